"""Points become a polar: as a table, or as a cloud that is asked at the table's figures.

Both answer at the nodes of a grid of wind speeds and angles, with what each figure is worth: how many
points it stands on and its standard error. Where there are no points there is no figure.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.logs.log import Array, Points
from seacruise.yacht.points import PolarPoints
from seacruise.yacht.polar import Polar

Method = Literal["table", "cloud", "curve"]
METHODS: Final[tuple[Method, ...]] = ("table", "cloud", "curve")

INDEPENDENT_S: Final = 75.0
"""Two speeds are as good as independent when so far apart [s].

Sum of the autocorrelation of the residuals in the logs of a day's racing (Flensburg 2013): a helmsman's luck
with a puff lasts about a minute."""

_TWA: Final = (30, 36, 42, 48, 54, 60, 70, 80, 90, 100, 110, 120, 130, 140, 150, 160, 170, 180)
_TWS_KN: Final = (4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 27, 30, 35, 40)

_REACH_TWS: Final = 2.0
_REACH_TWA: Final = 12.0
"""How far a point counts for a node [m/s, degrees]; its weight falls to 0 there."""

_BEYOND: Final = 0.5
"""How far outside the winds that were met a figure may stand [m/s]."""

LEAST_POINTS: Final = 3.0
"""Points that a figure must stand on, weighed by their distance."""

WORST_ERROR: Final = 0.15
"""A figure less certain than this share of it is left out of a polar: its neighbours know better."""

_LEAST_FIGURES: Final = 2
_HALF_SPEED_WIND: Final = 5.0
_HOLD: Final = 10.0
_TURNS: Final = 60
"""For filling gaps: figures that an angle or a wind needs, wind of half the greatest speed [m/s], how
strongly the usual growth with the wind is held to [s2/m2], and turns of the fit."""

_ALWAYS_CERTAIN: Final = 0.05
"""Errors below this are none [m/s]: dead into the wind 0 is 0."""


@dataclass(frozen=True, slots=True, eq=False)
class Fitted:
    """Speeds at the nodes of a grid, and what they are worth; NaN where there are no points.

    Attributes
    ----------
    tws, twa
        ``(w,)`` [m/s] and ``(a,)`` [degrees], increasing.
    speed, error
        ``(a, w)`` boat speed and its standard error [m/s].
    count
        ``(a, w)`` points that the figure stands on, weighed by their distance.
    """

    tws: Array
    twa: Array
    speed: Array
    error: Array
    count: Array

    @property
    def certain(self) -> NDArray[np.bool_]:
        """Which figures are certain enough for a polar: ``(a, w)``."""
        worst = np.maximum(WORST_ERROR * np.nan_to_num(self.speed), _ALWAYS_CERTAIN)
        return ~np.isnan(self.speed) & (np.nan_to_num(self.error, nan=np.inf) <= worst)

    def on(self, tws: Array, twa: Array) -> Fitted:
        """Give the same figures on axes that hold all of its own; NaN elsewhere."""
        rows, columns = np.searchsorted(twa, self.twa), np.searchsorted(tws, self.tws)
        place = np.ix_(rows, columns)
        parts = []
        for part, empty in ((self.speed, np.nan), (self.error, np.nan), (self.count, 0.0)):
            table = np.full((twa.size, tws.size), empty)
            table[place] = part
            parts.append(table)
        return Fitted(tws, twa, *parts)

    def polar(self, name: str, *, source: str = "") -> Polar:
        """Make the polar: figures that are certain enough, and the gaps between them filled.

        A wind speed that was met on some courses only would leave the others to guesses: below its least
        angle a table falls to nothing. So a gap gets the product of what its angle and its wind speed have
        in common with the rest, see `filled`. Winds and angles with fewer than two figures are left out.

        Raises
        ------
        InputError
            There are figures at fewer than two winds or two angles.
        """
        angles, winds = self._sailed()
        if angles.sum() < 2 or winds.sum() < 2:
            raise InputError(
                f"The log has steady sailing at {winds.sum()} wind speeds and {angles.sum()} angles only; "
                "a polar needs two of each: give more logs, or a polar to start from (--prior)."
            )
        part = np.ix_(angles, winds)
        kept = Fitted(
            self.tws[winds], self.twa[angles], *(t[part] for t in (self.speed, self.error, self.count))
        )
        return Polar(name, kept.tws, kept.twa, kept.filled(), source=source)

    def _sailed(self) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Which angles and winds have two certain figures or more."""
        known = self.certain
        return known.sum(axis=1) >= _LEAST_FIGURES, known.sum(axis=0) >= _LEAST_FIGURES

    def filled(self) -> Array:
        """Give the speeds ``(a, w)`` [m/s] with those that are not certain foretold from the others.

        Foretold is a product of a factor of the angle and one of the wind, fitted to the certain figures by
        least squares in turn; factors of winds are held to ``w / (w + 5)`` where little speaks for them.
        NaN at angles without any.
        """
        known = self.certain
        if known.all():
            return self.speed
        speed = np.where(known, self.speed, 0.0)
        weight = np.where(known, 1.0 / (np.nan_to_num(self.error) ** 2 + (0.05 * speed) ** 2 + 1e-4), 0.0)
        usual = self.tws / (self.tws + _HALF_SPEED_WIND)
        by_wind = usual.copy()
        by_angle = np.zeros(self.twa.size)
        for _ in range(_TURNS):
            by_angle = (weight * speed) @ by_wind / np.maximum(weight @ by_wind**2, 1e-12)
            held = _HOLD * float(by_angle @ by_angle) / max(by_angle.size, 1)
            by_wind = (by_angle @ (weight * speed) + held * usual) / (by_angle**2 @ weight + held)
        # An angle that was never sailed has nothing to be foretold from.
        by_angle[~known.any(axis=1)] = np.nan
        return np.where(known, self.speed, by_angle[:, np.newaxis] * by_wind)


def nodes(points: Points) -> tuple[Array, Array]:
    """Wind speeds [m/s] and angles [degrees] at which a polar of these points is given."""
    tws = np.array(_TWS_KN) * MS_PER_KNOT
    near = (tws >= points.tws.min() - _BEYOND) & (tws <= points.tws.max() + _BEYOND)
    return tws[near], np.array(_TWA, dtype=np.float64)


def fit_table(points: Points, tws: Array, twa: Array) -> Fitted:
    """Fit a plane to the points around each node, the nearer the heavier, and read it there.

    A mean of the points in a cell would be off by half a cell's slope where they crowd to one side; a plane
    is not. Its slopes are damped, so that points on one side do not extrapolate.

    Parameters
    ----------
    points
        Steady points, weighed.
    tws, twa
        ``(w,)`` and ``(a,)`` nodes [m/s, degrees].
    """
    x, y, speed, weight = _mirrored(points)
    values, variances, independent = (np.full((twa.size, tws.size), np.nan) for _ in range(3))
    counts = support(points, tws, twa)
    for row, angle in enumerate(twa):
        for column, wind in enumerate(tws):
            u, v = (x - wind) / _REACH_TWS, (y - angle) / _REACH_TWA
            near = u * u + v * v < 1.0
            each = weight[near] * (1.0 - u[near] ** 2 - v[near] ** 2)
            if counts[row, column] >= LEAST_POINTS and each.any():
                plane = _plane(u[near], v[near], speed[near], each)
                values[row, column], variances[row, column], effective = plane
                independent[row, column] = independent_of(effective, points.span)
    return Fitted(tws, twa, values, _errors(variances, independent), counts)


def support(points: Points, tws: Array, twa: Array) -> Array:
    """Count the points near each node, weighed by their distance: ``(a, w)``."""
    x, y, _, _ = _mirrored(points)
    count = np.zeros((twa.size, tws.size))
    for row, angle in enumerate(twa):
        v = ((y - angle) / _REACH_TWA) ** 2
        near = v < 1.0
        u = ((x[near, np.newaxis] - tws) / _REACH_TWS) ** 2
        count[row] = np.maximum(1.0 - u - v[near, np.newaxis], 0.0).sum(axis=0)
    return count


def _mirrored(points: Points) -> tuple[Array, Array, Array, Array]:
    """Points on one tack, those near the wind's axis again beyond it: she sails alike on both sides."""
    twa = np.abs(points.twa)
    beyond = twa > 180.0 - _REACH_TWA
    pick = np.concatenate((np.arange(len(points)), np.flatnonzero(beyond)))
    angle = np.concatenate((twa, 360.0 - twa[beyond]))
    return points.tws[pick], angle, points.speed[pick], points.weight[pick]


_DAMPING: Final = 0.05
"""Weight of "no slope", as a share of the points' own."""


def _plane(u: Array, v: Array, speed: Array, weight: Array) -> tuple[float, float, float]:
    """Value of a plane at the origin, variance of the points around it, and how many it is worth."""
    base = np.stack((np.ones(u.size), u, v))
    total = float(weight.sum())
    normal = (base * weight) @ base.T + np.diag((0.0, _DAMPING * total, _DAMPING * total))
    plane = np.linalg.solve(normal, (base * weight) @ speed)
    variance = float(weight @ (speed - plane @ base) ** 2) / total
    # What each point adds to the value at the origin; points on one side of it count for less.
    lever = np.linalg.solve(normal, np.array((1.0, 0.0, 0.0))) @ (base * weight)
    return max(float(plane[0]), 0.0), variance, 1.0 / float(lever @ lever)


def independent_of(count: float | Array, span: float) -> Array:
    """How many independent speeds a number of points is worth, one at least."""
    return np.maximum(np.asarray(count) * min(span / INDEPENDENT_S, 1.0), 1.0)


_POOLED: Final = 5.0
"""Independent speeds that the spread of all points counts for in the spread at a node.

Half a minute of points that happen to be alike proves nothing."""


def _errors(variance: Array, independent: Array) -> Array:
    """Give standard errors of means whose own spread is shrunk towards the common one."""
    known = ~np.isnan(variance)
    if not known.any():
        return np.full(variance.shape, np.nan)
    common = float(np.average(variance[known], weights=independent[known]))
    spread = (variance * independent + common * _POOLED) / (independent + _POOLED)
    return np.asarray(np.sqrt(spread / independent))


# --- cloud ---------------------------------------------------------------------------------------------

_CELL_TWS: Final = 0.5
_CELL_TWA: Final = 3.0
_CALM_ROW: Final = 1.0
"""Cells of a cloud, and how far apart its points dead into the wind are [m/s, degrees, m/s]."""


def cloud_of(points: Points, name: str = "") -> PolarPoints:
    """Condense points to a cloud: a point a cell of 0.5 m/s by 3 degrees, and no speed dead into the wind.

    Ten thousand moments on one reach would else outvote their neighbours by being more, not by being nearer.
    """
    row = np.floor(points.tws / _CELL_TWS).astype(np.int64)
    column = np.floor(np.abs(points.twa) / _CELL_TWA).astype(np.int64)
    _, cell = np.unique(row * 1000 + column, return_inverse=True)
    weight = np.bincount(cell, points.weight)
    full = weight > 0.0

    def mean(values: Array) -> Array:
        return np.asarray(np.bincount(cell, points.weight * values)[full] / weight[full])

    calm = np.arange(points.tws.min(), points.tws.max() + _CALM_ROW, _CALM_ROW)
    return PolarPoints(
        name,
        np.concatenate((mean(points.tws), calm)),
        np.concatenate((mean(np.abs(points.twa)), np.zeros(calm.size))),
        np.concatenate((mean(points.speed), np.zeros(calm.size))),
    )


def fit_cloud(points: Points, tws: Array, twa: Array) -> Fitted:
    """Interpolate in the cloud of the points at the nodes; parameters as for `fit_table`.

    The error is that of the points around: how far they are from the cloud's own surface.
    """
    cloud = cloud_of(points)
    wind, angle = np.meshgrid(tws, twa)
    count = support(points, tws, twa)
    known = count >= LEAST_POINTS
    speed = np.where(known, cloud.speed(wind, angle), np.nan)
    residual = np.abs(points.speed - cloud.speed(points.tws, points.twa))
    spread = fit_table(replace(points, speed=residual**2), tws, twa).speed
    error = _errors(np.where(known, spread, np.nan), independent_of(count, points.span))
    return Fitted(tws, twa, speed, error, count)
