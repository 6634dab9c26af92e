"""The lattice of the sea: triangular, in the Mercator plane, finer near the shore where that is asked.

Mercator keeps angles, so the courses of a stencil are the same compass courses everywhere, and each edge
is a rhumb line. Levels are nested: level s has half the spacing of level s - 1 and contains its
vertices, so a fine lattice near the shore is joined to the coarse one by the vertices they share.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError
from seacruise.geodesy import EARTH_RADIUS, from_mercator, scale, to_mercator
from seacruise.routing import axial, stencil
from seacruise.sea import Sea
from seacruise.units import METRES_PER_NM

Array = NDArray[np.float64]

MOST_VERTICES: Final = 2_500_000
MOST_EDGES: Final = 60_000_000
"""Finer lattices are refused: they would not fit in the memory of a small computer."""

SHORE_LEVEL: Final = 3

_JOINED: Final = 48
_AT_ONCE: Final = 1_000_000


@dataclass(frozen=True, slots=True, eq=False)
class Area:
    """Where vertices may lie.

    Attributes
    ----------
    kind
        ``"ellipse"``: the sum of the distances to both ends is at most ``reach_m`` [m, true].
        ``"rectangle"``: at most ``reach_m`` [m of the plane] to each side of the direct line (R1).
        ``"corridor"``: at most ``reach_m`` [m of the plane] from a line, and half of that for each level.
    lines
        ``(n, 4)`` x0, y0, x1, y1 of the Mercator plane [m]: the direct line, or the lines to follow.
    """

    kind: Literal["ellipse", "rectangle", "corridor"]
    lines: Array
    reach_m: float

    def at_level(self, level: int) -> Area:
        """Give the part in which a level is refined."""
        return replace(self, reach_m=self.reach_m / 2**level) if self.kind == "corridor" else self


@dataclass(frozen=True, slots=True, eq=False)
class Levels:
    """How the lattice is refined towards the shore.

    Attributes
    ----------
    everywhere
        Levels by which the shore is refined in the whole area.
    approaches
        Further levels around ``ways``: the ways by which each end leads out of islands.
    ways
        For each end ``(n, 4)`` lines as in `Area`.
    sides
        How far around the ways, in sides of a level's triangles.
    """

    everywhere: int = 0
    approaches: int = 0
    ways: tuple[Array, ...] = ()
    sides: float = 3.0


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
    joined
        Vertices of the further positions that were joined to the lattice, in their order.
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
    joined: tuple[int, ...] = ()

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

    def edges_in_degrees(self) -> NDArray[np.float32]:
        """Edges ``(m, 4)`` as lat, lon, lat, lon [degrees], for drawing."""
        a, b = self.sources(), self.target
        return np.stack([self.lat[a], self.lon[a], self.lat[b], self.lon[b]], axis=1).astype(np.float32)

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
    shore_offsets: NDArray[np.int64] | None = None,
    enter_from: int | None = None,
    joined: tuple[tuple[float, float], ...] = (),
) -> Lattice:
    """Build the lattice between two positions [degrees].

    Parameters
    ----------
    spacing_nm
        Side of the coarsest triangles [nm, true at the middle latitude].
    offsets
        Stencil, see `seacruise.routing.stencil`.
    shore_offsets
        Stencil of the levels from `SHORE_LEVEL` on; the same by default. Narrow water leaves little choice of
        course, and what is left is relaxed later.
    enter_from
        R1's way: the start is the lattice's own first vertex, and only that many vertices nearest to the
        end lead into it. By default both ends are joined to every vertex near them that is in sight.
    joined
        Further positions [degrees] that become vertices, joined both ways to those in sight, to the start
        and to the end.

    Raises
    ------
    InputError
        When the lattice would not fit in memory.
    """
    (sx, ex), (sy, ey) = (c.tolist() for c in to_mercator([start[0], end[0]], [start[1], end[1]]))
    middle = float(from_mercator(0.0, (sy + ey) / 2)[0])
    spacing = spacing_nm * METRES_PER_NM / float(scale(middle))
    grower = _Grower(sea, (sx, sy), (ex, ey), spacing)
    whole = grower.grow(None, 0, offsets, area)
    for level in range(1, levels.everywhere + 1):
        stencil_here = offsets if shore_offsets is None or level < SHORE_LEVEL else shore_offsets
        whole = grower.grow(whole, level, stencil_here, area.at_level(level))
    for way in levels.ways:
        patch = whole
        for level in range(levels.everywhere + 1, levels.everywhere + levels.approaches + 1):
            around = Area("corridor", way, levels.sides * spacing / 2**level)
            patch = grower.grow(patch, level, offsets, around)
    jx, jy = to_mercator(*zip(*joined, strict=True)) if joined else (np.empty(0), np.empty(0))
    return grower.finish(enter_from, np.stack([jx, jy], axis=1))


@dataclass(frozen=True, slots=True, eq=False)
class _Patch:
    """Vertices of one level: where they lie on the lattice, and their numbers."""

    index: axial.Index
    numbers: NDArray[np.int32]


class _Grower:
    """Collects vertices and edges level by level; `build` is its only user."""

    def __init__(
        self, sea: Sea, start: tuple[float, float], end: tuple[float, float], spacing: float
    ) -> None:
        self.sea, self.start, self.end, self.spacing = sea, start, end, spacing
        self.finest = spacing
        self.x: list[Array] = []
        self.y: list[Array] = []
        self.count = 0
        self.a: list[NDArray[np.int32]] = []
        self.b: list[NDArray[np.int32]] = []

    def grow(self, above: _Patch | None, level: int, offsets: NDArray[np.int64], area: Area) -> _Patch:
        """Add the vertices of a level that are not there yet, and the edges of its stencil."""
        side = self.spacing / 2**level
        self.finest = min(self.finest, side)
        i, j = self._candidates(side, area)
        x = self.start[0] + side * (i + j / 2.0)
        y = self.start[1] + side * stencil.ROW_HEIGHT * j
        wanted = self._wet(x, y, side if level else None)
        if area.kind == "ellipse":
            wanted[wanted] = _inside_ellipse(area, x[wanted], y[wanted])
        elif area.kind == "rectangle":
            wanted[wanted] = _inside_rectangle(area, x[wanted], y[wanted])
        i, j, x, y = i[wanted], j[wanted], x[wanted], y[wanted]
        numbers = _shared_numbers(above, i, j)
        fresh = numbers < 0
        number = int(np.count_nonzero(fresh))
        if self.count + number > MOST_VERTICES or i.size * len(offsets) > MOST_EDGES:
            raise _too_fine()
        numbers[fresh] = np.arange(self.count, self.count + number, dtype=np.int32)
        self.x.append(x[fresh])
        self.y.append(y[fresh])
        self.count += number
        patch = _Patch(axial.Index(i, j), numbers)
        self._join(patch, i, j, offsets)
        return patch

    def _candidates(self, side: float, area: Area) -> tuple[axial.Whole, axial.Whole]:
        """Axial positions that may become vertices, by row and column."""
        from seacruise.routing import _kernels as k

        if area.kind == "corridor":
            return axial.unique(*k.corridor_points(area.lines, area.reach_m, side, *self.start))
        ends, reach = area.lines.reshape(-1, 2), area.reach_m
        if area.kind == "ellipse":
            flat = float(scale(from_mercator(0.0, np.abs(ends[:, 1]).max())[0])) * 0.95
            length, total = float(np.hypot(*(ends[-1] - ends[0]))), area.reach_m / flat
            reach = max((total - length) / 2, math.sqrt(max(0.0, total**2 - length**2)) / 2)
        water = self.sea.water
        corner = np.array([water.x0, water.y0])
        extent = np.array(water.cells.shape[::-1]) * water.cell
        low = (np.maximum(ends.min(axis=0) - reach, corner) - self.start) / side
        high = (np.minimum(ends.max(axis=0) + reach, corner + extent) - self.start) / side
        j0, j1 = math.floor(low[1] / stencil.ROW_HEIGHT), math.ceil(high[1] / stencil.ROW_HEIGHT)
        i0, i1 = math.floor(low[0] - j1 / 2), math.ceil(high[0] - j0 / 2)
        if (j1 - j0 + 1) * (i1 - i0 + 1) > 6 * MOST_VERTICES:
            raise _too_fine()
        j, i = np.mgrid[j0 : j1 + 1, i0 : i1 + 1]
        # The axial rectangle leans: its corners lie far outside the upright one that is wanted.
        x = i + j / 2.0
        upright = (x >= low[0]) & (x <= high[0])
        return i[upright], j[upright]

    def _wet(self, x: Array, y: Array, refined: float | None) -> NDArray[np.bool_]:
        """Which points are water; for a refined level of that spacing, within two sides of the shore."""
        from seacruise.sea import _kernels as k

        value = self.sea.water.at(x, y)
        wanted = value >= k.WATER
        shore = np.flatnonzero((value == k.SHORE) | (value == k.SHORE_WATER))
        wanted[shore] = self.sea.is_water_at(x[shore], y[shore])
        if refined is not None:
            wanted &= (value.astype(np.float64) - k.WATER) * self.sea.water.cell < 2.0 * refined
        return np.asarray(wanted)

    def _join(self, patch: _Patch, i: axial.Whole, j: axial.Whole, offsets: NDArray[np.int64]) -> None:
        """Add the edges that cross no land, both ways; half of the stencil finds them all."""
        xs, ys = np.concatenate(self.x), np.concatenate(self.y)
        half = offsets[: len(offsets) // 2]
        at_once = max(1, _AT_ONCE // max(1, i.size))
        for k in range(0, len(half), at_once):
            some = half[k : k + at_once]
            place = patch.index.at((i + some[:, :1]).ravel(), (j + some[:, 1:]).ravel())
            both = np.flatnonzero(place >= 0)
            a, b = patch.numbers[both % i.size], patch.numbers[place[both]]
            free = self.sea.clear(np.stack([xs[a], ys[a], xs[b], ys[b]], axis=1))
            self.a.append(a[free])
            self.b.append(b[free])

    def finish(self, enter_from: int | None, joined: Array) -> Lattice:
        """Join both ends, and further positions ``(m, 2)`` of the plane, and pack the edges into rows."""
        from seacruise.routing import _kernels as k

        ends = [self.start, self.end] if enter_from is None else [self.end]
        x = np.concatenate([*self.x, joined[:, 0], [end[0] for end in ends]])
        y = np.concatenate([*self.y, joined[:, 1], [end[1] for end in ends]])
        n, count = x.size, x.size - len(ends) - len(joined)
        further = range(count, count + len(joined))
        for number in further:
            near = self._in_sight(x, y, number, count)
            self.a.append(np.full(near.size, number, np.int32))
            self.b.append(near)
        if enter_from is None:
            start = n - 2
            leaves, enters = (
                np.concatenate([self._in_sight(x, y, end, count), self._seen(x, y, end, further)])
                for end in (n - 2, n - 1)
            )
        else:
            start = int(np.argmin(np.hypot(x[:count] - self.start[0], y[:count] - self.start[1])))
            leaves, enters = np.empty(0, np.int32), self._in_sight(x, y, n - 1, count, most=enter_from)
        a = [*self.a, *self.b, np.full(leaves.size, start, np.int32), enters]
        b = [*self.b, *self.a, leaves, np.full(enters.size, n - 1, np.int32)]
        if enter_from is None and bool(self.sea.clear(np.array([[*self.start, *self.end]]))[0]):
            a.append(np.array([start], np.int32))
            b.append(np.array([n - 1], np.int32))
        source, target = np.concatenate(a), np.concatenate(b)
        first, order = k.sort_rows(source, n)
        lat, lon = from_mercator(x, y)
        return Lattice(
            x, y, lat, lon, scale(lat), first, target[order], start, n - 1, self.spacing, tuple(further)
        )

    def _seen(self, x: Array, y: Array, end: int, further: range) -> NDArray[np.int32]:
        """Those of the further positions to which a straight line leads from an end."""
        numbers = np.array(further, dtype=np.int32)
        numbers = numbers[np.hypot(x[numbers] - x[end], y[numbers] - y[end]) > 1e-6]
        here = np.full(numbers.size, x[end]), np.full(numbers.size, y[end])
        return np.asarray(numbers[self.sea.clear(np.stack([*here, x[numbers], y[numbers]], axis=1))])

    def _in_sight(
        self, x: Array, y: Array, end: int, count: int, *, most: int | None = None
    ) -> NDArray[np.int32]:
        """Vertices that an end is joined to: those within two sides of its triangles, level by level."""
        away = np.hypot(x[:count] - x[end], y[:count] - y[end])
        nearest = np.flatnonzero(away < 2.1 * self.spacing)
        if nearest.size < max(_JOINED, most or 0):
            nearest = np.arange(count)
        nearest = nearest[np.argsort(away[nearest], kind="stable")]
        if most is not None:
            near = nearest[:most]
        else:
            near = nearest[:_JOINED]
            for level in range(round(math.log2(self.spacing / self.finest)) + 1):
                ring = np.flatnonzero(away < 2.1 * self.spacing / 2**level)
                # Of a crowded ring the outer ones: the inner ones belong to the next level.
                near = np.union1d(near, ring[np.argsort(-away[ring], kind="stable")[:_JOINED]])
        near = near[away[near] > 1e-6]
        here = np.full(near.size, x[end]), np.full(near.size, y[end])
        free = self.sea.clear(np.stack([*here, x[near], y[near]], axis=1))
        return np.asarray(near[free], dtype=np.int32)


def _too_fine() -> InputError:
    return InputError(
        f"A lattice of more than {MOST_VERTICES:,} vertices is too fine for this computer; choose a wider "
        "spacing or a shorter passage."
    )


def _inside_ellipse(area: Area, x: Array, y: Array) -> NDArray[np.bool_]:
    total = np.zeros(x.size)
    lat, lon = from_mercator(x, y)
    for point in (area.lines[0, :2], area.lines[0, 2:]):
        total += chord_m(lat, lon, *(float(c) for c in from_mercator(*point)))
    return np.asarray(total <= area.reach_m)


def _inside_rectangle(area: Area, x: Array, y: Array) -> NDArray[np.bool_]:
    x0, y0, x1, y1 = area.lines[0]
    length = math.hypot(x1 - x0, y1 - y0)
    ux, uy = (x1 - x0) / length, (y1 - y0) / length
    along, across = (x - x0) * ux + (y - y0) * uy, (x - x0) * uy - (y - y0) * ux
    return np.asarray((np.abs(across) <= area.reach_m) & (along >= -1.0) & (along <= length + 1.0))


def _shared_numbers(above: _Patch | None, i: axial.Whole, j: axial.Whole) -> NDArray[np.int32]:
    """Numbers of the points that a level has in common with the one above it, -1 for all others."""
    numbers = np.full(i.size, -1, dtype=np.int32)
    if above is not None and above.numbers.size:
        even = np.flatnonzero((i % 2 == 0) & (j % 2 == 0))
        place = above.index.at(i[even] // 2, j[even] // 2)
        numbers[even[place >= 0]] = above.numbers[place[place >= 0]]
    return numbers


def chord_m(lat: Array, lon: Array, lat0: float, lon0: float) -> Array:
    """Straight distance through the earth [m]: a lower bound of every distance on it, and a metric."""
    p, l = np.radians(lat), np.radians(lon)  # noqa: E741
    p0, l0 = math.radians(lat0), math.radians(lon0)
    dx = np.cos(p) * np.cos(l) - math.cos(p0) * math.cos(l0)
    dy = np.cos(p) * np.sin(l) - math.cos(p0) * math.sin(l0)
    return np.asarray(EARTH_RADIUS * np.sqrt(dx**2 + dy**2 + (np.sin(p) - math.sin(p0)) ** 2))
