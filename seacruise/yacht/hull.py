"""The tacking hull: what a yacht makes good when she may share her time between two headings.

Whatever two headings reach by turns lies on the chord between them, so the speed made good in any
direction is the radius of the convex hull of the polar slice, mirrored to both tacks. Inside the dead
angle that is a beat, dead before the wind a run on alternate gybes, and across a dent of the polar a mix
of a higher and a lower course.

References
----------
V. Dannenberg, R. Schueler, A. Schuermann, Appl. Sci. 12 (2022) 3085, doi 10.3390/app12063085.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from seacruise.yacht.polar import Polar, fold_angle

Array = NDArray[np.float64]
ArrayLike = Any

_STEP = 0.5
"""Sampling of a slice [degrees]. A smooth optimum between samples is then missed by less than 0.01 %;
the kinks, where it usually lies, are sampled besides."""

_FEW = 4
"""Winds of which hulls are kept; 30 kB each."""

_DIRECT = 1e-9
"""A mix must beat sailing direct by this share, or rounding would tack on every reach."""


@dataclass(frozen=True, slots=True, eq=False)
class _Slices:
    """Hull vertices of slices ``(w, s)``: sampled angles [radians], speeds, and the vertices around each gap.

    ``left[i, j]`` and ``right[i, j]`` are the samples that bound the gap ``j`` between samples ``j - 1``
    and ``j``; ``-1`` and ``s`` stand for the first and last vertex on the other tack.
    """

    angles: Array
    speeds: Array
    left: NDArray[np.intp]
    right: NDArray[np.intp]


def hull_speed(polar: Polar, tws: ArrayLike, twa: ArrayLike) -> Array:
    """Speed made good [m/s] in each direction, tacking and gybing where that is faster.

    Parameters
    ----------
    tws
        ``(w,)`` true wind speeds [m/s].
    twa
        ``(a,)`` angles between wind and course made good [degrees].

    Returns
    -------
    Array
        ``(w, a)`` [m/s]; nowhere less than ``polar.speed``.
    """
    wind = np.atleast_1d(np.asarray(tws, dtype=np.float64))
    course = fold_angle(np.atleast_1d(twa))
    slices = _hull(polar, wind)
    rows = np.arange(len(wind))[:, np.newaxis]
    direct = polar.speed(wind[:, np.newaxis], course)
    mixed = _mix(slices, rows, np.radians(course)[np.newaxis, :])[0]
    return np.maximum(direct, mixed)


def hull_headings(polar: Polar, tws: ArrayLike, twa: ArrayLike) -> tuple[Array, Array, Array, Array]:
    """Find the two headings that make good a course fastest, and how to share the time.

    Parameters
    ----------
    tws, twa
        True wind speeds [m/s] and angles of the course made good [degrees, -180 to 180, negative when
        the wind comes over the port side]; any shapes that broadcast, element by element.

    Returns
    -------
    twa1, share1, twa2, share2
        Signed angles to sail [degrees] and shares of the time. Where sailing direct is best ``twa1`` and
        ``twa2`` are the course itself and ``share1`` is 1. On a beat or run the first heading is the
        long board.
    """
    wind, course = np.broadcast_arrays(np.asarray(tws, dtype=np.float64), np.asarray(twa, dtype=np.float64))
    folded = fold_angle(course)
    port_tack = ((course + 180.0) % 360.0 < 180.0) & (folded < 180.0)
    side = np.where(port_tack, -1.0, 1.0)
    unique, rows = np.unique(wind, return_inverse=True)
    rows = rows.reshape(wind.shape)
    slices = _kept_hull(polar, tuple(unique.tolist())) if unique.size <= _FEW else _hull(polar, unique)
    speed, first, second, share = _mix(slices, rows, np.radians(folded))
    direct = polar.speed(wind, folded)
    mixed = speed > direct * (1.0 + _DIRECT)
    share1 = np.where(mixed, share, 1.0)
    twa1 = side * np.where(mixed, np.degrees(first), folded)
    twa2 = side * np.where(mixed, np.degrees(second), folded)
    return twa1, share1, twa2, 1.0 - share1


@lru_cache(maxsize=64)
def _kept_hull(polar: Polar, tws: tuple[float, ...]) -> _Slices:
    """`_hull` of few winds, kept: who asks for one course in a wind mostly asks for more."""
    return _hull(polar, np.array(tws))


def _hull(polar: Polar, tws: Array) -> _Slices:
    """Convex hulls of the slices at winds ``(w,)``."""
    degrees = polar.sample_angles(_STEP)
    angles = np.radians(degrees)
    speeds = np.nan_to_num(polar.speed(tws[:, np.newaxis], degrees))
    return _Slices(angles, speeds, *_gaps(_vertices(angles, speeds)))


def _vertices(angles: Array, speeds: Array) -> NDArray[np.bool_]:
    """Which samples of each slice ``(w, s)`` are vertices of its hull.

    The slice is symmetric: its hull closes with a level chord at the best VMG to windward and at the best
    to leeward, and what lies beyond those angles is inside. Of the rest, a sample within the triangle of
    the origin and its two neighbours is inside; all such go at once, and again, until none is left.
    """
    samples = len(angles)
    vmg = speeds * np.cos(angles)
    tie = 1e-12 * np.max(np.abs(vmg), axis=1, keepdims=True, initial=0.0)
    windward = vmg >= vmg.max(axis=1, keepdims=True) - tie
    leeward = vmg <= vmg.min(axis=1, keepdims=True) + tie
    # Of equal VMG the one furthest from the wind's axis spans the chord. Where none is made good, the hull
    # closes at the origin, where all samples at rest lie; between two that move it is inside.
    top = samples - 1 - np.argmax(windward[:, ::-1], axis=1)[:, np.newaxis]
    top = np.where(vmg.max(axis=1, keepdims=True) > tie, top, 0)
    index = np.arange(samples)
    bottom = np.argmax(leeward & (index >= top), axis=1)[:, np.newaxis]
    bottom = np.where(vmg.min(axis=1, keepdims=True) < -tie, bottom, samples - 1)
    moves = speeds > 0.0
    first = np.argmax(moves, axis=1)[:, np.newaxis]
    last = samples - 1 - np.argmax(moves[:, ::-1], axis=1)[:, np.newaxis]
    calm = ~moves.any(axis=1, keepdims=True)
    kept = (index >= top) & (index <= bottom) & (moves | calm | (index < first) | (index > last))
    x, y = speeds * np.sin(angles), vmg
    rows = np.arange(len(speeds))
    while len(rows):
        inside = _inside(x[rows], y[rows], kept[rows])
        kept[rows] &= ~inside
        rows = rows[inside.any(axis=1)]
    return np.asarray(kept)


def _inside(x: Array, y: Array, kept: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Kept samples that lie below the chord of their two kept neighbours."""
    before, after = _neighbours(kept)
    ends = (before < 0) | (after >= x.shape[1])
    before, after = np.maximum(before, 0), np.minimum(after, x.shape[1] - 1)
    x0, y0 = np.take_along_axis(x, before, 1), np.take_along_axis(y, before, 1)
    x1, y1 = np.take_along_axis(x, after, 1), np.take_along_axis(y, after, 1)
    cross = (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0)
    return np.asarray(kept & ~ends & (cross < 0.0))


def _neighbours(kept: NDArray[np.bool_]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Of every sample ``(w, s)`` the kept ones before and after it; ``-1`` and ``s`` where there is none."""
    samples = kept.shape[1]
    index = np.arange(samples)
    before = np.maximum.accumulate(np.where(kept, index, -1), axis=1)
    after = np.minimum.accumulate(np.where(kept, index, samples)[:, ::-1], axis=1)[:, ::-1]
    none_before = np.full((len(kept), 1), -1)
    none_after = np.full((len(kept), 1), samples)
    return np.hstack((none_before, before[:, :-1])), np.hstack((after[:, 1:], none_after))


def _gaps(kept: NDArray[np.bool_]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Of every gap between samples ``(w, s + 1)`` the vertices that bound it."""
    samples = kept.shape[1]
    index = np.arange(samples)
    left = np.maximum.accumulate(np.where(kept, index, -1), axis=1)
    right = np.minimum.accumulate(np.where(kept, index, samples)[:, ::-1], axis=1)[:, ::-1]
    edge = np.ones((len(kept), 1), dtype=np.intp)
    return np.hstack((-edge, left)), np.hstack((right, samples * edge))


def _mix(slices: _Slices, rows: NDArray[np.intp], course: Array) -> tuple[Array, Array, Array, Array]:
    """Speed made good on the chord across ``course`` [radians], its headings and the share of the first."""
    samples = len(slices.angles)
    gap = np.searchsorted(slices.angles, course, side="right")
    left, right = slices.left[rows, gap], slices.right[rows, gap]
    beats, runs = left < 0, right >= samples
    # Off either end the chord leads to the same vertex on the other tack.
    first = np.where(beats, right, left)
    second = np.where(runs, left, right)
    a1, v1 = slices.angles[first], slices.speeds[rows, first]
    v2 = slices.speeds[rows, second]
    a2 = np.where(beats | runs, -slices.angles[second], slices.angles[second])
    part1 = v2 * np.abs(np.sin(a2 - course))
    part2 = v1 * np.abs(np.sin(course - a1))
    total = part1 + part2
    share = np.where(total > 0.0, part1 / np.where(total > 0.0, total, 1.0), 1.0)
    speed = share * v1 * np.cos(course - a1) + (1.0 - share) * v2 * np.cos(course - a2)
    return speed, a1, a2, share
