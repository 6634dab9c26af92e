"""What the crew likes: limits, waiting, the distance from the shore, and what a manoeuvre costs."""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable
from dataclasses import replace
from datetime import timedelta
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import shapely
from numpy.typing import NDArray

from seacruise.commands import request as ask
from seacruise.errors import InputError, NoPassageError
from seacruise.export.jsonform import passage_to_json
from seacruise.passage import Options, Passage, PassageRequest, plan
from seacruise.ports import Port, find_port, load_ports
from seacruise.resources import resource_path
from seacruise.sea import coast
from seacruise.sea.zones import NO_ZONES, Zone, Zones
from seacruise.settings import Settings
from seacruise.units import MS_PER_KNOT
from seacruise.weather.sample import sample_wind
from seacruise.weather.wind import Wind, from_direction
from seacruise.yacht.fleet import find_yacht, load_fleet
from seacruise.yacht.polar import Polar
from tests.routing.worlds import DEPARTURE, HOUR, T0, forecast, steady_wind

Array = NDArray[np.float64]
Plan = Callable[..., Passage]

SOUTH, NORTH = Port("South", "", 55.9, 19.3), Port("North", "", 56.9, 19.3)

BELT_SOUTH, BELT_NORTH = 56.25, 56.55
OPEN_WEST_OF = 18.6


@cache
def yacht() -> Polar:
    return find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")]))


@cache
def port(name: str) -> Port:
    return find_port(name, load_ports())


@cache
def dangerous(
    kind: str, *, west_free: bool = False, lifts_after_h: float = math.inf, everywhere: bool = False
) -> Wind:
    """Twelve knots from the west; a belt of high waves or gusts across the way, for a time or for ever."""
    south, north = (54.0, 59.0) if everywhere else (BELT_SOUTH, BELT_NORTH)
    lat, lon = np.arange(55.0, 58.001, 0.1), np.arange(17.0, 22.001, 0.1)
    belt = (lat[:, None] > south) & (lat[:, None] < north) & (lon[None, :] > 16.0)
    if west_free:
        belt &= lon[None, :] > OPEN_WEST_OF
    begin, last = T0 - HOUR, T0 + 99 * HOUR
    times = np.array([begin, last])
    if math.isfinite(lifts_after_h):
        times = np.array([begin, T0 + lifts_after_h * HOUR - 600.0, T0 + lifts_after_h * HOUR, last])
    there = times < T0 + lifts_after_h * HOUR - 300.0
    u, v = from_direction(np.full((times.size, *belt.shape), 12.0 * MS_PER_KNOT), 270.0)
    calm, wild = {"wave": (0.5, 4.0), "gust": (15.0 * MS_PER_KNOT, 35.0 * MS_PER_KNOT), "none": (0.0, 0.0)}[
        kind
    ]
    grid = np.where(there[:, None, None] & belt[None], wild, calm).astype(np.float32)
    more = {} if kind == "none" else {kind: grid}
    return Wind(
        times,
        lat,
        lon,
        u.astype(np.float32),
        v.astype(np.float32),
        forecast(begin, last),
        **more,  # type: ignore[arg-type]
    )


@pytest.fixture(scope="session")
def planned(sea_settings: Settings) -> Plan:
    """Plan, each question only once; by default the 60 nm from south to north in a steady wind."""

    @cache
    def find(
        wind: Wind, start: Port = SOUTH, end: Port = NORTH, zones: Zones = NO_ZONES, **options: Any
    ) -> Passage:
        asked = PassageRequest(start, end, yacht(), wind, DEPARTURE, Options(**options), zones)
        return plan(asked, settings=sea_settings)

    return find


@cache
def beam() -> Wind:
    return steady_wind(12.0, 270.0)


@cache
def ahead() -> Wind:
    return steady_wind(14.0, 0.0)


@cache
def astern() -> Wind:
    return steady_wind(14.0, 180.0)


def met(wind: Wind, grid: NDArray[np.float32] | None, passage: Passage) -> Array:
    """Give the values of a grid along the track, by the interpolation of somebody else."""
    from scipy.interpolate import RegularGridInterpolator

    assert grid is not None
    at = RegularGridInterpolator((wind.time, wind.lat, wind.lon), grid.astype(np.float64))
    track = passage.track
    # Between two samples as well: a grid cell is crossed in an hour, a sample lasts six minutes at most.
    fine = np.linspace(0.0, track.time.size - 1.0, 4 * track.time.size)
    number = np.arange(track.time.size)
    along = [np.interp(fine, number, values) for values in (track.time, track.lat, track.lon)]
    return np.asarray(at(np.stack(along, axis=1)))


LIMITS = (
    ("wave", {"max_wave_m": 2.0}, 2.0),
    ("gust", {"max_gust_kn": 25.0}, 25.0 * MS_PER_KNOT),
)
each_limit = pytest.mark.parametrize(("kind", "limit", "si"), LIMITS, ids=["waves", "gusts"])


# ----------------------------------------------------------------------------------- limits of the sea


@each_limit
def test_waves_and_gusts_beyond_the_limit_are_sailed_around(
    kind: str, limit: dict[str, float], si: float, planned: Plan
) -> None:
    wind = dangerous(kind, west_free=True)
    straight, around = planned(wind), planned(wind, **limit)
    grid = getattr(wind, kind)
    assert met(wind, grid, straight).max() > 1.3 * si
    assert met(wind, grid, around).max() <= si * 1.01
    assert around.checks.within_limits
    assert around.checks.land_free
    assert around.duration_h > straight.duration_h
    assert around.track.lon.min() < OPEN_WEST_OF + 0.05
    assert around.lower_bound_h <= straight.duration_h


@each_limit
def test_where_all_is_too_rough_the_limit_is_the_reason(
    kind: str, limit: dict[str, float], si: float, planned: Plan
) -> None:
    with pytest.raises(NoPassageError, match="waves or stronger gusts than you allow") as caught:
        planned(dangerous(kind), spacing_nm=4.0, **limit)
    assert caught.value.reason == "wind-limit"
    assert planned(dangerous(kind)).checks.within_limits


def test_a_limit_of_what_is_not_in_the_forecast_forbids_nothing_and_says_so(planned: Plan) -> None:
    wind = dangerous("none")
    free, limited = planned(wind), planned(wind, max_gust_kn=5.0, max_wave_m=0.1)
    assert limited.duration_h == pytest.approx(free.duration_h, rel=1e-4)
    assert limited.checks.within_limits
    (said,) = set(limited.notices) - set(free.notices)
    assert "neither gusts nor waves" in said
    waves_known = planned(dangerous("wave"), max_gust_kn=5.0)
    assert any("no gusts" in notice for notice in waves_known.notices)


def test_waves_over_the_real_wind_are_kept_below_the_limit(planned: Plan) -> None:
    """Visby to Ronne in the sample, with the waves of a swell that runs west of Oland's south cape."""
    plain = sample_wind()
    lat, lon = np.meshgrid(plain.lat, plain.lon, indexing="ij")
    wave = 0.5 + 3.0 * np.exp(-((lat - 56.0) ** 2) / 0.5 - (lon - 16.5) ** 2 / 0.8)
    wind = replace(plain, wave=np.broadcast_to(wave, plain.u.shape).astype(np.float32))
    ends = port("Visby"), port("Ronne")
    free, kept = planned(wind, *ends), planned(wind, *ends, max_wave_m=2.0)
    assert met(wind, wind.wave, free).max() > 2.2
    assert met(wind, wind.wave, kept).max() <= 2.02
    assert kept.checks.within_limits
    assert kept.duration_h > free.duration_h


# ---------------------------------------------------------------------------------------------- waiting


@each_limit
def test_she_waits_for_the_sea_to_calm_down(
    kind: str, limit: dict[str, float], si: float, planned: Plan
) -> None:
    wind = dangerous(kind, lifts_after_h=5.0)
    # Without waiting she wears away the time at sea, on a detour that ends when the belt has gone.
    detour = planned(wind, spacing_nm=4.0, **limit)
    waited = planned(wind, spacing_nm=4.0, may_wait_h=6.0, **limit)
    hours = (waited.departure - DEPARTURE).total_seconds() / HOUR
    assert 1.0 <= hours <= 5.0
    assert met(wind, getattr(wind, kind), waited).max() <= si * 1.01
    assert any(f"She waits {hours:.0f} h in South" in notice for notice in waited.notices)
    assert waited.waypoints[0].time == waited.departure
    assert waited.arrival <= detour.arrival
    # Departures are tried by the hour: at most that much is lost against arriving as the belt goes.
    free = planned(wind, spacing_nm=4.0)
    assert waited.duration_h <= free.duration_h + 1.0


def test_she_waits_where_there_is_no_way_without(planned: Plan) -> None:
    wind = dangerous("wave", lifts_after_h=6.0, everywhere=True)
    with pytest.raises(NoPassageError) as caught:
        planned(wind, spacing_nm=4.0, max_wave_m=2.0)
    assert caught.value.reason == "wind-limit"
    waited = planned(wind, spacing_nm=4.0, max_wave_m=2.0, may_wait_h=8.0)
    assert met(wind, wind.wave, waited).max() <= 2.02
    assert waited.departure - DEPARTURE == timedelta(hours=6)
    assert waited.duration_h == pytest.approx(planned(wind).duration_h, rel=5e-3)
    with pytest.raises(NoPassageError):
        planned(wind, spacing_nm=4.0, max_wave_m=2.0, may_wait_h=3.0)


def closed(lifts_after_h: float, *, west: float = 18.0, east: float = 20.6) -> Zones:
    ring = np.array([[west, 56.3], [east, 56.3], [east, 56.5], [west, 56.5], [west, 56.3]])
    return Zones((Zone("Firing range", (ring,), valid_to=T0 + lifts_after_h * HOUR),))


@cache
def long_range() -> Zones:
    return closed(5.0)


def test_waiting_for_a_zone_to_open_saves_the_way_around_it(planned: Plan) -> None:
    around = planned(beam(), spacing_nm=4.0, zones=long_range())
    waited = planned(beam(), spacing_nm=4.0, zones=long_range(), may_wait_h=6.0)
    assert around.departure == DEPARTURE
    assert waited.departure > DEPARTURE
    assert waited.arrival < around.arrival
    # Departures are tried by the hour.
    assert waited.duration_h <= planned(beam(), spacing_nm=4.0).duration_h + 1.0
    for passage in (around, waited):
        assert passage.checks.zones_free
        inside = (passage.track.lat > 56.301) & (passage.track.lat < 56.499)
        inside &= (passage.track.lon > 18.001) & (passage.track.lon < 20.599)
        assert not (inside & (passage.track.time < T0 + 5 * HOUR)).any()


@cache
def small_range() -> Zones:
    return closed(30.0, west=19.2, east=19.4)


def test_nobody_waits_a_day_for_a_detour_of_minutes(planned: Plan) -> None:
    now = planned(beam(), spacing_nm=4.0, zones=small_range())
    patient = planned(beam(), spacing_nm=4.0, zones=small_range(), may_wait_h=24.0)
    assert patient.arrival <= now.arrival
    assert patient.departure - DEPARTURE < timedelta(hours=1)


def test_with_nothing_forbidden_there_is_nothing_to_wait_for(planned: Plan) -> None:
    now, patient = planned(beam()), planned(beam(), may_wait_h=12.0)
    assert patient.departure == DEPARTURE
    assert patient.arrival == now.arrival
    assert patient.notices == now.notices


# ------------------------------------------------------------------------------- distance from the shore


def shore_nm(lat: Array, lon: Array) -> Array:
    """Distances to the fine coast [nm]: around each position a plane of its own, and shapely."""
    land, tree = coast.fine_land(), shapely.STRtree(coast.fine_land())
    away = np.full(lat.size, np.inf)
    for k, (y, x) in enumerate(zip(lat.tolist(), lon.tolist(), strict=True)):
        flat = math.cos(math.radians(y))
        near = tree.query(shapely.box(x - 0.3 / flat, y - 0.3, x + 0.3 / flat, y + 0.3))
        if near.size:
            shapes = shapely.transform(
                land[near], lambda c, x=x, y=y, f=flat: (c - (x, y)) * (60.0 * f, 60.0)
            )
            away[k] = float(shapely.distance(shapes, shapely.Point(0.0, 0.0)).min())
    return away


def each_mile(passage: Passage) -> tuple[Array, Array]:
    """Positions a mile apart along the track."""
    track = passage.track
    flat = np.cos(np.radians(track.lat[1:]))
    steps = 60.0 * np.hypot(np.diff(track.lat), np.diff(track.lon) * flat)
    sailed = np.concatenate([[0.0], np.cumsum(steps)])
    miles = np.arange(0.0, sailed[-1], 1.0)
    return np.interp(miles, sailed, track.lat), np.interp(miles, sailed, track.lon)


def from_ends_nm(passage: Passage, lat: Array, lon: Array) -> Array:
    ends = np.array([[p.lat, p.lon] for p in (passage.start, passage.end)])
    flat = np.cos(np.radians(lat))
    return np.asarray(np.min([60.0 * np.hypot(lat - a, (lon - o) * flat) for a, o in ends], axis=0))


@pytest.mark.parametrize("clearance", [2.0, 4.0])
def test_the_distance_from_the_shore_is_kept_outside_the_approaches(clearance: float, planned: Plan) -> None:
    """From the west of Gotland to Latvia: the straight line passes Gotland's northern capes."""
    ends = port("Visby"), port("Ventspils")
    passage = planned(beam(), *ends, shore_clearance_nm=clearance)
    lat, lon = each_mile(passage)
    room, away = shore_nm(lat, lon), from_ends_nm(passage, lat, lon)
    # Straight shores: a way out is as long as the clearance, give or take a bay.
    outside = away > 1.5 * clearance + 2.0
    cell = 0.1
    assert outside.sum() > 60
    assert room[outside].min() >= clearance - cell
    assert room[~outside].min() < clearance
    assert passage.duration_h >= planned(beam(), *ends).duration_h * 0.999
    assert passage.checks.land_free
    assert any(f"keeps {clearance:g} nm off every shore" in notice for notice in passage.notices)


def crossing_lon(passage: Passage, lat: float) -> float:
    """Give the easternmost longitude at which a passage crosses a parallel."""
    track = passage.track
    crossed = np.flatnonzero((track.lat[:-1] - lat) * (track.lat[1:] - lat) <= 0.0)
    assert crossed.size
    return float(track.lon[crossed].max())


OLAND_EAST = 16.85
"""Easternmost shore of Oland on the parallel of its middle [degrees]."""


def test_kalmar_sound_is_closed_to_who_wants_much_room(planned: Plan) -> None:
    ends = Port("Hanö Bay", "", 56.0, 15.9), Port("Off Västervik", "", 57.7, 17.0)
    through, outside = planned(beam(), *ends), planned(beam(), *ends, shore_clearance_nm=3.0)
    assert crossing_lon(through, 56.75) < 16.7
    assert crossing_lon(outside, 56.75) > OLAND_EAST
    lat, lon = each_mile(outside)
    away = from_ends_nm(outside, lat, lon)
    assert shore_nm(lat, lon)[away > 6.0].min() >= 2.9


def test_too_much_room_is_named_as_the_reason(planned: Plan) -> None:
    with pytest.raises(NoPassageError, match="keeps 14 nm off every shore") as caught:
        planned(beam(), port("Kiel"), port("Gdynia"), shore_clearance_nm=14.0)
    assert caught.value.reason == "no-water-path"


# ------------------------------------------------------------------------------------------- manoeuvres


def test_tacks_that_cost_time_are_fewer_and_paid_for(planned: Plan) -> None:
    free, paid = planned(ahead()), planned(ahead(), tack_penalty_min=5.0)
    assert paid.tacks < free.tacks
    assert paid.tacks >= 1
    assert free.manoeuvre_h == 0.0
    assert paid.manoeuvre_h == pytest.approx(paid.tacks * 5.0 / 60.0)
    assert paid.duration_h >= free.duration_h * 0.9995
    assert paid.duration_h <= free.duration_h + paid.manoeuvre_h + 0.002 * free.duration_h


def test_gybes_and_turns_are_paid_for(planned: Plan) -> None:
    free = planned(astern())
    gybed = planned(astern(), gybe_penalty_min=4.0)
    assert gybed.manoeuvre_h == pytest.approx(gybed.gybes * 4.0 / 60.0)
    assert gybed.gybes <= max(free.gybes, 1)
    turned = planned(ahead(), turn_penalty=0.5)
    legs = [w.course_deg for w in turned.waypoints if w.course_deg is not None]
    degrees = sum(abs((b - a + 180.0) % 360.0 - 180.0) for a, b in pairwise(legs))
    assert turned.manoeuvre_h * 60.0 == pytest.approx(0.5 * degrees / 10.0, rel=1e-3)
    assert turned.duration_h >= planned(ahead()).duration_h * 0.9995


def test_the_cost_of_turning_is_in_the_time_line(planned: Plan) -> None:
    paid = planned(ahead(), tack_penalty_min=5.0)
    legs = list(pairwise(paid.waypoints))
    hours = sum((b.time - a.time).total_seconds() for a, b in legs) / HOUR
    assert hours == pytest.approx(paid.duration_h)
    track = paid.track
    stopped = float(np.diff(track.time)[track.boat_speed_kn[:-1] == 0.0].sum())
    assert stopped == pytest.approx(paid.manoeuvre_h * HOUR, rel=1e-6)


def test_json_names_the_time_of_manoeuvres_only_where_they_cost_any(planned: Plan) -> None:
    free, paid = passage_to_json(planned(ahead())), passage_to_json(planned(ahead(), tack_penalty_min=5.0))
    assert "manoeuvre_h" not in free
    assert paid["manoeuvre_h"] == pytest.approx(planned(ahead(), tack_penalty_min=5.0).manoeuvre_h, abs=1e-4)
    assert set(paid) - set(free) == {"manoeuvre_h"}


def test_no_more_tacks_than_wanted(planned: Plan) -> None:
    free = planned(ahead())
    assert free.tacks + free.gybes > 2
    few = planned(ahead(), most_turns=2)
    assert few.tacks + few.gybes <= 2
    assert few.manoeuvre_h == 0.0, "the wish costs no time that nobody takes"
    assert few.duration_h >= free.duration_h * 0.9995
    assert not any("no passage with only" in notice for notice in few.notices)


def test_a_wish_that_cannot_be_had_is_answered(planned: Plan) -> None:
    """Dead to windward no yacht arrives on one tack."""
    none = planned(ahead(), most_turns=0)
    turns = none.tacks + none.gybes
    assert turns >= 1
    assert any(f"tacks and gybes {turns} times: no passage with only 0" in notice for notice in none.notices)


def test_boards_are_as_long_as_the_crew_likes(planned: Plan) -> None:
    def board_h(passage: Passage) -> float:
        return passage.duration_h / (passage.tacks + 1)

    usual, long, short = planned(ahead()), planned(ahead(), board_h=3.0), planned(ahead(), board_h=0.75)
    assert board_h(long) > 1.3 * board_h(usual) > 1.3 * board_h(short)
    assert long.duration_h == pytest.approx(usual.duration_h, rel=5e-3)
    assert short.duration_h == pytest.approx(usual.duration_h, rel=5e-3)


# ------------------------------------------------------------------- other lattices, and what is refused


@pytest.mark.parametrize(
    "options",
    [
        {"lattice": "rectangular"},
        {"lattice": "rectangular", "directions": 8},
        {"safety_radius_nm": 2.0, "safety_levels": 1},
        {"lattice": "rectangular", "directions": 16, "safety_radius_nm": 1.5, "safety_levels": 2},
    ],
    ids=str,
)
def test_other_lattices_lead_to_the_same_passage(options: dict[str, Any], planned: Plan) -> None:
    ends = port("Visby"), port("Vastervik")
    usual, other = planned(beam(), *ends), planned(beam(), *ends, **options)
    assert other.duration_h == pytest.approx(usual.duration_h, rel=0.01)
    assert other.checks.land_free
    assert other.lower_bound_h <= other.duration_h
    assert other.search.directions == options.get("directions", 32 if "lattice" in options else 36)


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"lattice": "rectangular", "directions": 12}, "rectangular lattice cannot have 12"),
        ({"lattice": "rectangular", "directions": 36}, "choose 8, 16, 32"),
        ({"directions": 8}, "triangular lattice cannot have 8"),
        ({"safety_radius_nm": 2.0}, "both, a radius and a number of levels"),
        ({"safety_levels": 2}, "both, a radius and a number of levels"),
        ({"safety_radius_nm": 40.0, "safety_levels": 2}, "0.1 to 15"),
        ({"safety_radius_nm": 2.0, "safety_levels": 7}, "safety levels"),
        ({"shore_clearance_nm": 15.1}, "distance from the shore"),
        ({"shore_clearance_nm": math.nan}, "distance from the shore"),
        ({"may_wait_h": -1.0}, "time to wait"),
        ({"tack_penalty_min": -1.0}, "cost of a tack"),
        ({"gybe_penalty_min": 121.0}, "cost of a gybe"),
        ({"turn_penalty": math.nan}, "penalty for turning"),
        ({"board_h": 0.0}, "length of boards"),
        ({"max_gust_kn": 0.0}, "limit of gusts"),
        ({"max_wave_m": math.inf}, "wave height"),
        ({"most_turns": -1}, "tacks and gybes"),
        ({"preset": "classic", "tack_penalty_min": 2.0}, "no cost of manoeuvres"),
        ({"preset": "classic", "turn_penalty": 2.0}, "no cost of manoeuvres"),
        ({"preset": "classic", "most_turns": 3}, "no cost of manoeuvres"),
        ({"preset": "classic", "lattice": "rectangular"}, "its own lattice"),
        ({"preset": "classic", "safety_radius_nm": 2.0, "safety_levels": 1}, "its own lattice"),
    ],
    ids=str,
)
def test_options_that_do_not_go_together(options: dict[str, Any], says: str, planned: Plan) -> None:
    with pytest.raises(InputError, match=says):
        planned(beam(), **options)


# ------------------------------------------------------------------------------------- the command line

FLAGS = (
    ("--max-gust", "32.5", "max_gust_kn", 32.5),
    ("--max-wave", "1.8", "max_wave_m", 1.8),
    ("--shore-clearance", "2.5", "shore_clearance_nm", 2.5),
    ("--tack-penalty", "3", "tack_penalty_min", 3.0),
    ("--gybe-penalty", "4,5", "gybe_penalty_min", 4.5),
    ("--turn-penalty", "0.5", "turn_penalty", 0.5),
    ("--boards", "3", "board_h", 3.0),
    ("--most-turns", "6", "most_turns", 6),
    ("--may-wait", "12", "may_wait_h", 12.0),
    ("--lattice", "rectangular", "lattice", "rectangular"),
    ("--safety-radius", "2", "safety_radius_nm", 2.0),
    ("--safety-levels", "3", "safety_levels", 3),
)


def said(*words: str) -> Options:
    parser = argparse.ArgumentParser(exit_on_error=False)
    ask.add_search_options(parser)
    return ask.options_from(parser.parse_args(words))


@pytest.mark.parametrize(("flag", "text", "field", "value"), FLAGS, ids=[flag[0] for flag in FLAGS])
def test_each_flag_sets_its_option_and_nothing_else(flag: str, text: str, field: str, value: Any) -> None:
    assert said(flag, text) == replace(Options(), **{field: value})
    assert said() == Options()


@pytest.mark.parametrize(
    ("flag", "text"),
    [
        ("--max-gust", "0"),
        ("--max-wave", "31"),
        ("--shore-clearance", "15.5"),
        ("--tack-penalty", "-1"),
        ("--gybe-penalty", "nan"),
        ("--turn-penalty", "much"),
        ("--boards", "25"),
        ("--most-turns", "2.5"),
        ("--may-wait", "241"),
        ("--lattice", "hexagonal"),
        ("--safety-radius", "16"),
        ("--safety-levels", "7"),
    ],
)
def test_figures_out_of_range_are_refused_before_anything_is_read(flag: str, text: str) -> None:
    with pytest.raises(argparse.ArgumentError, match=flag):
        said(flag, text)
