"""Wind at 10 m from NetCDF files that follow the CF conventions, or nearly."""

from __future__ import annotations

from datetime import UTC
from pathlib import Path
from typing import Any, Final

import numpy as np

from seacruise.errors import WeatherError
from seacruise.weather.grids import Array, Grid, RawWind

_PAIRS: Final = (
    ("u10", "v10"),
    ("10u", "10v"),
    ("u10m", "v10m"),
    ("ugrd10m", "vgrd10m"),
    ("ugrd_10maboveground", "vgrd_10maboveground"),
    ("x_wind_10m", "y_wind_10m"),
    ("u-component_of_wind_height_above_ground", "v-component_of_wind_height_above_ground"),
    ("eastward_wind", "northward_wind"),
    ("x_wind", "y_wind"),
    ("uwnd", "vwnd"),
    ("u", "v"),
)
"""Names, in lower case, that senders give the components; then their standard names are tried."""

_STANDARD_PAIRS: Final = (("eastward_wind", "northward_wind"), ("x_wind", "y_wind"))
_SPEED_UNITS: Final = {
    "m s-1": 1.0, "m/s": 1.0, "m s**-1": 1.0, "ms-1": 1.0, "m.s-1": 1.0, "meter second-1": 1.0, "": 1.0,
    "knots": 1852 / 3600, "knot": 1852 / 3600, "kt": 1852 / 3600, "kts": 1852 / 3600, "kn": 1852 / 3600,
    "km/h": 1 / 3.6, "km h-1": 1 / 3.6,
}  # fmt: skip
_ALONG_THE_GRID: Final = ("x_wind", "grid_eastward_wind")
"""Standard names of components that follow the grid's axes, not east and north."""
_HEIGHT: Final = 10.0


def read_netcdf(path: Path, *, source: str) -> RawWind:
    """Read the wind at 10 m from a NetCDF file.

    Among several heights the one nearest to 10 m is taken, of an ensemble its first member, which by
    custom is the control; both are told in the notes.

    Raises
    ------
    WeatherError
        ``bad-response``, with an unfinished sentence, when there is no wind that can be used.
    """
    import netCDF4

    try:
        file = netCDF4.Dataset(path)
    except (OSError, RuntimeError):
        raise WeatherError("it is not a NetCDF file, or it is damaged") from None
    with file:
        try:
            return _read(file, source)
        except (RuntimeError, IndexError, ValueError, TypeError, AttributeError) as error:
            # the library's own complaints about truncated or inconsistent files
            raise WeatherError(f"it is damaged ({error})") from None


def _read(file: Any, source: str) -> RawWind:
    first, second = _components(file)
    notes: list[str] = []
    time, time_dims = _time(file, first)
    lat_variable, lon_variable = _position(file, first, "latitude"), _position(file, first, "longitude")
    lat, lon = _plain(lat_variable[:]), _plain(lon_variable[:])
    if lat.ndim == 2:
        space = tuple(lat_variable.dimensions)
    else:
        lat, lon = np.atleast_1d(lat), np.atleast_1d(lon)
        space = (*lat_variable.dimensions, *lon_variable.dimensions)
    wanted = (*time_dims, *space)
    u, v = (_values(file, variable, wanted, notes) for variable in (first, second))
    shape = (time.size, *(lat.shape if lat.ndim == 2 else (lat.size, lon.size)))
    order = np.argsort(time, kind="stable")
    # files joined from several runs repeat times; the later entry is the newer run
    order = np.append(order[:-1][np.diff(time[order]) > 0], order[-1:])
    return RawWind(
        time=time[order],
        lat=lat,
        lon=np.unwrap(np.unwrap(lon, axis=1, period=360.0), axis=0, period=360.0) if lon.ndim == 2 else lon,
        u=u.reshape(shape)[order],
        v=v.reshape(shape)[order],
        source=source,
        issued=None,
        grid_relative=lat.ndim == 2
        and (_standard_name(first) or first.name.lower()).startswith(_ALONG_THE_GRID),
        notes=tuple(dict.fromkeys(notes)),
    )


def _standard_name(variable: Any) -> str:
    return str(getattr(variable, "standard_name", "")).lower()


def _components(file: Any) -> tuple[Any, Any]:
    named = {name.lower(): variable for name, variable in file.variables.items()}
    air = {
        name: one for name, one in named.items() if "sea_water" not in _standard_name(one) and one.ndim >= 2
    }
    for u_name, v_name in _PAIRS:
        if u_name in air and v_name in air:
            return air[u_name], air[v_name]
    standard = {_standard_name(variable): variable for variable in air.values()}
    for u_name, v_name in _STANDARD_PAIRS:
        if u_name in standard and v_name in standard:
            return standard[u_name], standard[v_name]
    if any("sea_water" in _standard_name(variable) for variable in named.values()) or {"uo", "vo"} <= set(
        named
    ):
        raise WeatherError("it holds sea currents and no wind; give it as the current instead")
    raise WeatherError(
        "none of its variables is the wind at 10 m (u10 and v10, or eastward_wind and northward_wind)"
    )


def _time(file: Any, component: Any) -> tuple[Array, tuple[str, ...]]:
    """Read the times [s since 1970] and the dimension they run along, none for a single time."""
    import netCDF4

    candidates = [file.variables[name] for name in component.dimensions if name in file.variables]
    candidates += [file.variables[name] for name in ("time", "valid_time", "t") if name in file.variables]
    for variable in candidates:
        if " since " in str(getattr(variable, "units", "")):
            dates: Any = netCDF4.num2date(
                np.atleast_1d(np.ma.filled(variable[:])),
                variable.units,
                getattr(variable, "calendar", "standard"),
                only_use_cftime_datetimes=False,
                only_use_python_datetimes=True,
            )
            seconds = np.array([date.replace(tzinfo=UTC).timestamp() for date in dates])
            return seconds, tuple(name for name in variable.dimensions if name in component.dimensions)
    raise WeatherError("its wind has no time axis ('hours since ...')")


def _position(file: Any, component: Any, what: str) -> Any:
    """Coordinate variable of the latitude or longitude: a dimension's own, or one named as auxiliary."""
    names = [*component.dimensions, *str(getattr(component, "coordinates", "")).split(), what, what[:3]]
    for name in names:
        variable = file.variables.get(name)
        if variable is None or not set(variable.dimensions) <= set(component.dimensions):
            continue
        units = str(getattr(variable, "units", "")).lower().replace("_", "").replace(" ", "")
        direction = "north" if what == "latitude" else "east"
        if (
            _standard_name(variable) == what
            or name.lower() in (what, what[:3])
            or (
                units.startswith("degree")
                and units.endswith((direction, direction[0]))
                and "rlat" not in name
            )
        ):
            return variable
    raise WeatherError(f"its wind has no {what} axis")


def _values(file: Any, variable: Any, wanted: tuple[str, ...], notes: list[str]) -> Grid:
    """Values along the wanted dimensions, in their order, in m/s, NaN where missing."""
    index: list[Any] = []
    for name, size in zip(variable.dimensions, variable.shape, strict=True):
        index.append(slice(None) if name in wanted else _choice(file, name, size, notes))
    values = np.ma.filled(np.ma.asarray(variable[tuple(index)], dtype=np.float32), np.nan)
    kept = [name for name in variable.dimensions if name in wanted]
    values = values.transpose([kept.index(name) for name in wanted if name in kept])
    unit = str(getattr(variable, "units", "")).strip().lower()
    if unit not in _SPEED_UNITS:
        raise WeatherError(f"its wind is given in {unit!r}, not in m/s")
    return np.asarray(values * np.float32(_SPEED_UNITS[unit]), dtype=np.float32)


def _choice(file: Any, name: str, size: int, notes: list[str]) -> int:
    """Which index of a dimension that is neither time nor space: the height of 10 m, the first member."""
    variable = file.variables.get(name)
    is_height = variable is not None and (
        "height" in name.lower()
        or "height" in _standard_name(variable)
        or str(getattr(variable, "axis", "")) == "Z"
    )
    if is_height and str(getattr(variable, "units", "")).strip().lower() in (
        "m",
        "metre",
        "meter",
        "meters",
        "metres",
    ):
        heights = _plain(variable[:])
        chosen = int(np.argmin(np.abs(heights - _HEIGHT)))
        if abs(heights[chosen] - _HEIGHT) > 1.0:
            notes.append(f"The wind is that at {heights[chosen]:g} m; there is none at 10 m.")
        return chosen
    if size > 1:
        notes.append(f"Of {size} members ({name}), the first one is used.")
    return 0


def _plain(values: Any) -> Array:
    return np.asarray(np.ma.filled(np.ma.asarray(values, dtype=np.float64), np.nan))
