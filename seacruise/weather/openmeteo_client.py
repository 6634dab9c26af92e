"""One request to Open-Meteo, many places at a time: how it is asked, and what its refusals mean."""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final
from urllib.parse import urlsplit

import requests

from seacruise.errors import WeatherError
from seacruise.settings import OPENMETEO_URL, Settings
from seacruise.weather.http import Call, Limits, Reply, fetch
from seacruise.weather.openmeteo_answers import (
    SERVICE,
    Asked,
    places_text,
    refusal_text,
    to_marine,
    to_members,
    to_wind,
)
from seacruise.weather.series import Series

DAYS: Final = 10
"""Days that are asked for: beyond them no model tells a single wind from the climate's."""


@dataclass(frozen=True, slots=True)
class Endpoint:
    """One of the service's collections of data.

    Attributes
    ----------
    name
        Short name, part of what its answers are kept under.
    host, path
        Where it is; the host only while the service's own address is in use.
    params
        What is asked of it besides places and time.
    decode
        Makes series of a body.
    places_each
        Places in one request: a limit of the address's length, and of the answer's size.
    """

    name: str
    host: str
    path: str
    params: Mapping[str, str]
    decode: Callable[[bytes, Asked], list[Series]]
    places_each: int

    def url(self, settings: Settings) -> str:
        """Address of the endpoint: a server of the sailor's own has all of them."""
        if settings.openmeteo_url == OPENMETEO_URL:
            return f"https://{self.host}{self.path}"
        return settings.openmeteo_url + self.path


FORECAST: Final = Endpoint(
    "wind",
    urlsplit(OPENMETEO_URL).netloc,
    "/v1/forecast",
    {"hourly": "wind_speed_10m,wind_direction_10m,wind_gusts_10m"},
    to_wind,
    100,
)
MARINE: Final = Endpoint(
    "sea",
    "marine-api.open-meteo.com",
    "/v1/marine",
    {"hourly": "wave_height,ocean_current_velocity,ocean_current_direction"},
    to_marine,
    100,
)
ENSEMBLE: Final = Endpoint(
    "ensemble",
    "ensemble-api.open-meteo.com",
    "/v1/ensemble",
    {"hourly": "wind_speed_10m,wind_direction_10m", "models": "ecmwf_ifs025_ensemble"},
    to_members,
    10,
)


def ask(
    session: requests.Session,
    url: str,
    endpoint: Endpoint,
    asked: Asked,
    *,
    limits: Limits,
    stop: threading.Event,
) -> list[Series]:
    """Ask for all hours of some places.

    Parameters
    ----------
    url
        Address of the endpoint, see `Endpoint.url`.
    stop
        Set when nobody waits any more.

    Raises
    ------
    WeatherError
    """
    call = Call(
        service=SERVICE,
        url=url,
        params={
            **places_text(asked.places),
            **endpoint.params,
            # km/h is the service's default
            "wind_speed_unit": "ms",
            "timeformat": "unixtime",
            "timezone": "GMT",
            "forecast_days": str(DAYS),
            "cell_selection": "sea",
        },
        headers={},
        decode=lambda body: endpoint.decode(body, asked),
        refuse=_refusal,
    )
    return fetch(session, call, limits, stop)


def _refusal(reply: Reply) -> WeatherError | None:
    """Say what the service's own errors mean; ``None`` for those that mean the same everywhere."""
    reason = refusal_text(reply.body)
    if reply.status == 429:
        # its counters start anew by the clock, and it sends no Retry-After
        lowered = reason.lower()
        if "daily" in lowered:
            when = "the count starts again at 00:00 UTC"
        elif "hourly" in lowered:
            when = "the count starts again at the next full hour"
        else:
            when = "try again in a minute"
        return WeatherError(
            f"{SERVICE} has answered as often as it does without payment; {when}. Until then plan with "
            "practice weather or a file.",
            reason="quota",
        )
    if reply.status in (400, 401, 403):
        return WeatherError(
            f"{SERVICE} refuses the request (HTTP {reply.status}): {reason or 'it does not say why'}."
        )
    return None
