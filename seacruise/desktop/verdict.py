"""The answer to the sailor's first question, in one line: whether a week is enough."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Literal

from PySide6.QtCore import QCoreApplication

if TYPE_CHECKING:
    from seacruise.passage import Passage

DAY_H: Final = 24.0
WEEK_H: Final = 7 * DAY_H

DOUBTFUL_SHARE: Final = 0.1
"""With more of the passage than this beyond the forecast nothing is sure, as on the page of departures."""


@dataclass(frozen=True, slots=True)
class Verdict:
    """What is said, and how it is dressed."""

    text: str
    dress: Literal["good", "hint", "fault"]


def tr(text: str) -> str:
    """Translate a text of this module."""
    return QCoreApplication.translate("verdict", text)


def days_text(hours: float) -> str:
    """Write a long time in days and full hours: ``2 d 3 h``; less than a day in hours: ``7 h``."""
    days, rest = divmod(round(hours), 24)
    return tr("{d} d {h} h").format(d=days, h=rest) if days else tr("{h} h").format(h=rest)


def verdict_on(passage: Passage) -> Verdict:
    """Judge a passage by the week that a crew has, one way; no surer than the weather it was sailed in."""
    hours, real = passage.duration_h, passage.forecast.real
    doubtful = passage.beyond_forecast_h > DOUBTFUL_SHARE * hours
    if hours <= DAY_H and not doubtful:
        text = tr("A day is enough, one way.") if real else tr("In this weather a day is enough, one way.")
    elif hours <= WEEK_H:
        text = _enough(real=real, doubtful=doubtful)
    else:
        text = _too_long(real=real, doubtful=doubtful)
    said = text.format(takes=days_text(hours), left=days_text(abs(WEEK_H - hours)))
    if hours > WEEK_H:
        return Verdict(said, "fault")
    return Verdict(said, "good" if real and not doubtful else "hint")


def _enough(*, real: bool, doubtful: bool) -> str:
    if doubtful:
        return tr("{takes}: a week is probably enough, one way, with {left} to spare.")
    if real:
        return tr("{takes}: a week is enough, one way, with {left} to spare.")
    return tr("{takes}: in this weather a week is enough, one way, with {left} to spare.")


def _too_long(*, real: bool, doubtful: bool) -> str:
    if doubtful:
        return tr("{takes}: a week is hardly enough, {left} too long.")
    if real:
        return tr("{takes}: a week is not enough, {left} too long.")
    return tr("{takes}: in this weather a week is not enough, {left} too long.")
