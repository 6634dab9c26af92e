"""The chart view: layers one above the other, moved by mouse, wheel and keys."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QEvent, QPoint, QPointF, QRectF, Qt, QTimer, Signal
from PySide6.QtGui import (
    QColor,
    QContextMenuEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QFrame, QGraphicsScene, QGraphicsView, QMenu, QWidget

from seacruise.desktop.chart.coast_layer import CoastLayer
from seacruise.desktop.chart.graticule import GraticuleLayer, ScaleLayer
from seacruise.desktop.chart.legend import LegendLayer
from seacruise.desktop.chart.plane import CHARTED, point, position, rectangle
from seacruise.desktop.chart.ports_layer import PortsLayer
from seacruise.desktop.chart.route_layer import RouteLayer, TroubleLayer
from seacruise.desktop.chart.wind_layer import WindLayer
from seacruise.desktop.jobs import JobRunner
from seacruise.desktop.style import FOCUS
from seacruise.geodesy import format_position
from seacruise.ports import Port

if TYPE_CHECKING:
    from seacruise.desktop.compute import Answer

_STEP: Final = 1.25
_NEAREST_PX_M: Final = 0.4
_SETTLE_MS: Final = 60
_CLICK_PX: Final = 4
_FIT_SIDES_PX: Final = 40
_FIT_TOP_PX: Final = 58
_FIT_BOTTOM_PX: Final = 104
"""Room for ribbon and legend around what is fitted."""

_LEAST_FITTED_M: Final = 40_000.0


class ChartView(QGraphicsView):
    """Chart of the Baltic.

    Signals: ``pointed(lat, lon)`` as the pointer moves, ``left()`` when it leaves, ``leg_picked(number)``
    on a click on the route (-1 beside it), ``end_picked(which, lat, lon)`` with ``"from"`` or ``"to"``.
    """

    pointed = Signal(float, float)
    left = Signal()
    leg_picked = Signal(int)
    end_picked = Signal(str, float, float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setScene(QGraphicsScene(self))
        self._room = CHARTED.adjusted(*(f * CHARTED.width() for f in (-0.6, -0.6, 0.6, 0.6)))
        self.setSceneRect(self._room)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setViewportUpdateMode(QGraphicsView.ViewportUpdateMode.FullViewportUpdate)
        self.setTransformationAnchor(QGraphicsView.ViewportAnchor.NoAnchor)
        self.setResizeAnchor(QGraphicsView.ViewportAnchor.AnchorViewCenter)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.viewport().setCursor(Qt.CursorShape.CrossCursor)
        self.setAccessibleName(self.tr("Chart"))
        self.setAccessibleDescription(
            self.tr(
                "Plus and minus zoom, the arrow keys move the chart; the legs table says the same in words."
            )
        )
        self.painter_jobs = JobRunner("chart", self)
        self._make_layers()
        self._pressed: QPoint | None = None
        self._dragged = False
        self._fitted: QRectF | None = None
        self._shows_all = True
        self._settle = QTimer(self)
        self._settle.setSingleShot(True)
        self._settle.setInterval(_SETTLE_MS)
        self._settle.timeout.connect(self._demand_coast)

    def _make_layers(self) -> None:
        room = self._room
        self.coast = CoastLayer(room, self.painter_jobs, self.viewport().update)
        self.wind = WindLayer(room)
        self.ports = PortsLayer(room)
        self.route = RouteLayer(room)
        self.trouble = TroubleLayer(room)
        self.legend = LegendLayer(room)
        self.legend.setVisible(False)
        order = (self.coast, GraticuleLayer(room), self.wind, self.route, self.ports, ScaleLayer(room))
        for height, layer in enumerate((*order, self.legend, self.trouble)):
            layer.setZValue(height)
            self.scene().addItem(layer)

    # --- what is shown ------------------------------------------------------------------------------

    def show_answer(self, answer: Answer | None) -> None:
        """Show a passage and its wind at departure, or neither."""
        passage = answer.passage if answer else None
        self.route.show_passage(passage)
        self.legend.setVisible(passage is not None)
        if answer is None or passage is None:
            self.wind.show_wind(None, 0.0)
            return
        self.show_time(answer, passage.departure.timestamp())

    def show_time(self, answer: Answer, time: float) -> None:
        """Show wind and boat at a time [s since 1970-01-01T00:00Z]."""
        self.wind.show_wind(answer.wind, time)
        self.route.place_boat(time)

    def choose_ends(self, ends: Sequence[Port]) -> None:
        """Mark the ports that the form names."""
        self.ports.choose([(point(port.lat, port.lon), port.name) for port in ends])

    def fit_passage(self, answer: Answer) -> None:
        """Bring a whole passage into view."""
        track = answer.passage.track
        self.fit(
            rectangle(
                float(track.lat.min()), float(track.lon.min()), float(track.lat.max()), float(track.lon.max())
            )
        )

    def fit(self, area: QRectF) -> None:
        """Bring a rectangle of the plane into view, clear of ribbon and legend."""
        self._fitted, self._shows_all = QRectF(area), False
        view = self.viewport().rect().adjusted(_FIT_SIDES_PX, _FIT_TOP_PX, -_FIT_SIDES_PX, -_FIT_BOTTOM_PX)
        width, height = (max(side, _LEAST_FITTED_M) for side in (area.width(), area.height()))
        self._set_scale(min(max(view.width(), 50) / width, max(view.height(), 50) / height))
        shift = (_FIT_BOTTOM_PX - _FIT_TOP_PX) / 2.0 / self.transform().m11()
        self.centerOn(area.center() + QPointF(0.0, shift))
        self._moved(keep_fit=True)

    def show_all(self) -> None:
        """Fill the view with what is charted, the southern Baltic first."""
        self._fitted, self._shows_all = None, True
        view = self.viewport().rect()
        self._set_scale(max(view.width() / CHARTED.width(), view.height() / CHARTED.height()))
        seen = view.height() / self.transform().m11()
        self.centerOn(CHARTED.center().x(), CHARTED.bottom() - seen / 2.0)
        self._moved(keep_fit=True)

    def show_place(self, lat: float, lon: float) -> None:
        """Bring a position to the middle."""
        self.centerOn(point(lat, lon))
        self._moved()

    @property
    def is_settled(self) -> bool:
        """Whether the picture is complete: nothing is being painted or about to be."""
        return not self._settle.isActive() and self.coast.is_up_to_date

    # --- moving -------------------------------------------------------------------------------------

    def _limits(self) -> tuple[float, float]:
        view = self.viewport().rect()
        widest = max(view.width() / self._room.width(), view.height() / self._room.height())
        return widest * 1.15, _NEAREST_PX_M

    def _set_scale(self, wanted: float) -> None:
        low, high = self._limits()
        factor = min(max(wanted, low), high) / self.transform().m11()
        self.scale(factor, factor)

    def zoom(self, factor: float, at: QPointF | None = None) -> None:
        """Zoom so that what is under a point of the viewport stays there."""
        at = at if at is not None else QPointF(self.viewport().rect().center())
        back, _ = self.viewportTransform().inverted()
        before = back.map(at)
        self._set_scale(self.transform().m11() * factor)
        shift = self.viewportTransform().map(before) - at
        self._pan(shift.x(), shift.y())

    def zoom_in(self) -> None:
        """One step closer."""
        self.zoom(_STEP**2)

    def zoom_out(self) -> None:
        """One step away."""
        self.zoom(_STEP**-2)

    def _pan(self, dx: float, dy: float) -> None:
        for bar, shift in ((self.horizontalScrollBar(), dx), (self.verticalScrollBar(), dy)):
            bar.setValue(bar.value() + round(shift))
        self._moved()

    def _moved(self, *, keep_fit: bool = False) -> None:
        if not keep_fit:
            self._fitted, self._shows_all = None, False
        self.viewport().update()
        self.refresh_coast()

    def refresh_coast(self) -> None:
        """See to it, soon, that coast and lattice fit the view."""
        if not self._settle.isActive():
            self._settle.start()

    def _demand_coast(self) -> None:
        view = self.viewport().rect()
        if view.isEmpty() or not self.isVisible():
            return
        back, _ = self.viewportTransform().inverted()
        self.coast.demand(
            back.mapRect(QRectF(view)),
            self.transform().m11(),
            (view.width(), view.height()),
            self.devicePixelRatioF(),
        )

    # --- Qt's events --------------------------------------------------------------------------------

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep what was fitted in view, and the coast fitting."""
        super().resizeEvent(event)
        if self._fitted is not None:
            self.fit(self._fitted)
        elif self._shows_all:
            self.show_all()
        else:
            self._moved()

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom at the pointer."""
        self.zoom(_STEP ** (event.angleDelta().y() / 120.0), event.position())
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Plus, minus, arrows, Home."""
        step = 60.0
        moves = {
            Qt.Key.Key_Left: (-step, 0.0),
            Qt.Key.Key_Right: (step, 0.0),
            Qt.Key.Key_Up: (0.0, -step),
            Qt.Key.Key_Down: (0.0, step),
        }
        key = Qt.Key(event.key())
        if key in moves:
            self._pan(*moves[key])
        elif key in {Qt.Key.Key_Plus, Qt.Key.Key_Equal}:
            self.zoom_in()
        elif key in {Qt.Key.Key_Minus, Qt.Key.Key_Underscore}:
            self.zoom_out()
        else:
            # Not QGraphicsView's: it would scroll by keys that the window knows.
            QWidget.keyPressEvent(self, event)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Begin to drag, or a click."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._pressed, self._dragged = event.position().toPoint(), False
            event.accept()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag the chart; tell the position under the pointer."""
        at = event.position().toPoint()
        if self._pressed is not None:
            moved = self._pressed - at
            if self._dragged or moved.manhattanLength() > _CLICK_PX:
                self._dragged = True
                self.viewport().setCursor(Qt.CursorShape.ClosedHandCursor)
                self._pan(moved.x(), moved.y())
                self._pressed = at
        self.pointed.emit(*self._position_at(QPointF(at)))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """End a drag; a click picks a leg."""
        if self._pressed is not None and not self._dragged:
            leg = self.route.leg_at(event.position(), self.viewportTransform())
            self.leg_picked.emit(-1 if leg is None else leg)
        self._pressed = None
        self.viewport().setCursor(Qt.CursorShape.CrossCursor)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Zoom in at the pointer."""
        self.zoom(_STEP**2, event.position())

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Offer the position as an end of the passage."""
        lat, lon = self._position_at(QPointF(event.pos()))
        menu = QMenu(self)
        menu.addSection(format_position(lat, lon))
        menu.addAction(self.tr("Sail from here")).triggered.connect(
            lambda: self.end_picked.emit("from", lat, lon)
        )
        menu.addAction(self.tr("Sail to here")).triggered.connect(
            lambda: self.end_picked.emit("to", lat, lon)
        )
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.popup(event.globalPos())

    def viewportEvent(self, event: QEvent) -> bool:
        """Tell when the pointer has left."""
        if event.type() == QEvent.Type.Leave:
            self.left.emit()
        return bool(super().viewportEvent(event))

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the layers, and a frame when the keys go to the chart."""
        super().paintEvent(event)
        if self.hasFocus() and self.window().isActiveWindow():
            painter = QPainter(self.viewport())
            painter.setPen(QPen(QColor(FOCUS), 2.0))
            painter.drawRect(self.viewport().rect().adjusted(1, 1, -1, -1))
            painter.end()

    def _position_at(self, at: QPointF) -> tuple[float, float]:
        back, _ = self.viewportTransform().inverted()
        return position(back.map(at))
