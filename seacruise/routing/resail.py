"""Sail a finished passage again, by code that shares nothing with the search.

The search looks winds up in slices of time and speeds in a table, and trusts a raster of the sea. Here
the yacht is moved along her legs step by step: the `Wind` itself, the `Polar` itself, a position every
0.05 nm held against the fine coast. The time that comes out is the one SeaCruise shows.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import angle_between_deg, from_mercator, rhumb_course_deg, rhumb_distance_m
from seacruise.routing.manoeuvres import GAIN, Course, count_turns
from seacruise.sea import Sea
from seacruise.sun import sun_altitude_deg
from seacruise.units import METRES_PER_NM, SECONDS_PER_HOUR
from seacruise.weather.wind import Wind
from seacruise.yacht.hull import hull_speed
from seacruise.yacht.knobs import CALM_SEA_M, night_share
from seacruise.yacht.polar import Polar

if TYPE_CHECKING:
    from seacruise.routing.find import Question

Array = NDArray[np.float64]

STEP_S: Final = 360.0
"""The wind is looked up anew every six minutes [s]."""

LAND_STEP_M: Final = 0.05 * METRES_PER_NM
"""Distance of the positions that are held against the coast [m]."""

SHORTEST_STEP_S: Final = 360.0 / 16
"""Where her speed changes by more than a tenth in a step, it is halved down to this [s]."""

LIGHT_STEP_S: Final = 600.0
MOST_LIGHT_S: Final = 20 * 86_400.0
"""Steps in which the light changes, and how long it is known after the departure [s]."""

MOST_S: Final = 30 * 86_400.0
"""A leg that takes longer has no end: she is becalmed [s]."""

PER_TWS: Final = 5.0
PER_TWA: Final = 1.0
"""Entries of the polar's table per m/s and per degree; linear between them it is right to 0.05 %."""


@dataclass(frozen=True, slots=True, eq=False)
class Resailed:
    """A passage as sailed; samples every step and at each waypoint, shapes ``(n,)``, see `passage.Track`.

    Attributes
    ----------
    speed, sog
        Through the water and over ground [m/s].
    heading_deg
        Course steered, which is the course made good but for the current.
    current
        ``(n, 2)`` eastward and northward [m/s].
    pause_s
        Seconds that manoeuvres took.
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
    sog: Array
    heading_deg: Array
    current: Array
    tws: Array
    twd_deg: Array
    motor: NDArray[np.bool_]
    leg: NDArray[np.int64]
    at: NDArray[np.int64]
    arrived: bool
    land_free: bool
    zones_entered: tuple[str, ...]
    within_limits: bool
    fuel_l: float
    motor_s: float
    pause_s: float

    @property
    def in_current(self) -> bool:
        """Whether the water moved anywhere on the way."""
        return bool(self.current.any())

    def tacks_and_gybes(self) -> tuple[int, int]:
        """Count the times the wind changed its side between two legs."""
        at = self.at[:-1]
        return count_turns(self.heading_deg[at], self.twd_deg[at], ~self.motor[at])

    @property
    def turns(self) -> int:
        """Tacks and gybes together."""
        return sum(self.tacks_and_gybes())

    def mixed(self, polar: Polar) -> NDArray[np.bool_]:
        """Tell of each leg whether the hull of the polar is faster on it than the polar anywhere."""
        twa = angle_between_deg(self.twd_deg, self.course_deg)
        hull = np.array([hull_speed(polar, s, a)[0, 0] for s, a in zip(self.tws, twa, strict=True)])
        tacked = hull > polar.speed(self.tws, twa) * GAIN
        legs = int(self.leg.max(initial=0)) + 1
        return np.bincount(self.leg[:-1], weights=tacked[:-1], minlength=legs) > 0


def resail(asked: Question, course: Course, *, fuel_rate_l_h: float, look: bool = True) -> Resailed:
    """Sail the legs of a course and check every metre of it.

    Without ``look`` it is not held against the coast: ``land_free`` stays ``False``, see `is_land_free`.
    """
    from seacruise.routing import _resail

    handling, wind = asked.how.handling, asked.wind
    lat, lon = from_mercator(course.x, course.y)
    hull = course.short_tacked & handling.tacking
    straight = _table(asked, hull=False)
    engine = (-1.0, 0.0) if handling.motor_below is None else (handling.motor_below, handling.motor_speed)
    slowed = (*engine, _light(asked, lat, lon), _waves(asked))
    water = asked.current
    still = _nothing(wind)
    rows, at, arrived, paused = _resail.sail_legs(
        asked.departure,
        lat,
        lon,
        rhumb_course_deg(lat[:-1], lon[:-1], lat[1:], lon[1:]),
        rhumb_distance_m(lat[:-1], lon[:-1], lat[1:], lon[1:]),
        hull,
        (wind.time, wind.lat, wind.lon, wind.u, wind.v),
        still if water is None else (water.time, water.lat, water.lon, water.u, water.v),
        (straight, _table(asked, hull=True) if hull.any() else straight),
        slowed,
        handling.pauses,
        STEP_S,
        SHORTEST_STEP_S,
        MOST_S,
    )
    motor_s = float((np.diff(rows[:, 0]) * rows[:-1, 7]).sum())
    return Resailed(
        time=rows[:, 0],
        lat=rows[:, 1],
        lon=rows[:, 2],
        course_deg=rows[:, 3],
        speed=rows[:, 4],
        sog=rows[:, 9],
        heading_deg=rows[:, 10],
        current=rows[:, 11:13],
        tws=rows[:, 5],
        twd_deg=rows[:, 6],
        motor=rows[:, 7] > 0.5,
        leg=rows[:, 8].astype(np.int64),
        at=at,
        arrived=arrived,
        land_free=look and is_land_free(course, asked.sea),
        zones_entered=asked.zones.entered(rows[:, 1], rows[:, 2], rows[:, 0]) if asked.zones else (),
        within_limits=_within_limits(asked, rows),
        fuel_l=motor_s / SECONDS_PER_HOUR * fuel_rate_l_h,
        motor_s=motor_s,
        pause_s=float(paused),
    )


_Grid = tuple[Array, Array, Array, NDArray[np.float32], NDArray[np.float32]]


def _nothing(wind: Wind) -> _Grid:
    """Grid without times: there is no such thing on this passage."""
    return wind.time[:0], wind.lat, wind.lon, wind.u[:0], wind.v[:0]


def _light(asked: Question, lat: Array, lon: Array) -> _Grid:
    """Share of her speed that the night leaves, on a grid of its own: dusk is over in less than an hour.

    Around the waypoints: a wind that is the same everywhere has one place only, and it may be dark there.
    """
    at_night, wind = asked.how.handling.at_night, asked.wind
    if at_night >= 1.0:
        return _nothing(wind)
    times = asked.departure + np.arange(0.0, MOST_LIGHT_S, LIGHT_STEP_S)
    lat, lon = (np.linspace(axis.min() - 1e-6, axis.max(), 9) for axis in (lat, lon))
    share = night_share(sun_altitude_deg(times[:, None, None], lat[:, None], lon), at_night=at_night)
    return times, lat, lon, share.astype(np.float32), share.astype(np.float32)


def _waves(asked: Question) -> _Grid:
    """Share that waves take head to sea, on the forecast's grid."""
    per_metre, wind = asked.how.handling.per_metre, asked.wind
    if per_metre <= 0.0 or wind.wave is None:
        return _nothing(wind)
    lost = (np.maximum(wind.wave - CALM_SEA_M, 0.0) * per_metre).astype(np.float32)
    return wind.time, wind.lat, wind.lon, lost, lost


def _within_limits(asked: Question, rows: Array) -> bool:
    """Hold every sample against the limits of wind, gusts and waves, on the forecast's own grid."""
    handling, wind = asked.how.handling, asked.wind
    # Between two looks a gust of the grid may exceed what the search saw, by rounding only.
    kept = handling.max_wind is None or bool(rows[:, 5].max() <= handling.max_wind * 1.005)
    limits = handling.limits
    for grid, limit in ((wind.gust, limits.max_gust), (wind.wave, limits.max_wave)):
        if grid is not None and limit is not None:
            met = wind.interpolate(grid, rows[:, 0], rows[:, 1], rows[:, 2])
            kept = kept and bool(met.max() <= limit * 1.005)
    return kept


def _table(asked: Question, *, hull: bool) -> tuple[Array, float, float]:
    """Boat speed by TWS and TWA, evenly tabulated up to the strongest wind of the forecast."""
    wind = asked.wind
    strongest = math.sqrt(float((wind.u.astype(np.float64) ** 2 + wind.v.astype(np.float64) ** 2).max()))
    if asked.current is not None:
        strongest += float(np.hypot(asked.current.u, asked.current.v).max())
    table = _tabulated(asked.polar, math.ceil(strongest * PER_TWS) + 2, hull)
    return np.ascontiguousarray(table * asked.how.handling.share), PER_TWS, PER_TWA


@lru_cache(maxsize=4)
def _tabulated(polar: Polar, rows: int, hull: bool) -> Array:
    tws = np.arange(rows) / PER_TWS
    twa = np.linspace(0.0, 180.0, int(180 * PER_TWA) + 1)
    return hull_speed(polar, tws, twa) if hull else polar.speed(tws[:, None], twa[None, :])


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
