"""How far she gets: one search forwards to every vertex, one backwards from the end.

Forwards, the ordinary search settles the earliest arrival everywhere. Backwards, `latest_departures` settles
the latest departure from everywhere that still arrives at the end by a given time.
"""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Final, cast

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import from_mercator, great_circle_m, scale, to_mercator
from seacruise.progress import Job
from seacruise.routing import lattice as lattices
from seacruise.routing import stencil
from seacruise.routing.backwards import latest_departures
from seacruise.routing.bound import farthest_m
from seacruise.routing.field import SpeedTable, WindField
from seacruise.routing.find import COURSES, SPACING_NM
from seacruise.routing.lattice import Area, Lattice, chord_m
from seacruise.routing.levels import Position, levels_around
from seacruise.routing.search import Found, search
from seacruise.sea import Sea
from seacruise.sea.water import FARTHEST_WAY_NM
from seacruise.sea.zones import NO_ZONES, Zones
from seacruise.units import METRES_PER_NM, SECONDS_PER_HOUR

Array = NDArray[np.float64]

FINER: Final = 2
"""How often the lattice is halved before lines of equal time are drawn, so that they follow the shore."""

GRANTED: Final = 1.03
"""Share of the time within which a search without fine approaches must come near a port."""

_NEVER_S: Final = 1e12


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
    zones
        Areas to keep out of.
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
    zones: Zones = NO_ZONES

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
        the latest moment to leave it and still be back when the time is over. Infinite where there is none;
        NaN where the way back was not searched.
    sailed_m
        ``(m,)`` length of the way out [m].
    """

    lattice: Lattice
    out: Found
    arrival: Array
    home: Array
    leave_by: Array
    sailed_m: Array


def outing_lattice(asked: Outing, ports: Sequence[Position], *, reach_m: float) -> Lattice:
    """Build a lattice over all that can be reached; start and ports are vertices, and so is the way back.

    The start is there twice: ways begin at ``start`` and lead back to ``end``, at the same place.

    Parameters
    ----------
    reach_m
        Distance from the start that is to be covered [m].
    """
    # Becalmed she still needs a lattice; and beyond the sea that was read there is no water.
    whole_nm = min(max(asked.radius_m / METRES_PER_NM, 1.0), _widest_nm(asked))
    spacing = asked.spacing_nm or min(SPACING_NM, max(0.5, whole_nm / 40))
    x, y = (float(c) for c in to_mercator(*asked.start))
    per_nm = METRES_PER_NM / float(scale(asked.start[0]))
    levels = levels_around(asked.sea, (asked.start, *ports), spacing, 0, per_nm=per_nm)
    # Ways of neighbours overlap: as one they share their vertices.
    together = np.unique(np.concatenate(levels.ways), axis=0)
    reach_nm = math.ceil(min(reach_m / METRES_PER_NM, whole_nm) + spacing)
    return lattices.build(
        asked.sea,
        asked.start,
        asked.start,
        spacing_nm=spacing,
        offsets=stencil.triangular(asked.directions or COURSES),
        area=Area("ellipse", np.array([[x, y, x, y]]), 2 * reach_nm * METRES_PER_NM),
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

    The way out is one search for all ports. Whether she is back in time is the same question for all of
    them too, and one search backwards from the start answers it exactly: the latest moment to leave each. How
    long the way back takes when she leaves at once is another question a port, since each is left at its own
    time: one search each, goal-directed, led past all vertices from which the start is out of reach by
    then, and only where it matters - where she is back in time, or still has half of it.
    """
    job.report("lattice", None, "Building the lattice")
    promising, reach_m = _promising(asked, ports)
    job.check()
    grid = outing_lattice(asked, [ports[k] for k in promising], reach_m=reach_m)
    job.check()
    job.report("search", None, f"Searching {grid.vertices:,} vertices")
    field, speeds = asked.field, asked.speeds
    out = search(grid, field, speeds, asked.departure, to_end=False, latest=asked.deadline, zones=asked.zones)
    job.check()
    back = latest_departures(grid, field, speeds, asked.deadline, earliest=asked.departure, zones=asked.zones)
    arrival, home, sailed = (np.full(len(ports), value) for value in (np.inf, np.nan, np.nan))
    leave_by = np.full(len(ports), -np.inf)
    for k, vertex in zip(promising, grid.joined, strict=True):
        if out.arrival[vertex] <= asked.deadline:
            arrival[k], leave_by[k] = out.arrival[vertex], back.departure[vertex]
            sailed[k] = _length_m(grid, out.path(vertex))
    matters = (arrival + asked.stay <= leave_by) | (arrival - asked.departure <= asked.seconds / 2)
    homewards = _Homewards(asked, grid, back.departure)
    wanted = [k for k in promising if matters[k]]
    vertex_of = dict(zip(promising, grid.joined, strict=True))

    def sail_home(k: int) -> float:
        job.check()
        return homewards.arrival(vertex_of[k], float(arrival[k]) + asked.stay)

    with ThreadPoolExecutor(max_workers=min(4, os.cpu_count() or 1)) as pool:
        for count, (k, time) in enumerate(zip(wanted, pool.map(sail_home, wanted), strict=True)):
            job.report("search", count / len(wanted), "Searching the ways back")
            home[k] = time
    return Explored(grid, out, arrival, home, leave_by, sailed)


@dataclass(frozen=True, slots=True, eq=False)
class _Homewards:
    """Ways back to the start: one search each, and what they have in common.

    Attributes
    ----------
    leave_by
        ``(n,)`` latest departure from each vertex that is back in time.
    """

    asked: Outing
    grid: Lattice
    leave_by: Array

    def arrival(self, vertex: int, departure: float) -> float:
        """Give the earliest arrival at the start, seconds since 1970; inf where there is none."""
        field, speeds = self.asked.field, self.asked.speeds
        grid = replace(self.grid, start=vertex)
        fastest = field.fastest(speeds)
        hopeless = np.zeros(grid.vertices, dtype=bool)
        if departure <= self.leave_by[vertex]:
            # She is back in time, so no vertex on her way is left later than it may be.
            there = chord_m(grid.lat, grid.lon, grid.lat[vertex], grid.lon[vertex]) / fastest
            hopeless = departure + there > self.leave_by + 1.0
        found = search(grid, field, speeds, departure, hopeless=hopeless, zones=self.asked.zones)
        return float(found.arrival[grid.end])


def _promising(asked: Outing, ports: Sequence[Position]) -> tuple[list[int], float]:
    """Find the ports worth a fine approach, and how far from the start she gets [m].

    A lattice without approaches tells when she is where at sea. Where the way into a port begins, no farther
    off than such ways are followed, enough time must be left to sail it at her greatest speed; a few per
    cent are granted for what that lattice cannot do.
    """
    grid = outing_lattice(asked, (), reach_m=asked.radius_m)
    granted = asked.seconds * GRANTED
    found = search(
        grid, asked.field, asked.speeds, asked.departure, to_end=False, latest=asked.departure + granted
    )
    after = found.arrival - asked.departure
    there = after <= granted
    lat, lon, after = grid.lat[there], grid.lon[there], after[there]
    fastest = asked.field.fastest(asked.speeds)
    within = np.minimum((granted - after) * fastest, FARTHEST_WAY_NM * METRES_PER_NM)
    promising = [k for k, port in enumerate(ports) if (great_circle_m(lat, lon, *port) <= within).any()]
    return promising, float(great_circle_m(lat, lon, *asked.start).max())


def _length_m(grid: Lattice, path: NDArray[np.int64]) -> float:
    """Measure a way along edges [m, true]; NaN without one."""
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
    contours = contourpy.contour_generator(
        x,
        y,
        np.ma.masked_array(np.minimum(after, _NEVER_S), np.isnan(after)),
        corner_mask=True,
        fill_type=contourpy.FillType.OuterOffset,
    )
    found = []
    for h in hours:
        # With OuterOffset: of each polygon its points, and where its rings begin in them.
        filled = cast(
            "tuple[list[Array], list[NDArray[np.uint32]]]", contours.filled(-1.0, h * SECONDS_PER_HOUR)
        )
        polygons = []
        for points, begins in zip(*filled, strict=True):
            rings = np.stack(from_mercator(points[:, 0], points[:, 1]), axis=1)
            polygons.append(tuple(rings[a:b] for a, b in pairwise(begins.tolist())))
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
        grid = _halved(grid) if level else grid
        at_j, at_i = (j - j0) * 2**level, (i - i0) * 2**level
        column, row = np.rint(at_i).astype(np.int64), np.rint(at_j).astype(np.int64)
        on = (np.abs(at_i - column) < 1e-6) & (np.abs(at_j - row) < 1e-6)
        on &= (row >= 0) & (row < grid.shape[0]) & (column >= 0) & (column < grid.shape[1])
        grid[row[on], column[on]] = after[on]
    rows, columns = np.mgrid[: grid.shape[0], : grid.shape[1]]
    rows, columns = rows / 2**FINER + j0, columns / 2**FINER + i0
    x = x0 + lattice.spacing_m * (columns + rows / 2.0)
    y = y0 + lattice.spacing_m * stencil.ROW_HEIGHT * rows
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
