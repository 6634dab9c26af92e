"""Seas, winds, yachts and lattices made by hand, small enough to reason about."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import from_mercator, scale, to_mercator
from seacruise.progress import Job
from seacruise.routing.field import PER_TWS, Handling, SpeedTable, WindField
from seacruise.routing.find import Fastest, Finder, How, Ledger, Question
from seacruise.routing.lattice import Lattice
from seacruise.routing.search import PIECE_M
from seacruise.sea import Sea
from seacruise.sea.raster import WaterRaster
from seacruise.units import METRES_PER_NM, MS_PER_KNOT
from seacruise.weather.wind import Current, Forecast, Wind, from_direction
from seacruise.yacht.polar import Polar

Array = NDArray[np.float64]

DEPARTURE = datetime(2016, 11, 20, 6, tzinfo=UTC)
T0 = DEPARTURE.timestamp()
HOUR = 3600.0
DAY = 86_400.0

PRECISE = How(preset="precise", directions=None, spacing_nm=None, area=None, refine=True, handling=Handling())


def open_sea(
    south: float = 53.0, west: float = 14.0, north: float = 61.0, east: float = 26.0, *, cell: float = 900.0
) -> Sea:
    """Make a sea without any land in a rectangle of degrees."""
    return Sea(raster_of(south, west, north, east, cell=cell))


def raster_of(
    south: float, west: float, north: float, east: float, *, cell: float, land: Array | None = None
) -> WaterRaster:
    """Water everywhere but in rectangles of land ``(n, 4)``: south, west, north, east [degrees]."""
    from seacruise.sea import _kernels as k

    (x0, x1), (y0, y1) = (c.tolist() for c in to_mercator([south, north], [west, east]))
    cells = np.full((int((y1 - y0) / cell), int((x1 - x0) / cell)), k.WATER, dtype=np.uint8)
    for block in np.empty((0, 4)) if land is None else land:
        (bx0, bx1), (by0, by1) = (c.tolist() for c in to_mercator(block[[0, 2]], block[[1, 3]]))
        rows = slice(max(0, int((by0 - y0) / cell)), max(0, int((by1 - y0) / cell)))
        cells[rows, max(0, int((bx0 - x0) / cell)) : max(0, int((bx1 - x0) / cell))] = k.LAND
    k.count_free_cells(cells)
    squares = [-(-n // k.BIN) for n in cells.shape]
    first, shores = np.zeros(squares[0] * squares[1] + 1, np.int64), np.empty((0, 4), np.float32)
    for part in (cells, first, shores):
        # Kernels are compiled for arrays that cannot be written, as the cache maps them.
        part.setflags(write=False)
    return WaterRaster(x0, y0, cell, cells, first, shores)


def forecast(begin: float, end: float) -> Forecast:
    since, until = (datetime.fromtimestamp(t, UTC) for t in (begin, end))
    return Forecast("Made by hand", None, since, until, step_h=1.0, resolution_deg=1.0)


def wind_of(time: Any, lat: Any, speed: Any, direction_deg: Any) -> Wind:
    """Make a wind that changes with time and latitude only; ``speed`` [m/s] and direction broadcast."""
    time, lat = np.atleast_1d(np.asarray(time, float)), np.atleast_1d(np.asarray(lat, float))
    shape = (time.size, lat.size, 1)
    u, v = from_direction(np.broadcast_to(speed, shape), np.broadcast_to(direction_deg, shape))
    return Wind(
        time,
        lat,
        np.array([18.0]),
        u.astype(np.float32),
        v.astype(np.float32),
        forecast(float(time[0]), float(time[-1])),
    )


def steady_wind(speed_kn: float, direction_deg: float, *, days: float = 10.0) -> Wind:
    """Make one wind everywhere and all the time."""
    begin = T0 - 6 * HOUR
    return wind_of([begin, begin + days * DAY], [57.0], speed_kn * MS_PER_KNOT, direction_deg)


def drifter() -> Polar:
    """Make a yacht that sails at the speed of the wind on every course: time becomes distance or optics."""
    tws, twa = np.arange(1.0, 41.0), np.arange(0.0, 181.0, 15.0)
    return Polar("Drifter", tws, twa, np.broadcast_to(tws, (twa.size, tws.size)))


SLOOP_TWA = np.array([42.0, 52.0, 60.0, 75.0, 90.0, 110.0, 120.0, 135.0, 150.0, 165.0, 180.0])
SLOOP_SHARE = np.array([0.40, 0.47, 0.51, 0.55, 0.57, 0.60, 0.59, 0.56, 0.50, 0.44, 0.41])


def sloop() -> Polar:
    """Make a yacht with a dead angle and slow runs, as fast as the wind is strong: a polar that scales."""
    tws = np.arange(1.0, 31.0)
    return Polar("Sloop", tws, SLOOP_TWA, SLOOP_SHARE[:, None] * tws[None, :])


def question(
    sea: Sea,
    wind: Wind,
    polar: Polar,
    start: tuple[float, float],
    end: tuple[float, float],
    *,
    how: How = PRECISE,
    departure: float = T0,
    current: Current | None = None,
) -> Question:
    return Question(sea, wind, polar, how, start, end, departure, current=current)


def fastest(asked: Question) -> Fastest:
    return Finder().fastest(asked, job=Job(), ledger=Ledger())


# ---------------------------------------------------------------------- lattices, winds, tables at random


def lattice_of(x: Array, y: Array, edges: list[tuple[int, int]], *, start: int, end: int) -> Lattice:
    """Pack vertices of the Mercator plane [m] and edges into a `Lattice`."""
    n = x.size
    rows: list[list[int]] = [[] for _ in range(n)]
    for a, b in edges:
        rows[a].append(b)
    first = np.concatenate([[0], np.cumsum([len(r) for r in rows])]).astype(np.int64)
    target = np.array([b for row in rows for b in row], dtype=np.int32)
    lat, lon = from_mercator(x, y)
    return Lattice(x, y, lat, lon, scale(lat), first, target, start, end, 1.0)


def random_edges(
    rng: np.random.Generator, n: int, out_degree: int, *, both_ways: bool = False
) -> list[tuple[int, int]]:
    pairs = {
        (a, int(b))
        for a in range(n)
        for b in rng.choice(n, size=min(n, out_degree), replace=False)
        if a != int(b)
    }
    return sorted(pairs | {(b, a) for a, b in pairs} if both_ways else pairs)


def random_lattice(
    rng: np.random.Generator, n: int, *, out_degree: int = 4, size_nm: float = 80.0
) -> Lattice:
    """Scatter vertices over a square of the sea, some at the same place, and join them at random."""
    x0, y0 = (float(c) for c in to_mercator(57.0, 18.0))
    side = size_nm * METRES_PER_NM / float(scale(57.0))
    x, y = x0 + rng.uniform(0, side, n), y0 + rng.uniform(0, side, n)
    if rng.random() < 0.3:
        x[n // 2], y[n // 2] = x[0], y[0]
    return lattice_of(x, y, random_edges(rng, n, out_degree), start=n - 2, end=n - 1)


def random_field(rng: np.random.Generator, *, slices: int = 12, step: float = HOUR) -> WindField:
    """Make winds that jump from slice to slice, with calms that may last; few slices end under way."""
    u, v = rng.uniform(-9, 9, (2, slices, 3, 4)).astype(np.float32)
    calm = rng.random(slices) < 0.3
    if rng.random() < 0.8:
        calm[-1] = False
    u[calm], v[calm] = 0.0, 0.0
    tws = np.hypot(u.astype(np.float64), v.astype(np.float64))
    arrays = (u, v, T0, step, 56.5, 1.0, 17.5, 1.0)
    return WindField(arrays, T0 + (slices - 1) * step, float(tws.max()), float(tws.mean()))


def random_table(
    rng: np.random.Generator, *, limits: bool = False, dead: bool = True, top_ms: float = 14.0
) -> SpeedTable:
    """Make a speed for every wind and angle that owes nothing to any yacht; zero in a calm."""
    rows, columns = int(top_ms * PER_TWS) + 2, 17
    table = rng.uniform(0.3, 8.0, (rows, columns))
    if dead:
        table[:, int(rng.integers(11, 17)) :] = 0.0
    table[0] = 0.0
    return table_of(table, limit_row=int(rng.integers(20, rows)) if limits else None)


def table_of(table: Array, *, limit_row: int | None = None) -> SpeedTable:
    top = np.maximum.accumulate(table.max(axis=1))
    table = table.copy()
    if limit_row is not None:
        table[limit_row:] = -1.0
    return SpeedTable((np.ascontiguousarray(table, dtype=np.float32), PER_TWS), top)


def cache_dir_of(base: Path) -> Path:
    """Folder for the rasters of the sea that all tests of a session share: drawing the Baltic takes 1 s."""
    return base / "shared-sea"


def holds_backwards(lattice: Lattice, field: WindField, speeds: SpeedTable, leave: float) -> None:
    """Check that the edge from vertex 0 to 1 is the same sailed backwards, left at a time [s since 1970]."""
    from seacruise.routing import _backwards, _kernels

    world = lattice.points, PIECE_M, field.arrays, speeds.arrays
    there = _kernels.edge_arrival(leave, 0, 1, *world)
    if not np.isfinite(there):
        return
    # As late as one may: a calm at the begin of the edge lets her leave later for the same arrival.
    back = _backwards.edge_departure(there + 0.01, 0, 1, *world)
    assert back >= leave - 0.1
    assert _kernels.edge_arrival(back, 0, 1, *world) <= there + 0.01
