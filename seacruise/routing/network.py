"""What a search runs on: vertices, and edges as compressed sparse rows."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

Unchecked = tuple[tuple[NDArray[np.uint8], NDArray[np.int64], NDArray[np.float32]], float, float, float]


def _nothing() -> Unchecked:
    empty = (np.empty((0, 0), np.uint8), np.empty(0, np.int64), np.empty((0, 4), np.float32))
    for array in empty:
        # As those of the sea: kernels are compiled for arrays that cannot be written.
        array.setflags(write=False)
    return empty, 0.0, 0.0, 1.0


CHECKED: Final = _nothing()
"""No raster: all edges have been held against land."""


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
        Side of the coarsest triangles, or distance of the coarsest columns [m of the plane].
    joined
        Vertices of the further positions that were joined to the lattice, in their order.
    unchecked
        Raster of the sea, its corner and its cell, where edges are still to be held against land: the search
        looks at those that would be somebody's fastest way, which are few.
    points
        ``(n, 4)`` x, y, lat, scale of each vertex side by side, as the kernels read them.
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
    unchecked: Unchecked = CHECKED
    points: Array = field(init=False, repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "points", np.stack([self.x, self.y, self.lat, self.scale], axis=1))

    @property
    def edges(self) -> tuple[NDArray[np.int64], NDArray[np.int32]]:
        """What the kernels call ``edges``."""
        return self.first, self.target

    @property
    def vertices(self) -> int:
        """Number of vertices."""
        return int(self.x.size)

    @property
    def nbytes(self) -> int:
        """Memory that its arrays take [bytes]."""
        arrays = (self.x, self.y, self.lat, self.lon, self.scale, self.first, self.target, self.points)
        return sum(array.nbytes for array in arrays)

    def edges_in_degrees(self) -> NDArray[np.float32]:
        """Edges ``(m, 4)`` as lat, lon, lat, lon [degrees], for drawing."""
        return _edges_in_degrees(self)

    def sources(self) -> NDArray[np.int32]:
        """Source vertex of each edge, ``(m,)``."""
        return np.repeat(np.arange(self.vertices, dtype=np.int32), np.diff(self.first))


@lru_cache(maxsize=1)
def _edges_in_degrees(lattice: Lattice) -> NDArray[np.float32]:
    """Put edges together once: every passage on a lattice shows the same ones."""
    place = np.stack([lattice.lat, lattice.lon], axis=1).astype(np.float32)
    return np.hstack([place[lattice.sources()], place[lattice.target]])
