"""Saving the passage: GPX for the plotter, CSV for a spreadsheet, PNG for the crew."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QObject, Qt, Signal
from PySide6.QtGui import QImage, QImageWriter
from PySide6.QtWidgets import QWidget

from seacruise.atomic import write_atomically
from seacruise.desktop.jobs import JobRunner

if TYPE_CHECKING:
    from seacruise.export.beside import Beside
    from seacruise.passage import Passage
    from seacruise.weather.wind import Wind


def save_image(image: QImage, path: Path) -> None:
    """Write a picture.

    Raises
    ------
    InputError
        It cannot be written there.
    """
    picture = QBuffer()
    picture.open(QIODevice.OpenModeFlag.WriteOnly)
    QImageWriter(picture, QByteArray(b"png")).write(image)
    write_atomically(path, bytes(picture.data().data()), what="picture")


class Exporter(QObject):
    """Asks for a file name and writes on a worker; ``saved(path)`` or ``failed(error)``."""

    saved = Signal(object)
    failed = Signal(object)

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window
        self._runner = JobRunner("export", self)
        self._runner.finished.connect(lambda _, path: self.saved.emit(path))
        self._runner.failed.connect(lambda _, error: self.failed.emit(error))

    def ask(self, form: str, passage: Passage, wind: Wind, beside: Beside) -> None:
        """Save the passage: ``gpx``, ``csv``, ``png``, ``pdf``, ``kml`` or ``geojson``.

        What lies beside it on the chart is in the picture only: all others are of the passage that is sailed.

        The picture and the passage plan are not the screen, but sheets with title, times and sources to hand
        around. The plan speaks the window's language; what programs read stays as it is everywhere.
        """
        types = {
            "gpx": self.tr("GPX route (*.gpx)"),
            "csv": self.tr("Table of legs (*.csv)"),
            "png": self.tr("Picture (*.png)"),
            "pdf": self.tr("Passage plan (*.pdf)"),
            "kml": self.tr("KML for Google Earth (*.kml)"),
            "geojson": self.tr("GeoJSON (*.geojson)"),
        }

        def write(path: Path) -> None:
            from seacruise.export import chart, csvform, geojson, gpx, kml, pdf

            if form == "png":
                chart.write_chart(passage, path, wind=wind, beside=beside)
                return
            if form == "pdf":
                from seacruise.desktop.printed import paper_words

                pdf.write_pdf(passage, path, wind=wind, words=paper_words())
                return
            writers = {
                "gpx": gpx.write_gpx,
                "csv": csvform.write_csv,
                "kml": kml.write_kml,
                "geojson": geojson.write_geojson,
            }
            writers[form](passage, path)

        self._ask(_file_name(passage, form), types[form], write)

    def write(self, path: Path, write: Callable[[Path], None]) -> None:
        """Write a file on a worker."""

        def work(_job: object) -> Path:
            write(path)
            return path

        self._runner.run_job(work)

    def _ask(self, name: str, types: str, write: Callable[[Path], None]) -> None:
        from PySide6.QtWidgets import QFileDialog

        dialog = QFileDialog(self._window, self.tr("Save the passage"), name, types)
        dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
        dialog.setDefaultSuffix(Path(name).suffix[1:])
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.fileSelected.connect(lambda chosen: self.write(Path(chosen), write))
        dialog.open()

    def shut_down(self) -> None:
        """Let a file that is being written be finished."""
        self._runner.shut_down()


def _file_name(passage: Passage, suffix: str) -> str:
    name = f"{passage.start.name}-{passage.end.name}-{passage.departure:%Y-%m-%d-%H%M}.{suffix}"
    return "".join(letter if letter.isalnum() or letter in "-." else "_" for letter in name)
