"""The page of ports in reach, with the search in the test's hand."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise.desktop.pages.page import Phase
from seacruise.desktop.pages.reach_model import Outset
from seacruise.desktop.pages.reach_page import ReachPage
from seacruise.errors import InputError
from seacruise.ports import load_ports
from seacruise.settings import Settings
from tests.desktop.pages.doubles import HeldExplorer, fetch_for_reach, outset, port

BACK, LEAVE_BY, ARRIVES, FITS = 4, 5, 3, 1


class Asks:
    """What the form would ask."""

    def __init__(self) -> None:
        self.outset: Outset | InputError = outset()

    def __call__(self) -> Outset:
        if isinstance(self.outset, InputError):
            raise self.outset
        return self.outset


@pytest.fixture
def asks() -> Asks:
    return Asks()


@pytest.fixture
def explorer() -> HeldExplorer:
    return HeldExplorer()


@pytest.fixture
def page(
    app: QApplication, qtbot: QtBot, settings: Settings, asks: Asks, explorer: HeldExplorer
) -> Iterator[ReachPage]:
    page = ReachPage(settings, ask=asks, fetcher=fetch_for_reach, explorer=explorer)
    qtbot.addWidget(page)
    page.set_ports(load_ports())
    page.time_box.setValue(20)
    page.resize(900, 400)
    page.show()
    yield page
    explorer.gate.set()
    page.shut_down()


def explored(page: ReachPage, explorer: HeldExplorer, qtbot: QtBot) -> None:
    explorer.gate.set()
    with qtbot.waitSignal(page.settled, timeout=20_000):
        QTest.mouseClick(page.run_button, Qt.MouseButton.LeftButton)
    assert page.phase is Phase.DONE


def cells(page: ReachPage, column: int) -> list[str]:
    model = page.table.sorted
    return [str(model.index(row, column).data()) for row in range(model.rowCount())]


def test_it_begins_by_saying_what_it_is_for(page: ReachPage) -> None:
    assert page.phase is Phase.EMPTY
    assert page.invitation.isVisible()
    assert not page.body.isVisible()


def test_it_finds_ports_and_says_what_fits(page: ReachPage, explorer: HeldExplorer, qtbot: QtBot) -> None:
    page.start()
    qtbot.waitUntil(lambda: page.message.text() == "Half of the vertices settled")
    assert page.phase is Phase.BUSY
    with qtbot.waitSignals([page.settled, page.isochrones_ready], timeout=20_000):
        explorer.gate.set()
    assert page.sentence.text() == "One port fits, Byxelkrok: 5 h to spare by Mon 21 02:00 UTC."
    assert cells(page, 0) == ["Byxelkrok SE", "Västervik SE", "Świnoujście PL"]
    assert cells(page, FITS) == ["fits, 5 h to spare", "5 h too long", "no time to sail back"]
    assert cells(page, LEAVE_BY) == ["Sun 20 20:00", "", ""]
    assert page.heading.text() == "20 h from Visby, leaving Sun 20 06:00 UTC, Bavaria 46 Cruiser"
    assert page.notice.text() == "Test wind: not a forecast."


def test_one_way_shows_arrivals(page: ReachPage, explorer: HeldExplorer, qtbot: QtBot) -> None:
    page.back_box.click()
    assert not page.stay_box.isEnabled()
    explored(page, explorer, qtbot)
    assert page.table.isColumnHidden(BACK)
    assert page.table.isColumnHidden(LEAVE_BY)
    assert cells(page, ARRIVES)[0] == "Sun 20 11:00"
    assert page.sentence.text().startswith("3 ports are reached by Mon 21 02:00 UTC")
    page.back_box.click()
    explored(page, explorer, qtbot)
    assert page.table.isColumnHidden(ARRIVES)
    assert not page.table.isColumnHidden(BACK)


def test_days_are_hours(page: ReachPage, explorer: HeldExplorer, qtbot: QtBot) -> None:
    page.unit_box.setCurrentIndex(1)
    page.unit_box.activated.emit(1)
    assert page.time_box.value() == pytest.approx(0.8)
    page.time_box.setValue(7.0)
    assert page.hours == 168.0
    explored(page, explorer, qtbot)
    assert explorer.requests[-1].hours == 168.0
    page.unit_box.setCurrentIndex(0)
    page.unit_box.activated.emit(0)
    assert page.time_box.value() == 168.0


def test_choosing_a_port_and_planning_to_it(page: ReachPage, explorer: HeldExplorer, qtbot: QtBot) -> None:
    explored(page, explorer, qtbot)
    assert not page.adopt_button.isEnabled()
    page.table.setFocus()
    with qtbot.waitSignal(page.port_chosen, timeout=5_000) as chosen:
        page.table.choose(lambda row: row.port.name == "Västervik")
    assert chosen.args == [port("Västervik")]
    with qtbot.waitSignal(page.adopted, timeout=5_000) as adopted:
        QTest.keyClick(page.table, Qt.Key.Key_Return)
    assert adopted.args == [port("Västervik")]
    with qtbot.waitSignal(page.adopted, timeout=5_000):
        QTest.mouseClick(page.adopt_button, Qt.MouseButton.LeftButton)


def test_a_click_chooses_and_does_not_plan(page: ReachPage, explorer: HeldExplorer, qtbot: QtBot) -> None:
    explored(page, explorer, qtbot)
    cell = page.table.visualRect(page.table.sorted.index(2, 0)).center()
    with (
        qtbot.assertNotEmitted(page.adopted, wait=50),
        qtbot.waitSignal(page.port_chosen, timeout=5_000) as chosen,
    ):
        QTest.mouseClick(page.table.viewport(), Qt.MouseButton.LeftButton, pos=cell)
    assert chosen.args == [port("Świnoujście")]


def test_filter_and_sort(page: ReachPage, explorer: HeldExplorer, qtbot: QtBot) -> None:
    explored(page, explorer, qtbot)
    QTest.keyClicks(page.filter_field, "swi")
    assert cells(page, 0) == ["Świnoujście PL"]
    page.fits_box.click()
    assert cells(page, 0) == []
    assert page.none_label.isVisible()
    page.filter_field.clear()
    assert cells(page, 0) == ["Byxelkrok SE"]
    assert not page.none_label.isVisible()
    page.fits_box.click()
    page.table.sortByColumn(FITS, Qt.SortOrder.DescendingOrder)
    assert cells(page, FITS) == ["fits, 5 h to spare", "5 h too long", "no time to sail back"]
    page.table.sortByColumn(FITS, Qt.SortOrder.AscendingOrder)
    assert cells(page, FITS)[-1] == "no time to sail back"


def test_cancelling(page: ReachPage, explorer: HeldExplorer, qtbot: QtBot) -> None:
    page.start()
    qtbot.waitUntil(lambda: bool(explorer.requests))
    with qtbot.waitSignal(page.settled, timeout=5_000) as settled:
        QTest.mouseClick(page.cancel_button, Qt.MouseButton.LeftButton)
    assert settled.args == [Phase.CANCELLED]
    assert page.banner is not None
    assert page.banner.sentence == "Nothing was changed."
    with qtbot.assertNotEmitted(page.isochrones_ready, wait=50):
        explorer.gate.set()


def test_errors_are_said(page: ReachPage, asks: Asks, explorer: HeldExplorer, qtbot: QtBot) -> None:
    asks.outset = InputError("There is no port Visbi; did you mean Visby?")
    page.start()
    assert page.banner is not None
    assert page.banner.sentence == "There is no port Visbi; did you mean Visby?"
    asks.outset = outset()
    page.stay_box.setValue(30)
    with qtbot.waitSignal(page.settled, timeout=20_000):
        page.start()
    assert page.phase is Phase.FAILED
    assert page.banner.sentence.startswith("A stay of 30 h does not fit into 20 h")


def test_without_ports_it_asks_for_patience(page: ReachPage) -> None:
    page.set_ports(())
    page.start()
    assert page.banner is not None
    assert "not loaded yet" in page.banner.sentence


@pytest.mark.parametrize("width", [480, 900])
def test_it_fits_narrow_and_wide(page: ReachPage, explorer: HeldExplorer, qtbot: QtBot, width: int) -> None:
    explored(page, explorer, qtbot)
    page.resize(width, 600)
    QApplication.processEvents()
    assert page.width() == width
    for widget in (page.time_box, page.run_button, page.adopt_button):
        assert widget.mapTo(page, widget.rect().topRight()).x() < width


def test_everything_that_takes_a_hand_has_a_name(page: ReachPage) -> None:
    for widget in (page, page.time_box, page.unit_box, page.stay_box, page.filter_field, page.table):
        assert widget.accessibleName()
