"""Other ways on the chart: found beside the window, drawn, named, picked and adopted."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from datetime import UTC, datetime, timedelta

import numpy as np
import pytest
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QImage, QPainter
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise.alternatives import OtherWay
from seacruise.desktop.alternatives import Way, find_ways, way_of_departure
from seacruise.desktop.chart.context import open_menu
from seacruise.desktop.chart.plane import point
from seacruise.desktop.chart.view import ChartView
from seacruise.desktop.compute import Answer, Question
from seacruise.desktop.pages.departures_model import Row
from seacruise.desktop.window import MainWindow
from seacruise.passage import Options, Passage, PassageRequest
from seacruise.ports import Port
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.study import Run
from tests.desktop.conftest import HeldPlanner
from tests.passages import hand_made_passage, veering_wind

LINE = np.array([[54.6, 18.9], [56.0, 19.2], [57.4, 19.3], [58.6, 19.2], [59.3, 18.9]])
EAST = Way("Gotland", "east", 51.0 + 46 / 60, 1.0 + 57 / 60, LINE, (57.4, 19.3), (57.4, 19.3))


def eastward(shift_deg: float, hours: float) -> Passage:
    """Make a passage farther east, of so many hours more."""
    passage = hand_made_passage()
    track = replace(passage.track, lon=passage.track.lon + shift_deg)
    waypoints = tuple(replace(one, lon=one.lon + shift_deg) for one in passage.waypoints)
    arrival = passage.arrival + timedelta(hours=hours)
    return replace(passage, track=track, waypoints=waypoints, arrival=arrival)


def question_by(via: Port | None) -> Question:
    start, end = Port("Gdynia", "PL", 54.528, 18.57), Port("Sandhamn", "SE", 59.285, 18.94)
    moment = datetime(2016, 11, 20, 6, tzinfo=UTC)
    return Question(start, end, moment, None, ("sample",), Options(), via)  # type: ignore[arg-type]


def plan_eastward(request: PassageRequest, *, settings: Settings, job: Job) -> Passage:
    """Sail Gotland's other side when its western one is barred, and wherever nothing is."""
    del settings, job
    barred = any(zone.name == "Gotland" for zone in request.zones.zones)
    return eastward(1.9, 2.0) if barred else hand_made_passage()


# --- in words ----------------------------------------------------------------------------------------------


def test_words_of_a_way(app: QApplication) -> None:
    assert EAST.name == "east of Gotland"
    assert EAST.label == "east of Gotland 51 h 46 min"
    assert EAST.text == "east of Gotland 51 h 46 min, +1 h 57 min"
    direct = replace(EAST, island="", side="", hours=49.5, more_h=-2.25, via=None)
    assert direct.text == "direct 49 h 30 min, −2 h 15 min"


# --- found -------------------------------------------------------------------------------------------------


def test_ways_are_found_in_the_wind_at_hand(app: QApplication, settings: Settings) -> None:
    answer = Answer(hand_made_passage(), veering_wind(), question_by(None))
    ways = find_ways(answer, settings=settings, job=Job(), planner=plan_eastward)
    assert [way.name for way in ways] == ["east of Gotland"]
    way = ways[0]
    assert way.hours == pytest.approx(answer.passage.duration_h + 2.0)
    assert way.more_h == pytest.approx(2.0)
    assert way.via == way.place
    assert way.place[1] > 18.5, "abeam of Gotland, to the east"


def test_of_a_passage_by_a_place_the_way_without_it_is_one_more(
    app: QApplication, settings: Settings
) -> None:
    known = Answer(hand_made_passage(), veering_wind(), question_by(None))
    other = find_ways(known, settings=settings, job=Job(), planner=plan_eastward)[0]
    via = Port("via", "", *other.place)
    shown = Answer(eastward(1.9, 2.1), veering_wind(), question_by(via))
    ways = find_ways(shown, settings=settings, job=Job(), planner=plan_eastward)
    assert [way.name for way in ways] == ["direct"], "the way shown is not offered again"
    assert ways[0].via is None
    assert ways[0].more_h == pytest.approx(-2.1)


# --- departures that were compared --------------------------------------------------------------------------


def run_of(passage: Passage | None) -> Run:
    moment = hand_made_passage().departure if passage is None else passage.departure
    return Run(moment, "Bavaria 46 Cruiser", None, passage=passage)


def later(hours: float) -> Passage:
    passage, delay = hand_made_passage(), timedelta(hours=hours)
    return replace(passage, departure=passage.departure + delay, arrival=passage.arrival + delay * 1.5)


def test_another_departure_is_a_way_too(app: QApplication) -> None:
    shown = hand_made_passage()
    way = way_of_departure(run_of(later(6.0)), shown)
    assert way is not None
    assert way.leaving == shown.departure + timedelta(hours=6)
    assert way.label.startswith("leaving 20 Nov 12:00 ")
    assert way.more_h == pytest.approx(3.0)
    assert way_of_departure(run_of(shown), shown) is None, "that is the one shown"
    assert way_of_departure(run_of(None), shown) is None


def test_the_chosen_departure_is_on_the_chart_while_its_page_is_open(
    answered: MainWindow, planner: HeldPlanner, qtbot: QtBot
) -> None:
    window, view = answered, answered.chart.view
    page = window.planning.departures
    window.planning.frame.open_page(page)
    row = Row(0, later(6.0).departure, "Bavaria 46 Cruiser", run_of(later(6.0)))
    page.table.chosen.emit(row)
    assert [way.leaving for way in view.others.ways] == [row.departure]
    planner.gate.set()
    view.way_picked.emit(view.others.ways[0])
    assert window.form.departure.moment == row.departure
    qtbot.waitUntil(lambda: not window.steering.router.is_busy)
    page.table.chosen.emit(row)
    window.planning.frame.close_pages()
    assert not view.others.ways


# --- drawn -------------------------------------------------------------------------------------------------


@pytest.fixture
def view(app: QApplication, qtbot: QtBot) -> Iterator[ChartView]:
    view = ChartView()
    qtbot.addWidget(view)
    view.resize(800, 600)
    view.show()
    answer = Answer(hand_made_passage(), veering_wind(), question_by(None))
    view.show_answer(answer)
    view.fit_passage(answer)
    view.others.show_ways((EAST,))
    yield view
    view.painter_jobs.shut_down()


def test_a_way_is_under_the_pointer_where_it_is_drawn(view: ChartView) -> None:
    to_pixels = view.viewportTransform()
    at = to_pixels.map(point(57.4, 19.3))
    assert view.others.way_at(at, to_pixels) is EAST
    assert view.others.way_at(at + QPointF(5.0, 0.0), to_pixels) is EAST
    assert view.others.way_at(at + QPointF(40.0, 0.0), to_pixels) is None
    view.others.setVisible(False)
    assert view.others.way_at(at, to_pixels) is None


def test_its_name_is_beside_it_and_never_on_the_passage(view: ChartView) -> None:
    to_pixels, room = view.viewportTransform(), QRectF(view.viewport().rect())
    image = QImage(view.size(), QImage.Format.Format_ARGB32_Premultiplied)
    painter = QPainter(image)
    view.others.labels.begin(room)
    view.others.paint(painter, to_pixels, room)
    painter.end()
    written = view.others.labels.written
    assert [label.text for label in written] == ["east of Gotland 51 h 46 min"]
    metrics = view.fontMetrics()
    place = QRectF(
        written[0].base.x(), written[0].base.y() - metrics.ascent(), metrics.height(), metrics.height()
    )
    assert not view.route.touches(place, to_pixels)


def test_the_track_touches_the_boxes_it_leads_through(view: ChartView) -> None:
    to_pixels = view.viewportTransform()
    on = to_pixels.map(point(55.6, 18.2))
    assert view.route.touches(QRectF(on.x() - 4, on.y() - 4, 8, 8), to_pixels)
    assert not view.route.touches(QRectF(on.x() + 60, on.y() - 4, 8, 8), to_pixels)


def test_a_click_picks_it(view: ChartView, qtbot: QtBot) -> None:
    at = view.viewportTransform().map(point(57.4, 19.3)).toPoint()
    with qtbot.waitSignal(view.way_picked) as picked:
        QTest.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=at)
    assert picked.args == [EAST]


def test_the_menu_offers_it_for_the_keyboard(view: ChartView) -> None:
    menu = open_menu(view, 56.0, 19.0, view.mapToGlobal(view.rect().center()))
    try:
        assert "Sail east of Gotland 51 h 46 min, +1 h 57 min" in [action.text() for action in menu.actions()]
    finally:
        menu.close()


# --- in the window -----------------------------------------------------------------------------------------


def test_switched_on_found_adopted_and_dropped(
    answered: MainWindow, planner: HeldPlanner, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    window, view = answered, answered.chart.view
    planner.gate.set()

    def one_way(passage: Passage, sail: object, *, job: Job) -> tuple[OtherWay, ...]:
        del sail, job
        return (OtherWay(eastward(1.9, 2.0), "Gotland", "east", 57.4, 19.3),)

    monkeypatch.setattr("seacruise.alternatives.other_ways", one_way)
    assert not view.others.ways
    window.menus.layers["others"].setChecked(True)
    qtbot.waitUntil(lambda: bool(view.others.ways))
    view.way_picked.emit(view.others.ways[0])
    qtbot.waitUntil(lambda: not window.steering.router.is_busy)
    via = window.steering.via
    assert via is not None
    assert (via.lat, via.lon) == (57.4, 19.3)
    qtbot.waitUntil(lambda: [way.name for way in view.others.ways] == ["direct"])
    view.way_picked.emit(view.others.ways[0])
    qtbot.waitUntil(lambda: not window.steering.router.is_busy)
    assert window.steering.via is None
    window.menus.layers["others"].setChecked(False)
    assert not view.others.ways
    assert not window.layers.ways.islands.jobs.is_running
