"""Under way: what is saved, what a newer forecast changes, and passages sailed through wrong forecasts."""

from __future__ import annotations

import json
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from seacruise import cli, simulation
from seacruise.along import apart_nm, distinct, sail_along
from seacruise.between import sea_between
from seacruise.errors import CancelledError, InputError, NoPassageError
from seacruise.export.jsonform import dumps, passage_to_json
from seacruise.export.saved import read_saved, saved_from_json
from seacruise.export.underway import (
    replanned_to_json,
    replanned_to_text,
    voyage_to_json,
    voyage_to_text,
)
from seacruise.geodesy import great_circle_m
from seacruise.passage import Options, Passage, PassageRequest, plan
from seacruise.ports import find_port, load_ports
from seacruise.progress import Job
from seacruise.resources import resource_path
from seacruise.settings import Settings
from seacruise.simulation import Tolerance, Voyage, simulate
from seacruise.underway import Replanned, SavedPassage, other_sides, replan
from seacruise.units import METRES_PER_NM
from seacruise.weather.sample import sample_wind
from seacruise.weather.source import fetch_wind
from seacruise.weather.wind import Wind, from_direction, to_direction
from seacruise.yacht.fleet import find_yacht, load_fleet
from seacruise.yacht.polar import Polar
from tests.routing.worlds import cache_dir_of, steady_wind

DEPARTURE = datetime(2016, 11, 20, 6, tzinfo=UTC)
LATER = datetime(2016, 11, 20, 18, tzinfo=UTC)


@cache
def yacht() -> Polar:
    return find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")]))


@pytest.fixture(scope="session")
def sea_settings(tmp_path_factory: pytest.TempPathFactory) -> Settings:
    base = tmp_path_factory.getbasetemp()
    return Settings(cache_dir=cache_dir_of(base), data_dir=base / "data")


def asked(start: str = "Gdynia", end: str = "Visby", wind: Wind | None = None) -> PassageRequest:
    ports = load_ports()
    return PassageRequest(
        find_port(start, ports), find_port(end, ports), yacht(), wind or sample_wind(), DEPARTURE
    )


def issued(wind: Wind, time: datetime) -> Wind:
    return replace(wind, forecast=replace(wind.forecast, issued=time))


def turned(wind: Wind, degrees: float, *, stronger: float = 1.0) -> Wind:
    """Turn a wind clockwise and strengthen it, everywhere and always."""
    tws, twd = to_direction(wind.u, wind.v)
    u, v = from_direction(tws * stronger, twd + degrees)
    return replace(wind, u=u.astype(np.float32), v=v.astype(np.float32))


@pytest.fixture(scope="session")
def planned(sea_settings: Settings) -> Passage:
    return plan(asked(), settings=sea_settings)


@pytest.fixture(scope="session")
def saved(planned: Passage) -> SavedPassage:
    return saved_from_json(dumps(passage_to_json(planned)))


def again(saved: SavedPassage, sea_settings: Settings, **more: Any) -> Replanned:
    words: dict[str, Any] = {"position": None, "time": LATER, "wind": sample_wind(), "yacht": yacht()}
    return replan(saved, settings=sea_settings, **{**words, **more})


# ------------------------------------------------------------------------------------- what is saved


def test_json_is_enough_to_go_on(saved: SavedPassage, planned: Passage) -> None:
    assert saved.yacht == planned.yacht
    assert (saved.start.name, saved.end.name) == ("Gdynia", "Visby")
    assert saved.arrival - planned.arrival < timedelta(seconds=1)
    assert len(saved.waypoints) == len(planned.waypoints)
    assert saved.waypoints[3].course_deg == pytest.approx(planned.waypoints[3].course_deg, abs=0.01)
    assert saved.source == planned.forecast.source
    assert SavedPassage.of(planned).waypoints == planned.waypoints


def test_the_plan_knows_where_she_is(saved: SavedPassage, planned: Passage) -> None:
    track = planned.track
    for k in range(0, track.time.size - 1, 17):
        lat, lon = saved.position_at(datetime.fromtimestamp(float(track.time[k]), UTC))
        away = float(great_circle_m(lat, lon, track.lat[k], track.lon[k])) / METRES_PER_NM
        # Legs are steady in the plan; sailed, she is faster on one half than on the other.
        assert away < 1.5
    for waypoint in saved.waypoints:
        assert apart_nm(saved.position_at(waypoint.time), (waypoint.lat, waypoint.lon)) < 1e-3
    assert saved.rest_from(saved.waypoints[4].time)[1:] == [(w.lat, w.lon) for w in saved.waypoints[5:]]


@pytest.mark.parametrize(
    "change",
    [
        lambda data: data.pop("waypoints"),
        lambda data: data.update(schema="seacruise.passage/9"),
        lambda data: data["waypoints"][2].update(lat=95.0),
        lambda data: data["waypoints"][2].update(time="2016-11-20T07:00:00"),
        lambda data: data["waypoints"][2].update(time="soon"),
        lambda data: data.update(waypoints=data["waypoints"][:1]),
        lambda data: data["waypoints"].reverse(),
        lambda data: data["waypoints"][0].update(course_deg="north"),
    ],
)
def test_what_is_no_passage_is_refused(planned: Passage, change: Any) -> None:
    data = passage_to_json(planned)
    change(data)
    with pytest.raises(InputError):
        saved_from_json(json.dumps(data))


@pytest.mark.parametrize("text", ["", "{", "[1, 2]", "name,country\n", "[" * 100_000])
def test_a_file_that_is_something_else_is_refused(text: str, tmp_path: Path) -> None:
    path = tmp_path / "p.json"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError):
        read_saved(path)


# ------------------------------------------------------------------------------------- planned anew


def test_with_the_same_forecast_nothing_changes(saved: SavedPassage, sea_settings: Settings) -> None:
    answer = again(saved, sea_settings)
    assert answer.off_plan_nm == 0.0
    # The rest is searched on another lattice: a few minutes of a day.
    assert abs(answer.arrival_change_h) < 0.2
    assert answer.saves_h is not None
    assert abs(answer.saves_h) < 0.2
    assert abs(answer.distance_change_nm) < 5.0
    assert answer.other_side == ()
    assert answer.passage.departure == LATER
    assert (answer.passage.end.lat, answer.passage.end.lon) == pytest.approx((saved.end.lat, saved.end.lon))


def test_another_wind_changes_course_and_arrival(saved: SavedPassage, sea_settings: Settings) -> None:
    wind = turned(sample_wind(), 120.0)
    answer = again(saved, sea_settings, wind=wind)
    assert answer.arrival_change_h < -1.0
    old = saved.waypoints[saved.leg_at(LATER)].course_deg
    assert old is not None
    assert answer.course_change_deg == pytest.approx(
        (answer.course_deg - old + 180.0) % 360.0 - 180.0, abs=1e-9
    )
    assert abs(answer.course_change_deg) > 3.0
    assert answer.kept_arrival is not None
    assert answer.passage.arrival <= answer.kept_arrival + timedelta(minutes=2)
    arrival = answer.passage.arrival - saved.arrival
    assert answer.arrival_change_h == pytest.approx(arrival.total_seconds() / 3600.0)


def test_from_a_position_of_her_own(saved: SavedPassage, sea_settings: Settings) -> None:
    here = (56.3, 19.2)
    answer = again(saved, sea_settings, position=here)
    assert answer.position == here
    assert answer.off_plan_nm == pytest.approx(apart_nm(here, saved.position_at(LATER)))
    assert (answer.passage.start.lat, answer.passage.start.lon) == pytest.approx(here, abs=0.01)


def test_who_is_late_may_plan_after_the_planned_arrival(saved: SavedPassage, sea_settings: Settings) -> None:
    late = saved.arrival + timedelta(hours=1)
    with pytest.raises(InputError, match="not under way"):
        again(saved, sea_settings, time=late)
    answer = again(saved, sea_settings, time=late, position=(57.3, 17.9))
    assert answer.arrival_change_h > 1.0


def test_who_is_there_plans_no_more(saved: SavedPassage, sea_settings: Settings) -> None:
    with pytest.raises(InputError, match="already"):
        again(saved, sea_settings, position=(saved.end.lat, saved.end.lon))


def test_islands_on_the_other_side() -> None:
    """East and west about Gotland and Öland."""
    south, north = (55.9, 17.3), (58.3, 18.0)
    east, west = [south, (57.2, 19.6), north], [south, (57.2, 17.4), north]
    (gotland,) = other_sides(west, east)
    assert gotland.side == "port"
    assert 2900 < gotland.area_km2 < 3300
    assert 57.0 < gotland.lat < 57.9
    (back,) = other_sides(east, west)
    assert back.side == "starboard"
    assert other_sides(east, east) == ()
    # The other way round, the same island is on the other hand.
    assert other_sides(west[::-1], east[::-1])[0].side == "starboard"


def test_waypoints_followed_take_as_long_as_they_were_planned(
    planned: Passage, sea_settings: Settings
) -> None:
    request = asked()
    sea = sea_between(request.start, request.end, sea_settings)
    way = distinct([(w.lat, w.lon) for w in planned.waypoints])
    sailed = sail_along(request, way, departure=DEPARTURE.timestamp(), sea=sea)
    hours = (float(sailed.time[-1]) - DEPARTURE.timestamp()) / 3600.0
    assert sailed.arrived
    assert sailed.land_free
    assert sailed.at.size == len(way)
    assert hours == pytest.approx(planned.duration_h, rel=0.01)
    assert hours <= planned.duration_h + 1e-6


def test_replanned_as_text_and_json(saved: SavedPassage, sea_settings: Settings) -> None:
    answer = again(saved, sea_settings, wind=turned(sample_wind(), 120.0))
    data = json.loads(json.dumps(replanned_to_json(answer), allow_nan=False))
    assert data["schema"] == "seacruise.replan/1"
    assert data["passage"]["schema"] == "seacruise.passage/1"
    assert data["changes"]["arrival_change_h"] == pytest.approx(answer.arrival_change_h, abs=1e-4)
    text = replanned_to_text(answer, now=LATER)
    assert "earlier than planned" in text
    assert "of the plan's" in text
    assert "Under way - Visby:" in text


# ---------------------------------------------------------------------------------------- simulations


def short(wind: Wind | None = None) -> PassageRequest:
    return asked("Klaipėda", "Visby", wind)


@pytest.fixture(scope="session")
def surprised(sea_settings: Settings) -> Voyage:
    """The first forecast has the wind 60 degrees wrong, the one of noon is the truth."""
    truth = sample_wind()
    forecasts = [
        issued(truth, datetime(2016, 11, 20, 12, tzinfo=UTC)),
        issued(turned(truth, -60.0, stronger=0.8), datetime(2016, 11, 20, tzinfo=UTC)),
    ]
    return simulate(asked(), forecasts, truth, settings=sea_settings)


def test_where_forecasts_come_true_nothing_is_planned_anew(sea_settings: Settings) -> None:
    truth = sample_wind()
    voyage = simulate(short(), [issued(truth, DEPARTURE)], truth, settings=sea_settings)
    assert voyage.log == ()
    assert voyage.sailed_h == voyage.kept_h
    assert voyage.sailed_h == pytest.approx(voyage.expected_h, rel=0.01)
    assert voyage.hindsight_h == pytest.approx(voyage.expected_h, abs=1e-9)
    assert voyage.gained_h == 0.0


def test_where_they_do_not_she_plans_anew_and_gains(surprised: Voyage) -> None:
    assert surprised.log
    assert surprised.sailed_h is not None
    assert surprised.kept_h is not None
    assert surprised.hindsight_h is not None
    assert surprised.gained_h is not None
    assert surprised.gained_h > 1.0
    # Nobody beats who knows the truth.
    assert surprised.hindsight_h <= surprised.sailed_h * 1.005
    assert surprised.hindsight_h <= surprised.kept_h * 1.005


def test_the_log_tells_what_was_wrong(surprised: Voyage) -> None:
    tolerance = Tolerance()
    noon = datetime(2016, 11, 20, 12, tzinfo=UTC)
    for entry in surprised.log:
        assert tolerance.exceeded(entry.planned, entry.met)
        assert entry.issued == (noon if entry.time >= noon else datetime(2016, 11, 20, tzinfo=UTC))
        tws, twd = simulation._wind_at(sample_wind(), entry.time.timestamp(), entry.position)
        assert entry.met == (tws, twd)
        assert entry.expected is not None
    times = [entry.time for entry in surprised.log]
    assert times == sorted(times)
    # Once the forecast of noon is in use, it is the truth.
    assert [entry.issued == noon for entry in surprised.log].count(True) == 1
    assert surprised.log[-1].issued == noon


def test_the_track_is_one_line_from_start_to_end(surprised: Voyage) -> None:
    time, lat, lon = surprised.track.T
    assert (np.diff(time) > -1e-3).all()
    assert surprised.sailed_h is not None
    assert (time[-1] - time[0]) / 3600.0 == pytest.approx(surprised.sailed_h)
    steps = great_circle_m(lat[:-1], lon[:-1], lat[1:], lon[1:]) / METRES_PER_NM
    assert steps.max() < 15.0 * 0.2
    end = surprised.request.end
    assert apart_nm((float(lat[-1]), float(lon[-1])), (end.lat, end.lon)) < 1.0


@pytest.mark.parametrize(
    ("planned_wind", "met", "beyond"),
    [
        ((15.0, 350.0), (15.0, 5.0), False),
        ((15.0, 350.0), (15.0, 15.0), True),
        ((15.0, 0.0), (19.1, 0.0), True),
        ((15.0, 0.0), (11.1, 0.0), False),
        ((2.0, 0.0), (1.0, 180.0), False),
        ((2.0, 0.0), (4.0, 180.0), True),
    ],
)
def test_the_tolerance(planned_wind: tuple[float, float], met: tuple[float, float], beyond: bool) -> None:
    assert Tolerance().exceeded(planned_wind, met) is beyond


def test_a_forecast_has_to_be_issued(sea_settings: Settings) -> None:
    truth = sample_wind()
    with pytest.raises(InputError, match="issued"):
        simulate(short(), [truth], truth, settings=sea_settings)
    with pytest.raises(InputError, match="issued by the departure"):
        simulate(short(), [issued(truth, LATER)], truth, settings=sea_settings)
    with pytest.raises(InputError, match="at least one"):
        simulate(short(), [], truth, settings=sea_settings)


def test_becalmed_in_truth_she_does_not_arrive(sea_settings: Settings) -> None:
    truth = steady_wind(0.0, 0.0)
    forecast = issued(steady_wind(15.0, 180.0), DEPARTURE)
    voyage = simulate(short(), [forecast], truth, settings=sea_settings)
    assert voyage.sailed_h is voyage.kept_h is voyage.hindsight_h is voyage.gained_h is None
    assert "does not arrive" in voyage_to_text(voyage)


def test_no_passage_at_the_departure(sea_settings: Settings) -> None:
    calm = issued(steady_wind(0.0, 0.0), DEPARTURE)
    with pytest.raises(NoPassageError):
        simulate(short(), [calm], sample_wind(), settings=sea_settings)


def test_cancelled_it_goes_no_further(sea_settings: Settings, saved: SavedPassage) -> None:
    job = Job()
    job.cancel.set()
    truth = sample_wind()
    with pytest.raises(CancelledError):
        simulate(short(), [issued(truth, DEPARTURE)], truth, settings=sea_settings, job=job)
    with pytest.raises(CancelledError):
        again(saved, sea_settings, job=job)


def test_a_voyage_as_text_and_json(surprised: Voyage) -> None:
    data = json.loads(json.dumps(voyage_to_json(surprised), allow_nan=False))
    assert data["schema"] == "seacruise.voyage/1"
    assert data["gained_h"] == pytest.approx(data["kept_h"] - data["sailed_h"], abs=2e-4)
    assert len(data["replanned"]) == len(surprised.log)
    text = voyage_to_text(surprised)
    assert "Re-planning      saves" in text
    assert len([line for line in text.splitlines() if line.startswith(("Sun 20", "Mon 21"))]) == len(
        surprised.log
    )


def test_the_engine_counts_as_in_plan(sea_settings: Settings) -> None:
    """Options reach both what is planned and what is sailed."""
    truth = steady_wind(1.5, 180.0)
    request = replace(short(), options=Options(motor_below_kn=4.0, motor_speed_kn=5.0))
    voyage = simulate(request, [issued(truth, DEPARTURE)], truth, settings=sea_settings)
    assert voyage.sailed_h == pytest.approx(voyage.expected_h, rel=0.01)


# --------------------------------------------------------------------------------------- command line


@pytest.fixture
def file(planned: Passage, tmp_path: Path) -> Path:
    path = tmp_path / "passage.json"
    path.write_text(dumps(passage_to_json(planned)), encoding="utf-8")
    return path


def test_the_command_plans_anew(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["replan", str(file), "--time", "2016-11-20T18:00Z", "--forecast", "sample"]
    assert cli.main([*words, "--format", "json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["changes"]["off_plan_nm"] == 0.0
    assert data["passage"]["yacht"] == "Bavaria 46 Cruiser"
    assert cli.main([*words, "--at", "56.3,19.2", "--yacht", "folkboat"]) == 0
    out = capsys.readouterr().out
    assert "Re-planned under way to Visby" in out
    assert "Nordic Folkboat" in out


@pytest.mark.parametrize(
    "words",
    [
        ["--time", "2016-11-25T18:00Z"],
        ["--time", "2016-11-20T18:00Z", "--at", "Visby"],
        ["--time", "2016-11-20T18:00Z", "--yacht", "nobody's"],
        [],
    ],
)
def test_what_makes_no_sense_is_one_sentence(
    file: Path, words: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["replan", str(file), "--forecast", "sample", *words]) == 2
    err = capsys.readouterr().err
    assert len([line for line in err.splitlines() if line.startswith("seacruise: ")]) == 1


def test_a_missing_file_is_one_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["replan", str(tmp_path / "none.json")]) == 2
    assert "There is no saved passage" in capsys.readouterr().err


SIMULATE = [
    "simulate", "--from", "Klaipėda", "--to", "Visby", "--depart", "2016-11-20T06:00Z", "--yacht",
    "Bavaria 46 Cruiser", "--truth", "sample",
]  # fmt: skip


def test_the_command_simulates_with_files(shared_data: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The sample's own file, whose values are the sample's: what comes true is not planned anew."""
    file = shared_data / "weather" / "baltic" / "gfs_1deg_baltic_20161120_48h_6hourly.nc"
    words = [*SIMULATE, "--forecast", str(file), "--issued", "2016-11-20T00:00Z", "--format", "json"]
    assert cli.main(words) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["replanned"] == []
    assert data["sailed_h"] == pytest.approx(data["expected_h"], rel=0.01)


def test_a_real_forecast_of_another_weather(shared_data: Path, sea_settings: Settings) -> None:
    """Real dynamics, moved to the Baltic and to these days, until the sample is issued at noon."""
    ports = load_ports()
    ends = [(port.lat, port.lon) for port in (find_port("Klaipėda", ports), find_port("Visby", ports))]
    file = shared_data / "weather" / "baltic" / "RELOCATED_gfs025_120h_to_baltic.nc"
    read = fetch_wind(
        [str(file)], start=ends[0], end=ends[1], departure=None, settings=sea_settings, job=Job()
    )
    truth = sample_wind()
    time = read.time - read.time[0] + truth.time[0]
    forecast = replace(
        truth.forecast,
        valid_to=datetime.fromtimestamp(float(time[-1]), UTC),
        issued=truth.forecast.valid_from,
    )
    noon = datetime(2016, 11, 20, 12, tzinfo=UTC)
    relocated = replace(read, time=time, forecast=forecast)
    voyage = simulate(short(), [relocated, issued(truth, noon)], truth, settings=sea_settings)
    assert voyage.log
    assert voyage.log[-1].issued == noon
    assert voyage.sailed_h is not None
    assert voyage.hindsight_h is not None
    assert voyage.hindsight_h <= voyage.sailed_h * 1.005
    assert abs(voyage.expected_h - voyage.sailed_h) > 0.1


@pytest.mark.parametrize(
    "words", [[], ["--forecast", "sample"], ["--forecast", "sample", *["--issued", "2016-11-20T00:00Z"] * 2]]
)
def test_issues_must_be_known(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main([*SIMULATE, *words]) == 2
    err = capsys.readouterr().err
    assert len([line for line in err.splitlines() if line.startswith("seacruise: ")]) == 1


def test_weights_and_a_current_are_those_of_plan(
    file: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    asked: list[dict[str, Any]] = []

    def fetch(names: list[str], **more: Any) -> Wind:
        asked.append({"names": list(names), **more})
        return issued(sample_wind(), datetime(2016, 11, 20, tzinfo=UTC))

    monkeypatch.setattr("seacruise.weather.source.fetch_wind", fetch)
    words = ["replan", str(file), "--time", "2016-11-20T18:00Z", "--forecast", "a.grb", "--forecast", "b.grb"]
    assert cli.main([*words, "--weights", "2,1", "--current", "c.nc"]) == 0
    assert asked[0]["names"] == ["a.grb", "b.grb"]
    assert (asked[0]["weights"], asked[0]["current"]) == ((2.0, 1.0), Path("c.nc"))
    assert cli.main([*words, "--weights", "2,x"]) == 2
    asked.clear()
    assert cli.main([*SIMULATE, "--forecast", "a.grb", "--current", "c.nc"]) == 0
    assert [(one["names"], one["current"]) for one in asked] == [
        (["a.grb"], Path("c.nc")),
        (["sample"], Path("c.nc")),
    ]
    capsys.readouterr()


def test_beyond_the_horizon_the_wind_that_fades_is_the_one_forecast(sea_settings: Settings) -> None:
    """A forecast that comes true, and ends under way: what is met is what was planned."""
    wind = issued(sample_wind(), datetime(2016, 11, 20, tzinfo=UTC))
    early = wind.time <= wind.time[0] + 12 * 3600.0
    last = datetime.fromtimestamp(float(wind.time[early][-1]), UTC)
    cut = replace(
        wind, time=wind.time[early], u=wind.u[early], v=wind.v[early],
        forecast=replace(wind.forecast, valid_to=last),
    )  # fmt: skip
    request = replace(short(cut), options=Options(beyond="fade"))
    voyage = simulate(request, [cut], cut, settings=sea_settings)
    assert voyage.log == ()
    assert voyage.sailed_h == pytest.approx(voyage.kept_h)
