"""A server that speaks Storm Glass, and misbehaves on demand: real sockets on the loopback interface.

In tests: ``with FaultServer("good") as server: ... server.url``. For the window and the command line::

    python tests/faultserver.py --port 0 --behaviour good

It prints its address, ``http://127.0.0.1:PORT``, and serves until it is stopped. Behaviours are listed in
`BEHAVIOURS`; several, separated by commas, are taken one after the other, and the last one stays.
"""

from __future__ import annotations

import argparse
import contextlib
import gzip
import json
import math
import socket
import ssl
import struct
import sys
import threading
import zlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from datetime import UTC, datetime, timedelta
from email.utils import format_datetime
from pathlib import Path
from types import TracebackType
from typing import Any
from urllib.parse import parse_qs, urlsplit

Document = dict[str, Any]


@dataclass(frozen=True)
class Request:
    """What arrived: the query's first values, and the headers in lower case."""

    path: str
    query: dict[str, str]
    headers: dict[str, str]


@dataclass
class FaultServer:
    """Serves on a free port of this machine between ``__enter__`` and ``__exit__``.

    ``quota`` requests are answered a day, then 402; ``slow_s`` is the pause of the behaviour ``slow``;
    ``body`` replaces the generated answer. ``make`` and ``behaviours`` are another service's answers and
    misbehaviours in place of Storm Glass's; ``tls`` makes the server speak TLS with its certificate.
    """

    behaviour: str = "good"
    quota: int = 10
    port: int = 0
    slow_s: float = 0.3
    body: bytes | None = None
    used: int = 0
    requests: list[Request] = field(default_factory=list)
    most_at_once: int = 0
    make: Callable[[Request], Any] | None = None
    behaviours: Mapping[str, Behaviour] | None = None
    tls: ssl.SSLContext | None = None

    def __post_init__(self) -> None:
        self.stopping = threading.Event()
        self._lock = threading.Lock()
        self._open = 0
        self._connections: list[socket.socket] = []
        self._threads: list[threading.Thread] = []
        self._listener = socket.create_server(("127.0.0.1", self.port), backlog=64)
        self.port = self._listener.getsockname()[1]

    @property
    def url(self) -> str:
        return f"http{'s' if self.tls else ''}://127.0.0.1:{self.port}"

    def __enter__(self) -> FaultServer:
        thread = threading.Thread(target=self._accept, daemon=True)
        thread.start()
        self._threads.append(thread)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.stopping.set()
        # a listener blocked in accept wakes up for a connection, not for close
        with socket.socket() as knock:
            knock.connect_ex(("127.0.0.1", self.port))
        self._threads[0].join(5)
        self._listener.close()
        with self._lock:
            connections = list(self._connections)
        for connection in connections:
            close(connection)
        for thread in self._threads[1:]:
            thread.join(5)

    def _accept(self) -> None:
        while True:
            connection, _ = self._listener.accept()
            if self.stopping.is_set():
                connection.close()
                return
            connection.settimeout(20)
            with self._lock:
                self._connections.append(connection)
            thread = threading.Thread(target=self._serve, args=(connection,), daemon=True)
            thread.start()
            self._threads.append(thread)

    def _serve(self, connection: socket.socket) -> None:
        with self._lock:
            self._open += 1
            self.most_at_once = max(self.most_at_once, self._open)
        try:
            if self.tls is not None:
                connection = self.tls.wrap_socket(connection, server_side=True)
                with self._lock:
                    self._connections.append(connection)
            with connection.makefile("rb") as reader:
                while (request := read_request(reader)) is not None:
                    with self._lock:
                        names = self.behaviour.split(",")
                        name = names[min(len(self.requests), len(names) - 1)]
                        self.requests.append(request)
                        self.used += 1
                        count = self.used
                    behaviour = (self.behaviours or BEHAVIOURS)[name]
                    if not behaviour(Exchange(self, connection, request, count)):
                        break
        except OSError:
            pass  # the other side went away, as it may
        finally:
            with self._lock:
                self._open -= 1
            close(connection)


def close(connection: socket.socket) -> None:
    with contextlib.suppress(OSError):
        connection.shutdown(socket.SHUT_RDWR)
    connection.close()


def read_request(reader: Any) -> Request | None:
    first = reader.readline(65536).decode("latin-1").split()
    if len(first) != 3:
        return None
    headers: dict[str, str] = {}
    while (line := reader.readline(65536).decode("latin-1").strip()) != "":
        name, _, value = line.partition(":")
        headers[name.lower()] = value.strip()
    parts = urlsplit(first[1])
    return Request(parts.path, {name: values[0] for name, values in parse_qs(parts.query).items()}, headers)


@dataclass(frozen=True)
class Exchange:
    """One request and the means to answer it."""

    server: FaultServer
    connection: socket.socket
    request: Request
    count: int

    def document(self) -> Any:
        """Make the right answer to the request, in the shape of 2026."""
        if self.server.make is not None:
            return self.server.make(self.request)
        query = self.request.query
        lat, lon = float(query["lat"]), float(query["lng"])
        begin, end = (datetime.fromtimestamp(float(query[name]), UTC) for name in ("start", "end"))
        hours = int((end - begin).total_seconds() // 3600)
        return {
            "hours": [hour_of(lat, lon, begin + timedelta(hours=number), number) for number in range(hours)],
            "meta": {
                "cost": 1,
                "dailyQuota": self.server.quota,
                "end": f"{end - timedelta(hours=1):%Y-%m-%d %H:%M}",
                "lat": lat,
                "lng": lon,
                "params": query.get("params", "").split(","),
                "requestCount": self.count,
                "start": f"{begin:%Y-%m-%d %H:%M}",
            },
        }

    def body(self) -> bytes:
        return self.server.body if self.server.body is not None else json.dumps(self.document()).encode()

    def send(
        self,
        body: bytes | Document | list[Any] | str,
        *,
        status: str = "200 OK",
        kind: str = "application/json; charset=utf-8",
        headers: str = "",
        length: int | None = None,
    ) -> bool:
        if isinstance(body, (dict, list)):
            body = json.dumps(body)
        if isinstance(body, str):
            body = body.encode()
        size = len(body) if length is None else length
        head = f"HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {size}\r\n{headers}\r\n"
        self.connection.sendall(head.encode("latin-1") + body)
        return length is None

    def raw(self, data: bytes) -> bool:
        """Send bytes as they are, and hang up."""
        self.connection.sendall(data)
        return False

    def reset(self) -> bool:
        """Break the connection so that the other side gets a reset, not an end."""
        self.connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        self.connection.close()
        return False


def hour_of(lat: float, lon: float, time: datetime, number: int) -> Document:
    """Make one hour: a wind that differs from place to place; ``sg`` is ecmwf for 6 days, then noaa."""
    speed = round(6.0 + 3.0 * math.sin(number / 17.0) + 0.2 * (lat - 55.0), 2)
    direction = round((220.0 + 1.3 * number + 2.0 * (lon - 18.0)) % 360.0, 2)
    models = {
        "ecmwf": (speed, direction),
        "noaa": (round(speed * 1.1, 2), round((direction + 8.0) % 360.0, 2)),
    }
    if number >= 144:
        del models["ecmwf"]
    models["sg"] = models.get("ecmwf", models["noaa"])
    return {
        "gust": {model: round(values[0] * 1.4, 2) for model, values in models.items()},
        "time": time.isoformat(),
        "windDirection": {model: values[1] for model, values in models.items()},
        "windSpeed": {model: values[0] for model, values in models.items()},
    }


Behaviour = Callable[[Exchange], bool]
"""Answers one request; tells whether the connection stays open for another."""


def good(exchange: Exchange) -> bool:
    if not exchange.request.headers.get("authorization"):
        return exchange.send({"errors": {"key": "API key is invalid"}}, status="403 Forbidden")
    if exchange.request.path != "/v2/weather/point":
        return exchange.send({"errors": {"path": "not found"}}, status="404 Not Found")
    if exchange.count > exchange.server.quota:
        return spent(exchange)
    return exchange.send(exchange.body())


def spent(exchange: Exchange) -> bool:
    meta = {"dailyQuota": exchange.server.quota, "requestCount": exchange.count}
    return exchange.send(
        {"errors": {"key": "API quota exceeded"}, "meta": meta}, status="402 Payment Required"
    )


def status(
    line: str, body: bytes | Document | str, kind: str = "application/json", headers: str = ""
) -> Behaviour:
    return lambda exchange: exchange.send(body, status=line, kind=kind, headers=headers)


def busy(retry_after: Callable[[], str] | None) -> Behaviour:
    def answer(exchange: Exchange) -> bool:
        headers = f"Retry-After: {retry_after()}\r\n" if retry_after else ""
        return exchange.send(
            {"errors": {"rate": "slow down"}}, status="429 Too Many Requests", headers=headers
        )

    return answer


def echo(line: str) -> Behaviour:
    """Send the key back, as a careless service might."""

    def answer(exchange: Exchange) -> bool:
        key = exchange.request.headers.get("authorization", "")
        return exchange.send(
            {"errors": {"windSpeed": [f"bad key {key}"], key: [key]}, "key": key}, status=line
        )

    return answer


def never(exchange: Exchange) -> bool:
    exchange.server.stopping.wait()
    return False


def slow(exchange: Exchange) -> bool:
    exchange.server.stopping.wait(exchange.server.slow_s)
    return good(exchange)


def drip(exchange: Exchange, head: bytes, text: bytes) -> bool:
    """Send a byte now and then: each arrives in time, all of them never do."""
    exchange.connection.sendall(head)
    for number in range(len(text)):
        if exchange.server.stopping.wait(0.05):
            break
        exchange.connection.sendall(text[number : number + 1])
    return False


def drip_body(exchange: Exchange) -> bool:
    body = exchange.body()
    return drip(
        exchange,
        f"HTTP/1.1 200 OK\r\nContent-Type: application/json\r\nContent-Length: {len(body)}\r\n\r\n".encode(),
        body,
    )


def truncated(exchange: Exchange) -> bool:
    body = exchange.body()
    return exchange.send(body[: len(body) // 2], length=len(body))


def chunked(ending: str) -> Behaviour:
    def answer(exchange: Exchange) -> bool:
        body = exchange.body()
        part = body if ending == "whole" else body[: len(body) // 2]
        head = b"HTTP/1.1 200 OK\r\nContent-Type: application/json\r\nTransfer-Encoding: chunked\r\n\r\n"
        exchange.connection.sendall(head + f"{len(part):x}\r\n".encode() + part + b"\r\n")
        if ending == "whole":
            exchange.connection.sendall(b"0\r\n\r\n")
        return ending == "whole"

    return answer


def reset_in_body(exchange: Exchange) -> bool:
    body = exchange.body()
    exchange.send(body[:2000], length=len(body))
    exchange.server.stopping.wait(0.05)
    return exchange.reset()


def packed(change: Callable[[bytes], bytes]) -> Behaviour:
    return lambda exchange: exchange.send(
        change(gzip.compress(exchange.body())), headers="Content-Encoding: gzip\r\n"
    )


def bomb(exchange: Exchange) -> bool:
    packer = zlib.compressobj(9, zlib.DEFLATED, zlib.MAX_WBITS | 16)
    body = b"".join(packer.compress(b" " * 1_000_000) for _ in range(60)) + packer.flush()
    return exchange.send(body, headers="Content-Encoding: gzip\r\n")


def changed(change: Callable[[Document], Any]) -> Behaviour:
    """Answer with a document that was changed in place, or replaced when ``change`` returns something."""

    def answer(exchange: Exchange) -> bool:
        document = exchange.document()
        replaced = change(document)
        return exchange.send(document if replaced is None else replaced)

    return answer


def each_hour(change: Callable[[Document, int], Any]) -> Behaviour:
    def change_all(document: Document) -> None:
        for number, hour in enumerate(document["hours"]):
            change(hour, number)

    return changed(change_all)


def text_for(old: str, new: str) -> Behaviour:
    """Answer with the first number of a wind speed replaced by text that JSON libraries disagree about."""

    def answer(exchange: Exchange) -> bool:
        document = exchange.document()
        document["hours"][3]["windSpeed"]["sg"] = old
        return exchange.send(json.dumps(document).replace(f'"{old}"', new))

    return answer


def no_model(names: tuple[str, ...], first: int) -> Behaviour:
    """Leave models out from an hour on."""

    def change(hour: Document, number: int) -> None:
        if number >= first:
            for parameter in ("windSpeed", "windDirection", "gust"):
                for name in names:
                    hour[parameter].pop(name, None)

    return each_hour(change)


def keep_hours(wanted: Callable[[int], bool]) -> Behaviour:
    def change(document: Document) -> None:
        document["hours"] = [hour for number, hour in enumerate(document["hours"]) if wanted(number)]

    return changed(change)


def set_time(form: Callable[[datetime], str]) -> Behaviour:
    return each_hour(lambda hour, _: hour.update(time=form(datetime.fromisoformat(hour["time"]))))


def set_wind(parameter: str, value: Callable[[int], Any], model: str = "sg") -> Behaviour:
    return each_hour(lambda hour, number: hour[parameter].update({model: value(number)}))


def duplicated(document: Document) -> None:
    document["hours"] = [hour for hour in document["hours"] for _ in range(2)]


def another_place(document: Document) -> None:
    document["meta"].update(lat=-30.0, lng=150.0)


def more_told(hour: Document, number: int) -> None:
    """Add waves and a current, which sets to the north; the sea has none at every seventh hour."""
    known = number % 7 != 3
    hour["waveHeight"] = {"sg": 1.5, "meteo": 1.4} if known else {}
    hour["currentSpeed"] = {"sg": 0.3, "meto": 0.3}
    hour["currentDirection"] = {"sg": 180.0, "meto": 180.0}


def odd_extras(hour: Document, number: int) -> None:
    hour.update(gust="strong", waveHeight=["?"], currentSpeed={"sg": "fast"}, currentDirection={"sg": None})


def encoded(codec: str) -> Behaviour:
    return lambda exchange: exchange.send(exchange.body().decode().encode(codec))


def with_headers(headers: str, kind: str = "application/json") -> Behaviour:
    return lambda exchange: exchange.send(exchange.body(), headers=headers, kind=kind)


def early_hints(exchange: Exchange) -> bool:
    exchange.connection.sendall(b"HTTP/1.1 103 Early Hints\r\nLink: <x>; rel=preload\r\n\r\n")
    return good(exchange)


def reset_after_head(exchange: Exchange) -> bool:
    exchange.send(b"", length=len(exchange.body()))
    exchange.server.stopping.wait(0.05)
    return exchange.reset()


PAGE = "<!DOCTYPE html><html><body>Welcome to Marina WiFi. Please sign in.</body></html>"

BEHAVIOURS: dict[str, Behaviour] = {
    "good": good,
    "slow": slow,
    "402": spent,
    "401": status("401 Unauthorized", {"errors": {"key": "API key is invalid"}}),
    "403": status("403 Forbidden", {"errors": {"key": "API key is invalid"}}),
    "404": status("404 Not Found", "{}"),
    "407": status("407 Proxy Authentication Required", ""),
    "410": status("410 Gone", "{}"),
    "422": status("422 Unprocessable Entity", {"errors": {"windSpeed": ["is not known"]}}),
    "422-text": status("422 Unprocessable Entity", "no JSON at all"),
    "429": busy(None),
    "429-seconds": busy(lambda: "0"),
    "429-date": busy(lambda: format_datetime(datetime.now(UTC) + timedelta(hours=3), usegmt=True)),
    "429-day": busy(lambda: "86400"),
    "429-nonsense": busy(lambda: "soon"),
    "500": status("500 Internal Server Error", "oops", "text/plain"),
    "502": status("502 Bad Gateway", PAGE, "text/html"),
    "503": status("503 Service Unavailable", "{}"),
    "echo-422": echo("422 Unprocessable Entity"),
    "echo-500": echo("500 Internal Server Error"),
    "echo-200": echo("200 OK"),
    "timeout": never,
    "drip": drip_body,
    "drip-head": lambda exchange: drip(exchange, b"", b"HTTP/1.1 200 OK\r\nX-Slow: " + b"x" * 4000),
    "reset": lambda exchange: exchange.reset(),
    "hang-up": lambda exchange: False,
    "reset-body": reset_in_body,
    "truncated": truncated,
    "chunked": chunked("whole"),
    "chunked-short": chunked("short"),
    "garbage": lambda exchange: exchange.send(bytes(range(256)) * 20, kind="application/json"),
    "not-http": lambda exchange: exchange.raw(b"\x16\x03\x01 this is not HTTP\r\n\r\n"),
    "gzip": packed(lambda body: body),
    "gzip-corrupt": packed(lambda body: body[:100] + b"\x00" * 50 + body[150:]),
    "gzip-short": packed(lambda body: body[: len(body) // 2]),
    "gzip-bomb": bomb,
    "big": lambda exchange: exchange.send(b" " * 6_000_000 + b"{}"),
    "empty": lambda exchange: exchange.send(b""),
    "204": lambda exchange: exchange.raw(b"HTTP/1.1 204 No Content\r\n\r\n"),
    "redirect": lambda exchange: exchange.send(
        b"", status="302 Found", headers=f"Location: {exchange.server.url}/login\r\n"
    ),
    "redirect-away": status("301 Moved Permanently", "", headers="Location: https://example.invalid/\r\n"),
    "redirect-loop": lambda exchange: exchange.send(
        b"", status="307 Temporary Redirect", headers=f"Location: {exchange.request.path}\r\n"
    ),
    "portal": lambda exchange: exchange.send(PAGE, kind="text/html"),
    "portal-as-json": lambda exchange: exchange.send(PAGE),
    "stream-error": lambda exchange: exchange.send(
        exchange.body()[:5000] + b"Unexpected error while streaming data"
    ),
    "nan": text_for("X", "NaN"),
    "infinity": text_for("X", "Infinity"),
    "1e999": text_for("X", "1e999"),
    "string-number": set_wind("windSpeed", lambda number: "6.5"),
    "deep": lambda exchange: exchange.send(b"[" * 100_000),
    "list": lambda exchange: exchange.send(b"[]"),
    "twice-the-key": lambda exchange: exchange.send(
        exchange.body().replace(b'{"hours"', b'{"hours": [], "hours"', 1)
    ),
    "no-hours": changed(lambda document: document.pop("hours") and None),
    "empty-hours": changed(lambda document: document.update(hours=[])),
    "null": set_wind("windSpeed", lambda number: None if number % 7 == 3 else 6.0),
    "all-null": each_hour(lambda hour, _: hour.update(windSpeed=dict.fromkeys(hour["windSpeed"]))),
    "no-direction": each_hour(lambda hour, _: hour.pop("windDirection")),
    "some-without-direction": each_hour(
        lambda hour, number: hour.pop("windDirection") if number % 5 == 2 else None
    ),
    "no-sg": no_model(("sg",), 0),
    "sg-ends": no_model(("sg",), 100),
    "all-end": no_model(("sg", "noaa", "ecmwf"), 60),
    "new-model": each_hour(lambda hour, _: hour["windSpeed"].update({"x:y": 5.0})),
    "duplicates": changed(duplicated),
    "unsorted": changed(lambda document: document["hours"].reverse()),
    "three-hourly": keep_hours(lambda number: number % 3 == 0),
    "one-hole": keep_hours(lambda number: number != 30),
    "long-hole": keep_hours(lambda number: not 80 <= number < 100),
    "short": keep_hours(lambda number: number < 10),
    "no-zone": set_time(lambda time: time.replace(tzinfo=None).isoformat()),
    "other-zone": set_time(
        lambda time: (time + timedelta(hours=2)).replace(tzinfo=None).isoformat() + "+02:00"
    ),
    "not-a-time": set_time(lambda time: "yesterday"),
    "last-year": set_time(lambda time: (time - timedelta(days=365)).isoformat()),
    "negative": set_wind("windSpeed", lambda number: -1.0 if number == 5 else 6.0),
    "gale-400": set_wind("windSpeed", lambda number: 400.0),
    "direction-360": set_wind("windDirection", lambda number: 360.0),
    "direction-below": set_wind("windDirection", lambda number: -10.0),
    "direction-725": set_wind("windDirection", lambda number: 725.0 if number == 5 else 90.0),
    "direction-9999": set_wind("windDirection", lambda number: 9999.0 if number == 5 else 90.0),
    "no-meta": changed(lambda document: document.pop("meta") and None),
    "odd-meta": changed(lambda document: document.update(meta=["?"])),
    "another-place": changed(another_place),
    "nan-text": set_wind("windSpeed", lambda number: "NaN"),
    "null-hour": changed(lambda document: document["hours"].insert(3, None)),
    "hours-by-name": changed(lambda document: document.update(hours={"0": document["hours"][0]})),
    "no-time": each_hour(lambda hour, _: hour.pop("time")),
    "odd-names": each_hour(
        lambda hour, _: hour["windSpeed"].update({"моdель ☃\u202e": 5.0, "x\r\nHost: y": 5.0, "": 5.0})
    ),
    "more-told": each_hour(more_told),
    "odd-extras": each_hour(odd_extras),
    "tomorrow": set_time(lambda time: (time + timedelta(days=1)).isoformat()),
    "next-month": set_time(lambda time: (time + timedelta(days=30)).isoformat()),
    "half-hours": set_time(lambda time: (time + timedelta(minutes=30)).isoformat()),
    "bom": encoded("utf-8-sig"),
    "utf-16": encoded("utf-16"),
    "text-after": lambda exchange: exchange.send(exchange.body() + b"<!-- cached -->"),
    "gzip-lie": with_headers("Content-Encoding: gzip\r\n"),
    "brotli-lie": with_headers("Content-Encoding: br\r\n"),
    "octets": with_headers("", kind="application/octet-stream"),
    "no-type": with_headers("", kind=""),
    "length-short": lambda exchange: exchange.send(exchange.body(), length=1000),
    "early-hints": early_hints,
    "reset-after-head": reset_after_head,
    "login": lambda exchange: exchange.send(
        PAGE, status="303 See Other", kind="text/html", headers="Location: http://login.invalid/?next=/\r\n"
    ),
}


def main() -> int:
    parser = argparse.ArgumentParser(description="A Storm Glass that misbehaves on demand.")
    parser.add_argument("--port", type=int, default=0)
    parser.add_argument(
        "--behaviour", default="good", help="one or more, separated by commas: " + ", ".join(BEHAVIOURS)
    )
    parser.add_argument("--quota", type=int, default=10)
    parser.add_argument("--slow", type=float, default=0.3, help="pause of the behaviour 'slow' [s]")
    parser.add_argument("--body", type=Path, help="answer with this file instead")
    arguments = parser.parse_args()
    unknown = set(arguments.behaviour.split(",")) - set(BEHAVIOURS)
    if unknown:
        parser.error(f"unknown behaviour {', '.join(sorted(unknown))}")
    body = arguments.body.read_bytes() if arguments.body else None
    with FaultServer(
        arguments.behaviour, quota=arguments.quota, port=arguments.port, slow_s=arguments.slow, body=body
    ) as server:
        sys.stdout.write(server.url + "\n")
        sys.stdout.flush()
        with contextlib.suppress(KeyboardInterrupt):
            server.stopping.wait()
    return 0


if __name__ == "__main__":
    sys.exit(main())
