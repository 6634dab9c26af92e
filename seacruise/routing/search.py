"""The search: earliest arrival at the end, over a lattice, in wind that changes with time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.routing.field import SpeedTable, WindField
from seacruise.routing.lattice import Lattice, chord_m
from seacruise.sea.zones import NO_ZONES, Zones
from seacruise.units import METRES_PER_NM

PIECE_M: Final = 8 * METRES_PER_NM
"""Piece of an edge for a first look [m]; `seacruise.routing.refine.PIECE_M` is the fine one."""

_HAIR: Final = 1.0 - 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """What a search found.

    Attributes
    ----------
    arrival
        ``(n,)`` earliest arrival at each vertex, seconds since 1970; inf where it was not reached.
    before
        ``(n,)`` the vertex before it, -1 for the start and where it was not reached.
    settled, relaxed
        Vertices whose arrival became final, and edges that were sailed.
    """

    arrival: NDArray[np.float64]
    before: NDArray[np.int32]
    settled: int
    relaxed: int

    def path(self, end: int) -> NDArray[np.int64]:
        """Vertices from the start to ``end``; empty when it was not reached."""
        if not np.isfinite(self.arrival[end]):
            return np.empty(0, dtype=np.int64)
        vertices = [end]
        while self.before[vertices[-1]] >= 0:
            vertices.append(int(self.before[vertices[-1]]))
        return np.array(vertices[::-1], dtype=np.int64)


def search(
    lattice: Lattice,
    field: WindField,
    speeds: SpeedTable,
    departure: float,
    *,
    to_end: bool = True,
    latest: float = np.inf,
    piece_m: float = PIECE_M,
    zones: Zones = NO_ZONES,
    hopeless: NDArray[np.bool_] | None = None,
) -> Found:
    """Earliest arrivals from the lattice's start.

    Parameters
    ----------
    departure
        Seconds since 1970.
    to_end
        Goal-directed and stopping at the end; else every vertex that is reached before ``latest``.
    piece_m
        Longest part of an edge that is sailed in the wind of its middle [m].
    zones
        Closed areas; an edge that enters one while it is valid is not sailed. Nobody waits for a zone to
        open: of two ways to a vertex the earlier is kept, even where the later one could go on.
    hopeless
        ``(n,)`` vertices over which no fastest way to the end leads: they are looked at last.
    """
    from seacruise.routing import _kernels as k

    ahead = bound_ahead(lattice, field, speeds) if to_end else np.zeros(lattice.vertices)
    if hopeless is not None:
        ahead[hopeless] = np.inf
    return Found(
        *k.search(
            lattice.start,
            lattice.end if to_end else -1,
            departure,
            latest,
            ahead,
            lattice.points,
            lattice.edges,
            lattice.unchecked,
            piece_m,
            field.arrays,
            speeds.arrays,
            seconds_a_metre(field, speeds),
            zones.arrays,
        )
    )


def seconds_a_metre(field: WindField, speeds: SpeedTable) -> float:
    """Time [s] that a metre takes at the very least: at the best speed of all, and a hair less.

    The hair is more than what single precision of winds and speeds can be wrong by.
    """
    fastest = field.fastest(speeds)
    return _HAIR / fastest if fastest > 0.0 else 0.0


def bound_ahead(lattice: Lattice, field: WindField, speeds: SpeedTable) -> NDArray[np.float64]:
    """Least time [s] from each vertex to the end, ``(n,)``: straight there at the best speed of all."""
    fastest = field.fastest(speeds)
    if fastest <= 0.0:
        return np.zeros(lattice.vertices)
    end = lattice.lat[lattice.end], lattice.lon[lattice.end]
    return np.asarray(chord_m(lattice.lat, lattice.lon, *end) / fastest)


def connected(lattice: Lattice) -> bool:
    """Tell whether the lattice leads from its start to its end at all, whatever the wind."""
    from seacruise.routing import _rows as k

    return bool(k.reachable(lattice.first, lattice.target, lattice.start)[lattice.end])
