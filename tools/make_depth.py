"""Make ``assets/depth/etopo5.npz``, the coarse depths that tint the chart, from ETOPO5.

Run once by a developer, never by the program: ``python tools/make_depth.py ETOPO5.nc assets/depth``.

``ETOPO5.nc`` is a NetCDF of ``lat``, ``lon`` [degrees] and ``elevation(lat, lon)`` [m, negative below the
sea] over the Baltic, cut from the 5 arc-minute relief of NOAA's National Geophysical Data Center (1988,
public domain).

A grid of 9 km knows neither shoals nor channels: a bank of 10 m reads 38 m in it. So it is kept in steps of
2 m, without anything above the sea or deeper than the deepest tint: nobody shall take it for soundings.
"""

from __future__ import annotations

import sys
from pathlib import Path

import netCDF4
import numpy as np

HIGHEST_M, DEEPEST_M, STEP_M = 4, -300, 2
GRID_MIN = 5


def main(source: str, target: str) -> None:
    """Read the relief, write the asset."""
    folder = Path(target)
    folder.mkdir(parents=True, exist_ok=True)
    with netCDF4.Dataset(source) as data:
        lat, lon = (np.asarray(data[name][:], dtype=np.float64) for name in ("lat", "lon"))
        height = np.asarray(data["elevation"][:], dtype=np.float64)
    for axis in (lat, lon):
        if not np.allclose(np.diff(axis), GRID_MIN / 60, atol=1e-4):
            raise SystemExit("The grid is not one of 5 arc-minutes.")
    steps = np.floor(np.clip(height, DEEPEST_M, HIGHEST_M) / STEP_M).astype(np.int16)
    np.savez_compressed(
        folder / "etopo5.npz",
        allow_pickle=False,
        # Neighbours differ by little, which packs to half.
        steps=np.diff(steps, axis=1, prepend=np.zeros((len(lat), 1), np.int16)),
        metres=np.array(STEP_M),
        south=np.array(round(lat[0], 3)),
        west=np.array(round(lon[0], 3)),
        north=np.array(round(lat[-1], 3)),
        east=np.array(round(lon[-1], 3)),
    )


if __name__ == "__main__":
    main(*sys.argv[1:3])
