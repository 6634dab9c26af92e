"""Many plans at a time: few connections, every answer where it belongs; and a cache of a thousand answers."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest

from seacruise.errors import WeatherError
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.store import Store
from seacruise.weather.cache import CachedAnswer, Memory, WeatherCache
from seacruise.weather.http import Limits
from seacruise.weather.point import PointAnswer
from seacruise.weather.pool import Gate, Outcome, gate_to, run_all
from seacruise.weather.stormglass import StormGlass, StormGlassConfig, service_of
from seacruise.weather.wind import Wind
from tests.faultserver import FaultServer, Request

NOW = datetime(2026, 11, 21, 9, 30, tzinfo=UTC)
PATIENT = Limits(read_s=60.0, total_s=60.0)


def wind_of_the_place(request: Request) -> dict[str, Any]:
    """Answer with a west wind of as many cm/s as the place has quarter degrees, so that none is mistaken."""
    lat, lon = float(request.query["lat"]), float(request.query["lng"])
    begin = datetime.fromtimestamp(float(request.query["start"]), UTC)
    speed = place_speed(lat, lon)
    hours = [
        {
            "time": (begin + timedelta(hours=number)).isoformat(),
            "windSpeed": {"sg": speed},
            "windDirection": {"sg": 270.0},
        }
        for number in range(48)
    ]
    return {"hours": hours, "meta": {"dailyQuota": 5000, "cost": 1, "lat": lat, "lng": lon}}


def place_speed(lat: float, lon: float) -> float:
    return round((lat - 40.0) * 0.2 + (lon + 20.0) * 0.1 + 2.0, 4)


def boxes(count: int) -> list[tuple[float, float, float, float]]:
    return [
        (45.0 + number % 20, -10.0 + 2 * (number // 20), 45.5 + number % 20, -9.5 + 2 * (number // 20))
        for number in range(count)
    ]


def fetch(settings: Settings, config: StormGlassConfig, box: tuple[float, float, float, float]) -> Wind:
    return StormGlass(settings, config).wind(box, departure=None, now=NOW, job=Job())


def assert_own_answers(wind: Wind, box: tuple[float, float, float, float]) -> None:
    middle = (box[0] + box[2]) / 2, (box[1] + box[3]) / 2
    u, v = wind.at(NOW.timestamp(), *middle)
    assert float(u) == pytest.approx(place_speed(*middle), abs=0.06)
    assert float(v) == pytest.approx(0.0, abs=1e-3)


def test_two_hundred_plans_share_five_connections(settings: Settings) -> None:
    config = StormGlassConfig(limits=PATIENT, max_points=1, first=1, quiet_s=60.0)
    asked = boxes(200)
    with FaultServer("slow", quota=10**6, slow_s=0.2, make=wind_of_the_place) as server:
        there = replace(settings, stormglass_key="secret", stormglass_url=server.url)
        with ThreadPoolExecutor(200) as pool:
            winds = list(pool.map(lambda box: fetch(there, config, box), asked))
        assert server.most_at_once <= 5
        # one place for each, and none asked twice
        places = {(request.query["lat"], request.query["lng"]) for request in server.requests}
        assert len(server.requests) == len(places) == 200
    for box, wind in zip(asked, winds, strict=True):
        assert_own_answers(wind, box)
        assert wind.forecast.notice == ""
    assert Memory(there.database).quota("secret", NOW).used == 200


# --- the pool by itself ---------------------------------------------------------------------------


def late() -> WeatherError:
    return WeatherError("Too late.", reason="timeout")


def run(work: Callable[[int, threading.Event], int], count: int, **options: Any) -> list[Outcome[int]]:
    options = {"parallel": 2, "each_s": 30.0, "batch_s": 60.0, "on_done": lambda *_: True, **options}
    return run_all(list(range(count)), work, job=Job(), late=late, **options)


def test_a_gate_is_one_for_all_who_name_it() -> None:
    assert gate_to("http://a", 5) is not gate_to("http://b", 5)
    gate = gate_to("http://a", 5)
    assert gate_to("http://a", 5) is gate


def test_batches_at_one_gate_take_turns() -> None:
    gate, lock = Gate(2), threading.Lock()
    inside, most = 0, 0

    def work(task: int, stop: threading.Event) -> int:
        nonlocal inside, most
        with lock:
            inside += 1
            most = max(most, inside)
        stop.wait(0.01)
        with lock:
            inside -= 1
        return task

    with ThreadPoolExecutor(4) as pool:
        # as for the batch's deadline, waiting at the gate does not count
        results = list(pool.map(lambda _: run(work, 8, gate=gate, batch_s=30.0), range(4)))
    assert most <= 2
    assert all([outcome.value for outcome in result] == list(range(8)) for result in results)


def test_silence_ends_all_tasks_and_frees_the_gate() -> None:
    gate = Gate(2)
    never = threading.Event()

    def work(task: int, stop: threading.Event) -> int:
        never.wait(20)
        return task

    outcomes = run(work, 9, gate=gate, quiet_s=0.2)
    assert [outcome.error is not None and outcome.error.reason for outcome in outcomes] == ["timeout"] * 9
    assert gate.enter(0.0)
    assert gate.enter(0.0)
    never.set()


def test_whoever_hears_something_waits_on() -> None:
    # the first two answers come one after the other, later than the silence that is borne
    def work(task: int, stop: threading.Event) -> int:
        stop.wait(0.25 * (task + 1))
        return task

    outcomes = run(work, 4, parallel=4, quiet_s=0.6)
    assert [outcome.value for outcome in outcomes] == [0, 1, 2, 3]


# --- a thousand answers ---------------------------------------------------------------------------


def test_a_thousand_answers_are_listed_without_being_read(tmp_path: Path) -> None:
    store = Store(tmp_path / "seacruise.sqlite")
    cache = WeatherCache(store)
    # while somebody looks on, nobody tidies up after each of a thousand writes
    with store.reading() as db:
        db.execute("SELECT COUNT(*) FROM weather_forecast").fetchall()
        for number in range(1000):
            lat, lon = 50.0 + 0.25 * (number // 40), 10.0 + 0.25 * (number % 40)
            series = (place_speed(lat, lon),) * 240
            answer = PointAnswer(lat, lon, series, series, series, model=("sg",) * 240, gust=series)
            cache.put(lat, lon, service_of("sg"), CachedAnswer(answer, NOW.timestamp(), run=0.0))
    memory = Memory(store.path)
    assert len(memory.ages(NOW)) == 1000
    found = memory.around((-90.0, -180.0, 90.0, 180.0), service_of("sg"), 0.0)
    assert len({(one.lat, one.lon) for one in found}) == 1000
    # what is listed is a few pages of the file; the bodies are the rest
    with store.reading() as db:
        db.execute("DELETE FROM weather_body WHERE id % 2 = 0")
    assert len(memory.around((-90.0, -180.0, 90.0, 180.0), service_of("sg"), 0.0)) == 1000
    read = memory.read(found)
    assert len(read) == 500
    for one in read.values():
        assert set(one.answer.gust) == {place_speed(one.answer.lat, one.answer.lon)}
