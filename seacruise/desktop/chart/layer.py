"""What all layers of the chart share: they cover everything and draw in pixels of the screen."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetricsF,
    QPainter,
    QPen,
    QPixmap,
    QTransform,
)

from seacruise.desktop.chart.labels import Labels
from seacruise.desktop.chart.palette import DAY, Palette

_HALO_PX: Final = 3.0
_AROUND: Final = tuple((1.6 * math.cos(k * math.pi / 4), 1.6 * math.sin(k * math.pi / 4)) for k in range(8))


class Layer:
    """A layer of the chart.

    Drawing in pixels keeps barbs, symbols and text the same size at every zoom. What lies on the chart is
    also drawn into pictures larger than the view (`sheet.Sheet`): a layer draws what ``view`` holds, wherever
    that is, and tells by `update` when it would draw something else.

    Parameters
    ----------
    bounds
        Of the whole chart in the plane [m].

    Attributes
    ----------
    by_strips
        Whether drawing it strip by strip, each clipped, gives the same picture as at once.
    """

    by_strips = False

    def __init__(self, bounds: QRectF) -> None:
        self._bounds = bounds
        self._visible = True
        self._version = 0
        self.colours: Palette = DAY
        self.labels = Labels()
        self.on_update: Callable[[], None] | None = None

    def set_palette(self, colours: Palette) -> None:
        """Draw in the colours of another light from now on."""
        self.colours = colours
        self.update()

    def update(self) -> None:
        """Tell that the layer would draw something else from now on."""
        self._version += 1
        if self.on_update is not None:
            self.on_update()

    @property
    def version(self) -> int:
        """Another number whenever the layer would draw something else; negative while it is hidden."""
        return self._version if self._visible else -1

    def setVisible(self, on: bool) -> None:
        """Show or hide the layer."""
        if on != self._visible:
            self._visible = on
            self.update()

    def isVisible(self) -> bool:
        """Whether the layer is shown."""
        return self._visible

    def prepare(self, to_pixels: QTransform, view: QRectF, density: float) -> bool:
        """Make what drawing needs first, for some milliseconds at most; True once nothing is left of it."""
        del to_pixels, view, density
        return True

    def paint(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw the layer, if it is shown, and leave the painter as it was."""
        if self._visible:
            painter.save()
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            try:
                self.draw(painter, to_pixels, view)
            finally:
                painter.restore()

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw on a viewport or picture of ``view`` pixels; ``to_pixels`` maps the plane to it."""
        raise NotImplementedError


@lru_cache(maxsize=500)
def _text_sprite(text: str, font: str, ink: tuple[int, int], density: float) -> tuple[QPixmap, float]:
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
    painter.setPen(QColor.fromRgba(ink[1]))
    # Stroking the outlines looks the same and takes ten times as long.
    for dx, dy in _AROUND:
        painter.drawText(base + QPointF(dx, dy), text)
    painter.setPen(QColor.fromRgba(ink[0]))
    painter.drawText(base, text)
    painter.end()
    return pixmap, base.y()


def halo_text(painter: QPainter, at: QPointF, text: str, colour: QColor, halo: QColor) -> None:
    """Draw a text with its base line at a point, legible on any ground.

    Sixty names with halos take longer than the rest of a frame, so each is made once.
    """
    density = painter.device().devicePixelRatio()
    sprite, base = _text_sprite(text, painter.font().key(), (colour.rgba(), halo.rgba()), density)
    painter.drawPixmap(QPointF(round(at.x() - _HALO_PX), round(at.y() - base)), sprite)


def text_width(font: QFont, text: str) -> float:
    """Width of a text [pixels]."""
    return _text_width(font.key(), text)


@lru_cache(maxsize=1500)
def _text_width(font: str, text: str) -> float:
    face = QFont()
    face.fromString(font)
    return QFontMetricsF(face).horizontalAdvance(text)


@lru_cache(maxsize=64)
def _dot_sprite(radius: float, ink: tuple[int, int], density: float) -> QPixmap:
    """Picture of a dot of a colour with a rim."""
    side = math.ceil(2 * radius) + 6
    pixmap = QPixmap(QSize(side, side) * density)
    pixmap.setDevicePixelRatio(density)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(QColor.fromRgba(ink[1]), 1.5))
    painter.setBrush(QColor.fromRgba(ink[0]))
    painter.drawEllipse(QPointF(side / 2, side / 2), radius, radius)
    painter.end()
    return pixmap


def draw_dot(painter: QPainter, at: QPointF, radius: float, colour: QColor, rim: QColor) -> None:
    """Draw a dot, from a picture that is made once."""
    density = painter.device().devicePixelRatio()
    sprite = _dot_sprite(radius, (colour.rgba(), rim.rgba()), density)
    half = sprite.width() / density / 2
    painter.drawPixmap(QPointF(round(at.x() - half), round(at.y() - half)), sprite)


@dataclass(frozen=True, slots=True)
class NamedDot:
    """Picture of a dot with its name beside it.

    Attributes
    ----------
    left, top
        From the dot's middle to the picture's edges [pixels].
    name
        Place of the name as left, top, right and bottom, seen from the dot's middle.
    """

    picture: QPixmap
    left: float
    top: float
    name: tuple[float, float, float, float]


@lru_cache(maxsize=500)
def named_dot(
    name: str, font: str, inks: tuple[int, int, int], density: float, *, to_left: bool, radius: float
) -> NamedDot:
    """Make a dot with its name to the right or to the left.

    Parameters
    ----------
    inks
        Of dot and name, of the dot's rim, and of the halo.
    """
    text, _base = _text_sprite(name, font, (inks[0], inks[2]), density)
    dot = _dot_sprite(radius, inks[:2], density)
    width, height = text.width() / density, text.height() / density
    side, gap = dot.width() / density, radius + 4.0
    reach, half = side / 2, max(height, side) / 2
    total = reach + gap + width
    middle = total - reach if to_left else reach
    picture = QPixmap(math.ceil(total * density) + 1, math.ceil(2 * half * density) + 1)
    picture.setDevicePixelRatio(density)
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    painter.drawPixmap(QPointF(round(middle - reach), round(half - reach)), dot)
    begin = middle - gap - width + _HALO_PX if to_left else middle + gap - _HALO_PX
    painter.drawPixmap(QPointF(round(begin), round(half - height / 2)), text)
    painter.end()
    edge = begin - middle + _HALO_PX
    tall = height / 2 - _HALO_PX
    return NamedDot(picture, middle, half, (edge, -tall, edge + width - 2 * _HALO_PX, tall))


class LabelLayer(Layer):
    """Draws what other layers have written, above barbs and route."""

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw all of it."""
        del to_pixels, view
        before = painter.font()
        for label in self.labels.written:
            painter.setFont(label.font)
            halo_text(painter, label.base, label.text, label.ink, self.colours.halo)
        painter.setFont(before)
