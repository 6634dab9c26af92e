from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime, timedelta

import pytest

from seacruise.desktop.messages import (
    Message,
    WayOut,
    format_age,
    message_for,
    notices_of,
    way_out_text,
)
from seacruise.errors import InputError, NoPassageError, SeaCruiseError, WeatherError
from tests.passages import hand_made_passage

REASONS: list[tuple[type[SeaCruiseError], str]] = [
    *((NoPassageError, reason) for reason in ("becalmed", "no-water-path", "wind-limit", "dead-angle")),
    (NoPassageError, "outside-forecast"),
    *((WeatherError, r) for r in ("no-network", "no-key", "bad-key", "quota", "bad-response", "timeout")),
    *((InputError, r) for r in ("bad-input", "not-written", "same-port", "departure")),
]


@pytest.mark.parametrize(("kind", "reason"), REASONS)
def test_every_reason_has_a_title_of_its_own_and_keeps_its_sentence(
    kind: type[SeaCruiseError], reason: str
) -> None:
    message = message_for(kind("What was wrong, and where.", reason=reason))
    assert message.kind == "error"
    assert message.sentence == "What was wrong, and where."
    others = {message_for(k("x", reason=r)).title for k, r in REASONS if r != reason}
    assert message.title not in others


@pytest.mark.parametrize(
    ("sentence", "title"),
    [
        ("Storm Glass has no request left for today; the quota resets at 00:00 UTC.", "requests are spent"),
        ("Open-Meteo has answered enough; the count starts again at 00:00 UTC.", "requests are spent"),
        ("Open-Meteo has answered enough; try again in a minute.", "asked too often"),
        ("Open-Meteo has answered enough; the count starts again at the next full hour.", "asked too often"),
        ("MET Norway is asked too often; try again in some minutes.", "asked too often"),
    ],
)
def test_a_limit_of_the_minute_is_not_the_days(sentence: str, title: str) -> None:
    message = message_for(WeatherError(sentence, reason="quota"))
    assert title in message.title
    assert (message.way_out is WayOut.RETRY) == ("too often" in title)


@pytest.mark.parametrize("reason", ["brand-new", "another"])
def test_a_reason_nobody_knows_is_still_told(reason: str) -> None:
    message = message_for(NoPassageError("A whale.", reason=reason))
    assert message.title
    assert message.sentence == "A whale."


def test_a_place_is_offered_only_when_it_is_known() -> None:
    without = message_for(NoPassageError("Land.", reason="no-water-path"))
    known = message_for(NoPassageError("Land.", reason="no-water-path", place=(59.0, 18.0)))
    assert WayOut.SHOW_PLACE not in {without.way_out, without.other}
    assert known.way_out is WayOut.SHOW_PLACE


def test_every_way_out_has_words() -> None:
    assert all(way_out_text(way) for way in WayOut if way is not WayOut.NOTHING)


def test_practice_weather_is_called_so_before_anything_else() -> None:
    passage = hand_made_passage()
    first, *others = notices_of(passage, datetime.now(UTC))
    assert first == Message("warning", "Not a forecast for today", passage.forecast.notice, brief=True)
    assert passage.notices[0] in others[0].sentence
    assert all(passage.forecast.notice not in other.sentence for other in others)


@pytest.mark.parametrize(("hours", "warned"), [(2, False), (11.9, False), (14, True), (80, True)])
def test_an_old_forecast_is_called_old(hours: float, warned: bool) -> None:
    passage = hand_made_passage()
    now = datetime(2016, 11, 20, 12, tzinfo=UTC)
    forecast = replace(passage.forecast, notice="", real=True, issued=now - timedelta(hours=hours))
    messages = notices_of(replace(passage, forecast=forecast, notices=()), now)
    assert bool(messages) == warned
    assert all(message.kind == "warning" for message in messages)


def test_partial_and_stale_data_are_told_as_what_they_are() -> None:
    passage = hand_made_passage()
    now = datetime(2016, 11, 20, 12, tzinfo=UTC)
    notice = "3 of 12 points did not answer."
    forecast = replace(passage.forecast, notice=notice, real=True, issued=now - timedelta(hours=20))
    partial, stale = notices_of(replace(passage, forecast=forecast, notices=(notice,)), now)
    assert (partial.title, partial.sentence) == ("About this forecast", notice)
    assert "20 h old" in stale.title


@pytest.mark.parametrize(("hours", "text"), [(0.5, "30 min"), (14.2, "14 h"), (72.0, "3 days")])
def test_ages_are_short(hours: float, text: str) -> None:
    assert format_age(hours) == text
