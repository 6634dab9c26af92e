"""A fitted curve: a yacht's speed as a formula with a few dozen numbers."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.models import go_on, tabulate
from seacruise.yacht.polar import Polar

Array = NDArray[np.float64]
ArrayLike = Any

_HALF_WIND = 12.0 * MS_PER_KNOT
"""Wind in which the growth with the wind has run half its way [m/s]; the powers take care of the rest."""


def curve_basis(tws: ArrayLike, twa: ArrayLike, *, winds: int, angles: int) -> Array:
    """Terms of the model at winds [m/s] and angles [degrees] that broadcast.

    With ``s = tws / (tws + 12 kn)``, which grows from 0 in a calm towards 1, the speed is::

        v = sum over i, j of  p[i, j]  s**(i + 1)  sin((j + 1/2) twa),   i < winds, j < angles

    The sines are zero dead into the wind and level dead before it, as two tacks that are alike want it, and
    orthogonal in between. The model is linear in ``p``, so that least squares fit it in one step. Where
    points are few, short waves need a small price, or they fill the gaps with swings of their own.

    Returns
    -------
    Array
        ``(..., winds * angles)``; the angle's index runs fastest.
    """
    wind, angle = np.broadcast_arrays(np.asarray(tws, dtype=np.float64), np.radians(twa))
    share = wind / (wind + _HALF_WIND)
    powers = share[..., np.newaxis] ** np.arange(1, winds + 1)
    sines = np.sin(angle[..., np.newaxis] * (np.arange(angles) + 0.5))
    terms = powers[..., :, np.newaxis] * sines[..., np.newaxis, :]
    return np.asarray(terms.reshape(*wind.shape, winds * angles))


@dataclass(frozen=True, slots=True, eq=False)
class PolarCurve:
    """The model of `curve_basis` with its parameters.

    It is evaluated between the least and the greatest wind and angle of what it was fitted to, where its
    waves have something to hold on to; beyond it goes on as a table does.

    Attributes
    ----------
    name
        The yacht, as shown to the sailor.
    parameters
        ``(winds, angles)`` of the model [m/s].
    winds, angles
        Least and greatest wind [m/s] and angle [degrees] of the figures it was fitted to.

    Raises
    ------
    InputError
        A parameter or a limit is out of range or not finite.
    """

    name: str
    parameters: NDArray[np.float64]
    winds: tuple[float, float]
    angles: tuple[float, float]
    source: str = ""
    path: Path | None = None

    def __post_init__(self) -> None:
        array = np.array(self.parameters, dtype=np.float64)
        array.setflags(write=False)
        object.__setattr__(self, "parameters", array)
        finite = array.ndim == 2 and array.size > 0 and bool(np.isfinite(array).all())
        in_wind = 0.0 <= self.winds[0] <= self.winds[1] < np.inf
        if not (finite and in_wind and 0.0 <= self.angles[0] <= self.angles[1] <= 180.0):
            raise InputError(
                f"The curve of {self.name or 'this yacht'} cannot be used: its parameters or limits are no "
                "numbers in range."
            )

    def speed(self, tws: ArrayLike, twa: ArrayLike) -> Array:
        """Boat speed [m/s] at winds [m/s] and angles [degrees] that broadcast; NaN for NaN."""
        return go_on(self._model, tws, twa, winds=self.winds, angles=self.angles)

    def to_table(self) -> Polar:
        """Tabulate the curve on the usual grid within its limits."""
        return tabulate(self, winds=self.winds, angles=self.angles, path=self.path)

    def _model(self, tws: Array, twa: Array) -> Array:
        winds, angles = self.parameters.shape
        value = curve_basis(tws, twa, winds=winds, angles=angles) @ self.parameters.ravel()
        # A fit may dip below zero where she hardly moves.
        return np.maximum(value, 0.0)
