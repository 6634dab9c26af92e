"""The weather, the yachts and the saved passages, each in a window of its own beside the chart."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QDialog, QVBoxLayout, QWidget

from seacruise.desktop.messages import Message
from seacruise.desktop.state import Phase, WindowState

if TYPE_CHECKING:
    from seacruise.desktop.pages.passages_page import PassagesPage
    from seacruise.desktop.pages.rows import RowsTable
    from seacruise.desktop.pages.weather_page import WeatherPage
    from seacruise.desktop.pages.yacht_page import YachtPage
    from seacruise.desktop.window import MainWindow
    from seacruise.passages import Entry, Opened
    from seacruise.settings import Settings


class Desk(QObject):
    """Makes the pages when they are first wanted, and joins them to the main window.

    Signals: ``made(QDialog, name, tables)`` when a window was made.
    """

    made = Signal(object, str, object)

    def __init__(self, settings: Settings, window: MainWindow) -> None:
        super().__init__(window)
        self._settings, self._window = settings, window
        self._weather: WeatherPage | None = None
        self._passages: PassagesPage | None = None
        self._yachts: YachtPage | None = None
        window.form.forecast_changed.connect(self._show_choice)
        window.form.ends_changed.connect(self._show_ends)

    # --- the weather --------------------------------------------------------------------------------

    @property
    def weather(self) -> WeatherPage:
        """The weather page."""
        if self._weather is None:
            from seacruise.desktop.pages.weather_page import WeatherPage

            page = self._weather = WeatherPage(self._settings, QDialog(self._window))
            self._in_window(page, self.tr("Weather"), "weather", (620, 760))
            form = self._window.form
            page.source_chosen.connect(lambda name: form.set_forecast((name,)))
            page.mean_chosen.connect(form.set_forecast)
            page.beyond_chosen.connect(self._beyond_chosen)
            page.key_changed.connect(self._key_changed)
            self._show_choice()
            self._show_ends()
        return self._weather

    def show_weather(self) -> None:
        """Open the weather page, up to date."""
        self.weather.show_beyond(self._window.form.options().beyond)
        self.weather.load()
        _bring_up(self.weather)

    def _show_choice(self) -> None:
        if self._weather is not None:
            self._weather.show_choice(self._window.form.forecast, self._window.form.weights)

    def _show_ends(self) -> None:
        if self._weather is not None:
            self._weather.show_ends(*((port.lat, port.lon) for port in self._window.form.ends.values()))

    def _key_changed(self) -> None:
        self._window.background.load_quota()
        self._window.background.load_horizon(self._window.form.forecast)

    def _beyond_chosen(self, mode: str) -> None:
        self._window.form.fill({"beyond": mode})
        self._window.form.sailing_changed.emit()

    def note(self, state: WindowState) -> None:
        """Take note of how a calculation ended: whether the services can be reached, what is kept now."""
        if self._passages is not None:
            self._passages.save_button.setEnabled(state.answer is not None)
        if self._weather is None:
            return
        if state.phase is Phase.FAILED and state.error is not None:
            self._weather.show_trouble(state.error)
        elif state.phase is Phase.ROUTE and state.answer is not None and state.answer.passage.forecast.real:
            self._weather.show_reached()
        self._weather.load()

    # --- the yachts ---------------------------------------------------------------------------------

    @property
    def yachts(self) -> YachtPage:
        """The page of the yachts and their polars."""
        if self._yachts is None:
            from seacruise.desktop.pages.yacht_page import YachtPage

            page, form = YachtPage(self._settings, QDialog(self._window)), self._window.form
            self._yachts = page
            self._in_window(page, self.tr("Yachts"), "yachts", (900, 720), page.view.table)
            page.show_light(self._window.layers.light)
            page.yacht_chosen.connect(lambda polar: form.fill({"yacht": polar.name}))
            page.percent_changed.connect(form.percent_box.setValue)
            background = self._window.background
            page.fleet_changed.connect(lambda: background.load_catalogue(form.wanted_yacht))
            self._window.layers.light_changed.connect(page.show_light)
        return self._yachts

    def show_yachts(self) -> None:
        """Open the page of the yachts at the one that the form names."""
        self.yachts.load(self._window.form.wanted_yacht)
        self.yachts.set_percent(self._window.form.options().percent_of_polar)
        _bring_up(self.yachts)

    # --- saved passages -----------------------------------------------------------------------------

    @property
    def passages(self) -> PassagesPage:
        """The page of saved passages."""
        if self._passages is None:
            from seacruise.desktop.pages.passages_page import PassagesPage

            page = self._passages = PassagesPage(self._settings, QDialog(self._window))
            self._in_window(page, self.tr("Saved passages"), "passages", (760, 420), page.table)
            page.open_requested.connect(self.open_saved)
            page.save_requested.connect(self.save)
            page.saved.connect(self._saved)
            page.failed.connect(lambda _error: _bring_up(page))
        return self._passages

    def show_passages(self) -> None:
        """Open the page of saved passages."""
        self.passages.load()
        self.passages.save_button.setEnabled(self._window.state.answer is not None)
        _bring_up(self.passages)

    def save(self) -> None:
        """Save the passage that the window shows."""
        if self._window.state.answer is not None:
            self.passages.save(self._window.state.answer)

    def _saved(self, entry: Entry) -> None:
        self._window.status.say(self.tr("Saved as “{name}”.").format(name=entry.name), 8.0)

    def open_saved(self, opened: Opened) -> None:
        """Show a saved passage as it was, with the form as it was then; nothing is computed."""
        from seacruise.desktop.pages.passages_model import answer_of, form_values

        answer, form = answer_of(opened), self._window.form
        self._window.steering.take_over(lambda: form.fill(form_values(opened.asked)), answer.question)
        sentence = opened.entry.provenance(datetime.now(UTC))
        self._window.show_saved(answer, Message("info", opened.entry.name, sentence))

    # --- windows ------------------------------------------------------------------------------------

    def _in_window(
        self, page: QWidget, title: str, name: str, size: tuple[int, int], *tables: RowsTable
    ) -> None:
        """Show a page in the dialog it was made in: put there later, all of it would be dressed anew."""
        dialog = page.window()
        assert isinstance(dialog, QDialog)
        dialog.setWindowTitle(title)
        layout = QVBoxLayout(dialog)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(page)
        room = self._window.screen().availableGeometry()
        dialog.resize(min(size[0], round(0.94 * room.width())), min(size[1], round(0.9 * room.height())))
        dialog.setMinimumSize(440, 320)
        self.made.emit(dialog, name, tables)

    @property
    def opened(self) -> tuple[WeatherPage | None, PassagesPage | None, YachtPage | None]:
        """The pages that were wanted so far."""
        return self._weather, self._passages, self._yachts

    def take_over(self, other: Desk) -> None:
        """Have the pages that another window has, filled in and open as they are there."""
        weather, passages, yachts = other.opened
        if weather is not None:
            self.weather.take_over(weather)
        if passages is not None:
            self.passages.take_over(passages)
        if yachts is not None:
            self.yachts.take_over(yachts)
        for page, show in (
            (weather, self.show_weather),
            (passages, self.show_passages),
            (yachts, self.show_yachts),
        ):
            if page is not None and page.isVisible():
                show()

    def shut_down(self) -> None:
        """Close the windows and end their workers; what was to be saved is saved."""
        for page in (self._weather, self._passages, self._yachts):
            if page is not None:
                page.window().hide()
                page.shut_down()


def _bring_up(page: QWidget) -> None:
    window = page.window()
    window.show()
    window.raise_()
    window.activateWindow()
