"""The grid of wind: what it refuses, and the laws of its interpolation."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.errors import NoPassageError, WeatherError
from seacruise.weather.wind import (
    Forecast,
    Wind,
    describe_area,
    describe_grid,
    from_direction,
    require_cover,
    to_direction,
)

TIME = np.array([0.0, 3600.0, 10800.0])
LAT = np.array([54.0, 55.0, 56.0, 57.0])
LON = np.array([16.0, 17.5, 19.0])
FORECAST = Forecast(
    source="Test",
    issued=None,
    valid_from=datetime(1970, 1, 1, tzinfo=UTC),
    valid_to=datetime(1970, 1, 1, 3, tzinfo=UTC),
    step_h=1.0,
    resolution_deg=1.0,
)


def make(**changes: Any) -> Wind:
    rng = np.random.default_rng(7)
    shape = (TIME.size, LAT.size, LON.size)
    fields = {
        "time": TIME,
        "lat": LAT,
        "lon": LON,
        "u": rng.uniform(-20, 20, shape).astype(np.float32),
        "v": rng.uniform(-20, 20, shape).astype(np.float32),
        "forecast": FORECAST,
    }
    return Wind(**{**fields, **changes})


WIND = make()


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"time": TIME[::-1]}, "times do not increase"),
        ({"time": np.array([0.0, np.nan, 2.0])}, "times are empty or not numbers"),
        ({"time": np.array([])}, "times are empty"),
        ({"lat": LAT[::-1]}, "latitudes do not increase"),
        ({"lat": np.array([54.0, 55.0, 56.1, 57.0])}, "latitudes are not evenly spaced"),
        ({"lat": LAT + 40.0}, "beyond the poles"),
        ({"lon": np.array([16.0, 17.5])}, "axes say"),
        ({"lon": np.array([[16.0, 17.5, 19.0]])}, "longitudes are empty"),
        ({"u": np.full((3, 4, 3), np.nan)}, "missing or above"),
        ({"v": np.full((3, 4, 3), np.inf)}, "missing or above"),
        ({"v": np.full((3, 4, 3), 130.0)}, "missing or above"),
        ({"v": np.zeros((3, 4, 2))}, "axes say"),
    ],
)
def test_a_bad_wind_cannot_be_made(changes: dict[str, Any], words: str) -> None:
    with pytest.raises(WeatherError, match=words) as caught:
        make(**changes)
    assert caught.value.reason == "bad-response"
    assert "Test" in str(caught.value)


def test_types_are_brought_to_those_promised() -> None:
    wind = make(time=[0, 3600, 10800], u=np.zeros((3, 4, 3), dtype=np.float64)[::-1])
    assert [part.dtype.str[1:] for part in (wind.time, wind.u)] == ["f8", "f4"]
    assert wind.u.flags.c_contiguous


@given(st.integers(0, 2), st.integers(0, 3), st.integers(0, 2))
def test_interpolation_is_exact_at_the_knots(t: int, y: int, x: int) -> None:
    u, v = WIND.at(TIME[t], LAT[y], LON[x])
    assert (float(u), float(v)) == (float(WIND.u[t, y, x]), float(WIND.v[t, y, x]))


@given(st.floats(-1e5, 1e5), st.floats(50, 60), st.floats(10, 25))
def test_interpolation_is_bounded_by_the_corners_of_its_cell(time: float, lat: float, lon: float) -> None:
    cell = np.ix_(*(neighbours(value, axis) for value, axis in ((time, TIME), (lat, LAT), (lon, LON))))
    for value, grid in zip(WIND.at(time, lat, lon), (WIND.u, WIND.v), strict=True):
        assert grid[cell].min() - 1e-5 <= value <= grid[cell].max() + 1e-5


def neighbours(value: float, axis: np.ndarray[Any, Any]) -> list[int]:
    above = int(np.clip(np.searchsorted(axis, value), 1, axis.size - 1))
    return [above - 1, above]


def test_half_way_is_the_mean_of_the_eight_corners() -> None:
    u, _ = WIND.at(1800.0, 54.5, 16.75)
    assert float(u) == pytest.approx(float(WIND.u[:2, :2, :2].mean()), abs=1e-5)


def test_the_wind_is_held_before_and_after_and_beyond_the_edge() -> None:
    assert WIND.at(-9e9, 54.0, 16.0)[0] == WIND.u[0, 0, 0]
    assert WIND.at(9e9, 99.0, 99.0)[1] == WIND.v[-1, -1, -1]


def test_arguments_are_broadcast() -> None:
    u, v = WIND.at(0.0, LAT[:, None], LON[None, :])
    assert u.dtype == np.float64
    np.testing.assert_array_equal(u, WIND.u[0])
    np.testing.assert_array_equal(v, WIND.v[0])
    assert WIND.at(TIME, 54.0, 16.0)[0].shape == (3,)


def test_a_single_place_is_a_uniform_wind() -> None:
    wind = make(lat=[56.0], lon=[18.0], u=np.full((3, 1, 1), 4.0), v=np.zeros((3, 1, 1)))
    assert [float(part) for part in wind.at(0.0, 10.0, -70.0)] == [4.0, 0.0]
    assert bool(wind.covers(10.0, -70.0))
    single = make(time=[0.0], u=WIND.u[:1], v=WIND.v[:1])
    assert single.at(99.0, 54.0, 16.0)[0] == WIND.u[0, 0, 0]


def test_covers_includes_the_edge_only() -> None:
    np.testing.assert_array_equal(
        WIND.covers([54.0, 57.0, 57.001, 55.0], [16.0, 19.0, 17.0, 15.9]), [True, True, False, False]
    )


@given(st.floats(0.01, 100), st.floats(0, 360, exclude_max=True))
def test_speed_and_direction_survive_the_round_trip(speed: float, direction: float) -> None:
    back_speed, back_direction = to_direction(*from_direction(speed, direction))
    assert float(back_speed) == pytest.approx(speed, rel=1e-12)
    assert abs((float(back_direction) - direction + 180) % 360 - 180) < 1e-9
    assert 0 <= float(back_direction) < 360


@pytest.mark.parametrize(("direction", "u", "v"), [(0, 0, -1), (90, -1, 0), (180, 0, 1), (270, 1, 0)])
def test_directions_say_where_the_wind_comes_from(direction: float, u: float, v: float) -> None:
    np.testing.assert_allclose(from_direction(1.0, direction), (u, v), atol=1e-15)


def test_a_place_outside_is_named_with_the_area() -> None:
    with pytest.raises(NoPassageError, match=r"54\.0 to 57\.0 N, 16\.0 to 19\.0 E.*60°00\.0'N") as caught:
        require_cover("Test", (LAT, LON), [(55.0, 18.0), (60.0, 18.0)])
    assert (caught.value.reason, caught.value.place) == ("outside-forecast", (60.0, 18.0))
    assert describe_area(np.array([-3.0, 4.0]), np.array([-20.0, -10.0])) == "3.0 S to 4.0 N, 10.0 to 20.0 W"


def test_a_grid_is_described_by_its_usual_step() -> None:
    first, last, step_h, resolution = describe_grid(np.array([0.0, 3600.0, 7200.0, 18000.0]), LAT, LON)
    assert (last - first).total_seconds() == 18000
    assert (step_h, resolution) == (1.0, 1.0)
    assert describe_grid(np.array([0.0]), LAT[:1], LON)[2:] == (0.0, 1.5)
