"""The part of the form for what is changed most: crew, limit of wind, engine; and the way to all the rest."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QGridLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from seacruise.desktop.banner import text_label
from seacruise.desktop.options_dialog import Number, OptionsDialog, most_wind, motor_below, number_box
from seacruise.desktop.options_model import OptionsModel
from seacruise.desktop.units_choice import units_choice


class OptionsBar(QWidget):
    """A button that opens three fields, a line that says what is not usual, and a button for everything.

    Parameters
    ----------
    model
        Shown and set here.

    Signals: ``made(OptionsDialog)`` when the dialog was made.
    """

    made = Signal(object)

    def __init__(self, model: OptionsModel, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._model = model
        self._dialog: OptionsDialog | None = None
        self.more_button = QPushButton(self)
        self.more_button.setObjectName("flat")
        self.more_button.clicked.connect(self._turn)
        self.summary = text_label("", "hint", self)
        self.summary.setAccessibleName(self.tr("What differs from the defaults"))
        self.box: QWidget = QWidget(self)
        self._make_fields()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addWidget(self.more_button)
        layout.addWidget(self.box)
        layout.addWidget(self.summary)
        model.changed.connect(self.tell)
        units_choice().changed.connect(self.tell)
        self.show_options(shown=False)

    def _make_fields(self) -> None:
        specs = (
            Number("percent_of_polar", self.tr("Crew sails at"), 10, 200, " %", 5),
            most_wind(),
            motor_below(),
        )
        boxes = [number_box(spec, self._model, self.box) for spec in specs]
        self.percent_box, self.max_wind_box, self.motor_box = boxes
        grid = QGridLayout(self.box)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setColumnStretch(0, 1)
        for row, (spec, box) in enumerate(zip(specs, boxes, strict=True)):
            label = QLabel(spec.label, self.box)
            label.setObjectName("fieldName")
            label.setBuddy(box)
            grid.addWidget(label, row, 0)
            grid.addWidget(box, row, 1)
        # It has a key of its own; the window has no letter to spare for it in every language.
        self.all_button = QPushButton(self.tr("Limits, &boards, search…").replace("&", ""), self.box)
        self.all_button.setToolTip(self.tr("Everything about how she is sailed (Ctrl+Shift+O)"))
        self.all_button.clicked.connect(self.open_dialog)
        grid.addWidget(self.all_button, len(specs), 0, 1, 2)

    def _turn(self) -> None:
        self.show_options(shown=self.box.isHidden())

    def show_options(self, *, shown: bool) -> None:
        """Open or close the three fields."""
        self.box.setVisible(shown)
        self.tell()

    def tell(self) -> None:
        """Say what is not usual."""
        open_ = not self.box.isHidden()
        self.more_button.setText(self.tr("Fewer options") if open_ else self.tr("Crew, wind limit, engine…"))
        said = self._model.summary()
        self.summary.setText(said)
        self.summary.setVisible(bool(said))

    @property
    def dialog(self) -> OptionsDialog:
        """The dialog with everything, made when it is first wanted."""
        if self._dialog is None:
            self._dialog = OptionsDialog(self._model, self.window())
            self.made.emit(self._dialog)
        return self._dialog

    def take_over(self, other: OptionsBar) -> None:
        """Be as open as that of another window, its dialog too."""
        self.show_options(shown=not other.box.isHidden())
        if other.is_dialog_open:
            self.open_dialog()

    @property
    def is_dialog_open(self) -> bool:
        """Whether the dialog with everything is shown."""
        return self._dialog is not None and self._dialog.isVisible()

    def open_dialog(self) -> None:
        """Open the dialog beside the window."""
        self.dialog.show()
        self.dialog.raise_()
        self.dialog.activateWindow()
