"""Series that services sent, kept in the one SQLite file until a newer run of the model is due."""

from __future__ import annotations

import zlib
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Final

import msgspec
import numpy as np

from seacruise.store import Store, StoreError
from seacruise.weather.cache import KEPT_S, place_id
from seacruise.weather.series import Series

_STEPS: Final = (
    """CREATE TABLE weather_series (
        place TEXT NOT NULL, service TEXT NOT NULL, fetched REAL NOT NULL, expires REAL NOT NULL,
        checksum INTEGER NOT NULL, body BLOB NOT NULL, PRIMARY KEY (place, service))""",
)

MAX_BYTES: Final = 48_000_000
"""Size of all series together; beyond it the oldest go: some twelve ensembles, or 150 passages."""

_MOST_VARIABLES: Final = 500
"""SQLite's own limit of parameters in one statement is 999 in old versions."""


@dataclass(frozen=True, slots=True, eq=False)
class Kept:
    """A series, when it was fetched and until when it is as good as a new one [s since 1970]."""

    series: Series
    fetched: float
    expires: float


class _Record(msgspec.Struct, frozen=True, array_like=True):
    """A series as it is stored: arrays as little-endian bytes."""

    lat: float
    lon: float
    time: bytes
    values: dict[str, bytes]
    notes: tuple[str, ...]
    stamp: str


def _pack(series: Series) -> bytes:
    record = _Record(
        lat=series.lat,
        lon=series.lon,
        time=series.time.astype("<f8").tobytes(),
        values={name: value.astype("<f4").tobytes() for name, value in series.values.items()},
        notes=series.notes,
        stamp=series.stamp,
    )
    return zlib.compress(msgspec.msgpack.encode(record), level=1)


def _unpack(body: bytes) -> Series | None:
    try:
        record = msgspec.msgpack.decode(zlib.decompress(body), type=_Record)
        time = np.frombuffer(record.time, dtype="<f8").astype(np.float64)
        values = {
            name: np.frombuffer(value, dtype="<f4").astype(np.float32)
            for name, value in record.values.items()
        }
    except (zlib.error, msgspec.DecodeError, ValueError):
        return None
    if any(value.shape != time.shape for value in values.values()):
        return None
    return Series(record.lat, record.lon, time, values, record.notes, record.stamp)


class Shelf:
    """Series by service and place; a file that cannot be used costs the memory, never the forecast.

    Attributes
    ----------
    trouble
        Why nothing is kept, for the sailor; empty while all is well.
    """

    def __init__(self, database: Path, *, max_bytes: int = MAX_BYTES) -> None:
        self._max_bytes = max_bytes
        self.trouble = ""
        self._store: Store | None = None
        with self._excused():
            store = Store(database)
            store.migrate("weather-series", _STEPS)
            self._store = store

    @contextmanager
    def _excused(self) -> Iterator[None]:
        try:
            yield
        except StoreError as error:
            self.trouble = str(error)

    def recall(self, service: str, places: Sequence[tuple[float, float]]) -> dict[int, Kept]:
        """Series kept for places, of any age, by their index; what is damaged is missing."""
        if self._store is None:
            return {}
        wanted = [place_id(lat, lon) for lat, lon in places]
        found: dict[str, Kept] = {}
        with self._excused(), self._store.reading() as db:
            for first in range(0, len(wanted), _MOST_VARIABLES):
                part = wanted[first : first + _MOST_VARIABLES]
                marks = ",".join("?" * len(part))
                rows = db.execute(
                    "SELECT place, fetched, expires, checksum, body FROM weather_series "  # noqa: S608
                    f"WHERE service = ? AND place IN ({marks})",
                    (service, *part),
                ).fetchall()
                for place, fetched, expires, checksum, body in rows:
                    series = _unpack(body) if zlib.crc32(body) == checksum else None
                    if series is not None:
                        found[place] = Kept(series, fetched, expires)
        return {index: found[place] for index, place in enumerate(wanted) if place in found}

    def keep(self, service: str, entries: Iterable[Kept]) -> None:
        """Keep series in place of older ones, and throw away those too old for anything."""
        if self._store is None:
            return
        rows = []
        for kept in entries:
            body = _pack(kept.series)
            place = place_id(kept.series.lat, kept.series.lon)
            rows.append((place, service, kept.fetched, kept.expires, zlib.crc32(body), body))
        if not rows:
            return
        with self._excused(), self._store.writing() as db:
            oldest = max(row[2] for row in rows) - KEPT_S
            db.execute("DELETE FROM weather_series WHERE fetched < ?", (oldest,))
            db.executemany("INSERT OR REPLACE INTO weather_series VALUES (?, ?, ?, ?, ?, ?)", rows)
            # the running sum counts from the youngest
            db.execute(
                "DELETE FROM weather_series WHERE rowid IN (SELECT rowid FROM (SELECT rowid, "
                "SUM(LENGTH(body)) OVER (ORDER BY fetched DESC, rowid DESC) AS size FROM weather_series) "
                "WHERE size > ?)",
                (self._max_bytes,),
            )

    def ages(self, now: datetime) -> tuple[tuple[str, str, float], ...]:
        """Service, number of places in words and age of the youngest [h], one for each service."""
        if self._store is None:
            return ()
        rows: list[tuple[str, int, float]] = []
        with self._excused(), self._store.reading() as db:
            rows = db.execute(
                "SELECT service, COUNT(*), MAX(fetched) FROM weather_series GROUP BY service ORDER BY service"
            ).fetchall()
        return tuple(
            (service, f"{count} places", (now.timestamp() - fetched) / 3600.0)
            for service, count, fetched in rows
        )
