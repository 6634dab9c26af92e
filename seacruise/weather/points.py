"""Which places to ask when requests are counted, and how a few answers become a whole grid."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.weather.grids import Box

Array = NDArray[np.float64]
Nodes = NDArray[np.int64]
IsWater = Callable[[Any, Any], NDArray[np.bool_]]

MODEL_STEP_DEG: Final = 0.25
"""Step of the models behind the services; nodes lie on multiples of it, and asking denser tells nothing."""

_MAX_CELLS: Final = 40


@dataclass(frozen=True, slots=True, eq=False)
class PointPlan:
    """A coarse regular grid over the area of a passage, and those of its nodes that are asked.

    Attributes
    ----------
    lat, lon
        ``(y,)`` and ``(x,)`` degrees, increasing and evenly spaced, at least two each.
    rows, columns
        ``(n,)`` indices of the nodes to ask.
    """

    lat: Array
    lon: Array
    rows: NDArray[np.int64]
    columns: NDArray[np.int64]

    @property
    def places(self) -> tuple[tuple[float, float], ...]:
        """Latitude and longitude [degrees] of each node to ask."""
        return tuple(
            (float(self.lat[row]), float(self.lon[column]))
            for row, column in zip(self.rows, self.columns, strict=True)
        )


def plan_points(box: Box, *, most: int, is_water: IsWater | None = None) -> PointPlan:
    """Choose the finest regular grid over an area that needs no more than ``most`` requests.

    Only nodes at sea are asked, so a grid over a narrow sea may be finer than one over open water. Of all
    grids that can be paid for, the one with the shortest diagonal of its cells on the ground is taken.

    Parameters
    ----------
    box
        South, west, north, east [degrees].
    most
        Requests at most, 1 or more.
    is_water
        Tells for arrays of latitudes and longitudes which are water; without it all nodes are asked.
    """
    shrink = max(math.cos(math.radians((box[0] + box[2]) / 2)), 0.2)
    all_rows, all_columns = _axes(box[0], box[2]), _axes(box[1], box[3])
    water = _Water(all_rows, all_columns, is_water)
    best: tuple[float, PointPlan] | None = None
    for rows in all_rows:
        for columns in all_columns:
            diagonal = math.hypot(rows[1] - rows[0], (columns[1] - columns[0]) * shrink)
            if best is None or diagonal < best[0]:
                plan = water.plan(rows, columns)
                if 0 < plan.rows.size <= most:
                    best = diagonal, plan
    if best is not None:
        return best[1]
    coarsest = water.plan(all_rows[-1], all_columns[-1])
    if not coarsest.rows.size:
        # between skerries no node may be water; the wind there is still better than none
        return plan_points(box, most=most)
    return _thinned(coarsest, most)


def _axes(low: float, high: float) -> list[Nodes]:
    """List the axes that enclose a span with 1 to `_MAX_CELLS` cells, the finest first."""
    first, last = math.floor(low / MODEL_STEP_DEG + 1e-9), math.ceil(high / MODEL_STEP_DEG - 1e-9)
    span = max(last - first, 1)
    axes = []
    for cells in range(min(span, _MAX_CELLS), 0, -1):
        step = math.ceil(span / cells)
        # what reaches beyond the span reaches beyond both of its ends
        axes.append(first - (cells * step - span) // 2 + step * np.arange(cells + 1))
    return axes


class _Water:
    """Which nodes of all candidate grids are at sea, looked up once: land masks answer in bulk."""

    def __init__(self, all_rows: list[Nodes], all_columns: list[Nodes], is_water: IsWater | None) -> None:
        self._south, self._west = (min(int(axis[0]) for axis in axes) for axes in (all_rows, all_columns))
        north, east = (max(int(axis[-1]) for axis in axes) for axes in (all_rows, all_columns))
        lat = np.arange(self._south, north + 1, dtype=np.float64) * MODEL_STEP_DEG
        lon = np.arange(self._west, east + 1, dtype=np.float64) * MODEL_STEP_DEG
        if is_water is None:
            self._asked = np.ones((lat.size, lon.size), dtype=np.bool_)
        else:
            self._asked = np.asarray(is_water(*np.meshgrid(lat, lon, indexing="ij")), dtype=np.bool_)

    def plan(self, rows: Nodes, columns: Nodes) -> PointPlan:
        """Make a plan of a candidate grid; it may have no node at all."""
        at, beside = np.nonzero(self._asked[np.ix_(rows - self._south, columns - self._west)])
        lat, lon = (np.asarray(axis * MODEL_STEP_DEG, dtype=np.float64) for axis in (rows, columns))
        return PointPlan(lat=lat, lon=lon, rows=at, columns=beside)


def _thinned(plan: PointPlan, most: int) -> PointPlan:
    """Keep some nodes of a grid that cannot be coarser: those that lie farthest from one another."""
    chosen = [0]
    while len(chosen) < most:
        gaps = np.hypot(
            plan.rows[:, None] - plan.rows[chosen][None, :],
            plan.columns[:, None] - plan.columns[chosen][None, :],
        ).min(axis=1)
        chosen.append(int(np.argmax(gaps)))
    order = np.sort(np.array(chosen))
    return PointPlan(lat=plan.lat, lon=plan.lon, rows=plan.rows[order], columns=plan.columns[order])


def spread(plan: PointPlan, answered: NDArray[np.bool_], values: Array) -> Array:
    """Fill a plan's grid from the nodes that answered, weighted by the inverse square of the distance.

    Parameters
    ----------
    answered
        ``(n,)``: which of the plan's nodes have values.
    values
        ``(t, m)``: for the ``m`` nodes that do.

    Returns
    -------
    ndarray
        ``(t, y, x)``; the answering nodes have exactly their own values.

    References
    ----------
    Shepard (1968), doi:10.1145/800186.810616.
    """
    rows, columns = plan.rows[answered], plan.columns[answered]
    shrink = np.cos(np.radians(plan.lat))[:, None, None]
    dlat = plan.lat[:, None, None] - plan.lat[rows]
    dlon = (plan.lon[None, :, None] - plan.lon[columns]) * shrink
    square = dlat**2 + dlon**2
    own = square == 0.0
    weight = np.where(own.any(axis=2, keepdims=True), own, 1.0 / np.where(own, 1.0, square))
    weight /= weight.sum(axis=2, keepdims=True)
    return np.asarray(np.einsum("yxm,tm->tyx", weight, values))
