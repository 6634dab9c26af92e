"""Time against changes of course: what it costs to steer less."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from datetime import UTC
from typing import Final

from seacruise.errors import NoPassageError
from seacruise.model import Passage, PassageRequest
from seacruise.passage import DEARER_S, NOBODY, how_of, question_of, the_finder, waters_of
from seacruise.progress import Job
from seacruise.routing.field import FINE_SLICE_S, speed_table
from seacruise.routing.find import Ledger
from seacruise.routing.manoeuvres import merge_straight, straight_legs, true_length_nm
from seacruise.routing.refine import Waters, relaxed, timed
from seacruise.routing.resail import resail
from seacruise.routing.turning import paths_by_changes
from seacruise.settings import Settings
from seacruise.units import SECONDS_PER_HOUR

MOST_CHANGES: Final = 60
"""More changes of course than this are not weighed."""

WORTH_S: Final = 120.0
"""One more change of course must save at least this [s]."""

SLOWEST: Final = 1.25
"""A passage with fewer turns that takes longer than this, to the fastest, is nobody's choice."""


@dataclass(frozen=True, slots=True)
class Choice:
    """A passage among others: faster than all with fewer changes of course.

    Attributes
    ----------
    course_changes
        Tacks and gybes among them.
    """

    course_changes: int
    duration_h: float
    distance_nm: float
    tacks: int
    gybes: int


def trade_off(
    request: PassageRequest, passage: Passage, *, settings: Settings, job: Job = NOBODY
) -> tuple[Choice, ...]:
    """Find the least time for each number of changes of course (a Pareto front).

    On the lattice the least times are exact, with the polar as it is and every board an edge. Each passage is
    then relaxed with the waypoints it has, and sailed again as `plan` does it.

    Parameters
    ----------
    passage
        What `plan` found for the request; it is one of the choices.

    Returns
    -------
    tuple of Choice
        By rising number of changes and falling time.
    """
    sea, ends = waters_of(request, settings)
    asked = question_of(request, sea, ends, passage.departure.astimezone(UTC))
    asked = replace(asked, how=replace(how_of(request.options), refine=False))
    found = the_finder().fastest(asked, job=job, ledger=Ledger())
    job.check()
    job.report("search", None, "Weighing time against changes of course")
    handling = replace(asked.how.handling, tacking=False)
    field = asked.winds(FINE_SLICE_S)
    waters = Waters(asked.sea, field, speed_table(asked.polar, handling), asked.zones, handling.pauses)
    most = min(MOST_CHANGES, passage.course_changes)
    as_she_sails = replace(asked, how=replace(asked.how, handling=handling))
    choices = [
        Choice(passage.course_changes, passage.duration_h, passage.distance_nm, passage.tacks, passage.gybes)
    ]
    last = math.inf
    for _, arrival, path in paths_by_changes(
        found.lattice, field, waters.speeds, asked.departure, most=most, zones=asked.zones
    ):
        job.check()
        if arrival > last - WORTH_S:
            continue
        last = arrival
        line = relaxed(
            waters, timed(waters, found.lattice.x[path], found.lattice.y[path], asked.departure), split=False
        )
        course = merge_straight(straight_legs(line), asked.sea, asked.zones)
        sailed = resail(as_she_sails, course, fuel_rate_l_h=0.0)
        if sailed.arrived and sailed.within_limits and not sailed.zones_entered:
            legs = true_length_nm(course.x, course.y)
            hours = (float(sailed.time[-1]) - asked.departure) / SECONDS_PER_HOUR
            choices.append(Choice(legs.size - 1, hours, float(legs.sum()), *sailed.tacks_and_gybes()))
    return _front(choices)


@dataclass(frozen=True, slots=True, eq=False)
class Calmer:
    """A passage with fewer tacks and gybes.

    Attributes
    ----------
    most_turns
        `Options.most_turns` that it was planned with.
    """

    passage: Passage
    most_turns: int


def fewer_turns(passage: Passage, sail: Callable[[int], Passage], *, job: Job = NOBODY) -> Iterator[Calmer]:
    """Ask for half as many tacks and gybes, and again for half, as long as that is worth its time.

    Unlike the choices of `trade_off`, which count every change of course, each of these is a whole passage:
    planned, refined and sailed again with an option that the sailor can set.

    Parameters
    ----------
    passage
        That has too many.
    sail
        Plans it with so many tacks and gybes at most; what it finds may have more of them, where so few
        cannot be had.

    Yields
    ------
    Calmer
        As they are found, by falling number of turns.

    Raises
    ------
    CancelledError
        The job was cancelled.
    """
    least = passage.tacks + passage.gybes
    most = least // 2
    # `plan` tries as many prices of a turn as this, the dearest last: after that there are no fewer.
    for _ in DEARER_S:
        job.check()
        if least == 0:
            return
        job.report("search", None, f"Looking for a passage with at most {most} tacks and gybes")
        try:
            other = sail(most)
        except NoPassageError:
            return
        turns = other.tacks + other.gybes
        if turns >= least:
            return
        if other.duration_h <= SLOWEST * passage.duration_h:
            yield Calmer(other, most)
        least, most = turns, min(most, turns) // 2


def _front(choices: list[Choice]) -> tuple[Choice, ...]:
    """Keep the choices that no other one betters in both respects."""
    front: list[Choice] = []
    for choice in sorted(choices, key=lambda c: (c.course_changes, c.duration_h)):
        if not front or choice.duration_h < front[-1].duration_h - WORTH_S / SECONDS_PER_HOUR:
            front.append(choice)
    return tuple(front)
