"""Where the vertices of a lattice may lie, and where it is refined: areas, levels, safety zones."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import EARTH_RADIUS, from_mercator, scale
from seacruise.sea.zones import NO_ZONES, Zones

Array = NDArray[np.float64]

WIDE_LEVELS: Final = 2
"""Levels that a corridor has in its whole width: among islands the next sound lies miles away, and a first
search without these levels cannot tell which of two is the faster by a third of a percent."""


@dataclass(frozen=True, slots=True, eq=False)
class Area:
    """Where vertices may lie.

    Attributes
    ----------
    kind
        ``"ellipse"``: the sum of the distances to both ends is at most ``reach_m`` [m, true].
        ``"rectangle"``: at most ``reach_m`` [m of the plane] to each side of the direct line (R1).
        ``"corridor"``: at most ``reach_m`` [m of the plane] from a line, and half of that for each level
        beyond `WIDE_LEVELS`.
        ``"box"``: between the parallels and meridians of two corners (R2, R3).
    lines
        ``(n, 4)`` x0, y0, x1, y1 of the Mercator plane [m]: the direct line, the lines to follow, or the
        south-west and the north-east corner of the box.
    """

    kind: Literal["ellipse", "rectangle", "corridor", "box"]
    lines: Array
    reach_m: float = 0.0

    def at_level(self, level: int) -> Area:
        """Give the part in which a level is refined."""
        if self.kind != "corridor":
            return self
        return replace(self, reach_m=self.reach_m / 2 ** max(0, level - WIDE_LEVELS))

    def bounds(self) -> tuple[Array, Array]:
        """South-west and north-east corner of an upright rectangle around it [m of the plane]."""
        ends, reach = self.lines.reshape(-1, 2), self.reach_m
        if self.kind == "ellipse":
            flat = float(scale(from_mercator(0.0, np.abs(ends[:, 1]).max())[0])) * 0.95
            length, total = float(np.hypot(*(ends[-1] - ends[0]))), self.reach_m / flat
            reach = max((total - length) / 2, math.sqrt(max(0.0, total**2 - length**2)) / 2)
        elif self.kind == "box":
            # The last row and column lie on the border itself: rounding must not lose them.
            reach = 1e-3
        return ends.min(axis=0) - reach, ends.max(axis=0) + reach

    def holds(self, x: Array, y: Array) -> NDArray[np.bool_]:
        """Tell which points ``(n,)`` of its `bounds` lie in it; those of a corridor are made to."""
        if self.kind == "ellipse":
            total = np.zeros(x.size)
            lat, lon = from_mercator(x, y)
            for point in (self.lines[0, :2], self.lines[0, 2:]):
                total += chord_m(lat, lon, *(float(c) for c in from_mercator(*point)))
            return np.asarray(total <= self.reach_m)
        if self.kind == "rectangle":
            x0, y0, x1, y1 = self.lines[0]
            length = math.hypot(x1 - x0, y1 - y0)
            ux, uy = (x1 - x0) / length, (y1 - y0) / length
            along, across = (x - x0) * ux + (y - y0) * uy, (x - x0) * uy - (y - y0) * ux
            return np.asarray((np.abs(across) <= self.reach_m) & (along >= -1.0) & (along <= length + 1.0))
        return np.ones(x.size, dtype=bool)


@dataclass(frozen=True, slots=True, eq=False)
class Levels:
    """How the lattice is refined towards the shore.

    A refined level reaches two of its own sides from the shore, so that each is joined to the one above.
    Safety zones (R3) are wider: within a radius of the shore, and of the border of each hazard, all their
    levels are there, and the sides are 2 ** ``safety_levels`` times shorter than at sea.

    Attributes
    ----------
    everywhere
        Levels by which the shore is refined in the whole area.
    approaches
        Further levels around ``ways``: the ways by which each end leads out of islands.
    ways
        For each end ``(n, 4)`` lines as in `Area`.
    sides
        How far around the ways, in sides of a level's triangles.
    safety_radius_m
        Width of the safety zones [m, true]. Distances from the shore are those of the sea's raster,
        counted over corners too: all within the radius is refined, and up to 1.4 times that diagonally.
    safety_levels
        Levels of the safety zones.
    hazards
        Closed areas around whose borders there are safety zones, whether they are closed for good or for
        a time.
    """

    everywhere: int = 0
    approaches: int = 0
    ways: tuple[Array, ...] = ()
    sides: float = 3.0
    safety_radius_m: float = 0.0
    safety_levels: int = 0
    hazards: Zones = NO_ZONES

    @property
    def deepest(self) -> int:
        """Level to which the whole shore is refined."""
        return max(self.everywhere, self.safety_levels)

    def radius_at(self, level: int) -> float:
        """Radius of the safety zones at a level [m, true]; 0 beyond the last of them."""
        return float(self.safety_radius_m) if level <= self.safety_levels else 0.0

    def hazards_at(self, level: int) -> Array:
        """Borders ``(n, 4)`` [m of the plane] around which a level is refined."""
        if not 1 <= level <= self.safety_levels or not self.hazards:
            return np.empty((0, 4))
        return self.hazards.arrays[1]


NO_LEVELS: Final = Levels()


def room_m(radius_m: float, side: float, y: Any) -> Array:
    """How far from the shore a level is refined [m of the plane].

    Parameters
    ----------
    radius_m
        Radius of the safety zone [m, true].
    side
        Longest side of the level's cells [m of the plane].
    y
        Where in the plane [m]: the farther north, the longer a true metre.
    """
    return np.maximum(2.0 * side, radius_m * np.cosh(np.asarray(y) / EARTH_RADIUS))


def chord_m(lat: Array, lon: Array, lat0: float, lon0: float) -> Array:
    """Straight distance through the earth [m]: a lower bound of every distance on it, and a metric."""
    p, l = np.radians(lat), np.radians(lon)  # noqa: E741
    p0, l0 = math.radians(lat0), math.radians(lon0)
    dx = np.cos(p) * np.cos(l) - math.cos(p0) * math.cos(l0)
    dy = np.cos(p) * np.sin(l) - math.cos(p0) * math.sin(l0)
    return np.asarray(EARTH_RADIUS * np.sqrt(dx**2 + dy**2 + (np.sin(p) - math.sin(p0)) ** 2))
