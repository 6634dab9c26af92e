"""The sphere and its Mercator plane, held against a geodesic library that shares nothing with us."""

from __future__ import annotations

import math

import numpy as np
import pytest
from geographiclib.geodesic import Geodesic
from hypothesis import assume, given
from hypothesis import strategies as st

from seacruise import geodesy
from seacruise.units import METRES_PER_NM

SPHERE = Geodesic(geodesy.EARTH_RADIUS, 0.0)
EARTH = Geodesic.WGS84

lats = st.floats(-75.0, 75.0)
lons = st.floats(-180.0, 180.0)
baltic_lats, baltic_lons = st.floats(53.0, 66.0), st.floats(9.0, 31.0)
courses = st.floats(0.0, 360.0, exclude_max=True)


@given(lats, lons)
def test_mercator_there_and_back(lat: float, lon: float) -> None:
    back = geodesy.from_mercator(*geodesy.to_mercator(lat, lon))
    assert (float(back[0]), float(back[1])) == pytest.approx((lat, lon), abs=1e-10)


@given(lats, lons, lats, lons)
def test_great_circles_are_the_librarys(lat1: float, lon1: float, lat2: float, lon2: float) -> None:
    ours = float(geodesy.great_circle_m(lat1, lon1, lat2, lon2))
    assert ours == pytest.approx(SPHERE.Inverse(lat1, lon1, lat2, lon2)["s12"], rel=1e-7, abs=1e-2)


@given(baltic_lats, baltic_lons, baltic_lats, baltic_lons)
def test_the_sphere_is_within_four_tenths_of_a_percent_of_the_earth(
    lat1: float, lon1: float, lat2: float, lon2: float
) -> None:
    true = EARTH.Inverse(lat1, lon1, lat2, lon2)["s12"]
    assume(true > 1.0)
    assert float(geodesy.great_circle_m(lat1, lon1, lat2, lon2)) == pytest.approx(true, rel=4e-3)


@given(lats, st.floats(-60, 60), courses, st.floats(1.0, 400.0))
def test_a_rhumb_line_crosses_every_meridian_at_its_course(
    lat: float, lon: float, course: float, miles: float
) -> None:
    """Sail it in hundred short great circles, each begun on the course at its middle."""
    length = miles * METRES_PER_NM
    end_lat, end_lon = (float(c) for c in geodesy.destination(lat, lon, course, length))
    assume(abs(end_lat) < 80.0)
    here_lat, here_lon, pieces = lat, lon, 100
    for _ in range(pieces):
        first = SPHERE.Direct(here_lat, here_lon, course, length / pieces / 2)
        turn = course - first["azi2"]
        half = SPHERE.Direct(here_lat, here_lon, course + turn, length / pieces)
        here_lat, here_lon = half["lat2"], half["lon2"]
    off = SPHERE.Inverse(here_lat, here_lon, end_lat, end_lon)["s12"]
    assert off < 2e-5 * length + 1e-3


@given(lats, st.floats(-80, 80), courses, st.floats(0.01, 400.0))
def test_destination_course_and_distance_agree(lat: float, lon: float, course: float, miles: float) -> None:
    length = miles * METRES_PER_NM
    there = tuple(float(c) for c in geodesy.destination(lat, lon, course, length))
    assume(abs(there[0]) < 80.0)
    found = float(geodesy.rhumb_course_deg(lat, lon, *there))
    assert abs((found - course + 180.0) % 360.0 - 180.0) < 1e-4
    assert float(geodesy.rhumb_distance_m(lat, lon, *there)) == pytest.approx(length, rel=1e-6, abs=1e-3)


@pytest.mark.parametrize("course", [90.0, 270.0, 89.9999, 90.0001])
@pytest.mark.parametrize("lat", [0.0, 57.0, -33.0])
def test_east_and_west_are_no_special_case(course: float, lat: float) -> None:
    length = 60 * METRES_PER_NM
    there = geodesy.destination(lat, 20.0, course, length)
    assert float(there[0]) == pytest.approx(lat, abs=1e-4)
    miles_per_degree = 60.0404 * math.cos(math.radians(lat))
    assert abs(float(there[1]) - 20.0) == pytest.approx(60.0 / miles_per_degree, rel=1e-4)
    assert float(geodesy.rhumb_distance_m(lat, 20.0, *there)) == pytest.approx(length, rel=1e-6)


def test_a_rhumb_line_is_never_shorter_than_the_great_circle() -> None:
    rng = np.random.default_rng(1)
    lat1, lat2 = rng.uniform(40, 70, (2, 500))
    lon1, lon2 = rng.uniform(0, 40, (2, 500))
    rhumb = geodesy.rhumb_distance_m(lat1, lon1, lat2, lon2)
    great = geodesy.great_circle_m(lat1, lon1, lat2, lon2)
    assert (rhumb >= great * (1 - 1e-9)).all()
    assert (rhumb <= great * 1.05).all()


def test_scale_is_the_true_length_of_a_metre_of_the_plane() -> None:
    lat, lon = 57.0, 18.0
    x, y = geodesy.to_mercator(lat, lon)
    for dx, dy in ((100.0, 0.0), (0.0, 100.0), (70.0, -70.0)):
        there = geodesy.from_mercator(x + dx, y + dy)
        true = SPHERE.Inverse(lat, lon, float(there[0]), float(there[1]))["s12"]
        assert true / math.hypot(dx, dy) == pytest.approx(float(geodesy.scale(lat)), rel=1e-4)


@pytest.mark.parametrize(
    ("a", "b", "between"),
    [
        (90, 120, 30),
        (180, 150, 30),
        (270, 90, 180),
        (350, 10, 20),
        (10, 350, 20),
        (0, 360, 0),
        (-90, 90, 180),
    ],
)
def test_angles_are_folded_as_r1_does(a: float, b: float, between: float) -> None:
    assert float(geodesy.angle_between_deg(a, b)) == pytest.approx(between)


@pytest.mark.parametrize(
    ("lat", "lon", "text"),
    [
        (54.516, 18.553, "54°31.0'N 018°33.2'E"),
        (-0.5, -179.999, "00°30.0'S 179°59.9'W"),
        (59.99999, 9.99999, "60°00.0'N 010°00.0'E"),
        (0.0, 0.0, "00°00.0'N 000°00.0'E"),
    ],
)
def test_positions_are_written_as_sailors_read_them(lat: float, lon: float, text: str) -> None:
    assert geodesy.format_position(lat, lon) == text


def test_whole_arrays_at_once() -> None:
    lat, lon = np.linspace(50, 60, 7), np.linspace(10, 20, 7)
    assert geodesy.great_circle_m(lat, lon, 57.0, 18.0).shape == (7,)
    assert geodesy.rhumb_course_deg(lat[:, None], lon[:, None], lat, lon).shape == (7, 7)
    assert geodesy.destination(lat, lon, 45.0, 1000.0)[0].shape == (7,)
