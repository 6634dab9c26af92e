"""Pictures of the chart that are kept, painted in parts, and painted beside the window."""

from __future__ import annotations

import threading

import pytest
from PySide6.QtCore import QRectF, QSizeF
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise.desktop.chart import wind_layer
from seacruise.desktop.chart.barbs import barb_sprites
from seacruise.desktop.chart.layer import Layer
from seacruise.desktop.chart.sheet import Sheet, SheetPainter, blank
from seacruise.desktop.chart.turns import PoliteJob, Turns
from seacruise.desktop.chart.view import ChartView
from seacruise.desktop.compute import Answer
from seacruise.errors import CancelledError
from tests.desktop.conftest import settle


def painted(view: ChartView, layers: tuple[Layer, ...], density: float) -> tuple[QImage, int]:
    """Sheet of some layers, and in how many steps it was painted."""
    room = QRectF(view.viewport().rect())
    sheet = Sheet(blank(room.size(), density), view.viewportTransform(), room.size(), (), ())
    painter = SheetPainter(sheet, layers, view.font(), lambda *_: None)
    steps = 1
    while not painter.step():
        steps += 1
    assert painter.has(layers)
    return sheet.picture.toImage(), steps


@pytest.mark.parametrize("density", [1.0, 1.1, 1.25, 1.5, 2.0])
def test_a_sheet_painted_by_strips_is_the_same(
    view: ChartView, answer: Answer, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, density: float
) -> None:
    settle(view, qtbot)
    view.field.setVisible(True)
    layers = (view.coast, view.field)
    monkeypatch.setattr("seacruise.desktop.chart.sheet._STRIP_PIXELS", 60_000)
    by_strips, steps = painted(view, layers, density)
    for layer in layers:
        monkeypatch.setattr(layer, "by_strips", False)
    at_once, fewest = painted(view, layers, density)
    assert by_strips == at_once
    assert steps > fewest + 6
    assert fewest <= len(layers) + 1


def test_where_a_strip_would_end_within_a_row_there_are_none(
    view: ChartView, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    settle(view, qtbot)
    monkeypatch.setattr("seacruise.desktop.chart.sheet._STRIP_PIXELS", 60_000)
    assert painted(view, (view.coast,), 1.333)[1] <= 2


def test_pictures_that_are_not_needed_any_more_are_painted_on_again(app: QApplication) -> None:
    used = blank(QSizeF(40, 30), 2.0)
    assert (used.width(), used.height(), used.devicePixelRatio()) == (80, 60, 2.0)
    assert blank(QSizeF(40, 30), 2.0, used) is used
    assert blank(QSizeF(80, 60), 1.0, used) is not used
    assert blank(QSizeF(41, 30), 2.0, used) is not used


def test_a_chart_that_is_moved_far_takes_two_pictures_in_turn(
    view: ChartView, answer: Answer, qtbot: QtBot
) -> None:
    settle(view, qtbot)
    shown: list[object] = []
    for _ in range(4):
        qtbot.waitUntil(lambda: view.easel.has_sheet, timeout=10_000)
        assert view.easel._sheet is not None
        shown.append(view.easel._sheet.picture)
        view.pan(0.6 * view.width(), 0.0)
        view.grab()
        settle(view, qtbot)
        view.pan(-0.6 * view.width(), 0.0)
        view.grab()
        settle(view, qtbot)
    assert len({id(picture) for picture in shown}) <= 2


def test_barbs_are_made_before_they_are_drawn_on_a_sheet(
    view: ChartView, answer: Answer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(wind_layer, "_PART_S", 0.0)
    barb_sprites.cache_clear()
    room, parts = QRectF(view.viewport().rect()), 1
    while not view.wind.prepare(view.viewportTransform(), room, 1.0):
        parts += 1
        # As if there had been time for one.
        monkeypatch.setattr(wind_layer, "_PART_S", 10.0)
    assert parts == 2
    made: list[int] = []
    monkeypatch.setattr("seacruise.desktop.chart.barbs._stroke", lambda *_: made.append(1))
    painted(view, (view.wind,), 1.0)
    assert not made
    painted(view, (view.wind,), 2.0)
    assert made, "another screen has its own"


def test_barbs_of_a_light_are_kept(app: QApplication) -> None:
    assert barb_sprites(0xFF102030, 0xE0FFFFFF) is barb_sprites(0xFF102030, 0xE0FFFFFF)
    assert barb_sprites(0xFF102030, 0xE0FFFFFF) is not barb_sprites(0xFF102030, 0xE0FFFFFF, 0.4)


# --- frames first --------------------------------------------------------------------------------------


def test_a_worker_stands_aside_while_the_window_draws() -> None:
    turns = Turns()
    assert turns.stand_aside()
    with turns.drawing():
        assert not turns.stand_aside(), "it goes on after a while, whatever the window does"
    assert turns.stand_aside()


def test_one_that_waits_goes_on_when_the_frame_is_done(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("seacruise.desktop.chart.turns._PATIENCE_S", 60.0)
    turns, went_on = Turns(), threading.Event()

    def work() -> None:
        PoliteJob(turns=turns).check()
        went_on.set()

    with turns.drawing():
        worker = threading.Thread(target=work)
        worker.start()
        assert not went_on.wait(0.05)
    worker.join(30.0)
    assert went_on.is_set()


def test_a_polite_job_can_be_cancelled() -> None:
    job = PoliteJob()
    job.check()
    job.cancel.set()
    with pytest.raises(CancelledError):
        job.check()


def test_frames_and_sheets_hold_the_coast_s_painter_back(
    view: ChartView, answer: Answer, qtbot: QtBot
) -> None:
    settle(view, qtbot)
    free: list[bool] = []
    view.wind.draw = lambda *_: free.append(view.coast.turns._free.is_set())  # type: ignore[method-assign]
    view.wind.update()
    view.grab()
    frames = len(free)
    assert frames > 0
    qtbot.waitUntil(lambda: view.easel.has_sheet, timeout=10_000)
    assert len(free) > frames
    assert not any(free)
    assert view.coast.turns._free.is_set()
