"""The words of printed sheets: English by themselves, another language when the window passes it in."""

from __future__ import annotations

import string
from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime
from typing import Any, Final

from seacruise.export import logform
from seacruise.export.textform import format_day_time
from seacruise.narrative import Phrase


class _Formatter(string.Formatter):
    def __init__(self, point: str) -> None:
        self._point = point

    def format_field(self, value: Any, format_spec: str) -> Any:
        text = str(format(value, format_spec))
        return text.replace(".", self._point) if isinstance(value, float) else text


@dataclass(frozen=True, slots=True)
class Words:
    """How a sheet speaks.

    Attributes
    ----------
    say
        Gives a text of the sheet, its gaps open, in the language of the sheet.
    sentence
        The same for the sentences of notices, and for where a wind is from.
    tell
        Writes an entry of the log.
    point
        The decimal sign.
    """

    say: Callable[[str], str] = str
    sentence: Callable[[str], str] = str
    tell: Callable[[Phrase], str] = logform.say
    point: str = "."

    def fill(self, text: str, /, **values: object) -> str:
        """Say a text with its gaps filled; of numbers with decimals the sign is that of the language."""
        return _Formatter(self.point).vformat(self.say(text), (), values)

    def day_time(self, time: datetime, *, year: bool = True) -> str:
        """Write a time, UTC: ``Sun 20 Nov 2016 06:00``."""
        day, date, month, full, clock = format_day_time(time).split()
        parts = [self.say(day), date, self.say(month), *([full] if year else []), clock]
        return " ".join(parts)

    def clock(self, time: datetime) -> str:
        """Write weekday and time, UTC: ``Sun 06:00``."""
        day, *_, clock = format_day_time(time).split()
        return f"{self.say(day)} {clock}"


ENGLISH: Final = Words()

DAYS: Final = ("Mon", "Tue", "Wed", "Thu", "Fri", "Sat", "Sun")
MONTHS: Final = ("Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec")
