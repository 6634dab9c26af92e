"""Ports with their names: as many as the zoom has room for, and always the two that are chosen."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Final

import numpy as np
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QFont, QFontMetricsF, QPainter, QTransform

from seacruise.desktop.chart.importance import importance, short_name
from seacruise.desktop.chart.labels import Labels, around
from seacruise.desktop.chart.layer import Layer, draw_dot, halo_text, named_dot, text_width
from seacruise.desktop.chart.plane import point, to_plane
from seacruise.desktop.style import scaled_font
from seacruise.ports import Port

_COARSEST_M: Final = 1_600_000.0
_LEVELS: Final = 16
_ROOM_PX: Final = 85.0
_NEAR_PX_M: Final = 1.0 / 500.0
"""Scale from which a town's harbours are told apart [pixels per metre of the plane]."""

_DOT_PX: Final = 2.6
_CHOSEN_PX: Final = 5.0
_CHOSEN_SIZE: Final = 1.05
_NAME_SIZE: Final = 0.92
_NEW_A_FRAME: Final = 10
"""Names pictured in one frame at the most: when sixty come into view at once they come one after another."""

_GRIP_PX: Final = 13.0
_CATCH_PX: Final = 9.0
"""How near the pointer must be to take hold of an end, and an end in the hand to a port to become it."""


def rank_by_room(x: list[float], y: list[float]) -> list[int]:
    """For each place the level of zoom from which it has room: the first in its cell of a grid takes it.

    The grid halves from level to level. Ranks do not depend on the view, so names neither jump nor
    flicker while the chart is moved.
    """
    ranks = [_LEVELS] * len(x)
    for level in range(_LEVELS):
        size = _COARSEST_M / 2**level
        taken = {
            (round(px / size), round(py / size))
            for px, py, rank in zip(x, y, ranks, strict=True)
            if rank < level
        }
        for number, (px, py) in enumerate(zip(x, y, strict=True)):
            cell = (round(px / size), round(py / size))
            if ranks[number] == _LEVELS and cell not in taken:
                ranks[number] = level
                taken.add(cell)
    return ranks


class PortsLayer(Layer):
    """Dots and names of ports."""

    def __init__(self, bounds: QRectF) -> None:
        super().__init__(bounds)
        self._ports: list[tuple[QPointF, Port, int]] = []
        self._places = np.empty((3, 0))
        self.chosen: dict[str, tuple[QPointF, str]] = {}
        self._left_out: frozenset[str] = frozenset()
        self._names_shown = True
        self.is_complete = True

    @property
    def names_shown(self) -> bool:
        """Whether ports are shown, or only the chosen ends."""
        return self._names_shown

    @names_shown.setter
    def names_shown(self, on: bool) -> None:
        if on != self._names_shown:
            self._names_shown = on
            self.update()

    def show_ports(self, ports: Sequence[Port]) -> None:
        """Take the ports over."""
        ports = sorted(ports, key=lambda port: importance(port.name))
        x, y = to_plane(np.array([p.lat for p in ports]), np.array([p.lon for p in ports]))
        ranks = rank_by_room(x.tolist(), y.tolist())
        places = [QPointF(px, py) for px, py in zip(x.tolist(), y.tolist(), strict=True)]
        self._ports = sorted(zip(places, ports, ranks, strict=True), key=lambda item: item[2])
        self._places = np.array(
            [[p.x() for p, _, _ in self._ports], [p.y() for p, _, _ in self._ports], sorted(ranks)]
        )
        self.update()

    def choose(self, ends: Mapping[str, Port]) -> None:
        """Mark the ends of the passage, ``"from"`` and ``"to"`` and what lies between, with their names."""
        self.chosen = {which: (point(port.lat, port.lon), port.name) for which, port in ends.items()}
        # Which ports are left out: an end that is dragged over the sea changes nothing.
        left_out = frozenset(port.name for port in ends.values() if port.country)
        if left_out != self._left_out:
            self._left_out = left_out
            self.update()
        elif self.on_update is not None:
            self.on_update()

    @property
    def has_via(self) -> bool:
        """Whether the passage is led through a place on the way."""
        return "via" in self.chosen

    def end_at(self, at: QPointF, to_pixels: QTransform) -> str | None:
        """Tell which end is under a point [pixels]."""
        near = {which: _gap(to_pixels.map(place), at) for which, (place, _) in self.chosen.items()}
        which = min(near, key=lambda w: near[w], default=None)
        return which if which is not None and near[which] <= _GRIP_PX else None

    def port_at(self, at: QPointF, to_pixels: QTransform) -> Port | None:
        """Port whose dot is drawn under a point [pixels]."""
        finest, here = self._finest(to_pixels), to_pixels.inverted()[0].map(at)
        away = np.hypot(self._places[0] - here.x(), self._places[1] - here.y()) * to_pixels.m11()
        away[self._places[2] > finest] = math.inf
        nearest = int(away.argmin()) if away.size else -1
        return self._ports[nearest][1] if nearest >= 0 and away[nearest] <= _CATCH_PX else None

    def _finest(self, to_pixels: QTransform) -> float:
        return float(np.log2(_COARSEST_M * to_pixels.m11() / _ROOM_PX))

    def reserve(self, font: QFont, to_pixels: QTransform, labels: Labels) -> None:
        """Take the places of the chosen ends and their names before anything else is written."""
        bold = scaled_font(font, _CHOSEN_SIZE, bold=True)
        height = QFontMetricsF(bold).height()
        for which, (place, name) in self.chosen.items():
            at = to_pixels.map(place)
            size = (text_width(bold, name), height)
            sides = around(at, *size, _CHOSEN_PX + 9.0)
            dot = QRectF(at.x() - _CHOSEN_PX, at.y() - _CHOSEN_PX, 2 * _CHOSEN_PX, 2 * _CHOSEN_PX)
            kept = next((side for side in sides if labels.is_free(side)), sides[0])
            labels.kept[which] = kept
            labels.take(kept.adjusted(-5, -2, 5, 2))
            labels.take(dot.adjusted(-2, -2, 2, 2))

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw ports by rank wherever dot and name fit."""
        if self._names_shown:
            self._draw_ports(painter, to_pixels, view, scaled_font(painter.font(), _NAME_SIZE).key())

    def _draw_ports(self, painter: QPainter, to_pixels: QTransform, view: QRectF, font: str) -> None:
        colours, labels = self.colours, self.labels
        inks = (colours.ink.rgba(), colours.casing.rgba(), colours.halo.rgba())
        density = painter.device().devicePixelRatio()
        scale, dx, dy = to_pixels.m11(), to_pixels.dx(), to_pixels.dy()
        names, finest = self._left_out, self._finest(to_pixels)
        near = scale > _NEAR_PX_M
        made = named_dot.cache_info().misses
        self.is_complete = True
        for place, port, rank in self._ports:
            if rank > finest:
                break
            if named_dot.cache_info().misses - made >= _NEW_A_FRAME:
                self.is_complete = False
                self.update()
                break
            x, y = scale * place.x() + dx, scale * place.y() + dy
            if not (0.0 <= x <= view.width() and 0.0 <= y <= view.height()) or port.name in names:
                continue
            if not labels.is_free_box((x - _DOT_PX, y - _DOT_PX, x + _DOT_PX, y + _DOT_PX)):
                continue
            for to_left in (False, True):
                name = port.name if near else short_name(port.name)
                sprite = named_dot(name, font, inks, density, to_left=to_left, radius=_DOT_PX)
                left, top, right, bottom = sprite.name
                box = (x + left, y + top, x + right, y + bottom)
                if labels.is_free_box(box):
                    labels.take_box(box)
                    labels.take_box((x - 4.6, y - 4.6, x + 4.6, y + 4.6))
                    painter.drawPixmap(round(x - sprite.left), round(y - sprite.top), sprite.picture)
                    break


class EndsLayer(Layer):
    """The chosen ends with their names; apart from the ports, which stay as they are while one is dragged.

    Parameters
    ----------
    ports
        Knows them.
    """

    def __init__(self, bounds: QRectF, ports: PortsLayer) -> None:
        super().__init__(bounds)
        self._ports = ports

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw them, with their names in the places that were kept for them."""
        del view
        colours = self.colours
        painter.setFont(scaled_font(painter.font(), _CHOSEN_SIZE, bold=True))
        for which, (place, name) in self._ports.chosen.items():
            draw_dot(painter, to_pixels.map(place), _CHOSEN_PX, colours.magenta, colours.casing)
            if (kept := self.labels.kept.get(which)) is not None:
                base = QPointF(kept.left(), kept.top() + painter.fontMetrics().ascent())
                halo_text(painter, base, name, colours.magenta, colours.halo)


def _gap(a: QPointF, b: QPointF) -> float:
    return math.hypot(a.x() - b.x(), a.y() - b.y())
