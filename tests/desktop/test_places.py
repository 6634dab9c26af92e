"""Windows come back where they were, as large, and onto a screen that exists; columns as wide."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QRect
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise.desktop.memory import WindowMemory
from seacruise.desktop.places import on_a_screen
from seacruise.desktop.window import MainWindow

HOME, SECOND = QRect(0, 27, 1366, 741), QRect(1366, 0, 2560, 1440)
numbers = st.integers(-5000, 5000)
sides = st.integers(1, 6000)


def test_a_window_that_fits_stays_where_it_was() -> None:
    kept = QRect(1500, 100, 900, 700)
    assert on_a_screen(kept, [HOME, SECOND], HOME) == kept


def test_a_screen_that_is_gone_is_not_waited_for() -> None:
    place = on_a_screen(QRect(1500, 100, 900, 700), [HOME], HOME)
    assert HOME.contains(place)
    assert place.size().toTuple() == (900, 700)


def test_a_smaller_screen_makes_it_smaller() -> None:
    small = QRect(0, 0, 800, 560)
    place = on_a_screen(QRect(100, 100, 1400, 1000), [small], small)
    assert small.contains(place)
    assert 780 <= place.width() <= 800
    assert 500 <= place.height() < 560


@given(x=numbers, y=numbers, width=sides, height=sides, screens=st.sampled_from([(HOME,), (HOME, SECOND)]))
def test_it_is_always_on_a_screen_with_its_title(
    x: int, y: int, width: int, height: int, screens: tuple[QRect, ...]
) -> None:
    place = on_a_screen(QRect(x, y, width, height), screens, HOME)
    assert any(screen.contains(place) for screen in screens)


@pytest.fixture
def memory(tmp_path: Path) -> WindowMemory:
    return WindowMemory(tmp_path)


def test_windows_and_columns_outlive_the_program(
    make_window: Callable[..., MainWindow], memory: WindowMemory, tmp_path: Path, qtbot: QtBot
) -> None:
    first = make_window(memory=memory)
    first.desk.show_passages()
    first.desk.show_yachts()
    first.form.options_bar.open_dialog()
    passages, yachts = first.desk.passages.window(), first.desk.yachts.window()
    passages.setGeometry(40, 50, 640, 380)
    yachts.setGeometry(10, 20, 700, 500)
    first.form.options_bar.dialog.resize(500, 480)
    table = first.planning.departures.table
    table.setColumnWidth(1, 133)
    table.sortByColumn(1, table.horizontalHeader().sortIndicatorOrder().DescendingOrder)
    # One that is closed before the program ends is kept, too.
    passages.close()
    first.close()

    second = make_window(memory=WindowMemory(tmp_path))
    second.desk.show_passages()
    second.desk.show_yachts()
    second.form.options_bar.open_dialog()
    assert second.desk.passages.window().geometry() == QRect(40, 50, 640, 380)
    assert second.desk.yachts.window().geometry() == QRect(10, 20, 700, 500)
    assert second.form.options_bar.dialog.size().toTuple() == (500, 480)
    columns = second.planning.departures.table
    assert columns.columnWidth(1) == 133
    assert columns.contents() == {"widths": {"1": 133}, "by": 1, "down": True}


def test_a_window_larger_than_the_screen_comes_back_within_it(
    make_window: Callable[..., MainWindow], memory: WindowMemory
) -> None:
    memory.keep("places", {"weather": [3000, 2500, 4000, 3000], "passages": [-900, -700, 500, 400]})
    window = make_window(memory=memory)
    window.desk.show_weather()
    window.desk.show_passages()
    room = window.screen().availableGeometry()
    for page in (window.desk.weather, window.desk.passages):
        assert room.contains(page.window().geometry())


@pytest.mark.parametrize(
    "kept",
    [
        {"weather": "here", "departures": [1, 2]},
        {"weather": [1, 2, 3], "departures": {"widths": {"0": "wide", "x": 3, "77": 50}, "by": 99}},
        {"weather": [1, 2, True, None], "departures": {"widths": 3, "by": "name"}},
        {"weather": [0, 0, -5, 10**12]},
    ],
)
def test_a_damaged_file_is_passed_over(
    make_window: Callable[..., MainWindow], memory: WindowMemory, kept: dict[str, Any]
) -> None:
    memory.keep("places", kept)
    window = make_window(memory=memory)
    window.desk.show_weather()
    QApplication.processEvents()
    assert window.desk.weather.isVisible()
    assert window.planning.departures.table.contents()["widths"] == {}


def test_a_column_drawn_out_stays_so_while_the_table_changes(
    make_window: Callable[..., MainWindow], memory: WindowMemory
) -> None:
    table = make_window(memory=memory).planning.reach.table
    table.setColumnWidth(0, 222)
    table.resize(1200, 300)
    table.setColumnHidden(3, True)
    table.show_rows(())
    assert table.columnWidth(0) == 222
    table.setColumnHidden(3, False)
    assert table.contents()["widths"] == {"0": 222}
