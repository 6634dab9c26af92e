"""Safety zones (R3): fine near shores and hazards, coarse at sea, and one lattice all the same."""

from __future__ import annotations

import numpy as np
import pytest

from seacruise.errors import InputError
from seacruise.geodesy import from_mercator, great_circle_m, to_mercator
from seacruise.routing import lattice as lattices
from seacruise.routing import stencil
from seacruise.routing.lattice import Area, Lattice, Levels
from seacruise.routing.search import connected
from seacruise.sea import Sea, coast
from seacruise.sea.zones import Zone, Zones
from seacruise.units import METRES_PER_NM
from tests.routing.sounds import COARSE_NM, DEEPEST, SOUNDS, ellipse, lattice_through, shortest_nm
from tests.routing.test_lattice import assert_both_ways, assert_sound, inner_edges, rhumb_lines
from tests.routing.worlds import open_sea, raster_of


@pytest.mark.parametrize("kind", ["triangular", "rectangular"])
@pytest.mark.parametrize("sound", SOUNDS)
def test_narrow_water_is_as_passable_as_on_a_fine_lattice(
    sound: str, kind: stencil.Kind, baltic: Sea
) -> None:
    zones = Levels(safety_radius_m=0.5 * METRES_PER_NM, safety_levels=DEEPEST)
    safe = lattice_through(baltic, sound, kind=kind, levels=zones)
    fine = lattice_through(baltic, sound, kind=kind, spacing_nm=COARSE_NM / 2**DEEPEST)
    assert shortest_nm(safe) < shortest_nm(fine) * 1.01
    assert safe.vertices < 0.5 * fine.vertices
    assert_sound(safe)
    assert_both_ways(safe)
    lines = rhumb_lines(safe)
    some = np.random.default_rng(5).choice(len(lines), min(len(lines), 40_000), replace=False)
    assert np.count_nonzero(coast.land_on_lines(lines[some])) == 0


@pytest.mark.parametrize("sound", SOUNDS)
def test_the_coarse_lattice_alone_leads_round_them_or_nowhere(sound: str, baltic: Sea) -> None:
    coarse = lattice_through(baltic, sound)
    safe = lattice_through(baltic, sound, levels=Levels(safety_levels=DEEPEST))
    assert shortest_nm(coarse) > 1.15 * shortest_nm(safe)


# ------------------------------------------------------------------------------------ what is refined


ISLAND = np.array([[56.9, 18.8, 57.1, 19.2]])
ROUND_IT = ((56.5, 18.4), (57.5, 19.6))


def round_island(levels: Levels, *, mesh: stencil.Mesh = stencil.TRIANGLES) -> Lattice:
    sea = Sea(raster_of(55.5, 16.0, 58.5, 22.0, cell=300.0, land=ISLAND))
    offsets = stencil.triangular(12) if mesh == stencil.TRIANGLES else stencil.rectangular(8)
    return lattices.build(
        sea,
        *ROUND_IT,
        spacing_nm=4.0,
        offsets=offsets,
        mesh=mesh,
        area=ellipse(*ROUND_IT, 1.3),
        levels=levels,
    )


def shore_nm(lattice: Lattice) -> np.ndarray:
    """True distance of each vertex from the island [nm], by the nearest place of its border."""
    south, west, north, east = ISLAND[0]
    lat, lon = np.clip(lattice.lat, south, north), np.clip(lattice.lon, west, east)
    return np.asarray(great_circle_m(lattice.lat, lattice.lon, lat, lon)) / METRES_PER_NM


@pytest.mark.parametrize("mesh", [stencil.TRIANGLES, stencil.SQUARES], ids=["triangles", "squares"])
def test_all_water_within_the_radius_is_fine_and_none_far_beyond(mesh: stencil.Mesh) -> None:
    radius_nm, deepest = 3.0, 3
    levels = Levels(safety_radius_m=radius_nm * METRES_PER_NM, safety_levels=deepest)
    safe, fine = round_island(levels, mesh=mesh), round_island(Levels(), mesh=mesh)
    everywhere = lattices.build(
        Sea(raster_of(55.5, 16.0, 58.5, 22.0, cell=300.0, land=ISLAND)),
        *ROUND_IT,
        spacing_nm=4.0 / 2**deepest,
        offsets=stencil.triangular(6) if mesh == stencil.TRIANGLES else stencil.rectangular(8),
        mesh=mesh,
        area=ellipse(*ROUND_IT, 1.3),
    )
    cell_nm = 300.0 * np.cos(np.radians(57.0)) / METRES_PER_NM
    near = shore_nm(everywhere)[:-2] <= radius_nm - 2 * cell_nm
    present = {(round(float(x)), round(float(y))) for x, y in zip(safe.x, safe.y, strict=True)}
    wanted = {
        (round(float(x)), round(float(y)))
        for x, y in zip(everywhere.x[:-2][near], everywhere.y[:-2][near], strict=True)
    }
    assert len(wanted) > 500
    assert wanted <= present
    # The finest edges lie nowhere else; the raster counts over corners, hence the root of two.
    a, b = inner_edges(safe)
    length = np.hypot(safe.x[a] - safe.x[b], safe.y[a] - safe.y[b])
    finest = np.unique(a[length < 1.01 * safe.spacing_m / 2**deepest])
    assert shore_nm(safe)[finest].max() < 2**0.5 * (radius_nm + 2 * cell_nm)
    assert fine.vertices < safe.vertices < everywhere.vertices


def test_a_wider_radius_holds_the_narrower_one() -> None:
    counts = [
        round_island(Levels(safety_radius_m=nm * METRES_PER_NM, safety_levels=3)).vertices
        for nm in (0.0, 1.0, 2.0, 4.0, 8.0)
    ]
    assert counts == sorted(counts)
    assert counts[0] == round_island(Levels(3)).vertices
    assert counts[-1] > 2 * counts[0]


def test_a_corridor_is_refined_like_any_other_area() -> None:
    """Two pieces of code tell what is near the shore; over the same water they must say the same."""
    sea = Sea(raster_of(55.5, 16.0, 58.5, 22.0, cell=300.0, land=ISLAND))
    x, y = to_mercator([56.5, 57.5], [19.0, 19.0])
    line = np.array([[x[0], y[0], x[1], y[1]]])
    levels = Levels(safety_radius_m=2.0 * METRES_PER_NM, safety_levels=2)

    def vertices(area: Area) -> set[tuple[int, int]]:
        built = lattices.build(
            sea,
            (56.5, 19.0),
            (57.5, 19.0),
            spacing_nm=3.0,
            offsets=stencil.triangular(12),
            area=area,
            levels=levels,
        )
        inside = np.abs(built.x - x[0]) < 20_000.0
        inside &= (built.y > y[0]) & (built.y < y[1])
        return {
            (round(float(a)), round(float(b))) for a, b in zip(built.x[inside], built.y[inside], strict=True)
        }

    # Four times as wide, because a corridor narrows by half with each level.
    assert vertices(Area("corridor", line, 80_100.0)) == vertices(Area("rectangle", line, 80_100.0))


def test_a_radius_that_the_raster_cannot_tell_is_refused() -> None:
    with pytest.raises(InputError, match=r"safety radius of 60 nm .* up to \d+ nm"):
        round_island(Levels(safety_radius_m=60 * METRES_PER_NM, safety_levels=1))


# ---------------------------------------------------------------------------------------------- hazards


def wall() -> Zone:
    """Make a closed area across the direct line of `ROUND_IT`, thin and long."""
    west, east, south, north = 18.7, 19.35, 56.99, 57.01
    ring = np.array([[west, south], [east, south], [east, north], [west, north], [west, south]])
    return Zone("Wall", (ring,))


def past_the_wall(levels: Levels) -> Lattice:
    return lattices.build(
        open_sea(cell=300.0, south=55.5, west=16.0, north=58.5, east=22.0),
        *ROUND_IT,
        spacing_nm=6.0,
        offsets=stencil.triangular(36),
        area=ellipse(*ROUND_IT, 1.4),
        levels=levels,
    )


def test_around_a_hazard_the_lattice_is_fine_and_the_way_is_shorter() -> None:
    zones = Zones((wall(),))
    plain = past_the_wall(Levels())
    safe = past_the_wall(Levels(safety_radius_m=1.0 * METRES_PER_NM, safety_levels=4, hazards=zones))
    assert connected(safe)
    assert_sound(safe)
    assert_both_ways(safe)
    # At sea, far from it, nothing changed.
    border = np.array([[56.99, 18.7, 57.01, 19.35]])[0]
    lat, lon = np.clip(safe.lat, border[0], border[2]), np.clip(safe.lon, border[1], border[3])
    away = np.asarray(great_circle_m(safe.lat, safe.lon, lat, lon)) / METRES_PER_NM
    a, b = inner_edges(safe)
    length = np.hypot(safe.x[a] - safe.x[b], safe.y[a] - safe.y[b]) / safe.spacing_m
    finest = np.unique(a[length < 1.01 / 16])
    assert finest.size > 300
    assert away[finest].max() < 1.2
    straight = float(great_circle_m(*ROUND_IT[0], *ROUND_IT[1])) / METRES_PER_NM
    assert straight < shortest_nm(safe, zones) < shortest_nm(plain, zones) - 0.5


def test_hazards_of_other_seas_cost_nothing() -> None:
    ring = np.array([[10.0, 54.0], [10.5, 54.0], [10.5, 54.4], [10.0, 54.4], [10.0, 54.0]])
    far = Zones((Zone("Far", (ring,)),))
    levels = Levels(safety_radius_m=2.0 * METRES_PER_NM, safety_levels=4, hazards=far)
    assert past_the_wall(levels).vertices == past_the_wall(Levels()).vertices


def test_a_hazard_inside_a_corridor_is_refined_too() -> None:
    sea = open_sea(cell=300.0, south=55.5, west=16.0, north=58.5, east=22.0)
    x, y = to_mercator(*zip(*ROUND_IT, strict=True))
    built = lattices.build(
        sea,
        *ROUND_IT,
        spacing_nm=6.0,
        offsets=stencil.triangular(12),
        area=Area("corridor", np.array([[x[0], y[0], x[1], y[1]]]), 60_000.0),
        levels=Levels(safety_radius_m=1.0 * METRES_PER_NM, safety_levels=2, hazards=Zones((wall(),))),
    )
    a, b = inner_edges(built)
    length = np.hypot(built.x[a] - built.x[b], built.y[a] - built.y[b]) / built.spacing_m
    lat, _ = from_mercator(built.x[a], built.y[a])
    finest = length < 0.26
    assert np.count_nonzero(finest) > 50
    assert np.abs(lat[finest] - 57.0).max() < 0.1


# ------------------------------------------------------------------------------------------ never slower


@pytest.mark.parametrize("kind", ["triangular", "rectangular"])
def test_a_refined_lattice_has_every_edge_of_the_coarse_one(kind: stencil.Kind, baltic: Sea) -> None:
    """Those of the two ends as well; so more levels are never slower."""
    lengths: list[float] = []
    edges: set[tuple[int, ...]] = set()
    for deepest in range(DEEPEST + 1):
        levels = Levels(safety_radius_m=0.5 * METRES_PER_NM, safety_levels=deepest)
        lattice = lattice_through(baltic, "Stockholm archipelago", kind=kind, levels=levels)
        a, b = lattice.sources(), lattice.target
        xy = np.stack([lattice.x[a], lattice.y[a], lattice.x[b], lattice.y[b]], axis=1)
        here = set(map(tuple, np.round(xy).astype(np.int64).tolist()))
        assert edges <= here
        edges = here
        lengths.append(shortest_nm(lattice))
    assert lengths == sorted(lengths, reverse=True)
    assert lengths[-1] < 0.9 * lengths[0]
