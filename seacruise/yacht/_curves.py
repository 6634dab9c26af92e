"""The continuous polar behind a table: one piecewise cubic per tabulated wind speed.

Each wind speed has its own angles, as its beat and run angles are its own. A cubic stays a cubic on any
part of its interval, so all of them are cut at the knots of all: one search finds the interval, and a
gather the coefficients.

Between two figures a cubic may promise a better VMG than either, and the beat and run angles of a
certificate are by definition where VMG is best. So no column makes good more than its best figure does,
to windward or to leeward.

Where a table ends
------------------
*Below the least angle* the speed falls linearly. It reaches zero dead into the wind, or sooner where that
would promise a better VMG than the least angle itself has: on a linear ramp of width ``c`` the VMG still
grows at the angle ``a`` when ``c <= cot a``.

*Above the greatest angle* she keeps making good to leeward what she makes good there, ``v cos a =
const``. The pieces are Hermite interpolants of the secant, whose fourth derivative is positive: they lie
below it, and the VMG never grows.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from seacruise.yacht import _pchip

Array = NDArray[np.float64]

_LEAST_RAMP = 1.0
"""Degrees in which the speed falls to zero where there is no VMG to keep (a table that ends abeam)."""

_LEEWARD_STEP = 10.0
"""Longest Hermite piece of the secant [degrees]: from 110 degrees on within 0.2 % of constant VMG."""


@dataclass(frozen=True, slots=True, eq=False)
class Curves:
    """Cubics of all columns on common intervals.

    Attributes
    ----------
    tws
        ``(w,)`` [m/s].
    knots
        ``(k + 1,)`` ends of the intervals [degrees], from 0 to 180.
    coefficients
        ``(4, w, k)``: speed [m/s] at ``knots[i] + u`` is ``c[0] + u (c[1] + u (c[2] + u c[3]))``.
    best_vmg
        ``(2, w)`` best VMG [m/s] of the figures, to windward and to leeward; infinite without one.
    """

    tws: Array
    knots: Array
    coefficients: Array
    best_vmg: Array


@dataclass(frozen=True, slots=True)
class _Hermite:
    """Pieces of one column: from ``x0`` to ``x1``, values and slopes at both ends."""

    x0: float
    x1: float
    y0: float
    y1: float
    m0: float
    m1: float

    def coefficients_at(self, x: float) -> tuple[float, float, float, float]:
        """Coefficients in powers of the distance from ``x``, which lies in the piece."""
        h = self.x1 - self.x0
        secant = (self.y1 - self.y0) / h
        c2 = (3.0 * secant - 2.0 * self.m0 - self.m1) / h
        c3 = (self.m0 + self.m1 - 2.0 * secant) / (h * h)
        u = x - self.x0
        return (
            self.y0 + u * (self.m0 + u * (c2 + u * c3)),
            self.m0 + u * (2.0 * c2 + 3.0 * u * c3),
            c2 + 3.0 * u * c3,
            c3,
        )


def build_curves(tws: Array, twa: Array, speed_table: Array) -> Curves:
    """Make the cubics of a table ``(a, w)`` with NaN where it has no figure."""
    columns = [_column(twa, speed_table[:, k]) for k in range(len(tws))]
    knots = np.array(sorted({x for pieces in columns for p in pieces for x in (p.x0, p.x1)}))
    coefficients = np.zeros((4, len(tws), len(knots) - 1))
    for k, pieces in enumerate(columns):
        first = np.searchsorted(knots, [p.x0 for p in pieces])
        last = np.searchsorted(knots, [p.x1 for p in pieces])
        for piece, i, j in zip(pieces, first, last, strict=True):
            for interval in range(i, j):
                coefficients[:, k, interval] = piece.coefficients_at(float(knots[interval]))
    return Curves(tws, knots, coefficients, _best_vmg(twa, speed_table))


def _best_vmg(twa: Array, speed_table: Array) -> Array:
    vmg = np.nan_to_num(speed_table, nan=-1.0) * np.cos(np.radians(twa))[:, np.newaxis]
    best = np.full((2, speed_table.shape[1]), np.inf)
    for row, side in ((0, twa < 90.0), (1, twa > 90.0)):
        known = side[:, np.newaxis] & ~np.isnan(speed_table)
        figures = np.where(known, np.abs(vmg), -1.0).max(axis=0, initial=-1.0)
        best[row] = np.where(figures > 0.0, figures, np.inf)
    return best


def _column(twa: Array, speeds: Array) -> list[_Hermite]:
    """Pieces from 0 to 180 degrees through the figures of one wind speed."""
    known = ~np.isnan(speeds)
    x, y = twa[known], speeds[known]
    if len(x) > 1 and x[0] == 0.0 and y[0] == 0.0:
        # "Nothing dead into the wind" is no figure: a cubic down to it would invent the dead angle.
        x, y = x[1:], y[1:]
    m = _pchip.slopes(x, y)
    inner = [
        _Hermite(*map(float, (x[i], x[i + 1], y[i], y[i + 1], m[i], m[i + 1]))) for i in range(len(x) - 1)
    ]
    return [*_windward(float(x[0]), float(y[0])), *inner, *_leeward(float(x[-1]), float(y[-1]))]


def _windward(angle: float, speed: float) -> list[_Hermite]:
    """From dead into the wind to the least angle with a figure."""
    if angle == 0.0:
        return []
    start = ramp_start(angle)
    ramp = speed / (angle - start)
    calm = [_Hermite(0.0, start, 0.0, 0.0, 0.0, 0.0)] if start > 0.0 else []
    return [*calm, _Hermite(start, angle, 0.0, speed, ramp, ramp)]


def ramp_start(angle: float) -> float:
    """Angle [degrees] up to which the speed is zero where the least figure is at ``angle``."""
    widest = np.degrees(1.0 / np.tan(np.radians(angle))) if angle < 90.0 else 0.0
    return max(0.0, angle - max(float(widest), _LEAST_RAMP))


def _leeward(angle: float, speed: float) -> list[_Hermite]:
    """From the greatest angle with a figure to dead before the wind."""
    if angle == 180.0:
        return []
    if angle < 90.0 + _LEAST_RAMP:
        end = angle + _LEAST_RAMP
        ramp = speed / _LEAST_RAMP
        return [_Hermite(angle, end, speed, 0.0, -ramp, -ramp), _Hermite(end, 180.0, 0.0, 0.0, 0.0, 0.0)]
    pieces = int(np.ceil((180.0 - angle) / _LEEWARD_STEP))
    x = np.linspace(angle, 180.0, pieces + 1)
    y = speed * np.cos(np.radians(angle)) / np.cos(np.radians(x))
    y[0] = speed
    m = np.radians(1.0) * y * np.tan(np.radians(x))
    knots = list(zip(x.tolist(), y.tolist(), m.tolist(), strict=True))
    return [_Hermite(a[0], b[0], a[1], b[1], a[2], b[2]) for a, b in pairwise(knots)]


def evaluate(curves: Curves, tws: Array, twa: Array) -> Array:
    """Speed [m/s] at winds [m/s] and folded angles [degrees] that broadcast; NaN for NaN."""
    columns = curves.tws
    interval = np.clip(np.searchsorted(curves.knots, twa, side="right") - 1, 0, len(curves.knots) - 2)
    u = twa - curves.knots[interval]
    side = (twa > 90.0).astype(np.intp)
    c0, c1, c2, c3 = curves.coefficients
    # Abeam there is no VMG to speak of, and 1e-12 leaves the limit far above any speed.
    cosine = np.maximum(np.abs(np.cos(np.radians(twa))), 1e-12)

    def column(k: NDArray[np.intp]) -> Array:
        cubic = c0[k, interval] + u * (c1[k, interval] + u * (c2[k, interval] + u * c3[k, interval]))
        return np.asarray(np.minimum(cubic, curves.best_vmg[side, k] / cosine))

    wind = np.clip(tws, 0.0, columns[-1])
    if len(columns) == 1:
        speed = column(np.zeros(wind.shape, dtype=np.intp)) + 0.0 * wind
    else:
        k = np.clip(np.searchsorted(columns, wind, side="right") - 1, 0, len(columns) - 2)
        speed = _between_columns(columns, wind, k, column)
    if columns[0] > 0.0:
        calm = np.clip(wind / columns[0], 0.0, 1.0)
        speed = speed * calm
    return np.asarray(np.maximum(speed, 0.0))


def _between_columns(
    tws: Array, wind: Array, k: NDArray[np.intp], column: Callable[[NDArray[np.intp]], Array]
) -> Array:
    """Monotone cubic from column ``k`` to ``k + 1``; the secants beside them give the slopes."""
    last = len(tws) - 1
    y0, y1 = column(k), column(k + 1)
    h = tws[k + 1] - tws[k]
    secant = (y1 - y0) / h
    if last == 1:
        m0 = m1 = secant
    else:
        before, after = np.maximum(k - 1, 0), np.minimum(k + 2, last)
        # Off the table there is no column before or after; the dummy steps are never selected.
        h_before = np.where(k > 0, tws[k] - tws[before], h)
        h_after = np.where(k + 2 <= last, tws[after] - tws[k + 1], h)
        d_before = (y0 - column(before)) / h_before
        d_after = (column(after) - y1) / h_after
        m0 = np.where(
            k > 0,
            _pchip.interior_slope(h_before, h, d_before, secant),
            _pchip.end_slope(h, h_after, secant, d_after),
        )
        m1 = np.where(
            k + 2 <= last,
            _pchip.interior_slope(h, h_after, secant, d_after),
            _pchip.end_slope(h, h_before, secant, d_before),
        )
    t = np.clip((wind - tws[k]) / h, 0.0, 1.0)
    speed = y0 + t * h * (m0 + t * (3.0 * secant - 2.0 * m0 - m1 + t * (m0 + m1 - 2.0 * secant)))
    # The cubic is monotone, its rounding is not: hold it within its two figures.
    return np.asarray(np.clip(speed, np.minimum(y0, y1), np.maximum(y0, y1)))
