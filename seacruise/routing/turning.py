"""Passages on which turning costs time: tacks, gybes, and every degree of a turn.

The search runs on states (vertex, course by which it was reached), so what a turn costs is weighed against
what it gains while the passage is found, not added afterwards. And as manoeuvres are what a crew of two
would rather not do, there is the choice itself: the least time for each number of changes of course.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.routing.backwards import latest_departures
from seacruise.routing.field import SpeedTable, WindField
from seacruise.routing.lattice import Lattice
from seacruise.routing.search import PIECE_M, bound_ahead, search, seconds_a_metre
from seacruise.sea.zones import NO_ZONES, Zones

Pauses = tuple[float, float, float]
"""Seconds that a tack costs, a gybe, and each degree of a turn."""

NO_PAUSES: Final[Pauses] = (0.0, 0.0, 0.0)

SLOWER: Final = 0.08
"""Fewer changes of course are worth at most this share of the least time."""

GOOD_S: Final = 30.0
"""Nearer to the least time than this [s] no more changes are tried."""

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
        seconds_a_metre(field, speeds),
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
    slower: float = SLOWER,
    piece_m: float = PIECE_M,
    zones: Zones = NO_ZONES,
) -> list[tuple[int, float, NDArray[np.int64]]]:
    """Least time for each number of changes of course that a further one can better.

    Parameters
    ----------
    slower
        Passages that take longer than the fastest by more than this share are not looked for.

    Returns
    -------
    list
        Number of changes, arrival [s since 1970] and vertices from start to end, by rising number and
        falling time.
    """
    from seacruise.routing import _turning

    fastest = search(lattice, field, speeds, departure, piece_m=piece_m, zones=zones).arrival[lattice.end]
    if not np.isfinite(fastest):
        return []
    deadline = departure + (fastest - departure) * (1.0 + slower)
    latest = latest_departures(
        lattice, field, speeds, deadline, earliest=departure, piece_m=piece_m, zones=zones
    ).departure.copy()
    latest[lattice.start] = fastest + GOOD_S
    source = lattice.sources()
    dx = lattice.x[lattice.target] - lattice.x[source]
    dy = lattice.y[lattice.target] - lattice.y[source]
    angle = np.round(np.degrees(np.arctan2(dx, dy)) / COURSE_DEG).astype(np.int64) % round(360 / COURSE_DEG)
    angles, course = np.unique(angle, return_inverse=True)
    radians = np.radians(angles[course] * COURSE_DEG)
    along = np.sin(radians) * lattice.x[source] + np.cos(radians) * lattice.y[source]
    order = np.lexsort((along, course))
    rows = np.searchsorted(course[order], np.arange(angles.size + 1))
    arrivals, by, edge, before = _turning.fewest_changes(
        lattice.start,
        lattice.end,
        departure,
        most,
        latest,
        rows,
        order,
        lattice.points,
        source,
        lattice.target,
        piece_m,
        field.arrays,
        speeds.arrays,
        zones.arrays,
    )
    found: list[tuple[int, float, NDArray[np.int64]]] = []
    for changes, arrival in enumerate(arrivals.tolist()):
        if not arrival < (found[-1][1] if found else np.inf):
            continue
        state, edges = int(by[changes]), []
        while state >= 0:
            edges.append(int(edge[state]))
            state = int(before[state])
        edges.reverse()
        found.append((changes, arrival, np.append(source[edges[0]], lattice.target[edges])))
    return found
