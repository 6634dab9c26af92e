"""What is reached, as JSON (schema ``seacruise.reach/1``), as a table and as GeoJSON."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path
from typing import Any

from seacruise.atomic import write_atomically
from seacruise.export.jsonform import dumps, forecast_to_json, format_time, number
from seacruise.export.textform import NOTICE, format_day_time, format_duration, format_forecast
from seacruise.geodesy import format_position
from seacruise.reach import SCHEMA, PortReached, Reach
from seacruise.routing.reach import Isochrone


def reach_to_json(reached: Reach) -> dict[str, Any]:
    """Put the answer into the object of the command line's contract."""
    return {
        "schema": SCHEMA,
        "start": {
            "name": reached.start.name,
            "lat": number(reached.start.lat, 6),
            "lon": number(reached.start.lon, 6),
        },
        "departure": format_time(reached.departure),
        "hours": number(reached.hours, 4),
        "stay_h": number(reached.stay_h, 4),
        "yacht": reached.yacht,
        "forecast": forecast_to_json(reached.forecast),
        "ports": [_port(port) for port in reached.ports],
        "unreachable": reached.unreachable,
    }


def _port(found: PortReached) -> dict[str, Any]:
    return {
        "name": found.port.name,
        "country": found.port.country,
        "lat": number(found.lat, 6),
        "lon": number(found.lon, 6),
        "distance_nm": number(found.distance_nm, 3),
        "out_h": number(found.out_h, 4),
        "arrival": format_time(found.arrival),
        "back_h": number(found.back_h, 4),
        "return_fits": found.return_fits,
        "leave_by": None if found.leave_by is None else format_time(found.leave_by),
        "beyond_forecast_h": number(found.beyond_forecast_h, 4),
        "resailed_h": number(found.resailed_h, 4),
        "land_free": found.land_free,
    }


def reach_to_text(reached: Reach, *, now: datetime) -> str:
    """Summary, table of the ports sorted by the time out, and notices.

    Parameters
    ----------
    now
        Timezone-aware; the age of the forecast is counted to it.
    """
    fits = sum(port.return_fits for port in reached.ports)
    there = format_position(reached.start.lat, reached.start.lon)
    head = f"{reached.start.name}, {format_duration(reached.hours)}"
    stay = f", with a stay of {format_duration(reached.stay_h)}" if reached.stay_h else ""
    rows = [
        ("Yacht", reached.yacht),
        ("From", f"{reached.start.name}, {there}"),
        ("Departure", f"{format_day_time(reached.departure)} UTC"),
        ("Out and back", f"{fits} ports fit{stay}" if fits != 1 else f"1 port fits{stay}"),
        ("Not in reach", f"{reached.unreachable} ports of the list"),
        ("Forecast", format_forecast(reached.forecast, now=now)),
    ]
    count = len(reached.ports)
    blocks = [
        f"{head}: {count} port{'' if count == 1 else 's'} in reach",
        "\n".join(f"  {label:<16} {text}" for label, text in rows),
    ]
    if reached.ports:
        blocks.append(_table(reached.ports))
    said = dict.fromkeys((*reached.notices, NOTICE))
    blocks.append("\n".join(f"! {notice}" for notice in said))
    return "\n\n".join(blocks)


def _table(ports: tuple[PortReached, ...]) -> str:
    width = max(len(port.port.name) for port in ports)
    head = f"{'Port':<{width}}      {'Dist':>8}  {'Out':>11}  {'Arrival (UTC)':<21}  {'Back':>11}  "
    lines = [f"{head}{'Leave by (UTC)':<21}  Out and back"]
    for found in ports:
        back = "" if found.back_h is None else format_duration(found.back_h)
        leave = "" if found.leave_by is None else format_day_time(found.leave_by)
        fits = "fits" if found.return_fits else "too long"
        late = (
            f", {found.beyond_forecast_h:.0f} h after the forecast" if found.beyond_forecast_h >= 0.5 else ""
        )
        lines.append(
            f"{found.port.name:<{width}}  {found.port.country:2}  {found.distance_nm:5.1f} nm  "
            f"{format_duration(found.out_h):>11}  {format_day_time(found.arrival):<21}  {back:>11}  "
            f"{leave:<21}  {fits}{late}"
        )
    return "\n".join(lines)


def reach_geojson(reached: Reach) -> dict[str, Any]:
    """Feature collection: the water reached within each time, the largest first, then the ports."""
    about = {
        "yacht": reached.yacht,
        "departure": format_time(reached.departure),
        "forecast": forecast_to_json(reached.forecast),
        "notice": NOTICE,
    }
    areas = [_area(line, about) for line in reversed(reached.isochrones) if line.polygons]
    start = {"name": reached.start.name, "out_h": 0.0}
    points = [_point(reached.start.lat, reached.start.lon, start)]
    for port in reached.ports:
        facts = _port(port)
        points.append(_point(facts.pop("lat"), facts.pop("lon"), facts))
    return {"type": "FeatureCollection", "features": [*areas, *points]}


def _point(lat: float, lon: float, properties: dict[str, Any]) -> dict[str, Any]:
    place = {"type": "Point", "coordinates": [number(lon, 6), number(lat, 6)]}
    return {"type": "Feature", "geometry": place, "properties": properties}


def _area(line: Isochrone, about: dict[str, Any]) -> dict[str, Any]:
    # Rings as they come: the outer one anticlockwise and its holes clockwise, as RFC 7946 wants them.
    coordinates = [
        [[[number(lon, 5), number(lat, 5)] for lat, lon in ring.tolist()] for ring in rings]
        for rings in line.polygons
    ]
    return {
        "type": "Feature",
        "geometry": {"type": "MultiPolygon", "coordinates": coordinates},
        "properties": {"hours": number(line.hours, 4), **about},
    }


def write_reach_geojson(reached: Reach, path: Path) -> None:
    """Write `reach_geojson` to a file.

    Raises
    ------
    InputError
        The file cannot be written.
    """
    write_atomically(path, dumps(reach_geojson(reached)) + "\n", what="GeoJSON file")
