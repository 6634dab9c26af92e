"""Land in square cells, so that painting a view touches only what is in it; plain arrays.

Cells are the quarters of quarters of a rectangle, the charted one or the world. Each holds its rings
clipped to itself and a margin; a painter that clips to the cell alone shows neither seams nor the edges
that clipping made.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF

from seacruise.desktop.chart.kept import Kept
from seacruise.desktop.chart.plane import CHARTED, WORLD, to_plane
from seacruise.sea.coast import chart_land, world_land

Points = NDArray[np.float64]

MARGIN: Final = 1.0 / 16.0
"""Overlap to each side, as a share of a cell."""

_MOST_POINTS: Final = 300_000
"""Points of all cells that are kept; each depth of quartering has those of the whole once more."""


@dataclass(frozen=True, slots=True, eq=False)
class Rings:
    """Closed rings one after another.

    Attributes
    ----------
    points
        ``(n, 2)`` in the plane [m]; ring k from ``starts[k]`` to ``starts[k + 1]``.
    weight
        ``(k,)`` width or height of the ring before any cutting, the larger [m]; a quarter of it for a
        lake, which matters less to a sailor: what to leave out at a zoom.
    """

    points: Points
    starts: NDArray[np.int64]
    weight: NDArray[np.float64]

    def __len__(self) -> int:
        return self.starts.size - 1

    def split(self, least_m: float = 0.0) -> list[Points]:
        """One array a ring, of those that weigh enough [m]."""
        kept = np.flatnonzero(self.weight >= least_m)
        return [self.points[a:b] for a, b in zip(self.starts[kept], self.starts[kept + 1], strict=True)]


def join_rings(rings: list[Points], *, lakes: list[bool]) -> Rings:
    """Put whole rings one after another."""
    starts = _starts(np.array([len(ring) for ring in rings], dtype=np.int64))
    points = np.concatenate(rings)
    high = np.maximum.reduceat(points, starts[:-1], axis=0)
    low = np.minimum.reduceat(points, starts[:-1], axis=0)
    return Rings(points, starts, (high - low).max(axis=1) * np.where(lakes, 0.25, 1.0))


def _starts(sizes: NDArray[np.int64]) -> NDArray[np.int64]:
    return np.concatenate((np.zeros(1, np.int64), np.cumsum(sizes)))


def _clip_half_plane(ring: Points, axis: int, limit: float, sign: float) -> Points:
    """Part of a ring with ``sign * coordinate >= sign * limit`` (Sutherland and Hodgman 1974)."""
    inside = sign * ring[:, axis] >= sign * limit
    if inside.all():
        return ring
    following = np.roll(ring, -1, axis=0)
    crosses = inside != np.roll(inside, -1)
    span = np.where(crosses, following[:, axis] - ring[:, axis], 1.0)
    cut = ring + ((limit - ring[:, axis]) / span)[:, None] * (following - ring)
    both = np.stack((ring, cut), axis=1)
    return np.asarray(both[np.stack((inside, crosses), axis=1)])


def clip_ring(ring: Points, box: tuple[float, float, float, float]) -> Points:
    """Part of a ring within a box ``(west, north, east, south)`` of the plane."""
    west, north, east, south = box
    for axis, limit, sign in ((0, west, 1.0), (0, east, -1.0), (1, north, 1.0), (1, south, -1.0)):
        if len(ring) == 0:
            break
        ring = _clip_half_plane(ring, axis, limit, sign)
    return ring


def clip_rings(rings: Rings, box: tuple[float, float, float, float]) -> Rings:
    """Parts of rings within a box; only those that cross its edge are touched one by one."""
    if len(rings) == 0:
        return rings
    west, north, east, south = box
    starts = rings.starts[:-1]
    low = np.minimum.reduceat(rings.points, starts, axis=0)
    high = np.maximum.reduceat(rings.points, starts, axis=0)
    meets = (high[:, 0] >= west) & (low[:, 0] <= east) & (high[:, 1] >= north) & (low[:, 1] <= south)
    within = (low[:, 0] >= west) & (high[:, 0] <= east) & (low[:, 1] >= north) & (high[:, 1] <= south)
    sizes = np.diff(rings.starts)
    kept_points = rings.points[np.repeat(within, sizes)]
    kept_sizes = sizes[within]
    cut, cut_weights = [], []
    for number in np.flatnonzero(meets & ~within):
        part = clip_ring(rings.points[rings.starts[number] : rings.starts[number + 1]], box)
        if len(part) > 2:
            cut.append(part)
            cut_weights.append(rings.weight[number])
    points = np.concatenate((kept_points, *cut))
    all_sizes = np.concatenate((kept_sizes, np.array([len(part) for part in cut], dtype=np.int64)))
    return Rings(points, _starts(all_sizes), np.concatenate((rings.weight[within], cut_weights)))


class LandCells:
    """Land of one level of detail, cut into cells when they are first asked for; one thread at a time.

    Parameters
    ----------
    level
        Of `seacruise.sea.coast.chart_land`; ``None`` for `seacruise.sea.coast.world_land`.
    """

    def __init__(self, level: int | None) -> None:
        self._level = level
        self.frame = WORLD if level is None else CHARTED
        self._cells: Kept[tuple[int, int, int], Rings] = Kept(_MOST_POINTS, lambda rings: len(rings.points))

    def _whole(self) -> Rings:
        polygons = world_land() if self._level is None else chart_land(self._level)
        lakes = [number > 0 for polygon in polygons for number in range(len(polygon))]
        degrees = [ring for polygon in polygons for ring in polygon]
        return join_rings([np.stack(to_plane(r[:, 1], r[:, 0]), axis=1) for r in degrees], lakes=lakes)

    def cell(self, depth: int, column: int, row: int) -> Rings:
        """Rings of a cell at a depth of quartering, its margin included."""
        key = (depth, column, row)
        if (known := self._cells.get(key)) is not None:
            return known
        if depth == 0:
            found = self._whole()
        else:
            box = _margined(depth, column, row, self.frame)
            found = clip_rings(self.cell(depth - 1, column // 2, row // 2), box)
        return self._cells.put(key, found)


def cell_box(depth: int, column: int, row: int, frame: QRectF = CHARTED) -> tuple[float, float, float, float]:
    """Box ``(west, north, east, south)`` of a cell in the plane [m], without its margin."""
    width, height = frame.width() / 2**depth, frame.height() / 2**depth
    west, north = frame.left() + column * width, frame.top() + row * height
    return west, north, west + width, north + height


def _margined(depth: int, column: int, row: int, frame: QRectF) -> tuple[float, float, float, float]:
    west, north, east, south = cell_box(depth, column, row, frame)
    dx, dy = MARGIN * (east - west), MARGIN * (south - north)
    return west - dx, north - dy, east + dx, south + dy
