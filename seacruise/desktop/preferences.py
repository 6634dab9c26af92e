"""What the sailor prefers, in the menu: units of the window, and its language."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QMenu

from seacruise.desktop import language
from seacruise.desktop.units_choice import units_choice

if TYPE_CHECKING:
    from seacruise.desktop.memory import WindowMemory


class UnitsMenu(QObject):
    """A menu of units, four groups of which one each is chosen.

    Parameters
    ----------
    menu
        The entries are added to it.
    """

    def __init__(self, menu: QMenu, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._actions: dict[str, dict[str, QAction]] = {}
        for number, (name, texts) in enumerate(self._texts().items()):
            if number:
                menu.addSeparator()
            self._actions[name] = self._add(menu, name, texts)
        units_choice().changed.connect(self._show)
        self._show()

    def _texts(self) -> dict[str, dict[str, str]]:
        return {
            "wind": {
                "kn": self.tr("Wind in &knots"),
                "m/s": self.tr("Wind in metres a &second"),
                "Bft": self.tr("Wind in &Beaufort"),
            },
            "distance": {
                "nm": self.tr("Distances in &nautical miles"),
                "km": self.tr("Distances in k&ilometres"),
            },
            "height": {
                "m": self.tr("Waves and depths in &metres"),
                "ft": self.tr("Waves and depths in &feet"),
            },
            "clock": {
                "utc": self.tr("Times in &UTC"),
                "local": self.tr("Times of this &computer's zone, with the offset"),
            },
        }

    def _add(self, menu: QMenu, name: str, texts: dict[str, str]) -> dict[str, QAction]:
        group = QActionGroup(menu)
        actions = {}
        for unit, text in texts.items():
            action = actions[unit] = menu.addAction(text)
            action.setCheckable(True)
            action.setData(unit)
            group.addAction(action)
        group.triggered.connect(lambda action: units_choice().choose(**{name: action.data()}))
        return actions

    def _show(self) -> None:
        for name, actions in self._actions.items():
            actions[getattr(units_choice().units, name)].setChecked(True)


class LanguageMenu(QObject):
    """A menu of languages; ``chosen()`` when one was, and is kept.

    Parameters
    ----------
    menu
        The entries are added to it.
    memory
        Keeps the choice; without one there is nothing to choose.
    """

    chosen = Signal()

    def __init__(self, menu: QMenu, memory: WindowMemory | None, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._memory = memory
        group = QActionGroup(menu)
        present = language.chosen(memory)
        for number, (code, text) in enumerate(language.choices().items(), start=1):
            action = menu.addAction(f"&{number} {text}")
            action.setCheckable(True)
            action.setData(code)
            action.setChecked(code == present)
            group.addAction(action)
        menu.setEnabled(memory is not None)
        group.triggered.connect(self._choose)

    def _choose(self, action: QAction) -> None:
        if self._memory is not None:
            language.choose(self._memory, str(action.data()))
            self.chosen.emit()
