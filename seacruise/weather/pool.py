"""Several slow requests at a time, given up in an instant."""

from __future__ import annotations

import math
import queue
import threading
import time
import weakref
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Final, Generic, TypeVar

from seacruise.errors import WeatherError
from seacruise.progress import Job

T = TypeVar("T")
R = TypeVar("R")

_POLL_S: Final = 0.05


class Gate:
    """The connections that all plans of this process together may have open to a service.

    Parameters
    ----------
    places
        Tasks at a time.

    Attributes
    ----------
    heard
        When the service last showed that it is alive, on the monotonic clock [s].
    """

    def __init__(self, places: int) -> None:
        self.heard = -math.inf
        self._free = threading.Semaphore(places)

    def enter(self, timeout: float) -> bool:
        """Take a place, waiting up to ``timeout`` [s] for one; tells whether there was one."""
        return self._free.acquire(timeout=timeout)

    def leave(self) -> None:
        """Give the place back."""
        self._free.release()


_gates: weakref.WeakValueDictionary[tuple[str, int], Gate] = weakref.WeakValueDictionary()
_gates_lock = threading.Lock()


def gate_to(address: str, places: int) -> Gate:
    """Get the one gate of this process to an address."""
    with _gates_lock:
        gate = _gates.get((address, places))
        if gate is None:
            gate = _gates[address, places] = Gate(places)
        return gate


@dataclass(slots=True)
class _Running:
    since: float
    stop: threading.Event = field(default_factory=threading.Event)


@dataclass(frozen=True, slots=True)
class Outcome(Generic[R]):
    """What one task came to: a value, or the error that ended it."""

    value: R | None = None
    error: WeatherError | None = None


def run_all(
    tasks: Sequence[T],
    work: Callable[[T, threading.Event], R],
    *,
    job: Job,
    parallel: int,
    each_s: float,
    batch_s: float,
    on_done: Callable[[int, int, Outcome[R]], bool],
    late: Callable[[], WeatherError],
    quiet_s: float = math.inf,
    gate: Gate | None = None,
) -> list[Outcome[R]]:
    """Do all tasks, a few at a time, each in a thread of its own.

    A thread stuck in a socket cannot be stopped from outside, so it is left behind: at its deadline, at
    the deadline of the batch, or when the job is cancelled, which is noticed within `_POLL_S`. The threads
    are daemons, unlike those of `concurrent.futures`, which Python waits for when the program ends.

    Parameters
    ----------
    work
        Does one task; its event is set when nobody waits for it any more.
    each_s, batch_s
        Deadlines [s] of one task and of all of them.
    on_done
        Told the number of finished tasks, the index of the latest and its outcome; ``False`` from it
        means that no further task is started.
    late
        Makes the error of a task that missed its deadline.
    quiet_s
        How long nothing may come from the service, to nobody, before all tasks are given up [s].
    gate
        Passed by each task while it runs. The time that a batch waits before it with nothing under way is
        not its own, and counts towards no deadline.

    Raises
    ------
    CancelledError
    """
    batch = _Batch(gate or Gate(parallel), on_done, late, len(tasks), time.monotonic() + batch_s)
    try:
        while batch.waiting or batch.running:
            job.check()
            if batch.admit(tasks, work, parallel):
                batch.receive()
                batch.give_up(each_s, quiet_s)
    finally:
        batch.abandon()
    return [outcome if outcome is not None else Outcome(error=late()) for outcome in batch.outcomes]


class _Batch(Generic[R]):
    """The tasks of one call of `run_all`: those waiting, those under way, and what the others came to."""

    def __init__(
        self,
        gate: Gate,
        on_done: Callable[[int, int, Outcome[R]], bool],
        late: Callable[[], WeatherError],
        count: int,
        end: float,
    ) -> None:
        self.outcomes: list[Outcome[R] | None] = [None] * count
        self.waiting = list(range(count))
        self.running: dict[int, _Running] = {}
        self._gate, self._on_done, self._late = gate, on_done, late
        self._arrived: queue.SimpleQueue[tuple[int, Outcome[R]]] = queue.SimpleQueue()
        self._heard = time.monotonic()
        self._end = end
        self._done = 0

    def admit(self, tasks: Sequence[T], work: Callable[[T, threading.Event], R], parallel: int) -> bool:
        """Start what may be started; tells whether anything is under way."""
        now = time.monotonic()
        if now >= self._end:
            self.waiting.clear()
        while self.waiting and len(self.running) < parallel:
            if not self._gate.enter(0.0 if self.running else _POLL_S):
                break
            index = self.waiting.pop(0)
            self.running[index] = _Running(time.monotonic())
            _start(work, tasks[index], index, self.running[index].stop, self._arrived)
        if not self.running:
            waited = time.monotonic() - now
            self._end += waited
            self._heard += waited
        return bool(self.running)

    def receive(self) -> None:
        """Wait a moment for one that is done."""
        try:
            index, outcome = self._arrived.get(timeout=_POLL_S)
        except queue.Empty:
            return
        if self.running.pop(index, None) is None:
            return
        if outcome.error is None or outcome.error.reason != "timeout":
            self._heard = self._gate.heard = time.monotonic()
        self._finish(index, outcome)

    def give_up(self, each_s: float, quiet_s: float) -> None:
        """Leave those behind that are late, and all of them when the service says nothing any more."""
        now = time.monotonic()
        is_silent = now - max(self._heard, self._gate.heard) > quiet_s
        late = [i for i, one in self.running.items() if is_silent or now > min(one.since + each_s, self._end)]
        if is_silent:
            self.waiting.clear()
        for index in late:
            self.running.pop(index).stop.set()
            self._finish(index, Outcome(error=self._late()))

    def abandon(self) -> None:
        """Leave all behind that are still under way."""
        for state in self.running.values():
            state.stop.set()
            self._gate.leave()

    def _finish(self, index: int, outcome: Outcome[R]) -> None:
        self._done += 1
        self.outcomes[index] = outcome
        self._gate.leave()
        if not self._on_done(self._done, index, outcome):
            self.waiting.clear()


def _start(
    work: Callable[[T, threading.Event], R],
    task: T,
    index: int,
    stop: threading.Event,
    arrived: queue.SimpleQueue[tuple[int, Outcome[R]]],
) -> None:
    def run() -> None:
        outcome: Outcome[R]
        try:
            outcome = Outcome(value=work(task, stop))
        except WeatherError as error:
            outcome = Outcome(error=error)
        except Exception as error:  # noqa: BLE001 (a thread that dies silently would look like a timeout)
            outcome = Outcome(
                error=WeatherError(f"The weather could not be fetched ({type(error).__name__}).")
            )
        arrived.put((index, outcome))

    threading.Thread(target=run, name=f"weather-{index}", daemon=True).start()
