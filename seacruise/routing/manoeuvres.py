"""Beats and runs as they are sailed: the tacking hull turned into real tacks and gybes.

The search makes good the convex hull of the polar. Where a leg lies inside the dead angle, or dead before
the wind, that speed is a mix of two headings; here such legs become boards on those headings, each pair
of boards ending on the leg, and no board touching land.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import from_mercator, scale
from seacruise.sea import Sea
from seacruise.units import METRES_PER_NM
from seacruise.weather.wind import Wind, to_direction
from seacruise.yacht.hull import hull_headings
from seacruise.yacht.polar import Polar

Array = NDArray[np.float64]

PAIR_S: Final = 3 * 3600.0
"""A pair of boards usually takes this long [s]: the crew goes about every hour and a half."""

SHORTEST_PAIR_S: Final = 600.0
"""In narrow water boards get shorter, but a pair never takes less than this [s]."""

GAIN: Final = 1.002
"""A leg is tacked where that is at least 0.2 % faster than sailing it straight."""


@dataclass(frozen=True, slots=True, eq=False)
class Course:
    """Waypoints as they are sailed.

    Attributes
    ----------
    x, y
        ``(n,)`` in the Mercator plane [m].
    short_tacked
        ``(n - 1,)`` legs too narrow to plan the boards: she makes good the hull of her polar there.
    """

    x: Array
    y: Array
    short_tacked: NDArray[np.bool_]


def sail_boards(x: Array, y: Array, times: Array, sea: Sea, wind: Wind, polar: Polar) -> Course:
    """Replace each leg that is sailed on the hull by boards on the two headings of the hull.

    Parameters
    ----------
    x, y, times
        ``(n,)`` waypoints of the Mercator plane [m] and arrival there [s since 1970].
    """
    out: list[tuple[float, float]] = [(float(x[0]), float(y[0]))]
    short: list[bool] = []
    other_first = False
    for k in range(x.size - 1):
        a, b = np.array([x[k], y[k]]), np.array([x[k + 1], y[k + 1]])
        pieces = max(1, round((times[k + 1] - times[k]) / PAIR_S))
        straight = a
        for p in range(pieces):
            c = a + (b - a) * (p + 1) / pieces
            t = times[k] + (times[k + 1] - times[k]) * (p + 0.5) / pieces
            boards, other_first = _boards(
                straight, c, float(t), (times[k + 1] - times[k]) / pieces, sea, wind, polar, other_first
            )
            if boards is None:
                tight = _hull_gain((straight + c) / 2, c - straight, float(t), wind, polar)[0] >= GAIN
                if tight or p == pieces - 1 or (short and short[-1]):
                    out.append((float(c[0]), float(c[1])))
                    short.append(tight)
                else:
                    continue
            else:
                if out[-1] != (float(straight[0]), float(straight[1])):
                    out.append((float(straight[0]), float(straight[1])))
                    short.append(False)
                out.extend(boards)
                short.extend([False] * len(boards))
            straight = c
    points = np.array(out)
    return merge_straight(Course(points[:, 0], points[:, 1], np.array(short, dtype=bool)))


def _hull_gain(
    middle: Array, vector: Array, t: float, wind: Wind, polar: Polar
) -> tuple[float, tuple[float, float, float, float], float, float]:
    """How much faster than straight the hull is, its headings and shares, TWS [m/s] and TWD [degrees]."""
    lat, lon = from_mercator(*middle)
    u, v = wind.at(t, lat, lon)
    tws, twd = (float(c) for c in to_direction(u, v))
    course = float(np.degrees(np.arctan2(vector[0], vector[1])))
    twa = (twd - course + 180.0) % 360.0 - 180.0
    first, share1, second, share2 = (float(c) for c in hull_headings(polar, tws, twa))
    direct = float(polar.speed(tws, twa))
    made = share1 * float(polar.speed(tws, first)) * np.cos(np.radians(first - twa)) + share2 * float(
        polar.speed(tws, second)
    ) * np.cos(np.radians(second - twa))
    gain = made / direct if direct > 1e-9 else (np.inf if made > 1e-9 else 1.0)
    return float(gain), (first, share1, second, share2), tws, twd


def _boards(
    a: Array, b: Array, t: float, seconds: float, sea: Sea, wind: Wind, polar: Polar, other_first: bool
) -> tuple[list[tuple[float, float]] | None, bool]:
    """Corners of the boards from a to b (ends with b), or ``None`` where she sails straight.

    Every second pair begins with the heading on which the last one ended, which halves the tacks.
    """
    gain, (first, share1, second, share2), _, twd = _hull_gain((a + b) / 2, b - a, t, wind, polar)
    if gain < GAIN or min(share1, share2) <= 0.0:
        return None, other_first
    headings = np.radians([twd - first, twd - second])
    unit = np.array([np.sin(headings), np.cos(headings)])
    legs = np.linalg.solve(unit, b - a)
    if min(legs) <= 0.0:
        return None, other_first
    pairs = 1
    while seconds / pairs >= SHORTEST_PAIR_S or pairs == 1:
        for swap in (other_first, not other_first):
            corners, last = _zigzag(a, unit * legs / pairs, pairs, swap)
            points = np.vstack([a, corners])
            if bool(sea.clear(np.hstack([points[:-1], points[1:]])).all()):
                return [(float(px), float(py)) for px, py in corners], last
        pairs *= 2
    return None, other_first


def _zigzag(a: Array, steps: Array, pairs: int, swap: bool) -> tuple[Array, bool]:
    corners = []
    here = a
    for _ in range(pairs):
        order = (1, 0) if swap else (0, 1)
        for k in order:
            here = here + steps[:, k]
            corners.append(here)
        swap = not swap
    return np.array(corners), swap


def merge_straight(course: Course, *, degrees: float = 0.05) -> Course:
    """Join legs between which the course does not change."""
    keep = [0]
    for k in range(1, course.x.size - 1):
        before = np.arctan2(course.x[k] - course.x[keep[-1]], course.y[k] - course.y[keep[-1]])
        after = np.arctan2(course.x[k + 1] - course.x[k], course.y[k + 1] - course.y[k])
        turn = abs((np.degrees(after - before) + 180.0) % 360.0 - 180.0)
        if turn > degrees or course.short_tacked[k] != course.short_tacked[k - 1]:
            keep.append(k)
    keep.append(course.x.size - 1)
    return Course(course.x[keep], course.y[keep], course.short_tacked[keep[:-1]])


def count_turns(course_deg: Array, twd_deg: Array, sailing: NDArray[np.bool_]) -> tuple[int, int]:
    """Count tacks and gybes between legs: the wind changes its side, over the bow or over the stern.

    Parameters
    ----------
    course_deg, twd_deg
        ``(n,)`` course of each leg, and the wind's direction where it begins [degrees].
    sailing
        ``(n,)`` ``False`` for legs under engine: going about under engine is no tack.
    """
    tacks = gybes = 0
    for k in range(1, course_deg.size):
        if not (sailing[k - 1] and sailing[k]):
            continue
        before = (twd_deg[k] - course_deg[k - 1] + 180.0) % 360.0 - 180.0
        after = (twd_deg[k] - course_deg[k] + 180.0) % 360.0 - 180.0
        if before * after < 0.0:
            if abs(before) + abs(after) < 180.0:
                tacks += 1
            else:
                gybes += 1
    return tacks, gybes


def true_length_nm(x: Array, y: Array) -> Array:
    """Lengths of the legs between points of the Mercator plane [nm]."""
    lat, _ = from_mercator(x, y)
    return np.asarray(np.hypot(np.diff(x), np.diff(y)) * scale((lat[:-1] + lat[1:]) / 2) / METRES_PER_NM)
