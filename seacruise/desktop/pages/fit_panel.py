"""A fit from logs: while it runs, and what it has found until it is kept or dropped."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QProgressBar, QPushButton, QVBoxLayout, QWidget

from seacruise.desktop.banner import text_label
from seacruise.desktop.pages.yacht_model import FromLog
from seacruise.desktop.pages.yacht_words import fit_text
from seacruise.desktop.style import scaled_font


class FitPanel(QFrame):
    """Signals: ``cancelled()``, ``kept(FromLog)``, ``shown(FromLog)``, ``dropped()``."""

    cancelled = Signal()
    kept = Signal(object)
    shown = Signal(object)
    dropped = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("banner")
        self.setProperty("kind", "info")
        self.found: FromLog | None = None
        self.title = text_label("", parent=self)
        self.title.setFont(scaled_font(self.font(), 1.0, bold=True))
        self.words = text_label("", parent=self)
        self.progress = QProgressBar(self)
        self.progress.setTextVisible(False)
        self.progress.setAccessibleName(self.tr("Progress of the fit"))
        self.cancel_button = self._button(self.tr("Cancel"), self.cancelled.emit)
        self.keep_button = self._button(self.tr("Keep her"), lambda: self.kept.emit(self.found))
        self.keep_button.setToolTip(self.tr("Save the polar in your own folder; the next log learns on"))
        self.show_button = self._button(self.tr("Show"), lambda: self.shown.emit(self.found))
        self.drop_button = self._button(self.tr("Drop"), self.dropped.emit)
        row = QHBoxLayout()
        row.setSpacing(8)
        for button in (self.cancel_button, self.keep_button, self.show_button, self.drop_button):
            row.addWidget(button)
        row.addStretch()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(12, 9, 12, 10)
        layout.setSpacing(5)
        for widget in (self.title, self.words, self.progress):
            layout.addWidget(widget)
        layout.addLayout(row)
        self.clear()

    def _button(self, text: str, pressed: object) -> QPushButton:
        button = QPushButton(text, self)
        button.clicked.connect(pressed)
        return button

    def clear(self) -> None:
        """Show nothing."""
        self.found = None
        self.setVisible(False)

    def begin(self) -> None:
        """Show that a fit runs."""
        self.found = None
        self.title.setText(self.tr("Fitting a polar to your log"))
        self.show_progress(None, self.tr("Reading…"))
        self._show_buttons(busy=True)

    def show_progress(self, fraction: float | None, message: str) -> None:
        """Show how far it is."""
        self.progress.setRange(0, 0 if fraction is None else 1000)
        self.progress.setValue(round(1000 * (fraction or 0.0)))
        self.words.setText(message)

    def end(self, found: FromLog) -> None:
        """Show what was found."""
        self.found = found
        self.title.setText(found.yacht.name)
        self.words.setText(fit_text(found))
        self._show_buttons(busy=False)
        self.keep_button.setFocus()

    def _show_buttons(self, *, busy: bool) -> None:
        self.progress.setVisible(busy)
        self.cancel_button.setVisible(busy)
        for button in (self.keep_button, self.show_button, self.drop_button):
            button.setVisible(not busy)
        self.setVisible(True)
