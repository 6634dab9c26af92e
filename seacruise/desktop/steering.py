"""What the sailor changes once there is a passage is sailed anew at once: ends, departure, yacht, areas."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from datetime import datetime

from PySide6.QtCore import QObject, Signal

from seacruise.desktop.avoid import Avoided
from seacruise.desktop.chart_pane import ChartPane
from seacruise.desktop.compute import Planner, Question
from seacruise.desktop.form import PassageForm
from seacruise.desktop.live import LiveRouter
from seacruise.desktop.state import Phase, WindowState
from seacruise.errors import InputError
from seacruise.geodesy import format_position
from seacruise.ports import Port
from seacruise.sea.zones import NO_ZONES, Zones
from seacruise.settings import Settings


class Steering(QObject):
    """Joins form, chart and time bar to the live router.

    Nothing is fetched: as long as the forecast of the form is that of the passage shown, its wind is used.

    Parameters
    ----------
    form, chart
        Of the window.
    state
        Tells what the window shows.

    ``taken_over()`` when form and chart ask what a saved passage asked: there is nothing to undo then.
    """

    taken_over = Signal()

    def __init__(
        self,
        settings: Settings,
        planner: Planner,
        *,
        form: PassageForm,
        chart: ChartPane,
        state: Callable[[], WindowState],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._form, self._chart, self._state = form, chart, state
        self.router = LiveRouter(settings, planner, self)
        self.avoided = Avoided(self)
        self.enabled = True
        self.via: Port | None = None
        self._layers = NO_ZONES
        bar, view = chart.time_bar, chart.view
        form.sailing_changed.connect(self.follow)
        form.departure.changed.connect(lambda: bar.set_departure(form.departure.moment))
        form.ends_changed.connect(self._show_ends)
        bar.departure_moved.connect(self._departure_moved)
        bar.departure_settled.connect(self.router.settle)
        view.end_dragged.connect(self._end_dragged)
        view.end_picked.connect(self._end_picked)
        view.via_dropped.connect(lambda: self._set_via(None))
        view.avoid_picked.connect(self.avoided.add)
        view.avoid_dropped.connect(self.avoided.remove)
        self.avoided.changed.connect(self._areas_changed)

    def question(self) -> Question:
        """Say what form and chart ask.

        Raises
        ------
        InputError
            What is wrong, and in which field.
        """
        return replace(self._form.question(), via=self.via, avoid=self.avoided.zones)

    def show_layers(self, layers: Zones) -> None:
        """Show the zones of the sailor's layers, and those marked here."""
        self._layers = layers
        self._chart.view.zones.show_zones(Zones((*layers.zones, *self.avoided.zones)))
        self._chart.view.removable = frozenset(self.avoided.zones)

    def follow(self) -> None:
        """Sail anew what form and chart ask now, when there is a passage to follow from."""
        state, form = self._state(), self._form
        known = state.answer
        if known is None or not self.enabled or state.phase is Phase.COMPUTING or not form.is_answerable:
            return
        if (form.forecast, form.weights) != (known.question.forecast, known.question.weights):
            return
        try:
            question = self.question()
        except InputError:
            # Both ends in one place, on the way of one past the other.
            return
        self.router.ask(question, known)

    def take_over(self, fill: Callable[[], None], question: Question) -> None:
        """Let form, place to sail by and areas be those of a question, without sailing anything anew."""

        def fill_all() -> None:
            fill()
            self.avoided.stack.clear()
            self.avoided.put(question.avoid)

        self.ask_again(fill_all, question.via)
        self.taken_over.emit()

    def ask_again(self, fill: Callable[[], None], via: Port | None) -> None:
        """Let form and place to sail by be those of another question; nothing is sailed anew by that."""
        enabled, self.enabled = self.enabled, False
        try:
            fill()
            self.via = via
            self._show_ends()
        finally:
            self.enabled = enabled

    def _departure_moved(self, moment: datetime) -> None:
        self._form.departure.set_moment(moment, chosen=True)

    def _end_dragged(self, which: str, port: Port, done: bool) -> None:
        if which == "via":
            self._set_via(_named(port))
        else:
            self._form.set_end(which, port)
            self.follow()
        if done:
            self.router.settle()

    def _end_picked(self, which: str, lat: float, lon: float) -> None:
        self._end_dragged(which, Port("", "", lat, lon), True)

    def _set_via(self, port: Port | None) -> None:
        self.via = port
        self._show_ends()
        self.follow()

    def _show_ends(self) -> None:
        ends = dict(self._form.ends)
        if self.via is not None:
            # A position as a name would cover half the chart.
            ends["via"] = self.via if self.via.country else replace(self.via, name=self.tr("via"))
        self._chart.view.choose_ends(ends)

    def _areas_changed(self) -> None:
        self.show_layers(self._layers)
        self.follow()


def _named(port: Port) -> Port:
    return port if port.name else replace(port, name=format_position(port.lat, port.lon))
