"""Ports: yacht harbours by name, found with or without diacritics."""

from __future__ import annotations

import csv
import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from pathlib import Path

from seacruise.errors import InputError
from seacruise.geodesy import format_position
from seacruise.resources import resource_path
from seacruise.text import did_you_mean, folds, parse_number, rank_names, read_text, same_name, suggestions

HEADER = ("name", "country", "lat", "lon")

# Names that a foreign chart or a neighbour uses; the file has the native one.
_EXONYMS = {
    "Copenhagen": "København", "Kopenhagen": "København", "Elsinore": "Helsingør",
    "Gothenburg": "Göteborg", "Danzig": "Gdańsk", "Gdingen": "Gdynia", "Stettin": "Szczecin",
    "Swinemünde": "Świnoujście", "Kolberg": "Kołobrzeg", "Memel": "Klaipėda", "Libau": "Liepāja",
    "Windau": "Ventspils", "Reval": "Tallinn", "Helsingfors": "Helsinki", "Åbo": "Turku",
    "Hangö": "Hanko", "Borgå": "Porvoo", "Nådendal": "Naantali", "Raumo": "Rauma",
    "Björneborg": "Pori", "Vasa": "Vaasa", "Uleåborg": "Oulu", "Ekenäs": "Tammisaari",
    "Nauvo": "Nagu", "Fredrikshamn": "Hamina", "Karleby": "Kokkola", "Apenrade": "Aabenraa",
    "Sonderburg": "Sønderborg", "Saint Petersburg": "Sankt-Peterburg", "St Petersburg": "Sankt-Peterburg",
    "Maarianhamina": "Mariehamn", "Wyborg": "Vyborg",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Port:
    """A yacht harbour, or any position that a sailor gives.

    Attributes
    ----------
    name
        Native spelling, e.g. ``"Świnoujście"``; for a bare position the position itself.
    country
        ISO 3166 alpha-2 code, empty for a bare position.
    lat, lon
        Degrees, north and east positive.
    """

    name: str
    country: str
    lat: float
    lon: float


def load_ports(path: Path | None = None) -> tuple[Port, ...]:
    """Read the ports, in the order of the file.

    Parameters
    ----------
    path
        A file ``name,country,lat,lon`` in UTF-8; the one that is shipped when not given.

    Raises
    ------
    InputError
        The file is missing or wrong; the sentence names the line and what to do.
    """
    return _shipped_ports() if path is None else _read(path)


@cache
def _shipped_ports() -> tuple[Port, ...]:
    return _read(resource_path("ports.csv"))


def _read(path: Path) -> tuple[Port, ...]:
    reader = csv.reader(read_text(path, "list of ports").splitlines(), strict=True)
    ports: list[Port] = []
    lines: dict[str, int] = {}
    try:
        header = tuple(cell.strip().lower() for cell in next(reader))
        if header != HEADER:
            raise InputError(f"{path.name}, line 1: the header must be {','.join(HEADER)}.")
        for cells in reader:
            if not any(cell.strip() for cell in cells):
                continue
            where = f"{path.name}, line {reader.line_num}"
            port = _port(cells, where)
            first = lines.setdefault(port.name, reader.line_num)
            if first != reader.line_num:
                raise InputError(
                    f"{where}: {port.name} is already in line {first}; give each port its own name."
                )
            ports.append(port)
    except csv.Error as error:
        raise InputError(
            f"{path.name}, line {reader.line_num}: {error}; check the quotation marks."
        ) from error
    if not ports:
        raise InputError(f"{path.name} has a header but no ports; add lines such as Gdynia,PL,54.516,18.553.")
    return tuple(ports)


def _port(cells: list[str], where: str) -> Port:
    while len(cells) > len(HEADER) and not cells[-1].strip():
        cells.pop()
    if len(cells) != len(HEADER):
        raise InputError(
            f"{where}: {len(cells)} values where {','.join(HEADER)} are needed; put a name that has a comma "
            "into quotation marks."
        )
    name, country = (" ".join(cell.split()) for cell in cells[:2])
    if not name:
        raise InputError(f"{where}: the name is missing.")
    if country and not re.fullmatch(r"[A-Za-z]{2}", country):
        raise InputError(f"{where}: the country {country!r} is not a code of two letters such as PL.")
    lat, lon = (_degrees(text, column, where) for text, column in zip(cells[2:], ("lat", "lon"), strict=True))
    if abs(lat) > 90.0:
        swapped = " (lat and lon swapped?)" if abs(lon) <= 90.0 else ""
        raise InputError(f"{where}: lat {lat:g} is not within -90 and 90{swapped}.")
    if abs(lon) > 180.0:
        raise InputError(f"{where}: lon {lon:g} is not within -180 and 180.")
    if country.upper() in _BALTIC and not _in_baltic(lat, lon) and _in_baltic(lon, lat):
        raise InputError(
            f"{where}: {name} at lat {lat:g}, lon {lon:g} is far from {country.upper()}; lat and lon swapped?"
        )
    return Port(name, country.upper(), lat, lon)


_BALTIC = frozenset(("AX", "DE", "DK", "EE", "FI", "LT", "LV", "PL", "RU", "SE"))


def _in_baltic(lat: float, lon: float) -> bool:
    return 47.0 <= lat <= 71.0 and 5.0 <= lon <= 32.0


def _degrees(text: str, column: str, where: str) -> float:
    text = text.strip()
    value = None if "," in text else parse_number(text)
    if value is not None:
        return value
    example = "54.5167"
    if not text:
        raise InputError(f"{where}: {column} is missing; write degrees such as {example}.")
    if re.search(r"\d.*[°º'′\"″NSEWnsew]|[NSEWnsew]\s*\d|\d\s+\d", text):
        raise InputError(
            f"{where}: {column} {text!r} is in degrees and minutes; write decimal degrees such as {example}."
        )
    raise InputError(f"{where}: {column} {text!r} is not a number; write decimal degrees such as {example}.")


# --- finding -----------------------------------------------------------------------------------------


@lru_cache(maxsize=8)
def _index(ports: tuple[Port, ...]) -> dict[str, tuple[str, ...]]:
    """Of each port's name the ways to type it."""
    foreign: dict[str, list[str]] = {}
    for other, native in _EXONYMS.items():
        foreign.setdefault(native, []).append(other)
    keys = {}
    for port in ports:
        town, bracket, harbour = port.name.partition(" (")
        names = [port.name, *(other + bracket + harbour for other in foreign.get(town, ()))]
        keys[port.name] = tuple(dict.fromkeys(key for name in names for key in folds(name)))
    return keys


def find_port(text: str, ports: Sequence[Port]) -> Port:
    """Find the port that a sailor means, or take a position as it is.

    The whole name as written; else without diacritics, case and hyphens (``Swinoujscie``, ``Aarhus`` or
    ``Århus``, ``Travemuende``, ``Copenhagen``); else the first harbour of a town (``Ronneby``); else the
    only name that begins with, or has a word that begins with, what was typed.

    Parameters
    ----------
    text
        A name, or a position: ``54.5,18.6`` or ``54°31.0'N 018°33.2'E``.

    Raises
    ------
    InputError
        No port, or more than one, has such a name; the sentence offers the closest.
    """
    text = text.strip()
    if not text:
        raise InputError("No port was named; give a name such as Gdynia, or a position such as 54.5,18.6.")
    if (position := parse_position(text)) is not None:
        return Port(format_position(*position), "", *position)
    for port in ports:
        if port.name == text:
            return port
    keys = _index(tuple(ports))
    by_name = {port.name: port for port in ports}
    for name, typed_as in keys.items():
        if same_name(text, (*typed_as, *folds(name.partition(" (")[0]))):
            return by_name[name]
    found = rank_names(text, keys) if any(folds(text)) else []
    if found and (len(found) == 1 or len({name.partition(" (")[0] for name in found}) == 1):
        return by_name[found[0]]
    if found:
        raise InputError(f"More than one port fits {text!r}: {did_you_mean(found[:4])}")
    offer = did_you_mean(suggestions(text, keys))
    raise InputError(
        f"There is no port {text!r}: {offer}"
        if offer
        else f"There is no port {text!r}; see the list of ports, or give a position such as 54.5,18.6."
    )


def search_ports(text: str, ports: Sequence[Port], limit: int = 20) -> list[Port]:
    """Ports that fit what is typed so far, best first; all of them, up to ``limit``, for an empty text."""
    by_name = {port.name: port for port in ports}
    if not folds(text)[0]:
        return list(ports[:limit]) if not text.strip() else []
    return [by_name[name] for name in rank_names(text, _index(tuple(ports)))[:limit]]


# --- positions ---------------------------------------------------------------------------------------

_DECIMAL = re.compile(
    r"\s*([+-]?\d{1,3}(?:\.\d*)?)\s*°?\s*[,; ]\s*([+-]?\d{1,3}(?:\.\d*)?)\s*°?\s*", re.ASCII
)
_NUMBER = r"{}(?:[.,][0-9]*)?"
_PART = re.compile(
    r"(?P<before>[NSEW])?\s*(?P<deg>" + _NUMBER.format("[0-9]{1,3}") + r")\s*[°º]?\s*"
    r"(?:(?P<min>" + _NUMBER.format("[0-9]{1,2}") + r")\s*['′’]?\s*)?"
    r"(?:(?P<sec>" + _NUMBER.format("[0-9]{1,2}") + r")\s*(?:\"|″|''|’’)\s*)?"
    r"(?(before)|(?P<after>[NSEW]))",
    re.IGNORECASE,
)
_BETWEEN = re.compile(r"[\s,;/]*")


def parse_position(text: str) -> tuple[float, float] | None:
    """Read ``LAT,LON`` in decimal degrees, or degrees and minutes (and seconds) with N, S, E or W.

    Returns
    -------
    tuple of float, or None
        Latitude and longitude [degrees]; ``None`` when the text is no position at all, but a name.

    Raises
    ------
    InputError
        It is a position, but not on the earth.
    """
    if match := _DECIMAL.fullmatch(text):
        lat, lon = float(match[1]), float(match[2])
    elif (pair := _sexagesimal(text.strip())) is not None:
        lat, lon = pair
    else:
        return None
    if abs(lat) > 90.0 or abs(lon) > 180.0:
        raise InputError(
            f"The position {text!r} is not on the earth: latitude first, -90 to 90, then longitude, "
            "-180 to 180."
        )
    return lat, lon


def _sexagesimal(text: str) -> tuple[float, float] | None:
    first = _PART.match(text)
    second = _PART.fullmatch(_BETWEEN.sub("", text[first.end() :], count=1)) if first else None
    if first is None or second is None:
        return None
    values: dict[str, float] = {}
    for part in (first, second):
        degrees, minutes, seconds = (
            float((part[unit] or "0").replace(",", ".")) for unit in ("deg", "min", "sec")
        )
        if minutes >= 60.0 or seconds >= 60.0:
            raise InputError(f"The position {text!r} has 60 minutes or seconds, or more; check the figures.")
        value = degrees + minutes / 60.0 + seconds / 3600.0
        hemisphere = (part["before"] or part["after"]).upper()
        values["lat" if hemisphere in "NS" else "lon"] = -value if hemisphere in "SW" else value
    return (values["lat"], values["lon"]) if len(values) == 2 else None
