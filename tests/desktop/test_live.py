"""Re-routing while something is dragged: the newest wins, the window stays free, nothing is fetched."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from dataclasses import replace
from datetime import timedelta

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise.desktop.chart.plane import point
from seacruise.desktop.compute import Answer
from seacruise.desktop.follow import QUICK_S
from seacruise.desktop.state import Phase
from seacruise.desktop.window import MainWindow
from seacruise.errors import InputError, NoPassageError
from seacruise.passage import Passage, PassageRequest
from seacruise.progress import Job
from seacruise.settings import Settings
from tests.desktop.conftest import ASK, Heart, fetch_at_once, texts_of
from tests.passages import DEPARTURE, hand_made_passage


class SteadyPlanner:
    """Answers after a while, leaving when it was asked to."""

    def __init__(self) -> None:
        self.seconds = 0.0
        self.requests: list[PassageRequest] = []
        self.error: Exception | None = None
        self.most_at_once = 0
        self._at_once = 0
        self._lock = threading.Lock()

    def __call__(self, request: PassageRequest, *, settings: Settings, job: Job) -> Passage:
        with self._lock:
            self.requests.append(request)
            self._at_once += 1
            self.most_at_once = max(self.most_at_once, self._at_once)
        try:
            until = time.monotonic() + self.seconds
            while time.monotonic() < until:
                time.sleep(0.002)
                job.check()
            if self.error is not None:
                raise self.error
            passage = hand_made_passage()
            moved = (request.departure or DEPARTURE) - passage.departure
            return replace(
                passage, departure=passage.departure + moved, arrival=passage.arrival + moved, yacht="steady"
            )
        finally:
            with self._lock:
                self._at_once -= 1

    @property
    def roughs(self) -> list[bool]:
        return [not request.options.corridor for request in self.requests]


@pytest.fixture
def steady() -> SteadyPlanner:
    return SteadyPlanner()


@pytest.fixture
def live(app: QApplication, qtbot: QtBot, settings: Settings, steady: SteadyPlanner) -> Iterator[MainWindow]:
    """A window with a passage, whose planner is slow enough to be coarse first."""
    window = MainWindow(settings, planner=steady, fetcher=fetch_at_once)
    qtbot.addWidget(window)
    window.resize(1280, 800)
    window.fill(ASK)
    with qtbot.waitSignal(window.ready, timeout=20_000):
        window.show()
        window.load(warm_up=False)
    with qtbot.waitSignal(window.settled, timeout=20_000):
        window.calculate()
    steady.requests.clear()
    steady.seconds = 0.02
    window.steering.router.note(4 * QUICK_S)
    qtbot.waitUntil(lambda: window.chart.view.is_settled, timeout=30_000)
    yield window
    window.close()


def settle(window: MainWindow, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: not window.steering.router.is_busy, timeout=20_000)


def phase_of(window: MainWindow) -> Phase:
    """Phase, asked anew: a type checker believes that it stays what it was."""
    return window.state.phase


def departure_shown(window: MainWindow) -> object:
    return window.state.answer.passage.departure if window.state.answer else None


def test_a_drag_of_the_departure_is_followed(live: MainWindow, steady: SteadyPlanner, qtbot: QtBot) -> None:
    slider = live.chart.time_bar.departure_slider
    begun = slider.value()
    shown: list[Answer] = []
    live.steering.router.routed.connect(shown.append)
    for step in range(1, 31):
        slider.setValue(begun + step)
        qtbot.wait(10)
    assert live.form.departure.moment == DEPARTURE + timedelta(minutes=300)
    slider.sliderReleased.emit()
    settle(live, qtbot)
    assert len([answer for answer in shown if answer.rough]) >= 3, "the route follows while the hand moves"
    assert len(steady.requests) < 30, "what was overtaken before it began is forgotten"
    departures = [answer.passage.departure for answer in shown]
    assert departures == sorted(departures)
    assert departure_shown(live) == DEPARTURE + timedelta(minutes=300)
    assert live.state.answer is not None
    assert not live.state.answer.rough
    assert live.state.phase is Phase.ROUTE
    assert steady.roughs[-1] is False
    assert all(request.wind is live.state.answer.wind for request in steady.requests), "nothing is fetched"


def test_a_quick_planner_is_precise_while_the_hand_moves(
    live: MainWindow, steady: SteadyPlanner, qtbot: QtBot
) -> None:
    live.steering.router.note(QUICK_S / 2)
    live.chart.time_bar.departure_slider.setValue(40)
    settle(live, qtbot)
    assert steady.roughs == [False]


def test_a_hand_that_rests_gets_the_precise_passage(
    live: MainWindow, steady: SteadyPlanner, qtbot: QtBot
) -> None:
    live.chart.time_bar.departure_slider.setValue(50)
    settle(live, qtbot)
    assert steady.roughs == [True, False], "by resting alone, without letting go"


def test_the_next_move_cancels_a_precise_one(live: MainWindow, steady: SteadyPlanner, qtbot: QtBot) -> None:
    slider = live.chart.time_bar.departure_slider
    slider.setValue(50)
    qtbot.waitUntil(lambda: live.state.answer is not None and live.state.answer.rough)
    steady.seconds = 5.0
    slider.sliderReleased.emit()
    qtbot.waitUntil(lambda: steady.roughs == [True, False])
    steady.seconds = 0.02
    begun = time.monotonic()
    slider.setValue(60)
    settle(live, qtbot)
    assert time.monotonic() - begun < 4.0
    assert departure_shown(live) == DEPARTURE + timedelta(minutes=10 * (60 - 36))


def test_yacht_and_crew_are_followed(live: MainWindow, steady: SteadyPlanner, qtbot: QtBot) -> None:
    live.form.percent_box.setValue(80.0)
    settle(live, qtbot)
    assert steady.requests[-1].options.percent_of_polar == 80.0
    box = live.form.yacht_box
    box.setFocus()
    QTest.keyClick(box, Qt.Key.Key_Down)
    settle(live, qtbot)
    assert steady.requests[-1].yacht.name == box.currentText() != ASK["yacht"]


def test_an_end_is_dragged_on_the_chart(live: MainWindow, steady: SteadyPlanner, qtbot: QtBot) -> None:
    view = live.chart.view
    end = live.form.ends["to"]
    at = view.viewportTransform().map(point(end.lat, end.lon)).toPoint()
    QTest.mouseMove(view.viewport(), at)
    assert view.viewport().cursor().shape() == Qt.CursorShape.OpenHandCursor
    centre = view.middle()
    QTest.mousePress(view.viewport(), Qt.MouseButton.LeftButton, pos=at)
    for step in range(1, 9):
        QTest.mouseMove(view.viewport(), at + QPoint(4 * step, 5 * step))
        qtbot.wait(20)
    there = view.position_at((at + QPoint(32, 40)).toPointF())
    QTest.mouseRelease(view.viewport(), Qt.MouseButton.LeftButton, pos=at + QPoint(32, 40))
    settle(live, qtbot)
    assert (steady.requests[-1].end.lat, steady.requests[-1].end.lon) == pytest.approx(there, abs=1e-3)
    assert steady.requests[-1].start.name == "Gdynia"
    assert steady.roughs[-1] is False
    assert live.form.ends["to"].lat == pytest.approx(there[0], abs=1e-3)
    assert view.middle() == pytest.approx(centre), "the chart stays where it is"


def test_an_end_dropped_on_a_port_becomes_it(live: MainWindow, steady: SteadyPlanner, qtbot: QtBot) -> None:
    view = live.chart.view
    visby = next(p for p in live.form.start_field._ports if p.name == "Visby")
    view.zoom(2.5)
    view.show_place(58.4, 18.3)
    at = [view.viewportTransform().map(point(p.lat, p.lon)).toPoint() for p in (live.form.ends["to"], visby)]
    QTest.mousePress(view.viewport(), Qt.MouseButton.LeftButton, pos=at[0])
    QTest.mouseMove(view.viewport(), at[1] + QPoint(3, -2))
    QTest.mouseRelease(view.viewport(), Qt.MouseButton.LeftButton, pos=at[1] + QPoint(3, -2))
    settle(live, qtbot)
    assert live.form.end_field.text() == "Visby"
    assert steady.requests[-1].end == visby


def test_no_passage_while_dragging_is_told_at_rest(
    live: MainWindow, steady: SteadyPlanner, qtbot: QtBot
) -> None:
    steady.error = NoPassageError("Land all around.", reason="no-water-path", place=(59.3, 18.9))
    live.chart.time_bar.departure_slider.setValue(50)
    settle(live, qtbot)
    assert phase_of(live) is Phase.FAILED
    assert "Land all around." in texts_of(live)
    assert live.state.answer is not None, "the earlier passage stays"
    steady.error = None
    live.chart.time_bar.departure_slider.setValue(60)
    settle(live, qtbot)
    assert phase_of(live) is Phase.ROUTE


def test_following_can_be_switched_off(live: MainWindow, steady: SteadyPlanner, qtbot: QtBot) -> None:
    live.menus.live.setChecked(False)
    live.form.percent_box.setValue(70.0)
    qtbot.wait(50)
    assert not steady.requests
    assert not live.steering.router.is_busy


def test_a_trouble_of_a_dropped_file_outlives_what_follows_the_hand(
    live: MainWindow, steady: SteadyPlanner, qtbot: QtBot
) -> None:
    live.background.troubled.emit(InputError("bad.csv is no polar; choose another file."))
    assert "bad.csv" in texts_of(live)
    before = len(steady.requests)
    live.form.departure.set_moment(live.form.departure.moment + timedelta(hours=2), chosen=True)
    live.form.sailing_changed.emit()
    qtbot.waitUntil(
        lambda: len(steady.requests) > before and not live.steering.router.is_busy, timeout=20_000
    )
    assert "bad.csv" in texts_of(live)
    with qtbot.waitSignal(live.settled, timeout=20_000):
        live.calculate()
    assert "bad.csv" not in texts_of(live)


def test_another_forecast_is_never_fetched_by_a_drag(
    live: MainWindow, steady: SteadyPlanner, qtbot: QtBot
) -> None:
    with qtbot.waitSignal(live.background.horizon_loaded, timeout=20_000):
        live.form.set_forecast(("practice",))
    live.chart.time_bar.departure_slider.setValue(5)
    qtbot.wait(50)
    assert not steady.requests


def test_calculate_supersedes_a_drag(live: MainWindow, steady: SteadyPlanner, qtbot: QtBot) -> None:
    steady.seconds = 0.2
    live.chart.time_bar.departure_slider.setValue(50)
    qtbot.waitUntil(lambda: len(steady.requests) == 1)
    with qtbot.waitSignal(live.settled, timeout=20_000):
        live.calculate()
    assert live.state.phase is Phase.ROUTE
    assert not live.steering.router.is_busy
    assert steady.roughs == [True, False]


def test_the_slider_keeps_its_place_under_way(live: MainWindow, qtbot: QtBot) -> None:
    bar = live.chart.time_bar
    bar.slider.setValue(600)
    bar.departure_slider.setValue(60)
    settle(live, qtbot)
    assert bar.slider.value() == 600
    assert bar.moment == DEPARTURE + timedelta(minutes=10 * (60 - 36) + 600)


def test_closing_while_dragging(live: MainWindow, steady: SteadyPlanner, qtbot: QtBot) -> None:
    steady.seconds = 5.0
    live.chart.time_bar.departure_slider.setValue(50)
    qtbot.waitUntil(lambda: len(steady.requests) == 1)
    live.close()
    assert not [t for t in threading.enumerate() if t.name.startswith("live-")]


def test_dragging_does_not_hold_the_window_up(live: MainWindow, steady: SteadyPlanner, qtbot: QtBot) -> None:
    slider, worst = live.chart.time_bar.departure_slider, []
    for layer in ("field", "nights"):
        live.menus.layers[layer].setChecked(True)
    for attempt in range(3):
        with Heart() as heart:
            for step in range(15):
                slider.setValue(20 + 20 * attempt + step)
                qtbot.wait(15)
            settle(live, qtbot)
        worst.append(heart.worst_s)
    assert min(worst) < Heart.LIMIT_S, f"blocked for {[f'{1000 * w:.0f} ms' for w in worst]}"


def test_what_nobody_reads_while_a_hand_moves_is_told_at_rest(
    live: MainWindow, steady: SteadyPlanner, qtbot: QtBot
) -> None:
    rested: list[Answer] = []
    live.steering.router.rested.connect(rested.append)
    slider = live.chart.time_bar.departure_slider
    for step in range(8):
        slider.setValue(40 + step)
        qtbot.wait(15)
        assert not rested
    settle(live, qtbot)
    assert [answer.rough for answer in rested] == [False]
    assert rested[0] is live.state.answer
