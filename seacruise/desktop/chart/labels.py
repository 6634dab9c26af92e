"""Room for labels: what is written first keeps its place, and nothing is written over it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QFont

_CELL_PX: Final = 64.0

Box = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class Label:
    """Text with its base line at a point [pixels]."""

    font: QFont
    base: QPointF
    text: str
    ink: QColor


class Labels:
    """Places of the viewport that are taken in the present frame [pixels].

    Kept by cells of a grid, and in plain numbers: a thousand questions a frame against a hundred places
    would be a frame's time otherwise.
    """

    def __init__(self) -> None:
        self._cells: dict[tuple[int, int], list[Box]] = {}
        self._view: Box = (0.0, 0.0, 0.0, 0.0)
        self.written: list[Label] = []
        self.kept: dict[str, QRectF] = {}

    def begin(self, view: QRectF, taken: Iterable[QRectF] = ()) -> None:
        """Begin a frame, with what lies over the chart anyway."""
        self._view, self._cells, self.written, self.kept = edges(view), {}, [], {}
        for place in taken:
            self.take(place)

    def take(self, place: QRectF) -> None:
        """Take a place, whoever else has it."""
        self.take_box(edges(place))

    def take_box(self, box: Box) -> None:
        """Take a place given by left, top, right and bottom."""
        cells = self._cells
        for column in range(int(box[0] // _CELL_PX), int(box[2] // _CELL_PX) + 1):
            for row in range(int(box[1] // _CELL_PX), int(box[3] // _CELL_PX) + 1):
                cells.setdefault((column, row), []).append(box)

    def is_free(self, place: QRectF) -> bool:
        """Whether a place is in view and nobody's."""
        return self.is_free_box(edges(place))

    def is_free_box(self, box: Box) -> bool:
        """Whether a place given by left, top, right and bottom is in view and nobody's."""
        left, top, right, bottom = box
        view = self._view
        if left < view[0] or top < view[1] or right > view[2] or bottom > view[3]:
            return False
        cells = self._cells
        for column in range(int(left // _CELL_PX), int(right // _CELL_PX) + 1):
            for row in range(int(top // _CELL_PX), int(bottom // _CELL_PX) + 1):
                for other in cells.get((column, row), ()):
                    if left < other[2] and other[0] < right and top < other[3] and other[1] < bottom:
                        return False
        return True

    def write(self, label: Label) -> None:
        """Have a text drawn above barbs and route, whichever layer it is of."""
        self.written.append(label)

    def claim(self, *places: QRectF) -> QRectF | None:
        """Take the first of some places that is free; ``None`` when none is."""
        for place in places:
            if self.is_free(place):
                self.take(place)
                return place
        return None


def edges(place: QRectF) -> Box:
    """Left, top, right and bottom of a place."""
    return place.left(), place.top(), place.right(), place.bottom()


def around(at: QPointF, width: float, height: float, gap: float) -> tuple[QRectF, ...]:
    """Places for a label around a point: right, left, above, below."""
    x, y = at.x(), at.y()
    return (
        QRectF(x + gap, y - height / 2, width, height),
        QRectF(x - gap - width, y - height / 2, width, height),
        QRectF(x - width / 2, y - gap - height, width, height),
        QRectF(x - width / 2, y + gap, width, height),
    )
