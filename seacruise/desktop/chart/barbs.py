"""Wind barbs after the rules of the WMO.

The shaft points to where the wind comes FROM. A half feather is 5 knots, a full one 10, a pennant 50; a
circle is a calm. Feathers stand on the side of low pressure: clockwise of the shaft on the northern
hemisphere, anticlockwise on the southern (Manual on the GDPFS, WMO-No. 485, appendix II-4).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QPixmap, QPolygonF, QRegion

SHAFT_PX: Final = 30.0
_FEATHER_PX: Final = 11.0
_SLANT_PX: Final = 4.0
_STEP_PX: Final = 4.6
_PENNANT_PX: Final = 6.5
_SIDE_PX: Final = 96
_DIRECTIONS: Final = 72


@dataclass(frozen=True, slots=True)
class Barb:
    """A barb for wind from north, station at the origin, y downwards [pixels]."""

    lines: tuple[tuple[float, float, float, float], ...]
    pennants: tuple[tuple[tuple[float, float], tuple[float, float], tuple[float, float]], ...]
    calm: bool


def barb_counts(speed_kn: float) -> tuple[int, int, int]:
    """Pennants, full and half feathers of a speed [kn], rounded to the nearest five."""
    rest = int(speed_kn / 5.0 + 0.5)
    pennants, rest = divmod(rest, 10)
    full, half = divmod(rest, 2)
    return pennants, full, half


@lru_cache(maxsize=64)
def make_barb(fives: int, side: int = 1) -> Barb:
    """Geometry of a barb.

    Parameters
    ----------
    fives
        Speed in units of five knots.
    side
        1 on the northern hemisphere, -1 on the southern.
    """
    pennants, full, half = barb_counts(5.0 * fives)
    if not fives:
        return Barb((), (), calm=True)
    lines = [(0.0, 0.0, 0.0, -SHAFT_PX)]
    triangles = []
    y = -SHAFT_PX
    for _ in range(pennants):
        triangles.append(((0.0, y), (side * _FEATHER_PX, y), (0.0, y + _PENNANT_PX)))
        y += _PENNANT_PX
    if pennants:
        y += _STEP_PX / 2
    for _ in range(full):
        lines.append((0.0, y, side * _FEATHER_PX, y - _SLANT_PX))
        y += _STEP_PX
    if half:
        if not pennants and not full:
            # A single half feather at the tip would be taken for a full one of a bent shaft.
            y += _STEP_PX
        lines.append((0.0, y, side * _FEATHER_PX / 2, y - _SLANT_PX / 2))
    return Barb(tuple(lines), tuple(triangles), calm=False)


def direction_classes(direction_from_deg: NDArray[np.float64]) -> NDArray[np.int64]:
    """Numbers of the sprites for directions [degrees true]; every five degrees there is one."""
    return np.rint(direction_from_deg / 360.0 * _DIRECTIONS).astype(np.int64) % _DIRECTIONS


class BarbSprites:
    """Ready-made pictures of barbs: three hundred of them are on the chart in a millisecond.

    Parameters
    ----------
    colour, halo
        Of the strokes, and of the light rim that keeps them legible on any ground.
    opacity
        Of the pictures, 0 to 1.
    """

    def __init__(self, colour: QColor, halo: QColor, opacity: float = 1.0) -> None:
        self._colour = colour
        self._halo = halo
        self._opacity = opacity
        self._sprites: dict[tuple[int, int, int, float], tuple[QPixmap, float, float]] = {}

    def sprite(
        self, fives: int, direction: int, *, side: int, density: float
    ) -> tuple[QPixmap, float, float]:
        """Picture, and from its left and upper edge to the station [pixels]."""
        # A calm has no direction; its circle, turned, would be another by a hair.
        direction = direction if fives else 0
        key = (fives, direction, side, density)
        if (known := self._sprites.get(key)) is not None:
            return known
        pixmap = QPixmap(QSize(_SIDE_PX, _SIDE_PX) * density)
        pixmap.setDevicePixelRatio(density)
        pixmap.fill(Qt.GlobalColor.transparent)
        painter = QPainter(pixmap)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.translate(_SIDE_PX / 2, _SIDE_PX / 2)
        painter.rotate(direction * 360.0 / _DIRECTIONS)
        for colour, width in ((self._halo, 3.4), (self._colour, 1.5)):
            _stroke(painter, fives, side, colour, width)
        painter.end()
        # Blending what is empty would take most of the time of the layer.
        box = QRegion(pixmap.mask()).boundingRect()
        cut = _faded(pixmap.copy(box), self._opacity)
        cut.setDevicePixelRatio(density)
        middle = _SIDE_PX / 2
        made = self._sprites[key] = (cut, middle - box.left() / density, middle - box.top() / density)
        return made


@lru_cache(maxsize=8)
def barb_sprites(colour: int, halo: int, opacity: float = 1.0) -> BarbSprites:
    """Pictures in some colours (``0xAARRGGBB``), kept for when a light is put on again."""
    return BarbSprites(QColor.fromRgba(colour), QColor.fromRgba(halo), opacity)


def _faded(picture: QPixmap, opacity: float) -> QPixmap:
    """Fade a picture as a whole: strokes drawn faintly would be darker where they cross."""
    if opacity < 1.0:
        painter = QPainter(picture)
        painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_DestinationIn)
        painter.fillRect(picture.rect(), QColor(0, 0, 0, round(255 * opacity)))
        painter.end()
    return picture


@lru_cache(maxsize=64)
def _lines(fives: int, side: int) -> QPainterPath:
    """Lines of a barb in one path, which is drawn in two thirds of the time that they take."""
    path = QPainterPath()
    for x1, y1, x2, y2 in make_barb(fives, side).lines:
        path.moveTo(x1, y1)
        path.lineTo(x2, y2)
    return path


def _stroke(painter: QPainter, fives: int, side: int, colour: QColor, width: float) -> None:
    barb = make_barb(fives, side)
    pen = QPen(colour, width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap, Qt.PenJoinStyle.RoundJoin)
    painter.setPen(pen)
    if barb.calm:
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawEllipse(QPointF(0, 0), 4.0, 4.0)
        return
    painter.strokePath(_lines(fives, side), pen)
    painter.setBrush(colour)
    for triangle in barb.pennants:
        painter.drawPolygon(QPolygonF([QPointF(*corner) for corner in triangle]))
    painter.drawEllipse(QPointF(0, 0), 0.8, 0.8)
