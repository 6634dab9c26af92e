"""The sample that ships with the program: real Baltic weather of 20-22 November 2016.

GFS analyses of NOAA (public domain), 1 degree, every six hours; see docs/weather.md for how they came here.
"""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Final

import numpy as np

from seacruise.resources import resource_path
from seacruise.weather.wind import Forecast, Wind, describe_grid

SOURCE: Final = "Sample: real Baltic analyses, 20-22 Nov 2016 (NOAA GFS)"
NOTICE: Final = "Sample weather: real analyses of 20-22 November 2016, not a forecast."
VALID_FROM: Final = datetime(2016, 11, 20, tzinfo=UTC)
VALID_TO: Final = datetime(2016, 11, 22, tzinfo=UTC)


def sample_wind() -> Wind:
    """Read the sample: 9 times six hours apart, 52-67 N 7-32 E."""
    with np.load(resource_path("assets/wind/sample.npz")) as file:
        time, lat, lon, u, v = (file[name] for name in ("time", "lat", "lon", "u10", "v10"))
    valid_from, valid_to, step_h, resolution = describe_grid(time, lat, lon)
    forecast = Forecast(
        source=SOURCE,
        issued=None,
        valid_from=valid_from,
        valid_to=valid_to,
        step_h=step_h,
        resolution_deg=resolution,
        notice=NOTICE,
        real=False,
    )
    return Wind(time=time, lat=lat, lon=lon, u=u, v=v, forecast=forecast)
