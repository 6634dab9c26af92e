"""Wind speed as a field of colour under the barbs."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QImage, QPainter, QTransform

from seacruise.desktop.chart.layer import Layer
from seacruise.desktop.chart.palette import Palette
from seacruise.geodesy import from_mercator
from seacruise.units import MS_PER_KNOT

if TYPE_CHECKING:
    from seacruise.weather.wind import Wind

FIELD_STOPS: Final = (
    (0.0, "#B9D9EA"),
    (6.0, "#7FBBD9"),
    (11.0, "#55B6A0"),
    (16.0, "#8CC152"),
    (21.0, "#F0CF4A"),
    (27.0, "#EC8B3C"),
    (34.0, "#CF3F3A"),
    (48.0, "#7B2A86"),
)
"""Speeds [kn] and their colours; between two of them they blend."""

_STEP_KN: Final = 0.25
_CELL_PX: Final = 20.0
_ENLARGED: Final = 2
_MARGIN: Final = 0.25


def field_table(alpha: int) -> NDArray[np.uint8]:
    """Colours by speed in quarter knots, ``(n, 4)`` as blue, green, red, alpha, premultiplied."""
    speeds = np.arange(0.0, FIELD_STOPS[-1][0] + _STEP_KN, _STEP_KN)
    knots = [speed for speed, _ in FIELD_STOPS]
    colours = [QColor(text) for _, text in FIELD_STOPS]
    channels = [
        np.interp(speeds, knots, [getattr(colour, name)() for colour in colours])
        for name in ("blue", "green", "red")
    ]
    # A calm is hardly tinted: the field begins where wind does.
    opacity = alpha * np.interp(speeds, (0.0, 8.0), (0.35, 1.0))
    premultiplied = [channel * opacity / 255.0 for channel in channels]
    return np.stack([*premultiplied, opacity], axis=1).round().astype(np.uint8)


class FieldLayer(Layer):
    """Field of a wind at a time; painted for more than the view, so that panning moves a picture only."""

    by_strips = True

    def __init__(self, bounds: QRectF) -> None:
        super().__init__(bounds)
        self._wind: Wind | None = None
        self._time = 0.0
        self._table = field_table(self.colours.field_alpha)
        self._picture: tuple[tuple[float, float], QRectF, QImage] | None = None

    def set_palette(self, colours: Palette) -> None:
        """Blend for another light."""
        super().set_palette(colours)
        self._table = field_table(colours.field_alpha)
        self._picture = None

    def show_wind(self, wind: Wind | None, time: float) -> None:
        """Show a wind at a time [s since 1970-01-01T00:00Z]."""
        if wind is not self._wind:
            self._picture = None
        self._wind, self._time = wind, time
        self.update()

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw the field, made anew when time or zoom have changed or the view has left it."""
        if self._wind is None:
            return
        area, picture = self._pictured(self._wind, to_pixels, view)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.drawImage(to_pixels.mapRect(area), picture)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, on=False)

    def prepare(self, to_pixels: QTransform, view: QRectF, density: float) -> bool:
        """Make the picture of the field."""
        del density
        if self._wind is not None:
            self._pictured(self._wind, to_pixels, view)
        return True

    def _pictured(self, wind: Wind, to_pixels: QTransform, view: QRectF) -> tuple[QRectF, QImage]:
        """Give the picture of a part of the plane that holds the view."""
        back, _ = to_pixels.inverted()
        seen, scale = back.mapRect(view), to_pixels.m11()
        key = (scale, self._time)
        known = self._picture
        if known is None or known[0] != key or not known[1].contains(seen):
            # While time runs every frame has a picture of its own, and what lies beyond the view is in vain.
            margin = _MARGIN if known is not None and known[0] == key else 0.0
            area = seen.adjusted(
                -margin * seen.width(), -margin * seen.height(), margin * seen.width(), margin * seen.height()
            )
            self._picture = known = (key, *self._paint(wind, area, scale))
        return known[1:]

    def _paint(self, wind: Wind, area: QRectF, scale: float) -> tuple[QRectF, QImage]:
        """Paint an area of the plane; returns what was painted, which is a little more, and its picture."""
        step = _CELL_PX / scale
        left, top = math.floor(area.left() / step) * step, math.floor(area.top() / step) * step
        columns = math.ceil((area.right() - left) / step) + 2
        rows = math.ceil((area.bottom() - top) / step) + 2
        x, y = left + step * np.arange(columns), top + step * np.arange(rows)
        lat, lon = from_mercator(x, -y)
        u, v = wind.at(self._time, lat[:, None], lon[None, :])
        index = np.hypot(u, v) / (MS_PER_KNOT * _STEP_KN)
        fine = _enlarge(np.minimum(index, len(self._table) - 1.0))
        pixels = self._table[np.rint(fine).astype(np.intp)]
        fine_step = step / _ENLARGED
        fine_lat, _ = from_mercator(0.0, -(top + fine_step * np.arange(fine.shape[0])))
        _, fine_lon = from_mercator(left + fine_step * np.arange(fine.shape[1]), 0.0)
        pixels[~wind.covers(fine_lat[:, None], fine_lon[None, :])] = 0
        rows, columns = fine.shape
        image = QImage(
            np.ascontiguousarray(pixels).tobytes(),
            columns,
            rows,
            4 * columns,
            QImage.Format.Format_ARGB32_Premultiplied,
        ).copy()
        # Values are those of the pixels' middles.
        painted = QRectF(left - fine_step / 2, top - fine_step / 2, columns * fine_step, rows * fine_step)
        return painted, image


def _enlarge(grid: NDArray[np.float64]) -> NDArray[np.float64]:
    """Put values between the nodes of a grid, linear in both directions."""

    def along(values: NDArray[np.float64]) -> NDArray[np.float64]:
        steps = np.arange(_ENLARGED) / _ENLARGED
        between = values[:-1, None, :] * (1.0 - steps)[None, :, None] + values[1:, None, :] * steps[:, None]
        return np.asarray(between.reshape(-1, values.shape[1]))

    return along(along(grid).T).T
