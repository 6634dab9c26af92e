"""Land anywhere in the world: the 1 km mask of the package ``global-land-mask``.

The package is never imported: that takes about 5 s and 940 MB. Its compressed file is read as a stream
instead - rows above the area skipped, columns beside it dropped - which takes a fraction of a second.
"""

from __future__ import annotations

import importlib.util
import zipfile
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError

MASK_FILE: Final = "globe_combined_mask_compressed.npz"
ROWS: Final = 21_600
COLUMNS: Final = 43_200
CELLS_PER_DEGREE: Final = 120
_ROWS_AT_ONCE: Final = 120


def mask_path() -> Path:
    """Where the installed package keeps its mask."""
    spec = importlib.util.find_spec("global_land_mask")
    if spec is None or not spec.submodule_search_locations:
        raise InputError(
            "The package global-land-mask is not installed; install SeaCruise again with pip or make."
        )
    return Path(next(iter(spec.submodule_search_locations))) / MASK_FILE


def read_land(south: float, west: float, north: float, east: float) -> NDArray[np.bool_]:
    """Land of a rectangle of whole degrees, straight from the compressed file.

    Returns
    -------
    numpy.ndarray
        ``((north - south) * 120, (east - west) * 120)``, ``True`` for land; row 0 is the northernmost,
        cell ``[r, c]`` covers latitudes ``north - (r + 1) / 120`` to ``north - r / 120``. Lakes are land.
    """
    first, last = (90 - round(north)) * CELLS_PER_DEGREE, (90 - round(south)) * CELLS_PER_DEGREE
    columns = (
        np.arange(round(west) * CELLS_PER_DEGREE, round(east) * CELLS_PER_DEGREE) + COLUMNS // 2
    ) % COLUMNS
    land = np.ones((last - first, columns.size), dtype=bool)
    with zipfile.ZipFile(mask_path()) as archive, archive.open("mask.npy") as stream:
        np.lib.format.read_magic(stream)
        shape, _, dtype = np.lib.format.read_array_header_1_0(stream)
        if shape != (ROWS, COLUMNS) or dtype != np.dtype(bool):
            raise InputError(f"{MASK_FILE} is not the mask of 21600 x 43200 cells that SeaCruise can read.")
        for row in range(0, last, _ROWS_AT_ONCE):
            block = stream.read(_ROWS_AT_ONCE * COLUMNS)
            if row + _ROWS_AT_ONCE <= first:
                continue
            ocean = np.frombuffer(block, dtype=bool).reshape(-1, COLUMNS)
            top = max(first, row)
            bottom = min(last, row + ocean.shape[0])
            land[top - first : bottom - first] = ~ocean[top - row : bottom - row][:, columns]
    return land
