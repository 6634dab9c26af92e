"""How far the precise preset stays from the best passage that much more searching finds."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

from benchmarks.measure import Figures, Pace, say, within
from benchmarks.simulator import Simulator
from benchmarks.world import PASSAGES, PRECISE, World, other_winds, world
from seacruise.errors import NoPassageError
from seacruise.geodesy import from_mercator
from seacruise.passage import Options, plan, sail_again
from seacruise.progress import Job
from seacruise.routing.find import Finder, Ledger, Question
from seacruise.routing.lattice import Levels
from seacruise.routing.refine import Line, in_corridor, relaxed
from seacruise.units import SECONDS_PER_HOUR

BUDGET_PERCENT: Final = 0.1
COURSES: Final = 132


@dataclass(frozen=True, slots=True)
class Corridor:
    """One more search around the best line so far."""

    spacing_nm: float
    width_nm: float
    levels: int


CORRIDORS: Final = (
    Corridor(2.0, 20.0, 3),
    Corridor(1.0, 9.0, 2),
    Corridor(0.7, 6.0, 2),
    Corridor(0.5, 4.0, 2),
)
"""Each is run with 132 courses and relaxed; the best of all lines is what the others are held against."""


def search_as_precise(asked: Question) -> Line:
    """Find the line that the precise preset finds, before boards are put in."""
    return Finder().fastest(asked, job=Job(), ledger=Ledger()).line


def converged(at: World, asked: Question, found: Line) -> Line:
    """Search on until little can be left: the best of many lines, by the search's own fine integrator.

    Two beginnings, the line that was found and that of another lattice of the whole area with twice the
    courses and half the spacing, so that a wrong side of an island does not decide the result.
    """
    waters = at.waters(asked.sea)
    wide = replace(asked, how=replace(PRECISE, directions=72, spacing_nm=2.5, refine=False))
    lines = [relaxed(waters, found), relaxed(waters, search_as_precise(wide))]
    for base in tuple(lines):
        best = base
        for corridor in CORRIDORS:
            line, _, _ = in_corridor(
                waters,
                best,
                spacing_nm=corridor.spacing_nm,
                courses=COURSES,
                width_nm=corridor.width_nm,
                levels=Levels(everywhere=corridor.levels),
            )
            if line is not None:
                lines.append(relaxed(waters, line))
                best = min((best, lines[-1]), key=lambda one: one.seconds)
    return min(lines, key=lambda one: one.seconds)


def shown(asked: Question, line: Line) -> tuple[float, bool]:
    """Hours that SeaCruise would show for a line, boards put in and sailed again, and is it free of land."""
    _, sailed = sail_again(asked, line)
    return float(sailed.time[-1] - asked.departure) / SECONDS_PER_HOUR, sailed.land_free


def simulated_h(simulator: Simulator, asked: Question, line: Line) -> float:
    """Hours of a line in the simulator of these benchmarks, beats on the hull of the polar."""
    lat, lon = from_mercator(line.x, line.y)
    return simulator.sail(lat.tolist(), lon.tolist(), asked.departure).hours


def accuracy(pace: Pace) -> Figures:
    """Gap of the precise preset to the converged optimum, on the passages and winds of the issue."""
    at = world()
    winds = {"sample": at.wind} | ({} if pace.quick else other_winds())
    figures: Figures = {
        "about": "gap_percent: hours as shown (boards put in, sailed again) against those of the best line "
        f"that searches with {COURSES} courses down to {CORRIDORS[-1].spacing_nm} nm found, both made and "
        "sailed alike; line_gap_percent: the same lines in this benchmark's own simulator, without boards. "
        "A gap below zero: the boards fell better for ours. classic_h: the preset of the publication, null "
        "where it finds no way.",
        "passages": {},
    }
    for name, wind in winds.items():
        there = at if wind is at.wind else at.under(wind)
        for start, end in PASSAGES[: 1 if pace.quick else None]:
            say(f"accuracy: {start} - {end}, {name}")
            figures["passages"][f"{start} - {end}, {name}"] = _gap(there, start, end)
    for name, key in (("shown", "gap_percent"), ("lines", "line_gap_percent")):
        worst = {"worst_gap_percent": max(case[key] for case in figures["passages"].values())}
        figures[name] = worst | within(worst, "worst_gap_percent", BUDGET_PERCENT)
    slower = [
        name
        for name, case in figures["passages"].items()
        if case["classic_h"] is not None and case["found_h"] > case["classic_h"]
    ]
    figures["slower_than_classic"] = slower
    return figures


def _gap(at: World, start: str, end: str) -> Figures:
    simulator = Simulator(at.wind, at.yacht)
    asked = at.question(at.water_at(start), at.water_at(end))
    ours = search_as_precise(asked)
    best = converged(at, asked, ours)
    passage = plan(at.request(start, end), settings=at.settings)
    found_h, free = passage.duration_h, passage.checks.land_free
    optimum_h, best_free = shown(asked, best)
    line_h, best_line_h = (simulated_h(simulator, asked, line) for line in (ours, best))
    return {
        "found_h": round(found_h, 4),
        "optimum_h": round(optimum_h, 4),
        "gap_percent": _percent(found_h, optimum_h),
        "line_h": round(line_h, 4),
        "optimum_line_h": round(best_line_h, 4),
        "line_gap_percent": _percent(line_h, best_line_h),
        "land_free": free and best_free,
        "classic_h": _classic_h(at, start, end),
    }


def _classic_h(at: World, start: str, end: str) -> float | None:
    request = replace(at.request(start, end), options=Options(preset="classic"))
    try:
        return round(plan(request, settings=at.settings).duration_h, 4)
    except NoPassageError:
        return None


def _percent(hours: float, optimum: float) -> float:
    return round(100.0 * (hours / optimum - 1.0), 4)
