"""Positions on a lattice - axial, or by column and row - and finding a point by its position."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

Whole = NDArray[np.int64]

_DENSEST: Final = 4_000_000
_SHIFT: Final = 1 << 30


def keys(i: Whole, j: Whole) -> Whole:
    """One number for each position; sorted by row, then by column."""
    return np.asarray(((j + _SHIFT) << 32) | (i + _SHIFT))


def unique(i: Whole, j: Whole) -> tuple[Whole, Whole]:
    """Positions without repetition, sorted by row, then by column."""
    if i.size == 0:
        return i, j
    i0, j0 = int(i.min()), int(j.min())
    shape = (int(j.max()) - j0 + 1, int(i.max()) - i0 + 1)
    if shape[0] * shape[1] <= 16 * i.size:
        marked = np.zeros(shape, dtype=bool)
        marked[j - j0, i - i0] = True
        rows, columns = np.nonzero(marked)
        return columns + i0, rows + j0
    found = np.sort(keys(i, j))
    # Sorting beats np.unique, which hashes first.
    found = found[np.append(True, found[1:] != found[:-1])] if found.size else found
    return (found & 0xFFFFFFFF) - _SHIFT, (found >> 32) - _SHIFT


class Index:
    """Finds where in a list a position stands.

    A table over each row, from its first position to its last, answers fastest; where that would be much
    larger than the list - the shores of half a sea - a row is searched.

    Parameters
    ----------
    i, j
        ``(n,)`` axial positions, each once, sorted as `unique` gives them.

    Attributes
    ----------
    arrays
        What `seacruise.routing._points` calls ``index``: the first row; ``(r + 1,)`` where in the list each
        row begins; ``(r,)`` its first column and where in the table it begins; the table; and ``i``.
    """

    def __init__(self, i: Whole, j: Whole) -> None:
        j0 = int(j[0]) if j.size else 0
        rows = int(j[-1]) - j0 + 1 if j.size else 0
        first = np.searchsorted(j, np.arange(j0, j0 + rows + 1))
        filled = first[1:] > first[:-1]
        low, width = np.zeros(rows, dtype=np.int64), np.zeros(rows, dtype=np.int64)
        low[filled] = i[first[:-1][filled]]
        width[filled] = i[first[1:][filled] - 1] - low[filled] + 1
        base = np.concatenate([[0], np.cumsum(width)])
        table = np.empty(0, dtype=np.int32)
        if base[-1] <= max(_DENSEST, 4 * i.size):
            table = np.full(int(base[-1]), -1, dtype=np.int32)
            table[base[j - j0] + i - low[j - j0]] = np.arange(i.size, dtype=np.int32)
        self.arrays = (j0, first, low, base, table, i)

    def at(self, i: Whole, j: Whole) -> Whole:
        """Places in the list ``(m,)`` of positions ``(m,)``; -1 where they are not in it."""
        from seacruise.routing import _points as k

        return np.asarray(k.find_many(self.arrays, i, j))


@dataclass(frozen=True, slots=True, eq=False)
class Patch:
    """Vertices of one level: where they lie on the lattice, and their numbers ``(n,)``."""

    index: Index
    numbers: NDArray[np.int32]


def numbers_above(above: Patch | None, i: Whole, j: Whole) -> NDArray[np.int32]:
    """Numbers of the points ``(m,)`` that a level has in common with the one above, -1 for all others."""
    numbers = np.full(i.size, -1, dtype=np.int32)
    if above is not None and above.numbers.size:
        even = np.flatnonzero((i % 2 == 0) & (j % 2 == 0))
        place = above.index.at(i[even] // 2, j[even] // 2)
        numbers[even[place >= 0]] = above.numbers[place[place >= 0]]
    return numbers
