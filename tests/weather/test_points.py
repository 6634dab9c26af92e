"""Which places are asked, and the grid that is made of their answers."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.weather.grids import passage_box
from seacruise.weather.points import MODEL_STEP_DEG, PointPlan, plan_points, spread

BALTIC = (54.0, 17.0, 59.5, 22.0)


@given(st.floats(-60, 66), st.floats(-170, 160), st.floats(0.01, 12), st.floats(0.01, 18), st.integers(1, 60))
def test_a_plan_is_regular_encloses_its_area_and_keeps_its_budget(
    south: float, west: float, high: float, wide: float, most: int
) -> None:
    plan = plan_points((south, west, south + high, west + wide), most=most)
    assert 1 <= plan.rows.size <= most
    assert plan.lat[0] <= south + 1e-6
    assert plan.lat[-1] >= south + high - 1e-6
    assert plan.lon[0] <= west + 1e-6
    assert plan.lon[-1] >= west + wide - 1e-6
    for axis in (plan.lat, plan.lon):
        assert axis.size >= 2
        np.testing.assert_allclose(np.diff(axis), axis[1] - axis[0], rtol=1e-9)
        np.testing.assert_allclose(axis / MODEL_STEP_DEG, np.round(axis / MODEL_STEP_DEG), atol=1e-9)
    assert len(set(plan.places)) == plan.rows.size


def test_nine_requests_are_three_by_three() -> None:
    plan = plan_points(BALTIC, most=9)
    assert (plan.lat.size, plan.lon.size) == (3, 3)
    assert np.diff(plan.lat)[0] == pytest.approx(2.75)


def test_land_is_not_asked_and_the_grid_gets_finer_for_it() -> None:
    def is_water(lat: Any, lon: Any) -> Any:
        return np.asarray(lon) > 19.8

    plan = plan_points(BALTIC, most=9, is_water=is_water)
    assert all(lon > 19.8 for _, lon in plan.places)
    assert plan.lat.size * plan.lon.size > 9
    nowhere = plan_points(BALTIC, most=9, is_water=lambda lat, lon: np.zeros(np.shape(lat), dtype=bool))
    assert nowhere.rows.size == 9


def test_a_plan_of_few_requests_keeps_those_farthest_apart() -> None:
    plan = plan_points(BALTIC, most=2)
    assert {plan.places[0], plan.places[1]} == {
        (plan.lat[0], plan.lon[0]),
        (plan.lat[-1], plan.lon[-1]),
    }


def some_plan() -> PointPlan:
    return plan_points(BALTIC, most=9)


@given(st.lists(st.booleans(), min_size=9, max_size=9).filter(any), st.integers(0, 10**6))
def test_spreading_keeps_answers_and_stays_within_their_range(flags: list[bool], seed: int) -> None:
    plan, answered = some_plan(), np.array(flags)
    values = np.random.default_rng(seed).uniform(-20, 20, (4, int(answered.sum())))
    grid = spread(plan, answered, values)
    assert grid.shape == (4, plan.lat.size, plan.lon.size)
    np.testing.assert_array_equal(grid[:, plan.rows[answered], plan.columns[answered]], values)
    assert grid.min() >= values.min() - 1e-9
    assert grid.max() <= values.max() + 1e-9


def test_half_way_between_two_answers_is_their_mean() -> None:
    plan = PointPlan(
        lat=np.array([55.0, 56.0, 57.0]),
        lon=np.array([18.0, 19.0]),
        rows=np.array([0, 2]),
        columns=np.array([0, 0]),
    )
    grid = spread(plan, np.array([True, True]), np.array([[2.0, 6.0]]))
    assert grid[0, 1, 0] == pytest.approx(4.0)
    assert grid[0, 0, 1] < 4.0


def test_a_passage_has_room_on_every_side() -> None:
    south, west, north, east = passage_box(((54.5, 18.6), (59.3, 18.1)), 1.0)
    assert (south, north) == (53.5, 60.3)
    assert 18.1 - west == pytest.approx(east - 18.6) == pytest.approx(1.83, abs=0.02)
