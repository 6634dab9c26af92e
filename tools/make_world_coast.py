"""Make ``assets/coast/world.npz``, the coarse coast of the whole world, from the mask that routing uses.

Run once by a developer, never by the program: ``python tools/make_world_coast.py assets/coast``.

Outside the Baltic passages are kept off land by the 1 km mask of the package ``global-land-mask`` (MIT; made
from the GLOBE elevations of NOAA, public domain). The chart draws the same land there, thinned to about
2 km: what it shows is what the router knows. Cells of 4 x 4 are joined to the share of land in them, the
line of one half is their shore, and what is smaller than about 12 square kilometres is left out. With it
comes a raster of 0.2 degrees that tells land from water at a glance.
"""

from __future__ import annotations

import sys
from itertools import pairwise
from pathlib import Path
from typing import cast

import contourpy
import numpy as np
import shapely

from seacruise.sea.globe import CELLS_PER_DEGREE, read_land

NORTH, SOUTH = 84, -66
JOINED = 4
TOLERANCE_DEG = 0.02
SMALLEST_DEG2, SMALLEST_LAKE_DEG2 = 1e-3, 5e-2
UNITS_PER_DEGREE = 500
RASTER = 6
"""Joined cells along a side of the raster's: 0.2 degrees."""


def land_share() -> np.ndarray:
    """Share of land in cells of `JOINED` x `JOINED`, northernmost row first."""
    strips = []
    for north in range(NORTH, SOUTH, -10):
        land = read_land(max(north - 10, SOUTH), -180, north, 180)
        cells = land.reshape(land.shape[0] // JOINED, JOINED, -1, JOINED)
        strips.append(cells.mean(axis=(1, 3), dtype=np.float32))
    return np.concatenate(strips)


def shores(share: np.ndarray) -> np.ndarray:
    """Polygons of land, lon and lat [degrees]."""
    step = JOINED / CELLS_PER_DEGREE
    lat = NORTH - step * (np.arange(share.shape[0]) + 0.5)
    lon = -180 + step * (np.arange(share.shape[1]) + 0.5)
    contours = contourpy.contour_generator(lon, lat, share, fill_type="OuterOffset")
    points, offsets = cast("tuple[list[np.ndarray], list[np.ndarray]]", contours.filled(0.5, 2.0))
    land = []
    for ring, ends in zip(points, offsets, strict=True):
        parts = [ring[a:b] for a, b in pairwise(ends)]
        land.append(shapely.Polygon(parts[0], parts[1:]))
    return np.array(land, dtype=object)


def thinned(land: np.ndarray) -> np.ndarray:
    """Leave out islets, ponds, and points that hardly bend the shore."""
    kept = shapely.simplify(land[shapely.area(land) >= SMALLEST_DEG2], TOLERANCE_DEG)
    out = []
    for polygon in shapely.get_parts(kept):
        lakes = [r for r in polygon.interiors if shapely.area(shapely.polygons(r)) >= SMALLEST_LAKE_DEG2]
        out.append(shapely.Polygon(polygon.exterior, lakes))
    return np.array([polygon for polygon in out if not polygon.is_empty], dtype=object)


def main(target: str) -> None:
    """Write the asset."""
    share = land_share()
    _, coords, (rings, polygons) = shapely.to_ragged_array(thinned(shores(share)))
    blocks = share.reshape(share.shape[0] // RASTER, RASTER, -1, RASTER).mean(axis=(1, 3))
    whole = np.round(coords * UNITS_PER_DEGREE).astype(np.int32)
    np.savez_compressed(
        Path(target) / "world.npz",
        allow_pickle=False,
        deltas=np.diff(whole, axis=0, prepend=np.zeros((1, 2), np.int32)),
        rings=rings.astype(np.int32),
        polygons=polygons.astype(np.int32),
        raster=np.packbits(blocks > 0.5, axis=1),
    )


if __name__ == "__main__":
    main(*sys.argv[1:2])
