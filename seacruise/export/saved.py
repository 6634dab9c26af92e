"""Reading back a passage that ``seacruise plan --format json`` printed."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path

import msgspec

from seacruise.errors import InputError
from seacruise.model import SCHEMA, Waypoint
from seacruise.ports import Port
from seacruise.text import read_text
from seacruise.underway import SavedPassage


class _Place(msgspec.Struct):
    name: str
    lat: float
    lon: float


class _Forecast(msgspec.Struct):
    source: str
    issued: datetime | None = None


class _Waypoint(msgspec.Struct):
    lat: float
    lon: float
    time: datetime
    course_deg: float | None = None
    leg_nm: float | None = None
    boat_speed_kn: float | None = None
    tws_kn: float | None = None
    twd_deg: float | None = None
    twa_deg: float | None = None
    motor: bool | None = None
    steer_deg: float | None = None


class _Passage(msgspec.Struct):
    """The keys that re-planning needs; others may be there."""

    schema: str
    start: _Place
    end: _Place
    yacht: str
    max_tws_kn: float
    forecast: _Forecast
    waypoints: list[_Waypoint]


def read_saved(path: Path) -> SavedPassage:
    """Read a file with the JSON of a passage.

    Raises
    ------
    InputError
        It cannot be read, or is not the JSON of a passage.
    """
    return saved_from_json(read_text(path, "saved passage"), name=path.name)


def saved_from_json(text: str, *, name: str = "The text") -> SavedPassage:
    """Read the JSON of a passage, schema ``seacruise.passage/1``.

    Parameters
    ----------
    name
        What it is called in a sentence.

    Raises
    ------
    InputError
        It is not the JSON of a passage.
    """
    try:
        data = msgspec.json.decode(text, type=_Passage)
    except (msgspec.MsgspecError, RecursionError) as error:
        raise _refused(name, str(error)) from None
    if data.schema != SCHEMA:
        raise _refused(name, f"its schema is {data.schema!r}, not {SCHEMA!r}")
    ends = [(place.lat, place.lon) for place in (data.start, data.end)]
    for lat, lon in [*ends, *((w.lat, w.lon) for w in data.waypoints)]:
        if not (-90.0 <= lat <= 90.0 and -180.0 <= lon <= 180.0):
            raise _refused(name, f"{lat:g}, {lon:g} is no position")
    times = [waypoint.time for waypoint in data.waypoints]
    if any(time.tzinfo is None for time in times):
        raise _refused(name, "a time has no time zone")
    return SavedPassage(
        start=Port(data.start.name, "", data.start.lat, data.start.lon),
        end=Port(data.end.name, "", data.end.lat, data.end.lon),
        yacht=data.yacht,
        waypoints=tuple(Waypoint(**msgspec.structs.asdict(w)) for w in data.waypoints),
        max_tws_kn=data.max_tws_kn,
        source=data.forecast.source,
        issued=data.forecast.issued,
    )


def _refused(name: str, why: str) -> InputError:
    return InputError(
        f"{name} is not a saved passage ({why}); make one with 'seacruise plan --format json > passage.json'."
    )
