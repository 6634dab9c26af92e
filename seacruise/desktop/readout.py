"""What the chart says about a position: wind, distance, bearing; words only, without Qt's widgets."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication

from seacruise.desktop import units_choice as units
from seacruise.export.textform import format_course
from seacruise.geodesy import great_circle_m, rhumb_course_deg, rhumb_distance_m
from seacruise.units import METRES_PER_NM, MS_PER_KNOT

if TYPE_CHECKING:
    from seacruise.weather.wind import Wind


def wind_text(wind: Wind, time: float, lat: float, lon: float) -> str:
    """Direction and speed of the wind at a time [s since 1970] and place [degrees]; empty off its grid."""
    from seacruise.weather.wind import to_direction

    if not bool(wind.covers(lat, lon)):
        return ""
    speed, direction = to_direction(*wind.at(time, lat, lon))
    return _tr("wind {twd} {tws}").format(
        twd=format_course(float(direction)), tws=units.wind_text(float(speed) / MS_PER_KNOT)
    )


def bearing_text(lat1: float, lon1: float, lat2: float, lon2: float) -> str:
    """Rhumb line from one position to another: ``123.4 nm 045°``."""
    miles = float(rhumb_distance_m(lat1, lon1, lat2, lon2)) / METRES_PER_NM
    course = format_course(float(rhumb_course_deg(lat1, lon1, lat2, lon2)))
    return f"{units.distance_text(miles)} {course}"


def from_start_text(name: str, start: tuple[float, float], lat: float, lon: float) -> str:
    """Distance and bearing of a position from the start; empty at the start itself."""
    if float(great_circle_m(*start, lat, lon)) < 1.0:
        return ""
    return _tr("{bearing} from {name}").format(bearing=bearing_text(*start, lat, lon), name=name)


def _tr(text: str) -> str:
    return QCoreApplication.translate("readout", text)
