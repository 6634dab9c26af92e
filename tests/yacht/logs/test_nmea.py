"""NMEA 0183: every sentence we read, and the garbage between them."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.errors import InputError
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.logs.gather import BLOCK
from seacruise.yacht.logs.log import COLUMNS, Log, Tally, joined
from seacruise.yacht.logs.nmea import CHECKSUMS, Checksum, judged_checksum, read_nmea
from seacruise.yacht.logs.source import read_log
from tests.yacht.logs.voyages import nmea, sentence, voyage
from tests.yacht.polars import small

KN = MS_PER_KNOT
RMC = "GPRMC,100000,A,5430.000,N,01030.000,E,05.0,090.0,010726,,,A"
T0 = datetime(2026, 7, 1, 10, tzinfo=UTC).timestamp()


def read(*bodies: str, checksum: Checksum = "auto", variation: float = np.nan) -> tuple[Log, Tally]:
    """Read sentences given without their checksums."""
    return read_lines([sentence(body) for body in bodies], checksum=checksum, variation=variation)


def read_lines(
    lines: list[str], *, checksum: Checksum = "auto", variation: float = np.nan
) -> tuple[Log, Tally]:
    tally = Tally()
    source = [f"{line}\r\n".encode("latin-1") for line in lines]
    return joined(read_nmea(source, tally, checksum=checksum, variation_deg=variation)), tally


def test_time_position_and_motion_over_ground() -> None:
    log, tally = read(RMC)
    assert (len(log), tally.used) == (1, 1)
    assert log.time[0] == T0
    assert (log.lat[0], log.lon[0]) == (54.5, 10.5)
    assert log.sog[0] == pytest.approx(5 * KN)
    assert log.cog[0] == 90.0
    assert np.isnan(log.stw[0])


@pytest.mark.parametrize(
    ("body", "column", "value"),
    [
        ("IIVHW,,,063,M,05.5,N,,", "stw", 5.5 * KN),
        ("IIVHW,,,063,M,,,10.0,K", "stw", 10 / 3.6),
        ("IIVHW,070,T,063,M,05.5,N,,", "heading", 70.0),
        ("IIHDT,123.4,T", "heading", 123.4),
        ("IIHDM,123.4,M", "heading", 123.4),
        ("IIHDG,010.0,2.0,W,3.0,E", "heading", 11.0),
        ("IIMWV,330,R,10.0,N,A", "awa", -30.0),
        ("IIMWV,330,R,10.0,M,A", "aws", 10.0),
        ("IIMWV,180,T,36.0,K,A", "tws", 10.0),
        ("IIMWV,180,T,36.0,K,A", "twa", 180.0),
        ("IIVWR,045,L,12.0,N,,,,", "awa", -45.0),
        ("IIVWR,045,R,12.0,N,,,,", "aws", 12 * KN),
        ("IIVWR,045,R,,,7.5,M,,", "aws", 7.5),
        ("IIVTG,200,T,197,M,06.0,N,11.1,K", "cog", 200.0),
        ("IIVTG,200,T,197,M,06.0,N,11.1,K", "sog", 6 * KN),
        ("IIRPM,E,1,2400,10.5,A", "rpm", 2400.0),
    ],
)
def test_each_sentence(body: str, column: str, value: float) -> None:
    log, tally = read(RMC, body)
    assert tally.used == 2
    assert not tally.skipped
    assert getattr(log, column)[0] == pytest.approx(value)


@pytest.mark.parametrize(
    "body",
    [
        "GPRMC,100001,V,5430.000,N,01030.000,E,05.0,090.0,010726,,,A",
        "IIMWV,330,R,10.0,N,V",
        "IIMWV,,R,,N,A",
        "IIVHW,,,,,,,,",
        "GPGLL,5430.0,N,01030.0,E,100001,V,N",
        "GPGGA,100001,5430.0,N,01030.0,E,0,00,,,M,,M,,",
        "IIRPM,E,1,2400,10.5,V",
    ],
)
def test_sentences_that_say_nothing(body: str) -> None:
    log, tally = read(RMC, body)
    assert (len(log), tally.used) == (1, 1)
    assert tally.skipped == {"without a valid figure": 1}


@pytest.mark.parametrize(
    "body",
    [
        "IIMWV,400,R,10.0,N,A",
        "IIMWV,030,R,9999,N,A",
        "IIMWV,030,X,10.0,N,A",
        "IIMWV,030,R",
        "IIMWV,0-3,R,10.0,N,A",
        "IIVWR,045,Q,12.0,N,,,,",
        "IIVHW,,,063",
        "GPRMC,100001,A,9930.000,N,01030.000,E,05.0,090.0,010726,,,A",
        "GPRMC,100001,A,5430.000,N,01030.000,E,05.0,090.0,993926,,,A",
        "GPZDA,100001,31,02,2026,00,00",
    ],
)
def test_garbled_sentences_are_counted_and_change_nothing(body: str) -> None:
    log, tally = read(RMC, body)
    assert (len(log), tally.used) == (1, 1)
    assert tally.skipped == {"garbled": 1}
    assert all(np.isnan(getattr(log, name)[0]) for name in ("stw", "awa", "aws", "twa", "tws"))


def test_other_kinds_are_counted() -> None:
    _, tally = read(RMC, "IIMTW,+20.5,C", "GPRMW,1,2")
    assert tally.skipped == {"of other kinds": 2}


def test_merged_lines_are_taken_apart() -> None:
    merged = sentence(RMC) + sentence("IIVHW,,,063,M,05.5,N,,")
    log, tally = read_lines([merged, "$IIMWV,03" + sentence("IIHDT,100,T")])
    assert tally.used == 3
    assert log.stw[0] == pytest.approx(5.5 * KN)
    assert log.heading[0] == 100.0


def test_text_before_a_sentence_is_passed_over() -> None:
    log, _ = read_lines(
        ["2026-07-01T10:00:00 > " + sentence(RMC), r"\s:x,c:1*00\ " + sentence("IIHDT,100,T")]
    )
    assert log.heading[0] == 100.0


@pytest.mark.parametrize(
    ("checksum", "used", "reason"),
    [
        ("strict", 1, {"with a wrong checksum": 1, "without a checksum": 1}),
        ("accept", 2, {"with a wrong checksum": 1}),
        ("ignore", 3, {}),
        ("auto", 2, {"with a wrong checksum": 1}),
    ],
)
def test_checksum_policies(checksum: Checksum, used: int, reason: dict[str, int]) -> None:
    lines = [sentence(RMC), "$IIHDT,100,T", sentence("IIVHW,,,063,M,05.5,N,,")[:-2] + "00"]
    _, tally = read_lines(lines, checksum=checksum)
    assert tally.used == used
    assert tally.skipped == reason


def test_a_log_whose_checksums_mean_nothing_is_read_all_the_same() -> None:
    wrong = [f"${body}*00" for body in (RMC, "IIHDT,100,T", "IIVHW,,,063,M,05.5,N,,")]
    log, tally = read_lines([*wrong, sentence("IIMWV,330,R,10.0,N,A")])
    assert tally.used == 4
    assert log.stw[0] == pytest.approx(5.5 * KN)
    assert "wrong checksum" in tally.notes[0]
    assert judged_checksum([line.encode() for line in wrong]) == "ignore"
    assert judged_checksum([]) == "accept"


def test_the_fix_gives_the_time_and_a_late_one_does_not_turn_it_back() -> None:
    log, _ = read(
        RMC,
        "GPGLL,5430.1,N,01030.0,E,100002,A,A",
        "IIHDT,100,T",
        RMC.replace("100000", "100001"),
        "IIHDT,110,T",
    )
    assert log.time.tolist() == [T0, T0 + 2]
    assert log.heading[1] == 110.0


def test_a_repeated_fix_is_one_row() -> None:
    log, _ = read(RMC, "IIHDT,100,T", RMC, "IIHDT,101,T", RMC.replace("100000", "100005"), "IIHDT,102,T")
    assert log.time.tolist() == [T0, T0 + 5]
    assert log.heading.tolist() == [101.0, 102.0]


def test_midnight_passes_without_a_date() -> None:
    late = RMC.replace("100000", "235959")
    log, _ = read(late, "IIHDT,100,T", "GPGLL,5430.1,N,01030.0,E,000001,A,A", "IIHDT,101,T")
    assert np.diff(log.time).tolist() == [2.0]


def test_a_clock_set_back_begins_anew() -> None:
    log, _ = read(RMC, "IIHDT,100,T", RMC.replace("100000", "080000"), "IIHDT,101,T")
    assert np.diff(log.time).tolist() == [-7200.0]


def test_values_before_the_first_fix_have_no_row() -> None:
    log, _ = read("IIHDT,100,T", "GPGLL,5430.1,N,01030.0,E,095959,A,A", RMC)
    assert log.time.tolist() == [T0]
    assert np.isnan(log.heading[0])


def test_time_and_date_alone_will_do() -> None:
    log, _ = read("GPZDA,100000,01,07,2026,00,00", "IIHDT,100,T")
    assert log.time.tolist() == [T0]


@pytest.mark.parametrize(("told", "sign"), [("3.0,E", 1.0), ("3.0,W", -1.0)])
def test_magnetic_headings_become_true_by_the_variation(told: str, sign: float) -> None:
    log, tally = read(RMC.replace(",,,A", f",{told},A"), "IIHDM,001,M")
    assert log.heading[0] == pytest.approx((1.0 + sign * 3.0) % 360.0)
    assert not tally.notes
    log, tally = read(RMC, "IIHDM,359,M", variation=4.0)
    assert log.heading[0] == pytest.approx(3.0)
    log, tally = read(RMC, "IIHDM,359,M")
    assert log.heading[0] == 359.0
    assert "variation" in tally.notes[0]


def test_what_was_sent_is_read() -> None:
    sailed = voyage(small(), hours=0.1)
    log, tally = read_lines(list(nmea(sailed, variation="0.0,E")))
    assert tally.used == 3 * len(sailed)
    assert not tally.skipped
    for name in ("time", "lat", "lon", "sog", "cog", "stw", "heading", "awa", "aws"):
        assert getattr(log, name) == pytest.approx(getattr(sailed, name), abs=0.006), name


def test_it_comes_in_blocks_that_do_not_grow() -> None:
    lines = [sentence(RMC.replace("100000", f"{10 + k // 3600:02d}{k // 60 % 60:02d}{k % 60:02d}"))
             for k in range(3 * BLOCK + 10)]  # fmt: skip
    sizes = [len(block) for block in read_nmea((f"{line}\n".encode() for line in lines), Tally())]
    assert len(sizes) == 4
    assert max(sizes) == BLOCK
    assert sum(sizes) == len(lines)


@given(st.lists(st.binary(max_size=60), max_size=12), st.sampled_from(CHECKSUMS))
def test_nothing_that_a_wire_can_carry_breaks_it(noise: list[bytes], checksum: Checksum) -> None:
    lines = [b"$II" + line for line in noise] + [b"$IIMWV," + line for line in noise]
    lines += [b"$GPRMC," + line for line in noise] + [sentence(RMC).encode()]
    tally = Tally()
    log = joined(read_nmea(lines, tally, checksum=checksum))
    assert len(log) >= (checksum != "ignore")
    for name in COLUMNS:
        values = getattr(log, name)
        assert np.isfinite(values[~np.isnan(values)]).all()


def test_files_that_are_no_logs_say_so(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"There is no log .*none\.txt"):
        list(read_log(tmp_path / "none.txt", Tally()))
    with pytest.raises(InputError, match="cannot be read"):
        list(read_log(tmp_path, Tally()))
    other = tmp_path / "notes.txt"
    other.write_text("Dear diary\nToday we sailed.\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"notes\.txt cannot be used.*column of times"):
        list(read_log(other, Tally()))
    other.write_bytes(bytes(range(256)) * 4000)
    with pytest.raises(InputError, match=r"notes\.txt"):
        list(read_log(other, Tally()))
