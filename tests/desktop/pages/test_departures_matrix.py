"""Yachts compared, a column each: what the cells say, what stands out, what a click does."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from seacruise.desktop.pages.departures_matrix import YachtMatrix
from seacruise.desktop.pages.departures_model import Arrived, Comparison
from seacruise.desktop.pages.departures_page import DeparturesPage
from seacruise.desktop.units_choice import units_choice
from seacruise.settings import Settings
from tests.desktop.pages.doubles import (
    BAVARIA,
    HeldComparer,
    begun,
    fetch_for_departures,
    later,
    question,
    run_of,
    yachts,
)

FOLKBOAT = "Nordic Folkboat"
HOURS = {(0, BAVARIA): 40.0, (6, BAVARIA): 30.0, (0, FOLKBOAT): 35.0, (6, FOLKBOAT): None}


@pytest.fixture
def comparison() -> Comparison:
    """Two departures of two yachts; the second of the second is not sailed."""
    found = Comparison(begun(2, BAVARIA, FOLKBOAT))
    for number, (departure, yacht) in enumerate(found.begun.slots):
        hours = HOURS[round((departure - later(0)).total_seconds() / 3600), yacht]
        found.add(Arrived(number, run_of(departure, hours, yacht)))
    return found


@pytest.fixture
def matrix(app: QApplication, qtbot: QtBot, comparison: Comparison) -> Iterator[YachtMatrix]:
    parent = QWidget()
    qtbot.addWidget(parent)
    matrix = YachtMatrix(parent)
    matrix.cells.show_rows(comparison.rows(), comparison.yachts, "duration")
    matrix.resize(520, 200)
    parent.show()
    yield matrix
    parent.close()


def texts(matrix: YachtMatrix) -> list[list[str]]:
    cells = matrix.cells
    return [[cells.index(r, c).data() for c in range(cells.columnCount())] for r in range(cells.rowCount())]


def is_bold(matrix: YachtMatrix, row: int, column: int) -> bool:
    font = matrix.cells.index(row, column).data(Qt.ItemDataRole.FontRole)
    return font is not None and font.bold()


def test_a_row_is_a_departure_and_a_column_a_yacht(matrix: YachtMatrix) -> None:
    assert texts(matrix) == [["40 h 00", "35 h 00"], ["30 h 00", "none"]]
    heads = [matrix.cells.headerData(k, Qt.Orientation.Horizontal) for k in range(2)]
    assert heads == [BAVARIA, FOLKBOAT]
    sides = [matrix.cells.headerData(k, Qt.Orientation.Vertical) for k in range(2)]
    assert sides == ["Sun 20 06:00", "Sun 20 12:00"]
    assert "becalmed" in matrix.cells.index(1, 1).data(Qt.ItemDataRole.ToolTipRole)


def test_the_fastest_yacht_of_a_departure_stands_out(matrix: YachtMatrix) -> None:
    assert [[is_bold(matrix, r, c) for c in range(2)] for r in range(2)] == [
        [False, True],
        [False, False],
    ], "alone there is nothing to be faster than"


def test_arrivals_take_the_place_of_hours(matrix: YachtMatrix, comparison: Comparison) -> None:
    matrix.cells.show_rows(comparison.rows(), comparison.yachts, "arrival")
    assert texts(matrix)[0] == ["Mon 21 22:00", "Mon 21 17:00"]


def test_a_click_chooses_and_takes(matrix: YachtMatrix, qtbot: QtBot) -> None:
    at = matrix.visualRect(matrix.cells.index(1, 0)).center()
    with qtbot.waitSignals([matrix.chosen, matrix.taken]) as caught:
        QTest.mouseClick(matrix.viewport(), Qt.MouseButton.LeftButton, pos=at)
    for signal in caught.all_signals_and_args:
        assert (signal.args[0].departure, signal.args[0].yacht) == (later(6.0), BAVARIA)
    matrix.choose(2)
    assert matrix.currentIndex() == matrix.cells.index(0, 1)
    matrix.choose(None)
    assert not matrix.currentIndex().isValid()


@pytest.mark.parametrize("light", ["day", "night"])
def test_each_column_has_a_piece_of_its_curve(matrix: YachtMatrix, light: str) -> None:
    matrix.cells.light = light
    pieces = [
        matrix.cells.headerData(k, Qt.Orientation.Horizontal, Qt.ItemDataRole.DecorationRole).toImage()
        for k in range(2)
    ]
    assert pieces[0] != pieces[1]


# ------------------------------------------------------------------------------------------ on the page


@pytest.fixture
def page(app: QApplication, qtbot: QtBot, settings: Settings) -> DeparturesPage:
    comparer = HeldComparer(lambda request: HOURS.get((0, request.yacht.name)))
    comparer.let_go(1000)
    page = DeparturesPage(settings, ask=question, fetcher=fetch_for_departures, comparer=comparer)
    qtbot.addWidget(page)
    page.set_yachts(yachts())
    page.resize(900, 560)
    page.show()
    return page


def compare(page: DeparturesPage, qtbot: QtBot) -> None:
    page.count_box.setValue(2)
    with qtbot.waitSignal(page.settled, timeout=20_000):
        page.start()


def test_with_one_yacht_there_is_nothing_to_put_side_by_side(page: DeparturesPage, qtbot: QtBot) -> None:
    compare(page, qtbot)
    assert page.table.isVisible()
    assert not page.matrix.isVisible()
    assert page.matrix_button.isHidden()


def test_with_several_the_matrix_comes_and_goes_with_its_button(page: DeparturesPage, qtbot: QtBot) -> None:
    page.add_yacht(FOLKBOAT)
    compare(page, qtbot)
    assert page.matrix.isVisible()
    assert texts(page.matrix) == [["40 h 00", "35 h 00"]] * 2
    page.matrix_button.click()
    assert page.table.isVisible()
    assert not page.matrix.isVisible()


def test_a_cell_is_a_departure_to_adopt(page: DeparturesPage, qtbot: QtBot) -> None:
    page.add_yacht(FOLKBOAT)
    compare(page, qtbot)
    at = page.matrix.visualRect(page.matrix.cells.index(1, 0)).center()
    with qtbot.waitSignal(page.adopted) as caught:
        QTest.mouseClick(page.matrix.viewport(), Qt.MouseButton.LeftButton, pos=at)
    assert caught.args == [later(6.0)]
    assert page.curve.number == page.table.current.number


def test_no_column_is_cut_off_and_an_engine_that_rests_has_none(page: DeparturesPage, qtbot: QtBot) -> None:
    compare(page, qtbot)
    bar = page.table.horizontalScrollBar()
    assert bar.maximum() == 0
    shown = [
        page.table.rows.headerData(k, Qt.Orientation.Horizontal)
        for k in range(page.table.rows.columnCount())
        if not page.table.isColumnHidden(k)
    ]
    assert shown == ["Leaves", "Hours", "Arrives", "Wind", "Upwind", "Night"]
    page.resize(662, 420)
    QApplication.processEvents()
    assert bar.maximum() == 0, page.table.width()


@pytest.fixture
def choose_units() -> Callable[..., None]:
    return units_choice().choose


def test_it_speaks_in_the_units_that_were_chosen(
    page: DeparturesPage, qtbot: QtBot, choose_units: Callable[..., None]
) -> None:
    compare(page, qtbot)
    assert "300 nm" in page.detail.text()
    try:
        choose_units(wind="m/s", distance="km")
        assert page.table.rows.index(0, 4).data() == "12 m/s", "24 kn"
        assert "556 km" in page.detail.text()
    finally:
        choose_units(wind="kn", distance="nm")
