"""Polars written as files, for SeaCruise and for other programs."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.atomic import write_atomically
from seacruise.errors import InputError
from seacruise.units import MS_PER_KNOT
from seacruise.yacht._cells import DIGITS
from seacruise.yacht._trees import SCHEMA
from seacruise.yacht.polar import Polar

Array = NDArray[np.float64]


def write_polar(polar: Polar, path: Path, *, form: str = "seacruise") -> None:
    """Write a polar; figures to a millionth of a knot.

    ``seacruise`` and ``json`` keep the sails; ``opencpn``, ``expedition`` and ``points`` leave out what the
    table has no figure for; the others know no empty cells, and get the speed that is interpolated there.

    Parameters
    ----------
    form
        One of `FORMATS`.

    Raises
    ------
    InputError
        There is no such format, or the place cannot be written to.
    """
    if form not in FORMATS:
        raise InputError(f"There is no polar format {form!r}; choose one of {', '.join(FORMATS)}.")
    write_atomically(Path(path), polar_text(polar, form), what="polar")


def polar_text(polar: Polar, form: str = "seacruise") -> str:
    """Return what `write_polar` would write."""
    return _WRITERS[form](polar)


def _seacruise(polar: Polar) -> str:
    lines = [f"# source: {_one_line(polar.source)}", f"# name: {_one_line(polar.name)}"]
    for sail in polar.sails or (polar,):
        if polar.sails:
            lines.append(f"# sail: {_one_line(sail.name)}")
        lines += _table(sail, sail.speed_table, corner="twa/tws", separator=";")
    return _text(lines, "\n")


def _opencpn(polar: Polar) -> str:
    return _text(_table(polar, polar.speed_table, corner="TWA\\TWS", separator=";"), "\n")


def _qtvlm(polar: Polar) -> str:
    return _text(_table(polar, _complete(polar), corner="TWA\\TWS", separator=";"), "\n")


def _maxsea(polar: Polar) -> str:
    return _text(_table(polar, _complete(polar), corner="TWA", separator="\t"), "\r\n")


def _hrosailing(polar: Polar) -> str:
    return _text(_table(polar, _complete(polar), corner="TWA\\TWS", separator="\t"), "\n")


def _expedition(polar: Polar) -> str:
    lines = ["!Expedition polar"]
    for tws, speeds in zip(polar.tws, polar.speed_table.T, strict=True):
        pairs = [
            _figure(v)
            for twa, speed in zip(polar.twa, speeds, strict=True)
            if not math.isnan(speed)
            for v in (twa, speed / MS_PER_KNOT)
        ]
        lines.append("\t".join([_figure(tws / MS_PER_KNOT), *pairs]))
    return _text(lines, "\r\n")


def _points(polar: Polar) -> str:
    lines = [f"# source: {_one_line(polar.source)}", f"# name: {_one_line(polar.name)}", "TWS,TWA,BSP"]
    for tws, speeds in zip(polar.tws, polar.speed_table.T, strict=True):
        lines += [
            ",".join(map(_figure, (tws / MS_PER_KNOT, twa, speed / MS_PER_KNOT)))
            for twa, speed in zip(polar.twa, speeds, strict=True)
            if not math.isnan(speed)
        ]
    return _text(lines, "\n")


def _json(polar: Polar) -> str:
    content = {"schema": SCHEMA, "yacht": polar.name, "source": polar.source, **_figures(polar)}
    if polar.sails:
        content["sails"] = [{"name": sail.name, **_figures(sail)} for sail in polar.sails]
    return json.dumps(content, allow_nan=False) + "\n"


_WRITERS: Final[dict[str, Callable[[Polar], str]]] = {
    "seacruise": _seacruise,
    "json": _json,
    "opencpn": _opencpn,
    "expedition": _expedition,
    "maxsea": _maxsea,
    "qtvlm": _qtvlm,
    "hrosailing": _hrosailing,
    "points": _points,
}

FORMATS: Final = tuple(_WRITERS)
"""Names of the formats that can be written."""


def _figures(polar: Polar) -> dict[str, Any]:
    return {
        "tws_kn": [_rounded(tws / MS_PER_KNOT) for tws in polar.tws],
        "twa_deg": [_rounded(twa) for twa in polar.twa],
        "boat_speed_kn": [
            [None if math.isnan(speed) else _rounded(speed / MS_PER_KNOT) for speed in row]
            for row in polar.speed_table
        ],
    }


def _complete(polar: Polar) -> Array:
    """Fill the cells without a figure with the speed that is interpolated there."""
    known = ~np.isnan(polar.speed_table)
    if known.all():
        return polar.speed_table
    return np.where(known, polar.speed_table, polar.speed(polar.tws, polar.twa[:, np.newaxis]))


def _table(polar: Polar, speeds: Array, *, corner: str, separator: str) -> list[str]:
    rows = [separator.join([corner, *(_figure(tws / MS_PER_KNOT) for tws in polar.tws)])]
    for twa, row in zip(polar.twa, speeds, strict=True):
        rows.append(separator.join([_figure(twa), *(_figure(speed / MS_PER_KNOT) for speed in row)]))
    return rows


def _text(lines: Iterable[str], end: str) -> str:
    return end.join([*lines, ""])


def _one_line(text: str) -> str:
    return " ".join("".join(c if c.isprintable() else " " for c in text).split())


def _rounded(value: float) -> float:
    return round(float(value), DIGITS)


def _figure(value: float) -> str:
    if math.isnan(value):
        return ""
    text = f"{value:.{DIGITS}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
