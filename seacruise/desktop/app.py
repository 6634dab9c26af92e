"""Starting the window, and taking its picture."""

from __future__ import annotations

import logging
import signal
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from logging.handlers import RotatingFileHandler
from pathlib import Path
from types import TracebackType
from typing import Any, Final

from PySide6.QtCore import QCoreApplication, QTimer
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QApplication

from seacruise.desktop.exporting import save_image
from seacruise.desktop.language import install
from seacruise.desktop.memory import WindowMemory
from seacruise.desktop.state import WindowState
from seacruise.desktop.style import apply_style
from seacruise.desktop.window import MainWindow
from seacruise.errors import InputError
from seacruise.settings import Settings

log = logging.getLogger(__name__)

SWITCH_S: Final = 0.0002
"""How long a worker may keep Python's lock while the window wants it; Python's own 5 ms can be felt when
a frame asks for it a dozen times."""

_LOG_BYTES: Final = 500_000
_POLL_MS: Final = 30


def open_window(
    prefill: Mapping[str, Any], *, screenshot: Path | None = None, size: tuple[int, int] | None = None
) -> int:
    """Open the window and return the exit code when it is closed.

    Parameters
    ----------
    prefill
        By the names of the command line's options: ``start``, ``end``, ``depart``, ``yacht``,
        ``forecast``, and the fields of `seacruise.passage.Options`.
    screenshot
        Compute the passage, save the picture of the window there, and leave.
    size
        Width and height of the window [pixels].

    Raises
    ------
    InputError
        There is no font to write with.
    SeaCruiseError
        With a screenshot: why there is no passage. The picture shows it, too.
    """
    app = QApplication.instance()
    if not isinstance(app, QApplication):
        QCoreApplication.setApplicationName("SeaCruise")
        app = QApplication(sys.argv[:1])
    if not QFontMetrics(app.font()).inFont("a"):
        raise InputError(
            "The window cannot open: no font is installed; on Debian or Ubuntu: "
            "apt-get install fonts-dejavu-core.",
            reason="no-window",
        )
    apply_style(app)
    settings = Settings.from_environment()
    with _logging(settings), _switching_fast():
        memory = WindowMemory(settings.data_dir) if screenshot is None else None
        install(app, memory)
        window = MainWindow(settings, memory=memory)
        restored = memory is not None and memory.restore_geometry(window, window.splitter)
        if size is not None:
            window.resize(*size)
        elif not restored:
            _fit_to_screen(window)
        window.fill(prefill)
        with _faults_shown(window), _interruptible(window):
            window.show()
            if screenshot is None:
                # After the first paint: nothing that is loaded is in its way.
                QTimer.singleShot(0, window.load)
                if not prefill:
                    QTimer.singleShot(0, window.habits.welcome)
                return int(app.exec())
            return _take_picture(app, window, screenshot, compute="start" in prefill and "end" in prefill)


def _fit_to_screen(window: MainWindow) -> None:
    screen = window.screen().availableGeometry()
    window.resize(min(1440, round(screen.width() * 0.92)), min(920, round(screen.height() * 0.92)))


def _take_picture(app: QApplication, window: MainWindow, path: Path, *, compute: bool) -> int:
    """Compute, wait until chart and panels are complete, save, and leave."""
    ended: list[WindowState] = []

    def start() -> None:
        if not compute:
            ended.append(window.state)
            return
        window.calculate()
        if not window.jobs.is_running:
            ended.append(window.state)

    def poll() -> None:
        if ended and window.chart.view.is_settled:
            app.quit()

    window.ready.connect(start)
    window.settled.connect(ended.append)
    timer = QTimer(window)
    timer.timeout.connect(poll)
    timer.start(_POLL_MS)
    window.load(warm_up=False)
    app.exec()
    timer.stop()
    save_image(window.grab().toImage(), path)
    window.close()
    if ended and ended[-1].error is not None:
        raise ended[-1].error
    return 0


@contextmanager
def _logging(settings: Settings) -> Iterator[None]:
    """Keep what goes wrong in a file of the sailor's; without one where it cannot be written."""
    handler: logging.Handler = logging.NullHandler()
    with suppress(OSError):
        settings.data_dir.mkdir(parents=True, exist_ok=True)
        handler = RotatingFileHandler(
            settings.data_dir / "seacruise.log",
            maxBytes=_LOG_BYTES,
            backupCount=1,
            encoding="utf-8",
            delay=True,
        )
    handler.setFormatter(logging.Formatter("%(asctime)s %(levelname)s %(name)s: %(message)s"))
    root = logging.getLogger("seacruise")
    root.addHandler(handler)
    try:
        yield
    finally:
        root.removeHandler(handler)
        handler.close()


@contextmanager
def _switching_fast() -> Iterator[None]:
    before = sys.getswitchinterval()
    sys.setswitchinterval(SWITCH_S)
    try:
        yield
    finally:
        sys.setswitchinterval(before)


@contextmanager
def _faults_shown(window: MainWindow) -> Iterator[None]:
    """Show a mistake in a slot as one sentence, and log the rest; nothing ends the program."""
    before = sys.excepthook

    def hook(kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        log.error("A slot broke.", exc_info=(kind, error, trace))
        window.show_fault(error)

    sys.excepthook = hook
    try:
        yield
    finally:
        sys.excepthook = before


@contextmanager
def _interruptible(window: MainWindow) -> Iterator[None]:
    """Close the window on Ctrl+C in the terminal: Python only hears it when some Python code runs."""
    before = signal.signal(signal.SIGINT, lambda *_: window.close())
    heartbeat = QTimer(window)
    heartbeat.timeout.connect(lambda: None)
    heartbeat.start(250)
    try:
        yield
    finally:
        heartbeat.stop()
        signal.signal(signal.SIGINT, before)
