"""The fine coast of the Baltic: OpenStreetMap land, simplified to 100 m (ODbL, see ``NOTICE``)."""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from seacruise.resources import resource_path

if TYPE_CHECKING:
    import shapely

UNITS_PER_DEGREE = 1_000_000
WORLD_UNITS_PER_DEGREE = 500
WORLD_NORTH, WORLD_RASTER_DEG = 84.0, 0.2

FINE_SOUTH, FINE_WEST, FINE_NORTH, FINE_EAST = 53.0, 9.0, 66.0, 31.0
"""The rectangle that the fine coast covers [degrees]."""

CHART_LEVELS = 3

Ring = NDArray[np.float64]


def _ragged(deltas: NDArray[np.int32]) -> Ring:
    return np.cumsum(deltas, axis=0, dtype=np.int64) / UNITS_PER_DEGREE


def fine_rings() -> tuple[Ring, NDArray[np.int32], NDArray[np.int32]]:
    """Land in tiles of 0.25 x 0.125 degrees, as plain arrays.

    Returns
    -------
    coords, rings, polygons
        ``(n, 2)`` lon and lat [degrees]; offsets of rings into ``coords``; of polygons into ``rings``.
    """
    with np.load(resource_path("assets/coast/baltic.npz")) as data:
        return _ragged(data["deltas"]), data["rings"], data["polygons"]


@lru_cache(maxsize=1)
def fine_land() -> NDArray[Any]:
    """`fine_rings` as ``(n,)`` shapely polygons.

    Tiling is what makes them fast to search. Lakes and wide rivers are water here; `seacruise.sea.raster`
    keeps the water that is connected with the open sea.
    """
    import shapely

    coords, rings, polygons = fine_rings()
    return np.asarray(shapely.from_ragged_array(shapely.GeometryType.POLYGON, coords, (rings, polygons)))


@lru_cache(maxsize=1)
def fine_tree() -> shapely.STRtree:
    """Search tree over `fine_land`, built once a process (about 20 ms)."""
    import shapely

    return shapely.STRtree(fine_land())


def covers(lat: NDArray[np.float64], lon: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Tell which positions [degrees] lie in the rectangle of the fine coast."""
    return (lat >= FINE_SOUTH) & (lat <= FINE_NORTH) & (lon >= FINE_WEST) & (lon <= FINE_EAST)


def land_on_lines(coords: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Tell which lines touch land of the fine coast.

    Parameters
    ----------
    coords
        ``(n, m, 2)``: lon and lat [degrees] of the m points of each of n lines.
    """
    import shapely

    lines = shapely.linestrings(coords)
    hit = np.zeros(len(lines), dtype=bool)
    hit[fine_tree().query(lines, predicate="intersects")[0]] = True
    return hit


def chart_land(level: int) -> list[list[Ring]]:
    """Land for drawing, thinned for a scale; who draws makes something else of it, so it is not kept.

    Parameters
    ----------
    level
        0 for the whole Baltic on a screen (2 km), 1 for a sea (600 m), 2 for a harbour approach (100 m).

    Returns
    -------
    list
        One entry a polygon: its rings, the shore first and then its lakes, each ``(n, 2)`` of lon and
        lat [degrees], closed. Fill them with the even-odd rule.
    """
    with np.load(resource_path("assets/coast/chart.npz")) as data:
        coords = _ragged(data[f"deltas{level}"])
        rings, polygons = data[f"rings{level}"], data[f"polygons{level}"]
    return _by_polygon(coords, rings, polygons)


def world_land() -> list[list[Ring]]:
    """Land of the whole world for drawing, to about 2 km and without islets, as `chart_land` gives it.

    Made by ``tools/make_world_coast.py`` from the mask that `seacruise.sea.globe` reads: beyond the rectangle
    of the fine coast the chart shows what routing knows there.
    """
    with np.load(resource_path("assets/coast/world.npz")) as data:
        coords = np.cumsum(data["deltas"], axis=0, dtype=np.int64) / WORLD_UNITS_PER_DEGREE
        return _by_polygon(coords, data["rings"], data["polygons"])


@lru_cache(maxsize=1)
def _world_raster() -> NDArray[np.bool_]:
    with np.load(resource_path("assets/coast/world.npz")) as data:
        return np.unpackbits(data["raster"], axis=1).astype(bool)


def roughly_ashore(lat: NDArray[np.float64], lon: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Tell which positions ``(n,)`` [degrees] anywhere are on land, to 0.2 degrees: for drawing only."""
    raster = _world_raster()
    row = np.floor((WORLD_NORTH - lat) / WORLD_RASTER_DEG).astype(np.int64).clip(0, raster.shape[0] - 1)
    column = np.floor((lon + 180.0) / WORLD_RASTER_DEG).astype(np.int64) % raster.shape[1]
    return np.asarray(raster[row, column])


def _by_polygon(coords: Ring, rings: NDArray[np.int32], polygons: NDArray[np.int32]) -> list[list[Ring]]:
    shores = [coords[a:b] for a, b in pairwise(rings)]
    return [shores[a:b] for a, b in pairwise(polygons)]
