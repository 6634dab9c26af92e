"""Weather page and saved passages joined to the window."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise.desktop.memory import WindowMemory
from seacruise.desktop.state import Phase
from seacruise.desktop.window import MainWindow
from seacruise.errors import WeatherError
from seacruise.passages import SavedPassages
from seacruise.settings import Settings
from tests.desktop.conftest import HeldPlanner, texts_of


def save(window: MainWindow, qtbot: QtBot) -> None:
    with qtbot.waitSignal(window.desk.passages.saved, timeout=20_000):
        window.desk.save()


def open_first(window: MainWindow, qtbot: QtBot) -> None:
    with qtbot.waitSignal(window.desk.passages.loaded, timeout=20_000):
        window.desk.show_passages()
    with qtbot.waitSignal(window.desk.passages.open_requested, timeout=20_000):
        window.desk.passages.open()


def test_saved_it_opens_after_a_restart_as_it_was(
    answered: MainWindow, make_window: Callable[..., MainWindow], planner: HeldPlanner, qtbot: QtBot
) -> None:
    save(answered, qtbot)
    before = answered.state.answer
    assert before is not None
    answered.close()
    asked = len(planner.requests)
    window = make_window(fill=False)
    open_first(window, qtbot)
    after = window.state.answer
    assert after is not None
    assert after.passage.waypoints == before.passage.waypoints
    assert after.passage.notices == before.passage.notices
    assert window.state.phase is Phase.ROUTE
    assert window.legs.legs.rowCount() == len(before.passage.waypoints)
    window.pane.show_page("log")
    assert "Gdynia" in window.pane.log.text_of_rows()
    assert window.form.start_field.text() == "Gdynia"
    assert window.form.departure.moment == before.question.departure
    text = texts_of(window)
    assert "Computed on" in text
    assert "which is no forecast" in text
    assert before.passage.notices[0] in text
    QTest.qWait(300)
    assert len(planner.requests) == asked, "nothing is computed anew"
    assert window.state.answer is after


def test_opening_ends_a_calculation_that_runs(
    answered: MainWindow, planner: HeldPlanner, qtbot: QtBot
) -> None:
    save(answered, qtbot)
    answered.calculate()
    assert answered.state.phase.value == "computing"
    open_first(answered, qtbot)
    assert not answered.jobs.is_running
    assert answered.state.phase.value == "route"
    planner.gate.set()
    QTest.qWait(100)
    assert "Computed on" in texts_of(answered)


def test_the_menu_saves_and_opens(answered: MainWindow, qtbot: QtBot, settings: Settings) -> None:
    action = next(a for a in answered.menus.exports if "this passage" in a.text())
    with qtbot.waitSignal(answered.desk.passages.saved, timeout=20_000):
        action.trigger()
    assert len(SavedPassages(settings.database).listing().entries) == 1
    assert "Saved as" in answered.statusBar().currentMessage()


def test_a_source_and_a_mean_are_chosen_for_the_form(window: MainWindow, qtbot: QtBot) -> None:
    page = window.desk.weather
    page.choose("metno")
    assert window.form.question().forecast == ("metno",)
    page.cards["open-meteo"].mix_box.click()
    page.cards["metno"].mix_box.click()
    page.cards["metno"].weight_box.setValue(2.0)
    page.mean_button.click()
    assert window.form.forecast == ("open-meteo", "metno")
    assert window.form.weights == (1.0, 2.0)
    assert window.form.question().weights == (1.0, 2.0)
    window.form.set_forecast(("sample",))
    assert page.chosen.text().endswith("Sample of November 2016.")
    assert window.form.question().weights == ()


def test_what_comes_after_the_forecast_is_a_wish_of_the_form(window: MainWindow) -> None:
    window.desk.show_weather()
    window.desk.weather.beyond_chosen.emit("fade")
    assert window.form.options().beyond == "fade"
    window.desk.show_weather()
    assert window.desk.weather.beyond_box.currentData() == "fade"


def test_weights_outlive_the_window(
    make_window: Callable[..., MainWindow], settings: Settings, tmp_path: Path
) -> None:
    first = make_window(memory=WindowMemory(settings.data_dir))
    first.form.set_forecast(("open-meteo", "metno"), (3.0, 1.0))
    first.close()
    second = make_window(memory=WindowMemory(settings.data_dir), fill=False)
    assert (second.form.forecast, second.form.weights) == (("open-meteo", "metno"), (3.0, 1.0))
    second.form.restore({"forecast": ["open-meteo", "metno"], "weights": ["x", -1]})
    assert second.form.weights == ()


def test_a_calculation_that_reaches_nobody_is_noted(
    window: MainWindow, planner: HeldPlanner, qtbot: QtBot
) -> None:
    window.desk.show_weather()
    planner.error = WeatherError("Open-Meteo cannot be reached.", reason="no-network")
    planner.gate.set()
    with qtbot.waitSignal(window.settled, timeout=20_000):
        window.calculate()
    assert window.desk.weather.is_offline


def test_keys_open_both_pages(window: MainWindow) -> None:
    QTest.keyClick(window, Qt.Key.Key_F3)
    QTest.keyClick(window, Qt.Key.Key_O, Qt.KeyboardModifier.ControlModifier)
    QApplication.processEvents()
    assert window.desk.weather.isVisible()
    assert window.desk.passages.isVisible()
    window.close()
    assert not window.desk.weather.isVisible()


def test_neither_page_is_loaded_before_it_is_wanted() -> None:
    program = (
        "import sys\nimport seacruise.desktop.window\n"
        "late = [name for name in ('seacruise.passages', 'seacruise.desktop.pages.weather_page',"
        " 'seacruise.desktop.pages.passages_page', 'sqlite3', 'keyring') if name in sys.modules]\n"
        "assert not late, late\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", program],
        capture_output=True,
        text=True,
        check=False,
        cwd=Path(__file__).resolve().parent.parent.parent,
    )
    assert done.returncode == 0, done.stderr


def test_a_yacht_taken_on_its_page_is_the_one_of_the_form(window: MainWindow, qtbot: QtBot) -> None:
    window.desk.show_yachts()
    page = window.desk.yachts
    qtbot.waitUntil(lambda: page.polar is not None, timeout=20_000)
    assert page.polar is not None
    assert page.polar.name == window.form.wanted_yacht
    other = "Delphia 47"
    page.choose(other)
    qtbot.waitUntil(lambda: page.polar is not None and page.polar.name == other, timeout=20_000)
    page.yacht_chosen.emit(page.polar)
    assert window.form.wanted_yacht == other
    page.percent_changed.emit(85.0)
    assert window.form.options().percent_of_polar == 85.0
