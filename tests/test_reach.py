"""Ports in reach and back, the latest departure that is in time, and the command that asks."""

from __future__ import annotations

import json
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from seacruise import cli
from seacruise.errors import CancelledError, InputError, NoPassageError
from seacruise.export.reach import reach_geojson, reach_to_json, reach_to_text
from seacruise.export.reach_chart import reach_chart
from seacruise.passage import Options, PassageRequest, plan
from seacruise.ports import Port, find_port, load_ports
from seacruise.progress import Job
from seacruise.reach import PortReached, Reach, ReachRequest, check_notices, fetch_wind_around, reach
from seacruise.resources import resource_path
from seacruise.settings import Settings
from seacruise.units import METRES_PER_NM, SECONDS_PER_HOUR
from seacruise.weather.sample import sample_wind
from seacruise.yacht.fleet import find_yacht, load_fleet
from seacruise.yacht.polar import Polar
from tests.routing.worlds import cache_dir_of, drifter, steady_wind

DEPARTURE = datetime(2016, 11, 20, 6, tzinfo=UTC)
COMMAND = ["reach", "--from", "Gdynia", "--yacht", "Bavaria 46 Cruiser", "--forecast", "sample"]
WHEN = ["--depart", "2016-11-20T06:00Z"]


@cache
def yacht() -> Polar:
    return find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")]))


def port(name: str) -> Port:
    return find_port(name, load_ports())


@pytest.fixture(scope="session")
def sea_settings(tmp_path_factory: pytest.TempPathFactory) -> Settings:
    base = tmp_path_factory.getbasetemp()
    return Settings(cache_dir=cache_dir_of(base), data_dir=base / "data")


def asked(start: str = "Gdynia", hours: float = 12.0, **more: Any) -> ReachRequest:
    return ReachRequest(port(start), yacht(), sample_wind(), hours, DEPARTURE, **more)


@pytest.fixture(scope="session")
def half_a_day(sea_settings: Settings) -> Reach:
    return reach(asked(), ports=load_ports(), settings=sea_settings)


def by_name(reached: Reach) -> dict[str, PortReached]:
    return {found.port.name: found for found in reached.ports}


# ---------------------------------------------------------------------------------------- the laws


def test_ports_come_nearest_in_time_first(half_a_day: Reach) -> None:
    out = [found.out_h for found in half_a_day.ports]
    assert out == sorted(out)
    assert 5 < len(out) < 40
    assert max(out) <= 12.0
    assert len(out) + half_a_day.unreachable == len(load_ports()) - 1
    assert "Gdynia" not in by_name(half_a_day)


def test_figures_of_a_port_are_consistent(half_a_day: Reach) -> None:
    over = half_a_day.departure + timedelta(hours=half_a_day.hours)
    for found in half_a_day.ports:
        assert found.arrival == half_a_day.departure + timedelta(hours=found.out_h)
        straight = np.hypot(
            found.lat - half_a_day.start.lat,
            (found.lon - half_a_day.start.lon) * np.cos(np.radians(half_a_day.start.lat)),
        )
        assert found.distance_nm > 0.99 * straight * 60
        # As the yacht sails: not faster than her polar.
        assert (
            found.distance_nm / found.out_h
            < yacht().speed_table[np.isfinite(yacht().speed_table)].max() / METRES_PER_NM * SECONDS_PER_HOUR
        )
        assert found.return_fits == (found.leave_by is not None)
        if found.leave_by is not None:
            assert found.back_h is not None
            assert found.arrival <= found.leave_by < over
            assert found.arrival + timedelta(hours=found.back_h) <= over + timedelta(seconds=1)
        elif found.back_h is not None:
            assert found.arrival + timedelta(hours=found.back_h) > over
    fitting = [found.return_fits for found in half_a_day.ports]
    assert any(fitting)
    assert not all(fitting)


@pytest.mark.parametrize("name", ["Hel", "Władysławowo", "Łeba", "Baltiysk"])
def test_the_time_out_is_that_of_a_planned_passage(name: str, sea_settings: Settings) -> None:
    options = Options(spacing_nm=2.5, directions=36, refine=False)
    reached = by_name(reach(asked(options=options), ports=load_ports(), settings=sea_settings))
    request = PassageRequest(port("Gdynia"), port(name), yacht(), sample_wind(), DEPARTURE, options)
    passage = plan(request, settings=sea_settings)
    assert reached[name].out_h == pytest.approx(passage.duration_h, rel=0.02)
    assert (reached[name].lat, reached[name].lon) == (passage.end.lat, passage.end.lon)


def test_the_time_back_is_that_of_a_passage_planned_back(half_a_day: Reach, sea_settings: Settings) -> None:
    there = by_name(half_a_day)["Władysławowo"]
    request = PassageRequest(
        port("Władysławowo"), port("Gdynia"), yacht(), sample_wind(), there.arrival, Options()
    )
    passage = plan(request, settings=sea_settings)
    assert there.back_h == pytest.approx(passage.duration_h, rel=0.05)


def test_leaving_by_the_time_told_she_is_back_in_time(half_a_day: Reach, sea_settings: Settings) -> None:
    there = by_name(half_a_day)["Władysławowo"]
    assert there.leave_by is not None
    over = half_a_day.departure + timedelta(hours=half_a_day.hours)

    def home(leaves: datetime) -> datetime:
        request = PassageRequest(port("Władysławowo"), port("Gdynia"), yacht(), sample_wind(), leaves)
        return plan(request, settings=sea_settings).arrival

    # A planned passage is a little faster than the lattice.
    assert home(there.leave_by) <= over + timedelta(minutes=1)
    assert home(there.leave_by + timedelta(minutes=30)) > over


def test_a_faster_yacht_is_there_earlier_and_gets_farther(sea_settings: Settings) -> None:
    slow = reach(asked(options=Options(percent_of_polar=70.0)), ports=load_ports(), settings=sea_settings)
    fast = reach(asked(options=Options(percent_of_polar=100.0)), ports=load_ports(), settings=sea_settings)
    assert set(by_name(slow)) < set(by_name(fast))
    # A hundredth for lattices of different spacing.
    assert all(by_name(fast)[name].out_h < 1.01 * found.out_h for name, found in by_name(slow).items())


def test_a_stay_leaves_less_time(half_a_day: Reach, sea_settings: Settings) -> None:
    staying = reach(asked(stay_h=8.0), ports=load_ports(), settings=sea_settings)
    with_stay, without = by_name(staying), by_name(half_a_day)
    assert {n: f.out_h for n, f in with_stay.items()} == {n: f.out_h for n, f in without.items()}
    fit = {name for name, found in with_stay.items() if found.return_fits}
    assert fit < {name for name, found in without.items() if found.return_fits}
    # The latest moment to leave is the same; only whether it is after the stay is not.
    assert all(with_stay[name].leave_by == without[name].leave_by for name in fit)


def test_ports_among_islands_are_reached(sea_settings: Settings) -> None:
    wind = steady_wind(16.0, 230.0)
    request = ReachRequest(port("Sandhamn"), yacht(), wind, 16.0, DEPARTURE)
    reached = by_name(reach(request, ports=load_ports(), settings=sea_settings))
    assert {"Stockholm", "Saltsjöbaden", "Nynäshamn", "Furusund"} <= set(reached)


def test_a_port_whose_approach_is_too_narrow_for_the_lattice_is_reached(sea_settings: Settings) -> None:
    """Norrköping lies up a canal; the lattice of all ports does not lead into it, one of its own does."""
    ports = [port("Norrköping"), port("Arkösund")]
    reached = by_name(reach(asked("Oxelösund", check=True), ports=ports, settings=sea_settings))
    found = reached["Norrköping"]
    request = PassageRequest(port("Oxelösund"), port("Norrköping"), yacht(), sample_wind(), DEPARTURE)
    passage = plan(request, settings=sea_settings)
    assert found.out_h == pytest.approx(passage.duration_h, rel=0.03)
    assert found.distance_nm == pytest.approx(passage.distance_nm, rel=0.05)
    assert found.land_free is True
    assert found.return_fits
    assert found.back_h is not None
    home = replace(request, start=port("Norrköping"), end=port("Oxelösund"), departure=found.arrival)
    assert found.back_h == pytest.approx(plan(home, settings=sea_settings).duration_h, rel=0.05)
    assert found.leave_by is not None
    assert found.arrival < found.leave_by < DEPARTURE + timedelta(hours=12)
    in_time = replace(home, departure=found.leave_by)
    assert plan(in_time, settings=sea_settings).arrival <= DEPARTURE + timedelta(hours=12, minutes=5)


def test_with_less_time_it_is_not(sea_settings: Settings) -> None:
    short = reach(asked("Oxelösund", hours=3.0), ports=[port("Norrköping")], settings=sea_settings)
    assert short.ports == ()
    assert short.unreachable == 1


def test_ways_out_can_be_sailed_again(half_a_day: Reach, sea_settings: Settings) -> None:
    checked = reach(asked(check=True), ports=load_ports(), settings=sea_settings)
    assert [found.port for found in checked.ports] == [found.port for found in half_a_day.ports]
    for found, plain in zip(checked.ports, half_a_day.ports, strict=True):
        assert found.land_free is True
        assert found.resailed_h == pytest.approx(found.out_h, rel=0.01)
        assert replace(found, resailed_h=None, land_free=None) == plain
    assert any("ways out were sailed again" in notice for notice in checked.notices)
    assert not any("sailed again" in notice for notice in half_a_day.notices)


def test_what_sailing_again_shows_is_told(half_a_day: Reach) -> None:
    one, two, three = half_a_day.ports[:3]
    later = replace(one, resailed_h=one.out_h * 1.021, land_free=True)
    ashore = replace(two, resailed_h=two.out_h, land_free=False)
    lost = replace(three, resailed_h=None, land_free=True)
    said = check_notices([later, ashore, lost])
    assert said[0].startswith("2 ways out were sailed again: their times are +0.0 to +2.1 %")
    assert three.port.name in said[1]
    assert two.port.name in said[2]


def test_the_public_name(half_a_day: Reach, sea_settings: Settings) -> None:
    import seacruise

    answer = seacruise.ports_in_reach(asked(), ports=load_ports(), settings=sea_settings)
    assert answer.ports == half_a_day.ports


def test_hours_on_held_wind_are_counted(sea_settings: Settings) -> None:
    late = replace(asked(), departure=datetime(2016, 11, 21, 22, tzinfo=UTC))
    reached = reach(late, ports=load_ports(), settings=sea_settings)
    for found in reached.ports:
        if found.back_h is not None:
            expected = max(0.0, found.out_h - 2.0) + found.back_h - max(0.0, 2.0 - found.out_h)
            assert found.beyond_forecast_h == pytest.approx(max(0.0, expected), abs=1e-6)
    assert any("held beyond the end" in notice for notice in reached.notices)


def test_becalmed_no_port_is_reached(sea_settings: Settings) -> None:
    request = ReachRequest(port("Gdynia"), drifter(), steady_wind(0.0, 0.0), 24.0, DEPARTURE)
    reached = reach(request, ports=load_ports(), settings=sea_settings)
    assert reached.ports == ()
    assert reached.unreachable == len(load_ports()) - 1
    assert "0 ports in reach" in reach_to_text(reached, now=DEPARTURE)
    assert "No port is reached" in reached.notices[-1]
    assert reach_chart(reached).startswith(b"\x89PNG")


def test_cancelled_it_goes_no_further(sea_settings: Settings) -> None:
    job = Job()
    job.cancel.set()
    with pytest.raises(CancelledError):
        reach(asked(), ports=load_ports(), settings=sea_settings, job=job)


@pytest.mark.parametrize("change", [{"hours": 0.0}, {"hours": 1e4}, {"stay_h": 12.0}, {"stay_h": -1.0}])
def test_numbers_that_make_no_sense(change: dict[str, Any], sea_settings: Settings) -> None:
    with pytest.raises(InputError):
        reach(replace(asked(), **change), ports=load_ports(), settings=sea_settings)


def test_leaving_outside_the_forecast(sea_settings: Settings) -> None:
    late = replace(asked(), departure=datetime(2016, 11, 25, tzinfo=UTC))
    with pytest.raises(NoPassageError) as refused:
        reach(late, ports=load_ports(), settings=sea_settings)
    assert refused.value.reason == "outside-forecast"


# -------------------------------------------------------------------------------------------- files


def test_json_has_the_keys_of_the_contract(half_a_day: Reach) -> None:
    answer = reach_to_json(half_a_day)
    assert answer["schema"] == "seacruise.reach/1"
    assert list(answer["ports"][0]) == [
        "name", "country", "lat", "lon", "distance_nm", "out_h", "arrival", "back_h", "return_fits",
        "leave_by", "beyond_forecast_h", "resailed_h", "land_free",
    ]  # fmt: skip
    assert len(answer["ports"]) == len(half_a_day.ports)
    json.dumps(answer, allow_nan=False)


def test_text_has_a_line_a_port(half_a_day: Reach) -> None:
    text = reach_to_text(half_a_day, now=DEPARTURE)
    lines = [line for line in text.splitlines() if " nm  " in line]
    assert len(lines) == len(half_a_day.ports)
    assert lines[0].startswith(half_a_day.ports[0].port.name)
    assert sum(line.endswith("fits") for line in lines) == sum(p.return_fits for p in half_a_day.ports)
    assert sum("too long" in line for line in lines) == sum(not p.return_fits for p in half_a_day.ports)


def test_geojson_is_the_water_and_the_ports(half_a_day: Reach) -> None:
    from shapely.geometry import shape

    features = reach_geojson(half_a_day)["features"]
    areas = [f for f in features if f["geometry"]["type"] == "MultiPolygon"]
    points = [f for f in features if f["geometry"]["type"] == "Point"]
    hours = [area["properties"]["hours"] for area in areas]
    assert hours == sorted(hours, reverse=True)
    assert hours[0] == 12.0
    assert len(points) == len(half_a_day.ports) + 1
    sizes = [shape(area["geometry"]).area for area in areas]
    assert sizes == sorted(sizes, reverse=True)
    for polygon in areas[0]["geometry"]["coordinates"]:
        for number, ring in enumerate(polygon):
            x, y = np.array(ring).T
            assert ring[0] == ring[-1]
            # RFC 7946: the outer ring anticlockwise, holes clockwise.
            assert (np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]) > 0) == (number == 0)


def test_the_chart_is_a_picture(half_a_day: Reach) -> None:
    assert reach_chart(half_a_day).startswith(b"\x89PNG")


# -------------------------------------------------------------------------------------- command line


def test_the_command_prints_and_writes(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "reach.geojson"
    words = [*COMMAND, *WHEN, "--hours", "6", "--format", "json", "--geojson", str(target)]
    assert cli.main(words) == 0
    out, err = capsys.readouterr()
    answer = json.loads(out)
    assert answer["hours"] == 6.0
    assert "Hel" in {found["name"] for found in answer["ports"]}
    assert "Note: Sample weather" in err
    assert json.loads(target.read_text(encoding="utf-8"))["type"] == "FeatureCollection"


def test_a_file_is_kept_as_far_as_she_may_get(
    shared_data: Path, capsys: pytest.CaptureFixture[str], half_a_day: Reach
) -> None:
    """The same wind as the sample, from its file; a passage between two ports would have cropped it."""
    path = shared_data / "weather" / "baltic" / "gfs_1deg_baltic_20161120_48h_6hourly.nc"
    words = [*COMMAND[:-1], str(path), *WHEN, "--hours", "12", "--format", "json"]
    assert cli.main(words) == 0
    found = {one["name"]: one["out_h"] for one in json.loads(capsys.readouterr().out)["ports"]}
    assert found == pytest.approx({one.port.name: one.out_h for one in half_a_day.ports}, rel=1e-3)


@pytest.mark.parametrize(
    ("words", "code"),
    [
        (["--hours", "0"], 2),
        (["--hours", "12", "--stay", "12"], 2),
        ([], 2),
        (["--hours", "12", "--depart", "2016-12-20T06:00Z"], 3),
    ],
)
def test_what_cannot_be_answered_is_one_sentence(
    words: list[str], code: int, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main([*COMMAND, *words]) == code
    err = capsys.readouterr().err
    assert len([line for line in err.splitlines() if line.startswith("seacruise: ")]) == 1
    assert "Traceback" not in err


# --------------------------------------------------------------------------------------- the wind for it


def test_the_wind_is_asked_for_around_the_start_as_far_as_she_may_come(
    monkeypatch: pytest.MonkeyPatch, sea_settings: Settings, tmp_path: Path
) -> None:
    asked_for: list[tuple[Any, dict[str, Any]]] = []

    def fetch(names: Any, **how: Any) -> Any:
        asked_for.append((names, how))
        return sample_wind()

    monkeypatch.setattr("seacruise.weather.source.fetch_wind", fetch)
    ask = partial(
        fetch_wind_around,
        port("Gdynia"),
        yacht(),
        options=Options(),
        names=("a.grib", "b.grib"),
        departure=DEPARTURE,
        settings=sea_settings,
        job=Job(),
        weights=(1.0, 2.0),
        current=tmp_path / "current.nc",
    )
    ask(hours=6.0, ports=load_ports())
    ask(hours=48.0, ports=load_ports())
    ask(hours=48.0, ports=())
    (names, how), (_, farther), (_, alone) = asked_for
    assert names == ("a.grib", "b.grib")
    gdynia = port("Gdynia")
    assert how["start"] == how["end"] == (gdynia.lat, gdynia.lon)
    assert (how["weights"], how["current"]) == ((1.0, 2.0), tmp_path / "current.nc")
    assert alone["margin_deg"] < how["margin_deg"] < farther["margin_deg"]
    assert bool(how["is_water"](54.6, 18.8))
    assert not bool(how["is_water"](54.3, 18.0))
