"""Day and hour of departure: the calendar offers the forecast's days; what is typed is never bent."""

from __future__ import annotations

from datetime import UTC, date, datetime, time, timedelta
from typing import Final

from PySide6.QtCore import QDate, QLocale, QPoint, QSize, Qt, QTime, Signal
from PySide6.QtGui import QPalette, QTextCharFormat
from PySide6.QtWidgets import (
    QCalendarWidget,
    QDateEdit,
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QTimeEdit,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from seacruise.desktop.banner import text_label
from seacruise.desktop.state import Horizon
from seacruise.desktop.style import show_icon
from seacruise.desktop.units_choice import (
    format_moment,
    from_zone,
    in_zone,
    moment_text,
    units_choice,
    zone_text,
)
from seacruise.errors import InputError

__all__ = ["DepartureField", "format_moment", "to_date"]


def to_date(day: QDate) -> date:
    """Python's date for Qt's."""
    return date(day.year(), day.month(), day.day())


_AROUND_DAYS: Final = 43
"""A page of the calendar has six weeks: so many days before and after the forecast may be seen."""


class DepartureField(QWidget):
    """Date, calendar and time; ``changed()`` when the sailor picks another moment.

    Qt's own calendar field would clamp a typed date to the range without a word. Here any date can be
    typed; one that the forecast does not cover is said to be so, and refused when it is computed.
    """

    changed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._horizon: Horizon | None = None
        self._chosen = False
        self._filling = False
        self._moment = datetime(1970, 1, 1, tzinfo=UTC)
        self.date_edit = QDateEdit(self)
        self.date_edit.setDisplayFormat("ddd d MMM yyyy")
        self.date_edit.setDateRange(QDate(1900, 1, 1), QDate(2199, 12, 31))
        self.date_edit.setAccessibleName(self.tr("Date of departure"))
        self.calendar_button = QToolButton(self)
        show_icon(self.calendar_button, "calendar")
        self.calendar_button.setIconSize(QSize(18, 18))
        self.calendar_button.setAccessibleName(self.tr("Choose the date of departure in a calendar"))
        self.calendar_button.setToolTip(self.tr("Days that the forecast covers"))
        self.calendar_button.clicked.connect(self.open_calendar)
        self.time_edit = QTimeEdit(self)
        self.time_edit.setDisplayFormat("HH:mm")
        self.time_edit.setAccessibleName(self.tr("Time of departure"))
        self.time_edit.setMaximumWidth(92)
        for edit in (self.date_edit, self.time_edit):
            edit.lineEdit().setTextMargins(5, 0, 0, 0)
        self.range_label = text_label("", "hint", self)
        self._make_calendar()
        row = QHBoxLayout()
        row.setSpacing(6)
        row.addWidget(self.date_edit, 1)
        row.addWidget(self.calendar_button)
        row.addWidget(self.time_edit)
        layout = QGridLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setVerticalSpacing(4)
        layout.addLayout(row, 0, 0)
        layout.addWidget(self.range_label, 1, 0)
        self.setFocusProxy(self.date_edit)
        self.date_edit.dateChanged.connect(self._picked)
        self.time_edit.timeChanged.connect(self._picked)
        for edit in (self.date_edit, self.time_edit):
            # An hour that the clocks leave out in spring becomes the one that is meant by it.
            edit.editingFinished.connect(self._show_moment)
        units_choice().changed.connect(self._show_zone)
        # Until the forecast is known: the next full hour, not the day that Qt begins with.
        soon = datetime.now(UTC).replace(minute=0, second=0, microsecond=0) + timedelta(hours=1)
        self.set_moment(soon, chosen=False)

    def _make_calendar(self) -> None:
        self.popup = QFrame(self, Qt.WindowType.Popup)
        self.popup.setObjectName("card")
        self.calendar = QCalendarWidget(self.popup)
        self.calendar.setFirstDayOfWeek(QLocale().firstDayOfWeek())
        self.calendar.setVerticalHeaderFormat(QCalendarWidget.VerticalHeaderFormat.NoVerticalHeader)
        self.calendar.setGridVisible(False)
        self.calendar.activated.connect(self._picked_in_calendar)
        self.calendar.clicked.connect(self._picked_in_calendar)
        inner = QVBoxLayout(self.popup)
        inner.setContentsMargins(6, 6, 6, 6)
        inner.addWidget(self.calendar)

    # --- the moment ---------------------------------------------------------------------------------

    @property
    def moment(self) -> datetime:
        """What is in the field, UTC."""
        return self._moment

    @property
    def was_chosen(self) -> bool:
        """Whether the sailor chose the moment; else it follows the forecast."""
        return self._chosen

    @property
    def is_covered(self) -> bool:
        """Whether the forecast covers the moment, as far as that is known."""
        return self._horizon is None or self._horizon.covers(self.moment)

    def require_moment(self) -> datetime:
        """Give the moment, when the forecast covers it.

        Raises
        ------
        InputError
            It does not; the sentence tells the range.
        """
        if not self.is_covered:
            raise InputError(
                self.tr("The departure on {moment} is not within the forecast, which covers {range}.").format(
                    moment=moment_text(self.moment), range=self._range_text()
                ),
                reason="departure",
            )
        return self.moment

    def set_moment(self, moment: datetime, *, chosen: bool) -> None:
        """Fill in a moment; ``chosen`` by the sailor, it stays when the forecast changes."""
        self._moment = moment.astimezone(UTC).replace(second=0, microsecond=0)
        self._show_moment()
        self._chosen = chosen
        self._show_range()
        self.changed.emit()

    def _show_moment(self) -> None:
        shown = in_zone(self._moment)
        self._filling = True
        self.date_edit.setDate(QDate(shown.year, shown.month, shown.day))
        self.time_edit.setTime(QTime(shown.hour, shown.minute))
        self._filling = False

    def set_horizon(self, horizon: Horizon | None, now: datetime) -> None:
        """Take over what the forecast covers; ``None`` while that is not known."""
        self._horizon = horizon
        self.calendar_button.setEnabled(horizon is not None)
        if horizon is not None:
            self._offer_days(horizon)
            if not self._chosen:
                self.set_moment(horizon.default_departure(now), chosen=False)
        self._show_range()

    def use_first_hour(self, now: datetime) -> None:
        """Move to the first full hour that can be sailed, at once or when the forecast is known."""
        self._chosen = False
        if self._horizon is not None:
            self.set_moment(self._horizon.default_departure(now), chosen=False)

    # --- what is shown ------------------------------------------------------------------------------

    def _range_text(self) -> str:
        assert self._horizon is not None
        return self.tr("{first} to {last}").format(
            first=format_moment(self._horizon.first), last=moment_text(self._horizon.last)
        )

    def _show_zone(self) -> None:
        """Show the same moment in the zone that was chosen."""
        self._show_moment()
        if self._horizon is not None:
            self._offer_days(self._horizon)
        self._show_range()

    def _offer_days(self, horizon: Horizon) -> None:
        first, last = in_zone(horizon.first), in_zone(horizon.last)
        self.calendar.setDateRange(
            QDate(first.year, first.month, first.day), QDate(last.year, last.month, last.day)
        )

    def _show_range(self) -> None:
        wrong = not self.is_covered
        if self._horizon is None:
            text = zone_text(self.moment)
        elif wrong:
            text = self.tr("Not in the forecast, which covers {range}.").format(range=self._range_text())
        else:
            text = self.tr("{zone}. The forecast covers {range}.").format(
                zone=zone_text(self.moment), range=self._range_text()
            )
        if text != self.range_label.text():
            self.range_label.setText(text)
        self.range_label.setObjectName("fault" if wrong else "hint")
        if wrong == bool(self.range_label.property("wrong")):
            return
        for widget in (self.date_edit, self.time_edit, self.range_label):
            widget.setProperty("wrong", wrong)
            widget.style().unpolish(widget)
            widget.style().polish(widget)

    def _picked(self) -> None:
        if not self._filling:
            clock = self.time_edit.time()
            self._moment = from_zone(
                datetime.combine(to_date(self.date_edit.date()), time(clock.hour(), clock.minute()))
            )
            self._chosen = True
            self._show_range()
            self.changed.emit()

    def open_calendar(self) -> None:
        """Open the calendar under the field."""
        self._dress_days()
        self.calendar.setSelectedDate(self.date_edit.date())
        self.popup.adjustSize()
        below = self.date_edit.mapToGlobal(QPoint(0, self.date_edit.height() + 3))
        self.popup.move(below)
        self.popup.show()
        self.calendar.setFocus()

    def _dress_days(self) -> None:
        """Grey the days that cannot be chosen, and write weekends, red in Qt, as other days."""
        palette, plain, out = self.calendar.palette(), QTextCharFormat(), QTextCharFormat()
        plain.setForeground(palette.brush(QPalette.ColorGroup.Active, QPalette.ColorRole.Text))
        out.setForeground(palette.brush(QPalette.ColorGroup.Disabled, QPalette.ColorRole.Text))
        for weekday in (Qt.DayOfWeek.Saturday, Qt.DayOfWeek.Sunday):
            self.calendar.setWeekdayTextFormat(weekday, plain)
        self.calendar.setDateTextFormat(QDate(), QTextCharFormat())
        first, last = self.calendar.minimumDate(), self.calendar.maximumDate()
        for days in range(1, _AROUND_DAYS):
            self.calendar.setDateTextFormat(first.addDays(-days), out)
            self.calendar.setDateTextFormat(last.addDays(days), out)

    def _picked_in_calendar(self, day: QDate) -> None:
        self.popup.hide()
        self.date_edit.setDate(day)
        self.date_edit.setFocus()
