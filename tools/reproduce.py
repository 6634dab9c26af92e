"""Print the tables of docs/reference-systems.md: what five publications computed, computed by us.

Run it in the checkout with ``python -m tools.reproduce``, or with some of ``r1 r2 r3 r4 zones``. Seconds are
of the machine it runs on; everything else is the same on all of them.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from functools import lru_cache, partial
from itertools import pairwise
from typing import Final

import numpy as np
from numpy.typing import NDArray

from benchmarks.world import World, world
from seacruise.errors import NoPassageError
from seacruise.geodesy import (
    angle_between_deg,
    great_circle_m,
    rhumb_course_deg,
    rhumb_distance_m,
    to_mercator,
)
from seacruise.passage import Options, Passage, PassageRequest, plan
from seacruise.resources import resource_path
from seacruise.routing import lattice as lattices
from seacruise.routing import stencil
from seacruise.routing.field import Handling, SpeedTable, WindField, speed_table, wind_field
from seacruise.routing.lattice import NO_LEVELS, Area, Lattice, Levels
from seacruise.routing.search import search
from seacruise.routing.turning import NO_PAUSES, Pauses, search_turning
from seacruise.units import METRES_PER_NM, MS_PER_KNOT, SECONDS_PER_HOUR
from seacruise.weather.practice import practice_wind
from seacruise.weather.wind import Wind, to_direction
from seacruise.yacht.fleet import find_yacht, load_fleet
from seacruise.yacht.polar import Polar
from tests.routing import sounds
from tests.routing.worlds import steady_wind
from tools import reproduce_motor

GULF: Final = (54.217, 18.069, 54.936, 19.508)
"""Area of R2 and R3: south, west, north, east [degrees]."""

DEPARTURE: Final = datetime(2016, 11, 20, 6, tzinfo=UTC)
PRACTICE_DAY: Final = datetime(2016, 11, 20, tzinfo=UTC)

RUNS: Final = 5
"""Times that something is timed; the least counts."""


def row(*cells: object) -> None:
    """Print a row of a table."""
    print(f"| {' | '.join(str(cell) for cell in cells)} |")


def head(*cells: str) -> None:
    """Print the first two rows of a table."""
    row(*cells)
    row(*("---" for _ in cells))


@lru_cache(maxsize=8)
def yacht(name: str) -> Polar:
    """Read one of the yachts that come with the program."""
    return find_yacht(name, load_fleet([resource_path("polars")]))


# ------------------------------------------------------------------------------------------- R2 and R3


@dataclass(frozen=True, slots=True, eq=False)
class Sailing:
    """What R2 and R3 publish of a passage.

    Attributes
    ----------
    penalties_h
        Part of ``hours`` that turns cost.
    settled
        Vertices, or vertices by course, that the search made final.
    """

    hours: float
    nm: float
    penalties_h: float
    changes: int
    points: int
    settled: int
    seconds: float


def least_seconds(work: Callable[[], object]) -> float:
    """Time some work, the best of a few."""
    seconds = []
    for _ in range(RUNS):
        begun = time.perf_counter()
        work()
        seconds.append(time.perf_counter() - begun)
    return min(seconds)


def sail_on(
    grid: Lattice, field: WindField, speeds: SpeedTable, *, pauses: Pauses = NO_PAUSES
) -> Sailing | None:
    """Search a grid, and sail what was found edge by edge with what its turns cost."""
    from seacruise.routing import _kernels as k

    t = DEPARTURE.timestamp()

    def find() -> tuple[NDArray[np.int64], int]:
        if any(pauses):
            return search_turning(grid, field, speeds, t, pauses)
        found = search(grid, field, speeds, t)
        return found.path(grid.end), found.settled

    path, settled = find()
    if path.size == 0:
        return None
    seconds = least_seconds(find)
    lat, lon = grid.lat[path], grid.lon[path]
    course = rhumb_course_deg(lat[:-1], lon[:-1], lat[1:], lon[1:])
    turns = angle_between_deg(course[1:], course[:-1])
    cost = np.append(0.0, pauses[2] * turns)
    arrival = t
    for n, (a, b) in enumerate(pairwise(path.tolist())):
        arrival = k.edge_arrival(arrival + cost[n], a, b, grid.points, 1e5, field.arrays, speeds.arrays)
    metres = rhumb_distance_m(lat[:-1], lon[:-1], lat[1:], lon[1:]).sum()
    return Sailing(
        (arrival - t) / SECONDS_PER_HOUR,
        float(metres) / METRES_PER_NM,
        float(cost.sum()) / SECONDS_PER_HOUR,
        int(np.count_nonzero(turns > 0.1)),
        path.size,
        settled,
        seconds,
    )


@dataclass(frozen=True, slots=True, eq=False)
class Gulf:
    """The Gulf of Gdansk, a wind over it, and a yacht in it."""

    at: World
    wind: Wind
    polar: Polar

    @property
    def field(self) -> WindField:
        """Wind in slices of a quarter of an hour."""
        return wind_field(self.wind, since=DEPARTURE.timestamp())

    @property
    def speeds(self) -> SpeedTable:
        """Polar without the hull: R2 and R3 tack by the edges of their grids."""
        return speed_table(self.polar, Handling(tacking=False))

    def wind_at(self, lat: float, lon: float) -> str:
        """Wind at a place and the departure."""
        u, v = self.wind.at(DEPARTURE.timestamp(), np.array([lat]), np.array([lon]))
        tws, twd = to_direction(u, v)
        return f"{float(tws.ravel()[0]) / MS_PER_KNOT:.1f} kn from {float(twd.ravel()[0]):.0f} degrees"

    def grid(
        self,
        ends: tuple[tuple[float, float], tuple[float, float]],
        shape: tuple[int, int],
        courses: int,
        *,
        levels: Levels = NO_LEVELS,
    ) -> Lattice:
        """Lay rows and columns over the area; nobody sails from end to end but by the grid."""
        offsets = stencil.rectangular(courses)
        grid = lattices.grid(self.at.sea, *ends, corners=GULF, shape=shape, offsets=offsets, levels=levels)
        source = grid.sources()
        kept = (source != grid.start) | (grid.target != grid.end)
        first = np.concatenate([[0], np.cumsum(np.bincount(source[kept], minlength=grid.vertices))])
        return replace(grid, first=first.astype(np.int64), target=grid.target[kept])


def gulfs() -> dict[str, Gulf]:
    """Two winds: the sample's, and one of ours in which the passages are a beat, as those published were."""
    at, polar = world(), yacht("Conrad 25RT")
    return {
        "sample": Gulf(at, at.wind, polar),
        "steady": Gulf(at, steady_wind(12.0, 265.0), polar),
    }


R2_ENDS: Final = (54.56, 19.23), (54.52, 18.76)
R2_PUBLISHED: Final = (
    ("coarse", 8, 595, 7_514, 8, 29, 15, 6.06, 0.19),
    ("coarse", 16, 1_178, 21_794, 10, 18, 45, 2.16, 0.31),
    ("coarse", 32, 1_335, 46_730, 8, 21, 15, 1.99, 0.57),
    ("fine", 8, 1_886, 30_918, 10, 55, 25, 3.82, 1.12),
    ("fine", 16, 2_653, 91_156, 3, 50, 25, 1.20, 1.45),
    ("fine", 32, 3_222, 200_236, 5, 45, 25, 1.15, 1.74),
)
"""Grid, courses, V, E, w, points, D [nm], T [h], compute [s]."""

R3_SHAPES: Final = {"coarse": (42, 84), "fine": (84, 168)}
"""Rows and columns of R3's two grids."""


def r2() -> None:
    """R2's table on R3's grids, and the grids that have R2's numbers of vertices."""
    for name, gulf in gulfs().items():
        print(f"\nOn R3's grids, {name} wind: {gulf.wind_at(*R2_ENDS[0])} at A.\n")
        head("grid", "courses", "V", "settled", "E", "w", "points", "D nm", "T h", "grid s", "search s")
        for size, courses, v, e, w, points, nm, hours, seconds in R2_PUBLISHED:
            row(f"{size}, published", courses, f"{v:,}", "", f"{e:,}", w, points, nm, hours, "", seconds)
            rows, columns = R3_SHAPES[size]
            _r2_row(f"{size}, {columns} x {rows}", gulf, R3_SHAPES[size], courses)
    gulf = gulfs()["sample"]
    print("\nGrids of n x 2n points with about R2's numbers of vertices:\n")
    head("V published", "grid", "V", "courses", "E published", "E")
    for _, courses, v, e, *_ in R2_PUBLISHED:
        shape = _fitting_shape(gulf, v)
        grid = gulf.grid(R2_ENDS, shape, courses)
        size = f"{shape[1]} x {shape[0]}"
        row(f"{v:,}", size, f"{grid.vertices:,}", courses, f"{e:,}", f"{grid.target.size:,}")


def _r2_row(title: str, gulf: Gulf, shape: tuple[int, int], courses: int) -> None:
    grid = gulf.grid(R2_ENDS, shape, courses)
    built = least_seconds(lambda: gulf.grid(R2_ENDS, shape, courses))
    ours = sail_on(grid, gulf.field, gulf.speeds)
    if ours is None:
        row(
            title,
            courses,
            f"{grid.vertices:,}",
            "",
            f"{grid.target.size:,}",
            *["none"] * 4,
            f"{built:.3f}",
            "",
        )
        return
    row(
        title,
        courses,
        f"{grid.vertices:,}",
        f"{ours.settled:,}",
        f"{grid.target.size:,}",
        ours.changes,
        ours.points,
        f"{ours.nm:.2f}",
        f"{ours.hours:.2f}",
        f"{built:.3f}",
        f"{ours.seconds:.4f}",
    )


def _fitting_shape(gulf: Gulf, vertices: int) -> tuple[int, int]:
    """Rows and columns, 1 to 2, of the grid whose points on water come nearest to a number."""
    south, west, north, east = GULF
    (x0, x1), (y0, y1) = to_mercator([south, north], [west, east])
    counts = {}
    for rows in range(10, 120):
        x, y = np.meshgrid(np.linspace(x0, x1, 2 * rows), np.linspace(y0, y1, rows))
        counts[rows] = int(np.count_nonzero(gulf.at.sea.is_water_at(x, y)))
    best = min(counts, key=lambda rows: abs(counts[rows] - vertices))
    return best, 2 * best


R3_ENDS: Final = (54.65, 19.21), (54.60, 18.60)
R3_YACHTS: Final = {"Conrad": "Conrad 25RT", "Oceania": "Bavaria 46 Cruiser"}
"""R3's yachts, and ours in their place."""

R3_PUBLISHED: Final = {
    ("Conrad", "coarse", 0): (6.22, 38.69, 0.0, 5, 27, 0.93),
    ("Conrad", "fine", 0): (6.20, 38.58, 0.0, 4, 54, 1.91),
    ("Conrad", "coarse", 1): (7.17, 41.89, 0.68, 10, 15, 1.06),
    ("Conrad", "fine", 1): (7.12, 41.64, 0.70, 16, 29, 1.91),
    ("Oceania", "coarse", 0): (6.21, 38.55, 0.0, 5, 28, 0.80),
    ("Oceania", "fine", 0): (6.19, 38.35, 0.0, 5, 58, 1.54),
    ("Oceania", "coarse", 1): (7.30, 40.24, 0.81, 11, 15, 0.96),
    ("Oceania", "fine", 1): (7.25, 39.82, 0.75, 18, 28, 1.52),
}
"""By yacht, grid and p: T [h], D [nm], penalties [h], course changes, points, compute [s]."""


def r3() -> None:
    """R3's table, and the safety zones on its coarse grid."""
    for wind, gulf in gulfs().items():
        print(f"\nR3's table, {wind} wind: {gulf.wind_at(*R3_ENDS[0])} at A.\n")
        head("yacht", "grid", "p", "T h", "D nm", "penalties h", "course changes", "points", "search s")
        for (name, size, p), published in R3_PUBLISHED.items():
            row(f"{name}, published", size, p, *published)
            sailed = replace(gulf, polar=yacht(R3_YACHTS[name]))
            _r3_row(sailed, size, p)
    gulf = gulfs()["steady"]
    print("\nSafety zones on the coarse grid, 32 courses, Conrad 25RT, steady wind:\n")
    head("lattice", "V", "E", "T h", "D nm", "grid s", "search s")
    for title, shape, levels in (
        ("84 x 42", (42, 84), NO_LEVELS),
        ("84 x 42, zones of 0.5 nm, s = 2", (42, 84), _zones(0.5, 2)),
        ("84 x 42, zones of 1 nm, s = 2", (42, 84), _zones(1.0, 2)),
        ("84 x 42, zones of 2 nm, s = 2", (42, 84), _zones(2.0, 2)),
        ("333 x 165: as fine as the zones everywhere", (165, 333), NO_LEVELS),
    ):
        _zoned_row(title, gulf, shape, levels)


def _r3_row(gulf: Gulf, size: str, p: int) -> None:
    # p * O / 10 minutes for a turn of O degrees.
    pauses = (0.0, 0.0, 6.0 * p)
    ours = sail_on(gulf.grid(R3_ENDS, R3_SHAPES[size], 32), gulf.field, gulf.speeds, pauses=pauses)
    if ours is None:
        row(gulf.polar.name, size, p, *["none"] * 5, "")
        return
    row(
        gulf.polar.name,
        size,
        p,
        f"{ours.hours:.2f}",
        f"{ours.nm:.2f}",
        f"{ours.penalties_h:.2f}",
        ours.changes,
        ours.points,
        f"{ours.seconds:.4f}",
    )


def _zoned_row(title: str, gulf: Gulf, shape: tuple[int, int], levels: Levels) -> None:
    grid = gulf.grid(R3_ENDS, shape, 32, levels=levels)
    built = least_seconds(lambda: gulf.grid(R3_ENDS, shape, 32, levels=levels))
    ours = sail_on(grid, gulf.field, gulf.speeds)
    found = ["none"] * 2 if ours is None else [f"{ours.hours:.3f}", f"{ours.nm:.2f}"]
    searched = "" if ours is None else f"{ours.seconds:.4f}"
    row(title, f"{grid.vertices:,}", f"{grid.target.size:,}", *found, f"{built:.3f}", searched)


def _zones(radius_nm: float, levels: int) -> Levels:
    return Levels(safety_radius_m=radius_nm * METRES_PER_NM, safety_levels=levels)


def zones() -> None:
    """Safety zones on the triangular lattice: narrow water, and a whole passage."""
    sea = world().sea
    head("water", "lattice", "V", "E", "shortest nm", "built s")
    fine = sounds.COARSE_NM / 2**sounds.DEEPEST
    for sound in sounds.SOUNDS:
        through = partial(sounds.lattice_through, sea, sound)
        safe = _zones(0.5, sounds.DEEPEST)
        _zone_row(sound, "5 nm", through)
        _zone_row(sound, "5 nm, zones of 0.5 nm, s = 5", partial(through, levels=safe))
        _zone_row(sound, "0.16 nm everywhere", partial(through, spacing_nm=fine))
    for radius in (0.5, 1.0, 2.0):
        safe = _zones(radius, sounds.DEEPEST)
        _zone_row("Gdynia - Stockholm", f"5 nm, zones of {radius} nm, s = 5", partial(_passage, safe))
    everywhere = partial(_passage, NO_LEVELS, spacing_nm=4 * fine)
    _zone_row("Gdynia - Stockholm", "0.63 nm everywhere", everywhere)


def _passage(levels: Levels, spacing_nm: float = sounds.COARSE_NM) -> Lattice:
    """Lattice with 24 courses of the passage that everybody measures."""
    at = world()
    ends = at.water_at("Gdynia"), at.water_at("Stockholm")
    x, y = to_mercator(*zip(*ends, strict=True))
    area = Area(
        "ellipse", np.array([[x[0], y[0], x[1], y[1]]]), 1.3 * float(great_circle_m(*ends[0], *ends[1]))
    )
    offsets = stencil.triangular(24)
    return lattices.build(at.sea, *ends, spacing_nm=spacing_nm, offsets=offsets, area=area, levels=levels)


def _zone_row(water: str, title: str, build: Callable[[], Lattice]) -> None:
    built = least_seconds(build)
    grid = build()
    nm = sounds.shortest_nm(grid)
    row(
        water,
        title,
        f"{grid.vertices:,}",
        f"{grid.target.size:,}",
        f"{nm:.2f}" if np.isfinite(nm) else "no way",
        f"{built:.3f}",
    )


# -------------------------------------------------------------------------------------------------- R1


R1_PUBLISHED: Final = {
    0: (41.82, 33.47, 354.34, 301.80),
    48: (41.70, None, 309.73, None),
    72: (41.83, 36.86, 307.67, 303.58),
    120: (42.40, 43.24, 315.18, 313.03),
}
"""By departure [h from now]: Gdynia - Stockholm and back [h], the same [nm]."""

R1_YACHTS: Final = {
    "Edel 660": (49.27, None),
    "Delphia 47": (35.17, 52.84),
    "Bavaria 46 Cruiser": (34.00, None),
    "Bavaria 40 Cruiser": (33.26, None),
    "Cookson 50": (22.67, None),
}
"""Klaipeda - Swinoujscie and back [h]."""


def planned(
    wind: Wind, polar: Polar, ports: tuple[str, str], after_h: float, options: Options
) -> Passage | str:
    """Plan a passage, or give the reason why there is none."""
    at = world()
    start, end = (at.port(name) for name in ports)
    departure = wind.forecast.valid_from + timedelta(hours=6 + after_h)
    try:
        return plan(PassageRequest(start, end, polar, wind, departure, options=options), settings=at.settings)
    except NoPassageError as error:
        return f"none: {error.reason}"


def told(passage: Passage | str, *, nm: bool = True) -> str:
    """Hours and miles of a passage, with the share sailed in wind held beyond the forecast."""
    if isinstance(passage, str):
        return passage
    held = f" ({passage.beyond_forecast_h:.0f} h held)" if passage.beyond_forecast_h > 0.5 else ""
    return f"{passage.duration_h:.2f} h{f', {passage.distance_nm:.1f} nm' if nm else ''}{held}"


R1_WINDS: Final[dict[str, tuple[Callable[[], Wind], tuple[int, ...]]]] = {
    "sample": (lambda: world().wind, (0, 12, 24, 36)),
    "practice": (lambda: practice_wind(PRACTICE_DAY), (0, 48, 72, 120)),
}
"""By name: the wind, and departures within it [h after 06:00 UTC of its first day]."""


def r1() -> None:
    """R1's tables 7.1 and 7.2, with R1's rules and with ours."""
    presets = {"classic": Options(preset="classic"), "precise": Options()}
    there, back = ("Gdynia", "Stockholm"), ("Stockholm", "Gdynia")
    for name, (make, departures) in R1_WINDS.items():
        print(f"\nTable 7.1 in the {name} wind, Bavaria 46 Cruiser:\n")
        head("departure", *(f"{way} {p}" for way in ("G-S", "S-G") for p in presets))
        for after in departures:
            cells = [
                told(planned(make(), yacht("Bavaria 46 Cruiser"), ports, after, options))
                for ports in (there, back)
                for options in presets.values()
            ]
            row(f"+{after} h" if after else "first", *cells)
    there, back = ("Klaipeda", "Swinoujscie"), ("Swinoujscie", "Klaipeda")
    for name, (make, _) in R1_WINDS.items():
        print(f"\nTable 7.2 in the {name} wind, first departure:\n")
        head("yacht", *(f"{way} {p}" for way in ("K-S", "S-K") for p in ("published", *presets)))
        for boat, published in R1_YACHTS.items():
            cells = []
            for ports, hours in zip((there, back), published, strict=True):
                cells.append(f"{hours:.2f} h" if hours else "none")
                found = (planned(make(), yacht(boat), ports, 0, options) for options in presets.values())
                cells.extend(told(passage, nm=False) for passage in found)
            row(boat, *cells)


SECTIONS: Final[dict[str, Callable[[], None]]] = {
    "r1": r1,
    "r2": r2,
    "r3": r3,
    "r4": reproduce_motor.main,
    "zones": zones,
}


def main(wanted: Sequence[str]) -> None:
    """Print the sections that are wanted, or all."""
    for name in wanted or SECTIONS:
        print(f"\n## {name}\n")
        SECTIONS[name]()


if __name__ == "__main__":
    main(sys.argv[1:])
