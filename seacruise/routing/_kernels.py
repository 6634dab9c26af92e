"""Compiled loops of the search: wind and polar looked up, edges sailed, labels settled.

Everything here works on plain arrays. Names used throughout:

``wind``
    ``(u, v, t0, step, lat0, per_lat, lon0, per_lon)``: u, v ``(k, y, x)`` float32 [m/s], constant during
    each slice of ``step`` seconds from ``t0``; the last slice holds for ever. Where there is a current or a
    limit of gusts or waves, or night or waves slow her down, there are three more, each of which may have no
    slices: ``stream``, ``(u, v, lat0, per_lat, lon0, per_lon)`` of the current in the same slices on a grid
    of its own; ``danger`` ``(k, y, x)`` on the wind's grid, gusts and waves as shares of what is allowed; and
    ``knobs``, ``(ease, rough, motor_below, motor_speed)``: the share of her speed that the night leaves and
    the one that waves take head to sea, both ``(k, y, x)``, and the engine, which neither slows down. Most
    passages need none of them, and looking for them would cost a quarter of a search: kernels are compiled
    once for each kind.
``speeds``
    ``(table, per_tws)``: ``(w, c)`` float32 boat speed [m/s]; rows by TWS in steps of ``1 / per_tws``,
    columns by the cosine of the TWA from -1 to 1; negative where the limits forbid to sail.
``points``
    ``(n, 4)`` of each vertex x, y, lat, scale, see `seacruise.routing.lattice.Lattice`: side by side, because
    an edge needs all four of a vertex that is not in the processor's cache. Longitude is x by another name.
``slow``
    Seconds a metre takes at the very least: an edge that even so leads to a vertex no earlier than another
    one did is not sailed at all, which spares two of five.
"""

from __future__ import annotations

import numpy as np

from seacruise.compiled import chosen, inlined, kernel
from seacruise.geodesy import EARTH_RADIUS
from seacruise.routing._heap import sift_down, sift_up
from seacruise.sea._kernels import free_line
from seacruise.sea._prisms import closed
from seacruise.yacht.knobs import LEAST_SHARE

STILL = 1e-6
"""Slower than this [m/s] is not moving."""

DEGREES_PER_METRE = 180.0 / (np.pi * EARTH_RADIUS)


@inlined
def boat_speed(u, v, east, north, speeds):
    """Speed [m/s] on the course with direction cosines ``east, north`` in a wind u, v."""
    table, per_tws = speeds
    tws = np.sqrt(u * u + v * v)
    cosine = -(u * east + v * north) / tws if tws > 1e-9 else 0.0
    row = min(tws * per_tws, table.shape[0] - 1.000001)
    column = min(max((cosine + 1.0) * 0.5 * (table.shape[1] - 1), 0.0), table.shape[1] - 1.000001)
    r, c = int(row), int(column)
    fr, fc = row - r, column - c
    a, b, d, e = table[r, c], table[r, c + 1], table[r + 1, c], table[r + 1, c + 1]
    if min(a, b, d, e) < 0.0:
        return -1.0
    return (a * (1 - fc) + b * fc) * (1 - fr) + (d * (1 - fc) + e * fc) * fr


@inlined
def _cell(lat, lon, grid, lat0, per_lat, lon0, per_lon):
    _, rows, columns = grid.shape
    y = min(max((lat - lat0) * per_lat, 0.0), rows - 1.0)
    x = min(max((lon - lon0) * per_lon, 0.0), columns - 1.0)
    r, c = min(int(y), rows - 2), min(int(x), columns - 2)
    fy, fx = y - r, x - c
    return r, c, (1 - fy) * (1 - fx), (1 - fy) * fx, fy * (1 - fx), fy * fx


@chosen
def cell_at(lat, lon, wind):
    """Cells of the grids around a position: row, column and the weights of their four corners."""

    def in_air(lat, lon, wind):
        return _cell(lat, lon, wind[0], wind[4], wind[5], wind[6], wind[7])

    def in_stream(lat, lon, wind):
        stream = wind[8]
        return (
            _cell(lat, lon, wind[0], wind[4], wind[5], wind[6], wind[7]),
            _cell(lat, lon, stream[0], stream[2], stream[3], stream[4], stream[5]),
        )

    return in_air if len(wind) == 8 else in_stream


@kernel
def eased_speed(u, v, east, north, speeds, ease, rough, below, motor_speed):
    """`boat_speed` as night and waves leave it, see `seacruise.yacht.knobs`."""
    speed = boat_speed(u, v, east, north, speeds)
    if speed < 0.0:
        return speed
    if rough > 0.0:
        tws = np.sqrt(u * u + v * v)
        ahead = 1.0 - (u * east + v * north) / tws if tws > 1e-9 else 0.0
        ease *= max(1.0 - rough * ahead * ahead * 0.25, LEAST_SHARE)
    speed *= ease
    return max(speed, motor_speed) if speed < below else speed


@kernel
def made_good(u, v, set_east, set_north, east, north, speeds, ease, rough, below, motor_speed):
    """Speed over ground [m/s] on a course made good, through water that moves.

    She steers into the current so far that what is left of her speed lies on the course. The wind u, v is
    the one felt by the drifting water; sought is the greatest r with ``|r d - c| = speed(r d - c)``, where d
    is the course and c the current. 0 where she cannot stem it; negative where the limits forbid to sail.
    """
    straight = eased_speed(u, v, east, north, speeds, ease, rough, below, motor_speed)
    if straight < 0.0:
        return -1.0
    if set_east == 0.0 and set_north == 0.0:
        return straight
    r = straight + set_east * east + set_north * north
    for _ in range(20):
        wx, wy = r * east - set_east, r * north - set_north
        need = np.sqrt(wx * wx + wy * wy)
        if need < 1e-9:
            return max(r, 0.0)
        have = eased_speed(u, v, wx / need, wy / need, speeds, ease, rough, below, motor_speed)
        if have < 0.0:
            return -1.0
        slope = (wx * east + wy * north) / need
        if slope < 0.3:
            break
        step = (have - need) / slope
        r += step
        if abs(step) < 1e-5:
            return max(r, 0.0)
    # Near a dead angle the iteration may swing: look from above for the first speed that she can hold.
    drift = np.sqrt(set_east * set_east + set_north * set_north)
    most = 0.0
    for c in range(speeds[0].shape[1]):
        row = min(int(np.sqrt(u * u + v * v) * speeds[1]) + 1, speeds[0].shape[0] - 1)
        most = max(most, speeds[0][row, c])
    high = max(most, motor_speed) + drift
    low = high
    while low > 0.0:
        low -= 0.05
        wx, wy = low * east - set_east, low * north - set_north
        need = max(np.sqrt(wx * wx + wy * wy), 1e-9)
        if eased_speed(u, v, wx / need, wy / need, speeds, ease, rough, below, motor_speed) >= need:
            break
        high = low
    if low <= 0.0:
        return 0.0
    for _ in range(20):
        r = 0.5 * (low + high)
        wx, wy = r * east - set_east, r * north - set_north
        need = max(np.sqrt(wx * wx + wy * wy), 1e-9)
        if eased_speed(u, v, wx / need, wy / need, speeds, ease, rough, below, motor_speed) >= need:
            low = r
        else:
            high = r
    return low


@inlined
def _look_up(grid, k, cell):
    r, c, w00, w01, w10, w11 = cell
    return (
        grid[k, r, c] * w00 + grid[k, r, c + 1] * w01 + grid[k, r + 1, c] * w10 + grid[k, r + 1, c + 1] * w11
    )


@chosen
def speed_in(k, cell, east, north, wind, speeds):
    """Speed over ground [m/s] on a course in slice ``k`` at a place, see `cell_at`."""

    def in_air(k, cell, east, north, wind, speeds):
        u, v = wind[0], wind[1]
        r, c, w00, w01, w10, w11 = cell
        uu = u[k, r, c] * w00 + u[k, r, c + 1] * w01 + u[k, r + 1, c] * w10 + u[k, r + 1, c + 1] * w11
        vv = v[k, r, c] * w00 + v[k, r, c + 1] * w01 + v[k, r + 1, c] * w10 + v[k, r + 1, c + 1] * w11
        return boat_speed(uu, vv, east, north, speeds)

    def in_stream(k, cell, east, north, wind, speeds):
        stream, danger, knobs = wind[8], wind[9], wind[10]
        if danger.shape[0] > 0 and _look_up(danger, k, cell[0]) > 1.0:
            return -1.0
        uu, vv = _look_up(wind[0], k, cell[0]), _look_up(wind[1], k, cell[0])
        cu = cv = rough = 0.0
        ease = 1.0
        if stream[0].shape[0] > 0:
            cu, cv = _look_up(stream[0], k, cell[1]), _look_up(stream[1], k, cell[1])
        if knobs[0].shape[0] > 0:
            ease = _look_up(knobs[0], k, cell[0])
        if knobs[1].shape[0] > 0:
            rough = _look_up(knobs[1], k, cell[0])
        return made_good(uu - cu, vv - cv, cu, cv, east, north, speeds, ease, rough, knobs[2], knobs[3])

    return in_air if len(wind) == 8 else in_stream


@inlined
def wind_at(t, lat, lon, wind):
    """Wind u, v [m/s] over ground at a place and time."""
    slices, t0, step = wind[0].shape[0], wind[2], wind[3]
    k = min(max(int((t - t0) / step), 0), slices - 1)
    cell = _cell(lat, lon, wind[0], wind[4], wind[5], wind[6], wind[7])
    return _look_up(wind[0], k, cell), _look_up(wind[1], k, cell)


@inlined
def slice_at(t, wind):
    """Slice of time that begins at ``t`` or in which it lies."""
    slices, t0, step = wind[0].shape[0], wind[2], wind[3]
    k = min(max(int((t - t0) / step), 0), slices - 1)
    while k < slices - 1 and t0 + (k + 1) * step <= t:
        k += 1
    return k


@inlined
def sail_line(t, k, lat0, lon0, lat1, lon1, length, east, north, piece, wind, speeds):
    """Arrival [s] at the end of a straight leg of ``length`` metres left at time ``t``; inf if never.

    The leg is cut into pieces; the wind of each is that of its middle, and it changes with every slice
    of time that the piece takes. Speed then depends on time alone, so sailing a piece is solved exactly,
    and who leaves later can never arrive earlier (FIFO), through calms and squalls alike. ``k`` is the slice
    of ``t``, see `slice_at`: all edges of a vertex share it.
    """
    slices, t0, step = wind[0].shape[0], wind[2], wind[3]
    pieces = int(length / piece) + 1
    share = 1.0 / pieces
    for p in range(pieces):
        f = (p + 0.5) * share
        cell = cell_at(lat0 + (lat1 - lat0) * f, lon0 + (lon1 - lon0) * f, wind)
        rest = length * share
        while True:
            speed = speed_in(k, cell, east, north, wind, speeds)
            if speed < 0.0:
                return np.inf
            if k == slices - 1:
                if speed <= STILL:
                    return np.inf
                t += rest / speed
                break
            until = t0 + (k + 1) * step
            if speed * (until - t) >= rest:
                t += rest / speed
                break
            rest -= speed * (until - t)
            t = until
            k += 1
    return t


@inlined
def sail_edge(t, k, a, b, points, piece, wind, speeds):
    """`sail_line` from vertex a to vertex b, left at time ``t`` of slice ``k``."""
    dx, dy = points[b, 0] - points[a, 0], points[b, 1] - points[a, 1]
    span = np.sqrt(dx * dx + dy * dy)
    if span == 0.0:
        return t
    inverse = 1.0 / span
    return sail_line(
        t,
        k,
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


@inlined
def least_seconds(a, b, points, slow):
    """Time [s] that an edge takes at the very least."""
    dx, dy = points[b, 0] - points[a, 0], points[b, 1] - points[a, 1]
    return np.sqrt(dx * dx + dy * dy) * 0.5 * (points[a, 3] + points[b, 3]) * slow


@kernel
def edge_arrival(t, a, b, points, piece, wind, speeds):
    """`sail_edge` for callers outside compiled code: the reference search and the tests."""
    return sail_edge(t, slice_at(t, wind), a, b, points, piece, wind, speeds)


@kernel
def _crosses_land(a, b, points, unchecked):
    """Tell whether an edge crosses land, looked at in the same direction whoever asks."""
    raster, ox, oy, cell = unchecked
    x0, y0, x1, y1 = points[a, 0], points[a, 1], points[b, 0], points[b, 1]
    if x1 < x0 or (x1 == x0 and y1 < y0):
        x0, y0, x1, y1 = x1, y1, x0, y0
    return not free_line(raster, (x0 - ox) / cell, (y0 - oy) / cell, (x1 - ox) / cell, (y1 - oy) / cell)


@kernel
def search(start, end, departure, latest, ahead, points, edges, unchecked, piece, wind, speeds, slow, zones):
    """Time-dependent Dijkstra, goal-directed (A*), with an indexed 4-ary heap in an array.

    Parameters
    ----------
    start, end
        Vertices; ``end < 0`` settles everything that is reached before ``latest``.
    ahead
        ``(n,)`` consistent lower bound of the time from each vertex to the end [s]; zeros for Dijkstra.
    edges
        ``(first, target)``: compressed sparse rows.
    unchecked
        ``(arrays, x0, y0, cell)`` of the raster against which edges still have to be held, without cells
        where none has: of many edges few are ever the fastest way to a vertex.
    zones
        Closed areas, see `seacruise.sea._prisms.closed`.

    Returns
    -------
    arrival, before, settled, relaxed
        ``(n,)`` earliest arrival [s] (inf where not reached), ``(n,)`` previous vertex (-1), and counts.
    """
    first, target = edges
    n = first.size - 1
    arrival = np.full(n, np.inf)
    before = np.full(n, -1, dtype=np.int32)
    heap, keys = np.empty(n, dtype=np.int32), np.empty(n)
    place = np.full(n, -1, dtype=np.int32)
    done = np.zeros(n, dtype=np.bool_)
    arrival[start] = departure
    heap[0], keys[0] = start, departure + ahead[start]
    place[start] = 0
    size = 1
    settled = 0
    relaxed = 0
    zoned = zones[0].size > 1
    lazily = unchecked[0][0].size > 0
    while size > 0:
        a, key = heap[0], keys[0]
        size -= 1
        if size > 0:
            sift_down(heap, keys, place, size)
        done[a] = True
        settled += 1
        if a == end or key > latest:
            break
        t = arrival[a]
        k = slice_at(t, wind)
        for e in range(first[a], first[a + 1]):
            b = target[e]
            if done[b]:
                continue
            if t + least_seconds(a, b, points, slow) > arrival[b]:
                continue
            relaxed += 1
            then = sail_edge(t, k, a, b, points, piece, wind, speeds)
            if then < arrival[b] or (then == arrival[b] and then < np.inf and a < before[b]):
                if zoned and closed(zones, points[a, 0], points[a, 1], t, points[b, 0], points[b, 1], then):
                    continue
                if lazily and _crosses_land(a, b, points, unchecked):
                    continue
                hole = place[b]
                if hole < 0:
                    hole = size
                    size += 1
                arrival[b] = then
                before[b] = a
                sift_up(heap, keys, place, hole, b, then + ahead[b])
    return arrival, before, settled, relaxed


@inlined
def latitude(y):
    """Latitude [degrees] of a point of the Mercator plane [m]."""
    return np.degrees(np.arctan(np.sinh(y / EARTH_RADIUS)))


@kernel
def sail_rhumb(t, x0, y0, lat0, x1, y1, lat1, piece, wind, speeds):
    """`sail_line` along the rhumb line between two points of the Mercator plane [m] of known latitudes."""
    dx, dy = x1 - x0, y1 - y0
    span = np.sqrt(dx * dx + dy * dy)
    if span < 1e-6:
        return t
    if abs(dy) > 1.0:
        length = span * EARTH_RADIUS * np.radians(lat1 - lat0) / dy
    else:
        length = span * np.cos(np.radians(0.5 * (lat0 + lat1)))
    return sail_line(
        t,
        slice_at(t, wind),
        lat0,
        x0 * DEGREES_PER_METRE,
        lat1,
        x1 * DEGREES_PER_METRE,
        length,
        dx / span,
        dy / span,
        piece,
        wind,
        speeds,
    )
