"""One way to the wind: whatever it is from, it is asked for here and comes as one `Wind`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Final

from seacruise.errors import InputError, WeatherError
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.weather.blend import shares
from seacruise.weather.currents import with_current
from seacruise.weather.grids import Place, passage_box
from seacruise.weather.isolated import read_current_isolated, read_isolated
from seacruise.weather.practice import practice_wind
from seacruise.weather.sample import VALID_FROM, VALID_TO, sample_wind
from seacruise.weather.several import mean_of
from seacruise.weather.wind import Wind, require_cover

if TYPE_CHECKING:
    from seacruise.weather.cache import Memory, Quota
    from seacruise.weather.points import IsWater

SERVICE_MARGIN_DEG: Final = 0.75
"""Room around a passage that a service is asked for [degrees]: every request counts."""

NAMES: Final = ("auto", "stormglass", "open-meteo", "open-meteo-ensemble", "metno", "practice", "sample")
_ALONE: Final = frozenset({"auto", "practice", "sample", "open-meteo-ensemble"})
_OFFER: Final = f"choose {', '.join(NAMES)}, or give the path of a GRIB or NetCDF file"


@dataclass(frozen=True, slots=True)
class _Ask:
    """What is asked of every source alike; the fields are those of `fetch_wind`."""

    start: Place
    end: Place
    departure: datetime | None
    settings: Settings
    job: Job
    is_water: IsWater | None
    now: datetime
    margin_deg: float | None

    @property
    def box(self) -> tuple[float, float, float, float]:
        """Area that a service is asked for: south, west, north, east [degrees]."""
        margin = SERVICE_MARGIN_DEG if self.margin_deg is None else self.margin_deg
        return passage_box((self.start, self.end), margin)


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
    weights: Sequence[float] | None = None,
    current: Path | None = None,
) -> Wind:
    """Get the wind for a passage.

    Parameters
    ----------
    names
        One of `NAMES`, or services and paths of files, the mean of which is taken, without the services
        that fail. ``"auto"`` is Storm Glass with a key, else Open-Meteo, else practice weather; it is
        reported which, and why.
    start, end
        Latitude and longitude [degrees]; the wind must cover both.
    departure
        Timezone-aware, or ``None`` for now; a service is not asked about a day it does not forecast.
    is_water
        Tells for arrays of latitudes and longitudes which are water, so that no request is spent on land.
    margin_deg
        Room around start and end for which wind is wanted [degrees of latitude], where a passage between
        them is not all that is asked; files are then kept whole.
    weights
        One for each name, in the mean; equal by default.
    current
        GRIB or NetCDF file with the current to reckon with, instead of one that comes with the wind.

    Raises
    ------
    InputError
        A name or a file that cannot be used, forecasts with nothing in common, or a weight that is none.
    WeatherError
        The service failed; its ``reason`` says how.
    NoPassageError
        ``outside-forecast``: the wind does not cover start, end or departure.
    CancelledError
    """
    kinds = _kinds(names)
    if {"auto", "stormglass"} & set(kinds):
        settings = settings.with_key()
    ask = _Ask(start, end, departure, settings, job, is_water, now or datetime.now(UTC), margin_deg)
    # a mistake in what is at hand must not cost requests
    shares(len(kinds), weights)
    around = (start, end) if margin_deg is None else ()
    water = None if current is None else read_current_isolated(current, around=around, job=job)

    def get(name: str) -> Wind:
        job.check()
        return _fetch(_kind(name.lower()), name, ask)

    wind = mean_of(names, get, weights=weights, say=lambda text: job.report("wind", None, text))
    require_cover(wind.forecast.source, (wind.lat, wind.lon), (start, end))
    return wind if water is None else with_current(wind, water)


def _fetch(kind: str, name: str, ask: _Ask) -> Wind:
    """Get the wind from one source."""
    if kind == "auto":
        return _automatic(ask)
    if kind == "file":
        ask.job.report("wind", None, f"Reading {Path(name).name}")
        around = (ask.start, ask.end) if ask.margin_deg is None else ()
        return read_isolated(Path(name), around=around, job=ask.job)
    if kind == "practice":
        return practice_wind(ask.now)
    if kind == "sample":
        return sample_wind()
    # loading the HTTP library takes 0.1 s, which other sources need not pay
    if kind == "stormglass":
        from seacruise.weather.stormglass import StormGlass, config_named

        ends = (ask.start, ask.end) if ask.margin_deg is None else None
        return StormGlass(ask.settings, config_named(name)).wind(
            ask.box, departure=ask.departure, now=ask.now, job=ask.job, is_water=ask.is_water, ends=ends
        )
    if kind == "metno":
        from seacruise.weather.metno import MetNo

        return MetNo(ask.settings).wind(
            ask.box, departure=ask.departure, now=ask.now, job=ask.job, is_water=ask.is_water
        )
    from seacruise.weather.openmeteo import OpenMeteo

    service = OpenMeteo(ask.settings)
    if kind == "open-meteo-ensemble":
        return service.ensemble(ask.box, departure=ask.departure, now=ask.now, job=ask.job)
    return service.wind(ask.box, departure=ask.departure, now=ask.now, job=ask.job, is_water=ask.is_water)


def _automatic(ask: _Ask) -> Wind:
    """Choose for the sailor: Storm Glass with a key, else Open-Meteo, else practice weather.

    Practice weather only stands in where it is of use: for a passage and a departure that it covers.
    """
    if ask.settings.stormglass_key:
        ask.job.report("wind", None, "Wind from Storm Glass, because a key is set")
        return _fetch("stormglass", "stormglass", ask)
    ask.job.report("wind", None, "Wind from Open-Meteo, because no Storm Glass key is set")
    try:
        return _fetch("open-meteo", "open-meteo", ask)
    except WeatherError as error:
        wind = practice_wind(ask.now)
        until = wind.forecast.valid_to
        if not wind.covers(*zip(ask.start, ask.end, strict=True)).all() or (ask.departure or ask.now) > until:
            raise
        # the rest of the sentence is advice for those who asked for Open-Meteo by name
        clause = str(error).split(";", maxsplit=1)[0].rstrip(".")
        why = f"It stands in because no Storm Glass key is set and Open-Meteo failed ({clause})."
    ask.job.report("wind", None, f"Practice weather, not a forecast. {why}")
    return replace(wind, forecast=replace(wind.forecast, notice=f"{wind.forecast.notice} {why}"))


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
    spans = [_horizon(kind, name, settings, now) for kind, name in zip(_kinds(names), names, strict=True)]
    return max(begin for begin, _ in spans), min(end for _, end in spans)


def _horizon(kind: str, name: str, settings: Settings, now: datetime) -> tuple[datetime, datetime]:
    if kind == "auto":
        kind = "stormglass" if settings.with_key().stormglass_key else "open-meteo"
    if kind == "sample":
        return VALID_FROM, VALID_TO
    if kind in ("practice", "file"):
        wind = practice_wind(now) if kind == "practice" else read_isolated(Path(name), job=Job())
        return wind.forecast.valid_from, wind.forecast.valid_to
    if kind == "stormglass":
        from seacruise.weather.stormglass import horizon_of
    elif kind == "metno":
        from seacruise.weather.metno import horizon_of
    else:
        from seacruise.weather.openmeteo import horizon_of
    return horizon_of(now)


@dataclass(frozen=True, slots=True)
class SourceInfo:
    """A source of wind.

    Attributes
    ----------
    usable, remark
        Whether it can be used now; why not, or what to know about it.
    terms
        What its owner asks of those who use it, or empty.
    """

    name: str
    usable: bool
    remark: str
    terms: str = ""


@dataclass(frozen=True, slots=True)
class CachedInfo:
    """Answers in the cache: of which service, for which place ``"lat,lon"`` or how many, their age [h]."""

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
    from seacruise.weather import metno, openmeteo
    from seacruise.weather.cache import Memory
    from seacruise.weather.shelf import Shelf

    now, settings = now or datetime.now(UTC), settings.with_key()
    try:
        size = settings.database.stat().st_size
    except OSError:
        size = 0
    memory, shelf = Memory(settings.database), Shelf(settings.database)
    stormglass, quota = _stormglass_info(settings, memory, now)
    automatic = (
        "Storm Glass, because a key is set"
        if settings.stormglass_key
        else "Open-Meteo, because no Storm Glass key is set; practice weather when that fails"
    )
    sources = (
        SourceInfo("auto", True, automatic),
        stormglass,
        SourceInfo(
            "open-meteo",
            True,
            "no key needed; ten days of wind, gusts, waves and current",
            openmeteo.TERMS,
        ),
        SourceInfo(
            "open-meteo-ensemble", True, "no key needed; ten days, 51 members of ECMWF", openmeteo.TERMS
        ),
        SourceInfo("metno", True, _metno_remark(settings), metno.TERMS),
        SourceInfo("practice", True, "a generated week from today; not a forecast"),
        SourceInfo("sample", True, f"real analyses, {VALID_FROM:%d %b %Y} to {VALID_TO:%d %b %Y}"),
        SourceInfo("file", True, "GRIB 1, GRIB 2 or CF NetCDF"),
    )
    cached = tuple(CachedInfo(*one) for one in (*memory.ages(now), *shelf.ages(now)))
    trouble = memory.trouble or shelf.trouble
    return WeatherInfo(sources, quota, cached, settings.database, size, trouble)


def _stormglass_info(settings: Settings, memory: Memory, now: datetime) -> tuple[SourceInfo, Quota | None]:
    from seacruise.weather.stormglass import StormGlassConfig
    from seacruise.weather.stormglass_client import check_key

    try:
        quota = memory.quota(check_key(settings), now)
    except WeatherError as error:
        return SourceInfo("stormglass", False, str(error)), None
    told = "as far as known" if not quota.known else "by the service's own count"
    most = StormGlassConfig().places(quota)
    remark = f"{quota.left} of {quota.daily} requests left today, {told}; a passage takes up to {most}"
    return SourceInfo("stormglass", True, remark), quota


def _metno_remark(settings: Settings) -> str:
    remark = "no key needed; nine days of wind and gusts"
    if settings.contact:
        return remark
    # its terms of service: without a way to reach those who ask "you risk being blocked without warning"
    return f"{remark}; it wants a contact of those who ask: set SEACRUISE_CONTACT to your e-mail or site"


def _kind(name: str) -> str:
    """Sort a name in lower case: a source's models may follow it, as in ``stormglass:ecmwf+noaa``."""
    if name.startswith("stormglass:"):
        return "stormglass"
    return name if name in NAMES else "file"


def _kinds(names: Sequence[str]) -> list[str]:
    """Sort names into the known sources and ``"file"``."""
    if not names:
        raise InputError(f"No forecast was named; {_OFFER}.")
    kinds = [_kind(name.lower()) for name in names]
    alone = [kind for kind in kinds if kind in _ALONE]
    if alone and len(names) > 1:
        raise InputError(
            f"The forecast {alone[0]} cannot be averaged with others; give it alone, or only services and "
            "files."
        )
    for name, kind in zip(names, kinds, strict=True):
        if kind == "file" and not Path(name).is_file():
            raise InputError(f"There is no forecast or file {name!r}; {_OFFER}.")
    return kinds
