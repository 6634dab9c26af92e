"""The passages asked for lately: kept, told in a line, asked again with a click."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtWidgets import QApplication, QMenu
from pytestqt.qtbot import QtBot

from seacruise.desktop.memory import WindowMemory
from seacruise.desktop.recent import KEPT, RecentPassages, via_of
from seacruise.desktop.window import MainWindow
from seacruise.ports import Port
from tests.desktop.conftest import ASK, HeldPlanner


def question(number: int, **others: Any) -> dict[str, Any]:
    return {"start": "Gdynia", "end": f"Port {number}", "yacht": "Carter 30", "forecast": ["sample"]} | others


@pytest.fixture
def recent(app: QApplication, qtbot: QtBot) -> RecentPassages:
    menu = QMenu()
    qtbot.addWidget(menu)
    return RecentPassages(menu)


def titles(menu: QMenu) -> list[str]:
    return [action.text() for action in menu.actions() if action.text()]


@pytest.fixture
def menu_of(recent: RecentPassages) -> Callable[[], list[str]]:
    return lambda: titles(recent._menu)


def test_the_newest_is_first_and_ten_are_kept(recent: RecentPassages) -> None:
    for number in range(KEPT + 3):
        recent.note(question(number))
    assert [q["end"] for q in recent.questions] == [f"Port {n}" for n in range(12, 2, -1)]


def test_the_same_passage_at_another_time_takes_the_place_of_the_first(recent: RecentPassages) -> None:
    recent.note(question(1, depart="2016-11-20T06:00+00:00"))
    recent.note(question(2))
    recent.note(question(1, depart="2016-11-21T06:00+00:00", percent_of_polar=90.0))
    assert [q["end"] for q in recent.questions] == ["Port 1", "Port 2"]
    assert recent.questions[0]["percent_of_polar"] == 90.0
    recent.note(question(1), Port("Visby", "SE", 57.6, 18.3))
    assert len(recent.questions) == 3


def test_the_menu_says_what_was_asked(recent: RecentPassages, menu_of: Callable[[], list[str]]) -> None:
    assert menu_of()[0] == "None yet: what you calculate appears here"
    recent.note(question(1, depart="2016-11-20T06:00:00+00:00"), Port("A & B", "", 57.0, 18.0))
    assert menu_of()[0] == "&1 Gdynia – Port 1, via A && B, Carter 30, Sun 20 Nov 2016 06:00 UTC"
    recent.note(question(2, end="X" * 60))
    assert len(menu_of()[0]) < 80
    recent.clear()
    assert len(menu_of()) == 2
    assert not recent.questions


@pytest.mark.parametrize(
    "kept",
    [
        {},
        {"asked": 5},
        {"asked": [None, 5, {}, {"start": 1, "end": "x"}]},
        {"asked": [{"start": "", "end": " "}]},
    ],
)
def test_a_damaged_memory_is_passed_over(recent: RecentPassages, kept: dict[str, Any]) -> None:
    recent.restore(kept)
    assert recent.questions == []


@pytest.mark.parametrize("via", [None, 5, {}, {"lat": "x", "lon": 1}, {"lat": 91.0, "lon": 1.0}])
def test_a_damaged_place_is_none(via: object) -> None:
    assert via_of({"via": via}) is None


def test_asked_again_after_a_restart(
    make_window: Callable[..., MainWindow], planner: HeldPlanner, qtbot: QtBot, tmp_path: Path
) -> None:
    planner.gate.set()
    first = make_window(memory=WindowMemory(tmp_path))
    first.fill({"percent_of_polar": 85.0, "max_wind_kn": 28.0})
    first.steering.via = Port("Visby", "SE", 57.64, 18.28)
    with qtbot.waitSignal(first.settled, timeout=20_000):
        first.calculate()
    first.fill({"start": "Hel", "end": "Visby", "percent_of_polar": 100.0, "max_wind_kn": None})
    first.close()
    second = make_window(memory=WindowMemory(tmp_path), fill=False)
    assert second.form.start_field.text() == "Hel"
    asked = len(planner.requests)
    action = second.menus.recent.actions()[0]
    assert "Gdynia – Sandhamn, via Visby" in action.text()
    with qtbot.waitSignal(second.settled, timeout=20_000):
        action.trigger()
    request = planner.requests[asked]
    assert (request.start.name, request.end.name, request.departure) == ("Gdynia", "Visby", ASK["depart"])
    assert (request.options.percent_of_polar, request.options.max_wind_kn) == (85.0, 28.0)
    assert second.form.end_field.text() == "Sandhamn"
    assert second.steering.via is not None


def test_what_was_asked_is_kept_before_the_window_is_closed(
    make_window: Callable[..., MainWindow], planner: HeldPlanner, qtbot: QtBot, tmp_path: Path
) -> None:
    memory = WindowMemory(tmp_path)
    window = make_window(memory=memory)
    planner.gate.set()
    with qtbot.waitSignal(window.settled, timeout=20_000):
        window.calculate()
    memory.flush()
    lives = WindowMemory(tmp_path)
    assert lives.recall("form")["end"] == "Sandhamn"
    assert len(lives.recall("recent")["asked"]) == 1
