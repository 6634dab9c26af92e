"""Starting the window, and taking its picture."""

from __future__ import annotations

import logging
import signal
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from types import TracebackType
from typing import Any, Final

from PySide6.QtCore import QCoreApplication, QEvent, QObject, QTimer, Signal
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QApplication, QWidget

from seacruise.desktop.language import install
from seacruise.desktop.memory import WindowMemory
from seacruise.desktop.state import WindowState
from seacruise.desktop.style import apply_style, begin_style, worn
from seacruise.desktop.succession import Succession
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
    begin_style(app)
    settings = Settings.from_environment()
    with _logging(settings), _switching_fast():
        memory = WindowMemory(settings.data_dir) if screenshot is None else None
        install(app, memory)
        window = MainWindow(settings, memory=memory)
        _dress(app, window)
        restored = memory is not None and memory.restore_geometry(window, window.splitter)
        if size is not None:
            window.resize(*size)
        elif not restored:
            _fit_to_screen(window)
        window.fill(prefill)
        succession = Succession(app, window)
        with _faults_shown(succession), _interruptible(succession):
            window.show()
            if screenshot is None:
                # Nothing that is loaded is in the way of the first painting.
                painted = FirstPaint(window)
                painted.done.connect(window.load)
                if not prefill:
                    painted.done.connect(window.habits.welcome)
                # Its place may be taken; nothing here may keep it alive then.
                del window
                return int(app.exec())
            return _take_picture(app, window, screenshot, compute="start" in prefill and "end" in prefill)


def _dress(app: QApplication, window: MainWindow) -> None:
    """Put the style sheet on a window that is made.

    Put on before, it is applied to each widget anew with each widget that is put around it, which takes
    longer than making them.
    """
    if worn(app) is None:
        apply_style(app)
    # Their heights come from what is in them, which may be of another height now.
    window.pane.take_room()
    QCoreApplication.sendEvent(window.statusBar(), QEvent(QEvent.Type.LayoutRequest))


class FirstPaint(QObject):
    """Tells once, by ``done()``, that a window has been painted, or was not to be seen for a second."""

    done = Signal()
    _PATIENCE_MS = 1000

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self.done)
        self._timer.timeout.connect(self.deleteLater)
        self._timer.start(self._PATIENCE_MS)
        window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Take note of the painting; what is in the window is painted before the event loop goes on."""
        if event.type() == QEvent.Type.Paint:
            watched.removeEventFilter(self)
            self._timer.start(0)
        return False


def _fit_to_screen(window: MainWindow) -> None:
    screen = window.screen().availableGeometry()
    window.resize(min(1440, round(screen.width() * 0.92)), min(920, round(screen.height() * 0.92)))


def _take_picture(app: QApplication, window: MainWindow, path: Path, *, compute: bool) -> int:
    """Compute, wait until chart and panels are complete, save, and leave."""
    from seacruise.desktop.exporting import save_image

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


class _LogFile(logging.Handler):
    """Opens the file of the log when there is something to write: most starts write nothing."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self._path = path
        self._writer: logging.Handler | None = None

    def emit(self, record: logging.LogRecord) -> None:
        """Write a record."""
        if self._writer is None:
            from logging.handlers import RotatingFileHandler

            self._writer = RotatingFileHandler(
                self._path, maxBytes=_LOG_BYTES, backupCount=1, encoding="utf-8", delay=True
            )
            self._writer.setFormatter(self.formatter)
            # On a full disk there is no log; that is no fault of what was to be written, nor one to tell.
            self._writer.handleError = lambda _record: None  # type: ignore[assignment, method-assign]
        self._writer.handle(record)

    def close(self) -> None:
        """Close the file."""
        if self._writer is not None:
            with suppress(OSError):
                self._writer.close()
        super().close()


@contextmanager
def _logging(settings: Settings) -> Iterator[None]:
    """Keep what goes wrong in a file of the sailor's; without one where it cannot be written."""
    handler: logging.Handler = logging.NullHandler()
    with suppress(OSError):
        settings.data_dir.mkdir(parents=True, exist_ok=True)
        handler = _LogFile(settings.data_dir / "seacruise.log")
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
def _faults_shown(succession: Succession) -> Iterator[None]:
    """Show a mistake in a slot as one sentence, and log the rest; nothing ends the program."""
    before = sys.excepthook

    def hook(kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        log.error("A slot broke.", exc_info=(kind, error, trace))
        succession.window.show_fault(error)

    sys.excepthook = hook
    try:
        yield
    finally:
        sys.excepthook = before


@contextmanager
def _interruptible(succession: Succession) -> Iterator[None]:
    """Close the window on Ctrl+C in the terminal: Python only hears it when some Python code runs."""
    before = signal.signal(signal.SIGINT, lambda *_: succession.window.close())
    heartbeat = QTimer(succession)
    heartbeat.timeout.connect(lambda: None)
    heartbeat.start(250)
    try:
        yield
    finally:
        heartbeat.stop()
        signal.signal(signal.SIGINT, before)
