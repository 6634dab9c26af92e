"""The JSON object is a contract: key for key, nothing more."""

from __future__ import annotations

import dataclasses
import json
from datetime import UTC, datetime, timedelta, timezone

import pytest

from seacruise.export.jsonform import dumps, format_time, passage_to_json
from seacruise.passage import Passage

CONTRACT = {
    "schema": None,
    "start": {"name", "lat", "lon"},
    "end": {"name", "lat", "lon"},
    "yacht": None,
    "departure": None,
    "arrival": None,
    "duration_h": None,
    "distance_nm": None,
    "direct_distance_nm": None,
    "mean_speed_kn": None,
    "tacks": None,
    "gybes": None,
    "course_changes": None,
    "max_tws_kn": None,
    "motor_h": None,
    "fuel_l": None,
    "beyond_forecast_h": None,
    "forecast": {"source", "issued", "valid_from", "valid_to", "step_h", "resolution_deg"},
    "waypoints": None,
    "lower_bound_h": None,
    "checks": {"resailed_h", "land_free", "zones_free", "within_limits"},
    "search": {"directions", "spacing_nm", "vertices", "edges", "settled", "seconds"},
}
LEG = ("course_deg", "leg_nm", "boat_speed_kn", "tws_kn", "twd_deg", "twa_deg", "motor")
WAYPOINT = ("lat", "lon", "time", *LEG)


def test_keys_are_those_of_the_contract_in_its_order(passage: Passage) -> None:
    data = passage_to_json(passage)
    assert list(data) == list(CONTRACT)
    for key, inner in CONTRACT.items():
        if inner is not None:
            assert set(data[key]) == inner, key
    assert all(tuple(waypoint) == WAYPOINT for waypoint in data["waypoints"])
    assert set(data["search"]["seconds"]) == {"sea", "lattice", "wind", "search", "refine", "check"}
    assert data["schema"] == "seacruise.passage/1"


def test_figures_agree_with_each_other(passage: Passage) -> None:
    data = json.loads(dumps(passage_to_json(passage)))
    departure, arrival = datetime.fromisoformat(data["departure"]), datetime.fromisoformat(data["arrival"])
    assert (arrival - departure) / timedelta(hours=1) == pytest.approx(data["duration_h"], abs=0.001)
    legs = data["waypoints"][:-1]
    assert sum(leg["leg_nm"] for leg in legs) == pytest.approx(data["distance_nm"], abs=0.01)
    assert data["mean_speed_kn"] == pytest.approx(data["distance_nm"] / data["duration_h"], abs=0.001)
    assert (data["start"]["lat"], data["start"]["lon"]) == (legs[0]["lat"], legs[0]["lon"])
    assert data["waypoints"][-1]["time"] == data["arrival"]


def test_legs_are_null_at_the_end(passage: Passage) -> None:
    *legs, end = passage_to_json(passage)["waypoints"]
    assert all(end[key] is None for key in LEG)
    assert all(leg[key] is not None for leg in legs for key in LEG)


def test_unknown_is_null_and_never_nan(passage: Passage) -> None:
    odd = dataclasses.replace(
        passage,
        max_tws_kn=float("nan"),
        lower_bound_h=float("inf"),
        forecast=dataclasses.replace(passage.forecast, issued=None),
    )
    data = json.loads(dumps(passage_to_json(odd)), parse_constant=pytest.fail)
    assert data["max_tws_kn"] is None
    assert data["lower_bound_h"] is None
    assert data["forecast"]["issued"] is None


def test_times_are_utc_to_the_second() -> None:
    warsaw = timezone(timedelta(hours=1))
    assert format_time(datetime(2016, 11, 20, 7, 0, tzinfo=warsaw)) == "2016-11-20T06:00:00Z"
    assert format_time(datetime(2016, 12, 31, 23, 59, 59, 600_000, tzinfo=UTC)) == "2017-01-01T00:00:00Z"


def test_the_same_passage_gives_the_same_text(passage: Passage) -> None:
    assert dumps(passage_to_json(passage)) == dumps(passage_to_json(passage))
