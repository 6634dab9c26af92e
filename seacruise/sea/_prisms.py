"""Compiled tests of ways against zones: prisms in (x, y, time)."""

from __future__ import annotations

import numpy as np

from seacruise.compiled import kernel


@kernel
def closed(zones, x0, y0, t0, x1, y1, t1):
    """Tell whether a straight way enters a zone while that is valid.

    Parameters
    ----------
    zones
        ``(first, edges, boxes, spans)``: edges ``(m, 4)`` of zone z from ``first[z]`` on, its box ``(z, 4)``
        west, south, east, north, and its time of validity ``(z, 2)`` [s]; all in the Mercator plane [m].
    t0, t1
        When the way is begun and ended [s]; between the two she moves evenly.
    """
    first, edges, boxes, spans = zones
    dx, dy = x1 - x0, y1 - y0
    shares = np.empty(64)
    for z in range(first.size - 1):
        if t1 < spans[z, 0] or t0 > spans[z, 1]:
            continue
        if max(x0, x1) < boxes[z, 0] or min(x0, x1) > boxes[z, 2]:
            continue
        if max(y0, y1) < boxes[z, 1] or min(y0, y1) > boxes[z, 3]:
            continue
        inside = False
        count = 0
        for e in range(first[z], first[z + 1]):
            ax, ay, bx, by = edges[e, 0] - x0, edges[e, 1] - y0, edges[e, 2] - x0, edges[e, 3] - y0
            # Even-odd along the ray to the east tells whether the way begins inside.
            if (ay > 0.0) != (by > 0.0) and ax - ay * (bx - ax) / (by - ay) > 0.0:
                inside = not inside
            side_a, side_b = dx * ay - dy * ax, dx * by - dy * bx
            if (side_a > 0.0) != (side_b > 0.0):
                s = (ax * (by - ay) - ay * (bx - ax)) / (dx * (by - ay) - dy * (bx - ax))
                if 0.0 <= s <= 1.0 and count < shares.size:
                    k = count
                    while k > 0 and shares[k - 1] > s:
                        shares[k] = shares[k - 1]
                        k -= 1
                    shares[k] = s
                    count += 1
        since = 0.0
        for k in range(count + 1):
            until = shares[k] if k < count else 1.0
            if inside and t0 + (t1 - t0) * until >= spans[z, 0] and t0 + (t1 - t0) * since <= spans[z, 1]:
                return True
            inside = not inside
            since = until
    return False


@kernel
def closed_many(zones, x0, y0, x1, y1, t0, t1, out):
    """Apply `closed` to ``(n,)`` ways; each is taken to last from t0 to t1 wherever it is."""
    for k in range(x0.size):
        out[k] = False
        for z in range(zones[0].size - 1):
            if t1[k] >= zones[3][z, 0] and t0[k] <= zones[3][z, 1]:
                one = (
                    zones[0][z : z + 2] - zones[0][z],
                    zones[1][zones[0][z] : zones[0][z + 1]],
                    zones[2][z : z + 1],
                    np.array([[-np.inf, np.inf]]),
                )
                out[k] = out[k] or closed(one, x0[k], y0[k], 0.0, x1[k], y1[k], 0.0)
