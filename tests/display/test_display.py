"""The real program, by mouse and keys, from an empty form to a route in a plotter's file."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtGui import QImage

from tests.display.conftest import Program, Screen

pytestmark = pytest.mark.display

ROUTE_COLOURS = ("#f7d13d", "#fca636", "#ee7b51", "#d5536f", "#a82296", "#6a00a8", "#26066e")
CHART = (360, 90, 920, 480)


def shot(screen: Screen, folder: Path) -> QImage:
    """What the screen shows."""
    target = folder / "screen.png"
    code = (
        "import sys; from PySide6.QtWidgets import QApplication; app = QApplication([]);"
        "app.primaryScreen().grabWindow(0).save(sys.argv[1])"
    )
    subprocess.run([sys.executable, "-c", code, str(target)], env=screen.env, check=True, timeout=60)
    return QImage(str(target))


def pixels(image: QImage, colours: tuple[str, ...]) -> int:
    """Pixels of the chart that have one of these colours."""
    left, top, right, bottom = CHART
    return sum(
        image.pixelColor(x, y).name() in colours for x in range(left, right) for y in range(top, bottom)
    )


def wait_for(condition: Callable[[], bool], seconds: float, what: str) -> None:
    deadline = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < deadline, f"{what} did not happen within {seconds:.0f} s"
        time.sleep(0.5)


def test_from_a_click_to_a_route(screen: Screen, home: Path, tmp_path: Path) -> None:
    program = Program(
        screen,
        *("--forecast", "sample", "--depart", "2016-11-20T06:00Z", "--yacht", "Bavaria 46 Cruiser"),
        *("--size", "1280x800"),
    )
    land = "#efe2bd"
    wait_for(lambda: pixels(shot(screen, tmp_path), (land,)) > 1000, 30, "the coast on the chart")
    screen.click(150, 105, times=3)
    screen.type("gdynia")
    screen.keys("Escape")
    screen.click(150, 156, times=3)
    screen.type("visby")
    screen.keys("Escape")
    before = pixels(shot(screen, tmp_path), ROUTE_COLOURS)
    screen.click(127, 431)
    wait_for(lambda: pixels(shot(screen, tmp_path), ROUTE_COLOURS) > before + 150, 60, "a route on the chart")
    code, error = program.end()
    assert code == 0, error
    assert "Traceback" not in error
    assert "Visby" in (home / "data" / "window.ini").read_text(encoding="utf-8")


def test_closing_while_it_computes(screen: Screen, home: Path, tmp_path: Path) -> None:
    program = Program(
        screen,
        *("--from", "Gdynia", "--to", "Luleå", "--forecast", "sample", "--depart", "2016-11-20T06:00Z"),
        *("--size", "1280x800"),
    )
    time.sleep(2.0)
    screen.keys("ctrl+Return")
    time.sleep(0.3)
    begun = time.monotonic()
    code, error = program.end()
    assert code == 0, error
    assert "Traceback" not in error
    assert time.monotonic() - begun < 20.0
