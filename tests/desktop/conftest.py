"""A window with a planner that a test holds in its hand."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from datetime import UTC, datetime
from itertools import pairwise
from typing import Any

import pytest
import shiboken6
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QLabel
from pytestqt.qtbot import QtBot

from seacruise.desktop.chart.view import ChartView
from seacruise.desktop.compute import Answer, Question
from seacruise.desktop.memory import WindowMemory
from seacruise.desktop.style import apply_style
from seacruise.desktop.window import MainWindow
from seacruise.passage import Passage, PassageRequest
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.weather.wind import Wind
from tests.passages import hand_made_passage, veering_wind

ASK: dict[str, Any] = {
    "start": "Gdynia",
    "end": "Sandhamn",
    "depart": datetime(2016, 11, 20, 6, tzinfo=UTC),
    "yacht": "Bavaria 46 Cruiser",
    "forecast": ("sample",),
}


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if "tests/desktop" in item.path.as_posix():
            # The platform that draws in memory has no window manager to ask for sizes, order or the keyboard.
            item.add_marker(pytest.mark.qt_log_ignore("This plugin does not support"))


class HeldPlanner:
    """Waits until the test lets it go, as a real one does until it has found something."""

    def __init__(self) -> None:
        self.gate = threading.Event()
        self.begun = threading.Event()
        self.requests: list[PassageRequest] = []
        self.cancelled = 0
        self.error: Exception | None = None

    def __call__(self, request: PassageRequest, *, settings: Settings, job: Job) -> Passage:
        self.requests.append(request)
        job.report("search", 0.5, "half of the vertices settled")
        self.begun.set()
        while not self.gate.wait(0.005):
            if job.cancel.is_set():
                self.cancelled += 1
            job.check()
        if self.error is not None:
            raise self.error
        return hand_made_passage()


def fetch_at_once(question: Question, settings: Settings, job: Job) -> Wind:
    job.report("wind", 1.0, "wind 1 of 1")
    return veering_wind()


@pytest.fixture
def app(qapp: QApplication) -> QApplication:
    apply_style(qapp)
    return qapp


@pytest.fixture
def planner() -> HeldPlanner:
    return HeldPlanner()


@pytest.fixture
def make_window(
    app: QApplication, qtbot: QtBot, settings: Settings, planner: HeldPlanner
) -> Iterator[Callable[..., MainWindow]]:
    windows = []

    def make(*, memory: WindowMemory | None = None, fill: bool = True) -> MainWindow:
        window = MainWindow(settings, planner=planner, fetcher=fetch_at_once, memory=memory)
        windows.append(window)
        if fill:
            window.fill(ASK)
        with qtbot.waitSignal(window.ready, timeout=20_000):
            window.show()
            window.load(warm_up=False)
        return window

    yield make
    planner.gate.set()
    for window in filter(shiboken6.isValid, windows):
        window.close()
        window.deleteLater()


@pytest.fixture
def window(make_window: Callable[..., MainWindow]) -> MainWindow:
    return make_window()


@pytest.fixture
def answered(window: MainWindow, planner: HeldPlanner, qtbot: QtBot) -> MainWindow:
    """A window with a passage."""
    planner.gate.set()
    with qtbot.waitSignal(window.settled, timeout=20_000):
        window.calculate()
    planner.gate.clear()
    return window


@pytest.fixture
def view(app: QApplication, qtbot: QtBot) -> Iterator[ChartView]:
    """A chart of its own."""
    view = ChartView()
    qtbot.addWidget(view)
    view.resize(800, 600)
    view.show()
    yield view
    view.painter_jobs.shut_down()


@pytest.fixture
def answer(view: ChartView) -> Answer:
    """A passage that the chart shows."""
    question: Question = None  # type: ignore[assignment]  # the chart does not look at it
    answer = Answer(hand_made_passage(), veering_wind(), question)
    view.show_answer(answer)
    view.fit_passage(answer)
    return answer


def settle(view: ChartView, qtbot: QtBot) -> None:
    """Wait until the picture of a chart is complete."""
    qtbot.waitUntil(lambda: view.is_settled, timeout=30_000)


class Heart:
    """Beats every 5 ms on the window's thread, and finds its longest pause.

    A pause counts by the clock or by what that thread itself did on its processor, whichever is less: while
    other programs have the machine, nobody here holds the window up.
    """

    LIMIT_S = 0.050

    def __init__(self) -> None:
        self.beats: list[tuple[float, float]] = []
        self._timer = QTimer()
        self._timer.timeout.connect(self._beat)

    def _beat(self) -> None:
        self.beats.append((time.perf_counter(), time.thread_time()))

    def __enter__(self) -> Heart:
        self._beat()
        self._timer.start(5)
        return self

    def __exit__(self, *_: object) -> None:
        self._timer.stop()
        self._beat()

    @property
    def worst_s(self) -> float:
        """Longest pause [s]."""
        return max(min(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(self.beats))


def texts_of(window: MainWindow) -> str:
    """Everything that the side panel says."""
    QApplication.processEvents()
    return "\n".join(label.text() for label in window.side.findChildren(QLabel) if label.isVisible())
