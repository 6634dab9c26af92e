"""From a move of the mouse to another passage on the chart; see `benchmarks.window`.

Prints one JSON object. Mouse events are sent to the window sixty times a second, as a hand sends them, and
passages are really planned. What is timed is the way of one move: from its event until the chart with the
passage that answers it has been painted. Moves that were overtaken before they were begun have no passage.
Afterwards some of the same questions are searched precisely, to tell how far off they were.
"""

from __future__ import annotations

import json
import statistics
import sys
import time
from collections.abc import Callable
from typing import Any, Final

from PySide6.QtCore import QEventLoop, QPoint, QPointF, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QStyle, QStyleOptionSlider

from benchmarks.frames import open_chart, wait
from benchmarks.measure import Figures
from benchmarks.world import home
from seacruise.desktop.app import SWITCH_S
from seacruise.desktop.chart.plane import point
from seacruise.desktop.compute import Answer, Question, replan
from seacruise.desktop.style import apply_style
from seacruise.desktop.window import MainWindow
from seacruise.errors import NoPassageError
from seacruise.ports import Port
from seacruise.progress import Job
from seacruise.settings import Settings

EVERY_MS: Final = 16
PASSAGES: Final = (("Visby", "Ronne"), ("Karlskrona", "Swinoujscie"), ("Gdynia", "Stockholm"))
COMPARED: Final = 16
"""Passages of a drag that are searched precisely afterwards."""

THOUSANDTH: Final = 1e-3
LEFT: Final = Qt.MouseButton.LeftButton


class Watch:
    """Notes when each move was made, and when the passage that answers it was painted."""

    def __init__(self, window: MainWindow) -> None:
        self._window, self._router = window, window.steering.router
        self._moved = 0.0
        self._asked: dict[int, tuple[float, Question]] = {}
        self.shown: list[tuple[float, Answer]] = []
        ask = self._router.ask

        def watched(question: Question, known: Answer) -> None:
            # The question is kept: another one must not get its number.
            self._asked[id(question)] = (self._moved, question)
            ask(question, known)

        self._router.ask = watched  # type: ignore[method-assign]
        self._router.routed.connect(self._painted)

    def _painted(self, answer: Answer) -> None:
        self._window.chart.view.viewport().repaint()
        moved, _ = self._asked.get(id(answer.question), (self._moved, None))
        self.shown.append((time.perf_counter() - moved, answer))

    def move(self, by: Callable[[int], None], moves: int) -> Figures:
        """Make some moves and tell what came of them while the hand moved."""
        self.shown.clear()
        loop, begun, own = QEventLoop(), time.perf_counter(), time.thread_time()
        for number in range(moves):
            self._moved = time.perf_counter()
            by(number)
            QTimer.singleShot(EVERY_MS, loop.quit)
            loop.exec()
        took, own = time.perf_counter() - begun, time.thread_time() - own
        moving = list(self.shown)
        if not moving:
            return {"moves": moves, "passages_shown": 0}
        waited = sorted(seconds for seconds, _ in moving)
        rest(self._window)
        return {
            "median_ms": round(1e3 * statistics.median(waited), 1),
            "worst_ms": round(1e3 * waited[-1], 1),
            **_off([answer for _, answer in moving]),
            "passages_per_s": round(len(moving) / took, 1),
            "own_share": round(own / took, 2),
            "moves": moves,
        }


def _off(shown: list[Answer]) -> Figures:
    """Tell by how much longer the passages shown while the hand moved take than those searched precisely."""
    settings = Settings.from_environment({"SEACRUISE_HOME": home()})
    off = []
    for answer in shown[:: max(1, len(shown) // COMPARED)]:
        try:
            precise = replan(answer.question, answer, settings=settings, job=Job())
        except NoPassageError:
            continue
        off.append(answer.passage.duration_h / precise.passage.duration_h - 1.0)
    if not off:
        return {}
    return {
        "off_median_percent": round(100 * statistics.median(off), 3),
        "off_worst_percent": round(100 * max(off), 3),
        "within_a_thousandth_share": round(sum(one <= THOUSANDTH for one in off) / len(off), 2),
    }


def rest(window: MainWindow) -> None:
    """Wait until the hand's last wish is answered."""
    wait(lambda: not window.steering.router.is_busy)


def by_slider(window: MainWindow, watch: Watch, moves: int) -> Figures:
    """Drag the departure's slider by its handle, to and fro."""
    slider = window.chart.time_bar.departure_slider
    option = QStyleOptionSlider()
    slider.initStyleOption(option)
    handle = slider.style().subControlRect(
        QStyle.ComplexControl.CC_Slider, option, QStyle.SubControl.SC_SliderHandle, slider
    )
    at = handle.center()
    QTest.mousePress(slider, LEFT, pos=at)
    figures = watch.move(lambda n: QTest.mouseMove(slider, at + QPoint(_to_and_fro(n, 90), 0)), moves)
    QTest.mouseRelease(slider, LEFT, pos=at)
    rest(window)
    return figures


def on_chart(window: MainWindow, watch: Watch, place: Port, moves: int) -> Figures:
    """Drag an end, or the place to sail by, on the chart."""
    view = window.chart.view
    port = view.viewport()
    at = view.viewportTransform().map(point(place.lat, place.lon)).toPoint()
    QTest.mousePress(port, LEFT, pos=at)
    figures = watch.move(lambda n: QTest.mouseMove(port, at + QPoint(_to_and_fro(n, 30), -(n % 7))), moves)
    QTest.mouseRelease(port, LEFT, pos=at + QPoint(3, 9))
    rest(window)
    return figures


def _to_and_fro(number: int, far: int) -> int:
    lap = number % (2 * far)
    return 1 + (lap if lap < far else 2 * far - lap)


def by_passage(window: MainWindow, watch: Watch, names: tuple[str, str], moves: int) -> Figures:
    """Drag departure, start and a place on the way of one passage."""
    view, form = window.chart.view, window.form
    window.fill({"start": names[0], "end": names[1]})
    settled: list[Any] = []
    window.settled.connect(settled.append)
    window.calculate()
    wait(lambda: bool(settled))
    window.settled.disconnect(settled.append)
    if window.state.error is not None:
        raise SystemExit(str(window.state.error))
    wait(lambda: view.is_settled and not window.layers.jobs.is_running)
    report = {
        "departure": by_slider(window, watch, moves),
        "start": on_chart(window, watch, form.ends["from"], moves),
    }
    ends = [view.viewportTransform().map(point(p.lat, p.lon)) for p in form.ends.values()]
    middle = view.position_at(QPointF((ends[0] + ends[1]) / 2.0))
    view.end_picked.emit("via", *middle)
    rest(window)
    via = window.steering.via
    if via is not None and window.state.error is None:
        report["via"] = on_chart(window, watch, via, moves)
    view.via_dropped.emit()
    rest(window)
    return report


def main(moves: int) -> int:
    """Run the script and print its figures."""
    sys.setswitchinterval(SWITCH_S)
    app = QApplication([])
    apply_style(app)
    window = open_chart()
    watch = Watch(window)
    # Kernels and lattices are made at the first wish of each kind; that is no drag.
    by_passage(window, watch, PASSAGES[0], 10)
    print(
        json.dumps({"-".join(names): by_passage(window, watch, names, moves) for names in PASSAGES}),
        flush=True,
    )
    window.close()
    return 0


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 120))
