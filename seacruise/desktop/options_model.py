"""How she is sailed: one set of options that all its fields show, with words for what is not usual."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Any, Final

from PySide6.QtCore import QCoreApplication, QObject, Signal

from seacruise.desktop.language import fill
from seacruise.desktop.units_choice import distance_text, height_text, wind_text
from seacruise.errors import InputError
from seacruise.model import Options

NAMES: Final = tuple(field.name for field in fields(Options) if field.name != "corridor")
"""What a sailor may set; the corridor is left out by the window itself while something is dragged."""
DEFAULTS: Final = Options()

OFFERED: Final = (
    "percent_of_polar",
    "percent_at_night",
    "sea_state_percent",
    "max_wind_kn",
    "max_gust_kn",
    "max_wave_m",
    "shore_clearance_nm",
    "may_wait_h",
    "motor_below_kn",
    "motor_speed_kn",
    "fuel_rate_l_h",
    "tacking",
    "tack_penalty_min",
    "gybe_penalty_min",
    "board_h",
    "most_turns",
    "preset",
    "beyond",
    "currents",
)
"""What the window has fields for, and remembers; the rest is the command line's."""


class OptionsModel(QObject):
    """The options; ``changed()`` whenever they are others, ``learned()`` when more is known of the wind.

    What the command line gave is kept as it was given, also where no field shows it.

    Attributes
    ----------
    has_current
        Whether the wind at hand comes with a current; ``None`` while that is not known.
    """

    changed = Signal()
    learned = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.options = DEFAULTS
        self.has_current: bool | None = None

    def learn_current(self, has: bool | None) -> None:
        """Take note of whether the wind at hand comes with a current."""
        if has is not self.has_current:
            self.has_current = has
            self.learned.emit()

    def put(self, values: Mapping[str, Any]) -> None:
        """Set options by their names; others of the mapping are passed over."""
        options = replace(self.options, **{name: values[name] for name in NAMES if name in values})
        if options != self.options:
            self.options = options
            self.changed.emit()

    def reset(self) -> None:
        """Go back to the defaults, all of them."""
        self.put({name: getattr(DEFAULTS, name) for name in NAMES})

    @property
    def is_default(self) -> bool:
        """Whether nothing differs from the defaults."""
        return self.options == DEFAULTS

    def contents(self) -> dict[str, object]:
        """Give what is worth keeping for the next start."""
        return {name: getattr(self.options, name) for name in OFFERED}

    def restore(self, kept: Mapping[str, Any]) -> None:
        """Set what `contents` gave, each by itself; what cannot be, as in a damaged file, is passed over."""
        from seacruise.model import check_options

        for name in OFFERED:
            if name not in kept or not _is_of_kind(kept[name], name):
                continue
            try:
                check_options(replace(DEFAULTS, **{name: kept[name]}))
            except InputError:
                continue
            self.put({name: kept[name]})

    def summary(self) -> str:
        """Say in a line what differs from the defaults; empty when nothing does."""
        return ", ".join(differences(self.options))


def _is_of_kind(value: object, name: str) -> bool:
    default = getattr(DEFAULTS, name)
    if isinstance(default, bool | str):
        return isinstance(value, type(default))
    if value is None:
        return default is None
    wanted = int if name == "most_turns" else (int, float)
    return isinstance(value, wanted) and not isinstance(value, bool)


def tr(text: str) -> str:
    """Translate a text of this module."""
    return QCoreApplication.translate("options", text)


def differences(options: Options) -> list[str]:
    """Say what differs from the defaults, also where only the command line can say it."""
    said = [_difference(name, getattr(options, name), options) for name in NAMES if _differs(name, options)]
    return [text for text in said if text]


def _differs(name: str, options: Options) -> bool:
    return bool(getattr(options, name) != getattr(DEFAULTS, name))


def _difference(name: str, value: Any, options: Options) -> str:
    """Words for one option that is not the default; empty when another one's words say it already."""
    if name in {"motor_speed_kn", "fuel_rate_l_h"} and options.motor_below_kn is None:
        return ""
    if name == "safety_levels":
        return ""
    if name == "most_turns":
        return tr("at most {n} tacks and gybes").format(n=value)
    texts = {
        "preset": tr("classic search"),
        "tacking": tr("no tacking"),
        "currents": tr("without currents"),
        "percent_of_polar": tr("{n:g} % of the polar"),
        "percent_at_night": tr("{n:g} % at night"),
        "sea_state_percent": tr("{n:g} % less for each metre of waves"),
        "motor_below_kn": tr("engine below {n:g} kn"),
        "motor_speed_kn": tr("{n:g} kn under engine"),
        "fuel_rate_l_h": tr("{n:g} l/h"),
        "max_wind_kn": tr("at most {wind} of wind"),
        "max_gust_kn": tr("gusts to {wind}"),
        "max_wave_m": tr("waves to {height}"),
        "shore_clearance_nm": tr("{distance} off the shore"),
        "tack_penalty_min": tr("{n:g} min a tack"),
        "gybe_penalty_min": tr("{n:g} min a gybe"),
        "board_h": tr("boards of {n:g} h"),
        "may_wait_h": tr("may wait {n:g} h"),
        "beyond": {"fade": tr("wind fades after the forecast"), "refuse": tr("ends with the forecast")}.get(
            str(value), ""
        ),
    }
    text = texts.get(name) or _of_the_command_line(name, value)
    if not isinstance(value, int | float) or isinstance(value, bool):
        return text
    decimals = 0 if float(value).is_integer() else 1
    return fill(
        text,
        n=float(value),
        wind=wind_text(value, decimals) if name in {"max_wind_kn", "max_gust_kn"} else "",
        height=height_text(value) if name == "max_wave_m" else "",
        distance=distance_text(value) if name == "shore_clearance_nm" else "",
    )


def _of_the_command_line(name: str, value: Any) -> str:
    """Name what only the command line can say, with its value."""
    words = {
        "directions": tr("directions"),
        "spacing_nm": tr("spacing [nm]"),
        "area": tr("area"),
        "refine": tr("refinement"),
        "lattice": tr("lattice"),
        "turn_penalty": tr("penalty for turning [min for 10°]"),
        "safety_radius_nm": tr("safety radius [nm]"),
    }
    values = {
        "True": tr("yes"),
        "False": tr("no"),
        "ellipse": tr("ellipse"),
        "rectangle": tr("rectangle"),
        "rectangular": tr("rectangular"),
    }
    return tr("{name} {value}").format(
        name=words.get(name, name), value=values.get(str(value), fill("{n}", n=value))
    )
