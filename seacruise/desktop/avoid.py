"""Areas that the sailor marks on the chart to keep out of, and takes back."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Final

import numpy as np
from PySide6.QtCore import QCoreApplication, QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from seacruise.desktop.chart.context import RADII_NM
from seacruise.desktop.language import fill
from seacruise.geodesy import destination
from seacruise.sea.zones import Zone
from seacruise.units import METRES_PER_NM

STEPS: Final = 200
"""Steps that can be taken back; older ones are forgotten."""

_CORNERS: Final = 48


def circle(lat: float, lon: float, radius_nm: float, name: str) -> Zone:
    """Zone around a position [degrees]; its polygon touches the circle from outside."""
    courses = np.linspace(0.0, 360.0, _CORNERS + 1)
    far = radius_nm * METRES_PER_NM / math.cos(math.pi / _CORNERS)
    ring_lat, ring_lon = destination(lat, lon, courses, far)
    ring = np.stack([ring_lon, ring_lat], axis=1)
    ring[-1] = ring[0]
    return Zone(name, (ring,))


def _tr(text: str) -> str:
    return QCoreApplication.translate("Avoided", text)


def area_name(radius_nm: float) -> str:
    """Name an area around a position."""
    return fill(_tr("{radius:g} nm to avoid"), radius=radius_nm)


def area_names() -> tuple[str, ...]:
    """Name the areas that are offered, in the language of the window."""
    return tuple(area_name(float(radius)) for radius in RADII_NM)


class Avoided(QObject):
    """The areas marked in this window; ``changed()`` after each change, undone ones included."""

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.stack = QUndoStack(self)
        self.stack.setUndoLimit(STEPS)
        self._zones: tuple[Zone, ...] = ()

    @property
    def zones(self) -> tuple[Zone, ...]:
        """The areas, oldest first."""
        return self._zones

    def add(self, lat: float, lon: float, radius_nm: float) -> None:
        """Keep clear of a position [degrees]."""
        self._change((*self._zones, circle(lat, lon, radius_nm, area_name(radius_nm))))

    def remove(self, zone: Zone) -> None:
        """No longer keep clear of an area."""
        self._change(tuple(other for other in self._zones if other is not zone))

    def _change(self, after: tuple[Zone, ...]) -> None:
        self.stack.push(Change(self, self._zones, after))

    def put(self, zones: tuple[Zone, ...]) -> None:
        """Have these areas and no others; not to be undone."""
        self._zones = zones
        self.changed.emit()


class Renamed:
    """Gives areas the names that they have in another language; the same area is the same again.

    Parameters
    ----------
    names
        New ones by old ones; an area of another name keeps its own.
    """

    def __init__(self, names: Mapping[str, str]) -> None:
        self._names = names
        self._made: dict[Zone, Zone] = {}

    def __call__(self, zones: tuple[Zone, ...]) -> tuple[Zone, ...]:
        """Rename some areas."""
        return tuple(self._one(zone) for zone in zones)

    def _one(self, zone: Zone) -> Zone:
        if zone.name not in self._names:
            return zone
        return self._made.setdefault(zone, replace(zone, name=self._names[zone.name]))


class Change(QUndoCommand):
    """From some areas to others."""

    def __init__(self, avoided: Avoided, before: tuple[Zone, ...], after: tuple[Zone, ...]) -> None:
        super().__init__(_tr("avoiding an area") if len(after) > len(before) else _tr("opening an area"))
        self._avoided, self._before, self._after = avoided, before, after

    def again(self, avoided: Avoided, renamed: Renamed) -> Change:
        """Give the same change for another window, named in its language."""
        return Change(avoided, renamed(self._before), renamed(self._after))

    def redo(self) -> None:
        """Make the change."""
        self._avoided.put(self._after)

    def undo(self) -> None:
        """Take it back."""
        self._avoided.put(self._before)
