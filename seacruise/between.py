"""What lies between two ports: the sea, and the wind over it."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from seacruise.geodesy import great_circle_m
from seacruise.ports import Port
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.units import METRES_PER_NM

if TYPE_CHECKING:
    from seacruise.sea import Sea
    from seacruise.weather.wind import Wind


def sea_between(start: Port, end: Port, settings: Settings) -> Sea:
    """Read the sea around two ports, wide enough for any passage between them."""
    from seacruise.sea import Sea

    away = float(great_circle_m(start.lat, start.lon, end.lat, end.lon)) / METRES_PER_NM / 60
    return Sea.around(
        (start.lat, end.lat), (start.lon, end.lon), margin_deg=1.0 + away / 2, cache_dir=settings.cache_dir
    )


def fetch_wind_between(
    names: Sequence[str],
    start: Port,
    end: Port,
    departure: datetime | None,
    *,
    settings: Settings,
    job: Job,
    weights: Sequence[float] | None = None,
    current: Path | None = None,
) -> Wind:
    """Get the wind for a passage, see `seacruise.weather.source.fetch_wind`.

    The sea is only read when a service has to know which of its points are worth a request.
    """
    from seacruise.weather.source import fetch_wind

    def is_water(lat: Any, lon: Any) -> Any:
        return sea_between(start, end, settings).is_water(lat, lon)

    return fetch_wind(
        names,
        start=(start.lat, start.lon),
        end=(end.lat, end.lon),
        departure=departure,
        settings=settings,
        job=job,
        is_water=is_water,
        weights=weights,
        current=current,
    )
