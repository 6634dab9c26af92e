"""Lines of equal time around a passage's start, for the chart; computed beside the window."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.units import SECONDS_PER_HOUR

if TYPE_CHECKING:
    from seacruise.desktop.compute import Answer
    from seacruise.progress import Job
    from seacruise.routing.reach import Isochrone
    from seacruise.settings import Settings

_STEPS_H: Final = (0.25, 0.5, 1.0, 2.0, 3.0, 6.0, 12.0, 24.0, 48.0)
_MOST_LINES: Final = 12
_TOLERANCE_DEG: Final = 0.003


@dataclass(frozen=True, slots=True, eq=False)
class TimeLine:
    """Where she can be after some hours and not before.

    Attributes
    ----------
    hours
        Since departure.
    pieces
        Each ``(n, 2)`` of lat and lon [degrees]; shores are left out.
    """

    hours: float
    pieces: tuple[NDArray[np.float64], ...]


def hours_drawn(duration_h: float) -> list[float]:
    """Even hours within a passage for which a line is drawn."""
    step = next((s for s in _STEPS_H if duration_h / s <= _MOST_LINES), _STEPS_H[-1])
    return [k * step for k in range(1, math.ceil(duration_h / step - 1e-9))]


def find_time_lines(answer: Answer, *, settings: Settings, job: Job) -> list[TimeLine]:
    """Search on from a passage's start in all directions, as long as the passage lasts.

    Raises
    ------
    CancelledError
        The job was cancelled.
    """
    from seacruise.between import sea_between
    from seacruise.passage import how_of
    from seacruise.routing import reach as routing
    from seacruise.routing.field import COARSE_SLICE_S, speed_table, wind_field
    from seacruise.routing.search import search

    question, passage = answer.question, answer.passage
    departure, hours = passage.departure.timestamp(), hours_drawn(passage.duration_h)
    seconds = passage.duration_h * SECONDS_PER_HOUR
    handling = how_of(question.options).handling
    field = wind_field(
        answer.wind,
        slice_s=COARSE_SLICE_S,
        since=departure,
        current=answer.wind.current if question.options.currents else None,
        limits=handling.limits,
    )
    asked = routing.Outing(
        sea_between(question.start, question.end, settings),
        field,
        speed_table(question.yacht, handling),
        (passage.start.lat, passage.start.lon),
        departure,
        seconds,
        zones=answer.zones,
    )
    job.check()
    grid = routing.outing_lattice(asked, (), reach_m=asked.radius_m)
    job.check()
    found = search(
        grid,
        asked.field,
        asked.speeds,
        departure,
        to_end=False,
        latest=asked.deadline,
        zones=answer.zones,
    )
    job.check()
    beyond = 2.0 * passage.duration_h
    areas = routing.isochrones(grid, asked.sea, found.arrival, departure=departure, hours=[*hours, beyond])
    return [_thinned(line) for line in open_lines(areas)]


def _thinned(line: TimeLine) -> TimeLine:
    """Leave out points that move a line by less than it is wide on the chart."""
    import shapely

    pieces = [shapely.LineString(piece) for piece in line.pieces]
    thin = [shapely.get_coordinates(piece.simplify(_TOLERANCE_DEG)) for piece in pieces]
    return TimeLine(line.hours, tuple(thin))


def open_lines(areas: Sequence[Isochrone]) -> list[TimeLine]:
    """Lines of all areas but the last, without the shores.

    Areas of equal time share their shores, and nothing else: what the next larger one has too is shore.
    """
    found = []
    for area, larger in pairwise(areas):
        shore = {point for polygon in larger.polygons for ring in polygon for point in _keys(ring)}
        pieces: list[NDArray[np.float64]] = []
        for polygon in area.polygons:
            for ring in polygon:
                pieces.extend(_off_shore(ring, np.array([point in shore for point in _keys(ring)])))
        found.append(TimeLine(area.hours, tuple(pieces)))
    return found


def _keys(ring: NDArray[np.float64]) -> list[tuple[float, float]]:
    # To a metre: where land cuts a cell, the line lies between an hour and "never", and moves by less.
    return [(lat, lon) for lat, lon in ring.round(5).tolist()]


def _off_shore(ring: NDArray[np.float64], shore: NDArray[np.bool_]) -> list[NDArray[np.float64]]:
    """Parts of a closed ring whose sides do not lie on the shore at both ends."""
    sides = ~(shore[:-1] & shore[1:])
    if not sides.any():
        return []
    if sides.all():
        return [ring]
    # Begin at a side of the shore, so that no part is cut where the ring happens to close.
    first = int(np.flatnonzero(~sides)[0])
    points = np.roll(ring[:-1], -first, axis=0)
    sides = np.roll(sides, -first)
    bounds = np.flatnonzero(np.diff(np.concatenate([[False], sides, [False]]).astype(np.int8)))
    closed = np.vstack([points, points[:1]])
    return [closed[begin : end + 1] for begin, end in bounds.reshape(-1, 2).tolist()]
