"""R4's example under engine: obstacles for good and for a forecast step, leg speeds, four problems.

A motor vessel goes from (10, 20) km to (200, 1000) km at 2.5 to 12.5 m/s; forbidden areas are polygons,
some of them valid for one forecast step of three hours. The publication does not give its areas: those here
are ours. The plane lies along the equator, where the Mercator plane is flat to 0.3 %.

Routes come from the program's own search, under engine at one speed after another. The speeds of a route's
legs are then chosen by dynamic programming over arrival times, which is exact up to its grid of time.
"""

from __future__ import annotations

import itertools
import math
import time
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import EARTH_RADIUS, from_mercator
from seacruise.routing import lattice as lattices
from seacruise.routing import stencil
from seacruise.routing.field import Handling, speed_table, wind_field
from seacruise.routing.lattice import Area, Lattice, Levels
from seacruise.routing.refine import Waters, relaxed, simplified, timed
from seacruise.routing.search import search
from seacruise.sea import Sea
from seacruise.sea.zones import NO_ZONES, Zone, Zones
from seacruise.units import METRES_PER_NM, SECONDS_PER_HOUR
from tests.routing.worlds import T0, drifter, open_sea, steady_wind

Array = NDArray[np.float64]

START_KM, END_KM = (10.0, 20.0), (200.0, 1000.0)
SLOWEST, FASTEST = 2.5, 12.5
"""Speeds [m/s]."""

STEP_S: Final = 3 * SECONDS_PER_HOUR
"""A forecast step [s]: areas of a storm are valid for one of them."""

SPACING_KM, SAFETY_KM = 15.0, 2.0
"""The lattice: spacing at sea, and radius of the safety zones around areas, where it is 4 times finer."""

SPEEDS: Final = np.arange(SLOWEST, FASTEST + 0.01, 0.5)
"""Speeds at which routes are looked for [m/s]."""

PIECE_KM: Final = 45.0
TICK_S: Final = 150.0
LONGEST_H: Final = 36
"""For the speeds of legs: piece with one speed (an hour at full speed), grid of arrival times, latest one."""

LATEST_H: Final = (25.0, 30.0)
SAVING: Final = 0.3
ALIKE_H: Final = 0.25
"""What problems (b), (c) and (d) are asked with; 30 h is the published passage, and times within a quarter
of an hour count as the least."""


def at(km: tuple[float, float]) -> tuple[float, float]:
    """Position [degrees] of a place of the publication's plane [km], its middle on the equator."""
    lat, lon = from_mercator(km[0] * 1000.0, (km[1] - 500.0) * 1000.0)
    return float(lat), float(lon)


def area(
    name: str, corners_km: list[tuple[float, float]], step: int | None = None, *, steps: int = 1
) -> Zone:
    """Close an area, for good or for forecast steps."""
    ring = np.array([at(corner)[::-1] for corner in [*corners_km, corners_km[0]]])
    if step is None:
        return Zone(name, (ring,))
    return Zone(name, (ring,), T0 + step * STEP_S, T0 + (step + steps) * STEP_S)


def storm(step: int) -> Zone:
    """Eight sides around a storm of 90 km radius that moves west by 10 km in each step."""
    x, y = 60.0 - 10.0 * step, 560.0
    angles = np.radians(np.arange(22.5, 360.0, 45.0))
    corners = [(x + 90.0 * math.cos(a), y + 90.0 * math.sin(a)) for a in angles]
    return area(f"storm, step {step + 1}", corners, step)


SHOALS: Final = (
    area("shoal", [(20.0, 250.0), (130.0, 250.0), (130.0, 320.0), (20.0, 320.0)]),
    area("farm", [(110.0, 740.0), (270.0, 740.0), (270.0, 790.0), (110.0, 790.0)]),
)
STORM: Final = tuple(storm(step) for step in range(10))
RANGE: Final = area("range", [(-400.0, 590.0), (600.0, 590.0), (600.0, 610.0), (-400.0, 610.0)], 3, steps=2)
"""Closed from 9 to 15 h after the departure, and wider than the waters."""


@dataclass(frozen=True, slots=True, eq=False)
class Route:
    """Waypoints of the plane [m]."""

    x: Array
    y: Array

    @property
    def legs_m(self) -> Array:
        """True lengths [m]."""
        dy, span = np.diff(self.y), np.hypot(np.diff(self.x), np.diff(self.y))
        lat = from_mercator(0.0, self.y)[0]
        flat = np.cos(np.radians((lat[1:] + lat[:-1]) / 2))
        steep = np.abs(dy) > 1.0
        rise = EARTH_RADIUS * np.radians(np.diff(lat))
        return np.asarray(span * np.where(steep, rise / np.where(steep, dy, 1.0), flat))

    @property
    def km(self) -> float:
        """True length [km]."""
        return float(self.legs_m.sum()) / 1000.0

    def cut(self) -> Route:
        """Cut long legs: a speed may change at sea too."""
        x, y = [self.x[:1]], [self.y[:1]]
        for k, metres in enumerate(self.legs_m):
            # Whole pieces first: at full speed they take whole ticks, and only the rest is rounded.
            share = np.append(np.arange(PIECE_KM * 1000.0, metres - 1.0, PIECE_KM * 1000.0) / metres, 1.0)
            x.append(self.x[k] + share * (self.x[k + 1] - self.x[k]))
            y.append(self.y[k] + share * (self.y[k + 1] - self.y[k]))
        return Route(np.concatenate(x), np.concatenate(y))


@dataclass(frozen=True, slots=True, eq=False)
class Passage:
    """A route with a speed for each of its pieces."""

    route: Route
    hours: float
    fuel: float
    speeds: Array


def fuel_rate(speed: Array | float) -> Array:
    """Consumption by speed [m/s], as a share of that at full speed: power grows with the cube of speed."""
    return np.asarray((np.asarray(speed) / FASTEST) ** 3)


def fuel_of(metres: float, seconds: Array | float) -> Array:
    """Fuel for a distance in a time, in hours at full speed."""
    return np.asarray(fuel_rate(metres / np.asarray(seconds)) * np.asarray(seconds) / SECONDS_PER_HOUR)


# ------------------------------------------------------------------------------------------------ routes


def motor_waters(sea: Sea, speed: float, zones: Zones) -> Waters:
    """Waters of a vessel under engine at one speed: the wind gives her nothing."""
    engine = Handling(tacking=False, motor_below=2 * FASTEST, motor_speed=speed, share=1e-3)
    wind = steady_wind(0.1, 0.0)
    return Waters(sea, wind_field(wind), speed_table(drifter(), engine), zones)


def lattice_of(sea: Sea, zones: Zones) -> Lattice:
    """Lattice around the direct line, finer around the areas."""
    start, end = at(START_KM), at(END_KM)
    x0, y0, x1, y1 = (1000.0 * v for v in (START_KM[0], START_KM[1] - 500.0, END_KM[0], END_KM[1] - 500.0))
    return lattices.build(
        sea,
        start,
        end,
        spacing_nm=SPACING_KM * 1000.0 / METRES_PER_NM,
        offsets=stencil.triangular(36),
        area=Area("rectangle", np.array([[x0, y0, x1, y1]]), 200_000.0),
        levels=Levels(safety_radius_m=SAFETY_KM * 1000.0, safety_levels=2, hazards=zones),
    )


def route_at(grid: Lattice, waters: Waters) -> Route | None:
    """Find the fastest route at one speed, and pull it straight."""
    found = search(grid, waters.field, waters.speeds, T0, zones=waters.zones)
    path = found.path(grid.end)
    if path.size == 0:
        return None
    line = relaxed(waters, timed(waters, grid.x[path], grid.y[path], T0))
    line = relaxed(waters, simplified(waters, line), split=False)
    return Route(line.x, line.y)


def routes(sea: Sea, zones: Zones) -> list[Route]:
    """Routes that differ, found at one speed after another; and the one that would need no storm to pass."""
    grid = lattice_of(sea, zones)
    fixed = Zones(SHOALS) if zones else NO_ZONES
    asked = [(speed, zones) for speed in SPEEDS] + [(FASTEST, fixed)]
    found: dict[int, Route] = {}
    for speed, closed in asked:
        route = route_at(grid, motor_waters(sea, float(speed), closed))
        if route is not None:
            found.setdefault(round(route.km * 2), route)
    return list(found.values())


# ------------------------------------------------------------------------------------------------ speeds


def best_speeds(route: Route, zones: Zones) -> Array:
    """Least fuel ``(pieces + 1, ticks)`` with which each piece of a route can be ended at each tick.

    Dynamic programming: a piece is begun and ended on ticks, at one speed in between, and may not touch an
    area while that is valid.
    """
    from seacruise.sea import _prisms

    metres = route.legs_m
    ticks = round(LONGEST_H * SECONDS_PER_HOUR / TICK_S) + 1
    least = np.full((metres.size + 1, ticks), np.inf)
    least[0, 0] = 0.0
    arrays = zones.arrays
    for k, length in enumerate(metres.tolist()):
        first = math.ceil(length / FASTEST / TICK_S - 1e-9)
        last = math.floor(length / SLOWEST / TICK_S)
        ends = route.x[k], route.y[k], route.x[k + 1], route.y[k + 1]
        free = not bool(zones.close(np.array([ends]), T0, T0 + LONGEST_H * SECONDS_PER_HOUR)[0])
        for ticks_long in range(first, last + 1):
            fuel = float(fuel_of(length, ticks_long * TICK_S))
            begin = np.flatnonzero(np.isfinite(least[k, : ticks - ticks_long]))
            if not free:
                t = T0 + begin * TICK_S
                until = t + ticks_long * TICK_S
                touches = [
                    _prisms.closed(arrays, ends[0], ends[1], a, ends[2], ends[3], b)
                    for a, b in zip(t.tolist(), until.tolist(), strict=True)
                ]
                begin = begin[~np.array(touches, dtype=bool)]
            end = begin + ticks_long
            least[k + 1, end] = np.minimum(least[k + 1, end], least[k, begin] + fuel)
    return least


def read_back(route: Route, zones: Zones, least: Array, tick: int) -> Passage:
    """Speeds of the pieces of a passage that ends at a tick, from the last to the first."""
    from seacruise.sea import _prisms

    metres = route.legs_m
    speeds = np.empty(metres.size)
    fuel = float(least[-1, tick])
    hours = tick * TICK_S / SECONDS_PER_HOUR
    for k in range(metres.size - 1, -1, -1):
        ends = route.x[k], route.y[k], route.x[k + 1], route.y[k + 1]
        for before in range(tick - 1, -1, -1):
            seconds = (tick - before) * TICK_S
            speed = metres[k] / seconds
            if not SLOWEST - 1e-9 <= speed <= FASTEST + 1e-9 or not np.isfinite(least[k, before]):
                continue
            if abs(least[k, before] + float(fuel_of(metres[k], seconds)) - least[k + 1, tick]) > 1e-9:
                continue
            a, b = T0 + before * TICK_S, T0 + tick * TICK_S
            if not zones or not _prisms.closed(zones.arrays, ends[0], ends[1], a, ends[2], ends[3], b):
                speeds[k], tick = speed, before
                break
    return Passage(route, hours, fuel, speeds)


# ---------------------------------------------------------------------------------------------- problems


def at_one_speed(route: Route, zones: Zones) -> list[Passage]:
    """Sail a route at one speed after another, where that touches no area."""
    found = []
    for speed in np.arange(FASTEST, SLOWEST - 1e-9, -0.01):
        times = T0 + np.concatenate([[0.0], np.cumsum(route.legs_m)]) / speed
        hours = float(times[-1] - T0) / SECONDS_PER_HOUR
        if hours > LONGEST_H:
            break
        if not touches(route, zones, times):
            fuel = float(fuel_rate(float(speed))) * hours
            found.append(Passage(route, hours, fuel, np.full(route.x.size - 1, speed)))
    return found


def touches(route: Route, zones: Zones, times: Array) -> bool:
    """Tell whether a route sailed at those times touches an area while that is valid."""
    from seacruise.sea import _prisms

    if not zones:
        return False
    corners = zip(route.x, route.y, times, strict=True)
    return any(_prisms.closed(zones.arrays, *a, *b) for a, b in itertools.pairwise(corners))


def passages(route: Route, zones: Zones) -> list[Passage]:
    """All that can be had of a route: at one speed, and for each arrival with the best speeds."""
    least = best_speeds(route, zones)
    varied = [read_back(route, zones, least, int(t)) for t in np.flatnonzero(np.isfinite(least[-1]))]
    return at_one_speed(route, zones) + varied


def solve(choice: list[Passage]) -> dict[str, Passage]:
    """Solve R4's four problems."""
    quickest = min(choice, key=lambda p: p.hours)
    even = [p for p in choice if np.ptp(p.speeds) < 1e-9]
    answers = {"(a) least time": quickest}
    answers["(a) at one speed all the way"] = min(even, key=lambda p: p.hours)
    for latest in LATEST_H:
        within = [p for p in choice if p.hours <= latest]
        if within:
            answers[f"(b) least fuel in {latest:g} h"] = min(within, key=lambda p: p.fuel)
        steady = [p for p in even if p.hours <= latest]
        if steady:
            answers[f"(b) in {latest:g} h, at one speed all the way"] = min(steady, key=lambda p: p.fuel)
    spared = [p for p in choice if p.fuel <= (1 - SAVING) * quickest.fuel]
    answers[f"(c) least time with {SAVING:.0%} less fuel than (a)"] = min(spared, key=lambda p: p.hours)
    as_quick = [p for p in choice if p.hours <= quickest.hours + ALIKE_H]
    answers["(d) shortest of least time"] = min(as_quick, key=lambda p: (round(p.route.km), p.hours))
    return answers


def main() -> None:
    """Print R4's example without areas, with those for good, with a storm, with a range."""
    sea = open_sea(-6.0, -4.0, 6.0, 6.0, cell=2000.0)
    print("| areas | problem | h | km | fuel, share of (a) | speeds m/s |")
    print("|---|---|---|---|---|---|")
    print("| R4's own, published | (a) least time | 30 | 1,002 | | |")
    seconds = []
    for title, zones in (
        ("none", NO_ZONES),
        ("two for good", Zones(SHOALS)),
        ("two for good and a storm", Zones(SHOALS + STORM)),
        ("two for good and a range", Zones((*SHOALS, RANGE))),
    ):
        begun = time.perf_counter()
        found = [route.cut() for route in routes(sea, zones)]
        searched = time.perf_counter()
        answers = solve([passage for route in found for passage in passages(route, zones)])
        done = time.perf_counter()
        full = answers["(a) least time"].fuel
        for problem, one in answers.items():
            speeds = sorted({round(float(v), 1) for v in one.speeds})
            told = f"{speeds[0]}" if speeds[0] == speeds[-1] else f"{speeds[0]} to {speeds[-1]}"
            figures = f"{one.hours:.2f} | {one.route.km:,.0f} | {one.fuel / full:.1%} | {told}"
            print(f"| {title} | {problem} | {figures} |")
        seconds.append(
            f"{title}: {len(found)} routes {searched - begun:.1f} s, speeds {done - searched:.1f} s"
        )
    print(f"\n{'; '.join(seconds)}.")
