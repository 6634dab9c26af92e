"""The panel beside the chart: messages, progress, and the answer; and what to do first."""

from __future__ import annotations

from datetime import datetime

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QScrollArea, QVBoxLayout, QWidget

from seacruise.desktop.banner import Banner, text_label
from seacruise.desktop.compute import Answer
from seacruise.desktop.messages import Message
from seacruise.desktop.progress_panel import ProgressPanel
from seacruise.desktop.result_panel import ResultPanel
from seacruise.desktop.state import Phase, WindowState
from seacruise.desktop.style import scaled_font
from seacruise.desktop.units_choice import Units, units_choice


def scroll_area(body: QWidget, width: int, parent: QWidget | None = None) -> QScrollArea:
    """Scroll area of a fixed width for a column of cards."""
    area = QScrollArea(parent)
    area.setObjectName("side")
    area.setFrameShape(QFrame.Shape.NoFrame)
    area.setWidgetResizable(True)
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    area.setFixedWidth(width)
    area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    body.setObjectName("sideBody")
    area.setWidget(body)
    return area


class Welcome(QFrame):
    """What to do first."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("card")
        title = text_label(self.tr("Is a week enough?"), parent=self)
        title.setFont(scaled_font(self.font(), 1.25, bold=True))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 12, 16, 14)
        layout.setSpacing(9)
        layout.addWidget(title)
        for text in (
            self.tr(
                "Choose two ports, a departure and your yacht. "
                "SeaCruise finds the fastest passage under sail."
            ),
            self.tr("Right-click on the chart to sail from, to or via any position, or to avoid an area."),
            self.tr("Then drag the start, the end or the departure: the passage follows."),
            self.tr("Drop a polar file on the window to add your yacht, or a GRIB file to use its wind."),
        ):
            layout.addWidget(text_label(text, parent=self))
        keys = text_label(
            self.tr("Ctrl+Enter calculates, Esc cancels, + and − zoom, the arrow keys move the chart."),
            "hint",
            self,
        )
        layout.addWidget(keys)


class SidePanel(QWidget):
    """Column of cards; ``way_out_chosen(way_out)`` from any banner."""

    way_out_chosen = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.progress = ProgressPanel(self)
        self.result = ResultPanel(self)
        self.result.way_out_chosen.connect(self.way_out_chosen)
        self.welcome = Welcome(self)
        self.banner: Banner | None = None
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(10, 10, 10, 10)
        self._layout.setSpacing(10)
        self._layout.addWidget(self.welcome)
        self._layout.addWidget(self.progress)
        self._layout.addWidget(self.result)
        self._layout.addStretch()
        self._shown: tuple[WindowState, Message | None, datetime] | None = None
        units_choice().changed.connect(self._show_units)
        self._pictured: tuple[Answer, bool, Units] | None = None

    def show_state(self, state: WindowState, message: Message | None, now: datetime) -> None:
        """Show a state with its message."""
        self._shown = (state, message, now)
        computing = state.phase is Phase.COMPUTING
        if computing and self.progress.isHidden():
            self.progress.begin()
        elif not computing:
            self.progress.end()
        self.progress.setVisible(computing)
        if computing:
            self.progress.show_progress(state.progress)
        self._show_message(message)
        self.result.setVisible(state.answer is not None)
        if state.answer is not None:
            shown = (state.answer, state.answer_is_earlier, units_choice().units)
            if self._pictured is None or shown[0] is not self._pictured[0] or shown[1:] != self._pictured[1:]:
                self.result.show_passage(
                    state.answer.passage,
                    now,
                    earlier=state.answer_is_earlier,
                    rough=state.answer.rough,
                    via=state.answer.question.via.name if state.answer.question.via else "",
                    wind=state.answer.wind,
                )
                self._pictured = shown
        self.welcome.setVisible(not computing and message is None and state.answer is None)

    def _show_units(self) -> None:
        if self._shown is not None:
            self.show_state(*self._shown)

    def _show_message(self, message: Message | None) -> None:
        if self.banner is not None:
            if message == self.banner.message:
                return
            self.banner.take_down()
            self.banner = None
        if message is not None:
            self.banner = Banner(message, self)
            self.banner.way_out_chosen.connect(self.way_out_chosen)
            self._layout.insertWidget(0, self.banner)
