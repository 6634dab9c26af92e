"""Another end for a lattice that is there: while a hand drags a port, no lattice is built for each place.

The vertices stay; only the two ends move, and are joined anew to what is in sight of them.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import from_mercator, scale, to_mercator
from seacruise.routing.network import Lattice
from seacruise.sea import Sea

_JOINED: Final = 96
"""Vertices that an end is joined to, the nearest ones, where they are in sight."""

_ENOUGH: Final = 12
"""With fewer of them in sight the place is too narrow for a lattice that was not made for it."""


def with_ends(
    lattice: Lattice, sea: Sea, start: tuple[float, float], end: tuple[float, float]
) -> Lattice | None:
    """Move the ends of a lattice that `seacruise.routing.lattice.build` made without further positions.

    Returns
    -------
    Lattice or None
        ``None`` where one of them is too narrow a place.
    """
    sx, sy = to_mercator(*start)
    ex, ey = to_mercator(*end)
    x, y = lattice.x.copy(), lattice.y.copy()
    x[-2:], y[-2:] = (float(sx), float(ex)), (float(sy), float(ey))
    if (x[-2:] == lattice.x[-2:]).all() and (y[-2:] == lattice.y[-2:]).all():
        return lattice
    leaves, enters = _in_sight(x, y, lattice.start, sea), _in_sight(x, y, lattice.end, sea)
    if min(leaves.size, enters.size) < _ENOUGH:
        return None
    first, target = _joined(lattice, leaves, enters)
    lat, lon = from_mercator(x, y)
    return replace(lattice, x=x, y=y, lat=lat, lon=lon, scale=scale(lat), first=first, target=target)


def _in_sight(x: NDArray[np.float64], y: NDArray[np.float64], end: int, sea: Sea) -> NDArray[np.int32]:
    """Vertices nearest to an end to which a straight line leads, in rising order; neither of the ends."""
    away = np.hypot(x[:-2] - x[end], y[:-2] - y[end])
    near = np.sort(np.argpartition(away, min(_JOINED, away.size - 1))[:_JOINED])
    near = near[away[near] > 1e-6]
    here = np.full(near.size, x[end]), np.full(near.size, y[end])
    return np.asarray(near[sea.clear(np.stack([*here, x[near], y[near]], axis=1))], dtype=np.int32)


def _joined(
    lattice: Lattice, leaves: NDArray[np.int32], enters: NDArray[np.int32]
) -> tuple[NDArray[np.int64], NDArray[np.int32]]:
    """Rows of edges in which the ends' old ones are replaced."""
    inner = lattice.vertices - 2
    target = lattice.target[: lattice.first[inner]]
    old = np.flatnonzero(target == lattice.end)
    degrees = np.diff(lattice.first[: inner + 1])
    degrees[np.searchsorted(lattice.first[: inner + 1], old, side="right") - 1] -= 1
    # Each vertex leads into the end last of all.
    rows_end = np.cumsum(degrees)[enters]
    degrees[enters] += 1
    target = np.insert(np.delete(target, old), rows_end, np.int32(lattice.end))
    first = np.concatenate([[0], np.cumsum(degrees)])
    last = first[-1] + leaves.size
    return np.concatenate([first, [last, last]]), np.concatenate([target, leaves])
