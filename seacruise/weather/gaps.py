"""Holes in what a file holds: land masked by the sender, bitmaps, fill values."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import WeatherError

Grid = NDArray[np.float32]
Rounds = NDArray[np.int16]

MAX_MISSING: Final = 0.6
"""Largest share of a wind that may be filled. Senders that mask land leave about half of a coastal area."""

NEVER: Final = -1
"""Where `grow` has not come."""


def fill_gaps(*parts: Grid, area: str = "its area") -> tuple[tuple[Grid, ...], Rounds]:
    """Fill the missing values (NaN) of a wind from the nearest valid neighbours of the same time.

    A masked coast gets the wind of the sea beside it, and the filling fades into a smooth mean further
    inland, where nobody sails.

    Parameters
    ----------
    parts
        Components [m/s], each ``(..., y, x)``; where one is missing, all are taken as missing.
    area
        What the grid covers, for the sentence of a refusal.

    Returns
    -------
    tuple
        The same without holes (the very arrays that came in when there were none), and how far each value
        is from a given one, as `grow` tells it.

    Raises
    ------
    WeatherError
        ``bad-response`` when a time has no value at all, or more than `MAX_MISSING` of all is missing.
    """
    missing = _missing(parts)
    share = float(missing.mean())
    if share > MAX_MISSING or missing.all(axis=(-2, -1)).any():
        raise WeatherError(f"its wind is missing (masked) over {share:.0%} of {area}")
    return grow(*parts)


def grow(*parts: Grid, rounds: int | None = None) -> tuple[tuple[Grid, ...], Rounds]:
    """Fill missing values (NaN) from their rim inwards.

    In each round, a missing node with valid neighbours among the eight around it takes their mean.

    Parameters
    ----------
    rounds
        How many there are; by default as many as it takes. What is farther from any value stays NaN.

    Returns
    -------
    tuple
        The parts, and ``(..., y, x)`` the round in which each node was filled: 0 where the file has a
        value, `NEVER` where it is missing still.
    """
    missing = _missing(parts)
    depth = np.zeros(missing.shape, dtype=np.int16)
    if not missing.any():
        return parts, depth
    filled = np.stack(parts)
    filled[:, missing] = 0.0
    known = ~missing
    depth[missing] = NEVER
    count = 0
    while not known.all() and (rounds is None or count < rounds):
        count += 1
        new = _grow(filled, known)
        if not new.any():
            break
        depth[new] = count
    filled[:, ~known] = np.nan
    return tuple(filled), depth


def _missing(parts: tuple[Grid, ...]) -> NDArray[np.bool_]:
    missing = np.isnan(parts[0])
    for part in parts[1:]:
        missing |= np.isnan(part)
    return missing


def _grow(filled: Grid, known: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Fill, in place, every unknown node that touches a known one, and tell which those were."""
    rows, columns = known.shape[-2:]
    count = np.zeros(known.shape, dtype=np.float32)
    total = np.zeros(filled.shape, dtype=np.float32)
    around = _framed(known.astype(np.float32))
    values = _framed(filled * known)
    for dy in range(3):
        for dx in range(3):
            count += around[..., dy : dy + rows, dx : dx + columns]
            total += values[..., dy : dy + rows, dx : dx + columns]
    new = ~known & (count > 0)
    filled[:, new] = total[:, new] / count[new]
    known |= new
    return new


def _framed(values: Grid) -> Grid:
    """Put a row and a column of zeros around a grid."""
    return np.pad(values, [(0, 0)] * (values.ndim - 2) + [(1, 1), (1, 1)])
