"""Beats and runs as they are sailed: the tacking hull turned into real tacks and gybes.

The search makes good the convex hull of the polar. Where a leg lies inside the dead angle, or dead before
the wind, that speed is a mix of two headings; here such legs become boards on those headings, each pair
of boards ending on the leg, and no board touching land.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import from_mercator, rhumb_distance_m, scale
from seacruise.routing.field import tacking_may_gain
from seacruise.routing.refine import QUICKLY, THOROUGHLY, Line, Waters, relaxed, timed
from seacruise.sea import Sea
from seacruise.sea.zones import Zones
from seacruise.units import METRES_PER_NM
from seacruise.weather.wind import to_direction
from seacruise.yacht.hull import hull_headings
from seacruise.yacht.polar import Polar

if TYPE_CHECKING:
    from seacruise.routing.find import Question

Array = NDArray[np.float64]

SHORTEST_PAIR_S: Final = 360.0
"""In narrow water boards get shorter, but a pair never takes less than this [s]."""

SLACK_S: Final = 1800.0
"""Boards may be sailed this much earlier or later than planned, and meet no zone all the same [s]."""

_GUESSED: Final = 4.0

SAME_COURSE_DEG: Final = 1.0
"""Courses that differ by less are one leg to a helmsman."""

GAIN: Final = 1.005
"""A leg is tacked where that is at least 0.5 % faster than sailing it straight."""


@dataclass(frozen=True, slots=True)
class Boards:
    """How long the boards of a beat or run are, as the crew likes it.

    Attributes
    ----------
    usual_s
        In open water she goes about this often [s].
    shortest_s
        In open water a board shorter than this is put off and joined to the next one [s].
    """

    usual_s: float = 5400.0
    shortest_s: float = 900.0


USUAL: Final = Boards()


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


def straight_legs(line: Line) -> Course:
    """Every leg of a line sailed straight."""
    return Course(line.x, line.y, np.zeros(line.x.size - 1, dtype=bool))


def sail_boards(asked: Question, line: Line) -> Course:
    """Replace each leg that is sailed on the hull by boards on the two headings of the hull."""
    builder = _Builder(asked, (float(line.x[0]), float(line.y[0])))
    pieces = _pieces(asked, line)
    for piece, after in zip(pieces, [*pieces[1:], None], strict=True):
        builder.add(piece, put_off=after is not None and after.gain >= GAIN)
    return merge_straight(builder.course(), asked.sea, asked.zones)


def relax_boards(waters: Waters, course: Course, departure: float, *, quickly: bool = False) -> Course:
    """Move the corners of boards to where the wind makes them fastest.

    Boards are laid out in the wind of their middle; it shifts meanwhile. What lies between two legs that are
    too narrow for boards is relaxed with the polar as it is.

    Parameters
    ----------
    waters
        With the speeds of the polar itself, not of its hull.
    departure
        Seconds since 1970.
    """
    cuts = np.flatnonzero(np.diff(np.concatenate([[True], course.short_tacked, [True]]).astype(int)))
    x, y, short = [course.x[:1]], [course.y[:1]], [np.zeros(0, dtype=bool)]
    t, k = departure, 0
    for begin, end in cuts.reshape(-1, 2).tolist():
        # From corner k to ``begin`` she makes good the hull; when she is there is only a guess of the wind.
        t += (
            float(np.hypot(np.diff(course.x[k : begin + 1]), np.diff(course.y[k : begin + 1])).sum())
            / _GUESSED
        )
        line = relaxed(
            waters,
            timed(waters, course.x[begin : end + 1], course.y[begin : end + 1], t),
            split=False,
            pull=QUICKLY if quickly else THOROUGHLY,
        )
        x += [course.x[k + 1 : begin + 1], line.x[1:]]
        y += [course.y[k + 1 : begin + 1], line.y[1:]]
        short += [np.ones(begin - k, dtype=bool), np.zeros(line.x.size - 1, dtype=bool)]
        t, k = float(line.times[-1]), end
    rest = course.x.size - 1 - k
    x, y = [*x, course.x[k + 1 :]], [*y, course.y[k + 1 :]]
    short.append(np.ones(rest, dtype=bool))
    return Course(np.concatenate(x), np.concatenate(y), np.concatenate(short))


@dataclass(frozen=True, slots=True, eq=False)
class _Piece:
    """Part of a leg, a to b ``(2,)`` [m of the plane], ``gain`` times as fast on the hull.

    ``begin`` and ``end`` are seconds since 1970; ``headings`` ``(2, 2)`` holds the direction of each
    heading in a column.
    """

    a: Array
    b: Array
    begin: float
    end: float
    gain: float
    headings: Array

    @property
    def seconds(self) -> float:
        return self.end - self.begin


def _pieces(asked: Question, line: Line) -> list[_Piece]:
    """Cut a line into pieces of about a pair of boards and find the best headings in each one's middle."""
    polar = asked.polar
    pair_s = 2.0 * asked.how.boards.usual_s
    cuts = [max(1, round(float(seconds) / pair_s)) for seconds in np.diff(line.times)]
    shares = np.concatenate([k + np.arange(n) / n for k, n in enumerate(cuts)] + [[float(len(cuts))]])
    nodes = np.arange(line.x.size)
    x, y, t = (np.interp(shares, nodes, axis) for axis in (line.x, line.y, line.times))
    lat, lon = from_mercator((x[1:] + x[:-1]) / 2, (y[1:] + y[:-1]) / 2)
    when = (t[1:] + t[:-1]) / 2
    u, v = asked.wind.at(when, lat, lon)
    # Through the water she goes where she goes over ground less what the current does.
    east, north = np.diff(x), np.diff(y)
    drift = (np.zeros_like(u), np.zeros_like(v))
    if asked.current is not None:
        drift = asked.current.at(when, lat, lon)
        per_s = scale(lat) / np.maximum(np.diff(t), 1.0)
        east, north = east * per_s - drift[0], north * per_s - drift[1]
    tws, twd = to_direction(u - drift[0], v - drift[1])
    twa = (twd - np.degrees(np.arctan2(east, north)) + 180.0) % 360.0 - 180.0
    first, share, second, other = _headings(polar, tws, twa)
    made = share * polar.speed(tws, first) * np.cos(np.radians(first - twa))
    made += other * polar.speed(tws, second) * np.cos(np.radians(second - twa))
    direct = polar.speed(tws, twa)
    with np.errstate(divide="ignore", invalid="ignore"):
        gain = np.where(other > 0.0, np.where(direct > 0.0, made / direct, np.inf), 1.0)
    handling = asked.how.handling
    if handling.motor_below is not None:
        # The engine takes her there straight, faster than boards would.
        gain[made * handling.share < min(handling.motor_below, handling.motor_speed)] = 1.0
    courses = np.radians([twd - first, twd - second])
    speeds = np.array([polar.speed(tws, first), polar.speed(tws, second)])
    headings = np.array([np.sin(courses) * speeds + drift[0], np.cos(courses) * speeds + drift[1]])
    headings /= np.maximum(np.hypot(*headings), 1e-9)
    points = np.stack([x, y], axis=1)
    return [
        _Piece(points[k], points[k + 1], float(t[k]), float(t[k + 1]), float(gain[k]), headings[:, :, k])
        for k in range(gain.size)
    ]


def _headings(polar: Polar, tws: Array, twa: Array) -> tuple[Array, Array, Array, Array]:
    """`hull_headings`, asked only where it may matter: sailing straight is all the rest can do."""
    first, share, second, other = twa.copy(), np.ones(twa.size), twa.copy(), np.zeros(twa.size)
    worth = tacking_may_gain(polar, tws, twa, least=(GAIN - 1.0) / 2.0)
    if worth.any():
        first[worth], share[worth], second[worth], other[worth] = hull_headings(polar, tws[worth], twa[worth])
    return first, share, second, other


class _Builder:
    """Collects the corners of a course; `sail_boards` is its only user."""

    def __init__(self, asked: Question, start: tuple[float, float]) -> None:
        self.sea, self.zones = asked.sea, asked.zones
        self.shortest_s = asked.how.boards.shortest_s
        self.corners = [start]
        self.short: list[bool] = []
        self.other_first = False

    def course(self) -> Course:
        """Give what was collected."""
        points = np.array(self.corners)
        return Course(points[:, 0], points[:, 1], np.array(self.short, dtype=bool))

    def add(self, piece: _Piece, *, put_off: bool) -> None:
        """Sail a piece: straight, on boards, or - where there is no room - halves of it on their own.

        With ``put_off`` a short second board may be left to the next piece, which then begins beside its
        own line: from there, or, if that is no good, after the board that was put off.
        """
        here = np.array(self.corners[-1])
        beside = bool(np.hypot(*(here - piece.a)) > 1.0)
        points = self._sailed(here, piece, put_off=put_off)
        if points is None and beside:
            self._append(piece.a[None, :], short=False)
            points = self._sailed(piece.a, piece, put_off=put_off)
        if points is not None:
            self._append(points, short=False)
        elif piece.seconds > 2 * SHORTEST_PAIR_S:
            middle, half = (piece.a + piece.b) / 2, (piece.begin + piece.end) / 2
            self.add(replace(piece, b=middle, end=half), put_off=False)
            self.add(replace(piece, a=middle, begin=half), put_off=put_off)
        else:
            self._append(piece.b[None, :], short=True)

    def _append(self, points: Array, *, short: bool) -> None:
        self.corners.extend((float(x), float(y)) for x, y in points)
        self.short.extend([short] * len(points))

    def _sailed(self, here: Array, piece: _Piece, *, put_off: bool) -> Array | None:
        """Corners from here to the end of a piece; ``None`` where land or the wind forbid it."""
        if piece.gain < GAIN:
            on_line = np.array_equal(here, piece.a)
            return piece.b[None, :] if on_line or self._clear(np.stack([here, piece.b]), piece) else None
        legs = np.linalg.solve(piece.headings, piece.b - here)
        if legs.min() < 0.0:
            return None
        steps = piece.headings * legs
        if put_off and piece.seconds * legs.min() / legs.sum() < self.shortest_s:
            there = here + steps[:, int(np.argmax(legs))]
            # The board put off must be free as well: it is the way back to the line.
            if self._clear(np.stack([here, there, piece.b]), piece):
                return there[None, :]
        return self._boards(here, steps, piece)

    def _clear(self, points: Array, piece: _Piece) -> bool:
        """Tell whether legs through points touch neither land nor a zone valid during the piece."""
        legs = np.hstack([points[:-1], points[1:]])
        if self.zones and bool(self.zones.close(legs, piece.begin - SLACK_S, piece.end + SLACK_S).any()):
            return False
        return bool(self.sea.clear(legs).all())

    def _boards(self, a: Array, steps: Array, piece: _Piece) -> Array | None:
        """Corners of the boards, as few as the water allows; ``None`` where it is too narrow.

        Every second pair begins with the heading on which the last one ended, which halves the tacks.
        """
        pairs = 1
        while pairs == 1 or piece.seconds / pairs >= SHORTEST_PAIR_S:
            for swap in (self.other_first, not self.other_first):
                corners, last = _zigzag(a, steps / pairs, pairs, swap)
                if self._clear(np.vstack([a, corners]), piece):
                    self.other_first = last
                    return corners
            pairs *= 2
        return None


def _zigzag(a: Array, steps: Array, pairs: int, swap: bool) -> tuple[Array, bool]:
    """Corners after each board, and whether the next pair begins with the second heading."""
    corners = []
    here = a
    for _ in range(pairs):
        for k in (1, 0) if swap else (0, 1):
            here = here + steps[:, k]
            corners.append(here)
        swap = not swap
    return np.array(corners), swap


def merge_straight(course: Course, sea: Sea, zones: Zones) -> Course:
    """Join legs between which the course does not change, where the joined leg touches nothing either."""
    keep = [0]
    points, short = list(zip(course.x.tolist(), course.y.tolist(), strict=True)), course.short_tacked.tolist()
    for k in range(1, course.x.size - 1):
        (ax, ay), (bx, by), (cx, cy) = points[keep[-1]], points[k], points[k + 1]
        before, after = math.atan2(bx - ax, by - ay), math.atan2(cx - bx, cy - by)
        turn = abs((math.degrees(after - before) + 180.0) % 360.0 - 180.0)
        if turn <= SAME_COURSE_DEG and short[k] == short[k - 1]:
            joined = np.array([[ax, ay, cx, cy]])
            if bool(sea.clear(joined)[0]) and not bool(zones.close(joined, -np.inf, np.inf)[0]):
                continue
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
    lat, lon = from_mercator(x, y)
    return np.asarray(rhumb_distance_m(lat[:-1], lon[:-1], lat[1:], lon[1:]) / METRES_PER_NM)
