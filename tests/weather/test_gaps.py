"""Holes in a wind are filled from beside them, or the wind is refused."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.errors import WeatherError
from seacruise.weather.gaps import MAX_MISSING, NEVER, fill_gaps, grow


def field(seed: int = 1) -> np.ndarray[tuple[int, int, int], np.dtype[np.float32]]:
    return np.random.default_rng(seed).uniform(-9, 9, (3, 5, 6)).astype(np.float32)


def test_a_whole_wind_is_left_as_it_is() -> None:
    u, v = field(1), field(2)
    filled, depth = fill_gaps(u, v)
    assert filled[0] is u
    assert filled[1] is v
    assert not depth.any()


def test_a_single_hole_gets_the_mean_around_it() -> None:
    u, v = field(1), field(2)
    expected = (u[1, 1:4, 2:5].sum() - u[1, 2, 3]) / 8
    u[1, 2, 3] = np.nan
    (filled_u, filled_v), depth = fill_gaps(u, v)
    assert filled_u[1, 2, 3] == pytest.approx(expected, abs=1e-5)
    # a component alone is no wind: the other one was filled as well
    assert filled_v[1, 2, 3] != v[1, 2, 3]
    assert np.isnan(u[1, 2, 3])
    assert depth[1, 2, 3] == depth.sum() == 1


@given(st.lists(st.integers(0, 29), max_size=15), st.integers(0, 99))
def test_filling_keeps_what_is_known_and_stays_within_its_range(holes: list[int], seed: int) -> None:
    u, v = field(seed), field(seed + 1)
    for array in (u, v):
        array.reshape(3, 30)[:, holes] = np.nan
    known = ~np.isnan(u)
    for before, after in zip((u, v), fill_gaps(u, v)[0], strict=True):
        assert np.isfinite(after).all()
        np.testing.assert_array_equal(before[known], after[known])
        assert after.min() >= before[known].min() - 1e-5
        assert after.max() <= before[known].max() + 1e-5


def test_too_many_holes_are_refused() -> None:
    u = field()
    u.reshape(3, 30)[:, : int(30 * MAX_MISSING) + 1] = np.nan
    with pytest.raises(WeatherError, match=r"missing \(masked\) over 63%") as caught:
        fill_gaps(u, field())
    assert caught.value.reason == "bad-response"


def test_a_time_without_any_wind_is_refused() -> None:
    u = field()
    u[1] = np.nan
    with pytest.raises(WeatherError, match="missing"):
        fill_gaps(u, field())


def test_filling_stops_after_the_rounds_it_is_given() -> None:
    row = np.full((2, 1, 1, 7), np.nan, dtype=np.float32)
    row[:, 0, 0, 0] = 4.0, 6.0
    (filled,), depth = grow(row, rounds=3)
    np.testing.assert_array_equal(filled[:, 0, 0, :4], [[4.0] * 4, [6.0] * 4])
    assert np.isnan(filled[..., 4:]).all()
    np.testing.assert_array_equal(depth[0, 0, 0], [0, 1, 2, 3, NEVER, NEVER, NEVER])


def test_nothing_grows_from_nothing() -> None:
    empty = np.full((1, 3, 3), np.nan, dtype=np.float32)
    (filled,), depth = grow(empty)
    assert np.isnan(filled).all()
    assert (depth == NEVER).all()
