"""From the grids that models and files come on to regular ones: true north, ascending, evenly spaced."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from datetime import datetime
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import WeatherError

Array = NDArray[np.float64]
Grid = NDArray[np.float32]
Index = NDArray[np.int64]
Box = tuple[float, float, float, float]
"""South, west, north, east [degrees]."""

Place = tuple[float, float]
"""Latitude, longitude [degrees]."""

MAX_VALUES: Final = 20_000_000
"""Values per component that a resampled grid may have (80 MB); finer model grids are thinned to it."""

MOST_READ: Final = 250_000_000
"""Values that a variable or message may claim to have (1 GB): a flipped bit must not eat all the memory."""

_EVEN: Final = 1e-3
_ROUNDED: Final = 1e-6


@dataclass(frozen=True, slots=True)
class RawField:
    """Values on one grid as they were read: missing ones are NaN, axes run either way.

    Attributes
    ----------
    time
        ``(t,)`` seconds since 1970-01-01T00:00Z, increasing.
    lat, lon
        ``(y,)`` and ``(x,)`` degrees of a regular grid, or both ``(y, x)`` of any other; longitudes may
        exceed 180.
    parts
        One array for a speed or a height, two for the components of a vector, each ``(t, y, x)``, or
        ``(m, t, y, x)`` with the members of an ensemble.
    grid_relative
        Whether the components follow the grid's own axes instead of east and north.
    """

    time: Array
    lat: Array
    lon: Array
    parts: tuple[Grid, ...]
    grid_relative: bool = False

    @property
    def step(self) -> float:
        """Distance of neighbouring latitudes of a regular grid [degrees]; 0 for a single one."""
        return float(abs(self.lat[-1] - self.lat[0])) / max(self.lat.size - 1, 1)

    def mapped(
        self,
        change: Callable[[Grid], Grid],
        *,
        time: Array | None = None,
        lat: Array | None = None,
        lon: Array | None = None,
    ) -> RawField:
        """Change every part alike, and the axes that are given."""
        return replace(
            self,
            parts=tuple(change(part) for part in self.parts),
            time=self.time if time is None else time,
            lat=self.lat if lat is None else lat,
            lon=self.lon if lon is None else lon,
        )


@dataclass(frozen=True, slots=True)
class RawFile:
    """What a file holds for a sailor, each layer on the grid it came on.

    Attributes
    ----------
    wind, current
        Vectors [m/s], ``None`` when there are none that can be used.
    gust, wave
        Speed of the gusts [m/s] and significant wave height [m].
    troubles
        Why a layer is ``None``, by its name, as an unfinished sentence.
    notes
        Sentences for the sailor about what was chosen or repaired.
    """

    source: str
    issued: datetime | None = None
    wind: RawField | None = None
    gust: RawField | None = None
    wave: RawField | None = None
    current: RawField | None = None
    troubles: Mapping[str, str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()


def passage_box(places: Sequence[Place], margin_deg: float) -> Box:
    """South, west, north, east [degrees] around positions, with room on every side.

    The margin is in degrees of latitude; degrees of longitude are shorter and get more of them.
    """
    lat, lon = [place[0] for place in places], [place[1] for place in places]
    south, north = max(min(lat) - margin_deg, -90.0), min(max(lat) + margin_deg, 90.0)
    wider = margin_deg / max(float(np.cos(np.radians((south + north) / 2))), 0.2)
    return south, min(lon) - wider, north, max(lon) + wider


def regular(raw: RawField, box: Box | None = None) -> RawField:
    """Bring a field to true north on a regular, ascending, evenly spaced grid.

    Parameters
    ----------
    box
        What is wanted; a curvilinear grid is only resampled around it. Others are kept whole.

    Raises
    ------
    WeatherError
        ``bad-response``, with an unfinished sentence, when the grid does not reach the box.
    """
    return _evened(ascending(_resampled(raw, box) if raw.lat.ndim == 2 else raw))


def bilinear(values: Grid, row: Array, column: Array) -> Grid:
    """Interpolate ``(..., y, x)`` values at fractional rows and columns; NaN outside the grid."""
    rows, columns = values.shape[-2:]
    outside = (row < 0) | (row > rows - 1) | (column < 0) | (column > columns - 1)
    i = np.clip(row.astype(np.int64), 0, max(rows - 2, 0))
    j = np.clip(column.astype(np.int64), 0, max(columns - 2, 0))
    i1, j1 = np.minimum(i + 1, rows - 1), np.minimum(j + 1, columns - 1)
    wi, wj = (row - i).astype(np.float32), (column - j).astype(np.float32)
    low = values[..., i, j] * (1 - wj) + values[..., i, j1] * wj
    high = values[..., i1, j] * (1 - wj) + values[..., i1, j1] * wj
    result = low * (1 - wi) + high * wi
    result[..., outside] = np.nan
    return np.asarray(result, dtype=np.float32)


def onto(raw: RawField, lat: Array, lon: Array) -> RawField:
    """Interpolate a regular, ascending field onto other axes; NaN where it does not reach.

    An axis of a single value holds everywhere along it.
    """

    def position(wanted: Array, axis: Array) -> Array:
        if axis.size == 1:
            return np.zeros(wanted.shape)
        # a rounded last digit is no reason to lose an edge
        near = np.where(np.abs(wanted - axis[0]) < _ROUNDED, axis[0], wanted)
        near = np.where(np.abs(wanted - axis[-1]) < _ROUNDED, axis[-1], near)
        return np.interp(near, axis, np.arange(axis.size, dtype=np.float64), left=-1, right=-1)

    rows, columns = np.meshgrid(position(lat, raw.lat), position(lon, raw.lon), indexing="ij")
    return raw.mapped(lambda part: bilinear(part, rows, columns), lat=lat, lon=lon)


def ascending(raw: RawField) -> RawField:
    """Sort the axes, bring longitudes to -180..180 and close a grid that goes around the world."""
    rows = np.argsort(raw.lat)
    lon = raw.lon
    if lon.size > 1:
        lon = np.unwrap(lon, period=360.0)
    columns = np.argsort(lon)
    lon = lon[columns]
    lon = lon - 360.0 * np.floor((lon[0] + 180.0) / 360.0)
    step = (lon[-1] - lon[0]) / max(lon.size - 1, 1)
    if lon.size > 2 and abs(lon[-1] + step - lon[0] - 360.0) < step / 2:
        shift = int(np.searchsorted(lon, 180.0))
        lon = np.concatenate([lon[shift:] - 360.0, lon[:shift]])
        lon = np.append(lon, lon[0] + 360.0)
        columns = np.append(np.roll(columns, -shift), columns[shift % columns.size])
    down, across = _cut(rows), _cut(columns)
    return raw.mapped(lambda part: part[..., down, :][..., across], lat=raw.lat[rows], lon=lon)


def _cut(index: Index) -> Index | slice:
    """Give an index as a slice where it is one: turning a grid upside down need not copy all its members."""
    if index.size > 1 and (np.diff(index) == 1).all():
        return slice(int(index[0]), int(index[-1]) + 1)
    if index.size > 1 and (np.diff(index) == -1).all():
        return slice(int(index[0]), None if index[-1] == 0 else int(index[-1]) - 1, -1)
    return index


def cropped(raw: RawField, box: Box | None) -> RawField:
    """Keep what encloses a box."""
    if box is None:
        return raw
    south, west, north, east = box
    rows, columns = _within(raw.lat, south, north), _within(raw.lon, west, east)
    return raw.mapped(lambda part: part[..., rows, columns], lat=raw.lat[rows], lon=raw.lon[columns])


def _within(axis: Array, low: float, high: float) -> slice:
    """Slice of an axis that encloses a span; at least two nodes, where the axis has them."""
    first = int(np.clip(np.searchsorted(axis, low, side="right") - 1, 0, max(axis.size - 2, 0)))
    last = int(
        np.clip(np.searchsorted(axis, high, side="left"), min(first + 1, axis.size - 1), axis.size - 1)
    )
    return slice(first, last + 1)


def _evened(raw: RawField) -> RawField:
    """Resample axes that are not evenly spaced, Gaussian latitudes for example."""

    def even(axis: Array) -> Array:
        straight = np.linspace(axis[0], axis[-1], axis.size)
        step = (axis[-1] - axis[0]) / max(axis.size - 1, 1)
        return axis if np.abs(axis - straight).max() <= _EVEN * step / 2 else straight

    lat, lon = even(raw.lat), even(raw.lon)
    return raw if lat is raw.lat and lon is raw.lon else onto(raw, lat, lon)


def _resampled(raw: RawField, box: Box | None) -> RawField:
    """Bring a curvilinear field (Lambert, rotated pole) to true north and a regular grid.

    The regular grid has the spacing of the original and is the part of its bounding box that the
    original fills completely, found by dropping the emptiest edge until nothing is missing.
    """
    turned = to_true_north(raw) if raw.grid_relative else raw
    lat, lon = _target_axes(raw, box)
    row, column = _locate(raw.lat, raw.lon, lat, lon)
    inside = (row >= 0) & (row <= raw.lat.shape[0] - 1) & (column >= 0) & (column <= raw.lat.shape[1] - 1)
    rows, columns = _filled_part(inside)
    if rows.stop - rows.start < 2 or columns.stop - columns.start < 2:
        raise WeatherError("its grid does not reach the area of the passage")
    row, column = row[rows, columns], column[rows, columns]
    return turned.mapped(lambda part: bilinear(part, row, column), lat=lat[rows], lon=lon[columns])


def to_true_north(raw: RawField) -> RawField:
    """Turn the components of a curvilinear field from along the grid's axes to east and north.

    The angle of the axes is measured on the positions themselves, so that no projection has to be known.
    """
    # towards the last column, the way the file counts its x axis
    dlat = np.gradient(raw.lat, axis=1)
    dlon = np.gradient(np.unwrap(raw.lon, axis=1, period=360.0), axis=1) * np.cos(np.radians(raw.lat))
    length = np.hypot(dlat, dlon)
    cos, sin = (dlon / length).astype(np.float32), (dlat / length).astype(np.float32)
    u, v = raw.parts
    return replace(raw, parts=(u * cos - v * sin, u * sin + v * cos), grid_relative=False)


def _target_axes(raw: RawField, box: Box | None) -> tuple[Array, Array]:
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
    nodes = raw.parts[0].size // raw.lat.size * (north - south) / step * (east - west) / step_lon
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
