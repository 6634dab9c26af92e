"""What makes the window the sailor's own: units, passages asked lately, the guide, all that is remembered."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import UTC, datetime
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject
from PySide6.QtGui import QAction, QKeySequence

from seacruise.desktop.narrow import Columns
from seacruise.desktop.places import Places
from seacruise.desktop.preferences import LanguageMenu, UnitsMenu
from seacruise.desktop.recent import RecentPassages, via_of
from seacruise.desktop.state import Phase, WindowState
from seacruise.desktop.units_choice import units_choice

if TYPE_CHECKING:
    from seacruise.desktop.guide import Guide, Step
    from seacruise.desktop.memory import WindowMemory
    from seacruise.desktop.window import MainWindow


class Habits(QObject):
    """Joins them to the window.

    Parameters
    ----------
    window
        Has form, chart, menus, layers and steering already.
    memory
        ``None`` where nothing is to be remembered, as for a picture.
    """

    def __init__(self, window: MainWindow, memory: WindowMemory | None) -> None:
        super().__init__(window)
        self._window, self._memory = window, memory
        self.places = Places(window, memory)
        self._guide: Guide | None = None
        menus = window.menus
        self.recent = RecentPassages(menus.recent, self)
        self.units = UnitsMenu(menus.units, self)
        self.language = LanguageMenu(menus.language, memory, self)
        self.columns = Columns(window, menus.go_to, window.form, window.side)
        guide = QAction(self.tr("&Guide in three steps"), self)
        guide.setShortcut(QKeySequence("Shift+F1"))
        guide.triggered.connect(lambda _on=False: self.show_guide())
        menus.help.insertAction(menus.help.actions()[0], guide)
        self.recent.chosen.connect(self.ask_again)
        window.settled.connect(self._settled)
        self.columns.lowered.connect(self._fold_pane)
        units_choice().changed.connect(self._units_changed)
        self._watch_places()
        self._restore()

    # --- memory -------------------------------------------------------------------------------------

    @property
    def memory(self) -> WindowMemory | None:
        """What is remembered from one start to the next."""
        return self._memory

    def _watch_places(self) -> None:
        window, places = self._window, self.places
        window.desk.made.connect(lambda dialog, name, tables: places.watch(dialog, name, *tables))
        window.form.options_bar.made.connect(lambda dialog: places.watch(dialog, "options"))
        window.planning.made.connect(lambda page, name: places.watch_table(page.table, name))

    def _restore(self) -> None:
        memory, window = self._memory, self._window
        if memory is None:
            return
        units_choice().restore(memory.recall("units"))
        window.form.restore(memory.recall("form"))
        window.layers.restore(memory.recall("layers"))
        window.pane.restore(memory.recall("pane"))
        self.recent.restore(memory.recall("recent"))
        if isinstance(follows := memory.recall("live").get("on"), bool):
            window.menus.live.setChecked(follows)

    def keep(self) -> None:
        """Remember everything for the next start."""
        memory, window = self._memory, self._window
        if memory is None:
            return
        memory.keep("form", window.form.contents())
        memory.keep("layers", window.layers.contents())
        memory.keep("pane", window.pane.contents())
        memory.keep("units", units_choice().contents())
        memory.keep("recent", self.recent.contents())
        memory.keep("live", {"on": window.menus.live.isChecked()})
        self.places.keep()
        memory.keep_geometry(window, window.splitter)
        memory.flush()

    def _units_changed(self) -> None:
        view = self._window.chart.view
        view.legend.update()
        view.route.tell_again()
        view.viewport().update()

    # --- passages asked lately ----------------------------------------------------------------------

    def note_question(self) -> None:
        """Take note of what is asked, also for the case that the program does not live to be closed."""
        window = self._window
        self.recent.note(window.form.contents(), window.steering.via)
        if self._memory is not None:
            self._memory.keep("form", window.form.contents())
            self._memory.keep("recent", self.recent.contents())

    def ask_again(self, question: Mapping[str, Any]) -> None:
        """Fill in what was asked, and calculate."""
        window = self._window
        form = window.form

        def fill() -> None:
            form.sailing.reset()
            form.departure.use_first_hour(datetime.now(UTC))
            form.restore(question)

        window.steering.ask_again(fill, via_of(question))
        window.calculate()

    def _settled(self, state: WindowState) -> None:
        """Bring the answer into view where only one column has room; after an error, too: it stands there."""
        if state.phase is not Phase.CANCELLED:
            self.columns.show_column("answer")
        if self._window.pane.is_folded:
            self._fold_pane()

    def _fold_pane(self) -> None:
        """Fold the pane below the chart away, and give the chart what that leaves."""
        pane, splitter = self._window.pane, self._window.splitter
        pane.fold(folded=True)
        sizes, own = splitter.sizes(), splitter.indexOf(pane)
        height = pane.maximumHeight()
        sizes[0], sizes[own] = sizes[0] + max(sizes[own] - height, 0), min(sizes[own], height)
        splitter.setSizes(sizes)

    # --- guide --------------------------------------------------------------------------------------

    def welcome(self) -> None:
        """Show the guide to who opens the window for the first time."""
        if self._memory is not None and not self._memory.recall("guide").get("seen"):
            self.show_guide()

    def show_guide(self, step: int = 0) -> None:
        """Show the guide, from its beginning or from a later step on."""
        if self._guide is None:
            from seacruise.desktop.guide import Guide

            self._guide = Guide(self._steps(), self._window.chart)
            self._guide.closed.connect(self._guide_read)
        self.columns.show_column("question")
        self._guide.begin(step)

    @property
    def guide(self) -> Guide | None:
        """The guide, once it was shown."""
        return self._guide

    def _guide_read(self) -> None:
        if self._memory is not None:
            self._memory.keep("guide", {"seen": True})

    def _steps(self) -> tuple[Step, ...]:
        from seacruise.desktop.guide import Step

        form = self._window.form
        return (
            Step(
                self.tr("Where from, where to"),
                self.tr(
                    "Type the beginning of a port's name, or a position such as 54.5, 18.6. "
                    "Or right-click on the chart: sail from here, to here."
                ),
                form.start_field,
            ),
            Step(
                self.tr("When, and with which yacht"),
                self.tr(
                    "Choose the departure, your yacht and the forecast. Without a key and without a network "
                    "there is practice weather, to try things out."
                ),
                form.yacht_box,
            ),
            Step(
                self.tr("Calculate, then drag"),
                self.tr(
                    "Press Calculate or Ctrl+Enter. Then drag the departure below the chart, or the start or "
                    "the end: the passage follows at once."
                ),
                form.calculate_button,
            ),
        )
