"""Slices of a polar in one wind, ready to be drawn: curve, hull, best VMG, sails."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.hull import hull_headings, hull_speed
from seacruise.yacht.polar import Polar
from seacruise.yacht.sails import SailRange, SailSet, sail_at
from seacruise.yacht.targets import Target

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

STEP_DEG: Final = 0.5
"""Step of the curves; a chord of the hull drawn point by point is then straight to the eye."""

NEAR_KN: Final = 1.0
"""Points of a log are drawn with a slice whose wind is no further from theirs than this."""

LEAST_GAIN: Final = 0.002
"""A dent of the polar in which two headings gain less than this share of the speed is not told."""

_LEAST_KN: Final = 2.0
_MOST_SLICES: Final = 7


@dataclass(frozen=True, slots=True)
class Chord:
    """Courses that are made good by turns on two headings.

    Attributes
    ----------
    course_from, course_to
        Those courses [degrees to the wind, 0 to 180].
    twa1, twa2
        The headings [degrees, negative with the wind over the port side].
    sail1, sail2
        Their sails, where the polar knows them.
    """

    course_from: float
    course_to: float
    twa1: float
    twa2: float
    sail1: str | None = None
    sail2: str | None = None


@dataclass(frozen=True, slots=True, eq=False)
class SailCurve:
    """Boat speed ``(n,)`` under one sail [kn] at the angles of a `Slice`; NaN beyond its figures."""

    name: str
    speed_kn: Array


@dataclass(frozen=True, slots=True, eq=False)
class Slice:
    """A polar in one wind.

    Attributes
    ----------
    tws_kn
        The wind [kn].
    twa
        ``(n,)`` angles, from 0 to 180 [degrees].
    speed_kn, hull_kn
        ``(n,)`` boat speed, and what is made good in that direction by tacking and gybing as well [kn].
    known
        ``(n,)`` whether the polar has figures there; elsewhere it goes on by rule.
    beat, run
        Best VMG against and with the wind.
    chords
        Where two headings are better than one, from ahead to astern.
    sails, ranges
        Each sail's own curve, and which one is set where; empty where the polar knows no sails.
    """

    tws_kn: float
    twa: Array
    speed_kn: Array
    hull_kn: Array
    known: Mask
    beat: Target
    run: Target
    chords: tuple[Chord, ...]
    sails: tuple[SailCurve, ...]
    ranges: tuple[SailRange, ...]


def slice_of(polar: Polar, tws_kn: float, *, with_sails: bool = True) -> Slice:
    """Cut a polar at a true wind speed [kn].

    Parameters
    ----------
    with_sails
        Look for each sail's curve and range as well, which takes longer than all the rest.
    """
    wind = tws_kn * MS_PER_KNOT
    twa = polar.sample_angles(STEP_DEG)
    beat, run = (float(polar.best_vmg(np.array([wind]), up)[0][0]) for up in (True, False))
    sails = SailSet(polar.name, polar.sails) if polar.sails and with_sails else None
    speed, made = polar.speed(wind, twa), hull_speed(polar, wind, twa)[0]
    return Slice(
        tws_kn=tws_kn,
        twa=twa,
        speed_kn=speed / MS_PER_KNOT,
        hull_kn=made / MS_PER_KNOT,
        known=polar.covers(wind, twa),
        beat=target_at(polar, tws_kn, beat),
        run=target_at(polar, tws_kn, run),
        chords=_chords(polar, wind, twa, direct=speed, made=made),
        sails=_sail_curves(sails, wind, twa) if sails else (),
        ranges=tuple(sails.ranges(wind)) if sails else (),
    )


def target_at(polar: Polar, tws_kn: float, twa: float) -> Target:
    """Tell what is sailed at an angle [degrees] in a wind [kn]; the VMG is positive both ways."""
    wind = tws_kn * MS_PER_KNOT
    speed = float(polar.speed(wind, twa))
    ahead = wind * np.cos(np.radians(twa)) + speed
    abeam = wind * np.sin(np.radians(twa))
    return Target(
        twa=twa,
        boat_speed_kn=speed / MS_PER_KNOT,
        vmg_kn=speed * abs(float(np.cos(np.radians(twa)))) / MS_PER_KNOT,
        awa=float(np.degrees(np.arctan2(abeam, ahead))),
        aws_kn=float(np.hypot(abeam, ahead)) / MS_PER_KNOT,
        sail=sail_at(polar, wind, twa),
    )


def _chords(polar: Polar, wind: float, twa: Array, *, direct: Array, made: Array) -> tuple[Chord, ...]:
    """Join the courses that are sailed on the same two headings, where that is worth while."""
    first, share, second, _ = hull_headings(polar, wind, twa)
    mixed = (share < 1.0) & (made > 0.0)
    pairs: dict[tuple[float, float], list[int]] = {}
    for k in np.flatnonzero(mixed).tolist():
        # A course at which sailing direct happens to be as good lies between others of its chord.
        pairs.setdefault((round(float(first[k]), 3), round(float(second[k]), 3)), []).append(k)
    chords = []
    for pair, courses in pairs.items():
        gain = float((made[courses] - direct[courses]).max()) / float(made[courses].max())
        if pair[0] != -pair[1] and gain < LEAST_GAIN:
            continue
        begin, end = float(twa[courses[0]]), float(twa[courses[-1]])
        if pair[0] == -pair[1]:
            # Both tacks: the chord goes from the heading to the wind's axis.
            begin, end = (0.0, abs(pair[0])) if abs(pair[0]) < 90.0 else (abs(pair[0]), 180.0)
        sails = [sail_at(polar, wind, abs(angle)) for angle in pair]
        chords.append(Chord(begin, end, *pair, *sails))
    return tuple(chords)


def _sail_curves(sails: SailSet, wind: float, twa: Array) -> tuple[SailCurve, ...]:
    speeds = sails.speeds(wind, twa) / MS_PER_KNOT
    return tuple(
        SailCurve(sail.name, np.where((speed > 0.0) & sail.covers(wind, twa), speed, np.nan))
        for sail, speed in zip(sails.sails, speeds, strict=True)
    )


def usual_winds(polars: Sequence[Polar]) -> tuple[float, ...]:
    """Winds [kn] that show polars well: those of the first one's table, seven of them at most."""
    winds = [round(float(tws) / MS_PER_KNOT, 2) for tws in polars[0].tws]
    winds = [kn for kn in winds if kn >= _LEAST_KN] or [max(winds[-1], _LEAST_KN)]
    if len(winds) > _MOST_SLICES:
        chosen = np.linspace(0, len(winds) - 1, _MOST_SLICES).round().astype(int)
        winds = [winds[k] for k in chosen.tolist()]
    return tuple(winds)


@dataclass(frozen=True, slots=True, eq=False)
class LogPoints:
    """Steady sailing out of a log, to be laid over a polar, all ``(n,)``.

    Attributes
    ----------
    tws_kn
        True wind speed [kn].
    twa
        True wind angle [degrees, positive with the wind over the starboard side; any sign will do].
    speed_kn
        Boat speed through the water [kn].
    source
        The log, as the picture names it.

    Raises
    ------
    InputError
        The three differ in number, or a value is not finite.
    """

    tws_kn: Array
    twa: Array
    speed_kn: Array
    source: str = ""

    def __post_init__(self) -> None:
        for attribute in ("tws_kn", "twa", "speed_kn"):
            array = np.array(getattr(self, attribute), dtype=np.float64)
            object.__setattr__(self, attribute, array)
        if not (self.tws_kn.ndim == 1 and self.tws_kn.shape == self.twa.shape == self.speed_kn.shape):
            raise InputError("The points of a log need one wind speed, one angle and one boat speed each.")
        if not all(np.isfinite(a).all() for a in (self.tws_kn, self.twa, self.speed_kn)):
            raise InputError("A point of the log is no finite number; leave it out.")

    def __len__(self) -> int:
        return int(self.tws_kn.size)

    @property
    def both_tacks(self) -> bool:
        """Whether she was on either tack."""
        return bool((self.twa > 0.0).any() and (self.twa < 0.0).any())

    def near(self, tws_kn: float) -> LogPoints:
        """Points in about a wind [kn]."""
        return self.rows(np.abs(self.tws_kn - tws_kn) <= NEAR_KN)

    def rows(self, which: Mask) -> LogPoints:
        """Give some of the points."""
        return LogPoints(self.tws_kn[which], self.twa[which], self.speed_kn[which], self.source)
