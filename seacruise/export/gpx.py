"""GPX 1.1: the route that a plotter follows, and the track as it was sailed on paper, with times.

What the programs that read it make of it, and what therefore stands here:

- OpenCPN (``model/src/nav_object_database.cpp``) shows ``rte`` and ``trk`` apart, takes the name, the
  description and the symbol of a point, and has its own elements for what GPX has none for: it shows the
  departure, and works out times of its own from the planned speed. A point without a symbol becomes a
  square; ``diamond`` is one of its own symbols.
- qtVlm reads points and routes of GPX (https://nauticalninja.pages.dev/sailing_guides/weather_routing/
  waypoints-and-routing-concepts). What Navionics makes of one is published nowhere that was found. So nothing
  here goes beyond the schema, and there are no loose waypoints that a reader would take for marks.
- Garmin's plotters keep at most 250 points in a route and cut names, the older ones (GPSMAP 4000 to 7000) to
  10 letters for a waypoint; a second waypoint of a name already there is renamed
  (https://support.garmin.com/en-US/?faq=HGD9XaRzls9HmNiZcs15I6, http://www.aukadia.net/gps/lwg_1.htm).
  So names between the ports are of at most 10 plain letters and figures, and tell passages apart.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterator, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

import seacruise
from seacruise.atomic import write_atomically
from seacruise.export.jsonform import format_time
from seacruise.export.textform import NOTICE, leg_sentence, title
from seacruise.export.xmlform import add_text, document, folded, waypoint_names
from seacruise.passage import Passage, Waypoint

NAMESPACE: Final = "http://www.topografix.com/GPX/1/1"
OPENCPN: Final = "http://www.opencpn.org"
MOST_POINTS: Final = 250
"""Points of a route at most; a longer one is told in parts, each of which begins where the last ended."""

LONGEST_NAME: Final = 30
"""Letters of a point's name that newer plotters show."""

_SCHEMA = f"{NAMESPACE} {NAMESPACE}/gpx.xsd"
_INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"


def gpx(passage: Passage) -> bytes:
    """GPX 1.1 document with the route (the waypoints) and one track (a point every six minutes).

    Elements follow the order that the schema demands. The document holds no time of writing, so that the
    same passage gives the same file.
    """
    root = ET.Element(
        "gpx",
        {
            "xmlns": NAMESPACE,
            "xmlns:xsi": _INSTANCE,
            "xmlns:opencpn": OPENCPN,
            "xsi:schemaLocation": _SCHEMA,
            "version": "1.1",
            "creator": f"SeaCruise {seacruise.__version__}",
        },
    )
    metadata = ET.SubElement(root, "metadata")
    add_text(metadata, "name", title(passage))
    add_text(metadata, "desc", f"{passage.forecast.source}. {NOTICE}")
    if bounds := _bounds(passage):
        ET.SubElement(metadata, "bounds", bounds)
    named = list(zip(waypoint_names(passage), passage.waypoints, strict=True))
    parts = list(_parts(named))
    for number, part in enumerate(parts, 1):
        _add_route(root, passage, part, f" ({number} of {len(parts)})" if len(parts) > 1 else "")
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


def _parts(named: Sequence[tuple[str, Waypoint]]) -> Iterator[Sequence[tuple[str, Waypoint]]]:
    """Cut a route into parts that plotters take, which share the points at which they meet."""
    step = MOST_POINTS - 1
    for begin in range(0, max(len(named) - 1, 1), step):
        yield named[begin : begin + MOST_POINTS]


def _add_route(root: ET.Element, passage: Passage, part: Sequence[tuple[str, Waypoint]], which: str) -> None:
    route = ET.SubElement(root, "rte")
    add_text(route, "name", f"{title(passage)}{which}")
    add_text(route, "desc", NOTICE)
    begin, end = part[0][1].time, part[-1][1].time
    sailed_nm = sum(waypoint.leg_nm or 0.0 for _, waypoint in part[:-1])
    extensions = ET.SubElement(route, "extensions")
    add_text(extensions, "opencpn:start", part[0][0])
    add_text(extensions, "opencpn:end", part[-1][0])
    if hours := (end - begin).total_seconds() / 3600.0:
        add_text(extensions, "opencpn:planned_speed", f"{sailed_nm / hours:.2f}")
    add_text(extensions, "opencpn:planned_departure", format_time(begin))
    for name, waypoint in part:
        point = ET.SubElement(route, "rtept", _position(waypoint.lat, waypoint.lon))
        add_text(point, "time", format_time(waypoint.time))
        add_text(point, "name", name[:LONGEST_NAME].rstrip())
        if waypoint.course_deg is not None:
            add_text(point, "desc", leg_sentence(waypoint))
        add_text(point, "sym", "diamond")


def _add_track(root: ET.Element, passage: Passage) -> None:
    track = ET.SubElement(root, "trk")
    add_text(track, "name", title(passage))
    segment = ET.SubElement(track, "trkseg")
    samples = passage.track
    for time, lat, lon in zip(samples.time, samples.lat, samples.lon, strict=True):
        point = ET.SubElement(segment, "trkpt", _position(lat, lon))
        add_text(point, "time", format_time(datetime.fromtimestamp(float(time), UTC)))


def _bounds(passage: Passage) -> dict[str, str]:
    """Bounds of all points; nothing across the date line, for which GPX has no words."""
    lats = [w.lat for w in passage.waypoints] + passage.track.lat.tolist()
    lons = [folded(lon) for lon in [w.lon for w in passage.waypoints] + passage.track.lon.tolist()]
    if max(lons) - min(lons) > 180.0:
        return {}
    low, high = _position(min(lats), min(lons)), _position(max(lats), max(lons))
    return {"minlat": low["lat"], "minlon": low["lon"], "maxlat": high["lat"], "maxlon": high["lon"]}


def _position(lat: float, lon: float) -> dict[str, str]:
    return {"lat": f"{lat:.6f}", "lon": f"{folded(lon):.6f}"}
