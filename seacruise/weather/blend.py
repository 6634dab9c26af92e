"""Several forecasts as one: the mean of their vectors, and how far they differ.

R1's customer asked for it: services disagree, and the mean of several is better than most of them. The mean
of directions in degrees would turn a wind of 350 and one of 10 into one from the south, so components are
averaged; where forecasts contradict each other the mean wind is weak and `Wind.spread` is large.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from datetime import UTC, datetime
from typing import Final

import numpy as np

from seacruise.errors import InputError
from seacruise.weather.grids import MAX_VALUES, Array, Grid
from seacruise.weather.wind import Forecast, Wind, describe_area, describe_grid

_SAME_DEG: Final = 1e-4
_SAME_S: Final = 1.0


def blend(winds: Sequence[Wind], weights: Sequence[float] | None = None) -> Wind:
    """Average forecasts on a common grid.

    The grid is the finest of them over the area that all cover, at all times that any of them has within
    the span that all cover; forecasts that share their axes keep them. Of one forecast it is returned as it
    is. Members are not kept: those of different ensembles do not belong together.

    Parameters
    ----------
    winds
        At least one; wherever each is from.
    weights
        One for each, positive; equal by default.

    Returns
    -------
    Wind
        ``u``, ``v`` the weighted mean of the vectors; ``gust`` and ``wave`` that of the forecasts which have
        them; ``spread`` the weighted standard deviation of the vectors, each forecast's own spread included;
        ``current`` that of the heaviest forecast with one. The source is named ``Mean of A (2) and B (1)``,
        the notices are joined, ``issued`` is the oldest.

    Raises
    ------
    InputError
        They have no time or no area in common, or a weight is none; one sentence.
    """
    if not winds:
        raise InputError("There is no forecast to average; name at least one.")
    parts = shares(len(winds), weights)
    if len(winds) == 1:
        return winds[0]
    moved = [_beside(winds[0], wind) for wind in winds]
    time, lat, lon = _axes(moved)
    shape = (time.size, lat.size, lon.size)
    u, v, square = (np.zeros(shape, dtype=np.float64) for _ in range(3))
    gust, wave = _Mean(), _Mean()
    for wind, share in zip(moved, parts, strict=True):
        one = _on(wind, time, lat, lon)
        east, north = one["u"].astype(np.float64), one["v"].astype(np.float64)
        u += share * east
        v += share * north
        # a difference of squares needs all the digits there are
        square += share * (east * east + north * north + np.square(one.get("spread", 0.0)))
        gust.add(one.get("gust"), share)
        wave.add(one.get("wave"), share)
    currents = [(share, wind.current) for share, wind in zip(parts, winds, strict=True) if wind.current]
    return Wind(
        time=time,
        lat=lat,
        lon=lon,
        u=u.astype(np.float32),
        v=v.astype(np.float32),
        forecast=_forecast(winds, weights, time, lat, lon),
        gust=gust.value(),
        wave=wave.value(),
        spread=np.sqrt(np.maximum(square - u * u - v * v, 0.0)).astype(np.float32),
        current=max(currents, key=lambda one: one[0])[1] if currents else None,
    )


class _Mean:
    """Weighted mean of what only some forecasts have."""

    def __init__(self) -> None:
        self._total: Array | None = None
        self._weight = 0.0

    def add(self, values: Grid | None, share: float) -> None:
        """Take in the values of one forecast, if it has any."""
        if values is not None:
            weighted = share * values.astype(np.float64)
            self._total = weighted if self._total is None else self._total + weighted
            self._weight += share

    def value(self) -> Grid | None:
        """Give the mean of those that had any, or ``None``."""
        return None if self._total is None else (self._total / self._weight).astype(np.float32)


def shares(count: int, weights: Sequence[float] | None) -> list[float]:
    """Give the part of each forecast in the mean, 1 in all; weights are checked before any is fetched.

    Raises
    ------
    InputError
        There are not as many weights as forecasts, or one of them is none.
    """
    given = [1.0] * count if weights is None else [float(weight) for weight in weights]
    if len(given) != count:
        raise InputError(f"There are {len(given)} weights for {count} forecasts; give one weight for each.")
    if not all(np.isfinite(weight) and weight > 0 for weight in given):
        raise InputError("A weight of a forecast must be a number above 0; leave out forecasts without any.")
    return [weight / sum(given) for weight in given]


def _name(wind: Wind) -> str:
    return wind.forecast.source.removeprefix("File ")


def _beside(first: Wind, other: Wind) -> Wind:
    """Turn a forecast around the world to where the first one lies: 185 E is 175 W."""
    if first.lon.size == 1 or other.lon.size == 1:
        return other

    def overlap(turn: float) -> float:
        return float(min(first.lon[-1], other.lon[-1] + turn) - max(first.lon[0], other.lon[0] + turn))

    turn = max((0.0, 360.0, -360.0), key=overlap)
    if turn == 0.0:
        return other
    return Wind(
        other.time, other.lat, other.lon + turn, other.u, other.v, other.forecast,
        gust=other.gust, wave=other.wave, spread=other.spread,
    )  # fmt: skip


def _axes(winds: Sequence[Wind]) -> tuple[Array, Array, Array]:
    """Choose the times, latitudes and longitudes on which all can be put."""
    first = winds[0]
    if all(
        _same(one.time, first.time, _SAME_S)
        and _same(one.lat, first.lat, _SAME_DEG)
        and _same(one.lon, first.lon, _SAME_DEG)
        for one in winds
    ):
        return first.time, first.lat, first.lon
    begin, end = max(one.time[0] for one in winds), min(one.time[-1] for one in winds)
    if begin > end:
        spans = _listed(f"{_name(one)} covers {_span(one)}" for one in winds)
        raise InputError(f"{spans}: they have no time in common and cannot be averaged; give one of them.")
    times = np.unique(np.concatenate([one.time for one in winds]))
    times = times[(times >= begin) & (times <= end)]
    # times that differ by rounding only are one
    times = times[np.append(True, np.diff(times) > _SAME_S)]
    lat, lon = _common([one.lat for one in winds]), _common([one.lon for one in winds])
    if lat is None or lon is None:
        areas = _listed(f"{_name(one)} covers {describe_area(one.lat, one.lon)}" for one in winds)
        raise InputError(f"{areas}: they have no area in common and cannot be averaged; give one of them.")
    thinner = float(np.sqrt(times.size * lat.size * lon.size / MAX_VALUES))
    return (times, lat, lon) if thinner <= 1.0 else (times, _thinned(lat, thinner), _thinned(lon, thinner))


def _same(one: Array, two: Array, tolerance: float) -> bool:
    return one.shape == two.shape and bool(np.abs(one - two).max() <= tolerance)


def _common(axes: Sequence[Array]) -> Array | None:
    """Nodes of the finest axis within what all cover, and its ends; an axis of one value is everywhere."""
    long = [axis for axis in axes if axis.size > 1]
    if not long:
        return axes[0]
    low, high = max(float(axis[0]) for axis in long), min(float(axis[-1]) for axis in long)
    if high - low <= _SAME_DEG:
        return None
    finest = min(long, key=lambda axis: float(axis[-1] - axis[0]) / (axis.size - 1))
    step = float(finest[-1] - finest[0]) / (finest.size - 1)
    inside = finest[(finest >= low - _SAME_DEG) & (finest <= high + _SAME_DEG)]
    if inside.size > 1 and inside[0] - low <= _SAME_DEG and high - inside[-1] <= _SAME_DEG:
        return inside
    # the edge of another grid lies between two nodes: even steps of at most the finest, edge to edge
    return np.linspace(low, high, int(np.ceil((high - low) / step - _SAME_DEG)) + 1)


def _thinned(axis: Array, by: float) -> Array:
    return np.linspace(axis[0], axis[-1], max(int(axis.size / by), 2)) if axis.size > 1 else axis


def _on(wind: Wind, time: Array, lat: Array, lon: Array) -> dict[str, Grid]:
    """Interpolate all that a forecast has, one time after the other: that keeps the memory small."""
    layers: dict[str, Grid] = {
        name: values
        for name in ("u", "v", "gust", "wave", "spread")
        if (values := getattr(wind, name)) is not None
    }
    axes = ((wind.time, time, _SAME_S), (wind.lat, lat, _SAME_DEG), (wind.lon, lon, _SAME_DEG))
    if all(_same(*one) for one in axes):
        return layers
    result = {name: np.empty((time.size, lat.size, lon.size), dtype=np.float32) for name in layers}
    for k, moment in enumerate(time.tolist()):
        for name, values in layers.items():
            result[name][k] = wind.interpolate(values, moment, lat[:, None], lon[None, :])
    return result


def _forecast(
    winds: Sequence[Wind], weights: Sequence[float] | None, time: Array, lat: Array, lon: Array
) -> Forecast:
    valid_from, valid_to, step_h, resolution = describe_grid(time, lat, lon)
    named = [
        _name(wind) if weights is None else f"{_name(wind)} ({weight:g})"
        for wind, weight in zip(winds, weights or [1.0] * len(winds), strict=True)
    ]
    notices = [one.forecast.notice for one in winds if one.forecast.notice]
    if time.size == 1 and any(one.time.size > 1 for one in winds):
        notices.append(
            f"The forecasts have only {valid_from:%Y-%m-%d %H:%M} UTC in common; its wind is held from then."
        )
    issued = [one.forecast.issued for one in winds if one.forecast.issued is not None]
    return Forecast(
        source=f"Mean of {_listed(named)}",
        issued=min(issued) if issued else None,
        valid_from=valid_from,
        valid_to=valid_to,
        step_h=step_h,
        resolution_deg=resolution,
        notice=" ".join(dict.fromkeys(notices)),
        real=all(one.forecast.real for one in winds),
    )


def _span(wind: Wind) -> str:
    first, last = (datetime.fromtimestamp(float(wind.time[k]), UTC) for k in (0, -1))
    return f"{first:%Y-%m-%d %H:%M} to {last:%Y-%m-%d %H:%M} UTC"


def _listed(names: Iterable[str]) -> str:
    *most, last = names
    return f"{', '.join(most)} and {last}" if most else last
