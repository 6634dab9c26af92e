"""What a service said about one place, and how it is kept."""

from __future__ import annotations

import zlib
from array import array
from itertools import groupby
from typing import Final

import msgspec

from seacruise.weather.splice import Splice


class PointAnswer(msgspec.Struct, frozen=True):
    """What a service said about one place, checked and reduced to what is used.

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
    time: tuple[float, ...]
    speed: tuple[float, ...]
    direction: tuple[float, ...]
    model: tuple[str, ...]
    notes: tuple[str, ...] = ()
    gust: tuple[float, ...] = ()
    wave: tuple[float, ...] = ()
    current_u: tuple[float, ...] = ()
    current_v: tuple[float, ...] = ()
    spread: tuple[float, ...] = ()
    splices: tuple[Splice, ...] = ()


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
    series = tuple(array("d", getattr(answer, name)).tobytes() for name in _SERIES)
    return msgspec.msgpack.encode(_Packed(answer.lat, answer.lon, series, runs, answer.notes, answer.splices))


def unpack(body: bytes) -> PointAnswer | None:
    """Make an answer of bytes, those of earlier versions too; ``None`` when they are of none."""
    try:
        if body[:1] == _ZLIB:
            return msgspec.msgpack.decode(zlib.decompress(body), type=PointAnswer)
        packed = _UNPACK.decode(body)
        series = []
        for one in packed.series:
            values = array("d")
            values.frombytes(one)
            series.append(tuple(values))
    except (zlib.error, msgspec.DecodeError, ValueError):
        return None
    model: list[str] = []
    for name, count in packed.model:
        model += [name] * count
    return PointAnswer(
        lat=packed.lat,
        lon=packed.lon,
        model=tuple(model),
        notes=packed.notes,
        splices=packed.splices,
        **dict(zip(_SERIES, series, strict=True)),
    )
