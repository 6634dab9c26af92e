"""The guide for the first start: three cards, in nobody's way, not shown twice."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel
from pytestqt.qtbot import QtBot

from seacruise.desktop.guide import Guide
from seacruise.desktop.memory import WindowMemory
from seacruise.desktop.window import MainWindow
from tests.desktop.conftest import HeldPlanner


def shown(window: MainWindow) -> bool:
    """Whether a guide is there to be seen."""
    return window.habits.guide is not None and window.habits.guide.isVisible()


def begun(window: MainWindow) -> Guide:
    window.habits.show_guide()
    QApplication.processEvents()
    guide = window.habits.guide
    assert guide is not None
    return guide


def test_it_is_shown_once(make_window: Callable[..., MainWindow], tmp_path: Path) -> None:
    first = make_window(memory=WindowMemory(tmp_path), fill=False)
    first.habits.welcome()
    assert shown(first)
    assert first.habits.guide is not None
    first.habits.guide.skip_button.click()
    assert not shown(first)
    first.close()
    second = make_window(memory=WindowMemory(tmp_path), fill=False)
    second.habits.welcome()
    assert not shown(second)
    second.menus.help.actions()[0].trigger()
    assert shown(second)


def test_not_closed_it_comes_again(make_window: Callable[..., MainWindow], tmp_path: Path) -> None:
    first = make_window(memory=WindowMemory(tmp_path), fill=False)
    first.habits.welcome()
    first.close()
    second = make_window(memory=WindowMemory(tmp_path), fill=False)
    second.habits.welcome()
    assert second.habits.guide is not None


def test_a_picture_has_no_guide(make_window: Callable[..., MainWindow]) -> None:
    window = make_window(fill=False)
    window.habits.welcome()
    assert window.habits.guide is None


def test_three_steps_by_keyboard(window: MainWindow, qtbot: QtBot) -> None:
    window.activateWindow()
    guide = begun(window)
    qtbot.waitUntil(guide.next_button.hasFocus)
    titles = []
    for number in range(3):
        assert guide.step == number
        titles.append(guide.title.text())
        assert guide.title.text() in guide.accessibleDescription()
        QTest.keyClick(guide.next_button, Qt.Key.Key_Space)
    assert len(set(titles)) == 3
    assert not guide.isVisible()
    assert window.form.isAncestorOf(QApplication.focusWidget() or window)


def test_back_and_forth(window: MainWindow) -> None:
    guide = begun(window)
    assert not guide.back_button.isVisible()
    guide.next_button.click()
    guide.back_button.click()
    assert guide.step == 0


def test_escape_puts_it_away_wherever_the_keyboard_is(window: MainWindow) -> None:
    window.activateWindow()
    for place in (window.form.start_field, window.form.yacht_box, window.chart.view, window.form.percent_box):
        guide = begun(window)
        place.setFocus()
        QTest.keyClick(place, Qt.Key.Key_Escape)
        assert not guide.isVisible(), place


def test_nothing_waits_for_it(window: MainWindow, planner: HeldPlanner, qtbot: QtBot) -> None:
    guide = begun(window)
    assert not guide.isModal()
    planner.gate.set()
    with qtbot.waitSignal(window.settled, timeout=20_000):
        QTest.mouseClick(window.form.calculate_button, Qt.MouseButton.LeftButton)
    assert window.state.answer is not None
    assert guide.isVisible()


def test_it_lies_over_the_chart_and_is_read_whole(window: MainWindow, qtbot: QtBot) -> None:
    guide = begun(window)
    for width, height in ((1280, 800), (1000, 600), (640, 400)):
        window.resize(width, height)
        for number in range(3):
            guide.show_step(number)
            QApplication.processEvents()
            window_rect = QRect(QPoint(0, 0), window.size())
            assert window_rect.contains(guide.geometry()), (width, number)
            button = window.form.calculate_button
            assert not guide.geometry().intersects(QRect(button.mapTo(window, QPoint(0, 0)), button.size()))
            for label in guide.findChildren(QLabel):
                assert label.heightForWidth(label.width()) <= label.height() + 1


@pytest.mark.parametrize(("prefill", "shown_at_start"), [({}, "True"), ({"start": "Gdynia"}, "False")])
def test_it_is_for_a_start_without_options(
    tmp_path: Path, prefill: dict[str, str], shown_at_start: str
) -> None:
    code = f"""
from PySide6.QtWidgets import QApplication
from seacruise.desktop.app import open_window
from seacruise.desktop.window import MainWindow

def look(_app):
    for _ in range(100):
        QApplication.processEvents()
    window = next(w for w in QApplication.topLevelWidgets() if isinstance(w, MainWindow))
    print(window.habits.guide is not None)
    window.close()
    return 0

QApplication.exec = look
open_window({prefill!r})
"""
    environment = os.environ | {"SEACRUISE_HOME": str(tmp_path), "QT_QPA_PLATFORM": "offscreen"}
    answer = subprocess.run(
        [sys.executable, "-c", code],
        env=environment | {"SEACRUISE_LANGUAGE": "en"},
        capture_output=True,
        text=True,
        check=False,
        timeout=240,
    )
    assert answer.returncode == 0, answer.stderr
    assert answer.stdout.split() == [shown_at_start]
