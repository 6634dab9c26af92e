"""KML 2.2, for Google Earth and its kin: the passage as a line, its waypoints with time and leg."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from pathlib import Path

from seacruise.atomic import write_atomically
from seacruise.export.jsonform import format_time
from seacruise.export.textform import NOTICE, format_duration, leg_sentence, title
from seacruise.export.xmlform import add_text, document, folded, waypoint_names
from seacruise.passage import Passage

NAMESPACE = "http://www.opengis.net/kml/2.2"
_ROUTE_COLOUR = "ffa000c8"
"""Magenta, as routes are on charts; KML writes alpha, blue, green, red."""


def kml(passage: Passage) -> bytes:
    """KML document; elements follow the order that the schema demands."""
    root = ET.Element("kml", {"xmlns": NAMESPACE})
    body = ET.SubElement(root, "Document")
    add_text(body, "name", title(passage))
    add_text(body, "description", f"{passage.yacht}, {passage.forecast.source}. {NOTICE}")
    style = ET.SubElement(body, "Style", {"id": "passage"})
    line_style = ET.SubElement(style, "LineStyle")
    add_text(line_style, "color", _ROUTE_COLOUR)
    add_text(line_style, "width", "3")
    _add_line(body, passage)
    _add_waypoints(body, passage)
    return document(root)


def write_kml(passage: Passage, path: Path) -> None:
    """Write `kml` to a file.

    Raises
    ------
    InputError
        The file cannot be written.
    """
    write_atomically(path, kml(passage), what="KML file")


def _add_line(body: ET.Element, passage: Passage) -> None:
    placemark = ET.SubElement(body, "Placemark")
    add_text(placemark, "name", f"{title(passage)}, {format_duration(passage.duration_h)}")
    span = ET.SubElement(placemark, "TimeSpan")
    add_text(span, "begin", format_time(passage.departure))
    add_text(span, "end", format_time(passage.arrival))
    add_text(placemark, "styleUrl", "#passage")
    line = ET.SubElement(placemark, "LineString")
    add_text(line, "tessellate", "1")
    # The sailed samples, not the waypoints: between those a map program would draw great circles.
    samples = zip(passage.track.lon, passage.track.lat, strict=True)
    add_text(line, "coordinates", " ".join(f"{folded(lon):.6f},{lat:.6f}" for lon, lat in samples))


def _add_waypoints(body: ET.Element, passage: Passage) -> None:
    folder = ET.SubElement(body, "Folder")
    add_text(folder, "name", "Waypoints")
    for name, waypoint in zip(waypoint_names(passage), passage.waypoints, strict=True):
        placemark = ET.SubElement(folder, "Placemark")
        add_text(placemark, "name", name)
        if waypoint.course_deg is not None:
            add_text(placemark, "description", leg_sentence(waypoint))
        add_text(ET.SubElement(placemark, "TimeStamp"), "when", format_time(waypoint.time))
        point = ET.SubElement(placemark, "Point")
        add_text(point, "coordinates", f"{folded(waypoint.lon):.6f},{waypoint.lat:.6f}")
