"""The search: compiled against the plain array, against all paths by hand, and by the laws of sailing."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from seacruise.routing import _kernels
from seacruise.routing.field import SpeedTable, WindField, handling_in_knots, speed_table, wind_field
from seacruise.routing.lattice import Lattice
from seacruise.routing.reference import Sail, array_queue_search
from seacruise.routing.search import PIECE_M, connected, search
from seacruise.units import METRES_PER_NM, MS_PER_KNOT
from tests.routing.worlds import (
    DAY,
    HOUR,
    T0,
    drifter,
    lattice_of,
    random_edges,
    random_field,
    random_lattice,
    random_table,
    steady_wind,
    table_of,
)

seeds = st.integers(0, 2**32 - 1)
_AS_IT_IS: dict[str, Any] = {
    "tacking": False,
    "percent": 100.0,
    "motor_below_kn": None,
    "motor_speed_kn": 5.0,
    "max_wind_kn": None,
}

many = hypothesis_settings(max_examples=max(500, hypothesis_settings().max_examples))


def sail_by_kernel(lattice: Lattice, field: WindField, speeds: SpeedTable) -> Sail:
    """Sail one edge as the compiled search does."""

    def sail(t: float, a: int, b: int) -> float:
        return float(_kernels.edge_arrival(t, a, b, lattice.points, PIECE_M, field.arrays, speeds.arrays))

    return sail


def sail_by_hand(lattice: Lattice, field: WindField, speeds: SpeedTable) -> Sail:
    """Sail one edge by the definition: in each piece and slice of time a constant speed."""
    u, v, t0, step, south, per_lat, west, per_lon = field.arrays
    table, per_tws = speeds.arrays

    def bilinear(grid: NDArray[np.float32], row: float, column: float) -> float:
        r = min(int(row), grid.shape[0] - 2)
        c = min(int(column), grid.shape[1] - 2)
        fr, fc = row - r, column - c
        below = float(grid[r, c]) * (1 - fc) + float(grid[r, c + 1]) * fc
        above = float(grid[r + 1, c]) * (1 - fc) + float(grid[r + 1, c + 1]) * fc
        return float(below * (1 - fr) + above * fr)

    def speed(k: int, lat: float, lon: float, course: float) -> float:
        row = min(max((lat - south) * per_lat, 0.0), u.shape[1] - 1.0)
        column = min(max((lon - west) * per_lon, 0.0), u.shape[2] - 1.0)
        east, north = bilinear(u[k], row, column), bilinear(v[k], row, column)
        tws = math.hypot(east, north)
        into = -(east * math.sin(course) + north * math.cos(course)) / tws if tws > 1e-9 else 0.0
        return bilinear(
            table, min(tws * per_tws, table.shape[0] - 1.0), (into + 1) / 2 * (table.shape[1] - 1)
        )

    def sail(t: float, a: int, b: int) -> float:
        dx, dy = float(lattice.x[b] - lattice.x[a]), float(lattice.y[b] - lattice.y[a])
        length = math.hypot(dx, dy) * float(lattice.scale[a] + lattice.scale[b]) / 2
        pieces = int(length / PIECE_M) + 1
        for p in range(pieces):
            f, left = (p + 0.5) / pieces, length / pieces
            lat = float(lattice.lat[a] + (lattice.lat[b] - lattice.lat[a]) * f)
            lon = float(lattice.lon[a] + (lattice.lon[b] - lattice.lon[a]) * f)
            while left > 0.0:
                k = min(int((t - t0) / step), u.shape[0] - 1)
                until = t0 + (k + 1) * step if k < u.shape[0] - 1 else math.inf
                pace = speed(k, lat, lon, math.atan2(dx, dy))
                if pace <= 1e-6 and until == math.inf:
                    return math.inf
                if pace * (until - t) >= left:
                    t, left = t + left / pace, 0.0
                else:
                    t, left = until, left - pace * (until - t)
        return t

    return sail


def within_reach(arrival: float) -> float:
    """Call it never when it takes months: at a hair above no speed, rounding decides between both."""
    return arrival if arrival < T0 + 1e7 else math.inf


# ------------------------------------------------------------------------------- one search, three ways


@many
@given(seeds)
def test_compiled_search_settles_what_the_plain_array_settles(seed: int) -> None:
    rng = np.random.default_rng(seed)
    lattice = random_lattice(
        rng, int(rng.integers(2, 30)), out_degree=int(rng.integers(1, 6)), size_nm=rng.choice([5, 80, 400])
    )
    field, speeds = random_field(rng), random_table(rng, limits=bool(rng.random() < 0.3))
    departure = T0 + float(rng.uniform(-2, 14)) * HOUR
    plain = array_queue_search(lattice, sail_by_kernel(lattice, field, speeds), departure)
    whole = search(lattice, field, speeds, departure, to_end=False)
    np.testing.assert_array_equal(whole.arrival, plain.arrival)
    np.testing.assert_array_equal(whole.before, plain.before)
    assert whole.settled == plain.settled
    # Goal-directed, fewer labels are final, but the passage is the same one.
    ahead = search(lattice, field, speeds, departure)
    assert ahead.arrival[lattice.end] == plain.arrival[lattice.end]
    assert ahead.path(lattice.end).tolist() == plain.path(lattice.end).tolist()
    assert ahead.settled <= plain.settled


@many
@given(seeds)
def test_no_path_by_hand_arrives_earlier(seed: int) -> None:
    rng = np.random.default_rng(seed)
    n = int(rng.integers(2, 7))
    lattice = random_lattice(rng, n, out_degree=int(rng.integers(1, n + 1)), size_nm=rng.choice([5, 60, 200]))
    field, speeds = random_field(rng, slices=int(rng.integers(1, 9))), random_table(rng)
    sail = sail_by_hand(lattice, field, speeds)
    edges = set(zip(lattice.sources().tolist(), lattice.target.tolist(), strict=True))
    best = math.inf
    others = [v for v in range(n) if v not in {lattice.start, lattice.end}]
    for between in itertools.chain.from_iterable(
        itertools.permutations(others, k) for k in range(len(others) + 1)
    ):
        path = (lattice.start, *between, lattice.end)
        if not edges.issuperset(itertools.pairwise(path)):
            continue
        t = T0
        for a, b in itertools.pairwise(path):
            t = sail(t, a, b) if t < math.inf else t
        best = min(best, t)
    found = search(lattice, field, speeds, T0)
    best, ours = within_reach(best), within_reach(float(found.arrival[lattice.end]))
    assert ours - T0 == pytest.approx(best - T0, rel=1e-6, abs=1e-3)
    if math.isinf(found.arrival[lattice.end]):
        assert found.path(lattice.end).size == 0
    else:
        path = found.path(lattice.end).tolist()
        assert (path[0], path[-1]) == (lattice.start, lattice.end)
        assert edges.issuperset(itertools.pairwise(path))


@given(seeds)
def test_reached_is_what_hangs_together(seed: int) -> None:
    rng = np.random.default_rng(seed)
    lattice = random_lattice(rng, int(rng.integers(2, 30)), out_degree=int(rng.integers(1, 3)))
    speeds = table_of(np.full((60, 17), 3.0))
    found = search(lattice, wind_field(steady_wind(10.0, 0.0)), speeds, T0)
    assert connected(lattice) == bool(np.isfinite(found.arrival[lattice.end]))


@given(seeds, st.floats(0.5, 30.0))
def test_a_deadline_cuts_off_what_is_reached_later(seed: int, hours: float) -> None:
    rng = np.random.default_rng(seed)
    lattice, field, speeds = random_lattice(rng, 25), random_field(rng), random_table(rng)
    latest = T0 + hours * HOUR
    whole = search(lattice, field, speeds, T0, to_end=False)
    cut = search(lattice, field, speeds, T0, to_end=False, latest=latest)
    inside = whole.arrival <= latest
    np.testing.assert_array_equal(cut.arrival[inside], whole.arrival[inside])
    assert (cut.arrival[~inside] > latest).all()


# ------------------------------------------------------------------------------------ first in, first out


@many
@given(seeds, st.floats(-3, 15), st.floats(0, 12))
def test_on_an_edge_leaving_later_never_arrives_earlier(seed: int, leaves_h: float, waits_h: float) -> None:
    rng = np.random.default_rng(seed)
    lattice = random_lattice(rng, 2, out_degree=2, size_nm=rng.choice([1, 20, 300]))
    sail = sail_by_kernel(lattice, random_field(rng, slices=int(rng.integers(1, 13))), random_table(rng))
    soon = T0 + leaves_h * HOUR
    assert sail(soon, 0, 1) <= sail(soon + waits_h * HOUR, 0, 1) + 1e-4


@given(seeds, st.floats(-3, 15), st.floats(0, 12))
def test_on_a_passage_leaving_later_never_arrives_earlier(seed: int, leaves_h: float, waits_h: float) -> None:
    rng = np.random.default_rng(seed)
    lattice, field, speeds = random_lattice(rng, 20), random_field(rng), random_table(rng)
    soon = search(lattice, field, speeds, T0 + leaves_h * HOUR, to_end=False).arrival
    later = search(lattice, field, speeds, T0 + (leaves_h + waits_h) * HOUR, to_end=False).arrival
    assert (soon <= later + 1e-3).all()
    assert (np.isfinite(soon) | np.isinf(later)).all()


def test_a_calm_that_lifts_is_sat_out_wherever_one_is() -> None:
    # Calm for ten slices; who left an hour ago and who leaves now both wait, and sail on together.
    u = np.zeros((11, 2, 2), np.float32)
    u[-1] = 5.0
    field = WindField((u, np.zeros_like(u), T0, HOUR, 56.0, 0.5, 17.0, 0.5), T0 + 10 * HOUR, 5.0, 5.0 / 11)
    lattice = random_lattice(np.random.default_rng(1), 2, out_degree=2)
    speeds = speed_table(drifter(), handling_in_knots(**_AS_IT_IS))
    sail = sail_by_kernel(lattice, field, speeds)
    arrivals = [sail(T0 + h * HOUR, 0, 1) for h in (0.0, 1.0, 9.99)]
    assert arrivals == pytest.approx([arrivals[0]] * 3, abs=1e-3)
    assert sail(T0 + 11 * HOUR, 0, 1) - arrivals[0] == pytest.approx(HOUR, abs=1e-3)


def test_the_last_wind_holds_beyond_the_forecast() -> None:
    x0, y0 = 2e6, 7.5e6
    lattice = lattice_of(np.array([x0, x0 + 1e6]), np.array([y0, y0]), [(0, 1)], start=0, end=1)
    field = wind_field(steady_wind(10.0, 0.0, days=1.0))
    found = search(lattice, field, speed_table(drifter(), handling_in_knots(**_AS_IT_IS)), T0)
    seconds = 1e6 * float(lattice.scale[0]) / (10 * MS_PER_KNOT)
    assert seconds > DAY
    assert found.arrival[1] - T0 == pytest.approx(seconds, rel=1e-6)


# ---------------------------------------------------------------------------------------- laws of sailing


@given(seeds)
def test_a_faster_yacht_is_never_later(seed: int) -> None:
    rng = np.random.default_rng(seed)
    lattice, field, slow = random_lattice(rng, 20), random_field(rng), random_table(rng)
    table = slow.arrays[0].astype(np.float64)
    faster = table_of(table + rng.uniform(0, 2, table.shape) * (rng.random(table.shape) < 0.5) * (table > 0))
    one, two = (search(lattice, field, s, T0, to_end=False).arrival for s in (slow, faster))
    assert (two <= one + 1e-3).all()


@given(seeds, st.floats(0.3, 4.0))
def test_in_a_steady_wind_times_scale_with_the_polar(seed: int, factor: float) -> None:
    rng = np.random.default_rng(seed)
    lattice, field, speeds = random_lattice(rng, 20), random_field(rng, slices=1), random_table(rng)
    scaled = table_of(speeds.arrays[0].astype(np.float64) * factor)
    one, two = (search(lattice, field, s, T0, to_end=False).arrival - T0 for s in (speeds, scaled))
    np.testing.assert_allclose(two * factor, one, rtol=1e-5, atol=1e-3)


@given(seeds, st.floats(-30, 300))
def test_in_a_steady_wind_the_hour_of_leaving_changes_nothing(seed: int, hours: float) -> None:
    rng = np.random.default_rng(seed)
    lattice, field, speeds = random_lattice(rng, 20), random_field(rng, slices=1), random_table(rng)
    now = search(lattice, field, speeds, T0)
    then = search(lattice, field, speeds, T0 + hours * HOUR)
    np.testing.assert_allclose(
        then.arrival[lattice.end] - T0 - hours * HOUR, now.arrival[lattice.end] - T0, atol=1e-3
    )
    assert then.path(lattice.end).tolist() == now.path(lattice.end).tolist()


@given(seeds)
def test_more_edges_are_never_slower_and_fewer_never_faster(seed: int) -> None:
    rng = np.random.default_rng(seed)
    some = random_lattice(rng, 20, out_degree=3)
    field, speeds = random_field(rng), random_table(rng)
    edges = list(zip(some.sources().tolist(), some.target.tolist(), strict=True))
    more = sorted({*edges, *random_edges(rng, 20, 3)})
    all_of_them = lattice_of(some.x, some.y, more, start=some.start, end=some.end)
    one, two = (search(g, field, speeds, T0, to_end=False).arrival for g in (some, all_of_them))
    assert (two <= one).all()


@given(seeds)
def test_the_same_question_has_the_same_answer(seed: int) -> None:
    rng = np.random.default_rng(seed)
    lattice, field, speeds = random_lattice(rng, 25), random_field(rng), random_table(rng)
    one, two = (search(lattice, field, speeds, T0) for _ in range(2))
    assert one.arrival.tobytes() == two.arrival.tobytes()
    assert one.before.tobytes() == two.before.tobytes()
    assert (one.settled, one.relaxed) == (two.settled, two.relaxed)


@given(seeds)
def test_time_never_runs_backwards_along_a_path(seed: int) -> None:
    rng = np.random.default_rng(seed)
    lattice, field, speeds = random_lattice(rng, 30), random_field(rng), random_table(rng)
    found = search(lattice, field, speeds, T0, to_end=False)
    path = found.path(int(rng.integers(30)))
    assert (np.diff(found.arrival[path]) >= 0.0).all()


def test_more_wind_than_allowed_is_not_sailed() -> None:
    # Five m/s but for the fourth hour, when it blows twelve.
    v = np.full((8, 2, 2), -5.0, np.float32)
    v[3] = -12.0
    field = WindField((np.zeros_like(v), v, T0, HOUR, 56.0, 0.5, 17.0, 0.5), T0 + 7 * HOUR, 12.0, 5.9)
    x0, y0 = 2e6, 7.5e6
    step = 0.9 * HOUR * 5.0 / float(lattice_of(np.array([x0]), np.array([y0]), [], start=0, end=0).scale[0])
    lattice = lattice_of(np.array([x0, x0 + 2 * step]), np.array([y0, y0]), [(0, 1)], start=0, end=1)
    handling = handling_in_knots(**_AS_IT_IS | {"max_wind_kn": 11.0 / MS_PER_KNOT})
    speeds = speed_table(drifter(), handling)
    hours = [search(lattice, field, speeds, T0 + h * HOUR).arrival[1] / HOUR - T0 / HOUR for h in range(6)]
    assert hours == pytest.approx([1.8, 2.8, math.inf, math.inf, 5.8, 6.8], abs=1e-6)


@given(seeds)
def test_piece_by_piece_is_what_the_definition_says(seed: int) -> None:
    rng = np.random.default_rng(seed)
    lattice = random_lattice(rng, 6, out_degree=3, size_nm=rng.choice([3, 60, 400]))
    field, speeds = random_field(rng, slices=int(rng.integers(1, 13))), random_table(rng)
    kernel, hand = sail_by_kernel(lattice, field, speeds), sail_by_hand(lattice, field, speeds)
    leaves = T0 + float(rng.uniform(0, 14)) * HOUR
    for a, b in zip(lattice.sources().tolist(), lattice.target.tolist(), strict=True):
        ours, definition = (within_reach(arrive(leaves, a, b)) for arrive in (kernel, hand))
        assert ours - T0 == pytest.approx(definition - T0, rel=1e-6, abs=1e-2)


def test_an_edge_takes_its_length_by_the_speed() -> None:
    x0, y0 = 2e6, 7.5e6
    lattice = lattice_of(np.array([x0, x0 + 30_000]), np.array([y0, y0 + 40_000]), [(0, 1)], start=0, end=1)
    true_nm = 50_000 * float(lattice.scale.mean()) / METRES_PER_NM
    found = search(
        lattice,
        wind_field(steady_wind(8.0, 123.0)),
        speed_table(drifter(), handling_in_knots(**_AS_IT_IS)),
        T0,
    )
    assert (found.arrival[1] - T0) / HOUR == pytest.approx(true_nm / 8.0, rel=1e-6)
