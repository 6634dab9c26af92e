"""The benchmarks are programs: the cheap parts must run, and say what they claim to say."""

from __future__ import annotations

import importlib
import io
import json
import math
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from benchmarks import measure
from benchmarks.__main__ import SECTIONS, main, missed
from benchmarks.isochrones import polar_file
from benchmarks.simulator import Simulator
from benchmarks.tables import render, renew
from seacruise.geodesy import rhumb_distance_m, to_mercator
from seacruise.routing.find import Question
from seacruise.routing.manoeuvres import Course, straight_legs
from seacruise.routing.refine import Line
from seacruise.routing.resail import resail
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.polar import Polar
from tests.routing.worlds import PRECISE, T0, open_sea, sloop, steady_wind

REPOSITORY = Path(__file__).resolve().parent.parent


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """What the quick benchmarks print, run as a user runs them."""
    home = tmp_path_factory.mktemp("home")
    answer = subprocess.run(
        [sys.executable, "-m", "benchmarks", "--quick", "rooms", "lattice", "search"],
        cwd=REPOSITORY,
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=False,
        env={**os.environ, "SEACRUISE_HOME": str(home)},
    )
    assert answer.returncode == 0, answer.stderr
    assert "rooms: done" in answer.stderr
    return json.loads(answer.stdout)


def figures_in(value: Any) -> list[tuple[str, Any]]:
    """All leaves with their keys."""
    if isinstance(value, dict):
        return [leaf for key, inner in value.items() for leaf in [(key, inner), *figures_in(inner)]]
    if isinstance(value, list):
        return [leaf for inner in value for leaf in figures_in(inner)]
    return []


def test_prints_one_object_with_the_sections_asked_for(report: Any) -> None:
    assert report["schema"] == "seacruise.benchmarks/1"
    assert set(report["sections"]) == {"rooms", "lattice", "search"}
    assert report["machine"]["cores"] >= 1
    assert isinstance(report["missed_budgets"], list)


def test_every_measured_time_has_its_unit_and_its_runs(report: Any) -> None:
    leaves = figures_in(report["sections"])
    medians = [(key, value) for key, value in leaves if key.startswith("median")]
    assert len(medians) >= 12
    assert {key for key, _ in medians} <= {"median_ms", "median_s"}
    assert all(value > 0 for _, value in medians)
    assert sum(key == "runs" for key, _ in leaves) == len(medians)


def test_searches_tell_their_size_and_hold_their_budget_against_it(report: Any) -> None:
    case = report["sections"]["search"]["cases"]["gdynia_stockholm_12_courses_5_nm"]["goal_directed"]
    assert 1_000 < case["vertices"] < case["edges"]
    assert 0 < case["settled"] <= case["vertices"]
    assert case["relaxed"] <= case["edges"]
    assert case["budget_ms"] == 2.0
    assert case["within"] is (case["median_ms"] <= 2.0)
    # The wind of the sample takes her there in one to three days.
    assert 24 < case["found_h"] < 72


def test_more_courses_find_no_slower_passage(report: Any) -> None:
    growth = report["sections"]["search"]["growth_with_courses_2_nm"]
    assert [grown["courses"] for grown in growth] == [12, 24]
    assert growth[1]["found_h"] <= growth[0]["found_h"]
    assert growth[1]["edges"] > 1.5 * growth[0]["edges"]


def test_missed_budgets_are_named_by_their_place() -> None:
    figures = {"a": {"b": {"within": False}, "c": {"within": True}}, "d": {"within_memory": False}}
    assert missed(figures) == ["a/b: within", "d: within_memory"]


def test_some_of_the_sections_are_renewed_alone(report: Any) -> None:
    before = render(report)
    some = {**report, "begun": "another day", "sections": {"search": report["sections"]["search"]}}
    after = renew(before, some)
    assert after.replace("\n\nMeasured on its own, another day.", "") == before
    assert after.count("another day") == 1
    assert after.index("### Search") < after.index("another day") < after.index("| search | vertices |")
    assert renew("", some).startswith("\n\n### Search\n\nMeasured on its own, another day.\n\n")


def test_results_become_tables(report: Any) -> None:
    case = report["sections"]["search"]["cases"]["gdynia_stockholm_12_courses_5_nm"]["goal_directed"]
    text = render({**report, "sections": {**report["sections"], "plan": {"failed": "OSError: full"}}})
    row = next(line for line in text.splitlines() if "12 courses 5 nm, goal directed" in line)
    assert f"| {case['vertices']:,} |" in row
    assert f"| {case['median_ms']:.2f} |" in row
    assert ("kept" if case["within"] else "missed") in row
    assert "plan failed: OSError: full" in text
    tables = [line for line in text.splitlines() if line.startswith("| --- |")]
    beside = report["sections"]["rooms"]["beside_hrosailing"]["outcome"] == "compared"
    assert len(tables) == 4 + beside


def test_failing_section_costs_no_other(monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    def broken(pace: Any) -> Any:
        raise OSError(f"disk full after {pace.runs} runs")

    monkeypatch.setattr("benchmarks.rooms.rooms", broken)
    monkeypatch.setattr("benchmarks.lattices.lattice_builds", lambda pace: {"runs": pace.runs})
    assert main(["--quick", "rooms", "lattice"]) == 1
    sections = json.loads(capsys.readouterr().out)["sections"]
    assert sections["rooms"] == {"failed": "OSError: disk full after 1 runs"}
    assert sections["lattice"]["runs"] == 1


def test_every_section_exists() -> None:
    for module, function in SECTIONS.values():
        assert callable(getattr(importlib.import_module(f"benchmarks.{module}"), function))


def test_unknown_section_is_refused() -> None:
    answer = subprocess.run(
        [sys.executable, "-m", "benchmarks", "speed"],
        cwd=REPOSITORY,
        capture_output=True,
        text=True,
        check=False,
    )
    assert answer.returncode == 2
    assert "no section speed" in answer.stderr
    assert answer.stdout == ""


def test_absent_program_says_how_to_get_it() -> None:
    figures = measure.attempt(lambda: {"outcome": str(importlib.import_module("no_such_router"))})
    assert figures == {"outcome": f"{measure.HOW_TO_INSTALL} (No module named 'no_such_router')"}


def test_raising_program_is_quoted() -> None:
    def broken() -> measure.Figures:
        raise ValueError("axis 1 is out of bounds")

    assert measure.attempt(broken)["outcome"] == "It raised ValueError: axis 1 is out of bounds"


def test_processes_are_measured_without_the_memory_of_whoever_starts_them() -> None:
    # 200 MB here must not be found again in a process that needs 10.
    ballast = np.ones(25_000_000)
    sailed = measure.run_process([sys.executable, "-S", "-c", "print('ahoy'); raise SystemExit(3)"])
    assert (sailed.code, sailed.output.strip()) == (3, "ahoy")
    assert ballast.sum() == 25_000_000
    assert sailed.peak_mb is None or 1 < sailed.peak_mb < 100


def test_simulator_sails_a_reach_in_the_time_of_the_polar() -> None:
    yacht = sloop()
    simulator = Simulator(steady_wind(12.0, 270.0), yacht)
    lat, lon = [56.0, 57.0, 58.0], [19.0, 19.0, 19.0]
    voyage = simulator.sail(lat, lon, T0)
    metres = float(rhumb_distance_m(56.0, 19.0, 58.0, 19.0))
    speed = float(yacht.speed(12.0 * MS_PER_KNOT, 90.0))
    assert voyage.hours == pytest.approx(metres / speed / 3600, rel=2e-4)
    assert voyage.distance_nm == pytest.approx(metres / 1852)


def test_simulator_beats_only_where_it_may() -> None:
    simulator = Simulator(steady_wind(12.0, 0.0), sloop())
    beat = simulator.sail([56.0, 57.0], [19.0, 19.0], T0)
    dead = simulator.sail([56.0, 57.0], [19.0, 19.0], T0, tacking=False)
    assert math.isfinite(beat.hours)
    assert dead.hours > 2 * beat.hours


def test_simulator_agrees_with_the_sailing_that_seacruise_shows() -> None:
    yacht, wind = sloop(), steady_wind(14.0, 230.0)
    sea = open_sea()
    asked = Question(sea, wind, yacht, PRECISE, (56.0, 18.0), (58.5, 19.5), T0)
    x, y = to_mercator([56.0, 57.0, 58.5], [18.0, 19.5, 19.5])
    course: Course = straight_legs(Line(x, y, np.zeros(3)))
    shown = resail(asked, course, fuel_rate_l_h=0.0)
    voyage = Simulator(wind, yacht).sail([56.0, 57.0, 58.5], [18.0, 19.5, 19.5], T0, tacking=False)
    assert voyage.hours == pytest.approx((shown.time[-1] - T0) / 3600, rel=1e-3)


def test_polar_for_the_other_program_is_the_same_polar() -> None:
    yacht: Polar = sloop()
    table = np.loadtxt(io.StringIO(polar_file(yacht)), skiprows=1)
    angles, speeds = table[:, 0], table[:, 1:]
    assert angles.tolist() == list(range(0, 181, 5))
    assert speeds[18, 6] == pytest.approx(
        float(yacht.speed(12.0 * MS_PER_KNOT, 90.0)) / MS_PER_KNOT, abs=1e-4
    )
