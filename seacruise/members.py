"""What the members of an ensemble make of a passage: how long it takes in each, and which way each goes.

Two questions. How long is the fastest passage in each member's wind: what the weather allows. And how long
is the planned line in each: the skipper decides before she knows which of them comes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

from seacruise.along import sail_along, waypoints_of
from seacruise.alternatives import Split, splits
from seacruise.between import sea_between
from seacruise.study import Spread, spread_of
from seacruise.units import SECONDS_PER_HOUR
from seacruise.weather.beyond import extend

if TYPE_CHECKING:
    from seacruise.model import Passage, PassageRequest
    from seacruise.settings import Settings
    from seacruise.weather.beyond import Beyond
    from seacruise.weather.wind import Wind


@dataclass(frozen=True, slots=True, eq=False)
class Member:
    """A member of an ensemble, and what it makes of a passage.

    Attributes
    ----------
    number
        In the forecast, from 0.
    passage
        The fastest one in its wind; ``None`` where there is none.
    kept_h
        Hours she needs in its wind along the planned line; ``None`` where she does not arrive like that.
    """

    number: int
    passage: Passage | None
    kept_h: float | None


@dataclass(frozen=True, eq=False)
class Bundle:
    """A planned passage, and those of the members as far as they are known.

    Attributes
    ----------
    total
        How many members the forecast has.
    members
        Those that are known, by number.
    """

    planned: Passage
    total: int
    members: tuple[Member, ...]

    @property
    def is_complete(self) -> bool:
        """Whether all members are known."""
        return len(self.members) == self.total

    @cached_property
    def passages(self) -> tuple[Passage, ...]:
        """Passages of the members that have one."""
        return tuple(member.passage for member in self.members if member.passage is not None)

    @cached_property
    def duration_h(self) -> Spread:
        """Quantiles of the fastest passages [h]; a member without one counts as never arriving."""
        return spread_of([None if m.passage is None else m.passage.duration_h for m in self.members])

    @cached_property
    def kept_h(self) -> Spread:
        """Quantiles of the planned line [h]; a member in which she gets stuck counts as never arriving."""
        return spread_of([member.kept_h for member in self.members])

    @cached_property
    def splits(self) -> tuple[Split, ...]:
        """Islands that some members leave on another side than planned."""
        return splits(self.planned, [passage.track for passage in self.passages])


def winds_of(wind: Wind, beyond: Beyond) -> tuple[Wind, ...]:
    """Give the winds of the members, to be sailed one by one; none for a wind that has no members.

    They fade to their common mean, so this is done before they go their own ways. The current is the one of
    the whole forecast.
    """
    extended = extend(wind, beyond)
    return tuple(replace(member, current=wind.current) for member in extended.members)


def hours_along(request: PassageRequest, planned: Passage, *, settings: Settings) -> float | None:
    """Hours from the departure of a planned passage along its waypoints in the wind of a request.

    Returns
    -------
    float or None
        ``None`` where she does not arrive.
    """
    departure = planned.departure.timestamp()
    sea = sea_between(request.start, request.end, settings)
    sailed = sail_along(request, waypoints_of(planned), departure=departure, sea=sea)
    return (float(sailed.time[-1]) - departure) / SECONDS_PER_HOUR if sailed.arrived else None


def bundle_of(planned: Passage, total: int, members: Sequence[Member]) -> Bundle:
    """Put the members that are known together, in their order."""
    return Bundle(planned, total, tuple(sorted(members, key=lambda member: member.number)))
