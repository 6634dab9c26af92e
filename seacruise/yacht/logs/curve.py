"""Points become a polar as a curve: a formula with a few numbers, by least squares or orthogonal distance.

The formula is that of `seacruise.yacht.curve`. SciPy fits it with a loss that does not mind outliers; it is
needed for this method alone (the extra ``fit``).
"""

from __future__ import annotations

from typing import Final

import numpy as np

from seacruise.errors import InputError
from seacruise.yacht.curve import PolarCurve, curve_basis
from seacruise.yacht.logs.fit import INDEPENDENT_S, LEAST_POINTS, Fitted, support
from seacruise.yacht.logs.log import Array, Points

POWERS: Final = 2
WAVES: Final = 5
"""Powers of the wind and waves in the angle: what some hours of sailing can tell apart."""

_LEAST_POINTS: Final = 30
_STIFF: Final = 0.05
"""How much the shorter waves are held back: where there are no points the curve must not swing."""

SIGMA_TWS: Final = 0.7
SIGMA_TWA: Final = 4.0
SIGMA_SPEED: Final = 0.25
"""How far a mean of ten seconds is from what the sails felt [m/s, degrees, m/s]."""


def _formula(numbers: Array, tws: Array, twa: Array) -> Array:
    return np.asarray(curve_basis(tws, twa, winds=POWERS, angles=WAVES) @ numbers)


def _fitted(points: Points, *, orthogonal: bool) -> tuple[Array, Array]:
    """Numbers of the formula and their covariance."""
    try:
        from scipy.optimize import least_squares
    except ModuleNotFoundError:
        raise InputError(
            "Fitting a curve needs SciPy, which is not installed; install seacruise[fit], "
            "or fit a table or a cloud."
        ) from None
    if len(points) < _LEAST_POINTS:
        raise InputError(
            f"A curve needs {_LEAST_POINTS} steady points or more and the log has {len(points)}; "
            "give more logs, or fit a table."
        )
    root = np.sqrt(points.weight)
    distance = _orthogonal if orthogonal else _vertical
    independent = max(len(points) * min(points.span / INDEPENDENT_S, 1.0), 1.0)
    stiff = np.tile(np.arange(WAVES), POWERS) * _STIFF * np.sqrt(independent) / SIGMA_SPEED

    def off(numbers: Array) -> Array:
        return np.concatenate((root * distance(numbers, points), numbers * stiff))

    start = np.zeros(POWERS * WAVES)
    start[0] = 2.0 * float(np.median(points.speed))
    # A soft loss: what the filters let pass that is no sailing must not bend the curve.
    found = least_squares(off, start, loss="soft_l1", x_scale="jac", max_nfev=400)
    free = max(len(points) - start.size, 1)
    variance = float(np.sum(off(found.x)[: len(points)] ** 2)) / free
    shape = found.jac.T @ found.jac
    # Directions in which the points say nothing have a large, not an infinite, variance.
    damped = shape + 1e-6 * np.trace(shape) / start.size * np.eye(start.size)
    return found.x, np.linalg.inv(damped) * variance * len(points) / independent


def _vertical(numbers: Array, points: Points) -> Array:
    return np.asarray((points.speed - _formula(numbers, points.tws, np.abs(points.twa))) / SIGMA_SPEED)


def _orthogonal(numbers: Array, points: Points) -> Array:
    """Signed distances from the surface, in standard deviations, to their nearest points on it.

    Of each point the foot is found by Gauss-Newton steps in its two free figures; the sign is that of the
    speed, so that the distances are smooth where they vanish.
    """
    measured = np.abs(points.twa)
    wind, angle = points.tws.copy(), measured.copy()
    for _ in range(4):
        speed = _formula(numbers, wind, angle)
        by_wind = (_formula(numbers, wind + 1e-4, angle) - speed) / 1e-4 * SIGMA_TWS
        by_angle = (_formula(numbers, wind, angle + 1e-3) - speed) / 1e-3 * SIGMA_TWA
        p, q = (wind - points.tws) / SIGMA_TWS, (angle - measured) / SIGMA_TWA
        # The tangent plane's nearest point to the measured one.
        rest = points.speed - speed + by_wind * p + by_angle * q
        gain = rest / (SIGMA_SPEED**2 + by_wind**2 + by_angle**2)
        wind = np.maximum(points.tws + SIGMA_TWS * by_wind * gain, 0.0)
        angle = np.clip(measured + SIGMA_TWA * by_angle * gain, 0.0, 180.0)
    off = (points.speed - _formula(numbers, wind, angle)) / SIGMA_SPEED
    p, q = (wind - points.tws) / SIGMA_TWS, (angle - measured) / SIGMA_TWA
    return np.asarray(np.copysign(np.sqrt(off**2 + p**2 + q**2), off))


def curve_of(points: Points, name: str = "", *, orthogonal: bool = False) -> PolarCurve:
    """Fit the formula to points.

    Parameters
    ----------
    points
        Steady points, weighed.
    orthogonal
        Measure how far a point is from the surface in all three figures, not in speed alone: wind speeds
        and angles have errors too, and on the steep parts of a polar they flatten a fit by speed.

    Raises
    ------
    InputError
        SciPy is not installed, or the points are too few.
    """
    numbers, _ = _fitted(points, orthogonal=orthogonal)
    return _curve(numbers, points, name)


def _curve(numbers: Array, points: Points, name: str) -> PolarCurve:
    angles = np.abs(points.twa)
    return PolarCurve(
        name,
        numbers.reshape(POWERS, WAVES),
        winds=(float(points.tws.min()), float(points.tws.max())),
        angles=(float(angles.min()), float(angles.max())),
    )


def fit_curve(points: Points, tws: Array, twa: Array, *, orthogonal: bool = False) -> Fitted:
    """Fit the formula and read it at the nodes that points lie near; see `curve_of`."""
    numbers, covariance = _fitted(points, orthogonal=orthogonal)
    speed = _curve(numbers, points, "").speed(tws, twa[:, np.newaxis])
    terms = curve_basis(tws, twa[:, np.newaxis], winds=POWERS, angles=WAVES)
    error = np.sqrt(np.maximum(np.einsum("awk,kl,awl->aw", terms, covariance, terms), 0.0))
    count = support(points, tws, twa)
    known = count >= LEAST_POINTS
    return Fitted(tws, twa, np.where(known, speed, np.nan), np.where(known, error, np.nan), count)
