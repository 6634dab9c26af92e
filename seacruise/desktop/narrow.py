"""A window without room for three columns: question or answer beside the chart, whichever is wanted."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu, QPushButton, QScrollArea, QWidget

CHART_PX: Final = 386
"""Where the chart would be narrower than this, it has one column beside it only."""

_SHARE: Final = 0.55
"""Most of the window that a column may take where the letters are large."""

_SCROLL_BAR_PX: Final = 11

LOW_PX: Final = 560
"""Below this height the chart has none to spare for what is below it."""


class Columns(QObject):
    """Hides a column where there is room for one only.

    Signals: ``turned()`` when another column is shown, ``lowered()`` when the window has become a low one.

    Parameters
    ----------
    window, menu
        The entries that choose a column are added to the menu; their keys also give it the keyboard.
    question, answer
        What is in the columns; the scroll areas around them are hidden and shown.
    """

    turned = Signal()
    lowered = Signal()

    def __init__(self, window: QMainWindow, menu: QMenu, question: QWidget, answer: QWidget) -> None:
        super().__init__(window)
        self._window = window
        self._columns = {"question": question, "answer": answer}
        self._areas = {name: _area_of(body) for name, body in self._columns.items()}
        self._bodies = {name: _body_of(body) for name, body in self._columns.items()}
        self._usual = {name: area.minimumWidth() for name, area in self._areas.items()}
        self._shown = "question"
        self._was_low = False
        group = QActionGroup(self)
        self.actions: dict[str, QAction] = {}
        for name, text, key in (
            ("question", self.tr("What is as&ked"), "F6"),
            ("answer", self.tr("What is ans&wered"), "F7"),
        ):
            action = self.actions[name] = menu.addAction(text)
            action.setShortcut(QKeySequence(key))
            action.setCheckable(True)
            group.addAction(action)
            action.triggered.connect(lambda _on=False, column=name: self.go_to(column))
        self.button = QPushButton(window)
        self.button.setObjectName("flat")
        self.button.clicked.connect(lambda _on=False: self.go_to(self._other))
        window.statusBar().addPermanentWidget(self.button)
        window.installEventFilter(self)
        for body in self._bodies.values():
            body.installEventFilter(self)
        self._apply()

    @property
    def is_narrow(self) -> bool:
        """Whether there is room for one column only."""
        columns = sum(area.minimumWidth() for area in self._areas.values())
        return self._window.width() < columns + CHART_PX

    @property
    def shown(self) -> str:
        """The column that was wanted last, ``"question"`` or ``"answer"``."""
        return self._shown

    @property
    def _other(self) -> str:
        return "answer" if self._shown == "question" else "question"

    @property
    def is_low(self) -> bool:
        """Whether the window is so low that the chart needs all of it."""
        return self._window.height() < LOW_PX

    def show_column(self, name: str) -> None:
        """Show a column, ``"question"`` or ``"answer"``, where not both are."""
        if name != self._shown:
            self._shown = name
            self._apply()
            self.turned.emit()

    def go_to(self, name: str) -> None:
        """Show a column and give it the keyboard."""
        self.show_column(name)
        inside = [widget for widget in self._columns[name].findChildren(QWidget) if _takes_keys(widget)]
        if inside:
            inside[0].setFocus(Qt.FocusReason.TabFocusReason)

    def _make_room(self) -> None:
        """Give each column the width that what is in it needs, as far as the window has that."""
        most = round(_SHARE * self._window.width())
        for name, area in self._areas.items():
            needed = self._bodies[name].minimumSizeHint().width() + _SCROLL_BAR_PX
            width = max(self._usual[name], min(needed, most))
            if width != area.minimumWidth():
                area.setFixedWidth(width)

    def _apply(self) -> None:
        self._make_room()
        for name, area in self._areas.items():
            area.setVisible(not self.is_narrow or name == self._shown)
            self.actions[name].setChecked(name == self._shown)
        self.button.setVisible(self.is_narrow)
        texts = {"question": self.tr("To the question (F6)"), "answer": self.tr("To the answer (F7)")}
        self.button.setText(texts[self._other])

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Look again as the window changes its size."""
        if watched is not self._window and event.type() == QEvent.Type.LayoutRequest:
            self._apply()
        if watched is self._window and event.type() == QEvent.Type.Resize:
            self._apply()
            before, self._was_low = self._was_low, self.is_low
            if self._was_low and not before:
                self.lowered.emit()
        return bool(super().eventFilter(watched, event))


def _takes_keys(widget: QWidget) -> bool:
    return widget.isVisible() and widget.isEnabled() and bool(widget.focusPolicy().value & 1)


def _area_of(body: QWidget) -> QScrollArea:
    widget: QWidget | None = body
    while not isinstance(widget, QScrollArea):
        assert widget is not None, "what is in a column lies in a scroll area"
        widget = widget.parentWidget()
    return widget


def _body_of(widget: QWidget) -> QWidget:
    """Give what the scroll area around a widget scrolls."""
    area = _area_of(widget)
    while (parent := widget.parentWidget()) is not None and parent is not area.viewport():
        widget = parent
    return widget
