"""Memory: what is not taken, and what is given back while nothing is searched."""

from __future__ import annotations

import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from seacruise.desktop import thrift
from seacruise.desktop.jobs import GarbageKeeper, JobRunner
from seacruise.routing import levels
from seacruise.sea import raster

ON_LINUX = pytest.mark.skipif(sys.platform != "linux", reason="tells of mapped files as Linux does")


def resident_kb(part_of_path: str) -> int:
    """Memory in which files of that name lie [kB]."""
    found, counts = 0, False
    for line in Path("/proc/self/smaps").read_text(encoding="utf-8", errors="replace").splitlines():
        name, _, value = line.partition(":")
        if "-" in name and " " in name:
            counts = part_of_path in line
        elif counts and name == "Rss":
            found += int(value.split()[0])
    return found


def test_qt_is_imported_without_reading_the_text_of_every_module() -> None:
    script = (
        "import linecache, sys\n"
        "from seacruise.desktop.thrift import import_qt_plainly\n"
        "import_qt_plainly()\n"
        "import seacruise.settings, wave, html.parser\n"
        "from PySide6.QtCore import QObject\n"
        "assert 'PySide6.QtCore' in sys.modules and QObject().parent() is None\n"
        "print(__import__.__name__ != '__feature_import__', len(linecache.cache))\n"
    )
    said = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert said.stdout.split() == ["True", "0"]


@ON_LINUX
def test_a_mapped_sea_leaves_the_memory_and_is_read_again(tmp_path: Path) -> None:
    sea = raster.load(54.0, 13.0, 55.0, 15.0, cache_dir=tmp_path)
    whole = {part: np.array(getattr(sea, part)) for part in ("cells", "first", "shores")}
    folder = str(tmp_path)
    assert resident_kb(folder) * 1024 >= whole["cells"].nbytes
    thrift.give_back()
    assert resident_kb(folder) == 0
    for part, before in whole.items():
        np.testing.assert_array_equal(getattr(sea, part), before)


@ON_LINUX
def test_the_compilers_code_leaves_the_memory_and_kernels_run_on() -> None:
    from numba import njit

    from seacruise.sea import _kernels as k

    assert njit(lambda one: one + 1)(1) == 2, "the compiler has been at work"
    cells = np.full((40, 40), k.WATER, dtype=np.uint8)
    cells[18:22, 5:30] = k.LAND
    before = cells.copy()
    k.count_free_cells(before)
    loaded = resident_kb("libllvmlite")
    thrift.give_back()
    assert resident_kb("libllvmlite") < loaded
    after = cells.copy()
    k.count_free_cells(after)
    np.testing.assert_array_equal(after, before)
    # Another version of a kernel asks the compiler itself.
    k.count_free_cells(np.asfortranarray(cells))


class Heavy:
    """As much of a lattice as its cache knows."""

    def __init__(self, nbytes: int) -> None:
        self.nbytes = nbytes


def test_the_lattices_used_last_are_kept_at_rest(monkeypatch: pytest.MonkeyPatch) -> None:
    cache, made = levels.LatticeCache(), []

    def build(*_: object, nbytes: int) -> Heavy:
        made.append(nbytes)
        return Heavy(nbytes)

    class Water:
        cells = np.zeros(1)

    class Sound:
        water = Water()

    monkeypatch.setattr("seacruise.routing.lattice.build", build)
    mb = 1_000_000
    for number, size in enumerate((4, 10, 40, 9, 6)):
        ends = ((float(number), 0.0), (0.0, 0.0))
        cache.get(("kind",), Sound(), ends, lambda size=size: {"nbytes": size * mb})  # type: ignore[arg-type, misc]
    assert made == [4 * mb, 10 * mb, 40 * mb, 9 * mb, 6 * mb]
    levels.let_go()
    for number, size in ((4, 6), (3, 9)):
        ends = ((float(number), 0.0), (0.0, 0.0))
        kept = cache.get(("kind",), Sound(), ends, lambda: pytest.fail("was forgotten"))  # type: ignore[arg-type]
        assert kept.nbytes == size * mb
    cache.get(("kind",), Sound(), ((2.0, 0.0), (0.0, 0.0)), lambda: {"nbytes": 1})  # type: ignore[arg-type]
    assert made[-1] == 1, "too much to be kept while nothing is searched"


def test_the_window_rests_once_all_workers_have_ended(qtbot: QtBot) -> None:
    keeper, runner, gate = GarbageKeeper(lambda: False), JobRunner("test"), threading.Event()
    keeper.start()
    try:
        runner.run_job(lambda _job: gate.wait(30))
        # Nobody awaits it any more, and it works on.
        runner.cancel()
        with pytest.raises(Exception, match="waitUntil"):
            qtbot.waitUntil(lambda: keeper.is_at_rest, timeout=400)
        gate.set()
        qtbot.waitUntil(lambda: keeper.is_at_rest, timeout=20_000)
    finally:
        gate.set()
        keeper.stop()
        runner.shut_down()
