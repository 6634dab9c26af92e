"""Tables of rows to sort, filter and take one from: what both pages share."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from PySide6.QtCore import (
    QAbstractTableModel,
    QItemSelectionModel,
    QModelIndex,
    QPersistentModelIndex,
    QSortFilterProxyModel,
    Qt,
    Signal,
)
from PySide6.QtGui import QFont, QFontMetrics, QResizeEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView, QWidget

from seacruise.desktop.style import scaled_font
from seacruise.desktop.units_choice import units_choice

Index = QModelIndex | QPersistentModelIndex

SORT_ROLE: Final = Qt.ItemDataRole.UserRole
_PADDING_PX: Final = 10
_FRAME_PX: Final = 2
_SHARED_PX: Final = 120
_LEAST_PX: Final = 28
_MOST_PX: Final = 900
_ARROW_ROOM: Final = "   "


@dataclass(frozen=True, slots=True)
class Column:
    """A column of a table.

    Attributes
    ----------
    head
        Its head, or what gives it where that changes with the units.
    text, key
        What a row shows, and what it is sorted by; a key of ``None`` comes last in either direction.
    sample
        A text as wide as the column must be.
    takes_rest
        Takes the room that is left besides.
    """

    head: str | Callable[[], str]
    tip: str
    text: Callable[[Any], str]
    key: Callable[[Any], Any]
    sample: str
    left: bool = False
    takes_rest: bool = False


def head_of(column: Column) -> str:
    """Give the head of a column."""
    return column.head if isinstance(column.head, str) else column.head()


@dataclass(frozen=True, slots=True)
class Looks:
    """How rows look besides their cells.

    Attributes
    ----------
    note
        A sentence in place of all cells from ``note_column`` on, or empty.
    tip
        Tool tip of a row.
    bold
        Whether a row stands out.
    """

    note: Callable[[Any], str] = lambda _row: ""
    note_column: int = 0
    tip: Callable[[Any], str] = lambda _row: ""
    bold: Callable[[Any], bool] = lambda _row: False


class RowsModel(QAbstractTableModel):
    """Rows of a page; they are replaced one by one or as a whole."""

    def __init__(self, columns: Sequence[Column], looks: Looks, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.columns, self.looks = tuple(columns), looks
        self.rows: list[Any] = []
        self.bold_font = QFont() if parent is None else scaled_font(parent.font(), 1.0, bold=True)

    def show_rows(self, rows: Sequence[Any]) -> None:
        """Show rows; when there are as many as before, those are changed and none is lost from sight."""
        if len(rows) == len(self.rows) and rows:
            changed = [number for number, row in enumerate(rows) if row != self.rows[number]]
            self.rows = list(rows)
            last = len(self.columns) - 1
            # Row by row: whatever is said to have changed is sorted in anew.
            for number in changed:
                self.dataChanged.emit(self.index(number, 0), self.index(number, last))
            return
        self.beginResetModel()
        self.rows = list(rows)
        self.endResetModel()

    def rowCount(self, parent: Index | None = None) -> int:
        """Rows."""
        return 0 if parent is not None and parent.isValid() else len(self.rows)

    def columnCount(self, parent: Index | None = None) -> int:
        """Columns."""
        return 0 if parent is not None and parent.isValid() else len(self.columns)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Text, sorting key and looks of a cell."""
        row, column = self.rows[index.row()], self.columns[index.column()]
        if role == Qt.ItemDataRole.DisplayRole:
            note = self.looks.note(row)
            if note and index.column() >= self.looks.note_column:
                return note if index.column() == self.looks.note_column else ""
            return column.text(row)
        if role == SORT_ROLE:
            return column.key(row)
        if role == Qt.ItemDataRole.ToolTipRole:
            return self.looks.tip(row) or None
        if role == Qt.ItemDataRole.FontRole:
            return self.bold_font if self.looks.bold(row) else None
        if role == Qt.ItemDataRole.TextAlignmentRole:
            left = column.left or bool(self.looks.note(row))
            return _side(left=left)
        return None

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """Heads of the columns."""
        if orientation == Qt.Orientation.Vertical:
            return None
        column = self.columns[section]
        if role == Qt.ItemDataRole.DisplayRole:
            return head_of(column)
        if role == Qt.ItemDataRole.ToolTipRole:
            return column.tip
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return _side(left=column.left)
        return None


def _side(*, left: bool) -> Qt.AlignmentFlag:
    side = Qt.AlignmentFlag.AlignLeft if left else Qt.AlignmentFlag.AlignRight
    return side | Qt.AlignmentFlag.AlignVCenter


class SortedRows(QSortFilterProxyModel):
    """Sorts by the columns' keys and shows what is accepted."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._accepts: Callable[[Any], bool] = lambda _row: True
        self.setSortRole(SORT_ROLE)
        self.setDynamicSortFilter(True)

    def show_only(self, accepts: Callable[[Any], bool]) -> None:
        """Show the rows that are accepted."""
        self._accepts = accepts
        self.invalidate()

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """Heads of the columns; the one sorted by leaves room for the arrow, which is drawn over its end."""
        given = super().headerData(section, orientation, role)
        if role != Qt.ItemDataRole.DisplayRole or section != self.sortColumn() or not isinstance(given, str):
            return given
        return f"{given}{_ARROW_ROOM}"

    def row_at(self, index: Index) -> Any:
        """Row at a place of the table."""
        model = self.sourceModel()
        assert isinstance(model, RowsModel)
        return model.rows[self.mapToSource(index).row()]

    def filterAcceptsRow(self, source_row: int, source_parent: Index) -> bool:
        """Ask whoever filters."""
        del source_parent
        model = self.sourceModel()
        assert isinstance(model, RowsModel)
        return self._accepts(model.rows[source_row])

    def lessThan(self, source_left: Index, source_right: Index) -> bool:
        """Compare keys; rows without one come last in either direction."""
        left, right = (self.sourceModel().data(index, SORT_ROLE) for index in (source_left, source_right))
        if left is None or right is None:
            if left is right:
                return False
            return (left is None) == (self.sortOrder() == Qt.SortOrder.DescendingOrder)
        return bool(left < right)


class RowsTable(QTableView):
    """The table.

    Signals: ``chosen(row or None)`` when the current row is another one, ``taken(row)`` when a row is
    entered or clicked twice, ``pressed_row(row)`` when one is clicked.
    """

    chosen = Signal(object)
    taken = Signal(object)
    pressed_row = Signal(object)

    def __init__(
        self, name: str, columns: Sequence[Column], looks: Looks, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.rows = RowsModel(columns, looks, self)
        self._own: dict[int, int] = {}
        self._is_sharing = False
        self.sorted = SortedRows(self)
        self.sorted.setSourceModel(self.rows)
        self.setModel(self.sorted)
        self.setAccessibleName(name)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setAlternatingRowColors(True)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.setTabKeyNavigation(False)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 9)
        self._size_columns()
        self.setSortingEnabled(True)
        self.sortByColumn(0, Qt.SortOrder.AscendingOrder)
        self.selectionModel().currentRowChanged.connect(self._row_changed)
        self.activated.connect(lambda index: self.taken.emit(self.sorted.row_at(index)))
        self.clicked.connect(lambda index: self.pressed_row.emit(self.sorted.row_at(index)))
        units_choice().changed.connect(self._show_units)
        for changed in (self.sorted.layoutChanged, self.sorted.modelReset):
            changed.connect(self._join_cells)

    def _show_units(self) -> None:
        """Write everything anew in the units that were chosen."""
        last = len(self.rows.columns) - 1
        self.rows.headerDataChanged.emit(Qt.Orientation.Horizontal, 0, last)
        if self.rows.rows:
            self.rows.dataChanged.emit(self.rows.index(0, 0), self.rows.index(len(self.rows.rows) - 1, last))

    def _size_columns(self) -> None:
        head = self.horizontalHeader()
        head.setHighlightSections(False)
        head.setSortIndicatorShown(True)
        head.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        head.setMinimumSectionSize(_LEAST_PX)
        for number in range(len(self.rows.columns)):
            self.setColumnWidth(number, self._width_of(number))
        # Only now: these were nobody's wish.
        head.sectionResized.connect(self._drawn_out)

    def _drawn_out(self, number: int, before: int, width: int) -> None:
        """Keep the width that the sailor gives a column; one that is hidden or comes back has none."""
        if not self._is_sharing and before and width:
            self._own[number] = min(width, _MOST_PX)

    def contents(self) -> dict[str, object]:
        """Give what is worth keeping for the next start: widths that the sailor chose, and the order."""
        head = self.horizontalHeader()
        down = head.sortIndicatorOrder() == Qt.SortOrder.DescendingOrder
        widths = {str(number): width for number, width in self._own.items()}
        return {"widths": widths, "by": head.sortIndicatorSection(), "down": down}

    def restore(self, kept: Mapping[str, Any]) -> None:
        """Show what `contents` gave; what is not of its kind, as in a damaged file, is passed over."""
        widths, by, count = kept.get("widths"), kept.get("by"), len(self.rows.columns)
        for key, width in widths.items() if isinstance(widths, dict) else ():
            if str(key).isdecimal() and int(key) < count and type(width) is int:
                self._own[int(key)] = min(max(width, _LEAST_PX), _MOST_PX)
        if type(by) is int and 0 <= by < count:
            orders = Qt.SortOrder.AscendingOrder, Qt.SortOrder.DescendingOrder
            self.sortByColumn(by, orders[bool(kept.get("down"))])
        self._share_room()

    def _width_of(self, number: int) -> int:
        if number in self._own:
            return self._own[number]
        column = self.rows.columns[number]
        bold = QFontMetrics(self.rows.bold_font)
        head = self.horizontalHeader().fontMetrics().horizontalAdvance(head_of(column) + _ARROW_ROOM) + 4
        return max(bold.horizontalAdvance(column.sample), head) + _PADDING_PX

    @property
    def needed_px(self) -> int:
        """Width with which no column that is shown is cut off."""
        shown = [k for k in range(len(self.rows.columns)) if not self.isColumnHidden(k)]
        bar = self.verticalScrollBar().sizeHint().width()
        return sum(self._width_of(k) for k in shown) + bar + 2 * _FRAME_PX

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Share the room out anew."""
        super().resizeEvent(event)
        self._share_room()

    def _share_room(self) -> None:
        """Share the room that is left out; Qt's own stretching would squeeze a column to nothing.

        Half of it goes to the column that takes the rest: all of it would put the figures of a wide window
        far away from what they are of.
        """
        columns = self.rows.columns
        shown = [k for k in range(len(columns)) if not self.isColumnHidden(k)]
        taker = next((k for k in shown if columns[k].takes_rest), None)
        if taker is None:
            return
        spare = max(self.viewport().width() - sum(self._width_of(k) for k in shown), 0)
        free = [k for k in shown if k not in self._own]
        each = spare // (2 * len(shown)) if spare > _SHARED_PX and taker in free else 0
        self._is_sharing = True
        for k in shown:
            more = each if k != taker else spare - each * (len(free) - 1)
            self.setColumnWidth(k, self._width_of(k) + (more if k in free else 0))
        self._is_sharing = False

    def show_rows(self, rows: Sequence[Any]) -> None:
        """Show rows; the current one stays so where it is still there."""
        self.rows.show_rows(rows)
        self._join_cells()
        self._share_room()

    def choose(self, matches: Callable[[Any], bool]) -> None:
        """Make the first row that matches the current one; none when there is none."""
        for number in range(self.sorted.rowCount()):
            index = self.sorted.index(number, 0)
            if matches(self.sorted.row_at(index)):
                flags = QItemSelectionModel.SelectionFlag
                self.selectionModel().setCurrentIndex(index, flags.ClearAndSelect | flags.Rows)
                self.scrollTo(index)
                return
        self.clearSelection()
        self.selectionModel().clearCurrentIndex()

    @property
    def current(self) -> Any:
        """The row that is chosen, or ``None``."""
        index = self.currentIndex()
        return self.sorted.row_at(index) if index.isValid() else None

    def _row_changed(self, current: QModelIndex) -> None:
        self.chosen.emit(self.sorted.row_at(current) if current.isValid() else None)

    def _join_cells(self) -> None:
        """Give a row's note the room of the cells that it stands for."""
        self.clearSpans()
        begin = self.rows.looks.note_column
        wide = len(self.rows.columns) - begin
        for number in range(self.sorted.rowCount()):
            if self.rows.looks.note(self.sorted.row_at(self.sorted.index(number, 0))):
                self.setSpan(number, begin, 1, wide)
