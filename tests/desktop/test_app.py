"""The program as it is started: pictures, exit codes, and what it does not load."""

from __future__ import annotations

import errno
import io
import logging
import subprocess
import sys
from logging.handlers import RotatingFileHandler
from pathlib import Path

import pytest
from PySide6.QtGui import QImage

from seacruise.desktop.app import _LogFile

REPOSITORY = Path(__file__).resolve().parents[2]


def run(*words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-W", "error", *words],
        cwd=REPOSITORY,
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
    )


def take_picture(target: Path, *words: str) -> subprocess.CompletedProcess[str]:
    return run("-m", "seacruise", "window", "--screenshot", str(target), "--size", "1100x700", *words)


def test_a_picture_of_a_computed_passage(tmp_path: Path) -> None:
    target = tmp_path / "window.png"
    answer = take_picture(
        target,
        *("--from", "Visby", "--to", "Västervik", "--depart", "2016-11-20T06:00Z"),
        *("--yacht", "Bavaria 46 Cruiser", "--forecast", "sample"),
    )
    assert answer.returncode == 0, answer.stderr
    image = QImage(str(target))
    assert (image.width(), image.height()) == (1100, 700)
    colours = {image.pixel(x, y) for x in range(0, 1100, 3) for y in range(0, 700, 3)}
    assert len(colours) > 60


@pytest.mark.parametrize(
    ("words", "code"),
    [
        (("--from", "Gdynia", "--to", "Gdynia", "--forecast", "sample"), 2),
        (("--from", "Gdynia", "--to", "Atlantis", "--forecast", "sample"), 2),
        (("--from", "Gdynia", "--to", "Visby", "--forecast", "sample", "--depart", "2026-11-20"), 2),
        (("--from", "Gdynia", "--to", "Visby", "--forecast", "stormglass"), 4),
    ],
)
def test_a_picture_of_a_trouble_has_its_exit_code(tmp_path: Path, words: tuple[str, ...], code: int) -> None:
    answer = take_picture(tmp_path / "window.png", *words)
    assert answer.returncode == code, answer.stderr
    assert "Traceback" not in answer.stderr
    assert (tmp_path / "window.png").stat().st_size > 10_000


def test_the_first_picture_loads_nothing_heavy() -> None:
    code = """
import sys
from PySide6.QtWidgets import QApplication
app = QApplication([])
from seacruise.desktop.window import MainWindow
from seacruise.settings import Settings
window = MainWindow(Settings.from_environment())
window.show()
app.processEvents()
print([m for m in ("numba", "shapely", "matplotlib", "netCDF4", "requests", "scipy") if m in sys.modules])
"""
    answer = run("-c", code)
    assert answer.returncode == 0, answer.stderr
    assert answer.stdout.strip() == "[]"


def test_qt_keeps_its_references_to_none() -> None:
    """PySide6 6.12.0 before Python 3.12 loses one a void call, and some thousand calls later the process."""
    code = """
import sys
from PySide6.QtCore import QObject
thing = QObject()
thing.setObjectName("warm")
before = sys.getrefcount(None)
for _ in range(2000):
    thing.setObjectName("a")
print(sys.getrefcount(None) - before)
"""
    answer = run("-c", code)
    assert answer.returncode == 0, answer.stderr
    assert abs(int(answer.stdout)) < 200


def test_a_log_that_cannot_be_written_is_nobodys_trouble(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    class FullDisk(io.StringIO):
        def write(self, _text: str) -> int:
            raise OSError(errno.ENOSPC, "No space left on device")

        def flush(self) -> None:
            self.write("")

        def close(self) -> None:
            self.write("")

    monkeypatch.setattr(RotatingFileHandler, "_open", lambda _handler: FullDisk())
    file = _LogFile(tmp_path / "seacruise.log")
    for _ in range(3):
        file.handle(logging.makeLogRecord({"msg": "something", "levelno": logging.WARNING}))
    file.close()
    assert capsys.readouterr().err == ""
