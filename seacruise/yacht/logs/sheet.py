"""Logs as tables: a header that names columns and units, a row a moment, as blocks of a log."""

from __future__ import annotations

import csv
import re
from collections.abc import Callable, Iterable, Iterator
from datetime import UTC, datetime
from math import isnan, nan, pi
from typing import Final

from seacruise.errors import InputError
from seacruise.text import parse_number
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.logs.gather import Gatherer
from seacruise.yacht.logs.log import Log, Tally

_NAMES: Final = {
    "time": "time datetime timestamp utc",
    "date": "date",
    "lat": "lat latitude",
    "lon": "lon lng long longitude",
    "sog": "sog speedoverground gpsspeed",
    "cog": "cog courseoverground gpscourse",
    "stw": "stw bsp sow boatspeed speedthroughwater waterspeed",
    "heading": "heading hdg hdt headingtrue",
    "magnetic": "hdm headingmagnetic",
    "variation": "variation magneticvariation",
    "awa": "awa apparentwindangle",
    "aws": "aws apparentwindspeed",
    "twa": "twa truewindangle",
    "tws": "tws truewindspeed",
    "rpm": "rpm enginerpm revolutions",
}
_COLUMN_OF: Final = {alias: column for column, aliases in _NAMES.items() for alias in aliases.split()}
_UNITS: Final = {"kn": MS_PER_KNOT, "kt": MS_PER_KNOT, "kts": MS_PER_KNOT, "knots": MS_PER_KNOT}
_UNITS_SI: Final = {"ms": 1.0, "mps": 1.0, "kmh": 1.0 / 3.6, "mph": 0.44704}
_SPEEDS: Final = ("sog", "stw", "aws", "tws")
_OFF_BOW: Final = ("awa", "twa")
_DIRECTIONS: Final = ("cog", "heading", "magnetic")
_BOUNDS: Final = {"lat": (-90.0, 90.0), "lon": (-180.0, 180.0), "rpm": (-20_000.0, 20_000.0)}
_HEADER = re.compile(
    r"([^\W\d_](?:[^\W_]|[ -])*?)[ _]*(?:[\[(]([^\])]*)[\])]|_(kn|kts?|knots|ms|mps|kmh|deg|rad))?"
)

_Columns = dict[int, str]
_Readers = dict[int, Callable[[str], float]]


def read_sheet(lines: Iterable[bytes], tally: Tally, *, variation_deg: float = nan) -> Iterator[Log]:
    """Read a table with a header in blocks; memory does not grow with the log.

    Columns are known by their usual names (``time``, ``lat``, ``lon``, ``sog``, ``cog``, ``stw`` or
    ``bsp``, ``heading``, ``awa``, ``aws``, ``twa``, ``tws``, ``rpm``, ...), in any order. Speeds are in
    knots unless the header says otherwise, as in ``sog_ms``, ``stw [km/h]`` or ``tws (m/s)``. Times are
    ISO 8601, UTC unless they have an offset, in one column or as date and time, or seconds since 1970.
    Cells are separated by ``;``, tabs or commas.

    Parameters
    ----------
    lines
        The file's lines.
    tally
        Is counted up on the way.
    variation_deg
        Magnetic variation [degrees, positive to the east] for a column of magnetic headings.

    Yields
    ------
    Log
        A row a line.

    Raises
    ------
    InputError
        There is no header with a time.
    """
    text = (line.decode("utf-8-sig", "replace").rstrip("\r\n") for line in lines)
    content = (line for line in text if line.strip() and not line.lstrip().startswith("#"))
    header = next(content, "")
    separator = max(";\t,", key=header.count)
    columns, readers = _columns(header.split(separator))
    if not {"time", "date"} & set(columns.values()):
        raise InputError(
            "The log's first line names no column of times; a header such as time;stw;twa;tws is needed."
        )
    rows = Gatherer()
    for cells in csv.reader(content, delimiter=separator):
        if _row(cells, columns, readers, rows, variation_deg):
            tally.used += 1
        else:
            tally.skipped["garbled"] += 1
        if block := rows.full():
            yield block
    if block := rows.rest():
        yield block


def _columns(header: list[str]) -> tuple[_Columns, _Readers]:
    """Of each cell that is known, the column and how its figures are read."""
    columns: _Columns = {}
    readers: _Readers = {}
    for place, cell in enumerate(header):
        match = _HEADER.fullmatch(cell.strip().strip('"').casefold())
        column = _COLUMN_OF.get(re.sub(r"[ -]", "", match[1])) if match else None
        if match is None or column is None or column in columns.values():
            continue
        columns[place] = column
        if column not in ("time", "date"):
            readers[place] = _reader(column, re.sub(r"[^a-z]", "", match[2] or match[3] or ""))
    return columns, readers


def _reader(column: str, unit: str) -> Callable[[str], float]:
    factor = 1.0
    if column in _SPEEDS:
        factor = (_UNITS | _UNITS_SI).get(unit, MS_PER_KNOT)
    elif unit == "rad":
        factor = 180.0 / pi
    low, high = (0.0, 120.0) if column in _SPEEDS else _BOUNDS.get(column, (-360.0, 360.0))

    def read(cell: str) -> float:
        number = parse_number(cell)
        if number is None or not low <= number * factor <= high:
            return nan
        value = number * factor
        if column in _OFF_BOW:
            return 180.0 - (180.0 - value) % 360.0
        return value % 360.0 if column in _DIRECTIONS else value

    return read


def _time(cell: str) -> float:
    number = parse_number(cell)
    if number is not None:
        # Milliseconds are what many programs count in.
        return number / 1000.0 if number > 1e11 else number
    try:
        moment = datetime.fromisoformat(cell.strip())
    except ValueError:
        return nan
    return (moment if moment.tzinfo else moment.replace(tzinfo=UTC)).timestamp()


def _row(
    cells: list[str], columns: _Columns, readers: _Readers, rows: Gatherer, variation_deg: float
) -> bool:
    said = {name: cells[place] for place, name in columns.items() if place < len(cells)}
    time = _time("T".join(said[name].strip() for name in ("date", "time") if name in said))
    if isnan(time):
        return False
    rows.at(time)
    values = {columns[place]: read(cells[place]) for place, read in readers.items() if place < len(cells)}
    variation = values.pop("variation", variation_deg)
    magnetic = values.pop("magnetic", nan)
    if isnan(values.get("heading", nan)):
        values["heading"] = (magnetic + (0.0 if isnan(variation) else variation)) % 360.0
    for name, value in values.items():
        rows.put(name, value)
    return any(not isnan(value) for value in values.values())
