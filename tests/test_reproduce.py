"""The tools behind docs/reference-systems.md: what they print must be what was sailed."""

from __future__ import annotations

import math

import numpy as np
import pytest

from seacruise.geodesy import EARTH_RADIUS
from seacruise.routing import lattice as lattices
from seacruise.routing import stencil
from seacruise.routing.field import Handling, speed_table, wind_field
from seacruise.routing.search import search
from seacruise.sea.zones import NO_ZONES, Zone, Zones
from seacruise.units import SECONDS_PER_HOUR
from tests.routing.worlds import T0, open_sea, sloop, steady_wind
from tools import reproduce, reproduce_motor
from tools.reproduce_motor import FASTEST, STEP_S, TICK_S, Route

GULF_ENDS = (54.65, 19.21), (54.60, 18.60)


def straight(pieces: int = 6) -> Route:
    """Make a route along the equator, of pieces of 45 km."""
    x = np.linspace(0.0, pieces * 45_000.0, pieces + 1)
    return Route(x, np.zeros_like(x))


def wall(*, step: int | None) -> Zone:
    """Close the fourth piece of the straight route."""
    west, east = (math.degrees(m / EARTH_RADIUS) for m in (140_000.0, 175_000.0))
    ring = np.array([[west, -1.0], [east, -1.0], [east, 1.0], [west, 1.0], [west, -1.0]])
    valid = () if step is None else (T0 + step * STEP_S, T0 + (step + 1) * STEP_S)
    return Zone("Wall", (ring,), *valid)


def test_in_still_water_one_speed_all_the_way_takes_least_fuel() -> None:
    """By convexity: fuel per mile grows with the square of speed, so an even speed cannot be bettered."""
    route = straight()
    least = reproduce_motor.best_speeds(route, NO_ZONES)
    metres = float(route.legs_m.sum())
    for hours in (6.0, 8.0, 12.0):
        tick = round(hours * SECONDS_PER_HOUR / TICK_S)
        even = (metres / (hours * SECONDS_PER_HOUR) / FASTEST) ** 3 * hours
        assert float(least[-1, tick]) == pytest.approx(even, rel=2e-3)
        assert float(least[-1, tick]) >= even * (1 - 1e-9)
        one = reproduce_motor.read_back(route, NO_ZONES, least, tick)
        seconds = float((route.legs_m / one.speeds).sum())
        assert seconds == pytest.approx(hours * SECONDS_PER_HOUR)
        assert float((reproduce_motor.fuel_of(45_000.0, 45_000.0 / one.speeds)).sum()) == pytest.approx(
            one.fuel
        )


def test_around_an_area_in_time_an_even_speed_is_not_the_best() -> None:
    route, zones = straight(), Zones((wall(step=1),))
    choice = reproduce_motor.passages(route, zones)
    for one in choice:
        times = T0 + np.cumsum([0.0, *(route.legs_m / one.speeds)])
        assert not reproduce_motor.touches(route, zones, times)
    # At full speed she would be in the wall from 3.1 to 3.9 h, while it is closed.
    quickest = min(choice, key=lambda one: one.hours)
    assert quickest.hours > 6.0 + 0.5
    even = [one for one in choice if np.ptp(one.speeds) < 1e-9]
    # At one speed she must be so slow that the wall is open again before she comes.
    latest = 10.0
    assert min(one.hours for one in even) > latest + 1.0
    assert quickest.hours <= latest
    assert min(one.fuel for one in choice if one.hours <= latest) < quickest.fuel


def test_a_wall_for_good_leaves_nothing_of_the_route() -> None:
    assert reproduce_motor.passages(straight(), Zones((wall(step=None),))) == []


def test_what_r3_s_table_tells_is_what_the_search_found() -> None:
    grid = lattices.grid(
        open_sea(),
        *GULF_ENDS,
        corners=reproduce.GULF,
        shape=(21, 42),
        offsets=stencil.rectangular(16),
    )
    departure = reproduce.DEPARTURE.timestamp()
    field = wind_field(steady_wind(12.0, 265.0), since=departure)
    speeds = speed_table(sloop(), Handling(tacking=False))
    free = reproduce.sail_on(grid, field, speeds)
    paid = reproduce.sail_on(grid, field, speeds, pauses=(0.0, 0.0, 6.0))
    assert free is not None
    assert paid is not None
    found = search(grid, field, speeds, departure)
    assert free.hours == pytest.approx((float(found.arrival[grid.end]) - departure) / 3600.0)
    assert free.points == found.path(grid.end).size
    assert free.penalties_h == 0.0
    assert paid.penalties_h > 0.0
    assert free.hours < paid.hours
    # What turns cost is weighed while searching: the free passage would have paid more for its own.
    assert paid.changes <= free.changes
