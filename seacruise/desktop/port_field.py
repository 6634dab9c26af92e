"""A field for a port: type-ahead over all ports, with or without diacritics, or a position."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QStringListModel, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QCompleter, QLineEdit, QListView, QWidget

from seacruise.errors import InputError
from seacruise.ports import Port, find_port, search_ports

_OFFERED = 12


def same_name(typed: str, name: str) -> bool:
    """Whether a name is typed to its end, in whatever spelling."""
    return len(typed.strip()) >= len(name)


class PortField(QLineEdit):
    """Line edit that knows the ports; ``port_changed()`` when it names another one, or none."""

    port_changed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._ports: Sequence[Port] = ()
        self._port: Port | None = None
        self._model = QStringListModel(self)
        self._completer = QCompleter(self._model, self)
        # The search ranks by itself (word beginnings, other spellings); Qt's own filter would drop them.
        self._completer.setCompletionMode(QCompleter.CompletionMode.UnfilteredPopupCompletion)
        self._completer.setMaxVisibleItems(_OFFERED)
        self.popup = QListView(self)
        self.popup.setObjectName("completions")
        self._completer.setPopup(self.popup)
        # Not setCompleter(): the line edit would open the popup again after it was decided to close it.
        self._completer.setWidget(self)
        self._completer.activated.connect(self._take)
        self.setClearButtonEnabled(True)
        self.textEdited.connect(self._offer)
        self.textChanged.connect(self._resolve)
        self.editingFinished.connect(self._complete_name)

    def set_ports(self, ports: Sequence[Port]) -> None:
        """Take the ports over; what was typed meanwhile is looked up again."""
        self._ports = ports
        self._resolve()

    @property
    def offered(self) -> list[str]:
        """Names that are offered for what is typed, best first."""
        return self._model.stringList()

    @property
    def port(self) -> Port | None:
        """The port that is named, or ``None`` while the text names none, or more than one."""
        return self._port

    def require_port(self) -> Port:
        """Find the port that is named.

        Raises
        ------
        InputError
            What is wrong with the text, and which ports come close.
        """
        return self._port or find_port(self.text(), self._ports)

    def set_position(self, lat: float, lon: float) -> None:
        """Name a position instead of a port [degrees]."""
        self.setText(f"{lat:.4f}, {lon:.4f}")
        self._complete_name()

    def mark_wrong(self, *, wrong: bool) -> None:
        """Frame the field in red, or not."""
        if bool(self.property("wrong")) != wrong:
            self.setProperty("wrong", wrong)
            self.style().unpolish(self)
            self.style().polish(self)

    def _offer(self, text: str) -> None:
        self._resolve()
        names = [port.name for port in search_ports(text, self._ports, _OFFERED)] if text.strip() else []
        self._model.setStringList(names)
        # An open popup takes the next click for itself; it must go once nothing is left to choose.
        port = self._port
        decided = port is not None and names == [port.name] and same_name(text, port.name)
        if names and not decided:
            self._completer.complete()
            return
        self.popup.hide()
        if decided:
            self._complete_name()

    def _take(self, name: str) -> None:
        self.setText(name)
        self.setCursorPosition(0)

    def _resolve(self) -> None:
        self.mark_wrong(wrong=False)
        try:
            port = find_port(self.text(), self._ports) if self.text().strip() and self._ports else None
        except InputError:
            port = None
        if port != self._port:
            self._port = port
            self.setToolTip(f"{port.name} {port.country}".strip() if port else "")
            self.port_changed.emit()

    def _complete_name(self) -> None:
        """Write the native spelling out when the sailor leaves the field."""
        if self.popup.isVisible():
            return
        if self._port is not None and self.text() != self._port.name:
            self.setText(self._port.name)
        elif self._port is None and self.text().strip() and self._ports:
            self.mark_wrong(wrong=True)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Ctrl+Return is the window's, not the field's."""
        if event.key() in {Qt.Key.Key_Return, Qt.Key.Key_Enter} and event.modifiers():
            event.ignore()
            return
        super().keyPressEvent(event)
