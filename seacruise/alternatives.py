"""Other ways: the best passage on the other side of each big island, to be weighed against the fastest.

Two ways are of different kinds when one cannot be pulled into the other without crossing an island. So each
island on the way gets a barrier on the side where the fastest passage leaves it: a ray from its interior
outwards, across all water. Whoever does not cross it passes on the other side (Bhattacharya et al. 2012,
doi:10.1007/s10514-012-9304-1). The barrier is a zone like any other, and the passage that keeps out of it is
planned, refined and sailed again as every passage is.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import CancelledError, NoPassageError
from seacruise.geodesy import from_mercator, great_circle_m, to_mercator
from seacruise.model import Passage, Track
from seacruise.progress import Job
from seacruise.sea.zones import Zone

Array = NDArray[np.float64]
Side = Literal["north", "east", "south", "west"]
SIDES: Final[tuple[Side, ...]] = ("north", "east", "south", "west")

DETOUR: Final = 1.5
"""An island is on the way when by way of it the ends are no farther apart than this, to the direct line."""

SLOWEST: Final = 1.25
"""A way that takes longer than this, to the fastest, is nobody's choice."""

MOST_WAYS: Final = 5
MOST_ISLANDS: Final = 8

_BARRIER_M: Final = 300.0
"""Width of a barrier [m of the Mercator plane]."""

_BEYOND_M: Final = 600_000.0
"""How far a barrier reaches beyond four times the direct line [m of the Mercator plane]."""


@dataclass(frozen=True, slots=True)
class Island:
    """An island by a point well inside it [degrees]."""

    name: str
    lat: float
    lon: float


ISLANDS: Final = (
    Island("Gotland", 57.40, 18.50),
    Island("Öland", 56.70, 16.65),
    Island("Bornholm", 55.13, 14.92),
    Island("Sjælland", 55.50, 11.90),
    Island("Fyn", 55.35, 10.40),
    Island("Rügen", 54.45, 13.40),
    Island("Saaremaa", 58.40, 22.50),
    Island("Hiiumaa", 58.88, 22.60),
    Island("Åland", 60.22, 20.00),
    Island("Lolland", 54.77, 11.40),
    Island("Falster", 54.80, 11.95),
    Island("Langeland", 54.959, 10.795),
    Island("Fehmarn", 54.45, 11.15),
    Island("Møn", 54.976, 12.434),
    Island("Als", 54.98, 9.90),
    Island("Samsø", 55.85, 10.60),
    Island("Læsø", 57.27, 11.05),
    Island("Fårö", 57.93, 19.12),
    Island("Hailuoto", 65.02, 24.72),
)
"""Islands of the Baltic that are weighed, the larger before the smaller."""


@dataclass(frozen=True, slots=True, eq=False)
class OtherWay:
    """A passage that leaves an island on the other side.

    Attributes
    ----------
    side
        Of the island, on which this one passes.
    lat, lon
        Where it is abeam of the island [degrees]: by way of there the sailor gets it.
    """

    passage: Passage
    island: str
    side: Side
    lat: float
    lon: float


@dataclass(frozen=True, slots=True)
class Passing:
    """Those of some passages that leave an island on one side.

    Attributes
    ----------
    count
        How many.
    lat, lon
        Where the middle one of them is abeam of the island [degrees].
    """

    side: Side
    count: int
    lat: float
    lon: float


@dataclass(frozen=True, slots=True)
class Split:
    """An island that some passages leave on another side than a planned one.

    Attributes
    ----------
    planned
        Side on which the planned one leaves it.
    passing
        One entry a side, the side of most passages first.
    """

    island: str
    planned: Side
    passing: tuple[Passing, ...]


@dataclass(frozen=True, slots=True, eq=False)
class _Ray:
    """Half a line of the Mercator plane, from an island's interior across the direct line."""

    x: float
    y: float
    dx: float
    dy: float
    length: float

    def turned(self) -> _Ray:
        return _Ray(self.x, self.y, -self.dx, -self.dy, self.length)

    @property
    def side(self) -> Side:
        """Point of the compass it leads to."""
        return SIDES[round(math.degrees(math.atan2(self.dx, self.dy)) / 90.0) % 4]

    def crossed(self, x: Array, y: Array) -> Array:
        """Distances from the interior [m] at which a line ``(n,)`` crosses the ray."""
        along = (x - self.x) * self.dx + (y - self.y) * self.dy
        across = (x - self.x) * self.dy - (y - self.y) * self.dx
        hits = np.flatnonzero((across[:-1] < 0.0) != (across[1:] < 0.0))
        share = across[hits] / (across[hits] - across[hits + 1])
        at = along[hits] + share * (along[hits + 1] - along[hits])
        return np.asarray(at[(at > 0.0) & (at < self.length)])

    def barrier(self, name: str) -> Zone:
        """Make a zone of it that nothing passes."""
        half = _BARRIER_M / 2.0
        ends = np.array([0.0, 0.0, self.length, self.length, 0.0])
        sides = np.array([-half, half, half, -half, -half])
        lat, lon = from_mercator(
            self.x + ends * self.dx + sides * self.dy, self.y + ends * self.dy - sides * self.dx
        )
        return Zone(name, (np.stack([lon, lat], axis=1),))


def other_ways(
    passage: Passage,
    sail: Callable[[Zone], Passage],
    *,
    job: Job,
    islands: Sequence[Island] = ISLANDS,
) -> tuple[OtherWay, ...]:
    """Find the ways on the other side of the islands that lie between the ends of a passage.

    Parameters
    ----------
    passage
        The fastest one.
    sail
        Plans the same passage with one more zone to keep out of; a `NoPassageError` says that the other side
        leads nowhere.
    islands
        Those that are weighed; of more than `MOST_ISLANDS` on the way the first.

    Returns
    -------
    tuple of OtherWay
        The faster before the slower, no two of them past all islands on the same sides.

    Raises
    ------
    CancelledError
        The job was cancelled.
    """
    weighed = [(island, ray) for island in islands if (ray := _ray(island, passage)) is not None]
    weighed = weighed[:MOST_ISLANDS]
    known = {_sides(passage.track, weighed)}
    found = []
    for number, (island, ray) in enumerate(weighed):
        job.check()
        job.report("search", number / len(weighed), f"Looking at the other side of {island.name}")
        here = ray if ray.crossed(*_line(passage.track)).size % 2 else ray.turned()
        try:
            other = sail(here.barrier(island.name))
        except CancelledError:
            raise
        except NoPassageError:
            continue
        kind = _sides(other.track, weighed)
        abeam = here.turned().crossed(*_line(other.track))
        if kind in known or not abeam.size or other.duration_h > SLOWEST * passage.duration_h:
            continue
        known.add(kind)
        near = float(abeam.min())
        lat, lon = from_mercator(here.x - near * here.dx, here.y - near * here.dy)
        found.append(OtherWay(other, island.name, here.turned().side, float(lat), float(lon)))
    found.sort(key=lambda way: way.passage.duration_h)
    return tuple(found[:MOST_WAYS])


def splits(
    planned: Passage, others: Sequence[Track], *, islands: Sequence[Island] = ISLANDS
) -> tuple[Split, ...]:
    """Find the islands that other passages between the same ends leave on another side.

    Islands beside each other part passages alike: of these the first one is told.

    Parameters
    ----------
    others
        Tracks; one that passes an island on neither side, or on both, is not counted there.
    islands
        As for `other_ways`.
    """
    weighed = [(island, ray) for island in islands if (ray := _ray(island, planned)) is not None]
    lines = [_line(track) for track in others]
    found: list[Split] = []
    known: set[tuple[float | None, ...]] = set()
    for island, ray in weighed[:MOST_ISLANDS]:
        here = ray if ray.crossed(*_line(planned.track)).size % 2 else ray.turned()
        abeam = [_abeam(here, line) for line in lines]
        kind = tuple(None if at is None else math.copysign(1.0, at) for at in abeam)
        if -1.0 not in kind or kind in known:
            continue
        known.add(kind)
        passing = [
            _passing(here if side > 0.0 else here.turned(), sorted(abs(at) for at in ats))
            for side in (1.0, -1.0)
            if (ats := [at for at in abeam if at is not None and at * side > 0.0])
        ]
        passing.sort(key=lambda one: -one.count)
        found.append(Split(island.name, here.side, tuple(passing)))
    return tuple(found)


def _abeam(ray: _Ray, line: tuple[Array, Array]) -> float | None:
    """Distance [m] at which a line passes on the side of a ray, negative on the opposite one."""
    one, other = ray.crossed(*line), ray.turned().crossed(*line)
    if one.size % 2 == other.size % 2:
        return None
    return float(one.min()) if one.size % 2 else -float(other.min())


def _passing(ray: _Ray, distances: Sequence[float]) -> Passing:
    middle = distances[len(distances) // 2]
    lat, lon = from_mercator(ray.x + middle * ray.dx, ray.y + middle * ray.dy)
    return Passing(ray.side, len(distances), float(lat), float(lon))


def _line(track: Track) -> tuple[Array, Array]:
    return to_mercator(track.lat, track.lon)


def _ray(island: Island, passage: Passage) -> _Ray | None:
    """Ray across the direct line from an island that a passage leaves on one side of it."""
    start, end = passage.start, passage.end
    direct = float(great_circle_m(start.lat, start.lon, end.lat, end.lon))
    by_way = sum(float(great_circle_m(island.lat, island.lon, e.lat, e.lon)) for e in (start, end))
    if by_way > DETOUR * direct:
        return None
    x, y = to_mercator(np.array([start.lat, end.lat, island.lat]), np.array([start.lon, end.lon, island.lon]))
    along = math.hypot(x[1] - x[0], y[1] - y[0])
    dx, dy = float(x[1] - x[0]) / along, float(y[1] - y[0]) / along
    ray = _Ray(float(x[2]), float(y[2]), dy, -dx, 4.0 * along + _BEYOND_M)
    line = _line(passage.track)
    # An island beside an end is passed on neither side, or on both.
    one, other = (r.crossed(*line).size % 2 for r in (ray, ray.turned()))
    return ray if one != other else None


def _sides(track: Track, weighed: Sequence[tuple[Island, _Ray]]) -> tuple[bool, ...]:
    """Tell on which side of each island a track passes."""
    x, y = _line(track)
    return tuple(bool(ray.crossed(x, y).size % 2) for _, ray in weighed)
