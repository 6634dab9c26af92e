"""Figures as they are collected from a polar file, in knots and degrees, and the polar they make."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

import numpy as np

from seacruise.units import MS_PER_KNOT
from seacruise.yacht._cells import FaultError, Place
from seacruise.yacht.polar import Polar

MAX_TWS_KN: Final = 120.0
MAX_SPEED_KN: Final = 80.0
MAX_WINDS: Final = 200
MAX_ANGLES: Final = 1000
"""The largest honest tables known have a column a knot and a row a degree."""

_SAME_SPEED_KN: Final = 0.05
"""Two figures for one angle and wind may differ by this: a beat or run angle met a tabulated one."""


@dataclass(slots=True)
class Figures:
    """Boat speeds [kn] of one table: ``figures[tws_kn][twa]``, and the sail they are sailed with."""

    figures: dict[float, dict[float, float]] = field(default_factory=dict)
    sail: str = ""

    def add_wind(self, tws: float, place: Place, cell: int) -> None:
        """Begin the figures of a wind speed [kn]; winds come in increasing order.

        Raises
        ------
        FaultError
            It is out of range, there already, or out of order.
        """
        check_wind(tws, place, cell)
        if tws in self.figures:
            raise FaultError(f"{place.where(cell)}: the wind speed {tws:g} kn is there twice")
        if self.figures and tws < max(self.figures):
            raise FaultError(
                f"{place.where(cell)}: the wind speeds must increase, {tws:g} kn comes after "
                f"{max(self.figures):g}"
            )
        self.figures[tws] = {}

    def add(self, point: tuple[float, float, float], place: Place, cell: int) -> None:
        """Add a wind speed [kn] that was begun, an angle [degrees] and a boat speed [kn].

        Raises
        ------
        FaultError
            Angle or speed is out of range, or the same wind and angle has another speed.
        """
        tws, twa, speed = point
        check_point(twa, speed, place, cell)
        known = self.figures[tws].setdefault(twa, speed)
        if abs(known - speed) > _SAME_SPEED_KN:
            where = place.where(cell)
            raise FaultError(
                f"{where}: {twa:g} degrees at {tws:g} kn has two speeds, {known:g} and {speed:g} kn"
            )

    def polar(self, name: str, *, source: str = "", path: Path | None = None) -> Polar:
        """Make the polar; wind speeds without any figure are left out (OpenCPN: interpolate there).

        Raises
        ------
        FaultError
            There is too little to sail by.
        """
        winds = [tws for tws, figures in self.figures.items() if figures]
        angles = sorted({twa for tws in winds for twa in self.figures[tws]})
        of_sail = f" ({self.sail})" if self.sail else ""
        if len(winds) < 2 or len(angles) < 2:
            raise FaultError(
                f"line 1: a polar needs figures at two wind speeds and two angles or more{of_sail}"
            )
        if len(winds) > MAX_WINDS or len(angles) > MAX_ANGLES:
            raise FaultError(
                f"line 1: {len(winds)} wind speeds and {len(angles)} angles are more than a polar has"
            )
        speeds = np.full((len(angles), len(winds)), np.nan)
        row_of = {twa: row for row, twa in enumerate(angles)}
        for k, tws in enumerate(winds):
            for twa, speed in self.figures[tws].items():
                speeds[row_of[twa], k] = speed
        if not (speeds > 0.0).any():
            raise FaultError(f"line 1: all boat speeds are zero{of_sail}")
        return Polar(
            name=name,
            tws=np.array(winds) * MS_PER_KNOT,
            twa=np.array(angles),
            speed_table=speeds * MS_PER_KNOT,
            source=source,
            path=path,
        )


def check_wind(tws: float, place: Place, cell: int) -> None:
    """Refuse a wind speed [kn] that no table has."""
    if not 0.0 <= tws <= MAX_TWS_KN:
        where = place.where(cell)
        raise FaultError(f"{where}: a wind speed of {tws:g} kn is not within 0 and {MAX_TWS_KN:g}")


def check_point(twa: float, speed: float, place: Place, cell: int) -> None:
    """Refuse an angle [degrees] or a boat speed [kn] that no table has."""
    if not 0.0 <= twa <= 180.0:
        where = place.where(cell)
        raise FaultError(f"{where}: a wind angle of {twa:g} degrees is not within 0 and 180")
    if not 0.0 <= speed <= MAX_SPEED_KN:
        where = place.where(cell)
        raise FaultError(f"{where}: a boat speed of {speed:g} kn is not within 0 and {MAX_SPEED_KN:g}")
