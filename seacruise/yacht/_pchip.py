"""Shape-preserving cubic slopes: no interpolated speed beyond the figures it lies between."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def interior_slope(h0: Array, h1: Array, d0: Array, d1: Array) -> Array:
    """Slope at a knot between secants ``d0`` and ``d1`` over steps ``h0`` and ``h1``.

    The weighted harmonic mean of the two secants, and zero where they change sign.

    References
    ----------
    F. N. Fritsch and J. Butland, A method for constructing local monotone piecewise cubic
    interpolants, SIAM J. Sci. Stat. Comput. 5 (1984), doi 10.1137/0905021.
    """
    same_way = d0 * d1 > 0.0
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        w0, w1 = 2.0 * h1 + h0, h1 + 2.0 * h0
        slope = (w0 + w1) / (w0 / d0 + w1 / d1)
    return np.where(same_way, slope, 0.0)


def end_slope(h0: Array, h1: Array, d0: Array, d1: Array) -> Array:
    """Slope at the first knot from its secant ``d0`` and the next one ``d1``: three points, kept monotone."""
    slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1)
    slope = np.where(np.sign(slope) != np.sign(d0), 0.0, slope)
    overshoots = (np.sign(d0) != np.sign(d1)) & (np.abs(slope) > 3.0 * np.abs(d0))
    return np.where(overshoots, 3.0 * d0, slope)


def slopes(x: Array, y: Array) -> Array:
    """Slopes of the monotone piecewise cubic through ``(x, y)``, both ``(n,)`` with ``n >= 1``."""
    n = len(x)
    if n == 1:
        return np.zeros(1)
    h = np.diff(x)
    d = np.diff(y) / h
    if n == 2:
        return np.repeat(d, 2)
    inner = interior_slope(h[:-1], h[1:], d[:-1], d[1:])
    first = end_slope(h[0], h[1], d[0], d[1])
    last = end_slope(h[-1], h[-2], d[-1], d[-2])
    return np.concatenate(([first], inner, [last]))
