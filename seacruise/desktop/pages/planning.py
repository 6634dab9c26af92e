"""Joins the pages of departures and of ports in reach to the window around them."""

from __future__ import annotations

from dataclasses import replace
from datetime import datetime
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QMenu

from seacruise.desktop.chart.plane import point
from seacruise.desktop.compute import Answer
from seacruise.desktop.messages import WayOut
from seacruise.desktop.pages.frame import PagesFrame
from seacruise.desktop.style import show_light
from seacruise.ports import Port

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from seacruise.desktop.background import Catalogue
    from seacruise.desktop.equal_time import TimeLine
    from seacruise.desktop.pages.departures_model import Row
    from seacruise.desktop.pages.departures_page import DeparturesPage
    from seacruise.desktop.pages.page import Page
    from seacruise.desktop.pages.reach_model import Outset
    from seacruise.desktop.pages.reach_page import ReachPage
    from seacruise.desktop.state import Horizon
    from seacruise.desktop.window import MainWindow
    from seacruise.settings import Settings

_EDGE_PX: Final = 30
_PAUSE_MS: Final = 120
_MODULES: Final = (
    "departures_curve", "departures_matrix", "departures_page", "reach_model", "reach_page",
    "weather_model", "key_box", "source_card", "weather_page",
)  # fmt: skip
"""What these pages and that of the weather are made of, in portions loaded in a few milliseconds each."""


class Planning(QObject):
    """Both pages, with menu entries that open them; each is made when it is first wanted.

    Parameters
    ----------
    window
        Has form, chart, menus and layers already; the pages are shown in its splitter.

    Signals: ``way_out_chosen(WayOut)`` from a banner of a page; ``made(page, name)`` when one was made.
    """

    way_out_chosen = Signal(object)
    made = Signal(object, str)

    def __init__(self, window: MainWindow, settings: Settings) -> None:
        super().__init__(window)
        self._window, self._settings = window, settings
        self._horizon: Horizon | None = None
        self._catalogue: Catalogue | None = None
        self._departures: DeparturesPage | None = None
        self._reach: ReachPage | None = None
        self._steps: Iterator[None] | None = None
        self.frame = frame = PagesFrame(window.splitter)
        menu = window.menus.passage
        frame.offer(self.tr("When to go"), lambda: self.departures)
        frame.offer(self.tr("Where to go"), lambda: self.reach)
        menu.addSeparator()
        self._add_entry(menu, self.tr("When to &go"), "Ctrl+G", lambda: self.departures)
        self._add_entry(menu, self.tr("Where to g&o"), "Ctrl+Shift+G", lambda: self.reach)
        frame.turned.connect(self._turned)
        window.layers.ways.departure_picked.connect(self._leave)
        window.layers.ways.turns_picked.connect(self._turn)
        window.background.catalogue_loaded.connect(self._take_catalogue)
        window.background.horizon_loaded.connect(self._take_horizon)
        window.form.forecast_changed.connect(lambda: self._take_horizon(None))
        window.layers.light_changed.connect(self._light_changed)

    def _add_entry(self, menu: QMenu, text: str, key: str, page: Callable[[], Page]) -> None:
        action = menu.addAction(text)
        action.setShortcut(QKeySequence(key))
        action.triggered.connect(lambda _checked=False: self.frame.open_page(page()))

    # --- making pages -------------------------------------------------------------------------------

    @property
    def departures(self) -> DeparturesPage:
        """The page that compares departures."""
        if self._departures is None:
            from seacruise.desktop.pages.departures_page import DeparturesPage

            # In its place at once: each change of the parent has all its widgets styled anew.
            page = DeparturesPage(
                self._settings,
                ask=self._window.steering.question,
                known=self._answer,
                parent=self.frame.stack,
            )
            self._departures = page
            page.adopted.connect(self._leave)
            page.table.chosen.connect(self._compare)
            page.show_light(self._window.layers.light)
            if self._catalogue is not None:
                page.set_yachts(self._catalogue.yachts)
            self._join(0, page, "departures")
        return self._departures

    @property
    def reach(self) -> ReachPage:
        """The page of ports in reach."""
        if self._reach is None:
            from seacruise.desktop.pages.reach_page import ReachPage

            page = ReachPage(self._settings, ask=self._outset, known=self._answer, parent=self.frame.stack)
            self._reach = page
            page.adopted.connect(self._sail_to)
            page.port_chosen.connect(self._show_port)
            page.isochrones_ready.connect(self._show_lines)
            if self._catalogue is not None:
                page.set_ports(self._catalogue.ports)
            self._join(1, page, "reach")
        return self._reach

    def _join(self, number: int, page: Page, name: str) -> None:
        page.way_out_chosen.connect(partial(self._take_way_out, page))
        show_light(page, self._window.layers.light)
        self.frame.take_in(number, page)
        self.made.emit(page, name)

    @property
    def made_pages(self) -> tuple[DeparturesPage | None, ReachPage | None]:
        """The pages of departures and of ports in reach, each ``None`` while nobody has wanted it."""
        return self._departures, self._reach

    def prepare(self) -> None:
        """Make both pages in short steps while nobody waits, so that the first look at one is no wait."""
        self._steps = self._prepare()
        QTimer.singleShot(_PAUSE_MS, self._go_on)

    def _go_on(self) -> None:
        if self._steps is not None and next(self._steps, self) is None:
            QTimer.singleShot(_PAUSE_MS, self._go_on)

    def _prepare(self) -> Iterator[None]:
        for name in _MODULES:
            import_module(f"seacruise.desktop.pages.{name}")
            yield
        _ = self.departures
        yield
        _ = self.reach

    def _take_way_out(self, page: Page, way_out: WayOut) -> None:
        """Try again on the page itself; everything else is the window's."""
        if way_out is WayOut.RETRY:
            page.start()
        else:
            self.way_out_chosen.emit(way_out)

    def take_over(self, other: Planning) -> None:
        """Go on where the pages of another window are; open they are when `frame` takes over, too."""
        departures, reach = other.made_pages
        if departures is not None:
            self.departures.take_over(departures)
        if reach is not None:
            self.reach.take_over(reach)

    def shut_down(self) -> None:
        """End the workers of both pages."""
        self._steps = None
        for page in self.made_pages:
            if page is not None:
                page.shut_down()

    @property
    def is_busy(self) -> bool:
        """Whether either page computes."""
        return any(page is not None and page.jobs.is_running for page in self.made_pages)

    # --- what the pages ask -------------------------------------------------------------------------

    def _answer(self) -> Answer | None:
        """Give the passage shown when its wind is the whole forecast; one that was saved has a part of it."""
        answer, horizon = self._window.state.answer, self._horizon
        if answer is None or horizon is None or answer.wind.forecast.valid_to < horizon.last:
            return None
        return answer

    def _take_horizon(self, horizon: Horizon | None) -> None:
        self._horizon = horizon

    def _outset(self) -> Outset:
        """Read the form, which needs no end for this.

        Raises
        ------
        InputError
            What is wrong with it.
        """
        window = self._window
        return replace(window.form.outset(), avoid=window.steering.avoided.zones)

    def _take_catalogue(self, catalogue: Catalogue) -> None:
        self._catalogue = catalogue
        if self._departures is not None:
            self._departures.set_yachts(catalogue.yachts)
        if self._reach is not None:
            self._reach.set_ports(catalogue.ports)

    def _light_changed(self, light: str) -> None:
        if self._departures is not None:
            self._departures.show_light(light)

    # --- what the pages find ------------------------------------------------------------------------

    def _leave(self, moment: datetime) -> None:
        """Take a departure over; where the passage does not follow by itself, calculate it."""
        window = self._window
        follows = window.state.answer is not None and window.steering.enabled
        window.form.departure.set_moment(moment, chosen=True)
        if not follows:
            window.calculate()

    def _turn(self, most: int | None) -> None:
        """Allow so many tacks and gybes; where the passage does not follow by itself, calculate it."""
        window = self._window
        follows = window.state.answer is not None and window.steering.enabled
        window.form.sailing.put({"most_turns": most})
        if not follows:
            window.calculate()

    def _turned(self) -> None:
        if self._departures is not None:
            self._compare(self._departures.table.current)

    def _compare(self, row: Row | None) -> None:
        """Show the way of the chosen departure faintly, while its page is open."""
        shown = row is not None and self.frame.is_open and self.departures.isVisible()
        self._window.layers.ways.compare(row.run if row is not None and shown else None)

    def _sail_to(self, port: Port) -> None:
        self._window.form.set_end("to", port)
        self._window.calculate()

    def _show_port(self, port: Port) -> None:
        """Bring a port into view, unless it is there."""
        view = self._window.chart.view
        seen = view.viewport().rect().adjusted(_EDGE_PX, _EDGE_PX, -_EDGE_PX, -_EDGE_PX)
        if not seen.contains(view.mapFromScene(point(port.lat, port.lon))):
            view.show_place(port.lat, port.lon)

    def _show_lines(self, lines: list[TimeLine]) -> None:
        """Show the lines of equal time of the reach, until there is another passage."""
        window = self._window
        window.menus.layers["isochrones"].setChecked(True)
        # Switched on, the layer looks for the lines of the passage; these were asked for later.
        window.layers.jobs.cancel()
        window.chart.view.isochrones.show_lines(lines)
        window.chart.view.viewport().update()
