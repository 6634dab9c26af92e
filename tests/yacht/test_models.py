"""Points, curves, sails and tacks: what every representation keeps, and what becomes of it in a table."""

from __future__ import annotations

import dataclasses
import pickle
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from seacruise.errors import InputError
from seacruise.resources import resource_path
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.curve import PolarCurve, curve_basis
from seacruise.yacht.files import read_polar
from seacruise.yacht.models import SpeedModel
from seacruise.yacht.points import PolarPoints
from seacruise.yacht.polar import Polar
from seacruise.yacht.sails import SailRange, SailSet, sail_at, sail_names
from seacruise.yacht.tacks import TwoSided
from tests.yacht.polars import NAN, polar_kn, polars, small

KN = MS_PER_KNOT
Array = NDArray[np.float64]


def points_of(polar: Polar) -> tuple[Array, Array, Array]:
    angle, wind = np.nonzero(~np.isnan(polar.speed_table))
    return polar.tws[wind], polar.twa[angle], polar.speed_table[angle, wind]


def fitted(points: tuple[Array, Array, Array], winds: int = 4, angles: int = 8) -> PolarCurve:
    """Least squares, with a small price on the cube of each wave's number."""
    tws, twa, speed = points
    terms = curve_basis(tws, twa, winds=winds, angles=angles)
    price = np.sqrt(1e-8 * speed.size) * np.tile((np.arange(angles) + 0.5) ** 3, winds)
    found = np.linalg.lstsq(
        np.vstack((terms, np.diag(price))), np.concatenate((speed, np.zeros(price.size))), rcond=None
    )
    limits = (tws.min(), tws.max()), (twa.min(), twa.max())
    return PolarCurve("Curve", found[0].reshape(winds, angles), *limits)


def genoa() -> Polar:
    return polar_kn((6, 10, 16, 20), (45, 60, 90, 120, 150), [[4, 5.5, 6.2, 6.4]] * 5, name="Genoa")


def gennaker() -> Polar:
    table = ((3.8, 5.2, 6.0), (5.6, 7.2, 8.0), (5.2, 7.2, 8.3), (3.4, 5.3, 7.2))
    return polar_kn((6, 10, 16), (80, 100, 120, 160), table, name="Gennaker")


def models() -> list[SpeedModel]:
    yacht = read_polar(resource_path("polars") / "bavaria-46-cruiser.csv")
    sailed = points_of(yacht)
    slow = dataclasses.replace(yacht, speed_table=yacht.speed_table * 0.9)
    return [
        yacht,
        PolarPoints("Points", *sailed),
        fitted(sailed),
        SailSet("Sails", (genoa(), gennaker())),
        TwoSided("Tacks", yacht, slow),
    ]


each_model = pytest.mark.parametrize("model", models(), ids=lambda model: type(model).__name__)


@each_model
def test_every_representation_keeps_the_laws(model: SpeedModel) -> None:
    winds, angles = np.linspace(0, 60, 121)[:, np.newaxis] * KN, np.linspace(0, 180, 181)
    speed = model.speed(winds, angles)
    assert speed.shape == (121, 181)
    assert np.isfinite(speed).all()
    assert (speed >= 0.0).all()
    assert (speed[0] == 0.0).all()
    assert (speed[:, 0] == 0.0).all()
    assert speed.max() < 14.0 * KN
    np.testing.assert_array_equal(model.speed(winds, -angles), speed)
    np.testing.assert_array_equal(model.speed(winds, 360.0 - angles), speed)
    np.testing.assert_allclose(speed[-1], speed[-2], rtol=1e-12)
    assert np.isnan(model.speed(NAN, 90.0))
    assert np.isnan(model.speed(5.0, NAN))
    # Nothing jumps: half a degree and half a knot change little, but where sails are struck.
    fine = model.speed(np.linspace(4, 15.9, 200)[:, np.newaxis] * KN, np.linspace(50, 150, 401))
    assert np.abs(np.diff(fine, axis=0)).max() < 0.35 * KN
    assert np.abs(np.diff(fine, axis=1)).max() < 0.35 * KN


@each_model
def test_every_representation_becomes_a_table(model: SpeedModel) -> None:
    table = model.to_table()
    assert table.name == model.name
    for k, wind in enumerate(table.tws):
        known = ~np.isnan(table.speed_table[:, k])
        np.testing.assert_allclose(
            table.speed_table[known, k], model.speed(wind, table.twa[known]), rtol=1e-9, atol=1e-9
        )
    # From 16 to 16.5 kn a sail is struck. Points are met by small terraces, and between two winds sails
    # change at an angle of their own: no table follows either.
    most, mean = {PolarPoints: (0.4, 0.1), SailSet: (0.35, 0.06)}.get(type(model), (0.15, 0.03))
    winds = np.array((6.1, 8.3, 11, 13, 15.7, 17, 19.9))[:, np.newaxis] * KN
    angles = np.linspace(50, 148, 99)
    difference = np.abs(table.speed(winds, angles) - model.speed(winds, angles))
    assert difference.max() < most * KN
    assert np.sqrt((difference**2).mean()) < mean * KN


# ------------------------------------------------------------------------------------- points


@given(polars(), st.floats(0, 40), st.floats(0, 180))
def test_points_are_met_and_bound_the_speed(polar: Polar, tws: float, twa: float) -> None:
    points = PolarPoints("Cloud", *points_of(polar))
    np.testing.assert_allclose(points.speed(points.tws, points.twa), points.boat_speed, atol=1e-9)
    assert 0.0 <= float(points.speed(tws, twa)) <= points.boat_speed.max() * (1 + 1e-9)
    if points.winds[0] <= tws <= points.winds[1] and points.angles[0] <= twa <= points.angles[1]:
        assert float(points.speed(tws, twa)) >= points.boat_speed.min() * (1 - 1e-9)


def test_points_are_weighed_by_their_distance() -> None:
    # Along one wind, three points: the middle of the first two, with the third as the farthest.
    points = PolarPoints("Line", np.full(3, 5.0), np.array([50.0, 60.0, 90.0]), np.array([4.0, 6.0, 9.0]))
    # Distances 0.5, 0.5 and 3.5 steps of ten degrees: the farthest weighs nothing.
    assert float(points.speed(5.0, 55.0)) == pytest.approx(5.0)
    # At 58: distances 0.8, 0.2, 3.2, so weights (2.4 / 2.56)**2 and (3.0 / 0.64)**2.
    w0, w1 = (2.4 / 2.56) ** 2, (3.0 / 0.64) ** 2
    assert float(points.speed(5.0, 58.0)) == pytest.approx((4.0 * w0 + 6.0 * w1) / (w0 + w1))


def test_many_points_find_the_surface_they_are_from() -> None:
    yacht = read_polar(resource_path("polars") / "bavaria-46-cruiser.csv")
    rng = np.random.default_rng(46)
    tws, twa = rng.uniform(5, 20, 2000) * KN, rng.uniform(45, 165, 2000)
    points = PolarPoints("Log", tws, twa, yacht.speed(tws, twa))
    asked = rng.uniform(6, 19, 500) * KN, rng.uniform(50, 160, 500)
    error = points.speed(*asked) / yacht.speed(*asked) - 1.0
    assert np.sqrt((error**2).mean()) < 0.02
    assert abs(error).max() < 0.1


def test_points_at_one_place_are_averaged() -> None:
    points = PolarPoints(
        "Two", np.array([5.0, 5.0, 8.0]), np.array([90.0, 90.0, 90.0]), np.array([4.0, 5.0, 6.0])
    )
    assert float(points.speed(5.0, 90.0)) == pytest.approx(4.5)


@pytest.mark.parametrize(
    "columns",
    [
        ([], [], []),
        ([5.0], [90.0], [np.nan]),
        ([5.0], [190.0], [4.0]),
        ([-5.0], [90.0], [4.0]),
        ([5.0], [90.0], [-4.0]),
        ([5.0, 6.0], [90.0], [4.0]),
    ],
)
def test_what_are_no_points_cannot_be_made(columns: tuple[list[float], ...]) -> None:
    tws, twa, speed = (np.array(column) for column in columns)
    with pytest.raises(InputError, match="The points of Bad cannot be used"):
        PolarPoints("Bad", tws, twa, speed)


# ------------------------------------------------------------------------------------- curve


def test_the_curve_is_its_formula() -> None:
    tws, twa = 8.0, 70.0
    share = tws / (tws + 12 * KN)
    terms = curve_basis(tws, twa, winds=2, angles=3)
    expected = [share**i * np.sin(np.radians((j + 0.5) * twa)) for i in (1, 2) for j in (0, 1, 2)]
    np.testing.assert_allclose(terms, expected)
    curve = PolarCurve("One", np.array([[2.0, 0.5]]), (2.0, 12.0), (30.0, 180.0))
    assert float(curve.speed(tws, twa)) == pytest.approx(
        share * (2.0 * np.sin(np.radians(35.0)) + 0.5 * np.sin(np.radians(105.0)))
    )


def test_a_fit_finds_the_curve_that_the_points_are_from() -> None:
    true = PolarCurve("True", np.array([[8.0, 2.0, -0.5], [-1.0, 0.5, 0.2]]), (2.0, 12.0), (30.0, 180.0))
    rng = np.random.default_rng(3)
    tws, twa = rng.uniform(2, 12, 300), rng.uniform(30, 180, 300)
    found = fitted((tws, twa, true.speed(tws, twa)), winds=2, angles=3)
    np.testing.assert_allclose(found.speed(tws, twa), true.speed(tws, twa), atol=2e-3)


def test_certificates_are_curves_to_two_per_cent() -> None:
    misfits = []
    for path in sorted(resource_path("polars").glob("*.csv")):
        sailed = points_of(read_polar(path))
        curve = fitted(sailed)
        misfits.append(np.sqrt(((curve.speed(*sailed[:2]) / sailed[2] - 1.0) ** 2).mean()))
    assert np.median(misfits) < 0.02


@pytest.mark.parametrize(
    ("parameters", "winds", "angles"),
    [
        ([[np.nan]], (2.0, 12.0), (30.0, 180.0)),
        ([1.0], (2.0, 12.0), (30.0, 180.0)),
        ([[1.0]], (12.0, 2.0), (30.0, 180.0)),
        ([[1.0]], (2.0, 12.0), (30.0, 190.0)),
    ],
)
def test_what_is_no_curve_cannot_be_made(parameters: Any, winds: Any, angles: Any) -> None:
    with pytest.raises(InputError, match="The curve of Bad cannot be used"):
        PolarCurve("Bad", np.array(parameters), winds, angles)


# ------------------------------------------------------------------------------------- sails


def test_the_best_sail_has_a_name_and_gives_way_where_another_is_as_fast() -> None:
    sails = SailSet("Yacht", (genoa(), gennaker()))
    assert sails.sail(10 * KN, 50.0) == "Genoa"
    assert sails.sail(10 * KN, 120.0) == "Gennaker"
    assert sails.sail(10 * KN, -120.0) == "Gennaker"
    assert sails.sail(0.0, 120.0) is None
    low, high = sails.ranges(10 * KN)
    assert (low.sail, high.sail) == ("Genoa", "Gennaker")
    assert low.twa_to == high.twa_from
    speeds = sails.speeds(10 * KN, low.twa_to)
    assert float(speeds[0]) == pytest.approx(float(speeds[1]), abs=1e-3)
    assert high.twa_to == 180.0


def test_a_sail_is_not_set_in_more_wind_than_its_table_has() -> None:
    sails = SailSet("Yacht", (genoa(), gennaker()))
    assert sails.sail(16 * KN, 120.0) == "Gennaker"
    assert sails.sail(18 * KN, 120.0) == "Genoa"
    assert sails.sail(60 * KN, 120.0) == "Genoa"
    assert sails.ranges(20 * KN)[0].sail == "Genoa"
    assert len(sails.ranges(20 * KN)) == 1
    assert isinstance(sails.ranges(20 * KN)[0], SailRange)


def test_a_table_of_sails_is_the_best_of_them_and_names_them() -> None:
    table = SailSet("Yacht", (genoa(), gennaker())).to_table()
    assert sail_at(table, 10 * KN, 120.0) == "Gennaker"
    assert sail_at(table, 18 * KN, 120.0) == "Genoa"
    assert sail_at(small(), 10 * KN, 120.0) is None
    names = sail_names(table)
    assert len(names) == len(table.twa)
    row = list(table.twa).index(120.0)
    np.testing.assert_allclose(table.tws / KN, [6, 10, 16, 16.5, 20])
    assert names[row] == ("Gennaker", "Gennaker", "Gennaker", "Genoa", "Genoa")
    assert sail_names(small()) == ()
    copy = pickle.loads(pickle.dumps(table))
    assert sail_at(copy, 10 * KN, 120.0) == "Gennaker"


@given(polars(), polars())
def test_the_best_is_no_slower_than_any_of_the_sails(a: Polar, b: Polar) -> None:
    one, other = dataclasses.replace(a, name="One"), dataclasses.replace(b, name="Other")
    sails = SailSet("Yacht", (one, other))
    winds, angles = np.linspace(0.1, 30, 7)[:, np.newaxis], np.linspace(0, 180, 37)
    speed = sails.speed(winds, angles)
    set_in = sails.speeds(winds, angles)
    np.testing.assert_array_equal(speed, set_in.max(axis=0))
    best = sails.best(winds, angles)
    assert (best[speed > 0] >= 0).all()
    chosen = np.take_along_axis(set_in, np.maximum(best, 0)[np.newaxis], 0)[0]
    np.testing.assert_array_equal(chosen[best >= 0], speed[best >= 0])


@given(polars())
def test_a_single_sail_is_its_own_table(polar: Polar) -> None:
    table = SailSet("Yacht", (dataclasses.replace(polar, name="Genoa"),)).to_table()
    np.testing.assert_array_equal(table.tws, polar.tws)
    for twa, row in zip(polar.twa, polar.speed_table, strict=True):
        if np.isfinite(row).any():
            mine = table.speed_table[int(np.abs(table.twa - twa).argmin())]
            np.testing.assert_allclose(mine[np.isfinite(row)], row[np.isfinite(row)], atol=1e-9)


@pytest.mark.parametrize(
    ("sails", "sentence"), [((), "has no sails"), ((genoa(), genoa()), "two sails named")]
)
def test_what_are_no_sails_cannot_be_made(sails: tuple[Polar, ...], sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        SailSet("Bad", sails)


# ------------------------------------------------------------------------------------- tacks


def test_each_tack_has_its_own_speed_and_routing_the_mean() -> None:
    port, starboard = small(), polar_kn((6, 10), (45, 90, 150), ((4, 6), (5, 7), (3, 5)))
    yacht = TwoSided("Bent", port, starboard)
    tws = 9 * KN
    assert float(yacht.speed_on(tws, -80.0)) == float(port.speed(tws, 80.0))
    assert float(yacht.speed_on(tws, 80.0)) == float(starboard.speed(tws, 80.0))
    assert float(yacht.speed_on(tws, 280.0)) == float(port.speed(tws, 80.0))
    mean = (float(port.speed(tws, 80.0)) + float(starboard.speed(tws, 80.0))) / 2
    assert float(yacht.speed(tws, 80.0)) == pytest.approx(mean)
    assert float(yacht.speed(tws, -80.0)) == pytest.approx(mean)
    assert (
        float(yacht.speed_on(tws, 180.0))
        == float(yacht.speed_on(tws, -180.0))
        == float(yacht.speed(tws, 180.0))
    )
    slower = dataclasses.replace(yacht, slower=True)
    assert float(slower.speed(tws, 80.0)) == min(
        float(port.speed(tws, 80.0)), float(starboard.speed(tws, 80.0))
    )
