"""Find the fastest passage: the chain from ports to waypoints, for each preset.

``area -> lattice -> search -> refine`` for ``precise``; R1's rectangle and rules for ``classic``. When
there is no passage, this is where the reason is found.
"""

from __future__ import annotations

import time
from collections import OrderedDict
from dataclasses import dataclass, field, replace
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import NoPassageError
from seacruise.geodesy import great_circle_m, scale, to_mercator
from seacruise.progress import Job
from seacruise.routing import classic, stencil
from seacruise.routing import lattice as lattices
from seacruise.routing.field import Handling, SpeedTable, WindField, speed_table, wind_field
from seacruise.routing.lattice import Area, Lattice, Levels
from seacruise.routing.refine import Line, Waters, refine, simplified, timed
from seacruise.routing.search import connected, search
from seacruise.sea import Sea
from seacruise.units import METRES_PER_NM
from seacruise.weather.wind import Wind
from seacruise.yacht.polar import Polar

Array = NDArray[np.float64]

COURSES: Final = 36
"""Courses of the first search: enough that it chooses the right side of an island."""

PORT_NM: Final = 25.0
"""Within this distance of its ends a passage may need the finest lattice [nm]: archipelagos."""

_FIRST_REACH: Final = 1.25
_LAST_REACH: Final = 4.0
_KEPT: Final = 8


@dataclass(frozen=True, slots=True)
class How:
    """How to search; see `seacruise.passage.Options`."""

    preset: str
    directions: int | None
    spacing_nm: float | None
    area: str | None
    refine: bool
    handling: Handling


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


class LatticeCache:
    """The lattices used last, by what defines them: the same ports again need no new one."""

    def __init__(self) -> None:
        self._kept: OrderedDict[Any, Lattice] = OrderedDict()

    def get(self, sea: Sea, key: tuple[Any, ...], **recipe: Any) -> Lattice:
        """The lattice of a recipe (see `lattice.build`), which ``key`` must tell from all others."""
        if key not in self._kept:
            self._kept[key] = lattices.build(sea, **recipe)
            while len(self._kept) > _KEPT:
                self._kept.popitem(last=False)
        self._kept.move_to_end(key)
        return self._kept[key]


@dataclass(frozen=True, slots=True, eq=False)
class Fastest:
    """The line found, what it was found on, and what the bounds need."""

    line: Line
    lattice: Lattice
    speeds: SpeedTable


def fastest(
    sea: Sea,
    wind: Wind,
    polar: Polar,
    how: How,
    start: tuple[float, float],
    end: tuple[float, float],
    departure: float,
    *,
    job: Job,
    ledger: Ledger,
    cache: LatticeCache,
) -> Fastest:
    """Find the fastest passage between two positions on the water [degrees].

    Raises
    ------
    NoPassageError
        With the reason: ``no-water-path``, ``becalmed``, ``wind-limit`` or ``dead-angle``.
    """
    waters = Waters(sea, wind_field(wind, since=departure), speed_table(polar, how.handling))
    ledger.lap("wind")
    if how.preset == "classic":
        line, grid = _classic(
            waters, wind, polar, how, start, end, departure, job=job, ledger=ledger, cache=cache
        )
    else:
        line, grid = _precise(waters, how, start, end, departure, job=job, ledger=ledger, cache=cache)
    if line is None:
        raise _why_not(waters, polar, how, grid, departure)
    job.check()
    if how.refine:
        job.report("refine", None, "Refining the passage")
        line, settled = refine(waters, line, job)
        ledger.settled += settled
    elif how.preset != "classic":
        line = simplified(waters, line, share=1e-6)
    ledger.lap("refine")
    ledger.vertices, ledger.edges = grid.vertices, int(grid.target.size)
    return Fastest(line, grid, waters.speeds)


def _precise(
    waters: Waters,
    how: How,
    start: tuple[float, float],
    end: tuple[float, float],
    departure: float,
    *,
    job: Job,
    ledger: Ledger,
    cache: LatticeCache,
) -> tuple[Line | None, Lattice]:
    """Search the whole area; widen it until nothing outside can be faster."""
    direct = float(great_circle_m(*start, *end))
    ledger.directions = how.directions or COURSES
    ledger.spacing_nm = how.spacing_nm or min(5.0, max(0.5, direct / METRES_PER_NM / 40))
    reach = max(direct * _FIRST_REACH, direct + 20 * METRES_PER_NM)
    while True:
        grid = _lattice(waters, how, start, end, reach, job=job, ledger=ledger, cache=cache)
        job.check()
        job.report("search", None, f"Searching {grid.vertices:,} vertices")
        found = search(grid, waters.field, waters.speeds, departure)
        ledger.settled += found.settled
        ledger.lap("search")
        path = found.path(grid.end)
        if path.size:
            line = timed(waters, grid.x[path], grid.y[path], departure)
            needed = min(line.seconds * waters.speeds.fastest(waters.field.strongest), direct * _LAST_REACH)
            if how.area == "rectangle" or needed <= reach * 1.001 or reach >= direct * 1.6:
                return line, grid
            reach = min(needed, max(direct * 1.6, reach))
            continue
        if how.area == "rectangle" or reach >= direct * _LAST_REACH:
            return None, grid
        reach = min(reach * 1.8, direct * _LAST_REACH + 100 * METRES_PER_NM)


def _lattice(
    waters: Waters,
    how: How,
    start: tuple[float, float],
    end: tuple[float, float],
    reach: float,
    *,
    job: Job,
    ledger: Ledger,
    cache: LatticeCache,
) -> Lattice:
    job.report("lattice", None, "Building the lattice")
    line = np.stack(to_mercator([start[0], end[0]], [start[1], end[1]]), axis=1)
    spacing = ledger.spacing_nm
    flat = float(scale((start[0] + end[0]) / 2))
    if how.area == "rectangle":
        area = Area("rectangle", line, classic.HALF_WIDTH_DEG * 60 * METRES_PER_NM / flat)
    else:
        reach = float(np.ceil(reach / METRES_PER_NM)) * METRES_PER_NM
        area = Area("ellipse", line, reach)
    everywhere = max(0, round(np.log2(spacing / 0.6)))
    at_ports = max(0, round(np.log2(spacing / 0.15)) - everywhere)
    levels = Levels(everywhere, at_ports, PORT_NM * METRES_PER_NM / flat)
    key = (id(waters.sea.water), start, end, spacing, ledger.directions, area.kind, area.reach_m)
    grid = cache.get(
        waters.sea,
        key,
        start=start,
        end=end,
        spacing_nm=spacing,
        offsets=stencil.triangular(ledger.directions),
        area=area,
        levels=levels,
    )
    ledger.lap("lattice")
    return grid


def _classic(
    waters: Waters,
    wind: Wind,
    polar: Polar,
    how: How,
    start: tuple[float, float],
    end: tuple[float, float],
    departure: float,
    *,
    job: Job,
    ledger: Ledger,
    cache: LatticeCache,
) -> tuple[Line | None, Lattice]:
    del cache
    job.report("lattice", None, "Building the lattice")
    ledger.directions, ledger.spacing_nm = 12, how.spacing_nm or classic.SPACING_NM
    line = np.stack(to_mercator([start[0], end[0]], [start[1], end[1]]), axis=1)
    grid = classic.lattice(waters.sea, start, end, spacing_nm=ledger.spacing_nm, line=line)
    ledger.lap("lattice")
    job.report("search", None, f"Searching {grid.vertices:,} vertices")
    found = classic.search(grid, wind, polar, how.handling, departure)
    ledger.settled += found.settled
    ledger.lap("search")
    path = found.path(grid.end)
    if path.size == 0:
        return None, grid
    return Line(grid.x[path], grid.y[path], found.arrival[path]), grid


def _why_not(waters: Waters, polar: Polar, how: How, grid: Lattice, departure: float) -> NoPassageError:
    """Find out why nothing was found: take the obstacles away one by one."""
    if not connected(grid):
        return NoPassageError(
            "There is no way by water between the two ports in the area searched; choose other ports, a finer "
            "--spacing, or check that both lie on the same sea.",
            reason="no-water-path",
        )

    def passable(handling: Handling) -> bool:
        found = search(grid, waters.field, speed_table(polar, handling), departure)
        return bool(np.isfinite(found.arrival[grid.end]))

    if how.handling.max_wind is not None and passable(replace(how.handling, max_wind=None, tacking=True)):
        return NoPassageError(
            f"Every way leads through more wind than the {how.handling.max_wind / (1852 / 3600):.0f} kn you allow; "
            "leave at another time or raise the limit.",
            reason="wind-limit",
        )
    if not how.handling.tacking and passable(replace(how.handling, tacking=True)):
        return NoPassageError(
            "Every way leads at some time through the yacht's dead angle, and tacking is switched off; allow "
            "tacking (the precise preset does) or leave at another time.",
            reason="dead-angle",
        )
    return NoPassageError(
        "The yacht is becalmed: with this wind she never arrives. Leave at another time, choose another "
        "forecast, or allow the engine (--motor-below).",
        reason="becalmed",
    )


def field_of(wind: Wind) -> WindField:
    """The whole forecast as the kernels want it."""
    return wind_field(wind)
