"""Lines of equal time on the chart."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np
from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen, QPolygonF, QTransform

from seacruise.desktop.chart.basemap import polygon_of
from seacruise.desktop.chart.labels import Label, around
from seacruise.desktop.chart.layer import Layer, text_width
from seacruise.desktop.chart.plane import to_plane
from seacruise.desktop.language import fill
from seacruise.desktop.style import scaled_font

if TYPE_CHECKING:
    from seacruise.desktop.chart.route_layer import RouteLayer
    from seacruise.desktop.equal_time import TimeLine

_TRIES: Final = 9


class IsochroneLayer(Layer):
    """Lines, each with its hours where there is room for them.

    Parameters
    ----------
    route
        The passage, which no hours may cover.
    """

    def __init__(self, bounds: QRectF, route: RouteLayer) -> None:
        super().__init__(bounds)
        self._route = route
        self._lines: list[tuple[str, list[QPolygonF]]] = []

    def show_lines(self, lines: Sequence[TimeLine]) -> None:
        """Show lines, or none."""
        self._lines = []
        for line in lines:
            pieces = [
                polygon_of(np.stack(to_plane(piece[:, 0], piece[:, 1]), axis=1)) for piece in line.pieces
            ]
            text = fill(QCoreApplication.translate("isochrones", "{hours:g} h"), hours=line.hours)
            self._lines.append((text, sorted(pieces, key=lambda piece: -piece.size())))
        self.update()

    @property
    def count(self) -> int:
        """How many lines there are."""
        return len(self._lines)

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw those lines that are in view."""
        if not self._lines:
            return
        # Not a hair wider: lines of one pixel are drawn twenty times as fast.
        pen = QPen(self.colours.isochrone, 1.0)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        before = painter.font()
        painter.setFont(scaled_font(before, 0.88, bold=True))
        for text, pieces in self._lines:
            shown = [
                line
                for piece in pieces
                if (line := to_pixels.map(piece)).boundingRect().adjusted(-1, -1, 1, 1).intersects(view)
            ]
            painter.setPen(pen)
            for line in shown:
                painter.drawPolyline(line)
            if shown:
                self._label(painter, shown[0], text, to_pixels)
        painter.setFont(before)

    def _label(self, painter: QPainter, line: QPolygonF, text: str, to_pixels: QTransform) -> None:
        """Write the hours beside a line, at the first of some places along it that is free."""
        count, size = line.size(), (text_width(painter.font(), text), float(painter.fontMetrics().height()))
        for number in range(_TRIES):
            at = line.at(round((0.5 + (-1) ** number * number / 2 / _TRIES) * (count - 1)))
            places = around(at, *size, 4.0)
            place = self.labels.claim(*(one for one in places if not self._route.touches(one, to_pixels)))
            if place is not None:
                base = QPointF(place.left(), place.top() + painter.fontMetrics().ascent())
                self.labels.write(Label(painter.font(), base, text, self.colours.isochrone))
                return
