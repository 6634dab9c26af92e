"""The page of saved passages: open one as it was, give it another name, delete it and bring it back."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from datetime import UTC, datetime
from functools import partial
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QCoreApplication, QDate, QEvent, QLocale, Qt, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence, QResizeEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QInputDialog,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from seacruise.desktop.banner import text_label
from seacruise.desktop.jobs import JobRunner
from seacruise.desktop.language import sentence
from seacruise.desktop.messages import message_for
from seacruise.desktop.pages.flow import FlowLayout
from seacruise.desktop.pages.passages_model import Done, asked_of, brought_back, deleted, on_the_shelf
from seacruise.desktop.pages.rows import Column, Looks, RowsTable
from seacruise.desktop.style import scaled_font
from seacruise.desktop.units_choice import in_zone
from seacruise.errors import SeaCruiseError
from seacruise.export.textform import format_duration
from seacruise.passages import Entry, Listing, Opened, SavedPassages

if TYPE_CHECKING:
    from seacruise.desktop.compute import Answer
    from seacruise.passage import Passage
    from seacruise.settings import Settings

_WIDE_PX: Final = 640
"""Narrower than this there is no room for the yachts beside the names."""

_YACHT: Final = 3

Do = Callable[[SavedPassages], Any]


def tr(text: str) -> str:
    """Translate a text of this module."""
    return QCoreApplication.translate("passages", text)


def columns() -> tuple[Column, ...]:
    """Columns of the table."""
    return (
        Column(
            tr("Name"),
            tr("Name of the passage"),
            lambda e: e.name,
            lambda e: e.name.casefold(),
            "Gdynia – Visby",
            left=True,
            takes_rest=True,
        ),
        Column(
            tr("Departure"),
            tr("When she leaves"),
            lambda e: _day_and_time(in_zone(e.departure)),
            lambda e: e.departure,
            "28 May 2026 00:00",
        ),
        Column(
            tr("Duration"),
            tr("How long the passage takes"),
            lambda e: format_duration(e.duration_h),
            lambda e: e.duration_h,
            "5 d 23 h 59 min",
        ),
        Column(
            tr("Yacht"),
            tr("The yacht"),
            lambda e: e.yacht,
            lambda e: e.yacht.casefold(),
            "Bavaria 46 Cruiser",
            left=True,
        ),
    )


class Notice(QFrame):
    """A sentence and a button that does something about it: ``pressed()``."""

    pressed = Signal()

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("banner")
        self.label = text_label("", "", self)
        self.button = QPushButton(self)
        self.button.clicked.connect(self.pressed)
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 7, 10, 7)
        row.addWidget(self.label, 1)
        row.addWidget(self.button)
        self.hide()

    def say(self, kind: str, text: str, button: str = "") -> None:
        """Show a sentence; an empty one hides it."""
        self.setProperty("kind", kind)
        for widget in (self, self.label):
            widget.style().polish(widget)
        self.label.setText(text)
        self.button.setText(button)
        self.button.setVisible(bool(button))
        self.setAccessibleName(text)
        self.setVisible(bool(text))


class PassagesPage(QFrame):
    """The page.

    Signals: ``open_requested(Opened)`` with a passage as it was saved, ``save_requested()`` while there is
    none to open, ``saved(Entry)``, ``loaded(Listing)`` whenever the list was looked at, ``failed(error)``
    besides what the page itself says.
    """

    open_requested = Signal(object)
    save_requested = Signal()
    saved = Signal(object)
    loaded = Signal(object)
    failed = Signal(object)

    def __init__(self, settings: Settings, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("bar")
        self.setAccessibleName(self.tr("Saved passages"))
        self._settings = settings
        self._queue: list[tuple[Do, Callable[[Any], None]]] = []
        self._listing = Listing()
        self._undo: tuple[int, ...] = ()
        self._next_row = 0
        self.jobs = JobRunner("passages", self)
        self.jobs.finished.connect(lambda _, done: self._done(done))
        self.jobs.failed.connect(lambda _, error: self._not_done(error))
        self._make_parts()
        self._lay_out()
        self._connect()
        self._show_current()

    # --- building -----------------------------------------------------------------------------------

    def _make_parts(self) -> None:
        looks = Looks(tip=lambda entry: f"{entry.start} – {entry.end}, {entry.yacht}")
        self.table = RowsTable(self.tr("Saved passages"), columns(), looks, self)
        self.table.sortByColumn(1, Qt.SortOrder.DescendingOrder)
        self.invitation = text_label(
            self.tr("No passage is saved yet. Plan one, then save it: it will open again as it was."),
            "hint",
            self,
        )
        self.invitation.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
        self.invitation.hide()
        self.save_button = QPushButton(self.tr("&Save the passage on the chart"), self)
        self.save_button.hide()
        self.details = text_label("", "hint", self)
        self.details.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.fault, self.damage, self.undone = Notice(self), Notice(self), Notice(self)
        self.open_button = QPushButton(self.tr("&Open"), self)
        self.open_button.setObjectName("primary")
        self.rename_button = QPushButton(self.tr("&Rename…"), self)
        self.rename_button.setToolTip("F2")
        self.delete_button = QPushButton(self.tr("&Delete"), self)
        self.delete_button.setToolTip(self.tr("Del; Ctrl+Z brings it back"))

    def _lay_out(self) -> None:
        title = QLabel(self.tr("Saved passages"), self)
        title.setFont(scaled_font(self.font(), 1.15, bold=True))
        buttons = QWidget(self)
        flow = FlowLayout(buttons)
        for button in (self.open_button, self.rename_button, self.delete_button):
            flow.addWidget(button)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(12, 8, 12, 10)
        layout.setSpacing(7)
        for widget in (title, self.fault, self.damage, self.undone):
            layout.addWidget(widget)
        layout.addWidget(self.invitation)
        layout.addWidget(self.save_button, 1, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
        layout.addWidget(self.table, 10)
        layout.addWidget(self.details)
        layout.addWidget(buttons)
        self._buttons = buttons

    def _connect(self) -> None:
        self.table.chosen.connect(self._show_current)
        self.table.taken.connect(lambda _entry: self.open())
        self.open_button.clicked.connect(self.open)
        self.save_button.clicked.connect(self.save_requested)
        self.rename_button.clicked.connect(self.ask_for_name)
        self.delete_button.clicked.connect(self.delete)
        self.undone.pressed.connect(self.undo)
        self.damage.pressed.connect(self._delete_damaged)
        self.fault.pressed.connect(lambda: self.fault.say("error", ""))

    def _command(self, event: QKeyEvent) -> Callable[[], None] | None:
        """Give what a key does here; Ctrl+Z also means something to the window around."""
        if event.matches(QKeySequence.StandardKey.Undo):
            return self.undo if self._undo else None
        if event.matches(QKeySequence.StandardKey.Delete):
            return self.delete
        return self.ask_for_name if event.key() == Qt.Key.Key_F2 else None

    def event(self, event: QEvent) -> bool:
        """Claim the keys of this page before a menu does."""
        claims = isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride
        if claims and isinstance(event, QKeyEvent) and self._command(event) is not None:
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Rename with F2, delete with Del, undo with Ctrl+Z."""
        if (command := self._command(event)) is not None:
            command()
            return
        super().keyPressEvent(event)

    # --- what it does -------------------------------------------------------------------------------

    def load(self) -> None:
        """Look at what is saved, beside the window."""
        self._ask(lambda _shelf: None, lambda _value: None)

    def save(self, answer: Answer, name: str = "") -> None:
        """Save the passage that the window shows."""
        asked, now = asked_of(answer.question), datetime.now(UTC)

        def do(shelf: SavedPassages) -> Entry:
            usual = name or _usual_name(answer.passage)
            return shelf.save(answer.passage, asked, answer.wind, name=usual, now=now)

        def then(entry: Entry) -> None:
            self.table.choose(lambda one: one.number == entry.number)
            self.saved.emit(entry)

        self._ask(do, then)

    def open(self) -> None:
        """Open the passage that is chosen."""
        if (entry := self.current) is not None:
            self._ask(lambda shelf: shelf.open(entry.number), self._opened)

    def _opened(self, opened: Opened) -> None:
        self.open_requested.emit(opened)

    def ask_for_name(self) -> None:
        """Ask for another name of the passage that is chosen."""
        entry = self.current
        if entry is None:
            return
        dialog = QInputDialog(self)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setWindowTitle(self.tr("Rename"))
        dialog.setLabelText(self.tr("Name of the passage"))
        dialog.setTextValue(entry.name)
        dialog.textValueSelected.connect(lambda name: self.rename(entry.number, name))
        dialog.open()

    def rename(self, number: int, name: str) -> None:
        """Give a passage another name."""
        self._ask(lambda shelf: shelf.rename(number, name), lambda _name: None)

    def delete(self) -> None:
        """Delete the passage that is chosen; `undo` brings it back."""
        if (entry := self.current) is not None:
            # What comes next is at hand for the next key.
            self._next_row = self.table.currentIndex().row()
            self._delete((entry.number,), self.tr("“{name}” is deleted.").format(name=entry.name))

    def _delete_damaged(self) -> None:
        numbers = tuple(number for number, _ in self._listing.damaged)
        self._delete(numbers, self.tr("The damaged passages are deleted."))

    def _delete(self, numbers: tuple[int, ...], told: str) -> None:
        now = datetime.now(UTC)

        def then(_count: int) -> None:
            self._undo = numbers
            self.undone.say("info", told, self.tr("Undo"))
            self._choose_row(self._next_row)

        self._ask(lambda shelf: deleted(shelf, numbers, now), then)

    def undo(self) -> None:
        """Bring back what was deleted last."""
        numbers, self._undo = self._undo, ()
        if not numbers:
            return

        def then(count: int) -> None:
            lost = self.tr("It is gone for good: deleted passages are kept for a day.")
            self.undone.say("info", "" if count else lost)
            self.table.choose(lambda one: one.number == numbers[0])
            self.table.setFocus()

        self._ask(lambda shelf: brought_back(shelf, numbers), then)

    def take_over(self, other: PassagesPage) -> None:
        """Show what the same page of another window shows; what it has to do, it does to the end."""
        if (entry := other.current) is not None:
            self._ask(lambda _shelf: None, lambda _value: self.table.choose(partial(_is_same, entry)))
        self._undo = other.deleted
        if other.deleted:
            told = self.tr("%n passage(s) deleted.", "", len(other.deleted))
            self.undone.say("info", told, self.tr("Undo"))

    @property
    def deleted(self) -> tuple[int, ...]:
        """Numbers of what was deleted last, and can be brought back."""
        return self._undo

    # --- one thing after the other ------------------------------------------------------------------

    def _ask(self, do: Do, then: Callable[[Any], None]) -> None:
        self._queue.append((do, then))
        if len(self._queue) == 1:
            self._begin()

    def _begin(self) -> None:
        do, database = self._queue[0][0], self._settings.database
        self.jobs.run_job(lambda _job: on_the_shelf(database, do))

    def _done(self, done: Done) -> None:
        _, then = self._queue.pop(0)
        self.fault.say("error", "")
        self._show(done.listing)
        then(done.value)
        self.loaded.emit(done.listing)
        self._go_on()

    def _not_done(self, error: SeaCruiseError) -> None:
        self._queue.pop(0)
        message = message_for(error)
        self.fault.say("error", f"{message.title}. {sentence(message.sentence)}", self.tr("Close"))
        self.failed.emit(error)
        self._go_on()

    def _go_on(self) -> None:
        if self._queue:
            self._begin()

    @property
    def is_busy(self) -> bool:
        """Whether something is still to be done."""
        return bool(self._queue)

    # --- what it shows ------------------------------------------------------------------------------

    @property
    def current(self) -> Entry | None:
        """The passage that is chosen."""
        row = self.table.current
        return row if isinstance(row, Entry) else None

    def _show(self, listing: Listing) -> None:
        kept = self.current
        self._listing = listing
        self.table.show_rows(listing.entries)
        if kept is not None:
            self.table.choose(lambda one: one.number == kept.number)
        if self.current is None:
            self._choose_row(0)
        names = ", ".join(name for _, name in listing.damaged)
        self.damage.say(
            "warning",
            self.tr("Damaged and left out: {names}.").format(names=names) if names else "",
            self.tr("Delete them"),
        )
        filled = bool(listing.entries)
        for widget in (self.table, self.details, self._buttons):
            widget.setVisible(filled)
        self.invitation.setVisible(not filled)
        self.save_button.setVisible(not filled)
        self._show_current()

    def _choose_row(self, row: int) -> None:
        last = self.table.sorted.rowCount() - 1
        if last >= 0:
            self.table.selectRow(min(max(row, 0), last))

    def _show_current(self) -> None:
        entry = self.current
        for button in (self.open_button, self.rename_button, self.delete_button):
            button.setEnabled(entry is not None)
        if entry is None:
            self.details.setText("")
            return
        ends = f"{entry.start} – {entry.end}, {entry.yacht}"
        self.details.setText(f"{ends}\n{sentence(entry.provenance(datetime.now(UTC)))}")

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Leave the yachts out where there is no room; the line below names the one that is chosen."""
        super().resizeEvent(event)
        narrow = event.size().width() < _WIDE_PX
        if narrow != self.table.isColumnHidden(_YACHT):
            self.table.setColumnHidden(_YACHT, narrow)
            # The room of the column is for the names.
            self.table.show_rows(self._listing.entries)

    def shut_down(self) -> None:
        """End the worker; what was asked for is done, to the last."""
        self.jobs.shut_down(patience_s=2.0)
        waiting, self._queue = self._queue[1:], []
        for do, _ in waiting:
            with suppress(SeaCruiseError):
                on_the_shelf(self._settings.database, do)


def _is_same(entry: Entry, other: Entry) -> bool:
    return entry.number == other.number


def _usual_name(passage: Passage) -> str:
    """Ports and departure, UTC, with the month as the sailor's language writes it."""
    leaves = _day_and_time(passage.departure.astimezone(UTC))
    return f"{passage.start.name} – {passage.end.name}, {leaves}"


def _day_and_time(moment: datetime) -> str:
    day = QLocale().toString(QDate(moment.year, moment.month, moment.day), "dd MMM yyyy")
    return f"{day} {moment:%H:%M}"
