"""Wind, gusts, waves and current from NetCDF files that follow the CF conventions, or nearly."""

from __future__ import annotations

import io
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from datetime import UTC
from pathlib import Path
from typing import Any, Final

import numpy as np

from seacruise.errors import WeatherError
from seacruise.weather.classic import check_header
from seacruise.weather.grids import MOST_READ, Array, Grid, RawField, RawFile

_SPEEDS: Final = {
    "m s-1": 1.0, "m/s": 1.0, "m s**-1": 1.0, "ms-1": 1.0, "m.s-1": 1.0, "meter second-1": 1.0, "": 1.0,
    "m s^-1": 1.0, "meters/second": 1.0, "meter/sec": 1.0, "meters per second": 1.0, "m/sec": 1.0,
    "cm/s": 0.01, "cm s-1": 0.01,
    "knots": 1852 / 3600, "knot": 1852 / 3600, "kt": 1852 / 3600, "kts": 1852 / 3600, "kn": 1852 / 3600,
    "km/h": 1 / 3.6, "km h-1": 1 / 3.6,
}  # fmt: skip
_HEIGHTS: Final = {
    "m": 1.0, "metre": 1.0, "metres": 1.0, "meter": 1.0, "meters": 1.0, "": 1.0,
    "cm": 0.01, "ft": 0.3048, "feet": 0.3048,
}  # fmt: skip
_ALONG_THE_GRID: Final = (
    "x_wind", "grid_eastward_wind", "sea_water_x_velocity", "surface_sea_water_x_velocity",
)  # fmt: skip
"""Standard names of components that follow the grid's axes, not east and north."""

_MEMBER_NAMES: Final = ("realization", "member", "ens", "number", "perturbation")
_DEGREES: Final = {
    "latitude": ("degreenorth", "degreesnorth", "degreen", "degreesn"),
    "longitude": ("degreeeast", "degreeseast", "degreee", "degreese"),
}
"""CF's units of the two, without underscores."""

_PRESSURES: Final = ("pa", "hpa", "mb", "mbar", "millibar", "millibars", "hectopascal")
_METRES: Final = ("m", "metre", "meter", "meters", "metres")
_UPRIGHT: Final = ("height", "depth", "altitude", "lev")
_SENTINEL: Final = 9000.0
"""No speed and no wave: 9999, 1e20 and their like mean a missing value, whether declared or not."""

_COMPLAINTS: Final = (RuntimeError, IndexError, ValueError, TypeError, AttributeError, OverflowError)
"""What the library raises on truncated or inconsistent files."""

_NO_WIND: Final = (
    "none of its variables is the wind at 10 m (u10 and v10, or eastward_wind and northward_wind)"
)
_ONLY_CURRENT: Final = "it holds sea currents and no wind; give it as the current instead"
_NO_CURRENT: Final = (
    "none of its variables is a current (uo and vo, or eastward_sea_water_velocity and "
    "northward_sea_water_velocity)"
)


@dataclass(frozen=True, slots=True)
class _Layer:
    """What is looked for: names in lower case that senders give, then CF standard names."""

    called: str
    names: tuple[tuple[str, ...], ...]
    standard: tuple[tuple[str, ...], ...]
    units: Mapping[str, float]
    unit: str
    level: float


_WIND: Final = _Layer(
    "wind",
    (
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
    ),
    (
        ("eastward_wind", "northward_wind"),
        ("x_wind", "y_wind"),
        ("grid_eastward_wind", "grid_northward_wind"),
    ),
    _SPEEDS,
    "m/s",
    10.0,
)
_CURRENT: Final = _Layer(
    "current",
    (
        ("utotal", "vtotal"),
        ("uo", "vo"),
        ("water_u", "water_v"),
        ("ucurr", "vcurr"),
        ("uogrd", "vogrd"),
        ("uogrd_surface", "vogrd_surface"),
        ("ocu", "ocv"),
        ("u_velocity", "v_velocity"),
        ("u-component_of_current_surface", "v-component_of_current_surface"),
    ),
    (
        ("eastward_sea_water_velocity", "northward_sea_water_velocity"),
        ("surface_eastward_sea_water_velocity", "surface_northward_sea_water_velocity"),
        ("sea_water_x_velocity", "sea_water_y_velocity"),
        ("surface_sea_water_x_velocity", "surface_sea_water_y_velocity"),
    ),
    _SPEEDS,
    "m/s",
    0.0,
)
_GUST: Final = _Layer(
    "gust",
    tuple(
        (name,)
        for name in ("i10fg", "10fg", "fg10", "gust", "gust_surface", "wind_gust", "wind_speed_of_gust",
                     "wind_speed_gust_surface", "gustsfc", "gust10m", "wind_gusts_10m", "vmax_10m")
    ),
    (("wind_speed_of_gust",),),
    _SPEEDS,
    "m/s",
    10.0,
)  # fmt: skip
_WAVE: Final = _Layer(
    "wave",
    tuple(
        (name,)
        for name in ("vhm0", "swh", "hs", "htsgw", "htsgw_surface", "htsgwsfc",
                     "significant_height_of_combined_wind_waves_and_swell_surface")
    ),
    (("sea_surface_wave_significant_height",),
     ("significant_height_of_wind_and_swell_waves",)),
    _HEIGHTS,
    "m",
    0.0,
)  # fmt: skip


def read_netcdf(content: Path | bytes, *, source: str) -> RawFile:
    """Read wind, gusts, waves and current from a NetCDF file, as far as they are there.

    Among several heights the one nearest to 10 m is taken, among depths the shallowest; what is odd is
    told in the notes.

    Parameters
    ----------
    content
        Where the file is, or what is in it.

    Raises
    ------
    WeatherError
        ``bad-response``, with an unfinished sentence, when it is no NetCDF file, or damaged.
    """
    import netCDF4

    with io.BytesIO(content) if isinstance(content, bytes) else content.open("rb") as stream:
        check_header(stream)
    try:
        if isinstance(content, bytes):
            file = netCDF4.Dataset(source, memory=content)
        else:
            file = netCDF4.Dataset(content)
    except (OSError, RuntimeError):
        raise WeatherError("it is not a NetCDF file, or it is damaged") from None
    with file:
        try:
            return _read(file, source)
        except _COMPLAINTS as error:
            raise WeatherError(f"it is damaged ({error})") from None


def _read(file: Any, source: str) -> RawFile:
    fields: dict[str, RawField] = {}
    troubles: dict[str, str] = {}
    notes: list[str] = []
    for layer in (_WIND, _GUST, _WAVE, _CURRENT):
        variables = _variables(file, layer)
        if variables is None:
            continue
        told: list[str] = []
        try:
            fields[layer.called] = _field(file, layer, variables, told)
            notes += told
        except WeatherError as error:
            troubles[layer.called] = str(error)
        except _COMPLAINTS as error:
            troubles[layer.called] = f"it is damaged ({error})"
    notes += [
        f"The {name} in the file is not used: {trouble}."
        for name, trouble in troubles.items()
        if name != _WIND.called
    ]
    is_sea = "current" in fields or "current" in troubles
    troubles.setdefault("wind", _ONLY_CURRENT if is_sea else _NO_WIND)
    troubles.setdefault("current", _NO_CURRENT)
    return RawFile(
        source,
        wind=fields.get("wind"),
        gust=fields.get("gust"),
        wave=fields.get("wave"),
        current=fields.get("current"),
        troubles=troubles,
        notes=tuple(dict.fromkeys(notes)),
    )


def _field(file: Any, layer: _Layer, variables: tuple[Any, ...], notes: list[str]) -> RawField:
    """Read the variables of a layer with their axes; members of an ensemble come first."""
    first = variables[0]
    if any(one.size > MOST_READ for one in file.variables.values()):
        raise WeatherError(f"it has variables of more than {MOST_READ // 10**6} million values")
    time, time_dims = _time(file, first)
    lat_variable, lon_variable = _position(file, first, "latitude"), _position(file, first, "longitude")
    lat, lon = _plain(lat_variable[:]), _plain(lon_variable[:])
    if lat.ndim == 2:
        space = tuple(lat_variable.dimensions)
        lon = np.unwrap(np.unwrap(lon, axis=1, period=360.0), axis=0, period=360.0)
    else:
        lat, lon = np.atleast_1d(lat), np.atleast_1d(lon)
        space = (*lat_variable.dimensions, *lon_variable.dimensions)
    if not (np.isfinite(lat).all() and np.isfinite(lon).all() and np.isfinite(time).all()):
        raise WeatherError(f"the axes of its {layer.called} are damaged")
    members = _member_dims(file, first, (*time_dims, *space))
    wanted = (*members, *time_dims, *space)
    parts = [_values(file, layer, variable, wanted, notes) for variable in variables]
    count = [part.shape[0] for part in parts] if members else []
    shape = (*count[:1], time.size, *(lat.shape if lat.ndim == 2 else (lat.size, lon.size)))
    order = np.argsort(time, kind="stable")
    # files joined from several runs repeat times; the later entry is the newer run
    order = np.append(order[:-1][np.diff(time[order]) > 0], order[-1:])
    return RawField(
        time=time[order],
        lat=lat,
        lon=lon,
        parts=tuple(part.reshape(shape)[..., order, :, :] for part in parts),
        grid_relative=lat.ndim == 2
        and len(parts) == 2
        and (_standard_name(first) or first.name.lower()).startswith(_ALONG_THE_GRID),
    )


def _standard_name(variable: Any) -> str:
    return str(getattr(variable, "standard_name", "")).lower()


def _variables(file: Any, layer: _Layer) -> tuple[Any, ...] | None:
    """Find the variables of a layer by name, then by standard name."""

    def fits(variable: Any) -> bool:
        # "u" and "v" are the water's in files of ocean models
        is_water = "sea_water" in _standard_name(variable)
        return variable.ndim >= 2 and is_water <= (layer is _CURRENT)

    named = {name.lower(): one for name, one in file.variables.items() if fits(one)}
    standard = {_standard_name(one): one for one in named.values()}
    for known, choices in ((named, layer.names), (standard, layer.standard)):
        for names in choices:
            if all(name in known for name in names):
                return tuple(known[name] for name in names)
    return None


def _kind_units(variable: Any) -> str:
    return str(getattr(variable, "units", "")).strip().lower()


def _is_upright(name: str, variable: Any) -> bool:
    return (
        any(word in name.lower() or word in _standard_name(variable) for word in _UPRIGHT)
        or str(getattr(variable, "axis", "")) == "Z"
        or _kind_units(variable) in _PRESSURES
    )


def _member_dims(file: Any, variable: Any, others: Iterable[str]) -> tuple[str, ...]:
    """Name the dimension along which the members of an ensemble lie, if there is one."""
    for name, size in zip(variable.dimensions, variable.shape, strict=True):
        axis = file.variables.get(name)
        is_named = name.lower().startswith(_MEMBER_NAMES) or (
            axis is not None and (_standard_name(axis) == "realization" or getattr(axis, "axis", "") == "E")
        )
        if size > 1 and is_named and name not in others:
            return (name,)
    return ()


def _time(file: Any, component: Any) -> tuple[Array, tuple[str, ...]]:
    """Read the times [s since 1970] and the dimension they run along, none for a single time."""
    dated = [one for one in file.variables.values() if " since " in str(getattr(one, "units", ""))]
    own = [one for one in dated if one.dimensions and set(one.dimensions) <= set(component.dimensions)]
    own.sort(key=lambda one: (one.name not in component.dimensions, one.name != "valid_time"))
    if own:
        return _seconds(own[0]), tuple(own[0].dimensions)
    for variable in (one for name in ("valid_time", "time", "t") for one in dated if one.name == name):
        if np.size(variable[:]) == 1:
            lead = _lead(file, component)
            if lead is None:
                return _seconds(variable), ()
            return _seconds(variable) + lead[0], lead[1]
    raise WeatherError("it has no time axis ('hours since ...')")


def _seconds(variable: Any) -> Array:
    import netCDF4

    dates: Any = netCDF4.num2date(
        np.atleast_1d(np.ma.filled(variable[:])),
        variable.units,
        getattr(variable, "calendar", "standard"),
        only_use_cftime_datetimes=False,
        only_use_python_datetimes=True,
    )
    return np.array([date.replace(tzinfo=UTC).timestamp() for date in dates])


def _lead(file: Any, component: Any) -> tuple[Array, tuple[str, ...]] | None:
    """Hours after the run [s], where the run stands alone and the steps have an axis of their own."""
    for name in component.dimensions:
        axis = file.variables.get(name)
        if axis is not None and (_standard_name(axis) == "forecast_period" or name in ("step", "lead_time")):
            unit = {"h": 3600.0, "m": 60.0, "s": 1.0, "d": 86400.0}.get(_kind_units(axis)[:1])
            if unit is not None:
                return _plain(axis[:]) * unit, (name,)
    return None


def _position(file: Any, component: Any, what: str) -> Any:
    """Coordinate variable of the latitude or longitude: a dimension's own, or one named as auxiliary."""
    names = [*component.dimensions, *str(getattr(component, "coordinates", "")).split(), what, what[:3]]
    for name in names:
        variable = file.variables.get(name)
        if variable is None or not set(variable.dimensions) <= set(component.dimensions):
            continue
        standard = _standard_name(variable)
        units = _kind_units(variable).replace("_", "").replace(" ", "")
        # those of a rotated grid are often in degrees_north, too
        is_rotated = standard.startswith("grid_") or name.lower() in ("rlat", "rlon")
        if (
            standard == what
            or name.lower() in (what, what[:3])
            or (units in _DEGREES[what] and not is_rotated)
        ):
            return variable
    raise WeatherError(f"it has no {what} axis")


def _values(file: Any, layer: _Layer, variable: Any, wanted: tuple[str, ...], notes: list[str]) -> Grid:
    """Values along the wanted dimensions, in their order and in SI, NaN where missing."""
    index: list[Any] = []
    for name, size in zip(variable.dimensions, variable.shape, strict=True):
        index.append(slice(None) if name in wanted else _choice(file, layer, (name, size), notes))
    values = np.ma.filled(np.ma.asarray(variable[tuple(index)], dtype=np.float32), np.nan)
    kept = [name for name in variable.dimensions if name in wanted]
    values = values.transpose([kept.index(name) for name in wanted if name in kept])
    unit = _kind_units(variable)
    if unit not in layer.units:
        raise WeatherError(f"its {layer.called} is given in {unit!r}, not in {layer.unit}")
    values = np.where(np.abs(values) >= _SENTINEL, np.float32(np.nan), values)
    return np.asarray(values * np.float32(layer.units[unit]), dtype=np.float32)


def _choice(file: Any, layer: _Layer, dimension: tuple[str, int], notes: list[str]) -> int:
    """Which index of a dimension that is neither time, space nor member: the height of 10 m, the surface."""
    name, size = dimension
    variable = file.variables.get(name)
    if variable is not None and _is_upright(name, variable):
        unit = _kind_units(variable)
        if layer is _WIND and unit in _PRESSURES:
            raise WeatherError("its wind is that of pressure levels aloft, and there is none at 10 m")
        if unit in _METRES:
            levels = np.abs(_plain(variable[:]))
            chosen = int(np.argmin(np.abs(levels - layer.level)))
            if layer is _WIND and abs(levels[chosen] - layer.level) > 1.0:
                notes.append(f"The wind is that at {levels[chosen]:g} m; there is none at 10 m.")
            return chosen
    if size > 1:
        notes.append(f"Of {size} layers ({name}) of the {layer.called}, the first one is used.")
    return 0


def _plain(values: Any) -> Array:
    return np.asarray(np.ma.filled(np.ma.asarray(values, dtype=np.float64), np.nan))
