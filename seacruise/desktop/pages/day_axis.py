"""An axis of time by the clock that is shown: where its days and even hours are, and their words.

Moments are hours since 1970.
"""

from __future__ import annotations

import math
from datetime import UTC, datetime

from PySide6.QtCore import QDate, QLocale

from seacruise.desktop.pages.plot import HOURS_PER_DAY, ticks_h
from seacruise.desktop.units_choice import in_zone
from seacruise.units import SECONDS_PER_HOUR


def moment_at(hours: float) -> datetime:
    """Give a moment by the clock that is shown."""
    return in_zone(datetime.fromtimestamp(hours * SECONDS_PER_HOUR, UTC))


def _zone_h(hours: float) -> float:
    """How far the clock that is shown is ahead of UTC [h]."""
    offset = moment_at(hours).utcoffset()
    return offset.total_seconds() / SECONDS_PER_HOUR if offset else 0.0


def ticks_of_day(low: float, high: float, most: int) -> list[float]:
    """Even hours of the clock that is shown, as hours since 1970."""
    ahead = _zone_h(low)
    return [tick - ahead for tick in ticks_h(low + ahead, high + ahead, most)]


def midnights(low: float, high: float) -> list[float]:
    """Beginnings of the days, as hours since 1970."""
    ahead = _zone_h(low)
    first, last = math.ceil((low + ahead) / HOURS_PER_DAY), math.floor((high + ahead) / HOURS_PER_DAY)
    return [HOURS_PER_DAY * k - ahead for k in range(first, last + 1)]


def day_text(hours: float, pattern: str) -> str:
    """Write the day of a moment in the words of the window."""
    local = moment_at(hours)
    return QLocale().toString(QDate(local.year, local.month, local.day), pattern)


def day_clock(hours: float) -> str:
    """Write a moment of the axis of arrivals: ``Wed 06:00``."""
    return f"{day_text(hours, 'ddd')} {moment_at(hours):%H:%M}"
