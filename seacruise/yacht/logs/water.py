"""What the water does to a log: the log's own error, the compass's, and the current.

Over the ground she moves as through the water, plus the current: ``g = k w + c``. With the factor ``k`` as
a complex number it holds both faults of the instruments at once: its length is what the log's figures must
be multiplied by, its angle what must be added to the compass. Within some minutes the current hardly
changes, so the differences of ``g`` and ``w`` from their means tell ``k``, and the means then tell ``c`` -
if she sailed more than one course.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from seacruise.yacht.logs.log import Array, Log, Mask, Vectors, angle_of, vector

BLOCK_S: Final = 600.0
"""How long the current is taken as constant [s]."""

_LEAST_ROWS: Final = 60
_LEAST_SPREAD: Final = 0.7
"""Least spread of the courses: 0 on one course for ever, 1 when all courses are sailed alike."""

_TRUST: Final = 0.02
"""A factor is used when its standard error is below this."""

_INDEPENDENT_S: Final = 75.0
"""Rows are as good as independent after this long [s]: measured on the residuals of real logs."""


@dataclass(frozen=True, slots=True)
class Calibration:
    """What the ground says about log and compass.

    Attributes
    ----------
    log_factor
        What speeds through the water must be multiplied by.
    compass_offset_deg
        What headings must be increased by [degrees]: variation and deviation, where they were not known.
    error
        Standard error of the factor; of the offset, in radians, it is the same.
    trusted
        Whether courses and rows suffice for using it.
    """

    log_factor: float
    compass_offset_deg: float
    error: float
    trusted: bool


def calibrated(log: Log, *, block_s: float = BLOCK_S) -> Calibration | None:
    """Hold log and compass against the ground.

    Parameters
    ----------
    log
        Means over some seconds, see `seacruise.yacht.logs.average`.
    block_s
        How long the current is taken as constant [s].

    Returns
    -------
    Calibration or None
        ``None`` where speed through the water, heading or ground are missing.
    """
    ground, water = log.over_ground, log.through_water
    known = ~np.isnan(ground) & ~np.isnan(water) & (log.stw > 0.5)
    if known.sum() < _LEAST_ROWS:
        return None
    g, w = ground[known], water[known]
    block = np.floor(log.time[known] / block_s)
    spread = 1.0 - float(np.abs(np.mean(w / np.abs(w))))
    g, w = g - _block_means(g, block), w - _block_means(w, block)
    keep = np.ones(g.size, dtype=np.bool_)
    factor = 1.0 + 0.0j
    for _ in range(10):
        power = float(np.sum(np.abs(w[keep]) ** 2))
        factor = complex(np.sum(np.conj(w[keep]) * g[keep])) / max(power, 1e-12)
        off = np.abs(g - factor * w)
        # Manoeuvres and a log that sticks are far off; they must not decide.
        keep = off <= 3.0 * max(float(np.median(off)), 1e-6)
    spacing = float(np.median(np.diff(log.time))) if len(log) > 1 else 1.0
    independent = max(keep.sum() * spacing / _INDEPENDENT_S, 1.0)
    residual = float(np.mean(np.abs(g[keep] - factor * w[keep]) ** 2)) / 2.0
    signal = max(float(np.mean(np.abs(w[keep]) ** 2)), 1e-12)
    error = float(np.sqrt(residual / signal / independent))
    trusted = spread >= _LEAST_SPREAD and error <= _TRUST
    return Calibration(abs(factor), float(np.degrees(np.angle(factor))), error, trusted)


def _block_means(values: Vectors, block: Array) -> Vectors:
    """Mean of the block that each value is in."""
    _, of = np.unique(block, return_inverse=True)
    count = np.bincount(of)
    mean = (np.bincount(of, values.real) + 1j * np.bincount(of, values.imag)) / count
    return np.asarray(mean[of])


def corrected(log: Log, calibration: Calibration) -> Log:
    """Correct speeds through the water and headings by what the ground said."""
    return replace(
        log,
        stw=log.stw * calibration.log_factor,
        heading=(log.heading + calibration.compass_offset_deg) % 360.0,
    )


def estimated_current(log: Log, *, block_s: float = BLOCK_S) -> Vectors:
    """Estimate the current [m/s] at each row: what remains of the ground's motion in each block of time.

    Parameters
    ----------
    log
        With speed through the water and heading, best `corrected`.
    block_s
        How long the current is taken as constant [s].

    Returns
    -------
    Vectors
        ``(n,)``, where the water goes to; 0 where it cannot be told.
    """
    drift = log.over_ground - log.through_water
    known = ~np.isnan(drift)
    current = np.zeros(len(log), dtype=np.complex128)
    if not known.any():
        return current
    number = np.floor(log.time / block_s)
    for block in np.unique(number[known]):
        here = number == block
        # The median does not mind a tack, in which the log lags behind the receiver.
        parts = drift[here & known]
        current[here] = np.median(parts.real) + 1j * np.median(parts.imag)
    return current


def given_current(log: Log, set_deg: float, drift: float) -> Vectors:
    """Give a known current [degrees true it sets TO, m/s] to each row."""
    return np.full(len(log), complex(vector(drift, set_deg)))


def without_current(log: Log, current: Vectors) -> tuple[Log, Mask]:
    """Fill in the motion through the water where it was not logged: the ground's, less the current.

    Returns
    -------
    log, filled
        The log with speeds through the water and headings, and which speeds were filled in.
    """
    water = log.over_ground - current
    filled = np.isnan(log.stw) & ~np.isnan(water)
    stw = np.where(filled, np.abs(water), log.stw)
    heading = np.where(np.isnan(log.heading), angle_of(water) % 360.0, log.heading)
    return replace(log, stw=stw, heading=heading), filled
