"""From the form to the answer: fetch the wind, plan the passage; runs on a worker thread, without Qt."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime
from typing import TYPE_CHECKING, Protocol

from seacruise.errors import InputError
from seacruise.ports import Port

if TYPE_CHECKING:
    from seacruise.passage import Options, Passage, PassageRequest
    from seacruise.progress import Job
    from seacruise.settings import Settings
    from seacruise.weather.wind import Wind
    from seacruise.yacht.polar import Polar


class Planner(Protocol):
    """`seacruise.passage.plan`, or what a test puts in its place."""

    def __call__(self, request: PassageRequest, *, settings: Settings, job: Job) -> Passage:
        """Find the passage, or raise a `SeaCruiseError`."""
        ...


@dataclass(frozen=True, slots=True)
class Question:
    """What the form asks; ``forecast`` as on the command line, one name or several files."""

    start: Port
    end: Port
    departure: datetime | None
    yacht: Polar
    forecast: tuple[str, ...]
    options: Options


@dataclass(frozen=True, slots=True)
class Answer:
    """A passage, the wind it was found in, and what was asked."""

    passage: Passage
    wind: Wind
    question: Question


Fetcher = Callable[["Question", "Settings", "Job"], "Wind"]


def refuse_same_port(start: Port, end: Port) -> None:
    """Raise `InputError` when a passage would end where it begins."""
    if (start.lat, start.lon) == (end.lat, end.lon):
        raise InputError(
            f"{start.name} is both the start and the end; choose two different ports.", reason="same-port"
        )


def fetch_wind(question: Question, settings: Settings, job: Job) -> Wind:
    """Wind for a question from wherever its forecast says."""
    from seacruise.between import fetch_wind_between

    return fetch_wind_between(
        question.forecast, question.start, question.end, question.departure, settings=settings, job=job
    )


def plan_passage(request: PassageRequest, *, settings: Settings, job: Job) -> Passage:
    """`seacruise.passage.plan`, imported when first needed: it brings the compiler with it."""
    from seacruise.passage import plan

    return plan(request, settings=settings, job=job)


def compute(
    question: Question,
    *,
    settings: Settings,
    job: Job,
    planner: Planner = plan_passage,
    fetcher: Fetcher = fetch_wind,
) -> Answer:
    """Answer a question.

    Raises
    ------
    SeaCruiseError
        Why there is no answer; `CancelledError` when the job was cancelled.
    """
    from seacruise.passage import PassageRequest
    from seacruise.sea.zones import layer_files, load_zones

    refuse_same_port(question.start, question.end)
    job.check()
    wind = fetcher(question, settings, job)
    job.check()
    request = PassageRequest(
        start=question.start,
        end=question.end,
        yacht=question.yacht,
        wind=wind,
        departure=question.departure,
        options=question.options,
        zones=load_zones(layer_files(settings.layers)),
    )
    passage = planner(request, settings=settings, job=job)
    job.check()
    return Answer(passage, wind, question)
