"""Other ways than the passage, faint under it, each with its name and what it takes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF, QTransform

from seacruise.desktop.chart.basemap import polygon_of
from seacruise.desktop.chart.labels import Label, around
from seacruise.desktop.chart.layer import Layer, text_width
from seacruise.desktop.chart.plane import point, to_plane
from seacruise.desktop.style import scaled_font

if TYPE_CHECKING:
    from seacruise.desktop.alternatives import Way
    from seacruise.desktop.chart.route_layer import RouteLayer

_PICK_PX: Final = 7.0
_WIDE_PX: Final = 4.6
_ALPHA: Final = 165
_APART_PX: Final = 9.0
_SHARES: Final = (0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8)
"""Where along a way its name is tried after the place that suits it best."""


class OthersLayer(Layer):
    """Lines of other ways, dashed where the passage's is whole.

    Parameters
    ----------
    route
        The passage, which no name may cover.
    """

    def __init__(self, bounds: QRectF, route: RouteLayer) -> None:
        super().__init__(bounds)
        self._route = route
        self.ways: tuple[Way, ...] = ()
        self._sides: tuple[Way, ...] = ()
        self._turns: tuple[Way, ...] = ()
        self._compared: tuple[Way, ...] = ()
        self._planes: list[NDArray[np.float64]] = []
        self._lines: list[QPolygonF] = []
        self._places: list[QPointF] = []

    def show_ways(self, ways: Sequence[Way]) -> None:
        """Show ways past islands, or none."""
        self._sides = tuple(ways)
        self._show()

    def show_turns(self, ways: Sequence[Way]) -> None:
        """Show ways with fewer turns, or none."""
        self._turns = tuple(ways)
        self._show()

    def compare(self, way: Way | None) -> None:
        """Show the way of another departure besides, or none."""
        self._compared = () if way is None else (way,)
        self._show()

    def _show(self) -> None:
        ways = (*self._compared, *self._sides, *self._turns)
        if ways == self.ways:
            return
        self.ways = ways
        self._planes = [np.stack(to_plane(way.line[:, 0], way.line[:, 1]), axis=1) for way in self.ways]
        self._lines = [polygon_of(plane) for plane in self._planes]
        self._places = [point(*way.place) for way in self.ways]
        self.update()

    def way_at(self, at: QPointF, to_pixels: QTransform) -> Way | None:
        """Way whose line passes under a point [pixels]; the faster of two."""
        if not self.isVisible():
            return None
        origin = np.array([at.x() - to_pixels.dx(), at.y() - to_pixels.dy()])
        for way, plane in zip(self.ways, self._planes, strict=True):
            points = plane * to_pixels.m11() - origin
            a, step = points[:-1], np.diff(points, axis=0)
            length = np.maximum((step**2).sum(axis=1), 1e-9)
            share = np.clip(-(a * step).sum(axis=1) / length, 0.0, 1.0)
            if np.hypot(*(a + share[:, None] * step).T).min() <= _PICK_PX:
                return way
        return None

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw the slower ways first, and name the faster first."""
        del view
        if not self.ways:
            return
        ink, rim = QColor(self.colours.keel), QColor(self.colours.casing)
        ink.setAlpha(_ALPHA)
        rim.setAlpha(_ALPHA)
        dashes = QPen(ink, 2.0, Qt.PenStyle.CustomDashLine)
        dashes.setDashPattern([6.0, 2.5])
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for line in reversed(self._lines):
            for pen in (QPen(rim, _WIDE_PX), dashes):
                painter.setPen(pen)
                painter.drawPolyline(to_pixels.map(line))
        painter.setFont(scaled_font(painter.font(), 0.9))
        for way, plane, place in zip(self.ways, self._planes, self._places, strict=True):
            along = [QPointF(*plane[round(share * (len(plane) - 1))]) for share in _SHARES]
            self._name(painter, way.label, [to_pixels.map(at) for at in (place, *along)], to_pixels)

    def _name(self, painter: QPainter, text: str, along: Sequence[QPointF], to_pixels: QTransform) -> None:
        """Write a name at the first of some points of a way that has room and is not of the passage, too."""
        size = (text_width(painter.font(), text), float(painter.fontMetrics().height()))
        for at in along:
            if self._route.touches(
                QRectF(at.x() - _APART_PX, at.y() - _APART_PX, 2 * _APART_PX, 2 * _APART_PX), to_pixels
            ):
                continue
            places = around(at, *size, 8.0)
            place = self.labels.claim(*(one for one in places if not self._route.touches(one, to_pixels)))
            if place is not None:
                base = QPointF(place.left(), place.top() + painter.fontMetrics().ascent())
                self.labels.write(Label(painter.font(), base, text, self.colours.ink))
                return
