"""What every representation of a yacht's speed can do, and how it becomes a table.

A table (`Polar`), a cloud of points (`PolarPoints`), a fitted curve (`PolarCurve`), several sails (`SailSet`)
and a yacht that is not the same on both tacks (`TwoSided`) are all a `SpeedModel`. Routing, hull and files
know tables only: ``to_table()`` makes one of each.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final, Protocol

import numpy as np
from numpy.typing import NDArray

from seacruise.units import MS_PER_KNOT
from seacruise.yacht._curves import ramp_start
from seacruise.yacht.polar import Polar, fold_angle

Array = NDArray[np.float64]
ArrayLike = Any

GRID_TWS_KN: Final = (2.0, 4.0, 6.0, 8.0, 10.0, 12.0, 14.0, 16.0, 18.0, 20.0, 24.0, 28.0, 32.0, 40.0)
"""Wind speeds of the tables that are made of other representations [kn]."""

GRID_TWA: Final = (*(float(a) for a in range(30, 60, 3)), *(float(a) for a in range(60, 181, 5)))
"""Their wind angles [degrees]; closer where a beat is decided."""


class SpeedModel(Protocol):
    """How fast a yacht sails, alike on both tacks.

    Zero in a calm; zero dead into the wind unless the figures say otherwise; beyond the figures as
    `seacruise.yacht._curves` tells.
    """

    @property
    def name(self) -> str:
        """The yacht, as shown to the sailor."""
        ...

    def speed(self, tws: ArrayLike, twa: ArrayLike) -> Array:
        """Boat speed [m/s] at wind speeds [m/s] and angles [degrees] that broadcast; NaN for NaN."""
        ...

    def to_table(self) -> Polar:
        """Make the table that routing, hull and files work with."""
        ...


class Box(Protocol):
    """Speed [m/s] within the winds [m/s] and angles [degrees] that there are figures for."""

    def __call__(self, tws: Array, twa: Array) -> Array:
        """Evaluate it at arrays of one shape."""
        ...


def go_on(
    inside: Box, tws: ArrayLike, twa: ArrayLike, *, winds: tuple[float, float], angles: tuple[float, float]
) -> Array:
    """Evaluate a model within its figures and go on beyond them as a table does.

    Parameters
    ----------
    inside
        The model; called with arrays of one shape, all within the limits.
    tws, twa
        True wind speed [m/s] and angle [degrees].
    winds, angles
        Least and greatest wind [m/s] and angle [degrees] that the model has figures for.
    """
    wind, angle = np.broadcast_arrays(np.asarray(tws, dtype=np.float64), fold_angle(twa))
    known = ~(np.isnan(wind) | np.isnan(angle))
    speed = np.full(wind.shape, np.nan)
    w, a = np.maximum(wind[known], 0.0), angle[known]
    value = np.asarray(inside(np.clip(w, *winds), np.clip(a, *angles)))
    if winds[0] > 0.0:
        value = value * np.clip(w / winds[0], 0.0, 1.0)
    least, greatest = angles
    if least > 0.0:
        start = ramp_start(least)
        value = value * np.clip((a - start) / (least - start), 0.0, 1.0)
    beyond = a > greatest
    if greatest > 91.0:
        value = np.where(beyond, value * np.cos(np.radians(greatest)) / np.cos(np.radians(a)), value)
    else:
        value = np.where(beyond, value * np.clip(greatest + 1.0 - a, 0.0, 1.0), value)
    speed[known] = np.maximum(value, 0.0)
    return speed


def tabulate(
    model: SpeedModel, *, winds: tuple[float, float], angles: tuple[float, float], path: Path | None = None
) -> Polar:
    """Make a table of a model on the usual grid, within its figures and with their ends.

    Parameters
    ----------
    winds, angles
        Least and greatest wind [m/s] and angle [degrees] that the model has figures for.
    """
    tws = _axis(np.array(GRID_TWS_KN) * MS_PER_KNOT, *winds, closest=0.5 * MS_PER_KNOT)
    twa = _axis(np.array(GRID_TWA), *angles, closest=1.0)
    source = getattr(model, "source", "")
    return Polar(model.name, tws, twa, model.speed(tws, twa[:, np.newaxis]), source=source, path=path)


def _axis(grid: Array, least: float, greatest: float, *, closest: float) -> Array:
    """Values of a grid between two ends, and the ends; none of them closer to an end than ``closest``."""
    between = grid[(grid > least + closest) & (grid < greatest - closest)]
    return np.unique(np.concatenate(([least], between, [greatest])))
