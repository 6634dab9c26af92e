"""The search as R1 published it: Dijkstra with a plain array for its queue.

Short and readable rather than fast: extract-min looks at every vertex, O(V), decrease-key is O(1). It is
what the ``classic`` preset runs, and what the compiled search (`seacruise.routing.search`) must agree with.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from seacruise.routing.lattice import Lattice
from seacruise.routing.search import Found

Sail = Callable[[float, int, int], float]
"""Arrival [s] at vertex b when vertex a is left at a time [s]; inf when that cannot be sailed."""


def array_queue_search(lattice: Lattice, sail: Sail, departure: float) -> Found:
    """Settle every vertex that can be reached, in the order of arrival.

    Dijkstra is right here as long as leaving later never means arriving earlier (FIFO).
    """
    n = lattice.vertices
    arrival = np.full(n, np.inf)
    before = np.full(n, -1, dtype=np.int32)
    waiting = np.ones(n, dtype=bool)
    arrival[lattice.start] = departure
    settled = relaxed = 0
    while True:
        a = int(np.argmin(np.where(waiting, arrival, np.inf)))
        if not waiting[a] or not np.isfinite(arrival[a]):
            break
        waiting[a] = False
        settled += 1
        for b in lattice.target[lattice.first[a] : lattice.first[a + 1]].tolist():
            if not waiting[b]:
                continue
            relaxed += 1
            then = sail(float(arrival[a]), a, b)
            if then < arrival[b] or (then == arrival[b] and then < np.inf and a < before[b]):
                arrival[b], before[b] = then, a
    return Found(arrival, before, settled, relaxed)
