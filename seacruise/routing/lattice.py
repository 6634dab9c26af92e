"""The lattice of the sea: in the Mercator plane, finer near the shore where that is asked.

Mercator keeps angles, so the courses of a stencil are the same compass courses everywhere, and each edge
is a rhumb line. It is triangular, or rectangular as R2 and R3 have it. Levels are nested: level s has half
the spacing of level s - 1 and contains its vertices, so a fine lattice near the shore is joined to the
coarse one by the vertices they share.
"""

from __future__ import annotations

import math
import os
from concurrent.futures import ThreadPoolExecutor
from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError
from seacruise.geodesy import from_mercator, scale, to_mercator
from seacruise.routing import axial
from seacruise.routing.area import NO_LEVELS, Area, Levels, chord_m, room_m
from seacruise.routing.network import CHECKED, Lattice
from seacruise.routing.stencil import TRIANGLES, Mesh
from seacruise.sea import Sea
from seacruise.units import METRES_PER_NM

__all__ = ["NO_LEVELS", "Area", "Lattice", "Levels", "build", "chord_m", "grid"]

Array = NDArray[np.float64]

MOST_VERTICES: Final = 2_500_000
MOST_EDGES: Final = 60_000_000
"""Finer lattices are refused: they would not fit in the memory of a small computer."""

SHORE_LEVEL: Final = 3

OFF_SHORE_M: Final = 10.0
"""Vertices keep about this far off a shoreline [m of the plane]; single precision knows it to 0.1 m."""

_JOINED: Final = 48
_CORES: Final = min(4, os.cpu_count() or 1)
_ALONE: Final = 50_000
_AT_ONCE: Final = 4_000_000
"""Edges that are not worth a second core, and those looked at in one go."""


def build(
    sea: Sea,
    start: tuple[float, float],
    end: tuple[float, float],
    *,
    spacing_nm: float,
    offsets: NDArray[np.int64],
    area: Area,
    mesh: Mesh = TRIANGLES,
    levels: Levels = NO_LEVELS,
    shore_offsets: NDArray[np.int64] | None = None,
    enter_from: int | None = None,
    joined: tuple[tuple[float, float], ...] = (),
    lazily: bool = False,
) -> Lattice:
    """Build the lattice between two positions [degrees].

    Parameters
    ----------
    spacing_nm
        Side of the coarsest triangles or squares [nm, true at the middle latitude].
    offsets, mesh
        Stencil and what it is laid on, see `seacruise.routing.stencil`.
    shore_offsets
        Stencil of the levels from `SHORE_LEVEL` on; the same by default. Narrow water leaves little choice of
        course, and what is left is relaxed later.
    enter_from
        R1's way: the start is the lattice's own first vertex, and only that many vertices nearest to the
        end lead into it. By default both ends are joined to every vertex near them that is in sight.
    joined
        Further positions [degrees] that become vertices, joined both ways to those in sight, to the start
        and to the end.
    lazily
        Leave the edges that lie in the area to be held against land by `seacruise.routing.search.search`,
        the only one that can.

    Raises
    ------
    InputError
        When the lattice would not fit in memory, or the safety zones are wider than the sea's raster tells.
    """
    (sx, ex), (sy, ey) = (c.tolist() for c in to_mercator([start[0], end[0]], [start[1], end[1]]))
    spacing = spacing_nm * METRES_PER_NM / float(scale(float(from_mercator(0.0, (sy + ey) / 2)[0])))
    grower = _Grower(sea, ((sx, sy), (ex, ey)), (sx, sy), spacing, mesh, lazily=lazily)
    grower.grow_all(offsets, shore_offsets, area, levels)
    jx, jy = to_mercator(*zip(*joined, strict=True)) if joined else (np.empty(0), np.empty(0))
    return grower.finish(enter_from, np.stack([jx, jy], axis=1))


def grid(
    sea: Sea,
    start: tuple[float, float],
    end: tuple[float, float],
    *,
    corners: tuple[float, float, float, float],
    shape: tuple[int, int],
    offsets: NDArray[np.int64],
    levels: Levels = NO_LEVELS,
) -> Lattice:
    """Lay rows and columns of points over a bounded area, as R2 and R3 do, and join both ends to them.

    Columns are evenly spaced in longitude and rows in the Mercator plane, so that every move is one true
    course everywhere; what course it is follows from the shape of the rectangles.

    Parameters
    ----------
    corners
        South, west, north, east [degrees].
    shape
        Rows and columns, 2 or more; the outermost lie on the borders of the area.
    offsets
        See `seacruise.routing.stencil.rectangular`.

    Raises
    ------
    InputError
        The area is empty, or as for `build`.
    """
    south, west, north, east = corners
    if not (-85.0 < south < north < 85.0 and west < east and min(shape) >= 2):
        raise InputError(
            "A grid needs south below north, west before east and two rows and columns at least."
        )
    (x0, x1), (y0, y1) = (c.tolist() for c in to_mercator([south, north], [west, east]))
    side, row = (x1 - x0) / (shape[1] - 1), (y1 - y0) / (shape[0] - 1)
    (sx, ex), (sy, ey) = (c.tolist() for c in to_mercator([start[0], end[0]], [start[1], end[1]]))
    grower = _Grower(sea, ((sx, sy), (ex, ey)), (x0, y0), side, Mesh(0.0, row / side))
    grower.grow_all(offsets, None, Area("box", np.array([[x0, y0, x1, y1]])), levels)
    return grower.finish(None, np.empty((0, 2)))


class _Grower:
    """Collects vertices and edges level by level, for `build` and `grid`.

    Positions are of the Mercator plane [m]: the two ends, and the origin of the lattice.
    """

    def __init__(
        self,
        sea: Sea,
        ends: tuple[tuple[float, float], tuple[float, float]],
        origin: tuple[float, float],
        spacing: float,
        mesh: Mesh,
        *,
        lazily: bool = False,
    ) -> None:
        self.sea, self.origin, self.spacing, self.mesh, self.lazily = sea, origin, spacing, mesh, lazily
        self.start, self.end = ends
        self.finest = spacing
        self.x: list[Array] = []
        self.y: list[Array] = []
        self.born: list[NDArray[np.int8]] = []
        self.count = 0
        self.a: list[NDArray[np.int32]] = []
        self.b: list[NDArray[np.int32]] = []

    def grow_all(
        self, offsets: NDArray[np.int64], shore: NDArray[np.int64] | None, area: Area, levels: Levels
    ) -> None:
        """Add the coarse lattice and all its levels."""
        self._check_radius(levels)
        whole = self._grow(None, 0, offsets, area, NO_LEVELS)
        for level in range(1, levels.deepest + 1):
            stencil_here = offsets if shore is None or level < SHORE_LEVEL else shore
            whole = self._grow(whole, level, stencil_here, area.at_level(level), levels)
        for way in levels.ways:
            patch = whole
            for level in range(levels.deepest + 1, levels.everywhere + levels.approaches + 1):
                around = Area("corridor", way, levels.sides * self.spacing / 2**level)
                patch = self._grow(patch, level, offsets, around, levels)

    def _check_radius(self, levels: Levels) -> None:
        """Refuse safety zones wider than the raster's cells can tell."""
        from seacruise.sea import _kernels as k

        water = self.sea.water
        north = max(abs(water.y0), abs(water.y0 + water.cells.shape[0] * water.cell))
        rings = int(np.iinfo(water.cells.dtype).max) - k.WATER
        known = rings * water.cell * float(scale(from_mercator(0.0, north)[0]))
        if levels.safety_levels and levels.safety_radius_m > known:
            raise InputError(
                f"A safety radius of {levels.safety_radius_m / METRES_PER_NM:g} nm is wider than the sea's "
                f"raster can tell; give up to {math.floor(known / METRES_PER_NM)} nm."
            )

    def _grow(
        self, above: axial.Patch | None, level: int, offsets: NDArray[np.int64], area: Area, levels: Levels
    ) -> axial.Patch:
        """Add the vertices of a level that are not there yet, and the edges of its stencil."""
        side = self.spacing / 2**level
        self.finest = min(self.finest, side)
        i, j = self._candidates(side, area, level, levels)
        x = self.origin[0] + side * (i + self.mesh.lean * j)
        y = self.origin[1] + side * self.mesh.rise * j
        wanted = self._wet(x, y)
        if area.kind != "corridor":
            wanted[wanted] = area.holds(x[wanted], y[wanted])
        i, j, x, y = i[wanted], j[wanted], x[wanted], y[wanted]
        numbers = axial.numbers_above(above, i, j)
        fresh = numbers < 0
        number = int(np.count_nonzero(fresh))
        if self.count + number > MOST_VERTICES or i.size * len(offsets) > MOST_EDGES:
            raise _too_fine()
        numbers[fresh] = np.arange(self.count, self.count + number, dtype=np.int32)
        self.x.append(x[fresh])
        self.y.append(y[fresh])
        self.born.append(np.full(number, level, dtype=np.int8))
        self.count += number
        patch = axial.Patch(axial.Index(i, j), numbers)
        self._join(patch, (i, j), self.sea.water.lines(x, y), offsets)
        return patch

    def _candidates(
        self, side: float, area: Area, level: int, levels: Levels
    ) -> tuple[axial.Whole, axial.Whole]:
        """Positions that may become vertices of a level, by row and column."""
        near = self._around_hazards(side, area, level, levels)
        all_water = (math.inf, 0.0)
        if level:
            room = (2.0 * side * self.mesh.longest, levels.radius_at(level))
        else:
            room = all_water
        if area.kind == "corridor":
            if not near[0].size:
                return self._along(area.lines, area.reach_m, side, room)
            i, j = self._along(area.lines, area.reach_m, side, all_water)
            kept = self._near_shore(i, j, side, levels.radius_at(level)) | (axial.Index(*near).at(i, j) >= 0)
            return i[kept], j[kept]
        from seacruise.routing import _points as k

        water, (low, high) = self.sea.water, area.bounds()
        fits, i, j = k.water_points(
            water.cells,
            (water.x0, water.y0, water.cell),
            self.mesh.pair,
            self.origin,
            side,
            (float(low[0]), float(low[1]), float(high[0]), float(high[1])),
            room,
            6 * MOST_VERTICES,
        )
        if not fits:
            raise _too_fine()
        if near[0].size:
            return axial.unique(np.concatenate([i, near[0]]), np.concatenate([j, near[1]]))
        return i, j

    def _along(
        self, lines: Array, reach: float, side: float, room: tuple[float, float]
    ) -> tuple[axial.Whole, axial.Whole]:
        """Positions on water within reach of lines, and within some room of a shore."""
        from seacruise.routing import _points as k

        water = self.sea.water
        upright = np.where((lines[:, 1] > lines[:, 3])[:, None], lines[:, [2, 3, 0, 1]], lines)
        fits, i, j = k.corridor_points(
            np.ascontiguousarray(upright[np.argsort(upright[:, 1], kind="stable")]),
            reach,
            water.cells,
            (water.x0, water.y0, water.cell),
            self.mesh.pair,
            self.origin,
            side,
            room,
            6 * MOST_VERTICES,
        )
        if not fits:
            raise _too_fine()
        return i, j

    def _around_hazards(
        self, side: float, area: Area, level: int, levels: Levels
    ) -> tuple[axial.Whole, axial.Whole]:
        """Positions within reach of the borders of hazards."""
        lines = levels.hazards_at(level)
        if not lines.size or not area.lines.size:
            return np.empty(0, np.int64), np.empty(0, np.int64)
        low, high = area.bounds()
        reach = float(
            room_m(levels.radius_at(level), side * self.mesh.longest, np.abs([low[1], high[1]])).max()
        )
        west, south = lines[:, [0, 2]].min(axis=1), lines[:, [1, 3]].min(axis=1)
        east, north = lines[:, [0, 2]].max(axis=1), lines[:, [1, 3]].max(axis=1)
        apart = (east < low[0] - reach) | (west > high[0] + reach)
        apart |= (north < low[1] - reach) | (south > high[1] + reach)
        return self._along(lines[~apart], reach, side, (math.inf, 0.0))

    def _wet(self, x: Array, y: Array) -> NDArray[np.bool_]:
        """Which points are water and not so near a shore that rounding could put them on land."""
        from seacruise.routing import _points as k

        water = self.sea.water
        return np.asarray(k.wet_points(water.arrays, *water.lines(x, y), OFF_SHORE_M / water.cell))

    def _near_shore(self, i: axial.Whole, j: axial.Whole, side: float, radius: float) -> NDArray[np.bool_]:
        """Which positions are within reach of a shore; see `_points.water_points`, which tells the same."""
        from seacruise.sea import _kernels as k

        x = np.asarray(self.origin[0] + side * (i + self.mesh.lean * j))
        y = np.asarray(self.origin[1] + side * self.mesh.rise * j)
        value = self.sea.water.at(x, y)
        rings = value.astype(np.float64) - k.WATER
        room = room_m(radius, side * self.mesh.longest, y)
        return np.asarray((value != k.LAND) & (rings * self.sea.water.cell < room))

    def _join(
        self,
        patch: axial.Patch,
        at: tuple[axial.Whole, axial.Whole],
        cells: tuple[Array, Array],
        offsets: NDArray[np.int64],
    ) -> None:
        """Add the edges that cross no land, both ways; half of the stencil finds them all."""
        from seacruise.routing import _points as k

        half, size = offsets[: len(offsets) // 2], at[0].size
        land = CHECKED[0] if self.lazily else self.sea.water.arrays
        # The kernel lets go of the interpreter: a lattice is checked on all cores.
        parts = min(len(half), max(_CORES if size * len(half) > _ALONE else 1, size * len(half) // _AT_ONCE))
        if not size or not parts:
            return

        def join(some: NDArray[np.int64]) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
            a, b = np.empty((2, size * len(some)), dtype=np.int32)
            count = k.join_points(patch.index.arrays, *at, *cells, some, land, a, b)
            return patch.numbers[a[:count]], patch.numbers[b[:count]]

        some = np.array_split(half, parts)
        for a, b in map(join, some) if parts == 1 else _workers().map(join, some):
            self.a.append(a)
            self.b.append(b)

    def finish(self, enter_from: int | None, joined: Array) -> Lattice:
        """Join both ends, and further positions ``(m, 2)`` of the plane, and pack the edges into rows."""
        from seacruise.routing import _rows as k

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
        source = [np.full(leaves.size, start, np.int32), enters]
        target = [leaves, np.full(enters.size, n - 1, np.int32)]
        if enter_from is None and bool(self.sea.clear(np.array([[*self.start, *self.end]]))[0]):
            source.append(np.array([start], np.int32))
            target.append(np.array([n - 1], np.int32))
        nothing = [np.empty(0, np.int32)]
        edges = (np.concatenate(nothing + some) for some in (self.a, self.b, source, target))
        first, to = k.pack_rows(*edges, n)
        lat, lon = from_mercator(x, y)
        water = self.sea.water
        unchecked = (water.arrays, water.x0, water.y0, water.cell) if self.lazily else CHECKED
        return Lattice(
            *(x, y, lat, lon, scale(lat), first, to, start, n - 1, self.spacing, tuple(further)),
            unchecked=unchecked,
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
        """Vertices that an end is joined to: of each level those nearest to it, or ``most`` of all.

        So a lattice that is refined has every edge of the one that is not.
        """
        away = np.hypot(x[:count] - x[end], y[:count] - y[end])
        if most is not None:
            near = np.argsort(away, kind="stable")[:most]
        else:
            born = np.concatenate(self.born)
            around = 4.2 * self.spacing * self.mesh.longest
            close = np.flatnonzero(away < around)
            near = np.empty(0, dtype=np.int64)
            for level in range(round(math.log2(self.spacing / self.finest)) + 1):
                ring = close[(away[close] < around / 2**level) & (born[close] <= level)]
                if level == 0 and ring.size < _JOINED:
                    ring = np.flatnonzero(born == 0)
                near = np.union1d(near, ring[np.argsort(away[ring], kind="stable")[:_JOINED]])
        near = near[away[near] > 1e-6]
        here = np.full(near.size, x[end]), np.full(near.size, y[end])
        free = self.sea.clear(np.stack([*here, x[near], y[near]], axis=1))
        return np.asarray(near[free], dtype=np.int32)


@lru_cache(maxsize=1)
def _workers() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(_CORES, thread_name_prefix="lattice")


def _too_fine() -> InputError:
    return InputError(
        f"A lattice of more than {MOST_VERTICES:,} vertices is too fine for this computer; choose a wider "
        "spacing or a shorter passage."
    )
