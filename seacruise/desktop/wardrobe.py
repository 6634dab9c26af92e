"""Another light for the whole program, without holding it up.

Qt gives a new style sheet to all widgets at once and lays each out anew, which takes a third of a second.
Here sheet and palette are changed without telling the widgets; then each is polished by itself, those that
are seen first, some milliseconds at a time. Nothing is laid out anew: a light changes colours only.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from typing import Final

import shiboken6
from PySide6.QtCore import QObject, Qt, QTimer
from PySide6.QtWidgets import QApplication, QLabel, QWidget

from seacruise.desktop.style import apply_palette, apply_style, style_sheet, worn

_MOST_IN_A_PART: Final = 30
_LINK: Final = "<a "
_STEP_S: Final = 0.008
"""So long a step of changing the look may take, and one thing more [s]."""

_PAUSE_MS: Final = 4
"""Between two steps; with none, what else waits might be passed over."""


class Wardrobe(QObject):
    """Changes the look of a program that is shown, step by step: its window lives between two of them."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        app = QApplication.instance()
        assert isinstance(app, QApplication)
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
        if worn(self._app) == light and not self.is_changing:
            return
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
        app.setProperty("light", None)
        # Who has forgotten what the old sheet said of the widgets finds none to give the new one to.
        app.style().unpolish(app)
        app.setStyleSheet(style_sheet(self._light))
        apply_palette(app, self._light)
        yield False
        seen, others = _dressed(app)
        yield from _polish(seen)
        while self._hidden:
            part = self._hidden.pop()
            if shiboken6.isValid(part):
                part.setUpdatesEnabled(True)
                part.repaint()
                yield True
        yield from _polish(others)
        app.setProperty("light", self._light)


def _dressed(app: QApplication) -> tuple[list[QWidget], list[QWidget]]:
    """Widgets that wear the sheet, those that are seen and those that are not; each after what it is in."""
    windows = app.topLevelWidgets()
    every = [widget for window in windows for widget in (window, *window.findChildren(QWidget))]
    worn = [widget for widget in every if widget.testAttribute(Qt.WidgetAttribute.WA_WState_Polished)]
    return [w for w in worn if w.isVisible()], [w for w in worn if not w.isVisible()]


def _polish(widgets: Sequence[QWidget]) -> Iterator[bool]:
    for widget in widgets:
        if shiboken6.isValid(widget):
            widget.style().polish(widget)
            if isinstance(widget, QLabel) and _LINK in widget.text():
                _read_again(widget)
            yield True


def _read_again(label: QLabel) -> None:
    """Let a label read its text anew: links have the colour that they had when it was read."""
    form = label.textFormat()
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setTextFormat(form)


def _parts(widget: QWidget) -> list[QWidget]:
    """Divide a window into parts that are painted in a step each."""
    inner = [child for child in widget.children() if isinstance(child, QWidget) and child.isVisible()]
    if not inner or len(widget.findChildren(QWidget)) <= _MOST_IN_A_PART:
        return [widget] if widget.isVisible() else []
    return [part for child in inner for part in _parts(child)]
