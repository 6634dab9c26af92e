"""Columns of the table of departures."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

from seacruise.desktop.pages.departures_model import Row
from seacruise.desktop.pages.rows import Column
from seacruise.desktop.pages.words import clock, run_text, short_moment, tr
from seacruise.desktop.units_choice import wind_text

YACHT_COLUMN: Final = 1
NOTE_COLUMN: Final = 2
"""From here on a departure without a passage has its reason instead of figures."""


MOTOR_COLUMN: Final = 7

LEAST_MOTOR_H: Final = 0.05
"""Less than this under engine [h] is nothing to tell."""


def columns() -> tuple[Column, ...]:
    """Make the table's columns, from left to right."""

    def number(name: str) -> Callable[[Row], Any]:
        return lambda row: None if row.run is None else getattr(row.run, name)

    def text(name: str, say: Callable[[Any], str]) -> Callable[[Row], str]:
        value = number(name)
        return lambda row: "" if value(row) is None else say(value(row))

    def hours(value: float) -> str:
        return f"{value:.0f}" if value >= LEAST_MOTOR_H else "–"

    return (
        Column(
            tr("Leaves"),
            tr("Departure"),
            lambda row: short_moment(row.departure),
            lambda row: (row.departure, row.number),
            "Wed 00 00:00",
            left=True,
            takes_rest=True,
        ),
        Column(
            tr("Yacht"),
            tr("Yacht"),
            lambda row: row.yacht,
            lambda row: row.yacht,
            "Bavaria 46 Cruiser",
            left=True,
        ),
        Column(tr("Hours"), tr("Duration"), text("duration_h", clock), number("duration_h"), "00 h 00"),
        Column(
            tr("Arrives"),
            tr("Arrival"),
            text("arrival", short_moment),
            number("arrival"),
            "Wed 00 00:00",
        ),
        Column(
            tr("Wind"),
            tr("Strongest true wind"),
            text("max_tws_kn", wind_text),
            number("max_tws_kn"),
            "00 kn",
        ),
        Column(
            tr("Upwind"),
            tr("Part of the time closer than 60° to the true wind"),
            text("upwind_share", lambda v: f"{100.0 * v:.0f} %"),
            number("upwind_share"),
            "100 %",
        ),
        Column(tr("Night"), tr("Hours in the dark"), text("night_h", hours), number("night_h"), "00"),
        Column(tr("Motor"), tr("Hours under engine"), text("motor_h", hours), number("motor_h"), "00"),
    )


def tip_of(row: Row) -> str:
    """Tell a departure in full."""
    return "" if row.run is None else run_text(row.run)
