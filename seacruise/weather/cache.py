"""What Storm Glass answered, and how many requests are left today: both outlive the program.

Neither holds the key, only the hash that tells keys apart.
"""

from __future__ import annotations

import hashlib
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, Final

import msgspec

from seacruise.store import Store, StoreError

FREE_PLAN_QUOTA: Final = 10
"""Requests a day of the free plan; assumed until the service tells another number."""

KEPT_S: Final = 10 * 86400.0
"""Answers reach ten days ahead; older ones are thrown away [s]."""

_STEPS: Final = (
    """CREATE TABLE weather_answer (
        place TEXT NOT NULL, service TEXT NOT NULL, fetched REAL NOT NULL,
        checksum INTEGER NOT NULL, body BLOB NOT NULL, PRIMARY KEY (place, service))""",
    """CREATE TABLE weather_quota (
        key_hash TEXT NOT NULL, day TEXT NOT NULL, used INTEGER NOT NULL, daily INTEGER NOT NULL,
        PRIMARY KEY (key_hash, day))""",
)


class PointAnswer(msgspec.Struct, frozen=True):
    """What a service said about one place, checked and reduced to what is used.

    Attributes
    ----------
    time
        Seconds since 1970-01-01T00:00Z, strictly increasing.
    speed, direction
        [m/s] and degrees true FROM; as many as times.
    model
        Name of the source each hour is from.
    notes
        Sentences about what was missing or replaced.
    """

    lat: float
    lon: float
    time: tuple[float, ...]
    speed: tuple[float, ...]
    direction: tuple[float, ...]
    model: tuple[str, ...]
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class CachedAnswer:
    """An answer and when it was given [s since 1970]."""

    answer: PointAnswer
    fetched: float


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
        """Keep an answer for a place in place of an older one, and throw away those too old for anything."""
        body = zlib.compress(msgspec.msgpack.encode(cached.answer))
        with self._store.writing() as db:
            db.execute("DELETE FROM weather_answer WHERE fetched < ?", (cached.fetched - KEPT_S,))
            db.execute(
                "INSERT OR REPLACE INTO weather_answer VALUES (?, ?, ?, ?, ?)",
                (place_id(lat, lon), service, cached.fetched, zlib.crc32(body), body),
            )

    def get(self, lat: float, lon: float, service: str) -> CachedAnswer | None:
        """Answer kept for a place, of any age; ``None`` when there is none or it is damaged."""
        with self._store.reading() as db:
            row = db.execute(
                "SELECT fetched, checksum, body FROM weather_answer WHERE place = ? AND service = ?",
                (place_id(lat, lon), service),
            ).fetchone()
        if row is None or zlib.crc32(row[2]) != row[1]:
            return None
        try:
            answer = msgspec.msgpack.decode(zlib.decompress(row[2]), type=PointAnswer)
        except (zlib.error, msgspec.DecodeError):
            return None
        return CachedAnswer(answer=answer, fetched=row[0])

    def ages(self, now: datetime) -> tuple[tuple[str, str, float], ...]:
        """Service, place and age [h] of every answer kept, the youngest first."""
        with self._store.reading() as db:
            rows = db.execute(
                "SELECT service, place, fetched FROM weather_answer ORDER BY fetched DESC"
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
        spent: bool = False,
    ) -> None:
        """Write a request into the ledger, with the service's own count when its answer carried one.

        Answers overtake each other and the key may be in use elsewhere: the highest count of a day holds.

        Parameters
        ----------
        used, daily
            Requests of today and allowed a day, as the service counts them.
        spent
            The service refused because nothing is left.
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
            else:
                count = before + 1 if used is None else max(before, used)
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

    def recall(self, lat: float, lon: float, service: str) -> CachedAnswer | None:
        """Answer kept for a place, if any."""
        if self._cache is not None:
            with self._excused():
                return self._cache.get(lat, lon, service)
        return None

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


def _hash(key: str) -> str:
    return hashlib.sha256(b"seacruise quota " + key.encode()).hexdigest()[:16]


def _day(now: datetime) -> str:
    return now.astimezone(UTC).date().isoformat()
