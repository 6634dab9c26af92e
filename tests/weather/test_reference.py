"""The wind between the nodes, held against xarray's interpolation: code that shares nothing with ours."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from seacruise.weather.blend import blend
from seacruise.weather.wind import Wind
from tests.weather.worlds import DAY, uniform

xarray: Any = pytest.importorskip(
    "xarray", reason="XARRAY ABSENT: the independent interpolation is not there (pip install -e .[dev])"
)

AS_NEAR = 1e-5
"""Greatest difference allowed [m/s]; the fields are float32 of up to 25 m/s."""


def random_wind(seed: int) -> Wind:
    """Wind of a random field on random axes; the times have random steps."""
    rng = np.random.default_rng(seed)
    hours = np.concatenate([[0.0], np.cumsum(rng.choice([0.5, 1.0, 3.0, 6.0], rng.integers(1, 7)))])
    lat: Any = rng.uniform(50, 60) + rng.uniform(0.05, 1.5) * np.arange(rng.integers(2, 9))
    lon: Any = rng.uniform(-20, 20) + rng.uniform(0.05, 1.5) * np.arange(rng.integers(2, 9))
    wind = uniform(hours=hours, lat=lat, lon=lon)
    u, v, gust = rng.uniform(-25, 25, (3, *wind.u.shape)).astype(np.float32)
    return Wind(wind.time, lat, lon, u, v, wind.forecast, gust=np.abs(gust))


def as_xarray(wind: Wind) -> Any:
    grids = {
        name: (("time", "lat", "lon"), getattr(wind, name).astype(np.float64)) for name in ("u", "v", "gust")
    }
    return xarray.Dataset(grids, coords={"time": wind.time, "lat": wind.lat, "lon": wind.lon})


def inside(rng: np.random.Generator, axis: Any, count: int) -> Any:
    return rng.uniform(axis[0], axis[-1], count)


@pytest.mark.parametrize("seed", range(40))
def test_the_wind_between_nodes_is_what_xarray_finds(seed: int) -> None:
    wind, rng = random_wind(seed), np.random.default_rng(seed + 1000)
    time, lat, lon = (inside(rng, axis, 60) for axis in (wind.time, wind.lat, wind.lon))
    along = {name: ("place", values) for name, values in (("time", time), ("lat", lat), ("lon", lon))}
    wanted = as_xarray(wind).interp({key: xarray.DataArray(x, dims=d) for key, (d, x) in along.items()})
    u, v = wind.at(time, lat, lon)
    np.testing.assert_allclose(u, wanted["u"], atol=AS_NEAR, rtol=0)
    np.testing.assert_allclose(v, wanted["v"], atol=AS_NEAR, rtol=0)
    assert wind.gust is not None
    np.testing.assert_allclose(
        wind.interpolate(wind.gust, time, lat, lon), wanted["gust"], atol=AS_NEAR, rtol=0
    )


@hypothesis_settings(max_examples=15)
@given(st.integers(0, 10**6))
def test_a_blend_is_the_mean_of_what_xarray_finds(seed: int) -> None:
    rng = np.random.default_rng(seed)
    winds = []
    for k in range(2):
        hours = np.cumsum(rng.choice([0.5, 1.0, 3.0], 6))
        lat: Any = 54 + rng.uniform(0, 0.4) + rng.uniform(0.2, 0.5) * np.arange(8)
        lon: Any = 16 + rng.uniform(0, 0.4) + rng.uniform(0.2, 0.5) * np.arange(8)
        wind = uniform(hours=hours, lat=lat, lon=lon)
        u, v = rng.uniform(-25, 25, (2, *wind.u.shape)).astype(np.float32)
        winds.append(Wind(wind.time, lat, lon, u, v, wind.forecast, gust=np.abs(u) + k))
    if max(one.time[0] for one in winds) > min(one.time[-1] for one in winds):
        return
    mean = blend(winds, [3.0, 1.0])
    assert mean.time[0] >= DAY.timestamp()
    # the ends of a common span may lie beyond an axis by the rounding of the last digit
    found = [
        as_xarray(one).interp(
            time=mean.time,
            lat=np.clip(mean.lat, one.lat[0], one.lat[-1]),
            lon=np.clip(mean.lon, one.lon[0], one.lon[-1]),
        )
        for one in winds
    ]
    for name in ("u", "v", "gust"):
        wanted = 0.75 * found[0][name].values + 0.25 * found[1][name].values
        np.testing.assert_allclose(getattr(mean, name), wanted, atol=2 * AS_NEAR, rtol=0)
