"""What is shown while the chart moves: one picture of all that lies on it, larger than the view.

Drawing every layer takes most of a frame; moving or stretching a picture of them does not. Sheets are painted
in parts between two frames, so that no frame waits for a whole one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import QFont, QPainter, QPixmap, QTransform

from seacruise.desktop.chart.labels import Labels
from seacruise.desktop.chart.layer import Layer

_STRIP_PIXELS: Final = 700_000
_WHOLE_AT: Final = 20
"""So many rows are a whole number of the screen's own, whether it is scaled by 125, 150 or 110 %."""

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
    """Paints one sheet, a few milliseconds at each step.

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
        self._room = QRectF(QPointF(), sheet.size)
        self._labels = Labels()
        self._labels.begin(self._room)
        reserve(self._labels, font, sheet.to_pixels)
        self._done: set[Layer] = set()
        self._steps = self._paint(layers)

    def step(self) -> bool:
        """Paint a part; True when nothing is left."""
        return next(self._steps, None) is None

    def has(self, layers: Sequence[Layer]) -> bool:
        """Whether all of some layers are on the sheet."""
        return self._done.issuperset(layers)

    def _paint(self, layers: Sequence[Layer]) -> Iterator[bool]:
        sheet = self.sheet
        for layer in (one for one in layers if one.isVisible()):
            while not layer.prepare(sheet.to_pixels, self._room, sheet.picture.devicePixelRatio()):
                yield True
            for strip in _strips(sheet) if layer.by_strips else (self._room,):
                self._paint_layer(layer, strip)
                yield True
            self._done.add(layer)

    def _paint_layer(self, layer: Layer, strip: QRectF) -> None:
        painter = QPainter(self.sheet.picture)
        painter.setFont(self._font)
        painter.setClipRect(strip)
        kept, layer.labels = layer.labels, self._labels
        try:
            layer.paint(painter, self.sheet.to_pixels, self._room)
        finally:
            layer.labels = kept
            painter.end()


def _strips(sheet: Sheet) -> list[QRectF]:
    """Cut a sheet into strips of so many pixels as are painted in a step, new memory included."""
    width, height, density = sheet.size.width(), sheet.size.height(), sheet.picture.devicePixelRatio()
    rows = _WHOLE_AT * math.ceil(_STRIP_PIXELS / (width * density**2) / _WHOLE_AT)
    if not (_WHOLE_AT * density).is_integer():
        # Where a strip ended within a row of the screen, that row would be painted twice, or not at all.
        return [QRectF(0.0, 0.0, width, height)]
    edges = [*range(0, math.floor(height), rows), height]
    return [QRectF(0.0, top, width, bottom - top) for top, bottom in pairwise(edges)]


class Group:
    """Layers that are painted together: from a picture, once they stay as they are.

    Parameters
    ----------
    opaque
        They cover everything.
    """

    def __init__(self, layers: Sequence[Layer], *, opaque: bool) -> None:
        self._layers, self._opaque = layers, opaque
        self._state: State = ()
        self._picture: QPixmap | None = None
        self._is_painted = False

    def forget(self) -> None:
        """Paint them anew in the next frame."""
        self._state, self._is_painted = (), False

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
            self._state, self._is_painted = state, False
        elif not self._is_painted and keep:
            self._paint_picture(painter, to_pixels, room)
        if self._picture is not None and self._is_painted:
            painter.drawPixmap(0, 0, self._picture)
            return
        for layer in self._layers:
            layer.paint(painter, to_pixels, room)

    def _paint_picture(self, like: QPainter, to_pixels: QTransform, room: QRectF) -> None:
        self._picture = picture = blank(room.size(), like.device().devicePixelRatio(), self._picture)
        if not self._opaque:
            picture.fill(Qt.GlobalColor.transparent)
        painter = QPainter(picture)
        painter.setFont(like.font())
        for layer in self._layers:
            layer.paint(painter, to_pixels, room)
        painter.end()
        self._is_painted = True


def blank(size: QSizeF, density: float, used: QPixmap | None = None) -> QPixmap:
    """Picture to be painted on, not cleared.

    Parameters
    ----------
    used
        One that is not needed any more; it is taken if it fits, for to touch new memory for the first time
        takes longer than to paint on it.
    """
    pixels = (size * density).toSize().expandedTo(QSize(1, 1))
    if used is not None and used.size() == pixels and used.devicePixelRatio() == density:
        return used
    picture = QPixmap(pixels)
    picture.setDevicePixelRatio(density)
    return picture
