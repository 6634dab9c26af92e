"""Another light for the whole program, without holding it up for long.

A style sheet that replaces another is applied to each widget once for each of its ancestors, which takes a
third of a second. So the old one is taken off first, and the new one put on in the next step; then the window
is laid out and painted part by part.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from typing import Final

import shiboken6
from PySide6.QtCore import QCoreApplication, QEvent, QObject, QTimer
from PySide6.QtWidgets import QApplication, QWidget

from seacruise.desktop.style import apply_palette, apply_style, style_sheet

_MOST_IN_A_PART: Final = 30
_STEP_S: Final = 0.008
"""So long a step of changing the look may take, and one thing more [s]."""

_PAUSE_MS: Final = 4
"""Between two steps; with none, what else waits might be passed over."""


class Wardrobe(QObject):
    """Changes the look of a program that is shown, step by step: its window lives between two of them."""

    def __init__(self, app: QApplication, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._app = app
        self._light = "day"
        self._steps: Iterator[bool] | None = None
        self._hidden: list[QWidget] = []
        self._timer = QTimer(self)
        self._timer.setInterval(_PAUSE_MS)
        self._timer.timeout.connect(self._step)

    @property
    def is_changing(self) -> bool:
        """Whether the look is not yet complete."""
        return self._steps is not None

    def change(self, light: str) -> None:
        """Change to a light; one that is being changed to is given up."""
        self._light = light
        if not any(window.isVisible() for window in self._app.topLevelWidgets()):
            apply_style(self._app, light)
            return
        self._hidden += [part for window in self._app.topLevelWidgets() for part in _parts(window)]
        for part in self._hidden:
            part.setUpdatesEnabled(False)
        self._steps = self._change()
        self._timer.start()

    def _step(self) -> None:
        begun = time.perf_counter()
        steps = self._steps
        while steps is not None and time.perf_counter() - begun < _STEP_S:
            go_on = next(steps, None)
            if go_on is None:
                self._steps = None
                self._timer.stop()
            if not go_on:
                return

    def _change(self) -> Iterator[bool]:
        """Change the look; gives, between two steps, whether the next may follow at once."""
        app = self._app
        app.setStyleSheet("")
        apply_palette(app, self._light)
        _forget_layouts()
        yield False
        app.setStyleSheet(style_sheet(self._light))
        yield False
        for widget in reversed(_seen(app)):
            if shiboken6.isValid(widget) and (layout := widget.layout()) is not None:
                layout.activate()
                yield True
        while self._hidden:
            part = self._hidden.pop()
            if shiboken6.isValid(part):
                # It is painted before the next step.
                part.setUpdatesEnabled(True)
                yield False


def _seen(app: QApplication) -> list[QWidget]:
    """Widgets that are seen, each after the one that it is in."""
    windows = [window for window in app.topLevelWidgets() if window.isVisible()]
    return [w for window in windows for w in (window, *window.findChildren(QWidget)) if w.isVisible()]


def _parts(widget: QWidget) -> list[QWidget]:
    """Divide a window into parts that are painted in a step each."""
    inner = [child for child in widget.children() if isinstance(child, QWidget) and child.isVisible()]
    if not inner or len(widget.findChildren(QWidget)) <= _MOST_IN_A_PART:
        return [widget] if widget.isVisible() else []
    return [part for child in inner for part in _parts(child)]


def _forget_layouts() -> None:
    """Lay nothing out while the style is incomplete; who calls it activates the layouts later."""
    # The stub knows no None, which is everybody.
    QCoreApplication.removePostedEvents(None, QEvent.Type.LayoutRequest)  # type: ignore[arg-type]
