"""What a log says, as data: sentences in English with gaps, and what belongs into them.

Whoever shows a `Phrase` fills its gaps in units of his choice, and may translate its text first: each text
stands alone, so that another language can put its words into their own order and case.
"""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime
from typing import Final, Literal


@dataclass(frozen=True, slots=True)
class Amount:
    """A figure with its meaning, so that whoever shows it chooses unit and digits.

    Attributes
    ----------
    quantity
        ``wind`` and ``speed`` (of boat or water) are in knots, ``distance`` in nautical miles, ``hours`` in
        hours, ``course`` in degrees true, ``height`` in metres.
    """

    quantity: Literal["wind", "speed", "distance", "hours", "course", "height"]
    value: float


@dataclass(frozen=True, slots=True)
class Phrase:
    """A sentence, or a part of one: an English text with gaps such as ``{place}``, and what they hold.

    Attributes
    ----------
    text
        The English, one of `TEMPLATES`: what is translated.
    parts
        Name of each gap and what belongs into it; moments are timezone-aware.
    count
        The number that decides the plural, where there is one.
    """

    text: str
    parts: tuple[tuple[str, str | int | datetime | Amount | Phrase], ...] = ()
    count: int | None = None


POINT_LIMITS_DEG: Final = (55.0, 80.0, 100.0, 155.0)
"""Where close-hauled, close reach, beam reach, broad reach and run meet [degrees of true wind angle]."""

HOW: Final = {
    "calm": ("calm", "calm"),
    "ahead": ("{wind} from ahead", "{wind} from ahead"),
    "bow": ("{wind} on the port bow", "{wind} on the starboard bow"),
    "close": ("{wind}, close-hauled on port tack", "{wind}, close-hauled on starboard tack"),
    "fetch": ("{wind} forward of the port beam", "{wind} forward of the starboard beam"),
    "beam": ("{wind} on the port beam", "{wind} on the starboard beam"),
    "quarter": ("{wind} on the port quarter", "{wind} on the starboard quarter"),
    "astern": ("{wind} from dead astern", "{wind} from dead astern"),
    "beating": ("{wind}, beating in narrow water", "{wind}, beating in narrow water"),
    "running": ("{wind}, running in narrow water", "{wind}, running in narrow water"),
}
"""Wind and where it comes from, with the wind on the port and on the starboard side."""

SAID: Final[dict[str, str]] = {
    "waiting": "Waits {hours} in {place}, until what is not allowed has passed.",
    "departure": "Leaves {place}; {how}.",
    "departure-engine": "Leaves {place} under engine; {how}.",
    "passing-port": "Off {place}, {distance} to port; {how}.",
    "passing-starboard": "Off {place}, {distance} to starboard; {how}.",
    "passing-close": "Passes close to {place}; {how}.",
    "rounding-port": "Rounds {place}, {distance} to port; {how}.",
    "rounding-starboard": "Rounds {place}, {distance} to starboard; {how}.",
    "tack": "Tacks to {course}; {how}.",
    "gybe": "Gybes to {course}; {how}.",
    "beat": "Begins to beat; {turns} until {time}, {wind}.",
    "run": "Begins to run before the wind; {turns} until {time}, {wind}.",
    "tacks": "{n} tacks",
    "gybes": "{n} gybes",
    "heads-up": "Heads up to {course}; {how}.",
    "bears-away": "Bears away to {course}; {how}.",
    "veers": "The wind veers; {how}.",
    "backs": "The wind backs; {how}.",
    "wind-up": "The wind rises to force {force}; {how}.",
    "wind-down": "The wind drops to force {force}; {how}.",
    "strongest-wind": "Strongest wind of the passage; {how}.",
    "strongest-gusts": "Strongest wind of the passage, with gusts of {gusts}; {how}.",
    "waves": "Highest waves of the passage, {height}.",
    "current": "Strongest current of the passage, {speed} setting {course}.",
    "sunrise": "Sunrise; {how}.",
    "sunset": "Sunset; {how}.",
    "engine-on": "Starts the engine; {how}.",
    "engine-off": "Stops the engine; {how}.",
    "held": "The forecast ends; from here on its last wind is held.",
    "fading": "The forecast ends; from here on its last wind fades to the usual.",
    "arrival": "Arrives in {place} after {hours} and {distance}.",
}
"""The sentences, and the parts of them that are counted."""

TEMPLATES: Final = tuple(dict.fromkeys((*SAID.values(), *(text for pair in HOW.values() for text in pair))))
"""Every English text that a `Phrase` can have."""


def fill(key: str, **parts: str | int | datetime | Amount | Phrase) -> Phrase:
    """Make the sentence of a key of this module with what belongs into its gaps."""
    return Phrase(SAID[key], tuple(parts.items()))
