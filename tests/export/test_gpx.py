"""GPX 1.1: after the schema, and as the programs read it that sailors have."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import replace
from datetime import UTC, datetime
from itertools import pairwise

import pytest

from seacruise.export import gpx, xmlform
from seacruise.geodesy import rhumb_course_deg, rhumb_distance_m
from seacruise.passage import Passage, Place
from seacruise.units import METRES_PER_NM
from tests.export.schemas import GPX, faults
from tests.passages import moved_east

NS = {"g": gpx.NAMESPACE, "o": gpx.OPENCPN}


def root_of(passage: Passage) -> ET.Element:
    return ET.fromstring(gpx.gpx(passage))


def named(place: Place, name: str) -> Place:
    return replace(place, name=name)


def many(passage: Passage, count: int) -> Passage:
    first, *_, last = passage.waypoints
    legs = [replace(first, lat=54.0 + k / 1000) for k in range(count - 1)]
    return replace(passage, waypoints=(*legs, last))


# --------------------------------------------------------------------------------------- the schema


def test_it_keeps_to_the_schema(passage: Passage) -> None:
    data = gpx.gpx(passage)
    assert faults(data, gpx.NAMESPACE, GPX) == []
    assert data.startswith(b"<?xml version='1.0' encoding='UTF-8'?>")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (b"<name>Gdynia</name>", b"<name>Gdynia</name><time>2016-11-20T06:00:00Z</time>"),
        (b"<sym>diamond</sym>", b"<sym>diamond</sym><symbol>x</symbol>"),
        (b'lon="18.570000"', b'lon="180.000000"'),
        (b'lat="54.528000"', b'lat="54,528000"'),
        (b'version="1.1"', b'version="1.0"'),
        (b"2016-11-20T06:00:00Z", b"20.11.2016 06:00"),
        (b"</extensions>", b"<name>ours</name></extensions>"),
    ],
)
def test_the_check_finds_what_breaks_the_schema(passage: Passage, old: bytes, new: bytes) -> None:
    """So that the test above is worth something: each of these is refused by the published schema too."""
    data = gpx.gpx(passage)
    assert old in data
    assert faults(data.replace(old, new), gpx.NAMESPACE, GPX)


def test_over_the_date_line_it_still_keeps_to_the_schema(passage: Passage) -> None:
    """Longitudes are below 180 there (xsd:maxExclusive), and no bounds lie around the world."""
    data = gpx.gpx(moved_east(passage, 161.6))
    assert faults(data, gpx.NAMESPACE, GPX) == []
    assert b"<bounds" not in data
    assert b"<bounds" in gpx.gpx(passage)


def test_bounds_hold_every_point(passage: Passage) -> None:
    root = root_of(passage)
    bounds = root.find("g:metadata/g:bounds", NS)
    assert bounds is not None
    points = [*root.findall(".//g:rtept", NS), *root.findall(".//g:trkpt", NS)]
    for key in ("lat", "lon"):
        values = [float(point.attrib[key]) for point in points]
        assert float(bounds.attrib[f"min{key}"]) == min(values)
        assert float(bounds.attrib[f"max{key}"]) == max(values)


# -------------------------------------------------------------------------------- there and back again


def test_the_route_read_back_gives_the_same_legs(passage: Passage) -> None:
    points = root_of(passage).findall("g:rte/g:rtept", NS)
    assert len(points) == len(passage.waypoints)
    for (here, there), leg, to in zip(
        pairwise(points), passage.waypoints[:-1], passage.waypoints[1:], strict=True
    ):
        assert leg.course_deg is not None
        assert leg.leg_nm is not None
        ends = [float(p.attrib[key]) for p in (here, there) for key in ("lat", "lon")]
        assert float(rhumb_course_deg(*ends)) == pytest.approx(leg.course_deg, abs=0.01)
        assert float(rhumb_distance_m(*ends)) / METRES_PER_NM == pytest.approx(leg.leg_nm, abs=1e-3)
        sailed = [datetime.fromisoformat(p.findtext("g:time", "", NS)) for p in (here, there)]
        took = to.time - leg.time
        assert (sailed[1] - sailed[0] - took).total_seconds() == pytest.approx(0.0, abs=1.0)
    assert f"steer {round(passage.waypoints[0].course_deg or 0):03d}° for 13.3 nm" in (
        points[0].findtext("g:desc", "", NS)
    )


def test_the_track_has_rising_times(passage: Passage) -> None:
    points = root_of(passage).findall("g:trk/g:trkseg/g:trkpt", NS)
    times = [datetime.fromisoformat(p.findtext("g:time", "", NS)) for p in points]
    assert len(points) == len(passage.track.time)
    assert times == sorted(times)
    assert times[0] == passage.departure.astimezone(UTC)
    assert abs((times[-1] - passage.arrival).total_seconds()) <= 0.5


def test_it_says_that_it_is_no_chart(passage: Passage) -> None:
    root = root_of(passage)
    for where in ("g:metadata/g:desc", "g:rte/g:desc"):
        assert "not for navigation" in root.findtext(where, "", NS)


# ------------------------------------------------------------------------------- as programs read it


def test_points_have_what_opencpn_shows(passage: Passage) -> None:
    """GPXLoadRoute1 in OpenCPN's model/src/nav_object_database.cpp: names, symbols and its own elements."""
    route = root_of(passage).find("g:rte", NS)
    assert route is not None
    assert route.findtext("o:start", None, NS) is None, "its elements belong into <extensions>"
    assert route.findtext("g:extensions/o:start", None, NS) == "Gdynia"
    assert route.findtext("g:extensions/o:end", None, NS) == "Sandhamn"
    assert route.findtext("g:extensions/o:planned_departure", None, NS) == "2016-11-20T06:00:00Z"
    speed = float(route.findtext("g:extensions/o:planned_speed", "", NS))
    assert speed == pytest.approx(passage.mean_speed_kn, abs=0.006)
    points = route.findall("g:rtept", NS)
    assert {point.findtext("g:sym", None, NS) for point in points} == {"diamond"}
    # It reads extensions before points only when they stand there, as the schema wants them.
    assert [child.tag.rpartition("}")[2] for child in route][:3] == ["name", "desc", "extensions"]


def test_route_and_track_are_apart(passage: Passage) -> None:
    """qtVlm takes points of a file for marks: loose waypoints would clutter its chart."""
    root = root_of(passage)
    assert [child.tag.rpartition("}")[2] for child in root] == ["metadata", "rte", "trk"]


@pytest.mark.parametrize(
    ("start", "end", "stem"),
    [
        ("Gdynia", "Stockholm", "GDYSTO"),
        ("Świnoujście", "Łeba", "SWILEB"),
        ("Ærøskøbing", "Ålesund", "ROSALE"),
        ("54.5,18.6", "56,20", "WP"),
    ],
)
def test_names_are_short_plain_and_those_of_one_passage(
    passage: Passage, start: str, end: str, stem: str
) -> None:
    """Older Garmin plotters keep 10 letters of a waypoint's name and rename a second one of that name."""
    one = replace(passage, start=named(passage.start, start), end=named(passage.end, end))
    names = xmlform.waypoint_names(one)
    assert (names[0], names[-1]) == (start, end)
    assert names[1:-1] == [f"{stem}{k:02d}" for k in range(1, len(names) - 1)]
    for name in names[1:-1]:
        assert len(name) <= 10
        assert name.isascii()
        assert name.isalnum()
    assert len(set(names)) == len(names)


def test_long_names_of_ports_are_cut(passage: Passage) -> None:
    one = replace(passage, end=named(passage.end, "Yachthafen am Nordmolenkopf bei der alten Werft"))
    names = [p.findtext("g:name", "", NS) for p in root_of(one).findall("g:rte/g:rtept", NS)]
    assert names[-1] == "Yachthafen am Nordmolenkopf be"
    assert len(names[-1]) == gpx.LONGEST_NAME


@pytest.mark.parametrize(
    ("count", "sizes"), [(2, [2]), (250, [250]), (251, [250, 2]), (600, [250, 250, 102])]
)
def test_a_route_has_no_more_points_than_plotters_take(
    passage: Passage, count: int, sizes: list[int]
) -> None:
    """Garmin: 250 points a route. The parts meet, so that no leg is lost."""
    one = many(passage, count)
    assert faults(gpx.gpx(one), gpx.NAMESPACE, GPX) == []
    routes = root_of(one).findall("g:rte", NS)
    points = [[dict(p.attrib) for p in route.findall("g:rtept", NS)] for route in routes]
    assert [len(part) for part in points] == sizes
    assert all(here[-1] == there[0] for here, there in pairwise(points))
    joined = points[0] + [p for part in points[1:] for p in part[1:]]
    assert len(joined) == count
    names = [route.findtext("g:name", "", NS) for route in routes]
    assert len(set(names)) == len(names)
    if len(sizes) > 1:
        assert names[0] == f"Gdynia - Sandhamn (1 of {len(sizes)})"
