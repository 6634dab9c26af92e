"""Wind at 10 m from GRIB 1 and 2, as sailors get it by e-mail, from XyGrib or from a weather service."""

from __future__ import annotations

import atexit
import os
import sys
from collections.abc import Iterator
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from functools import cache
from pathlib import Path
from typing import IO, Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError, WeatherError
from seacruise.weather.grids import Array, Grid, RawWind, ascending, onto

Component = Literal["u", "v"]

_U_NAMES: Final = {"10u", "u", "ugrd", "10u_instant"}
_V_NAMES: Final = {"10v", "v", "vgrd", "10v_instant"}
_GRIB1_U, _GRIB1_V, _GRIB1_CURRENTS = 33, 34, (47, 48, 49, 50)
_GRIB1_HEIGHT, _GRIB1_SURFACE = 105, 1
_TIME_UNITS: Final = frozenset({0, 1, 2, 10, 11, 12, 13, 14, 254})
"""Minutes to days and seconds, in the codes of either edition."""

_ROUNDING_DEG: Final = 0.0005
"""GRIB 1 rounds degrees to three digits."""


@dataclass(frozen=True, slots=True)
class _Message:
    """One component of the wind at one time."""

    component: Component
    grid: tuple[Any, ...]
    run: float
    valid: float
    member: int
    lat: Array
    lon: Array
    grid_relative: bool
    values: NDArray[np.float32]


def read_grib(data: bytes, *, source: str) -> RawWind:
    """Read the wind at 10 m from the bytes of a GRIB file.

    Of several runs the latest is taken for each hour, of an ensemble the control. Where a file mixes
    grids, the finest is kept and coarser ones extend it in time.

    Raises
    ------
    WeatherError
        ``bad-response``, with an unfinished sentence, when there is no wind that can be used.
    InputError
        When the library that decodes GRIB is not installed.
    """
    messages: list[_Message] = []
    notes: list[str] = []
    seen = currents = 0
    for block, whole in _split(data):
        if not whole:
            notes.append(f"The file is cut off after {seen} messages.")
            break
        seen += 1
        decoded, is_current = _decode(block)
        currents += is_current
        if decoded is not None:
            messages.append(decoded)
    if not seen:
        raise WeatherError("it is not a GRIB file, or nothing of it arrived")
    if not messages:
        if currents:
            raise WeatherError("it holds sea currents and no wind; give it as the current instead")
        raise WeatherError(f"none of its {seen} messages is wind at 10 m")
    return _join(messages, source, notes)


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


def _decode(block: bytes) -> tuple[_Message | None, bool]:
    """Decode a message when it is wind at 10 m; the flag tells whether it is a sea current."""
    eccodes = _eccodes()
    if not _is_sound(block):
        raise WeatherError("one of its messages is damaged")
    try:
        handle = eccodes.codes_new_from_message(block)
    except eccodes.CodesInternalError:
        raise WeatherError("one of its messages is damaged") from None
    try:
        component = _component(eccodes, handle)
        if component == "current":
            return None, True
        return (None if component is None else _message(eccodes, handle, component)), False
    except (eccodes.CodesInternalError, ValueError, OverflowError, TypeError) as error:
        # dates and sizes that are none, besides the library's own complaints
        raise WeatherError(f"one of its messages cannot be decoded ({error})") from None
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


def _component(eccodes: Any, handle: Any) -> Component | Literal["current"] | None:
    name = str(eccodes.codes_get(handle, "shortName"))
    level = int(eccodes.codes_get(handle, "level"))
    kind = str(eccodes.codes_get(handle, "typeOfLevel"))
    # some senders (uGrib) label 10 m wind as surface wind
    low = (kind == "heightAboveGround" and level == 10) or kind == "surface"
    if name in ("ucurr", "vcurr", "uogrd", "vogrd", "ocu", "ocv", "uoe", "von"):
        return "current"
    if low and name in _U_NAMES:
        return "u"
    if low and name in _V_NAMES:
        return "v"
    if name == "unknown" and int(eccodes.codes_get(handle, "edition")) == 1:
        # senders that give a centre of their own leave the library without names
        number = int(eccodes.codes_get(handle, "indicatorOfParameter"))
        kind_number = eccodes.codes_get(handle, "indicatorOfTypeOfLevel", int)
        if number in _GRIB1_CURRENTS:
            return "current"
        if number in (_GRIB1_U, _GRIB1_V) and (kind_number, level) in (
            (_GRIB1_HEIGHT, 10),
            (_GRIB1_SURFACE, level),
        ):
            return "u" if number == _GRIB1_U else "v"
    return None


def _message(eccodes: Any, handle: Any, component: Component) -> _Message:
    get = eccodes.codes_get
    kind = str(get(handle, "gridType"))
    rows, columns = int(get(handle, "Nj")), int(get(handle, "Ni"))
    missing = float(get(handle, "missingValue"))
    if int(get(handle, "indicatorOfUnitOfTimeRange")) not in _TIME_UNITS:
        # the library divides by the length of a unit that it does not know
        raise WeatherError("one of its messages is damaged (its unit of time)")
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
        grid = (
            kind,
            rows,
            columns,
            float(lat[0, 0]),
            float(lon[0, 0]),
            float(lat[-1, -1]),
            float(lon[-1, -1]),
        )
    return _Message(
        component=component,
        grid=grid,
        run=_moment(get(handle, "dataDate"), get(handle, "dataTime")),
        valid=_moment(get(handle, "validityDate"), get(handle, "validityTime")),
        member=int(get(handle, "perturbationNumber"))
        if eccodes.codes_is_defined(handle, "perturbationNumber")
        else 0,
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


def _join(messages: list[_Message], source: str, notes: list[str]) -> RawWind:
    members = sorted({message.member for message in messages})
    if len(members) > 1:
        notes.append(f"Of {len(members)} members, member {members[0]} is used.")
        messages = [message for message in messages if message.member == members[0]]
    runs = sorted({message.run for message in messages})
    if len(runs) > 1:
        notes.append(f"Of {len(runs)} model runs, the latest is used for each hour.")
    grids: dict[tuple[Any, ...], list[_Message]] = {}
    for message in messages:
        grids.setdefault(message.grid, []).append(message)
    parts = [part for group in grids.values() if (part := _stack(group, source)) is not None]
    if not parts:
        raise WeatherError("it holds only one of the two components of the wind")
    return replace(
        _combine(parts, notes),
        issued=datetime.fromtimestamp(runs[-1], UTC),
        notes=tuple(dict.fromkeys(notes)),
    )


def _stack(group: list[_Message], source: str) -> RawWind | None:
    """Put the messages of one grid in order of time; ``None`` without a time that has both components."""
    found: dict[float, dict[Component, _Message]] = {}
    for message in sorted(group, key=lambda one: one.run):
        found.setdefault(message.valid, {})[message.component] = message
    both = [(valid, pair["u"], pair["v"]) for valid, pair in sorted(found.items()) if len(pair) == 2]
    if not both:
        return None
    first = both[0][1]
    return RawWind(
        time=np.array([valid for valid, _, _ in both]),
        lat=first.lat,
        lon=first.lon,
        u=np.stack([u.values for _, u, _ in both]),
        v=np.stack([v.values for _, _, v in both]),
        source=source,
        issued=None,
        grid_relative=first.grid_relative,
    )


def _combine(parts: list[RawWind], notes: list[str]) -> RawWind:
    """Keep the finest grid and extend it in time by the coarser ones that cover it."""
    if len(parts) == 1:
        return parts[0]
    if any(part.lat.ndim == 2 for part in parts):
        notes.append(f"The file mixes {len(parts)} grids; the one with the most hours is used.")
        return max(parts, key=lambda part: part.time.size)
    parts = sorted((ascending(part) for part in parts), key=lambda part: (_step(part), -part.time.size))
    base = parts[0]
    for other in parts[1:]:
        new = ~np.isin(other.time, base.time)
        fitted = onto(
            replace(other, time=other.time[new], u=other.u[new], v=other.v[new]), base.lat, base.lon
        )
        if not new.any() or np.isnan(fitted.u).mean() > np.isnan(other.u).mean() + 0.05:
            notes.append(f"A second grid of {_step(other):.2f} degrees in the file is not used.")
            continue
        notes.append(f"{int(new.sum())} of the hours are from a coarser grid of {_step(other):.2f} degrees.")
        base = _merged(base, fitted)
    return base


def _merged(base: RawWind, other: RawWind) -> RawWind:
    time = np.concatenate([base.time, other.time])
    order = np.argsort(time)

    def joined(first: Grid, second: Grid) -> Grid:
        return np.concatenate([first, second])[order]

    return replace(base, time=time[order], u=joined(base.u, other.u), v=joined(base.v, other.v))


def _step(raw: RawWind) -> float:
    return float(abs(raw.lat[-1] - raw.lat[0])) / max(raw.lat.size - 1, 1)
