"""Frames of the chart; see `benchmarks.window`.

Prints one JSON object. A frame is the whole of drawing the chart once, to memory, with coast, barbs, colour
field, isochrones, route and names; what moves it, and what the layers compute for it, is counted with it.
`beside` is what the same thread does between two frames: pictures for the next ones are painted there.
"""

from __future__ import annotations

import json
import math
import statistics
import sys
import time
from collections.abc import Callable
from datetime import UTC, datetime
from typing import Any, Final

from PySide6.QtCore import QEventLoop, QPointF, QTimer
from PySide6.QtWidgets import QApplication

from benchmarks.measure import Figures
from seacruise.desktop.app import SWITCH_S
from seacruise.desktop.state import Phase
from seacruise.desktop.style import apply_style
from seacruise.desktop.window import MainWindow
from seacruise.settings import Settings

SIZE: Final = (1920, 1080)
PASSAGE: Final[dict[str, Any]] = {
    "start": "Gdynia",
    "end": "Stockholm",
    "depart": datetime(2016, 11, 20, 6, tzinfo=UTC),
    "yacht": "Bavaria 46 Cruiser",
    "forecast": ("sample",),
}


def wait(condition: Callable[[], bool], seconds: float = 120.0) -> None:
    """Let the window live until something is so."""
    loop, begun = QEventLoop(), time.monotonic()
    timer = QTimer()
    timer.timeout.connect(lambda: loop.quit() if condition() or time.monotonic() - begun > seconds else None)
    timer.start(5)
    loop.exec()
    if not condition():
        raise SystemExit("The window did not get there.")


def open_chart() -> MainWindow:
    """Window with a passage, all layers but the lattice, the chart as large as the whole window."""
    window = MainWindow(Settings.from_environment())
    window.resize(*SIZE)
    ready: list[bool] = []
    window.ready.connect(lambda: ready.append(True))
    window.fill(PASSAGE)
    window.show()
    window.load(warm_up=False)
    wait(lambda: bool(ready))
    window.calculate()
    wait(lambda: window.state.phase is not Phase.COMPUTING)
    if window.state.error is not None:
        raise SystemExit(str(window.state.error))
    for name in ("field", "isochrones"):
        window.menus.layers[name].setChecked(True)
    # As large as a whole screen: what the panels take of it in the window would be frames made cheaper.
    window.chart.view.setParent(None)
    window.chart.view.resize(*SIZE)
    window.chart.view.show()
    wait(lambda: window.chart.view.is_settled and not window.layers.jobs.is_running)
    window.garbage.settle()
    return window


Frame = tuple[float, float, float]


def frames_of(window: MainWindow, frames: int, move: Callable[[int], None]) -> list[Frame]:
    """Give the seconds of each frame by the clock, of its thread's own, and of that thread until the next.

    Between two of them the window lives, as it does between a mouse's moves.
    """
    loop, seconds = QEventLoop(), []
    for number in range(frames):
        begun, own = time.perf_counter(), time.thread_time()
        move(number)
        window.chart.view.viewport().repaint()
        took, own = time.perf_counter() - begun, time.thread_time() - own
        beside = time.thread_time()
        QTimer.singleShot(8, loop.quit)
        loop.exec()
        seconds.append((took, own, time.thread_time() - beside))
    return seconds


def figures(frames: list[Frame]) -> Figures:
    """Median and worst of some frames [ms]; ``own`` is what is left when nobody else wants the machine."""
    seconds, own, beside = (sorted(column) for column in zip(*frames, strict=True))
    return {
        "median_ms": round(1e3 * statistics.median(seconds), 2),
        "p95_ms": round(1e3 * seconds[math.ceil(0.95 * len(seconds)) - 1], 2),
        "worst_ms": round(1e3 * seconds[-1], 2),
        "own_median_ms": round(1e3 * statistics.median(own), 2),
        "own_worst_ms": round(1e3 * own[-1], 2),
        "beside_mean_ms": round(1e3 * statistics.fmean(beside), 2),
        "frames": len(frames),
    }


def main(frames: int) -> int:
    """Run the script and print its figures."""
    sys.setswitchinterval(SWITCH_S)
    app = QApplication([])
    apply_style(app)
    window = open_chart()
    view, slider = window.chart.view, window.chart.time_bar.slider
    at = QPointF(0.4 * SIZE[0], 0.4 * SIZE[1])

    def pan(number: int) -> None:
        view.pan(9.0 * math.cos(number / 9), 9.0 * math.sin(number / 9))

    def zoom(number: int) -> None:
        view.zoom(1.04 if number % 40 < 20 else 1 / 1.04, at)

    def play(number: int) -> None:
        slider.setValue(6 * number % slider.maximum())

    scripts = {"pan": pan, "zoom": zoom, "play": play}
    for move in scripts.values():
        frames_of(window, 5, move)
    seconds = {name: frames_of(window, frames, move) for name, move in scripts.items()}
    report: Figures = {name: figures(times) for name, times in seconds.items()}
    report["all"] = figures([one for times in seconds.values() for one in times])
    print(json.dumps(report), flush=True)
    window.close()
    return 0


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 120))
