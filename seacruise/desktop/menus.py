"""The menus: every command of the window with its key."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QObject
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu

Command = Callable[[], object]


@dataclass(frozen=True, slots=True)
class Commands:
    """What the menus call."""

    save_gpx: Command
    save_csv: Command
    save_png: Command
    quit: Command
    show_layers: Command
    zoom_in: Command
    zoom_out: Command
    fit: Command
    calculate: Command
    cancel: Command
    swap: Command
    about: Command


class Menus(QObject):
    """Menu bar of a window.

    Attributes
    ----------
    exports
        Actions that need a passage.
    cancel
        Enabled while a calculation runs; else Esc is for whoever has the focus.
    layers
        Switches of the layers ``wind``, ``ports``, ``lattice`` and of the table ``legs``.
    """

    def __init__(self, window: QMainWindow, commands: Commands) -> None:
        super().__init__(window)
        bar = window.menuBar()
        file_menu, view_menu = bar.addMenu(self.tr("&File")), bar.addMenu(self.tr("&View"))
        passage_menu, help_menu = bar.addMenu(self.tr("&Passage")), bar.addMenu(self.tr("&Help"))
        self.exports = [
            _action(file_menu, self.tr("Save route as &GPX…"), commands.save_gpx, "Ctrl+S"),
            _action(file_menu, self.tr("Save legs as &CSV…"), commands.save_csv),
            _action(file_menu, self.tr("Save chart as &PNG…"), commands.save_png),
        ]
        file_menu.addSeparator()
        _action(file_menu, self.tr("&Quit"), commands.quit, "Ctrl+Q")
        show = commands.show_layers
        self.layers = {
            "wind": _switch(view_menu, self.tr("&Wind barbs"), show, "Ctrl+Shift+W", on=True),
            "ports": _switch(view_menu, self.tr("&Ports"), show, "Ctrl+Shift+P", on=True),
            "lattice": _switch(view_menu, self.tr("&Lattice"), show, "Ctrl+Shift+L", on=False),
            "legs": _switch(view_menu, self.tr("Table of l&egs"), show, "Ctrl+Shift+T", on=True),
        }
        view_menu.addSeparator()
        _action(view_menu, self.tr("Zoom &in"), commands.zoom_in, "Ctrl++")
        _action(view_menu, self.tr("Zoom &out"), commands.zoom_out, "Ctrl+-")
        _action(view_menu, self.tr("Whole pa&ssage"), commands.fit, "Ctrl+0")
        _action(passage_menu, self.tr("&Calculate"), commands.calculate, "Ctrl+Return", "Ctrl+Enter")
        self.cancel = _action(passage_menu, self.tr("Ca&ncel"), commands.cancel, "Esc")
        _action(passage_menu, self.tr("&Swap start and end"), commands.swap, "Ctrl+R")
        _action(help_menu, self.tr("&About SeaCruise"), commands.about, "F1")


def _action(menu: QMenu, text: str, command: Command, *keys: str) -> QAction:
    action = menu.addAction(text)
    action.setShortcuts([QKeySequence(key) for key in keys])
    action.triggered.connect(lambda _checked=False: command())
    return action


def _switch(menu: QMenu, text: str, command: Command, key: str, *, on: bool) -> QAction:
    action = menu.addAction(text)
    action.setCheckable(True)
    action.setChecked(on)
    action.setShortcut(QKeySequence(key))
    action.toggled.connect(lambda _checked: command())
    return action
