"""Many passages at once: the same two ports for several departures, yachts and members of an ensemble.

``[PassageRequest, ...] -> plan, plan, plan -> Study``. The passages are computed on any executor of
`concurrent.futures`: threads by default, because the kernels release the interpreter and all threads then
share sea and lattices; a process pool or a cluster just as well.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import (
    FIRST_COMPLETED,
    BrokenExecutor,
    Executor,
    Future,
    ThreadPoolExecutor,
    wait,
)
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime, timedelta
from threading import Event
from typing import Final

import numpy as np

from seacruise.along import Position, sail_along, upwind_share, waypoints_of
from seacruise.between import sea_between
from seacruise.errors import CancelledError, InputError, SeaCruiseError
from seacruise.model import Passage, PassageRequest
from seacruise.passage import NOBODY, departure_of, plan
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.sun import night_hours
from seacruise.units import SECONDS_PER_HOUR
from seacruise.weather.beyond import extend_each
from seacruise.weather.wind import Forecast, Wind
from seacruise.yacht.polar import Polar

__all__ = ["Band", "Run", "Spread", "Study", "compare", "departures_from", "ensemble", "variants"]

HELD_SHARE: Final = 0.1
"""A passage sailed for more of its time on wind held beyond the forecast is no ground for a choice."""

QUANTILES: Final = (0.1, 0.5, 0.9)

MOST_RUNS: Final = 2000
"""More passages than this are not asked for by a person."""

# The finder keeps the lattices used last, eight of them; more threads would push each other's out.
_MOST_THREADS: Final = 8
_LOOK_S: Final = 0.05
_NEVER: Final = 1e15


@dataclass(frozen=True, slots=True)
class Spread:
    """The values that 10, 50 and 90 % of the members stay below; ``None`` where so many never arrive."""

    low: float | None
    middle: float | None
    high: float | None


@dataclass(frozen=True, slots=True)
class Band:
    """What the members of an ensemble make of a departure.

    Attributes
    ----------
    members
        One run each, the fastest passage in that member's wind; its ``followed_h`` is the time she needs
        there when she keeps to the passage of the wind they are members of.
    duration_h, followed_h
        10, 50 and 90 % of both [h].
    """

    members: tuple[Run, ...]
    duration_h: Spread
    followed_h: Spread

    @property
    def found(self) -> int:
        """How many members have a passage."""
        return sum(run.found for run in self.members)


@dataclass(frozen=True, slots=True)
class Run:
    """One passage of a study, or why there is none.

    Attributes
    ----------
    member
        Number of the member of the ensemble, from 0; ``None`` for the wind itself.
    duration_h ... beyond_forecast_h
        ``None`` when there is no passage. ``upwind_share`` is the part of the time that she sails closer to
        the true wind than `along.UPWIND_DEG`, ``night_h`` the hours with the sun more than 6 degrees below
        the horizon where she is.
    reason, message
        Why there is no passage, as a code and as a sentence; empty when there is one.
    followed_h
        Of a member: hours she needs in its wind along the waypoints of the wind itself; ``None`` where she
        does not arrive, or where it was not asked.
    """

    departure: datetime
    yacht: str
    member: int | None = None
    duration_h: float | None = None
    arrival: datetime | None = None
    distance_nm: float | None = None
    max_tws_kn: float | None = None
    upwind_share: float | None = None
    night_h: float | None = None
    motor_h: float | None = None
    beyond_forecast_h: float | None = None
    reason: str = ""
    message: str = ""
    followed_h: float | None = None
    band: Band | None = None
    passage: Passage | None = field(default=None, repr=False, compare=False)

    @property
    def found(self) -> bool:
        """Whether there is a passage."""
        return self.duration_h is not None

    @property
    def arrivals(self) -> tuple[datetime | None, ...]:
        """Arrivals by which 10, 50 and 90 % of the members are there; empty without members."""
        if self.band is None:
            return ()
        hours = (self.band.duration_h.low, self.band.duration_h.middle, self.band.duration_h.high)
        return tuple(None if h is None else self.departure + timedelta(hours=h) for h in hours)

    @property
    def is_forecast(self) -> bool:
        """Whether at most `HELD_SHARE` of the time is sailed on wind held beyond the forecast."""
        return (self.beyond_forecast_h or 0.0) <= HELD_SHARE * (self.duration_h or 0.0)


@dataclass(frozen=True, slots=True)
class Study:
    """The answer: a run a request, in the order they were asked."""

    start: str
    end: str
    forecast: Forecast
    runs: tuple[Run, ...]

    @property
    def yachts(self) -> tuple[str, ...]:
        """Yachts, in the order they were asked."""
        return tuple(dict.fromkeys(run.yacht for run in self.runs))

    def of_yacht(self, yacht: str) -> tuple[Run, ...]:
        """Give the runs of one yacht."""
        return tuple(run for run in self.runs if run.yacht == yacht)

    def best(self, yacht: str | None = None) -> Run | None:
        """Shortest passage, of all or of one yacht; ``None`` when there is none at all.

        Passages of which more than `HELD_SHARE` is sailed on held wind only count when there is no other.
        """
        found = [run for run in (self.of_yacht(yacht) if yacht else self.runs) if run.found]
        known = [run for run in found if run.is_forecast]
        return min(known or found, key=lambda run: (run.duration_h, run.departure), default=None)


def departures_from(request: PassageRequest, *, count: int, every: timedelta) -> list[datetime]:
    """Give the departures of a study: the first one that a passage would have, and others after it.

    Raises
    ------
    InputError
        The number or the interval makes no sense.
    NoPassageError
        The first one is outside the forecast.
    """
    if not 1 <= count <= MOST_RUNS or not timedelta(minutes=1) <= every <= timedelta(days=30):
        raise InputError(
            f"{count} departures every {every} cannot be compared; give 1 to {MOST_RUNS} of them, one minute "
            "to 30 days apart."
        )
    first = departure_of(request.wind, request.departure)
    return [first + k * every for k in range(count)]


def variants(
    request: PassageRequest, *, departures: Sequence[datetime], yachts: Sequence[Polar] = ()
) -> list[PassageRequest]:
    """Ask the same passage for each yacht and each departure."""
    return [
        replace(request, yacht=yacht, departure=departure)
        for yacht in yachts or (request.yacht,)
        for departure in departures
    ]


def compare(
    requests: Sequence[PassageRequest],
    *,
    settings: Settings,
    executor: Executor | None = None,
    job: Job = NOBODY,
    members: bool = True,
) -> Study:
    """Plan many passages between the same two ports and put their figures side by side.

    What one of them meets - no wind, a closed forecast - is told in its own run and spoils no other.

    Parameters
    ----------
    executor
        Where to compute: threads of this process by default, which share what they read. Requests and
        answers are pickled for any other executor than a `ThreadPoolExecutor`; what it has begun when the
        job is cancelled ends there and is thrown away.
    members
        Plan each request for every member of its wind's ensemble too; no effect on a wind without members.

    Raises
    ------
    InputError
        There is no request, or there are too many.
    CancelledError
        The job was cancelled.
    """
    if not requests:
        raise InputError("There is nothing to compare; give at least one departure.")
    runs_asked = sum(1 + (len(request.wind.members) if members else 0) for request in requests)
    if runs_asked > MOST_RUNS:
        raise InputError(
            f"{runs_asked} passages are too many at once (the most is {MOST_RUNS}); ask for fewer departures."
        )
    # Before the members go their own ways: they fade to their common mean.
    winds = extend_each([(request.wind, request.options.beyond) for request in requests])
    requests = [replace(request, wind=wind) for request, wind in zip(requests, winds, strict=True)]
    with _pool(executor, job) as (pool, cancel):
        progress = _Progress(job, runs_asked)
        own = [_Task(_without_members(request), settings) for request in requests]
        runs = _run_all(pool, own, cancel=cancel, progress=progress)
        if members:
            tasks = [
                _Task(
                    _of_member(request, wind, run.departure),
                    settings,
                    number,
                    tuple(waypoints_of(run.passage)) if run.passage else (),
                )
                for request, run in zip(requests, runs, strict=True)
                for number, wind in enumerate(request.wind.members)
            ]
            after = iter(_run_all(pool, tasks, cancel=cancel, progress=progress))
            runs = [
                _with_band(run, [next(after) for _ in request.wind.members])
                for request, run in zip(requests, runs, strict=True)
            ]
    first = requests[0]
    return Study(first.start.name, first.end.name, first.wind.forecast, tuple(runs))


def ensemble(
    request: PassageRequest,
    *,
    settings: Settings,
    executor: Executor | None = None,
    job: Job = NOBODY,
) -> Band:
    """Route every member of a wind's ensemble, and sail the passage of the wind itself in each of them.

    Raises
    ------
    InputError
        The wind has no members.
    CancelledError
        The job was cancelled.
    """
    if not request.wind.members:
        raise InputError(
            f"The wind ({request.wind.forecast.source}) is no ensemble; choose a forecast with members."
        )
    (run,) = compare([request], settings=settings, executor=executor, job=job).runs
    assert run.band is not None
    return run.band


# ---------------------------------------------------------------------------------------- the work


@dataclass(frozen=True, slots=True)
class _Task:
    """One passage to be planned, somewhere.

    Attributes
    ----------
    follow
        Waypoints to sail along besides, in the same wind; empty for none.
    """

    request: PassageRequest
    settings: Settings
    member: int | None = None
    follow: tuple[Position, ...] = ()


def _run(task: _Task, cancel: Event | None) -> Run:
    """Plan a passage; a module's own function, so that it can be sent to other processes."""
    job = NOBODY if cancel is None else Job(cancel=cancel)
    request = task.request
    departure = request.departure or datetime.now(UTC)
    try:
        departure = departure_of(request.wind, request.departure)
        run = _figures(plan(request, settings=task.settings, job=job), member=task.member)
    except CancelledError:
        raise
    except SeaCruiseError as error:
        run = _none(task, departure, error.reason, str(error))
    if task.follow:
        job.check()
        sea = sea_between(request.start, request.end, task.settings)
        sailed = sail_along(request, task.follow, departure=departure.timestamp(), sea=sea)
        if sailed.arrived:
            hours = (float(sailed.time[-1]) - departure.timestamp()) / SECONDS_PER_HOUR
            run = replace(run, followed_h=hours)
    return run


def _none(task: _Task, departure: datetime, reason: str, message: str) -> Run:
    return Run(departure, task.request.yacht.name, task.member, reason=reason, message=message)


def _figures(passage: Passage, *, member: int | None) -> Run:
    track = passage.track
    return Run(
        departure=passage.departure,
        yacht=passage.yacht,
        member=member,
        duration_h=passage.duration_h,
        arrival=passage.arrival,
        distance_nm=passage.distance_nm,
        max_tws_kn=passage.max_tws_kn,
        upwind_share=upwind_share(track),
        night_h=night_hours(track.time, track.lat, track.lon),
        motor_h=passage.motor_h,
        beyond_forecast_h=passage.beyond_forecast_h,
        # The edges of the lattice are megabytes that nobody draws for a table.
        passage=replace(passage, lattice_edges=None),
    )


def _without_members(request: PassageRequest) -> PassageRequest:
    """Leave the members behind: a process that plans in their mean need not be sent all of them."""
    return replace(request, wind=replace(request.wind, members=())) if request.wind.members else request


def _of_member(request: PassageRequest, wind: Wind, departure: datetime) -> PassageRequest:
    """Ask the same in the wind of a member; the current is the one of the whole forecast."""
    return replace(request, wind=wind, departure=departure, current=request.current or request.wind.current)


class _Progress:
    """Counts the passages that are done."""

    def __init__(self, job: Job, total: int) -> None:
        self.job, self.total, self.done = job, total, 0

    def step(self) -> None:
        """Report one more."""
        self.done += 1
        self.job.report("search", self.done / self.total, f"Passage {self.done} of {self.total}")


@contextmanager
def _pool(executor: Executor | None, job: Job) -> Iterator[tuple[Executor, Callable[[], Event | None]]]:
    """Give the executor and what cancels the tasks on it; threads of our own end with it."""
    if executor is not None:
        shared = job.cancel if isinstance(executor, ThreadPoolExecutor) else None
        yield executor, lambda: _checked(job, shared)
        return
    own = ThreadPoolExecutor(max_workers=min(_MOST_THREADS, os.cpu_count() or 1))
    try:
        yield own, lambda: _checked(job, job.cancel)
    finally:
        # Cancelled, the threads end by themselves; who cancelled need not wait for them.
        own.shutdown(wait=not job.cancel.is_set(), cancel_futures=True)


def _checked(job: Job, shared: Event | None) -> Event | None:
    job.check()
    return shared


def _run_all(
    pool: Executor,
    tasks: Sequence[_Task],
    *,
    cancel: Callable[[], Event | None],
    progress: _Progress,
) -> list[Run]:
    """Compute all tasks; when the job is cancelled, those not begun are dropped and the others told."""
    event = cancel()
    futures: dict[Future[Run], int] = {}
    runs: list[Run | None] = [None] * len(tasks)
    try:
        futures = {pool.submit(_run, task, event): k for k, task in enumerate(tasks)}
        pending = set(futures)
        while pending:
            done, pending = wait(pending, timeout=_LOOK_S, return_when=FIRST_COMPLETED)
            for future in done:
                runs[futures[future]] = future.result()
                progress.step()
            cancel()
    except BrokenExecutor:
        raise SeaCruiseError(
            "A helper process that computed passages ended before its time; try again with fewer of them.",
            reason="worker-lost",
        ) from None
    finally:
        for future in futures:
            future.cancel()
    return [run for run in runs if run is not None]


def _with_band(run: Run, members: Sequence[Run]) -> Run:
    if not members:
        return run
    band = Band(
        tuple(replace(member, passage=None) for member in members),
        spread_of([member.duration_h for member in members]),
        spread_of([member.followed_h for member in members]),
    )
    return replace(run, band=band)


def spread_of(hours: Sequence[float | None]) -> Spread:
    """Quantiles of durations [h], of which ``None`` takes for ever; at least one of them."""
    values = [_NEVER if value is None else value for value in hours]
    # Between a number and never there is nothing: only a quantile that lies among numbers is one.
    low, middle, high = (float(q) for q in np.quantile(values, QUANTILES))
    return Spread(*(None if q > _NEVER * 1e-9 else q for q in (low, middle, high)))
