"""How far each point is to be believed: the weighers of R5, on arrays.

Each returns weights ``(n,)`` from 0 to 1; weights of several are multiplied. Two look at the points that
are near in the plane of true wind speed and angle, within the ellipse with half-axes ``radius_tws`` and
``radius_twa``; the third looks at what the instruments did around the moment.

References
----------
V. Dannenberg, R. Schueler, A. Schuermann, Appl. Sci. 12 (2022) 3085, doi 10.3390/app12063085.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.yacht.logs.log import Array, Mask, Points

RADIUS_TWS: Final = 1.0
RADIUS_TWA: Final = 7.5
"""Half-axes of what is near [m/s, degrees]."""

_AT_ONCE: Final = 400_000
"""Pairs of points held in memory at once."""


def cylindric_mean(
    points: Points, *, radius_tws: float = RADIUS_TWS, radius_twa: float = RADIUS_TWA
) -> Array:
    """Weigh by how near each speed is to the mean of the speeds near by.

    The deviation from the mean, in standard deviations of the points near by, is scaled so that the
    farthest point has the weight 0 and a point at its mean the weight 1.
    """
    deviation = np.zeros(len(points))
    for rows, others, near in _cylinders(points, radius_tws, radius_twa):
        speed = points.speed[others]
        count = near.sum(axis=1)
        mean = near @ speed / count
        # About the mean of all, so that no digits are lost between two large sums.
        middle = speed.mean()
        variance = near @ (speed - middle) ** 2 / count - (mean - middle) ** 2
        sigma = np.sqrt(np.maximum(variance, 0.0))
        off = np.abs(points.speed[rows] - mean)
        # A point alone is its own mean: nothing speaks for or against it.
        deviation[rows] = np.divide(off, sigma, out=np.zeros(off.size), where=sigma > 1e-9)
    most = float(deviation.max(initial=0.0))
    return 1.0 - deviation / most if most > 0.0 else np.ones(len(points))


def cylindric_member(
    points: Points,
    *,
    radius_tws: float = RADIUS_TWS,
    radius_twa: float = RADIUS_TWA,
    height: float = 0.25,
) -> Array:
    """Weigh by how many points lie near by and have a speed within ``height`` [m/s]; 1 for the most."""
    members = np.zeros(len(points))
    for rows, others, near in _cylinders(points, radius_tws, radius_twa):
        alike = np.abs(points.speed[others] - points.speed[rows, np.newaxis]) <= height
        members[rows] = (near & alike).sum(axis=1) - 1
    most = float(members.max(initial=0.0))
    return members / most if most > 0.0 else np.ones(len(points))


def fluctuation(
    time: Array, values: Array, *, most: float, before_s: float = 60.0, after_s: float = 60.0
) -> Array:
    """Weigh by how calm a value is in time.

    Parameters
    ----------
    time, values
        ``(n,)`` moments [s], increasing, and what was measured in them.
    most
        Standard deviation from which on the weight is 0; it falls to that linearly from 1.
    before_s, after_s
        How far to look around each moment [s].
    """
    first = np.searchsorted(time, time - before_s, side="left")
    last = np.searchsorted(time, time + after_s, side="right")
    known = ~np.isnan(values)
    middle = float(values[known].mean()) if known.any() else 0.0
    centred = np.where(known, values - middle, 0.0)

    def sums(each: Array) -> Array:
        running = np.concatenate(([0.0], np.cumsum(each)))
        return np.asarray(running[last] - running[first])

    count = np.maximum(sums(known.astype(np.float64)), 1.0)
    variance = sums(centred**2) / count - (sums(centred) / count) ** 2
    return np.asarray(np.clip(1.0 - np.sqrt(np.maximum(variance, 0.0)) / most, 0.0, 1.0))


def _cylinders(
    points: Points, radius_tws: float, radius_twa: float
) -> Iterator[tuple[NDArray[np.intp], NDArray[np.intp], Mask]]:
    """Give some points, those that may be near, and which are: ``(rows, others, near)``."""
    order = np.argsort(points.tws)
    sorted_tws = points.tws[order]
    twa = np.abs(points.twa)
    step = max(1, _AT_ONCE // max(order.size, 1))
    for begin in range(0, order.size, step):
        rows = order[begin : begin + step]
        low = np.searchsorted(sorted_tws, points.tws[rows[0]] - radius_tws, side="left")
        high = np.searchsorted(sorted_tws, points.tws[rows[-1]] + radius_tws, side="right")
        others = order[low:high]
        x = (points.tws[others] - points.tws[rows, np.newaxis]) / radius_tws
        y = (twa[others] - twa[rows, np.newaxis]) / radius_twa
        yield rows, others, x * x + y * y <= 1.0
