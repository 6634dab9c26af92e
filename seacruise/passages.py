"""Saved passages: what was asked, what was answered and in which wind, as it was shown.

They lie in the one SQLite file. A passage that is opened again is the one that was saved, to the last digit:
nothing is computed anew, and so it stays what it was when forecast, polar or program have changed.
"""

from __future__ import annotations

import sqlite3
import zlib
from dataclasses import dataclass, field, fields, replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError, SeaCruiseError
from seacruise.export.jsonform import dumps, passage_to_json
from seacruise.export.saved import saved_from_json
from seacruise.export.textform import format_day_time
from seacruise.model import Options, Passage, Track
from seacruise.ports import Port
from seacruise.records import pack, unpack
from seacruise.store import Store
from seacruise.weather.beyond import extend

if TYPE_CHECKING:
    from seacruise.sea.zones import Zone
    from seacruise.underway import SavedPassage
    from seacruise.weather.wind import Flow, Wind
    from seacruise.yacht.polar import Polar

Array = NDArray[np.float64]

_STEPS: Final = (
    """CREATE TABLE passage (
        id INTEGER PRIMARY KEY AUTOINCREMENT, name TEXT NOT NULL, start TEXT NOT NULL, finish TEXT NOT NULL,
        yacht TEXT NOT NULL, departure REAL NOT NULL, duration_h REAL NOT NULL, source TEXT NOT NULL,
        issued REAL, is_real INTEGER NOT NULL, computed REAL NOT NULL, deleted REAL)""",
    """CREATE TABLE passage_body (
        id INTEGER PRIMARY KEY REFERENCES passage (id) ON DELETE CASCADE,
        json TEXT NOT NULL, body BLOB NOT NULL, checksum INTEGER NOT NULL)""",
)

_AROUND_DEG: Final = 1.0
"""Room around a passage of which the wind is kept [degrees]."""

UNDO_S: Final = 86_400.0
"""A deleted passage can be brought back for this long [s]; then it is thrown away."""

MOST_LETTERS: Final = 120
"""Longer names than this are nobody's."""

_LINE: Final = """SELECT id, name, start, finish, yacht, departure, duration_h, source, issued, is_real,
    computed FROM passage WHERE id = ?"""


@dataclass(frozen=True, slots=True)
class Asked:
    """What the sailor asked for, enough to ask it again.

    Attributes
    ----------
    forecast
        Names as on the command line.
    weights, current
        Weights of several forecasts, and a file with the current; as on the command line.
    via
        A place to be led through.
    avoid
        Areas marked on the chart.
    """

    start: Port
    end: Port
    departure: datetime | None
    yacht: Polar
    forecast: tuple[str, ...]
    options: Options = field(default_factory=Options)
    weights: tuple[float, ...] = ()
    current: str = ""
    via: Port | None = None
    avoid: tuple[Zone, ...] = field(default=(), compare=False)


@dataclass(frozen=True, slots=True)
class Entry:
    """A line of the list of saved passages.

    Attributes
    ----------
    source, issued, is_real
        The forecast by name, its run, and whether it was one: practice weather and the sample are not.
    computed
        When the passage was found.
    """

    number: int
    name: str
    start: str
    end: str
    yacht: str
    departure: datetime
    duration_h: float
    source: str
    issued: datetime | None
    is_real: bool
    computed: datetime

    def provenance(self, now: datetime) -> str:
        """Say when it was computed, with which forecast, and how old that is by now."""
        told = f"Computed on {format_day_time(self.computed)} UTC with {self.source}"
        if not self.is_real and "not a forecast" in self.source:
            return f"Computed on {format_day_time(self.computed)} UTC with {self.source}."
        if not self.is_real:
            return f"{told}, which is no forecast."
        if self.issued is None:
            return f"{told}; how old that forecast is it does not say."
        return f"{told}; that forecast is {_age(now - self.issued)} old."


@dataclass(frozen=True, slots=True)
class Opened:
    """A saved passage as it was shown.

    Attributes
    ----------
    wind
        The wind around it and of its hours, without members; its forecast says what is left.
    json
        What ``plan --format json`` would have printed.
    """

    entry: Entry
    passage: Passage
    asked: Asked
    wind: Wind
    json: str

    def to_replan(self) -> SavedPassage:
        """Give what `seacruise.underway.replan` goes on from."""
        return saved_from_json(self.json, name=self.entry.name)


@dataclass(frozen=True, slots=True)
class Listing:
    """All that is saved, the latest first, and what is damaged: by number and name."""

    entries: tuple[Entry, ...] = ()
    damaged: tuple[tuple[int, str], ...] = ()


class SavedPassages:
    """The shelf of saved passages.

    Parameters
    ----------
    database
        `seacruise.settings.Settings.database`.

    Raises
    ------
    StoreError
        From here and from every method when the file cannot be used.
    """

    def __init__(self, database: Path) -> None:
        self._store = Store(database)
        self._store.migrate("passages", _STEPS)

    def save(
        self, passage: Passage, asked: Asked, wind: Wind, *, name: str = "", now: datetime | None = None
    ) -> Entry:
        """Save a passage with the wind around it; a name that is taken gets a number.

        Parameters
        ----------
        name
            By default ports and departure.
        now
            When it was computed.
        """
        when = now or datetime.now(UTC)
        text = dumps(passage_to_json(passage))
        body = _packed(passage, asked, wind)
        usual = f"{passage.start.name} – {passage.end.name}, {passage.departure:%d %b %Y %H:%M}"
        source = passage.forecast
        row = (
            passage.start.name,
            passage.end.name,
            passage.yacht,
            passage.departure.timestamp(),
            passage.duration_h,
            source.source,
            None if source.issued is None else source.issued.timestamp(),
            source.real,
            when.timestamp(),
        )
        with self._store.writing() as db:
            _purge(db, when)
            named = _free_name(db, _clean(name or usual))
            number = db.execute(
                """INSERT INTO passage (name, start, finish, yacht, departure, duration_h, source, issued,
                is_real, computed) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)""",
                (named, *row),
            ).lastrowid
            db.execute(
                "INSERT INTO passage_body VALUES (?, ?, ?, ?)", (number, text, body, _checksum(text, body))
            )
            return _entry(db.execute(_LINE, (number,)).fetchone())

    def listing(self) -> Listing:
        """List what is saved, the latest first; what is damaged is named and left where it is."""
        entries, damaged = [], []
        with self._store.reading() as db:
            numbers = [row[0] for row in db.execute("SELECT id FROM passage WHERE deleted IS NULL")]
            for number in sorted(numbers, reverse=True):
                entry, fault = _looked_at(db, number)
                if entry is not None:
                    entries.append(entry)
                else:
                    damaged.append((number, fault))
        return Listing(tuple(entries), tuple(damaged))

    def open(self, number: int) -> Opened:
        """Open a passage as it was saved.

        Raises
        ------
        InputError
            There is none of that number, or it is damaged.
        """
        with self._store.reading() as db:
            if db.execute("SELECT 1 FROM passage WHERE id = ?", (number,)).fetchone() is None:
                raise InputError("This passage is no longer saved; it was deleted by another window.")
            entry, name = _looked_at(db, number)
            row = db.execute("SELECT json, body FROM passage_body WHERE id = ?", (number,)).fetchone()
        if entry is None or row is None:
            raise _damaged(name)
        try:
            passage, asked, wind = _unpacked(row[1])
            saved_from_json(row[0], name=entry.name)
        except (ValueError, TypeError, KeyError, SeaCruiseError):
            raise _damaged(entry.name) from None
        return Opened(entry, passage, asked, wind, row[0])

    def rename(self, number: int, name: str) -> str:
        """Give a passage another name; returns it as it was taken.

        Raises
        ------
        InputError
            The name is empty.
        """
        wanted = _clean(name)
        if not wanted:
            raise InputError("A saved passage needs a name; type one.")
        with self._store.writing() as db:
            named = _free_name(db, wanted, besides=number)
            db.execute("UPDATE passage SET name = ? WHERE id = ?", (named, number))
        return named

    def delete(self, number: int, *, now: datetime | None = None) -> None:
        """Take a passage off the list; `restore` brings it back for a day."""
        when = now or datetime.now(UTC)
        with self._store.writing() as db:
            _purge(db, when)
            db.execute("UPDATE passage SET deleted = ? WHERE id = ?", (when.timestamp(), number))

    def restore(self, number: int) -> bool:
        """Undo `delete`; False when it is gone for good."""
        with self._store.writing() as db:
            return db.execute("UPDATE passage SET deleted = NULL WHERE id = ?", (number,)).rowcount > 0


def _packed(passage: Passage, asked: Asked, wind: Wind) -> bytes:
    return pack(
        {
            # The edges of the lattice are megabytes, and made again with the next search.
            "passage": replace(passage, lattice_edges=None),
            "asked": {one.name: getattr(asked, one.name) for one in fields(asked)},
            "wind": _around(wind, passage),
        }
    )


def _unpacked(body: bytes) -> tuple[Passage, Asked, Wind]:
    record = unpack(body)
    return record["passage"], Asked(**record["asked"]), record["wind"]


def _around(wind: Wind, passage: Passage) -> Wind:
    """Cut the wind to the hours of a passage and the water around it; what is left is what it says it has.

    One that fades does so by its members and all its hours, which are not kept: so it is kept extended.
    """
    track = passage.track
    wind = extend(wind, passage.beyond)
    cut = _cut(wind, track)
    if passage.beyond == "fade":
        cut = (slice(cut[0].start, wind.time.size), *cut[1:])
    layers = {
        name: values[cut]
        for name in ("gust", "wave", "spread")
        if (values := getattr(wind, name)) is not None
    }
    time = wind.time[cut[0]]
    first, last = (datetime.fromtimestamp(float(time[k]), UTC) for k in (0, -1))
    forecast = replace(
        wind.forecast,
        valid_from=max(wind.forecast.valid_from, first),
        valid_to=min(wind.forecast.valid_to, last) if first <= wind.forecast.valid_to else last,
    )
    current = wind.current
    if current is not None:
        of = _cut(current, track)
        current = replace(current, **_axes(current, of))
    return replace(wind, **_axes(wind, cut), **layers, forecast=forecast, current=current, members=())


def _axes(flow: Flow, cut: tuple[slice, slice, slice]) -> dict[str, Any]:
    axes = dict(zip(("time", "lat", "lon"), (flow.time, flow.lat, flow.lon), strict=True))
    return {
        **{name: axis[part] for (name, axis), part in zip(axes.items(), cut, strict=True)},
        "u": flow.u[cut],
        "v": flow.v[cut],
    }


def _cut(flow: Flow, track: Track) -> tuple[slice, slice, slice]:
    """Choose the part of a grid that holds a track."""

    def part(axis: Array, low: float, high: float) -> slice:
        first = int(np.searchsorted(axis, low, side="right")) - 1
        last = int(np.searchsorted(axis, high, side="left"))
        # At least two nodes: an axis of one would mean that the wind is the same all along it.
        return slice(max(0, min(first, axis.size - 2)), max(min(last + 1, axis.size), 2))

    lat, lon = track.lat, track.lon
    return (
        part(flow.time, float(track.time[0]), float(track.time[-1])),
        part(flow.lat, float(lat.min()) - _AROUND_DEG, float(lat.max()) + _AROUND_DEG),
        part(flow.lon, float(lon.min()) - 2 * _AROUND_DEG, float(lon.max()) + 2 * _AROUND_DEG),
    )


def _age(age: timedelta) -> str:
    hours = max(0.0, age.total_seconds() / 3600.0)
    return f"{hours:.0f} h" if hours < 48.0 else f"{hours / 24.0:.0f} days"


def _clean(name: str) -> str:
    """Put a name on one line, of a bearable length."""
    return " ".join(name.split())[:MOST_LETTERS].strip()


def _free_name(db: sqlite3.Connection, wanted: str, *, besides: int = -1) -> str:
    """Give the name, or the name and the first number, that no other passage has."""
    taken = {
        row[0] for row in db.execute("SELECT name FROM passage WHERE deleted IS NULL AND id != ?", (besides,))
    }
    number, name = 1, wanted
    while name in taken:
        number += 1
        name = f"{wanted} ({number})"
    return name


def _purge(db: sqlite3.Connection, now: datetime) -> None:
    db.execute("DELETE FROM passage WHERE deleted < ?", (now.timestamp() - UNDO_S,))


def _checksum(text: str, body: bytes) -> int:
    return zlib.crc32(body, zlib.crc32(text.encode()))


def _damaged(name: str) -> InputError:
    return InputError(f"The saved passage {name} is damaged; delete it and plan it again.", reason="damaged")


def _looked_at(db: sqlite3.Connection, number: int) -> tuple[Entry | None, str]:
    """Read a line and hold its contents against the checksum; else the name of what is damaged."""
    name = f"number {number}"
    try:
        row = db.execute(_LINE, (number,)).fetchone()
        name = row[1] if isinstance(row[1], str) and row[1] else name
        entry = _entry(row)
        kept = db.execute("SELECT json, body, checksum FROM passage_body WHERE id = ?", (number,)).fetchone()
        is_whole = kept is not None and _checksum(*kept[:2]) == kept[2]
    except (sqlite3.DatabaseError, ValueError, TypeError, AttributeError, OverflowError, OSError):
        # a page of the file that cannot be read, or a value that no one of ours has written
        return None, name
    return (entry if is_whole else None), name


def _entry(row: tuple[Any, ...]) -> Entry:
    number, name, start, end, yacht, departure, duration_h, source, issued, is_real, computed = row
    if not all(isinstance(text, str) for text in (name, start, end, yacht, source)):
        raise TypeError
    return Entry(
        number,
        name,
        start,
        end,
        yacht,
        datetime.fromtimestamp(departure, UTC),
        float(duration_h),
        source,
        None if issued is None else datetime.fromtimestamp(issued, UTC),
        bool(is_real),
        datetime.fromtimestamp(computed, UTC),
    )
