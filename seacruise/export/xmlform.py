"""What GPX and KML have in common."""

from __future__ import annotations

import re
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
    """Name each waypoint: the ports at the ends, ``WP01`` and so on between them."""
    between = [f"WP{number:02d}" for number in range(1, len(passage.waypoints) - 1)]
    return [passage.start.name, *between, passage.end.name]
