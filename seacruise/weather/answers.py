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
from seacruise.weather.point import PointAnswer
from seacruise.weather.splice import find_splices
from seacruise.weather.wind import MAX_SPEED, from_direction, to_direction

MAX_GAP_H: Final = 6.0
"""A longer hole between two hours is not bridged; the forecast ends before it [h]."""

MIN_HOURS: Final = 24.0
"""An answer that reaches less far is no forecast [h]."""

MAX_ECHO_DEG: Final = 0.6
"""How far the place of an answer may lie from the place asked, half a cell of a 1-degree model [degrees]."""

MAX_WAVE: Final = 40.0
"""No sea is higher [m]."""

MAX_CURRENT: Final = 15.0
"""No current of the sea is faster [m/s]."""

SPLICED: Final = "sg"
"""The service's own choice of the best model for a place, which changes with the hours."""

_MODEL_NAME: Final = re.compile(r"[A-Za-z0-9:_.-]{1,24}")
"""New models appear without notice, with a colon in some names; what else is sent is not shown to anyone."""

_Values = Mapping[str, float | None]


class _Hour(msgspec.Struct):
    time: datetime
    windSpeed: _Values = {}  # noqa: N815 (the service's own name)
    windDirection: _Values = {}  # noqa: N815
    # what else is told is welcome, and no reason to refuse the wind
    gust: Any = None
    waveHeight: Any = None  # noqa: N815
    currentSpeed: Any = None  # noqa: N815
    currentDirection: Any = None  # noqa: N815


class _Body(msgspec.Struct):
    hours: list[_Hour]
    meta: msgspec.Raw = msgspec.Raw(b"")


_DECODER: Final = msgspec.json.Decoder(_Body)


@dataclass(frozen=True, slots=True)
class Meta:
    """What an answer says about itself, as far as it says it."""

    used: int | None = None
    daily: int | None = None
    cost: int = 1
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

    cost = count("cost")
    return Meta(
        used=count("requestCount"),
        daily=count("dailyQuota"),
        cost=1 if cost is None else cost,
        lat=degrees("lat"),
        lon=degrees("lng"),
    )


@dataclass(frozen=True, slots=True)
class _Pick:
    """Wind of an hour: components [m/s], their standard deviation among sources, and the sources."""

    u: float
    v: float
    spread: float
    models: tuple[str, ...]


def to_point(
    answer: DecodedAnswer, *, place: tuple[float, float], window: tuple[float, float], source: str
) -> PointAnswer:
    """Make a forecast of one place of an answer.

    Speed and direction of an hour are from one model: the wanted source where it has both, else the next
    one that has, and the notes say so. Of several wanted sources the vectors are averaged. Hours are put in
    order, the later of two equal ones counts. Holes up to `MAX_GAP_H` are left to interpolation; a longer
    one ends the forecast.

    Parameters
    ----------
    place
        Latitude and longitude that were asked [degrees].
    window
        First and last time that were asked [s since 1970].
    source
        Wanted model, e.g. ``"sg"``; several are joined by ``+``.

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
    wanted = tuple(dict.fromkeys(source.split("+")))
    found: dict[float, tuple[_Hour, _Pick]] = {}
    for hour in answer.hours:
        if (one := _choose(hour, wanted)) is not None:
            found[_seconds(hour.time)] = hour, one
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
    hours, picks = zip(*(found[time] for time in kept), strict=True)
    return _point(place, kept, hours, picks, wanted=wanted, notes=_notes(picks, wanted, cut=cut))


def _point(
    place: tuple[float, float],
    time: list[float],
    hours: Sequence[_Hour],
    picks: Sequence[_Pick],
    *,
    wanted: tuple[str, ...],
    notes: tuple[str, ...],
) -> PointAnswer:
    u, v = np.array([one.u for one in picks]), np.array([one.v for one in picks])
    speed, direction = to_direction(u, v)
    behind = [
        _behind(hour) if pick.models == (SPLICED,) else frozenset({"+".join(pick.models)})
        for hour, pick in zip(hours, picks, strict=True)
    ]
    current_u, current_v = _current(hours, wanted)
    return PointAnswer(
        lat=place[0],
        lon=place[1],
        time=tuple(time),
        speed=tuple(speed.tolist()),
        direction=tuple(direction.tolist()),
        model=tuple("+".join(one.models) for one in picks),
        notes=notes,
        gust=_extra(hours, "gust", wanted, 2 * MAX_SPEED),
        wave=_extra(hours, "waveHeight", wanted, MAX_WAVE),
        current_u=current_u,
        current_v=current_v,
        spread=tuple(one.spread for one in picks) if len(wanted) > 1 else (),
        splices=find_splices(np.array(time), (u, v), behind, [_models(hour) for hour in hours]),
    )


def _seconds(time: datetime) -> float:
    # the service's times without a zone are UTC, like those in its meta
    return (time if time.tzinfo else time.replace(tzinfo=UTC)).timestamp()


def _models(hour: _Hour) -> frozenset[str]:
    """Models of an hour that have both speed and direction."""
    return frozenset(
        name
        for name, speed in hour.windSpeed.items()
        if speed is not None and hour.windDirection.get(name) is not None and _MODEL_NAME.fullmatch(name)
    )


def _behind(hour: _Hour) -> frozenset[str]:
    """Models that the service's own choice is a copy of at an hour."""
    own = hour.windSpeed.get(SPLICED), hour.windDirection.get(SPLICED)
    return frozenset(
        name for name in _models(hour) - {SPLICED} if (hour.windSpeed[name], hour.windDirection[name]) == own
    )


def _choose(hour: _Hour, wanted: tuple[str, ...]) -> _Pick | None:
    """Wind of an hour from the wanted models; from the next one that has any, where they have none."""
    winds = [(model, one) for model in wanted if (one := _wind(hour, model)) is not None]
    if not winds:
        others = sorted(_models(hour) - set(wanted))
        winds = [(model, one) for model in others if (one := _wind(hour, model)) is not None][:1]
    if not winds:
        return None
    u = sum(one[0] for _, one in winds) / len(winds)
    v = sum(one[1] for _, one in winds) / len(winds)
    square = sum((one[0] - u) ** 2 + (one[1] - v) ** 2 for _, one in winds) / len(winds)
    # how far a single one errs is not known
    spread = math.nan if len(winds) == 1 else math.sqrt(square)
    return _Pick(u, v, spread, tuple(model for model, _ in winds))


def _wind(hour: _Hour, model: str) -> tuple[float, float] | None:
    """Components of the wind that a model has for an hour [m/s].

    Raises
    ------
    WeatherError
        When it cannot be.
    """
    speed, direction = hour.windSpeed.get(model), hour.windDirection.get(model)
    # numbers like -999 and 9999 stand for missing in the files of some models
    if speed is None or direction is None or not -360.0 <= direction <= 720.0:
        return None
    if not 0.0 <= speed <= MAX_SPEED:
        raise WeatherError(f"Storm Glass sent a wind of {speed:g} m/s, which cannot be; try again later.")
    u, v = from_direction(speed, direction)
    return float(u), float(v)


def _told(hours: Sequence[_Hour], name: str, wanted: tuple[str, ...], most: float) -> dict[str, list[float]]:
    """Values of a parameter by model, NaN where it has none; the model to be taken comes first."""
    by_model: dict[str, list[float]] = {}
    for index, hour in enumerate(hours):
        told = getattr(hour, name)
        for model, value in told.items() if isinstance(told, dict) else ():
            if type(value) in {int, float} and 0.0 <= value <= most and _MODEL_NAME.fullmatch(str(model)):
                by_model.setdefault(model, [math.nan] * len(hours))[index] = float(value)
    rank = {model: number for number, model in enumerate((*wanted, SPLICED))}
    # one model for all hours: a step from one to another would look like weather
    order = sorted(
        by_model, key=lambda model: (sum(map(math.isnan, by_model[model])), rank.get(model, 99), model)
    )
    return {model: by_model[model] for model in order}


def _extra(hours: Sequence[_Hour], name: str, wanted: tuple[str, ...], most: float) -> tuple[float, ...]:
    return tuple(next(iter(_told(hours, name, wanted, most).values()), ()))


def _current(hours: Sequence[_Hour], wanted: tuple[str, ...]) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Motion of the water; the service says where it comes FROM, as it does of the wind."""
    speeds = _told(hours, "currentSpeed", wanted, MAX_CURRENT)
    directions = _told(hours, "currentDirection", wanted, 360.0)
    model = next((name for name in speeds if name in directions), None)
    if model is None:
        return (), ()
    u, v = from_direction(speeds[model], directions[model])
    return tuple(u.tolist()), tuple(v.tolist())


def _until_gap(times: list[float]) -> tuple[list[float], bool]:
    """Cut times before the first hole that is too long; the flag tells whether there was one."""
    holes = np.nonzero(np.diff(times) > MAX_GAP_H * 3600.0)[0]
    return (times, False) if holes.size == 0 else (times[: int(holes[0]) + 1], True)


def _notes(picks: Sequence[_Pick], wanted: tuple[str, ...], *, cut: bool) -> tuple[str, ...]:
    notes = []
    others = sorted({model for pick in picks for model in pick.models} - set(wanted))
    if others:
        count = sum(not set(pick.models) & set(wanted) for pick in picks)
        names = " and ".join(wanted)
        notes.append(
            f"{count} of {len(picks)} hours are from {', '.join(others)}, where {names} "
            f"{'has' if len(wanted) == 1 else 'have'} none."
        )
    if cut:
        notes.append(f"Hours after a hole of more than {MAX_GAP_H:.0f} h are not used.")
    return tuple(notes)
