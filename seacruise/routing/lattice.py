"""The lattice of the sea: triangular, in the Mercator plane, finer near the shore where that is asked.

Mercator keeps angles, so the courses of a stencil are the same compass courses everywhere, and each edge
is a rhumb line. Levels are nested: level s has half the spacing of level s - 1 and contains its
vertices, so a fine lattice near the shore is joined to the coarse one by the vertices they share.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError
from seacruise.geodesy import EARTH_RADIUS, from_mercator, scale, to_mercator
from seacruise.routing import stencil
from seacruise.sea import Sea
from seacruise.units import METRES_PER_NM

Array = NDArray[np.float64]

MOST_VERTICES: Final = 6_000_000
"""Finer lattices are refused: they would not fit in the memory of a small computer."""

_JOINED: Final = 48


@dataclass(frozen=True, slots=True)
class Area:
    """Where vertices may lie: within a sum of distances to both ends (an ellipse), or along a line.

    Attributes
    ----------
    line
        ``(m, 2)`` points of the Mercator plane [m]: the two ends, or the passage around which to refine.
    reach_m
        With ``kind="ellipse"`` the greatest sum of the distances to both ends [m, true]; with
        ``"rectangle"`` and ``"corridor"`` the greatest distance to the line [m of the plane].
    """

    kind: str
    line: Any
    reach_m: float


@dataclass(frozen=True, slots=True)
class Levels:
    """How the lattice is refined towards the shore.

    Attributes
    ----------
    everywhere
        Levels by which the whole shore is refined.
    at_ports
        Further levels near the two ends.
    port_m
        Distance from an end within which those apply [m of the plane].
    """

    everywhere: int = 0
    at_ports: int = 0
    port_m: float = 0.0

    @property
    def deepest(self) -> int:
        """Number of the finest level."""
        return self.everywhere + self.at_ports


NO_LEVELS: Final = Levels()


@dataclass(frozen=True, slots=True, eq=False)
class Lattice:
    """Vertices in the Mercator plane and edges as compressed sparse rows.

    Attributes
    ----------
    x, y, lat, lon, scale
        ``(n,)`` of each vertex: plane [m], degrees, true metres per metre of the plane.
    first, target
        Edges of vertex v lead to ``target[first[v]:first[v + 1]]``.
    start, end
        Vertices of the two ends: the last two.
    spacing_m
        Side of the coarsest triangles [m of the plane].
    """

    x: Array
    y: Array
    lat: Array
    lon: Array
    scale: Array
    first: NDArray[np.int64]
    target: NDArray[np.int32]
    start: int
    end: int
    spacing_m: float

    @property
    def points(self) -> tuple[Array, Array, Array, Array, Array]:
        """What the kernels call ``points``."""
        return self.x, self.y, self.lat, self.lon, self.scale

    @property
    def edges(self) -> tuple[NDArray[np.int64], NDArray[np.int32]]:
        """What the kernels call ``edges``."""
        return self.first, self.target

    @property
    def vertices(self) -> int:
        """Number of vertices."""
        return int(self.x.size)

    def sources(self) -> NDArray[np.int32]:
        """Source vertex of each edge, ``(m,)``."""
        return np.repeat(np.arange(self.vertices, dtype=np.int32), np.diff(self.first))


def build(
    sea: Sea,
    start: tuple[float, float],
    end: tuple[float, float],
    *,
    spacing_nm: float,
    offsets: NDArray[np.int64],
    area: Area,
    levels: Levels = NO_LEVELS,
    enter_from: int | None = None,
) -> Lattice:
    """Build the lattice between two positions [degrees].

    Parameters
    ----------
    spacing_nm
        Side of the coarsest triangles [nm, true at the middle latitude].
    offsets
        Stencil, see `seacruise.routing.stencil`.
    enter_from
        R1's way: the start is the lattice's own first vertex, and only that many vertices nearest to the
        end lead into it. By default both ends are joined to every vertex near them that is in sight.

    Raises
    ------
    InputError
        When the lattice would not fit in memory.
    """
    (sx, ex), (sy, ey) = (c.tolist() for c in to_mercator([start[0], end[0]], [start[1], end[1]]))
    middle = float(from_mercator(0.0, (sy + ey) / 2)[0])
    spacing = spacing_nm * METRES_PER_NM / float(scale(middle))
    grower = _Grower(sea, (sx, sy), (ex, ey), spacing, area, levels)
    whole = grower.grow(None, 0, offsets, None)
    for level in range(1, levels.everywhere + 1):
        whole = grower.grow(whole, level, offsets, None)
    for port in ((sx, sy), (ex, ey)):
        patch = whole
        for level in range(levels.everywhere + 1, levels.deepest + 1):
            patch = grower.grow(patch, level, offsets, port)
    return grower.finish(enter_from)


@dataclass(frozen=True, slots=True, eq=False)
class _Patch:
    """Numbers of the vertices at the axial positions of one level; -1 where there is none."""

    index: NDArray[np.int32]
    column: int
    row: int


class _Grower:
    """Collects vertices and edges patch by patch; `build` is its only user."""

    def __init__(
        self,
        sea: Sea,
        start: tuple[float, float],
        end: tuple[float, float],
        spacing: float,
        area: Area,
        levels: Levels,
    ) -> None:
        self.sea, self.start, self.end = sea, start, end
        self.spacing, self.area, self.levels = spacing, area, levels
        self.x: list[Array] = []
        self.y: list[Array] = []
        self.count = 0
        self.a: list[NDArray[np.int32]] = []
        self.b: list[NDArray[np.int32]] = []

    def grow(
        self, above: _Patch | None, level: int, offsets: NDArray[np.int64], port: tuple[float, float] | None
    ) -> _Patch:
        """Add the vertices of a level that are not there yet, and the edges of its stencil.

        With a ``port`` only the water within `Levels.port_m` of it, else the whole area.
        """
        side = self.spacing / 2**level
        column, row, shape = self._frame(side, port)
        if shape[0] * shape[1] > 8 * MOST_VERTICES:
            raise InputError(
                f"A lattice of {self.spacing * float(scale(55)) / METRES_PER_NM:.2f} nm over this area is too "
                "fine for this computer; choose a wider spacing."
            )
        rows, columns = np.arange(row, row + shape[0]), np.arange(column, column + shape[1])
        x = self.start[0] + side * (columns[None, :] + rows[:, None] / 2.0)
        y = np.broadcast_to((self.start[1] + side * stencil.ROW_HEIGHT * rows)[:, None], shape)
        wanted = self._wanted(side if level else None, x, y, port)
        patch = _Patch(np.full(shape, -1, dtype=np.int32), column, row)
        if above is not None:
            _share(patch, above, wanted)
        fresh = wanted & (patch.index < 0)
        number = int(np.count_nonzero(fresh))
        patch.index[fresh] = np.arange(self.count, self.count + number, dtype=np.int32)
        self.x.append(x[fresh])
        self.y.append(y[fresh])
        self.count += number
        self._join(patch.index, offsets)
        return patch

    def _frame(self, side: float, port: tuple[float, float] | None) -> tuple[int, int, tuple[int, int]]:
        """First column and row (even), and shape, of the axial rectangle around what is wanted."""
        line = np.asarray(self.area.line, dtype=np.float64)
        reach = self.area.reach_m
        if port is not None:
            line, reach = np.array([port]), self.levels.port_m
        elif self.area.kind == "ellipse":
            flat = float(scale(from_mercator(0.0, np.abs(line[:, 1]).max())[0])) * 0.95
            length, total = float(np.hypot(*(line[-1] - line[0]))), self.area.reach_m / flat
            reach = max((total - length) / 2, math.sqrt(max(0.0, total**2 - length**2)) / 2)
        low = (line.min(axis=0) - reach - self.start) / side
        high = (line.max(axis=0) + reach - self.start) / side
        j0, j1 = math.floor(low[1] / stencil.ROW_HEIGHT), math.ceil(high[1] / stencil.ROW_HEIGHT)
        i0, i1 = math.floor(low[0] - j1 / 2), math.ceil(high[0] - j0 / 2)
        i0, j0 = i0 - i0 % 2, j0 - j0 % 2
        return i0, j0, (j1 - j0 + 1, i1 - i0 + 1)

    def _wanted(
        self, refined: float | None, x: Array, y: Array, port: tuple[float, float] | None
    ) -> NDArray[np.bool_]:
        """Which points become vertices: water, in the area, and near the shore when refining.

        ``refined`` is the spacing of a refined level: it begins two of its sides from the shore.
        """
        from seacruise.sea import _kernels as k

        value = self.sea.water.at(x, y)
        wanted = value >= k.WATER
        shore = np.flatnonzero((value == k.SHORE) | (value == k.SHORE_WATER))
        wanted.ravel()[shore] = self.sea.is_water_at(x.ravel()[shore], y.ravel()[shore])
        if refined is not None:
            wanted &= (value.astype(np.float64) - k.WATER) * self.sea.water.cell < 2.0 * refined
        at = np.flatnonzero(wanted)
        px, py = x.ravel()[at], y.ravel()[at]
        if port is not None:
            keep = np.hypot(px - port[0], py - port[1]) <= self.levels.port_m
        else:
            keep = self._inside(px, py)
        wanted.ravel()[at[~keep]] = False
        return np.asarray(wanted)

    def _inside(self, x: Array, y: Array) -> NDArray[np.bool_]:
        line = np.asarray(self.area.line, dtype=np.float64)
        if self.area.kind == "ellipse":
            total = np.zeros(x.size)
            lat, lon = from_mercator(x, y)
            for point in line[[0, -1]]:
                total += chord_m(lat, lon, *(float(c) for c in from_mercator(*point)))
            return np.asarray(total <= self.area.reach_m)
        if self.area.kind == "rectangle":
            along = (line[-1] - line[0]) / np.hypot(*(line[-1] - line[0]))
            dx, dy = x - line[0, 0], y - line[0, 1]
            s, across = dx * along[0] + dy * along[1], dx * along[1] - dy * along[0]
            length = float(np.hypot(*(line[-1] - line[0])))
            return np.asarray((np.abs(across) <= self.area.reach_m) & (s >= -1.0) & (s <= length + 1.0))
        return distance_to_line(x, y, line) <= self.area.reach_m

    def _join(self, index: NDArray[np.int32], offsets: NDArray[np.int64]) -> None:
        """Add the edges that cross no land, both ways; half of the stencil finds them all."""
        rows, columns = index.shape
        xs, ys = np.concatenate(self.x), np.concatenate(self.y)
        for i, j in offsets[: len(offsets) // 2].tolist():
            r0, r1 = max(0, -j), min(rows, rows - j)
            c0, c1 = max(0, -i), min(columns, columns - i)
            if r0 >= r1 or c0 >= c1:
                continue
            a = index[r0:r1, c0:c1]
            b = index[r0 + j : r1 + j, c0 + i : c1 + i]
            both = (a >= 0) & (b >= 0)
            a, b = a[both], b[both]
            free = self.sea.clear(np.stack([xs[a], ys[a], xs[b], ys[b]], axis=1))
            self.a.append(a[free])
            self.b.append(b[free])

    def finish(self, enter_from: int | None) -> Lattice:
        """Join both ends and pack the edges into rows."""
        from seacruise.routing import _kernels as k

        x = np.concatenate([*self.x, [self.start[0], self.end[0]]])
        y = np.concatenate([*self.y, [self.start[1], self.end[1]]])
        n = x.size
        start = n - 2
        if enter_from is None:
            leaves, enters = self._in_sight(x, y, n - 2), self._in_sight(x, y, n - 1)
        else:
            start = int(np.argmin(np.hypot(x[:-2] - self.start[0], y[:-2] - self.start[1])))
            leaves, enters = np.empty(0, np.int32), self._in_sight(x, y, n - 1, most=enter_from)
        a = [*self.a, *self.b, np.full(leaves.size, n - 2, np.int32), enters]
        b = [*self.b, *self.a, leaves, np.full(enters.size, n - 1, np.int32)]
        if enter_from is None and bool(self.sea.clear(np.array([[*self.start, *self.end]]))[0]):
            a.append(np.array([n - 2], np.int32))
            b.append(np.array([n - 1], np.int32))
        source, target = np.concatenate(a), np.concatenate(b)
        first, order = k.sort_rows(source, n)
        lat, lon = from_mercator(x, y)
        return Lattice(x, y, lat, lon, scale(lat), first, target[order], start, n - 1, self.spacing)

    def _in_sight(self, x: Array, y: Array, end: int, *, most: int | None = None) -> NDArray[np.int32]:
        """Vertices that an end is joined to: those within two sides of its triangles, level by level."""
        away = np.hypot(x[:-2] - x[end], y[:-2] - y[end])
        nearest = np.argsort(away, kind="stable")
        if most is not None:
            near = nearest[:most]
        else:
            near = nearest[:_JOINED]
            for level in range(self.levels.deepest + 1):
                ring = np.flatnonzero(away < 2.1 * self.spacing / 2**level)
                # Of a crowded ring the outer ones: the inner ones belong to the next level.
                near = np.union1d(near, ring[np.argsort(-away[ring], kind="stable")[:_JOINED]])
        near = near[away[near] > 1e-6]
        here = np.full(near.size, x[end]), np.full(near.size, y[end])
        free = self.sea.clear(np.stack([*here, x[near], y[near]], axis=1))
        return near[free].astype(np.int32)


def _share(patch: _Patch, above: _Patch, wanted: NDArray[np.bool_]) -> None:
    """Give the points that a level has in common with the one above it the same numbers."""
    rows, columns = np.nonzero(wanted)
    i, j = columns + patch.column, rows + patch.row
    even = (i % 2 == 0) & (j % 2 == 0)
    rows, columns = rows[even], columns[even]
    r, c = j[even] // 2 - above.row, i[even] // 2 - above.column
    known = (r >= 0) & (r < above.index.shape[0]) & (c >= 0) & (c < above.index.shape[1])
    patch.index[rows[known], columns[known]] = above.index[r[known], c[known]]


def chord_m(lat: Array, lon: Array, lat0: float, lon0: float) -> Array:
    """Straight distance through the earth [m]: a lower bound of every distance on it, and a metric."""
    p, l = np.radians(lat), np.radians(lon)  # noqa: E741
    p0, l0 = math.radians(lat0), math.radians(lon0)
    dx = np.cos(p) * np.cos(l) - math.cos(p0) * math.cos(l0)
    dy = np.cos(p) * np.sin(l) - math.cos(p0) * math.sin(l0)
    return np.asarray(EARTH_RADIUS * np.sqrt(dx**2 + dy**2 + (np.sin(p) - math.sin(p0)) ** 2))


def distance_to_line(x: Array, y: Array, line: Array) -> Array:
    """Distance of points of the plane to a line of straight legs ``(m, 2)`` [m of the plane]."""
    best = np.full(x.size, np.inf)
    for (ax, ay), (bx, by) in zip(line[:-1], line[1:], strict=True):
        dx, dy = bx - ax, by - ay
        square = dx * dx + dy * dy
        t = np.clip(((x - ax) * dx + (y - ay) * dy) / square, 0.0, 1.0) if square > 0 else 0.0
        np.minimum(best, np.hypot(x - ax - t * dx, y - ay - t * dy), out=best)
    return best
