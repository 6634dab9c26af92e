"""Opens the window as the program does and prints when its first frame was drawn; see `benchmarks.window`."""

from __future__ import annotations

import os
import sys
import time

from PySide6.QtCore import QEvent, QObject, QTimer
from PySide6.QtWidgets import QApplication, QWidget


class FirstFrame(QObject):
    """Sees every widget being painted; the last of the first frame is what counts."""

    def __init__(self) -> None:
        super().__init__()
        self.painted = 0.0
        self.waiting = False

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Note the time after each paint event, and report once the frame is complete."""
        if event.type() == QEvent.Type.Paint and isinstance(watched, QWidget):
            self.painted = time.time()
            if not self.waiting:
                self.waiting = True
                # The whole frame is painted before the event loop runs the next timer.
                QTimer.singleShot(0, self.report)
        return False

    def report(self) -> None:
        """Print the time, seconds since 1970, and leave without closing anything."""
        print(self.painted, flush=True)
        os._exit(0)


def main() -> int:
    """Open the window of the program, watched."""
    app = QApplication(sys.argv[:1])
    frame = FirstFrame()
    app.installEventFilter(frame)
    from seacruise.desktop.app import open_window

    return open_window({})


if __name__ == "__main__":
    sys.exit(main())
