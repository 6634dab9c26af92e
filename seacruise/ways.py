"""Single ways of a reach: what leads to each port, and ports whose approach wants a lattice of its own."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from seacruise.along import Position
from seacruise.errors import NoPassageError
from seacruise.geodesy import from_mercator, rhumb_distance_m
from seacruise.model import PassageRequest
from seacruise.passage import how_of, the_finder
from seacruise.progress import Job

if TYPE_CHECKING:
    from seacruise.routing.reach import Explored, Outing


def _vertices(explored: Explored, ports: Sequence[Position]) -> dict[int, int]:
    """Vertex of each port that has one: those worth a fine approach were joined to the lattice."""
    grid = explored.lattice
    if not grid.joined:
        return {}
    joined = np.array(grid.joined)
    found = {}
    for k, (lat, lon) in enumerate(ports):
        away = np.hypot(grid.lat[joined] - lat, grid.lon[joined] - lon)
        nearest = int(np.argmin(away))
        if away[nearest] < 1e-6:
            found[k] = int(joined[nearest])
    return found


def ways_out(explored: Explored, ports: Sequence[Position]) -> dict[int, list[Position]]:
    """Positions along the way to each port that is reached."""
    grid = explored.lattice
    ways = {}
    for k, vertex in _vertices(explored, ports).items():
        if math.isfinite(explored.arrival[k]):
            path = explored.out.path(vertex)
            ways[k] = list(zip(grid.lat[path].tolist(), grid.lon[path].tolist(), strict=True))
    return ways


def cut_off(explored: Explored, ports: Sequence[Position]) -> list[int]:
    """Ports to which the lattice leads in no wind at all: it is too coarse for their approach."""
    from seacruise.routing import _rows as k

    grid = explored.lattice
    open_to = k.reachable(grid.first, grid.target, grid.start)
    return [port for port, vertex in _vertices(explored, ports).items() if not open_to[vertex]]


def sail_alone(
    passage: PassageRequest, asked: Outing, explored: Explored, port: tuple[int, Position], job: Job
) -> list[Position]:
    """Search the ways to and from one port on lattices of its own, as fine as it takes.

    Parameters
    ----------
    passage
        How she is sailed to that port.
    explored
        What is found is entered here.
    port
        Its number in ``explored``, and its water.

    Returns
    -------
    list
        Positions of the way out; empty when she is not there in time.
    """
    from seacruise.routing.backwards import latest_departures
    from seacruise.routing.find import Ledger, Question

    job.check()
    k, there = port
    how = replace(how_of(passage.options), preset="precise", area=None, refine=False)
    out = Question(
        asked.sea,
        passage.wind,
        passage.yacht,
        how,
        asked.start,
        there,
        asked.departure,
        passage.zones,
        passage.stream,
    )
    try:
        found = the_finder().fastest(out, job=job, ledger=Ledger())
    except NoPassageError:
        return []
    arrival = float(found.line.times[-1])
    if arrival > asked.deadline:
        return []
    way = list(zip(*(c.tolist() for c in from_mercator(found.line.x, found.line.y)), strict=True))
    explored.arrival[k] = arrival
    explored.sailed_m[k] = _length_m(way)
    leaves = arrival + asked.stay
    try:
        home = the_finder().fastest(
            replace(out, start=there, end=asked.start, departure=leaves), job=job, ledger=Ledger()
        )
    except NoPassageError:
        return way
    explored.home[k] = float(home.line.times[-1])
    explored.leave_by[k] = latest_departures(
        home.lattice,
        asked.field,
        asked.speeds,
        asked.deadline,
        earliest=asked.departure,
        zones=passage.zones,
    ).departure[home.lattice.start]
    return way


def _length_m(way: Sequence[Position]) -> float:
    lat, lon = np.array(way).T
    return float(rhumb_distance_m(lat[:-1], lon[:-1], lat[1:], lon[1:]).sum())
