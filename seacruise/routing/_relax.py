"""Compiled loops that pull a passage straight in time: waypoints moved, dropped and put in.

Who reaches a waypoint earlier reaches the end earlier (FIFO), so a move of one waypoint is judged by the
arrival at the next one: two legs to sail, however long the passage is.
"""

from __future__ import annotations

import numpy as np

from seacruise.compiled import kernel
from seacruise.routing._kernels import sail_rhumb
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


@kernel
def _retime(x, y, times, count, since, piece, wind, speeds):
    for k in range(since, count):
        times[k] = sail_rhumb(times[k - 1], x[k - 1], y[k - 1], x[k], y[k], piece, wind, speeds)


@kernel
def _move(x, y, times, count, step, piece, water, frame, wind, speeds):
    """Try to shift each waypoint by ``step`` in twelve directions; returns the seconds gained."""
    gained = 0.0
    for k in range(1, count - 1):
        times[k] = sail_rhumb(times[k - 1], x[k - 1], y[k - 1], x[k], y[k], piece, wind, speeds)
        best = sail_rhumb(times[k], x[k], y[k], x[k + 1], y[k + 1], piece, wind, speeds)
        before = best
        bx, by, at = x[k], y[k], times[k]
        along = np.arctan2(y[k + 1] - y[k - 1], x[k + 1] - x[k - 1])
        ox, oy = x[k], y[k]
        for turn in range(12):
            # Across the course first: along it a waypoint gains next to nothing.
            angle = along + np.pi * (0.5 + turn / 6.0)
            nx, ny = ox + step * np.cos(angle), oy + step * np.sin(angle)
            here = sail_rhumb(times[k - 1], x[k - 1], y[k - 1], nx, ny, piece, wind, speeds)
            if here >= best:
                continue
            then = sail_rhumb(here, nx, ny, x[k + 1], y[k + 1], piece, wind, speeds)
            if (
                then < best - 1e-3
                and _free(water, frame, x[k - 1], y[k - 1], times[k - 1], nx, ny, here)
                and _free(water, frame, nx, ny, here, x[k + 1], y[k + 1], then)
            ):
                best, bx, by, at = then, nx, ny, here
        x[k], y[k], times[k] = bx, by, at
        if before < np.inf:
            gained += before - best
    times[count - 1] = sail_rhumb(
        times[count - 2], x[count - 2], y[count - 2], x[count - 1], y[count - 1], piece, wind, speeds
    )
    return gained


@kernel
def _drop(x, y, times, count, slack, piece, water, frame, wind, speeds):
    """Leave out waypoints where sailing straight on costs at most ``slack`` seconds; give their count."""
    k = 1
    while k < count - 1:
        there = sail_rhumb(times[k], x[k], y[k], x[k + 1], y[k + 1], piece, wind, speeds)
        straight = sail_rhumb(times[k - 1], x[k - 1], y[k - 1], x[k + 1], y[k + 1], piece, wind, speeds)
        if straight <= there + slack and _free(
            water, frame, x[k - 1], y[k - 1], times[k - 1], x[k + 1], y[k + 1], straight
        ):
            for j in range(k, count - 1):
                x[j], y[j] = x[j + 1], y[j + 1]
            count -= 1
        else:
            k += 1
            times[k - 1] = sail_rhumb(
                times[k - 2], x[k - 2], y[k - 2], x[k - 1], y[k - 1], piece, wind, speeds
            )
    return count


@kernel
def _split(x, y, count, longest, most):
    """Put a waypoint into the middle of each leg longer than ``longest``; returns the new count."""
    k = 0
    while k < count - 1 and count < most:
        if np.hypot(x[k + 1] - x[k], y[k + 1] - y[k]) > longest:
            for j in range(count, k + 1, -1):
                x[j], y[j] = x[j - 1], y[j - 1]
            x[k + 1], y[k + 1] = 0.5 * (x[k] + x[k + 2]), 0.5 * (y[k] + y[k + 2])
            count += 1
            k += 1
        k += 1
    return count


@kernel
def relax(x, y, departure, steps, rounds, longest, slack, piece, water, frame, wind, speeds):
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

    Returns
    -------
    x, y
        The waypoints kept.
    """
    most = 4 * x.size + 256
    px, py, times = np.empty(most), np.empty(most), np.empty(most)
    count = x.size
    px[:count], py[:count] = x, y
    times[0] = departure
    _retime(px, py, times, count, 1, piece, wind, speeds)
    count = _drop(px, py, times, count, slack, piece, water, frame, wind, speeds)
    for stage in range(steps.size):
        step = steps[stage]
        count = _split(px, py, count, longest[stage], most - 1)
        _retime(px, py, times, count, 1, piece, wind, speeds)
        for _ in range(rounds):
            gained = _move(px, py, times, count, step, piece, water, frame, wind, speeds)
            if gained < 1.0:
                break
        count = _drop(px, py, times, count, slack, piece, water, frame, wind, speeds)
        _retime(px, py, times, count, 1, piece, wind, speeds)
    return px[:count].copy(), py[:count].copy()


@kernel
def thin(x, y, departure, allowance, piece, water, frame, wind, speeds):
    """Leave out waypoints, the one that costs least first, until the whole costs ``allowance`` seconds.

    Returns
    -------
    x, y
        The waypoints kept.
    """
    px, py, times = x.copy(), y.copy(), np.empty(x.size)
    count = x.size
    times[0] = departure
    _retime(px, py, times, count, 1, piece, wind, speeds)
    latest = times[count - 1] + allowance
    cost = np.empty(x.size)
    stale = np.ones(x.size, dtype=np.bool_)
    while count > 2:
        best = -1
        for k in range(1, count - 1):
            if stale[k]:
                straight = sail_rhumb(
                    times[k - 1], px[k - 1], py[k - 1], px[k + 1], py[k + 1], piece, wind, speeds
                )
                cost[k] = straight - times[k + 1]
                if not _free(
                    water, frame, px[k - 1], py[k - 1], times[k - 1], px[k + 1], py[k + 1], straight
                ):
                    cost[k] = np.inf
                stale[k] = False
            if best < 0 or cost[k] < cost[best]:
                best = k
        if not cost[best] < np.inf:
            break
        # The end decides, not the next waypoint: time lost may be won back, or lost twice.
        t = sail_rhumb(
            times[best - 1], px[best - 1], py[best - 1], px[best + 1], py[best + 1], piece, wind, speeds
        )
        for k in range(best + 2, count):
            t = sail_rhumb(t, px[k - 1], py[k - 1], px[k], py[k], piece, wind, speeds)
        if not t <= latest:
            cost[best] = np.inf
            continue
        for k in range(best, count - 1):
            px[k], py[k] = px[k + 1], py[k + 1]
            cost[k], stale[k] = cost[k + 1], stale[k + 1]
        count -= 1
        stale[best - 1] = True
        stale[best] = True
        _retime(px, py, times, count, best, piece, wind, speeds)
    return px[:count].copy(), py[:count].copy()
