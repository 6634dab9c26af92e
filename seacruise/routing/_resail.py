"""Compiled stepping of a yacht along her finished legs; see `seacruise.routing.resail`.

Shares nothing with the search's kernels: the forecast's own grid and times instead of slices, a polar by
angle instead of cosine, steps of time instead of pieces of way.
"""

from __future__ import annotations

import numpy as np

from seacruise.compiled import kernel


@kernel
def _bracket(axis, value):
    """Index before a value on an increasing axis, and how far towards the next it lies; ends are held."""
    n = axis.size
    if n == 1 or value <= axis[0]:
        return 0, 0.0
    if value >= axis[n - 1]:
        return n - 2, 1.0
    k = np.searchsorted(axis, value, side="right") - 1
    return k, (value - axis[k]) / (axis[k + 1] - axis[k])


@kernel
def _meet(grid, t, lat, lon):
    """Wind u, v [m/s]: linear in time and bilinear in space; ``grid`` = (time, lat, lon, u, v)."""
    times, lats, lons, u, v = grid
    k, a = _bracket(times, t)
    i, b = _bracket(lats, lat)
    j, c = _bracket(lons, lon)
    east = north = 0.0
    for dk in range(2):
        for di in range(2):
            for dj in range(2):
                weight = (a if dk else 1 - a) * (b if di else 1 - b) * (c if dj else 1 - c)
                if weight > 0.0:
                    east += weight * u[k + dk, i + di, j + dj]
                    north += weight * v[k + dk, i + di, j + dj]
    return east, north


@kernel
def _go(polar, tws, twa, motor_below, motor_speed):
    """Speed [m/s] by a table ``(speeds (w, a), per_tws, per_twa)``, and whether the engine gives it."""
    table, per_tws, per_twa = polar
    x = min(tws * per_tws, table.shape[0] - 1.000001)
    y = min(twa * per_twa, table.shape[1] - 1.000001)
    i, j = int(x), int(y)
    f, g = x - i, y - j
    sail = (table[i, j] * (1 - g) + table[i, j + 1] * g) * (1 - f) + (
        table[i + 1, j] * (1 - g) + table[i + 1, j + 1] * g
    ) * f
    if sail < motor_below and motor_speed > sail:
        return motor_speed, True
    return sail, False


@kernel
def _relative(east, north, course):
    """TWS [m/s], TWD [degrees] and folded TWA [degrees]."""
    tws = np.sqrt(east * east + north * north)
    twd = np.degrees(np.arctan2(-east, -north)) % 360.0
    return tws, twd, abs((twd - course + 180.0) % 360.0 - 180.0)


@kernel
def sail_legs(departure, lat, lon, course, length, hull, grid, polars, engine, step, patience):
    """Sail legs in steps of time, each at the speed of its middle (midpoint rule).

    Parameters
    ----------
    lat, lon
        ``(n,)`` waypoints [degrees].
    course, length, hull
        ``(n - 1,)`` of each leg: degrees true, metres, and whether she makes good the hull of her polar.
    polars
        Tables for sailing straight and for the hull, see `_go`.
    engine
        ``(below, speed)`` [m/s]; below 0 for no engine.
    step, patience
        Seconds between looks at the wind, and the longest time for one leg.

    Returns
    -------
    rows, at, arrived
        ``(m, 9)``: time, lat, lon, course, speed, TWS, TWD, engine (0 or 1), leg; row of each waypoint; and
        whether she arrived.
    """
    below, motor_speed = engine
    rows = np.empty((1024, 9))
    at = np.zeros(lat.size, dtype=np.int64)
    count = 0
    t = departure
    for k in range(lat.size - 1):
        at[k] = count
        polar = polars[1] if hull[k] else polars[0]
        sailed = 0.0
        begin = t
        while True:
            if count + 2 >= rows.shape[0]:
                more = np.empty((2 * rows.shape[0], 9))
                more[:count] = rows[:count]
                rows = more
            f = sailed / length[k] if length[k] > 0.0 else 1.0
            y, x = lat[k] + (lat[k + 1] - lat[k]) * f, lon[k] + (lon[k + 1] - lon[k]) * f
            east, north = _meet(grid, t, y, x)
            tws, twd, twa = _relative(east, north, course[k])
            speed, motor = _go(polar, tws, twa, below, motor_speed)
            rows[count, 0], rows[count, 1], rows[count, 2] = t, y, x
            rows[count, 3], rows[count, 4], rows[count, 5] = course[k], speed, tws
            rows[count, 6], rows[count, 7], rows[count, 8] = twd, motor, k
            count += 1
            rest = length[k] - sailed
            if rest <= 1e-6:
                count -= 1
                break
            if t - begin > patience:
                at[k + 1] = count - 1
                return rows[:count].copy(), at[: k + 2].copy(), False
            half = min(step, rest / speed) / 2 if speed > 0.0 else step / 2
            f = (sailed + speed * half) / length[k]
            y, x = lat[k] + (lat[k + 1] - lat[k]) * f, lon[k] + (lon[k + 1] - lon[k]) * f
            east, north = _meet(grid, t + half, y, x)
            tws, twd, twa = _relative(east, north, course[k])
            speed, motor = _go(polar, tws, twa, below, motor_speed)
            rows[count - 1, 7] = motor
            if speed * step >= rest:
                t += rest / speed
                sailed = length[k]
            else:
                t += step
                sailed += speed * step
    at[lat.size - 1] = count
    count += 1
    return rows[:count].copy(), at, True
