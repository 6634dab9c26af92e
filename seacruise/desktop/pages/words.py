"""Moments and hours as both pages write them, in the sailor's language."""

from __future__ import annotations

from datetime import datetime, timedelta
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, QDate, QLocale

from seacruise.desktop.language import sentence
from seacruise.desktop.messages import message_for
from seacruise.desktop.pages.departures_model import Comparison, Outcome, Verdict
from seacruise.desktop.pages.page import Texts
from seacruise.desktop.units_choice import distance_text, in_zone, wind_text, zone_text
from seacruise.desktop.verdict import days_text
from seacruise.errors import NoPassageError
from seacruise.export.textform import to_minute

if TYPE_CHECKING:
    from seacruise.study import Run


LONG_H: Final = 48.0
"""From here on a time [h] is told in days."""

MUCH_MORE_KN: Final = 4.0
"""A departure that saves hours in so much more wind is not simply better [kn]: a force of Beaufort."""


def tr(text: str) -> str:
    """Translate a text of this module."""
    return QCoreApplication.translate("pages", text)


def short_moment(moment: datetime) -> str:
    """Weekday, day and time without the zone, for tables: ``Sun 20 06:00``."""
    local = in_zone(to_minute(moment))
    return f"{QLocale().toString(QDate(local.year, local.month, local.day), 'ddd d')} {local:%H:%M}"


def moment_in_short(moment: datetime) -> str:
    """Weekday, day and time with the zone: ``Sun 20 06:00 UTC``."""
    return f"{short_moment(moment)} {zone_text(moment)}"


def spoken_moment(moment: datetime, *, since: datetime) -> str:
    """Day and time as one says it, with the zone: within six days the weekday alone, else the date."""
    local = in_zone(to_minute(moment))
    pattern = "dddd" if abs(local - since) < timedelta(days=6) else "dddd d MMMM"
    day = QLocale().toString(QDate(local.year, local.month, local.day), pattern)
    return f"{day} {local:%H:%M} {zone_text(moment)}"


def clock(hours: float) -> str:
    """Write a duration in a narrow place: ``28 h 10``."""
    minutes = round(hours * 60)
    return tr("{h} h {m:02d}").format(h=minutes // 60, m=minutes % 60)


def about(hours: float) -> str:
    """Write a difference as one says it: ``40 min``, ``6 h``, ``6 h 10 min``, ``26 h``."""
    minutes = round(hours * 60)
    if minutes < 60:
        return tr("{m} min").format(m=minutes)
    if minutes >= LONG_H * 60:
        return days_text(hours)
    if minutes >= 600 or minutes % 60 == 0:
        return tr("{h} h").format(h=round(minutes / 60))
    return tr("{h} h {m} min").format(h=minutes // 60, m=minutes % 60)


def rounded(hours: float) -> str:
    """Write a difference where there is little room: ``37 min``, ``1 h 37``, and from two on full hours."""
    minutes = round(hours * 60)
    if minutes < 60:
        return tr("{m} min").format(m=minutes)
    if minutes >= LONG_H * 60:
        return days_text(hours)
    return clock(hours) if minutes < 120 else tr("{h:.0f} h").format(h=hours)


def reason_of(run: Run) -> str:
    """Why there is no passage, in a few words; empty when there is one."""
    return "" if run.found else message_for(NoPassageError(run.message, reason=run.reason)).title


def verdict_sentences(comparison: Comparison) -> list[str]:
    """Name the best departure: of the fastest yacht, and of the first one."""
    yachts = comparison.yachts
    if len(yachts) == 1:
        return [_sentence(comparison.verdict(yachts[0]), comparison)]
    fastest = comparison.fastest()
    first = comparison.verdict(yachts[0])
    if fastest is None or fastest.best is None:
        return [_sentence(first, comparison)]
    if fastest.yacht == first.yacht:
        return [tr("{yacht} is fastest.").format(yacht=first.yacht), _sentence(first, comparison)]
    leaves = spoken_moment(fastest.best.departure, since=comparison.present)
    said = tr("Fastest is {yacht}, leaving {leaves}: {hours} under way.").format(
        yacht=fastest.yacht, leaves=leaves, hours=clock(fastest.best.duration_h or 0.0)
    )
    return [said, f"{first.yacht}: {_sentence(first, comparison)}"]


def _sentence(verdict: Verdict, comparison: Comparison) -> str:
    best, against = verdict.best, verdict.against
    if best is None:
        if verdict.outcome is Outcome.WAITING:
            return tr("No passage yet.")
        return tr("None of these departures leads to a passage; each row says why.")

    def say(moment: datetime) -> str:
        return spoken_moment(moment, since=comparison.present)

    texts = {
        Outcome.ONLY: tr("{leaves} is the only departure with a passage: {hours} under way."),
        Outcome.EQUAL: tr("It makes no difference when you leave: {hours} under way."),
        Outcome.PRESENT: tr(
            "Leaving as planned, {leaves}, is best: {hours} under way, up to {saves} less than later."
        ),
        Outcome.OTHER: tr("Leaving {leaves} saves {saves}: {hours} under way instead of {other}."),
        Outcome.UNLIKE_PRESENT: tr("Best is leaving {leaves}: {hours} under way."),
        Outcome.LESS_HELD: tr(
            "Leaving {leaves} is best: {hours} under way. Others seem shorter, but more than a tenth of "
            "them is beyond the forecast."
        ),
        Outcome.BEYOND: tr(
            "Nothing can be said yet about when to leave: more than a tenth of every passage is beyond the "
            "forecast. In the wind held from then on, leaving {leaves} is shortest: {hours} under way."
        ),
    }
    said = texts[verdict.outcome].format(
        leaves=say(best.departure),
        hours=clock(best.duration_h or 0.0),
        saves=about(verdict.hours),
        other="" if against is None else clock(against.duration_h or 0.0),
    )
    price = _price(verdict) if verdict.outcome in {Outcome.OTHER, Outcome.PRESENT} else ""
    return f"{said} {price}" if price else said


def _price(verdict: Verdict) -> str:
    """Say what the hours that are saved cost in wind; empty where that is not much."""
    best, against = verdict.best, verdict.against
    if best is None or against is None or best.max_tws_kn is None or against.max_tws_kn is None:
        return ""
    if best.max_tws_kn - against.max_tws_kn < MUCH_MORE_KN:
        return ""
    return tr("But the strongest wind is {wind}, not {other}.").format(
        wind=wind_text(best.max_tws_kn), other=wind_text(against.max_tws_kn)
    )


def run_text(run: Run) -> str:
    """One departure in full, for the line below the curve: its passage, or why there is none."""
    leaves = short_moment(run.departure)
    if run.duration_h is None or run.arrival is None:
        return f"{leaves}: {sentence(run.message)}"
    parts = [
        tr("{leaves} to {arrives}: {hours}, {distance}").format(
            leaves=leaves,
            arrives=moment_in_short(run.arrival),
            hours=clock(run.duration_h),
            distance=distance_text(run.distance_nm or 0.0, 0),
        )
    ]
    if run.beyond_forecast_h:
        parts.append(tr("{hours} of it beyond the forecast").format(hours=about(run.beyond_forecast_h)))
    if run.band is not None:
        spread = run.band.duration_h
        quantiles = [tr("never") if h is None else clock(h) for h in (spread.low, spread.middle, spread.high)]
        parts.append(
            tr("of {n} members 10 - 50 - 90 % need {band}").format(
                n=len(run.band.members), band=" - ".join(quantiles)
            )
        )
    return "; ".join(parts) + "."


def departures_texts() -> Texts:
    """Words of the page of departures."""
    return Texts(
        tr("When to go"),
        tr("Comp&are"),
        tr(
            "Plans the passage of the form for several departures, from its own on, and shows how long each "
            "takes, when it arrives and in what wind. Choose how many, and press Compare."
        ),
    )
