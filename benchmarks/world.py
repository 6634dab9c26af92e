"""The yacht, the wind, the seas and the passages that all sections measure."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import NDArray

from benchmarks.measure import ROOT, say
from seacruise.geodesy import to_mercator
from seacruise.passage import Options, PassageRequest, sea_between
from seacruise.ports import Port, find_port, load_ports
from seacruise.resources import resource_path
from seacruise.routing.field import COARSE_SLICE_S, Handling, SpeedTable, WindField, speed_table, wind_field
from seacruise.routing.find import How, Question
from seacruise.routing.refine import Waters
from seacruise.sea import Sea
from seacruise.sea.raster import WaterRaster
from seacruise.settings import Settings
from seacruise.weather.files import read_wind_file
from seacruise.weather.practice import practice_wind
from seacruise.weather.sample import sample_wind
from seacruise.weather.wind import Wind
from seacruise.yacht.fleet import find_yacht, load_fleet
from seacruise.yacht.polar import Polar

Position = tuple[float, float]

YACHT: Final = "Bavaria 46 Cruiser"
DEPARTURE: Final = datetime(2016, 11, 20, 6, tzinfo=UTC)

PASSAGES: Final = (
    ("Gdynia", "Stockholm"),
    ("Stockholm", "Gdynia"),
    ("Klaipeda", "Swinoujscie"),
    ("Swinoujscie", "Klaipeda"),
    ("Karlskrona", "Swinoujscie"),
    ("Kiel", "Helsinki"),
    ("Visby", "Ronne"),
    ("Travemunde", "Tallinn"),
)

PRACTICE_BEGINS: Final = datetime(2026, 7, 1, tzinfo=UTC)
"""The same practice weather in every run."""

RELOCATED: Final = ROOT.parent / "shared/data/weather/baltic/RELOCATED_gfs025_120h_to_baltic.nc"

OFF_STOCKHOLM: Final = (58.85, 18.6)
"""Open water before the archipelago: a lattice of one spacing does not reach the harbour behind it."""

PRECISE: Final = How(
    preset="precise", directions=None, spacing_nm=None, area=None, refine=True, handling=Handling()
)


@dataclass(frozen=True, slots=True, eq=False)
class World:
    """What does not change from section to section."""

    settings: Settings
    ports: tuple[Port, ...]
    yacht: Polar
    wind: Wind
    sea: Sea
    leaves: datetime = DEPARTURE

    @property
    def departure(self) -> float:
        """Seconds since 1970."""
        return self.leaves.timestamp()

    def under(self, wind: Wind) -> World:
        """Give the same world in another wind, left six hours after its begin."""
        return replace(self, wind=wind, leaves=wind.forecast.valid_from + timedelta(hours=6))

    @property
    def speeds(self) -> SpeedTable:
        """Table of the yacht's hull, as the search reads it."""
        return speed_table(self.yacht, Handling())

    def field(self, *, fine: bool = False) -> WindField:
        """Cut the wind into slices of time, as the first search has it or as refining has it."""
        if fine:
            return wind_field(self.wind, since=self.departure)
        return wind_field(self.wind, slice_s=COARSE_SLICE_S, since=self.departure)

    def waters(self, sea: Sea) -> Waters:
        """Sea, fine wind and yacht, as refining wants them."""
        return Waters(sea, self.field(fine=True), self.speeds)

    def port(self, name: str) -> Port:
        """Find a port by its name."""
        return find_port(name, self.ports)

    def water_at(self, name: str) -> Position:
        """Position on the water nearest to a port."""
        port = self.port(name)
        snap = self.sea.snap(port.lat, port.lon, name=port.name)
        return snap.lat, snap.lon

    def request(self, start: str, end: str) -> PassageRequest:
        """Ask for a passage between two ports with the default options."""
        return PassageRequest(
            self.port(start), self.port(end), self.yacht, self.wind, self.leaves, options=Options()
        )

    def question(self, start: Position, end: Position, *, sea: Sea | None = None) -> Question:
        """Ask the router itself, between positions on the water."""
        return Question(sea or self.sea, self.wind, self.yacht, PRECISE, start, end, self.departure)


@lru_cache(maxsize=1)
def world() -> World:
    """Read everything once; what is cached on disk stays in ``build/`` unless ``SEACRUISE_HOME`` is set."""
    settings = Settings.from_environment({"SEACRUISE_HOME": home()})
    ports = load_ports()
    yacht = find_yacht(YACHT, load_fleet([resource_path("polars")]))
    sea = sea_between(find_port("Gdynia", ports), find_port("Stockholm", ports), settings)
    return World(settings, ports, yacht, sample_wind(), sea)


def other_winds() -> dict[str, Wind]:
    """Practice weather, and a real forecast moved to the Baltic where the data for tests lies beside us."""
    winds = {"practice": practice_wind(PRACTICE_BEGINS)}
    if RELOCATED.is_file():
        winds["relocated forecast"] = read_wind_file(RELOCATED)
    else:
        say(f"No {RELOCATED.name} in {RELOCATED.parent.name}: its passages are left out.")
    return winds


def home() -> str:
    """Folder for caches: never the user's own."""
    return os.environ.get("SEACRUISE_HOME") or str(ROOT / "build" / "benchmarks")


def open_sea(
    south: float = 53.0, west: float = 12.0, north: float = 62.0, east: float = 26.0, *, cell: float = 900.0
) -> Sea:
    """Make a sea without any land in a rectangle of degrees: for programs that know none."""
    from seacruise.sea import _kernels as k

    (x0, x1), (y0, y1) = (c.tolist() for c in to_mercator([south, north], [west, east]))
    cells = np.full((int((y1 - y0) / cell), int((x1 - x0) / cell)), k.WATER, dtype=np.uint8)
    k.count_free_cells(cells)
    squares = [-(-n // k.BIN) for n in cells.shape]
    first = np.zeros(squares[0] * squares[1] + 1, np.int64)
    shores: NDArray[np.float32] = np.empty((0, 4), np.float32)
    for part in (cells, first, shores):
        # Kernels are compiled for arrays that cannot be written, as the cache maps them.
        part.setflags(write=False)
    return Sea(WaterRaster(x0, y0, cell, cells, first, shores))
