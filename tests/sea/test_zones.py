"""No-go zones: read from GeoJSON, tested as prisms in (lat, lon, time), kept clear of by passages."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import assume, given
from hypothesis import strategies as st

from seacruise.errors import InputError, NoPassageError
from seacruise.geodesy import to_mercator
from seacruise.passage import PassageRequest, plan
from seacruise.ports import Port
from seacruise.resources import resource_path
from seacruise.sea import _prisms as k
from seacruise.sea import zones as z
from seacruise.settings import Settings
from seacruise.weather.sample import sample_wind
from seacruise.yacht.fleet import find_yacht, load_fleet

BOX = [[18.6, 55.6], [19.6, 55.6], [19.6, 56.0], [18.6, 56.0], [18.6, 55.6]]
DEPARTURE = datetime(2016, 11, 20, 6, tzinfo=UTC)


def geojson(*polygons: Any, **properties: Any) -> dict[str, Any]:
    return {
        "type": "FeatureCollection",
        "features": [
            {
                "type": "Feature",
                "properties": properties,
                "geometry": {"type": "Polygon", "coordinates": [one]},
            }
            for one in polygons
        ],
    }


def write(path: Path, content: Any) -> Path:
    path.write_text(content if isinstance(content, str) else json.dumps(content), encoding="utf-8")
    return path


def request(zones: z.Zones, end: tuple[float, float] = (56.6, 19.2)) -> PassageRequest:
    yacht = find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")]))
    south, north = Port("South", "", 55.0, 19.1), Port("North", "", *end)
    return PassageRequest(south, north, yacht, sample_wind(), DEPARTURE, zones=zones)


# ------------------------------------------------------------------------------------------ the kernel


square = st.tuples(*[st.floats(-2.0, 2.0).map(lambda v: round(v, 3))] * 4)


@given(ways=st.lists(square, min_size=1, max_size=20), seed=st.integers(0, 1000))
def test_a_way_is_closed_exactly_where_shapely_says_it_enters(
    ways: list[tuple[float, ...]], seed: int
) -> None:
    rng = np.random.default_rng(seed)
    angle = np.sort(rng.uniform(0, 2 * np.pi, 7))
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=1) * rng.uniform(0.3, 1.5, 7)[:, None]
    area = shapely.Polygon(ring)
    assume(area.is_valid)
    edges = np.hstack([ring, np.roll(ring, -1, axis=0)])
    box = np.array([[*ring.min(axis=0), *ring.max(axis=0)]])
    arrays = (np.array([0, 7]), edges, box, np.array([[-np.inf, np.inf]]))
    for x0, y0, x1, y1 in ways:
        way = shapely.LineString([(x0, y0), (x1, y1)])
        if (x0, y0) == (x1, y1):
            continue
        if way.distance(area.boundary) > 0.0 or way.crosses(area):
            deep = way.intersection(area).length
            if deep == 0.0 or deep > 1e-6:
                assert k.closed(arrays, x0, y0, 0.0, x1, y1, 1.0) == way.intersects(area)


@pytest.mark.parametrize(
    ("begin", "end", "closed"),
    [
        (0.0, 10.0, True),
        # On the box from 2.5 to 7.5: before, during and after.
        (-20.0, -10.0, False),
        (20.0, 30.0, False),
        (-5.0, 2.0, False),
        (-5.0, 3.0, True),
        (8.0, 9.0, False),
        (7.0, 9.0, True),
    ],
)
def test_a_zone_is_a_prism_in_time(begin: float, end: float, closed: bool) -> None:
    x = np.array([-0.5, 0.5, 0.5, -0.5, -0.5])
    y = np.array([-0.5, -0.5, 0.5, 0.5, -0.5])
    edges = np.stack([x[:-1], y[:-1], x[1:], y[1:]], axis=1)
    arrays = (np.array([0, 4]), edges, np.array([[-0.5, -0.5, 0.5, 0.5]]), np.array([[begin, end]]))
    # From -1 to 1 in ten seconds she is inside from 2.5 to 7.5.
    assert k.closed(arrays, -1.0, 0.0, 0.0, 1.0, 0.0, 10.0) is closed


# -------------------------------------------------------------------------------------------- passages


def test_a_passage_goes_around_a_zone(settings: Settings, tmp_path: Path) -> None:
    free = plan(request(z.NO_ZONES), settings=settings)
    closed = z.load_zones([write(tmp_path / "a.geojson", geojson(BOX, name="Range"))])
    around = plan(request(closed), settings=settings)
    assert around.checks.zones_free
    assert around.duration_h > free.duration_h
    track = shapely.LineString(np.stack([around.track.lon, around.track.lat], axis=1))
    assert not track.intersects(shapely.Polygon(BOX))
    assert shapely.LineString(np.stack([free.track.lon, free.track.lat], axis=1)).intersects(
        shapely.Polygon(BOX)
    )
    assert any("Zones that are kept clear of" in notice for notice in around.notices)


def test_a_zone_that_is_not_valid_yet_or_any_more_changes_nothing(settings: Settings, tmp_path: Path) -> None:
    free = plan(request(z.NO_ZONES), settings=settings)
    for span in (
        {"valid_to": "2016-11-20T05:00Z"},
        {"valid_from": "2016-11-23T00:00Z"},
        {"valid_from": "2016-11-25T00:00Z", "valid_to": "2016-11-26T00:00+02:00"},
    ):
        closed = z.load_zones([write(tmp_path / "a.geojson", geojson(BOX, **span))])
        assert plan(request(closed), settings=settings).duration_h == pytest.approx(free.duration_h, rel=1e-3)


def test_a_zone_that_closes_as_she_comes_is_kept_clear_of(settings: Settings, tmp_path: Path) -> None:
    free = plan(request(z.NO_ZONES), settings=settings)
    inside = (free.track.lat > 55.6) & (free.track.lat < 56.0)
    begin, end = free.track.time[inside][[0, -1]]
    span = {
        "valid_from": datetime.fromtimestamp((begin + end) / 2, UTC).isoformat(),
        "valid_to": datetime.fromtimestamp(end + 3600, UTC).isoformat(),
    }
    closed = z.load_zones([write(tmp_path / "a.geojson", geojson(BOX, **span))])
    passage = plan(request(closed), settings=settings)
    assert passage.checks.zones_free
    assert passage.duration_h >= free.duration_h * 0.999
    assert free.track.time.size
    assert closed.entered(free.track.lat, free.track.lon, free.track.time) != ()


def test_an_end_in_a_zone_is_refused_with_its_name(settings: Settings, tmp_path: Path) -> None:
    closed = z.load_zones([write(tmp_path / "a.geojson", geojson(BOX, name="Range"))])
    with pytest.raises(NoPassageError, match="Range") as caught:
        plan(request(closed, end=(55.8, 19.0)), settings=settings)
    assert caught.value.reason == "closed-zone"


def test_a_wall_from_shore_to_shore_is_the_reason(settings: Settings, tmp_path: Path) -> None:
    wall = [[9.0, 55.5], [31.0, 55.5], [31.0, 56.2], [9.0, 56.2], [9.0, 55.5]]
    closed = z.load_zones([write(tmp_path / "a.geojson", geojson(wall))])
    with pytest.raises(NoPassageError) as caught:
        plan(request(closed), settings=settings)
    assert caught.value.reason == "closed-zone"


def test_more_zones_never_make_a_faster_passage(settings: Settings, tmp_path: Path) -> None:
    east = [[19.0, 55.6], [20.5, 55.6], [20.5, 55.9], [19.0, 55.9], [19.0, 55.6]]
    one = z.load_zones([write(tmp_path / "a.geojson", geojson(BOX))])
    two = z.load_zones([write(tmp_path / "a.geojson", geojson(BOX, east))])
    # Waypoints are relaxed to a tolerance, which is all that may be won.
    assert (
        plan(request(two), settings=settings).duration_h
        >= plan(request(one), settings=settings).duration_h * 0.999
    )


def test_german_wind_farms_and_shipping_lanes_are_kept_clear_of(
    settings: Settings, shared_data: Path
) -> None:
    folder = shared_data / "zones"
    closed = z.load_zones([folder / "DE_OWF.geojson", folder / "DE_shipping.geojson"])
    assert len(closed.zones) > 40
    asked = replace(
        request(closed), start=Port("Kiel", "DE", 54.42, 10.17), end=Port("Rønne", "DK", 55.10, 14.69)
    )
    passage = plan(asked, settings=settings)
    assert passage.checks.zones_free
    track = shapely.LineString(np.stack([passage.track.lon, passage.track.lat], axis=1))
    for zone in closed.zones:
        assert not track.intersects(shapely.Polygon(zone.rings[0])), zone.name


# ----------------------------------------------------------------------------------------------- files


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ("", "not GeoJSON"),
        ("{", "not GeoJSON"),
        ("[" * 100_000, "not GeoJSON"),
        ("[1, 2]", "no GeoJSON features"),
        ({"type": "FeatureCollection", "features": "none"}, "no GeoJSON features"),
        (geojson([[1, 2], [3, 4]]), "not longitude and latitude"),
        (geojson([[1, 2], [3, 4], ["x", 5]]), "not longitude and latitude"),
        (geojson([[1, 2], [3, 400], [5, 6]]), "not longitude and latitude"),
        (geojson([[1, 2], [3, math.nan], [5, 6]]), "not longitude and latitude"),
        (geojson(BOX, valid_from="Thursday"), "valid_from of feature 1"),
    ],
)
def test_a_broken_file_is_named_with_what_is_wrong(content: Any, says: str, tmp_path: Path) -> None:
    path = write(tmp_path / "zones.geojson", content)
    with pytest.raises(InputError, match=says) as caught:
        z.load_zones([path])
    assert "zones.geojson" in str(caught.value)


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"nowhere\.geojson cannot be read"):
        z.load_zones([tmp_path / "nowhere.geojson"])


def test_holes_points_and_names_are_understood(tmp_path: Path) -> None:
    hole = [[19.0, 55.7], [19.2, 55.7], [19.2, 55.9], [19.0, 55.9], [19.0, 55.7]]
    content = {
        "type": "FeatureCollection",
        "features": [
            {
                "type": "Feature",
                "properties": {"NAME": "Ring"},
                "geometry": {"type": "Polygon", "coordinates": [BOX, hole]},
            },
            {"type": "Feature", "properties": None, "geometry": {"type": "Point", "coordinates": [1, 2]}},
        ],
    }
    (zone,) = z.load_zones([write(tmp_path / "a.geojson", content)]).zones
    assert zone.name == "Ring"
    only = z.Zones((zone,))
    assert z.blocking(only, 55.8, 18.8, 0.0) == ("Ring",)
    assert z.blocking(only, 55.8, 19.1, 0.0) == ()
    x, y = to_mercator([55.8, 55.8, 55.8], [18.7, 18.9, 19.1])
    lines = np.array([[x[0], y[0], x[1], y[1]], [x[2], y[2], x[2] + 1.0, y[2]]])
    assert only.close(lines, 0.0, 1.0).tolist() == [True, False]


def test_the_folder_of_layers_may_be_missing_or_hold_other_files(tmp_path: Path) -> None:
    assert z.layer_files(tmp_path / "layers") == []
    write(tmp_path / "b.geojson", geojson(BOX))
    write(tmp_path / "a.GeoJSON", geojson(BOX))
    write(tmp_path / "notes.txt", "hello")
    assert [path.name for path in z.layer_files(tmp_path)] == ["a.GeoJSON", "b.geojson"]
