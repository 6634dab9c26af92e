"""Wind from Storm Glass: few requests, counted, cached, and each of them bounded.

The service answers for one place at a time and the free plan allows ten answers a day, each of ten days'
hours. So a coarse regular grid over the passage is asked, only at sea, and the rest filled in between.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime, timedelta
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import NoPassageError, WeatherError
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.weather.answers import Meta
from seacruise.weather.cache import CachedAnswer, Memory, PointAnswer, Quota
from seacruise.weather.grids import Box
from seacruise.weather.http import Limits, timed_out
from seacruise.weather.points import IsWater, PointPlan, plan_points, spread
from seacruise.weather.pool import Outcome, run_all
from seacruise.weather.stormglass_client import PARAMS, SERVICE, Client, check_key, quota_error
from seacruise.weather.wind import Forecast, Wind, describe_grid, from_direction

HORIZON: Final = timedelta(days=10)
"""How far the service's default model looks ahead."""

Array = NDArray[np.float64]
OnDone = Callable[[int, int, Outcome[PointAnswer]], bool]

_STOPPING: Final = frozenset({"quota", "bad-key"})


@dataclass(frozen=True, slots=True)
class StormGlassConfig:
    """How Storm Glass is asked.

    Attributes
    ----------
    source
        Preferred model; ``"sg"`` is the service's own choice of the best one per place.
    parallel
        Requests under way at a time.
    batch_s
        Deadline of all requests together [s]; that of each one is in ``limits``.
    fresh_s
        Age up to which a cached answer is as good as a new one [s]: the models run every six hours.
    reserve
        Requests of a day that are left alone, for a look at the forecast elsewhere.
    max_points
        Requests for one passage at most, however large the plan.
    enough
        Share of the places that must have an answer for the wind to be used.
    """

    source: str = "sg"
    parallel: int = 5
    batch_s: float = 120.0
    fresh_s: float = 6 * 3600.0
    reserve: int = 1
    max_points: int = 40
    enough: float = 0.5
    limits: Limits = field(default_factory=Limits)


@dataclass(frozen=True, slots=True, eq=False)
class _Gathered:
    """Answers for the places of a plan: those at hand, and the older ones for when nothing better comes."""

    plan: PointPlan
    fresh: dict[int, CachedAnswer]
    stale: dict[int, CachedAnswer]

    @property
    def missing(self) -> list[int]:
        """Places without a fresh answer."""
        return [index for index in range(self.plan.rows.size) if index not in self.fresh]


def horizon_of(now: datetime) -> tuple[datetime, datetime]:
    """First and last time that Storm Glass answers for: today 00:00 UTC and ten days on."""
    today = now.astimezone(UTC).replace(hour=0, minute=0, second=0, microsecond=0)
    return today, today + HORIZON


class StormGlass:
    """The service, its cache and its ledger of requests.

    Parameters
    ----------
    settings
        Address, key and the file that cache and ledger live in; a file that cannot be used is done
        without, which is reported.

    Raises
    ------
    WeatherError
        ``no-key`` or ``bad-key``, before anything is sent.
    """

    def __init__(self, settings: Settings, config: StormGlassConfig | None = None) -> None:
        self.config = config or StormGlassConfig()
        self._settings = settings
        self._key = check_key(settings)
        self._memory = Memory(settings.database)
        self._service = f"stormglass {PARAMS} {self.config.source}"

    def quota(self, now: datetime) -> Quota:
        """Look up the requests of today, as far as the ledger knows."""
        return self._memory.quota(self._key, now)

    def wind(
        self,
        box: Box,
        *,
        departure: datetime | None,
        now: datetime,
        job: Job,
        is_water: IsWater | None = None,
    ) -> Wind:
        """Get the wind over an area, from today to the end of the forecast.

        Parameters
        ----------
        box
            South, west, north, east [degrees].
        departure
            Checked before anything is sent, so that no request is spent on a day without a forecast.

        Raises
        ------
        WeatherError
            With its reason, when too few places have an answer, old ones included.
        NoPassageError
            ``outside-forecast`` when the departure is beyond the forecast.
        CancelledError
        """
        begin, end = horizon_of(now)
        if departure is not None and not begin <= departure <= end:
            raise NoPassageError(
                f"Storm Glass forecasts from {begin:%d %b %Y} to {end:%d %b %Y}; choose a departure between "
                "them, or another forecast.",
                reason="outside-forecast",
            )
        gathered = self._plan(box, now, is_water)
        error = self._fetch_missing(gathered, now, job)
        if self._memory.trouble:
            job.report("wind", None, f"Forecasts are not kept. {self._memory.trouble}")
        return self._assemble(gathered, now, error, departure or now)

    def _plan(self, box: Box, now: datetime, is_water: IsWater | None) -> _Gathered:
        """Find the finest grid whose missing answers today's requests can buy.

        The size of the day's quota, and not what is left of it, is tried first, so that a second plan of
        the same passage asks for the same places and finds them in the cache. A grid that has enough of
        them is kept, whatever else could be bought.
        """
        quota = self.quota(now)
        most = min(max(quota.daily - self.config.reserve, 1), self.config.max_points)
        widest: _Gathered | None = None
        while most >= 1:
            tried = self._gather(plan_points(box, most=most, is_water=is_water), now)
            widest = widest or tried
            if len(tried.missing) <= self._budget(quota) or self._is_enough(len(tried.fresh), tried):
                return tried
            most = min(most, tried.plan.rows.size) - 1
        # nothing can be bought; the widest plan is the one that old answers may be there for
        assert widest is not None
        return widest

    def _budget(self, quota: Quota) -> int:
        return max(quota.left - self.config.reserve, 0)

    def _is_enough(self, answers: int, gathered: _Gathered) -> bool:
        return answers >= max(1, math.ceil(self.config.enough * gathered.plan.rows.size))

    def _gather(self, plan: PointPlan, now: datetime) -> _Gathered:
        gathered = _Gathered(plan=plan, fresh={}, stale={})
        for index, (lat, lon) in enumerate(plan.places):
            cached = self._memory.recall(lat, lon, self._service)
            if cached is not None:
                # an answer from the future is a clock that was set back, and as good as new
                is_fresh = now.timestamp() - cached.fetched < self.config.fresh_s
                (gathered.fresh if is_fresh else gathered.stale)[index] = cached
        return gathered

    def _fetch_missing(self, gathered: _Gathered, now: datetime, job: Job) -> WeatherError | None:
        """Ask for the places without a fresh answer; returns why some still have none."""
        quota = self.quota(now)
        asked = gathered.missing[: self._budget(quota)]
        if not gathered.missing:
            job.report("wind", 1.0, f"Storm Glass: no request needed, {quota.left} left today")
            return None
        if not asked:
            return quota_error(quota.left)
        left = f"{quota.left} left today" if quota.known else f"{quota.daily} a day on this plan"
        job.report("wind", 0.0, f"Storm Glass: {len(asked)} request{'s' * (len(asked) > 1)}, {left}")
        errors: list[WeatherError] = []

        def on_done(done: int, position: int, outcome: Outcome[PointAnswer]) -> bool:
            job.report("wind", done / len(asked), f"wind {done} of {len(asked)}")
            if outcome.value is not None:
                gathered.fresh[asked[position]] = CachedAnswer(outcome.value, fetched=now.timestamp())
                self._memory.keep(self._service, gathered.fresh[asked[position]])
            elif outcome.error is not None:
                errors.append(outcome.error)
            return outcome.error is None or outcome.error.reason not in _STOPPING

        self._ask_all([gathered.plan.places[index] for index in asked], now, job, on_done)
        # a spent quota or a wrong key explains the others that failed with it
        return next((error for error in errors if error.reason in _STOPPING), errors[0] if errors else None)

    def _ask_all(
        self, places: Sequence[tuple[float, float]], now: datetime, job: Job, on_done: OnDone
    ) -> None:
        config = self.config
        begin, end = horizon_of(now)
        window = begin.timestamp(), end.timestamp()

        def count(meta: Meta) -> None:
            self._memory.note_request(self._key, now, used=meta.used, daily=meta.daily, spent=meta.spent)

        client = Client(self._settings, config.limits, count)
        try:
            run_all(
                places,
                lambda place, stop: client.ask(place, window, source=config.source, stop=stop),
                job=job,
                parallel=config.parallel,
                each_s=config.limits.total_s,
                batch_s=config.batch_s,
                on_done=on_done,
                late=lambda: timed_out(SERVICE, config.limits.total_s),
            )
        finally:
            client.close()

    def _assemble(
        self, gathered: _Gathered, now: datetime, error: WeatherError | None, needed: datetime
    ) -> Wind:
        """Make the grid of the answers there are; old ones only where nothing better came."""
        old = {
            index: cached
            for index, cached in gathered.stale.items()
            if index not in gathered.fresh and cached.answer.time[-1] > needed.timestamp()
        }
        answers = {**old, **gathered.fresh}
        if not self._is_enough(len(answers), gathered):
            raise error or quota_error()
        plan, indices = gathered.plan, sorted(answers)
        points = [answers[index].answer for index in indices]
        answered = np.zeros(plan.rows.size, dtype=np.bool_)
        answered[indices] = True
        time, u, v = _on_common_hours(points)
        oldest = min(cached.fetched for cached in answers.values())
        age_h = (now.timestamp() - oldest) / 3600.0 if old else 0.0
        valid_from, valid_to, step_h, resolution = describe_grid(time, plan.lat, plan.lon)
        forecast = Forecast(
            source=f"{SERVICE} ({self.config.source})",
            issued=datetime.fromtimestamp(oldest, UTC),
            valid_from=valid_from,
            valid_to=valid_to,
            step_h=step_h,
            resolution_deg=resolution,
            notice=_notice(points, plan.rows.size, error, age_h),
        )
        grid_u, grid_v = (spread(plan, answered, part).astype(np.float32) for part in (u, v))
        return Wind(time=time, lat=plan.lat, lon=plan.lon, u=grid_u, v=grid_v, forecast=forecast)


def _on_common_hours(points: Sequence[PointAnswer]) -> tuple[Array, Array, Array]:
    """Components ``(t, n)`` of all points at the hours that any of them has, while all of them last."""
    first = max(point.time[0] for point in points)
    last = min(point.time[-1] for point in points)
    time = np.unique(np.concatenate([np.asarray(point.time, dtype=np.float64) for point in points]))
    time = time[(time >= first) & (time <= last)]
    if time.size < 2:
        raise WeatherError("The answers of Storm Glass for this passage have no hours in common; try again.")
    u, v = np.empty((time.size, len(points))), np.empty((time.size, len(points)))
    for column, point in enumerate(points):
        east, north = from_direction(point.speed, point.direction)
        u[:, column] = np.interp(time, point.time, east)
        v[:, column] = np.interp(time, point.time, north)
    return time, u, v


def _notice(points: Sequence[PointAnswer], total: int, error: WeatherError | None, age_h: float) -> str:
    """Say with the wind what is not as it should be: old, incomplete, from another model."""
    parts = []
    if age_h > 0:
        parts.append(f"The wind is from an answer {age_h:.0f} h old.")
    if len(points) < total:
        parts.append(f"{len(points)} of {total} places have an answer; the wind between them is filled in.")
    if error is not None:
        parts.append(str(error))
    parts += dict.fromkeys(note for point in points for note in point.notes)
    return " ".join(parts)
