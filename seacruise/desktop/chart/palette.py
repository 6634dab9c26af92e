"""Colours of the chart, after the day palette of IHO S-52: pale water, buff land, magenta for the route."""

from __future__ import annotations

from bisect import bisect_right
from typing import Final

from PySide6.QtGui import QColor

WATER: Final = QColor("#E4F1F8")
LAND: Final = QColor("#EFE2BD")
SHORE: Final = QColor("#9C8552")
UNCHARTED: Final = QColor("#E3E8EC")
UNCHARTED_HATCH: Final = QColor("#CBD5DC")
GRATICULE: Final = QColor(60, 105, 140, 52)
GRATICULE_TEXT: Final = QColor("#4A6A83")
LATTICE: Final = QColor(18, 92, 138, 60)
BARB: Final = QColor("#2C4A63")
PORT: Final = QColor("#14304A")
HALO: Final = QColor(255, 255, 255, 225)
MAGENTA: Final = QColor("#B0157A")
CASING: Final = QColor("#FFFFFF")
TROUBLE: Final = QColor("#B3261E")

WIND_LIMITS_KN: Final = (5.0, 10.0, 15.0, 20.0, 25.0, 30.0)
"""Where one colour of the route ends and the next begins, true wind speed [kn]."""

WIND_COLOURS: Final = tuple(
    QColor(name) for name in ("#F7D13D", "#FCA636", "#EE7B51", "#D5536F", "#A82296", "#6A00A8", "#26066E")
)
"""From calm to gale. Samples of matplotlib's plasma, darkening evenly, so that they are told apart by
their lightness alone (Nuñez et al. 2018, doi:10.1371/journal.pone.0199239)."""


def wind_class(tws_kn: float) -> int:
    """Give the number of the colour for a true wind speed [kn]."""
    return bisect_right(WIND_LIMITS_KN, tws_kn)


def wind_class_name(number: int) -> str:
    """Span of a colour, for the legend."""
    if number == 0:
        return f"< {WIND_LIMITS_KN[0]:.0f}"
    if number == len(WIND_LIMITS_KN):
        return f"> {WIND_LIMITS_KN[-1]:.0f}"
    return f"{WIND_LIMITS_KN[number - 1]:.0f}–{WIND_LIMITS_KN[number]:.0f}"
