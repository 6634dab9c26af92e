"""Parallels and meridians with their labels, and the scale in nautical miles."""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QPainter, QPen, QTransform

from seacruise.desktop.chart.labels import Label
from seacruise.desktop.chart.layer import Layer, halo_text, text_width
from seacruise.desktop.chart.plane import position, to_plane
from seacruise.geodesy import scale as true_scale
from seacruise.units import METRES_PER_NM

_STEPS_MIN: Final = (600, 300, 120, 60, 30, 20, 10, 5, 2, 1)
_LEAST_PX: Final = 110.0
_SCALES_NM: Final = (200.0, 100.0, 50.0, 20.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1)
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


class GraticuleLayer(Layer):
    """Thin lines over sea and land; labels at the left and the lower edge."""

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw parallels and meridians of a step that suits the zoom."""
        back, _ = to_pixels.inverted()
        north, west = position(back.map(view.topLeft()))
        south, east = position(back.map(view.bottomRight()))
        per_degree = view.width() / max(east - west, 1e-9)
        step = step_minutes(per_degree)
        lines, labels = [], []
        meridians = np.arange(math.ceil(west * 60 / step) * step, math.floor(east * 60) + 1, step)
        parallels = np.arange(math.ceil(south * 60 / step) * step, math.floor(north * 60) + 1, step)
        x = to_pixels.m11() * to_plane(np.zeros(1), meridians / 60)[0] + to_pixels.dx()
        y = to_pixels.m22() * to_plane(parallels / 60, np.zeros(1))[1] + to_pixels.dy()
        for minutes, at in zip(meridians.tolist(), np.rint(x).tolist(), strict=True):
            lines.append(QRectF(at, view.top(), 1.0, view.height()))
            labels.append((QPointF(at + 4, view.bottom() - 6), angle_label(minutes, "E", "W")))
        for minutes, at in zip(parallels.tolist(), np.rint(y).tolist(), strict=True):
            lines.append(QRectF(view.left(), at, view.width(), 1.0))
            if view.top() + 14 < at < view.bottom() - 24:
                labels.append((QPointF(view.left() + 6, at - 4), angle_label(minutes, "N", "S")))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, on=False)
        for line in lines:
            # Ten times as fast as a line with a pen.
            painter.fillRect(line, self.colours.graticule)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        height = float(painter.fontMetrics().height())
        for at, text in labels:
            width = text_width(painter.font(), text)
            # Its base line is at the point.
            if self.labels.claim(QRectF(at.x(), at.y() - 0.75 * height, width, 0.85 * height)) is None:
                continue
            self.labels.write(Label(painter.font(), at, text, self.colours.graticule_text))


def scale_bar(pixels_per_metre: float, lat: float) -> tuple[float, float]:
    """Length of the scale bar: nautical miles, and pixels, at a latitude [degrees]."""
    pixels_per_nm = pixels_per_metre * METRES_PER_NM / float(true_scale(lat))
    for miles in _SCALES_NM:
        if miles * pixels_per_nm <= _LONGEST_PX:
            return miles, miles * pixels_per_nm
    return _SCALES_NM[-1], _SCALES_NM[-1] * pixels_per_nm


def scale_label(miles: float) -> str:
    """Text beside the scale bar."""
    return f"{miles:g} nm"


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
        painter.setPen(QPen(self.colours.halo, 5.0))
        painter.drawLine(QPointF(left, base), QPointF(left + length, base))
        painter.setPen(QPen(self.colours.ink, 3.0))
        painter.drawLine(QPointF(left, base), QPointF(left + half, base))
        painter.setPen(QPen(self.colours.graticule_text, 3.0))
        painter.drawLine(QPointF(left + half, base), QPointF(left + length, base))
        text = scale_label(miles)
        x = left + half - text_width(painter.font(), text) / 2
        halo_text(painter, QPointF(x, base - 7), text, self.colours.ink, self.colours.halo)
