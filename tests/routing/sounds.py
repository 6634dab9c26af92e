"""Narrow water of the Baltic, and how far it is through it."""

from __future__ import annotations

from typing import Final

import numpy as np

from seacruise.geodesy import great_circle_m, to_mercator
from seacruise.routing import lattice as lattices
from seacruise.routing import stencil
from seacruise.routing.field import Handling, speed_table, wind_field
from seacruise.routing.lattice import NO_LEVELS, Area, Lattice, Levels
from seacruise.routing.search import search
from seacruise.sea import Sea
from seacruise.sea.zones import NO_ZONES, Zones
from tests.routing.worlds import HOUR, T0, drifter, steady_wind

COARSE_NM: Final = 5.0
DEEPEST: Final = 5
"""Spacing at sea [nm], and the levels with which it is 0.16 nm at the shore."""

SOUNDS: Final = {
    "Kalmar Sound": ((56.80, 16.50), (56.50, 16.35), 1.15),
    "Stockholm archipelago": ((58.87, 17.97), (59.70, 19.10), 1.3),
    "Øresund": ((56.15, 12.50), (55.40, 12.80), 1.15),
    "Fehmarnsund": ((54.42, 10.95), (54.36, 11.25), 1.6),
}
"""Two ends, and how far around the direct line the area reaches."""


def ellipse(start: tuple[float, float], end: tuple[float, float], stretch: float = 1.2) -> Area:
    x, y = to_mercator([start[0], end[0]], [start[1], end[1]])
    return Area(
        "ellipse", np.array([[x[0], y[0], x[1], y[1]]]), stretch * float(great_circle_m(*start, *end))
    )


def lattice_through(
    sea: Sea,
    sound: str,
    *,
    kind: stencil.Kind = "triangular",
    spacing_nm: float = COARSE_NM,
    levels: Levels = NO_LEVELS,
) -> Lattice:
    """Build a lattice with 24 courses, or 32 on squares."""
    start, end, stretch = SOUNDS[sound]
    return lattices.build(
        sea,
        start,
        end,
        spacing_nm=spacing_nm,
        offsets=stencil.of(kind, 32 if kind == "rectangular" else 24),
        mesh=stencil.mesh_of(kind),
        area=ellipse(start, end, stretch),
        levels=levels,
    )


def shortest_nm(lattice: Lattice, zones: Zones = NO_ZONES) -> float:
    """Length of the shortest way, by a yacht that makes 10 kn on every course; inf where there is none."""
    field, speeds = wind_field(steady_wind(10.0, 0.0)), speed_table(drifter(), Handling())
    found = search(lattice, field, speeds, T0, zones=zones)
    return float(found.arrival[lattice.end] - T0) / HOUR * 10.0
