"""The one SQLite file: forecast cache, quota ledger, saved passages.

Each room keeps its tables in it through its own list of schema steps; this module knows the file, not what
is in it. The file is in WAL mode, so that a window and a command line can use it at the same time and a
process killed in the middle of a write leaves it whole.
"""

from __future__ import annotations

import sqlite3
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Final

from seacruise.errors import InputError

BUSY_TIMEOUT_S: Final = 5.0
"""How long a writer waits for another program that is writing [s]."""

_OPENING_AGAIN_S: Final = 0.01

_turns: dict[Path, threading.RLock] = {}
_turns_lock = threading.Lock()


class StoreError(InputError):
    """The file of saved things cannot be used: damaged, read-only, disk full, written by a newer version."""

    default_reason = "storage"


class Store:
    """Opens the SQLite file anew for every use.

    Opening takes a fraction of a millisecond, and so any thread may use one `Store` and none leaves a
    connection behind.

    Parameters
    ----------
    path
        The file; it and its folder are made on first use.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        with _turns_lock:
            # The threads of this program take turns by themselves: SQLite's own waiting is not fair, and it
            # does not wait at all where one connection opens the file while the last other one closes it.
            self._turn = _turns.setdefault(path, threading.RLock())

    @contextmanager
    def reading(self) -> Iterator[sqlite3.Connection]:
        """Connect for queries.

        Raises
        ------
        StoreError
        """
        connection = None
        try:
            connection = self._connect()
            yield connection
        except sqlite3.Error as error:
            raise self._failure(error) from None
        finally:
            if connection is not None:
                with self._turn:
                    connection.close()

    @contextmanager
    def writing(self) -> Iterator[sqlite3.Connection]:
        """Connect for a transaction: all of it is written, or nothing when the block raises.

        Raises
        ------
        StoreError
        """
        with self._turn, self.reading() as connection:
            # taken at once: a reader that turns writer later would fail without waiting for its turn
            connection.execute("BEGIN IMMEDIATE")
            try:
                yield connection
                connection.execute("COMMIT")
            except BaseException:
                if connection.in_transaction:
                    connection.execute("ROLLBACK")
                raise

    def migrate(self, room: str, steps: Sequence[str]) -> None:
        """Bring a room's tables to the version ``len(steps)``; each step is one SQL statement.

        Steps that were published are never edited, only followed by more.

        Raises
        ------
        StoreError
            Also when the file was written by a newer SeaCruise.
        """
        with self.reading() as connection:
            known = connection.execute("SELECT 1 FROM sqlite_master WHERE name = 'schema_version'").fetchone()
            if known and self._version(connection, room) == len(steps):
                return
        with self.writing() as connection:
            connection.execute(
                "CREATE TABLE IF NOT EXISTS schema_version (room TEXT PRIMARY KEY, version INTEGER NOT NULL)"
            )
            version = self._version(connection, room)
            if version > len(steps):
                raise StoreError(
                    f"The file {self.path} is of a newer SeaCruise; update, or set SEACRUISE_HOME elsewhere."
                )
            for step in steps[version:]:
                connection.execute(step)
            connection.execute("INSERT OR REPLACE INTO schema_version VALUES (?, ?)", (room, len(steps)))

    @staticmethod
    def _version(connection: sqlite3.Connection, room: str) -> int:
        row = connection.execute("SELECT version FROM schema_version WHERE room = ?", (room,)).fetchone()
        return int(row[0]) if row else 0

    def _connect(self) -> sqlite3.Connection:
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise StoreError(
                f"The folder {self.path.parent} cannot be made ({error.strerror}); set SEACRUISE_HOME."
            ) from None
        until = time.monotonic() + BUSY_TIMEOUT_S
        while True:
            try:
                with self._turn:
                    return self._open()
            except sqlite3.OperationalError as error:
                if not _is_busy(error) or time.monotonic() > until:
                    raise
            time.sleep(_OPENING_AGAIN_S)

    def _open(self) -> sqlite3.Connection:
        connection = sqlite3.connect(self.path, timeout=BUSY_TIMEOUT_S, isolation_level=None)
        try:
            connection.execute("PRAGMA journal_mode = WAL")
            connection.execute("PRAGMA synchronous = NORMAL")
            connection.execute("PRAGMA foreign_keys = ON")
        except sqlite3.Error:
            connection.close()
            raise
        return connection

    def _failure(self, error: sqlite3.Error) -> StoreError:
        text = str(error)
        if _is_busy(error):
            what = "is in use by another program; close that and try again"
        elif "full" in text:
            what = "cannot be written: the disk is full"
        elif "readonly" in text or "unable to open" in text:
            what = "cannot be written; set SEACRUISE_HOME to a folder of yours"
        elif isinstance(error, sqlite3.DatabaseError) and ("not a database" in text or "malformed" in text):
            what = "is damaged; move it away and SeaCruise makes a new one"
        else:
            what = f"cannot be used ({text})"
        return StoreError(f"The file {self.path} {what}.")


def _is_busy(error: sqlite3.Error) -> bool:
    text = str(error)
    return "locked" in text or "busy" in text
