"""How fast she goes: boat speed by true wind speed and true wind angle."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError
from seacruise.yacht._curves import Curves, build_curves, evaluate
from seacruise.yacht._one import evaluate_one

Array = NDArray[np.float64]
ArrayLike = Any

_LEVEL = 1e-4
_VMG_STEP = 0.25
"""Step of the search for the best VMG [degrees]; the kinks of a polar are searched besides."""


@dataclass(frozen=True, slots=True, eq=False)
class Polar:
    """A polar table.

    Attributes
    ----------
    name
        The yacht, as shown to the sailor.
    tws
        ``(w,)`` true wind speeds [m/s], increasing.
    twa
        ``(a,)`` true wind angles [degrees], 0-180, increasing; includes the beat and run angles.
    speed_table
        ``(a, w)`` boat speed through the water [m/s]; NaN where the table has no figure.
    source
        Certificate or file that the figures are from.
    sails
        The tables of the single sails, each named after its sail, where the figures are the best of
        several; see `seacruise.yacht.sails`.

    Raises
    ------
    InputError
        The table is not a polar: angles or winds out of order, a speed that is negative or not finite,
        a wind speed without any figure.
    """

    name: str
    tws: NDArray[np.float64]
    twa: NDArray[np.float64]
    speed_table: NDArray[np.float64]
    source: str = ""
    path: Path | None = None
    sails: tuple[Polar, ...] = ()
    _curves: Curves | None = field(default=None, init=False, repr=False)

    def __post_init__(self) -> None:
        for attribute in ("tws", "twa", "speed_table"):
            array = np.array(getattr(self, attribute), dtype=np.float64)
            array.setflags(write=False)
            object.__setattr__(self, attribute, array)
        if fault := self._fault():
            raise InputError(f"The polar of {self.name or 'this yacht'} cannot be used: {fault}.")

    def _fault(self) -> str | None:
        tws, twa, table = self.tws, self.twa, self.speed_table
        if tws.ndim != 1 or twa.ndim != 1 or not tws.size or not twa.size:
            return "it has no wind speeds or no wind angles"
        if table.shape != (twa.size, tws.size):
            return f"its {table.shape} figures do not fit {twa.size} angles and {tws.size} wind speeds"
        if not np.isfinite(tws).all() or tws[0] < 0.0 or (np.diff(tws) <= 0.0).any():
            return "its wind speeds must increase from zero or more"
        if not np.isfinite(twa).all() or twa[0] < 0.0 or twa[-1] > 180.0 or (np.diff(twa) <= 0.0).any():
            return "its wind angles must increase within 0 and 180 degrees"
        if np.isinf(table).any() or (table < 0.0).any():
            return "a boat speed is negative or not finite"
        if np.isnan(table).all(axis=0).any():
            return "a wind speed has no figure at any angle"
        return None

    @property
    def curves(self) -> Curves:
        """The continuous polar behind the table; made once, when first asked for."""
        if self._curves is None:
            object.__setattr__(self, "_curves", build_curves(self.tws, self.twa, self.speed_table))
        assert self._curves is not None
        return self._curves

    def speed(self, tws: ArrayLike, twa: ArrayLike) -> Array:
        """Boat speed through the water [m/s] at true wind speeds [m/s] and angles [degrees].

        Monotone cubic in the angle, over the angles that have figures at that very wind speed, then
        monotone cubic between wind speeds: always within the figures around it. Below the least wind
        speed it falls linearly to zero in a calm, above the greatest it stays. How it goes on beyond
        the least and the greatest angle is told in `seacruise.yacht._curves`.

        Parameters
        ----------
        tws, twa
            Any shapes that broadcast; angles of any sign and size are folded to 0-180.

        Returns
        -------
        Array
            Of the broadcast shape [m/s]; NaN where an argument is NaN.
        """
        if isinstance(tws, float) and isinstance(twa, float):
            return np.asarray(evaluate_one(self.curves, float(tws), float(twa)))
        return evaluate(self.curves, np.asarray(tws, dtype=np.float64), fold_angle(twa))

    def to_table(self) -> Polar:
        """Return the polar itself; see `seacruise.yacht.models.SpeedModel`."""
        return self

    def nearest_speed(self, tws: ArrayLike, twa: ArrayLike) -> Array:
        """Boat speed [m/s] by the rule of R1: the nearest tabulated wind speed, linear in the angle only.

        With columns of 16 and 20 kn, 18 still reads 16 (half-way goes down) and all above reads 20.
        Zero inside the dead angle, which is below the least angle with a figure in that column, and in
        a calm; beyond the greatest angle the last figure stays.

        Parameters
        ----------
        tws, twa
            True wind speed [m/s] and angle [degrees]; any shapes that broadcast.
        """
        wind, angle = np.broadcast_arrays(np.asarray(tws, dtype=np.float64), fold_angle(twa))
        # A hair downwards: knots become m/s with a rounding that must not decide a tie.
        middles = (self.tws[1:] + self.tws[:-1]) / 2.0 * (1.0 + 1e-12)
        column = np.searchsorted(middles, wind, side="left")
        result = np.zeros(wind.shape)
        for k in np.unique(column):
            known = ~np.isnan(self.speed_table[:, k])
            here = column == k
            result[here] = np.interp(angle[here], self.twa[known], self.speed_table[known, k], left=0.0)
        result[wind <= 0.0] = 0.0
        result[np.isnan(wind) | np.isnan(angle)] = np.nan
        return result

    def covers(self, tws: ArrayLike, twa: ArrayLike) -> NDArray[np.bool_]:
        """Whether a wind [m/s] and an angle [degrees] lie within the figures, rather than beyond them.

        Within the winds of the table, and between the least and the greatest angle that has a figure at the
        nearest of them.
        """
        wind, angle = np.broadcast_arrays(np.asarray(tws, dtype=np.float64), fold_angle(twa))
        known = ~np.isnan(self.speed_table)
        nearest = np.abs(wind[..., np.newaxis] - self.tws).argmin(axis=-1)
        least = self.twa[known.argmax(axis=0)][nearest]
        greatest = self.twa[::-1][known[::-1].argmax(axis=0)][nearest]
        # Knots become m/s with a rounding that must not decide.
        in_wind = (wind >= self.tws[0] * (1.0 - 1e-9)) & (wind <= self.tws[-1] * (1.0 + 1e-9))
        return np.asarray(in_wind & (angle >= least) & (angle <= greatest))

    def best_vmg(self, tws: ArrayLike, upwind: bool) -> tuple[Array, Array]:
        """Angle [degrees] and speed [m/s] of the best velocity made good against or with the wind.

        Beyond the greatest angle of a table VMG is level by rule, to a few parts of 100,000: rounding would
        decide between the last figure and dead before the wind. There the angle nearest to abeam is told.

        Parameters
        ----------
        tws
            True wind speed [m/s], any shape.
        upwind
            Against the wind; otherwise with it.

        Returns
        -------
        twa, vmg
            In the shape of ``tws``; the VMG is positive both ways.
        """
        wind = np.asarray(tws, dtype=np.float64)
        angles = self.sample_angles(_VMG_STEP)
        angles = angles[angles <= 90.0] if upwind else angles[angles >= 90.0]
        vmg = self.speed(wind[..., np.newaxis], angles) * np.abs(np.cos(np.radians(angles)))
        vmg = np.nan_to_num(vmg, nan=-1.0)
        best = np.argmax(vmg, axis=-1)
        if not upwind:
            level = np.argmax(vmg >= (1.0 - _LEVEL) * vmg.max(axis=-1, keepdims=True), axis=-1)
            best = np.where(self.covers(wind, angles[best]), best, level)
        return angles[best], vmg.max(axis=-1)

    def sample_angles(self, step: float) -> Array:
        """Angles 0-180 [degrees], no further apart than ``step``, with every kink of the polar among them."""
        even = np.linspace(0.0, 180.0, round(180.0 / step) + 1)
        return np.unique(np.concatenate((even, self.curves.knots)))


def fold_angle(twa: ArrayLike) -> Array:
    """Fold angles [degrees] of any sign and size to 0-180: she sails alike on both tacks."""
    turn = np.abs(np.asarray(twa, dtype=np.float64)) % 360.0
    return np.asarray(np.minimum(turn, 360.0 - turn))
