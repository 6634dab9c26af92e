"""Turning costs time: the search on states against plain searches, and the laws of paying for a turn."""

from __future__ import annotations

import heapq
import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from seacruise.routing import _kernels, _turning
from seacruise.routing.field import Handling, SpeedTable, WindField, speed_table, wind_field
from seacruise.routing.lattice import Lattice
from seacruise.routing.manoeuvres import merge_straight, straight_legs
from seacruise.routing.refine import Waters, relaxed, timed
from seacruise.routing.resail import resail
from seacruise.routing.search import PIECE_M, search
from seacruise.routing.turning import COURSE_DEG, Pauses, paths_by_changes, search_turning
from tests.routing.worlds import (
    HOUR,
    PRECISE,
    T0,
    fastest,
    lattice_of,
    open_sea,
    question,
    random_field,
    random_lattice,
    random_table,
    sloop,
    steady_wind,
)

seeds = st.integers(0, 2**32 - 1)
some = hypothesis_settings(max_examples=max(500, hypothesis_settings().max_examples), deadline=None)


def sail(lattice: Lattice, field: WindField, speeds: SpeedTable, t: float, a: int, b: int) -> float:
    return float(_kernels.edge_arrival(t, a, b, lattice.points, PIECE_M, field.arrays, speeds.arrays))


def pause_by_hand(
    lattice: Lattice, field: WindField, t: float, way: tuple[int, int, int], pauses: Pauses
) -> float:
    """Seconds that turning at the middle one of three vertices takes, from the definition."""
    a, b, c = way
    before = math.atan2(lattice.x[b] - lattice.x[a], lattice.y[b] - lattice.y[a])
    after = math.atan2(lattice.x[c] - lattice.x[b], lattice.y[c] - lattice.y[b])
    u, v, t0, step, south, per_lat, west, per_lon = field.arrays
    k = min(max(int((t - t0) / step), 0), u.shape[0] - 1)
    row = min(max((lattice.lat[b] - south) * per_lat, 0.0), u.shape[1] - 1.0)
    column = min(max((lattice.lon[b] - west) * per_lon, 0.0), u.shape[2] - 1.0)
    r, q = min(int(row), u.shape[1] - 2), min(int(column), u.shape[2] - 2)
    f, g = row - r, column - q

    def at(grid: np.ndarray) -> float:
        low = grid[k, r, q] * (1 - f) * (1 - g) + grid[k, r, q + 1] * (1 - f) * g
        return float(low + grid[k, r + 1, q] * f * (1 - g) + grid[k, r + 1, q + 1] * f * g)

    east, north = at(u), at(v)
    turn = abs((math.degrees(after - before) + 180.0) % 360.0 - 180.0)
    wind_from = math.atan2(-east, -north)
    sides = [(math.degrees(wind_from - course) + 180.0) % 360.0 - 180.0 for course in (before, after)]
    seconds = turn * pauses[2]
    across = [math.sin(math.radians(side)) * math.hypot(east, north) for side in sides]
    if across[0] * across[1] < 0.0:
        seconds += pauses[0] if abs(sides[0]) + abs(sides[1]) < 180.0 else pauses[1]
    return seconds


def by_plain_states(
    lattice: Lattice, field: WindField, speeds: SpeedTable, pauses: Pauses
) -> dict[tuple[int, int], float]:
    """Earliest arrivals by each edge: a search over edges that leaves nothing out."""
    rows = [lattice.target[lattice.first[v] : lattice.first[v + 1]].tolist() for v in range(lattice.vertices)]
    best: dict[tuple[int, int], float] = {}
    queue = [
        (sail(lattice, field, speeds, T0, lattice.start, b), lattice.start, b) for b in rows[lattice.start]
    ]
    heapq.heapify(queue)
    while queue:
        t, a, b = heapq.heappop(queue)
        if (a, b) in best or not math.isfinite(t):
            continue
        best[a, b] = t
        for c in rows[b]:
            leave = t + pause_by_hand(lattice, field, t, (a, b, c), pauses)
            heapq.heappush(queue, (sail(lattice, field, speeds, leave, b, c), b, c))
    return best


def duration(
    path: np.ndarray, lattice: Lattice, field: WindField, speeds: SpeedTable, pauses: Pauses
) -> float:
    t = T0
    for k in range(path.size - 1):
        if k > 0:
            t += pause_by_hand(lattice, field, t, (path[k - 1], path[k], path[k + 1]), pauses)
        t = sail(lattice, field, speeds, t, int(path[k]), int(path[k + 1]))
    return t


def steady_direction(rng: np.random.Generator) -> WindField:
    """Make winds that freshen and ease but keep their direction: who arrives earlier never turns later.

    Where the wind shifts, a tack may turn into a mere change of course for who comes later; the earlier
    label is kept then, by every search of labels.
    """
    field = random_field(rng)
    u, v, *rest = field.arrays
    strength = rng.uniform(0.2, 1.0, (u.shape[0], 1, 1)).astype(np.float32)
    return replace(field, arrays=(strength * u[:1], strength * v[:1], *rest))


pauses_drawn = st.tuples(st.floats(0.0, 1800.0), st.floats(0.0, 1800.0), st.floats(0.0, 20.0))


@some
@given(seeds, pauses_drawn)
def test_states_are_searched_as_by_a_search_that_leaves_nothing_out(seed: int, pauses: Pauses) -> None:
    rng = np.random.default_rng(seed)
    lattice = random_lattice(rng, 12, out_degree=4)
    # An edge between two vertices at one place has no course that could be turned from.
    assume(np.unique(np.stack([lattice.x, lattice.y]), axis=1).shape[1] == lattice.vertices)
    field, speeds = steady_direction(rng), random_table(rng)
    truth = by_plain_states(lattice, field, speeds, pauses)
    exact = min((t for (_, b), t in truth.items() if b == lattice.end), default=math.inf)
    path, _ = search_turning(lattice, field, speeds, T0, pauses)
    if path.size == 0:
        assert exact == math.inf
    else:
        assert (path[0], path[-1]) == (lattice.start, lattice.end)
        assert duration(path, lattice, field, speeds, pauses) == pytest.approx(exact, abs=1e-3)


@given(seeds)
def test_without_pauses_it_is_the_ordinary_search(seed: int) -> None:
    rng = np.random.default_rng(seed)
    lattice, field, speeds = random_lattice(rng, 25), random_field(rng), random_table(rng)
    plain = search(lattice, field, speeds, T0)
    path, _ = search_turning(lattice, field, speeds, T0, (0.0, 0.0, 0.0))
    if path.size == 0:
        assert plain.path(lattice.end).size == 0
    else:
        arrival = duration(path, lattice, field, speeds, (0.0, 0.0, 0.0))
        assert arrival == pytest.approx(plain.arrival[lattice.end], abs=1e-6)


@given(seeds, pauses_drawn)
def test_paying_for_turns_never_makes_a_passage_faster(seed: int, pauses: Pauses) -> None:
    rng = np.random.default_rng(seed)
    lattice, field, speeds = random_lattice(rng, 20), random_field(rng), random_table(rng)
    free = search(lattice, field, speeds, T0).arrival[lattice.end]
    path, _ = search_turning(lattice, field, speeds, T0, pauses)
    assert bool(path.size) == bool(np.isfinite(free))
    if path.size:
        assert duration(path, lattice, field, speeds, pauses) >= free - 1e-6


@pytest.mark.parametrize(
    ("courses", "wind_to", "expected"),
    [
        ((45.0, 315.0), 180.0, 60.0),  # through the wind: a tack
        ((135.0, 225.0), 180.0, 90.0),  # before the wind: a gybe
        ((60.0, 120.0), 180.0, 0.0),  # bearing away on one side
        ((315.0, 45.0), 180.0, 60.0),
        ((20.0, 220.0), 180.0, 60.0),  # more than half-way round, but shorter through the wind
        ((100.0, 200.0), 180.0, 90.0),
    ],
)
def test_tack_and_gybe_are_told_apart(courses: tuple[float, float], wind_to: float, expected: float) -> None:
    (e0, n0), (e1, n1) = ((math.sin(math.radians(c)), math.cos(math.radians(c))) for c in courses)
    u, v = 8.0 * math.sin(math.radians(wind_to)), 8.0 * math.cos(math.radians(wind_to))
    assert _turning.pause_of(e0, n0, e1, n1, u, v, (60.0, 90.0, 0.0)) == expected
    turned = abs((courses[1] - courses[0] + 180.0) % 360.0 - 180.0)
    by_angle = _turning.pause_of(e0, n0, e1, n1, u, v, (0.0, 0.0, 6.0))
    assert by_angle == pytest.approx(6.0 * turned)


# ------------------------------------------------------------------------ as few changes of course as wanted


def grid_lattice(rng: np.random.Generator, columns: int, rows: int) -> Lattice:
    """Make vertices in rows and columns, some missing, with edges in eight directions."""
    side = 20_000.0
    places = [(i, j) for j in range(rows) for i in range(columns) if rng.random() < 0.85]
    places = [p for p in places if p not in {(0, 0), (columns - 1, rows - 1)}]
    places += [(0, 0), (columns - 1, rows - 1)]
    number = {place: k for k, place in enumerate(places)}
    edges = [
        (k, number[i + di, j + dj])
        for (i, j), k in number.items()
        for di in (-1, 0, 1)
        for dj in (-1, 0, 1)
        if (di or dj) and (i + di, j + dj) in number
    ]
    x, y = (np.array([p[axis] for p in places]) * side + offset for axis, offset in ((0, 2e6), (1, 7.6e6)))
    return lattice_of(x, y, sorted(edges), start=len(places) - 2, end=len(places) - 1)


def by_plain_layers(lattice: Lattice, field: WindField, speeds: SpeedTable, most: int) -> list[float]:
    """Earliest arrival with at most 0, 1 ... changes, over states (vertex, course, changes)."""
    rows = [lattice.target[lattice.first[v] : lattice.first[v + 1]].tolist() for v in range(lattice.vertices)]

    def course(a: int, b: int) -> int:
        dx, dy = lattice.x[b] - lattice.x[a], lattice.y[b] - lattice.y[a]
        return round(math.degrees(math.atan2(dx, dy)) / COURSE_DEG)

    best = [math.inf] * (most + 1)
    settled: set[tuple[int, int, int]] = set()
    queue = [
        (sail(lattice, field, speeds, T0, lattice.start, b), 0, b, course(lattice.start, b))
        for b in rows[lattice.start]
    ]
    heapq.heapify(queue)
    while queue:
        t, changes, a, c = heapq.heappop(queue)
        if (changes, a, c) in settled or not math.isfinite(t):
            continue
        settled.add((changes, a, c))
        if a == lattice.end:
            best[changes] = min(best[changes], t)
            continue
        for b in rows[a]:
            d = course(a, b)
            after = changes + (d != c)
            if after <= most:
                heapq.heappush(queue, (sail(lattice, field, speeds, t, a, b), after, b, d))
    return [min(best[: w + 1]) for w in range(most + 1)]


@given(seeds)
def test_fewest_changes_are_those_of_a_plain_search(seed: int) -> None:
    rng = np.random.default_rng(seed)
    lattice = grid_lattice(rng, 5, 4)
    field, speeds = random_field(rng), random_table(rng, dead=False)
    truth = by_plain_layers(lattice, field, speeds, 8)
    found = paths_by_changes(lattice, field, speeds, T0, most=8, slower=50.0)
    for changes, arrival, path in found:
        assert arrival == pytest.approx(truth[changes], abs=1e-6)
        turns = sum(
            not np.isclose(
                math.atan2(lattice.x[b] - lattice.x[a], lattice.y[b] - lattice.y[a]),
                math.atan2(lattice.x[c] - lattice.x[b], lattice.y[c] - lattice.y[b]),
                atol=1e-6,
            )
            for a, b, c in zip(path[:-2], path[1:-1], path[2:], strict=True)
        )
        assert turns <= changes
        assert duration(path, lattice, field, speeds, (0.0, 0.0, 0.0)) == pytest.approx(arrival, abs=1e-6)
    if math.isfinite(truth[-1]):
        # Within half a minute of the best no more changes are tried.
        assert found[-1][1] <= truth[-1] + 31.0


# ----------------------------------------------------------------------------------------- on a real beat


def beat(pauses: Pauses) -> tuple[float, int, float]:
    """Sail 60 nm dead to windward; hours, tacks and hours lost in turning."""
    how = replace(PRECISE, handling=replace(PRECISE.handling, pauses=pauses))
    asked = question(open_sea(), steady_wind(14.0, 0.0), sloop(), (56.0, 18.0), (57.0, 18.0), how=how)
    found = fastest(asked)
    assert found.boards_found
    course = merge_straight(straight_legs(found.line), asked.sea, asked.zones)
    sailed = resail(asked, course, fuel_rate_l_h=0.0)
    assert sailed.arrived
    assert sailed.land_free
    return (float(sailed.time[-1]) - T0) / HOUR, sailed.turns, sailed.pause_s / HOUR


def test_a_beat_is_sailed_in_as_few_boards_as_the_cost_of_tacking_asks_for() -> None:
    hours, tacks, lost = beat((300.0, 300.0, 0.0))
    # In a steady wind on open water two boards are enough.
    assert tacks == 1
    assert lost == pytest.approx(tacks * 300.0 / HOUR)
    asked = question(open_sea(), steady_wind(14.0, 0.0), sloop(), (56.0, 18.0), (57.0, 18.0))
    assert hours == pytest.approx(fastest(asked).line.seconds / HOUR + lost, rel=2e-3)


def test_relaxing_counts_what_turns_cost() -> None:
    sea, field = open_sea(), wind_field(steady_wind(14.0, 0.0))
    speeds = speed_table(sloop(), Handling(tacking=False))
    x = np.array([2.0e6, 2.02e6, 2.0e6, 2.02e6, 2.0e6])
    y = 7.6e6 + np.arange(5, dtype=np.float64) * 20_000.0
    paid = Waters(sea, field, speeds, pauses=(900.0, 900.0, 0.0))
    free = replace(paid, pauses=(0.0, 0.0, 0.0))
    assert timed(paid, x, y, T0).seconds == pytest.approx(timed(free, x, y, T0).seconds + 3 * 900.0)
    after = relaxed(paid, timed(paid, x, y, T0))
    assert after.seconds <= timed(paid, x, y, T0).seconds
    turns = after.x.size - 2
    assert after.seconds == pytest.approx(timed(free, after.x, after.y, T0).seconds + turns * 900.0)
