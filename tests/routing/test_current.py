"""Water that moves: what she makes good, what she steers, and that both searches agree about it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from seacruise.errors import NoPassageError
from seacruise.export.jsonform import passage_to_json
from seacruise.passage import Options, Passage, PassageRequest, plan
from seacruise.ports import Port
from seacruise.routing import _kernels
from seacruise.routing.backwards import latest_departures
from seacruise.routing.field import Handling, SpeedTable, WindField, speed_table, wind_field
from seacruise.routing.search import search
from seacruise.settings import Settings
from seacruise.units import MS_PER_KNOT
from seacruise.weather.wind import Current, Wind, from_direction
from seacruise.yacht.polar import Polar
from tests.routing.worlds import (
    DEPARTURE,
    HOUR,
    T0,
    cache_dir_of,
    drifter,
    holds_backwards,
    random_field,
    random_lattice,
    random_table,
    sloop,
    steady_wind,
    wind_of,
)

Array = NDArray[np.float64]
Plan = Callable[..., Passage]
seeds = st.integers(0, 2**32 - 1)
many = hypothesis_settings(max_examples=max(300, hypothesis_settings().max_examples))

SOUTH, NORTH = Port("South", "", 55.9, 19.3), Port("North", "", 56.9, 19.3)
APART_NM = 60.0405


def set_to(direction_deg: float, speed_kn: float, *, days: float = 10.0) -> Current:
    """Make a current that is the same everywhere and always."""
    flow = wind_of([T0 - HOUR, T0 + days * 24 * HOUR], [57.0], speed_kn * MS_PER_KNOT, direction_deg + 180.0)
    return Current(
        flow.time, flow.lat, flow.lon, flow.u, flow.v, replace(flow.forecast, source="Tide tables")
    )


FRESH = steady_wind(12.0, 270.0)
YACHT, SLOOP = drifter(), sloop()
EASTGOING, FAIR, FOUL = set_to(90.0, 2.0), set_to(0.0, 2.0), set_to(180.0, 2.0)


# -------------------------------------------------------------------------------------- speed made good


def speed_of(table: SpeedTable, u: float, v: float, heading: Array) -> Array:
    """Look the speed table up: linear in the wind speed and in the cosine of the angle."""
    grid, per_tws = table.arrays
    tws = math.hypot(u, v)
    cosine = -(u * np.sin(heading) + v * np.cos(heading)) / max(tws, 1e-9)
    row = min(tws * per_tws, grid.shape[0] - 1.000001)
    low, share = int(row), row - int(row)
    columns = np.linspace(-1.0, 1.0, grid.shape[1])
    below, above = (np.interp(cosine, columns, grid[r]) for r in (low, low + 1))
    return np.asarray(below * (1 - share) + above * share)


def by_all_headings(
    table: SpeedTable, wind: tuple[float, float], current: tuple[float, float], course: float
) -> Array:
    """Speeds over ground [m/s] on a course of every heading that keeps her on it, found one by one."""
    heading = course + np.radians(np.linspace(-179.995, 180.0, 36_000))
    speed = speed_of(table, *wind, heading)
    east, north = math.sin(course), math.cos(course)
    across = speed * np.sin(heading - course) + current[0] * north - current[1] * east
    along = speed * np.cos(heading - course) + current[0] * east + current[1] * north
    crossing = np.flatnonzero((across[:-1] * across[1:] <= 0.0) & (np.abs(np.diff(across)) < 0.1))
    share = across[crossing] / np.where(
        across[crossing] == across[crossing + 1], 1.0, -np.diff(across)[crossing]
    )
    return np.asarray(along[crossing] + share * np.diff(along)[crossing])


@cache
def hull() -> SpeedTable:
    return speed_table(sloop(), Handling())


def made_good(
    table: SpeedTable, wind: tuple[float, float], current: tuple[float, float], course: float
) -> float:
    """Ask the kernel, by day and in smooth water."""
    undisturbed = 1.0, 0.0, -1.0, 0.0
    east, north = math.sin(course), math.cos(course)
    return float(_kernels.made_good(*wind, *current, east, north, table.arrays, *undisturbed))


angles = st.floats(0.0, 2.0 * math.pi)


@many
@given(strength=st.floats(3.0, 12.0), blows=angles, drift=st.floats(0.05, 1.2), sets=angles, course=angles)
def test_made_good_is_the_best_of_all_headings(
    strength: float, blows: float, drift: float, sets: float, course: float
) -> None:
    wind = strength * math.sin(blows), strength * math.cos(blows)
    current = drift * math.sin(sets), drift * math.cos(sets)
    made = made_good(hull(), wind, current, course)
    best = by_all_headings(hull(), wind, current, course).max(initial=0.0)
    assert made == pytest.approx(max(best, 0.0), abs=0.02)


@many
@given(seed=seeds, drift=st.floats(0.05, 3.0), sets=angles, course=angles)
def test_what_is_made_good_can_be_steered_with_any_table(
    seed: int, drift: float, sets: float, course: float
) -> None:
    """Whatever the polar looks like: speed through the water carries her along the course, or she stays."""
    rng = np.random.default_rng(seed)
    table = random_table(rng)
    u, v = rng.uniform(-9.0, 9.0, 2)
    east, north = math.sin(course), math.cos(course)
    set_east, set_north = drift * math.sin(sets), drift * math.cos(sets)
    made = made_good(table, (u, v), (set_east, set_north), course)
    assert made >= 0.0
    if made > 0.0:
        through = made * east - set_east, made * north - set_north
        need = math.hypot(*through)
        have = float(speed_of(table, u, v, np.array(math.atan2(*through))))
        # Where the table jumps from nought she could do better than she need; never worse.
        assert have >= need - 0.02


def test_in_still_water_it_is_the_boat_speed() -> None:
    for course in np.radians(np.arange(0.0, 360.0, 7.0)):
        made = made_good(hull(), (0.0, -8.0), (0.0, 0.0), float(course))
        assert made == pytest.approx(float(speed_of(hull(), 0.0, -8.0, np.array(course))), abs=1e-4)


def test_a_stream_stronger_than_she_is_lets_her_go_nowhere_against_it() -> None:
    against, along = (made_good(hull(), (0.0, -6.0), (0.0, -20.0), course) for course in (0.0, math.pi))
    assert against == 0.0
    assert along > 20.0


# ------------------------------------------------------------------------------ forwards and backwards


def random_stream(rng: np.random.Generator, *, most: float = 1.5) -> WindField:
    """Winds and currents that both jump from slice to slice, the current on a grid of its own."""
    field = random_field(rng)
    slices = field.arrays[0].shape[0]
    cu, cv = rng.uniform(-most, most, (2, slices, 5, 3)).astype(np.float32)
    drift = float(np.hypot(cu, cv).max())
    # No danger, by day, in smooth water: what the field of a mere current has behind its stream.
    _, *rest = wind_field(FRESH, current=FAIR).arrays[8:]
    return replace(field, arrays=(*field.arrays, (cu, cv, 56.0, 2.0, 17.0, 0.8), *rest), drift=drift)


@many
@given(seed=seeds, hours=st.floats(0.5, 60.0))
@example(seed=1981, hours=32.109375)
def test_leaving_at_the_latest_arrives_through_a_current(seed: int, hours: float) -> None:
    rng = np.random.default_rng(seed)
    lattice, field, speeds = random_lattice(rng, 12), random_stream(rng), random_table(rng)
    deadline = T0 + hours * HOUR
    latest = latest_departures(lattice, field, speeds, deadline)
    for vertex in range(lattice.vertices):
        leave = float(latest.departure[vertex])
        away = math.hypot(
            lattice.x[vertex] - lattice.x[lattice.end], lattice.y[vertex] - lattice.y[lattice.end]
        )
        if vertex == lattice.end or away == 0.0:
            continue
        homewards = replace(lattice, start=vertex)
        if np.isfinite(leave):
            assert search(homewards, field, speeds, leave).arrival[lattice.end] <= deadline
        later = max(leave, T0 - 1000 * HOUR) + 1.0
        # Where the wind freshens, who leaves a second later may arrive hardly later at all.
        assert search(homewards, field, speeds, later).arrival[lattice.end] > deadline - 0.1


@many
@given(seed=seeds, hours=st.floats(-3.0, 40.0))
def test_an_edge_in_a_current_is_the_same_backwards(seed: int, hours: float) -> None:
    rng = np.random.default_rng(seed)
    lattice, field, speeds = random_lattice(rng, 4), random_stream(rng), random_table(rng)
    holds_backwards(lattice, field, speeds, T0 + hours * HOUR)


@given(seed=seeds, hours=st.floats(0.0, 30.0), waits=st.floats(0.0, 20.0))
def test_in_a_current_leaving_later_never_arrives_earlier(seed: int, hours: float, waits: float) -> None:
    rng = np.random.default_rng(seed)
    lattice, field, speeds = random_lattice(rng, 15), random_stream(rng), random_table(rng)
    first, second = (
        search(lattice, field, speeds, T0 + h * HOUR).arrival[lattice.end] for h in (hours, hours + waits)
    )
    assert second >= first - 1e-6


# --------------------------------------------------------------------------------------------- passages


@pytest.fixture(scope="module")
def across(tmp_path_factory: pytest.TempPathFactory) -> Plan:
    """Plan the 60 nm from south to north, each question only once."""
    base = tmp_path_factory.getbasetemp()
    folders = Settings(cache_dir=cache_dir_of(base), data_dir=base / "data")

    @cache
    def find(wind: Wind, polar: Polar, current: Current | None = None, **options: Any) -> Passage:
        asked = PassageRequest(SOUTH, NORTH, polar, wind, DEPARTURE, Options(**options), current=current)
        return plan(asked, settings=folders)

    return find


def through_water_kn(current: Current) -> float:
    """Speed of the drifter, who sails at the speed of the wind that the moving water feels [kn]."""
    u, v = FRESH.u[0, 0, 0] - current.u[0, 0, 0], FRESH.v[0, 0, 0] - current.v[0, 0, 0]
    return float(np.hypot(u, v)) / MS_PER_KNOT


@pytest.mark.parametrize("current", [EASTGOING, FAIR, FOUL], ids=["across", "fair", "foul"])
def test_an_even_current_takes_the_time_of_the_triangle(current: Current, across: Plan) -> None:
    passage = across(FRESH, YACHT, current)
    speed, east = through_water_kn(current), float(current.u[0, 0, 0]) / MS_PER_KNOT
    made = math.sqrt(speed**2 - east**2) + float(current.v[0, 0, 0]) / MS_PER_KNOT
    assert passage.duration_h == pytest.approx(APART_NM / made, rel=2e-3)
    assert passage.lower_bound_h <= passage.duration_h
    for leg in passage.waypoints[:-1]:
        assert leg.sog_kn == pytest.approx(made, rel=5e-3)
        assert leg.boat_speed_kn == pytest.approx(speed, rel=5e-3)


@pytest.mark.parametrize(("sets", "side"), [(90.0, -1.0), (270.0, 1.0)])
def test_she_steers_up_against_the_stream(sets: float, side: float, across: Plan) -> None:
    current = set_to(sets, 2.0)
    passage = across(FRESH, YACHT, current)
    expected = side * math.degrees(math.asin(2.0 / through_water_kn(current)))
    for leg in passage.waypoints[:-1]:
        assert leg.steer_deg is not None
        assert leg.course_deg is not None
        off = (leg.steer_deg - leg.course_deg + 180.0) % 360.0 - 180.0
        assert off == pytest.approx(expected, abs=0.3)
        assert leg.current_kn == pytest.approx(2.0, rel=1e-5)
        assert leg.current_to_deg == pytest.approx(sets, abs=1e-3)


def test_a_current_that_is_not_reckoned_with_does_nothing(across: Plan) -> None:
    plain = across(FRESH, YACHT)
    for wind, current in ((FRESH, FOUL), (replace(FRESH, current=FOUL), None)):
        passage = across(wind, YACHT, current, currents=False)
        assert passage.duration_h == plain.duration_h
        assert across(wind, YACHT, current).duration_h > plain.duration_h + 0.5
        assert all(leg.current_kn is None for leg in passage.waypoints)
        assert passage.notices == plain.notices


def test_a_fair_current_helps_and_a_foul_one_does_not(across: Plan) -> None:
    hours = [across(FRESH, SLOOP, current).duration_h for current in (FAIR, None, FOUL)]
    assert hours[0] < hours[1] < hours[2]
    assert any("Tide tables" in notice for notice in across(FRESH, SLOOP, FAIR).notices)


def test_what_is_sailed_again_is_what_the_search_promised(across: Plan) -> None:
    """Close-hauled through a current that turns with the hours."""
    times = T0 + np.arange(-1.0, 49.0, 1.0) * HOUR
    u, v = from_direction(np.full(times.size, 1.5 * MS_PER_KNOT), 60.0 * np.arange(times.size) / 2.0)
    turning = Current(
        times,
        np.array([57.0]),
        np.array([19.0]),
        u.reshape(-1, 1, 1).astype(np.float32),
        v.reshape(-1, 1, 1).astype(np.float32),
        FRESH.forecast,
    )
    passage = across(steady_wind(14.0, 330.0), SLOOP, turning)
    assert passage.lower_bound_h <= passage.duration_h
    still = across(steady_wind(14.0, 330.0), SLOOP)
    # The stream goes once round in twelve hours: what it takes it mostly gives back.
    assert passage.duration_h == pytest.approx(still.duration_h, rel=0.15)
    track = passage.track
    sailed = 60.0 * np.hypot(np.diff(track.lat), np.diff(track.lon) * np.cos(np.radians(track.lat[1:])))
    assert sailed.sum() == pytest.approx(passage.distance_nm, rel=5e-3)


CURRENT_KEYS = {"sog_kn", "steer_deg", "current_kn", "current_to_deg"}


def test_json_tells_of_the_current_only_where_there_is_one(across: Plan) -> None:
    still, moving = (passage_to_json(across(FRESH, SLOOP, c)) for c in (None, EASTGOING))
    assert set(still) == set(moving)
    assert not any(CURRENT_KEYS & set(waypoint) for waypoint in still["waypoints"])
    *legs, last = moving["waypoints"]
    for leg in legs:
        assert set(leg) >= CURRENT_KEYS
        assert all(leg[key] is not None for key in CURRENT_KEYS)
    assert not CURRENT_KEYS & set(last)


def test_a_current_that_came_with_the_wind_is_sailed_in(across: Plan) -> None:
    with_wind = replace(FRESH, current=FAIR)
    assert across(with_wind, SLOOP).duration_h == across(FRESH, SLOOP, FAIR).duration_h
    # One given besides is taken instead.
    assert across(with_wind, SLOOP, FOUL).duration_h == across(FRESH, SLOOP, FOUL).duration_h


def test_against_a_stream_stronger_than_she_is_she_never_arrives(across: Plan) -> None:
    light, torrent = steady_wind(5.0, 270.0), set_to(180.0, 9.0)
    with pytest.raises(NoPassageError, match="becalmed") as caught:
        across(light, SLOOP, torrent, spacing_nm=5.0)
    assert caught.value.reason == "becalmed"


def test_the_engine_stems_what_the_sails_do_not(across: Plan) -> None:
    calm, foul = steady_wind(0.0, 0.0), set_to(180.0, 3.0)
    passage = across(calm, SLOOP, foul, motor_below_kn=2.0, motor_speed_kn=6.0, spacing_nm=5.0)
    assert passage.duration_h == pytest.approx(APART_NM / 3.0, rel=5e-3)
    assert passage.motor_h == pytest.approx(passage.duration_h, rel=1e-3)
