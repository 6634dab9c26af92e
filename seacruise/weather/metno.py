"""Wind from MET Norway's Locationforecast: the Nordic models, place by place, with good manners.

The service is free for everybody who says who they are, asks no more often than its answers change, and
shows where the data is from. See its terms of service at api.met.no.
"""

from __future__ import annotations

import math
import re
import threading
import time as clock
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime, timedelta
from email.utils import parsedate_to_datetime
from typing import Final

import msgspec
import numpy as np
from numpy.typing import NDArray

from seacruise.errors import WeatherError
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.weather.grids import Box
from seacruise.weather.http import Call, Limits, Reply, fetch, program_name, require_name, timed_out
from seacruise.weather.points import IsWater, PointPlan, plan_points
from seacruise.weather.pool import Outcome, run_all
from seacruise.weather.series import (
    Series,
    common_times,
    gusts_on_grid,
    has,
    lasting,
    onto_grid,
    require_hours,
    unique_hours,
)
from seacruise.weather.sessions import Sessions
from seacruise.weather.shelf import Kept, Shelf
from seacruise.weather.wind import MAX_SPEED, Forecast, Wind, describe_grid, from_direction, require_departure

SERVICE: Final = "MET Norway"
TERMS: Final = "Weather data by MET Norway (CC BY 4.0)."
DEPRECATED: Final = "MET Norway will soon end this version of its service; look for a newer SeaCruise."
ABOUT: Final = "passage planner for cruising under sail"
LONGEST_CONTACT: Final = 100
"""Letters of a contact that are sent."""

HORIZON: Final = timedelta(days=9)
"""How far the service looks ahead, at least."""

MAX_GAP_H: Final = 12.0
"""A longer hole between two hours is not bridged; the steps at the end of the forecast are of 6 h [h]."""

MAX_ECHO_DEG: Final = 0.2
"""How far the place of an answer may lie from the place asked [degrees]."""

_PATH: Final = "/weatherapi/locationforecast/2.0/complete"
_KEPT_AS: Final = "metno"
_DEFAULT_EXPIRY_S: Final = 1800.0
_LONGEST_EXPIRY_S: Final = 6 * 3600.0
_LOST_AFTER: Final = 4
"""Failures without a single answer after which no more places are asked."""

_STOPPING: Final = frozenset({"no-network", "quota"})

Array = NDArray[np.float64]
Grid = NDArray[np.float32]


@dataclass(frozen=True, slots=True)
class MetNoConfig:
    """How MET Norway is asked.

    Attributes
    ----------
    parallel
        Requests under way at a time.
    pace_s
        Least time between the starts of two requests [s]; the service wants fewer than 20 a second.
    batch_s
        Deadline of everything together [s]; that of each request is in ``limits``.
    name_s
        Time to find the name of the service's computer [s].
    max_points
        Places of a grid at most.
    enough
        Share of the places that must have an answer for the wind to be used.
    """

    parallel: int = 2
    pace_s: float = 0.15
    batch_s: float = 28.0
    name_s: float = 4.0
    max_points: int = 36
    enough: float = 0.5
    limits: Limits = field(default_factory=lambda: Limits(connect_s=4.0, read_s=8.0, total_s=20.0, tries=2))


class _Instant(msgspec.Struct):
    details: dict[str, float | None]


class _Data(msgspec.Struct):
    instant: _Instant


class _Step(msgspec.Struct):
    time: datetime
    data: _Data


class _Meta(msgspec.Struct):
    units: dict[str, str]


class _Properties(msgspec.Struct):
    meta: _Meta
    timeseries: list[_Step]


class _Geometry(msgspec.Struct):
    coordinates: list[float]


class _Body(msgspec.Struct):
    geometry: _Geometry
    properties: _Properties


_DECODER: Final = msgspec.json.Decoder(_Body)
_UNITS: Final = {
    "wind_speed": frozenset({"m/s"}),
    "wind_speed_of_gust": frozenset({"m/s"}),
    "wind_from_direction": frozenset({"degrees", "degree", "°"}),
}


def user_agent(contact: str) -> str:
    """Say who asks; the service blocks programs that do not.

    Its terms want the name of the program, and an e-mail address or a site "where we can find contact
    information. If we cannot contact you in case of problems, you risk being blocked without warning"
    (https://api.met.no/doc/TermsOfService, Identification). SeaCruise has no site of its own, so that it is
    the contact of who runs it; see `seacruise.settings.Settings`.
    """
    # parentheses enclose a comment (RFC 9110, 5.6.5); what is no ASCII may not be in a header
    fit = re.sub(r"[^ -~]|[()\\]", "", contact)[:LONGEST_CONTACT].strip()
    return f"{program_name()} ({ABOUT}{f'; contact {fit}' if fit else ''})"


def horizon_of(now: datetime) -> tuple[datetime, datetime]:
    """First and last time that MET Norway answers for: this hour and nine days on."""
    hour = now.astimezone(UTC).replace(minute=0, second=0, microsecond=0)
    return hour, hour + HORIZON


def truncated(degrees: float) -> float:
    """Cut a coordinate to the four decimals that the service takes."""
    return math.trunc(degrees * 10_000) / 10_000


def to_series(body: bytes, place: tuple[float, float], now: float) -> Series:
    """Make a series of an answer: ``u``, ``v`` and ``gust``, hourly at first, six-hourly later.

    Raises
    ------
    msgspec.DecodeError
        When it is not JSON, or not of the service's shape (`msgspec.ValidationError`).
    WeatherError
        ``bad-response`` when it is for elsewhere or other days, in other units, or physically impossible.
    """
    decoded = _DECODER.decode(body)
    where = decoded.geometry.coordinates[:2]
    if len(where) < 2 or any(
        abs((echo - asked + 180.0) % 360.0 - 180.0) > MAX_ECHO_DEG
        for echo, asked in zip(where, (place[1], place[0]), strict=True)
    ):
        raise WeatherError(f"{SERVICE} answered for another place than the one asked; try again later.")
    steps = decoded.properties.timeseries
    columns = {name: _column(steps, name, decoded.properties.meta.units) for name in _UNITS}
    speed, direction = columns["wind_speed"], columns["wind_from_direction"]
    wrong = np.nonzero((speed < 0.0) | (speed > MAX_SPEED))[0]
    if wrong.size:
        raise WeatherError(
            f"{SERVICE} sent a wind of {speed[wrong[0]]:g} m/s, which cannot be; try again later."
        )
    time = np.array([_seconds(step.time) for step in steps], dtype=np.float64)
    if not time.size or time.max() < now:
        raise WeatherError(f"{SERVICE} answered for other days than those asked; check this computer's date.")
    gust = columns["wind_speed_of_gust"]
    u, v = from_direction(speed, np.where(np.abs(direction) <= 720.0, direction, np.nan))
    hours, values = unique_hours(
        time, {"u": u, "v": v, "gust": np.where((gust >= 0) & (gust <= 2 * MAX_SPEED), gust, np.nan)}
    )
    series = Series(place[0], place[1], hours, values)
    require_hours(SERVICE, [series], ("u", "v"), max_gap_h=MAX_GAP_H)
    return series


def _column(steps: list[_Step], name: str, units: dict[str, str]) -> Array:
    values = np.array([step.data.instant.details.get(name) for step in steps], dtype=np.float64)
    unit = units.get(name, "")
    if unit not in _UNITS[name] and np.isfinite(values).any():
        known = re.sub(r"[^ -~]+", "?", unit)[:20]
        raise WeatherError(f"{SERVICE} sent an answer of another shape than expected ({name} in {known!r}).")
    return values


def _seconds(time: datetime) -> float:
    return (time if time.tzinfo else time.replace(tzinfo=UTC)).timestamp()


def _moment_of(header: str) -> float | None:
    """Seconds since 1970 of a date in a header; ``None`` for what is none."""
    try:
        when = parsedate_to_datetime(header)
    except ValueError:
        return None
    return _seconds(when)


class MetNo:
    """The service and what is kept of it.

    Parameters
    ----------
    settings
        Address, and the file that answers are kept in; a file that cannot be used is done without, which
        is reported.
    """

    def __init__(self, settings: Settings, config: MetNoConfig | None = None) -> None:
        self.config = config or MetNoConfig()
        self._url = settings.metno_url + _PATH
        self._agent = user_agent(settings.contact)
        self._shelf = Shelf(settings.database)
        self._turn = threading.Lock()
        self._next = 0.0

    def wind(
        self,
        box: Box,
        *,
        departure: datetime | None,
        now: datetime,
        job: Job,
        is_water: IsWater | None = None,
    ) -> Wind:
        """Get wind and gusts over an area, from this hour to the end of the forecast.

        The parameters are those of `seacruise.weather.openmeteo.OpenMeteo.wind`; places are asked at sea
        only, the others are filled in.

        Raises
        ------
        WeatherError
            With its reason, when too few places have an answer, old ones included.
        NoPassageError
            ``outside-forecast`` when the departure is beyond the forecast.
        CancelledError
        """
        require_departure(SERVICE, horizon_of(now), departure)
        plan = plan_points(box, most=self.config.max_points, is_water=is_water)
        kept = self._shelf.recall(_KEPT_AS, [_asked(place) for place in plan.places])
        errors = self._fetch(plan, kept, now, job)
        needed = (departure or now).timestamp()
        answers = {
            index: one
            for index, one in kept.items()
            if has(one.series, ("u", "v")) and one.series.time[-1] > needed
        }
        enough = max(1, math.ceil(self.config.enough * plan.rows.size))
        if len(answers) < enough:
            raise (
                errors[-1]
                if errors
                else WeatherError(f"{SERVICE} has no wind for this area; choose another forecast.")
            )
        series = {index: one.series for index, one in answers.items()}
        last = lasting(series, ("u", "v"), max_gap_h=MAX_GAP_H, least=enough)
        chosen = {index: one for index, one in answers.items() if index in last}
        return _assemble(plan, chosen, errors, now)

    def _fetch(self, plan: PointPlan, kept: dict[int, Kept], now: datetime, job: Job) -> list[WeatherError]:
        """Renew, in place, the answers that have expired; returns why some could not be."""
        expired = [
            index
            for index in range(plan.rows.size)
            if index not in kept or kept[index].expires <= now.timestamp()
        ]
        if not expired:
            job.report("wind", 1.0, f"{SERVICE}: no request needed, the answers kept are new enough")
            return []
        job.report("wind", 0.0, f"{SERVICE}: {len(expired)} request{'s' * (len(expired) > 1)}")
        errors: list[WeatherError] = []
        try:
            require_name(SERVICE, self._url, self.config.name_s, check=job.check)
        except WeatherError as error:
            return [error]
        arrived: list[Kept] = []
        sessions = Sessions()

        def on_done(done: int, position: int, outcome: Outcome[Kept]) -> bool:
            job.report("wind", done / len(expired), f"wind {done} of {len(expired)}")
            if outcome.value is not None:
                kept[expired[position]] = outcome.value
                arrived.append(outcome.value)
            elif outcome.error is not None:
                errors.append(outcome.error)
                lost = not arrived and (outcome.error.reason == "timeout" or len(errors) >= _LOST_AFTER)
                return not lost and outcome.error.reason not in _STOPPING
            return True

        try:
            run_all(
                expired,
                lambda index, stop: self._ask(sessions, plan.places[index], kept.get(index), now, stop),
                job=job,
                parallel=self.config.parallel,
                each_s=self.config.limits.total_s,
                batch_s=self.config.batch_s,
                on_done=on_done,
                late=lambda: timed_out(SERVICE, self.config.limits.total_s),
            )
        finally:
            sessions.close()
            # what came before a cancel is worth keeping too
            self._shelf.keep(_KEPT_AS, arrived)
        if self._shelf.trouble:
            job.report("wind", None, f"Forecasts are not kept. {self._shelf.trouble}")
        return errors

    def _ask(
        self,
        sessions: Sessions,
        place: tuple[float, float],
        before: Kept | None,
        now: datetime,
        stop: threading.Event,
    ) -> Kept:
        """Ask for one place; an answer that has not changed since is kept as it is."""
        lat, lon = _asked(place)
        replies: list[Reply] = []

        def decode(body: bytes) -> Series:
            if replies[-1].status == 304 and before is not None:
                return before.series
            return to_series(body, (lat, lon), now.timestamp())

        headers = {"User-Agent": self._agent}
        if before is not None and before.series.stamp:
            # the very text of the answer's own header: the service compares strings
            headers["If-Modified-Since"] = before.series.stamp
        call = Call(
            service=SERVICE,
            url=self._url,
            params={"lat": f"{lat:.4f}", "lon": f"{lon:.4f}"},
            headers=headers,
            decode=decode,
            refuse=_refusal,
            good=frozenset({200, 203, 304}) if before is not None else frozenset({200, 203}),
            note=replies.append,
        )
        self._wait_for_turn(stop)
        with sessions.one(stop) as session:
            series = fetch(session, call, self.config.limits, stop)
        reply = replies[-1]
        if reply.status != 304:
            notes = (DEPRECATED,) if reply.status == 203 else ()
            series = replace(series, notes=notes, stamp=reply.last_modified)
        fetched = now.timestamp()
        expires = _moment_of(reply.expires) or fetched + _DEFAULT_EXPIRY_S
        return Kept(series, fetched, min(max(expires, fetched), fetched + _LONGEST_EXPIRY_S))

    def _wait_for_turn(self, stop: threading.Event) -> None:
        with self._turn:
            begin = max(self._next, clock.monotonic())
            self._next = begin + self.config.pace_s
        stop.wait(max(begin - clock.monotonic(), 0.0))


def _asked(place: tuple[float, float]) -> tuple[float, float]:
    # a grid across the date line counts on beyond 180
    return truncated(place[0]), truncated((place[1] + 180.0) % 360.0 - 180.0)


def _refusal(reply: Reply) -> WeatherError | None:
    """Say what the service's own errors mean; ``None`` for those that mean the same everywhere."""
    if reply.status == 403:
        return WeatherError(
            f"{SERVICE} refuses this program or this network (HTTP 403); choose another forecast."
        )
    if reply.status == 429:
        return WeatherError(
            f"{SERVICE} is asked too often by this program or network; try again in some minutes, or choose "
            "another forecast.",
            reason="quota",
        )
    if reply.status in (400, 422):
        return WeatherError(f"{SERVICE} has no forecast for a place of this passage (HTTP {reply.status}).")
    return None


def _assemble(plan: PointPlan, answers: dict[int, Kept], errors: list[WeatherError], now: datetime) -> Wind:
    """Make the grid of the answers there are."""
    series = {index: kept.series for index, kept in answers.items()}
    time = common_times(SERVICE, list(series.values()), ("u", "v"), max_gap_h=MAX_GAP_H)
    u, v = (onto_grid(plan, series, name, time) for name in ("u", "v"))
    gust, gust_notice = gusts_on_grid(plan, series, time, np.hypot(u, v))
    notices = [gust_notice]
    oldest = min(kept.fetched for kept in answers.values())
    age_h = (now.timestamp() - oldest) / 3600.0
    total = plan.rows.size
    if errors and any(kept.expires <= now.timestamp() for kept in answers.values()):
        notices.append(f"Some of the wind is from an answer {age_h:.0f} h old.")
    if len(answers) < total:
        notices.append(f"{len(answers)} of {total} places have an answer; the rest is filled in.")
    notices += [str(error) for error in errors[-1:]]
    notices += dict.fromkeys(note for one in series.values() for note in one.notes)
    valid_from, valid_to, step_h, resolution = describe_grid(time, plan.lat, plan.lon)
    forecast = Forecast(
        source=SERVICE,
        issued=datetime.fromtimestamp(oldest, UTC),
        valid_from=valid_from,
        valid_to=valid_to,
        step_h=step_h,
        resolution_deg=resolution,
        notice=" ".join(filter(None, [*notices, TERMS])),
    )
    return Wind(time=time, lat=plan.lat, lon=plan.lon, u=u, v=v, gust=gust, forecast=forecast)
