"""The log of a passage in English: for the terminal and the PDF, and what the window falls back on."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import datetime
from typing import TYPE_CHECKING

from seacruise.export.textform import format_course, format_day_time, format_duration
from seacruise.phrases import Amount, Phrase

if TYPE_CHECKING:
    from seacruise.narrative import Entry

Translate = Callable[[Phrase], str]
Show = Callable[[Amount | datetime], str]


def say(phrase: Phrase, *, translate: Translate | None = None, show: Show | None = None) -> str:
    """Write a phrase with its gaps filled.

    Parameters
    ----------
    translate
        Gives the text of a phrase, its gaps still open, in another language.
    show
        Writes a figure or a moment in other units.
    """
    text = phrase.text if translate is None else translate(phrase)
    write = show or show_plain

    def part(value: str | int | datetime | Amount | Phrase) -> str:
        if isinstance(value, Phrase):
            return say(value, translate=translate, show=show)
        return write(value) if isinstance(value, Amount | datetime) else str(value)

    said = text.format(**{name: part(value) for name, value in phrase.parts})
    # The full stop of an abbreviated unit is that of the sentence, too.
    return said[:-1] if said.endswith("..") else said


def show_plain(value: Amount | datetime) -> str:
    """Write a figure in knots, nautical miles, metres and degrees; of a moment hour and minute, UTC."""
    if isinstance(value, datetime):
        return format_day_time(value)[-5:]
    if value.quantity == "hours":
        return format_duration(value.value)
    if value.quantity == "course":
        return format_course(value.value)
    decimals, unit = {
        "wind": (0, "kn"),
        "speed": (1, "kn"),
        "distance": (1, "nm"),
        "height": (1, "m"),
    }[value.quantity]
    return f"{value.value:.{decimals}f} {unit}"


def entry_time(entry: Entry) -> str:
    """Day and time of an entry, UTC: ``Thu 21:40``."""
    text = format_day_time(entry.time)
    return f"{text[:3]} {text[-5:]}"


def log_lines(entries: Sequence[Entry]) -> list[str]:
    """One line an entry: ``Thu 21:40  Off Hoburgen, 3.1 nm to port; 14 kn on the port quarter.``."""
    return [f"{entry_time(entry)}  {say(entry.phrase)}" for entry in entries]


def log_to_text(entries: Sequence[Entry]) -> str:
    """Log for a terminal, below a heading."""
    return "\n".join(["Log (UTC)", *(f"  {line}" for line in log_lines(entries))])
