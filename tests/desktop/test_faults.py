"""Groups H (dates and the end of the forecast) and K (the window) of the catalogue of faults.

One test a case, named by its group; what is survived is a sentence and a way out, nothing lost, no hang.
"""

# ruff: noqa: N802 - the letter of the group is in the name

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from PySide6.QtCore import QDate, QPoint, QPointF, Qt, QTime, QTimer
from PySide6.QtGui import QImage, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise import cli
from seacruise.desktop.app import _faults_shown
from seacruise.desktop.departure_field import DepartureField
from seacruise.desktop.state import Horizon, Phase
from seacruise.desktop.succession import Succession
from seacruise.desktop.units_choice import in_zone, units_choice
from seacruise.desktop.window import MainWindow
from seacruise.errors import InputError
from tests.desktop.conftest import ASK, HeldPlanner, texts_of

REPOSITORY = Path(__file__).resolve().parents[2]
NOW = datetime(2026, 11, 22, 9, 20, tzinfo=UTC)
TEN_DAYS = Horizon(NOW.replace(minute=0), NOW.replace(minute=0) + timedelta(days=10))


def phase_of(window: MainWindow) -> Phase:
    """Phase, asked anew: a type checker believes that it stays what it was."""
    return window.state.phase


def plan_sample(
    *words: str, depart: str, capsys: pytest.CaptureFixture[str]
) -> tuple[int, dict[str, object], str]:
    """Plan Gdynia - Visby in the sample of 20 to 22 November 2016 by the command line."""
    asked = [
        "plan",
        "--from",
        "Gdynia",
        "--to",
        "Visby",
        "--yacht",
        "Bavaria 46 Cruiser",
        "--forecast",
        "sample",
    ]
    code = cli.main([*asked, "--depart", depart, "--format", "json", *words])
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    return code, json.loads(out), err


@pytest.fixture
def field(app: QApplication, qtbot: QtBot) -> DepartureField:
    field = DepartureField()
    qtbot.addWidget(field)
    field.set_horizon(TEN_DAYS, NOW)
    return field


@pytest.fixture
def in_warsaw(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Show the times of a sailor in Poland."""
    if not hasattr(time, "tzset"):
        pytest.skip("the zone of a process cannot be set here")
    monkeypatch.setenv("TZ", "Europe/Warsaw")
    time.tzset()
    units_choice().choose(clock="local")
    yield
    units_choice().choose(clock="utc")
    monkeypatch.undo()
    time.tzset()


def type_moment(field: DepartureField, day: QDate, clock: QTime) -> None:
    """Type a day and a time, and leave the field."""
    field.date_edit.setDate(day)
    field.time_edit.setTime(clock)
    field.time_edit.editingFinished.emit()


# -------------------------------------------------------------------------------------------- H: dates


def test_H_past_date(window: MainWindow, planner: HeldPlanner, capsys: pytest.CaptureFixture[str]) -> None:
    window.form.departure.set_moment(datetime(2016, 11, 1, 6, tzinfo=UTC), chosen=True)
    window.calculate()
    assert phase_of(window) is Phase.FAILED
    assert not planner.requests
    said = texts_of(window)
    assert "1 Nov 2016 06:00 UTC is not within the forecast, which covers Sun 20 Nov 2016 00:00" in said
    assert window.side.banner is not None
    assert window.side.banner.button is not None
    window.side.banner.button.click()
    assert window.form.departure.is_covered
    code, answer, err = plan_sample(depart="2016-11-01T06:00Z", capsys=capsys)
    assert (code, answer["reason"]) == (3, "outside-forecast")
    assert "2016-11-20" in err or "20 Nov" in err


def test_H_beyond_horizon(
    window: MainWindow, planner: HeldPlanner, capsys: pytest.CaptureFixture[str]
) -> None:
    window.form.departure.set_moment(datetime(2016, 12, 25, 6, tzinfo=UTC), chosen=True)
    window.calculate()
    assert phase_of(window) is Phase.FAILED
    assert not planner.requests
    assert "to Tue 22 Nov 2016 00:00 UTC" in texts_of(window)
    code, answer, err = plan_sample(depart="2016-12-25T06:00Z", capsys=capsys)
    assert (code, answer["reason"]) == (3, "outside-forecast")
    assert len(err.strip().splitlines()) == 1


def test_H_arrival_beyond_horizon(capsys: pytest.CaptureFixture[str]) -> None:
    code, answer, err = plan_sample(depart="2016-11-21T23:00Z", capsys=capsys)
    assert code == 0
    held = answer["beyond_forecast_h"]
    assert isinstance(held, float)
    assert held > 12.0
    assert "held beyond the end of the forecast" in err
    code, answer, err = plan_sample("--beyond", "refuse", depart="2016-11-21T23:00Z", capsys=capsys)
    assert (code, answer["reason"]) == (3, "outside-forecast")
    assert err.strip().splitlines()[-1].startswith("seacruise: ")


def test_H_typed_and_clamped(field: DepartureField) -> None:
    type_moment(field, QDate(2027, 2, 14), QTime(6, 0))
    assert field.date_edit.date() == QDate(2027, 2, 14)
    assert "Not in the forecast" in field.range_label.text()
    with pytest.raises(InputError, match="14 Feb 2027"):
        field.require_moment()


def test_H_midnight_rollover_while_open(field: DepartureField) -> None:
    late = NOW.replace(hour=23, minute=50)
    field.set_horizon(Horizon(late.replace(minute=0), late + timedelta(days=10)), late)
    assert field.moment == datetime(2026, 11, 23, tzinfo=UTC)
    after = late + timedelta(minutes=25)
    tomorrow = Horizon(after.replace(minute=0), after + timedelta(days=10))
    field.set_horizon(tomorrow, after)
    assert field.moment == datetime(2026, 11, 23, 1, tzinfo=UTC)
    assert field.calendar.minimumDate() == QDate(2026, 11, 23)
    field.set_moment(datetime(2026, 11, 22, 23, tzinfo=UTC), chosen=True)
    field.set_horizon(tomorrow, after)
    assert field.moment == datetime(2026, 11, 22, 23, tzinfo=UTC), "what was chosen stays"
    with pytest.raises(InputError, match="covers Mon 23 Nov 2026"):
        field.require_moment()


def test_H_leap_day(field: DepartureField) -> None:
    leap = datetime(2028, 2, 28, 12, tzinfo=UTC)
    field.set_horizon(Horizon(leap, leap + timedelta(days=5)), leap)
    type_moment(field, QDate(2028, 2, 29), QTime(6, 0))
    assert field.require_moment() == datetime(2028, 2, 29, 6, tzinfo=UTC)
    assert field.calendar.maximumDate() == QDate(2028, 3, 4)
    type_moment(field, QDate(2027, 2, 29), QTime(6, 0))
    assert field.date_edit.date().isValid()


def test_H_local_time_in_DST_gap(field: DepartureField, in_warsaw: None) -> None:
    spring = datetime(2026, 3, 28, 12, tzinfo=UTC)
    field.set_horizon(Horizon(spring, spring + timedelta(days=5)), spring)
    type_moment(field, QDate(2026, 3, 29), QTime(2, 30))
    moment, shown = field.require_moment(), field.time_edit.time()
    assert moment in {datetime(2026, 3, 29, hour, 30, tzinfo=UTC) for hour in (0, 1)}
    assert (shown.hour(), shown.minute()) == (in_zone(moment).hour, 30), "the clock shows what is meant"
    assert shown != QTime(2, 30)
    type_moment(field, QDate(2026, 3, 29), QTime(1, 30))
    assert field.require_moment() == datetime(2026, 3, 29, 0, 30, tzinfo=UTC)
    assert field.time_edit.time() == QTime(1, 30)


@pytest.mark.parametrize("days", [-1, 1])
def test_H_clock_wrong_by_a_day(answered: MainWindow, field: DepartureField, days: int) -> None:
    wrong = NOW + timedelta(days=days)
    field.set_horizon(TEN_DAYS, wrong)
    assert field.is_covered
    assert answered.state.answer is not None
    issued = answered.state.answer.passage.forecast.issued
    assert issued is not None
    answered.side.result.show_passage(
        answered.state.answer.passage, issued + timedelta(days=days), earlier=False
    )
    said = texts_of(answered)
    assert " -" not in said.replace(" - ", " "), "an age is never less than nothing"


# -------------------------------------------------------------------------------------- K: the window


def press_calculate(window: MainWindow) -> None:
    QTest.mouseClick(window.form.calculate_button, Qt.MouseButton.LeftButton)


def test_K_double_click_calculate(window: MainWindow, planner: HeldPlanner, qtbot: QtBot) -> None:
    QTest.mouseDClick(window.form.calculate_button, Qt.MouseButton.LeftButton)
    press_calculate(window)
    window.calculate()
    qtbot.waitUntil(planner.begun.is_set)
    planner.gate.set()
    qtbot.waitUntil(lambda: window.state.phase is Phase.ROUTE)
    assert len(planner.requests) == 1


def test_K_change_form_during_run(window: MainWindow, planner: HeldPlanner, qtbot: QtBot) -> None:
    press_calculate(window)
    qtbot.waitUntil(planner.begun.is_set)
    window.form.swap_ends()
    window.form.percent_box.setValue(80.0)
    planner.gate.set()
    qtbot.waitUntil(lambda: window.state.phase is Phase.ROUTE)
    assert window.state.answer is not None
    assert window.state.answer.question.start.name == "Gdynia"
    assert window.state.answer.question.options.percent_of_polar == 100.0
    assert window.form.start_field.text() == str(ASK["end"])


def test_K_close_window_during_run(window: MainWindow, planner: HeldPlanner, qtbot: QtBot) -> None:
    press_calculate(window)
    qtbot.waitUntil(planner.begun.is_set)
    window.close()
    assert not window.isVisible()
    assert not [t for t in threading.enumerate() if t.name.startswith("passage-")]


def test_K_cancel_then_restart(window: MainWindow, planner: HeldPlanner, qtbot: QtBot) -> None:
    for _ in range(5):
        planner.begun.clear()
        window.calculate()
        qtbot.waitUntil(planner.begun.is_set)
        window.cancel()
    window.calculate()
    planner.gate.set()
    qtbot.waitUntil(lambda: window.state.phase is Phase.ROUTE)
    assert window.state.generation == window.state.answer_generation == 6


def test_K_resize_and_zoom_during_run(window: MainWindow, planner: HeldPlanner, qtbot: QtBot) -> None:
    view = window.chart.view
    qtbot.waitUntil(lambda: view.is_settled, timeout=30_000)
    press_calculate(window)
    qtbot.waitUntil(planner.begun.is_set)
    for width, height, notches in ((1000, 640, 3), (1700, 1000, -4), (1280, 800, 2)):
        window.resize(width, height)
        QApplication.processEvents()
        at = QPointF(view.viewport().rect().center())
        wheel = QWheelEvent(
            *(
                at,
                view.viewport().mapToGlobal(at),
                QPoint(),
                QPoint(0, 120 * notches),
                Qt.MouseButton.NoButton,
            ),
            *(Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase, False),
        )
        QApplication.sendEvent(view.viewport(), wheel)
        view.pan(40.0, -30.0)
        QApplication.processEvents()
    assert phase_of(window) is Phase.COMPUTING
    planner.gate.set()
    qtbot.waitUntil(lambda: window.state.phase is Phase.ROUTE)
    qtbot.waitUntil(lambda: view.is_settled, timeout=30_000)
    assert (window.width(), window.height()) == (1280, 800)
    assert len(planner.requests) == 1


@pytest.mark.qt_no_exception_capture
def test_K_exception_in_a_slot(
    app: QApplication, answered: MainWindow, qtbot: QtBot, caplog: pytest.LogCaptureFixture
) -> None:
    def broken() -> None:
        raise KeyError("slot")

    with _faults_shown(Succession(app, answered)):
        QTimer.singleShot(0, broken)
        qtbot.waitUntil(lambda: "KeyError" in texts_of(answered))
    assert "A slot broke" in caplog.text
    assert answered.isVisible()
    assert answered.state.answer is not None


def picture(target: Path, *words: str, **env: str) -> subprocess.CompletedProcess[str]:
    """Take the picture of a window in a process of its own."""
    return subprocess.run(
        [
            sys.executable,
            "-m",
            "seacruise",
            "window",
            "--screenshot",
            str(target),
            "--size",
            "1000x640",
            *words,
        ],
        cwd=REPOSITORY,
        env=os.environ | env,
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
    )


def test_K_hidpi_2x(tmp_path: Path) -> None:
    small, large = tmp_path / "1x.png", tmp_path / "2x.png"
    for target, factor in ((small, "1"), (large, "2")):
        answer = picture(target, "--forecast", "sample", QT_SCALE_FACTOR=factor)
        assert answer.returncode == 0, answer.stderr
    image, before = QImage(str(large)), QImage(str(small))
    assert (image.width(), image.height()) == (2000, 1280)
    halved = image.scaled(1000, 640, mode=Qt.TransformationMode.SmoothTransformation)
    # The same window, sharper: nothing is anywhere else.
    spots = [(x, y) for x in range(5, 1000, 7) for y in range(5, 640, 7)]
    same = sum(
        all(abs(a - b) < 40 for a, b in zip(_rgb(halved, *at), _rgb(before, *at), strict=True))
        for at in spots
    )
    assert same > 0.85 * len(spots)


def _rgb(image: QImage, x: int, y: int) -> tuple[int, int, int]:
    colour = image.pixelColor(x, y)
    return colour.red(), colour.green(), colour.blue()


@pytest.mark.skipif(
    not sys.platform.startswith("linux"), reason="fonts and plugins are the system's elsewhere"
)
@pytest.mark.parametrize(
    ("env", "sentence"),
    [
        pytest.param(
            {"FONTCONFIG_FILE": "no-fonts.conf", "QT_QPA_PLATFORM": "offscreen"},
            "The window cannot open: no font is installed; on Debian or Ubuntu: apt-get install",
            id="fonts",
        ),
        pytest.param(
            {"QT_QPA_PLATFORM": "nonsense"},
            "The window cannot open: Qt knows no platform 'nonsense'; unset QT_QPA_PLATFORM.",
            id="plugin",
        ),
        pytest.param(
            {"QT_QPA_PLATFORM": "xcb", "DISPLAY": ":9876"},
            "The window cannot open: ",
            id="display",
        ),
    ],
)
def test_K_missing_fonts_or_platform_plugin(tmp_path: Path, env: dict[str, str], sentence: str) -> None:
    if "FONTCONFIG_FILE" in env:
        bare = tmp_path / env["FONTCONFIG_FILE"]
        bare.write_text("<fontconfig><dir>/nowhere</dir></fontconfig>", encoding="utf-8")
        env = env | {"FONTCONFIG_FILE": str(bare)}
    answer = picture(tmp_path / "window.png", **env)
    assert answer.returncode == 2, answer.stderr
    assert sentence in answer.stderr
    assert len(answer.stderr.strip().splitlines()) == 1
    assert not (tmp_path / "window.png").exists()
