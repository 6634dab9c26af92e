"""The fleet as a list with a search field above it."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QItemSelectionModel, QModelIndex, QStringListModel, Qt, Signal
from PySide6.QtGui import QKeyEvent, QResizeEvent
from PySide6.QtWidgets import QAbstractItemView, QLineEdit, QListView, QVBoxLayout, QWidget

from seacruise.desktop.pages.yacht_model import search_yachts


class SearchField(QLineEdit):
    """Line edit that hands the arrow keys on: ``stepped(rows)``; ``entered()`` with Return."""

    stepped = Signal(int)
    entered = Signal()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Move in the list with up and down, take with Return, clear with Esc."""
        steps = {Qt.Key.Key_Down: 1, Qt.Key.Key_Up: -1, Qt.Key.Key_PageDown: 8, Qt.Key.Key_PageUp: -8}
        if event.key() in steps:
            self.stepped.emit(steps[Qt.Key(event.key())])
        elif event.key() in {Qt.Key.Key_Return, Qt.Key.Key_Enter} and not event.modifiers():
            self.entered.emit()
        elif event.key() == Qt.Key.Key_Escape and self.text():
            self.clear()
        else:
            super().keyPressEvent(event)


class FleetList(QWidget):
    """Search field and list.

    Signals: ``looked_at(name)`` when another yacht is the current one, ``taken(name)`` when one is entered
    or clicked twice.
    """

    looked_at = Signal(str)
    taken = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._names: Sequence[str] = ()
        self._current = ""
        self.search = SearchField(self)
        self.search.setPlaceholderText(self.tr("Search the fleet"))
        self.search.setAccessibleName(self.tr("Search the fleet"))
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(self._filter)
        self.search.stepped.connect(self.step)
        self.search.entered.connect(self._take)
        self._model = QStringListModel(self)
        self.view = QListView(self)
        self.view.setModel(self._model)
        self.view.setObjectName("completions")
        self.view.setAccessibleName(self.tr("Yachts"))
        self.view.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.view.setUniformItemSizes(True)
        self.view.setTextElideMode(Qt.TextElideMode.ElideRight)
        self.view.selectionModel().currentChanged.connect(self._moved)
        self.view.activated.connect(self._take)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(6)
        layout.addWidget(self.search)
        layout.addWidget(self.view, 1)
        self.setFocusProxy(self.search)

    @property
    def shown(self) -> list[str]:
        """Names in the list."""
        return self._model.stringList()

    @property
    def current(self) -> str:
        """Name of the yacht that is looked at; empty when there is none."""
        return self._current

    def show_names(self, names: Sequence[str]) -> None:
        """Show a fleet; the current yacht stays so where she is still there."""
        self._names = tuple(names)
        if self._current not in self._names:
            self._current = ""
        self._filter()

    def choose(self, name: str) -> bool:
        """Look at a yacht; False when she is not in the fleet."""
        if name not in self._names:
            return False
        if name not in self.shown:
            self.search.clear()
        index = self._model.index(self.shown.index(name), 0)
        if name == self._current and self.view.currentIndex() == index:
            self.looked_at.emit(name)
        self.view.selectionModel().setCurrentIndex(index, QItemSelectionModel.SelectionFlag.ClearAndSelect)
        self.view.scrollTo(index)
        return True

    def step(self, rows: int) -> None:
        """Look at another yacht of the list."""
        if self.shown:
            at = self.view.currentIndex().row()
            self.choose(self.shown[min(max(at + rows, 0), len(self.shown) - 1)])

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep the current yacht in sight."""
        super().resizeEvent(event)
        self.view.scrollTo(self.view.currentIndex())

    def _filter(self) -> None:
        found = search_yachts(self.search.text(), self._names)
        # The current yacht may not be among those found: she is looked at none the less.
        self.view.selectionModel().blockSignals(True)
        self._model.setStringList(found)
        if self._current in found:
            index = self._model.index(found.index(self._current), 0)
            flags = QItemSelectionModel.SelectionFlag
            self.view.selectionModel().setCurrentIndex(index, flags.ClearAndSelect)
            self.view.scrollTo(index)
        self.view.selectionModel().blockSignals(False)
        self.view.viewport().update()

    def _moved(self, current: QModelIndex) -> None:
        if current.isValid() and current.data() != self._current:
            self._current = str(current.data())
            self.looked_at.emit(self._current)

    def _take(self) -> None:
        if self.search.hasFocus() and self.shown and self._current not in self.shown:
            self.choose(self.shown[0])
        if self._current:
            self.taken.emit(self._current)
