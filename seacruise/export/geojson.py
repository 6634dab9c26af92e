"""GeoJSON (RFC 7946): the passage as a line and its waypoints as points, for map programs."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from seacruise.atomic import write_atomically
from seacruise.export.jsonform import dumps, number, passage_to_json
from seacruise.export.textform import NOTICE, title
from seacruise.passage import Passage


def geojson(passage: Passage) -> dict[str, Any]:
    """Feature collection: the line with the summary first, then a point a waypoint with its leg."""
    summary = passage_to_json(passage)
    waypoints = summary.pop("waypoints")
    line = {
        "type": "Feature",
        "geometry": {"type": "LineString", "coordinates": [[w["lon"], w["lat"]] for w in waypoints]},
        "properties": {"name": title(passage), "notice": NOTICE, **summary},
    }
    points = [
        {
            "type": "Feature",
            "geometry": {"type": "Point", "coordinates": [leg.pop("lon"), leg.pop("lat")]},
            "properties": {"number": index, **leg},
        }
        for index, leg in enumerate(waypoints)
    ]
    lats = [w.lat for w in passage.waypoints]
    lons = [w.lon for w in passage.waypoints]
    box = [number(value, 6) for value in (min(lons), min(lats), max(lons), max(lats))]
    return {"type": "FeatureCollection", "bbox": box, "features": [line, *points]}


def write_geojson(passage: Passage, path: Path) -> None:
    """Write `geojson` to a file.

    Raises
    ------
    InputError
        The file cannot be written.
    """
    write_atomically(path, dumps(geojson(passage)) + "\n", what="GeoJSON file")
