"""Tables of boat speeds in text: which form a file has, and its figures."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from itertools import groupby, pairwise

from seacruise.text import parse_number
from seacruise.yacht import _hro
from seacruise.yacht._cells import FaultError, Row, trimmed
from seacruise.yacht._figures import Figures, check_point, check_wind

_HEADER = re.compile(
    r"(twa|tws|angles?|wind ?(speed|velocity)|twa ?[\\/|x;,_ -] ?tws|tws ?[\\/|x;,_ -] ?twa)"
    r" ?[(\[]?(deg|knop|kno?t?s?|kts?)?[)\]]?"
)
_ANGLE_ROW = re.compile(r"(beat|run|gybe|jibe)? ?(angles?|twa)")
_VMG_ROW = re.compile(r"(beat|run|gybe|jibe)? ?(vmg|wmg)")


@dataclass(slots=True)
class Scatter:
    """Points of wind speed [kn], angle [degrees] and boat speed [kn], in any order."""

    points: list[tuple[float, float, float]] = field(default_factory=list)

    def figures(self) -> Figures | None:
        """Make a table, where the points are one: several angles at each wind, and one speed for each."""
        by_wind: dict[float, dict[float, float]] = {}
        for tws, twa, speed in self.points:
            column = by_wind.setdefault(tws, {})
            if twa in column:
                return None
            column[twa] = speed
        if any(len(column) < 2 for column in by_wind.values()) or len(by_wind) < 2:
            return None
        return Figures(dict(sorted(by_wind.items())))


def collect(rows: list[Row]) -> list[Figures] | Scatter:
    """Read the figures of a text file: a table, one for each sail, or scattered points.

    Raises
    ------
    FaultError
        It is no polar, or something in it is wrong.
    """
    first = rows[0]
    if first.label == "polardiagrampointcloud":
        rows = rows[1:]
    elif first.label in _hro.TITLES:
        return _hro.collect(rows)
    if rows and [cell.casefold() for cell in trimmed(rows[0].cells)] == ["tws", "twa", "bsp"]:
        return _scatter(rows[1:])
    if any(_is_header(row) for row in rows[:5]):
        return [_section(list(section)) for _, section in groupby(rows, key=lambda row: row.sail)]
    if table := _without_corner(rows):
        return [_by_angle(table)]
    if parse_number(first.cells[0]) is not None:
        cells = len(trimmed(first.cells))
        if cells >= 3 and cells % 2:
            return [_expedition(rows)]
        raise FaultError(
            f"line {first.line}: the header with the wind speeds is missing, such as twa/tws;6;8;10"
        )
    raise FaultError(f"line {first.line}: this is no header of a polar, such as twa/tws;6;8;10")


def _is_header(row: Row) -> bool:
    return len(row.cells) > 1 and _HEADER.fullmatch(row.label) is not None


def _section(rows: list[Row]) -> Figures:
    """Read the table of one sail, whose header may follow lines of a title."""
    for place, row in enumerate(rows[:5]):
        if _is_header(row):
            figures = _by_angle(rows[place:])
            figures.sail = row.sail
            return figures
    raise FaultError(f"line {rows[0].line}: the header of {rows[0].sail or 'the table'} is missing")


def _without_corner(rows: list[Row]) -> list[Row] | None:
    """Give a header its corner where there is nothing or a zero (PredictWind, Sailonline)."""
    if len(rows) < 3:
        return None
    first, second = (trimmed(row.cells) for row in rows[:2])
    if not first[0] or (parse_number(first[0]) == 0.0 and len(first) == len(second)):
        winds = first[1:]
    elif len(first) + 1 == len(second):
        winds = first
    else:
        return None
    numbers = [parse_number(cell) for cell in winds]
    # Pairs of angle and speed, which Expedition writes, do not rise all along a line.
    if len(winds) < 2 or any(a is None or b is None or a >= b for a, b in pairwise(numbers)):
        return None
    return [Row(rows[0].line, ["twa/tws", *winds]), *rows[1:]]


def _by_angle(rows: list[Row]) -> Figures:
    """Read a row per angle and a column per wind speed, or the other way round: the corner tells."""
    header, body = rows[0].trimmed(), rows[1:]
    if not body:
        raise FaultError(f"line {header.line}: there is a header but no rows of boat speeds")
    if re.match(r"tws ?\W ?twa", header.label):
        return _by_wind(header, body)
    table = Figures()
    winds = []
    for cell in range(1, len(header.cells)):
        winds.append(header.number(cell, "wind speed"))
        table.add_wind(winds[-1], header, cell)
    if len(winds) < 2:
        raise FaultError(f"line {header.line}: there is only one wind speed; a polar needs two or more")
    lines = _lines(body, winds)
    missing_is_zero = _zero_is_missing(lines, len(winds))
    for line in lines:
        known = [k for k, speed in enumerate(line.speeds) if speed is not None]
        if missing_is_zero and (_is_single(line.speeds) or not any(line.speeds)):
            known = [k for k in known if line.speeds[k]]
        for k in known:
            table.add((winds[k], line.twa[k], line.speeds[k] or 0.0), line.row, k + 1)
    return table


@dataclass(frozen=True, slots=True)
class _Line:
    """Of a row the angle and the speed [kn] at every wind speed; ``None`` where there is no figure."""

    row: Row
    twa: list[float]
    speeds: list[float | None]


def _lines(body: list[Row], winds: list[float]) -> list[_Line]:
    lines: list[_Line] = []
    angles: tuple[Row, list[float]] | None = None
    for row in body:
        _check_length(row, len(winds))
        if _ANGLE_ROW.fullmatch(row.label):
            angles = (row, _complete(row, winds, "wind angle"))
        elif _VMG_ROW.fullmatch(row.label):
            if angles is None:
                raise FaultError(f"line {row.line}: the row of angles that this VMG belongs to is missing")
            vmg = _complete(row, winds, "VMG")
            speeds = [
                speed_of_vmg(v, twa, angles[0].where(k + 1))
                for k, (v, twa) in enumerate(zip(vmg, angles[1], strict=True))
            ]
            lines.append(_Line(row, angles[1], list(speeds)))
            angles = None
        else:
            twa = row.number(0, "wind angle")
            lines.append(_Line(row, [twa] * len(winds), _speeds(row, len(winds))))
    return lines


def speed_of_vmg(vmg: float, twa: float, where: str) -> float:
    """Boat speed that makes good ``vmg`` at an angle [degrees].

    Raises
    ------
    FaultError
        Nobody beats or runs at that angle.
    """
    if not 0.0 <= twa <= 180.0 or abs(math.cos(math.radians(twa))) < 0.05:
        raise FaultError(f"{where}: {twa:g} degrees is no angle of a best VMG")
    return vmg / abs(math.cos(math.radians(twa)))


def _complete(row: Row, winds: list[float], what: str) -> list[float]:
    return [row.number(cell, what) for cell in range(1, len(winds) + 1)]


def _speeds(row: Row, winds: int) -> list[float | None]:
    return [row.number(cell, "boat speed") if row.cells[cell] else None for cell in range(1, winds + 1)]


def _check_length(row: Row, columns: int, what: str = "wind speeds") -> None:
    """Refuse a ragged row: a figure in the wrong column would be a wrong speed."""
    cells = max(len(trimmed(row.cells)), min(len(row.cells), columns + 1))
    if cells != columns + 1:
        raise FaultError(f"line {row.line}: {cells - 1} figures where the header has {columns} {what}")


def _is_single(speeds: list[float | None]) -> bool:
    return sum(1 for speed in speeds if speed) == 1


def _zero_is_missing(lines: list[_Line], winds: int) -> bool:
    """Whether this is the export of a certificate: each wind speed has beat or run rows of its own."""
    single = [line.speeds for line in lines if _is_single(line.speeds) and None not in line.speeds]
    covered = {k for speeds in single for k, speed in enumerate(speeds) if speed}
    return winds > 2 and len(covered) == winds


def _by_wind(header: Row, body: list[Row]) -> Figures:
    table = Figures()
    angles = [header.number(cell, "wind angle") for cell in range(1, len(header.cells))]
    for row in body:
        tws = row.number(0, "wind speed")
        table.add_wind(tws, row, 0)
        _check_length(row, len(angles), "angles")
        for cell, twa in enumerate(angles, start=1):
            if row.cells[cell]:
                table.add((tws, twa, row.number(cell, "boat speed")), row, cell)
    return table


def _expedition(rows: list[Row]) -> Figures:
    """Expedition, Deckman and Garmin: a wind speed, then pairs of angle and boat speed."""
    table = Figures()
    for row in rows:
        tws = row.number(0, "wind speed")
        table.add_wind(tws, row, 0)
        cells = len(trimmed(row.cells))
        if cells < 3 or cells % 2 == 0:
            raise FaultError(
                f"line {row.line}: after the wind speed there must be pairs of angle and boat speed"
            )
        for cell in range(1, cells, 2):
            twa, speed = row.number(cell, "wind angle"), row.number(cell + 1, "boat speed")
            table.add((tws, twa, speed), row, cell + 1)
    return table


def _scatter(rows: list[Row]) -> Scatter:
    """Lines of wind speed, angle and boat speed."""
    scatter = Scatter()
    for row in rows:
        if len(trimmed(row.cells)) != 3:
            raise FaultError(f"line {row.line}: wind speed, wind angle and boat speed are needed")
        tws, twa, speed = (
            row.number(k, what) for k, what in enumerate(("wind speed", "wind angle", "boat speed"))
        )
        check_wind(tws, row, 0)
        check_point(twa, speed, row, 2)
        scatter.points.append((tws, twa, speed))
    if not scatter.points:
        raise FaultError("line 1: there is a header but no points")
    return scatter
