"""Sail waypoints that somebody else chose: in another wind, or from another moment on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import great_circle_m, to_mercator
from seacruise.model import Passage, PassageRequest, Track
from seacruise.passage import how_of
from seacruise.units import METRES_PER_NM, MS_PER_KNOT

if TYPE_CHECKING:
    from seacruise.routing.resail import Resailed
    from seacruise.sea import Sea
    from seacruise.weather.wind import Wind

Position = tuple[float, float]

UNDER_WAY: Final = "Under way"
"""Name of the place from which a passage is planned anew."""

ARRIVED_NM: Final = 0.2
"""Nearer to the end than this there is nothing left to plan [nm]."""

UPWIND_DEG: Final = 60.0
"""Sailed closer to the true wind than this she beats, or nearly so: slow, wet and tiring [degrees]."""

SAME_M: Final = 1.0
"""Waypoints nearer to each other than this are one [m of the Mercator plane]."""


def distinct(waypoints: Sequence[Position]) -> list[Position]:
    """Leave out each waypoint that lies at the one before it: there is no course between the two."""
    x, y = to_mercator(*np.array(waypoints, dtype=np.float64).T)
    apart = np.append(True, np.hypot(np.diff(x), np.diff(y)) > SAME_M)
    return [place for place, kept in zip(waypoints, apart.tolist(), strict=True) if kept]


def waypoints_of(passage: Passage) -> list[Position]:
    """Positions of a passage's waypoints, `distinct`."""
    return distinct([(w.lat, w.lon) for w in passage.waypoints])


def apart_nm(a: Position, b: Position) -> float:
    """Distance of two positions [nm]."""
    return float(great_circle_m(*a, *b)) / METRES_PER_NM


def format_utc(time: datetime) -> str:
    """Write a time for a sentence: ``2016-11-20 06:00 UTC``."""
    return f"{time.astimezone(UTC):%Y-%m-%d %H:%M} UTC"


def sail_along(
    request: PassageRequest,
    waypoints: Sequence[Position],
    *,
    departure: float,
    sea: Sea,
) -> Resailed:
    """Sail along waypoints in the wind of a request, step by step as every finished passage is sailed again.

    Where the wind heads her, or comes from dead astern, she makes good the convex hull of her polar: whoever
    follows waypoints tacks when they must. Without tacking she stops there, and ``arrived`` is ``False``.

    Parameters
    ----------
    request
        Its wind, yacht, options and zones count.
    waypoints
        At least two positions ``lat, lon`` [degrees], the first one where she is; see `distinct`.
    departure
        Seconds since 1970 at the first waypoint.
    """
    from seacruise.routing.find import Question
    from seacruise.routing.manoeuvres import Course
    from seacruise.routing.resail import resail
    from seacruise.weather.beyond import extend

    lat, lon = np.array(waypoints, dtype=np.float64).T
    x, y = to_mercator(lat, lon)
    asked = Question(
        sea,
        extend(request.wind, request.options.beyond),
        request.yacht,
        replace(how_of(request.options), refine=False),
        waypoints[0],
        waypoints[-1],
        departure,
        request.zones,
        request.stream,
    )
    course = Course(x, y, np.ones(x.size - 1, dtype=bool))
    return resail(asked, course, fuel_rate_l_h=request.options.fuel_rate_l_h)


@dataclass(frozen=True, slots=True, eq=False)
class Weather:
    """What a forecast has besides the wind, along a track; ``(n,)`` each, ``None`` where it has none.

    Attributes
    ----------
    gust_kn
        Gusts [kn].
    wave_m
        Significant height of the waves [m].
    current_kn, current_to_deg
        Current [kn] and where it sets to [degrees true].
    """

    gust_kn: NDArray[np.float64] | None = None
    wave_m: NDArray[np.float64] | None = None
    current_kn: NDArray[np.float64] | None = None
    current_to_deg: NDArray[np.float64] | None = None


def weather_along(track: Track, wind: Wind | None) -> Weather:
    """Gusts, waves and current at each sample of a track, as far as a wind has them."""
    if wind is None:
        return Weather()

    def look(grid: NDArray[np.float32] | None) -> NDArray[np.float64] | None:
        return None if grid is None else wind.interpolate(grid, track.time, track.lat, track.lon)

    gust, wave = look(wind.gust), look(wind.wave)
    gust_kn = None if gust is None else gust / MS_PER_KNOT
    if wind.current is None:
        return Weather(gust_kn, wave)
    u, v = wind.current.at(track.time, track.lat, track.lon)
    return Weather(gust_kn, wave, np.hypot(u, v) / MS_PER_KNOT, np.degrees(np.arctan2(u, v)) % 360.0)


def upwind_share(track: Track) -> float:
    """Give the part of the time that she sails closer to the true wind than `UPWIND_DEG`, 0 to 1."""
    steps = np.diff(track.time)
    upwind = (track.twa_deg[:-1] < UPWIND_DEG) & ~track.motor[:-1]
    return float(steps[upwind].sum() / steps.sum())
