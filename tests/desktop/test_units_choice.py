"""The units that the window speaks in: converted where words are made, and nowhere else."""

from __future__ import annotations

import json
import os
import time
from collections.abc import Callable, Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise.desktop import units_choice as units
from seacruise.desktop.chart.schemes import SCHEMES
from seacruise.desktop.departure_field import DepartureField
from seacruise.desktop.memory import WindowMemory
from seacruise.desktop.number_box import NumberBox
from seacruise.desktop.readout import bearing_text, wind_text
from seacruise.desktop.units_choice import Units, units_choice
from seacruise.desktop.window import MainWindow
from tests.passages import veering_wind

OTHERS = {"wind": "m/s", "distance": "km", "height": "ft", "clock": "local"}
MOMENT = datetime(2016, 11, 20, 6, tzinfo=UTC)


@pytest.fixture(autouse=True)
def defaults() -> Iterator[None]:
    yield
    units_choice().choose(wind="kn", distance="nm", height="m", clock="utc")


@pytest.fixture
def in_warsaw(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    if not hasattr(time, "tzset"):
        pytest.skip("this system has no time zone that a program can set")
    monkeypatch.setenv("TZ", "CET-1CEST,M3.5.0,M10.5.0/3")
    time.tzset()
    yield
    os.environ.pop("TZ", None)
    time.tzset()


# --- words -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("unit", "text"), [("kn", "14 kn"), ("m/s", "7 m/s"), ("Bft", "4 Bft")], ids=["kn", "ms", "bft"]
)
def test_wind(unit: str, text: str) -> None:
    units_choice().choose(wind=unit)
    assert units.wind_text(14.4) == text
    assert units.wind_number(14.4) + " " + units.wind_unit() == text


def test_distances_and_heights() -> None:
    assert units.distance_text(123.44) == "123.4 nm"
    assert units.height_text(2.0) == "2.0 m"
    units_choice().choose(distance="km", height="ft")
    assert units.distance_text(100.0) == "185.2 km"
    assert units.height_text(2.0) == "7 ft"


def test_a_thousand_is_written_as_the_core_writes_it() -> None:
    assert units.distance_text(1234.5) == "1234.5 nm"


def test_times_of_the_computer_have_their_offset(in_warsaw: None) -> None:
    assert units.moment_text(MOMENT) == "Sun 20 Nov 2016 06:00 UTC"
    units_choice().choose(clock="local")
    assert units.moment_text(MOMENT) == "Sun 20 Nov 2016 07:00 UTC+1"
    assert units.zone_text(datetime(2016, 7, 1, tzinfo=UTC)) == "UTC+2"
    assert units.short_moment(datetime(2016, 11, 20, 23, 30, tzinfo=UTC)) == "21 Nov 00:30"


@given(st.integers(0, 70 * 365 * 24).map(lambda hours: MOMENT + timedelta(hours=hours)))
def test_what_is_read_off_is_the_moment_again(moment: datetime) -> None:
    shown = units.in_zone(moment)
    assert units.from_zone(shown.replace(tzinfo=None)) == moment


# --- the choice ------------------------------------------------------------------------------------------


def test_what_cannot_be_chosen_changes_nothing(qtbot: QtBot) -> None:
    with qtbot.assertNotEmitted(units_choice().changed):
        units_choice().restore({"wind": "furlongs", "distance": 5, "height": None, "clock": "m", "beer": "l"})
    assert units_choice().units == Units()


def test_the_menu_chooses(window: MainWindow, qtbot: QtBot) -> None:
    entries = {a.data(): a for a in window.menus.units.actions() if a.data()}
    assert [unit for unit, action in entries.items() if action.isChecked()] == ["kn", "nm", "m", "utc"]
    with qtbot.waitSignal(units_choice().changed):
        entries["m/s"].trigger()
    assert units_choice().units.wind == "m/s"
    assert entries["m/s"].isChecked()
    assert not entries["kn"].isChecked()


def test_the_choice_outlives_the_window(make_window: Callable[..., MainWindow], tmp_path: Path) -> None:
    first = make_window(memory=WindowMemory(tmp_path))
    units_choice().choose(**OTHERS)
    first.close()
    units_choice().choose(wind="kn", distance="nm", height="m", clock="utc")
    make_window(memory=WindowMemory(tmp_path))
    assert units_choice().contents() == OTHERS
    assert json.loads(json.dumps(units_choice().contents())) == OTHERS


def test_the_chart_speaks_so(window: MainWindow) -> None:
    wind = veering_wind()
    moment, lat, lon = wind.forecast.valid_from.timestamp(), 57.0, 18.5
    assert wind_text(wind, moment, lat, lon).endswith(" kn")
    assert bearing_text(55.0, 18.0, 56.0, 18.0).startswith("60.0 nm")
    units_choice().choose(wind="m/s", distance="km")
    assert wind_text(wind, moment, lat, lon).endswith(" m/s")
    assert bearing_text(55.0, 18.0, 56.0, 18.0).startswith("111.")


def test_the_sliders_speak_so_at_once(answered: MainWindow, in_warsaw: None) -> None:
    bar = answered.chart.time_bar
    assert bar.label.text().startswith("Sun 20 Nov 06:00 UTC ")
    units_choice().choose(clock="local")
    assert bar.label.text().startswith("Sun 20 Nov 07:00 UTC+1 ")
    assert bar.departure_label.text() == "Sun 20 Nov 07:00 UTC+1"


# --- fields ----------------------------------------------------------------------------------------------


def test_a_departure_is_typed_in_the_time_shown(app: QApplication, qtbot: QtBot, in_warsaw: None) -> None:
    field = DepartureField()
    qtbot.addWidget(field)
    field.set_moment(MOMENT, chosen=True)
    units_choice().choose(clock="local")
    assert field.moment == MOMENT
    assert field.time_edit.time().hour() == 7
    assert "UTC+1" in field.range_label.text()
    field.time_edit.setTime(field.time_edit.time().addSecs(3600))
    assert field.moment == datetime(2016, 11, 20, 7, tzinfo=UTC)
    assert field.was_chosen


@pytest.mark.parametrize(
    ("kind", "unit", "typed", "value"),
    [
        ("wind", {"wind": "m/s"}, "13", 25.27),
        ("wind", {"wind": "Bft"}, "13", 13.0),
        ("distance", {"distance": "km"}, "9.26", 5.0),
        ("height", {"height": "ft"}, "50", 15.24),
    ],
)
def test_a_limit_is_typed_in_the_unit_shown(
    app: QApplication, qtbot: QtBot, kind: str, unit: dict[str, str], typed: str, value: float
) -> None:
    box = NumberBox(0.0, 30.0, none="none", kind=kind)  # type: ignore[arg-type]
    qtbot.addWidget(box)
    units_choice().choose(**unit)
    box.selectAll()
    QTest.keyClicks(box.lineEdit(), typed)
    box.interpretText()
    assert box.value() == pytest.approx(value, abs=0.01)
    shown, before = box.text(), box.value()
    box.interpretText()
    assert (box.text(), box.value()) == (shown, before)


@given(st.floats(0.01, 200.0))
def test_to_look_at_a_limit_in_another_unit_does_not_change_it(qapp: QApplication, value: float) -> None:
    box = NumberBox(0.0, 200.0, kind="wind")
    box.setValue(value)
    before = box.value()
    units_choice().choose(wind="m/s")
    box.interpretText()
    assert box.value() == before
    units_choice().choose(wind="kn")
    assert box.value() == before
    box.deleteLater()


# --- the chart -------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("unit", "first", "last"), [("kn", "< 5", "> 30"), ("m/s", "< 3", "> 15"), ("Bft", "< 2", "> 7")]
)
def test_the_legend_speaks_so(unit: str, first: str, last: str) -> None:
    units_choice().choose(wind=unit)
    scheme = SCHEMES["tws"]
    assert unit in scheme.title()
    assert (scheme.names()[0], scheme.names()[-1]) == (first, last)
    assert SCHEMES["speed"].title() == "Boat speed (kn)"


@pytest.mark.parametrize("unit", ["kn", "m/s", "Bft"])
def test_a_scale_of_the_wind_has_its_figures_in_place(unit: str) -> None:
    units_choice().choose(wind=unit)
    ticks = units.wind_ticks(60.0)
    assert 4 <= len(ticks) <= 8
    for knots, figure in ticks:
        assert 0.0 <= knots < 60.0
        assert units.wind_number(knots) == figure


def test_sunrise_is_told_in_the_time_shown(answered: MainWindow, in_warsaw: None) -> None:
    route = answered.chart.view.route
    before = [text for _, text, _ in route._suns]
    units_choice().choose(clock="local")
    after = [text for _, text, _ in route._suns]
    assert before
    assert len(after) == len(before)
    hours = [int(text.split()[-1][:2]) for text in (*before, *after)]
    assert [(hour + 1) % 24 for hour in hours[: len(before)]] == hours[len(before) :]
