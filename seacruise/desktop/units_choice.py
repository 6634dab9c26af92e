"""In which units the window speaks: wind, distances, heights and times, as the sailor chose.

Everything is computed, kept and exported in SI, knots and UTC; only what the window shows is converted,
here and nowhere else. Barbs stay knots (WMO), and so does the speed of the boat, as on her log.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from datetime import UTC, datetime
from typing import Any, Final, Literal, get_args

from PySide6.QtCore import QCoreApplication, QDate, QLocale, QObject, Signal

from seacruise.units import BEAUFORT_KN, METRES_PER_NM, MS_PER_KNOT, beaufort

WindUnit = Literal["kn", "m/s", "Bft"]
DistanceUnit = Literal["nm", "km"]
HeightUnit = Literal["m", "ft"]
Clock = Literal["utc", "local"]

CHOICES: Final[dict[str, tuple[str, ...]]] = {
    "wind": get_args(WindUnit),
    "distance": get_args(DistanceUnit),
    "height": get_args(HeightUnit),
    "clock": get_args(Clock),
}
"""What can be chosen, by the fields of `Units`; the first of each is the default."""

METRES_PER_FOOT: Final = 0.3048


@dataclass(frozen=True, slots=True)
class Units:
    """Units of the window.

    Attributes
    ----------
    clock
        ``"utc"``, or ``"local"``: the time of the computer's zone, always told with its offset.
    """

    wind: WindUnit = "kn"
    distance: DistanceUnit = "nm"
    height: HeightUnit = "m"
    clock: Clock = "utc"


class UnitsChoice(QObject):
    """The units of this program; ``changed()`` when the sailor chose others."""

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.units = Units()

    def choose(self, **units: str) -> None:
        """Choose units by the fields of `Units`; what cannot be chosen is passed over."""
        fit = {name: unit for name, unit in units.items() if unit in CHOICES.get(name, ())}
        chosen = replace(self.units, **fit)  # type: ignore[arg-type]
        if chosen != self.units:
            self.units = chosen
            self.changed.emit()

    def contents(self) -> dict[str, object]:
        """Give what is worth keeping for the next start."""
        return dict(asdict(self.units))

    def restore(self, kept: Mapping[str, Any]) -> None:
        """Choose what `contents` gave."""
        self.choose(**{name: unit for name, unit in kept.items() if isinstance(unit, str)})


_kept: list[UnitsChoice] = []


def units_choice() -> UnitsChoice:
    """Give the one choice of this program."""
    if not _kept:
        _kept.append(UnitsChoice())
    return _kept[0]


def tr(text: str) -> str:
    """Translate a text of this module."""
    return QCoreApplication.translate("units", text)


# --- wind ------------------------------------------------------------------------------------------------


def wind_unit() -> str:
    """Name the unit of the wind, for heads of columns and legends: ``kn``, ``m/s`` or ``Bft``."""
    return {"kn": tr("kn"), "m/s": tr("m/s"), "Bft": tr("Bft")}[units_choice().units.wind]


def wind_value(speed_kn: float) -> float:
    """Speed of the wind [kn] in the chosen unit."""
    unit = units_choice().units.wind
    if unit == "m/s":
        return speed_kn * MS_PER_KNOT
    return float(beaufort(speed_kn)) if unit == "Bft" else speed_kn


def wind_number(speed_kn: float, decimals: int = 0) -> str:
    """Speed of the wind [kn] as a figure without its unit; a force is a whole one."""
    return _figure(wind_value(speed_kn), 0 if units_choice().units.wind == "Bft" else decimals)


def wind_text(speed_kn: float, decimals: int = 0) -> str:
    """Speed of the wind [kn] with its unit: ``14 kn``, ``7 m/s``, ``4 Bft``."""
    return f"{wind_number(speed_kn, decimals)} {wind_unit()}"


def wind_ticks(most_kn: float) -> list[tuple[float, str]]:
    """Places [kn] and figures for a scale of the wind from calm to a speed, in the chosen unit."""
    unit = units_choice().units.wind
    if unit == "Bft":
        return [(float(BEAUFORT_KN[force - 1]), str(force)) for force in range(2, beaufort(most_kn) + 1, 2)]
    step, scale = (5, MS_PER_KNOT) if unit == "m/s" else (10, 1.0)
    return [(value / scale, str(value)) for value in range(0, round(most_kn * scale), step)]


# --- distances and heights -------------------------------------------------------------------------------


def distance_unit() -> str:
    """Name the unit of distances: ``nm`` or ``km``."""
    return tr("nm") if units_choice().units.distance == "nm" else tr("km")


def distance_value(miles: float) -> float:
    """Distance [nm] in the chosen unit."""
    return miles if units_choice().units.distance == "nm" else miles * METRES_PER_NM / 1000.0


def distance_number(miles: float, decimals: int = 1) -> str:
    """Distance [nm] as a figure without its unit."""
    return _figure(distance_value(miles), decimals)


def distance_text(miles: float, decimals: int = 1) -> str:
    """Distance [nm] with its unit: ``123.4 nm``, ``228.5 km``."""
    return f"{distance_number(miles, decimals)} {distance_unit()}"


def height_unit() -> str:
    """Name the unit of waves and depths: ``m`` or ``ft``."""
    return tr("m") if units_choice().units.height == "m" else tr("ft")


def height_value(metres: float) -> float:
    """Height or depth [m] in the chosen unit."""
    return metres if units_choice().units.height == "m" else metres / METRES_PER_FOOT


def height_text(metres: float, decimals: int = 1) -> str:
    """Height or depth [m] with its unit; feet are whole."""
    feet = units_choice().units.height == "ft"
    return f"{_figure(height_value(metres), 0 if feet else decimals)} {height_unit()}"


def _figure(value: float, decimals: int) -> str:
    locale = QLocale()
    locale.setNumberOptions(QLocale.NumberOption.OmitGroupSeparator)
    return locale.toString(float(value), "f", decimals)


# --- times -----------------------------------------------------------------------------------------------


def in_zone(moment: datetime) -> datetime:
    """Moment (timezone-aware) in the zone that times are shown in."""
    return moment.astimezone(UTC) if units_choice().units.clock == "utc" else moment.astimezone()


def from_zone(wall: datetime) -> datetime:
    """Moment in UTC of a time without a zone, as it is read off in the chosen one."""
    return wall.replace(tzinfo=UTC) if units_choice().units.clock == "utc" else wall.astimezone(UTC)


def zone_text(moment: datetime) -> str:
    """Name of the zone at a moment: ``UTC``, ``UTC+1``, ``UTC+5:30``."""
    offset = in_zone(moment).utcoffset()
    minutes = round(offset.total_seconds() / 60.0) if offset is not None else 0
    if not minutes:
        return tr("UTC")
    hours, rest = divmod(abs(minutes), 60)
    return tr("UTC") + f"{'+' if minutes > 0 else '-'}{hours}" + (f":{rest:02d}" if rest else "")


def clock_text(moment: datetime) -> str:
    """Hour and minute without the zone: ``06:00``."""
    return f"{in_zone(moment):%H:%M}"


def short_moment(moment: datetime) -> str:
    """Day and time for tables, without year and zone: ``20 Nov 06:00``."""
    local = in_zone(moment)
    return f"{QLocale().toString(QDate(local.year, local.month, local.day), 'd MMM')} {local:%H:%M}"


def week_moment(moment: datetime) -> str:
    """Weekday, day and time with their zone, without the year: ``Sun 20 Nov 06:00 UTC``."""
    local = in_zone(moment)
    day = QLocale().toString(QDate(local.year, local.month, local.day), "ddd d MMM")
    return f"{day} {local:%H:%M} {zone_text(moment)}"


def format_moment(moment: datetime) -> str:
    """Day and time as the sailor's locale writes them, without the zone: ``Sun 20 Nov 2016 06:00``."""
    local = in_zone(moment)
    day = QLocale().toString(QDate(local.year, local.month, local.day), "ddd d MMM yyyy")
    return f"{day} {local:%H:%M}"


def moment_text(moment: datetime) -> str:
    """Day and time with their zone: ``Sun 20 Nov 2016 06:00 UTC``, ``Sun 20 Nov 2016 07:00 UTC+1``."""
    return f"{format_moment(moment)} {zone_text(moment)}"
