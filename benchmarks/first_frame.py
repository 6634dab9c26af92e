"""Opens the window as the program does and prints when its first frame was drawn; see `benchmarks.window`.

Nothing watches the making of the window: an event filter on the application, in Python, took 0.1 s of it.
"""

from __future__ import annotations

import json
import os
import sys
import time
from pathlib import Path

import seacruise.commands.window as command
from seacruise.cli import main

_trouble = command.qt_trouble


def watch() -> str | None:
    """Load Qt and the window as the program does, and stand by for the first painting."""
    trouble = _trouble()
    from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt
    from PySide6.QtGui import QPaintEvent
    from PySide6.QtWidgets import QMainWindow

    from seacruise.desktop.window import MainWindow

    class Bell(QObject):
        """Rung by the window, which is painted first; answers when everything in it has been painted."""

        def customEvent(self, _event: QEvent) -> None:  # noqa: N802 - Qt's name
            report()

    bell = Bell()

    def paint(window: MainWindow, event: QPaintEvent) -> None:
        QMainWindow.paintEvent(window, event)
        QCoreApplication.postEvent(bell, QEvent(QEvent.Type.User), Qt.EventPriority.HighEventPriority.value)

    MainWindow.paintEvent = paint  # type: ignore[assignment, method-assign]
    return trouble


def report() -> None:
    """Print time [s since 1970], processor time [s] and memory [MB], and leave without closing anything."""
    figures = {"painted": time.time(), "cpu_s": time.process_time()}
    print(json.dumps(figures | memory()), flush=True)
    os._exit(0)


def memory() -> dict[str, float]:
    """Tell the resident and the anonymous memory [MB], where the system tells it."""
    try:
        lines = Path("/proc/self/smaps_rollup").read_text(encoding="ascii").splitlines()
    except OSError:
        return {}
    names = {"Rss:": "rss_mb", "Anonymous:": "own_mb"}
    return {
        names[words[0]]: round(int(words[1]) * 1024 / 1e6, 1)
        for words in map(str.split, lines)
        if words and words[0] in names
    }


if __name__ == "__main__":
    command.qt_trouble = watch
    sys.argv[1:] = ["window"]
    sys.exit(main())
