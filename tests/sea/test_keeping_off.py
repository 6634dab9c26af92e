"""Keeping off the shore: what of the sea is left, and what stays open for the ports."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from seacruise.geodesy import from_mercator, scale, to_mercator
from seacruise.sea import Sea
from seacruise.units import METRES_PER_NM
from tests.routing.worlds import raster_of

Array = NDArray[np.float64]

CELL_M = 500.0
SOUTH, WEST, NORTH, EAST = 56.0, 17.0, 57.5, 19.5
ISLAND = np.array([[56.6, 18.0, 56.8, 18.4]])
PORT = (56.59, 18.2)
"""Half a mile south of the island."""


def sea_with(*blocks: Array) -> Sea:
    land = np.vstack(blocks) if blocks else None
    return Sea(raster_of(SOUTH, WEST, NORTH, EAST, cell=CELL_M, land=land))


def room_m(land: Array, lat: Array, lon: Array) -> Array:
    """Distances [m, true] to rectangles of land and to the rim of the world, by shapely."""
    (x0, x1), (y0, y1) = to_mercator([SOUTH, NORTH], [WEST, EAST])
    # Rows and columns of cells that are not whole belong to no raster.
    x1, y1 = x0 + (x1 - x0) // CELL_M * CELL_M, y0 + (y1 - y0) // CELL_M * CELL_M
    boxes = []
    for block in land:
        (bx0, bx1), (by0, by1) = to_mercator(block[[0, 2]], block[[1, 3]])
        columns = [x0 + math.floor((bx - x0) / CELL_M) * CELL_M for bx in (bx0, bx1)]
        rows = [y0 + math.floor((by - y0) / CELL_M) * CELL_M for by in (by0, by1)]
        boxes.append(shapely.box(columns[0], rows[0], columns[1], rows[1]))
    rim = shapely.box(x0, y0, x1, y1).exterior
    shores = shapely.union_all([*boxes, rim])
    points = shapely.points(*to_mercator(lat, lon))
    return np.asarray(shapely.distance(points, shores) * scale(lat))


def anywhere(rng: np.random.Generator, n: int) -> tuple[Array, Array]:
    return rng.uniform(SOUTH + 0.02, NORTH - 0.02, n), rng.uniform(WEST + 0.02, EAST - 0.02, n)


@hypothesis_settings(max_examples=20)
@given(distance_nm=st.floats(0.3, 12.0), seed=st.integers(0, 2**32 - 1))
def test_water_is_what_is_far_enough_from_every_shore(distance_nm: float, seed: int) -> None:
    sea, distance = sea_with(ISLAND), distance_nm * METRES_PER_NM
    lat, lon = anywhere(np.random.default_rng(seed), 3000)
    kept, room = sea.keeping_off(distance, ()).is_water(lat, lon), room_m(ISLAND, lat, lon)
    cell = CELL_M * scale(lat)
    assert (room[kept] >= distance - 1.0).all()
    # Distances are those of cells, counted over corners too: all beyond root two of it, and two cells, stays.
    assert kept[room > math.sqrt(2.0) * (distance + 2.0 * cell)].all()


@hypothesis_settings(max_examples=20)
@given(nearer=st.floats(0.3, 6.0), further=st.floats(0.0, 6.0))
def test_the_farther_off_the_less_water(nearer: float, further: float) -> None:
    sea = sea_with(ISLAND)
    lat, lon = anywhere(np.random.default_rng(3), 2000)
    wide, narrow = (
        sea.keeping_off(d * METRES_PER_NM, ()).is_water(lat, lon) for d in (nearer, nearer + further)
    )
    assert not (narrow & ~wide).any()
    assert not (wide & ~sea.is_water(lat, lon)).any()


def test_the_way_out_of_a_port_stays_open_and_other_shores_do_not() -> None:
    sea, distance = sea_with(ISLAND), 4.0 * METRES_PER_NM
    kept = sea.keeping_off(distance, (PORT,))
    assert not sea.keeping_off(distance, ()).is_water(*PORT)
    assert kept.is_water(*PORT)
    out = (56.4, 18.2)
    x, y = to_mercator([PORT[0], out[0]], [PORT[1], out[1]])
    assert kept.clear(np.array([[x[0], y[0], x[1], y[1]]]))[0]
    # Two miles off the northern shore is as near as two miles off the port, but no way out.
    assert not kept.is_water(56.8 + 2 / 60, 18.2)


def test_a_port_on_a_long_coast_leads_straight_out_and_not_along_it() -> None:
    """Ways out by all sectors of the compass would leave the whole coast open."""
    coast = np.array([[56.0, 17.0, 57.5, 17.8]])
    port = (56.75, 17.83)
    kept = sea_with(coast).keeping_off(4.0 * METRES_PER_NM, (port,))
    along = np.arange(56.2, 57.3, 0.01)
    beside = kept.is_water(along, np.full(along.size, 17.83))
    assert beside[np.abs(along - port[0]) < 0.5 / 60.0].all()
    assert not beside[np.abs(along - port[0]) > 3.0 / 60.0].any()


def test_out_of_a_pond_behind_narrows_the_way_leads_on() -> None:
    """A bay five miles wide behind a gap of one: two miles off her shores there is water, but no sea."""
    bay = [[56.5, 17.0, 56.6, 19.5], [56.6, 17.0, 56.7, 18.0], [56.6, 18.2, 56.7, 19.5]]
    gap = [[56.7, 17.0, 56.72, 18.085], [56.7, 18.115, 56.72, 19.5]]
    sea = sea_with(np.array(bay + gap))
    port, outside = (56.61, 18.1), (57.1, 18.1)
    x, y = to_mercator([port[0], outside[0]], [port[1], outside[1]])
    through = np.array([[x[0], y[0], x[1], y[1]]])
    assert sea.clear(through)[0]
    assert not sea.keeping_off(1.5 * METRES_PER_NM, ()).clear(through)[0]
    assert sea.keeping_off(1.5 * METRES_PER_NM, (port, outside)).clear(through)[0]


def test_ports_on_a_sea_of_their_own_need_not_reach_the_largest_one() -> None:
    """A wall with a gap that is too narrow to keep off: most water lies south of it, both ports north."""
    sea = sea_with(np.array([[56.9, 17.0, 56.92, 18.0], [56.9, 18.02, 56.92, 19.5]]))
    ports = (57.45, 17.5), (57.45, 19.0)
    kept = sea.keeping_off(3.0 * METRES_PER_NM, ports)
    x, y = to_mercator([57.45, 57.2, 57.2, 57.45], [17.5, 17.5, 19.0, 19.0])
    ways = np.stack([x[:-1], y[:-1], x[1:], y[1:]], axis=1)
    assert kept.clear(ways).all()
    gap = to_mercator(56.91, 18.01)
    assert not kept.is_water_at(np.array(gap[0]), np.array(gap[1]))


def test_land_is_no_water_even_beside_a_port() -> None:
    sea = sea_with(ISLAND)
    kept = sea.keeping_off(3.0 * METRES_PER_NM, (PORT,))
    rng = np.random.default_rng(4)
    lat, lon = rng.uniform(56.605, 56.795, 2000), rng.uniform(18.01, 18.39, 2000)
    assert not sea.is_water(lat, lon).any()
    assert not kept.is_water(lat, lon).any()


def test_a_sound_closes_when_it_is_narrower_than_twice_the_distance() -> None:
    """Two islands six miles apart, from rim to rim."""
    west = np.array([[56.7, 17.0, 56.8, 18.1]])
    sound = 6.0 / 60.0 / math.cos(math.radians(56.75))
    east = np.array([[56.7, 18.1 + sound, 56.8, 19.5]])
    sea = sea_with(west, east)
    x, y = to_mercator([56.3, 57.2], [18.1 + sound / 2] * 2)
    through = np.array([[x[0], y[0], x[1], y[1]]])
    assert sea.keeping_off(2.0 * METRES_PER_NM, ()).clear(through)[0]
    assert not sea.keeping_off(3.5 * METRES_PER_NM, ()).clear(through)[0]


def test_the_sea_itself_is_as_it_was() -> None:
    sea = sea_with(ISLAND)
    before = sea.water.cells.copy()
    kept = sea.keeping_off(5.0 * METRES_PER_NM, (PORT,))
    assert np.array_equal(sea.water.cells, before)
    assert not kept.water.cells.flags.writeable
    assert kept.water.shores is sea.water.shores


def test_the_same_again_is_the_same_sea() -> None:
    """A lattice is known by its sea: a new one for every question would never find its lattice again."""
    sea = sea_with(ISLAND)
    again = Sea(sea.water)
    cells = [s.keeping_off(5.0 * METRES_PER_NM, (PORT,)).water.cells for s in (sea, again)]
    assert cells[0] is cells[1]


@pytest.mark.parametrize("lat", [54.6, 60.0, 63.5, 65.2])
def test_the_farthest_distance_leaves_the_middle_of_wide_waters(lat: float) -> None:
    """Cells count to 255: the farthest that may be asked for must be less, up to the Gulf of Bothnia."""
    south, north = lat - 1.2, lat + 1.2
    sea = Sea(raster_of(south, 18.0, north, 24.0, cell=300.0))
    kept = sea.keeping_off(15.0 * METRES_PER_NM, ())
    assert kept.is_water(lat, 21.0)
    rim_lat, _ = from_mercator(*to_mercator(south, 21.0))
    assert not kept.is_water(float(rim_lat) + 14.0 / 60.0, 21.0)
