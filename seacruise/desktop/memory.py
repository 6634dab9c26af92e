"""What the window remembers from one day to the next: its size, its layers, the last form."""

from __future__ import annotations

import json
import logging
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QByteArray, QSettings

if TYPE_CHECKING:
    from pathlib import Path

    from PySide6.QtWidgets import QMainWindow, QSplitter

log = logging.getLogger(__name__)


class WindowMemory:
    """An INI file in the sailor's data folder; a broken or locked one costs nothing but the memory.

    Parameters
    ----------
    data_dir
        `seacruise.settings.Settings.data_dir`.
    """

    def __init__(self, data_dir: Path) -> None:
        self._settings = QSettings(str(data_dir / "window.ini"), QSettings.Format.IniFormat)

    def restore_geometry(self, window: QMainWindow, splitter: QSplitter) -> bool:
        """Give the window its last place; False when there is none."""
        geometry, parts = self._settings.value("geometry"), self._settings.value("splitter")
        if isinstance(parts, QByteArray):
            splitter.restoreState(parts)
        return isinstance(geometry, QByteArray) and window.restoreGeometry(geometry)

    def keep_geometry(self, window: QMainWindow, splitter: QSplitter) -> None:
        """Remember the window's place."""
        self._settings.setValue("geometry", window.saveGeometry())
        self._settings.setValue("splitter", splitter.saveState())

    def recall(self, name: str) -> dict[str, Any]:
        """Things kept under a name; empty when there are none that can be read."""
        text = self._settings.value(name, "")
        try:
            values = json.loads(text) if isinstance(text, str) and text else {}
        except (ValueError, RecursionError):
            log.warning("What the window remembered of %s is broken; it starts afresh.", name)
            return {}
        return values if isinstance(values, dict) else {}

    def keep(self, name: str, values: dict[str, object]) -> None:
        """Keep things under a name."""
        self._settings.setValue(name, json.dumps(values, ensure_ascii=False))

    def flush(self) -> None:
        """Write to disk now."""
        self._settings.sync()
        if self._settings.status() != QSettings.Status.NoError:
            log.warning("The window's state could not be written to %s.", self._settings.fileName())
