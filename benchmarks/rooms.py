"""The rooms that every passage walks through: wind, polar, hull, yachts, ports."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import numpy as np

from benchmarks.hro import beside_hrosailing
from benchmarks.measure import Figures, Pace, attempt, in_ms, say, stopwatch
from benchmarks.world import World, world
from seacruise.ports import load_ports
from seacruise.resources import resource_path
from seacruise.routing.field import Handling, speed_table
from seacruise.units import MS_PER_KNOT
from seacruise.weather.sample import sample_wind
from seacruise.yacht.fleet import load_fleet
from seacruise.yacht.hull import hull_speed

POINTS: Final = 1_000_000


def rooms(pace: Pace) -> Figures:
    """Micro-benchmarks, each call as the program makes it."""
    at = world()
    figures: Figures = {}
    for name, call in _calls(at).items():
        say(f"rooms: {name}")
        figures[name] = in_ms(stopwatch(call, runs=pace.runs))
    per_point = figures["wind_at_1000000_points"]["median_ms"] * 1e6 / POINTS
    figures["wind_at_1000000_points"]["ns_per_point"] = round(per_point, 1)
    say("rooms: polars beside hrosailing")
    figures["beside_hrosailing"] = attempt(lambda: beside_hrosailing(at.yacht, runs=pace.runs))
    return figures


def _calls(at: World) -> dict[str, Callable[[], object]]:
    rng = np.random.default_rng(20161120)
    time = at.departure + rng.uniform(0.0, 40 * 3600.0, POINTS)
    lat, lon = rng.uniform(53.5, 65.5, POINTS), rng.uniform(10.0, 30.0, POINTS)
    tws, twa = np.linspace(0.0, 40.0, 200) * MS_PER_KNOT, np.linspace(0.0, 180.0, 181)
    return {
        "wind_at_1000000_points": lambda: at.wind.at(time, lat, lon),
        "polar_speed_200_winds_181_angles": lambda: at.yacht.speed(tws[:, None], twa[None, :]),
        "hull_speed_200_winds_181_angles": lambda: hull_speed(at.yacht, tws, twa),
        "speed_table_of_the_search": lambda: speed_table(at.yacht, Handling()),
        "wind_field_coarse": at.field,
        "wind_field_fine": lambda: at.field(fine=True),
        "load_fleet": lambda: load_fleet([resource_path("polars")]),
        # By its path: the shipped file is read once a process.
        "load_ports": lambda: load_ports(resource_path("ports.csv")),
        "sample_wind": sample_wind,
    }
