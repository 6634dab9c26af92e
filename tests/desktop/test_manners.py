"""Nothing typed is lost, everything fits, and each trouble names a way out."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, QPointF, QRect, Qt
from PySide6.QtGui import QGuiApplication, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QCheckBox, QComboBox, QLabel
from pytestqt.qtbot import QtBot

from seacruise import cli
from seacruise.desktop.about import AboutDialog, notice_html, versions
from seacruise.desktop.banner import Banner, breakable
from seacruise.desktop.elided import ElidedLabel
from seacruise.desktop.loading import Loading
from seacruise.desktop.memory import WindowMemory
from seacruise.desktop.messages import WayOut, message_for
from seacruise.desktop.number_box import NumberBox
from seacruise.desktop.options_model import DEFAULTS, NAMES, OFFERED, OptionsModel
from seacruise.desktop.pages.weather_page import WeatherPage
from seacruise.desktop.state import Phase
from seacruise.desktop.units_choice import units_choice
from seacruise.desktop.window import MainWindow
from seacruise.errors import InputError, NoPassageError, SeaCruiseError, WeatherError
from seacruise.settings import Settings
from tests.desktop.conftest import ASK, HeldPlanner, fetch_at_once, texts_of

SAID = {
    "preset": "precise",
    "directions": 24,
    "spacing_nm": 4.0,
    "percent_of_polar": 92.5,
    "percent_at_night": 80.0,
    "sea_state_percent": 8.0,
    "max_wind_kn": 27.5,
    "max_gust_kn": 38.0,
    "max_wave_m": 2.5,
    "shore_clearance_nm": 1.5,
    "may_wait_h": 6.0,
    "motor_below_kn": 2.75,
    "motor_speed_kn": 5.5,
    "fuel_rate_l_h": 3.1,
    "tacking": False,
    "tack_penalty_min": 2.0,
    "gybe_penalty_min": 3.0,
    "board_h": 2.0,
    "most_turns": 12,
    "beyond": "fade",
    "currents": False,
}
"""Options of the command line, none at its default but the preset."""


# --- loading ---------------------------------------------------------------------------------------------


@pytest.fixture
def unloaded(
    app: QApplication, qtbot: QtBot, settings: Settings, planner: HeldPlanner
) -> Iterator[MainWindow]:
    """A window that has loaded nothing yet."""
    window = MainWindow(settings, planner=planner, fetcher=fetch_at_once)
    qtbot.addWidget(window)
    window.fill(ASK)
    window.show()
    yield window
    planner.gate.set()
    window.close()


def test_calculate_waits_for_the_ports(unloaded: MainWindow, planner: HeldPlanner, qtbot: QtBot) -> None:
    planner.gate.set()
    unloaded.form.calculate_button.click()
    assert "Loading ports" in texts_of(unloaded)
    assert "There is no port" not in texts_of(unloaded)
    assert not unloaded.form.calculate_button.isEnabled()
    with qtbot.waitSignal(unloaded.settled, timeout=20_000):
        unloaded.load(warm_up=False)
    assert unloaded.state.phase is Phase.ROUTE
    assert len(planner.requests) == 1
    assert "Loading" not in texts_of(unloaded)


def test_what_waits_is_cancelled(unloaded: MainWindow, planner: HeldPlanner, qtbot: QtBot) -> None:
    unloaded.calculate()
    QTest.keyClick(unloaded, Qt.Key.Key_Escape)
    assert unloaded.form.calculate_button.isEnabled()
    assert "Loading" not in texts_of(unloaded)
    with qtbot.waitSignal(unloaded.ready, timeout=20_000):
        unloaded.load(warm_up=False)
    assert unloaded.state.phase is Phase.EMPTY
    assert not planner.requests


def test_a_forecast_just_chosen_is_waited_for(window: MainWindow, planner: HeldPlanner, qtbot: QtBot) -> None:
    planner.gate.set()
    window.form.departure.use_first_hour(datetime.now(UTC))
    with qtbot.waitSignal(window.settled, timeout=20_000):
        window.form.set_forecast(("practice",))
        window.calculate()
    departure = planner.requests[-1].departure
    assert departure is not None
    assert departure > datetime.now(UTC) - timedelta(hours=1)


def test_only_the_last_wish_waits(qtbot: QtBot) -> None:
    loading, done = Loading("a", "b"), []
    loading.then(lambda: done.append(1))
    loading.then(lambda: done.append(2))
    loading.end("a")
    assert not done
    with qtbot.waitSignal(loading.ready):
        loading.end("b")
    assert done == [2]
    loading.begin("a")
    loading.then(lambda: done.append(3))
    assert loading.forget()
    with qtbot.assertNotEmitted(loading.ready):
        loading.end("a")
    assert done == [2]
    assert not loading.forget()


# --- nothing is lost -------------------------------------------------------------------------------------


def test_every_option_of_the_command_line_survives(
    window: MainWindow, planner: HeldPlanner, qtbot: QtBot
) -> None:
    window.fill(SAID)
    window.form.options_bar.open_dialog()
    window.form.options_bar.show_options(shown=True)
    options = window.form.options()
    assert {name: getattr(options, name) for name in SAID} == SAID
    planner.gate.set()
    with qtbot.waitSignal(window.settled, timeout=20_000):
        window.calculate()
    assert planner.requests[-1].options == options


def test_every_option_outlives_the_window(make_window: Callable[..., MainWindow], tmp_path: Path) -> None:
    first = make_window(memory=WindowMemory(tmp_path))
    first.fill(SAID)
    before = first.form.sailing.contents()
    first.close()
    second = make_window(memory=WindowMemory(tmp_path), fill=False)
    assert second.form.sailing.contents() == before
    assert {name: before[name] for name in OFFERED} == {name: SAID[name] for name in OFFERED}
    assert second.form.options().directions is None


@pytest.mark.parametrize(
    "typed",
    [
        ("Gdy", ""),
        ("Atlantis", "Świnoujście"),
        ("54.5, 18.6", "5"),
        ("  ", "Port with a very long name " * 9),
    ],
)
def test_half_typed_ends_outlive_the_window(
    make_window: Callable[..., MainWindow], tmp_path: Path, typed: tuple[str, str]
) -> None:
    first = make_window(memory=WindowMemory(tmp_path), fill=False)
    first.form.start_field.setText(typed[0])
    first.form.end_field.setText(typed[1])
    first.close()
    second = make_window(memory=WindowMemory(tmp_path), fill=False)
    assert (second.form.start_field.text(), second.form.end_field.text()) == typed


def test_a_chosen_departure_outlives_the_window(
    make_window: Callable[..., MainWindow], tmp_path: Path
) -> None:
    moment = datetime.now(UTC).replace(minute=20, second=0, microsecond=0) + timedelta(hours=30)
    first = make_window(memory=WindowMemory(tmp_path), fill=False)
    first.fill({"forecast": ("practice",), "depart": moment})
    first.close()
    second = make_window(memory=WindowMemory(tmp_path), fill=False)
    assert second.form.departure.moment == moment
    assert second.form.departure.was_chosen


def test_a_departure_that_is_over_does_not(make_window: Callable[..., MainWindow], tmp_path: Path) -> None:
    first = make_window(memory=WindowMemory(tmp_path), fill=False)
    first.fill({"forecast": ("practice",), "depart": datetime(2020, 1, 1, tzinfo=UTC)})
    first.close()
    second = make_window(memory=WindowMemory(tmp_path), fill=False)
    assert not second.form.departure.was_chosen
    assert second.form.departure.moment > datetime.now(UTC) - timedelta(hours=1)


def test_in_the_sample_no_departure_is_ever_over(
    make_window: Callable[..., MainWindow], tmp_path: Path
) -> None:
    make_window(memory=WindowMemory(tmp_path)).close()
    second = make_window(memory=WindowMemory(tmp_path), fill=False)
    assert second.form.departure.moment == ASK["depart"]


@pytest.mark.parametrize("error", [WeatherError("No network.", reason="no-network"), RuntimeError("x"), None])
def test_a_failure_leaves_the_form_alone(
    window: MainWindow, planner: HeldPlanner, qtbot: QtBot, error: Exception | None
) -> None:
    window.fill(SAID)
    window.form.end_field.setText("Sandhamn")
    before = window.form.contents()
    planner.error = error
    with qtbot.waitSignal(window.settled, timeout=20_000):
        window.calculate()
        qtbot.waitUntil(planner.begun.is_set)
        window.form.start_field.setText("Hel")
        window.cancel() if error is None else planner.gate.set()
    assert window.form.contents() == before | {"start": "Hel"}


def test_another_forecast_leaves_the_form_alone(window: MainWindow, qtbot: QtBot) -> None:
    window.fill(SAID)
    before = window.form.contents()
    with qtbot.waitSignal(window.background.horizon_loaded, timeout=20_000):
        window.form.set_forecast(("practice",))
    assert window.form.contents() == before | {"forecast": ["practice"]}
    assert window.form.departure.range_label.objectName() == "fault"


def test_a_wheel_that_passes_by_changes_nothing(window: MainWindow, qtbot: QtBot) -> None:
    window.form.options_bar.show_options(shown=True)
    window.chart.view.setFocus()
    QApplication.processEvents()
    before = window.form.contents()
    for field in (
        *(window.form.yacht_box, window.form.forecast_box, window.form.percent_box),
        *(window.form.departure.date_edit, window.form.departure.time_edit),
    ):
        middle = QPointF(field.rect().center())
        wheel = QWheelEvent(
            middle,
            field.mapToGlobal(middle),
            QPoint(0, 0),
            QPoint(0, -240),
            Qt.MouseButton.NoButton,
            Qt.KeyboardModifier.NoModifier,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QApplication.sendEvent(field, wheel)
    assert window.form.contents() == before


# --- options ---------------------------------------------------------------------------------------------


def test_the_line_says_what_is_not_usual(window: MainWindow) -> None:
    bar = window.form.options_bar
    assert not bar.summary.isVisible()
    window.fill({"percent_of_polar": 90.0, "max_wind_kn": 25.0})
    assert bar.summary.text() == "90 % of the polar, at most 25 kn of wind"
    units_choice().choose(wind="m/s")
    assert bar.summary.text() == "90 % of the polar, at most 13 m/s of wind"
    units_choice().choose(wind="kn")
    bar.dialog.reset_button.click()
    assert window.form.options() == DEFAULTS
    assert not bar.summary.isVisible()


def test_everything_that_differs_is_told() -> None:
    for name in NAMES:
        value = SAID.get(name, {"lattice": "rectangular", "area": "rectangle", "refine": False}.get(name))
        model = OptionsModel()
        model.put({name: "classic" if name == "preset" else value})
        told = name in {"motor_speed_kn", "fuel_rate_l_h", "safety_levels"} or model.is_default
        assert bool(model.summary()) != told, name


def test_the_dialog_sets_and_shows(window: MainWindow) -> None:
    form = window.form
    fields = form.options_bar.dialog.fields
    assert set(fields) == set(OFFERED)
    gusts, turns, beyond = fields["max_gust_kn"], fields["most_turns"], fields["beyond"]
    tacking, percent = fields["tacking"], fields["percent_of_polar"]
    assert isinstance(gusts, NumberBox)
    assert isinstance(turns, NumberBox)
    assert isinstance(percent, NumberBox)
    assert isinstance(beyond, QComboBox)
    assert isinstance(tacking, QCheckBox)
    gusts.setValue(35.0)
    turns.setValue(0.0)
    beyond.activated.emit(1)
    tacking.click()
    options = form.options()
    assert (options.max_gust_kn, options.most_turns) == (35.0, 0)
    assert (options.beyond, options.tacking) == ("fade", False)
    turns.setValue(turns.minimum())
    gusts.setValue(0.0)
    assert (form.options().most_turns, form.options().max_gust_kn) == (None, None)
    form.percent_box.setValue(80.0)
    assert percent.value() == 80.0


def test_a_forecast_without_a_current_says_so_beside_the_switch(
    answered: MainWindow, planner: HeldPlanner
) -> None:
    model, dialog = answered.form.sailing, answered.form.options_bar.dialog
    dialog.show()
    box = dialog.fields["currents"]
    reason = next(one for one in dialog.findChildren(QLabel) if one.text().endswith("has no current."))
    assert isinstance(box, QCheckBox)
    assert model.has_current is False
    assert not box.isEnabled()
    assert reason.isVisible()
    assert box.toolTip() == reason.text()
    answered.form.set_forecast(("practice",))
    assert box.isEnabled(), "not known yet"
    assert not reason.isVisible()
    model.learn_current(True)
    box.click()
    assert not answered.form.options().currents
    assert "without currents" in answered.form.options_bar.summary.text()


@pytest.mark.parametrize(
    "kept",
    [
        {"max_wind_kn": float("nan")},
        {"percent_of_polar": 1e9},
        {"most_turns": 2.5},
        {"beyond": "x"},
        {"tacking": 1},
    ],
)
def test_a_damaged_option_is_passed_over(kept: dict[str, object]) -> None:
    model = OptionsModel()
    model.restore(kept | {"motor_below_kn": 2.0})
    assert model.options.motor_below_kn == 2.0
    assert all(getattr(model.options, name) == getattr(DEFAULTS, name) for name in kept)


# --- room ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("width", "height"), [(640, 400), (853, 533), (1024, 640), (1280, 800)])
def test_the_window_fits_where_everything_is_large(answered: MainWindow, width: int, height: int) -> None:
    answered.resize(width, height)
    QApplication.processEvents()
    assert (answered.width(), answered.height()) == (width, height)
    chart = answered.chart.view
    assert chart.width() >= 250
    assert chart.height() >= 0.3 * height
    inside = QRect(QPoint(0, 0), answered.size())
    for widget in (answered.chart, answered.chart.time_bar.slider, answered.chart.time_bar.label):
        assert inside.contains(QRect(widget.mapTo(answered, QPoint(0, 0)), widget.size()))
    assert answered.chart.time_bar.slider.width() >= 60
    answered.habits.columns.go_to("question")
    QApplication.processEvents()
    assert answered.form.isVisible()
    assert answered.form.isAncestorOf(QApplication.focusWidget() or answered)


def test_a_question_is_beside_the_chart_until_there_is_an_answer(
    window: MainWindow, planner: HeldPlanner, qtbot: QtBot
) -> None:
    window.resize(700, 480)
    QApplication.processEvents()
    assert window.form.isVisible()
    assert not window.side.isVisible()
    planner.gate.set()
    with qtbot.waitSignal(window.settled, timeout=20_000):
        window.calculate()
    assert window.side.isVisible()
    window.form.end_field.setText("Atlantis")
    window.calculate()
    banner = window.side.banner
    assert banner is not None
    assert banner.button is not None
    banner.button.click()
    assert window.form.isVisible()
    assert window.form.end_field.hasFocus() or not window.isActiveWindow()


def test_large_fonts_fit(app: QApplication, make_window: Callable[..., MainWindow]) -> None:
    font = QGuiApplication.font()
    large = QGuiApplication.font()
    large.setPointSizeF(font.pointSizeF() * 1.6)
    app.setFont(large)
    try:
        window = make_window()
        window.resize(1280, 800)
        QApplication.processEvents()
        assert window.width() == 1280
        for field in (window.form.calculate_button, window.form.start_field, window.form.percent_box):
            assert field.width() <= window.form.width()
        window.form.options_bar.show_options(shown=True)
        QApplication.processEvents()
        for body in (window.form.parentWidget(), window.side):
            assert body is not None
            column = body.parentWidget()
            assert column is not None
            assert body.minimumSizeHint().width() <= column.width()
        assert window.chart.width() >= 300
    finally:
        app.setFont(font)


def test_what_is_too_long_is_cut_and_told(app: QApplication, qtbot: QtBot) -> None:
    label = ElidedLabel()
    qtbot.addWidget(label)
    label.say(
        "Świnoujście – Karlskrona, by way of everywhere there is to sail to", "Świnoujście – Karlskrona"
    )
    label.resize(1000, 20)
    label.show()
    assert label.shown == label.text()
    assert not label.toolTip()
    label.resize(label.fontMetrics().horizontalAdvance("Świnoujście – Karlskrona") + 4, 20)
    assert label.shown == "Świnoujście – Karlskrona"
    assert label.toolTip() == label.text()
    label.resize(60, 20)
    assert label.shown.endswith("…")
    assert label.minimumSizeHint().width() <= 60


def test_a_long_trouble_wraps(window: MainWindow) -> None:
    path = "/home/sailor/" + "a_folder_with_a_name/" * 12 + "a" * 90 + ".grib2"
    window._show_trouble(InputError(f"{path} cannot be read; choose another file."))
    QApplication.processEvents()
    banner = window.side.banner
    assert banner is not None
    area = window.side.width()
    for label in banner.findChildren(QLabel):
        assert label.minimumSizeHint().width() <= area
        assert label.heightForWidth(label.width()) <= label.height() + 1
    assert path in banner.accessibleName()
    assert breakable(path).replace("\u200b", "") == path


def test_long_names_do_not_widen_the_form(window: MainWindow) -> None:
    wide = window.form.width()
    window.form.yacht_box.addItem("The Good Ship " + "Lollipop " * 8)
    window.form.yacht_box.setCurrentIndex(window.form.yacht_box.count() - 1)
    window.form.set_forecast(("/tmp/" + "icon-eu-" * 12 + ".grib2",))
    window.form.start_field.setText("Świnoujście–Karlskrona–Kuressaare–Nynäshamn " * 3)
    QApplication.processEvents()
    assert window.form.width() == wide
    assert window.form.minimumSizeHint().width() <= wide


# --- ways out --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("error", "ways"),
    [
        (WeatherError("x", reason="no-key"), {WayOut.PRACTICE, WayOut.WEATHER}),
        (WeatherError("x", reason="no-network"), {WayOut.RETRY, WayOut.PRACTICE}),
        (NoPassageError("x", reason="wind-limit", place=(1.0, 2.0)), {WayOut.SHOW_PLACE, WayOut.OPTIONS}),
        (NoPassageError("x", reason="wind-limit"), {WayOut.OPTIONS}),
        (InputError("There is no port."), {WayOut.FORM}),
    ],
)
def test_a_trouble_has_its_ways_out(
    app: QApplication, qtbot: QtBot, error: SeaCruiseError, ways: set[WayOut]
) -> None:
    banner = Banner(message_for(error))
    qtbot.addWidget(banner)
    taken: list[WayOut] = []
    banner.way_out_chosen.connect(taken.append)
    for button in banner.buttons:
        button.click()
    assert set(taken) == ways


def test_ways_out_lead_somewhere(window: MainWindow) -> None:
    window.side.way_out_chosen.emit(WayOut.OPTIONS)
    assert window.form.options_bar.dialog.isVisible()
    window.side.way_out_chosen.emit(WayOut.WEATHER)
    page = window.desk.weather
    assert isinstance(page, WeatherPage)
    assert page.isVisible()
    window.side.way_out_chosen.emit(WayOut.ABOUT)
    dialog = window.findChild(AboutDialog)
    assert dialog is not None
    dialog.close()


# --- about -----------------------------------------------------------------------------------------------


def test_about_reads_the_notice(window: MainWindow) -> None:
    said = notice_html()
    for word in (
        "ODbL",
        "Open-Meteo",
        "CC BY 4.0",
        "MET Norway",
        "NLOD",
        "Storm Glass",
        "Qt and PySide6",
        "ORC",
    ):
        assert word in said
    assert "href='https://creativecommons.org/licenses/by/4.0/'" in said


def test_versions_tell_nothing_of_the_sailor(window: MainWindow, settings: Settings) -> None:
    window.show_about()
    dialog = window.findChild(AboutDialog)
    assert dialog is not None
    dialog.copy_button.click()
    copied = QGuiApplication.clipboard().text()
    assert copied == versions()
    assert "SeaCruise" in copied
    assert "PySide6" in copied
    assert str(Path.home()) not in copied
    assert str(settings.data_dir) not in copied
    assert dialog.copied.isVisible()
    dialog.close()


# --- a program without a console -------------------------------------------------------------------------


def test_without_streams_nothing_breaks(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(sys, "stdout", None)
    monkeypatch.setattr(sys, "stderr", None)
    assert cli.main(["ports", "list"]) == 0
    opened = [sys.stdout, sys.stderr]
    assert cli.main(["plan", "--from", "Atlantis", "--to", "Gdynia", "--yacht", "x"]) == 2
    for stream in opened:
        stream.close()


def test_a_process_without_streams_ends_well() -> None:
    for words, code in ((["ports", "list"], 0), (["ports"], 2)):
        program = "import sys; sys.stdout = sys.stderr = None; from seacruise.cli import main"
        program += f"; sys.exit(main({words}))"
        ended = subprocess.run([sys.executable, "-c", program], check=False, timeout=120)
        assert ended.returncode == code


def test_ports_that_cannot_be_read_hold_nothing_up(
    unloaded: MainWindow, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(*_: object) -> None:
        raise InputError("SeaCruise is not installed completely: ports.csv is missing; install it again.")

    monkeypatch.setattr("seacruise.desktop.background.load_catalogue", broken)
    unloaded.calculate()
    with qtbot.waitSignal(unloaded.ready, timeout=20_000):
        unloaded.load(warm_up=False)
    assert unloaded.state.phase is Phase.EMPTY
    assert unloaded.form.calculate_button.isEnabled()
    assert "ports.csv is missing" in texts_of(unloaded)


def test_the_empty_shelf_has_a_way_to_fill_it(answered: MainWindow, qtbot: QtBot) -> None:
    answered.desk.show_passages()
    page = answered.desk.passages
    qtbot.waitUntil(page.save_button.isVisible, timeout=20_000)
    assert page.invitation.isVisible()
    assert page.save_button.isEnabled()
    with qtbot.waitSignal(page.saved, timeout=20_000):
        page.save_button.click()
    qtbot.waitUntil(lambda: not page.save_button.isVisible(), timeout=20_000)


def test_there_is_nothing_to_save_before_there_is_a_passage(window: MainWindow, qtbot: QtBot) -> None:
    window.desk.show_passages()
    page = window.desk.passages
    qtbot.waitUntil(page.save_button.isVisible, timeout=20_000)
    assert not page.save_button.isEnabled()
