"""One simulator for the routes of all programs: what each would have taken, to the port itself.

Written for this purpose alone. It shares the wind's grid and the polar with SeaCruise and nothing else: no
kernel, no table of the search, no re-sailing of `seacruise.routing.resail`.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from seacruise.geodesy import EARTH_RADIUS, rhumb_course_deg, rhumb_distance_m
from seacruise.units import METRES_PER_NM, SECONDS_PER_HOUR
from seacruise.weather.wind import Wind
from seacruise.yacht.hull import hull_speed
from seacruise.yacht.polar import Polar

STEP_S: Final = 180.0
"""Time between two looks at the wind [s]."""

PATIENCE_S: Final = 10 * 86_400.0
"""A route that takes longer is not sailable [s]."""

_PER_TWS: Final = 10.0
_PER_TWA: Final = 2.0


@dataclass(frozen=True, slots=True)
class Voyage:
    """A route as it was sailed; ``hours`` is infinite when she never arrived."""

    hours: float
    distance_nm: float


class Simulator:
    """Sails lines of waypoints, each leg a rhumb line, with the midpoint rule in steps of time.

    On each leg she may tack or gybe as she likes: a leg against the wind is sailed at the speed of her
    polar's hull, for whichever program it comes from.
    """

    def __init__(self, wind: Wind, polar: Polar) -> None:
        self._axes = tuple(axis.tolist() for axis in (wind.time, wind.lat, wind.lon))
        self._u: list[list[list[float]]] = wind.u.astype(float).tolist()
        self._v: list[list[list[float]]] = wind.v.astype(float).tolist()
        strongest = float(np.hypot(wind.u, wind.v).max())
        tws = np.arange(math.ceil(strongest * _PER_TWS) + 2) / _PER_TWS
        twa = np.arange(180 * _PER_TWA + 1) / _PER_TWA
        self._hull: list[list[float]] = hull_speed(polar, tws, twa).tolist()
        self._straight: list[list[float]] = polar.speed(tws[:, None], twa[None, :]).tolist()

    def wind_at(self, t: float, lat: float, lon: float) -> tuple[float, float]:
        """Wind u, v [m/s]: linear in time, bilinear in space, held beyond all edges."""
        (k, a), (i, b), (j, c) = (
            _place(axis, value) for axis, value in zip(self._axes, (t, lat, lon), strict=True)
        )
        east = north = 0.0
        for dk, wk in ((0, 1.0 - a), (1, a)):
            for di, wi in ((0, 1.0 - b), (1, b)):
                for dj, wj in ((0, 1.0 - c), (1, c)):
                    weight = wk * wi * wj
                    if weight > 0.0:
                        east += weight * self._u[k + dk][i + di][j + dj]
                        north += weight * self._v[k + dk][i + di][j + dj]
        return east, north

    def speed(self, t: float, lat: float, lon: float, course: float, *, tacking: bool = True) -> float:
        """Speed made good [m/s] on a course [degrees]."""
        east, north = self.wind_at(t, lat, lon)
        twa = abs((math.degrees(math.atan2(-east, -north)) - course + 180.0) % 360.0 - 180.0)
        table = self._hull if tacking else self._straight
        x, y = min(math.hypot(east, north) * _PER_TWS, len(table) - 1.000001), min(twa * _PER_TWA, 359.999999)
        i, j = int(x), int(y)
        f, g = x - i, y - j
        low = table[i][j] * (1 - g) + table[i][j + 1] * g
        return low * (1 - f) + (table[i + 1][j] * (1 - g) + table[i + 1][j + 1] * g) * f

    def sail(
        self, lat: Sequence[float], lon: Sequence[float], departure: float, *, tacking: bool = True
    ) -> Voyage:
        """Sail waypoints [degrees] from a departure [s since 1970] to the last of them."""
        t, metres = departure, 0.0
        for k in range(len(lat) - 1):
            leg = _Leg((lat[k], lon[k]), (lat[k + 1], lon[k + 1]))
            sailed = 0.0
            metres += leg.length
            while leg.length - sailed > 1e-6:
                if t - departure > PATIENCE_S:
                    return Voyage(math.inf, metres / METRES_PER_NM)
                here = leg.at(sailed)
                guess = self.speed(t, *here, leg.course, tacking=tacking)
                rest = leg.length - sailed
                half = min(STEP_S, rest / guess if guess > 0.0 else STEP_S) / 2
                middle = leg.at(min(leg.length, sailed + guess * half))
                speed = self.speed(t + half, *middle, leg.course, tacking=tacking)
                if speed * STEP_S >= rest:
                    t += rest / speed
                    break
                t += STEP_S
                sailed += speed * STEP_S
        return Voyage((t - departure) / SECONDS_PER_HOUR, metres / METRES_PER_NM)


class _Leg:
    """A rhumb line between two positions."""

    def __init__(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        self.start, self.end = start, end
        self.course = float(rhumb_course_deg(*start, *end))
        self.length = float(rhumb_distance_m(*start, *end))
        self._y = _northing(start[0]), _northing(end[0])

    def at(self, sailed: float) -> tuple[float, float]:
        """Position [degrees] after some metres: latitude grows evenly, longitude with the Mercator plane."""
        share = sailed / self.length
        lat = self.start[0] + (self.end[0] - self.start[0]) * share
        span = self._y[1] - self._y[0]
        if abs(span) > 1.0:
            share = (_northing(lat) - self._y[0]) / span
        return lat, self.start[1] + (self.end[1] - self.start[1]) * share


def _northing(lat: float) -> float:
    return EARTH_RADIUS * math.asinh(math.tan(math.radians(lat)))


def _place(axis: list[float], value: float) -> tuple[int, float]:
    """Index before a value and how far towards the next it lies; the ends are held."""
    last = len(axis) - 1
    if last == 0 or value <= axis[0]:
        return 0, 0.0
    if value >= axis[last]:
        return last - 1, 1.0
    k = bisect_right(axis, value) - 1
    return k, (value - axis[k]) / (axis[k + 1] - axis[k])
