"""One passage, from start to end: what is asked, what is answered, and how the rooms are joined.

``PassageRequest -> Sea -> Lattice -> Wind -> search -> refine -> re-sail -> Passage``
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from seacruise.between import sea_between
from seacruise.errors import InputError, NoPassageError
from seacruise.geodesy import angle_between_deg, format_position, great_circle_m
from seacruise.model import (
    SCHEMA,
    Checks,
    Options,
    Passage,
    PassageRequest,
    Place,
    Preset,
    SearchReport,
    Tack,
    Track,
    Waypoint,
    check_options,
)
from seacruise.ports import Port
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.units import METRES_PER_NM, MS_PER_KNOT, SECONDS_PER_HOUR

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

TELL_SNAP_NM = 0.1
"""A port moved farther than this to reach water is worth a sentence [nm]."""

LIMIT_SHARES = (1.0, 0.97, 0.94, 0.9)
"""Shares of a wind limit with which to search, until the passage keeps it when sailed again."""

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
    from seacruise.routing.find import Ledger, Question

    ledger = Ledger()
    check_options(request.options)
    departure = departure_of(request.wind, request.departure)
    job.report("sea", None, "Reading the sea")
    sea, ends = waters_of(request, settings)
    job.check()
    ledger.lap("sea")
    check_cover(request.wind, request.start, request.end)
    start, end = ((place.lat, place.lon) for place in ends)
    asked = Question(
        sea,
        request.wind,
        request.yacht,
        how_of(request.options),
        start,
        end,
        departure.timestamp(),
        request.zones,
    )
    _check_zones(asked, request)
    found, course, sailed = _find_within_limits(asked, request.options.fuel_rate_l_h, job, ledger)
    job.check()
    return _Answer(request, ends, departure, found, course, sailed).passage(ledger)


def _find_within_limits(
    asked: Question, fuel_rate_l_h: float, job: Job, ledger: Ledger
) -> tuple[Fastest, Course, Resailed]:
    """Find a passage and sail it again; where that meets more wind than allowed, search with less."""
    limit = asked.how.handling.max_wind
    for share in LIMIT_SHARES:
        sought = asked
        if limit is not None:
            handling = replace(asked.how.handling, max_wind=limit * share)
            sought = replace(asked, how=replace(asked.how, handling=handling))
        found = the_finder().fastest(sought, job=job, ledger=ledger)
        job.check()
        job.report("check", None, "Sailing the passage again")
        course, sailed = _sail_again(asked, found.line, fuel_rate_l_h)
        if sailed.within_limits:
            return found, course, sailed
    raise NoPassageError(
        f"The wind comes too close to the {(limit or 0.0) / MS_PER_KNOT:.0f} kn you allow on every way that "
        "was found; leave at another time or raise the limit.",
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
    from seacruise.routing.find import How

    is_classic = options.preset == "classic"
    return How(
        preset=options.preset,
        directions=options.directions,
        spacing_nm=options.spacing_nm,
        area="rectangle" if is_classic else options.area,
        refine=options.refine and not is_classic,
        handling=handling_in_knots(
            tacking=options.tacking and not is_classic,
            percent=options.percent_of_polar,
            motor_below_kn=options.motor_below_kn,
            motor_speed_kn=options.motor_speed_kn,
            max_wind_kn=options.max_wind_kn,
        ),
    )


def _sail_again(asked: Question, line: Line, fuel_rate_l_h: float) -> tuple[Course, Resailed]:
    """Put in the tacks and sail the passage by independent code.

    Without tacking a leg found possible hour by hour may still lead through the dead angle between two
    looks; rather than show a time nobody sailed, such a passage is tacked where it must be.
    """
    from seacruise.routing.manoeuvres import merge_straight, sail_boards, straight_legs
    from seacruise.routing.resail import resail

    handling = asked.how.handling
    course = (
        sail_boards(asked, line)
        if handling.tacking
        else merge_straight(straight_legs(line), asked.sea, asked.zones)
    )
    sailed = resail(asked, course, fuel_rate_l_h=fuel_rate_l_h)
    if not sailed.arrived:
        tacked = replace(asked, how=replace(asked.how, handling=replace(handling, tacking=True)))
        course = replace(course, short_tacked=np.ones_like(course.short_tacked))
        sailed = resail(tacked, course, fuel_rate_l_h=fuel_rate_l_h)
        course = replace(course, short_tacked=sailed.mixed(asked.polar))
    if not sailed.arrived:
        raise NoPassageError(
            "The passage that was found cannot be sailed to its end: the yacht is becalmed under way. Leave "
            "at another time or allow the engine (--motor-below).",
            reason="becalmed",
            place=(float(sailed.lat[-1]), float(sailed.lon[-1])),
        )
    return course, sailed


@dataclass(frozen=True, slots=True, eq=False)
class _Answer:
    """What was found and sailed again, on its way to becoming a `Passage`."""

    request: PassageRequest
    ends: tuple[Place, Place]
    departure: datetime
    found: Fastest
    course: Course
    sailed: Resailed

    @property
    def seconds(self) -> float:
        return float(self.sailed.time[-1]) - self.departure.timestamp()

    @property
    def beyond_s(self) -> float:
        """Seconds sailed on wind held beyond the forecast."""
        begin = self.departure.timestamp()
        horizon = max(self.request.wind.forecast.valid_to.timestamp(), begin)
        return max(0.0, begin + self.seconds - horizon)

    def passage(self, ledger: Ledger) -> Passage:
        """Put the answer together."""
        from seacruise.routing.manoeuvres import count_turns, true_length_nm

        sailed, (start, end) = self.sailed, self.ends
        legs = true_length_nm(self.course.x, self.course.y)
        at = sailed.at[:-1]
        tacks, gybes = count_turns(sailed.course_deg[at], sailed.twd_deg[at], ~sailed.motor[at])
        bound_h = self._lower_bound_s() / SECONDS_PER_HOUR
        ledger.lap("check")
        return Passage(
            start=start,
            end=end,
            yacht=self.request.yacht.name,
            departure=self.departure,
            arrival=self.departure + timedelta(seconds=self.seconds),
            distance_nm=float(legs.sum()),
            direct_distance_nm=float(great_circle_m(start.lat, start.lon, end.lat, end.lon)) / METRES_PER_NM,
            waypoints=_waypoints(sailed, self.course.short_tacked, legs),
            tacks=tacks,
            gybes=gybes,
            course_changes=legs.size - 1,
            max_tws_kn=float(sailed.tws.max()) / MS_PER_KNOT,
            motor_h=sailed.motor_s / SECONDS_PER_HOUR,
            fuel_l=sailed.fuel_l,
            beyond_forecast_h=self.beyond_s / SECONDS_PER_HOUR,
            forecast=self.request.wind.forecast,
            lower_bound_h=bound_h,
            checks=Checks(
                self.seconds / SECONDS_PER_HOUR,
                sailed.land_free,
                not sailed.zones_entered,
                sailed.within_limits,
            ),
            search=SearchReport(
                ledger.directions,
                ledger.spacing_nm,
                ledger.vertices,
                ledger.edges,
                ledger.settled,
                dict(ledger.seconds),
            ),
            track=_track(sailed),
            notices=self._notices(legs),
            lattice_edges=self.found.lattice.edges_in_degrees(),
        )

    def _lower_bound_s(self) -> float:
        from seacruise.routing.bound import lower_bound_s

        start, end = self.ends
        return lower_bound_s(
            self.request.wind,
            self.found.speeds,
            (start.lat, start.lon),
            (end.lat, end.lon),
            departure=self.departure.timestamp(),
            found_s=self.seconds,
        )

    def _notices(self, legs: NDArray[np.float64]) -> tuple[str, ...]:
        """Sentences that a sailor must read with the passage."""
        notice = self.request.wind.forecast.notice
        said = [notice] if notice else []
        for place, verb in zip(self.ends, ("begins", "ends"), strict=True):
            if place.snapped_nm > TELL_SNAP_NM:
                said.append(
                    f"The passage {verb} {place.snapped_nm:.1f} nm from {place.name}, at the nearest water "
                    "of the chart that is connected with the open sea."
                )
        if self.beyond_s > 60.0:
            said.append(
                f"The last {math.ceil(self.beyond_s / SECONDS_PER_HOUR)} h are sailed in the last known "
                "wind, held beyond the end of the forecast."
            )
        if self.request.zones:
            said.append(f"{len(self.request.zones.zones)} zones of your layers are kept clear of.")
        said.extend(f"The passage touches the closed zone {name}." for name in self.sailed.zones_entered)
        narrow = float(legs[self.course.short_tacked].sum())
        if narrow > TELL_SNAP_NM:
            said.append(
                f"{narrow:.1f} nm are a beat or run in water too narrow to plan the boards; they are "
                "reckoned at the speed made good."
            )
        return tuple(said)


def _waypoints(
    sailed: Resailed, short_tacked: NDArray[np.bool_], legs: NDArray[np.float64]
) -> tuple[Waypoint, ...]:
    points = []
    for k, a in enumerate(sailed.at.tolist()):
        lat, lon = float(sailed.lat[a]), float(sailed.lon[a])
        when = datetime.fromtimestamp(float(sailed.time[a]), UTC)
        if k == legs.size:
            points.append(Waypoint(lat, lon, when))
            break
        until = int(sailed.at[k + 1])
        hours = float(sailed.time[until] - sailed.time[a]) / SECONDS_PER_HOUR
        course, twd = float(sailed.course_deg[a]), float(sailed.twd_deg[a])
        twa = (twd - course + 180.0) % 360.0 - 180.0
        motor = bool(np.mean(sailed.motor[a:until]) > 0.5)
        points.append(
            Waypoint(
                lat,
                lon,
                when,
                course_deg=course,
                leg_nm=float(legs[k]),
                boat_speed_kn=float(legs[k]) / hours if hours > 0 else 0.0,
                tws_kn=float(sailed.tws[a]) / MS_PER_KNOT,
                twd_deg=twd,
                twa_deg=abs(twa),
                motor=motor,
                tack=None if motor else _tack(twa, both=bool(short_tacked[k])),
            )
        )
    return tuple(points)


def _tack(twa: float, *, both: bool) -> Tack:
    if both:
        return "both"
    return "starboard" if twa >= 0 else "port"


def _track(sailed: Resailed) -> Track:
    return Track(
        sailed.time,
        sailed.lat,
        sailed.lon,
        sailed.course_deg,
        sailed.speed / MS_PER_KNOT,
        sailed.tws / MS_PER_KNOT,
        sailed.twd_deg,
        angle_between_deg(sailed.twd_deg, sailed.course_deg),
        sailed.motor,
        sailed.leg,
    )
