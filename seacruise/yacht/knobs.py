"""Honest knobs: what a crew and the sea take off the polar. None of them is used unless it is asked for.

Each function gives a share, 1 for the whole speed; they are multiplied with each other and with the
percentage of the polar. The figures are rules of thumb: no measurement of cruising yachts is known to us that
would give better ones. Whoever has a log of the yacht should set them by it.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import InputError

Array = NDArray[np.float64]
ArrayLike = Any

SUNSET_DEG: Final = -0.833
"""Altitude of the sun's centre at sunset, its radius and refraction considered [degrees]."""

DARK_DEG: Final = -6.0
"""Altitude of the sun at the end of civil twilight [degrees]."""

CALM_SEA_M: Final = 0.5
"""Significant wave height up to which a polar holds as it is [m]."""

LEAST_SHARE: Final = 0.4
"""No sea takes more than the rest: she would heave to, and no formula knows."""


def night_share(sun_altitude_deg: ArrayLike, *, at_night: float) -> Array:
    """Share of the speed that a crew keeps after dark.

    Whole by day, ``at_night`` once civil twilight has ended, and in between in proportion to the sun's
    altitude: crews reef and drop the spinnaker at dusk. A rule of thumb; short-handed crews commonly plan
    with 0.9, others with 0.95.

    Parameters
    ----------
    sun_altitude_deg
        Altitude of the sun above the horizon [degrees], any shape.
    at_night
        Share kept in the dark, above 0 and up to 1.

    Raises
    ------
    InputError
        The share is out of range.
    """
    if not 0.0 < at_night <= 1.0:
        raise InputError(f"A share of speed at night of {at_night:g} is out of range; give 0.1 to 1.")
    altitude = np.asarray(sun_altitude_deg, dtype=np.float64)
    dark = np.clip((SUNSET_DEG - altitude) / (SUNSET_DEG - DARK_DEG), 0.0, 1.0)
    return np.asarray(1.0 - (1.0 - at_night) * dark)


def sea_state_share(
    wave_height_m: ArrayLike, twa: ArrayLike, *, per_metre: float = 0.08, length_m: float = 10.0
) -> Array:
    """Share of the speed that the waves leave.

    With the height H above what a polar has in it, and the sea running with the wind::

        share = 1 - per_metre * max(0, H - 0.5 m) * (10 m / length) * (1 + cos twa)**2 / 4

    so that a metre more takes the whole of ``per_metre`` dead to windward, a quarter of it abeam, and nothing
    from astern (surfing is not counted); longer yachts lose less. A rule of thumb, never less than 0.4.

    Parameters
    ----------
    wave_height_m
        Significant wave height [m].
    twa
        Angle between heading and wind [degrees]; for a swell, between heading and swell. Broadcasts with
        the height.
    per_metre
        Share lost for each metre, head to sea, in a yacht of 10 m.
    length_m
        Length of the yacht [m].

    Raises
    ------
    InputError
        ``per_metre`` or the length is out of range.
    """
    if not 0.0 <= per_metre <= 1.0:
        raise InputError(f"A loss of {per_metre:g} a metre of waves is out of range; give 0 to 1.")
    if not 3.0 <= length_m <= 100.0:
        raise InputError(f"A length of {length_m:g} m is out of range; give 3 to 100 m.")
    height = np.maximum(np.asarray(wave_height_m, dtype=np.float64) - CALM_SEA_M, 0.0)
    ahead = (1.0 + np.cos(np.radians(twa))) ** 2 / 4.0
    return np.asarray(np.maximum(1.0 - per_metre * height * (10.0 / length_m) * ahead, LEAST_SHARE))
