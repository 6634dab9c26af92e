"""SeaCruise answers how long a passage takes under sail, and whether a week is enough.

What is listed in ``__all__`` is public; nothing else is. The names are loaded when they are first
touched, so that ``import seacruise`` costs nothing::

    from pathlib import Path
    import seacruise

    settings, job = seacruise.Settings.from_environment(), seacruise.Job()
    ports = seacruise.load_ports()
    start, end = seacruise.find_port("Gdynia", ports), seacruise.find_port("Stockholm", ports)
    yacht = seacruise.read_polar(Path("my-yacht.csv"))
    wind = seacruise.fetch_wind(
        ["sample"],
        start=(start.lat, start.lon),
        end=(end.lat, end.lon),
        departure=None,
        settings=settings,
        job=job,
    )
    passage = seacruise.plan(seacruise.PassageRequest(start, end, yacht, wind), settings=settings, job=job)
    print(passage.duration_h)
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from seacruise.errors import (
        CancelledError,
        InputError,
        NoPassageError,
        SeaCruiseError,
        WeatherError,
    )
    from seacruise.passage import Options, Passage, PassageRequest, Waypoint, plan
    from seacruise.ports import Port, find_port, load_ports
    from seacruise.progress import Job
    from seacruise.reach import ReachRequest
    from seacruise.reach import reach as ports_in_reach
    from seacruise.sea import Sea
    from seacruise.settings import Settings
    from seacruise.simulation import simulate
    from seacruise.study import compare, ensemble, variants
    from seacruise.underway import SavedPassage, replan
    from seacruise.weather.source import fetch_wind
    from seacruise.weather.wind import Forecast, Wind
    from seacruise.yacht.files import read_polar
    from seacruise.yacht.polar import Polar

__version__ = "0.1.0"

__all__ = [
    "CancelledError",
    "Forecast",
    "InputError",
    "Job",
    "NoPassageError",
    "Options",
    "Passage",
    "PassageRequest",
    "Polar",
    "Port",
    "ReachRequest",
    "SavedPassage",
    "Sea",
    "SeaCruiseError",
    "Settings",
    "Waypoint",
    "WeatherError",
    "Wind",
    "__version__",
    "compare",
    "ensemble",
    "fetch_wind",
    "find_port",
    "load_ports",
    "plan",
    "ports_in_reach",
    "read_polar",
    "replan",
    "simulate",
    "variants",
]

_HOME_OF = {
    "CancelledError": "errors",
    "Forecast": "weather.wind",
    "InputError": "errors",
    "Job": "progress",
    "NoPassageError": "errors",
    "Options": "passage",
    "Passage": "passage",
    "PassageRequest": "passage",
    "Polar": "yacht.polar",
    "Port": "ports",
    "ReachRequest": "reach",
    "SavedPassage": "underway",
    "Sea": "sea",
    "SeaCruiseError": "errors",
    "Settings": "settings",
    "Waypoint": "passage",
    "WeatherError": "errors",
    "Wind": "weather.wind",
    "compare": "study",
    "ensemble": "study",
    "fetch_wind": "weather.source",
    "find_port": "ports",
    "load_ports": "ports",
    "plan": "passage",
    # `seacruise.reach` is the module: the name of its function is taken.
    "ports_in_reach": "reach:reach",
    "read_polar": "yacht.files",
    "replan": "underway",
    "simulate": "simulation",
    "variants": "study",
}


def __getattr__(name: str) -> object:
    """Load a public name from its room on first use (PEP 562)."""
    try:
        room, _, own = _HOME_OF[name].partition(":")
    except KeyError:
        raise AttributeError(f"module 'seacruise' has no attribute {name!r}") from None
    value = getattr(import_module(f"seacruise.{room}"), own or name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """List the public names, loaded or not."""
    return sorted(__all__)
