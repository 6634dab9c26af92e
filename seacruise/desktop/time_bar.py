"""Two sliders: her departure, which re-routes at once, and the time under way for boat and wind."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta
from typing import TYPE_CHECKING, Final

import numpy as np
from PySide6.QtCore import QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QSlider, QToolButton, QWidget

from seacruise.desktop.daylight import Light, light_along, spans
from seacruise.desktop.elided import ElidedLabel
from seacruise.desktop.style import scaled_font, show_icon
from seacruise.desktop.units_choice import short_moment, units_choice, week_moment

if TYPE_CHECKING:
    from seacruise.desktop.state import Horizon
    from seacruise.passage import Track

_TICK_MS: Final = 40
_MINUTES_A_TICK: Final = 6
_DEPARTURE_STEP_MIN: Final = 10
_HANDLE_PX: Final = 20
_SLIDER_PX: Final = 80
_SAMPLE: Final = "Mon 30 Nov 00:00 UTC+1  +100 h 00"
_LIGHTS: Final = {Light.DAY: "#F2C14E", Light.TWILIGHT: "#7F8FA6", Light.NIGHT: "#22324A"}


class DaylightStrip(QWidget):
    """Day, twilight and night along the slider above it."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFixedHeight(5)
        self._parts: list[tuple[Light, float, float]] = []
        self._darker = 100

    def show_track(self, track: Track | None) -> None:
        """Show the light along a track, or nothing."""
        self._parts = []
        if track is not None:
            begin, length = float(track.time[0]), max(float(np.ptp(track.time)), 1.0)
            self._parts = [
                (
                    Light(light),
                    (float(track.time[a]) - begin) / length,
                    (float(track.time[b]) - begin) / length,
                )
                for light, a, b in spans(light_along(track))
            ]
        dark = sum(b - a for light, a, b in self._parts if light is Light.NIGHT)
        text = self.tr("{share:.0%} of the passage is dark").format(share=dark) if self._parts else ""
        self.setToolTip(text)
        self.setAccessibleName(text)
        self.update()

    def show_light(self, light: str) -> None:
        """Be as bright as a light allows: ``day``, ``dusk`` or ``night``."""
        self._darker = {"day": 100, "dusk": 130, "night": 260}[light]
        self.update()

    @property
    def parts(self) -> list[tuple[Light, float, float]]:
        """Light, and where it begins and ends as a share of the passage."""
        return list(self._parts)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw one bar a part."""
        del event
        painter = QPainter(self)
        room = self.width() - _HANDLE_PX
        for light, begin, end in self._parts:
            bar = QRectF(_HANDLE_PX / 2 + begin * room, 0, (end - begin) * room, self.height())
            painter.fillRect(bar, QColor(_LIGHTS[light]).darker(self._darker))
        painter.end()


class TimeBar(QFrame):
    """Both sliders, play button, and the moments in words.

    Signals: ``moved(datetime)`` as the time under way goes, ``departure_moved(datetime)`` while the
    departure is dragged, and ``departure_settled()`` when it is let go.
    """

    moved = Signal(object)
    departure_moved = Signal(object)
    departure_settled = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("bar")
        self._begin = datetime(1970, 1, 1, tzinfo=UTC)
        self._first = self._leaves = self._begin
        self._make_departure()
        self._make_time()
        self._lay_out()
        self._ticker = QTimer(self)
        self._ticker.setInterval(_TICK_MS)
        self._ticker.timeout.connect(self._advance)
        self.set_horizon(None)
        self.set_span(None, None)
        self._play(on=False)
        units_choice().changed.connect(self._tell_again)

    def _make_departure(self) -> None:
        self.departure_slider = QSlider(Qt.Orientation.Horizontal, self)
        self.departure_slider.setObjectName("departure")
        self.departure_slider.setAccessibleName(self.tr("Departure"))
        self.departure_slider.setToolTip(self.tr("Drag the departure: the passage follows"))
        self.departure_slider.setPageStep(60 // _DEPARTURE_STEP_MIN)
        self.departure_slider.valueChanged.connect(self._departure_slid)
        self.departure_slider.sliderReleased.connect(self.departure_settled)
        self.departure_name = QLabel(self.tr("&Leaves"), self)
        self.departure_name.setObjectName("fieldName")
        self.departure_name.setBuddy(self.departure_slider)
        self.departure_label = ElidedLabel(self, sample=_SAMPLE)

    def _make_time(self) -> None:
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
        self.strip = DaylightStrip(self)
        self.label = ElidedLabel(self, sample=_SAMPLE)
        self.label.setFont(scaled_font(self.font(), 1.0, bold=True))

    def _lay_out(self) -> None:
        for slider in (self.slider, self.departure_slider):
            slider.setMinimumWidth(_SLIDER_PX)
        for label in (self.label, self.departure_label):
            label.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        layout = QGridLayout(self)
        layout.setContentsMargins(12, 4, 14, 6)
        layout.setHorizontalSpacing(10)
        layout.setVerticalSpacing(0)
        layout.setColumnStretch(1, 1)
        layout.addWidget(self.departure_name, 0, 0)
        layout.addWidget(self.departure_slider, 0, 1)
        layout.addWidget(self.departure_label, 0, 2)
        layout.addWidget(self.play_button, 1, 0, 2, 1, Qt.AlignmentFlag.AlignRight)
        layout.addWidget(self.slider, 1, 1)
        layout.addWidget(self.label, 1, 2, 2, 1)
        layout.addWidget(self.strip, 2, 1)

    # --- departure ----------------------------------------------------------------------------------

    def set_horizon(self, horizon: Horizon | None) -> None:
        """Let the departure be dragged over the hours of a forecast; ``None`` while they are not known."""
        known = horizon is not None
        for widget in (self.departure_name, self.departure_slider, self.departure_label):
            widget.setEnabled(known)
        if horizon is None:
            self.departure_label.say("")
            return
        kept = self.departure
        self._first = horizon.first.astimezone(UTC)
        steps = int((horizon.last - horizon.first).total_seconds() // (60 * _DEPARTURE_STEP_MIN))
        self.departure_slider.blockSignals(True)
        self.departure_slider.setRange(0, max(steps, 1))
        self.departure_slider.blockSignals(False)
        self.set_departure(kept)

    @property
    def departure(self) -> datetime:
        """Where the departure's slider is, UTC."""
        return self._first + timedelta(minutes=_DEPARTURE_STEP_MIN * self.departure_slider.value())

    def set_departure(self, moment: datetime) -> None:
        """Show a departure that was chosen elsewhere."""
        steps = round((moment - self._first).total_seconds() / 60.0 / _DEPARTURE_STEP_MIN)
        self.departure_slider.blockSignals(True)
        self.departure_slider.setValue(steps)
        self.departure_slider.blockSignals(False)
        if self.departure_slider.isEnabled():
            self._tell_departure(moment)

    def _tell_departure(self, moment: datetime) -> None:
        self._leaves = moment
        self.departure_label.say(week_moment(moment), short_moment(moment))

    def _tell_again(self) -> None:
        """Say both moments in the zone that was chosen."""
        if self.departure_slider.isEnabled():
            self._tell_departure(self._leaves)
        if self.slider.isEnabled():
            self._tell_time()

    def _departure_slid(self) -> None:
        self._tell_departure(self.departure)
        self.departure_moved.emit(self.departure)

    # --- time under way -----------------------------------------------------------------------------

    def set_span(self, begin: datetime | None, end: datetime | None) -> None:
        """Let the slider run between two moments from the first; nowhere while there is no passage."""
        self.play_button.setChecked(False)
        for widget in (self.play_button, self.slider, self.strip, self.label):
            widget.setEnabled(begin is not None and end is not None)
        if begin is None or end is None:
            self.slider.setRange(0, 0)
            self.label.say("")
            return
        self._begin = begin
        self.slider.setRange(0, _minutes(begin, end))
        self.slider.setValue(0)
        self._slid(0)

    def shift_span(self, begin: datetime, end: datetime) -> None:
        """Let the slider run between two other moments; it stays as far from departure as it is."""
        self._begin = begin
        self.slider.blockSignals(True)
        self.slider.setRange(0, _minutes(begin, end))
        self.slider.blockSignals(False)
        self._slid(self.slider.value())

    @property
    def moment(self) -> datetime:
        """Where the slider is, UTC."""
        return self._begin + timedelta(minutes=self.slider.value())

    def set_moment(self, moment: datetime) -> None:
        """Move the slider."""
        self.slider.setValue(round((moment - self._begin).total_seconds() / 60.0))

    def _slid(self, minutes: int) -> None:
        del minutes
        self._tell_time()
        self.moved.emit(self.moment)

    def _tell_time(self) -> None:
        hours, rest = divmod(self.slider.value(), 60)
        under_way = self.tr("+{hours} h {minutes:02d}").format(hours=hours, minutes=rest)
        whole, brief = week_moment(self.moment), short_moment(self.moment)
        self.label.say(f"{whole}  {under_way}", f"{brief}  {under_way}", brief)

    def _play(self, on: bool) -> None:
        show_icon(self.play_button, "pause" if on else "play")
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


def _minutes(begin: datetime, end: datetime) -> int:
    return max(1, round((end - begin).total_seconds() / 60.0))
