"""Signal K deltas, tables, arrays: the same voyage by any road."""

from __future__ import annotations

import json
from datetime import UTC, datetime
from math import radians
from pathlib import Path

import numpy as np
import pytest

from seacruise.errors import InputError
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.logs.log import COLUMNS, Log, Tally, joined, log_of
from seacruise.yacht.logs.sheet import read_sheet
from seacruise.yacht.logs.signalk import read_signalk
from seacruise.yacht.logs.source import read_log
from tests.yacht.logs.voyages import BEGIN, nmea, voyage
from tests.yacht.polars import small

KN = MS_PER_KNOT


def iso(time: float) -> str:
    return datetime.fromtimestamp(time, UTC).isoformat().replace("+00:00", "Z")


def delta(time: str | None, context: str | None = "vessels.self", **paths: object) -> bytes:
    values = [{"path": path.replace("_", "."), "value": value} for path, value in paths.items()]
    message: dict[str, object] = {"updates": [{"timestamp": time, "values": values}]}
    if context is not None:
        message["context"] = context
    return json.dumps(message).encode()


def signalk(*lines: bytes, variation: float = np.nan) -> tuple[Log, Tally]:
    tally = Tally()
    return joined(read_signalk(lines, tally, variation_deg=variation)), tally


def sheet(text: str, variation: float = np.nan) -> tuple[Log, Tally]:
    tally = Tally()
    lines = [f"{line}\r\n".encode() for line in text.splitlines()]
    return joined(read_sheet(lines, tally, variation_deg=variation)), tally


def as_signalk(log: Log) -> list[bytes]:
    lines = []
    for k in range(len(log)):
        angles = {"navigation_headingTrue": log.heading, "navigation_courseOverGroundTrue": log.cog}
        angles["environment_wind_angleApparent"] = log.awa
        speeds = {"navigation_speedThroughWater": log.stw, "navigation_speedOverGround": log.sog}
        speeds["environment_wind_speedApparent"] = log.aws
        when = iso(log.time[k])
        place = {"latitude": log.lat[k], "longitude": log.lon[k]}
        lines.append(delta(when, navigation_position=place))
        lines.append(delta(when, "vessels.self", **{p: radians(v[k]) for p, v in angles.items()}))
        lines.append(delta(when, "vessels.self", **{p: float(v[k]) for p, v in speeds.items()}))
    return lines


def as_sheet(log: Log) -> str:
    rows = ["time;lat;lon;sog_kn;cog;bsp [kn];Heading;AWA;aws (m/s)"]
    for k in range(len(log)):
        cells = [log.lat[k], log.lon[k], log.sog[k] / KN, log.cog[k], log.stw[k] / KN, log.heading[k]]
        rows.append(";".join([iso(log.time[k]), *(f"{v:.8f}" for v in (*cells, log.awa[k], log.aws[k]))]))
    return "\n".join(rows)


def test_every_road_leads_to_the_same_log(tmp_path: Path) -> None:
    sailed = voyage(small(), hours=0.05)
    for name, content in (
        ("a.nmea", "\n".join(nmea(sailed, variation="0.0,E"))),
        ("b.jsonl", b"\n".join(as_signalk(sailed)).decode()),
        ("c.csv", as_sheet(sailed)),
    ):
        path = tmp_path / name
        path.write_text(content, encoding="utf-8")
        tally = Tally()
        log = joined(read_log(path, tally))
        assert tally.used > 0
        assert not tally.skipped
        for column in ("time", "lat", "lon", "sog", "cog", "stw", "heading", "awa", "aws"):
            assert getattr(log, column) == pytest.approx(getattr(sailed, column), abs=0.006), (name, column)


# --- Signal K ------------------------------------------------------------------------------------------


def test_other_vessels_are_left_out() -> None:
    speed = {"navigation_speedThroughWater": 3.0}
    lines = [
        b'{"self":"vessels.urn:mrn:imo:mmsi:1","version":"2.0"}',
        delta("2026-07-01T08:00:00.250Z", "vessels.urn:mrn:imo:mmsi:1", **speed),
        delta("2026-07-01T08:00:00Z", "vessels.urn:mrn:imo:mmsi:2", navigation_speedThroughWater=9.0),
    ]
    log, tally = signalk(*lines)
    assert log.time.tolist() == [BEGIN]
    assert log.stw.tolist() == [3.0]
    assert tally.skipped == {"of other vessels": 1}
    _, tally = signalk(lines[2])
    assert "own one" in tally.notes[0]


def test_angles_and_units_of_signal_k() -> None:
    log, _ = signalk(
        delta(
            "2026-07-01T08:00:00Z",
            None,
            environment_wind_angleTrueWater=radians(270.0),
            environment_wind_speedTrue=5.0,
            propulsion_port_revolutions=25.0,
            navigation_magneticVariation=radians(4.0),
            navigation_headingMagnetic=radians(358.0),
        )
    )
    assert log.twa[0] == pytest.approx(-90.0)
    assert (log.tws[0], log.rpm[0]) == (5.0, 1500.0)
    assert log.heading[0] == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        (b'{"updates": 3}', "garbled"),
        (b'{"updates": [{"values": [', "garbled"),
        (b"no braces", "garbled"),
        (b'{"context": "vessels.self", "updates": [{"timestamp": "x", "values": []}]}', "without a time"),
        (delta("2026-07-01T08:00:00Z", navigation_speedThroughWater="fast"), "of other kinds"),
        (delta("2026-07-01T08:00:00Z", navigation_speedThroughWater=True), "of other kinds"),
        (delta("2026-07-01T08:00:00Z", navigation_speedThroughWater=-1.0), "of other kinds"),
        (
            delta("2026-07-01T08:00:00Z", navigation_position={"latitude": 99, "longitude": 0}),
            "of other kinds",
        ),
    ],
)
def test_bad_messages_are_counted(line: bytes, reason: str) -> None:
    log, tally = signalk(line)
    assert len(log) == 0
    assert tally.skipped == {reason: 1}


# --- tables --------------------------------------------------------------------------------------------


def test_units_names_and_separators() -> None:
    log, tally = sheet(
        "Date,Time,Boat Speed,TWS [km/h],TWA,hdm,Variation,junk\n"
        "2026-07-01,08:00:00,5.0,36,350,1,-3,x\n"
        "2026-07-01,08:00:01,6.0,36,10,1,-3,x\n"
        "not a row\n"
    )
    assert log.time.tolist() == [BEGIN, BEGIN + 1]
    assert log.stw == pytest.approx(np.array((5.0, 6.0)) * KN)
    assert log.tws == pytest.approx(10.0)
    assert log.twa.tolist() == [-10.0, 10.0]
    assert log.heading.tolist() == [358.0, 358.0]
    assert tally.skipped == {"garbled": 1}


@pytest.mark.parametrize(
    ("time", "seconds"),
    [("1782892800", 0), ("1782892800500", 0.5), ("2026-07-01T10:00:02+02:00", 2), ("2026-07-01 08:00:03", 3)],
)
def test_times(time: str, seconds: float) -> None:
    log, _ = sheet(f"# a comment\ntime\tstw_ms\n{time}\t2,5\n")
    assert log.time.tolist() == [BEGIN + seconds]
    assert log.stw.tolist() == [2.5]


def test_figures_out_of_bounds_are_none() -> None:
    log, tally = sheet("time;stw;awa\n2026-07-01T08:00Z;-3;1000\n2026-07-01T08:01Z;3;\n")
    assert np.isnan(log.awa).all()
    assert log.stw.tolist() == [3 * KN]
    assert (tally.used, sum(tally.skipped.values())) == (1, 1)


def test_a_table_without_times_is_refused() -> None:
    with pytest.raises(InputError, match="column of times"):
        sheet("stw;awa\n3;4\n")


# --- arrays --------------------------------------------------------------------------------------------


def test_arrays() -> None:
    log = log_of([1.0, 2.0], stw=[3.0, np.nan])
    assert log.stw[0] == 3.0
    assert np.isnan(log.tws).all()
    assert len(log.rows(log.time > 1.5)) == 1
    assert all(getattr(joined([log, log]), name).size == 4 for name in COLUMNS)
    assert len(joined([])) == 0


def test_arrays_that_are_no_log() -> None:
    with pytest.raises(InputError, match="no column 'speed'"):
        log_of([1.0], speed=[3.0])
    with pytest.raises(InputError, match="column stw has the shape"):
        log_of([1.0, 2.0], stw=[3.0])
