"""Re-routing while something is dragged: runs what `follow` decides, on worker threads."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from PySide6.QtCore import QObject, QTimer, Signal

from seacruise.desktop.compute import Answer, Planner, Question, replan
from seacruise.desktop.follow import Follow, Turn
from seacruise.desktop.jobs import JobRunner
from seacruise.errors import SeaCruiseError
from seacruise.progress import Job
from seacruise.settings import Settings

REST_MS: Final = 140
"""A hand that has not moved for so long rests [ms]."""


@dataclass(frozen=True, slots=True)
class _Ended:
    """What a worker hands back; its time and its error travel together."""

    answer: Answer | None
    error: SeaCruiseError | None
    seconds: float


class LiveRouter(QObject):
    """Answers the newest of many questions about the wind of an earlier answer.

    Signals: ``routed(Answer)``, with ``rough`` set while the hand moves and re-routing is slow;
    ``failed(SeaCruiseError)`` when there is no passage - a rough search that finds none says nothing;
    ``rested(Answer)`` after the last of some ``routed`` passages, when the hand rests: what nobody reads
    while it moves is shown then.
    """

    routed = Signal(object)
    failed = Signal(object)
    rested = Signal(object)

    def __init__(self, settings: Settings, planner: Planner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._settings, self._planner = settings, planner
        self._follow: Follow[tuple[Question, Answer]] = Follow()
        self._turn: Turn[tuple[Question, Answer]] | None = None
        self._last: Answer | None = None
        self._runner = JobRunner("live", self)
        self._runner.finished.connect(self._ended)
        self._runner.failed.connect(lambda _, error: self._ended(0, _Ended(None, error, 0.0)))
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(REST_MS)
        self._rest.timeout.connect(self.settle)

    @property
    def is_busy(self) -> bool:
        """Whether an answer is still awaited."""
        return self._rest.isActive() or self._follow.is_busy

    def ask(self, question: Question, known: Answer) -> None:
        """Ask anew, in the wind of a known answer; supersedes every earlier question."""
        self._rest.start()
        self._run(self._follow.ask((question, known)))

    def settle(self) -> None:
        """Tell that the hand rests: now precisely."""
        self._rest.stop()
        self._run(self._follow.rest())
        self._tell_rest()

    def note(self, seconds: float) -> None:
        """Take note of the time [s] that a precise calculation took elsewhere."""
        self._follow.took(seconds)

    def cancel(self) -> None:
        """Drop everything that is asked."""
        self._rest.stop()
        self._last = None
        self._follow.forget()
        self._runner.cancel()

    def shut_down(self) -> None:
        """End the workers."""
        self.cancel()
        self._runner.shut_down()

    def _run(self, turn: Turn[tuple[Question, Answer]] | None) -> None:
        if turn is None:
            return
        self._turn = turn
        self._runner.run_job(_work(turn, self._settings, self._planner))

    def _ended(self, _generation: int, ended: _Ended) -> None:
        turn = self._turn
        # The next one is searched while this one is drawn.
        self._run(self._follow.ended(ended.seconds))
        if ended.answer is not None:
            self._last = ended.answer
            self.routed.emit(ended.answer)
        elif ended.error is not None and turn is not None and not turn.rough:
            self.failed.emit(ended.error)
        self._tell_rest()

    def _tell_rest(self) -> None:
        if self._last is not None and not self.is_busy:
            last, self._last = self._last, None
            self.rested.emit(last)


def _work(
    turn: Turn[tuple[Question, Answer]], settings: Settings, planner: Planner
) -> Callable[[Job], _Ended]:
    question, known = turn.wish

    def work(job: Job) -> _Ended:
        begun = time.perf_counter()
        answer: Answer | None = None
        failure: SeaCruiseError | None = None
        try:
            answer = replan(question, known, settings=settings, job=job, planner=planner, rough=turn.rough)
        except SeaCruiseError as error:
            job.check()
            failure = error
        return _Ended(answer, failure, time.perf_counter() - begun)

    return work
