"""Which points to keep, by their weights: the filters of R5."""

from __future__ import annotations

import numpy as np

from seacruise.yacht.logs.log import Array, Mask


def bounded(weights: Array, *, low: float = 0.0, high: float = np.inf) -> Mask:
    """Keep weights within bounds, both included."""
    return np.asarray((weights >= low) & (weights <= high))


def above_quantile(weights: Array, share: float) -> Mask:
    """Leave out the share of the points with the least weights; equal ones stay together."""
    if not weights.size:
        return np.zeros(0, dtype=np.bool_)
    return np.asarray(weights >= np.quantile(weights, share))
