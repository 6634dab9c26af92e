"""What Storm Glass answered, and how many requests are left today: both outlive the program.

Neither holds the key, only the hash that tells keys apart.
"""

from __future__ import annotations

import hashlib
import sqlite3
import zlib
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, Final

from seacruise.store import Store, StoreError
from seacruise.weather.grids import Box
from seacruise.weather.point import PointAnswer, pack, unpack

FREE_PLAN_QUOTA: Final = 10
"""Requests a day of the free plan; assumed until the service tells another number."""

KEPT_S: Final = 10 * 86400.0
"""Answers reach ten days ahead; older ones are thrown away [s]."""

MAX_BYTES: Final = 32_000_000
"""Size of all answers together; beyond it the oldest go: some 2,500 of ten days."""

OVERTAKING: Final = 5
"""Answers that may overtake one another at least; a count that is lower by more is of the service's new
day."""

_STEPS: Final = (
    """CREATE TABLE weather_answer (
        place TEXT NOT NULL, service TEXT NOT NULL, fetched REAL NOT NULL,
        checksum INTEGER NOT NULL, body BLOB NOT NULL, PRIMARY KEY (place, service))""",
    """CREATE TABLE weather_quota (
        key_hash TEXT NOT NULL, day TEXT NOT NULL, used INTEGER NOT NULL, daily INTEGER NOT NULL,
        PRIMARY KEY (key_hash, day))""",
    # bodies lie in a table of their own, so that looking through a thousand answers reads a few pages
    """CREATE TABLE weather_forecast (
        id INTEGER PRIMARY KEY, service TEXT NOT NULL, place TEXT NOT NULL, run REAL NOT NULL,
        lat REAL NOT NULL, lon REAL NOT NULL, fetched REAL NOT NULL, expires REAL, last REAL,
        size INTEGER NOT NULL, UNIQUE (service, place, run))""",
    """CREATE TABLE weather_body (
        id INTEGER PRIMARY KEY REFERENCES weather_forecast (id) ON DELETE CASCADE,
        checksum INTEGER NOT NULL, body BLOB NOT NULL)""",
    """INSERT INTO weather_forecast (service, place, run, lat, lon, fetched, size)
        SELECT service, place, fetched, CAST(substr(place, 1, instr(place, ',') - 1) AS REAL),
        CAST(substr(place, instr(place, ',') + 1) AS REAL), fetched, length(body) FROM weather_answer""",
    """INSERT INTO weather_body SELECT f.id, a.checksum, a.body
        FROM weather_answer a JOIN weather_forecast f USING (service, place)""",
    "DROP TABLE weather_answer",
)

_KEPT: Final = """SELECT f.id, f.fetched, f.expires, f.run, b.checksum, b.body
    FROM weather_forecast f JOIN weather_body b USING (id) WHERE """

_EARLIER: Final = """f.id < ? AND (f.service, f.place) = (
    SELECT service, place FROM weather_forecast WHERE id = ?) ORDER BY f.id DESC"""

_MOST_VARIABLES: Final = 500
"""SQLite's own limit of parameters in one statement is 999 in old versions."""


@dataclass(frozen=True, slots=True)
class CachedAnswer:
    """An answer, and its times in seconds since 1970.

    Attributes
    ----------
    fetched
        When it was given.
    expires
        Until when it is as good as a new one, by the cycle in which its source is brought up to date;
        ``None`` where that was not kept.
    run
        Run of the model; ``None`` where an answer counts as a run of its own. Of a place's answers from
        one run the latest is kept, and those of earlier runs stand in where it is damaged.
    """

    answer: PointAnswer
    fetched: float
    expires: float | None = None
    run: float | None = None


@dataclass(frozen=True, slots=True)
class Found:
    """An answer that the cache has for a place [degrees]; `WeatherCache.read` reads it.

    Attributes
    ----------
    fetched, expires
        As in `CachedAnswer`.
    """

    number: int
    lat: float
    lon: float
    fetched: float
    expires: float | None


@dataclass(frozen=True, slots=True)
class Quota:
    """Requests used and allowed on a UTC day; ``known`` when the service itself told so."""

    used: int
    daily: int
    known: bool

    @property
    def left(self) -> int:
        """Requests that may still be sent today."""
        return max(self.daily - self.used, 0)


def place_id(lat: float, lon: float) -> str:
    """Name of a place in the cache: rounded to a thousandth of a degree, about 100 m."""
    return f"{round(lat, 3) + 0.0:.3f},{round(lon, 3) + 0.0:.3f}"


class WeatherCache:
    """Forecast cache and quota ledger in the one SQLite file.

    Parameters
    ----------
    store
        The file; tables are made or brought up to date here.

    Raises
    ------
    StoreError
        From here and from every method when the file cannot be used.
    """

    def __init__(self, store: Store) -> None:
        self._store = store
        store.migrate("weather", _STEPS)

    def put(self, lat: float, lon: float, service: str, cached: CachedAnswer) -> None:
        """Keep an answer for a place and run, and throw away those too old for anything, or too many."""
        body = pack(cached.answer)
        place, run = place_id(lat, lon), cached.fetched if cached.run is None else cached.run
        last = max(cached.answer.time, default=None)
        row = (service, place, run, lat, lon, cached.fetched, cached.expires, last, len(body))
        with self._store.writing() as db:
            db.execute("DELETE FROM weather_forecast WHERE fetched < ?", (cached.fetched - KEPT_S,))
            db.execute(
                "DELETE FROM weather_forecast WHERE service = ? AND place = ? AND run = ?",
                (service, place, run),
            )
            added = db.execute(
                """INSERT INTO weather_forecast (service, place, run, lat, lon, fetched, expires, last, size)
                VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)""",
                row,
            ).lastrowid
            db.execute("INSERT INTO weather_body VALUES (?, ?, ?)", (added, zlib.crc32(body), body))
            _drop_oldest(db, MAX_BYTES)

    def around(self, box: Box, service: str, reaching: float) -> tuple[Found, ...]:
        """List the latest answers kept for the places in an area, of any age, without reading them.

        Parameters
        ----------
        box
            South, west, north, east [degrees].
        reaching
            Answers that end before this time are passed over [s since 1970].
        """
        south, west, north, east = box
        found: dict[str, Found] = {}
        with self._store.reading() as db:
            rows = db.execute(
                """SELECT place, id, lat, lon, fetched, expires FROM weather_forecast
                WHERE service = ? AND lat BETWEEN ? AND ? AND lon BETWEEN ? AND ?
                AND (last IS NULL OR last >= ?) ORDER BY id DESC""",
                (service, south, north, west, east, reaching),
            )
            for place, *rest in rows:
                found.setdefault(place, Found(*rest))
        return tuple(found.values())

    def read(self, found: Sequence[Found]) -> dict[int, CachedAnswer]:
        """Read answers, by their number; for a damaged one that of an earlier run, if there is any."""
        answers: dict[int, CachedAnswer] = {}
        with self._store.reading() as db:
            for first in range(0, len(found), _MOST_VARIABLES):
                part = [one.number for one in found[first : first + _MOST_VARIABLES]]
                marks = ",".join("?" * len(part))
                for number, *row in db.execute(f"{_KEPT} f.id IN ({marks})", part):
                    if (answer := _cached(row)) is not None:
                        answers[number] = answer
            for number in {one.number for one in found} - set(answers):
                rows = db.execute(f"{_KEPT} {_EARLIER}", (number, number))
                if (answer := next((one for _, *row in rows if (one := _cached(row))), None)) is not None:
                    answers[number] = answer
        return answers

    def ages(self, now: datetime) -> tuple[tuple[str, str, float], ...]:
        """Service, place and age [h] of every answer kept, the youngest first."""
        with self._store.reading() as db:
            rows = db.execute(
                "SELECT service, place, fetched FROM weather_forecast ORDER BY fetched DESC"
            ).fetchall()
        return tuple(
            (service, place, (now.timestamp() - fetched) / 3600.0) for service, place, fetched in rows
        )

    def quota(self, key: str, now: datetime) -> Quota:
        """Look up the requests used with a key on the UTC day of ``now``; an unseen day begins at zero."""
        with self._store.reading() as db:
            today = db.execute(
                "SELECT used, daily FROM weather_quota WHERE key_hash = ? AND day = ?",
                (_hash(key), _day(now)),
            ).fetchone()
            last = db.execute(
                "SELECT daily FROM weather_quota WHERE key_hash = ? ORDER BY day DESC LIMIT 1", (_hash(key),)
            ).fetchone()
        if today is not None:
            return Quota(used=today[0], daily=today[1], known=True)
        return Quota(used=0, daily=last[0] if last else FREE_PLAN_QUOTA, known=False)

    def note_request(
        self,
        key: str,
        now: datetime,
        *,
        used: int | None = None,
        daily: int | None = None,
        cost: int = 1,
        spent: bool = False,
        overtaking: int = OVERTAKING,
    ) -> None:
        """Write a request into the ledger, with the service's own count when its answer carried one.

        Answers overtake each other and the key may be in use elsewhere: the highest count of a day holds,
        until the service counts from the beginning again: it is its day that matters, not this computer's.

        Parameters
        ----------
        used, daily
            Requests of today and allowed a day, as the service counts them.
        cost
            Requests that the answer counts for, where the service does not tell their number.
        spent
            The service refused because nothing is left.
        overtaking
            Answers that may have overtaken this one: the requests sent since the plan began.
        """
        with self._store.writing() as db:
            row = db.execute(
                "SELECT used, daily FROM weather_quota WHERE key_hash = ? AND day = ?",
                (_hash(key), _day(now)),
            ).fetchone()
            last = db.execute(
                "SELECT daily FROM weather_quota WHERE key_hash = ? ORDER BY day DESC LIMIT 1", (_hash(key),)
            ).fetchone()
            before = row[0] if row else 0
            allowed = daily if daily is not None else (last[0] if last else FREE_PLAN_QUOTA)
            if spent:
                count = max(before, allowed)
            elif used is None:
                count = before + cost
            else:
                count = used if used < before - max(overtaking, OVERTAKING) else max(before, used)
            db.execute(
                "INSERT OR REPLACE INTO weather_quota VALUES (?, ?, ?, ?)",
                (_hash(key), _day(now), count, allowed),
            )


class Memory:
    """The cache, or nothing: a file that cannot be used costs the memory, never the forecast.

    Attributes
    ----------
    trouble
        Why nothing is kept, for the sailor; empty while all is well.
    """

    def __init__(self, database: Path) -> None:
        self.trouble = ""
        self._cache: WeatherCache | None = None
        with self._excused():
            self._cache = WeatherCache(Store(database))

    @contextmanager
    def _excused(self) -> Iterator[None]:
        try:
            yield
        except StoreError as error:
            self.trouble = str(error)

    def around(self, box: Box, service: str, reaching: float) -> tuple[Found, ...]:
        """List the answers kept for an area; see `WeatherCache.around`."""
        if self._cache is not None:
            with self._excused():
                return self._cache.around(box, service, reaching)
        return ()

    def read(self, found: Sequence[Found]) -> dict[int, CachedAnswer]:
        """Read answers, by their number; see `WeatherCache.read`."""
        if self._cache is not None:
            with self._excused():
                return self._cache.read(found)
        return {}

    def keep(self, service: str, cached: CachedAnswer) -> None:
        """Keep an answer for its place."""
        if self._cache is not None:
            with self._excused():
                self._cache.put(cached.answer.lat, cached.answer.lon, service, cached)

    def quota(self, key: str, now: datetime) -> Quota:
        """Look up the requests of today; the free plan's, unused, when nothing is known."""
        if self._cache is not None:
            with self._excused():
                return self._cache.quota(key, now)
        return Quota(used=0, daily=FREE_PLAN_QUOTA, known=False)

    def note_request(self, key: str, now: datetime, **counts: Any) -> None:
        """Write a request into the ledger; see `WeatherCache.note_request`."""
        if self._cache is not None:
            with self._excused():
                self._cache.note_request(key, now, **counts)

    def ages(self, now: datetime) -> tuple[tuple[str, str, float], ...]:
        """Service, place and age [h] of every answer kept."""
        if self._cache is not None:
            with self._excused():
                return self._cache.ages(now)
        return ()


def _cached(row: Sequence[Any]) -> CachedAnswer | None:
    fetched, expires, run, checksum, body = row
    answer = unpack(body) if zlib.crc32(body) == checksum else None
    return None if answer is None else CachedAnswer(answer, fetched=fetched, expires=expires, run=run)


def _drop_oldest(db: sqlite3.Connection, most: int) -> None:
    total = db.execute("SELECT SUM(size) FROM weather_forecast").fetchone()[0]
    if total <= most:
        return
    for number, size in db.execute("SELECT id, size FROM weather_forecast ORDER BY fetched").fetchall():
        db.execute("DELETE FROM weather_forecast WHERE id = ?", (number,))
        total -= size
        if total <= most:
            return


def _hash(key: str) -> str:
    return hashlib.sha256(b"seacruise quota " + key.encode()).hexdigest()[:16]


def _day(now: datetime) -> str:
    return now.astimezone(UTC).date().isoformat()
