"""The wind she meets: a grid of vectors in time and space, and where it is from.

Directions are where the wind comes FROM, in degrees true, as every sailor and every service says them;
``u`` and ``v`` are where the air goes to. The two conversions live here and nowhere else.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any, ClassVar, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import NoPassageError, WeatherError
from seacruise.geodesy import format_position

Array = NDArray[np.float64]
ArrayLike = Any

MAX_SPEED: Final = 120.0
"""No wind at 10 m blows faster [m/s]; the record is 113 (doi:10.1175/BAMS-D-12-00034.1)."""

_SPACING_TOLERANCE: Final = 1e-3
_EDGE_TOLERANCE_DEG: Final = 1e-6


@dataclass(frozen=True, slots=True)
class Forecast:
    """Where a wind is from: shown with every number that was computed from it.

    Attributes
    ----------
    source
        Name for the sailor, e.g. ``"Storm Glass (sg)"`` or ``"Practice weather - not a forecast"``.
    issued
        Run of the model, or when the service answered; ``None`` when not known. UTC.
    valid_from, valid_to
        First and last hour covered, UTC; beyond ``valid_to`` (the horizon) the last wind is held.
    step_h, resolution_deg
        Usual step in time [h] and in space [degrees of latitude].
    notice
        A sentence the sailor must see with it ("generated weather, not a forecast"), or empty.
    real
        Whether it tells of the weather to come; practice weather and the sample do not.
    """

    source: str
    issued: datetime | None
    valid_from: datetime
    valid_to: datetime
    step_h: float
    resolution_deg: float
    notice: str = ""
    real: bool = True


@dataclass(frozen=True, slots=True, eq=False)
class Flow:
    """Moving air or water on a regular grid.

    Attributes
    ----------
    time
        ``(t,)`` seconds since 1970-01-01T00:00Z, strictly increasing, any steps.
    lat, lon
        ``(y,)`` and ``(x,)`` degrees, increasing and evenly spaced to a thousandth of a step. A single
        value means that the flow does not change along that axis.
    u, v
        ``(t, y, x)`` float32, eastward and northward component of the motion [m/s], finite.

    Raises
    ------
    WeatherError
        ``bad-response`` when an axis or a component breaks these rules.
    """

    time: NDArray[np.float64]
    lat: NDArray[np.float64]
    lon: NDArray[np.float64]
    u: NDArray[np.float32]
    v: NDArray[np.float32]
    forecast: Forecast

    _WHAT: ClassVar[str] = "flow"
    _MAX_SPEED: ClassVar[float] = MAX_SPEED

    def __post_init__(self) -> None:
        for name in ("time", "lat", "lon"):
            object.__setattr__(self, name, np.ascontiguousarray(getattr(self, name), dtype=np.float64))
        for name in ("u", "v"):
            object.__setattr__(self, name, np.ascontiguousarray(getattr(self, name), dtype=np.float32))
        self._check_axes()
        for name in ("u", "v"):
            self._check_values(getattr(self, name), -self._MAX_SPEED, self._MAX_SPEED, "m/s")

    def _refuse(self, what: str) -> WeatherError:
        return WeatherError(f"The {self._WHAT} from {self.forecast.source} cannot be used: {what}.")

    def _check_axes(self) -> None:
        for name, axis in (("times", self.time), ("latitudes", self.lat), ("longitudes", self.lon)):
            if axis.ndim != 1 or axis.size == 0 or not np.isfinite(axis).all():
                raise self._refuse(f"its {name} are empty or not numbers")
            steps = np.diff(axis)
            if (steps <= 0).any():
                raise self._refuse(f"its {name} do not increase")
            if name != "times" and steps.size:
                even = (axis[-1] - axis[0]) / steps.size
                if np.abs(axis - (axis[0] + even * np.arange(axis.size))).max() > _SPACING_TOLERANCE * even:
                    raise self._refuse(f"its {name} are not evenly spaced")
        if self.lat[0] < -90.001 or self.lat[-1] > 90.001:
            raise self._refuse("it has latitudes beyond the poles")

    def _check_values(self, values: NDArray[np.float32], low: float, high: float, unit: str) -> None:
        shape = (self.time.size, self.lat.size, self.lon.size)
        if values.shape != shape:
            raise self._refuse(f"its grid is {values.shape}, its axes say {shape}")
        # min and max carry a NaN along, so one pass each is the whole test
        least, most = float(values.min()), float(values.max())
        if not (least >= low and most <= high):
            raise self._refuse(f"it has values that are missing or above {high:.0f} {unit}")

    def at(self, time: ArrayLike, lat: ArrayLike, lon: ArrayLike) -> tuple[Array, Array]:
        """Flow at places and times: ``u, v`` [m/s], of the arguments' broadcast shape.

        Linear in time, bilinear in space, both of the components, so that no direction jumps through
        north. Before the first and after the last time the nearest one is held (R1), beyond the edge
        of the grid the edge's flow is taken; `covers` tells the latter.

        Parameters
        ----------
        time
            Seconds since 1970-01-01T00:00Z.
        lat, lon
            Degrees.
        """
        u, v = self._interpolated((self.u, self.v), time, lat, lon)
        return u, v

    def interpolate(
        self, grid: NDArray[np.float32], time: ArrayLike, lat: ArrayLike, lon: ArrayLike
    ) -> Array:
        """Values of a further grid ``(t, y, x)`` on these axes, such as gusts, as `at` does it."""
        return self._interpolated((grid,), time, lat, lon)[0]

    def _interpolated(
        self, grids: Sequence[NDArray[np.float32]], time: ArrayLike, lat: ArrayLike, lon: ArrayLike
    ) -> list[Array]:
        t, wt = _bracket(time, self.time)
        y, wy = _bracket(lat, self.lat)
        x, wx = _bracket(lon, self.lon)
        t1 = np.minimum(t + 1, self.time.size - 1)
        y1 = np.minimum(y + 1, self.lat.size - 1)
        x1 = np.minimum(x + 1, self.lon.size - 1)

        def interpolate(grid: NDArray[np.float32]) -> Array:
            before = _bilinear(grid, t, (y, y1, wy), (x, x1, wx))
            after = _bilinear(grid, t1, (y, y1, wy), (x, x1, wx))
            return np.asarray(before * (1.0 - wt) + after * wt)

        return [interpolate(grid) for grid in grids]

    def covers(self, lat: ArrayLike, lon: ArrayLike) -> NDArray[np.bool_]:
        """Tell which positions [degrees] lie on the grid, its edge included; of the broadcast shape."""
        return is_on_grid(self.lat, self.lon, lat, lon)

    def describe_area(self) -> str:
        """Name the covered area for a sentence: ``52.0 to 67.0 N, 7.0 to 32.0 E``."""
        return describe_area(self.lat, self.lon)


@dataclass(frozen=True, slots=True, eq=False)
class Current(Flow):
    """Current of the sea at its surface; ``u`` and ``v`` are where the water goes to [m/s]."""

    _WHAT: ClassVar[str] = "current"
    _MAX_SPEED: ClassVar[float] = 15.0


@dataclass(frozen=True, slots=True, eq=False)
class Wind(Flow):
    """Wind at 10 m on a regular grid, and what the forecast knows besides.

    Attributes
    ----------
    gust
        ``(t, y, x)`` float32, speed of the gusts at 10 m [m/s]; ``None`` where the forecast has none.
    wave
        ``(t, y, x)`` float32, significant wave height [m]; ``None`` where the forecast has none.
    spread
        ``(t, y, x)`` float32, how far sources or members differ [m/s]: the standard deviation of their
        vectors; ``None`` for a single one.
    current
        Current that came with the forecast, on a grid of its own.
    members
        Members of an ensemble, each a wind on the same axes, without members of its own; ``u`` and ``v``
        are then their mean or the control run, as ``forecast.source`` says.
    """

    gust: NDArray[np.float32] | None = None
    wave: NDArray[np.float32] | None = None
    spread: NDArray[np.float32] | None = None
    current: Current | None = None
    members: tuple[Wind, ...] = ()

    _WHAT: ClassVar[str] = "wind"

    def __post_init__(self) -> None:
        Flow.__post_init__(self)
        for name, most, unit in (
            ("gust", 2 * MAX_SPEED, "m/s"),
            ("wave", 40.0, "m"),
            ("spread", MAX_SPEED, "m/s"),
        ):
            values = getattr(self, name)
            if values is not None:
                values = np.ascontiguousarray(values, dtype=np.float32)
                object.__setattr__(self, name, values)
                self._check_values(values, 0.0, most, unit)
        for member in self.members:
            axes = ((self.time, member.time), (self.lat, member.lat), (self.lon, member.lon))
            if member.members or not all(np.array_equal(a, b) for a, b in axes):
                raise self._refuse("its members are not on the axes of their mean")


def _bracket(value: ArrayLike, axis: Array) -> tuple[NDArray[np.int64], Array]:
    """Index of the knot below each value and the weight of the one above, held beyond both ends."""
    # searching the axis itself, instead of dividing by its step, keeps the knots exact
    position = np.interp(np.asarray(value, dtype=np.float64), axis, np.arange(axis.size, dtype=np.float64))
    below = np.asarray(position).astype(np.int64)
    return below, np.asarray(position - below)


def _bilinear(
    grid: NDArray[np.float32],
    t: NDArray[np.int64],
    rows: tuple[NDArray[np.int64], NDArray[np.int64], Array],
    columns: tuple[NDArray[np.int64], NDArray[np.int64], Array],
) -> Array:
    y, y1, wy = rows
    x, x1, wx = columns
    south = grid[t, y, x] * (1.0 - wx) + grid[t, y, x1] * wx
    north = grid[t, y1, x] * (1.0 - wx) + grid[t, y1, x1] * wx
    return np.asarray(south * (1.0 - wy) + north * wy)


def is_on_grid(grid_lat: Array, grid_lon: Array, lat: ArrayLike, lon: ArrayLike) -> NDArray[np.bool_]:
    """Tell which positions lie within axes, ends included; an axis of one value holds everywhere."""
    inside = np.ones(np.broadcast_shapes(np.shape(lat), np.shape(lon)), dtype=np.bool_)
    for value, axis in ((lat, grid_lat), (lon, grid_lon)):
        if axis.size > 1:
            degrees = np.asarray(value, dtype=np.float64)
            inside &= (degrees >= axis[0] - _EDGE_TOLERANCE_DEG) & (degrees <= axis[-1] + _EDGE_TOLERANCE_DEG)
    return inside


def describe_area(lat: Array, lon: Array) -> str:
    """Name the area of positions [degrees] for a sentence: ``52.0 to 67.0 N, 7.0 to 32.0 E``."""

    def span(values: Array, positive: str, negative: str) -> str:
        first, last = float(values.min()), float(values.max())
        if first < 0 < last:
            return f"{-first:.1f} {negative} to {last:.1f} {positive}"
        low, high = sorted((abs(first), abs(last)))
        return f"{low:.1f} to {high:.1f} {negative if first < 0 else positive}"

    return f"{span(lat, 'N', 'S')}, {span(lon, 'E', 'W')}"


def require_cover(source: str, grid: tuple[Array, Array], places: Iterable[tuple[float, float]]) -> None:
    """Check that positions ``lat, lon`` [degrees] lie on a grid's axes.

    Raises
    ------
    NoPassageError
        ``outside-forecast``, naming the first that does not and what is covered.
    """
    for lat, lon in places:
        if not is_on_grid(*grid, lat, lon):
            raise NoPassageError(
                f"{source} covers {describe_area(*grid)}, and {format_position(lat, lon)} is outside; "
                "choose another forecast.",
                reason="outside-forecast",
                place=(lat, lon),
            )


def require_departure(service: str, covered: tuple[datetime, datetime], departure: datetime | None) -> None:
    """Check that a service forecasts a departure, before anything is asked of it.

    Raises
    ------
    NoPassageError
        ``outside-forecast``, naming what is covered.
    """
    begin, end = covered
    if departure is not None and not begin <= departure <= end:
        raise NoPassageError(
            f"{service} forecasts from {begin:%d %b %Y %H:%M} to {end:%d %b %Y %H:%M} UTC; choose a "
            "departure between them, or another forecast.",
            reason="outside-forecast",
        )


def from_direction(speed: ArrayLike, direction_from_deg: ArrayLike) -> tuple[Array, Array]:
    """Components ``u, v`` of a wind of a speed coming FROM a direction [degrees true]; unit of the speed."""
    angle = np.radians(np.asarray(direction_from_deg, dtype=np.float64))
    strength = np.asarray(speed, dtype=np.float64)
    return np.asarray(-strength * np.sin(angle)), np.asarray(-strength * np.cos(angle))


def to_direction(u: ArrayLike, v: ArrayLike) -> tuple[Array, Array]:
    """Speed and direction FROM [degrees true, 0 <= direction < 360] of components; unit of the components."""
    east, north = np.asarray(u, dtype=np.float64), np.asarray(v, dtype=np.float64)
    direction = np.degrees(np.arctan2(-east, -north)) % 360.0
    # a tiny negative angle is rounded up to 360 by the modulo itself
    return np.asarray(np.hypot(east, north)), np.asarray(np.where(direction >= 360.0, 0.0, direction))


def describe_grid(time: Array, lat: Array, lon: Array) -> tuple[datetime, datetime, float, float]:
    """Axes as a `Forecast` tells them: first and last time, usual step [h], resolution [degrees].

    The usual step is the median one; a single time has the step 0.
    """
    steps = np.diff(time)
    axis = lat if lat.size > 1 else lon
    resolution = float(axis[-1] - axis[0]) / (axis.size - 1) if axis.size > 1 else 0.0
    return (
        datetime.fromtimestamp(float(time[0]), UTC),
        datetime.fromtimestamp(float(time[-1]), UTC),
        # `np.median` would load all of `numpy.ma`, and nothing else does.
        float(np.quantile(steps, 0.5)) / 3600.0 if steps.size else 0.0,
        round(resolution, 4),
    )
