"""Practice weather and the sample."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta
from typing import Any

import netCDF4
import numpy as np
import pytest

from seacruise.resources import resource_path
from seacruise.weather.practice import practice_wind
from seacruise.weather.sample import VALID_FROM, VALID_TO, sample_wind
from seacruise.weather.wind import to_direction
from tests.conftest import SHARED_DATA

NOON = datetime(2026, 11, 21, 12, tzinfo=UTC)


def test_practice_weather_says_that_it_is_no_forecast() -> None:
    forecast = practice_wind(NOON).forecast
    assert "not a forecast" in forecast.source
    assert forecast.notice == "Practice weather: generated, not a forecast."
    assert (forecast.valid_from, forecast.valid_to) == (
        datetime(2026, 11, 21, tzinfo=UTC),
        datetime(2026, 11, 28, tzinfo=UTC),
    )


def test_practice_weather_is_the_same_all_day_and_another_the_next() -> None:
    first, later = practice_wind(NOON), practice_wind(NOON + timedelta(hours=11))
    np.testing.assert_array_equal(first.u, later.u)
    assert np.abs(first.u - practice_wind(NOON + timedelta(hours=13)).u).max() > 1.0
    np.testing.assert_array_equal(practice_wind(NOON, seed=5).v, practice_wind(NOON, seed=5).v)


@pytest.mark.parametrize("seed", range(8))
def test_practice_weather_is_believable(seed: int) -> None:
    wind = practice_wind(NOON, seed=seed)
    speed = np.hypot(wind.u, wind.v)
    assert 14.0 < speed.max() < 25.0
    assert 4.0 < speed.mean() < 9.0
    # an hour never brings more than a squally front would
    assert np.abs(np.diff(wind.u, axis=0)).max() < 6.0
    assert wind.covers([53.9, 65.8], [9.5, 25.0]).all()


def test_two_lows_turn_the_wind_against_the_clock() -> None:
    wind = practice_wind(NOON, seed=1)
    spacing = np.radians(0.5) * 6_371_009
    dv_dx = np.gradient(wind.v, axis=2) / (spacing * np.cos(np.radians(wind.lat))[None, :, None])
    spin = (dv_dx - np.gradient(wind.u, axis=1) / spacing).max(axis=(1, 2))
    strong = spin > 0.6 * spin.max()
    # cyclonic vorticity stands out twice in the week, with quiet days between
    assert np.count_nonzero(np.diff(strong.astype(int)) == 1) + int(strong[0]) == 2


def test_surface_wind_crosses_the_isobars_towards_the_low() -> None:
    wind = practice_wind(NOON, seed=1)
    divergence = np.gradient(wind.u, axis=2) * 2 + np.gradient(wind.v, axis=1)
    spin = np.gradient(wind.v, axis=2) * 2 - np.gradient(wind.u, axis=1)
    hour, row, column = np.unravel_index(spin.argmax(), spin.shape)
    assert divergence[hour, row, column] < 0


def test_the_sample_is_the_real_weather_of_november_2016() -> None:
    wind = sample_wind()
    assert wind.u.shape == (9, 16, 26)
    assert "20-22 Nov 2016" in wind.forecast.source
    assert (wind.forecast.valid_from, wind.forecast.valid_to) == (VALID_FROM, VALID_TO)
    assert (wind.forecast.step_h, wind.forecast.resolution_deg) == (6.0, 1.0)
    assert wind.lat[0] == 52.0
    speed, _ = to_direction(wind.u, wind.v)
    assert float(speed.max()) == pytest.approx(22.8, abs=0.1)


def test_the_arrays_of_the_sample_are_those_of_its_file() -> None:
    wind = sample_wind()
    with netCDF4.Dataset(resource_path("assets/wind/sample.nc")) as file:
        ours: dict[str, Any] = {
            "time": wind.time,
            "lat": wind.lat,
            "lon": wind.lon,
            "u10": wind.u,
            "v10": wind.v,
        }
        for name, values in ours.items():
            np.testing.assert_array_equal(values, np.asarray(file[name][:], dtype=values.dtype))
    assert wind.u.dtype == np.float32


def test_the_sample_is_what_the_source_said() -> None:
    source = SHARED_DATA / "weather" / "baltic" / "gfs_1deg_baltic_20161120_48h_6hourly.nc"
    if not source.exists():
        pytest.skip("REAL DATA ABSENT: no shared/ beside the checkout (../shared/data)")
    wind = sample_wind()
    with netCDF4.Dataset(source) as file:
        rows = np.argsort(file["lat"][:])
        np.testing.assert_allclose(wind.u, file["u10"][:][:, rows], atol=0.0051)
        np.testing.assert_allclose(wind.v, file["v10"][:][:, rows], atol=0.0051)
