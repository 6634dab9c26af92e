"""Polar files: any table that sailors have is read by its content, the house format is written.

House format: ``;`` separated, first cell ``twa/tws``, columns of true wind speed [kn], rows of true wind
angle [degrees], boat speed [kn] in the cells, an empty cell where the table has no figure, ``#`` comments.

Read besides: the same with tabs, commas or blanks and the headers of OpenCPN, qtVlm, MaxSea and Adrena; the
site export of ORC certificates, in which 0 stands for "no figure" in the rows of beat and run angles; ORC
text tables with beat and run VMG; Expedition's rows of wind speed and pairs of angle and speed; lists of
wind speed, angle and boat speed.
"""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from seacruise.atomic import write_atomically
from seacruise.errors import InputError
from seacruise.text import parse_number, read_text, split_lines
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.polar import Polar

_MAX_TWS_KN = 120.0
_MAX_SPEED_KN = 80.0
_SAME_SPEED_KN = 0.05
"""Two figures for one angle and wind may differ by this: a beat or run angle met a tabulated one."""

_HEADER = re.compile(
    r"(twa|tws|angles?|wind ?(speed|velocity)|twa ?[\\/|x;,_ -] ?tws|tws ?[\\/|x;,_ -] ?twa)"
    r" ?[(\[]?(deg|knop|kno?t?s?|kts?)?[)\]]?"
)
_ANGLE_ROW = re.compile(r"(beat|run|gybe|jibe)? ?(angles?|twa)")
_VMG_ROW = re.compile(r"(beat|run|gybe|jibe)? ?(vmg|wmg)")


@dataclass(frozen=True, slots=True)
class _Row:
    """Cells of a line that is no comment."""

    line: int
    cells: list[str]

    @property
    def label(self) -> str:
        return " ".join(self.cells[0].casefold().split())

    def number(self, cell: int, what: str) -> float:
        """Read the number in a cell, or raise an error that names line and cell."""
        text = self.cells[cell].strip().rstrip("°º").strip()
        value = parse_number(text)
        if value is None:
            shown = text if len(text) <= 20 else text[:20] + "..."
            raise _FaultError(f"line {self.line}, cell {cell + 1}: {shown!r} is not a number ({what})")
        return value


class _FaultError(Exception):
    """What is wrong with the file, without its name."""


@dataclass(slots=True)
class _Table:
    """Figures as they are collected [kn, degrees]: ``figures[tws][twa]``."""

    figures: dict[float, dict[float, float]] = field(default_factory=dict)

    def add_wind(self, tws: float, row: _Row, cell: int) -> None:
        if not 0.0 <= tws <= _MAX_TWS_KN:
            raise _FaultError(
                f"line {row.line}, cell {cell + 1}: a wind speed of {tws:g} kn is not within 0 and "
                f"{_MAX_TWS_KN:g}"
            )
        if tws in self.figures:
            raise _FaultError(f"line {row.line}, cell {cell + 1}: the wind speed {tws:g} kn is there twice")
        if self.figures and tws < max(self.figures):
            raise _FaultError(
                f"line {row.line}, cell {cell + 1}: the wind speeds must increase, {tws:g} kn comes after "
                f"{max(self.figures):g}"
            )
        self.figures[tws] = {}

    def add(self, tws: float, twa: float, speed: float, row: _Row, cell: int) -> None:
        where = f"line {row.line}, cell {cell + 1}"
        if not 0.0 <= twa <= 180.0:
            raise _FaultError(f"{where}: a wind angle of {twa:g} degrees is not within 0 and 180")
        if not 0.0 <= speed <= _MAX_SPEED_KN:
            raise _FaultError(f"{where}: a boat speed of {speed:g} kn is not within 0 and {_MAX_SPEED_KN:g}")
        known = self.figures[tws].setdefault(twa, speed)
        if abs(known - speed) > _SAME_SPEED_KN:
            raise _FaultError(
                f"{where}: {twa:g} degrees at {tws:g} kn has two speeds, {known:g} and {speed:g} kn"
            )


def read_polar(path: Path) -> Polar:
    """Read a polar file of any format that is known, told by its content.

    Raises
    ------
    InputError
        It is missing, no polar or broken; the sentence names the line, the cell and what to do.
    """
    path = Path(path)
    text = read_text(path, "polar file")
    try:
        return _parse(text, path)
    except _FaultError as fault:
        raise InputError(f"{path.name}, {fault}; correct it or choose another polar file.") from None


def _parse(text: str, path: Path) -> Polar:
    start = text.lstrip()[:200]
    if start.startswith("<"):
        raise _FaultError("line 1: this is an XML file, not a table of boat speeds")
    if start.startswith(("{", "[")):
        raise _FaultError("line 1: this is a JSON file, not a table of boat speeds")
    lines = split_lines(text)
    comments = [line.strip() for line in lines if line.lstrip().startswith(("#", "!"))]
    rows = list(_rows(lines))
    if not rows:
        raise _FaultError("line 1: there are only comments and no figures")
    return _polar(_collect(rows), path, comments)


def _rows(lines: list[str]) -> Iterator[_Row]:
    for number, line in enumerate(lines, start=1):
        if not line.strip() or line.lstrip().startswith(("#", "!")):
            continue
        try:
            cells = _cells(line)
        except csv.Error:
            raise _FaultError(f"line {number}: the quotation marks do not match") from None
        if any(cells):
            yield _Row(number, cells)


def _cells(line: str) -> list[str]:
    """Cells of a line; each line tells its own separator, since in some files they differ."""
    line = line.replace("\u00a0", " ")
    for separator in (";", "\t"):
        if separator in line:
            return _split(line, separator)
    words = line.split()
    # "52 3,74 4,48" has decimal commas and blanks, "52, 3.74, 4.48" commas between the cells.
    decimal_commas = len(words) > 1 and all("," not in w or re.fullmatch(r"[+-]?\d*,\d+°?", w) for w in words)
    if "," in line and not decimal_commas:
        return _split(line, ",")
    # "Beat Angles" is a label of two words: blanks separate cells only before a figure.
    match = re.match(r"\s*(\D+?)(?=\s+[-+.,]?\d)", line)
    return [match[1].strip(), *line[match.end() :].split()] if match else words


def _split(line: str, separator: str) -> list[str]:
    if '"' in line:
        return [cell.strip() for cell in next(csv.reader([line], delimiter=separator, strict=True))]
    return [cell.strip().strip("'") for cell in line.split(separator)]


# --- the formats ---------------------------------------------------------------------------------------


def _collect(rows: list[_Row]) -> _Table:
    first = rows[0]
    if first.label == "polardiagrammultisails":
        raise _FaultError(f"line {first.line}: tables of several sails are not read")
    if first.label == "polardiagrampointcloud":
        rows = rows[1:]
    if rows and [cell.casefold() for cell in _trimmed(rows[0].cells)] == ["tws", "twa", "bsp"]:
        return _point_list(rows[1:])
    for place, row in enumerate(rows[:5]):
        if len(row.cells) > 1 and _HEADER.fullmatch(row.label):
            return _by_angle(rows[place:])
    if parse_number(first.cells[0]) is not None:
        cells = len(_trimmed(first.cells))
        if cells >= 3 and cells % 2:
            return _expedition(rows)
        raise _FaultError(
            f"line {first.line}: the header with the wind speeds is missing, such as twa/tws;6;8;10"
        )
    raise _FaultError(f"line {first.line}: this is no header of a polar, such as twa/tws;6;8;10")


def _by_angle(rows: list[_Row]) -> _Table:
    """Read a row per angle and a column per wind speed, or the other way round: the corner tells."""
    header, body = _Row(rows[0].line, _trimmed(rows[0].cells)), rows[1:]
    if not body:
        raise _FaultError(f"line {header.line}: there is a header but no rows of boat speeds")
    if re.match(r"tws ?\W ?twa", header.label):
        return _by_wind(header, body)
    table = _Table()
    winds = []
    for cell in range(1, len(header.cells)):
        winds.append(header.number(cell, "wind speed"))
        table.add_wind(winds[-1], header, cell)
    if len(winds) < 2:
        raise _FaultError(f"line {header.line}: there is only one wind speed; a polar needs two or more")
    figures = _figures(body, winds)
    missing_is_zero = _zero_is_missing(figures, len(winds))
    for row, twa, speeds in figures:
        known = [k for k, speed in enumerate(speeds) if speed is not None]
        if missing_is_zero and (_is_single(speeds) or not any(speeds)):
            known = [k for k in known if speeds[k]]
        for k in known:
            table.add(winds[k], twa[k], speeds[k] or 0.0, row, k + 1)
    return table


_Figures = list[tuple[_Row, list[float], list[float | None]]]


def _figures(body: list[_Row], winds: list[float]) -> _Figures:
    """Of each row the angle and the speed at every wind speed; ``None`` where there is no figure."""
    figures: _Figures = []
    angles: tuple[_Row, list[float]] | None = None
    for row in body:
        _check_length(row, len(winds))
        if _ANGLE_ROW.fullmatch(row.label):
            angles = (row, _complete(row, winds, "wind angle"))
        elif _VMG_ROW.fullmatch(row.label):
            if angles is None:
                raise _FaultError(f"line {row.line}: the row of angles that this VMG belongs to is missing")
            vmg = _complete(row, winds, "VMG")
            for k, twa in enumerate(angles[1]):
                if not 0.0 <= twa <= 180.0 or abs(math.cos(math.radians(twa))) < 0.05:
                    raise _FaultError(
                        f"line {angles[0].line}, cell {k + 2}: {twa:g} degrees is no angle of a best VMG"
                    )
            speeds = [v / abs(math.cos(math.radians(a))) for v, a in zip(vmg, angles[1], strict=True)]
            figures.append((row, angles[1], list(speeds)))
            angles = None
        else:
            twa = row.number(0, "wind angle")
            figures.append((row, [twa] * len(winds), _speeds(row, len(winds))))
    return figures


def _complete(row: _Row, winds: list[float], what: str) -> list[float]:
    return [row.number(cell, what) for cell in range(1, len(winds) + 1)]


def _speeds(row: _Row, winds: int) -> list[float | None]:
    return [row.number(cell, "boat speed") if row.cells[cell] else None for cell in range(1, winds + 1)]


def _trimmed(cells: list[str]) -> list[str]:
    """Without the empty cells that trailing separators make."""
    filled = [k for k, cell in enumerate(cells) if cell]
    return cells[: filled[-1] + 1] if filled else []


def _check_length(row: _Row, columns: int, what: str = "wind speeds") -> None:
    """Refuse a ragged row: a figure in the wrong column would be a wrong speed."""
    cells = max(len(_trimmed(row.cells)), min(len(row.cells), columns + 1))
    if cells != columns + 1:
        raise _FaultError(f"line {row.line}: {cells - 1} figures where the header has {columns} {what}")


def _is_single(speeds: list[float | None]) -> bool:
    return sum(1 for speed in speeds if speed) == 1


def _zero_is_missing(figures: _Figures, winds: int) -> bool:
    """Whether this is the export of a certificate: each wind speed has beat or run rows of its own."""
    single = [speeds for _, _, speeds in figures if _is_single(speeds) and None not in speeds]
    covered = {k for speeds in single for k, speed in enumerate(speeds) if speed}
    return winds > 2 and len(covered) == winds


def _by_wind(header: _Row, body: list[_Row]) -> _Table:
    table = _Table()
    angles = [header.number(cell, "wind angle") for cell in range(1, len(header.cells))]
    for row in body:
        tws = row.number(0, "wind speed")
        table.add_wind(tws, row, 0)
        _check_length(row, len(angles), "angles")
        for cell, twa in enumerate(angles, start=1):
            if row.cells[cell]:
                table.add(tws, twa, row.number(cell, "boat speed"), row, cell)
    return table


def _expedition(rows: list[_Row]) -> _Table:
    """Expedition: a wind speed, then pairs of angle and boat speed."""
    table = _Table()
    for row in rows:
        tws = row.number(0, "wind speed")
        table.add_wind(tws, row, 0)
        cells = len(_trimmed(row.cells))
        if cells < 3 or cells % 2 == 0:
            raise _FaultError(
                f"line {row.line}: after the wind speed there must be pairs of angle and boat speed"
            )
        for cell in range(1, cells, 2):
            twa, speed = row.number(cell, "wind angle"), row.number(cell + 1, "boat speed")
            table.add(tws, twa, speed, row, cell + 1)
    return table


def _point_list(rows: list[_Row]) -> _Table:
    """Lines of wind speed, angle and boat speed."""
    table = _Table()
    for row in rows:
        if len(_trimmed(row.cells)) != 3:
            raise _FaultError(f"line {row.line}: wind speed, wind angle and boat speed are needed")
        tws, twa, speed = (
            row.number(k, what) for k, what in enumerate(("wind speed", "wind angle", "speed"))
        )
        if tws not in table.figures:
            table.add_wind(tws, row, 0)
        table.add(tws, twa, speed, row, 2)
    return table


def _polar(table: _Table, path: Path, comments: list[str]) -> Polar:
    """Make the polar; wind speeds without any figure are left out (OpenCPN: interpolate there)."""
    winds = [tws for tws, figures in table.figures.items() if figures]
    angles = sorted({twa for tws in winds for twa in table.figures[tws]})
    if len(winds) < 2 or len(angles) < 2:
        raise _FaultError("line 1: a polar needs figures at two wind speeds and two angles or more")
    speeds = np.full((len(angles), len(winds)), np.nan)
    row_of = {twa: row for row, twa in enumerate(angles)}
    for k, tws in enumerate(winds):
        for twa, speed in table.figures[tws].items():
            speeds[row_of[twa], k] = speed
    if not (speeds > 0.0).any():
        raise _FaultError("line 1: all boat speeds are zero")
    named = {
        key.strip().casefold(): value.strip()
        for key, colon, value in (comment.lstrip("#! ").partition(":") for comment in comments)
        if colon
    }
    return Polar(
        name=named.get("name") or " ".join(path.stem.replace("_", " ").split()) or path.name,
        tws=np.array(winds) * MS_PER_KNOT,
        twa=np.array(angles),
        speed_table=speeds * MS_PER_KNOT,
        source=named.get("source") or path.name,
        path=path,
    )


# --- writing -------------------------------------------------------------------------------------------


def write_polar(polar: Polar, path: Path) -> None:
    """Write a polar in the house format; figures to a millionth of a knot.

    Raises
    ------
    InputError
        The place cannot be written to.
    """
    path = Path(path)
    lines = [
        f"# source: {_one_line(polar.source)}",
        f"# name: {_one_line(polar.name)}",
        ";".join(["twa/tws", *(_figure(tws / MS_PER_KNOT) for tws in polar.tws)]),
    ]
    for twa, speeds in zip(polar.twa, polar.speed_table, strict=True):
        lines.append(";".join([_figure(twa), *(_figure(speed / MS_PER_KNOT) for speed in speeds)]))
    write_atomically(path, "\n".join(lines) + "\n", what="polar")


def _one_line(text: str) -> str:
    return " ".join("".join(c if c.isprintable() else " " for c in text).split())


def _figure(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.6f}".rstrip("0").rstrip(".")
