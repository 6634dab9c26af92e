"""Polar files: any that sailors have is read by its content, most can be written.

House format: ``;`` separated, first cell ``twa/tws``, columns of true wind speed [kn], rows of true wind
angle [degrees], boat speed [kn] in the cells, an empty cell where the table has no figure, ``#`` comments. A
comment ``# sail: Genoa`` before a header makes the table below that of one sail; several may follow.

Read besides: the same with tabs, commas or blanks and the headers of OpenCPN, qtVlm, MaxSea and Adrena; the
site export of ORC certificates, in which 0 stands for "no figure" in the rows of beat and run angles; ORC
text tables with beat and run VMG and ORC certificates in JSON; Expedition's rows of wind speed and pairs of
angle and speed; lists of wind speed, angle and boat speed; hrosailing's tables of one and of several sails;
Virtual Regatta's boats in JSON; OpenCPN's boats in XML, which name polar files beside them.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from seacruise.errors import InputError
from seacruise.text import read_text, split_lines
from seacruise.units import MS_PER_KNOT
from seacruise.yacht import _tables, _trees
from seacruise.yacht._cells import FaultError, comments_of, rows_of
from seacruise.yacht._figures import Figures
from seacruise.yacht.points import PolarPoints
from seacruise.yacht.polar import Polar
from seacruise.yacht.sails import SailSet
from seacruise.yacht.writers import FORMATS, write_polar

_MAX_SAILS = 20

__all__ = ["FORMATS", "read_points", "read_polar", "write_polar"]


def read_polar(path: Path) -> Polar:
    """Read a polar file of any format that is known, told by its content.

    Of several sails it is the best, with the sails in `Polar.sails`; of scattered points the surface through
    them.

    Raises
    ------
    InputError
        It is missing, no polar or broken; the sentence names the line, the cell and what to do.
    """
    path = Path(path)
    text = read_text(path, "polar file")
    try:
        return _parse(text, path)
    except FaultError as fault:
        raise _refusal(path, fault) from None


def read_points(path: Path) -> PolarPoints:
    """Read a list of wind speed, angle and boat speed as it is, without making a table of it.

    Raises
    ------
    InputError
        It is missing, no such list or broken.
    """
    path = Path(path)
    lines = split_lines(read_text(path, "list of points"))
    try:
        return _points(_scatter(lines), *_names(comments_of(lines), path), path)
    except FaultError as fault:
        raise _refusal(path, fault) from None


def _scatter(lines: list[str]) -> _tables.Scatter:
    rows = list(rows_of(lines))
    content = _tables.collect(rows) if rows else None
    if isinstance(content, _tables.Scatter):
        return content
    raise FaultError("line 1: this is no list of points, which begins with TWS,TWA,BSP")


def _refusal(path: Path, fault: FaultError) -> InputError:
    return InputError(f"{path.name}, {fault}; correct it or choose another polar file.")


def _parse(text: str, path: Path) -> Polar:
    start = text.lstrip("\ufeff \t\r\n\f")[:1]
    if start == "<":
        return _boat(text, path)
    if start in {"{", "["}:
        tree = _trees.collect(text)
        name = tree.name or _name_of(path)
        return _polar(tree.sails, name, tree.source or path.name, path)
    lines = split_lines(text)
    rows = list(rows_of(lines))
    if not rows:
        raise FaultError("line 1: there are only comments and no figures")
    name, source = _names(comments_of(lines), path)
    content = _tables.collect(rows)
    if isinstance(content, _tables.Scatter):
        table = content.figures()
        if table is None:
            return _points(content, name, source, path).to_table()
        content = [table]
    return _polar(content, name, source, path)


def _names(comments: dict[str, str], path: Path) -> tuple[str, str]:
    return comments.get("name") or _name_of(path), comments.get("source") or path.name


def _name_of(path: Path) -> str:
    return " ".join(path.stem.replace("_", " ").split()) or path.name


def _polar(tables: list[Figures], name: str, source: str, path: Path) -> Polar:
    """Make the polar of one table, or of the best of several sails."""
    if len(tables) == 1 and not tables[0].sail:
        return tables[0].polar(name, source=source, path=path)
    names = [table.sail or f"Sail {number}" for number, table in enumerate(tables, start=1)]
    if twice := next((sail for sail in names if names.count(sail) > 1), None):
        raise FaultError(f"line 1: two sails have the name {twice}")
    if len(names) > _MAX_SAILS:
        raise FaultError(f"line 1: {len(names)} sails are more than a yacht carries")
    sails = tuple(table.polar(sail, source=source) for table, sail in zip(tables, names, strict=True))
    return SailSet(name, sails, source=source, path=path).to_table()


def _points(scatter: _tables.Scatter, name: str, source: str, path: Path) -> PolarPoints:
    tws, twa, speed = np.array(scatter.points).T
    if len(np.unique(tws)) < 2 or len(np.unique(twa)) < 2:
        raise FaultError("line 1: a polar needs points at two wind speeds and two angles or more")
    if not speed.any():
        raise FaultError("line 1: all boat speeds are zero")
    return PolarPoints(name, tws * MS_PER_KNOT, twa, speed * MS_PER_KNOT, source=source, path=path)


def _boat(text: str, path: Path) -> Polar:
    """Read OpenCPN's description of a boat: the best of the polars that it names."""
    # Declared entities can grow without bound; no boat has any.
    if "<!" in text.replace("<!--", ""):
        raise FaultError("line 1: this XML declares things of its own; that is no OpenCPN boat")
    import xml.etree.ElementTree as ET

    try:
        root = ET.fromstring(text)  # noqa: S314 - no declarations: nothing can expand
    except (ET.ParseError, ValueError) as error:
        line = getattr(error, "position", (1, 0))[0]
        raise FaultError(f"line {line}: this is not XML that can be read") from None
    named = [polar.get("FileName", "") for polar in root.iter("Polar")]
    if root.tag != "OpenCPNWeatherRoutingBoat" or not any(named):
        raise FaultError("line 1: this XML is no OpenCPN boat with a polar file")
    files = [_beside(path, name) for name in named if name]
    if any(read_text(file, "polar file").lstrip("\ufeff \t\r\n").startswith("<") for file in files):
        raise FaultError("line 1: a polar file that the boat names is itself a boat")
    polars = [read_polar(file) for file in files]
    if len(polars) == 1:
        return Polar(
            _name_of(path), polars[0].tws, polars[0].twa, polars[0].speed_table, source=path.name, path=path
        )
    return SailSet(_name_of(path), tuple(polars), source=path.name, path=path).to_table()


def _beside(boat: Path, name: str) -> Path:
    """Find a polar file that a boat names, in its folder or in OpenCPN's folder of polars next to it."""
    last = Path(name.replace("\\", "/")).name
    for folder in (boat.parent, boat.parent / "polars", boat.parent.parent / "polars"):
        try:
            if last and (folder / last).is_file():
                return folder / last
        except (OSError, ValueError):
            continue
    raise FaultError(f"line 1: the boat's polar file {last or name!r} does not lie beside it")
