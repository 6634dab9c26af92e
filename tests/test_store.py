"""The one SQLite file: versions, transactions, and files that cannot be used."""

from __future__ import annotations

import os
import sqlite3
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from seacruise.errors import InputError
from seacruise.store import Store, StoreError

STEPS = ("CREATE TABLE note (text TEXT)",)


@pytest.fixture
def store(tmp_path: Path) -> Store:
    store = Store(tmp_path / "Ordner mit Ümlaut" / "seacruise.sqlite")
    store.migrate("notes", STEPS)
    return store


def notes(store: Store) -> list[str]:
    with store.reading() as db:
        return [row[0] for row in db.execute("SELECT text FROM note ORDER BY text")]


def test_what_was_written_is_there_for_the_next(store: Store) -> None:
    with store.writing() as db:
        db.execute("INSERT INTO note VALUES ('a')")
    assert notes(Store(store.path)) == ["a"]


def fail_half_way(store: Store) -> None:
    with store.writing() as db:
        db.execute("INSERT INTO note VALUES ('a')")
        raise KeyError


def test_a_block_that_fails_writes_nothing(store: Store) -> None:
    with pytest.raises(KeyError):
        fail_half_way(store)
    assert notes(store) == []


def test_readers_and_writers_do_not_wait_for_each_other(store: Store) -> None:
    with store.reading() as db:
        assert db.execute("PRAGMA journal_mode").fetchone() == ("wal",)
        db.execute("BEGIN")
        db.execute("SELECT * FROM note").fetchall()
        with store.writing() as other:
            other.execute("INSERT INTO note VALUES ('a')")
        assert db.execute("SELECT * FROM note").fetchall() == []
    assert notes(store) == ["a"]


def test_later_steps_are_added_to_earlier_ones(store: Store) -> None:
    with store.writing() as db:
        db.execute("INSERT INTO note VALUES ('kept')")
    steps = (*STEPS, "ALTER TABLE note ADD COLUMN colour TEXT DEFAULT 'blue'")
    store.migrate("notes", steps)
    store.migrate("notes", steps)
    with store.reading() as db:
        assert db.execute("SELECT * FROM note").fetchall() == [("kept", "blue")]


def test_rooms_count_their_versions_apart(store: Store) -> None:
    store.migrate("other", ("CREATE TABLE other (a)", "CREATE TABLE another (a)"))
    store.migrate("notes", STEPS)
    assert notes(store) == []


def test_a_file_of_a_newer_version_is_left_alone(store: Store) -> None:
    store.migrate("notes", (*STEPS, "CREATE TABLE future (a)"))
    with pytest.raises(StoreError, match="newer SeaCruise"):
        store.migrate("notes", STEPS)


def test_many_threads_write_at_a_time(store: Store) -> None:
    def write(number: int) -> None:
        with store.writing() as db:
            db.execute("INSERT INTO note VALUES (?)", (f"{number:02d}",))

    threads = [threading.Thread(target=write, args=(number,)) for number in range(16)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert notes(store) == [f"{number:02d}" for number in range(16)]


@pytest.mark.parametrize(
    "content", [b"this is no database, just text" * 100, b"SQLite format 3\x00" + b"\xff" * 5000]
)
def test_a_damaged_file_is_named_and_kept(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "seacruise.sqlite"
    path.write_bytes(content)
    with pytest.raises(StoreError, match="damaged") as caught:
        Store(path).migrate("notes", STEPS)
    assert path.read_bytes() == content
    assert isinstance(caught.value, InputError)
    assert (caught.value.exit_code, caught.value.reason) == (2, "storage")
    assert str(path) in str(caught.value)


def test_a_folder_that_cannot_be_made_is_named(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    with pytest.raises(StoreError, match="cannot be made"):
        Store(tmp_path / "file" / "deep" / "seacruise.sqlite").migrate("notes", STEPS)


def test_a_folder_in_place_of_the_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(StoreError, match="cannot be written"):
        Store(tmp_path).migrate("notes", STEPS)


def write_on_a_full_disk(store: Store) -> None:
    with store.writing() as db:
        pages = db.execute("PRAGMA page_count").fetchone()[0]
        db.execute(f"PRAGMA max_page_count = {pages}")
        db.execute("INSERT INTO note VALUES (?)", ("x" * 100_000,))


def test_a_full_disk_is_named(store: Store) -> None:
    with pytest.raises(StoreError, match="disk is full"):
        write_on_a_full_disk(store)
    assert notes(store) == []


def test_another_program_that_writes_for_long_is_named(store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("seacruise.store.BUSY_TIMEOUT_S", 0.05)
    with store.writing(), pytest.raises(StoreError, match="in use"), store.writing():
        pass


def test_kill_in_the_middle_of_a_write_leaves_the_file_whole(store: Store) -> None:
    with store.writing() as db:
        db.execute("INSERT INTO note VALUES ('before')")
    program = (
        "import os, sqlite3, sys\n"
        "from pathlib import Path\n"
        "from seacruise.store import Store\n"
        "with Store(Path(sys.argv[1])).writing() as db:\n"
        "    db.execute(\"INSERT INTO note VALUES ('half')\")\n"
        "    os._exit(9)\n"
    )
    root = str(Path(__file__).resolve().parent.parent)
    done = subprocess.run(
        [sys.executable, "-c", program, str(store.path)],
        check=False,
        env={**os.environ, "PYTHONPATH": root},
        timeout=60,
    )
    assert done.returncode == 9
    assert notes(store) == ["before"]
    with store.reading() as db:
        assert db.execute("PRAGMA integrity_check").fetchone() == ("ok",)


def test_a_wrong_statement_is_no_traceback(store: Store) -> None:
    with pytest.raises(StoreError, match="cannot be used"), store.reading() as db:
        db.execute("SELECT * FROM nowhere")


def test_threads_that_open_and_close_the_file_all_write(tmp_path: Path) -> None:
    path = tmp_path / "seacruise.sqlite"

    def write(number: int) -> None:
        store = Store(path)
        store.migrate("notes", STEPS)
        with store.writing() as db:
            db.execute("INSERT INTO note VALUES (?)", (f"{number:03d}",))

    with ThreadPoolExecutor(100) as pool:
        list(pool.map(write, range(100)))
    assert notes(Store(path)) == [f"{number:03d}" for number in range(100)]


def test_a_file_that_another_program_is_just_closing_is_opened_again(
    store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened, refusals = Store._open, [sqlite3.OperationalError("database is locked")] * 3

    def closing(self: Store) -> sqlite3.Connection:
        if refusals:
            raise refusals.pop()
        return opened(self)

    monkeypatch.setattr(Store, "_open", closing)
    assert notes(store) == []
    assert not refusals
