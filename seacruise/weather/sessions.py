"""Connections that stay open from one request to the next."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager

import requests

from seacruise.weather.http import new_session


class Sessions:
    """Sessions of one fetch: a session is no thread's own, but never used by two at a time."""

    def __init__(self) -> None:
        self._idle: list[requests.Session] = []
        self._closed = False
        self._lock = threading.Lock()

    @contextmanager
    def one(self, stop: threading.Event) -> Iterator[requests.Session]:
        """Lend a session; it is closed after a request that nobody waits for any more."""
        with self._lock:
            session = self._idle.pop() if self._idle else new_session()
        try:
            yield session
        finally:
            with self._lock:
                keep = not self._closed and not stop.is_set()
                if keep:
                    self._idle.append(session)
            if not keep:
                session.close()

    def close(self) -> None:
        """Close the sessions that are idle; the others close after their request."""
        with self._lock:
            self._closed = True
            idle, self._idle = self._idle, []
        for session in idle:
            session.close()
