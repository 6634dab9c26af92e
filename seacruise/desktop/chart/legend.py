"""What the colours of the route mean."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QTransform

from seacruise.desktop.chart import palette
from seacruise.desktop.chart.layer import Layer
from seacruise.desktop.style import scaled_font

_SWATCH_PX = 38.0


class LegendLayer(Layer):
    """Swatches with their spans of true wind speed, at the lower right."""

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw the legend on a card of its own."""
        del to_pixels
        painter.setFont(scaled_font(painter.font(), 0.85))
        line = painter.fontMetrics().height()
        count = len(palette.WIND_COLOURS)
        width = count * _SWATCH_PX + 20
        height = 2 * line + 24
        card = QRectF(view.right() - width - 12, view.bottom() - height - 26, width, height)
        painter.setPen(QPen(QColor("#CFDAE3"), 1.0))
        painter.setBrush(QColor(255, 255, 255, 235))
        painter.drawRoundedRect(card, 8, 8)
        painter.setPen(palette.PORT)
        title = QCoreApplication.translate("legend", "Wind on the route (TWS, kn)")
        painter.drawText(QPointF(card.left() + 10, card.top() + line + 2), title)
        top = card.top() + line + 8
        for number, colour in enumerate(palette.WIND_COLOURS):
            swatch = QRectF(card.left() + 10 + number * _SWATCH_PX, top, _SWATCH_PX, 7)
            painter.fillRect(swatch, colour)
            painter.drawText(
                QRectF(swatch.left() - 4, swatch.bottom() + 1, _SWATCH_PX + 8, line + 3),
                Qt.AlignmentFlag.AlignCenter,
                palette.wind_class_name(number),
            )
