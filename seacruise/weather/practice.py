"""Practice weather: a generated week of two lows that cross the Baltic, for learning and for trying out.

It is never a forecast and says so wherever it is shown. What it is good for is that it behaves like
weather: winds veer and back as the lows pass, the strongest ones lie south of their tracks, and the air
at sea level crosses the isobars towards the low.

Model: each low is a Gaussian pressure dip ``p(r) = -dp exp(-r^2 / 2 L^2)`` that moves in a straight line.
Around it blows the gradient wind, the root of ``V^2 / r + f V = (1 / rho) dp/dr`` [1]_, with the Coriolis
parameter ``f`` of the latitude, plus half the low's own motion where its pressure dips [2]_. Friction at
sea takes it down to 0.7 of that at 10 m and turns it 18 degrees towards the low [3]_. Around all that
blows a westerly that swings and breathes slowly through the week.

References
----------
.. [1] Holton & Hakim, An Introduction to Dynamic Meteorology, 5th ed., section 3.2.
.. [2] Lin & Chavas (2012), doi:10.1029/2011JD017126: surface winds take up about half of the translation.
.. [3] WMO-No. 702, Guide to Wave Analysis and Forecasting, chapter 2: winds at sea are 60-75 % of the
   gradient wind and 15-20 degrees off the isobars.
"""

from __future__ import annotations

from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import EARTH_RADIUS
from seacruise.weather.wind import Forecast, Wind, describe_grid

SOURCE: Final = "Practice weather - generated, not a forecast"
NOTICE: Final = "Practice weather: generated, not a forecast."
HOURS: Final = 168
STEP_DEG: Final = 0.5
SOUTH, NORTH, WEST, EAST = 52.0, 67.0, 7.0, 32.0

_AIR_DENSITY: Final = 1.22
_EARTH_ROTATION: Final = 7.2921e-5
_FRICTION: Final = 0.7
_INFLOW_DEG: Final = 18.0
_TRANSLATION_SHARE: Final = 0.5

_Grid = NDArray[np.float32]


@dataclass(frozen=True, slots=True)
class _Low:
    """A moving low: where it is when [h after the begin], how it moves [m/s], how deep [Pa] and wide [m]."""

    lat: float
    lon: float
    hour: float
    east: float
    north: float
    depth: float
    width: float


def practice_wind(now: datetime, *, seed: int | None = None) -> Wind:
    """Generate the practice week that begins on the day of ``now``, 00:00 UTC.

    Parameters
    ----------
    now
        Timezone-aware; only its UTC day counts, so that a day's weather stays the same all day.
    seed
        Draws the lows; by default the day itself does, so that every day has its own weather.
    """
    begin = now.astimezone(UTC).replace(hour=0, minute=0, second=0, microsecond=0)
    rng = np.random.default_rng([begin.toordinal()] if seed is None else [seed])
    hour = np.arange(HOURS + 1, dtype=np.float32)[:, None, None]
    lat, lon = _axis(SOUTH, NORTH), _axis(WEST, EAST)
    u, v = _westerly(rng, hour)
    u, v = (np.broadcast_to(part, (HOURS + 1, lat.size, lon.size)).copy() for part in (u, v))
    for passing in (rng.uniform(30.0, 50.0), rng.uniform(100.0, 130.0)):
        _add_low(_draw_low(rng, passing), hour, (lat.astype(np.float32), lon.astype(np.float32)), (u, v))
    time = begin.timestamp() + 3600.0 * np.arange(HOURS + 1, dtype=np.float64)
    valid_from, valid_to, step_h, resolution = describe_grid(time, lat, lon)
    forecast = Forecast(
        source=SOURCE,
        issued=begin,
        valid_from=valid_from,
        valid_to=valid_to,
        step_h=step_h,
        resolution_deg=resolution,
        notice=NOTICE,
        real=False,
    )
    return Wind(time=time, lat=lat, lon=lon, u=u, v=v, forecast=forecast)


def _axis(first: float, last: float) -> NDArray[np.float64]:
    return np.linspace(first, last, round((last - first) / STEP_DEG) + 1)


def _draw_low(rng: np.random.Generator, passing: float) -> _Low:
    """Draw a low that is over the middle Baltic at an hour, moving between east and north-east."""
    pace, heading = rng.uniform(7.0, 11.0), np.radians(rng.uniform(50.0, 85.0))
    return _Low(
        lat=rng.uniform(58.0, 62.0),
        lon=rng.uniform(17.0, 22.0),
        hour=passing,
        east=pace * float(np.sin(heading)),
        north=pace * float(np.cos(heading)),
        depth=rng.uniform(1300.0, 2300.0),
        width=rng.uniform(260e3, 400e3),
    )


def _westerly(rng: np.random.Generator, hour: _Grid) -> tuple[_Grid, _Grid]:
    """Draw the wind around the lows: from between south-west and north-west, swinging and breathing."""
    phase, swell = rng.uniform(0.0, 2 * np.pi, size=2)
    towards = np.radians(40.0) * np.sin(2 * np.pi * hour / rng.uniform(90.0, 150.0) + phase)
    strength = rng.uniform(3.0, 5.5) * (1.0 + 0.4 * np.sin(2 * np.pi * hour / 54.0 + swell))
    return (strength * np.cos(towards)).astype(np.float32), (strength * np.sin(towards)).astype(np.float32)


def _add_low(low: _Low, hour: _Grid, axes: tuple[_Grid, _Grid], wind: tuple[_Grid, _Grid]) -> None:
    """Add the 10 m wind of one low to ``u, v`` in place; float32 throughout, it is a picture of weather."""
    lat, lon = axes[0][None, :, None], axes[1][None, None, :]
    metres = np.float32(EARTH_RADIUS * np.pi / 180.0)
    seconds = (hour - np.float32(low.hour)) * np.float32(3600.0)
    shrink = np.cos(np.radians(lat))
    x = (lon - np.float32(low.lon)) * metres * shrink - seconds * np.float32(low.east)
    y = (lat - np.float32(low.lat)) * metres - seconds * np.float32(low.north)
    square = x * x + y * y
    dip = np.exp(square * np.float32(-0.5 / low.width**2))
    coriolis = (2 * _EARTH_ROTATION * np.sin(np.radians(lat))).astype(np.float32)
    # with dp/dr = depth r/L^2 dip both roots below carry a factor r; V/r needs no division at the centre
    turning = (
        np.sqrt(coriolis**2 / 4 + np.float32(low.depth / low.width**2 / _AIR_DENSITY) * dip) - coriolis / 2
    )
    along, across = _FRICTION * np.cos(np.radians(_INFLOW_DEG)), _FRICTION * np.sin(np.radians(_INFLOW_DEG))
    carried = np.float32(_TRANSLATION_SHARE * _FRICTION) * dip
    u, v = wind
    u += turning * (np.float32(-along) * y - np.float32(across) * x) + carried * np.float32(low.east)
    v += turning * (np.float32(along) * x - np.float32(across) * y) + carried * np.float32(low.north)
