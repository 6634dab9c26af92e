"""What a service says about places, hour by hour, and how many places become one grid."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import WeatherError
from seacruise.weather.points import PointPlan, spread

Array = NDArray[np.float64]
Grid = NDArray[np.float32]

MIN_HOURS: Final = 24.0
"""An answer that reaches less far is no forecast [h]."""

EARLY_H: Final = 24.0
"""An answer that ends earlier than this before the others is left out where the rest suffices [h]."""


@dataclass(frozen=True, slots=True, eq=False)
class Series:
    """Values at one place through time.

    Attributes
    ----------
    lat, lon
        The place that was asked [degrees].
    time
        ``(t,)`` seconds since 1970-01-01T00:00Z, strictly increasing.
    values
        By name, ``(t,)`` float32 each, NaN where the service has none. ``u`` and ``v`` are the wind's
        components, ``gust`` its gusts [m/s]; ``wave`` the significant height [m]; ``current_u`` and
        ``current_v`` the water's motion [m/s]; ``u07`` and ``v07`` those of a member.
    notes
        Sentences for the sailor about this answer.
    stamp
        ``Last-Modified`` of the answer, exactly as it came, or empty.
    """

    lat: float
    lon: float
    time: Array
    values: Mapping[str, Grid]
    notes: tuple[str, ...] = ()
    stamp: str = ""

    def valid(self, names: Sequence[str], max_gap_h: float) -> Array:
        """Pick the times at which all named values are known, up to the first hole longer than that [h]."""
        known = np.ones(self.time.size, dtype=np.bool_)
        for name in names:
            known &= np.isfinite(self.values[name])
        time = self.time[known]
        holes = np.nonzero(np.diff(time) > max_gap_h * 3600.0)[0]
        return time if holes.size == 0 else time[: int(holes[0]) + 1]

    def at(self, name: str, time: Array) -> Array:
        """One of the values at other times, linear between the known ones and held beyond them."""
        values = self.values[name]
        known = np.isfinite(values)
        return np.asarray(np.interp(time, self.time[known], values[known]))


def require_hours(service: str, series: Sequence[Series], names: Sequence[str], *, max_gap_h: float) -> None:
    """Refuse an answer that is no forecast for most of its places, before it replaces a better one.

    Raises
    ------
    WeatherError
        ``bad-response``.
    """
    valid = [one.valid(names, max_gap_h) for one in series if has(one, names)]
    spans = [float(times[-1] - times[0]) for times in valid]
    if 2 * len(spans) < len(series):
        raise WeatherError(f"{service} sent no wind speed with a direction for any hour; try again later.")
    if 2 * sum(span >= MIN_HOURS * 3600.0 for span in spans) < len(series):
        raise _too_short(service)


def _too_short(service: str) -> WeatherError:
    return WeatherError(f"{service} sent less than {MIN_HOURS:.0f} hours of wind; try again later.")


def common_times(service: str, series: Sequence[Series], names: Sequence[str], *, max_gap_h: float) -> Array:
    """List the times that any of the places has, while all of them last.

    Raises
    ------
    WeatherError
        ``bad-response`` when they have less than `MIN_HOURS` in common.
    """
    valid = [one.valid(names, max_gap_h) for one in series]
    first, last = max(times[0] for times in valid), min(times[-1] for times in valid)
    time = np.unique(np.concatenate(valid))
    time = time[(time >= first) & (time <= last)]
    if time.size < 2 or time[-1] - time[0] < MIN_HOURS * 3600.0:
        raise _too_short(service)
    return np.asarray(time)


def lasting(
    series: Mapping[int, Series], names: Sequence[str], *, max_gap_h: float, least: int
) -> frozenset[int]:
    """Choose the places whose answers do not cut those of the others short by more than `EARLY_H`.

    Parameters
    ----------
    least
        With fewer places than this left all are chosen: then the forecast ends early.
    """
    ends = {index: float(one.valid(names, max_gap_h)[-1]) for index, one in series.items()}
    last = max(ends.values(), default=0.0)
    late = frozenset(index for index, end in ends.items() if end >= last - EARLY_H * 3600.0)
    return late if len(late) >= least else frozenset(series)


def has(series: Series, names: Sequence[str]) -> bool:
    """Tell whether a place has at least one hour with all of the named values."""
    return all(name in series.values for name in names) and bool(series.valid(names, np.inf).size)


def onto_grid(plan: PointPlan, series: Mapping[int, Series], name: str, time: Array) -> Grid:
    """Bring a value of all places that have it onto a plan's grid: ``(t, y, x)``.

    Parameters
    ----------
    series
        By index of the plan's places; places that are missing are filled in from the others.
    """
    indices = sorted(series)
    values = np.stack([series[index].at(name, time) for index in indices], axis=1)
    nodes = plan.lat.size * plan.lon.size
    if len(indices) == plan.rows.size == nodes:
        # a plan lists its nodes row by row
        return values.reshape(time.size, plan.lat.size, plan.lon.size).astype(np.float32)
    answered = np.zeros(plan.rows.size, dtype=np.bool_)
    answered[indices] = True
    return spread(plan, answered, values).astype(np.float32)


def from_nearest(plan: PointPlan, series: Mapping[int, Series], name: str, time: Array) -> Grid:
    """Bring a value of the sea onto a plan's grid: each node without it takes the nearest one's.

    Unlike the wind, waves and currents have no value on land, and a mean with the far side of a cape
    would invent one.
    """
    indices = sorted(series)
    rows, columns = plan.rows[indices], plan.columns[indices]
    shrink = np.cos(np.radians(plan.lat))[:, None, None]
    dlat = plan.lat[:, None, None] - plan.lat[rows]
    dlon = (plan.lon[None, :, None] - plan.lon[columns]) * shrink
    nearest = np.argmin(dlat**2 + dlon**2, axis=2)
    values = np.stack([series[index].at(name, time) for index in indices], axis=1)
    return np.asarray(values[:, nearest], dtype=np.float32)


def gusts_on_grid(
    plan: PointPlan, series: Mapping[int, Series], time: Array, speed: Grid
) -> tuple[Grid | None, str]:
    """Make gusts on a plan's grid; after the last one known the wind itself stands for them.

    Parameters
    ----------
    speed
        ``(t, y, x)``, the wind's own [m/s].

    Returns
    -------
    tuple
        The gusts, or ``None`` where no place has any; and a sentence on how far they reach, or empty.
    """
    known = {index: one for index, one in series.items() if has(one, ("gust",))}
    if not known:
        return None, ""
    until = min(one.valid(("gust",), np.inf)[-1] for one in known.values())
    gust = onto_grid(plan, known, "gust", time)
    late = time > until
    if not late.any():
        return gust, ""
    gust[late] = speed[late]
    return gust, f"Gusts are known until {format_moment(until)}; after that the mean wind stands for them."


def format_moment(seconds: float) -> str:
    """Write a time for a sentence: ``21 Nov 06:00 UTC``."""
    return f"{datetime.fromtimestamp(seconds, UTC):%d %b %H:%M} UTC"


def unique_hours(time: Array, values: Mapping[str, Array]) -> tuple[Array, dict[str, Grid]]:
    """Put hours in order; of two equal ones the later in the answer counts."""
    # searched from the back, the first of equals is the last
    kept, last = np.unique(time[::-1], return_index=True)
    order = time.size - 1 - last
    return kept, {name: value[order].astype(np.float32) for name, value in values.items()}
