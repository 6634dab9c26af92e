"""Wind from Storm Glass: few requests, counted, cached, and each of them bounded.

The service answers for one place at a time and the free plan allows ten answers a day, each of ten days'
hours. So a few places along the passage are asked, then those where their answers leave most in doubt
(`seacruise.weather.adaptive`), and the rest is filled in between.
"""

from __future__ import annotations

import contextlib
import re
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime, timedelta
from typing import Final

import numpy as np

from seacruise.errors import InputError, WeatherError
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.weather.answers import Meta
from seacruise.weather.cache import CachedAnswer, Found, Memory, Quota, place_id
from seacruise.weather.grids import Box, Place
from seacruise.weather.ground import Ground, survey
from seacruise.weather.http import Limits, require_name, timed_out
from seacruise.weather.hunt import ROUGHLY_NM, Hunt
from seacruise.weather.mosaic import common_hours, to_wind
from seacruise.weather.point import PointAnswer
from seacruise.weather.points import IsWater
from seacruise.weather.pool import Gate, Outcome, gate_to, run_all
from seacruise.weather.splice import describe_splices
from seacruise.weather.stormglass_client import SERVICE, Client, check_key, quota_error
from seacruise.weather.wind import Forecast, Wind, describe_grid, require_departure

HORIZON: Final = timedelta(days=10)
"""How far ahead is asked: the service's own default. How far an answer reaches, it says itself."""

FRESH_S: Final = 6 * 3600.0
"""Time after which most sources have a newer run [s]."""

UPDATE_CYCLES_S: Final = {"metno": 4 * 3600.0}
"""Of those with another cycle, by the service's own list of sources [s]."""

OLD_S: Final = 24 * 3600.0
"""Up to this age a whole forecast is better than a few new answers [s]."""

_EARLY_S: Final = 24 * 3600.0
"""An answer that ends earlier than this before the others' would cut them short [s]."""

_STOPPING: Final = frozenset({"quota", "bad-key"})
_UNREACHED: Final = frozenset({"no-network", "timeout"})


@dataclass(frozen=True, slots=True)
class StormGlassConfig:
    """How Storm Glass is asked.

    Attributes
    ----------
    source
        Wanted model; ``"sg"`` is the service's own choice of the best one per place. The vectors of
        several, joined by ``+``, are averaged.
    parallel
        Requests under way at a time, of all plans of this process together.
    batch_s
        Deadline of all requests of a plan together [s]; that of each one is in ``limits``.
    quiet_s
        How long nothing may come from the service before it is given up [s].
    reserve
        Requests of a day that are left alone, for a look at the forecast elsewhere.
    max_points
        Places for one passage at most, however large the plan of the service.
    first
        Places that are asked first, before the answers tell where to go on.
    enough
        Share of the places that must have an answer for the wind to be used.
    """

    source: str = "sg"
    parallel: int = 5
    batch_s: float = 120.0
    quiet_s: float = 30.0
    reserve: int = 1
    max_points: int = 40
    first: int = 6
    enough: float = 0.5
    limits: Limits = field(default_factory=Limits)

    @property
    def cycle_s(self) -> float:
        """Time after which an answer is no longer as good as a new one [s]."""
        return min(UPDATE_CYCLES_S.get(name, FRESH_S) for name in self.source.split("+"))

    def places(self, quota: Quota) -> int:
        """Count the places of a plan at most: by the size of a day's quota, not by what is left of it.

        So a later plan of the same passage is for the same places, and finds them in the cache.
        """
        return max(min(quota.daily - self.reserve, self.max_points), 1)


def config_named(name: str) -> StormGlassConfig:
    """Make the configuration that a forecast's name asks for.

    ``stormglass`` is the service's own choice, ``stormglass:noaa`` one model, and of
    ``stormglass:ecmwf+noaa`` the vectors are averaged.

    Raises
    ------
    InputError
        When what follows the colon is no name of a model.
    """
    _, colon, models = name.partition(":")
    if colon and not re.fullmatch(r"[a-z0-9:_.-]{1,24}(\+[a-z0-9:_.-]{1,24}){0,7}", models.lower()):
        raise InputError(
            f"{name!r} names no model of Storm Glass; write stormglass, stormglass:noaa, or "
            "stormglass:ecmwf+noaa for the mean of several."
        )
    return StormGlassConfig(source=models.lower()) if colon else StormGlassConfig()


def horizon_of(now: datetime) -> tuple[datetime, datetime]:
    """First and last time that Storm Glass is asked for: today 00:00 UTC and ten days on."""
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
        self._gate = gate_to(settings.stormglass_url, self.config.parallel)

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
        ends: tuple[Place, Place] | None = None,
    ) -> Wind:
        """Get the wind over an area, from today to the end of the forecast.

        Parameters
        ----------
        box
            South, west, north, east [degrees].
        departure
            Checked before anything is sent, so that no request is spent on a day without a forecast.
        ends
            Start and end of the passage, which the places asked then lie around.

        Raises
        ------
        WeatherError
            With its reason, when too few places have an answer, old ones included.
        NoPassageError
            ``outside-forecast`` when the departure is beyond the forecast.
        CancelledError
        """
        require_departure(SERVICE, horizon_of(now), departure)
        needed = (departure or now).timestamp()
        quota = self.quota(now)
        aim = max(self.config.places(quota), 1 if ends is None else 2)
        ground = survey(box, ends=ends, is_water=is_water, first=min(self.config.first, aim))
        hunt = Hunt(
            ground,
            # which places are asked does not depend on the departure, so that another one needs no request
            kept=self._kept(ground, needed),
            read=self._memory.read,
            now=now.timestamp(),
            needed=needed,
            fresh_s=self.config.cycle_s,
            aim=aim,
            left=quota.left,
            at_once=max(self.config.parallel, aim // 4),
            enough=self.config.enough,
        )
        error = self._fetch(hunt, now, quota, job)
        if self._memory.trouble:
            job.report("wind", None, f"Forecasts are not kept. {self._memory.trouble}")
        return self._assemble(hunt, error)

    def _kept(self, ground: Ground, needed: float) -> dict[str, Found]:
        """Answers in the cache for places on the ground that reach a time, by the name of the place."""
        # answers for other passages beside this one are better than none
        box = (
            float(ground.lat[0] - 1.0),
            float(ground.lon[0] - 1.0),
            float(ground.lat[-1] + 1.0),
            float(ground.lon[-1] + 1.0),
        )
        kept: dict[str, Found] = {}
        # earlier versions asked for the wind alone, which is still a forecast
        earlier = f"stormglass gust,windDirection,windSpeed {self.config.source}"
        for service in (earlier, service_of(self.config.source)):
            for one in self._memory.around(box, service, needed):
                place = place_id(one.lat, one.lon)
                if place not in kept or kept[place].fetched <= one.fetched:
                    kept[place] = one
        return kept

    def _fetch(self, hunt: Hunt, now: datetime, quota: Quota, job: Job) -> WeatherError | None:
        """Ask for the places that the plan wants; returns why some have no answer."""
        wanted = hunt.wanted()
        if hunt.is_short and self._old_will_do(hunt):
            return quota_error(quota.left)
        if len(wanted) < (2 if hunt.ground.ends and not hunt.answers else 1):
            if not hunt.suffices(hunt.answered()):
                return quota_error(quota.left)
            job.report("wind", 1.0, f"Storm Glass: no request needed, {quota.left} left today")
            return None
        total = min(hunt.at_most(), quota.left)
        job.report("wind", 0.0, _announce(hunt.at_most(), total, len(wanted), quota))
        rounds = _Rounds(hunt, self._settings, self.config, self._memory, now=now, job=job, total=total)
        try:
            # an address that is none is named by the request itself
            with contextlib.suppress(ValueError):
                require_name(SERVICE, self._settings.stormglass_url, self.config.limits.connect_s)
            while wanted and not rounds.is_over:
                rounds.ask(wanted, self._gate)
                wanted = hunt.wanted()
        except WeatherError as error:
            return error
        finally:
            rounds.client.close()
        # a spent quota or a wrong key explains the others that failed with it
        return next(
            (error for error in rounds.errors if error.reason in _STOPPING), next(iter(rounds.errors), None)
        )

    def _old_will_do(self, hunt: Hunt) -> bool:
        """Tell whether answers of the last day cover what the few requests left would only begin."""
        kept = [(one.lat, one.lon) for one in hunt.kept.values() if hunt.now - one.fetched < OLD_S]
        return hunt.suffices(kept) and not hunt.suffices(hunt.answered())

    def _assemble(self, hunt: Hunt, error: WeatherError | None) -> Wind:
        """Make the grid of the answers there are; old ones only where the new ones do not suffice."""
        used = [hunt.answers[one] for one in sorted(hunt.answers)]
        if not hunt.suffices(hunt.answered()):
            used += hunt.others()
            if not _will_do(hunt, used, error):
                raise error or quota_error()
        used = _lasting(hunt, used)
        points = [cached.answer for cached in used]
        times = common_hours(points)
        oldest = min(cached.fetched for cached in used)
        valid_from, valid_to, step_h, resolution = describe_grid(times, hunt.ground.lat, hunt.ground.lon)
        forecast = Forecast(
            source=f"{SERVICE} ({self.config.source})",
            issued=datetime.fromtimestamp(oldest, UTC),
            valid_from=valid_from,
            valid_to=valid_to,
            step_h=step_h,
            resolution_deg=resolution,
            notice=_notice(hunt, used, error),
        )
        return to_wind(hunt.ground, points, times, forecast)


class _Rounds:
    """The requests of one plan, round by round.

    Attributes
    ----------
    errors
        Why places have no answer, in the order of events.
    is_over
        Nothing more is to be had: the quota is spent, the key is wrong, or the service cannot be reached.
    """

    def __init__(
        self,
        hunt: Hunt,
        settings: Settings,
        config: StormGlassConfig,
        memory: Memory,
        *,
        now: datetime,
        job: Job,
        total: int,
    ) -> None:
        self.errors: list[WeatherError] = []
        self.is_over = False
        self._hunt, self._config, self._memory, self._job = hunt, config, memory, job
        self._now, self._total = now, total
        self._key = check_key(settings)
        self._begin = time.monotonic()
        self._done = self._sent = 0
        self.client = Client(settings, config.limits, self._count)

    def ask(self, wanted: Sequence[int], gate: Gate) -> None:
        """Ask for places and note what comes."""
        hunt, config = self._hunt, self._config
        hunt.left -= len(wanted)
        self._sent += len(wanted)
        begin, end = horizon_of(self._now)
        window = begin.timestamp(), end.timestamp()
        places = [(float(lat), float(lon)) for lat, lon in hunt.ground.places[list(wanted)]]
        run_all(
            places,
            lambda place, stop: self.client.ask(place, window, source=config.source, stop=stop),
            job=self._job,
            parallel=config.parallel,
            each_s=config.limits.total_s,
            batch_s=config.batch_s - (time.monotonic() - self._begin),
            on_done=lambda _, position, outcome: self._note(wanted[position], outcome),
            late=lambda: timed_out(SERVICE, config.limits.total_s),
            quiet_s=config.quiet_s,
            gate=gate,
        )

    def _note(self, place: int, outcome: Outcome[PointAnswer]) -> bool:
        self._done += 1
        self._job.report("wind", self._done / self._total, f"wind {self._done} of {self._total}")
        now, cycle = self._now.timestamp(), self._config.cycle_s
        if outcome.value is not None:
            # the service does not tell its run; an answer counts as of the cycle it was given in
            cached = CachedAnswer(outcome.value, fetched=now, expires=now + cycle, run=now // cycle * cycle)
            self._hunt.answers[place] = cached
            self._memory.keep(service_of(self._config.source), cached)
        elif outcome.error is not None:
            self._hunt.failed.add(place)
            self.errors.append(outcome.error)
            is_silent = outcome.error.reason in _UNREACHED and not self._done > len(self.errors)
            self.is_over |= outcome.error.reason in _STOPPING or is_silent
        return not self.is_over

    def _count(self, meta: Meta) -> None:
        # a plan may last beyond midnight
        now = self._now + timedelta(seconds=time.monotonic() - self._begin)
        counts = {"used": meta.used, "daily": meta.daily, "cost": meta.cost, "spent": meta.spent}
        self._memory.note_request(self._key, now, **counts, overtaking=self._sent)


def _announce(most: int, total: int, at_once: int, quota: Quota) -> str:
    """Say how many requests follow, and how many are left before them."""
    number = f"{'up to ' * (total > at_once)}{total} request{'s' * (total > 1)}"
    left = f"{quota.left} left today" if quota.known else f"{quota.daily} a day on this plan"
    shrunk = f"; {most} were planned" if total < most else ""
    return f"Storm Glass: {number}, {left}{shrunk}"


def _places(answers: Sequence[CachedAnswer]) -> list[tuple[float, float]]:
    return [(one.answer.lat, one.answer.lon) for one in answers]


def _will_do(hunt: Hunt, used: Sequence[CachedAnswer], error: WeatherError | None) -> bool:
    """Tell whether answers cover the passage, or nearly do and nothing better is to be had today."""
    if hunt.suffices(_places(used)):
        return True
    is_hopeless = error is None or error.reason in {"quota", *_UNREACHED}
    return is_hopeless and len(used) > len(hunt.answers) and hunt.gap_nm(_places(used)) <= ROUGHLY_NM


def _lasting(hunt: Hunt, used: list[CachedAnswer]) -> list[CachedAnswer]:
    """Leave out answers that end long before the others, which would end with them, if the rest suffices."""
    usual = float(np.median([cached.answer.time[-1] for cached in used]))
    lasting = [cached for cached in used if cached.answer.time[-1] > usual - _EARLY_S]
    return lasting if hunt.suffices(_places(lasting)) else used


def _notice(hunt: Hunt, used: Sequence[CachedAnswer], error: WeatherError | None) -> str:
    """Say with the wind what is not as it should be: old, incomplete, from another model."""
    parts = []
    tried = len(hunt.tried())
    oldest = min(cached.fetched for cached in used)
    if not all(hunt.is_fresh(cached) for cached in used):
        unreached = error is not None and error.reason in _UNREACHED
        why = "; the service could not be reached" if unreached else ""
        parts.append(f"The wind is from {SERVICE}, {(hunt.now - oldest) / 3600.0:.0f} h old{why}.")
    elif len(used) < tried:
        parts.append(f"{len(used)} of {tried} places have an answer; the wind between them is filled in.")
    if not hunt.suffices(_places(used)):
        gap = hunt.gap_nm(_places(used))
        parts.append(
            f"Its answers were asked for another passage and lie up to {gap:.0f} nm away from this one."
        )
    if hunt.is_short and error is None:
        parts.append(
            f"Only {tried} of {hunt.aim} planned places were asked: no more requests were left today."
        )
    if error is not None:
        parts.append(str(error))
    parts += dict.fromkeys(note for cached in used for note in cached.answer.notes)
    parts += describe_splices(SERVICE, (one for cached in used for one in cached.answer.splices))
    return " ".join(parts)


def service_of(source: str) -> str:
    """Name under which answers are kept in the cache."""
    return f"stormglass {source}"
