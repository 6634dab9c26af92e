"""Duration or arrival over departure as a curve, with the band of an ensemble behind it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Final

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFocusEvent,
    QFontMetricsF,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPolygonF,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from seacruise.desktop.language import fill
from seacruise.desktop.pages.day_axis import day_clock, day_text, midnights, moment_at, ticks_of_day
from seacruise.desktop.pages.departures_model import Curve, Dot, Measure
from seacruise.desktop.pages.plot import HOURS_PER_DAY, Scale, step_h, ticks_h, with_room
from seacruise.desktop.style import (
    ACCENT,
    CARD,
    FOCUS,
    GOOD_INK,
    INK,
    LINE,
    MAGENTA,
    MUTED,
    WARNING_INK,
    scaled_font,
    tinted,
)
from seacruise.units import SECONDS_PER_HOUR

COLOURS: Final = (ACCENT, MAGENTA, GOOD_INK, WARNING_INK)
STROKES: Final = (
    Qt.PenStyle.SolidLine,
    Qt.PenStyle.DashLine,
    Qt.PenStyle.DashDotLine,
    Qt.PenStyle.DotLine,
)
_DOT_PX: Final = 3.5
_NAME_PX: Final = 118
_CATCH_PX: Final = 24.0
_STEPS: Final = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}
_LINES: Final = {Qt.Key.Key_Up: -1, Qt.Key.Key_Down: 1}


class DepartureCurve(QWidget):
    """The curve; one dot a departure, a cross at the foot where there is no passage.

    Left and right go from departure to departure, up and down from yacht to yacht, Enter takes one; a click
    does both.

    Signals: ``chosen(number)`` and ``taken(number)`` of a departure.
    """

    chosen = Signal(int)
    taken = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setAccessibleName(self.tr("Curve over the departures; the table beside it says the same"))
        self._curves: tuple[Curve, ...] = ()
        self._missing: frozenset[int] = frozenset()
        self._best: frozenset[int] = frozenset()
        self._measure: Measure = "duration"
        self._number: int | None = None
        self._named: int | None = None
        self._light = "day"
        self._small = scaled_font(self.font(), 0.9)

    # --- what is shown ------------------------------------------------------------------------------

    def show_curves(
        self,
        curves: Sequence[Curve],
        measure: Measure,
        *,
        missing: frozenset[int] = frozenset(),
        best: frozenset[int] = frozenset(),
    ) -> None:
        """Show curves.

        Parameters
        ----------
        missing, best
            Numbers of the departures without a passage, and of the best ones.
        """
        self._curves, self._measure = tuple(curves), measure
        self._missing, self._best = missing, best
        found = [dot for dot in self._dots() if dot.number in best and dot.value is not None]
        # Several yachts leave best at about the same time: their words would lie over each other.
        self._named = min(found, key=lambda dot: dot.value or 0.0).number if found else None
        if self._dot(self._number) is None:
            self._number = None
        self.update()

    def show_light(self, light: str) -> None:
        """Draw in the colours of a light: ``day``, ``dusk`` or ``night``."""
        self._light = light
        self.update()

    def choose(self, number: int | None) -> None:
        """Mark a departure, without a word to anybody."""
        if number != self._number:
            self._number = number
            self.update()

    @property
    def number(self) -> int | None:
        """The departure that is marked."""
        return self._number

    def sizeHint(self) -> QSize:
        """Room for a dozen departures."""
        return QSize(420, 180)

    def minimumSizeHint(self) -> QSize:
        """Room for axes with a few ticks."""
        return QSize(160, 116)

    # --- geometry -----------------------------------------------------------------------------------

    def _dots(self) -> list[Dot]:
        return [dot for curve in self._curves for dot in curve.dots]

    def _dot(self, number: int | None) -> Dot | None:
        return next((dot for dot in self._dots() if dot.number == number), None)

    @property
    def _is_legend_shown(self) -> bool:
        """Whether there are several yachts, and room for enough of each name to tell them apart."""
        return 1 < len(self._curves) <= self.width() // _NAME_PX

    def _frame(self) -> QRectF:
        metrics = self.fontMetrics()
        left = metrics.horizontalAdvance("Wed 00:00 " if self._measure == "arrival" else "000 h ") + 4
        legend = 1.5 if self._is_legend_shown else 0.5
        top = legend * metrics.height()
        return QRectF(left, top, self.width() - left - 14.0, self.height() - top - 2.1 * metrics.height() - 4)

    def _scales(self) -> tuple[Scale, Scale] | None:
        """Map departures [h since 1970] and values [h] to pixels; ``None`` while there is nothing."""
        dots = self._dots()
        if not dots:
            return None
        values = [v for dot in dots for v in (dot.value, dot.low, dot.high) if v is not None]
        low, high = with_room(min(values, default=0.0), max(values, default=24.0), least=2.0)
        times = [dot.time / SECONDS_PER_HOUR for dot in dots]
        first, last = min(times), max(times)
        edge = max((last - first) * 0.03, 0.25)
        frame = self._frame()
        low = low if self._measure == "arrival" else max(low, 0.0)
        return (
            Scale(first - edge, last + edge, frame.left(), frame.right()),
            Scale(low, high, frame.bottom(), frame.top()),
        )

    def place_of(self, number: int) -> QPointF | None:
        """Where a departure is drawn [pixels]; at the foot where it has no passage yet or none."""
        scales, dot = self._scales(), self._dot(number)
        return None if scales is None or dot is None else self._place(dot, *scales)

    def _place(self, dot: Dot, x: Scale, y: Scale) -> QPointF:
        height = y.begin - 6.0 if dot.value is None else y.to_px(dot.value)
        return QPointF(x.to_px(dot.time / SECONDS_PER_HOUR), height)

    def box_of_name(self) -> QRectF | None:
        """Where the best departure is named [pixels]: over no dot, and over least of a line."""
        scales, dot = self._scales(), self._dot(self._named)
        if scales is None or dot is None:
            return None
        at, frame, gap = self._place(dot, *scales), self._frame(), 3.0 * _DOT_PX
        metrics = QFontMetricsF(scaled_font(self._small, 1.0, bold=True))
        wide, high = metrics.horizontalAdvance(self.tr("shortest")) + 4.0, metrics.height()
        # Within the frame: the words beside the axis are not to be written over.
        left = min(max(at.x() - wide / 2.0, frame.left()), frame.right() - wide)
        corners = (
            (left, at.y() - gap - high),
            (at.x() - gap - wide, at.y() - high / 2.0),
            (at.x() + gap, at.y() - high / 2.0),
            (left, at.y() + gap),
        )
        boxes = [QRectF(*corner, wide, high) for corner in corners]
        inked = self._inked(*scales)
        free = [box for box in boxes if frame.contains(box)] or boxes[:1]
        return min(free, key=lambda box: sum(weight for place, weight in inked if box.contains(place)))

    def _inked(self, x: Scale, y: Scale) -> list[tuple[QPointF, int]]:
        """Points on the curves, with how much it matters that each is seen."""
        points = []
        for curve in self._curves:
            for part in _parts(curve.dots, lambda dot: dot.value is not None):
                places = [self._place(dot, x, y) for dot in part]
                for off in (
                    QPointF(-_DOT_PX, 0),
                    QPointF(_DOT_PX, 0),
                    QPointF(0, -_DOT_PX),
                    QPointF(0, _DOT_PX),
                ):
                    points += [(place + off, 100) for place in places]
                for here, there in pairwise(places):
                    points += [(here + (there - here) * (k / 12.0), 1) for k in range(13)]
        return points

    def _nearest(self, at: QPointF) -> int | None:
        """Departure under the pointer: the nearest dot of the nearest departure in time."""
        scales = self._scales()
        if scales is None:
            return None

        def gaps(dot: Dot) -> tuple[float, float]:
            place = self._place(dot, *scales)
            return (abs(place.x() - at.x()), abs(place.y() - at.y()))

        nearest = min(self._dots(), key=gaps)
        return nearest.number if gaps(nearest)[0] <= _CATCH_PX else None

    # --- hands --------------------------------------------------------------------------------------

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Go along the curve, to another one, or take a departure."""
        key = Qt.Key(event.key())
        if key in _STEPS or key in _LINES or key in {Qt.Key.Key_Home, Qt.Key.Key_End}:
            self._go(key)
        elif key in {Qt.Key.Key_Return, Qt.Key.Key_Enter} and self._number is not None:
            self.taken.emit(self._number)
        else:
            super().keyPressEvent(event)

    def _go(self, key: Qt.Key) -> None:
        curves = [curve for curve in self._curves if curve.dots]
        if not curves:
            return
        line, at = next(
            (
                (line, at)
                for line, curve in enumerate(curves)
                for at, dot in enumerate(curve.dots)
                if dot.number == self._number
            ),
            (0, -1 if key == Qt.Key.Key_Right else 0),
        )
        line = min(max(line + _LINES.get(key, 0), 0), len(curves) - 1)
        last = len(curves[line].dots) - 1
        at = {Qt.Key.Key_Home: 0, Qt.Key.Key_End: last}.get(key, at + _STEPS.get(key, 0))
        self._mark(curves[line].dots[min(max(at, 0), last)].number)

    def _mark(self, number: int) -> None:
        self.choose(number)
        self.chosen.emit(number)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Mark and take the departure under the pointer."""
        number = self._nearest(event.position()) if event.button() == Qt.MouseButton.LeftButton else None
        if number is None:
            super().mousePressEvent(event)
            return
        self._mark(number)
        self.taken.emit(number)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Show that there is something to take."""
        over = self._nearest(event.position()) is not None
        self.setCursor(Qt.CursorShape.PointingHandCursor if over else Qt.CursorShape.ArrowCursor)

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Show the frame of the focus."""
        super().focusInEvent(event)
        self.update()

    def changeEvent(self, event: QEvent) -> None:
        """Follow the font."""
        if event.type() == QEvent.Type.FontChange:
            self._small = scaled_font(self.font(), 0.9)
        super().changeEvent(event)

    # --- drawing ------------------------------------------------------------------------------------

    def _ink(self, colour: str, alpha: int = 255) -> QColor:
        ink = QColor(tinted(colour, self._light))
        ink.setAlpha(alpha)
        return ink

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw axes, bands, curves, dots."""
        del event
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(self.rect(), self._ink(CARD))
        painter.setFont(self._small)
        scales = self._scales()
        if scales is not None:
            self._draw_axes(painter, *scales)
            for number, curve in enumerate(self._curves):
                self._draw_band(painter, curve, self._ink(COLOURS[number % 4], 46), *scales)
            for number, curve in enumerate(self._curves):
                self._draw_curve(painter, curve, number % 4, *scales)
            self._draw_name(painter)
            self._draw_legend(painter)
        if self.hasFocus():
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(QPen(self._ink(FOCUS), 2.0))
            painter.drawRoundedRect(QRectF(self.rect()).adjusted(1, 1, -1, -1), 4, 4)
        painter.end()

    def _draw_axes(self, painter: QPainter, x: Scale, y: Scale) -> None:
        metrics, frame = painter.fontMetrics(), self._frame()
        grid, text = QPen(self._ink(LINE), 1.0), self._ink(MUTED)
        ticks = ticks_h if self._measure == "duration" else ticks_of_day
        for value in ticks(y.low, y.high, max(2, int(frame.height() / (2.2 * metrics.height())))):
            at = y.to_px(value)
            painter.setPen(grid)
            painter.drawLine(QPointF(frame.left(), at), QPointF(frame.right(), at))
            painter.setPen(text)
            label = fill(self.tr("{h:g} h"), h=value) if self._measure == "duration" else day_clock(value)
            box = QRectF(0, at - metrics.height() / 2, frame.left() - 6, metrics.height())
            painter.drawText(box, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, label)
        self._draw_times(painter, x)
        painter.setPen(QPen(self._ink(MUTED), 1.0))
        painter.drawLine(frame.bottomLeft(), frame.bottomRight())

    def _draw_times(self, painter: QPainter, x: Scale) -> None:
        """Write the time at each tick and the days below; days alone where a tick is a day."""
        metrics, frame = painter.fontMetrics(), self._frame()
        most = max(2, int(frame.width() / (metrics.horizontalAdvance("00 MMM") + 14)))
        by_day = step_h(x.high - x.low, most) >= HOURS_PER_DAY
        for value in ticks_of_day(x.low, x.high, most):
            at = x.to_px(value)
            painter.setPen(QPen(self._ink(LINE), 1.0))
            painter.drawLine(QPointF(at, frame.top()), QPointF(at, frame.bottom() + 3))
            painter.setPen(self._ink(MUTED))
            box = QRectF(at - 50, frame.bottom() + 4, 100, metrics.height())
            text = day_text(value, "d MMM") if by_day else f"{moment_at(value):%H:%M}"
            painter.drawText(box, Qt.AlignmentFlag.AlignHCenter, text)
        if by_day:
            return
        painter.setPen(self._ink(INK))
        days = [x.low, *midnights(x.low, x.high)]
        for begin, end in pairwise([*days, math.inf]):
            label = day_text(begin, "ddd d MMM")
            left = max(x.to_px(begin), frame.left())
            right = self.width() if math.isinf(end) else x.to_px(end) - 8
            if left + metrics.horizontalAdvance(label) <= right:
                painter.drawText(
                    QPointF(left, frame.bottom() + 4 + metrics.height() + metrics.ascent()), label
                )

    def _draw_band(self, painter: QPainter, curve: Curve, colour: QColor, x: Scale, y: Scale) -> None:
        """Fill between 10 and 90 %, and a thin line at 50; a departure without them ends the band."""
        middle = QPen(colour.darker(130), 1.0)
        middle.setColor(QColor(colour.red(), colour.green(), colour.blue(), 150))
        for part in _parts(curve.dots, lambda dot: dot.low is not None and dot.high is not None):
            across = [x.to_px(dot.time / SECONDS_PER_HOUR) for dot in part]
            sides = list(zip(across, part, strict=True))
            if len(part) == 1:
                # One departure alone has a band too: as wide as its dot.
                sides = [(across[0] - _DOT_PX, part[0]), (across[0] + _DOT_PX, part[0])]
            low = [QPointF(at, y.to_px(dot.low or 0.0)) for at, dot in sides]
            high = [QPointF(at, y.to_px(dot.high or 0.0)) for at, dot in sides]
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(colour)
            painter.drawPolygon(QPolygonF([*low, *reversed(high)]))
            painter.setPen(middle)
            painter.drawPolyline(QPolygonF([QPointF(at, y.to_px(dot.middle or 0.0)) for at, dot in sides]))

    def _draw_curve(self, painter: QPainter, curve: Curve, number: int, x: Scale, y: Scale) -> None:
        colour = self._ink(COLOURS[number])
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(colour, 2.0, STROKES[number]))
        for part in _parts(curve.dots, lambda dot: dot.value is not None):
            for here, there in pairwise(part):
                painter.drawLine(self._place(here, x, y), self._place(there, x, y))
        for dot in curve.dots:
            self._draw_dot(painter, dot, self._place(dot, x, y), colour)

    def _draw_dot(self, painter: QPainter, dot: Dot, at: QPointF, colour: QColor) -> None:
        if dot.number == self._number:
            frame = self._frame()
            painter.setPen(QPen(self._ink(FOCUS), 1.0, Qt.PenStyle.DashLine))
            painter.drawLine(QPointF(at.x(), frame.top()), QPointF(at.x(), frame.bottom()))
            painter.setPen(QPen(self._ink(FOCUS), 2.0))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawEllipse(at, 2.4 * _DOT_PX, 2.4 * _DOT_PX)
        if dot.value is not None:
            painter.setPen(QPen(self._ink(CARD), 1.0))
            painter.setBrush(colour)
            radius = _DOT_PX * (1.6 if dot.number in self._best else 1.0)
            painter.drawEllipse(at, radius, radius)
        elif dot.number in self._missing:
            painter.setPen(QPen(colour, 1.8))
            for side in (-1, 1):
                arm = QPointF(_DOT_PX, side * _DOT_PX)
                painter.drawLine(at - arm, at + arm)

    def _draw_name(self, painter: QPainter) -> None:
        """Name the best departure."""
        if (box := self.box_of_name()) is not None:
            painter.setFont(scaled_font(self._small, 1.0, bold=True))
            painter.fillRect(box, self._ink(CARD))
            painter.setPen(self._ink(INK))
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, self.tr("shortest"))
            painter.setFont(self._small)

    def _draw_legend(self, painter: QPainter) -> None:
        """Name the yachts above the frame, where there are several; each gets its share of the width."""
        if not self._is_legend_shown:
            return
        frame, metrics = self._frame(), painter.fontMetrics()
        share = frame.width() / len(self._curves)
        for number, curve in enumerate(self._curves):
            left = frame.left() + number * share
            middle = 2 + metrics.height() / 2
            painter.setPen(QPen(self._ink(COLOURS[number % 4]), 2.0, STROKES[number % 4]))
            painter.drawLine(QPointF(left, middle), QPointF(left + 22, middle))
            painter.setPen(self._ink(INK))
            name = metrics.elidedText(curve.yacht, Qt.TextElideMode.ElideRight, int(share - 32))
            painter.drawText(QPointF(left + 27, 2 + metrics.ascent()), name)


def _parts(dots: Sequence[Dot], is_there: Callable[[Dot], bool]) -> list[list[Dot]]:
    """Find the runs of dots that are there."""
    parts: list[list[Dot]] = [[]]
    for dot in dots:
        if is_there(dot):
            parts[-1].append(dot)
        elif parts[-1]:
            parts.append([])
    return [part for part in parts if part]
