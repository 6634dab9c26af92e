"""GeoJSON (RFC 7946): the passage as a line and its waypoints as points, for map programs."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

from seacruise.atomic import write_atomically
from seacruise.export.jsonform import dumps, number, passage_to_json
from seacruise.export.textform import NOTICE, title
from seacruise.export.xmlform import folded
from seacruise.passage import Passage


def geojson(passage: Passage) -> dict[str, Any]:
    """Feature collection: the line with the summary first, then a point a waypoint with its leg."""
    summary = passage_to_json(passage)
    waypoints = summary.pop("waypoints")
    places = [(folded(w.lon), w.lat) for w in passage.waypoints]
    pieces = _cut_at_date_line(places)
    shape = (
        {"type": "LineString", "coordinates": pieces[0]}
        if len(pieces) == 1
        else {"type": "MultiLineString", "coordinates": pieces}
    )
    line = {
        "type": "Feature",
        "geometry": shape,
        "properties": {"name": title(passage), "notice": NOTICE, **summary},
    }
    points = [
        {
            "type": "Feature",
            "geometry": {"type": "Point", "coordinates": _rounded(place)},
            "properties": {"number": index, **{k: v for k, v in leg.items() if k not in {"lat", "lon"}}},
        }
        for index, (leg, place) in enumerate(zip(waypoints, places, strict=True))
    ]
    return {"type": "FeatureCollection", "bbox": _box(places), "features": [line, *points]}


def _cut_at_date_line(places: Sequence[tuple[float, float]]) -> list[list[list[float | None]]]:
    """Cut a line where it crosses 180 degrees, as RFC 7946 (3.1.9) wants it; mostly that is nowhere."""
    pieces = [[_rounded(places[0])]]
    for (lon, lat), (to_lon, to_lat) in pairwise(places):
        if abs(to_lon - lon) > 180.0:
            edge = 180.0 if lon > 0.0 else -180.0
            share = (edge - lon) / (to_lon + 2.0 * edge - lon)
            at = lat + share * (to_lat - lat)
            pieces[-1].append(_rounded((edge, at)))
            pieces.append([_rounded((-edge, at))])
        pieces[-1].append(_rounded((to_lon, to_lat)))
    return pieces


def _rounded(place: tuple[float, float]) -> list[float | None]:
    return [number(value, 6) for value in place]


def _box(places: Sequence[tuple[float, float]]) -> list[float | None]:
    """West, south, east and north; across the date line west is greater than east (RFC 7946, 5.2)."""
    lons, lats = [lon for lon, _ in places], [lat for _, lat in places]
    west, east = min(lons), max(lons)
    if east - west > 180.0:
        west, east = min(lon for lon in lons if lon >= 0.0), max(lon for lon in lons if lon < 0.0)
    return [number(value, 6) for value in (west, min(lats), east, max(lats))]


def write_geojson(passage: Passage, path: Path) -> None:
    """Write `geojson` to a file.

    Raises
    ------
    InputError
        The file cannot be written.
    """
    write_atomically(path, dumps(geojson(passage)) + "\n", what="GeoJSON file")
