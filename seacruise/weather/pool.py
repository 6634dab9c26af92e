"""Several slow requests at a time, given up in an instant."""

from __future__ import annotations

import queue
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Final, Generic, TypeVar

from seacruise.errors import WeatherError
from seacruise.progress import Job

T = TypeVar("T")
R = TypeVar("R")

_POLL_S: Final = 0.05


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

    Raises
    ------
    CancelledError
    """
    outcomes: list[Outcome[R] | None] = [None] * len(tasks)
    arrived: queue.SimpleQueue[tuple[int, Outcome[R]]] = queue.SimpleQueue()
    running: dict[int, _Running] = {}
    waiting = list(range(len(tasks)))
    end = time.monotonic() + batch_s
    done = 0

    def finish(index: int, outcome: Outcome[R]) -> None:
        nonlocal done
        done += 1
        outcomes[index] = outcome
        if not on_done(done, index, outcome):
            waiting.clear()

    try:
        while waiting or running:
            job.check()
            while waiting and len(running) < parallel and time.monotonic() < end:
                index = waiting.pop(0)
                running[index] = _Running(time.monotonic())
                _start(work, tasks[index], index, running[index].stop, arrived)
            try:
                index, outcome = arrived.get(timeout=_POLL_S)
                if running.pop(index, None) is not None:
                    finish(index, outcome)
            except queue.Empty:
                pass
            now = time.monotonic()
            for index in [one for one, state in running.items() if now > min(state.since + each_s, end)]:
                running.pop(index).stop.set()
                finish(index, Outcome(error=late()))
            if now > end:
                waiting.clear()
    finally:
        for state in running.values():
            state.stop.set()
    return [outcome if outcome is not None else Outcome(error=late()) for outcome in outcomes]


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
