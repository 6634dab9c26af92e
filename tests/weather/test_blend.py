"""Several forecasts as one: the laws of the mean, the common grid, and what is refused."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.errors import InputError
from seacruise.weather import blend as blending
from seacruise.weather.blend import blend
from seacruise.weather.wind import Current, from_direction
from tests.weather.worlds import uniform


def test_one_forecast_is_itself() -> None:
    wind = uniform()
    assert blend([wind]) is wind
    assert blend([wind], [3.0]) is wind


def test_vectors_are_averaged_not_directions() -> None:
    north_west, north_east = (uniform(*(float(x) for x in from_direction(10.0, deg))) for deg in (350, 10))
    mean = blend([north_west, north_east])
    np.testing.assert_allclose(mean.u, 0.0, atol=1e-6)
    np.testing.assert_allclose(mean.v, -10 * np.cos(np.radians(10)), rtol=1e-6)
    assert mean.spread is not None
    np.testing.assert_allclose(mean.spread, 10 * np.sin(np.radians(10)), rtol=1e-4)


def test_weights_count() -> None:
    mean = blend([uniform(3.0, gust=6.0), uniform(9.0, name="File b.nc", gust=12.0)], [2.0, 1.0])
    np.testing.assert_allclose(mean.u, 5.0, rtol=1e-6)
    assert mean.gust is not None
    assert mean.spread is not None
    np.testing.assert_allclose(mean.gust, 8.0, rtol=1e-6)
    np.testing.assert_allclose(mean.spread, np.sqrt(2 / 3 * 4 + 1 / 3 * 16), rtol=1e-5)
    assert mean.forecast.source == "Mean of a.grb (2) and b.nc (1)"


@given(
    st.lists(
        st.tuples(st.floats(-20, 20), st.floats(-20, 20), st.floats(0.1, 9), st.floats(0, 5)),
        min_size=2,
        max_size=5,
    )
)
def test_the_spread_is_that_of_all_the_vectors(cases: list[tuple[float, float, float, float]]) -> None:
    mean = blend([uniform(u, v, spread=s) for u, v, _, s in cases], [w for _, _, w, _ in cases])
    u, v, weight, own = (np.array(column) for column in zip(*cases, strict=True))
    mean_u, mean_v = np.average(u, weights=weight), np.average(v, weights=weight)
    variance = np.average((u - mean_u) ** 2 + (v - mean_v) ** 2 + own**2, weights=weight)
    assert float(mean.u[0, 0, 0]) == pytest.approx(mean_u, abs=1e-4)
    assert mean.spread is not None
    assert float(mean.spread[1, 2, 3]) == pytest.approx(np.sqrt(variance), rel=1e-4, abs=1e-4)


@given(st.permutations([0, 1, 2]))
def test_the_order_does_not_matter(order: list[int]) -> None:
    winds = [
        uniform(1.0, 2.0),
        uniform(4.0, lat=np.arange(53.25, 56.3, 0.25), hours=(3.0, 7.0, 20.0), wave=2.0),
        uniform(7.0, lon=np.arange(15.0, 19.6, 0.5)),
    ]
    weights = [1.0, 2.0, 5.0]
    first = blend(winds, weights)
    again = blend([winds[k] for k in order], [weights[k] for k in order])
    for name in ("time", "lat", "lon", "u", "v", "wave", "spread"):
        np.testing.assert_allclose(getattr(again, name), getattr(first, name), atol=1e-5)


def test_the_grid_is_the_finest_over_what_all_cover_at_all_their_times() -> None:
    coarse = uniform(2.0, hours=(0.0, 6.0, 12.0))
    fine = uniform(
        4.0, hours=(3.0, 5.0, 6.0, 24.0), lat=np.arange(55.0, 60.1, 0.25), lon=np.arange(10.0, 18.6)
    )
    mean = blend([coarse, fine])
    np.testing.assert_allclose(mean.lat, np.arange(55.0, 57.1, 0.25))
    np.testing.assert_allclose(mean.lon, [16.0, 17.0, 18.0])
    np.testing.assert_allclose((mean.time - coarse.time[0]) / 3600, [3, 5, 6, 12])
    np.testing.assert_allclose(mean.u, 3.0, rtol=1e-6)
    assert (mean.forecast.resolution_deg, mean.forecast.step_h) == (0.25, 2.0)
    # an edge between two nodes of the finest is kept as an edge
    shifted = blend([coarse, uniform(4.0, lat=np.arange(54.1, 56.2, 0.2))])
    assert (shifted.lat[0], shifted.lat[-1]) == pytest.approx((54.1, 56.1))


def test_a_field_that_varies_is_interpolated_in_space_and_time() -> None:
    slope = uniform(0.0)
    u = (
        slope.lat[None, :, None]
        + slope.lon[None, None, :] / 10
        + (slope.time - slope.time[0])[:, None, None] / 3600
    )
    slope = replace(slope, u=np.broadcast_to(u, slope.u.shape))
    fine = uniform(
        0.0, hours=(0.0, 1.0, 2.0), lat=np.arange(54.0, 57.1, 0.5), lon=np.arange(16.0, 20.1, 0.25)
    )
    mean = blend([slope, fine])
    wanted = (
        mean.lat[None, :, None]
        + mean.lon[None, None, :] / 10
        + (mean.time - mean.time[0])[:, None, None] / 3600
    )
    np.testing.assert_allclose(2 * mean.u, wanted, rtol=1e-5)


def test_what_only_some_have_is_theirs() -> None:
    plain, rich = uniform(1.0), uniform(3.0, gust=9.0, wave=2.0)
    current = Current(plain.time, plain.lat, plain.lon, plain.u, plain.v, plain.forecast)
    mean = blend([plain, replace(rich, current=current)], [9.0, 1.0])
    assert mean.gust is not None
    assert mean.wave is not None
    np.testing.assert_allclose(mean.gust, 9.0)
    np.testing.assert_allclose(mean.wave, 2.0)
    assert mean.current is current
    assert mean.members == ()


def test_names_and_notices_are_joined() -> None:
    winds = [uniform(notice="One."), uniform(name="Storm Glass (sg)", notice="Two."), uniform(notice="One.")]
    forecast = blend(winds).forecast
    assert forecast.source == "Mean of a.grb, Storm Glass (sg) and a.grb"
    assert forecast.notice == "One. Two."


def test_an_area_across_the_date_line_is_found() -> None:
    west = uniform(2.0, lon=[-180.0, -179.0, -178.0])
    east = uniform(4.0, lon=[178.0, 179.0, 180.0, 181.0])
    mean = blend([east, west])
    np.testing.assert_allclose(mean.lon, [180.0, 181.0])
    np.testing.assert_allclose(mean.u, 3.0, rtol=1e-6)


def test_a_single_place_is_everywhere() -> None:
    mean = blend([uniform(2.0), uniform(4.0, lat=[10.0], lon=[0.0])])
    np.testing.assert_allclose(mean.lat, uniform().lat)
    np.testing.assert_allclose(mean.u, 3.0, rtol=1e-6)


def test_a_single_time_in_common_is_told() -> None:
    mean = blend([uniform(2.0), uniform(4.0, hours=(6.0,))])
    assert mean.time.size == 1
    assert "only 2026-01-01 06:00 UTC in common" in mean.forecast.notice


def test_a_blend_too_fine_for_memory_is_thinned(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(blending, "MAX_VALUES", 500)
    mean = blend([uniform(2.0), uniform(4.0, lat=np.linspace(54, 57, 61), lon=np.linspace(16, 20, 81))])
    assert mean.u.size <= 500
    assert (mean.lat[-1], mean.lon[-1]) == (57.0, 20.0)


@pytest.mark.parametrize(
    ("winds", "weights", "words"),
    [
        ([], None, "no forecast to average"),
        (
            [uniform(), uniform(name="File b.nc", hours=(20.0, 30.0))],
            None,
            r"a\.grb covers 2026-01-01 00:00 to 2026-01-01 12:00 UTC and b\.nc covers .* no time in common",
        ),
        (
            [uniform(), uniform(name="File b.nc", lat=[40.0, 41.0])],
            None,
            r"b\.nc covers 40\.0 to 41\.0 N.* no area in common",
        ),
        ([uniform(), uniform(lon=[20.0, 21.0])], None, "no area in common"),
        ([uniform(), uniform()], [1.0], "1 weights for 2 forecasts"),
        ([uniform(), uniform()], [1.0, 0.0], "above 0"),
        ([uniform(), uniform()], [1.0, float("nan")], "above 0"),
    ],
)
def test_what_cannot_be_averaged_is_refused_in_one_sentence(
    winds: Any, weights: list[float] | None, words: str
) -> None:
    with pytest.raises(InputError, match=words) as caught:
        blend(winds, weights)
    assert str(caught.value).count(". ") == 0
