"""NMEA 0183: what talkers say at their own pace, garbled and merged lines among it, as blocks of a log.

Read: RMC, GLL, GGA, ZDA (time and position), VTG (over ground), VHW (through the water), HDG, HDT, HDM
(heading), MWV and VWR (wind), RPM (engine). Sentences are taken apart by pynmea2; what is done here is to
decide which to believe.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from datetime import UTC, datetime, time
from functools import lru_cache, reduce
from itertools import chain, islice
from math import isnan, nan
from operator import xor
from typing import Any, Final, Literal

from seacruise.units import MS_PER_KNOT
from seacruise.yacht.logs.gather import Gatherer
from seacruise.yacht.logs.log import Log, Tally

Checksum = Literal["auto", "strict", "accept", "ignore"]

CHECKSUMS: Final[tuple[Checksum, ...]] = ("auto", "strict", "accept", "ignore")
"""``strict`` wants a right checksum, ``accept`` takes sentences without one too, ``ignore`` looks at none;
``auto`` is ``accept``, but ``ignore`` where most sound sentences carry a wrong one."""

_SAMPLE: Final = 4000
_WHOLE = re.compile(rb"\$[A-Z]{5},[^$*!]*\*[0-9A-F]{2}\s*")
_MS: Final = {"N": MS_PER_KNOT, "K": 1.0 / 3.6, "M": 1.0, "S": 0.44704}
_TOP_SPEED: Final = 120.0
_DAY: Final = 86_400.0


class _FaultError(ValueError):
    """A value that cannot be."""


class _State:
    """What later sentences need of earlier ones: the date, the variation, the fix that is valid."""

    def __init__(self, gatherer: Gatherer, variation: float) -> None:
        # pynmea2 is loaded by whoever reads a log, not by every plan.
        import pynmea2

        # Its sentences, made of their fields: its own parser would look for kind and checksum once more.
        self.kinds: dict[bytes, Callable[[str, str, list[str]], Any]] = {
            kind: getattr(pynmea2, kind.decode()) for kind in _READERS
        }
        self.rows = gatherer
        self.day: float = nan
        self.variation = variation
        self.told_variation = False

    def clock(self, moment: time, day: float | None) -> bool:
        """Go on to a time of day; without a date the day is the one that is nearest to the last time."""
        seconds = moment.hour * 3600.0 + moment.minute * 60.0 + moment.second + moment.microsecond * 1e-6
        if day is not None:
            self.day = day
        if isnan(self.day):
            return False
        at = self.day + seconds
        if day is None and abs(at - self.rows.time) > _DAY / 2:
            at += _DAY if at < self.rows.time else -_DAY
        self.rows.at(at)
        return True

    def magnetic(self, heading: float) -> None:
        """Note a magnetic heading, made true where the variation is known."""
        known = not isnan(self.variation)
        self.rows.put("heading", (heading + self.variation) % 360.0 if known else heading)


def read_nmea(
    lines: Iterable[bytes], tally: Tally, *, checksum: Checksum = "auto", variation_deg: float = nan
) -> Iterator[Log]:
    """Read NMEA 0183 in blocks; memory does not grow with the log.

    Parameters
    ----------
    lines
        Lines as they were logged; text before the ``$`` (a time stamp, a tag) is passed over, and of
        several sentences in a line each is tried.
    tally
        Is counted up on the way.
    checksum
        What to believe, see `CHECKSUMS`.
    variation_deg
        Magnetic variation [degrees, positive to the east] where the log tells none.

    Yields
    ------
    Log
        A row for each time that the log's clock shows.
    """
    source = iter(lines)
    begin = list(islice(source, _SAMPLE))
    policy = judged_checksum(begin) if checksum == "auto" else checksum
    if checksum == "auto" and policy == "ignore":
        tally.notes.append("Most sound sentences carry a wrong checksum, so checksums were not looked at.")
    state = _State(Gatherer(), variation_deg)
    for line in chain(begin, source):
        for sentence in line.split(b"$")[1:]:
            _take(sentence, policy, state, tally)
        if block := state.rows.full():
            yield block
    if block := state.rows.rest():
        yield block
    if not state.told_variation and isnan(variation_deg):
        tally.notes.append("The log tells no magnetic variation.")


def judged_checksum(lines: Iterable[bytes]) -> Checksum:
    """Decide by some lines whether the log's checksums mean anything."""
    whole = [match.group() for line in lines for match in _WHOLE.finditer(line)]
    right = sum(_is_right(sentence[1:]) is True for sentence in whole)
    return "ignore" if 2 * right < len(whole) else "accept"


def _is_right(sentence: bytes) -> bool | None:
    """Tell whether the checksum fits the text before it; ``None`` where there is none."""
    star = sentence.rfind(b"*")
    if star < 0:
        return None
    try:
        return int(sentence[star + 1 : star + 3], 16) == reduce(xor, sentence[:star], 0)
    except ValueError:
        return False


def _take(sentence: bytes, policy: Checksum, state: _State, tally: Tally) -> None:
    kind = sentence[2:5]
    reader = _READERS.get(kind)
    if reader is None or sentence[5:6] != b",":
        tally.skipped["of other kinds"] += 1
        return
    if policy != "ignore":
        right = _is_right(sentence)
        if right is False:
            tally.skipped["with a wrong checksum"] += 1
            return
        if right is None and policy == "strict":
            tally.skipped["without a checksum"] += 1
            return
    body = sentence.partition(b"*")[0].rstrip()
    try:
        fields = body[6:].decode("ascii").split(",")
        message = state.kinds[kind](body[:2].decode("ascii"), kind.decode("ascii"), fields)
        counted = reader(message, state)
    except (ValueError, TypeError, AttributeError, ArithmeticError, IndexError):
        tally.skipped["garbled"] += 1
        return
    if counted:
        tally.used += 1
    else:
        tally.skipped["without a valid figure"] += 1


# --- values --------------------------------------------------------------------------------------------


def _number(value: Any, low: float, high: float) -> float:
    """Give a field as a number, NaN where it is empty.

    Raises
    ------
    _FaultError
        It is out of bounds, so digits are lost.
    """
    if value is None or value == "":
        return nan
    number = float(value)
    if not low <= number <= high:
        raise _FaultError
    return number


def _angle(value: Any) -> float:
    return _number(value, 0.0, 360.0)


def _speed(value: Any, unit: str) -> float:
    return _number(value, 0.0, _TOP_SPEED / _MS[unit]) * _MS[unit]


def _needs(message: Any, count: int) -> None:
    """Refuse a sentence whose end is missing."""
    if len(message.data) < count:
        raise _FaultError


def _position(message: Any, state: _State) -> None:
    # Receivers send the same fix in several sentences, and reading it takes longest of all.
    if state.rows.knows("lat") or not message.lat or not message.lon:
        return
    lat, lon = _number(message.latitude, -90.0, 90.0), _number(message.longitude, -180.0, 180.0)
    state.rows.put("lat", lat)
    state.rows.put("lon", lon)


# --- sentences -----------------------------------------------------------------------------------------


def _rmc(message: Any, state: _State) -> bool:
    _needs(message, 9)
    moment = message.timestamp
    if message.status != "A" or not message.data[8] or not moment:
        return False
    speed, course = _speed(message.spd_over_grnd, "N"), _angle(message.true_course)
    state.clock(moment, _midnight(message.data[8]))
    _position(message, state)
    state.rows.put("sog", speed)
    state.rows.put("cog", course)
    if len(message.data) > 10:
        _variation(message.mag_variation, message.mag_var_dir, state)
    return True


@lru_cache(maxsize=8)
def _midnight(ddmmyy: str) -> float:
    """Begin of a day [s since 1970]; pynmea2 would read the date anew in every second of a log."""
    return datetime.strptime(ddmmyy, "%d%m%y").replace(tzinfo=UTC).timestamp()


def _variation(value: Any, side: str, state: _State) -> None:
    variation = _number(value, 0.0, 180.0)
    if not isnan(variation) and side in ("E", "W"):
        state.variation = variation if side == "E" else -variation
        state.told_variation = True


def _gll(message: Any, state: _State) -> bool:
    _needs(message, 5)
    if message.status == "V" or not message.timestamp or not state.clock(message.timestamp, None):
        return False
    _position(message, state)
    return True


def _gga(message: Any, state: _State) -> bool:
    _needs(message, 6)
    if not message.gps_qual or not message.timestamp or not state.clock(message.timestamp, None):
        return False
    _position(message, state)
    return True


def _zda(message: Any, state: _State) -> bool:
    _needs(message, 4)
    day = datetime(message.year, message.month, message.day, tzinfo=UTC).timestamp()
    return bool(message.timestamp) and state.clock(message.timestamp, day)


def _vtg(message: Any, state: _State) -> bool:
    _needs(message, 6)
    course, speed = _angle(message.true_track), _speed(message.spd_over_grnd_kts, "N")
    state.rows.put("cog", course)
    state.rows.put("sog", speed)
    return not isnan(speed)


def _vhw(message: Any, state: _State) -> bool:
    _needs(message, 6)
    true, magnetic = _angle(message.heading_true), _angle(message.heading_magnetic)
    speed = _speed(message.water_speed_knots, "N")
    if isnan(speed) and len(message.data) > 6:
        speed = _speed(message.water_speed_km, "K")
    state.rows.put("stw", speed)
    _heading(true, magnetic, state)
    return not isnan(speed)


def _heading(true: float, magnetic: float, state: _State) -> bool:
    if not isnan(true):
        state.rows.put("heading", true)
        return True
    if not isnan(magnetic):
        state.magnetic(magnetic)
        return True
    return False


def _hdg(message: Any, state: _State) -> bool:
    _needs(message, 5)
    heading = _angle(message.heading)
    _variation(message.variation, message.var_dir, state)
    deviation = _number(message.deviation, 0.0, 180.0)
    if not isnan(deviation) and message.dev_dir in ("E", "W"):
        heading += deviation if message.dev_dir == "E" else -deviation
    return _heading(nan, heading % 360.0, state)


def _hdt(message: Any, state: _State) -> bool:
    return _heading(_angle(message.heading), nan, state)


def _hdm(message: Any, state: _State) -> bool:
    return _heading(nan, _angle(message.heading), state)


def _mwv(message: Any, state: _State) -> bool:
    _needs(message, 5)
    if message.status != "A":
        return False
    angle, speed = _angle(message.wind_angle), _speed(message.wind_speed, message.wind_speed_units)
    names = {"R": ("awa", "aws"), "T": ("twa", "tws")}.get(message.reference)
    if names is None:
        raise _FaultError
    return _wind(names, angle, speed, state)


def _wind(names: tuple[str, str], angle: float, speed: float, state: _State) -> bool:
    # Half of a wind is none: a new speed must not be joined to an old angle.
    if isnan(angle) or isnan(speed):
        return False
    state.rows.put(names[0], angle if angle <= 180.0 else angle - 360.0)
    state.rows.put(names[1], speed)
    return True


def _vwr(message: Any, state: _State) -> bool:
    _needs(message, 4)
    if message.l_r not in ("L", "R"):
        raise _FaultError
    angle = _number(message.deg_r, 0.0, 180.0)
    speed = _speed(message.wind_speed_kn, "N")
    if isnan(speed) and len(message.data) > 5:
        speed = _speed(message.wind_speed_ms, "M")
    return _wind(("awa", "aws"), angle if message.l_r == "R" else (360.0 - angle) % 360.0, speed, state)


def _rpm(message: Any, state: _State) -> bool:
    _needs(message, 3)
    if message.source != "E" or (len(message.data) > 4 and message.status == "V"):
        return False
    revolutions = abs(_number(message.speed, -20_000.0, 20_000.0))
    state.rows.put("rpm", revolutions)
    return not isnan(revolutions)


_READERS: Final[dict[bytes, Callable[[Any, _State], bool]]] = {
    b"RMC": _rmc,
    b"GLL": _gll,
    b"GGA": _gga,
    b"ZDA": _zda,
    b"VTG": _vtg,
    b"VHW": _vhw,
    b"HDG": _hdg,
    b"HDT": _hdt,
    b"HDM": _hdm,
    b"MWV": _mwv,
    b"VWR": _vwr,
    b"RPM": _rpm,
}
