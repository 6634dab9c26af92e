"""What a calculation is doing: its stages, the running one with its count, and the time it has taken."""

from __future__ import annotations

import time

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QFrame, QGridLayout, QHBoxLayout, QLabel, QProgressBar, QVBoxLayout, QWidget

from seacruise.desktop.banner import text_label
from seacruise.desktop.language import fill, sentence
from seacruise.desktop.state import STAGES, Progress
from seacruise.desktop.style import scaled_font


class ProgressPanel(QFrame):
    """Stages of a calculation with what each says for itself."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("card")
        self._begun = time.monotonic()
        self._ticker = QTimer(self)
        self._ticker.setInterval(100)
        self._ticker.timeout.connect(self._tick)
        title = QLabel(self.tr("Calculating"), self)
        title.setFont(scaled_font(self.font(), 1.15, bold=True))
        self.elapsed = QLabel(self)
        self.elapsed.setObjectName("hint")
        head = QHBoxLayout()
        head.addWidget(title, 1)
        head.addWidget(self.elapsed)
        self.bar = QProgressBar(self)
        self.bar.setTextVisible(False)
        self.bar.setAccessibleName(self.tr("Progress"))
        self.message = text_label("", "hint", self)
        grid = QGridLayout()
        grid.setVerticalSpacing(3)
        grid.setColumnStretch(1, 1)
        self._rows: dict[str, tuple[QLabel, QLabel]] = {}
        for row, stage in enumerate(STAGES):
            sign, name = QLabel(self), QLabel(self._names()[stage], self)
            sign.setFixedWidth(18)
            grid.addWidget(sign, row, 0)
            grid.addWidget(name, row, 1)
            self._rows[stage] = (sign, name)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 12, 16, 14)
        layout.setSpacing(8)
        layout.addLayout(head)
        layout.addWidget(self.bar)
        layout.addWidget(self.message)
        layout.addLayout(grid)

    def _names(self) -> dict[str, str]:
        return {
            "sea": self.tr("The sea between the ports"),
            "lattice": self.tr("The lattice of courses"),
            "wind": self.tr("The wind"),
            "search": self.tr("The fastest passage"),
            "refine": self.tr("Refining it"),
            "check": self.tr("Sailing it again, to check"),
        }

    def begin(self) -> None:
        """Start the clock."""
        self._begun = time.monotonic()
        self._ticker.start()
        self.show_progress(Progress())
        self._tick()

    def end(self) -> None:
        """Stop the clock."""
        self._ticker.stop()

    def _tick(self) -> None:
        self.elapsed.setText(fill(self.tr("{n:.1f} s"), n=time.monotonic() - self._begun))

    def show_progress(self, progress: Progress) -> None:
        """Show how far it is; the bar is the stages behind and the share of the running one."""
        for stage, (sign, name) in self._rows.items():
            mark, how = "○", "ahead"
            if stage == progress.stage:
                mark, how = "●", "runs"
            elif stage in progress.done:
                mark, how = "✓", "done"
            sign.setText(mark)
            for label in (sign, name):
                if label.property("stage") != how:
                    label.setProperty("stage", how)
                    label.style().unpolish(label)
                    label.style().polish(label)
        text = sentence(progress.message) or self.tr("Starting…")
        self.message.setText(text[0].upper() + text[1:])
        if progress.stage is None:
            self.bar.setRange(0, 0)
        else:
            self.bar.setRange(0, 100 * len(STAGES))
            self.bar.setValue(round(100 * (len(progress.done) + (progress.fraction or 0.0))))
