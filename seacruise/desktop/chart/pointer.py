"""What the mouse does on the chart: pan, take an end of the passage along, measure, pick a leg."""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent

from seacruise.ports import Port

if TYPE_CHECKING:
    from seacruise.desktop.chart.view import ChartView

_CLICK_PX: Final = 4


class Doing(Enum):
    """What a pressed button is for."""

    NOTHING = "nothing"
    CLICK = "click"
    PAN = "pan"
    END = "end"
    MEASURE = "measure"


class Pointer:
    """The mouse over a view; the view passes its events on."""

    def __init__(self, view: ChartView) -> None:
        self._view = view
        self._doing = Doing.NOTHING
        self._pressed = QPoint()
        self._end = ""
        self._rubber = False

    def press(self, event: QMouseEvent) -> None:
        """Begin whatever is under the pointer."""
        view, at = self._view, event.position()
        self._pressed = at.toPoint()
        end = view.ports.end_at(at, view.viewportTransform())
        if view.is_measuring:
            self._doing = Doing.MEASURE
            self.set_or_end_line(*view.position_at(at))
        elif end is not None:
            self._doing, self._end = Doing.END, end
        else:
            self._doing = Doing.CLICK
        self.show_cursor(at)

    def move(self, event: QMouseEvent) -> None:
        """Go on with it."""
        view, at = self._view, event.position()
        moved = self._pressed - at.toPoint()
        if self._doing is Doing.CLICK and moved.manhattanLength() > _CLICK_PX:
            self._doing = Doing.PAN
        if self._doing is Doing.PAN:
            view.pan(moved.x(), moved.y())
            self._pressed = at.toPoint()
        elif self._doing is Doing.END:
            self._take_along(at, done=False)
        elif view.is_measuring and self._rubber:
            view.measure.reach(*view.position_at(at))
        self.show_cursor(at)

    def release(self, event: QMouseEvent) -> None:
        """End it; a click picks a leg."""
        view, at = self._view, event.position()
        if self._doing is Doing.CLICK:
            leg = view.route.leg_at(at, view.viewportTransform())
            view.leg_picked.emit(-1 if leg is None else leg)
            if leg is None and (way := view.others.way_at(at, view.viewportTransform())) is not None:
                view.way_picked.emit(way)
        elif self._doing is Doing.END and (at.toPoint() - self._pressed).manhattanLength() > _CLICK_PX:
            self._take_along(at, done=True)
        elif self._doing is Doing.MEASURE and (at.toPoint() - self._pressed).manhattanLength() > _CLICK_PX:
            self._rubber = False
        self._doing = Doing.NOTHING
        self.show_cursor(at)

    def set_or_end_line(self, lat: float, lon: float) -> None:
        """Set the beginning of the measuring line, or its end when it follows the pointer."""
        if self._rubber:
            self._view.measure.reach(lat, lon)
        else:
            self._view.measure.begin(lat, lon)
        self._rubber = not self._rubber

    def follow(self, lat: float, lon: float) -> None:
        """Let the line's end follow something other than the mouse."""
        if self._rubber:
            self._view.measure.reach(lat, lon)

    def drop_line(self) -> None:
        """Take the measuring line away."""
        self._rubber = False
        self._view.measure.clear()

    def _take_along(self, at: QPointF, *, done: bool) -> None:
        view = self._view
        port = view.ports.port_at(at, view.viewportTransform())
        if port is None:
            lat, lon = view.position_at(at)
            port = Port("", "", lat, lon)
        view.end_dragged.emit(self._end, port, done)

    def show_cursor(self, at: QPointF) -> None:
        """Show what a press would do here, or what is being done."""
        view = self._view
        shape = Qt.CursorShape.CrossCursor
        if self._doing is Doing.PAN:
            shape = Qt.CursorShape.ClosedHandCursor
        elif self._doing is Doing.END:
            shape = Qt.CursorShape.DragMoveCursor
        elif not view.is_measuring and view.ports.end_at(at, view.viewportTransform()) is not None:
            shape = Qt.CursorShape.OpenHandCursor
        elif not view.is_measuring and view.others.way_at(at, view.viewportTransform()) is not None:
            shape = Qt.CursorShape.PointingHandCursor
        if view.viewport().cursor().shape() != shape:
            view.viewport().setCursor(shape)
