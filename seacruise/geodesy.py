"""The sphere and its Mercator plane: where courses are straight lines.

The earth is a sphere of the mean radius here. Against the ellipsoid that is wrong by at most 0.3 % of a
distance at Baltic latitudes, which is less than a boat's log shows; what it buys is that a rhumb line is
exactly a straight line in the plane in which lattice, coast and legs live.

Mercator plane: ``x = R * lon``, ``y = R * asinh(tan lat)`` [m]; true lengths are plane lengths times
``cos(lat)``.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

EARTH_RADIUS: Final = 6_371_008.8
"""Mean radius R1 of the earth [m] (Moritz, Geodetic Reference System 1980)."""

Array = NDArray[np.float64]
ArrayLike = Any


def to_mercator(lat: ArrayLike, lon: ArrayLike) -> tuple[Array, Array]:
    """Project positions [degrees] to the Mercator plane [m]; returns ``x, y``."""
    x = EARTH_RADIUS * np.radians(np.asarray(lon, dtype=np.float64))
    y = EARTH_RADIUS * np.arcsinh(np.tan(np.radians(np.asarray(lat, dtype=np.float64))))
    return x, y


def from_mercator(x: ArrayLike, y: ArrayLike) -> tuple[Array, Array]:
    """Positions ``lat, lon`` [degrees] of points of the Mercator plane [m]."""
    lat = np.degrees(np.arctan(np.sinh(np.asarray(y, dtype=np.float64) / EARTH_RADIUS)))
    lon = np.degrees(np.asarray(x, dtype=np.float64) / EARTH_RADIUS)
    return lat, lon


def scale(lat: ArrayLike) -> Array:
    """Give the true metres per metre of the Mercator plane at a latitude [degrees]."""
    return np.asarray(np.cos(np.radians(np.asarray(lat, dtype=np.float64))))


def great_circle_m(lat1: ArrayLike, lon1: ArrayLike, lat2: ArrayLike, lon2: ArrayLike) -> Array:
    """Great-circle distance [m] between positions [degrees] (haversine)."""
    p1, p2 = np.radians(lat1), np.radians(lat2)
    dp, dl = p2 - p1, np.radians(np.asarray(lon2) - np.asarray(lon1))
    h = np.sin(dp / 2) ** 2 + np.cos(p1) * np.cos(p2) * np.sin(dl / 2) ** 2
    return np.asarray(2 * EARTH_RADIUS * np.arcsin(np.sqrt(np.clip(h, 0.0, 1.0))))


def rhumb_course_deg(lat1: ArrayLike, lon1: ArrayLike, lat2: ArrayLike, lon2: ArrayLike) -> Array:
    """Course of the rhumb line from 1 to 2 [degrees true, 0 <= course < 360]."""
    x1, y1 = to_mercator(lat1, lon1)
    x2, y2 = to_mercator(lat2, lon2)
    return np.asarray(np.degrees(np.arctan2(x2 - x1, y2 - y1)) % 360.0)


def rhumb_distance_m(lat1: ArrayLike, lon1: ArrayLike, lat2: ArrayLike, lon2: ArrayLike) -> Array:
    """Length of the rhumb line from 1 to 2 [m].

    Along a rhumb line of course C the latitude changes by ``s cos C / R``; close to east-west that
    quotient is 0 / 0 and the middle latitude's scale takes over.
    """
    x1, y1 = to_mercator(lat1, lon1)
    x2, y2 = to_mercator(lat2, lon2)
    dx, dy = x2 - x1, y2 - y1
    dlat = EARTH_RADIUS * np.radians(np.asarray(lat2, dtype=np.float64) - np.asarray(lat1))
    steep = np.abs(dy) > 1e-3
    ratio = np.where(steep, dlat / np.where(steep, dy, 1.0), scale((np.asarray(lat1) + lat2) / 2))
    return np.asarray(np.hypot(dx, dy) * ratio)


def destination(
    lat: ArrayLike, lon: ArrayLike, course_deg: ArrayLike, distance_m: ArrayLike
) -> tuple[Array, Array]:
    """Position ``lat, lon`` [degrees] after sailing a rhumb line [degrees true, m] from a position."""
    course = np.radians(course_deg)
    lat1 = np.asarray(lat, dtype=np.float64)
    lat2 = lat1 + np.degrees(np.asarray(distance_m) * np.cos(course) / EARTH_RADIUS)
    x1, y1 = to_mercator(lat1, lon)
    _, y2 = to_mercator(lat2, lon)
    flat = np.abs(np.cos(course)) < 1e-6
    dx = np.where(
        flat,
        np.asarray(distance_m) * np.sin(course) / scale(lat1),
        (y2 - y1) * np.tan(np.where(flat, 0.0, course)),
    )
    return lat2, from_mercator(x1 + dx, y1)[1]


def angle_between_deg(a: ArrayLike, b: ArrayLike) -> Array:
    """Smallest angle between two directions [degrees], folded to 0-180."""
    return np.asarray(np.abs((np.asarray(a, dtype=np.float64) - b + 180.0) % 360.0 - 180.0))


def format_position(lat: float, lon: float) -> str:
    """Write a position as sailors read it: ``54°31.0'N 018°33.2'E``."""

    def part(value: float, positive: str, negative: str, width: int) -> str:
        minutes = round(abs(value) * 60, 1)
        return f"{int(minutes // 60):0{width}d}°{minutes % 60:04.1f}'{positive if value >= 0 else negative}"

    return f"{part(lat, 'N', 'S', 2)} {part(lon, 'E', 'W', 3)}"
