"""A yacht that is not the same on both tacks: bent mast, log on one side, engine box, loose keel."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from seacruise.yacht.polar import Polar
from seacruise.yacht.sails import union_of_axes

Array = NDArray[np.float64]
ArrayLike = Any


@dataclass(frozen=True, slots=True, eq=False)
class TwoSided:
    """One polar for each tack.

    Routing sails alike on both tacks and takes the mean of the two: a beat spends its time on both. Who
    wants to be sure takes the slower one with ``slower=True``.

    Attributes
    ----------
    name
        The yacht, as shown to the sailor.
    port, starboard
        With the wind over the port and over the starboard side.
    slower
        `speed` is that of the slower tack rather than the mean.
    """

    name: str
    port: Polar
    starboard: Polar
    slower: bool = False
    source: str = ""
    path: Path | None = None

    def speed_on(self, tws: ArrayLike, twa_signed: ArrayLike) -> Array:
        """Boat speed [m/s] at an angle [degrees] that is negative with the wind over the port side.

        Dead into and dead before the wind, where there is no side, it is that of `speed`.
        """
        angle = (np.asarray(twa_signed, dtype=np.float64) + 180.0) % 360.0 - 180.0
        one_side = np.where(angle < 0.0, self.port.speed(tws, angle), self.starboard.speed(tws, angle))
        return np.where((angle == 0.0) | (angle == -180.0), self.speed(tws, angle), one_side)

    def speed(self, tws: ArrayLike, twa: ArrayLike) -> Array:
        """Mean boat speed [m/s] of both tacks, or the slower one's, at winds [m/s] and angles [degrees]."""
        port, starboard = self.port.speed(tws, twa), self.starboard.speed(tws, twa)
        return np.asarray(np.minimum(port, starboard) if self.slower else (port + starboard) / 2.0)

    def to_table(self) -> Polar:
        """Tabulate `speed` at the winds and angles of both."""
        tws = union_of_axes([self.port.tws, self.starboard.tws], 1e-6)
        twa = union_of_axes([self.port.twa, self.starboard.twa], 1e-6)
        table = self.speed(tws, twa[:, np.newaxis])
        return Polar(self.name, tws, twa, table, source=self.source, path=self.path)
