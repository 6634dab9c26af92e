"""Parallels and meridians with their labels, and the scale in nautical miles."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np
from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QFont, QFontMetricsF, QPainter, QPen, QTransform

from seacruise.desktop.chart.layer import Layer, halo_text, text_width
from seacruise.desktop.chart.plane import position, to_plane
from seacruise.desktop.language import fill
from seacruise.geodesy import scale as true_scale
from seacruise.units import METRES_PER_NM

_STEPS_MIN: Final = (3600, 1800, 1200, 600, 300, 120, 60, 30, 20, 10, 5, 2, 1)
_LEAST_PX: Final = 110.0
_SCALES_NM: Final = (2000.0, 1000.0, 500.0, 200.0, 100.0, 50.0, 20.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1)
_LONGEST_PX: Final = 150.0


def step_minutes(pixels_per_degree: float) -> int:
    """Finest step of the graticule [minutes of arc] that keeps its lines apart."""
    fitting = [step for step in _STEPS_MIN if step / 60.0 * pixels_per_degree >= _LEAST_PX]
    return fitting[-1] if fitting else _STEPS_MIN[0]


def angle_label(minutes: int, positive: str, negative: str) -> str:
    """Degrees, and minutes where they are not zero: ``57°30'N``."""
    degrees, rest = divmod(abs(minutes), 60)
    letter = "" if minutes == 0 else positive if minutes > 0 else negative
    return f"{degrees}°{f'{rest:02d}′' if rest else ''}{letter}"


@dataclass(frozen=True, slots=True)
class _Grid:
    """Minutes of arc of meridians and parallels in a view, and where they are [pixels]."""

    meridians: list[tuple[int, float]]
    parallels: list[tuple[int, float]]

    @classmethod
    def of(cls, to_pixels: QTransform, view: QRectF) -> _Grid:
        """Choose a step that suits the zoom."""
        back, _ = to_pixels.inverted()
        north, west = position(back.map(view.topLeft()))
        south, east = position(back.map(view.bottomRight()))
        step = step_minutes(view.width() / max(east - west, 1e-9))
        meridians = np.arange(math.ceil(west * 60 / step) * step, math.floor(east * 60) + 1, step)
        parallels = np.arange(math.ceil(south * 60 / step) * step, math.floor(north * 60) + 1, step)
        x = to_pixels.m11() * to_plane(np.zeros(1), meridians / 60)[0] + to_pixels.dx()
        y = to_pixels.m22() * to_plane(parallels / 60, np.zeros(1))[1] + to_pixels.dy()
        return cls(
            list(zip(meridians.tolist(), np.rint(x).tolist(), strict=True)),
            list(zip(parallels.tolist(), np.rint(y).tolist(), strict=True)),
        )


class GraticuleLayer(Layer):
    """Thin lines over sea and land."""

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw parallels and meridians of a step that suits the zoom."""
        grid, ink = _Grid.of(to_pixels, view), self.colours.graticule
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, on=False)
        # Ten times as fast as a line with a pen.
        for _, x in grid.meridians:
            painter.fillRect(QRectF(x, view.top(), 1.0, view.height()), ink)
        for _, y in grid.parallels:
            painter.fillRect(QRectF(view.left(), y, view.width(), 1.0), ink)


class DegreesLayer(Layer):
    """Degrees of the graticule's lines, at the left and the lower edge of the view."""

    def __init__(self, bounds: QRectF) -> None:
        super().__init__(bounds)
        self._shown: list[tuple[QPointF, str]] = []

    def reserve(self, font: QFont, to_pixels: QTransform, view: QRectF) -> None:
        """Take places for the frame to come, before anything else is written."""
        grid, height = _Grid.of(to_pixels, view), QFontMetricsF(font).height()
        places = [
            (QPointF(x + 4, view.bottom() - 6), angle_label(minutes, "E", "W"))
            for minutes, x in grid.meridians
        ]
        places += [
            (QPointF(view.left() + 6, y - 4), angle_label(minutes, "N", "S"))
            for minutes, y in grid.parallels
            if view.top() + 14 < y < view.bottom() - 24
        ]
        self._shown = []
        for at, text in places:
            # Its base line is at the point.
            room = QRectF(at.x(), at.y() - 0.75 * height, text_width(font, text), 0.85 * height)
            if self.labels.claim(room) is not None:
                self._shown.append((at, text))

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Write them."""
        del to_pixels, view
        for at, text in self._shown:
            halo_text(painter, at, text, self.colours.graticule_text, self.colours.halo)


def scale_bar(pixels_per_metre: float, lat: float) -> tuple[float, float]:
    """Length of the scale bar: nautical miles, and pixels, at a latitude [degrees]."""
    pixels_per_nm = pixels_per_metre * METRES_PER_NM / float(true_scale(lat))
    for miles in _SCALES_NM:
        if miles * pixels_per_nm <= _LONGEST_PX:
            return miles, miles * pixels_per_nm
    return _SCALES_NM[-1], _SCALES_NM[-1] * pixels_per_nm


def scale_label(miles: float) -> str:
    """Text beside the scale bar."""
    return fill(QCoreApplication.translate("chart", "{miles:g} nm"), miles=miles)


class ScaleLayer(Layer):
    """A bar of a round number of miles, true at the middle of the view."""

    @staticmethod
    def place(view: QRectF) -> QRectF:
        """Where the bar and its text are."""
        return QRectF(view.left(), view.bottom() - 56.0, _LONGEST_PX + 32.0, 36.0)

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw the bar at the lower left."""
        back, _ = to_pixels.inverted()
        lat, _lon = position(back.map(view.center()))
        miles, length = scale_bar(to_pixels.m11(), lat)
        left, base = view.left() + 16.0, view.bottom() - 30.0
        half = length / 2
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(self.colours.card)
        painter.drawRoundedRect(QRectF(left - 8, base - 22, length + 16, 30), 6, 6)
        painter.setPen(QPen(self.colours.ink, 3.0))
        painter.drawLine(QPointF(left, base), QPointF(left + half, base))
        painter.setPen(QPen(self.colours.graticule_text, 3.0))
        painter.drawLine(QPointF(left + half, base), QPointF(left + length, base))
        text = scale_label(miles)
        x = left + half - text_width(painter.font(), text) / 2
        halo_text(painter, QPointF(x, base - 7), text, self.colours.ink, self.colours.halo)
