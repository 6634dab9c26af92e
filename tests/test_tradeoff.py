"""Time against changes of course: a front of choices, each of them sailed."""

from __future__ import annotations

import json
from dataclasses import replace
from datetime import timedelta
from functools import cache
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise import cli
from seacruise.errors import CancelledError, NoPassageError
from seacruise.export.jsonform import trade_off_to_json
from seacruise.export.textform import trade_off_to_text
from seacruise.passage import Options, Passage, PassageRequest, plan
from seacruise.ports import Port
from seacruise.progress import Job
from seacruise.resources import resource_path
from seacruise.settings import Settings
from seacruise.tradeoff import MOST_CHANGES, Choice, fewer_turns, trade_off
from seacruise.weather.sample import sample_wind
from seacruise.weather.wind import Wind
from seacruise.yacht.fleet import find_yacht, load_fleet
from tests.passages import hand_made_passage
from tests.routing.worlds import DEPARTURE, cache_dir_of, steady_wind

SOUTH, NORTH = Port("South", "", 55.9, 19.3), Port("North", "", 56.9, 19.3)
Found = tuple[PassageRequest, Passage, tuple[Choice, ...]]

WINDS = {
    "beat": lambda: steady_wind(14.0, 0.0),
    "reach": lambda: steady_wind(14.0, 100.0),
    "sample": sample_wind,
}


@pytest.fixture(scope="module")
def folders(tmp_path_factory: pytest.TempPathFactory) -> Settings:
    base = tmp_path_factory.getbasetemp()
    return Settings(cache_dir=cache_dir_of(base), data_dir=base / "data")


@pytest.fixture(scope="module", params=WINDS)
def found(request: pytest.FixtureRequest, folders: Settings) -> Found:
    """Plan, and weigh, each wind once."""
    return weighed(WINDS[request.param](), folders)


def weighed(wind: Wind, folders: Settings) -> Found:
    asked = request_in(wind)
    passage = plan(asked, settings=folders)
    return asked, passage, trade_off(asked, passage, settings=folders)


@cache
def request_in(wind: Wind) -> PassageRequest:
    yacht = find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")]))
    return PassageRequest(SOUTH, NORTH, yacht, wind, DEPARTURE, Options(spacing_nm=3.0))


def test_more_changes_of_course_save_time_or_are_not_told(found: Found) -> None:
    _, _, choices = found
    assert choices
    for few, many in pairwise(choices):
        assert few.course_changes < many.course_changes
        assert few.duration_h > many.duration_h


def test_none_is_faster_than_the_passage_itself_and_none_has_more_changes(found: Found) -> None:
    _, passage, choices = found
    for choice in choices:
        assert choice.duration_h >= passage.duration_h * (1 - 1e-3)
        assert choice.course_changes <= max(passage.course_changes, MOST_CHANGES)
    fastest = min(choice.duration_h for choice in choices)
    assert fastest <= passage.duration_h + 120.0 / 3600.0


def test_every_choice_could_be_a_passage(found: Found) -> None:
    """Turns are changes of course; the way is not shorter than the direct one, nor faster than the bound."""
    _, passage, choices = found
    for choice in choices:
        assert 0 <= choice.tacks + choice.gybes <= choice.course_changes
        assert choice.distance_nm >= passage.direct_distance_nm * 0.9999
        assert choice.duration_h >= passage.lower_bound_h
        assert choice.duration_h <= passage.duration_h * 1.15


def test_dead_to_windward_one_tack_is_the_least(folders: Settings) -> None:
    _, _, choices = weighed(WINDS["beat"](), folders)
    assert choices[0].course_changes == choices[0].tacks == 1


def test_on_a_reach_there_is_nothing_to_weigh(folders: Settings) -> None:
    _, passage, choices = weighed(WINDS["reach"](), folders)
    assert choices[0].course_changes == 0
    assert len(choices) == 1
    assert choices[0].duration_h == pytest.approx(passage.duration_h, rel=1e-3)


def test_told_in_json_and_in_words(found: Found) -> None:
    _, _, choices = found
    rows = trade_off_to_json(choices)
    assert [row["course_changes"] for row in rows] == [choice.course_changes for choice in choices]
    assert all(set(row) == {"course_changes", "duration_h", "distance_nm", "tacks", "gybes"} for row in rows)
    assert len(trade_off_to_text(choices).splitlines()) == len(choices) + 2


def test_cancelled_it_goes_no_further(folders: Settings) -> None:
    asked, passage, _ = weighed(WINDS["beat"](), folders)
    job = Job()
    job.cancel.set()
    with pytest.raises(CancelledError):
        trade_off(asked, passage, settings=folders, job=job)


def test_the_command_line_adds_one_key(capsys: pytest.CaptureFixture[str]) -> None:
    words = ["plan", "--from", "55.9,19.3", "--to", "56.9,19.3", "--yacht", "Bavaria 46 Cruiser"]
    words += ["--depart", "2016-11-20T06:00Z", "--forecast", "sample", "--spacing", "4", "--format", "json"]
    assert cli.main(words) == 0
    without = json.loads(capsys.readouterr().out)
    assert cli.main([*words, "--trade-off"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert set(told) - set(without) == {"trade_off"}
    assert told["duration_h"] == without["duration_h"]
    assert told["trade_off"]


# --- fewer tacks and gybes -----------------------------------------------------------------------------


def turning(turns: int, hours: float) -> Passage:
    """Make a passage with so many tacks."""
    passage = hand_made_passage()
    arrival = passage.departure + timedelta(hours=hours)
    return replace(passage, tacks=turns, gybes=0, arrival=arrival)


@given(st.lists(st.integers(0, 40), min_size=3, max_size=3), st.integers(1, 40))
def test_turns_fall_with_each_one_and_never_rise(offered: list[int], had: int) -> None:
    """Whatever a planner comes up with: asked for at most so many, it may find more or fewer."""
    answers = iter(offered)
    asked: list[int] = []

    def sail(most: int) -> Passage:
        asked.append(most)
        return turning(next(answers), 41.0)

    found = list(fewer_turns(turning(had, 40.0), sail))
    turns = [had, *(one.passage.tacks for one in found)]
    assert all(few < many for many, few in pairwise(turns))
    assert asked[0] == had // 2
    assert all(few <= many // 2 for many, few in pairwise(asked))
    assert [one.most_turns for one in found] == asked[: len(found)]


def test_what_takes_too_long_is_nobodys_choice_but_the_next_one_is_looked_at() -> None:
    offered = {4: turning(4, 60.0), 2: turning(2, 44.0), 1: turning(2, 44.0)}
    found = list(fewer_turns(turning(9, 40.0), offered.__getitem__))
    assert [(one.passage.tacks, one.most_turns) for one in found] == [(2, 2)]


def never(most: int) -> Passage:
    raise AssertionError(f"asked for {most} turns")


def test_without_turns_nothing_is_asked() -> None:
    assert not list(fewer_turns(turning(0, 40.0), never))


def test_where_there_is_no_way_it_ends() -> None:
    def sail(most: int) -> Passage:
        raise NoPassageError(f"No way with {most}.", reason="wind-limit")

    assert not list(fewer_turns(turning(3, 40.0), sail))


def test_each_is_what_is_planned_with_its_number_of_turns(folders: Settings) -> None:
    """So adopting one, which allows so many turns, gives the very passage that was shown."""
    request, passage, _ = weighed(WINDS["beat"](), folders)

    def sail(most: int) -> Passage:
        asked = replace(request, options=replace(request.options, most_turns=most))
        return plan(asked, settings=folders)

    found = list(fewer_turns(passage, sail))
    assert found
    for one in found:
        turns = one.passage.tacks + one.passage.gybes
        assert sail(turns).duration_h == pytest.approx(one.passage.duration_h, rel=1e-9)
        assert turns < passage.tacks + passage.gybes
        assert one.passage.checks.land_free


def test_cancelled_no_more_turns_are_asked() -> None:
    job = Job()
    job.cancel.set()
    with pytest.raises(CancelledError):
        list(fewer_turns(turning(3, 40.0), never, job=job))
