"""Compiled stepping of a yacht along her finished legs; see `seacruise.routing.resail`.

Shares nothing with the search's kernels: the forecast's own grid and times instead of slices, a polar by
angle instead of cosine, steps of time instead of pieces of way.
"""

from __future__ import annotations

import numpy as np

from seacruise.compiled import kernel
from seacruise.yacht.knobs import LEAST_SHARE


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
def _go(polar, tws, twa, engine):
    """Speed [m/s] by a table ``(speeds (w, a), per_tws, per_twa)``, and whether the engine gives it.

    ``engine`` is ``(below, speed, ease, rough)``: when it starts and what it gives [m/s], the share of the
    speed that the night leaves here and now, and the one that waves take head to sea.
    """
    table, per_tws, per_twa = polar
    motor_below, motor_speed, ease, rough = engine
    x = min(tws * per_tws, table.shape[0] - 1.000001)
    y = min(twa * per_twa, table.shape[1] - 1.000001)
    i, j = int(x), int(y)
    f, g = x - i, y - j
    sail = (table[i, j] * (1 - g) + table[i, j + 1] * g) * (1 - f) + (
        table[i + 1, j] * (1 - g) + table[i + 1, j + 1] * g
    ) * f
    sail *= ease * max(1.0 - rough * (1.0 + np.cos(np.radians(twa))) ** 2 / 4.0, LEAST_SHARE)
    if sail < motor_below and motor_speed > sail:
        return motor_speed, True
    return sail, False


@kernel
def _steer(polar, tws, twd, course, set_east, set_north, engine):
    """Heading [degrees] and speed made good [m/s] on a course in moving water; wind as the water feels it.

    Headings are tried degree by degree within a right angle of the course; where the yacht's drift across
    it changes its sign the crossing is halved until it is known to a hundredth of a degree. Of several
    headings the one is steered that gets her on fastest. The speed is 0 where there is none.
    """
    to_north, to_east = np.cos(np.radians(course)), np.sin(np.radians(course))
    across = set_east * to_north - set_north * to_east
    best, heading = 0.0, course
    low_drift = 0.0
    for degree in range(-90, 91):
        speed, _ = _go(polar, tws, abs((twd - course - degree + 180.0) % 360.0 - 180.0), engine)
        drift = speed * np.sin(np.radians(degree)) + across
        if degree > -90 and low_drift * drift <= 0.0:
            low, high, at_low = degree - 1.0, float(degree), low_drift
            for _ in range(14):
                middle = 0.5 * (low + high)
                speed, _ = _go(polar, tws, abs((twd - course - middle + 180.0) % 360.0 - 180.0), engine)
                here = speed * np.sin(np.radians(middle)) + across
                if at_low * here <= 0.0:
                    high = middle
                else:
                    low, at_low = middle, here
            made = speed * np.cos(np.radians(middle)) + set_east * to_east + set_north * to_north
            # Where the polar jumps, drift changes its sign without ever being nought.
            if made > best and abs(here) < 0.05:
                best, heading = made, course + middle
        low_drift = drift
    return heading % 360.0, best


@kernel
def _sail(polar, air, water, course, engine, t, lat, lon):
    """How she sails here and now on a course.

    Returns
    -------
    made, speed, motor, tws, twd, heading, east, north
        Speed over ground and through water [m/s], engine, wind over ground, course steered, and current.
    """
    east, north = _meet(air, t, lat, lon)
    below, motor_speed, light, waves = engine
    ease, rough = 1.0, 0.0
    if light[3].shape[0] > 0:
        ease, _ = _meet(light, t, lat, lon)
    if waves[3].shape[0] > 0:
        rough, _ = _meet(waves, t, lat, lon)
    now = (below, motor_speed, ease, rough)
    tws, twd, twa = _relative(east, north, course)
    set_east = set_north = 0.0
    if water[3].shape[0] > 0:
        set_east, set_north = _meet(water, t, lat, lon)
    if set_east == 0.0 and set_north == 0.0:
        speed, motor = _go(polar, tws, twa, now)
        return speed, speed, motor, tws, twd, course, 0.0, 0.0
    felt, felt_from, _ = _relative(east - set_east, north - set_north, course)
    heading, made = _steer(polar, felt, felt_from, course, set_east, set_north, now)
    speed, motor = _go(polar, felt, abs((felt_from - heading + 180.0) % 360.0 - 180.0), now)
    return made, speed, motor, tws, twd, heading, set_east, set_north


@kernel
def _turn(before, after, tws, twd, sailing, pauses):
    """Seconds that turning from a course to the next one takes; no tack is sailed under engine."""
    tack, gybe, per_degree = pauses
    turn = abs((after - before + 180.0) % 360.0 - 180.0)
    side0 = (twd - before + 180.0) % 360.0 - 180.0
    side1 = (twd - after + 180.0) % 360.0 - 180.0
    seconds = turn * per_degree
    if sailing and tws > 0.0 and side0 * side1 < 0.0:
        seconds += tack if abs(side0) + abs(side1) < 180.0 else gybe
    return seconds


@kernel
def _relative(east, north, course):
    """TWS [m/s], TWD [degrees] and folded TWA [degrees]."""
    tws = np.sqrt(east * east + north * north)
    twd = np.degrees(np.arctan2(-east, -north)) % 360.0
    return tws, twd, abs((twd - course + 180.0) % 360.0 - 180.0)


@kernel
def sail_legs(
    departure, lat, lon, course, length, hull, air, water, polars, engine, pauses, step, shortest, patience
):
    """Sail legs in steps of time, each at the speed of its middle (midpoint rule).

    Parameters
    ----------
    lat, lon
        ``(n,)`` waypoints [degrees].
    course, length, hull
        ``(n - 1,)`` of each leg: degrees true, metres, and whether she makes good the hull of her polar.
    air, water
        Grids of wind and current, see `_meet`; the current's without times where there is none.
    polars
        Tables for sailing straight and for the hull, see `_go`.
    engine
        ``(below, speed, light, waves)``: when it starts, below 0 for no engine, and what it gives [m/s]; and
        grids, see `_meet`, of the share of her speed that the night leaves and of the one that waves take
        head to sea, without times where neither does.
    pauses
        Seconds for a tack, a gybe, and each degree of a turn; she does not get on meanwhile.
    step, shortest, patience
        Seconds between looks at the wind; the shortest step, taken where her speed changes much in one;
        and the longest time for one leg.

    Returns
    -------
    rows, at, arrived, paused
        ``(m, 13)``: time, lat, lon, course, speed through water, TWS, TWD, engine (0 or 1), leg, speed over
        ground, course steered, current east and north; row of each waypoint; whether she arrived; and the
        seconds that manoeuvres took.
    """
    rows = np.empty((1024, 13))
    at = np.zeros(lat.size, dtype=np.int64)
    count = 0
    t = departure
    paused = 0.0
    sailing = False
    for k in range(lat.size - 1):
        at[k] = count
        polar = polars[1] if hull[k] else polars[0]
        sailed = 0.0
        begin = t
        fresh = k > 0 and pauses[0] + pauses[1] + pauses[2] > 0.0
        while True:
            if count + 3 >= rows.shape[0]:
                more = np.empty((2 * rows.shape[0], 13))
                more[:count] = rows[:count]
                rows = more
            f = sailed / length[k] if length[k] > 0.0 else 1.0
            y, x = lat[k] + (lat[k + 1] - lat[k]) * f, lon[k] + (lon[k + 1] - lon[k]) * f
            made, speed, motor, tws, twd, heading, east, north = _sail(
                polar, air, water, course[k], engine, t, y, x
            )
            rows[count, 0], rows[count, 1], rows[count, 2] = t, y, x
            rows[count, 3], rows[count, 4], rows[count, 5] = course[k], speed, tws
            rows[count, 6], rows[count, 7], rows[count, 8] = twd, motor, k
            rows[count, 9], rows[count, 10], rows[count, 11], rows[count, 12] = made, heading, east, north
            count += 1
            if fresh:
                fresh = False
                pause = _turn(course[k - 1], course[k], tws, twd, sailing and not motor, pauses)
                if pause > 0.0:
                    rows[count - 1, 4] = rows[count - 1, 9] = 0.0
                    t += pause
                    paused += pause
                    continue
            rest = length[k] - sailed
            if rest <= 1e-6:
                count -= 1
                break
            if t - begin > patience:
                at[k + 1] = count - 1
                return rows[:count].copy(), at[: k + 2].copy(), False, paused
            span = step
            while True:
                half = min(span, rest / made) / 2 if made > 0.0 else span / 2
                f = min((sailed + made * half) / length[k], 1.0)
                y, x = lat[k] + (lat[k + 1] - lat[k]) * f, lon[k] + (lon[k + 1] - lon[k]) * f
                middle, _, motor, _, _, _, _, _ = _sail(polar, air, water, course[k], engine, t + half, y, x)
                # A front or the end of a calm within the step: come nearer to it.
                later = middle
                if made == 0.0:
                    later, _, _, _, _, _, _, _ = _sail(polar, air, water, course[k], engine, t + span, y, x)
                if span <= shortest or abs(max(middle, later) - made) <= 0.1 * max(middle, later, made):
                    break
                span *= 0.5
            sailing = not motor
            rows[count - 1, 7] = motor
            if middle * span >= rest:
                t += rest / middle
                sailed = length[k]
            else:
                t += span
                sailed += middle * span
    at[lat.size - 1] = count
    count += 1
    return rows[:count].copy(), at, True, paused
