"""Passages whose fastest time is known: closed forms on the sphere, and what the search makes of them.

Where a closed form belongs to a plane, the wind is made proportional to the cosine of the latitude: a yacht
whose speed is proportional to the wind then sails the Mercator plane as if it were flat, and a formula of
the plane is exact on the sphere.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import great_circle_m, scale, to_mercator
from seacruise.units import MS_PER_KNOT
from seacruise.weather.wind import Current, Wind, to_direction
from seacruise.yacht.polar import Polar
from tests.routing.worlds import DAY, HOUR, T0, drifter, sloop, steady_wind, wind_of

Array = NDArray[np.float64]
Position = tuple[float, float]

START: Position = (55.7, 16.0)
END: Position = (57.7, 20.0)

_LATS = np.arange(54.0, 60.0001, 0.005)


@dataclass(frozen=True, slots=True, eq=False)
class Case:
    """A passage over open water and the least time it can take.

    Attributes
    ----------
    exact_s
        From departure to arrival [s].
    held
        Error of the time shown that the tests allow [share]: what is reached, and a small reserve.
    """

    formula: str
    wind: Wind
    yacht: Polar
    start: Position
    end: Position
    exact_s: float
    held: float
    current: Current | None = None


# ------------------------------------------------------------------ speed of the wind, whatever the course


def _great_circle(start: Position, end: Position, *, held: float = 3e-4) -> Case:
    speed = 10 * MS_PER_KNOT
    exact = float(great_circle_m(*start, *end)) / speed
    return Case("great circle / v", steady_wind(10.0, 250.0), drifter(), start, end, exact, held)


def _two_bands() -> Case:
    """Find the crossing of Snell's law on the sphere: the only unknown is where the border is crossed."""
    border, slow, fast = 56.7025, 6 * MS_PER_KNOT, 12 * MS_PER_KNOT

    def seconds(lon: float) -> float:
        south = float(great_circle_m(*START, border, lon)) / slow
        return south + float(great_circle_m(border, lon, *END)) / fast

    # Half-way between two rows of the grid, which blends the two winds over half a mile.
    speed = np.where(border > _LATS, slow, fast)
    wind = wind_of([T0, T0 + 10 * DAY], _LATS, speed[None, :, None], 180.0)
    exact = _least(seconds, START[1], END[1])
    return Case("Snell's law", wind, drifter(), START, END, exact, 8e-4)


def _arc() -> Case:
    """In a medium whose speed is linear in y the fastest way is an arc of a circle (Fermat)."""
    (x0, x1), (y0, y1) = to_mercator([START[0], END[0]], [START[1], END[1]])
    middle = (y0 + y1) / 2
    v_middle, gradient = 8 * MS_PER_KNOT, 8 * MS_PER_KNOT / 250_000.0

    def in_plane(y: Array) -> Array:
        return np.asarray(np.maximum(v_middle + gradient * (y - middle), 0.1))

    _, y = to_mercator(_LATS, 0.0)
    speed = in_plane(y) * scale(_LATS)
    wind = wind_of([T0, T0 + 10 * DAY], _LATS, speed[None, :, None], 270.0)
    apart = math.hypot(x1 - x0, y1 - y0)
    ends = float(in_plane(np.asarray(y0)) * in_plane(np.asarray(y1)))
    exact = math.acosh(1.0 + (gradient * apart) ** 2 / (2.0 * ends)) / gradient
    return Case("arc of a circle", wind, drifter(), START, END, exact, 8e-4)


def _lifting_calm(lifts_after: float, *, within: float = 1.0, held: float = 3e-4) -> Case:
    speed = 12 * MS_PER_KNOT
    times = T0 + np.array([-HOUR, lifts_after, lifts_after + within, 5 * DAY])
    wind = wind_of(times, [57.0], np.array([0.0, 0.0, speed, speed])[:, None, None], 200.0)
    exact = lifts_after + within / 2 + float(great_circle_m(*START, *END)) / speed
    return Case("calm + great circle / v", wind, drifter(), START, END, exact, held)


def _freshening() -> Case:
    """Speed a + b t everywhere: distance a T + b T^2 / 2."""
    slow, fast, span = 2.0, 9.0, DAY
    times = T0 + np.array([0.0, span])
    wind = wind_of(times, [57.0], np.array([slow, fast])[:, None, None], 200.0)
    b = (fast - slow) / span
    distance = float(great_circle_m(*START, *END))
    exact = (-slow + math.sqrt(slow**2 + 2 * b * distance)) / b
    return Case("quadratic in t", wind, drifter(), START, END, exact, 3e-4)


def _least(seconds: Callable[[float], float], low: float, high: float) -> float:
    """Minimum of a convex function by golden section."""
    golden = (math.sqrt(5.0) - 1.0) / 2.0
    while high - low > 1e-7:
        a, b = high - golden * (high - low), low + golden * (high - low)
        low, high = (low, b) if seconds(a) < seconds(b) else (a, high)
    return seconds((low + high) / 2)


# --------------------------------------------------------- a real polar, in a plane that the wind makes flat

_FLAT_KN = 12.0
"""Wind on the equator in knots; at 57 N it blows 6.5, which leaves the polar well within its table."""


def _flat_wind(times: Array, direction_deg: Array, speed_kn: float = 2 * _FLAT_KN) -> Wind:
    speed = speed_kn * MS_PER_KNOT * scale(_LATS)
    return wind_of(times, _LATS, speed[None, :, None], direction_deg[:, None, None])


def _steady(twa: float) -> Case:
    """The hull of a polar is convex, so in a steady wind nothing beats the straight line."""
    x, y = to_mercator([START[0], END[0]], [START[1], END[1]])
    course = math.degrees(math.atan2(x[1] - x[0], y[1] - y[0]))
    times = T0 + np.array([0.0, 10 * DAY])
    wind = _flat_wind(times, np.full(2, (course + twa) % 360.0))
    exact = _homogeneous(wind, np.array([x[1] - x[0], y[1] - y[0]]))
    return Case("plane distance / hull", wind, sloop(), START, END, exact, 2e-4)


def _flat_current(set_to_deg: float, speed_kn: float) -> Current:
    """Make a current that is the same everywhere in the plane."""
    flow = wind_of(
        T0 + np.array([0.0, 10 * DAY]),
        _LATS,
        speed_kn * MS_PER_KNOT * scale(_LATS)[None, :, None],
        set_to_deg + 180.0,
    )
    return Current(flow.time, flow.lat, flow.lon, flow.u, flow.v, flow.forecast)


def _zermelo() -> Case:
    """Zermelo's problem: the same speed through the water on every course, water that moves evenly.

    Over ground she reaches a circle that drifts; r d - c has the length of her speed through the water.
    """
    current = _flat_current(305.0, 4.0)
    wind = _flat_wind(T0 + np.array([0.0, 10 * DAY]), np.full(2, 200.0))
    (u, v), (cu, cv) = (
        (float(c[0, 0, 0]) / float(scale(_LATS[0])) for c in (flow.u, flow.v)) for flow in (wind, current)
    )
    speed = math.hypot(u - cu, v - cv)
    x, y = to_mercator([START[0], END[0]], [START[1], END[1]])
    way = np.array([x[1] - x[0], y[1] - y[0]])
    length = float(np.hypot(*way))
    along = float(way @ (cu, cv)) / length
    made_good = along + math.sqrt(speed**2 - cu**2 - cv**2 + along**2)
    return Case("circle that drifts", wind, drifter(), START, END, length / made_good, 2e-4, current=current)


def _in_current(twa: float) -> Case:
    """A real polar in a steady wind and current: the hull drifts, and it is convex."""
    x, y = to_mercator([START[0], END[0]], [START[1], END[1]])
    course = math.degrees(math.atan2(x[1] - x[0], y[1] - y[0]))
    wind = _flat_wind(T0 + np.array([0.0, 10 * DAY]), np.full(2, (course + twa) % 360.0))
    current = _flat_current((course + 100.0) % 360.0, 3.0)
    exact = _homogeneous(wind, np.array([x[1] - x[0], y[1] - y[0]]), current=current)
    return Case("hull that drifts", wind, sloop(), START, END, exact, 5e-4, current=current)


def _turning(first: float, last: float) -> Case:
    times = T0 + np.arange(0.0, 2 * DAY + 1, 900.0)
    direction = first + (last - first) * np.minimum((times - T0) / DAY, 1.0)
    wind = _flat_wind(times, direction)
    x, y = to_mercator([START[0], END[0]], [START[1], END[1]])
    exact = _homogeneous(wind, np.array([x[1] - x[0], y[1] - y[0]]))
    return Case("sum of hulls", wind, sloop(), START, END, exact, 8e-4)


def _homogeneous(
    wind: Wind, way: Array, *, angles: int = 2880, step: float = 60.0, current: Current | None = None
) -> float:
    """Least time [s] to make good a vector [m] where the wind is the same everywhere, but not always.

    What can be reached in T is the sum (Minkowski) of the hulls of all moments; a point lies in that
    convex set when no direction p sees it farther than the integral of the hulls' support in p.
    """
    times = T0 + np.arange(0.0, 4 * DAY, step) + step / 2
    drift = (0.0, 0.0)
    if current is not None:
        drift = (float(current.at(T0, 57.0, 18.0)[0]), float(current.at(T0, 57.0, 18.0)[1]))
    felt = [component - c for component, c in zip(wind.at(times, 57.0, 18.0), drift, strict=True)]
    _, first_twd = to_direction(felt[0][:1], felt[1][:1])
    # Hulls are flat across the wind's axis: there a direction in between would be too generous.
    goals = np.radians(float(first_twd[0]) + np.arange(angles) * 360.0 / angles)
    twa = np.arange(0.0, 180.01, 0.05)
    radius = sloop().speed(10.0, twa) / 10.0
    # Support of a polar slice in the direction that makes an angle with the wind, per m/s of wind.
    relative = np.radians(np.arange(0.0, 180.01, 0.125))
    support = np.array([(radius * np.cos(np.radians(twa) - r)).max() for r in relative])
    _, direction = to_direction(*felt)
    strength = np.hypot(*felt) / float(scale(57.0))
    drifted = (np.sin(goals) * drift[0] + np.cos(goals) * drift[1]) / float(scale(57.0)) * step
    seen = np.sin(goals) * way[0] + np.cos(goals) * way[1]
    reached = np.zeros(angles)
    for t, (speed, twd) in enumerate(zip(strength, direction, strict=True)):
        off = np.abs((goals - math.radians(twd) + np.pi) % (2 * np.pi) - np.pi)
        gained = speed * step * np.interp(off, relative, support) + drifted
        if (seen <= reached + gained).all():
            # Within this minute: the last direction to be satisfied decides.
            return float(t * step + step * ((seen - reached) / gained)[gained > 0].max())
        reached += gained
    raise AssertionError("four days are not enough")


PASSAGES: dict[str, Callable[[], Case]] = {
    "Straight on": lambda: _great_circle(START, END),
    "Straight east, 340 nm": lambda: _great_circle((56.0, 15.0), (56.0, 25.0), held=5e-4),
    "Two bands of wind": _two_bands,
    "Wind growing to the north": _arc,
    "Calm for 10 h": lambda: _lifting_calm(10 * HOUR),
    "Calm for 9 h 50 min": lambda: _lifting_calm(9 * HOUR + 50 * 60),
    "Calm lifting within an hour": lambda: _lifting_calm(9 * HOUR + 50 * 60, within=HOUR),
    "Wind freshening everywhere": _freshening,
    "Dead beat": lambda: _steady(0.0),
    "Close-hauled": lambda: _steady(50.0),
    "Beam reach": lambda: _steady(90.0),
    "Broad reach": lambda: _steady(130.0),
    "Run": lambda: _steady(180.0),
    "Current across, Zermelo": _zermelo,
    "Beat in a current": lambda: _in_current(10.0),
    "Reach in a current": lambda: _in_current(80.0),
    "Run in a current": lambda: _in_current(175.0),
    "Wind turning 120 degrees, reach to beat": lambda: _turning(230.0, 350.0),
    "Wind turning 90 degrees, beat to reach": lambda: _turning(62.0, 152.0),
}
"""What makes each passage of ``docs/accuracy.md``, in its order."""
