"""One leg on its own: how long it takes, what it costs, and where she is on a course after a while.

All of it is the search's own integrator, `seacruise.routing._relax.retime`, called in one place: no figure
here can differ from that of a passage. A leg is a rhumb line, cut into marks; the integrator gives the
time at each, and the rest is arithmetic with those times:

- cost ``integral of density(s) ds + absolute(seconds, metres)``, after R5, whose density may be anything that
  a place and a time of the leg have;
- the point on a course after a time: the marks between which that time falls, and the same integrator
  inverted between the two.

References
----------
V. Dannenberg, R. Schueler, A. Schuermann, Appl. Sci. 12 (2022) 3085, doi 10.3390/app12063085.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError
from seacruise.geodesy import destination, from_mercator, rhumb_course_deg, rhumb_distance_m, to_mercator
from seacruise.routing.field import Handling, SpeedTable, WindField, speed_table, wind_field
from seacruise.routing.refine import PIECE_M
from seacruise.routing.turning import NO_PAUSES
from seacruise.weather.wind import Wind, to_direction
from seacruise.yacht.polar import Polar

Array = NDArray[np.float64]
Position = tuple[float, float]

_MARK_M: Final = PIECE_M / 4.0
"""Distance of the marks at which a density is asked for [m]."""

_MOST_MARKS: Final = 20_000
_EXACT_S: Final = 1e-3
_MOST_TURNS: Final = 40
"""How exactly the time of a point on a course is met [s], and after how many turns it is close enough."""

_MOST_LATITUDE: Final = 85.0
"""The Mercator plane has no pole: a course ends here [degrees]."""


@dataclass(frozen=True, slots=True, eq=False)
class Conditions:
    """A yacht in her weather, made ready once for many legs; see `conditions`."""

    wind: Wind
    field: WindField
    speeds: SpeedTable

    def sail(self, departure: float, x: Array, y: Array) -> Array:
        """Sail marks in a line: times [s since 1970] at points of the Mercator plane [m].

        The one call of the integrator in this module; inf where she never comes.
        """
        from seacruise.routing import _relax

        x, y = np.ascontiguousarray(x), np.ascontiguousarray(y)
        times = np.empty(x.size)
        times[0] = departure
        _relax.retime(
            x,
            y,
            _relax.latitudes(y),
            times,
            x.size,
            1,
            PIECE_M,
            self.field.arrays,
            self.speeds.arrays,
            NO_PAUSES,
        )
        return times


def conditions(wind: Wind, polar: Polar, handling: Handling | None = None, **field: Any) -> Conditions:
    """Make a yacht and her weather ready.

    Parameters
    ----------
    wind, polar
        What blows, and how fast she is in it.
    handling
        How she is sailed; with tacking and all of her polar by default.
    field
        Passed on to `seacruise.routing.field.wind_field`: a current, limits of gusts and waves.
    """
    return Conditions(wind, wind_field(wind, **field), speed_table(polar, handling or Handling()))


@dataclass(frozen=True, slots=True, eq=False)
class Marks:
    """A leg as it was sailed, at marks along it, all ``(n,)``; what a density function is given.

    Attributes
    ----------
    time
        Seconds since 1970.
    lat, lon
        Degrees.
    distance
        From the start [m].
    speed
        Made good over the ground [m/s], from mark to mark; that of a mark is the mean of both sides.
    tws, twd
        True wind speed [m/s] and where it comes from [degrees true].
    course_deg
        Of the leg [degrees true].
    """

    time: Array
    lat: Array
    lon: Array
    distance: Array
    speed: Array
    tws: Array
    twd: Array
    course_deg: float


Density = Callable[[Marks], Any]
"""Cost per metre at each mark, ``(n,)`` or a single number; per second it is ``cost / marks.speed``."""

Absolute = Callable[[float, float], float]
"""Cost of the whole leg, of its time [s] and length [m]."""


def leg_time(start: Position, end: Position, departure: float, given: Conditions) -> float:
    """Time that a leg takes [s]; inf where she is becalmed on it for ever, or it is forbidden.

    Parameters
    ----------
    start, end
        Positions [degrees]; the leg is the rhumb line between them.
    departure
        Seconds since 1970.
    given
        The yacht and her weather.
    """
    x, y = _line(start, end, PIECE_M)
    return float(given.sail(departure, x, y)[-1] - departure)


def _line(start: Position, end: Position, apart: float) -> tuple[Array, Array]:
    """Points of the Mercator plane [m] on the rhumb line between positions, no further apart [m].

    On a long leg the latitude does not grow evenly with the way in the plane; between marks it may be
    taken to.
    """
    length = float(rhumb_distance_m(*start, *end))
    count = min(int(np.ceil(length / apart)), _MOST_MARKS) + 1
    x, y = to_mercator(np.array((start[0], end[0])), np.array((start[1], end[1])))
    share = np.linspace(0.0, 1.0, max(count, 2))
    return x[0] + share * (x[1] - x[0]), y[0] + share * (y[1] - y[0])


def leg_cost(
    start: Position,
    end: Position,
    departure: float,
    given: Conditions,
    *,
    density: Density | None = None,
    absolute: Absolute | None = None,
) -> float:
    """Cost of a leg through changing weather, by whatever the sailor counts as cost.

    Parameters
    ----------
    start, end, departure, given
        As for `leg_time`.
    density
        Cost that grows along the way, for example 1 where the wind is above a limit; see `Density`.
    absolute
        Cost of the whole; the time in seconds by default, and nothing where there is a density.

    Returns
    -------
    float
        In the unit of the functions; inf for a leg that cannot be sailed.

    Raises
    ------
    InputError
        A density is not of the marks' number.
    """
    if density is None:
        seconds = leg_time(start, end, departure, given)
        length = float(rhumb_distance_m(*start, *end))
        return seconds if absolute is None or not np.isfinite(seconds) else absolute(seconds, length)
    marks = leg_marks(start, end, departure, given)
    if not np.isfinite(marks.time[-1]):
        return float("inf")
    each = np.asarray(density(marks), dtype=np.float64)
    if each.shape not in ((), marks.time.shape):
        raise InputError(
            f"The density of a cost gave {each.shape} figures for {marks.time.size} marks; "
            "it must give one each."
        )
    along = float(np.trapezoid(np.broadcast_to(each, marks.distance.shape), marks.distance))
    seconds, length = float(marks.time[-1] - departure), float(marks.distance[-1])
    return along + (absolute(seconds, length) if absolute else 0.0)


def leg_marks(start: Position, end: Position, departure: float, given: Conditions) -> Marks:
    """Sail a leg and tell what was met along it, about every half mile."""
    x, y = _line(start, end, _MARK_M)
    lat, lon = from_mercator(x, y)
    distance = rhumb_distance_m(start[0], start[1], lat, lon)
    time = given.sail(departure, x, y)
    sailed = np.isfinite(time)
    u, v = given.wind.at(np.where(sailed, time, departure), lat, lon)
    tws, twd = to_direction(u, v)
    course = float(rhumb_course_deg(*start, *end))
    return Marks(time, lat, lon, distance, _speeds(time, distance), tws, twd, course)


def _speeds(time: Array, distance: Array) -> Array:
    """Speeds at marks: of a mark the distance over the time between its neighbours."""
    if not np.isfinite(time).all() or time[-1] <= time[0]:
        return np.zeros(time.size)
    between = np.diff(distance) / np.maximum(np.diff(time), 1e-9)
    return np.concatenate((between[:1], (between[1:] + between[:-1]) / 2.0, between[-1:]))


@dataclass(frozen=True, slots=True)
class Reached:
    """Where she is on a course after a time: position [degrees] and the distance sailed [m]."""

    lat: float
    lon: float
    distance: float


def isochrone_point(
    start: Position, course_deg: float, seconds: float, departure: float, given: Conditions
) -> Reached:
    """Point that is reached on a course after a time, by inverting the integrator.

    Where she cannot go on - becalmed to the end of the forecast, or before a wind above the limits - it is
    the point where she is stopped.

    Parameters
    ----------
    start
        Position [degrees].
    course_deg
        Course made good [degrees true], a rhumb line.
    seconds
        Time [s], from 0 on.
    departure, given
        As for `leg_time`.

    Raises
    ------
    InputError
        The time is negative or the course no number.
    """
    if not (np.isfinite(course_deg) and np.isfinite(seconds) and seconds >= 0.0):
        raise InputError(
            f"A course of {course_deg} degrees for {seconds} s cannot be sailed; give both anew."
        )
    farthest = given.field.fastest(given.speeds) * seconds
    count = min(int(np.ceil(farthest / PIECE_M)), _MOST_MARKS) + 1
    lat, lon = destination(start[0], start[1], course_deg, np.linspace(0.0, farthest, count))
    on_chart = np.abs(lat) < _MOST_LATITUDE
    x, y = to_mercator(lat[on_chart], lon[on_chart])
    times = given.sail(departure, x, y) - departure
    mark = int(np.searchsorted(times, seconds, side="right")) - 1
    if mark < 0 or mark + 1 >= times.size:
        at_x, at_y = float(x[max(mark, 0)]), float(y[max(mark, 0)])
    else:
        at_x, at_y = _between(given, departure, seconds, (times[mark:], x[mark:], y[mark:]))
    here_lat, here_lon = (float(v) for v in from_mercator(at_x, at_y))
    return Reached(here_lat, here_lon, float(rhumb_distance_m(*start, here_lat, here_lon)))


def _between(
    given: Conditions, departure: float, seconds: float, marks: tuple[Array, Array, Array]
) -> tuple[float, float]:
    """Find the point between the first two marks that is reached at the time."""
    times, x, y = marks
    low, high = 0.0, 1.0
    early, late = float(times[0]) - seconds, float(times[1]) - seconds
    point = float(x[0]), float(y[0])
    for turn in range(_MOST_TURNS):
        # The secant finds it in two or three turns; where it creeps or there is no end, the middle does.
        share = low - early * (high - low) / (late - early) if np.isfinite(late) and turn % 3 < 2 else np.nan
        if not low < share < high:
            share = (low + high) / 2.0
        tried = float(x[0] + share * (x[1] - x[0])), float(y[0] + share * (y[1] - y[0]))
        ends = np.array((x[0], tried[0])), np.array((y[0], tried[1]))
        off = float(given.sail(departure + float(times[0]), *ends)[-1]) - departure - seconds
        if off <= 0.0:
            low, early, point = share, off, tried
        else:
            high, late = share, off
        if abs(off) < _EXACT_S:
            return tried
    return point
