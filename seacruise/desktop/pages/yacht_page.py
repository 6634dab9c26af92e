"""Which yacht: the fleet, her polar diagram, her targets, and where her polar comes from."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QDragEnterEvent, QDropEvent, QResizeEvent
from PySide6.QtWidgets import (
    QBoxLayout,
    QFileDialog,
    QFrame,
    QProgressBar,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from seacruise.desktop.banner import Banner, text_label
from seacruise.desktop.fields import copy_fields
from seacruise.desktop.jobs import JobRunner
from seacruise.desktop.messages import Message, message_for
from seacruise.desktop.pages.fit_panel import FitPanel
from seacruise.desktop.pages.fleet_list import FleetList
from seacruise.desktop.pages.flow import FlowLayout
from seacruise.desktop.pages.yacht_model import (
    FromLog,
    Shown,
    Yacht,
    can_fit,
    fit_from_logs,
    import_polar,
    keep_fit,
    look_at,
    yachts_of,
)
from seacruise.desktop.pages.yacht_view import YachtView
from seacruise.errors import InputError, SeaCruiseError

if TYPE_CHECKING:
    from seacruise.progress import Job
    from seacruise.settings import Settings
    from seacruise.yacht.polar import Polar

_SIDE_BY_SIDE_PX: Final = 760
_LIST_WIDTH: Final = 230
_LIST_HEIGHT: Final = 170


@dataclass(frozen=True, slots=True, eq=False)
class _Imported:
    """What came of files that were dropped: the last polar, and the refusals."""

    polar: Polar | None
    refusals: tuple[str, ...]


class YachtPage(QFrame):
    """The page.

    Signals: ``yacht_chosen(Polar)`` when the sailor takes a yacht for the passage, ``fleet_changed()`` when a
    polar has joined the sailor's own, ``percent_changed(float)``.
    """

    yacht_chosen = Signal(object)
    fleet_changed = Signal()
    percent_changed = Signal(float)

    def __init__(self, settings: Settings, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("bar")
        self.setAccessibleName(self.tr("Yachts"))
        self.setAcceptDrops(True)
        self._settings = settings
        self._fleet: Mapping[str, Polar] = {}
        self._wanted = ""
        self._fit_shown: FromLog | None = None
        self._banner: Banner | None = None
        self._make_parts()
        self._lay_out()
        self._make_jobs()
        self._show_state()

    # --- building -----------------------------------------------------------------------------------

    def _make_parts(self) -> None:
        self.fleet = FleetList(self)
        self.fleet.looked_at.connect(self._look_at)
        self.fleet.taken.connect(self._take)
        self.take_button = QPushButton(self.tr("&Sail with her"), self)
        self.take_button.setObjectName("primary")
        self.take_button.setToolTip(self.tr("Take her for the passage"))
        self.take_button.clicked.connect(lambda: self._take(self.fleet.current))
        self.add_button = QPushButton(self.tr("&Add a polar…"), self)
        self.add_button.setToolTip(self.tr("Or drop the file here: it is checked and copied to your own"))
        self.add_button.clicked.connect(self._ask_polar)
        self.fit_button = QPushButton(self.tr("&Fit from a log…"), self)
        self.fit_button.setToolTip(
            self.tr("NMEA 0183, Signal K, or a table; this polar is what it starts from")
        )
        self.fit_button.clicked.connect(self._ask_logs)
        self.fit_button.setVisible(can_fit())
        self.fit_panel = FitPanel(self)
        self.view = YachtView(self)
        self.view.setVisible(False)
        self.view.other_chosen.connect(self._look_again)
        self.view.percent_changed.connect(self.percent_changed)
        self.busy = QProgressBar(self)
        self.busy.setTextVisible(False)
        self.busy.setRange(0, 0)
        self.busy.setAccessibleName(self.tr("Reading the yachts"))
        self.invitation = text_label("", "hint", self)

    def _lay_out(self) -> None:
        buttons = QWidget(self)
        flow = FlowLayout(buttons)
        for button in (self.take_button, self.add_button, self.fit_button):
            flow.addWidget(button)
        self._left = QWidget(self)
        left = QVBoxLayout(self._left)
        left.setContentsMargins(0, 0, 0, 0)
        left.setSpacing(7)
        left.addWidget(self.fleet, 1)
        left.addWidget(buttons)
        # The fleet does not scroll with the diagram: its button would be out of sight.
        body = QWidget(self)
        body.setObjectName("sideBody")
        inside = QVBoxLayout(body)
        inside.setContentsMargins(0, 4, 8, 10)
        inside.addWidget(self.view)
        area = QScrollArea(self)
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setWidgetResizable(True)
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        area.setWidget(body)
        area.setAccessibleName(self.tr("Yacht and polar"))
        both = QWidget(self)
        both.setObjectName("sideBody")
        self._halves = QBoxLayout(QBoxLayout.Direction.LeftToRight, both)
        self._halves.setContentsMargins(12, 8, 4, 10)
        self._halves.setSpacing(14)
        self._halves.addWidget(self._left)
        self._halves.addWidget(area, 1)
        self._banners = QVBoxLayout()
        self._banners.setContentsMargins(12, 0, 12, 0)
        for widget in (self.busy, self.invitation, self.fit_panel):
            self._banners.addWidget(widget)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 8, 0, 0)
        layout.setSpacing(6)
        layout.addLayout(self._banners)
        layout.addWidget(both, 1)
        self._direct()

    def _make_jobs(self) -> None:
        self.runners = {name: JobRunner(f"yachts-{name}", self) for name in ("fleet", "look", "file", "fit")}
        runners = self.runners
        runners["fleet"].finished.connect(lambda _, found: self._fleet_read(*found))
        runners["look"].finished.connect(lambda _, shown: self._show(*shown))
        runners["file"].finished.connect(lambda _, done: self._file_done(done))
        runners["fit"].finished.connect(lambda _, found: self._fitted(found))
        runners["fit"].progressed.connect(
            lambda _g, _stage, fraction, message: self.fit_panel.show_progress(fraction, message)
        )
        for runner in runners.values():
            runner.failed.connect(lambda _, error: self._failed(error))
        runners["fit"].failed.connect(lambda *_: self.fit_panel.clear())
        self.fit_panel.cancelled.connect(self._cancel_fit)
        self.fit_panel.kept.connect(self._keep)
        self.fit_panel.shown.connect(self._show_fit)
        self.fit_panel.dropped.connect(self._drop_fit)

    # --- the fleet ----------------------------------------------------------------------------------

    def load(self, wanted: str = "") -> None:
        """Read the fleet and show a yacht: the one that is wanted, else the one that was shown."""
        self._wanted = wanted or self._wanted or self.fleet.current
        self.runners["fleet"].run_job(lambda _job: yachts_of(self._settings))
        self._show_state()

    def show_fleet(self, yachts: Mapping[str, Polar], wanted: str = "") -> None:
        """Show a fleet that was read elsewhere."""
        self._wanted = wanted or self._wanted or self.fleet.current
        self._fleet_read(yachts, ())

    def choose(self, name: str) -> None:
        """Look at a yacht; one that is not there yet is looked at when the fleet is read."""
        if not self.fleet.choose(name):
            self._wanted = name

    @property
    def polar(self) -> Polar | None:
        """The yacht of the fleet that is looked at."""
        return self._fleet.get(self.fleet.current)

    def _fleet_read(self, yachts: Mapping[str, Polar], problems: Sequence[str]) -> None:
        self._fleet = yachts
        self.view.offer(list(yachts))
        self.fleet.show_names(list(yachts))
        if problems:
            more = self.tr(" ({n} more)").format(n=len(problems) - 1) if len(problems) > 1 else ""
            self._say(Message("warning", self.tr("A polar file cannot be used"), problems[0] + more))
        wanted = self._wanted if self._wanted in yachts else self.fleet.current
        self._wanted = ""
        if not self.fleet.choose(wanted) and yachts:
            self.fleet.choose(next(iter(yachts)))
        self._show_state()

    def _take(self, name: str) -> None:
        if polar := self._fleet.get(name):
            self.yacht_chosen.emit(polar)

    # --- what is shown ------------------------------------------------------------------------------

    def _look_at(self, name: str) -> None:
        if polar := self._fleet.get(name):
            self._fit_shown = None
            self._prepare(polar, self._other())

    def _look_again(self) -> None:
        if self._fit_shown is not None:
            self._prepare(self._fit_shown.yacht, self._other())
        else:
            self._look_at(self.fleet.current)

    def _other(self) -> Polar | None:
        return self._fleet.get(self.view.other)

    def _prepare(self, yacht: Yacht, other: Yacht | None) -> None:
        def work(job: Job) -> tuple[Shown, Shown | None]:
            mine = look_at(yacht, job)
            if other is None:
                return mine, None
            return mine, look_at(other, job, tws_kn=[row.tws_kn for row in mine.rows])

        self.runners["look"].run_job(work)

    def _show(self, mine: Shown, other: Shown | None) -> None:
        points = self._fit_shown.points if self._fit_shown is not None else None
        self.view.show_yachts(mine, other, points)
        self.view.setVisible(True)
        self._show_state()

    @property
    def percent(self) -> float:
        """Per cent of the polar that is shown."""
        return self.view.percent_box.value()

    def set_percent(self, percent: float) -> None:
        """Show so many per cent of the polar."""
        self.view.percent_box.setValue(percent)

    def show_light(self, light: str) -> None:
        """Draw in the colours of a light: ``day``, ``dusk`` or ``night``."""
        self.view.show_light(light)

    def _show_state(self) -> None:
        reading = self.runners["fleet"].is_running and not self._fleet
        self.busy.setVisible(reading)
        self._left.setEnabled(bool(self._fleet) or not reading)
        self.take_button.setEnabled(bool(self.fleet.current))
        self.fit_panel.show_button.setEnabled(self._fit_shown is None)
        self.invitation.setVisible(not self._fleet)
        self.invitation.setText(
            self.tr("Reading the yachts…")
            if reading
            else self.tr("There are no yachts yet. Drop a polar file here, or add one.")
        )

    # --- files --------------------------------------------------------------------------------------

    def _ask_polar(self) -> None:
        self._ask(self.tr("Add a polar"), self.add_polars)

    def _ask_logs(self) -> None:
        self._ask(self.tr("Fit a polar to logs of this yacht"), self.fit)

    def _ask(self, title: str, then: Any) -> None:
        dialog = QFileDialog(self, title)
        dialog.setFileMode(QFileDialog.FileMode.ExistingFiles)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.filesSelected.connect(lambda chosen: then([Path(name) for name in chosen]))
        dialog.open()

    def add_polars(self, paths: Sequence[Path]) -> None:
        """Check polar files and copy them to the sailor's own; refusals are told."""

        def work(job: Job) -> _Imported:
            polar, refusals = None, []
            for path in paths:
                job.check()
                try:
                    polar = import_polar(path, self._settings)
                except InputError as error:
                    refusals.append(str(error))
            return _Imported(polar, tuple(refusals))

        if paths:
            self.runners["file"].run_job(work)

    def _file_done(self, done: _Imported | Polar) -> None:
        polar, refusals = (done.polar, done.refusals) if isinstance(done, _Imported) else (done, ())
        if not isinstance(done, _Imported):
            self._drop_fit()
        if refusals:
            self._say(Message("error", self.tr("This polar was not taken"), "\n".join(refusals)))
        elif polar is not None:
            self._say(Message("info", "", self.tr("{yacht} is in your fleet now.").format(yacht=polar.name)))
        if polar is not None:
            self.load(polar.name)
            self.fleet_changed.emit()

    # --- from a log ---------------------------------------------------------------------------------

    def fit(self, paths: Sequence[Path]) -> None:
        """Fit a polar to logs; the yacht that is looked at is what it starts from."""
        if paths:
            prior = self.polar
            self._say(None)
            self.fit_panel.begin()
            self.runners["fit"].run_job(lambda job: fit_from_logs(paths, prior, job))

    def _fitted(self, found: FromLog) -> None:
        self.fit_panel.end(found)
        self.view.set_other(self.fleet.current)
        self._show_fit(found)

    def _show_fit(self, found: FromLog) -> None:
        self._fit_shown = found
        self._look_again()

    def _cancel_fit(self) -> None:
        if self.runners["fit"].cancel():
            self.fit_panel.clear()
            self._say(Message("info", self.tr("Cancelled"), self.tr("Nothing was changed.")))

    def _keep(self, found: FromLog) -> None:
        self.runners["file"].run_job(lambda _job: keep_fit(found, self._settings))

    def _drop_fit(self) -> None:
        self.fit_panel.clear()
        if self._fit_shown is not None:
            self._fit_shown = None
            self.view.set_other("")
            self._look_again()

    # --- messages -----------------------------------------------------------------------------------

    def _failed(self, error: SeaCruiseError) -> None:
        self._say(message_for(error))
        self._show_state()

    @property
    def message(self) -> Message | None:
        """What the banner says."""
        return None if self._banner is None else self._banner.message

    def _say(self, message: Message | None) -> None:
        if self._banner is not None:
            self._banner.take_down()
            self._banner = None
        if message is not None:
            self._banner = Banner(message, self)
            self._banners.addWidget(self._banner)

    # --- Qt's events --------------------------------------------------------------------------------

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Put the fleet beside the diagram where there is room, else above it."""
        super().resizeEvent(event)
        self._direct()

    def _direct(self) -> None:
        wide = self.width() >= _SIDE_BY_SIDE_PX
        side = QBoxLayout.Direction.LeftToRight if wide else QBoxLayout.Direction.TopToBottom
        self._halves.setDirection(side)
        self._left.setMaximumWidth(_LIST_WIDTH if wide else 16_777_215)
        self.fleet.setMaximumHeight(16_777_215 if wide else _LIST_HEIGHT)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        """Take files."""
        if event.mimeData().hasUrls():
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        """Let polars join the fleet."""
        self.add_polars([Path(url.toLocalFile()) for url in event.mimeData().urls() if url.isLocalFile()])
        event.acceptProposedAction()

    def take_over(self, other: YachtPage) -> None:
        """Go on where the same page of another window is."""
        if other.yachts:
            self.show_fleet(other.yachts, other.fleet.current)
        self.view.set_other(other.view.other)
        copy_fields(other.view, self.view)
        self._look_again()
        if other.is_fitting:
            self.fit_panel.begin()
        elif other.fit_panel.found is not None:
            self._fitted(other.fit_panel.found)
        for name, runner in other.runners.items():
            runner.hand_over(self.runners[name])

    @property
    def yachts(self) -> Mapping[str, Polar]:
        """The fleet."""
        return self._fleet

    @property
    def is_fitting(self) -> bool:
        """Whether a polar is being fitted to logs."""
        return self.runners["fit"].is_running

    def shut_down(self) -> None:
        """End the workers."""
        for runner in self.runners.values():
            runner.shut_down(patience_s=0.2)
