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

    A table over the rectangle of all positions answers fastest; where that would be much larger than the
    list - a fine corridor across half a sea - a sorted list of keys does.

    Parameters
    ----------
    i, j
        ``(n,)`` axial positions, each once, sorted as `unique` gives them.
    """

    def __init__(self, i: Whole, j: Whole) -> None:
        self._table: NDArray[np.int32] | None = None
        self._keys = keys(i, j)
        if i.size == 0:
            return
        self._i0, self._j0 = int(i.min()), int(j.min())
        shape = (int(j.max()) - self._j0 + 1, int(i.max()) - self._i0 + 1)
        if shape[0] * shape[1] <= max(_DENSEST, 4 * i.size):
            self._table = np.full(shape, -1, dtype=np.int32)
            self._table[j - self._j0, i - self._i0] = np.arange(i.size, dtype=np.int32)

    def at(self, i: Whole, j: Whole) -> Whole:
        """Places in the list ``(m,)`` of positions ``(m,)``; -1 where they are not in it."""
        if self._keys.size == 0:
            return np.full(i.shape, -1, dtype=np.int64)
        if self._table is None:
            wanted = keys(i, j)
            place = np.searchsorted(self._keys, wanted)
            place[place == self._keys.size] = 0
            return np.where(self._keys[place] == wanted, place, -1)
        r, c = j - self._j0, i - self._i0
        inside = (r >= 0) & (r < self._table.shape[0]) & (c >= 0) & (c < self._table.shape[1])
        found = np.full(i.shape, -1, dtype=np.int64)
        found[inside] = self._table[r[inside], c[inside]]
        return found


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
