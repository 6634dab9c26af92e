"""The chart's own plane: Mercator metres with y downwards, as screens count."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF

from seacruise.geodesy import from_mercator, to_mercator
from seacruise.sea.coast import FINE_EAST, FINE_NORTH, FINE_SOUTH, FINE_WEST

Array = NDArray[np.float64]


def to_plane(lat: Array, lon: Array) -> tuple[Array, Array]:
    """Points of the chart's plane [m] for positions [degrees]."""
    x, y = to_mercator(lat, lon)
    return x, -y


def point(lat: float, lon: float) -> QPointF:
    """Point of the chart's plane for a position [degrees]."""
    x, y = to_plane(np.asarray(lat), np.asarray(lon))
    return QPointF(float(x), float(y))


def position(place: QPointF) -> tuple[float, float]:
    """Latitude and longitude [degrees] of a point of the chart's plane."""
    lat, lon = from_mercator(place.x(), -place.y())
    return float(lat), float(lon)


def rectangle(south: float, west: float, north: float, east: float) -> QRectF:
    """Rectangle of the chart's plane between parallels and meridians [degrees]."""
    return QRectF(point(north, west), point(south, east))


CHARTED: Final = rectangle(FINE_SOUTH, FINE_WEST, FINE_NORTH, FINE_EAST)
"""What the fine coast of `seacruise.sea.coast` covers; beyond it the chart knows the coarse one only."""

WORLD: Final = rectangle(-64.0, -180.0, 82.0, 180.0)
"""What can be brought into view: the coarse coast, without the poles, which no Mercator chart has."""
