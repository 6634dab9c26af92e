"""The continuous polar: between its figures, beyond its table, and by R1's rule."""

from __future__ import annotations

import dataclasses
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import PchipInterpolator

from seacruise.errors import InputError
from seacruise.resources import resource_path
from seacruise.units import MS_PER_KNOT
from seacruise.yacht import _pchip
from seacruise.yacht.files import read_polar
from seacruise.yacht.polar import Polar, fold_angle
from tests.yacht.polars import NAN, polar_kn, polars, small

KN = MS_PER_KNOT


@given(
    st.lists(st.integers(0, 10_000), min_size=2, max_size=12, unique=True).map(sorted),
    st.data(),
)
def test_slopes_are_those_of_scipy(x: list[int], data: st.DataObject) -> None:
    y = data.draw(st.lists(st.integers(-500, 500), min_size=len(x), max_size=len(x)))
    xs, ys = np.array(x) / 10.0, np.array(y) / 10.0
    expected = PchipInterpolator(xs, ys).derivative()(xs)
    np.testing.assert_allclose(_pchip.slopes(xs, ys), expected, rtol=1e-9, atol=1e-9)


def test_one_figure_is_level() -> None:
    assert _pchip.slopes(np.array([3.0]), np.array([7.0])).tolist() == [0.0]


def test_figures_of_the_table_are_returned_exactly() -> None:
    polar = small()
    speed = polar.speed(polar.tws, polar.twa[:, np.newaxis])
    known = ~np.isnan(polar.speed_table)
    np.testing.assert_allclose(speed[known], polar.speed_table[known], rtol=1e-12)


def test_between_figures_it_is_scipys_pchip_in_angle_up_to_the_best_vmg() -> None:
    polar = small()
    for k in range(len(polar.tws)):
        known = ~np.isnan(polar.speed_table[:, k])
        x, y = polar.twa[known], polar.speed_table[known, k]
        angles = np.linspace(x[0], x[-1], 400)
        cosine = np.cos(np.radians(angles))
        vmg = y * np.cos(np.radians(x))
        limit = np.where(angles <= 90.0, vmg.max(), -vmg.min()) / np.maximum(np.abs(cosine), 1e-12)
        expected = np.minimum(PchipInterpolator(x, y)(angles), limit)
        np.testing.assert_allclose(polar.speed(polar.tws[k], angles), expected, rtol=1e-9)


def test_between_winds_it_is_scipys_pchip() -> None:
    polar = small()
    winds = np.linspace(polar.tws[0], polar.tws[-1], 50)
    for twa in (60.0, 90.0, 120.0):
        row = polar.speed_table[list(polar.twa).index(twa)]
        expected = PchipInterpolator(polar.tws, row)(winds)
        np.testing.assert_allclose(polar.speed(winds, twa), expected, rtol=1e-9)


def test_two_winds_are_joined_by_a_line() -> None:
    polar = polar_kn((6, 10), (45, 90, 150), ((4, 6), (5, 7), (3, 5)))
    assert polar.speed(8 * KN, 90.0) == pytest.approx(6 * KN)


def test_below_the_least_wind_it_falls_linearly_to_zero() -> None:
    polar = small()
    first = float(polar.speed(6 * KN, 90.0))
    np.testing.assert_allclose(
        polar.speed(np.array([0, 1.5, 3, 6]) * KN, 90.0), first * np.array([0, 0.25, 0.5, 1])
    )


def test_above_the_greatest_wind_it_stays() -> None:
    polar = small()
    np.testing.assert_array_equal(
        polar.speed(np.array([17, 40, 1e6]) * KN, 100.0), polar.speed(16 * KN, 100.0)
    )


def test_nothing_dead_into_the_wind_unless_the_table_says_so() -> None:
    assert small().speed(10 * KN, 0.0) == 0.0
    drifts = polar_kn((6, 10), (0, 45, 90, 150), ((0.5, 0.7), (4, 6), (5, 7), (3, 5)))
    assert drifts.speed(10 * KN, 0.0) == pytest.approx(0.7 * KN)


def test_a_row_of_zeros_at_zero_changes_nothing() -> None:
    without = polar_kn((6, 10), (45, 90, 150), ((4, 6), (5, 7), (3, 5)))
    with_row = polar_kn((6, 10), (0, 45, 90, 150), ((0, 0), (4, 6), (5, 7), (3, 5)))
    angles = np.arange(181.0)
    np.testing.assert_allclose(with_row.speed(8 * KN, angles), without.speed(8 * KN, angles))


def test_zeros_above_zero_degrees_are_a_dead_angle() -> None:
    polar = polar_kn((6, 10), (0, 30, 45, 90, 150), ((0, 0), (0, 0), (4, 6), (5, 7), (3, 5)))
    assert (polar.speed(8 * KN, np.arange(0, 31)) == 0.0).all()


@pytest.mark.parametrize("least", [30.0, 45.0, 52.0, 60.0, 75.0, 89.0])
def test_the_fall_to_the_eye_of_the_wind_promises_no_better_vmg(least: float) -> None:
    polar = polar_kn((6, 10), (least, 90, 150), ((4, 6), (5, 7), (3, 5)))
    angles = np.linspace(0.0, least, 500)
    vmg = polar.speed(10 * KN, angles) * np.cos(np.radians(angles))
    assert vmg.max() <= vmg[-1] * (1 + 1e-9)
    assert (np.diff(polar.speed(10 * KN, angles)) >= -1e-12).all()


@pytest.mark.parametrize("greatest", [110.0, 135.0, 150.0, 165.0, 179.0])
def test_beyond_the_greatest_angle_the_vmg_to_leeward_stays(greatest: float) -> None:
    polar = polar_kn((6, 10), (45, 60, greatest), ((4, 6), (5, 7), (3, 5)))
    angles = np.linspace(greatest, 180.0, 500)
    vmg = -polar.speed(10 * KN, angles) * np.cos(np.radians(angles))
    assert vmg.max() <= vmg[0] * (1 + 1e-9)
    assert vmg.min() >= vmg[0] * 0.998


@pytest.mark.parametrize("angles", [(90.0,), (120.0, 150.0), (40.0, 80.0)])
def test_a_table_of_one_side_invents_nothing_on_the_other(angles: tuple[float, ...]) -> None:
    polar = polar_kn((6, 10), angles, [[4.0, 5.0]] * len(angles))
    speed = polar.speed(8 * KN, np.arange(181.0))
    assert np.isfinite(speed).all()
    if angles[0] > 60.0:
        assert polar.speed(8 * KN, 60.0) == 0.0
    if angles[-1] < 90.0:
        assert polar.speed(8 * KN, 120.0) == 0.0


def test_no_certificate_makes_good_more_than_its_best_figure() -> None:
    for path in sorted(resource_path("polars").glob("*.csv")):
        polar = read_polar(path)
        vmg = polar.speed_table * np.cos(np.radians(polar.twa))[:, np.newaxis]
        _, upwind = polar.best_vmg(polar.tws, True)
        _, downwind = polar.best_vmg(polar.tws, False)
        np.testing.assert_allclose(upwind, np.nanmax(vmg, axis=0), rtol=1e-9, err_msg=path.name)
        np.testing.assert_allclose(downwind, -np.nanmin(vmg, axis=0), rtol=1e-9, err_msg=path.name)


def test_best_vmg_of_a_certificate_is_at_its_beat_angle() -> None:
    polar = read_polar(resource_path("polars") / "bavaria-46-cruiser.csv")
    twa, vmg = polar.best_vmg(10 * KN, True)
    assert twa == 42.0
    assert float(vmg) / KN == pytest.approx(4.89, abs=0.001)
    twa, vmg = polar.best_vmg(12 * KN, False)
    assert twa == pytest.approx(150.5, abs=0.6)
    assert float(vmg) / KN == pytest.approx(6.57, abs=0.002)


def test_best_vmg_keeps_the_shape_of_the_wind() -> None:
    twa, vmg = small().best_vmg(np.full((2, 3), 5.0), True)
    assert twa.shape == vmg.shape == (2, 3)


@pytest.mark.parametrize(
    ("tws_kn", "column"),
    [(0.5, 6), (5.5, 6), (7.0, 6), (7.1, 8), (17.0, 16), (18.0, 16), (18.1, 20), (45.0, 20)],
)
def test_nearest_speed_reads_the_nearest_column(tws_kn: float, column: int) -> None:
    winds = (6, 8, 10, 12, 14, 16, 20)
    polar = polar_kn(winds, (52, 90, 150), [winds] * 3)
    assert polar.nearest_speed(tws_kn * KN, 70.0) == pytest.approx(column * KN)


def test_nearest_speed_is_linear_in_angle_and_zero_in_the_dead_angle() -> None:
    polar = small()
    assert polar.nearest_speed(10 * KN, 75.0) == pytest.approx(7.3 * KN)
    assert polar.nearest_speed(10 * KN, 41.9) == 0.0
    assert polar.nearest_speed(10 * KN, 42.0) == pytest.approx(6.2 * KN)
    assert polar.nearest_speed(6 * KN, 44.0) == 0.0
    assert polar.nearest_speed(10 * KN, 180.0) == pytest.approx(5.2 * KN)
    assert polar.nearest_speed(0.0, 90.0) == 0.0


@pytest.mark.parametrize("method", ["speed", "nearest_speed"])
def test_arguments_broadcast_and_nan_stays_nan(method: str) -> None:
    evaluate = getattr(small(), method)
    assert evaluate(np.ones((4, 1)), np.ones((1, 5))).shape == (4, 5)
    assert np.isnan(evaluate(np.nan, 90.0))
    assert np.isnan(evaluate(5.0, np.nan))


@pytest.mark.parametrize(("given_angle", "folded"), [(-90, 90), (190, 170), (360, 0), (725, 5), (-180, 180)])
def test_angles_are_folded(given_angle: float, folded: float) -> None:
    assert fold_angle(given_angle) == folded
    polar = small()
    assert polar.speed(5.0, given_angle) == polar.speed(5.0, folded)


@given(polars(), st.floats(0, 40), st.floats(-180, 180))
def test_both_tacks_are_alike(polar: Polar, tws: float, twa: float) -> None:
    assert polar.speed(tws, twa) == polar.speed(tws, -twa)


@given(polars(), st.floats(0, 40), st.floats(0, 180))
def test_a_speed_lies_between_the_figures_around_it(polar: Polar, tws: float, twa: float) -> None:
    speed = float(polar.speed(tws, twa))
    low, high = np.inf, 0.0
    right = int(np.clip(np.searchsorted(polar.tws, tws), 1, len(polar.tws) - 1))
    for k in (right - 1, right):
        known = ~np.isnan(polar.speed_table[:, k])
        x, y = polar.twa[known], polar.speed_table[known, k]
        at = int(np.searchsorted(x, twa))
        around = y[max(at - 1, 0) : at + 1]
        beyond = twa < x[0] or twa > x[-1]
        low, high = min(low, 0.0 if beyond else around.min()), max(high, around.max())
    if tws < polar.tws[0]:
        low = 0.0
    assert low - 1e-9 <= speed <= high + 1e-9


@given(polars(), st.floats(0.1, 3.0), st.floats(0, 40), st.floats(0, 180))
def test_a_polar_k_times_as_fast_sails_k_times_as_fast(
    polar: Polar, k: float, tws: float, twa: float
) -> None:
    scaled = dataclasses.replace(polar, speed_table=polar.speed_table * k)
    assert float(scaled.speed(tws, twa)) == pytest.approx(
        k * float(polar.speed(tws, twa)), rel=1e-9, abs=1e-9
    )
    assert float(scaled.nearest_speed(tws, twa)) == pytest.approx(
        k * float(polar.nearest_speed(tws, twa)), rel=1e-9, abs=1e-9
    )


@pytest.mark.parametrize(
    ("tws", "twa", "table"),
    [
        pytest.param((6, 6), (40, 90), ((1, 1), (1, 1)), id="duplicate wind"),
        pytest.param((8, 6), (40, 90), ((1, 1), (1, 1)), id="falling wind"),
        pytest.param((-1, 6), (40, 90), ((1, 1), (1, 1)), id="negative wind"),
        pytest.param((6, 8), (90, 40), ((1, 1), (1, 1)), id="falling angle"),
        pytest.param((6, 8), (40, 190), ((1, 1), (1, 1)), id="angle above 180"),
        pytest.param((6, 8), (40, 90), ((1, -1), (1, 1)), id="negative speed"),
        pytest.param((6, 8), (40, 90), ((1, np.inf), (1, 1)), id="infinite speed"),
        pytest.param((6, 8), (40, 90), ((1, NAN), (1, NAN)), id="empty column"),
        pytest.param((6, 8), (40, 90), ((1, 1, 1), (1, 1, 1)), id="wrong shape"),
        pytest.param((), (), ((),), id="nothing"),
    ],
)
def test_what_is_no_polar_cannot_be_made(tws: object, twa: object, table: object) -> None:
    with pytest.raises(InputError, match="The polar of Test cannot be used"):
        polar_kn(tws, twa, table)


def test_a_polar_cannot_be_changed_and_goes_to_other_processes() -> None:
    polar = small()
    with pytest.raises(ValueError, match="read-only"):
        polar.speed_table[0, 0] = 9.0
    copy = pickle.loads(pickle.dumps(polar))
    assert copy.speed(5.0, 80.0) == polar.speed(5.0, 80.0)
