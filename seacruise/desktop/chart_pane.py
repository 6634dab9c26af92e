"""The chart with its buttons, the ribbon that says what weather it is, and the slider below."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QSize, Qt
from PySide6.QtWidgets import QLabel, QToolButton, QVBoxLayout, QWidget

from seacruise.desktop.banner import first_sentence
from seacruise.desktop.chart.view import ChartView
from seacruise.desktop.language import sentence
from seacruise.desktop.style import scaled_font, show_icon
from seacruise.desktop.time_bar import TimeBar

_EDGE = 12
_RIBBON_PADDING = 30


class ChartPane(QWidget):
    """Chart, overlay buttons, ribbon and time bar."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.view = ChartView(self)
        self.time_bar = TimeBar(self)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.view, 1)
        layout.addWidget(self.time_bar)
        self.zoom_in_button = self._button("plus", self.tr("Zoom in"))
        self.zoom_out_button = self._button("minus", self.tr("Zoom out"))
        self.fit_button = self._button("fit", self.tr("Show the whole passage"))
        self.measure_button = self._button("measure", self.tr("Measure distance and bearing (Ctrl+M)"))
        self.measure_button.setCheckable(True)
        self.zoom_in_button.clicked.connect(self.view.zoom_in)
        self.zoom_out_button.clicked.connect(self.view.zoom_out)
        self.ribbon = QLabel(self.view)
        self.ribbon.setFont(scaled_font(self.font(), 0.95, bold=True))
        self.ribbon.setObjectName("ribbon")
        self.ribbon.setWordWrap(True)
        self.ribbon.hide()
        self.view.installEventFilter(self)

    def _button(self, name: str, text: str) -> QToolButton:
        button = QToolButton(self.view)
        show_icon(button, name)
        button.setIconSize(QSize(18, 18))
        button.setFixedSize(32, 32)
        button.setToolTip(text)
        button.setAccessibleName(text)
        button.setCursor(Qt.CursorShape.ArrowCursor)
        return button

    def show_ribbon(self, text: str) -> None:
        """Say over the chart, and so in every picture of it, what must not be overlooked; or nothing."""
        whole = sentence(text)
        # The rest, a reason mostly, stands beside the chart; over it, it would hide an end of the passage.
        self.ribbon.setText(first_sentence(whole))
        self.ribbon.setToolTip(whole)
        self.ribbon.setVisible(bool(text))
        self._place()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Keep buttons and ribbon at their edges."""
        if watched is self.view and event.type() == QEvent.Type.Resize:
            self._place()
        return bool(super().eventFilter(watched, event))

    def _place(self) -> None:
        right = self.view.width() - _EDGE
        buttons = (self.zoom_in_button, self.zoom_out_button, self.fit_button, self.measure_button)
        for row, button in enumerate(buttons):
            button.move(right - button.width(), _EDGE + row * (button.height() + 5))
        room = max(self.view.width() - 2 * (_EDGE + 44), 120)
        words = self.ribbon.fontMetrics().horizontalAdvance(self.ribbon.text())
        width = min(words + _RIBBON_PADDING, room)
        self.ribbon.resize(width, self.ribbon.heightForWidth(width))
        self.ribbon.move((self.view.width() - self.ribbon.width()) // 2, _EDGE)
