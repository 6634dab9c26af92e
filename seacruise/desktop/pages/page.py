"""What both pages share: what is asked at the top, one job beside the window, and its five states."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from functools import partial
from typing import Final

from PySide6.QtCore import QCoreApplication, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QDoubleSpinBox,
    QFrame,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from seacruise.desktop.banner import Banner, text_label
from seacruise.desktop.fields import copy_fields
from seacruise.desktop.jobs import JobRunner, Work
from seacruise.desktop.language import sentence
from seacruise.desktop.messages import Message, message_for
from seacruise.desktop.pages.flow import FlowLayout
from seacruise.desktop.style import scaled_font
from seacruise.errors import SeaCruiseError

MARGIN_PX: Final = 12
"""Left and right of everything on a page."""


class Phase(Enum):
    """What a page is doing."""

    EMPTY = "empty"
    BUSY = "busy"
    DONE = "done"
    FAILED = "failed"
    CANCELLED = "cancelled"


@dataclass(frozen=True, slots=True)
class Texts:
    """Words of a page: its title, its button, and what to do first."""

    title: str
    run: str
    invitation: str


def tr(text: str) -> str:
    """Translate a text of this module."""
    return QCoreApplication.translate("pages", text)


def number_box(
    name: str, *, low: float, high: float, value: float, suffix: str = "", decimals: int = 0
) -> QDoubleSpinBox:
    """Field for a number with its unit."""
    box = QDoubleSpinBox()
    box.setRange(low, high)
    box.setDecimals(decimals)
    box.setValue(value)
    box.setSuffix(suffix)
    box.setAccessibleName(name)
    box.lineEdit().setTextMargins(5, 0, 0, 0)
    widest = max((f"{low:.{decimals}f}{suffix}", f"{high:.{decimals}f}{suffix}"), key=len)
    box.setFixedWidth(box.fontMetrics().horizontalAdvance(widest) + 54)
    return box


def chip(text: str, tip: str, parent: QWidget) -> QToolButton:
    """Switch of one word."""
    button = QToolButton(parent)
    button.setObjectName("chip")
    button.setText(text)
    button.setToolTip(tip)
    button.setCheckable(True)
    return button


def _cancelled(*, has_results: bool) -> Message:
    kept = tr("What was found so far stays.") if has_results else tr("Nothing was changed.")
    return Message("info", tr("Cancelled"), kept)


class Page(QFrame):
    """A page: ``controls`` at the top, ``body`` below, of which the layout is the page's own.

    What was found stays in sight when a later job fails or is cancelled; ``heading`` tells what it is of.

    Signals: ``settled(Phase)`` when a job has ended in any way; ``way_out_chosen(WayOut)`` from a banner.
    """

    settled = Signal(object)
    way_out_chosen = Signal(object)

    def __init__(self, name: str, texts: Texts, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("bar")
        self.setAccessibleName(texts.title)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.phase = Phase.EMPTY
        self.jobs = JobRunner(name, self)
        self.jobs.progressed.connect(self._progressed)
        self.jobs.finished.connect(self._finished)
        self.jobs.failed.connect(self._failed)
        self._banner: Banner | None = None
        self.said: Callable[[], Message] | None = None
        self._make_parts(texts)
        self._lay_out(texts)
        self.setFocusProxy(self.run_button)
        self._show_phase(Phase.EMPTY)

    # --- building -----------------------------------------------------------------------------------

    def _make_parts(self, texts: Texts) -> None:
        self.heading = text_label("", "hint", self)
        self.run_button = QPushButton(texts.run, self)
        self.run_button.setObjectName("primary")
        self.run_button.clicked.connect(self.start)
        self.cancel_button = QPushButton(tr("Cancel"), self)
        self.cancel_button.clicked.connect(self.cancel)
        self.progress = QProgressBar(self)
        self.progress.setTextVisible(False)
        self.progress.setAccessibleName(tr("Progress"))
        self.message = text_label("", "hint", self)
        self.invitation = text_label(texts.invitation, "hint", self)
        self.invitation.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
        self.body = QWidget(self)

    def _lay_out(self, texts: Texts) -> None:
        self.title = QLabel(texts.title, self)
        self.title.setFont(scaled_font(self.font(), 1.15, bold=True))
        head = QHBoxLayout()
        head.setSpacing(12)
        head.addWidget(self.title)
        head.addWidget(self.heading, 1)
        top = QWidget(self)
        self.controls = FlowLayout(top)
        self._banners = QVBoxLayout()
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(MARGIN_PX, 8, MARGIN_PX, 10)
        self._layout.setSpacing(7)
        self._layout.addLayout(head)
        self._layout.addWidget(top)
        self._layout.addWidget(self.progress)
        self._layout.addWidget(self.message)
        self._layout.addLayout(self._banners)
        self._layout.addWidget(self.invitation, 1)
        self._layout.addWidget(self.body, 10)
        # Where neither is shown the room below a banner stays empty.
        self._layout.addStretch(0)

    def add_controls(self, *widgets: QWidget) -> None:
        """Put controls in a line, the page's buttons after them."""
        for widget in (*widgets, self.run_button, self.cancel_button):
            self.controls.addWidget(widget)

    # --- what a page does ---------------------------------------------------------------------------

    def make_work(self) -> Work:
        """Read the controls and give the work to do.

        Raises
        ------
        SeaCruiseError
            What is wrong with them.
        """
        # Qt's metaclass leaves no room for ABC's.
        raise NotImplementedError

    def take_delivery(self) -> None:
        """Show what the worker has handed over so far."""

    def take_result(self, result: object) -> None:
        """Show the result."""

    def show_end(self) -> None:
        """Show that the job has ended, in whichever way."""

    @property
    def has_results(self) -> bool:
        """Whether the body has anything to show."""
        raise NotImplementedError

    def start(self) -> None:
        """Begin; a second press while it runs is the same press."""
        if self.phase is Phase.BUSY:
            return
        try:
            work = self.make_work()
        except SeaCruiseError as error:
            self._end(Phase.FAILED, partial(message_for, error))
            return
        self._say(None)
        self.message.setText(tr("Starting…"))
        self.progress.setRange(0, 0)
        self.jobs.run_job(work)
        self._show_phase(Phase.BUSY)

    def cancel(self) -> None:
        """Cancel, at once, whatever the worker still does."""
        if self.jobs.cancel():
            self.take_delivery()
            self._end(Phase.CANCELLED, partial(_cancelled, has_results=self.has_results))

    def take_over(self, other: Page) -> None:
        """Go on where the same page of another window is, in another language."""
        copy_fields(other, self)
        if other.phase is Phase.BUSY:
            self.message.setText(tr("Starting…"))
            self.progress.setRange(0, 0)
        self._say(other.said)
        self._show_phase(other.phase)
        other.jobs.hand_over(self.jobs)

    def shut_down(self) -> None:
        """End the worker."""
        self.jobs.shut_down(patience_s=0.2)

    # --- what the job says --------------------------------------------------------------------------

    def _progressed(self, _generation: int, _stage: str, fraction: float | None, message: str) -> None:
        self.progress.setRange(0, 0 if fraction is None else 1000)
        self.progress.setValue(round(1000 * (fraction or 0.0)))
        said = sentence(message)
        self.message.setText(said[:1].upper() + said[1:])
        self.take_delivery()
        self._show_parts()

    def _finished(self, _generation: int, result: object) -> None:
        self.take_delivery()
        self.take_result(result)
        self._end(Phase.DONE, None)

    def _failed(self, _generation: int, error: SeaCruiseError) -> None:
        self.take_delivery()
        self._end(Phase.FAILED, partial(message_for, error))

    def _end(self, phase: Phase, message: Callable[[], Message] | None) -> None:
        self._say(message)
        self._show_phase(phase)
        self.show_end()
        self.settled.emit(phase)

    # --- what is shown ------------------------------------------------------------------------------

    def _show_phase(self, phase: Phase) -> None:
        leaves = self.cancel_button.hasFocus()
        self.phase = phase
        busy = phase is Phase.BUSY
        self.cancel_button.setEnabled(busy)
        self.cancel_button.setVisible(busy)
        self.run_button.setEnabled(not busy)
        self.progress.setVisible(busy)
        self.message.setVisible(busy)
        if leaves and not busy:
            self.run_button.setFocus()
        self._show_parts()

    def _show_parts(self) -> None:
        self.invitation.setVisible(not self.has_results and self._banner is None)
        self.body.setVisible(self.has_results)
        self.heading.setVisible(self.has_results)

    def _say(self, message: Callable[[], Message] | None) -> None:
        """Show a banner instead of the one that is there; what makes it is kept for another language."""
        self.said = message
        if self._banner is not None:
            self._banner.take_down()
            self._banner = None
        if message is not None:
            self._banner = Banner(message(), self)
            self._banner.way_out_chosen.connect(self.way_out_chosen)
            self._banners.addWidget(self._banner)

    @property
    def banner(self) -> Message | None:
        """What the banner says."""
        return None if self._banner is None else self._banner.message

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Cancel with Esc while a job runs."""
        if event.key() == Qt.Key.Key_Escape and self.phase is Phase.BUSY:
            self.cancel()
            return
        super().keyPressEvent(event)
