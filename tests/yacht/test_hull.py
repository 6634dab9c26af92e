"""The tacking hull against an independent one, and the headings that make it good."""

from __future__ import annotations

import warnings
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

from seacruise.resources import resource_path
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.files import read_polar
from seacruise.yacht.hull import hull_headings, hull_speed
from seacruise.yacht.polar import Polar
from seacruise.yacht.sails import SailSet, sail_at
from seacruise.yacht.targets import targets
from tests.yacht.polars import polar_kn, polars, small

Array = NDArray[np.float64]
KN = MS_PER_KNOT
COURSES = np.arange(181.0)


def qhull_radius(polar: Polar, tws: float) -> Array:
    """Radius of the hull in all courses, by Qhull from a slice sampled five times as finely."""
    angles = np.radians(polar.sample_angles(0.1))
    speed = polar.speed(tws, np.degrees(angles))
    right = np.column_stack((speed * np.sin(angles), speed * np.cos(angles)))
    hull = ConvexHull(np.vstack((right, right * (-1.0, 1.0))))
    course = np.radians(COURSES)
    outward = np.column_stack((np.sin(course), np.cos(course))) @ hull.equations[:, :2].T
    with np.errstate(divide="ignore", invalid="ignore"):
        reach = np.where(outward > 1e-12, -hull.equations[:, 2] / outward, np.inf)
    return np.asarray(reach.min(axis=1))


@pytest.mark.parametrize(
    "yacht", ["edel-660", "bavaria-46-cruiser", "bavaria-c50-no-spinnaker", "cookson-50"]
)
@pytest.mark.parametrize("tws_kn", [3.0, 7.0, 12.0, 17.3, 22.0])
def test_the_hull_is_qhulls(yacht: str, tws_kn: float) -> None:
    polar = read_polar(resource_path("polars") / f"{yacht}.csv")
    speed = hull_speed(polar, np.array([tws_kn * KN]), COURSES)[0]
    np.testing.assert_allclose(speed, qhull_radius(polar, tws_kn * KN), rtol=2e-4)


@given(polars(), st.floats(0.5, 35.0))
def test_nothing_made_good_is_slower_than_direct(polar: Polar, tws: float) -> None:
    direct = polar.speed(tws, COURSES)
    assert (hull_speed(polar, np.array([tws]), COURSES)[0] >= direct).all()


@given(polars(), st.floats(0.5, 35.0))
def test_the_headings_make_good_the_course_at_the_speed_of_the_hull(polar: Polar, tws: float) -> None:
    twa1, share1, twa2, share2 = hull_headings(polar, tws, COURSES)
    assert ((share1 >= 0.0) & (share1 <= 1.0)).all()
    np.testing.assert_allclose(share1 + share2, 1.0)
    east, north = (
        share1 * polar.speed(tws, twa1) * f(np.radians(twa1))
        + share2 * polar.speed(tws, twa2) * f(np.radians(twa2))
        for f in (np.sin, np.cos)
    )
    speed = hull_speed(polar, np.array([tws]), COURSES)[0]
    np.testing.assert_allclose(east, speed * np.sin(np.radians(COURSES)), atol=1e-7)
    np.testing.assert_allclose(north, speed * np.cos(np.radians(COURSES)), atol=1e-7)


def test_a_convex_slice_is_its_own_hull() -> None:
    # A circle through the origin's lee: v = 5 + 2 sin, convex and best VMG at its ends.
    angles = np.arange(0.0, 180.1, 2.5)
    circle = 5.0 / np.ones_like(angles)
    polar = polar_kn((6, 12), angles, np.column_stack((circle, circle * 1.5)))
    winds = np.array([8.0, 12.0]) * KN
    np.testing.assert_allclose(
        hull_speed(polar, winds, COURSES), polar.speed(winds[:, np.newaxis], COURSES), rtol=1e-9
    )
    twa1, share1, _, _ = hull_headings(polar, winds[0], COURSES)
    np.testing.assert_array_equal(share1, 1.0)
    np.testing.assert_array_equal(twa1, COURSES)


def test_a_beat_is_two_boards_at_the_beat_angle() -> None:
    polar = small()
    twa, vmg = polar.best_vmg(10 * KN, True)
    twa1, share1, twa2, share2 = hull_headings(polar, 10 * KN, 0.0)
    assert (float(twa1), float(twa2)) == (float(twa), -float(twa))
    assert float(share1) == float(share2) == pytest.approx(0.5)
    assert hull_speed(polar, np.array([10 * KN]), np.array([0.0]))[0, 0] == pytest.approx(
        float(vmg), rel=1e-9
    )


def test_courses_on_port_tack_mirror_those_on_starboard() -> None:
    polar, courses = small(), np.array([10.0, 90.0, 170.0])
    starboard, port = hull_headings(polar, 8 * KN, courses), hull_headings(polar, 8 * KN, -courses)
    np.testing.assert_allclose(port[0], -starboard[0])
    np.testing.assert_allclose(port[2], -starboard[2])
    np.testing.assert_allclose(port[1], starboard[1])


def test_dead_before_the_wind_is_180_not_minus_180() -> None:
    twa1, _, _, _ = hull_headings(small(), 8 * KN, np.array([180.0, -180.0]))
    assert (twa1 > 0.0).all()


def test_across_a_dent_she_mixes_a_higher_and_a_lower_course() -> None:
    polar = polar_kn((6, 12), (45, 80, 100, 120, 150), ((5, 6), (7, 8), (4, 5), (7, 8), (5, 6)))
    twa1, share1, twa2, _ = hull_headings(polar, 8 * KN, 100.0)
    assert 60.0 < float(twa1) < 100.0 < float(twa2) < 140.0
    assert 0.0 < float(share1) < 1.0


def test_a_calm_makes_nothing_good() -> None:
    assert (hull_speed(small(), np.array([0.0]), COURSES) == 0.0).all()
    assert float(hull_headings(small(), 0.0, 30.0)[1]) == 1.0


@given(polars(), st.floats(0.2, 3.0))
def test_the_hull_grows_with_the_polar(polar: Polar, k: float) -> None:
    scaled = Polar("Scaled", polar.tws, polar.twa, polar.speed_table * k)
    winds = np.array([3.0, 9.0])
    np.testing.assert_allclose(
        hull_speed(scaled, winds, COURSES), k * hull_speed(polar, winds, COURSES), rtol=1e-6, atol=1e-9
    )


def test_best_vmg_is_sampled_finely_enough() -> None:
    polar = read_polar(resource_path("polars") / "bavaria-46-cruiser.csv")
    winds = np.arange(1.0, 20.0, 0.7)
    made_good = hull_speed(polar, winds, np.array([0.0, 180.0]))
    fine = np.arange(0.0, 180.001, 0.01)
    vmg = polar.speed(winds[:, np.newaxis], fine) * np.cos(np.radians(fine))
    np.testing.assert_allclose(made_good[:, 0], vmg.max(axis=1), rtol=5e-4)
    np.testing.assert_allclose(made_good[:, 1], -vmg.min(axis=1), rtol=5e-4)


YACHTS = ("edel-660", "bavaria-46-cruiser", "cookson-50", "bavaria-c50")


def hrosailings_speed(polar: Polar, diagram: Any, tws_kn: float, course: float) -> float | None:
    """Speed made good by the headings of hrosailing; ``None`` where its shares are no shares."""
    split = import_module("hrosailing.cruising").convex_direction(diagram, tws_kn, course)
    if any(not -1e-9 <= part.proportion <= 1.0 + 1e-9 for part in split):
        return None
    headings = [(part.angle, part.proportion) for part in split] if len(split) > 1 else [(course, 1.0)]
    return sum(
        share * float(polar.speed(tws_kn * KN, twa)) * float(np.cos(np.radians(twa - course)))
        for twa, share in headings
    )


@pytest.mark.parametrize("yacht", YACHTS)
def test_the_hull_is_hrosailings(yacht: str) -> None:
    """Within 1 %, where its shares are shares: on a course that is one of its vertices they can be -0.03."""
    pytest.importorskip("hrosailing", reason="hrosailing is not installed (extra bench)")
    polar = read_polar(resource_path("polars") / f"{yacht}.csv")
    winds, angles = np.array([6.0, 10.0, 14.0, 20.0]), np.arange(0.0, 360.0, 2.0)
    compared = 0
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        diagram = import_module("hrosailing.polardiagram").PolarDiagramTable(
            ws_resolution=winds, wa_resolution=angles, bsps=polar.speed(winds * KN, angles[:, None]) / KN
        )
        for tws_kn in winds.tolist():
            ours = hull_speed(polar, tws_kn * KN, np.arange(0.0, 181.0, 15.0))[0]
            for course, speed in zip(np.arange(0.0, 181.0, 15.0), ours, strict=True):
                theirs = hrosailings_speed(polar, diagram, tws_kn, float(course))
                if theirs is not None:
                    compared += 1
                    assert theirs == pytest.approx(float(speed), rel=0.01), (tws_kn, course)
    assert compared >= 45


@given(polars(), st.floats(0.5, 35.0))
def test_the_hull_is_convex(polar: Polar, tws: float) -> None:
    """No chord between two courses reaches beyond it, over both tacks."""
    courses = np.arange(-180.0, 180.0, 5.0)
    speed = hull_speed(polar, tws, courses)[0]
    places = speed * np.exp(1j * np.radians(courses))
    chords = (places[:, np.newaxis] + places) / 2.0
    reach = hull_speed(polar, tws, np.degrees(np.angle(chords)).ravel())[0].reshape(chords.shape)
    # The hull is made of samples half a degree apart: its rounding is 0.004 % of the radius.
    assert (np.abs(chords) <= reach * (1.0 + 2e-4) + 1e-9).all()


def test_headings_may_need_two_sails() -> None:
    jib = polar_kn((6, 12), (45, 70, 100), ((5, 6), (7, 8), (5, 6)), name="Jib")
    spinnaker = polar_kn((6, 12), (100, 120, 150), ((5.5, 6.5), (7.5, 8.5), (5, 6)), name="Spinnaker")
    polar = SailSet("Yacht", (jib, spinnaker)).to_table()
    tws = 12 * KN
    twa1, share1, twa2, share2 = (float(v) for v in hull_headings(polar, tws, 95.0))
    assert sail_at(polar, tws, twa1) == "Jib"
    assert sail_at(polar, tws, twa2) == "Spinnaker"
    assert 0.0 < share1 < 1.0
    assert share1 + share2 == pytest.approx(1.0)
    assert hull_speed(polar, tws, 95.0)[0, 0] > float(polar.speed(tws, 95.0)) * 1.05


def test_targets_are_the_best_beat_and_run() -> None:
    polar = small()
    (target,) = targets(polar, [10.0])
    assert target.tws_kn == 10.0
    assert target.beat.twa == 42.0
    assert target.beat.boat_speed_kn == pytest.approx(6.2)
    assert target.beat.vmg_kn == pytest.approx(6.2 * np.cos(np.radians(42.0)))
    # 10 kn at 42 degrees and 6.2 kn of her own: 10 cos 42 + 6.2 ahead, 10 sin 42 abeam.
    ahead, abeam = 10 * np.cos(np.radians(42.0)) + 6.2, 10 * np.sin(np.radians(42.0))
    assert target.beat.aws_kn == pytest.approx(np.hypot(ahead, abeam))
    assert target.beat.awa == pytest.approx(np.degrees(np.arctan2(abeam, ahead)))
    assert target.beat.sail is None
    assert target.run.twa > 90.0
    assert target.run.vmg_kn == pytest.approx(float(hull_speed(polar, 10 * KN, 180.0)[0, 0]) / KN, rel=1e-6)
