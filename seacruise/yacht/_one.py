"""`seacruise.yacht._curves.evaluate` for one wind and one angle: plain floats, without the arrays.

A call for a single point spends a hundred times longer in making arrays than in arithmetic. The arithmetic
is the same, in the same order; a test holds the two equal.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

from seacruise.yacht._curves import Curves


@dataclass(frozen=True, slots=True)
class _Lists:
    """`Curves` as lists: ``cubics[w][k]`` are the four coefficients, ``best_vmg`` by side, then by wind."""

    tws: list[float]
    knots: list[float]
    cubics: list[list[tuple[float, float, float, float]]]
    best_vmg: list[list[float]]


@lru_cache(maxsize=64)
def _listed(curves: Curves) -> _Lists:
    cubics = [
        [(c[0], c[1], c[2], c[3]) for c in column]
        for column in curves.coefficients.transpose(1, 2, 0).tolist()
    ]
    return _Lists(curves.tws.tolist(), curves.knots.tolist(), cubics, curves.best_vmg.tolist())


def evaluate_one(curves: Curves, tws: float, twa: float) -> float:
    """Speed [m/s] at a wind [m/s] and an angle [degrees] of any sign and size; NaN for NaN."""
    if not (math.isfinite(tws) and math.isfinite(twa)):
        tws = math.copysign(1e9, tws) if math.isinf(tws) else tws
        if math.isnan(tws) or not math.isfinite(twa):
            return math.nan
    lists = _listed(curves)
    winds, knots = lists.tws, lists.knots
    turn = abs(twa) % 360.0
    angle = min(turn, 360.0 - turn)
    interval = min(max(bisect_right(knots, angle) - 1, 0), len(knots) - 2)
    u = angle - knots[interval]
    most = lists.best_vmg[1 if angle > 90.0 else 0]
    cosine = max(abs(math.cos(math.radians(angle))), 1e-12)

    def column(k: int) -> float:
        c0, c1, c2, c3 = lists.cubics[k][interval]
        return min(c0 + u * (c1 + u * (c2 + u * c3)), most[k] / cosine)

    wind = min(max(tws, 0.0), winds[-1])
    if len(winds) == 1:
        speed = column(0)
    else:
        k = min(max(bisect_right(winds, wind) - 1, 0), len(winds) - 2)
        y0, y1 = column(k), column(k + 1)
        h = winds[k + 1] - winds[k]
        m0, m1 = _slopes(winds, k, column, y0, y1)
        t = min(max((wind - winds[k]) / h, 0.0), 1.0)
        secant = (y1 - y0) / h
        speed = y0 + t * h * (m0 + t * (3.0 * secant - 2.0 * m0 - m1 + t * (m0 + m1 - 2.0 * secant)))
        speed = min(max(speed, min(y0, y1)), max(y0, y1))
    if winds[0] > 0.0:
        speed *= min(max(wind / winds[0], 0.0), 1.0)
    return max(speed, 0.0)


def _slopes(
    winds: list[float], k: int, column: Callable[[int], float], y0: float, y1: float
) -> tuple[float, float]:
    """Slopes at columns ``k`` and ``k + 1``, see `seacruise.yacht._curves`."""
    last = len(winds) - 1
    h = winds[k + 1] - winds[k]
    secant = (y1 - y0) / h
    if last == 1:
        return secant, secant
    before = after = h_before = h_after = 0.0
    if k > 0:
        h_before = winds[k] - winds[k - 1]
        before = (y0 - column(k - 1)) / h_before
    if k + 2 <= last:
        h_after = winds[k + 2] - winds[k + 1]
        after = (column(k + 2) - y1) / h_after
    m0 = _interior(h_before, h, before, secant) if k > 0 else _end(h, h_after, secant, after)
    m1 = _interior(h, h_after, secant, after) if k + 2 <= last else _end(h, h_before, secant, before)
    return m0, m1


def _interior(h0: float, h1: float, d0: float, d1: float) -> float:
    if not d0 * d1 > 0.0:
        return 0.0
    w0, w1 = 2.0 * h1 + h0, h1 + 2.0 * h0
    return (w0 + w1) / (w0 / d0 + w1 / d1)


def _end(h0: float, h1: float, d0: float, d1: float) -> float:
    slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1)
    if _sign(slope) != _sign(d0):
        return 0.0
    return 3.0 * d0 if _sign(d0) != _sign(d1) and abs(slope) > 3.0 * abs(d0) else slope


def _sign(value: float) -> int:
    return (value > 0.0) - (value < 0.0)
