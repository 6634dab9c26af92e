"""The form: from where to where, when, with which yacht, by which forecast, and how she is sailed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import (
    QComboBox,
    QDoubleSpinBox,
    QFileDialog,
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from seacruise.desktop.banner import text_label
from seacruise.desktop.compute import Question, refuse_same_port
from seacruise.desktop.departure_field import DepartureField
from seacruise.desktop.pages.reach_model import Outset
from seacruise.desktop.port_field import PortField
from seacruise.desktop.style import scaled_font, show_icon
from seacruise.errors import InputError
from seacruise.passage import Options
from seacruise.ports import Port

if TYPE_CHECKING:
    from seacruise.yacht.polar import Polar

FILE_TYPES: Final = "GRIB, NetCDF (*.grib *.grib2 *.grb *.grb2 *.nc *.nc4);;* (*)"
_CHOOSE_FILE: Final = "choose-file"
_KINDS: Final[dict[str, type | tuple[type, ...]]] = {
    **dict.fromkeys(("start", "end", "yacht"), str),
    **dict.fromkeys(("forecast", "weights"), list),
    **dict.fromkeys(("percent_of_polar", "max_wind_kn", "motor_below_kn"), (int, float)),
}
"""What a window keeps of its form, and of which kind it is."""


class PassageForm(QFrame):
    """The passage form.

    Signals: ``submitted()`` and ``cancelled()`` by its buttons, ``ends_changed()`` when a port changes,
    ``forecast_changed()`` when another forecast is chosen, ``sailing_changed()`` when the sailor changes
    departure, yacht or options.
    """

    submitted = Signal()
    cancelled = Signal()
    ends_changed = Signal()
    forecast_changed = Signal()
    sailing_changed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("card")
        self._yachts: dict[str, Polar] = {}
        self._wanted_yacht = ""
        self._options = Options()
        self._forecast: tuple[str, ...] = ("auto",)
        self._weights: tuple[float, ...] = ()
        self.start_field, self.end_field = PortField(self), PortField(self)
        self.departure = DepartureField(self)
        self.yacht_box, self.forecast_box = QComboBox(self), QComboBox(self)
        self._make_buttons()
        self._make_options()
        self._lay_out()
        self._fill_forecasts()
        self.yacht_box.setPlaceholderText(self.tr("Loading the yachts…"))
        self.yacht_box.setMaxVisibleItems(18)
        for field in (self.start_field, self.end_field):
            field.port_changed.connect(self.ends_changed)
        self.start_field.setPlaceholderText(self.tr("Port, or 54.5, 18.6"))
        self.end_field.setPlaceholderText(self.tr("Port, or 59.3, 18.1"))
        self.forecast_box.activated.connect(self._forecast_picked)
        self.yacht_box.activated.connect(self._yacht_picked)
        self.yacht_box.activated.connect(self.sailing_changed)
        for box in (self.percent_box, self.max_wind_box, self.motor_box):
            box.valueChanged.connect(self.sailing_changed)
        self.departure.changed.connect(self._departure_changed)

    # --- building -----------------------------------------------------------------------------------

    def _make_buttons(self) -> None:
        self.swap_button = QToolButton(self)
        show_icon(self.swap_button, "swap")
        self.swap_button.setIconSize(QSize(18, 18))
        self.swap_button.setToolTip(self.tr("Swap start and end"))
        self.swap_button.setAccessibleName(self.tr("Swap start and end"))
        self.swap_button.clicked.connect(self.swap_ends)
        self.calculate_button = QPushButton(self.tr("&Calculate"), self)
        self.calculate_button.setObjectName("primary")
        self.calculate_button.setMinimumHeight(36)
        self.calculate_button.setToolTip(self.tr("Ctrl+Enter"))
        self.calculate_button.clicked.connect(self.submitted)
        self.cancel_button = QPushButton(self.tr("Cancel"), self)
        self.cancel_button.setMinimumHeight(36)
        self.cancel_button.setToolTip(self.tr("Esc"))
        self.cancel_button.clicked.connect(self.cancelled)
        self.set_running(running=False)

    def _make_options(self) -> None:
        self.options_box = QWidget(self)
        self.more_button = QPushButton(self)
        self.more_button.setObjectName("flat")
        self.more_button.clicked.connect(lambda: self.show_options(shown=self.options_box.isHidden()))
        self.percent_box = self._number(30.0, 150.0, " %", step=5.0, value=100.0)
        self.max_wind_box = self._number(0.0, 100.0, " kn", step=1.0, none=self.tr("no limit"))
        self.motor_box = self._number(0.0, 20.0, " kn", step=0.5, none=self.tr("never"))
        grid = QGridLayout(self.options_box)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setColumnStretch(0, 1)
        for row, (text, box) in enumerate(
            (
                (self.tr("Crew sails at"), self.percent_box),
                (self.tr("Most wind (TWS)"), self.max_wind_box),
                (self.tr("Motor when slower than"), self.motor_box),
            )
        ):
            label = QLabel(text, self.options_box)
            label.setObjectName("fieldName")
            label.setBuddy(box)
            box.setAccessibleName(text)
            grid.addWidget(label, row, 0)
            grid.addWidget(box, row, 1)
        self.show_options(shown=False)

    def _number(
        self, low: float, high: float, suffix: str, *, step: float, value: float = 0.0, none: str = ""
    ) -> QDoubleSpinBox:
        box = QDoubleSpinBox(self.options_box)
        box.setRange(low, high)
        box.setDecimals(1 if step < 1 else 0)
        box.setSingleStep(step)
        box.setSuffix(suffix)
        box.setSpecialValueText(none)
        box.setValue(value)
        box.setMinimumWidth(104)
        box.lineEdit().setTextMargins(5, 0, 0, 0)
        return box

    def _lay_out(self) -> None:
        title = QLabel(self.tr("Passage"), self)
        title.setFont(scaled_font(self.font(), 1.25, bold=True))
        ends = QGridLayout()
        ends.setHorizontalSpacing(8)
        ends.setVerticalSpacing(3)
        ends.addWidget(self._name(self.tr("&From"), self.start_field), 0, 0)
        ends.addWidget(self.start_field, 1, 0)
        ends.addWidget(self._name(self.tr("&To"), self.end_field), 2, 0)
        ends.addWidget(self.end_field, 3, 0)
        ends.addWidget(self.swap_button, 1, 1, 3, 1, Qt.AlignmentFlag.AlignVCenter)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 12, 16, 14)
        layout.setSpacing(8)
        layout.addWidget(title)
        layout.addLayout(ends)
        for text, field in (
            (self.tr("&Departure"), self.departure),
            (self.tr("&Yacht"), self.yacht_box),
            (self.tr("F&orecast"), self.forecast_box),
        ):
            column = QVBoxLayout()
            column.setSpacing(3)
            column.addWidget(self._name(text, field))
            column.addWidget(field)
            layout.addLayout(column)
        layout.addWidget(self.more_button, 0, Qt.AlignmentFlag.AlignLeft)
        layout.addWidget(self.options_box)
        buttons = QHBoxLayout()
        buttons.setSpacing(8)
        buttons.addWidget(self.calculate_button, 2)
        buttons.addWidget(self.cancel_button, 1)
        layout.addLayout(buttons)

    def _name(self, text: str, field: QWidget) -> QLabel:
        label = text_label(text, "fieldName", self)
        label.setTextFormat(Qt.TextFormat.AutoText)
        label.setBuddy(field)
        if not isinstance(field, DepartureField):
            field.setAccessibleName(text.replace("&", ""))
        return label

    def _fill_forecasts(self) -> None:
        for text, name in (
            (self.tr("Automatic"), "auto"),
            (self.tr("Storm Glass (needs a key)"), "stormglass"),
            (self.tr("Open-Meteo"), "open-meteo"),
            (self.tr("Open-Meteo ensemble"), "open-meteo-ensemble"),
            (self.tr("MET Norway"), "metno"),
            (self.tr("Practice weather (not a forecast)"), "practice"),
            (self.tr("Sample: 20–22 November 2016"), "sample"),
            (self.tr("GRIB or NetCDF file…"), _CHOOSE_FILE),
        ):
            self.forecast_box.addItem(text, (name,))

    # --- what is asked ------------------------------------------------------------------------------

    def question(self) -> Question:
        """Say what the form asks.

        Raises
        ------
        InputError
            What is wrong, and in which field; the field has the focus then.
        """
        ends = [_port_in(field) for field in (self.start_field, self.end_field)]
        refuse_same_port(*ends)
        return Question(
            start=ends[0],
            end=ends[1],
            departure=self.departure.require_moment(),
            yacht=self._yacht(),
            forecast=self._forecast,
            weights=self._weights,
            options=self.options(),
        )

    def outset(self) -> Outset:
        """Say what the form asks but for the end.

        Raises
        ------
        InputError
            What is wrong, and in which field; the field has the focus then.
        """
        return Outset(
            start=_port_in(self.start_field),
            departure=self.departure.require_moment(),
            yacht=self._yacht(),
            forecast=self._forecast,
            weights=self._weights,
            options=self.options(),
        )

    def _yacht(self) -> Polar:
        name = self.yacht_box.currentText()
        if name not in self._yachts:
            raise InputError(
                self.tr(
                    "There is no yacht yet; wait until they are loaded, or drop a polar file on the window."
                )
            )
        return self._yachts[name]

    def options(self) -> Options:
        """How to sail: the three boxes, and what the command line said besides."""
        return replace(
            self._options,
            percent_of_polar=self.percent_box.value(),
            max_wind_kn=self.max_wind_box.value() or None,
            motor_below_kn=self.motor_box.value() or None,
        )

    @property
    def forecast(self) -> tuple[str, ...]:
        """Chosen forecast, as on the command line."""
        return self._forecast

    @property
    def weights(self) -> tuple[float, ...]:
        """Weights of several forecasts in their mean; empty for equal ones."""
        return self._weights

    @property
    def ends(self) -> dict[str, Port]:
        """The ports that are named so far, ``"from"`` and ``"to"``."""
        fields = {"from": self.start_field, "to": self.end_field}
        return {which: field.port for which, field in fields.items() if field.port is not None}

    @property
    def is_answerable(self) -> bool:
        """Whether both ports and a yacht are named, and the forecast covers the departure."""
        return (
            len(self.ends) == 2 and self.yacht_box.currentText() in self._yachts and self.departure.is_covered
        )

    def set_end(self, which: str, port: Port) -> None:
        """Name an end, ``"from"`` or ``"to"``; a port without a name is a position."""
        field = self.start_field if which == "from" else self.end_field
        if port.name:
            field.setText(port.name)
        else:
            field.set_position(port.lat, port.lon)

    def contents(self) -> dict[str, object]:
        """Give what is worth keeping for the next start; a departure is not."""
        return {
            "start": self.start_field.text(),
            "end": self.end_field.text(),
            "yacht": self._wanted_yacht,
            "forecast": list(self._forecast),
            "weights": list(self._weights),
            "percent_of_polar": self.percent_box.value(),
            "max_wind_kn": self.max_wind_box.value(),
            "motor_below_kn": self.motor_box.value(),
        }

    # --- filling in ---------------------------------------------------------------------------------

    def fill(self, values: Mapping[str, Any]) -> None:
        """Fill in by the names of the command line's options; what is not there stays."""
        for key, field in (("start", self.start_field), ("end", self.end_field)):
            if key in values:
                field.setText(str(values[key]))
                field.setCursorPosition(0)
        if isinstance(depart := values.get("depart"), datetime):
            self.departure.set_moment(depart, chosen=True)
        if yacht := values.get("yacht"):
            self._wanted_yacht = str(yacht)
            if (at := self.yacht_box.findText(self._wanted_yacht)) >= 0:
                self.yacht_box.setCurrentIndex(at)
        if forecast := values.get("forecast"):
            names, weights = tuple(str(name) for name in forecast), tuple(values.get("weights") or ())
            fits = len(weights) == len(names) and all(isinstance(w, int | float) and w > 0 for w in weights)
            self.set_forecast(names, weights if fits else ())
        known = {field.name for field in fields(Options)}
        self._options = replace(self._options, **{k: v for k, v in values.items() if k in known})
        for key, box in (
            ("percent_of_polar", self.percent_box),
            ("max_wind_kn", self.max_wind_box),
            ("motor_below_kn", self.motor_box),
        ):
            if key in values:
                box.setValue(float(values[key] or 0.0))
        self._tell_options()

    def restore(self, kept: Mapping[str, Any]) -> None:
        """Fill in what `contents` gave; what is not of its kind, as in a damaged file, is passed over."""
        self.fill({key: value for key, value in kept.items() if isinstance(value, _KINDS.get(key, ()))})

    def set_ports(self, ports: Sequence[Port]) -> None:
        """Take the ports over."""
        self.start_field.set_ports(ports)
        self.end_field.set_ports(ports)

    def set_yachts(self, yachts: Mapping[str, Polar], chosen: str) -> None:
        """Take the yachts over, and choose one."""
        self._yachts = dict(yachts)
        self.yacht_box.clear()
        self.yacht_box.addItems(list(yachts))
        self.yacht_box.setCurrentIndex(max(self.yacht_box.findText(chosen), 0))
        self._wanted_yacht = self.yacht_box.currentText()

    @property
    def wanted_yacht(self) -> str:
        """The yacht that is chosen, or will be when the yachts are loaded."""
        return self._wanted_yacht

    def _departure_changed(self) -> None:
        # A departure that follows the clock is nobody's wish.
        if self.departure.was_chosen:
            self.sailing_changed.emit()

    def _yacht_picked(self) -> None:
        self._wanted_yacht = self.yacht_box.currentText()

    def set_forecast(self, names: tuple[str, ...], weights: tuple[float, ...] = ()) -> None:
        """Choose a forecast by the names of the command line; what is not there gets an entry."""
        at = next(
            (i for i in range(self.forecast_box.count()) if tuple(self.forecast_box.itemData(i)) == names), -1
        )
        if at < 0:
            at = self.forecast_box.count() - 1
            text = ", ".join(Path(name).name for name in names)
            self.forecast_box.insertItem(at, text, names)
        self.forecast_box.setCurrentIndex(at)
        changed = (names, weights) != (self._forecast, self._weights)
        self._forecast, self._weights = names, weights
        if changed:
            self.forecast_changed.emit()

    def _forecast_picked(self, index: int) -> None:
        names = tuple(self.forecast_box.itemData(index))
        if names == (_CHOOSE_FILE,):
            self.set_forecast(self._forecast, self._weights)
            self._ask_for_files()
        else:
            self.set_forecast(names)

    def _ask_for_files(self) -> None:
        dialog = QFileDialog(self, self.tr("Forecast files"), "", FILE_TYPES)
        dialog.setFileMode(QFileDialog.FileMode.ExistingFiles)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.filesSelected.connect(lambda files: self.set_forecast(tuple(files)))
        dialog.open()

    def swap_ends(self) -> None:
        """Sail the other way."""
        start, end = self.start_field.text(), self.end_field.text()
        self.start_field.setText(end)
        self.end_field.setText(start)

    def show_options(self, *, shown: bool) -> None:
        """Open or close the part with the finer choices."""
        self.options_box.setVisible(shown)
        self._tell_options()

    def _tell_options(self) -> None:
        if not self.options_box.isHidden():
            self.more_button.setText(self.tr("Fewer options"))
            return
        said = []
        if self.percent_box.value() != 100.0:
            said.append(f"{self.percent_box.value():.0f} %")
        if self.max_wind_box.value():
            said.append(self.tr("up to {n:.0f} kn").format(n=self.max_wind_box.value()))
        if self.motor_box.value():
            said.append(self.tr("motor below {n:g} kn").format(n=self.motor_box.value()))
        extra = f" ({', '.join(said)})" if said else ""
        self.more_button.setText(self.tr("Crew, wind limit, engine…") + extra)

    def use_engine(self) -> None:
        """Let the engine help below three knots."""
        self.motor_box.setValue(3.0)
        self.show_options(shown=True)

    def set_running(self, *, running: bool) -> None:
        """Tell that a calculation runs, or none does. Changing the fields meanwhile disturbs nothing."""
        before, after = self.calculate_button, self.cancel_button
        if not running:
            before, after = after, before
        had_focus = before.hasFocus()
        after.setEnabled(True)
        before.setEnabled(False)
        if had_focus:
            # Qt would pass it on to whatever comes next.
            after.setFocus()


def _port_in(field: PortField) -> Port:
    """Give the port that a field names; one that names none has the focus then."""
    try:
        return field.require_port()
    except InputError:
        field.mark_wrong(wrong=True)
        field.setFocus()
        raise
