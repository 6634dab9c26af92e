"""The sea a passage may cross: the places that may be asked there, and the few to ask first."""

from __future__ import annotations

import heapq
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.weather.grids import Box, Place
from seacruise.weather.points import MODEL_STEP_DEG, IsWater

Array = NDArray[np.float64]
Node = tuple[int, int]

MAX_CELLS: Final = 40
"""Cells along an axis at most; over a larger area they are a multiple of the models' step."""

_LAND_COST: Final = 6.0
"""How many times longer a way over land counts: straits are narrower than a cell, so it is not forbidden."""

_HALF_WIDTH: Final = 0.2
"""Distance from the way at which a place matters by 1/e, as a share of the way's length."""

_LEAST_HALF_WIDTH_DEG: Final = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class Ground:
    """Places around a passage.

    Attributes
    ----------
    lat, lon
        ``(y,)`` and ``(x,)`` degrees, increasing and evenly spaced: the grid that the wind will be on.
    places
        ``(n, 2)`` latitude and longitude [degrees] of the nodes of that grid which may be asked.
    weight
        ``(n,)`` from 0 to 1: how much the wind there matters for the passage.
    first
        Indices of the places to ask first, the more important earlier: start and end, then along the way.
    ends
        Indices of start and end; none where only an area is known.
    way
        ``(w, 2)`` degrees, from start to end by water; the middle of the area where only that is known.
    """

    lat: Array
    lon: Array
    places: Array
    weight: Array
    first: tuple[int, ...]
    ends: tuple[int, ...]
    way: Array

    def distances(self, places: Array, others: Array) -> Array:
        """Distance [degrees of latitude] of each place from each of others: ``(n, m)``."""
        return distances(places, others, self.shrink)

    @property
    def shrink(self) -> float:
        """Length of a degree of longitude in degrees of latitude."""
        return shrink_at(self.lat)


def shrink_at(lat: Array) -> float:
    """Length of a degree of longitude in degrees of latitude, in the middle of an axis."""
    return max(math.cos(math.radians(float(lat[0] + lat[-1]) / 2.0)), 0.2)


def distances(places: Array, others: Array, shrink: float) -> Array:
    """Distance [degrees of latitude] of each place ``(n, 2)`` from each of others ``(m, 2)``: ``(n, m)``."""
    return np.asarray(
        np.hypot(places[:, None, 0] - others[None, :, 0], (places[:, None, 1] - others[None, :, 1]) * shrink)
    )


def survey(box: Box, *, ends: tuple[Place, Place] | None, is_water: IsWater | None, first: int) -> Ground:
    """List the places around a passage and choose those to ask first.

    Parameters
    ----------
    box
        South, west, north, east [degrees].
    ends
        Start and end; without them the whole area matters alike.
    is_water
        Tells for arrays of latitudes and longitudes which are water; without it all are asked.
    first
        How many places to ask first, 2 or more.
    """
    lat, lon = _axis(box[0], box[2]), _axis(box[1], box[3])
    nodes = np.stack(np.meshgrid(lat, lon, indexing="ij"), axis=-1)
    water = np.ones(nodes.shape[:2], dtype=np.bool_)
    if is_water is not None:
        water = np.asarray(is_water(nodes[..., 0], nodes[..., 1]), dtype=np.bool_)
    if not water.any():
        # between skerries no node may be water; the wind there is still better than none
        water[:] = True
    places = nodes[water]
    shrink = shrink_at(lat)
    if ends is None or math.hypot(ends[0][0] - ends[1][0], (ends[0][1] - ends[1][1]) * shrink) < 1e-3:
        middle = np.array([[(box[0] + box[2]) / 2, (box[1] + box[3]) / 2]])
        start = int(distances(places, middle, shrink).argmin())
        chosen = _far_apart(places, start, shrink, first)
        return Ground(lat, lon, places, np.ones(len(places)), chosen, (), middle)
    both = distances(places, np.array(ends), shrink).argmin(axis=0)
    way = _way(nodes, water, (places[both[0]], places[both[1]]), shrink)
    away = distances(places, way, shrink).min(axis=1)
    length = float(np.hypot(np.diff(way[:, 0]), np.diff(way[:, 1]) * shrink).sum())
    half_width = max(_LEAST_HALF_WIDTH_DEG, _HALF_WIDTH * length)
    chosen = _along(places, way, shrink, first)
    return Ground(lat, lon, places, np.exp(-((away / half_width) ** 2)), chosen, chosen[:2], way)


def _axis(low: float, high: float) -> Array:
    """Multiples of the models' step, or of a multiple of it, that enclose a span."""
    cells = max(math.ceil((high - low) / MODEL_STEP_DEG), 1)
    step = MODEL_STEP_DEG * math.ceil(cells / MAX_CELLS)
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    return np.arange(first, max(last, first + 1) + 1, dtype=np.float64) * step


def _far_apart(places: Array, start: int, shrink: float, count: int) -> tuple[int, ...]:
    """Pick one place after another, each as far as can be from those before."""
    chosen = [start]
    gaps = np.full(len(places), np.inf)
    while len(chosen) < min(count, len(places)):
        gaps = np.minimum(gaps, distances(places, places[chosen[-1:]], shrink)[:, 0])
        chosen.append(int(gaps.argmax()))
    return tuple(chosen)


def _along(places: Array, way: Array, shrink: float, count: int) -> tuple[int, ...]:
    """Pick start, end, and places evenly along the way between, the middle ones before the outer ones."""
    along = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(way[:, 0]), np.diff(way[:, 1]) * shrink))])
    shares = [0.0, 1.0, *sorted(np.arange(1, count - 1) / (count - 1), key=lambda one: abs(one - 0.5))]
    stops = way[[int(np.abs(along - share * along[-1]).argmin()) for share in shares]]
    nearest = distances(stops, places, shrink).argmin(axis=1)
    return tuple(dict.fromkeys(int(one) for one in nearest))


def _way(nodes: Array, water: NDArray[np.bool_], ends: tuple[Array, Array], shrink: float) -> Array:
    """Find the shortest way from node to node, by water where there is any."""
    start, end = (_node_at(nodes, place) for place in ends)
    step = float(nodes[1, 0, 0] - nodes[0, 0, 0])
    wide = float(nodes[0, 1, 1] - nodes[0, 0, 1]) * shrink
    moves = [(i, j, math.hypot(i * step, j * wide)) for i in (-1, 0, 1) for j in (-1, 0, 1) if i or j]
    cost: dict[Node, float] = {start: 0.0}
    before: dict[Node, Node] = {}
    heap = [(0.0, start)]
    while heap:
        so_far, here = heapq.heappop(heap)
        if here == end:
            break
        if so_far > cost[here]:
            continue
        for i, j, length in moves:
            there = here[0] + i, here[1] + j
            if 0 <= there[0] < water.shape[0] and 0 <= there[1] < water.shape[1]:
                total = so_far + length * (1.0 if water[there] else _LAND_COST)
                if total < cost.get(there, math.inf):
                    cost[there], before[there] = total, here
                    heapq.heappush(heap, (total, there))
    way: list[Node] = [end]
    while way[-1] != start:
        way.append(before[way[-1]])
    return np.array([nodes[node] for node in reversed(way)])


def _node_at(nodes: Array, place: Sequence[float] | Array) -> Node:
    row = int(np.abs(nodes[:, 0, 0] - place[0]).argmin())
    column = int(np.abs(nodes[0, :, 1] - place[1]).argmin())
    return row, column
