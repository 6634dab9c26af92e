"""A table whose rows belong to moments of the passage, and can be copied as text."""

from __future__ import annotations

from PySide6.QtCore import QAbstractItemModel, QItemSelectionModel, QModelIndex, QSize, Qt, Signal
from PySide6.QtGui import QGuiApplication, QKeyEvent, QKeySequence
from PySide6.QtWidgets import QAbstractItemView, QTableView, QWidget


class LinkedTable(QTableView):
    """Rows to choose and to copy; ``row_chosen(number)`` when the sailor chooses another, -1 for none.

    Rows that `mark` chooses are told to nobody: they follow what was chosen elsewhere. Ctrl+C copies the
    selected rows with their heads, columns parted by tabs, as spreadsheets take them.
    """

    row_chosen = Signal(int)

    def __init__(self, model: QAbstractItemModel, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        model.setParent(self)
        self.setModel(model)
        self._marking = False
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setAlternatingRowColors(True)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.setTabKeyNavigation(False)
        self.setIconSize(QSize(11, 11))
        self.setFrameShape(QTableView.Shape.NoFrame)
        rows = self.verticalHeader()
        rows.setDefaultSectionSize(self.fontMetrics().height() + 9)
        rows.setMinimumWidth(30)
        rows.setDefaultAlignment(Qt.AlignmentFlag.AlignCenter)
        self.horizontalHeader().setHighlightSections(False)
        self.selectionModel().currentRowChanged.connect(self._row_changed)

    def choose(self, number: int) -> None:
        """Choose a row, as a click does; -1 chooses none."""
        if number < 0:
            self.clearSelection()
            self.selectionModel().clearCurrentIndex()
            return
        index = self.model().index(number, 0)
        flags = QItemSelectionModel.SelectionFlag
        self.selectionModel().setCurrentIndex(index, flags.ClearAndSelect | flags.Rows)
        self.scrollTo(index)

    def mark(self, number: int) -> None:
        """Choose a row without telling anybody; rows that the sailor is selecting to copy are left alone."""
        if number == self.currentIndex().row() or len(self.selectionModel().selectedRows()) > 1:
            return
        self._marking = True
        try:
            self.choose(number)
        finally:
            self._marking = False

    def _row_changed(self, current: QModelIndex) -> None:
        if not self._marking:
            self.row_chosen.emit(current.row())

    def text_of_rows(self) -> str:
        """Text of the selected rows, or of all when none is selected, below the heads of the columns."""
        model = self.model()
        shown = [column for column in range(model.columnCount()) if not self.isColumnHidden(column)]
        rows = sorted(index.row() for index in self.selectionModel().selectedRows())
        heads = [str(model.headerData(column, Qt.Orientation.Horizontal)) for column in shown]
        cells = [[str(model.index(row, column).data()) for column in shown] for row in rows]
        if not rows:
            cells = [
                [str(model.index(row, column).data()) for column in shown] for row in range(model.rowCount())
            ]
        return "\n".join("\t".join(line) for line in (heads, *cells))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Copy rows, not the one cell that Qt would copy."""
        if event.matches(QKeySequence.StandardKey.Copy):
            QGuiApplication.clipboard().setText(self.text_of_rows())
            event.accept()
            return
        super().keyPressEvent(event)
