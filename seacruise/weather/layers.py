"""From the layers of a file to one `Wind` and one `Current`: whole, cut to the passage, told what is odd."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, datetime
from typing import Final

import numpy as np

from seacruise.errors import WeatherError
from seacruise.geodesy import format_position
from seacruise.weather.gaps import Rounds, fill_gaps, grow
from seacruise.weather.grids import (
    Array,
    Box,
    Grid,
    Place,
    RawField,
    RawFile,
    cropped,
    onto,
    passage_box,
    regular,
)
from seacruise.weather.wind import MAX_SPEED, Current, Forecast, Wind, describe_grid, require_cover

MARGIN_DEG: Final = 3.0
"""What is kept of a file around the ends of a passage, at least: room for any detour [degrees]."""

FILL_DEG: Final = 0.75
"""How far from the ends of a passage the nearest given wind may be [degrees], or two steps of the grid."""

WAVE_REACH_DEG: Final = 1.0
"""How far inland the waves of the nearest sea are told [degrees]; beyond it there are none."""

HOLD_H: Final = 6.0
"""A layer may end so much before the wind [h], or one of its own steps, without a word about it."""

MAX_CURRENT: Final = 15.0
"""Faster water than in any strait [m/s]."""

_AROUND: Final = (
    "the area around the passage, as in files that leave out land and inland seas; choose another forecast"
)
_WORLD_DEG: Final = 360.0 - 1e-6


def to_wind(raw: RawFile, *, around: Sequence[Place] = ()) -> Wind:
    """Make the wind of a file, with what came besides: gusts, waves, members and current.

    Parameters
    ----------
    around
        Ends of a passage: they must be covered, and only what a passage between them may meet is kept
        and judged for missing values. Without any, all is kept.

    Raises
    ------
    WeatherError
        ``bad-response``, with an unfinished sentence, when there is no wind that can be used.
    NoPassageError
        ``outside-forecast`` when an end is not covered.
    """
    box = _box(around)
    field = _wind_field(raw, box, around)
    u, v = field.parts
    members = u.shape[0] if u.ndim == 4 else 1
    mean_u, mean_v = (part.mean(axis=0, dtype=np.float64) if members > 1 else part for part in (u, v))
    notes = list(raw.notes)
    gust = _besides(raw.gust, "gusts", field, box, notes)
    wave = _besides(raw.wave, "waves", field, box, notes)
    current = _current(raw, field, box, notes)
    if field.time.size == 1:
        notes.append("The file holds a single time; its wind is held from then on.")

    def member(number: int) -> Wind:
        named = _forecast(f"{raw.source}, member {number + 1}", raw.issued, field, ())
        return Wind(field.time, field.lat, field.lon, u[number], v[number], named)

    source = f"{raw.source}, mean of {members} members" if members > 1 else raw.source
    return Wind(
        time=field.time,
        lat=field.lat,
        lon=field.lon,
        u=mean_u,
        v=mean_v,
        forecast=_forecast(source, raw.issued, field, notes),
        # the mean wind of a squall line blows harder than the gusts told for it here and there
        gust=None if gust is None else np.maximum(gust, np.hypot(mean_u, mean_v)),
        wave=wave,
        spread=None if members == 1 else np.sqrt(u.var(axis=0) + v.var(axis=0)),
        current=current,
        members=tuple(member(number) for number in range(members)) if members > 1 else (),
    )


def _wind_field(raw: RawFile, box: Box | None, around: Sequence[Place]) -> RawField:
    """Bring the wind of a file to a regular grid, cut to a box and without holes."""
    if raw.wind is None:
        raise WeatherError(raw.troubles["wind"])
    if raw.wind.lat.ndim == 2:
        _require_reach(raw.source, raw.wind, around)
    whole = regular(raw.wind, box)
    require_cover(raw.source, (whole.lat, whole.lon), around)
    field = cropped(whole, box)
    parts, depth = fill_gaps(*field.parts, area=_AROUND if around else "its area")
    _require_values(field, depth, around)
    if max(float(np.abs(part).max()) for part in parts) > MAX_SPEED:
        raise WeatherError(f"its wind blows above {MAX_SPEED:.0f} m/s, which no wind does")
    return replace(field, parts=parts)


def to_current(raw: RawFile, *, around: Sequence[Place] = ()) -> Current:
    """Make the current of a file: zero over land, and fading to zero within a step beyond its edge.

    Raises
    ------
    WeatherError
        ``bad-response``, with an unfinished sentence, when there is no current that can be used.
    """
    if raw.current is None:
        raise WeatherError(raw.troubles["current"])
    return _make_current(raw.current, raw, _box(around))


def _box(around: Sequence[Place]) -> Box | None:
    if not around:
        return None
    span = max(abs(around[0][0] - around[-1][0]), abs(around[0][1] - around[-1][1]) / 2)
    return passage_box(around, max(MARGIN_DEG, span / 2))


def _forecast(source: str, issued: datetime | None, field: RawField, notes: Sequence[str]) -> Forecast:
    valid_from, valid_to, step_h, resolution = describe_grid(field.time, field.lat, field.lon)
    return Forecast(
        source=source,
        issued=issued,
        valid_from=valid_from,
        valid_to=valid_to,
        step_h=step_h,
        resolution_deg=resolution,
        notice=" ".join(dict.fromkeys(notes)),
    )


def _require_reach(source: str, raw: RawField, around: Sequence[Place]) -> None:
    """Check positions against the bounds of a curvilinear grid, before it is cut to their surroundings."""
    bounds = (np.array([raw.lat.min(), raw.lat.max()]), np.array([raw.lon.min(), raw.lon.max()]))
    require_cover(source, bounds, around)


def _require_values(field: RawField, depth: Rounds, around: Sequence[Place]) -> None:
    """Refuse a wind whose values near the ends of a passage are made up from far away.

    A file that leaves out land leaves out ports with it, but by a cell or two; one that leaves out an inland
    sea would have its wind made up from another one's.
    """
    step = field.step or FILL_DEG
    most = max(2, int(np.ceil(FILL_DEG / step)))
    worst = depth.reshape(-1, *depth.shape[-2:]).max(axis=0)
    for lat, lon in around:
        row, column = int(np.abs(field.lat - lat).argmin()), int(np.abs(field.lon - lon).argmin())
        if worst[row, column] > most:
            raise WeatherError(
                f"its wind is missing (masked) around {format_position(lat, lon)}, as in files that leave "
                "out land and inland seas; choose another forecast"
            )


def _besides(
    raw: RawField | None, what: str, wind: RawField, box: Box | None, notes: list[str]
) -> Grid | None:
    """Bring a speed or height onto the wind's grid and times; ``None`` when it is not there.

    Missing values are those of the nearest sea, or zero far from it; in time it is interpolated, and held
    before its first and after its last value.
    """
    if raw is None:
        return None
    try:
        field = cropped(regular(raw, box), box)
    except WeatherError:
        notes.append(f"The {what} of the file do not reach the area of the passage.")
        return None
    (values,) = field.parts
    if values.ndim == 4:
        values = values.mean(axis=0)
    reach = int(np.ceil(WAVE_REACH_DEG / (field.step or WAVE_REACH_DEG)))
    (values,), _ = grow(values, rounds=reach)
    fitted = onto(RawField(field.time, field.lat, field.lon, (values,)), wind.lat, wind.lon)
    if np.isnan(fitted.parts[0]).all():
        notes.append(f"The {what} of the file do not reach the area of the passage.")
        return None
    _tell_end(what, field.time, wind.time, notes)
    return np.maximum(np.nan_to_num(_at_times(fitted, wind.time), nan=0.0), 0.0)


def _at_times(field: RawField, times: Array) -> Grid:
    """Interpolate the one part of a field linearly to times, holding it before and after its own."""
    position = np.interp(times, field.time, np.arange(field.time.size, dtype=np.float64))
    before = position.astype(np.int64)
    after = np.minimum(before + 1, field.time.size - 1)
    share = (position - before).astype(np.float32)[:, None, None]
    (values,) = field.parts
    return np.asarray(values[before] * (1 - share) + values[after] * share, dtype=np.float32)


def _tell_end(what: str, times: Array, wind: Array, notes: list[str]) -> None:
    """Say where a layer that is shorter than the wind ends; a single time is meant to be held."""
    allowed_s = max(HOLD_H * 3600.0, float(np.diff(times).max()) if times.size > 1 else np.inf)
    if wind[-1] - times[-1] > allowed_s:
        last = datetime.fromtimestamp(float(times[-1]), UTC)
        notes.append(f"The {what} of the file end at {last:%Y-%m-%d %H:%M} UTC; the last are held.")


def _current(raw: RawFile, wind: RawField, box: Box | None, notes: list[str]) -> Current | None:
    """Make the current that came with a wind; where it cannot be used, the wind still can."""
    if raw.current is None:
        return None
    try:
        current = _make_current(raw.current, raw, box)
    except WeatherError as error:
        notes.append(f"The current in the file is not used: {error}.")
        return None
    _tell_end("currents", current.time, wind.time, notes)
    return current


def _make_current(current: RawField, raw: RawFile, box: Box | None) -> Current:
    field = regular(current, box)
    if box is not None and not _meets(field, box):
        raise WeatherError("its current does not reach the area of the passage")
    field = cropped(field, box)
    u, v = (part.mean(axis=0) if part.ndim == 4 else part for part in field.parts)
    missing = np.isnan(u) | np.isnan(v)
    if missing.all():
        raise WeatherError("its current is missing (masked) all over the area of the passage")
    u, v = np.where(missing, np.float32(0.0), u), np.where(missing, np.float32(0.0), v)
    fastest = float(np.hypot(u, v).max())
    if fastest > MAX_CURRENT:
        raise WeatherError(f"its current runs at {fastest:.0f} m/s, which no water does")
    lat, lon, u, v = _fenced(field.lat, field.lon, u, v)
    return Current(field.time, lat, lon, u, v, _forecast(raw.source, raw.issued, field, ()))


def _meets(field: RawField, box: Box) -> bool:
    south, west, north, east = box
    rows = field.lat.size == 1 or (field.lat[0] <= north and field.lat[-1] >= south)
    columns = field.lon.size == 1 or (field.lon[0] <= east and field.lon[-1] >= west)
    return bool(rows and columns)


def _fenced(lat: Array, lon: Array, u: Grid, v: Grid) -> tuple[Array, Array, Grid, Grid]:
    """Put a rim of still water around a current: a grid's edge holds beyond it, and no current does."""
    rows, columns = (0, 0), (0, 0)
    if lat.size > 1:
        step = (lat[-1] - lat[0]) / (lat.size - 1)
        rows = (int(lat[0] - step >= -90.0), int(lat[-1] + step <= 90.0))
        lat = lat[0] + step * np.arange(-rows[0], lat.size + rows[1])
    if lon.size > 1 and lon[-1] - lon[0] < _WORLD_DEG:
        step, columns = (lon[-1] - lon[0]) / (lon.size - 1), (1, 1)
        lon = lon[0] + step * np.arange(-1, lon.size + 1)
    u, v = (np.pad(part, [(0, 0), rows, columns]) for part in (u, v))
    return lat, lon, u, v
