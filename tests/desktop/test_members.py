"""Members of an ensemble: found beside the window, told, drawn, and dropped with the question."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from datetime import timedelta

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QImage, QPainter
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise.alternatives import Passing, Split
from seacruise.desktop.chart.context import open_menu
from seacruise.desktop.chart.members_layer import MemberBoatsLayer
from seacruise.desktop.chart.palette import PALETTES, Palette
from seacruise.desktop.chart.plane import point
from seacruise.desktop.chart.view import ChartView
from seacruise.desktop.compute import Answer, Question, plan_passage
from seacruise.desktop.members import about, bundle_text, sail_members, split_text, spread_text
from seacruise.desktop.window import MainWindow
from seacruise.errors import CancelledError, NoPassageError
from seacruise.members import Bundle, bundle_of
from seacruise.passage import Options, Passage, PassageRequest
from seacruise.ports import Port
from seacruise.progress import Job
from seacruise.resources import resource_path
from seacruise.settings import Settings
from seacruise.study import Spread
from seacruise.study import ensemble as ensemble_of
from seacruise.weather.wind import Wind
from seacruise.yacht.fleet import find_yacht, load_fleet
from tests.desktop.conftest import HeldPlanner
from tests.desktop.test_alternatives import EAST, eastward, question_by
from tests.desktop.test_fewer_turns import CALMER
from tests.desktop.test_layers import contrast
from tests.passages import hand_made_passage, veering_wind
from tests.routing.worlds import DEPARTURE, cache_dir_of, steady_wind

COUNT = 8


def ensemble(count: int = COUNT) -> Wind:
    """Make a wind with members, each of them named by its source."""
    wind = veering_wind()
    members = tuple(
        replace(wind, forecast=replace(wind.forecast, source=f"member {number + 1}"))
        for number in range(count)
    )
    return replace(wind, members=members)


def answer_of(count: int = COUNT) -> Answer:
    return Answer(hand_made_passage(), ensemble(count), question_by(None))


def plan_of_member(request: PassageRequest, *, settings: Settings, job: Job) -> Passage:
    """Make each member an hour longer than the one before; the last one goes east of Gotland."""
    del settings
    job.check()
    number = int(request.wind.forecast.source.split()[-1])
    if number == 2:
        raise NoPassageError("Becalmed.", reason="becalmed")
    return eastward(1.9 if number == COUNT else 0.0, float(number - 1))


@pytest.fixture
def kept(monkeypatch: pytest.MonkeyPatch) -> None:
    """Sail the planned line in no time, two hours slower than planned."""
    monkeypatch.setattr(
        "seacruise.members.hours_along", lambda _request, planned, *, settings: planned.duration_h + 2.0
    )


@pytest.fixture
def bundle(settings: Settings, kept: None) -> Bundle:
    return sail_members(
        answer_of(), settings=settings, job=Job(), planner=plan_of_member, deliver=lambda _: None
    )


# --- found -------------------------------------------------------------------------------------------------


def test_each_member_is_sailed_in_its_wind_from_the_hour_of_the_passage(
    settings: Settings, kept: None
) -> None:
    asked: list[PassageRequest] = []

    def plan(request: PassageRequest, *, settings: Settings, job: Job) -> Passage:
        asked.append(request)
        return plan_of_member(request, settings=settings, job=job)

    answer = answer_of()
    answer = replace(answer, question=replace(answer.question, departure=None))
    found = sail_members(answer, settings=settings, job=Job(), planner=plan, deliver=lambda _: None)
    assert sorted(request.wind.forecast.source for request in asked) == [
        f"member {number + 1}" for number in range(COUNT)
    ]
    assert {request.departure for request in asked} == {answer.passage.departure}
    assert [member.number for member in found.members] == list(range(COUNT))
    assert [member.passage is None for member in found.members] == [number == 1 for number in range(COUNT)]
    assert found.is_complete
    assert found.planned is answer.passage


def test_a_cancelled_search_ends(settings: Settings, kept: None) -> None:
    job = Job()
    job.cancel.set()
    with pytest.raises(CancelledError):
        sail_members(answer_of(), settings=settings, job=job, planner=plan_of_member, deliver=lambda _: None)


def test_they_say_what_the_band_of_when_to_go_says(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Both sail each member, and the planned line in it: to the last digit the same."""
    base = tmp_path_factory.getbasetemp()
    folders = Settings(cache_dir=cache_dir_of(base), data_dir=base / "data")
    yacht = find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")]))
    start, end = Port("South", "", 55.9, 19.3), Port("North", "", 56.9, 19.3)
    winds = tuple(steady_wind(knots, 60.0) for knots in (8.0, 14.0, 20.0))
    wind = replace(winds[1], members=winds)
    question = Question(start, end, DEPARTURE, yacht, ("steady",), Options(spacing_nm=4.0, refine=False))
    request = PassageRequest(start, end, yacht, wind, DEPARTURE, question.options)
    passage = plan_passage(request, settings=folders, job=Job())
    found = sail_members(
        Answer(passage, wind, question),
        settings=folders,
        job=Job(),
        planner=plan_passage,
        deliver=lambda _: None,
    )
    band = ensemble_of(request, settings=folders)
    assert found.duration_h == band.duration_h
    assert found.kept_h == band.followed_h
    assert found.duration_h.low is not None
    assert found.duration_h.low < passage.duration_h


# --- in words ----------------------------------------------------------------------------------------------


def test_the_members_in_words(app: QApplication, bundle: Bundle) -> None:
    text = bundle_text(bundle)
    assert text.startswith("In 8 members: ")
    assert "No passage in 1 of 8." in text
    assert "The planned line takes " in text
    assert "6 of 8 go west of Gotland, as planned." in text
    few = bundle_of(bundle.planned, COUNT, bundle.members[:3])
    assert bundle_text(few) == "3 of 8 members sailed so far…"
    some = bundle_of(bundle.planned, COUNT, bundle.members[2:])
    assert bundle_text(some).startswith("In 6 of 8 members so far: ")


def test_a_spread_in_words(app: QApplication) -> None:
    assert spread_text(Spread(41.2, 44.4, 48.6)) == "41 h to 49 h (10 to 90 %), median 44 h"
    assert spread_text(Spread(41.2, 41.3, 41.4)) == "about 41 h"
    assert spread_text(Spread(41.2, 44.4, None)) == "41 h at best (10 %)"
    assert spread_text(Spread(None, None, None)) == "hardly ever arrives"
    assert about(5.7) == "5 h 40 min"


def test_unlike_the_plan(app: QApplication) -> None:
    split = Split("Gotland", "west", (Passing("east", 18, 57.4, 19.4), Passing("west", 3, 57.4, 17.4)))
    assert split_text(split, 21) == "18 of 21 go east of Gotland, unlike the plan."


@given(st.floats(0.1, 500.0), st.floats(0.0, 100.0))
def test_what_is_longer_never_reads_shorter(hours: float, more: float) -> None:
    def read(text: str) -> float:
        parts = text.replace(" min", "").split(" h")
        return float(parts[0]) + float(parts[1] or 0.0) / 60.0

    assert read(about(hours)) <= read(about(hours + more)) + 1e-9
    assert abs(read(about(hours)) - hours) <= (0.5 if hours >= 19.9 else 1.0 / 12.0) + 1e-6


# --- drawn -------------------------------------------------------------------------------------------------


@pytest.fixture
def chart(view: ChartView, bundle: Bundle) -> ChartView:
    answer = answer_of()
    view.show_answer(answer)
    view.fit_passage(answer)
    view.members.show_bundle(bundle)
    return view


def test_a_boat_is_where_its_passage_has_it(chart: ChartView) -> None:
    passage = hand_made_passage()
    boats = chart.members.boats_at(passage.departure.timestamp())
    assert boats.shape == (COUNT - 1, 2)
    start = point(passage.track.lat[0], passage.track.lon[0])
    assert boats[0] == pytest.approx([start.x(), start.y()], abs=1.0)
    # Whoever is there stays there.
    late = chart.members.boats_at(passage.arrival.timestamp() + 1e6)
    there = point(passage.track.lat[-1], passage.track.lon[-1])
    assert late[0] == pytest.approx([there.x(), there.y()], abs=1.0)
    chart.members.show_bundle(None)
    assert chart.members.boats_at(0.0).shape == (0, 2)


def test_their_boats_are_drawn_where_they_are(chart: ChartView) -> None:
    image = QImage(chart.viewport().size(), QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(Qt.GlobalColor.white)
    layer = MemberBoatsLayer(QRectF(), chart.members, chart.route)
    layer.set_palette(chart.members.colours)
    time = hand_made_passage().departure + timedelta(hours=20)
    chart.show_time(answer_of(), time.timestamp())
    painter = QPainter(image)
    layer.paint(painter, chart.viewportTransform(), QRectF(image.rect()))
    painter.end()
    x, y = chart.members.boats_at(time.timestamp())[-1]
    at = chart.viewportTransform().map(QPointF(x, y))
    assert image.pixelColor(round(at.x()), round(at.y())) == chart.members.colours.member


def test_how_many_go_where_is_written_beside_the_island(chart: ChartView) -> None:
    to_pixels, room = chart.viewportTransform(), QRectF(chart.viewport().rect())
    image = QImage(chart.size(), QImage.Format.Format_ARGB32_Premultiplied)
    painter = QPainter(image)
    chart.members.labels.begin(room)
    chart.members.paint(painter, to_pixels, room)
    painter.end()
    assert {label.text for label in chart.members.labels.written} == {"6 of 8 members", "1 of 8 members"}


def test_the_menu_of_a_place_tells_them(chart: ChartView) -> None:
    menu = open_menu(chart, 56.0, 19.0, chart.mapToGlobal(chart.rect().center()))
    try:
        assert any(action.text().startswith("In 8 members: ") for action in menu.actions())
    finally:
        menu.close()


@pytest.mark.parametrize("palette", PALETTES.values(), ids=list(PALETTES))
def test_they_are_told_from_every_ground(palette: Palette) -> None:
    for ground in (*palette.depths, palette.land, palette.card):
        assert contrast(palette.member, ground) >= 3.0
    assert palette.member not in (palette.isochrone, palette.keel, palette.magenta, palette.ink)


def test_a_picture_gets_what_is_on_the_chart(
    with_members: MainWindow, planner: HeldPlanner, qtbot: QtBot
) -> None:
    window = with_members
    assert not window.layers.beside().members
    planner.gate.set()
    qtbot.waitUntil(lambda: said(window).startswith("In 8 members: "))
    window.chart.view.others.show_ways((CALMER, EAST))
    beside = window.layers.beside()
    assert len(beside.members) == COUNT
    assert [name for name, _ in beside.ways] == [
        "tacks and gybes: 3, 51 h 00 min",
        "east of Gotland, 51 h 46 min",
    ]


def test_the_legend_has_a_line_more(chart: ChartView) -> None:
    room, font = QRectF(chart.viewport().rect()), chart.font()
    before = chart.legend.card(room, font).height()
    chart.legend.members = COUNT
    assert chart.legend.card(room, font).height() > before
    assert chart.grab().toImage().size() == chart.size()


# --- in the window -----------------------------------------------------------------------------------------


@pytest.fixture
def with_members(
    make_window: Callable[..., MainWindow],
    planner: HeldPlanner,
    qtbot: QtBot,
    kept: None,
    monkeypatch: pytest.MonkeyPatch,
) -> MainWindow:
    """A window with a passage in a forecast with members; the planner holds them."""
    monkeypatch.setattr("tests.desktop.conftest.veering_wind", ensemble)
    window = make_window()
    planner.gate.set()
    with qtbot.waitSignal(window.settled, timeout=20_000):
        window.calculate()
    planner.gate.clear()
    return window


def said(window: MainWindow) -> str:
    return window.side.result.members.text()


def test_members_come_by_themselves_and_go_with_the_switch(
    with_members: MainWindow, planner: HeldPlanner, qtbot: QtBot
) -> None:
    window, switch = with_members, with_members.menus.layers["members"]
    assert switch.isEnabled()
    assert switch.isChecked()
    assert window.chart.view.legend.members == COUNT
    qtbot.waitUntil(lambda: bool(said(window)))
    planner.gate.set()
    qtbot.waitUntil(lambda: said(window).startswith("In 8 members: "))
    assert window.side.result.members.isVisible()
    found = window.chart.view.members.bundle
    assert found is not None
    assert found.is_complete
    switch.setChecked(False)
    assert window.chart.view.members.bundle is None
    assert not window.side.result.members.isVisible()
    assert window.chart.view.legend.members == 0


def test_another_question_drops_them_and_gets_its_own(
    with_members: MainWindow, planner: HeldPlanner, qtbot: QtBot
) -> None:
    window = with_members
    planner.gate.set()
    qtbot.waitUntil(lambda: window.chart.view.members.bundle is not None)
    qtbot.waitUntil(lambda: said(window).startswith("In 8 members: "))
    planner.gate.clear()
    first = window.state.answer
    moment = window.form.departure.moment + timedelta(hours=1)
    window.form.departure.set_moment(moment, chosen=True)
    planner.gate.set()
    qtbot.waitUntil(lambda: window.state.answer is not first)
    assert window.chart.view.members.bundle is None, "not those of another question"
    qtbot.waitUntil(lambda: said(window).startswith("In 8 members: "))


def test_they_are_cancelled_by_the_switch(
    with_members: MainWindow, planner: HeldPlanner, qtbot: QtBot
) -> None:
    window = with_members
    qtbot.waitUntil(lambda: said(window).startswith("Sailing"))
    window.menus.layers["members"].setChecked(False)
    qtbot.waitUntil(lambda: planner.cancelled > 0)
    assert not said(window)
    assert window.chart.view.members.bundle is None


def test_while_a_hand_holds_the_chart_nothing_begins(
    with_members: MainWindow, planner: HeldPlanner, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    window = with_members
    monkeypatch.setattr(QApplication, "mouseButtons", lambda: Qt.MouseButton.LeftButton)
    window.menus.layers["members"].setChecked(False)
    window.menus.layers["members"].setChecked(True)
    asked = len(planner.requests)
    qtbot.wait(700)
    assert len(planner.requests) == asked
    monkeypatch.undo()


def test_a_forecast_without_members_says_so(answered: MainWindow) -> None:
    switch = answered.menus.layers["members"]
    assert not switch.isEnabled()
    assert "it has none" in switch.text()
    assert "Open-Meteo" in switch.toolTip()
    assert not said(answered)
    assert answered.chart.view.legend.members == 0


def test_before_there_is_a_passage_the_switch_is_a_wish(window: MainWindow) -> None:
    assert window.menus.layers["members"].isEnabled()
