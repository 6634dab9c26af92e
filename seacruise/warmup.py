"""Compile the kernels and draw the sea once, so that the first passage does not wait for it.

``python -m seacruise.warmup`` runs at the end of the installation; the window does the same in the
background when it opens. What is compiled stays on disk.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from datetime import timedelta
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from seacruise.progress import Job
from seacruise.settings import Settings


def warm_up(settings: Settings | None = None) -> None:
    """Plan a short passage and a short outing on the bundled wind: what long ones need is then compiled."""
    from seacruise.passage import PassageRequest, plan
    from seacruise.ports import find_port, load_ports
    from seacruise.reach import ReachRequest, reach
    from seacruise.resources import resource_path
    from seacruise.weather.sample import sample_wind
    from seacruise.weather.wind import Current
    from seacruise.yacht.fleet import find_yacht, load_fleet

    ports = load_ports()
    wind = sample_wind()
    request = PassageRequest(
        start=find_port("Visby", ports),
        end=find_port("Västervik", ports),
        yacht=find_yacht("Bavaria 46 Cruiser", load_fleet([resource_path("polars")])),
        wind=wind,
        departure=wind.forecast.valid_from + timedelta(hours=6),
    )
    settings = settings or Settings.from_environment()
    plan(request, settings=settings, job=Job())
    # The kernels have a second version for moving water, and turning has kernels of its own.
    still = np.zeros((1, wind.lat.size, wind.lon.size), dtype=np.float32)
    water = Current(wind.time[:1], wind.lat, wind.lon, still, still, wind.forecast)
    drifting = replace(wind, current=water)
    costly = replace(request.options, tack_penalty_min=1.0, shore_clearance_nm=0.5)
    plan(replace(request, wind=drifting), settings=settings, job=Job())
    plan(replace(request, options=costly), settings=settings, job=Job())
    outing = ReachRequest(request.start, request.yacht, wind, 2.0, request.departure)
    reach(outing, ports=ports, settings=settings, job=Job())


def draw_a_sea() -> None:
    """Draw a sea and forget it: where one is drawn already, the first one elsewhere would compile for it."""
    from seacruise.sea import Sea

    with TemporaryDirectory() as folder:
        Sea.around((57.6,), (18.3,), margin_deg=0.1, cache_dir=Path(folder))


if __name__ == "__main__":
    print("Preparing SeaCruise for this computer (once)...", file=sys.stderr)  # noqa: T201
    warm_up()
    draw_a_sea()
