"""Storm Glass against a server that misbehaves: reasons, sentences, deadlines, and the key kept secret."""

from __future__ import annotations

import logging
import threading
import time
import traceback
from collections.abc import Iterator
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from seacruise.errors import CancelledError, NoPassageError, SeaCruiseError, WeatherError
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.store import Store
from seacruise.weather.cache import WeatherCache
from seacruise.weather.http import Limits
from seacruise.weather.stormglass import StormGlass, StormGlassConfig
from seacruise.weather.wind import Wind, from_direction
from tests.faultserver import BEHAVIOURS, FaultServer, hour_of

KEY = "4d1f-SECRET-8a2c-0123456789"
NOW = datetime(2026, 11, 21, 9, 30, tzinfo=UTC)
TODAY = datetime(2026, 11, 21, tzinfo=UTC)
BOX = (54.0, 17.0, 58.0, 21.0)
SHORT = Limits(connect_s=2.0, read_s=0.3, total_s=0.8, tries=2, backoff_s=0.01, retry_after_s=0.2)
CONFIG = StormGlassConfig(limits=SHORT, batch_s=5.0, max_points=2)

# A slow machine must not turn a late answer into a timeout where the case is another one.
PATIENT = replace(CONFIG, limits=replace(SHORT, read_s=20.0, total_s=20.0), batch_s=40.0)
LATE = {"timeout", "drip", "drip-head", "429-date", "429-day"}


@pytest.fixture
def keyed(settings: Settings) -> Settings:
    return replace(settings, stormglass_key=KEY)


@pytest.fixture(autouse=True)
def secret_logs(caplog: pytest.LogCaptureFixture) -> Iterator[None]:
    """Log everything that anyone logs, and find no key in it."""
    caplog.set_level(logging.DEBUG)
    yield
    assert KEY not in caplog.text


def ask(
    settings: Settings,
    server: FaultServer,
    *,
    config: StormGlassConfig = PATIENT,
    now: datetime = NOW,
    **options: Any,
) -> Wind:
    there = replace(settings, stormglass_url=server.url)
    options = {"departure": None, "job": Job(), **options}
    return StormGlass(there, config).wind(BOX, now=now, **options)


def assert_key_nowhere(settings: Settings, error: BaseException | None) -> None:
    seen: list[BaseException] = []
    waiting = [error]
    while waiting:
        one = waiting.pop()
        if one is not None and one not in seen:
            seen.append(one)
            waiting += [one.__cause__, one.__context__]
            assert KEY not in repr(one)
            assert KEY not in "".join(traceback.format_exception(one))
            assert not hasattr(one, "request")
    for path in (settings.data_dir.parent).rglob("*"):
        assert not path.is_file() or KEY.encode() not in path.read_bytes()


# --- what goes wrong ------------------------------------------------------------------------------

BROKEN = "trouble of its own"
BAD_JSON = "incomplete or not JSON"
CUT = "broke off"
OTHER_SHAPE = "another shape"
FAILURES = [
    ("402", "quota", "resets at 00:00 UTC"),
    ("401", "bad-key", "STORMGLASS_API_KEY"),
    ("403", "bad-key", "STORMGLASS_API_KEY"),
    ("404", "bad-response", "HTTP 404"),
    ("407", "no-network", "proxy"),
    ("410", "bad-response", "HTTP 410"),
    ("422", "bad-response", "windSpeed"),
    ("422-text", "bad-response", "does not understand"),
    ("429", "quota", "asked too often"),
    ("429-seconds", "quota", "asked too often"),
    ("429-date", "quota", "in 180 minutes"),
    ("429-day", "quota", "in 1440 minutes"),
    ("429-nonsense", "quota", "in some minutes"),
    ("500", "bad-response", BROKEN),
    ("502", "bad-response", BROKEN),
    ("503", "bad-response", BROKEN),
    ("echo-422", "bad-response", "windSpeed"),
    ("echo-500", "bad-response", BROKEN),
    ("echo-200", "bad-response", OTHER_SHAPE),
    ("timeout", "timeout", "did not answer within"),
    ("drip", "timeout", "did not answer within"),
    ("drip-head", "timeout", "did not answer within"),
    ("reset", "bad-response", CUT),
    ("hang-up", "bad-response", CUT),
    ("reset-body", "bad-response", CUT),
    ("truncated", "bad-response", CUT),
    ("chunked-short", "bad-response", CUT),
    ("not-http", "bad-response", CUT),
    ("garbage", "bad-response", BAD_JSON),
    ("gzip-corrupt", "bad-response", CUT),
    ("gzip-short", "bad-response", "."),
    ("gzip-bomb", "bad-response", "more than 5 MB"),
    ("big", "bad-response", "more than 5 MB"),
    ("empty", "bad-response", BAD_JSON),
    ("204", "bad-response", "HTTP 204"),
    ("redirect", "bad-response", "not followed"),
    ("redirect-away", "bad-response", "not followed"),
    ("redirect-loop", "bad-response", "not followed"),
    ("portal", "bad-response", "sign in"),
    ("portal-as-json", "bad-response", BAD_JSON),
    ("stream-error", "bad-response", BAD_JSON),
    ("nan", "bad-response", BAD_JSON),
    ("infinity", "bad-response", BAD_JSON),
    ("1e999", "bad-response", "."),
    ("string-number", "bad-response", r"Expected `float \| null`, got `str`"),
    ("deep", "bad-response", "."),
    ("list", "bad-response", OTHER_SHAPE),
    ("no-hours", "bad-response", "hours"),
    ("empty-hours", "bad-response", "without a single hour"),
    ("all-null", "bad-response", "no wind speed with a direction"),
    ("no-direction", "bad-response", "no wind speed with a direction"),
    ("short", "bad-response", "less than 24 hours"),
    ("not-a-time", "bad-response", OTHER_SHAPE),
    ("last-year", "bad-response", "other days"),
    ("negative", "bad-response", "-1 m/s"),
    ("gale-400", "bad-response", "400 m/s"),
    ("another-place", "bad-response", "another place"),
]


@pytest.mark.parametrize(("behaviour", "reason", "words"), FAILURES, ids=[case[0] for case in FAILURES])
def test_a_failure_has_its_reason_and_its_sentence(
    keyed: Settings, behaviour: str, reason: str, words: str
) -> None:
    config = CONFIG if behaviour in LATE else PATIENT
    with FaultServer(behaviour) as server, pytest.raises(WeatherError, match=words) as caught:
        ask(keyed, server, config=config)
    sentence = str(caught.value)
    assert caught.value.reason == reason
    assert caught.value.exit_code == 4
    assert sentence.endswith(".")
    assert len(sentence) < 250
    assert_key_nowhere(keyed, caught.value)
    # each of the two places was tried at most as often as the limits allow, and redirects not at all
    assert len(server.requests) <= 2 * SHORT.tries
    if "redirect" in behaviour:
        assert {request.path for request in server.requests} == {"/v2/weather/point"}


SOUND = [
    ("good", ""),
    ("chunked", ""),
    ("gzip", ""),
    ("slow", ""),
    ("null", "hours are from ecmwf, noaa, where sg has none"),
    ("some-without-direction", ""),
    ("no-sg", "240 of 240 hours are from ecmwf, noaa"),
    ("sg-ends", "140 of 240 hours are from ecmwf, noaa"),
    ("all-end", ""),
    ("new-model", ""),
    ("duplicates", ""),
    ("unsorted", ""),
    ("three-hourly", ""),
    ("one-hole", ""),
    ("long-hole", "hole of more than 6 h"),
    ("no-zone", ""),
    ("other-zone", ""),
    ("direction-360", ""),
    ("direction-below", ""),
    ("direction-725", ""),
    ("direction-9999", ""),
    ("no-meta", ""),
    ("odd-meta", ""),
    ("twice-the-key", ""),
]


@pytest.mark.parametrize(("behaviour", "notice"), SOUND, ids=[case[0] for case in SOUND])
def test_an_odd_but_sound_answer_is_used(keyed: Settings, behaviour: str, notice: str) -> None:
    with FaultServer(behaviour) as server:
        wind = ask(keyed, server)
    assert wind.forecast.valid_from == TODAY
    assert notice in wind.forecast.notice
    assert wind.forecast.source == "Storm Glass (sg)"
    assert_key_nowhere(keyed, None)


def test_every_behaviour_of_the_server_is_a_case() -> None:
    assert {case[0] for case in FAILURES} | {case[0] for case in SOUND} == set(BEHAVIOURS)


@pytest.mark.parametrize(
    "first", ["503", "reset", "truncated", "stream-error", "429-seconds", "gzip-corrupt"]
)
def test_a_passing_fault_is_asked_again(keyed: Settings, first: str) -> None:
    with FaultServer(f"{first},good") as server:
        wind = ask(keyed, server, config=replace(PATIENT, parallel=1))
    assert len(server.requests) == 3
    assert "trouble" not in wind.forecast.notice


@pytest.mark.parametrize("url", ["http://127.0.0.1:9", "http://nowhere.invalid"])
def test_no_network_is_said_at_once(keyed: Settings, url: str) -> None:
    with pytest.raises(WeatherError, match="internet connection") as caught:
        StormGlass(replace(keyed, stormglass_url=url), PATIENT).wind(BOX, departure=None, now=NOW, job=Job())
    assert caught.value.reason == "no-network"
    assert_key_nowhere(keyed, caught.value)


def test_a_server_that_cannot_prove_who_it_is_is_refused(keyed: Settings) -> None:
    with FaultServer("good") as server:
        # this one does not speak TLS at all
        there = replace(keyed, stormglass_url=server.url.replace("http:", "https:"))
        with pytest.raises(WeatherError, match="prove who it is") as caught:
            StormGlass(there, PATIENT).wind(BOX, departure=None, now=NOW, job=Job())
    assert_key_nowhere(keyed, caught.value)


def test_a_missing_certificate_bundle_is_named(keyed: Settings, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("REQUESTS_CA_BUNDLE", "/nowhere/bundle.pem")
    with pytest.raises(WeatherError, match="REQUESTS_CA_BUNDLE"):
        StormGlass(replace(keyed, stormglass_url="https://127.0.0.1:9"), PATIENT).wind(
            BOX, departure=None, now=NOW, job=Job()
        )


@pytest.mark.parametrize("url", ["no-scheme", "ftp://127.0.0.1", "http://[::bad"])
def test_a_wrong_address_is_named(keyed: Settings, url: str) -> None:
    with pytest.raises(WeatherError, match="address"):
        StormGlass(replace(keyed, stormglass_url=url), PATIENT).wind(BOX, departure=None, now=NOW, job=Job())


@pytest.mark.parametrize(
    ("key", "reason"),
    [(None, "no-key"), ("", "no-key"), ("  ", "no-key"), ("a\r\nHost: evil", "bad-key"), ("ключ", "bad-key")],
)
def test_a_key_that_is_none_is_not_sent(settings: Settings, key: str | None, reason: str) -> None:
    with FaultServer() as server, pytest.raises(WeatherError, match="STORMGLASS_API_KEY") as caught:
        ask(replace(settings, stormglass_key=key), server)
    assert caught.value.reason == reason
    assert server.requests == []


def test_netrc_does_not_replace_the_key(
    keyed: Settings, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    netrc = tmp_path / "netrc"
    netrc.write_text("machine 127.0.0.1 login someone password else\n")
    monkeypatch.setenv("NETRC", str(netrc))
    with FaultServer() as server:
        ask(keyed, server)
    assert {request.headers["authorization"] for request in server.requests} == {KEY}


# --- what is asked, and what comes of it ----------------------------------------------------------


def test_the_free_plan_is_asked_for_nine_places_and_all_their_hours(keyed: Settings) -> None:
    told: list[tuple[str, float | None, str]] = []
    job = Job(report=lambda *parts: told.append(parts))
    with FaultServer() as server:
        wind = ask(keyed, server, config=replace(PATIENT, max_points=40), job=job)
    assert 6 <= len(server.requests) <= 9
    assert server.most_at_once <= 5
    query = server.requests[0].query
    assert query["start"] == str(int(TODAY.timestamp()))
    assert query["end"] == str(int((TODAY + timedelta(days=10)).timestamp()))
    assert set(query["params"].split(",")) == {"windSpeed", "windDirection", "gust"}
    assert "source" not in query
    count = len(server.requests)
    assert told[0][2] == f"Storm Glass: {count} requests, 10 a day on this plan"
    assert [message for _, _, message in told[1:]] == [f"wind {n} of {count}" for n in range(1, count + 1)]
    assert wind.time.size == 240
    assert wind.covers([BOX[0], BOX[2]], [BOX[1], BOX[3]]).all()
    assert "follows ecmwf until 27 Nov 00:00 UTC, then noaa" in wind.forecast.notice


def test_the_wind_at_an_asked_place_is_the_service_s(keyed: Settings) -> None:
    with FaultServer() as server:
        wind = ask(keyed, server, config=replace(PATIENT, max_points=9))
    query = server.requests[0].query
    lat, lon = float(query["lat"]), float(query["lng"])
    sent = hour_of(lat, lon, TODAY + timedelta(hours=30), 30)
    expected = from_direction(sent["windSpeed"]["sg"], sent["windDirection"]["sg"])
    got = wind.at((TODAY + timedelta(hours=30)).timestamp(), lat, lon)
    np.testing.assert_allclose(got, expected, atol=1e-5)


def test_no_request_is_spent_on_land(keyed: Settings) -> None:
    with FaultServer() as server:
        ask(keyed, server, config=replace(PATIENT, max_points=9), is_water=lambda lat, lon: lon > 18.6)
    assert server.requests
    assert all(float(request.query["lng"]) > 18.6 for request in server.requests)


def test_a_second_plan_of_the_same_passage_sends_nothing(keyed: Settings) -> None:
    told: list[str] = []
    config = replace(PATIENT, max_points=40)
    with FaultServer() as server:
        first = ask(keyed, server, config=config)
        sent = len(server.requests)
        job = Job(report=lambda stage, fraction, message: told.append(message))
        second = ask(keyed, server, config=config, now=NOW + timedelta(hours=5), job=job)
    assert len(server.requests) == sent
    assert told == [f"Storm Glass: no request needed, {10 - sent} left today"]
    np.testing.assert_array_equal(first.u, second.u)
    assert second.forecast.issued == NOW


def test_a_stale_answer_is_asked_for_again(keyed: Settings) -> None:
    with FaultServer(quota=50) as server:
        ask(keyed, server)
        wind = ask(keyed, server, now=NOW + timedelta(hours=7))
    assert len(server.requests) == 4
    assert wind.forecast.issued == NOW + timedelta(hours=7)


@pytest.mark.parametrize("behaviour", ["503", "402", "reset", "401"])
def test_a_stale_answer_is_better_than_none_and_says_its_age(keyed: Settings, behaviour: str) -> None:
    with FaultServer() as server:
        fresh = ask(keyed, server)
    with FaultServer(behaviour) as server:
        wind = ask(keyed, server, now=NOW + timedelta(hours=14))
    np.testing.assert_array_equal(fresh.u, wind.u)
    assert "an answer 14 h old" in wind.forecast.notice
    assert "Storm Glass" in wind.forecast.notice
    assert wind.forecast.issued == NOW


def test_an_answer_that_ends_before_departure_is_of_no_use(keyed: Settings) -> None:
    with FaultServer() as server:
        ask(keyed, server)
    later = NOW + timedelta(days=8)
    with FaultServer("503") as server, pytest.raises(WeatherError, match=BROKEN):
        ask(keyed, server, now=later, departure=later + timedelta(days=5))


def test_nothing_is_sent_when_the_ledger_says_that_nothing_is_left(keyed: Settings) -> None:
    with FaultServer("402") as server, pytest.raises(WeatherError):
        ask(keyed, server)
    with FaultServer() as server:
        with pytest.raises(WeatherError, match="resets at 00:00 UTC") as caught:
            ask(keyed, server)
        assert caught.value.reason == "quota"
        assert server.requests == []
        # the ledger is of a UTC day
        ask(keyed, server, now=NOW + timedelta(days=1))
        assert len(server.requests) == 2


def test_a_key_used_elsewhere_shows_in_the_ledger(keyed: Settings) -> None:
    with FaultServer(used=5) as server:
        ask(keyed, server)
        quota = StormGlass(keyed).quota(NOW)
    assert (quota.used, quota.daily, quota.left, quota.known) == (7, 10, 3, True)
    assert StormGlass(replace(keyed, stormglass_key="another")).quota(NOW).used == 0


def test_a_shrinking_quota_buys_a_coarser_grid(keyed: Settings) -> None:
    with FaultServer(used=4) as server:
        ask(keyed, server, config=replace(PATIENT, max_points=1))
        assert server.used == 5
        ask(keyed, server, config=replace(PATIENT, max_points=40, source="noaa"))
    assert server.used <= 9


def test_what_arrived_before_the_quota_ran_out_is_kept(keyed: Settings) -> None:
    config = replace(PATIENT, max_points=9, parallel=1)
    with FaultServer(quota=10, used=4) as server:
        wind = ask(keyed, server, config=config)
    assert len(server.requests) == 7
    assert "6 of 9 places have an answer" in wind.forecast.notice
    assert "resets at 00:00 UTC" in wind.forecast.notice


def test_a_wrong_key_is_not_tried_on_every_place(keyed: Settings) -> None:
    with FaultServer("403") as server, pytest.raises(WeatherError):
        ask(keyed, server, config=replace(PATIENT, max_points=9, parallel=1))
    assert len(server.requests) == 1


def test_half_of_the_places_are_enough(keyed: Settings) -> None:
    config = replace(PATIENT, max_points=9, parallel=1, limits=replace(PATIENT.limits, tries=1))
    with FaultServer("503,503,good") as server:
        wind = ask(keyed, server, config=config)
    assert "7 of 9 places have an answer" in wind.forecast.notice
    # another source, so that the first answers cannot stand in
    config = replace(config, source="noaa")
    with FaultServer("good,good,good,503") as server, pytest.raises(WeatherError, match=BROKEN):
        ask(replace(keyed, stormglass_key="another"), server, config=config)


def test_a_day_without_a_forecast_costs_no_request(keyed: Settings) -> None:
    with FaultServer() as server:
        for departure in (TODAY - timedelta(hours=1), TODAY + timedelta(days=11)):
            with pytest.raises(NoPassageError, match="21 Nov 2026 to 01 Dec 2026") as caught:
                ask(keyed, server, departure=departure)
            assert caught.value.reason == "outside-forecast"
    assert server.requests == []


def test_a_cache_that_cannot_be_used_costs_no_forecast(keyed: Settings) -> None:
    keyed.data_dir.mkdir(parents=True)
    keyed.database.write_bytes(b"not a database" * 1000)
    told: list[str] = []
    with FaultServer() as server:
        wind = ask(keyed, server, job=Job(report=lambda stage, fraction, message: told.append(message)))
    assert wind.time.size == 240
    assert any("damaged" in message for message in told)


def test_a_damaged_entry_is_a_miss(keyed: Settings) -> None:
    with FaultServer(quota=50) as server:
        ask(keyed, server)
        store = Store(keyed.database)
        with store.writing() as db:
            db.execute("UPDATE weather_answer SET body = substr(body, 1, 50)")
        ask(keyed, server)
    assert len(server.requests) == 4
    assert len(WeatherCache(store).ages(NOW)) == 2


# --- time -----------------------------------------------------------------------------------------


def test_cancel_does_not_wait_for_a_server_that_says_nothing(keyed: Settings) -> None:
    cancel = threading.Event()

    def report(stage: str, fraction: float | None, message: str) -> None:
        threading.Timer(0.1, cancel.set).start()

    with FaultServer("timeout") as server:
        begin = time.monotonic()
        with pytest.raises(CancelledError):
            ask(keyed, server, job=Job(report=report, cancel=cancel))
        # the server would have held the call for 20 s
        assert time.monotonic() - begin < 10.0


def test_the_batch_has_a_deadline_of_its_own(keyed: Settings) -> None:
    config = replace(PATIENT, max_points=9, parallel=2, batch_s=0.5)
    with FaultServer("timeout") as server:
        begin = time.monotonic()
        with pytest.raises(WeatherError) as caught:
            ask(keyed, server, config=config)
        assert time.monotonic() - begin < 10.0
    assert caught.value.reason == "timeout"
    assert len(server.requests) <= 2


# --- recorded answers -----------------------------------------------------------------------------


def recorded(shared_data: Path, name: str) -> bytes:
    return (shared_data / "weather" / "stormglass" / name).read_bytes()


def test_the_recorded_answer_of_2023_is_a_forecast(keyed: Settings, shared_data: Path) -> None:
    body = recorded(shared_data, "razelkayamdev_forecast-watch-service.json")
    there = (32.0, 34.5, 32.2, 35.0)
    with FaultServer(body=body) as server:
        settings = replace(keyed, stormglass_url=server.url)
        wind = StormGlass(settings, replace(PATIENT, max_points=1)).wind(
            there, departure=None, now=datetime(2023, 2, 19, 6, tzinfo=UTC), job=Job()
        )
    assert wind.time.size == 241
    u, v = from_direction(5.95, 23.54)
    np.testing.assert_allclose(
        (wind.u[0], wind.v[0]), np.broadcast_to([[[u]], [[v]]], (2, *wind.u[0].shape)), atol=1e-5
    )
    assert "Storm Glass follows icon until" in wind.forecast.notice


def test_the_recorded_answer_of_2021_has_no_direction(keyed: Settings, shared_data: Path) -> None:
    body = recorded(shared_data, "DanielRamosAcosta_storm-glass.json")
    with FaultServer(body=body) as server, pytest.raises(SeaCruiseError, match="with a direction"):
        StormGlass(replace(keyed, stormglass_url=server.url), replace(PATIENT, max_points=1)).wind(
            (38.9, 26.0, 39.1, 26.2), departure=None, now=datetime(2021, 9, 25, 6, tzinfo=UTC), job=Job()
        )
