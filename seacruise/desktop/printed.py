"""The passage plan on paper in the window's language; times stay UTC, distances nautical miles."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication, QLocale

from seacruise.desktop.language import sentence

if TYPE_CHECKING:
    from datetime import datetime

    from seacruise.export.words import Words
    from seacruise.narrative import Amount, Phrase

TEXTS: Final = (
    QT_TRANSLATE_NOOP("paper", "Yacht"),
    QT_TRANSLATE_NOOP("paper", "From"),
    QT_TRANSLATE_NOOP("paper", "To"),
    QT_TRANSLATE_NOOP("paper", "Departure"),
    QT_TRANSLATE_NOOP("paper", "Arrival"),
    QT_TRANSLATE_NOOP("paper", "Distance"),
    QT_TRANSLATE_NOOP("paper", "{sailed:.1f} nm, {direct:.1f} nm direct"),
    QT_TRANSLATE_NOOP("paper", "Mean speed"),
    QT_TRANSLATE_NOOP("paper", "{speed:.1f} kn"),
    QT_TRANSLATE_NOOP("paper", "{speed:.0f} kn"),
    QT_TRANSLATE_NOOP("paper", "nm"),
    QT_TRANSLATE_NOOP("paper", "Strongest wind"),
    QT_TRANSLATE_NOOP("paper", "Manoeuvres"),
    QT_TRANSLATE_NOOP("paper", "tacks {tacks}, gybes {gybes}, course changes {changes}"),
    QT_TRANSLATE_NOOP("paper", "At night"),
    QT_TRANSLATE_NOOP("paper", "Lower bound"),
    QT_TRANSLATE_NOOP("paper", "Sailed again"),
    QT_TRANSLATE_NOOP("paper", "clear of land"),
    QT_TRANSLATE_NOOP("paper", "CROSSES LAND"),
    QT_TRANSLATE_NOOP("paper", "CROSSES A ZONE"),
    QT_TRANSLATE_NOOP("paper", "within limits"),
    QT_TRANSLATE_NOOP("paper", "BEYOND A LIMIT"),
    QT_TRANSLATE_NOOP("paper", "Engine"),
    QT_TRANSLATE_NOOP("paper", "{hours}, {litres:.0f} l of fuel"),
    QT_TRANSLATE_NOOP("paper", "Turning"),
    QT_TRANSLATE_NOOP("paper", "{hours} for manoeuvres"),
    QT_TRANSLATE_NOOP("paper", "Held wind"),
    QT_TRANSLATE_NOOP("paper", "Fading wind"),
    QT_TRANSLATE_NOOP("paper", "{hours} beyond the forecast"),
    QT_TRANSLATE_NOOP("paper", ", {distance:.1f} nm from the harbour"),
    QT_TRANSLATE_NOOP("paper", "When this wind was issued is not known."),
    QT_TRANSLATE_NOOP("paper", "The wind is of {when} UTC."),
    QT_TRANSLATE_NOOP("paper", "The wind is of {when} UTC, {hours:.0f} h before departure."),
    QT_TRANSLATE_NOOP("paper", "Notices (continued)"),
    QT_TRANSLATE_NOOP("paper", "Wind: {source}"),
    QT_TRANSLATE_NOOP("paper", ", issued {when} UTC"),
    QT_TRANSLATE_NOOP("paper", "{begin} to {end} UTC"),
    QT_TRANSLATE_NOOP(
        "paper", "Coast: (c) OpenStreetMap contributors, ODbL; beyond the Baltic to 2 km. Polar: {yacht}."
    ),
    QT_TRANSLATE_NOOP(
        "paper", "Not a navigation chart. A planning aid: check every leg on official charts before sailing."
    ),
    QT_TRANSLATE_NOOP("paper", "Page {number} of {count}"),
    QT_TRANSLATE_NOOP("paper", "Barbs: {when} UTC"),
    QT_TRANSLATE_NOOP("paper", "under engine"),
    QT_TRANSLATE_NOOP("paper", "True wind [kn]"),
    QT_TRANSLATE_NOOP("paper", "Boat speed [kn]"),
    QT_TRANSLATE_NOOP("paper", "Wind angle [°]"),
    QT_TRANSLATE_NOOP("paper", "Waves [m]"),
    QT_TRANSLATE_NOOP("paper", "gusts"),
    QT_TRANSLATE_NOOP("paper", "engine"),
    QT_TRANSLATE_NOOP("paper", "beyond the forecast"),
    QT_TRANSLATE_NOOP("paper", "Weather along the passage"),
    QT_TRANSLATE_NOOP(
        "paper",
        "Shaded: sun more than 6° below the horizon. Hatched: beyond the end of the forecast. "
        "Dotted: angle of the true wind.",
    ),
    QT_TRANSLATE_NOOP("paper", "Legs"),
    QT_TRANSLATE_NOOP("paper", "Legs (continued)"),
    QT_TRANSLATE_NOOP("paper", "Log (UTC)"),
    QT_TRANSLATE_NOOP("paper", "Log (UTC, continued)"),
    QT_TRANSLATE_NOOP("paper", "and {n} smaller changes of course and wind"),
    QT_TRANSLATE_NOOP("paper", "No"),
    QT_TRANSLATE_NOOP("paper", "Time (UTC)"),
    QT_TRANSLATE_NOOP("paper", "Position"),
    QT_TRANSLATE_NOOP("paper", "Steer"),
    QT_TRANSLATE_NOOP("paper", "Course"),
    QT_TRANSLATE_NOOP("paper", "Dist nm"),
    QT_TRANSLATE_NOOP("paper", "Speed kn"),
    QT_TRANSLATE_NOOP("paper", "TWS kn"),
    QT_TRANSLATE_NOOP("paper", "TWD"),
    QT_TRANSLATE_NOOP("paper", "TWA"),
    QT_TRANSLATE_NOOP("paper", "Tack"),
    QT_TRANSLATE_NOOP("paper", "port"),
    QT_TRANSLATE_NOOP("paper", "starboard"),
    QT_TRANSLATE_NOOP("paper", "both"),
    QT_TRANSLATE_NOOP("paper", "Mon"),
    QT_TRANSLATE_NOOP("paper", "Tue"),
    QT_TRANSLATE_NOOP("paper", "Wed"),
    QT_TRANSLATE_NOOP("paper", "Thu"),
    QT_TRANSLATE_NOOP("paper", "Fri"),
    QT_TRANSLATE_NOOP("paper", "Sat"),
    QT_TRANSLATE_NOOP("paper", "Sun"),
    QT_TRANSLATE_NOOP("paper", "Jan"),
    QT_TRANSLATE_NOOP("paper", "Feb"),
    QT_TRANSLATE_NOOP("paper", "Mar"),
    QT_TRANSLATE_NOOP("paper", "Apr"),
    QT_TRANSLATE_NOOP("paper", "May"),
    QT_TRANSLATE_NOOP("paper", "Jun"),
    QT_TRANSLATE_NOOP("paper", "Jul"),
    QT_TRANSLATE_NOOP("paper", "Aug"),
    QT_TRANSLATE_NOOP("paper", "Sep"),
    QT_TRANSLATE_NOOP("paper", "Oct"),
    QT_TRANSLATE_NOOP("paper", "Nov"),
    QT_TRANSLATE_NOOP("paper", "Dec"),
)
"""All that the sheet says by itself, for the tools that collect words; a test holds the two together."""

# Other names for Qt's function where the text is no literal: the literals are those above.
_translate: Final = QCoreApplication.translate


def paper_words() -> Words:
    """Give the words of a sheet in the window's language; may be asked for and used beside the window."""
    from seacruise.export.words import Words

    return Words(say=_say, sentence=sentence, tell=_tell, point=QLocale().decimalPoint())


def _say(text: str) -> str:
    return _translate("paper", text)


def _tell(phrase: Phrase) -> str:
    from seacruise.desktop.log_words import in_language
    from seacruise.export.logform import say, show_plain

    def show(value: Amount | datetime) -> str:
        text = show_plain(value).replace(".", QLocale().decimalPoint())
        figure, _, unit = text.rpartition(" ")
        return f"{figure} {_translate('units', unit)}" if unit in {"kn", "nm", "m"} else text

    return say(phrase, translate=in_language, show=show)
