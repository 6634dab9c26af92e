"""Polars in JSON: our own, ORC certificates, Virtual Regatta's boats."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Final, NoReturn

from seacruise.yacht._cells import DIGITS, FaultError, shown
from seacruise.yacht._figures import Figures
from seacruise.yacht._tables import speed_of_vmg

SCHEMA: Final = "seacruise.polar/1"

_LEAST_NEGATIVE_KN: Final = -0.5
"""Virtual Regatta's tables fall a little below zero where a sail is of no use [kn]; that is a zero."""


@dataclass(frozen=True, slots=True)
class _Path:
    """Where in the file a list of figures is."""

    text: str

    def where(self, cell: int) -> str:
        return f"{self.text}, cell {cell + 1}"


@dataclass(frozen=True, slots=True)
class Tree:
    """What a JSON file holds."""

    name: str
    source: str
    sails: list[Figures]


def collect(text: str) -> Tree:
    """Read a polar in JSON; its keys tell the form.

    Raises
    ------
    FaultError
        It is no JSON, no polar, or something in it is wrong; the sentence names the place.
    """
    content = _parse(text)
    if isinstance(content, list) and len(content) == 1:
        content = content[0]
    for wrapper in ("scriptData", "polar"):
        if isinstance(content, dict) and isinstance(content.get(wrapper), dict):
            content = content[wrapper]
    if isinstance(content, dict):
        if "vpp" in content:
            return _certificate(content)
        if "sail" in content:
            return _virtual_regatta(content)
        if "tws_kn" in content or "sails" in content:
            return _ours(content)
    raise FaultError(
        "line 1: this JSON is no polar of SeaCruise (boat_speed_kn), ORC (vpp) or Virtual Regatta (sail)"
    )


def _parse(text: str) -> Any:
    def refuse(constant: str) -> NoReturn:
        raise FaultError(f"line 1: {constant} is not a number")

    try:
        return json.loads(text, parse_constant=refuse)
    except json.JSONDecodeError as error:
        raise FaultError(f"line {error.lineno}, column {error.colno}: this is not JSON") from None
    except (ValueError, RecursionError):
        raise FaultError("line 1: this JSON is nested too deeply or has a number without end") from None


def _ours(content: dict[str, Any]) -> Tree:
    sails = content.get("sails")
    if sails:
        tables = []
        for k, entry in enumerate(_list(sails, "sails")):
            where = f"sails {k + 1}"
            sail = _dict(entry, where)
            tables.append(_our_table(sail, where + ", ", _text(sail.get("name")) or f"Sail {k + 1}"))
    else:
        tables = [_our_table(content, "", "")]
    return Tree(_text(content.get("yacht")), _text(content.get("source")), tables)


def _our_table(content: dict[str, Any], where: str, sail: str) -> Figures:
    return _grid(
        _numbers(content.get("tws_kn"), where + "tws_kn"),
        _numbers(content.get("twa_deg"), where + "twa_deg"),
        content.get("boat_speed_kn"),
        where=where + "boat_speed_kn",
        sail=sail,
    )


def _virtual_regatta(content: dict[str, Any]) -> Tree:
    winds = _numbers(content.get("tws"), "tws")
    angles = _numbers(content.get("twa"), "twa")
    ratio = _number(content.get("globalSpeedRatio", 1.0), _Path("globalSpeedRatio"))
    tables = []
    for k, entry in enumerate(_list(content["sail"], "sail")):
        sail = _dict(entry, f"sail {k + 1}")
        name = _text(sail.get("name")).replace("_", " ").capitalize() or f"Sail {k + 1}"
        table = _grid(winds, angles, sail.get("speed"), where=f"sail {k + 1}, speed", sail=name, scale=ratio)
        # A sail that she does not carry is a table of zeros.
        if any(speed > 0.0 for column in table.figures.values() for speed in column.values()):
            tables.append(table)
    if not tables:
        raise FaultError("sail: there is no sail with a boat speed above zero")
    return Tree(_text(content.get("label")), "Virtual Regatta", tables)


def _certificate(content: dict[str, Any]) -> Tree:
    vpp = _dict(content["vpp"], "vpp")
    winds = _numbers(vpp.get("speeds"), "vpp, speeds")
    angles = _numbers(vpp.get("angles"), "vpp, angles")
    table = Figures()
    for k, tws in enumerate(winds):
        table.add_wind(tws, _Path("vpp, speeds"), k)
    for twa in angles:
        where = f"vpp, {twa:g}"
        _fill(table, winds, [twa] * len(winds), _row(vpp.get(f"{twa:g}"), len(winds), where), where)
    for name in ("beat", "run"):
        if vpp.get(f"{name}_angle") is None or vpp.get(f"{name}_vmg") is None:
            continue
        where = f"vpp, {name}_angle"
        own = _row(vpp[f"{name}_angle"], len(winds), where)
        vmg = _row(vpp[f"{name}_vmg"], len(winds), f"vpp, {name}_vmg")
        # Where there is no best angle the certificate has a zero.
        pairs = [(a, v) if a and v else (None, None) for a, v in zip(own, vmg, strict=True)]
        best = [a for a, _ in pairs]
        speeds = [
            None if a is None or v is None else speed_of_vmg(v, a, f"{where}, cell {k + 1}")
            for k, (a, v) in enumerate(pairs)
        ]
        _fill(table, winds, [a or 0.0 for a in best], speeds, where)
    return Tree(*_certificate_names(content), [table])


def _certificate_names(content: dict[str, Any]) -> tuple[str, str]:
    boat = content.get("boat")
    kind = _text(boat.get("type")) if isinstance(boat, dict) else ""
    own = _text(content.get("name"))
    number = _text(content.get("sailnumber"))
    # Those who choose a yacht look for the type.
    name = f"{kind} ({own})" if kind and own else kind or own
    return name, " ".join(f"ORC certificate {number} {kind}".split())


def _grid(
    winds: list[float],
    angles: list[float],
    rows: Any,
    *,
    where: str,
    sail: str,
    scale: float | None = None,
) -> Figures:
    """Read rows of boat speeds, one for each angle; ``null`` where there is no figure.

    With a ``scale`` speeds are multiplied by it, and such as are hardly below zero are zero.
    """
    table = Figures(sail=sail)
    for k, tws in enumerate(winds):
        table.add_wind(tws, _Path(f"{where}, wind speeds"), k)
    rows = _list(rows, where)
    if len(rows) != len(angles):
        raise FaultError(f"{where}: {len(rows)} rows for {len(angles)} wind angles")
    for number, (twa, row) in enumerate(zip(angles, rows, strict=True), start=1):
        here = f"{where}, row {number}"
        speeds = _row(row, len(winds), here)
        if scale is not None:
            speeds = [v if v is None or v < _LEAST_NEGATIVE_KN else max(0.0, v * scale) for v in speeds]
        _fill(table, winds, [twa] * len(winds), speeds, here)
    return table


def _fill(
    table: Figures, winds: list[float], angles: list[float], speeds: list[float | None], where: str
) -> None:
    place = _Path(where)
    for k, (tws, twa, speed) in enumerate(zip(winds, angles, speeds, strict=True)):
        if speed is not None:
            table.add((tws, twa, speed), place, k)


def _row(value: Any, length: int, where: str) -> list[float | None]:
    row = _list(value, where)
    if len(row) != length:
        raise FaultError(f"{where}: {len(row)} figures for {length} wind speeds")
    place = _Path(where)
    return [None if v is None else _number(v, place, k) for k, v in enumerate(row)]


def _numbers(value: Any, where: str) -> list[float]:
    place = _Path(where)
    return [_number(v, place, k) for k, v in enumerate(_list(value, where))]


def _number(value: Any, place: _Path, cell: int | None = None) -> float:
    # In Python true is a number; here it is not. 1e999 is infinite, and no float holds 10**400.
    if isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < 1e9:
        return round(float(value), DIGITS)
    found = shown(str(value)) if isinstance(value, str | int | float) else f"a {type(value).__name__}"
    where = place.text if cell is None else place.where(cell)
    raise FaultError(f"{where}: {found} is not a number")


def _list(value: Any, where: str) -> list[Any]:
    if isinstance(value, list):
        return value
    raise FaultError(f"{where}: a list of figures is missing")


def _dict(value: Any, where: str) -> dict[str, Any]:
    if isinstance(value, dict):
        return value
    raise FaultError(f"{where}: this is no object with named parts")


def _text(value: Any) -> str:
    # JSON can spell half a surrogate pair, which no file can hold.
    return " ".join(value.encode("utf-8", "replace").decode().split()) if isinstance(value, str) else ""
