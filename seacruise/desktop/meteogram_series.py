"""What the weather along a passage is drawn from: samples, and what they are at any moment; without Qt."""

from __future__ import annotations

from bisect import bisect_left
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from seacruise.desktop.daylight import Light, light_along, spans

if TYPE_CHECKING:
    from seacruise.along import Weather
    from seacruise.passage import Passage
    from seacruise.weather.wind import Wind

Array = NDArray[np.float64]

PORT, STARBOARD, ENGINE = 0, 1, 2
"""Classes of `Series.tack`."""


@dataclass(frozen=True, slots=True, eq=False)
class Moment:
    """Everything at one moment under way; ``None`` where it is not known."""

    time: datetime
    tws_kn: float
    twd_deg: float
    gust_kn: float | None
    twa_deg: float
    tack: Literal["port", "starboard", "engine"]
    boat_speed_kn: float
    wave_m: float | None
    current_kn: float | None
    current_to_deg: float | None
    beyond_forecast: bool


@dataclass(frozen=True, slots=True, eq=False)
class Series:
    """Samples along a passage, shapes ``(n,)``; see `passage.Track` and `along.Weather`.

    Attributes
    ----------
    horizon
        End of the forecast [s since 1970].
    tack
        `PORT`, `STARBOARD` or `ENGINE`.
    lights
        Day, twilight and night with the times they begin and end [s since 1970].
    """

    time: Array
    tws_kn: Array
    twd_deg: Array
    twa_deg: Array
    boat_speed_kn: Array
    tack: NDArray[np.int64]
    weather: Weather
    horizon: float
    lights: tuple[tuple[Light, float, float], ...]

    @property
    def begin(self) -> float:
        """Departure [s since 1970]."""
        return float(self.time[0])

    @property
    def end(self) -> float:
        """Arrival [s since 1970]."""
        return float(self.time[-1])

    def tacks(self) -> list[tuple[int, int, int]]:
        """Find runs on one tack, or under engine: which, first and last sample."""
        return spans(self.tack)

    def sample(self, time: float) -> int:
        """Sample nearest to a time [s since 1970]."""
        at = min(bisect_left(self.time, time), self.time.size - 1)
        return at - 1 if at and time - self.time[at - 1] < self.time[at] - time else at

    def at(self, moment: datetime) -> Moment:
        """Tell everything at a moment, by the nearest sample."""
        k, weather = self.sample(moment.timestamp()), self.weather
        tacks: tuple[Literal["port"], Literal["starboard"], Literal["engine"]] = (
            "port",
            "starboard",
            "engine",
        )

        def of(values: Array | None) -> float | None:
            return None if values is None else float(values[k])

        return Moment(
            time=datetime.fromtimestamp(float(self.time[k]), UTC),
            tws_kn=float(self.tws_kn[k]),
            twd_deg=float(self.twd_deg[k]),
            gust_kn=of(weather.gust_kn),
            twa_deg=float(self.twa_deg[k]),
            tack=tacks[int(self.tack[k])],
            boat_speed_kn=float(self.boat_speed_kn[k]),
            wave_m=of(weather.wave_m),
            current_kn=of(weather.current_kn),
            current_to_deg=of(weather.current_to_deg),
            beyond_forecast=moment.timestamp() > self.horizon,
        )


def series_of(passage: Passage, wind: Wind | None) -> Series:
    """Collect what is drawn of a passage in a wind; about a millisecond."""
    from seacruise.along import weather_along

    track = passage.track
    starboard = (track.twd_deg - track.course_deg) % 360.0 < 180.0
    tack = np.where(track.motor, ENGINE, np.where(starboard, STARBOARD, PORT))
    lights = tuple(
        (Light(light), float(track.time[a]), float(track.time[b]))
        for light, a, b in spans(light_along(track))
    )
    return Series(
        time=track.time,
        tws_kn=track.tws_kn,
        twd_deg=track.twd_deg,
        twa_deg=track.twa_deg,
        boat_speed_kn=track.boat_speed_kn,
        tack=tack,
        weather=weather_along(track, wind),
        horizon=passage.forecast.valid_to.timestamp(),
        lights=lights,
    )
