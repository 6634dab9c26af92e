"""One way to the wind: whatever it is from, it is asked for here and comes as one `Wind`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

import numpy as np

from seacruise.errors import InputError, WeatherError
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.weather.cache import Memory, Quota
from seacruise.weather.grids import Place, passage_box
from seacruise.weather.isolated import read_isolated
from seacruise.weather.points import IsWater
from seacruise.weather.practice import practice_wind
from seacruise.weather.sample import VALID_FROM, VALID_TO, sample_wind
from seacruise.weather.wind import Wind, require_cover

SERVICE_MARGIN_DEG: Final = 0.75
"""Room around a passage that a service is asked for [degrees]: every request counts."""

_NAMES: Final = ("auto", "practice", "sample", "stormglass")
_OFFER: Final = "choose auto, practice, sample, stormglass, or give the path of a GRIB or NetCDF file"


def fetch_wind(
    names: Sequence[str],
    *,
    start: Place,
    end: Place,
    departure: datetime | None,
    settings: Settings,
    job: Job,
    is_water: IsWater | None = None,
    now: datetime | None = None,
    margin_deg: float | None = None,
) -> Wind:
    """Get the wind for a passage.

    Parameters
    ----------
    names
        One of ``"auto"``, ``"practice"``, ``"sample"`` and ``"stormglass"``, or paths of files, the mean
        of which is taken. ``"auto"`` is Storm Glass with a key, else practice weather; it is reported
        which, and why.
    start, end
        Latitude and longitude [degrees]; the wind must cover both.
    departure
        Timezone-aware, or ``None`` for now; a service is not asked about a day it does not forecast.
    is_water
        Tells for arrays of latitudes and longitudes which are water, so that no request is spent on land.
    margin_deg
        Room around start and end for which wind is wanted [degrees of latitude], where a passage between
        them is not all that is asked; files are then kept whole.

    Raises
    ------
    InputError
        A name or a file that cannot be used.
    WeatherError
        The service failed; its ``reason`` says how.
    NoPassageError
        ``outside-forecast``: the wind does not cover start, end or departure.
    CancelledError
    """
    now = now or datetime.now(UTC)
    kind = _kind(names)
    if kind == "auto":
        kind = "stormglass" if settings.stormglass_key else "practice"
        why = "a key is set" if settings.stormglass_key else "STORMGLASS_API_KEY is not set"
        chosen = "Storm Glass" if settings.stormglass_key else "practice weather"
        job.report("wind", None, f"Wind from {chosen}, because {why}")
    job.check()
    if kind == "files":
        around = (start, end) if margin_deg is None else ()
        wind = _mean([_read(name, around, job) for name in names])
        require_cover(wind.forecast.source, (wind.lat, wind.lon), (start, end))
        return wind
    if kind == "stormglass":
        # loading the HTTP library takes 0.1 s, which other sources need not pay
        from seacruise.weather.stormglass import StormGlass

        box = passage_box((start, end), SERVICE_MARGIN_DEG if margin_deg is None else margin_deg)
        return StormGlass(settings).wind(box, departure=departure, now=now, job=job, is_water=is_water)
    wind = practice_wind(now) if kind == "practice" else sample_wind()
    require_cover(wind.forecast.source, (wind.lat, wind.lon), (start, end))
    return wind


def horizon(
    names: Sequence[str], settings: Settings, now: datetime | None = None
) -> tuple[datetime, datetime]:
    """Tell the first and last time that can be asked for, without fetching anything; files are opened.

    Raises
    ------
    InputError
        A name or a file that cannot be used.
    """
    now = now or datetime.now(UTC)
    kind = _kind(names)
    if kind == "auto":
        kind = "stormglass" if settings.stormglass_key else "practice"
    if kind == "stormglass":
        from seacruise.weather.stormglass import horizon_of

        return horizon_of(now)
    if kind == "sample":
        return VALID_FROM, VALID_TO
    forecasts = (
        [practice_wind(now).forecast]
        if kind == "practice"
        else [read_isolated(Path(name), job=Job()).forecast for name in names]
    )
    return max(one.valid_from for one in forecasts), min(one.valid_to for one in forecasts)


@dataclass(frozen=True, slots=True)
class SourceInfo:
    """A source of wind: its name, whether it can be used now, and what to know about it."""

    name: str
    usable: bool
    remark: str


@dataclass(frozen=True, slots=True)
class CachedInfo:
    """An answer in the cache: of which service, for which place ``"lat,lon"``, and its age [h]."""

    service: str
    place: str
    age_h: float


@dataclass(frozen=True, slots=True)
class WeatherInfo:
    """What ``seacruise weather info`` tells.

    Attributes
    ----------
    quota
        Storm Glass requests of today; ``None`` without a key.
    database, database_bytes
        The file with the cache, and its size; 0 when it does not exist yet.
    trouble
        Why nothing is kept, or empty.
    """

    sources: tuple[SourceInfo, ...]
    quota: Quota | None
    cached: tuple[CachedInfo, ...]
    database: Path
    database_bytes: int
    trouble: str


def weather_info(settings: Settings, now: datetime | None = None) -> WeatherInfo:
    """Look at what can be used and what is kept; nothing is sent."""
    from seacruise.weather.stormglass_client import check_key

    now = now or datetime.now(UTC)
    try:
        size = settings.database.stat().st_size
    except OSError:
        size = 0
    memory = Memory(settings.database)
    quota: Quota | None = None
    try:
        quota = memory.quota(check_key(settings), now)
        told = "as far as known" if not quota.known else "by the service's own count"
        stormglass = SourceInfo(
            "stormglass", True, f"{quota.left} of {quota.daily} requests left today, {told}"
        )
    except WeatherError as error:
        stormglass = SourceInfo("stormglass", False, str(error))
    sources = (
        stormglass,
        SourceInfo("practice", True, "a generated week from today; not a forecast"),
        SourceInfo("sample", True, f"real analyses, {VALID_FROM:%d %b %Y} to {VALID_TO:%d %b %Y}"),
        SourceInfo("file", True, "GRIB 1, GRIB 2 or CF NetCDF"),
    )
    cached = tuple(CachedInfo(*one) for one in memory.ages(now))
    return WeatherInfo(sources, quota, cached, settings.database, size, memory.trouble)


def _kind(names: Sequence[str]) -> str:
    """Sort names into one of the known sources, or ``"files"``."""
    if not names:
        raise InputError(f"No forecast was named; {_OFFER}.")
    known = [name for name in names if name.lower() in _NAMES]
    if known:
        if len(names) > 1:
            raise InputError(
                f"The forecast {known[0]} cannot be averaged with others; give it alone, or only files."
            )
        return known[0].lower()
    for name in names:
        if name.lower() == "open-meteo":
            raise InputError(f"Open-Meteo is not available in this version; {_OFFER}.")
        if not Path(name).is_file():
            raise InputError(f"There is no forecast or file {name!r}; {_OFFER}.")
    return "files"


def _read(name: str, around: tuple[Place, ...], job: Job) -> Wind:
    job.report("wind", None, f"Reading {Path(name).name}")
    return read_isolated(Path(name), around=around, job=job)


def _mean(winds: Sequence[Wind]) -> Wind:
    """Average the components of winds that share grid and times.

    Raises
    ------
    InputError
        When they do not.
    """
    first = winds[0]
    if len(winds) == 1:
        return first
    for other in winds[1:]:
        axes = ((first.time, other.time), (first.lat, other.lat), (first.lon, other.lon))
        if not all(
            one.shape == two.shape and np.allclose(one, two, rtol=0.0, atol=1e-4) for one, two in axes
        ):
            raise InputError(
                f"{first.forecast.source} and {other.forecast.source} have different grids or times and "
                "cannot be averaged; give one of them."
            )
    names = ", ".join(one.forecast.source.removeprefix("File ") for one in winds)
    notices = dict.fromkeys(one.forecast.notice for one in winds if one.forecast.notice)
    return Wind(
        time=first.time,
        lat=first.lat,
        lon=first.lon,
        u=np.mean([one.u for one in winds], axis=0),
        v=np.mean([one.v for one in winds], axis=0),
        forecast=replace(first.forecast, source=f"Mean of {names}", notice=" ".join(notices)),
    )
