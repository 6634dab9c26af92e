"""Which moments show what she can do: no manoeuvre, no gust to recover from, no engine.

A polar speaks of a yacht that has settled. Each row gets the first reason that speaks against it, in the
order of `REASONS`:

========================  ===============================================================================
missing wind or speed     no true wind or no speed through the water
beside a gap              fewer than half of the rows around it (30 s before and after)
stopped                   slower than 1 kn
calm                      true wind below 3 kn, in which vanes and logs read anything
under engine              the engine turns; or she moves where no yacht sails, nearer than 20 degrees to
                          the wind; or she is 1.6 times as fast as the wind
after a tack or gybe      the wind came from the other side within the last minute
turning                   her heading varies by more than 20 degrees within those 60 s
wind shifting             the wind's angle varies by more than 30 degrees
accelerating              her speed varies by more than a quarter
log against receiver      speed through the water and over ground (less the current) differ by a quarter:
                          weed in the log, or a receiver that lost its fix
========================  ===============================================================================
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from seacruise.units import MS_PER_KNOT
from seacruise.yacht.logs.log import Array, Log, Mask, Vectors, signed_angle

STEADY: Final = -1

_SIDED: Final = 75.0
"""The wind comes from a side when it is no further than this from abeam [degrees]."""

REASONS: Final = (
    "missing wind or speed",
    "beside a gap",
    "stopped",
    "calm",
    "under engine",
    "after a tack or gybe",
    "turning",
    "wind shifting",
    "accelerating",
    "log against receiver",
)


@dataclass(frozen=True, slots=True)
class Rules:
    """Limits of what counts as steady; see the module for what each decides.

    Attributes
    ----------
    around_s, settle_s
        How far to look to both sides [s], and how long a yacht needs after a tack [s].
    least_speed, least_wind
        [m/s].
    nearest_twa, fastest
        Least angle to the wind [degrees] and greatest share of the wind's speed without engine.
    turn_deg, shift_deg
        Greatest span of heading and of wind angle [degrees].
    change, mismatch
        Greatest span of speed, and difference from the ground, as shares of her speed.
    """

    around_s: float = 30.0
    settle_s: float = 60.0
    least_speed: float = 1.0 * MS_PER_KNOT
    least_wind: float = 3.0 * MS_PER_KNOT
    nearest_twa: float = 20.0
    fastest: float = 1.6
    turn_deg: float = 20.0
    shift_deg: float = 30.0
    change: float = 0.25
    mismatch: float = 0.25


CRUISING: Final = Rules()


def judged(log: Log, current: Vectors, *, span_s: float, rules: Rules = CRUISING) -> NDArray[np.int8]:
    """Judge every row of a log of means.

    Parameters
    ----------
    log
        With true wind and speed through the water, in the order of time.
    current
        ``(n,)`` [m/s], see `seacruise.yacht.logs.water`.
    span_s
        Length of the means [s].
    rules
        The limits.

    Returns
    -------
    NDArray[np.int8]
        ``(n,)``: `STEADY`, or the place of the first reason against it in `REASONS`.
    """
    half = max(round(rules.around_s / span_s), 1)
    near = _Neighbours(log.time, half, rules.around_s + span_s / 2)
    speed, twa = log.stw, np.abs(log.twa)
    with np.errstate(invalid="ignore"):
        against: tuple[Mask, ...] = (
            np.isnan(speed) | np.isnan(log.tws) | np.isnan(log.twa),
            near.share() < 0.5,
            speed < rules.least_speed,
            log.tws < rules.least_wind,
            (log.rpm > 0.0) | (twa < rules.nearest_twa) | (speed > rules.fastest * log.tws),
            _tacked(log, rules.settle_s),
            near.span_of_angle(log.heading) > rules.turn_deg,
            near.span_of_angle(log.twa) > rules.shift_deg,
            near.span(speed) > rules.change * speed,
            np.abs(np.abs(log.over_ground - current) - speed) > rules.mismatch * speed,
        )
    reason = np.full(len(log), STEADY, dtype=np.int8)
    for number in reversed(range(len(against))):
        reason[against[number]] = number
    return reason


class _Neighbours:
    """The rows around each row, no further away in time than is looked at."""

    def __init__(self, time: Array, half: int, reach_s: float) -> None:
        self._half = half
        around = self._windows(time)
        with np.errstate(invalid="ignore"):
            self._near = np.abs(around - time[:, np.newaxis]) <= reach_s

    def _windows(self, values: Array) -> Array:
        padded = np.pad(values, self._half, constant_values=np.nan)
        return np.asarray(sliding_window_view(padded, 2 * self._half + 1))

    def share(self) -> Array:
        return np.asarray(self._near.mean(axis=1))

    def _extent(self, windows: Array) -> Array:
        known = self._near & ~np.isnan(windows)
        high = np.where(known, windows, -np.inf).max(axis=1)
        low = np.where(known, windows, np.inf).min(axis=1)
        return np.asarray(np.where(known.any(axis=1), high - low, np.nan))

    def span(self, values: Array) -> Array:
        """Greatest less least value around each row."""
        return self._extent(self._windows(values))

    def span_of_angle(self, angle_deg: Array) -> Array:
        """Span of angles around each row [degrees], measured from its own."""
        return self._extent(signed_angle(self._windows(angle_deg) - angle_deg[:, np.newaxis]))


def _tacked(log: Log, settle_s: float) -> Mask:
    """Whether the wind came from the other side within the time that she needs to settle.

    Dead before the wind it comes from either side by turns without a gybe: there no side is taken.
    """
    off_axis = np.abs(np.abs(log.twa) - 90.0) < _SIDED
    known = np.flatnonzero(off_axis)
    changes = np.flatnonzero(np.diff(np.sign(log.twa[known]))) + 1
    times = np.concatenate(([-np.inf], log.time[known[changes]]))
    last = times[np.searchsorted(times, log.time, side="right") - 1]
    return np.asarray(log.time - last < settle_s)
