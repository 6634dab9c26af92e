"""What the buttons of a banner do."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from seacruise.desktop.messages import WayOut
from seacruise.errors import NoPassageError

if TYPE_CHECKING:
    from seacruise.desktop.window import MainWindow


class WaysOut(QObject):
    """Takes a way out of a trouble, for the window and all its pages."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window

    def take(self, way_out: WayOut) -> None:
        """Do what a button says."""
        window = self._window
        form = window.form
        match way_out:
            case WayOut.PRACTICE:
                form.set_forecast(("practice",))
            case WayOut.DEPARTURE:
                form.departure.use_first_hour(datetime.now(UTC))
            case WayOut.ENGINE:
                form.use_engine()
            case WayOut.SHOW_PLACE:
                error = window.state.error
                if isinstance(error, NoPassageError) and error.place is not None:
                    window.chart.view.show_place(*error.place)
            case WayOut.RETRY:
                window.calculate()
            case WayOut.WEATHER:
                window.desk.show_weather()
            case WayOut.OPTIONS:
                form.options_bar.open_dialog()
            case WayOut.FORM:
                window.habits.columns.show_column("question")
                form.wrong_field.setFocus()
            case WayOut.ABOUT:
                window.show_about()
