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

from seacruise.errors import CancelledError, InputError, NoPassageError, SeaCruiseError, WeatherError
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.store import Store
from seacruise.weather.cache import _STEPS, Memory, WeatherCache
from seacruise.weather.http import Limits
from seacruise.weather.source import fetch_wind
from seacruise.weather.stormglass import StormGlass, StormGlassConfig, config_named
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
    ("nan-text", "bad-response", r"Expected `float \| null`, got `str`"),
    ("null-hour", "bad-response", OTHER_SHAPE),
    ("hours-by-name", "bad-response", OTHER_SHAPE),
    ("no-time", "bad-response", OTHER_SHAPE),
    ("next-month", "bad-response", "other days"),
    ("bom", "bad-response", BAD_JSON),
    ("utf-16", "bad-response", BAD_JSON),
    ("text-after", "bad-response", BAD_JSON),
    ("gzip-lie", "bad-response", CUT),
    ("octets", "bad-response", "Something else answered"),
    ("length-short", "bad-response", BAD_JSON),
    ("reset-after-head", "bad-response", CUT),
    ("login", "bad-response", "not followed"),
    # the HTTP library takes hints for the answer; they are only sent to those who ask for them
    ("early-hints", "bad-response", "HTTP 103"),
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
    ("odd-names", ""),
    ("more-told", ""),
    ("odd-extras", ""),
    ("brotli-lie", ""),
    ("no-type", ""),
]


@pytest.mark.parametrize(("behaviour", "notice"), SOUND, ids=[case[0] for case in SOUND])
def test_an_odd_but_sound_answer_is_used(keyed: Settings, behaviour: str, notice: str) -> None:
    with FaultServer(behaviour) as server:
        wind = ask(keyed, server)
    assert wind.forecast.valid_from == TODAY
    assert notice in wind.forecast.notice
    assert wind.forecast.source == "Storm Glass (sg)"
    assert_key_nowhere(keyed, None)


SKEWED = [("tomorrow", timedelta(days=1)), ("half-hours", timedelta(minutes=30))]


@pytest.mark.parametrize(("behaviour", "by"), SKEWED, ids=[case[0] for case in SKEWED])
def test_the_times_are_the_answer_s_not_those_asked(keyed: Settings, behaviour: str, by: timedelta) -> None:
    with FaultServer(behaviour) as server:
        wind = ask(keyed, server)
    assert wind.forecast.valid_from == TODAY + by
    assert wind.forecast.valid_to == TODAY + by + timedelta(hours=239)


def test_every_behaviour_of_the_server_is_a_case() -> None:
    cases = [*FAILURES, *SOUND, *SKEWED]
    assert {str(case[0]) for case in cases} == set(BEHAVIOURS)
    assert len(cases) == len(BEHAVIOURS)


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
    assert set(query["params"].split(",")) == {
        "windSpeed",
        "windDirection",
        "gust",
        "waveHeight",
        "currentSpeed",
        "currentDirection",
    }
    assert "source" not in query
    count = len(server.requests)
    assert told[0][2] == "Storm Glass: up to 9 requests, 10 a day on this plan"
    assert [message for _, _, message in told[1:]] == [f"wind {n} of 9" for n in range(1, count + 1)]
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
    assert "The wind is from Storm Glass, 14 h old" in wind.forecast.notice
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
    # the plan is for nine; what is left is used
    assert server.used == 10


def test_what_arrived_before_the_quota_ran_out_is_kept(keyed: Settings) -> None:
    config = replace(PATIENT, max_points=9, parallel=1)
    with FaultServer(quota=10, used=4) as server:
        wind = ask(keyed, server, config=config)
    assert len(server.requests) == 7
    assert "6 of 7 places have an answer" in wind.forecast.notice
    assert "resets at 00:00 UTC" in wind.forecast.notice


def test_a_wrong_key_is_not_tried_on_every_place(keyed: Settings) -> None:
    with FaultServer("403") as server, pytest.raises(WeatherError):
        ask(keyed, server, config=replace(PATIENT, max_points=9, parallel=1))
    assert len(server.requests) == 1


def test_half_of_the_places_are_enough(keyed: Settings) -> None:
    config = replace(PATIENT, max_points=6, parallel=1, limits=replace(PATIENT.limits, tries=1))
    with FaultServer("503,503,good") as server:
        wind = ask(keyed, server, config=config)
    assert "4 of 6 places have an answer" in wind.forecast.notice
    # another source, so that the first answers cannot stand in
    config = replace(config, source="noaa")
    with FaultServer("good,good,503") as server, pytest.raises(WeatherError, match=BROKEN):
        ask(replace(keyed, stormglass_key="another"), server, config=config)


def test_a_day_without_a_forecast_costs_no_request(keyed: Settings) -> None:
    with FaultServer() as server:
        for departure in (TODAY - timedelta(hours=1), TODAY + timedelta(days=11)):
            with pytest.raises(NoPassageError, match="21 Nov 2026 00:00 to 01 Dec 2026 00:00 UTC") as caught:
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
            db.execute("UPDATE weather_body SET body = substr(body, 1, 50)")
        ask(keyed, server)
    assert len(server.requests) == 4
    assert len(WeatherCache(store).ages(NOW)) == 2


def broken_store(monkeypatch: pytest.MonkeyPatch, pragma: str) -> None:
    connect = Store._connect

    def limited(self: Store) -> Any:
        connection = connect(self)
        connection.execute(pragma)
        return connection

    monkeypatch.setattr(Store, "_connect", limited)


@pytest.mark.parametrize("more", [0, 1, 3, 6, 10])
def test_a_disk_that_fills_up_costs_no_forecast(
    keyed: Settings, monkeypatch: pytest.MonkeyPatch, more: int
) -> None:
    Memory(keyed.database)
    with Store(keyed.database).reading() as db:
        pages = db.execute("PRAGMA page_count").fetchone()[0]
    broken_store(monkeypatch, f"PRAGMA max_page_count = {pages + more}")
    told: list[str] = []
    with FaultServer() as server:
        wind = ask(keyed, server, config=NINE, job=Job(report=lambda *parts: told.append(parts[2])))
    assert wind.time.size == 240
    assert any("Forecasts are not kept" in message and "disk is full" in message for message in told)
    with Store(keyed.database).reading() as db:
        assert db.execute("PRAGMA integrity_check").fetchone() == ("ok",)


def test_a_file_that_may_only_be_read_costs_no_forecast(
    keyed: Settings, monkeypatch: pytest.MonkeyPatch
) -> None:
    Memory(keyed.database)
    broken_store(monkeypatch, "PRAGMA query_only = ON")
    told: list[str] = []
    with FaultServer() as server:
        wind = ask(keyed, server, job=Job(report=lambda *parts: told.append(parts[2])))
    assert wind.time.size == 240
    assert any("cannot be written; set SEACRUISE_HOME" in message for message in told)


def test_a_file_of_a_newer_version_costs_no_forecast(keyed: Settings) -> None:
    Store(keyed.database).migrate("weather", [*_STEPS, "CREATE TABLE weather_future (x)"])
    told: list[str] = []
    with FaultServer() as server:
        wind = ask(keyed, server, job=Job(report=lambda *parts: told.append(parts[2])))
    assert wind.time.size == 240
    assert any("newer SeaCruise" in message for message in told)
    with Store(keyed.database).reading() as db:
        assert db.execute("SELECT COUNT(*) FROM weather_future").fetchone() == (0,)


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


def test_a_server_that_never_answers_is_given_up_after_one_deadline(keyed: Settings) -> None:
    # nine places, two at a time: the first two tell all there is to tell
    config = replace(CONFIG, max_points=9, parallel=2, quiet_s=0.4)
    with FaultServer("timeout") as server:
        with pytest.raises(WeatherError, match="did not answer") as caught:
            ask(keyed, server, config=config)
        assert len({(r.query["lat"], r.query["lng"]) for r in server.requests}) <= 2
    assert caught.value.reason == "timeout"
    assert StormGlassConfig().quiet_s == StormGlassConfig().limits.total_s == 30.0


# --- what else is told, and by whom ---------------------------------------------------------------


def test_gusts_waves_and_current_come_with_the_wind(keyed: Settings) -> None:
    with FaultServer("more-told") as server:
        wind = ask(keyed, server)
    assert len(server.requests) == 2
    assert wind.gust is not None
    np.testing.assert_allclose(wind.gust[:144], 1.4 * np.hypot(wind.u, wind.v)[:144], rtol=0.02)
    assert wind.wave is not None
    # the hours without are bridged, and the model that has most of them is taken
    np.testing.assert_allclose(wind.wave, 1.5, rtol=1e-6)
    assert wind.current is not None
    # it comes from the south, as the wind's directions are told
    np.testing.assert_allclose(wind.current.u, 0.0, atol=1e-6)
    np.testing.assert_allclose(wind.current.v, 0.3, rtol=1e-6)
    assert wind.spread is None


def test_without_more_there_is_the_wind_alone(keyed: Settings) -> None:
    with FaultServer("odd-extras") as server:
        wind = ask(keyed, server)
    assert (wind.gust, wind.wave, wind.current, wind.spread) == (None, None, None, None)


def test_one_model_is_had_by_name(keyed: Settings) -> None:
    with FaultServer() as server:
        wind = ask(keyed, server, config=replace(PATIENT, source="noaa"))
    lat, lon = (float(server.requests[0].query[name]) for name in ("lat", "lng"))
    sent = hour_of(lat, lon, TODAY + timedelta(hours=30), 30)
    expected = from_direction(sent["windSpeed"]["noaa"], sent["windDirection"]["noaa"])
    got = wind.at((TODAY + timedelta(hours=30)).timestamp(), lat, lon)
    np.testing.assert_allclose(got, expected, atol=1e-5)
    assert wind.forecast.source == "Storm Glass (noaa)"
    assert wind.forecast.notice == ""


def test_the_mean_of_models_knows_how_far_they_differ(keyed: Settings) -> None:
    with FaultServer() as server:
        wind = ask(keyed, server, config=replace(PATIENT, source="ecmwf+noaa"))
    lat, lon = (float(server.requests[0].query[name]) for name in ("lat", "lng"))
    sent = hour_of(lat, lon, TODAY + timedelta(hours=30), 30)
    one, two = (
        np.array(from_direction(sent["windSpeed"][model], sent["windDirection"][model]))
        for model in ("ecmwf", "noaa")
    )
    time = (TODAY + timedelta(hours=30)).timestamp()
    np.testing.assert_allclose(wind.at(time, lat, lon), (one + two) / 2, atol=1e-5)
    assert wind.spread is not None
    row, column = (int(np.abs(axis - here).argmin()) for axis, here in ((wind.lat, lat), (wind.lon, lon)))
    assert wind.spread[30, row, column] == pytest.approx(np.hypot(*(one - two)) / 2, abs=1e-4)
    # ecmwf ends after six days; how far it would differ from then on is not known, so the last is held
    np.testing.assert_array_equal(wind.spread[150], wind.spread[239])
    assert "follows ecmwf+noaa until 27 Nov 00:00 UTC, then noaa" in wind.forecast.notice


def test_another_source_is_another_question(keyed: Settings) -> None:
    with FaultServer(quota=50) as server:
        ask(keyed, server)
        ask(keyed, server, config=replace(PATIENT, source="noaa"))
    assert len(server.requests) == 4


@pytest.mark.parametrize(
    ("name", "source"),
    [
        ("stormglass", "sg"),
        ("StormGlass", "sg"),
        ("stormglass:noaa", "noaa"),
        ("stormglass:ecmwf:aifs", "ecmwf:aifs"),
        ("stormglass:ecmwf:aifs+noaa", "ecmwf:aifs+noaa"),
    ],
)
def test_names_of_models_follow_a_colon(name: str, source: str) -> None:
    assert config_named(name).source == source


def test_a_forecast_s_name_chooses_the_model_and_its_ends_the_places(keyed: Settings) -> None:
    options: Any = {"start": ENDS[0], "end": ENDS[1], "departure": None, "job": Job(), "now": NOW}
    with FaultServer() as server:
        there = replace(keyed, stormglass_url=server.url)
        wind = fetch_wind(["stormglass:noaa"], settings=there, **options)
    assert wind.forecast.source == "Storm Glass (noaa)"
    # six places on the way, though the area is four times as wide
    assert len(server.requests) == 6
    assert all(17.9 < float(request.query["lng"]) < 18.9 for request in server.requests)


@pytest.mark.parametrize("name", ["stormglass:", "stormglass:a+", "stormglass:a b", "stormglass:" + "a" * 30])
def test_a_name_that_is_no_model_s_is_refused(name: str) -> None:
    with pytest.raises(InputError, match="names no model of Storm Glass"):
        config_named(name)


def test_a_model_with_a_faster_cycle_expires_earlier() -> None:
    assert StormGlassConfig().cycle_s == 6 * 3600
    assert config_named("stormglass:metno+noaa").cycle_s == 4 * 3600


# --- the plan of places ---------------------------------------------------------------------------

ENDS = ((54.5, 18.6), (57.7, 18.2))
NINE = replace(PATIENT, max_points=40)


def messages(settings: Settings, server: FaultServer, **options: Any) -> tuple[list[str], Wind]:
    told: list[str] = []
    job = Job(report=lambda stage, fraction, message: told.append(message))
    wind = ask(settings, server, config=NINE, job=job, ends=ENDS, **options)
    return told, wind


def test_the_plan_is_told_before_the_first_request(keyed: Settings) -> None:
    with FaultServer(quota=10, used=1) as server:
        ask(keyed, server, config=replace(PATIENT, max_points=1, source="noaa"))
        seen: list[tuple[str, int]] = []
        job = Job(report=lambda stage, fraction, message: seen.append((message, len(server.requests))))
        ask(keyed, server, config=NINE, job=job, ends=ENDS)
    assert seen[0] == ("Storm Glass: up to 8 requests, 8 left today; 9 were planned", 1)


def test_a_plan_shrinks_to_what_is_left_and_keeps_both_ends(keyed: Settings) -> None:
    with FaultServer(quota=10, used=5) as server:
        ask(keyed, server, config=replace(PATIENT, max_points=1, source="noaa"))
        told, wind = messages(keyed, server)
    assert told[0] == "Storm Glass: 4 requests, 4 left today; 9 were planned"
    assert server.used == 10
    places = [(float(r.query["lat"]), float(r.query["lng"])) for r in server.requests[1:]]
    for end in ENDS:
        assert min(np.hypot(lat - end[0], (lon - end[1]) / 2) for lat, lon in places) < 0.25
    assert "Only 4 of 9 planned places were asked: no more requests were left today." in wind.forecast.notice


def test_one_request_is_no_plan(keyed: Settings) -> None:
    with FaultServer(quota=10, used=8) as server:
        ask(keyed, server, config=replace(PATIENT, max_points=1, source="noaa"))
        with pytest.raises(WeatherError, match="has only 1 left for today") as caught:
            messages(keyed, server)
        assert len(server.requests) == 1
    assert caught.value.reason == "quota"


def test_a_forecast_of_today_is_better_than_a_few_new_answers(keyed: Settings) -> None:
    with FaultServer(quota=10) as server:
        first = messages(keyed, server)[1]
        sent = len(server.requests)
        second = messages(keyed, server, now=NOW + timedelta(hours=7))[1]
    # what is left does not buy the first places of a plan
    assert len(server.requests) == sent == 6
    assert "The wind is from Storm Glass, 7 h old. Storm Glass has only 4 left" in second.forecast.notice
    np.testing.assert_array_equal(first.u, second.u)


@pytest.mark.parametrize("url", ["http://127.0.0.1:9", "http://nowhere.invalid"])
def test_without_a_network_the_cache_is_used_and_says_its_age(keyed: Settings, url: str) -> None:
    with FaultServer(quota=10) as server:
        first = messages(keyed, server)[1]
    there = replace(keyed, stormglass_url=url)
    # the day after, so that requests are left; for a departure that the old answers reach
    later = NOW + timedelta(hours=20)
    wind = StormGlass(there, NINE).wind(
        BOX, departure=later + timedelta(days=2), now=later, job=Job(), ends=ENDS
    )
    assert "The wind is from Storm Glass, 20 h old; the service could not be reached." in wind.forecast.notice
    assert wind.forecast.issued == NOW
    np.testing.assert_array_equal(first.u, wind.u)
    # elsewhere it is of no use
    with pytest.raises(WeatherError, match="cannot be reached"):
        StormGlass(there, NINE).wind(
            (54.0, 10.0, 58.0, 12.0),
            departure=None,
            now=later,
            job=Job(),
            ends=((54.5, 10.5), (57.5, 11.5)),
        )


def test_answers_for_another_passage_are_better_than_none(keyed: Settings) -> None:
    with FaultServer(quota=10) as server:
        # an area, as it is asked for all ports in reach
        ask(keyed, server, config=replace(NINE, max_points=9, first=9))
        told, wind = messages(keyed, server)
        assert len(server.requests) == 9
        assert told == []
        assert "asked for another passage and lie up to" in wind.forecast.notice
        assert "has only 1 left for today" in wind.forecast.notice
        # where they are too far away nothing is made up
        with pytest.raises(WeatherError, match="has only 1 left"):
            StormGlass(replace(keyed, stormglass_url=server.url), NINE).wind(
                (58.0, 21.0, 62.0, 24.0),
                departure=None,
                now=NOW,
                job=Job(),
                ends=((58.5, 21.5), (61.5, 23.5)),
            )


@pytest.mark.parametrize("failing", [0, 1])
def test_without_an_answer_at_an_end_there_is_no_wind(keyed: Settings, failing: int) -> None:
    behaviour = ",".join("503" if number == failing else "good" for number in range(6))
    config = replace(NINE, parallel=1, max_points=6, limits=replace(PATIENT.limits, tries=1))
    with FaultServer(behaviour) as server, pytest.raises(WeatherError, match=BROKEN):
        ask(keyed, server, config=config, ends=ENDS)


def test_one_place_between_may_fail_but_no_two_neighbours(keyed: Settings) -> None:
    config = replace(NINE, parallel=1, max_points=6, limits=replace(PATIENT.limits, tries=1))
    with FaultServer("good,good,503,good,good,good") as server:
        wind = ask(keyed, server, config=config, ends=ENDS)
    assert "5 of 6 places have an answer; the wind between them is filled in." in wind.forecast.notice
    other = replace(config, source="noaa")
    with FaultServer("good,good,503,503,503,good", quota=50) as server, pytest.raises(WeatherError):
        ask(replace(keyed, stormglass_key="another"), server, config=other, ends=ENDS)


def test_answers_of_an_earlier_version_are_used(keyed: Settings) -> None:
    with FaultServer(quota=10) as server:
        first = ask(keyed, server)
        sent = len(server.requests)
        with Store(keyed.database).writing() as db:
            db.execute(
                "UPDATE weather_forecast SET service = 'stormglass gust,windDirection,windSpeed sg', "
                "expires = NULL, last = NULL"
            )
        second = ask(keyed, server, now=NOW + timedelta(hours=5))
        assert len(server.requests) == sent
    np.testing.assert_array_equal(first.u, second.u)


def test_a_day_that_ends_during_a_plan_is_counted_by_the_service(keyed: Settings) -> None:
    # eight were used yesterday; at midnight the service begins again
    with FaultServer(used=7) as server:
        ask(keyed, server, config=replace(PATIENT, max_points=1))
        server.used = 0
        ask(keyed, server, config=replace(PATIENT, max_points=1, source="noaa"))
        quota = StormGlass(keyed).quota(NOW)
    assert (quota.used, quota.left) == (1, 9)


def test_midnight_passes_during_a_plan(keyed: Settings) -> None:
    before = datetime(2026, 11, 21, 23, 59, 59, 900_000, tzinfo=UTC)
    with FaultServer("slow", slow_s=0.3) as server:
        ask(keyed, server, config=replace(PATIENT, max_points=1), now=before)
        stormglass = StormGlass(keyed)
    assert (stormglass.quota(before).used, stormglass.quota(before + timedelta(minutes=1)).used) == (0, 1)


def test_an_answer_that_ends_early_does_not_cut_the_others_short(keyed: Settings) -> None:
    config = replace(NINE, parallel=1, max_points=6)
    with FaultServer("good,good,all-end,good") as server:
        wind = ask(keyed, server, config=config, ends=ENDS)
    assert wind.time.size == 240


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
