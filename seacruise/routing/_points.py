"""Compiled loops that list the points of a lattice - over water, near the shore, along lines - and join them.

Names used throughout:

``mesh``
    ``(lean, rise)``: position (i, j) lies at ``x0 + side * (i + lean * j)``, ``y0 + side * rise * j``.
``origin``
    ``(x0, y0)`` [m of the plane].
``most``
    More points than that are not listed; ``fits`` is false then.
"""

from __future__ import annotations

import numpy as np

from seacruise.compiled import inlined, kernel
from seacruise.geodesy import EARTH_RADIUS
from seacruise.sea._kernels import LAND, WATER, free_line, wet


@kernel
def water_points(cells, frame, mesh, origin, side, box, room, most):
    """Points over cells of water, or with a shoreline in them, and no farther than ``room`` from a shore.

    Cells tell how many free ones surround them, so a row of the lattice jumps over open water.

    Parameters
    ----------
    cells, frame
        Raster of the sea, and its corner and cell ``(x0, y0, cell)`` [m of the plane].
    box
        ``(west, south, east, north)`` [m of the plane].
    room
        ``(least, radius)``: how far from the shore, in metres of the plane and in true ones, whichever is
        farther; an infinite one lists all water.

    Returns
    -------
    fits, i, j
        ``(m,)`` positions, sorted by row, then by column.
    """
    lean, rise = mesh
    x0, y0 = origin
    cx, cy, cell = frame
    rows, columns = cells.shape
    west, south, east, north = max(box[0], cx), max(box[1], cy), box[2], box[3]
    east, north = min(east, cx + columns * cell), min(north, cy + rows * cell)
    count = 0
    i_out = np.empty(0, dtype=np.int64)
    j_out = np.empty(0, dtype=np.int64)
    for fill in (False, True):
        if fill:
            i_out = np.empty(count, dtype=np.int64)
            j_out = np.empty(count, dtype=np.int64)
            count = 0
        for j in range(
            int(np.ceil((south - y0) / (side * rise))), int(np.floor((north - y0) / (side * rise))) + 1
        ):
            y = y0 + side * rise * j
            row = min(int(np.floor((y - cy) / cell)), rows - 1)
            limit = WATER + max(room[0], room[1] * np.cosh(y / EARTH_RADIUS)) / cell
            i = int(np.ceil((west - x0) / side - lean * j))
            last = int(np.floor((east - x0) / side - lean * j))
            while i <= last:
                column = min(int(np.floor((x0 + side * (i + lean * j) - cx) / cell)), columns - 1)
                value = cells[row, column]
                if value != LAND and value < limit:
                    if fill:
                        i_out[count], j_out[count] = i, j
                    count += 1
                    if count > most:
                        return False, i_out, j_out
                elif value >= limit:
                    # n cells on there are at least value - n rings; one is for where in its cell it lies.
                    i += max(0, int((value - limit - 1.0) * cell / side))
                i += 1
    return True, i_out, j_out


@inlined
def _reached(x0, y0, x1, y1, reach, y):
    """Part of a row at ``y`` that is within ``reach`` of a line: west and east end, inf and -inf if none.

    What is within reach is two discs and the rectangle between them, and convex.
    """
    west, east = np.inf, -np.inf
    for cx, cy in ((x0, y0), (x1, y1)):
        square = reach * reach - (y - cy) * (y - cy)
        if square >= 0.0:
            half = np.sqrt(square)
            west, east = min(west, cx - half), max(east, cx + half)
    dx, dy = x1 - x0, y1 - y0
    if dy != 0.0:
        across = reach / np.sqrt(dx * dx + dy * dy)
        for sign in (-across, across):
            f = (y - y0 - sign * dx) / dy
            if 0.0 <= f <= 1.0:
                x = x0 - sign * dy + f * dx
                west, east = min(west, x), max(east, x)
    return west, east


@inlined
def _spans(lines, active, count, reach, y, wests, easts):
    """Parts of a row within reach of the active lines, sorted and joined where they meet; their number."""
    found = 0
    for n in range(count):
        k = active[n]
        west, east = _reached(lines[k, 0], lines[k, 1], lines[k, 2], lines[k, 3], reach, y)
        if west > east:
            continue
        place = found
        while place > 0 and wests[place - 1] > west:
            wests[place], easts[place] = wests[place - 1], easts[place - 1]
            place -= 1
        wests[place], easts[place] = west, east
        found += 1
    joined = 0
    for n in range(1, found):
        if wests[n] <= easts[joined]:
            easts[joined] = max(easts[joined], easts[n])
        else:
            joined += 1
            wests[joined], easts[joined] = wests[n], easts[n]
    return min(found, joined + 1)


@kernel
def corridor_points(lines, reach, cells, frame, mesh, origin, side, room, most):
    """Points over water within ``reach`` [m of the plane] of lines and within ``room`` of a shore.

    Parameters
    ----------
    lines
        ``(n, 4)``, each from south to north, and sorted by where they begin.
    cells, frame, room
        As in `water_points`.

    Returns
    -------
    fits, i, j
        ``(m,)`` positions, each once, sorted by row, then by column.
    """
    lean, rise = mesh
    x0, y0 = origin
    cx, cy, cell = frame
    rows, columns = cells.shape
    count = 0
    i_out = np.empty(0, dtype=np.int64)
    j_out = np.empty(0, dtype=np.int64)
    if lines.shape[0] == 0:
        return True, i_out, j_out
    # Ways run along cells, and the lattice begins on one: points at that very distance are within reach.
    reach *= 1.0 + 1e-9
    active = np.empty(lines.shape[0], dtype=np.int64)
    wests, easts = np.empty(lines.shape[0]), np.empty(lines.shape[0])
    low = int(np.ceil((max(lines[0, 1] - reach, cy) - y0) / (side * rise)))
    high = int(np.floor((min(lines[:, 3].max() + reach, cy + rows * cell) - y0) / (side * rise)))
    for fill in (False, True):
        if fill:
            i_out = np.empty(count, dtype=np.int64)
            j_out = np.empty(count, dtype=np.int64)
            count = 0
        coming = here = 0
        for j in range(low, high + 1):
            y = y0 + side * rise * j
            while coming < lines.shape[0] and lines[coming, 1] - reach <= y:
                active[here] = coming
                coming += 1
                here += 1
            still = 0
            for n in range(here):
                if lines[active[n], 3] + reach >= y:
                    active[still] = active[n]
                    still += 1
            here = still
            row = min(int(np.floor((y - cy) / cell)), rows - 1)
            limit = WATER + max(room[0], room[1] * np.cosh(y / EARTH_RADIUS)) / cell
            for n in range(_spans(lines, active, here, reach, y, wests, easts)):
                i = int(np.ceil((max(wests[n], cx) - x0) / side - lean * j))
                last = int(np.floor((min(easts[n], cx + columns * cell) - x0) / side - lean * j))
                while i <= last:
                    column = min(int(np.floor((x0 + side * (i + lean * j) - cx) / cell)), columns - 1)
                    value = cells[row, column]
                    if value != LAND and value < limit:
                        if fill:
                            i_out[count], j_out[count] = i, j
                        count += 1
                        if count > most:
                            return False, i_out, j_out
                    elif value >= limit:
                        i += max(0, int((value - limit - 1.0) * cell / side))
                    i += 1
    return True, i_out, j_out


@kernel
def wet_points(water, x, y, margin):
    """Which points [cells] are water and not so near a shore that rounding could put them on land.

    Parameters
    ----------
    water
        Arrays of the raster, see `seacruise.sea._kernels`.
    margin
        Half of the diagonals that must be free [cells].
    """
    cells = water[0]
    out = np.zeros(x.size, dtype=np.bool_)
    m = margin
    for k in range(x.size):
        px, py = x[k], y[k]
        if not wet(water, px, py):
            continue
        out[k] = cells[int(py), int(px)] >= WATER or (
            free_line(water, px - m, py - m, px + m, py + m)
            and free_line(water, px - m, py + m, px + m, py - m)
        )
    return out


@inlined
def _find(index, i, j):
    """Place of a position in the list that an index is of, -1 where it is not in it; see `axial.Index`."""
    j0, first, low, base, table, column = index
    r = j - j0
    if r < 0 or r >= low.size:
        return -1
    begin, after = first[r], first[r + 1]
    c = i - low[r]
    if begin == after or c < 0 or i > column[after - 1]:
        return -1
    if table.size > 0:
        return table[base[r] + c]
    while begin < after:
        middle = (begin + after) >> 1
        if column[middle] < i:
            begin = middle + 1
        else:
            after = middle
    return begin if begin < first[r + 1] and column[begin] == i else -1


@kernel
def find_many(index, i, j):
    """Places ``(m,)`` of positions ``(m,)`` in the list that an index is of, -1 where they are not in it."""
    out = np.empty(i.size, dtype=np.int64)
    for k in range(i.size):
        out[k] = _find(index, i[k], j[k])
    return out


@kernel
def join_points(index, i, j, x, y, offsets, water, a, b):
    """List the edges that lead from points by an offset to another one and cross no land.

    Parameters
    ----------
    i, j, x, y
        ``(m,)`` positions, and where they lie [cells].
    offsets
        ``(k, 2)``.
    water
        Arrays of the raster; without cells, every edge is listed.
    a, b
        Filled with the places of both ends, as many as there are; room for ``k * m``.

    Returns
    -------
    count
        Number of edges.
    """
    any_edge = water[0].size == 0
    count = 0
    for o in range(offsets.shape[0]):
        di, dj = offsets[o, 0], offsets[o, 1]
        for k in range(i.size):
            n = _find(index, i[k] + di, j[k] + dj)
            if n >= 0 and (any_edge or free_line(water, x[k], y[k], x[n], y[n])):
                a[count], b[count] = k, n
                count += 1
    return count
