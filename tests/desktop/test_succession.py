"""Another language at once: a window in that language goes on where the other one was."""

from __future__ import annotations

import threading
import weakref
from collections import Counter
from collections.abc import Callable, Iterator
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
import shiboken6
from PySide6.QtCore import QAbstractItemModel, QLocale, QModelIndex, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QComboBox,
    QDoubleSpinBox,
    QLabel,
    QLineEdit,
    QListView,
    QMainWindow,
    QTabBar,
    QTableView,
    QWidget,
)
from pytestqt.qtbot import QtBot

from seacruise.desktop import language
from seacruise.desktop.jobs import JobRunner
from seacruise.desktop.memory import WindowMemory
from seacruise.desktop.pages.page import Phase as PagePhase
from seacruise.desktop.state import Phase
from seacruise.desktop.succession import Succession
from seacruise.desktop.units_choice import units_choice
from seacruise.desktop.window import MainWindow
from seacruise.errors import InputError, NoPassageError
from seacruise.progress import Job
from seacruise.settings import Settings
from tests.desktop.conftest import ASK, HeldPlanner, fetch_at_once, texts_of


@pytest.fixture(autouse=True)
def english_again(qapp: QApplication, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.delenv("SEACRUISE_LANGUAGE", raising=False)
    before = QLocale()
    yield
    language.speak(qapp, "en")
    QLocale.setDefault(before)


@pytest.fixture
def memory(tmp_path: Path) -> WindowMemory:
    memory = WindowMemory(tmp_path)
    language.choose(memory, "en")
    return memory


@pytest.fixture
def first(make_window: Callable[..., MainWindow], memory: WindowMemory) -> MainWindow:
    return make_window(memory=memory)


@pytest.fixture
def succession(
    app: QApplication, first: MainWindow, planner: HeldPlanner, memory: WindowMemory
) -> Iterator[Succession]:
    succession = Succession(app, first)
    yield succession
    planner.gate.set()
    succession.window.close()
    succession.window.deleteLater()
    succession.deleteLater()


def speak(succession: Succession, code: str, qtbot: QtBot) -> MainWindow:
    """Choose a language in the menu, as a click does, and wait until the other window is gone."""
    old = succession.window
    menu = old.menus.language
    action = next(action for action in menu.actions() if action.data() == code)
    action.trigger()
    qtbot.waitUntil(lambda: not shiboken6.isValid(old), timeout=20_000)
    qtbot.wait(50)
    return succession.window


def answer(window: MainWindow, planner: HeldPlanner, qtbot: QtBot) -> None:
    planner.gate.set()
    with qtbot.waitSignal(window.settled, timeout=20_000):
        window.calculate()
    planner.gate.clear()


# --- no stale word ---------------------------------------------------------------------------------------


def words_of(window: QMainWindow) -> dict[str, list[str]]:
    """Everything that a window and its dialogs say, by what says it."""
    said: dict[str, list[str]] = {}
    for widget in (window, *window.findChildren(QWidget)):
        kind = f"{type(widget).__name__} {widget.objectName()}"
        said.setdefault(kind, []).extend(text for text in texts_of_widget(widget) if text)
    for action in window.findChildren(QAction):
        said.setdefault("actions", []).extend((action.text(), action.toolTip()))
    return {kind: sorted(texts) for kind, texts in said.items() if "qt_" not in kind}


def texts_of_widget(widget: QWidget) -> list[str]:
    texts = [widget.toolTip(), widget.accessibleName(), widget.accessibleDescription()]
    texts += [widget.whatsThis(), widget.statusTip(), widget.windowTitle()]
    if isinstance(widget, QAbstractButton | QLabel):
        texts.append(widget.text())
    elif isinstance(widget, QComboBox):
        texts += [widget.itemText(k) for k in range(widget.count())] + [widget.placeholderText()]
    elif isinstance(widget, QLineEdit):
        texts.append(widget.placeholderText())
    elif isinstance(widget, QDoubleSpinBox):
        texts += [widget.suffix(), widget.prefix(), widget.specialValueText()]
    elif isinstance(widget, QTabBar):
        texts += [widget.tabText(k) + widget.tabToolTip(k) for k in range(widget.count())]
    elif isinstance(widget, QTableView | QListView):
        root, across = QModelIndex(), Qt.Orientation.Horizontal
        model: QAbstractItemModel = widget.model()
        for column in range(model.columnCount(root) if isinstance(widget, QTableView) else 1):
            for role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.ToolTipRole):
                texts.append(str(model.headerData(column, across, role)))
            texts += [str(model.index(row, column, root).data()) for row in range(model.rowCount(root))]
    return texts


def open_all(window: MainWindow) -> None:
    """Open everything that a window can have beside it."""
    window.form.options_bar.open_dialog()
    window.desk.show_weather()
    window.desk.show_passages()
    window.desk.show_yachts()
    window.habits.show_guide()
    window.planning.frame.open_page(window.planning.departures)


def is_quiet(window: MainWindow) -> bool:
    weather, passages, yachts = window.desk.opened
    runners = window.findChildren(JobRunner) + [
        runner for page in (weather, passages, yachts) if page for runner in page.findChildren(JobRunner)
    ]
    return not any(runner.is_running for runner in runners)


def test_after_a_change_nothing_is_said_in_the_other_language(
    first: MainWindow,
    succession: Succession,
    make_window: Callable[..., MainWindow],
    memory: WindowMemory,
    planner: HeldPlanner,
    qtbot: QtBot,
) -> None:
    answer(first, planner, qtbot)
    open_all(first)
    qtbot.waitUntil(lambda: is_quiet(first), timeout=20_000)
    in_english = words_of(first)
    heir = speak(succession, "pl", qtbot)
    qtbot.waitUntil(lambda: is_quiet(heir), timeout=20_000)
    changed = words_of(heir)

    # One that was started in that language, and came to the same point.
    started = make_window(memory=memory)
    answer(started, planner, qtbot)
    open_all(started)
    qtbot.waitUntil(lambda: is_quiet(started), timeout=20_000)
    expected = words_of(started)
    stale = {kind: Counter(texts) - Counter(expected.get(kind, ())) for kind, texts in changed.items()}
    assert {kind: texts for kind, texts in stale.items() if texts} == {}
    # What it lacks are words of a calculation that it has not seen.
    lacking = {kind: Counter(texts) - Counter(changed.get(kind, ())) for kind, texts in expected.items()}
    assert sum(map(len, lacking.values())) <= 6, lacking
    assert sum(map(len, in_english.values())) > 500
    assert "Oblicz" in heir.form.calculate_button.text().replace("&", "")
    assert not heir.menus.language.actions()[1].isChecked()


# --- nothing lost ----------------------------------------------------------------------------------------


def test_question_options_and_answer_stay(
    first: MainWindow, succession: Succession, planner: HeldPlanner, qtbot: QtBot
) -> None:
    answer(first, planner, qtbot)
    found = first.state.answer
    first.menus.live.setChecked(False)
    first.form.sailing.put({"directions": 24, "percent_of_polar": 92.5, "max_wind_kn": 27.0})
    first.form.options_bar.show_options(shown=True)
    first.form.start_field.setText("S")
    first.chart.time_bar.set_moment(first.chart.time_bar.moment + timedelta(hours=3))
    moment, asked = first.chart.time_bar.moment, first.form.contents()
    options, departure = first.form.options(), first.form.departure.moment
    first.pane.show_page("log")

    heir = speak(succession, "pl", qtbot)
    assert heir is not first
    assert heir.state.answer is found
    assert heir.state.phase is Phase.ROUTE
    assert heir.form.contents() == asked
    assert heir.form.options() == options
    assert (heir.form.departure.moment, heir.form.departure.was_chosen) == (departure, True)
    assert heir.chart.time_bar.moment == moment
    assert heir.pane.page == "log"
    assert not heir.form.options_bar.box.isHidden()
    assert heir.menus.exports[0].isEnabled()
    assert len(planner.requests) == 1, "nothing was calculated anew"


def test_the_same_part_of_the_chart_is_shown(
    first: MainWindow, succession: Succession, planner: HeldPlanner, qtbot: QtBot
) -> None:
    answer(first, planner, qtbot)
    qtbot.wait(50)
    view = first.chart.view
    view.zoom_in()
    view.pan(40.0, -25.0)
    scale, middle = view.transform().m11(), view.middle()
    geometry = first.geometry()
    heir = speak(succession, "pl", qtbot)
    qtbot.waitUntil(lambda: heir.chart.view.transform().m11() == pytest.approx(scale), timeout=5_000)
    assert heir.chart.view.middle() == pytest.approx(middle, abs=0.02)
    assert heir.geometry() == geometry


def test_a_calculation_goes_on_and_ends_in_the_new_window(
    first: MainWindow, succession: Succession, planner: HeldPlanner, qtbot: QtBot
) -> None:
    first.calculate()
    qtbot.waitUntil(planner.begun.is_set, timeout=20_000)
    heir = speak(succession, "pl", qtbot)
    assert heir.jobs.is_running
    assert heir.state.progress.stage == "search"
    assert heir.form.cancel_button.isEnabled()
    planner.gate.set()
    with qtbot.waitSignal(heir.settled, timeout=20_000):
        pass
    assert heir.state.phase is Phase.ROUTE
    assert planner.cancelled == 0
    assert len(planner.requests) == 1


def test_a_calculation_that_went_over_can_be_cancelled_and_asked_again(
    first: MainWindow, succession: Succession, planner: HeldPlanner, qtbot: QtBot
) -> None:
    first.calculate()
    qtbot.waitUntil(planner.begun.is_set, timeout=20_000)
    heir = speak(succession, "pl", qtbot)
    heir.cancel()
    assert not heir.jobs.is_running
    assert "Anulowano" in texts_of(heir)
    answer(heir, planner, qtbot)
    assert heir.state.phase is Phase.ROUTE


def test_steps_can_still_be_taken_back(
    first: MainWindow, succession: Succession, planner: HeldPlanner, qtbot: QtBot
) -> None:
    answer(first, planner, qtbot)
    first.menus.live.setChecked(False)
    first.form.swap_ends()
    first.history.settle()
    first.steering.avoided.add(57.0, 18.0, 5.0)
    first.form.sailing.put({"max_wind_kn": 25.0})
    first.history.settle()
    first.history.stack.undo()
    index = first.history.stack.index()
    assert first.history.stack.count() == 3

    heir = speak(succession, "pl", qtbot)
    stack = heir.history.stack
    assert (stack.count(), stack.index()) == (3, index)
    assert heir.form.options().max_wind_kn is None
    assert [zone.name for zone in heir.steering.avoided.zones] == ["omijane: 5 Mm"]
    assert heir.form.start_field.text() == "Sandhamn"
    stack.redo()
    assert heir.form.options().max_wind_kn == 25.0
    stack.undo()
    stack.undo()
    assert heir.steering.avoided.zones == ()
    assert "zamian" in stack.undoText()
    stack.undo()
    assert heir.form.start_field.text() == "Gdynia"
    assert not stack.canUndo()
    heir.form.swap_ends()
    heir.history.settle()
    assert stack.count() == 1


def test_a_window_that_is_still_loading_goes_over_too(
    app: QApplication, settings: Settings, planner: HeldPlanner, memory: WindowMemory, qtbot: QtBot
) -> None:
    first = MainWindow(settings, planner=planner, fetcher=fetch_at_once, memory=memory)
    first.fill(ASK)
    first.show()
    first.load(warm_up=False)
    succession = Succession(app, first)
    first.calculate()
    assert first.loading.holds
    language.choose(memory, "pl")
    succession.change()
    heir = succession.window
    try:
        with qtbot.waitSignal(heir.settled, timeout=20_000):
            planner.gate.set()
        assert heir.state.phase is Phase.ROUTE
        assert heir.form.start_field.text() == "Gdynia"
        assert len(planner.requests) == 1
    finally:
        heir.close()
        heir.deleteLater()
        succession.deleteLater()


def test_a_comparison_goes_on_and_what_was_found_stays(
    first: MainWindow, succession: Succession, planner: HeldPlanner, qtbot: QtBot
) -> None:
    answer(first, planner, qtbot)
    page = first.planning.departures
    page.count_box.setValue(3)
    first.planning.frame.open_page(page)
    page.start()
    assert page.phase is PagePhase.BUSY
    heir = speak(succession, "pl", qtbot)
    page = heir.planning.departures
    if page.phase is PagePhase.BUSY:
        with qtbot.waitSignal(page.settled, timeout=60_000):
            pass
    assert page.phase is PagePhase.DONE
    assert page.comparison is not None
    sentence, rows = page.sentence.text(), len(page.comparison.rows())
    chosen = page.table.current.number
    again = speak(succession, "en", qtbot)
    page = again.planning.departures
    assert page.phase is PagePhase.DONE
    assert page.comparison is not None
    assert (len(page.comparison.rows()), page.table.current.number) == (rows, chosen)
    assert page.sentence.text() != sentence
    assert page.sentence.text().startswith(("Leav", "It "))


def test_troubles_are_told_in_the_new_language(
    first: MainWindow, succession: Succession, planner: HeldPlanner, qtbot: QtBot
) -> None:
    planner.gate.set()
    planner.error = NoPassageError("No wind.", reason="becalmed", place=(56.0, 18.0))
    with qtbot.waitSignal(first.settled, timeout=20_000):
        first.calculate()
    heir = speak(succession, "pl", qtbot)
    assert heir.state.phase is Phase.FAILED
    assert heir.side.banner is not None
    assert heir.side.banner.message.title == "Brak trasy: cisza"
    again = speak(succession, "en", qtbot)
    assert again.side.banner is not None
    assert again.side.banner.message.title == "No passage: becalmed"


def test_what_is_wrong_with_the_form_is_said_in_the_new_language(
    first: MainWindow, succession: Succession, qtbot: QtBot
) -> None:
    first.form.departure.set_moment(first.form.departure.moment + timedelta(days=900), chosen=True)
    first.calculate()
    assert isinstance(first.state.error, InputError)
    in_english = str(first.state.error)
    heir = speak(succession, "pl", qtbot)
    assert heir.state.phase is Phase.FAILED
    assert str(heir.state.error) != in_english
    assert "prognoz" in texts_of(heir)


def test_open_pages_and_windows_stay_open(first: MainWindow, succession: Succession, qtbot: QtBot) -> None:
    first.show()
    first.desk.show_weather()
    first.desk.weather.key_box.field.setText("half a key")
    first.desk.weather.cards["open-meteo"].mix_box.setChecked(True)
    first.desk.weather.window().resize(600, 500)
    first.form.options_bar.open_dialog()
    first.planning.frame.open_page(first.planning.reach)
    first.planning.reach.time_box.setValue(36.0)
    first.planning.departures.count_box.setValue(5)
    heir = speak(succession, "pl", qtbot)
    weather, passages, yachts = heir.desk.opened
    assert weather is not None
    assert (passages, yachts) == (None, None)
    assert weather.isVisible()
    assert weather.key_box.field.text() == "half a key"
    assert weather.cards["open-meteo"].mix_box.isChecked()
    assert weather.window().size().toTuple() == (600, 500)
    assert heir.form.options_bar.is_dialog_open
    assert heir.planning.frame.is_open
    assert heir.planning.frame.stack.currentWidget() is heir.planning.reach
    assert heir.planning.reach.hours == 36.0
    assert heir.planning.departures.count_box.value() == 5


# --- nothing left behind ---------------------------------------------------------------------------------


def test_the_old_window_is_freed_and_its_workers_end(
    first: MainWindow, succession: Succession, planner: HeldPlanner, qtbot: QtBot
) -> None:
    answer(first, planner, qtbot)
    open_all(first)
    heir = speak(succession, "pl", qtbot)
    for code in ("en", "pl", "en"):
        freed = weakref.ref(heir)
        parts = [weakref.ref(part) for part in (heir.form, heir.chart.view, heir.pane, heir.side)]
        heir = speak(succession, code, qtbot)
        qtbot.waitUntil(lambda: freed() is None, timeout=10_000)  # noqa: B023
        assert [part() for part in parts] == [None] * len(parts)
        assert sum(isinstance(w, MainWindow) for w in QApplication.topLevelWidgets()) <= 2
    qtbot.waitUntil(lambda: is_quiet(heir), timeout=20_000)
    qtbot.waitUntil(lambda: not own_threads(heir), timeout=10_000)
    # Nobody who is gone is told of anything.
    units_choice().choose(wind="m/s")
    units_choice().choose(wind="kn")


def own_threads(window: MainWindow) -> list[str]:
    names = ("passage-", "live-", "departures-", "reach-", "isochrones-", "ways-", "catalogue-", "yachts-")
    return [t.name for t in threading.enumerate() if t.name.startswith(names)]


def test_where_the_environment_decides_the_choice_is_kept_and_said(
    first: MainWindow,
    succession: Succession,
    monkeypatch: pytest.MonkeyPatch,
    memory: WindowMemory,
    qtbot: QtBot,
) -> None:
    monkeypatch.setenv("SEACRUISE_LANGUAGE", "en")
    next(a for a in first.menus.language.actions() if a.data() == "pl").trigger()
    qtbot.waitUntil(lambda: "SEACRUISE_LANGUAGE" in first.statusBar().currentMessage(), timeout=5_000)
    assert succession.window is first
    assert language.chosen(memory) == "pl"


# --- one runner after another ----------------------------------------------------------------------------


def test_a_runner_hands_over_what_it_awaits(qtbot: QtBot) -> None:
    old, heir = JobRunner("old"), JobRunner("heir")
    gate, begun = threading.Event(), threading.Event()
    told: list[Any] = []
    for name, runner in (("old", old), ("heir", heir)):
        runner.finished.connect(lambda number, found, name=name: told.append((name, number, found)))
        runner.progressed.connect(lambda _g, stage, *_, name=name: told.append((name, stage)))

    def work(job: Job) -> str:
        job.report("sea", 0.5, "")
        begun.set()
        assert gate.wait(10)
        return "found"

    number = old.run_job(work)
    assert begun.wait(10)
    # Reported before, not yet heard.
    old.hand_over(heir)
    assert not old.is_running
    assert heir.is_running
    old.shut_down()
    old.deleteLater()
    gate.set()
    qtbot.waitUntil(lambda: ("heir", number, "found") in told, timeout=10_000)
    assert ("heir", "sea") in told
    assert not [one for one in told if one[0] == "old"]
    assert heir.run_job(lambda _job: None) == number + 1
    qtbot.waitUntil(lambda: not heir.is_running, timeout=10_000)


def test_a_runner_without_work_hands_nothing_over(qtbot: QtBot) -> None:
    old, heir = JobRunner("old"), JobRunner("heir")
    old.hand_over(heir)
    assert not heir.is_running
