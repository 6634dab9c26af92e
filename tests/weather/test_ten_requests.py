"""A day's ten requests against a whole grid: a real forecast, served hour by hour as Storm Glass does."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from seacruise.between import sea_between
from seacruise.passage import PassageRequest, plan
from seacruise.ports import find_port, load_ports
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.weather.isolated import read_isolated
from seacruise.weather.source import fetch_wind
from seacruise.weather.wind import Wind, to_direction
from seacruise.yacht.files import read_polar
from tests.conftest import REPOSITORY
from tests.faultserver import FaultServer, Request

KEY = "ten-a-day-SECRET"
PORTS = load_ports()
START, END = find_port("Gdynia", PORTS), find_port("Stockholm", PORTS)


@pytest.fixture(scope="module")
def full(shared_data: Path) -> Wind:
    """Real GFS forecast of another coast, moved over the Baltic: 0.25 degrees, 3-hourly, 120 h."""
    return read_isolated(shared_data / "weather" / "baltic" / "RELOCATED_gfs025_120h_to_baltic.nc", job=Job())


@pytest.fixture
def server(full: Wind) -> Iterator[FaultServer]:
    def answer(request: Request) -> dict[str, Any]:
        query = request.query
        lat, lon = float(query["lat"]), float(query["lng"])
        first, last = max(float(query["start"]), full.time[0]), min(float(query["end"]), full.time[-1])
        time = np.arange(first, last + 1.0, 3600.0)
        speed, direction = to_direction(*full.at(time, lat, lon))
        hours = [
            {
                "time": datetime.fromtimestamp(one, UTC).isoformat(),
                "windSpeed": {"sg": round(float(strength), 2)},
                "windDirection": {"sg": round(float(angle), 2)},
            }
            for one, strength, angle in zip(time, speed, direction, strict=True)
        ]
        meta = {"cost": 1, "dailyQuota": 10, "lat": lat, "lng": lon}
        return {"hours": hours, "meta": meta}

    with FaultServer(quota=10, make=answer) as server:
        yield server


def fetch(
    settings: Settings, server: FaultServer, now: datetime, departure: datetime, told: list[str]
) -> Wind:
    keyed = replace(settings, stormglass_key=KEY, stormglass_url=server.url)
    sea = sea_between(START, END, keyed)
    job = Job(report=lambda stage, fraction, message: told.append(message))
    return fetch_wind(
        ["stormglass"],
        start=(START.lat, START.lon),
        end=(END.lat, END.lon),
        departure=departure,
        settings=keyed,
        job=job,
        is_water=sea.is_water,
        now=now,
    )


def test_ten_requests_plan_gdynia_stockholm_like_the_whole_grid(
    settings: Settings, full: Wind, server: FaultServer
) -> None:
    now = datetime.fromtimestamp(full.time[0], UTC) + timedelta(minutes=30)
    departures = [now + timedelta(hours=hours) for hours in (6, 24, 48)]
    told: list[str] = []
    wind = fetch(settings, server, now, departures[0], told)
    assert len(server.requests) <= 10
    assert told[0].startswith("Storm Glass: up to 9 requests")
    # the horizon is the answer's: the served forecast ends after five days, not ten
    assert wind.time[-1] == full.time[-1]
    errors = {}
    for name in ("bavaria-46-cruiser", "edel-660", "cookson-50"):
        yacht = read_polar(REPOSITORY / "polars" / f"{name}.csv")
        for departure in departures:
            asked = PassageRequest(START, END, yacht, wind, departure=departure)
            ours = plan(asked, settings=settings).duration_h
            whole = plan(replace(asked, wind=full), settings=settings).duration_h
            errors[name, departure] = ours / whole - 1.0
    assert len(errors) == 9
    assert max(map(abs, errors.values())) < 0.02, errors
    # the same passage again, at another hour and for another departure, sends nothing
    sent = len(server.requests)
    for later, departure in ((now, departures[0]), (now + timedelta(hours=4), departures[2])):
        again = fetch(settings, server, later, departure, told)
        assert len(server.requests) == sent
        np.testing.assert_array_equal(again.u, wind.u)
    assert told[-1] == f"Storm Glass: no request needed, {10 - sent} left today"
    for path in settings.data_dir.parent.rglob("*"):
        assert not path.is_file() or KEY.encode() not in path.read_bytes()
