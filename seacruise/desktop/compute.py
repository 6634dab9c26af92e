"""From the form to the answer: fetch the wind, plan the passage; runs on a worker thread, without Qt."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from datetime import datetime
from typing import TYPE_CHECKING, Protocol

from seacruise.desktop.via import join
from seacruise.errors import InputError
from seacruise.geodesy import great_circle_m
from seacruise.ports import Port
from seacruise.sea.zones import NO_ZONES, Zone, Zones
from seacruise.units import METRES_PER_NM

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
    """What the window asks.

    Attributes
    ----------
    forecast
        As on the command line, one name or several files.
    via
        A place to be led through.
    avoid
        Areas that the sailor marked on the chart.
    weights
        Weights of several forecasts in their mean; empty for equal ones.
    """

    start: Port
    end: Port
    departure: datetime | None
    yacht: Polar
    forecast: tuple[str, ...]
    options: Options
    via: Port | None = None
    avoid: tuple[Zone, ...] = field(default=(), compare=False)
    weights: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Answer:
    """A passage, the wind it was found in, and what was asked.

    Attributes
    ----------
    layers
        Zones of the sailor's layers at that time.
    rough
        Found by following an earlier one, while something is dragged; a precise one comes after it.
    parts
        The passages of which ``passage`` is joined where it leads by way of a place.
    """

    passage: Passage
    wind: Wind
    question: Question
    layers: Zones = NO_ZONES
    rough: bool = False
    parts: tuple[Passage, ...] = ()

    @property
    def zones(self) -> Zones:
        """Everything the passage keeps clear of."""
        return Zones((*self.layers.zones, *self.question.avoid))


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
        question.forecast,
        question.start,
        question.end,
        question.departure,
        settings=settings,
        job=job,
        weights=question.weights or None,
    )


def plan_passage(request: PassageRequest, *, settings: Settings, job: Job) -> Passage:
    """`seacruise.passage.plan`, imported when first needed: it brings the compiler with it."""
    # What the window shows a passage with: here nobody waits for it.
    import seacruise.narrative  # noqa: F401
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
    from seacruise.sea.zones import layer_files, load_zones

    refuse_same_port(question.start, question.end)
    job.check()
    wind = fetcher(question, settings, job)
    job.check()
    layers = load_zones(layer_files(settings.layers))
    return _answer(question, wind, layers, planner=planner, settings=settings, job=job)


def replan(
    question: Question,
    known: Answer,
    *,
    settings: Settings,
    job: Job,
    planner: Planner = plan_passage,
    rough: bool = False,
) -> Answer:
    """Answer another question in the wind of a known answer, and with its layers: nothing is fetched.

    Parameters
    ----------
    rough
        Leave the search in the corridor out and follow the line of the known answer instead, see
        `seacruise.passage.PassageRequest`.

    Raises
    ------
    SeaCruiseError
        Why there is no answer; `CancelledError` when the job was cancelled.
    """
    refuse_same_port(question.start, question.end)
    asked = replace(question, options=replace(question.options, corridor=False)) if rough else question
    near = (known.parts or (known.passage,)) if rough else ()
    answer = _answer(asked, known.wind, known.layers, near, planner=planner, settings=settings, job=job)
    return replace(answer, question=question, rough=rough)


def _answer(
    question: Question,
    wind: Wind,
    layers: Zones,
    near: tuple[Passage, ...] = (),
    *,
    planner: Planner,
    settings: Settings,
    job: Job,
) -> Answer:
    from seacruise.passage import PassageRequest

    request = PassageRequest(
        start=question.start,
        end=question.end,
        yacht=question.yacht,
        wind=wind,
        departure=question.departure,
        options=question.options,
        zones=Zones((*layers.zones, *question.avoid)),
    )

    def sail(asked: PassageRequest) -> Passage:
        found = planner(asked, settings=settings, job=job)
        job.check()
        return found

    parts = 1 if question.via is None else 2
    # A passage that led elsewhere is no good beginning.
    lines = near if len(near) == parts else (None,) * parts
    request = replace(request, near=lines[0])
    if question.via is None:
        return Answer(sail(request), wind, question, layers)
    refuse_same_port(question.start, question.via)
    refuse_same_port(question.via, question.end)
    first = sail(replace(request, end=question.via))
    # She goes on from where she arrived: the way in and the way out begin at the same water.
    place = replace(question.via, lat=first.end.lat, lon=first.end.lon)
    second = sail(replace(request, start=place, departure=first.arrival, near=lines[1]))
    away = float(great_circle_m(first.start.lat, first.start.lon, second.end.lat, second.end.lon))
    joined = join(first, second, direct_distance_nm=away / METRES_PER_NM)
    return Answer(joined, wind, question, layers, parts=(first, second))
