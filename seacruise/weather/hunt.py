"""A plan of places while its answers come in: which are there, which to ask next, whether they will do."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final

import numpy as np
from numpy.typing import NDArray

from seacruise.errors import WeatherError
from seacruise.weather.adaptive import next_places
from seacruise.weather.cache import CachedAnswer, Found, place_id
from seacruise.weather.ground import Ground
from seacruise.weather.mosaic import common_hours, winds_at

END_NEAR_DEG: Final = 0.5
"""How far from start and end the nearest answer may be [degrees of latitude]."""

ROUGHLY_NM: Final = 90.0
"""How far from a passage answers asked for another one may be, where no others are to be had [nm]."""

_SLACK_DEG: Final = 0.25

Array = NDArray[np.float64]


@dataclass(slots=True, eq=False)
class Hunt:
    """The places of one passage.

    The plan depends on the answers alone. So a second plan of the same passage wants the same places, and
    finds them in the cache.

    Attributes
    ----------
    kept, read
        What the cache has on the ground, by the name of the place, and how it is read.
    now, needed
        Time, and the time that an answer must reach to be of use [s since 1970].
    fresh_s
        Age up to which an answer without a date of expiry is as good as new [s].
    aim
        Places of the plan at most.
    left
        Requests that may still be sent.
    at_once
        Places to ask at a time at most, after the first ones.
    enough
        Share of the places asked that must have an answer.
    answers, failed
        Places by their index on the ground: those with a good answer, and those asked in vain.
    is_short
        The plan ended for want of requests.
    """

    ground: Ground
    kept: Mapping[str, Found]
    read: Callable[[Sequence[Found]], Mapping[int, CachedAnswer]]
    now: float
    needed: float
    fresh_s: float
    aim: int
    left: int
    at_once: int
    enough: float
    answers: dict[int, CachedAnswer] = field(default_factory=dict)
    failed: set[int] = field(default_factory=set)
    is_short: bool = False
    _planned: list[int] = field(default_factory=list)

    def wanted(self) -> tuple[int, ...]:
        """List the places to ask now; what the cache has is taken on the way. Nothing when the plan ends."""
        while True:
            missing = [one for one in self._planned if one not in self.answers and one not in self.failed]
            if missing:
                self.is_short = len(missing) > self.left
                return tuple(missing[: self.left])
            more = self._more()
            if not more:
                return ()
            self._planned += more
            names = {one: place_id(*map(float, self.ground.places[one])) for one in more}
            fresh = {one: self.kept[name] for one, name in names.items() if name in self.kept}
            fresh = {one: found for one, found in fresh.items() if self.is_fresh(found)}
            answers = self.read(tuple(fresh.values())) if fresh else {}
            for one, found in fresh.items():
                # in place of a damaged answer there may be one of an earlier run
                if found.number in answers and self.is_fresh(answers[found.number]):
                    self.answers[one] = answers[found.number]

    def _more(self) -> tuple[int, ...]:
        if not self._planned:
            return self.ground.first
        still = self.aim - len(self._planned)
        if still <= 0 or not self.answers:
            return ()
        # each answer makes the next choice better, and each round of requests takes its time
        most = min(self.at_once, math.ceil(still / 2))
        answered = sorted(self.answers)
        points = [self.answers[one].answer for one in answered]
        try:
            wind = winds_at(points, common_hours(points))
        except WeatherError:
            return ()
        return next_places(self.ground, answered, wind, most, frozenset(self.failed))

    def at_most(self) -> int:
        """Count the requests that the plan may still need, if all of them are to be had."""
        return max(self.aim - len(self.answers) - len(self.failed), 0)

    def is_fresh(self, cached: CachedAnswer | Found) -> bool:
        """Tell whether an answer is as good as a new one."""
        expires = cached.fetched + self.fresh_s if cached.expires is None else cached.expires
        # an answer from the future is a clock that was set back
        return self.now < expires

    def tried(self) -> list[int]:
        """List the places that were asked or found in the cache; before that, the first ones."""
        return [*self.answers, *self.failed] or list(self.ground.first)

    def others(self) -> list[CachedAnswer]:
        """Read what the cache has besides the answers, as far as it reaches the time needed."""
        taken = {place_id(one.answer.lat, one.answer.lon) for one in self.answers.values()}
        rest = [found for place, found in self.kept.items() if place not in taken]
        # how far an answer of an earlier version reaches is only known when it is read
        return [one for one in self.read(rest).values() if one.answer.time[-1] >= self.needed]

    def answered(self) -> list[tuple[float, float]]:
        """List latitude and longitude of the answers [degrees]."""
        return [(one.answer.lat, one.answer.lon) for one in self.answers.values()]

    def suffices(self, answered: Sequence[tuple[float, float]]) -> bool:
        """Tell whether answers cover the passage: start, end, and enough of the way between.

        Of the places asked, a share of `enough` must have an answer; the passage's ends must be near one;
        and no stretch of the way may be without, as it is where two neighbours failed.
        """
        places = np.array(answered).reshape(-1, 2)
        tried = self.tried()
        if len(places) < max(1, math.ceil(self.enough * len(tried))):
            return False
        ground = self.ground
        if not ground.ends:
            return True
        away = ground.distances(ground.places[list(ground.ends)], places).min(axis=1)
        planned = self._gap(ground.places[tried])
        return bool(away.max() <= END_NEAR_DEG and self._gap(places) <= 2.0 * planned + _SLACK_DEG)

    def gap_nm(self, answered: Sequence[tuple[float, float]]) -> float:
        """Measure how far from the nearest answer the passage leads, its ends included [nm]."""
        return self._gap(np.array(answered).reshape(-1, 2)) * 60.0

    def _gap(self, places: Array) -> float:
        if not len(places):
            return math.inf
        return float(self.ground.distances(self.ground.way, places).min(axis=1).max())
