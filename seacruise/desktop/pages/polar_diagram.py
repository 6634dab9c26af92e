"""A polar diagram that follows the pointer: painted here, since a plotting library takes a second to load."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, QSizeF, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFont,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPainterPath,
    QPaintEvent,
    QPen,
    QPixmap,
    QPolygonF,
    QResizeEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from seacruise.desktop.pages.yacht_model import Yacht
from seacruise.desktop.style import ACCENT, CARD, FOCUS, INK, LINE, MAGENTA, MUTED, scaled_font, tinted
from seacruise.export.polar_slices import LogPoints, Slice, slice_of
from seacruise.yacht.polar import Polar

Array = NDArray[np.float64]

_SECOND: Final = "#B34700"
"""Orange for the yacht that is compared; with the blue of the first told apart by every kind of eye."""

_HULL_ALPHA: Final = 26
_RINGS: Final = (1, 2, 5, 10, 20, 50, 100, 1000)
_SPOKES: Final = 30
_MARGIN_EM: Final = 1.7


class PolarDiagram(QWidget):
    """Slices of one or two yachts in one wind; ``angle_changed(angle)`` when another angle is looked at.

    The angle is in degrees, negative on port tack, or ``None``. Half a circle is drawn unless a yacht or the
    points of a log differ between the tacks. Left and right arrow keys go round the circle.
    """

    angle_changed = Signal(object)
    wind_wanted = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._yachts: tuple[Yacht, ...] = ()
        self._slices: list[dict[int, Slice]] = []
        self._tws_kn = 10.0
        self._percent = 100.0
        self._hull = True
        self._points: LogPoints | None = None
        self._angle: float | None = None
        self._light = "day"
        # All but the angle that is looked at, which follows the pointer.
        self._picture: QPixmap | None = None
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(260, 280)
        self.setAccessibleName(self.tr("Polar diagram"))
        self.setToolTip("")

    def sizeHint(self) -> QSize:
        """Size that shows the diagram well."""
        return QSize(440, 380)

    # --- what is shown ------------------------------------------------------------------------------

    def show_yachts(
        self, yachts: Sequence[Yacht], points: LogPoints | None = None, *, tws_kn: float | None = None
    ) -> None:
        """Show a yacht, or two to compare, and points of a log over them.

        Parameters
        ----------
        tws_kn
            The wind [kn]; without it the one that is shown.
        """
        self._tws_kn = tws_kn or self._tws_kn
        self._yachts = tuple(yachts)
        self._points = points
        self._cut()

    def set_wind(self, tws_kn: float) -> None:
        """Cut at another wind [kn]."""
        if tws_kn != self._tws_kn:
            self._tws_kn = tws_kn
            self._cut()

    def set_percent(self, percent: float) -> None:
        """Show a share of the polar."""
        self._percent = percent
        self._redraw()

    def show_hull(self, on: bool) -> None:
        """Show what is made good on two headings, or not."""
        self._hull = on
        self._redraw()

    def show_light(self, light: str) -> None:
        """Take the colours of a light: ``day``, ``dusk`` or ``night``."""
        self._light = light
        self._redraw()

    @property
    def angle(self) -> float | None:
        """Angle that is looked at [degrees, negative on port tack]."""
        return self._angle

    def look_at(self, angle: float | None) -> None:
        """Look at an angle [degrees, negative on port tack]."""
        if angle is not None and not self.full:
            angle = abs(angle)
        if angle != self._angle:
            self._angle = angle
            self.angle_changed.emit(angle)
            self.update()

    @property
    def full(self) -> bool:
        """Whether both tacks are drawn."""
        sides = any(not isinstance(yacht, Polar) for yacht in self._yachts)
        return sides or (self._points is not None and self._points.both_tacks)

    @property
    def slices(self) -> list[dict[int, Slice]]:
        """Of each yacht the slice that is drawn on starboard (1) and on port tack (-1)."""
        return self._slices

    def _cut(self) -> None:
        self._slices = [dict(self._sides(yacht)) for yacht in self._yachts]
        if self._angle is not None and not self.full:
            self._angle = abs(self._angle)
        self._redraw()

    def _sides(self, yacht: Yacht) -> Iterator[tuple[int, Slice]]:
        if isinstance(yacht, Polar):
            cut = slice_of(yacht, self._tws_kn, with_sails=False)
            yield 1, cut
            if self.full:
                yield -1, cut
        else:
            yield 1, slice_of(yacht.starboard, self._tws_kn, with_sails=False)
            yield -1, slice_of(yacht.port, self._tws_kn, with_sails=False)

    # --- geometry -----------------------------------------------------------------------------------

    def _top(self) -> float:
        """Speed at the rim [kn]."""
        speeds = [float(cut.hull_kn.max(initial=0.0)) for sides in self._slices for cut in sides.values()]
        top = max(speeds, default=0.0) * self._percent / 100.0
        if self._points is not None:
            top = max(top, float(self._points.near(self._tws_kn).speed_kn.max(initial=0.0)))
        return max(1.0, math.ceil(top * 1.05))

    def _frame(self) -> tuple[QPointF, float]:
        """Centre, and radius of the rim [pixels]."""
        margin = _MARGIN_EM * self.fontMetrics().height()
        wide, high = self.width() - 2 * margin, self.height() - 2 * margin
        radius = max(20.0, min(wide / (2.0 if self.full else 1.0), high / 2.0))
        middle = self.width() / 2.0
        return QPointF(middle if self.full else middle - radius / 2.0, self.height() / 2.0), radius

    def _place(self, angle: float, share: float) -> QPointF:
        centre, radius = self._frame()
        turn = math.radians(angle)
        return QPointF(
            centre.x() + radius * share * math.sin(turn), centre.y() - radius * share * math.cos(turn)
        )

    def _polygon(self, angles: Array, speeds: Array, top: float) -> QPolygonF:
        centre, radius = self._frame()
        turn = np.radians(angles)
        r = radius * speeds / top
        x, y = centre.x() + r * np.sin(turn), centre.y() - r * np.cos(turn)
        return QPolygonF([QPointF(a, b) for a, b in zip(x.tolist(), y.tolist(), strict=True)])

    # --- events -------------------------------------------------------------------------------------

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Look at the angle under the pointer."""
        centre, radius = self._frame()
        at = event.position() - centre
        if not self._yachts or math.hypot(at.x(), at.y()) > 1.25 * radius:
            return
        angle = math.degrees(math.atan2(at.x(), -at.y()))
        self.look_at(float(round(angle)))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Go round with left and right (Shift: five degrees), change the wind with up and down."""
        step = 5.0 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1.0
        moves = {Qt.Key.Key_Right: step, Qt.Key.Key_Left: -step}
        winds = {Qt.Key.Key_Up: 1, Qt.Key.Key_Down: -1}
        if event.key() in moves and self._yachts:
            now = self._angle if self._angle is not None else 45.0 - step
            lowest = -180.0 if self.full else 0.0
            self.look_at(min(180.0, max(lowest, now + moves[Qt.Key(event.key())])))
        elif event.key() in winds:
            self.wind_wanted.emit(winds[Qt.Key(event.key())])
        elif event.key() == Qt.Key.Key_Escape and self._angle is not None:
            self.look_at(None)
        else:
            super().keyPressEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        """Follow the font."""
        if event.type() in {QEvent.Type.FontChange, QEvent.Type.PaletteChange}:
            self._redraw()
        super().changeEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Draw for another size."""
        super().resizeEvent(event)
        self._redraw()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw grid, points, hull, curves, best VMG and the angle that is looked at."""
        del event
        ratio = self.devicePixelRatioF()
        if self._picture is None or self._picture.devicePixelRatio() != ratio:
            self._picture = self._draw_picture(ratio)
        painter = QPainter(self)
        painter.drawPixmap(0, 0, self._picture)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if self._yachts:
            self._draw_angle(painter, self._top())
        if self.hasFocus():
            painter.setPen(QPen(self._colour(FOCUS), 2.0))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(QRectF(self.rect()).adjusted(1, 1, -1, -1))
        painter.end()

    def _redraw(self) -> None:
        self._picture = None
        self.update()

    def _draw_picture(self, ratio: float) -> QPixmap:
        picture = QPixmap((QSizeF(self.size()) * ratio).toSize())
        picture.setDevicePixelRatio(ratio)
        picture.fill(self._colour(CARD))
        painter = QPainter(picture)
        painter.setFont(self.font())
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if self._yachts:
            top = self._top()
            self._draw_grid(painter, top)
            self._draw_points(painter, top)
            for number, sides in enumerate(self._slices):
                self._draw_yacht(painter, number, sides, top)
        painter.end()
        return picture

    # --- drawing ------------------------------------------------------------------------------------

    def _colour(self, colour: str) -> QColor:
        return QColor(tinted(colour, self._light))

    def _draw_grid(self, painter: QPainter, top: float) -> None:
        centre, radius = self._frame()
        step = next(ring for ring in _RINGS if top / ring <= 6)
        small = scaled_font(self.font(), 0.85)
        painter.setFont(small)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        begin, span = (0, 360 * 16) if self.full else (-90 * 16, 180 * 16)
        for speed in (*range(step, math.ceil(top), step), top):
            r = radius * speed / top
            painter.setPen(QPen(self._colour(LINE), 1.4 if speed == top else 1.0))
            painter.drawArc(QRectF(centre.x() - r, centre.y() - r, 2 * r, 2 * r), begin, span)
        painter.setPen(QPen(self._colour(LINE), 1.0))
        for angle in range(-180 if self.full else 0, 181, _SPOKES):
            painter.drawLine(centre, self._place(angle, 1.0))
        painter.setPen(self._colour(MUTED))
        room = painter.fontMetrics().height()
        for angle in range(-150 if self.full else 0, 181, _SPOKES):
            self._write(painter, self._place(angle, 1.0 + 0.85 * room / radius), f"{abs(angle)}°")
        for speed in range(step, math.ceil(top), step):
            place = self._place(0.0, speed / top)
            self._write(painter, place - QPointF(0.75 * room, 0.0), str(speed))

    def _write(self, painter: QPainter, middle: QPointF, text: str) -> None:
        box = QRectF(0, 0, painter.fontMetrics().horizontalAdvance(text) + 6, painter.fontMetrics().height())
        box.moveCenter(middle)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)

    def _draw_points(self, painter: QPainter, top: float) -> None:
        if self._points is None:
            return
        near = self._points.near(self._tws_kn)
        colour = self._colour(INK)
        colour.setAlpha(90)
        painter.setPen(QPen(colour, 2.0))
        # Smooth edges of some thousand dots would take longer than everything else.
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, on=False)
        painter.drawPoints(self._polygon(near.twa if self.full else np.abs(near.twa), near.speed_kn, top))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)

    def _yacht_colour(self, number: int) -> QColor:
        return self._colour(ACCENT if number == 0 else _SECOND)

    def _draw_yacht(self, painter: QPainter, number: int, sides: dict[int, Slice], top: float) -> None:
        colour = self._yacht_colour(number)
        share = self._percent / 100.0
        dash = Qt.PenStyle.SolidLine if number == 0 else Qt.PenStyle.DashLine
        for side, cut in sides.items():
            angles = side * cut.twa
            # With sides that differ, the hull of one of them is not that of the yacht.
            if self._hull and isinstance(self._yachts[number], Polar):
                self._draw_hull(painter, self._polygon(angles, share * cut.hull_kn, top), number)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            faint = QColor(colour)
            faint.setAlpha(110)
            painter.setPen(QPen(faint, 1.2, dash))
            painter.drawPolyline(self._polygon(angles, share * cut.speed_kn, top))
            painter.setPen(QPen(colour, 2.4, dash))
            known = cut.known
            if known.any():
                painter.drawPolyline(self._polygon(angles[known], share * cut.speed_kn[known], top))
            painter.setPen(QPen(self._colour(CARD), 1.5))
            painter.setBrush(colour)
            for best in (cut.beat, cut.run):
                if best.vmg_kn > 0.0:
                    place = self._place(side * best.twa, share * best.boat_speed_kn / top)
                    painter.drawEllipse(place, 5.0, 5.0)

    def _draw_hull(self, painter: QPainter, line: QPolygonF, number: int) -> None:
        magenta = self._colour(MAGENTA)
        if number == 0:
            ground = QColor(magenta)
            ground.setAlpha(_HULL_ALPHA)
            area = QPainterPath(self._frame()[0])
            area.addPolygon(line)
            area.lineTo(self._frame()[0])
            painter.fillPath(area, ground)
        painter.setPen(QPen(magenta if number == 0 else self._yacht_colour(number), 1.4, Qt.PenStyle.DotLine))
        painter.drawPolyline(line)

    def _draw_angle(self, painter: QPainter, top: float) -> None:
        if self._angle is None:
            return
        painter.setPen(QPen(self._colour(MUTED), 1.2))
        painter.drawLine(self._frame()[0], self._place(self._angle, 1.0))
        side = -1 if self._angle < 0.0 else 1
        for number, sides in enumerate(self._slices):
            cut = sides.get(side, sides[1])
            speed = float(np.interp(abs(self._angle), cut.twa, cut.speed_kn)) * self._percent / 100.0
            painter.setPen(QPen(self._yacht_colour(number), 2.5))
            painter.setBrush(self._colour(CARD))
            painter.drawEllipse(self._place(self._angle, speed / top), 5.5, 5.5)
        bold = scaled_font(self.font(), 0.95, bold=True)
        bold.setStyleStrategy(QFont.StyleStrategy.PreferAntialias)
        painter.setFont(bold)
        painter.setPen(self._colour(INK))
        room = painter.fontMetrics().height()
        _, radius = self._frame()
        place = self._place(self._angle, 1.0 + 0.85 * room / radius)
        words = f"{abs(self._angle):.0f}°"
        box = QRectF(0, 0, painter.fontMetrics().horizontalAdvance(words) + 8, room)
        box.moveCenter(place)
        painter.fillRect(box, self._colour(CARD))
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, words)
