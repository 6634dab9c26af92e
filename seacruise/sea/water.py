"""The sea of a passage: where there is water, how far the shore is, and whether a line crosses land."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import NoPassageError
from seacruise.geodesy import format_position, from_mercator, great_circle_m, scale, to_mercator
from seacruise.sea import coast, raster
from seacruise.units import METRES_PER_NM

FARTHEST_SNAP_NM: Final = 40.0
"""A port farther than this from open water is refused [nm]; Szczecin, up the Odra, is the farthest."""

FARTHEST_WAY_NM: Final = 45.0
"""Ways out of an archipelago are followed this far from the port [nm]."""

APPROACH_NM: Final = 1.0
"""Where a distance from the shore is kept, this much room is left beside the ways out of a port [nm]."""

NOT_MUCH_LONGER: Final = 1.3
"""Ways out that are longer than the shortest one by more than this factor do not count there."""

SECTORS: Final = 8

_STEPS_AT_ONCE: Final = 32

_POND: Final = 16
_AIM: Final = 255
"""Side of a body of water too small to be looked for [cells], and the mark of cells that ways lead to."""

_LINES_A_CORE: Final = 20_000
_CORES: Final = min(4, os.cpu_count() or 1)

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Snap:
    """Water nearest to a position: where it is [degrees] and how far [nm]."""

    lat: float
    lon: float
    distance_nm: float


@dataclass(frozen=True, slots=True, eq=False)
class Sea:
    """Water of a rectangle of the earth; `Sea.around` makes one.

    Lines are rhumb lines, given as ``(n, 4)`` x0, y0, x1, y1 in the Mercator plane [m].
    """

    water: raster.WaterRaster

    @classmethod
    def around(cls, lats: Any, lons: Any, *, margin_deg: float, cache_dir: Path) -> Sea:
        """Read the sea around positions [degrees], with a margin on each side.

        All of the Baltic is one raster, made once and shared by all its passages; elsewhere the raster
        is as large as the passage needs.
        """
        south, north = float(np.min(lats)) - margin_deg, float(np.max(lats)) + margin_deg
        wider = margin_deg / float(scale(min(80.0, max(abs(south), abs(north)))))
        west, east = float(np.min(lons)) - wider, float(np.max(lons)) + wider
        ends_inside = (
            np.min(lats) >= coast.FINE_SOUTH
            and np.max(lats) <= coast.FINE_NORTH
            and np.min(lons) >= coast.FINE_WEST
            and np.max(lons) <= coast.FINE_EAST
        )
        if ends_inside:
            bounds = (coast.FINE_SOUTH, coast.FINE_WEST, coast.FINE_NORTH, coast.FINE_EAST)
        else:
            bounds = (max(-80.0, south), west, min(80.0, north), east)
        return cls(_load(bounds, cache_dir))

    def is_water(self, lat: Any, lon: Any) -> NDArray[np.bool_]:
        """Tell where positions [degrees] lie on water that is connected with the open sea."""
        return self.is_water_at(*to_mercator(lat, lon))

    def is_water_at(self, x: Array, y: Array) -> NDArray[np.bool_]:
        """`is_water` for points of the Mercator plane [m], any shape."""
        from seacruise.sea import _kernels as k

        wet = np.empty(np.broadcast(x, y).shape, dtype=bool)
        column, row = (np.broadcast_to(c, wet.shape).ravel() for c in self.water.lines(x, y))
        k.wet_many(self.water.arrays, column, row, wet.reshape(-1))
        return wet

    def clearance_m(self, lat: Any, lon: Any) -> Array:
        """Distance to the nearest shore that is certain to be free [m, true]; 0 on land and at shores."""
        from seacruise.sea import _kernels as k

        rings = self.water.at(*to_mercator(lat, lon)).astype(np.float64) - k.WATER
        return np.asarray(np.maximum(rings, 0.0) * self.water.cell * scale(lat))

    def clear(self, lines: Array) -> NDArray[np.bool_]:
        """Tell which lines cross no land.

        The raster answers where it is sure; where a line passes cells with a shoreline in them it is
        held against the shoreline itself.
        """
        from seacruise.sea import _kernels as k

        flat = np.asarray(lines, dtype=np.float64).reshape(-1, 4)
        x0, y0 = self.water.lines(flat[:, 0], flat[:, 1])
        x1, y1 = self.water.lines(flat[:, 2], flat[:, 3])
        free = np.empty(len(flat), dtype=bool)
        cuts = np.linspace(0, len(flat), 1 + min(_CORES, 1 + len(flat) // _LINES_A_CORE)).astype(int)
        parts = [np.s_[a:b] for a, b in pairwise(cuts.tolist())]
        if len(parts) == 1:
            k.free_lines(self.water.arrays, x0, y0, x1, y1, free)
        else:
            # The kernel lets go of the interpreter: a lattice is checked on all cores.
            checks = [
                _workers().submit(k.free_lines, self.water.arrays, x0[p], y0[p], x1[p], y1[p], free[p])
                for p in parts
            ]
            for check in checks:
                check.result()
        return free

    def touches_land(self, lat: Array, lon: Array) -> NDArray[np.bool_]:
        """Tell which steps of a finely sampled track ``(n,)`` [degrees] touch land: ``(n - 1,)``.

        The last check of a passage. It shares nothing with `clear`: where there is a fine coast its
        polygons and a search tree are asked, elsewhere the cells of the global mask under each sample.
        """
        fine = coast.covers(lat, lon)
        dry = ~fine & (self.water.at(*to_mercator(lat, lon)) == 0)
        touched = dry[:-1] | dry[1:]
        # Most of a track is far from land: only the parts that touch it are looked at step by step.
        track = np.stack([lon, lat], axis=1)
        parts = np.minimum(
            np.arange(0, len(track) - 1, _STEPS_AT_ONCE)[:, None] + np.arange(_STEPS_AT_ONCE + 1),
            len(track) - 1,
        )
        steps = parts[coast.land_on_lines(track[parts])][:, :-1].ravel()
        steps = np.unique(steps[steps < touched.size])
        touched[steps] |= coast.land_on_lines(np.stack([track[steps], track[steps + 1]], axis=1))
        return np.asarray(touched)

    def snap(self, lat: float, lon: float, *, name: str = "") -> Snap:
        """Water nearest to a port: connected with the open sea, and not itself in a cell with a shore.

        Raises
        ------
        NoPassageError
            Reason ``no-water-path`` when there is none within `FARTHEST_SNAP_NM`.
        """
        # Most harbours have water within a mile or two: the whole window takes 20 ms to look at.
        found = self._nearest_water(lat, lon, FARTHEST_SNAP_NM / 16)
        found = found or self._nearest_water(lat, lon, FARTHEST_SNAP_NM)
        if found is None:
            raise NoPassageError(
                f"{name or format_position(lat, lon)} has no water connected with the open sea within "
                f"{FARTHEST_SNAP_NM:.0f} nm; choose a port on the coast or a position at sea.",
                reason="no-water-path",
                place=(lat, lon),
            )
        return found

    def _nearest_water(self, lat: float, lon: float, within_nm: float) -> Snap | None:
        """Nearest cell of water in a square around a position, if no nearer one can lie outside it."""
        from seacruise.sea import _kernels as k

        cell, cells = self.water.cell, self.water.cells
        x, y = (float(c) for c in to_mercator(lat, lon))
        reach = math.ceil(within_nm * METRES_PER_NM / float(scale(lat)) / cell)
        column, row = (math.floor(float(c)) for c in self.water.lines(np.array(x), np.array(y)))
        r0, c0 = max(0, row - reach), max(0, column - reach)
        window = cells[r0 : max(0, row + reach + 1), c0 : max(0, column + reach + 1)]
        rows, columns = np.nonzero(window >= k.WATER)
        if rows.size == 0:
            return None
        px = self.water.x0 + (columns + c0 + 0.5) * cell
        py = self.water.y0 + (rows + r0 + 0.5) * cell
        away = (px - x) ** 2 + (py - y) ** 2
        best = int(np.argmin(away))
        if away[best] > (reach * cell) ** 2:
            return None
        if cells[row, column] >= k.WATER:
            return Snap(lat, lon, 0.0)
        found_lat, found_lon = (float(c) for c in from_mercator(px[best], py[best]))
        return Snap(
            found_lat, found_lon, float(great_circle_m(lat, lon, found_lat, found_lon)) / METRES_PER_NM
        )

    def keeping_off(self, distance_m: float, ports: Sequence[tuple[float, float]]) -> Sea:
        """Give the same sea with all water nearer to a shore than this taken for land.

        Parameters
        ----------
        distance_m
            True distance [m]; measured by the cells of the raster, so kept to a cell's width.
        ports
            Positions [degrees]; on the shortest ways of each to water that is far enough from the shore, and
            within `APPROACH_NM` of these, every water stays water.
        """
        return _kept_off(self.water, round(distance_m), tuple(ports))

    def ways_out(self, lat: float, lon: float, *, room_m: float) -> Array:
        """Ways by water from a position to open water, one for each sector of the compass that has one.

        Parameters
        ----------
        room_m
            Free water wanted on all sides for it to be open [m of the plane].

        Returns
        -------
        numpy.ndarray
            ``(n, 4)`` short lines x0, y0, x1, y1 of the Mercator plane [m]. They follow cells of the
            raster, not courses: they tell where a lattice must be fine.
        """
        from seacruise.sea import _kernels as k

        x, y = to_mercator(lat, lon)
        column, row = (math.floor(float(c)) for c in self.water.lines(x, y))
        most = math.ceil(FARTHEST_WAY_NM * METRES_PER_NM / float(scale(lat)) / self.water.cell)
        rings = math.ceil(room_m / self.water.cell)
        rows, columns, lengths = k.ways_out(self.water.cells, row, column, rings, most, SECTORS)
        lines = []
        for way in np.split(np.arange(rows.size), np.cumsum(lengths))[:-1]:
            if way.size:
                corners = way[np.unique(np.append(np.arange(0, way.size, 4), way.size - 1))]
                px = self.water.x0 + (columns[corners] + 0.5) * self.water.cell
                py = self.water.y0 + (rows[corners] + 0.5) * self.water.cell
                lines.append(np.stack([px[:-1], py[:-1], px[1:], py[1:]], axis=1))
        found = np.concatenate(lines) if lines else np.empty((0, 4))
        return np.unique(found, axis=0)


@lru_cache(maxsize=1)
def _workers() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(_CORES, thread_name_prefix="sea")


@lru_cache(maxsize=2)
def _kept_off(water: raster.WaterRaster, distance_m: int, ports: tuple[tuple[float, float], ...]) -> Sea:
    from seacruise.sea import _kernels as k

    latitudes, _ = from_mercator(0.0, water.y0 + (np.arange(water.cells.shape[0]) + 0.5) * water.cell)
    rings = np.ceil(distance_m / (water.cell * scale(latitudes)))[:, None]
    cells = np.where(water.cells < k.WATER + rings, k.LAND, k.WATER).astype(np.uint8)
    for (lat, _), (rows, columns) in zip(ports, _shortest_ways(water, cells, ports), strict=True):
        reach = math.ceil(APPROACH_NM * METRES_PER_NM / float(scale(lat)) / water.cell)
        for row, column in zip(rows.tolist(), columns.tolist(), strict=True):
            window = np.s_[
                max(0, row - reach) : max(0, row + reach + 1),
                max(0, column - reach) : max(0, column + reach + 1),
            ]
            cells[window] = np.minimum(water.cells[window], k.WATER)
    k.count_free_cells(cells)
    cells.setflags(write=False)
    return Sea(replace(water, cells=cells))


def _shortest_ways(
    water: raster.WaterRaster, open_water: NDArray[np.uint8], ports: Sequence[tuple[float, float]]
) -> list[tuple[NDArray[np.int64], NDArray[np.int64]]]:
    """Rows and columns of the cells by which ports lead to the nearest body of open water they all reach.

    The shortest way of each, and those to other sides that are hardly longer: one along the coast would be an
    excuse to keep no distance at all. Ponds of open water behind narrows are no aim unless all reach them;
    ways lead on through them.
    """
    from seacruise.sea import _kernels as k

    at = [tuple(math.floor(float(c)) for c in water.lines(*to_mercator(*port))) for port in ports]
    far = [math.ceil(FARTHEST_WAY_NM * METRES_PER_NM / float(scale(lat)) / water.cell) for lat, _ in ports]
    bodies = k.name_bodies(open_water.copy(), _POND, np.empty(open_water.size // 4 + 1024, dtype=np.int64))

    def around(here: tuple[int, ...], most: int) -> tuple[int, int, Any]:
        first, left = max(0, here[1] - most), max(0, here[0] - most)
        return first, left, np.s_[first : here[1] + most + 1, left : here[0] + most + 1]

    def way(here: tuple[int, ...], most: int, body: int) -> tuple[int, NDArray[np.int64], NDArray[np.int64]]:
        first, left, window = around(here, most)
        aim = np.where(bodies[window] == body, _AIM, np.minimum(water.cells[window], k.WATER))
        rows, columns, lengths = k.ways_out(
            aim.astype(np.uint8), here[1] - first, here[0] - left, _AIM - k.WATER, most, SECTORS
        )
        # No way is as long as all cells of the window, which stands for none.
        shortest = int(lengths[lengths > 0].min(initial=aim.size))
        kept = np.repeat(lengths <= NOT_MUCH_LONGER * shortest, lengths)
        return shortest, rows[kept].astype(np.int64) + first, columns[kept].astype(np.int64) + left

    near = [set(np.unique(bodies[around(*place)[2]]).tolist()) for place in zip(at, far, strict=True)]
    common = sorted(set.intersection(*near) - {k.LAND, k.WATER}) if near else []
    found = [[way(*place, body) for place in zip(at, far, strict=True)] for body in common]
    met = [ways for ways in found if all(rows.size for _, rows, _ in ways)]
    if not met:
        # With no open water to meet in there is no way; the ports themselves are water all the same.
        return [(np.array([row]), np.array([column])) for column, row in at]
    nearest = min(met, key=lambda ways: sum(shortest for shortest, _, _ in ways))
    return [(rows, columns) for _, rows, columns in nearest]


@lru_cache(maxsize=4)
def _load(bounds: tuple[float, float, float, float], cache_dir: Path) -> raster.WaterRaster:
    return raster.load(*bounds, cache_dir=cache_dir)
