"""Where the parts of the window are."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QSplitter, QVBoxLayout, QWidget

from seacruise.desktop.side_panel import scroll_area

if TYPE_CHECKING:
    from seacruise.desktop.passage_pane import PassagePane

_FORM_PX: Final = 350
_SIDE_PX: Final = 344
_PANE_PX: Final = 224


def pane_splitter(chart: QWidget, side: QWidget, pane: PassagePane) -> QSplitter:
    """Chart and side panel above the pane of the passage."""
    upper = QWidget()
    row = QHBoxLayout(upper)
    row.setContentsMargins(0, 0, 0, 0)
    row.setSpacing(0)
    row.addWidget(chart, 1)
    row.addWidget(scroll_area(side, _SIDE_PX))
    splitter = QSplitter(Qt.Orientation.Vertical)
    splitter.addWidget(upper)
    splitter.addWidget(pane)
    splitter.setStretchFactor(0, 1)
    splitter.setCollapsible(0, False)
    splitter.setCollapsible(1, False)
    splitter.setSizes([1000, pane.maximumHeight()])
    pane.shrunk.connect(partial(_give_room, splitter, pane))
    return splitter


def _give_room(splitter: QSplitter, pane: PassagePane, small: bool) -> None:
    """Give the pane its height back when it has something to show; without, the chart has it."""
    sizes = splitter.sizes()
    whole, own = sizes[0] + sizes[1], splitter.indexOf(pane)
    wanted = pane.maximumHeight() if small else int(pane.property("openHeight") or _PANE_PX)
    sizes[0], sizes[own] = whole - wanted, wanted
    splitter.setSizes(sizes)


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
