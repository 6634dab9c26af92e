"""Make ``assets/coast`` from the tiled OpenStreetMap land of the Baltic.

Run once by a developer, never by the program: ``python tools/make_coast.py LAND.wkb assets/coast``.

``LAND.wkb`` is a WKB GeometryCollection of land polygons, simplified to 100 m and cut into tiles of
0.25 x 0.125 degrees over 9-31 E, 53-66 N (from the npm package ``@geo-maps/earth-lands-100m`` 0.6.0;
data (c) OpenStreetMap contributors, ODbL). Two files come out:

``baltic.npz``
    the tiles themselves, for every question of the kind "does this leg cross land";
``chart.npz``
    the tiles joined and thinned to three levels of detail, for drawing.

Coordinates are stored as differences of whole millionths of a degree, which compress to a fifth.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import shapely

UNITS_PER_DEGREE = 1_000_000
CHART_TOLERANCES_DEG = (0.02, 0.006, 0.0)
CHART_SMALLEST_DEG2 = (1e-3, 6e-5, 0.0)
CHART_SMALLEST_LAKE_DEG2 = (5e-2, 1e-2, 1e-3)


def packed(polygons: np.ndarray) -> dict[str, np.ndarray]:
    """Ragged arrays of polygons: coordinate differences, ring offsets, polygon offsets."""
    _, coords, (rings, parts) = shapely.to_ragged_array(polygons)
    whole = np.round(coords * UNITS_PER_DEGREE).astype(np.int32)
    return {
        "deltas": np.diff(whole, axis=0, prepend=np.zeros((1, 2), np.int32)),
        "rings": rings.astype(np.int32),
        "polygons": parts.astype(np.int32),
    }


def chart_polygons(land: np.ndarray, tolerance: float, smallest: float, smallest_lake: float) -> np.ndarray:
    """Thin joined land for drawing: Douglas-Peucker, small islands and (larger) lakes left out.

    A yacht on the Baltic steers by islands, never by lakes: those are there to look familiar.
    """
    kept = land[shapely.area(land) >= smallest]
    if tolerance > 0:
        kept = shapely.simplify(kept, tolerance)
    out = []
    for polygon in shapely.get_parts(kept):
        holes = [ring for ring in polygon.interiors if shapely.area(shapely.polygons(ring)) >= smallest_lake]
        out.append(shapely.Polygon(polygon.exterior, holes))
    return np.array([p for p in out if not p.is_empty], dtype=object)


def main(source: str, target: str) -> None:
    """Read the tiles, write both files."""
    folder = Path(target)
    folder.mkdir(parents=True, exist_ok=True)
    tiles = shapely.get_parts(shapely.from_wkb(Path(source).read_bytes()))
    np.savez_compressed(folder / "baltic.npz", allow_pickle=False, **packed(tiles))
    # A hair of growth closes the seams between tiles that were cut with rounding.
    joined = shapely.get_parts(shapely.union_all(shapely.buffer(tiles, 2e-6, join_style="mitre")))
    arrays: dict[str, np.ndarray] = {}
    details = zip(CHART_TOLERANCES_DEG, CHART_SMALLEST_DEG2, CHART_SMALLEST_LAKE_DEG2, strict=True)
    for level, (tolerance, smallest, smallest_lake) in enumerate(details):
        for key, value in packed(chart_polygons(joined, tolerance, smallest, smallest_lake)).items():
            arrays[f"{key}{level}"] = value
    np.savez_compressed(folder / "chart.npz", allow_pickle=False, **arrays)


if __name__ == "__main__":
    main(*sys.argv[1:3])
