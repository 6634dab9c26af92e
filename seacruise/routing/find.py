"""Find the fastest passage: the chain from ports to waypoints, for each preset.

``area -> lattice -> search -> refine`` for ``precise``; R1's rectangle and rules for ``classic``. When
there is no passage, this is where the reason is found.
"""

from __future__ import annotations

import math
import time
from collections import OrderedDict
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from functools import lru_cache, partial
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import great_circle_m, scale, to_mercator
from seacruise.progress import Job
from seacruise.routing import classic, stencil
from seacruise.routing.bound import farthest_m
from seacruise.routing.field import (
    COARSE_SLICE_S,
    FINE_SLICE_S,
    NO_LIMITS,
    Handling,
    SpeedTable,
    WindField,
    kept_field,
    speed_table,
)
from seacruise.routing.lattice import Area, Lattice, Levels
from seacruise.routing.levels import LatticeCache, Position, Recipe, levels_around
from seacruise.routing.manoeuvres import USUAL, Boards
from seacruise.routing.refine import PIECE_M as REFINED_PIECE_M
from seacruise.routing.refine import Line, Waters, followed, refine, timed
from seacruise.routing.refusal import why_not
from seacruise.routing.search import PIECE_M, connected, search
from seacruise.sea import Sea
from seacruise.sea.zones import NO_ZONES, Zones
from seacruise.units import METRES_PER_NM
from seacruise.weather.wind import Current, Wind
from seacruise.yacht.polar import Polar

Array = NDArray[np.float64]

COURSES: Final = 36
"""Courses of the first search: enough that it chooses the right side of an island."""

SPACING_NM: Final = 5.0
"""Spacing of the first search at sea [nm]; see `seacruise.routing.levels` for shores and approaches."""

MOST_DETAIL: Final = 2

_GUESSED_PACE: Final = 0.6
_FIRST_REACH: Final = 1.3
_LAST_REACH: Final = 4.0
_REACH_STEP: Final = 0.1
_KEPT: Final = 8


@dataclass(frozen=True, slots=True)
class Safety:
    """Safety zones (R3): where the lattice is finer, see `seacruise.routing.area.Levels`."""

    radius_m: float = 0.0
    levels: int = 0


NO_SAFETY: Final = Safety()


@dataclass(frozen=True, slots=True)
class How:
    """How to search; see `seacruise.passage.Options`."""

    preset: Literal["precise", "classic"]
    directions: int | None
    spacing_nm: float | None
    area: Literal["ellipse", "rectangle"] | None
    refine: bool
    handling: Handling
    corridor: bool = True
    boards: Boards = USUAL
    mesh: stencil.Kind = "triangular"
    safety: Safety = NO_SAFETY


@dataclass(slots=True)
class Ledger:
    """Sizes and seconds of each stage, collected on the way."""

    directions: int = 0
    spacing_nm: float = 0.0
    vertices: int = 0
    edges: int = 0
    settled: int = 0
    seconds: dict[str, float] = field(
        default_factory=lambda: dict.fromkeys(("sea", "lattice", "wind", "search", "refine", "check"), 0.0)
    )
    _begun: float = field(default_factory=time.perf_counter)

    def lap(self, stage: str) -> None:
        """Book the time since the last lap on a stage."""
        now = time.perf_counter()
        self.seconds[stage] += now - self._begun
        self._begun = now


@dataclass(frozen=True, slots=True, eq=False)
class Question:
    """What is asked of the router.

    Attributes
    ----------
    start, end
        Positions on the water [degrees].
    departure
        Seconds since 1970.
    clearance_nm
        What ``sea`` keeps off the shores already [nm]: told when that leaves no way.
    near
        Points ``(m, 2)`` of the plane [m] of a line that answered nearly the same question, to be followed.
    """

    sea: Sea
    wind: Wind
    polar: Polar
    how: How
    start: Position
    end: Position
    departure: float
    zones: Zones = NO_ZONES
    current: Current | None = None
    clearance_nm: float | None = None
    near: Array | None = None

    def winds(self, slice_s: float) -> WindField:
        """Cut wind, current and limits into slices of time, from the departure on."""
        handling = self.how.handling
        return kept_field(
            self.wind,
            slice_s=slice_s,
            since=self.departure,
            current=self.current,
            limits=handling.limits,
            knobs=handling.knobs,
        )

    @property
    def direct_m(self) -> float:
        """Great-circle distance of the ends [m]."""
        return float(great_circle_m(*self.start, *self.end))

    @property
    def ends(self) -> Array:
        """The direct line in the Mercator plane [m], ``(1, 4)``."""
        x, y = to_mercator(*zip(self.start, self.end, strict=True))
        return np.array([[x[0], y[0], x[1], y[1]]])

    @property
    def plane_per_nm(self) -> float:
        """Metres of the plane per nautical mile at the middle latitude."""
        return METRES_PER_NM / float(scale((self.start[0] + self.end[0]) / 2))


@dataclass(frozen=True, slots=True, eq=False)
class Fastest:
    """The line found, the lattice it was found on, and what else is needed to sail and to bound it.

    Attributes
    ----------
    near
        The line before waypoints were left out, for who follows it.
    speeds, field
        What bounds are reckoned with: the hull of the polar, wind and current.
    boards_found
        Whether tacks and gybes are in the line already, because they were searched with what they cost.
    """

    line: Line
    near: Line
    lattice: Lattice
    speeds: SpeedTable
    field: WindField
    boards_found: bool = False


class Finder:
    """Answers questions; keeps the lattices of the last ones."""

    def __init__(self) -> None:
        self.cache = LatticeCache()
        self._speeds: OrderedDict[tuple[int, Handling], tuple[Polar, SpeedTable]] = OrderedDict()

    def fastest(self, asked: Question, *, job: Job, ledger: Ledger) -> Fastest:
        """Find the fastest passage.

        Raises
        ------
        NoPassageError
            With the reason: ``no-water-path``, ``becalmed``, ``wind-limit`` or ``dead-angle``.
        """
        handling = asked.how.handling
        speeds = self._speed_table(asked.polar, handling)
        coarse, fine = asked.winds(COARSE_SLICE_S), asked.winds(FINE_SLICE_S)
        waters = Waters(asked.sea, fine, speeds, asked.zones)
        ledger.lap("wind")
        known: Line | None = None
        if asked.how.preset == "classic":
            line, grid = _classic(asked, job, ledger)
        else:
            # At the same time as the search: the kernels of both let go of the interpreter.
            following = None if asked.near is None else _follower().submit(_followed, asked, waters)
            line, grid = self._precise(asked, waters, coarse, job, ledger)
            known = None if following is None else following.result()
        if line is None:
            raise why_not(asked, grid)
        job.check()
        turned = None
        if any(handling.pauses) and asked.how.preset == "precise":
            waters = replace(waters, pauses=handling.pauses)
            turned = _turning(self.as_she_sails(asked), grid, asked.departure, job, ledger)
        # Where every board would be too short for the lattice she makes good the hull, as without costs.
        waters, line = turned or (waters, line)
        near = line
        if asked.how.refine:
            job.report("refine", None, "Refining the passage")
            line, near, settled = refine(waters, line, job, corridor=asked.how.corridor, known=known)
            ledger.settled += settled
        ledger.lap("refine")
        ledger.vertices, ledger.edges = grid.vertices, int(grid.target.size)
        return Fastest(line, near, grid, speeds, fine, boards_found=turned is not None)

    def as_she_sails(self, asked: Question) -> Waters:
        """Sea, wind and the speeds of the polar itself, every board of a beat one of its own."""
        handling = replace(asked.how.handling, tacking=False)
        speeds = self._speed_table(asked.polar, handling)
        return Waters(asked.sea, asked.winds(FINE_SLICE_S), speeds, asked.zones, handling.pauses)

    def _speed_table(self, polar: Polar, handling: Handling) -> SpeedTable:
        """Give one of the tables used last, or make another."""
        key = id(polar), handling
        # The polar is kept with its table: while it is, no other one can have its identity.
        _, table = kept if (kept := self._speeds.get(key)) else (polar, speed_table(polar, handling))
        self._speeds[key] = polar, table
        while len(self._speeds) > _KEPT:
            # Another thread may have been faster.
            self._speeds.pop(next(iter(self._speeds)), None)
        return table

    def _precise(
        self, asked: Question, waters: Waters, coarse: WindField, job: Job, ledger: Ledger
    ) -> tuple[Line | None, Lattice]:
        """Search the area; widen it until nothing outside can be faster, refine it until it is open."""
        direct = asked.direct_m
        most = stencil.RECTANGULAR_COURSES[-1]
        ledger.directions = asked.how.directions or (COURSES if asked.how.mesh == "triangular" else most)
        ledger.spacing_nm = asked.how.spacing_nm or min(SPACING_NM, max(0.5, direct / METRES_PER_NM / 40))
        # A guess of the duration spares most passages a second, wider search; the loop does not trust it.
        pace = _GUESSED_PACE * waters.field.fastest(waters.speeds, waters.field.mean)
        guessed = _reach_needed(asked, waters, direct / pace) if pace > 0.0 else 0.0
        reach = min(max(guessed, direct * _FIRST_REACH, direct + 20 * METRES_PER_NM), direct * _LAST_REACH)
        # A limit that is held at a coarse look may be broken at a fine one: look finely at once.
        handling = asked.how.handling
        fine = handling.max_wind is not None or handling.limits != NO_LIMITS
        look = partial(
            search,
            field=waters.field if fine else coarse,
            speeds=waters.speeds,
            departure=asked.departure,
            piece_m=REFINED_PIECE_M if fine else PIECE_M,
            zones=asked.zones,
        )
        detail = 0
        # While a hand drags, one that was made for other ends, or for less wind, will do.
        moved = asked.near is not None and self.cache.moved(
            _recipe(asked, _area(asked, reach), detail, ledger), asked.sea, (asked.start, asked.end)
        )
        while True:
            grid = moved or self._lattice(asked, reach, detail, job, ledger)
            job.check()
            job.report("search", None, f"Searching {grid.vertices:,} vertices")
            found = look(grid)
            ledger.settled += found.settled
            ledger.lap("search")
            path = found.path(grid.end)
            if path.size:
                line = timed(waters, grid.x[path], grid.y[path], asked.departure)
                if moved:
                    return line, grid
                needed = _reach_needed(asked, waters, line.seconds)
                if asked.how.area == "rectangle" or needed <= reach:
                    return line, grid
                reach = needed
            elif moved:
                moved = None
            elif detail < MOST_DETAIL and not connected(grid):
                detail += 1
            elif asked.how.area == "rectangle" or reach >= direct * _LAST_REACH:
                return None, grid
            else:
                reach = max(reach * 2, direct + 100 * METRES_PER_NM)

    def _lattice(self, asked: Question, reach: float, detail: int, job: Job, ledger: Ledger) -> Lattice:
        """Build or recall the lattice of an area."""
        job.report("lattice", None, "Building the lattice")
        how, spacing, area = asked.how, ledger.spacing_nm, _area(asked, reach)
        grid = self.cache.get(
            _recipe(asked, area, detail, ledger),
            asked.sea,
            (asked.start, asked.end),
            lambda: {
                "spacing_nm": spacing,
                "offsets": stencil.of(how.mesh, ledger.directions),
                "mesh": stencil.mesh_of(how.mesh),
                "area": area,
                "levels": approach_levels(asked, spacing, detail),
            },
        )
        ledger.lap("lattice")
        return grid


def _area(asked: Question, reach: float) -> Area:
    if asked.how.area == "rectangle":
        return Area("rectangle", asked.ends, classic.HALF_WIDTH_DEG * 60 * asked.plane_per_nm)
    # In steps, so that another departure or yacht finds the lattice of the last one.
    step = _REACH_STEP * asked.direct_m
    return Area("ellipse", asked.ends, math.ceil(reach / step) * step)


def _recipe(asked: Question, area: Area, detail: int, ledger: Ledger) -> Recipe:
    how = asked.how
    # Lattices are finer around hazards, so their identity belongs to the key.
    hazards = id(asked.zones) if how.safety.levels and asked.zones else None
    return Recipe(
        *(ledger.spacing_nm, ledger.directions, area.kind, area.reach_m, detail, how.mesh, how.safety),
        hazards,
    )


@lru_cache(maxsize=1)
def _follower() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(2, thread_name_prefix="follow")


def _followed(asked: Question, waters: Waters) -> Line | None:
    assert asked.near is not None
    return followed(waters, asked.near, asked.ends.reshape(2, 2), asked.departure)


def approach_levels(asked: Question, spacing_nm: float, detail: int) -> Levels:
    """Levels for both ends of a passage, see `levels_around`, and its safety zones."""
    ports = (asked.start, asked.end)
    return replace(
        levels_around(asked.sea, ports, spacing_nm, detail, per_nm=asked.plane_per_nm),
        safety_radius_m=asked.how.safety.radius_m,
        safety_levels=asked.how.safety.levels,
        hazards=asked.zones if asked.how.safety.levels else NO_ZONES,
    )


def _reach_needed(asked: Question, waters: Waters, seconds: float) -> float:
    """Distance [m] that no passage can sail in a time: the ellipse of that size holds all faster ones."""
    ends = (asked.start, asked.end)
    return farthest_m(waters.field, waters.speeds, ends, departure=asked.departure, seconds=seconds)


def _classic(asked: Question, job: Job, ledger: Ledger) -> tuple[Line | None, Lattice]:
    """R1's search; where R1's own lattice is cut off from a port, it is refined at the shore and ports."""
    ledger.directions, ledger.spacing_nm = 12, asked.how.spacing_nm or classic.SPACING_NM
    job.report("lattice", None, "Building the lattice")
    spacing = ledger.spacing_nm
    grid = classic.lattice(asked.sea, asked.start, asked.end, spacing_nm=spacing)
    detail = 0
    while not connected(grid) and detail <= MOST_DETAIL:
        levels = approach_levels(asked, spacing, detail)
        grid = classic.lattice(asked.sea, asked.start, asked.end, spacing_nm=spacing, levels=levels)
        detail += 1
    ledger.lap("lattice")
    job.check()
    job.report("search", None, f"Searching {grid.vertices:,} vertices")
    found = classic.search(grid, asked.wind, asked.polar, asked.how.handling, asked.departure)
    ledger.settled += found.settled
    ledger.lap("search")
    path = found.path(grid.end)
    if path.size == 0:
        return None, grid
    return Line(grid.x[path], grid.y[path], found.arrival[path]), grid


def _turning(
    waters: Waters, grid: Lattice, departure: float, job: Job, ledger: Ledger
) -> tuple[Waters, Line] | None:
    """Search again over states (vertex, course), with real boards instead of the hull; `None` for no way."""
    job.report("search", None, f"Searching {grid.target.size:,} courses at {grid.vertices:,} vertices")
    path, settled = waters.search(grid, departure)
    ledger.settled += settled
    ledger.lap("search")
    job.check()
    return (waters, timed(waters, grid.x[path], grid.y[path], departure)) if path.size else None
