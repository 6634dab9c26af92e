"""Where the parts of the window are."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QByteArray, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QSplitter, QVBoxLayout, QWidget

from seacruise.desktop.side_panel import scroll_area

if TYPE_CHECKING:
    from seacruise.desktop.passage_pane import PassagePane

_FORM_PX: Final = 350
_SIDE_PX: Final = 344
_PANE_PX: Final = 200


def pane_splitter(chart: QWidget, side: QWidget, pane: PassagePane) -> PaneSplitter:
    """Chart and side panel above the pane of the passage."""
    upper = QWidget()
    row = QHBoxLayout(upper)
    row.setContentsMargins(0, 0, 0, 0)
    row.setSpacing(0)
    row.addWidget(chart, 1)
    row.addWidget(scroll_area(side, _SIDE_PX))
    return PaneSplitter(upper, pane)


class PaneSplitter(QSplitter):
    """Gives the chart all that the pane below it does not need, whatever was kept from another day."""

    def __init__(self, upper: QWidget, pane: PassagePane) -> None:
        super().__init__(Qt.Orientation.Vertical)
        self._pane = pane
        self.addWidget(upper)
        self.addWidget(pane)
        self.setStretchFactor(0, 1)
        self.setCollapsible(0, False)
        self.setCollapsible(1, False)
        self.setSizes([1000, pane.maximumHeight()])
        pane.shrunk.connect(self._give_room)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Share the room anew."""
        super().resizeEvent(event)
        self._give_back()

    def restoreState(self, state: QByteArray | bytes | bytearray | memoryview, /) -> bool:
        """Take heights that were kept, of a pane that may have had more to show."""
        restored = super().restoreState(state)
        self._give_back()
        return restored

    def _give_back(self) -> None:
        """Take from the pane what lies beyond its greatest height: Qt would leave it grey below it."""
        if not self._pane.isHidden() and self.sizes()[self.indexOf(self._pane)] > self._pane.maximumHeight():
            self._set_height(self._pane.maximumHeight())

    def _give_room(self, small: bool) -> None:
        """Give the pane its height back when it has something to show; without, the chart has it."""
        opened = int(self._pane.property("openHeight") or _PANE_PX)
        self._set_height(self._pane.maximumHeight() if small else opened)

    def _set_height(self, height: int) -> None:
        sizes, own = self.sizes(), self.indexOf(self._pane)
        sizes[0], sizes[own] = sizes[0] + sizes[own] - height, height
        self.setSizes(sizes)


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
