"""Compiled loops of the reverse search: the latest departure that still arrives by a given time.

The mirror of `seacruise.routing._kernels`: an edge is sailed backwards through the same pieces and the same
slices of time, at the same speeds.
"""

from __future__ import annotations

import numpy as np

from seacruise.compiled import kernel
from seacruise.routing._heap import sift_down, sift_up
from seacruise.routing._kernels import (
    DEGREES_PER_METRE,
    STILL,
    cell_at,
    least_seconds,
    sail_edge,
    slice_at,
    speed_in,
)
from seacruise.sea._prisms import closed

MARGIN = 1e-3
"""Labels are this much [s] before the very last moment: rounding must not turn it into a missed calm."""

TRIES = 12
"""How often a departure is put forward, twice as far each time, until sailing forwards agrees with it."""


@kernel
def sail_line_back(t, lat0, lon0, lat1, lon1, length, east, north, piece, wind, speeds):
    """Latest departure [s] on a straight leg that arrives at its end by ``t``; -inf if there is none."""
    slices, t0, step = wind[0].shape[0], wind[2], wind[3]
    pieces = int(length / piece) + 1
    share = 1.0 / pieces
    # The slice that ends at or after t: what is sailed backwards is sailed before t.
    k = min(max(int((t - t0) / step), 0), slices - 1)
    while k < slices - 1 and t0 + (k + 1) * step < t:
        k += 1
    while k > 0 and t0 + k * step >= t:
        k -= 1
    for p in range(pieces - 1, -1, -1):
        f = (p + 0.5) * share
        cell = cell_at(lat0 + (lat1 - lat0) * f, lon0 + (lon1 - lon0) * f, wind)
        rest = length * share
        while True:
            speed = speed_in(k, cell, east, north, wind, speeds)
            if speed < 0.0:
                return -np.inf
            if k == slices - 1 and speed <= STILL:
                # Forwards this calm never ends: she must have been through before it began.
                speed = 0.0
            if k == 0:
                if speed <= STILL:
                    return -np.inf
                t -= rest / speed
                break
            since = t0 + k * step
            if speed * (t - since) >= rest:
                t -= rest / speed
                break
            rest -= speed * (t - since)
            t = since
            k -= 1
    return t


@kernel
def sail_edge_back(t, a, b, points, piece, wind, speeds):
    """`sail_line_back` from vertex a to vertex b."""
    dx, dy = points[b, 0] - points[a, 0], points[b, 1] - points[a, 1]
    span = np.sqrt(dx * dx + dy * dy)
    if span == 0.0:
        return t
    inverse = 1.0 / span
    return sail_line_back(
        t,
        points[a, 2],
        points[a, 0] * DEGREES_PER_METRE,
        points[b, 2],
        points[b, 0] * DEGREES_PER_METRE,
        span * 0.5 * (points[a, 3] + points[b, 3]),
        dx * inverse,
        dy * inverse,
        piece,
        wind,
        speeds,
    )


@kernel
def confirmed(leave, t, a, b, points, piece, wind, speeds):
    """Put the departure of an edge forward until the forward integrator itself arrives by ``t``."""
    if leave == -np.inf or leave == t:
        return leave
    earlier = MARGIN
    for _ in range(TRIES):
        if sail_edge(leave, slice_at(leave, wind), a, b, points, piece, wind, speeds) <= t:
            return leave - MARGIN
        leave -= earlier
        earlier *= 2.0
    return -np.inf


@kernel
def edge_departure(t, a, b, points, piece, wind, speeds):
    """Latest departure along one edge, for callers outside compiled code: the tests."""
    leave = sail_edge_back(t, a, b, points, piece, wind, speeds)
    return confirmed(leave, t, a, b, points, piece, wind, speeds)


@kernel
def search_back(end, deadline, earliest, points, edges, piece, wind, speeds, slow, zones):
    """Time-dependent Dijkstra on latest departures, from the end backwards, with an indexed 4-ary heap.

    Parameters
    ----------
    end
        Vertex to be reached by ``deadline`` [s].
    earliest
        Departures before this [s] are of no use; the search ends there.
    edges
        ``(first, source)``: compressed sparse rows of the edges that lead INTO each vertex.
    zones
        Closed areas, see `seacruise.sea._prisms.closed`.

    Returns
    -------
    departure, after, settled
        ``(n,)`` latest departure [s] (-inf where there is none), ``(n,)`` next vertex (-1), and a count.
    """
    first, source = edges
    n = first.size - 1
    departure = np.full(n, -np.inf)
    after = np.full(n, -1, dtype=np.int32)
    # The heap gives the smallest key: departures with their sign turned.
    heap, keys = np.empty(n, dtype=np.int32), np.empty(n)
    place = np.full(n, -1, dtype=np.int32)
    done = np.zeros(n, dtype=np.bool_)
    departure[end] = deadline
    heap[0], keys[0] = end, -deadline
    place[end] = 0
    size = 1
    settled = 0
    zoned = zones[0].size > 1
    x, y = points[:, 0], points[:, 1]
    while size > 0:
        b = heap[0]
        size -= 1
        if size > 0:
            sift_down(heap, keys, place, size)
        done[b] = True
        t = departure[b]
        if t < earliest:
            break
        settled += 1
        for e in range(first[b], first[b + 1]):
            a = source[e]
            if done[a] or t - least_seconds(a, b, points, slow) <= departure[a]:
                continue
            leave = sail_edge_back(t, a, b, points, piece, wind, speeds)
            if leave <= departure[a]:
                continue
            leave = confirmed(leave, t, a, b, points, piece, wind, speeds)
            if leave > departure[a]:
                if zoned and closed(zones, x[a], y[a], leave, x[b], y[b], t):
                    continue
                hole = place[a]
                if hole < 0:
                    hole = size
                    size += 1
                departure[a] = leave
                after[a] = b
                sift_up(heap, keys, place, hole, a, -leave)
    for v in range(n):
        if not done[v] or departure[v] < earliest:
            departure[v] = -np.inf
            after[v] = -1
    return departure, after, settled
