"""libweatherrouting (PyPI ``weatherrouting``, GPL-3): isochrones in Python, driven through its public API."""

from __future__ import annotations

import io
import math
import time
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib import import_module
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from benchmarks.simulator import Simulator
from benchmarks.world import World
from seacruise.geodesy import to_mercator
from seacruise.routing.find import Question
from seacruise.sea import Sea
from seacruise.units import MS_PER_KNOT, SECONDS_PER_HOUR
from seacruise.yacht.polar import Polar

STEP_H: Final = 1.0
"""Its own step [h]. Half of it took twice as long and found slower routes: it keeps the best point of each
degree of bearing from the start, and more steps lose more of the good ones."""

MOST_STEPS: Final = 400


@dataclass(frozen=True, slots=True)
class Route:
    """What another program found: positions [degrees], the hours it claims, and its computing time."""

    lat: list[float]
    lon: list[float]
    claimed_h: float
    seconds: float


class _Wind:
    """What it calls a GRIB: direction FROM [degrees] and speed [m/s] at a time and place."""

    def __init__(self, simulator: Simulator) -> None:
        self._wind_at = simulator.wind_at

    def get_wind_at(self, t: datetime, lat: float, lon: float) -> tuple[float, float]:
        u, v = self._wind_at(t.timestamp(), lat, lon)
        return math.degrees(math.atan2(-u, -v)) % 360.0, math.hypot(u, v)


def polar_file(polar: Polar) -> str:
    """Write a polar as it reads them: a table in knots, every 5 degrees - its own step of headings."""
    tws = np.arange(0.0, 41.0, 2.0)
    twa = np.arange(0.0, 181.0, 5.0)
    speeds = polar.speed(tws * MS_PER_KNOT, twa[:, None]) / MS_PER_KNOT
    lines = ["TWA\\TWS\t" + "\t".join(f"{w:g}" for w in tws)]
    lines += [f"{a:g}\t" + "\t".join(f"{s:.4f}" for s in row) for a, row in zip(twa, speeds, strict=True)]
    return "\n".join(lines) + "\n"


def route_by_weatherrouting(at: World, simulator: Simulator, asked: Question, *, land: bool) -> Route:
    """Route with its only weather router, `LinearBestIsoRouter`.

    Raises
    ------
    RuntimeError
        It did not reach the port.
    """
    library = import_module("weatherrouting")
    polar = library.Polar("", io.StringIO(polar_file(at.yacht)))
    checks = _land_checks(asked.sea) if land else {}
    departure = datetime.fromtimestamp(asked.departure, UTC)
    router = library.list_routing_algorithms()[0]["class"]
    begun = time.perf_counter()
    routing = library.Routing(router, polar, [asked.start, asked.end], _Wind(simulator), departure, **checks)
    # After the port is reached one more step only says so.
    while not routing.path and routing.steps < MOST_STEPS:
        routing.step(timedelta=STEP_H)
    seconds = time.perf_counter() - begun
    if not routing.path:
        raise RuntimeError(f"it did not reach the port in {MOST_STEPS} steps of {STEP_H:g} h")
    lat, lon = zip(*(point.pos for point in routing.path), strict=True)
    claimed = (routing.time - departure).total_seconds() / SECONDS_PER_HOUR
    return Route([float(v) for v in lat], [float(v) for v in lon], claimed, seconds)


def _land_checks(sea: Sea) -> dict[str, Any]:
    """Our sea through its call-backs, in the vectorised form it offers for speed."""

    def points(positions: list[tuple[float, float]]) -> NDArray[np.bool_]:
        lat, lon = np.asarray(positions, dtype=float).reshape(-1, 2).T
        return sea.is_water(lat, lon)

    def lines(positions: list[list[float]]) -> NDArray[np.bool_]:
        ends = np.asarray(positions, dtype=float).reshape(-1, 4)
        x0, y0 = to_mercator(ends[:, 0], ends[:, 1])
        x1, y1 = to_mercator(ends[:, 2], ends[:, 3])
        return sea.clear(np.stack([x0, y0, x1, y1], axis=1))

    return {"points_validity": points, "lines_validity": lines}
