"""The fine coast: straits, lakes and harbours as they are, and the raster held against the polygons."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import shapely
from numpy.typing import NDArray

from seacruise.errors import NoPassageError
from seacruise.geodesy import destination, from_mercator, great_circle_m, to_mercator
from seacruise.ports import Port, load_ports
from seacruise.sea import Sea, coast
from seacruise.sea import _kernels as k
from seacruise.units import METRES_PER_NM
from tests.routing.worlds import raster_of

Array = NDArray[np.float64]
Position = tuple[float, float]

# A position on either side, and the box (south, west, north, east) in which a way between them is sought.
STRAITS: dict[str, tuple[Position, Position, tuple[float, float, float, float]]] = {
    "Oresund": ((55.45, 12.75), (56.2, 12.45), (55.3, 12.2, 56.3, 13.1)),
    "Great Belt": ((54.75, 10.95), (55.85, 10.85), (54.6, 10.75, 56.0, 11.4)),
    "Little Belt": ((55.2, 9.85), (55.65, 10.0), (55.1, 9.5, 55.75, 10.15)),
    "Kiel fjord": ((54.33, 10.16), (54.5, 10.3), (54.3, 10.1, 54.55, 10.4)),
    "Kalmar Sound": ((56.35, 16.2), (57.1, 16.75), (56.25, 15.9, 57.2, 16.95)),
    "Stockholm entrance (Sandhamn-Wasahamnen)": (
        (59.28, 18.93),
        (59.325, 18.10),
        (59.2, 18.05, 59.45, 19.0),
    ),
    "Stralsund Strelasund S": ((54.2, 13.5), (54.30, 13.11), (54.05, 13.05, 54.32, 13.6)),
    "Stralsund N": ((54.33, 13.12), (54.58, 12.95), (54.31, 12.85, 54.65, 13.2)),
    "Swinoujscie-Szczecin lagoon": ((53.95, 14.28), (53.75, 14.35), (53.6, 14.1, 54.0, 14.6)),
    "Klaipeda-Curonian lagoon": ((55.73, 21.05), (55.4, 21.1), (55.2, 20.8, 55.8, 21.3)),
    "Svendborgsund": ((55.03, 10.52), (55.07, 10.75), (54.95, 10.4, 55.15, 10.8)),
    "Mariehamn": ((60.09, 19.92), (59.9, 19.9), (59.8, 19.6, 60.15, 20.2)),
    "Turku archipelago": ((60.42, 22.1), (59.75, 21.4), (59.6, 21.0, 60.5, 22.4)),
    "Irbe strait": ((57.75, 21.7), (57.8, 22.8), (57.5, 21.5, 58.1, 23.0)),
    "Moon Sound (Suur vain)": ((58.4, 23.4), (58.95, 23.3), (58.3, 23.1, 59.05, 23.6)),
    "Karlskrona": ((56.155, 15.59), (55.95, 15.6), (55.9, 15.4, 56.2, 15.8)),
    "Gdansk Bay-Vistula Lagoon": ((54.6, 19.6), (54.5, 19.85), (54.4, 19.4, 54.75, 20.1)),
    "Fehmarnsund": ((54.38, 11.0), (54.38, 11.25), (54.3, 10.95, 54.42, 11.3)),
    "Fårösund": ((57.82, 19.15), (57.95, 18.98), (57.78, 18.9, 57.98, 19.25)),
    "Göteborg harbour": ((57.69, 11.9), (57.65, 11.6), (57.6, 11.5, 57.75, 12.0)),
    "Flensburg fjord": ((54.81, 9.44), (54.8, 10.0), (54.7, 9.4, 54.95, 10.1)),
    "Trave Travemünde-Lübeck": ((53.98, 10.92), (53.89, 10.75), (53.85, 10.65, 54.05, 11.0)),
    "Kalmar bridge": ((56.60, 16.42), (56.75, 16.5), (56.55, 16.3, 56.8, 16.7)),
    "Åland Sea": ((59.9, 19.4), (60.4, 19.1), (59.7, 18.8, 60.6, 19.7)),
}

# The survey looked at rasters; the shoreline itself leaves the narrows at Middelfart open, as they are.
OPEN_BY_THE_SHORELINE = {"Little Belt"}

# Harbours up rivers and lagoons that the coast closes: farther from open water than a mile [nm].
FAR = {
    "Szczecin": 31.0, "Trzebież": 17.0, "Ueckermünde": 13.0, "Lübeck": 8.0, "Rīga": 4.5, "Gdańsk": 3.0,
    "Kappeln": 2.0, "Oulu": 1.5, "Horsens": 1.5,
}  # fmt: skip

LAKES = {
    "Vänern": (58.9, 13.3),
    "Vättern": (58.3, 14.55),
    "Ladoga": (60.8, 30.8),
    "Mälaren": (59.45, 17.0),
    "Hjälmaren": (59.23, 15.8),
    "Peipus": (58.6, 27.5),
}


@pytest.fixture(scope="session")
def survey(shared_data: Path) -> dict[str, str]:
    data = json.loads((shared_data / "coast" / "passability.json").read_text(encoding="utf-8"))
    column = 1 + data["masks"].index("osm100")
    return {row[0]: row[column] for row in data["passability"]}


def way_between(sea: Sea, name: str) -> tuple[bool, float]:
    """Whether a strait is open in its box, and how far its two positions are from water [nm]."""
    from scipy import ndimage

    *ends, (south, west, north, east) = STRAITS[name]
    x, y = to_mercator([south, north], [west, east])
    columns, rows = (np.floor(c).astype(int) for c in sea.water.lines(x, y))
    labels, _ = ndimage.label(sea.water.cells[rows[0] : rows[1], columns[0] : columns[1]] >= k.SHORE_WATER)
    wet = np.argwhere(labels)
    met, away = [], []
    for end in ends:
        column, row = (float(c) for c in sea.water.lines(*to_mercator(*end)))
        distance = np.hypot(wet[:, 0] + 0.5 + rows[0] - row, wet[:, 1] + 0.5 + columns[0] - column)
        nearest = int(np.argmin(distance))
        met.append(int(labels[tuple(wet[nearest])]))
        away.append(float(distance[nearest]) * sea.water.cell * 0.6 / METRES_PER_NM)
    return met[0] == met[1], max(away)


def test_every_strait_of_the_survey_is_looked_at(survey: dict[str, str]) -> None:
    assert set(survey) == set(STRAITS)


@pytest.mark.parametrize("name", STRAITS)
def test_straits_are_open_as_surveyed(name: str, baltic: Sea, survey: dict[str, str]) -> None:
    is_open, away = way_between(baltic, name)
    if survey[name] == "yes" or name in OPEN_BY_THE_SHORELINE:
        assert is_open
        assert away < 0.5
    else:
        # The water behind is no part of the sea: the nearest that is, is miles off.
        assert not is_open or away > 2.0


# ------------------------------------------------------------------------------------ lakes and harbours


@pytest.mark.parametrize("name", LAKES)
def test_lakes_are_land(name: str, baltic: Sea) -> None:
    lat, lon = LAKES[name]
    rng = np.random.default_rng(2)
    around = lat + rng.uniform(-0.1, 0.1, 500), lon + rng.uniform(-0.1, 0.1, 500)
    assert not baltic.is_water(*around).any()
    assert (baltic.clearance_m(*around) == 0.0).all()


def test_all_open_water_is_one_sea(baltic: Sea) -> None:
    from scipy import ndimage

    _, bodies = ndimage.label(np.asarray(baltic.water.cells) >= k.SHORE_WATER)
    assert bodies == 1


def test_every_harbour_reaches_the_open_sea(baltic: Sea) -> None:
    ports = load_ports()
    assert len(ports) > 150
    far = {}
    for port in ports:
        snap = baltic.snap(port.lat, port.lon, name=port.name)
        assert int(baltic.water.at(*to_mercator(snap.lat, snap.lon))) >= k.WATER, port.name
        told = float(great_circle_m(port.lat, port.lon, snap.lat, snap.lon)) / METRES_PER_NM
        assert snap.distance_nm == pytest.approx(told, abs=1e-6), port.name
        if told > 1.0:
            far[port.name] = told
    assert set(far) <= set(FAR)
    for name, distance in far.items():
        assert distance <= FAR[name], name


def test_the_nearest_water_is_taken(baltic: Sea) -> None:
    for port in load_ports()[::10]:
        snap = baltic.snap(port.lat, port.lon)
        if 0.0 < snap.distance_nm < 1.0:
            nearer = snap.distance_nm * METRES_PER_NM - 300.0
            course, share = np.meshgrid(np.arange(0.0, 360.0, 10.0), np.linspace(0.05, 1.0, 12))
            lat, lon = destination(port.lat, port.lon, course, share * max(nearer, 0.0))
            # Cells with a shore in them do not count; all others nearer than this are dry.
            assert (baltic.water.at(*to_mercator(lat, lon)) < k.WATER).all(), port.name


@pytest.mark.parametrize(
    ("name", "position"),
    [("Caspian", (53.5, 30.0)), ("Minsk", (53.9, 27.55)), ("Berlin-ish", (53.05, 27.0))],
)
def test_a_place_far_inland_is_refused(name: str, position: Position, baltic: Sea) -> None:
    with pytest.raises(NoPassageError, match=name) as caught:
        baltic.snap(*position, name=name)
    assert caught.value.reason == "no-water-path"
    assert caught.value.place == position


# --------------------------------------------------------------------------- the raster and the polygons


def random_lines(sea: Sea, count: int) -> Array:
    """Rhumb lines of 0.05 to 15 nm that begin on open water, as x0, y0, x1, y1 [m]."""
    rng = np.random.default_rng(1)
    lat, lon = rng.uniform(54.0, 65.5, 12 * count), rng.uniform(10.0, 29.0, 12 * count)
    wet = np.flatnonzero(sea.is_water(lat, lon) & ~on_land(lat, lon))[:count]
    assert wet.size == count
    course, length = rng.uniform(0, 360, count), 10 ** rng.uniform(-1.3, 1.2, count) * METRES_PER_NM
    ends = destination(lat[wet], lon[wet], course, length)
    return np.stack([*to_mercator(lat[wet], lon[wet]), *to_mercator(*ends)], axis=1)


def on_land(lat: Array, lon: Array) -> NDArray[np.bool_]:
    """By shapely alone."""
    hit = np.zeros(lat.size, dtype=bool)
    hit[coast.fine_tree().query(shapely.points(lon, lat), predicate="intersects")[0]] = True
    return hit


def as_degrees(lines: Array, *, points: int = 9) -> Array:
    share = np.linspace(0.0, 1.0, points)
    x = lines[:, [0]] * (1 - share) + lines[:, [2]] * share
    y = lines[:, [1]] * (1 - share) + lines[:, [3]] * share
    lat, lon = from_mercator(x, y)
    return np.stack([lon, lat], axis=2)


def test_clear_lines_never_touch_land_and_few_free_ones_are_refused(baltic: Sea) -> None:
    lines = random_lines(baltic, 20_000)
    free = baltic.clear(lines)
    degrees = as_degrees(lines)
    touching = coast.land_on_lines(degrees)
    assert 2_000 > np.count_nonzero(touching) > 1_000
    assert np.count_nonzero(free & touching) == 0
    refused = np.flatnonzero(~free & ~touching)
    assert refused.size < 0.004 * np.count_nonzero(~touching)
    # What is refused passes the shore within the margin: a boat's length or two.
    for line in degrees[refused]:
        assert distance_to_shore_m(line) < 60.0


def distance_to_shore_m(line: Array) -> float:
    """Of a line ``(m, 2)`` of lon and lat, near enough for lines of some miles."""
    box = shapely.box(*(line.min(axis=0) - 0.02), *(line.max(axis=0) + 0.02))
    near = coast.fine_land()[coast.fine_tree().query(box)]
    squeeze = np.array([np.cos(np.radians(line[:, 1].mean())), 1.0])
    shores = shapely.transform(shapely.boundary(near), lambda coords: coords * squeeze)
    away = shapely.distance(shapely.linestrings(line * squeeze), shores)
    return float(away.min(initial=np.inf)) * 111_195.0


def test_lines_are_as_free_one_way_as_the_other(baltic: Sea) -> None:
    lines = random_lines(baltic, 5_000)
    there, back = baltic.clear(lines), baltic.clear(lines[:, [2, 3, 0, 1]])
    np.testing.assert_array_equal(there, back)


def test_water_is_never_where_the_polygons_have_land(baltic: Sea) -> None:
    rng = np.random.default_rng(4)
    lat, lon = rng.uniform(53.5, 65.5, 60_000), rng.uniform(9.5, 30.5, 60_000)
    wet, land = baltic.is_water(lat, lon), on_land(lat, lon)
    wrong = np.flatnonzero(wet & land)
    assert wrong.size == 0, list(zip(lat[wrong].tolist(), lon[wrong].tolist(), strict=True))[:5]
    assert 0.2 < wet.mean() < 0.5


def test_clearance_is_a_distance_that_is_free(baltic: Sea) -> None:
    rng = np.random.default_rng(6)
    lat, lon = rng.uniform(54.0, 65.0, 4_000), rng.uniform(11.0, 28.0, 4_000)
    room = baltic.clearance_m(lat, lon)
    some = np.flatnonzero(room > 500.0)[:200]
    assert some.size == 200
    for i in some.tolist():
        around = destination(lat[i], lon[i], np.arange(0.0, 360.0, 5.0), 0.98 * room[i])
        assert not on_land(*around).any()


# -------------------------------------------------------------------------------------- rasters by hand


def test_a_line_meets_a_wall_and_passes_beside_it() -> None:
    sea = Sea(raster_of(56.0, 17.0, 58.0, 20.0, cell=900.0, land=np.array([[56.9, 18.0, 57.0, 19.0]])))

    def clear(start: Position, end: Position) -> bool:
        x, y = to_mercator([start[0], end[0]], [start[1], end[1]])
        return bool(sea.clear(np.array([[x[0], y[0], x[1], y[1]]]))[0])

    assert not clear((56.5, 18.5), (57.5, 18.5))
    assert clear((56.5, 17.9), (57.5, 17.9))
    assert not clear((56.5, 17.9), (57.5, 18.3))
    assert not clear((56.95, 18.5), (56.95, 18.6))
    assert clear((56.5, 18.5), (56.5, 18.5))
    assert not clear((56.5, 18.5), (59.0, 18.5)), "nothing is known beyond the raster"
    assert not sea.is_water(59.0, 18.5)
    assert sea.is_water(56.5, 18.5)
    assert not sea.is_water(56.95, 18.5)


def test_touching_is_asked_of_every_step(baltic: Sea) -> None:
    # Across Bornholm from the west: water, land, water.
    lon = np.linspace(14.3, 15.5, 400)
    touches = baltic.touches_land(np.full(400, 55.12), lon)
    assert touches.shape == (399,)
    ashore = lon[:-1][touches]
    assert 14.65 < ashore.min() < 14.75
    assert 15.1 < ashore.max() < 15.2


def test_ports_by_hand_are_snapped_the_same(baltic: Sea) -> None:
    port = Port("Somewhere", "", 57.2, 18.9)
    snap = baltic.snap(port.lat, port.lon)
    assert (snap.lat, snap.lon, snap.distance_nm) == (57.2, 18.9, 0.0)
