"""Make ports.csv and docs/ports.md: ``python tools/make_ports.py DATA``.

DATA is a folder that holds ``ports`` and ``coast``. Its yacht harbours are named as a sailor types them, held
against two lists of commercial ports and against the coast of OpenStreetMap, and corrected where they were
wrong.
"""

from __future__ import annotations

import csv
import sys
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy import ndimage

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from seacruise.geodesy import great_circle_m  # noqa: E402
from seacruise.text import folds  # noqa: E402
from seacruise.units import METRES_PER_NM  # noqa: E402

# Names of the source that a sailor would not type: the town's own name goes to its first harbour.
NAMES = {
    "Gdynia (Marina Gdynia)": "Gdynia",
    "Sopot (Marina Sopot)": "Sopot",
    "Gdańsk (Marina Gdańsk, Motława)": "Gdańsk",
    "Darłowo (Darłówko)": "Darłowo",
    "Świnoujście (Basen Północny)": "Świnoujście",
    "Kaliningrad (Baltiysk)": "Baltiysk",
    "Klaipėda (Smiltynė / Pilies)": "Klaipėda",
    "Jūrmala (Lielupe)": "Jūrmala",
    "Rīga (Andrejosta)": "Rīga",
    "Ruhnu (Ringsu)": "Ruhnu",
    "Veere (Saaremaa)": "Veere",
    "Haapsalu (Grand Holm)": "Haapsalu",
    "Tallinn (Old City Marina)": "Tallinn",
    "St Petersburg (Kronstadt)": "Sankt-Peterburg (Kronshtadt)",
    "Helsinki (NJK Blekholmen)": "Helsinki",
    "Helsinki (HSK Katajanokka)": "Helsinki (Katajanokka)",
    "Kotka (Sapokka)": "Kotka",
    "Hanko (Itäsatama)": "Hanko",
    "Ekenäs (Tammisaari)": "Tammisaari",
    "Nagu (Nauvo)": "Nagu",
    "Utö (FI)": "Utö (Finland)",
    "Mariehamn (ÅSS Västerhamn)": "Mariehamn",
    "Mariehamn (Österhamn MSF)": "Mariehamn (Österhamn)",
    "Kökar (Sandvik)": "Kökar",
    "Rauma (Syväraumanlahti)": "Rauma",
    "Pori (Reposaari)": "Pori",
    "Umeå (Patholmsviken)": "Umeå",
    "Sandhamn (KSSS)": "Sandhamn",
    "Stockholm (Wasahamnen)": "Stockholm",
    "Utö (SE, Gruvbryggan)": "Utö (Sverige)",
    "Ronneby (Ekenäs)": "Ronneby",
    "Trelleborg (Gislöv)": "Trelleborg",
    "Malmö (Limhamn)": "Malmö",
    "Landskrona (Borstahusen)": "Landskrona",
    "Helsingborg (Norra hamnen)": "Helsingborg",
    "Göteborg (Långedrag)": "Göteborg",
    "Læsø (Vesterø)": "Læsø",
    "Samsø (Ballen)": "Samsø",
    "Copenhagen (Svanemøllen)": "København",
    "Copenhagen (Margretheholm)": "København (Margretheholm)",
    "Rønne (Nørrekås)": "Rønne",
    "Kiel (Düsternbrook)": "Kiel",
    "Burgtiefe (Fehmarn)": "Burgtiefe",
    "Timmendorf (Poel)": "Timmendorf",
    "Warnemünde (Hohe Düne)": "Warnemünde",
    "Darßer Ort (Nothafen)": "Darßer Ort",
    "Lauterbach (Rügen)": "Lauterbach",
}

# Source name: position, and what says that the source was wrong.
CORRECTIONS = {
    "Veere (Saaremaa)": (
        58.4550, 22.0510, "was 0.9 nm inland; the village, now Veeremäe, is on the coast at 58°28'N 22°03'E"
    ),
}  # fmt: skip

# Town harbours that the source lacks and both lists of commercial ports have: name, country, WPI, searoute.
ADDITIONS = (
    ("Horsens", "DK", "Horsens", "Horsens"),
    ("Korsør", "DK", "Korsor", "Korsoer"),
    ("Nakskov", "DK", "Nakskov", "Nakskov"),
    ("Bandholm", "DK", "Bandholm", "Bandholm"),
    ("Fakse Ladeplads", "DK", "Fakse Ladeplads Havn", "Fakse Ladeplads"),
    ("Stubbekøbing", "DK", "Stubbekobing", "Stubbekobing"),
    ("Vejle", "DK", "Vejle", "Vejle"),
    ("Aalborg", "DK", "Alborg", "Aalborg"),
    ("Aabenraa", "DK", "Abenra", "Aabenraa"),
    ("Orth", "DE", "Orth", "Orth"),
    ("Lübeck", "DE", "Lubeck", "Lubeck"),
    ("Höganäs", "SE", "Hoganas", "Hoganas"),
    ("Sölvesborg", "SE", "Solvesborg", "Solvesborg"),
    ("Bergkvara", "SE", "Bergkvara", "Bergkvara"),
    ("Degerhamn", "SE", "Degerhamn", "Degerhamn"),
    ("Klintehamn", "SE", "Klintehamn", "Klintehamn"),
    ("Nyköping", "SE", "Nykoping", "Nykoping"),
    ("Norrköping", "SE", "Norrkoping", "Norrkoping"),
    ("Örnsköldsvik", "SE", "Ornskoldsvik", "Ornskoldsvik"),
    ("Skelleftehamn", "SE", "Skelleftehamn", "Skelleftehamn"),
    ("Pietarsaari", "FI", "Pietarsaari", "Jakobstad"),
    ("Kaskinen", "FI", "Kaskinen", "Kaskinen"),
    ("Kemi", "FI", "Kemi", "Kemi"),
    ("Rohuküla", "EE", "Rohukula", "Rohukula"),
)  # fmt: skip

# The same place under another name in the lists of commercial ports.
ALSO = {
    "Baltiysk": ("Baltiysk",),
    "Sankt-Peterburg (Kronshtadt)": ("Kronshtadt",),
    "Tallinn": ("Vanasadam - Port of Tallinn",),
    "Pärnu": ("Pyarnu",),
    "Tammisaari": ("Ekenas",),
    "Umeå": ("Umea Hamn",),
    "Malmö": ("Limhamn",),
    "Grenå": ("Grenaa Havn", "Grenaa"),
    "Skagen": ("Skagen Havn",),
    "Rødbyhavn": ("Rodby Havn",),
    "København": ("Tuborg",),
    "København (Margretheholm)": ("Kobenhavn",),
    "Helsingør": ("Elsinore",),
    "Nexø": ("Nekso",),
    "Christiansø": ("Christianso Harbor",),
    "Neustadt in Holstein": ("Neustadt", "Neustadt/Holstein"),
    "Travemünde": ("Lubeck-Travemunde",),
    "Warnemünde": ("Rostock",),
    "Strömstad": ("Stroemstad",),
    "Korsør": ("Korsoer",),
    "Aalborg": ("Alborg",),
    "Aabenraa": ("Abenra",),
    "Pietarsaari": ("Jakobstad",),
    "Fakse Ladeplads": ("Fakse Ladeplads Havn",),
}

COMMERCIAL = "position of the commercial port"
REACH_NM = 5.0
CONFIRMED_NM = 1.0

Place = tuple[str, float, float]


@dataclass(frozen=True)
class Harbour:
    """A line of ports.csv and how it was checked."""

    name: str
    country: str
    lat: float
    lon: float
    detail: str
    note: str
    wpi_nm: float | None
    searoute_nm: float | None
    water_nm: float

    @property
    def nearest_nm(self) -> float | None:
        """Distance to the nearer of the two places of the same name [nm]."""
        return min((nm for nm in (self.wpi_nm, self.searoute_nm) if nm is not None), default=None)


class Water:
    """Water of the OpenStreetMap coast that is connected with the open Baltic."""

    def __init__(self, path: Path) -> None:
        data = np.load(path)
        rows, columns = (int(n) for n in data["shape"])
        water = np.unpackbits(data["water"])[: rows * columns].reshape(rows, columns)
        labels, _ = ndimage.label(water)
        self.west, self.north = float(data["lon0"]), float(data["lat0"])
        self.dlon, self.dlat = float(data["dlon"]), float(data["dlat"])
        row, column = self._cell(55.5, 18.0)
        self.main = labels == labels[row, column]

    def _cell(self, lat: float, lon: float) -> tuple[int, int]:
        return int((self.north - lat) / self.dlat), int((lon - self.west) / self.dlon)

    def distance_nm(self, lat: float, lon: float) -> float:
        """Distance to water [nm]; not a number beyond some 15 nm."""
        row, column = self._cell(lat, lon)
        top, left = max(row - 200, 0), max(column - 200, 0)
        near = self.main[top : row + 200, left : column + 200]
        rows, columns = np.nonzero(near)
        lats = self.north - (rows + top + 0.5) * self.dlat
        lons = self.west + (columns + left + 0.5) * self.dlon
        return (
            float(great_circle_m(lat, lon, lats, lons).min()) / METRES_PER_NM if len(rows) else float("nan")
        )


def nearest(name: str, lat: float, lon: float, places: list[Place]) -> float | None:
    """Distance [nm] to the place of the same name, within reach."""
    wanted = {key for n in (name.partition(" (")[0], *ALSO.get(name, ())) for key in folds(n)}
    found = [
        float(great_circle_m(lat, lon, p[1], p[2])) / METRES_PER_NM
        for p in places
        if wanted.intersection(folds(p[0]))
    ]
    return min((nm for nm in found if nm <= REACH_NM), default=None)


def read_places(path: Path, name: str, lat: str, lon: str) -> list[Place]:
    """Names and positions of a list of ports, by the names of its columns."""
    with path.open(encoding="utf-8-sig", newline="") as file:
        return [(row[name], float(row[lat]), float(row[lon])) for row in csv.DictReader(file)]


def harbours(data: Path) -> list[Harbour]:
    """Name, correct, add and check."""
    wpi = read_places(data / "ports/wpi_baltic.csv", "Main Port Name", "Latitude", "Longitude")
    searoute = read_places(data / "ports/searoute_baltic.csv", "name", "lat", "lon")
    water = Water(data / "coast/osm_water_0025x00125_baltic.npz")
    found = []

    def add(name: str, country: str, position: tuple[float, float], *, detail: str, note: str) -> None:
        lat, lon = position
        checks = nearest(name, lat, lon, wpi), nearest(name, lat, lon, searoute)
        found.append(Harbour(name, country, lat, lon, detail, note, *checks, water.distance_nm(lat, lon)))

    with (data / "ports/baltic_yacht_ports.csv").open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file, delimiter=";"):
            source, lat, lon, note = row["name"], float(row["lat"]), float(row["lon"]), ""
            if source in CORRECTIONS:
                lat, lon, note = CORRECTIONS[source]
            name = NAMES.get(source, source)
            detail = source.partition(" (")[2].rstrip(")") if name != source else ""
            add(name, row["country"], (lat, lon), detail=detail, note=note)
    by_name = {place[0]: place for place in searoute}
    for name, country, _, other in ADDITIONS:
        _, lat, lon = by_name[other]
        add(name, country, (round(lat, 4), round(lon, 4)), detail="town harbour", note=COMMERCIAL)
    # The harbours of a town stand together, the one that has the town's own name first.
    towns = [h.name.partition(" (")[0] for h in found]
    return sorted(found, key=lambda h: (towns.index(h.name.partition(" (")[0]), "(" in h.name))


def write_ports(found: list[Harbour], path: Path) -> None:
    """Write ports.csv."""
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("name", "country", "lat", "lon"))
        writer.writerows((h.name, h.country, f"{h.lat:.4f}", f"{h.lon:.4f}") for h in found)


def verdict(harbour: Harbour) -> str:
    """Say what the checks amount to; a position taken from a list is not confirmed by that list."""
    if harbour.note == COMMERCIAL:
        return "commercial port"
    nm = harbour.nearest_nm
    if nm is not None and nm <= CONFIRMED_NM:
        return "confirmed"
    if nm is not None:
        return "another basin of the same town"
    return "coast only"


INTRODUCTION = """\
# Ports

`ports.csv` has {count} harbours that yachts use, {countries}.
**A position is that of the harbour, to about 0.3 nm, and is not surveyed: it is where a passage is planned
to, never what to steer for.** Planning starts and ends on open water nearby, and the passage says how far
that is from the port.

Origin:

- names and positions: our own list of yacht harbours, made from general knowledge;
- {additions} town harbours that it lacked: positions of the commercial port from the list of ports of the
  package searoute (Apache-2.0);
- checks: the World Port Index of the National Geospatial-Intelligence Agency (public domain), the ports of
  searoute, and the coast of OpenStreetMap (ODbL, © OpenStreetMap contributors).

How each was checked: *WPI* and *searoute* are distances [nm] to the commercial port of the same name there,
within {reach:g} nm; *water* is the distance to water that the coast of OpenStreetMap connects with the open
sea (cells of 150 m). *Confirmed* means that a second source has the place within {confirmed:g} nm, which is
so for {n_confirmed}; {n_basin} lie in another basin than the town's commercial port; {n_coast} are in no
second list and stand on the coast alone; {n_added} have the commercial port's position, and both lists agree
on it within {agree:.2f} nm (where they agree to 0.00 both give whole arc minutes, from the same origin, good
to half a mile). A large distance to water is a river, canal or lagoon that this coast closes:
Szczecin and its lagoon, Lübeck, Rīga, Gdańsk, Kappeln.

Corrected:

{corrections}

Not in the list, because nobody could check them: approaches, depths, opening hours, bridges.

| port | harbour | lat | lon | WPI | searoute | water | check |
|---|---|---|---|---|---|---|---|
"""


def write_page(found: list[Harbour], path: Path) -> None:
    """Write the page with the checks."""
    verdicts = Counter(verdict(h) for h in found)
    countries = Counter(h.country for h in found)
    fixed = [(NAMES.get(source, source), c[2]) for source, c in CORRECTIONS.items()]
    lines = [
        INTRODUCTION.format(
            count=len(found),
            countries=", ".join(f"{country} {n}" for country, n in countries.most_common()),
            additions=len(ADDITIONS),
            reach=REACH_NM,
            confirmed=CONFIRMED_NM,
            n_confirmed=verdicts["confirmed"],
            n_basin=verdicts["another basin of the same town"],
            n_coast=verdicts["coast only"],
            n_added=verdicts["commercial port"],
            agree=max(h.wpi_nm for h in found if h.note == COMMERCIAL and h.wpi_nm is not None),
            corrections="\n".join(f"- {name}: {why}." for name, why in fixed),
        ).rstrip("\n")
    ]
    for h in found:
        distances = ("-" if nm is None else f"{nm:.2f}" for nm in (h.wpi_nm, h.searoute_nm))
        far = "> 15" if np.isnan(h.water_nm) else f"{h.water_nm:.2f}"
        lines.append(
            f"| {h.name} | {h.detail or '-'} | {h.lat:.4f} | {h.lon:.4f} | {' | '.join(distances)} | {far} "
            f"| {verdict(h)} |"
        )
    path.write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


def main(data: Path) -> None:
    """Write both and tell which harbours are far from water."""
    found = harbours(data)
    write_ports(found, ROOT / "ports.csv")
    write_page(found, ROOT / "docs/ports.md")
    print(f"{len(found)} ports; far from water:")
    for h in sorted(found, key=lambda h: -np.nan_to_num(h.water_nm, nan=99.0))[:25]:
        print(f"  {h.name:28} {h.water_nm:.2f}")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
