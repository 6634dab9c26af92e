"""Where a lattice is refined for the ports of a passage, and the lattices that were used last."""

from __future__ import annotations

import math
import threading
from collections import OrderedDict
from collections.abc import Callable, Sequence
from typing import Any, Final, NamedTuple
from weakref import WeakSet

from seacruise.geodesy import great_circle_m
from seacruise.routing import lattice
from seacruise.routing.area import Levels
from seacruise.routing.graft import with_ends
from seacruise.routing.lattice import Lattice
from seacruise.sea import Sea
from seacruise.units import METRES_PER_NM

Position = tuple[float, float]

SHORE_NM: Final = 2.5
APPROACH_NM: Final = 0.15
"""Spacings of the first search near the shore and where the ends lie among islands [nm]."""

OPEN_WATER_NM: Final = 3.5
"""Room on all sides [nm] with which the approach of a port is over; bays among islands have less."""

KEPT: Final = 8
"""Lattices that are kept."""

KEPT_AT_REST_BYTES: Final = 16_000_000
"""So much of them while nothing is searched: usual ones have 4 MB, those of a bay without a wide way out,
which is looked at ever more finely, forty."""

_CACHES: Final[WeakSet[LatticeCache]] = WeakSet()

FAR_M: Final = 20 * METRES_PER_NM
"""Ends that were moved farther than this need a lattice of their own [m]."""


def levels_around(
    sea: Sea, ports: Sequence[Position], spacing_nm: float, detail: int, *, per_nm: float
) -> Levels:
    """Levels that lead from ports to open water, as far as islands and narrows reach.

    Parameters
    ----------
    detail
        0 at first; each one more halves the spacing near the shore and doubles the room around the ways
        out, for ends that were not connected.
    per_nm
        Metres of the plane per nautical mile.
    """
    everywhere = max(0, math.ceil(math.log2(spacing_nm / SHORE_NM))) + detail
    approaches = max(0, math.ceil(math.log2(spacing_nm / APPROACH_NM)) - everywhere + detail)
    ways = tuple(sea.ways_out(*port, room_m=OPEN_WATER_NM * per_nm) for port in ports)
    return Levels(everywhere, approaches, ways, sides=3.0 * 2**detail)


class Recipe(NamedTuple):
    """What defines a lattice, besides its sea and its ends."""

    spacing_nm: float
    directions: int
    kind: str
    reach_m: float
    detail: int
    mesh: str
    safety: Any
    hazards: int | None

    def is_like(self, other: Recipe) -> bool:
        """Tell whether two differ in their size only."""
        alike = self[5:] == other[5:] and (self.directions, self.kind) == (other.directions, other.kind)
        return alike and 2 / 3 < self.spacing_nm / other.spacing_nm < 3 / 2


class LatticeCache:
    """The lattices used last, by what defines them: the same ports again need no new one."""

    def __init__(self) -> None:
        # The cells are kept as well: while they are, no other sea can have their identity.
        self._lock = threading.Lock()
        self._kept: OrderedDict[Any, tuple[Lattice, Any]] = OrderedDict()
        _CACHES.add(self)

    def get(
        self,
        key: Recipe,
        sea: Sea,
        ends: tuple[Position, Position],
        recipe: Callable[[], dict[str, Any]],
    ) -> Lattice:
        """Return the lattice of a recipe (see `lattice.build`); ``key`` must tell it from all others."""
        whole = (id(sea.water.cells), ends, key)
        with self._lock:
            found = self._kept.get(whole)
        # Not while the lock is held: two lattices may well be built at once.
        found = found or (lattice.build(sea, *ends, **recipe()), sea.water.cells)
        with self._lock:
            self._kept[whole] = found
            self._kept.move_to_end(whole)
            while len(self._kept) > KEPT:
                self._kept.popitem(last=False)
        return found[0]

    def let_go(self) -> None:
        """Forget the lattices used longest ago, where all of them take much memory."""
        with self._lock:
            while sum(kept.nbytes for kept, _ in self._kept.values()) > KEPT_AT_REST_BYTES:
                self._kept.popitem(last=False)

    def moved(self, key: Recipe, sea: Sea, ends: tuple[Position, Position]) -> Lattice | None:
        """Give a lattice like the one of a recipe, kept for ends that are not far, with these ends.

        ``None`` where there is none, or where an end lies too narrowly for it.
        """

        def away(kept: tuple[int, tuple[Position, Position], Recipe]) -> float:
            return max(float(great_circle_m(*a, *b)) for a, b in zip(ends, kept[1], strict=True))

        with self._lock:
            like = [
                (away(whole), -whole[2].reach_m, lattice)
                for whole, (lattice, _) in self._kept.items()
                if whole[0] == id(sea.water.cells) and whole[2].is_like(key)
            ]
        if not like:
            return None
        distance, _, found = min(like, key=lambda one: one[:2])
        return with_ends(found, sea, *ends) if distance < FAR_M else None


def let_go() -> None:
    """Let all caches forget what takes much memory and was not used last: for when nothing is searched."""
    for cache in tuple(_CACHES):
        cache.let_go()
