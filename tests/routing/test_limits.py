"""Laws of what is forbidden: closed areas, gusts and waves take ways away and never add one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from seacruise.geodesy import to_mercator
from seacruise.routing.field import (
    NO_LIMITS,
    Handling,
    SeaLimits,
    SpeedTable,
    WindField,
    handling_in_knots,
    speed_table,
    wind_field,
)
from seacruise.routing.lattice import Lattice
from seacruise.routing.search import search
from seacruise.sea.zones import NO_ZONES, Zone, Zones
from seacruise.units import MS_PER_KNOT
from seacruise.weather.wind import Wind
from tests.routing.worlds import (
    HOUR,
    T0,
    forecast,
    random_field,
    random_lattice,
    random_table,
    sloop,
    steady_wind,
)

seeds = st.integers(0, 2**32 - 1)
many = hypothesis_settings(max_examples=max(200, hypothesis_settings().max_examples))


def random_zones(rng: np.random.Generator, count: int) -> list[Zone]:
    """Scatter squares over the sea of `random_lattice`."""
    zones = []
    for k in range(count):
        lat, lon, half = rng.uniform(57.0, 58.3), rng.uniform(18.0, 20.4), rng.uniform(0.02, 0.25)
        south, north, west, east = lat - half, lat + half, lon - 2 * half, lon + 2 * half
        ring = np.array([[west, south], [east, south], [east, north], [west, north], [west, south]])
        zones.append(Zone(f"Area {k}", (ring,)))
    return zones


def arrival(lattice: Lattice, field: WindField, speeds: SpeedTable, zones: Zones = NO_ZONES) -> float:
    """Give the arrival at the end: elsewhere the search stops looking once that is known."""
    return float(search(lattice, field, speeds, T0, zones=zones).arrival[lattice.end])


@many
@given(seed=seeds, some=st.integers(0, 3), more=st.integers(1, 3))
def test_more_closed_areas_are_never_faster(seed: int, some: int, more: int) -> None:
    rng = np.random.default_rng(seed)
    lattice, field = random_lattice(rng, 20), random_field(rng)
    zones = random_zones(rng, some + more)
    speeds = random_table(rng)
    few, all_of_them = (arrival(lattice, field, speeds, Zones(tuple(z))) for z in (zones[:some], zones))
    assert all_of_them >= few


@many
@given(seed=seeds)
def test_no_edge_of_the_way_found_touches_a_closed_area(seed: int) -> None:
    rng = np.random.default_rng(seed)
    lattice, field = random_lattice(rng, 20), random_field(rng)
    zones = Zones(tuple(random_zones(rng, 3)))
    found = search(lattice, field, random_table(rng), T0, zones=zones)
    path = found.path(lattice.end)
    if path.size > 1:
        x, y = lattice.x[path], lattice.y[path]
        legs = np.stack([x[:-1], y[:-1], x[1:], y[1:]], axis=1)
        for zone in zones.zones:
            (west, south), (east, north) = zone.rings[0].min(axis=0), zone.rings[0].max(axis=0)
            (x0, x1), (y0, y1) = to_mercator([south, north], [west, east])
            for share in np.linspace(0.0, 1.0, 50):
                px, py = (
                    legs[:, 0] + (legs[:, 2] - legs[:, 0]) * share,
                    legs[:, 1] + (legs[:, 3] - legs[:, 1]) * share,
                )
                assert not ((px > x0) & (px < x1) & (py > y0) & (py < y1)).any()


def rough(rng: np.random.Generator) -> Wind:
    """Make a wind with gusts and waves of its own on every node, the same all day."""
    lat, lon = np.arange(56.5, 59.0, 0.5), np.arange(17.5, 21.0, 0.5)
    shape = (2, lat.size, lon.size)
    u, v = (np.repeat(rng.uniform(-9.0, 9.0, (1, *shape[1:])), 2, axis=0) for _ in range(2))
    gust, wave = (
        np.repeat(rng.uniform(low, high, (1, *shape[1:])), 2, axis=0) for low, high in ((4, 25), (0, 5))
    )
    times = np.array([T0 - HOUR, T0 + 90 * HOUR])
    return Wind(
        times,
        lat,
        lon,
        u.astype(np.float32),
        v.astype(np.float32),
        forecast(*times.tolist()),
        gust=gust.astype(np.float32),
        wave=wave.astype(np.float32),
    )


@given(seed=seeds, gust=st.floats(5.0, 25.0), wave=st.floats(0.5, 5.0), share=st.floats(0.5, 1.0))
def test_a_tighter_limit_is_never_faster_and_a_limit_never_faster_than_none(
    seed: int, gust: float, wave: float, share: float
) -> None:
    rng = np.random.default_rng(seed)
    lattice, wind, speeds = random_lattice(rng, 20), rough(rng), speed_table(sloop(), Handling())
    free, wide, tight = (
        arrival(lattice, wind_field(wind, slice_s=HOUR, limits=limits), speeds)
        for limits in (NO_LIMITS, SeaLimits(gust, wave), SeaLimits(gust * share, wave * share))
    )
    assert wide >= free
    assert tight >= wide


def test_a_limit_stops_her_where_waves_begin_and_only_there() -> None:
    wind = replace(steady_wind(12.0, 270.0), wave=np.full((2, 1, 1), 1.5, dtype=np.float32))
    lattice = random_lattice(np.random.default_rng(2), 20, out_degree=8)
    speeds = speed_table(sloop(), Handling())
    below, above = (
        search(lattice, wind_field(wind, limits=SeaLimits(None, limit)), speeds, T0).arrival
        for limit in (1.51, 1.49)
    )
    free = search(lattice, wind_field(wind), speeds, T0).arrival
    assert np.array_equal(below, free)
    assert np.isfinite(above).sum() == np.isfinite(free[lattice.start])
    assert above[lattice.start] == T0


def test_limits_given_in_knots_are_tightened_together() -> None:
    handling = handling_in_knots(
        tacking=True,
        percent=100.0,
        motor_below_kn=None,
        motor_speed_kn=5.0,
        max_wind_kn=20.0,
        max_gust_kn=30.0,
        max_wave_m=2.0,
    )
    part = handling.within(0.9)
    assert part.max_wind == pytest.approx(18.0 * MS_PER_KNOT)
    assert part.limits.max_gust == pytest.approx(27.0 * MS_PER_KNOT)
    assert part.limits.max_wave == pytest.approx(1.8)
    assert Handling().within(0.9) == Handling()
