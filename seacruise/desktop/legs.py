"""The legs of a passage as a table: the twin of the chart in words and figures."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import (
    QAbstractTableModel,
    QCoreApplication,
    QItemSelectionModel,
    QModelIndex,
    QPersistentModelIndex,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView, QWidget

from seacruise.desktop.chart.palette import WIND_COLOURS, wind_class
from seacruise.export.textform import format_course, to_minute
from seacruise.geodesy import format_position

if TYPE_CHECKING:
    from seacruise.passage import Passage, Waypoint

Index = QModelIndex | QPersistentModelIndex

# Flags are joined once: a table of a screen asks some hundred times.
_LEFT: Final = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
_RIGHT: Final = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


def tr(text: str) -> str:
    """Translate a text of this module."""
    return QCoreApplication.translate("legs", text)


@dataclass(frozen=True, slots=True)
class Column:
    """A column: its head, what it is, and its text for a waypoint."""

    head: str
    tip: str
    text: Callable[[Waypoint], str]


def _number(value: float | None, decimals: int = 1) -> str:
    return "" if value is None else f"{value:.{decimals}f}"


def _angle(value: float | None) -> str:
    return "" if value is None else f"{value:.0f}°"


def _course(value: float | None) -> str:
    return "" if value is None else format_course(value)


def _how(waypoint: Waypoint) -> str:
    if waypoint.course_deg is None:
        return tr("arrival")
    if waypoint.motor:
        return tr("engine")
    return {"port": tr("port"), "starboard": tr("starboard"), "both": tr("both"), None: ""}[waypoint.tack]


def columns() -> tuple[Column, ...]:
    """Make the table's columns, from left to right."""
    return (
        Column(tr("Time (UTC)"), tr("When the leg begins"), lambda w: f"{to_minute(w.time):%d %b %H:%M}"),
        Column(tr("Position"), tr("Where the leg begins"), lambda w: format_position(w.lat, w.lon)),
        Column(tr("COG"), tr("Course over ground, degrees true"), lambda w: _course(w.course_deg)),
        Column(tr("Leg nm"), tr("Length of the leg, nautical miles"), lambda w: _number(w.leg_nm)),
        Column(tr("Boat kn"), tr("Speed through the water, knots"), lambda w: _number(w.boat_speed_kn)),
        Column(tr("TWS kn"), tr("True wind speed where the leg begins, knots"), lambda w: _number(w.tws_kn)),
        Column(tr("TWD"), tr("Direction the true wind comes from"), lambda w: _course(w.twd_deg)),
        Column(tr("TWA"), tr("True wind angle, 0° ahead to 180° astern"), lambda w: _angle(w.twa_deg)),
        Column(tr("Tack"), tr("Side the wind comes from, or engine"), _how),
    )


class LegsModel(QAbstractTableModel):
    """One row a leg, and the arrival."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._columns = columns()
        self._waypoints: tuple[Waypoint, ...] = ()
        self._darker = 100

    def show_light(self, light: str) -> None:
        """Be as bright as a light allows: ``day``, ``dusk`` or ``night``."""
        self._darker = 200 if light == "night" else 100

    def show_passage(self, passage: Passage | None) -> None:
        """Take over the waypoints of a passage, or none."""
        self.beginResetModel()
        self._waypoints = passage.waypoints if passage is not None else ()
        self.endResetModel()

    def rowCount(self, parent: Index | None = None) -> int:
        """Waypoints."""
        return 0 if parent is not None and parent.isValid() else len(self._waypoints)

    def columnCount(self, parent: Index | None = None) -> int:
        """Columns."""
        return 0 if parent is not None and parent.isValid() else len(self._columns)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Text, alignment and the wind's colour of a cell."""
        waypoint, column = self._waypoints[index.row()], self._columns[index.column()]
        if role == Qt.ItemDataRole.DisplayRole:
            return column.text(waypoint)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return self._side(index.column())
        if role == Qt.ItemDataRole.DecorationRole and index.column() == 5 and waypoint.tws_kn is not None:
            return WIND_COLOURS[wind_class(waypoint.tws_kn)].darker(self._darker)
        return None

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """Heads of the columns, numbers of the legs."""
        if orientation == Qt.Orientation.Vertical:
            return str(section + 1) if role == Qt.ItemDataRole.DisplayRole else None
        if role == Qt.ItemDataRole.DisplayRole:
            return self._columns[section].head
        if role == Qt.ItemDataRole.ToolTipRole:
            return self._columns[section].tip
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return self._side(section)
        return None

    def _side(self, column: int) -> Qt.AlignmentFlag:
        return _LEFT if column in {0, 1, len(self._columns) - 1} else _RIGHT


class LegsTable(QTableView):
    """The table; ``leg_chosen(number)`` when another row is chosen."""

    leg_chosen = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.legs = LegsModel(self)
        self.setModel(self.legs)
        self.setAccessibleName(self.tr("Legs of the passage"))
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setAlternatingRowColors(True)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.setTabKeyNavigation(False)
        self.setIconSize(QSize(11, 11))
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 9)
        self.verticalHeader().setMinimumWidth(30)
        self.verticalHeader().setDefaultAlignment(Qt.AlignmentFlag.AlignCenter)
        head = self.horizontalHeader()
        head.setHighlightSections(False)
        head.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        metrics = self.fontMetrics()
        for column, sample in ((0, "00 Nov 00:00"), (1, "00°00.0'N 000°00.0'E"), (8, "starboard")):
            head.setSectionResizeMode(column, QHeaderView.ResizeMode.Fixed)
            self.setColumnWidth(column, metrics.horizontalAdvance(sample) + 26)
        self.selectionModel().currentRowChanged.connect(self._row_changed)

    def show_passage(self, passage: Passage | None) -> None:
        """Show the legs of a passage, or none."""
        self.legs.show_passage(passage)

    def choose_leg(self, number: int) -> None:
        """Choose the row of a leg; -1 chooses none."""
        if number < 0:
            self.clearSelection()
            self.selectionModel().clearCurrentIndex()
            return
        index = self.legs.index(number, 0)
        flags = QItemSelectionModel.SelectionFlag
        self.selectionModel().setCurrentIndex(index, flags.ClearAndSelect | flags.Rows)
        self.scrollTo(index)

    def _row_changed(self, current: QModelIndex) -> None:
        self.leg_chosen.emit(current.row())
