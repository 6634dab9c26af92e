"""An hour of use in a few minutes: memory, growth, and the longest time the window did not answer.

``python -m benchmarks.soak [--minutes M | --hours H] [--seed S]`` drives the real window with real passages:
drags, pans, zooms, plays, changes light and yacht, opens and closes pages, saves passages and opens them,
in an order that a seed decides. Progress goes to standard error, one JSON object to standard output.

Memory is sampled at rest: nothing is computed, and the window has given back what it can, of its own accord.
What it takes while searches run is told apart, as the greatest of all.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import statistics
import sys
import time
from collections.abc import Callable, Sequence
from typing import Any, Final

from PySide6.QtCore import QEventLoop, QObject, QPointF, QTimer
from PySide6.QtWidgets import QApplication, QWidget

from benchmarks.frames import PASSAGE, wait
from benchmarks.measure import Figures, Pace, run_process, say, within
from benchmarks.memory import forget_peak, own_mb, parts, peak_mb, rss_mb
from benchmarks.world import home
from seacruise.desktop.app import SWITCH_S
from seacruise.desktop.state import Phase
from seacruise.desktop.style import apply_style
from seacruise.desktop.thrift import import_qt_plainly
from seacruise.desktop.window import MainWindow
from seacruise.settings import Settings

MINUTES: Final = 3.0
MEMORY_MB: Final = 400.0
BLOCKED_MS: Final = 50.0
SAMPLES: Final = 40
SAMPLES_APART_S: Final = 15.0
SETTLED: Final = 0.3
"""Share of the time after which growth is reckoned: until then caches fill."""

REST_S: Final = 120.0
"""How long at the most a sample waits for the window to come to rest [s]."""

SIZE: Final = (1440, 900)
LIGHTS: Final = ("dusk", "night", "day")
SCHEMES: Final = ("twa", "speed", "tws")


class Heart(QObject):
    """Beats every 5 ms on the window's thread and keeps its longest pauses."""

    def __init__(self) -> None:
        super().__init__()
        self.doing = ""
        self.pauses: list[tuple[float, float, str]] = []
        self._last = (time.perf_counter(), time.thread_time())
        timer = QTimer(self)
        timer.timeout.connect(self._beat)
        timer.start(5)

    def _beat(self) -> None:
        now = (time.perf_counter(), time.thread_time())
        # On a machine that others use, only what this thread itself did is its fault.
        own, clock = now[1] - self._last[1], now[0] - self._last[0]
        self._last = now
        self.pauses = sorted([*self.pauses, (min(own, clock), clock, self.doing)], reverse=True)[:12]


class Sailor:
    """What is done to the window; each action leaves it as another may find it."""

    def __init__(self, window: MainWindow, seed: int) -> None:
        self._window = window
        self._random = random.Random(seed)  # noqa: S311 - the same order each time
        self._turn = 0

    def actions(self) -> dict[str, tuple[int, Callable[[], None]]]:
        """Name the actions, with how often each is done in proportion."""
        return {
            "pan": (8, self.pan),
            "zoom": (6, self.zoom),
            "departure": (8, self.departure),
            "end": (4, self.end),
            "play": (3, self.play),
            "yacht": (2, self.yacht),
            "light": (2, self.light),
            "layers": (2, self.layers),
            "pages": (2, self.pages),
            "dialogs": (2, self.dialogs),
            "passages": (2, self.passages),
            "calculate": (1, self.calculate),
            "think": (3, self.think),
        }

    def _live(self, ms: int) -> None:
        loop = QEventLoop()
        QTimer.singleShot(ms, loop.quit)
        loop.exec()

    def _rest(self) -> None:
        window = self._window
        wait(lambda: not window.steering.router.is_busy and window.state.phase is not Phase.COMPUTING, 60.0)

    def pan(self) -> None:
        """Move the chart for a while."""
        dx, dy = self._random.uniform(-14, 14), self._random.uniform(-14, 14)
        for _ in range(20):
            self._window.chart.view.pan(dx, dy)
            self._live(12)

    def zoom(self) -> None:
        """Zoom in or out by some steps of the wheel, and to the whole passage now and then."""
        view = self._window.chart.view
        factor = self._random.choice((1.25, 1.25, 0.8, 0.8))
        for _ in range(self._random.randint(1, 5)):
            view.zoom(factor, QPointF(view.width() * self._random.random(), view.height() * 0.5))
            self._live(20)
        if self._random.random() < 0.4:
            self._window.chart.fit_button.click()

    def departure(self) -> None:
        """Drag the departure."""
        slider = self._window.chart.time_bar.departure_slider
        slider.setValue(self._random.randint(0, 40))
        for _ in range(15):
            slider.setValue(slider.value() + 1)
            self._live(16)
        slider.sliderReleased.emit()
        self._rest()

    def end(self) -> None:
        """Drag an end about, or the place to sail by way of."""
        view, form = self._window.chart.view, self._window.form
        which = self._random.choice(("from", "to", "via"))
        if which == "via":
            view.end_picked.emit("via", 56.9 + self._random.random(), 18.9 + self._random.random())
            self._rest()
            view.via_dropped.emit()
        else:
            port = form.ends[which]
            for step in range(8):
                moved = type(port)("", "", port.lat - 0.002 * step, port.lon + 0.01 * step)
                view.end_dragged.emit(which, moved, False)
                self._live(16)
            view.end_dragged.emit(which, port, True)
        self._rest()

    def play(self) -> None:
        """Let time run under way."""
        button = self._window.chart.time_bar.play_button
        button.setChecked(True)
        self._live(600)
        button.setChecked(False)

    def yacht(self) -> None:
        """Choose another yacht."""
        box = self._window.form.yacht_box
        box.setCurrentIndex(self._random.randrange(box.count()))
        self._rest()
        self._window.fill({"yacht": PASSAGE["yacht"]})
        self._rest()

    def light(self) -> None:
        """Change the light, and the meaning of the route's colours."""
        self._turn += 1
        self._window.menus.choose("light", LIGHTS[self._turn % len(LIGHTS)])
        self._window.menus.choose("scheme", SCHEMES[self._turn % len(SCHEMES)])
        self._live(250)

    def layers(self) -> None:
        """Switch layers on and off."""
        for name in ("field", "isochrones", "lattice"):
            action = self._window.menus.layers[name]
            action.setChecked(not action.isChecked())
            self._live(60)
        self._window.menus.layers["lattice"].setChecked(False)

    def pages(self) -> None:
        """Open when to go or where to go, let it compute, and leave it."""
        planning = self._window.planning
        page = self._random.choice((planning.departures, planning.reach))
        planning.frame.open_page(page)
        self._live(100)
        page.start()
        self._live(900)
        page.cancel()
        planning.frame.close_pages()
        self._live(60)

    def dialogs(self) -> None:
        """Open the weather or the yachts, and close it."""
        desk = self._window.desk
        show = self._random.choice((desk.show_weather, desk.show_yachts))
        show()
        self._live(400)
        for widget in QApplication.topLevelWidgets():
            if widget.isVisible() and widget is not self._window:
                widget.close()
        self._live(30)

    def passages(self) -> None:
        """Save the passage, open it again, and delete it."""
        desk = self._window.desk
        desk.save()
        page = desk.passages
        wait(lambda: not page.is_busy, 20.0)
        desk.show_passages()
        wait(lambda: not page.is_busy, 20.0)
        self._live(60)
        for do in (page.open, page.delete):
            do()
            wait(lambda: not page.is_busy, 20.0)
            self._live(40)
        page.window().close()
        self.calculate()

    def think(self) -> None:
        """Look at what is there."""
        self._live(2500)

    def calculate(self) -> None:
        """Calculate what the form of the beginning asks."""
        self._window.fill(PASSAGE)
        self._window.calculate()
        self._rest()


def open_window() -> MainWindow:
    """Window with a passage, most layers shown."""
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
    for name in ("field", "isochrones"):
        window.menus.layers[name].setChecked(True)
    window.garbage.settle()
    return window


def use(window: MainWindow, minutes: float, seed: int) -> Figures:
    """Use the window, and tell what became of it."""
    sailor, heart = Sailor(window, seed), Heart()
    actions = sailor.actions()
    names = [name for name, (times, _) in actions.items() for _ in range(times)]
    chooser = random.Random(seed)  # noqa: S311 - the same order each time
    for name in actions:
        heart.doing = name
        actions[name][1]()
    heart.pauses = []
    samples, begun = [_sample(window, 0, 0.0)], time.perf_counter()
    forget_peak()
    done, apart = 0, max(SAMPLES_APART_S, 60.0 * minutes / SAMPLES)
    while (now := time.perf_counter() - begun) < 60.0 * minutes:
        heart.doing = chooser.choice(names)
        actions[heart.doing][1]()
        done += 1
        if now > len(samples) * apart:
            heart.doing = "rest"
            samples.append(_sample(window, done, now))
    samples.append(_sample(window, done, time.perf_counter() - begun))
    return _told(samples, heart) | {"parts": parts(), "minutes": minutes, "seed": seed}


def _sample(window: MainWindow, done: int, seconds: float) -> Figures:
    """Look at the memory when the window has come to rest."""
    wait(lambda: window.garbage.is_at_rest and window.chart.view.is_settled, REST_S)
    found = {
        "seconds": round(seconds, 1),
        "actions": done,
        "rss_mb": round(rss_mb(), 1),
        "own_mb": own_mb(),
        "widgets": len(QApplication.allWidgets()),
        "blocks": sys.getallocatedblocks(),
    }
    say("soak: " + ", ".join(f"{name} {value}" for name, value in found.items()))
    return found


def _ends(samples: Sequence[Figures]) -> dict[str, Figures]:
    return {"first": samples[0], "last": samples[-1]}


def _told(samples: Sequence[Figures], heart: Heart) -> Figures:
    settled = [s for s in samples if s["seconds"] >= SETTLED * samples[-1]["seconds"]]
    own, clock, doing = heart.pauses[0]

    def growth(key: str) -> float:
        slope = statistics.linear_regression(
            [float(s["actions"]) for s in settled], [float(s[key]) for s in settled]
        ).slope
        return round(1000.0 * slope, 1)

    most: Figures = {"rss_mb": max(s["rss_mb"] for s in samples)}
    blocked: Figures = {"blocked_ms": round(1e3 * own, 1)}
    known = [key for key in ("rss_mb", "own_mb", "widgets", "blocks") if samples[0][key] is not None]
    return {
        "actions": samples[-1]["actions"],
        "peak_mb": round(peak_mb(), 1),
        "at_rest": most | within(most, "rss_mb", MEMORY_MB),
        **{f"{when}_{key}": at[key] for when, at in _ends(samples).items() for key in ("rss_mb", "own_mb")},
        **{f"growth_{key}_per_1000": growth(key) for key in known},
        "samples": [{key: s[key] for key in ("seconds", "actions", *known)} for s in samples],
        "worst": blocked | within(blocked, "blocked_ms", BLOCKED_MS) | {"while": doing},
        "worst_by_clock_ms": round(1e3 * max(clock, *(pause[1] for pause in heart.pauses)), 1),
        "pauses": [
            {"own_ms": round(1e3 * o, 1), "clock_ms": round(1e3 * c, 1), "while": w}
            for o, c, w in heart.pauses
        ],
    }


def soak(pace: Pace) -> Figures:
    """Use the window in a process of its own for some minutes."""
    environment = {
        "SEACRUISE_HOME": home(),
        "QT_QPA_PLATFORM": os.environ.get("QT_QPA_PLATFORM", "offscreen"),
    }
    minutes = 0.2 if pace.quick else MINUTES
    say(f"soak: {minutes:g} minutes")
    sailed = run_process(
        (sys.executable, "-m", "benchmarks.soak", "--minutes", str(minutes)), environment=environment
    )
    if sailed.code:
        last = (sailed.said.strip() or f"exit code {sailed.code}").splitlines()[-1]
        return {"outcome": f"The window did not last: {last}"}
    figures: Figures = json.loads(sailed.output)
    return figures


def main(arguments: Sequence[str]) -> int:
    """Run the script and print its figures."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.soak", description=__doc__)
    parser.add_argument("--minutes", type=float, default=MINUTES)
    parser.add_argument("--hours", type=float, help="instead of minutes")
    parser.add_argument("--seed", type=int, default=1)
    said = parser.parse_args(arguments)
    import_qt_plainly()
    sys.setswitchinterval(SWITCH_S)
    app: Any = QApplication([])
    apply_style(app)
    window: QWidget = open_window()
    assert isinstance(window, MainWindow)
    report = use(window, 60.0 * said.hours if said.hours else said.minutes, said.seed)
    print(json.dumps(report), flush=True)
    window.close()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
