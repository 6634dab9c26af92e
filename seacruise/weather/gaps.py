"""Holes in a wind: land masked by the sender, bitmaps, fill values."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import WeatherError

Grid = NDArray[np.float32]

MAX_MISSING: Final = 0.6
"""Largest share of a grid that may be filled. Senders that mask land leave about half of a coastal area."""


def fill_gaps(u: Grid, v: Grid) -> tuple[Grid, Grid]:
    """Fill missing values (NaN) from the nearest valid neighbours of the same time.

    The hole shrinks from its rim: in each round, a missing node with valid neighbours among the eight
    around it takes their mean. So a masked coast gets the wind of the sea beside it, and the filling
    fades into a smooth mean further inland, where nobody sails.

    Parameters
    ----------
    u, v
        ``(t, y, x)`` components [m/s]; where one is missing, both are taken as missing.

    Returns
    -------
    tuple
        The same without holes; the very arrays that came in when there were none.

    Raises
    ------
    WeatherError
        ``bad-response`` when a time has no value at all, or more than `MAX_MISSING` of all is missing.
    """
    missing = np.isnan(u) | np.isnan(v)
    if not missing.any():
        return u, v
    share = float(missing.mean())
    if share > MAX_MISSING or missing.all(axis=(1, 2)).any():
        raise WeatherError(f"the wind is missing (masked) over {share:.0%} of the area")
    filled = np.stack([u, v])
    filled[:, missing] = 0.0
    known = ~missing
    while not known.all():
        _grow(filled, known)
    return filled[0], filled[1]


def _grow(filled: Grid, known: NDArray[np.bool_]) -> None:
    """Fill, in place, every unknown node that touches a known one."""
    rows, columns = known.shape[1:]
    count = np.zeros(known.shape, dtype=np.float32)
    total = np.zeros(filled.shape, dtype=np.float32)
    around = np.pad(known.astype(np.float32), ((0, 0), (1, 1), (1, 1)))
    values = np.pad(filled * known, ((0, 0), (0, 0), (1, 1), (1, 1)))
    for dy in range(3):
        for dx in range(3):
            count += around[:, dy : dy + rows, dx : dx + columns]
            total += values[:, :, dy : dy + rows, dx : dx + columns]
    new = ~known & (count > 0)
    filled[:, new] = total[:, new] / count[new]
    known |= new
