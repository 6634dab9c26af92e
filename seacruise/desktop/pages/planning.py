"""Joins the pages of departures and of ports in reach to the window around them."""

from __future__ import annotations

from dataclasses import replace
from datetime import datetime
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QMenu

from seacruise.desktop.chart.plane import point
from seacruise.desktop.compute import Answer
from seacruise.desktop.messages import WayOut
from seacruise.desktop.pages.departures_page import DeparturesPage
from seacruise.desktop.pages.frame import PagesFrame
from seacruise.desktop.pages.page import Page
from seacruise.desktop.pages.reach_model import Outset
from seacruise.desktop.pages.reach_page import ReachPage
from seacruise.ports import Port

if TYPE_CHECKING:
    from seacruise.desktop.background import Catalogue
    from seacruise.desktop.equal_time import TimeLine
    from seacruise.desktop.pages.departures_model import Row
    from seacruise.desktop.state import Horizon
    from seacruise.desktop.window import MainWindow
    from seacruise.settings import Settings

_EDGE_PX: Final = 30


class Planning(QObject):
    """Both pages, with menu entries that open them.

    Parameters
    ----------
    window
        Has form, chart, menus and layers already; the pages are shown in its splitter.

    Signals: ``way_out_chosen(WayOut)`` from a banner of a page.
    """

    way_out_chosen = Signal(object)

    def __init__(self, window: MainWindow, settings: Settings) -> None:
        super().__init__(window)
        self._window = window
        self._horizon: Horizon | None = None
        self.frame = frame = PagesFrame(window.splitter)
        menu = window.menus.passage
        self.departures = DeparturesPage(settings, ask=window.steering.question, known=self._answer)
        self.reach = ReachPage(settings, ask=self._outset, known=self._answer)
        frame.add(self.departures, self.tr("When to go"))
        frame.add(self.reach, self.tr("Where to go"))
        menu.addSeparator()
        self._add_entry(menu, self.tr("When to &go"), "Ctrl+G", self.departures)
        self._add_entry(menu, self.tr("Where to g&o"), "Ctrl+Shift+G", self.reach)
        self.departures.adopted.connect(self._leave)
        self.departures.table.chosen.connect(self._compare)
        frame.turned.connect(lambda: self._compare(self.departures.table.current))
        window.layers.ways.departure_picked.connect(self._leave)
        self.reach.adopted.connect(self._sail_to)
        self.reach.port_chosen.connect(self._show_port)
        self.reach.isochrones_ready.connect(self._show_lines)
        window.background.catalogue_loaded.connect(self._take_catalogue)
        window.background.horizon_loaded.connect(self._take_horizon)
        window.form.forecast_changed.connect(lambda: self._take_horizon(None))
        for page in (self.departures, self.reach):
            page.way_out_chosen.connect(partial(self._take_way_out, page))
        window.layers.light_changed.connect(self.departures.show_light)

    def _add_entry(self, menu: QMenu, text: str, key: str, page: Page) -> None:
        action = menu.addAction(text)
        action.setShortcut(QKeySequence(key))
        action.triggered.connect(lambda _checked=False: self.frame.open_page(page))

    def _take_way_out(self, page: Page, way_out: WayOut) -> None:
        """Try again on the page itself; everything else is the window's."""
        if way_out is WayOut.RETRY:
            page.start()
        else:
            self.way_out_chosen.emit(way_out)

    def shut_down(self) -> None:
        """End the workers of both pages."""
        self.departures.shut_down()
        self.reach.shut_down()

    @property
    def is_busy(self) -> bool:
        """Whether either page computes."""
        return self.departures.jobs.is_running or self.reach.jobs.is_running

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
        self.departures.set_yachts(catalogue.yachts)
        self.reach.set_ports(catalogue.ports)

    # --- what the pages find ------------------------------------------------------------------------

    def _leave(self, moment: datetime) -> None:
        """Take a departure over; where the passage does not follow by itself, calculate it."""
        window = self._window
        follows = window.state.answer is not None and window.steering.enabled
        window.form.departure.set_moment(moment, chosen=True)
        if not follows:
            window.calculate()

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
