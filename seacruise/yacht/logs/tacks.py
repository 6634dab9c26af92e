"""Whether she is faster on one tack than on the other."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from seacruise.yacht.logs.fit import fit_table
from seacruise.yacht.logs.log import Array, Points

_LEAST_SHARE = 0.02
"""Two fits of a hundred points are not better known than this; a cell must not outweigh all others."""


@dataclass(frozen=True, slots=True, eq=False)
class Asymmetry:
    """Speed on the starboard tack over speed on the port tack, less 1.

    Attributes
    ----------
    difference, error
        Over all nodes that were sailed on both tacks, weighed by precision, and its standard error.
    tws, twa
        ``(n,)`` those nodes [m/s, degrees].
    differences, errors
        ``(n,)`` of each node.
    """

    difference: float
    error: float
    tws: Array
    twa: Array
    differences: Array
    errors: Array

    @property
    def significant(self) -> bool:
        """Whether chance would hardly make it: more than three standard errors."""
        return abs(self.difference) > 3.0 * self.error


def asymmetry(points: Points, tws: Array, twa: Array) -> Asymmetry | None:
    """Fit each tack on its own and compare the figures that both have.

    Parameters
    ----------
    points
        Steady points; the wind over starboard has positive angles.
    tws, twa
        ``(w,)`` and ``(a,)`` nodes [m/s, degrees].

    Returns
    -------
    Asymmetry or None
        ``None`` where no node was sailed on both tacks.
    """
    sides = points.twa > 0.0
    if sides.all() or not sides.any():
        return None
    starboard, port = (fit_table(points.rows(side), tws, twa) for side in (sides, ~sides))
    # Dead before the wind a tack is a matter of the boom, and points are mirrored there.
    both = ~np.isnan(starboard.speed) & ~np.isnan(port.speed) & (twa < 175.0)[:, np.newaxis]
    both &= (np.nan_to_num(starboard.speed) > 0.1) & (np.nan_to_num(port.speed) > 0.1)
    if not both.any():
        return None
    difference = starboard.speed[both] / port.speed[both] - 1.0
    parts = [side.error[both] / side.speed[both] for side in (starboard, port)]
    error = np.maximum(np.hypot(*parts), _LEAST_SHARE)
    weight = 1.0 / error**2
    wind, angle = np.meshgrid(tws, twa)
    mean = float(weight @ difference / weight.sum())
    # Neighbouring nodes share their points, about four each: their errors do not average out as if alone.
    overall = float(np.sqrt(min(4.0, difference.size) / weight.sum()))
    return Asymmetry(mean, overall, wind[both], angle[both], difference, error)
