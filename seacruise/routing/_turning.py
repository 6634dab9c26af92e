"""Compiled search on states (vertex, course by which it was reached): turning costs time.

A state is an edge: who arrived by it arrived on its course. Names as in `seacruise.routing._kernels`, and
``pauses``: seconds for a tack, for a gybe, and for each degree of a turn (R3's penalty).
"""

from __future__ import annotations

import numpy as np

from seacruise.compiled import inlined, kernel
from seacruise.routing._heap import sift_down, sift_up
from seacruise.routing._kernels import (
    DEGREES_PER_METRE,
    least_seconds,
    sail_edge,
    slice_at,
    wind_at,
)
from seacruise.sea._prisms import closed


@kernel
def pause_of(east0, north0, east1, north1, u, v, pauses):
    """Seconds that turning from one course to another takes; courses as direction cosines."""
    tack, gybe, per_degree = pauses
    seconds = 0.0
    if per_degree > 0.0:
        cosine = min(max(east0 * east1 + north0 * north1, -1.0), 1.0)
        seconds += per_degree * np.degrees(np.arccos(cosine))
    # The side the wind comes from is the sign of its part across the course.
    across0, across1 = north0 * u - east0 * v, north1 * u - east1 * v
    if across0 * across1 < 0.0:
        before = np.arctan2(abs(across0), -(east0 * u + north0 * v))
        after = np.arctan2(abs(across1), -(east1 * u + north1 * v))
        seconds += tack if before + after < np.pi else gybe
    return seconds


@inlined
def longest_pause(pauses):
    """Seconds of the costliest turn there is."""
    return max(pauses[0], pauses[1]) + 180.0 * pauses[2]


@kernel
def search_turning(
    start, end, departure, ahead, points, edges, source, piece, wind, speeds, slow, zones, pauses
):
    """Time-dependent A* over edges, each turn between two of them paid for.

    A state is settled unless another one at its vertex is earlier by the costliest turn there is: whatever
    comes next, that one can turn and be there first. ``best`` is the earliest that is known of each vertex.

    Parameters
    ----------
    source
        ``(m,)`` vertex from which each edge leads.

    Returns
    -------
    arrival, before, last, settled, relaxed
        ``(m,)`` arrival at the end of each edge [s], ``(m,)`` the edge sailed before it (-1), the edge by
        which the end is reached (-1 if it is not), and counts.
    """
    first, target = edges
    m = target.size
    x, y = points[:, 0], points[:, 1]
    arrival = np.full(m, np.inf)
    before = np.full(m, -1, dtype=np.int32)
    heap, keys = np.empty(m, dtype=np.int32), np.empty(m)
    place = np.full(m, -1, dtype=np.int32)
    done = np.zeros(m, dtype=np.bool_)
    best = np.full(first.size - 1, np.inf)
    best[start] = departure
    most = longest_pause(pauses)
    zoned = zones[0].size > 1
    size = 0
    settled = relaxed = 0
    last = -1
    e = -1
    while True:
        t = departure
        a = start
        east = north = u = v = 0.0
        if e >= 0:
            t = arrival[e]
            a = target[e]
            dx, dy = x[a] - x[source[e]], y[a] - y[source[e]]
            span = max(np.sqrt(dx * dx + dy * dy), 1e-9)
            east, north = dx / span, dy / span
            u, v = wind_at(t, points[a, 2], x[a] * DEGREES_PER_METRE, wind)
        for f in range(first[a], first[a + 1]):
            if done[f]:
                continue
            b = target[f]
            # What cannot be early enough even without turning need not be asked what turning costs.
            least = least_seconds(a, b, points, slow)
            latest = min(arrival[f], best[b] + most)
            if t + least >= latest:
                continue
            leave = t
            if e >= 0:
                dx, dy = x[b] - x[a], y[b] - y[a]
                span = max(np.sqrt(dx * dx + dy * dy), 1e-9)
                leave = t + pause_of(east, north, dx / span, dy / span, u, v, pauses)
                if leave + least >= latest:
                    continue
            relaxed += 1
            then = sail_edge(leave, slice_at(leave, wind), a, b, points, piece, wind, speeds)
            if then < arrival[f] and then < best[b] + most:
                if zoned and closed(zones, x[a], y[a], leave, x[b], y[b], then):
                    continue
                hole = place[f]
                if hole < 0:
                    hole = size
                    size += 1
                arrival[f] = then
                best[b] = min(best[b], then)
                before[f] = e
                sift_up(heap, keys, place, hole, f, then + ahead[b])
        e = -1
        while size > 0 and e < 0:
            e = heap[0]
            size -= 1
            if size > 0:
                sift_down(heap, keys, place, size)
            done[e] = True
            if arrival[e] >= best[target[e]] + most and arrival[e] > best[target[e]]:
                e = -1
        if e < 0:
            break
        settled += 1
        if target[e] == end:
            last = e
            break
    return arrival, before, last, settled, relaxed


@kernel
def fewest_changes(
    start, end, departure, most, latest, rows, order, points, source, target, piece, wind, speeds, zones
):
    """Earliest arrivals with at most 0, 1, 2 ... ``most`` changes of course.

    With a number of changes given, the next edge either keeps the course, or leaves a vertex reached with
    one change less on any course. Edges of a course only lead onwards along it, so one sweep in that order
    settles all of them: no queue is needed.

    Parameters
    ----------
    latest
        ``(n,)`` time [s] after which there is no use in being at a vertex, -inf where there never is; at
        the start, an arrival at the end that no number of changes betters.
    rows, order
        ``(c + 1,)`` and ``(m,)``: the edges of course k are ``order[rows[k]:rows[k + 1]]``, in the order in
        which one sails over the vertices they lead from.
    source, target
        ``(m,)`` vertices of each edge.

    Returns
    -------
    arrival, by, edge, before
        ``(most + 1,)`` arrival at the end [s] and the state it is reached by (-1 if it is not); ``(k,)`` edge
        of each state and the state before it (-1 at the start).
    """
    n, m = points.shape[0], target.size
    x, y = points[:, 0], points[:, 1]
    zoned = zones[0].size > 1
    arrivals = np.full(most + 1, np.inf)
    arrived_by = np.full(most + 1, -1, dtype=np.int32)
    edge = np.empty(4 * m + 1024, dtype=np.int32)
    before = np.empty(edge.size, dtype=np.int32)
    count = 0
    # Earliest arrival at each vertex with one change less, and the state by which.
    reached = np.full(n, np.inf)
    by = np.full(n, -1, dtype=np.int32)
    reached[start] = departure
    # With one change more most edges are left no earlier, and need not be sailed again.
    left = np.full(m, np.inf)
    there = np.full(m, np.inf)
    state = np.full(m, -1, dtype=np.int32)
    on_course = np.empty(n)
    on_course_by = np.empty(n, dtype=np.int32)
    for w in range(most + 1):
        best = reached.copy()
        best_by = by.copy()
        for c in range(rows.size - 1):
            on_course[:] = np.inf
            for f in order[rows[c] : rows[c + 1]]:
                a, b = source[f], target[f]
                t, e = on_course[a], on_course_by[a]
                if reached[a] < t:
                    t, e = reached[a], by[a]
                if not t <= latest[a] or a == end:
                    continue
                if t < left[f]:
                    left[f] = t
                    there[f] = sail_edge(t, slice_at(t, wind), a, b, points, piece, wind, speeds)
                    if zoned and closed(zones, x[a], y[a], t, x[b], y[b], there[f]):
                        there[f] = np.inf
                    if count == edge.size:
                        edge = np.append(edge, np.empty_like(edge))
                        before = np.append(before, np.empty_like(before))
                    edge[count], before[count] = f, e
                    state[f] = count
                    count += 1
                then = there[f]
                if then < on_course[b]:
                    on_course[b], on_course_by[b] = then, state[f]
                if then < best[b]:
                    best[b], best_by[b] = then, state[f]
        reached, by = best, best_by
        arrivals[w], arrived_by[w] = reached[end], by[end]
        if reached[end] <= latest[start]:
            break
    return arrivals, arrived_by, edge[:count].copy(), before[:count].copy()
