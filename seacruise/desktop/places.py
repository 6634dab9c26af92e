"""Where the windows beside the chart were, and how wide their columns: from one start to the next."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QEvent, QObject, QRect, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QWidget

if TYPE_CHECKING:
    from seacruise.desktop.memory import WindowMemory
    from seacruise.desktop.pages.rows import RowsTable

_KEPT_AS: Final = "places"
_SIDES_PX: Final = 12
_TITLE_PX: Final = 36
"""Room for the frame of a window, which is not known before it is shown."""


def on_a_screen(wanted: QRect, screens: Sequence[QRect], home: QRect) -> QRect:
    """Fit a window onto a screen that exists: onto the one that has most of it, else onto ``home``.

    Parameters
    ----------
    screens, home
        What windows may take of each screen, and of the one of the main window.
    """

    def shared(screen: QRect) -> int:
        both = screen.intersected(wanted)
        return both.width() * both.height() if both.isValid() else 0

    screen = max(screens, key=shared, default=home)
    room = (screen if shared(screen) else home).adjusted(0, 0, -_SIDES_PX, -_TITLE_PX)
    width, height = min(wanted.width(), room.width()), min(wanted.height(), room.height())
    left = min(max(wanted.left(), room.left()), room.left() + room.width() - width)
    top = min(max(wanted.top(), room.top()), room.top() + room.height() - height)
    return QRect(left, top, width, height)


class Places(QObject):
    """Keeps sizes and places of windows when they are hidden, and widths of columns with them.

    Parameters
    ----------
    home
        The main window: what was on a screen that is gone comes to its screen.
    memory
        ``None`` where nothing is to be remembered.
    """

    def __init__(self, home: QWidget, memory: WindowMemory | None) -> None:
        super().__init__(home)
        self._home, self._memory = home, memory
        self._kept = memory.recall(_KEPT_AS) if memory is not None else {}
        self._windows: dict[QWidget, str] = {}
        self._tables: dict[str, RowsTable] = {}

    def watch(self, window: QWidget, name: str, *tables: RowsTable) -> None:
        """Bring a window to where it was, and keep where it is put; its tables with it."""
        if (kept := _rect(self._kept.get(name))) is not None:
            screens = [screen.availableGeometry() for screen in QGuiApplication.screens()]
            place = on_a_screen(kept, screens, self._home.screen().availableGeometry())
            window.move(place.topLeft())
            window.resize(place.size())
        self._windows[window] = name
        window.installEventFilter(self)
        for number, table in enumerate(tables):
            self.watch_table(table, f"{name}-{number}")

    def watch_table(self, table: RowsTable, name: str) -> None:
        """Give a table the columns that it had, and keep what the sailor makes of them."""
        if isinstance(kept := self._kept.get(name), dict):
            table.restore(kept)
        self._tables[name] = table

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Take note of a window that is put away."""
        if event.type() == QEvent.Type.Hide and not event.spontaneous():
            self.keep()
        return bool(super().eventFilter(watched, event))

    def keep(self) -> None:
        """Remember everything that was looked at since the start."""
        for window, name in self._windows.items():
            if window.testAttribute(Qt.WidgetAttribute.WA_WState_ExplicitShowHide):
                at, size = window.pos(), window.size()
                self._kept[name] = [at.x(), at.y(), size.width(), size.height()]
        for name, table in self._tables.items():
            self._kept[name] = table.contents()
        if self._memory is not None:
            self._memory.keep(_KEPT_AS, self._kept)


def _rect(kept: Any) -> QRect | None:
    """Rectangle of a list of four numbers; ``None`` for anything else, as in a damaged file."""
    if not isinstance(kept, list) or len(kept) != 4 or not all(type(n) is int for n in kept):
        return None
    rect = QRect(*(min(max(n, -100_000), 100_000) for n in kept))
    return rect if rect.width() > 0 and rect.height() > 0 else None
