"""Saved passages: opened after a restart exactly as they were shown, whatever has happened to the file."""

from __future__ import annotations

import json
import os
import sqlite3
import subprocess
import sys
from contextlib import closing
from dataclasses import fields, is_dataclass, replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.errors import InputError
from seacruise.export.jsonform import dumps, passage_to_json
from seacruise.export.textform import passage_to_text
from seacruise.model import Options
from seacruise.passages import MOST_LETTERS, UNDO_S, Asked, SavedPassages
from seacruise.ports import Port
from seacruise.records import pack, unpack
from seacruise.resources import resource_path
from seacruise.sea.zones import Zone
from seacruise.store import Store, StoreError
from seacruise.weather.beyond import extend
from seacruise.weather.wind import Current, Wind
from seacruise.yacht.fleet import find_yacht, load_fleet
from seacruise.yacht.polar import Polar
from tests.passages import hand_made_passage, veering_wind

NOW = datetime(2016, 11, 20, 5, 30, tzinfo=UTC)
SQUARE = np.array([[18.0, 56.0], [18.2, 56.0], [18.2, 56.1], [18.0, 56.0]])


@pytest.fixture(scope="module")
def yacht() -> Polar:
    return find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")]))


@pytest.fixture
def asked(yacht: Polar) -> Asked:
    return Asked(
        start=Port("Gdynia", "PL", 54.5189, 18.5531),
        end=Port("Sandhamn", "SE", 59.2875, 18.9106),
        departure=datetime(2016, 11, 20, 6, tzinfo=UTC),
        yacht=yacht,
        forecast=("a.grb", "open-meteo"),
        options=Options(motor_below_kn=3.0, beyond="fade"),
        weights=(2.0, 1.0),
        current="current.nc",
        via=Port("", "", 57.0, 18.0),
        avoid=(Zone("Range", (SQUARE,), valid_to=1.5e9),),
    )


@pytest.fixture
def shelf(tmp_path: Path) -> SavedPassages:
    return SavedPassages(tmp_path / "seacruise.sqlite")


def windy() -> Wind:
    """The test's wind with everything a forecast can bring."""
    wind = veering_wind()
    tenth = np.float32(0.1)
    current = Current(wind.time, wind.lat, wind.lon, wind.u * tenth, wind.v * tenth, wind.forecast)
    gust = (np.hypot(wind.u, wind.v) * 1.3).astype(np.float32)
    return replace(
        wind,
        gust=gust,
        wave=gust * tenth,
        spread=gust * tenth,
        current=current,
        members=(wind, veering_wind()),
    )


def same(one: Any, two: Any) -> None:
    """Hold two values against each other to the last bit, all the way down."""
    assert type(one) is type(two)
    if is_dataclass(one) and not isinstance(one, type):
        for field in fields(one):
            if field.name not in {"_curves", "lattice_edges"}:
                same(getattr(one, field.name), getattr(two, field.name))
    elif isinstance(one, np.ndarray):
        assert one.dtype == two.dtype
        np.testing.assert_array_equal(one, two)
    elif isinstance(one, tuple):
        assert len(one) == len(two)
        for a, b in zip(one, two, strict=True):
            same(a, b)
    else:
        assert one == two


# ----------------------------------------------------------------------------------------- as it was


def test_it_is_opened_exactly_as_it_was_shown(shelf: SavedPassages, asked: Asked, tmp_path: Path) -> None:
    passage = hand_made_passage()
    entry = shelf.save(passage, asked, windy(), now=NOW)
    opened = SavedPassages(tmp_path / "seacruise.sqlite").open(entry.number)
    same(opened.passage, passage)
    same(opened.asked, asked)
    assert json.loads(opened.json) == passage_to_json(passage)
    assert opened.json == dumps(passage_to_json(opened.passage))
    assert passage_to_text(opened.passage, now=NOW) == passage_to_text(passage, now=NOW)
    assert opened.entry == entry == shelf.listing().entries[0]
    assert opened.to_replan().waypoints[-1].time == passage.arrival.replace(microsecond=0) + timedelta(
        seconds=round(passage.arrival.microsecond / 1e6)
    )


def test_another_process_opens_the_same(shelf: SavedPassages, asked: Asked, tmp_path: Path) -> None:
    entry = shelf.save(hand_made_passage(), asked, windy(), now=NOW)
    program = (
        "import sys\nfrom pathlib import Path\n"
        "from seacruise.passages import SavedPassages\n"
        "opened = SavedPassages(Path(sys.argv[1])).open(int(sys.argv[2]))\n"
        "print([(w.lat.hex(), w.lon.hex(), w.time.isoformat()) for w in opened.passage.waypoints])\n"
        "print(opened.passage.notices)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", program, str(tmp_path / "seacruise.sqlite"), str(entry.number)],
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=True,
        env={**os.environ, "PYTHONIOENCODING": "utf-8"},
        cwd=Path(__file__).resolve().parent.parent,
    )
    wanted = hand_made_passage()
    points = [(w.lat.hex(), w.lon.hex(), w.time.isoformat()) for w in wanted.waypoints]
    assert done.stdout.splitlines() == [str(points), str(wanted.notices)]


def test_the_wind_on_the_way_is_the_wind_it_was(shelf: SavedPassages, asked: Asked) -> None:
    passage, wind = hand_made_passage(), windy()
    kept = shelf.open(shelf.save(passage, asked, wind, now=NOW).number).wind
    track = passage.track
    for name, before, after in (("wind", wind, kept), ("current", wind.current, kept.current)):
        assert before is not None, name
        assert after is not None, name
        for a, b in zip(
            before.at(track.time, track.lat, track.lon), after.at(track.time, track.lat, track.lon),
            strict=True,
        ):  # fmt: skip
            np.testing.assert_allclose(a, b, rtol=1e-6, atol=1e-6, err_msg=name)
    assert wind.gust is not None
    assert kept.gust is not None
    np.testing.assert_allclose(
        wind.interpolate(wind.gust, track.time, track.lat, track.lon),
        kept.interpolate(kept.gust, track.time, track.lat, track.lon),
        rtol=1e-6,
    )
    assert kept.u.size < wind.u.size / 3
    assert kept.members == ()
    assert kept.covers(track.lat, track.lon).all()


def test_what_is_left_of_the_wind_is_what_it_says(shelf: SavedPassages, asked: Asked) -> None:
    """Whoever plans another departure in it must be told where it ends."""
    passage, wind = hand_made_passage(), windy()
    hours = wind.time[0] + np.arange(0.0, 200.0) * 3600.0
    long = replace(
        wind, time=hours, u=np.repeat(wind.u[:1], 200, 0), v=np.repeat(wind.v[:1], 200, 0), gust=None,
        wave=None, spread=None, current=None, members=(),
        forecast=replace(wind.forecast, valid_to=datetime.fromtimestamp(float(hours[-1]), UTC)),
    )  # fmt: skip
    opened = shelf.open(shelf.save(passage, asked, long, now=NOW).number)
    assert opened.wind.forecast.valid_to.timestamp() == opened.wind.time[-1]
    assert opened.wind.forecast.valid_from.timestamp() == opened.wind.time[0]
    assert passage.arrival.timestamp() <= opened.wind.time[-1] <= passage.arrival.timestamp() + 3600.0
    assert opened.passage.forecast == passage.forecast


def test_a_wind_that_fades_goes_on_fading_as_it_did(shelf: SavedPassages, asked: Asked) -> None:
    passage, wind = replace(hand_made_passage(), beyond="fade"), windy()
    whole = extend(wind, "fade")
    kept = extend(shelf.open(shelf.save(passage, asked, wind, now=NOW).number).wind, "fade")
    late = wind.time[-1] + np.array([0.0, 9.0, 24.0, 48.0]) * 3600.0
    here = passage.track.lat[-1], passage.track.lon[-1]
    np.testing.assert_allclose(kept.at(late, *here), whole.at(late, *here), rtol=1e-6)
    assert kept.forecast.valid_to == wind.forecast.valid_to


def test_where_it_is_from_and_how_old(shelf: SavedPassages, asked: Asked) -> None:
    passage = hand_made_passage()
    real = replace(passage.forecast, source="Open-Meteo", real=True)
    entry = shelf.save(replace(passage, forecast=real), asked, windy(), now=NOW)
    told = entry.provenance(datetime(2016, 11, 21, 7, tzinfo=UTC))
    assert told == "Computed on Sun 20 Nov 2016 05:30 UTC with Open-Meteo; that forecast is 31 h old."
    assert entry.provenance(datetime(2016, 11, 25, tzinfo=UTC)).endswith("that forecast is 5 days old.")
    nameless = replace(passage, forecast=replace(real, issued=None))
    assert "does not say" in shelf.save(nameless, asked, windy(), now=NOW).provenance(NOW)
    assert shelf.save(passage, asked, windy(), now=NOW).provenance(NOW).endswith(", which is no forecast.")
    practice = replace(passage.forecast, source="Practice weather - generated, not a forecast", real=False)
    made_up = shelf.save(replace(passage, forecast=practice), asked, windy(), now=NOW).provenance(NOW)
    assert made_up.endswith("with Practice weather - generated, not a forecast.")


# ---------------------------------------------------------------------------------------- the list


def test_the_latest_comes_first_and_names_are_no_twins(shelf: SavedPassages, asked: Asked) -> None:
    names = [shelf.save(hand_made_passage(), asked, windy(), now=NOW).name for _ in range(3)]
    usual = "Gdynia – Sandhamn, 20 Nov 2016 06:00"
    assert names == [usual, f"{usual} (2)", f"{usual} (3)"]
    assert [entry.name for entry in shelf.listing().entries] == names[::-1]


def test_names_are_changed_and_cleaned(shelf: SavedPassages, asked: Asked, tmp_path: Path) -> None:
    first, second = (shelf.save(hand_made_passage(), asked, windy(), now=NOW).number for _ in range(2))
    assert shelf.rename(first, "  To the\nmidsummer 🌞 regatta ") == "To the midsummer 🌞 regatta"
    assert shelf.rename(second, "To the midsummer 🌞 regatta") == "To the midsummer 🌞 regatta (2)"
    assert shelf.rename(second, "To the midsummer 🌞 regatta (2)").endswith("regatta (2)")
    assert len(shelf.rename(second, "x" * 500)) == MOST_LETTERS
    with pytest.raises(InputError, match="needs a name"):
        shelf.rename(first, " \n ")
    again = SavedPassages(tmp_path / "seacruise.sqlite")
    assert again.open(first).entry.name == "To the midsummer 🌞 regatta"


def test_deleted_it_can_be_brought_back_for_a_day(shelf: SavedPassages, asked: Asked) -> None:
    number = shelf.save(hand_made_passage(), asked, windy(), now=NOW).number
    shelf.delete(number, now=NOW)
    assert shelf.listing().entries == ()
    assert shelf.restore(number)
    assert [entry.number for entry in shelf.listing().entries] == [number]
    shelf.delete(number, now=NOW)
    other = shelf.save(hand_made_passage(), asked, windy(), now=NOW + timedelta(seconds=UNDO_S + 1)).number
    assert not shelf.restore(number)
    with pytest.raises(InputError, match="no longer saved"):
        shelf.open(number)
    assert [entry.number for entry in shelf.listing().entries] == [other]


# ------------------------------------------------------------------------------------------ damage


def spoil(path: Path, statement: str, *values: Any) -> None:
    with closing(sqlite3.connect(path)) as db:
        db.execute(statement, values)
        db.commit()


@pytest.mark.parametrize(
    ("statement", "value"),
    [
        ("UPDATE passage_body SET body = ? WHERE id = 2", b"\x00\x01"),
        ("UPDATE passage_body SET json = ? WHERE id = 2", "{}"),
        ("UPDATE passage_body SET body = ? WHERE id = 2", 7),
        ("UPDATE passage SET departure = ? WHERE id = 2", "yesterday"),
        ("UPDATE passage SET duration_h = ? WHERE id = 2", b"\xff"),
        ("UPDATE passage SET computed = ? WHERE id = 2", 1e300),
        ("UPDATE passage SET yacht = ? WHERE id = 2", b"\xff"),
        ("DELETE FROM passage_body WHERE id = ?", 2),
    ],
)
def test_a_damaged_row_is_skipped_and_named(
    shelf: SavedPassages, asked: Asked, tmp_path: Path, statement: str, value: Any
) -> None:
    for name in "abc":
        shelf.save(hand_made_passage(), asked, windy(), name=name, now=NOW)
    spoil(tmp_path / "seacruise.sqlite", statement, value)
    found = shelf.listing()
    assert [entry.name for entry in found.entries] == ["c", "a"]
    assert found.damaged == ((2, "b"),)
    with pytest.raises(InputError, match=r"The saved passage .* is damaged; delete it"):
        shelf.open(2)
    assert shelf.open(1).entry.name == "a"
    shelf.delete(2, now=NOW)
    assert shelf.listing().damaged == ()


def test_a_record_of_a_later_version_is_named(shelf: SavedPassages, asked: Asked, tmp_path: Path) -> None:
    entry = shelf.save(hand_made_passage(), asked, windy(), name="b", now=NOW)
    body = pack({"passage": 1, "asked": {"wings": 2}, "wind": 3})
    import zlib

    text = shelf.open(entry.number).json
    spoil(
        tmp_path / "seacruise.sqlite", "UPDATE passage_body SET body = ?, checksum = ?",
        body, zlib.crc32(body, zlib.crc32(text.encode())),
    )  # fmt: skip
    with pytest.raises(InputError, match="The saved passage b is damaged"):
        shelf.open(entry.number)


def test_a_file_that_is_none_is_one_sentence(tmp_path: Path) -> None:
    path = tmp_path / "seacruise.sqlite"
    path.write_bytes(b"this is no database" * 500)
    with pytest.raises(StoreError, match="is damaged; move it away"):
        SavedPassages(path)


def test_a_file_of_a_newer_version_is_left_alone(tmp_path: Path) -> None:
    path = tmp_path / "seacruise.sqlite"
    SavedPassages(path)
    spoil(path, "UPDATE schema_version SET version = 99 WHERE room = ?", "passages")
    with pytest.raises(StoreError, match="newer SeaCruise"):
        SavedPassages(path)


def test_killed_while_saving_nothing_is_half_saved(
    shelf: SavedPassages, asked: Asked, tmp_path: Path
) -> None:
    shelf.save(hand_made_passage(), asked, windy(), name="before", now=NOW)
    path = tmp_path / "seacruise.sqlite"
    program = (
        "import os, sys\nfrom pathlib import Path\n"
        "from seacruise import passages\n"
        "shelf = passages.SavedPassages(Path(sys.argv[1]))\n"
        "opened = shelf.open(1)\n"
        # the line is in, its contents are not
        "passages._checksum = lambda *_: os.kill(os.getpid(), 9)\n"
        "shelf.save(opened.passage, opened.asked, opened.wind, name='half')\n"
    )
    if sys.platform == "win32":
        program = program.replace("os.kill(os.getpid(), 9)", "os._exit(9)")
    done = subprocess.run(
        [sys.executable, "-c", program, str(path)],
        check=False,
        capture_output=True,
        cwd=Path(__file__).resolve().parent.parent,
    )
    assert done.returncode in {-9, 9}, done.stderr.decode()
    assert [entry.name for entry in SavedPassages(path).listing().entries] == ["before"]
    with Store(path).reading() as db:
        assert db.execute("PRAGMA integrity_check").fetchone() == ("ok",)


# ----------------------------------------------------------------------------------------- records


plain = st.recursive(
    st.none() | st.booleans() | st.integers(-(2**62), 2**62) | st.floats(allow_nan=False) | st.text(),
    lambda inner: (
        st.lists(inner, max_size=4).map(tuple)
        | st.dictionaries(st.text().filter(lambda key: key != "~"), inner, max_size=4)
    ),
    max_leaves=12,
)


@given(plain)
def test_what_is_packed_is_unpacked(value: Any) -> None:
    assert unpack(pack(value)) == value


@given(st.binary(max_size=200))
def test_bytes_from_elsewhere_are_no_record(data: bytes) -> None:
    with pytest.raises(ValueError, match="not a record"):
        unpack(data)


def test_only_our_own_classes_are_made() -> None:
    import zlib

    import msgspec

    for record in ({"~": "Popen", "args": "ls"}, {"~": "Port", "wings": 2}, {"~": "array", "dtype": "|O8"}):
        with pytest.raises(ValueError, match="not a record"):
            unpack(zlib.compress(msgspec.msgpack.encode(record)))


def test_a_polar_sails_as_before(yacht: Polar) -> None:
    again = unpack(pack(yacht))
    assert isinstance(again, Polar)
    np.testing.assert_array_equal(
        again.speed(np.array([5.0, 8.0]), np.array([45.0, 110.0])),
        yacht.speed(np.array([5.0, 8.0]), np.array([45.0, 110.0])),
    )
