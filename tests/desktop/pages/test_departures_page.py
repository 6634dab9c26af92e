"""The page of departures, with passages in the test's hand."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from datetime import datetime
from functools import partial

import pytest
from PySide6.QtCore import QPoint, QRectF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QPushButton
from pytestqt.qtbot import QtBot

from seacruise.desktop.compute import Question
from seacruise.desktop.messages import WayOut
from seacruise.desktop.pages.departures_curve import DepartureCurve
from seacruise.desktop.pages.departures_model import Curve, Dot
from seacruise.desktop.pages.departures_page import MOST_YACHTS, DeparturesPage
from seacruise.desktop.pages.page import Phase
from seacruise.errors import InputError
from seacruise.passage import PassageRequest
from seacruise.settings import Settings
from tests.desktop.pages.doubles import (
    BAVARIA,
    FIRST,
    HeldComparer,
    fetch_for_departures,
    later,
    port,
    question,
    yachts,
)

HOURS: dict[datetime, float | None] = {
    later(0): 40.0,
    later(6): None,
    later(12): 34.0,
    later(18): 38.0,
}


class Asks:
    """What the form would ask."""

    def __init__(self) -> None:
        self.question: Question | InputError = question()

    def __call__(self) -> Question:
        if isinstance(self.question, InputError):
            raise self.question
        return self.question


def hours_of(request: PassageRequest) -> float | None:
    assert request.departure is not None
    hours = HOURS[request.departure]
    return hours and hours + (0.0 if request.yacht.name == BAVARIA else 20.0)


@pytest.fixture
def asks() -> Asks:
    return Asks()


@pytest.fixture
def comparer() -> HeldComparer:
    return HeldComparer(hours_of)


@pytest.fixture
def page(
    app: QApplication, qtbot: QtBot, settings: Settings, asks: Asks, comparer: HeldComparer
) -> Iterator[DeparturesPage]:
    page = DeparturesPage(settings, ask=asks, fetcher=fetch_for_departures, comparer=comparer)
    qtbot.addWidget(page)
    page.set_yachts(yachts())
    page.count_box.setValue(4)
    page.resize(900, 400)
    page.show()
    yield page
    comparer.let_go(1000)
    page.shut_down()


def compared(page: DeparturesPage, comparer: HeldComparer, qtbot: QtBot) -> None:
    comparer.let_go(1000)
    with qtbot.waitSignal(page.settled, timeout=20_000):
        QTest.mouseClick(page.run_button, Qt.MouseButton.LeftButton)
    assert page.phase is Phase.DONE


def phase_of(page: DeparturesPage) -> Phase:
    """Phase, asked anew: a type checker believes that it stays what it was."""
    return page.phase


def known_are(page: DeparturesPage, count: int) -> bool:
    return page.comparison is not None and page.comparison.known == count


def cells(page: DeparturesPage, column: int) -> list[str]:
    model = page.table.sorted
    return [str(model.index(row, column).data()) for row in range(model.rowCount())]


def test_it_begins_by_saying_what_it_is_for(page: DeparturesPage) -> None:
    assert page.phase is Phase.EMPTY
    assert page.invitation.isVisible()
    assert not page.body.isVisible()
    assert not page.cancel_button.isEnabled()


def test_passages_appear_one_by_one(page: DeparturesPage, comparer: HeldComparer, qtbot: QtBot) -> None:
    QTest.mouseClick(page.run_button, Qt.MouseButton.LeftButton)
    assert page.phase is Phase.BUSY
    assert page.progress.isVisible()
    for known in range(1, 4):
        comparer.let_go()
        qtbot.waitUntil(partial(known_are, page, known))
        assert cells(page, 2).count("…") == 4 - known
        assert page.sentence.text().startswith("So far: ")
        assert page.message.text() == f"Passage {known} of 4"
    with qtbot.waitSignal(page.settled, timeout=20_000):
        comparer.let_go()
    assert phase_of(page) is Phase.DONE
    assert page.sentence.text() == "Leaving Sunday 18:00 UTC saves 6 h: 34 h 00 under way instead of 40 h 00."
    assert page.heading.text() == "Gdynia – Sandhamn, Bavaria 46 Cruiser"
    assert "Test wind" in page.notice.text()


def test_the_table_has_the_figures_and_the_reason(
    page: DeparturesPage, comparer: HeldComparer, qtbot: QtBot
) -> None:
    compared(page, comparer, qtbot)
    model = page.table.sorted
    best = [str(model.index(2, column).data()) for column in range(model.columnCount())]
    assert best == ["Sun 20 18:00", BAVARIA, "34 h 00", "Tue 22 04:00", "23 kn", "25 %", "8", "–"]
    assert page.table.isColumnHidden(1)
    assert cells(page, 2)[1] == "No passage: becalmed"
    assert page.table.columnSpan(1, 2) == 6
    assert page.table.columnSpan(2, 2) == 1
    tip = model.index(1, 2).data(Qt.ItemDataRole.ToolTipRole)
    assert tip == "Sun 20 12:00: The yacht is becalmed off Hel."


def test_a_click_on_a_head_sorts_and_reasons_stay_last(
    page: DeparturesPage, comparer: HeldComparer, qtbot: QtBot
) -> None:
    compared(page, comparer, qtbot)
    for order, hours in (
        (Qt.SortOrder.AscendingOrder, ["34 h 00", "38 h 00", "40 h 00"]),
        (Qt.SortOrder.DescendingOrder, ["40 h 00", "38 h 00", "34 h 00"]),
    ):
        page.table.sortByColumn(2, order)
        assert cells(page, 2) == [*hours, "No passage: becalmed"]
        assert page.table.columnSpan(3, 2) == 6


def test_a_click_on_the_curve_adopts(page: DeparturesPage, comparer: HeldComparer, qtbot: QtBot) -> None:
    compared(page, comparer, qtbot)
    place = page.curve.place_of(3)
    assert place is not None
    with qtbot.waitSignal(page.adopted, timeout=5_000) as adopted:
        QTest.mouseClick(page.curve, Qt.MouseButton.LeftButton, pos=place.toPoint() + QPoint(4, 5))
    assert adopted.args == [later(18)]
    assert page.table.current.number == 3
    assert page.detail.text() == "Mon 21 00:00 to Tue 22 14:00 UTC: 38 h 00, 300 nm."


def test_the_curve_by_keyboard(page: DeparturesPage, comparer: HeldComparer, qtbot: QtBot) -> None:
    compared(page, comparer, qtbot)
    chosen: list[int] = []
    page.curve.chosen.connect(chosen.append)
    for key in (Qt.Key.Key_Home, Qt.Key.Key_Right, Qt.Key.Key_Right, Qt.Key.Key_Left, Qt.Key.Key_End):
        QTest.keyClick(page.curve, key)
    assert chosen == [0, 1, 2, 1, 3]
    with qtbot.waitSignal(page.adopted, timeout=5_000) as adopted:
        QTest.keyClick(page.curve, Qt.Key.Key_Return)
    assert adopted.args == [later(18)]


def test_the_table_by_keyboard_and_by_mouse(
    page: DeparturesPage, comparer: HeldComparer, qtbot: QtBot
) -> None:
    compared(page, comparer, qtbot)
    assert page.table.current.departure == later(12), "the best is chosen when all are known"
    page.table.choose(lambda row: row.number == 0)
    assert page.curve.number == 0
    with qtbot.waitSignal(page.adopted, timeout=5_000) as adopted:
        QTest.keyClick(page.table, Qt.Key.Key_Return)
    assert adopted.args == [FIRST]
    cell = page.table.visualRect(page.table.sorted.index(3, 0)).center()
    with qtbot.waitSignal(page.adopted, timeout=5_000) as adopted:
        QTest.mouseClick(page.table.viewport(), Qt.MouseButton.LeftButton, pos=cell)
    assert adopted.args == [later(18)]
    with qtbot.waitSignal(page.adopted, timeout=5_000):
        QTest.mouseClick(page.adopt_button, Qt.MouseButton.LeftButton)


def test_a_departure_without_a_passage_is_not_adopted(
    page: DeparturesPage, comparer: HeldComparer, qtbot: QtBot
) -> None:
    compared(page, comparer, qtbot)
    with qtbot.assertNotEmitted(page.adopted, wait=50):
        page.table.choose(lambda row: row.number == 1)
        QTest.keyClick(page.table, Qt.Key.Key_Return)
        QTest.keyClick(page.curve, Qt.Key.Key_Return)
    assert not page.adopt_button.isEnabled()
    assert page.detail.text() == "Sun 20 12:00: The yacht is becalmed off Hel."


def test_cancelling_keeps_what_was_found(page: DeparturesPage, comparer: HeldComparer, qtbot: QtBot) -> None:
    page.start()
    comparer.let_go()
    qtbot.waitUntil(lambda: page.comparison is not None)
    page.run_button.setFocus()
    with qtbot.waitSignal(page.settled, timeout=5_000) as settled:
        QTest.keyClick(page, Qt.Key.Key_Escape)
    assert settled.args == [Phase.CANCELLED]
    assert page.banner is not None
    assert page.banner.title == "Cancelled"
    assert cells(page, 2).count("not compared") == 3
    assert page.sentence.text().startswith("Of the 1 that were compared: ")
    assert page.run_button.isEnabled()
    comparer.let_go(100)
    QTest.qWait(50)
    assert page.comparison is not None
    assert page.comparison.known == 1


def test_an_earlier_comparison_stays_until_there_is_another(
    page: DeparturesPage, comparer: HeldComparer, qtbot: QtBot
) -> None:
    compared(page, comparer, qtbot)
    said = page.sentence.text()
    while comparer._free.acquire(blocking=False):
        pass
    page.start()
    qtbot.waitUntil(lambda: page.message.text().startswith("Passage 1"))
    page.cancel()
    assert page.sentence.text() == said


def test_a_wrong_form_is_said_and_starts_nothing(page: DeparturesPage, asks: Asks) -> None:
    asks.question = InputError("There is no port Gdynai; did you mean Gdynia?")
    page.start()
    assert page.phase is Phase.FAILED
    assert page.banner is not None
    assert page.banner.sentence == "There is no port Gdynai; did you mean Gdynia?"
    assert not page.jobs.is_running


def test_a_departure_outside_the_forecast_offers_a_way_out(
    page: DeparturesPage, asks: Asks, qtbot: QtBot
) -> None:
    asks.question = replace(question(), departure=later(2000))
    with qtbot.waitSignal(page.settled, timeout=20_000):
        page.start()
    assert page.phase is Phase.FAILED
    assert page.banner is not None
    assert page.banner.way_out is WayOut.DEPARTURE
    assert not page.body.isVisible()


def test_other_yachts_come_and_go(page: DeparturesPage, comparer: HeldComparer, qtbot: QtBot) -> None:
    page.add_yacht("Nordic Folkboat")
    page.add_yacht("Nordic Folkboat")
    page.add_yacht("No such yacht")
    assert page.extra_yachts == ["Nordic Folkboat"]
    compared(page, comparer, qtbot)
    assert not page.table.isColumnHidden(1)
    assert len(cells(page, 1)) == 8
    assert page.sentence.text().startswith("Bavaria 46 Cruiser is fastest. Leaving Sunday 18:00 UTC")
    QTest.keyClick(page.curve, Qt.Key.Key_Home)
    page.curve.choose(2)
    QTest.keyClick(page.curve, Qt.Key.Key_Down)
    assert page.table.current.yacht == "Nordic Folkboat"
    assert page.table.current.departure == later(12)
    leave_out = next(b for b in page.findChildren(QPushButton) if b.text() == "✕ Nordic Folkboat")
    QTest.mouseClick(leave_out, Qt.MouseButton.LeftButton)
    assert page.extra_yachts == []


def test_no_more_yachts_than_are_told_apart(page: DeparturesPage) -> None:
    (polar,) = {name: p for name, p in yachts().items() if name == BAVARIA}.values()
    page.set_yachts({f"Yacht {k}": polar for k in range(6)})
    for k in range(6):
        page.add_yacht(f"Yacht {k}")
    assert len(page.extra_yachts) == MOST_YACHTS - 1
    assert not page.yacht_box.isEnabled()
    page.set_yachts({"Yacht 1": polar})
    assert page.extra_yachts == ["Yacht 1"]


def test_a_passage_by_way_of_a_place_says_what_is_compared(
    page: DeparturesPage, asks: Asks, comparer: HeldComparer, qtbot: QtBot
) -> None:
    asks.question = replace(question(), via=port("Visby"))
    compared(page, comparer, qtbot)
    assert "not by way of Visby" in page.notice.text()


def test_the_curve_turns_to_arrivals(page: DeparturesPage, comparer: HeldComparer, qtbot: QtBot) -> None:
    compared(page, comparer, qtbot)
    before = page.curve.grab().toImage()
    page._measures.button(1).click()
    assert page.measure == "arrival"
    assert page.curve.grab().toImage() != before


@pytest.mark.parametrize("hours", [(50, 49, 47, 42, 39, 37), (37, 39, 42, 47, 49, 50), (45, 40, 37, 40, 45)])
@pytest.mark.parametrize("width", [250, 320, 900])
def test_the_best_departure_is_named_beside_the_dots(
    app: QApplication, qtbot: QtBot, hours: tuple[float, ...], width: int
) -> None:
    curve = DepartureCurve()
    qtbot.addWidget(curve)
    curve.resize(width, 200)
    dots = tuple(Dot(k, FIRST.timestamp() + 6 * 3600 * k, float(value)) for k, value in enumerate(hours))
    best = hours.index(min(hours))
    curve.show_curves([Curve(BAVARIA, dots)], "duration", best=frozenset({best}))
    box = curve.box_of_name()
    assert box is not None
    assert QRectF(curve.rect()).contains(box)
    places = [curve.place_of(dot.number) for dot in dots]
    assert not [place for place in places if place is not None and box.contains(place)]


def test_a_curve_without_departures_paints_and_takes_keys(app: QApplication, qtbot: QtBot) -> None:
    curve = DepartureCurve()
    qtbot.addWidget(curve)
    curve.show()
    for light in ("day", "dusk", "night"):
        curve.show_light(light)
        assert not curve.grab().isNull()
    QTest.keyClick(curve, Qt.Key.Key_Right)
    QTest.mouseClick(curve, Qt.MouseButton.LeftButton)
    assert curve.number is None


@pytest.mark.parametrize(("width", "beside"), [(480, False), (940, True)])
def test_it_fits_narrow_and_wide(
    page: DeparturesPage, comparer: HeldComparer, qtbot: QtBot, width: int, beside: bool
) -> None:
    compared(page, comparer, qtbot)
    page.resize(width, 600)
    QApplication.processEvents()
    assert page.width() == width
    assert (page.table.mapTo(page, QPoint()).x() > page.curve.mapTo(page, QPoint()).x()) is beside
    assert page.cancel_button.isHidden()
    for widget in (page.count_box, page.run_button, page.adopt_button):
        right = widget.mapTo(page, widget.rect().topRight()).x()
        assert right < width


def test_everything_that_takes_a_hand_has_a_name(page: DeparturesPage) -> None:
    for widget in (page, page.count_box, page.every_box, page.yacht_box, page.curve, page.table):
        assert widget.accessibleName()
