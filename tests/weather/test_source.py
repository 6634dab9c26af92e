"""One way to the wind: names, files, horizons, and what ``weather info`` tells."""

from __future__ import annotations

import subprocess
import sys
import urllib.request
from collections.abc import Iterator
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import msgspec
import netCDF4
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.commands import request
from seacruise.errors import CancelledError, InputError, NoPassageError, WeatherError
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.weather.answers import decode_answer, decode_meta, to_point
from seacruise.weather.sample import sample_wind
from seacruise.weather.source import NAMES, fetch_wind, horizon, weather_info
from seacruise.weather.wind import Wind
from tests.conftest import REPOSITORY
from tests.faultserver import FaultServer
from tests.weather.weatherserver import met_norway, open_meteo
from tests.weather.worlds import write_layers

GDYNIA, STOCKHOLM = (54.52, 18.56), (59.32, 18.08)
NOW = datetime(2026, 11, 21, 9, 30, tzinfo=UTC)


def get(settings: Settings, *names: str, **options: Any) -> Wind:
    options = {"start": GDYNIA, "end": STOCKHOLM, "departure": None, "job": Job(), "now": NOW, **options}
    return fetch_wind(list(names), settings=settings, **options)


def write_wind(path: Path, *, plus: float = 0.0, lat0: float = 53.0) -> str:
    with netCDF4.Dataset(path, "w") as file:
        axes = {"time": np.arange(3) * 6.0, "lat": lat0 + np.arange(8.0), "lon": 15.0 + np.arange(6.0)}
        for name, unit in (
            ("time", "hours since 2026-11-21"),
            ("lat", "degrees_north"),
            ("lon", "degrees_east"),
        ):
            file.createDimension(name, len(axes[name]))
            axis = file.createVariable(name, "f8", (name,))
            axis.units = unit
            axis[:] = axes[name]
        for name in ("u10", "v10"):
            component = file.createVariable(name, "f4", ("time", "lat", "lon"))
            component.units = "m s-1"
            component[:] = 5.0 + plus
    return str(path)


def test_practice_and_sample_are_had_by_name(settings: Settings) -> None:
    assert "not a forecast" in get(settings, "practice").forecast.source
    np.testing.assert_array_equal(get(settings, "Sample").u, sample_wind().u)


def test_auto_is_open_meteo_without_a_key_and_says_why(settings: Settings) -> None:
    told: list[str] = []
    with open_meteo(today=NOW.replace(hour=0, minute=0)) as server:
        there = replace(settings, openmeteo_url=server.url)
        wind = get(there, "auto", job=Job(report=lambda stage, fraction, message: told.append(message)))
    assert wind.forecast.source == "Open-Meteo"
    assert wind.forecast.real
    assert told[0] == "Wind from Open-Meteo, because no Storm Glass key is set"
    assert wind.covers([GDYNIA[0], STOCKHOLM[0]], [GDYNIA[1], STOCKHOLM[1]]).all()


def test_auto_is_practice_without_a_network_and_says_why(settings: Settings) -> None:
    told: list[str] = []
    wind = get(settings, "auto", job=Job(report=lambda stage, fraction, message: told.append(message)))
    assert "Practice" in wind.forecast.source
    assert not wind.forecast.real
    why = (
        "It stands in because no Storm Glass key is set and Open-Meteo failed (Open-Meteo cannot be reached)."
    )
    assert wind.forecast.notice == f"Practice weather: generated, not a forecast. {why}"
    assert told[0] == "Wind from Open-Meteo, because no Storm Glass key is set"
    assert told[-1] == f"Practice weather, not a forecast. {why}"


@pytest.mark.parametrize(
    ("behaviour", "why"),
    [("429-daily", "as often as it does without payment"), ("portal", "hotel"), ("nan", "not JSON")],
)
def test_auto_is_practice_when_open_meteo_fails(settings: Settings, behaviour: str, why: str) -> None:
    with open_meteo(behaviour) as server:
        wind = get(replace(settings, openmeteo_url=server.url), "auto")
    assert not wind.forecast.real
    assert why in wind.forecast.notice


def test_practice_does_not_stand_in_where_it_is_of_no_use(settings: Settings) -> None:
    # off Lisbon there is no practice weather, and after seven days none anywhere
    for options in ({"start": (38.5, -9.5), "end": (37.0, -9.2)}, {"departure": NOW + timedelta(days=8)}):
        with pytest.raises(WeatherError, match="Open-Meteo cannot be reached") as caught:
            get(settings, "auto", **options)
        assert caught.value.reason == "no-network"


def test_a_departure_that_nobody_forecasts_is_not_practised(settings: Settings) -> None:
    with pytest.raises(NoPassageError, match="Open-Meteo forecasts from 21 Nov 2026"):
        get(settings, "auto", departure=NOW - timedelta(days=3))


def test_storm_glass_with_a_key_that_fails_is_an_error_and_no_practice(settings: Settings) -> None:
    with FaultServer("402") as server, pytest.raises(WeatherError) as caught:
        get(replace(settings, stormglass_key="secret", stormglass_url=server.url), "auto")
    assert caught.value.reason == "quota"


def test_open_meteo_its_ensemble_and_met_norway_are_had_by_name(settings: Settings) -> None:
    with open_meteo(today=NOW.replace(hour=0, minute=0)) as server:
        there = replace(settings, openmeteo_url=server.url)
        assert get(there, "open-meteo").forecast.source == "Open-Meteo"
        assert len(get(there, "Open-Meteo-Ensemble").members) > 1
    with met_norway(now=NOW) as server:
        assert get(replace(settings, metno_url=server.url), "metno").forecast.source == "MET Norway"


def test_services_and_files_are_averaged(settings: Settings, tmp_path: Path) -> None:
    path = write_wind(tmp_path / "a.nc")
    with open_meteo(today=NOW.replace(hour=0, minute=0)) as one, met_norway(now=NOW) as two:
        there = replace(settings, openmeteo_url=one.url, metno_url=two.url)
        parts = [get(there, name) for name in ("open-meteo", "metno", path)]
        wind = get(there, "open-meteo", "metno", path)
    assert wind.forecast.source == "Mean of Open-Meteo, MET Norway and a.nc"
    moment = (NOW + timedelta(hours=1)).timestamp()
    expected = np.mean([part.at(moment, 56.0, 18.0) for part in parts], axis=0)
    np.testing.assert_allclose(wind.at(moment, 56.0, 18.0), expected, atol=0.05)
    assert wind.spread is not None
    assert wind.gust is not None
    assert "Open-Meteo.com (CC BY 4.0)" in wind.forecast.notice
    assert "MET Norway (CC BY 4.0)" in wind.forecast.notice


def test_auto_is_storm_glass_with_a_key(settings: Settings) -> None:
    told: list[str] = []
    job = Job(report=lambda stage, fraction, message: told.append(message))
    with FaultServer() as server:
        keyed = replace(settings, stormglass_key="secret", stormglass_url=server.url)
        wind = get(keyed, "auto", job=job)
    assert wind.forecast.source == "Storm Glass (sg)"
    assert told[0] == "Wind from Storm Glass, because a key is set"
    assert wind.covers([GDYNIA[0], STOCKHOLM[0]], [GDYNIA[1], STOCKHOLM[1]]).all()


def test_storm_glass_without_a_key_says_what_to_set(settings: Settings) -> None:
    with pytest.raises(WeatherError, match="set STORMGLASS_API_KEY") as caught:
        get(settings, "stormglass")
    assert caught.value.reason == "no-key"


@pytest.mark.parametrize(
    ("names", "words"),
    [
        ((), "No forecast was named"),
        (("tomorrow.grb",), r"no forecast or file 'tomorrow\.grb'; choose auto"),
        (("practice", "sample"), "cannot be averaged"),
    ],
)
def test_a_name_that_is_none_is_refused_with_the_choice(
    settings: Settings, names: tuple[str, ...], words: str
) -> None:
    with pytest.raises(InputError, match=words):
        get(settings, *names)


def test_a_file_is_read_and_several_are_averaged(settings: Settings, tmp_path: Path) -> None:
    first, second = write_wind(tmp_path / "a.nc"), write_wind(tmp_path / "b.nc", plus=2.0)
    assert get(settings, first).u.max() == 5.0
    mean = get(settings, first, second)
    assert mean.u.max() == mean.u.min() == 6.0
    assert mean.forecast.source == "Mean of a.nc and b.nc"
    weighted = get(settings, first, second, weights=[3.0, 1.0])
    np.testing.assert_allclose(weighted.u, 5.5, rtol=1e-6)
    assert weighted.forecast.source == "Mean of a.nc (3) and b.nc (1)"
    with pytest.raises(InputError, match="3 weights for 2 forecasts"):
        get(settings, first, second, weights=[3.0, 1.0, 1.0])


def test_files_of_different_grids_are_averaged_where_both_cover(settings: Settings, tmp_path: Path) -> None:
    first, second = write_wind(tmp_path / "a.nc"), write_wind(tmp_path / "b.nc", lat0=53.5, plus=2.0)
    mean = get(settings, first, second)
    assert (mean.lat[0], mean.lat[-1]) == (53.5, 60.0)
    np.testing.assert_allclose(mean.u, 6.0, rtol=1e-6)
    assert mean.spread is not None
    np.testing.assert_allclose(mean.spread, np.sqrt(2.0), rtol=1e-5)


def test_a_current_is_put_to_the_wind(settings: Settings, tmp_path: Path) -> None:
    path = write_layers(
        tmp_path / "c.nc",
        {name: (np.full((3, 8, 6), 0.25), {"units": "m s-1"}) for name in ("uo", "vo")},
        lat=53.0 + np.arange(8.0),
        lon=15.0 + np.arange(6.0),
    )
    with pytest.raises(InputError, match=r"c\.nc\) covers 2026-01-01.*choose a current of the same days"):
        get(settings, "sample", current=path)
    wind = get(settings, write_wind(tmp_path / "a.nc"), current=dated(path))
    assert wind.current is not None
    assert float(wind.current.at(wind.time[1], 56.0, 17.0)[0]) == 0.25
    assert "ends at 2026-11-21 06:00 UTC; the last is held" in wind.forecast.notice
    told: list[str] = []
    job = Job(report=lambda stage, fraction, message: told.append(message))
    with pytest.raises(InputError, match=r"nowhere\.nc cannot be read"):
        get(settings, "open-meteo", current=tmp_path / "nowhere.nc", job=job)
    # no request is spent when a file at hand cannot be read
    assert told == []


def dated(path: Path) -> Path:
    """Let a file of `write_layers` be of the day of `write_wind`."""
    with netCDF4.Dataset(path, "a") as file:
        file["time"].units = "hours since 2026-11-21"
    return path


@pytest.mark.parametrize("name", ["practice", "sample", "file"])
def test_a_passage_outside_the_wind_is_refused_with_the_area(
    settings: Settings, tmp_path: Path, name: str
) -> None:
    path = write_wind(tmp_path / "a.nc") if name == "file" else name
    with pytest.raises(NoPassageError, match=r"covers 5[23]\.0 to 6[07]\.0 N.*35°00\.0'N") as caught:
        get(settings, path, end=(35.0, 18.0))
    assert caught.value.reason == "outside-forecast"


def test_a_cancelled_job_gets_no_wind(settings: Settings) -> None:
    job = Job()
    job.cancel.set()
    with pytest.raises(CancelledError):
        get(settings, "practice", job=job)


def test_the_calendar_offers_what_a_source_covers(settings: Settings, tmp_path: Path) -> None:
    today = datetime(2026, 11, 21, tzinfo=UTC)
    path = write_wind(tmp_path / "a.nc")
    keyed = replace(settings, stormglass_key="secret")
    assert horizon(["practice"], settings, NOW) == (today, today + timedelta(days=7))
    assert horizon(["auto"], settings, NOW) == (today, today + timedelta(days=10))
    assert horizon(["open-meteo-ensemble"], settings, NOW) == (today, today + timedelta(days=10))
    hour = NOW.replace(minute=0)
    assert horizon(["metno"], settings, NOW) == (hour, hour + timedelta(days=9))
    assert horizon(["metno", "open-meteo"], settings, NOW) == (hour, hour + timedelta(days=9))
    assert horizon(["auto"], keyed, NOW) == (today, today + timedelta(days=10))
    assert horizon(["sample"], settings, NOW)[0] == datetime(2016, 11, 20, tzinfo=UTC)
    assert horizon([path], settings, NOW) == (today, today + timedelta(hours=12))


def test_weather_info_of_a_closed_folder_says_why_nothing_is_kept(
    settings: Settings, monkeypatch: pytest.MonkeyPatch
) -> None:
    def closed(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "stat", closed)
    monkeypatch.setattr(Path, "mkdir", closed)
    info = weather_info(settings, NOW)
    assert info.database_bytes == 0
    assert "Permission denied" in info.trouble


def test_weather_info_tells_what_is_there(settings: Settings) -> None:
    before = weather_info(settings, NOW)
    assert before.quota is None
    assert [source.name for source in before.sources] == [*NAMES, "file"]
    # the command line offers them without loading this room
    assert request.SERVICES == NAMES
    automatic, stormglass, free, *_ = before.sources
    assert "Open-Meteo, because" in automatic.remark
    assert (stormglass.name, stormglass.usable) == ("stormglass", False)
    assert "CC BY 4.0" in free.terms
    assert "STORMGLASS_API_KEY" in stormglass.remark
    with FaultServer() as server:
        keyed = replace(settings, stormglass_key="secret", stormglass_url=server.url)
        get(keyed, "stormglass")
    after = weather_info(keyed, NOW + timedelta(hours=3))
    assert after.quota is not None
    assert after.quota.left == 10 - len(server.requests) == 10 - len(after.cached)
    assert {info.age_h for info in after.cached} == {3.0}
    assert after.database_bytes > 0
    assert after.trouble == ""
    assert "secret" not in repr(after)


# --- the adapter's own laws -----------------------------------------------------------------------


@given(
    st.binary(max_size=400)
    | st.text(alphabet='{}[]":,0123456789.-eE hourstimewindSpeedsg', max_size=200).map(str.encode)
)
def test_any_bytes_are_an_answer_or_a_decode_error(body: bytes) -> None:
    decode_meta(body)
    try:
        answer = decode_answer(body)
    except (msgspec.DecodeError, UnicodeDecodeError):
        return
    with pytest.raises(WeatherError):
        to_point(answer, place=(55.0, 18.0), window=(0.0, 1e6), source="sg")


JSON = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(max_size=9),
    lambda children: (
        st.lists(children, max_size=4) | st.dictionaries(st.text(max_size=6), children, max_size=4)
    ),
    max_leaves=8,
)


@given(
    st.lists(
        st.fixed_dictionaries(
            {"time": st.just("2026-11-21T00:00:00+00:00")},
            optional={"windSpeed": JSON, "windDirection": JSON},
        ),
        max_size=3,
    ),
    JSON,
)
def test_any_document_is_an_answer_or_an_error(hours: list[Any], meta: Any) -> None:
    body = msgspec.json.encode({"hours": hours, "meta": meta})
    try:
        answer = decode_answer(body)
    except msgspec.ValidationError:
        return
    # three hours are never enough, whatever they hold
    with pytest.raises(WeatherError):
        to_point(answer, place=(55.0, 18.0), window=(0.0, 1e10), source="sg")


# --- the fault server as a program ----------------------------------------------------------------


@pytest.fixture
def program() -> Iterator[str]:
    command = [
        sys.executable,
        str(REPOSITORY / "tests" / "faultserver.py"),
        "--port",
        "0",
        "--behaviour",
        "403,good",
    ]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            yield process.stdout.readline().strip()
        finally:
            process.terminate()


def test_the_fault_server_runs_by_itself(program: str) -> None:
    url = f"{program}/v2/weather/point?lat=55&lng=18&params=windSpeed&start=1795219200&end=1796083200"
    request = urllib.request.Request(url, headers={"Authorization": "k"})
    with pytest.raises(urllib.error.HTTPError) as refused:
        urllib.request.urlopen(request)
    with refused.value as error:
        assert error.code == 403
    with urllib.request.urlopen(request) as response:
        assert len(msgspec.json.decode(response.read())["hours"]) == 240
