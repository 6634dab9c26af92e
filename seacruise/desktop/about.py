"""About SeaCruise: what it is, where its data is from and under which terms, and its versions."""

from __future__ import annotations

import html
import platform
import re
from importlib import metadata
from pathlib import Path
from typing import Final

from PySide6.QtCore import Qt, QUrl, qVersion
from PySide6.QtGui import QDesktopServices, QGuiApplication
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFrame,
    QLabel,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

import seacruise
from seacruise.desktop.banner import text_label
from seacruise.desktop.style import scaled_font
from seacruise.errors import InputError
from seacruise.resources import resource_path

_PACKAGES: Final = ("PySide6-Essentials", "numpy", "numba", "shapely", "eccodes", "netCDF4")


class AboutDialog(QDialog):
    """Version, purpose, sources and licences, versions to copy, and where the program keeps its files."""

    def __init__(self, data_dir: Path, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("About SeaCruise"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._data_dir = data_dir
        title = QLabel(f"SeaCruise {seacruise.__version__}", self)
        title.setFont(scaled_font(self.font(), 1.6, bold=True))
        purpose = text_label(
            self.tr("How long will the cruise take under sail, and is a week enough?"), parent=self
        )
        caution = text_label(
            self.tr(
                "A planning aid, not for navigation. It knows land, the forecast and the yacht's polar; "
                "it does not know shoals, traffic schemes, local rules or your crew."
            ),
            parent=self,
        )
        caution.setFont(scaled_font(self.font(), 1.0, bold=True))
        self.copy_button = QPushButton(self.tr("&Copy versions for a bug report"), self)
        self.copy_button.clicked.connect(self.copy_versions)
        self.copied = text_label("", "hint", self)
        self.copied.hide()
        folder = text_label(
            self.tr("Your files and seacruise.log: {folder}").format(folder=data_dir), "hint", self
        )
        folder.setTextInteractionFlags(
            Qt.TextInteractionFlag.TextSelectableByMouse | Qt.TextInteractionFlag.TextSelectableByKeyboard
        )
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close, self)
        buttons.addButton(self.copy_button, QDialogButtonBox.ButtonRole.ActionRole)
        open_button = buttons.addButton(self.tr("&Open that folder"), QDialogButtonBox.ButtonRole.ActionRole)
        open_button.clicked.connect(self._open_folder)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(24, 20, 24, 16)
        layout.setSpacing(10)
        for widget in (title, purpose, caution, self._sources(), folder, self.copied, buttons):
            layout.addWidget(widget)
        layout.setStretch(3, 1)
        self.setMinimumSize(420, 320)
        room = (parent or self).screen().availableGeometry()
        self.resize(min(640, room.width()), min(620, room.height() - 40))

    def _sources(self) -> QScrollArea:
        said = QLabel(notice_html(), self)
        said.setTextFormat(Qt.TextFormat.RichText)
        said.setWordWrap(True)
        said.setOpenExternalLinks(True)
        said.setTextInteractionFlags(Qt.TextInteractionFlag.TextBrowserInteraction)
        said.setAlignment(Qt.AlignmentFlag.AlignTop)
        said.setContentsMargins(12, 10, 12, 10)
        area = QScrollArea(self)
        area.setAccessibleName(self.tr("Sources and licences"))
        area.setFrameShape(QFrame.Shape.StyledPanel)
        area.setWidgetResizable(True)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setWidget(said)
        return area

    def copy_versions(self) -> None:
        """Put what a bug report needs on the clipboard: versions, nothing of the sailor's own."""
        QGuiApplication.clipboard().setText(versions())
        self.copied.setText(self.tr("Copied: versions of SeaCruise, Python, Qt and the system."))
        self.copied.show()

    def _open_folder(self) -> None:
        QDesktopServices.openUrl(QUrl.fromLocalFile(str(self._data_dir)))


def notice_html() -> str:
    """Give the file NOTICE as rich text: it alone says what is in the program, and under which terms."""
    try:
        text = resource_path("NOTICE").read_text(encoding="utf-8")
    except (InputError, OSError) as error:
        return html.escape(str(error))
    return "".join(f"<p style='line-height: 130%'>{_block_html(block)}</p>" for block in text.split("\n\n"))


def _block_html(block: str) -> str:
    """Write a paragraph; one that is indented below its first line has that for a heading."""
    first, *rest = block.strip("\n").split("\n")
    if rest and all(line.startswith("    ") for line in rest):
        said = f"<b>{html.escape(first)}</b><br>{html.escape(' '.join(line.strip() for line in rest))}"
    else:
        said = html.escape(" ".join((first, *rest)))
    return re.sub(r"https?://[^\s)<]+[^\s)<.,;]", lambda found: f"<a href='{found[0]}'>{found[0]}</a>", said)


def versions() -> str:
    """Versions of the program, of Python, Qt and the larger libraries, and of the system; no paths."""
    lines = [
        f"SeaCruise {seacruise.__version__}",
        f"Python {platform.python_version()}, Qt {qVersion()}",
        f"{platform.system()} {platform.release()}, {platform.machine()}",
    ]
    screen = QGuiApplication.primaryScreen()
    if screen is not None:
        width, height, scale = screen.size().width(), screen.size().height(), screen.devicePixelRatio()
        lines.append(f"{QGuiApplication.platformName()}, {width}x{height} at {scale:g}")
    lines += [f"{name} {_version(name)}" for name in _PACKAGES]
    return "\n".join(lines) + "\n"


def _version(package: str) -> str:
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return "?"
