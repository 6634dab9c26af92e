"""The words of a log: columns by time, vectors, and the points that a polar is fitted to.

Vectors are complex numbers. Over the ground and through the water the real part points north and the
imaginary part east; in the boat's frame they point ahead and to starboard. A wind is the vector towards
where it comes FROM, so that adding the boat's own motion to the true wind gives the apparent one.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field, fields
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError

Array = NDArray[np.float64]
Vectors = NDArray[np.complex128]
Mask = NDArray[np.bool_]
ArrayLike = Any


@dataclass(frozen=True, slots=True, eq=False)
class Log:
    """What the instruments said, a row a moment, all columns ``(n,)`` and NaN where there is nothing.

    Attributes
    ----------
    time
        Seconds since 1970-01-01T00:00Z.
    lat, lon
        Position [degrees].
    sog, cog
        Speed [m/s] and course [degrees true] over ground.
    stw, heading
        Speed through the water [m/s] and heading [degrees true; magnetic where no variation is known].
    awa, aws
        Apparent wind: angle off the bow [degrees, -180 to 180, positive to starboard] and speed [m/s].
    twa, tws
        True wind in the same way; see `seacruise.yacht.logs.wind` for which one.
    rpm
        Engine [revolutions per minute].

    Raises
    ------
    InputError
        The columns differ in length.
    """

    time: Array
    lat: Array
    lon: Array
    sog: Array
    cog: Array
    stw: Array
    heading: Array
    awa: Array
    aws: Array
    twa: Array
    tws: Array
    rpm: Array

    def __post_init__(self) -> None:
        for name in COLUMNS:
            column = np.ascontiguousarray(getattr(self, name), dtype=np.float64)
            object.__setattr__(self, name, column)
            if column.shape != (np.size(self.time),):
                raise InputError(
                    f"The log's column {name} has the shape {column.shape} where there are "
                    f"{np.size(self.time)} times; give columns of one length."
                )

    def __len__(self) -> int:
        return int(self.time.size)

    def rows(self, which: Any) -> Log:
        """Give some of the rows: a mask, a slice or indices."""
        return Log(*(getattr(self, name)[which] for name in COLUMNS))

    @property
    def over_ground(self) -> Vectors:
        """Motion over the ground [m/s]."""
        return vector(self.sog, self.cog)

    @property
    def through_water(self) -> Vectors:
        """Motion through the water [m/s], leeway left out."""
        return vector(self.stw, self.heading)


COLUMNS: Final = tuple(column.name for column in fields(Log))


def log_of(time: ArrayLike, **columns: ArrayLike) -> Log:
    """Make a log of arrays; columns that are not given are NaN.

    Parameters
    ----------
    time
        ``(n,)`` seconds since 1970-01-01T00:00Z.
    columns
        Any of the columns of `Log`, in its units.

    Raises
    ------
    InputError
        There is no such column, or the columns differ in length.
    """
    unknown = sorted(set(columns) - set(COLUMNS))
    if unknown:
        raise InputError(f"A log has no column {unknown[0]!r}; there are {', '.join(COLUMNS)}.")
    empty = np.full(np.shape(time), np.nan)
    return Log(time, *(columns.get(name, empty) for name in COLUMNS[1:]))


def joined(logs: Iterable[Log]) -> Log:
    """Join logs, in their order; an empty log of none."""
    parts = list(logs) or [log_of(np.empty(0))]
    return Log(*(np.concatenate([getattr(part, name) for part in parts]) for name in COLUMNS))


@dataclass(slots=True)
class Tally:
    """What was read, used and left out, and why; counted on the way.

    Attributes
    ----------
    used
        Sentences, lines or messages that gave a value.
    skipped
        By reason, those that gave none.
    notes
        Sentences for the sailor: which checksum policy was taken, which variation.
    """

    used: int = 0
    skipped: Counter[str] = field(default_factory=Counter)
    notes: list[str] = field(default_factory=list)


@dataclass(frozen=True, slots=True, eq=False)
class Points:
    """What a polar is fitted to, all ``(n,)``.

    Attributes
    ----------
    time
        Seconds since 1970.
    tws, twa, speed
        True wind speed [m/s] and angle [degrees, signed, positive on the starboard tack], and boat speed
        through the water [m/s].
    weight
        0 to 1, see `seacruise.yacht.logs.weigh`.
    span
        How long each point stands for [s].
    """

    time: Array
    tws: Array
    twa: Array
    speed: Array
    weight: Array
    span: float

    def __len__(self) -> int:
        return int(self.time.size)

    def rows(self, which: Any) -> Points:
        """Give some of the points: a mask, a slice or indices."""
        return Points(
            self.time[which],
            self.tws[which],
            self.twa[which],
            self.speed[which],
            self.weight[which],
            self.span,
        )


def points_of(log: Log, *, span: float) -> Points:
    """Take the points of a log whose rows are steady, each of weight 1."""
    return Points(log.time, log.tws, log.twa, log.stw, np.ones(len(log)), span)


def vector(length: ArrayLike, angle_deg: ArrayLike) -> Vectors:
    """Make vectors of lengths and angles [degrees]."""
    return np.asarray(length * np.exp(1j * np.radians(angle_deg)))


def signed_angle(angle_deg: ArrayLike) -> Array:
    """Turn angles [degrees] into -180 to 180, the upper end included."""
    return np.asarray(180.0 - (180.0 - np.asarray(angle_deg, dtype=np.float64)) % 360.0)


def angle_of(vectors: Vectors) -> Array:
    """Give the directions of vectors [degrees, -180 to 180]."""
    return np.asarray(np.degrees(np.angle(vectors)))
