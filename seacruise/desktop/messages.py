"""What is said to the sailor when something is in the way: a title, one sentence, and a way out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from enum import Enum
from typing import TYPE_CHECKING, Final, Literal

from PySide6.QtCore import QCoreApplication

from seacruise.desktop.state import Phase
from seacruise.errors import NoPassageError

if TYPE_CHECKING:
    from seacruise.desktop.state import WindowState
    from seacruise.errors import SeaCruiseError
    from seacruise.passage import Passage
    from seacruise.weather.wind import Forecast

STALE_H: Final = 12.0
"""Age of a forecast that is worth a warning [h]: services compute a new one every six hours."""


class WayOut(Enum):
    """What the window can do for the sailor about a trouble."""

    NOTHING = ""
    RETRY = "retry"
    PRACTICE = "practice"
    DEPARTURE = "departure"
    SHOW_PLACE = "show-place"
    ENGINE = "engine"
    WEATHER = "weather"
    OPTIONS = "options"
    FORM = "form"
    ABOUT = "about"


@dataclass(frozen=True, slots=True)
class Message:
    """A banner: ``sentence`` says what was wrong and where, ``advice`` what to do.

    Attributes
    ----------
    way_out, other
        What its buttons do; ``other`` is the second choice.
    brief
        Its title is enough, and its first sentence where it has none; all of it is told to who points at it.
    """

    kind: Literal["info", "warning", "error"]
    title: str
    sentence: str
    advice: str = ""
    way_out: WayOut = WayOut.NOTHING
    other: WayOut = WayOut.NOTHING
    brief: bool = False


def tr(text: str) -> str:
    """Translate a text of this module."""
    return QCoreApplication.translate("messages", text)


_Known = tuple[str, str, WayOut, WayOut]


def _known() -> dict[str, _Known]:
    """Title, advice, and two ways out by the reason of an error."""
    return _of_the_passage() | _of_the_weather() | _of_the_program()


def _of_the_passage() -> dict[str, _Known]:
    return {
        "same-port": (
            tr("Start and end are the same"),
            tr("Type another destination, or use right-click on the chart."),
            WayOut.FORM,
            WayOut.NOTHING,
        ),
        "departure": (
            tr("The forecast does not cover this departure"),
            "",
            WayOut.DEPARTURE,
            WayOut.WEATHER,
        ),
        "becalmed": (
            tr("No passage: becalmed"),
            tr("Leave at another time, or let the engine help in light wind."),
            WayOut.ENGINE,
            WayOut.NOTHING,
        ),
        "no-water-path": (
            tr("No passage: no way by water"),
            tr("Choose a neighbouring port, or a position in open water."),
            WayOut.SHOW_PLACE,
            WayOut.FORM,
        ),
        "wind-limit": (
            tr("No passage: too much wind"),
            tr("Raise your limit of wind if the crew can stand it, or leave at another time."),
            WayOut.SHOW_PLACE,
            WayOut.OPTIONS,
        ),
        "dead-angle": (
            tr("No passage: dead against the wind"),
            tr("Allow tacking, or leave at another time."),
            WayOut.SHOW_PLACE,
            WayOut.OPTIONS,
        ),
        "closed-zone": (
            tr("No passage: a closed area"),
            tr("Leave when it is open, or take it off the chart: right-click on it, or Ctrl+Z."),
            WayOut.SHOW_PLACE,
            WayOut.NOTHING,
        ),
        "outside-forecast": (
            tr("No passage: outside the forecast"),
            tr("Choose ports and a departure that the forecast covers."),
            WayOut.DEPARTURE,
            WayOut.WEATHER,
        ),
    }


def _of_the_weather() -> dict[str, _Known]:
    return {
        "no-network": (
            tr("No connection to the weather service"),
            tr("Check the network and try again; until then there is practice weather."),
            WayOut.RETRY,
            WayOut.PRACTICE,
        ),
        "timeout": (
            tr("The weather service does not answer"),
            tr("Try again in a moment; until then there is practice weather."),
            WayOut.RETRY,
            WayOut.PRACTICE,
        ),
        "no-key": (
            tr("Storm Glass needs a key"),
            tr("Paste one on the weather page (F3); without a key there is Open-Meteo, or practice weather."),
            WayOut.PRACTICE,
            WayOut.WEATHER,
        ),
        "bad-key": (
            tr("Storm Glass does not accept the key"),
            tr("Check it on the weather page (F3); until then there is practice weather."),
            WayOut.PRACTICE,
            WayOut.WEATHER,
        ),
        "quota": (
            tr("Today's requests are spent"),
            tr("The count starts again at 00:00 UTC; until then use a file or practice weather."),
            WayOut.PRACTICE,
            WayOut.WEATHER,
        ),
        "too-often": (
            tr("The weather service is asked too often"),
            tr("Try again in a few minutes; until then use a file or practice weather."),
            WayOut.RETRY,
            WayOut.PRACTICE,
        ),
        "bad-response": (
            tr("The weather cannot be used"),
            tr("Try again later, or choose another forecast."),
            WayOut.RETRY,
            WayOut.WEATHER,
        ),
    }


def _of_the_program() -> dict[str, _Known]:
    return {
        "bad-input": (tr("Please check what was given"), "", WayOut.FORM, WayOut.NOTHING),
        "not-written": (
            tr("The file was not saved"),
            tr("Choose another folder or name; the passage is still here."),
            WayOut.NOTHING,
            WayOut.NOTHING,
        ),
        "damaged": (
            tr("Something that was saved is damaged"),
            tr("Everything else is as it was."),
            WayOut.NOTHING,
            WayOut.NOTHING,
        ),
        "internal": (
            tr("Something went wrong inside SeaCruise"),
            tr("What you entered is still here. For a report: versions and seacruise.log, see About."),
            WayOut.ABOUT,
            WayOut.NOTHING,
        ),
    }


def message_for(error: SeaCruiseError) -> Message:
    """Message for an error; its own sentence is always part of it."""
    title, advice, *ways = _known().get(_cause(error)) or (
        tr("No passage") if isinstance(error, NoPassageError) else tr("That did not work"),
        "",
        WayOut.NOTHING,
        WayOut.NOTHING,
    )
    if getattr(error, "place", None) is None:
        ways = [way for way in ways if way is not WayOut.SHOW_PLACE]
    first, second, *_ = [*ways, WayOut.NOTHING, WayOut.NOTHING]
    return Message("error", title, str(error), advice, first, second)


def message_of(state: WindowState, *, holds: bool) -> Message | None:
    """Message for what the window is doing; ``holds`` while a calculation waits for what is being loaded."""
    if holds:
        return Message(
            "info",
            QCoreApplication.translate("MainWindow", "Loading ports, yachts and the forecast…"),
            QCoreApplication.translate("MainWindow", "The passage is calculated as soon as they are there."),
        )
    if state.phase is Phase.FAILED and state.error is not None:
        return message_for(state.error)
    if state.phase is Phase.CANCELLED:
        nothing = QCoreApplication.translate("MainWindow", "Nothing was changed.")
        return Message("info", QCoreApplication.translate("MainWindow", "Cancelled"), nothing)
    return None


def message_for_polars(problems: Sequence[str]) -> Message:
    """Message for polar files that cannot be used."""
    title = QCoreApplication.translate("MainWindow", "Some polars cannot be used")
    return Message("warning", title, "\n".join(problems))


def _cause(error: SeaCruiseError) -> str:
    """Tell a day's requests that are spent from a limit of the minute or the hour, which passes."""
    sentence = str(error)
    is_of_the_day = "today" in sentence or "00:00 UTC" in sentence
    return "too-often" if error.reason == "quota" and not is_of_the_day else error.reason


def way_out_text(way_out: WayOut) -> str:
    """Words on the button."""
    return {
        WayOut.RETRY: tr("Try again"),
        WayOut.PRACTICE: tr("Use practice weather"),
        WayOut.DEPARTURE: tr("Use the first hour covered"),
        WayOut.SHOW_PLACE: tr("Show the place"),
        WayOut.ENGINE: tr("Motor below 3 kn"),
        WayOut.WEATHER: tr("Weather…"),
        WayOut.OPTIONS: tr("Change the limits…"),
        WayOut.FORM: tr("To the form"),
        WayOut.ABOUT: tr("About SeaCruise…"),
    }.get(way_out, "")


def is_forecast(forecast: Forecast) -> bool:
    """Tell a forecast from practice weather and the sample."""
    return forecast.real


def notices_of(passage: Passage, now: datetime) -> list[Message]:
    """Collect what must be read with a passage, most important first."""
    forecast = passage.forecast
    real = is_forecast(forecast)
    messages = []
    if forecast.notice:
        title = tr("About this forecast") if real else tr("Not a forecast for today")
        messages.append(Message("warning", title, forecast.notice, brief=not real))
    if real and forecast.issued is not None and (age := age_h(forecast.issued, now)) >= STALE_H:
        messages.append(
            Message(
                "warning",
                tr("The forecast is {age} old").format(age=format_age(age)),
                tr("A newer one may change the passage; calculate again when you are online."),
            )
        )
    others = [sentence for sentence in passage.notices if sentence != forecast.notice]
    if others:
        messages.append(Message("info", "", "\n".join(others)))
    return messages


def age_h(issued: datetime, now: datetime) -> float:
    """Age of a forecast [h]."""
    return max(0.0, (now - issued).total_seconds() / 3600.0)


def format_age(hours: float) -> str:
    """Write an age: minutes, hours, or days."""
    if hours < 1.0:
        return tr("{n} min").format(n=round(hours * 60))
    if hours < 48.0:
        return tr("{n} h").format(n=round(hours))
    return tr("{n} days").format(n=round(hours / 24.0))
