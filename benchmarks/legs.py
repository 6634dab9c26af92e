"""A leg on its own: its time, its cost, the point reached, beside hrosailing and the ellipsoid.

hrosailing 0.12 integrates well, but in degrees of 69 miles, in a projection that swaps the axes, and with
angles from the mathematical circle (`benchmarks.hro` has what comes of that). Here its conventions are met
from outside: legs are so long in its own miles as ours are in nautical ones, the wind is handed over so
that its angle comes out right, and figures are compared with our polar in the place of its table, which
reads 1.4 % off in the middle. What is left is the integration, and there it is right. Its computing time
is that with its own table.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import partial
from importlib import import_module
from typing import Any, Final

import numpy as np

from benchmarks.measure import Figures, Pace, attempt, in_ms, say, stopwatch
from benchmarks.world import DEPARTURE, Position, world
from seacruise.geodesy import destination
from seacruise.routing.field import Handling
from seacruise.routing.leg import Conditions, conditions, isochrone_point, leg_cost, leg_time
from seacruise.units import METRES_PER_NM, MS_PER_KNOT, SECONDS_PER_HOUR
from seacruise.weather.wind import Forecast, Wind, from_direction, to_direction
from seacruise.yacht.polar import Polar

START: Final[Position] = (55.0, 18.0)
COURSES: Final = (350.0, 40.0, 100.0, 160.0)
LENGTH_NM: Final = 60.0
HOURS: Final = 6.0

_ITS_MILES_PER_DEGREE: Final = 69.0


@dataclass(frozen=True, slots=True, eq=False)
class _Weather:
    """What it calls a weather model, with the wind turned so that its wind angle is the true one."""

    wind: Wind
    course: float
    its_heading: float

    def get_weather(self, point: tuple[datetime, float, float]) -> dict[str, float]:
        u, v = self.wind.at(point[0].timestamp(), *START)
        tws, twd = (float(part) for part in to_direction(u, v))
        turned = math.radians(self.its_heading - (twd - self.course) - 180.0)
        speed = tws / MS_PER_KNOT
        return {"UGRID": speed * math.cos(turned), "VGRID": speed * math.sin(turned)}


def legs(pace: Pace) -> Figures:
    """Measure our functions, and both programs side by side."""
    at = world()
    changing = _changing_wind()
    given = conditions(changing, at.yacht, Handling(tacking=False))
    figures: Figures = {
        "about": f"From {START}, wind changing with time; {LENGTH_NM:g} nm, {HOURS:g} h; hrosailing with its "
        "conventions met from outside. ratio: its computing time over ours.",
        "ours": _ours(given, pace),
    }
    say("legs: hrosailing")
    figures["hrosailing"] = attempt(lambda: _beside(given, changing, at.yacht, pace))
    say("legs: geographiclib")
    figures["geographiclib"] = attempt(lambda: _ellipsoid(given))
    return figures


def _changing_wind() -> Wind:
    """Make a wind that eases, freshens and veers, the same everywhere."""
    begin = DEPARTURE.timestamp()
    hours = np.arange(0.0, 73.0)
    speed = (11.0 + 4.0 * np.sin(hours / 3.0)) * MS_PER_KNOT
    u, v = from_direction(speed, 250.0 + 25.0 * np.sin(hours / 5.0))
    until = datetime.fromtimestamp(begin + 72 * SECONDS_PER_HOUR, UTC)
    told = Forecast("Made by hand", None, DEPARTURE, until, step_h=1.0, resolution_deg=1.0)
    lat, lon = np.array([START[0]]), np.array([START[1]])
    east, north = (part.astype(np.float32).reshape(-1, 1, 1) for part in (u, v))
    return Wind(begin + hours * SECONDS_PER_HOUR, lat, lon, east, north, told)


def _end(course: float) -> Position:
    lat, lon = destination(*START, course, LENGTH_NM * METRES_PER_NM)
    return float(lat), float(lon)


def _ours(given: Conditions, pace: Pace) -> Figures:
    begin, end = DEPARTURE.timestamp(), _end(COURSES[1])
    seconds = HOURS * SECONDS_PER_HOUR
    calls: dict[str, Callable[[], object]] = {
        "leg_time": lambda: leg_time(START, end, begin, given),
        "leg_cost": lambda: leg_cost(START, end, begin, given, density=lambda at: at.tws),
        "isochrone_point": lambda: isochrone_point(START, COURSES[1], seconds, begin, given),
    }
    return {name: in_ms(_many(call, runs=pace.runs)) for name, call in calls.items()}


def _many(call: Callable[[], object], *, runs: int, times: int = 50) -> list[float]:
    """Seconds of one call, measured over fifty: a single one is too short for the clock."""
    many = stopwatch(lambda: [call() for _ in range(times)], runs=runs)
    return [seconds / times for seconds in many]


def _beside(given: Conditions, wind: Wind, yacht: Polar, pace: Pace) -> Figures:
    with warnings.catch_warnings():
        # It uses names that NumPy and SciPy are about to drop; that is not what is measured here.
        warnings.simplefilter("ignore")
        cruising, polars = (import_module(f"hrosailing.{room}") for room in ("cruising", "polardiagram"))
        tws, twa = np.arange(1.0, 31.0), np.arange(0.0, 360.0, 1.0)
        table = yacht.speed(tws * MS_PER_KNOT, twa[:, None]) / MS_PER_KNOT
        diagram = polars.PolarDiagramTable(ws_resolution=tws, wa_resolution=twa, bsps=table)

        def exact(tws_kn: float, twa_deg: float) -> float:
            return float(yacht.speed(tws_kn * MS_PER_KNOT, twa_deg)) / MS_PER_KNOT

        ask = partial(_compared, given, wind, (cruising, diagram, exact), pace)
        return {f"course_{course:g}": ask(course) for course in COURSES}


def _compared(
    given: Conditions, wind: Wind, theirs: tuple[Any, Any, Any], pace: Pace, course: float
) -> Figures:
    cruising, table, exact = theirs
    begin, end = DEPARTURE.timestamp(), _end(course)
    # On this line of its own plane the length in its miles is ours in nautical ones.
    line = (0.0, 0.0), (LENGTH_NM / _ITS_MILES_PER_DEGREE, 0.0)
    course_of = vars(import_module("hrosailing.cruising.basics"))["_right_handing_course"]
    heading = float(course_of(*line))
    weather = _Weather(wind, course, heading)
    along = _Weather(wind, course, course)

    def strength(when: datetime, _lat: float, _lon: float, model: _Weather) -> float:
        return float(np.hypot(*model.wind.at(when.timestamp(), *START))) / MS_PER_KNOT

    def cost(polar: Any, **how: Any) -> float:
        # Left alone the solver takes a dozen steps, too few for the trapezia under a density.
        fine = {"max_step": 1.0} if polar is exact else {}
        return float(cruising.cost_cruise(polar, *line, DEPARTURE, weather, **how, **fine))

    def reach(polar: Any) -> float:
        return float(cruising.isochrone(polar, (0.0, 0.0), DEPARTURE, course, along, total_time=HOURS)[1])

    def ours_density() -> float:
        return leg_cost(START, end, begin, given, density=lambda at: at.tws / MS_PER_KNOT) / METRES_PER_NM

    def ours_reach() -> float:
        return isochrone_point(START, course, HOURS * SECONDS_PER_HOUR, begin, given).distance / METRES_PER_NM

    nothing = {"cost_fun_dens": strength, "cost_fun_abs": lambda _t, _s: 0.0}
    pairs: dict[str, tuple[Callable[[Any], float], Callable[[], float]]] = {
        "time_h": (cost, lambda: leg_time(START, end, begin, given) / SECONDS_PER_HOUR),
        "wind_along_kn_nm": (lambda polar: cost(polar, **nothing), ours_density),
        f"reached_in_{HOURS:g}_h_nm": (reach, ours_reach),
    }
    return {
        name: _pair((partial(its, exact), partial(its, table)), ours, runs=pace.runs)
        for name, (its, ours) in pairs.items()
    }


def _pair(
    theirs: tuple[Callable[[], float], Callable[[], float]], ours: Callable[[], float], *, runs: int
) -> Figures:
    exact, as_it_is = theirs
    its_value, our_value = exact(), ours()
    slow, fast = in_ms(stopwatch(as_it_is, runs=runs)), in_ms(_many(ours, runs=runs))
    return {
        "hrosailing": round(its_value, 4),
        "ours": round(our_value, 4),
        "difference_percent": round(100.0 * (our_value / its_value - 1.0), 3),
        "its_computing": slow,
        "our_computing": fast,
        "ratio": round(slow["median_ms"] / fast["median_ms"], 1),
    }


def _ellipsoid(given: Conditions) -> Figures:
    """Distances of the points reached against the ellipsoid, on which the earth is no sphere."""
    geodesic = import_module("geographiclib.geodesic").Geodesic.WGS84
    begin = DEPARTURE.timestamp()
    figures: Figures = {}
    for course in COURSES:
        point = isochrone_point(START, course, HOURS * SECONDS_PER_HOUR, begin, given)
        true = geodesic.Inverse(*START, point.lat, point.lon)["s12"]
        figures[f"course_{course:g}"] = {
            "ours_nm": round(point.distance / METRES_PER_NM, 4),
            "ellipsoid_nm": round(true / METRES_PER_NM, 4),
            "difference_percent": round(100.0 * (point.distance / true - 1.0), 3),
        }
    return figures
