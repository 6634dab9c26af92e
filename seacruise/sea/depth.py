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
        rows = _weights(lat, self.south, self.north, self.metres.shape[0])
        columns = _weights(lon, self.west, self.east, self.metres.shape[1])
        return np.asarray(rows @ self.metres @ columns.T)

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
        rows = _weights(lat, self.south, self.north, self.metres.shape[0])
        columns = _weights(lon, self.west, self.east, self.metres.shape[1])
        within = (lat >= self.south) & (lat <= self.north) & (lon >= self.west) & (lon <= self.east)
        high = ((rows @ self.metres) * columns).sum(axis=1) <= 0.0
        return np.where(within, high, roughly_ashore(lat, lon))


def _weights(at: Array, low: float, high: float, nodes: int) -> Array:
    """Weights ``(n, nodes)`` of a uniform cubic B-spline at some places of an axis."""
    place = np.clip((np.asarray(at) - low) / (high - low), 0.0, 1.0) * (nodes - 1)
    first = np.minimum(place.astype(np.int64), nodes - 2)
    t = place - first
    weights = np.zeros((place.size, nodes))
    number = np.arange(place.size)
    pieces = ((1 - t) ** 3, 3 * t**3 - 6 * t**2 + 4, -3 * t**3 + 3 * t**2 + 3 * t + 1, t**3)
    for shift, piece in enumerate(pieces, start=-1):
        # At the edges the outer node counts for the one beyond.
        np.add.at(weights, (number, np.clip(first + shift, 0, nodes - 1)), piece / 6.0)
    return weights


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
