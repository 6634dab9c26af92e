from __future__ import annotations

from collections.abc import Iterator
from datetime import UTC, datetime, timedelta

import pytest
from PySide6.QtCore import QDate, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise.desktop.departure_field import DepartureField
from seacruise.desktop.form import PassageForm
from seacruise.desktop.port_field import PortField
from seacruise.desktop.state import Horizon
from seacruise.errors import InputError
from seacruise.ports import load_ports
from seacruise.resources import resource_path
from seacruise.yacht.fleet import load_fleet

NOW = datetime(2016, 11, 20, 9, 20, tzinfo=UTC)
HORIZON = Horizon(datetime(2016, 11, 20, tzinfo=UTC), datetime(2016, 11, 22, tzinfo=UTC))


@pytest.fixture
def field(app: QApplication, qtbot: QtBot) -> Iterator[PortField]:
    field = PortField()
    qtbot.addWidget(field)
    field.set_ports(load_ports())
    field.show()
    yield field
    field.popup.hide()


@pytest.fixture
def departure(app: QApplication, qtbot: QtBot) -> DepartureField:
    field = DepartureField()
    qtbot.addWidget(field)
    field.show()
    field.set_horizon(HORIZON, NOW)
    return field


@pytest.fixture
def form(app: QApplication, qtbot: QtBot) -> PassageForm:
    form = PassageForm()
    qtbot.addWidget(form)
    form.set_ports(load_ports())
    form.set_yachts(load_fleet([resource_path("polars")]).yachts, "Bavaria 46 Cruiser")
    form.departure.set_horizon(HORIZON, NOW)
    form.fill({"start": "Gdynia", "end": "Stockholm"})
    form.show()
    return form


# --- ports ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("typed", "name"),
    [("swinou", "Świnoujście"), ("KLAIP", "Klaipėda"), ("Kopenh", "København"), ("gdyn", "Gdynia")],
)
def test_ports_are_offered_as_one_types(field: PortField, typed: str, name: str) -> None:
    QTest.keyClicks(field, typed)
    assert any(offered.startswith(name) for offered in field.offered)


def test_the_offer_is_taken_with_the_keys(field: PortField, qtbot: QtBot) -> None:
    QTest.keyClicks(field, "swinou")
    popup = field.popup
    qtbot.waitUntil(popup.isVisible)
    QTest.keyClick(popup, Qt.Key.Key_Down)
    QTest.keyClick(popup, Qt.Key.Key_Return)
    assert field.text() == "Świnoujście"
    assert field.port is not None


def test_a_known_name_without_diacritics_is_written_out(field: PortField) -> None:
    field.setText("swinoujscie")
    field.editingFinished.emit()
    assert field.text() == "Świnoujście"


def test_a_position_is_a_port(field: PortField) -> None:
    field.set_position(55.5, 18.25)
    assert field.port is not None
    assert (field.port.lat, field.port.lon) == pytest.approx((55.5, 18.25), abs=1e-3)


def test_an_unknown_port_is_said_to_be_so(field: PortField) -> None:
    field.setText("Atlantis")
    field.editingFinished.emit()
    assert field.port is None
    assert field.property("wrong") is True
    with pytest.raises(InputError, match="Atlantis"):
        field.require_port()


# --- departure -----------------------------------------------------------------------------------------


def test_the_calendar_offers_the_days_of_the_forecast_only(departure: DepartureField) -> None:
    assert departure.calendar.minimumDate() == QDate(2016, 11, 20)
    assert departure.calendar.maximumDate() == QDate(2016, 11, 22)


def test_the_default_is_the_next_full_hour(departure: DepartureField) -> None:
    assert departure.moment == datetime(2016, 11, 20, 10, tzinfo=UTC)
    assert not departure.was_chosen


def test_the_range_stands_beside_it(departure: DepartureField) -> None:
    text = departure.range_label.text()
    assert "20 Nov 2016 00:00" in text
    assert "22 Nov 2016 00:00" in text


def test_a_typed_date_beyond_the_forecast_is_kept_and_refused(departure: DepartureField) -> None:
    departure.date_edit.setDate(QDate(2026, 12, 25))
    assert departure.date_edit.date() == QDate(2026, 12, 25)
    assert departure.range_label.objectName() == "fault"
    with pytest.raises(InputError, match="25 Dec 2026") as refusal:
        departure.require_moment()
    assert refusal.value.reason == "departure"
    departure.use_first_hour(NOW)
    assert departure.require_moment() == datetime(2016, 11, 20, 10, tzinfo=UTC)


def test_a_chosen_departure_survives_another_forecast(departure: DepartureField) -> None:
    departure.set_moment(datetime(2016, 11, 21, 6, tzinfo=UTC), chosen=True)
    later = Horizon(HORIZON.first + timedelta(days=30), HORIZON.last + timedelta(days=30))
    departure.set_horizon(later, NOW)
    assert departure.moment == datetime(2016, 11, 21, 6, tzinfo=UTC)
    assert departure.range_label.objectName() == "fault"


def test_a_departure_nobody_chose_follows_the_forecast(departure: DepartureField) -> None:
    later = Horizon(HORIZON.first + timedelta(days=30), HORIZON.last + timedelta(days=30))
    departure.set_horizon(later, NOW)
    assert departure.moment == later.first


def test_a_time_with_an_offset_is_shown_in_utc(departure: DepartureField) -> None:
    departure.set_moment(datetime.fromisoformat("2016-11-21T01:00+02:00"), chosen=True)
    assert departure.time_edit.time().hour() == 23
    assert departure.date_edit.date() == QDate(2016, 11, 20)


def test_a_day_is_picked_in_the_calendar(departure: DepartureField) -> None:
    departure.calendar_button.click()
    assert departure.popup.isVisible()
    ink = {
        day: departure.calendar.dateTextFormat(QDate(2016, 11, day)).foreground().color().name()
        for day in (18, 21, 24)
    }
    assert ink[18] == ink[24] != ink[21], "days without a forecast are grey"
    departure.calendar.clicked.emit(QDate(2016, 11, 21))
    assert not departure.popup.isVisible()
    assert departure.moment == datetime(2016, 11, 21, 10, tzinfo=UTC)
    assert departure.was_chosen


# --- form ----------------------------------------------------------------------------------------------


def test_the_form_asks_what_it_shows(form: PassageForm) -> None:
    form.fill({"forecast": ["sample"], "percent_of_polar": 90.0, "directions": 24, "max_wind_kn": 25.0})
    question = form.question()
    assert (question.start.name, question.end.name) == ("Gdynia", "Stockholm")
    assert question.departure == datetime(2016, 11, 20, 10, tzinfo=UTC)
    assert question.yacht.name == "Bavaria 46 Cruiser"
    assert question.forecast == ("sample",)
    options = question.options
    assert (options.percent_of_polar, options.directions, options.max_wind_kn) == (90.0, 24, 25.0)
    assert options.motor_below_kn is None


def test_what_is_changed_in_the_form_counts(form: PassageForm) -> None:
    form.fill({"max_wind_kn": 25.0})
    form.max_wind_box.setValue(0.0)
    form.use_engine()
    assert form.options().max_wind_kn is None
    assert form.options().motor_below_kn == 3.0


def test_ends_are_swapped(form: PassageForm) -> None:
    form.swap_button.click()
    assert {which: port.name for which, port in form.ends.items()} == {"from": "Stockholm", "to": "Gdynia"}


def test_the_same_port_twice_is_refused(form: PassageForm) -> None:
    form.end_field.setText("gdynia")
    with pytest.raises(InputError, match="both the start and the end") as refusal:
        form.question()
    assert refusal.value.reason == "same-port"


def test_a_wrong_port_gets_the_focus(form: PassageForm, qtbot: QtBot) -> None:
    form.activateWindow()
    form.end_field.setText("Atlantis")
    with pytest.raises(InputError):
        form.question()
    assert form.focusWidget() is form.end_field


def test_a_file_gets_an_entry_of_its_own(form: PassageForm, qtbot: QtBot) -> None:
    with qtbot.waitSignal(form.forecast_changed):
        form.set_forecast(("gfs.grib2", "icon.grib2"))
    assert form.forecast_box.currentText() == "gfs.grib2, icon.grib2"
    assert form.forecast == ("gfs.grib2", "icon.grib2")


def test_it_remembers_everything_but_the_departure(form: PassageForm, app: QApplication) -> None:
    form.fill({"forecast": ["practice"], "motor_below_kn": 2.5})
    kept = form.contents()
    other = PassageForm()
    other.restore(kept)
    assert other.contents() == kept
    assert "depart" not in kept


def test_a_damaged_memory_fills_in_what_it_can(app: QApplication) -> None:
    form = PassageForm()
    form.restore(
        {
            "start": "Visby",
            "end": 5,
            "yacht": ["Carter 30"],
            "forecast": 7,
            "directions": "x",
            "percent_of_polar": "abc",
            "max_wind_kn": None,
            "motor_below_kn": 2.5,
        }
    )
    assert (form.start_field.text(), form.end_field.text(), form.wanted_yacht) == ("Visby", "", "")
    assert form.forecast == ("auto",)
    options = form.options()
    assert (options.directions, options.percent_of_polar, options.motor_below_kn) == (None, 100.0, 2.5)


def test_every_field_has_a_name_for_those_who_cannot_see_it(form: PassageForm) -> None:
    fields = (
        *(form.start_field, form.end_field, form.yacht_box, form.forecast_box, form.swap_button),
        *(form.departure.date_edit, form.departure.time_edit, form.departure.calendar_button),
        *(form.percent_box, form.max_wind_box, form.motor_box),
    )
    assert all(field.accessibleName() for field in fields)


def test_the_offer_closes_when_the_name_is_complete(field: PortField, qtbot: QtBot) -> None:
    popup = field.popup
    QTest.keyClicks(field, "visb")
    qtbot.waitUntil(popup.isVisible)
    QTest.keyClicks(popup, "y")
    assert field.port is not None
    assert not popup.isVisible()


def test_the_focus_goes_from_calculate_to_cancel_and_back(form: PassageForm, qtbot: QtBot) -> None:
    form.activateWindow()
    form.calculate_button.setFocus()
    form.set_running(running=True)
    assert form.focusWidget() is form.cancel_button
    form.set_running(running=False)
    assert form.focusWidget() is form.calculate_button
