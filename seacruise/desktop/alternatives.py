"""Other ways than the one shown, for the chart: computed beside the window in the wind at hand."""

from __future__ import annotations

from dataclasses import dataclass, replace
from datetime import datetime
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QCoreApplication, QObject, Signal

from seacruise.desktop.compute import Answer, Planner, replan
from seacruise.desktop.jobs import JobRunner
from seacruise.desktop.units_choice import short_moment
from seacruise.export.textform import format_duration
from seacruise.geodesy import great_circle_m
from seacruise.units import METRES_PER_NM

if TYPE_CHECKING:
    from seacruise.alternatives import OtherWay
    from seacruise.desktop.chart.view import ChartView
    from seacruise.passage import Passage
    from seacruise.progress import Job
    from seacruise.sea.zones import Zone
    from seacruise.settings import Settings
    from seacruise.study import Run

_SAME_PLACE_NM: Final = 4.0
"""A way abeam of its island this near to the place the passage is led by is the passage itself [nm]."""


@dataclass(frozen=True, slots=True, eq=False)
class Way:
    """Another way on the chart.

    Attributes
    ----------
    island, side
        What it passes, and on which side; empty for the way that is led by no place.
    hours, more_h
        What it takes [h], and by how much that is more than the passage shown.
    line
        ``(n, 2)`` of lat and lon [degrees].
    place
        Where its name belongs [degrees].
    via
        Sailing by way of there is sailing it; ``None`` where it needs none.
    leaving
        Departure of one that leaves at another time; else ``None``.
    """

    island: str
    side: str
    hours: float
    more_h: float
    line: NDArray[np.float64]
    place: tuple[float, float]
    via: tuple[float, float] | None
    leaving: datetime | None = None

    @property
    def name(self) -> str:
        """How a sailor calls it."""
        if self.leaving is not None:
            return _tr("leaving {moment}").format(moment=short_moment(self.leaving))
        words = {
            "north": _tr("north of {island}"),
            "east": _tr("east of {island}"),
            "south": _tr("south of {island}"),
            "west": _tr("west of {island}"),
        }
        return words.get(self.side, _tr("direct")).format(island=self.island)

    @property
    def label(self) -> str:
        """Name and duration, for the chart."""
        return _tr("{way} {duration}").format(way=self.name, duration=format_duration(self.hours))

    @property
    def text(self) -> str:
        """Name, duration and difference: ``east of Gotland 51 h 46 min, +1 h 57 min``."""
        sign = "+" if self.more_h >= 0 else "−"
        difference = sign + format_duration(abs(self.more_h))
        return _tr("{way}, {difference}").format(way=self.label, difference=difference)


def way_of_departure(run: Run, shown: Passage) -> Way | None:
    """Way of a departure that was compared; ``None`` where it has no passage or is the one shown."""
    passage = run.passage
    if passage is None or (passage.departure, passage.yacht) == (shown.departure, shown.yacht):
        return None
    more_h = passage.duration_h - shown.duration_h
    place = _middle(passage)
    return Way("", "", passage.duration_h, more_h, _line(passage), place, None, passage.departure)


def find_ways(answer: Answer, *, settings: Settings, job: Job, planner: Planner) -> tuple[Way, ...]:
    """Search the other sides of the islands on the way, in the wind of an answer; nothing is fetched.

    Of a passage by way of a place the way without it is one more.

    Raises
    ------
    CancelledError
        The job was cancelled.
    """
    from seacruise.alternatives import other_ways

    shown, question = answer.passage, replace(answer.question, via=None)

    def sail(*barriers: Zone) -> Passage:
        asked = replace(question, avoid=(*question.avoid, *barriers))
        return replan(asked, answer, settings=settings, job=job, planner=planner).passage

    via = answer.question.via
    direct = shown if via is None else sail()
    found = [_other(way, shown) for way in other_ways(direct, sail, job=job)]
    if via is None:
        return tuple(found)
    more_h = direct.duration_h - shown.duration_h
    without = Way("", "", direct.duration_h, more_h, _line(direct), _middle(direct), None)
    here = (via.lat, via.lon)
    others = [
        way for way in found if float(great_circle_m(*way.place, *here)) / METRES_PER_NM > _SAME_PLACE_NM
    ]
    return without, *others


def _other(way: OtherWay, shown: Passage) -> Way:
    passage, place = way.passage, (way.lat, way.lon)
    more_h = passage.duration_h - shown.duration_h
    return Way(way.island, way.side, passage.duration_h, more_h, _line(passage), place, place)


def _middle(passage: Passage) -> tuple[float, float]:
    """Position after half of the time [degrees]."""
    half = len(passage.track.time) // 2
    return float(passage.track.lat[half]), float(passage.track.lon[half])


def _line(passage: Passage) -> NDArray[np.float64]:
    return np.array([[waypoint.lat, waypoint.lon] for waypoint in passage.waypoints])


class OtherWays(QObject):
    """Keeps the other ways on the chart those of the passage shown.

    Signals: ``failed(error)`` when they could not be found, ``departure_picked(datetime)`` on a click on a
    passage that leaves at another time.
    """

    failed = Signal(object)
    departure_picked = Signal(object)

    def __init__(
        self, settings: Settings, planner: Planner, view: ChartView, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._settings, self._planner, self._view = settings, planner, view
        self._of: Answer | None = None
        self._answer: Answer | None = None
        self.jobs = JobRunner("ways", self)
        self.jobs.finished.connect(self._found)
        self.jobs.failed.connect(lambda _, error: self.failed.emit(error))
        view.way_picked.connect(self._adopt)

    def show(self, answer: Answer | None, *, on: bool) -> None:
        """Find the ways of an answer, unless they are there; none while it follows a hand."""
        if answer is not self._answer:
            self._answer = answer
            self._view.others.compare(None)
        wanted = answer if on else None
        if wanted is self._of:
            return
        self._of = None
        self.jobs.cancel()
        self._view.others.show_ways(())
        if wanted is None or wanted.rough:
            return
        self._of, settings, planner = wanted, self._settings, self._planner

        def work(job: Job) -> Any:
            return find_ways(wanted, settings=settings, job=job, planner=planner)

        self.jobs.run_job(work)

    def compare(self, run: Run | None) -> None:
        """Show the way of a departure that was compared, or none; it is known, nothing is computed."""
        shown = self._answer
        self._view.others.compare(
            None if run is None or shown is None else way_of_departure(run, shown.passage)
        )

    def _found(self, _generation: int, ways: tuple[Way, ...]) -> None:
        self._view.others.show_ways(ways)

    def _adopt(self, way: Way) -> None:
        """Sail a way: by way of the place where it is abeam of its island."""
        if way.leaving is not None:
            self.departure_picked.emit(way.leaving)
        elif way.via is None:
            self._view.via_dropped.emit()
        else:
            self._view.end_picked.emit("via", *way.via)


def _tr(text: str) -> str:
    return QCoreApplication.translate("ways", text)
