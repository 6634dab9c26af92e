"""What a file holds besides the wind: gusts, waves, currents, members; each where it belongs."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import netCDF4
import numpy as np
import pytest

from seacruise.errors import InputError
from seacruise.progress import Job
from seacruise.weather.files import read_current_file, read_wind_file
from seacruise.weather.isolated import read_current_isolated, read_isolated
from tests.weather.worlds import COLUMNS, ROWS, full, message, write_layers

MS = {"units": "m s-1"}
SHAPE = (3, ROWS, COLUMNS)


def ones(value: float = 1.0) -> Any:
    return np.full(SHAPE, value)


def wind_layers(u: Any = None, v: Any = None) -> dict[str, Any]:
    return {"u10": (ones(5.0) if u is None else u, MS), "v10": (ones(0.0) if v is None else v, MS)}


# --- the real ones --------------------------------------------------------------------------------


def test_the_current_and_the_waves_off_ruegen_are_those_of_the_file(shared_data: Path) -> None:
    path = shared_data / "weather" / "baltic" / "gfs_cmems_rugen_20230720_27h.nc"
    wind = read_wind_file(path)
    assert wind.current is not None
    assert wind.wave is not None
    with netCDF4.Dataset(path) as file:
        east = np.ma.filled(file["utotal"][0], np.nan)
        height = np.ma.filled(file["VHM0"][:], np.nan)
        lat, lon = file["latitude"][:], file["longitude"][:]
        rows, columns = np.argsort(lat), np.argsort(lon)
    inside = east[:, rows][:, :, columns]
    found = wind.current.u[:, 1:-1, 1:-1]
    np.testing.assert_allclose(found[~np.isnan(inside)], inside[~np.isnan(inside)], rtol=1e-6)
    assert (found[np.isnan(inside)] == 0).all()
    waves = height[:, rows][:, :, columns]
    known = ~np.isnan(waves)
    assert 0.5 < known.mean() < 1
    np.testing.assert_allclose(wind.wave[known], waves[known], atol=1e-6)
    # land beside the sea has the sea's waves
    assert (wind.wave > 0).all()
    alone = read_current_file(path)
    np.testing.assert_array_equal(alone.u, wind.current.u)
    assert (alone.forecast.valid_from, alone.forecast.valid_to) == (
        datetime(2023, 7, 20, 10, tzinfo=UTC),
        datetime(2023, 7, 21, 13, tzinfo=UTC),
    )


def test_a_grib_of_nothing_but_currents_is_a_current(shared_data: Path) -> None:
    path = shared_data / "weather" / "grib" / "xgrib_current-matching.grb"
    current = read_current_isolated(path, job=Job())
    assert current.u.shape == (2, 4, 5)
    # the file's own six points, and still water around them
    assert np.abs(current.u[:, 1:-1, 1:-1]).max() > 1
    for part in (current.u, current.v):
        assert not part[:, [0, -1]].any()
        assert not part[:, :, [0, -1]].any()


def test_the_gusts_of_zygrib_are_found_without_a_name(shared_data: Path) -> None:
    wind = read_wind_file(shared_data / "weather" / "grib" / "zygrib_gfs_ww3_useast_20180429.grb")
    assert wind.gust is not None
    speed = np.hypot(wind.u, wind.v)
    assert float(wind.gust.max()) == pytest.approx(29.9, abs=0.1)
    assert (wind.gust >= speed - 1e-5).all()
    assert 1.1 < float((wind.gust[speed > 8] / speed[speed > 8]).mean()) < 1.7


def test_the_members_of_gefs_come_with_their_mean(shared_data: Path) -> None:
    path = shared_data / "weather" / "ensemble" / "gefs21_california_20151019.nc"
    wind = read_isolated(path, job=Job())
    assert wind.forecast.source == "File gefs21_california_20151019.nc, mean of 21 members"
    assert len(wind.members) == 21
    assert wind.members[3].forecast.source == "File gefs21_california_20151019.nc, member 4"
    with netCDF4.Dataset(path) as file:
        rows, columns = np.argsort(file["latitude"][:]), np.argsort(file["longitude"][:])
        x = np.asarray(file["x_wind"][:]).transpose(1, 0, 3, 2)[:, :, rows][..., columns]
        y = np.asarray(file["y_wind"][:]).transpose(1, 0, 3, 2)[:, :, rows][..., columns]
    for number, member in enumerate(wind.members):
        np.testing.assert_array_equal(member.u, x[number])
    np.testing.assert_allclose(wind.u, x.mean(axis=0), atol=1e-5)
    np.testing.assert_allclose(wind.v, y.mean(axis=0), atol=1e-5)
    assert wind.spread is not None
    scatter = np.sqrt(((x - x.mean(axis=0)) ** 2 + (y - y.mean(axis=0)) ** 2).mean(axis=0))
    np.testing.assert_allclose(wind.spread, scatter, atol=1e-4)
    # forecasts part with time
    assert wind.spread[-4:].mean() > 2 * wind.spread[:4].mean()


# --- NetCDF made here -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "attributes", "layer", "factor"),
    [
        ("i10fg", MS, "gust", 1.0),
        ("fg10", {"units": "m s**-1"}, "gust", 1.0),
        ("GUST_surface", {"units": "knots"}, "gust", 1852 / 3600),
        ("ff_g", {"units": "m/s", "standard_name": "wind_speed_of_gust"}, "gust", 1.0),
        ("swh", {"units": "m"}, "wave", 1.0),
        ("VHM0", {"units": "m"}, "wave", 1.0),
        ("HTSGW_surface", {"units": "m"}, "wave", 1.0),
        ("hsig", {"units": "m", "standard_name": "sea_surface_wave_significant_height"}, "wave", 1.0),
        ("hs", {"units": "ft"}, "wave", 0.3048),
    ],
)
def test_gusts_and_waves_have_many_names(
    tmp_path: Path, name: str, attributes: dict[str, str], layer: str, factor: float
) -> None:
    layers = {**wind_layers(), name: (ones(20.0), attributes)}
    wind = read_wind_file(write_layers(tmp_path / "a.nc", layers))
    np.testing.assert_allclose(getattr(wind, layer), 20.0 * factor, rtol=1e-6)
    assert wind.forecast.notice == ""


@pytest.mark.parametrize(
    ("names", "standard"),
    [
        (("uo", "vo"), None),
        (("utotal", "vtotal"), None),
        (("water_u", "water_v"), None),
        (("u", "v"), ("eastward_sea_water_velocity", "northward_sea_water_velocity")),
        (("e", "n"), ("surface_eastward_sea_water_velocity", "surface_northward_sea_water_velocity")),
    ],
)
def test_currents_have_many_names(
    tmp_path: Path, names: tuple[str, str], standard: tuple[str, str] | None
) -> None:
    layers = {}
    for k, name in enumerate(names):
        attributes = {**MS, **({"standard_name": standard[k]} if standard else {})}
        # the deeper the slower; the surface counts, wherever it stands in the file
        layers[name] = (np.stack([ones(0.1), ones(0.5 - k)]), attributes)
    path = write_layers(tmp_path / "a.nc", layers, depth=[10.0, 0.5])
    current = read_current_file(path)
    np.testing.assert_allclose(current.u[:, 1:-1, 1:-1], 0.5)
    np.testing.assert_allclose(current.v[:, 1:-1, 1:-1], -0.5)
    with pytest.raises(InputError, match="sea currents and no wind"):
        read_wind_file(path)


def test_a_file_can_hold_all_of_it_on_grids_of_its_own(tmp_path: Path) -> None:
    layers = {
        **wind_layers(),
        "uo": (ones(0.4), MS),
        "vo": (ones(0.0), MS),
        "swh": (ones(1.5), {"units": "m"}),
        "gust": (ones(9.0), MS),
    }
    wind = read_wind_file(write_layers(tmp_path / "a.nc", layers))
    assert wind.current is not None
    assert wind.wave is not None
    assert wind.gust is not None
    assert wind.current.at(wind.time[1], 55.5, 18.0)[0] == pytest.approx(0.4)
    # a step outside the grid of the current there is none
    assert wind.current.at(wind.time[1], 55.5, 21.0)[0] == 0.0
    assert wind.current.at(wind.time[1], 55.5, 40.0)[0] == 0.0


def test_land_has_no_current_and_the_waves_of_the_nearest_sea(tmp_path: Path) -> None:
    sea = np.full((3, 4, 40), np.nan)
    sea[..., :10] = 2.0
    lon = np.linspace(10.0, 19.75, 40)
    layers = {
        "u10": (np.full((3, 4, 40), 5.0), MS), "v10": (np.zeros((3, 4, 40)), MS),
        "swh": (sea, {"units": "m"}), "uo": (sea / 4, MS), "vo": (sea * 0, MS),
    }  # fmt: skip
    wind = read_wind_file(write_layers(tmp_path / "a.nc", layers, lon=lon, lat=[54.0, 54.25, 54.5, 54.75]))
    assert wind.wave is not None
    assert wind.current is not None
    np.testing.assert_allclose(wind.wave[..., :13], 2.0)
    assert not wind.wave[..., 14:].any()
    np.testing.assert_allclose(wind.current.u[:, 1:-1, 1:11], 0.5)
    assert not wind.current.u[..., 11:].any()


def test_a_layer_that_cannot_be_used_costs_a_sentence_not_the_wind(tmp_path: Path) -> None:
    layers = {
        **wind_layers(),
        "gust": (ones(9.0), {"units": "furlongs"}),
        "uo": (ones(99.0), MS),
        "vo": (ones(0.0), MS),
    }
    path = write_layers(tmp_path / "a.nc", layers)
    wind = read_wind_file(path)
    assert wind.gust is None
    assert wind.current is None
    assert "The gust in the file is not used: its gust is given in 'furlongs'" in wind.forecast.notice
    assert "runs at 99 m/s, which no water does" in wind.forecast.notice
    with pytest.raises(InputError, match="which no water does"):
        read_current_file(path)


def test_gusts_are_never_below_the_wind(tmp_path: Path) -> None:
    gust = ones(9.0)
    gust[1] = 2.0
    wind = read_wind_file(write_layers(tmp_path / "a.nc", {**wind_layers(), "gust": (gust, MS)}))
    assert wind.gust is not None
    np.testing.assert_allclose(wind.gust[:, 0, 0], [9.0, 5.0, 9.0])


def test_a_file_without_currents_is_no_current(tmp_path: Path) -> None:
    path = write_layers(tmp_path / "a.nc", wind_layers())
    with pytest.raises(InputError, match=r"a\.nc cannot be used: none of its variables is a current"):
        read_current_isolated(path, job=Job())
    masked = {"uo": (ones(np.nan), MS), "vo": (ones(np.nan), MS)}
    with pytest.raises(InputError, match=r"masked.*all over the area"):
        read_current_file(write_layers(tmp_path / "b.nc", masked))
    there = {"uo": (ones(0.5), MS), "vo": (ones(0.5), MS)}
    far = [(30.0, -40.0), (35.0, -41.0)]
    with pytest.raises(InputError, match="does not reach the area of the passage"):
        read_current_file(write_layers(tmp_path / "c.nc", there), around=far)


def test_wind_on_pressure_levels_is_not_sailed_in(tmp_path: Path) -> None:
    levels = {"u": (np.stack([ones(), ones()]), MS), "v": (np.stack([ones(), ones()]), MS)}
    path = write_layers(tmp_path / "a.nc", levels, level=[1000.0, 850.0])
    with netCDF4.Dataset(path, "a") as file:
        file["level"].units = "hPa"
    with pytest.raises(InputError, match="pressure levels aloft"):
        read_wind_file(path)


@pytest.mark.parametrize("has_valid_time", [True, False])
def test_a_run_with_an_axis_of_steps_has_its_times(tmp_path: Path, has_valid_time: bool) -> None:
    path = tmp_path / "a.nc"
    with netCDF4.Dataset(path, "w") as file:
        for name, values, unit in (
            ("step", [0.0, 3.0, 6.0], "hours"),
            ("latitude", [54.0, 55.0], "degrees_north"),
            ("longitude", [16.0, 17.0], "degrees_east"),
        ):
            file.createDimension(name, len(values))
            axis = file.createVariable(name, "f8", (name,))
            axis.units = unit
            axis[:] = values
        for name, dims, hours in (("time", (), 12.0), ("valid_time", ("step",), [12.0, 15.0, 18.0])):
            if has_valid_time or name == "time":
                moment = file.createVariable(name, "f8", dims)
                moment.units = "hours since 2026-01-01"
                moment[:] = hours
        for name in ("u10", "v10"):
            file.createVariable(name, "f4", ("step", "latitude", "longitude"))[:] = 4.0
    wind = read_wind_file(path)
    assert wind.forecast.valid_from == datetime(2026, 1, 1, 12, tzinfo=UTC)
    assert (wind.time.size, wind.forecast.step_h) == (3, 3.0)


def rotated_grid(rlat: Any, rlon: Any) -> tuple[Any, Any, Any, Any]:
    """Latitudes, longitudes and the unit vectors along the rows of a grid whose pole lies at 39 N 180 E.

    Everything is reckoned with vectors in space, which share nothing with the reader's way of doing it.
    """
    pole = np.array([-np.cos(np.radians(39.0)), 0.0, np.sin(np.radians(39.0))])
    first = np.array([np.sin(np.radians(39.0)), 0.0, np.cos(np.radians(39.0))])
    second = np.cross(pole, first)
    phi, lam = np.meshgrid(np.radians(rlat), np.radians(rlon), indexing="ij")
    across = np.cos(lam)[..., None] * first + np.sin(lam)[..., None] * second
    place = np.cos(phi)[..., None] * across + np.sin(phi)[..., None] * pole
    along = -np.sin(lam)[..., None] * first + np.cos(lam)[..., None] * second
    up = -np.sin(phi)[..., None] * across + np.cos(phi)[..., None] * pole
    lat, lon = np.degrees(np.arcsin(place[..., 2])), np.degrees(np.arctan2(place[..., 1], place[..., 0]))
    return lat, lon, along, up


@pytest.mark.parametrize("unit", ["degrees", "degree", "degrees_north"])
def test_a_rotated_pole_is_turned_and_resampled(tmp_path: Path, unit: str) -> None:
    rlat, rlon = np.linspace(3.0, 6.0, 31), np.linspace(8.0, 11.4, 35)
    lat, lon, along, up = rotated_grid(rlat, rlon)
    east = np.stack([-np.sin(np.radians(lon)), np.cos(np.radians(lon)), np.zeros_like(lon)], axis=-1)
    path = tmp_path / "a.nc"
    with netCDF4.Dataset(path, "w") as file:
        for name, values in (("time", np.arange(2.0)), ("rlat", rlat), ("rlon", rlon)):
            file.createDimension(name, values.size)
            axis = file.createVariable(name, "f8", (name,))
            axis.units = "hours since 2026-01-01" if name == "time" else unit
            axis[:] = values
        file["rlat"].standard_name, file["rlon"].standard_name = "grid_latitude", "grid_longitude"
        for name, values in (("lat", lat), ("lon", lon)):
            position = file.createVariable(name, "f8", ("rlat", "rlon"))
            position.units = "degrees_north" if name == "lat" else "degrees_east"
            position[:] = values
        # a wind of 10 m/s from the west everywhere, as seen along the grid's axes
        for name, axis, standard in (("u", along, "grid_eastward_wind"), ("v", up, "grid_northward_wind")):
            component = file.createVariable(name, "f4", ("time", "rlat", "rlon"))
            component.setncatts({"standard_name": standard, "units": "m s-1", "coordinates": "lon lat"})
            component[:] = 10.0 * (east * axis).sum(axis=-1)
        assert np.ptp(np.asarray(file["u"][:])) > 0.05
    wind = read_wind_file(path)
    np.testing.assert_allclose(wind.u, 10.0, atol=0.01)
    np.testing.assert_allclose(wind.v, 0.0, atol=0.02)
    assert wind.covers(lat, lon).mean() > 0.5


# --- GRIB made here -------------------------------------------------------------------------------


def grib(tmp_path: Path, *messages: bytes) -> Path:
    path = tmp_path / "a.grb"
    path.write_bytes(b"".join(messages))
    return path


def wind_at(step: str, u: float, **keys: Any) -> bytes:
    return message("10u", full(u), stepRange=step, **keys) + message("10v", full(0.0), stepRange=step, **keys)


def test_gusts_waves_and_currents_of_a_grib(tmp_path: Path) -> None:
    ocean: dict[str, Any] = {"centre": 7, "discipline": 10, "parameterCategory": 1}
    path = grib(
        tmp_path,
        wind_at("0", 4.0),
        wind_at("6", 6.0),
        message("i10fg", full(12.0), stepRange="6"),
        message("swh", full(2.0), stepRange="0"),
        message("swh", full(3.0), stepRange="6"),
        message("", full(0.7), stepRange="0", **ocean, parameterNumber=2),
        message("", full(-0.3), stepRange="0", **ocean, parameterNumber=3),
    )
    wind = read_wind_file(path)
    assert wind.gust is not None
    assert wind.wave is not None
    assert wind.current is not None
    # held before the first of its hours, as everywhere
    np.testing.assert_allclose(wind.gust, 12.0, atol=1e-3)
    np.testing.assert_allclose(wind.wave[:, 0, 0], [2.0, 3.0], atol=1e-3)
    np.testing.assert_allclose(wind.current.at(wind.time[0], 55.0, 18.0), (0.7, -0.3), atol=1e-3)
    assert wind.forecast.notice == ""


def test_waves_on_a_coarser_grid_and_fewer_hours_are_interpolated_then_held(tmp_path: Path) -> None:
    coarse: dict[str, Any] = {
        "Ni": 3, "Nj": 2, "iDirectionIncrementInDegrees": 2.0, "jDirectionIncrementInDegrees": 3.0,
    }  # fmt: skip
    winds = [wind_at(str(step), 5.0) for step in (0, 3, 6, 12, 24)]
    west_to_east = np.tile([1.0, 3.0, 5.0], (2, 1))
    waves = [message("swh", west_to_east * k, stepRange=str(step), **coarse) for k, step in ((1, 0), (2, 6))]
    wind = read_wind_file(grib(tmp_path, *winds, *waves))
    assert wind.wave is not None
    np.testing.assert_allclose(wind.wave[0, 1], [1, 2, 3, 4, 5], atol=1e-3)
    np.testing.assert_allclose(wind.wave[:, 0, 0], [1, 1.5, 2, 2, 2], atol=1e-3)
    assert wind.forecast.notice == "The waves of the file end at 2026-01-01 12:00 UTC; the last are held."


def test_a_file_of_two_grids_has_the_finest_and_the_coarser_ones_later_hours(tmp_path: Path) -> None:
    coarse: dict[str, Any] = {
        "Ni": 3, "Nj": 2, "iDirectionIncrementInDegrees": 2.0, "jDirectionIncrementInDegrees": 3.0,
    }  # fmt: skip
    later = np.array([[10.0, 12.0, 14.0], [16.0, 18.0, 20.0]])

    def rough(step: str, values: Any) -> bytes:
        both = (message(name, values, stepRange=step, **coarse) for name in ("10u", "10v"))
        return b"".join(both)

    path = grib(tmp_path, rough("3", later * 0 - 9), rough("6", later), wind_at("0", 4.0), wind_at("3", 5.0))
    wind = read_wind_file(path)
    assert wind.u.shape == (3, ROWS, COLUMNS)
    np.testing.assert_allclose(wind.u[:2, 0, 0], [4.0, 5.0], atol=1e-3)
    # rows from south to north: 54 N is the second of the message, 55 N a third of the way to 57 N
    np.testing.assert_allclose(wind.u[2, 0], [16, 17, 18, 19, 20], atol=1e-3)
    np.testing.assert_allclose(wind.u[2, 1], np.array([16, 17, 18, 19, 20]) - 2, atol=1e-3)
    assert wind.forecast.notice == "1 of the hours are from a coarser grid of 3.00 degrees."


def test_the_members_of_a_grib_come_with_their_mean(tmp_path: Path) -> None:
    def member(number: int, u: float, step: str = "3") -> bytes:
        keys: dict[str, Any] = {"productDefinitionTemplateNumber": 1, "perturbationNumber": number}
        return wind_at(step, u, **keys)

    path = grib(tmp_path, member(2, 10.0), member(0, 4.0), member(1, 7.0))
    wind = read_wind_file(path)
    assert wind.forecast.source == "File a.grb, mean of 3 members"
    np.testing.assert_allclose([one.u[0, 0, 0] for one in wind.members], [4, 7, 10], atol=1e-3)
    np.testing.assert_allclose(wind.u, 7.0, atol=1e-3)
    assert wind.spread is not None
    np.testing.assert_allclose(wind.spread, np.sqrt(6.0), atol=1e-3)
    # a member that ends early ends them all, and that is told
    wind = read_wind_file(grib(tmp_path, member(0, 4.0), member(0, 5.0, "6"), member(1, 7.0)))
    assert wind.time.size == 1
    assert "2 of 2 members are used, at the 1 times they have in common" in wind.forecast.notice


def test_a_spread_is_not_taken_for_a_wind(tmp_path: Path) -> None:
    def derived(kind: int, u: float) -> bytes:
        return wind_at("3", u, productDefinitionTemplateNumber=2, derivedForecast=kind)

    wind = read_wind_file(grib(tmp_path, derived(0, 8.0), derived(4, 1.5)))
    np.testing.assert_allclose(wind.u, 8.0, atol=1e-3)
    with pytest.raises(InputError, match="none of its 2 messages is wind"):
        read_wind_file(grib(tmp_path, derived(4, 1.5)))


def test_a_passage_keeps_what_lies_around_it_in_every_layer(tmp_path: Path) -> None:
    lat, lon = np.arange(30.0, 70.0), np.arange(-20.0, 40.0)
    field = np.broadcast_to(lat[None, :, None], (3, lat.size, lon.size))
    layers = {
        "u10": (field / 10, MS), "v10": (field / 10, MS), "swh": (field / 10, {"units": "m"}),
        "uo": (field / 100, MS), "vo": (field / 100, MS),
    }  # fmt: skip
    path = write_layers(tmp_path / "a.nc", layers, lat=lat, lon=lon)
    wind = read_wind_file(path, around=[(54.5, 18.5), (57.6, 18.3)])
    assert wind.wave is not None
    assert wind.current is not None
    assert wind.u.shape[1:] == wind.wave.shape[1:] == (11, 13)
    assert wind.current.u.shape[1:] == (13, 15)
    assert wind.current.at(wind.time[0], 56.0, 18.0)[0] == pytest.approx(0.56, abs=1e-6)
    assert float(wind.interpolate(wind.wave, wind.time[0], 56.5, 18.0)) == pytest.approx(5.65, abs=1e-5)
