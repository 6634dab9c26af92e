"""What Open-Meteo sends, checked once at the edge and brought to our own names and units."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Final

import msgspec
import numpy as np
from numpy.typing import NDArray

from seacruise.errors import WeatherError
from seacruise.units import MS_PER_KNOT
from seacruise.weather.series import Series, require_hours, unique_hours
from seacruise.weather.wind import MAX_SPEED, from_direction

SERVICE: Final = "Open-Meteo"

MAX_ECHO_DEG: Final = 1.0
"""How far the cell of an answer may lie from the place asked [degrees]: a few cells of the coarsest model."""

MAX_CURRENT: Final = 15.0
"""No sea runs faster [m/s]; Saltstraumen has 11."""

MAX_WAVE: Final = 40.0
"""No significant height is greater [m]; the record is 19 (WMO, North Atlantic, 2013)."""

MAX_GAP_H: Final = 6.0
"""A longer hole between two hours is not bridged; the forecast ends before it [h]."""

Array = NDArray[np.float64]

_TO_MS: Final = {"m/s": 1.0, "km/h": 1 / 3.6, "kn": MS_PER_KNOT, "mp/h": 0.44704, "mph": 0.44704}
_TO_M: Final = {"m": 1.0, "metre": 1.0, "ft": 0.3048}
_DEGREES: Final = {"°": 1.0, "deg": 1.0}
_MEMBER: Final = re.compile(r"wind_speed_10m(?:_member(\d{1,3}))?")


class _Location(msgspec.Struct):
    latitude: float
    longitude: float
    hourly_units: dict[str, str]
    hourly: dict[str, msgspec.Raw]
    utc_offset_seconds: float = 0.0


class _Refusal(msgspec.Struct):
    reason: str


_DECODER: Final = msgspec.json.Decoder(list[_Location] | _Location)
_VALUES: Final = msgspec.json.Decoder(list[float | None])
_TIMES: Final = msgspec.json.Decoder(list[int | str])
_REFUSAL: Final = msgspec.json.Decoder(_Refusal)


@dataclass(frozen=True, slots=True)
class Asked:
    """What a request was about, to hold its answer against.

    Attributes
    ----------
    places
        Latitude and longitude [degrees] in the order of the answer.
    now
        Seconds since 1970: an answer that ends before it is for other days.
    """

    places: tuple[tuple[float, float], ...]
    now: float


def refusal_text(body: bytes) -> str:
    """Read the reason out of an error's body, without signs that could disturb a terminal; or empty."""
    try:
        reason = _REFUSAL.decode(body).reason
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError):
        return ""
    return re.sub(r"[^ -~°]+", " ", reason)[:160].strip().rstrip(".")


def decode_locations(body: bytes, asked: Asked) -> list[_Location]:
    """Decode a body: an object for one place, an array for several, in the order asked.

    Raises
    ------
    msgspec.DecodeError
        When it is not JSON - the service ends an answer that fails under way with a sentence of plain
        text - or not of the service's shape (`msgspec.ValidationError`).
    WeatherError
        ``bad-response`` when it is a refusal, or for other places than those asked.
    """
    try:
        decoded = _DECODER.decode(body)
    except msgspec.ValidationError:
        if reason := refusal_text(body):
            raise WeatherError(
                f"{SERVICE} sent a refusal in place of a forecast ({reason}); try again later."
            ) from None
        raise
    locations = decoded if isinstance(decoded, list) else [decoded]
    if len(locations) != len(asked.places):
        raise WeatherError(
            f"{SERVICE} answered for {len(locations)} places where {len(asked.places)} were asked; try again "
            "later."
        )
    for location, (lat, lon) in zip(locations, asked.places, strict=True):
        away = abs((location.longitude - lon + 180.0) % 360.0 - 180.0)
        if max(abs(location.latitude - lat), away) > MAX_ECHO_DEG:
            raise WeatherError(f"{SERVICE} answered for another place than the one asked; try again later.")
    return locations


def to_wind(body: bytes, asked: Asked) -> list[Series]:
    """Make the wind of a body: ``u``, ``v`` and ``gust`` for each place."""

    def one(table: _Table) -> dict[str, Array]:
        u, v = table.wind("wind_speed_10m", "wind_direction_10m")
        return {"u": u, "v": v, "gust": table.column("wind_gusts_10m", _TO_MS, most=2 * MAX_SPEED)}

    series = _to_series(body, asked, one)
    require_hours(SERVICE, series, ("u", "v"), max_gap_h=MAX_GAP_H)
    return series


def to_marine(body: bytes, asked: Asked) -> list[Series]:
    """Make waves and current of a body: ``wave``, ``current_u`` and ``current_v`` for each place.

    The direction of a current is where the water goes to, unlike the wind's.
    """

    def one(table: _Table) -> dict[str, Array]:
        speed = table.column("ocean_current_velocity", _TO_MS, most=MAX_CURRENT)
        u, v = from_direction(speed, table.direction("ocean_current_direction"))
        return {
            "wave": table.column("wave_height", _TO_M, most=MAX_WAVE),
            "current_u": -u,
            "current_v": -v,
        }

    series = _to_series(body, asked, one)
    if not any(np.isfinite(values).any() for place in series for values in place.values.values()):
        raise WeatherError(f"{SERVICE} sent neither waves nor current for this area.")
    return series


def to_members(body: bytes, asked: Asked) -> list[Series]:
    """Make an ensemble's wind of a body: ``u00``, ``v00`` (the control run), ``u01`` ... for each place."""

    def one(table: _Table) -> dict[str, Array]:
        values: dict[str, Array] = {}
        for name in table.location.hourly:
            if (match := _MEMBER.fullmatch(name)) is None:
                continue
            number = int(match.group(1) or 0)
            u, v = table.wind(name, name.replace("wind_speed", "wind_direction"))
            values[f"u{number:02d}"], values[f"v{number:02d}"] = u, v
        return values

    series = _to_series(body, asked, one)
    require_hours(SERVICE, series, ("u00", "v00"), max_gap_h=MAX_GAP_H)
    return series


def _to_series(body: bytes, asked: Asked, make: _Maker) -> list[Series]:
    series = []
    for location, (lat, lon) in zip(decode_locations(body, asked), asked.places, strict=True):
        table = _Table(location)
        if not table.time.size or table.time.max() < asked.now:
            raise WeatherError(
                f"{SERVICE} answered for other days than those asked; check this computer's date."
            )
        time, values = unique_hours(table.time, make(table))
        series.append(Series(lat, lon, time, values))
    return series


class _Table:
    """The hours of one place: columns by the service's names, in our units."""

    def __init__(self, location: _Location) -> None:
        self.location = location
        self.time = self._times()

    def _times(self) -> Array:
        if "time" not in self.location.hourly:
            raise _other_shape("there are no times")
        seconds = []
        for time in _TIMES.decode(self.location.hourly["time"]):
            if isinstance(time, int):
                seconds.append(float(time))
                continue
            try:
                moment = datetime.fromisoformat(time)
            except ValueError:
                raise _other_shape("its times are not times") from None
            # times without a zone are local ones, by the offset that stands beside them
            aware = moment if moment.tzinfo else moment.replace(tzinfo=UTC)
            seconds.append(aware.timestamp() - (0 if moment.tzinfo else self.location.utc_offset_seconds))
        times = np.array(seconds, dtype=np.float64)
        if times.size and (times.min() < 0.0 or times.max() > 1e10):
            raise _other_shape("its times are not times")
        return times

    def column(self, name: str, units: dict[str, float], *, most: float, least: float = 0.0) -> Array:
        """Read a column; what is not there or not possible is missing, as files of models mark it."""
        if name not in self.location.hourly:
            return np.full(self.time.size, np.nan)
        values = self._raw(name, units)
        with np.errstate(invalid="ignore"):
            return np.where((values >= least) & (values <= most), values, np.nan)

    def direction(self, name: str) -> Array:
        """Read directions [degrees]; 360 and a turn too many are as good as 0, 9999 is none."""
        return self.column(name, _DEGREES, least=-360.0, most=720.0)

    def wind(self, speed_name: str, direction_name: str) -> tuple[Array, Array]:
        """Read a wind: ``u, v`` [m/s], NaN where either part is missing.

        Raises
        ------
        WeatherError
            ``bad-response`` for a speed that cannot be.
        """
        speed = self._raw(speed_name, _TO_MS)
        wrong = np.nonzero((speed < 0.0) | (speed > MAX_SPEED))[0]
        if wrong.size:
            raise WeatherError(
                f"{SERVICE} sent a wind of {speed[wrong[0]]:g} m/s, which cannot be; try again later."
            )
        return from_direction(speed, self.direction(direction_name))

    def _raw(self, name: str, units: dict[str, float]) -> Array:
        if name not in self.location.hourly:
            raise _other_shape(f"there is no {name}")
        unit = self.location.hourly_units.get(name, "")
        raw = self.location.hourly[name]
        values = np.array(_VALUES.decode(raw), dtype=np.float64)
        if values.size != self.time.size:
            raise _other_shape(f"{name} has {values.size} values for {self.time.size} times")
        if unit not in units:
            # the service names no unit for a column without values
            if unit in ("", "undefined") and np.isnan(values).all():
                return values
            known = re.sub(r"[^ -~°]+", "?", unit)[:20]
            raise _other_shape(f"{name} is in {known!r}")
        return values * units[unit]


_Maker = Callable[[_Table], dict[str, Array]]


def _other_shape(what: str) -> WeatherError:
    return WeatherError(f"{SERVICE} sent an answer of another shape than expected ({what}).")


def places_text(places: Sequence[tuple[float, float]]) -> dict[str, str]:
    """Write places as the two lists that a request carries."""
    return {
        "latitude": ",".join(f"{lat:.3f}" for lat, _ in places),
        # a grid across the date line counts on beyond 180
        "longitude": ",".join(f"{(lon + 180.0) % 360.0 - 180.0:.3f}" for _, lon in places),
    }
