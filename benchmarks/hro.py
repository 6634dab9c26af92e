"""hrosailing 0.12 (Apache-2.0): it has no router, but it answers what a leg costs and how a beat is split."""

from __future__ import annotations

import math
import time
import warnings
from datetime import UTC, datetime
from importlib import import_module
from typing import Any, Final

import numpy as np

from benchmarks.measure import Figures, in_ms, stopwatch
from benchmarks.simulator import Simulator
from benchmarks.world import Position, World
from seacruise.geodesy import great_circle_m, rhumb_course_deg
from seacruise.units import METRES_PER_NM, MS_PER_KNOT, SECONDS_PER_HOUR
from seacruise.yacht.hull import hull_headings

LEGS: Final = {
    "139_nm": ((55.0, 19.0), (57.3, 19.6)),
    "288_nm": ((54.56, 18.75), (59.35, 18.75)),
    "288_nm_back": ((59.35, 18.75), (54.56, 18.75)),
}
TWS_KN: Final = 12.0
ISOCHRONE_COURSE_DEG: Final = 10.0


class _Weather:
    """What it calls a weather model: components in knots, since its distances are nautical miles."""

    def __init__(self, simulator: Simulator) -> None:
        self._wind_at = simulator.wind_at

    def get_weather(self, point: tuple[datetime, float, float]) -> dict[str, float]:
        when, lat, lon = point
        u, v = self._wind_at(when.timestamp(), float(lat), float(lon))
        return {"UGRID": u / MS_PER_KNOT, "VGRID": v / MS_PER_KNOT}


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
        figures: Figures = {"cost_cruise_straight_leg": {}}
        for name, (start, end) in LEGS.items():
            figures["cost_cruise_straight_leg"][name] = _cost(at, simulator, cruising, diagram, start, end)
        figures["isochrone_1_h"] = _isochrone(at, simulator, cruising, diagram)
        figures["cruise"] = _cruise(at, cruising, diagram)
        figures["convex_direction_12_kn"] = _convex(at, cruising, diagram, runs=runs)
    return figures


def _departure(at: World) -> datetime:
    return datetime.fromtimestamp(at.departure, UTC)


def _raised(error: Exception) -> Figures:
    return {"outcome": f"It raised {type(error).__name__}: {error}"}


def _cost(
    at: World, simulator: Simulator, cruising: Any, diagram: Any, start: Position, end: Position
) -> Figures:
    begun = time.perf_counter()
    try:
        hours = float(cruising.cost_cruise(diagram, start, end, _departure(at), _Weather(simulator)))
    except Exception as error:  # noqa: BLE001 - other people's programs raise what they like
        return _raised(error)
    seconds = time.perf_counter() - begun
    begun = time.perf_counter()
    true = simulator.sail([start[0], end[0]], [start[1], end[1]], at.departure, tacking=False)
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


def _isochrone(at: World, simulator: Simulator, cruising: Any, diagram: Any) -> Figures:
    start = LEGS["139_nm"][0]
    begun = time.perf_counter()
    try:
        end, length = cruising.isochrone(
            diagram, start, _departure(at), ISOCHRONE_COURSE_DEG, _Weather(simulator), total_time=1
        )
    except Exception as error:  # noqa: BLE001 - other people's programs raise what they like
        return _raised(error)
    seconds = time.perf_counter() - begun
    speed = simulator.speed(at.departure + SECONDS_PER_HOUR / 2, *start, ISOCHRONE_COURSE_DEG, tacking=False)
    away = float(great_circle_m(*start, float(end[0]), float(end[1]))) / METRES_PER_NM
    return {
        "course_deg": ISOCHRONE_COURSE_DEG,
        "claimed_nm": round(float(length), 2),
        "its_end_lies_away_nm": round(away, 2),
        "its_end_lies_on_course_deg": round(float(rhumb_course_deg(*start, float(end[0]), float(end[1]))), 1),
        "simulator_nm": round(speed * SECONDS_PER_HOUR / METRES_PER_NM, 2),
        "computing_s": round(seconds, 3),
    }


def _cruise(at: World, cruising: Any, diagram: Any) -> Figures:
    start, end = ((lon, lat) for lat, lon in LEGS["139_nm"])
    try:
        answer = cruising.cruise(diagram, start, end, (TWS_KN, 270.0))
    except Exception as error:  # noqa: BLE001 - other people's programs raise what they like
        return _raised(error)
    course = float(rhumb_course_deg(*LEGS["139_nm"][0], *LEGS["139_nm"][1]))
    speed = float(at.yacht.speed(TWS_KN * MS_PER_KNOT, 270.0 - course))
    hours = float(great_circle_m(*LEGS["139_nm"][0], *LEGS["139_nm"][1])) / speed / SECONDS_PER_HOUR
    return {
        "outcome": "answered",
        "claimed_h": round(sum(h for _, h in answer), 3),
        "true_h": round(hours, 3),
    }


def _convex(at: World, cruising: Any, diagram: Any, *, runs: int) -> Figures:
    """Speed made good by its two headings against that by ours, every 5 degrees."""
    courses = np.arange(0.0, 181.0, 5.0)
    tws = TWS_KN * MS_PER_KNOT

    def made(angles: list[tuple[float, float]], course: float) -> float:
        return sum(
            share * float(at.yacht.speed(tws, angle)) * math.cos(math.radians(angle - course))
            for angle, share in angles
        )

    theirs, own, impossible = [], [], []
    for course in courses.tolist():
        try:
            split = cruising.convex_direction(diagram, TWS_KN, course)
        except Exception as error:  # noqa: BLE001 - other people's programs raise what they like
            return _raised(error) | {"course_deg": course}
        if any(not -1e-9 <= d.proportion <= 1.0 + 1e-9 for d in split):
            impossible.append(
                {"course_deg": course, "shares": [round(float(d.proportion), 3) for d in split]}
            )
            continue
        # A single heading stands for sailing the course itself.
        headings = [(d.angle, d.proportion) for d in split] if len(split) > 1 else [(course, 1.0)]
        theirs.append(made(headings, course))
        first, share, second, other = (float(v) for v in hull_headings(at.yacht, tws, course))
        own.append(made([(first, share), (second, other)], course))
    less = 100.0 * (1.0 - np.array(theirs) / np.array(own))
    slow = stopwatch(lambda: cruising.convex_direction(diagram, TWS_KN, 20.0), runs=runs)
    fast = stopwatch(lambda: hull_headings(at.yacht, tws, courses), runs=runs)
    per_call, per_course = in_ms(slow), in_ms([s / courses.size for s in fast])
    return {
        "outcome": "compared",
        "courses": int(courses.size),
        "shares_below_zero_or_above_one": impossible,
        "less_made_good_than_ours_worst_percent": round(float(less.max()), 3),
        "less_made_good_than_ours_mean_percent": round(float(less.mean()), 3),
        "per_course": per_call,
        "ours_per_course": per_course,
        "ratio_of_computing": round(per_call["median_ms"] / per_course["median_ms"], 1),
    }
