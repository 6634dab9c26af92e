"""Compiled loops over the cells of a water raster. Rows run north, columns east."""

from __future__ import annotations

import numpy as np

from seacruise.compiled import kernel

LAND, SHORE, SHORE_WATER, WATER = 0, 1, 2, 3
"""Classes of a cell: land or lake; crossed by a shoreline, its centre on land; the same with its centre
on the open water; all water. Above ``WATER`` the value also counts the free cells around."""

MARGIN = 0.1
"""Lines keep about this far from corners of the shoreline [cells; some 15 m], so that what the sphere,
the projection or single precision moves by a metre never turns a clear leg into one that touches."""

BIN = 8
"""Side of the squares into which the edges of the shoreline are sorted, in cells."""

_MOST = 255


@kernel
def draw_polygons(x, y, rings, cells, window):
    """Classify the cells of a window (first row, row after, first column, column after) by polygons of land.

    Even-odd filling of all polygons at once - they do not overlap, and edges that two tiles share cancel:
    each edge toggles, in each row, the first cell whose centre lies east of it; a sweep along the row then
    integrates. A second bit marks every cell that an edge touches. Coordinates are in cells.
    """
    row0, row1, column0, column1 = window
    inside_bit, shore_bit = np.uint8(1), np.uint8(2)
    for row in range(row0, row1):
        for column in range(column0, column1):
            cells[row, column] = 0
    for r in range(rings.size - 1):
        for k in range(rings[r], rings[r + 1] - 1):
            x0, y0, x1, y1 = x[k], y[k], x[k + 1], y[k + 1]
            if y0 > y1:
                x0, y0, x1, y1 = x1, y1, x0, y0
            slope = (x1 - x0) / (y1 - y0) if y1 > y0 else 0.0
            low, high = int(np.floor(y0 - MARGIN)), int(np.floor(y1 + MARGIN))
            for row in range(max(row0, low), min(row1 - 1, high) + 1):
                if y0 <= row + 0.5 < y1:
                    column = max(column0, int(np.ceil(x0 + (row + 0.5 - y0) * slope - 0.5)))
                    if column < column1:
                        cells[row, column] ^= inside_bit
                xa, xb = x0, x1
                if y1 > y0:
                    xa = x0 + (min(max(y0, row - MARGIN), y1) - y0) * slope
                    xb = x0 + (max(min(y1, row + 1.0 + MARGIN), y0) - y0) * slope
                left = max(column0, int(np.floor(min(xa, xb) - MARGIN)))
                right = min(column1 - 1, int(np.floor(max(xa, xb) + MARGIN)))
                for column in range(left, right + 1):
                    cells[row, column] |= shore_bit
    for row in range(row0, row1):
        inside = np.uint8(0)
        for column in range(column0, column1):
            bits = cells[row, column]
            inside ^= bits & inside_bit
            if bits & shore_bit:
                cells[row, column] = SHORE if inside else SHORE_WATER
            else:
                cells[row, column] = LAND if inside else WATER


_VISITED = 10


@kernel
def _flood(cells, start, low, new, stack):
    """Relabel the cells ``low`` and ``low + 1`` that hang together (over sides) with ``start``; count them.

    Works by runs along rows: a run is pushed once for each run beside it, so the stack stays small.
    """
    rows, columns = cells.shape
    count = 0
    stack[0] = start
    top = 1
    while top > 0:
        top -= 1
        r = stack[top] // columns
        c = stack[top] % columns
        if not low <= cells[r, c] <= low + 1:
            continue
        left = c
        while left > 0 and low <= cells[r, left - 1] <= low + 1:
            left -= 1
        right = c
        while right < columns - 1 and low <= cells[r, right + 1] <= low + 1:
            right += 1
        for k in range(left, right + 1):
            cells[r, k] = new[0] if cells[r, k] == low else new[1]
        count += right - left + 1
        for rr in (r - 1, r + 1):
            if rr < 0 or rr >= rows:
                continue
            before = False
            for k in range(left, right + 1):
                here = low <= cells[rr, k] <= low + 1
                if here and not before:
                    stack[top] = rr * columns + k
                    top += 1
                before = here
    return count


@kernel
def keep_the_sea(cells, every, stack):
    """Turn all water but the largest connected one into land, and its shores with it.

    Bodies of water are met by looking at every n-th cell of every n-th row: one that is too small to be
    met so is too small to be the sea.
    """
    rows, columns = cells.shape
    dry = (LAND, LAND)
    best, best_start = 0, -1
    for row in range(every // 2, rows, every):
        for column in range(every // 2, columns, every):
            if not SHORE_WATER <= cells[row, column] <= WATER:
                continue
            start = row * columns + column
            count = _flood(cells, start, SHORE_WATER, (SHORE_WATER + _VISITED, WATER + _VISITED), stack)
            if count > best:
                if best_start >= 0:
                    _flood(cells, best_start, SHORE_WATER + _VISITED, dry, stack)
                best, best_start = count, start
            else:
                _flood(cells, start, SHORE_WATER + _VISITED, dry, stack)
    for row in range(rows):
        for column in range(columns):
            value = cells[row, column]
            if value >= _VISITED:
                cells[row, column] = value - _VISITED
            elif value >= SHORE_WATER:
                cells[row, column] = LAND
    # A shoreline that no sea is near belongs to a lake, or is a seam between two tiles of land.
    for row in range(rows):
        for column in range(columns):
            if cells[row, column] != SHORE:
                continue
            near = False
            for r in range(max(0, row - 1), min(rows, row + 2)):
                for c in range(max(0, column - 1), min(columns, column + 2)):
                    near = near or cells[r, c] >= SHORE_WATER
            if not near:
                cells[row, column] = LAND


@kernel
def name_bodies(cells, every, stack):
    """Replace ``WATER``, among cells that are water or land, by a number for each body that hangs together.

    Bodies are met as in `keep_the_sea`; what is met by none of the looks, or after 245 bodies, stays
    ``WATER``.
    """
    rows, columns = cells.shape
    name = _VISITED
    for row in range(every // 2, rows, every):
        for column in range(every // 2, columns, every):
            if cells[row, column] == WATER and name < _MOST:
                _flood(cells, row * columns + column, WATER, (name, name), stack)
                name += 1
    return cells


@kernel
def count_free_cells(cells):
    """Replace ``WATER`` by ``WATER - 1 + k``: k cells away (over corners too) is the nearest other cell.

    The rim of the raster counts as land: nothing is known beyond it. Two sweeps, exact for this metric.
    """
    rows, columns = cells.shape
    base = WATER - 1
    for row in range(rows):
        for column in range(columns):
            if cells[row, column] < WATER:
                continue
            best = 1
            if row > 0 and 0 < column < columns - 1:
                best = _MOST
                for value in (
                    cells[row - 1, column - 1],
                    cells[row - 1, column],
                    cells[row - 1, column + 1],
                    cells[row, column - 1],
                ):
                    near = value - base + 1 if value >= WATER else 1
                    best = min(best, near)
            cells[row, column] = min(_MOST, base + best)
    for row in range(rows - 1, -1, -1):
        for column in range(columns - 1, -1, -1):
            own = cells[row, column]
            if own < WATER:
                continue
            best = 1
            if row < rows - 1 and 0 < column < columns - 1:
                best = _MOST
                for value in (
                    cells[row + 1, column - 1],
                    cells[row + 1, column],
                    cells[row + 1, column + 1],
                    cells[row, column + 1],
                ):
                    near = value - base + 1 if value >= WATER else 1
                    best = min(best, near)
            cells[row, column] = min(own, base + best)


@kernel
def bin_shores(x, y, rings, columns, rows):
    """Sort the edges of polygons into squares of ``BIN`` x ``BIN`` cells.

    Returns
    -------
    first, edges
        Edges of square b are ``edges[first[b]:first[b + 1]]``, each x0, y0, x1, y1 in cells; an edge is
        listed in every square that its bounding box touches.
    """
    first = np.zeros(columns * rows + 1, dtype=np.int64)
    for fill in (False, True):
        if fill:
            for b in range(columns * rows):
                first[b + 1] += first[b]
            edges = np.empty((first[-1], 4), dtype=np.float32)
            free = first[:-1].copy()
        for r in range(rings.size - 1):
            for k in range(rings[r], rings[r + 1] - 1):
                left = max(0, int(np.floor((min(x[k], x[k + 1]) - MARGIN) / BIN)))
                right = min(columns - 1, int(np.floor((max(x[k], x[k + 1]) + MARGIN) / BIN)))
                low = max(0, int(np.floor((min(y[k], y[k + 1]) - MARGIN) / BIN)))
                high = min(rows - 1, int(np.floor((max(y[k], y[k + 1]) + MARGIN) / BIN)))
                for row in range(low, high + 1):
                    for column in range(left, right + 1):
                        b = row * columns + column
                        if fill:
                            at = free[b]
                            edges[at, 0], edges[at, 1], edges[at, 2], edges[at, 3] = (
                                x[k],
                                y[k],
                                x[k + 1],
                                y[k + 1],
                            )
                            free[b] += 1
                        else:
                            first[b + 1] += 1
    return first, edges


@kernel
def _crossings(water, row, column, x0, y0, x1, y1, margin):
    """Number of shoreline edges in the square around a cell that a line meets.

    With a ``margin`` the edges are longer by that at both ends, and the first one met is enough.
    """
    cells, first, edges = water
    b = (row // BIN) * ((cells.shape[1] + BIN - 1) // BIN) + column // BIN
    dx, dy = x1 - x0, y1 - y0
    count = 0
    for e in range(first[b], first[b + 1]):
        ax, ay = edges[e, 0] - x0, edges[e, 1] - y0
        bx, by = edges[e, 2] - x0, edges[e, 3] - y0
        if margin > 0.0:
            span = np.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay))
            if span > 0.0:
                ex, ey = (bx - ax) * margin / span, (by - ay) * margin / span
                ax, ay, bx, by = ax - ex, ay - ey, bx + ex, by + ey
        side_a, side_b = dx * ay - dy * ax, dx * by - dy * bx
        # Half-open on one side: a line through a corner where two edges meet counts once.
        if (side_a > 0.0) == (side_b > 0.0):
            continue
        t = (ax * (by - ay) - ay * (bx - ax)) / (dx * (by - ay) - dy * (bx - ax))
        if 0.0 <= t <= 1.0:
            count += 1
            if margin > 0.0:
                break
    return count


@kernel
def wet(water, x, y):
    """Tell whether a point (in cells) is on the open water; in a cell with a shoreline, exactly."""
    cells = water[0]
    column, row = int(np.floor(x)), int(np.floor(y))
    if row < 0 or column < 0 or row >= cells.shape[0] or column >= cells.shape[1]:
        return False
    value = cells[row, column]
    if value >= WATER or value == LAND:
        return value >= WATER
    crossed = _crossings(water, row, column, x, y, column + 0.5, row + 0.5, 0.0)
    return (value == SHORE_WATER) == (crossed % 2 == 0)


@kernel
def free_line(water, x0, y0, x1, y1):
    """Follow a straight line over the raster and tell whether it stays on the water.

    From a cell with k - 1 rings of water around it the line runs on to the edge of that square at once,
    so open water costs a step or two, and no point of the line goes unseen; in cells with a shoreline it
    is held against the shoreline itself. Coordinates are in cells.
    """
    cells = water[0]
    rows, columns = cells.shape
    if not wet(water, x0, y0):
        return False
    dx, dy = x1 - x0, y1 - y0
    tested = -1
    t = 0.0
    while t < 1.0:
        column, row = int(np.floor(x0 + t * dx)), int(np.floor(y0 + t * dy))
        if row < 0 or column < 0 or row >= rows or column >= columns:
            return False
        value = int(cells[row, column])
        if value == LAND:
            return False
        rings = 0
        if value >= WATER:
            rings = value - WATER
        elif tested != (row // BIN) * columns + column // BIN:
            tested = (row // BIN) * columns + column // BIN
            if _crossings(water, row, column, x0, y0, x1, y1, MARGIN) > 0:
                return False
        ahead = 2.0
        if dx > 0.0:
            ahead = (column + 1 + rings - x0) / dx
        elif dx < 0.0:
            ahead = (column - rings - x0) / dx
        if dy > 0.0:
            ahead = min(ahead, (row + 1 + rings - y0) / dy)
        elif dy < 0.0:
            ahead = min(ahead, (row - rings - y0) / dy)
        # A nudge carries the line over the border; without it rounding could stop it there for ever.
        t = max(ahead, t) + 1e-7
    return wet(water, x1, y1)


@kernel
def wet_many(water, x, y, out):
    """`wet` for ``(n,)`` points in cells."""
    for k in range(x.size):
        out[k] = wet(water, x[k], y[k])


@kernel
def free_lines(water, x0, y0, x1, y1, out):
    """`free_line` for ``(n,)`` lines in cells."""
    for k in range(x0.size):
        out[k] = free_line(water, x0[k], y0[k], x1[k], y1[k])


@kernel
def ways_out(cells, row, column, rings, most, sectors):
    """Find ways by water from a cell to open water, at most one for each sector of the compass.

    Breadth-first over sides and corners of cells; a way ends at the first cell with ``rings`` free rings
    around it, and does not go on through open water.

    Returns
    -------
    rows, columns, lengths
        Cells of the ways, one after the other from their outer end, and the number of cells of each.
    """
    rows, columns = cells.shape
    side = 2 * most + 1
    before = np.full((side, side), -1, dtype=np.int32)
    queue = np.empty(side * side, dtype=np.int32)
    middle = most * side + most
    before[most, most] = middle
    queue[0] = middle
    head, tail = 0, 1
    exits = np.full(sectors, -1, dtype=np.int32)
    while head < tail:
        here = queue[head]
        head += 1
        sr, sc = here // side, here % side
        r, c = row + sr - most, column + sc - most
        if cells[r, c] >= WATER + rings:
            sector = int((np.arctan2(sc - most, sr - most) / (2.0 * np.pi) + 0.5) * sectors) % sectors
            if exits[sector] < 0:
                exits[sector] = here
            continue
        for dr, dc in ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1)):
            nr, nc = sr + dr, sc + dc
            rr, cc = row + nr - most, column + nc - most
            if (
                rr < 0
                or cc < 0
                or rr >= rows
                or cc >= columns
                or nr < 0
                or nc < 0
                or nr >= side
                or nc >= side
            ):
                continue
            if cells[rr, cc] >= SHORE_WATER and before[nr, nc] < 0:
                before[nr, nc] = here
                queue[tail] = nr * side + nc
                tail += 1
    out_rows = np.empty(sectors * tail + 1, dtype=np.int32)
    out_columns = np.empty(sectors * tail + 1, dtype=np.int32)
    lengths = np.zeros(sectors, dtype=np.int64)
    n = 0
    for s in range(sectors):
        here = exits[s]
        if here < 0:
            continue
        while True:
            out_rows[n], out_columns[n] = row + here // side - most, column + here % side - most
            n += 1
            lengths[s] += 1
            if here == middle:
                break
            here = before[here // side, here % side]
    return out_rows[:n].copy(), out_columns[:n].copy(), lengths
