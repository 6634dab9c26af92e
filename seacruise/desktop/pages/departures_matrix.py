"""Yachts compared: departures down, yachts across, in each cell how long she takes or when she arrives."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime
from typing import Any

from PySide6.QtCore import (
    QAbstractTableModel,
    QItemSelectionModel,
    QModelIndex,
    QPersistentModelIndex,
    Qt,
    Signal,
)
from PySide6.QtGui import QColor, QPainter, QPen, QPixmap
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView, QWidget

from seacruise.desktop.pages.departures_curve import COLOURS, STROKES
from seacruise.desktop.pages.departures_model import Measure, Row
from seacruise.desktop.pages.words import clock, run_text, short_moment, tr
from seacruise.desktop.style import scaled_font, tinted
from seacruise.desktop.units_choice import units_choice

Index = QModelIndex | QPersistentModelIndex

_ROLES = Qt.ItemDataRole


def fastest_of(rows: Sequence[Row]) -> Row | None:
    """Find the row with the shortest passage; ``None`` where there is none, or one only."""
    found = [row for row in rows if row.found]
    return min(found, key=_hours) if len(found) > 1 else None


def _hours(row: Row) -> float:
    return (row.run.duration_h if row.run is not None else None) or 0.0


class MatrixModel(QAbstractTableModel):
    """Rows of a comparison by departure and yacht; in bold the fastest yacht of each departure."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._departures: tuple[datetime, ...] = ()
        self._yachts: tuple[str, ...] = ()
        self._cells: dict[tuple[int, int], Row] = {}
        self._fastest: set[int] = set()
        self._measure: Measure = "duration"
        self.light = "day"
        self._bold = scaled_font(parent.font(), 1.0, bold=True)

    def show_rows(self, rows: Sequence[Row], yachts: Sequence[str], measure: Measure) -> None:
        """Show rows: each yacht has the same departures, in the same order."""
        many = len(rows) // max(len(yachts), 1)
        fresh = (many, tuple(yachts)) != (len(self._departures), self._yachts)
        if fresh:
            self.beginResetModel()
        self._measure, self._yachts = measure, tuple(yachts)
        self._cells = {divmod(k, many)[::-1]: row for k, row in enumerate(rows)}
        self._departures = tuple(row.departure for row in rows[:many])
        each = ([row for at, row in self._cells.items() if at[0] == k] for k in range(many))
        self._fastest = {row.number for row in map(fastest_of, each) if row is not None}
        if fresh:
            self.endResetModel()
        else:
            self.show_units()

    def show_units(self) -> None:
        """Write everything anew in the zone that was chosen."""
        if self._cells:
            self.dataChanged.emit(
                self.index(0, 0), self.index(len(self._departures) - 1, len(self._yachts) - 1)
            )
            self.headerDataChanged.emit(Qt.Orientation.Vertical, 0, len(self._departures) - 1)

    def row_at(self, index: Index) -> Row | None:
        """Departure and yacht of a cell."""
        return self._cells.get((index.row(), index.column()))

    def index_of(self, number: int) -> QModelIndex:
        """Cell of a row's number; not valid where there is none."""
        at = next((at for at, row in self._cells.items() if row.number == number), None)
        return QModelIndex() if at is None else self.index(*at)

    def rowCount(self, parent: Index | None = None) -> int:
        """Departures."""
        return 0 if parent is not None and parent.isValid() else len(self._departures)

    def columnCount(self, parent: Index | None = None) -> int:
        """Yachts."""
        return 0 if parent is not None and parent.isValid() else len(self._yachts)

    def data(self, index: Index, role: int = _ROLES.DisplayRole) -> Any:
        """Text and looks of a cell."""
        row = self._cells[index.row(), index.column()]
        if role == _ROLES.DisplayRole:
            return self._text(row)
        if role == _ROLES.ToolTipRole:
            return None if row.run is None else run_text(row.run)
        if role == _ROLES.FontRole:
            return self._bold if row.number in self._fastest else None
        if role == _ROLES.TextAlignmentRole:
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        return None

    def _text(self, row: Row) -> str:
        if row.run is None:
            return "…"
        if row.run.duration_h is None or row.run.arrival is None:
            return tr("none")
        return clock(row.run.duration_h) if self._measure == "duration" else short_moment(row.run.arrival)

    def _swatch(self, yacht: int) -> QPixmap:
        """Piece of a yacht's curve: by night the colours are one, the strokes are not."""
        swatch = QPixmap(26, 9)
        swatch.fill(Qt.GlobalColor.transparent)
        painter, kind = QPainter(swatch), yacht % len(COLOURS)
        painter.setPen(QPen(QColor(tinted(COLOURS[kind], self.light)), 2.0, STROKES[kind]))
        painter.drawLine(0, 5, 26, 5)
        painter.end()
        return swatch

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = _ROLES.DisplayRole) -> Any:
        """Yachts across, departures down."""
        across = orientation == Qt.Orientation.Horizontal
        if role in {_ROLES.DisplayRole, _ROLES.ToolTipRole}:
            return self._yachts[section] if across else short_moment(self._departures[section])
        if role == _ROLES.DecorationRole and across:
            return self._swatch(section)
        if role == _ROLES.TextAlignmentRole:
            side = Qt.AlignmentFlag.AlignRight if across else Qt.AlignmentFlag.AlignLeft
            return side | Qt.AlignmentFlag.AlignVCenter
        return None


class YachtMatrix(QTableView):
    """The matrix.

    Signals: ``chosen(row or None)`` when another cell is the current one, ``taken(row)`` when one is entered,
    clicked or clicked twice.
    """

    chosen = Signal(object)
    taken = Signal(object)

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.cells = MatrixModel(self)
        self.setModel(self.cells)
        self.setAccessibleName(tr("Yachts compared, by departure"))
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setAlternatingRowColors(True)
        self.setShowGrid(False)
        self.setTabKeyNavigation(False)
        head, side = self.horizontalHeader(), self.verticalHeader()
        for header in (head, side):
            header.setHighlightSections(False)
            header.setSectionsClickable(False)
        head.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        head.setMinimumSectionSize(self.fontMetrics().horizontalAdvance("Wed 00 00:00") + 14)
        head.setTextElideMode(Qt.TextElideMode.ElideRight)
        side.setDefaultSectionSize(self.fontMetrics().height() + 9)
        units_choice().changed.connect(self.cells.show_units)
        self.selectionModel().currentChanged.connect(lambda at: self.chosen.emit(self.cells.row_at(at)))
        for signal in (self.activated, self.clicked):
            signal.connect(lambda at: self.taken.emit(self.cells.row_at(at)))

    def choose(self, number: int | None) -> None:
        """Make the cell of a row's number the current one; none where there is none."""
        at = QModelIndex() if number is None else self.cells.index_of(number)
        if at != self.currentIndex():
            self.selectionModel().setCurrentIndex(at, QItemSelectionModel.SelectionFlag.ClearAndSelect)
