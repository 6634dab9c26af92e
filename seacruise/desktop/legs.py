"""The legs of a passage as a table: the twin of the chart in words and figures."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import (
    QAbstractTableModel,
    QCoreApplication,
    QModelIndex,
    QPersistentModelIndex,
    Qt,
)
from PySide6.QtGui import QColor, QResizeEvent
from PySide6.QtWidgets import QHeaderView, QStyledItemDelegate, QStyleOptionViewItem, QWidget

from seacruise.desktop.chart.palette import WIND_COLOURS, wind_class
from seacruise.desktop.language import fill
from seacruise.desktop.linked_table import LinkedTable
from seacruise.desktop.style import PORT_TACK, STARBOARD_TACK, tinted
from seacruise.desktop.units_choice import (
    distance_number,
    distance_unit,
    short_moment,
    units_choice,
    wind_number,
    wind_unit,
    zone_text,
)
from seacruise.export.textform import format_course, to_minute
from seacruise.geodesy import format_position
from seacruise.phrases import POINT_LIMITS_DEG

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
    """A column: its key, its head, what it is, and its text for a waypoint."""

    key: str
    head: str
    tip: str
    text: Callable[[Waypoint], str]


def _number(value: float | None) -> str:
    return "" if value is None else fill("{n:.1f}", n=value)


def _angle(value: float | None) -> str:
    return "" if value is None else f"{value:.0f}°"


def _course(value: float | None) -> str:
    return "" if value is None else format_course(value)


def _distance(value: float | None) -> str:
    return "" if value is None else distance_number(value)


def _wind(value: float | None) -> str:
    return "" if value is None else wind_number(value, 1)


def _how(waypoint: Waypoint) -> str:
    if waypoint.course_deg is None:
        return tr("arrival")
    if waypoint.motor:
        return tr("engine")
    return {"port": tr("port"), "starboard": tr("starboard"), "both": tr("both"), None: ""}[waypoint.tack]


def point_of_sail(twa_deg: float) -> str:
    """Name the point of sail at an angle to the true wind [degrees, 0 to 180]."""
    names = (tr("close-hauled"), tr("close reach"), tr("beam reach"), tr("broad reach"), tr("run"))
    return names[bisect_right(POINT_LIMITS_DEG, twa_deg)]


def _point(waypoint: Waypoint) -> str:
    return "" if waypoint.twa_deg is None or waypoint.motor else point_of_sail(waypoint.twa_deg)


def columns(moment: datetime | None = None) -> tuple[Column, ...]:
    """Make the table's columns, from left to right; times are in the zone of a moment."""
    zone = zone_text(moment or datetime.now(UTC))
    wind, distance = wind_unit(), distance_unit()
    return (
        Column(
            "time",
            tr("Time ({zone})").format(zone=zone),
            tr("When the leg begins"),
            lambda w: short_moment(to_minute(w.time)),
        ),
        Column(
            "position", tr("Position"), tr("Where the leg begins"), lambda w: format_position(w.lat, w.lon)
        ),
        Column("cog", tr("COG"), tr("Course over ground, degrees true"), lambda w: _course(w.course_deg)),
        Column(
            "leg",
            tr("Leg {unit}").format(unit=distance),
            tr("Length of the leg"),
            lambda w: _distance(w.leg_nm),
        ),
        Column(
            "speed", tr("Boat kn"), tr("Speed through the water, knots"), lambda w: _number(w.boat_speed_kn)
        ),
        Column(
            "tws",
            tr("TWS {unit}").format(unit=wind),
            tr("True wind speed where the leg begins"),
            lambda w: _wind(w.tws_kn),
        ),
        Column("twd", tr("TWD"), tr("Direction the true wind comes from"), lambda w: _course(w.twd_deg)),
        Column("twa", tr("TWA"), tr("True wind angle, 0° ahead to 180° astern"), lambda w: _angle(w.twa_deg)),
        Column("sail", tr("Sail"), tr("Best sail where the leg begins"), lambda w: w.sail or "–"),
        Column("point", tr("Point of sail"), tr("Angle to the wind in a sailor's word"), _point),
        Column("tack", tr("Tack"), tr("Side the wind comes from, or engine"), _how),
    )


_PAD_PX: Final = 16
_ICON_PX: Final = 17

_AFTER_FIGURES: Final = frozenset({"sail", "point"})
_WITH_ICON: Final = frozenset({"tws", "tack"}) | _AFTER_FIGURES

_TEXTS: Final = frozenset({"time", "position", "sail", "point", "tack"})
"""Columns that are read from the left; the others are figures."""


class LegsModel(QAbstractTableModel):
    """One row a leg, and the arrival."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._columns = columns()
        self._keys = [column.key for column in self._columns]
        self._waypoints: tuple[Waypoint, ...] = ()
        self._light = "day"
        units_choice().changed.connect(self._show_units)

    def show_light(self, light: str) -> None:
        """Be as bright as a light allows: ``day``, ``dusk`` or ``night``."""
        self._light = light

    def show_passage(self, passage: Passage | None) -> None:
        """Take over the waypoints of a passage, or none."""
        self.beginResetModel()
        self._waypoints = passage.waypoints if passage is not None else ()
        self._columns = columns(self._waypoints[0].time if self._waypoints else None)
        self.endResetModel()

    def _show_units(self) -> None:
        self.beginResetModel()
        self._columns = columns(self._waypoints[0].time if self._waypoints else None)
        self.endResetModel()

    @property
    def has_sails(self) -> bool:
        """Whether the yacht's polar knows sails."""
        return any(waypoint.sail for waypoint in self._waypoints)

    def key(self, column: int) -> str:
        """Give the key of a column by its number."""
        return self._keys[column]

    def samples(self, key: str) -> tuple[str, ...]:
        """Give the longest texts that a column may have, sails' names as they are."""
        fixed = {
            "time": ("00 Nov 00:00",),
            "position": ("00°00.0'N 000°00.0'E",),
            "cog": ("000°",),
            "leg": ("0000.0",),
            "speed": ("00.0",),
            "tws": ("00.0",),
            "twd": ("000°",),
            "twa": ("000°",),
            "sail": tuple({waypoint.sail or "" for waypoint in self._waypoints}),
            "point": tuple(point_of_sail(angle) for angle in (0.0, 60.0, 90.0, 120.0, 180.0)),
            "tack": (tr("port"), tr("starboard"), tr("engine"), tr("arrival")),
        }
        return fixed[key] or ("",)

    def column(self, key: str) -> int:
        """Give the number of a column by its key, such as ``"tws"``."""
        return self._keys.index(key)

    def rowCount(self, parent: Index | None = None) -> int:
        """Waypoints."""
        return 0 if parent is not None and parent.isValid() else len(self._waypoints)

    def columnCount(self, parent: Index | None = None) -> int:
        """Columns."""
        return 0 if parent is not None and parent.isValid() else len(self._columns)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Text, alignment and the colour of the wind or the tack of a cell."""
        waypoint, column = self._waypoints[index.row()], self._columns[index.column()]
        if role == Qt.ItemDataRole.DisplayRole:
            return column.text(waypoint)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return self._side(column.key)
        if role == Qt.ItemDataRole.DecorationRole:
            return self._colour(column.key, waypoint)
        return None

    def _colour(self, key: str, waypoint: Waypoint) -> QColor | None:
        if key == "tws" and waypoint.tws_kn is not None:
            return WIND_COLOURS[wind_class(waypoint.tws_kn)].darker(200 if self._light == "night" else 100)
        if key in _AFTER_FIGURES:
            # Invisible: room between figures at the right of their column and words at the left of theirs.
            return QColor(Qt.GlobalColor.transparent)
        if key == "tack" and waypoint.tack in {"port", "starboard"}:
            return QColor(tinted(PORT_TACK if waypoint.tack == "port" else STARBOARD_TACK, self._light))
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
            return self._side(self._columns[section].key)
        return None

    def _side(self, key: str) -> Qt.AlignmentFlag:
        return _LEFT if key in _TEXTS else _RIGHT


class _ColourAfter(QStyledItemDelegate):
    """Puts a colour behind its figure; before it, it would seem to belong to the column before."""

    def initStyleOption(self, option: QStyleOptionViewItem, index: Index) -> None:
        """Turn the sides."""
        super().initStyleOption(option, index)
        option.decorationPosition = QStyleOptionViewItem.Position.Right


class LegsTable(LinkedTable):
    """The table; ``row_chosen(number)`` when the sailor chooses another leg."""

    def __init__(self, parent: QWidget | None = None) -> None:
        model = LegsModel()
        super().__init__(model, parent)
        self.legs = model
        self.setAccessibleName(self.tr("Legs of the passage"))
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        self._colour_after = _ColourAfter(self)
        self.setItemDelegateForColumn(model.column("tws"), self._colour_after)
        self.legs.modelReset.connect(self._fit_columns)
        self._fit_columns()

    def show_passage(self, passage: Passage | None) -> None:
        """Show the legs of a passage, or none."""
        self.legs.show_passage(passage)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Share the room that is left among the columns."""
        super().resizeEvent(event)
        self._fit_columns()

    def _fit_columns(self) -> None:
        """Give each column what its head and its longest text need, in whatever language and font."""
        model, metrics = self.legs, self.fontMetrics()
        widths = {}
        for column in range(model.columnCount()):
            key = model.key(column)
            head = str(model.headerData(column, Qt.Orientation.Horizontal))
            longest = max(metrics.horizontalAdvance(text) for text in (head, *model.samples(key)))
            widths[column] = longest + _PAD_PX + (_ICON_PX if key in _WITH_ICON else 0)
        sail = model.column("sail")
        self.setColumnHidden(sail, not model.has_sails)
        if not model.has_sails:
            del widths[sail]
        spare = max(0, self.viewport().width() - sum(widths.values())) // len(widths)
        for column, width in widths.items():
            self.setColumnWidth(column, width + spare)

    def choose_leg(self, number: int) -> None:
        """Choose the row of a leg; -1 chooses none."""
        self.choose(number)
