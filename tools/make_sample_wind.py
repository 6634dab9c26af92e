"""Write ``assets/wind/sample.nc`` and ``.npz`` from a NetCDF file of 10 m wind: run once, both are committed.

    python tools/make_sample_wind.py SOURCE.nc assets/wind/sample.nc

The source holds ``u10 v10 (time, lat, lon)``. Values are packed as 16-bit integers of 0.01 m/s, far below
the 0.19 m/s of the source's own quantisation. The second file has the same as plain arrays: the program reads
it at once, and need not load a library for NetCDF first.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import netCDF4
import numpy as np

ATTRIBUTES = {
    "Conventions": "CF-1.8",
    "title": "Wind at 10 m over the Baltic, 20-22 November 2016",
    "institution": "NOAA/NCEP (data); packed for SeaCruise",
    "source": "GFS 1 degree analyses, 2016-11-20T00Z to 2016-11-22T00Z every six hours",
    "history": (
        "NOAA GFS analyses; made into 8-bit pictures by the demonstration of mapbox/webgl-wind, which "
        "quantised them to 0.19 m/s; read back, cut to 52-67 N 7-32 E, packed as int16 of 0.01 m/s"
    ),
    "license": "Public domain (work of the United States government)",
}


def write_sample(source: Path, target: Path) -> None:
    """Copy the wind of ``source`` to ``target``: ascending latitudes, packed and compressed."""
    with netCDF4.Dataset(source) as old, netCDF4.Dataset(target, "w", format="NETCDF4") as new:
        new.setncatts(ATTRIBUTES)
        lat, lon = np.asarray(old["lat"][:]), np.asarray(old["lon"][:])
        rows, columns = np.argsort(lat), np.argsort(lon)
        dates = netCDF4.num2date(old["time"][:], old["time"].units)
        seconds = np.asarray(netCDF4.date2num(dates, "seconds since 1970-01-01 00:00:00"))
        for name, values, unit, standard in (
            ("time", seconds, "seconds since 1970-01-01 00:00:00", "time"),
            ("lat", lat[rows], "degrees_north", "latitude"),
            ("lon", lon[columns], "degrees_east", "longitude"),
        ):
            new.createDimension(name, len(values))
            axis = new.createVariable(name, "f8", (name,))
            axis.setncatts({"units": unit, "standard_name": standard})
            axis[:] = values
        for name, standard in (("u10", "eastward_wind"), ("v10", "northward_wind")):
            component = new.createVariable(
                name, "i2", ("time", "lat", "lon"), zlib=True, shuffle=True, complevel=9
            )
            component.setncatts(
                {"units": "m s-1", "standard_name": standard, "scale_factor": 0.01, "height": "10 m"}
            )
            component[:] = np.asarray(old[name][:])[:, rows][:, :, columns]


def write_arrays(sample: Path) -> None:
    """Write beside a sample what is in it, as the program takes it."""
    with netCDF4.Dataset(sample) as file:
        axes = {name: np.asarray(file[name][:], dtype=np.float64) for name in ("time", "lat", "lon")}
        wind = {name: np.asarray(file[name][:], dtype=np.float32) for name in ("u10", "v10")}
    np.savez_compressed(sample.with_suffix(".npz"), allow_pickle=False, **axes, **wind)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Write the sample wind from a NetCDF file.")
    parser.add_argument("source", type=Path)
    parser.add_argument("target", type=Path)
    arguments = parser.parse_args()
    write_sample(arguments.source, arguments.target)
    write_arrays(arguments.target)
