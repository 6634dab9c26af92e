"""The pages in the window: what they ask of the form, and what becomes of what they find."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, Qt, QUrl
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from seacruise.desktop.dropped import dropped_files
from seacruise.desktop.equal_time import TimeLine
from seacruise.desktop.messages import Message, WayOut
from seacruise.desktop.pages.page import Phase as PagePhase
from seacruise.desktop.state import Phase
from seacruise.desktop.window import MainWindow
from tests.desktop.conftest import HeldPlanner
from tests.desktop.pages.doubles import HeldComparer, HeldExplorer, fetch_for_reach, later, port


@pytest.fixture
def comparer() -> HeldComparer:
    comparer = HeldComparer(lambda request: 40.0)
    comparer.let_go(1000)
    return comparer


def entry(window: MainWindow, text: str) -> QAction:
    return next(a for a in window.menus.passage.actions() if a.text().replace("&", "") == text)


def compare(window: MainWindow, comparer: HeldComparer, qtbot: QtBot) -> None:
    page = window.planning.departures
    page._comparer = comparer
    page.count_box.setValue(3)
    entry(window, "When to go").trigger()
    with qtbot.waitSignal(page.settled, timeout=20_000):
        page.start()
    assert page.phase is PagePhase.DONE


def test_a_page_takes_the_place_of_the_legs(answered: MainWindow) -> None:
    planning = answered.planning
    assert answered.pane.isVisible()
    assert not planning.frame.is_open
    entry(answered, "Where to go").trigger()
    assert planning.reach.isVisible()
    assert planning.reach.run_button.hasFocus()
    assert not answered.pane.isVisible()
    entry(answered, "When to go").trigger()
    assert planning.departures.isVisible()
    assert not planning.reach.isVisible()
    QTest.mouseClick(planning.frame.close_button, Qt.MouseButton.LeftButton)
    assert not planning.frame.is_open
    assert answered.pane.isVisible()


def test_departures_are_those_of_the_form_in_the_wind_of_the_passage(
    answered: MainWindow, comparer: HeldComparer, qtbot: QtBot
) -> None:
    compare(answered, comparer, qtbot)
    assert {(r.start.name, r.end.name) for r in comparer.asked} == {("Gdynia", "Sandhamn")}
    assert sorted(r.departure for r in comparer.asked if r.departure) == [later(0), later(6), later(12)]
    known = answered.state.answer
    assert known is not None
    assert all(np.shares_memory(r.wind.u, known.wind.u) for r in comparer.asked)


def test_the_part_of_a_wind_that_was_saved_is_not_enough(answered: MainWindow) -> None:
    planning, answer = answered.planning, answered.state.answer
    assert answer is not None
    assert planning._answer() is answer
    forecast = replace(answer.wind.forecast, valid_to=later(24))
    saved = replace(answer, wind=replace(answer.wind, forecast=forecast))
    answered.show_saved(saved, Message("info", "Saved", ""))
    assert answered.state.answer is saved
    assert planning._answer() is None


def test_an_adopted_departure_is_sailed_at_once(
    answered: MainWindow, comparer: HeldComparer, planner: HeldPlanner, qtbot: QtBot
) -> None:
    compare(answered, comparer, qtbot)
    planner.gate.set()
    with qtbot.waitSignal(answered.steering.router.routed, timeout=20_000):
        answered.planning.departures._take_number(2)
    assert answered.form.departure.moment == later(12)
    assert planner.requests[-1].departure == later(12)


def test_without_a_passage_an_adopted_departure_is_calculated(
    window: MainWindow, comparer: HeldComparer, planner: HeldPlanner, qtbot: QtBot
) -> None:
    compare(window, comparer, qtbot)
    planner.gate.set()
    with qtbot.waitSignal(window.settled, timeout=20_000):
        window.planning.departures._take_number(1)
    assert planner.requests[-1].departure == later(6)
    assert window.state.phase is Phase.ROUTE


def test_ports_need_no_end_and_one_of_them_becomes_it(
    window: MainWindow, planner: HeldPlanner, qtbot: QtBot
) -> None:
    page, explorer = window.planning.reach, HeldExplorer()
    explorer.gate.set()
    page._explorer, page._fetcher = explorer, fetch_for_reach
    window.form.end_field.clear()
    with qtbot.waitSignal(page.settled, timeout=20_000):
        page.start()
    assert explorer.requests[0].start.name == "Gdynia"
    assert explorer.requests[0].departure == later(0)
    planner.gate.set()
    page.table.choose(lambda row: row.port.name == "Västervik")
    with qtbot.waitSignal(window.settled, timeout=20_000):
        QTest.keyClick(page.table, Qt.Key.Key_Return)
    assert planner.requests[-1].end == port("Västervik")


def test_a_wrong_start_is_said_on_the_page(window: MainWindow) -> None:
    window.form.start_field.setText("Gdynai")
    page = window.planning.reach
    page.start()
    assert page.phase is PagePhase.FAILED
    assert page.banner is not None
    assert "Gdynai" in page.banner.sentence
    assert window.state.phase is Phase.EMPTY


def test_a_port_out_of_sight_is_brought_into_view(answered: MainWindow) -> None:
    view = answered.chart.view
    before = view.mapToScene(view.viewport().rect().center())
    answered.planning.reach.port_chosen.emit(port("Visby"))
    assert view.mapToScene(view.viewport().rect().center()) == before
    answered.planning.reach.port_chosen.emit(port("Oulu"))
    assert view.mapToScene(view.viewport().rect().center()) != before


def test_lines_of_the_reach_are_switched_on(answered: MainWindow) -> None:
    piece = np.array([[57.0, 18.0], [57.5, 18.5]])
    lines = [TimeLine(6.0, (piece,)), TimeLine(12.0, (piece + 0.5,))]
    answered.planning.reach.isochrones_ready.emit(lines)
    assert answered.layers.is_on("isochrones")
    assert answered.chart.view.isochrones.count == 2
    QTest.qWait(50)
    assert answered.chart.view.isochrones.count == 2


def test_trying_again_is_the_page_s_and_other_ways_out_the_window_s(
    window: MainWindow, comparer: HeldComparer, qtbot: QtBot
) -> None:
    page = window.planning.departures
    page._comparer = comparer
    with qtbot.waitSignal(page.settled, timeout=20_000):
        page.way_out_chosen.emit(WayOut.RETRY)
    assert comparer.asked
    page.way_out_chosen.emit(WayOut.PRACTICE)
    assert window.form.forecast == ("practice",)


def test_closing_ends_what_a_page_computes(make_window: Callable[..., MainWindow], qtbot: QtBot) -> None:
    window, held = make_window(), HeldComparer(lambda request: 40.0)
    page = window.planning.departures
    page._comparer = held
    page.start()
    qtbot.waitUntil(lambda: bool(held.asked))
    assert window.planning.is_busy
    window.close()
    assert not window.planning.is_busy


def test_files_that_are_dropped_are_told_apart(tmp_path: Path) -> None:
    mime = QMimeData()
    names = ("wind.GRB2", "yacht.csv", "sea.nc")
    urls = [QUrl.fromLocalFile(str(tmp_path / name)) for name in names]
    mime.setUrls([*urls, QUrl("https://example.org/wind.grb")])
    winds, others = dropped_files(mime)
    assert [path.name for path in winds] == ["wind.GRB2", "sea.nc"]
    assert [path.name for path in others] == ["yacht.csv"]
