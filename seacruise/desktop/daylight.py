"""Day and night along a passage: which parts are sailed in the dark, and where the sun rises and sets."""

from __future__ import annotations

from enum import IntEnum
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from seacruise import sun
from seacruise.sun import CIVIL_TWILIGHT_DEG, SUNRISE_DEG, SunEvent, sun_altitude_deg

if TYPE_CHECKING:
    from seacruise.passage import Track


class Light(IntEnum):
    """How light it is."""

    DAY = 0
    TWILIGHT = 1
    NIGHT = 2


def light_along(track: Track) -> NDArray[np.int64]:
    """`Light` at each sample of a track, ``(n,)``."""
    altitude = sun_altitude_deg(track.time, track.lat, track.lon)
    return (altitude < SUNRISE_DEG).astype(np.int64) + (altitude < CIVIL_TWILIGHT_DEG)


def light_at(time: float, lat: float, lon: float) -> Light:
    """Tell how light it is at a time [s since 1970] and place [degrees]."""
    altitude = float(sun_altitude_deg(time, lat, lon))
    return Light(int(altitude < SUNRISE_DEG) + int(altitude < CIVIL_TWILIGHT_DEG))


def sun_events(track: Track) -> list[SunEvent]:
    """Sunrises and sunsets along a track, in their order."""
    return sun.sun_events(track.time, track.lat, track.lon)


def spans(classes: NDArray[np.int64]) -> list[tuple[int, int, int]]:
    """Find runs of equal classes: class, first and last sample; each begins where the one before ends."""
    if len(classes) < 2:
        return []
    changes = (np.flatnonzero(np.diff(classes)) + 1).tolist()
    bounds = [0, *changes, len(classes) - 1]
    return [(int(classes[a]), a, b) for a, b in pairwise(bounds) if b > a]
