"""The published schemas of GPX 1.1 and KML 2.2 as far as we write them, and a strict check against them.

The schemas themselves are not ours to pass on, so their rules stand here as tables: which elements an element
may hold, in which order and how often, which attributes it must and may have, and of which type the texts
are. What is not in the tables is refused.

- GPX 1.1: http://www.topografix.com/GPX/1/1/gpx.xsd, every type of it.
- KML 2.2: http://schemas.opengis.net/kml/2.2.0/ogckml22.xsd, the elements that `seacruise.export.kml` may
  use; an element that it has besides in the schema fails here and belongs into the table first.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from datetime import datetime

Text = Callable[[str], bool]
MANY = 10**9


def decimal(text: str) -> bool:
    return re.fullmatch(r"\s*[+-]?(\d+(\.\d*)?|\.\d+)\s*", text) is not None


def whole(text: str) -> bool:
    return re.fullmatch(r"\s*\+?\d+\s*", text) is not None


def date_time(text: str) -> bool:
    """Tell whether a text is an xsd:dateTime; a day that is none in the calendar is not."""
    if re.fullmatch(r"-?\d{4,}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d+)?(Z|[+-]\d\d:\d\d)?", text.strip()) is None:
        return False
    try:
        datetime.fromisoformat(text.strip())
    except ValueError:
        return False
    return True


def within(low: float, high: float, *, high_too: bool) -> Text:
    def fits(text: str) -> bool:
        return decimal(text) and (low <= float(text) < high or (high_too and float(text) == high))

    return fits


def one_of(*words: str) -> Text:
    return lambda text: text in words


def matching(pattern: str) -> Text:
    return lambda text: re.fullmatch(pattern, text.strip()) is not None


def anything(_text: str) -> bool:
    return True


@dataclass(frozen=True)
class Model:
    """What an element holds: children ``(name, its model's name, least, most)`` in order, or a text."""

    children: tuple[tuple[str, str, int, int], ...] = ()
    text: Text | None = None
    must: Mapping[str, Text] = field(default_factory=dict)
    may: Mapping[str, Text] = field(default_factory=dict)
    foreign: bool = False


def optional(*names: str, kind: str = "string", most: int = 1) -> tuple[tuple[str, str, int, int], ...]:
    return tuple((name, kind, 0, most) for name in names)


LATITUDE = within(-90.0, 90.0, high_too=True)
LONGITUDE = within(-180.0, 180.0, high_too=False)
LINK = optional("link", kind="link", most=MANY)
EXTENSIONS = optional("extensions", kind="extensions")

GPX = {
    "string": Model(text=anything),
    "decimal": Model(text=decimal),
    "whole": Model(text=whole),
    "time": Model(text=date_time),
    "degrees": Model(text=within(0.0, 360.0, high_too=False)),
    "fix": Model(text=one_of("none", "2d", "3d", "dgps", "pps")),
    "station": Model(text=lambda text: whole(text) and int(text) <= 1023),
    "year": Model(text=matching(r"-?\d{4,}(Z|[+-]\d\d:\d\d)?")),
    "extensions": Model(foreign=True),
    "link": Model(optional("text", "type"), must={"href": anything}),
    "email": Model(must={"id": anything, "domain": anything}),
    "person": Model(
        (*optional("name"), *optional("email", kind="email"), *optional("link", kind="link")),
    ),
    "copyright": Model((*optional("year", kind="year"), *optional("license")), must={"author": anything}),
    "bounds": Model(must={"minlat": LATITUDE, "minlon": LONGITUDE, "maxlat": LATITUDE, "maxlon": LONGITUDE}),
    "metadata": Model(
        (
            *optional("name", "desc"),
            *optional("author", kind="person"),
            *optional("copyright", kind="copyright"),
            *LINK,
            *optional("time", kind="time"),
            *optional("keywords"),
            *optional("bounds", kind="bounds"),
            *EXTENSIONS,
        )
    ),
    "point": Model(
        (
            *optional("ele", kind="decimal"),
            *optional("time", kind="time"),
            *optional("magvar", kind="degrees"),
            *optional("geoidheight", kind="decimal"),
            *optional("name", "cmt", "desc", "src"),
            *LINK,
            *optional("sym", "type"),
            *optional("fix", kind="fix"),
            *optional("sat", kind="whole"),
            *optional("hdop", "vdop", "pdop", "ageofdgpsdata", kind="decimal"),
            *optional("dgpsid", kind="station"),
            *EXTENSIONS,
        ),
        must={"lat": LATITUDE, "lon": LONGITUDE},
    ),
    "route": Model(
        (
            *optional("name", "cmt", "desc", "src"),
            *LINK,
            *optional("number", kind="whole"),
            *optional("type"),
            *EXTENSIONS,
            *optional("rtept", kind="point", most=MANY),
        )
    ),
    "track": Model(
        (
            *optional("name", "cmt", "desc", "src"),
            *LINK,
            *optional("number", kind="whole"),
            *optional("type"),
            *EXTENSIONS,
            *optional("trkseg", kind="segment", most=MANY),
        )
    ),
    "segment": Model((*optional("trkpt", kind="point", most=MANY), *EXTENSIONS)),
    "gpx": Model(
        (
            *optional("metadata", kind="metadata"),
            *optional("wpt", kind="point", most=MANY),
            *optional("rte", kind="route", most=MANY),
            *optional("trk", kind="track", most=MANY),
            *EXTENSIONS,
        ),
        must={"version": one_of("1.1"), "creator": anything},
    ),
}

NUMBER = r"-?\d+(\.\d+)?"
KML_ID = {"id": matching(r"[A-Za-z_][\w.-]*")}
FEATURE = (
    *optional("name"),
    *optional("visibility", "open", kind="boolean"),
    *optional("description"),
    *optional("TimeStamp", kind="stamp"),
    *optional("TimeSpan", kind="span"),
    *optional("styleUrl"),
    *optional("Style", kind="style", most=MANY),
)
KML = {
    "string": Model(text=anything),
    "boolean": Model(text=one_of("0", "1", "true", "false")),
    "colour": Model(text=matching("[0-9a-fA-F]{8}")),
    "decimal": Model(text=decimal),
    "time": Model(text=lambda text: date_time(text) or matching(r"\d{4}(-\d\d(-\d\d)?)?")(text)),
    "stamp": Model((("when", "time", 0, 1),)),
    "span": Model((("begin", "time", 0, 1), ("end", "time", 0, 1))),
    "style": Model((("LineStyle", "line style", 0, 1),), may=KML_ID),
    "line style": Model((("color", "colour", 0, 1), ("width", "decimal", 0, 1))),
    "places": Model(text=matching(rf"{NUMBER},{NUMBER}(,{NUMBER})?(\s+{NUMBER},{NUMBER}(,{NUMBER})?)*")),
    "line": Model((*optional("extrude", "tessellate", kind="boolean"), ("coordinates", "places", 0, 1))),
    "point": Model((*optional("extrude", kind="boolean"), ("coordinates", "places", 0, 1))),
    "placemark": Model(
        (*FEATURE, *optional("Point", kind="point"), *optional("LineString", kind="line")), may=KML_ID
    ),
    "folder": Model((*FEATURE, *optional("Placemark", kind="placemark", most=MANY)), may=KML_ID),
    "document": Model(
        (
            *FEATURE,
            *optional("Placemark", kind="placemark", most=MANY),
            *optional("Folder", kind="folder", most=MANY),
        ),
        may=KML_ID,
    ),
    "kml": Model((("Document", "document", 0, 1),)),
}


def faults(data: bytes, namespace: str, schema: dict[str, Model]) -> list[str]:
    """Say what in a document breaks the schema; its root is the model of the same name."""
    root = ET.fromstring(data)
    name = next(reversed(schema))
    if root.tag != f"{{{namespace}}}{name}":
        return [f"the root is {root.tag}"]
    return _faults(root, namespace, schema, name)


def _faults(element: ET.Element, namespace: str, schema: Mapping[str, Model], kind: str) -> list[str]:
    model, here = schema[kind], element.tag.rpartition("}")[2]
    found = _attribute_faults(element, model)
    if model.text is not None:
        wrong = [] if model.text(element.text or "") else [f"{here} holds {element.text!r}"]
        return [*found, *wrong, *(f"{here} has a child" for _ in element)]
    if (element.text or "").strip():
        found.append(f"{here} holds a text")
    if model.foreign:
        return found + [
            f"{here} holds {c.tag}" for c in element if c.tag.startswith((f"{{{namespace}}}", "?"))
        ]
    names = [name for name, *_ in model.children]
    last, seen = -1, dict.fromkeys(names, 0)
    for child in element:
        uri, _, name = child.tag[1:].rpartition("}")
        if uri != namespace or name not in names:
            found.append(f"{here} must not hold {child.tag}")
            continue
        place = names.index(name)
        if place < last:
            found.append(f"{name} in {here} comes too late")
        last = max(last, place)
        seen[name] += 1
        found += _faults(child, namespace, schema, model.children[place][1])
    return found + [
        f"{here} has {seen[name]} of {name}"
        for name, _, least, most in model.children
        if not least <= seen[name] <= most
    ]


def _attribute_faults(element: ET.Element, model: Model) -> list[str]:
    own = {key: text for key, text in element.attrib.items() if not key.startswith("{")}
    known = {**model.must, **model.may}
    return [
        *(f"{element.tag} lacks {key}" for key in model.must if key not in own),
        *(f"{element.tag} has {key}={text!r}" for key, text in own.items() if key not in known),
        *(f"{key}={text!r}" for key, text in own.items() if key in known and not known[key](text)),
    ]
