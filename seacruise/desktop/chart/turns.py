"""Frames first: a worker that paints stands aside while the window's thread draws.

The window's thread gives Python's lock up after 0.2 ms to a worker that asks for it, and each thing a worker
paints keeps it for up to some milliseconds: a frame of 15 ms would take 60.
"""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Final

from seacruise.progress import Job

_PATIENCE_S: Final = 0.05
"""A worker goes one step on after so long, so that it ends however many frames there are."""


class Turns:
    """Tells workers when the window's thread draws."""

    def __init__(self) -> None:
        self._free = threading.Event()
        self._free.set()

    @contextmanager
    def drawing(self) -> Iterator[None]:
        """Hold workers back meanwhile; for the window's thread only."""
        self._free.clear()
        try:
            yield
        finally:
            self._free.set()

    def stand_aside(self) -> bool:
        """Wait while the window's thread draws; False when that takes too long to be waited for."""
        return self._free.wait(_PATIENCE_S)


@dataclass(frozen=True, slots=True)
class PoliteJob(Job):
    """A job that stands aside at each of its checks."""

    turns: Turns = field(default_factory=Turns)

    def check(self) -> None:
        """Wait for the window's thread, then raise `CancelledError` when the job was cancelled."""
        self.turns.stand_aside()
        # A class with slots is made anew by its decorator: super() without arguments does not know it.
        Job.check(self)
