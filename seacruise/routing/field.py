"""Wind and polar in the shape in which compiled loops read them fastest."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.units import MS_PER_KNOT
from seacruise.weather.wind import Wind
from seacruise.yacht.hull import hull_speed
from seacruise.yacht.polar import Polar

TOP_TWS: Final = 40.0
"""Strongest wind in the speed table [m/s]; above it the last row holds."""

PER_TWS: Final = 4.0
"""Rows of the speed table per m/s."""

COSINES: Final = 513
"""Columns of the speed table, even in the cosine of the wind angle: a beat's 1 / cos is smooth in it."""

FINE_SLICE_S: Final = 900.0
COARSE_SLICE_S: Final = 3600.0
"""Lengths of the slices of time [s]: for relaxing waypoints, and for the first look at the whole area."""

MOST_BYTES: Final = 96 * 2**20
"""A field larger than this gets longer slices instead."""


@dataclass(frozen=True, slots=True, eq=False)
class WindField:
    """A `Wind` cut into slices of time; ``arrays`` is what `seacruise.routing._kernels` calls ``wind``.

    Attributes
    ----------
    horizon
        Seconds since 1970 at which the forecast ends; the last slice, from there on, holds for ever.
    strongest, mean
        Greatest and mean wind speed in the field [m/s].
    """

    arrays: tuple[Any, ...]
    horizon: float
    strongest: float
    mean: float


def wind_field(wind: Wind, *, slice_s: float = FINE_SLICE_S, since: float | None = None) -> WindField:
    """Interpolate the wind to the middle of even slices of time.

    Parameters
    ----------
    slice_s
        Length of a slice [s]; longer ones are taken where the field would get too large.
    since
        Seconds since 1970 from which it is needed; the begin of the forecast by default.
    """
    begin, end = float(wind.time[0]), float(wind.time[-1])
    if since is not None:
        begin = min(max(begin, np.floor((since - begin) / slice_s) * slice_s + begin), end)
    nodes = wind.u.shape[1] * wind.u.shape[2]
    step = slice_s
    while (end - begin) / step * nodes * 8 > MOST_BYTES:
        step *= 2
    count = int(np.ceil((end - begin) / step))
    middles = np.append(np.minimum(begin + (np.arange(count) + 0.5) * step, end), end)
    u, v = _at_times(wind, middles)
    if wind.lat.size == 1:
        u, v = np.repeat(u, 2, axis=1), np.repeat(v, 2, axis=1)
    if wind.lon.size == 1:
        u, v = np.repeat(u, 2, axis=2), np.repeat(v, 2, axis=2)
    per_lat = 1.0 / float(wind.lat[1] - wind.lat[0]) if wind.lat.size > 1 else 0.0
    per_lon = 1.0 / float(wind.lon[1] - wind.lon[0]) if wind.lon.size > 1 else 0.0
    tws = np.hypot(u, v)
    arrays = (u, v, begin, step, float(wind.lat[0]), per_lat, float(wind.lon[0]), per_lon)
    return WindField(arrays, end, float(tws.max()), float(tws.mean()))


def _at_times(wind: Wind, times: NDArray[np.float64]) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    if wind.time.size == 1:
        shape = (times.size, *wind.u.shape[1:])
        return np.broadcast_to(wind.u, shape).copy(), np.broadcast_to(wind.v, shape).copy()
    after = np.clip(np.searchsorted(wind.time, times, side="right"), 1, wind.time.size - 1)
    share = (times - wind.time[after - 1]) / (wind.time[after] - wind.time[after - 1])
    part = share.astype(np.float32)[:, None, None]

    def between(component: NDArray[np.float32]) -> NDArray[np.float32]:
        return np.ascontiguousarray(component[after - 1] * (1 - part) + component[after] * part)

    return between(wind.u), between(wind.v)


@dataclass(frozen=True, slots=True)
class Handling:
    """How this crew sails this yacht: everything that changes her speed in a given wind.

    Attributes
    ----------
    tacking
        Make good the convex hull of the polar (beats and runs); else the polar as it is.
    share
        Part of the polar's speed that is reached, 1 for all of it.
    motor_below, motor_speed
        Engine on when she would make less than this under sail [m/s], and what it gives [m/s].
    max_wind
        Never sail in more than this [m/s].
    """

    tacking: bool = True
    share: float = 1.0
    motor_below: float | None = None
    motor_speed: float = 0.0
    max_wind: float | None = None


@dataclass(frozen=True, slots=True, eq=False)
class SpeedTable:
    """Boat speed by TWS and cosine of TWA; ``arrays`` is what the kernels call ``speeds``.

    Attributes
    ----------
    top
        ``(w,)`` greatest speed [m/s] in winds up to each row's, for bounds.
    """

    arrays: tuple[NDArray[np.float32], float]
    top: NDArray[np.float64]

    def fastest(self, strongest: float) -> float:
        """Greatest speed [m/s] in winds up to ``strongest`` [m/s]."""
        row = min(int(np.ceil(strongest * PER_TWS)), self.top.size - 1)
        return float(self.top[row])


def speed_table(polar: Polar, handling: Handling) -> SpeedTable:
    """Tabulate a polar, finely enough that looking it up costs less than 0.05 % of speed."""
    tws = np.arange(int(TOP_TWS * PER_TWS) + 2) / PER_TWS
    twa = np.degrees(np.arccos(np.linspace(-1.0, 1.0, COSINES)))
    if handling.tacking:
        degrees = np.linspace(0.0, 180.0, 721)
        by_degree = hull_speed(polar, tws, degrees)
        table = np.array([np.interp(twa, degrees, row) for row in by_degree])
    else:
        table = polar.speed(tws[:, None], twa[None, :])
    table = table * handling.share
    if handling.motor_below is not None:
        table = np.where(table < handling.motor_below, np.maximum(table, handling.motor_speed), table)
    top = np.maximum.accumulate(table.max(axis=1))
    if handling.max_wind is not None:
        table[tws > handling.max_wind + 1e-9] = -1.0
    return SpeedTable((np.ascontiguousarray(table, dtype=np.float32), PER_TWS), top)


def handling_in_knots(
    *,
    tacking: bool,
    percent: float,
    motor_below_kn: float | None,
    motor_speed_kn: float,
    max_wind_kn: float | None,
) -> Handling:
    """Make `Handling` of the figures a sailor gives."""
    return Handling(
        tacking=tacking,
        share=percent / 100.0,
        motor_below=None if motor_below_kn is None else motor_below_kn * MS_PER_KNOT,
        motor_speed=motor_speed_kn * MS_PER_KNOT,
        max_wind=None if max_wind_kn is None else max_wind_kn * MS_PER_KNOT,
    )
