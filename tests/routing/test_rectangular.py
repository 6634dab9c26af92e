"""The rectangular lattice of R2 and R3: exact courses, no edge over land, grids of rows and columns."""

from __future__ import annotations

import numpy as np
import pytest

from seacruise.errors import InputError
from seacruise.geodesy import great_circle_m, rhumb_course_deg, to_mercator
from seacruise.routing import lattice as lattices
from seacruise.routing import stencil
from seacruise.routing.field import Handling, speed_table, wind_field
from seacruise.routing.lattice import Lattice, Levels
from seacruise.routing.search import connected, search
from seacruise.sea import Sea, coast
from seacruise.units import METRES_PER_NM
from tests.routing.sounds import ellipse
from tests.routing.test_lattice import (
    KARLSKRONA,
    NORTH,
    SOUTH,
    SWINOUJSCIE,
    assert_both_ways,
    assert_sound,
    inner_edges,
    rhumb_lines,
)
from tests.routing.worlds import T0, drifter, open_sea, steady_wind

HEL = (54.217, 18.069, 54.936, 19.508)
"""The area of R2 and R3: south, west, north, east."""


def rectangular_between(
    sea: Sea,
    start: tuple[float, float] = SOUTH,
    end: tuple[float, float] = NORTH,
    *,
    courses: int = 8,
    levels: Levels = lattices.NO_LEVELS,
) -> Lattice:
    return lattices.build(
        sea,
        start,
        end,
        spacing_nm=4.0,
        offsets=stencil.rectangular(courses),
        mesh=stencil.SQUARES,
        area=ellipse(start, end),
        levels=levels,
    )


@pytest.mark.parametrize("courses", stencil.RECTANGULAR_COURSES)
def test_edges_are_the_true_courses_of_the_moves(courses: int) -> None:
    lattice = rectangular_between(open_sea(), courses=courses)
    a, b = inner_edges(lattice)
    course = rhumb_course_deg(lattice.lat[a], lattice.lon[a], lattice.lat[b], lattice.lon[b])
    moves = stencil.rectangular(courses)
    exact = np.degrees(np.arctan2(moves[:, 0], moves[:, 1])) % 360.0
    off = np.abs((course[:, None] - exact[None, :] + 180.0) % 360.0 - 180.0)
    assert off.min(axis=1).max() < 1e-6
    degree = np.bincount(a, minlength=lattice.vertices - 2)
    assert degree.max() == courses
    assert np.count_nonzero(degree == courses) > 50


def test_squares_are_true_at_the_middle_latitude() -> None:
    lattice = rectangular_between(open_sea())
    a, b = inner_edges(lattice)
    north = np.flatnonzero(np.abs(lattice.x[a] - lattice.x[b]) < 1.0)
    length = great_circle_m(
        lattice.lat[a[north]], lattice.lon[a[north]], lattice.lat[b[north]], lattice.lon[b[north]]
    )
    assert float(np.median(length)) / METRES_PER_NM == pytest.approx(4.0, rel=0.01)


@pytest.mark.parametrize("levels", [Levels(), Levels(4)], ids=["coarse", "four levels"])
def test_rows_are_sound_and_keep_off_the_land(levels: Levels, baltic: Sea) -> None:
    lattice = rectangular_between(baltic, KARLSKRONA, SWINOUJSCIE, courses=32, levels=levels)
    assert_sound(lattice)
    assert_both_ways(lattice)
    lines = rhumb_lines(lattice)
    assert len(lines) > 1000
    assert np.count_nonzero(coast.land_on_lines(lines)) == 0


def test_due_north_is_sailed_exactly_as_long_as_it_is() -> None:
    """On a course that the lattice has, its passage is the rhumb line itself."""
    start, end = (56.0, 18.0), (57.5, 18.0)
    lattice = rectangular_between(open_sea(), start, end)
    field, speeds = wind_field(steady_wind(10.0, 90.0)), speed_table(drifter(), Handling())
    hours = (float(search(lattice, field, speeds, T0).arrival[lattice.end]) - T0) / 3600.0
    assert hours * 10.0 == pytest.approx(float(great_circle_m(*start, *end)) / METRES_PER_NM, rel=1e-3)


# ------------------------------------------------------------------------------------- rows and columns


def hel_grid(
    sea: Sea, shape: tuple[int, int], *, courses: int = 8, levels: Levels = lattices.NO_LEVELS
) -> Lattice:
    return lattices.grid(
        sea,
        (54.65, 19.21),
        (54.60, 18.60),
        corners=HEL,
        shape=shape,
        offsets=stencil.rectangular(courses),
        levels=levels,
    )


@pytest.mark.parametrize("shape", [(2, 2), (7, 12), (42, 84)])
def test_a_grid_has_the_points_and_edges_that_were_asked_for(shape: tuple[int, int]) -> None:
    lattice = hel_grid(open_sea(), shape)
    rows, columns = shape
    assert lattice.vertices == rows * columns + 2
    inner = slice(0, rows * columns)
    south, west, north, east = HEL
    assert (lattice.lat[inner].min(), lattice.lat[inner].max()) == pytest.approx((south, north), abs=1e-9)
    assert (lattice.lon[inner].min(), lattice.lon[inner].max()) == pytest.approx((west, east), abs=1e-9)
    sides = rows * (columns - 1) + columns * (rows - 1)
    diagonals = 2 * (rows - 1) * (columns - 1)
    assert inner_edges(lattice)[0].size == 2 * (sides + diagonals)


def test_a_move_on_a_grid_is_one_course_everywhere() -> None:
    lattice = hel_grid(open_sea(), (42, 84), courses=32)
    a, b = inner_edges(lattice)
    course = rhumb_course_deg(lattice.lat[a], lattice.lon[a], lattice.lat[b], lattice.lon[b])
    assert np.unique(np.round(course, 6) % 360.0).size == 32


def test_a_grid_in_the_gulf_keeps_off_the_land_and_leads_round_hel(baltic: Sea) -> None:
    lattice = hel_grid(baltic, (42, 84), courses=32)
    assert_sound(lattice)
    assert_both_ways(lattice)
    assert lattice.vertices < 42 * 84
    assert np.count_nonzero(coast.land_on_lines(rhumb_lines(lattice))) == 0
    assert connected(lattice)
    field, speeds = wind_field(steady_wind(10.0, 90.0)), speed_table(drifter(), Handling())
    path = search(lattice, field, speeds, T0).path(lattice.end)
    # Hel's tip is at 54.59 N 18.81 E.
    assert lattice.lat[path][(lattice.lon[path] > 18.75) & (lattice.lon[path] < 18.87)].min() < 54.60


def test_a_grid_is_refined_like_every_lattice(baltic: Sea) -> None:
    coarse = hel_grid(baltic, (21, 42), courses=16)
    fine = hel_grid(baltic, (21, 42), courses=16, levels=Levels(1))
    everywhere = hel_grid(baltic, (41, 83), courses=16)
    assert coarse.vertices < fine.vertices < everywhere.vertices
    np.testing.assert_allclose(fine.x[: coarse.vertices - 2], coarse.x[:-2])
    # What was added stands on the grid of half the spacing.
    x0, y0 = (float(c) for c in to_mercator(HEL[0], HEL[1]))
    x1, y1 = (float(c) for c in to_mercator(HEL[2], HEL[3]))
    column = (fine.x[:-2] - x0) / (x1 - x0) * 82
    row = (fine.y[:-2] - y0) / (y1 - y0) * 40
    np.testing.assert_allclose([column, row], np.round([column, row]), atol=1e-6)


@pytest.mark.parametrize(
    ("corners", "shape"),
    [((54.9, 18.0, 54.2, 19.0), (4, 4)), ((54.2, 19.0, 54.9, 18.0), (4, 4)), (HEL, (1, 8))],
    ids=["upside down", "east of west", "one row"],
)
def test_grids_without_an_inside_are_refused(
    corners: tuple[float, float, float, float], shape: tuple[int, int]
) -> None:
    with pytest.raises(InputError, match="grid needs"):
        lattices.grid(
            open_sea(),
            (54.65, 19.21),
            (54.60, 18.60),
            corners=corners,
            shape=shape,
            offsets=stencil.rectangular(8),
        )
