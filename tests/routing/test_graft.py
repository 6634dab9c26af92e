"""Another end for a lattice: only the edges of the ends change, and it leads as well as one of its own."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from seacruise.routing import graft, stencil
from seacruise.routing import lattice as lattices
from seacruise.routing.field import Handling, speed_table, wind_field
from seacruise.routing.lattice import Lattice
from seacruise.routing.levels import LatticeCache, Recipe
from seacruise.routing.search import search
from seacruise.sea import Sea
from tests.routing.sounds import ellipse
from tests.routing.worlds import T0, open_sea, sloop, steady_wind

Position = tuple[float, float]

SOUTH, NORTH = (56.5, 18.5), (57.6, 19.5)
BEHIND_ISLETS = (58.74, 17.87)
"""Off Nynäshamn: vertices 5 nm apart are out of sight."""

SEA = open_sea()


def build(sea: Sea, start: Position = SOUTH, end: Position = NORTH, *, courses: int = 36) -> Lattice:
    return lattices.build(
        sea,
        start,
        end,
        spacing_nm=3.0,
        offsets=stencil.triangular(courses),
        area=ellipse(start, end, 1.4),
    )


def pairs(lattice: Lattice) -> set[tuple[int, int]]:
    return set(zip(lattice.sources().tolist(), lattice.target.tolist(), strict=True))


def hours(lattice: Lattice) -> float:
    field, speeds = wind_field(steady_wind(14.0, 20.0)), speed_table(sloop(), Handling())
    return float(search(lattice, field, speeds, T0).arrival[lattice.end] - T0) / 3600.0


WHOLE = build(SEA)


def test_the_same_ends_give_the_same_lattice() -> None:
    assert graft.with_ends(WHOLE, SEA, SOUTH, NORTH) is WHOLE


@settings(deadline=None, max_examples=25)
@given(
    *(st.floats(-0.2, 0.2) for _ in range(4)),
)
def test_only_the_edges_of_the_ends_change(a: float, b: float, c: float, d: float) -> None:
    start, end = (SOUTH[0] + a, SOUTH[1] + b), (NORTH[0] + c, NORTH[1] + d)
    moved = graft.with_ends(WHOLE, SEA, start, end)
    assert moved is not None
    ends = {WHOLE.start, WHOLE.end}
    kept = {pair for pair in pairs(WHOLE) if not ends & set(pair)}
    new = pairs(moved) - kept
    assert kept < pairs(moved)
    assert moved.target.size == len(pairs(moved)), "no edge twice"
    assert all(source == moved.start or target == moved.end for source, target in new)
    assert (moved.first[1:] >= moved.first[:-1]).all()
    assert moved.first[-1] == moved.target.size
    np.testing.assert_allclose((moved.lat[-2], moved.lon[-2]), start)
    np.testing.assert_allclose((moved.lat[-1], moved.lon[-1]), end)
    assert moved.points[-1, 0] == moved.x[-1], "what the kernels read has moved, too"
    assert 36 <= sum(source == moved.start for source, _ in new) <= 96


@pytest.mark.parametrize("shift", [(0.0, 0.05), (0.11, -0.07), (-0.2, 0.2)])
def test_it_leads_as_well_as_a_lattice_of_its_own(shift: Position) -> None:
    start = SOUTH[0] + shift[0], SOUTH[1] + shift[1]
    moved = graft.with_ends(WHOLE, SEA, start, NORTH)
    assert moved is not None
    assert hours(moved) == pytest.approx(hours(build(SEA, start)), rel=0.004)


def test_a_place_too_narrow_for_it_needs_a_lattice_of_its_own(baltic: Sea) -> None:
    whole = build(baltic)
    assert graft.with_ends(whole, baltic, BEHIND_ISLETS, NORTH) is None
    assert graft.with_ends(whole, baltic, SOUTH, BEHIND_ISLETS) is None


def recipe(lattice_reach: float = 1.0, *, courses: int = 36) -> Recipe:
    return Recipe(3.0, courses, "ellipse", lattice_reach, 0, "triangular", None, None)


@pytest.fixture
def cache() -> LatticeCache:
    kept = LatticeCache()
    kept.get(recipe(), SEA, (SOUTH, NORTH), _as(SOUTH, NORTH))
    return kept


def _as(start: Position, end: Position) -> Callable[[], dict[str, object]]:
    return lambda: {
        "spacing_nm": 3.0,
        "offsets": stencil.triangular(36),
        "area": ellipse(start, end, 1.4),
    }


def test_a_kept_lattice_is_moved_where_it_is_like_the_one_wanted(cache: LatticeCache) -> None:
    near = (SOUTH[0] + 0.1, SOUTH[1])
    assert cache.moved(recipe(), SEA, (near, NORTH)) is not None
    assert cache.moved(recipe(2.0), SEA, (near, NORTH)) is not None, "size alone does not matter"
    assert cache.moved(recipe(courses=24), SEA, (near, NORTH)) is None
    assert cache.moved(recipe(), open_sea(), (near, NORTH)) is None, "another sea"
    assert cache.moved(recipe(), SEA, ((SOUTH[0] + 0.5, SOUTH[1]), NORTH)) is None, "30 nm away"


def test_the_nearest_of_the_kept_lattices_is_moved(cache: LatticeCache) -> None:
    there = (SOUTH[0] + 0.1, SOUTH[1])
    own = cache.get(recipe(), SEA, (there, NORTH), _as(there, NORTH))
    assert cache.moved(recipe(), SEA, (there, NORTH)) is own
