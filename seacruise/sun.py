"""Where the sun stands: how much of a passage is sailed in the dark.

The low-precision formulas of the Astronomical Almanac (U.S. Naval Observatory, "Computing approximate solar
coordinates"): right to about a hundredth of a degree between 1950 and 2050, which is three seconds of time.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

CIVIL_TWILIGHT_DEG: Final = -6.0
"""Below this altitude the horizon and unlit marks can no longer be made out [degrees]."""

SUNRISE_DEG: Final = -0.833
"""Altitude of the sun's centre when its upper limb touches the horizon: half its width, and 34 minutes of
refraction [degrees] (Explanatory Supplement to the Astronomical Almanac)."""

_J2000: Final = 946_728_000.0
"""2000-01-01T12:00Z, from which the almanac counts [seconds since 1970]."""


def sun_altitude_deg(time: Any, lat: Any, lon: Any) -> Array:
    """Altitude of the sun's centre above the horizon, without refraction [degrees].

    Parameters
    ----------
    time
        Seconds since 1970-01-01T00:00Z; broadcasts with the positions.
    lat, lon
        Degrees.
    """
    days = (np.asarray(time, dtype=np.float64) - _J2000) / 86_400.0
    anomaly = np.radians(357.529 + 0.98560028 * days)
    mean_longitude = 280.459 + 0.98564736 * days
    longitude = np.radians(mean_longitude + 1.915 * np.sin(anomaly) + 0.020 * np.sin(2 * anomaly))
    obliquity = np.radians(23.439 - 0.00000036 * days)
    right_ascension = np.arctan2(np.cos(obliquity) * np.sin(longitude), np.cos(longitude))
    sine_of_declination = np.sin(obliquity) * np.sin(longitude)
    sidereal_deg = (18.697374558 + 24.06570982441908 * days) * 15.0
    hour_angle = np.radians(sidereal_deg + np.asarray(lon, dtype=np.float64)) - right_ascension
    phi = np.radians(np.asarray(lat, dtype=np.float64))
    sine = np.sin(phi) * sine_of_declination
    sine = sine + np.cos(phi) * np.sqrt(1.0 - sine_of_declination**2) * np.cos(hour_angle)
    return np.asarray(np.degrees(np.arcsin(np.clip(sine, -1.0, 1.0))))


def night_hours(time: Array, lat: Array, lon: Array) -> float:
    """Hours of a track during which the sun is below `CIVIL_TWILIGHT_DEG`.

    Parameters
    ----------
    time
        ``(n,)`` seconds since 1970, increasing; a sample every few minutes.
    lat, lon
        ``(n,)`` degrees.
    """
    middle = [(np.asarray(a[1:]) + np.asarray(a[:-1])) / 2 for a in (time, lat, lon)]
    dark = sun_altitude_deg(*middle) < CIVIL_TWILIGHT_DEG
    return float(np.diff(time)[dark].sum()) / 3600.0


@dataclass(frozen=True, slots=True)
class SunEvent:
    """Sunrise or sunset under way.

    Attributes
    ----------
    time
        Seconds since 1970.
    lat, lon
        Where the yacht is then [degrees].
    """

    kind: Literal["sunrise", "sunset"]
    time: float
    lat: float
    lon: float


def sun_events(time: Array, lat: Array, lon: Array) -> list[SunEvent]:
    """Sunrises and sunsets along a track, in their order.

    Parameters
    ----------
    time
        ``(n,)`` seconds since 1970, increasing; a sample every few minutes.
    lat, lon
        ``(n,)`` degrees.
    """
    above = sun_altitude_deg(time, lat, lon) - SUNRISE_DEG
    events = []
    for k in np.flatnonzero(np.sign(above[1:]) * np.sign(above[:-1]) < 0).tolist():
        share = float(above[k] / (above[k] - above[k + 1]))
        when, where_lat, where_lon = (float(a[k] + share * (a[k + 1] - a[k])) for a in (time, lat, lon))
        events.append(SunEvent("sunset" if above[k] > 0 else "sunrise", when, where_lat, where_lon))
    return events
