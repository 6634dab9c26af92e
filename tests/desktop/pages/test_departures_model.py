"""Departures compared, without a window."""

from __future__ import annotations

import threading
from dataclasses import replace
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.desktop.compute import Question
from seacruise.desktop.pages.departures_model import (
    Arrived,
    Begun,
    Comparison,
    Delivery,
    Outcome,
    Wish,
    compare_departures,
)
from seacruise.desktop.pages.inbox import Inbox
from seacruise.desktop.pages.plot import Scale, step_h, ticks_h, with_room
from seacruise.desktop.pages.words import verdict_sentences
from seacruise.errors import CancelledError, InputError, NoPassageError
from seacruise.passage import PassageRequest
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.study import compare, departures_from, variants
from seacruise.weather.sample import sample_wind
from seacruise.weather.wind import Wind
from tests.desktop.pages.doubles import (
    BAVARIA,
    FIRST,
    HeldComparer,
    answer,
    begun,
    fetch_for_departures,
    later,
    port,
    question,
    run_of,
    yachts,
)
from tests.passages import veering_wind
from tests.routing.worlds import cache_dir_of


def wish(**more: Any) -> Wish:
    return replace(Wish(question(), 4, timedelta(hours=6)), **more)


def ran(asked: Wish, settings: Settings, comparer: HeldComparer, **more: Any) -> list[Delivery]:
    given: list[Delivery] = []
    comparer.let_go(1000)
    more.setdefault("fetcher", fetch_for_departures)
    compare_departures(
        asked, settings=settings, job=more.pop("job", Job()), deliver=given.append, comparer=comparer, **more
    )
    return given


def by_hour(request: PassageRequest) -> float:
    assert request.departure is not None
    return 40.0 - (request.departure - FIRST).total_seconds() / 7200.0


def never(*_: object) -> Wind:
    raise AssertionError("the wind was fetched")


def comparison(hours: dict[str, list[float | None]]) -> Comparison:
    count = len(next(iter(hours.values())))
    made = Comparison(begun(count, *hours))
    number = 0
    for yacht, values in hours.items():
        for k, value in enumerate(values):
            made.add(Arrived(number, run_of(later(6.0 * k), value, yacht)))
            number += 1
    return made


# ------------------------------------------------------------------------------------------- the work


def test_departures_are_told_first_and_each_passage_as_it_is_found(settings: Settings) -> None:
    given = ran(wish(), settings, HeldComparer(by_hour))
    first, *others = given
    assert isinstance(first, Begun)
    assert first.slots == tuple((later(6.0 * k), BAVARIA) for k in range(4))
    found = {item.number: item.run.duration_h for item in others if isinstance(item, Arrived)}
    assert found == {0: 40.0, 1: 37.0, 2: 34.0, 3: 31.0}
    assert len(others) == 4


def test_every_yacht_sails_every_departure(settings: Settings) -> None:
    comparer = HeldComparer(by_hour)
    extra = (yachts()["Nordic Folkboat"],)
    first = ran(wish(yachts=extra), settings, comparer)[0]
    assert isinstance(first, Begun)
    assert [name for _, name in first.slots] == [BAVARIA] * 4 + ["Nordic Folkboat"] * 4
    assert {(r.departure, r.yacht.name) for r in comparer.asked} == set(first.slots)


def test_the_bands_come_after_all_passages(settings: Settings) -> None:
    wind = replace(veering_wind(), members=(veering_wind(), veering_wind()))
    comparer = HeldComparer(by_hour)
    reports: list[float | None] = []
    job = Job(report=lambda stage, fraction, message: reports.append(fraction))
    given = ran(wish(), settings, comparer, fetcher=lambda *_: wind, job=job)
    bands = [item.run.band is not None for item in given if isinstance(item, Arrived)]
    assert bands == [False] * 4 + [True] * 4
    assert comparer.members_asked == 4
    told = [fraction for fraction in reports if fraction is not None]
    assert told == sorted(told)
    assert told[-1] == pytest.approx(1.0)


def test_members_are_left_out_when_they_are_not_wanted(settings: Settings) -> None:
    wind = replace(veering_wind(), members=(veering_wind(), veering_wind()))
    comparer = HeldComparer(by_hour)
    ran(wish(members=False), settings, comparer, fetcher=lambda *_: wind)
    assert comparer.members_asked == 0


def test_the_wind_of_the_passage_shown_is_used(settings: Settings) -> None:
    given = ran(wish(), settings, HeldComparer(by_hour), known=answer(), fetcher=never)
    assert len(given) == 5


@pytest.mark.parametrize(
    "other", [{"forecast": ("practice",)}, {"end": replace(port("Sandhamn"), lat=40.0, lon=5.0)}]
)
def test_another_forecast_or_place_is_fetched(settings: Settings, other: dict[str, Any]) -> None:
    fetched: list[Question] = []

    def fetch(asked: Question, settings: Settings, job: Job) -> Wind:
        fetched.append(asked)
        return veering_wind()

    asked = wish(question=replace(question(), **other))
    ran(asked, settings, HeldComparer(by_hour), known=answer(), fetcher=fetch)
    assert fetched == [asked.question]


def test_areas_to_avoid_and_options_go_along(settings: Settings) -> None:
    comparer = HeldComparer(by_hour)
    options = replace(question().options, motor_below_kn=3.0)
    ran(wish(question=replace(question(), options=options)), settings, comparer)
    assert {request.options for request in comparer.asked} == {options}


def test_cancelling_ends_it_and_hands_over_no_more(settings: Settings) -> None:
    comparer, job = HeldComparer(by_hour), Job()
    given: list[Delivery] = []
    begun_event, errors = threading.Event(), []

    def deliver(item: Delivery) -> None:
        given.append(item)
        begun_event.set()

    def work() -> None:
        try:
            compare_departures(
                wish(),
                settings=settings,
                job=job,
                deliver=deliver,
                fetcher=fetch_for_departures,
                comparer=comparer,
            )
        except CancelledError as error:
            errors.append(error)

    thread = threading.Thread(target=work)
    thread.start()
    assert begun_event.wait(20)
    job.cancel.set()
    thread.join(20)
    assert not thread.is_alive()
    assert len(errors) == 1
    assert len(given) == 1


def test_too_many_are_refused_before_anything_is_planned(settings: Settings) -> None:
    wind = replace(veering_wind(), members=(veering_wind(),) * 50)
    comparer = HeldComparer(by_hour)
    with pytest.raises(InputError, match="100 passages, each for 50 members"):
        ran(wish(count=100, every=timedelta(minutes=10)), settings, comparer, fetcher=lambda *_: wind)
    assert not comparer.asked


def test_one_port_twice_is_refused(settings: Settings) -> None:
    asked = wish(question=replace(question(), end=question().start))
    with pytest.raises(InputError, match="both the start and the end"):
        ran(asked, settings, HeldComparer(by_hour), fetcher=never)


def test_a_first_departure_outside_the_forecast_is_refused(settings: Settings) -> None:
    asked = wish(question=replace(question(), departure=later(1000)))
    with pytest.raises(NoPassageError, match="outside the forecast"):
        ran(asked, settings, HeldComparer(by_hour))


def test_figures_are_those_of_the_study(settings: Settings, tmp_path_factory: pytest.TempPathFactory) -> None:
    base: Path = tmp_path_factory.getbasetemp()
    settings = replace(settings, cache_dir=cache_dir_of(base))
    asked = replace(question(), start=port("Visby"), end=port("Västervik"))
    given: list[Delivery] = []
    compare_departures(
        Wish(asked, 2, timedelta(hours=9)),
        settings=settings,
        job=Job(),
        deliver=given.append,
        fetcher=lambda *_: sample_wind(),
    )
    request = PassageRequest(asked.start, asked.end, asked.yacht, sample_wind(), FIRST)
    departures = departures_from(request, count=2, every=timedelta(hours=9))
    study = compare(variants(request, departures=departures), settings=settings)
    arrived = sorted((item for item in given if isinstance(item, Arrived)), key=lambda item: item.number)
    assert tuple(item.run for item in arrived) == study.runs
    assert all(item.run.found for item in arrived)


# ------------------------------------------------------------------------------------- what is best


@pytest.mark.parametrize(
    ("hours", "outcome", "best", "saves"),
    [
        ([40.0, 36.0, 34.0, 38.0], Outcome.OTHER, 2, 6.0),
        ([34.0, 36.0, 40.0, 38.0], Outcome.PRESENT, 0, 6.0),
        ([34.02, 36.0, 34.0, 38.0], Outcome.PRESENT, 0, 3.98),
        ([34.0, 34.05, 34.01, 34.0], Outcome.EQUAL, 0, 0.05),
        ([None, 36.0, 34.0, None], Outcome.UNLIKE_PRESENT, 2, 0.0),
        ([None, None, 34.0, None], Outcome.ONLY, 2, 0.0),
        ([None, None, None, None], Outcome.NONE, None, 0.0),
    ],
)
def test_the_best_departure(
    hours: list[float | None], outcome: Outcome, best: int | None, saves: float
) -> None:
    made = comparison({BAVARIA: hours})
    verdict = made.verdict(BAVARIA)
    assert verdict.outcome is outcome
    assert (verdict.best and verdict.best.departure) == (None if best is None else later(6.0 * best))
    assert verdict.hours == pytest.approx(saves)
    assert [row.number for row in made.rows() if row.is_best] == ([] if best is None else [best])


def test_too_much_held_wind_is_no_ground_for_a_choice() -> None:
    made = comparison({BAVARIA: [34.0, 40.0, 38.0]})
    made.add(Arrived(0, run_of(FIRST, 34.0, held_h=20.0)))
    verdict = made.verdict(BAVARIA)
    assert verdict.outcome is Outcome.LESS_HELD
    assert verdict.best is not None
    assert verdict.best.duration_h == 38.0


def test_where_all_is_beyond_the_forecast_no_departure_saves_anything() -> None:
    made = comparison({BAVARIA: [34.0, 40.0]})
    made.add(Arrived(0, run_of(FIRST, 34.0, held_h=20.0)))
    made.add(Arrived(1, run_of(later(6.0), 40.0, held_h=26.0)))
    verdict = made.verdict(BAVARIA)
    assert verdict.outcome is Outcome.BEYOND
    assert verdict.hours == 0.0
    assert verdict_sentences(made)[0].startswith("Nothing can be said yet about when to leave")


def test_while_others_are_awaited_nothing_is_called_the_only_one() -> None:
    made = Comparison(begun(3))
    assert made.verdict(BAVARIA).outcome is Outcome.WAITING
    made.add(Arrived(1, run_of(later(6), 30.0)))
    assert made.verdict(BAVARIA).outcome is Outcome.UNLIKE_PRESENT
    assert made.known == 1
    assert [row.run is None for row in made.rows()] == [True, False, True]


def test_each_yacht_is_judged_for_herself() -> None:
    made = comparison({BAVARIA: [40.0, 34.0], "Nordic Folkboat": [60.0, 70.0]})
    assert made.yachts == (BAVARIA, "Nordic Folkboat")
    assert [row.number for row in made.rows() if row.is_best] == [1, 2]
    fastest = made.fastest()
    assert fastest is not None
    assert (fastest.yacht, fastest.hours) == (BAVARIA, 6.0)


@given(st.lists(st.none() | st.floats(1.0, 300.0), min_size=1, max_size=12))
def test_nothing_shorter_than_the_best_by_much_is_passed_over(hours: list[float | None]) -> None:
    verdict = comparison({BAVARIA: hours}).verdict(BAVARIA)
    found = [h for h in hours if h is not None]
    assert (verdict.best is None) == (not found)
    if verdict.best is not None and verdict.best.duration_h is not None:
        assert verdict.best.duration_h - min(found) < 5.0 / 60.0 + 1e-9
        assert verdict.hours >= 0.0


def test_the_curves_carry_duration_or_arrival_and_the_band() -> None:
    made = comparison({BAVARIA: [40.0, None]})
    made.add(Arrived(0, run_of(FIRST, 40.0, band=True)))
    (duration,) = made.curves("duration")
    (arrival,) = made.curves("arrival")
    first, second = duration.dots
    assert (first.low, first.value, first.middle, first.high) == (39.0, 40.0, 40.5, 43.0)
    assert second.value is None
    since = FIRST.timestamp() / 3600.0
    assert arrival.dots[0].value == pytest.approx(since + 40.0)
    assert arrival.dots[0].high == pytest.approx(since + 43.0)
    assert made.has_bands


# --------------------------------------------------------------------------------------- small parts


@given(st.floats(-1e6, 1e6), st.floats(0.01, 2000.0), st.integers(2, 12))
def test_ticks_are_even_within_and_few(low: float, span: float, most: int) -> None:
    step = step_h(span, most)
    ticks = ticks_h(low, low + span, most)
    assert len(ticks) <= most + 1
    assert all(low - 1e-3 <= tick <= low + span + 1e-3 for tick in ticks)
    assert all(tick / step == pytest.approx(round(tick / step), abs=1e-6) for tick in ticks)


@given(st.floats(0.0, 500.0), st.floats(0.0, 500.0))
def test_no_dot_lies_on_the_frame(low: float, span: float) -> None:
    begin, end = with_room(low, low + span, least=2.0)
    assert begin < low
    assert end > low + span
    assert end - begin >= 2.0 - 1e-9
    scale = Scale(begin, end, 100.0, 10.0)
    assert 10.0 < scale.to_px(low + span) <= scale.to_px(low) < 100.0


def test_the_inbox_keeps_the_order_and_gives_each_item_once() -> None:
    inbox: Inbox[int] = Inbox()

    def fill() -> None:
        for k in range(1000):
            inbox.put(k)

    thread = threading.Thread(target=fill)
    thread.start()
    taken: list[int] = []
    while thread.is_alive() or len(taken) < 1000:
        taken += inbox.take()
    assert taken == list(range(1000))
    assert inbox.take() == []
