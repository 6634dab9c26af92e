"""MET Norway: its manners, its hours, and every fault between here and there."""

from __future__ import annotations

import re
import threading
import time
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import seacruise
from seacruise.errors import CancelledError, NoPassageError, WeatherError
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.weather.metno import MetNo, MetNoConfig, horizon_of, to_series, truncated, user_agent
from seacruise.weather.source import weather_info
from seacruise.weather.wind import Wind, from_direction
from tests.faultserver import FaultServer
from tests.weather.failures import (
    BAD_JSON,
    BOX,
    BROKEN,
    LATE,
    LATER,
    NOW,
    SHORT,
    behaviours,
    each,
    fails,
    old_answers_serve,
    on_the_way,
)
from tests.weather.weatherserver import EXPIRES, LAST_MODIFIED, MET_NORWAY, met_norway, wind_at

HOUR = datetime(2026, 11, 21, 9, tzinfo=UTC)
CONFIG = MetNoConfig(limits=SHORT, batch_s=5.0, max_points=4, pace_s=0.0)
PATIENT = replace(CONFIG, limits=replace(SHORT, read_s=20.0, total_s=20.0), batch_s=40.0)


def ask(
    settings: Settings,
    server: FaultServer,
    *,
    config: MetNoConfig = PATIENT,
    now: datetime = NOW,
    **options: Any,
) -> Wind:
    options = {"departure": None, "job": Job(), **options}
    return MetNo(replace(settings, metno_url=server.url), config).wind(BOX, now=now, **options)


# --- what goes wrong ------------------------------------------------------------------------------

SHAPE = "another shape"
FAILURES = [
    *on_the_way("asked too often"),
    ("C", "400", "bad-response", "no forecast for a place"),
    ("C", "401", "bad-response", "HTTP 401"),
    ("C", "403", "bad-response", "refuses this program"),
    ("C", "422", "bad-response", "no forecast for a place"),
    ("C", "429-page", "quota", "asked too often"),
    ("D", "portal", "bad-response", "sign in"),
    ("D", "portal-as-json", "bad-response", BAD_JSON),
    ("D", "stream-error", "bad-response", BAD_JSON),
    ("D", "nan", "bad-response", BAD_JSON),
    ("D", "infinity", "bad-response", BAD_JSON),
    ("D", "1e999", "bad-response", "out of range"),
    ("D", "string-number", "bad-response", r"Expected `float \| null`, got `str`"),
    ("D", "deep", "bad-response", "."),
    ("D", "list", "bad-response", SHAPE),
    ("D", "no-series", "bad-response", "`timeseries`"),
    ("D", "empty-series", "bad-response", "other days"),
    ("D", "no-meta", "bad-response", "`meta`"),
    ("D", "no-place", "bad-response", "another place"),
    ("D", "another-place", "bad-response", "another place"),
    ("D", "all-null", "bad-response", "no wind speed with a direction"),
    ("D", "no-direction", "bad-response", "no wind speed with a direction"),
    ("D", "short", "bad-response", "less than 24 hours"),
    ("D", "not-a-time", "bad-response", SHAPE),
    ("D", "last-year", "bad-response", "other days"),
    ("D", "negative", "bad-response", "-1 m/s"),
    ("D", "gale-400", "bad-response", "400 m/s"),
    ("E", "knots", "bad-response", "wind_speed in 'kn'"),
    ("E", "unsaid-unit", "bad-response", "wind_speed in ''"),
]


@each("behaviour reason words", FAILURES)
def test_fault(settings: Settings, behaviour: str, reason: str, words: str) -> None:
    config = CONFIG if behaviour in LATE else PATIENT
    server = met_norway(behaviour, now=NOW)
    sentence = fails(server, lambda one: ask(settings, one, config=config), reason, words)
    # each place was tried at most as often as the limits allow, and redirects not at all
    assert len(server.requests) <= 4 * SHORT.tries
    assert {request.path for request in server.requests} == {"/weatherapi/locationforecast/2.0/complete"}

    notice = old_answers_serve(
        met_norway(now=NOW),
        met_norway(behaviour, now=NOW),
        before=lambda one: ask(settings, one),
        after=lambda one: ask(settings, one, config=config, now=LATER),
    )
    assert "Some of the wind is from an answer 7 h old." in notice
    assert sentence in notice


SOUND = [
    ("A", "good", ""),
    ("A", "chunked", ""),
    ("A", "gzip", ""),
    ("C", "203", "will soon end this version"),
    ("A", "no-caching", ""),
    ("A", "odd-caching", ""),
    ("D", "null", ""),
    ("D", "some-without-direction", ""),
    ("D", "no-gusts", ""),
    ("D", "duplicates", ""),
    ("D", "unsorted", ""),
    ("D", "three-hourly", ""),
    ("D", "one-hole", ""),
    ("D", "long-hole", ""),
    ("D", "no-zone", ""),
    ("D", "other-zone", ""),
    ("D", "direction-360", ""),
    ("D", "direction-below", ""),
    ("D", "direction-9999", ""),
    ("D", "twice-the-key", ""),
]


@each("behaviour notice", SOUND)
def test_odd_but_sound(settings: Settings, behaviour: str, notice: str) -> None:
    with met_norway(behaviour, now=NOW) as server:
        wind = ask(settings, server)
    assert wind.forecast.valid_from == HOUR
    assert wind.forecast.source == "MET Norway"
    assert notice in wind.forecast.notice
    assert wind.forecast.notice.endswith("Weather data by MET Norway (CC BY 4.0).")
    if not behaviour.startswith(("direction", "null")):
        expected = from_direction(*wind_at(wind.lat[0], wind.lon[0], 24))
        got = wind.at((HOUR + timedelta(hours=24)).timestamp(), wind.lat[0], wind.lon[0])
        np.testing.assert_allclose(got, expected, atol=0.01)


def test_an_answer_that_says_unchanged_when_nothing_is_kept_is_none(settings: Settings) -> None:
    with met_norway("304-at-once", now=NOW) as server, pytest.raises(WeatherError) as caught:
        ask(settings, server)
    assert caught.value.reason == "bad-response"


def test_every_behaviour_of_the_server_is_a_case() -> None:
    assert behaviours(FAILURES, SOUND) | {"304-at-once"} == set(MET_NORWAY)


@pytest.mark.parametrize(
    "url", ["http://127.0.0.1:9", "http://nowhere.invalid"], ids=["A-refused", "A-no-name"]
)
def test_no_network_is_said_at_once(settings: Settings, url: str) -> None:
    with pytest.raises(WeatherError, match="internet connection") as caught:
        MetNo(replace(settings, metno_url=url), PATIENT).wind(BOX, departure=None, now=NOW, job=Job())
    assert caught.value.reason == "no-network"


def test_a_server_that_never_answers_is_given_up_after_the_first_places(settings: Settings) -> None:
    with met_norway("timeout", now=NOW) as server:
        begin = time.monotonic()
        with pytest.raises(WeatherError) as caught:
            ask(settings, server, config=replace(CONFIG, max_points=9))
        assert time.monotonic() - begin < 10.0
    assert caught.value.reason == "timeout"
    assert len(server.requests) <= CONFIG.parallel * SHORT.tries


def test_the_usual_deadline_is_within_half_a_minute() -> None:
    config = MetNoConfig()
    assert config.limits.total_s <= config.batch_s <= 30.0
    assert config.limits.connect_s <= 5.0
    # fewer than 20 requests a second, by far
    assert config.pace_s >= 0.1


def test_requests_start_one_pace_apart(settings: Settings) -> None:
    with met_norway(now=NOW) as server:
        begin = time.monotonic()
        ask(settings, server, config=replace(PATIENT, pace_s=0.1))
        # the first starts at once
        assert time.monotonic() - begin >= 0.1 * (len(server.requests) - 1)


def test_cancel_does_not_wait_for_a_server_that_says_nothing(settings: Settings) -> None:
    cancel = threading.Event()

    def report(stage: str, fraction: float | None, message: str) -> None:
        threading.Timer(0.1, cancel.set).start()

    with met_norway("timeout", now=NOW) as server:
        begin = time.monotonic()
        with pytest.raises(CancelledError):
            ask(settings, server, job=Job(report=report, cancel=cancel))
        # the server would have held the call for 20 s
        assert time.monotonic() - begin < 10.0


# --- manners --------------------------------------------------------------------------------------


def test_the_service_is_told_who_asks(settings: Settings) -> None:
    with met_norway(now=NOW) as server:
        ask(settings, server)
    for request in server.requests:
        assert request.headers["user-agent"] == (
            f"SeaCruise/{seacruise.__version__} (passage planner for cruising under sail)"
        )
        assert "if-modified-since" not in request.headers
        assert all(re.fullmatch(r"-?\d+\.\d{4}", request.query[name]) for name in ("lat", "lon"))


def test_the_service_is_told_whom_to_write_to(settings: Settings) -> None:
    """Its terms: "include a company email address or a link to the company website"."""
    settings = replace(settings, contact="skipper@boat.example")
    with met_norway(now=NOW) as server:
        ask(settings, server)
    about = "passage planner for cruising under sail; contact skipper@boat.example"
    agents = {request.headers["user-agent"] for request in server.requests}
    assert agents == {f"SeaCruise/{seacruise.__version__} ({about})"}


def test_the_contact_is_the_environment_s_and_its_absence_is_told(tmp_path: Path) -> None:
    home = {"SEACRUISE_HOME": str(tmp_path)}
    for contact, wanted in (("", True), (" me@boat.example ", False)):
        settings = Settings.from_environment({**home, "SEACRUISE_CONTACT": contact})
        assert settings.contact == contact.strip()
        (remark,) = (one.remark for one in weather_info(settings, NOW).sources if one.name == "metno")
        assert ("set SEACRUISE_CONTACT" in remark) == wanted


@given(st.text(max_size=300))
def test_any_contact_makes_a_header(contact: str) -> None:
    agent = user_agent(contact)
    assert re.fullmatch(r"SeaCruise/\S+ \([ -~]*\)", agent)
    assert agent.count("(") == agent.count(")") == 1
    assert len(agent) < 250


@pytest.mark.parametrize(
    ("degrees", "cut"), [(54.56789, 54.5678), (-0.99999, -0.9999), (18.0, 18.0), (59.00004, 59.0)]
)
def test_coordinates_are_cut_to_four_decimals(degrees: float, cut: float) -> None:
    assert truncated(degrees) == cut


def test_nothing_is_asked_before_the_answer_expires(settings: Settings) -> None:
    told: list[str] = []
    job = Job(report=lambda stage, fraction, message: told.append(message))
    assert EXPIRES == "Sat, 21 Nov 2026 10:12:44 GMT"
    with met_norway(now=NOW) as server:
        first = ask(settings, server)
        sent = len(server.requests)
        second = ask(settings, server, now=NOW + timedelta(minutes=42), job=job)
        assert len(server.requests) == sent
        ask(settings, server, now=NOW + timedelta(minutes=43))
        assert len(server.requests) == 2 * sent
    assert told == ["MET Norway: no request needed, the answers kept are new enough"]
    np.testing.assert_array_equal(first.u, second.u)


def test_an_unchanged_answer_is_kept(settings: Settings) -> None:
    with met_norway(now=NOW) as server:
        first = ask(settings, server)
        sent = len(server.requests)
        second = ask(settings, server, now=LATER)
    for request in server.requests[sent:]:
        assert request.headers["if-modified-since"] == LAST_MODIFIED
    np.testing.assert_array_equal(first.u, second.u)
    # confirmed by the service just now
    assert second.forecast.issued == LATER
    assert "old" not in second.forecast.notice


def test_an_answer_without_a_date_is_kept_for_half_an_hour(settings: Settings) -> None:
    with met_norway("odd-caching", now=NOW) as server:
        ask(settings, server)
        sent = len(server.requests)
        ask(settings, server, now=NOW + timedelta(minutes=29))
        assert len(server.requests) == sent
        ask(settings, server, now=NOW + timedelta(minutes=31))
    assert len(server.requests) == 2 * sent
    assert all("if-modified-since" not in request.headers for request in server.requests)


# --- what comes of it -----------------------------------------------------------------------------


def test_hourly_and_six_hourly_steps_are_one_axis(settings: Settings) -> None:
    with met_norway(now=NOW) as server:
        wind = ask(settings, server)
    hours = (wind.time - HOUR.timestamp()) / 3600.0
    np.testing.assert_array_equal(hours, [*range(60), *range(60, 240, 6)])
    assert wind.forecast.valid_to == HOUR + timedelta(hours=234)


def test_gusts_end_before_the_wind_and_it_is_said(settings: Settings) -> None:
    with met_norway(now=NOW) as server:
        wind = ask(settings, server)
    assert wind.gust is not None
    speed = np.hypot(wind.u, wind.v)
    np.testing.assert_allclose(wind.gust[:60], 1.4 * speed[:60], atol=0.02)
    np.testing.assert_array_equal(wind.gust[60:], speed[60:])
    assert "Gusts are known until 23 Nov 20:00 UTC" in wind.forecast.notice


def test_land_is_not_asked_and_gets_wind(settings: Settings) -> None:
    with met_norway(now=NOW) as server:
        wind = ask(settings, server, is_water=lambda lat, lon: np.asarray(lon) > 18.0)
    assert all(float(request.query["lon"]) > 18.0 for request in server.requests)
    assert np.isfinite(wind.u).all()
    assert wind.covers([BOX[0], BOX[2]], [BOX[1], BOX[3]]).all()


def test_a_baltic_passage_takes_at_most_forty_places(settings: Settings) -> None:
    config = replace(MetNoConfig(), pace_s=0.0)
    with met_norway(now=NOW) as server:
        MetNo(replace(settings, metno_url=server.url), config).wind(
            (53.8, 16.7, 60.1, 19.9), departure=None, now=NOW, job=Job()
        )
    assert 20 <= len(server.requests) <= 40
    assert server.most_at_once <= 2  # connections, kept open from one request to the next


@pytest.mark.parametrize("hours", [-2, 24 * 9 + 1])
def test_a_day_without_a_forecast_costs_no_request(settings: Settings, hours: int) -> None:
    assert horizon_of(NOW) == (HOUR, HOUR + timedelta(days=9))
    with met_norway(now=NOW) as server, pytest.raises(NoPassageError, match="21 Nov 2026") as caught:
        ask(settings, server, departure=NOW + timedelta(hours=hours))
    assert caught.value.reason == "outside-forecast"
    assert server.requests == []


def test_half_of_the_places_are_enough(settings: Settings) -> None:
    config = replace(PATIENT, parallel=1, limits=replace(PATIENT.limits, tries=1))
    with met_norway("503,503,good", now=NOW) as server:
        wind = ask(settings, server, config=config)
    assert "2 of 4 places have an answer; the rest is filled in." in wind.forecast.notice
    assert BROKEN in wind.forecast.notice


@given(
    st.binary(max_size=400)
    | st.text(alphabet='{}[]":,0123456789.-eE geometrypropertiestimeseries', max_size=200).map(str.encode)
)
def test_any_bytes_are_an_answer_or_an_error(body: bytes) -> None:
    with pytest.raises((msgspec.DecodeError, UnicodeDecodeError, WeatherError)):
        to_series(body, (55.0, 18.0), 0.0)
