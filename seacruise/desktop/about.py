"""About SeaCruise: what it is, where its data is from, and under which terms."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QLabel, QVBoxLayout, QWidget

import seacruise
from seacruise.desktop.banner import text_label
from seacruise.desktop.style import scaled_font


class AboutDialog(QDialog):
    """Version, purpose, sources and licences, and where the program keeps its files."""

    def __init__(self, data_dir: Path, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("About SeaCruise"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        title = QLabel(f"SeaCruise {seacruise.__version__}", self)
        title.setFont(scaled_font(self.font(), 1.6, bold=True))
        purpose = text_label(
            self.tr("How long will the cruise take under sail, and is a week enough?"), parent=self
        )
        caution = text_label(
            self.tr(
                "A planning aid, not for navigation. It knows land, wind and the yacht's polar; it does not "
                "know shoals, traffic schemes, waves, currents or your crew."
            ),
            parent=self,
        )
        caution.setFont(scaled_font(self.font(), 1.0, bold=True))
        sources = QLabel(self.sources(data_dir), self)
        sources.setTextFormat(Qt.TextFormat.RichText)
        sources.setWordWrap(True)
        sources.setOpenExternalLinks(True)
        sources.setTextInteractionFlags(Qt.TextInteractionFlag.TextBrowserInteraction)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close, self)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(24, 20, 24, 16)
        layout.setSpacing(12)
        for widget in (title, purpose, caution, sources, buttons):
            layout.addWidget(widget)
        self.setMinimumWidth(560)

    def sources(self, data_dir: Path) -> str:
        """Give sources and licences as rich text."""
        lines = (
            self.tr("<b>Coast</b>: © OpenStreetMap contributors, Open Database License (ODbL) 1.0."),
            self.tr("<b>Land elsewhere</b>: GLOBE elevation model of NOAA, by global-land-mask."),
            self.tr("<b>Sample weather</b>: GFS analyses of NOAA, public domain."),
            self.tr("<b>Forecasts</b>: Storm Glass, with a key of your own; GRIB and NetCDF files."),
            self.tr("<b>Polars</b>: speed predictions of the Offshore Racing Congress (ORC)."),
            self.tr("<b>Built with</b>: Qt and PySide6 (LGPL 3), NumPy, Numba, Shapely."),
            self.tr("<b>SeaCruise itself</b>: Apache License 2.0; see LICENSE and NOTICE."),
            self.tr("<b>Your files and seacruise.log</b>: {folder}").format(folder=data_dir),
        )
        return "<p style='line-height: 140%'>" + "<br>".join(lines) + "</p>"
