"""One request to Storm Glass, to see whether a key is accepted; only sent when the sailor asks for it."""

from __future__ import annotations

from datetime import datetime
from typing import Final

from seacruise.errors import WeatherError
from seacruise.progress import Job
from seacruise.settings import Settings
from seacruise.weather.answers import Meta
from seacruise.weather.cache import Memory, Quota
from seacruise.weather.http import Limits
from seacruise.weather.stormglass_client import Client, check_key

PLACE: Final = (57.0, 19.75)
"""Open sea east of Gotland, latitude and longitude [degrees]."""

_WINDOW_S: Final = 6 * 3600.0
_ABOUT_THE_KEY: Final = frozenset({"bad-key", "no-key", "quota"})


def try_key(settings: Settings, *, now: datetime, job: Job) -> Quota:
    """Send one request with the key of the settings; returns what is left of the day, that one counted.

    Raises
    ------
    WeatherError
        The key is not accepted, its requests are spent, or the service cannot be reached.
    """
    key = check_key(settings)
    memory = Memory(settings.database)
    answered: list[Meta] = []

    def note(meta: Meta) -> None:
        answered.append(meta)
        memory.note_request(key, now, used=meta.used, daily=meta.daily, cost=meta.cost, spent=meta.spent)

    client = Client(settings, Limits(tries=1), note)
    window = now.timestamp(), now.timestamp() + _WINDOW_S
    try:
        client.ask(PLACE, window, source="sg", stop=job.cancel)
    except WeatherError as error:
        # An answer of which the wind cannot be used is one to a key that is good.
        if not answered or error.reason in _ABOUT_THE_KEY:
            raise
    finally:
        client.close()
    job.check()
    return memory.quota(key, now)
