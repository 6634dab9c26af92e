"""Water as a raster in the Mercator plane, with the free water around each cell.

Two sources are joined: the fine coast where there is one, the global land mask elsewhere. A cell crossed
by a shoreline is only *unsure*: lines over such cells are tested against the shoreline itself
(`seacruise.sea.coast`). Water that is not connected with the open sea - lakes, and harbours that the
coast data close - counts as land.
"""

from __future__ import annotations

import math
import mmap
import shutil
import sys
import tempfile
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final
from weakref import WeakSet

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import EARTH_RADIUS, from_mercator, to_mercator
from seacruise.sea import coast, globe
from seacruise.sea.seal import is_whole, seal

FINE_CELL_M: Final = 300.0
"""Cell of the fine raster [m of the Mercator plane]; 180 m true at 53 N, 122 m at 66 N."""

COARSE_CELL_M: Final = EARTH_RADIUS * math.radians(1 / globe.CELLS_PER_DEGREE)
"""Cell where only the global mask is known [m of the Mercator plane]."""

RASTER_VERSION: Final = 4
_SAMPLES: Final = 97
_PARTS: Final = ("cells", "first", "shores")
_FILES: Final = tuple(f"{part}.npy" for part in _PARTS)

_MAPPED: Final[WeakSet[mmap.mmap]] = WeakSet()


@dataclass(frozen=True, slots=True, eq=False)
class WaterRaster:
    """Classes of cells, see `seacruise.sea._kernels`.

    Attributes
    ----------
    x0, y0
        South-west corner in the Mercator plane [m].
    cell
        Side of a cell [m of the plane].
    cells
        ``(rows, columns)`` uint8, row 0 southernmost.
    first, shores
        Edges of the shoreline sorted into squares of cells, see `seacruise.sea._kernels.bin_shores`.
    """

    x0: float
    y0: float
    cell: float
    cells: NDArray[np.uint8]
    first: NDArray[np.int64]
    shores: NDArray[np.float32]

    @property
    def arrays(self) -> tuple[NDArray[np.uint8], NDArray[np.int64], NDArray[np.float32]]:
        """What the kernels call ``water``."""
        return self.cells, self.first, self.shores

    def lines(
        self, x: NDArray[np.float64], y: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Plane coordinates [m] as coordinates in cells."""
        return (np.asarray(x) - self.x0) / self.cell, (np.asarray(y) - self.y0) / self.cell

    def at(self, x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.uint8]:
        """Values of the cells in which points of the plane lie; 0 outside the raster."""
        column, row = (np.floor(c).astype(np.int64) for c in self.lines(x, y))
        rows, columns = self.cells.shape
        inside = (row >= 0) & (row < rows) & (column >= 0) & (column < columns)
        values = np.zeros(np.broadcast(row, column).shape, dtype=np.uint8)
        values[inside] = self.cells[row[inside], column[inside]]
        return values


def build(south: float, west: float, north: float, east: float) -> WaterRaster:
    """Rasterise the land of a rectangle of whole degrees."""
    from seacruise.sea import _kernels as k

    x0, y0, cell, shape = _frame(south, west, north, east)
    cells = np.full(shape, k.WATER, dtype=np.uint8)
    squares = _squares(shape)
    first, shores = np.zeros(math.prod(squares) + 1, np.int64), np.empty((0, 4), np.float32)
    raster = WaterRaster(x0, y0, cell, cells, first, shores)
    inside_fine = (
        west >= coast.FINE_WEST
        and east <= coast.FINE_EAST
        and south >= coast.FINE_SOUTH
        and north <= coast.FINE_NORTH
    )
    if not inside_fine:
        cells[_global_land(raster, south, west, north, east)] = k.LAND
    if _overlaps_fine(south, west, north, east):
        coords, rings, _ = coast.fine_rings()
        x, y = raster.lines(*to_mercator(coords[:, 1], coords[:, 0]))
        k.draw_polygons(x, y, rings, cells, _fine_window(raster))
        first, shores = k.bin_shores(x, y, rings, squares[1], squares[0])
        raster = replace(raster, first=first, shores=shores)
    k.keep_the_sea(cells, _SAMPLES, np.empty(cells.size // 4 + 1024, dtype=np.int64))
    k.count_free_cells(cells)
    for part in _PARTS:
        # As when mapped from the cache: kernels are compiled for one kind of array only.
        getattr(raster, part).setflags(write=False)
    return raster


def _frame(
    south: float, west: float, north: float, east: float
) -> tuple[float, float, float, tuple[int, int]]:
    """South-west corner [m of the plane], cell and shape of the raster of a rectangle."""
    cell = FINE_CELL_M if _overlaps_fine(south, west, north, east) else COARSE_CELL_M
    (x0, x1), (y0, y1) = (c.tolist() for c in to_mercator([south, north], [west, east]))
    return x0, y0, cell, (math.ceil((y1 - y0) / cell), math.ceil((x1 - x0) / cell))


def _squares(shape: tuple[int, int]) -> tuple[int, int]:
    """Rows and columns of the squares into which the shoreline's edges are sorted."""
    from seacruise.sea import _kernels as k

    return -(-shape[0] // k.BIN), -(-shape[1] // k.BIN)


def _overlaps_fine(south: float, west: float, north: float, east: float) -> bool:
    return (
        west < coast.FINE_EAST
        and east > coast.FINE_WEST
        and south < coast.FINE_NORTH
        and north > coast.FINE_SOUTH
    )


def _global_land(
    raster: WaterRaster, south: float, west: float, north: float, east: float
) -> NDArray[np.bool_]:
    """Cells of which any corner lies on land of the global mask, whose cells are never smaller."""
    land = globe.read_land(south, west, north, east)
    rows, columns = raster.cells.shape
    lat, _ = from_mercator(0.0, raster.y0 + raster.cell * np.arange(rows + 1))
    _, lon = from_mercator(raster.x0 + raster.cell * np.arange(columns + 1), 0.0)
    r = np.clip(np.floor((north - lat) * globe.CELLS_PER_DEGREE).astype(int), 0, land.shape[0] - 1)
    c = np.clip(np.floor((lon - west) * globe.CELLS_PER_DEGREE).astype(int), 0, land.shape[1] - 1)
    corners = land[np.ix_(r, c)]
    return np.asarray(corners[:-1, :-1] | corners[:-1, 1:] | corners[1:, :-1] | corners[1:, 1:])


def _fine_window(raster: WaterRaster) -> tuple[int, int, int, int]:
    """Rows and columns (first, after) of the cells that the fine coast covers whole."""
    (xa, xb), (ya, yb) = raster.lines(
        *to_mercator([coast.FINE_SOUTH, coast.FINE_NORTH], [coast.FINE_WEST, coast.FINE_EAST])
    )
    rows, columns = raster.cells.shape
    return (
        max(0, math.ceil(ya - 1e-6)),
        max(0, min(rows, math.floor(yb + 1e-6))),
        max(0, math.ceil(xa - 1e-6)),
        max(0, min(columns, math.floor(xb + 1e-6))),
    )


def load(south: float, west: float, north: float, east: float, *, cache_dir: Path) -> WaterRaster:
    """Map the raster of a rectangle from the cache, or build and cache it."""
    south, west = math.floor(south), math.floor(west)
    north, east = math.ceil(north), math.ceil(east)
    folder = cache_dir / f"water-v{RASTER_VERSION}_{south}_{west}_{north}_{east}"
    x0, y0, cell, shape = _frame(south, west, north, east)

    def mapped() -> WaterRaster | None:
        if not is_whole(folder, _FILES):
            return None
        try:
            arrays = [np.load(folder / name, mmap_mode="r") for name in _FILES]
            raster = WaterRaster(x0, y0, cell, *arrays)
        except (OSError, ValueError, EOFError):
            return None
        _MAPPED.update(array.base for array in arrays if isinstance(array.base, mmap.mmap))
        return raster if raster.cells.shape == shape else None

    if (known := mapped()) is not None:
        return known
    built = build(south, west, north, east)
    _save(folder, built)
    # Mapped again, what was built need not stay in memory; where nothing could be saved, it must.
    return mapped() or built


def let_go() -> None:
    """Let the system have the memory in which mapped rasters lie: what is looked at again is there again.

    They are files, and a search over half a sea touches 70 MB of them. Where the system knows no such
    advice it takes them anyhow when memory is short.
    """
    advice = getattr(mmap, "MADV_DONTNEED", None)
    if advice is not None and sys.platform == "linux":
        for mapped in tuple(_MAPPED):
            mapped.madvise(advice)


def _save(folder: Path, raster: WaterRaster) -> None:
    """Write a folder beside the target and rename it; a cache that cannot be written stops nobody."""
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder.parent, prefix="water-") as name:
            whole = Path(name) / "whole"
            whole.mkdir()
            for part, file in zip(_PARTS, _FILES, strict=True):
                np.save(whole / file, getattr(raster, part))
            seal(whole, _FILES)
            if folder.exists():
                shutil.rmtree(folder)
            whole.rename(folder)
        for old in folder.parent.glob("water-v*"):
            if not old.name.startswith(f"water-v{RASTER_VERSION}_"):
                shutil.rmtree(old, ignore_errors=True)
    except OSError:
        return
