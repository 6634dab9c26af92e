"""Cache and ledger: what is put is what is got, or nothing."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from seacruise.store import Store
from seacruise.weather.cache import CachedAnswer, Memory, PointAnswer, WeatherCache, place_id

NOW = datetime(2026, 11, 21, 9, tzinfo=UTC)
NUMBERS = st.lists(st.floats(allow_nan=False, allow_infinity=False), max_size=30).map(tuple)


@pytest.fixture
def cache(tmp_path: Path) -> WeatherCache:
    return WeatherCache(Store(tmp_path / "seacruise.sqlite"))


@hypothesis_settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    st.builds(
        PointAnswer,
        lat=st.floats(-90, 90),
        lon=st.floats(-180, 180),
        time=NUMBERS,
        speed=NUMBERS,
        direction=NUMBERS,
        model=st.lists(st.text()).map(tuple),
        notes=st.lists(st.text()).map(tuple),
    ),
    st.floats(0, 4e9),
)
def test_what_is_put_is_what_is_got(cache: WeatherCache, answer: PointAnswer, fetched: float) -> None:
    put = CachedAnswer(answer=answer, fetched=fetched)
    cache.put(answer.lat, answer.lon, "service", put)
    assert cache.get(answer.lat, answer.lon, "service") == put
    assert cache.get(answer.lat, answer.lon, "another") is None


ANSWER = PointAnswer(
    lat=55.0, lon=18.0, time=(0.0, 1.0), speed=(1.0, 2.0), direction=(3.0, 4.0), model=("sg", "sg")
)


@pytest.mark.parametrize("position", range(0, 200, 7))
def test_a_flipped_bit_is_a_miss_never_garbage(tmp_path: Path, position: int) -> None:
    store = Store(tmp_path / "seacruise.sqlite")
    cache = WeatherCache(store)
    cache.put(55.0, 18.0, "service", CachedAnswer(ANSWER, NOW.timestamp()))
    with store.writing() as db:
        body = bytearray(db.execute("SELECT body FROM weather_answer").fetchone()[0])
        body[position % len(body)] ^= 0x10
        db.execute("UPDATE weather_answer SET body = ?", (bytes(body),))
    assert cache.get(55.0, 18.0, "service") is None


def test_places_are_rounded_to_a_hundred_metres() -> None:
    assert place_id(54.5, 18.6) == "54.500,18.600"
    assert place_id(54.50004, 18.6) == place_id(54.5, 18.60004)
    assert place_id(-0.0001, 0.0) == place_id(0.0, 0.0)


def test_answers_too_old_for_anything_are_thrown_away(cache: WeatherCache) -> None:
    cache.put(55.0, 18.0, "service", CachedAnswer(ANSWER, NOW.timestamp()))
    cache.put(56.0, 18.0, "service", CachedAnswer(ANSWER, (NOW + timedelta(days=11)).timestamp()))
    assert cache.ages(NOW + timedelta(days=11, hours=2)) == (("service", "56.000,18.000", 2.0),)


def test_the_ledger_keeps_the_highest_count_of_a_day(cache: WeatherCache) -> None:
    assert cache.quota("key", NOW) == cache.quota("other", NOW)
    assert (cache.quota("key", NOW).left, cache.quota("key", NOW).known) == (10, False)
    for used in (3, 2):
        cache.note_request("key", NOW, used=used, daily=50)
    assert cache.quota("key", NOW).left == 47
    cache.note_request("key", NOW)
    assert cache.quota("key", NOW).left == 46
    cache.note_request("key", NOW, spent=True)
    assert cache.quota("key", NOW).left == 0
    tomorrow = cache.quota("key", NOW + timedelta(hours=15))
    assert (tomorrow.left, tomorrow.known) == (50, False)
    assert cache.quota("other", NOW).left == 10


def test_the_key_is_nowhere_in_the_file(tmp_path: Path) -> None:
    path = tmp_path / "seacruise.sqlite"
    WeatherCache(Store(path)).note_request("my-secret-key", NOW, used=1, daily=10)
    for file in tmp_path.iterdir():
        assert b"my-secret-key" not in file.read_bytes()


def test_memory_without_a_file_forgets_and_says_why(tmp_path: Path) -> None:
    path = tmp_path / "seacruise.sqlite"
    path.write_bytes(b"not a database " * 500)
    memory = Memory(path)
    memory.keep("service", CachedAnswer(ANSWER, NOW.timestamp()))
    memory.note_request("key", NOW, used=3)
    assert "damaged" in memory.trouble
    assert memory.recall(55.0, 18.0, "service") is None
    assert memory.ages(NOW) == ()
    assert memory.quota("key", NOW).left == 10
