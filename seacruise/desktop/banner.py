"""A message in a frame: what was wrong, what to do, and a button that does it."""

from __future__ import annotations

import re
from typing import Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAccessible, QAccessibleEvent, QShowEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from seacruise.desktop.language import sentence
from seacruise.desktop.messages import Message, WayOut, way_out_text
from seacruise.desktop.style import scaled_font

_FIRST_SENTENCE: Final = re.compile(r".+?[^\d\s][.!?](?=\s+[^\W\d_a-ząćęłńóśźż])", re.DOTALL)


def text_label(text: str = "", name: str = "", parent: QWidget | None = None) -> QLabel:
    """Label that wraps and can be read out and copied."""
    label = QLabel(text, parent)
    label.setObjectName(name)
    label.setWordWrap(True)
    label.setTextFormat(Qt.TextFormat.PlainText)
    return label


def first_sentence(text: str) -> str:
    """Cut a text after its first sentence; the rest, mostly a reason, is told where there is room for it."""
    first = _FIRST_SENTENCE.match(text)
    return first[0] if first else text


def breakable(text: str) -> str:
    """Let words that are longer than a line of a column, as paths are, be broken; invisibly."""
    return re.sub(r"\S{36,}", lambda word: re.sub(r"([/\\]|[^/\\]{30})(?!$)", "\\1\u200b", word[0]), text)


class Banner(QFrame):
    """Shows one message; ``way_out_chosen(way_out)`` when its button is pressed."""

    way_out_chosen = Signal(object)

    def __init__(self, message: Message, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("banner")
        self.setProperty("kind", message.kind)
        self.message = message
        layout = QVBoxLayout(self)
        layout.setContentsMargins(12, 9, 12, 10)
        layout.setSpacing(4)
        self._labels: list[QLabel] = []
        for number, text in enumerate(_texts(message)):
            label = text_label(breakable(text), parent=self)
            if number or not message.title:
                label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
            else:
                label.setFont(scaled_font(self.font(), 1.0, bold=True))
            layout.addWidget(label)
            self._labels.append(label)
        self.buttons = [self._button(way) for way in (message.way_out, message.other) if way.value]
        row = QHBoxLayout()
        row.setContentsMargins(0, 4, 0, 0)
        for button in self.buttons:
            row.addWidget(button)
        row.addStretch()
        if self.buttons:
            layout.addLayout(row)
        self._name()

    @property
    def button(self) -> QPushButton | None:
        """The button of the first way out."""
        return self.buttons[0] if self.buttons else None

    def _button(self, way_out: WayOut) -> QPushButton:
        button = QPushButton(way_out_text(way_out), self)
        button.clicked.connect(lambda _on=False: self.way_out_chosen.emit(way_out))
        return button

    def showEvent(self, event: QShowEvent) -> None:
        """Have an error read out at once."""
        super().showEvent(event)
        if self.message.kind == "error" and QAccessible.isActive():
            QAccessible.updateAccessibility(QAccessibleEvent(self, QAccessible.Event.Alert))

    def say(self, message: Message) -> bool:
        """Say something else in the same form; False, and nothing is changed, when its form is another."""
        if _form(message) != _form(self.message):
            return False
        self.message = message
        for label, text in zip(self._labels, _texts(message), strict=True):
            if label.text() != breakable(text):
                label.setText(breakable(text))
        self._name()
        return True

    def take_down(self) -> None:
        """Vanish for good; its layout forgets it when it is freed."""
        self.hide()
        self.deleteLater()

    def _name(self) -> None:
        whole = sentence(self.message.sentence)
        told = (self.message.title, whole, self.message.advice)
        self.setAccessibleName(" ".join(filter(None, told)))
        self.setToolTip(whole if self.message.brief else "")


def _texts(message: Message) -> list[str]:
    whole = sentence(message.sentence)
    if message.brief:
        return [message.title or first_sentence(whole)]
    return [text for text in (message.title, whole, message.advice) if text]


def _form(message: Message) -> tuple[object, ...]:
    return (
        message.kind,
        message.brief,
        message.way_out,
        message.other,
        bool(message.title),
        bool(message.sentence),
        bool(message.advice),
    )
