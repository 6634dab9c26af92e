"""Searches and lattices: how long, and how it grows."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Final

import numpy as np

from benchmarks.measure import Figures, Pace, in_ms, say, stopwatch, within
from benchmarks.world import OFF_STOCKHOLM, Position, World, world
from seacruise.geodesy import to_mercator
from seacruise.routing import lattice as lattices
from seacruise.routing import stencil
from seacruise.routing.find import COURSES, SPACING_NM, Question, approach_levels
from seacruise.routing.lattice import NO_LEVELS, Area, Lattice, Levels
from seacruise.routing.search import connected, search
from seacruise.units import METRES_PER_NM, SECONDS_PER_HOUR

PASSAGE_NM: Final = 400.0
BALTIC_NM: Final = 1200.0
"""Sums of the distances to both ends [nm]: an ellipse for a passage, and one that holds the whole sea."""


@dataclass(frozen=True, slots=True)
class Recipe:
    """A lattice of one spacing, and what it may cost."""

    courses: int
    spacing_nm: float
    reach_nm: float
    search_ms: float | None = None
    build_s: float | None = None
    whole: bool = False

    def build(self, at: World, *, levels: Levels = NO_LEVELS) -> Lattice:
        """Build it from Gdynia to open water before Stockholm."""
        start = at.water_at("Gdynia")
        return lattices.build(
            at.sea,
            start,
            OFF_STOCKHOLM,
            spacing_nm=self.spacing_nm,
            offsets=stencil.triangular(self.courses),
            area=Area("ellipse", _line(start, OFF_STOCKHOLM), self.reach_nm * METRES_PER_NM),
            levels=levels,
        )


# Budgets are those of the plan of the house; 0.6 nm is where the Baltic has the vertices planned for 1 nm.
RECIPES: Final = {
    "gdynia_stockholm_12_courses_5_nm": Recipe(12, 5.0, PASSAGE_NM, search_ms=2.0),
    "gdynia_stockholm_24_courses_2_nm": Recipe(24, 2.0, PASSAGE_NM, search_ms=15.0),
    "baltic_24_courses_1_nm": Recipe(24, 1.0, BALTIC_NM, search_ms=400.0, build_s=1.0, whole=True),
    "baltic_24_courses_0.6_nm": Recipe(24, 0.6, BALTIC_NM, search_ms=400.0, build_s=1.0, whole=True),
}


def _line(start: Position, end: Position) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    x, y = to_mercator(*zip(start, end, strict=True))
    return np.array([[x[0], y[0], x[1], y[1]]])


def _chosen(pace: Pace) -> dict[str, Recipe]:
    return dict(list(RECIPES.items())[: 1 if pace.quick else None])


def searches(pace: Pace) -> Figures:
    """Earliest arrivals over lattices, and how the time grows with vertices and courses."""
    at = world()
    figures: Figures = {
        "about": "To open water before Stockholm (58.85 N 18.6 E): a lattice of one spacing does not reach "
        "the harbour. goal_directed stops at the end; whole_area settles every vertex.",
        "cases": {},
    }
    for name, recipe in _chosen(pace).items():
        say(f"search: {name}")
        grid = recipe.build(at)
        figures["cases"][name] = {
            "goal_directed": _timed(at, grid, pace, budget_ms=recipe.search_ms),
            "whole_area": _timed(
                at, grid, pace, budget_ms=recipe.search_ms if recipe.whole else None, to_end=False
            ),
        }
    figures["cases"]["gdynia_stockholm_as_precise_first_searches"] = _first_search(at, pace)
    say("search: growth")
    spacings = (12.0, 6.0) if pace.quick else (12.0, 4.0, 1.25, 0.39)
    figures["growth_with_vertices_12_courses"] = [
        _grown(at, Recipe(12, spacing, BALTIC_NM), pace) for spacing in spacings
    ]
    courses = (12, 24) if pace.quick else stencil.COURSES[1:]
    figures["growth_with_courses_2_nm"] = [_grown(at, Recipe(n, 2.0, PASSAGE_NM), pace) for n in courses]
    return figures


def _first_search(at: World, pace: Pace) -> Figures:
    """Search harbour to harbour on the lattice of several spacings that the precise preset begins with."""
    start, end = at.water_at("Gdynia"), at.water_at("Stockholm")
    asked: Question = at.question(start, end)
    grid = lattices.build(
        at.sea,
        start,
        end,
        spacing_nm=SPACING_NM,
        offsets=stencil.triangular(COURSES),
        area=Area("ellipse", asked.ends, PASSAGE_NM * METRES_PER_NM),
        levels=approach_levels(asked, SPACING_NM, 0),
    )
    return {"courses": COURSES, "spacing_nm": SPACING_NM, "goal_directed": _timed(at, grid, pace)}


def _grown(at: World, recipe: Recipe, pace: Pace) -> Figures:
    about = {"courses": recipe.courses, "spacing_nm": recipe.spacing_nm}
    return about | _timed(at, recipe.build(at), pace, to_end=False)


def _timed(
    at: World, grid: Lattice, pace: Pace, *, budget_ms: float | None = None, to_end: bool = True
) -> Figures:
    """Search again and again on one lattice, on the wind and speeds that a passage uses."""
    field, speeds = at.field(), at.speeds
    found = search(grid, field, speeds, at.departure, to_end=to_end)
    seconds = stopwatch(lambda: search(grid, field, speeds, at.departure, to_end=to_end), runs=pace.runs)
    figures = in_ms(seconds, budget_ms=budget_ms)
    hours = (float(found.arrival[grid.end]) - at.departure) / SECONDS_PER_HOUR
    return figures | {
        "vertices": grid.vertices,
        "edges": int(grid.target.size),
        "settled": found.settled,
        "relaxed": found.relaxed,
        "ns_per_relaxation": round(figures["median_ms"] * 1e6 / max(1, found.relaxed), 1),
        "found_h": round(hours, 3) if connected(grid) else None,
    }


def lattice_builds(pace: Pace) -> Figures:
    """Land-checked lattices from nothing; the program keeps those used last in memory."""
    at = world()
    figures: Figures = {}
    for name, recipe in _chosen(pace).items():
        say(f"lattice: {name}")
        grid = recipe.build(at)
        runs = pace.runs if grid.vertices < 50_000 else min(pace.runs, 5)
        seconds = []
        for _ in range(runs):
            begun = time.perf_counter()
            recipe.build(at)
            seconds.append(time.perf_counter() - begun)
        case: Figures = {
            "median_s": round(float(np.median(seconds)), 4),
            "min_s": round(min(seconds), 4),
            "runs": runs,
            "vertices": grid.vertices,
            "edges": int(grid.target.size),
            "ns_per_edge": round(float(np.median(seconds)) / max(1, grid.target.size) * 1e9, 1),
        }
        if recipe.build_s is not None:
            case |= within(case, "median_s", recipe.build_s)
        figures[name] = case
    return figures
