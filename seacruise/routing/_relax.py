"""Compiled loops that pull a passage straight in time: waypoints moved, dropped and put in.

Who reaches a waypoint earlier reaches the end earlier (FIFO), so a move of one waypoint is judged by the
arrival at the next one - where turning costs time, by the time at which she has turned there: two legs to
sail, however long the passage is.

``x``, ``y`` and ``lat`` are the waypoints in the Mercator plane [m] and their latitudes [degrees], which take
as long to reckon as half a mile of sailing.
"""

from __future__ import annotations

import numpy as np

from seacruise.compiled import inlined, kernel
from seacruise.routing._kernels import DEGREES_PER_METRE, latitude, sail_rhumb, wind_at
from seacruise.routing._turning import pause_of
from seacruise.sea._kernels import free_line
from seacruise.sea._prisms import closed


@kernel
def _free(water, frame, x0, y0, t0, x1, y1, t1):
    """Tell whether a leg touches neither land nor a zone valid when she is there.

    ``water`` is ``(arrays of the raster, arrays of the zones)``.
    """
    ox, oy, cell = frame
    raster, zones = water
    if zones[0].size > 1 and closed(zones, x0, y0, t0, x1, y1, t1):
        return False
    return free_line(raster, (x0 - ox) / cell, (y0 - oy) / cell, (x1 - ox) / cell, (y1 - oy) / cell)


@inlined
def _pause(ax, ay, bx, by, cx, cy, t, wind, pauses):
    """Seconds lost by turning at b, reached at time t, from the leg a - b to the leg b - c."""
    if pauses[0] + pauses[1] + pauses[2] == 0.0:
        return 0.0
    span0 = max(np.hypot(bx - ax, by - ay), 1e-9)
    span1 = max(np.hypot(cx - bx, cy - by), 1e-9)
    u, v = wind_at(t, latitude(by), bx * DEGREES_PER_METRE, wind)
    return pause_of((bx - ax) / span0, (by - ay) / span0, (cx - bx) / span1, (cy - by) / span1, u, v, pauses)


@kernel
def _through(x, y, lat, t, k, nx, ny, nlat, count, latest, piece, wind, speeds, pauses):
    """Time of leaving waypoint k + 1 when k lies at ``nx, ny`` and k - 1 is reached at time t.

    Who is not at k before ``latest`` need not sail on.

    Returns
    -------
    here, then, leave
        Arrival at k, at k + 1, and the time at which she has turned there.
    """
    if k > 1:
        t += _pause(x[k - 2], y[k - 2], x[k - 1], y[k - 1], nx, ny, t, wind, pauses)
    here = sail_rhumb(t, x[k - 1], y[k - 1], lat[k - 1], nx, ny, nlat, piece, wind, speeds)
    if here >= latest:
        return here, np.inf, np.inf
    leave = here + _pause(x[k - 1], y[k - 1], nx, ny, x[k + 1], y[k + 1], here, wind, pauses)
    then = sail_rhumb(leave, nx, ny, nlat, x[k + 1], y[k + 1], lat[k + 1], piece, wind, speeds)
    leave = then
    if k + 2 < count:
        leave += _pause(nx, ny, x[k + 1], y[k + 1], x[k + 2], y[k + 2], then, wind, pauses)
    return here, then, leave


@kernel
def _straight(x, y, lat, t, k, count, piece, wind, speeds, pauses):
    """`_through` without waypoint k: arrival at k + 1, and the time at which she has turned there."""
    if k > 1:
        t += _pause(x[k - 2], y[k - 2], x[k - 1], y[k - 1], x[k + 1], y[k + 1], t, wind, pauses)
    then = sail_rhumb(t, x[k - 1], y[k - 1], lat[k - 1], x[k + 1], y[k + 1], lat[k + 1], piece, wind, speeds)
    leave = then
    if k + 2 < count:
        leave += _pause(x[k - 1], y[k - 1], x[k + 1], y[k + 1], x[k + 2], y[k + 2], then, wind, pauses)
    return then, leave


@kernel
def latitudes(y):
    """Latitudes ``(n,)`` [degrees]."""
    lat = np.empty(y.size)
    for k in range(y.size):
        lat[k] = latitude(y[k])
    return lat


@kernel
def retime(x, y, lat, times, count, since, piece, wind, speeds, pauses):
    """Fill in the arrivals from waypoint ``since`` on; turns are paid for at the waypoints between."""
    for k in range(since, count):
        t = times[k - 1]
        if k > 1:
            t += _pause(x[k - 2], y[k - 2], x[k - 1], y[k - 1], x[k], y[k], t, wind, pauses)
        times[k] = sail_rhumb(t, x[k - 1], y[k - 1], lat[k - 1], x[k], y[k], lat[k], piece, wind, speeds)


@kernel
def _move(x, y, lat, times, count, step, moved, piece, water, frame, wind, speeds, pauses):
    """Try to shift each waypoint by ``step`` in twelve directions; returns the seconds gained.

    ``moved`` tells which waypoints moved in the last round, and is renewed: where neither a waypoint nor its
    neighbours did, there is nothing new to try.
    """
    gained = 0.0
    # What a turn costs depends on the waypoint after the next one, too.
    around = 2 if pauses[0] + pauses[1] + pauses[2] > 0.0 else 1
    for k in range(1, count - 1):
        worth = False
        for near in range(max(1, k - around), min(count - 1, k + around + 1)):
            worth = worth or moved[near] > 0
        if not worth:
            retime(x, y, lat, times, k + 1, k, piece, wind, speeds, pauses)
            continue
        times[k], _, best = _through(
            x, y, lat, times[k - 1], k, x[k], y[k], lat[k], count, np.inf, piece, wind, speeds, pauses
        )
        before = best
        bx, by, blat, at = x[k], y[k], lat[k], times[k]
        along = np.arctan2(y[k + 1] - y[k - 1], x[k + 1] - x[k - 1])
        ox, oy = x[k], y[k]
        for turn in range(12):
            # Across the course first: along it a waypoint gains next to nothing.
            angle = along + np.pi * (0.5 + turn / 6.0)
            nx, ny = ox + step * np.cos(angle), oy + step * np.sin(angle)
            nlat = latitude(ny)
            here, then, leave = _through(
                x, y, lat, times[k - 1], k, nx, ny, nlat, count, best, piece, wind, speeds, pauses
            )
            if (
                leave < best - 1e-3
                and _free(water, frame, x[k - 1], y[k - 1], times[k - 1], nx, ny, here)
                and _free(water, frame, nx, ny, here, x[k + 1], y[k + 1], then)
            ):
                best, bx, by, blat, at = leave, nx, ny, nlat, here
        if bx != ox or by != oy:
            # In this round; those of the last one still count for the waypoints to come.
            moved[k] = 2
        x[k], y[k], lat[k], times[k] = bx, by, blat, at
        if before < np.inf:
            gained += before - best
    for k in range(1, count - 1):
        moved[k] = 1 if moved[k] == 2 else 0
    retime(x, y, lat, times, count, count - 1, piece, wind, speeds, pauses)
    return gained


@kernel
def _drop(x, y, lat, times, count, slack, piece, water, frame, wind, speeds, pauses):
    """Leave out waypoints where sailing straight on costs at most ``slack`` seconds; give their count."""
    k = 1
    while k < count - 1:
        _, _, there = _through(
            x, y, lat, times[k - 1], k, x[k], y[k], lat[k], count, np.inf, piece, wind, speeds, pauses
        )
        then, straight = _straight(x, y, lat, times[k - 1], k, count, piece, wind, speeds, pauses)
        if straight <= there + slack and _free(
            water, frame, x[k - 1], y[k - 1], times[k - 1], x[k + 1], y[k + 1], then
        ):
            for j in range(k, count - 1):
                x[j], y[j], lat[j] = x[j + 1], y[j + 1], lat[j + 1]
            count -= 1
        else:
            k += 1
            retime(x, y, lat, times, k, k - 1, piece, wind, speeds, pauses)
    return count


@kernel
def _split(x, y, lat, count, longest, most):
    """Put a waypoint into the middle of each leg longer than ``longest``; returns the new count."""
    k = 0
    while k < count - 1 and count < most:
        if np.hypot(x[k + 1] - x[k], y[k + 1] - y[k]) > longest:
            for j in range(count, k + 1, -1):
                x[j], y[j], lat[j] = x[j - 1], y[j - 1], lat[j - 1]
            x[k + 1], y[k + 1] = 0.5 * (x[k] + x[k + 2]), 0.5 * (y[k] + y[k + 2])
            lat[k + 1] = latitude(y[k + 1])
            count += 1
            k += 1
        k += 1
    return count


@kernel
def relax(x, y, departure, steps, rounds, longest, slack, piece, water, frame, wind, speeds, pauses):
    """Relax a line of waypoints continuously, with steps from coarse to fine, without touching land.

    Parameters
    ----------
    x, y
        ``(m,)`` waypoints in the Mercator plane [m].
    steps
        Lengths of the trial moves [m of the plane], falling.
    rounds
        Most sweeps over the waypoints for each step.
    longest
        ``(k,)`` for each step: legs longer than this [m of the plane] are split before they are moved.
    slack
        Seconds that dropping a waypoint may cost.
    pauses
        Seconds that turning costs, see `seacruise.routing._turning`.

    Returns
    -------
    x, y
        The waypoints kept.
    """
    most = 4 * x.size + 256
    px, py, lat, times = np.empty(most), np.empty(most), np.empty(most), np.empty(most)
    moved = np.empty(most, dtype=np.int8)
    count = x.size
    px[:count], py[:count], lat[:count] = x, y, latitudes(y)
    times[0] = departure
    retime(px, py, lat, times, count, 1, piece, wind, speeds, pauses)
    count = _drop(px, py, lat, times, count, slack, piece, water, frame, wind, speeds, pauses)
    for stage in range(steps.size):
        step = steps[stage]
        count = _split(px, py, lat, count, longest[stage], most - 1)
        retime(px, py, lat, times, count, 1, piece, wind, speeds, pauses)
        moved[:] = 1
        for _ in range(rounds):
            gained = _move(px, py, lat, times, count, step, moved, piece, water, frame, wind, speeds, pauses)
            if gained < 1.0:
                break
        count = _drop(px, py, lat, times, count, slack, piece, water, frame, wind, speeds, pauses)
        retime(px, py, lat, times, count, 1, piece, wind, speeds, pauses)
    return px[:count].copy(), py[:count].copy()


@kernel
def thin(x, y, departure, allowance, piece, water, frame, wind, speeds, pauses):
    """Leave out waypoints, the one that costs least first, until the whole costs ``allowance`` seconds.

    Returns
    -------
    x, y
        The waypoints kept.
    """
    px, py, lat, times = x.copy(), y.copy(), latitudes(y), np.empty(x.size)
    count = x.size
    times[0] = departure
    retime(px, py, lat, times, count, 1, piece, wind, speeds, pauses)
    latest = times[count - 1] + allowance
    cost = np.empty(x.size)
    stale = np.ones(x.size, dtype=np.bool_)
    trial_x, trial_y, trial = np.empty(x.size), np.empty(x.size), np.empty(x.size)
    trial_lat = np.empty(x.size)
    while count > 2:
        best = -1
        for k in range(1, count - 1):
            if stale[k]:
                _, _, there = _through(
                    px,
                    py,
                    lat,
                    times[k - 1],
                    k,
                    px[k],
                    py[k],
                    lat[k],
                    count,
                    np.inf,
                    piece,
                    wind,
                    speeds,
                    pauses,
                )
                then, straight = _straight(px, py, lat, times[k - 1], k, count, piece, wind, speeds, pauses)
                cost[k] = straight - there
                if not _free(water, frame, px[k - 1], py[k - 1], times[k - 1], px[k + 1], py[k + 1], then):
                    cost[k] = np.inf
                stale[k] = False
            if best < 0 or cost[k] < cost[best]:
                best = k
        if not cost[best] < np.inf:
            break
        # The end decides, not the next waypoint: time lost may be won back, or lost twice.
        trial_x[:best], trial_x[best : count - 1] = px[:best], px[best + 1 : count]
        trial_y[:best], trial_y[best : count - 1] = py[:best], py[best + 1 : count]
        trial_lat[:best], trial_lat[best : count - 1] = lat[:best], lat[best + 1 : count]
        trial[:best] = times[:best]
        retime(trial_x, trial_y, trial_lat, trial, count - 1, best, piece, wind, speeds, pauses)
        if not trial[count - 2] <= latest:
            cost[best] = np.inf
            continue
        cost[best : count - 1] = cost[best + 1 : count].copy()
        stale[best : count - 1] = stale[best + 1 : count].copy()
        count -= 1
        px[:count], py[:count], times[:count] = trial_x[:count], trial_y[:count], trial[:count]
        lat[:count] = trial_lat[:count]
        # Turns reach two waypoints back and on.
        for k in range(max(1, best - 2), min(count - 1, best + 2)):
            stale[k] = True
    return px[:count].copy(), py[:count].copy()
