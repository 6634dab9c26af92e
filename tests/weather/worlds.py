"""Weather made by hand: winds with known values, and files written from them."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import eccodes
import netCDF4
import numpy as np

from seacruise.weather.wind import Forecast, Wind, describe_grid

DAY = datetime(2026, 1, 1, tzinfo=UTC)
ROWS, COLUMNS = 4, 5


def uniform(
    u: float = 3.0,
    v: float = 0.0,
    *,
    hours: Any = (0.0, 6.0, 12.0),
    lat: Any = (54.0, 55.0, 56.0, 57.0),
    lon: Any = (16.0, 17.0, 18.0, 19.0, 20.0),
    name: str = "File a.grb",
    notice: str = "",
    **besides: Any,
) -> Wind:
    """Wind that is the same everywhere; ``gust``, ``wave`` and ``spread`` may be numbers."""
    time = DAY.timestamp() + 3600.0 * np.asarray(hours, dtype=np.float64)
    axes = (time, np.asarray(lat, dtype=np.float64), np.asarray(lon, dtype=np.float64))
    shape = tuple(axis.size for axis in axes)

    def full(value: Any) -> Any:
        return np.broadcast_to(np.float32(value), shape).copy()

    layers = {
        key: full(value) if key in ("gust", "wave", "spread") else value for key, value in besides.items()
    }
    valid_from, valid_to, step_h, resolution = describe_grid(*axes)
    forecast = Forecast(name, DAY, valid_from, valid_to, step_h, resolution, notice)
    return Wind(*axes, full(u), full(v), forecast, **layers)


def message(name: str, values: Any, sample: str = "regular_ll_sfc_grib2", **keys: Any) -> bytes:
    """GRIB message on the grid of ``(ROWS, COLUMNS)`` from 57 N 16 E to 54 N 20 E, from north to south."""
    handle = eccodes.codes_grib_new_from_samples(sample)
    first = {"Ni": COLUMNS, "Nj": ROWS, "dataDate": 20260101, "dataTime": 600, "stepRange": "3"}
    corners = {
        "latitudeOfFirstGridPointInDegrees": 57.0, "latitudeOfLastGridPointInDegrees": 54.0,
        "longitudeOfFirstGridPointInDegrees": 16.0, "longitudeOfLastGridPointInDegrees": 20.0,
        "iDirectionIncrementInDegrees": 1.0, "jDirectionIncrementInDegrees": 1.0,
    }  # fmt: skip
    named = {"shortName": name} if name else {}
    try:
        for key, value in {**first, **corners, **named, **keys}.items():
            eccodes.codes_set(handle, key, value)
        eccodes.codes_set_values(handle, np.asarray(values, dtype=np.float64).ravel())
        return bytes(eccodes.codes_get_message(handle))
    finally:
        eccodes.codes_release(handle)


def full(value: float) -> Any:
    """Give a field of one value for `message`."""
    return np.full((ROWS, COLUMNS), value)


def write_layers(path: Path, layers: dict[str, tuple[Any, dict[str, str]]], **axes: Any) -> Path:
    """Write a NetCDF file with variables ``name: (values, attributes)``.

    The last dimensions of ``values`` are time, lat and lon as far as it has them; ``axes`` replace the
    common ones, and those besides come first.
    """
    common: dict[str, Any] = {
        "time": [0.0, 3.0, 6.0], "lat": [54.0, 55.0, 56.0, 57.0], "lon": [16.0, 17.0, 18.0, 19.0, 20.0],
    }  # fmt: skip
    units = {"time": "hours since 2026-01-01", "lat": "degrees_north", "lon": "degrees_east", "depth": "m"}
    extra = {name: values for name, values in axes.items() if name not in common}
    order = [*extra, *common]
    with netCDF4.Dataset(path, "w") as file:
        for name, values in {**common, **axes}.items():
            file.createDimension(name, len(values))
            axis = file.createVariable(name, "f8", (name,))
            axis.units = units.get(name, "1")
            axis[:] = values
        for name, (values, attributes) in layers.items():
            variable = file.createVariable(
                name, "f4", order[len(order) - np.ndim(values) :], fill_value=-999.0
            )
            variable.setncatts(attributes)
            variable[:] = np.ma.masked_invalid(values)
    return path
