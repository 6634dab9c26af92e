"""Open-Meteo: what is asked, what comes of it, and every fault between here and there."""

from __future__ import annotations

import logging
import threading
import time
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from typing import Any

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.errors import CancelledError, NoPassageError, WeatherError
from seacruise.progress import Job
from seacruise.settings import OPENMETEO_URL, Settings
from seacruise.weather.openmeteo import OpenMeteo, OpenMeteoConfig, horizon_of
from seacruise.weather.openmeteo_answers import Asked, to_marine, to_members, to_wind
from seacruise.weather.openmeteo_client import ENSEMBLE, FORECAST, MARINE
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
from tests.weather.weatherserver import MEMBERS, OPEN_METEO, open_meteo, wind_at

TODAY = datetime(2026, 11, 21, tzinfo=UTC)
CONFIG = OpenMeteoConfig(limits=SHORT, batch_s=5.0, sea_s=0.8, max_points=6, max_ensemble_points=6)
PATIENT = replace(CONFIG, limits=replace(SHORT, read_s=20.0, total_s=20.0), sea_s=20.0, batch_s=40.0)


@pytest.fixture(autouse=True)
def everything_logged(caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.DEBUG)


def ask(
    settings: Settings,
    server: FaultServer,
    *,
    config: OpenMeteoConfig = PATIENT,
    now: datetime = NOW,
    ensemble: bool = False,
    box: tuple[float, float, float, float] = BOX,
    **options: Any,
) -> Wind:
    service = OpenMeteo(replace(settings, openmeteo_url=server.url), config)
    options = {"departure": None, "job": Job(), **options}
    fetch = service.ensemble if ensemble else service.wind
    return fetch(box, now=now, **options)


# --- what goes wrong ------------------------------------------------------------------------------

NO_HOUR = "no wind speed with a direction"
FAILURES = [
    *on_the_way("in a minute"),
    ("A", "503-reason", "bad-response", BROKEN),
    ("C", "400", "bad-response", "Parameter 'start_date' is out of allowed range"),
    ("C", "400-no-data", "bad-response", "No data is available for this location"),
    ("C", "400-text", "bad-response", "it does not say why"),
    ("C", "401", "bad-response", "HTTP 401"),
    ("C", "403", "bad-response", "The supplied API key is invalid"),
    ("C", "429-minutely", "quota", "in a minute"),
    ("C", "429-hourly", "quota", "next full hour"),
    ("C", "429-daily", "quota", "00:00 UTC"),
    ("C", "429-concurrent", "quota", "in a minute"),
    ("D", "portal", "bad-response", "sign in"),
    ("D", "portal-as-json", "bad-response", BAD_JSON),
    ("D", "stream-error", "bad-response", BAD_JSON),
    ("D", "200-error", "bad-response", "Something went wrong inside"),
    ("D", "nan", "bad-response", BAD_JSON),
    ("D", "infinity", "bad-response", BAD_JSON),
    ("D", "1e999", "bad-response", "out of range"),
    ("D", "string-number", "bad-response", r"Expected `float \| null`, got `str`"),
    ("D", "deep", "bad-response", "."),
    ("D", "list", "bad-response", "0 places where 6 were asked"),
    ("D", "no-hourly", "bad-response", "`hourly`"),
    ("D", "no-units", "bad-response", "`hourly_units`"),
    ("D", "empty-hours", "bad-response", "other days"),
    ("D", "no-time", "bad-response", "there are no times"),
    ("D", "no-speed", "bad-response", "there is no wind_speed_10m"),
    ("D", "no-direction", "bad-response", NO_HOUR),
    ("D", "all-null", "bad-response", NO_HOUR),
    ("D", "short", "bad-response", "less than 24 hours"),
    ("D", "not-a-time", "bad-response", "its times are not times"),
    ("D", "milliseconds", "bad-response", "its times are not times"),
    ("D", "last-year", "bad-response", "other days"),
    ("D", "negative", "bad-response", "-1 m/s"),
    ("D", "gale-400", "bad-response", "400 m/s"),
    ("D", "no-place", "bad-response", "`latitude`"),
    ("D", "another-place", "bad-response", "another place"),
    ("D", "ragged", "bad-response", "239 values for 240 times"),
    ("D", "one-too-few", "bad-response", "5 places where 6 were asked"),
    ("E", "unknown-unit", "bad-response", "furlong"),
    ("E", "unsaid-unit", "bad-response", "wind_speed_10m is in ''"),
    ("E", "object-for-array", "bad-response", "1 places where 6 were asked"),
]


@each("behaviour reason words", FAILURES)
def test_fault(settings: Settings, behaviour: str, reason: str, words: str) -> None:
    config = CONFIG if behaviour in LATE else PATIENT
    server = open_meteo(behaviour, today=TODAY)
    sentence = fails(server, lambda one: ask(settings, one, config=config), reason, words)
    # wind and sea were tried at most as often as the limits allow, and redirects not at all
    assert len(server.requests) <= SHORT.tries + 1
    assert {request.path for request in server.requests} <= {"/v1/forecast", "/v1/marine"}

    notice = old_answers_serve(
        open_meteo(today=TODAY),
        open_meteo(behaviour, today=TODAY),
        before=lambda one: ask(settings, one),
        after=lambda one: ask(settings, one, config=config, now=LATER),
    )
    assert "The wind is from an answer 7 h old." in notice or behaviour == "last-year"
    assert sentence in notice or behaviour == "last-year"


SOUND = [
    ("A", "good", ""),
    ("A", "slow", ""),
    ("A", "chunked", ""),
    ("A", "gzip", ""),
    ("D", "null", ""),
    ("D", "null-end", ""),
    ("D", "one-ends-early", "5 of 6 places have an answer; the rest is filled in."),
    ("D", "gusts-end", "Gusts are known until 23 Nov 11:00 UTC"),
    ("D", "waves-end", "Waves are known until 23 Nov 11:00 UTC"),
    ("D", "some-without-direction", ""),
    ("D", "no-gusts", ""),
    ("D", "new-column", ""),
    ("D", "duplicates", ""),
    ("D", "unsorted", ""),
    ("D", "three-hourly", ""),
    ("D", "one-hole", ""),
    ("D", "long-hole", ""),
    ("D", "no-zone", ""),
    ("D", "other-zone", ""),
    ("D", "local-zone", ""),
    ("D", "direction-360", ""),
    ("D", "direction-below", ""),
    ("D", "direction-725", ""),
    ("D", "direction-9999", ""),
    ("D", "twice-the-key", ""),
    ("E", "kmh", ""),
    ("E", "knots", ""),
    ("E", "array-for-object", ""),
    ("D", "marine-503", "There are no waves and current with it. Open-Meteo has trouble of its own"),
    ("D", "marine-null", "There are no waves and current with it. Open-Meteo sent neither"),
    ("D", "marine-garbage", "There are no waves and current with it."),
    ("D", "no-members", ""),
    ("D", "lost-member", ""),
]


@each("behaviour notice", SOUND)
def test_odd_but_sound(settings: Settings, behaviour: str, notice: str) -> None:
    with open_meteo(behaviour, today=TODAY) as server:
        wind = ask(settings, server)
    assert wind.forecast.valid_from == TODAY
    assert wind.forecast.source == "Open-Meteo"
    assert wind.forecast.notice.startswith(notice)
    assert wind.forecast.notice.endswith("non-commercial use.")
    # whatever the unit, the zone and the order: the wind of an hour is the one that was meant
    if not behaviour.startswith("direction"):
        expected = from_direction(*wind_at(BOX[0], BOX[1], 24))
        got = wind.at((TODAY + timedelta(hours=24)).timestamp(), BOX[0], BOX[1])
        np.testing.assert_allclose(got, expected, atol=0.01)


def test_every_behaviour_of_the_server_is_a_case() -> None:
    assert behaviours(FAILURES, SOUND) == set(OPEN_METEO)


@pytest.mark.parametrize("first", ["503", "reset", "truncated", "stream-error", "gzip-corrupt"])
def test_a_passing_fault_is_asked_again(settings: Settings, first: str) -> None:
    with open_meteo(f"{first},good", today=TODAY) as server:
        wind = ask(settings, server, config=replace(PATIENT, parallel=1))
    assert [request.path for request in server.requests] == ["/v1/forecast", "/v1/forecast", "/v1/marine"]
    assert "trouble" not in wind.forecast.notice


@pytest.mark.parametrize(
    "url", ["http://127.0.0.1:9", "http://nowhere.invalid"], ids=["A-refused", "A-no-name"]
)
def test_no_network_is_said_at_once(settings: Settings, url: str) -> None:
    with pytest.raises(WeatherError, match="internet connection") as caught:
        OpenMeteo(replace(settings, openmeteo_url=url), PATIENT).wind(BOX, departure=None, now=NOW, job=Job())
    assert caught.value.reason == "no-network"


def test_a_name_that_is_looked_up_for_ever_is_no_network(
    settings: Settings, monkeypatch: pytest.MonkeyPatch
) -> None:
    never = threading.Event()
    monkeypatch.setattr("socket.getaddrinfo", lambda *_: never.wait(30))
    with pytest.raises(WeatherError, match="cannot be reached") as caught:
        OpenMeteo(
            replace(settings, openmeteo_url="http://nowhere.invalid"), replace(CONFIG, name_s=0.1)
        ).wind(BOX, departure=None, now=NOW, job=Job())
    never.set()
    assert caught.value.reason == "no-network"


def test_cancel_does_not_wait_for_a_name_either(settings: Settings, monkeypatch: pytest.MonkeyPatch) -> None:
    never, cancel = threading.Event(), threading.Event()

    def look_up(*_: object) -> None:
        cancel.set()
        never.wait(30)

    monkeypatch.setattr("socket.getaddrinfo", look_up)
    with pytest.raises(CancelledError):
        OpenMeteo(
            replace(settings, openmeteo_url="http://nowhere.invalid"), replace(CONFIG, name_s=30.0)
        ).wind(BOX, departure=None, now=NOW, job=Job(cancel=cancel))
    never.set()


def test_a_grid_across_the_date_line_asks_for_longitudes_that_exist(settings: Settings) -> None:
    with open_meteo(today=TODAY) as server:
        wind = ask(settings, server, box=(54.0, 178.0, 56.0, 182.0))
    lons = {float(lon) for request in server.requests for lon in request.query["longitude"].split(",")}
    assert all(-180.0 <= lon < 180.0 for lon in lons)
    assert min(lons) < 0 < max(lons)
    assert wind.covers([54.0, 56.0], [178.0, 182.0]).all()


def test_a_server_that_never_answers_is_given_up_within_its_deadline(settings: Settings) -> None:
    config = replace(CONFIG, batch_s=0.6, limits=replace(SHORT, read_s=30.0, total_s=30.0))
    with open_meteo("timeout", today=TODAY) as server:
        begin = time.monotonic()
        with pytest.raises(WeatherError) as caught:
            ask(settings, server, config=config)
        # the server would have held each call for 30 s
        assert time.monotonic() - begin < 10.0
    assert caught.value.reason == "timeout"


def test_the_usual_deadline_is_within_half_a_minute() -> None:
    config = OpenMeteoConfig()
    assert config.name_s + config.batch_s <= 32.0
    assert config.limits.total_s + config.sea_s <= config.batch_s <= 30.0
    assert config.limits.connect_s <= 5.0


def test_cancel_does_not_wait_for_a_server_that_says_nothing(settings: Settings) -> None:
    cancel = threading.Event()

    def report(stage: str, fraction: float | None, message: str) -> None:
        threading.Timer(0.1, cancel.set).start()

    with open_meteo("timeout", today=TODAY) as server:
        begin = time.monotonic()
        with pytest.raises(CancelledError):
            ask(settings, server, job=Job(report=report, cancel=cancel))
        # the server would have held the call for 20 s
        assert time.monotonic() - begin < 10.0


# --- what is asked --------------------------------------------------------------------------------


def test_the_wind_is_asked_for_in_metres_per_second_and_utc(settings: Settings) -> None:
    told: list[str] = []
    job = Job(report=lambda stage, fraction, message: told.append(message))
    with open_meteo(today=TODAY) as server:
        wind = ask(settings, server, config=replace(PATIENT, max_points=200), job=job)
    wanted = {request.path: request.query for request in server.requests}
    assert set(wanted) == {"/v1/forecast", "/v1/marine"}
    query = wanted["/v1/forecast"]
    assert query["wind_speed_unit"] == "ms"
    assert (query["timeformat"], query["timezone"], query["cell_selection"]) == ("unixtime", "GMT", "sea")
    assert query["hourly"] == "wind_speed_10m,wind_direction_10m,wind_gusts_10m"
    assert server.most_at_once <= 2
    assert told[0] == f"Open-Meteo: {len(server.requests)} requests for {2 * wind.u[0].size} places"
    assert wind.time.size == 240
    # the finest step of the models behind it, where the area is small
    assert wind.forecast.resolution_deg == 0.25
    assert np.diff(wind.lon)[0] == 0.25
    assert wind.covers([BOX[0], BOX[2]], [BOX[1], BOX[3]]).all()


def test_a_long_passage_gets_a_coarser_grid_in_a_few_requests(settings: Settings) -> None:
    with open_meteo(today=TODAY) as server:
        wind = ask(settings, server, config=replace(PATIENT, max_points=200), box=(53.0, 9.0, 66.0, 30.0))
    assert wind.forecast.resolution_deg > 0.5
    assert wind.u[0].size <= 200
    assert len(server.requests) == 4
    places = [len(request.query["latitude"].split(",")) for request in server.requests]
    assert max(places) <= 100


def test_the_wind_at_every_node_is_the_service_s(settings: Settings) -> None:
    with open_meteo(today=TODAY) as server:
        wind = ask(settings, server)
    for row, lat in enumerate(wind.lat):
        for column, lon in enumerate(wind.lon):
            expected = from_direction(*wind_at(lat, lon, 30))
            np.testing.assert_allclose(
                (wind.u[30, row, column], wind.v[30, row, column]), expected, atol=1e-5
            )
    assert wind.gust is not None
    np.testing.assert_allclose(wind.gust, np.hypot(wind.u, wind.v) * 1.4, atol=0.02)


def test_the_current_goes_to_where_the_service_says(settings: Settings) -> None:
    with open_meteo(today=TODAY) as server:
        wind = ask(settings, server)
    assert wind.current is not None
    # 90 degrees is a current that sets to the east, unlike a wind of 90 degrees
    np.testing.assert_allclose(wind.current.u, 0.3, atol=1e-6)
    np.testing.assert_allclose(wind.current.v, 0.0, atol=1e-6)
    assert wind.current.forecast.source == "Open-Meteo marine"


def test_the_sea_is_asked_at_sea_only_and_the_wind_everywhere(settings: Settings) -> None:
    with open_meteo(today=TODAY) as server:
        wind = ask(settings, server, is_water=lambda lat, lon: np.asarray(lon) > 18.0)
    sea = next(request for request in server.requests if request.path == "/v1/marine")
    assert all(float(lon) > 18.0 for lon in sea.query["longitude"].split(","))
    land = next(request for request in server.requests if request.path == "/v1/forecast")
    assert any(float(lon) < 18.0 for lon in land.query["longitude"].split(","))
    assert wind.wave is not None
    # on land stand the waves of the nearest sea, in the same row
    nearest = int(np.argmax(wind.lon > 18.0))
    np.testing.assert_array_equal(wind.wave[:, :, 0], wind.wave[:, :, nearest])


def test_a_passage_without_any_sea_around_it_has_wind_and_no_waves(settings: Settings) -> None:
    with open_meteo(today=TODAY) as server:
        wind = ask(settings, server, is_water=lambda lat, lon: np.zeros(np.shape(lat), dtype=np.bool_))
    assert wind.wave is None
    assert wind.current is None
    assert [request.path for request in server.requests] == ["/v1/forecast"]
    assert "There are no waves and current with it." in wind.forecast.notice


def test_the_horizon_is_where_the_values_end(settings: Settings) -> None:
    with open_meteo("null-end", today=TODAY) as server:
        wind = ask(settings, server)
    assert wind.forecast.valid_to == TODAY + timedelta(hours=99)
    with open_meteo("one-ends-early", today=TODAY) as server:
        wind = ask(settings, server, now=NOW + timedelta(hours=4))
    # a single place does not cut the others short
    assert wind.forecast.valid_to == TODAY + timedelta(hours=239)
    with open_meteo("long-hole", today=TODAY) as server:
        wind = ask(settings, server, now=NOW + timedelta(hours=7))
    assert wind.forecast.valid_to == TODAY + timedelta(hours=79)


def test_the_service_s_own_hosts_are_three(settings: Settings) -> None:
    own = replace(settings, openmeteo_url=OPENMETEO_URL)
    assert FORECAST.url(own) == "https://api.open-meteo.com/v1/forecast"
    assert MARINE.url(own) == "https://marine-api.open-meteo.com/v1/marine"
    assert ENSEMBLE.url(own) == "https://ensemble-api.open-meteo.com/v1/ensemble"
    assert MARINE.url(settings) == "http://127.0.0.1:9/v1/marine"


@pytest.mark.parametrize("days", [-1, 11])
def test_a_day_without_a_forecast_costs_no_request(settings: Settings, days: int) -> None:
    assert horizon_of(NOW) == (TODAY, TODAY + timedelta(days=10))
    with open_meteo(today=TODAY) as server, pytest.raises(NoPassageError, match="21 Nov 2026") as caught:
        ask(settings, server, departure=NOW + timedelta(days=days))
    assert caught.value.reason == "outside-forecast"
    assert server.requests == []


# --- the ensemble ---------------------------------------------------------------------------------


def test_members_are_winds_and_their_mean_is_the_wind(settings: Settings) -> None:
    with open_meteo(today=TODAY) as server:
        wind = ask(settings, server, ensemble=True)
    assert [request.path for request in server.requests] == ["/v1/ensemble"]
    assert server.requests[0].query["models"] == "ecmwf_ifs025_ensemble"
    assert len(wind.members) == MEMBERS
    u, v = (np.stack([getattr(member, name) for member in wind.members]) for name in ("u", "v"))
    np.testing.assert_allclose(wind.u, u.mean(axis=0), atol=1e-5)
    assert wind.spread is not None
    np.testing.assert_allclose(wind.spread, np.sqrt(u.var(axis=0) + v.var(axis=0)), atol=1e-4)
    for number, member in enumerate(wind.members):
        expected = from_direction(*wind_at(wind.lat[0], wind.lon[0], 12, number))
        np.testing.assert_allclose((member.u[12, 0, 0], member.v[12, 0, 0]), expected, atol=1e-5)
    assert f"mean of {MEMBERS} members" in wind.forecast.source


def test_an_ensemble_is_asked_for_ten_places_at_a_time(settings: Settings) -> None:
    with open_meteo(today=TODAY) as server:
        wind = ask(settings, server, ensemble=True, config=replace(PATIENT, max_ensemble_points=40))
    places = [len(request.query["latitude"].split(",")) for request in server.requests]
    assert max(places) <= 10
    assert sum(places) == wind.u[0].size <= 40


@pytest.mark.parametrize(
    ("behaviour", "words"),
    [("no-members", "no ensemble"), ("503", BROKEN), ("stream-error", BAD_JSON), ("429-daily", "00:00 UTC")],
)
def test_an_ensemble_that_fails_says_why(settings: Settings, behaviour: str, words: str) -> None:
    with open_meteo(behaviour, today=TODAY) as server, pytest.raises(WeatherError, match=words):
        ask(settings, server, ensemble=True)


def test_a_lost_member_is_left_out(settings: Settings) -> None:
    with open_meteo("lost-member", today=TODAY) as server:
        wind = ask(settings, server, ensemble=True)
    assert len(wind.members) == MEMBERS - 1


# --- what is kept ---------------------------------------------------------------------------------


@pytest.mark.parametrize("ensemble", [False, True])
def test_a_second_plan_of_the_same_passage_sends_nothing(settings: Settings, ensemble: bool) -> None:
    told: list[str] = []
    job = Job(report=lambda stage, fraction, message: told.append(message))
    with open_meteo(today=TODAY) as server:
        first = ask(settings, server, ensemble=ensemble)
        sent = len(server.requests)
        second = ask(settings, server, ensemble=ensemble, now=NOW + timedelta(hours=1), job=job)
    assert len(server.requests) == sent
    assert told == ["Open-Meteo: no request needed, the answers kept are new enough"]
    for name in ("u", "v", "gust", "wave", "spread"):
        np.testing.assert_array_equal(getattr(first, name), getattr(second, name))
    assert second.forecast == first.forecast


@pytest.mark.parametrize(("minutes", "asked"), [(149, False), (151, True)])
def test_answers_are_kept_until_the_models_have_run_again(
    settings: Settings, minutes: int, asked: bool
) -> None:
    with open_meteo(today=TODAY) as server:
        ask(settings, server)
        sent = len(server.requests)
        # fetched at 09:30; the next cycle begins at 12:00
        ask(settings, server, now=NOW + timedelta(minutes=minutes))
    assert (len(server.requests) > sent) is asked


def test_an_answer_just_before_the_next_run_is_kept_for_an_hour(settings: Settings) -> None:
    late = datetime(2026, 11, 21, 11, 59, tzinfo=UTC)
    with open_meteo(today=TODAY) as server:
        ask(settings, server, now=late)
        sent = len(server.requests)
        ask(settings, server, now=late + timedelta(minutes=59))
        assert len(server.requests) == sent
        ask(settings, server, now=late + timedelta(minutes=61))
    assert len(server.requests) > sent


def test_what_arrived_before_the_limit_is_kept_and_the_rest_filled_in(settings: Settings) -> None:
    config = replace(PATIENT, max_points=200, parallel=1)
    with open_meteo("good,429-minutely", today=TODAY) as server:
        wind = ask(settings, server, config=config, box=(53.0, 9.0, 66.0, 30.0))
    total = wind.u[0].size
    assert (
        f"{total - total // 2} of {total} places have an answer; the rest is filled in."
        in wind.forecast.notice
    )
    assert "in a minute" in wind.forecast.notice
    # neighbours are asked in different requests, so every hole has neighbours that know
    lat, lon = float(wind.lat[1]), float(wind.lon[2])
    speed = np.hypot(*wind.at(TODAY.timestamp(), lat, lon))
    assert speed == pytest.approx(wind_at(lat, lon, 0)[0], abs=0.3)


def test_old_answers_that_end_before_the_departure_are_of_no_use(settings: Settings) -> None:
    with open_meteo(today=TODAY) as server:
        ask(settings, server)
    with open_meteo("503", today=TODAY) as server, pytest.raises(WeatherError, match=BROKEN):
        ask(settings, server, now=NOW + timedelta(days=9), departure=NOW + timedelta(days=12))


# --- the adapter's own laws -----------------------------------------------------------------------

ASKED = Asked(((55.0, 18.0),), now=0.0)


@given(
    st.binary(max_size=400)
    | st.text(alphabet='{}[]":,0123456789.-eE hourlytimewindspeed_10m', max_size=200).map(str.encode)
)
def test_any_bytes_are_an_answer_or_an_error(body: bytes) -> None:
    for decode in (to_wind, to_marine, to_members):
        with pytest.raises((msgspec.DecodeError, UnicodeDecodeError, WeatherError)):
            decode(body, ASKED)


VALUES = st.lists(
    st.none()
    | st.integers(-(10**12), 10**12)
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(max_size=3),
    max_size=4,
)


@given(
    st.dictionaries(st.sampled_from(["time", "wind_speed_10m", "wind_direction_10m", "x"]), VALUES), VALUES
)
def test_any_document_is_finite_wind_or_an_error(hourly: dict[str, Any], odd: list[Any]) -> None:
    units = {"wind_speed_10m": "m/s", "wind_direction_10m": "°"}
    body = msgspec.json.encode(
        {"latitude": 55, "longitude": 18, "hourly_units": units, "hourly": {**hourly, "odd": odd}}
    )
    try:
        (series,) = to_wind(body, ASKED)
    except (msgspec.DecodeError, WeatherError):
        return
    assert (np.diff(series.time) > 0).all()
    assert (np.hypot(series.values["u"], series.values["v"])[np.isfinite(series.values["u"])] <= 120.01).all()
