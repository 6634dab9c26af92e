"""GPX 1.1: the route that a plotter follows, and the track as it was sailed on paper, with times."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from datetime import UTC, datetime
from pathlib import Path

import seacruise
from seacruise.atomic import write_atomically
from seacruise.export.jsonform import format_time
from seacruise.export.textform import NOTICE, leg_sentence, title
from seacruise.export.xmlform import add_text, document, waypoint_names
from seacruise.passage import Passage

NAMESPACE = "http://www.topografix.com/GPX/1/1"
_SCHEMA = f"{NAMESPACE} {NAMESPACE}/gpx.xsd"
_INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"


def gpx(passage: Passage) -> bytes:
    """GPX 1.1 document with one route (the waypoints) and one track (a point every six minutes).

    Elements follow the order that the schema demands. The document holds no time of writing, so that the
    same passage gives the same file.
    """
    root = ET.Element(
        "gpx",
        {
            "xmlns": NAMESPACE,
            "xmlns:xsi": _INSTANCE,
            "xsi:schemaLocation": _SCHEMA,
            "version": "1.1",
            "creator": f"SeaCruise {seacruise.__version__}",
        },
    )
    metadata = ET.SubElement(root, "metadata")
    add_text(metadata, "name", title(passage))
    add_text(metadata, "desc", f"{passage.forecast.source}. {NOTICE}")
    ET.SubElement(metadata, "bounds", _bounds(passage))
    _add_route(root, passage)
    _add_track(root, passage)
    return document(root)


def write_gpx(passage: Passage, path: Path) -> None:
    """Write `gpx` to a file.

    Raises
    ------
    InputError
        The file cannot be written.
    """
    write_atomically(path, gpx(passage), what="GPX file")


def _add_route(root: ET.Element, passage: Passage) -> None:
    route = ET.SubElement(root, "rte")
    add_text(route, "name", title(passage))
    add_text(route, "desc", NOTICE)
    for name, waypoint in zip(waypoint_names(passage), passage.waypoints, strict=True):
        point = ET.SubElement(route, "rtept", _position(waypoint.lat, waypoint.lon))
        add_text(point, "time", format_time(waypoint.time))
        add_text(point, "name", name)
        if waypoint.course_deg is not None:
            add_text(point, "desc", leg_sentence(waypoint))


def _add_track(root: ET.Element, passage: Passage) -> None:
    track = ET.SubElement(root, "trk")
    add_text(track, "name", title(passage))
    segment = ET.SubElement(track, "trkseg")
    samples = passage.track
    for time, lat, lon in zip(samples.time, samples.lat, samples.lon, strict=True):
        point = ET.SubElement(segment, "trkpt", _position(lat, lon))
        add_text(point, "time", format_time(datetime.fromtimestamp(float(time), UTC)))


def _bounds(passage: Passage) -> dict[str, str]:
    lats = [w.lat for w in passage.waypoints]
    lons = [w.lon for w in passage.waypoints]
    low, high = _position(min(lats), min(lons)), _position(max(lats), max(lons))
    return {"minlat": low["lat"], "minlon": low["lon"], "maxlat": high["lat"], "maxlon": high["lon"]}


def _position(lat: float, lon: float) -> dict[str, str]:
    return {"lat": f"{lat:.6f}", "lon": f"{lon:.6f}"}
