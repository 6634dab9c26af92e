"""The true wind that a polar speaks of: the one over the water.

``true = apparent - own motion`` in the boat's frame. The motion through the water gives the wind over the
water; leeway and the upwash of the sails are left out, so angles close to the wind read a few degrees too
high or low on all yachts alike.

A vane that was not fixed straight makes every yacht point higher on one tack than on the other. The ground
cannot tell it, since it turns all winds alike; the yacht can: she beats at one angle on both tacks.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from seacruise.yacht.logs.log import Array, Log, angle_of, signed_angle, vector

_BEATING: Final = (8.0, 48.0)
"""Apparent wind angles among which a beat is looked for [degrees]."""

_BIN: Final = 0.25
_BINS: Final = np.arange(_BEATING[0], _BEATING[1] + _BIN / 2.0, _BIN)
_WINDOW: Final = np.exp(-0.5 * (np.arange(-9.0, 9.0 + _BIN, _BIN) / 3.0) ** 2)
"""Classes of angles [degrees], and the bell of 3 degrees that smooths them."""

_LEAST_BEAT_S: Final = 300.0
_LIKE_WIND: Final = 1.5
"""Width of a class of apparent wind speed [m/s]."""

_WORST_VANE: Final = 15.0


@dataclass(frozen=True, slots=True)
class Vane:
    """How the vane is turned.

    Attributes
    ----------
    offset_deg
        What apparent wind angles must be increased by [degrees].
    starboard_deg, port_deg
        Apparent angle, off the bow, at which she beat most on either tack, as logged.
    """

    offset_deg: float
    starboard_deg: float
    port_deg: float


def vane_of(log: Log, *, span_s: float) -> Vane | None:
    """Find how the vane is turned, from the beats on both tacks.

    Parameters
    ----------
    log
        Means over some seconds.
    span_s
        How long each is [s].

    Returns
    -------
    Vane or None
        ``None`` with less than five minutes of beating on either tack, or where the two angles differ so
        much that something else is wrong.
    """
    beating = (np.abs(log.awa) >= _BEATING[0]) & (np.abs(log.awa) <= _BEATING[1]) & (log.stw > 1.0)
    angle, strength = log.awa[beating], np.floor(log.aws[beating] / _LIKE_WIND)
    sides = [side * angle[side * angle > 0.0] for side in (1.0, -1.0)]
    if min(side.size for side in sides) * span_s < _LEAST_BEAT_S:
        return None
    differences = np.zeros(2 * _BINS.size - 3)
    # She points lower in a light wind, so tacks are compared in winds alike.
    for each in np.unique(strength):
        starboard, port = (
            np.histogram(side * angle[strength == each], _BINS)[0].astype(np.float64) for side in (1.0, -1.0)
        )
        most = max(float(starboard.sum()), float(port.sum()))
        # How often an angle on port is so much wider than one on starboard, over all pairs.
        differences += np.correlate(port, starboard, mode="full") / most
    if not differences.any():
        return None
    offset = float(_BIN * (np.argmax(np.convolve(differences, _WINDOW, mode="same")) - _BINS.size + 2)) / 2.0
    return Vane(offset, *(_mode(side) for side in sides)) if abs(offset) <= _WORST_VANE else None


def _mode(values: Array) -> float:
    """Most frequent value, of a histogram smoothed by 3 degrees."""
    density = np.convolve(np.histogram(values, _BINS)[0], _WINDOW, mode="same")
    return float(_BINS[np.argmax(density)] + _BIN / 2.0)


def with_vane_turned(log: Log, offset_deg: float) -> Log:
    """Turn the apparent wind by an offset of the vane; the logged true wind rests on it and is dropped."""
    apparent = ~np.isnan(log.awa)
    return replace(
        log,
        awa=signed_angle(log.awa + offset_deg),
        twa=np.where(apparent, np.nan, log.twa),
        tws=np.where(apparent, np.nan, log.tws),
    )


def with_true_wind(log: Log) -> Log:
    """Compute the true wind from the apparent one; keep the logged one where that is not possible.

    Instruments compute it as well, but some from the speed over ground and some with a lag. What the
    yacht's own processor said remains only where there is no apparent wind.
    """
    true = vector(log.aws, log.awa) - log.stw
    known = ~np.isnan(true)
    return replace(
        log,
        twa=np.where(known, signed_angle(angle_of(true)), log.twa),
        tws=np.where(known, np.abs(true), log.tws),
    )
