"""Signal K: delta messages, one JSON object a line, as blocks of a log.

Signal K speaks SI and radians. Only the own vessel counts: the context ``vessels.self``, the one that the
server's greeting calls ``self``, or none; what AIS tells of others is left out.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from datetime import UTC, datetime
from math import degrees, isfinite, isnan, nan, pi
from typing import Any, Final

import msgspec

from seacruise.yacht.logs.gather import Gatherer
from seacruise.yacht.logs.log import Log, Tally

_NOT_SELF: Final = "of other vessels"


class _Value(msgspec.Struct):
    path: str
    value: Any = None


class _Update(msgspec.Struct):
    timestamp: str | None = None
    values: list[_Value] = []


class _Message(msgspec.Struct):
    """A delta, or the greeting that names the own vessel."""

    context: str | None = None
    updates: list[_Update] = []
    self_: str | None = msgspec.field(default=None, name="self")
    timestamp: str | None = None


def _same(value: float) -> float:
    return value


def _direction(value: float) -> float:
    return degrees(value) % 360.0


def _off_bow(value: float) -> float:
    # Servers send -pi to pi, some instruments 0 to 2 pi.
    return 180.0 - (180.0 - degrees(value)) % 360.0


def _per_minute(value: float) -> float:
    return value * 60.0


_COLUMNS: Final[dict[str, tuple[str, Callable[[float], float], float, float]]] = {
    "navigation.speedOverGround": ("sog", _same, 0.0, 120.0),
    "navigation.courseOverGroundTrue": ("cog", _direction, -2 * pi, 4 * pi),
    "navigation.speedThroughWater": ("stw", _same, 0.0, 120.0),
    "navigation.headingTrue": ("heading", _direction, -2 * pi, 4 * pi),
    "environment.wind.angleApparent": ("awa", _off_bow, -2 * pi, 4 * pi),
    "environment.wind.speedApparent": ("aws", _same, 0.0, 120.0),
    "environment.wind.angleTrueWater": ("twa", _off_bow, -2 * pi, 4 * pi),
    "environment.wind.speedTrue": ("tws", _same, 0.0, 120.0),
}
"""Path: column, conversion, and the bounds of a sound value."""

_RPM = re.compile(r"propulsion\.[^.]+\.revolutions")


def read_signalk(lines: Iterable[bytes], tally: Tally, *, variation_deg: float = nan) -> Iterator[Log]:
    """Read Signal K deltas in blocks; memory does not grow with the log.

    Parameters
    ----------
    lines
        JSON objects, one a line; what the server's own logger puts before the brace is passed over.
    tally
        Is counted up on the way.
    variation_deg
        Magnetic variation [degrees, positive to the east] where the log tells none.

    Yields
    ------
    Log
        A row for each second in which something was said.
    """
    decode = msgspec.json.Decoder(_Message).decode
    rows = Gatherer()
    own = {"vessels.self"}
    variation = [variation_deg]
    for line in lines:
        brace = line.find(b"{")
        if brace < 0:
            if line.strip():
                tally.skipped["garbled"] += 1
            continue
        try:
            message = decode(line[brace:])
        except (msgspec.MsgspecError, UnicodeDecodeError):
            tally.skipped["garbled"] += 1
            continue
        if message.self_:
            own |= {message.self_, f"vessels.{message.self_.removeprefix('vessels.')}"}
        if message.context is not None and message.context not in own:
            tally.skipped[_NOT_SELF] += 1
            continue
        for update in message.updates:
            _take(update, rows, variation, tally)
        if block := rows.full():
            yield block
    if block := rows.rest():
        yield block
    if _NOT_SELF in tally.skipped and not tally.used:
        tally.notes.append("No message is of vessels.self and no greeting says which vessel is the own one.")


def _take(update: _Update, rows: Gatherer, variation: list[float], tally: Tally) -> None:
    try:
        moment = datetime.fromisoformat(update.timestamp or "")
    except ValueError:
        tally.skipped["without a time"] += 1
        return
    # Instruments answer some hundredths of a second apart; a row a second is what a log means.
    second = moment.replace(microsecond=0)
    rows.at((second if second.tzinfo else second.replace(tzinfo=UTC)).timestamp())
    known = sum([_put(entry.path, entry.value, rows, variation) for entry in update.values])
    if known:
        tally.used += 1
    else:
        tally.skipped["of other kinds"] += 1


def _put(path: str, value: Any, rows: Gatherer, variation: list[float]) -> bool:
    if path == "navigation.position" and isinstance(value, dict):
        lat, lon = _number(value.get("latitude"), -90, 90), _number(value.get("longitude"), -180, 180)
        if isnan(lat) or isnan(lon):
            return False
        rows.put("lat", lat)
        rows.put("lon", lon)
        return True
    if path == "navigation.magneticVariation":
        variation[0] = degrees(_number(value, -pi, pi))
        return True
    if path == "navigation.headingMagnetic":
        heading = degrees(_number(value, -2 * pi, 4 * pi))
        rows.put("heading", (heading + (0.0 if isnan(variation[0]) else variation[0])) % 360.0)
        return not isnan(heading)
    if path in _COLUMNS:
        column, convert, low, high = _COLUMNS[path]
    elif _RPM.fullmatch(path):
        column, convert, low, high = "rpm", _per_minute, 0.0, 400.0
    else:
        return False
    number = _number(value, low, high)
    if isnan(number):
        return False
    rows.put(column, convert(number))
    return True


def _number(value: Any, low: float, high: float) -> float:
    """Give a value as a number, NaN where it is none or out of bounds."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not isfinite(value):
        return nan
    return float(value) if low <= value <= high else nan
