"""Arriving by a given time: the latest departure that does."""

from __future__ import annotations

import json
from dataclasses import replace
from datetime import UTC, datetime, timedelta

import pytest

from seacruise import cli
from seacruise.arrival import plan_arrival
from seacruise.errors import InputError, NoPassageError
from seacruise.passage import PassageRequest, plan
from seacruise.ports import Port, find_port, load_ports
from seacruise.resources import resource_path
from seacruise.settings import Settings
from seacruise.weather.sample import sample_wind
from seacruise.yacht.fleet import find_yacht, load_fleet
from tests.routing.worlds import cache_dir_of

PLAN = [
    "plan",
    "--from",
    "Visby",
    "--to",
    "Västervik",
    "--yacht",
    "Bavaria 46 Cruiser",
    "--forecast",
    "sample",
]


@pytest.fixture(scope="session")
def sea_settings(tmp_path_factory: pytest.TempPathFactory) -> Settings:
    base = tmp_path_factory.getbasetemp()
    return Settings(cache_dir=cache_dir_of(base), data_dir=base / "data")


def port(name: str) -> Port:
    return find_port(name, load_ports())


def arriving(
    start: str = "Visby", end: str = "Västervik", departure: datetime | None = None
) -> PassageRequest:
    yacht = find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")]))
    return PassageRequest(port(start), port(end), yacht, sample_wind(), departure)


@pytest.mark.parametrize("hours", [14, 27, 40])
def test_the_latest_departure_arrives_in_time_and_a_later_one_does_not(
    hours: int, sea_settings: Settings
) -> None:
    deadline = datetime(2016, 11, 20, tzinfo=UTC) + timedelta(hours=hours)
    passage = plan_arrival(arriving(), deadline, settings=sea_settings)
    assert passage.arrival <= deadline
    assert passage.checks.land_free
    later = replace(arriving(), departure=passage.departure + timedelta(minutes=6))
    assert plan(later, settings=sea_settings).arrival > deadline


def test_a_late_deadline_is_met_by_the_last_hour_of_the_forecast(sea_settings: Settings) -> None:
    passage = plan_arrival(arriving(), datetime(2016, 11, 27, tzinfo=UTC), settings=sea_settings)
    assert passage.departure == sample_wind().forecast.valid_to


def test_too_early_an_arrival_names_the_earliest(sea_settings: Settings) -> None:
    earliest = plan(replace(arriving(), departure=datetime(2016, 11, 20, tzinfo=UTC)), settings=sea_settings)
    with pytest.raises(NoPassageError) as refused:
        plan_arrival(arriving(), earliest.arrival - timedelta(hours=1), settings=sea_settings)
    assert refused.value.reason == "outside-forecast"
    rounded = earliest.arrival + timedelta(seconds=59)
    assert f"{rounded:%Y-%m-%d %H:%M} UTC at the earliest" in str(refused.value)


def test_arriving_before_the_forecast_begins(sea_settings: Settings) -> None:
    with pytest.raises(NoPassageError) as refused:
        plan_arrival(arriving(), datetime(2016, 11, 19, tzinfo=UTC), settings=sea_settings)
    assert refused.value.reason == "outside-forecast"


def test_an_arrival_needs_a_time_zone(sea_settings: Settings) -> None:
    with pytest.raises(InputError):
        plan_arrival(arriving(), datetime(2016, 11, 21), settings=sea_settings)  # noqa: DTZ001


def test_plan_arrive_by(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main([*PLAN, "--arrive-by", "2016-11-21T06:00Z", "--format", "json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    arrival = datetime.fromisoformat(answer["arrival"])
    deadline = datetime(2016, 11, 21, 6, tzinfo=UTC)
    assert deadline - timedelta(minutes=30) < arrival <= deadline


def test_arrive_by_excludes_depart(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main([*PLAN, "--arrive-by", "2016-11-21T06:00Z", "--depart", "2016-11-20T06:00Z"]) == 2
    assert "either --depart or --arrive-by" in capsys.readouterr().err
