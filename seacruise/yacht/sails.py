"""Several sails: the best one for each wind, its name, and where it changes.

Every sail has a polar of its own, named after the sail. What the yacht does is the best of them; a table of
that is a `Polar` like any other, so that nothing else needs to know, and it carries the sails along: a leg
can tell its sail.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.polar import Polar, fold_angle

Array = NDArray[np.float64]
ArrayLike = Any

_STEP: Final = 0.25
"""Step of the search for changes of sail [degrees]."""

_STRUCK: Final = 0.5 * MS_PER_KNOT
"""So much above the greatest wind of its table a sail is down [m/s]."""


@dataclass(frozen=True, slots=True)
class SailRange:
    """Angles [degrees] between which a sail is the best at some wind."""

    sail: str
    twa_from: float
    twa_to: float


@dataclass(frozen=True, slots=True, eq=False)
class SailSet:
    """A yacht and the sails she carries.

    A sail is not set in more wind than its own table has, as long as another one's table goes further. In
    less wind, and beyond its angles, its polar goes on as every `Polar` does.

    Attributes
    ----------
    name
        The yacht, as shown to the sailor.
    sails
        One polar a sail, named after it.

    Raises
    ------
    InputError
        There is no sail, or two have the same name.
    """

    name: str
    sails: tuple[Polar, ...]
    source: str = ""
    path: Path | None = None

    def __post_init__(self) -> None:
        names = [sail.name for sail in self.sails]
        if not names:
            raise InputError(f"{self.name or 'This yacht'} has no sails; give a polar for one at least.")
        if twice := next((name for name in names if names.count(name) > 1), None):
            raise InputError(
                f"{self.name or 'This yacht'} has two sails named {twice!r}; rename one of them."
            )

    def speeds(self, tws: ArrayLike, twa: ArrayLike) -> Array:
        """Boat speed [m/s] with each sail ``(s, ...)``; zero with one that is not set in so much wind."""
        wind = np.asarray(tws, dtype=np.float64)
        angle = fold_angle(twa)
        strongest = max(float(sail.tws[-1]) for sail in self.sails)
        return np.stack(
            [
                np.where(
                    (wind <= sail.tws[-1] * (1.0 + 1e-9)) | (sail.tws[-1] >= strongest) | np.isnan(wind),
                    sail.speed(wind, angle),
                    0.0,
                )
                for sail in self.sails
            ]
        )

    def speed(self, tws: ArrayLike, twa: ArrayLike) -> Array:
        """Boat speed [m/s] under the best sail at winds [m/s] and angles [degrees] that broadcast."""
        return np.asarray(self.speeds(tws, twa).max(axis=0))

    def best(self, tws: ArrayLike, twa: ArrayLike) -> NDArray[np.intp]:
        """Which of `sails` is the fastest, in the broadcast shape; -1 where none of them moves her.

        Of two that are equally fast it is the one that is named first.
        """
        speeds = self.speeds(tws, twa)
        return np.where(speeds.max(axis=0) > 0.0, speeds.argmax(axis=0), -1)

    def sail(self, tws: float, twa: float) -> str | None:
        """Name the best sail at a wind [m/s] and an angle [degrees]; ``None`` where none moves her."""
        best = int(self.best(tws, twa))
        return self.sails[best].name if best >= 0 else None

    def ranges(self, tws: float) -> list[SailRange]:
        """Find the sails to set in a wind [m/s], from close-hauled to a run, and where each gives way."""
        _, edges, after = self._changes(np.array([tws]))
        best = [int(self.best(tws, 0.0)), *after.tolist()]
        limits = pairwise([0.0, *edges.tolist(), 180.0])
        return [
            SailRange(self.sails[k].name, begin, end)
            for k, (begin, end) in zip(best, limits, strict=True)
            if k >= 0
        ]

    def _changes(self, tws: Array) -> tuple[NDArray[np.intp], Array, NDArray[np.intp]]:
        """All changes of the best sail in winds ``(w,)``: the wind's row, the angle, the sail after it."""
        angles = np.linspace(0.0, 180.0, round(180.0 / _STEP) + 1)
        best = self.best(tws[:, np.newaxis], angles)
        rows, at = np.nonzero(best[:, 1:] != best[:, :-1])
        low, high = angles[at], angles[at + 1]
        before = best[rows, at]
        while (high - low > 1e-3).any():
            middle = (low + high) / 2.0
            same = self.best(tws[rows], middle) == before
            low, high = np.where(same, middle, low), np.where(same, high, middle)
        return rows, (low + high) / 2.0, best[rows, at + 1]

    def to_table(self) -> Polar:
        """Tabulate the best of the sails; the table has all their winds and angles, and each change.

        Without the angles of change a smooth curve would be laid across the kink at which one sail gives way
        to another, and without a wind just above that in which a sail is struck it would be half set there.
        """
        greatest = np.array(sorted({float(sail.tws[-1]) for sail in self.sails}))
        tws = union_of_axes([*(sail.tws for sail in self.sails), greatest[:-1] + _STRUCK], 1e-6)
        _, changes, _ = self._changes(tws)
        twa = union_of_axes([*(sail.twa for sail in self.sails), np.round(changes, 1)], 0.05)
        known = np.any([sail.covers(tws, twa[:, np.newaxis]) for sail in self.sails], axis=0)
        return Polar(
            self.name,
            tws,
            twa[known.any(axis=1)],
            np.where(known, self.speed(tws, twa[:, np.newaxis]), np.nan)[known.any(axis=1)],
            source=self.source,
            path=self.path,
            sails=self.sails,
        )


def union_of_axes(axes: list[Array], tolerance: float) -> Array:
    """All values of some axes, those that differ by rounding only once."""
    values = np.unique(np.concatenate(axes))
    return values[np.concatenate(([True], np.diff(values) > tolerance))]


def sail_at(polar: Polar, tws: float, twa: float) -> str | None:
    """Name the sail to set at a true wind speed [m/s] and angle [degrees].

    Returns
    -------
    str or None
        ``None`` where the polar knows no sails, and where none of them moves her.
    """
    if not polar.sails:
        return None
    return SailSet(polar.name, polar.sails).sail(tws, twa)


def sail_names(polar: Polar) -> tuple[tuple[str, ...], ...]:
    """Name the sail of each cell of the table ``(a, w)``; empty text where there is none."""
    if not polar.sails:
        return ()
    best = SailSet(polar.name, polar.sails).best(polar.tws, polar.twa[:, np.newaxis])
    return tuple(tuple(polar.sails[k].name if k >= 0 else "" for k in row) for row in best)
