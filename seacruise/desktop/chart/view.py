"""The chart view: layers one above the other, moved by mouse, wheel and keys."""

from __future__ import annotations

import time
from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, QTimer, Signal
from PySide6.QtGui import (
    QContextMenuEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QFrame, QGraphicsScene, QGraphicsView, QWidget

from seacruise.desktop.chart.coarse_layer import CoarseLayer
from seacruise.desktop.chart.coast_layer import CoastLayer
from seacruise.desktop.chart.context import open_menu
from seacruise.desktop.chart.easel import Easel, Stack
from seacruise.desktop.chart.field_layer import FieldLayer
from seacruise.desktop.chart.graticule import DegreesLayer, GraticuleLayer, ScaleLayer
from seacruise.desktop.chart.isochrone_layer import IsochroneLayer
from seacruise.desktop.chart.layer import LabelLayer
from seacruise.desktop.chart.legend import LegendLayer
from seacruise.desktop.chart.measure_layer import MeasureLayer
from seacruise.desktop.chart.members_layer import MemberBoatsLayer, MembersLayer
from seacruise.desktop.chart.others_layer import OthersLayer
from seacruise.desktop.chart.palette import DAY, Palette
from seacruise.desktop.chart.plane import CHARTED, WORLD, point, position, rectangle
from seacruise.desktop.chart.pointer import Pointer
from seacruise.desktop.chart.ports_layer import EndsLayer, PortsLayer
from seacruise.desktop.chart.route_layer import BoatLayer, RouteLayer, TroubleLayer
from seacruise.desktop.chart.schemes import Scheme
from seacruise.desktop.chart.wind_layer import WindLayer
from seacruise.desktop.chart.zones_layer import ZonesLayer
from seacruise.desktop.jobs import JobRunner
from seacruise.ports import Port
from seacruise.sea.zones import Zone

if TYPE_CHECKING:
    from seacruise.desktop.compute import Answer

_STEP: Final = 1.25
_NEAREST_PX_M: Final = 0.4
_SETTLE_MS: Final = 60
_PATIENCE_S: Final = 1.2
_BARE_S: Final = 0.1
"""A coast that is painted while the chart moves takes time from its frames; so long it is stretched, and so
long a part of the view may be without."""

_FIT_SIDES_PX: Final = 40
_FIT_TOP_PX: Final = 58
_FIT_BOTTOM_PX: Final = 104
_FIT_ABOVE_PX: Final = 18
"""Room for ribbon and legend around what is fitted."""

_LEAST_FITTED_M: Final = 40_000.0


class ChartView(QGraphicsView):
    """Chart of the Baltic; of other seas coarsely.

    Signals: ``pointed(lat, lon)`` as the pointer moves, ``left()`` when it leaves, ``leg_picked(number)``
    on a click on the route (-1 beside it), ``end_picked(which, lat, lon)`` with ``"from"``, ``"to"`` or
    ``"via"`` from its menu, ``end_dragged(which, port, done)`` while one is dragged - a port without a name
    is a position -, ``via_dropped()``, ``avoid_picked(lat, lon, radius_nm)``, ``avoid_dropped(zone)``, and
    ``measuring_changed(bool)``; ``way_picked(way)`` on a click on another way.
    """

    pointed = Signal(float, float)
    left = Signal()
    leg_picked = Signal(int)
    end_picked = Signal(str, float, float)
    end_dragged = Signal(str, object, bool)
    via_dropped = Signal()
    avoid_picked = Signal(float, float, float)
    avoid_dropped = Signal(object)
    measuring_changed = Signal(bool)
    way_picked = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setScene(QGraphicsScene(self))
        self._room = WORLD
        self.setSceneRect(self._room)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setViewportUpdateMode(QGraphicsView.ViewportUpdateMode.FullViewportUpdate)
        self.setTransformationAnchor(QGraphicsView.ViewportAnchor.NoAnchor)
        self.setResizeAnchor(QGraphicsView.ViewportAnchor.AnchorViewCenter)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        # The coast covers everything; filling the ground before it is a millisecond of each frame.
        self.viewport().setAutoFillBackground(False)
        self.viewport().setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.viewport().setCursor(Qt.CursorShape.CrossCursor)
        self.setAccessibleName(self.tr("Chart"))
        self.setAccessibleDescription(
            self.tr(
                "Plus and minus zoom, the arrow keys move the chart, the menu key offers what can be done "
                "in its middle; the legs table says the same in words."
            )
        )
        self.painter_jobs = JobRunner("chart", self)
        self._colours = DAY
        self._make_layers()
        self._pointer = Pointer(self)
        self._measuring = False
        self.removable: frozenset[Zone] = frozenset()
        self._fitted: QRectF | None = None
        self._shows_all = True
        self._asked = 0.0
        self._settle = QTimer(self)
        self._settle.setSingleShot(True)
        self._settle.setInterval(_SETTLE_MS)
        self._settle.timeout.connect(self._demand_coast)

    def _make_layers(self) -> None:
        room = self._room
        self.coast = CoastLayer(room, self.painter_jobs, self.viewport().update)
        self.field, self.wind = FieldLayer(room), WindLayer(room)
        self.ports, self.route = PortsLayer(room), RouteLayer(room)
        self.zones, self.isochrones = ZonesLayer(room), IsochroneLayer(room, self.route)
        self.others, self.members = OthersLayer(room, self.route), MembersLayer(room, self.route)
        self.measure, self.trouble = MeasureLayer(room), TroubleLayer(room)
        self.legend = LegendLayer(room)
        self.legend.setVisible(False)
        self.field.setVisible(False)
        degrees = DegreesLayer(room)
        self._stack = Stack(
            ground=(self.coast,),
            weather=(self.field, self.wind),
            lying=(
                *(GraticuleLayer(room), self.zones, self.isochrones, self.members, self.others, self.route),
                *(LabelLayer(room), self.ports),
            ),
            above=(
                *(
                    EndsLayer(room, self.ports),
                    MemberBoatsLayer(room, self.members, self.route),
                    BoatLayer(room, self.route),
                    degrees,
                    ScaleLayer(room),
                    CoarseLayer(room),
                    self.legend,
                ),
                *(self.measure, self.trouble),
            ),
        )
        self.easel = Easel(self, self._stack, self.ports, degrees)

    def set_palette(self, colours: Palette) -> None:
        """Show the chart in the colours of another light."""
        self._colours = colours
        for layer in self._stack.layers:
            layer.set_palette(colours)
        self.viewport().update()
        self.refresh_coast()

    def show_scheme(self, scheme: Scheme) -> None:
        """Give the colours of the route another meaning."""
        if scheme is self.route.scheme:
            return
        self.route.show_scheme(scheme)
        self.legend.show_scheme(scheme)

    # --- what is shown ------------------------------------------------------------------------------

    def show_answer(self, answer: Answer | None) -> None:
        """Show a passage and its wind at departure, or neither."""
        passage = answer.passage if answer else None
        self.route.show_passage(passage)
        self.legend.setVisible(passage is not None)
        if answer is None or passage is None:
            self.wind.show_wind(None, 0.0)
            self.field.show_wind(None, 0.0)
            return
        self.show_time(answer, passage.departure.timestamp())

    def show_time(self, answer: Answer, time: float) -> None:
        """Show wind and boat at a time [s since 1970-01-01T00:00Z]."""
        self.wind.show_wind(answer.wind, time)
        self.field.show_wind(answer.wind, time)
        self.zones.show_time(time)
        self.route.place_boat(time)

    def choose_ends(self, ends: Mapping[str, Port]) -> None:
        """Mark the places that the passage begins, ends and is led through: ``from``, ``to``, ``via``."""
        self.ports.choose(ends)

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
        whole = self.viewport().rect()
        bottom = min(_FIT_BOTTOM_PX, whole.height() // 5)
        if self.legend.has_room(QRectF(whole), self.font()):
            legend = self.legend.card(QRectF(whole), self.font())
            bottom = max(bottom, round(whole.height() - legend.top()) + _FIT_ABOVE_PX)
        view = whole.adjusted(_FIT_SIDES_PX, _FIT_TOP_PX, -_FIT_SIDES_PX, -bottom)
        width, height = (max(side, _LEAST_FITTED_M) for side in (area.width(), area.height()))
        self._set_scale(min(max(view.width(), 50) / width, max(view.height(), 50) / height))
        shift = (bottom - _FIT_TOP_PX) / 2.0 / self.transform().m11()
        self.centerOn(area.center() + QPointF(0.0, shift))
        self._moved(keep_fit=True)

    def fit_again(self) -> None:
        """Keep clear of a legend that has grown what was fitted, unless the chart was moved since."""
        if self._fitted is not None:
            self.fit(self._fitted)

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
        at_rest = not self._settle.isActive() and not self.easel.is_moving
        return at_rest and self.coast.is_up_to_date and self.ports.is_complete

    # --- measuring ----------------------------------------------------------------------------------

    @property
    def is_measuring(self) -> bool:
        """Whether a click begins or ends the measuring line."""
        return self._measuring

    def set_measuring(self, on: bool) -> None:
        """Take the measuring line in hand, or put it away."""
        if on != self._measuring:
            self._measuring = on
            self._pointer.drop_line()
            self.measuring_changed.emit(on)

    def measure_from(self, lat: float, lon: float) -> None:
        """Begin to measure at a position [degrees]."""
        self.set_measuring(True)
        self._pointer.drop_line()
        self._pointer.set_or_end_line(lat, lon)

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

    def pan(self, dx: float, dy: float) -> None:
        """Move the chart by pixels."""
        self._pan(dx, dy)

    def _pan(self, dx: float, dy: float) -> None:
        for bar, shift in ((self.horizontalScrollBar(), dx), (self.verticalScrollBar(), dy)):
            bar.setValue(bar.value() + round(shift))
        self._moved()

    def _moved(self, *, keep_fit: bool = False) -> None:
        if not keep_fit:
            self._fitted, self._shows_all = None, False
        self.easel.moved()
        self.viewport().update()
        self.refresh_coast()

    def refresh_coast(self) -> None:
        """See to it that coast and lattice fit the view, as soon as it rests, or has moved for a while."""
        now = time.monotonic()
        if not self._settle.isActive():
            self._asked = now
            self._settle.start()
            return
        back, _ = self.viewportTransform().inverted()
        covered = self.coast.covers(back.mapRect(QRectF(self.viewport().rect())))
        if now - self._asked < (_PATIENCE_S if covered else _BARE_S):
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
            self.fit_again()
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
            self._pointer.follow(*self.middle())
        elif key in {Qt.Key.Key_Plus, Qt.Key.Key_Equal}:
            self.zoom_in()
        elif key in {Qt.Key.Key_Minus, Qt.Key.Key_Underscore}:
            self.zoom_out()
        elif self._measuring and key in {Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space}:
            self._pointer.set_or_end_line(*self.middle())
        elif self._measuring and key == Qt.Key.Key_Escape:
            self.set_measuring(False)
        else:
            # Not QGraphicsView's: it would scroll by keys that the window knows.
            QWidget.keyPressEvent(self, event)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Begin to drag, or a click."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._pointer.press(event)
            event.accept()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag what is held; tell the position under the pointer."""
        self._pointer.move(event)
        self.pointed.emit(*self.position_at(event.position()))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """End a drag or a click."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._pointer.release(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Zoom in at the pointer."""
        if not self._measuring:
            self.zoom(_STEP**2, event.position())

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Offer what can be done with the position under the pointer, or in the middle for the keyboard."""
        by_mouse = event.reason() == QContextMenuEvent.Reason.Mouse
        at = event.pos() if by_mouse else self.viewport().rect().center()
        place = self.position_at(QPointF(at))
        open_menu(self, *place, event.globalPos() if by_mouse else self.viewport().mapToGlobal(at))

    def viewportEvent(self, event: QEvent) -> bool:
        """Tell when the pointer has left."""
        if event.type() == QEvent.Type.Leave:
            self.left.emit()
        return bool(super().viewportEvent(event))

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the layers, and a frame when the keys go to the chart."""
        del event
        painter = QPainter(self.viewport())
        try:
            self.easel.paint(painter, self._taken())
            if self.hasFocus() and self.window().isActiveWindow():
                self._draw_focus(painter)
        finally:
            painter.end()

    def _draw_focus(self, painter: QPainter) -> None:
        painter.setPen(QPen(self._colours.focus, 2.0))
        painter.drawRect(self.viewport().rect().adjusted(1, 1, -1, -1))
        if self._measuring:
            middle = self.viewport().rect().center()
            painter.drawLine(middle.x() - 7, middle.y(), middle.x() + 7, middle.y())
            painter.drawLine(middle.x(), middle.y() - 7, middle.x(), middle.y() + 7)

    def _taken(self) -> list[QRectF]:
        """Places that no label may take: buttons, scale, legend."""
        view = QRectF(self.viewport().rect())
        widgets = [child for child in self.children() if isinstance(child, QWidget)]
        taken = [QRectF(c.geometry()) for c in widgets if c.isVisible() and c is not self.viewport()]
        taken += [ScaleLayer.place(view), *self.trouble.taken(self.viewportTransform())]
        if self.legend.isVisible() and self.legend.has_room(view, self.font()):
            taken.append(self.legend.card(view, self.font()))
        return taken

    def middle(self) -> tuple[float, float]:
        """Position in the middle of the view [degrees]."""
        return self.position_at(QPointF(self.viewport().rect().center()))

    def position_at(self, at: QPointF) -> tuple[float, float]:
        """Position [degrees] at a point of the viewport."""
        back, _ = self.viewportTransform().inverted()
        return position(back.map(at))
