from __future__ import annotations

import pytest
from PySide6.QtCore import QAbstractItemModel, Qt
from PySide6.QtTest import QAbstractItemModelTester
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise.desktop.legs import LegsModel, LegsTable
from tests.passages import hand_made_passage


def row_of(model: QAbstractItemModel, row: int) -> list[str]:
    return [model.index(row, column).data() for column in range(model.columnCount())]


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
    cells = row_of(model, 0)
    assert cells[0] == "20 Nov 06:00"
    assert cells[1] == "54°31.7'N 018°34.2'E"
    assert cells[2] == f"{first.course_deg:03.0f}°"
    assert float(cells[3]) == pytest.approx(first.leg_nm, abs=0.05)
    assert cells[8] == first.tack


def test_the_last_row_is_the_arrival_and_engine_is_named(app: QApplication) -> None:
    model, passage = LegsModel(), hand_made_passage()
    model.show_passage(passage)
    assert model.rowCount() == len(passage.waypoints)
    assert row_of(model, model.rowCount() - 1)[2:] == ["", "", "", "", "", "", "arrival"]
    assert row_of(model, model.rowCount() - 2)[8] == "engine"


def test_every_column_explains_itself(app: QApplication) -> None:
    model = LegsModel()
    for column in range(model.columnCount()):
        for role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.ToolTipRole):
            assert model.headerData(column, Qt.Orientation.Horizontal, role)


def test_a_leg_is_chosen_from_both_sides(app: QApplication, qtbot: QtBot) -> None:
    table = LegsTable()
    qtbot.addWidget(table)
    table.show_passage(hand_made_passage())
    with qtbot.waitSignal(table.leg_chosen) as signal:
        table.choose_leg(3)
    assert signal.args == [3]
    assert {index.row() for index in table.selectedIndexes()} == {3}
    table.choose_leg(-1)
    assert not table.selectedIndexes()
