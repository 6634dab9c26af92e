"""What is shown while the chart moves: one picture of all that lies on it, larger than the view.

Drawing every layer takes most of a frame; moving or stretching a picture of them does not. Sheets are painted
one layer at a time between two frames, so that no frame waits for a whole one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import QFont, QPainter, QPixmap, QTransform

from seacruise.desktop.chart.labels import Labels
from seacruise.desktop.chart.layer import Layer

State = tuple[float, ...]
"""Versions of some layers, and the density of the screen: equal when a picture of them would be the same."""


@dataclass(frozen=True, slots=True, eq=False)
class Sheet:
    """A picture of layers.

    Attributes
    ----------
    to_pixels
        Maps the plane to the picture.
    size
        Of the picture in pixels independent of the screen's density.
    ground, lying
        State of the layers that changed least and of the others when it was painted.
    """

    picture: QPixmap
    to_pixels: QTransform
    size: QSizeF
    ground: State
    lying: State

    def stretch(self, to_pixels: QTransform) -> float:
        """How many times as large as it was painted it must be drawn on a viewport."""
        return to_pixels.m11() / self.to_pixels.m11()

    def place(self, to_pixels: QTransform) -> QRectF:
        """Where it lies on a viewport."""
        times = self.stretch(to_pixels)
        corner = QPointF(
            to_pixels.dx() - times * self.to_pixels.dx(), to_pixels.dy() - times * self.to_pixels.dy()
        )
        return QRectF(corner, self.size * times)

    def draw(self, painter: QPainter, to_pixels: QTransform) -> None:
        """Draw it where it belongs."""
        place = self.place(to_pixels)
        if abs(self.stretch(to_pixels) - 1.0) < 1e-9:
            painter.drawPixmap(QPointF(round(place.left()), round(place.top())), self.picture)
            return
        # Not smoothly: that takes four times as long, of all cores, and the sharp frame comes at once.
        painter.drawPixmap(place, self.picture, QRectF(self.picture.rect()))


class SheetPainter:
    """Paints one sheet, a layer at each step.

    Parameters
    ----------
    sheet
        With a picture of the right size, to be painted on.
    reserve
        Takes the places for what is written first; called with the labels, the font and the transform.
    """

    def __init__(
        self,
        sheet: Sheet,
        layers: Sequence[Layer],
        font: QFont,
        reserve: Callable[[Labels, QFont, QTransform], None],
    ) -> None:
        self.sheet = sheet
        self._font = font
        self._left = list(layers)
        self._labels = Labels()
        self._labels.begin(QRectF(QPointF(), sheet.size))
        reserve(self._labels, font, sheet.to_pixels)

    def step(self) -> bool:
        """Paint the next layer; True when it was the last."""
        layer = self._left.pop(0)
        painter = QPainter(self.sheet.picture)
        painter.setFont(self._font)
        kept, layer.labels = layer.labels, self._labels
        try:
            layer.paint(painter, self.sheet.to_pixels, QRectF(QPointF(), self.sheet.size))
        finally:
            layer.labels = kept
            painter.end()
        return not self._left


class Group:
    """Layers that are painted together: from a picture, once they stay as they are.

    Parameters
    ----------
    opaque
        They cover everything.
    """

    def __init__(self, layers: Sequence[Layer], *, opaque: bool) -> None:
        self._layers, self._opaque = layers, opaque
        self.forget()

    def forget(self) -> None:
        """Paint them anew in the next frame."""
        self._state: State = ()
        self._picture: QPixmap | None = None

    def paint(
        self, painter: QPainter, to_pixels: QTransform, room: QRectF, *, state: State, keep: bool
    ) -> None:
        """Paint them.

        Parameters
        ----------
        state
            Of layers and view; the picture is good for this one only.
        keep
            Whether a picture is worth its making: the state may be the same in the next frame.
        """
        if state != self._state:
            self._state, self._picture = state, None
        elif self._picture is None and keep:
            self._picture = self._pictured(painter, to_pixels, room)
        if self._picture is not None:
            painter.drawPixmap(0, 0, self._picture)
            return
        for layer in self._layers:
            layer.paint(painter, to_pixels, room)

    def _pictured(self, like: QPainter, to_pixels: QTransform, room: QRectF) -> QPixmap:
        picture = blank(room.size(), like.device().devicePixelRatio())
        if not self._opaque:
            picture.fill(Qt.GlobalColor.transparent)
        painter = QPainter(picture)
        painter.setFont(like.font())
        for layer in self._layers:
            layer.paint(painter, to_pixels, room)
        painter.end()
        return picture


def blank(size: QSizeF, density: float) -> QPixmap:
    """Picture to be painted on, not cleared."""
    picture = QPixmap((size * density).toSize().expandedTo(QSize(1, 1)))
    picture.setDevicePixelRatio(density)
    return picture
