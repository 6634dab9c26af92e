"""What GPX, KML and GeoJSON have in common."""

from __future__ import annotations

import re
import unicodedata
import xml.etree.ElementTree as ET

from seacruise.passage import Passage

# Characters that XML 1.0 cannot hold, not even escaped.
_NOT_XML = re.compile(r"[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def add_text(parent: ET.Element, tag: str, text: str) -> None:
    """Append an element that holds a text, without the characters that XML forbids."""
    ET.SubElement(parent, tag).text = _NOT_XML.sub("", text)


def document(root: ET.Element) -> bytes:
    """Write a tree as an indented UTF-8 document."""
    ET.indent(root)
    return bytes(ET.tostring(root, encoding="UTF-8", xml_declaration=True)) + b"\n"


def waypoint_names(passage: Passage) -> list[str]:
    """Name each waypoint: the ports at the ends, ``GDYSTO01`` and so on between them.

    Letters of both ports tell the points of one passage from those of another, which share a plotter's list
    of waypoints; the number is that of the table of legs.
    """
    stem = f"{_three(passage.start.name)}{_three(passage.end.name)}" or "WP"
    between = [f"{stem}{number:02d}" for number in range(1, len(passage.waypoints) - 1)]
    return [passage.start.name, *between, passage.end.name]


def _three(name: str) -> str:
    """First three letters of a name as every plotter can show them: ``SWI`` of Świnoujście."""
    # these letters are no base letter with a mark, so that taking marks off would lose them
    plain = name.translate(str.maketrans("łŁøØđĐ", "lLoOdD"))
    plain = unicodedata.normalize("NFKD", plain).encode("ascii", "ignore").decode()
    return "".join(letter for letter in plain if letter.isalpha())[:3].upper()


def folded(lon: float) -> float:
    """Longitude within -180 (included) and 180 (excluded) [degrees], also after rounding to six decimals."""
    east = (round(lon, 6) + 180.0) % 360.0 - 180.0
    return -180.0 if round(east, 6) >= 180.0 else east
