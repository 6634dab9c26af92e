"""A passage sailed through forecasts that do not come true: what re-planning under way is worth."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.along import (
    ARRIVED_NM,
    UNDER_WAY,
    Position,
    apart_nm,
    distinct,
    format_utc,
    sail_along,
    waypoints_of,
)
from seacruise.between import sea_between
from seacruise.errors import InputError, NoPassageError
from seacruise.model import Passage, PassageRequest
from seacruise.passage import NOBODY, plan
from seacruise.ports import Port
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.units import MS_PER_KNOT, SECONDS_PER_HOUR
from seacruise.weather.beyond import extend

if TYPE_CHECKING:
    from seacruise.routing.resail import Resailed
    from seacruise.weather.wind import Wind

Array = NDArray[np.float64]

LEAST_BETWEEN_S: Final = 3600.0
"""With the same forecast nobody plans anew within this time [s]: it would say the same."""


@dataclass(frozen=True, slots=True)
class Tolerance:
    """How far the wind met at a waypoint may be from the one planned before she plans anew.

    In less than ``light_kn`` of wind, planned and met, directions say nothing.
    """

    tws_kn: float = 4.0
    twd_deg: float = 20.0
    light_kn: float = 3.0

    def exceeded(self, planned: tuple[float, float], met: tuple[float, float]) -> bool:
        """Compare winds, each as speed [kn] and direction from [degrees true]."""
        if abs(met[0] - planned[0]) > self.tws_kn:
            return True
        turned = abs((met[1] - planned[1] + 180.0) % 360.0 - 180.0)
        return turned > self.twd_deg and max(met[0], planned[0]) >= self.light_kn


@dataclass(frozen=True, slots=True)
class LogEntry:
    """A waypoint at which she planned anew, or would have.

    Attributes
    ----------
    planned, met
        True wind as speed [kn] and direction from [degrees true]: the plan's and the one she meets.
    issued
        Issue of the forecast with which she planned.
    expected
        Arrival she now expects; ``None`` when no passage was found and she keeps to the old one.
    reason
        Why no passage was found, or empty.
    """

    time: datetime
    position: Position
    planned: tuple[float, float]
    met: tuple[float, float]
    issued: datetime | None
    expected: datetime | None
    reason: str = ""


@dataclass(frozen=True, slots=True)
class Voyage:
    """A passage sailed in a wind other than forecast.

    Attributes
    ----------
    expected_h
        Duration promised at departure [h].
    sailed_h, kept_h
        Duration with re-planning, and when the first plan is kept to the end [h]; ``None`` when she does
        not arrive.
    hindsight_h
        Fastest passage of one who knows the true wind [h]; ``None`` when there is none.
    log
        One entry for each time she planned anew.
    track
        ``(n, 3)`` seconds since 1970, lat and lon as sailed with re-planning.
    """

    request: PassageRequest
    departure: datetime
    expected_h: float
    sailed_h: float | None
    kept_h: float | None
    hindsight_h: float | None
    log: tuple[LogEntry, ...]
    max_tws_kn: float
    track: Array

    @property
    def gained_h(self) -> float | None:
        """Hours that re-planning saves."""
        if self.sailed_h is None or self.kept_h is None:
            return None
        return self.kept_h - self.sailed_h


def simulate(
    request: PassageRequest,
    forecasts: Sequence[Wind],
    truth: Wind,
    *,
    settings: Settings,
    tolerance: Tolerance | None = None,
    job: Job = NOBODY,
) -> Voyage:
    """Sail a passage in a true wind, planning with the newest forecast that is issued by then.

    She leaves with the plan of the newest forecast at departure. At each waypoint she holds the wind she
    meets against the one the forecast has there for that moment; where they differ by more than the tolerance
    she plans anew from there, unless she did so within the hour with the same forecast. Between, she follows
    her waypoints and tacks where the wind heads her.

    Parameters
    ----------
    request
        Ports, yacht, departure, options and zones; its wind is not looked at.
    forecasts
        Each with the time of its issue; at least one issued by the departure.
    truth
        The wind that blows.

    Raises
    ------
    InputError
        A forecast does not tell its issue, or none is issued by the departure.
    NoPassageError
        There is no passage at the departure; `CancelledError` as usual.
    """
    if request.departure is None or request.departure.tzinfo is None:
        raise InputError("A simulation needs a departure with a time zone (--depart).")
    # What is planned, sailed and held against each other is one wind, beyond its horizon too.
    known = [extend(wind, request.options.beyond) for wind in _by_issue(forecasts)]
    truth = extend(truth, request.options.beyond)
    sailor = _Sailor(request, known, truth, settings, tolerance or Tolerance(), job)
    first = sailor.planned((), request.departure)
    job.report("check", None, "Sailing the first plan in the true wind")
    kept = sailor.sail(waypoints_of(first), request.departure)
    sailed = sailor.voyage(first, request.departure)
    try:
        hindsight = plan(replace(request, wind=truth), settings=settings, job=job).duration_h
    except NoPassageError:
        hindsight = None
    begin = request.departure.timestamp()
    return Voyage(
        request=request,
        departure=request.departure,
        expected_h=first.duration_h,
        sailed_h=(float(sailed.track[-1, 0]) - begin) / SECONDS_PER_HOUR if sailed.arrived else None,
        kept_h=(float(kept.time[-1]) - begin) / SECONDS_PER_HOUR if kept.arrived else None,
        hindsight_h=hindsight,
        log=tuple(sailed.log),
        max_tws_kn=sailed.max_tws_kn,
        track=sailed.track,
    )


def _by_issue(forecasts: Sequence[Wind]) -> list[Wind]:
    nameless = next((w.forecast.source for w in forecasts if w.forecast.issued is None), None)
    if nameless or not forecasts:
        raise InputError(
            f"The forecast {nameless} does not tell when it was issued; give it (--issued)."
            if nameless
            else "A simulation needs at least one forecast."
        )
    return sorted(forecasts, key=lambda w: w.forecast.issued or datetime.min.replace(tzinfo=UTC))


@dataclass(slots=True)
class _Sailed:
    """What a voyage leaves behind."""

    log: list[LogEntry]
    track: Array
    max_tws_kn: float
    arrived: bool


@dataclass(frozen=True, slots=True)
class _Sailor:
    """Who sails a simulation: `simulate` in steps."""

    request: PassageRequest
    forecasts: list[Wind]
    truth: Wind
    settings: Settings
    tolerance: Tolerance
    job: Job

    def newest(self, time: datetime) -> Wind:
        """Give the newest forecast that is issued by a time."""
        known = [w for w in self.forecasts if w.forecast.issued and w.forecast.issued <= time]
        if not known:
            first = self.forecasts[0].forecast
            assert first.issued is not None
            raise InputError(
                f"No forecast is issued by the departure at {format_utc(time)}; the first one "
                f"({first.source}) is of {format_utc(first.issued)}."
            )
        return known[-1]

    def planned(self, here: Position | tuple[()], time: datetime) -> Passage:
        """Plan from a position, or from the start, with what is known then."""
        start = Port(UNDER_WAY, "", *here) if here else self.request.start
        request = replace(self.request, start=start, wind=self.newest(time), departure=time)
        return plan(request, settings=self.settings, job=self.job)

    def sail(self, way: Sequence[Position], time: datetime) -> Resailed:
        """Follow waypoints in the true wind."""
        request = replace(self.request, wind=self.truth)
        sea = sea_between(request.start, request.end, self.settings)
        return sail_along(request, way, departure=time.timestamp(), sea=sea)

    def voyage(self, passage: Passage, time: datetime) -> _Sailed:
        """Sail to the end, planning anew wherever the wind is another one."""
        way, begun = waypoints_of(passage), time
        forecast = self.newest(time)
        done = _Sailed([], np.empty((0, 3)), 0.0, arrived=False)
        while True:
            self.job.check()
            sailed = self.sail(way, begun)
            stop = self._surprise(sailed, way, forecast) if len(way) > 2 else None
            upto = sailed.time.size - 1 if stop is None else int(sailed.at[stop])
            rows = np.stack([sailed.time, sailed.lat, sailed.lon], axis=1)
            # The sample of the waypoint itself comes with what is sailed from there.
            done.track = np.concatenate([done.track, rows[: upto + (1 if stop is None else 0)]])
            done.max_tws_kn = max(done.max_tws_kn, float(sailed.tws[: upto + 1].max()) / MS_PER_KNOT)
            if stop is None:
                done.arrived = sailed.arrived
                return done
            begun = datetime.fromtimestamp(float(sailed.time[upto]), UTC)
            way, forecast = self._anew(way[stop:], begun, forecast, done)

    def _surprise(self, sailed: Resailed, way: Sequence[Position], forecast: Wind) -> int | None:
        """Find the first waypoint on the way where the wind is not the one forecast."""
        reached = sailed.at.size - (0 if sailed.arrived else 1)
        for k in range(1, min(len(way) - 1, reached)):
            time = float(sailed.time[sailed.at[k]])
            rested = time - float(sailed.time[0]) < LEAST_BETWEEN_S
            if rested and self.newest(datetime.fromtimestamp(time, UTC)) is forecast:
                continue
            if self.tolerance.exceeded(*self._winds(way[k], time, forecast)):
                return k
        return None

    def _winds(
        self, here: Position, time: float, forecast: Wind
    ) -> tuple[tuple[float, float], tuple[float, float]]:
        """Wind forecast and wind met, as speed [kn] and direction."""
        return _wind_at(forecast, time, here), _wind_at(self.truth, time, here)

    def _anew(
        self, way: list[Position], time: datetime, forecast: Wind, done: _Sailed
    ) -> tuple[list[Position], Wind]:
        """Plan anew from the first of the waypoints left; without a passage keep to them."""
        here = way[0]
        expected_wind, met = self._winds(here, time.timestamp(), forecast)
        newest = self.newest(time)
        expected, reason = None, ""
        if apart_nm(here, way[-1]) >= ARRIVED_NM:
            self.job.report("search", None, f"Planning anew at {format_utc(time)}")
            try:
                passage = self.planned(here, time)
                way, expected = distinct([here, *waypoints_of(passage)]), passage.arrival
            except NoPassageError as error:
                reason = error.reason
        issued = newest.forecast.issued
        done.log.append(LogEntry(time, here, expected_wind, met, issued, expected, reason))
        return way, newest


def _wind_at(wind: Wind, time: float, here: Position) -> tuple[float, float]:
    from seacruise.weather.wind import to_direction

    tws, twd = to_direction(*wind.at(time, *here))
    return float(tws) / MS_PER_KNOT, float(twd)
