"""The global mask streamed from its package: the same answers as the package's own lookup."""

from __future__ import annotations

import subprocess
import sys
import zipfile

import numpy as np
import pytest
from numpy.typing import NDArray

from seacruise.sea import globe

CORSICA = (41, 8, 44, 11)
DATE_LINE = (-19, 177, -16, 183)


def ocean_rows(first: int, last: int) -> NDArray[np.bool_]:
    """Rows of the mask, read past the .npy header byte by byte; True is ocean there."""
    with zipfile.ZipFile(globe.mask_path()) as archive, archive.open("mask.npy") as stream:
        header = 10 + int.from_bytes(stream.read(10)[8:], "little")
        stream.seek(header + first * globe.COLUMNS)
        block = stream.read((last - first) * globe.COLUMNS)
    return np.frombuffer(block, dtype=bool).reshape(last - first, globe.COLUMNS)


def index_of_the_package(lat: NDArray[np.float64], lon: NDArray[np.float64]) -> tuple[NDArray[np.int64], ...]:
    """Its lookup: axes from 90 and -180 in steps of 1/120 degree, truncated."""
    return ((lat - 90.0) / -(1 / 120)).astype(int), ((lon + 180.0) / (1 / 120)).astype(int)


@pytest.mark.parametrize("bounds", [CORSICA, DATE_LINE], ids=["Corsica", "across 180 degrees"])
def test_streamed_land_is_the_packages_own(bounds: tuple[int, int, int, int]) -> None:
    south, west, north, east = bounds
    land = globe.read_land(*bounds)
    assert land.shape == ((north - south) * 120, (east - west) * 120)
    rng = np.random.default_rng(5)
    lat, lon = rng.uniform(south, north, 20_000), rng.uniform(west, east, 20_000)
    first = (90 - north) * 120
    rows, columns = index_of_the_package(lat, (lon + 180.0) % 360.0 - 180.0)
    ocean = ocean_rows(first, first + land.shape[0])[rows - first, columns]
    ours = land[np.floor((north - lat) * 120).astype(int), np.floor((lon - west) * 120).astype(int)]
    # At the very border of two cells the two formulas may round to different sides.
    assert np.count_nonzero(ours == ocean) <= 2, "True is land here and ocean there"
    assert 0.05 < ocean.mean() < 1.0


def test_known_places() -> None:
    land = globe.read_land(*CORSICA)

    def at(lat: float, lon: float) -> bool:
        return bool(land[int((CORSICA[2] - lat) * 120), int((lon - CORSICA[1]) * 120)])

    assert at(42.15, 9.1)  # in the mountains of Corsica
    assert not at(43.3, 8.6)  # Ligurian Sea


def test_the_package_is_never_imported() -> None:
    code = (
        "import sys; from seacruise.sea import globe; globe.read_land(43, 8, 44, 9);"
        "assert 'global_land_mask' not in sys.modules; assert 'global_land_mask.globe' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
