from __future__ import annotations

from datetime import UTC, datetime, timedelta
from typing import cast

import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.desktop.compute import Answer
from seacruise.desktop.state import STAGES, Horizon, Phase, Progress, WindowState
from seacruise.errors import WeatherError

ANSWER = cast("Answer", object())
ERROR = WeatherError("No network.", reason="no-network")


def test_an_answer_arrives() -> None:
    state = WindowState().started(1).progressed(1, "sea", None, "").finished(1, ANSWER)
    assert state.phase is Phase.ROUTE
    assert state.answer is ANSWER
    assert not state.answer_is_earlier


def test_an_earlier_answer_survives_a_failure() -> None:
    state = WindowState().started(1).finished(1, ANSWER).started(2).failed(2, ERROR)
    assert state.phase is Phase.FAILED
    assert state.answer is ANSWER
    assert state.answer_is_earlier


@pytest.mark.parametrize("late", [1, 3, 99])
def test_what_arrives_late_changes_nothing(late: int) -> None:
    state = WindowState().started(2)
    assert state.finished(late, ANSWER) is state
    assert state.failed(late, ERROR) is state
    assert state.progressed(late, "sea", 0.1, "") is state


def test_after_cancel_nothing_of_the_job_counts() -> None:
    state = WindowState().started(1).cancelled()
    assert state.phase is Phase.CANCELLED
    assert state.finished(1, ANSWER) is state
    assert state.cancelled() is state


@given(st.lists(st.sampled_from(STAGES), min_size=1))
def test_the_running_stage_is_never_among_those_behind(stages: list[str]) -> None:
    progress = Progress()
    for stage in stages:
        progress = progress.advanced(stage, None, "")
    assert progress.stage == stages[-1]
    assert progress.done == set(stages) - {stages[-1]}


BEGIN = datetime(2016, 11, 20, tzinfo=UTC)
HORIZON = Horizon(BEGIN, BEGIN + timedelta(hours=48))


@given(st.integers(-50 * 3600, 100 * 3600))
def test_the_default_departure_is_a_covered_full_hour(seconds: int) -> None:
    now = BEGIN + timedelta(seconds=seconds)
    departure = HORIZON.default_departure(now)
    assert HORIZON.covers(departure)
    assert (departure.minute, departure.second, departure.microsecond) == (0, 0, 0)
    if HORIZON.first <= now <= HORIZON.last - timedelta(hours=1):
        assert timedelta(0) <= departure - now < timedelta(hours=1)
    else:
        assert departure in {HORIZON.first, HORIZON.last}
