"""Headlands, lights, islands and ports that she goes by: how near, on which side, and whether rounded."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Literal

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import great_circle_m, rhumb_course_deg
from seacruise.landmarks import Landmark, load_landmarks
from seacruise.ports import Port, load_ports
from seacruise.units import METRES_PER_NM

if TYPE_CHECKING:
    from seacruise.model import Passage

Array = NDArray[np.float64]

REACH_NM: Final = {1: 10.0, 2: 5.0}
"""How far off a landmark of a rank is told [nm]."""

PORT_REACH_NM: Final = 2.0
"""How far off a port is told [nm]."""

FREE_OF_ENDS_NM: Final = 3.0
"""What lies so near to either end is not passed but left, or reached [nm]."""

APART_NM: Final = 8.0
"""Way sailed between two places that are told; of those nearer together one is [nm]."""

ROUNDED_DEG: Final = 30.0
"""She rounds what she turns around by so much [degrees]."""


@dataclass(frozen=True, slots=True)
class Passed:
    """A place she goes by.

    Attributes
    ----------
    sample
        Of the track, where she is nearest.
    side
        On which side she leaves it.
    rounded
        Whether she turns around it there.
    """

    name: str
    sample: int
    distance_nm: float
    side: Literal["port", "starboard"]
    rounded: bool


def passed_places(
    passage: Passage,
    *,
    ports: Sequence[Port] | None = None,
    landmarks: Sequence[Landmark] | None = None,
) -> list[Passed]:
    """Find the places worth telling, in the order in which they are passed.

    Of places close together along the way it is the one that is nearest in proportion to how far it is told.
    """
    known = load_landmarks() if landmarks is None else landmarks
    places = [(mark.name, mark.lat, mark.lon, REACH_NM[mark.rank], True) for mark in known]
    names = {mark.name for mark in known}
    places += [
        (port.name, port.lat, port.lon, PORT_REACH_NM, False)
        for port in (load_ports() if ports is None else ports)
        if port.name not in names
    ]
    if not places:
        return []
    sailed = _sailed_nm(passage)
    found: list[tuple[float, Passed]] = []
    for name, lat, lon, reach, turning in _around(passage, places):
        nearest = _nearest(passage, lat, lon, reach)
        if nearest is None:
            continue
        sample, distance = nearest
        side = _side(passage, sample, lat, lon)
        rounded = turning and _rounds(passage, sailed, sample, distance, side)
        # A cape that she turns around is told before any that she only goes by.
        found.append((distance / reach - rounded, Passed(name, sample, distance, side, rounded)))
    chosen: list[Passed] = []
    for _, place in sorted(found, key=lambda item: item[0]):
        if all(abs(sailed[place.sample] - sailed[other.sample]) >= APART_NM for other in chosen):
            chosen.append(place)
    return sorted(chosen, key=lambda place: place.sample)


_Place = tuple[str, float, float, float, bool]


def _around(passage: Passage, places: list[_Place]) -> list[_Place]:
    """Leave out what lies outside the rectangle of the track, widened by its reach, and at either end."""
    track = passage.track
    lat, lon, reach = (np.array([place[k] for place in places], dtype=np.float64) for k in (1, 2, 3))
    high = reach / 60.0
    wide = high / np.cos(np.radians(np.minimum(np.abs(lat) + 1.0, 85.0)))
    near = (lat > track.lat.min() - high) & (lat < track.lat.max() + high)
    near &= (lon > track.lon.min() - wide) & (lon < track.lon.max() + wide)
    for end in (passage.start, passage.end):
        near &= great_circle_m(lat, lon, end.lat, end.lon) > FREE_OF_ENDS_NM * METRES_PER_NM
        near &= np.array([place[0] != end.name for place in places])
    return [place for place, is_near in zip(places, near.tolist(), strict=True) if is_near]


def _nearest(passage: Passage, lat: float, lon: float, reach_nm: float) -> tuple[int, float] | None:
    """Sample at which a place is nearest, and how far it is [nm]; ``None`` out of reach, and at the ends."""
    track = passage.track
    away = great_circle_m(track.lat, track.lon, lat, lon) / METRES_PER_NM
    sample = int(np.argmin(away))
    if not 0 < sample < away.size - 1 or away[sample] > reach_nm:
        return None
    return sample, float(away[sample])


def _side(passage: Passage, sample: int, lat: float, lon: float) -> Literal["port", "starboard"]:
    track = passage.track
    # Between two legs the course of neither would do: the way she comes and goes decides.
    before, after = max(sample - 1, 0), min(sample + 1, track.lat.size - 1)
    ends = ((track.lat[k], track.lon[k]) for k in (before, after))
    course = float(rhumb_course_deg(*next(ends), *next(ends)))
    bearing = float(rhumb_course_deg(track.lat[sample], track.lon[sample], lat, lon))
    return "starboard" if (bearing - course) % 360.0 < 180.0 else "port"


def _rounds(passage: Passage, sailed: Array, sample: int, distance_nm: float, side: str) -> bool:
    """Whether she turns towards a place while it is abeam."""
    way = max(3.0, 1.5 * distance_nm)
    before = int(np.searchsorted(sailed, sailed[sample] - way))
    after = min(int(np.searchsorted(sailed, sailed[sample] + way)), sailed.size - 1)
    course = passage.track.course_deg
    turned = (float(course[after]) - float(course[before]) + 180.0) % 360.0 - 180.0
    return turned >= ROUNDED_DEG if side == "starboard" else turned <= -ROUNDED_DEG


def _sailed_nm(passage: Passage) -> Array:
    """Way sailed until each sample [nm]."""
    track = passage.track
    steps = great_circle_m(track.lat[:-1], track.lon[:-1], track.lat[1:], track.lon[1:])
    return np.concatenate([[0.0], np.cumsum(steps)]) / METRES_PER_NM
