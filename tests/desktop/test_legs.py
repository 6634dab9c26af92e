from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest
from PySide6.QtCore import QAbstractItemModel, QItemSelectionModel, Qt
from PySide6.QtGui import QColor, QGuiApplication
from PySide6.QtTest import QAbstractItemModelTester, QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise.desktop.legs import LegsModel, LegsTable, point_of_sail
from seacruise.desktop.units_choice import units_choice
from seacruise.passage import Passage
from tests.passages import hand_made_passage


@pytest.fixture
def units() -> Iterator[None]:
    """Units may be chosen; afterwards they are as before."""
    yield
    units_choice().choose(wind="kn", distance="nm", height="m", clock="utc")


def cell(model: LegsModel, row: int, key: str) -> str:
    return str(model.index(row, model.column(key)).data())


def row_of(model: QAbstractItemModel, row: int) -> list[str]:
    return [model.index(row, column).data() for column in range(model.columnCount())]


def with_sails() -> Passage:
    passage = hand_made_passage()
    first, *others = passage.waypoints
    return replace(passage, waypoints=(replace(first, sail="Code 0"), *others))


def test_the_model_keeps_qts_rules(app: QApplication) -> None:
    model = LegsModel()
    QAbstractItemModelTester(model, QAbstractItemModelTester.FailureReportingMode.Fatal)
    model.show_passage(hand_made_passage())
    model.show_passage(None)
    assert model.rowCount() == 0


def test_a_row_says_its_leg(app: QApplication) -> None:
    model, passage = LegsModel(), hand_made_passage()
    model.show_passage(passage)
    first = passage.waypoints[0]
    assert first.course_deg is not None
    assert first.twa_deg is not None
    assert cell(model, 0, "time") == "20 Nov 06:00"
    assert cell(model, 0, "position") == "54°31.7'N 018°34.2'E"
    assert cell(model, 0, "cog") == f"{first.course_deg:03.0f}°"
    assert float(cell(model, 0, "leg")) == pytest.approx(first.leg_nm, abs=0.05)
    assert cell(model, 0, "tack") == first.tack
    assert cell(model, 0, "point") == point_of_sail(first.twa_deg)


def test_the_last_row_is_the_arrival_and_engine_is_named(app: QApplication) -> None:
    model, passage = LegsModel(), hand_made_passage()
    model.show_passage(passage)
    assert model.rowCount() == len(passage.waypoints)
    last = row_of(model, model.rowCount() - 1)
    assert [text for text in last[2:] if text not in {"", "–"}] == ["arrival"]
    assert cell(model, model.rowCount() - 2, "tack") == "engine"
    assert cell(model, model.rowCount() - 2, "point") == ""


@pytest.mark.parametrize(
    ("twa", "name"),
    [
        (30.0, "close-hauled"),
        (60.0, "close reach"),
        (90.0, "beam reach"),
        (120.0, "broad reach"),
        (170.0, "run"),
    ],
)
def test_points_of_sail_have_names(app: QApplication, twa: float, name: str) -> None:
    assert point_of_sail(twa) == name


def test_every_column_explains_itself(app: QApplication) -> None:
    model = LegsModel()
    for column in range(model.columnCount()):
        for role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.ToolTipRole):
            assert model.headerData(column, Qt.Orientation.Horizontal, role)


def test_sails_have_a_column_where_the_polar_knows_them(app: QApplication, qtbot: QtBot) -> None:
    table = LegsTable()
    qtbot.addWidget(table)
    table.show_passage(hand_made_passage())
    assert table.isColumnHidden(table.legs.column("sail"))
    table.show_passage(with_sails())
    assert not table.isColumnHidden(table.legs.column("sail"))
    assert cell(table.legs, 0, "sail") == "Code 0"
    assert cell(table.legs, 1, "sail") == "–"


def test_wind_and_tack_have_their_colours(app: QApplication) -> None:
    model = LegsModel()
    model.show_passage(hand_made_passage())
    for key in ("tws", "tack"):
        colour = model.index(0, model.column(key)).data(Qt.ItemDataRole.DecorationRole)
        assert isinstance(colour, QColor)
        model.show_light("night")
        assert model.index(0, model.column(key)).data(Qt.ItemDataRole.DecorationRole) != colour
        model.show_light("day")
    assert model.index(0, 0).data(Qt.ItemDataRole.DecorationRole) is None


def test_the_table_speaks_in_the_units_that_were_chosen(app: QApplication, units: None) -> None:
    model, passage = LegsModel(), hand_made_passage()
    model.show_passage(passage)
    knots = float(cell(model, 0, "tws"))
    units_choice().choose(wind="m/s", distance="km")
    assert float(cell(model, 0, "tws")) == pytest.approx(knots * 0.5144, abs=0.1)
    assert float(cell(model, 0, "leg")) == pytest.approx(
        (passage.waypoints[0].leg_nm or 0.0) * 1.852, abs=0.1
    )
    assert model.headerData(model.column("tws"), Qt.Orientation.Horizontal) == "TWS m/s"


def test_a_leg_is_chosen_from_both_sides(app: QApplication, qtbot: QtBot) -> None:
    table = LegsTable()
    qtbot.addWidget(table)
    table.show_passage(hand_made_passage())
    with qtbot.waitSignal(table.row_chosen) as signal:
        table.choose_leg(3)
    assert signal.args == [3]
    assert {index.row() for index in table.selectedIndexes()} == {3}
    table.choose_leg(-1)
    assert not table.selectedIndexes()


def test_a_row_that_follows_is_told_to_nobody(app: QApplication, qtbot: QtBot) -> None:
    table = LegsTable()
    qtbot.addWidget(table)
    table.show_passage(hand_made_passage())
    with qtbot.assertNotEmitted(table.row_chosen):
        table.mark(4)
    assert table.currentIndex().row() == 4


def test_rows_are_copied_as_text(app: QApplication, qtbot: QtBot) -> None:
    table, passage = LegsTable(), hand_made_passage()
    qtbot.addWidget(table)
    table.show_passage(passage)
    flags = QItemSelectionModel.SelectionFlag.Select | QItemSelectionModel.SelectionFlag.Rows
    for row in (2, 4):
        table.selectionModel().select(table.legs.index(row, 0), flags)
    # Rows that are being selected to be copied are not taken away by the slider.
    table.mark(0)
    QTest.keyClick(table, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    lines = QGuiApplication.clipboard().text().splitlines()
    assert len(lines) == 3
    assert lines[0].split("\t")[:2] == ["Time (UTC)", "Position"]
    assert lines[1].split("\t")[0] == cell(table.legs, 2, "time")
    assert lines[2].split("\t")[0] == cell(table.legs, 4, "time")
    assert "Sail" not in lines[0]
    table.clearSelection()
    assert len(table.text_of_rows().splitlines()) == 1 + len(passage.waypoints)
