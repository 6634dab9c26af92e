"""From a line that was found and sailed again to the `Passage` a sailor reads."""

from __future__ import annotations

import math
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import NoPassageError
from seacruise.geodesy import angle_between_deg, from_mercator, great_circle_m
from seacruise.model import (
    Checks,
    Passage,
    PassageRequest,
    Place,
    SearchReport,
    Tack,
    Track,
    Waypoint,
)
from seacruise.sea.coast import covers
from seacruise.units import METRES_PER_NM, MS_PER_KNOT, SECONDS_PER_HOUR
from seacruise.yacht.sails import sail_at

if TYPE_CHECKING:
    from seacruise.routing.find import Fastest, Ledger, Question
    from seacruise.routing.manoeuvres import Course
    from seacruise.routing.resail import Resailed
    from seacruise.yacht.polar import Polar

TELL_SNAP_NM: Final = 0.1
"""A port moved farther than this to reach water is worth a sentence [nm]."""


@dataclass(frozen=True, slots=True, eq=False)
class Answer:
    """What was found and sailed again, on its way to becoming a `Passage`."""

    request: PassageRequest
    ends: tuple[Place, Place]
    wanted: datetime
    asked: Question
    found: Fastest
    course: Course
    sailed: Resailed

    @property
    def departure(self) -> datetime:
        """When she leaves, after any waiting."""
        return datetime.fromtimestamp(self.asked.departure, UTC)

    @property
    def seconds(self) -> float:
        """From departure to arrival [s]."""
        return float(self.sailed.time[-1]) - self.asked.departure

    @property
    def beyond_s(self) -> float:
        """Seconds sailed on wind held beyond the forecast."""
        begin = self.asked.departure
        horizon = max(self.request.wind.forecast.valid_to.timestamp(), begin)
        return max(0.0, begin + self.seconds - horizon)

    def refuse_beyond(self) -> None:
        """Raise `NoPassageError` when the passage ends after the forecast, held wind being no forecast."""
        if self.beyond_s > 0.0:
            horizon = self.request.wind.forecast.valid_to
            arrival = self.departure + timedelta(seconds=self.seconds)
            raise NoPassageError(
                f"The passage would end at {arrival:%Y-%m-%d %H:%M} UTC, after the forecast, which ends at "
                f"{horizon:%Y-%m-%d %H:%M} UTC; leave earlier, choose a longer forecast, or let the last "
                "wind be held (--beyond hold) or fade (--beyond fade).",
                reason="outside-forecast",
            )

    def passage(self, ledger: Ledger) -> Passage:
        """Put the answer together."""
        from seacruise.routing.manoeuvres import true_length_nm

        sailed, (start, end) = self.sailed, self.ends
        legs = true_length_nm(self.course.x, self.course.y)
        tacks, gybes = sailed.tacks_and_gybes()
        # While a hand drags nobody reads it.
        bound_h = 0.0 if self.asked.near is not None else self._lower_bound_s() / SECONDS_PER_HOUR
        ledger.lap("check")
        return Passage(
            start=start,
            end=end,
            yacht=self.request.yacht.name,
            departure=self.departure,
            arrival=self.departure + timedelta(seconds=self.seconds),
            distance_nm=float(legs.sum()),
            direct_distance_nm=float(great_circle_m(start.lat, start.lon, end.lat, end.lon)) / METRES_PER_NM,
            waypoints=_waypoints(sailed, self.course.short_tacked, legs, self.request.yacht),
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
            manoeuvre_h=sailed.pause_s / SECONDS_PER_HOUR,
            beyond=self.request.options.beyond,
            notices=self._notices(legs),
            lattice_edges=self.found.lattice.edges_in_degrees,
            line=np.stack(from_mercator(self.found.near.x, self.found.near.y), axis=1),
        )

    def _lower_bound_s(self) -> float:
        from seacruise.routing.bound import lower_bound_s

        start, end = self.ends
        return lower_bound_s(
            self.request.wind,
            self.found.speeds,
            (start.lat, start.lon),
            (end.lat, end.lon),
            departure=self.asked.departure,
            drift=self.found.field.drift,
            found_s=self.seconds,
        )

    def _limits_without_forecast(self) -> list[str]:
        """Say which limits nobody could keep, the forecast being silent on what they limit."""
        wind, limits = self.request.wind, self.asked.how.handling.limits
        unknown = [
            what
            for what, grid, limit in (
                ("gusts", wind.gust, limits.max_gust),
                ("waves", wind.wave, limits.max_wave),
            )
            if limit is not None and grid is None
        ]
        if not unknown:
            return []
        missing = f"no {unknown[0]}" if len(unknown) == 1 else "neither gusts nor waves"
        return [f"The forecast has {missing}: what you do not allow of them was not looked at."]

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
        if not covers(self.sailed.lat, self.sailed.lon).all():
            said.append(
                "Outside 9 to 31° E and 53 to 66° N the coast is known to 1 km only: islets are missing "
                "there, keep well off every shore."
            )
        if self.beyond_s > 60.0:
            fading = self.request.options.beyond == "fade"
            said.append(
                f"The last {math.ceil(self.beyond_s / SECONDS_PER_HOUR)} h are sailed in the last known "
                f"wind, {'fading to the usual' if fading else 'held'} beyond the end of the forecast."
            )
        waited_h = (self.departure - self.wanted).total_seconds() / SECONDS_PER_HOUR
        if waited_h > 0.0:
            said.append(
                f"She waits {waited_h:.0f} h in {self.ends[0].name}, until what you do not allow has passed."
            )
        if self.asked.current is not None:
            said.append(f"The current is from {self.asked.current.forecast.source}.")
        if self.request.options.shore_clearance_nm is not None:
            said.append(
                f"She keeps {self.request.options.shore_clearance_nm:g} nm off every shore, but on the ways "
                "out of and into the ports."
            )
        most = self.request.options.most_turns
        if most is not None and self.sailed.turns > most:
            said.append(
                f"She tacks and gybes {self.sailed.turns} times: no passage with only {most} was found."
            )
        said.extend(self._limits_without_forecast())
        if self.request.zones:
            said.append(self.request.zones.told)
        said.extend(f"The passage touches the closed zone {name}." for name in self.sailed.zones_entered)
        narrow = float(legs[self.course.short_tacked].sum())
        if narrow > TELL_SNAP_NM:
            said.append(
                f"{narrow:.1f} nm are a beat or run in water too narrow to plan the boards; they are "
                "reckoned at the speed made good."
            )
        return tuple(said)


def _waypoints(
    sailed: Resailed, short_tacked: NDArray[np.bool_], legs: NDArray[np.float64], yacht: Polar
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
        sog = float(legs[k]) / hours if hours > 0 else 0.0
        steer, twd = float(sailed.heading_deg[a]), float(sailed.twd_deg[a])
        twa = (twd - steer + 180.0) % 360.0 - 180.0
        east, north = sailed.current[a].tolist()
        motor = bool(np.mean(sailed.motor[a:until]) > 0.5)
        points.append(
            Waypoint(
                lat,
                lon,
                when,
                course_deg=float(sailed.course_deg[a]),
                leg_nm=float(legs[k]),
                boat_speed_kn=_mean_kn(sailed, a, until) if sailed.in_current else sog,
                tws_kn=float(sailed.tws[a]) / MS_PER_KNOT,
                twd_deg=twd,
                twa_deg=abs(twa),
                motor=motor,
                tack=None if motor else _tack(twa, both=bool(short_tacked[k])),
                sail=None if motor else sail_at(yacht, float(sailed.tws[a]), abs(twa)),
                sog_kn=sog,
                steer_deg=steer,
                current_kn=math.hypot(east, north) / MS_PER_KNOT if sailed.in_current else None,
                current_to_deg=math.degrees(math.atan2(east, north)) % 360 if sailed.in_current else None,
            )
        )
    return tuple(points)


def _mean_kn(sailed: Resailed, a: int, until: int) -> float:
    """Mean speed through the water between two samples [kn]."""
    time, speed = sailed.time[a : until + 1], sailed.speed[a : until + 1]
    sailed_m = float((np.diff(time) * (speed[1:] + speed[:-1])).sum()) / 2
    return sailed_m / max(float(time[-1] - time[0]), 1.0) / MS_PER_KNOT


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
