"""hrosailing 0.12 (Apache-2.0): it has no router, but it tells what a leg costs and how a beat is split."""

from __future__ import annotations

import math
import time
import warnings
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import partial
from importlib import import_module
from typing import Any, Final

import numpy as np

from benchmarks.measure import Figures, attempt, in_ms, stopwatch
from benchmarks.simulator import Simulator
from benchmarks.world import Position, World
from seacruise.geodesy import great_circle_m, rhumb_course_deg
from seacruise.units import METRES_PER_NM, MS_PER_KNOT, SECONDS_PER_HOUR
from seacruise.yacht.hull import hull_headings
from seacruise.yacht.polar import Polar

Leg = tuple[Position, Position]

LEGS: Final[dict[str, Leg]] = {
    "139_nm": ((55.0, 19.0), (57.3, 19.6)),
    "288_nm": ((54.56, 18.75), (59.35, 18.75)),
    "288_nm_back": ((59.35, 18.75), (54.56, 18.75)),
}
TWS_KN: Final = 12.0
TWD_DEG: Final = 270.0
ISOCHRONE_COURSE_DEG: Final = 10.0


class _Weather:
    """What it calls a weather model: components in knots, since its distances are nautical miles."""

    def __init__(self, simulator: Simulator) -> None:
        self._wind_at = simulator.wind_at

    def get_weather(self, point: tuple[datetime, float, float]) -> dict[str, float]:
        when, lat, lon = point
        u, v = self._wind_at(when.timestamp(), float(lat), float(lon))
        return {"UGRID": u / MS_PER_KNOT, "VGRID": v / MS_PER_KNOT}


@dataclass(frozen=True, slots=True, eq=False)
class _Bench:
    """Its functions, its form of our polar, and what they are held against."""

    cruising: Any
    diagram: Any
    yacht: Polar
    simulator: Simulator
    departure: float

    @property
    def when(self) -> datetime:
        return datetime.fromtimestamp(self.departure, UTC)


def hrosailing_figures(at: World, simulator: Simulator, *, runs: int) -> Figures:
    """Its four public functions against the simulator and our hull."""
    with warnings.catch_warnings():
        # It uses names that NumPy and SciPy are about to drop; that is not what is measured here.
        warnings.simplefilter("ignore")
        cruising, polars = (import_module(f"hrosailing.{room}") for room in ("cruising", "polardiagram"))
        tws, twa = np.arange(2.0, 41.0, 2.0), np.arange(0.0, 360.0, 2.0)
        diagram = polars.PolarDiagramTable(
            ws_resolution=tws,
            wa_resolution=twa,
            bsps=at.yacht.speed(tws * MS_PER_KNOT, twa[:, None]) / MS_PER_KNOT,
        )
        bench = _Bench(cruising, diagram, at.yacht, simulator, at.departure)
        return {
            "cost_cruise_straight_leg": {
                name: attempt(partial(_cost, bench, leg)) for name, leg in LEGS.items()
            },
            "isochrone_1_h": attempt(lambda: _isochrone(bench)),
            "cruise": attempt(lambda: _cruise(bench)),
            "convex_direction_12_kn": attempt(lambda: _convex(bench, runs=runs)),
        }


def beside_hrosailing(yacht: Polar, *, runs: int) -> Figures:
    """Evaluate a polar and find hull directions with both programs, from one and the same table.

    Its functions take one wind and one angle a call; ours take arrays, and are also timed one point a call.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        cruising, polars = (import_module(f"hrosailing.{room}") for room in ("cruising", "polardiagram"))
        full = np.unique(np.concatenate((yacht.twa, np.arange(0.0, 181.0, 5.0))))
        tws_kn = yacht.tws / MS_PER_KNOT
        table = Polar(yacht.name, yacht.tws, full, yacht.speed(yacht.tws, full[:, None]))
        both_tacks = np.concatenate((full, 360.0 - full[-2:0:-1]))
        diagram = polars.PolarDiagramTable(
            ws_resolution=tws_kn,
            wa_resolution=both_tacks,
            bsps=table.speed(table.tws, both_tacks[:, None]) / MS_PER_KNOT,
        )
        return {
            "outcome": "compared",
            "evaluation": _evaluation(table, diagram, runs=runs),
            "hull_directions": _directions(cruising, table, diagram, runs=runs),
        }


def _evaluation(table: Polar, diagram: Any, *, runs: int) -> Figures:
    winds_kn, angles = np.linspace(4.0, 20.0, 10), np.linspace(40.0, 170.0, 20)

    def theirs() -> list[float]:
        return [float(diagram(tws, twa)) for tws in winds_kn.tolist() for twa in angles.tolist()]

    def ours() -> Any:
        return table.speed(winds_kn[:, None] * MS_PER_KNOT, angles)

    difference = np.array(theirs()).reshape(ours().shape) / (ours() / MS_PER_KNOT) - 1.0
    slow, fast = in_ms(stopwatch(theirs, runs=runs)), in_ms(stopwatch(ours, runs=runs))
    single = in_ms(stopwatch(lambda: table.speed(6.3, 71.0), runs=runs))
    return {
        "points": int(difference.size),
        "theirs": slow,
        "ours": fast,
        "ours_one_point_a_call": single,
        "ratio": round(slow["median_ms"] / fast["median_ms"], 1),
        "ratio_one_point_a_call": round(slow["median_ms"] / difference.size / single["median_ms"], 1),
        "difference_worst_percent": round(100.0 * float(np.abs(difference).max()), 2),
        "difference_rms_percent": round(100.0 * float(np.sqrt((difference**2).mean())), 2),
    }


def _directions(cruising: Any, table: Polar, diagram: Any, *, runs: int) -> Figures:
    winds_kn, courses = (8.0, 12.0, 16.0), np.arange(0.0, 181.0, 15.0)

    def theirs() -> list[Any]:
        return [cruising.convex_direction(diagram, tws, twa) for tws in winds_kn for twa in courses.tolist()]

    def ours() -> Any:
        return hull_headings(table, np.array(winds_kn)[:, None] * MS_PER_KNOT, courses)

    impossible = sum(any(not -1e-9 <= part.proportion <= 1.0 + 1e-9 for part in split) for split in theirs())
    slow, fast = in_ms(stopwatch(theirs, runs=runs)), in_ms(stopwatch(ours, runs=runs))
    return {
        "directions": len(winds_kn) * int(courses.size),
        "theirs": slow,
        "ours": fast,
        "ratio": round(slow["median_ms"] / fast["median_ms"], 1),
        "their_shares_below_zero_or_above_one": int(impossible),
    }


def _cost(bench: _Bench, leg: Leg) -> Figures:
    (lat0, lon0), (lat1, lon1) = start, end = leg
    begun = time.perf_counter()
    hours = float(
        bench.cruising.cost_cruise(bench.diagram, start, end, bench.when, _Weather(bench.simulator))
    )
    seconds = time.perf_counter() - begun
    begun = time.perf_counter()
    true = bench.simulator.sail([lat0, lat1], [lon0, lon1], bench.departure, tacking=False)
    figures: Figures = {
        "claimed_h": round(hours, 3),
        "computing_s": round(seconds, 3),
        "simulator_s": round(time.perf_counter() - begun, 3),
        "direct_nm": round(float(great_circle_m(*start, *end)) / METRES_PER_NM, 1),
    }
    if not math.isfinite(true.hours):
        return figures | {"outcome": "The straight leg cannot be sailed without tacking; a time was claimed."}
    return figures | {
        "outcome": "compared",
        "sailed_h": round(true.hours, 3),
        "error_percent": round(100.0 * (hours / true.hours - 1.0), 1),
    }


def _isochrone(bench: _Bench) -> Figures:
    start = LEGS["139_nm"][0]
    course = ISOCHRONE_COURSE_DEG
    begun = time.perf_counter()
    end, length = bench.cruising.isochrone(
        bench.diagram, start, bench.when, course, _Weather(bench.simulator), total_time=1
    )
    seconds = time.perf_counter() - begun
    reached = float(end[0]), float(end[1])
    middle = bench.departure + SECONDS_PER_HOUR / 2
    true_m = bench.simulator.speed(middle, *start, course, tacking=False) * SECONDS_PER_HOUR
    return {
        "outcome": "compared",
        "course_deg": course,
        "claimed_nm": round(float(length), 2),
        "its_end_lies_away_nm": round(float(great_circle_m(*start, *reached)) / METRES_PER_NM, 2),
        "its_end_lies_on_course_deg": round(float(rhumb_course_deg(*start, *reached)), 1),
        "simulator_nm": round(true_m / METRES_PER_NM, 2),
        "computing_s": round(seconds, 3),
    }


def _cruise(bench: _Bench) -> Figures:
    start, end = LEGS["139_nm"]
    answer = bench.cruising.cruise(bench.diagram, start[::-1], end[::-1], (TWS_KN, TWD_DEG))
    twa = TWD_DEG - float(rhumb_course_deg(*start, *end))
    speed = float(bench.yacht.speed(TWS_KN * MS_PER_KNOT, twa))
    hours = float(great_circle_m(*start, *end)) / speed / SECONDS_PER_HOUR
    return {
        "outcome": "compared",
        "claimed_h": round(sum(time_h for _, time_h in answer), 3),
        "true_h": round(hours, 3),
    }


def _convex(bench: _Bench, *, runs: int) -> Figures:
    """Speed made good by its two headings against that by ours, every 5 degrees."""
    courses = np.arange(0.0, 181.0, 5.0)
    tws = TWS_KN * MS_PER_KNOT

    def made(headings: list[tuple[float, float]], course: float) -> float:
        return sum(
            share * float(bench.yacht.speed(tws, twa)) * math.cos(math.radians(twa - course))
            for twa, share in headings
        )

    less, impossible = [], []
    for course in courses.tolist():
        split = bench.cruising.convex_direction(bench.diagram, TWS_KN, course)
        if any(not -1e-9 <= part.proportion <= 1.0 + 1e-9 for part in split):
            shares = [round(float(part.proportion), 3) for part in split]
            impossible.append({"course_deg": course, "shares": shares})
            continue
        # A single heading stands for sailing the course itself.
        theirs = [(part.angle, part.proportion) for part in split] if len(split) > 1 else [(course, 1.0)]
        first, share, second, other = (float(v) for v in hull_headings(bench.yacht, tws, course))
        less.append(100.0 * (1.0 - made(theirs, course) / made([(first, share), (second, other)], course)))
    slow = stopwatch(lambda: bench.cruising.convex_direction(bench.diagram, TWS_KN, 20.0), runs=runs)
    fast = stopwatch(lambda: hull_headings(bench.yacht, tws, courses), runs=runs)
    per_call, per_course = in_ms(slow), in_ms([seconds / courses.size for seconds in fast])
    return {
        "outcome": "compared",
        "courses": int(courses.size),
        "shares_below_zero_or_above_one": impossible,
        "less_made_good_than_ours_worst_percent": round(max(less), 3),
        "less_made_good_than_ours_mean_percent": round(sum(less) / len(less), 3),
        "per_course": per_call,
        "ours_per_course": per_course,
        "ratio_of_computing": round(per_call["median_ms"] / per_course["median_ms"], 1),
    }
