"""Long jobs beside the window: one worker thread a job, cancelled by an event, superseded by number.

Workers own no QObject. They hold a plain mailbox; its bridge to the window is a QObject that is made,
kept and freed on the window's thread (a QObject whose last reference dies on another thread takes the
program with it).
"""

from __future__ import annotations

import gc
import logging
import threading
import time
from collections.abc import Callable
from typing import Any, Final

from PySide6.QtCore import QCoreApplication, QEvent, QObject, QTimer, Signal

from seacruise.desktop.thrift import give_back, share_arenas
from seacruise.errors import CancelledError, SeaCruiseError
from seacruise.progress import Job

log = logging.getLogger(__name__)

Work = Callable[[Job], Any]

_OUTLIVING: Final[list[JobRunner]] = []
"""Bridges whose workers had not ended when their window closed; freed when they have, or with the process."""


class _Mailbox:
    """What a worker may touch: the latest progress, and a function that wakes the window's thread."""

    def __init__(self, generation: int, wake: Callable[[int, str, object], None]) -> None:
        self.generation = generation
        self._wake = wake
        self._lock, self._wake_lock = threading.Lock(), threading.Lock()
        self._progress: list[tuple[str, float | None, str]] = []

    def report(self, stage: str, fraction: float | None, message: str) -> None:
        """Keep the newest report of each stage; ten thousand of them wake the window once."""
        with self._lock:
            awake = bool(self._progress)
            if awake and self._progress[-1][0] == stage:
                self._progress.pop()
            self._progress.append((stage, fraction, message))
        if not awake:
            self.post("progress", None)

    def take_progress(self) -> list[tuple[str, float | None, str]]:
        """Take the reports out, in their order."""
        with self._lock:
            progress, self._progress = self._progress, []
        return progress

    def post(self, kind: str, value: object) -> None:
        """Hand something to the window's thread; a window that is gone needs nothing."""
        with self._wake_lock:
            try:
                self._wake(self.generation, kind, value)
            except RuntimeError:
                log.debug("The window had closed before %s arrived.", kind)

    def turn_to(self, wake: Callable[[int, str, object], None]) -> None:
        """Wake somebody else from now on."""
        with self._wake_lock:
            self._wake = wake


class JobRunner(QObject):
    """Runs one job at a time; starting another supersedes the one that runs.

    Signals carry the generation that `run_job` returned: ``progressed(generation, stage, fraction,
    message)``, ``finished(generation, result)``, ``failed(generation, error)`` with a `SeaCruiseError`.
    Nothing of a cancelled or superseded job is ever emitted.
    """

    progressed = Signal(int, str, object, str)
    finished = Signal(int, object)
    failed = Signal(int, object)
    _arrived = Signal(int, str, object)

    def __init__(self, name: str, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._name = name
        self._generation = 0
        self._running: tuple[Job, _Mailbox] | None = None
        self._threads: list[threading.Thread] = []
        self._heir: JobRunner | None = None
        self._arrived.connect(self.receive)

    @property
    def is_running(self) -> bool:
        """Whether a result is still awaited."""
        return self._running is not None

    def run_job(self, work: Work) -> int:
        """Start a job on a thread of its own; returns its generation."""
        self.cancel()
        self._generation += 1
        mailbox = _Mailbox(self._generation, self.wake)
        job = Job(report=mailbox.report)
        self._running = (job, mailbox)
        # A daemon: a service that does not answer must not keep a closed program alive.
        thread = threading.Thread(
            target=_run, args=(work, job, mailbox), name=f"{self._name}-{self._generation}", daemon=True
        )
        self._threads = [*(t for t in self._threads if t.is_alive()), thread]
        thread.start()
        return self._generation

    def cancel(self) -> bool:
        """Drop the job that runs, at once; it ends itself at its next check. False when none runs."""
        if self._running is None:
            return False
        self._running[0].cancel.set()
        self._running = None
        return True

    def shut_down(self, patience_s: float = 2.0) -> None:
        """Cancel, and wait for the workers, but not longer than that."""
        self.cancel()
        deadline = time.monotonic() + patience_s
        for thread in self._threads:
            thread.join(max(0.0, deadline - time.monotonic()))
        if self.has_workers:
            log.info("%s: a worker had not ended when the window closed.", self._name)
            self.setParent(None)
            _OUTLIVING.append(self)

    def hand_over(self, heir: JobRunner) -> None:
        """Let another runner of this thread await what is awaited here; nothing that arrives is lost."""
        if self._running is None:
            return
        job, mailbox = self._running
        heir.inherit(job, mailbox, self._threads)
        mailbox.turn_to(heir.wake)
        self._heir, self._running, self._threads = heir, None, []
        # What had been posted to this one before is passed on while it lives.
        QCoreApplication.sendPostedEvents(self, QEvent.Type.MetaCall.value)

    def inherit(self, job: Job, mailbox: _Mailbox, threads: list[threading.Thread]) -> None:
        """Await a job that another runner has begun, by the number it has."""
        self.cancel()
        self._generation, self._running = mailbox.generation, (job, mailbox)
        self._threads = [*self._threads, *threads]

    @property
    def has_workers(self) -> bool:
        """Whether a thread still lives."""
        return any(thread.is_alive() for thread in self._threads)

    @property
    def wake(self) -> Callable[[int, str, object], None]:
        """What a worker calls from its own thread."""
        return self._arrived.emit

    def receive(self, generation: int, kind: str, value: object) -> None:
        """Take what a worker has posted, on the thread of this runner."""
        if self._heir is not None:
            self._heir.receive(generation, kind, value)
            return
        if self._running is None or generation != self._running[1].generation:
            return
        if kind == "progress":
            for report in self._running[1].take_progress():
                self.progressed.emit(generation, *report)
            return
        self._running = None
        if kind == "result":
            self.finished.emit(generation, value)
        elif not isinstance(value, CancelledError):
            self.failed.emit(generation, value)


class _Workshop:
    """Counts the jobs that are at work, also those whose result nobody awaits any more."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self.at_work = 0

    def __enter__(self) -> None:
        with self._lock:
            self.at_work += 1

    def __exit__(self, *_: object) -> None:
        with self._lock:
            self.at_work -= 1


_WORKSHOP: Final = _Workshop()


def _run(work: Work, job: Job, mailbox: _Mailbox) -> None:
    with _WORKSHOP:
        _do(work, job, mailbox)


def _do(work: Work, job: Job, mailbox: _Mailbox) -> None:
    try:
        result = work(job)
    except SeaCruiseError as error:
        mailbox.post("error", error)
    except Exception as error:
        if job.cancel.is_set():
            # Nobody waits for it, and a process that ends takes from its workers what they need.
            log.debug("A calculation that was cancelled broke.", exc_info=True)
            return
        log.exception("A calculation broke.")
        mailbox.post("error", unexpected(error))
    else:
        mailbox.post("result", result)


def are_workers_left() -> bool:
    """Whether a worker of a window that is gone has not ended; bridges without one are freed."""
    _OUTLIVING[:] = [runner for runner in _OUTLIVING if runner.has_workers]
    return bool(_OUTLIVING)


def unexpected(error: BaseException) -> SeaCruiseError:
    """Sentence for a fault of the program itself, which is in the log with all its details."""
    text = QCoreApplication.translate(
        "jobs",
        "SeaCruise made a mistake of its own ({kind}); what you had is kept. "
        "The details are in seacruise.log: see Help, About.",
    )
    return SeaCruiseError(text.format(kind=type(error).__name__), reason="internal")


class GarbageKeeper(QObject):
    """Collects Python's cycles on the window's thread only.

    Python collects wherever it happens to be, and a QObject in a cycle that is collected by a worker is
    destroyed on the wrong thread. A full collection walks the whole heap, libraries included, and would
    block for several frames; `settle` takes what never dies out of it.

    Parameters
    ----------
    is_busy
        Tells whether a calculation runs that is awaited, which is no time for a full collection.
    """

    _INTERVAL_MS = 100
    _FULL_EVERY = 200
    _CALM = 20

    def __init__(self, is_busy: Callable[[], bool], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._is_busy = is_busy
        self._worked = False
        self._calm = 0
        self._ticks = 0
        self._giving: threading.Thread | None = None
        self._timer = QTimer(self)
        self._timer.setInterval(self._INTERVAL_MS)
        self._timer.timeout.connect(self._tick)

    def start(self) -> None:
        """Take over from the automatic collector."""
        gc.disable()
        share_arenas()
        self.settle()
        self._timer.start()

    def settle(self) -> None:
        """Regard everything that lives now as permanent: modules, compiled kernels, the window itself."""
        gc.freeze()

    def renew(self) -> None:
        """Collect everything that nobody needs any more, and regard what is left as permanent."""
        gc.disable()
        gc.unfreeze()
        gc.collect(2)
        self.settle()

    @property
    def is_at_rest(self) -> bool:
        """Whether nothing has been computed since freed memory was given back."""
        given = self._giving is None or not self._giving.is_alive()
        return given and not self._worked and self._calm > self._CALM

    def stop(self) -> None:
        """Give collection back to Python."""
        self._timer.stop()
        gc.unfreeze()
        gc.enable()

    def _tick(self) -> None:
        self._ticks += 1
        busy = self._is_busy() or _WORKSHOP.at_work > 0
        self._worked |= busy
        self._calm = 0 if busy else self._calm + 1
        after_work = self._worked and self._calm == self._CALM
        if not after_work and (busy or self._ticks % self._FULL_EVERY):
            gc.collect(0)
            return
        gc.collect(2)
        if self._worked:
            self._worked = False
            self._giving = threading.Thread(target=give_back, name="thrift", daemon=True)
            self._giving.start()
