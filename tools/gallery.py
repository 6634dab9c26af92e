"""Pictures of the window: those of the documentation, and all others to be looked at.

    python tools/gallery.py                   # docs/images, docs/gallery.md; needs Xvfb and xdotool
    python tools/gallery.py FOLDER [SCENE ...] [--size 1024x700 ...] [--light night ...] [--language pl]

Passages are really computed; only what cannot be had on demand, a spent quota or a network that is down, is
put in the place of the weather service. The pictures of the first way come from the real program, driven by
mouse and keys (``tests/display``), in both languages, and from here; they are brought down to 256 colours.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import Any, NoReturn

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import numpy as np
from PySide6.QtCore import QEventLoop, QTimer
from PySide6.QtWidgets import QApplication, QScrollArea, QToolButton, QWidget

from seacruise.desktop.compute import Fetcher, Question, fetch_wind
from seacruise.desktop.language import install
from seacruise.desktop.pages.page import Page
from seacruise.desktop.pages.page import Phase as PagePhase
from seacruise.desktop.state import Phase
from seacruise.desktop.style import apply_style
from seacruise.desktop.window import MainWindow
from seacruise.errors import NoPassageError, SeaCruiseError, WeatherError
from seacruise.progress import Job
from seacruise.resources import resource_path
from seacruise.settings import Settings
from seacruise.weather.wind import Wind

ROOT = Path(__file__).resolve().parent.parent
SIZES = ((1024, 700), (1280, 800), (1920, 1080))
LIGHTS = ("day", "dusk", "night")
DOCUMENTED = ((1280, 800),)
POLISH = ("guide-1", "passage", "when-to-go", "where-to-go")
IN_POLISH = ((1024, "dusk"), (1280, "night"), (1920, "day"))
COLOURS = 256
TURNED_DEG = (-40.0, -25.0, -12.0, -4.0, 5.0, 14.0, 27.0, 45.0)
STRENGTH = (0.85, 1.1, 0.72, 1.05, 0.95, 1.2, 0.88, 1.0)
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

Shoot = Callable[[str, QWidget | None], None]
Scene = Callable[[MainWindow, Shoot], None]


def wait(condition: Callable[[], bool], seconds: float = 120.0) -> None:
    """Let the window live until something is so."""
    loop, begun = QEventLoop(), time.monotonic()
    timer = QTimer()
    timer.timeout.connect(lambda: loop.quit() if condition() or time.monotonic() - begun > seconds else None)
    timer.start(20)
    loop.exec()
    if not condition():
        raise SystemExit("The window did not get there; see its log.")


def rest(seconds: float = 0.2) -> None:
    """Let the window live for a while."""
    end = time.monotonic() + seconds
    wait(lambda: time.monotonic() > end)


@contextmanager
def a_window(size: tuple[int, int], fetcher: Fetcher = fetch_wind) -> Iterator[MainWindow]:
    """Window of a sailor who has nothing yet, with the form filled in and everything loaded."""
    with tempfile.TemporaryDirectory() as home:
        # What was compiled of the sea stays from window to window: it is the same.
        cache = Path(tempfile.gettempdir()) / "seacruise-gallery-cache"
        settings = Settings(cache_dir=cache, data_dir=Path(home) / "data")
        window = MainWindow(settings, fetcher=fetcher)
        window.resize(*size)
        ready: list[bool] = []
        window.ready.connect(lambda: ready.append(True))
        window.fill(PASSAGE)
        window.show()
        window.load(warm_up=False)
        wait(lambda: bool(ready) and window.chart.view.is_settled)
        yield window
        window.close()


def calculate(window: MainWindow) -> None:
    """Calculate to the end."""
    window.calculate()
    wait(lambda: window.state.phase is not Phase.COMPUTING)
    rest()
    wait(lambda: window.chart.view.is_settled)


def run_page(page: Page) -> None:
    """Let a page do its job."""
    page.start()
    wait(lambda: page.phase is not PagePhase.BUSY)
    rest()


# ------------------------------------------------------------------------------------------------ scenes


def passage(window: MainWindow, shoot: Shoot) -> None:
    """Empty window, route, its details, in every light."""
    shoot("empty", None)
    calculate(window)
    window.menus.layers["isochrones"].setChecked(True)
    wait(lambda: not window.layers.jobs.is_running)
    window.chart.time_bar.slider.setValue(15 * 60)
    shoot("passage", None)
    window.menus.layers["isochrones"].setChecked(False)
    window.legs.choose_leg(4)
    window.menus.layers["field"].setChecked(True)
    shoot("field", None)
    window.form.options_bar.show_options(shown=True)
    shoot("options", None)


def chart(window: MainWindow, shoot: Shoot) -> None:
    """Everything on the chart at once, each meaning of the route's colours, via and measure."""
    calculate(window)
    layers, menus, view = window.layers, window.menus, window.chart.view
    for name in ("field", "isochrones", "lattice"):
        menus.layers[name].setChecked(True)
    window.steering.avoided.add(56.8, 18.4, 10.0)
    wait(lambda: not window.steering.router.is_busy)
    for scheme in ("tws", "twa", "point", "speed"):
        menus.choose("scheme", scheme)
        wait(lambda: not layers.jobs.is_running)
        shoot(f"layers-{scheme}", None)
    for name in ("field", "isochrones", "lattice"):
        menus.layers[name].setChecked(False)
    middle = view.middle()
    view.measure_from(*middle)
    view.measure.reach(middle[0] + 1.0, middle[1] + 1.0)
    view.end_picked.emit("via", middle[0] + 0.4, middle[1] + 0.6)
    wait(lambda: not window.steering.router.is_busy)
    shoot("via-and-measure", None)


def when(window: MainWindow, shoot: Shoot) -> None:
    """When to go: empty, departures of one yacht, of three, arrivals, nothing found."""
    page = window.planning.departures
    window.planning.frame.open_page(page)
    shoot("when-empty", None)
    page.count_box.setValue(8)
    page.every_box.setValue(3)
    run_page(page)
    shoot("when", None)
    page.add_yacht("Cookson 50")
    names = [page.yacht_box.itemText(k) for k in range(page.yacht_box.count())]
    page.add_yacht(max(names, key=len))
    run_page(page)
    shoot("when-yachts", None)
    next(b for b in page.body.findChildren(QToolButton) if b.isCheckable() and not b.isChecked()).click()
    shoot("when-arrival", None)
    window.form.fill({"max_wind_kn": 5.0})
    run_page(page)
    shoot("when-none", None)
    window.form.end_field.setText("Nowhere at all")
    run_page(page)
    shoot("when-wrong", None)


def where(window: MainWindow, shoot: Shoot) -> None:
    """Where to go: empty, there and back, one way, no port, wrong stay."""
    page = window.planning.reach
    window.planning.frame.open_page(page)
    shoot("where-empty", None)
    run_page(page)
    shoot("where", None)
    page.back_box.setChecked(False)
    run_page(page)
    shoot("where-out", None)
    page.filter_field.setText("xyz")
    shoot("where-filtered", None)
    page.filter_field.clear()
    page.back_box.setChecked(True)
    page.stay_box.setValue(30)
    run_page(page)
    shoot("where-wrong", None)


def weather(window: MainWindow, shoot: Shoot) -> None:
    """Weather: no key, files read and refused, a mean, a service that is down."""
    window.desk.show_weather()
    page = window.desk.weather
    rest(0.6)
    shoot("weather", page)
    page.add_file(str(resource_path("assets/wind/sample.nc")))
    broken = (
        Path(tempfile.gettempdir())
        / "a long name of a forecast that somebody has downloaded in a hurry.grib2"
    )
    broken.write_bytes(b"GRIB")
    page.add_file(str(broken))
    rest(2.0)
    page.show_trouble(TROUBLES[0])
    shoot("weather-down", page)
    area = page.findChild(QScrollArea)
    assert area is not None
    area.verticalScrollBar().setValue(area.verticalScrollBar().maximum())
    shoot("weather-files", page)
    broken.unlink()


def yachts(window: MainWindow, shoot: Shoot) -> None:
    """Yachts: the polar of one, and two compared."""
    window.desk.show_yachts()
    page = window.desk.yachts
    rest(1.0)
    shoot("yachts", page)


def saved(window: MainWindow, shoot: Shoot) -> None:
    """List saved passages: none, some, one of them with a long name, and one that is open."""
    window.desk.show_passages()
    page = window.desk.passages
    rest(0.5)
    shoot("saved-empty", page)
    calculate(window)
    assert window.state.answer is not None
    page.save(window.state.answer)
    page.save(
        window.state.answer,
        "Late, with the whole family aboard, from the yard in Gdynia to the quay below the old town",
    )
    wait(lambda: not page.is_busy)
    page.load()
    wait(lambda: not page.is_busy)
    rest()
    shoot("saved", page)
    page.open()
    wait(lambda: not page.is_busy)
    rest()
    shoot("saved-open", None)


def ensemble(window: MainWindow, shoot: Shoot) -> None:
    """Compare departures with an ensemble: the band of 10 to 90 per cent of its members."""
    calculate(window)
    page = window.planning.departures
    window.planning.frame.open_page(page)
    page.count_box.setValue(5)
    page.every_box.setValue(4)
    run_page(page)
    shoot("when-ensemble", None)


def members(window: MainWindow, shoot: Shoot) -> None:
    """Show the members of an ensemble on the chart, and the same passage with fewer turns."""
    calculate(window)
    wait(lambda: (bundle := window.chart.view.members.bundle) is not None and bundle.is_complete)
    window.chart.time_bar.slider.setValue(30 * 60)
    shoot("members", None)
    window.menus.layers["members"].setChecked(False)
    window.menus.layers["turns"].setChecked(True)
    wait(lambda: bool(window.chart.view.others.ways) and not window.layers.ways.turns.jobs.is_running)
    shoot("fewer-turns", None)


def with_members(question: Question, where: Settings, job: Job) -> Wind:
    """Sample wind with eight members, weaker and stronger than it, veered and backed."""
    wind = fetch_wind(question, where, job)
    turned = (wind.u + 1j * wind.v)[None] * np.exp(1j * np.radians(TURNED_DEG))[:, None, None, None]
    members = tuple(
        replace(wind, u=k * one.real, v=k * one.imag) for k, one in zip(STRENGTH, turned, strict=True)
    )
    return replace(wind, members=members)


SCENES: dict[str, Scene] = {
    scene.__name__: scene
    for scene in (passage, chart, members, when, ensemble, where, weather, yachts, saved)
}
FETCHERS: dict[str, Fetcher] = {"ensemble": with_members, "members": with_members}


def troubles(size: tuple[int, int], shoot_of: Callable[[MainWindow], Shoot]) -> None:
    """Window after each calculation that failed, and while one computes."""
    for error in TROUBLES:

        def fail(*_: object, error: SeaCruiseError = error) -> NoReturn:
            raise error

        with a_window(size, fail) as window:
            calculate(window)
            if isinstance(error, NoPassageError) and error.place is not None:
                window.chart.view.show_place(*error.place)
            shoot_of(window)(f"trouble-{error.reason}", None)
    gate = threading.Event()

    def fetch_slowly(question: Question, where: Settings, job: Job) -> Wind:
        job.report("sea", 1.0, "Sea ready")
        job.report("wind", 3 / 9, "wind 3 of 9")
        gate.wait(30)
        return fetch_wind(question, where, job)

    with a_window(size, fetch_slowly) as window:
        window.calculate()
        wait(lambda: window.state.progress.stage == "wind")
        shoot_of(window)("computing", None)
        gate.set()
        wait(lambda: window.state.phase is not Phase.COMPUTING)


# -------------------------------------------------------------------------------------------- the camera


def shooter(window: MainWindow, folder: Path, lights: tuple[str, ...]) -> Shoot:
    """Take a picture of a window in each light once the chart is complete."""

    def shoot(name: str, page: QWidget | None) -> None:
        for light in lights:
            window.menus.choose("light", light)
            rest()
            wait(lambda: window.wardrobe is None or not window.wardrobe.is_changing)
            wait(lambda: window.chart.view.is_settled)
            path = folder / f"{name}-{light}.png"
            path.parent.mkdir(parents=True, exist_ok=True)
            (page.window() if page is not None else window).grab().save(str(path))
            print(path)
        window.menus.choose("light", lights[0])

    return shoot


def look(
    folder: Path,
    names: Sequence[str],
    sizes: Sequence[tuple[int, int]],
    lights: tuple[str, ...] = LIGHTS[:1],
) -> None:
    """Take the pictures to be looked at."""
    for size in sizes:
        place = folder / f"{size[0]}x{size[1]}"
        for name, scene in SCENES.items():
            if name in names or not names:
                with a_window(size, FETCHERS.get(name, fetch_wind)) as window:
                    scene(window, shooter(window, place, lights))
        if "troubles" in names or not names:
            troubles(size, partial(shooter, folder=place, lights=lights[:1]))


# --------------------------------------------------------------------------------------- documentation

RUN = (
    ("guide-1", "A first start: a guide of three cards, which waits for nobody."),
    ("type-ahead", "Ports by the beginnings of their names."),
    ("calendar", "The calendar offers the days that the forecast covers."),
    ("passage", "The fastest passage: summary, legs, chart."),
    ("right-click", "What can be done with any position."),
    ("via", "By way of a place; the departure was dragged before."),
    ("when-to-go", "Departures compared: curve, table, a sentence; a click adopts one."),
    ("where-to-go", "Ports in reach, there and back, and the lines of equal time."),
)
"""Pictures of the run by mouse and keys, in its order."""

PAGES = (
    ("when-yachts-day", "Yachts compared, a column each: in bold the fastest of each departure."),
    ("when-ensemble-day", "With an ensemble: ten to ninety per cent of its members lie within the band."),
    (
        "members-day",
        "With an ensemble: the fastest passage in each member, and where she is in each at the time below.",
    ),
    (
        "fewer-turns-day",
        "The same passage with fewer tacks and gybes, and what they cost; a click adopts one.",
    ),
    ("where-day", "What fits in the time there is."),
    ("weather-day", "Weather: each source, whether it can be used or why not, the key, what is kept."),
    (
        "weather-files-day",
        "Weather without a connection: files that were dropped, what is done after their end.",
    ),
    ("yachts-day", "Yachts: the polar, its targets."),
    ("saved-day", "Saved passages."),
    ("layers-tws-day", "Everything on the chart at once."),
    ("trouble-no-water-path-day", "No passage: the sentence says why, the chart where."),
)
"""Pictures of pages and troubles, taken here."""


GALLERY_TEXT = """\
The real program on a screen of its own, driven by mouse and keys from an empty home to a route in a plotter's
file, in English and in Polish: `tests/display`. `python tools/gallery.py` takes the pictures anew.
"""


def pack(path: Path, target: Path) -> None:
    """Bring a picture down to few colours: a third of the bytes, and hardly a difference to the eye."""
    from PIL import Image

    target.parent.mkdir(parents=True, exist_ok=True)
    with Image.open(path) as picture:
        # The usual method takes the colours of large areas, and turns the few pixels of a legend into others.
        few = picture.convert("RGB").quantize(
            COLOURS, method=Image.Quantize.MAXCOVERAGE, kmeans=1, dither=Image.Dither.NONE
        )
        few.save(target, optimize=True)


def drive(folder: Path) -> None:
    """Let the tests drive the real program, and keep what its screen shows."""
    subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:randomly", "tests/display"],
        cwd=ROOT,
        env=os.environ | {"SEACRUISE_SHOTS": str(folder), "QT_QPA_PLATFORM": "xcb"},
        check=True,
    )


def write_gallery(shots: Path, pages: Path) -> None:
    """Put the pictures into the documentation, with a page that shows them."""
    images = ROOT / "docs" / "images" / "gallery"
    shutil.rmtree(images, ignore_errors=True)

    def keep(source: Path, text: str) -> str:
        pack(source, images / source.name)
        return f"{text}\n\n![{text}](images/gallery/{source.name})\n"

    parts = [
        "# Gallery\n",
        GALLERY_TEXT,
        "## From the first start to a saved route\n",
        *(keep(shots / f"en-{name}.png", text) for name, text in RUN),
        "## In Polish\n",
        *(keep(shots / f"pl-{name}.png", text) for name, text in RUN if name in POLISH),
        "## Three sizes, three lights\n",
    ]
    for width, height in SIZES:
        for light in LIGHTS:
            name = f"{width}x{height}-{light}"
            language, said = ("pl", "Polish") if (width, light) in IN_POLISH else ("en", "English")
            parts.append(keep(shots / f"{language}-{name}.png", f"{width} x {height}, {light}, {said}"))
    parts.append("## Pages, and what is said when there is no passage\n")
    parts += [keep(pages / f"{name}.png", text) for name, text in PAGES]
    (ROOT / "docs" / "gallery.md").write_text("\n".join(parts), encoding="utf-8")
    whole = sum(path.stat().st_size for path in images.iterdir())
    print(f"{len(list(images.iterdir()))} pictures, {whole / 1e6:.1f} MB")


def document() -> None:
    """Take every picture of the documentation."""
    with tempfile.TemporaryDirectory() as folder:
        shots, pages = Path(folder) / "shots", Path(folder) / "pages"
        shots.mkdir()
        drive(shots)
        look(
            pages,
            ["when", "ensemble", "members", "where", "weather", "yachts", "saved", "chart", "troubles"],
            DOCUMENTED,
        )
        write_gallery(shots, pages / "1280x800")
        pack(shots / "en-1280x800-day.png", ROOT / "docs" / "images" / "window.png")


def main() -> None:
    """Take the pictures of the documentation, or those to be looked at."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("folder", type=Path, nargs="?")
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--size", action="append", default=[], help="1024x700, 1280x800, 1920x1080")
    parser.add_argument("--light", action="append", default=[], choices=LIGHTS)
    parser.add_argument("--language", default="en", choices=("en", "pl"))
    arguments = parser.parse_args()
    os.environ["SEACRUISE_LANGUAGE"] = arguments.language
    app = QApplication([])
    apply_style(app)
    install(app)
    if arguments.folder is None:
        document()
        return
    sizes = tuple(size for size in SIZES if not arguments.size or f"{size[0]}x{size[1]}" in arguments.size)
    look(arguments.folder, arguments.scenes, sizes, tuple(arguments.light or LIGHTS))


if __name__ == "__main__":
    main()
