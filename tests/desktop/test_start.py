"""The start: what the first painting does without comes after it, and nobody notices."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final

import pytest
from PySide6.QtCore import QRect, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from seacruise.desktop import app as program
from seacruise.desktop.app import FirstPaint
from seacruise.desktop.style import apply_style
from seacruise.desktop.window import MainWindow
from seacruise.settings import Settings
from tests.desktop.conftest import Heart

REPOSITORY: Final = Path(__file__).resolve().parents[2]

UNWANTED: Final = (
    *(
        "numba",
        "llvmlite",
        "shapely",
        "matplotlib",
        "scipy",
        "netCDF4",
        "requests",
        "urllib3",
        "ssl",
        "keyring",
    ),
    *("sqlite3", "msgspec", "logging.handlers", "numpy.ma", "numpy.random", "numpy.fft"),
    *("seacruise.narrative", "seacruise.passage", "seacruise.reach", "seacruise.weather.source"),
    *(
        "seacruise.desktop.pages.departures_page",
        "seacruise.desktop.pages.reach_page",
        "seacruise.desktop.guide",
    ),
)
"""What the first painting of the window has no use for."""


def test_the_program_paints_its_window_before_it_loads_anything_else() -> None:
    code = f"""
import os, sys
from benchmarks import first_frame

def report():
    print([name for name in {UNWANTED!r} if name in sys.modules], flush=True)
    os._exit(0)

first_frame.report = report
first_frame.command.qt_trouble = first_frame.watch
sys.argv[1:] = ["window"]
sys.exit(first_frame.main())
"""
    answer = subprocess.run(
        [sys.executable, "-W", "error", "-c", code],
        cwd=REPOSITORY,
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
    )
    assert answer.returncode == 0, answer.stderr
    assert answer.stdout.strip() == "[]"


def test_loading_begins_when_the_window_has_been_painted(app: QApplication, qtbot: QtBot) -> None:
    window, seen = QWidget(), []
    qtbot.addWidget(window)
    painted = FirstPaint(window)
    painted.done.connect(lambda: seen.append(window.isVisible()))
    qtbot.wait(30)
    assert not seen
    with qtbot.waitSignal(painted.done, timeout=5_000):
        window.show()
    window.update()
    qtbot.wait(30)
    assert seen == [True]


def test_a_window_that_is_not_to_be_seen_is_loaded_all_the_same(
    app: QApplication, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Started minimised, or on another desktop."""
    monkeypatch.setattr(FirstPaint, "_PATIENCE_MS", 20)
    window, seen = QWidget(), []
    qtbot.addWidget(window)
    FirstPaint(window).done.connect(lambda: seen.append(True))
    qtbot.waitUntil(lambda: bool(seen), timeout=5_000)
    window.show()
    qtbot.waitExposed(window)
    qtbot.wait(30)
    assert seen == [True]


@pytest.fixture
def undressed(app: QApplication) -> Iterator[QApplication]:
    """A program that has not put its style sheet on yet, as when it starts."""
    app.setStyleSheet("")
    app.setProperty("light", None)
    yield app
    apply_style(app)


def _places(window: MainWindow) -> dict[str, QRect]:
    named = ("form", "chart", "side", "pane", "splitter")
    parts: dict[str, QWidget] = {name: getattr(window, name) for name in named}
    parts |= {"status": window.statusBar(), "head": window.pane.head, "bar": window.chart.time_bar}
    return {
        name: QRect(part.mapTo(window, part.rect().topLeft()), part.size()) for name, part in parts.items()
    }


def test_a_window_dressed_after_it_is_made_looks_as_one_dressed_before(
    undressed: QApplication, qtbot: QtBot, settings: Settings
) -> None:
    def shown(window: MainWindow) -> dict[str, QRect]:
        qtbot.addWidget(window)
        window.resize(1280, 800)
        window.show()
        qtbot.waitExposed(window)
        QApplication.processEvents()
        return _places(window)

    late = MainWindow(settings)
    program._dress(undressed, late)
    places = shown(late)
    assert undressed.property("light") == "day"
    assert places == shown(MainWindow(settings))
    late.pane.take_room()
    QApplication.processEvents()
    assert _places(late) == places


def test_a_light_that_was_remembered_is_kept_when_the_window_is_dressed(
    undressed: QApplication, qtbot: QtBot, settings: Settings
) -> None:
    window = MainWindow(settings)
    qtbot.addWidget(window)
    apply_style(undressed, "night")
    program._dress(undressed, window)
    assert undressed.property("light") == "night"


def test_pages_are_made_when_they_are_wanted(window: MainWindow) -> None:
    assert not any(window.planning.made_pages)
    QTest.keyClick(window, Qt.Key.Key_G, Qt.KeyboardModifier.ControlModifier)
    departures, reach = window.planning.made_pages
    assert departures is not None
    assert reach is None
    assert departures.isVisible()
    window.planning.frame.tabs.setCurrentIndex(1)
    assert window.planning.reach.isVisible()
    assert not departures.isVisible()
    assert window.planning.departures is departures


def test_a_page_made_late_knows_what_was_loaded_before(window: MainWindow) -> None:
    window.menus.choose("light", "night")
    page = window.planning.departures
    assert page.yacht_box.count() > 10
    assert page.matrix.cells.light == "night"
    window.menus.choose("light", "day")
    assert page.matrix.cells.light == "day"


def test_pages_nobody_has_asked_for_yet_are_made_in_steps_that_nobody_feels(
    window: MainWindow, qtbot: QtBot
) -> None:
    with Heart() as heart:
        window.planning.prepare()
        qtbot.waitUntil(lambda: None not in window.planning.made_pages, timeout=20_000)
    assert heart.worst_s < Heart.LIMIT_S
    assert not window.planning.frame.is_open


def test_a_window_closed_while_its_pages_are_prepared_makes_none(
    make_window: Callable[..., MainWindow], qtbot: QtBot
) -> None:
    window = make_window()
    window.planning.prepare()
    window.close()
    qtbot.wait(400)
    assert window.planning.made_pages == (None, None)
