"""Members of an ensemble: their passages counted by sides of islands, and their hours by quantiles."""

from __future__ import annotations

from dataclasses import replace
from datetime import timedelta

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.alternatives import splits
from seacruise.members import Bundle, Member, bundle_of, hours_along, winds_of
from seacruise.passage import Options, Passage, PassageRequest, plan
from seacruise.ports import Port
from seacruise.resources import resource_path
from seacruise.settings import Settings
from seacruise.study import spread_of
from seacruise.weather.wind import Current
from seacruise.yacht.fleet import find_yacht, load_fleet
from tests.passages import hand_made_passage, veering_wind
from tests.routing.worlds import DEPARTURE, cache_dir_of, steady_wind

EAST_OF_GOTLAND_DEG = 1.9


def shifted(degrees: float, hours: float = 0.0) -> Passage:
    """Make the passage of the hand farther east, of so many hours more."""
    passage = hand_made_passage()
    track = replace(passage.track, lon=passage.track.lon + degrees)
    return replace(passage, track=track, arrival=passage.arrival + timedelta(hours=hours))


def bundle(*members: tuple[float, float] | None) -> Bundle:
    """Make a bundle of members shifted by degrees, that many hours longer; ``None`` has no passage."""
    found = [
        Member(number, None if one is None else shifted(*one), None if one is None else 40.0 + one[1])
        for number, one in enumerate(members)
    ]
    return bundle_of(hand_made_passage(), len(found), found[::-1])


# --- which side --------------------------------------------------------------------------------------------


def test_who_goes_by_the_other_side_is_counted() -> None:
    tracks = [shifted(shift).track for shift in (0.0, 0.05, EAST_OF_GOTLAND_DEG, 0.1)]
    (split,) = splits(hand_made_passage(), tracks)
    assert (split.island, split.planned) == ("Gotland", "west")
    assert [(one.side, one.count) for one in split.passing] == [("west", 3), ("east", 1)]
    west, east = split.passing
    assert west.lon < 18.5 < east.lon, "abeam of the island, on its side"
    assert 56.5 < west.lat < 58.5


def test_where_all_go_as_planned_nothing_is_told() -> None:
    assert splits(hand_made_passage(), [shifted(0.05).track] * 3) == ()
    assert splits(hand_made_passage(), []) == ()


def test_where_all_go_another_way_than_planned_it_is_told() -> None:
    (split,) = splits(hand_made_passage(), [shifted(EAST_OF_GOTLAND_DEG).track] * 3)
    assert split.planned == "west"
    assert [(one.side, one.count) for one in split.passing] == [("east", 3)]


@given(st.lists(st.sampled_from([0.0, 0.1, EAST_OF_GOTLAND_DEG, 2.1]), max_size=8))
def test_counts_add_up_and_most_come_first(shifts: list[float]) -> None:
    for split in splits(hand_made_passage(), [shifted(shift).track for shift in shifts]):
        counts = [one.count for one in split.passing]
        assert sum(counts) == len(shifts), "each of these passes each island on one side"
        assert counts == sorted(counts, reverse=True)
        assert all(counts)
        assert len({one.side for one in split.passing}) == len(counts)
        east = sum(shift > 1.0 for shift in shifts)
        assert dict(zip((one.side for one in split.passing), counts, strict=True)).get("east", 0) == east


# --- how long ----------------------------------------------------------------------------------------------


@given(st.lists(st.one_of(st.none(), st.floats(1.0, 400.0)), min_size=1, max_size=51))
def test_quantiles_lie_between_the_fastest_and_the_slowest_in_their_order(hours: list[float | None]) -> None:
    spread = spread_of(hours)
    told = [value for value in (spread.low, spread.middle, spread.high) if value is not None]
    arrived = [value for value in hours if value is not None]
    assert told == sorted(told)
    for value in told:
        assert min(arrived) - 1e-9 <= value <= max(arrived) + 1e-9
    if spread.high is None:
        assert None in hours
    if spread.low is None:
        assert spread.middle is None
        assert spread.high is None


def test_a_bundle_tells_both_spreads_and_who_has_no_passage() -> None:
    found = bundle((0.0, 0.0), (0.05, 4.0), (EAST_OF_GOTLAND_DEG, 8.0), None)
    assert [member.number for member in found.members] == [0, 1, 2, 3]
    assert found.is_complete
    assert len(found.passages) == 3
    shortest = hand_made_passage().duration_h
    assert found.duration_h.low == pytest.approx(shortest + 1.2)
    assert found.duration_h.middle == pytest.approx(shortest + 6.0)
    assert found.duration_h.high is None, "one of four never arrives"
    assert found.kept_h.middle == pytest.approx(46.0)
    assert [one.count for one in found.splits[0].passing] == [2, 1]
    assert not bundle_of(hand_made_passage(), 5, found.members).is_complete


# --- their winds -------------------------------------------------------------------------------------------


def test_members_have_the_current_of_the_whole_and_fade_to_their_mean() -> None:
    wind = veering_wind()
    slack = np.zeros_like(wind.u)
    current = Current(wind.time, wind.lat, wind.lon, slack, slack, wind.forecast)
    other = replace(wind, u=wind.u + 4.0)
    whole = replace(wind, members=(wind, other), current=current)
    one, two = winds_of(whole, "hold")
    assert one.current is current
    assert np.array_equal(two.u, other.u)
    assert winds_of(wind, "hold") == ()
    one, two = winds_of(whole, "fade")
    assert np.array_equal(one.u[-1], two.u[-1]), "faded, they are one wind"
    assert one.time[-1] > wind.time[-1]


def test_the_planned_line_takes_what_it_was_planned_to_in_its_own_wind(
    tmp_path_factory: pytest.TempPathFactory,
) -> None:
    base = tmp_path_factory.getbasetemp()
    folders = Settings(cache_dir=cache_dir_of(base), data_dir=base / "data")
    yacht = find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")]))
    start, end = Port("South", "", 55.9, 19.3), Port("North", "", 56.9, 19.3)
    wind = steady_wind(14.0, 100.0)
    request = PassageRequest(start, end, yacht, wind, DEPARTURE, Options(spacing_nm=3.0))
    planned = plan(request, settings=folders)
    assert hours_along(request, planned, settings=folders) == pytest.approx(planned.duration_h, rel=1e-3)
    slower = replace(request, wind=steady_wind(8.0, 100.0))
    kept_h = hours_along(slower, planned, settings=folders)
    assert kept_h is not None
    assert kept_h > planned.duration_h
    becalmed = replace(request, wind=steady_wind(0.0, 100.0))
    assert hours_along(becalmed, planned, settings=folders) is None
