"""The log of a passage before it is sailed: what the navigator will write down, and when.

Everything is told as data, an `Entry` with a `Phrase`: a sentence in English with gaps, and what belongs into
them. The command line and the PDF write it in English (`seacruise.export.logform`); the window translates
the sentence and fills the gaps in the units that the sailor chose.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from itertools import pairwise
from typing import TYPE_CHECKING, Final, Literal

import numpy as np
from numpy.typing import NDArray

from seacruise.along import weather_along
from seacruise.model import Passage
from seacruise.passing import Passed, passed_places
from seacruise.phrases import HOW, POINT_LIMITS_DEG, SAID, TEMPLATES, Amount, Phrase, fill
from seacruise.sun import sun_events
from seacruise.units import SECONDS_PER_HOUR, beaufort

if TYPE_CHECKING:
    from seacruise.landmarks import Landmark
    from seacruise.ports import Port
    from seacruise.weather.wind import Wind

Array = NDArray[np.float64]

__all__ = ["TEMPLATES", "Amount", "Entry", "Kind", "Phrase", "tell"]

Kind = Literal[
    "waiting", "departure", "passing", "rounding", "tack", "gybe", "beat", "run", "point-of-sail", "wind-up",
    "wind-down", "strongest-wind", "waves", "current", "sunrise", "sunset", "engine-on", "engine-off",
    "forecast-ends", "arrival",
]  # fmt: skip

ASTERN_DEG: Final = 170.0
AHEAD_DEG: Final = 25.0
"""Nearer than this to the ends of the ship the wind has no side worth telling [degrees]."""

CALM_KN: Final = 1.0

POINT_HOLDS_S: Final = 1800.0
WIND_HOLDS_S: Final = 2700.0
ENGINE_HOLDS_S: Final = 900.0
"""Point of sail, force of the wind and engine are news when they last so long [s]."""

BOARDS_GAP_S: Final = 3 * 3600.0
FEWEST_BOARDS: Final = 3
"""So many tacks, none longer after another than this [s], are told as one beat."""

SAME_NEWS_S: Final = 1200.0
"""A change of the point of sail so near to a manoeuvre that tells it already is left out [s]."""

CLOSE_NM: Final = 0.15
"""Nearer than this a place has no side [nm]: she goes by way of it."""

LEAST_WAVES_M: Final = 1.0
LEAST_CURRENT_KN: Final = 0.3
"""Less is not worth a line."""


@dataclass(frozen=True, slots=True)
class Entry:
    """A line of the log.

    Attributes
    ----------
    time
        Timezone-aware UTC.
    lat, lon
        Where the yacht is then [degrees].
    """

    time: datetime
    lat: float
    lon: float
    kind: Kind
    phrase: Phrase


def tell(
    passage: Passage,
    *,
    wind: Wind | None = None,
    wanted: datetime | None = None,
    ports: Sequence[Port] | None = None,
    landmarks: Sequence[Landmark] | None = None,
) -> tuple[Entry, ...]:
    """Tell a passage as its log, in the order of time.

    Parameters
    ----------
    wind
        Where gusts and waves are read; without it, or where it has none, they are not told.
    wanted
        The departure that was asked for (timezone-aware); she waits from then on, if she leaves later.
    ports, landmarks
        What may be passed; those that come with the program when not given.
    """
    story = _Story(passage)
    boards = list(story.boards())
    entries = [
        *story.ends(wanted),
        *story.turns(boards),
        *story.engine(),
        *story.forecast(),
        *story.strongest(wind),
        *story.sun(),
        *(story.passed(place) for place in passed_places(passage, ports=ports, landmarks=landmarks)),
    ]
    entries += [e for e in story.forces() if not _is_near(e, entries, ("strongest-wind", "departure"))]
    manoeuvres = ("departure", "tack", "gybe", "engine-on", "engine-off")
    entries += [
        e
        for e in story.points()
        if not _is_near(e, entries, manoeuvres) and not any(b.covers(e.time) for b in boards)
    ]
    return tuple(sorted(entries, key=lambda e: (e.kind == "arrival", e.time, e.kind != "departure")))


def _is_near(entry: Entry, others: Sequence[Entry], kinds: Sequence[str]) -> bool:
    return any(o.kind in kinds and abs((o.time - entry.time).total_seconds()) < SAME_NEWS_S for o in others)


@dataclass(frozen=True, slots=True)
class _Boards:
    """Three tacks or gybes or more, one soon after another."""

    kind: Literal["tack", "gybe"]
    turns: tuple[int, ...]
    begin: datetime
    last: datetime
    end: datetime

    @property
    def is_beat(self) -> bool:
        return len(self.turns) >= FEWEST_BOARDS

    def covers(self, time: datetime) -> bool:
        """Whether a moment is of the beat or run: what changes then is told by it."""
        return self.is_beat and self.begin <= time <= self.end


class _Story:
    """A passage with what is asked again and again of its track."""

    def __init__(self, passage: Passage) -> None:
        self._passage, self._track = passage, passage.track
        track = passage.track
        self._signed = (track.twd_deg - track.course_deg + 180.0) % 360.0 - 180.0

    def _entry(self, sample: int, kind: Kind, phrase: Phrase) -> Entry:
        track = self._track
        return Entry(
            datetime.fromtimestamp(float(track.time[sample]), UTC),
            float(track.lat[sample]),
            float(track.lon[sample]),
            kind,
            phrase,
        )

    def _sample(self, time: float) -> int:
        """First sample that is not before a time [s since 1970]."""
        # Waypoints are told to the microsecond, samples to the double.
        at = int(np.searchsorted(self._track.time, time - 1e-3))
        return min(at, self._track.time.size - 1)

    def _wind(self, sample: int) -> Amount:
        return Amount("wind", float(self._track.tws_kn[sample]))

    def how(self, sample: int) -> Phrase:
        """Wind and where it comes from, as a sailor says it."""
        track = self._track
        angle, signed = float(track.twa_deg[sample]), float(self._signed[sample])
        waypoint = self._passage.waypoints[int(track.leg[sample])]
        if track.tws_kn[sample] < CALM_KN:
            key = "calm"
        elif waypoint.tack == "both":
            key = "beating" if angle < 90.0 else "running"
        elif track.motor[sample]:
            near = ((AHEAD_DEG, "ahead"), (70.0, "bow"), (110.0, "beam"), (ASTERN_DEG, "quarter"))
            key = next((name for limit, name in near if angle < limit), "astern")
        else:
            close, fetch, beam, _ = POINT_LIMITS_DEG
            near = ((close, "close"), (fetch, "fetch"), (beam, "beam"), (ASTERN_DEG, "quarter"))
            key = next((name for limit, name in near if angle < limit), "astern")
        text = HOW[key][int(signed >= 0.0)]
        return Phrase(text, (("wind", self._wind(sample)),) if "{wind}" in text else ())

    def ends(self, wanted: datetime | None) -> Iterator[Entry]:
        """Tell waiting, departure and arrival."""
        passage, last = self._passage, self._track.time.size - 1
        place = passage.start.name
        if wanted is not None and (passage.departure - wanted).total_seconds() > 60.0:
            waited_h = (passage.departure - wanted).total_seconds() / SECONDS_PER_HOUR
            waits = fill("waiting", hours=Amount("hours", waited_h), place=place)
            yield Entry(wanted.astimezone(UTC), passage.start.lat, passage.start.lon, "waiting", waits)
        key = "departure-engine" if self._track.motor[0] else "departure"
        yield self._entry(0, "departure", fill(key, place=place, how=self.how(0)))
        hours, miles = Amount("hours", passage.duration_h), Amount("distance", passage.distance_nm)
        yield self._entry(
            last, "arrival", fill("arrival", place=passage.end.name, hours=hours, distance=miles)
        )

    # --- tacks and gybes ------------------------------------------------------------------------------

    def _turning_points(self) -> Iterator[tuple[int, Literal["tack", "gybe"]]]:
        """Waypoints where the wind comes over to the other side, counted as `Passage.tacks` is."""
        points = self._passage.waypoints
        for k in range(1, len(points) - 1):
            before, here = points[k - 1], points[k]
            old, new, wind = before.steer_deg, here.steer_deg, here.twd_deg
            old, new = (
                (old if old is not None else before.course_deg),
                (new if new is not None else here.course_deg),
            )
            if before.motor or here.motor or old is None or new is None or wind is None:
                continue
            a, b = ((wind - course + 180.0) % 360.0 - 180.0 for course in (old, new))
            if a * b < 0.0:
                yield k, "tack" if abs(a) + abs(b) < 180.0 else "gybe"

    def boards(self) -> Iterator[_Boards]:
        """Tacks and gybes, those together that follow soon on each other."""
        points = self._passage.waypoints
        group: list[int] = []
        kind: Literal["tack", "gybe"] = "tack"
        for k, turn in self._turning_points():
            if group and (turn != kind or self._gap(group[-1], k) > BOARDS_GAP_S):
                yield self._board(kind, group)
                group = []
            kind = turn
            group.append(k)
        if group and points:
            yield self._board(kind, group)

    def _gap(self, a: int, b: int) -> float:
        points = self._passage.waypoints
        return (points[b].time - points[a].time).total_seconds()

    def _board(self, kind: Literal["tack", "gybe"], turns: list[int]) -> _Boards:
        points, first, last = self._passage.waypoints, turns[0], turns[-1]
        begin = first - 1 if self._gap(first - 1, first) <= BOARDS_GAP_S else first
        end = last + 1 if self._gap(last, last + 1) <= BOARDS_GAP_S else last
        return _Boards(kind, tuple(turns), points[begin].time, points[last].time, points[end].time)

    def turns(self, boards: Sequence[_Boards]) -> Iterator[Entry]:
        """One entry a tack or gybe, or one for all boards of a beat or run."""
        for board in boards:
            if board.is_beat:
                n = len(board.turns)
                word = SAID["tacks" if board.kind == "tack" else "gybes"]
                key: Kind = "beat" if board.kind == "tack" else "run"
                sample = self._sample(board.begin.timestamp())
                turns = Phrase(word, (("n", n),), n)
                yield self._entry(
                    sample, key, fill(key, turns=turns, time=board.last, wind=self._wind(sample))
                )
                continue
            for k in board.turns:
                waypoint = self._passage.waypoints[k]
                assert waypoint.course_deg is not None
                course, at = Amount("course", waypoint.course_deg), self._sample(waypoint.time.timestamp())
                yield self._entry(at, board.kind, fill(board.kind, course=course, how=self.how(at)))

    # --- what changes on the way ----------------------------------------------------------------------

    def points(self) -> Iterator[Entry]:
        """Tell changes of the point of sail."""
        track = self._track
        points = np.searchsorted(POINT_LIMITS_DEG, track.twa_deg, side="right")
        sides = np.where(points < len(POINT_LIMITS_DEG), np.sign(self._signed), 0.0)
        under_sail = np.where(track.motor, -1, points * 3 + sides)
        for at, before in settled(under_sail, track.time, POINT_HOLDS_S):
            if track.motor[at] or track.motor[before]:
                continue
            helm = _turned(track.course_deg[before], track.course_deg[at])
            shift = _turned(track.twd_deg[before], track.twd_deg[at])
            course = Amount("course", float(track.course_deg[at]))
            if abs(helm) >= abs(shift):
                closer = track.twa_deg[at] < track.twa_deg[before]
                phrase = fill("heads-up" if closer else "bears-away", course=course, how=self.how(at))
            else:
                phrase = fill("veers" if shift > 0.0 else "backs", how=self.how(at))
            yield self._entry(at, "point-of-sail", phrase)

    def forces(self) -> Iterator[Entry]:
        """Tell changes of the wind's force."""
        track = self._track
        force = np.array([beaufort(kn) for kn in track.tws_kn.tolist()])
        for at, before in settled(force, track.time, WIND_HOLDS_S):
            kind: Kind = "wind-up" if force[at] > force[before] else "wind-down"
            yield self._entry(at, kind, fill(kind, force=int(force[at]), how=self.how(at)))

    def engine(self) -> Iterator[Entry]:
        """Engine on and off under way."""
        track = self._track
        for at, _ in settled(track.motor.astype(np.int64), track.time, ENGINE_HOLDS_S):
            kind: Kind = "engine-on" if track.motor[at] else "engine-off"
            yield self._entry(at, kind, fill(kind, how=self.how(at)))

    def forecast(self) -> Iterator[Entry]:
        """Tell where the forecast ends, when she is still under way."""
        passage, track = self._passage, self._track
        end = passage.forecast.valid_to.timestamp()
        if passage.beyond_forecast_h > 0.0 and end < float(track.time[-1]):
            key = "fading" if passage.beyond == "fade" else "held"
            yield self._entry(self._sample(end), "forecast-ends", fill(key))

    def strongest(self, wind: Wind | None) -> Iterator[Entry]:
        """Strongest wind with its gusts, highest waves, strongest current."""
        track = self._track
        weather = weather_along(track, wind)
        gust, wave = weather.gust_kn, weather.wave_m
        at = int(np.argmax(track.tws_kn))
        phrase = fill("strongest-wind", how=self.how(at))
        if gust is not None and float(gust[at]) > float(track.tws_kn[at]):
            gusts = Amount("wind", float(gust[at]))
            phrase = fill("strongest-gusts", gusts=gusts, how=self.how(at))
        yield self._entry(at, "strongest-wind", phrase)
        if wave is not None and float(np.nanmax(wave, initial=0.0)) >= LEAST_WAVES_M:
            at = int(np.nanargmax(wave))
            yield self._entry(at, "waves", fill("waves", height=Amount("height", float(wave[at]))))
        currents = [w for w in self._passage.waypoints if w.current_kn and w.current_to_deg is not None]
        strong = max(currents, key=lambda w: w.current_kn or 0.0, default=None)
        if strong is not None and (strong.current_kn or 0.0) >= LEAST_CURRENT_KN:
            speed = Amount("speed", strong.current_kn or 0.0)
            course = Amount("course", strong.current_to_deg or 0.0)
            at = self._sample(strong.time.timestamp())
            yield self._entry(at, "current", fill("current", speed=speed, course=course))

    def sun(self) -> Iterator[Entry]:
        """Sunrises and sunsets."""
        track = self._track
        for event in sun_events(track.time, track.lat, track.lon):
            how = self.how(self._sample(event.time))
            time = datetime.fromtimestamp(event.time, UTC)
            yield Entry(time, event.lat, event.lon, event.kind, fill(event.kind, how=how))

    def passed(self, place: Passed) -> Entry:
        """Tell a place that she passes or rounds."""
        kind: Kind = "rounding" if place.rounded else "passing"
        if not place.rounded and place.distance_nm < CLOSE_NM:
            close = fill("passing-close", place=place.name, how=self.how(place.sample))
            return self._entry(place.sample, kind, close)
        distance = Amount("distance", place.distance_nm)
        phrase = fill(f"{kind}-{place.side}", place=place.name, distance=distance, how=self.how(place.sample))
        return self._entry(place.sample, kind, phrase)


def _turned(before: float, after: float) -> float:
    return (float(after) - float(before) + 180.0) % 360.0 - 180.0


def settled(levels: NDArray[np.int64] | Array, time: Array, holds_s: float) -> list[tuple[int, int]]:
    """Find changes that last.

    Parameters
    ----------
    levels, time
        ``(n,)`` class and moment [s] of each sample.
    holds_s
        A class that lasts for less is passed over [s].

    Returns
    -------
    list
        First sample of each new class, and the last sample of the class that was news before it.
    """
    edges = [0, *(np.flatnonzero(np.diff(levels)) + 1).tolist(), len(levels)]
    changes: list[tuple[int, int]] = []
    known = 0
    for begin, end in pairwise(edges):
        last = min(end, len(levels) - 1)
        if levels[begin] == levels[known]:
            known = end - 1
        elif time[last] - time[begin] >= holds_s:
            changes.append((begin, known))
            known = end - 1
    return changes
