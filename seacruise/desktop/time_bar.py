"""The slider that moves time: boat and wind on the chart follow it."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta

from PySide6.QtCore import QSize, Qt, QTimer, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QSlider, QToolButton, QWidget

from seacruise.desktop.departure_field import format_moment
from seacruise.desktop.style import icon, scaled_font

_TICK_MS = 40
_MINUTES_A_TICK = 6


class TimeBar(QFrame):
    """Play button, slider, and the moment in words; ``moved(datetime)`` as time goes."""

    moved = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("bar")
        self._begin = datetime(1970, 1, 1, tzinfo=UTC)
        self.play_button = QToolButton(self)
        self.play_button.setIconSize(QSize(16, 16))
        self.play_button.setCheckable(True)
        self.play_button.setAccessibleName(self.tr("Play the passage"))
        self.play_button.toggled.connect(self._play)
        self.slider = QSlider(Qt.Orientation.Horizontal, self)
        self.slider.setAccessibleName(self.tr("Time along the passage"))
        self.slider.setSingleStep(6)
        self.slider.setPageStep(60)
        self.slider.valueChanged.connect(self._slid)
        self.label = QLabel(self)
        self.label.setFont(scaled_font(self.font(), 1.0, bold=True))
        self.label.setMinimumWidth(
            self.label.fontMetrics().horizontalAdvance("Mon 30 Nov 2030 00:00 UTC  +100 h 00") + 8
        )
        self.label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(12, 6, 14, 6)
        layout.setSpacing(10)
        layout.addWidget(self.play_button)
        layout.addWidget(self.slider, 1)
        layout.addWidget(self.label)
        self._ticker = QTimer(self)
        self._ticker.setInterval(_TICK_MS)
        self._ticker.timeout.connect(self._advance)
        self.set_span(None, None)
        self._play(on=False)

    def set_span(self, begin: datetime | None, end: datetime | None) -> None:
        """Let the slider run between two moments; nowhere while there is no passage."""
        known = begin is not None and end is not None
        self.play_button.setChecked(False)
        self.setEnabled(known)
        if begin is None or end is None:
            self.slider.setRange(0, 0)
            self.label.setText("")
            return
        self._begin = begin
        self.slider.setRange(0, max(1, round((end - begin).total_seconds() / 60.0)))
        self.slider.setValue(0)
        self._slid(0)

    @property
    def moment(self) -> datetime:
        """Where the slider is, UTC."""
        return self._begin + timedelta(minutes=self.slider.value())

    def set_moment(self, moment: datetime) -> None:
        """Move the slider."""
        self.slider.setValue(round((moment - self._begin).total_seconds() / 60.0))

    def _slid(self, minutes: int) -> None:
        hours, rest = divmod(minutes, 60)
        text = self.tr("{moment} UTC  +{hours} h {minutes:02d}").format(
            moment=format_moment(self.moment), hours=hours, minutes=rest
        )
        self.label.setText(text)
        self.moved.emit(self.moment)

    def _play(self, on: bool) -> None:
        self.play_button.setIcon(icon("pause" if on else "play"))
        self.play_button.setToolTip(self.tr("Pause") if on else self.tr("Play the passage"))
        if on:
            if self.slider.value() >= self.slider.maximum():
                self.slider.setValue(0)
            self._ticker.start()
        else:
            self._ticker.stop()

    def _advance(self) -> None:
        self.slider.setValue(self.slider.value() + _MINUTES_A_TICK)
        if self.slider.value() >= self.slider.maximum():
            self.play_button.setChecked(False)
