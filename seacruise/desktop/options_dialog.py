"""All ways to sail and to search, in groups, beside the window: what is changed counts at once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFrame,
    QGridLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from seacruise.desktop.banner import text_label
from seacruise.desktop.number_box import Kind, NumberBox, WheelGuard
from seacruise.desktop.options_model import OptionsModel
from seacruise.desktop.style import scaled_font

_ABSENT_BELOW: Final = -1.0
"""Stands for "none" where nought is a number as any other."""


@dataclass(frozen=True, slots=True)
class Number:
    """A field for a number.

    Attributes
    ----------
    none
        What is written when there is none; empty where there always is one.
    """

    name: str
    label: str
    low: float
    high: float
    suffix: str = ""
    step: float = 1.0
    none: str = ""
    kind: Kind = "plain"
    tip: str = ""


def most_wind() -> Number:
    """Field for the limit of wind."""
    label = QCoreApplication.translate("OptionsDialog", "Most wind (TWS)")
    none = QCoreApplication.translate("OptionsDialog", "no limit")
    return Number("max_wind_kn", label, 0, 200, none=none, kind="wind")


def motor_below() -> Number:
    """Field for the speed below which the engine helps."""
    label = QCoreApplication.translate("OptionsDialog", "Motor when slower than")
    unit = QCoreApplication.translate("OptionsDialog", " kn")
    never = QCoreApplication.translate("OptionsDialog", "never")
    return Number("motor_below_kn", label, 0, 50, unit, 0.5, never)


def number_box(spec: Number, model: OptionsModel, parent: QWidget) -> NumberBox:
    """Make a field for a number that shows and sets an option of the model."""
    box = NumberBox(
        spec.low,
        spec.high,
        suffix=spec.suffix,
        step=spec.step,
        none=spec.none,
        kind=spec.kind,
        parent=parent,
    )
    box.setAccessibleName(spec.label)
    box.setToolTip(spec.tip)
    whole = spec.name == "most_turns"

    def show() -> None:
        value = getattr(model.options, spec.name)
        box.blockSignals(True)
        box.setValue(box.minimum() if value is None else value)
        box.blockSignals(False)

    def take(value: float) -> None:
        absent = bool(spec.none) and value == box.minimum()
        model.put({spec.name: None if absent else round(value) if whole else value})

    box.valueChanged.connect(take)
    model.changed.connect(show)
    show()
    return box


class OptionsDialog(QDialog):
    """The dialog; it stays open beside the window, and shows what is set elsewhere, too."""

    def __init__(self, model: OptionsModel, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._model = model
        self.setWindowTitle(self.tr("How she is sailed"))
        self.fields: dict[str, QWidget] = {}
        self._guard = WheelGuard(self)
        body = QWidget()
        body.setObjectName("sideBody")
        sections = QVBoxLayout(body)
        sections.setContentsMargins(14, 14, 14, 14)
        sections.setSpacing(12)
        for make in (self._yacht_and_crew, self._limits, self._engine, self._boards, self._search):
            sections.addWidget(make())
        sections.addStretch()
        scroll = QScrollArea(self)
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setWidgetResizable(True)
        scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setWidget(body)
        self.summary = text_label("", "hint", self)
        self.summary.setAccessibleName(self.tr("What differs from the defaults"))
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close, self)
        self.reset_button = QPushButton(self.tr("Back to &defaults"), self)
        buttons.addButton(self.reset_button, QDialogButtonBox.ButtonRole.ResetRole)
        self.reset_button.clicked.connect(model.reset)
        buttons.rejected.connect(self.reject)
        foot = QVBoxLayout()
        foot.setContentsMargins(16, 4, 16, 12)
        foot.addWidget(self.summary)
        foot.addWidget(buttons)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(scroll, 1)
        layout.addLayout(foot)
        model.changed.connect(self._tell)
        self._tell()
        self.setMinimumSize(340, 240)
        self.resize(460, 720)

    def _tell(self) -> None:
        said = self._model.summary()
        self.summary.setText(
            self.tr("Differs from the defaults: {what}.").format(what=said)
            if said
            else self.tr("Everything is at its default.")
        )
        self.reset_button.setEnabled(not self._model.is_default)

    # --- sections -----------------------------------------------------------------------------------

    def _yacht_and_crew(self) -> QWidget:
        return self._section(
            self.tr("Yacht and crew"),
            Number("percent_of_polar", self.tr("Crew sails at"), 10, 200, self.tr(" % of polar"), 5),
            Number("percent_at_night", self.tr("of that at night"), 10, 100, " %", 5),
            Number(
                "sea_state_percent",
                self.tr("Slower by waves"),
                0,
                50,
                self.tr(" % a metre"),
                tip=self.tr(
                    "What each metre of waves above half a metre takes off her speed head to sea, where the "
                    "forecast has waves; 8 % is a rule of thumb"
                ),
            ),
        )

    def _limits(self) -> QWidget:
        none = self.tr("no limit")
        here = self.tr("Counts where the forecast has it")
        return self._section(
            self.tr("Limits"),
            most_wind(),
            Number("max_gust_kn", self.tr("Strongest gusts"), 0, 200, none=none, kind="wind", tip=here),
            Number(
                "max_wave_m", self.tr("Highest waves"), 0, 30, step=0.5, none=none, kind="height", tip=here
            ),
            Number(
                "shore_clearance_nm",
                self.tr("Distance from the shore"),
                0,
                15,
                step=0.5,
                none=self.tr("none kept"),
                kind="distance",
                tip=self.tr("Kept everywhere but on the way out of and into the ports"),
            ),
            Number(
                "may_wait_h",
                self.tr("May leave later by"),
                0,
                240,
                self.tr(" h"),
                tip=self.tr("She waits where that brings her there earlier, or at all"),
            ),
        )

    def _engine(self) -> QWidget:
        return self._section(
            self.tr("Engine"),
            motor_below(),
            Number("motor_speed_kn", self.tr("Speed under engine"), 0.1, 50, self.tr(" kn"), 0.5),
            Number("fuel_rate_l_h", self.tr("Fuel"), 0, 1000, self.tr(" l/h"), 0.5),
        )

    def _boards(self) -> QWidget:
        return self._section(
            self.tr("Boards"),
            self._check("tacking", self.tr("Tack up and gybe down the wind")),
            Number("tack_penalty_min", self.tr("A tack costs"), 0, 120, self.tr(" min"), 0.5),
            Number("gybe_penalty_min", self.tr("A gybe costs"), 0, 120, self.tr(" min"), 0.5),
            Number(
                "board_h",
                self.tr("Usual length of a board"),
                0,
                24,
                self.tr(" h"),
                0.5,
                self.tr("1.5 h"),
            ),
            Number(
                "most_turns",
                self.tr("Tacks and gybes at most"),
                _ABSENT_BELOW,
                1000,
                none=self.tr("as many as it takes"),
            ),
        )

    def _search(self) -> QWidget:
        return self._section(
            self.tr("How it is searched"),
            self._choice(
                "preset",
                self.tr("Search"),
                {"precise": self.tr("precise"), "classic": self.tr("classic (the 2016 method)")},
            ),
            self._choice(
                "beyond",
                self.tr("After the forecast"),
                {
                    "hold": self.tr("hold the last wind"),
                    "fade": self.tr("let the wind fade"),
                    "refuse": self.tr("refuse to sail on"),
                },
            ),
            self._check("currents", self.tr("Reckon with the current")),
            ("", self._without_current()),
        )

    def _without_current(self) -> QLabel:
        """Say why there is no current to reckon with, where there is none."""
        label = text_label(self.tr("The forecast at hand has no current."), "hint", self)
        box = self.fields["currents"]

        def show() -> None:
            absent = self._model.has_current is False
            box.setEnabled(not absent)
            box.setToolTip(label.text() if absent else "")
            label.setVisible(absent)

        self._model.learned.connect(show)
        show()
        return label

    # --- fields -------------------------------------------------------------------------------------

    def _section(self, title: str, *rows: Number | tuple[str, QWidget]) -> QFrame:
        card = QFrame(self)
        card.setObjectName("card")
        grid = QGridLayout(card)
        grid.setContentsMargins(14, 10, 14, 12)
        grid.setVerticalSpacing(6)
        grid.setColumnStretch(0, 1)
        heading = QLabel(title, card)
        heading.setFont(scaled_font(self.font(), 1.05, bold=True))
        grid.addWidget(heading, 0, 0, 1, 2)
        for row, spec in enumerate(rows, start=1):
            if isinstance(spec, Number):
                text, field = spec.label, self._number(spec)
            else:
                text, field = spec
            if not text:
                grid.addWidget(field, row, 0, 1, 2)
                continue
            label = text_label(text, "fieldName", card)
            label.setBuddy(field)
            grid.addWidget(label, row, 0)
            grid.addWidget(field, row, 1)
        return card

    def _number(self, spec: Number) -> QWidget:
        box = number_box(spec, self._model, self)
        box.setMinimumWidth(self.fontMetrics().horizontalAdvance(self.tr("as many as it takes")) + 48)
        self.fields[spec.name] = box
        return box

    def _check(self, name: str, label: str) -> tuple[str, QWidget]:
        box = QCheckBox(label, self)
        self._join(name, box, lambda: box.setChecked(bool(getattr(self._model.options, name))))
        box.toggled.connect(lambda on: self._model.put({name: on}))
        return "", box

    def _choice(self, name: str, label: str, texts: dict[str, str]) -> tuple[str, QWidget]:
        box = QComboBox(self)
        box.setAccessibleName(label)
        for value, text in texts.items():
            box.addItem(text, value)
        self._guard.guard(box)
        self._join(name, box, lambda: box.setCurrentIndex(box.findData(getattr(self._model.options, name))))
        box.activated.connect(lambda at: self._model.put({name: box.itemData(at)}))
        return label, box

    def _join(self, name: str, field: QWidget, show: Callable[[], Any]) -> None:
        def show_quietly() -> None:
            field.blockSignals(True)
            show()
            field.blockSignals(False)

        self.fields[name] = field
        self._model.changed.connect(show_quietly)
        show_quietly()

    def showEvent(self, event: QShowEvent) -> None:
        """Begin at the first field, and within the screen."""
        super().showEvent(event)
        room = self.screen().availableGeometry()
        self.resize(min(self.width(), room.width()), min(self.height(), room.height() - 40))
        next(iter(self.fields.values())).setFocus()
