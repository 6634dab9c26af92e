"""Passages on which turning costs time: tacks, gybes, and every degree of a turn.

The search runs on states (vertex, course by which it was reached), so what a turn costs is weighed against
what it gains while the passage is found, not added afterwards. And as manoeuvres are what a crew of two
would rather not do, there is the choice itself: the least time for each number of changes of course.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.routing.field import SpeedTable, WindField
from seacruise.routing.lattice import Lattice
from seacruise.routing.search import PIECE_M, bound_ahead
from seacruise.sea.zones import NO_ZONES, Zones

Pauses = tuple[float, float, float]
"""Seconds that a tack costs, a gybe, and each degree of a turn."""

NO_PAUSES: Final[Pauses] = (0.0, 0.0, 0.0)

COURSE_DEG: Final = 0.25
"""Edges whose courses differ by less are one course: the angles of a stencil differ by more."""


def search_turning(
    lattice: Lattice,
    field: WindField,
    speeds: SpeedTable,
    departure: float,
    pauses: Pauses,
    *,
    piece_m: float = PIECE_M,
    zones: Zones = NO_ZONES,
) -> tuple[NDArray[np.int64], int]:
    """Find the earliest arrival at the end when turns cost time.

    Returns
    -------
    path, settled
        ``(n,)`` vertices from start to end, none where there is no way, and the states settled.
    """
    from seacruise.routing import _turning

    source = lattice.sources()
    _, before, last, settled, _ = _turning.search_turning(
        lattice.start,
        lattice.end,
        departure,
        bound_ahead(lattice, field, speeds),
        lattice.points,
        lattice.edges,
        source,
        piece_m,
        field.arrays,
        speeds.arrays,
        zones.arrays,
        pauses,
    )
    edges = []
    while last >= 0:
        edges.append(int(last))
        last = before[last]
    if not edges:
        return np.empty(0, dtype=np.int64), int(settled)
    edges.reverse()
    path = np.append(source[edges[0]], lattice.target[edges])
    return path.astype(np.int64), int(settled)


def paths_by_changes(
    lattice: Lattice,
    field: WindField,
    speeds: SpeedTable,
    departure: float,
    *,
    most: int,
    piece_m: float = PIECE_M,
) -> list[tuple[int, float, NDArray[np.int64]]]:
    """Least time for each number of changes of course that a further one can better.

    Returns
    -------
    list
        Number of changes, arrival [s since 1970] and vertices from start to end, by rising number and
        falling time.
    """
    from seacruise.routing import _turning

    source = lattice.sources()
    dx = lattice.x[lattice.target] - lattice.x[source]
    dy = lattice.y[lattice.target] - lattice.y[source]
    angle = np.round(np.degrees(np.arctan2(dx, dy)) / COURSE_DEG).astype(np.int64) % round(360 / COURSE_DEG)
    angles, course = np.unique(angle, return_inverse=True)
    radians = np.radians(angles * COURSE_DEG)
    across = np.outer(np.sin(radians), lattice.x) + np.outer(np.cos(radians), lattice.y)
    order = np.argsort(across, axis=1, kind="stable").astype(np.int32)
    arrival, before = _turning.fewest_changes(
        lattice.start,
        lattice.end,
        departure,
        most,
        order,
        lattice.points,
        lattice.edges,
        course.astype(np.int32),
        piece_m,
        field.arrays,
        speeds.arrays,
    )
    into = np.flatnonzero(lattice.target == lattice.end)
    found: list[tuple[int, float, NDArray[np.int64]]] = []
    for changes in range(most + 1):
        edge = int(into[np.argmin(arrival[changes, into])]) if into.size else -1
        if edge < 0 or not arrival[changes, edge] < (found[-1][1] if found else np.inf):
            continue
        states = [changes * course.size + edge]
        while (previous := int(before[divmod(states[-1], course.size)])) >= 0:
            states.append(previous)
        edges = np.array(states[::-1]) % course.size
        path = np.append(source[edges[0]], lattice.target[edges])
        found.append((changes, float(arrival[changes, edge]), path))
    return found
