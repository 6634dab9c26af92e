"""When to leave: passages of many departures as they come in, and which one is best; without Qt."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import datetime, timedelta
from enum import Enum
from typing import TYPE_CHECKING, Final, Literal, Protocol

from seacruise.desktop.compute import Answer, Fetcher, Question, fetch_wind, refuse_same_port
from seacruise.desktop.side_by_side import as_they_come
from seacruise.errors import InputError
from seacruise.progress import Job
from seacruise.sea.zones import Zones
from seacruise.study import MOST_RUNS, Run, Study
from seacruise.units import SECONDS_PER_HOUR

if TYPE_CHECKING:
    from seacruise.passage import PassageRequest
    from seacruise.settings import Settings
    from seacruise.weather.wind import Forecast
    from seacruise.yacht.polar import Polar

SAME_H: Final = 5.0 / 60.0
"""Passages that differ by less [h] are equally long to a sailor."""

Measure = Literal["duration", "arrival"]


class Comparer(Protocol):
    """`seacruise.study.compare`, or what a test puts in its place."""

    def __call__(
        self, requests: Sequence[PassageRequest], *, settings: Settings, job: Job, members: bool
    ) -> Study:
        """Plan the passages."""
        ...


def compare_passages(
    requests: Sequence[PassageRequest], *, settings: Settings, job: Job, members: bool
) -> Study:
    """`seacruise.study.compare` on threads of this process."""
    from seacruise.study import compare

    return compare(requests, settings=settings, job=job, members=members)


@dataclass(frozen=True, slots=True)
class Wish:
    """What is to be compared.

    Attributes
    ----------
    question
        Its departure is the first one.
    yachts
        Besides the one of the question.
    members
        Plan for the members of an ensemble too; no effect where the forecast has none.
    """

    question: Question
    count: int
    every: timedelta
    yachts: tuple[Polar, ...] = ()
    members: bool = True

    @property
    def fleet(self) -> tuple[Polar, ...]:
        """All yachts, that of the question first."""
        return (self.question.yacht, *self.yachts)


@dataclass(frozen=True, slots=True)
class Begun:
    """The departures are known; their passages follow.

    Attributes
    ----------
    slots
        Departure and yacht of each passage that follows.
    """

    start: str
    end: str
    forecast: Forecast
    slots: tuple[tuple[datetime, str], ...]


@dataclass(frozen=True, slots=True)
class Arrived:
    """One passage, or why there is none; the same one again when its band is known."""

    number: int
    run: Run


Delivery = Begun | Arrived


# ------------------------------------------------------------------------------------------ the work


def compare_departures(
    wish: Wish,
    *,
    settings: Settings,
    job: Job,
    deliver: Callable[[Delivery], None],
    known: Answer | None = None,
    fetcher: Fetcher = fetch_wind,
    comparer: Comparer = compare_passages,
) -> None:
    """Plan passage after passage and hand each over as soon as it is found.

    The winds of the members come after all departures: the curve is there long before its band.

    Parameters
    ----------
    deliver
        Called on this thread, before the progress is reported.
    known
        An answer whose wind is used when it is of the same forecast and covers both ports.

    Raises
    ------
    SeaCruiseError
        Why nothing can be compared; `CancelledError` when the job was cancelled.
    """
    from seacruise.study import departures_from, variants

    request = _request(wish.question, known, settings=settings, job=job, fetcher=fetcher)
    departures = departures_from(request, count=wish.count, every=wish.every)
    requests = variants(request, departures=departures, yachts=wish.fleet)
    members = len(request.wind.members) if wish.members else 0
    _refuse_too_many(len(requests), members)
    slots = tuple((departures[k % len(departures)], one.yacht.name) for k, one in enumerate(requests))
    deliver(Begun(request.start.name, request.end.name, request.wind.forecast, slots))
    job.report("search", 0.0, f"Passage 1 of {len(requests)}")
    total, done = len(requests) * (1 + members), 0
    quiet = Job(cancel=job.cancel)

    def one(number: int) -> Arrived:
        study = comparer([requests[number]], settings=settings, job=quiet, members=False)
        return Arrived(number, study.runs[0])

    for arrived in as_they_come(one, len(requests), job, name="departures"):
        done += 1
        deliver(arrived)
        job.report("search", done / total, f"Passage {done} of {len(requests)}")
    for number in range(len(requests) if members else 0):
        # Its members are computed on all cores, so one departure at a time.
        study = comparer([requests[number]], settings=settings, job=quiet, members=True)
        done += members
        deliver(Arrived(number, study.runs[0]))
        job.report("search", done / total, f"{members} members of departure {number + 1} of {len(requests)}")


def _request(
    question: Question, known: Answer | None, *, settings: Settings, job: Job, fetcher: Fetcher
) -> PassageRequest:
    from seacruise.passage import PassageRequest
    from seacruise.sea.zones import layer_files, load_zones

    refuse_same_port(question.start, question.end)
    job.check()
    if known is not None and _same_wind(question, known):
        wind, layers = known.wind, known.layers
    else:
        job.report("wind", None, "Getting the wind")
        wind = fetcher(question, settings, job)
        layers = load_zones(layer_files(settings.layers))
    job.check()
    return PassageRequest(
        question.start,
        question.end,
        question.yacht,
        wind,
        question.departure,
        question.options,
        Zones((*layers.zones, *question.avoid)),
    )


def _same_wind(question: Question, known: Answer) -> bool:
    """Whether the wind of an answer does for a question: the same forecast, over both of its ports."""
    ends = [(port.lat, port.lon) for port in (question.start, question.end)]
    if (question.forecast, question.weights) != (known.question.forecast, known.question.weights):
        return False
    return bool(known.wind.covers(*zip(*ends, strict=True)).all())


def _refuse_too_many(passages: int, members: int) -> None:
    if passages * (1 + members) > MOST_RUNS:
        each = f", each for {members} members of the ensemble," if members else ""
        raise InputError(
            f"{passages} passages{each} are too many at once (the most is {MOST_RUNS}); ask for fewer "
            "departures."
        )


# --------------------------------------------------------------------------------- what has come so far


class Outcome(Enum):
    """What can be said about the departures of a yacht."""

    WAITING = "waiting"
    NONE = "none"
    ONLY = "only"
    EQUAL = "equal"
    PRESENT = "present"
    OTHER = "other"
    UNLIKE_PRESENT = "unlike-present"
    LESS_HELD = "less-held"
    BEYOND = "beyond"


@dataclass(frozen=True, slots=True)
class Verdict:
    """The best departure of a yacht.

    Attributes
    ----------
    best
        ``None`` while, or because, there is no passage at all.
    against
        The present departure where there is a passage then; with ``PRESENT`` and ``EQUAL`` the longest one.
    """

    yacht: str
    outcome: Outcome
    best: Run | None = None
    against: Run | None = None

    @property
    def hours(self) -> float:
        """What the best departure saves [h]; less than nothing where a shorter passage is on held wind."""
        if self.best is None or self.against is None:
            return 0.0
        return (self.against.duration_h or 0.0) - (self.best.duration_h or 0.0)


@dataclass(frozen=True, slots=True)
class Row:
    """One departure of one yacht.

    Attributes
    ----------
    number
        As in `Arrived`.
    run
        ``None`` while it is not known.
    """

    number: int
    departure: datetime
    yacht: str
    run: Run | None
    is_best: bool = False

    @property
    def found(self) -> bool:
        """Whether there is a passage."""
        return self.run is not None and self.run.found


@dataclass(frozen=True, slots=True)
class Dot:
    """A departure on the curve.

    Attributes
    ----------
    time
        Of departure [s since 1970].
    value, low, middle, high
        Duration, or arrival since 1970 [h], of the passage and of 10, 50 and 90 % of the members; ``None``
        where it is not known or there is none.
    """

    number: int
    time: float
    value: float | None
    low: float | None = None
    middle: float | None = None
    high: float | None = None


@dataclass(frozen=True, slots=True)
class Curve:
    """The departures of one yacht, earliest first."""

    yacht: str
    dots: tuple[Dot, ...]


class Comparison:
    """Departures and what has come of them so far.

    Parameters
    ----------
    begun
        The departures.
    """

    def __init__(self, begun: Begun) -> None:
        self.begun = begun
        self._runs: list[Run | None] = [None] * len(begun.slots)

    def add(self, arrived: Arrived) -> None:
        """Take note of a passage."""
        self._runs[arrived.number] = arrived.run

    @property
    def known(self) -> int:
        """How many are known."""
        return sum(run is not None for run in self._runs)

    @property
    def yachts(self) -> tuple[str, ...]:
        """Yachts, in the order they were asked."""
        return tuple(dict.fromkeys(yacht for _, yacht in self.begun.slots))

    @property
    def present(self) -> datetime:
        """The first departure, against which the others are held."""
        return self.begun.slots[0][0]

    @property
    def has_bands(self) -> bool:
        """Whether any band of an ensemble is known."""
        return any(run is not None and run.band is not None for run in self._runs)

    def study(self) -> Study:
        """Give what is known so far."""
        begun = self.begun
        return Study(begun.start, begun.end, begun.forecast, tuple(run for run in self._runs if run))

    def verdict(self, yacht: str) -> Verdict:
        """Judge the departures of a yacht."""
        study = self.study()
        best = study.best(yacht)
        missing = any(
            run is None and slot[1] == yacht for slot, run in zip(self.begun.slots, self._runs, strict=True)
        )
        if best is None:
            return Verdict(yacht, Outcome.WAITING if missing else Outcome.NONE)
        found = [run for run in study.of_yacht(yacht) if run.found]
        if len(found) == 1:
            return Verdict(yacht, Outcome.UNLIKE_PRESENT if missing else Outcome.ONLY, best)
        if not best.is_forecast:
            return Verdict(yacht, Outcome.BEYOND, best)
        longest = max(found, key=_hours)
        present = self._present_of(yacht)
        if _hours(longest) - min(map(_hours, found)) < SAME_H:
            return Verdict(yacht, Outcome.EQUAL, present or best, longest)
        if present is None:
            return Verdict(yacht, Outcome.UNLIKE_PRESENT, best)
        saved = _hours(present) - _hours(best)
        if present is best or 0.0 <= saved < SAME_H:
            return Verdict(yacht, Outcome.PRESENT, present, longest)
        return Verdict(yacht, Outcome.LESS_HELD if saved < 0.0 else Outcome.OTHER, best, present)

    def fastest(self) -> Verdict | None:
        """Judge the yacht with the shortest passage; ``None`` while there is none."""
        best = self.study().best()
        return None if best is None else self.verdict(best.yacht)

    def _present_of(self, yacht: str) -> Run | None:
        for slot, run in zip(self.begun.slots, self._runs, strict=True):
            if slot == (self.present, yacht) and run is not None and run.found:
                return run
        return None

    def rows(self) -> list[Row]:
        """All departures, in the order they were asked."""
        best = {yacht: self.verdict(yacht).best for yacht in self.yachts}
        return [
            Row(
                number,
                run.departure if run is not None and run.found else departure,
                yacht,
                run,
                run is not None and run is best[yacht],
            )
            for number, ((departure, yacht), run) in enumerate(zip(self.begun.slots, self._runs, strict=True))
        ]

    def curves(self, measure: Measure) -> list[Curve]:
        """Duration or arrival over departure, one curve a yacht."""
        rows = self.rows()
        return [
            Curve(yacht, tuple(_dot(row, measure) for row in rows if row.yacht == yacht))
            for yacht in self.yachts
        ]


def _hours(run: Run) -> float:
    return run.duration_h or 0.0


def _dot(row: Row, measure: Measure) -> Dot:
    time = row.departure.timestamp()
    since = time / SECONDS_PER_HOUR if measure == "arrival" else 0.0

    def put(hours: float | None) -> float | None:
        return None if hours is None else since + hours

    run = row.run
    if run is None:
        return Dot(row.number, time, None)
    if run.band is None:
        return Dot(row.number, time, put(run.duration_h))
    spread = run.band.duration_h
    return Dot(row.number, time, put(run.duration_h), put(spread.low), put(spread.middle), put(spread.high))
