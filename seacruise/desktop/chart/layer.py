"""What all layers of the chart share: they cover everything and draw in pixels of the screen."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetricsF,
    QPainter,
    QPixmap,
    QTransform,
)
from PySide6.QtWidgets import QGraphicsItem, QStyleOptionGraphicsItem, QWidget

from seacruise.desktop.chart import palette

_HALO_PX: Final = 3.0
_AROUND: Final = tuple((1.6 * math.cos(k * math.pi / 4), 1.6 * math.sin(k * math.pi / 4)) for k in range(8))


class Layer(QGraphicsItem):
    """A layer of the chart.

    Drawing in pixels keeps barbs, symbols and text the same size at every zoom, and whole layers cost
    one item each: fifty thousand items would take 146 ms a frame.
    """

    def __init__(self, bounds: QRectF) -> None:
        super().__init__()
        self._bounds = bounds

    def boundingRect(self) -> QRectF:
        """Whole chart."""
        return self._bounds

    def paint(
        self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: QWidget | None = None
    ) -> None:
        """Draw the layer in pixels of the viewport."""
        del option
        if widget is None:
            return
        painter.save()
        to_pixels = painter.worldTransform()
        painter.resetTransform()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self.draw(painter, to_pixels, QRectF(widget.rect()))
        painter.restore()

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw on a viewport of ``view`` pixels; ``to_pixels`` maps the plane to it."""
        # Qt's metaclass leaves no room for ABC's: a layer that forgets to draw must fail at its first frame.
        raise NotImplementedError


@lru_cache(maxsize=1500)
def _text_sprite(text: str, font: str, colour: int, density: float) -> tuple[QPixmap, float]:
    """Picture of a text with its halo, and from its top to the base line [pixels]."""
    face = QFont()
    face.fromString(font)
    metrics = QFontMetricsF(face)
    base = QPointF(_HALO_PX, metrics.ascent() + _HALO_PX)
    size = QSizeF(metrics.horizontalAdvance(text) + 2 * _HALO_PX, metrics.height() + 2 * _HALO_PX)
    pixmap = QPixmap((size * density).toSize() + QSize(1, 1))
    pixmap.setDevicePixelRatio(density)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setFont(face)
    painter.setPen(palette.HALO)
    # Stroking the outlines looks the same and takes ten times as long.
    for dx, dy in _AROUND:
        painter.drawText(base + QPointF(dx, dy), text)
    painter.setPen(QColor.fromRgba(colour))
    painter.drawText(base, text)
    painter.end()
    return pixmap, base.y()


def halo_text(painter: QPainter, x: float, y: float, text: str, colour: QColor) -> None:
    """Draw a text with its base line at a point, legible on any ground.

    Sixty names with halos take longer than the rest of a frame, so each is made once.
    """
    density = painter.device().devicePixelRatio()
    sprite, base = _text_sprite(text, painter.font().toString(), colour.rgba(), density)
    painter.drawPixmap(QPointF(round(x - _HALO_PX), round(y - base)), sprite)


def text_width(font: QFont, text: str) -> float:
    """Width of a text [pixels]."""
    return QFontMetricsF(font).horizontalAdvance(text)
