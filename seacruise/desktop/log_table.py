"""The log of the passage as a table: when, what, where."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from datetime import datetime
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QAbstractTableModel, QCoreApplication, QModelIndex, QPersistentModelIndex, Qt
from PySide6.QtWidgets import QHeaderView, QWidget

from seacruise.desktop.linked_table import LinkedTable
from seacruise.desktop.log_words import entry_text, entry_time
from seacruise.desktop.units_choice import units_choice, zone_text
from seacruise.geodesy import format_position

if TYPE_CHECKING:
    from seacruise.narrative import Entry

Index = QModelIndex | QPersistentModelIndex

_LEFT: Final = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter


def _tr(text: str) -> str:
    return QCoreApplication.translate("log", text)


class LogModel(QAbstractTableModel):
    """One row an entry."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._entries: tuple[Entry, ...] = ()
        self._rows: list[tuple[str, str, str]] = []
        units_choice().changed.connect(self._write)

    def show_entries(self, entries: Sequence[Entry]) -> None:
        """Take a log over."""
        self._entries = tuple(entries)
        self._write()

    def _write(self) -> None:
        self.beginResetModel()
        self._rows = [(entry_time(e), entry_text(e), format_position(e.lat, e.lon)) for e in self._entries]
        self.endResetModel()

    @property
    def entries(self) -> tuple[Entry, ...]:
        """The entries, in the order of time."""
        return self._entries

    def row_at(self, moment: datetime) -> int:
        """Row of the last entry that is not after a moment; the first one before all."""
        return max(0, bisect_right(self._entries, moment, key=lambda entry: entry.time) - 1)

    def rowCount(self, parent: Index | None = None) -> int:
        """Entries."""
        return 0 if parent is not None and parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index | None = None) -> int:
        """Time, sentence, position."""
        return 0 if parent is not None and parent.isValid() else 3

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Text of a cell; the sentence also as its tip, for where the window is narrow."""
        if role == Qt.ItemDataRole.DisplayRole or (
            role == Qt.ItemDataRole.ToolTipRole and index.column() == 1
        ):
            return self._rows[index.row()][index.column()]
        return _LEFT if role == Qt.ItemDataRole.TextAlignmentRole else None

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """Heads of the columns, numbers of the entries."""
        if role == Qt.ItemDataRole.TextAlignmentRole and orientation == Qt.Orientation.Horizontal:
            return _LEFT
        if role != Qt.ItemDataRole.DisplayRole:
            return None
        if orientation == Qt.Orientation.Vertical:
            return str(section + 1)
        zone = zone_text(self._entries[0].time) if self._entries else _tr("UTC")
        return (_tr("Time ({zone})").format(zone=zone), _tr("What happens"), _tr("Position"))[section]


class LogTable(LinkedTable):
    """The table; ``row_chosen(number)`` when the sailor chooses another entry."""

    def __init__(self, parent: QWidget | None = None) -> None:
        model = LogModel()
        super().__init__(model, parent)
        self.log = model
        self.setAccessibleName(self.tr("Log of the passage"))
        head = self.horizontalHeader()
        head.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        head.setSectionResizeMode(1, QHeaderView.ResizeMode.Stretch)
        for column, sample in ((0, "Wed 00:00  UTC+5:30"), (2, "00°00.0'N 000°00.0'E")):
            self.setColumnWidth(column, self.fontMetrics().horizontalAdvance(sample) + 28)
        self.verticalHeader().hide()
