"""What must be known where the chart has the coarse coast only."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QCoreApplication, QPointF, QRectF
from PySide6.QtGui import QPainter, QPen, QTransform

from seacruise.desktop.chart.layer import Layer, text_width
from seacruise.desktop.chart.plane import CHARTED
from seacruise.desktop.style import scaled_font

_LEFT_PX: Final = 14.0
_ABOVE_PX: Final = 64.0
_MARGIN_PX: Final = 8.0


def is_coarse(to_pixels: QTransform, view: QRectF) -> bool:
    """Whether the middle of a view lies beyond the fine coast."""
    back, _ = to_pixels.inverted()
    return not CHARTED.contains(back.map(view.center()))


class CoarseLayer(Layer):
    """Two lines above the scale, while the view is of elsewhere than the Baltic."""

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Say it on a card, as the legend does."""
        if not is_coarse(to_pixels, view):
            return
        lines = (
            QCoreApplication.translate("coarse", "Coarse coast: no islets, no depths."),
            QCoreApplication.translate("coarse", "Routing sees land to 1 km here."),
        )
        painter.setFont(scaled_font(painter.font(), 0.85))
        height = painter.fontMetrics().height()
        width = max(text_width(painter.font(), line) for line in lines) + 2 * _MARGIN_PX
        tall = len(lines) * height + _MARGIN_PX
        card = QRectF(view.left() + _LEFT_PX, view.bottom() - _ABOVE_PX - tall, width, tall)
        painter.setPen(QPen(self.colours.card_line, 1.0))
        painter.setBrush(self.colours.card)
        painter.drawRoundedRect(card, 6, 6)
        painter.setPen(self.colours.ink)
        base = card.top() + _MARGIN_PX / 2 + painter.fontMetrics().ascent()
        for number, line in enumerate(lines):
            painter.drawText(QPointF(card.left() + _MARGIN_PX, base + number * height), line)
