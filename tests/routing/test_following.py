"""While a hand drags: the line of an earlier passage, pulled straight for another question."""

from __future__ import annotations

from dataclasses import replace
from datetime import datetime, timedelta

import numpy as np
import pytest

from seacruise.geodesy import to_mercator
from seacruise.passage import Options, Passage, PassageRequest, plan
from seacruise.ports import Port
from seacruise.progress import Job
from seacruise.routing.field import COARSE_SLICE_S, Handling, speed_table, wind_field
from seacruise.routing.refine import Line, Waters, followed, refine, relaxed, timed
from seacruise.sea import Sea
from seacruise.sea.zones import Zone, Zones
from seacruise.settings import Settings
from seacruise.weather.sample import sample_wind
from seacruise.weather.wind import Current
from tests.routing.worlds import HOUR, T0, forecast, open_sea, sloop, steady_wind, wind_of

SEA = open_sea()
SOUTH, NORTH = Port("South", "", 55.9, 19.3), Port("North", "", 58.6, 19.9)
ROUGHLY = Options(corridor=False)


def line_of(waters: Waters, *places: tuple[float, float]) -> Line:
    x, y = to_mercator(*zip(*places, strict=True))
    return timed(waters, x, y, T0)


def points(line: Line) -> np.ndarray:
    return np.stack([line.x, line.y], axis=1)


@pytest.fixture
def waters() -> Waters:
    return Waters(SEA, wind_field(steady_wind(14.0, 100.0)), speed_table(sloop(), Handling()))


# ------------------------------------------------------------------------------------------------- lines


def test_a_line_is_followed_to_other_ends_and_pulled_straight(waters: Waters) -> None:
    near = line_of(waters, (56.0, 18.6), (56.8, 19.4), (57.6, 18.9))
    ends = line_of(waters, (56.05, 18.7), (57.6, 18.9))
    found = followed(waters, points(near), points(ends), T0)
    assert found is not None
    np.testing.assert_allclose(points(found)[[0, -1]], points(ends))
    # With the wind abeam nothing beats the straight line.
    assert found.seconds == pytest.approx(ends.seconds, rel=1e-3)


def test_a_line_that_leads_over_land_is_not_followed(baltic: Sea) -> None:
    waters = Waters(baltic, wind_field(steady_wind(14.0, 100.0)), speed_table(sloop(), Handling()))
    around = line_of(waters, (57.0, 18.0), (56.7, 18.2), (57.0, 19.2))
    ends = points(around)[[0, -1]]
    found = followed(waters, points(around), ends, T0)
    assert found is not None
    assert baltic.clear(np.hstack([points(found)[:-1], points(found)[1:]])).all()
    assert followed(waters, points(around)[[0, 0, -1]], ends, T0) is None, "straight over Gotland"


def test_a_start_that_is_blocked_goes_by_the_old_one(baltic: Sea) -> None:
    waters = Waters(baltic, wind_field(steady_wind(14.0, 100.0)), speed_table(sloop(), Handling()))
    # East of Gotland's south cape; the next waypoint is hidden by it from farther in.
    near = line_of(waters, (56.85, 18.15), (56.88, 18.05), (57.3, 17.9))
    start = line_of(waters, (57.02, 18.50), (57.3, 17.9))
    assert not baltic.clear(np.array([[*points(start)[0], *points(near)[1]]])).all()
    found = followed(waters, points(near), points(start), T0)
    assert found is not None
    assert baltic.clear(np.hstack([points(found)[:-1], points(found)[1:]])).all()


def test_a_line_into_a_closed_zone_is_not_followed(waters: Waters) -> None:
    line = line_of(waters, (56.0, 18.6), (57.6, 18.9))
    square = np.array([[18.4, 56.6], [19.2, 56.6], [19.2, 57.0], [18.4, 57.0], [18.4, 56.6]])
    closed = replace(waters, zones=Zones((Zone("Range", (square,)),)))
    assert followed(waters, points(line), points(line), T0) is not None
    assert followed(closed, points(line), points(line), T0) is None


def test_the_faster_of_both_ways_is_taken(baltic: Sea) -> None:
    waters = Waters(baltic, wind_field(steady_wind(14.0, 270.0)), speed_table(sloop(), Handling()))
    south, north = (56.4, 18.3), (58.4, 18.6)
    west = relaxed(waters, line_of(waters, south, (57.3, 17.7), north))
    east = relaxed(waters, line_of(waters, south, (57.4, 19.5), north))
    faster, slower = sorted((west, east), key=lambda line: line.seconds)
    for first, known in ((west, east), (east, west)):
        best, *_ = refine(waters, first, Job(), corridor=False, known=known)
        assert best.seconds <= faster.seconds * 1.0005 < slower.seconds


# ---------------------------------------------------------------------------------------------- passages


@pytest.fixture(scope="module")
def request_(sea_settings: Settings) -> PassageRequest:
    return PassageRequest(SOUTH, NORTH, sloop(), sample_wind(), datetime.fromisoformat("2016-11-20T06:00Z"))


@pytest.fixture(scope="module")
def begun(request_: PassageRequest, sea_settings: Settings) -> Passage:
    return plan(request_, settings=sea_settings)


@pytest.mark.parametrize("minutes", [10, 60, 240])
def test_another_departure_is_as_good_as_searched_precisely(
    request_: PassageRequest, begun: Passage, sea_settings: Settings, minutes: int
) -> None:
    assert request_.departure is not None
    later = replace(request_, departure=request_.departure + timedelta(minutes=minutes))
    precise = plan(later, settings=sea_settings)
    live = plan(replace(later, near=begun, options=ROUGHLY), settings=sea_settings)
    assert live.departure == precise.departure
    # Mostly within 0.1 %; after an hour the wind of the sample has turned so far that another line is best.
    assert live.duration_h == pytest.approx(precise.duration_h, rel=1e-3 if minutes != 60 else 1e-2)
    assert live.checks.land_free
    assert live.lower_bound_h == 0.0, "not reckoned while a hand moves"


@pytest.mark.parametrize("moved", [(0.02, 0.03), (0.15, -0.1)])
def test_another_start_is_as_good_as_searched_precisely(
    request_: PassageRequest, begun: Passage, sea_settings: Settings, moved: tuple[float, float]
) -> None:
    start = Port("There", "", SOUTH.lat + moved[0], SOUTH.lon + moved[1])
    asked = replace(request_, start=start)
    precise = plan(asked, settings=sea_settings)
    live = plan(replace(asked, near=begun, options=ROUGHLY), settings=sea_settings)
    assert (live.start.lat, live.start.lon) == (precise.start.lat, precise.start.lon)
    assert live.duration_h == pytest.approx(precise.duration_h, rel=4e-3)
    assert live.checks.land_free


def test_who_searches_precisely_follows_nobody(
    request_: PassageRequest, begun: Passage, sea_settings: Settings
) -> None:
    again = plan(replace(request_, near=begun), settings=sea_settings)
    assert again.waypoints == begun.waypoints
    assert again.lower_bound_h == begun.lower_bound_h > 0.0


def test_a_passage_that_leads_elsewhere_does_no_harm(
    request_: PassageRequest, begun: Passage, sea_settings: Settings
) -> None:
    away = replace(request_, start=Port("Away", "", 55.3, 15.8), end=Port("Far", "", 54.6, 14.6))
    rough = plan(replace(away, options=ROUGHLY), settings=sea_settings)
    live = plan(replace(away, near=begun, options=ROUGHLY), settings=sea_settings)
    assert live.checks.land_free
    assert live.duration_h <= rough.duration_h * 1.001


def test_where_turning_costs_time_boards_are_searched(
    request_: PassageRequest, begun: Passage, sea_settings: Settings
) -> None:
    dear = replace(ROUGHLY, tack_penalty_min=5.0)
    alone = plan(replace(request_, options=dear), settings=sea_settings)
    live = plan(replace(request_, options=dear, near=begun), settings=sea_settings)
    assert live.waypoints == alone.waypoints


# ------------------------------------------------------------------------------------------------- field


def test_the_later_part_of_a_field_is_that_of_a_later_begin() -> None:
    times = T0 + np.arange(12) * 3 * HOUR
    wind = wind_of(times, [56.0, 57.0, 58.0], np.linspace(4.0, 12.0, 12)[:, None, None], 40.0)
    u = np.linspace(-0.5, 0.8, 24, dtype=np.float32).reshape(12, 2, 1)
    ends = forecast(float(times[0]), float(times[-1]))
    current = Current(np.asarray(times, float), np.array([56.0, 58.0]), np.array([18.0]), u, -u, ends)
    for slice_s in (900.0, COARSE_SLICE_S):
        whole = wind_field(wind, slice_s=slice_s, current=current)
        for since in (T0, T0 + 10_000.0, T0 + 20 * HOUR + 1.0, T0 + 40 * HOUR):
            later, own = whole.later(since), wind_field(wind, slice_s=slice_s, current=current, since=since)
            assert (later.strongest, later.drift, later.horizon) == (own.strongest, own.drift, own.horizon)
            assert later.mean == pytest.approx(own.mean, rel=1e-6)
            for one, two in zip(later.arrays, own.arrays, strict=True):
                same(one, two)


def same(one: object, two: object) -> None:
    if isinstance(one, tuple) and isinstance(two, tuple):
        for a, b in zip(one, two, strict=True):
            same(a, b)
    else:
        np.testing.assert_array_equal(np.asarray(one), np.asarray(two))
