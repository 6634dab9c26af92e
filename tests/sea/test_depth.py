"""The chart's coarse depths and its coarse coast: what they say, and that they say no more."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from seacruise.passage import Options, PassageRequest, plan
from seacruise.ports import Port
from seacruise.resources import resource_path
from seacruise.sea.coast import FINE_EAST, FINE_WEST, roughly_ashore, world_land
from seacruise.sea.depth import BAND_LIMITS_M, Depths, chart_depths
from seacruise.sea.globe import CELLS_PER_DEGREE, read_land
from seacruise.settings import Settings
from seacruise.yacht.fleet import find_yacht, load_fleet
from tests.routing.worlds import DEPARTURE, steady_wind


@pytest.mark.parametrize(
    ("place", "lat", "lon", "band"),
    [
        ("Landsort Deep, 459 m", 58.60, 18.25, 4),
        ("Gotland Deep, 249 m", 57.30, 20.05, 4),
        ("Bornholm Basin, 95 m", 55.30, 15.90, 2),
        ("Kattegat, 20 m", 56.80, 11.50, 0),
        ("Fehmarn Belt, 25 m", 54.60, 11.30, 0),
        ("Skåne", 56.00, 14.00, None),
        ("the North Sea, beyond the grid", 56.00, 5.00, None),
    ],
)
def test_bands_where_depths_are_known(place: str, lat: float, lon: float, band: int | None) -> None:
    assert chart_depths().band(lat, lon) == band, place


def test_the_asset_is_the_relief_to_its_step(shared_data: Path) -> None:
    netcdf = pytest.importorskip("netCDF4")
    with netcdf.Dataset(shared_data / "bathymetry" / "etopo5_baltic.nc") as data:
        height = np.asarray(data["elevation"][:], dtype=np.float64)
    metres = chart_depths().metres
    assert metres.shape == height.shape
    assert np.abs(metres - np.clip(-height, -5.0, 300.0)).max() <= 1.0


def test_nothing_tells_more_than_a_band() -> None:
    """No node lies on the edge of a band, and none keeps a depth to the metre."""
    metres = chart_depths().metres
    assert not np.isin(metres, BAND_LIMITS_M).any()
    assert len(np.unique(metres)) < 160


def test_the_assets_are_small() -> None:
    assert resource_path("assets/depth/etopo5.npz").stat().st_size < 60_000
    assert resource_path("assets/coast/world.npz").stat().st_size < 300_000


@given(
    st.floats(-3.0, 3.0),
    st.floats(-3.0, 3.0),
    st.lists(st.floats(1.0, 7.0), min_size=1, max_size=5),
    st.lists(st.floats(11.0, 17.0), min_size=1, max_size=4),
)
def test_a_slope_is_kept_as_it_is(a: float, b: float, lat: list[float], lon: list[float]) -> None:
    rows, columns = np.arange(9.0), np.arange(10.0, 19.0)
    slope = Depths(a * rows[:, None] + b * columns[None, :], 0.0, 10.0, 8.0, 18.0)
    found = slope.on(np.array(lat), np.array(lon))
    assert found.shape == (len(lat), len(lon))
    assert found == pytest.approx(a * np.array(lat)[:, None] + b * np.array(lon)[None, :], abs=1e-9)


@given(st.floats(-89.0, 89.0), st.floats(-179.0, 179.0))
def test_between_nodes_nothing_is_deeper_than_the_deepest(lat: float, lon: float) -> None:
    depths = chart_depths()
    found = float(depths.on(np.array([lat]), np.array([lon]))[0, 0])
    assert depths.metres.min() - 1e-9 <= found <= depths.metres.max() + 1e-9


# --- the world ---------------------------------------------------------------------------------------------


def test_the_coarse_coast_is_the_land_that_routing_knows() -> None:
    """Western Mediterranean: the thinned shores against the 1 km mask they were made from."""
    south, west, north, east = 35, -2, 44, 12
    land = read_land(south, west, north, east)
    polygons = shapely.union_all([shapely.make_valid(shapely.Polygon(p[0], p[1:])) for p in world_land()])
    shapely.prepare(polygons)
    rows, columns = np.mgrid[5 : land.shape[0] : 13, 5 : land.shape[1] : 13]
    lat = north - (rows + 0.5) / CELLS_PER_DEGREE
    lon = west + (columns + 0.5) / CELLS_PER_DEGREE
    drawn = shapely.contains_xy(polygons, lon, lat)
    assert (drawn == land[rows, columns]).mean() > 0.985
    raster = roughly_ashore(lat.ravel(), lon.ravel()).reshape(lat.shape)
    assert (raster == land[rows, columns]).mean() > 0.96


@pytest.mark.parametrize(
    ("place", "lat", "lon", "ashore"),
    [
        ("Mallorca", 39.60, 3.00, True),
        ("off Mallorca", 39.00, 4.00, False),
        ("mid-Atlantic", 40.00, -40.00, False),
        ("Tasmania", -42.00, 146.50, True),
        ("Germany, south of the depths", 52.40, 12.00, True),
        ("Gotland", 57.40, 18.50, True),
        ("east of Gotland", 57.40, 19.50, False),
    ],
)
def test_barbs_know_land_roughly(place: str, lat: float, lon: float, ashore: bool) -> None:
    assert bool(chart_depths().ashore(np.array([lat]), np.array([lon]))[0]) == ashore, place


def test_a_passage_elsewhere_says_how_coarse_the_coast_is(settings: Settings) -> None:
    yacht = find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")]))
    options = Options(spacing_nm=6.0, refine=False)
    wind = steady_wind(14.0, 300.0)

    def notices(start: Port, end: Port) -> str:
        return " ".join(
            plan(PassageRequest(start, end, yacht, wind, DEPARTURE, options), settings=settings).notices
        )

    assert "known to 1 km only" in notices(Port("A", "", 39.40, 3.40), Port("B", "", 39.90, 4.40))
    assert "known to 1 km only" not in notices(Port("A", "", 56.00, 18.00), Port("B", "", 56.40, 18.60))


def test_the_depths_end_where_the_fine_coast_ends() -> None:
    depths = chart_depths()
    assert (depths.south, depths.west, depths.north) == (53.0, FINE_WEST, 66.0)
    assert FINE_EAST - depths.east < 0.1
