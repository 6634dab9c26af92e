"""A layout that breaks lines like a text does: controls of a page that is narrow or wide."""

from __future__ import annotations

from PySide6.QtCore import QPoint, QRect, QSize, Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QLayout, QLayoutItem, QWidget

_GAP = 8


class FlowLayout(QLayout):
    """Puts widgets side by side and begins another line where there is no room."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._items: list[QLayoutItem] = []
        self.setContentsMargins(0, 0, 0, 0)

    def addItem(self, item: QLayoutItem) -> None:
        """Take an item over."""
        self._items.append(item)

    def count(self) -> int:
        """Items."""
        return len(self._items)

    def itemAt(self, index: int) -> QLayoutItem | None:
        """Item of a number, or none."""
        return self._items[index] if 0 <= index < len(self._items) else None

    def takeAt(self, index: int) -> QLayoutItem | None:
        """Remove an item."""
        return self._items.pop(index) if 0 <= index < len(self._items) else None

    def expandingDirections(self) -> Qt.Orientation:
        """Take no more room than is needed."""
        return Qt.Orientation(0)

    def hasHeightForWidth(self) -> bool:
        """Be higher where it is narrower."""
        return True

    def heightForWidth(self, width: int) -> int:
        """Height of all lines [pixels]."""
        return self._lay_out(QRect(0, 0, width, 0), move=False)

    def setGeometry(self, rect: QRect) -> None:
        """Put all items in their places."""
        super().setGeometry(rect)
        self._lay_out(rect, move=True)

    def sizeHint(self) -> QSize:
        """Size of the widest item."""
        return self.minimumSize()

    def minimumSize(self) -> QSize:
        """Size of the widest item."""
        size = QSize()
        for item in self._items:
            size = size.expandedTo(item.minimumSize())
        return size

    def _lay_out(self, rect: QRect, *, move: bool) -> int:
        for line, top, height in self._lines(rect):
            x = rect.x()
            for item in line if move else ():
                size = item.sizeHint()
                item.setGeometry(QRect(QPoint(x, top + (height - size.height()) // 2), size))
                x += size.width() + _GAP
        lines = self._lines(rect)
        return lines[-1][1] + lines[-1][2] - rect.y() if lines else 0

    def _lines(self, rect: QRect) -> list[tuple[list[QLayoutItem], int, int]]:
        """Items, top and height of each line."""
        lines: list[tuple[list[QLayoutItem], int, int]] = []
        line: list[QLayoutItem] = []
        x, top, height = 0, rect.y(), 0
        for item in self._items:
            size = item.sizeHint()
            if item.isEmpty():
                continue
            if line and x + size.width() > rect.width():
                lines.append((line, top, height))
                line, x, top, height = [], 0, top + height + _GAP, 0
            line.append(item)
            x += size.width() + _GAP
            height = max(height, size.height())
        return [*lines, (line, top, height)] if line else lines


def named(text: str, *fields: QWidget) -> QWidget:
    """Name before its fields, the first of which it leads to; they stay together when a line breaks."""
    group = QWidget()
    row = QHBoxLayout(group)
    row.setContentsMargins(0, 0, 0, 0)
    row.setSpacing(6)
    label = QLabel(text, group)
    label.setObjectName("fieldName")
    label.setBuddy(fields[0])
    row.addWidget(label)
    for field in fields:
        row.addWidget(field)
    return group
