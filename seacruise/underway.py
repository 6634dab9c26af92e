"""Under way: a newer forecast, a new passage from where she is, and what has changed.

`replan` compares a passage that was saved with the best one from here and now (R2).
`seacruise.simulation` sails a whole passage like that.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from itertools import pairwise
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.along import ARRIVED_NM, UNDER_WAY, Position, apart_nm, distinct, format_utc, sail_along
from seacruise.between import sea_between
from seacruise.errors import InputError
from seacruise.geodesy import destination, rhumb_course_deg, rhumb_distance_m
from seacruise.model import Options, Passage, PassageRequest, Waypoint
from seacruise.passage import NOBODY, plan
from seacruise.ports import Port
from seacruise.progress import Job
from seacruise.sea.zones import NO_ZONES, Zones
from seacruise.settings import Settings
from seacruise.units import METRES_PER_NM, SECONDS_PER_HOUR

if TYPE_CHECKING:
    from seacruise.weather.wind import Wind
    from seacruise.yacht.polar import Polar

Array = NDArray[np.float64]

LEAST_ISLAND_KM2: Final = 5.0
"""Islands smaller than this are not worth a word when she passes on their other side [km²]."""


@dataclass(frozen=True, slots=True)
class SavedPassage:
    """As much of a passage as its JSON tells: enough to go on from it.

    Attributes
    ----------
    start, end
        Where it begins and ends, on the water.
    waypoints
        From start to end, with times.
    """

    start: Port
    end: Port
    yacht: str
    waypoints: tuple[Waypoint, ...]
    max_tws_kn: float
    source: str
    issued: datetime | None = None

    def __post_init__(self) -> None:
        times = [w.time for w in self.waypoints]
        if len(times) < 2 or any(a > b for a, b in pairwise(times)):
            raise InputError(
                "The saved passage has no waypoints with rising times; save it again with "
                "'seacruise plan --format json'."
            )

    @classmethod
    def of(cls, passage: Passage) -> SavedPassage:
        """Take what is needed of a passage that was just planned."""
        start, end = (Port(place.name, "", place.lat, place.lon) for place in (passage.start, passage.end))
        forecast = passage.forecast
        return cls(
            start,
            end,
            passage.yacht,
            passage.waypoints,
            passage.max_tws_kn,
            forecast.source,
            forecast.issued,
        )

    @property
    def departure(self) -> datetime:
        """When it begins."""
        return self.waypoints[0].time

    @property
    def arrival(self) -> datetime:
        """When it ends."""
        return self.waypoints[-1].time

    def is_under_way(self, time: datetime) -> bool:
        """Whether it has begun and not ended at a time."""
        return self.departure <= time < self.arrival

    def leg_at(self, time: datetime) -> int:
        """Index of the waypoint at which the leg of a time begins; the first before, the last after it."""
        return max((k for k, w in enumerate(self.waypoints[:-1]) if w.time <= time), default=0)

    def position_at(self, time: datetime) -> Position:
        """Position ``lat, lon`` [degrees] that the plan has for a time: steadily along the leg."""
        k = self.leg_at(time)
        here, there = self.waypoints[k], self.waypoints[k + 1]
        seconds = (there.time - here.time).total_seconds()
        share = min(1.0, max(0.0, (time - here.time).total_seconds() / seconds)) if seconds > 0 else 0.0
        leg = (here.lat, here.lon, there.lat, there.lon)
        sailed_m = float(rhumb_distance_m(*leg)) * share
        lat, lon = destination(here.lat, here.lon, rhumb_course_deg(*leg), sailed_m)
        return float(lat), float(lon)

    def rest_from(self, time: datetime) -> list[Position]:
        """Positions still ahead at a time: where the plan is then, and the waypoints after it."""
        ahead = self.waypoints[self.leg_at(time) + 1 :]
        return distinct([self.position_at(time), *((w.lat, w.lon) for w in ahead)])


@dataclass(frozen=True, slots=True)
class OtherSide:
    """An island that the new passage leaves on the other side than the old one.

    Attributes
    ----------
    lat, lon
        A place on it [degrees].
    side
        Where the new passage leaves it: ``"port"`` or ``"starboard"``.
    """

    lat: float
    lon: float
    area_km2: float
    side: str


@dataclass(frozen=True, slots=True)
class Replanned:
    """The passage from here and now, and what is different from the one that was saved.

    Attributes
    ----------
    off_plan_nm
        Distance from where the plan has her at this time [nm].
    arrival_change_h
        Arrival later (positive) or earlier (negative) than planned [h].
    kept_arrival
        When she is there if she keeps to the waypoints that are left, in the new wind; ``None`` when she
        does not get there like that.
    course_deg, course_change_deg
        First course to steer now, true, and against the one of the plan: clockwise positive, -180 to 180.
    distance_change_nm
        Against what was left of the plan [nm].
    max_tws_change_kn
        Strongest wind of the new passage against the strongest that was ever planned [kn].
    other_side
        Islands left on another side than planned, the largest first.
    """

    saved: SavedPassage
    time: datetime
    position: Position
    passage: Passage
    off_plan_nm: float
    arrival_change_h: float
    kept_arrival: datetime | None
    course_deg: float
    course_change_deg: float
    distance_change_nm: float
    max_tws_change_kn: float
    other_side: tuple[OtherSide, ...] = ()

    @property
    def saves_h(self) -> float | None:
        """Hours that the new passage is faster than keeping to the old waypoints."""
        if self.kept_arrival is None:
            return None
        return (self.kept_arrival - self.passage.arrival).total_seconds() / SECONDS_PER_HOUR


def replan(
    saved: SavedPassage,
    *,
    position: Position | None,
    time: datetime,
    wind: Wind,
    yacht: Polar,
    settings: Settings,
    options: Options | None = None,
    zones: Zones = NO_ZONES,
    job: Job = NOBODY,
) -> Replanned:
    """Plan from where she is now to the end of a saved passage, and compare.

    Parameters
    ----------
    position
        ``lat, lon`` [degrees]; ``None`` for where the plan has her at ``time``. Who is late may give one
        after the planned arrival too.
    time
        Timezone-aware.

    Raises
    ------
    InputError
        The passage is not under way at that time and no position is given, or she is there already.
    NoPassageError, CancelledError
        As `seacruise.passage.plan`.
    """
    if position is None and not saved.is_under_way(time):
        raise InputError(
            f"At {format_utc(time)} the passage is not under way: it is from {format_utc(saved.departure)} "
            f"to {format_utc(saved.arrival)}. Give a time in between (--time), or where she is (--at)."
        )
    planned = saved.position_at(time)
    here = position or planned
    end = saved.end
    if apart_nm(here, (end.lat, end.lon)) < ARRIVED_NM:
        raise InputError(f"She is at {end.name} already; there is nothing left to plan.")
    request = PassageRequest(Port(UNDER_WAY, "", *here), end, yacht, wind, time, options or Options(), zones)
    passage = plan(request, settings=settings, job=job)
    job.check()
    rest = saved.rest_from(time)
    ahead = distinct([here, *rest[1:]])
    sea = sea_between(request.start, end, settings)
    kept = sail_along(request, ahead, departure=time.timestamp(), sea=sea)
    course = _steer(passage.waypoints[0])
    old_course = _steer(saved.waypoints[saved.leg_at(time)])
    new = [here, *((w.lat, w.lon) for w in passage.waypoints)]
    return Replanned(
        saved=saved,
        time=time.astimezone(UTC),
        position=here,
        passage=passage,
        off_plan_nm=apart_nm(here, planned),
        arrival_change_h=(passage.arrival - saved.arrival).total_seconds() / SECONDS_PER_HOUR,
        kept_arrival=datetime.fromtimestamp(float(kept.time[-1]), UTC) if kept.arrived else None,
        course_deg=course,
        course_change_deg=(course - old_course + 180.0) % 360.0 - 180.0,
        distance_change_nm=passage.distance_nm - _length_nm(rest),
        max_tws_change_kn=passage.max_tws_kn - saved.max_tws_kn,
        other_side=other_sides(ahead, new),
    )


def other_sides(old: Sequence[Position], new: Sequence[Position]) -> tuple[OtherSide, ...]:
    """Find the islands between two ways with the same ends, which one leaves to port, the other to starboard.

    Old way there and new way back are a closed loop; whatever it winds around lies on the other side. Only
    the Baltic's coast is known as islands.
    """
    from seacruise.sea.coast import chart_land

    loop = np.array([*old, *reversed(new)])
    low, high = loop.min(axis=0), loop.max(axis=0)
    found = []
    for rings in chart_land(1):
        lon, lat = rings[0].T
        if lat.min() < low[0] or lat.max() > high[0] or lon.min() < low[1] or lon.max() > high[1]:
            continue
        area = _area_km2(lat, lon)
        if area < LEAST_ISLAND_KM2:
            continue
        winds = _winding(loop, float(lat[0]), float(lon[0]))
        if winds:
            # Anticlockwise the old way has it on its port hand, so the new one has it to starboard.
            side = "starboard" if winds > 0 else "port"
            found.append(OtherSide(float(lat.mean()), float(lon.mean()), area, side))
    return tuple(sorted(found, key=lambda island: -island.area_km2))


def _winding(loop: Array, lat: float, lon: float) -> int:
    """How often a closed loop ``(n, 2)`` of lat and lon goes round a place, anticlockwise positive."""
    angle = np.arctan2(loop[:, 0] - lat, (loop[:, 1] - lon) * np.cos(np.radians(lat)))
    turns = np.diff(np.append(angle, angle[0]))
    return round(float(((turns + np.pi) % (2 * np.pi) - np.pi).sum() / (2 * np.pi)))


def _area_km2(lat: Array, lon: Array) -> float:
    x, y = lon * np.cos(np.radians(lat.mean())) * 111.2, lat * 111.2
    return abs(float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]))) / 2


def _steer(waypoint: Waypoint) -> float:
    """Course to steer on the leg that begins at a waypoint: with a current not the one made good."""
    course = waypoint.course_deg if waypoint.steer_deg is None else waypoint.steer_deg
    if course is None:
        raise InputError("The saved passage has a leg without a course; save it again.")
    return course


def _length_nm(way: Sequence[Position]) -> float:
    lat, lon = np.array(way).T
    return float(rhumb_distance_m(lat[:-1], lon[:-1], lat[1:], lon[1:]).sum()) / METRES_PER_NM
