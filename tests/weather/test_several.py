"""The mean of several sources: one that fails is left out, and it is said."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path

import numpy as np
import pytest

from seacruise.errors import CancelledError, InputError, NoPassageError, SeaCruiseError, WeatherError
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.weather.several import mean_of
from seacruise.weather.source import fetch_wind
from seacruise.weather.wind import Wind
from tests.weather.weatherserver import met_norway, open_meteo
from tests.weather.worlds import uniform

NOW = datetime(2026, 11, 21, 9, 30, tzinfo=UTC)
GDYNIA, VISBY = (54.52, 18.56), (57.64, 18.28)
DOWN = WeatherError("MET Norway did not answer within 20 s; try again later.", reason="timeout")
LATE = NoPassageError("MET Norway forecasts until 30 Nov; leave earlier.", reason="outside-forecast")


def mean(
    answers: Mapping[str, Wind | Exception], weights: list[float] | None = None
) -> tuple[Wind, list[str]]:
    said: list[str] = []

    def get(name: str) -> Wind:
        answer = answers[name]
        if isinstance(answer, Exception):
            raise answer
        return answer

    return mean_of(list(answers), get, weights=weights, say=said.append), said


def test_without_failures_it_is_the_mean_of_all() -> None:
    wind, said = mean({"a.grb": uniform(2.0), "open-meteo": uniform(6.0)}, [3.0, 1.0])
    np.testing.assert_allclose(wind.u, 3.0)
    assert said == []


@pytest.mark.parametrize("error", [DOWN, LATE])
def test_a_service_that_fails_is_left_out_with_its_weight(error: SeaCruiseError) -> None:
    two: dict[str, Wind | Exception] = {
        "metno": error,
        "a.grb": uniform(2.0),
        "b.grb": uniform(6.0, name="b.grb"),
    }
    wind, said = mean(two, [8.0, 3.0, 1.0])
    np.testing.assert_allclose(wind.u, 3.0)
    assert wind.forecast.source == "Mean of a.grb (3) and b.grb (1)"
    assert said == [f"The mean is without MET Norway: {str(error).partition(';')[0]}."]
    assert wind.forecast.notice.startswith(said[0])


def test_what_is_left_of_two_is_no_mean() -> None:
    alone = uniform(2.0)
    alone = replace(alone, forecast=replace(alone.forecast, notice="Its terms."))
    wind, said = mean({"stormglass:ecmwf+noaa": DOWN, "a.grb": alone})
    assert wind.forecast.source == alone.forecast.source
    assert wind.forecast.notice == f"{said[0]} Its terms."
    assert said[0].startswith("The mean is without Storm Glass: ")
    np.testing.assert_array_equal(wind.u, alone.u)


def test_when_all_fail_the_service_that_failed_is_the_answer() -> None:
    other = WeatherError("Open-Meteo is asked too often; try again in a minute.", reason="quota")
    with pytest.raises(WeatherError) as caught:
        mean({"metno": LATE, "open-meteo": other})
    assert caught.value is other
    with pytest.raises(NoPassageError):
        mean({"metno": LATE, "open-meteo": LATE})


@pytest.mark.parametrize("error", [DOWN, LATE])
def test_a_single_source_fails_as_it_fails(error: SeaCruiseError) -> None:
    with pytest.raises(type(error)) as caught:
        mean({"metno": error})
    assert caught.value is error


@pytest.mark.parametrize("error", [InputError("The file is damaged."), CancelledError()])
def test_a_broken_file_and_a_cancel_end_it(error: SeaCruiseError) -> None:
    with pytest.raises(type(error)):
        mean({"a.grb": error, "open-meteo": uniform()})


def fetch(settings: Settings, *names: str, departure: datetime | None = None) -> Wind:
    return fetch_wind(
        list(names), start=GDYNIA, end=VISBY, departure=departure, settings=settings, job=Job(), now=NOW
    )


def test_over_the_wire_the_other_service_stands_in(settings: Settings) -> None:
    today = NOW.replace(hour=0, minute=0)
    with open_meteo(today=today) as well, met_norway("403", now=NOW) as ill:
        both = replace(settings, openmeteo_url=well.url, metno_url=ill.url)
        mean_wind = fetch(both, "metno", "open-meteo")
        alone = fetch(both, "open-meteo")
    assert mean_wind.forecast.source == "Open-Meteo"
    assert "The mean is without MET Norway: MET Norway refuses this program" in mean_wind.forecast.notice
    np.testing.assert_array_equal(mean_wind.u, alone.u)


def test_a_departure_that_only_one_forecasts_is_planned_with_that_one(settings: Settings) -> None:
    today = NOW.replace(hour=0, minute=0)
    with open_meteo(today=today) as well, met_norway(now=NOW) as short:
        both = replace(settings, openmeteo_url=well.url, metno_url=short.url)
        wind = fetch(both, "metno", "open-meteo", departure=NOW + timedelta(days=9, hours=3))
    assert wind.forecast.source == "Open-Meteo"
    assert short.requests == []
    assert "The mean is without MET Norway: " in wind.forecast.notice


def test_a_file_that_is_no_forecast_is_named_at_once(settings: Settings, tmp_path: Path) -> None:
    broken = tmp_path / "broken.grb"
    broken.write_bytes(b"GRIB" + bytes(200))
    with open_meteo(today=NOW.replace(hour=0, minute=0)) as server, pytest.raises(InputError, match="broken"):
        fetch(replace(settings, openmeteo_url=server.url), str(broken), "open-meteo")
    assert server.requests == []
