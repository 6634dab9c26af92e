"""A cloud of points: boat speed as it was met, at winds and angles that form no table."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.models import go_on, tabulate
from seacruise.yacht.polar import Polar

Array = NDArray[np.float64]
ArrayLike = Any

_TWS_SCALE: Final = 2.0 * MS_PER_KNOT
_TWA_SCALE: Final = 10.0
"""Two knots of wind [m/s] count as much as ten degrees: in a certificate they change as much of the speed."""

_NEIGHBOURS: Final = 12
_AT_ONCE: Final = 4_000_000
"""Distances held in memory at once."""


@dataclass(frozen=True, slots=True, eq=False)
class PolarPoints:
    """Points of wind, angle and boat speed, and the surface through them.

    The speed between the points is their weighted mean by Shepard's improved inverse distance: of the
    twelve nearest points, one at the distance d has the weight ``((R - d) / (R d))**2``, where R is the
    distance of the farthest of them. A point's own speed is returned at its place (the mean, where several
    lie there), no speed is outside those of the points around it, and none jumps where the twelve change.

    Attributes
    ----------
    name
        The yacht, as shown to the sailor.
    tws, twa, boat_speed
        ``(n,)`` true wind speed [m/s], true wind angle [degrees, 0 to 180] and speed through the water [m/s].

    Raises
    ------
    InputError
        There are no points, or one is out of range or not finite.

    References
    ----------
    D. Shepard, A two-dimensional interpolation function for irregularly-spaced data, Proc. 23rd ACM
    National Conf. (1968), doi 10.1145/800186.810616. R. Franke, Scattered data interpolation: tests of some
    methods, Math. Comp. 38 (1982), doi 10.1090/S0025-5718-1982-0637296-4.
    """

    name: str
    tws: NDArray[np.float64]
    twa: NDArray[np.float64]
    boat_speed: NDArray[np.float64]
    source: str = ""
    path: Path | None = None

    def __post_init__(self) -> None:
        for attribute in ("tws", "twa", "boat_speed"):
            array = np.array(getattr(self, attribute), dtype=np.float64)
            array.setflags(write=False)
            object.__setattr__(self, attribute, array)
        if fault := self._fault():
            raise InputError(f"The points of {self.name or 'this yacht'} cannot be used: {fault}.")

    def _fault(self) -> str | None:
        if self.tws.ndim != 1 or not self.tws.size:
            return "there are none"
        if not self.tws.shape == self.twa.shape == self.boat_speed.shape:
            return "winds, angles and speeds are not of one number"
        if not all(np.isfinite(a).all() for a in (self.tws, self.twa, self.boat_speed)):
            return "one is not finite"
        if (self.tws < 0.0).any() or (self.boat_speed < 0.0).any():
            return "a wind or a boat speed is negative"
        if (self.twa < 0.0).any() or (self.twa > 180.0).any():
            return "an angle is not within 0 and 180 degrees"
        return None

    @property
    def winds(self) -> tuple[float, float]:
        """Least and greatest wind with a point [m/s]."""
        return float(self.tws.min()), float(self.tws.max())

    @property
    def angles(self) -> tuple[float, float]:
        """Least and greatest angle with a point [degrees]."""
        return float(self.twa.min()), float(self.twa.max())

    def speed(self, tws: ArrayLike, twa: ArrayLike) -> Array:
        """Boat speed [m/s] at winds [m/s] and angles [degrees] that broadcast; NaN for NaN."""
        return go_on(self._between, tws, twa, winds=self.winds, angles=self.angles)

    def to_table(self) -> Polar:
        """Tabulate the surface on the usual grid within the points."""
        return tabulate(self, winds=self.winds, angles=self.angles, path=self.path)

    def _between(self, tws: Array, twa: Array) -> Array:
        points = np.column_stack((self.tws / _TWS_SCALE, self.twa / _TWA_SCALE))
        asked = np.column_stack((tws / _TWS_SCALE, twa / _TWA_SCALE))
        step = max(1, _AT_ONCE // len(points))
        parts = [self._mean(points, asked[i : i + step]) for i in range(0, len(asked), step)]
        return np.concatenate(parts) if parts else np.zeros(0)

    def _mean(self, points: Array, asked: Array) -> Array:
        d2 = np.zeros((len(asked), len(points)))
        for axis in (0, 1):
            d2 += (asked[:, axis, np.newaxis] - points[:, axis]) ** 2
        nearest = min(_NEIGHBOURS, len(points))
        chosen = np.argpartition(d2, nearest - 1, axis=1)[:, :nearest]
        distance = np.sqrt(np.take_along_axis(d2, chosen, axis=1))
        speeds = self.boat_speed[chosen]
        # Closer than any instrument tells apart: the place of the point itself, where 1 / d has no end.
        at_place = distance < 1e-9
        distance = np.maximum(distance, 1e-9)
        reach = distance.max(axis=1, keepdims=True)
        # All twelve may be equally far, as around the middle of a circle: then all count alike.
        weight = ((reach - distance) / (reach * distance)) ** 2 + 1e-12
        weight = np.where(at_place.any(axis=1, keepdims=True), at_place, weight)
        return np.asarray((weight * speeds).sum(axis=1) / weight.sum(axis=1))
