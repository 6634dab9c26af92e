"""A polar that learns: new figures shrunk towards what was believed before, and cells that remember.

Each figure is believed with a precision, one over its variance. What was believed before - the certificate,
or the polar of last season - has the standard deviation `PRIOR_SHARE` of its speed, unless it comes with
errors of its own; what the log says has its standard error. The sum of both, weighed by precision, is the
new figure, with the sum of the precisions. Doing so log by log gives the same as doing it once with all: the
polar is updated online, and `seacruise.yacht.logs.cells` keeps what that needs.

A figure that the log does not touch cannot learn from it. But a yacht that sails 90 % of her certificate
where she was seen does so elsewhere too; left alone, the certificate would stand as a step beside what was
seen. So a certificate is first scaled by the share of it that she reached, shrunk towards 1 where few
minutes speak for it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from seacruise.errors import InputError
from seacruise.yacht.logs.fit import INDEPENDENT_S, Fitted
from seacruise.yacht.logs.log import Array, Points
from seacruise.yacht.polar import Polar

PRIOR_SHARE: Final = 0.1
"""Standard deviation of a certificate's figure for a yacht as she is sailed, as a share of it."""

_SHARE_INDEPENDENT: Final = 10.0
"""Independent speeds that speak as loudly for the share reached as the certificate does for 1."""

FLOOR: Final = 0.01
"""Least error of a figure [m/s]: means of few points that happen to be alike are not certain."""


@dataclass(frozen=True, slots=True, eq=False)
class Performance:
    """How she does against a polar.

    Attributes
    ----------
    share, error
        Median of measured over predicted speed, and its standard error.
    independent
        Independent speeds that it rests on.
    """

    share: float
    error: float
    independent: float

    @property
    def shrunk(self) -> float:
        """The share to expect where she was not seen."""
        return 1.0 + (self.share - 1.0) * self.independent / (self.independent + _SHARE_INDEPENDENT)


def performance(points: Points, polar: Polar) -> Performance | None:
    """Hold steady points against a polar; ``None`` where it has no speed for any of them."""
    predicted = polar.speed(points.tws, points.twa)
    moving = predicted > 0.1
    if not moving.any():
        return None
    ratio = points.speed[moving] / predicted[moving]
    middle = float(np.median(ratio))
    # Standard error of a median of normal values, from the spread of the middle half.
    spread = float(np.subtract(*np.percentile(ratio, (75.0, 25.0)))) / 1.349
    independent = max(ratio.size * min(points.span / INDEPENDENT_S, 1.0), 1.0)
    return Performance(middle, 1.2533 * spread / float(np.sqrt(independent)), independent)


def believed(polar: Polar, tws: Array, twa: Array, *, scale: float = 1.0) -> Fitted:
    """Read a polar, scaled, at nodes: figures with errors, standing on no points."""
    speed = scale * polar.speed(tws, twa[:, np.newaxis])
    return Fitted(tws, twa, speed, np.maximum(PRIOR_SHARE * speed, FLOOR), np.zeros(speed.shape))


def updated(prior: Fitted, seen: Fitted) -> Fitted:
    """Join what was believed with what was seen, figure by figure, each weighed by its precision.

    Parameters
    ----------
    prior, seen
        On the same nodes; NaN where there is no figure.

    Raises
    ------
    InputError
        The nodes differ.
    """
    if not (np.array_equal(prior.tws, seen.tws) and np.array_equal(prior.twa, seen.twa)):
        raise InputError("The polar to update has other wind speeds or angles than the fit; fit on its own.")
    precision, speed = [], []
    for each in (prior, seen):
        known = ~np.isnan(each.speed)
        precision.append(np.where(known, 1.0 / np.maximum(np.nan_to_num(each.error), FLOOR) ** 2, 0.0))
        speed.append(np.where(known, each.speed, 0.0))
    total = precision[0] + precision[1]
    known = total > 0.0
    safe = np.where(known, total, 1.0)
    mean = (precision[0] * speed[0] + precision[1] * speed[1]) / safe
    return Fitted(
        prior.tws,
        prior.twa,
        np.where(known, mean, np.nan),
        np.where(known, 1.0 / np.sqrt(safe), np.nan),
        prior.count + seen.count,
    )


_SAME_ANGLE: Final = 1.5


def joined_axes(polar: Polar | Fitted, seen: Fitted) -> tuple[Array, Array]:
    """Join the wind speeds [m/s] and angles [degrees] of a polar with those of a fit.

    The polar's own winds and angles are all kept, its beat and run angles among them. Winds of the fit are
    added beyond them, angles of the fit where there is none within 1.5 degrees.
    """
    beyond = seen.tws[(seen.tws < polar.tws[0] - 0.01) | (seen.tws > polar.tws[-1] + 0.01)]
    apart = np.abs(seen.twa[:, np.newaxis] - polar.twa).min(axis=1)
    return np.union1d(polar.tws, beyond), np.union1d(polar.twa, seen.twa[apart > _SAME_ANGLE])
