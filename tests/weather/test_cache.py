"""Cache and ledger: what is put is what is got, or nothing."""

from __future__ import annotations

import math
import os
import subprocess
import sys
import zlib
from datetime import UTC, datetime, timedelta
from pathlib import Path

import msgspec
import pytest
from hypothesis import HealthCheck, given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from seacruise.store import Store
from seacruise.weather.cache import _STEPS, CachedAnswer, Memory, WeatherCache, place_id
from seacruise.weather.point import PointAnswer, pack
from seacruise.weather.splice import Splice
from tests.conftest import REPOSITORY

NOW = datetime(2026, 11, 21, 9, tzinfo=UTC)
NUMBERS = st.lists(st.floats(allow_nan=False, allow_infinity=False), max_size=30).map(tuple)


@pytest.fixture
def cache(tmp_path: Path) -> WeatherCache:
    return WeatherCache(Store(tmp_path / "seacruise.sqlite"))


def kept(cache: WeatherCache | Memory, lat: float, lon: float, service: str) -> CachedAnswer | None:
    found = cache.around((lat, lon, lat, lon), service, -math.inf)
    return next(iter(cache.read(found).values()), None)


@hypothesis_settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    st.builds(
        PointAnswer,
        lat=st.floats(-90, 90),
        lon=st.floats(-180, 180),
        time=NUMBERS,
        speed=NUMBERS,
        direction=NUMBERS,
        model=st.lists(st.sampled_from(["sg", "ecmwf", "ключ", ""])).map(tuple),
        gust=NUMBERS,
        spread=NUMBERS,
        splices=st.lists(
            st.builds(Splice, time=st.floats(0, 4e9), before=st.text(), after=st.text(), jump=st.floats(0, 9))
        ).map(tuple),
        notes=st.lists(st.text()).map(tuple),
    ),
    st.floats(0, 4e9),
)
def test_what_is_put_is_what_is_got(cache: WeatherCache, answer: PointAnswer, fetched: float) -> None:
    put = CachedAnswer(answer=answer, fetched=fetched)
    cache.put(answer.lat, answer.lon, "service", put)
    got = kept(cache, answer.lat, answer.lon, "service")
    assert got is not None
    assert (got.answer, got.fetched) == (answer, fetched)
    assert kept(cache, answer.lat, answer.lon, "another") is None


ANSWER = PointAnswer(
    lat=55.0, lon=18.0, time=(0.0, 1.0), speed=(1.0, 2.0), direction=(3.0, 4.0), model=("sg", "sg")
)


@pytest.mark.parametrize("position", range(0, 200, 7))
def test_a_flipped_bit_is_a_miss_never_garbage(tmp_path: Path, position: int) -> None:
    store = Store(tmp_path / "seacruise.sqlite")
    cache = WeatherCache(store)
    cache.put(55.0, 18.0, "service", CachedAnswer(ANSWER, NOW.timestamp()))
    with store.writing() as db:
        body = bytearray(db.execute("SELECT body FROM weather_body").fetchone()[0])
        body[position % len(body)] ^= 0x10
        db.execute("UPDATE weather_body SET body = ?", (bytes(body),))
    assert kept(cache, 55.0, 18.0, "service") is None


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


def test_an_answer_that_many_overtook_is_no_new_day(cache: WeatherCache) -> None:
    for used in (4, 9, 8, 1):
        cache.note_request("key", NOW, used=used, daily=10, overtaking=9)
    assert cache.quota("key", NOW).left == 1
    # but the service counts from the beginning again when no nine requests were on their way
    cache.note_request("key", NOW, used=1, daily=10, overtaking=2)
    assert cache.quota("key", NOW).left == 9


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
    assert kept(memory, 55.0, 18.0, "service") is None
    assert memory.ages(NOW) == ()
    assert memory.quota("key", NOW).left == 10


# --- what lies in the file ------------------------------------------------------------------------

AREA = (50.0, 10.0, 60.0, 25.0)


def numbers(cache: WeatherCache, service: str = "service", reaching: float = 0.0) -> list[float]:
    return [one.fetched for one in cache.around(AREA, service, reaching)]


def test_an_answer_of_a_later_run_lies_beside_that_of_an_earlier_one(tmp_path: Path) -> None:
    store = Store(tmp_path / "seacruise.sqlite")
    cache = WeatherCache(store)
    for fetched, run in ((100.0, 0.0), (200.0, 0.0), (30_000.0, 21_600.0)):
        cache.put(55.0, 18.0, "service", CachedAnswer(ANSWER, fetched, expires=fetched + 50, run=run))
    # one for each run, and of them the latest is taken
    assert len(cache.ages(NOW)) == 2
    assert numbers(cache) == [30_000.0]
    got = kept(cache, 55.0, 18.0, "service")
    assert got == CachedAnswer(ANSWER, 30_000.0, expires=30_050.0, run=21_600.0)
    # that of the earlier run stands in for a damaged one
    with store.writing() as db:
        db.execute("UPDATE weather_body SET checksum = 0 WHERE id = (SELECT MAX(id) FROM weather_body)")
    got = kept(cache, 55.0, 18.0, "service")
    assert got is not None
    assert got.fetched == 200.0


def test_answers_are_found_by_area_source_and_reach(cache: WeatherCache) -> None:
    for lat, lon, service in ((55.0, 18.0, "service"), (61.0, 18.0, "service"), (55.0, 18.0, "another")):
        cache.put(lat, lon, service, CachedAnswer(ANSWER, 100.0))
    assert [(one.lat, one.lon) for one in cache.around(AREA, "service", 1.0)] == [(55.0, 18.0)]
    assert numbers(cache, reaching=2.0) == []
    (found,) = cache.around(AREA, "service", 0.0)
    assert cache.read([found])[found.number].answer == ANSWER
    assert cache.read([]) == {}


def test_the_oldest_answers_make_room(cache: WeatherCache, monkeypatch: pytest.MonkeyPatch) -> None:
    size = len(pack(ANSWER))
    monkeypatch.setattr("seacruise.weather.cache.MAX_BYTES", 10 * size)
    for number in range(25):
        cache.put(50.0 + 0.25 * number, 18.0, "service", CachedAnswer(ANSWER, 1000.0 + number))
    assert sorted(age for _, _, age in cache.ages(datetime.fromtimestamp(1024.0, UTC))) == [
        pytest.approx(number / 3600.0) for number in range(10)
    ]
    # bodies go with what they belong to
    with cache._store.reading() as db:
        assert db.execute("SELECT COUNT(*) FROM weather_body").fetchone() == (10,)


def test_the_file_of_an_earlier_version_is_taken_over(tmp_path: Path) -> None:
    store = Store(tmp_path / "seacruise.sqlite")
    store.migrate("weather", _STEPS[:2])
    body = zlib.compress(
        msgspec.msgpack.encode(
            {
                "lat": 55.0,
                "lon": 18.0,
                "time": [0.0, 1.0],
                "speed": [1.0, 2.0],
                "direction": [3.0, 4.0],
                "model": ["sg", "sg"],
                "notes": ["a note"],
            }
        )
    )
    with store.writing() as db:
        row = ("55.000,18.000", "service", 100.0, zlib.crc32(body), body)
        db.execute("INSERT INTO weather_answer VALUES (?, ?, ?, ?, ?)", row)
        db.execute("INSERT INTO weather_quota VALUES ('k', '2026-11-21', 3, 10)")
    cache = WeatherCache(store)
    got = kept(cache, 55.0, 18.0, "service")
    assert got is not None
    assert got.answer == msgspec.structs.replace(ANSWER, notes=("a note",))
    assert got.expires is None
    (found,) = cache.around(AREA, "service", 1e12)
    assert (found.lat, found.lon) == (55.0, 18.0)
    with store.reading() as db:
        assert db.execute("SELECT COUNT(*) FROM weather_quota").fetchone() == (1,)


def test_a_file_cut_off_in_the_middle_is_no_garbage(tmp_path: Path) -> None:
    path = tmp_path / "seacruise.sqlite"
    memory = Memory(path)
    for number in range(40):
        long = msgspec.structs.replace(ANSWER, notes=("x" * 5000,))
        memory.keep("service", CachedAnswer(msgspec.structs.replace(long, lat=50.0 + number / 4), 100.0))
    whole = path.read_bytes()
    for share in (0.1, 0.5, 0.9):
        path.write_bytes(whole[: int(len(whole) * share)])
        cut = Memory(path)
        found = cut.around((0.0, 0.0, 90.0, 90.0), "service", 0.0)
        for cached in cut.read(found).values():
            assert cached.answer.notes == ("x" * 5000,)
        cut.keep("service", CachedAnswer(ANSWER, 200.0))
        assert cut.trouble
        assert "damaged" in cut.trouble


def test_a_link_in_place_of_the_file_leads_where_it_points(tmp_path: Path) -> None:
    (tmp_path / "elsewhere").mkdir()
    link = tmp_path / "Mój jacht ⛵" / "seacruise.sqlite"
    link.parent.mkdir()
    try:
        link.symlink_to(tmp_path / "elsewhere" / "kept.sqlite")
    except OSError:
        pytest.skip("this system makes no links for ordinary users")
    Memory(link).keep("service", CachedAnswer(ANSWER, 100.0))
    assert kept(Memory(tmp_path / "elsewhere" / "kept.sqlite"), 55.0, 18.0, "service") is not None


# --- several programs -----------------------------------------------------------------------------

WRITER = """
import sys
from pathlib import Path
from seacruise.weather.cache import CachedAnswer, Memory
from seacruise.weather.point import PointAnswer
memory = Memory(Path(sys.argv[1]))
own = float(sys.argv[2])
print("ready", flush=True)
for number in range(int(sys.argv[3])):
    series = tuple(own + number / 1000 for _ in range(240))
    answer = PointAnswer(lat=50 + number % 40 / 4, lon=own, time=series, speed=series, direction=series,
        model=("sg",) * 240)
    memory.keep("service", CachedAnswer(answer, 1000.0 + number, run=0.0))
    memory.note_request("key", __import__("datetime").datetime(2026, 11, 21, 9,
        tzinfo=__import__("datetime").UTC))
if memory.trouble:
    sys.exit(memory.trouble)
"""


def writers(path: Path, count: int, answers: int) -> list[subprocess.Popen[str]]:
    return [
        subprocess.Popen(
            [sys.executable, "-c", WRITER, str(path), str(10 + number), str(answers)],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env={**os.environ, "PYTHONPATH": str(REPOSITORY)},
        )
        for number in range(count)
    ]


def assert_whole(path: Path) -> list[CachedAnswer]:
    with Store(path).reading() as db:
        assert db.execute("PRAGMA integrity_check").fetchone() == ("ok",)
        bodies = db.execute("SELECT COUNT(*) FROM weather_body").fetchone()
        assert db.execute("SELECT COUNT(*) FROM weather_forecast").fetchone() == bodies
    memory = Memory(path)
    found = memory.around((0.0, 0.0, 90.0, 90.0), "service", 0.0)
    read = list(memory.read(found).values())
    assert len(read) == len(found)
    for one in read:
        # no answer of one program is mixed with another's
        assert set(one.answer.speed) == {one.answer.speed[0]}
        assert int(one.answer.speed[0]) == int(one.answer.lon)
    return read


def test_several_programs_write_into_a_new_file_at_a_time(tmp_path: Path) -> None:
    path = tmp_path / "seacruise.sqlite"
    started = writers(path, 4, 40)
    told = [process.communicate(timeout=120) for process in started]
    assert [(process.returncode, error) for process, (_, error) in zip(started, told, strict=True)] == [
        (0, "")
    ] * 4
    assert len(assert_whole(path)) == 4 * 40
    assert Memory(path).quota("key", NOW).used == 4 * 40


def test_a_program_killed_while_it_writes_leaves_the_file_whole(tmp_path: Path) -> None:
    path = tmp_path / "seacruise.sqlite"
    started = writers(path, 2, 100_000)
    for process in started:
        assert process.stdout is not None
        assert process.stdout.readline() == "ready\n"
    memory = Memory(path)
    while len(memory.around((0.0, 0.0, 90.0, 90.0), "service", 0.0)) < 30:
        assert all(process.poll() is None for process in started)
    for process in started:
        process.kill()
        process.communicate(timeout=60)
    assert len(assert_whole(path)) >= 30
    memory.keep("service", CachedAnswer(ANSWER, NOW.timestamp()))
    assert memory.trouble == ""
