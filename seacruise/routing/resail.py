"""Sail a finished passage again, by code that shares nothing with the search.

The search looks winds up in slices of time and speeds in a table, and trusts a raster of the sea. Here
the yacht is moved along her legs step by step: the `Wind` itself, the `Polar` itself, a position every
0.05 nm held against the fine coast. The time that comes out is the one SeaCruise shows.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import from_mercator, rhumb_course_deg, rhumb_distance_m
from seacruise.routing.field import Handling
from seacruise.routing.manoeuvres import Course
from seacruise.sea import Sea
from seacruise.units import METRES_PER_NM
from seacruise.weather.wind import Wind, to_direction
from seacruise.yacht.hull import hull_speed
from seacruise.yacht.polar import Polar

if TYPE_CHECKING:
    from seacruise.routing.find import Question

Array = NDArray[np.float64]

STEP_S: Final = 360.0
"""The wind is looked up anew every six minutes [s]."""

LAND_STEP_M: Final = 0.05 * METRES_PER_NM
"""Distance of the positions that are held against the coast [m]."""

_MOST_S: Final = 120 * 86_400.0


@dataclass(frozen=True, slots=True, eq=False)
class Resailed:
    """A passage as sailed; samples every step and at each waypoint, shapes ``(n,)``, see `passage.Track`.

    Attributes
    ----------
    arrived
        ``False`` when she was becalmed for good, or met more wind than allowed on a leg.
    at
        ``(m,)`` index of each waypoint's sample.
    """

    time: Array
    lat: Array
    lon: Array
    course_deg: Array
    speed: Array
    tws: Array
    twd_deg: Array
    motor: NDArray[np.bool_]
    leg: NDArray[np.int64]
    at: NDArray[np.int64]
    arrived: bool
    land_free: bool
    within_limits: bool
    fuel_l: float
    motor_s: float


class _Boat:
    """Her speed in the wind of a place and time, and what is drawn of it."""

    def __init__(self, wind: Wind, polar: Polar, handling: Handling) -> None:
        self.wind, self.polar, self.handling = wind, polar, handling

    def meets(self, t: float, lat: float, lon: float) -> tuple[float, float]:
        """TWS [m/s] and TWD [degrees]."""
        u, v = self.wind.at(t, lat, lon)
        tws, twd = to_direction(u, v)
        return float(tws), float(twd)

    def speed(self, tws: float, twd: float, course: float, *, hull: bool) -> tuple[float, bool]:
        """Speed on a course [m/s], and whether the engine gives it."""
        twa = abs((twd - course + 180.0) % 360.0 - 180.0)
        sail = float(hull_speed(self.polar, tws, twa)[0, 0] if hull else self.polar.speed(tws, twa))
        sail *= self.handling.share
        below = self.handling.motor_below
        if below is not None and sail < below and self.handling.motor_speed > sail:
            return self.handling.motor_speed, True
        return sail, False


def resail(asked: Question, course: Course, *, fuel_rate_l_h: float) -> Resailed:
    """Sail the legs of a course and check every metre of it."""
    handling = asked.how.handling
    boat = _Boat(asked.wind, asked.polar, handling)
    lat, lon = from_mercator(course.x, course.y)
    rows: list[tuple[float, ...]] = []
    at = []
    t = asked.departure
    motor_s = 0.0
    arrived = True
    hull = course.short_tacked if handling.tacking else np.zeros_like(course.short_tacked)
    for k in range(lat.size - 1):
        at.append(len(rows))
        t, engine, arrived = _sail_leg(boat, k, t, lat[k : k + 2], lon[k : k + 2], bool(hull[k]), rows)
        motor_s += engine
        if not arrived:
            break
    tws, twd = boat.meets(t, lat[-1], lon[-1])
    last = rows[-1]
    rows.append((t, lat[-1], lon[-1], last[3], last[4], tws, twd, last[7], last[8]))
    at.append(len(rows) - 1)
    table = np.array(rows)
    limit = handling.max_wind
    return Resailed(
        time=table[:, 0],
        lat=table[:, 1],
        lon=table[:, 2],
        course_deg=table[:, 3],
        speed=table[:, 4],
        tws=table[:, 5],
        twd_deg=table[:, 6],
        motor=table[:, 7] > 0.5,
        leg=table[:, 8].astype(np.int64),
        at=np.array(at),
        arrived=arrived,
        land_free=is_land_free(course, asked.sea),
        # A grid's peak between two six-minute looks may exceed what the search saw by rounding only.
        within_limits=limit is None or bool(table[:, 5].max() <= limit * 1.005),
        fuel_l=motor_s / 3600.0 * fuel_rate_l_h,
        motor_s=motor_s,
    )


def _sail_leg(
    boat: _Boat, k: int, t: float, lat: Array, lon: Array, hull: bool, rows: list[tuple[float, ...]]
) -> tuple[float, float, bool]:
    """Move along one leg in six-minute steps; each step at the speed of its middle (midpoint rule)."""
    course = float(rhumb_course_deg(lat[0], lon[0], lat[1], lon[1]))
    length = float(rhumb_distance_m(lat[0], lon[0], lat[1], lon[1]))
    sailed = 0.0
    engine = 0.0
    begin = t
    while sailed < length - 1e-6:
        if t - begin > _MOST_S:
            return t, engine, False
        f = sailed / length
        here = lat[0] + (lat[1] - lat[0]) * f, lon[0] + (lon[1] - lon[0]) * f
        tws, twd = boat.meets(t, *here)
        speed, motor = boat.speed(tws, twd, course, hull=hull)
        rows.append((t, *here, course, speed, tws, twd, float(motor), float(k)))
        f = min(1.0, (sailed + speed * STEP_S / 2) / length)
        middle = lat[0] + (lat[1] - lat[0]) * f, lon[0] + (lon[1] - lon[0]) * f
        ahead = STEP_S / 2 if speed * STEP_S < 2 * (length - sailed) else (length - sailed) / speed / 2
        speed, motor = boat.speed(*boat.meets(t + min(ahead, STEP_S / 2), *middle), course, hull=hull)
        rest = (length - sailed) / speed if speed > 1e-9 else np.inf
        spent = min(STEP_S, rest)
        sailed = length if rest <= STEP_S else sailed + speed * spent
        engine += spent if motor else 0.0
        t += spent
    return t, engine, True


def is_land_free(course: Course, sea: Sea) -> bool:
    """Sample the course every 0.05 nm and hold each step against the fine coast, or the global mask."""
    x, y = [course.x[:1]], [course.y[:1]]
    for k in range(course.x.size - 1):
        dx, dy = course.x[k + 1] - course.x[k], course.y[k + 1] - course.y[k]
        pieces = max(1, int(np.ceil(np.hypot(dx, dy) / LAND_STEP_M)))
        share = np.arange(1, pieces + 1) / pieces
        x.append(course.x[k] + dx * share)
        y.append(course.y[k] + dy * share)
    px, py = np.concatenate(x), np.concatenate(y)
    return not bool(sea.touches_land(*from_mercator(px, py)).any())
