"""The field for the forecast: services, practice weather, the sample, or files of one's own."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QFileDialog, QSizePolicy, QWidget

FILE_TYPES: Final = "GRIB, NetCDF (*.grib *.grib2 *.grb *.grb2 *.nc *.nc4);;* (*)"
_CHOOSE_FILE: Final = "choose-file"


class ForecastBox(QComboBox):
    """Combo box of forecasts; ``forecast_changed()`` when another one is chosen, here or elsewhere."""

    forecast_changed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._forecast: tuple[str, ...] = ("auto",)
        self._weights: tuple[float, ...] = ()
        # The names of files may be as long as they like; the column stays as wide as it is.
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        for text, name in (
            (self.tr("Automatic"), "auto"),
            (self.tr("Storm Glass (needs a key)"), "stormglass"),
            (self.tr("Open-Meteo"), "open-meteo"),
            (self.tr("Open-Meteo ensemble"), "open-meteo-ensemble"),
            (self.tr("MET Norway"), "metno"),
            (self.tr("Practice weather (not a forecast)"), "practice"),
            (self.tr("Sample: 20–22 November 2016"), "sample"),
            (self.tr("GRIB or NetCDF file…"), _CHOOSE_FILE),
        ):
            self.addItem(text, (name,))
        self.activated.connect(self._picked)

    @property
    def forecast(self) -> tuple[str, ...]:
        """Chosen forecast, as on the command line."""
        return self._forecast

    @property
    def weights(self) -> tuple[float, ...]:
        """Weights of several forecasts in their mean; empty for equal ones."""
        return self._weights

    def set_forecast(self, names: tuple[str, ...], weights: tuple[float, ...] = ()) -> None:
        """Choose a forecast by the names of the command line; what is not there gets an entry."""
        at = next((i for i in range(self.count()) if tuple(self.itemData(i)) == names), -1)
        if at < 0:
            at = self.count() - 1
            self.insertItem(at, ", ".join(Path(name).name for name in names), names)
            self.setItemData(at, "\n".join(names), Qt.ItemDataRole.ToolTipRole)
        self.setCurrentIndex(at)
        self.setToolTip("\n".join(names) if len("".join(names)) > 20 else "")
        changed = (names, weights) != (self._forecast, self._weights)
        self._forecast, self._weights = names, weights
        if changed:
            self.forecast_changed.emit()

    def _picked(self, index: int) -> None:
        names = tuple(self.itemData(index))
        if names == (_CHOOSE_FILE,):
            self.set_forecast(self._forecast, self._weights)
            self.ask_for_files()
        else:
            self.set_forecast(names)

    def ask_for_files(self) -> None:
        """Let the sailor choose files; several are averaged."""
        dialog = QFileDialog(self, self.tr("Forecast files"), "", FILE_TYPES)
        dialog.setFileMode(QFileDialog.FileMode.ExistingFiles)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.filesSelected.connect(lambda files: self.set_forecast(tuple(files)))
        dialog.open()
