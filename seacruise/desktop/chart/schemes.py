"""What the route's colours may mean: wind, angle to it, boat speed, or point of sail."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QColor

from seacruise.desktop.chart.palette import WIND_COLOURS, WIND_LIMITS_KN, class_name
from seacruise.desktop.units_choice import wind_unit, wind_value
from seacruise.phrases import POINT_LIMITS_DEG

if TYPE_CHECKING:
    from seacruise.passage import Track

# Samples of matplotlib's viridis; as plasma, it lightens evenly.
_SPEED_COLOURS: Final = tuple(
    QColor(name) for name in ("#440154", "#443A83", "#31688E", "#21908C", "#35B779", "#8FD744", "#FDE725")
)
_SPEED_LIMITS_KN: Final = (2.0, 4.0, 5.0, 6.0, 7.0, 8.0)

# Samples of matplotlib's cividis, which looks the same to all kinds of colour vision.
_ANGLE_COLOURS: Final = tuple(
    QColor(name) for name in ("#00224E", "#35456C", "#666970", "#948E77", "#C8B866", "#FEE838")
)
_ANGLE_LIMITS_DEG: Final = (45.0, 60.0, 90.0, 120.0, 150.0)

# Okabe & Ito's colours: told apart with any kind of colour vision (jfly.uni-koeln.de/color).
_POINT_COLOURS: Final = tuple(
    QColor(name) for name in ("#0072B2", "#56B4E9", "#009E73", "#F0E442", "#E69F00", "#9A9A9A")
)
_ENGINE: Final = 5


@dataclass(frozen=True, slots=True)
class Scheme:
    """One meaning of the colours.

    Attributes
    ----------
    key
        Name in the window's memory.
    limits
        Where classes end, in the unit of the quantity.
    """

    key: str
    limits: tuple[float, ...]
    colours: tuple[QColor, ...]

    def classes(self, track: Track) -> NDArray[np.int64]:
        """Class of each sample of a track, an index of `colours`."""
        quantity = {"tws": track.tws_kn, "speed": track.boat_speed_kn}.get(self.key, track.twa_deg)
        found = np.searchsorted(self.limits, quantity, side="right")
        return np.where(track.motor, _ENGINE, found) if self.key == "point" else found

    def title(self) -> str:
        """Heading of the legend."""
        return {
            "tws": _tr("Wind on the route (TWS, {unit})").format(unit=wind_unit()),
            "twa": _tr("Angle to the wind (TWA, °)"),
            "speed": _tr("Boat speed (kn)"),
            "point": _tr("Point of sail"),
        }[self.key]

    def names(self) -> tuple[str, ...]:
        """Text under each colour of the legend."""
        if self.key == "point":
            return (_tr("close"), _tr("fetch"), _tr("beam"), _tr("broad"), _tr("run"), _tr("engine"))
        limits = tuple(map(wind_value, self.limits)) if self.key == "tws" else self.limits
        return tuple(class_name(limits, number) for number in range(len(self.colours)))


def _tr(text: str) -> str:
    return QCoreApplication.translate("legend", text)


SCHEMES: Final = {
    scheme.key: scheme
    for scheme in (
        Scheme("tws", WIND_LIMITS_KN, WIND_COLOURS),
        Scheme("twa", _ANGLE_LIMITS_DEG, _ANGLE_COLOURS),
        Scheme("speed", _SPEED_LIMITS_KN, _SPEED_COLOURS),
        Scheme("point", POINT_LIMITS_DEG, _POINT_COLOURS),
    )
}
