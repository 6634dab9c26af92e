"""From a lattice path to a passage a person would steer: corridor, more courses, waypoints relaxed.

The first search looks at the whole area with few courses. A lattice's error is one of direction, not of
resolution, so the next one has many courses and finer spacing, but only in a corridor around what was
found. Then the waypoints leave the lattice: each is moved, dropped or put in until nothing is gained.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import from_mercator, great_circle_m, scale
from seacruise.progress import Job
from seacruise.routing import lattice as lattices
from seacruise.routing import stencil
from seacruise.routing.field import SpeedTable, WindField
from seacruise.routing.lattice import Area, Lattice, Levels
from seacruise.routing.search import search
from seacruise.routing.turning import NO_PAUSES, Pauses, search_turning
from seacruise.sea import Sea
from seacruise.sea.zones import NO_ZONES, Zones
from seacruise.units import METRES_PER_NM

Array = NDArray[np.float64]

PIECE_M: Final = METRES_PER_NM
"""Longest part of a leg that is sailed in the wind of its middle while relaxing [m]."""

CORRIDOR_SPACING_NM: Final = 1.5
CORRIDOR_COURSES: Final = 72
SHORE_COURSES: Final = 24
CORRIDOR_SIDES: Final = 6.0
CORRIDOR_LEVELS: Final = 4
"""The second lattice: spacing [nm], courses, those of its finest levels, half-width in spacings, levels."""

STRAIGHT: Final = 48.0
"""The middle of the corridor may be straightened by this part of its half-width: each of its lines is looked
at on every level, and a first search has a short one from island to island."""


@dataclass(frozen=True, slots=True)
class Pull:
    """How thoroughly a line is pulled straight.

    Attributes
    ----------
    steps_nm, legs_nm
        Trial moves of the waypoints, and the longest legs while they are made [nm].
    rounds
        Most sweeps over the waypoints for each of them.
    """

    steps_nm: tuple[float, ...]
    legs_nm: tuple[float, ...]
    rounds: int


THOROUGHLY: Final = Pull(
    (4.0, 2.0, 1.0, 0.5, 0.25, 0.1, 0.05), (16.0, 12.0, 10.0, 10.0, 10.0, 10.0, 10.0), rounds=10
)
BRISKLY: Final = Pull((4.0, 2.0, 1.0, 0.5, 0.2, 0.05), (16.0, 12.0, 10.0, 10.0, 10.0, 10.0), rounds=5)
"""While a hand drags."""

QUICKLY: Final = Pull((2.0, 1.0, 0.5, 0.2, 0.1, 0.05), (10.0,) * 6, rounds=8)
"""For a line that was pulled straight in nearly the same wind: it has no long way to go."""

SIMPLIFY: Final = 0.00025
"""Share of the duration that may be given for fewer waypoints: steering 50 courses helps nobody."""


@dataclass(frozen=True, slots=True, eq=False)
class Line:
    """A passage as a line of waypoints of the Mercator plane [m] and the arrival at each [s since 1970]."""

    x: Array
    y: Array
    times: Array

    @property
    def seconds(self) -> float:
        """How long it takes [s]."""
        return float(self.times[-1] - self.times[0])


@dataclass(frozen=True, slots=True, eq=False)
class Waters:
    """The sea, the wind and the yacht of one passage, as the kernels want them."""

    sea: Sea
    field: WindField
    speeds: SpeedTable
    zones: Zones = NO_ZONES
    pauses: Pauses = NO_PAUSES

    @property
    def frame(self) -> tuple[float, float, float]:
        """Corner and cell of the sea's raster [m of the plane]."""
        return self.sea.water.x0, self.sea.water.y0, self.sea.water.cell

    @property
    def obstacles(self) -> tuple[Any, Any]:
        """Land and zones, as the kernels that move waypoints want them."""
        return self.sea.water.arrays, self.zones.arrays

    def search(self, lattice: Lattice, departure: float, **how: Any) -> tuple[NDArray[np.int64], int]:
        """Search a lattice, turns paid for where they cost something.

        Returns
        -------
        path, settled
            Vertices from start to end, none where there is no way, and a count.
        """
        if any(self.pauses):
            return search_turning(
                lattice, self.field, self.speeds, departure, self.pauses, zones=self.zones, **how
            )
        found = search(lattice, self.field, self.speeds, departure, zones=self.zones, **how)
        return found.path(lattice.end), found.settled

    def forbid(self, line: Line) -> bool:
        """Tell whether a line enters a zone while it is valid."""
        legs = np.stack([line.x[:-1], line.y[:-1], line.x[1:], line.y[1:]], axis=1)
        return bool(self.zones.close(legs, line.times[:-1], line.times[1:]).any())


def timed(waters: Waters, x: Array, y: Array, departure: float) -> Line:
    """Sail a line with the search's own integrator."""
    from seacruise.routing import _relax

    times = np.empty(x.size)
    times[0] = departure
    _relax.retime(
        x,
        y,
        _relax.latitudes(y),
        times,
        x.size,
        1,
        PIECE_M,
        waters.field.arrays,
        waters.speeds.arrays,
        waters.pauses,
    )
    return Line(x, y, times)


def relaxed(waters: Waters, line: Line, *, split: bool = True, pull: Pull = THOROUGHLY) -> Line:
    """Pull a line straight in time; never slower than before.

    With ``split`` long legs get new waypoints, so that they can bend; else the line keeps its own.
    """
    from seacruise.routing import _relax

    per_nm = METRES_PER_NM / float(scale(from_mercator(0.0, line.y.mean())[0]))
    x, y = _relax.relax(
        line.x,
        line.y,
        float(line.times[0]),
        np.array(pull.steps_nm) * per_nm,
        pull.rounds,
        np.array(pull.legs_nm) * per_nm if split else np.full(len(pull.steps_nm), np.inf),
        0.5,
        PIECE_M,
        waters.obstacles,
        waters.frame,
        waters.field.arrays,
        waters.speeds.arrays,
        waters.pauses,
    )
    after = timed(waters, x, y, float(line.times[0]))
    # A leg sailed earlier than it was judged may meet a zone that is not open yet.
    return after if after.seconds <= line.seconds and not waters.forbid(after) else line


def simplified(waters: Waters, line: Line, *, share: float = SIMPLIFY) -> Line:
    """Leave out the waypoints that matter least, as long as all of them together cost little time."""
    from seacruise.routing import _relax

    x, y = _relax.thin(
        line.x,
        line.y,
        float(line.times[0]),
        share * line.seconds,
        PIECE_M,
        waters.obstacles,
        waters.frame,
        waters.field.arrays,
        waters.speeds.arrays,
        waters.pauses,
    )
    after = timed(waters, x, y, float(line.times[0]))
    return line if waters.forbid(after) else after


def in_corridor(
    waters: Waters, line: Line, *, spacing_nm: float, courses: int, width_nm: float, levels: Levels
) -> tuple[Line | None, Lattice, int]:
    """Search again on a finer lattice with more courses, within a distance of a line.

    Returns
    -------
    line, lattice, settled
        ``None`` for the line when the corridor turned out to be closed.
    """
    import shapely

    lat, lon = from_mercator(line.x, line.y)
    per_nm = METRES_PER_NM / float(scale(lat.mean()))
    x, y = shapely.get_coordinates(
        shapely.simplify(shapely.linestrings(line.x, line.y), width_nm * per_nm / STRAIGHT)
    ).T
    along = np.stack([x[:-1], y[:-1], x[1:], y[1:]], axis=1)
    area = Area("corridor", along, width_nm * per_nm)
    start, end = ((float(lat[k]), float(lon[k])) for k in (0, -1))
    lattice = lattices.build(
        waters.sea,
        start,
        end,
        spacing_nm=spacing_nm,
        offsets=stencil.triangular(courses),
        area=area,
        levels=levels,
        shore_offsets=stencil.triangular(min(courses, SHORE_COURSES)),
        lazily=not any(waters.pauses),
    )
    path, settled = waters.search(lattice, float(line.times[0]))
    if path.size == 0:
        return None, lattice, settled
    return timed(waters, lattice.x[path], lattice.y[path], float(line.times[0])), lattice, settled


def followed(waters: Waters, near: Array, ends: Array, departure: float) -> Line | None:
    """Pull a line that was good for nearly the same question straight for this one.

    Parameters
    ----------
    near
        ``(m, 2)`` the line's points in the Mercator plane [m].
    ends
        ``(2, 2)`` where it begins and ends now.

    Returns
    -------
    Line or None
        ``None`` where it cannot be sailed between these ends at this time.
    """
    inner = near[1:-1]
    # Where the way to the next waypoint is blocked, the way there by the old end may not be.
    for points in (np.vstack([ends[:1], inner, ends[1:]]), np.vstack([ends[:1], near, ends[1:]])):
        if waters.sea.clear(np.hstack([points[:-1], points[1:]])).all():
            line = timed(waters, points[:, 0].copy(), points[:, 1].copy(), departure)
            if np.isfinite(line.seconds) and not waters.forbid(line):
                return relaxed(waters, line, pull=QUICKLY)
    return None


class Refined(NamedTuple):
    """What refining gave.

    Attributes
    ----------
    line
        With as few waypoints as possible.
    near
        The same with all of them: who follows it next does not inherit what leaving them out costs.
    settled
        Vertices settled on the way.
    """

    line: Line
    near: Line
    settled: int


def refine(
    waters: Waters, first: Line, job: Job, *, corridor: bool = True, known: Line | None = None
) -> Refined:
    """Refine what the first search found.

    Never slower than ``first``, but for the share of `SIMPLIFY`.

    Parameters
    ----------
    corridor
        Search again in the corridor; else the waypoints of ``first`` are relaxed as they are.
    known
        A line that `followed` gave: the faster of both is taken.
    """
    if not corridor:
        best = relaxed(waters, first, pull=THOROUGHLY if known is None else BRISKLY)
        if known is not None and known.seconds < best.seconds:
            best = known
        return Refined(simplified(waters, best), best, 0)
    lat, lon = from_mercator(first.x[[0, -1]], first.y[[0, -1]])
    distance_nm = float(great_circle_m(lat[0], lon[0], lat[1], lon[1])) / METRES_PER_NM
    spacing = min(CORRIDOR_SPACING_NM, max(0.25, distance_nm / 60))
    line, _, settled = in_corridor(
        waters,
        first,
        spacing_nm=spacing,
        courses=CORRIDOR_COURSES,
        width_nm=CORRIDOR_SIDES * spacing,
        levels=Levels(CORRIDOR_LEVELS),
    )
    job.check()
    best = relaxed(waters, first if line is None or line.seconds > first.seconds else line)
    job.check()
    # With fewer waypoints the ones that are left have better places than before.
    return Refined(relaxed(waters, simplified(waters, best), split=False), best, settled)
