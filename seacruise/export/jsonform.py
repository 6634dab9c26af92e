"""The passage as JSON: schema ``seacruise.passage/1``, which scripts rely on key for key."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from datetime import UTC, datetime, timedelta
from typing import TYPE_CHECKING, Any

from seacruise.passage import SCHEMA, Passage, Place, Waypoint
from seacruise.weather.wind import Forecast

if TYPE_CHECKING:
    from seacruise.tradeoff import Choice

STAGES = ("sea", "lattice", "wind", "search", "refine", "check")


def format_time(time: datetime) -> str:
    """Write a time as ``2016-11-20T06:00:00Z``, rounded to the second."""
    rounded = time.astimezone(UTC) + timedelta(microseconds=500_000)
    return rounded.strftime("%Y-%m-%dT%H:%M:%SZ")


def dumps(data: Any) -> str:
    """JSON text of our answers: readable, UTF-8, and never NaN, which is not JSON."""
    return json.dumps(data, indent=2, ensure_ascii=False, allow_nan=False)


def number(value: float | None, digits: int) -> float | None:
    """Round for the reader; ``None`` for what is not known or not finite."""
    return None if value is None or not math.isfinite(value) else round(float(value), digits)


def passage_to_json(passage: Passage) -> dict[str, Any]:
    """Put a passage into the object of the command line's contract.

    ``start`` and ``end`` are where the passage begins and ends, that is the ports as snapped to water.
    The keys are fixed by the schema. Only what was asked for besides adds one: in a current there are
    ``sog_kn``, ``steer_deg``, ``current_kn`` and ``current_to_deg`` at each waypoint, where turning
    costs time there is ``manoeuvre_h``, and where the last wind is not held after the forecast its
    ``beyond`` says what is done (``fade``, ``refuse``).
    """
    search = passage.search
    turning = {"manoeuvre_h": number(passage.manoeuvre_h, 4)} if passage.manoeuvre_h > 0.0 else {}
    return {
        "schema": SCHEMA,
        "start": _place(passage.start),
        "end": _place(passage.end),
        "yacht": passage.yacht,
        "departure": format_time(passage.departure),
        "arrival": format_time(passage.arrival),
        "duration_h": number(passage.duration_h, 4),
        "distance_nm": number(passage.distance_nm, 3),
        "direct_distance_nm": number(passage.direct_distance_nm, 3),
        "mean_speed_kn": number(passage.mean_speed_kn, 3),
        "tacks": passage.tacks,
        "gybes": passage.gybes,
        "course_changes": passage.course_changes,
        **turning,
        "max_tws_kn": number(passage.max_tws_kn, 2),
        "motor_h": number(passage.motor_h, 4),
        "fuel_l": number(passage.fuel_l, 2),
        "beyond_forecast_h": number(passage.beyond_forecast_h, 4),
        "forecast": {
            **forecast_to_json(passage.forecast),
            **({} if passage.beyond == "hold" else {"beyond": passage.beyond}),
        },
        "waypoints": [_waypoint(waypoint) for waypoint in passage.waypoints],
        "lower_bound_h": number(passage.lower_bound_h, 4),
        "checks": {
            "resailed_h": number(passage.checks.resailed_h, 4),
            "land_free": passage.checks.land_free,
            "zones_free": passage.checks.zones_free,
            "within_limits": passage.checks.within_limits,
        },
        "search": {
            "directions": search.directions,
            "spacing_nm": number(search.spacing_nm, 4),
            "vertices": search.vertices,
            "edges": search.edges,
            "settled": search.settled,
            "seconds": {stage: number(search.seconds.get(stage, 0.0), 6) for stage in STAGES},
        },
    }


def trade_off_to_json(choices: Sequence[Choice]) -> list[dict[str, Any]]:
    """Put the choices between time and changes of course into what ``--trade-off`` adds to a passage."""
    return [
        {
            "course_changes": choice.course_changes,
            "duration_h": number(choice.duration_h, 4),
            "distance_nm": number(choice.distance_nm, 3),
            "tacks": choice.tacks,
            "gybes": choice.gybes,
        }
        for choice in choices
    ]


def forecast_to_json(forecast: Forecast) -> dict[str, Any]:
    """Put the origin of a wind into the object that a passage carries."""
    return {
        "source": forecast.source,
        "issued": None if forecast.issued is None else format_time(forecast.issued),
        "valid_from": format_time(forecast.valid_from),
        "valid_to": format_time(forecast.valid_to),
        "step_h": number(forecast.step_h, 4),
        "resolution_deg": number(forecast.resolution_deg, 4),
    }


def _place(place: Place) -> dict[str, Any]:
    return {"name": place.name, "lat": number(place.lat, 6), "lon": number(place.lon, 6)}


def _waypoint(waypoint: Waypoint) -> dict[str, Any]:
    besides: dict[str, Any] = {} if waypoint.sail is None else {"sail": waypoint.sail}
    if waypoint.current_kn is not None:
        besides |= {
            "sog_kn": number(waypoint.sog_kn, 3),
            "steer_deg": number(waypoint.steer_deg, 2),
            "current_kn": number(waypoint.current_kn, 3),
            "current_to_deg": number(waypoint.current_to_deg, 2),
        }
    return {
        "lat": number(waypoint.lat, 6),
        "lon": number(waypoint.lon, 6),
        "time": format_time(waypoint.time),
        "course_deg": number(waypoint.course_deg, 2),
        "leg_nm": number(waypoint.leg_nm, 4),
        "boat_speed_kn": number(waypoint.boat_speed_kn, 3),
        "tws_kn": number(waypoint.tws_kn, 3),
        "twd_deg": number(waypoint.twd_deg, 2),
        "twa_deg": number(waypoint.twa_deg, 2),
        "motor": waypoint.motor,
        **besides,
    }
