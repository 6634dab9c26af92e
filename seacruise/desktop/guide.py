"""The first-run guide: three small cards beside what they speak of. Nothing waits for them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QApplication, QFrame, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from seacruise.desktop.banner import text_label
from seacruise.desktop.style import scaled_font

_WIDTH: Final = 300
_GAP: Final = 14


@dataclass(frozen=True, slots=True)
class Step:
    """A card.

    Attributes
    ----------
    beside
        The widget it speaks of; it stands to its right, or above it where that is lower down.
    """

    title: str
    text: str
    beside: QWidget


class Guide(QFrame):
    """The cards, one at a time over the chart; ``closed()`` when they were put away, read or not.

    They take no click but on themselves, and Esc puts them away from wherever the keyboard is.

    Parameters
    ----------
    steps
        What to say, in order.
    over
        The cards lie over this, and are children of its window.
    """

    closed = Signal()

    def __init__(self, steps: Sequence[Step], over: QWidget) -> None:
        super().__init__(over.window())
        self._steps, self._over = tuple(steps), over
        self._at = 0
        self.setObjectName("card")
        self.setAccessibleName(self.tr("Guide"))
        self.count = QLabel(self)
        self.count.setObjectName("hint")
        self.title = text_label("", "", self)
        self.title.setFont(scaled_font(self.font(), 1.15, bold=True))
        self.text = text_label("", "", self)
        self.skip_button = self._button(self.tr("Skip"), self.put_away)
        self.skip_button.setObjectName("flat")
        self.back_button = self._button(self.tr("Back"), lambda: self.show_step(self._at - 1))
        self.next_button = self._button("", self._go_on)
        self.next_button.setObjectName("primary")
        buttons = QHBoxLayout()
        for button in (self.skip_button, self.back_button, self.next_button):
            buttons.addWidget(button)
        buttons.insertStretch(1)
        layout = self._layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 12, 16, 14)
        layout.setSpacing(7)
        for widget in (self.count, self.title, self.text):
            layout.addWidget(widget)
        layout.addLayout(buttons)
        self.setFixedWidth(_WIDTH)
        self.hide()
        over.window().installEventFilter(self)
        over.installEventFilter(self)

    def _button(self, text: str, do: Callable[[], object]) -> QPushButton:
        button = QPushButton(text, self)
        button.clicked.connect(lambda _on=False: do())
        return button

    @property
    def step(self) -> int:
        """Number of the card shown, from 0."""
        return self._at

    def begin(self, step: int = 0) -> None:
        """Show a card, the first one if none is said, and give it the keyboard."""
        self.show_step(step)
        self.next_button.setFocus()

    def show_step(self, number: int) -> None:
        """Show a card."""
        self._at = min(max(number, 0), len(self._steps) - 1)
        step, last = self._steps[self._at], self._at == len(self._steps) - 1
        self.count.setText(self.tr("{n} of {all}").format(n=self._at + 1, all=len(self._steps)))
        self.title.setText(step.title)
        self.text.setText(step.text)
        self.next_button.setText(self.tr("Done") if last else self.tr("Next"))
        self.back_button.setVisible(self._at > 0)
        self.skip_button.setVisible(not last)
        self.setAccessibleDescription(f"{self.count.text()}. {step.title}. {step.text}")
        self.show()
        self.raise_()
        self._place()

    def _go_on(self) -> None:
        if self._at + 1 < len(self._steps):
            self.show_step(self._at + 1)
        else:
            self.put_away()

    def put_away(self) -> None:
        """Close the guide; the keyboard goes to the form."""
        if self.isHidden():
            return
        focused = QApplication.focusWidget()
        had_focus = focused is not None and self.isAncestorOf(focused)
        self.hide()
        if had_focus:
            self._steps[0].beside.setFocus()
        self.closed.emit()

    def _place(self) -> None:
        """Stand beside what the card speaks of, within the chart."""
        window, step = self.window(), self._steps[self._at]
        self._layout.activate()
        self.resize(self.width(), self._layout.totalHeightForWidth(_WIDTH))
        room = QRect(self._over.mapTo(window, QPoint(0, 0)), self._over.size())
        room.adjust(_GAP, _GAP, -_GAP, -_GAP)
        target = QRect(step.beside.mapTo(window, QPoint(0, 0)), step.beside.size())
        y = target.center().y() - self.height() // 2
        x = target.right() + _GAP if target.right() < room.right() - self.width() else target.left()
        x = min(max(x, room.left()), max(room.right() - self.width(), 0))
        y = min(max(y, room.top()), max(room.bottom() - self.height(), 0))
        self.move(x, y)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Stay in place as the window changes; hear an Esc that nobody else wanted."""
        if self.isHidden():
            return False
        if event.type() in {QEvent.Type.Resize, QEvent.Type.LayoutRequest}:
            self._place()
        pressed = event.type() == QEvent.Type.KeyPress and watched is self.window()
        if pressed and isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape:
            self.put_away()
            return True
        return bool(super().eventFilter(watched, event))
