"""The log of a passage in the window's language and in the units that the sailor chose."""

from __future__ import annotations

from datetime import datetime
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication, QDate, QLocale

from seacruise.desktop.units_choice import clock_text, distance_text, height_text, in_zone, wind_text
from seacruise.export.logform import say, show_plain
from seacruise.export.textform import to_minute
from seacruise.phrases import Amount, Phrase

if TYPE_CHECKING:
    from seacruise.narrative import Entry

SENTENCES: Final = (
    QT_TRANSLATE_NOOP("narrative", "Waits {hours} in {place}, until what is not allowed has passed."),
    QT_TRANSLATE_NOOP("narrative", "Leaves {place}; {how}."),
    QT_TRANSLATE_NOOP("narrative", "Leaves {place} under engine; {how}."),
    QT_TRANSLATE_NOOP("narrative", "Off {place}, {distance} to port; {how}."),
    QT_TRANSLATE_NOOP("narrative", "Off {place}, {distance} to starboard; {how}."),
    QT_TRANSLATE_NOOP("narrative", "Passes close to {place}; {how}."),
    QT_TRANSLATE_NOOP("narrative", "Rounds {place}, {distance} to port; {how}."),
    QT_TRANSLATE_NOOP("narrative", "Rounds {place}, {distance} to starboard; {how}."),
    QT_TRANSLATE_NOOP("narrative", "Tacks to {course}; {how}."),
    QT_TRANSLATE_NOOP("narrative", "Gybes to {course}; {how}."),
    QT_TRANSLATE_NOOP("narrative", "Begins to beat; {turns} until {time}, {wind}."),
    QT_TRANSLATE_NOOP("narrative", "Begins to run before the wind; {turns} until {time}, {wind}."),
    QT_TRANSLATE_NOOP("narrative", "Heads up to {course}; {how}."),
    QT_TRANSLATE_NOOP("narrative", "Bears away to {course}; {how}."),
    QT_TRANSLATE_NOOP("narrative", "The wind veers; {how}."),
    QT_TRANSLATE_NOOP("narrative", "The wind backs; {how}."),
    QT_TRANSLATE_NOOP("narrative", "The wind rises to force {force}; {how}."),
    QT_TRANSLATE_NOOP("narrative", "The wind drops to force {force}; {how}."),
    QT_TRANSLATE_NOOP("narrative", "Strongest wind of the passage; {how}."),
    QT_TRANSLATE_NOOP("narrative", "Strongest wind of the passage, with gusts of {gusts}; {how}."),
    QT_TRANSLATE_NOOP("narrative", "Highest waves of the passage, {height}."),
    QT_TRANSLATE_NOOP("narrative", "Strongest current of the passage, {speed} setting {course}."),
    QT_TRANSLATE_NOOP("narrative", "Sunrise; {how}."),
    QT_TRANSLATE_NOOP("narrative", "Sunset; {how}."),
    QT_TRANSLATE_NOOP("narrative", "Starts the engine; {how}."),
    QT_TRANSLATE_NOOP("narrative", "Stops the engine; {how}."),
    QT_TRANSLATE_NOOP("narrative", "The forecast ends; from here on its last wind is held."),
    QT_TRANSLATE_NOOP("narrative", "The forecast ends; from here on its last wind fades to the usual."),
    QT_TRANSLATE_NOOP("narrative", "Arrives in {place} after {hours} and {distance}."),
    QT_TRANSLATE_NOOP("narrative", "calm"),
    QT_TRANSLATE_NOOP("narrative", "{wind} from ahead"),
    QT_TRANSLATE_NOOP("narrative", "{wind} on the port bow"),
    QT_TRANSLATE_NOOP("narrative", "{wind} on the starboard bow"),
    QT_TRANSLATE_NOOP("narrative", "{wind}, close-hauled on port tack"),
    QT_TRANSLATE_NOOP("narrative", "{wind}, close-hauled on starboard tack"),
    QT_TRANSLATE_NOOP("narrative", "{wind} forward of the port beam"),
    QT_TRANSLATE_NOOP("narrative", "{wind} forward of the starboard beam"),
    QT_TRANSLATE_NOOP("narrative", "{wind} on the port beam"),
    QT_TRANSLATE_NOOP("narrative", "{wind} on the starboard beam"),
    QT_TRANSLATE_NOOP("narrative", "{wind} on the port quarter"),
    QT_TRANSLATE_NOOP("narrative", "{wind} on the starboard quarter"),
    QT_TRANSLATE_NOOP("narrative", "{wind} from dead astern"),
    QT_TRANSLATE_NOOP("narrative", "{wind}, beating in narrow water"),
    QT_TRANSLATE_NOOP("narrative", "{wind}, running in narrow water"),
)
"""What `seacruise.phrases` says, for the tools that collect words; a test holds the two together."""

# The collector wants literals, and finds them above; what is translated is known here only when it is said.
_translate: Final = QCoreApplication.translate


def entry_text(entry: Entry) -> str:
    """Sentence of an entry."""
    return say(entry.phrase, translate=in_language, show=_in_units)


def entry_time(entry: Entry) -> str:
    """Day and time of an entry in the chosen zone: ``Thu 21:40``."""
    return day_and_time(entry.time)


def day_and_time(moment: datetime) -> str:
    """Day of the week and time of a moment in the chosen zone: ``Thu 21:40``."""
    minute = to_minute(moment)
    local = in_zone(minute)
    day = QLocale().toString(QDate(local.year, local.month, local.day), "ddd")
    return f"{day} {clock_text(minute)}"


def in_language(phrase: Phrase) -> str:
    """Give the text of a phrase in the window's language, its gaps still open."""
    n = phrase.count
    if n is None:
        return _translate("narrative", phrase.text)
    counted = {
        "{n} tacks": QCoreApplication.translate("narrative", "%n tack(s)", "", n),
        "{n} gybes": QCoreApplication.translate("narrative", "%n gybe(s)", "", n),
    }
    return counted[phrase.text]


def _in_units(value: Amount | datetime) -> str:
    if isinstance(value, datetime):
        return clock_text(to_minute(value))
    if value.quantity == "wind":
        return wind_text(value.value)
    if value.quantity == "distance":
        return distance_text(value.value)
    if value.quantity == "height":
        return height_text(value.value)
    return show_plain(value)
