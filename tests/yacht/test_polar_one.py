"""One point a call is the same as many at once: the polar in plain floats."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.yacht.hull import hull_headings
from seacruise.yacht.polar import Polar
from tests.yacht.polars import polar_kn, polars, small

any_wind = st.floats(-5.0, 60.0) | st.just(math.nan) | st.just(math.inf)
any_angle = st.floats(-720.0, 720.0) | st.just(math.nan) | st.sampled_from([0.0, 90.0, 180.0, -180.0])


@given(polar=polars(), tws=any_wind, twa=any_angle)
def test_one_point_is_that_of_the_arrays(polar: Polar, tws: float, twa: float) -> None:
    with np.errstate(invalid="ignore"):
        expected = polar.speed(np.array([tws]), np.array([twa]))[0]
    for one in (polar.speed(tws, twa), polar.speed(np.float64(tws), np.float64(twa))):
        assert one.shape == ()
        np.testing.assert_allclose(one, expected, rtol=1e-13, atol=1e-13)


def test_the_figures_themselves() -> None:
    polar = small()
    for k, tws in enumerate(polar.tws.tolist()):
        for twa, figure in zip(polar.twa.tolist(), polar.speed_table[:, k].tolist(), strict=True):
            if not math.isnan(figure):
                assert float(polar.speed(tws, twa)) == pytest.approx(figure, rel=1e-12)


def test_a_single_wind_speed_and_two() -> None:
    for tws in ((10.0,), (10.0, 20.0)):
        polar = polar_kn(tws, (45.0, 90.0, 150.0), [[5.0 * f for f in range(1, len(tws) + 1)]] * 3)
        for wind in (0.0, 3.0, 5.1, 8.0, 30.0):
            for angle in (10.0, 45.0, 100.0, 170.0):
                many = polar.speed(np.array([wind]), np.array([angle]))[0]
                assert float(polar.speed(wind, angle)) == pytest.approx(many, rel=1e-13, abs=1e-13)


def test_hulls_of_few_winds_are_those_of_many() -> None:
    polar, twa = small(), np.linspace(-180.0, 180.0, 37)
    winds = np.array([3.2, 5.0, 6.1, 7.7, 8.8, 11.0])
    many = hull_headings(polar, winds[:, None], twa)
    for k, wind in enumerate(winds.tolist()):
        for kept, made in zip(hull_headings(polar, wind, twa), many, strict=True):
            np.testing.assert_array_equal(kept, made[k])
