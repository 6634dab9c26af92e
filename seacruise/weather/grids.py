"""From the grids that models and files come on to the one regular grid of `Wind`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import WeatherError
from seacruise.weather.gaps import fill_gaps
from seacruise.weather.wind import Forecast, Wind, describe_grid, require_cover

Array = NDArray[np.float64]
Grid = NDArray[np.float32]
Index = NDArray[np.int64]
Box = tuple[float, float, float, float]
"""South, west, north, east [degrees]."""

Place = tuple[float, float]
"""Latitude, longitude [degrees]."""

MARGIN_DEG: Final = 3.0
"""What is kept of a file around the ends of a passage, at least: room for any detour [degrees]."""

MAX_VALUES: Final = 20_000_000
"""Values per component that a resampled wind may have (80 MB); finer model grids are thinned to it."""

_EVEN: Final = 1e-3


@dataclass(frozen=True, slots=True)
class RawWind:
    """A wind as it was read: missing values are NaN, axes run either way, longitudes may exceed 180.

    Attributes
    ----------
    time
        ``(t,)`` seconds since 1970-01-01T00:00Z.
    lat, lon
        ``(y,)`` and ``(x,)`` degrees of a regular grid, or both ``(y, x)`` of any other.
    u, v
        ``(t, y, x)`` [m/s]; along the grid's own axes when ``grid_relative``.
    notes
        Sentences for the sailor about what was chosen or repaired.
    """

    time: Array
    lat: Array
    lon: Array
    u: Grid
    v: Grid
    source: str
    issued: datetime | None
    grid_relative: bool = False
    notes: tuple[str, ...] = ()


def passage_box(places: Sequence[Place], margin_deg: float) -> Box:
    """South, west, north, east [degrees] around positions, with room on every side.

    The margin is in degrees of latitude; degrees of longitude are shorter and get more of them.
    """
    lat, lon = [place[0] for place in places], [place[1] for place in places]
    south, north = max(min(lat) - margin_deg, -90.0), min(max(lat) + margin_deg, 90.0)
    wider = margin_deg / max(float(np.cos(np.radians((south + north) / 2))), 0.2)
    return south, min(lon) - wider, north, max(lon) + wider


def to_wind(raw: RawWind, *, around: Sequence[Place] = ()) -> Wind:
    """Bring a wind as read onto the regular grid of `Wind`: true north, ascending, whole.

    Parameters
    ----------
    around
        Ends of a passage: they must be covered, and only what a passage between them may meet is kept
        and judged for missing values. Without any, all is kept.

    Raises
    ------
    WeatherError
        ``bad-response``, with an unfinished sentence, when the values cannot be used.
    NoPassageError
        ``outside-forecast`` when an end is not covered.
    """
    box = None
    if around:
        span = max(abs(around[0][0] - around[-1][0]), abs(around[0][1] - around[-1][1]) / 2)
        box = passage_box(around, max(MARGIN_DEG, span / 2))
    if raw.lat.ndim == 2:
        _require_reach(raw, around)
    regular = _evened(ascending(_resampled(raw, box) if raw.lat.ndim == 2 else raw))
    require_cover(raw.source, (regular.lat, regular.lon), around)
    cropped = _cropped(regular, box)
    u, v = fill_gaps(cropped.u, cropped.v)
    valid_from, valid_to, step_h, resolution = describe_grid(cropped.time, cropped.lat, cropped.lon)
    notes = cropped.notes
    if cropped.time.size == 1:
        notes += ("The file holds a single time; its wind is held from then on.",)
    forecast = Forecast(
        source=raw.source,
        issued=raw.issued,
        valid_from=valid_from,
        valid_to=valid_to,
        step_h=step_h,
        resolution_deg=resolution,
        notice=" ".join(notes),
    )
    return Wind(time=cropped.time, lat=cropped.lat, lon=cropped.lon, u=u, v=v, forecast=forecast)


def bilinear(values: Grid, row: Array, column: Array) -> Grid:
    """Interpolate ``(t, y, x)`` values at fractional rows and columns; NaN outside the grid."""
    rows, columns = values.shape[1:]
    outside = (row < 0) | (row > rows - 1) | (column < 0) | (column > columns - 1)
    i = np.clip(row.astype(np.int64), 0, max(rows - 2, 0))
    j = np.clip(column.astype(np.int64), 0, max(columns - 2, 0))
    i1, j1 = np.minimum(i + 1, rows - 1), np.minimum(j + 1, columns - 1)
    wi, wj = (row - i).astype(np.float32), (column - j).astype(np.float32)
    low = values[:, i, j] * (1 - wj) + values[:, i, j1] * wj
    high = values[:, i1, j] * (1 - wj) + values[:, i1, j1] * wj
    result = low * (1 - wi) + high * wi
    result[:, outside] = np.nan
    return np.asarray(result, dtype=np.float32)


def onto(raw: RawWind, lat: Array, lon: Array) -> RawWind:
    """Interpolate a regular, ascending wind onto other axes; NaN where it does not reach."""
    row = np.interp(lat, raw.lat, np.arange(raw.lat.size), left=-1, right=-1)
    column = np.interp(lon, raw.lon, np.arange(raw.lon.size), left=-1, right=-1)
    rows, columns = np.meshgrid(row, column, indexing="ij")
    u, v = bilinear(raw.u, rows, columns), bilinear(raw.v, rows, columns)
    return replace(raw, lat=lat, lon=lon, u=u, v=v)


def ascending(raw: RawWind) -> RawWind:
    """Sort the axes, bring longitudes to -180..180 and close a grid that goes around the world."""
    rows = np.argsort(raw.lat)
    lon = raw.lon
    if lon.size > 1:
        lon = np.unwrap(lon, period=360.0)
    columns = np.argsort(lon)
    lon = lon[columns]
    lon = lon - 360.0 * np.floor((lon[0] + 180.0) / 360.0)
    u, v = raw.u[:, rows][:, :, columns], raw.v[:, rows][:, :, columns]
    step = (lon[-1] - lon[0]) / max(lon.size - 1, 1)
    if lon.size > 2 and abs(lon[-1] + step - lon[0] - 360.0) < step / 2:
        shift = int(np.searchsorted(lon, 180.0))
        lon = np.concatenate([lon[shift:] - 360.0, lon[:shift]])
        lon = np.append(lon, lon[0] + 360.0)
        u, v = (np.roll(part, -shift, axis=2) for part in (u, v))
        u, v = (np.concatenate([part, part[:, :, :1]], axis=2) for part in (u, v))
    return replace(raw, lat=raw.lat[rows], lon=lon, u=u, v=v)


def _cropped(raw: RawWind, box: Box | None) -> RawWind:
    if box is None:
        return raw
    south, west, north, east = box
    rows = _within(raw.lat, south, north)
    columns = _within(raw.lon, west, east)
    return replace(
        raw, lat=raw.lat[rows], lon=raw.lon[columns], u=raw.u[:, rows, columns], v=raw.v[:, rows, columns]
    )


def _within(axis: Array, low: float, high: float) -> slice:
    """Slice of an axis that encloses a span; at least two nodes, where the axis has them."""
    first = int(np.clip(np.searchsorted(axis, low, side="right") - 1, 0, max(axis.size - 2, 0)))
    last = int(
        np.clip(np.searchsorted(axis, high, side="left"), min(first + 1, axis.size - 1), axis.size - 1)
    )
    return slice(first, last + 1)


def _evened(raw: RawWind) -> RawWind:
    """Resample axes that are not evenly spaced, Gaussian latitudes for example."""

    def even(axis: Array) -> Array:
        straight = np.linspace(axis[0], axis[-1], axis.size)
        step = (axis[-1] - axis[0]) / max(axis.size - 1, 1)
        return axis if np.abs(axis - straight).max() <= _EVEN * step / 2 else straight

    lat, lon = even(raw.lat), even(raw.lon)
    return raw if lat is raw.lat and lon is raw.lon else onto(raw, lat, lon)


def _resampled(raw: RawWind, box: Box | None) -> RawWind:
    """Bring a curvilinear wind (Lambert, rotated pole) to true north and a regular grid.

    The regular grid has the spacing of the original and is the part of its bounding box that the
    original fills completely, found by dropping the emptiest edge until nothing is missing.
    """
    u, v = _to_true_north(raw) if raw.grid_relative else (raw.u, raw.v)
    lat, lon = _target_axes(raw, box)
    row, column = _locate(raw.lat, raw.lon, lat, lon)
    inside = (row >= 0) & (row <= raw.lat.shape[0] - 1) & (column >= 0) & (column <= raw.lat.shape[1] - 1)
    rows, columns = _filled_part(inside)
    if rows.stop - rows.start < 2 or columns.stop - columns.start < 2:
        raise WeatherError("its grid does not reach the area of the passage")
    row, column = row[rows, columns], column[rows, columns]
    return replace(
        raw,
        lat=lat[rows],
        lon=lon[columns],
        u=bilinear(u, row, column),
        v=bilinear(v, row, column),
        grid_relative=False,
    )


def _require_reach(raw: RawWind, around: Sequence[Place]) -> None:
    """Check positions against the bounds of a curvilinear grid, before it is cut to their surroundings."""
    bounds = (
        np.array([raw.lat.min(), raw.lat.max()]),
        np.array([raw.lon.min(), raw.lon.max()]),
    )
    require_cover(raw.source, bounds, around)


def _to_true_north(raw: RawWind) -> tuple[Grid, Grid]:
    """Turn components along the grid's axes to east and north.

    The angle of the axes is measured on the positions themselves, so that no projection has to be known.
    """
    # towards the last column, the way the file counts its x axis
    dlat = np.gradient(raw.lat, axis=1)
    dlon = np.gradient(np.unwrap(raw.lon, axis=1, period=360.0), axis=1) * np.cos(np.radians(raw.lat))
    length = np.hypot(dlat, dlon)
    cos, sin = (dlon / length).astype(np.float32), (dlat / length).astype(np.float32)
    return raw.u * cos - raw.v * sin, raw.u * sin + raw.v * cos


def _target_axes(raw: RawWind, box: Box | None) -> tuple[Array, Array]:
    along = np.hypot(*(np.diff(part, axis=0) for part in (raw.lat, raw.lon * np.cos(np.radians(raw.lat)))))
    step = float(np.median(along))
    middle = float(np.median(raw.lat))
    south, north = float(raw.lat.min()), float(raw.lat.max())
    west, east = float(raw.lon.min()), float(raw.lon.max())
    if box is not None:
        south, west = max(south, box[0] - 2 * step), max(west, box[1] - 4 * step)
        north, east = min(north, box[2] + 2 * step), min(east, box[3] + 4 * step)
        if south >= north or west >= east:
            raise WeatherError("its grid does not reach the area of the passage")
    step_lon = step / np.cos(np.radians(middle))
    nodes = raw.time.size * (north - south) / step * (east - west) / step_lon
    coarser = max(1.0, float(np.sqrt(nodes / MAX_VALUES)))
    lat = np.linspace(south, north, max(int((north - south) / step / coarser), 1) + 1)
    lon = np.linspace(west, east, max(int((east - west) / step_lon / coarser), 1) + 1)
    return lat, lon


def _locate(grid_lat: Array, grid_lon: Array, lat: Array, lon: Array) -> tuple[Array, Array]:
    """Fractional row and column of a curvilinear grid at each node of a regular one.

    Newton's method on the grid's own bilinear positions; such grids are smooth, a handful of rounds
    brings it to a millionth of a cell.
    """
    rows, columns = grid_lat.shape
    target_lat, target_lon = np.meshgrid(lat, lon, indexing="ij")
    row = np.full(target_lat.shape, (rows - 1) / 2)
    column = np.full(target_lat.shape, (columns - 1) / 2)
    for _ in range(12):
        i, j = np.clip(row.astype(np.int64), 0, rows - 2), np.clip(column.astype(np.int64), 0, columns - 2)
        wi, wj = (row - i).astype(np.float64), (column - j).astype(np.float64)
        error_lat, lat_i, lat_j = _cell(grid_lat, (i, j), (wi, wj))
        error_lon, lon_i, lon_j = _cell(grid_lon, (i, j), (wi, wj))
        error_lat, error_lon = target_lat - error_lat, target_lon - error_lon
        area = lat_i * lon_j - lat_j * lon_i
        row_step = (error_lat * lon_j - error_lon * lat_j) / area
        column_step = (error_lon * lat_i - error_lat * lon_i) / area
        row, column = np.clip(row + row_step, -9, rows + 9), np.clip(column + column_step, -9, columns + 9)
        if max(np.abs(row_step).max(), np.abs(column_step).max()) < 1e-6:
            break
    return row, column


def _cell(grid: Array, index: tuple[Index, Index], weight: tuple[Array, Array]) -> tuple[Array, Array, Array]:
    """Value of a bilinear cell and its change per row and per column."""
    (i, j), (wi, wj) = index, weight
    a, b, c, d = grid[i, j], grid[i, j + 1], grid[i + 1, j], grid[i + 1, j + 1]
    low, high = a + (b - a) * wj, c + (d - c) * wj
    return low + (high - low) * wi, high - low, (b - a) * (1 - wi) + (d - c) * wi


def _filled_part(inside: NDArray[np.bool_]) -> tuple[slice, slice]:
    """Rows and columns of a rectangle without holes, by dropping the emptiest edge again and again."""
    top, bottom, left, right = 0, inside.shape[0], 0, inside.shape[1]
    while top < bottom and left < right:
        part = inside[top:bottom, left:right]
        edges = [float(edge.mean()) for edge in (part[0], part[-1], part[:, 0], part[:, -1])]
        worst = int(np.argmin(edges))
        if edges[worst] == 1.0:
            break
        top, bottom = top + (worst == 0), bottom - (worst == 1)
        left, right = left + (worst == 2), right - (worst == 3)
    return slice(top, bottom), slice(left, right)
