"""How far she gets: one search forwards to every vertex, one backwards from the end.

Forwards, the ordinary search settles the earliest arrival everywhere. Backwards, `latest_departures` settles
the latest departure from everywhere that still arrives at the end by a given time; it sails each edge
backwards through the same pieces and slices of time, so that both agree to the millisecond.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import from_mercator, scale, to_mercator
from seacruise.progress import Job
from seacruise.routing import lattice as lattices
from seacruise.routing import stencil
from seacruise.routing.field import SpeedTable, WindField
from seacruise.routing.find import COURSES, SPACING_NM, Position, farthest_m, levels_around
from seacruise.routing.lattice import Area, Lattice
from seacruise.routing.search import PIECE_M, Found, search
from seacruise.sea import Sea
from seacruise.units import METRES_PER_NM, SECONDS_PER_HOUR

Array = NDArray[np.float64]

FINER: Final = 2
"""How often the lattice is halved before lines of equal time are drawn, so that they follow the shore."""


@dataclass(frozen=True, slots=True, eq=False)
class Latest:
    """What a reverse search found.

    Attributes
    ----------
    departure
        ``(n,)`` latest departure from each vertex, seconds since 1970; -inf where none is late enough.
    after
        ``(n,)`` the vertex after it, -1 for the end and where there is none.
    settled
        Vertices whose departure became final.
    """

    departure: Array
    after: NDArray[np.int32]
    settled: int

    def path(self, start: int) -> NDArray[np.int64]:
        """Vertices from ``start`` to the end; empty when it cannot be reached in time."""
        if not np.isfinite(self.departure[start]):
            return np.empty(0, dtype=np.int64)
        vertices = [start]
        while self.after[vertices[-1]] >= 0:
            vertices.append(int(self.after[vertices[-1]]))
        return np.array(vertices, dtype=np.int64)


def latest_departures(
    lattice: Lattice,
    field: WindField,
    speeds: SpeedTable,
    deadline: float,
    *,
    earliest: float = -np.inf,
) -> Latest:
    """Latest departure from each vertex that arrives at the lattice's end by a deadline.

    Leaving a vertex then, the forward search arrives in time; leaving a second later it does not. (Where
    Handling.max_wind closes edges for a time, leaving earlier may be no way at all: the departure told is
    then one that works along its own path, not the very latest.)

    Parameters
    ----------
    deadline, earliest
        Seconds since 1970; departures before ``earliest`` are not looked for.
    """
    from seacruise.routing import _backwards, _kernels

    sources = lattice.sources()
    first, order = _kernels.sort_rows(lattice.target, lattice.vertices)
    return Latest(
        *_backwards.search_back(
            lattice.end,
            deadline,
            earliest,
            lattice.points,
            (first, sources[order]),
            PIECE_M,
            field.arrays,
            speeds.arrays,
        )
    )


@dataclass(frozen=True, slots=True, eq=False)
class Outing:
    """What is asked: how far she gets from a position, and back, in a time.

    Attributes
    ----------
    start
        Position on the water [degrees].
    departure, seconds, stay
        Seconds since 1970, seconds that there are in all, and seconds spent in a port.
    directions, spacing_nm
        Of the lattice; ``None`` for what suits the distance.
    """

    sea: Sea
    field: WindField
    speeds: SpeedTable
    start: Position
    departure: float
    seconds: float
    stay: float = 0.0
    directions: int | None = None
    spacing_nm: float | None = None

    @property
    def deadline(self) -> float:
        """When the time is over, seconds since 1970."""
        return self.departure + self.seconds

    @property
    def radius_m(self) -> float:
        """Distance from the start [m] beyond which she cannot get."""
        return farthest_m(
            self.field, self.speeds, (self.start,), departure=self.departure, seconds=self.seconds
        )


@dataclass(frozen=True, slots=True, eq=False)
class Explored:
    """The answer to an `Outing`: of each port, and of each vertex of the lattice.

    Attributes
    ----------
    out
        Earliest arrival everywhere, and the ways there.
    arrival, home, leave_by
        ``(m,)`` of each port, seconds since 1970: earliest arrival; when she is back, having stayed; and
        the latest moment to leave it and still be back when the time is over. Not finite where there is none.
    sailed_m
        ``(m,)`` length of the way out [m].
    """

    lattice: Lattice
    out: Found
    arrival: Array
    home: Array
    leave_by: Array
    sailed_m: Array


def outing_lattice(asked: Outing, ports: Sequence[Position]) -> Lattice:
    """Build a lattice over all that can be reached; start and ports are vertices, and so is the way back.

    The start is there twice: ways begin at ``start`` and lead back to ``end``, at the same place.
    """
    # Becalmed she still needs a lattice; and beyond the sea that was read there is no water.
    reach_nm = min(max(asked.radius_m / METRES_PER_NM, 1.0), _widest_nm(asked))
    spacing = asked.spacing_nm or min(SPACING_NM, max(0.5, reach_nm / 40))
    x, y = (float(c) for c in to_mercator(*asked.start))
    per_nm = METRES_PER_NM / float(scale(asked.start[0]))
    levels = levels_around(asked.sea, (asked.start, *ports), spacing, 0, per_nm=per_nm)
    # Ways of neighbours overlap: as one they share their vertices.
    together = np.unique(np.concatenate(levels.ways), axis=0)
    return lattices.build(
        asked.sea,
        asked.start,
        asked.start,
        spacing_nm=spacing,
        offsets=stencil.triangular(asked.directions or COURSES),
        area=Area("ellipse", np.array([[x, y, x, y]]), 2 * math.ceil(reach_nm) * METRES_PER_NM),
        levels=replace(levels, ways=(together,)),
        joined=tuple(ports),
    )


def _widest_nm(asked: Outing) -> float:
    """Distance [nm] from the start to the farthest corner of the sea that was read."""
    water = asked.sea.water
    rows, columns = water.cells.shape
    x, y = (float(c) for c in to_mercator(*asked.start))
    across = max(abs(water.x0 - x), abs(water.x0 + columns * water.cell - x))
    up = max(abs(water.y0 - y), abs(water.y0 + rows * water.cell - y))
    # True lengths are never longer than those of the plane.
    return math.hypot(across, up) / METRES_PER_NM


def explore(asked: Outing, ports: Sequence[Position], job: Job) -> Explored:
    """Search out and back.

    The way out is one search for all ports. The way back is one search a port, because each is left at its
    own time; they are goal-directed and take milliseconds. The latest moment to leave is the same question
    for all ports - back at the start when the time is over - and so one search backwards answers it.
    """
    job.report("lattice", None, "Building the lattice")
    grid = outing_lattice(asked, ports)
    job.check()
    job.report("search", None, f"Searching {grid.vertices:,} vertices")
    field, speeds = asked.field, asked.speeds
    out = search(grid, field, speeds, asked.departure, to_end=False, latest=asked.deadline)
    job.check()
    back = latest_departures(grid, field, speeds, asked.deadline, earliest=asked.departure)
    vertices = np.array(grid.joined, dtype=np.int64)
    arrival = out.arrival[vertices]
    arrival[arrival > asked.deadline] = np.inf
    home = np.full(vertices.size, np.inf)
    reached = np.flatnonzero(np.isfinite(arrival))
    for count, k in enumerate(reached.tolist()):
        job.check()
        job.report("search", count / reached.size, "Searching the ways back")
        homewards = replace(grid, start=int(vertices[k]))
        found = search(homewards, field, speeds, float(arrival[k]) + asked.stay)
        home[k] = found.arrival[grid.end]
    sailed = np.array([_length_m(grid, out.path(v)) for v in vertices.tolist()])
    return Explored(grid, out, arrival, home, back.departure[vertices], sailed)


def _length_m(grid: Lattice, path: NDArray[np.int64]) -> float:
    """True length of a way along edges [m]; NaN without one."""
    if path.size == 0:
        return math.nan
    span = np.hypot(np.diff(grid.x[path]), np.diff(grid.y[path]))
    return float((span * (grid.scale[path[:-1]] + grid.scale[path[1:]]) / 2).sum())


# ------------------------------------------------------------------------------- lines of equal time


@dataclass(frozen=True, slots=True, eq=False)
class Isochrone:
    """The water that is reached within a time.

    Attributes
    ----------
    hours
        Since departure.
    polygons
        One entry a polygon: its rings, the outer one first and then its holes, each ``(n, 2)`` of lat and
        lon [degrees], closed.
    """

    hours: float
    polygons: tuple[tuple[Array, ...], ...]


def isochrones(
    lattice: Lattice, sea: Sea, arrival: Array, *, departure: float, hours: Sequence[float]
) -> list[Isochrone]:
    """Draw the water that is reached within each of some times.

    Parameters
    ----------
    arrival
        ``(n,)`` earliest arrival at each vertex, seconds since 1970.
    departure
        Seconds since 1970.
    """
    import contourpy

    x, y, after = _arrival_grid(lattice, sea, arrival - departure)
    if min(after.shape) < 2:
        return [Isochrone(h, ()) for h in hours]
    never = 1e12
    filled = np.where(np.isfinite(after), after, never)
    contours = contourpy.contour_generator(
        x,
        y,
        np.ma.masked_array(filled, np.isnan(after)),
        corner_mask=True,
        fill_type=contourpy.FillType.OuterOffset,
    )
    found = []
    for h in hours:
        points, offsets = contours.filled(-1.0, h * SECONDS_PER_HOUR)
        polygons = []
        for some, at in zip(points, offsets, strict=True):
            lat, lon = from_mercator(some[:, 0], some[:, 1])
            rings = np.stack([lat, lon], axis=1)
            polygons.append(tuple(rings[a:b] for a, b in zip(at[:-1], at[1:], strict=True)))
        found.append(Isochrone(h, tuple(polygons)))
    return found


def _arrival_grid(lattice: Lattice, sea: Sea, after: Array) -> tuple[Array, Array, Array]:
    """Seconds after departure on an even axial grid, finer than the lattice at sea, ``nan`` on land.

    Vertices of the level everywhere refined and above lie on the axial grid of the start; what lies
    between two of them is their mean, and water that has no such pair takes the mean of its neighbours.
    """
    x0, y0 = lattice.x[lattice.start], lattice.y[lattice.start]
    j = (lattice.y - y0) / (lattice.spacing_m * stencil.ROW_HEIGHT)
    i = (lattice.x - x0) / lattice.spacing_m - j / 2.0
    reached = np.flatnonzero(np.isfinite(after))
    pad = 2.0 / 2**FINER
    i0, j0 = math.floor(i[reached].min() - pad) - 1, math.floor(j[reached].min() - pad) - 1
    shape = (math.ceil(j[reached].max()) - j0 + 3, math.ceil(i[reached].max()) - i0 + 3)
    grid = np.full(shape, np.nan)
    for level in range(FINER + 1):
        if level:
            grid = _halved(grid)
        at_j, at_i = (j - j0) * 2**level, (i - i0) * 2**level
        column, row = np.rint(at_i).astype(np.int64), np.rint(at_j).astype(np.int64)
        on = (np.abs(at_i - column) < 1e-6) & (np.abs(at_j - row) < 1e-6)
        on &= (row >= 0) & (row < grid.shape[0]) & (column >= 0) & (column < grid.shape[1])
        grid[row[on], column[on]] = after[on]
        side = lattice.spacing_m / 2**level
        rows, columns = np.mgrid[: grid.shape[0], : grid.shape[1]]
        x = x0 + side * (columns + i0 * 2**level + (rows + j0 * 2**level) / 2.0)
        y = y0 + side * stencil.ROW_HEIGHT * (rows + j0 * 2**level)
    # The start's own place is a vertex of the lattice too, and only the start itself is there at once.
    grid[-j0 * 2**FINER, -i0 * 2**FINER] = 0.0
    dry = ~sea.is_water_at(x, y)
    grid = _towards_shore(grid)
    grid[dry] = np.nan
    return x, y, grid


def _halved(grid: Array) -> Array:
    """Put the mean of two neighbours between them, along all three directions of the lattice."""
    fine = np.full((2 * grid.shape[0] - 1, 2 * grid.shape[1] - 1), np.nan)
    fine[::2, ::2] = grid
    fine[::2, 1::2] = (grid[:, :-1] + grid[:, 1:]) / 2
    fine[1::2, ::2] = (grid[:-1] + grid[1:]) / 2
    fine[1::2, 1::2] = (grid[:-1, 1:] + grid[1:, :-1]) / 2
    return fine


def _towards_shore(grid: Array) -> Array:
    """Carry the arrival on by one cell, to places between the last vertex and the shore."""
    padded = np.pad(grid, 1, constant_values=np.nan)
    rows, columns = grid.shape
    around = np.stack(
        [
            padded[1 + dj : 1 + dj + rows, 1 + di : 1 + di + columns]
            for di, dj in ((1, 0), (-1, 0), (0, 1), (0, -1), (1, -1), (-1, 1))
        ]
    )
    known = np.isfinite(around)
    count = known.sum(axis=0)
    mean = np.where(known, around, 0.0).sum(axis=0) / np.maximum(count, 1)
    return np.where(np.isnan(grid) & (count > 0), mean, grid)
