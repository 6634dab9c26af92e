"""A message in a frame: what was wrong, what to do, and a button that does it."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from seacruise.desktop.messages import Message, WayOut, way_out_text
from seacruise.desktop.style import scaled_font


def text_label(text: str = "", name: str = "", parent: QWidget | None = None) -> QLabel:
    """Label that wraps and can be read out and copied."""
    label = QLabel(text, parent)
    label.setObjectName(name)
    label.setWordWrap(True)
    label.setTextFormat(Qt.TextFormat.PlainText)
    return label


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
            label = text_label(text, parent=self)
            if number or not message.title:
                label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
            else:
                label.setFont(scaled_font(self.font(), 1.0, bold=True))
            layout.addWidget(label)
            self._labels.append(label)
        self.button: QPushButton | None = None
        if message.way_out is not WayOut.NOTHING:
            self.button = QPushButton(way_out_text(message.way_out), self)
            self.button.clicked.connect(lambda: self.way_out_chosen.emit(message.way_out))
            row = QHBoxLayout()
            row.setContentsMargins(0, 4, 0, 0)
            row.addWidget(self.button)
            row.addStretch()
            layout.addLayout(row)
        self._name()

    def say(self, message: Message) -> bool:
        """Say something else in the same form; False, and nothing is changed, when its form is another."""
        if _form(message) != _form(self.message):
            return False
        self.message = message
        for label, text in zip(self._labels, _texts(message), strict=True):
            if label.text() != text:
                label.setText(text)
        self._name()
        return True

    def _name(self) -> None:
        self.setAccessibleName(" ".join(_texts(self.message)))


def _texts(message: Message) -> list[str]:
    return [text for text in (message.title, message.sentence, message.advice) if text]


def _form(message: Message) -> tuple[object, ...]:
    return message.kind, message.way_out, bool(message.title), bool(message.sentence), bool(message.advice)
