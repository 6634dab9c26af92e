"""The line below: where the wind is from, what is left of a quota, and what is under the pointer."""

from __future__ import annotations

from datetime import UTC, datetime

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QLabel, QStatusBar

from seacruise.desktop.compute import Answer
from seacruise.desktop.messages import age_h, format_age, is_forecast
from seacruise.desktop.readout import from_start_text, wind_text
from seacruise.geodesy import format_position

_SAMPLE = "00°00.0'N 000°00.0'E   wind 000° 00 kn   000.0 nm 000° from Gdynia"


class StatusLine(QObject):
    """Labels of a status bar."""

    def __init__(self, bar: QStatusBar) -> None:
        super().__init__(bar)
        self._bar = bar
        self._answer: Answer | None = None
        self._time = 0.0
        self.source, self.quota, self.position = QLabel(), QLabel(), QLabel()
        self.position.setMinimumWidth(self.position.fontMetrics().horizontalAdvance(_SAMPLE))
        self.source.setAccessibleName(self.tr("Source of the wind"))
        self.position.setAccessibleName(self.tr("Position, wind and distance at the pointer"))
        self.source.setText(self.tr("No wind loaded yet"))
        bar.addWidget(self.source)
        for label in (self.quota, self.position):
            bar.addPermanentWidget(label)
        bar.setSizeGripEnabled(False)

    def show_answer(self, answer: Answer) -> None:
        """Tell the source of a passage's wind; the read-out is of that wind from now on."""
        self._answer = answer
        forecast = answer.passage.forecast
        age = ""
        if forecast.issued is not None and is_forecast(forecast):
            age = self.tr(", {age} old").format(age=format_age(age_h(forecast.issued, datetime.now(UTC))))
        self.source.setText(self.tr("Wind: {source}").format(source=forecast.source) + age)

    def show_time(self, moment: datetime) -> None:
        """Read the wind at another time from now on."""
        self._time = moment.timestamp()

    def show_quota(self, quota: tuple[int, int] | None) -> None:
        """Tell the requests that are left today, of how many; ``None`` where there is no key."""
        text = ""
        if quota is not None:
            text = self.tr("Storm Glass: {left} of {daily} requests left today").format(
                left=quota[0], daily=quota[1]
            )
        self.quota.setText(text)

    def point(self, lat: float, lon: float) -> None:
        """Tell position, wind, and distance and bearing from the start."""
        parts = [format_position(lat, lon)]
        if self._answer is not None:
            start = self._answer.passage.start
            parts += [
                wind_text(self._answer.wind, self._time, lat, lon),
                from_start_text(start.name, (start.lat, start.lon), lat, lon),
            ]
        self.position.setText("   ".join(filter(None, parts)))

    def say(self, text: str, seconds: float) -> None:
        """Say something for a while."""
        self._bar.showMessage(text, round(1000 * seconds))
