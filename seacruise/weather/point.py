"""What a service said about one place, and how it is kept."""

from __future__ import annotations

import zlib
from array import array
from collections.abc import Sequence
from functools import lru_cache
from itertools import chain, groupby
from typing import Final

import msgspec

from seacruise.weather.splice import Splice

Series = Sequence[float]
"""Kept as arrays of doubles: a thousand answers are a million numbers, and making objects of them took longer
than reading and checking all of them."""


class PointAnswer(msgspec.Struct, frozen=True):
    """What a service said about one place, checked and reduced to what is used.

    Any sequences of numbers may be given; they become ``array("d")``.

    Attributes
    ----------
    time
        Seconds since 1970-01-01T00:00Z, strictly increasing.
    speed, direction
        [m/s] and degrees true FROM; as many as times.
    model
        Name of the source each hour is from.
    notes
        Sentences about what was missing or replaced.
    gust, wave
        Speed of the gusts [m/s] and significant wave height [m]; NaN at the hours without, and no values
        at all where none was told.
    current_u, current_v
        Eastward and northward component of the motion of the water [m/s], likewise.
    spread
        Standard deviation of the vectors of the sources that speed and direction are the mean of [m/s];
        none for a single source.
    splices
        Where the hours change from one model to another.
    """

    lat: float
    lon: float
    time: Series
    speed: Series
    direction: Series
    model: tuple[str, ...]
    notes: tuple[str, ...] = ()
    gust: Series = ()
    wave: Series = ()
    current_u: Series = ()
    current_v: Series = ()
    spread: Series = ()
    splices: tuple[Splice, ...] = ()

    def __post_init__(self) -> None:
        for name in _SERIES:
            values = getattr(self, name)
            if type(values) is not array:
                msgspec.structs.force_setattr(self, name, array("d", values))


_SERIES: Final = (
    "time", "speed", "direction", "gust", "wave", "current_u", "current_v", "spread",
)  # fmt: skip


class _Packed(msgspec.Struct, array_like=True, frozen=True):
    """An answer as it is stored: series as bytes of doubles, which are read ten times faster than numbers."""

    lat: float
    lon: float
    series: tuple[bytes, ...]
    model: tuple[tuple[str, int], ...]
    notes: tuple[str, ...]
    splices: tuple[Splice, ...]


_UNPACK: Final = msgspec.msgpack.Decoder(_Packed)
_ZLIB: Final = b"x"
"""First byte of the bodies of earlier versions, which were compressed."""


def pack(answer: PointAnswer) -> bytes:
    """Make bytes of an answer, for `unpack`."""
    runs = tuple((name, len(list(same))) for name, same in groupby(answer.model))
    series = tuple(bytes(getattr(answer, name)) for name in _SERIES)
    return msgspec.msgpack.encode(_Packed(answer.lat, answer.lon, series, runs, answer.notes, answer.splices))


def unpack(body: bytes) -> PointAnswer | None:
    """Make an answer of bytes, those of earlier versions too; ``None`` when they are of none."""
    try:
        if body[:1] == _ZLIB:
            return msgspec.msgpack.decode(zlib.decompress(body), type=PointAnswer)
        packed = _UNPACK.decode(body)
        series = [array("d", one) for one in packed.series]
    except (zlib.error, msgspec.DecodeError, ValueError):
        return None
    return PointAnswer(
        lat=packed.lat,
        lon=packed.lon,
        model=_by_hour(packed.model),
        notes=packed.notes,
        splices=packed.splices,
        **dict(zip(_SERIES, series, strict=True)),
    )


@lru_cache(maxsize=256)
def _by_hour(runs: tuple[tuple[str, int], ...]) -> tuple[str, ...]:
    """Names hour by hour; answers of one service mostly share them."""
    return tuple(chain.from_iterable((name,) * count for name, count in runs))
