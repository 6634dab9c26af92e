"""The cache of rasters: broken files are made again, and nobody is stopped by a cache."""

from __future__ import annotations

import io
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from seacruise.sea import Sea, raster
from seacruise.sea.raster import WaterRaster
from tests.routing.worlds import cache_dir_of

# A corner of the Baltic (fine coast) is drawn in a fraction of a second.
BOUNDS = (54.0, 13.0, 55.0, 15.0)


@pytest.fixture(scope="module")
def good() -> WaterRaster:
    return raster.build(*BOUNDS)


def assert_same(one: WaterRaster, two: WaterRaster) -> None:
    assert (one.x0, one.y0, one.cell) == (two.x0, two.y0, two.cell)
    for part in ("cells", "first", "shores"):
        np.testing.assert_array_equal(getattr(one, part), getattr(two, part))


def files_in(cache: Path) -> list[Path]:
    return sorted(p for p in cache.rglob("*") if p.is_file())


def test_what_was_drawn_is_read_again(
    tmp_path: Path, good: WaterRaster, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert_same(raster.load(*BOUNDS, cache_dir=tmp_path), good)
    monkeypatch.setattr(raster, "build", lambda *bounds: pytest.fail("drawn again"))
    again = raster.load(*BOUNDS, cache_dir=tmp_path)
    assert_same(again, good)
    assert isinstance(again.cells, np.memmap), "mapped, not read"


def other_array(data: bytes) -> bytes:
    """A sound file of another shape, as an older version might have left."""
    stream = io.BytesIO()
    np.save(stream, np.zeros((3, 3), dtype=np.float64))
    return stream.getvalue()


DAMAGE = {
    "empty": lambda data: b"",
    "truncated in the header": lambda data: data[:40],
    "truncated in the data": lambda data: data[: len(data) // 2],
    "one byte short": lambda data: data[:-1],
    "noise": lambda data: bytes(range(256)) * 8,
    "another array": other_array,
}


@pytest.mark.parametrize("part", ["cells", "first", "shores"])
@pytest.mark.parametrize("damage", DAMAGE)
def test_a_broken_file_is_made_again(part: str, damage: str, tmp_path: Path, good: WaterRaster) -> None:
    raster.load(*BOUNDS, cache_dir=tmp_path)
    (path,) = tmp_path.rglob(f"{part}.npy")
    path.write_bytes(DAMAGE[damage](path.read_bytes()))
    assert_same(raster.load(*BOUNDS, cache_dir=tmp_path), good)
    # ... and what lies there afterwards is sound.
    assert_same(raster.load(*BOUNDS, cache_dir=tmp_path), good)


def test_a_missing_file_is_made_again(tmp_path: Path, good: WaterRaster) -> None:
    raster.load(*BOUNDS, cache_dir=tmp_path)
    next(tmp_path.rglob("shores.npy")).unlink()
    assert_same(raster.load(*BOUNDS, cache_dir=tmp_path), good)
    assert len(files_in(tmp_path)) == 4  # three parts and their seal


def test_a_cache_that_cannot_be_written_stops_nobody(tmp_path: Path, good: WaterRaster) -> None:
    # A file where the folder should be: no user may write there, not even root.
    blocked = tmp_path / "cache"
    blocked.write_text("in the way")
    assert_same(raster.load(*BOUNDS, cache_dir=blocked), good)
    assert blocked.read_text() == "in the way"


def test_a_full_disk_stops_nobody_and_leaves_nothing_behind(
    tmp_path: Path, good: WaterRaster, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*args: object, **kwargs: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(np, "save", full)
    assert_same(raster.load(*BOUNDS, cache_dir=tmp_path), good)
    assert files_in(tmp_path) == []


def test_two_processes_at_once_agree(tmp_path: Path, good: WaterRaster) -> None:
    code = (
        "import sys, zlib; from pathlib import Path; from seacruise.sea import raster;"
        f"r = raster.load(*{BOUNDS}, cache_dir=Path(sys.argv[1]));"
        "print(zlib.crc32(r.cells.tobytes()), zlib.crc32(r.shores.tobytes()))"
    )
    command = [sys.executable, "-c", code, str(tmp_path)]
    both = [
        subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) for _ in range(2)
    ]
    answers = [p.communicate(timeout=120) for p in both]
    assert [p.returncode for p in both] == [0, 0], answers
    assert answers[0][0] == answers[1][0]
    assert_same(raster.load(*BOUNDS, cache_dir=tmp_path), good)
    assert len(files_in(tmp_path)) == 4  # three parts and their seal


def test_all_passages_of_the_baltic_share_one_raster(
    baltic: Sea, tmp_path_factory: pytest.TempPathFactory
) -> None:

    other = Sea.around(
        (54.3, 59.3), (10.2, 18.1), margin_deg=3.0, cache_dir=cache_dir_of(tmp_path_factory.getbasetemp())
    )
    assert other.water is baltic.water


@pytest.mark.parametrize("part", ["cells", "first", "shores"])
def test_a_flipped_bit_is_found(part: str, tmp_path: Path, good: WaterRaster) -> None:
    raster.load(*BOUNDS, cache_dir=tmp_path)
    (path,) = tmp_path.rglob(f"{part}.npy")
    data = bytearray(path.read_bytes())
    data[len(data) * 3 // 4] ^= 0x10
    path.write_bytes(data)
    assert_same(raster.load(*BOUNDS, cache_dir=tmp_path), good)


def test_a_copied_cache_is_used(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    raster.load(*BOUNDS, cache_dir=tmp_path / "one")
    shutil.copytree(tmp_path / "one", tmp_path / "two", copy_function=shutil.copyfile)
    monkeypatch.setattr(raster, "build", lambda *bounds: pytest.fail("was drawn again"))
    assert raster.load(*BOUNDS, cache_dir=tmp_path / "two").cells.size


def test_rasters_of_older_versions_are_cleared_away(tmp_path: Path) -> None:
    old = tmp_path / "water-v1_53_9_66_31"
    old.mkdir()
    (old / "cells.npy").write_bytes(b"old")
    raster.load(*BOUNDS, cache_dir=tmp_path)
    assert not old.exists()
