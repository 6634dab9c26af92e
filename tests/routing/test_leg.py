"""One leg: its time, its cost and the point reached, against closed forms and other integrators."""

from __future__ import annotations

import numpy as np
import pytest
from geographiclib.geodesic import Geodesic
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from seacruise.errors import InputError
from seacruise.geodesy import angle_between_deg, destination, rhumb_course_deg, rhumb_distance_m
from seacruise.routing.field import Handling
from seacruise.routing.leg import (
    Conditions,
    Marks,
    conditions,
    isochrone_point,
    leg_cost,
    leg_marks,
    leg_time,
)
from seacruise.units import METRES_PER_NM, MS_PER_KNOT
from seacruise.weather.wind import Wind
from seacruise.yacht.hull import hull_speed
from seacruise.yacht.polar import Polar
from tests.routing.worlds import HOUR, T0, drifter, sloop, steady_wind, wind_of

A, B = (55.0, 17.0), (57.5, 20.5)
KN = MS_PER_KNOT


@pytest.fixture(scope="module")
def steady() -> Conditions:
    """Ten knots for the drifter, who makes ten knots of them."""
    return conditions(steady_wind(10.0, 250.0), drifter())


def changing_wind() -> Wind:
    """A wind that freshens, eases and veers with time and latitude, without a calm."""
    time = T0 + np.arange(-6, 121) * HOUR
    lat = np.arange(53.0, 61.0, 0.5)
    t, y = np.meshgrid(np.arange(time.size), lat, indexing="ij")
    speed = 7.0 + 3.0 * np.sin(t / 7.0) + 0.8 * (y - 57.0)
    return wind_of(time, lat, speed[..., None], (240.0 + 40.0 * np.sin(t / 11.0))[..., None])


@pytest.fixture(scope="module")
def changing() -> Conditions:
    return conditions(changing_wind(), sloop())


def integrated(wind: Wind, polar: Polar, start: tuple[float, float], end: tuple[float, float]) -> float:
    """Seconds of dt/ds = 1 / v(s, t), by SciPy and the hull of the polar itself."""
    course = float(rhumb_course_deg(*start, *end))
    length = float(rhumb_distance_m(*start, *end))

    def slowness(s: float, t: np.typing.NDArray[np.float64]) -> list[float]:
        lat, lon = destination(start[0], start[1], course, s)
        u, v = wind.at(T0 + t[0], lat, lon)
        twa = np.degrees(np.arctan2(-u, -v)) - course
        return [1.0 / float(hull_speed(polar, np.hypot(u, v), twa)[0, 0])]

    found = solve_ivp(slowness, (0.0, length), [0.0], rtol=1e-6, max_step=length / 100)
    return float(found.y[0, -1])


def test_a_steady_wind_is_distance_over_speed(steady: Conditions) -> None:
    seconds = leg_time(A, B, T0, steady)
    assert seconds == pytest.approx(float(rhumb_distance_m(*A, *B)) / (10 * KN), rel=2e-4)
    assert leg_time(A, A, T0, steady) == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("ends", [(A, B), (B, A), ((56.0, 16.0), (56.0, 21.0)), ((54.0, 18.0), (60.0, 18.0))])
def test_a_changing_wind_against_another_integrator(
    changing: Conditions, ends: tuple[tuple[float, float], tuple[float, float]]
) -> None:
    assert leg_time(*ends, T0, changing) == pytest.approx(integrated(changing.wind, sloop(), *ends), rel=2e-3)


def test_costs_that_are_known(changing: Conditions) -> None:
    seconds, metres = leg_time(A, B, T0, changing), float(rhumb_distance_m(*A, *B))
    assert leg_cost(A, B, T0, changing) == seconds
    assert leg_cost(A, B, T0, changing, absolute=lambda t, s: t + s) == pytest.approx(seconds + metres)
    assert leg_cost(A, B, T0, changing, density=lambda _: 1.0) == pytest.approx(metres, rel=1e-6)
    per_second = leg_cost(A, B, T0, changing, density=lambda at: 1.0 / at.speed)
    assert per_second == pytest.approx(seconds, rel=2e-3)
    both = leg_cost(A, B, T0, changing, density=lambda _: 2.0, absolute=lambda t, _s: 3.0 * t)
    assert both == pytest.approx(2.0 * metres + 3.0 * seconds, rel=1e-3)


def test_a_density_sees_what_is_met(changing: Conditions) -> None:
    seen: list[Marks] = []

    def rough(at: Marks) -> np.typing.NDArray[np.float64]:
        seen.append(at)
        return (at.tws > 8.0).astype(np.float64)

    rough_m = leg_cost(A, B, T0, changing, density=rough)
    marks = seen[0]
    u, v = changing.wind.at(marks.time, marks.lat, marks.lon)
    assert marks.tws == pytest.approx(np.hypot(u, v))
    # Counted finely and on its own: how much of the way is above the limit.
    fine = np.linspace(0.0, marks.distance[-1], 20_001)
    strength = np.interp(fine, marks.distance, marks.tws)
    assert rough_m == pytest.approx(float((strength > 8.0).mean()) * marks.distance[-1], rel=0.01)
    assert np.diff(marks.distance).max() <= 0.6 * METRES_PER_NM
    assert marks.course_deg == pytest.approx(float(rhumb_course_deg(*A, *B)))
    assert (np.diff(marks.time) > 0.0).all()


def test_a_density_of_another_number_is_refused(steady: Conditions) -> None:
    with pytest.raises(InputError, match=r"it must give one each"):
        leg_cost(A, B, T0, steady, density=lambda _: np.ones(3))


def test_a_leg_that_cannot_be_sailed_costs_without_end() -> None:
    becalmed = conditions(steady_wind(0.0, 0.0), sloop())
    assert leg_time(A, B, T0, becalmed) == np.inf
    assert leg_cost(A, B, T0, becalmed, absolute=lambda t, s: s) == np.inf
    assert leg_cost(A, B, T0, becalmed, density=lambda _: 1.0) == np.inf
    assert leg_marks(A, B, T0, becalmed).speed.tolist()[:2] == [0.0, 0.0]


@settings(max_examples=40)
@given(st.floats(0.0, 359.9), st.floats(0.02, 30.0))
def test_the_point_reached_is_the_inverse_of_the_time(
    changing: Conditions, course: float, hours: float
) -> None:
    point = isochrone_point(A, course, hours * HOUR, T0, changing)
    assert leg_time(A, (point.lat, point.lon), T0, changing) == pytest.approx(hours * HOUR, rel=1e-3, abs=2.0)
    assert float(angle_between_deg(rhumb_course_deg(*A, point.lat, point.lon), course)) < 0.01
    assert point.distance == pytest.approx(float(rhumb_distance_m(*A, point.lat, point.lon)), rel=1e-9)


def test_further_with_every_hour(changing: Conditions) -> None:
    distances = [isochrone_point(A, 40.0, h * HOUR, T0, changing).distance for h in np.arange(0.0, 24.0, 0.5)]
    assert distances[0] == 0.0
    assert (np.diff(distances) > 0.0).all()


def test_she_stops_where_she_is_stopped() -> None:
    time = T0 + np.array([-6.0, 3.0, 4.0, 12.0]) * HOUR
    dying = wind_of(time, [57.0], np.array([5.0, 5.0, 0.0, 0.0])[:, None, None], 250.0)
    given_up = conditions(dying, drifter())
    day, week = (isochrone_point(A, 90.0, days * 24 * HOUR, T0, given_up).distance for days in (1, 7))
    assert day == pytest.approx(5.0 * 3.5 * HOUR, rel=0.01)
    assert week == pytest.approx(day, rel=1e-3)
    lat = np.arange(54.0, 60.0, 0.25)
    rising = wind_of([T0, T0 + 240 * HOUR], lat, (4.0 * (lat - 53.0))[None, :, None], 250.0)
    limited = conditions(rising, drifter(), Handling(max_wind=12.0))
    north = isochrone_point((54.5, 18.0), 0.0, 48 * HOUR, T0, limited)
    assert north.lat == pytest.approx(56.0, abs=0.1)


def test_the_pole_is_the_end(steady: Conditions) -> None:
    assert isochrone_point((80.0, 0.0), 0.0, 900 * HOUR, T0, steady).lat <= 85.0


@pytest.mark.parametrize(("course", "seconds"), [(np.nan, 10.0), (10.0, -1.0), (10.0, np.inf)])
def test_nonsense_is_refused(steady: Conditions, course: float, seconds: float) -> None:
    with pytest.raises(InputError, match="cannot be sailed"):
        isochrone_point(A, course, seconds, T0, steady)


@pytest.mark.parametrize("course", [0.0, 33.0, 90.0, 155.0, 270.0])
def test_geodesy_against_the_ellipsoid(steady: Conditions, course: float) -> None:
    """A rhumb line of WGS 84 in steps of 200 m, by geographiclib, ends within 0.5 % of the distance."""
    seconds = 12 * HOUR
    point = isochrone_point(A, course, seconds, T0, steady)
    lat, lon = A
    length, step = 10 * KN * seconds, 200.0
    for _ in range(int(length / step)):
        end = Geodesic.WGS84.Direct(lat, lon, course, step)
        lat, lon = end["lat2"], end["lon2"]
    off = Geodesic.WGS84.Inverse(lat, lon, point.lat, point.lon)["s12"]
    assert off < 0.005 * length
