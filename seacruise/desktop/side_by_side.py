"""Many passages on threads of this process, handed over as they come."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from typing import Final, TypeVar

from seacruise.progress import Job

Found = TypeVar("Found")

# The finder keeps the lattices used last, eight of them; more threads would push each other's out.
_MOST_THREADS: Final = 8
_LOOK_S: Final = 0.05


def as_they_come(one: Callable[[int], Found], count: int, job: Job, *, name: str) -> Iterator[Found]:
    """Compute on threads and yield in the order of completion; a core is left to the window.

    Parameters
    ----------
    one
        Computes the passage of a number, from 0.
    name
        Of the threads.

    Raises
    ------
    CancelledError
        The job was cancelled.
    """
    threads = min(_MOST_THREADS, max(1, (os.cpu_count() or 2) - 1))
    pool = ThreadPoolExecutor(max_workers=threads, thread_name_prefix=name)
    try:
        pending: set[Future[Found]] = {pool.submit(one, number) for number in range(count)}
        while pending:
            done, pending = wait(pending, timeout=_LOOK_S, return_when=FIRST_COMPLETED)
            for future in done:
                yield future.result()
            job.check()
    finally:
        # Cancelled, the threads end by themselves; nobody waits for them.
        pool.shutdown(wait=not job.cancel.is_set(), cancel_futures=True)
