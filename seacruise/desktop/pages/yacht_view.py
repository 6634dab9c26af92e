"""A yacht looked at closely: her polar diagram in a wind, what it says at an angle, and her targets."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QHBoxLayout, QSlider, QVBoxLayout, QWidget

from seacruise.desktop.banner import text_label
from seacruise.desktop.language import fill, sentence
from seacruise.desktop.pages.flow import FlowLayout, named
from seacruise.desktop.pages.page import number_box
from seacruise.desktop.pages.polar_diagram import PolarDiagram
from seacruise.desktop.pages.rows import Looks, RowsTable
from seacruise.desktop.pages.yacht_model import Shown, reading_at, targets_in
from seacruise.desktop.pages.yacht_words import (
    COMPARING_COLUMNS,
    TargetRow,
    angle_text,
    best_text,
    target_columns,
)
from seacruise.desktop.style import scaled_font
from seacruise.export.polar_slices import LogPoints
from seacruise.yacht.polar import Polar

_FIRST_WIND_KN: Final = 10


class YachtView(QWidget):
    """Diagram, slider, reading and table of one yacht, or of two.

    Signals: ``other_chosen()`` when another yacht is to be compared, ``percent_changed(float)``.
    """

    other_chosen = Signal()
    percent_changed = Signal(float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._shown: tuple[Shown, Shown | None] | None = None
        self._from_log = False
        self._make_head()
        self._make_diagram()
        self._lay_out()

    # --- building -----------------------------------------------------------------------------------

    def _make_head(self) -> None:
        self.title = text_label("", parent=self)
        self.title.setFont(scaled_font(self.font(), 1.2, bold=True))
        self.source = text_label("", "hint", self)
        self.other_box = QComboBox(self)
        self.other_box.setAccessibleName(self.tr("Compare with another yacht"))
        self.other_box.setMaximumWidth(210)
        self.other_box.currentIndexChanged.connect(lambda _at: self.other_chosen.emit())
        self.percent_box = number_box(
            self.tr("Per cent of the polar"), low=30.0, high=150.0, value=100.0, suffix=self.tr(" %")
        )
        self.percent_box.setSingleStep(5.0)
        self.percent_box.valueChanged.connect(self._set_percent)
        self.hull_box = QCheckBox(self.tr("&Tacking and gybing"), self)
        self.hull_box.setToolTip(self.tr("Dotted: what she makes good by turns on two headings"))
        self.hull_box.setChecked(True)
        self.hull_box.toggled.connect(self._set_hull)

    def _make_diagram(self) -> None:
        self.diagram = PolarDiagram(self)
        self.diagram.angle_changed.connect(self._say_angle)
        self.diagram.wind_wanted.connect(self._step_wind)
        self.wind_slider = QSlider(Qt.Orientation.Horizontal, self)
        self.wind_slider.setAccessibleName(self.tr("True wind speed, knots"))
        self.wind_slider.setPageStep(4)
        self.wind_slider.setRange(2, 24)
        self.wind_slider.setValue(_FIRST_WIND_KN)
        self.wind_slider.valueChanged.connect(self._set_wind)
        self.wind_label = text_label("", parent=self)
        self.wind_label.setFont(scaled_font(self.font(), 1.0, bold=True))
        self.wind_label.setMinimumWidth(self.wind_label.fontMetrics().horizontalAdvance("000 kn") + 6)
        self.reading = text_label("", parent=self)
        self.reading.setAccessibleName(self.tr("At this angle"))
        # As high as its longest text: the diagram must not jump under the pointer.
        self.reading.setMinimumHeight(3 * self.reading.fontMetrics().height() + 4)
        self.reading.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
        self.table = RowsTable(self.tr("Targets: best beat and run by wind"), target_columns(), Looks(), self)
        self.table.pressed_row.connect(self._go_to_wind)
        self.table.taken.connect(self._go_to_wind)

    def _lay_out(self) -> None:
        controls = QWidget(self)
        line = FlowLayout(controls)
        line.addWidget(named(self.tr("C&ompare"), self.other_box))
        line.addWidget(named(self.tr("S&ails at"), self.percent_box))
        line.addWidget(self.hull_box)
        wind = QHBoxLayout()
        wind.addWidget(named(self.tr("&Wind"), self.wind_slider), 1)
        wind.addWidget(self.wind_label)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(6)
        for widget in (self.title, self.source, controls):
            layout.addWidget(widget)
        layout.addWidget(self.diagram, 1)
        layout.addLayout(wind)
        layout.addWidget(self.reading)
        layout.addWidget(self.table)

    # --- what is shown ------------------------------------------------------------------------------

    @property
    def shown(self) -> tuple[Shown, Shown | None] | None:
        """The yacht, and the one she is compared with."""
        return self._shown

    def offer(self, names: Sequence[str]) -> None:
        """Offer yachts to compare with; the one that is chosen stays so where she is still there."""
        chosen = self.other
        self.other_box.blockSignals(True)
        self.other_box.clear()
        self.other_box.addItem(self.tr("with no other yacht"))
        self.other_box.addItems(list(names))
        self.other_box.blockSignals(False)
        self.set_other(chosen)

    @property
    def other(self) -> str:
        """Name of the yacht to compare with; empty for none."""
        return self.other_box.currentText() if self.other_box.currentIndex() > 0 else ""

    def set_other(self, name: str) -> None:
        """Choose the yacht to compare with, and tell nobody."""
        self.other_box.blockSignals(True)
        self.other_box.setCurrentIndex(max(0, self.other_box.findText(name)) if name else 0)
        self.other_box.blockSignals(False)

    def show_yachts(self, mine: Shown, other: Shown | None, points: LogPoints | None) -> None:
        """Show a yacht; with points of a log, which are as they were sailed, the whole of her polar."""
        self._shown = (mine, other)
        self._from_log = points is not None
        self.percent_box.setEnabled(not self._from_log)
        self.hull_box.setEnabled(isinstance(mine.yacht, Polar))
        one = mine.yacht.name
        self.title.setText(
            self.tr("{one} and {two} (dashed)").format(one=one, two=other.yacht.name) if other else one
        )
        self.source.setText(sentence(mine.yacht.source))
        self.source.setVisible(bool(mine.yacht.source))
        self.wind_slider.blockSignals(True)
        self.wind_slider.setRange(mine.least_kn, mine.most_kn)
        self.wind_slider.blockSignals(False)
        yachts = [shown.yacht for shown in (mine, other) if shown is not None]
        self.diagram.set_percent(self.share)
        self.diagram.show_yachts(yachts, points, tws_kn=float(self.wind_slider.value()))
        self._show_table()
        self._set_wind(self.wind_slider.value())

    @property
    def share(self) -> float:
        """Per cent of the polar that is drawn."""
        return 100.0 if self._from_log else self.percent_box.value()

    def _show_table(self) -> None:
        if self._shown is None:
            return
        mine, other = self._shown
        rows = [
            TargetRow(row, self.share, targets_in(other, row.tws_kn) if other is not None else None)
            for row in mine.rows
        ]
        for column in COMPARING_COLUMNS:
            self.table.setColumnHidden(column, other is None)
        self.table.show_rows(rows)
        height = self.table.horizontalHeader().sizeHint().height()
        self.table.setFixedHeight(height + len(rows) * self.table.verticalHeader().defaultSectionSize() + 14)

    def show_light(self, light: str) -> None:
        """Draw in the colours of a light."""
        self.diagram.show_light(light)

    # --- what the sailor does -----------------------------------------------------------------------

    def _set_wind(self, tws_kn: int) -> None:
        self.wind_label.setText(self.tr("{tws} kn").format(tws=tws_kn))
        self.diagram.set_wind(float(tws_kn))
        self._say_angle(self.diagram.angle)

    def _step_wind(self, step: int) -> None:
        self.wind_slider.setValue(self.wind_slider.value() + step)

    def _go_to_wind(self, row: TargetRow | None) -> None:
        if row is not None:
            self.wind_slider.setValue(round(row.targets.tws_kn))

    def _set_hull(self, on: bool) -> None:
        self.diagram.show_hull(on)
        self._say_angle(self.diagram.angle)

    def _set_percent(self, percent: float) -> None:
        self.diagram.set_percent(self.share)
        self._show_table()
        self._say_angle(self.diagram.angle)
        self.percent_changed.emit(percent)

    def _say_angle(self, angle: float | None) -> None:
        text = self._words(angle)
        self.reading.setText(text)
        self.diagram.setAccessibleDescription(text)

    def _words(self, angle: float | None) -> str:
        if self._shown is None or not self.diagram.slices:
            return ""
        mine, other = self._shown
        sides = self.diagram.slices[0]
        cut = sides.get(-1 if angle is not None and angle < 0.0 else 1, sides[1])
        if angle is None:
            return best_text(cut, self.share)
        text = angle_text(mine, cut, angle, self.share, hull=self.hull_box.isChecked())
        if other is not None:
            speed = reading_at(other.yacht, cut.tws_kn, angle, self.share).boat_speed_kn
            text += fill(self.tr("  {yacht}: {speed:.2f} kn."), yacht=other.yacht.name, speed=speed)
        return text
