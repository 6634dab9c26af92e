"""The weather page: where the wind comes from, what of it is at hand, and what is done after its end."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import (
    QComboBox,
    QFileDialog,
    QFrame,
    QLabel,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from seacruise.desktop.banner import Banner, text_label
from seacruise.desktop.fields import copy_fields
from seacruise.desktop.forecast_box import FILE_TYPES
from seacruise.desktop.jobs import JobRunner
from seacruise.desktop.language import fill
from seacruise.desktop.messages import Message
from seacruise.desktop.pages.flow import FlowLayout, named
from seacruise.desktop.pages.key_box import KeyBox
from seacruise.desktop.pages.source_card import Card, title_of
from seacruise.desktop.pages.weather_model import FileInfo, Mix, WeatherState, load_state, look_into
from seacruise.desktop.style import scaled_font
from seacruise.errors import SeaCruiseError
from seacruise.weather.beyond import BEYOND

if TYPE_CHECKING:
    from seacruise.progress import Job
    from seacruise.settings import Settings

ORDER: Final = (
    "auto", "stormglass", "open-meteo", "open-meteo-ensemble", "metno", "practice", "sample",
)  # fmt: skip
_UNREACHED: Final = frozenset({"no-network", "timeout"})


class WeatherPage(QFrame):
    """The page.

    Parameters
    ----------
    load, read
        What looks sources up and reads files; tests put their own in.

    Signals: ``source_chosen(str)`` when passages shall be planned with a source or a file,
    ``mean_chosen(names, weights)`` with a mean of several (tuples; no weights where all are alike),
    ``beyond_chosen(str)`` what to do after the end of the forecast, ``key_changed()`` when a key was kept or
    removed, ``loaded()`` when what it shows is up to date, ``file_read(path)``.
    """

    source_chosen = Signal(str)
    mean_chosen = Signal(object, object)
    beyond_chosen = Signal(str)
    key_changed = Signal()
    loaded = Signal()
    file_read = Signal(str)

    def __init__(
        self,
        settings: Settings,
        parent: QWidget | None = None,
        *,
        load: Callable[[Settings, datetime], WeatherState] = load_state,
        read: Callable[[Path, Job, Sequence[tuple[float, float]]], FileInfo] = look_into,
    ) -> None:
        super().__init__(parent)
        self.setObjectName("bar")
        self.setAccessibleName(self.tr("Weather"))
        self.setAcceptDrops(True)
        self._settings, self._load, self._read = settings, load, read
        self._state: WeatherState | None = None
        self._trouble: SeaCruiseError | None = None
        self._ends: tuple[tuple[float, float], ...] = ()
        self._in_use: tuple[tuple[str, ...], tuple[float, ...]] = (("auto",), ())
        self._waiting: list[str] = []
        self._ticked: dict[str, float] = {}
        self._loader, self._reader = JobRunner("weather", self), JobRunner("file", self)
        self._loader.finished.connect(self._take_state)
        self._loader.failed.connect(lambda _, error: self._say_fault(error))
        self._reader.finished.connect(lambda _, info: self._file_done(info))
        self._reader.failed.connect(lambda _, error: self._file_done(error))
        self._body = self._scrolled()
        self.cards = {name: Card(name, self._body) for name in ORDER}
        self.files: dict[str, Card] = {}
        self.key_box = KeyBox(settings, self.cards["stormglass"])
        self._make_parts()
        self._lay_out()
        self._connect()
        self.show_choice(*self._in_use)

    # --- building -----------------------------------------------------------------------------------

    def _scrolled(self) -> QWidget:
        """Make what everything stands in, first: whatever is put elsewhere later is dressed once more."""
        self.area = area = QScrollArea(self)
        area.setObjectName("side")
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setWidgetResizable(True)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        body = QWidget(self)
        body.setObjectName("sideBody")
        area.setWidget(body)
        outer = QVBoxLayout(self)
        outer.setContentsMargins(0, 0, 0, 0)
        outer.addWidget(area)
        return body

    def _make_parts(self) -> None:
        self.chosen = text_label("", "hint", self._body)
        self.drop_zone = text_label(
            self.tr("Drop a GRIB or NetCDF file anywhere on this page to see what it covers."), "hint", self
        )
        self.choose_button = QPushButton(self.tr("Choose a file…"), self)
        self.mean_button = QPushButton(self.tr("Use the mean"), self)
        self.mean_text = text_label("", "hint", self)
        self.beyond_box = QComboBox(self)
        for mode, text in (
            ("hold", self.tr("Hold the last wind")),
            ("fade", self.tr("Fade to the usual within a day")),
            ("refuse", self.tr("Refuse to sail on")),
        ):
            self.beyond_box.addItem(text, mode)
        self.beyond_box.setAccessibleName(self.tr("After the end of the forecast"))
        self.beyond_text = text_label("", "hint", self)
        self._banner: Banner | None = None

    def _lay_out(self) -> None:
        body = self._body
        self._column = QVBoxLayout(body)
        self._column.setContentsMargins(14, 12, 14, 14)
        self._column.setSpacing(9)
        title = QLabel(self.tr("Weather"), body)
        title.setFont(scaled_font(self.font(), 1.25, bold=True))
        for widget in (title, self.chosen, *self.cards.values()):
            self._column.addWidget(widget)
        self.cards["stormglass"].add_row(self.key_box)
        self._file_card = self._boxed(self.tr("Files"), self.drop_zone, self.choose_button)
        self._column.addWidget(self._file_card)
        self._column.addWidget(self._boxed(self.tr("Mean of several"), self.mean_text, self.mean_button))
        after = named(self.tr("&After the end of the forecast"), self.beyond_box)
        self._column.addWidget(self._boxed("", self.beyond_text, after))
        self._column.addStretch()

    def _boxed(self, title: str, text: QWidget, control: QWidget) -> QFrame:
        card = QFrame(self._body)
        card.setObjectName("card")
        layout = QVBoxLayout(card)
        layout.setContentsMargins(14, 10, 14, 11)
        layout.setSpacing(6)
        if title:
            head = QLabel(title, card)
            head.setFont(scaled_font(self.font(), 1.08, bold=True))
            layout.addWidget(head)
        line = QWidget(card)
        flow = FlowLayout(line)
        flow.addWidget(control)
        for widget in (line, text) if not title else (text, line):
            layout.addWidget(widget)
        return card

    def _connect(self) -> None:
        for name, card in self.cards.items():
            card.used.connect(partial(self.choose, name))
            card.mixed.connect(self._show_mean)
        self.choose_button.clicked.connect(self._ask_for_files)
        self.mean_button.clicked.connect(self._use_mean)
        self.beyond_box.activated.connect(self._beyond_picked)
        self.key_box.changed.connect(self._key_changed)
        self.key_box.tested.connect(self._key_tested)
        self.show_beyond("hold")
        self._show_mean()

    # --- what is known ------------------------------------------------------------------------------

    def load(self) -> None:
        """Look everything up, beside the window; nothing is sent."""
        self._loader.run_job(lambda _job: self._load(self._settings, datetime.now(UTC)))

    def _take_state(self, _generation: int, state: WeatherState) -> None:
        self._state = state
        self.key_box.show_state(state.key)
        self._render()
        self.loaded.emit()

    def _render(self) -> None:
        if self._state is None:
            return
        for found in self._state.sources:
            keyless = found.name == "stormglass" and not self._state.key.place
            source = replace(found, remark=self.tr("Needs a key of your own.")) if keyless else found
            if source.name in self.cards:
                self.cards[source.name].show_source(source, offline=self.is_offline, keyless=keyless)
        if self._trouble is not None:
            title = self.tr("No connection") if self.is_offline else self.tr("A service does not answer")
            advice = self.tr(
                "What is kept is used meanwhile; files, practice weather and the sample need no network."
            )
            self._say(Message("warning", title, str(self._trouble), advice))
        elif self._state.trouble:
            self._say(Message("warning", self.tr("Forecasts are not kept"), self._state.trouble))
        else:
            self._say(None)

    def show_trouble(self, error: SeaCruiseError) -> None:
        """Take note of what a service said: without a connection the page says so."""
        if error.reason in _UNREACHED:
            self._trouble = error
            self._render()

    def show_reached(self) -> None:
        """Take note that a service has answered."""
        if self._trouble is not None:
            self._trouble = None
            self._render()

    @property
    def is_offline(self) -> bool:
        """Whether there was no network at the last attempt."""
        return self._trouble is not None and self._trouble.reason == "no-network"

    def _key_changed(self) -> None:
        self.load()
        self.key_changed.emit()

    def _key_tested(self, error: SeaCruiseError | None) -> None:
        if error is None:
            self.show_reached()
        else:
            self.show_trouble(error)
        self.load()

    def _say_fault(self, error: SeaCruiseError) -> None:
        self._say(Message("error", self.tr("That did not work"), str(error)))

    def _say(self, message: Message | None) -> None:
        if self._banner is not None:
            if self._banner.message == message:
                return
            self._banner.take_down()
            self._banner = None
        if message is not None:
            self._banner = Banner(message, self)
            self._column.insertWidget(1, self._banner)

    @property
    def banner(self) -> Message | None:
        """What the banner says."""
        return None if self._banner is None else self._banner.message

    # --- what is chosen -----------------------------------------------------------------------------

    def choose(self, name: str) -> None:
        """Use a source or a file alone."""
        self.show_choice((name,))
        self.source_chosen.emit(name)

    def show_choice(self, names: Sequence[str], weights: Sequence[float] = ()) -> None:
        """Show what passages are planned with, as the form has it; files among it are looked into."""
        self._in_use = (tuple(names), tuple(weights))
        for name in names:
            if name not in self.cards and name not in self.files and Path(name).is_file():
                self.add_file(name)
        for name, card in self._all_cards():
            self._mark(name, card)
        parts = [
            title_of(name) + (fill(" ({n:g})", n=weight) if weights else "")
            for name, weight in _weighed(names, weights).items()
        ]
        what = self.tr("the mean of {parts}") if len(names) > 1 else "{parts}"
        self.chosen.setText(
            self.tr("Passages are planned with {what}.").format(what=what.format(parts=", ".join(parts)))
        )
        self._show_mean()

    def _mark(self, name: str, card: Card) -> None:
        """Show on a card whether it is in use, alone or in the mean that is."""
        names, weights = self._in_use
        is_mean = len(names) > 1
        card.show_in_use(in_use=not is_mean and name in names)
        if is_mean:
            card.set_mixed(_weighed(names, weights).get(name))

    def _all_cards(self) -> list[tuple[str, Card]]:
        return [*self.cards.items(), *self.files.items()]

    @property
    def mix(self) -> Mix:
        """What is ticked for the mean."""
        return Mix(tuple((name, card.weight) for name, card in self._all_cards() if card.in_mean))

    def _show_mean(self) -> None:
        mix = self.mix
        self.mean_button.setEnabled(mix.is_mean)
        used = mix.is_mean and _weighed(*self._in_use) == _weighed(mix.names, mix.weights)
        self.mean_button.setText(self.tr("The mean is in use") if used else self.tr("Use the mean"))
        self.mean_button.setObjectName("primary" if used else "")
        self.mean_button.style().polish(self.mean_button)
        if mix.is_mean:
            parts = zip(mix.names, mix.shares(), strict=True)
            self.mean_text.setText(
                ", ".join(f"{title_of(name)} {100.0 * share:.0f} %" for name, share in parts)
                + self.tr(". Their spread tells how far they disagree.")
            )
        else:
            self.mean_text.setText(self.tr("Tick two or more services or files to plan with their mean."))

    def _use_mean(self) -> None:
        mix = self.mix
        self.show_choice(mix.names, mix.weights)
        self.mean_chosen.emit(mix.names, mix.weights)

    def show_beyond(self, mode: str) -> None:
        """Show what is done after the end of the forecast."""
        assert mode in BEYOND
        self.beyond_box.setCurrentIndex(self.beyond_box.findData(mode))
        self.beyond_text.setText(
            {
                "hold": self.tr("The last wind blows on; the result says for how long."),
                "fade": self.tr("Within 24 hours it goes over to the mean of the forecast."),
                "refuse": self.tr("A passage that would end after the forecast is none."),
            }[mode]
        )  # fmt: skip

    def _beyond_picked(self) -> None:
        mode = str(self.beyond_box.currentData())
        self.show_beyond(mode)
        self.beyond_chosen.emit(mode)

    def show_ends(self, *ends: tuple[float, float]) -> None:
        """Take note of the passage's ends, latitude and longitude [degrees]: files have to do for those."""
        self._ends = ends

    # --- files --------------------------------------------------------------------------------------

    def add_file(self, path: str) -> None:
        """Read a file beside the window and show what it covers."""
        if path in self._waiting:
            return
        self._drop_card(path)
        card = Card(path, self._body)
        card.setToolTip(path)
        card.show_reading()
        card.used.connect(partial(self.choose, path))
        card.mixed.connect(self._show_mean)
        card.removed.connect(partial(self.remove_file, path))
        self.files[path] = card
        self._column.insertWidget(self._column.indexOf(self._file_card) + 1, card)
        self._waiting.append(path)
        self._read_next()

    def add_files(self, paths: Sequence[str]) -> None:
        """Read several files, one after the other."""
        for path in paths:
            self.add_file(path)

    def remove_file(self, path: str) -> None:
        """Take a file off the list; the file itself stays."""
        if self._waiting[:1] == [path]:
            self._reader.cancel()
        self._waiting = [one for one in self._waiting if one != path]
        self._drop_card(path)
        self._show_mean()
        self._read_next()

    def _drop_card(self, path: str) -> None:
        if card := self.files.pop(path, None):
            if any(child.hasFocus() for child in card.findChildren(QWidget)):
                self.choose_button.setFocus()
            self._column.removeWidget(card)
            card.hide()
            card.deleteLater()

    def _read_next(self) -> None:
        if self._waiting and not self._reader.is_running:
            path = Path(self._waiting[0])
            ends = self._ends
            self._reader.run_job(lambda job: self._read(path, job, ends))

    def _file_done(self, outcome: FileInfo | SeaCruiseError) -> None:
        path = self._waiting.pop(0)
        card = self.files[path]
        if isinstance(outcome, SeaCruiseError):
            card.show_fault(str(outcome))
        else:
            card.show_file(outcome)
            self._mark(path, card)
            if path in self._ticked:
                card.set_mixed(self._ticked.pop(path))
            self._show_mean()
        self.file_read.emit(path)
        self._read_next()

    def _ask_for_files(self) -> None:
        dialog = QFileDialog(self, self.tr("Forecast files"), "", FILE_TYPES)
        dialog.setFileMode(QFileDialog.FileMode.ExistingFiles)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.filesSelected.connect(self.add_files)
        dialog.open()

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        """Take files."""
        if any(url.isLocalFile() for url in event.mimeData().urls()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        """Read what was dropped: what is in a file decides, not its name."""
        self.add_files([url.toLocalFile() for url in event.mimeData().urls() if url.isLocalFile()])
        event.acceptProposedAction()

    def take_over(self, other: WeatherPage) -> None:
        """Show what the same page of another window shows; files are read again."""
        self._trouble = other.trouble
        copy_fields(other.key_box, self.key_box)
        for name, card in self.cards.items():
            copy_fields(other.cards[name], card)
        self._ticked = {path: card.weight for path, card in other.files.items() if card.in_mean}
        self.add_files([path for path in other.files if path not in self.files])

    @property
    def trouble(self) -> SeaCruiseError | None:
        """What a service said last, while it cannot be reached."""
        return self._trouble

    def shut_down(self) -> None:
        """End the workers."""
        for runner in (self._loader, self._reader):
            runner.shut_down(patience_s=0.2)
        self.key_box.shut_down()


def _weighed(names: Sequence[str], weights: Sequence[float]) -> dict[str, float]:
    """Weight of each forecast of a mean; without weights all are alike."""
    return dict(zip(names, weights or [1.0] * len(names), strict=True))
