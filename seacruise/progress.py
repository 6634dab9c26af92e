"""How a long job reports what it does and learns that it is no longer wanted."""

from __future__ import annotations

import threading
from dataclasses import dataclass, field
from typing import Protocol

from seacruise.errors import CancelledError


class Report(Protocol):
    """Receives progress: a stage, how much of it is done, and a sentence for the sailor."""

    def __call__(self, stage: str, fraction: float | None, message: str) -> None:
        """Take note of a stage, the part of it that is done, and a sentence."""


def silent(stage: str, fraction: float | None, message: str) -> None:
    """Report to nobody."""


@dataclass(frozen=True, slots=True)
class Job:
    """The two ends that a long job holds: where to report, and the event that cancels it.

    Stages are ``"sea"``, ``"lattice"``, ``"wind"``, ``"search"``, ``"refine"`` and ``"check"``;
    ``fraction`` runs from 0 to 1 within a stage and is ``None`` where it is not known.
    """

    report: Report = silent
    cancel: threading.Event = field(default_factory=threading.Event)

    def check(self) -> None:
        """Raise `CancelledError` when the job was cancelled; called often by long loops."""
        if self.cancel.is_set():
            raise CancelledError
