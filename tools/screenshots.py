"""Pictures of the window: the one in the README, and a gallery of every state it can be in.

``python tools/screenshots.py`` writes ``docs/images/window.png``; with a FOLDER it writes the gallery
there, ``1280x800/*.png`` and ``1920x1080/*.png``, to be looked at and not kept. Passages are really
computed; only what cannot be had on demand, a spent quota or a network that is down, is put in the place
of the weather service.
"""

from __future__ import annotations

import os
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, NoReturn

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtCore import QEventLoop, QTimer
from PySide6.QtWidgets import QApplication

from seacruise.desktop.compute import Fetcher, Question, fetch_wind
from seacruise.desktop.state import Phase
from seacruise.desktop.style import apply_style
from seacruise.desktop.window import MainWindow
from seacruise.errors import NoPassageError, SeaCruiseError, WeatherError
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.weather.wind import Wind

SIZES = ((1280, 800), (1920, 1080))
PASSAGE: dict[str, Any] = {
    "start": "Gdynia",
    "end": "Stockholm",
    "depart": datetime(2016, 11, 20, 6, tzinfo=UTC),
    "yacht": "Bavaria 46 Cruiser",
    "forecast": ("sample",),
}
TROUBLES: tuple[SeaCruiseError, ...] = (
    WeatherError(
        "api.stormglass.io cannot be reached; check the connection and try again.", reason="no-network"
    ),
    WeatherError("Storm Glass did not answer within 30 s; try again later.", reason="timeout"),
    WeatherError("Storm Glass needs a key: set STORMGLASS_API_KEY.", reason="no-key"),
    WeatherError("Storm Glass refused the key (401); check STORMGLASS_API_KEY.", reason="bad-key"),
    WeatherError(
        "Storm Glass has 0 requests left today and this passage needs 12; nothing was sent.", reason="quota"
    ),
    WeatherError("The answer of Storm Glass has no wind for 3 of 12 points.", reason="bad-response"),
    NoPassageError(
        "She is becalmed near 56°10.0'N 017°40.0'E from Mon 21 Nov 04:00 UTC on.",
        reason="becalmed",
        place=(56.17, 17.67),
    ),
    NoPassageError(
        "There is no way by water from Gdynia to Stockholm.", reason="no-water-path", place=(59.3, 18.9)
    ),
    NoPassageError(
        "More than 20 kn of wind everywhere east of Öland.", reason="wind-limit", place=(56.6, 17.3)
    ),
    NoPassageError("The wind is dead ahead and tacking is not allowed.", reason="dead-angle"),
    NoPassageError("The forecast ends before she could leave.", reason="outside-forecast"),
)


def wait(condition: Callable[[], bool], seconds: float = 60.0) -> None:
    """Let the window live until something is so."""
    loop, begun = QEventLoop(), time.monotonic()
    timer = QTimer()
    timer.timeout.connect(lambda: loop.quit() if condition() or time.monotonic() - begun > seconds else None)
    timer.start(20)
    loop.exec()
    if not condition():
        raise SystemExit("The window did not get there; see its log.")


def make_window(size: tuple[int, int], settings: Settings, fetcher: Fetcher = fetch_wind) -> MainWindow:
    """Window with the form filled in, everything loaded, the chart complete."""
    window = MainWindow(settings, fetcher=fetcher)
    window.resize(*size)
    ready: list[bool] = []
    window.ready.connect(lambda: ready.append(True))
    window.fill(PASSAGE)
    window.show()
    window.load(warm_up=False)
    wait(lambda: bool(ready) and window.chart.view.is_settled)
    return window


def save(window: MainWindow, path: Path) -> None:
    """Take the picture once the chart is complete."""
    wait(lambda: window.chart.view.is_settled)
    path.parent.mkdir(parents=True, exist_ok=True)
    window.grab().save(str(path))
    print(path)


def calculate(window: MainWindow) -> None:
    """Calculate to the end."""
    window.calculate()
    wait(lambda: window.state.phase is not Phase.COMPUTING)


def picture_of_route(size: tuple[int, int], settings: Settings, folder: Path) -> None:
    """Empty window, computing, route, its details."""
    gate = threading.Event()

    def fetch_slowly(question: Question, where: Settings, job: Job) -> Wind:
        if not gate.is_set():
            job.report("sea", 1.0, "Sea ready")
            job.report("wind", 3 / 9, "wind 3 of 9")
            time.sleep(0.3)
            gate.wait(30)
        return fetch_wind(question, where, job)

    window = make_window(size, settings, fetch_slowly)
    save(window, folder / "empty.png")
    window.calculate()
    wait(lambda: window.state.progress.stage == "wind")
    save(window, folder / "computing.png")
    gate.set()
    wait(lambda: window.state.phase is Phase.ROUTE, 180)
    wait(lambda: window.chart.view.is_settled)
    window.chart.time_bar.slider.setValue(15 * 60)
    save(window, folder / "route.png")
    window.legs.choose_leg(4)
    window.menus.layers["lattice"].setChecked(True)
    save(window, folder / "lattice.png")
    window.menus.layers["lattice"].setChecked(False)
    pictures_of_layers(window, folder)
    for _ in range(3):
        window.chart.view.zoom_in()
    window.form.show_options(shown=True)
    save(window, folder / "zoomed.png")
    window.form.fill({"depart": datetime(2026, 12, 25, 6, tzinfo=UTC)})
    calculate(window)
    save(window, folder / "departure.png")
    window.show_about()
    dialog = QApplication.activeModalWidget()
    if dialog is not None:
        dialog.grab().save(str(folder / "about.png"))
        dialog.close()
    window.close()


def pictures_of_layers(window: MainWindow, folder: Path) -> None:
    """Everything on the chart at once, in each light and with each meaning of the route's colours."""
    layers, menus, view = window.layers, window.menus, window.chart.view
    for name in ("field", "isochrones"):
        menus.layers[name].setChecked(True)
    window.steering.avoided.add(56.8, 18.4, 10.0)
    wait(lambda: not window.steering.router.is_busy)
    for scheme, light in (("tws", "day"), ("twa", "dusk"), ("point", "night"), ("speed", "day")):
        menus.choose("scheme", scheme)
        menus.choose("light", light)
        wait(lambda: not layers.jobs.is_running)
        save(window, folder / f"layers-{light}-{scheme}.png")
    for name in ("field", "isochrones"):
        menus.layers[name].setChecked(False)
    middle = view.middle()
    view.measure_from(*middle)
    view.measure.reach(middle[0] + 1.0, middle[1] + 1.0)
    view.end_picked.emit("via", middle[0] + 0.4, middle[1] + 0.6)
    wait(lambda: not window.steering.router.is_busy)
    save(window, folder / "via-and-measure.png")
    view.set_measuring(False)
    view.via_dropped.emit()
    window.steering.avoided.stack.undo()
    wait(lambda: not window.steering.router.is_busy)


def picture_of_trouble(error: SeaCruiseError, size: tuple[int, int], settings: Settings, path: Path) -> None:
    """Window after a calculation that failed."""

    def fail(*_: object) -> NoReturn:
        raise error

    window = make_window(size, settings, fail)
    calculate(window)
    if isinstance(error, NoPassageError) and error.place is not None:
        window.chart.view.show_place(*error.place)
    save(window, path)
    window.close()


def picture_for_readme(settings: Settings, path: Path) -> None:
    """Window with a passage, fifteen hours under way."""
    window = make_window(SIZES[0], settings)
    calculate(window)
    window.menus.layers["isochrones"].setChecked(True)
    wait(lambda: window.chart.view.is_settled and not window.layers.jobs.is_running)
    window.chart.time_bar.slider.setValue(15 * 60)
    save(window, path)
    window.close()


def main(gallery: Path | None) -> None:
    """Make the picture of the README, or all of the gallery."""
    app = QApplication([])
    apply_style(app)
    with tempfile.TemporaryDirectory() as home:
        settings = Settings(cache_dir=Path(home) / "cache", data_dir=Path(home) / "data")
        if gallery is None:
            picture_for_readme(settings, Path("docs/images/window.png"))
            return
        for size in SIZES:
            folder = gallery / f"{size[0]}x{size[1]}"
            picture_of_route(size, settings, folder)
            for error in TROUBLES:
                picture_of_trouble(error, size, settings, folder / f"{error.reason}.png")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else None)
