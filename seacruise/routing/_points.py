"""Compiled loops that list the points of a lattice: over water, near the shore, along lines.

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

from seacruise.compiled import kernel
from seacruise.geodesy import EARTH_RADIUS
from seacruise.sea._kernels import LAND, WATER


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


@kernel
def corridor_points(lines, reach, mesh, origin, side, most):
    """Points within ``reach`` [m of the plane] of lines ``(n, 4)``; near several lines, repeated.

    Returns
    -------
    fits, i, j
        ``(m,)`` positions.
    """
    lean, rise = mesh
    row_height = side * rise
    count = 0
    i_out = np.empty(0, dtype=np.int64)
    j_out = np.empty(0, dtype=np.int64)
    for fill in (False, True):
        if fill:
            i_out = np.empty(count, dtype=np.int64)
            j_out = np.empty(count, dtype=np.int64)
            count = 0
        for k in range(lines.shape[0]):
            ax, ay = lines[k, 0] - origin[0], lines[k, 1] - origin[1]
            dx, dy = lines[k, 2] - lines[k, 0], lines[k, 3] - lines[k, 1]
            square = dx * dx + dy * dy
            low = int(np.ceil((min(ay, ay + dy) - reach) / row_height))
            high = int(np.floor((max(ay, ay + dy) + reach) / row_height))
            for row in range(low, high + 1):
                y = row * row_height
                # Only the part of the line within reach of this row can be near points of it.
                first, last = 0.0, 1.0
                if dy != 0.0:
                    one, two = (y - reach - ay) / dy, (y + reach - ay) / dy
                    first, last = max(0.0, min(one, two)), min(1.0, max(one, two))
                left = min(ax + first * dx, ax + last * dx) - reach
                right = max(ax + first * dx, ax + last * dx) + reach
                for column in range(
                    int(np.ceil(left / side - lean * row)), int(np.floor(right / side - lean * row)) + 1
                ):
                    x = (column + lean * row) * side
                    t = 0.0
                    if square > 0.0:
                        t = min(max(((x - ax) * dx + (y - ay) * dy) / square, 0.0), 1.0)
                    ox, oy = x - ax - t * dx, y - ay - t * dy
                    if ox * ox + oy * oy <= reach * reach:
                        if fill:
                            i_out[count], j_out[count] = column, row
                        count += 1
                        if count > most:
                            return False, i_out, j_out
    return True, i_out, j_out
