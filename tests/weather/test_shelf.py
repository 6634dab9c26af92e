"""What is kept of Open-Meteo and MET Norway: whole or not at all, and never in the way of a forecast."""

from __future__ import annotations

import sqlite3
import subprocess
import sys
import threading
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.store import Store
from seacruise.weather.openmeteo import OpenMeteo, OpenMeteoConfig
from seacruise.weather.series import Series
from seacruise.weather.shelf import Kept, Shelf, _pack, _unpack
from seacruise.weather.wind import Wind
from tests.conftest import REPOSITORY
from tests.faultserver import FaultServer
from tests.weather.weatherserver import open_meteo

NOW = datetime(2026, 11, 21, 9, 30, tzinfo=UTC)
TODAY = datetime(2026, 11, 21, tzinfo=UTC)
BOX = (54.0, 17.0, 56.0, 19.0)
PLACES = [(54.0 + 0.25 * row, 17.0) for row in range(6)]


def series_at(lat: float, lon: float, *, size: int = 5) -> Series:
    time = NOW.timestamp() + 3600.0 * np.arange(size, dtype=np.float64)
    values = {"u": np.arange(size, dtype=np.float32) - 2.5, "v": np.full(size, np.nan, dtype=np.float32)}
    return Series(lat, lon, time, values, notes=("a note",), stamp="Sat, 21 Nov 2026 08:41:17 GMT")


def fill(shelf: Shelf, *, fetched: float = NOW.timestamp(), service: str = "test") -> None:
    shelf.keep(service, [Kept(series_at(*place), fetched, fetched + 60.0) for place in PLACES])


def ask(settings: Settings, server: FaultServer, **options: Any) -> Wind:
    service = OpenMeteo(replace(settings, openmeteo_url=server.url), OpenMeteoConfig(max_points=6))
    return service.wind(BOX, departure=None, now=NOW, **{"job": Job(), **options})


def test_what_is_kept_comes_back_exactly(tmp_path: Path) -> None:
    shelf = Shelf(tmp_path / "a.sqlite")
    fill(shelf)
    found = Shelf(tmp_path / "a.sqlite").recall("test", [*PLACES, (60.0, 20.0)])
    assert sorted(found) == list(range(6))
    for index, kept in found.items():
        series = series_at(*PLACES[index])
        assert (kept.series.lat, kept.series.lon) == PLACES[index]
        np.testing.assert_array_equal(kept.series.time, series.time)
        for name, values in series.values.items():
            np.testing.assert_array_equal(kept.series.values[name], values)
        assert (kept.series.notes, kept.series.stamp) == (series.notes, series.stamp)
        assert (kept.fetched, kept.expires) == (NOW.timestamp(), NOW.timestamp() + 60.0)
    assert shelf.recall("another", PLACES) == {}


@given(st.binary(max_size=200))
def test_any_bytes_are_a_series_or_nothing(body: bytes) -> None:
    assert _unpack(body) is None


@given(st.data())
def test_a_damaged_series_is_never_another_one(data: st.DataObject) -> None:
    body = bytearray(_pack(series_at(54.0, 17.0, size=30)))
    place = data.draw(st.integers(0, len(body) - 1))
    body[place] ^= 1 << data.draw(st.integers(0, 7))
    found = _unpack(bytes(body))
    # zlib's own checksum notices; the one in the table stands before it
    assert found is None or found.values.keys() == series_at(54.0, 17.0).values.keys()


@pytest.mark.parametrize(
    "change",
    [
        "substr(body, 1, 50)",
        "x'00'",
        "zeroblob(length(body))",
        "substr(body, 1, 40) || x'ff' || substr(body, 42)",
    ],
    ids=["I-truncated", "I-short", "I-zeros", "I-bit-flip"],
)
def test_a_damaged_entry_is_a_miss(settings: Settings, change: str) -> None:
    with open_meteo(today=TODAY) as server:
        first = ask(settings, server)
        sent = len(server.requests)
        with Store(settings.database).writing() as db:
            db.execute(f"UPDATE weather_series SET body = {change}")
        second = ask(settings, server)
    assert len(server.requests) == 2 * sent
    np.testing.assert_array_equal(first.u, second.u)


def test_I_cache_of_a_newer_version(settings: Settings) -> None:  # noqa: N802 (the fault's group)
    with open_meteo(today=TODAY) as server:
        ask(settings, server)
        with Store(settings.database).writing() as db:
            db.execute("UPDATE schema_version SET version = 99 WHERE room = 'weather-series'")
        told: list[str] = []
        wind = ask(settings, server, job=Job(report=lambda stage, part, message: told.append(message)))
    assert wind.time.size == 240
    assert any("of a newer SeaCruise" in message for message in told)


@pytest.mark.parametrize("content", [b"not a database" * 1000, b"SQLite format 3\x00" + b"\xff" * 5000])
def test_I_cache_that_is_no_database(settings: Settings, content: bytes) -> None:  # noqa: N802
    settings.data_dir.mkdir(parents=True)
    settings.database.write_bytes(content)
    told: list[str] = []
    with open_meteo(today=TODAY) as server:
        wind = ask(settings, server, job=Job(report=lambda stage, part, message: told.append(message)))
    assert wind.time.size == 240
    assert any("Forecasts are not kept." in message for message in told)
    # nothing that is not ours is written over
    assert settings.database.read_bytes() == content


def test_I_cache_where_no_folder_can_be(settings: Settings) -> None:  # noqa: N802
    settings.data_dir.parent.mkdir(parents=True)
    settings.data_dir.write_text("a file in the place of the folder")
    with open_meteo(today=TODAY) as server:
        assert ask(settings, server).time.size == 240


@pytest.mark.parametrize("number", range(1, 6))
def test_I_disk_full_at_every_write(  # noqa: N802
    settings: Settings, monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    with open_meteo(today=TODAY) as server:
        ask(settings, server)
    writes: list[str] = []

    class Full(sqlite3.Connection):
        def execute(self, sql: str, *arguments: Any) -> sqlite3.Cursor:
            self._count(sql)
            return super().execute(sql, *arguments)

        def executemany(self, sql: str, *arguments: Any) -> sqlite3.Cursor:
            self._count(sql)
            return super().executemany(sql, *arguments)

        def _count(self, sql: str) -> None:
            if sql.startswith(("BEGIN", "DELETE", "INSERT", "COMMIT")):
                writes.append(sql)
                if len(writes) == number:
                    raise sqlite3.OperationalError("database or disk is full")

    real = sqlite3.connect
    monkeypatch.setattr(sqlite3, "connect", lambda *a, **k: real(*a, **k, factory=Full))
    told: list[str] = []
    with open_meteo(today=TODAY) as server:
        service = OpenMeteo(replace(settings, openmeteo_url=server.url), OpenMeteoConfig(max_points=6))
        later = NOW.replace(hour=16)
        job = Job(report=lambda stage, part, message: told.append(message))
        wind = service.wind(BOX, departure=None, now=later, job=job)
    assert wind.forecast.issued == later
    assert len(writes) >= number
    assert any("the disk is full" in message for message in told)
    monkeypatch.undo()
    # all or nothing: what stood there before still does
    assert len(Shelf(settings.database).recall(*_kept_wind(settings))) == 6


def _kept_wind(settings: Settings) -> tuple[str, list[tuple[float, float]]]:
    with Store(settings.database).reading() as db:
        service = db.execute("SELECT service FROM weather_series WHERE service LIKE '%wind%'").fetchone()[0]
        rows = db.execute("SELECT place FROM weather_series WHERE service = ?", (service,)).fetchall()
    return service, [(float(lat), float(lon)) for lat, lon in (row[0].split(",") for row in rows)]


def test_I_killed_in_the_middle_of_a_write(tmp_path: Path) -> None:  # noqa: N802
    database = tmp_path / "a.sqlite"
    fill(Shelf(database))
    program = (
        "import os, sys\nfrom pathlib import Path\n"
        "from seacruise.store import Store\n"
        "with Store(Path(sys.argv[1])).writing() as db:\n"
        "    db.execute('DELETE FROM weather_series')\n"
        "    os.kill(os.getpid(), 9) if os.name != 'nt' else os._exit(9)\n"
    )
    done = subprocess.run([sys.executable, "-c", program, str(database)], cwd=REPOSITORY, check=False)
    assert done.returncode != 0
    assert len(Shelf(database).recall("test", PLACES)) == 6


def test_I_two_programs_at_a_time(tmp_path: Path) -> None:  # noqa: N802
    database = tmp_path / "a.sqlite"
    shelves = [Shelf(database) for _ in range(4)]

    def work(shelf: Shelf, name: str) -> None:
        for _ in range(5):
            fill(shelf, service=name)
            shelf.recall(name, PLACES)

    threads = [
        threading.Thread(target=work, args=(shelf, f"service {number}"))
        for number, shelf in enumerate(shelves)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [shelf.trouble for shelf in shelves] == [""] * 4
    assert all(len(Shelf(database).recall(f"service {number}", PLACES)) == 6 for number in range(4))


def test_I_path_with_spaces_and_letters_of_all_seas(tmp_path: Path) -> None:  # noqa: N802
    database = tmp_path / "żagle na Bałtyku 海" / "sea cruise.sqlite"
    fill(Shelf(database))
    assert len(Shelf(database).recall("test", PLACES)) == 6


def test_I_symlink_to_the_cache(tmp_path: Path) -> None:  # noqa: N802
    (tmp_path / "real").mkdir()
    try:
        (tmp_path / "link").symlink_to(tmp_path / "real", target_is_directory=True)
    except OSError:
        pytest.skip("SYMLINKS NOT TESTED: this system does not let us make one")
    fill(Shelf(tmp_path / "link" / "a.sqlite"))
    assert len(Shelf(tmp_path / "real" / "a.sqlite").recall("test", PLACES)) == 6


def test_old_and_too_much_are_thrown_away(tmp_path: Path) -> None:
    now = NOW.timestamp()
    shelf = Shelf(tmp_path / "a.sqlite", max_bytes=4000)
    fill(shelf, service="ten days old", fetched=now - 11 * 86400)
    fill(shelf, service="new", fetched=now)
    assert shelf.recall("ten days old", PLACES) == {}
    assert len(shelf.recall("new", PLACES)) == 6
    for number in range(20):
        fill(shelf, service=f"more {number}", fetched=now + number)
    assert shelf.recall("new", PLACES) == {}
    assert len(shelf.recall("more 19", PLACES)) == 6
    with Store(tmp_path / "a.sqlite").reading() as db:
        assert db.execute("SELECT SUM(LENGTH(body)) FROM weather_series").fetchone()[0] <= 4000


def test_many_places_are_recalled_at_once(tmp_path: Path) -> None:
    shelf = Shelf(tmp_path / "a.sqlite")
    places = [(54.0 + number / 1000, 17.0) for number in range(1200)]
    shelf.keep("many", [Kept(series_at(*place, size=1), 0.0, 1.0) for place in places])
    assert len(shelf.recall("many", places)) == 1200
    assert shelf.ages(datetime.fromtimestamp(7200, UTC)) == (("many", "1200 places", 2.0),)
