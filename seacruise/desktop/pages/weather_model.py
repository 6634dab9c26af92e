"""What the weather page knows, without Qt: sources, what is kept of them, the key, dropped files."""

from __future__ import annotations

from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Final, Literal

from seacruise.errors import InputError, NoPassageError, WeatherError
from seacruise.keychain import STORM_GLASS, shortened

if TYPE_CHECKING:
    from collections.abc import Sequence

    from seacruise.progress import Job
    from seacruise.settings import Settings
    from seacruise.weather.cache import Quota
    from seacruise.weather.source import CachedInfo

GIVES: Final[dict[str, tuple[str, ...]]] = {
    "stormglass": ("wind", "gusts", "waves", "current"),
    "open-meteo": ("wind", "gusts", "waves", "current"),
    "open-meteo-ensemble": ("wind", "members"),
    "metno": ("wind", "gusts"),
    "practice": ("wind",),
    "sample": ("wind",),
}
"""What each source brings; automatic is one of them, and a file has what is in it."""

SERVICES: Final = ("stormglass", "open-meteo", "metno")
"""Those of which a mean can be made, with each other and with files."""

ONLINE: Final = frozenset({"auto", "stormglass", "open-meteo", "open-meteo-ensemble", "metno"})

HOMEPAGES: Final = {
    "stormglass": "https://stormglass.io",
    "open-meteo": "https://open-meteo.com",
    "open-meteo-ensemble": "https://open-meteo.com",
    "metno": "https://www.met.no",
}

OWN_TERMS: Final = {
    "stormglass": "Used under your own contract with Storm Glass.",
    "sample": "GFS analyses of NOAA, public domain.",
}
"""Where the source itself tells no terms."""

# How the cache calls what a source sent.
_KEPT_AS: Final = {
    "stormglass": ("stormglass ",),
    "open-meteo": ("open-meteo wind", "open-meteo sea"),
    "open-meteo-ensemble": ("open-meteo ensemble",),
    "metno": ("metno",),
}

KeyPlace = Literal["", "environment", "keychain", "session"]


@dataclass(frozen=True, slots=True)
class Kept:
    """Answers of a source in the cache: how many places, and the age of the youngest [h]."""

    places: int
    age_h: float


@dataclass(frozen=True, slots=True)
class Source:
    """A source as the page shows it.

    Attributes
    ----------
    remark
        What to know about it, or why it cannot be used.
    kept
        What the cache has of it; ``None`` for nothing.
    """

    name: str
    usable: bool
    remark: str
    terms: str
    gives: tuple[str, ...]
    kept: Kept | None = None


@dataclass(frozen=True, slots=True)
class KeyState:
    """Where the Storm Glass key is from.

    Attributes
    ----------
    place
        Empty where there is none.
    shown
        As much of it as is ever shown.
    can_last
        Whether the system has a keychain that could keep one.
    """

    place: KeyPlace = ""
    shown: str = ""
    can_last: bool = False


@dataclass(frozen=True, slots=True)
class WeatherState:
    """All that the page shows, as it was looked up."""

    sources: tuple[Source, ...]
    key: KeyState
    quota: Quota | None = None
    trouble: str = ""


@dataclass(frozen=True, slots=True)
class FileInfo:
    """What a weather file covers.

    Attributes
    ----------
    brings
        What it has besides the wind.
    step_h, resolution_deg
        Usual step in time [h] and in space [degrees].
    """

    path: Path
    area: str
    first: datetime
    last: datetime
    step_h: float
    resolution_deg: float
    issued: datetime | None
    brings: tuple[str, ...]
    notice: str


def load_state(settings: Settings, now: datetime) -> WeatherState:
    """Look up sources, cache, quota and key; nothing is sent. The system may ask to unlock its keychain."""
    from seacruise.weather.source import weather_info

    info = weather_info(settings, now)
    sources = tuple(
        Source(
            name=one.name,
            usable=one.usable,
            remark=one.remark,
            terms=one.terms or OWN_TERMS.get(one.name, ""),
            gives=GIVES.get(one.name, ()),
            kept=kept_of(one.name, info.cached),
        )
        for one in info.sources
        if one.name != "file"
    )
    return WeatherState(sources, key_state(settings), info.quota, info.trouble)


def kept_of(name: str, cached: Sequence[CachedInfo]) -> Kept | None:
    """Add up what the cache has of a source."""
    prefixes = _KEPT_AS.get(name, ())
    found = [one for one in cached if prefixes and one.service.startswith(prefixes)]
    if not found:
        return None
    # One line a place, or one a service that says how many places there are.
    counts: dict[str, int] = {}
    for one in found:
        words = one.place.split()
        counts[one.service] = counts.get(one.service, 0) + (int(words[0]) if len(words) == 2 else 1)
    return Kept(max(counts.values()), max(0.0, min(one.age_h for one in found)))


def key_state(settings: Settings) -> KeyState:
    """Look where the key is from; its last four characters are all that anyone sees."""
    keys = settings.keys
    can_last = keys is not None and keys.has_vault
    if settings.stormglass_key:
        return KeyState("environment", shortened(settings.stormglass_key), can_last)
    kept = None if keys is None else keys.get(STORM_GLASS)
    if keys is None or not kept:
        return KeyState(can_last=can_last)
    return KeyState("keychain" if keys.is_lasting(STORM_GLASS) else "session", shortened(kept), can_last)


def keep_key(settings: Settings, text: str) -> KeyState:
    """Take a key over.

    Raises
    ------
    InputError
        It has characters that no key has.
    """
    from seacruise.weather.stormglass_client import check_key

    try:
        key = check_key(replace(settings, stormglass_key=text.strip()))
    except WeatherError:
        raise InputError(
            "This is no key: it is empty or has characters that no key has; copy it again without spaces.",
            reason="bad-key",
        ) from None
    assert settings.keys is not None
    settings.keys.put(STORM_GLASS, key)
    return key_state(settings)


def remove_key(settings: Settings) -> KeyState:
    """Forget the key.

    Raises
    ------
    InputError
        The system's keychain keeps it.
    """
    assert settings.keys is not None
    if not settings.keys.remove(STORM_GLASS):
        raise InputError(
            "The system's keychain would not let go of the key; it is unused until SeaCruise starts again. "
            "Remove the entry 'seacruise' with the system's own program."
        )
    return key_state(settings)


def ask_with_key(settings: Settings, job: Job) -> Quota:
    """Send one request with the key that is in use.

    Raises
    ------
    WeatherError
        Why it failed.
    """
    from seacruise.weather.keytest import try_key

    return try_key(settings.with_key(), now=datetime.now(UTC), job=job)


def look_into(path: Path, job: Job, around: Sequence[tuple[float, float]] = ()) -> FileInfo:
    """Read a weather file, in a process of its own, and say what it covers.

    Parameters
    ----------
    around
        Ends of the passage that is asked for [degrees]. A file that has gaps elsewhere may do for it.

    Raises
    ------
    InputError
        It is none, or damaged.
    """
    from seacruise.weather.contents import carried
    from seacruise.weather.isolated import read_isolated

    try:
        wind = read_isolated(path, job=job)
    except InputError as whole:
        if len(around) < 2:
            raise
        try:
            wind = read_isolated(path, around=around, job=job)
        except (InputError, NoPassageError):
            raise whole from None
    forecast = wind.forecast
    return FileInfo(
        path=path,
        area=wind.describe_area(),
        first=forecast.valid_from,
        last=forecast.valid_to,
        step_h=forecast.step_h,
        resolution_deg=forecast.resolution_deg,
        issued=forecast.issued,
        brings=tuple(carried(wind)),
        notice=forecast.notice,
    )


@dataclass(frozen=True, slots=True)
class Mix:
    """Forecasts that are to be averaged, with their weights."""

    parts: tuple[tuple[str, float], ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """Names as on the command line."""
        return tuple(name for name, _ in self.parts)

    @property
    def weights(self) -> tuple[float, ...]:
        """Weights, in that order; empty where all are alike."""
        given = tuple(weight for _, weight in self.parts)
        return () if len(set(given)) <= 1 else given

    @property
    def is_mean(self) -> bool:
        """Whether there are enough of them."""
        return len(self.parts) > 1

    def shares(self) -> tuple[float, ...]:
        """Part of each in the mean, 1 in all."""
        total = sum(weight for _, weight in self.parts)
        return tuple(weight / total for _, weight in self.parts)
