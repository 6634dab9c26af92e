"""R1's rules, for the ``classic`` preset: what SeaCruisePlanner published in 2021.

A rectangle around the direct line, twelve courses, the wind of the vertex and the hour at which an edge
is left held for the whole edge, the polar at its nearest wind speed, no sailing inside the dead angle,
and the array-queue Dijkstra. (Taking the wind at departure for a whole edge can break FIFO in a calm;
`seacruise.routing._kernels.sail_line` does not have that fault.)
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from seacruise.geodesy import EARTH_RADIUS, scale, to_mercator
from seacruise.routing import lattice as lattices
from seacruise.routing import stencil
from seacruise.routing.field import Handling
from seacruise.routing.lattice import NO_LEVELS, Area, Lattice, Levels
from seacruise.routing.reference import Sail, array_queue_search
from seacruise.routing.search import Found
from seacruise.sea import Sea
from seacruise.weather.wind import Wind, to_direction
from seacruise.yacht.polar import Polar

HALF_WIDTH_DEG: Final = 0.5
"""R1's rectangle reaches this far to each side of the direct line [degrees of latitude]."""

SPACING_NM: Final = 21.5
"""Side of the triangles [nm] with which Karlskrona - Świnoujście has its published 20 vertices."""

ENTERED_FROM: Final = 6
"""Vertices that lead into the end."""


def lattice(
    sea: Sea,
    start: tuple[float, float],
    end: tuple[float, float],
    *,
    spacing_nm: float = SPACING_NM,
    levels: Levels = NO_LEVELS,
) -> Lattice:
    """R1's lattice between two positions [degrees]: rectangle, second ring, end entered from 6 vertices.

    ``levels`` other than none refine it towards shore and ports, which R1 did not.
    """
    (x0, x1), (y0, y1) = to_mercator([start[0], end[0]], [start[1], end[1]])
    half_width = EARTH_RADIUS * math.radians(HALF_WIDTH_DEG) / float(scale((start[0] + end[0]) / 2))
    return lattices.build(
        sea,
        start,
        end,
        spacing_nm=spacing_nm,
        offsets=stencil.second_ring(),
        area=Area("rectangle", np.array([[x0, y0, x1, y1]]), half_width),
        levels=levels,
        enter_from=ENTERED_FROM,
    )


def sail_by_r1(grid: Lattice, wind: Wind, polar: Polar, handling: Handling) -> Sail:
    """Edge times by R1's rules, for `array_queue_search`."""
    source = grid.sources()
    dx, dy = grid.x[grid.target] - grid.x[source], grid.y[grid.target] - grid.y[source]
    length = np.hypot(dx, dy) * (grid.scale[source] + grid.scale[grid.target]) / 2
    course = np.degrees(np.arctan2(dx, dy))
    first_hour, last_hour = int(wind.time[0] // 3600), int(wind.time[-1] // 3600)
    hours = np.arange(first_hour, last_hour + 1)
    u, v = wind.at(hours[:, None] * 3600.0, grid.lat[None, :], grid.lon[None, :])
    tws, twd = to_direction(u, v)
    speed = handling.share * polar.nearest_speed(tws[:, source], twd[:, source] - course[None, :])
    if handling.motor_below is not None:
        speed = np.where(speed < handling.motor_below, np.maximum(speed, handling.motor_speed), speed)
    if handling.max_wind is not None:
        speed = np.where(tws[:, source] > handling.max_wind, 0.0, speed)
    with np.errstate(divide="ignore"):
        seconds = length[None, :] / speed
    number = {(a, b): e for e, (a, b) in enumerate(zip(source.tolist(), grid.target.tolist(), strict=True))}

    def sail(t: float, a: int, b: int) -> float:
        hour = min(max(int(t // 3600), first_hour), last_hour) - first_hour
        return t + float(seconds[hour, number[a, b]])

    return sail


def search(grid: Lattice, wind: Wind, polar: Polar, handling: Handling, departure: float) -> Found:
    """R1's search: labels of every vertex that can be reached."""
    return array_queue_search(grid, sail_by_r1(grid, wind, polar, handling), departure)


def rows_as_published(grid: Lattice) -> list[str]:
    """Adjacency lists in R1's notation, ``0 --> 1 2``: 0 is the start, the last one the end."""
    away = np.hypot(grid.x - grid.x[grid.start], grid.y - grid.y[grid.start])
    away[grid.end] = np.inf
    order = np.argsort(away, kind="stable")
    number = np.empty_like(order)
    number[order] = np.arange(order.size)
    rows = (number[grid.target[grid.first[v] : grid.first[v + 1]]] for v in order)
    return [f"{k} --> {' '.join(map(str, sorted(row.tolist())))}".rstrip() for k, row in enumerate(rows)]
