"""A label for one line that may be longer than its room: it shows a shorter form, or the beginning."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QLabel, QStyle, QStyleOption, QWidget

_LEAST_PX = 40


class ElidedLabel(QLabel):
    """Label that never makes its window wider; what is cut off is in its tooltip, and is read out whole.

    Parameters
    ----------
    sample
        The label would like to be as wide as this text; as wide as its own where empty.
    """

    def __init__(self, parent: QWidget | None = None, *, sample: str = "") -> None:
        super().__init__(parent)
        self._briefs: tuple[str, ...] = ()
        self._sample = sample
        self.setTextFormat(Qt.TextFormat.PlainText)

    def say(self, text: str, *briefs: str) -> None:
        """Show a text, or the first of its shorter forms that there is room for."""
        self._briefs = tuple(filter(None, briefs))
        self.setText(text)
        self._explain()

    @property
    def shown(self) -> str:
        """What can be read of the text."""
        room, metrics = self.contentsRect().width(), self.fontMetrics()
        forms = (self.text(), *self._briefs)
        for text in forms:
            if metrics.horizontalAdvance(text) <= room:
                return text
        return metrics.elidedText(forms[-1], Qt.TextElideMode.ElideRight, room)

    def sizeHint(self) -> QSize:
        """As wide as the text, or as the sample."""
        hint = super().sizeHint()
        wide = self.fontMetrics().horizontalAdvance(self._sample) if self._sample else hint.width()
        return QSize(wide, hint.height())

    def minimumSizeHint(self) -> QSize:
        """Let it be narrow."""
        return QSize(min(_LEAST_PX, self.sizeHint().width()), super().minimumSizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Tell the whole of it in the tooltip when it is cut."""
        super().resizeEvent(event)
        self._explain()

    def _explain(self) -> None:
        whole = "" if self.shown == self.text() else self.text()
        if whole != self.toolTip():
            self.setToolTip(whole)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw what there is room for."""
        del event
        painter = QPainter(self)
        option = QStyleOption()
        option.initFrom(self)
        self.style().drawPrimitive(QStyle.PrimitiveElement.PE_Widget, option, painter, self)
        painter.setPen(option.palette.color(self.foregroundRole()))
        painter.setFont(self.font())
        painter.drawText(self.contentsRect(), self.alignment() | Qt.TextFlag.TextSingleLine, self.shown)
        painter.end()
