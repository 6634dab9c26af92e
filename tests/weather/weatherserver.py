"""Open-Meteo and MET Norway as the fault server speaks them, rightly and wrongly.

In tests: ``with open_meteo("good", today=TODAY) as server: ... server.url``. For the window and the command
line::

    python tests/weather/weatherserver.py open-meteo --behaviour good
"""

from __future__ import annotations

import argparse
import contextlib
import json
import math
import sys
from collections.abc import Callable
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from tests.faultserver import BEHAVIOURS, Behaviour, Exchange, FaultServer, Request, status

Location = dict[str, Any]

LAST_MODIFIED = "Sat, 21 Nov 2026 08:41:17 GMT"
MEMBERS = 5

TRANSPORT = (
    "404", "407", "410", "429", "429-seconds", "429-date", "429-day", "429-nonsense", "500", "502", "503",
    "timeout", "drip", "drip-head", "reset", "hang-up", "reset-body", "truncated", "chunked",
    "chunked-short", "garbage", "not-http", "gzip", "gzip-corrupt", "gzip-short", "gzip-bomb", "big",
    "empty", "204", "redirect", "redirect-away", "redirect-loop", "portal", "portal-as-json",
    "stream-error", "deep", "list",
)  # fmt: skip
"""What goes wrong between here and there, which is the same for every service."""


def wind_at(lat: float, lon: float, hour: float, member: int = 0) -> tuple[float, float]:
    """Speed [m/s] and direction FROM [degrees]: differs from place to place and hour to hour."""
    speed = 6.0 + 3.0 * math.sin(hour / 17.0) + 0.2 * (lat - 55.0) + 0.3 * member
    return round(speed, 2), round((220.0 + 1.3 * hour + 2.0 * (lon - 18.0) + 4.0 * member) % 360.0, 1)


# --- Open-Meteo -----------------------------------------------------------------------------------


def location_of(request: Request, lat: float, lon: float, begin: datetime) -> Location:
    """Make one place's answer to what was asked, in the units that were asked for."""
    query = request.query
    hours = 24 * int(query.get("forecast_days", "7"))
    if query.get("timeformat") == "unixtime":
        times: list[Any] = [int(begin.timestamp()) + 3600 * hour for hour in range(hours)]
    else:
        times = [f"{begin + timedelta(hours=hour):%Y-%m-%dT%H:%M}" for hour in range(hours)]
    in_ms = query.get("wind_speed_unit") == "ms"
    factor, unit = (1.0, "m/s") if in_ms else (3.6, "km/h")
    units = {"time": query.get("timeformat", "iso8601")}
    columns: dict[str, list[Any]] = {"time": times}
    members = range(MEMBERS) if request.path.endswith("ensemble") else range(1)
    for name in query["hourly"].split(","):
        for member in members:
            key = name if member == 0 else f"{name}_member{member:02d}"
            winds = [wind_at(lat, lon, hour, member) for hour in range(hours)]
            units[key] = unit
            if name == "wind_speed_10m":
                columns[key] = [round(speed * factor, 2) for speed, _ in winds]
            elif name == "wind_gusts_10m":
                columns[key] = [round(speed * 1.4 * factor, 2) for speed, _ in winds]
            elif name == "wind_direction_10m":
                columns[key], units[key] = [direction for _, direction in winds], "°"
            elif name == "wave_height":
                columns[key], units[key] = [round(0.2 * speed, 2) for speed, _ in winds], "m"
            elif name == "ocean_current_velocity":
                columns[key] = [round(0.3 * factor, 2)] * hours
            else:
                columns[key], units[key] = [90.0] * hours, "°"
    return {
        "latitude": round(lat * 8) / 8,
        "longitude": round(lon * 8) / 8,
        "generationtime_ms": 0.3,
        "utc_offset_seconds": 0,
        "timezone": "GMT",
        "timezone_abbreviation": "GMT",
        "elevation": 0.0,
        "hourly_units": units,
        "hourly": columns,
    }


def open_meteo_document(today: datetime | None) -> Callable[[Request], Any]:
    """Make answers that begin on a day, by default the real one: an object, or an array for several."""

    def make(request: Request) -> Any:
        begin = today or datetime.now(UTC).replace(hour=0, minute=0, second=0, microsecond=0)
        lats, lons = (request.query[name].split(",") for name in ("latitude", "longitude"))
        locations = [
            location_of(request, float(lat), float(lon), begin) for lat, lon in zip(lats, lons, strict=True)
        ]
        return locations[0] if len(locations) == 1 else locations

    return make


def open_meteo_good(exchange: Exchange) -> bool:
    if exchange.request.path not in {"/v1/forecast", "/v1/marine", "/v1/ensemble"}:
        return exchange.send({"error": True, "reason": "Not Found"}, status="404 Not Found")
    return exchange.send(exchange.body())


def slow(exchange: Exchange) -> bool:
    exchange.server.stopping.wait(exchange.server.slow_s)
    return open_meteo_good(exchange)


def reason(line: str, text: str) -> Behaviour:
    return status(line, {"error": True, "reason": text})


def each(change: Callable[[Location], Any]) -> Behaviour:
    """Answer with every place changed in place."""

    def answer(exchange: Exchange) -> bool:
        document = exchange.document()
        for location in document if isinstance(document, list) else [document]:
            change(location)
        return exchange.send(document)

    return answer


def values(prefix: str, value: Callable[[int, Any], Any]) -> Behaviour:
    """Answer with every column of a kind changed, value by value; its hour is told."""

    def change(location: Location) -> None:
        for name, column in location["hourly"].items():
            if name.startswith(prefix):
                location["hourly"][name] = [value(hour, old) for hour, old in enumerate(column)]

    return each(change)


def hours(pick: Callable[[list[Any]], list[Any]]) -> Behaviour:
    """Answer with other hours: dropped, doubled, in another order."""

    def change(location: Location) -> None:
        for name, column in location["hourly"].items():
            location["hourly"][name] = pick(column)

    return each(change)


def without(prefix: str) -> Behaviour:
    def change(location: Location) -> None:
        for name in [name for name in location["hourly"] if name.startswith(prefix)]:
            del location["hourly"][name]

    return each(change)


def in_unit(unit: str | None, factor: float) -> Behaviour:
    """Deliver speeds in another unit, and say so."""

    def change(location: Location) -> None:
        for name, column in location["hourly"].items():
            if location["hourly_units"].get(name) == "m/s":
                location["hourly"][name] = [round(value * factor, 3) for value in column]
                if unit is None:
                    del location["hourly_units"][name]
                else:
                    location["hourly_units"][name] = unit

    return each(change)


def times(form: Callable[[datetime], Any], offset: int = 0) -> Behaviour:
    def change(location: Location) -> None:
        column = location["hourly"]["time"]
        location["hourly"]["time"] = [form(datetime.fromtimestamp(time, UTC)) for time in column]
        location["utc_offset_seconds"] = offset

    return each(change)


def number(text: str) -> Behaviour:
    """Answer with a number of the first speed that JSON libraries disagree about."""

    def answer(exchange: Exchange) -> bool:
        document = exchange.document()
        first = document[0] if isinstance(document, list) else document
        name = "wind_speed_10m" if "wind_speed_10m" in first["hourly"] else "wave_height"
        first["hourly"][name][3] = "X"
        return exchange.send(json.dumps(document).replace('"X"', text))

    return answer


def only(path: str, fault: Behaviour) -> Behaviour:
    """Misbehave at one endpoint, and be good at the others."""

    def answer(exchange: Exchange) -> bool:
        here = exchange.request.path.endswith(path)
        return fault(exchange) if here else open_meteo_good(exchange)

    return answer


def doubled_key(exchange: Exchange) -> bool:
    return exchange.send(exchange.body().replace(b'{"latitude"', b'{"latitude": 1.0, "latitude"'))


def moved(location: Location) -> None:
    location.update(latitude=-30.0, longitude=150.0)


def one_too_few(exchange: Exchange) -> bool:
    document = exchange.document()
    return exchange.send(document[:-1] if isinstance(document, list) else [])


def object_for_array(exchange: Exchange) -> bool:
    document = exchange.document()
    return exchange.send(document[0] if isinstance(document, list) else document)


def array_for_object(exchange: Exchange) -> bool:
    document = exchange.document()
    return exchange.send(document if isinstance(document, list) else [document])


def ragged(location: Location) -> None:
    for name in location["hourly"]:
        if name != "time":
            location["hourly"][name].pop()


def one_ends_early(exchange: Exchange) -> bool:
    """Leave the last place without values after two days."""
    document = exchange.document()
    columns = document[-1]["hourly"]
    for name in columns:
        if name != "time":
            columns[name] = [value if hour < 48 else None for hour, value in enumerate(columns[name])]
    return exchange.send(document)


LIMIT = "API request limit exceeded. Please try again"
OPEN_METEO: dict[str, Behaviour] = {
    **{name: BEHAVIOURS[name] for name in TRANSPORT},
    "good": open_meteo_good,
    "slow": slow,
    "400": reason("400 Bad Request", "Parameter 'start_date' is out of allowed range"),
    "400-no-data": reason("400 Bad Request", "No data is available for this location"),
    "400-text": status("400 Bad Request", "no JSON \x1b[31m at all"),
    "401": reason("401 Unauthorized", "Unauthorized"),
    "403": reason("403 Forbidden", "The supplied API key is invalid"),
    "429-minutely": reason("429 Too Many Requests", f"Minutely {LIMIT} in one minute."),
    "429-hourly": reason("429 Too Many Requests", f"Hourly {LIMIT} in the next hour."),
    "429-daily": reason("429 Too Many Requests", f"Daily {LIMIT} tomorrow."),
    "429-concurrent": reason("429 Too Many Requests", "Too many concurrent requests"),
    "503-reason": reason("503 Service Unavailable", "The service is overloaded"),
    "200-error": reason("200 OK", "Something went wrong inside"),
    "nan": number("NaN"),
    "infinity": number("Infinity"),
    "1e999": number("1e999"),
    "string-number": number('"6.5"'),
    "null": values("w", lambda hour, old: None if hour % 7 == 3 else old),
    "all-null": values("w", lambda hour, old: None),
    "null-end": values("w", lambda hour, old: None if hour >= 100 else old),
    "one-ends-early": only("forecast", one_ends_early),
    "gusts-end": values("wind_gusts", lambda hour, old: None if hour >= 60 else old),
    "waves-end": values("wave", lambda hour, old: None if hour >= 60 else old),
    "no-hourly": each(lambda location: location.pop("hourly")),
    "no-units": each(lambda location: location.pop("hourly_units")),
    "empty-hours": hours(lambda column: []),
    "no-time": without("time"),
    "no-speed": without("wind_speed"),
    "no-direction": without("wind_direction"),
    "some-without-direction": values("wind_direction", lambda hour, old: None if hour % 5 == 2 else old),
    "no-gusts": without("wind_gusts"),
    "new-column": each(lambda location: location["hourly"].update({"x:y": ["?"]})),
    "duplicates": hours(lambda column: [value for value in column for _ in range(2)]),
    "unsorted": hours(lambda column: column[::-1]),
    "three-hourly": hours(lambda column: column[::3]),
    "one-hole": hours(lambda column: column[:30] + column[31:]),
    "long-hole": hours(lambda column: column[:80] + column[100:]),
    "short": hours(lambda column: column[:20]),
    "no-zone": times(lambda time: f"{time:%Y-%m-%dT%H:%M}"),
    "other-zone": times(lambda time: f"{time + timedelta(hours=2):%Y-%m-%dT%H:%M}+02:00"),
    "local-zone": times(lambda time: f"{time + timedelta(hours=2):%Y-%m-%dT%H:%M}", offset=7200),
    "not-a-time": times(lambda time: "yesterday"),
    "last-year": times(lambda time: int(time.timestamp()) - 365 * 86400),
    "milliseconds": times(lambda time: int(time.timestamp() * 1000)),
    "negative": values("wind_speed", lambda hour, old: -1.0 if hour == 5 else old),
    "gale-400": values("wind_speed", lambda hour, old: 400.0),
    "direction-360": values("wind_direction", lambda hour, old: 360.0),
    "direction-below": values("wind_direction", lambda hour, old: -10.0),
    "direction-725": values("wind_direction", lambda hour, old: 725.0 if hour == 5 else old),
    "direction-9999": values("wind_direction", lambda hour, old: 9999.0 if hour == 5 else old),
    "no-place": each(lambda location: location.pop("latitude")),
    "another-place": each(moved),
    "twice-the-key": doubled_key,
    "ragged": each(ragged),
    "kmh": in_unit("km/h", 3.6),
    "knots": in_unit("kn", 3600 / 1852),
    "unknown-unit": in_unit("furlong/fortnight", 1.0),
    "unsaid-unit": in_unit(None, 1.0),
    "one-too-few": one_too_few,
    "object-for-array": object_for_array,
    "array-for-object": array_for_object,
    "marine-503": only("marine", BEHAVIOURS["503"]),
    "marine-null": only("marine", values("", lambda hour, old: old if isinstance(old, int) else None)),
    "marine-garbage": only("marine", BEHAVIOURS["garbage"]),
    "no-members": only("ensemble", without("wind_speed_10m_member")),
    "lost-member": only("ensemble", without("wind_speed_10m_member03")),
}  # fmt: skip


def open_meteo(behaviour: str = "good", *, today: datetime | None = None, **options: Any) -> FaultServer:
    """Make an Open-Meteo that misbehaves."""
    make = open_meteo_document(today)
    return FaultServer(behaviour, make=make, behaviours=OPEN_METEO, **options)


# --- MET Norway -----------------------------------------------------------------------------------


def met_norway_document(now: datetime | None) -> Callable[[Request], Any]:
    """Make answers that begin at an hour, by default this one: 60 hourly steps, then six-hourly ones."""

    def make(request: Request) -> Any:
        begin = (now or datetime.now(UTC)).replace(minute=0, second=0, microsecond=0)
        lat, lon = float(request.query["lat"]), float(request.query["lon"])
        steps = [*range(60), *range(60, 240, 6)]
        return {
            "type": "Feature",
            "geometry": {"type": "Point", "coordinates": [lon, lat, 0]},
            "properties": {
                "meta": {
                    "updated_at": f"{begin:%Y-%m-%dT%H:%M:%SZ}",
                    "units": {
                        "air_temperature": "celsius",
                        "wind_from_direction": "degrees",
                        "wind_speed": "m/s",
                        "wind_speed_of_gust": "m/s",
                    },
                },
                "timeseries": [step_of(lat, lon, hour, begin) for hour in steps],
            },
        }

    return make


def step_of(lat: float, lon: float, hour: int, begin: datetime) -> dict[str, Any]:
    speed, direction = wind_at(lat, lon, hour)
    details = {"air_temperature": 5.0, "wind_speed": speed, "wind_from_direction": direction}
    if hour < 60:
        details["wind_speed_of_gust"] = round(speed * 1.4, 2)
    time = begin + timedelta(hours=hour)
    return {"time": f"{time:%Y-%m-%dT%H:%M:%SZ}", "data": {"instant": {"details": details}}}


def met_norway_good(exchange: Exchange) -> bool:
    """Answer as the service does: only those who say who they are, 304 where nothing has changed."""
    headers, query = exchange.request.headers, exchange.request.query
    named = "SeaCruise/" in headers.get("user-agent", "")
    if not named or any(len(query[name].partition(".")[2]) > 4 for name in ("lat", "lon")):
        return exchange.send("", status="403 Forbidden", kind="text/html")
    if headers.get("if-modified-since") == LAST_MODIFIED:
        return exchange.raw(b"HTTP/1.1 304 Not Modified\r\nExpires: " + EXPIRES.encode() + b"\r\n\r\n")
    return exchange.send(exchange.body(), headers=CACHING)


EXPIRES = "Sat, 21 Nov 2026 10:12:44 GMT"
CACHING = f"Expires: {EXPIRES}\r\nLast-Modified: {LAST_MODIFIED}\r\n"


def deprecated(exchange: Exchange) -> bool:
    return exchange.send(exchange.body(), status="203 Non-Authoritative Information", headers=CACHING)


def steps(pick: Callable[[list[Any]], list[Any]]) -> Behaviour:
    def answer(exchange: Exchange) -> bool:
        document = exchange.document()
        document["properties"]["timeseries"] = pick(document["properties"]["timeseries"])
        return exchange.send(document)

    return answer


def each_step(change: Callable[[dict[str, Any], int], Any]) -> Behaviour:
    def pick(series: list[Any]) -> list[Any]:
        for place, step in enumerate(series):
            change(step, place)
        return series

    return steps(pick)


def details(name: str, value: Callable[[int], Any]) -> Behaviour:
    return each_step(lambda step, place: step["data"]["instant"]["details"].update({name: value(place)}))


def no_detail(name: str) -> Behaviour:
    return each_step(lambda step, place: step["data"]["instant"]["details"].pop(name, None))


def written(form: Callable[[datetime], str]) -> Behaviour:
    return each_step(lambda step, place: step.update(time=form(datetime.fromisoformat(step["time"]))))


def met_number(text: str) -> Behaviour:
    def answer(exchange: Exchange) -> bool:
        document = exchange.document()
        document["properties"]["timeseries"][3]["data"]["instant"]["details"]["wind_speed"] = "X"
        return exchange.send(json.dumps(document).replace('"X"', text))

    return answer


def met_document(change: Callable[[Any], Any]) -> Behaviour:
    def answer(exchange: Exchange) -> bool:
        document = exchange.document()
        change(document)
        return exchange.send(document)

    return answer


MET_NORWAY: dict[str, Behaviour] = {
    **{name: BEHAVIOURS[name] for name in TRANSPORT},
    "good": met_norway_good,
    "203": deprecated,
    "400": status("400 Bad Request", "", "text/html"),
    "401": status("401 Unauthorized", "", "text/html"),
    "403": status("403 Forbidden", "<html>Forbidden</html>", "text/html"),
    "422": status("422 Unprocessable Entity", "", "text/html"),
    "429-page": status("429 Too Many Requests", "<html>Slow down</html>", "text/html"),
    "304-at-once": lambda exchange: exchange.raw(b"HTTP/1.1 304 Not Modified\r\n\r\n"),
    "no-caching": lambda exchange: exchange.send(exchange.body()),
    "odd-caching": lambda exchange: exchange.send(exchange.body(), headers="Expires: soon\r\n"),
    "nan": met_number("NaN"),
    "infinity": met_number("Infinity"),
    "1e999": met_number("1e999"),
    "string-number": met_number('"6.5"'),
    "null": details("wind_speed", lambda place: None if place % 7 == 3 else 6.0),
    "all-null": details("wind_speed", lambda place: None),
    "no-series": met_document(lambda document: document["properties"].pop("timeseries")),
    "empty-series": steps(lambda series: []),
    "no-meta": met_document(lambda document: document["properties"].pop("meta")),
    "no-place": met_document(lambda document: document["geometry"].update(coordinates=[])),
    "another-place": met_document(lambda document: document["geometry"].update(coordinates=[150.0, -30.0])),
    "no-direction": no_detail("wind_from_direction"),
    "some-without-direction": each_step(
        lambda step, place: place % 5 == 2 and step["data"]["instant"]["details"].pop("wind_from_direction")
    ),
    "no-gusts": no_detail("wind_speed_of_gust"),
    "duplicates": steps(lambda series: [step for step in series for _ in range(2)]),
    "unsorted": steps(lambda series: series[::-1]),
    "three-hourly": steps(lambda series: series[::3]),
    "one-hole": steps(lambda series: series[:30] + series[31:]),
    "long-hole": steps(lambda series: series[:40] + series[70:]),
    "short": steps(lambda series: series[:20]),
    "no-zone": written(lambda time: f"{time:%Y-%m-%dT%H:%M:%S}"),
    "other-zone": written(lambda time: f"{time + timedelta(hours=2):%Y-%m-%dT%H:%M:%S}+02:00"),
    "not-a-time": written(lambda time: "yesterday"),
    "last-year": written(lambda time: f"{time - timedelta(days=365):%Y-%m-%dT%H:%M:%SZ}"),
    "negative": details("wind_speed", lambda place: -1.0 if place == 5 else 6.0),
    "gale-400": details("wind_speed", lambda place: 400.0),
    "direction-360": details("wind_from_direction", lambda place: 360.0),
    "direction-below": details("wind_from_direction", lambda place: -10.0),
    "direction-9999": details("wind_from_direction", lambda place: 9999.0 if place == 5 else 90.0),
    "knots": met_document(lambda document: document["properties"]["meta"]["units"].update(wind_speed="kn")),
    "unsaid-unit": met_document(lambda document: document["properties"]["meta"]["units"].pop("wind_speed")),
    "twice-the-key": lambda exchange: exchange.send(
        exchange.body().replace(b'{"type"', b'{"type": 7, "type"', 1)
    ),
}


def met_norway(behaviour: str = "good", *, now: datetime | None = None, **options: Any) -> FaultServer:
    """Make a MET Norway that misbehaves."""
    make = met_norway_document(now)
    return FaultServer(behaviour, make=make, behaviours=MET_NORWAY, **options)


def main() -> int:
    services = {"open-meteo": (open_meteo, OPEN_METEO), "metno": (met_norway, MET_NORWAY)}
    parser = argparse.ArgumentParser(description="A weather service that misbehaves on demand.")
    parser.add_argument("service", choices=services)
    parser.add_argument("--port", type=int, default=0)
    parser.add_argument("--behaviour", default="good", help="one or more, separated by commas")
    arguments = parser.parse_args()
    make, known = services[arguments.service]
    unknown = set(arguments.behaviour.split(",")) - set(known)
    if unknown:
        parser.error(f"unknown behaviour {', '.join(sorted(unknown))}; there are {', '.join(known)}")
    with make(arguments.behaviour, port=arguments.port) as server:
        sys.stdout.write(server.url + "\n")
        sys.stdout.flush()
        with contextlib.suppress(KeyboardInterrupt):
            server.stopping.wait()
    return 0


if __name__ == "__main__":
    sys.exit(main())
