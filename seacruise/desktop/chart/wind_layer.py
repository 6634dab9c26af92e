"""Wind barbs at the slider's time, thinned to one per about sixty pixels."""

from __future__ import annotations

import math
import time
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter, QPixmap, QTransform

from seacruise.desktop.chart.barbs import BarbSprites, barb_sprites, direction_classes
from seacruise.desktop.chart.layer import Layer
from seacruise.desktop.chart.palette import Palette
from seacruise.geodesy import from_mercator
from seacruise.sea.depth import chart_depths
from seacruise.units import MS_PER_KNOT

if TYPE_CHECKING:
    from seacruise.weather.wind import Wind

LEAST_PX: Final = 58.0
_GROWTH: Final = math.sqrt(2.0)
_REACH_PX: Final = 40.0
_ASHORE: Final = 0.4
"""Opacity of barbs on land, which nobody sails by."""

_TOO_NEAR_M: Final = 25_000.0
"""Barbs nearer to each other than this [m of the plane] are finer than what is known of land here."""

_PART_S: Final = 0.003
"""So long pictures of barbs are made at a time."""

Array = NDArray[np.float64]
Kind = tuple[int, int, int, bool]
"""Speed in fives of knots, class of direction, hemisphere, and whether it stands on land."""

Barbs = tuple[Array, Array, list[Kind]]
Stations = tuple[Array, Array, list[QPixmap]]
Places = tuple[Array, Array, Array, Array, NDArray[np.bool_]]
"""Stations ``(n,)``: x, y [m] of the plane, lat, lon [degrees], and whether they are on land."""


def spacing_m(pixels_per_metre: float) -> float:
    """Distance of barbs in the plane [m]: stations stay where they are while the chart is panned.

    From one zoom to the next the distance grows by the root of two, so that barbs stand 58 to 82
    pixels apart.
    """
    return 1000.0 * float(_GROWTH ** math.ceil(math.log(LEAST_PX / pixels_per_metre / 1000.0, _GROWTH)))


class WindLayer(Layer):
    """Barbs of a wind at a time."""

    def __init__(self, bounds: QRectF) -> None:
        super().__init__(bounds)
        self._wind: Wind | None = None
        self._time = 0.0
        self._barbs: tuple[tuple[float, ...], Barbs] | None = None
        self._drawn: tuple[tuple[float, ...], Stations] | None = None
        self._places: tuple[tuple[float, ...], Places] | None = None

    def set_palette(self, colours: Palette) -> None:
        """Draw the barbs in the colours of another light."""
        super().set_palette(colours)
        self._drawn = None

    def show_wind(self, wind: Wind | None, time: float) -> None:
        """Show a wind at a time [s since 1970-01-01T00:00Z]."""
        if wind is not self._wind:
            self._drawn, self._places, self._barbs = None, None, None
        self._wind, self._time = wind, time
        self.update()

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw the barbs whose stations are in view or just beyond."""
        if self._wind is None:
            return
        density = painter.device().devicePixelRatio()
        x, y, pictures = self._stations(self._wind, to_pixels, view, density)
        columns = np.rint(to_pixels.m11() * x[0] + to_pixels.dx() - x[1]).astype(int).tolist()
        rows = np.rint(to_pixels.m22() * y[0] + to_pixels.dy() - y[1]).astype(int).tolist()
        draw = painter.drawPixmap
        for column, row, picture in zip(columns, rows, pictures, strict=True):
            draw(column, row, picture)

    def prepare(self, to_pixels: QTransform, view: QRectF, density: float) -> bool:
        """Make pictures of barbs: each takes a fifth of a millisecond, and another zoom wants dozens."""
        if self._wind is None:
            return True
        until = time.perf_counter() + _PART_S
        _, (_, _, kinds) = self._standing(self._wind, to_pixels, view)
        pictures = self._pictures()
        for fives, number, side, dry in set(kinds):
            if time.perf_counter() > until:
                return False
            pictures[dry].sprite(fives, number, side=side, density=density)
        return True

    def _pictures(self) -> tuple[BarbSprites, BarbSprites]:
        """Pictures of barbs at sea, and of those on land."""
        ink, halo = self.colours.barb.rgba(), self.colours.halo.rgba()
        return barb_sprites(ink, halo), barb_sprites(ink, halo, _ASHORE)

    def _covered(self, wind: Wind, step: float, columns: tuple[int, int], rows: tuple[int, int]) -> Places:
        """Find the stations that a wind reaches, kept while time runs."""
        key: tuple[float, ...] = (step, *columns, *rows)
        if self._places is not None and self._places[0] == key:
            return self._places[1]
        row, column = np.mgrid[rows[0] : rows[1] + 1, columns[0] : columns[1] + 1]
        # every second row is shifted by half a step: an even cover without visible columns
        x, y = ((column + 0.5 * (row % 2)) * step).ravel(), (row * step).ravel()
        lat, lon = from_mercator(x, -y)
        here = wind.covers(lat, lon)
        x, y, lat, lon = x[here], y[here], lat[here], lon[here]
        ashore = chart_depths().ashore(lat, lon) & (step > _TOO_NEAR_M)
        found = (x, y, lat, lon, ashore)
        self._places = (key, found)
        return found

    def _standing(self, wind: Wind, to_pixels: QTransform, view: QRectF) -> tuple[tuple[float, ...], Barbs]:
        """Find which barbs stand where in a view, kept until something changes; first what they depend on."""
        back, _ = to_pixels.inverted()
        seen = back.mapRect(view.adjusted(-_REACH_PX, -_REACH_PX, _REACH_PX, _REACH_PX))
        step = spacing_m(to_pixels.m11())
        columns = (math.ceil(seen.left() / step), math.floor(seen.right() / step))
        rows = (math.ceil(seen.top() / step), math.floor(seen.bottom() / step))
        key: tuple[float, ...] = (step, *columns, *rows, self._time)
        if self._barbs is not None and key == self._barbs[0]:
            return self._barbs
        from seacruise.weather.wind import to_direction

        x, y, lat, lon, ashore = self._covered(wind, step, columns, rows)
        speed, direction = to_direction(*wind.at(self._time, lat, lon))
        fives = np.floor(speed / MS_PER_KNOT / 5.0 + 0.5).astype(int).tolist()
        sides = np.where(lat < 0, -1, 1).tolist()
        kinds = list(zip(fives, direction_classes(direction).tolist(), sides, ashore.tolist(), strict=True))
        self._barbs = (key, (x, y, kinds))
        return self._barbs

    def _stations(self, wind: Wind, to_pixels: QTransform, view: QRectF, density: float) -> Stations:
        """Find barbs and their places: ``(2, n)`` of the plane [m], and from edge to station [pixels].

        Kept until something changes.
        """
        key, (x, y, kinds) = self._standing(wind, to_pixels, view)
        key = (*key, density)
        if self._drawn is not None and key == self._drawn[0]:
            return self._drawn[1]
        pictures = self._pictures()
        sprites = [
            pictures[dry].sprite(fives, number, side=side, density=density)
            for fives, number, side, dry in kinds
        ]
        left, top = (np.array([sprite[k] for sprite in sprites]) for k in (1, 2))
        found = (np.stack([x, left]), np.stack([y, top]), [sprite[0] for sprite in sprites])
        self._drawn = (key, found)
        return found
