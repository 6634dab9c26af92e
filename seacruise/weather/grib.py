"""Wind, gusts, waves and current from GRIB 1 and 2, as sailors get it by e-mail or from a weather service."""

from __future__ import annotations

import atexit
import os
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import cache
from pathlib import Path
from typing import IO, Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError, WeatherError
from seacruise.weather.grids import Array, RawFile
from seacruise.weather.messages import CURRENT, GUST, WAVE, WIND, Message, Role, join

_NAMES: Final[dict[str, Role]] = {
    "10u": "u", "u": "u", "ugrd": "u", "10u_instant": "u",
    "10v": "v", "v": "v", "vgrd": "v", "10v_instant": "v",
    "gust": "gust", "10fg": "gust", "i10fg": "gust", "10fg3": "gust", "10fg6": "gust", "max_i10fg": "gust",
    "swh": "wave",
    "ocu": "cu", "uoe": "cu", "ucurr": "cu", "uogrd": "cu",
    "ocv": "cv", "von": "cv", "vcurr": "cv", "vogrd": "cv",
}  # fmt: skip
_GRIB1_NUMBERS: Final[dict[int, Role]] = {
    33: "u", 34: "v", 49: "cu", 50: "cv", 100: "wave", 180: "gust",
}  # fmt: skip
"""Numbers of WMO's and NCEP's table 2, for senders whose centre the library does not know."""

_GRIB2_NUMBERS: Final[dict[tuple[int, int, int], Role]] = {
    (10, 1, 2): "cu", (10, 1, 3): "cv", (10, 0, 3): "wave", (0, 2, 22): "gust",
}  # fmt: skip
"""Discipline, category and number, where the library's own names depend on the centre."""

_CURRENT_SPEEDS: Final = (47, 48)
"""Direction and speed of the current in GRIB 1: they tell that a file is about the sea, no more."""

_AS_A_WHOLE: Final = frozenset({None, 0, 1, 6})
"""Derived forecasts (code table 4.7) that are a wind: means. The others are spreads, quantiles, extremes."""

_NOT_A_VALUE: Final = frozenset({5, 6, 9, 10})
"""Templates of product definition for probabilities and percentiles."""

_TIME_UNITS: Final = frozenset({0, 1, 2, 10, 11, 12, 13, 14, 254})
"""Minutes to days and seconds, in the codes of either edition."""

_MOST_POINTS: Final = 50_000_000
"""More than any model's grid has."""

_ROUNDING_DEG: Final = 0.0005
"""GRIB 1 rounds degrees to three digits."""


@dataclass(slots=True)
class _Reading:
    """What has been met so far on the way through a file."""

    messages: list[Message]
    notes: list[str]
    seen: int = 0
    is_sea: bool = False
    damage: str = ""


def read_grib(data: bytes, *, source: str) -> RawFile:
    """Read wind, gusts, waves and current from the bytes of a GRIB file, as far as they are there.

    Of several runs the latest is taken for each hour. Where a file mixes grids, the finest is kept and
    coarser ones extend it in time.

    Raises
    ------
    WeatherError
        ``bad-response``, with an unfinished sentence, when it is no GRIB file, or damaged.
    InputError
        When the library that decodes GRIB is not installed.
    """
    reading = _Reading([], [])
    for block, whole in _split(data):
        if not whole:
            reading.notes.append(f"The file is cut off after {reading.seen} messages.")
            break
        reading.seen += 1
        _decode(block, reading)
    if not reading.seen:
        raise WeatherError("it is not a GRIB file, or nothing of it arrived")
    return _made(reading, source)


def _made(reading: _Reading, source: str) -> RawFile:
    messages, notes = reading.messages, reading.notes
    if reading.damage:
        notes.append(f"Some of what is in the file besides the wind is not used: {reading.damage}.")
    wind = join(messages, WIND, notes)
    current = join(messages, CURRENT, notes)
    troubles = {"current": f"none of its {reading.seen} messages is a sea current"}
    if wind is None:
        half = any(message.role in WIND for message in messages)
        sea = reading.is_sea or any(message.role in CURRENT for message in messages)
        if half:
            troubles["wind"] = "it holds only one of the two components of the wind"
        elif sea:
            troubles["wind"] = "it holds sea currents and no wind; give it as the current instead"
        else:
            troubles["wind"] = f"none of its {reading.seen} messages is wind at 10 m"
    runs = [message.run for message in messages if message.role in WIND] or [m.run for m in messages]
    return RawFile(
        source,
        issued=datetime.fromtimestamp(max(runs), UTC) if runs else None,
        wind=wind,
        gust=join(messages, GUST, []),
        wave=join(messages, WAVE, []),
        current=current,
        troubles=troubles,
        notes=tuple(dict.fromkeys(notes)),
    )


def _split(data: bytes) -> Iterator[tuple[bytes, bool]]:
    """Cut a file into messages, passing over what lies between; the flag tells whether one is whole."""
    # cut here and not by the library: it wants a C FILE, which Python on Windows cannot always give
    position = data.find(b"GRIB")
    while position >= 0 and position + 16 <= len(data):
        edition = data[position + 7]
        size = int.from_bytes(
            data[position + 8 : position + 16] if edition == 2 else data[position + 4 : position + 7]
        )
        end = position + size
        whole = edition in (1, 2) and size >= 16 and data[end - 4 : end] == b"7777"
        if whole:
            yield data[position:end], True
        elif edition in (1, 2) and end > len(data):
            yield data[position:], False
            return
        position = data.find(b"GRIB", end if whole else position + 4)


def _is_sound(block: bytes) -> bool:
    """Tell whether the sections of a message fill it exactly: the library crashes on some that do not."""
    if block[7] == 1:
        # section 1 says which of the sections 2 and 3 are there; section 4 always is
        flags, position, count = block[15], 8, 2 + bool(block[15] & 0x80) + bool(block[15] & 0x40)
        for _ in range(count):
            position += int.from_bytes(block[position : position + 3])
        return flags & 0x3F == 0 and block[8:11] >= b"\x00\x00\x1c" and position == len(block) - 4
    position = 16
    while position < len(block) - 4:
        size = int.from_bytes(block[position : position + 4])
        if size < 5 or not 1 <= block[position + 4] <= 7:
            return False
        position += size
    return position == len(block) - 4


def _decode(block: bytes, reading: _Reading) -> None:
    """Decode a message when it is one of those wanted."""
    eccodes = _eccodes()
    if not _is_sound(block):
        raise WeatherError("one of its messages is damaged")
    try:
        handle = eccodes.codes_new_from_message(block)
    except eccodes.CodesInternalError:
        raise WeatherError("one of its messages is damaged") from None
    role: Role | Literal["sea"] | None = None
    try:
        role = _role(eccodes, handle)
        if role == "sea":
            reading.is_sea = True
        elif role is not None:
            reading.messages.append(_message(eccodes, handle, role))
    except (eccodes.CodesInternalError, ValueError, OverflowError, TypeError, WeatherError) as error:
        # dates and sizes that are none, besides the library's own complaints
        if role in (None, *WIND):
            sentence = f"one of its messages cannot be decoded ({error})"
            raise WeatherError(str(error) if isinstance(error, WeatherError) else sentence) from None
        reading.damage = str(error)
    finally:
        eccodes.codes_release(handle)


def _eccodes() -> Any:
    try:
        import eccodes
    except (ImportError, RuntimeError, OSError) as error:
        raise InputError(
            "GRIB files need the package eccodes, which is not installed or cannot find its library: "
            f"install it with 'pip install eccodes', or use a NetCDF file ({type(error).__name__})."
        ) from None
    _silence()
    return eccodes


@cache
def _silence() -> IO[bytes] | None:
    """Keep the library from writing to standard error; what it says there comes as an exception, too.

    Returns the file it writes to instead, which must stay open as long as the library is in use.
    """
    import eccodes

    if sys.platform == "win32":
        # a FILE of one C runtime is poison to another
        return None
    nowhere = Path(os.devnull).open("wb")  # noqa: SIM115 (stays open)
    atexit.register(nowhere.close)
    eccodes.codes_context_set_logging(nowhere)
    return nowhere


def _role(eccodes: Any, handle: Any) -> Role | Literal["sea"] | None:
    """Tell what a message is to us; ``"sea"`` is about currents and no use."""
    role = _named(eccodes, handle)
    if role not in ("u", "v"):
        return role
    level = int(eccodes.codes_get(handle, "level"))
    kind = str(eccodes.codes_get(handle, "typeOfLevel"))
    # some senders (uGrib) label 10 m wind as surface wind
    is_low = (kind == "heightAboveGround" and level == 10) or kind == "surface"
    if not is_low and kind == "unknown" and int(eccodes.codes_get(handle, "edition")) == 1:
        # 105: metres above ground, 1: surface
        number = eccodes.codes_get(handle, "indicatorOfTypeOfLevel", int)
        is_low = (number, level) == (105, 10) or number == 1
    return role if is_low else None


def _named(eccodes: Any, handle: Any) -> Role | Literal["sea"] | None:
    name = str(eccodes.codes_get(handle, "shortName"))
    if int(eccodes.codes_get(handle, "edition")) == 1:
        if name != "unknown":
            return _NAMES.get(name)
        # senders that give a centre of their own leave the library without names
        number = int(eccodes.codes_get(handle, "indicatorOfParameter"))
        return "sea" if number in _CURRENT_SPEEDS else _GRIB1_NUMBERS.get(number)
    if _get(eccodes, handle, "derivedForecast") not in _AS_A_WHOLE:
        return None
    if _get(eccodes, handle, "productDefinitionTemplateNumber") in _NOT_A_VALUE:
        return None
    numbers = ("discipline", "parameterCategory", "parameterNumber")
    known = _NAMES.get(name)
    return known or _GRIB2_NUMBERS.get(tuple(int(eccodes.codes_get(handle, key)) for key in numbers))  # type: ignore[arg-type]


def _get(eccodes: Any, handle: Any, key: str) -> int | None:
    """Value of a key that not every message has."""
    return int(eccodes.codes_get(handle, key)) if eccodes.codes_is_defined(handle, key) else None


def _message(eccodes: Any, handle: Any, role: Role) -> Message:
    get = eccodes.codes_get
    kind = str(get(handle, "gridType"))
    rows, columns = int(get(handle, "Nj")), int(get(handle, "Ni"))
    missing = float(get(handle, "missingValue"))
    if int(get(handle, "indicatorOfUnitOfTimeRange")) not in _TIME_UNITS:
        # the library divides by the length of a unit that it does not know
        raise WeatherError("one of its messages is damaged (its unit of time)")
    if rows * columns > _MOST_POINTS or int(get(handle, "numberOfValues")) > rows * columns:
        # the library would believe it, and ask for gigabytes
        raise WeatherError("one of its messages is damaged (its number of values)")
    values = np.asarray(eccodes.codes_get_values(handle))
    if values.size != rows * columns:
        raise WeatherError(f"a grid of the kind {kind} with {values.size} values cannot be read")
    values = np.where(values == missing, np.nan, values).astype(np.float32)
    if kind == "regular_ll":
        lat, lon, grid = _regular_axes(eccodes, handle)
    else:
        lat = _unscan(eccodes, handle, np.asarray(eccodes.codes_get_array(handle, "latitudes")))
        lon = _unscan(eccodes, handle, np.asarray(eccodes.codes_get_array(handle, "longitudes")))
        lon = np.unwrap(np.unwrap(lon, axis=1, period=360.0), axis=0, period=360.0)
        # eccodes counts longitudes from 0; the middle decides, so that the grid stays in one piece
        lon = lon - 360.0 * np.round(float(np.median(lon)) / 360.0)
        corners = (float(lat[0, 0]), float(lon[0, 0]), float(lat[-1, -1]), float(lon[-1, -1]))
        grid = (kind, rows, columns, *corners)
    if not (np.isfinite(lat).all() and np.isfinite(lon).all()):
        raise WeatherError("one of its messages is damaged (its grid)")
    return Message(
        role=role,
        grid=grid,
        run=_moment(get(handle, "dataDate"), get(handle, "dataTime")),
        valid=_moment(get(handle, "validityDate"), get(handle, "validityTime")),
        member=_get(eccodes, handle, "perturbationNumber"),
        level=abs(int(get(handle, "level"))),
        lat=lat,
        lon=lon,
        grid_relative=kind != "regular_ll" and bool(get(handle, "uvRelativeToGrid")),
        values=_unscan(eccodes, handle, values).astype(np.float32),
    )


def _moment(date: int, clock: int) -> float:
    day = datetime(date // 10000, date // 100 % 100, date % 100, tzinfo=UTC)
    return day.timestamp() + clock // 100 * 3600.0 + clock % 100 * 60.0


def _unscan(eccodes: Any, handle: Any, values: NDArray[Any]) -> NDArray[Any]:
    """Lay values out as ``(row, column)`` in the order of the axes."""
    kind = str(eccodes.codes_get(handle, "gridType"))
    rows, columns = int(eccodes.codes_get(handle, "Nj")), int(eccodes.codes_get(handle, "Ni"))
    if int(eccodes.codes_get(handle, "jPointsAreConsecutive")):
        return values.reshape(columns, rows).T
    grid = values.reshape(rows, columns).copy()
    if int(eccodes.codes_get(handle, "alternativeRowScanning")):
        grid[1::2] = grid[1::2, ::-1]
    if kind != "regular_ll" and int(eccodes.codes_get(handle, "iScansNegatively")):
        # the direction of the columns is what u is measured along
        grid = grid[:, ::-1]
    return grid


def _regular_axes(eccodes: Any, handle: Any) -> tuple[Array, Array, tuple[Any, ...]]:
    """Latitudes and longitudes in the order of the values, and what tells the grid from others."""

    def axis(name: str, letter: str, count: int, forwards: bool) -> Array:
        first = float(eccodes.codes_get(handle, f"{name}OfFirstGridPointInDegrees"))
        last = float(eccodes.codes_get(handle, f"{name}OfLastGridPointInDegrees"))
        if name == "longitude" and forwards and last < first:
            last += 360.0
        step = float(eccodes.codes_get(handle, f"{letter}DirectionIncrementInDegrees")) * (
            1.0 if forwards else -1.0
        )
        # files contradict themselves: uGrib writes last points that are not on the grid, zyGrib increments
        # that are nonsense; the ends count, unless they are off by more than rounded steps but less than one
        off = abs(first + (count - 1) * step - last)
        if count < 2 or _ROUNDING_DEG * (count + 1) < off <= abs(step):
            return first + step * np.arange(count, dtype=np.float64)
        return np.linspace(first, last, count)

    rows, columns = int(eccodes.codes_get(handle, "Nj")), int(eccodes.codes_get(handle, "Ni"))
    lat = axis("latitude", "j", rows, bool(eccodes.codes_get(handle, "jScansPositively")))
    lon = axis("longitude", "i", columns, not eccodes.codes_get(handle, "iScansNegatively"))
    ends = tuple(round(float(value), 3) for value in (lat[0], lat[-1], lon[0], lon[-1]))
    return lat, lon, ("regular_ll", rows, columns, *ends)
