"""Areas that the sailor marks on the chart to keep out of, and takes back."""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

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
        name = fill(self.tr("{radius:g} nm to avoid"), radius=radius_nm)
        after = (*self._zones, circle(lat, lon, radius_nm, name))
        self.stack.push(_Change(self, after, self.tr("avoiding an area")))

    def remove(self, zone: Zone) -> None:
        """No longer keep clear of an area."""
        after = tuple(other for other in self._zones if other is not zone)
        self.stack.push(_Change(self, after, self.tr("opening an area")))

    def put(self, zones: tuple[Zone, ...]) -> None:
        """Have these areas and no others; not to be undone."""
        self._zones = zones
        self.changed.emit()


class _Change(QUndoCommand):
    """From some areas to others."""

    def __init__(self, avoided: Avoided, after: tuple[Zone, ...], text: str) -> None:
        super().__init__(text)
        self._avoided, self._before, self._after = avoided, avoided.zones, after

    def redo(self) -> None:
        """Make the change."""
        self._avoided.put(self._after)

    def undo(self) -> None:
        """Take it back."""
        self._avoided.put(self._before)
