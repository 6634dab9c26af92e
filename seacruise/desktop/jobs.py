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

from PySide6.QtCore import QCoreApplication, QObject, QTimer, Signal

from seacruise.desktop.thrift import give_back, share_arenas
from seacruise.errors import CancelledError, SeaCruiseError
from seacruise.progress import Job

log = logging.getLogger(__name__)

Work = Callable[[Job], Any]

_OUTLIVING: Final[list[QObject]] = []
"""Bridges whose workers had not ended when the window closed; freed by the end of the process."""


class _Mailbox:
    """What a worker may touch: the latest progress, and a function that wakes the window's thread."""

    def __init__(self, generation: int, wake: Callable[[int, str, object], None]) -> None:
        self.generation = generation
        self._wake = wake
        self._lock = threading.Lock()
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
        try:
            self._wake(self.generation, kind, value)
        except RuntimeError:
            log.debug("The window had closed before %s arrived.", kind)


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
        self._arrived.connect(self._receive)

    @property
    def is_running(self) -> bool:
        """Whether a result is still awaited."""
        return self._running is not None

    def run_job(self, work: Work) -> int:
        """Start a job on a thread of its own; returns its generation."""
        self.cancel()
        self._generation += 1
        mailbox = _Mailbox(self._generation, self._arrived.emit)
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
        if any(thread.is_alive() for thread in self._threads):
            log.info("%s: a worker had not ended when the window closed.", self._name)
            self.setParent(None)
            _OUTLIVING.append(self)

    def _receive(self, generation: int, kind: str, value: object) -> None:
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


def _run(work: Work, job: Job, mailbox: _Mailbox) -> None:
    try:
        result = work(job)
    except SeaCruiseError as error:
        mailbox.post("error", error)
    except Exception as error:
        log.exception("A calculation broke.")
        mailbox.post("error", unexpected(error))
    else:
        mailbox.post("result", result)


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
        Tells whether a calculation runs, which is no time for a full collection.
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

    def stop(self) -> None:
        """Give collection back to Python."""
        self._timer.stop()
        gc.unfreeze()
        gc.enable()

    def _tick(self) -> None:
        self._ticks += 1
        busy = self._is_busy()
        self._worked |= busy
        self._calm = 0 if busy else self._calm + 1
        after_work = self._worked and self._calm == self._CALM
        if not after_work and (busy or self._ticks % self._FULL_EVERY):
            gc.collect(0)
            return
        gc.collect(2)
        if self._worked:
            self._worked = False
            threading.Thread(target=give_back, name="thrift", daemon=True).start()
