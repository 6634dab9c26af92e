"""Weights, filters, fits and learning, against what is known."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.errors import InputError
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.files import read_polar, write_polar
from seacruise.yacht.logs import weigh
from seacruise.yacht.logs.cells import read_cells, write_cells
from seacruise.yacht.logs.curve import curve_of, fit_curve
from seacruise.yacht.logs.filters import above_quantile, bounded
from seacruise.yacht.logs.fit import Fitted, cloud_of, fit_cloud, fit_table, nodes
from seacruise.yacht.logs.log import Points
from seacruise.yacht.logs.tacks import asymmetry
from seacruise.yacht.logs.update import believed, joined_axes, performance, updated
from tests.yacht.polars import small

KN = MS_PER_KNOT
FITS = {"table": fit_table, "cloud": fit_cloud, "curve": fit_curve}


def smooth(tws: np.typing.ArrayLike, twa: np.typing.ArrayLike) -> np.typing.NDArray[np.float64]:
    """A yacht without kinks [m/s]."""
    wind, angle = np.asarray(tws, dtype=float), np.abs(np.asarray(twa, dtype=float))
    return np.asarray(5.0 * wind / (wind + 5.0) * np.sin(np.radians(angle) / 2.0) ** 0.7)


def points(n: int, *, noise: float = 0.0, seed: int = 0, tacks: float = 0.0) -> Points:
    """Steady points of `smooth`; on the starboard tack she is faster by the share ``tacks``."""
    rng = np.random.default_rng(seed)
    tws = rng.uniform(3.0, 9.0, n)
    twa = np.asarray(rng.uniform(35.0, 180.0, n) * rng.choice((-1.0, 1.0), n), dtype=np.float64)
    speed = smooth(tws, twa) * np.where(twa > 0, 1.0 + tacks, 1.0) + rng.normal(0.0, noise, n)
    return Points(np.linspace(0.0, 10.0 * (n - 1), n), tws, twa, speed, np.ones(n), 10.0)


# --- weights -------------------------------------------------------------------------------------------


def near(given_points: Points, k: int, tws: float, twa: float) -> np.typing.NDArray[np.bool_]:
    x = (given_points.tws - given_points.tws[k]) / tws
    y = (np.abs(given_points.twa) - np.abs(given_points.twa[k])) / twa
    return np.asarray(x**2 + y**2 <= 1.0)


def test_cylindric_mean_is_r5s_formula() -> None:
    some = points(700, noise=0.2)
    off = []
    for k in range(len(some)):
        speed = some.speed[near(some, k, 1.0, 7.5)]
        off.append(abs(speed.mean() - some.speed[k]) / speed.std() if speed.std() > 1e-9 else 0.0)
    expected = 1.0 - np.array(off) / max(off)
    assert weigh.cylindric_mean(some) == pytest.approx(expected, abs=1e-6)


def test_cylindric_member_is_r5s_formula() -> None:
    some = points(700, noise=0.2)
    members = np.array(
        [
            (near(some, k, 1.0, 7.5) & (np.abs(some.speed - some.speed[k]) <= 0.25)).sum() - 1
            for k in range(700)
        ]
    )
    assert weigh.cylindric_member(some) == pytest.approx(members / members.max())


def test_an_outlier_weighs_least() -> None:
    some = points(400, noise=0.05)
    some.speed[7] += 2.0
    assert np.argmin(weigh.cylindric_mean(some)) == 7
    assert weigh.cylindric_member(some)[7] == 0.0


def test_fluctuation_is_r5s_formula() -> None:
    rng = np.random.default_rng(1)
    time, values = np.cumsum(rng.uniform(1.0, 30.0, 200)), rng.normal(4.0, 0.4, 200)
    expected = []
    for moment in time:
        around = values[(time >= moment - 40.0) & (time <= moment + 20.0)]
        expected.append(max(0.0, 1.0 - around.std() / 0.6))
    found = weigh.fluctuation(time, values, most=0.6, before_s=40.0, after_s=20.0)
    assert found == pytest.approx(expected, abs=1e-9)


def test_weights_of_alike_points_are_one() -> None:
    alike = points(5)
    for column in ("tws", "twa", "speed"):
        getattr(alike, column)[:] = 5.0
    assert weigh.cylindric_mean(alike).tolist() == [1.0] * 5
    assert weigh.cylindric_member(alike).tolist() == [1.0] * 5
    assert weigh.cylindric_mean(alike.rows(slice(0, 0))).size == 0


def test_filters() -> None:
    weights = np.array((0.0, 0.2, 0.5, 1.0))
    assert bounded(weights, low=0.2, high=0.9).tolist() == [False, True, True, False]
    assert above_quantile(weights, 0.25).tolist() == [False, True, True, True]
    assert above_quantile(np.ones(5), 0.5).all()
    assert above_quantile(np.empty(0), 0.5).size == 0


# --- fits ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", FITS)
def test_a_known_yacht_comes_out(method: str) -> None:
    some = points(4000, noise=0.15)
    fitted = FITS[method](some, *nodes(some))
    known = fitted.certain & (fitted.twa >= 40)[:, np.newaxis]
    truth = smooth(fitted.tws, fitted.twa[:, np.newaxis])
    assert known.sum() > 80
    assert np.abs(fitted.speed[known] - truth[known]).max() < 0.2
    assert np.median(np.abs(fitted.speed[known] / truth[known] - 1.0)) < 0.02


def test_standard_errors_are_what_they_say() -> None:
    """Over many logs of independent points the errors of the figures spread as was told."""
    off = []
    axes = np.array((5.0, 6.0, 7.0)), np.array((60.0, 90.0, 120.0))
    for seed in range(60):
        some = replace(points(1500, noise=0.3, seed=seed), span=75.0)
        fitted = fit_table(some, *axes)
        off.append((fitted.speed - smooth(axes[0], axes[1][:, np.newaxis])) / fitted.error)
    spread = np.std(off)
    assert 0.7 < spread < 1.3


def test_orthogonal_distance_undoes_the_flattening_by_errors_in_the_wind() -> None:
    rng = np.random.default_rng(5)
    true = points(3000, seed=5)
    seen = replace(
        true,
        tws=true.tws + rng.normal(0.0, 0.7, 3000),
        twa=np.sign(true.twa) * np.clip(np.abs(true.twa) + rng.normal(0.0, 4.0, 3000), 20.0, 180.0),
        speed=true.speed + rng.normal(0.0, 0.25, 3000),
    )
    grid = np.linspace(4.0, 8.0, 9), np.arange(45.0, 170.0, 5.0)
    truth = smooth(grid[0], grid[1][:, np.newaxis])
    flat, right = (
        np.abs(curve_of(seen, orthogonal=each).speed(grid[0], grid[1][:, np.newaxis]) / truth - 1.0).mean()
        for each in (False, True)
    )
    assert right < flat
    assert right < 0.02


def test_outliers_do_not_bend_the_curve() -> None:
    some = points(1000, noise=0.05)
    some.speed[::20] = 0.3
    fitted = fit_curve(some, *nodes(some))
    truth = smooth(fitted.tws, fitted.twa[:, np.newaxis])
    known = fitted.certain & (fitted.twa >= 40)[:, np.newaxis]
    assert np.abs(fitted.speed[known] - truth[known]).max() < 0.2


def test_weights_count() -> None:
    some = points(2000)
    some.speed[::2] *= 0.5
    weight = np.where(np.arange(2000) % 2 == 0, 0.0, 1.0)
    for fit in FITS.values():
        fitted = fit(replace(some, weight=weight), np.array((6.0, 7.0)), np.array((80.0, 100.0)))
        assert fitted.speed == pytest.approx(smooth(fitted.tws, fitted.twa[:, np.newaxis]), rel=0.03)


def test_no_figure_without_points() -> None:
    some = points(500)
    upwind = some.rows((np.abs(some.twa) < 70.0) & (some.tws < 6.0))
    for fit in FITS.values():
        fitted = fit(upwind, *nodes(some))
        assert np.isnan(fitted.speed[fitted.twa > 90.0]).all()
        assert np.isnan(fitted.speed[:, fitted.tws > 8.5]).all()
        polar = fitted.polar("part")
        assert polar.twa.max() <= 80.0


def test_gaps_are_filled_by_what_angle_and_wind_have_in_common() -> None:
    rng = np.random.default_rng(2)
    tws, twa = np.arange(3.0, 11.0), np.arange(40.0, 180.0, 10.0)
    truth = smooth(tws, twa[:, np.newaxis])
    known = rng.random(truth.shape) < 0.4
    error = np.where(known, 0.05, 2.0)
    error[0, 0] = np.nan
    table = np.where(known, truth, 9.0)
    fitted = Fitted(tws, twa, table, error, np.ones(truth.shape))
    filled = fitted.filled()
    assert filled[fitted.certain].tolist() == truth[fitted.certain].tolist()
    sailed = fitted.certain.any(axis=1)
    assert np.isnan(filled[~sailed]).all()
    assert filled[sailed] == pytest.approx(truth[sailed], rel=0.03)
    polar = fitted.polar("Filled")
    assert not np.isnan(polar.speed_table).any()


def test_the_cloud_stands_still_dead_into_the_wind() -> None:
    cloud = cloud_of(points(500))
    assert cloud.speed(6.0, 0.0) == pytest.approx(0.0, abs=1e-6)
    assert cloud.speed(6.0, 90.0) == pytest.approx(float(smooth(6.0, 90.0)), rel=0.05)


def test_too_little_for_a_polar() -> None:
    one_course = points(200)
    one_course.tws[:] = 5.15
    one_course.twa[:] = 90.0
    with pytest.raises(InputError, match="steady sailing at"):
        fit_table(one_course, np.array((5.15, 12.0)), np.array((60.0, 90.0))).polar("one")
    with pytest.raises(InputError, match="30 steady points or more and the log has 20"):
        curve_of(points(20))


def test_a_curve_without_scipy_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "scipy.optimize", None)
    with pytest.raises(InputError, match=r"seacruise\[fit\]"):
        curve_of(points(200))


# --- tacks ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("share", [-0.08, 0.0, 0.08])
def test_a_faster_tack_is_found(share: float) -> None:
    some = points(4000, noise=0.15, tacks=share)
    found = asymmetry(some, *nodes(some))
    assert found is not None
    assert found.difference == pytest.approx(share, abs=0.015)
    assert found.significant is bool(share)


def test_one_tack_cannot_be_compared() -> None:
    some = points(300)
    assert asymmetry(some.rows(some.twa > 0.0), *nodes(some)) is None


# --- learning ------------------------------------------------------------------------------------------


def figures(seed: int) -> Fitted:
    rng = np.random.default_rng(seed)
    speed = rng.uniform(2.0, 5.0, (3, 4))
    speed[rng.random((3, 4)) < 0.3] = np.nan
    error = np.where(np.isnan(speed), np.nan, rng.uniform(0.05, 0.5, (3, 4)))
    return Fitted(
        np.arange(4.0) + 3.0, np.array((45.0, 90.0, 135.0)), speed, error, rng.uniform(0, 9, (3, 4))
    )


@given(st.integers(0, 999))
def test_the_order_of_logs_does_not_matter(seed: int) -> None:
    a, b, c = (figures(seed * 3 + k) for k in range(3))
    one, other = updated(updated(a, b), c), updated(a, updated(c, b))
    assert one.speed == pytest.approx(other.speed, nan_ok=True)
    assert one.error == pytest.approx(other.error, nan_ok=True)
    assert one.count == pytest.approx(other.count)


@given(st.integers(0, 999))
def test_what_was_seen_pulls_as_far_as_it_is_certain(seed: int) -> None:
    prior, seen = figures(seed), figures(seed + 1000)
    after = updated(prior, seen)
    both = ~np.isnan(prior.speed) & ~np.isnan(seen.speed)
    low, high = np.minimum(prior.speed, seen.speed)[both], np.maximum(prior.speed, seen.speed)[both]
    assert ((after.speed[both] >= low - 1e-9) & (after.speed[both] <= high + 1e-9)).all()
    assert (after.error[both] < np.minimum(prior.error, seen.error)[both]).all()
    alone = ~np.isnan(prior.speed) & np.isnan(seen.speed)
    assert after.speed[alone] == pytest.approx(prior.speed[alone])


def test_learning_worked_by_hand() -> None:
    def one(speed: float, error: float) -> Fitted:
        axis = np.array((5.0,))
        return Fitted(axis, axis, *(np.full((1, 1), v) for v in (speed, error, 1.0)))

    after = updated(one(4.0, 0.2), one(3.0, 0.1))
    # Precisions 25 and 100: a fifth of the way from what was seen.
    assert after.speed[0, 0] == pytest.approx(3.2)
    assert after.error[0, 0] == pytest.approx(1.0 / np.sqrt(125.0))
    with pytest.raises(InputError, match="other wind speeds or angles"):
        updated(one(4.0, 0.2), replace(one(3.0, 0.1), twa=np.array((6.0,))))


def test_performance_against_a_polar() -> None:
    polar = small()
    some = points(2000)
    some = replace(some, speed=0.9 * polar.speed(some.tws, some.twa))
    found = performance(some, polar)
    assert found is not None
    assert found.share == pytest.approx(0.9)
    assert 0.9 < found.shrunk < 0.91
    few = performance(some.rows(slice(0, 8)), polar)
    assert few is not None
    assert 0.98 < few.shrunk < 1.0
    assert performance(replace(some, twa=np.zeros(2000)), polar) is None


def test_a_fit_is_kept_beside_its_polar(tmp_path: Path) -> None:
    some = points(3000, noise=0.1)
    fitted = fit_table(some, *nodes(some))
    path = tmp_path / "mine.csv"
    write_polar(fitted.polar("Mine"), path)
    write_cells(fitted, path)
    again = read_cells(read_polar(path))
    assert again is not None
    for name in ("tws", "twa", "speed", "error", "count"):
        assert getattr(again, name) == pytest.approx(getattr(fitted, name), abs=1e-5, nan_ok=True)
    write_polar(fitted.polar("Mine"), tmp_path / "other.csv")
    assert read_cells(read_polar(tmp_path / "other.csv")) is None
    slower = replace(fitted, speed=fitted.speed * 0.9)
    write_polar(slower.polar("Mine"), path)
    assert read_cells(read_polar(path)) is None, "the polar was changed by hand"
    path.with_suffix(".cells").write_text('{"schema": "x"}', encoding="utf-8")
    with pytest.raises(InputError, match=r"mine\.cells beside the polar cannot be used"):
        read_cells(read_polar(path))
    assert read_cells(small()) is None


def test_axes_are_joined_and_figures_put_on_them() -> None:
    fitted = fit_table(points(3000), *nodes(points(3000)))
    polar = small()
    tws, twa = joined_axes(polar, fitted)
    assert set(polar.tws) <= set(tws)
    assert set(polar.twa) <= set(twa)
    assert (np.diff(twa) > 0).all()
    before = believed(polar, tws, twa, scale=0.9)
    assert before.speed == pytest.approx(0.9 * polar.speed(tws, twa[:, np.newaxis]))
    wide, angles = np.union1d(fitted.tws, (1.0, 30.0)), np.union1d(fitted.twa, (33.3,))
    spread = fitted.on(wide, angles)
    assert spread.count.sum() == pytest.approx(fitted.count.sum())
    assert np.isnan(spread.speed[:, 0]).all()
