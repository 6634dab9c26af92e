"""Wind and polar in the shape in which compiled loops read them fastest."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.sun import sun_altitude_deg
from seacruise.units import MS_PER_KNOT
from seacruise.weather.wind import Current, Flow, Wind
from seacruise.yacht.hull import hull_speed
from seacruise.yacht.knobs import CALM_SEA_M, night_share
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
    drift
        Strongest current [m/s].
    slices
        ``(3, t)`` strongest wind, mean wind and strongest current of each slice [m/s].
    """

    arrays: tuple[Any, ...]
    horizon: float
    strongest: float
    mean: float
    drift: float = 0.0
    slices: NDArray[np.float64] | None = None

    def later(self, since: float) -> WindField:
        """Give the part from the slice on in which a time lies [s since 1970]; nothing is copied."""
        u, v, begin, step, *rest = self.arrays
        past = int(np.clip((since - begin) // step, 0, len(u) - 1))
        if past == 0 or self.slices is None:
            return self

        def cut(part: Any) -> Any:
            if isinstance(part, tuple):
                return tuple(cut(one) for one in part)
            return part[past:] if isinstance(part, np.ndarray) and len(part) == len(u) else part

        slices = self.slices[:, past:]
        strongest, mean, drift = float(slices[0].max()), float(slices[1].mean()), float(slices[2].max())
        arrays = (cut(u), cut(v), begin + past * step, step, *map(cut, rest))
        return WindField(arrays, self.horizon, strongest, mean, drift, slices)

    def fastest(self, speeds: SpeedTable, strongest: float | None = None) -> float:
        """Greatest speed over ground [m/s] in winds up to ``strongest`` [m/s], by default the field's."""
        wind = self.strongest if strongest is None else strongest
        return speeds.fastest(wind + self.drift) + self.drift

    def fastest_each(self, speeds: SpeedTable, strongest: NDArray[np.float64]) -> NDArray[np.float64]:
        """`fastest` in winds up to each of some speeds ``(n,)`` [m/s]."""
        row = np.ceil((np.asarray(strongest, dtype=np.float64) + self.drift) * PER_TWS).astype(np.int64)
        return np.asarray(speeds.top[np.minimum(row, speeds.top.size - 1)] + self.drift)


_NONE: Final = np.empty((0, 2, 2), dtype=np.float32)
STILL_WATER: Final = (_NONE, _NONE, 0.0, 0.0, 0.0, 0.0)
NO_DANGER: Final = _NONE
"""Parts of ``arrays`` where there is no current, and no limit of gusts or waves."""


@dataclass(frozen=True, slots=True)
class SeaLimits:
    """What crew and yacht allow of gusts [m/s] and of significant wave heights [m]; ``None`` for all."""

    max_gust: float | None = None
    max_wave: float | None = None


NO_LIMITS: Final = SeaLimits()


@dataclass(frozen=True, slots=True)
class Knobs:
    """What night and waves take off her speed, see `seacruise.yacht.knobs`.

    Attributes
    ----------
    at_night
        Share of the speed that the crew keeps in the dark.
    per_metre
        Share lost head to sea for each metre of waves above what a polar has in it.
    below, motor_speed
        The engine [m/s], which neither of them slows down; it starts below the first.
    """

    at_night: float = 1.0
    per_metre: float = 0.0
    below: float = -1.0
    motor_speed: float = 0.0

    @property
    def turned(self) -> bool:
        """Whether anything slows her down."""
        return self.at_night < 1.0 or self.per_metre > 0.0


NO_KNOBS: Final = Knobs()


def wind_field(
    wind: Wind,
    *,
    slice_s: float = FINE_SLICE_S,
    since: float | None = None,
    current: Current | None = None,
    limits: SeaLimits = NO_LIMITS,
    knobs: Knobs = NO_KNOBS,
) -> WindField:
    """Interpolate wind, current, gusts and waves to the middle of even slices of time.

    Parameters
    ----------
    slice_s
        Length of a slice [s]; longer ones are taken where the field would get too large.
    since
        Seconds since 1970 from which it is needed; the begin of the forecast by default.
    current
        Where the water moves; beyond its own times and edges the nearest value is taken.
    limits
        Gusts and waves in which nobody sails; where the forecast has none they forbid nothing.
    knobs
        What night and waves take off her speed.
    """
    begin, end = float(wind.time[0]), float(wind.time[-1])
    horizon = end
    if current is not None:
        end = max(end, float(current.time[-1]))
    if since is not None:
        begin = min(max(begin, _slice_of(since, begin, slice_s)), end)
    nodes = wind.u.shape[1] * wind.u.shape[2]
    if current is not None:
        nodes += current.u.shape[1] * current.u.shape[2]
    step = slice_s
    while (end - begin) / step * nodes * 8 > MOST_BYTES:
        step *= 2
    count = int(np.ceil((end - begin) / step))
    middles = np.append(np.minimum(begin + (np.arange(count) + 0.5) * step, end), end)
    u, v = (_at_times(wind, component, middles) for component in (wind.u, wind.v))
    stream: tuple[Any, ...] = STILL_WATER
    drift = np.zeros(middles.size)
    if current is not None:
        cu, cv = (_at_times(current, component, middles) for component in (current.u, current.v))
        stream, drift = (cu, cv, *_frame(current)), np.hypot(cu, cv).max(axis=(1, 2))
    tws = np.hypot(u, v)
    slices = np.array([tws.max(axis=(1, 2)), tws.mean(axis=(1, 2)), drift], dtype=np.float64)
    danger = _danger(wind, limits, middles)
    arrays: tuple[Any, ...] = (u, v, begin, step, *_frame(wind))
    slowed = _slowed(wind, knobs, middles)
    if current is not None or danger is not NO_DANGER or knobs.turned:
        arrays = (*arrays, stream, danger, slowed)
    return WindField(arrays, horizon, float(tws.max()), float(slices[1].mean()), float(drift.max()), slices)


def _slice_of(since: float, begin: float, slice_s: float) -> float:
    """Begin of the slice in which a time lies [s since 1970]."""
    return float(np.floor((since - begin) / slice_s) * slice_s + begin)


_KEPT_BYTES: Final = 32 * 2**20
_KEPT: Final = 4


@lru_cache(maxsize=_KEPT)
def _made(wind: Wind, current: Current | None, **how: Any) -> WindField:
    return wind_field(wind, current=current, **how)


def kept_field(
    wind: Wind,
    *,
    slice_s: float,
    since: float,
    current: Current | None,
    limits: SeaLimits,
    knobs: Knobs,
) -> WindField:
    """Give the part of a `wind_field` made before: all departures share it.

    Large ones are made anew: a few of them would fill the memory of a small computer.
    """
    ends = [float(flow.time[-1]) for flow in (wind, current) if flow is not None]
    slices = (max(ends) - float(wind.time[0])) / slice_s + 1.0
    nodes = wind.u[0].size + (current.u[0].size if current is not None else 0)
    if slices * nodes * 8 > _KEPT_BYTES:
        return wind_field(wind, slice_s=slice_s, since=since, current=current, limits=limits, knobs=knobs)
    return _made(wind, current, slice_s=slice_s, limits=limits, knobs=knobs).later(since)


def _frame(flow: Flow) -> tuple[float, float, float, float]:
    """First latitude, rows per degree, first longitude, columns per degree; 0 per degree for a single one."""
    per_lat = 1.0 / float(flow.lat[1] - flow.lat[0]) if flow.lat.size > 1 else 0.0
    per_lon = 1.0 / float(flow.lon[1] - flow.lon[0]) if flow.lon.size > 1 else 0.0
    return float(flow.lat[0]), per_lat, float(flow.lon[0]), per_lon


def _at_times(flow: Flow, grid: NDArray[np.float32], times: NDArray[np.float64]) -> NDArray[np.float32]:
    """Interpolate a grid ``(t, y, x)`` of a flow in time; both axes of space get at least two nodes."""
    if flow.time.size == 1:
        at = np.broadcast_to(grid, (times.size, *grid.shape[1:])).copy()
    else:
        after = np.clip(np.searchsorted(flow.time, times, side="right"), 1, flow.time.size - 1)
        share = (times - flow.time[after - 1]) / (flow.time[after] - flow.time[after - 1])
        part = np.clip(share, 0.0, 1.0).astype(np.float32)[:, None, None]
        at = np.ascontiguousarray(grid[after - 1] * (1 - part) + grid[after] * part)
    for axis in (1, 2):
        if at.shape[axis] == 1:
            at = np.repeat(at, 2, axis=axis)
    return at


def _slowed(wind: Wind, knobs: Knobs, times: NDArray[np.float64]) -> tuple[Any, Any, float, float]:
    """Share that the night leaves and share that waves take head to sea, and the engine."""
    ease = rough = _NONE
    if knobs.at_night < 1.0:
        lat, lon = (axis if axis.size > 1 else np.repeat(axis, 2) for axis in (wind.lat, wind.lon))
        altitude = sun_altitude_deg(times[:, None, None], lat[:, None], lon)
        ease = night_share(altitude, at_night=knobs.at_night).astype(np.float32)
    if knobs.per_metre > 0.0 and wind.wave is not None:
        rough = _at_times(wind, wind.wave, times)
        rough = np.maximum(rough - np.float32(CALM_SEA_M), 0.0) * np.float32(knobs.per_metre)
    return ease, rough, knobs.below, knobs.motor_speed


def _danger(wind: Wind, limits: SeaLimits, times: NDArray[np.float64]) -> NDArray[np.float32]:
    """Gusts and waves as shares of what is allowed, the worse of both; without slices where all is."""
    shares = [
        _at_times(wind, grid, times) / np.float32(max(limit, 1e-3))
        for grid, limit in ((wind.gust, limits.max_gust), (wind.wave, limits.max_wave))
        if grid is not None and limit is not None
    ]
    return np.maximum.reduce(shares) if shares else NO_DANGER


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
    limits
        Gusts and waves in which she does not sail.
    pauses
        Seconds that a tack costs, a gybe, and each degree of a turn.
    at_night, per_metre
        What night and waves leave of her speed and take off it, see `Knobs`.
    """

    tacking: bool = True
    share: float = 1.0
    motor_below: float | None = None
    motor_speed: float = 0.0
    max_wind: float | None = None
    limits: SeaLimits = NO_LIMITS
    pauses: tuple[float, float, float] = (0.0, 0.0, 0.0)
    at_night: float = 1.0
    per_metre: float = 0.0

    @property
    def knobs(self) -> Knobs:
        """What slows her down under sail, and the engine, which it does not."""
        below = -1.0 if self.motor_below is None else self.motor_below
        return Knobs(self.at_night, self.per_metre, below, self.motor_speed if below > 0.0 else 0.0)

    def within(self, share: float) -> Handling:
        """Give the same with all limits of wind, gusts and waves reduced to a share."""

        def part(limit: float | None) -> float | None:
            return None if limit is None else limit * share

        limits = SeaLimits(part(self.limits.max_gust), part(self.limits.max_wave))
        return replace(self, max_wind=part(self.max_wind), limits=limits)


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
    table = _tabulated(polar, handling.tacking) * handling.share
    top = table.max(axis=1)
    if handling.motor_below is not None:
        motored = np.where(table < handling.motor_below, np.maximum(table, handling.motor_speed), table)
        top = motored.max(axis=1)
        # Where night or waves slow her down first, the kernels start the engine.
        table = table if handling.knobs.turned else motored
    top = np.maximum.accumulate(top)
    if handling.max_wind is not None:
        table[tws > handling.max_wind + 1e-9] = -1.0
    return SpeedTable((np.ascontiguousarray(table, dtype=np.float32), PER_TWS), top)


@lru_cache(maxsize=8)
def _tabulated(polar: Polar, tacking: bool) -> NDArray[np.float64]:
    """Table of a polar or of its hull, kept: it takes thirty times longer than what a crew changes in it."""
    tws = np.arange(int(TOP_TWS * PER_TWS) + 2) / PER_TWS
    twa = np.degrees(np.arccos(np.linspace(-1.0, 1.0, COSINES)))
    if not tacking:
        return polar.speed(tws[:, None], twa[None, :])
    degrees = np.linspace(0.0, 180.0, 721)
    return np.array([np.interp(twa, degrees, row) for row in hull_speed(polar, tws, degrees)])


def tacking_may_gain(
    polar: Polar, tws: NDArray[np.float64], twa: NDArray[np.float64], *, least: float
) -> NDArray[np.bool_]:
    """Tell where the hull of a polar may be faster than the polar itself, by a share of at least ``least``.

    Looked up in the tables of the search at the four entries around each point, so that `hull_headings`,
    which takes a thousand times longer, need not be asked on a reach.

    Parameters
    ----------
    tws, twa
        ``(n,)`` true wind speeds [m/s] and angles [degrees].
    """
    hull, straight = _tabulated(polar, True), _tabulated(polar, False)
    row = np.minimum((tws * PER_TWS).astype(np.int64), hull.shape[0] - 2)
    column = ((np.cos(np.radians(twa)) + 1.0) / 2.0 * (COSINES - 1)).astype(np.int64)
    column = np.clip(column, 0, COSINES - 2)
    gains = hull > straight * (1.0 + least)
    return np.asarray(
        gains[row, column] | gains[row, column + 1] | gains[row + 1, column] | gains[row + 1, column + 1]
    )


def handling_in_knots(
    *,
    tacking: bool,
    percent: float,
    motor_below_kn: float | None,
    motor_speed_kn: float,
    max_wind_kn: float | None,
    max_gust_kn: float | None = None,
    max_wave_m: float | None = None,
    tack_min: float = 0.0,
    gybe_min: float = 0.0,
    turn_min_per_10_deg: float = 0.0,
    percent_at_night: float = 100.0,
    sea_state_percent: float = 0.0,
) -> Handling:
    """Make `Handling` of the figures a sailor gives; minutes for manoeuvres."""

    def speed(knots: float | None) -> float | None:
        return None if knots is None else knots * MS_PER_KNOT

    return Handling(
        tacking=tacking,
        share=percent / 100.0,
        motor_below=speed(motor_below_kn),
        motor_speed=motor_speed_kn * MS_PER_KNOT,
        max_wind=speed(max_wind_kn),
        limits=SeaLimits(speed(max_gust_kn), max_wave_m),
        pauses=(tack_min * 60.0, gybe_min * 60.0, turn_min_per_10_deg * 6.0),
        at_night=percent_at_night / 100.0,
        per_metre=sea_state_percent / 100.0,
    )
