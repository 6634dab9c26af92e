"""One wind of the answers for a few places."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import WeatherError
from seacruise.weather.adaptive import kriging_weights
from seacruise.weather.answers import MAX_GAP_H
from seacruise.weather.ground import Ground
from seacruise.weather.point import PointAnswer
from seacruise.weather.wind import Current, Forecast, Wind, from_direction

Array = NDArray[np.float64]
Grid = NDArray[np.float32]

ENOUGH: Final = 0.5
"""Share of the answers that must have gusts, waves or a current for them to be used."""


def common_hours(points: Sequence[PointAnswer]) -> Array:
    """List the times that any answer has, while all of them last.

    Raises
    ------
    WeatherError
        When there are fewer than two.
    """
    first = max(point.time[0] for point in points)
    last = min(point.time[-1] for point in points)
    time = np.unique(np.concatenate([np.asarray(point.time, dtype=np.float64) for point in points]))
    time = time[(time >= first) & (time <= last)]
    if time.size < 2:
        raise WeatherError("The answers of Storm Glass for this passage have no hours in common; try again.")
    return time


def winds_at(points: Sequence[PointAnswer], time: Array) -> tuple[Array, Array]:
    """Components of the wind of all answers at other times, ``(t, n)`` each [m/s]."""
    u, v = np.empty((time.size, len(points))), np.empty((time.size, len(points)))
    for column, point in enumerate(points):
        east, north = from_direction(point.speed, point.direction)
        u[:, column] = np.interp(time, point.time, east)
        v[:, column] = np.interp(time, point.time, north)
    return u, v


def to_wind(ground: Ground, points: Sequence[PointAnswer], time: Array, forecast: Forecast) -> Wind:
    """Bring answers onto the ground's grid; what few of them have besides the wind is left out.

    Parameters
    ----------
    points
        Answers for different places, one or more.
    time
        ``(t,)`` times wanted, see `common_hours`.
    """
    u, v = (_onto(ground, points, values) for values in winds_at(points, time))
    gust, wave, spread, current_u, current_v = (
        _extra(ground, points, name, time) for name in ("gust", "wave", "spread", "current_u", "current_v")
    )
    if gust is not None:
        gust = np.maximum(gust, np.hypot(u, v))
    current = None
    if current_u is not None and current_v is not None:
        current = Current(time, ground.lat, ground.lon, current_u, current_v, forecast)
    return Wind(
        time, ground.lat, ground.lon, u, v, forecast, gust=gust, wave=wave, spread=spread, current=current
    )


def _onto(ground: Ground, points: Sequence[PointAnswer], values: Array) -> Grid:
    """Fill the grid ``(t, y, x)`` from values ``(t, n)``, never beyond the least and greatest of a time."""
    known = np.array([(point.lat, point.lon) for point in points])
    nodes = np.stack(np.meshgrid(ground.lat, ground.lon, indexing="ij"), axis=-1)
    weights = kriging_weights(known, nodes.reshape(-1, 2), ground.shrink)
    least, most = values.min(axis=1, keepdims=True), values.max(axis=1, keepdims=True)
    filled = np.clip(values @ weights.T, least, most)
    return filled.reshape(len(values), ground.lat.size, ground.lon.size).astype(np.float32)


def _extra(ground: Ground, points: Sequence[PointAnswer], name: str, time: Array) -> Grid | None:
    """Bring one of the values besides the wind onto the grid; ``None`` when too few answers have it."""
    found = [(point, values) for point in points if (values := _through_time(point, name, time)) is not None]
    if not found or len(found) < ENOUGH * len(points):
        return None
    return _onto(ground, [point for point, _ in found], np.stack([values for _, values in found], axis=1))


def _through_time(point: PointAnswer, name: str, time: Array) -> Array | None:
    """Take values at other times; ``None`` where they have a hole, or end, longer than may be bridged.

    How far sources differ is not known after one of them ended; the last difference is held.
    """
    values = np.asarray(getattr(point, name), dtype=np.float64)
    known = np.isfinite(values)
    if not known.any():
        return None
    told = np.asarray(point.time, dtype=np.float64)[known]
    end = min(time[-1], told[-1]) if name == "spread" else time[-1]
    between = told[(told > time[0]) & (told < end)]
    if np.diff([time[0], *between, end]).max() > MAX_GAP_H * 3600.0:
        return None
    return np.asarray(np.interp(time, told, values[known]))
