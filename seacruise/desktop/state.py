"""What the window is doing, without Qt: every state it can be in and what moves it on.

Every calculation has a number, its generation. Whatever arrives with another number than the present
one is of a calculation that was cancelled or superseded, and changes nothing.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from datetime import datetime, timedelta
from enum import Enum
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from seacruise.desktop.compute import Answer
    from seacruise.errors import SeaCruiseError

STAGES: Final = ("sea", "lattice", "wind", "search", "refine", "check")


class Phase(Enum):
    """The five things that the window can be doing."""

    EMPTY = "empty"
    COMPUTING = "computing"
    ROUTE = "route"
    FAILED = "failed"
    CANCELLED = "cancelled"


@dataclass(frozen=True, slots=True)
class Progress:
    """How far a calculation is.

    Attributes
    ----------
    stage
        The stage that runs, one of `STAGES`; ``None`` before the first report.
    done
        The stages that are behind it.
    fraction
        Share of the running stage, 0 to 1; ``None`` where it is not known.
    message
        What the stage says for itself, e.g. ``"wind 3 of 9"``.
    """

    stage: str | None = None
    done: frozenset[str] = frozenset()
    fraction: float | None = None
    message: str = ""

    def advanced(self, stage: str, fraction: float | None, message: str) -> Progress:
        """Progress after a report of a job; stages may come in any order, and more than once."""
        done = self.done
        if self.stage is not None and self.stage != stage:
            done |= {self.stage}
        return Progress(stage, done - {stage}, fraction, message)


@dataclass(frozen=True, slots=True)
class WindowState:
    """Everything that decides what the window shows.

    Attributes
    ----------
    answer
        The last passage found. It stays while another is computed, and when that one fails.
    answer_generation
        Which calculation found it: not the present one means that it is an earlier answer.
    """

    phase: Phase = Phase.EMPTY
    generation: int = 0
    progress: Progress = Progress()
    answer: Answer | None = None
    answer_generation: int = 0
    error: SeaCruiseError | None = None

    def started(self, generation: int) -> WindowState:
        """State when a calculation begins; it supersedes any other."""
        return replace(self, phase=Phase.COMPUTING, generation=generation, progress=Progress(), error=None)

    def _awaits(self, generation: int) -> bool:
        return self.phase is Phase.COMPUTING and generation == self.generation

    def progressed(self, generation: int, stage: str, fraction: float | None, message: str) -> WindowState:
        """State after a report of progress."""
        if not self._awaits(generation):
            return self
        return replace(self, progress=self.progress.advanced(stage, fraction, message))

    def finished(self, generation: int, answer: Answer) -> WindowState:
        """State when a calculation found a passage."""
        if not self._awaits(generation):
            return self
        return replace(self, phase=Phase.ROUTE, answer=answer, answer_generation=generation)

    def failed(self, generation: int, error: SeaCruiseError) -> WindowState:
        """State when a calculation ended with a sentence instead of a passage."""
        if not self._awaits(generation):
            return self
        return replace(self, phase=Phase.FAILED, error=error)

    def refused(self, error: SeaCruiseError) -> WindowState:
        """State when the form itself cannot be computed; nothing was started."""
        return replace(self, phase=Phase.FAILED, error=error)

    def rerouted(self, answer: Answer) -> WindowState:
        """State when the passage followed a hand that drags; a calculation that was asked for goes on."""
        if self.phase is Phase.COMPUTING:
            return self
        return replace(self, phase=Phase.ROUTE, answer=answer, answer_generation=self.generation, error=None)

    def cancelled(self) -> WindowState:
        """State after Cancel: at once, whatever the job still does."""
        return self if self.phase is not Phase.COMPUTING else replace(self, phase=Phase.CANCELLED)

    @property
    def answer_is_earlier(self) -> bool:
        """Whether the passage on the chart is not of the latest calculation."""
        return self.answer is not None and self.phase is not Phase.ROUTE


@dataclass(frozen=True, slots=True)
class Horizon:
    """The hours that a forecast covers, UTC."""

    first: datetime
    last: datetime

    def covers(self, moment: datetime) -> bool:
        """Whether a departure lies within."""
        return self.first <= moment <= self.last

    def default_departure(self, now: datetime) -> datetime:
        """Next full hour that the forecast covers: from now on, or its first when it is not of now."""
        hour = now.replace(minute=0, second=0, microsecond=0)
        if hour < now:
            hour += timedelta(hours=1)
        if self.covers(hour):
            return hour
        first = self.first.replace(minute=0, second=0, microsecond=0)
        return first if first >= self.first else first + timedelta(hours=1)
