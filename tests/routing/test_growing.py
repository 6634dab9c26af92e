"""How a lattice is listed and joined by compiled loops: against plain ones, and land looked at late."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.geodesy import to_mercator
from seacruise.routing import _points, axial, stencil
from seacruise.routing import lattice as lattices
from seacruise.routing.area import Area, Levels
from seacruise.routing.field import Handling, speed_table, tacking_may_gain, wind_field
from seacruise.routing.manoeuvres import GAIN
from seacruise.routing.search import search
from seacruise.sea import Sea
from seacruise.units import METRES_PER_NM
from seacruise.yacht.hull import hull_speed
from tests.routing.worlds import T0, Array, sloop, steady_wind

WESTERVIK, VISBY = (57.72, 16.75), (57.63, 18.27)
MESH = stencil.TRIANGLES.pair
places = st.lists(st.tuples(st.integers(-40, 40), st.integers(-40, 40)), min_size=1, max_size=60)


def distance(x: Array, y: Array, lines: Array) -> Array:
    """Least distance of points ``(n,)`` from lines ``(m, 4)``."""
    along = lines[:, 2:] - lines[:, :2]
    square = np.maximum((along**2).sum(axis=1), 1e-12)
    away = np.stack([x, y], axis=1)[:, None, :] - lines[None, :, :2]
    share = np.clip((away * along).sum(axis=2) / square, 0.0, 1.0)
    return np.asarray(np.hypot(*np.moveaxis(away - share[:, :, None] * along, 2, 0)).min(axis=1))


@given(
    ends=st.lists(st.tuples(*(st.floats(-60.0, 60.0) for _ in range(4))), min_size=1, max_size=6),
    reach=st.floats(0.5, 30.0),
    flat=st.booleans(),
)
def test_points_of_a_corridor_are_those_within_reach(
    ends: list[tuple[float, float, float, float]], reach: float, flat: bool
) -> None:
    lines = np.array(ends)
    if flat:
        lines[:, 3] = lines[:, 1]
    side = 3.0
    swapped = np.where((lines[:, 1] > lines[:, 3])[:, None], lines[:, [2, 3, 0, 1]], lines)
    upright = np.ascontiguousarray(swapped[np.argsort(swapped[:, 1], kind="stable")])
    cells = np.full((400, 400), 3, dtype=np.uint8)
    cells.setflags(write=False)
    frame, origin = (-200.0, -200.0, 1.0), (0.3, -0.7)
    fits, i, j = _points.corridor_points(
        upright, reach, cells, frame, MESH, origin, side, (np.inf, 0.0), 1_000_000
    )
    assert fits
    all_j, all_i = (axis.ravel() for axis in np.mgrid[-60:61, -80:81])
    x = origin[0] + side * (all_i + MESH[0] * all_j)
    y = origin[1] + side * MESH[1] * all_j
    away = distance(x, y, lines)
    listed = set(zip(i.tolist(), j.tolist(), strict=True))
    wanted = zip(all_i.tolist(), all_j.tolist(), away.tolist(), strict=True)
    sure = {(a, b): d for a, b, d in wanted if abs(d - reach) > 1e-6 * reach}
    assert {place for place, d in sure.items() if d < reach} == {place for place in sure if place in listed}
    assert list(zip(j.tolist(), i.tolist(), strict=True)) == sorted((b, a) for a, b in listed)


@pytest.mark.parametrize("table", [True, False])
@given(kept=places, asked=places)
def test_an_index_finds_what_is_there_and_nothing_else(
    table: bool, kept: list[tuple[int, int]], asked: list[tuple[int, int]]
) -> None:
    i, j = axial.unique(*(np.array(axis, dtype=np.int64) for axis in zip(*kept, strict=True)))
    with pytest.MonkeyPatch.context() as patch:
        if not table:
            patch.setattr(axial, "_DENSEST", -1)
            # Four times the list is room enough for a table of few positions in a row.
            i, j = np.append(i, 5000), np.append(j, j[-1])
        index = axial.Index(i, j)
    assert (index.arrays[4].size > 0) is table
    where = {place: n for n, place in enumerate(zip(i.tolist(), j.tolist(), strict=True))}
    both = kept + asked
    found = index.at(*(np.array(axis, dtype=np.int64) for axis in zip(*both, strict=True)))
    assert found.tolist() == [where.get(place, -1) for place in both]


def test_land_looked_at_late_is_land_all_the_same(baltic: Sea) -> None:
    x, y = to_mercator(*zip(WESTERVIK, VISBY, strict=True))
    area = Area("corridor", np.array([[x[0], y[0], x[1], y[1]]]), 14 * METRES_PER_NM)
    at_once, late = (
        lattices.build(
            baltic,
            WESTERVIK,
            VISBY,
            spacing_nm=2.0,
            offsets=stencil.triangular(36),
            area=area,
            levels=Levels(3),
            lazily=lazily,
        )
        for lazily in (False, True)
    )
    assert late.target.size > at_once.target.size
    field, speeds = wind_field(steady_wind(14.0, 250.0)), speed_table(sloop(), Handling())
    for to_end in (True, False):
        one, other = (search(grid, field, speeds, T0, to_end=to_end) for grid in (at_once, late))
        np.testing.assert_array_equal(one.arrival, other.arrival)
        np.testing.assert_array_equal(one.before, other.before)


def test_no_board_that_pays_is_overlooked() -> None:
    polar = sloop()
    tws, twa = np.arange(0.5, 20.0, 0.37), np.arange(-180.0, 180.0, 0.7)
    straight = polar.speed(tws[:, None], twa)
    pays = hull_speed(polar, tws, twa) >= GAIN * straight
    wind, angle = np.broadcast_arrays(tws[:, None], twa)
    may = tacking_may_gain(polar, wind.ravel(), angle.ravel(), least=(GAIN - 1.0) / 2.0).reshape(pays.shape)
    assert (may | ~pays | (straight == 0.0) & (hull_speed(polar, tws, twa) == 0.0)).all()
    assert not may[:, (np.abs(twa) > 70.0) & (np.abs(twa) < 130.0)].any()
