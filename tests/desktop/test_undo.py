from __future__ import annotations

import gc
from collections.abc import Callable
from dataclasses import replace
from datetime import timedelta

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise.desktop.undo import Asked, History, _Step, differences, name_of
from seacruise.desktop.window import MainWindow
from seacruise.passage import Options
from seacruise.ports import Port
from tests.desktop.conftest import HeldPlanner
from tests.passages import DEPARTURE

GDYNIA, VISBY = Port("Gdynia", "PL", 54.516, 18.553), Port("Visby", "SE", 57.64, 18.28)
BEFORE = Asked(GDYNIA, VISBY, DEPARTURE, True, "Sloop", (("sample",), ()), Options(), None)


def settle(window: MainWindow) -> None:
    """Let what was changed become a step, and the next change a step of its own."""
    QApplication.processEvents()
    window.history.settle()


def actions(window: MainWindow) -> tuple[QAction, QAction]:
    found = {a.shortcut().toString(): a for a in window.findChildren(QAction)}
    return found["Ctrl+Z"], found["Ctrl+Shift+Z"]


@pytest.fixture
def history(window: MainWindow) -> History:
    return window.history


# --- names and differences, without a window ------------------------------------------------------------


@pytest.mark.parametrize(
    ("after", "changed", "name"),
    [
        (replace(BEFORE, start=VISBY, end=GDYNIA), {"start", "end"}, "start and end swapped"),
        (replace(BEFORE, start=replace(GDYNIA, name="Hel")), {"start"}, "start Hel"),
        (replace(BEFORE, end=replace(VISBY, name="Slite")), {"end"}, "destination Slite"),
        (replace(BEFORE, departure=DEPARTURE + timedelta(hours=12)), {"departure"}, "departure Sun 18:00"),
        (replace(BEFORE, yacht="Ketch"), {"yacht"}, "yacht Ketch"),
        (replace(BEFORE, options=Options(max_wind_kn=25.0)), {"options"}, "how she is sailed"),
        (replace(BEFORE, forecast=(("practice",), ())), {"forecast"}, "forecast"),
        (replace(BEFORE, via=GDYNIA), {"via"}, "sailing by way of a place"),
        (replace(BEFORE, via=GDYNIA, yacht="Ketch"), {"via", "yacht"}, "passage"),
    ],
)
def test_a_step_is_named_after_what_it_changes(after: Asked, changed: set[str], name: str) -> None:
    assert differences(BEFORE, after) == changed
    assert name_of(frozenset(changed), BEFORE, after) == name


@pytest.mark.parametrize(
    "after",
    [
        replace(BEFORE, start=None),
        replace(BEFORE, end=None),
        replace(BEFORE, yacht=""),
        replace(BEFORE, departure=DEPARTURE + timedelta(hours=1), chosen=False),
    ],
)
def test_half_a_name_and_a_departure_that_nobody_chose_are_no_steps(after: Asked) -> None:
    assert not differences(BEFORE, after)


# --- in the window --------------------------------------------------------------------------------------


def test_what_the_form_fills_in_by_itself_is_nothing_to_undo(window: MainWindow) -> None:
    settle(window)
    assert window.history.stack.count() == 0
    back, forth = actions(window)
    assert not back.isEnabled()
    assert not forth.isEnabled()
    assert back.text() == "&Undo"


def test_each_change_of_the_question_is_taken_back_and_made_again(window: MainWindow) -> None:
    form, steering, stack = window.form, window.steering, window.history.stack
    before = window.history._asked()
    form.start_field.setText("Hel")
    settle(window)
    form.departure.set_moment(DEPARTURE + timedelta(hours=3), chosen=True)
    settle(window)
    form.yacht_box.setCurrentIndex(form.yacht_box.currentIndex() + 1)
    settle(window)
    form.percent_box.setValue(80.0)
    settle(window)
    window.chart.view.end_picked.emit("via", 57.0, 19.0)
    settle(window)
    form.swap_ends()
    settle(window)
    after = window.history._asked()
    assert [stack.text(n) for n in range(stack.count())] == [
        "start Hel",
        "departure Sun 09:00",
        f"yacht {form.yacht_box.currentText()}",
        "how she is sailed",
        "sailing by way of a place",
        "start and end swapped",
    ]
    while stack.canUndo():
        stack.undo()
    settle(window)
    assert window.history._asked() == before
    assert steering.via is None
    while stack.canRedo():
        stack.redo()
    settle(window)
    assert window.history._asked() == after
    assert stack.count() == 6


def test_the_menu_names_the_step(window: MainWindow) -> None:
    window.form.departure.set_moment(DEPARTURE + timedelta(hours=12), chosen=True)
    settle(window)
    back, forth = actions(window)
    assert back.text() == "&Undo: departure Sun 18:00"
    back.trigger()
    assert window.form.departure.moment == DEPARTURE
    assert forth.text() == "&Redo: departure Sun 18:00"
    assert not back.isEnabled()
    forth.trigger()
    assert window.form.departure.moment == DEPARTURE + timedelta(hours=12)


def test_a_drag_of_the_departure_is_one_step(window: MainWindow) -> None:
    bar, stack = window.chart.time_bar, window.history.stack
    for hours in (1, 2, 5, 7):
        bar.departure_moved.emit(DEPARTURE + timedelta(hours=hours))
        QApplication.processEvents()
    bar.departure_settled.emit()
    assert stack.count() == 1
    assert stack.undoText() == "departure Sun 13:00"
    bar.departure_moved.emit(DEPARTURE + timedelta(hours=9))
    bar.departure_settled.emit()
    assert stack.count() == 2
    stack.undo()
    assert window.form.departure.moment == DEPARTURE + timedelta(hours=7)
    stack.undo()
    assert window.form.departure.moment == DEPARTURE


def test_a_long_drag_leaves_nothing_but_its_step(window: MainWindow) -> None:
    bar, stack = window.chart.time_bar, window.history.stack
    for minutes in range(6, 306, 6):
        bar.departure_moved.emit(DEPARTURE + timedelta(minutes=minutes))
        QApplication.processEvents()
    bar.departure_settled.emit()
    gc.collect()
    assert stack.count() == 1
    steps = [one for one in gc.get_objects() if isinstance(one, _Step)]
    mine = [one for one in steps if one._history is window.history]
    assert len(mine) == 1, "of a step that Qt merges PySide6 never lets go"


def test_a_drag_on_the_chart_is_one_step(window: MainWindow) -> None:
    view, stack = window.chart.view, window.history.stack
    start = window.form.start_field.text()
    for n in range(5):
        view.end_dragged.emit("from", Port("", "", 54.6 + n / 50.0, 18.9), n == 4)
        QApplication.processEvents()
    assert stack.count() == 1
    stack.undo()
    assert window.form.start_field.text() == start


def test_a_drag_that_comes_back_is_no_step(window: MainWindow) -> None:
    bar = window.chart.time_bar
    for hours in (1, 2, 0):
        bar.departure_moved.emit(DEPARTURE + timedelta(hours=hours))
        QApplication.processEvents()
    bar.departure_settled.emit()
    assert window.history.stack.count() == 0


def test_areas_are_steps_of_the_same_stack(window: MainWindow) -> None:
    window.form.departure.set_moment(DEPARTURE + timedelta(hours=1), chosen=True)
    settle(window)
    window.chart.view.avoid_picked.emit(57.0, 19.0, 5.0)
    settle(window)
    stack = window.history.stack
    assert [stack.text(n) for n in range(stack.count())] == ["departure Sun 07:00", "avoiding an area"]
    stack.undo()
    assert not window.steering.avoided.zones
    assert window.form.departure.moment == DEPARTURE + timedelta(hours=1)


def test_undoing_sails_anew(answered: MainWindow, planner: HeldPlanner, qtbot: QtBot) -> None:
    planner.gate.set()
    answered.form.departure.set_moment(DEPARTURE + timedelta(hours=4), chosen=True)
    settle(answered)
    qtbot.waitUntil(lambda: not answered.steering.router.is_busy, timeout=20_000)
    before = len(planner.requests)
    answered.history.stack.undo()
    qtbot.waitUntil(lambda: len(planner.requests) > before, timeout=20_000)
    qtbot.waitUntil(lambda: not answered.steering.router.is_busy, timeout=20_000)
    assert planner.requests[-1].departure == DEPARTURE


def test_a_field_that_is_typed_into_has_its_own_undo(window: MainWindow, qtbot: QtBot) -> None:
    window.form.departure.set_moment(DEPARTURE + timedelta(hours=1), chosen=True)
    settle(window)
    field = window.form.end_field
    field.setFocus()
    qtbot.waitUntil(field.hasFocus)
    field.selectAll()
    QTest.keyClicks(field, "Kalm")
    QTest.keyClick(field, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert field.text() != "Kalm"
    assert window.form.departure.moment == DEPARTURE + timedelta(hours=1)


def test_typing_a_name_is_one_step_from_port_to_port(window: MainWindow) -> None:
    field, stack = window.form.end_field, window.history.stack
    for text in ("", "H", "Hel", "Hels", "Helsi", "Helsinki"):
        field.setText(text)
        QApplication.processEvents()
    field.editingFinished.emit()
    assert stack.count() == 1
    assert stack.undoText() == "destination Helsinki"
    stack.undo()
    assert field.text() == "Sandhamn"


def test_an_end_that_was_empty_is_empty_again(make_window: Callable[..., MainWindow], qtbot: QtBot) -> None:
    window = make_window(fill=False)
    window.form.start_field.setText("Visby")
    settle(window)
    assert window.history.stack.undoText() == "start Visby"
    window.history.stack.undo()
    assert window.form.start_field.text() == ""


def test_a_saved_passage_that_is_opened_leaves_nothing_to_undo(answered: MainWindow) -> None:
    answered.form.departure.set_moment(DEPARTURE + timedelta(hours=1), chosen=True)
    settle(answered)
    assert answered.state.answer is not None
    question = answered.state.answer.question
    answered.steering.take_over(lambda: answered.form.fill({"start": "Visby"}), question)
    settle(answered)
    assert answered.history.stack.count() == 0
