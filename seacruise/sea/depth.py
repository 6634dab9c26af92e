"""How deep the sea is, coarsely, for tinting the chart: ETOPO5, 5 arc-minutes (see ``NOTICE``).

Nine kilometres lie between its nodes: shoals, channels and rocks are not in it, and a bank of 10 m reads
38 m. So nothing here tells a depth; what is told is one of a few bands, and routing never asks.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.resources import resource_path
from seacruise.sea.coast import roughly_ashore

Array = NDArray[np.float64]

BAND_LIMITS_M: Final = (20.0, 50.0, 100.0, 200.0)
"""Where one tint ends and the next begins [m]."""

ALL_LAND_M: Final = -4.9
"""Smoothed depths below this [m] have no node at sea around them: the grid is cut off at 4 m above it."""


_NODES: Final = 4
"""So many nodes of an axis a place between them depends on."""


@dataclass(frozen=True, slots=True, eq=False)
class Depths:
    """Depths on a grid.

    Attributes
    ----------
    metres
        ``(lat, lon)``, the southernmost row first; positive below the sea [m].
    south, west, north, east
        Of the outermost nodes [degrees].
    """

    metres: Array
    south: float
    west: float
    north: float
    east: float

    def on(self, lat: Array, lon: Array) -> Array:
        """Smoothed depths [m] where parallels ``(n,)`` cross meridians ``(m,)`` [degrees]: ``(n, m)``.

        Cubic B-splines draw the bands' edges without corners. Beyond the grid its edge is held.
        """
        row, by_row = _around(lat, self.south, self.north, self.metres.shape[0])
        column, by_column = _around(lon, self.west, self.east, self.metres.shape[1])
        along = (self.metres[row] * by_row[:, :, None]).sum(axis=1)
        return np.asarray(sum(along[:, column[:, k]] * by_column[:, k] for k in range(_NODES)))

    def band(self, lat: float, lon: float) -> int | None:
        """Give the band of a position [degrees], 0 for the shallowest; ``None`` on land and off the grid."""
        if not (self.south <= lat <= self.north and self.west <= lon <= self.east):
            return None
        metres = float(self.on(np.array([lat]), np.array([lon]))[0, 0])
        if metres <= 0.0:
            return None
        return int(np.searchsorted(BAND_LIMITS_M, metres, side="right"))

    def ashore(self, lat: Array, lon: Array) -> NDArray[np.bool_]:
        """Tell which positions ``(n,)`` [degrees] are on land, to some kilometres: for drawing only."""
        row, by_row = _around(lat, self.south, self.north, self.metres.shape[0])
        column, by_column = _around(lon, self.west, self.east, self.metres.shape[1])
        nodes = self.metres[row[:, :, None], column[:, None, :]]
        ashore = (nodes * by_row[:, :, None] * by_column[:, None, :]).sum(axis=(1, 2)) <= 0.0
        beyond = (lat < self.south) | (lat > self.north) | (lon < self.west) | (lon > self.east)
        ashore[beyond] = roughly_ashore(lat[beyond], lon[beyond])
        return np.asarray(ashore)


def _around(at: Array, low: float, high: float, nodes: int) -> tuple[NDArray[np.int64], Array]:
    """Find the four nodes ``(n, 4)`` around some places of an axis, and their weights in a cubic B-spline.

    Weights for all nodes would make matrices of it: multiplied by several threads of NumPy's library, which
    then wait for more to do at a processor's full cost, beside the frames that asked.
    """
    place = np.clip((np.asarray(at) - low) / (high - low), 0.0, 1.0) * (nodes - 1)
    first = np.minimum(place.astype(np.int64), nodes - 2)
    t = place - first
    pieces = ((1 - t) ** 3, 3 * t**3 - 6 * t**2 + 4, -3 * t**3 + 3 * t**2 + 3 * t + 1, t**3)
    # At the edges the outer node counts for the one beyond.
    numbers = np.clip(first[:, None] + np.arange(-1, _NODES - 1), 0, nodes - 1)
    return numbers, np.stack(pieces, axis=1) / 6.0


@lru_cache(maxsize=1)
def chart_depths() -> Depths:
    """Depths of the Baltic that come with the program.

    Raises
    ------
    InputError
        The installation is incomplete.
    """
    with np.load(resource_path("assets/depth/etopo5.npz")) as data:
        steps = np.cumsum(data["steps"], axis=1, dtype=np.int64)
        south, west, north, east = (float(data[name]) for name in ("south", "west", "north", "east"))
        # A step's middle: no plain of the grid lies just on the edge of a band.
        metres = np.asarray(-float(data["metres"]) * (steps + 0.5), dtype=np.float64)
        return Depths(metres, south, west, north, east)
