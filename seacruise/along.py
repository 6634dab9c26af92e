"""Sail waypoints that somebody else chose: in another wind, or from another moment on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, datetime
from typing import TYPE_CHECKING, Final

import numpy as np

from seacruise.geodesy import great_circle_m, to_mercator
from seacruise.model import Passage, PassageRequest
from seacruise.passage import how_of
from seacruise.units import METRES_PER_NM

if TYPE_CHECKING:
    from seacruise.routing.resail import Resailed
    from seacruise.sea import Sea

Position = tuple[float, float]

UNDER_WAY: Final = "Under way"
"""Name of the place from which a passage is planned anew."""

ARRIVED_NM: Final = 0.2
"""Nearer to the end than this there is nothing left to plan [nm]."""

SAME_M: Final = 1.0
"""Waypoints nearer to each other than this are one [m of the Mercator plane]."""


def distinct(waypoints: Sequence[Position]) -> list[Position]:
    """Leave out each waypoint that lies at the one before it: there is no course between the two."""
    x, y = to_mercator(*np.array(waypoints, dtype=np.float64).T)
    apart = np.append(True, np.hypot(np.diff(x), np.diff(y)) > SAME_M)
    return [place for place, kept in zip(waypoints, apart.tolist(), strict=True) if kept]


def waypoints_of(passage: Passage) -> list[Position]:
    """Positions of a passage's waypoints, `distinct`."""
    return distinct([(w.lat, w.lon) for w in passage.waypoints])


def apart_nm(a: Position, b: Position) -> float:
    """Distance of two positions [nm]."""
    return float(great_circle_m(*a, *b)) / METRES_PER_NM


def format_utc(time: datetime) -> str:
    """Write a time for a sentence: ``2016-11-20 06:00 UTC``."""
    return f"{time.astimezone(UTC):%Y-%m-%d %H:%M} UTC"


def sail_along(
    request: PassageRequest,
    waypoints: Sequence[Position],
    *,
    departure: float,
    sea: Sea,
) -> Resailed:
    """Sail along waypoints in the wind of a request, step by step as every finished passage is sailed again.

    Where the wind heads her, or comes from dead astern, she makes good the convex hull of her polar: whoever
    follows waypoints tacks when they must. Without tacking she stops there, and ``arrived`` is ``False``.

    Parameters
    ----------
    request
        Its wind, yacht, options and zones count.
    waypoints
        At least two positions ``lat, lon`` [degrees], the first one where she is; see `distinct`.
    departure
        Seconds since 1970 at the first waypoint.
    """
    from seacruise.routing.find import Question
    from seacruise.routing.manoeuvres import Course
    from seacruise.routing.resail import resail
    from seacruise.weather.beyond import extend

    lat, lon = np.array(waypoints, dtype=np.float64).T
    x, y = to_mercator(lat, lon)
    asked = Question(
        sea,
        extend(request.wind, request.options.beyond),
        request.yacht,
        replace(how_of(request.options), refine=False),
        waypoints[0],
        waypoints[-1],
        departure,
        request.zones,
        request.current or request.wind.current,
    )
    course = Course(x, y, np.ones(x.size - 1, dtype=bool))
    return resail(asked, course, fuel_rate_l_h=request.options.fuel_rate_l_h)
