"""A passage by way of a place: planned to it, on from there, and joined."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from seacruise.passage import Checks, Passage, SearchReport, Track


def join(first: Passage, second: Passage, *, direct_distance_nm: float) -> Passage:
    """Join two passages, the second of which leaves where and when the first arrives.

    The place between stays a waypoint. No lower bound is told: the second search left when the first
    arrived, and says nothing about leaving earlier.
    """
    edges = tuple(p.lattice_edges for p in (first, second) if p.lattice_edges is not None)
    notices = dict.fromkeys((*first.notices, *second.notices))
    return replace(
        first,
        end=second.end,
        arrival=second.arrival,
        distance_nm=first.distance_nm + second.distance_nm,
        direct_distance_nm=direct_distance_nm,
        waypoints=(*first.waypoints[:-1], *second.waypoints),
        tacks=first.tacks + second.tacks,
        gybes=first.gybes + second.gybes,
        course_changes=first.course_changes + second.course_changes + 1,
        max_tws_kn=max(first.max_tws_kn, second.max_tws_kn),
        motor_h=first.motor_h + second.motor_h,
        fuel_l=first.fuel_l + second.fuel_l,
        beyond_forecast_h=first.beyond_forecast_h + second.beyond_forecast_h,
        manoeuvre_h=first.manoeuvre_h + second.manoeuvre_h,
        lower_bound_h=0.0,
        checks=_both(first.checks, second.checks),
        search=_sum(first.search, second.search),
        track=_chain(first.track, second.track, legs=len(first.waypoints) - 1),
        notices=tuple(notices),
        lattice_edges=_Edges(edges) if edges else None,
    )


@dataclass(frozen=True, slots=True)
class _Edges:
    """Edges of several lattices; the same where the lattices are."""

    parts: tuple[Callable[[], NDArray[np.float32]], ...]

    def __call__(self) -> NDArray[np.float32]:
        return np.concatenate([edges() for edges in self.parts])


def _both(a: Checks, b: Checks) -> Checks:
    return replace(
        a,
        resailed_h=a.resailed_h + b.resailed_h,
        land_free=a.land_free and b.land_free,
        zones_free=a.zones_free and b.zones_free,
        within_limits=a.within_limits and b.within_limits,
    )


def _sum(a: SearchReport, b: SearchReport) -> SearchReport:
    return replace(
        a,
        vertices=a.vertices + b.vertices,
        edges=a.edges + b.edges,
        settled=a.settled + b.settled,
        seconds={stage: a.seconds.get(stage, 0.0) + seconds for stage, seconds in b.seconds.items()},
    )


def _chain(a: Track, b: Track, *, legs: int) -> Track:
    """Put one track after another; legs of the second are counted on, and the shared sample is kept once."""
    columns = {f.name: np.concatenate([getattr(a, f.name)[:-1], getattr(b, f.name)]) for f in fields(a)}
    columns["leg"] = np.concatenate([a.leg[:-1], b.leg + legs])
    return replace(a, **columns)
