"""Lines and cells of a polar file, whatever separates them."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import Final, Protocol

from seacruise.text import parse_number

DIGITS: Final = 6
"""Decimals of figures in files [knots, degrees]; finer differences would only make steps without end."""


class FaultError(Exception):
    """What is wrong with a polar file, without the file's name."""


@dataclass(frozen=True, slots=True)
class Row:
    """Cells of a line that is no comment.

    Attributes
    ----------
    line
        Its number as an editor shows it.
    sail
        The sail that the comments above it named, or nothing.
    """

    line: int
    cells: list[str]
    sail: str = ""

    @property
    def label(self) -> str:
        """The first cell as headers are compared."""
        return " ".join(self.cells[0].casefold().split())

    def trimmed(self) -> Row:
        """Leave out the empty cells that trailing separators make."""
        return Row(self.line, trimmed(self.cells), self.sail)

    def number(self, cell: int, what: str) -> float:
        """Read the number in a cell, to `DIGITS` decimals.

        Raises
        ------
        FaultError
            It is none; the sentence names line and cell.
        """
        value = _number(self.cells[cell])
        if value is None:
            raise FaultError(f"{self.where(cell)}: {shown(self.cells[cell])} is not a number ({what})")
        return value

    def where(self, cell: int) -> str:
        """Name the place of a cell."""
        return f"line {self.line}, cell {cell + 1}"


class Place(Protocol):
    """What can name the place of its cells, without doing so for each that is good."""

    def where(self, cell: int) -> str:
        """Name the place of a cell."""
        ...


@lru_cache(maxsize=4096)
def _number(text: str) -> float | None:
    """Read a number; most of a table's are in it, or in the next table, several times."""
    value = parse_number(text.strip().rstrip("°º"))
    return None if value is None else round(value, DIGITS)


def shown(text: str) -> str:
    """Quote what was found, cut short."""
    return repr(text if len(text) <= 20 else text[:20] + "...")


def trimmed(cells: list[str]) -> list[str]:
    """Cells up to the last that is filled."""
    filled = [k for k, cell in enumerate(cells) if cell]
    return cells[: filled[-1] + 1] if filled else []


def comments_of(lines: list[str]) -> dict[str, str]:
    """Return what comments name: ``# source: A`` gives ``{"source": "A"}``; the first of a key counts."""
    named: dict[str, str] = {}
    for line in lines:
        if _is_comment(line):
            key, colon, value = line.strip().lstrip("#! ").partition(":")
            if colon:
                named.setdefault(key.strip().casefold(), value.strip())
    return named


def rows_of(lines: list[str]) -> Iterator[Row]:
    """Rows of a table; a comment ``# sail: Genoa`` names the sail of those that follow.

    Raises
    ------
    FaultError
        Quotation marks do not match.
    """
    sail = ""
    for number, line in enumerate(lines, start=1):
        if not line.strip():
            continue
        if _is_comment(line):
            key, colon, value = line.strip().lstrip("#! ").partition(":")
            if colon and key.strip().casefold() == "sail":
                sail = value.strip()
            continue
        try:
            cells = _cells(line)
        except csv.Error:
            raise FaultError(f"line {number}: the quotation marks do not match") from None
        if any(cells):
            yield Row(number, cells, sail)


def _is_comment(line: str) -> bool:
    return line.lstrip().startswith(("#", "!"))


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
