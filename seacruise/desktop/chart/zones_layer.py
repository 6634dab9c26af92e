"""Areas to keep out of, with their names."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QPainter, QPainterPath, QPen, QTransform

from seacruise.desktop.chart.basemap import polygon_of
from seacruise.desktop.chart.labels import Label
from seacruise.desktop.chart.layer import Layer, text_width
from seacruise.desktop.chart.plane import point, to_plane
from seacruise.desktop.style import scaled_font
from seacruise.sea.zones import Zone, Zones

_LEAST_PX: Final = 3.0
_NAMED_PX: Final = 18.0
_INSIDE: Final = 0.8


@dataclass(frozen=True, slots=True, eq=False)
class _Area:
    """A zone ready to be drawn."""

    zone: Zone
    path: QPainterPath
    box: QRectF


class ZonesLayer(Layer):
    """Hatched areas; fainter while they are open at the slider's time."""

    def __init__(self, bounds: QRectF) -> None:
        super().__init__(bounds)
        self._areas: list[_Area] = []
        self._time = -math.inf

    def show_zones(self, zones: Zones) -> None:
        """Show zones, or none."""
        self._areas = []
        for zone in zones.zones:
            path = QPainterPath()
            for ring in zone.rings:
                path.addPolygon(polygon_of(np.stack(to_plane(ring[:, 1], ring[:, 0]), axis=1)))
            self._areas.append(_Area(zone, path, path.boundingRect()))
        self.update()

    def show_time(self, time: float) -> None:
        """Tell open from closed zones at a time [s since 1970]."""
        before, self._time = self._closed(), time
        if self._closed() != before:
            self.update()

    def _closed(self) -> list[bool]:
        """Tell for each area whether it is closed, at any time while none is known."""
        at = self._time
        return [at == -math.inf or a.zone.valid_from <= at <= a.zone.valid_to for a in self._areas]

    def zones_at(self, lat: float, lon: float) -> list[Zone]:
        """Zones that a position [degrees] lies in, whenever they are closed."""
        at = point(lat, lon)
        return [area.zone for area in self._areas if area.path.contains(at)]

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw the areas in view, and their names where there is room."""
        before = painter.font()
        painter.setFont(scaled_font(before, 0.88))
        for area, closed in zip(self._areas, self._closed(), strict=True):
            box = to_pixels.mapRect(area.box)
            if not box.intersects(view) or max(box.width(), box.height()) < _LEAST_PX:
                continue
            ink = QColor(self.colours.zone)
            ink.setAlpha(210 if closed else 90)
            fill = QColor(self.colours.zone)
            fill.setAlpha(38 if closed else 14)
            painter.setPen(QPen(ink, 1.4, Qt.PenStyle.DashLine))
            path = to_pixels.map(area.path)
            painter.setBrush(fill)
            painter.drawPath(path)
            if closed:
                hatch = QColor(ink)
                hatch.setAlpha(70)
                painter.fillPath(path, QBrush(hatch, Qt.BrushStyle.BDiagPattern))
            self._name(painter, area.zone.name, box.intersected(view))
        painter.setFont(before)

    def _name(self, painter: QPainter, name: str, box: QRectF) -> None:
        """Write a name into the visible part of an area, or else below it."""
        metrics, width = painter.fontMetrics(), text_width(painter.font(), name)
        place = QRectF(box.center().x() - width / 2, box.center().y(), width, metrics.height())
        if box.width() > _INSIDE * width:
            place.moveTop(box.center().y() - metrics.height() / 2)
        elif box.width() > _NAMED_PX:
            place.moveTop(box.bottom() + 2)
        else:
            return
        if self.labels.claim(place) is not None:
            base = QPointF(place.left(), place.top() + metrics.ascent())
            self.labels.write(Label(painter.font(), base, name, self.colours.zone))
