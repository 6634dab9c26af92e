"""When to go: many departures of the passage of the form, as a curve, a table and a sentence."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from datetime import timedelta
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QBoxLayout,
    QButtonGroup,
    QCheckBox,
    QComboBox,
    QHBoxLayout,
    QPushButton,
    QStackedWidget,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from seacruise.desktop.banner import first_sentence, text_label
from seacruise.desktop.compute import Answer, Fetcher, Question, fetch_wind
from seacruise.desktop.jobs import Work
from seacruise.desktop.language import sentence
from seacruise.desktop.pages.departures_curve import DepartureCurve
from seacruise.desktop.pages.departures_matrix import YachtMatrix
from seacruise.desktop.pages.departures_model import (
    Begun,
    Comparer,
    Comparison,
    Delivery,
    Measure,
    Row,
    Wish,
    compare_departures,
    compare_passages,
)
from seacruise.desktop.pages.departures_table import (
    LEAST_MOTOR_H,
    MOTOR_COLUMN,
    NOTE_COLUMN,
    YACHT_COLUMN,
    columns,
    tip_of,
)
from seacruise.desktop.pages.flow import named
from seacruise.desktop.pages.inbox import Inbox
from seacruise.desktop.pages.page import MARGIN_PX, Page, Phase, chip, number_box
from seacruise.desktop.pages.rows import Looks, RowsTable
from seacruise.desktop.pages.words import (
    departures_texts,
    reason_of,
    run_text,
    short_moment,
    tr,
    verdict_sentences,
)
from seacruise.desktop.style import scaled_font
from seacruise.desktop.units_choice import units_choice

if TYPE_CHECKING:
    from seacruise.settings import Settings
    from seacruise.yacht.polar import Polar

Course = tuple[Wish | None, Inbox[Delivery], Begun | None, Comparison | None, int, int | None]
"""What is asked, where it arrives, what has begun, what is shown, what the curve shows, the row chosen."""

MOST_YACHTS: Final = 4
"""Curves of more yachts than this are not told apart."""

_SIDE_BY_SIDE_PX: Final = 620
_CURVE_PX: Final = 162


class DeparturesPage(Page):
    """Compares departures; a click on one, or Enter, adopts it.

    Parameters
    ----------
    ask
        Gives the passage of the form, or raises `InputError`.
    known
        Gives the passage that is shown, for its wind, or ``None``.
    fetcher, comparer
        What computes; tests put their own in.

    Signals: ``adopted(datetime)``, besides those of `Page`.
    """

    adopted = Signal(object)

    def __init__(
        self,
        settings: Settings,
        *,
        ask: Callable[[], Question],
        known: Callable[[], Answer | None] = lambda: None,
        fetcher: Fetcher = fetch_wind,
        comparer: Comparer = compare_passages,
        parent: QWidget | None = None,
    ) -> None:
        self._settings, self._ask, self._known = settings, ask, known
        self._fetcher, self._comparer = fetcher, comparer
        self._comparison: Comparison | None = None
        self._begun: Begun | None = None
        self._current: int | None = None
        self._inbox: Inbox[Delivery] = Inbox()
        self._asked: Wish | None = None
        self._yachts: dict[str, Polar] = {}
        self._extra: dict[str, QPushButton] = {}
        super().__init__("departures", departures_texts(), parent)
        self._make_controls()
        self._make_results()

    # --- building -----------------------------------------------------------------------------------

    def _make_controls(self) -> None:
        self.count_box = number_box(self.tr("Number of departures"), low=2, high=100, value=8)
        self.every_box = number_box(
            self.tr("Hours between departures"), low=1, high=168, value=6, suffix=self.tr(" h")
        )
        for box in (self.count_box, self.every_box):
            box.lineEdit().returnPressed.connect(self.start)
        self.yacht_box = QComboBox(self)
        self.yacht_box.setPlaceholderText(self.tr("Another yacht"))
        self.yacht_box.setAccessibleName(self.tr("Compare another yacht too"))
        self.yacht_box.setToolTip(self.tr("Compare another yacht too"))
        self.yacht_box.setFixedWidth(150)
        self.yacht_box.activated.connect(lambda at: self.add_yacht(self.yacht_box.itemText(at)))
        self.yacht_box.setEnabled(False)
        self.members_box = QCheckBox(self.tr("Ensemble"), self)
        self.members_box.setChecked(True)
        self.members_box.setToolTip(
            self.tr("Plan for each member too, where the forecast has members: the band behind the curve")
        )
        self.add_controls(
            named(self.tr("Depart&ures"), self.count_box),
            named(self.tr("eve&ry"), self.every_box),
            self.yacht_box,
            self.members_box,
        )

    def _make_results(self) -> None:
        self.sentence = text_label("", parent=self.body)
        self.sentence.setFont(scaled_font(self.font(), 1.1, bold=True))
        self.notice = text_label("", "hint", self.body)
        self.curve = DepartureCurve(self.body)
        self.detail = text_label("", "hint", self.body)
        self.adopt_button = QPushButton(self.tr("Leave then"), self.body)
        self.adopt_button.setToolTip(self.tr("Take this departure for the passage (Enter)"))
        self.adopt_button.clicked.connect(lambda: self._take(self.table.current))
        looks = Looks(self._note, NOTE_COLUMN, tip_of, lambda row: row.is_best)
        self.table: RowsTable = RowsTable(self.tr("Departures compared"), columns(), looks, self.body)
        self.matrix = YachtMatrix(self.body)
        self._tables = QStackedWidget(self.body)
        for table in (self.table, self.matrix):
            self._tables.addWidget(table)
        self.matrix.chosen.connect(lambda row: None if row is None else self._choose(row.number))
        self.matrix.taken.connect(self._take)
        units_choice().changed.connect(self._show_results)
        self.curve.chosen.connect(self._choose)
        self.curve.taken.connect(self._take_number)
        self.table.chosen.connect(self._row_chosen)
        self.table.taken.connect(self._take)
        self.table.pressed_row.connect(self._take)
        upper = QHBoxLayout()
        upper.addWidget(self.sentence, 1)
        for button in self._make_measures():
            upper.addWidget(button, 0, Qt.AlignmentFlag.AlignTop)
        self._halves = QBoxLayout(QBoxLayout.Direction.TopToBottom)
        self._halves.setSpacing(10)
        self._halves.addWidget(self.curve, 2)
        self._halves.addWidget(self._tables, 3)
        below = QHBoxLayout()
        below.addWidget(self.detail, 1)
        below.addWidget(self.adopt_button, 0, Qt.AlignmentFlag.AlignTop)
        layout = QVBoxLayout(self.body)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(6)
        layout.addLayout(upper)
        layout.addWidget(self.notice)
        layout.addLayout(self._halves, 1)
        layout.addLayout(below)
        self._tables.setMinimumHeight(5 * self.table.verticalHeader().defaultSectionSize())

    def _make_measures(self) -> list[QToolButton]:
        self._measures = QButtonGroup(self)
        buttons: list[QToolButton] = []
        for text, tip in (
            (self.tr("Duration"), self.tr("Hours under way over the departure")),
            (self.tr("Arrival"), self.tr("Moment of arrival over the departure")),
        ):
            button = chip(text, tip, self.body)
            button.setChecked(not buttons)
            self._measures.addButton(button, len(buttons))
            buttons.append(button)
        self._measures.idToggled.connect(lambda _number, on: self._show_results() if on else None)
        self.matrix_button = chip(
            self.tr("By yacht"),
            self.tr("A column for each yacht, in place of every figure of each passage"),
            self.body,
        )
        self.matrix_button.setChecked(True)
        self.matrix_button.hide()
        self.matrix_button.toggled.connect(lambda _on: self._show_table())
        return [*buttons, self.matrix_button]

    # --- yachts -------------------------------------------------------------------------------------

    def set_yachts(self, yachts: Mapping[str, Polar]) -> None:
        """Take the yachts over that can be compared."""
        self._yachts = dict(yachts)
        for name in [name for name in self._extra if name not in yachts]:
            self._drop_yacht(name)
        self.yacht_box.clear()
        self.yacht_box.addItems(list(yachts))
        self.yacht_box.setCurrentIndex(-1)
        self._offer_yachts()

    def add_yacht(self, name: str) -> None:
        """Compare another yacht too; pressing its button leaves it out again."""
        self.yacht_box.setCurrentIndex(-1)
        if name not in self._yachts or name in self._extra or len(self._extra) >= MOST_YACHTS - 1:
            return
        button = QPushButton(f"✕ {name}", self)
        button.setObjectName("flat")
        button.setToolTip(self.tr("Leave {yacht} out").format(yacht=name))
        button.setAccessibleName(self.tr("Leave {yacht} out").format(yacht=name))
        button.clicked.connect(lambda: self._drop_yacht(name))
        self._extra[name] = button
        self.controls.addWidget(button)
        self._offer_yachts()

    def _drop_yacht(self, name: str) -> None:
        button = self._extra.pop(name)
        self.controls.removeWidget(button)
        button.hide()
        button.deleteLater()
        self._offer_yachts()
        self.yacht_box.setFocus()

    def _offer_yachts(self) -> None:
        self.yacht_box.setEnabled(bool(self._yachts) and len(self._extra) < MOST_YACHTS - 1)

    @property
    def extra_yachts(self) -> list[str]:
        """Yachts that are compared besides the one of the form."""
        return list(self._extra)

    # --- the job ------------------------------------------------------------------------------------

    def make_work(self) -> Work:
        """Ask the form, and compare what it asks.

        Raises
        ------
        InputError
            The form cannot be computed.
        """
        question = self._ask()
        wish = Wish(
            question,
            int(self.count_box.value()),
            timedelta(hours=self.every_box.value()),
            tuple(self._yachts[name] for name in self._extra if name != question.yacht.name),
            members=self.members_box.isChecked(),
        )
        inbox: Inbox[Delivery] = Inbox()
        self._inbox, self._asked = inbox, wish
        settings, known, fetcher, comparer = self._settings, self._known(), self._fetcher, self._comparer

        def work(job: Any) -> None:
            compare_departures(
                wish,
                settings=settings,
                job=job,
                deliver=inbox.put,
                known=known,
                fetcher=fetcher,
                comparer=comparer,
            )

        return work

    @property
    def course(self) -> Course:
        """What is asked and what has come of it, also while it still comes."""
        measure = self._measures.checkedId()
        return self._asked, self._inbox, self._begun, self._comparison, measure, self._current

    def take_over(self, other: Page) -> None:
        """Go on where the same page of another window is."""
        assert isinstance(other, DeparturesPage)
        for name in other.extra_yachts:
            self.add_yacht(name)
        self._asked, self._inbox, self._begun, self._comparison, measure, chosen = other.course
        super().take_over(other)
        self._measures.button(measure).setChecked(True)
        if self._comparison is not None:
            self._show_head()
            self._show_results()
            self.table.choose(lambda row: row.number == chosen)

    @property
    def has_results(self) -> bool:
        """Whether departures were compared."""
        return self._comparison is not None

    @property
    def comparison(self) -> Comparison | None:
        """What is shown."""
        return self._comparison

    def take_delivery(self) -> None:
        """Show the passages that have come."""
        items = self._inbox.take()
        for item in items:
            if isinstance(item, Begun):
                self._begun = item
                continue
            if self._begun is not None:
                # Only now: what was compared before stays in sight until there is something else.
                self._comparison, self._begun = Comparison(self._begun), None
                self._show_head()
                self.table.show_rows(())
            if self._comparison is not None:
                self._comparison.add(item)
        if items:
            self._show_results()

    def show_end(self) -> None:
        """Choose the best departure where none was chosen, and say it without reserve."""
        self._show_results()
        fastest = None if self._comparison is None else self._comparison.fastest()
        if fastest is not None and self.table.current is None:
            self.table.choose(lambda row: row.run is fastest.best)

    # --- what is shown ------------------------------------------------------------------------------

    def _show_head(self) -> None:
        assert self._comparison is not None
        assert self._asked is not None
        begun, question = self._comparison.begun, self._asked.question
        self.heading.setText(f"{begun.start} – {begun.end}, {', '.join(self._comparison.yachts)}")
        notices = [first_sentence(sentence(begun.forecast.notice))]
        if question.via is not None:
            notices.append(
                self.tr("Compared is the direct passage, not by way of {via}.").format(via=question.via.name)
            )
        self.notice.setText(" ".join(filter(None, notices)))
        self.notice.setVisible(bool(self.notice.text()))
        several = len(self._comparison.yachts) > 1
        self.table.setColumnHidden(YACHT_COLUMN, not several)
        self.matrix_button.setVisible(several)
        self._show_table()

    def _show_table(self) -> None:
        by_yacht = not self.matrix_button.isHidden() and self.matrix_button.isChecked()
        self._tables.setCurrentWidget(self.matrix if by_yacht else self.table)
        self._share_room()

    @property
    def measure(self) -> Measure:
        """What the curve shows."""
        return "arrival" if self._measures.checkedId() == 1 else "duration"

    def _show_results(self) -> None:
        comparison = self._comparison
        if comparison is None:
            return
        rows = comparison.rows()
        self.table.show_rows(rows)
        motored = any(row.run is not None and (row.run.motor_h or 0.0) >= LEAST_MOTOR_H for row in rows)
        self.table.setColumnHidden(MOTOR_COLUMN, not motored)
        self.matrix.cells.show_rows(rows, comparison.yachts, self.measure)
        self._share_room()
        self.curve.show_curves(
            comparison.curves(self.measure),
            self.measure,
            missing=frozenset(row.number for row in rows if row.run is not None and not row.found),
            best=frozenset(row.number for row in rows if row.is_best),
        )
        said = " ".join(verdict_sentences(comparison))
        if comparison.known < len(rows):
            so_far = self.tr("So far: {said}"), self.tr("Of the {n} that were compared: {said}")
            said = so_far[self.phase is not Phase.BUSY].format(n=comparison.known, said=said)
        if said != self.sentence.text():
            self.sentence.setText(said)
        self._show_detail(self.table.current)

    def _show_detail(self, row: Row | None) -> None:
        if row is None:
            text = self.tr("Choose a departure in the curve or in the table.")
        elif row.run is None:
            text = self.tr("{leaves}: not known yet.").format(leaves=short_moment(row.departure))
        else:
            text = run_text(row.run)
        self.detail.setText(text)
        self.adopt_button.setEnabled(row is not None and row.found)

    def _note(self, row: Row) -> str:
        """Say in place of figures why there are none."""
        if row.run is None:
            return "…" if self.phase is Phase.BUSY else tr("not compared")
        return reason_of(row.run)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Put curve and table side by side where there is room, else one above the other."""
        super().resizeEvent(event)
        self._share_room()

    def _share_room(self) -> None:
        """Give the table what it needs, as long as enough is left to the curve."""
        wide = self.width() >= _SIDE_BY_SIDE_PX
        side = QBoxLayout.Direction.LeftToRight if wide else QBoxLayout.Direction.TopToBottom
        if self._halves.direction() != side:
            self._halves.setDirection(side)
        room = self.width() - 2 * MARGIN_PX - self._halves.spacing()
        share = max(round(0.6 * room), min(self.table.needed_px, room - _CURVE_PX))
        for part, stretch in enumerate((room - share, share) if wide else (2, 3)):
            self._halves.setStretch(part, stretch)

    def show_light(self, light: str) -> None:
        """Draw in the colours of a light."""
        self.curve.show_light(light)
        self.matrix.cells.light = light

    # --- choosing -----------------------------------------------------------------------------------

    def _choose(self, number: int) -> None:
        self.table.choose(lambda row: row.number == number)

    def _row_chosen(self, row: Row | None) -> None:
        number = self._current = None if row is None else row.number
        self.curve.choose(number)
        self.matrix.choose(number)
        self._show_detail(row)

    def _take_number(self, number: int) -> None:
        self._choose(number)
        self._take(self.table.current)

    def _take(self, row: Row | None) -> None:
        """Adopt a departure that has a passage."""
        if row is not None and row.found:
            self.adopted.emit(row.departure)
