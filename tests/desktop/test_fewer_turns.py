"""Passages with fewer turns: found beside the window, told, adopted, and taken back."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise.desktop.alternatives import Way, find_fewer_turns
from seacruise.desktop.compute import Answer, Question
from seacruise.desktop.window import MainWindow
from seacruise.passage import Passage, PassageRequest
from seacruise.progress import Job
from seacruise.settings import Settings
from tests.desktop.conftest import HeldPlanner
from tests.desktop.test_alternatives import eastward, question_by
from tests.passages import veering_wind

CALMER = Way("", "", 51.0, 1.25, np.array([[54.6, 18.9], [59.3, 18.9]]), (57.0, 18.9), None, None, 3, 16, 3)


def plan_with_turns(request: PassageRequest, *, settings: Settings, job: Job) -> Passage:
    """Make passages with 16 turns, with 8, or with 3, which takes more than an hour more."""
    del settings, job
    most = request.options.most_turns
    turns, hours = (16, 0.0) if most is None or most >= 16 else (8, 0.5) if most >= 8 else (3, 1.25)
    return replace(eastward(0.0, hours), tacks=turns, gybes=0)


def asked(most: int | None, settings: Settings) -> Answer:
    question: Question = question_by(None)
    question = replace(question, options=replace(question.options, most_turns=most))
    request = PassageRequest(
        question.start, question.end, question.yacht, veering_wind(), None, question.options
    )
    passage = plan_with_turns(request, settings=settings, job=Job())
    return Answer(passage, veering_wind(), question)


def test_ways_with_fewer_turns(app: QApplication, settings: Settings) -> None:
    delivered: list[tuple[Way, ...]] = []
    said: list[str] = []
    job = Job(report=lambda _stage, _fraction, message: said.append(message))
    ways = find_fewer_turns(
        asked(None, settings),
        settings=settings,
        job=job,
        planner=plan_with_turns,
        deliver=delivered.append,
    )
    assert delivered == [ways[:1], ways], "each as soon as it is found"
    assert said[0] == "Looking for a passage with at most 8 tacks and gybes"
    assert [(way.turns, way.most_turns) for way in ways] == [(8, 8), (3, 3)]
    assert ways[1].text.endswith("+1 h 15 min")
    assert "3 turn" in ways[1].text
    assert "instead of 16:" in ways[1].text
    assert ways[1].label.startswith("3 turn")


def test_adopted_the_free_passage_is_one_of_the_others(app: QApplication, settings: Settings) -> None:
    ways = find_fewer_turns(asked(8, settings), settings=settings, job=Job(), planner=plan_with_turns)
    assert [(way.turns, way.most_turns) for way in ways] == [(3, 3), (16, None)]
    assert ways[1].more_h == pytest.approx(-0.5)


def most_turns(window: MainWindow) -> int | None:
    return window.form.sailing.options.most_turns


def test_fewer_turns_in_the_window_adopted_and_undone(
    answered: MainWindow, planner: HeldPlanner, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    window, view = answered, answered.chart.view
    planner.gate.set()
    monkeypatch.setattr(
        HeldPlanner, "__call__", lambda _self, request, **more: plan_with_turns(request, **more)
    )
    window.menus.layers["turns"].setChecked(True)
    qtbot.waitUntil(lambda: not window.layers.ways.turns.jobs.is_running)
    # The passage shown has two turns; this planner knows none with fewer.
    assert "no passage with fewer" in window.statusBar().currentMessage()
    assert not view.others.ways
    view.way_picked.emit(CALMER)
    assert most_turns(window) == 3
    assert "at most 3 tacks and gybes" in window.form.sailing.summary()
    qtbot.waitUntil(lambda: not window.steering.router.is_busy)
    qtbot.waitUntil(lambda: [way.most_turns for way in view.others.ways] == [None], timeout=10_000)
    assert "16 turn" in view.others.ways[0].text
    window.menus.ways.aboutToShow.emit()
    assert [action.text() for action in window.menus.ways.actions()] == [view.others.ways[0].text]
    window.history.note()
    window.history.stack.undo()
    assert most_turns(window) is None
    window.history.stack.redo()
    assert most_turns(window) == 3
    qtbot.waitUntil(lambda: not window.steering.router.is_busy)
    window.menus.layers["turns"].setChecked(False)
    assert not view.others.ways
    window.menus.ways.aboutToShow.emit()
    (empty,) = window.menus.ways.actions()
    assert not empty.isEnabled()
    assert "Fewer turns" in empty.text()


def test_adopted_where_nothing_follows_it_is_calculated(
    answered: MainWindow, planner: HeldPlanner, qtbot: QtBot
) -> None:
    window = answered
    window.menus.live.setChecked(False)
    planner.gate.set()
    with qtbot.waitSignal(window.settled, timeout=20_000):
        window.layers.ways.turns_picked.emit(2)
    assert planner.requests[-1].options.most_turns == 2
