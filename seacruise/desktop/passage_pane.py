"""Below the chart, the passage in three ways: its legs, the weather along it, its log."""

from __future__ import annotations

from bisect import bisect_right
from datetime import datetime, timedelta
from functools import partial
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QMenu,
    QSizePolicy,
    QStackedWidget,
    QTabBar,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from seacruise.desktop.banner import text_label
from seacruise.desktop.elided import ElidedLabel
from seacruise.desktop.legs import LegsTable
from seacruise.desktop.log_table import LogTable
from seacruise.desktop.meteogram import Meteogram
from seacruise.desktop.style import show_icon
from seacruise.desktop.units_choice import units_choice

if TYPE_CHECKING:
    from seacruise.desktop.chart_pane import ChartPane
    from seacruise.desktop.compute import Answer
    from seacruise.passage import Passage

PAGES: Final = ("legs", "weather", "log")
"""Names of the tabs, from left to right."""

_LIMITLESS: Final = 16_777_215
"""Qt's QWIDGETSIZE_MAX."""

# The slider knows whole minutes; a leg that begins between two of them is meant by both.
_MINUTE: Final = timedelta(seconds=31)


class PassagePane(QFrame):
    """Three pages that show the same moment as slider and chart.

    Only the page that is seen is kept up to date: a passage that follows a hand is another one twenty times
    a second.

    Signals: ``moment_chosen(datetime)`` when the sailor chooses one here; ``leg_chosen(number)`` when the leg
    under way, or the one that was chosen, is another (-1 for none); ``shrunk(bool)`` when it
    needs less room, or more again; ``wanted()`` when a
    tab was asked for by its key, the pane being hidden or not.
    """

    moment_chosen = Signal(object)
    leg_chosen = Signal(int)
    shrunk = Signal(bool)
    wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("legs")
        self._answer: Answer | None = None
        self._moment: datetime | None = None
        self._stale: set[str] = set(PAGES)
        self._chosen = -1
        self._leads = False
        self._is_small = True
        self.legs, self.meteogram, self.log = LegsTable(self), Meteogram(self), LogTable(self)
        self.empty = text_label("", "hint", self)
        self.empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.stack = QStackedWidget(self)
        for page in (self.legs, self.meteogram, self.log, self.empty):
            self.stack.addWidget(page)
        self._make_head()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(1, 1, 1, 1)
        layout.setSpacing(0)
        layout.addWidget(self.head)
        layout.addWidget(self.stack, 1)
        self.tabs.currentChanged.connect(self._refresh)
        self.legs.row_chosen.connect(self._leg_chosen)
        self.log.row_chosen.connect(self._entry_chosen)
        self.meteogram.moment_chosen.connect(self.moment_chosen)
        units_choice().changed.connect(self._mark)
        self._refresh()

    def _make_head(self) -> None:
        self.head = QWidget(self)
        self.tabs = QTabBar(self.head)
        self.tabs.setDrawBase(False)
        self.tabs.setExpanding(False)
        self.tabs.setAccessibleName(self.tr("What is shown of the passage"))
        for text, tip in (
            (self.tr("Legs"), self.tr("Courses to steer, one row a leg (Alt+1)")),
            (self.tr("Weather along the way"), self.tr("Wind, boat speed and sea over time (Alt+2)")),
            (self.tr("Log"), self.tr("The passage told in sentences (Alt+3)")),
        ):
            self.tabs.setTabToolTip(self.tabs.addTab(text), tip)
        self.now = ElidedLabel(self.head)
        self.now.setObjectName("hint")
        self.now.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self.now.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.fold_button = QToolButton(self.head)
        self.fold_button.setIconSize(QSize(12, 12))
        self.fold_button.clicked.connect(lambda: self.fold(folded=not self.is_folded))
        row = QHBoxLayout(self.head)
        row.setContentsMargins(12, 3, 8, 2)
        row.setSpacing(10)
        row.addWidget(self.tabs)
        row.addWidget(self.now, 1)
        row.addWidget(self.fold_button)
        self._show_fold()

    # --- what is shown --------------------------------------------------------------------------------

    @property
    def page(self) -> str:
        """Name of the tab that is open, one of `PAGES`."""
        return PAGES[self.tabs.currentIndex()]

    def show_page(self, name: str) -> None:
        """Open a tab and give it the keyboard."""
        self.fold(folded=False)
        self.tabs.setCurrentIndex(PAGES.index(name))
        if (page := self.stack.currentWidget()) is not None:
            page.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def join(self, chart: ChartPane, menu: QMenu) -> None:
        """Show the same moment and leg as a chart and its slider; add to a menu what opens each tab."""
        bar, view = chart.time_bar, chart.view
        self.leg_chosen.connect(lambda leg: view.route.choose_leg(None if leg < 0 else leg))
        self.moment_chosen.connect(bar.set_moment)
        bar.moved.connect(self.show_time)
        view.leg_picked.connect(self.choose_leg)
        for name, text, key in (
            ("legs", self.tr("L&egs of the passage"), "Alt+1"),
            ("weather", self.tr("We&ather along the way"), "Alt+2"),
            ("log", self.tr("L&og of the passage"), "Alt+3"),
        ):
            action = menu.addAction(text)
            action.setShortcut(QKeySequence(key))
            action.triggered.connect(partial(self._wanted, name))

    def _wanted(self, name: str, _checked: bool = False) -> None:
        self.wanted.emit()
        self.show_page(name)

    def show_answer(self, answer: Answer | None) -> None:
        """Show another passage, or none."""
        self._answer = answer
        self._chosen = -1
        self._moment = None if answer is None else _within(answer.passage, self._moment)
        self._stale = set(PAGES)
        self._refresh()

    def show_time(self, moment: datetime) -> None:
        """Show a moment that was chosen elsewhere."""
        self._moment = moment
        self._mark()

    def show_light(self, light: str) -> None:
        """Draw in the colours of a light: ``day``, ``dusk`` or ``night``."""
        self.legs.legs.show_light(light)
        self.meteogram.show_light(light)

    def _refresh(self) -> None:
        """Bring the page that is seen up to date."""
        name, answer = self.page, self._answer
        if answer is None:
            self._clear()
        elif name in self._stale and not self.is_folded:
            if name == "legs":
                self.legs.show_passage(answer.passage)
            elif name == "log":
                self._write_log(answer)
            self._stale.discard(name)
        if answer is not None:
            # Its words stand in the head, whatever page is open.
            if "weather" in self._stale or name == "weather":
                self.meteogram.show_passage(answer.passage, answer.wind)
                self._stale.discard("weather")
            self.stack.setCurrentIndex(PAGES.index(name))
        self.take_room()
        self._mark()

    def _write_log(self, answer: Answer) -> None:
        from seacruise.narrative import tell

        self.log.log.show_entries(tell(answer.passage, wind=answer.wind, wanted=answer.question.departure))

    def _clear(self) -> None:
        self.legs.show_passage(None)
        self.log.log.show_entries(())
        self.meteogram.show_passage(None)
        self.now.say("")
        self.empty.setText(self._promise())
        self.stack.setCurrentWidget(self.empty)

    def _promise(self) -> str:
        """Say what will be here once there is a passage."""
        return {
            "legs": self.tr(
                "Once there is a passage: each leg with its time, course, distance, wind and sail. "
                "Choosing a leg shows it on the chart."
            ),
            "weather": self.tr(
                "Once there is a passage: wind, gusts, angle to the wind and boat speed hour by hour, "
                "with the nights and the end of the forecast."
            ),
            "log": self.tr(
                "Once there is a passage: what you would write into the log, from leaving port to arriving: "
                "headlands, tacks, changes of the wind, sunrise and sunset."
            ),
        }[self.page]

    def _mark(self) -> None:
        """Mark the moment on the page that is seen, and say it."""
        answer, moment = self._answer, self._moment
        if answer is None or moment is None:
            return
        self.meteogram.show_time(moment)
        self.now.say(self.meteogram.brief_words())
        if self._leads:
            return
        leg = self._leg_at(moment)
        if self._chosen not in {-1, leg}:
            self._chosen = leg
            self.leg_chosen.emit(leg)
        if self.page == "legs" and not self.is_folded:
            self.legs.mark(leg)
        elif self.page == "log" and not self.is_folded:
            self.log.mark(self.log.log.row_at(moment + _MINUTE))

    def _leg_at(self, moment: datetime) -> int:
        assert self._answer is not None
        waypoints = self._answer.passage.waypoints
        return max(0, bisect_right(waypoints, moment + _MINUTE, key=lambda w: w.time) - 1)

    # --- what is chosen -------------------------------------------------------------------------------

    def choose_leg(self, number: int) -> None:
        """Choose a leg that was picked on the chart; -1 chooses none."""
        if self.page == "legs" and not self.is_folded:
            self.legs.choose_leg(number)
        else:
            self._leg_chosen(number)

    def _leg_chosen(self, number: int) -> None:
        self._chosen = number
        self.leg_chosen.emit(number)
        if self._answer is not None and 0 <= number < len(self._answer.passage.waypoints):
            self._lead_to(self._answer.passage.waypoints[number].time)

    def _entry_chosen(self, number: int) -> None:
        entries = self.log.log.entries
        if 0 <= number < len(entries):
            self._lead_to(entries[number].time)

    def _lead_to(self, moment: datetime) -> None:
        """Let the others follow: of several rows within a minute the one that was chosen stays chosen."""
        self._leads = True
        try:
            self.moment_chosen.emit(moment)
        finally:
            self._leads = False

    # --- folding --------------------------------------------------------------------------------------

    @property
    def is_folded(self) -> bool:
        """Whether only the tabs are seen."""
        return self.stack.isHidden()

    def fold(self, *, folded: bool) -> None:
        """Leave only the tabs, or show their pages again."""
        if folded == self.is_folded:
            return
        self.stack.setVisible(not folded)
        self._show_fold()
        self._refresh()

    def take_room(self) -> None:
        """Take no more room than there is to show: tabs alone when folded, one sentence without a passage."""
        small = self.is_folded or self._answer is None
        height = self.head.sizeHint().height() + 4
        if small and not self.is_folded:
            height += 3 * self.fontMetrics().height()
        if small and not self._is_small:
            self.setProperty("openHeight", self.height())
        self._is_small = small
        most = height if small else _LIMITLESS
        if most != self.maximumHeight():
            self.setMaximumHeight(most)
            self.shrunk.emit(small)

    def _show_fold(self) -> None:
        show_icon(self.fold_button, "chevron-up" if self.is_folded else "chevron-down")
        text = self.tr("Show the pages") if self.is_folded else self.tr("Fold the pages away")
        self.fold_button.setToolTip(text)
        self.fold_button.setAccessibleName(text)

    # --- memory ---------------------------------------------------------------------------------------

    def contents(self) -> dict[str, object]:
        """Give what is worth keeping for the next start."""
        height = self.property("openHeight") if self._is_small else self.height()
        return {"page": self.page, "folded": self.is_folded, "height": height or 0}

    def restore(self, kept: dict[str, Any]) -> None:
        """Show what `contents` gave; what is not of its kind, as in a damaged file, is passed over."""
        if kept.get("page") in PAGES:
            self.tabs.setCurrentIndex(PAGES.index(str(kept["page"])))
        height = kept.get("height")
        if isinstance(height, int) and height > self.maximumHeight():
            self.setProperty("openHeight", height)
        if isinstance(kept.get("folded"), bool):
            self.fold(folded=kept["folded"])


def _within(passage: Passage, moment: datetime | None) -> datetime:
    """Give a moment while a passage lasts, or else its departure."""
    if moment is not None and passage.departure <= moment <= passage.arrival:
        return moment
    return passage.departure
