"""How far she gets: the reverse search against the forward one, and the water reached in a time."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from seacruise.geodesy import great_circle_m
from seacruise.progress import Job
from seacruise.routing import _kernels
from seacruise.routing.backwards import latest_departures
from seacruise.routing.field import COARSE_SLICE_S, Handling, speed_table, wind_field
from seacruise.routing.lattice import Lattice
from seacruise.routing.reach import Explored, Outing, explore, isochrones
from seacruise.routing.search import PIECE_M, search
from seacruise.sea import Sea
from seacruise.units import METRES_PER_NM, MS_PER_KNOT
from seacruise.weather.wind import Wind
from seacruise.yacht.polar import Polar
from tests.routing.worlds import (
    HOUR,
    T0,
    drifter,
    holds_backwards,
    open_sea,
    random_field,
    random_lattice,
    random_table,
    sloop,
    steady_wind,
    wind_of,
)

seeds = st.integers(0, 2**32 - 1)
many = hypothesis_settings(max_examples=max(300, hypothesis_settings().max_examples))

MIDDLE = (57.0, 19.5)


def leaving_from(lattice: Lattice, vertex: int) -> Lattice:
    return replace(lattice, start=vertex)


# -------------------------------------------------------------------------------- the reverse search


@many
@given(seed=seeds, hours=st.floats(0.5, 60.0))
def test_leaving_at_the_latest_arrives_and_a_second_later_does_not(seed: int, hours: float) -> None:
    """Through calms, jumps of the wind and the hold beyond the forecast."""
    rng = np.random.default_rng(seed)
    lattice, field, speeds = random_lattice(rng, 14), random_field(rng), random_table(rng)
    deadline = T0 + hours * HOUR
    latest = latest_departures(lattice, field, speeds, deadline)
    assert latest.departure[lattice.end] == deadline
    for vertex in range(lattice.vertices):
        leave = float(latest.departure[vertex])
        if vertex == lattice.end:
            continue
        homewards = leaving_from(lattice, vertex)
        if np.isfinite(leave):
            assert search(homewards, field, speeds, leave).arrival[lattice.end] <= deadline
        later = max(leave, T0 - 1000 * HOUR) + 1.0
        if vertex_differs(lattice, vertex):
            assert search(homewards, field, speeds, later).arrival[lattice.end] > deadline


def vertex_differs(lattice: Lattice, vertex: int) -> bool:
    """Tell whether a vertex is elsewhere than the end: from the same place no time is needed."""
    return (
        math.hypot(lattice.x[vertex] - lattice.x[lattice.end], lattice.y[vertex] - lattice.y[lattice.end]) > 0
    )


@many
@given(seed=seeds, hours=st.floats(-3.0, 40.0))
def test_an_edge_sailed_backwards_is_the_edge_sailed_forwards(seed: int, hours: float) -> None:
    rng = np.random.default_rng(seed)
    lattice, field, speeds = random_lattice(rng, 4), random_field(rng), random_table(rng)
    holds_backwards(lattice, field, speeds, T0 + hours * HOUR)


@many
@given(seed=seeds, hours=st.floats(0.5, 40.0), more=st.floats(0.0, 20.0))
def test_more_time_never_means_leaving_earlier(seed: int, hours: float, more: float) -> None:
    rng = np.random.default_rng(seed)
    lattice, field, speeds = random_lattice(rng, 12), random_field(rng), random_table(rng)
    first = latest_departures(lattice, field, speeds, T0 + hours * HOUR).departure
    second = latest_departures(lattice, field, speeds, T0 + (hours + more) * HOUR).departure
    assert (second >= first - 0.1).all()


@given(seed=seeds)
def test_the_way_told_is_sailed_in_the_time_told(seed: int) -> None:
    rng = np.random.default_rng(seed)
    lattice, field, speeds = random_lattice(rng, 12), random_field(rng), random_table(rng)
    deadline = T0 + 20 * HOUR
    latest = latest_departures(lattice, field, speeds, deadline)
    path = latest.path(lattice.start)
    if path.size == 0:
        assert latest.departure[lattice.start] == -np.inf
        return
    t = float(latest.departure[lattice.start])
    for a, b in pairwise(path):
        t = _kernels.edge_arrival(t, a, b, lattice.points, PIECE_M, field.arrays, speeds.arrays)
        assert t <= latest.departure[b]
    assert path[-1] == lattice.end


@given(seed=seeds, hours=st.floats(1.0, 30.0))
def test_departures_before_the_earliest_are_not_told(seed: int, hours: float) -> None:
    rng = np.random.default_rng(seed)
    lattice, field, speeds = random_lattice(rng, 12), random_field(rng), random_table(rng)
    whole = latest_departures(lattice, field, speeds, T0 + hours * HOUR).departure
    cut = latest_departures(lattice, field, speeds, T0 + hours * HOUR, earliest=T0).departure
    assert np.array_equal(cut, np.where(whole >= T0, whole, -np.inf))


def test_a_calm_before_the_deadline_must_be_over_before_it_begins() -> None:
    """Wind until noon, none until midnight: who is to be there at six in the evening is there by noon."""
    times = T0 + np.array([0.0, 6.0, 6.01, 18.0, 18.01, 30.0]) * HOUR
    speeds_ms = np.array([10.0, 10.0, 0.0, 0.0, 10.0, 10.0])[:, None, None]
    wind = wind_of(times, [57.0], speeds_ms, 180.0)
    field = wind_field(wind, slice_s=60.0)
    lattice = random_lattice(np.random.default_rng(1), 8)
    speeds = speed_table(drifter(), Handling())
    at_calm = latest_departures(lattice, field, speeds, T0 + 6.0 * HOUR).departure
    in_calm = latest_departures(lattice, field, speeds, T0 + 12.0 * HOUR).departure
    others = np.isfinite(at_calm) & (np.arange(lattice.vertices) != lattice.end)
    assert others.sum() > 3
    assert np.abs(in_calm[others] - at_calm[others]).max() < 120.0


# ----------------------------------------------------------------------------------- out and back


@pytest.fixture(scope="module")
def sea() -> Sea:
    return open_sea()


def outing(sea: Sea, wind: Wind, polar: Polar, *, hours: float = 12.0, stay: float = 0.0) -> Outing:
    field = wind_field(wind, slice_s=COARSE_SLICE_S, since=T0)
    return Outing(sea, field, speed_table(polar, Handling()), MIDDLE, T0, hours * HOUR, stay=stay * HOUR)


def around(distance_nm: float) -> list[tuple[float, float]]:
    """Give eight positions at a distance."""
    dlat = distance_nm * METRES_PER_NM / 111_195.0
    dlon = dlat / math.cos(math.radians(MIDDLE[0]))
    angles = np.radians(np.arange(0.0, 360.0, 45.0))
    return [(MIDDLE[0] + dlat * math.cos(a), MIDDLE[1] + dlon * math.sin(a)) for a in angles]


def test_at_one_speed_time_is_distance_both_ways(sea: Sea) -> None:
    """The drifter sails at the speed of the wind on every course."""
    found = explore(outing(sea, steady_wind(10.0, 200.0), drifter()), ports := around(40.0), Job())
    away = np.array([float(great_circle_m(*MIDDLE, *port)) for port in ports]) / (10.0 * MS_PER_KNOT)
    assert found.arrival - T0 == pytest.approx(away, rel=0.003)
    assert found.home - found.arrival == pytest.approx(away, rel=0.003)
    assert T0 + 12 * HOUR - found.leave_by == pytest.approx(away, rel=0.003)
    assert found.sailed_m == pytest.approx(away * 10.0 * MS_PER_KNOT, rel=0.003)


def test_out_of_reach_is_said(sea: Sea) -> None:
    found = explore(outing(sea, steady_wind(10.0, 200.0), drifter(), hours=3.0), around(40.0), Job())
    assert np.isinf(found.arrival).all()
    assert np.isinf(found.leave_by).all()
    assert np.isnan(found.home).all()


@pytest.mark.parametrize("stay", [0.0, 5.0])
def test_back_in_time_is_the_same_forwards_and_backwards(sea: Sea, stay: float) -> None:
    """Wind that veers and drops: each port is left at its own time."""
    times = T0 + np.arange(0.0, 49.0, 6.0) * HOUR
    wind = wind_of(
        times,
        [53.0, 61.0],
        (4.0 + np.arange(9.0) % 3)[:, None, None],
        (200.0 + 15.0 * np.arange(9.0))[:, None, None],
    )
    asked = outing(sea, wind, sloop(), hours=18.0, stay=stay)
    found = explore(asked, around(10.0) + around(20.0), Job())
    reached = np.isfinite(found.home)
    assert reached.sum() >= 8
    deadline = T0 + 18.0 * HOUR
    leaves = found.arrival + stay * HOUR
    assert ((found.home <= deadline) == (leaves <= found.leave_by))[reached].all()
    assert (found.home[reached] > leaves[reached]).all()
    # What was left out of the searches back was no loss.
    field, speeds = asked.field, asked.speeds
    for vertex, leave, home in zip(found.lattice.joined, leaves, found.home, strict=True):
        if np.isfinite(home):
            plain = search(leaving_from(found.lattice, vertex), field, speeds, float(leave))
            assert home == plain.arrival[found.lattice.end]


def test_a_head_wind_on_the_way_home_costs_time(sea: Sea) -> None:
    north, _, _, _, south, _, _, _ = around(40.0)
    found = explore(outing(sea, steady_wind(14.0, 0.0), sloop(), hours=40.0), [north, south], Job())
    out, back = found.arrival - T0, found.home - found.arrival
    assert out[0] == pytest.approx(back[1], rel=0.01)
    assert out[1] == pytest.approx(back[0], rel=0.01)
    assert out[0] > 1.05 * out[1]


# ----------------------------------------------------------------------------- lines of equal time


def drawn(sea: Sea, found: Explored, hours: list[float]) -> list[float]:
    """Areas [square nautical miles, true]."""
    import shapely

    areas = []
    for line in isochrones(found.lattice, sea, found.out.arrival, departure=T0, hours=hours):
        polygons = [shapely.Polygon(p[0][:, ::-1], [h[:, ::-1] for h in p[1:]]) for p in line.polygons]
        assert all(polygon.is_valid for polygon in polygons)
        squares = sum(p.area * math.cos(math.radians(p.centroid.y)) for p in polygons)
        areas.append(squares * 3600.0)
    return areas


def test_at_one_speed_the_lines_are_circles(sea: Sea) -> None:
    found = explore(outing(sea, steady_wind(10.0, 200.0), drifter()), [], Job())
    areas = drawn(sea, found, [3.0, 6.0, 12.0])
    circles = [math.pi * (10.0 * h) ** 2 * 1.0014 for h in (3.0, 6.0, 12.0)]
    assert areas == pytest.approx(circles, rel=0.02)


def test_lines_keep_to_the_water(baltic: Sea) -> None:
    import shapely

    start = baltic.snap(57.64, 18.27)
    asked = replace(outing(baltic, steady_wind(14.0, 200.0), sloop()), start=(start.lat, start.lon))
    found = explore(asked, [], Job())
    (line,) = isochrones(found.lattice, baltic, found.out.arrival, departure=T0, hours=[12.0])
    whole = shapely.MultiPolygon([(p[0][:, ::-1], [h[:, ::-1] for h in p[1:]]) for p in line.polygons])
    rng = np.random.default_rng(7)
    west, south, east, north = whole.bounds
    lon, lat = rng.uniform(west, east, 4000), rng.uniform(south, north, 4000)
    inside = shapely.contains_xy(whole, lon, lat)
    assert inside.sum() > 1000
    wet = baltic.is_water(lat, lon)
    # A corner of land smaller than a cell of the drawing may lie within a line.
    assert wet[inside].mean() > 0.985
    # And what is reached, by the vertices of the lattice, lies inside or within a cell of it.
    there = found.out.arrival <= T0 + 12 * HOUR
    near = shapely.buffer(whole, 0.05)
    assert shapely.contains_xy(near, found.lattice.lon[there], found.lattice.lat[there]).mean() > 0.98


def test_six_hours_lie_within_twelve(baltic: Sea) -> None:
    import shapely

    start = baltic.snap(57.64, 18.27)
    asked = replace(outing(baltic, steady_wind(14.0, 200.0), sloop()), start=(start.lat, start.lon))
    found = explore(asked, [], Job())
    six, twelve = (
        shapely.make_valid(
            shapely.MultiPolygon([(p[0][:, ::-1], [h[:, ::-1] for h in p[1:]]) for p in line.polygons])
        )
        for line in isochrones(found.lattice, baltic, found.out.arrival, departure=T0, hours=[6.0, 12.0])
    )
    assert six.area < twelve.area
    # But for slivers where one cell of the drawing holds both lines.
    assert shapely.difference(six, twelve).area < 1e-4 * six.area
    # The harbour itself may lie between the last point of the drawing and the quay.
    assert six.distance(shapely.Point(asked.start[1], asked.start[0])) < 0.03
