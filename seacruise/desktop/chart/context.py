"""The menu of a place on the chart."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, QPoint, Qt
from PySide6.QtWidgets import QMenu

from seacruise.geodesy import format_position

if TYPE_CHECKING:
    from seacruise.desktop.chart.view import ChartView

RADII_NM: Final = (1, 2, 5, 10, 20)
"""Radii of an area to avoid that are offered [nm]."""


def open_menu(view: ChartView, lat: float, lon: float, at: QPoint) -> QMenu:
    """Open the menu of a position [degrees] at a point of the screen."""
    menu = QMenu(view)
    # A heading of its own: what a section is called is not drawn where there is a style sheet.
    menu.addAction(format_position(lat, lon)).setEnabled(False)
    menu.addSeparator()
    for text, which in (
        (_tr("Sail &from here"), "from"),
        (_tr("Sail &to here"), "to"),
        (_tr("Sail &via here"), "via"),
    ):
        _add(menu, text, partial(view.end_picked.emit, which, lat, lon))
    if view.ports.has_via:
        _add(menu, _tr("Sail &direct again"), view.via_dropped.emit)
    for way in view.others.ways if view.others.isVisible() else ():
        _add(menu, _tr("Sail {way}").format(way=way.text), partial(view.way_picked.emit, way))
    if view.members.bundle is not None:
        from seacruise.desktop.members import spread_text

        text = _tr("In {n} members: {hours}").format(
            n=len(view.members.bundle.members), hours=spread_text(view.members.bundle.duration_h)
        )
        menu.addAction(text).setEnabled(False)
    menu.addSeparator()
    avoid = menu.addMenu(_tr("&Avoid this area"))
    for radius in RADII_NM:
        text = _tr("{radius} nm around").format(radius=radius)
        _add(avoid, text, partial(view.avoid_picked.emit, lat, lon, float(radius)))
    for zone in view.zones.zones_at(lat, lon):
        if zone in view.removable:
            text = _tr("No longer avoid “{name}”").format(name=zone.name)
            _add(menu, text, partial(view.avoid_dropped.emit, zone))
    menu.addSeparator()
    _add(menu, _tr("&Measure from here"), lambda: view.measure_from(lat, lon))
    menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    menu.popup(at)
    return menu


def _add(menu: QMenu, text: str, command: Callable[[], None]) -> None:
    menu.addAction(text).triggered.connect(lambda _checked=False: command())


def _tr(text: str) -> str:
    return QCoreApplication.translate("chart", text)
