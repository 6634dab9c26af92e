"""Two programs from PyPI beside ours: same wind, same yacht, same ends, one simulator for all.

What a program prints as its duration is not comparable: some stop miles short of the port and call that
the arrival. So every route is sailed again to the port by `benchmarks.simulator`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from benchmarks.accuracy import converged, simulated_h
from benchmarks.hro import hrosailing_figures
from benchmarks.isochrones import Route, route_by_weatherrouting
from benchmarks.measure import Figures, Pace, attempt, in_ms, say, stopwatch
from benchmarks.simulator import Simulator, Voyage
from benchmarks.world import Position, World, open_sea, world
from seacruise.geodesy import from_mercator, great_circle_m
from seacruise.progress import Job
from seacruise.routing.find import Finder, Ledger, Question
from seacruise.routing.manoeuvres import Course, sail_boards
from seacruise.routing.resail import resail
from seacruise.units import METRES_PER_NM, SECONDS_PER_HOUR


@dataclass(frozen=True, slots=True)
class Case:
    """A passage for all programs.

    Attributes
    ----------
    land
        Held against the coast; else all is water, for programs that know no land.
    """

    start: Position
    end: Position
    land: bool


CASES: Final = {
    "open_water_139_nm": Case((55.0, 19.0), (57.3, 19.6), land=False),
    "open_water_288_nm": Case((54.56, 18.75), (59.35, 18.75), land=False),
    "open_water_288_nm_back": Case((59.35, 18.75), (54.56, 18.75), land=False),
    "with_land_258_nm": Case((54.56, 18.75), (58.85, 18.6), land=True),
}


def peers(pace: Pace) -> Figures:
    """Routes of all programs, and the leg helpers of hrosailing."""
    at = world()
    simulator = Simulator(at.wind, at.yacht)
    figures: Figures = {
        "about": "sailed_h: the route sailed again to the port by the common simulator, which may tack on "
        "every leg; gap_percent: against the converged optimum in the same simulator; ratio: computing time "
        "against ours with a lattice built anew.",
        "routes": {},
    }
    for name, case in list(CASES.items())[: 1 if pace.quick else None]:
        say(f"peers: {name}")
        figures["routes"][name] = _compared(at, simulator, case, pace)
    say("peers: hrosailing")
    figures["hrosailing"] = attempt(lambda: hrosailing_figures(at, simulator, runs=pace.runs))
    return figures


def _compared(at: World, simulator: Simulator, case: Case, pace: Pace) -> Figures:
    sea = at.sea if case.land else open_sea()
    asked = at.question(case.start, case.end, sea=sea)
    ours, line_h, optimum_h = _ours(at, simulator, asked, pace)
    figures: Figures = {
        "start": case.start,
        "end": case.end,
        "direct_nm": round(float(great_circle_m(*case.start, *case.end)) / METRES_PER_NM, 1),
        "land": case.land,
        "optimum_h": round(optimum_h, 4),
        "seacruise": ours,
    }
    say("peers: weatherrouting")

    def judged() -> Figures:
        route = route_by_weatherrouting(at, simulator, asked, land=case.land)
        return _judge(simulator, asked, route, ours=ours, ours_h=line_h, optimum_h=optimum_h)

    figures["weatherrouting"] = attempt(judged)
    return figures


def _ours(at: World, simulator: Simulator, asked: Question, pace: Pace) -> tuple[Figures, float, float]:
    """Figures of the precise preset, its sailed hours, and those of the converged optimum."""
    kept = Finder()

    def answer(finder: Finder) -> None:
        line = finder.fastest(asked, job=Job(), ledger=Ledger()).line
        resail(asked, sail_boards(asked, line), fuel_rate_l_h=0.0)

    anew = stopwatch(lambda: answer(Finder()), runs=pace.runs)
    again = stopwatch(lambda: answer(kept), runs=pace.runs)
    line = kept.fastest(asked, job=Job(), ledger=Ledger()).line
    course = sail_boards(asked, line)
    shown = resail(asked, course, fuel_rate_l_h=0.0)
    sailed = _simulated(simulator, asked, course)
    best = converged(at, asked, line)
    # Of the optimum with and without its boards the better one: nothing is given away.
    optimum_h = min(
        simulated_h(simulator, asked, best),
        _simulated(simulator, asked, sail_boards(asked, best)).hours,
        sailed.hours,
    )
    figures: Figures = {
        "sailed_h": round(sailed.hours, 4),
        "shown_h": round(float(shown.time[-1] - asked.departure) / SECONDS_PER_HOUR, 4),
        "distance_nm": round(sailed.distance_nm, 1),
        "gap_percent": _percent(sailed.hours, optimum_h),
        "waypoints": int(course.x.size),
        "computing_lattice_built": in_ms(anew),
        "computing_lattice_kept": in_ms(again),
    }
    return figures, sailed.hours, optimum_h


def _simulated(simulator: Simulator, asked: Question, course: Course) -> Voyage:
    lat, lon = from_mercator(course.x, course.y)
    return simulator.sail(lat.tolist(), lon.tolist(), asked.departure)


def _judge(
    simulator: Simulator, asked: Question, route: Route, *, ours: Figures, ours_h: float, optimum_h: float
) -> Figures:
    """Sail a route to the port and hold it against ours."""
    lat, lon = [*route.lat, asked.end[0]], [*route.lon, asked.end[1]]
    short = float(great_circle_m(lat[-2], lon[-2], *asked.end)) / METRES_PER_NM
    sailed = simulator.sail(lat, lon, asked.departure)
    figures: Figures = {
        "claimed_h": round(route.claimed_h, 4),
        "ends_short_of_the_port_nm": round(short, 2),
        "computing_s": round(route.seconds, 2),
        "runs": 1,
        "ratio_of_computing": round(route.seconds / (ours["computing_lattice_built"]["median_ms"] / 1e3), 1),
        "waypoints": len(lat),
    }
    if not math.isfinite(sailed.hours):
        return figures | {"outcome": "The route cannot be sailed to its end: she is becalmed on it."}
    return figures | {
        "outcome": "sailed",
        "sailed_h": round(sailed.hours, 4),
        "distance_nm": round(sailed.distance_nm, 1),
        "gap_percent": _percent(sailed.hours, optimum_h),
        "slower_than_ours_percent": _percent(sailed.hours, ours_h),
    }


def _percent(hours: float, best: float) -> float:
    return round(100.0 * (hours / best - 1.0), 4)
