"""GPX, KML, GeoJSON, CSV, text: what other programs and people read."""

from __future__ import annotations

import csv
import dataclasses
import io
import json
import re
import xml.etree.ElementTree as ET
from datetime import UTC, datetime
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from seacruise.export import csvform, geojson, gpx, kml, textform, xmlform
from seacruise.passage import Passage, Place, Waypoint
from tests.export.schemas import KML as KML_SCHEMA
from tests.export.schemas import faults
from tests.passages import moved_east

GPX = {"g": gpx.NAMESPACE}
KML = {"k": kml.NAMESPACE}
NOW = datetime(2016, 11, 20, 5, tzinfo=UTC)


def renamed(passage: Passage, name: str) -> Passage:
    start: Place = dataclasses.replace(passage.start, name=name)
    return dataclasses.replace(passage, start=start)


@pytest.mark.parametrize("name", ["Świnoujście", "A & B <c>", 'say "hi"', "bell\x07 and \ud800"])
def test_xml_holds_any_name(passage: Passage, name: str) -> None:
    written = "".join(c for c in name if c not in "\x07\ud800")
    found = ET.fromstring(gpx.gpx(renamed(passage, name))).findtext("g:rte/g:rtept/g:name", namespaces=GPX)
    assert found == written
    folder = ET.fromstring(kml.kml(renamed(passage, name))).find(".//k:Folder/k:Placemark/k:name", KML)
    assert folder is not None
    assert folder.text == written


# ------------------------------------------------------------------------------------- KML and GeoJSON


def test_kml_keeps_to_the_schema(passage: Passage) -> None:
    assert faults(kml.kml(passage), kml.NAMESPACE, KML_SCHEMA) == []


def test_kml_line_is_the_track_and_points_are_the_waypoints(passage: Passage) -> None:
    root = ET.fromstring(kml.kml(passage))
    line = root.findtext(".//k:LineString/k:coordinates", namespaces=KML) or ""
    lon, lat = (float(number) for number in line.split()[0].split(","))
    assert (lon, lat) == pytest.approx((passage.waypoints[0].lon, passage.waypoints[0].lat), abs=1e-6)
    assert len(line.split()) == len(passage.track.time)
    assert len(root.findall(".//k:Folder/k:Placemark/k:Point", KML)) == len(passage.waypoints)


def test_geojson_is_longitude_first_and_complete(passage: Passage) -> None:
    data: dict[str, Any] = json.loads(json.dumps(geojson.geojson(passage), allow_nan=False))
    line, *points = data["features"]
    assert line["geometry"]["type"] == "LineString"
    assert line["geometry"]["coordinates"][0] == [18.57, 54.528]
    assert line["properties"]["duration_h"] == pytest.approx(passage.duration_h, abs=1e-3)
    assert "waypoints" not in line["properties"]
    assert [p["geometry"]["coordinates"] for p in points] == line["geometry"]["coordinates"]
    assert points[0]["properties"]["course_deg"] == pytest.approx(56.66, abs=0.01)
    west, south, east, north = data["bbox"]
    assert west <= 18.57 <= east
    assert south <= 54.528 <= north


def test_geojson_is_cut_at_the_date_line(passage: Passage) -> None:
    """RFC 7946, 3.1.9 and 5.2: no line jumps around the world, and the box then has west > east."""
    data: dict[str, Any] = json.loads(json.dumps(geojson.geojson(moved_east(passage, 161.6))))
    line, *points = data["features"]
    assert line["geometry"]["type"] == "MultiLineString"
    pieces = line["geometry"]["coordinates"]
    assert len(pieces) == 3
    for here, there in pairwise(pieces):
        assert {here[-1][0], there[0][0]} == {180.0, -180.0}
        assert here[-1][1] == there[0][1]
    for piece in pieces:
        assert max(lon for lon, _ in piece) - min(lon for lon, _ in piece) < 10.0
    assert all(-180.0 <= p["geometry"]["coordinates"][0] < 180.0 for p in points)
    west, _, east, _ = data["bbox"]
    assert east < -170.0 < 170.0 < west


@pytest.mark.parametrize(
    ("lon", "folded"),
    [
        (180.0, -180.0),
        (-180.0, -180.0),
        (179.9999999, -180.0),
        (181.5, -178.5),
        (-190.0, 170.0),
        (18.5, 18.5),
    ],
)
def test_longitudes_are_folded_to_what_the_formats_take(lon: float, folded: float) -> None:
    assert xmlform.folded(lon) == pytest.approx(folded, abs=1e-9)


# ------------------------------------------------------------------------------------------------ CSV


def test_csv_reads_back_to_the_legs(passage: Passage) -> None:
    rows = list(csv.DictReader(io.StringIO(csvform.legs_csv(passage), newline="")))
    assert len(rows) == len(passage.waypoints)
    for row, waypoint in zip(rows[:-1], passage.waypoints[:-1], strict=True):
        assert float(row["leg_nm"]) == pytest.approx(waypoint.leg_nm, abs=0.005)
        assert float(row["twa_deg"]) == pytest.approx(waypoint.twa_deg, abs=0.05)
        assert row["tack"] == (waypoint.tack or "")
        assert row["motor"] == ("yes" if waypoint.motor else "no")
    assert rows[-1]["course_deg"] == rows[-1]["motor"] == ""


def test_csv_is_that_of_rfc_4180_in_any_language(passage: Passage) -> None:
    """CR LF after every record (2.1, 2.2), as many fields in each (2.4), points for decimals."""
    sail = 'genoa, "heavy"'
    first, *more = passage.waypoints
    told = dataclasses.replace(
        first, sail=sail, sog_kn=7.25, steer_deg=50.0, current_kn=0.4, current_to_deg=9.0
    )
    data = csvform.legs_csv(dataclasses.replace(passage, waypoints=(told, *more)))
    assert data.endswith("\r\n")
    assert data.count("\r\n") == data.count("\n") == data.count("\r") == len(passage.waypoints) + 1
    records = list(csv.reader(io.StringIO(data, newline=""), strict=True))
    assert {len(record) for record in records} == {len(csvform.COLUMNS)}
    assert records[1][-5:] == ["7.25", "50.0", "0.40", "9.0", sail]
    assert re.fullmatch(r"-?\d+\.\d{6}", records[1][2])
    assert '"genoa, ""heavy"""' in data


# ----------------------------------------------------------------------------------------------- text


def test_text_has_what_a_sailor_asks_for(passage: Passage) -> None:
    text = textform.passage_to_text(passage, now=NOW)
    for part in (
        "Gdynia - Sandhamn: 43 h 17 min",
        "54°31.7'N 018°34.2'E, 0.8 nm from the harbour",
        "Sun 20 Nov 2016 06:00 UTC",
        "312.1 nm sailed, 285.9 nm direct",
        "7.2 kn",
        "1 tack, 2 gybes, 6 course changes",
        "issued Sun 20 Nov 2016 00:00 UTC, 5 h old",
        "1 h 17 min sailed on the last known wind",
        "clear of land, within limits",
        "155° stbd",
        "! Test wind: not a forecast.",
        "! A planning aid, not for navigation.",
    ):
        assert part in text, part


def test_text_shouts_when_a_check_failed(passage: Passage) -> None:
    checks = dataclasses.replace(passage.checks, land_free=False)
    text = textform.passage_to_text(dataclasses.replace(passage, checks=checks), now=NOW)
    assert "CROSSES LAND" in text


def test_legs_stand_in_columns(passage: Passage) -> None:
    lines = textform.passage_to_text(passage, now=NOW).splitlines()
    head = next(number for number, line in enumerate(lines) if "Time (UTC)" in line)
    sailed = lines[head + 1 : head + len(passage.waypoints)]
    end_of_speed = lines[head].index("Speed") + len("Speed")
    assert all(line[:end_of_speed].endswith(" kn") for line in sailed)
    assert sailed[-1].endswith("engine")


@pytest.mark.parametrize(
    ("hours", "text"), [(41.816667, "41 h 49 min"), (0.0, "0 h 00 min"), (1.9999, "2 h 00 min")]
)
def test_durations(hours: float, text: str) -> None:
    assert textform.format_duration(hours) == text


@pytest.mark.parametrize(("course", "text"), [(0.2, "000°"), (359.7, "000°"), (45.0, "045°")])
def test_courses_have_three_digits(course: float, text: str) -> None:
    assert textform.format_course(course) == text


# -------------------------------------------------------------------------------------------- writing


def test_writers_write_what_they_return(passage: Passage, tmp_path: Path) -> None:
    gpx.write_gpx(passage, tmp_path / "a.gpx")
    kml.write_kml(passage, tmp_path / "a.kml")
    csvform.write_csv(passage, tmp_path / "a.csv")
    geojson.write_geojson(passage, tmp_path / "a.geojson")
    assert (tmp_path / "a.gpx").read_bytes() == gpx.gpx(passage)
    assert (tmp_path / "a.kml").read_bytes() == kml.kml(passage)
    assert (tmp_path / "a.csv").read_bytes() == csvform.legs_csv(passage).encode()
    assert json.loads((tmp_path / "a.geojson").read_text(encoding="utf-8")) == geojson.geojson(passage)
    assert len(list(tmp_path.iterdir())) == 4


def test_a_leg_without_engine_names_its_wind() -> None:
    waypoint = Waypoint(
        lat=55.0,
        lon=18.0,
        time=NOW,
        course_deg=359.9,
        leg_nm=2.04,
        boat_speed_kn=6.0,
        tws_kn=12.4,
        twd_deg=40.0,
        twa_deg=40.1,
        motor=False,
        tack="starboard",
    )
    assert textform.leg_sentence(waypoint) == "steer 000° for 2.0 nm, 6.0 kn, wind 40° stbd, TWS 12 kn"
