"""The measuring line: a rhumb line from where it was set to the pointer, with distance and bearing."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen, QTransform

from seacruise.desktop.chart.labels import around
from seacruise.desktop.chart.layer import Layer, text_width
from seacruise.desktop.chart.plane import point
from seacruise.desktop.readout import bearing_text
from seacruise.desktop.style import scaled_font

_PAD_PX = 6.0


class MeasureLayer(Layer):
    """A line between two positions, or nothing."""

    def __init__(self, bounds: QRectF) -> None:
        super().__init__(bounds)
        self._from: tuple[float, float] | None = None
        self._to: tuple[float, float] | None = None

    @property
    def begun(self) -> bool:
        """Whether its beginning is set."""
        return self._from is not None

    @property
    def text(self) -> str:
        """What is measured; empty before there are two ends."""
        if self._from is None or self._to is None or self._from == self._to:
            return ""
        return bearing_text(*self._from, *self._to)

    def begin(self, lat: float, lon: float) -> None:
        """Set the beginning [degrees]."""
        self._from, self._to = (lat, lon), None
        self.update()

    def reach(self, lat: float, lon: float) -> None:
        """Move the end [degrees]."""
        if self._from is not None:
            self._to = (lat, lon)
            self.update()

    def clear(self) -> None:
        """Take the line away."""
        self._from = self._to = None
        self.update()

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw the line, and its text on a card at the end."""
        del view
        if self._from is None:
            return
        begin = to_pixels.map(point(*self._from))
        end = begin if self._to is None else to_pixels.map(point(*self._to))
        for colour, width in ((self.colours.casing, 5.0), (self.colours.magenta, 2.0)):
            painter.setPen(QPen(colour, width))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawLine(begin, end)
            painter.drawEllipse(begin, 4.0, 4.0)
        if not self.text:
            return
        before = painter.font()
        painter.setFont(scaled_font(before, 1.0, bold=True))
        height = painter.fontMetrics().height() + _PAD_PX
        places = around(end, text_width(painter.font(), self.text) + 2 * _PAD_PX, height, 14.0)
        card = self.labels.claim(*places) or places[0]
        painter.setPen(QPen(self.colours.card_line, 1.0))
        painter.setBrush(self.colours.card)
        painter.drawRoundedRect(card, 5, 5)
        painter.setPen(self.colours.ink)
        base = QPointF(card.left() + _PAD_PX, card.top() + _PAD_PX / 2 + painter.fontMetrics().ascent())
        painter.drawText(base, self.text)
        painter.setFont(before)
