"""The main window: it wires form, jobs, chart and panels; what it shows follows from `WindowState`."""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QMainWindow,
    QSplitter,
    QVBoxLayout,
    QWidget,
)

from seacruise.desktop.about import AboutDialog
from seacruise.desktop.background import Background, Catalogue
from seacruise.desktop.chart_pane import ChartPane
from seacruise.desktop.compute import Answer, Fetcher, Planner, compute, fetch_wind, plan_passage
from seacruise.desktop.exporting import Exporter
from seacruise.desktop.form import PassageForm
from seacruise.desktop.jobs import GarbageKeeper, JobRunner, unexpected
from seacruise.desktop.legs import LegsTable
from seacruise.desktop.memory import WindowMemory
from seacruise.desktop.menus import Commands, Menus
from seacruise.desktop.messages import Message, WayOut, age_h, format_age, is_forecast, message_for
from seacruise.desktop.side_panel import SidePanel, scroll_area
from seacruise.desktop.state import Phase, WindowState
from seacruise.errors import NoPassageError, SeaCruiseError
from seacruise.geodesy import format_position

if TYPE_CHECKING:
    from seacruise.desktop.state import Horizon
    from seacruise.passage import Passage
    from seacruise.settings import Settings

log = logging.getLogger(__name__)

_FORM_PX: Final = 350
_SIDE_PX: Final = 344
_HORIZON_EVERY_MS: Final = 300_000
_WARM_UP_AFTER_MS: Final = 400
_WIND_FILES: Final = (".grib", ".grib1", ".grib2", ".grb", ".grb1", ".grb2", ".nc", ".nc4")


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
        self._settings, self._planner, self._fetcher, self._memory = settings, planner, fetcher, memory
        self.state = WindowState()
        self._message: Message | None = None
        self._awaited = {"catalogue", "horizon"}
        self.jobs = JobRunner("passage", self)
        self.background = Background(settings, self)
        self.exporter = Exporter(self)
        self.garbage = GarbageKeeper(lambda: self.jobs.is_running, self)
        self._build()
        self._build_menus()
        self._build_status()
        self._connect()
        self._horizon_timer = QTimer(self)
        self._horizon_timer.setInterval(_HORIZON_EVERY_MS)
        self._horizon_timer.timeout.connect(lambda: self.background.load_horizon(self.form.forecast))
        if memory is not None:
            self.form.restore(memory.recall("form"))
            self._restore_layers(memory.recall("layers"))
        self._render()

    # --- building -----------------------------------------------------------------------------------

    def _build(self) -> None:
        self.setWindowTitle("SeaCruise")
        self.setMinimumSize(980, 600)
        self.resize(1280, 800)
        self.setAcceptDrops(True)
        self.form, self.chart, self.side = PassageForm(), ChartPane(), SidePanel()
        self.legs = LegsTable()
        column = QWidget()
        column_layout = QVBoxLayout(column)
        column_layout.setContentsMargins(10, 10, 10, 10)
        column_layout.addWidget(self.form)
        column_layout.addStretch()
        upper = QWidget()
        upper_layout = QHBoxLayout(upper)
        upper_layout.setContentsMargins(0, 0, 0, 0)
        upper_layout.setSpacing(0)
        upper_layout.addWidget(self.chart, 1)
        upper_layout.addWidget(scroll_area(self.side, _SIDE_PX))
        self.legs_frame = QFrame()
        self.legs_frame.setObjectName("legs")
        legs_layout = QVBoxLayout(self.legs_frame)
        legs_layout.setContentsMargins(1, 1, 1, 1)
        legs_layout.addWidget(self.legs)
        self.splitter = QSplitter(Qt.Orientation.Vertical)
        self.splitter.addWidget(upper)
        self.splitter.addWidget(self.legs_frame)
        self.splitter.setStretchFactor(0, 1)
        self.splitter.setCollapsible(0, False)
        self.splitter.setSizes([620, 176])
        centre = QWidget()
        layout = QHBoxLayout(centre)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(scroll_area(column, _FORM_PX))
        layout.addWidget(self.splitter, 1)
        self.setCentralWidget(centre)

    def _build_menus(self) -> None:
        view = self.chart.view
        self.menus = Menus(
            self,
            Commands(
                save_gpx=partial(self._export, self.exporter.ask_gpx),
                save_csv=partial(self._export, self.exporter.ask_csv),
                save_png=self._export_png,
                quit=self.close,
                show_layers=self._show_layers,
                zoom_in=view.zoom_in,
                zoom_out=view.zoom_out,
                fit=self._fit,
                calculate=self.calculate,
                cancel=self.cancel,
                swap=self.form.swap_ends,
                about=self.show_about,
            ),
        )

    def _build_status(self) -> None:
        self.source_label, self.quota_label, self.position_label = QLabel(), QLabel(), QLabel()
        self.position_label.setMinimumWidth(self.fontMetrics().horizontalAdvance("00°00.0'N 000°00.0'E") + 20)
        self.source_label.setAccessibleName(self.tr("Source of the wind"))
        self.position_label.setAccessibleName(self.tr("Position of the pointer"))
        self.source_label.setText(self.tr("No wind loaded yet"))
        self.statusBar().addWidget(self.source_label)
        for label in (self.quota_label, self.position_label):
            self.statusBar().addPermanentWidget(label)
        self.statusBar().setSizeGripEnabled(False)

    def _connect(self) -> None:
        form, view = self.form, self.chart.view
        form.submitted.connect(self.calculate)
        form.cancelled.connect(self.cancel)
        form.ends_changed.connect(lambda: view.choose_ends(form.ends))
        form.forecast_changed.connect(self._forecast_changed)
        self.jobs.progressed.connect(self._progressed)
        self.jobs.finished.connect(self._finished)
        self.jobs.failed.connect(self._failed)
        background = self.background
        background.catalogue_loaded.connect(self._take_catalogue)
        background.horizon_loaded.connect(self._take_horizon)
        background.horizon_failed.connect(self._horizon_failed)
        background.quota_loaded.connect(self._show_quota)
        background.polar_added.connect(self._polar_added)
        background.troubled.connect(self._show_trouble)
        background.warmed_up.connect(self.garbage.settle)
        self.exporter.saved.connect(self._saved)
        self.exporter.failed.connect(self._show_trouble)
        self.side.way_out_chosen.connect(self._take_way_out)
        self.chart.time_bar.moved.connect(self._time_moved)
        self.chart.fit_button.clicked.connect(self._fit)
        self.legs.leg_chosen.connect(self._leg_chosen)
        view.leg_picked.connect(self.legs.choose_leg)
        view.pointed.connect(lambda lat, lon: self.position_label.setText(format_position(lat, lon)))
        view.left.connect(self.position_label.clear)
        view.end_picked.connect(self._end_picked)

    def load(self, *, warm_up: bool = True) -> None:
        """Load everything that the first picture does not need."""
        self.background.load_catalogue(self.form.wanted_yacht)
        self.background.load_horizon(self.form.forecast)
        self.background.load_quota()
        if warm_up:
            self.ready.connect(lambda: QTimer.singleShot(_WARM_UP_AFTER_MS, self.background.warm_up))
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
        self.chart.view.trouble.mark(None)
        try:
            question = self.form.question()
        except SeaCruiseError as error:
            self._set(self.state.refused(error))
            return
        how = partial(
            compute, question, settings=self._settings, planner=self._planner, fetcher=self._fetcher
        )
        self._set(self.state.started(self.jobs.run_job(lambda job: how(job=job))))

    def cancel(self) -> None:
        """Cancel the calculation; at once, whatever the worker still does."""
        if self.jobs.cancel():
            self._set(self.state.cancelled())
            self.settled.emit(self.state)

    def _progressed(self, generation: int, stage: str, fraction: float | None, message: str) -> None:
        self._set(self.state.progressed(generation, stage, fraction, message))

    def _finished(self, generation: int, answer: Answer) -> None:
        self._set(self.state.finished(generation, answer))
        if self.state.answer is answer:
            self._show_answer(answer)
        self.background.load_quota()
        self.settled.emit(self.state)

    def _failed(self, generation: int, error: SeaCruiseError) -> None:
        self._set(self.state.failed(generation, error))
        if isinstance(error, NoPassageError):
            self.chart.view.trouble.mark(error.place)
        self.background.load_quota()
        self.settled.emit(self.state)

    # --- showing ------------------------------------------------------------------------------------

    def _set(self, state: WindowState) -> None:
        if state is not self.state:
            self.state = state
            self._render()

    def _render(self) -> None:
        state = self.state
        self._message = None
        if state.phase is Phase.FAILED and state.error is not None:
            self._message = message_for(state.error)
        elif state.phase is Phase.CANCELLED:
            self._message = Message("info", self.tr("Cancelled"), self.tr("Nothing was changed."))
        self._show_side()
        running = state.phase is Phase.COMPUTING
        self.form.set_running(running=running)
        self.menus.cancel.setEnabled(running)
        answered = state.answer is not None
        for action in self.menus.exports:
            action.setEnabled(answered)
        self.chart.fit_button.setEnabled(answered)
        self.chart.view.route.faded = state.answer_is_earlier
        self.chart.view.viewport().update()
        self._show_layers()

    def _show_side(self) -> None:
        self.side.show_state(self.state, self._message, datetime.now(UTC))

    def _show_trouble(self, error: SeaCruiseError) -> None:
        """Show a trouble that is not of the calculation, without touching what is there."""
        self._message = message_for(error)
        self._show_side()

    def show_fault(self, error: BaseException) -> None:
        """Show, in one sentence, a mistake of the program in any slot."""
        self._show_trouble(unexpected(error))

    def _show_answer(self, answer: Answer) -> None:
        passage = answer.passage
        self.legs.show_passage(passage)
        self.chart.view.show_answer(answer)
        self.chart.time_bar.set_span(passage.departure, passage.arrival)
        self.chart.show_ribbon(passage.forecast.notice)
        self._show_lattice()
        self._show_layers()
        # The table takes room of the chart; what fits is known when that has happened.
        QTimer.singleShot(0, self._fit)
        forecast = passage.forecast
        age = ""
        if forecast.issued is not None and is_forecast(forecast):
            age = self.tr(", {age} old").format(age=format_age(age_h(forecast.issued, datetime.now(UTC))))
        self.source_label.setText(self.tr("Wind: {source}").format(source=forecast.source) + age)

    def _show_layers(self) -> None:
        checked = {name: action.isChecked() for name, action in self.menus.layers.items()}
        view = self.chart.view
        view.wind.setVisible(checked["wind"])
        view.ports.names_shown = checked["ports"]
        view.viewport().update()
        self.legs_frame.setVisible(checked["legs"] and self.state.answer is not None)
        self._show_lattice()

    def _show_lattice(self) -> None:
        answer = self.state.answer
        shown = self.menus.layers["lattice"].isChecked() and answer is not None
        self.chart.view.coast.show_lattice(answer.passage.lattice_edges if shown and answer else None)
        self.chart.view.refresh_coast()

    def _restore_layers(self, kept: dict[str, Any]) -> None:
        for name, action in self.menus.layers.items():
            if isinstance(kept.get(name), bool):
                action.setChecked(kept[name])

    def _fit(self) -> None:
        if self.state.answer is not None:
            self.chart.view.fit_passage(self.state.answer)

    def _time_moved(self, moment: datetime) -> None:
        if self.state.answer is not None:
            self.chart.view.show_time(self.state.answer, moment.timestamp())

    def _leg_chosen(self, number: int) -> None:
        answer = self.state.answer
        self.chart.view.route.choose_leg(None if number < 0 else number)
        if answer is not None and 0 <= number < len(answer.passage.waypoints):
            self.chart.time_bar.set_moment(answer.passage.waypoints[number].time)

    def _end_picked(self, which: str, lat: float, lon: float) -> None:
        field = self.form.start_field if which == "from" else self.form.end_field
        field.set_position(lat, lon)

    def show_about(self) -> None:
        """Open the dialog about the program."""
        AboutDialog(self._settings.data_dir, self).open()

    # --- what was loaded ----------------------------------------------------------------------------

    def _take_catalogue(self, catalogue: Catalogue) -> None:
        self.form.set_ports(catalogue.ports)
        self.form.set_yachts(catalogue.yachts, catalogue.yacht)
        self.chart.view.ports.show_ports(catalogue.ports)
        if catalogue.problems:
            log.warning("Polars that cannot be used: %s", " ".join(catalogue.problems))
            self._message = Message(
                "warning", self.tr("Some polars cannot be used"), "\n".join(catalogue.problems)
            )
            self._show_side()
        self._loaded("catalogue")

    def _forecast_changed(self) -> None:
        self.form.departure.set_horizon(None, datetime.now(UTC))
        self.background.load_horizon(self.form.forecast)

    def _take_horizon(self, horizon: Horizon) -> None:
        self.form.departure.set_horizon(horizon, datetime.now(UTC))
        self._loaded("horizon")

    def _horizon_failed(self, error: SeaCruiseError) -> None:
        self._show_trouble(error)
        self._loaded("horizon")

    def _loaded(self, what: str) -> None:
        if what in self._awaited:
            self._awaited.discard(what)
            if not self._awaited:
                self.ready.emit()

    def _show_quota(self, quota: tuple[int, int] | None) -> None:
        text = ""
        if quota is not None:
            text = self.tr("Storm Glass: {left} of {daily} requests left today").format(
                left=quota[0], daily=quota[1]
            )
        self.quota_label.setText(text)

    def _polar_added(self, name: str) -> None:
        self.background.load_catalogue(name)
        self.statusBar().showMessage(self.tr("{yacht} is in your fleet now.").format(yacht=name), 6000)

    # --- ways out and files -------------------------------------------------------------------------

    def _take_way_out(self, way_out: WayOut) -> None:
        match way_out:
            case WayOut.PRACTICE:
                self.form.set_forecast(("practice",))
            case WayOut.DEPARTURE:
                self.form.departure.use_first_hour(datetime.now(UTC))
            case WayOut.ENGINE:
                self.form.use_engine()
            case WayOut.SHOW_PLACE if isinstance(self.state.error, NoPassageError) and self.state.error.place:
                self.chart.view.show_place(*self.state.error.place)
            case WayOut.RETRY:
                self.calculate()

    def _export(self, ask: Callable[[Passage], None]) -> None:
        if self.state.answer is not None:
            ask(self.state.answer.passage)

    def _export_png(self) -> None:
        if self.state.answer is not None:
            self.exporter.ask_png(self.state.answer.passage, self.state.answer.wind)

    def _saved(self, path: Path) -> None:
        self.statusBar().showMessage(self.tr("Saved {path}").format(path=path), 8000)

    # --- Qt's events --------------------------------------------------------------------------------

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        """Take files."""
        if event.mimeData().hasUrls():
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        """Use a forecast, let a polar join the fleet."""
        paths = [Path(url.toLocalFile()) for url in event.mimeData().urls() if url.isLocalFile()]
        winds = [path for path in paths if path.suffix.lower() in _WIND_FILES]
        if winds:
            self.form.set_forecast(tuple(str(path) for path in winds))
        for path in paths:
            if path not in winds:
                self.background.add_polar(path)
        event.acceptProposedAction()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Remember, cancel, and leave; a calculation that runs is dropped cleanly."""
        if self._memory is not None:
            self._memory.keep("form", self.form.contents())
            self._memory.keep("layers", {n: a.isChecked() for n, a in self.menus.layers.items()})
            self._memory.keep_geometry(self, self.splitter)
            self._memory.flush()
        self.hide()
        self._horizon_timer.stop()
        self.garbage.stop()
        self.jobs.shut_down()
        self.chart.view.painter_jobs.shut_down()
        self.background.shut_down()
        self.exporter.shut_down()
        event.accept()
