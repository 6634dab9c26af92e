"""Why there is no passage: the obstacles are taken away one by one, until there is one."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from seacruise.errors import NoPassageError
from seacruise.routing.field import COARSE_SLICE_S, NO_LIMITS, Handling, speed_table
from seacruise.routing.lattice import Lattice
from seacruise.routing.search import connected, search
from seacruise.sea.zones import NO_ZONES, Zones
from seacruise.units import MS_PER_KNOT

if TYPE_CHECKING:
    from seacruise.routing.find import Question


def why_not(asked: Question, grid: Lattice) -> NoPassageError:
    """Find out why nothing was found on a lattice."""
    if not connected(grid) and asked.clearance_nm is not None:
        return NoPassageError(
            f"There is no way by water that keeps {asked.clearance_nm:g} nm off every shore; allow less "
            "clearance (--shore-clearance) or choose other ports.",
            reason="no-water-path",
        )
    if not connected(grid):
        return NoPassageError(
            "There is no way by water between the two ports in the area searched; choose other ports, or "
            "check that both lie on the same sea.",
            reason="no-water-path",
        )

    def passable(handling: Handling, zones: Zones) -> bool:
        field = replace(asked, how=replace(asked.how, handling=handling)).winds(COARSE_SLICE_S)
        found = search(grid, field, speed_table(asked.polar, handling), asked.departure, zones=zones)
        return bool(np.isfinite(found.arrival[grid.end]))

    handling = asked.how.handling
    if asked.zones and passable(handling, NO_ZONES):
        return NoPassageError(
            "Every way leads through a zone that is closed to you; take the zone out of the layers, or leave "
            "when it is open.",
            reason="closed-zone",
        )
    if handling.max_wind is not None and passable(replace(handling, max_wind=None), asked.zones):
        return NoPassageError(
            f"Every way leads through more wind than the {handling.max_wind / MS_PER_KNOT:.0f} kn you allow; "
            "leave at another time or raise the limit.",
            reason="wind-limit",
        )
    if handling.limits != NO_LIMITS and passable(replace(handling, limits=NO_LIMITS), asked.zones):
        return NoPassageError(
            "Every way leads through higher waves or stronger gusts than you allow; leave at another time or "
            "raise the limit.",
            reason="wind-limit",
        )
    if not handling.tacking and passable(replace(handling, tacking=True), asked.zones):
        return NoPassageError(
            "Every way leads at some time through the yacht's dead angle, and tacking is not allowed; allow "
            "it (the precise preset does) or leave at another time.",
            reason="dead-angle",
        )
    return NoPassageError(
        "The yacht is becalmed: with this wind she never arrives. Leave at another time, choose another "
        "forecast, or allow the engine (--motor-below).",
        reason="becalmed",
    )
