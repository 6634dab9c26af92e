"""A field for a number: nothing is cut off, nothing is changed by a wheel that only passes by."""

from __future__ import annotations

from typing import Final, Literal

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QValidator
from PySide6.QtWidgets import QDoubleSpinBox, QWidget

from seacruise.desktop.units_choice import (
    METRES_PER_FOOT,
    distance_unit,
    height_unit,
    units_choice,
    wind_unit,
)
from seacruise.units import METRES_PER_NM, MS_PER_KNOT

Kind = Literal["plain", "wind", "distance", "height"]

_DECIMALS: Final = 5
"""Kept of a number in the program's unit, so that what is typed in another one comes back as it was typed."""


class WheelGuard(QObject):
    """Lets the wheel scroll the column, not turn the field under it, until that field has the focus."""

    def guard(self, *fields: QWidget) -> None:
        """Watch over some fields."""
        for field in fields:
            field.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
            field.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Pass a wheel on to what is behind the field."""
        if event.type() == QEvent.Type.Wheel and isinstance(watched, QWidget) and not watched.hasFocus():
            event.ignore()
            return True
        return bool(super().eventFilter(watched, event))


class NumberBox(QDoubleSpinBox):
    """Spin box whose value is always in the program's own unit: knots, nautical miles, metres.

    Parameters
    ----------
    low, high
        The range, in the program's unit; the lowest may stand for "none".
    suffix
        Unit of a plain number, with the space before it.
    none
        What is written for the lowest value; empty where that is a number as any other.
    kind
        What it measures; other kinds than ``"plain"`` are shown in the unit that the sailor chose. A wind
        stays in knots where that is Beaufort: a force is a range, no limit.
    """

    def __init__(
        self,
        low: float,
        high: float,
        *,
        suffix: str = "",
        step: float = 1.0,
        none: str = "",
        kind: Kind = "plain",
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._kind: Kind = kind
        self._plain_suffix = suffix
        self._guard = WheelGuard(self)
        self._guard.guard(self)
        self.setDecimals(_DECIMALS)
        self.setRange(low, high)
        self.setSingleStep(step)
        self.setSpecialValueText(none)
        self.setKeyboardTracking(False)
        self.setMinimumWidth(112)
        self.lineEdit().setTextMargins(5, 0, 0, 0)
        self._show_unit()
        if kind != "plain":
            units_choice().changed.connect(self._show_unit)

    def _show_unit(self) -> None:
        unit = {
            "plain": self._plain_suffix,
            "wind": f" {wind_unit() if units_choice().units.wind == 'm/s' else self.tr('kn')}",
            "distance": f" {distance_unit()}",
            "height": f" {height_unit()}",
        }[self._kind]
        self.setSuffix(unit)

    def _factor(self) -> float:
        """How many of the unit shown one of the program's own is."""
        units = units_choice().units
        if self._kind == "wind" and units.wind == "m/s":
            return MS_PER_KNOT
        if self._kind == "distance" and units.distance == "km":
            return METRES_PER_NM / 1000.0
        if self._kind == "height" and units.height == "ft":
            return 1.0 / METRES_PER_FOOT
        return 1.0

    def textFromValue(self, value: float) -> str:
        """Write a number without zeros that say nothing."""
        text = super().textFromValue(round(value * self._factor(), 2))
        point = self.locale().decimalPoint()
        return text.rstrip("0").removesuffix(point) if point in text else text

    def valueFromText(self, text: str) -> float:
        """Read a number in the unit shown; what is shown of the present one is the present one."""
        if self.cleanText() == self.textFromValue(self.value()):
            return self.value()
        number, fits = self._read(text)
        return number / self._factor() if fits else super().valueFromText(text)

    def _read(self, text: str) -> tuple[float, bool]:
        number, fits = self.locale().toDouble(text.removesuffix(self.suffix()).strip())
        return float(number), bool(fits)

    def validate(self, text: str, at: int) -> tuple[QValidator.State, str, int]:
        """Take what is being typed; Qt would hold a number in another unit against the range."""
        state, text, at = super().validate(text, at)
        if self._factor() != 1.0 and self._read(text)[1]:
            state = QValidator.State.Acceptable
        return state, text, at
