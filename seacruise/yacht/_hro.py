"""hrosailing's own files: the tables of one or several sails that share their wind speeds.

After the title come ``TWS`` and a line of wind speeds; then, for each sail, its name (not in a table of one),
``TWA`` and a line of angles, ``BSP`` and a row of boat speeds for each angle. Angles may go round to 360
degrees; where both tacks are told, their mean is taken.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from seacruise.yacht._cells import DIGITS, FaultError, Row
from seacruise.yacht._figures import Figures

TITLES: Final = frozenset({"polardiagramtable", "polardiagrammultisails"})


def collect(rows: list[Row]) -> list[Figures]:
    """Read the figures of each sail.

    Raises
    ------
    FaultError
        A line is missing or wrong.
    """
    reader = _Reader(rows)
    several = rows[0].label == "polardiagrammultisails"
    if several and rows[1:] and rows[1].label.startswith("sails"):
        raise FaultError(f"line {rows[1].line}: the sails are in files of their own; name one of those")
    reader.take("TWS")
    winds = reader.numbers("wind speed")
    sails: list[Figures] = []
    while reader.more():
        table = Figures(sail=reader.name() if several else "")
        for k, tws in enumerate(winds[1]):
            table.add_wind(tws, winds[0], k)
        reader.take("TWA")
        here, angles = reader.numbers("wind angle")
        if len(set(angles)) < len(angles):
            raise FaultError(f"line {here.line}: an angle is there twice")
        reader.take("BSP")
        rows_by_angle: dict[float, list[tuple[Row, list[float]]]] = {}
        for twa in angles:
            row, speeds = reader.numbers("boat speed")
            if len(speeds) != len(winds[1]):
                raise FaultError(f"line {row.line}: {len(speeds)} figures for {len(winds[1])} wind speeds")
            rows_by_angle.setdefault(_folded(twa), []).append((row, speeds))
        for twa, rows_here in rows_by_angle.items():
            for k, tws in enumerate(winds[1]):
                speed = sum(speeds[k] for _, speeds in rows_here) / len(rows_here)
                table.add((tws, twa, speed), rows_here[0][0], k)
        sails.append(table)
    if not sails:
        raise FaultError(f"line {rows[-1].line}: the angles and boat speeds are missing")
    return sails


def _folded(twa: float) -> float:
    """Fold angles of the other tack, from 180 to 360 degrees."""
    return round(360.0 - twa, DIGITS) if 180.0 < twa <= 360.0 else twa


class _Reader:
    """Takes line by line what has to come next."""

    def __init__(self, rows: list[Row]) -> None:
        self._last = rows[0].line
        self._rows: Iterator[Row] = iter(rows[1:])
        self._next = next(self._rows, None)

    def more(self) -> bool:
        return self._next is not None

    def _take(self, what: str) -> Row:
        row = self._next
        if row is None:
            raise FaultError(f"line {self._last}: the file ends where {what} should follow")
        self._last, self._next = row.line, next(self._rows, None)
        return row.trimmed()

    def take(self, word: str) -> None:
        row = self._take(word)
        if row.label.rstrip(":") != word.casefold():
            raise FaultError(f"line {row.line}: {word} should be here")

    def name(self) -> str:
        return ",".join(self._take("the name of a sail").cells)

    def numbers(self, what: str) -> tuple[Row, list[float]]:
        row = self._take(f"a line of figures ({what})")
        return row, [row.number(cell, what) for cell in range(len(row.cells))]
