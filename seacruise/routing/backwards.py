"""The search backwards: the latest departure from everywhere that still arrives by a given time.

It sails each edge backwards through the same pieces and slices of time as the search does forwards, so that
both agree to the millisecond.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from seacruise.routing.field import SpeedTable, WindField
from seacruise.routing.lattice import Lattice
from seacruise.routing.search import PIECE_M, seconds_a_metre
from seacruise.sea.zones import NO_ZONES, Zones

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Latest:
    """What a reverse search found.

    Attributes
    ----------
    departure
        ``(n,)`` latest departure from each vertex, seconds since 1970; -inf where none is late enough.
    after
        ``(n,)`` the vertex after it, -1 for the end and where there is none.
    settled
        Vertices whose departure became final.
    """

    departure: Array
    after: NDArray[np.int32]
    settled: int

    def path(self, start: int) -> NDArray[np.int64]:
        """Vertices from ``start`` to the end; empty when it cannot be reached in time."""
        if not np.isfinite(self.departure[start]):
            return np.empty(0, dtype=np.int64)
        vertices = [start]
        while self.after[vertices[-1]] >= 0:
            vertices.append(int(self.after[vertices[-1]]))
        return np.array(vertices, dtype=np.int64)


def latest_departures(
    lattice: Lattice,
    field: WindField,
    speeds: SpeedTable,
    deadline: float,
    *,
    earliest: float = -np.inf,
    piece_m: float = PIECE_M,
    zones: Zones = NO_ZONES,
) -> Latest:
    """Latest departure from each vertex that arrives at the lattice's end by a deadline.

    Leaving a vertex then, the forward search arrives in time; leaving a second later it does not. (Where
    Handling.max_wind or a zone closes edges for a time, leaving earlier may be no way at all: the departure
    told is then one that works along its own path, not the very latest.)

    Parameters
    ----------
    deadline, earliest
        Seconds since 1970; departures before ``earliest`` are not looked for.
    piece_m
        As of the search that it must agree with.
    zones
        Closed areas.
    """
    from seacruise.routing import _backwards, _rows

    sources = lattice.sources()
    first, order = _rows.sort_rows(lattice.target, lattice.vertices)
    return Latest(
        *_backwards.search_back(
            lattice.end,
            deadline,
            earliest,
            lattice.points,
            (first, sources[order]),
            piece_m,
            field.arrays,
            speeds.arrays,
            seconds_a_metre(field, speeds),
            zones.arrays,
        )
    )
