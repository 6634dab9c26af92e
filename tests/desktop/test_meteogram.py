from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from dataclasses import replace
from datetime import UTC, datetime, timedelta

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, QRectF, Qt
from PySide6.QtGui import QHelpEvent, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QToolTip
from pytestqt.qtbot import QtBot

from seacruise.desktop.compute import Answer, Question
from seacruise.desktop.log_words import SENTENCES, entry_text, entry_time
from seacruise.desktop.memory import WindowMemory
from seacruise.desktop.meteogram import Meteogram, moment_words
from seacruise.desktop.meteogram_picture import frame_of
from seacruise.desktop.meteogram_series import ENGINE, series_of
from seacruise.desktop.passage_pane import PAGES, PassagePane
from seacruise.desktop.units_choice import units_choice
from seacruise.desktop.window import MainWindow
from seacruise.export.logform import say
from seacruise.narrative import tell
from seacruise.passage import Options, Passage
from seacruise.phrases import TEMPLATES
from seacruise.ports import Port
from seacruise.settings import Settings
from seacruise.weather.wind import Wind
from seacruise.yacht.polar import Polar
from tests.desktop.conftest import HeldPlanner
from tests.passages import veering_wind


@pytest.fixture
def units() -> Iterator[None]:
    """Units may be chosen; afterwards they are as before."""
    yield
    units_choice().choose(wind="kn", distance="nm", height="m", clock="utc")


@pytest.fixture
def rough_sea() -> Wind:
    """The wind of the tests with gusts half as strong again, and waves."""
    wind = veering_wind()
    speed = np.hypot(wind.u, wind.v)
    return replace(wind, gust=speed * np.float32(1.5), wave=np.full(wind.u.shape, 1.5, np.float32))


@pytest.fixture
def meteogram(app: QApplication, qtbot: QtBot, passage: Passage, rough_sea: Wind) -> Meteogram:
    widget = Meteogram()
    qtbot.addWidget(widget)
    widget.resize(900, 220)
    widget.show_passage(passage, rough_sea)
    widget.show()
    return widget


def answer_of(passage: Passage) -> Answer:
    wind = veering_wind()
    yacht = Polar("Test", np.array([5.0, 10.0]), np.array([45.0, 90.0]), np.full((2, 2), 3.0))
    question = Question(
        Port("Gdynia", "PL", 54.5, 18.5),
        Port("Sandhamn", "SE", 59.3, 18.9),
        passage.departure,
        yacht,
        ("sample",),
        Options(),
    )
    return Answer(passage, wind, question)


@pytest.fixture
def pane(app: QApplication, qtbot: QtBot) -> PassagePane:
    widget = PassagePane()
    qtbot.addWidget(widget)
    widget.resize(1000, 240)
    widget.show()
    return widget


def picture_of(widget: Meteogram) -> QImage:
    return widget.grab().toImage()


# --- the series, without a widget -----------------------------------------------------------------------


def test_a_moment_is_that_of_the_nearest_sample(passage: Passage, rough_sea: Wind) -> None:
    series = series_of(passage, rough_sea)
    k = 100
    at = series.at(datetime.fromtimestamp(float(passage.track.time[k]) + 60.0, UTC))
    assert at.tws_kn == passage.track.tws_kn[k]
    assert at.gust_kn == pytest.approx(1.5 * at.tws_kn, rel=0.02)
    assert at.wave_m == pytest.approx(1.5)
    assert at.current_kn is None
    assert series.at(passage.departure - timedelta(days=1)).time == passage.departure
    assert series.at(passage.arrival + timedelta(days=1)).tack == "engine"


def test_tacks_and_lights_cover_the_whole_passage(passage: Passage) -> None:
    series = series_of(passage, None)
    assert series.tacks()[0][1] == 0
    assert series.tacks()[-1] == (ENGINE, series.tacks()[-1][1], passage.track.time.size - 1)
    assert series.lights[0][1] == series.begin
    assert series.lights[-1][2] == series.end
    assert series.weather.gust_kn is None


def test_beyond_the_forecast_is_known(passage: Passage) -> None:
    end = passage.departure + timedelta(hours=10)
    series = series_of(replace(passage, forecast=replace(passage.forecast, valid_to=end)), None)
    assert not series.at(end - timedelta(hours=1)).beyond_forecast
    assert series.at(end + timedelta(hours=1)).beyond_forecast
    assert moment_words(series.at(end + timedelta(hours=1)))[-1] == "after the end of the forecast"


def test_time_runs_evenly_and_both_ways(passage: Passage, app: QApplication) -> None:
    series = series_of(passage, None)
    frame = frame_of(series, QRectF(0, 0, 800, 200), app.font())
    for share in (0.0, 0.3, 1.0):
        time = series.begin + share * (series.end - series.begin)
        assert frame.time(frame.x(time)) == pytest.approx(time, abs=1.0)
    assert frame.time(-50.0) == pytest.approx(series.begin, abs=1.0)
    assert frame.time(5000.0) == pytest.approx(series.end, abs=1.0)


# --- the picture ----------------------------------------------------------------------------------------


def test_it_is_drawn_once_and_kept(meteogram: Meteogram, passage: Passage) -> None:
    picture_of(meteogram)
    kept = meteogram._kept
    meteogram.show_time(passage.departure + timedelta(hours=3))
    picture_of(meteogram)
    assert meteogram._kept is kept
    meteogram.resize(700, 220)
    picture_of(meteogram)
    assert meteogram._kept is not kept


@pytest.mark.parametrize("light", ["day", "dusk", "night"])
def test_every_light_has_a_picture_of_its_own(meteogram: Meteogram, light: str) -> None:
    meteogram.show_light("dusk" if light != "dusk" else "day")
    before = picture_of(meteogram)
    meteogram.show_light(light)
    assert picture_of(meteogram) != before


def test_gusts_waves_units_and_the_end_of_the_forecast_are_seen(
    meteogram: Meteogram, passage: Passage, rough_sea: Wind, units: None
) -> None:
    pictures = [picture_of(meteogram)]
    meteogram.show_passage(passage, replace(rough_sea, gust=None))
    pictures.append(picture_of(meteogram))
    meteogram.show_passage(passage, veering_wind())
    pictures.append(picture_of(meteogram))
    units_choice().choose(wind="Bft")
    pictures.append(picture_of(meteogram))
    early = replace(passage.forecast, valid_to=passage.departure + timedelta(hours=8))
    meteogram.show_passage(replace(passage, forecast=early), None)
    pictures.append(picture_of(meteogram))
    assert all(a != b for n, a in enumerate(pictures) for b in pictures[:n])


def test_without_a_passage_nothing_is_drawn_or_said(meteogram: Meteogram, qtbot: QtBot) -> None:
    meteogram.show_passage(None)
    assert meteogram.words() == ""
    assert meteogram.moment is None
    with qtbot.assertNotEmitted(meteogram.moment_chosen):
        QTest.keyClick(meteogram, Qt.Key.Key_Right)
        QTest.mouseClick(meteogram, Qt.MouseButton.LeftButton, pos=QPoint(300, 80))
    picture_of(meteogram)


# --- moving ---------------------------------------------------------------------------------------------


def test_keys_go_through_the_passage(meteogram: Meteogram, passage: Passage, qtbot: QtBot) -> None:
    chosen: list[datetime] = []
    meteogram.moment_chosen.connect(chosen.append)
    meteogram.show_time(passage.departure)
    for key in (Qt.Key.Key_Right, Qt.Key.Key_PageDown, Qt.Key.Key_Left, Qt.Key.Key_End, Qt.Key.Key_Home):
        QTest.keyClick(meteogram, key)
    minutes = [round((moment - passage.departure).total_seconds() / 60.0) for moment in chosen]
    whole = round(passage.duration_h * 60.0)
    assert minutes == [6, 66, 60, whole, 0]


def test_a_click_and_a_drag_choose_a_moment(meteogram: Meteogram, passage: Passage, qtbot: QtBot) -> None:
    with qtbot.waitSignal(meteogram.moment_chosen) as signal:
        QTest.mouseClick(meteogram, Qt.MouseButton.LeftButton, pos=QPoint(450, 80))
    share = (signal.args[0] - passage.departure) / (passage.arrival - passage.departure)
    assert share == pytest.approx(0.5, abs=0.01)
    QTest.mouseClick(meteogram, Qt.MouseButton.LeftButton, pos=QPoint(2, 80))
    assert meteogram.moment is not None
    assert meteogram.moment.time == passage.departure


def test_a_tip_tells_what_is_under_the_pointer(meteogram: Meteogram, monkeypatch: pytest.MonkeyPatch) -> None:
    said: list[str] = []
    monkeypatch.setattr(QToolTip, "showText", lambda _at, text, _widget: said.append(text))
    at = QPointF(450, 80)
    event = QHelpEvent(QEvent.Type.ToolTip, at.toPoint(), meteogram.mapToGlobal(at).toPoint())
    QApplication.sendEvent(meteogram, event)
    (text,) = said
    assert text.startswith("Mon ")
    for word in ("wind ", "gusts ", "kn, TWA ", "waves 1.5 m"):
        assert word in text


def test_a_screen_reader_hears_the_moment(meteogram: Meteogram, passage: Passage) -> None:
    meteogram.show_time(passage.departure)
    first = meteogram.accessibleDescription()
    assert first.startswith("Sun 06:00, wind ")
    meteogram.show_time(passage.departure + timedelta(hours=20))
    assert meteogram.accessibleDescription() != first
    assert meteogram.accessibleName()


# --- the log's words ------------------------------------------------------------------------------------


def test_the_window_knows_every_sentence_of_the_log() -> None:
    plurals = {"{n} tacks", "{n} gybes"}
    assert set(SENTENCES) == set(TEMPLATES) - plurals


def test_the_window_tells_the_log_as_files_do(passage: Passage, app: QApplication) -> None:
    for entry in tell(passage):
        if entry.kind not in {"beat", "run"}:
            assert entry_text(entry) == say(entry.phrase)
    assert entry_time(tell(passage)[0]) == "Sun 06:00"


def test_the_log_is_told_in_the_units_that_were_chosen(passage: Passage, units: None) -> None:
    first, *_, last = tell(passage)
    units_choice().choose(wind="Bft", distance="km")
    assert " Bft" in entry_text(first)
    assert entry_text(last).endswith(" km.")


# --- the pane -------------------------------------------------------------------------------------------


def test_before_there_is_a_passage_each_tab_says_what_it_will_have(pane: PassagePane) -> None:
    said = set()
    for name in PAGES:
        pane.show_page(name)
        assert pane.stack.currentWidget() is pane.empty
        said.add(pane.empty.text())
    assert len(said) == 3
    assert pane.maximumHeight() < 120


def test_each_tab_shows_the_passage(pane: PassagePane, passage: Passage) -> None:
    pane.show_answer(answer_of(passage))
    for name, page in zip(PAGES, (pane.legs, pane.meteogram, pane.log), strict=True):
        pane.show_page(name)
        assert pane.stack.currentWidget() is page
    assert pane.legs.legs.rowCount() == len(passage.waypoints)
    assert pane.log.log.rowCount() == len(tell(passage, wind=veering_wind()))
    assert pane.maximumHeight() > 1000


def test_only_the_page_that_is_seen_is_written(pane: PassagePane, passage: Passage) -> None:
    pane.show_page("log")
    pane.show_answer(answer_of(passage))
    assert pane.legs.legs.rowCount() == 0
    pane.show_page("legs")
    assert pane.legs.legs.rowCount() == len(passage.waypoints)


def test_slider_and_tables_are_at_the_same_place(pane: PassagePane, passage: Passage) -> None:
    pane.show_answer(answer_of(passage))
    pane.show_time(passage.waypoints[3].time + timedelta(minutes=10))
    assert pane.legs.currentIndex().row() == 3
    pane.show_page("log")
    pane.show_time(passage.arrival)
    assert pane.log.currentIndex().row() == pane.log.log.rowCount() - 1
    assert pane.now.text().startswith("Mon ") or pane.now.text().startswith("Tue ")


def test_what_is_said_of_the_moment_is_never_cut_without_a_sign(
    pane: PassagePane, passage: Passage, qtbot: QtBot
) -> None:
    pane.show_answer(answer_of(passage))
    whole = pane.now.text()
    pane.resize(520, 300)
    pane.show()
    qtbot.waitExposed(pane)
    assert pane.now.shown.endswith("…")
    assert pane.now.toolTip() == whole
    pane.resize(1500, 300)
    qtbot.waitUntil(lambda: pane.now.shown == whole, timeout=2_000)
    assert not pane.now.toolTip()


def test_an_entry_of_the_log_leads_to_its_moment(pane: PassagePane, passage: Passage, qtbot: QtBot) -> None:
    pane.show_answer(answer_of(passage))
    pane.show_page("log")
    with qtbot.waitSignal(pane.moment_chosen) as signal:
        pane.log.choose(4)
    assert signal.args == [pane.log.log.entries[4].time]


def test_a_leg_that_was_chosen_moves_on_with_the_slider(pane: PassagePane, passage: Passage) -> None:
    told: list[int] = []
    pane.leg_chosen.connect(told.append)
    pane.show_answer(answer_of(passage))
    pane.show_time(passage.waypoints[2].time)
    assert told == []
    pane.choose_leg(3)
    pane.show_time(passage.waypoints[5].time)
    assert told == [3, 5]


def test_a_leg_picked_on_the_chart_is_chosen_on_any_page(
    pane: PassagePane, passage: Passage, qtbot: QtBot
) -> None:
    pane.show_answer(answer_of(passage))
    pane.show_page("weather")
    with qtbot.waitSignals([pane.leg_chosen, pane.moment_chosen]):
        pane.choose_leg(2)


def test_it_is_folded_away_and_remembered(pane: PassagePane, passage: Passage, qtbot: QtBot) -> None:
    pane.show_answer(answer_of(passage))
    pane.show_page("weather")
    QTest.mouseClick(pane.fold_button, Qt.MouseButton.LeftButton)
    assert pane.is_folded
    assert pane.maximumHeight() < 60
    kept = json.loads(json.dumps(pane.contents()))
    other = PassagePane()
    qtbot.addWidget(other)
    other.restore(kept)
    assert (other.is_folded, other.page) == (True, "weather")
    other.show_page("log")
    assert (other.is_folded, other.page) == (False, "log")
    other.restore({"page": 7, "folded": "yes", "height": "tall"})
    assert other.page == "log"


# --- in the window --------------------------------------------------------------------------------------


def test_chart_slider_and_pages_point_at_each_other(answered: MainWindow, passage: Passage) -> None:
    bar, pane = answered.chart.time_bar, answered.pane
    bar.set_moment(passage.waypoints[4].time)
    assert pane.legs.currentIndex().row() == 4
    pane.show_page("weather")
    pane.meteogram.moment_chosen.emit(passage.waypoints[2].time)
    assert abs(bar.moment - passage.waypoints[2].time) < timedelta(minutes=1)
    pane.show_page("legs")
    assert pane.legs.currentIndex().row() == 2
    answered.chart.view.leg_picked.emit(5)
    assert abs(bar.moment - passage.waypoints[5].time) < timedelta(minutes=1)
    assert answered.chart.view.route._leg == 5


def test_keys_open_the_tabs(answered: MainWindow, qtbot: QtBot) -> None:
    answered.menus.layers["legs"].setChecked(False)
    assert answered.pane.isHidden()
    for key, name in ((Qt.Key.Key_2, "weather"), (Qt.Key.Key_3, "log"), (Qt.Key.Key_1, "legs")):
        QTest.keyClick(answered, key, Qt.KeyboardModifier.AltModifier)
        assert answered.pane.isVisible()
        assert answered.pane.page == name


def test_the_pane_takes_its_room_only_when_it_has_something_to_show(
    window: MainWindow, planner: HeldPlanner, qtbot: QtBot
) -> None:
    assert window.pane.isVisible()
    assert window.pane.height() < 120
    planner.gate.set()
    with qtbot.waitSignal(window.settled, timeout=20_000):
        window.calculate()
    qtbot.waitUntil(lambda: 180 < window.pane.height() < 260)
    window.splitter.setSizes([400, 300])
    qtbot.waitUntil(lambda: window.pane.height() > 240)
    own = window.pane.height()
    window.pane.fold(folded=True)
    qtbot.waitUntil(lambda: window.pane.height() < 60)
    window.pane.fold(folded=False)
    qtbot.waitUntil(lambda: window.pane.height() == own)


def test_folded_away_while_it_is_empty_it_comes_back(window: MainWindow, qtbot: QtBot) -> None:
    whole = window.pane.height()
    window.pane.fold(folded=True)
    qtbot.waitUntil(lambda: window.pane.height() < whole)
    window.pane.fold(folded=False)
    qtbot.waitUntil(lambda: window.pane.height() == whole)


def test_after_a_restart_the_chart_has_what_the_empty_pane_does_not_need(
    make_window: Callable[..., MainWindow], planner: HeldPlanner, settings: Settings, qtbot: QtBot
) -> None:
    first = make_window(memory=WindowMemory(settings.data_dir))
    planner.gate.set()
    with qtbot.waitSignal(first.settled, timeout=20_000):
        first.calculate()
    first.splitter.setSizes([300, 360])
    qtbot.waitUntil(lambda: first.pane.height() > 300)
    first.close()
    memory = WindowMemory(settings.data_dir)
    second = make_window(memory=memory, fill=False)
    memory.restore_geometry(second, second.splitter)
    qtbot.waitUntil(lambda: second.splitter.sizes()[1] == second.pane.height() < 120)
    second.resize(1000, 700)
    qtbot.waitUntil(lambda: second.splitter.height() < 700)
    assert second.splitter.sizes()[1] == second.pane.height() < 120
    with qtbot.waitSignal(second.settled, timeout=20_000):
        second.calculate()
    qtbot.waitUntil(lambda: second.pane.height() > 240)


def test_the_tab_is_kept_for_the_next_start(
    make_window: Callable[..., MainWindow], settings: Settings, qtbot: QtBot
) -> None:
    first = make_window(memory=WindowMemory(settings.data_dir))
    first.pane.show_page("log")
    first.close()
    again = make_window(memory=WindowMemory(settings.data_dir))
    assert again.pane.page == "log"
