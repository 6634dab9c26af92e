"""What Storm Glass sends, checked once at the edge and brought to our own names."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any, Final

import msgspec
import numpy as np

from seacruise.errors import WeatherError
from seacruise.weather.cache import PointAnswer
from seacruise.weather.wind import MAX_SPEED

MAX_GAP_H: Final = 6.0
"""A longer hole between two hours is not bridged; the forecast ends before it [h]."""

MIN_HOURS: Final = 24.0
"""An answer that reaches less far is no forecast [h]."""

MAX_ECHO_DEG: Final = 0.6
"""How far the place of an answer may lie from the place asked, half a cell of a 1-degree model [degrees]."""

_MODEL_NAME: Final = re.compile(r"[A-Za-z0-9:_.-]{1,24}")
"""New models appear without notice, with a colon in some names; what else is sent is not shown to anyone."""

_Values = Mapping[str, float | None]


class _Hour(msgspec.Struct):
    time: datetime
    windSpeed: _Values = {}  # noqa: N815 (the service's own name)
    windDirection: _Values = {}  # noqa: N815


class _Body(msgspec.Struct):
    hours: list[_Hour]
    meta: msgspec.Raw = msgspec.Raw(b"")


_DECODER: Final = msgspec.json.Decoder(_Body)


@dataclass(frozen=True, slots=True)
class Meta:
    """What an answer says about itself, as far as it says it."""

    used: int | None = None
    daily: int | None = None
    spent: bool = False
    lat: float | None = None
    lon: float | None = None


@dataclass(frozen=True, slots=True)
class DecodedAnswer:
    """A body of the right shape; `to_point` tells whether it holds a forecast."""

    hours: tuple[_Hour, ...]
    meta: Meta


def decode_answer(body: bytes) -> DecodedAnswer:
    """Decode a body of Storm Glass.

    Raises
    ------
    msgspec.DecodeError
        When it is not JSON, or not of the service's shape (`msgspec.ValidationError`). NaN and Infinity
        are not JSON.
    """
    decoded = _DECODER.decode(body)
    return DecodedAnswer(hours=tuple(decoded.hours), meta=_meta(bytes(decoded.meta)))


def decode_meta(body: bytes) -> Meta:
    """Read the quota out of any body, an error's too; what is missing or odd stays ``None``."""
    try:
        document = msgspec.json.decode(body)
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError):
        return Meta()
    return _meta(msgspec.json.encode(document.get("meta"))) if isinstance(document, dict) else Meta()


def _meta(raw: bytes) -> Meta:
    try:
        meta: Any = msgspec.json.decode(raw) if raw else None
    except msgspec.DecodeError:
        return Meta()
    if not isinstance(meta, dict):
        return Meta()

    def count(name: str) -> int | None:
        value = meta.get(name)
        return value if type(value) is int and 0 <= value < 10**9 else None

    def degrees(name: str) -> float | None:
        value = meta.get(name)
        return float(value) if isinstance(value, (int, float)) else None

    return Meta(used=count("requestCount"), daily=count("dailyQuota"), lat=degrees("lat"), lon=degrees("lng"))


def to_point(
    answer: DecodedAnswer, *, place: tuple[float, float], window: tuple[float, float], source: str
) -> PointAnswer:
    """Make a forecast of one place of an answer.

    Speed and direction of an hour are from one model: the wanted source where it has both, else the next
    one that has, and the notes say so. Hours are put in order, the later of two equal ones counts. Holes
    up to `MAX_GAP_H` are left to interpolation; a longer one ends the forecast.

    Parameters
    ----------
    place
        Latitude and longitude that were asked [degrees].
    window
        First and last time that were asked [s since 1970].
    source
        Preferred model, e.g. ``"sg"``.

    Raises
    ------
    WeatherError
        ``bad-response`` when it is for elsewhere or other days, too short, or physically impossible.
    """
    meta = answer.meta
    if any(
        echo is not None and abs((echo - asked + 180.0) % 360.0 - 180.0) > MAX_ECHO_DEG
        for echo, asked in ((meta.lat, place[0]), (meta.lon, place[1]))
    ):
        raise WeatherError("Storm Glass answered for another place than the one asked; try again later.")
    if not answer.hours:
        raise WeatherError("Storm Glass sent an answer without a single hour; try again later.")
    found: dict[float, tuple[float, float, str]] = {}
    for hour in answer.hours:
        if (one := _choose(hour, source)) is not None:
            found[_seconds(hour.time)] = one
    if not found:
        raise WeatherError("Storm Glass sent no wind speed with a direction for any hour; try again later.")
    times = sorted(found)
    if times[0] > window[1] or times[-1] < window[0]:
        raise WeatherError(
            "Storm Glass answered for other days than those asked; check this computer's date."
        )
    kept, cut = _until_gap(times)
    if (kept[-1] - kept[0]) / 3600.0 < MIN_HOURS:
        raise WeatherError(f"Storm Glass sent less than {MIN_HOURS:.0f} hours of wind; try again later.")
    chosen = [found[time] for time in kept]
    models = tuple(model for _, _, model in chosen)
    return PointAnswer(
        lat=place[0],
        lon=place[1],
        time=tuple(kept),
        speed=tuple(speed for speed, _, _ in chosen),
        direction=tuple(direction for _, direction, _ in chosen),
        model=models,
        notes=_notes(answer.hours, models, source, cut),
    )


def _seconds(time: datetime) -> float:
    # the service's times without a zone are UTC, like those in its meta
    return (time if time.tzinfo else time.replace(tzinfo=UTC)).timestamp()


def _choose(hour: _Hour, source: str) -> tuple[float, float, str] | None:
    """Speed, direction and model of an hour; ``None`` when no model has both."""
    others = sorted(filter(_MODEL_NAME.fullmatch, set(hour.windSpeed) & set(hour.windDirection) - {source}))
    for model in (source, *others):
        speed, direction = hour.windSpeed.get(model), hour.windDirection.get(model)
        # numbers like -999 and 9999 stand for missing in the files of some models
        if speed is None or direction is None or not -360.0 <= direction <= 720.0:
            continue
        if not 0.0 <= speed <= MAX_SPEED or not math.isfinite(direction):
            raise WeatherError(f"Storm Glass sent a wind of {speed:g} m/s, which cannot be; try again later.")
        return speed, direction % 360.0, model
    return None


def _until_gap(times: list[float]) -> tuple[list[float], bool]:
    """Cut times before the first hole that is too long; the flag tells whether there was one."""
    holes = np.nonzero(np.diff(times) > MAX_GAP_H * 3600.0)[0]
    return (times, False) if holes.size == 0 else (times[: int(holes[0]) + 1], True)


def _notes(hours: Sequence[_Hour], models: tuple[str, ...], source: str, cut: bool) -> tuple[str, ...]:
    notes = []
    others = sorted({model for model in models if model != source})
    if others:
        count = sum(model != source for model in models)
        notes.append(f"{count} of {len(models)} hours are from {', '.join(others)}, where {source} has none.")
    if (seam := _seam(hours, source)) is not None:
        before, after, when = seam
        notes.append(f"Storm Glass follows {before} until {when:%d %b %H:%M} UTC, then {after}.")
    if cut:
        notes.append(f"Hours after a hole of more than {MAX_GAP_H:.0f} h are not used.")
    return tuple(notes)


def _seam(hours: Sequence[_Hour], source: str) -> tuple[str, str, datetime] | None:
    """First change of the model that a spliced source such as ``sg`` equals; its wind may jump there."""
    previous: tuple[str, datetime] | None = None
    for hour in sorted(hours, key=lambda one: _seconds(one.time)):
        own = (hour.windSpeed.get(source), hour.windDirection.get(source))
        same = [
            model
            for model in hour.windSpeed
            if model != source and (hour.windSpeed[model], hour.windDirection.get(model)) == own
        ]
        if None in own or not same:
            continue
        when = datetime.fromtimestamp(_seconds(hour.time), UTC)
        if previous is not None and previous[0] not in same:
            return previous[0], same[0], when
        if previous is None:
            previous = (same[0], when)
    return None
