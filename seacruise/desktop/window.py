"""The main window: it wires form, jobs, chart and panels; what it shows follows from `WindowState`."""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QTimer, Signal
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QMainWindow

from seacruise.desktop.background import Background, Catalogue
from seacruise.desktop.chart_pane import ChartPane
from seacruise.desktop.compute import Answer, Fetcher, Planner, compute, fetch_wind, plan_passage
from seacruise.desktop.dropped import use_files
from seacruise.desktop.exporting import Exporter
from seacruise.desktop.form import PassageForm
from seacruise.desktop.habits import Habits
from seacruise.desktop.jobs import GarbageKeeper, JobRunner, unexpected
from seacruise.desktop.layers import Layers
from seacruise.desktop.layout import lay_out, pane_splitter
from seacruise.desktop.loading import Loading
from seacruise.desktop.memory import WindowMemory
from seacruise.desktop.menus import Commands, Menus
from seacruise.desktop.messages import Message, message_for, message_for_polars, message_of
from seacruise.desktop.pages.desk import Desk
from seacruise.desktop.pages.planning import Planning
from seacruise.desktop.passage_pane import PassagePane
from seacruise.desktop.side_panel import SidePanel
from seacruise.desktop.state import Phase, WindowState
from seacruise.desktop.status import StatusLine
from seacruise.desktop.steering import Steering
from seacruise.desktop.style import show_light
from seacruise.desktop.undo import History
from seacruise.desktop.wardrobe import Wardrobe
from seacruise.desktop.ways_out import WaysOut
from seacruise.errors import NoPassageError, SeaCruiseError

if TYPE_CHECKING:
    from seacruise.desktop.state import Horizon
    from seacruise.settings import Settings

log = logging.getLogger(__name__)

_HORIZON_EVERY_MS: Final = 300_000
_WARM_UP_AFTER_MS: Final = 400


class MainWindow(QMainWindow):
    """The window.

    Parameters
    ----------
    settings
        Folders, services, key.
    planner, fetcher
        What computes; tests put their own in.

    Signals: ``settled(state)`` when a calculation has ended in any way, ``ready()`` when ports, yachts
    and the forecast's range are loaded.
    """

    settled = Signal(object)
    ready = Signal()

    def __init__(
        self,
        settings: Settings,
        *,
        planner: Planner = plan_passage,
        fetcher: Fetcher = fetch_wind,
        memory: WindowMemory | None = None,
    ) -> None:
        super().__init__()
        self._settings, self._planner, self._fetcher = settings, planner, fetcher
        self.state = WindowState()
        self.saying: Callable[[], Message | None] = lambda: None
        self._trouble: Callable[[], Message] | None = None
        self.wardrobe: Wardrobe | None = None
        self.loading = Loading("catalogue", "horizon", parent=self)
        self.jobs = JobRunner("passage", self)
        self.background = Background(settings, self)
        self.exporter = Exporter(self)
        self._build()
        self.steering = Steering(
            settings, planner, form=self.form, chart=self.chart, state=lambda: self.state, parent=self
        )
        self.desk = Desk(settings, self)
        self._build_menus()
        self.layers: Layers = Layers(settings, self.menus, self.chart.view, self, planner=planner)
        self.status = StatusLine(self.statusBar(), self.chart.view.coast.band_at)
        self.garbage = GarbageKeeper(self._is_busy, self)
        self.planning = Planning(self, settings)
        self._connect()
        self._horizon_timer = QTimer(self)
        self._horizon_timer.setInterval(_HORIZON_EVERY_MS)
        self._horizon_timer.timeout.connect(lambda: self.background.load_horizon(self.form.forecast))
        self.habits: Habits = Habits(self, memory)
        self._render()

    # --- building -----------------------------------------------------------------------------------

    def _build(self) -> None:
        self.setWindowTitle("SeaCruise")
        self.setMinimumSize(560, 360)
        self.resize(1280, 800)
        self.setAcceptDrops(True)
        self.form, self.chart, self.side = PassageForm(), ChartPane(), SidePanel()
        self.pane = PassagePane()
        self.legs = self.pane.legs
        self.splitter = pane_splitter(self.chart, self.side, self.pane)
        self.setCentralWidget(lay_out(self.form, self.splitter))

    def _build_menus(self) -> None:
        view = self.chart.view
        self.menus = Menus(
            self,
            Commands(
                save=self.desk.save,
                saved=self.desk.show_passages,
                weather=self.desk.show_weather,
                yachts=self.desk.show_yachts,
                export=self._export,
                quit=self.close,
                show_layers=self._show_layers,
                zoom_in=view.zoom_in,
                zoom_out=view.zoom_out,
                fit=self._fit,
                calculate=self.calculate,
                cancel=self.cancel,
                swap=self.form.swap_ends,
                options=self.form.options_bar.open_dialog,
                steer=self._steer,
                about=self.show_about,
            ),
            self.steering.avoided.stack,
        )
        self.pane.join(self.chart, self.menus.go_to)
        self.history = History(self.form, self.chart, self.steering, self)

    def _connect(self) -> None:
        form, view = self.form, self.chart.view
        self.loading.ready.connect(self.history.begin)
        self.loading.ready.connect(self.ready)
        form.submitted.connect(self.calculate)
        form.cancelled.connect(self.cancel)
        form.forecast_changed.connect(self._forecast_changed)
        self.settled.connect(self.desk.note)
        self.jobs.progressed.connect(self._progressed)
        self.jobs.finished.connect(self._finished)
        self.jobs.failed.connect(self._failed)
        self.steering.router.routed.connect(self._rerouted)
        self.steering.router.failed.connect(self._not_rerouted)
        self.steering.router.rested.connect(self.pane.show_answer)
        self.layers.failed.connect(self._show_trouble)
        self.layers.members_told.connect(self.side.result.show_members)
        self.layers.noted.connect(partial(self.status.say, seconds=12.0))
        self.layers.light_changed.connect(self._light_changed)
        background = self.background
        background.catalogue_loaded.connect(self._take_catalogue)
        background.horizon_loaded.connect(self._take_horizon)
        background.horizon_failed.connect(partial(self._not_loaded, "horizon"))
        background.catalogue_failed.connect(partial(self._not_loaded, "catalogue"))
        background.layers_loaded.connect(self.steering.show_layers)
        background.quota_loaded.connect(self.status.show_quota)
        background.polar_added.connect(self._polar_added)
        background.troubled.connect(self._show_trouble)
        background.warmed_up.connect(self.garbage.settle)
        self.planning.frame.turned.connect(self._show_layers)
        ways_out = WaysOut(self)
        self.planning.way_out_chosen.connect(ways_out.take)
        self.exporter.saved.connect(self._saved)
        self.exporter.failed.connect(self._show_trouble)
        self.side.way_out_chosen.connect(ways_out.take)
        self.chart.time_bar.moved.connect(self._time_moved)
        self.chart.fit_button.clicked.connect(self._fit)
        self.pane.wanted.connect(self.planning.frame.close_pages)
        self.pane.wanted.connect(partial(self.menus.layers["legs"].setChecked, True))
        view.pointed.connect(self.status.point)
        view.left.connect(self.status.clear_position)
        view.measuring_changed.connect(self.menus.layers["measure"].setChecked)
        self.chart.measure_button.clicked.connect(self.menus.layers["measure"].toggle)

    def load(self, *, warm_up: bool = True, known: Mapping[str, Any] | None = None) -> None:
        """Load everything that the first picture does not need, unless another window knows it."""
        self.background.load(self.form.wanted_yacht, self.form.forecast, known or {})
        if warm_up:
            self.ready.connect(lambda: QTimer.singleShot(_WARM_UP_AFTER_MS, self.background.warm_up))
            self.ready.connect(self.planning.prepare)
        self._horizon_timer.start()
        self.garbage.start()

    def fill(self, values: Mapping[str, Any]) -> None:
        """Fill the form in by the names of the command line's options."""
        self.form.fill(values)

    # --- calculating --------------------------------------------------------------------------------

    def calculate(self) -> None:
        """Compute what the form asks; a second press while it runs is the same press."""
        if self.state.phase is Phase.COMPUTING:
            return
        if not self.loading.is_done:
            self.loading.then(self.calculate)
            self._trouble = None
            self._render()
            return
        self.steering.router.cancel()
        self.chart.view.trouble.mark(None)
        try:
            question = self.steering.question()
        except SeaCruiseError as error:
            self._set(self.state.refused(error))
            self.habits.columns.show_column("answer")
            return
        self.habits.note_question()
        how = partial(
            compute, question, settings=self._settings, planner=self._planner, fetcher=self._fetcher
        )
        self._set(self.state.started(self.jobs.run_job(lambda job: how(job=job))))

    def cancel(self) -> None:
        """Cancel the calculation; at once, whatever the worker still does."""
        if self.loading.forget():
            self._render()
        elif self.jobs.cancel():
            self._set(self.state.cancelled())
            self.settled.emit(self.state)

    def _progressed(self, generation: int, stage: str, fraction: float | None, message: str) -> None:
        self._set(self.state.progressed(generation, stage, fraction, message))

    def _finished(self, generation: int, answer: Answer) -> None:
        self._set(self.state.finished(generation, answer))
        if self.state.answer is answer:
            self._show_answer(answer)
            took = answer.passage.search.seconds
            self.steering.router.note(sum(took.values()) - took.get("sea", 0.0))
        self.background.load_quota()
        self.settled.emit(self.state)

    def _failed(self, generation: int, error: SeaCruiseError) -> None:
        self._set(self.state.failed(generation, error))
        if isinstance(error, NoPassageError):
            self.chart.view.trouble.mark(error.place)
        self.background.load_quota()
        self.settled.emit(self.state)

    def _steer(self) -> None:
        self.steering.enabled = self.menus.live.isChecked()
        if not self.steering.enabled:
            self.steering.router.cancel()

    def _rerouted(self, answer: Answer) -> None:
        """Show a passage that followed a hand."""
        self._set(self.state.rerouted(answer))
        if self.state.answer is answer:
            self.chart.view.trouble.mark(None)
            self._show_answer(answer, follows=True)

    def _not_rerouted(self, error: SeaCruiseError) -> None:
        if self.state.phase is not Phase.COMPUTING:
            self._set(self.state.refused(error))
            self.chart.view.trouble.mark(error.place if isinstance(error, NoPassageError) else None)

    def _is_busy(self) -> bool:
        return self.jobs.is_running or self.steering.router.is_busy or self.planning.is_busy

    # --- showing ------------------------------------------------------------------------------------

    def _set(self, state: WindowState) -> None:
        if state is not self.state:
            if state.phase is not self.state.phase:
                self._trouble = None
            self.state = state
            self._render()

    def _render(self) -> None:
        state = self.state
        self.say(self._trouble or partial(message_of, state, holds=self.loading.holds))
        running = state.phase is Phase.COMPUTING or self.loading.holds
        self.form.set_running(running=running)
        self.menus.cancel.setEnabled(running)
        answered = state.answer is not None
        for action in self.menus.exports:
            action.setEnabled(answered)
        self.chart.fit_button.setEnabled(answered)
        self.chart.view.route.faded = state.answer_is_earlier
        self.chart.view.viewport().update()

    def say(self, message: Callable[[], Message | None]) -> None:
        """Show a message above the answer; what makes it is kept, for another language."""
        self.saying = message
        self.side.show_state(self.state, message(), datetime.now(UTC))

    def _show_trouble(self, error: SeaCruiseError) -> None:
        """Show a trouble that is not of the calculation, without touching what is there."""
        self._trouble = partial(message_for, error)
        self.say(self._trouble)

    def show_fault(self, error: BaseException) -> None:
        """Show, in one sentence, a mistake of the program in any slot."""
        self._show_trouble(unexpected(error))

    def _show_answer(self, answer: Answer, *, follows: bool = False) -> None:
        """Show a passage; one that follows a hand leaves view and slider where they are."""
        passage, view, bar = answer.passage, self.chart.view, self.chart.time_bar
        if not follows:
            self.pane.show_answer(answer)
        self.status.show_answer(answer)
        self.form.sailing.learn_current(answer.wind.current is not None)
        view.show_answer(answer)
        bar.strip.show_track(passage.track)
        if follows:
            bar.shift_span(passage.departure, passage.arrival)
        else:
            bar.set_span(passage.departure, passage.arrival)
            # The table takes room of the chart; what fits is known when that has happened.
            QTimer.singleShot(0, self._fit)
        self.chart.show_ribbon(passage.forecast.notice)
        self.steering.show_layers(answer.layers)
        self.layers.show_answer(answer)

    def show_saved(self, answer: Answer, message: Message) -> None:
        """Show a passage that was saved, as it was."""
        self.cancel()
        self.steering.router.cancel()
        self._set(self.state.rerouted(answer))
        self._show_answer(answer)
        self.say(lambda: message)

    def _show_layers(self) -> None:
        self.pane.setVisible(self.layers.is_on("legs") and not self.planning.frame.is_open)
        self.layers.apply()
        self.chart.measure_button.setChecked(self.layers.is_on("measure"))

    def _light_changed(self, light: str) -> None:
        self.pane.show_light(light)
        self.chart.time_bar.strip.show_light(light)
        show_light(self, light)
        self.wardrobe = self.wardrobe or Wardrobe(self)
        self.wardrobe.change(light)

    def _fit(self) -> None:
        if self.state.answer is not None:
            self.chart.view.fit_passage(self.state.answer)

    def _time_moved(self, moment: datetime) -> None:
        self.status.show_time(moment)
        if self.state.answer is not None:
            self.chart.view.show_time(self.state.answer, moment.timestamp())

    def show_about(self) -> None:
        """Open the dialog about the program."""
        from seacruise.desktop.about import AboutDialog

        AboutDialog(self._settings.data_dir, self).open()

    # --- what was loaded ----------------------------------------------------------------------------

    def _take_catalogue(self, catalogue: Catalogue) -> None:
        self.form.set_ports(catalogue.ports)
        self.form.set_yachts(catalogue.yachts, catalogue.yacht)
        self.chart.view.ports.show_ports(catalogue.ports)
        if catalogue.problems:
            log.warning("Polars that cannot be used: %s", " ".join(catalogue.problems))
            self.say(partial(message_for_polars, catalogue.problems))
        self.loading.end("catalogue")

    def _forecast_changed(self) -> None:
        self.form.departure.set_horizon(None, datetime.now(UTC))
        self.chart.time_bar.set_horizon(None)
        self.loading.begin("horizon")
        self.background.load_horizon(self.form.forecast)

    def _take_horizon(self, horizon: Horizon) -> None:
        self.form.departure.set_horizon(horizon, datetime.now(UTC))
        self.chart.time_bar.set_horizon(horizon)
        self.chart.time_bar.set_departure(self.form.departure.moment)
        self.loading.end("horizon")

    def _not_loaded(self, what: str, error: SeaCruiseError) -> None:
        """Show why something is not there; without ports there is no use in waiting on."""
        if what == "catalogue" and self.loading.forget():
            self._render()
        self.loading.end(what)
        self._show_trouble(error)

    def _polar_added(self, name: str) -> None:
        self.background.load_catalogue(name)
        self.status.say(self.tr("{yacht} is in your fleet now.").format(yacht=name), 6.0)

    # --- ways out and files -------------------------------------------------------------------------

    def _export(self, form: str) -> None:
        if self.state.answer is not None:
            beside = self.layers.beside()
            self.exporter.ask(form, self.state.answer.passage, self.state.answer.wind, beside)

    def _saved(self, path: Path) -> None:
        self.status.say(self.tr("Saved {path}").format(path=path), 8.0)

    # --- Qt's events --------------------------------------------------------------------------------

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        """Take files."""
        if event.mimeData().hasUrls():
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        """Use a forecast, let a polar join the fleet."""
        use_files(event.mimeData(), self.form.set_forecast, self.background.add_polar)
        event.acceptProposedAction()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Remember, cancel, and leave; a calculation that runs is dropped cleanly."""
        self.habits.keep()
        self.retire()
        event.accept()

    def heir(self) -> MainWindow:
        """Make the window that takes this one's place, in the language that is spoken now."""
        memory = self.habits.memory
        return MainWindow(self._settings, planner=self._planner, fetcher=self._fetcher, memory=memory)

    def take_over(self, other: MainWindow) -> None:
        """Show what another window shows, and await what it awaits."""
        other.jobs.hand_over(self.jobs)
        self.state = other.state
        if self.state.answer is not None:
            self._show_answer(self.state.answer)
        if other.loading.holds:
            self.loading.then(self.calculate)
        self._render()
        self.say(other.saying)

    def retire(self) -> None:
        """End everything that runs; a window that is closed, or has an heir."""
        self.hide()
        self._horizon_timer.stop()
        self.garbage.stop()
        workers: tuple[Any, ...] = (self.jobs, self.steering.router, self.planning, self.layers)
        for part in (*workers, self.chart.view.painter_jobs, self.background, self.desk, self.exporter):
            part.shut_down()
