"""The form: from where to where, when, with which yacht, by which forecast, and how she is sailed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from functools import partial
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import (
    QComboBox,
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from seacruise.desktop.banner import text_label
from seacruise.desktop.compute import Question, refuse_same_port
from seacruise.desktop.departure_field import DepartureField
from seacruise.desktop.forecast_box import ForecastBox
from seacruise.desktop.number_box import WheelGuard
from seacruise.desktop.options_bar import OptionsBar
from seacruise.desktop.options_model import OptionsModel
from seacruise.desktop.port_field import PortField
from seacruise.desktop.style import scaled_font, show_icon
from seacruise.errors import InputError
from seacruise.model import Options
from seacruise.ports import Port

if TYPE_CHECKING:
    from seacruise.desktop.pages.reach_model import Outset
    from seacruise.yacht.polar import Polar

_LIVE: Final = frozenset({"auto", "stormglass", "open-meteo", "open-meteo-ensemble", "metno", "practice"})
"""Forecasts of the days to come: with them a departure that is over is nothing to keep."""

_KINDS: Final[dict[str, type | tuple[type, ...]]] = {
    **dict.fromkeys(("start", "end", "yacht"), str),
    **dict.fromkeys(("forecast", "weights"), list),
}
"""What a window keeps of its form besides the options, and of which kind it is."""


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
        self.sailing = OptionsModel(self)
        self.start_field, self.end_field = PortField(self), PortField(self)
        self.departure = DepartureField(self)
        self.yacht_box, self.forecast_box = QComboBox(self), ForecastBox(self)
        self.options_bar = OptionsBar(self.sailing, self)
        bar = self.options_bar
        self.percent_box, self.max_wind_box, self.motor_box = bar.percent_box, bar.max_wind_box, bar.motor_box
        self._wheel = WheelGuard(self)
        self._make_buttons()
        self._lay_out()
        self.yacht_box.setPlaceholderText(self.tr("Loading the yachts…"))
        self.yacht_box.setMaxVisibleItems(18)
        # A name may be as long as it likes; the column stays as wide as it is.
        self.yacht_box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.yacht_box.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        for field in (self.start_field, self.end_field):
            field.port_changed.connect(self.ends_changed)
        self.start_field.setPlaceholderText(self.tr("Port, or 54.5, 18.6"))
        self.end_field.setPlaceholderText(self.tr("Port, or 59.3, 18.1"))
        self.forecast_box.forecast_changed.connect(self.forecast_changed)
        self.yacht_box.activated.connect(self._yacht_picked)
        self.yacht_box.activated.connect(self.sailing_changed)
        self.sailing.changed.connect(self.sailing_changed)
        self.forecast_changed.connect(partial(self.sailing.learn_current, None))
        self._wheel.guard(
            self.yacht_box, self.forecast_box, self.departure.date_edit, self.departure.time_edit
        )
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

    def _lay_out(self) -> None:
        title = QLabel(self.tr("Passage"), self)
        title.setFont(scaled_font(self.font(), 1.25, bold=True))
        ends = QGridLayout()
        ends.setHorizontalSpacing(8)
        ends.setVerticalSpacing(3)
        ends.addWidget(self._name(self.tr("Fro&m"), self.start_field), 0, 0)
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
        layout.addWidget(self.options_bar)
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
            forecast=self.forecast,
            weights=self.weights,
            options=self.options(),
        )

    def outset(self) -> Outset:
        """Say what the form asks but for the end.

        Raises
        ------
        InputError
            What is wrong, and in which field; the field has the focus then.
        """
        from seacruise.desktop.pages.reach_model import Outset

        return Outset(
            start=_port_in(self.start_field),
            departure=self.departure.require_moment(),
            yacht=self._yacht(),
            forecast=self.forecast,
            weights=self.weights,
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
        """How to sail: the fields, and what the command line said besides."""
        return self.sailing.options

    @property
    def forecast(self) -> tuple[str, ...]:
        """Chosen forecast, as on the command line."""
        return self.forecast_box.forecast

    @property
    def weights(self) -> tuple[float, ...]:
        """Weights of several forecasts in their mean; empty for equal ones."""
        return self.forecast_box.weights

    def set_forecast(self, names: tuple[str, ...], weights: tuple[float, ...] = ()) -> None:
        """Choose a forecast by the names of the command line."""
        self.forecast_box.set_forecast(names, weights)

    @property
    def wrong_field(self) -> QWidget:
        """The field to look at first: of an end that is none, or is the other one; else the departure."""
        if self.start_field.port is None:
            return self.start_field
        if self.end_field.port is None or self.end_field.port == self.start_field.port:
            return self.end_field
        return self.departure

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
        """Give what is worth keeping for the next start; a departure only where the sailor chose it."""
        kept: dict[str, object] = {
            "start": self.start_field.text(),
            "end": self.end_field.text(),
            "yacht": self._wanted_yacht,
            "forecast": list(self.forecast),
            "weights": list(self.weights),
        }
        if self.departure.was_chosen:
            kept["depart"] = self.departure.moment.isoformat()
        return kept | self.sailing.contents()

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
        self.sailing.put(values)

    def restore(self, kept: Mapping[str, Any]) -> None:
        """Fill in what `contents` gave; what is not of its kind, as in a damaged file, is passed over."""
        values = {key: kept[key] for key, kind in _KINDS.items() if isinstance(kept.get(key), kind)}
        if moment := _still_ahead(kept.get("depart"), values.get("forecast", ())):
            values["depart"] = moment
        self.fill(values)
        self.sailing.restore(kept)

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

    def swap_ends(self) -> None:
        """Sail the other way."""
        start, end = self.start_field.text(), self.end_field.text()
        self.start_field.setText(end)
        self.end_field.setText(start)

    def use_engine(self) -> None:
        """Let the engine help below three knots."""
        self.motor_box.setValue(3.0)
        self.options_bar.show_options(shown=True)

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


def _still_ahead(written: object, forecast: Sequence[object]) -> datetime | None:
    """Give a departure that was kept, unless it is over; in the sample or a file nothing ever is."""
    try:
        moment = datetime.fromisoformat(written) if isinstance(written, str) else None
    except ValueError:
        return None
    if moment is None or moment.tzinfo is None:
        return None
    lasts = bool(forecast) and not _LIVE.intersection(map(str, forecast))
    return moment if lasts or moment > datetime.now(UTC) else None
