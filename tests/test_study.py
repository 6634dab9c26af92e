"""Many passages side by side: departures, yachts, members of an ensemble, executors, the command."""

from __future__ import annotations

import json
import sys
import threading
import time
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from seacruise import cli, study
from seacruise.errors import CancelledError, InputError, SeaCruiseError
from seacruise.export.study import best_sentences, study_to_json, study_to_text
from seacruise.passage import Options, PassageRequest, plan
from seacruise.ports import Port, find_port, load_ports
from seacruise.progress import Job
from seacruise.resources import resource_path
from seacruise.routing import find
from seacruise.routing.field import Handling
from seacruise.settings import Settings
from seacruise.study import Run, Study, compare, departures_from, ensemble, variants
from seacruise.weather.sample import sample_wind
from seacruise.weather.source import fetch_wind
from seacruise.weather.wind import Wind
from seacruise.yacht.fleet import find_yacht, load_fleet
from seacruise.yacht.polar import Polar
from tests.routing.worlds import cache_dir_of

DEPARTURE = datetime(2016, 11, 20, 6, tzinfo=UTC)
COMMAND = ["compare", "--from", "Visby", "--to", "Västervik", "--forecast", "sample"]
WHEN = ["--depart", "2016-11-20T06:00Z"]


@cache
def yacht(name: str = "Bavaria 46 Cruiser") -> Polar:
    return find_yacht(name, load_fleet([resource_path("polars")]))


@pytest.fixture(scope="session")
def sea_settings(tmp_path_factory: pytest.TempPathFactory) -> Settings:
    base = tmp_path_factory.getbasetemp()
    return Settings(cache_dir=cache_dir_of(base), data_dir=base / "data")


def asked(start: str = "Visby", end: str = "Västervik", **more: Any) -> PassageRequest:
    ports = load_ports()
    request = PassageRequest(
        find_port(start, ports), find_port(end, ports), yacht(), sample_wind(), DEPARTURE
    )
    return replace(request, **more)


def every(hours: float, count: int, request: PassageRequest | None = None) -> list[PassageRequest]:
    request = request or asked()
    return variants(request, departures=departures_from(request, count=count, every=timedelta(hours=hours)))


def with_members(factors: tuple[float, ...] = (0.7, 0.9, 1.0, 1.1, 1.2)) -> Wind:
    """Make an ensemble of the sample: its own wind, weaker and stronger."""
    wind = sample_wind()
    members = tuple(replace(wind, u=wind.u * np.float32(f), v=wind.v * np.float32(f)) for f in factors)
    return replace(wind, members=members)


@pytest.fixture(scope="session")
def six_departures(sea_settings: Settings) -> Study:
    return compare(every(9, 6), settings=sea_settings)


# ------------------------------------------------------------------------------------------ the runs


def test_each_run_is_the_passage_that_plan_finds(six_departures: Study, sea_settings: Settings) -> None:
    found = [run for run in six_departures.runs if run.found]
    assert len(found) == 5
    for run in (found[0], found[-1]):
        passage = plan(asked(departure=run.departure), settings=sea_settings)
        assert run.duration_h == pytest.approx(passage.duration_h, abs=1e-9)
        assert run.arrival == passage.arrival
        assert run.max_tws_kn == passage.max_tws_kn
        assert run.member is None
        assert run.band is None


def test_departures_come_in_order_and_are_as_far_apart_as_asked(six_departures: Study) -> None:
    departures = [run.departure for run in six_departures.runs]
    assert departures == [DEPARTURE + timedelta(hours=9 * k) for k in range(6)]


def test_one_that_fails_tells_why_and_spoils_no_other(six_departures: Study) -> None:
    """45 hours after the first departure the sample is over."""
    last = six_departures.runs[-1]
    assert not last.found
    assert last.reason == "outside-forecast"
    assert "outside the forecast" in last.message
    assert last.arrival is None
    assert last.night_h is None
    assert all(run.found and not run.reason for run in six_departures.runs[:-1])


def test_shares_and_hours_are_within_the_passage(six_departures: Study) -> None:
    for run in six_departures.runs:
        if run.passage is None:
            continue
        assert run.duration_h is not None
        assert run.upwind_share is not None
        assert 0.0 <= run.upwind_share <= 1.0
        assert run.night_h is not None
        assert 0.0 <= run.night_h <= run.duration_h + 1e-9
        track = run.passage.track
        legs = np.diff(track.time)
        beating = legs[(track.twa_deg[:-1] < 60.0) & ~track.motor[:-1]].sum() / legs.sum()
        assert run.upwind_share == pytest.approx(float(beating))
    # 06:00 to noon is day but for the first hour; the one that leaves at 15:00 sails into the night.
    by_hour = {run.departure.hour: run for run in six_departures.runs[:3]}
    assert (by_hour[6].night_h or 0.0) < 1.0
    assert by_hour[15].night_h == pytest.approx(by_hour[15].duration_h, abs=1.0)


def test_the_best_is_the_shortest_that_is_not_on_held_wind(six_departures: Study) -> None:
    best = six_departures.best()
    assert best is not None
    known = [run for run in six_departures.runs if run.found and run.is_forecast]
    assert best.duration_h == min(run.duration_h for run in known if run.duration_h)


def test_held_wind_counts_only_when_there_is_nothing_else() -> None:
    def run(hours: float | None, held: float) -> Run:
        return Run(DEPARTURE, "A", duration_h=hours, beyond_forecast_h=held)

    forecast = sample_wind().forecast
    assert Study("A", "B", forecast, (run(9.0, 0.0), run(5.0, 4.0), run(None, 0.0))).best() == run(9.0, 0.0)
    assert Study("A", "B", forecast, (run(9.0, 8.0), run(5.0, 4.0))).best() == run(5.0, 4.0)
    assert Study("A", "B", forecast, (run(None, 0.0),)).best() is None


def test_yachts_are_compared(sea_settings: Settings) -> None:
    slow, fast = yacht("Nordic Folkboat"), yacht()
    requests = variants(asked(), departures=[DEPARTURE], yachts=[slow, fast])
    answer = compare(requests, settings=sea_settings)
    assert answer.yachts == (slow.name, fast.name)
    first, second = (run.duration_h for run in answer.runs)
    assert first is not None
    assert second is not None
    assert first > 1.2 * second
    best = answer.best()
    assert best is not None
    assert best.yacht == fast.name
    assert f"Fastest of all: {fast.name}" in best_sentences(answer)[-1]


@pytest.mark.parametrize(("count", "hours"), [(0, 6.0), (10**6, 6.0), (3, 0.0), (3, 1e4)])
def test_numbers_that_make_no_sense(count: int, hours: float) -> None:
    with pytest.raises(InputError):
        departures_from(asked(), count=count, every=timedelta(hours=hours))


def test_nothing_to_compare(sea_settings: Settings) -> None:
    with pytest.raises(InputError, match="nothing to compare"):
        compare([], settings=sea_settings)


# -------------------------------------------------------------------------------------- the executors


def figures(answer: Study) -> list[Any]:
    return [(run.departure, run.duration_h, run.arrival, run.reason) for run in answer.runs]


def test_other_processes_find_the_same(six_departures: Study, sea_settings: Settings) -> None:
    import multiprocessing

    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(1, mp_context=context) as pool:
        answer = compare(every(9, 6), settings=sea_settings, executor=pool)
    assert figures(answer) == figures(six_departures)


def test_threads_that_are_given_are_left_alone(six_departures: Study, sea_settings: Settings) -> None:
    with ThreadPoolExecutor(1) as pool:
        answer = compare(every(9, 6), settings=sea_settings, executor=pool)
        assert figures(answer) == figures(six_departures)
        assert pool.submit(int, "3").result() == 3


class Slow(Executor):
    """Never finishes what it is given, as a cluster that went away."""

    def __init__(self) -> None:
        self.futures: list[Future[Any]] = []

    def submit(self, *_args: Any, **_kwargs: Any) -> Future[Any]:
        self.futures.append(Future())
        return self.futures[-1]


def test_cancelled_it_waits_for_nobody(sea_settings: Settings) -> None:
    job, pool = Job(), Slow()
    threading.Timer(0.2, job.cancel.set).start()
    with pytest.raises(CancelledError):
        compare(every(6, 3), settings=sea_settings, executor=pool, job=job)
    assert all(future.cancelled() for future in pool.futures)


def test_cancelled_the_threads_stop_too(sea_settings: Settings) -> None:
    def cancel_after_the_first(stage: str, fraction: float | None, message: str) -> None:
        if fraction:
            job.cancel.set()

    job = Job(report=cancel_after_the_first)
    before = threading.active_count()
    with pytest.raises(CancelledError):
        compare(every(1, 40), settings=sea_settings, job=job)
    for _ in range(600):
        if threading.active_count() <= before:
            break
        time.sleep(0.1)
    assert threading.active_count() <= before


def test_a_broken_pool_is_a_sentence(sea_settings: Settings) -> None:
    from concurrent.futures.process import BrokenProcessPool

    class Broken(Executor):
        def submit(self, *_args: Any, **_kwargs: Any) -> Future[Any]:
            future: Future[Any] = Future()
            future.set_exception(BrokenProcessPool("gone"))
            return future

    with pytest.raises(SeaCruiseError) as told:
        compare(every(6, 2), settings=sea_settings, executor=Broken())
    assert told.value.reason == "worker-lost"


def test_progress_counts_the_passages(sea_settings: Settings) -> None:
    told: list[float | None] = []
    job = Job(report=lambda stage, fraction, message: told.append(fraction))
    compare(every(6, 3), settings=sea_settings, job=job)
    assert told == pytest.approx([1 / 3, 2 / 3, 1.0])


# ---------------------------------------------------------------------------------------- ensembles


@pytest.fixture(scope="session")
def two_bands(sea_settings: Settings) -> Study:
    return compare(every(6, 2, asked(wind=with_members())), settings=sea_settings)


def test_each_member_is_planned_in_its_own_wind(two_bands: Study, sea_settings: Settings) -> None:
    wind = with_members()
    for run in two_bands.runs:
        assert run.band is not None
        assert [member.member for member in run.band.members] == list(range(5))
        assert run.band.found == 5
        alone = plan(asked(wind=wind.members[0], departure=run.departure), settings=sea_settings).duration_h
        assert run.band.members[0].duration_h == pytest.approx(alone, abs=1e-9)
        # The member that is the wind itself has its passage.
        assert run.band.members[2].duration_h == pytest.approx(run.duration_h, abs=1e-9)


def test_the_band_is_the_quantiles_of_the_members(two_bands: Study) -> None:
    run = two_bands.runs[0]
    assert run.band is not None
    hours = [member.duration_h for member in run.band.members]
    spread = run.band.duration_h
    expected = np.quantile(np.array(hours, dtype=float), [0.1, 0.5, 0.9])
    assert [spread.low, spread.middle, spread.high] == pytest.approx(expected.tolist())
    assert spread.low is not None
    assert spread.high is not None
    assert spread.low < spread.high
    arrivals = run.arrivals
    assert arrivals[0] == run.departure + timedelta(hours=spread.low)
    assert arrivals == tuple(sorted(time for time in arrivals if time))


def test_the_passage_of_the_mean_is_no_faster_than_a_members_own(two_bands: Study) -> None:
    for run in two_bands.runs:
        assert run.band is not None
        for member in run.band.members:
            assert member.followed_h is not None
            assert member.duration_h is not None
            # Following waypoints she is granted the hull of her polar, planned boards lose a little.
            assert member.followed_h > 0.99 * member.duration_h


def test_members_fade_to_their_common_mean(sea_settings: Settings, monkeypatch: pytest.MonkeyPatch) -> None:
    """Alone a member would fade to its own mean; together, and once for all departures, to that of all."""
    whole = with_members((0.6, 1.0, 1.4))
    early = whole.time <= whole.time[0] + 7 * 3600.0
    forecast = replace(whole.forecast, valid_to=datetime.fromtimestamp(float(whole.time[early][-1]), UTC))

    def cut(wind: Wind, **more: Any) -> Wind:
        return replace(
            wind, time=wind.time[early], u=wind.u[early], v=wind.v[early], forecast=forecast, **more
        )

    members = tuple(cut(member) for member in whole.members)
    wind = replace(cut(replace(whole, members=())), members=members)
    tasks: list[Any] = []

    def run(task: Any, _cancel: Any) -> Run:
        tasks.append(task)
        return study._none(task, task.request.departure or DEPARTURE, "becalmed", "Becalmed.")

    monkeypatch.setattr(study, "_run", run)
    requests = every(1, 2, asked(wind=wind, departure=None, options=Options(beyond="fade")))
    compare(requests, settings=sea_settings)
    last = np.mean([member.u[-1] for member in members], axis=0)
    sailed = [task.request.wind for task in tasks if task.member is not None]
    assert len(sailed) == 6
    for one in sailed:
        assert one.time[-1] == wind.time[-1] + 24 * 3600.0
        np.testing.assert_allclose(one.u[-1], last, atol=1e-4)
    assert len({id(one) for one in sailed}) == 3, "extended once, not for each departure"


def test_members_becalmed_never_arrive(sea_settings: Settings) -> None:
    band = ensemble(asked(wind=with_members((1.0, 0.0, 0.0))), settings=sea_settings)
    assert band.found == 1
    assert {member.reason for member in band.members[1:]} == {"becalmed"}
    assert band.duration_h.middle is None
    assert band.duration_h.high is None
    assert band.followed_h.high is None


def test_a_real_ensemble(shared_data: Path, sea_settings: Settings) -> None:
    """Five of the 21 members of a GEFS forecast, off California."""
    ends = Port("A", "", 38.5, -125.0), Port("B", "", 37.5, -124.0)
    file = shared_data / "weather" / "ensemble" / "gefs21_california_20151019.nc"
    (a, b) = ((port.lat, port.lon) for port in ends)
    wind = fetch_wind([str(file)], start=a, end=b, departure=None, settings=sea_settings, job=Job())
    assert len(wind.members) == 21
    few = replace(wind, members=wind.members[:5])
    request = PassageRequest(*ends, yacht(), few, datetime(2015, 10, 21, 6, tzinfo=UTC))
    band = ensemble(request, settings=sea_settings)
    assert band.found == 5
    assert len({member.duration_h for member in band.members}) == 5
    assert None not in {band.duration_h.low, band.duration_h.high, band.followed_h.high}


def test_a_wind_without_members_is_no_ensemble(sea_settings: Settings) -> None:
    with pytest.raises(InputError, match="no ensemble"):
        ensemble(asked(), settings=sea_settings)


def test_members_can_be_left_out(sea_settings: Settings) -> None:
    answer = compare([asked(wind=with_members())], settings=sea_settings, members=False)
    assert answer.runs[0].band is None


# ------------------------------------------------------------------------------------ text and JSON


def test_json_has_a_run_a_departure(two_bands: Study, six_departures: Study) -> None:
    answer = json.loads(json.dumps(study_to_json(six_departures), allow_nan=False))
    assert answer["schema"] == "seacruise.study/1"
    assert list(answer["runs"][0]) == [
        "departure", "yacht", "member", "duration_h", "arrival", "distance_nm", "max_tws_kn",
        "upwind_share", "night_h", "motor_h", "beyond_forecast_h", "reason", "message", "ensemble",
    ]  # fmt: skip
    best = answer["runs"][answer["best"]]
    assert best["duration_h"] == pytest.approx(six_departures.best().duration_h, abs=1e-4)  # type: ignore[union-attr]
    assert answer["runs"][-1]["reason"] == "outside-forecast"
    band = study_to_json(two_bands)["runs"][0]["ensemble"]
    assert band["members"] == band["found"] == len(band["runs"]) == 5
    assert band["duration_h"]["p10"] < band["duration_h"]["p90"]
    assert band["arrival"]["p50"].startswith("2016-11-20T")


def test_text_has_a_line_a_departure_and_names_the_best(two_bands: Study, six_departures: Study) -> None:
    text = study_to_text(six_departures, now=DEPARTURE)
    lines = [line for line in text.splitlines() if line[2:].startswith(("Sun 20", "Mon 21", "Tue 22"))]
    assert len(lines) == 6
    assert [line for line in lines if line.startswith("*")] == [lines[1]]
    assert "outside-forecast" in lines[-1]
    assert "Best: leaving Sun 20 Nov 2016 15:00 UTC, 5 h 13 min; saves 0 h 1" in text
    assert "against leaving Sun 20 Nov 2016 06:00." in text
    assert "10 - 50 - 90 %" not in text
    assert "10 - 50 - 90 %" in study_to_text(two_bands, now=DEPARTURE)


def test_a_later_best_saves_against_leaving_first() -> None:
    runs = tuple(
        Run(DEPARTURE + timedelta(hours=6 * k), "A", duration_h=hours, arrival=DEPARTURE, beyond_forecast_h=0)
        for k, hours in enumerate((43.0, 40.0, 37.0))
    )
    (sentence,) = best_sentences(Study("A", "B", sample_wind().forecast, runs))
    assert sentence.endswith("37 h 00 min; saves 6 h 00 min against leaving Sun 20 Nov 2016 06:00.")


# -------------------------------------------------------------------------------------- command line


def test_the_command_prints_json(capsys: pytest.CaptureFixture[str]) -> None:
    words = [*COMMAND, *WHEN, "--yacht", "Bavaria 46 Cruiser", "--departures", "3", "--every", "90min"]
    assert cli.main([*words, "--format", "json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert [run["departure"] for run in answer["runs"]] == [
        "2016-11-20T06:00:00Z",
        "2016-11-20T07:30:00Z",
        "2016-11-20T09:00:00Z",
    ]


def test_the_command_compares_yachts(capsys: pytest.CaptureFixture[str]) -> None:
    words = [*COMMAND, *WHEN, "--yacht", "Bavaria 46 Cruiser", "--yacht", "folkboat"]
    assert cli.main(words) == 0
    out = capsys.readouterr().out
    assert "2 of 2 passages found" in out
    assert "Nordic Folkboat: Best: leaving" in out


def test_when_there_is_none_the_exit_code_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    words = [*COMMAND, *WHEN, "--yacht", "folkboat", "--max-wind", "5", "--departures", "2"]
    assert cli.main([*words, "--format", "json"]) == 3
    out, err = capsys.readouterr()
    assert [run["reason"] for run in json.loads(out)["runs"]] == ["wind-limit", "wind-limit"]
    assert "seacruise: None of the 2 passages exists" in err


@pytest.mark.parametrize(
    "words",
    [
        ["--departures", "0"],
        ["--departures", "2.5"],
        ["--every", "soon"],
        ["--every", "0h"],
        ["--every", "40d"],
        [],
    ],
)
def test_what_makes_no_sense_is_one_sentence(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    yachts = ["--yacht", "folkboat"] if words else []
    assert cli.main([*COMMAND, *yachts, *words]) == 2
    assert len(capsys.readouterr().err.splitlines()) == 1


def test_options_are_those_of_plan(sea_settings: Settings) -> None:
    request = asked(options=Options(percent_of_polar=80.0))
    (run,) = compare([request], settings=sea_settings).runs
    assert run.duration_h == pytest.approx(plan(request, settings=sea_settings).duration_h, abs=1e-9)


def test_threads_never_take_each_others_yacht(monkeypatch: pytest.MonkeyPatch) -> None:
    """The finder keeps the speed table used last, and all threads of a study share it."""
    yachts = (yacht(), yacht("Nordic Folkboat"))
    monkeypatch.setattr(find, "speed_table", lambda polar, handling: polar.name)
    finder, handling = find.Finder(), Handling()

    def mistaken(polar: Polar) -> int:
        return sum(str(finder._speed_table(polar, handling)) != polar.name for _ in range(30_000))

    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    try:
        with ThreadPoolExecutor(2) as pool:
            assert list(pool.map(mistaken, yachts)) == [0, 0]
    finally:
        sys.setswitchinterval(before)
