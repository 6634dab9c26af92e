"""Weather files: those that sailors have, those made here to be odd, and those that are none."""

from __future__ import annotations

import bz2
import gzip
import sys
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import eccodes
import netCDF4
import numpy as np
import pytest
from hypothesis import HealthCheck, given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from seacruise.errors import InputError, NoPassageError
from seacruise.weather import grids
from seacruise.weather.files import read_wind_file
from seacruise.weather.netcdf import read_netcdf
from tests.weather.worlds import COLUMNS, ROWS, message

# --- the real ones --------------------------------------------------------------------------------

READABLE = [
    # file, shape, area, first and last hour, highest speed, words of the notice
    ("baltic/gfs_1deg_baltic_20161120_48h_6hourly.nc", (9, 16, 26),
     "52.0 to 67.0 N, 7.0 to 32.0 E", "2016-11-20T00 2016-11-22T00", 22.8, ""),
    ("baltic/gfs_cmems_rugen_20230720_27h.nc", (10, 12, 12),
     "54.1 to 55.0 N, 13.1 to 14.0 E", "2023-07-20T10 2023-07-21T13", 10.2, ""),
    ("baltic/RELOCATED_gfs025_120h_to_baltic.nc", (41, 77, 85),
     "47.0 to 66.0 N, 9.0 to 30.0 E", "2018-04-29T18 2018-05-04T18", 19.7, ""),
    ("baltic/RELOCATED_gfs025_192h_to_baltic.grb", (65, 77, 85),
     "47.0 to 66.0 N, 9.0 to 30.0 E", "2018-04-29T18 2018-05-07T18", 19.7,
       "24 of the hours are from a coarser grid of 0.50 degrees."),
    ("ensemble/gefs21_california_20151019.nc", (25, 11, 11),
     "35.0 to 45.0 N, 120.0 to 130.0 W", "2015-10-19T06 2015-10-25T06", 14.56,
       ""),
    ("grib/gfs_EastAtlantic_20120822_ugrib.grb", (61, 53, 36),
     "10.0 to 62.0 N, 0.0 to 43.8 W", "2012-08-22T12 2012-08-30T00", 22.7, ""),
    ("grib/gfs_qtvlm_benchmark_20121127_bzip2_named.grb", (3, 52, 108),
     "48.0 S to 54.0 N, 126.0 W to 88.0 E", "2012-11-27T06 2012-11-28T06", 21.3, ""),
    ("grib/gfs_saildocs_tasman_20131226.grb", (7, 31, 46),
     "10.0 to 40.0 S, 130.0 to 175.0 E", "2013-12-27T06 2014-01-02T06", 18.1, ""),
    ("grib/gfs_southatlantic_20251111_single.grib2", (1, 61, 61),
     "10.0 to 40.0 S, 40.0 to 70.0 W", "2025-11-11T18 2025-11-11T18", 16.8, "a single time"),
    ("grib/zygrib_gfs_ww3_useast_20180429.grb", (65, 77, 85),
     "28.0 to 47.0 N, 59.0 to 80.0 W", "2018-04-29T18 2018-05-07T18", 19.7, "coarser grid"),
    ("netcdf/arome_metcoop_2p5km_northsea_20151116_67h.nc", (67, 140, 58),
     "59.1 to 62.3 N, 3.7 to 6.3 E", "2015-11-16T00 2015-11-18T18", 27.0, ""),
]  # fmt: skip

REFUSED = [
    ("grib/gfs_scandinavia_20150309_ugrib.grb", r"missing \(masked\) over 74% of its area"),
    ("grib/xgrib_corrupt.grb", "is not a GRIB file"),
    ("grib/xgrib_current-matching.grb", "sea currents and no wind"),
]


@pytest.mark.parametrize(
    ("name", "shape", "area", "hours", "speed", "notice"), READABLE, ids=[case[0] for case in READABLE]
)
def test_a_real_file_is_read(
    shared_data: Path, name: str, shape: tuple[int, ...], area: str, hours: str, speed: float, notice: str
) -> None:
    wind = read_wind_file(shared_data / "weather" / name)
    forecast = wind.forecast
    assert wind.u.shape == shape
    assert wind.describe_area() == area
    assert f"{forecast.valid_from:%Y-%m-%dT%H} {forecast.valid_to:%Y-%m-%dT%H}" == hours
    assert float(np.hypot(wind.u, wind.v).max()) == pytest.approx(speed, abs=0.05)
    assert notice in forecast.notice
    assert forecast.source.removesuffix(", mean of 21 members") == f"File {Path(name).name}"


@pytest.mark.parametrize(("name", "words"), REFUSED, ids=[case[0] for case in REFUSED])
def test_a_real_file_is_refused(shared_data: Path, name: str, words: str) -> None:
    with pytest.raises(InputError, match=words) as caught:
        read_wind_file(shared_data / "weather" / name)
    assert str(caught.value).startswith(f"The weather file {Path(name).name} cannot be used: ")
    assert caught.value.__cause__ is None


def test_every_real_file_is_a_case(shared_data: Path) -> None:
    folder = shared_data / "weather"
    known = {case[0] for case in READABLE} | {case[0] for case in REFUSED}
    found = {path.relative_to(folder).as_posix() for path in folder.rglob("*.*") if path.suffix != ".json"}
    assert found == known


def test_the_same_forecast_in_grib_and_netcdf_is_the_same_wind(shared_data: Path) -> None:
    folder = shared_data / "weather" / "baltic"
    grib = read_wind_file(folder / "RELOCATED_gfs025_192h_to_baltic.grb")
    netcdf = read_wind_file(folder / "RELOCATED_gfs025_120h_to_baltic.nc")
    np.testing.assert_allclose(grib.u[:41], netcdf.u, atol=0.01)
    np.testing.assert_allclose(grib.v[:41], netcdf.v, atol=0.01)
    np.testing.assert_allclose(grib.time[:41], netcdf.time)


def test_a_lambert_wind_is_turned_to_true_north(shared_data: Path) -> None:
    path = shared_data / "weather" / "netcdf" / "arome_metcoop_2p5km_northsea_20151116_67h.nc"
    wind = read_wind_file(path)
    with netCDF4.Dataset(path) as file:
        lat, lon = np.asarray(file["latitude"][:]), np.asarray(file["longitude"][:])
        x, y = (np.asarray(file[name][20]) for name in ("x_wind_10m", "y_wind_10m"))
    # the projection's own convergence: (lon - 15) sin 63, from its published parameters
    angle = np.radians((lon - 15.0) * np.sin(np.radians(63.0)))
    east, north = x * np.cos(angle) + y * np.sin(angle), -x * np.sin(angle) + y * np.cos(angle)
    inside = wind.covers(lat, lon)
    u, v = wind.at(wind.time[20], lat, lon)
    assert inside.mean() > 0.5
    # the fjords' wind changes from node to node, and interpolation smooths it; but nothing is left of a turn
    assert np.median(np.hypot(u - east, v - north)[inside]) < 0.2
    assert abs(np.mean((u - east)[inside])) < 0.005
    assert abs(np.mean((v - north)[inside])) < 0.005
    raw = read_netcdf(path, source="").wind
    assert raw is not None
    turned = grids.to_true_north(raw)
    np.testing.assert_allclose(turned.parts[0][20], east, atol=0.01)
    np.testing.assert_allclose(turned.parts[1][20], north, atol=0.01)


def test_a_file_is_cut_to_the_passage_and_judged_there(shared_data: Path) -> None:
    folder = shared_data / "weather" / "grib"
    wind = read_wind_file(folder / "gfs_EastAtlantic_20120822_ugrib.grb", around=[(50.0, -5.0), (43.0, -9.0)])
    assert wind.u.shape == (61, 16, 13)
    assert wind.covers([50.0, 43.0], [-5.0, -9.0]).all()
    masked = folder / "gfs_scandinavia_20150309_ugrib.grb"
    with pytest.raises(InputError, match=r"masked.*around the passage, as in files that leave out land"):
        read_wind_file(masked, around=[(54.5, 18.5), (59.3, 18.0)])
    # there are values in the North Sea near by, but the ports' own sea is left out
    with pytest.raises(InputError, match=r"masked.*around 57°42\.0'N 011°54\.0'E, as in files that leave"):
        read_wind_file(masked, around=[(58.0, 2.0), (57.7, 11.9)])
    assert read_wind_file(masked, around=[(60.4, 5.0), (57.0, -1.0)]).u.shape == (61, 11, 14)
    with pytest.raises(NoPassageError, match=r"28\.0 to 47\.0 N, 59\.0 to 80\.0 W") as caught:
        read_wind_file(folder / "zygrib_gfs_ww3_useast_20180429.grb", around=[(54.5, 18.5), (59.3, 18.0)])
    assert caught.value.reason == "outside-forecast"


def test_a_cut_lambert_file_is_the_same_wind(shared_data: Path) -> None:
    path = shared_data / "weather" / "netcdf" / "arome_metcoop_2p5km_northsea_20151116_67h.nc"
    whole, ends = read_wind_file(path), [(60.4, 5.0), (60.9, 4.9)]
    part = read_wind_file(path, around=ends)
    for lat, lon in ends:
        np.testing.assert_allclose(
            part.at(part.time[9], lat, lon), whole.at(part.time[9], lat, lon), atol=0.3
        )
    with pytest.raises(NoPassageError, match=r"58\.9 to 62\.5 N"):
        read_wind_file(path, around=[(54.5, 18.5), (60.9, 4.9)])


# --- GRIB made here -------------------------------------------------------------------------------

EAST = np.arange(ROWS * COLUMNS, dtype=np.float64).reshape(ROWS, COLUMNS) / 2 + 1.0
"""u of a field from south to north; v is its negative."""


def pair(values: Any = EAST[::-1], **keys: Any) -> bytes:
    """Messages of u and v, rows from north to south, as the samples scan."""
    return message("10u", values, **keys) + message("10v", -np.asarray(values), **keys)


def read(tmp_path: Path, content: bytes, name: str = "wind.grb") -> Any:
    path = tmp_path / name
    path.write_bytes(content)
    return read_wind_file(path)


@pytest.mark.parametrize("sample", ["regular_ll_sfc_grib1", "regular_ll_sfc_grib2"])
def test_a_grib_of_either_edition_is_read(tmp_path: Path, sample: str) -> None:
    wind = read(tmp_path, pair(sample=sample))
    np.testing.assert_allclose(wind.u[0], EAST, atol=1e-3)
    np.testing.assert_allclose(wind.v[0], -EAST, atol=1e-3)
    assert wind.forecast.issued == datetime(2026, 1, 1, 6, tzinfo=UTC)
    assert wind.forecast.valid_from == datetime(2026, 1, 1, 9, tzinfo=UTC)


def alternating(values: Any) -> Any:
    grid = np.array(values)
    grid[1::2] = grid[1::2, ::-1]
    return grid


@pytest.mark.parametrize(
    ("keys", "layout"),
    [
        ({"jScansPositively": 1, "latitudeOfFirstGridPointInDegrees": 54.0,
          "latitudeOfLastGridPointInDegrees": 57.0}, EAST),
        ({"iScansNegatively": 1, "longitudeOfFirstGridPointInDegrees": 20.0,
          "longitudeOfLastGridPointInDegrees": 16.0}, EAST[::-1, ::-1]),
        ({"jPointsAreConsecutive": 1}, EAST[::-1].T),
        ({"alternativeRowScanning": 1}, alternating(EAST[::-1])),
    ],
    ids=["south-to-north", "east-to-west", "columns-first", "boustrophedon"],
)  # fmt: skip
def test_every_way_of_scanning_gives_the_same_field(
    tmp_path: Path, keys: dict[str, Any], layout: Any
) -> None:
    wind = read(tmp_path, pair(layout, **keys))
    np.testing.assert_allclose(wind.lat, [54, 55, 56, 57])
    np.testing.assert_allclose(wind.lon, [16, 17, 18, 19, 20])
    np.testing.assert_allclose(wind.u[0], EAST, atol=1e-3)


def test_a_bitmap_is_filled_from_beside(tmp_path: Path) -> None:
    holed = EAST[::-1].copy()
    holed[1, 2] = 9999.0
    data = message("10u", holed, bitmapPresent=1, missingValue=9999) + message("10v", EAST[::-1])
    wind = read(tmp_path, data)
    assert np.isfinite(wind.u).all()
    assert wind.u[0, 2, 2] == pytest.approx(EAST[2, 2], abs=0.01)
    assert wind.u[0, 0, 0] == pytest.approx(EAST[0, 0], abs=0.01)


def test_the_later_run_wins(tmp_path: Path) -> None:
    later = pair(EAST[::-1] + 5, dataTime=900, stepRange="0")
    wind = read(tmp_path, later + pair())
    np.testing.assert_allclose(wind.u[0], EAST + 5, atol=1e-3)
    assert "Of 2 model runs, the latest" in wind.forecast.notice
    assert wind.forecast.issued == datetime(2026, 1, 1, 9, tzinfo=UTC)


def test_a_grid_around_the_world_is_closed_and_cut_at_the_date_line(tmp_path: Path) -> None:
    values = np.tile(np.arange(36.0), (ROWS, 1)) / 2
    wind = read(
        tmp_path,
        pair(values, Ni=36, longitudeOfFirstGridPointInDegrees=0.0, longitudeOfLastGridPointInDegrees=350.0,
             iDirectionIncrementInDegrees=10.0),
    )  # fmt: skip
    assert (wind.lon[0], wind.lon[-1]) == (-180.0, 180.0)
    np.testing.assert_allclose(wind.u[0, 0, [0, -1]], 9.0, atol=1e-3)
    assert wind.at(wind.time[0], 55.0, 20.0)[0] == pytest.approx(1.0, abs=1e-3)
    assert wind.at(wind.time[0], 55.0, -10.0)[0] == pytest.approx(17.5, abs=1e-3)


def test_a_rotated_grid_is_turned_and_resampled(tmp_path: Path) -> None:
    keys: dict[str, Any] = {
        "sample": "rotated_ll_sfc_grib2", "Ni": 25, "Nj": 21, "latitudeOfSouthernPoleInDegrees": -39.0,
        "longitudeOfSouthernPoleInDegrees": 0.0, "angleOfRotationInDegrees": 0.0, "uvRelativeToGrid": 1,
        "latitudeOfFirstGridPointInDegrees": 6.0, "latitudeOfLastGridPointInDegrees": 4.0,
        "longitudeOfFirstGridPointInDegrees": 9.0, "longitudeOfLastGridPointInDegrees": 11.4,
        "iDirectionIncrementInDegrees": 0.1, "jDirectionIncrementInDegrees": 0.1,
    }  # fmt: skip
    # pole of the rotated grid at 39 N 180 E: its meridians against the true ones, by spherical trigonometry
    handle_data = message("10u", np.zeros(525), **keys)
    handle = eccodes.codes_new_from_message(handle_data)
    lat, lon = (eccodes.codes_get_array(handle, name) for name in ("latitudes", "longitudes"))
    eccodes.codes_release(handle)
    pole = np.radians(39.0)
    away = np.radians(180.0 - lon)
    angle = np.arctan2(
        np.sin(away) * np.cos(pole),
        np.cos(np.radians(lat)) * np.sin(pole) - np.sin(np.radians(lat)) * np.cos(pole) * np.cos(away),
    )
    # a uniform wind of 10 m/s from the west, as seen along the grid's axes
    data = message("10u", 10 * np.cos(angle), **keys) + message("10v", 10 * np.sin(angle), **keys)
    wind = read(tmp_path, data)
    assert abs(np.degrees(angle)).max() > 5
    np.testing.assert_allclose(wind.u, 10.0, atol=0.02)
    np.testing.assert_allclose(wind.v, 0.0, atol=0.02)
    assert wind.lat.size > 10
    assert wind.covers(lat, lon).mean() > 0.5


def test_a_file_that_was_cut_off_is_used_as_far_as_it_goes(tmp_path: Path) -> None:
    data = pair() + pair(stepRange="6")
    wind = read(tmp_path, data[:-40])
    assert wind.time.size == 1
    assert "cut off after 3 messages" in wind.forecast.notice


def test_what_stands_around_the_messages_does_not_matter(tmp_path: Path) -> None:
    wind = read(
        tmp_path,
        b"From: query@example.org\r\n\r\n" + message("2t", EAST + 280) + b"\0\0" + pair() + b"\r\nbye",
    )
    np.testing.assert_allclose(wind.u[0], EAST, atol=1e-3)


@pytest.mark.parametrize("pack", [bz2.compress, gzip.compress])
def test_a_packed_file_is_read_whatever_its_name(tmp_path: Path, pack: Any) -> None:
    assert read(tmp_path, pack(pair())).u.shape == (1, ROWS, COLUMNS)
    netcdf = write_netcdf(tmp_path / "wind.nc").read_bytes()
    np.testing.assert_allclose(read(tmp_path, pack(netcdf)).u[0], EAST)
    with pytest.raises(InputError, match="damaged or cut off"):
        read(tmp_path, pack(pair())[:-30])


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "empty"),
        (b"hello", "neither GRIB nor NetCDF"),
        (b"GRIB", "not a GRIB file"),
        (b"GRIB" + b"\x00" * 100, "not a GRIB file"),
        (b"\x89HDF\r\n\x1a\n" + b"\0" * 100, "not a NetCDF file"),
        (b"CDF\x01 and then nonsense", "not a NetCDF file"),
        (b"BZh9 not really", "damaged"),
        (message("2t", EAST), "none of its 1 messages is wind at 10 m"),
        (message("10u", EAST), "only one of the two components"),
        (pair(EAST * 100), "above 120 m/s"),
    ],
)
def test_what_is_no_wind_is_refused_in_one_sentence(tmp_path: Path, content: bytes, words: str) -> None:
    with pytest.raises(InputError, match=words) as caught:
        read(tmp_path, content)
    sentence = str(caught.value)
    assert "wind.grb" in sentence
    assert sentence.endswith(".")
    assert ".." not in sentence


@hypothesis_settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.integers(0, len(pair()) - 1), st.booleans())
def test_a_file_cut_anywhere_is_a_wind_or_one_sentence(tmp_path: Path, length: int, zeros: bool) -> None:
    data = (pair() + pair(stepRange="6"))[: len(pair()) + length] + bytes(50) * zeros
    wind = read(tmp_path, data)
    np.testing.assert_allclose(wind.u[0], EAST, atol=1e-3)


@pytest.mark.parametrize(
    ("sample", "position", "byte"),
    [
        ("regular_ll_sfc_grib1", 10, 159),  # length of section 1
        ("regular_ll_sfc_grib1", 15, 0x3F),  # which sections there are
        ("regular_ll_sfc_grib1", 25, 200),  # unit of time
        ("regular_ll_sfc_grib2", 19, 250),  # length of section 1
        ("regular_ll_sfc_grib2", 20, 9),  # number of section 1
    ],
)
def test_damage_on_which_the_library_would_crash_is_refused(
    tmp_path: Path, sample: str, position: int, byte: int
) -> None:
    data = bytearray(pair(sample=sample))
    data[position] = byte
    with pytest.raises(InputError, match="damaged"):
        read(tmp_path, bytes(data))


@hypothesis_settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.sampled_from([b"GRIB", b"BZh", b"CDF\x01", b"\x1f\x8b", b""]), st.binary(max_size=300))
def test_any_bytes_are_a_wind_or_one_sentence(tmp_path: Path, head: bytes, rest: bytes) -> None:
    with pytest.raises(InputError, match=r"wind\.grb"):
        read(tmp_path, head + rest)


def test_the_library_does_not_write_to_the_terminal(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    data = bytearray(message("10u", EAST))
    # section 5, of 21 bytes, names the packing; of one that it does not know the library complains aloud
    data[data.index(b"\x00\x00\x00\x15\x05") + 10] = 77
    with pytest.raises(InputError, match="cannot be decoded"):
        read(tmp_path, bytes(data))
    assert capfd.readouterr() == ("", "")


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="cannot be read: No such file"):
        read_wind_file(tmp_path / "nowhere.grb")
    with pytest.raises(InputError, match="cannot be read"):
        read_wind_file(tmp_path)


def test_a_missing_library_is_one_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    data = pair()
    monkeypatch.setitem(sys.modules, "eccodes", None)
    with pytest.raises(InputError, match="pip install eccodes"):
        read(tmp_path, data)


# --- NetCDF made here -----------------------------------------------------------------------------


def write_netcdf(path: Path, **changes: Any) -> Path:
    """Write a NetCDF of one time; ``changes`` replace names, units, axes or add dimensions."""
    case: dict[str, Any] = {
        "names": ("u10", "v10"), "unit": "m s-1",
        "lat": [54.0, 55.0, 56.0, 57.0], "lon": [16.0, 17.0, 18.0, 19.0, 20.0],
        "dims": ("time", "lat", "lon"), "extra": {},
        "time": [0.0], "time_unit": "hours since 2026-01-01 09:00:00",
        "values": EAST, "calendar": "standard", **changes,
    }  # fmt: skip
    with netCDF4.Dataset(path, "w") as file:
        axes = {"time": case["time"], "lat": case["lat"], "lon": case["lon"], **case["extra"]}
        for name, values in axes.items():
            file.createDimension(name, len(values))
            axis = file.createVariable(name, "f8", (name,))
            axis[:] = values
        file["time"].units, file["time"].calendar = case["time_unit"], case["calendar"]
        file["lat"].units, file["lon"].units = "degrees_north", "degrees_east"
        for name in case["extra"]:
            file[name].units = "m" if name == "height" else "1"
        # the value at index n of an extra dimension is n + 1 times the field
        plain = [name for name in ("time", "lat", "lon") if name in case["dims"]]
        whole = np.broadcast_to(case["values"], [len(axes[name]) for name in plain])
        for name, values in case["extra"].items():
            plain, whole = [name, *plain], np.stack([whole * (index + 1) for index in range(len(values))])
        for name, sign in zip(case["names"], (1, -1), strict=True):
            variable = file.createVariable(name, "f4", case["dims"], fill_value=-999.0)
            if case["unit"] is not None:
                variable.units = case["unit"]
            variable[:] = np.transpose(sign * whole, [plain.index(dim) for dim in case["dims"]])
    return path


@pytest.mark.parametrize(
    ("changes", "factor", "notice"),
    [
        ({}, 1.0, ""),
        ({"names": ("10u", "10v")}, 1.0, ""),
        ({"names": ("UGRD_10maboveground", "VGRD_10maboveground")}, 1.0, ""),
        ({"names": ("eastward_wind", "northward_wind")}, 1.0, ""),
        ({"unit": None}, 1.0, ""),
        ({"unit": "knots"}, 1852 / 3600, ""),
        ({"unit": "km/h"}, 1 / 3.6, ""),
        ({"dims": ("lon", "time", "lat")}, 1.0, ""),
        ({"dims": ("lat", "lon")}, 1.0, ""),
        ({"lat": [57.0, 56.0, 55.0, 54.0], "values": EAST[::-1]}, 1.0, ""),
        ({"lon": [376.0, 377.0, 378.0, 379.0, 380.0]}, 1.0, ""),
        ({"dims": ("time", "height", "lat", "lon"), "extra": {"height": [2.0, 10.0, 80.0]}}, 2.0, ""),
        (
            {"dims": ("time", "height", "lat", "lon"), "extra": {"height": [50.0]}},
            1.0,
            "The wind is that at 50 m",
        ),
        (
            {"dims": ("number", "time", "lat", "lon"), "extra": {"number": [0, 1, 2]}},
            2.0,
            "",
        ),
        (
            {"dims": ("time", "kind", "lat", "lon"), "extra": {"kind": [0, 1, 2]}},
            1.0,
            "Of 3 layers (kind) of the wind, the first one is used.",
        ),
    ],
)
def test_a_netcdf_of_any_dialect_is_the_same_wind(
    tmp_path: Path, changes: dict[str, Any], factor: float, notice: str
) -> None:
    wind = read_wind_file(write_netcdf(tmp_path / "wind.nc", **changes))
    np.testing.assert_allclose(wind.lat, [54, 55, 56, 57])
    np.testing.assert_allclose(wind.lon, [16, 17, 18, 19, 20])
    np.testing.assert_allclose(wind.u[0], EAST * factor, rtol=1e-5)
    np.testing.assert_allclose(wind.v[0], -EAST * factor, rtol=1e-5)
    assert wind.forecast.valid_from == datetime(2026, 1, 1, 9, tzinfo=UTC)
    assert notice in wind.forecast.notice


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"names": ("t2m", "d2m")}, "none of its variables"),
        ({"names": ("uo", "vo")}, "sea currents"),
        ({"unit": "furlongs per fortnight"}, "'furlongs per fortnight', not in m/s"),
        ({"time_unit": "hours"}, "no time axis"),
        ({"calendar": "360_day"}, "damaged"),
        ({"values": EAST * 100}, "above 120 m/s"),
        ({"values": np.full((ROWS, COLUMNS), np.nan)}, "masked"),
    ],
)
def test_a_netcdf_without_a_usable_wind_is_refused(
    tmp_path: Path, changes: dict[str, Any], words: str
) -> None:
    with pytest.raises(InputError, match=words):
        read_wind_file(write_netcdf(tmp_path / "wind.nc", **changes))


def test_uneven_latitudes_are_evened(tmp_path: Path) -> None:
    wind = read_wind_file(write_netcdf(tmp_path / "wind.nc", lat=[54.0, 55.0, 56.2, 57.0]))
    np.testing.assert_allclose(wind.lat, [54, 55, 56, 57])
    assert wind.u[0, 2, 0] == pytest.approx(EAST[1, 0] + (EAST[2, 0] - EAST[1, 0]) / 1.2, abs=1e-4)


def test_repeated_and_unsorted_times_are_put_in_order(tmp_path: Path) -> None:
    values = np.stack([EAST, EAST + 1, EAST + 2])
    wind = read_wind_file(write_netcdf(tmp_path / "wind.nc", time=[3.0, 0.0, 3.0], values=values))
    np.testing.assert_allclose(wind.u[:, 0, 0], [2.0, 3.0])


def test_a_model_too_fine_for_memory_is_thinned(shared_data: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(grids, "MAX_VALUES", 100_000)
    wind = read_wind_file(shared_data / "weather" / "netcdf" / "arome_metcoop_2p5km_northsea_20151116_67h.nc")
    assert wind.u.size <= 100_000
    assert wind.forecast.resolution_deg > 0.03
