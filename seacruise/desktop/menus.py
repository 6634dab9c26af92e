"""The menus: every command of the window with its key."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from PySide6.QtCore import QObject
from PySide6.QtGui import QAction, QActionGroup, QKeySequence, QUndoStack
from PySide6.QtWidgets import QMainWindow, QMenu

from seacruise.desktop.undo import StepAction

Command = Callable[[], object]


@dataclass(frozen=True, slots=True)
class Commands:
    """What the menus call."""

    save: Command
    saved: Command
    weather: Command
    yachts: Command
    export: Callable[[str], object]
    quit: Command
    show_layers: Command
    zoom_in: Command
    zoom_out: Command
    fit: Command
    calculate: Command
    cancel: Command
    swap: Command
    options: Command
    steer: Command
    about: Command


class Menus(QObject):
    """Menu bar of a window.

    Attributes
    ----------
    exports
        Actions that need a passage.
    cancel
        Enabled while a calculation runs; else Esc is for whoever has the focus.
    live
        Whether changes are sailed at once.
    layers
        Switches of the chart's layers, of ``measure`` and of the table ``legs``.
    passage, help, recent, units, language, go_to, ways
        Menus that others add their entries to.
    """

    def __init__(self, window: QMainWindow, commands: Commands, undo: QUndoStack) -> None:
        super().__init__(window)
        bar = window.menuBar()
        file_menu, edit_menu = bar.addMenu(self.tr("&File")), bar.addMenu(self.tr("&Edit"))
        view_menu, passage_menu = bar.addMenu(self.tr("&View")), bar.addMenu(self.tr("&Passage"))
        self.passage = passage_menu
        self.help = help_menu = bar.addMenu(self.tr("&Help"))
        save = _action(file_menu, self.tr("Sa&ve this passage"), commands.save, "Ctrl+Shift+S")
        self.exports = [
            _action(file_menu, self.tr("Save route as &GPX…"), partial(commands.export, "gpx"), "Ctrl+S"),
            _action(file_menu, self.tr("Save legs as &CSV…"), partial(commands.export, "csv")),
            _action(file_menu, self.tr("Save chart as &PNG…"), partial(commands.export, "png")),
            _action(file_menu, self.tr("Save passage plan as P&DF…"), partial(commands.export, "pdf")),
            _action(file_menu, self.tr("Save as &KML…"), partial(commands.export, "kml")),
            _action(file_menu, self.tr("Save as Geo&JSON…"), partial(commands.export, "geojson")),
            save,
        ]
        file_menu.addSeparator()
        _action(file_menu, self.tr("Saved p&assages…"), commands.saved, "Ctrl+O")
        self.recent = file_menu.addMenu(self.tr("&Recent passages"))
        _action(file_menu, self.tr("&Weather…"), commands.weather, "F3")
        _action(file_menu, self.tr("&Yachts…"), commands.yachts, "F4")
        file_menu.addSeparator()
        _action(file_menu, self.tr("&Quit"), commands.quit, "Ctrl+Q")
        edit_menu.addActions([StepAction(undo, self, back=True), StepAction(undo, self, back=False)])
        self.layers = self._layers(view_menu, commands.show_layers)
        view_menu.setToolTipsVisible(True)
        self._groups = {
            "scheme": self._schemes(view_menu.addMenu(self.tr("&Colour the route by")), commands),
            "light": self._lights(view_menu.addMenu(self.tr("Li&ght")), commands),
        }
        self.units = view_menu.addMenu(self.tr("&Units"))
        self.language = view_menu.addMenu(self.tr("Langu&age"))
        self.go_to = view_menu.addMenu(self.tr("&Jump to"))
        view_menu.addSeparator()
        _action(view_menu, self.tr("Zoom &in"), commands.zoom_in, "Ctrl++")
        _action(view_menu, self.tr("Zoom &out"), commands.zoom_out, "Ctrl+-")
        _action(view_menu, self.tr("Whole pa&ssage"), commands.fit, "Ctrl+0")
        _action(passage_menu, self.tr("&Calculate"), commands.calculate, "Ctrl+Return", "Ctrl+Enter")
        self.cancel = _action(passage_menu, self.tr("Ca&ncel"), commands.cancel, "Esc")
        self.live = _switch(
            passage_menu, self.tr("&Follow changes at once"), commands.steer, "Ctrl+Shift+F", on=True
        )
        _action(passage_menu, self.tr("&Swap start and end"), commands.swap, "Ctrl+R")
        _action(passage_menu, self.tr("&How she is sailed…"), commands.options, "Ctrl+Shift+O")
        self.ways = passage_menu.addMenu(self.tr("Sail another wa&y"))
        _action(help_menu, self.tr("&About SeaCruise"), commands.about, "F1")

    def _layers(self, menu: QMenu, show: Command) -> dict[str, QAction]:
        return {
            "wind": _switch(menu, self.tr("&Wind barbs"), show, "Ctrl+Shift+W", on=True),
            "field": _switch(menu, self.tr("Wind as &field of colour"), show, "Ctrl+Shift+C", on=False),
            "depths": _switch(menu, self.tr("&Depth tint"), show, "Ctrl+Shift+D", on=True),
            "isochrones": _switch(menu, self.tr("Lines of e&qual time"), show, "Ctrl+Shift+I", on=False),
            "others": _switch(menu, self.tr("Othe&r ways"), show, "Ctrl+Shift+A", on=False),
            "turns": _switch(menu, self.tr("Fewer &turns"), show, "Ctrl+Shift+B", on=False),
            # Who chooses a forecast with members has asked for them; of any other they cost nothing.
            "members": _switch(menu, self.tr("Members of t&he forecast"), show, "Ctrl+Shift+E", on=True),
            "nights": _switch(menu, self.tr("Day and &night"), show, "Ctrl+Shift+N", on=True),
            "zones": _switch(menu, self.tr("&Zones to keep out of"), show, "Ctrl+Shift+X", on=True),
            "ports": _switch(menu, self.tr("&Ports"), show, "Ctrl+Shift+P", on=True),
            "lattice": _switch(menu, self.tr("&Lattice"), show, "Ctrl+Shift+L", on=False),
            "legs": _switch(menu, self.tr("L&egs, weather, log"), show, "Ctrl+Shift+T", on=True),
            "measure": _switch(menu, self.tr("&Measure"), show, "Ctrl+M", on=False),
        }

    def _schemes(self, menu: QMenu, commands: Commands) -> QActionGroup:
        return _choice(
            menu,
            {
                "tws": self.tr("&Wind speed (TWS)"),
                "twa": self.tr("&Angle to the wind (TWA)"),
                "speed": self.tr("&Boat speed"),
                "point": self.tr("&Point of sail"),
            },
            commands.show_layers,
        )

    def _lights(self, menu: QMenu, commands: Commands) -> QActionGroup:
        lights = {"day": self.tr("&Day"), "dusk": self.tr("D&usk"), "night": self.tr("&Night")}
        group = _choice(menu, lights, commands.show_layers)
        for number, action in enumerate(group.actions(), start=1):
            action.setShortcut(QKeySequence(f"Ctrl+{number}"))
        return group

    def offer_members(self, on: bool) -> None:
        """Let members of the forecast be switched on, or say why they cannot."""
        action = self.layers["members"]
        action.setEnabled(on)
        action.setText(
            self.tr("Members of t&he forecast") if on else self.tr("Members of t&he forecast (it has none)")
        )
        hint = "" if on else self.tr("Choose Open-Meteo's ensemble, or a file with members, as the forecast.")
        action.setToolTip(hint)
        action.setStatusTip(hint)

    def chosen(self, name: str) -> str:
        """Tell what is chosen of the ``"scheme"`` or the ``"light"``."""
        action = self._groups[name].checkedAction()
        return str(action.data())

    def choose(self, name: str, value: str) -> None:
        """Choose a scheme or a light, as a click does; an unknown one changes nothing."""
        for action in self._groups[name].actions():
            if action.data() == value and not action.isChecked():
                action.trigger()


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


def _choice(menu: QMenu, texts: dict[str, str], command: Command) -> QActionGroup:
    group = QActionGroup(menu)
    for key, text in texts.items():
        action = menu.addAction(text)
        action.setCheckable(True)
        action.setData(key)
        action.setChecked(not group.actions())
        group.addAction(action)
    group.triggered.connect(lambda _action: command())
    return group
