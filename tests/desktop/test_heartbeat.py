"""A watchdog over all that the window can be asked: its thread must not be held up for fifty milliseconds."""

from __future__ import annotations

import threading
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise.desktop.printed import paper_words
from seacruise.desktop.state import Phase
from seacruise.desktop.style import apply_style
from seacruise.desktop.window import MainWindow
from seacruise.export.pdf import write_pdf
from seacruise.settings import Settings
from tests.desktop.conftest import ASK, Heart, fetch_at_once
from tests.passages import hand_made_passage


@pytest.fixture
def planned(app: QApplication, qtbot: QtBot, settings: Settings) -> MainWindow:
    """A window with a passage, at rest."""
    others = set(threading.enumerate())
    window = MainWindow(settings, planner=lambda *_, **__: hand_made_passage(), fetcher=fetch_at_once)
    # The pages really plan here. A worker that goes on after the window might collect its cycles.
    qtbot.addWidget(
        window,
        before_close_func=lambda _: qtbot.waitUntil(
            lambda: set(threading.enumerate()) <= others, timeout=90_000
        ),
    )
    window.resize(1280, 800)
    window.fill(ASK)
    with qtbot.waitSignal(window.ready, timeout=20_000):
        window.show()
        window.load(warm_up=False)
    with qtbot.waitSignal(window.settled, timeout=20_000):
        window.calculate()
    qtbot.waitUntil(lambda: window.chart.view.is_settled, timeout=30_000)
    return window


@pytest.fixture
def watch(qtbot: QtBot) -> Callable[[Callable[[], None]], None]:
    """Do something up to five times, until once it did not hold the window up."""

    def watch(do: Callable[[], None]) -> None:
        worst: list[float] = []
        while not worst or (min(worst) >= Heart.LIMIT_S and len(worst) < 5):
            with Heart() as heart:
                do()
                qtbot.wait(60)
            worst.append(heart.worst_s)
        assert min(worst) < Heart.LIMIT_S, f"held up for {[f'{1000 * w:.0f} ms' for w in worst]}"

    return watch


def close_dialogs(window: MainWindow) -> None:
    for widget in QApplication.topLevelWidgets():
        if widget is not window and widget.isVisible():
            widget.close()


def test_a_heart_tells_who_was_at_work(qtbot: QtBot) -> None:
    with Heart() as heart:
        qtbot.wait(30)
        assert sum(number**2 for number in range(1_500_000))
        qtbot.wait(30)
    assert heart.worst_s > 0.02, "what the thread itself does is seen"
    assert len(heart.beats) > 3


@pytest.fixture
def put_on(planned: MainWindow, qtbot: QtBot) -> Callable[[str], None]:
    """Choose a light and wait until the window has changed."""

    def put_on(light: str) -> None:
        planned.menus.choose("light", light)
        qtbot.waitUntil(
            lambda: planned.wardrobe is not None and not planned.wardrobe.is_changing, timeout=10_000
        )

    return put_on


@pytest.mark.parametrize("light", ["dusk", "night"])
def test_changing_the_light(
    planned: MainWindow,
    watch: Callable[[Callable[[], None]], None],
    put_on: Callable[[str], None],
    light: str,
) -> None:
    def change() -> None:
        put_on(light)
        put_on("day")

    watch(change)
    assert planned.layers.light == "day"
    assert planned.updatesEnabled()
    assert planned.chart.view.updatesEnabled()


def test_a_light_put_on_in_steps_looks_as_one_put_on_at_once(
    planned: MainWindow, app: QApplication, qtbot: QtBot, put_on: Callable[[str], None]
) -> None:
    """Qt's own way gives every widget its look anew: slowly, and right."""
    planned.desk.show_weather()
    flashing = app.cursorFlashTime()
    app.setCursorFlashTime(0)

    def pictures() -> list[QImage]:
        qtbot.waitUntil(lambda: planned.chart.view.is_settled, timeout=30_000)
        qtbot.wait(250)
        shown = [window for window in app.topLevelWidgets() if window.isVisible()]
        assert len(shown) > 1
        return [window.grab().toImage() for window in sorted(shown, key=lambda window: window.windowTitle())]

    try:
        for light in ("night", "day", "dusk", "night", "day"):
            put_on(light)
            in_steps = pictures()
            apply_style(app, light)
            assert pictures() == in_steps, light
    finally:
        app.setCursorFlashTime(flashing)
        close_dialogs(planned)


@pytest.mark.parametrize("name", ["departures", "reach"])
def test_opening_a_page_that_plans(
    planned: MainWindow, watch: Callable[[Callable[[], None]], None], qtbot: QtBot, name: str
) -> None:
    page = getattr(planned.planning, name)

    def look() -> None:
        planned.planning.frame.open_page(page)
        page.start()
        qtbot.wait(200)
        page.cancel()
        planned.planning.frame.close_pages()

    watch(look)


@pytest.mark.parametrize("name", ["weather", "yachts", "passages"])
def test_opening_a_page_beside_the_window(
    planned: MainWindow, watch: Callable[[Callable[[], None]], None], qtbot: QtBot, name: str
) -> None:
    show = {
        "weather": planned.desk.show_weather,
        "yachts": planned.desk.show_yachts,
        "passages": planned.desk.show_passages,
    }[name]

    def look() -> None:
        show()
        qtbot.wait(200)
        close_dialogs(planned)

    watch(look)


def test_saving_a_passage_and_opening_it_again(
    planned: MainWindow, watch: Callable[[Callable[[], None]], None], qtbot: QtBot
) -> None:
    page = planned.desk.passages

    def keep() -> None:
        planned.desk.save()
        qtbot.waitUntil(lambda: not page.is_busy, timeout=10_000)
        planned.desk.show_passages()
        qtbot.waitUntil(lambda: not page.is_busy, timeout=10_000)
        page.open()
        qtbot.waitUntil(lambda: not page.is_busy, timeout=10_000)

    watch(keep)
    assert planned.state.phase is Phase.ROUTE
    close_dialogs(planned)


def test_writing_the_passage_plan(
    planned: MainWindow, watch: Callable[[Callable[[], None]], None], qtbot: QtBot, tmp_path: Path
) -> None:
    answer = planned.state.answer
    assert answer is not None
    target = tmp_path / "plan.pdf"

    def write() -> None:
        with qtbot.waitSignal(planned.exporter.saved, timeout=60_000):
            planned.exporter.write(
                target, lambda path: write_pdf(answer.passage, path, wind=answer.wind, words=paper_words())
            )

    watch(write)
    assert target.read_bytes().startswith(b"%PDF")


def test_the_pages_below_the_chart(
    planned: MainWindow, watch: Callable[[Callable[[], None]], None], qtbot: QtBot
) -> None:
    def look() -> None:
        for page in ("weather", "log", "legs"):
            planned.pane.show_page(page)
            for minutes in range(0, 300, 60):
                planned.chart.time_bar.slider.setValue(minutes)
                qtbot.wait(10)

    watch(look)


def test_moving_the_chart(
    planned: MainWindow, watch: Callable[[Callable[[], None]], None], qtbot: QtBot
) -> None:
    view = planned.chart.view
    planned.menus.layers["field"].setChecked(True)

    def move() -> None:
        for step in range(24):
            view.pan(11.0, 7.0 - step)
            qtbot.wait(8)
        for step in range(12):
            view.zoom(1.06 if step < 6 else 1 / 1.06)
            qtbot.wait(8)
        qtbot.waitUntil(lambda: view.is_settled, timeout=30_000)

    watch(move)
