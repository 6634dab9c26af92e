"""Where the parts of the window are."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QHBoxLayout, QSplitter, QVBoxLayout, QWidget

from seacruise.desktop.side_panel import scroll_area

_FORM_PX: Final = 350
_SIDE_PX: Final = 344


def legs_splitter(chart: QWidget, side: QWidget, legs: QWidget) -> tuple[QSplitter, QFrame]:
    """Chart and side panel above the table of legs; returns the splitter, and the table's frame."""
    upper = QWidget()
    row = QHBoxLayout(upper)
    row.setContentsMargins(0, 0, 0, 0)
    row.setSpacing(0)
    row.addWidget(chart, 1)
    row.addWidget(scroll_area(side, _SIDE_PX))
    frame = QFrame()
    frame.setObjectName("legs")
    inside = QVBoxLayout(frame)
    inside.setContentsMargins(1, 1, 1, 1)
    inside.addWidget(legs)
    frame.setVisible(False)
    splitter = QSplitter(Qt.Orientation.Vertical)
    splitter.addWidget(upper)
    splitter.addWidget(frame)
    splitter.setStretchFactor(0, 1)
    splitter.setCollapsible(0, False)
    splitter.setSizes([620, 176])
    return splitter, frame


def lay_out(form: QWidget, main: QWidget) -> QWidget:
    """Form to the left of everything else."""
    column = QWidget()
    inside = QVBoxLayout(column)
    inside.setContentsMargins(10, 10, 10, 10)
    inside.addWidget(form)
    inside.addStretch()
    centre = QWidget()
    layout = QHBoxLayout(centre)
    layout.setContentsMargins(0, 0, 0, 0)
    layout.setSpacing(0)
    layout.addWidget(scroll_area(column, _FORM_PX))
    layout.addWidget(main, 1)
    return centre
