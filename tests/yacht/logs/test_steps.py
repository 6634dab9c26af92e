"""The steps between a log and its points: means, water, wind, what is steady."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.units import MS_PER_KNOT
from seacruise.yacht.logs import steady
from seacruise.yacht.logs.average import averaged
from seacruise.yacht.logs.log import Log, log_of, signed_angle, vector
from seacruise.yacht.logs.water import (
    calibrated,
    corrected,
    estimated_current,
    given_current,
    without_current,
)
from seacruise.yacht.logs.wind import vane_of, with_true_wind, with_vane_turned
from tests.yacht.logs.voyages import Faults, voyage
from tests.yacht.polars import small

KN = MS_PER_KNOT
angles = st.floats(-179.0, 180.0)
speeds = st.floats(0.5, 15.0)


# --- means ---------------------------------------------------------------------------------------------


def test_means_of_ten_seconds() -> None:
    log = log_of(np.arange(20.0), stw=np.arange(20.0), heading=np.full(20, 90.0))
    mean = averaged([log])
    assert mean.time.tolist() == [5.0, 15.0]
    assert mean.stw.tolist() == [4.5, 14.5]
    assert mean.heading == pytest.approx(90.0)
    assert np.isnan(mean.tws).all()


def test_directions_are_averaged_through_north() -> None:
    log = log_of(
        [0.0, 1.0],
        heading=[350.0, 20.0],
        sog=[5.0, 5.0],
        cog=[359.0, 1.0],
        awa=[-179.0, 179.0],
        aws=[4.0, 4.0],
    )
    mean = averaged([log])
    assert mean.heading == pytest.approx(5.0)
    assert min(mean.cog[0], 360.0 - mean.cog[0]) == pytest.approx(0.0, abs=1e-9)
    assert mean.awa == pytest.approx(180.0)


def test_missing_values_do_not_count() -> None:
    mean = averaged(
        [log_of([0.0, 1.0, 2.0], stw=[1.0, np.nan, 3.0], aws=[1.0, 2.0, 3.0], awa=[0.0, np.nan, 0.0])]
    )
    assert mean.stw.tolist() == [2.0]
    assert mean.aws.tolist() == [2.0]


@given(st.lists(st.integers(1, 99), max_size=8))
def test_blocks_do_not_change_the_means(cuts: list[int]) -> None:
    log = voyage(small(), hours=0.028)
    whole = averaged([log])
    ends = sorted({0, len(log), *cuts})
    parts = averaged(log.rows(slice(a, b)) for a, b in pairwise(ends))
    for name in ("time", "stw", "heading", "awa", "aws", "sog", "cog"):
        assert getattr(parts, name) == pytest.approx(getattr(whole, name)), name


def test_gaps_and_clocks_set_back() -> None:
    mean = averaged([log_of([100.0, 101.0, 5.0, 6.0, 205.0], stw=[1.0, 1.0, 2.0, 4.0, 5.0])])
    assert mean.time.tolist() == [5.0, 105.0, 205.0]
    assert mean.stw.tolist() == [3.0, 1.0, 5.0]
    assert len(averaged([])) == 0


# --- wind ----------------------------------------------------------------------------------------------


def test_true_wind_worked_by_hand() -> None:
    # 3-4-5: wind abeam at 4 and a boat at 3 make an apparent wind of 5.
    apparent = np.degrees(np.arctan2(4.0, 3.0))
    log = with_true_wind(log_of([0.0, 1.0], aws=[5.0, 5.0], awa=[apparent, -apparent], stw=[3.0, 3.0]))
    assert log.tws == pytest.approx(4.0)
    assert log.twa == pytest.approx([90.0, -90.0])


@given(angles, speeds, st.floats(0.0, 10.0))
def test_apparent_and_true_wind_are_inverse(twa: float, tws: float, stw: float) -> None:
    apparent = vector(tws, twa) + stw
    again = with_true_wind(
        log_of([0.0], awa=[np.degrees(np.angle(apparent))], aws=[abs(apparent)], stw=[stw])
    )
    assert abs(vector(again.tws, again.twa)[0] - vector(tws, twa)) < 1e-9


def test_the_logged_true_wind_stays_where_there_is_no_apparent() -> None:
    log = with_true_wind(
        log_of(
            [0.0, 1.0], twa=[50.0, 60.0], tws=[7.0, 8.0], aws=[5.0, np.nan], awa=[0.0, 0.0], stw=[1.0, 1.0]
        )
    )
    assert log.tws.tolist() == [4.0, 8.0]
    assert log.twa.tolist() == [0.0, 60.0]


@pytest.mark.parametrize("offset", [-6.0, 0.0, 4.0])
def test_a_turned_vane_is_found_from_the_beats(offset: float) -> None:
    log = averaged([voyage(small(), hours=6.0, faults=Faults(vane_deg=offset))])
    vane = vane_of(log, span_s=10.0)
    assert vane is not None
    assert vane.offset_deg == pytest.approx(offset, abs=0.75)
    turned = with_vane_turned(log, vane.offset_deg)
    assert vane_of(turned, span_s=10.0).offset_deg == pytest.approx(0.0, abs=0.3)  # type: ignore[union-attr]


def test_a_vane_is_not_judged_by_one_tack() -> None:
    log = averaged([voyage(small(), hours=3.0)])
    assert vane_of(log.rows(log.awa > 0.0), span_s=10.0) is None


@given(st.floats(-1e4, 1e4))
def test_signed_angles(angle: float) -> None:
    signed = float(signed_angle(angle))
    assert -180.0 < signed <= 180.0 or signed == pytest.approx(-180.0)
    assert np.exp(1j * np.radians(signed)) == pytest.approx(np.exp(1j * np.radians(angle)), abs=1e-9)


# --- water ---------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def faulty() -> Log:
    faults = Faults(log_factor=0.93, compass_deg=5.0, current_set=70.0, current_drift=0.4)
    return averaged([voyage(small(), hours=4.0, faults=faults)])


def test_log_and_compass_are_calibrated_by_the_ground(faulty: Log) -> None:
    found = calibrated(faulty)
    assert found is not None
    assert found.trusted
    assert found.log_factor == pytest.approx(0.93, abs=0.01)
    assert found.compass_offset_deg == pytest.approx(5.0, abs=0.6)
    assert abs(found.log_factor - 0.93) < 4.0 * found.error


def test_the_current_remains(faulty: Log) -> None:
    found = calibrated(faulty)
    assert found is not None
    current = estimated_current(corrected(faulty, found))
    assert np.median(np.abs(current - vector(0.4, 70.0))) < 0.08


def test_one_course_tells_nothing_of_the_log() -> None:
    time = np.arange(0.0, 3600.0, 10.0)
    noise = np.random.default_rng(3).normal(0.0, 0.05, time.size)
    found = calibrated(
        log_of(time, sog=3.0 + noise, cog=90.0 + noise, stw=3.3 + noise[::-1], heading=88.0 + 0 * time)
    )
    assert found is not None
    assert not found.trusted
    assert calibrated(log_of(time, sog=3.0 + noise, cog=90.0 + noise)) is None


@given(angles, st.floats(0.0, 2.0), angles, speeds)
def test_a_known_current_is_taken_out(drift_to: float, drift: float, heading: float, stw: float) -> None:
    ground = vector(stw, heading) + vector(drift, drift_to)
    log = log_of([0.0], sog=[abs(ground)], cog=[np.degrees(np.angle(ground)) % 360])
    through, filled = without_current(log, given_current(log, drift_to, drift))
    assert filled.all()
    assert abs(vector(through.stw, through.heading)[0] - vector(stw, heading)) < 1e-9


def test_what_was_logged_is_not_filled_in() -> None:
    log = log_of([0.0], sog=[3.0], cog=[0.0], stw=[2.5], heading=[10.0])
    through, filled = without_current(log, given_current(log, 0.0, 1.0))
    assert (float(through.stw[0]), float(through.heading[0])) == (2.5, 10.0)
    assert not filled.any()


# --- steady --------------------------------------------------------------------------------------------


def calm_sailing(n: int = 60) -> dict[str, np.typing.NDArray[np.float64]]:
    """Ten minutes on one course, in means of ten seconds."""
    ones = np.ones(n)
    return {
        "time": np.linspace(5.0, 10.0 * n - 5.0, n),
        "sog": 3.0 * ones,
        "cog": 10.0 * ones,
        "stw": 3.0 * ones,
        "heading": 10.0 * ones,
        "twa": 60.0 * ones,
        "tws": 6.0 * ones,
    }


def judged(columns: dict[str, np.typing.NDArray[np.float64]]) -> list[str]:
    log = log_of(**columns)
    reason = steady.judged(log, np.zeros(len(log), dtype=complex), span_s=10.0)
    return ["steady" if k == steady.STEADY else steady.REASONS[k] for k in reason]


def test_ten_calm_minutes_are_steady_but_for_their_ends() -> None:
    said = judged(calm_sailing())
    assert set(said) == {"steady"}


@pytest.mark.parametrize(
    ("column", "value", "reason"),
    [
        ("tws", np.nan, "missing wind or speed"),
        ("stw", np.nan, "missing wind or speed"),
        ("stw", 0.3, "stopped"),
        ("tws", 1.0, "calm"),
        ("twa", 10.0, "under engine"),
        ("twa", -60.0, "after a tack or gybe"),
        ("heading", 60.0, "turning"),
        ("twa", 100.0, "wind shifting"),
        ("stw", 4.2, "accelerating"),
        ("sog", 4.2, "log against receiver"),
    ],
)
def test_each_reason(column: str, value: float, reason: str) -> None:
    columns = calm_sailing()
    columns[column][30:34] = value
    said = judged(columns)
    assert said[31] == reason
    assert said[20] == said[50] == "steady"


def test_the_engine_is_known_by_its_revolutions_or_by_what_no_sail_can_do() -> None:
    columns = calm_sailing()
    columns["rpm"] = np.where(np.arange(60) == 30, 1800.0, 0.0)
    assert [k for k, said in enumerate(judged(columns)) if said == "under engine"] == [30]
    columns = calm_sailing()
    columns["tws"][:] = 1.7
    assert set(judged(columns)) == {"under engine"}


def test_she_needs_a_minute_after_a_tack() -> None:
    columns = calm_sailing()
    columns["twa"][30:] = -60.0
    columns["heading"][30:] = 130.0
    said = judged(columns)
    assert said[30:36] == ["after a tack or gybe"] * 6
    assert said[36] == "steady"
    assert said[27:30] == ["turning"] * 3


def test_dead_before_the_wind_a_side_is_no_gybe() -> None:
    columns = calm_sailing()
    columns["twa"][:] = np.where(np.arange(60) % 2 == 0, 178.0, -178.0)
    assert set(judged(columns)) == {"steady"}


def test_beside_a_gap_nobody_knows() -> None:
    columns = {
        name: values[[*range(10), *range(11, 12), *range(40, 60)]] for name, values in calm_sailing().items()
    }
    said = judged(columns)
    assert said[10] == "beside a gap"
    assert said[5] == said[20] == "steady"
