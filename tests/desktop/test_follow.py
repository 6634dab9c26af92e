"""The newest wish wins, and the chart still follows: decisions of `follow`, without threads."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.desktop.follow import QUICK_S, Follow, Turn


def slow() -> Follow[int]:
    follow: Follow[int] = Follow()
    follow.took(4 * QUICK_S)
    return follow


def test_a_slow_one_is_coarse_first_and_precise_at_rest() -> None:
    follow = slow()
    assert follow.ask(1) == Turn(1, rough=True, follows=True)
    assert follow.ended(0.02) is None
    assert follow.is_busy, "the precise one is owed"
    assert follow.rest() == Turn(1, rough=False, follows=False)
    assert follow.ended(0.2) is None
    assert not follow.is_busy


def test_a_quick_one_is_precise_at_once() -> None:
    follow: Follow[int] = Follow()
    follow.took(QUICK_S / 2)
    assert follow.ask(1) == Turn(1, rough=False, follows=True)
    assert follow.ended(QUICK_S / 2) is None
    assert follow.rest() is None
    assert not follow.is_busy


def test_wishes_that_were_not_begun_are_forgotten() -> None:
    follow = slow()
    follow.ask(1)
    assert [follow.ask(n) for n in (2, 3, 4)] == [None, None, None]
    assert follow.ended(0.02) == Turn(4, rough=True, follows=True)


def test_a_precise_one_is_superseded_by_the_next_move() -> None:
    follow = slow()
    follow.ask(1)
    follow.ended(0.02)
    follow.rest()
    assert follow.ask(2) == Turn(2, rough=True, follows=True)


def test_a_rest_while_the_last_wish_waits_is_precise_at_once() -> None:
    follow = slow()
    follow.ask(1)
    follow.ask(2)
    assert follow.rest() is None
    assert follow.ended(0.02) == Turn(2, rough=False, follows=False)


def test_what_is_forgotten_is_not_owed() -> None:
    follow = slow()
    follow.ask(1)
    follow.forget()
    assert follow.rest() is None
    assert not follow.is_busy


@given(st.lists(st.sampled_from(("ask", "rest", "end")), max_size=60), st.booleans())
def test_in_the_end_the_newest_wish_is_answered_precisely(events: list[str], quick: bool) -> None:
    seconds = QUICK_S / 2 if quick else 4 * QUICK_S
    follow: Follow[int] = Follow()
    follow.took(seconds)
    running: Turn[int] | None = None
    answered: list[Turn[int]] = []
    wished = 0
    for event in [*events, "rest", *["end"] * 4]:
        begun: Turn[int] | None = None
        if event == "ask":
            wished += 1
            begun = follow.ask(wished)
        elif event == "rest":
            begun = follow.rest()
        elif running is not None:
            answered.append(running)
            running = None
            begun = follow.ended(seconds)
        if begun is not None:
            assert running is None or not running.follows, "what follows the hand is let run to its end"
            running = begun
    assert [turn.wish for turn in answered] == sorted(turn.wish for turn in answered)
    if wished:
        assert answered[-1].wish == wished
        assert not answered[-1].rough
    assert not follow.is_busy


@pytest.mark.parametrize("seconds", [None, 2 * QUICK_S])
def test_unknown_is_slow(seconds: float | None) -> None:
    follow: Follow[int] = Follow()
    if seconds is not None:
        follow.took(seconds)
    turn = follow.ask(1)
    assert turn is not None
    assert turn.rough
