"""The line below: where the wind is from, what is left of a quota, and what is under the pointer."""

from __future__ import annotations

from collections.abc import Callable
from datetime import UTC, datetime
from typing import Final

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QStatusBar

from seacruise.desktop.chart.depth_layer import band_text
from seacruise.desktop.compute import Answer
from seacruise.desktop.elided import ElidedLabel
from seacruise.desktop.language import sentence
from seacruise.desktop.messages import age_h, format_age, is_forecast
from seacruise.desktop.readout import from_start_text, wind_text
from seacruise.desktop.units_choice import units_choice
from seacruise.geodesy import format_position

_SAMPLE: Final = (
    "00°00.0'N 000°00.0'E   wind 000° 00.0 m/s   0000.0 km 000° from Gdynia   tint about 100–200 m (coarse)"
)


class StatusLine(QObject):
    """Labels of a status bar.

    Parameters
    ----------
    band_at
        Tells the band of depth with which the chart is tinted at a position [degrees], if it is.
    """

    def __init__(
        self, bar: QStatusBar, band_at: Callable[[float, float], int | None] = lambda _lat, _lon: None
    ) -> None:
        super().__init__(bar)
        self._bar, self._band_at = bar, band_at
        self._answer: Answer | None = None
        self._time = 0.0
        self._pointed: tuple[float, float] | None = None
        self.source, self.quota = ElidedLabel(), ElidedLabel()
        self.position = ElidedLabel(sample=_SAMPLE)
        self.source.setAccessibleName(self.tr("Source of the wind"))
        self.position.setAccessibleName(self.tr("Position, wind and distance at the pointer"))
        self.quota.setAccessibleName(self.tr("Requests left today"))
        self.source.say(self.tr("No wind loaded yet"))
        bar.addWidget(self.source)
        for label in (self.quota, self.position):
            bar.addPermanentWidget(label)
        bar.setSizeGripEnabled(False)
        # Where nothing is pointed at, the source has the whole line.
        self.position.hide()
        units_choice().changed.connect(self._point_again)

    def show_answer(self, answer: Answer) -> None:
        """Tell the source of a passage's wind; the read-out is of that wind from now on."""
        self._answer = answer
        forecast = answer.passage.forecast
        age = ""
        if forecast.issued is not None and is_forecast(forecast):
            age = self.tr(", {age} old").format(age=format_age(age_h(forecast.issued, datetime.now(UTC))))
        self.source.say(self.tr("Wind: {source}").format(source=sentence(forecast.source)) + age)

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
        self.quota.say(text)

    def point(self, lat: float, lon: float) -> None:
        """Tell position, wind, and distance and bearing from the start."""
        self._pointed = (lat, lon)
        parts = [format_position(lat, lon)]
        if self._answer is not None:
            start = self._answer.passage.start
            parts += [
                wind_text(self._answer.wind, self._time, lat, lon),
                from_start_text(start.name, (start.lat, start.lon), lat, lon),
            ]
        band = self._band_at(lat, lon)
        tints = ("", "") if band is None else (band_text(band), band_text(band, brief=True))
        # Where there is little room the place from which the distance is counted is known anyway.
        forms = ((*parts, tints[0]), (*parts[:2], tints[1]))
        self.position.show()
        self.position.say(*("   ".join(part for part in form if part) for form in forms))

    def clear_position(self) -> None:
        """Say nothing of a position: the pointer is elsewhere."""
        self._pointed = None
        self.position.say("")
        self.position.hide()

    def _point_again(self) -> None:
        if self._pointed is not None:
            self.point(*self._pointed)

    def say(self, text: str, seconds: float) -> None:
        """Say something for a while."""
        self._bar.showMessage(text, round(1000 * seconds))
