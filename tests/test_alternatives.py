"""Ways on the other side of an island: real ones, each planned and sailed as a passage is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import shapely

from seacruise.alternatives import ISLANDS, SLOWEST, Island, OtherWay, other_ways
from seacruise.errors import CancelledError, NoPassageError
from seacruise.geodesy import great_circle_m
from seacruise.passage import Options, Passage, PassageRequest, plan
from seacruise.ports import Port
from seacruise.progress import Job
from seacruise.resources import resource_path
from seacruise.sea.coast import chart_land
from seacruise.sea.zones import Zone, Zones
from seacruise.settings import Settings
from seacruise.yacht.fleet import find_yacht, load_fleet
from tests.routing.worlds import DEPARTURE, cache_dir_of, steady_wind

SOUTH, NORTH = Port("South", "", 56.2, 18.3), Port("North", "", 58.6, 18.6)
GOTLAND = Island("Gotland", 57.40, 18.50)
Found = tuple[PassageRequest, Passage, tuple[OtherWay, ...]]


@pytest.fixture(scope="module")
def folders(tmp_path_factory: pytest.TempPathFactory) -> Settings:
    base = tmp_path_factory.getbasetemp()
    return Settings(cache_dir=cache_dir_of(base), data_dir=base / "data")


@cache
def request_from_south_to_north() -> PassageRequest:
    yacht = find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")]))
    return PassageRequest(
        SOUTH, NORTH, yacht, steady_wind(14.0, 250.0), DEPARTURE, Options(spacing_nm=4.0, refine=False)
    )


def sailor(request: PassageRequest, folders: Settings) -> Callable[[Zone], Passage]:
    return lambda barrier: plan(replace(request, zones=Zones((barrier,))), settings=folders)


@pytest.fixture(scope="module")
def found(folders: Settings) -> Found:
    request = request_from_south_to_north()
    passage = plan(request, settings=folders)
    return request, passage, other_ways(passage, sailor(request, folders), job=Job(), islands=(GOTLAND,))


def sides_of(passage: Passage) -> set[str]:
    """Sides of Gotland on which a track is, where it is abeam of its middle."""
    abeam = np.abs(passage.track.lat - GOTLAND.lat) < 0.2
    return {"west" if lon < GOTLAND.lon else "east" for lon in passage.track.lon[abeam].tolist()}


def test_the_other_way_is_on_the_other_side(found: Found) -> None:
    _, passage, ways = found
    assert len(ways) == 1
    way = ways[0]
    assert {way.side} == sides_of(way.passage)
    assert sides_of(way.passage).isdisjoint(sides_of(passage))
    assert way.island == "Gotland"


def test_it_is_a_passage_like_any_other_and_never_faster(found: Found) -> None:
    _, passage, ways = found
    for way in ways:
        checks = way.passage.checks
        assert checks.land_free
        assert checks.zones_free
        assert checks.within_limits
        assert passage.duration_h <= way.passage.duration_h * 1.0005 <= SLOWEST * passage.duration_h


def test_by_way_of_its_place_she_gets_it(found: Found, folders: Settings) -> None:
    request, _, ways = found
    way = ways[0]
    via = Port("via", "", way.lat, way.lon)
    first = plan(replace(request, end=via), settings=folders)
    place = replace(via, lat=first.end.lat, lon=first.end.lon)
    second = plan(replace(request, start=place, departure=first.arrival), settings=folders)
    assert first.duration_h + second.duration_h == pytest.approx(way.passage.duration_h, rel=0.02)
    track = way.passage.track
    near = great_circle_m(track.lat, track.lon, way.lat, way.lon).min()
    assert float(near) < 1000.0


def test_the_barrier_closes_the_side_that_was_sailed_and_no_other(found: Found) -> None:
    """Whatever is asked of the planner is one zone, from inside the island across the way found."""
    _, passage, ways = found
    asked: list[Zone] = []

    def sail(barrier: Zone) -> Passage:
        asked.append(barrier)
        return ways[0].passage

    other_ways(passage, sail, job=Job(), islands=(GOTLAND,))
    polygon = shapely.Polygon(asked[0].rings[0])
    assert len(asked) == 1
    assert polygon.distance(shapely.Point(GOTLAND.lon, GOTLAND.lat)) < 0.01
    assert polygon.intersects(line_of(passage))
    assert not polygon.intersects(line_of(ways[0].passage))


def line_of(passage: Passage) -> shapely.LineString:
    return shapely.LineString(np.stack([passage.track.lon, passage.track.lat], axis=1))


def test_the_same_side_twice_is_told_once(found: Found) -> None:
    _, passage, ways = found
    again = Island("Gotland again", 57.50, 18.60)
    twice = other_ways(passage, lambda _: ways[0].passage, job=Job(), islands=(GOTLAND, again))
    assert [way.island for way in twice] == ["Gotland"]


def test_what_is_much_slower_or_leads_nowhere_is_left_out(found: Found) -> None:
    _, passage, ways = found
    slow = ways[0].passage
    later = slow.departure + (slow.arrival - slow.departure) * 3
    assert not other_ways(passage, lambda _: replace(slow, arrival=later), job=Job(), islands=(GOTLAND,))

    def nowhere(_: Zone) -> Passage:
        raise NoPassageError("Every way leads through a zone.", reason="closed-zone")

    assert not other_ways(passage, nowhere, job=Job(), islands=(GOTLAND,))


def test_islands_aside_are_not_weighed(found: Found) -> None:
    _, passage, _ = found

    def never(_: Zone) -> Passage:
        raise AssertionError("nothing is to be searched")

    far = (Island("Bornholm", 55.13, 14.92), Island("Saaremaa", 58.40, 22.50), Island("Als", 54.98, 9.90))
    assert not other_ways(passage, never, job=Job(), islands=far)


def test_a_cancelled_search_ends(found: Found) -> None:
    _, passage, ways = found
    job = Job()
    job.cancel.set()
    with pytest.raises(CancelledError):
        other_ways(passage, lambda _: ways[0].passage, job=job, islands=(GOTLAND,))


def test_every_island_is_land_and_an_island() -> None:
    polygons = [shapely.Polygon(rings[0]) for rings in chart_land(1)]
    tree = shapely.STRtree(polygons)
    parts = {}
    for island in ISLANDS:
        within = tree.query(shapely.Point(island.lon, island.lat), predicate="within")
        assert len(within) == 1, island.name
        parts[island.name] = int(within[0])
        assert polygons[within[0]].area < 1.2, f"{island.name} is a part of the mainland"
    assert len(set(parts.values())) == len(ISLANDS)
