"""Ports with their names: as many as the zoom has room for, and always the two that are chosen."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen, QTransform

from seacruise.desktop.chart import palette
from seacruise.desktop.chart.layer import Layer, halo_text, text_width
from seacruise.desktop.chart.plane import to_plane
from seacruise.desktop.style import scaled_font
from seacruise.ports import Port

_COARSEST_M: Final = 1_600_000.0
_LEVELS: Final = 16
_ROOM_PX: Final = 85.0

_WELL_KNOWN: Final = frozenset(
    (
        *("København", "Stockholm", "Helsinki", "Tallinn", "Rīga", "Gdynia", "Gdańsk", "Klaipėda", "Kiel"),
        *("Rostock", "Göteborg", "Visby", "Turku", "Mariehamn", "Kalmar", "Karlskrona", "Rønne", "Sassnitz"),
        *("Świnoujście", "Hel", "Ventspils", "Liepāja", "Pärnu", "Kuressaare", "Hanko", "Sandhamn"),
        *("Nynäshamn", "Aarhus", "Skagen", "Oulu", "Vaasa", "Luleå", "Sundsvall", "Umeå", "Gävle"),
        "Sankt-Peterburg",
    )
)
"""Named first where there is not room for all."""


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
        self._ports: list[tuple[QPointF, str, int]] = []
        self._chosen: list[tuple[QPointF, str]] = []
        self.names_shown = True

    def show_ports(self, ports: Sequence[Port]) -> None:
        """Take the ports over."""
        ports = sorted(ports, key=lambda port: port.name.partition(" (")[0] not in _WELL_KNOWN)
        x, y = to_plane(np.array([p.lat for p in ports]), np.array([p.lon for p in ports]))
        ranks = rank_by_room(x.tolist(), y.tolist())
        places = [QPointF(px, py) for px, py in zip(x.tolist(), y.tolist(), strict=True)]
        named = [(at, port.name, rank) for at, port, rank in zip(places, ports, ranks, strict=True)]
        self._ports = sorted(named, key=lambda item: item[2])
        self.update()

    def choose(self, ends: Sequence[tuple[QPointF, str]]) -> None:
        """Mark the ends of the passage, with their names."""
        self._chosen = list(ends)
        self.update()

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw the chosen ends first, then ports by rank wherever dot and name fit."""
        occupied = [QRectF(view.right() - 54, view.top(), 54, 130)]
        names = {name for _, name in self._chosen}
        finest = np.log2(_COARSEST_M * to_pixels.m11() / _ROOM_PX)
        base = painter.font()
        small = scaled_font(base, 0.92)
        bold = scaled_font(base, 1.05, bold=True)
        painter.setFont(bold)
        for place, name in self._chosen:
            self._draw_port(painter, (to_pixels.map(place), name), occupied, view, radius=5.0)
        painter.setFont(small)
        if self.names_shown:
            for place, name, rank in self._ports:
                if rank > finest or name in names:
                    continue
                at = to_pixels.map(place)
                if view.contains(at):
                    self._draw_port(painter, (at, name), occupied, view, radius=2.6)
        painter.setFont(base)

    def _draw_port(
        self,
        painter: QPainter,
        port: tuple[QPointF, str],
        occupied: list[QRectF],
        view: QRectF,
        *,
        radius: float,
    ) -> None:
        at, name = port
        chosen = radius > 3.0
        width, height = text_width(painter.font(), name), painter.fontMetrics().height()
        gap = radius + 4.0
        dot = QRectF(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius)
        right = QRectF(at.x() + gap, at.y() - height / 2, width, height)
        left = QRectF(at.x() - gap - width, at.y() - height / 2, width, height)
        for label in (right, left):
            if view.contains(label) and not any(label.intersects(other) for other in occupied):
                break
        else:
            if not chosen:
                return
            label = right
        if not chosen and any(dot.intersects(other) for other in occupied):
            return
        occupied += [label.adjusted(-5, -2, 5, 2), dot.adjusted(-2, -2, 2, 2)]
        painter.setPen(QPen(palette.CASING, 1.5))
        painter.setBrush(palette.MAGENTA if chosen else palette.PORT)
        painter.drawEllipse(at, radius, radius)
        painter.setPen(Qt.PenStyle.NoPen)
        base_line = label.top() + painter.fontMetrics().ascent()
        halo_text(painter, label.left(), base_line, name, palette.MAGENTA if chosen else palette.PORT)
