"""Which places are asked and where next, and the wind that is made of the answers."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.weather.adaptive import kriging_weights, next_places
from seacruise.weather.ground import Ground, survey
from seacruise.weather.mosaic import common_hours, to_wind
from seacruise.weather.point import PointAnswer
from seacruise.weather.points import MODEL_STEP_DEG
from seacruise.weather.wind import Forecast, from_direction, to_direction

GDYNIA, STOCKHOLM = (54.52, 18.56), (59.32, 18.08)
BOX = (53.77, 17.0, 60.07, 20.0)


def ground(first: int = 6, **options: Any) -> Ground:
    return survey(BOX, **{"ends": (GDYNIA, STOCKHOLM), "is_water": None, "first": first, **options})


@given(st.floats(-60, 66), st.floats(-170, 160), st.floats(0.1, 12), st.floats(0.1, 18), st.integers(2, 40))
def test_the_ground_encloses_its_area_and_lists_different_places(
    south: float, west: float, high: float, wide: float, first: int
) -> None:
    ends = (south + 0.02, west + 0.02), (south + high - 0.02, west + wide - 0.02)
    here = survey((south, west, south + high, west + wide), ends=ends, is_water=None, first=first)
    assert here.lat[0] <= south + 1e-6
    assert here.lat[-1] >= south + high - 1e-6
    assert here.lon[0] <= west + 1e-6
    assert here.lon[-1] >= west + wide - 1e-6
    np.testing.assert_allclose(here.places / MODEL_STEP_DEG, np.round(here.places / MODEL_STEP_DEG))
    assert 1 <= len(here.first) <= first
    assert len(set(here.first)) == len(here.first)
    assert here.weight.max() <= 1.0


def test_start_and_end_come_first_then_the_way_between() -> None:
    here = ground()
    asked = here.places[list(here.first)]
    assert here.ends == here.first[:2]
    np.testing.assert_allclose(asked[:2], [GDYNIA, STOCKHOLM], atol=MODEL_STEP_DEG)
    # evenly along the way, the middle before the outer ones
    assert np.sort(asked[:, 0]) == pytest.approx(np.linspace(54.5, 59.25, 6), abs=0.15)
    assert set(np.round(asked[2:4, 0])) == {56.0, 57.0} or abs(asked[2:4, 0].mean() - 56.9) < 0.3


def test_the_way_leads_around_land() -> None:
    # a spit from the west as far as 19 E
    def is_water(lat: Any, lon: Any) -> Any:
        return (np.abs(np.asarray(lat) - 57.0) > 0.6) | (np.asarray(lon) > 19.0)

    here = ground(is_water=is_water)
    assert (here.way[:, 1].max(), len(here.first)) == (19.25, 6)
    assert is_water(here.places[:, 0], here.places[:, 1]).all()


def test_an_area_without_ends_is_asked_far_apart() -> None:
    here = ground(ends=None, first=5)
    assert here.ends == ()
    asked = here.places[list(here.first)]
    np.testing.assert_allclose(asked[0], (56.9, 18.5), atol=MODEL_STEP_DEG)
    gaps = here.distances(asked, asked) + 9.0 * np.eye(5)
    # no two of five places are nearer than half of the area's width
    assert gaps.min() > 0.5 * (here.lon[-1] - here.lon[0]) * here.shrink


def test_between_skerries_all_nodes_are_asked() -> None:
    here = ground(is_water=lambda lat, lon: np.zeros(np.shape(lat), dtype=bool))
    assert len(here.places) == here.lat.size * here.lon.size


# --- where to ask next ----------------------------------------------------------------------------


def front(places: Any, at_lat: float) -> tuple[Any, Any]:
    """Make a wind for 24 hours: west of 8 m/s south of a latitude, east north of it."""
    u = np.where(np.asarray(places)[:, 0] < at_lat, 8.0, -8.0)
    return np.tile(u, (24, 1)), np.zeros((24, len(u)))


def test_a_steady_wind_needs_no_more_answers() -> None:
    here = ground()
    wind = np.full((24, 6), 8.0), np.zeros((24, 6))
    assert next_places(here, list(here.first), wind, 5, frozenset()) == ()


@pytest.mark.parametrize("at_lat", [55.6, 56.7, 57.9])
def test_the_next_places_lie_at_the_front(at_lat: float) -> None:
    here = ground()
    answered = list(here.first)
    chosen = next_places(here, answered, front(here.places[answered], at_lat), 3, frozenset())
    assert np.abs(here.places[list(chosen), 0] - at_lat).max() < 1.5
    assert np.abs(here.places[list(chosen), 0] - at_lat).min() < 0.8


def test_chosen_places_are_new_different_and_not_those_that_failed() -> None:
    here = ground()
    answered = list(here.first)
    wind = front(here.places[answered], 56.7)
    chosen = next_places(here, answered, wind, 5, frozenset())
    assert len({*chosen, *answered}) == 11
    barred = next_places(here, answered, wind, 5, frozenset(chosen))
    assert not set(chosen) & set(barred)


# --- one wind of the answers ----------------------------------------------------------------------

PLACES = st.lists(
    st.tuples(st.integers(0, 24), st.integers(0, 12)), min_size=1, max_size=12, unique=True
).map(lambda nodes: np.array([(53.75 + 0.25 * y, 17.0 + 0.25 * x) for y, x in nodes]))


@given(PLACES)
def test_weights_add_up_and_keep_the_answers(known: Any) -> None:
    elsewhere = np.array([(54.1, 17.3), (60.0, 20.0), (56.6, 18.4)])
    weights = kriging_weights(known, np.concatenate([known, elsewhere]), 0.55)
    np.testing.assert_allclose(weights.sum(axis=1), 1.0, atol=1e-9)
    np.testing.assert_allclose(weights[: len(known)], np.eye(len(known)), atol=1e-9)


def point(lat: float, lon: float, u: Any, v: Any, hours: int = 48, **options: Any) -> PointAnswer:
    speed, direction = to_direction(u, v)
    time = tuple(1.8e9 + 3600.0 * number for number in range(hours))
    return PointAnswer(
        lat=lat,
        lon=lon,
        time=time,
        speed=(float(speed),) * hours,
        direction=(float(direction),) * hours,
        model=("sg",) * hours,
        **options,
    )


def wind_of(points: list[PointAnswer]) -> Any:
    time = common_hours(points)
    begin, end = (np.datetime64(int(one), "s").item() for one in (time[0], time[-1]))
    return to_wind(ground(), points, time, Forecast("Test", None, begin, end, 1.0, 0.25))


@given(PLACES, st.integers(0, 10**6))
def test_the_wind_keeps_the_answers_and_stays_within_them(known: Any, seed: int) -> None:
    rng = np.random.default_rng(seed)
    components = rng.uniform(-20, 20, (len(known), 2))
    wind = wind_of([point(*place, *one) for place, one in zip(known.tolist(), components, strict=True)])
    rows = np.round((known[:, 0] - wind.lat[0]) / 0.25).astype(int)
    columns = np.round((known[:, 1] - wind.lon[0]) / 0.25).astype(int)
    np.testing.assert_allclose(wind.u[0, rows, columns], components[:, 0], atol=1e-4)
    np.testing.assert_allclose(wind.v[0, rows, columns], components[:, 1], atol=1e-4)
    assert wind.u.min() >= components[:, 0].min() - 1e-4
    assert wind.u.max() <= components[:, 0].max() + 1e-4


def test_a_wind_that_turns_through_north_does_not_blow_from_the_south() -> None:
    wind = wind_of(
        [point(55.0, 18.0, *from_direction(8.0, 350.0)), point(59.0, 18.0, *from_direction(8.0, 10.0))]
    )
    speed, direction = to_direction(wind.u, wind.v)
    assert speed.min() > 7.8
    assert ((direction > 349.9) | (direction < 10.1)).all()


def test_answers_last_as_long_as_the_shortest() -> None:
    assert common_hours([point(55.0, 18.0, 1, 1), point(56.0, 18.0, 1, 1, hours=30)]).size == 30


def test_gusts_of_too_few_answers_are_left_out() -> None:
    told: dict[str, Any] = {"gust": (12.0,) * 48, "wave": (1.0,) * 20 + (float("nan"),) * 28}
    bare = [point(55.0 + number, 18.0, 5.0, 5.0) for number in range(2)]
    full = [point(57.0 + number, 18.0, 5.0, 5.0, **told) for number in range(2)]
    half = wind_of([*bare, *full])
    assert half.gust is not None
    np.testing.assert_allclose(half.gust, 12.0, rtol=1e-5)
    # nobody told the waves to the end
    assert half.wave is None
    assert wind_of([*bare, full[0]]).gust is None
