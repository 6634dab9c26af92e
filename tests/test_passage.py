"""One passage, start to end: what is found is the fastest, is sailed, and touches no land."""

from __future__ import annotations

import math
import threading
from collections.abc import Callable
from dataclasses import replace
from datetime import datetime, timedelta
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import shapely
from numpy.typing import NDArray

from seacruise import passage as passage_module
from seacruise.errors import CancelledError, InputError, NoPassageError
from seacruise.export.jsonform import dumps, passage_to_json
from seacruise.passage import Options, Passage, PassageRequest, Waypoint, plan
from seacruise.ports import Port, find_port, load_ports
from seacruise.progress import Job
from seacruise.resources import resource_path
from seacruise.routing.find import Finder
from seacruise.sea import Sea, coast, globe
from seacruise.settings import Settings
from seacruise.units import MS_PER_KNOT
from seacruise.weather.sample import sample_wind
from seacruise.weather.wind import Wind, from_direction
from seacruise.yacht.fleet import find_yacht, load_fleet
from seacruise.yacht.hull import hull_speed
from seacruise.yacht.polar import Polar
from tests.routing.worlds import (
    DEPARTURE,
    HOUR,
    PRECISE,
    T0,
    cache_dir_of,
    drifter,
    fastest,
    forecast,
    question,
    steady_wind,
)

Array = NDArray[np.float64]
Plan = Callable[..., Passage]

EIGHT = (
    ("Gdynia", "Stockholm"),
    ("Stockholm", "Gdynia"),
    ("Klaipeda", "Swinoujscie"),
    ("Swinoujscie", "Klaipeda"),
    ("Karlskrona", "Swinoujscie"),
    ("Kiel", "Helsinki"),
    ("Visby", "Ronne"),
    ("Travemunde", "Tallinn"),
)
by_name = pytest.mark.parametrize(("start", "end"), EIGHT, ids=str)

# R1's twelve courses and its dead angle leave no way here; ours do.
BLOCKED_FOR_R1 = {("Kiel", "Helsinki"), ("Travemunde", "Tallinn")}
PUBLISHED = [(*ends, "precise") for ends in EIGHT] + [
    (*ends, "classic") for ends in EIGHT if ends not in BLOCKED_FOR_R1
]

SOUTH, NORTH = Port("South", "", 55.9, 19.3), Port("North", "", 56.9, 19.3)
APART_NM = 60.0405


@cache
def yacht() -> Polar:
    return find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")]))


@cache
def sample() -> Wind:
    return sample_wind()


@pytest.fixture(scope="session")
def sea_settings(tmp_path_factory: pytest.TempPathFactory) -> Settings:
    """Share the rasters of the sea with all tests of the session."""
    base = tmp_path_factory.getbasetemp()
    return Settings(cache_dir=cache_dir_of(base), data_dir=base / "data")


@pytest.fixture(scope="session")
def baltic(sea_settings: Settings) -> Sea:
    return Sea.around((57.0,), (18.0,), margin_deg=1.0, cache_dir=sea_settings.cache_dir)


@pytest.fixture(scope="session")
def planned(sea_settings: Settings) -> Plan:
    """Plan a passage between named ports in the sample wind, each only once."""

    @cache
    def find(start: str, end: str, preset: Any = "precise") -> Passage:
        ports = load_ports()
        ends = find_port(start, ports), find_port(end, ports)
        request = PassageRequest(*ends, yacht(), sample(), DEPARTURE, Options(preset=preset))
        return plan(request, settings=sea_settings)

    return find


@pytest.fixture
def across(sea_settings: Settings) -> Plan:
    """Plan the 60 nm from south to north over open water."""

    def find(
        wind: Wind, polar: Polar | None = None, *, start: Port = SOUTH, end: Port = NORTH, **options: Any
    ) -> Passage:
        request = PassageRequest(start, end, polar or yacht(), wind, DEPARTURE, Options(**options))
        return plan(request, settings=sea_settings)

    return find


def legs_of(passage: Passage) -> list[tuple[Waypoint, Waypoint]]:
    return list(pairwise(passage.waypoints))


def given(value: float | None) -> float:
    assert value is not None
    return value


def psi(lat: float) -> float:
    """Isometric latitude."""
    return math.asinh(math.tan(math.radians(lat)))


def rhumb(here: Waypoint, there: Waypoint) -> tuple[float, float]:
    """Course [degrees] and length [nm] on the sphere, by the textbook."""
    dlat, dlon = math.radians(there.lat - here.lat), math.radians(there.lon - here.lon)
    dpsi = psi(there.lat) - psi(here.lat)
    q = dlat / dpsi if abs(dpsi) > 1e-10 else math.cos(math.radians(here.lat))
    return math.degrees(math.atan2(dlon, dpsi)) % 360.0, math.hypot(dlat, q * dlon) * 6371.0088 / 1.852


def sampled(passage: Passage, *, step_nm: float = 0.05) -> tuple[Array, Array]:
    """Positions along the rhumb lines of the legs, and at every waypoint."""
    lat, lon = [passage.waypoints[0].lat], [passage.waypoints[0].lon]
    for here, there in legs_of(passage):
        pieces = max(1, math.ceil(rhumb(here, there)[1] / step_nm))
        p0, p1 = psi(here.lat), psi(there.lat)
        for k in range(1, pieces + 1):
            lat.append(math.degrees(math.atan(math.sinh(p0 + (p1 - p0) * k / pieces))))
            lon.append(here.lon + (there.lon - here.lon) * k / pieces)
    return np.array(lat), np.array(lon)


# ------------------------------------------------------------------------------------ the eight passages


@by_name
def test_no_metre_of_it_is_on_land(start: str, end: str, planned: Plan) -> None:
    passage = planned(start, end)
    lat, lon = sampled(passage)
    points = np.stack([lon, lat], axis=1)
    steps = shapely.linestrings(np.stack([points[:-1], points[1:]], axis=1))
    tree = shapely.STRtree(coast.fine_land())
    touching = np.unique(tree.query(steps, predicate="intersects")[0])
    assert touching.size == 0, points[touching[:5]].tolist()
    assert len(steps) >= passage.distance_nm / 0.05
    assert passage.checks.land_free


@by_name
def test_precise_is_never_slower_than_classic(start: str, end: str, planned: Plan) -> None:
    if (start, end) in BLOCKED_FOR_R1:
        with pytest.raises(NoPassageError) as caught:
            planned(start, end, "classic")
        assert caught.value.reason == "dead-angle"
    else:
        assert planned(start, end).duration_h <= planned(start, end, "classic").duration_h


@by_name
def test_what_the_search_promised_is_what_is_sailed(start: str, end: str, planned: Plan, baltic: Sea) -> None:
    passage = planned(start, end)
    ends = [(place.lat, place.lon) for place in (passage.start, passage.end)]
    line = fastest(question(baltic, sample(), yacht(), *ends, how=PRECISE)).line
    assert passage.duration_h == pytest.approx(line.seconds / HOUR, rel=5e-3)
    assert passage.checks.resailed_h == pytest.approx(passage.duration_h, abs=1e-6)


@pytest.mark.parametrize(("start", "end", "preset"), PUBLISHED, ids=str)
def test_legs_are_consistent(start: str, end: str, preset: str, planned: Plan) -> None:
    passage = planned(start, end, preset)
    total_nm = 0.0
    for here, there in legs_of(passage):
        course, length = rhumb(here, there)
        assert given(here.course_deg) == pytest.approx(course, abs=0.1)
        assert given(here.leg_nm) == pytest.approx(length, rel=1e-3, abs=1e-4)
        hours = (there.time - here.time).total_seconds() / HOUR
        assert hours > 0.0
        assert given(here.boat_speed_kn) * hours == pytest.approx(length, rel=2e-3, abs=1e-3)
        tws, twd = wind_at(sample(), here)
        assert given(here.tws_kn) == pytest.approx(tws, rel=1e-6)
        assert (given(here.twd_deg) - twd + 180.0) % 360.0 - 180.0 == pytest.approx(0.0, abs=1e-6)
        twa = (twd - given(here.course_deg) + 180.0) % 360.0 - 180.0
        assert given(here.twa_deg) == pytest.approx(abs(twa), abs=1e-6)
        # Where there is no room to plan the boards, the course made good lies between the tacks.
        side = "starboard" if twa >= 0 else "port"
        assert here.tack == side or (here.tack == "both" and (abs(twa) < 50.0 or abs(twa) > 140.0))
        assert here.motor is False
        total_nm += length
    last = passage.waypoints[-1]
    assert (last.course_deg, last.leg_nm, last.boat_speed_kn, last.twa_deg) == (None,) * 4
    assert total_nm == pytest.approx(passage.distance_nm, rel=1e-4)
    assert passage.mean_speed_kn == pytest.approx(passage.distance_nm / passage.duration_h)
    assert passage.course_changes == len(passage.waypoints) - 2


@by_name
def test_figures_of_the_whole_are_consistent(start: str, end: str, planned: Plan) -> None:
    passage = planned(start, end)
    first, last = passage.waypoints[0], passage.waypoints[-1]
    assert (first.lat, first.lon) == pytest.approx((passage.start.lat, passage.start.lon), abs=1e-6)
    assert (last.lat, last.lon) == pytest.approx((passage.end.lat, passage.end.lon), abs=1e-6)
    assert (first.time, passage.departure) == (DEPARTURE, DEPARTURE)
    assert abs(last.time - passage.arrival) < timedelta(milliseconds=1)
    assert passage.distance_nm >= passage.direct_distance_nm * 0.9999
    horizon = sample().forecast.valid_to
    beyond = max(0.0, (passage.arrival - horizon).total_seconds() / HOUR)
    assert passage.beyond_forecast_h == pytest.approx(beyond, abs=1e-3)
    assert bool(beyond) == any("held" in notice for notice in passage.notices)
    assert 0.5 * passage.duration_h < passage.lower_bound_h <= passage.duration_h
    assert (passage.motor_h, passage.fuel_l) == (0.0, 0.0)
    assert passage.max_tws_kn == pytest.approx(passage.track.tws_kn.max())
    assert sample().forecast.notice in passage.notices
    assert passage.search.vertices > 100
    assert set(passage.search.seconds) == {"sea", "lattice", "wind", "search", "refine", "check"}


@by_name
def test_the_track_is_the_passage(start: str, end: str, planned: Plan) -> None:
    passage = planned(start, end)
    track = passage.track
    assert (np.diff(track.time) >= 0.0).all()
    assert np.diff(track.time).max() <= 360.0 + 1e-6
    assert (np.diff(track.leg) >= 0).all()
    assert track.leg[-1] == len(passage.waypoints) - 2
    for number, (here, _) in enumerate(legs_of(passage)):
        k = int(np.argmax(track.leg == number))
        assert track.time[k] == pytest.approx(here.time.timestamp(), abs=1e-3)
        assert (track.lat[k], track.lon[k]) == pytest.approx((here.lat, here.lon), abs=1e-9)
    # The speed of each sample is the polar's, or the hull's where the water is too narrow for boards.
    sailing = ~track.motor
    tws, twa = track.tws_kn[sailing] * MS_PER_KNOT, track.twa_deg[sailing]
    polar = yacht().speed(tws, twa) / MS_PER_KNOT
    hull = np.array([float(hull_speed(yacht(), w, a)[0, 0]) for w, a in zip(tws, twa, strict=True)])
    speed = track.boat_speed_kn[sailing]
    assert (speed >= polar * (1 - 4e-3)).all()
    assert (speed <= hull / MS_PER_KNOT * (1 + 4e-3)).all()
    direct = speed < polar * 1.01
    assert float(np.mean(speed[direct] / polar[direct])) == pytest.approx(1.0, abs=5e-4)


def wind_at(wind: Wind, point: Waypoint) -> tuple[float, float]:
    u, v = wind.at(point.time.timestamp(), point.lat, point.lon)
    return math.hypot(u, v) / MS_PER_KNOT, math.degrees(math.atan2(-u, -v)) % 360.0


# --------------------------------------------------------------------------------------- one wind for all


@pytest.mark.parametrize(
    ("wind_from", "within"), [(90.0, 3e-3), (270.0, 3e-3), (225.0, 3e-3), (120.0, 3e-3), (55.0, 3e-3)]
)
def test_reaches_take_distance_by_boat_speed(wind_from: float, within: float, across: Plan) -> None:
    passage = across(steady_wind(14.0, wind_from))
    speed = float(yacht().speed(14.0 * MS_PER_KNOT, wind_from)) / MS_PER_KNOT
    assert passage.duration_h == pytest.approx(APART_NM / speed, rel=within)
    assert passage.distance_nm == pytest.approx(APART_NM, rel=1e-3)
    assert (passage.tacks, passage.gybes) == (0, 0)


def test_a_dead_beat_is_tacked_at_the_best_vmg(across: Plan) -> None:
    passage = across(steady_wind(14.0, 0.0))
    _, vmg = yacht().best_vmg(14.0 * MS_PER_KNOT, upwind=True)
    assert passage.duration_h == pytest.approx(APART_NM * MS_PER_KNOT / float(vmg), rel=2e-2)
    assert passage.tacks > 0
    assert {w.tack for w, _ in legs_of(passage)} == {"port", "starboard"}


def test_a_run_is_gybed_at_the_best_vmg(across: Plan) -> None:
    passage = across(steady_wind(14.0, 180.0))
    _, vmg = yacht().best_vmg(14.0 * MS_PER_KNOT, upwind=False)
    direct = float(yacht().speed(14.0 * MS_PER_KNOT, 180.0))
    assert passage.duration_h == pytest.approx(APART_NM * MS_PER_KNOT / max(float(vmg), direct), rel=1e-2)
    assert passage.tacks == 0
    assert (passage.gybes > 0) == (float(vmg) > 1.005 * direct)


def test_half_the_polar_takes_twice_the_time(across: Plan) -> None:
    wind = steady_wind(14.0, 70.0)
    hours = [across(wind, percent_of_polar=p).duration_h for p in (100.0, 80.0, 50.0)]
    assert hours == pytest.approx([hours[0], hours[0] / 0.8, hours[0] / 0.5], rel=1e-3)


def test_in_a_steady_wind_the_hour_does_not_matter(sea_settings: Settings) -> None:
    wind = steady_wind(14.0, 40.0)
    request = PassageRequest(SOUTH, NORTH, yacht(), wind, DEPARTURE)
    later = replace(request, departure=DEPARTURE + timedelta(hours=31, minutes=7))
    one, two = (plan(r, settings=sea_settings).duration_h for r in (request, later))
    assert two == pytest.approx(one, rel=1e-4)


def test_a_faster_yacht_is_not_later_and_more_courses_are_not_slower(across: Plan) -> None:
    faster = replace(yacht(), speed_table=yacht().speed_table * 1.1)
    assert across(sample(), faster).duration_h <= across(sample()).duration_h
    hours = [across(sample(), directions=d, refine=False, spacing_nm=3.0).duration_h for d in (12, 24, 72)]
    # Sailed again, with tacks put in, a third of a percent may change sides.
    assert hours[2] <= hours[1] * 1.003 <= hours[0] * 1.006


@pytest.mark.parametrize("ends", [(SOUTH, NORTH), (NORTH, SOUTH)])
def test_without_the_corridor_the_passage_is_nearly_as_good(across: Plan, ends: tuple[Port, Port]) -> None:
    ways: tuple[dict[str, Any], ...] = ({}, {"refine": False}, {"corridor": False})
    best, first, quick = (across(sample(), start=ends[0], end=ends[1], **way).duration_h for way in ways)
    assert best * 0.999 <= quick <= best * 1.002
    assert quick <= first


def test_later_is_never_earlier(sea_settings: Settings) -> None:
    request = PassageRequest(SOUTH, NORTH, yacht(), sample(), DEPARTURE)
    arrivals = [
        plan(replace(request, departure=DEPARTURE + timedelta(hours=h)), settings=sea_settings).arrival
        for h in range(0, 24, 4)
    ]
    assert arrivals == sorted(arrivals)


# ------------------------------------------------------------------------------------------------ engine


def calm(*, days: float = 5.0) -> Wind:
    return steady_wind(0.0, 0.0, days=days)


def test_in_a_calm_the_engine_carries_her(across: Plan) -> None:
    passage = across(calm(), motor_below_kn=2.0, motor_speed_kn=6.0, fuel_rate_l_h=3.0)
    assert passage.duration_h == pytest.approx(APART_NM / 6.0, rel=1e-3)
    assert passage.motor_h == pytest.approx(passage.duration_h, rel=1e-6)
    assert passage.fuel_l == pytest.approx(3.0 * passage.motor_h)
    for here, _ in legs_of(passage):
        assert here.motor is True
        assert here.tack is None
        assert here.boat_speed_kn == pytest.approx(6.0, rel=1e-3)
    assert passage.track.motor.all()
    assert (passage.tacks, passage.gybes) == (0, 0)


def test_the_engine_stops_when_the_wind_comes(across: Plan) -> None:
    begin, lifts = T0 - HOUR, T0 + 4 * HOUR
    times = np.array([begin, lifts, lifts + 60.0, T0 + 100 * HOUR])
    u, v = from_direction(np.array([0.0, 0.0, 14.0, 14.0]) * MS_PER_KNOT, 90.0)
    at, over = np.array([57.0]), np.array([19.0])
    shape = (4, 1, 1)
    wind = Wind(times, at, over, u.reshape(shape), v.reshape(shape), forecast(begin, times[-1]))  # type: ignore[arg-type]
    passage = across(wind, motor_below_kn=2.0, motor_speed_kn=5.0)
    sailing = float(yacht().speed(14.0 * MS_PER_KNOT, 90.0)) / MS_PER_KNOT
    assert passage.motor_h == pytest.approx(4.0, abs=0.11)
    assert passage.duration_h == pytest.approx(4.0 + (APART_NM - 20.0) / sailing, rel=1e-2)
    assert passage.fuel_l == pytest.approx(2.5 * passage.motor_h)
    track = passage.track
    assert track.motor[track.time < lifts - 360.0].all()
    assert not track.motor[(track.time > lifts + 360.0) & (track.time < track.time[-1])].any()


def test_an_engine_never_slows_her_down(across: Plan) -> None:
    under_sail = across(sample())
    with_engine = across(sample(), motor_below_kn=4.0, motor_speed_kn=5.0)
    assert with_engine.duration_h <= under_sail.duration_h * 1.001


# ---------------------------------------------------------------------------------------------- reasons


def gale_in_the_middle(*, west_free: bool) -> Wind:
    """Twelve knots from the west, and thirty in a belt across the way; or open at its western end."""
    lat, lon = np.arange(55.0, 58.001, 0.1), np.arange(17.0, 22.001, 0.1)
    belt = (np.abs(lat[:, None] - 56.4) < 0.15) & ((lon[None, :] > 18.6) | (not west_free))
    u, v = from_direction(np.where(belt, 30.0, 12.0) * MS_PER_KNOT, 270.0)
    begin = T0 - HOUR
    times = np.array([begin, begin + 100 * HOUR])
    u, v = (np.repeat(c[None], 2, axis=0) for c in (u, v))
    return Wind(times, lat, lon, u, v, forecast(begin, times[-1]))  # type: ignore[arg-type]


def test_more_wind_than_allowed_is_sailed_around(across: Plan) -> None:
    wind = gale_in_the_middle(west_free=True)
    straight, around = across(wind), across(wind, max_wind_kn=20.0)
    assert straight.max_tws_kn > 29.0
    assert around.max_tws_kn <= 20.0 * 1.005
    assert around.checks.within_limits
    assert around.duration_h > straight.duration_h
    assert min(w.lon for w in around.waypoints) < 18.7


@pytest.mark.parametrize("preset", ["precise", "classic"])
def test_nothing_but_too_much_wind(preset: str, across: Plan) -> None:
    with pytest.raises(NoPassageError, match="20 kn") as caught:
        across(steady_wind(25.0, 200.0), max_wind_kn=20.0, preset=preset)
    assert caught.value.reason == "wind-limit"


@pytest.mark.parametrize("preset", ["precise", "classic"])
def test_becalmed(preset: str, across: Plan) -> None:
    with pytest.raises(NoPassageError, match="becalmed") as caught:
        across(calm(), preset=preset)
    assert caught.value.reason == "becalmed"


def test_the_dead_angle_without_tacking(across: Plan) -> None:
    # From 65 degrees on: R1's courses at 0, 30 and 60 degrees to the wind are all dead.
    lame = Polar("Lame", np.array([2.0, 10.0]), np.array([65.0, 90.0, 180.0]), np.full((3, 2), 3.0))
    with pytest.raises(NoPassageError, match="dead angle") as caught:
        across(steady_wind(12.0, 0.0), lame, preset="classic")
    assert caught.value.reason == "dead-angle"
    assert across(steady_wind(12.0, 0.0), lame).tacks > 0


@pytest.mark.parametrize(
    ("name", "lat", "lon"), [("Ladoga", 60.8, 30.8), ("Vänern", 58.9, 13.3), ("Peipus", 58.6, 27.5)]
)
def test_a_port_on_a_lake_has_no_way_to_the_sea(name: str, lat: float, lon: float, across: Plan) -> None:
    with pytest.raises(NoPassageError) as caught:
        across(steady_wind(12.0, 0.0), end=Port(name, "", lat, lon))
    assert caught.value.reason == "no-water-path"


def test_the_caspian_is_a_lake(across: Plan) -> None:
    baku, turkmenbashi = Port("Baku", "AZ", 40.3, 49.95), Port("Türkmenbaşy", "TM", 40.0, 52.7)
    with pytest.raises(NoPassageError) as caught:
        across(steady_wind(12.0, 0.0), start=baku, end=turkmenbashi)
    assert caught.value.reason == "no-water-path"


@pytest.mark.parametrize("hours", [-30.0, 11 * 24.0])
def test_leaving_outside_the_forecast(hours: float, sea_settings: Settings) -> None:
    departure = DEPARTURE + timedelta(hours=hours)
    request = PassageRequest(SOUTH, NORTH, yacht(), steady_wind(12.0, 0.0), departure)
    with pytest.raises(NoPassageError, match="outside the forecast") as caught:
        plan(request, settings=sea_settings)
    assert caught.value.reason == "outside-forecast"


def test_a_port_outside_the_forecast(across: Plan) -> None:
    wind = gale_in_the_middle(west_free=True)
    with pytest.raises(NoPassageError, match="Kiel") as caught:
        across(wind, end=find_port("Kiel", load_ports()))
    assert caught.value.reason == "outside-forecast"
    assert caught.value.place == pytest.approx((54.4, 10.2), abs=0.3)


# ------------------------------------------------------------------------------------------------ input


def test_the_same_port_twice(across: Plan) -> None:
    with pytest.raises(InputError, match="same"):
        across(calm(), end=SOUTH)
    with pytest.raises(InputError, match="same"):
        across(calm(), end=Port("Neighbour", "", SOUTH.lat + 0.001, SOUTH.lon))


def test_a_departure_needs_a_time_zone(sea_settings: Settings) -> None:
    naive = datetime(2016, 11, 20, 6)  # noqa: DTZ001 - that is the mistake
    with pytest.raises(InputError, match="time zone"):
        plan(PassageRequest(SOUTH, NORTH, yacht(), sample(), naive), settings=sea_settings)


def test_without_a_departure_it_is_the_next_full_hour_of_the_forecast(sea_settings: Settings) -> None:
    passage = plan(PassageRequest(SOUTH, NORTH, yacht(), sample()), settings=sea_settings)
    assert passage.departure == sample().forecast.valid_from


@pytest.mark.parametrize(
    "options",
    [
        {"percent_of_polar": 0.0},
        {"percent_of_polar": 900.0},
        {"percent_of_polar": math.nan},
        {"spacing_nm": 0.0},
        {"spacing_nm": -1.0},
        {"spacing_nm": 1e9},
        {"spacing_nm": math.nan},
        {"preset": "classic", "directions": 24},
        {"directions": 13},
        {"max_wind_kn": 0.0},
        {"max_wind_kn": math.nan},
        {"motor_below_kn": -1.0},
        {"motor_below_kn": 3.0, "motor_speed_kn": 0.0},
        {"motor_below_kn": 3.0, "motor_speed_kn": math.nan},
        {"motor_below_kn": 3.0, "fuel_rate_l_h": -1.0},
    ],
    ids=str,
)
def test_options_that_make_no_sense(options: dict[str, Any], across: Plan) -> None:
    with pytest.raises(InputError):
        across(steady_wind(12.0, 100.0), **options)


# ----------------------------------------------------------------------------------------------- cancel

STAGES = ("sea", "lattice", "search", "refine", "check")


@pytest.mark.parametrize("stage", STAGES)
@pytest.mark.parametrize("preset", ["precise", "classic"])
def test_cancelled_at_any_stage_it_goes_no_further(preset: Any, stage: str, sea_settings: Settings) -> None:
    if preset == "classic" and stage == "refine":
        pytest.skip("the classic preset does not refine")
    chosen, cancel = stage, threading.Event()
    after: list[str] = []

    def report(stage: str, fraction: float | None, message: str) -> None:
        assert message
        if cancel.is_set():
            after.append(stage)
        if stage == chosen:
            cancel.set()

    job = Job(report, cancel)
    request = PassageRequest(SOUTH, NORTH, yacht(), sample(), DEPARTURE, Options(preset=preset))
    with pytest.raises(CancelledError) as caught:
        plan(request, settings=sea_settings, job=job)
    assert caught.value.exit_code == 130
    assert after == []


def test_every_stage_is_reported_in_order(sea_settings: Settings) -> None:
    told: list[str] = []
    job = Job(report=lambda stage, fraction, message: told.append(stage))
    plan(PassageRequest(SOUTH, NORTH, yacht(), sample(), DEPARTURE), settings=sea_settings, job=job)
    assert set(told) <= {"sea", "lattice", "wind", "search", "refine", "check"}
    assert [stage for stage in dict.fromkeys(told) if stage in STAGES] == list(STAGES)


# --------------------------------------------------------------------------------------- the same again


@pytest.mark.parametrize("preset", ["precise", "classic"])
def test_the_same_question_has_the_same_answer_to_the_last_byte(
    preset: Any, sea_settings: Settings, monkeypatch: pytest.MonkeyPatch
) -> None:
    ports = load_ports()
    ends = find_port("Visby", ports), find_port("Ronne", ports)
    request = PassageRequest(*ends, yacht(), sample(), DEPARTURE, Options(preset=preset))

    def answer() -> str:
        data = passage_to_json(plan(request, settings=sea_settings))
        data["search"].pop("seconds")
        return dumps(data)

    first = answer()
    assert answer() == first, "the lattice recalled"
    monkeypatch.setattr(passage_module, "_finder", Finder())
    assert answer() == first, "the lattice built anew"


# ------------------------------------------------------------------------------------- other people's seas


def test_corsica_is_sailed_around_by_the_global_mask_alone(sea_settings: Settings) -> None:
    """From Ajaccio to Bastia the straight line leads over mountains of 2,700 m."""
    ajaccio, bastia = Port("Ajaccio", "FR", 41.90, 8.68), Port("Bastia", "FR", 42.70, 9.48)
    passage = plan(
        PassageRequest(ajaccio, bastia, drifter(), steady_wind(8.0, 0.0), DEPARTURE), settings=sea_settings
    )
    lat, lon = sampled(passage)
    south, west, north, east = 40, 7, 44, 11
    land = globe.read_land(south, west, north, east)
    dry = land[((north - lat) * 120).astype(int), ((lon - west) * 120).astype(int)]
    assert not dry.any()
    assert passage.distance_nm > 1.8 * passage.direct_distance_nm
    # Round Cap Corse or through the Strait of Bonifacio: 100 to 130 nm by the chart.
    assert 90.0 < passage.distance_nm < 135.0
    assert passage.duration_h == pytest.approx(passage.distance_nm / 8.0, rel=1e-3)
