"""A lower bound: no passage, by whatever route, can be faster than this.

Let D be the distance still to go to the end. On the course that leads straight there she closes it at no
more than w, the greatest speed made good towards the end that the polar's hull gives in any wind of the
area at that moment. So D falls from the direct distance to zero in no less than the time in which the
integral of w reaches it - land, lattice and all courses notwithstanding. The maximum is taken over the
places that are D from the end, not over the whole area, which makes the bound follow the weather along
the way.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import great_circle_m
from seacruise.routing.field import PER_TWS, SpeedTable, WindField
from seacruise.weather.wind import Wind

Array = NDArray[np.float64]

STEP_S: Final = 3600.0

SAFETY: Final = 1.003
"""Covers what sampling courses, winds and places can miss of a maximum."""

_RINGS: Final = 48
_ROWS: Final = 16
_ANGLES: Final = 91


def lower_bound_s(
    wind: Wind,
    speeds: SpeedTable,
    start: tuple[float, float],
    end: tuple[float, float],
    *,
    departure: float,
    found_s: float,
    drift: float = 0.0,
) -> float:
    """Seconds that a passage between two positions [degrees] takes at the very least.

    Parameters
    ----------
    departure
        Seconds since 1970.
    found_s
        Duration of a passage that was found [s]: the bound is never above it, and places that no faster
        passage can touch are left out.
    drift
        Strongest current [m/s]: it may help all the way, and freshen the wind she feels.
    """
    distance = float(great_circle_m(*start, *end))
    lat, lon = np.meshgrid(_refined(wind.lat), _refined(wind.lon), indexing="ij")
    to_end = great_circle_m(lat, lon, *end)
    cell = float(np.hypot(*(c.max() - c.min() for c in (lat[:2, :2], lon[:2, :2])))) * 111_200.0
    strongest = float(np.hypot(wind.u, wind.v).max())
    reach = (speeds.fastest(strongest + drift) + drift) * found_s
    inside = to_end + great_circle_m(lat, lon, *start) <= reach + 2 * cell
    if not inside.any():
        # A grid so coarse that it has no node near: any of its winds may blow here.
        inside[:] = True
    lat, lon, to_end = lat[inside], lon[inside], to_end[inside]
    bearing = _bearing(lat, lon, *end)
    closing = _support(speeds, math.ceil(strongest * PER_TWS / _ROWS) * _ROWS)
    left, t = distance, 0.0
    while left > 0.0 and t < found_s:
        near = np.abs(to_end - left) <= cell + distance / _RINGS
        near = near if near.any() else np.ones_like(near)
        step = min(STEP_S, found_s - t)
        # Wind is linear in time between two looks, and no stronger than at the stronger of them.
        u, v = wind.at(departure + t + np.array([[0.0], [step]]), lat[near], lon[near])
        if drift > 0.0:
            best = speeds.fastest(float(np.hypot(u, v).max()) + drift) + drift
        else:
            best = float(_look_up(closing, u, v, bearing[near]).max())
        if best * SAFETY * step >= left:
            return t + left / (best * SAFETY)
        left -= best * SAFETY * step
        t += step
    return min(t, found_s)


def farthest_m(
    wind: WindField,
    speeds: SpeedTable,
    ends: Sequence[tuple[float, float]],
    *,
    departure: float,
    seconds: float,
) -> float:
    """Distance [m] that she cannot exceed in a time, as the sum of her distances from all ends.

    In each slice of time the fastest she can be is her best speed in the strongest wind then blowing
    anywhere near. Two ends make an ellipse of what is near; one makes a circle, of that radius.
    """
    u, v, begin, step, south, per_lat, west, per_lon = wind.arrays[:8]
    lat = south + np.arange(u.shape[1]) / per_lat if per_lat else np.full(u.shape[1], south)
    lon = west + np.arange(u.shape[2]) / per_lon if per_lon else np.full(u.shape[2], west)
    lat, lon = np.meshgrid(lat, lon, indexing="ij")
    around = np.sum([great_circle_m(lat, lon, *end) for end in ends], axis=0)
    cell = (1.0 / per_lat if per_lat else 0.0) * 111_200.0
    first = min(int((departure - begin) / step), u.shape[0] - 1)
    last = min(int((departure + seconds - begin) / step), u.shape[0] - 1)
    tws = np.hypot(u[first : last + 1], v[first : last + 1])
    changes = begin + np.arange(first + 1, last + 1) * step
    lasting = np.diff([departure, *np.clip(changes, departure, departure + seconds), departure + seconds])
    reach = wind.fastest(speeds) * seconds
    # Winds that are too far away to be met count for nothing, which makes the reach smaller: once more.
    for _ in range(3):
        inside = around <= reach + 2 * cell
        if not inside.any():
            # A grid so coarse that it has no node near: any of its winds may blow here.
            inside[:] = True
        reach = float(wind.fastest_each(speeds, tws[:, inside].max(axis=1)) @ lasting)
    return reach


def _refined(axis: Array) -> Array:
    """Put three points between two of an axis, so that hardly a peak of bilinear wind is missed."""
    if axis.size == 1:
        return axis
    return np.asarray(np.interp(np.arange(0.0, axis.size - 1 + 1e-9, 0.25), np.arange(axis.size), axis))


def _bearing(lat: Array, lon: Array, lat0: float, lon0: float) -> Array:
    """Bearing [radians] at which great circles to a position begin."""
    p, q = np.radians(lat), np.radians(lat0)
    d = np.radians(lon0 - lon)
    return np.asarray(
        np.arctan2(np.sin(d) * np.cos(q), np.cos(p) * np.sin(q) - np.sin(p) * np.cos(q) * np.cos(d))
    )


@lru_cache(maxsize=8)
def _support(speeds: SpeedTable, rows: int) -> Array:
    """Greatest speed made good ``(w, a)`` by TWS and angle between wind and goal: the support function.

    Of the table's first rows, and two more.
    """
    table = speeds.arrays[0][: rows + 2]
    angles = np.linspace(0.0, np.pi, _ANGLES)
    column = np.round((np.cos(angles) + 1.0) / 2 * (table.shape[1] - 1)).astype(int)
    by_angle = table[:, column].astype(np.float64)
    made = np.empty_like(by_angle)
    for k, goal in enumerate(angles):
        towards = np.maximum(np.cos(angles - goal), np.cos(angles + goal))
        made[:, k] = (by_angle * towards).max(axis=1)
    # Between two rows the stronger wind may not be the faster one: take the better of both.
    made[:-1] = np.maximum(made[:-1], made[1:])
    return np.asarray(np.maximum(made, 0.0))


def _look_up(closing: Array, u: Array, v: Array, bearing: Array) -> Array:
    tws = np.hypot(u, v)
    row = np.minimum((tws * PER_TWS).astype(int), closing.shape[0] - 1)
    angle = np.abs((np.arctan2(-u, -v) - bearing + np.pi) % (2 * np.pi) - np.pi)
    column = angle / np.pi * (_ANGLES - 1)
    low = np.minimum(column.astype(int), _ANGLES - 2)
    return np.asarray(np.maximum(closing[row, low], closing[row, low + 1]))
