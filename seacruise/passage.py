"""One passage, from start to end: what is asked, what is answered, and how the rooms are joined.

``PassageRequest -> Sea -> Lattice -> Wind -> search -> refine -> re-sail -> Passage``
"""

from __future__ import annotations

import math
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from seacruise.answer import Answer
from seacruise.between import sea_between
from seacruise.errors import InputError, NoPassageError
from seacruise.geodesy import format_position, great_circle_m, to_mercator
from seacruise.model import (
    SCHEMA,
    Checks,
    Options,
    Passage,
    PassageRequest,
    Place,
    Preset,
    SearchReport,
    Track,
    Waypoint,
    check_options,
)
from seacruise.ports import Port
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.units import METRES_PER_NM, SECONDS_PER_HOUR

if TYPE_CHECKING:
    from seacruise.routing.find import Fastest, Finder, How, Ledger, Question
    from seacruise.routing.manoeuvres import Course
    from seacruise.routing.refine import Line
    from seacruise.routing.resail import Resailed
    from seacruise.sea import Sea, Snap
    from seacruise.weather.wind import Wind

__all__ = [
    "SCHEMA",
    "Checks",
    "Options",
    "Passage",
    "PassageRequest",
    "Place",
    "Preset",
    "SearchReport",
    "Track",
    "Waypoint",
    "plan",
    "sea_between",
]

SAME_PLACE_NM = 0.1
"""Two ends nearer than this are the same port [nm]."""

LIMIT_SHARES = (1.0, 0.97, 0.94, 0.9)
"""Shares of a wind limit with which to search, until the passage keeps it when sailed again."""

MOST_DEPARTURES = 6
"""Departures that are searched in full where she may wait."""

DEARER_S = (300.0, 1200.0, 4800.0)
"""What a tack or gybe is made to cost more [s], until there are no more of them than wanted."""

BOARDS_COST = 0.003
"""Where boards cost more than this share of the time they are searched, not only laid out."""

ENGINE_LOST = 0.001
"""Where a passage with an engine takes longer than promised by more than this share, another one is tried."""

CHEAP_TURN_S = 15.0
"""What a tack or gybe costs then, so that there are no more of them than they are worth [s]."""

NOBODY = Job()
"""A job that nobody watches or cancels."""

_finder: Finder | None = None


def plan(request: PassageRequest, *, settings: Settings, job: Job = NOBODY) -> Passage:
    """Find the fastest passage and sail it again before showing it.

    Parameters
    ----------
    request
        Ports, yacht, wind, departure and how to search.
    settings
        Where the rasters of the sea are kept.
    job
        Receives the progress; its event cancels.

    Raises
    ------
    InputError
        Start and end are the same, or an option makes no sense.
    NoPassageError
        There is none; ``reason`` says why.
    CancelledError
        The job was cancelled.
    """
    from seacruise.routing.find import Ledger
    from seacruise.weather.beyond import extend

    ledger = Ledger()
    check_options(request.options)
    request = replace(request, wind=extend(request.wind, request.options.beyond))
    departure = departure_of(request.wind, request.departure)
    job.report("sea", None, "Reading the sea")
    sea, ends = waters_of(request, settings)
    job.check()
    ledger.lap("sea")
    check_cover(request.wind, request.start, request.end)
    asked = question_of(request, sea, ends, departure)
    _check_zones(asked, request)
    asked, found, course, sailed = _leaving_in_time(asked, request.options, job, ledger)
    answer = Answer(request, ends, departure, asked, found, course, sailed)
    if request.options.beyond == "refuse":
        answer.refuse_beyond()
    job.check()
    return answer.passage(ledger)


def question_of(
    request: PassageRequest, sea: Sea, ends: tuple[Place, Place], departure: datetime
) -> Question:
    """Put a request into the router's words."""
    from seacruise.routing.find import Question

    start, end = ((place.lat, place.lon) for place in ends)
    if request.options.shore_clearance_nm is not None:
        sea = sea.keeping_off(request.options.shore_clearance_nm * METRES_PER_NM, (start, end))
    return Question(
        sea,
        request.wind,
        request.yacht,
        how_of(request.options),
        start,
        end,
        departure.timestamp(),
        request.zones,
        request.stream,
        request.options.shore_clearance_nm,
        _near(request),
    )


def _near(request: PassageRequest) -> NDArray[np.float64] | None:
    """Give the line to follow, points ``(m, 2)`` of the plane [m], where one is to be followed."""
    options, near = request.options, request.near
    if options.corridor or not options.refine or near is None or near.line is None:
        return None
    if options.tack_penalty_min or options.gybe_penalty_min or options.turn_penalty:
        # Boards that were searched with what they cost are no line of the hull.
        return None
    return np.stack(to_mercator(near.line[:, 0], near.line[:, 1]), axis=1)


def _leaving_in_time(
    asked: Question, options: Options, job: Job, ledger: Ledger
) -> tuple[Question, Fastest, Course, Resailed]:
    """Find the passage; where waiting is allowed, of the departure that brings her there first."""
    refused: NoPassageError | None = None
    for later in _departures(asked, options.may_wait_h, job, ledger)[:MOST_DEPARTURES]:
        try:
            return later, *_with_few_turns(later, options, job, ledger)
        except NoPassageError as error:
            refused = refused or error
    assert refused is not None
    raise refused


def _departures(asked: Question, may_wait_h: float, job: Job, ledger: Ledger) -> list[Question]:
    """Departures worth a full search, the one that arrives first on a first look before the others.

    Waiting never helps against the wind alone: who leaves later arrives later. It helps where a limit or a
    zone that is open later forbids the way.
    """
    from seacruise.routing.field import NO_LIMITS

    limited = asked.how.handling.max_wind is not None or asked.how.handling.limits != NO_LIMITS
    if may_wait_h < 1.0 or not (limited or asked.zones):
        return [asked]
    looks: list[tuple[float, Question]] = []
    for hours in range(int(may_wait_h) + 1):
        job.check()
        later = replace(asked, departure=asked.departure + hours * SECONDS_PER_HOUR)
        try:
            line = the_finder().fastest(first_look(later), job=job, ledger=ledger).line
        except NoPassageError:
            continue
        looks.append((float(line.times[-1]), later))
    looks.sort(key=lambda look: look[0])
    return [later for _, later in looks] or [asked]


def _with_few_turns(
    asked: Question, options: Options, job: Job, ledger: Ledger
) -> tuple[Fastest, Course, Resailed]:
    """Find a passage; where it has more tacks and gybes than wanted, search as if they cost more.

    Where laying out the boards of a long beat lost much against the hull of the polar, they are searched as
    well, and the faster passage is taken.
    """

    def as_if_dearer(extra: float) -> tuple[Fastest, Course, Resailed]:
        tack, gybe, turn = asked.how.handling.pauses
        handling = replace(asked.how.handling, pauses=(tack + extra, gybe + extra, turn))
        dearer = replace(asked, how=replace(asked.how, handling=handling))
        return _find_within_limits(dearer, options, job, ledger, sailed_as=asked)

    best = _find_within_limits(asked, options, job, ledger)
    if options.preset == "classic":
        return best
    if asked.how.handling.motor_below is not None and _lost(asked, best) > ENGINE_LOST:
        best = _or_as_if_without_engine(best, asked, options, job, ledger)
    if not options.tacking:
        return best
    found, _, sailed = best
    lost = _lost(asked, best)
    free = options.refine and options.corridor and options.board_h is None and not found.boards_found
    if free and sailed.turns and lost > BOARDS_COST:
        best = min(best, as_if_dearer(CHEAP_TURN_S), key=lambda one: float(one[2].time[-1]))
    most = math.inf if options.most_turns is None else options.most_turns
    for extra in DEARER_S:
        if best[2].turns <= most:
            break
        best = min(best, as_if_dearer(extra), key=lambda one: one[2].turns)
    return best


def _lost(asked: Question, best: tuple[Fastest, Course, Resailed]) -> float:
    """Share by which a passage takes longer than the line it was made of promised."""
    found, _, sailed = best
    return (float(sailed.time[-1]) - asked.departure) / found.line.seconds - 1.0


def _or_as_if_without_engine(
    best: tuple[Fastest, Course, Resailed], asked: Question, options: Options, job: Job, ledger: Ledger
) -> tuple[Fastest, Course, Resailed]:
    """Search as if there were no engine as well, and give what is faster with it.

    Where the engine starts her speed jumps. A search may choose a course that is just slow enough for the
    engine, and a hair beside it she sails slower than she would have on any other.
    """
    handling = replace(asked.how.handling, motor_below=None, motor_speed=0.0)
    without = replace(asked, how=replace(asked.how, handling=handling))
    try:
        other = _find_within_limits(without, options, job, ledger, sailed_as=asked)
    except NoPassageError:
        return best
    return min(best, other, key=lambda one: float(one[2].time[-1]))


def first_look(asked: Question) -> Question:
    """Ask for the first search only, without refinement and without what turning costs."""
    handling = replace(asked.how.handling, pauses=(0.0, 0.0, 0.0))
    return replace(asked, how=replace(asked.how, refine=False, handling=handling))


def _find_within_limits(
    asked: Question, options: Options, job: Job, ledger: Ledger, *, sailed_as: Question | None = None
) -> tuple[Fastest, Course, Resailed]:
    """Find a passage and sail it again; where that breaks a limit, search with less."""
    handling = asked.how.handling
    for share in LIMIT_SHARES:
        sought = replace(asked, how=replace(asked.how, handling=handling.within(share)))
        found = the_finder().fastest(sought, job=job, ledger=ledger)
        job.check()
        job.report("check", None, "Sailing the passage again")
        course, sailed = sail_again(
            sailed_as or asked,
            found.line,
            boards_found=found.boards_found,
            fuel_rate_l_h=options.fuel_rate_l_h,
        )
        if sailed.within_limits:
            return found, course, sailed
    raise NoPassageError(
        "Wind, gusts or waves come too close to what you allow on every way that was found; leave "
        "at another time or raise the limit.",
        reason="wind-limit",
    )


def _check_zones(asked: Question, request: PassageRequest) -> None:
    """Refuse an end that lies in a zone: leaving or entering it is for the sailor to settle."""
    from seacruise.sea.zones import blocking

    for (lat, lon), port in zip((asked.start, asked.end), (request.start, request.end), strict=True):
        names = blocking(asked.zones, lat, lon, asked.departure) if asked.zones else ()
        if names:
            raise NoPassageError(
                f"{port.name} lies in a zone that is closed to you ({names[0]}); take the zone out of the "
                "layers or choose another port.",
                reason="closed-zone",
                place=(lat, lon),
            )


def the_finder() -> Finder:
    """Give the finder that all passages of this process share, for the lattices it keeps."""
    from seacruise.routing.find import Finder

    global _finder  # noqa: PLW0603 - its lattices are big and the same for every window and thread
    if _finder is None:
        _finder = Finder()
    return _finder


def departure_of(wind: Wind, departure: datetime | None) -> datetime:
    """Departure in UTC, within the forecast; by default its next full hour."""
    forecast = wind.forecast
    if departure is None:
        now = datetime.now(UTC)
        earliest = max(forecast.valid_from, now) if now <= forecast.valid_to else forecast.valid_from
        departure = earliest.replace(minute=0, second=0, microsecond=0)
        if departure < earliest:
            departure += timedelta(hours=1)
    elif departure.tzinfo is None:
        raise InputError("The departure needs a time zone; give it in UTC, for example 2016-11-20T06:00Z.")
    departure = departure.astimezone(UTC)
    if not forecast.valid_from <= departure <= forecast.valid_to:
        raise NoPassageError(
            f"The departure {departure:%Y-%m-%d %H:%M} UTC is outside the forecast ({forecast.source}), "
            f"which covers {forecast.valid_from:%Y-%m-%d %H:%M} to {forecast.valid_to:%Y-%m-%d %H:%M} UTC; "
            "choose a time within it.",
            reason="outside-forecast",
        )
    return departure


def waters_of(request: PassageRequest, settings: Settings) -> tuple[Sea, tuple[Place, Place]]:
    """Read the sea and move both ports to water."""
    start, end = request.start, request.end
    same = f"Start and end are the same place ({start.name}); choose two different ports."
    if float(great_circle_m(start.lat, start.lon, end.lat, end.lon)) < SAME_PLACE_NM * METRES_PER_NM:
        raise InputError(same)
    sea = sea_between(start, end, settings)
    places = tuple(place_of(port, sea.snap(port.lat, port.lon, name=port.name)) for port in (start, end))
    if float(great_circle_m(places[0].lat, places[0].lon, places[1].lat, places[1].lon)) < 1.0:
        raise InputError(same)
    return sea, (places[0], places[1])


def place_of(port: Port, snap: Snap) -> Place:
    """Put a port and its water together."""
    return Place(port.name, snap.lat, snap.lon, port.lat, port.lon, snap.distance_nm)


def check_cover(wind: Wind, *ports: Port) -> None:
    """Refuse ports that the wind does not cover."""
    for port in ports:
        if not bool(wind.covers(port.lat, port.lon)):
            raise NoPassageError(
                f"The wind ({wind.forecast.source}) does not reach {port.name} "
                f"({format_position(port.lat, port.lon)}); choose a forecast that covers both ports.",
                reason="outside-forecast",
                place=(port.lat, port.lon),
            )


def how_of(options: Options) -> How:
    """Put options into the router's words."""
    from seacruise.routing.field import handling_in_knots
    from seacruise.routing.find import How, Safety
    from seacruise.routing.manoeuvres import USUAL, Boards

    is_classic = options.preset == "classic"
    return How(
        preset=options.preset,
        directions=options.directions,
        spacing_nm=options.spacing_nm,
        area="rectangle" if is_classic else options.area,
        refine=options.refine and not is_classic,
        corridor=options.corridor,
        handling=handling_in_knots(
            tacking=options.tacking and not is_classic,
            percent=options.percent_of_polar,
            motor_below_kn=options.motor_below_kn,
            motor_speed_kn=options.motor_speed_kn,
            max_wind_kn=options.max_wind_kn,
            max_gust_kn=options.max_gust_kn,
            max_wave_m=options.max_wave_m,
            tack_min=options.tack_penalty_min,
            gybe_min=options.gybe_penalty_min,
            turn_min_per_10_deg=options.turn_penalty,
            percent_at_night=options.percent_at_night,
            sea_state_percent=options.sea_state_percent,
        ),
        mesh=options.lattice,
        safety=Safety((options.safety_radius_nm or 0.0) * METRES_PER_NM, options.safety_levels),
        boards=USUAL if options.board_h is None else Boards(usual_s=options.board_h * SECONDS_PER_HOUR),
    )


def sail_again(
    asked: Question, line: Line, *, boards_found: bool = False, fuel_rate_l_h: float = 0.0
) -> tuple[Course, Resailed]:
    """Put in the tacks and sail the passage by independent code.

    Without tacking a leg found possible hour by hour may still lead through the dead angle between two
    looks; rather than show a time nobody sailed, such a passage is tacked where it must be.

    Parameters
    ----------
    boards_found
        Whether tacks and gybes are in the line already.
    """
    from seacruise.routing.manoeuvres import merge_straight, relax_boards, sail_boards, straight_legs
    from seacruise.routing.resail import is_land_free, resail

    handling = asked.how.handling
    if boards_found or not handling.tacking:
        course = merge_straight(straight_legs(line), asked.sea, asked.zones)
    else:
        course = sail_boards(asked, line)
    # Holding a course against the coast takes longer than sailing it: only the one that is shown.
    sailed = resail(asked, course, fuel_rate_l_h=fuel_rate_l_h, look=False)
    if handling.tacking and asked.how.refine and not boards_found and sailed.turns:
        waters = the_finder().as_she_sails(asked)
        moved = relax_boards(waters, course, asked.departure, quickly=asked.near is not None)
        again = resail(asked, moved, fuel_rate_l_h=fuel_rate_l_h, look=False)
        if again.arrived and again.time[-1] < sailed.time[-1] and is_land_free(moved, asked.sea):
            course, sailed = moved, replace(again, land_free=True)
    if not sailed.arrived:
        tacked = replace(asked, how=replace(asked.how, handling=replace(handling, tacking=True)))
        course = replace(course, short_tacked=np.ones_like(course.short_tacked))
        sailed = resail(tacked, course, fuel_rate_l_h=fuel_rate_l_h, look=False)
        course = replace(course, short_tacked=sailed.mixed(asked.polar))
    if not sailed.arrived:
        raise NoPassageError(
            "The passage that was found cannot be sailed to its end: the yacht is becalmed under way. Leave "
            "at another time or allow the engine (--motor-below).",
            reason="becalmed",
            place=(float(sailed.lat[-1]), float(sailed.lon[-1])),
        )
    return course, sailed if sailed.land_free else replace(sailed, land_free=is_land_free(course, asked.sea))
