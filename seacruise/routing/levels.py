"""Where a lattice is refined for the ports of a passage, and the lattices that were used last."""

from __future__ import annotations

import math
import threading
from collections import OrderedDict
from collections.abc import Callable, Sequence
from typing import Any, Final

from seacruise.routing import lattice
from seacruise.routing.area import Levels
from seacruise.routing.lattice import Lattice
from seacruise.sea import Sea

Position = tuple[float, float]

SHORE_NM: Final = 2.5
APPROACH_NM: Final = 0.15
"""Spacings of the first search near the shore and where the ends lie among islands [nm]."""

OPEN_WATER_NM: Final = 3.5
"""Room on all sides [nm] with which the approach of a port is over; bays among islands have less."""

KEPT: Final = 8
"""Lattices that are kept."""


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


class LatticeCache:
    """The lattices used last, by what defines them: the same ports again need no new one."""

    def __init__(self) -> None:
        # The cells are kept as well: while they are, no other sea can have their identity.
        self._lock = threading.Lock()
        self._kept: OrderedDict[Any, tuple[Lattice, Any]] = OrderedDict()

    def get(
        self,
        key: tuple[Any, ...],
        sea: Sea,
        ends: tuple[Position, Position],
        recipe: Callable[[], dict[str, Any]],
    ) -> Lattice:
        """Return the lattice of a recipe (see `lattice.build`); ``key`` must tell it from all others."""
        whole = (id(sea.water.cells), ends, *key)
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
