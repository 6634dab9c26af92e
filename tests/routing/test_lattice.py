"""The lattice: true courses, sound rows, no edge over land, levels that hang together."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from geographiclib.geodesic import Geodesic

from seacruise.errors import InputError
from seacruise.geodesy import EARTH_RADIUS, from_mercator, great_circle_m, rhumb_course_deg, to_mercator
from seacruise.ports import find_port, load_ports
from seacruise.routing import classic, stencil
from seacruise.routing import lattice as lattices
from seacruise.routing.field import Handling, speed_table, wind_field
from seacruise.routing.lattice import Lattice, Levels
from seacruise.routing.search import connected, search
from seacruise.sea import Sea, coast
from seacruise.units import METRES_PER_NM
from tests.routing.sounds import ellipse
from tests.routing.worlds import T0, Array, open_sea, raster_of, sloop, steady_wind

SOUTH, NORTH = (56.5, 18.5), (57.6, 19.5)
KARLSKRONA, SWINOUJSCIE = (56.155, 15.595), (53.93, 14.28)
WESTERVIK, KALMAR_SOUTH = (57.72, 16.75), (56.15, 16.25)
NYNAESHAMN, NORRTAELJE = (58.87, 17.97), (59.70, 19.10)


def lattice_between(
    sea: Sea,
    start: tuple[float, float] = SOUTH,
    end: tuple[float, float] = NORTH,
    *,
    courses: int = 12,
    spacing_nm: float = 4.0,
    levels: Levels = lattices.NO_LEVELS,
    stretch: float = 1.2,
) -> Lattice:
    return lattices.build(
        sea,
        start,
        end,
        spacing_nm=spacing_nm,
        offsets=stencil.triangular(courses),
        area=ellipse(start, end, stretch),
        levels=levels,
    )


def inner_edges(lattice: Lattice) -> tuple[np.ndarray, np.ndarray]:
    """Edges between vertices of the lattice itself, the two ends left out."""
    a, b = lattice.sources(), lattice.target
    inner = (np.maximum(a, b) < lattice.vertices - 2) & (a >= 0)
    return a[inner], b[inner]


def rhumb_lines(lattice: Lattice) -> Array:
    """Edges as lines of lon and lat, cut in eight: rhumb lines are straight in our plane, not in degrees."""
    a, b = lattice.sources(), lattice.target
    share = np.linspace(0.0, 1.0, 9)
    x = lattice.x[a][:, None] * (1 - share) + lattice.x[b][:, None] * share
    y = lattice.y[a][:, None] * (1 - share) + lattice.y[b][:, None] * share
    lat, lon = from_mercator(x, y)
    return np.stack([lon, lat], axis=2)


# ----------------------------------------------------------------------------------------- true courses


def test_edges_are_courses_thirty_degrees_apart_at_57_north() -> None:
    lattice = lattice_between(open_sea())
    a, b = inner_edges(lattice)
    course = rhumb_course_deg(lattice.lat[a], lattice.lon[a], lattice.lat[b], lattice.lon[b])
    off = np.abs((course + 15.0) % 30.0 - 15.0)
    assert off.max() < 1e-6
    degree = np.bincount(a, minlength=lattice.vertices - 2)
    assert degree.max() == 12
    assert np.count_nonzero(degree == 12) > 100


def test_courses_are_true_bearings_on_the_globe() -> None:
    """A geodesic library knows nothing of our plane: bearing at the middle of an edge is the course."""
    lattice = lattice_between(open_sea(), courses=24)
    sphere = Geodesic(EARTH_RADIUS, 0.0)
    a, b = inner_edges(lattice)
    for k in np.random.default_rng(3).choice(a.size, 60, replace=False).tolist():
        p, q = int(a[k]), int(b[k])
        ends = lattice.lat[p], lattice.lon[p], lattice.lat[q], lattice.lon[q]
        line = sphere.InverseLine(*map(float, ends))
        middle = line.Position(line.s13 / 2)
        course = float(rhumb_course_deg(*ends))
        assert (middle["azi2"] - course + 180.0) % 360.0 - 180.0 == pytest.approx(0.0, abs=1e-3)
        length = float(np.hypot(lattice.x[p] - lattice.x[q], lattice.y[p] - lattice.y[q]))
        assert length * lattice.scale[[p, q]].mean() == pytest.approx(line.s13, rel=1e-5)


def test_neighbours_are_where_the_stencil_says() -> None:
    lattice = lattice_between(open_sea(), courses=36)
    a, b = inner_edges(lattice)
    dx, dy = lattice.x[b] - lattice.x[a], lattice.y[b] - lattice.y[a]
    j = dy / (lattice.spacing_m * stencil.ROW_HEIGHT)
    i = dx / lattice.spacing_m - j / 2
    np.testing.assert_allclose([i, j], np.round([i, j]), atol=1e-6)
    met = set(zip(np.round(i).astype(int).tolist(), np.round(j).astype(int).tolist(), strict=True))
    assert met == set(map(tuple, stencil.triangular(36).tolist()))


def test_spacing_is_true_at_the_middle_latitude() -> None:
    lattice = lattice_between(open_sea(), spacing_nm=4.0)
    middle = np.cos(np.radians((SOUTH[0] + NORTH[0]) / 2))
    assert lattice.spacing_m * middle / METRES_PER_NM == pytest.approx(4.0, rel=1e-3)


# ------------------------------------------------------------------------------------------- sound rows


def assert_sound(lattice: Lattice) -> None:
    n = lattice.vertices
    assert lattice.first[0] == 0
    assert lattice.first[-1] == lattice.target.size
    assert (np.diff(lattice.first) >= 0).all()
    assert lattice.target.min() >= 0
    assert lattice.target.max() < n
    a, b = (c.astype(np.int64) for c in (lattice.sources(), lattice.target))
    assert (a != b).all()
    assert np.unique(a * n + b).size == a.size, "an edge is listed twice"
    x, y = to_mercator(lattice.lat, lattice.lon)
    np.testing.assert_allclose([x, y], [lattice.x, lattice.y], atol=1e-3)
    np.testing.assert_allclose(lattice.scale, np.cos(np.radians(lattice.lat)))


def assert_both_ways(lattice: Lattice) -> None:
    a, b = (c.astype(np.int64) for c in inner_edges(lattice))
    n = lattice.vertices
    np.testing.assert_array_equal(np.sort(a * n + b), np.sort(b * n + a))


@pytest.mark.parametrize("courses", [12, 72])
def test_rows_are_sound_and_go_both_ways(courses: int, baltic: Sea) -> None:
    for lattice in (
        lattice_between(open_sea(), courses=courses),
        lattice_between(baltic, KARLSKRONA, SWINOUJSCIE, courses=courses, levels=Levels(1)),
    ):
        assert_sound(lattice)
        assert_both_ways(lattice)


def test_vertices_lie_in_the_ellipse() -> None:
    lattice = lattice_between(open_sea(), stretch=1.3)
    total = sum(great_circle_m(lattice.lat, lattice.lon, *end) for end in (SOUTH, NORTH))
    allowed = 1.3 * float(great_circle_m(*SOUTH, *NORTH))
    assert float(np.max(total)) <= allowed * (1 + 1e-5)
    # ... and fill it: its area by the spacing's own gives their number.
    a, c = allowed / 2, allowed / 1.3 / 2
    per_vertex = (4.0 * METRES_PER_NM) ** 2 * stencil.ROW_HEIGHT
    assert lattice.vertices == pytest.approx(np.pi * a * np.sqrt(a * a - c * c) / per_vertex, rel=0.06)


def test_a_lattice_too_fine_for_the_memory_is_refused() -> None:
    with pytest.raises(InputError, match="wider spacing"):
        lattice_between(open_sea(), spacing_nm=0.005)


# ----------------------------------------------------------------------------------------------- ends


def test_both_ends_are_joined_by_their_true_courses() -> None:
    lattice = lattice_between(open_sea())
    for end, position in ((lattice.start, SOUTH), (lattice.end, NORTH)):
        assert (lattice.lat[end], lattice.lon[end]) == pytest.approx(position, abs=1e-9)
    leaving = lattice.target[lattice.first[lattice.start] : lattice.first[lattice.start + 1]]
    entering = lattice.sources()[lattice.target == lattice.end]
    for ring, centre in ((leaving, SOUTH), (entering, NORTH)):
        assert ring.size >= 12
        bearing = np.sort(rhumb_course_deg(*centre, lattice.lat[ring], lattice.lon[ring]))
        assert np.diff(np.append(bearing, bearing[0] + 360.0)).max() < 45.0
    assert (lattice.target != lattice.start).all()
    assert lattice.first[lattice.end] == lattice.first[lattice.end + 1]
    # In sight of one another they are joined directly besides.
    assert lattice.end in leaving


def test_ends_behind_land_are_not_joined_across_it() -> None:
    # A wall between them, open at its western end.
    wall = np.array([[57.0, 18.2, 57.1, 26.0]])
    sea = Sea(raster_of(53.0, 14.0, 61.0, 26.0, cell=900.0, land=wall))
    lattice = lattice_between(sea, stretch=1.6)
    leaving = lattice.target[lattice.first[lattice.start] : lattice.first[lattice.start + 1]]
    assert lattice.end not in leaving
    assert connected(lattice)
    a, b = lattice.sources(), lattice.target
    over = (lattice.lat[a] < 57.05) & (lattice.lat[b] >= 57.05)
    share = (57.05 - lattice.lat[a]) / np.where(over, lattice.lat[b] - lattice.lat[a], 1.0)
    crossing = lattice.lon[a] + (lattice.lon[b] - lattice.lon[a]) * share
    assert over.any()
    assert (crossing[over] < 18.2).all()


# ------------------------------------------------------------------------------------------------ land


@pytest.mark.parametrize(
    ("start", "end", "levels"),
    [
        (KARLSKRONA, SWINOUJSCIE, Levels()),
        (KARLSKRONA, SWINOUJSCIE, Levels(3)),
        (NYNAESHAMN, NORRTAELJE, Levels(4)),
        (WESTERVIK, KALMAR_SOUTH, Levels(3)),
    ],
    ids=["open", "three levels", "Stockholm archipelago", "Kalmar Sound"],
)
def test_no_edge_crosses_land(
    start: tuple[float, float], end: tuple[float, float], levels: Levels, baltic: Sea
) -> None:
    lattice = lattice_between(baltic, start, end, courses=24, levels=levels)
    lines = rhumb_lines(lattice)
    assert len(lines) > 1000
    assert np.count_nonzero(coast.land_on_lines(lines)) == 0


# ---------------------------------------------------------------------------------------------- levels


@pytest.mark.parametrize(
    ("start", "end"),
    [(WESTERVIK, KALMAR_SOUTH), (NYNAESHAMN, NORRTAELJE)],
    ids=["Kalmar Sound", "Stockholm archipelago"],
)
def test_levels_lead_through_narrow_water(
    start: tuple[float, float], end: tuple[float, float], baltic: Sea
) -> None:
    lattice = lattice_between(baltic, start, end, courses=36, levels=Levels(4))
    assert connected(lattice)
    found = search(lattice, wind_field(steady_wind(12.0, 90.0)), speed_table(sloop(), Handling()), T0)
    path = found.path(lattice.end)
    legs = [
        great_circle_m(lattice.lat[p], lattice.lon[p], lattice.lat[q], lattice.lon[q])
        for p, q in itertools.pairwise(path.tolist())
    ]
    assert sum(map(float, legs)) < 1.3 * float(great_circle_m(*start, *end))


def test_a_level_halves_the_spacing_near_the_shore_only(baltic: Sea) -> None:
    coarse = lattice_between(baltic, KARLSKRONA, SWINOUJSCIE)
    fine = lattice_between(baltic, KARLSKRONA, SWINOUJSCIE, levels=Levels(1))
    a, b = inner_edges(fine)
    length = np.hypot(fine.x[a] - fine.x[b], fine.y[a] - fine.y[b]) / fine.spacing_m
    np.testing.assert_allclose(
        np.unique(np.round(length, 6)), [0.5, round(3**0.5 / 2, 6), 1.0, round(3**0.5, 6)]
    )
    half = np.union1d(a[length < 0.95], b[length < 0.95])
    room = baltic.clearance_m(fine.lat[half], fine.lon[half])
    assert (room <= 2.01 * fine.spacing_m / 2).all()
    assert coarse.vertices < fine.vertices < 4 * coarse.vertices
    # The coarse vertices are all still there.
    np.testing.assert_allclose(fine.x[: coarse.vertices - 2], coarse.x[:-2])


def test_a_port_on_open_water_needs_no_way_out() -> None:
    levels = Levels(1, 2, (np.empty((0, 4)), np.empty((0, 4))))
    assert lattice_between(open_sea(), levels=levels).vertices == lattice_between(open_sea()).vertices


# ----------------------------------------------------------------------------------------- monotonicity


def test_more_courses_are_never_slower() -> None:
    sea, speeds, field = open_sea(), speed_table(sloop(), Handling()), wind_field(steady_wind(14.0, 20.0))
    arrivals = []
    for courses in stencil.COURSES[1:]:
        lattice = lattice_between(sea, courses=courses)
        arrivals.append(float(search(lattice, field, speeds, T0).arrival[lattice.end]))
    assert arrivals == sorted(arrivals, reverse=True)
    assert arrivals[-1] < arrivals[0]


def test_less_water_is_never_faster() -> None:
    speeds, field = speed_table(sloop(), Handling()), wind_field(steady_wind(14.0, 100.0))
    blocks = np.array(
        [
            [56.9, 18.8, 57.0, 19.6],
            [57.2, 18.6, 57.3, 19.2],
            [56.6, 18.4, 56.7, 18.6],
            [57.0, 19.3, 57.4, 19.4],
        ]
    )
    arrivals = []
    for number in range(len(blocks) + 1):
        sea = Sea(raster_of(53.0, 14.0, 61.0, 26.0, cell=900.0, land=blocks[:number]))
        lattice = lattice_between(sea, courses=36, spacing_nm=2.0, stretch=1.5)
        arrivals.append(float(search(lattice, field, speeds, T0).arrival[lattice.end]))
    assert arrivals == sorted(arrivals)
    assert np.isfinite(arrivals[-1])
    assert arrivals[0] < arrivals[-1]


# --------------------------------------------------------------------------------------------- classic


def test_classic_lattice_is_r1s() -> None:
    lattice = classic.lattice(open_sea(), SOUTH, NORTH, spacing_nm=6.0)
    a, b = lattice.sources(), lattice.target
    into_end = b == lattice.end
    assert np.count_nonzero(into_end) == classic.ENTERED_FROM
    assert lattice.first[lattice.end] == lattice.first[lattice.end + 1]
    x, y = to_mercator(*SOUTH)
    assert (lattice.x[lattice.start], lattice.y[lattice.start]) == pytest.approx((float(x), float(y)))
    course = rhumb_course_deg(lattice.lat[a], lattice.lon[a], lattice.lat[b], lattice.lon[b])
    off = np.abs((course + 15.0) % 30.0 - 15.0)
    assert off[~into_end].max() < 1e-6
    side = np.hypot(lattice.x[a] - lattice.x[b], lattice.y[a] - lattice.y[b])[~into_end] / lattice.spacing_m
    np.testing.assert_allclose(np.unique(np.round(side, 6)), [round(3**0.5, 6), 2.0])


def test_classic_rows_read_as_published() -> None:
    """``0 --> 1 2``: numbered by the distance from the start, which is 0; the end is the last one."""
    lattice = classic.lattice(open_sea(), SOUTH, NORTH, spacing_nm=8.0)
    rows = classic.rows_as_published(lattice)
    assert rows[-1] == f"{lattice.vertices - 1} -->"
    away = np.hypot(lattice.x - lattice.x[lattice.start], lattice.y - lattice.y[lattice.start])
    order = sorted(range(lattice.vertices), key=lambda v: (v == lattice.end, away[v], v))
    assert (order[0], order[-1]) == (lattice.start, lattice.end)
    for number, (v, row) in enumerate(zip(order, rows, strict=True)):
        name, targets = row.split(" -->")
        assert int(name) == number
        led_to = sorted(order[int(t)] for t in targets.split())
        assert led_to == sorted(lattice.target[lattice.first[v] : lattice.first[v + 1]].tolist())


def test_karlskrona_swinoujscie_has_about_r1s_twenty_vertices(baltic: Sea) -> None:
    ports = load_ports()
    ends = [baltic.snap(p.lat, p.lon) for p in (find_port(n, ports) for n in ("Karlskrona", "Swinoujscie"))]
    lattice = classic.lattice(baltic, *((end.lat, end.lon) for end in ends))
    assert 19 <= lattice.vertices <= 21
    assert len(classic.rows_as_published(lattice)) == lattice.vertices
