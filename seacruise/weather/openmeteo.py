"""Wind from Open-Meteo, without a key: a whole grid of places in a few requests, waves and current with it.

The free service counts places, not requests: 600 a minute. So a grid has at most 200 of them, one of an
ensemble, whose places count tenfold, 40; and what was answered is kept until the models have run again.
"""

from __future__ import annotations

import math
import threading
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime, timedelta
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import WeatherError
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.weather.grids import Box
from seacruise.weather.http import Limits, require_name, timed_out
from seacruise.weather.openmeteo_answers import MAX_GAP_H, SERVICE, Asked
from seacruise.weather.openmeteo_client import DAYS, ENSEMBLE, FORECAST, MARINE, Endpoint, ask
from seacruise.weather.points import IsWater, PointPlan, plan_points
from seacruise.weather.pool import Outcome, run_all
from seacruise.weather.series import (
    Series,
    common_times,
    format_moment,
    from_nearest,
    gusts_on_grid,
    has,
    lasting,
    onto_grid,
)
from seacruise.weather.sessions import Sessions
from seacruise.weather.shelf import Kept, Shelf
from seacruise.weather.wind import Current, Forecast, Wind, describe_grid, require_departure

Array = NDArray[np.float64]
Grid = NDArray[np.float32]

TERMS: Final = "Weather data by Open-Meteo.com (CC BY 4.0); its free service is for non-commercial use."
"""What the service asks to be shown with its data."""

LEAST_KEPT_S: Final = 3600.0
"""An answer is as good as a new one for an hour at least, however soon the next run is due [s]."""

_STOPPING: Final = frozenset({"no-network", "timeout", "quota"})
_CURRENT: Final = ("current_u", "current_v")


@dataclass(frozen=True, slots=True)
class OpenMeteoConfig:
    """How Open-Meteo is asked.

    Attributes
    ----------
    parallel
        Requests under way at a time.
    batch_s
        Deadline of everything together [s]; that of each request is in ``limits``.
    sea_s
        Deadline of a request for waves and current [s], which a passage can do without.
    name_s
        Time to find the name of the service's computer [s].
    cycle_s, ensemble_cycle_s
        Models run this often [s]; answers are kept until the clock passes the next multiple.
    max_points, max_ensemble_points
        Places of a grid at most.
    enough
        Share of the places that must have an answer for the wind to be used.
    """

    parallel: int = 2
    batch_s: float = 28.0
    sea_s: float = 8.0
    name_s: float = 4.0
    cycle_s: float = 3 * 3600.0
    ensemble_cycle_s: float = 6 * 3600.0
    max_points: int = 200
    max_ensemble_points: int = 40
    enough: float = 0.5
    limits: Limits = field(default_factory=lambda: Limits(connect_s=4.0, read_s=8.0, total_s=20.0, tries=2))


@dataclass(frozen=True, slots=True, eq=False)
class _Gathered:
    """Answers of an endpoint for a plan: those at hand, and older ones for when nothing better comes.

    Attributes
    ----------
    errors
        Why some places have no answer, the latest last.
    """

    endpoint: Endpoint
    plan: PointPlan
    fresh: dict[int, Kept]
    stale: dict[int, Kept]
    errors: list[WeatherError]

    def requests(self) -> list[tuple[_Gathered, list[int]]]:
        """Divide the places without a fresh answer into requests.

        Neighbours go into different ones, so that a request that fails leaves a coarser grid, not a hole.
        """
        missing = [index for index in range(self.plan.rows.size) if index not in self.fresh]
        count = math.ceil(len(missing) / self.endpoint.places_each)
        return [(self, missing[number::count]) for number in range(count)]


def horizon_of(now: datetime) -> tuple[datetime, datetime]:
    """First and last time that Open-Meteo is asked for: today 00:00 UTC and `DAYS` on."""
    today = now.astimezone(UTC).replace(hour=0, minute=0, second=0, microsecond=0)
    return today, today + timedelta(days=DAYS)


class OpenMeteo:
    """The service and what is kept of it.

    Parameters
    ----------
    settings
        Address, and the file that answers are kept in; a file that cannot be used is done without, which
        is reported.
    """

    def __init__(self, settings: Settings, config: OpenMeteoConfig | None = None) -> None:
        self.config = config or OpenMeteoConfig()
        self._settings = settings
        self._shelf = Shelf(settings.database)

    def wind(
        self,
        box: Box,
        *,
        departure: datetime | None,
        now: datetime,
        job: Job,
        is_water: IsWater | None = None,
    ) -> Wind:
        """Get wind and gusts over an area, and waves and current over its sea.

        Parameters
        ----------
        box
            South, west, north, east [degrees].
        departure
            Checked before anything is sent.
        is_water
            Tells for arrays of latitudes and longitudes which are water: only there is a sea asked for.
            Its failure costs waves and current, with a notice, and not the wind.

        Raises
        ------
        WeatherError
            With its reason, when too few places have an answer, old ones included.
        NoPassageError
            ``outside-forecast`` when the departure is beyond the forecast.
        CancelledError
        """
        require_departure(SERVICE, horizon_of(now), departure)
        plan = plan_points(box, most=self.config.max_points)
        wind = self._gather(FORECAST, plan, now)
        sea = self._gather(MARINE, _at_sea(plan, is_water), now)
        self._fetch([wind, sea], now, job)
        answers, notices = self._usable(wind, ("u", "v"), now, departure)
        series = {index: kept.series for index, kept in answers.items()}
        time = common_times(SERVICE, list(series.values()), ("u", "v"), max_gap_h=MAX_GAP_H)
        u, v = (onto_grid(plan, series, name, time) for name in ("u", "v"))
        gust, gust_notice = gusts_on_grid(plan, series, time, np.hypot(u, v))
        wave, current, sea_notice = self._sea(sea, time, now)
        notices += [gust_notice, sea_notice, TERMS]
        return Wind(
            time=time,
            lat=plan.lat,
            lon=plan.lon,
            u=u,
            v=v,
            gust=gust,
            wave=wave,
            current=current,
            forecast=_describe(SERVICE, plan, time, answers, notices),
        )

    def ensemble(self, box: Box, *, departure: datetime | None, now: datetime, job: Job) -> Wind:
        """Get the members of an ensemble over an area; their mean is the wind, their spread its ``spread``.

        The parameters and errors are those of `wind`.
        """
        require_departure(SERVICE, horizon_of(now), departure)
        plan = plan_points(box, most=self.config.max_ensemble_points)
        gathered = self._gather(ENSEMBLE, plan, now)
        self._fetch([gathered], now, job)
        answers, notices = self._usable(gathered, ("u00", "v00"), now, departure)
        series = {index: kept.series for index, kept in answers.items()}
        numbers = _members_of(list(series.values()))
        names = [f"{part}{number}" for number in numbers for part in "uv"]
        time = common_times(SERVICE, list(series.values()), names, max_gap_h=MAX_GAP_H)
        every = np.stack([onto_grid(plan, series, name, time) for name in names])
        u, v = every[0::2], every[1::2]
        mean_u, mean_v = u.mean(axis=0), v.mean(axis=0)
        source = f"{SERVICE} ensemble (ECMWF, mean of {len(numbers)} members)"
        forecast = _describe(source, plan, time, answers, [*notices, TERMS])
        members = tuple(
            Wind(
                time=time,
                lat=plan.lat,
                lon=plan.lon,
                u=u[at],
                v=v[at],
                forecast=replace(forecast, source=f"{SERVICE} ensemble (ECMWF, member {number})"),
            )
            for at, number in enumerate(numbers)
        )
        return Wind(
            time=time,
            lat=plan.lat,
            lon=plan.lon,
            u=mean_u,
            v=mean_v,
            spread=np.sqrt(((u - mean_u) ** 2 + (v - mean_v) ** 2).mean(axis=0)),
            members=members,
            forecast=forecast,
        )

    def _gather(self, endpoint: Endpoint, plan: PointPlan, now: datetime) -> _Gathered:
        gathered = _Gathered(endpoint, plan, fresh={}, stale={}, errors=[])
        for index, kept in self._shelf.recall(_service(endpoint), plan.places).items():
            # an answer from the future is a clock that was set back, and as good as new
            is_fresh = now.timestamp() < kept.expires
            (gathered.fresh if is_fresh else gathered.stale)[index] = kept
        return gathered

    def _fetch(self, wanted: list[_Gathered], now: datetime, job: Job) -> None:
        """Ask for what is missing; errors are kept beside the answers."""
        tasks = [request for gathered in wanted for request in gathered.requests()]
        if not tasks:
            job.report("wind", 1.0, f"{SERVICE}: no request needed, the answers kept are new enough")
            return
        places = sum(len(indices) for _, indices in tasks)
        job.report("wind", 0.0, f"{SERVICE}: {len(tasks)} requests for {places} places")
        try:
            require_name(
                SERVICE, tasks[0][0].endpoint.url(self._settings), self.config.name_s, check=job.check
            )
        except WeatherError as error:
            tasks[0][0].errors.append(error)
            return

        def on_done(done: int, position: int, outcome: Outcome[list[Series]]) -> bool:
            gathered, indices = tasks[position]
            job.report("wind", done / len(tasks), f"wind {done} of {len(tasks)}")
            if outcome.value is not None:
                fetched = now.timestamp()
                entries = [Kept(one, fetched, self._expiry(gathered, fetched)) for one in outcome.value]
                gathered.fresh.update(zip(indices, entries, strict=True))
                self._shelf.keep(_service(gathered.endpoint), entries)
            elif outcome.error is not None:
                gathered.errors.append(outcome.error)
                return gathered is not wanted[0] or outcome.error.reason not in _STOPPING
            return True

        sessions = Sessions()
        try:
            run_all(
                tasks,
                lambda task, stop: self._ask(sessions, *task, now, stop),
                job=job,
                parallel=self.config.parallel,
                each_s=self.config.limits.total_s,
                batch_s=self.config.batch_s,
                on_done=on_done,
                late=lambda: timed_out(SERVICE, self.config.limits.total_s),
            )
        finally:
            sessions.close()
        if self._shelf.trouble:
            job.report("wind", None, f"Forecasts are not kept. {self._shelf.trouble}")

    def _ask(
        self,
        sessions: Sessions,
        gathered: _Gathered,
        indices: list[int],
        now: datetime,
        stop: threading.Event,
    ) -> list[Series]:
        """Send one request for some of a plan's places."""
        endpoint, limits = gathered.endpoint, self.config.limits
        if endpoint is MARINE:
            limits = replace(limits, total_s=min(limits.total_s, self.config.sea_s), tries=1)
        asked = Asked(tuple(gathered.plan.places[index] for index in indices), now.timestamp())
        url = endpoint.url(self._settings)
        with sessions.one(stop) as session:
            return ask(session, url, endpoint, asked, limits=limits, stop=stop)

    def _expiry(self, gathered: _Gathered, fetched: float) -> float:
        cycle = self.config.ensemble_cycle_s if gathered.endpoint is ENSEMBLE else self.config.cycle_s
        return max((fetched // cycle + 1) * cycle, fetched + LEAST_KEPT_S)

    def _usable(
        self, gathered: _Gathered, names: tuple[str, ...], now: datetime, departure: datetime | None
    ) -> tuple[dict[int, Kept], list[str]]:
        """Choose the answers to use: the new ones when there are enough, else old ones with them."""
        needed = (departure or now).timestamp()
        total = gathered.plan.rows.size
        enough = max(1, math.ceil(self.config.enough * total))
        fresh = {index: kept for index, kept in gathered.fresh.items() if has(kept.series, names)}
        old = {
            index: kept
            for index, kept in gathered.stale.items()
            if index not in fresh and has(kept.series, names) and kept.series.time[-1] > needed
        }
        error = gathered.errors[-1] if gathered.errors else None
        answers = fresh if len(fresh) >= enough else {**old, **fresh}
        if len(answers) < enough:
            raise error or WeatherError(f"{SERVICE} has no wind for this area; choose another forecast.")
        series = {index: kept.series for index, kept in answers.items()}
        last = lasting(series, names, max_gap_h=MAX_GAP_H, least=enough)
        notices = []
        if answers is not fresh:
            age_h = (now.timestamp() - min(kept.fetched for kept in answers.values())) / 3600.0
            notices.append(f"The wind is from an answer {age_h:.0f} h old.")
        if len(last) < total:
            notices.append(f"{len(last)} of {total} places have an answer; the rest is filled in.")
        chosen = {index: kept for index, kept in answers.items() if index in last}
        return chosen, notices + ([str(error)] if error else [])

    def _sea(self, sea: _Gathered, time: Array, now: datetime) -> tuple[Grid | None, Current | None, str]:
        """Make waves on the wind's hours and a current on its own; the sentence says what is missing."""
        answers = {**sea.stale, **sea.fresh}
        series = {index: kept.series for index, kept in answers.items() if kept.series.time[-1] > time[0]}
        waves = {index: one for index, one in series.items() if has(one, ("wave",))}
        currents = {index: one for index, one in series.items() if has(one, _CURRENT)}
        parts = []
        wave, current = None, None
        if waves:
            wave = from_nearest(sea.plan, waves, "wave", time)
            until = min(one.valid(("wave",), np.inf)[-1] for one in waves.values())
            if until < time[-1]:
                parts.append(f"Waves are known until {format_moment(until)}; the last ones are held.")
        if currents:
            hours = np.unique(np.concatenate([one.valid(_CURRENT, np.inf) for one in currents.values()]))
            flow = [from_nearest(sea.plan, currents, name, hours) for name in _CURRENT]
            about = _describe(f"{SERVICE} marine", sea.plan, hours, answers, [TERMS])
            current = Current(
                time=hours, lat=sea.plan.lat, lon=sea.plan.lon, u=flow[0], v=flow[1], forecast=about
            )
        missing = [name for name, got in (("waves", wave), ("current", current)) if got is None]
        if missing:
            parts.append(f"There are no {' and '.join(missing)} with it.")
        parts += [str(error) for error in sea.errors[-1:]]
        oldest = min((sea.stale[index].fetched for index in series if index not in sea.fresh), default=None)
        if oldest is not None:
            parts.append(f"Waves and current are from {(now.timestamp() - oldest) / 3600.0:.0f} h ago.")
        return wave, current, " ".join(parts)


def _service(endpoint: Endpoint) -> str:
    """Name under which an endpoint's answers are kept."""
    return " ".join(filter(None, ["open-meteo", endpoint.name, endpoint.params.get("models")]))


def _at_sea(plan: PointPlan, is_water: IsWater | None) -> PointPlan:
    """Keep the places of a plan that are water."""
    if is_water is None:
        return plan
    asked = np.asarray(is_water(plan.lat[plan.rows], plan.lon[plan.columns]), dtype=np.bool_)
    return PointPlan(lat=plan.lat, lon=plan.lon, rows=plan.rows[asked], columns=plan.columns[asked])


def _members_of(series: list[Series]) -> list[str]:
    """Numbers of the members that every place has.

    Raises
    ------
    WeatherError
        ``bad-response`` when there are less than two.
    """
    numbers = [
        {name[1:] for name in one.values if name[0] == "u" and has(one, (name, f"v{name[1:]}"))}
        for one in series
    ]
    common = sorted(set.intersection(*numbers))
    if len(common) < 2:
        raise WeatherError(f"{SERVICE} sent no ensemble: members are missing; choose another forecast.")
    return common


def _describe(
    source: str, plan: PointPlan, time: Array, answers: Mapping[int, Kept], notices: list[str]
) -> Forecast:
    valid_from, valid_to, step_h, resolution = describe_grid(time, plan.lat, plan.lon)
    return Forecast(
        source=source,
        issued=datetime.fromtimestamp(min(kept.fetched for kept in answers.values()), UTC),
        valid_from=valid_from,
        valid_to=valid_to,
        step_h=step_h,
        resolution_deg=resolution,
        notice=" ".join(filter(None, notices)),
    )
