"""The latest departure that still arrives by a given time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from typing import Final

import numpy as np

from seacruise.errors import InputError, NoPassageError
from seacruise.model import Passage, PassageRequest
from seacruise.passage import (
    NOBODY,
    departure_of,
    first_look,
    plan,
    question_of,
    the_finder,
    waters_of,
)
from seacruise.progress import Job
from seacruise.settings import Settings

WITHIN_S: Final = 300.0
"""A later departure than the one found by this much is too late [s]."""

_BY_TIME_LEFT: Final = 6
"""Passages tried at the departure that the time left suggests; then the rest of the time is halved."""


def plan_arrival(
    request: PassageRequest, arrive_by: datetime, *, settings: Settings, job: Job = NOBODY
) -> Passage:
    """Find the passage that leaves as late as it can and still arrives by a time.

    A reverse search on the lattice of the first passage gives the first guess. Passages are then planned in
    full, and sailed again, until one arrives in time and the one that leaves `WITHIN_S` later does not.

    Parameters
    ----------
    request
        Its departure is the earliest that will do; ``None`` means the next full hour of the forecast.
    arrive_by
        Timezone-aware.

    Raises
    ------
    NoPassageError
        Reason ``outside-forecast`` when not even the earliest departure arrives in time; else as `plan`.
    InputError, CancelledError
        As `plan`.
    """
    if arrive_by.tzinfo is None:
        raise InputError("The arrival needs a time zone; give it in UTC, for example 2016-11-22T18:00Z.")
    deadline = arrive_by.astimezone(UTC)
    earliest = departure_of(request.wind, request.departure)
    late = (
        f"She cannot be there by {deadline:%Y-%m-%d %H:%M} UTC: the earliest departure with a forecast is "
        f"{earliest:%Y-%m-%d %H:%M} UTC"
    )
    if deadline <= earliest:
        raise NoPassageError(f"{late}; choose a later arrival.", reason="outside-forecast")

    def sail(departure: datetime) -> Passage:
        return plan(replace(request, departure=departure), settings=settings, job=job)

    best = sail(earliest)
    if best.arrival > deadline:
        raise NoPassageError(
            f"{late}, and she arrives at {_minute_up(best.arrival):%Y-%m-%d %H:%M} UTC at the earliest; "
            "choose a later arrival.",
            reason="outside-forecast",
        )
    last = min(deadline, request.wind.forecast.valid_to)
    trial = _guess(request, best, deadline, settings) or best.departure + (deadline - best.arrival)
    return _latest(sail, best, deadline=deadline, last=last, trial=trial)


def _guess(request: PassageRequest, best: Passage, deadline: datetime, settings: Settings) -> datetime | None:
    """Latest departure on the lattice on which the first passage was found; ``None`` if there is none."""
    from seacruise.routing.backwards import latest_departures
    from seacruise.routing.field import COARSE_SLICE_S
    from seacruise.routing.find import Ledger

    sea, ends = waters_of(request, settings)
    asked = first_look(question_of(request, sea, ends, best.departure))
    found = the_finder().fastest(asked, job=NOBODY, ledger=Ledger())
    latest = latest_departures(
        found.lattice,
        asked.winds(COARSE_SLICE_S),
        found.speeds,
        deadline.timestamp(),
        earliest=asked.departure,
    ).departure[found.lattice.start]
    return datetime.fromtimestamp(float(latest), UTC) if np.isfinite(latest) else None


def _latest(
    sail: Callable[[datetime], Passage],
    best: Passage,
    *,
    deadline: datetime,
    last: datetime,
    trial: datetime,
) -> Passage:
    """Close in on the latest departure that is in time: by the time left or missing, then by halves.

    Parameters
    ----------
    best
        A passage that is in time.
    last
        The last departure that may be tried.
    trial
        The departure to try first.
    """
    within = timedelta(seconds=WITHIN_S)
    too_late = last + within if last < deadline else deadline
    tries = 0
    while too_late - best.departure > within:
        tries += 1
        halfway = best.departure + (too_late - best.departure) / 2
        trial = min(trial, last)
        if tries > _BY_TIME_LEFT or not best.departure < trial < too_late:
            trial = halfway
        trial = min(max(trial, best.departure + within), too_late - timedelta(minutes=1), last)
        trial = trial.replace(second=0, microsecond=0)
        if trial <= best.departure:
            break
        try:
            passage = sail(trial)
        except NoPassageError:
            # Leaving that late she is becalmed, or meets more wind than is allowed.
            too_late, trial = trial, halfway
            continue
        if passage.arrival <= deadline:
            best = passage
            trial += max(within, deadline - passage.arrival)
        else:
            too_late = trial
            trial -= max(within, passage.arrival - deadline)
    return best


def _minute_up(time: datetime) -> datetime:
    """Round up to a full minute: she is not there before."""
    return (time + timedelta(seconds=59)).replace(second=0, microsecond=0)
