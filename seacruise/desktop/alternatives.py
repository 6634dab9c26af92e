"""Other ways than the one shown, for the chart: computed beside the window in the wind at hand."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from typing import TYPE_CHECKING, Any, Final, Protocol

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QCoreApplication, QObject, Signal
from PySide6.QtWidgets import QMenu

from seacruise.desktop.compute import Answer, Planner, replan
from seacruise.desktop.jobs import JobRunner
from seacruise.desktop.language import sentence
from seacruise.desktop.pages.inbox import Inbox
from seacruise.desktop.units_choice import short_moment
from seacruise.export.textform import format_day_time, format_duration
from seacruise.geodesy import great_circle_m
from seacruise.progress import Job
from seacruise.units import METRES_PER_NM

if TYPE_CHECKING:
    from seacruise.alternatives import OtherWay
    from seacruise.desktop.chart.view import ChartView
    from seacruise.passage import Passage
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
    turns, not_turns
        Tacks and gybes of one that has fewer of them, or more, and those of the passage shown; else ``None``.
    most_turns
        Option by which the sailor gets it.
    """

    island: str
    side: str
    hours: float
    more_h: float
    line: NDArray[np.float64]
    place: tuple[float, float]
    via: tuple[float, float] | None
    leaving: datetime | None = None
    turns: int | None = None
    not_turns: int | None = None
    most_turns: int | None = None

    @property
    def name(self) -> str:
        """How a sailor calls it."""
        if self.leaving is not None:
            return _tr("leaving {moment}").format(moment=short_moment(self.leaving))
        if self.turns is not None:
            return QCoreApplication.translate("ways", "%n turn(s):", "", self.turns)
        return side_name(self.island, self.side) if self.side else _tr("direct")

    @property
    def plain(self) -> str:
        """Name and duration in English, for files."""
        name = f"{self.side} of {self.island}" if self.side else "direct"
        if self.leaving is not None:
            name = f"leaving {format_day_time(self.leaving)} UTC"
        elif self.turns is not None:
            name = f"tacks and gybes: {self.turns}"
        return f"{name}, {format_duration(self.hours)}"

    @property
    def label(self) -> str:
        """Name and duration, for the chart."""
        return self._told(self.name)

    @property
    def text(self) -> str:
        """Name, duration and difference: ``east of Gotland 51 h 46 min, +1 h 57 min``."""
        name = self.name
        if self.turns is not None:
            name = QCoreApplication.translate("ways", "%n turn(s) instead of {others}:", "", self.turns)
            name = name.format(others=self.not_turns)
        return _tr("{way}, {difference}").format(way=self._told(name), difference=self.difference)

    @property
    def difference(self) -> str:
        """How much longer it takes than the passage shown, or shorter: ``+1 h 57 min``."""
        return ("+" if self.more_h >= 0 else "−") + format_duration(abs(self.more_h))

    def _told(self, name: str) -> str:
        return _tr("{way} {duration}").format(way=name, duration=format_duration(self.hours))


def side_name(island: str, side: str) -> str:
    """Say on which side of an island a way passes: ``east of Gotland``."""
    words = {
        "north": _tr("north of {island}"),
        "east": _tr("east of {island}"),
        "south": _tr("south of {island}"),
        "west": _tr("west of {island}"),
    }
    return words[side].format(island=island)


Deliver = Callable[[tuple["Way", ...]], None]
"""Called on the worker's thread with the ways that are found so far."""


def _nobody(_ways: tuple[Way, ...]) -> None:
    """Receive ways that nobody waits for."""


def way_of_departure(run: Run, shown: Passage) -> Way | None:
    """Way of a departure that was compared; ``None`` where it has no passage or is the one shown."""
    passage = run.passage
    if passage is None or (passage.departure, passage.yacht) == (shown.departure, shown.yacht):
        return None
    more_h = passage.duration_h - shown.duration_h
    place = _middle(passage)
    return Way("", "", passage.duration_h, more_h, line_of(passage), place, None, passage.departure)


def find_ways(
    answer: Answer, *, settings: Settings, job: Job, planner: Planner, deliver: Deliver = _nobody
) -> tuple[Way, ...]:
    """Search the other sides of the islands on the way, in the wind of an answer; nothing is fetched.

    Of a passage by way of a place the way without it is one more. All come at once, the faster before the
    slower.

    Raises
    ------
    CancelledError
        The job was cancelled.
    """
    from seacruise.alternatives import other_ways

    del deliver

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
    without = Way("", "", direct.duration_h, more_h, line_of(direct), _middle(direct), None)
    here = (via.lat, via.lon)
    others = [
        way for way in found if float(great_circle_m(*way.place, *here)) / METRES_PER_NM > _SAME_PLACE_NM
    ]
    return without, *others


def find_fewer_turns(
    answer: Answer, *, settings: Settings, job: Job, planner: Planner, deliver: Deliver = _nobody
) -> tuple[Way, ...]:
    """Plan with ever fewer tacks and gybes, in the wind of an answer; nothing is fetched.

    Of a passage that may have so many only, the one that may have any number is one more.

    Raises
    ------
    CancelledError
        The job was cancelled.
    """
    from seacruise.tradeoff import fewer_turns

    shown, question = answer.passage, answer.question
    ways: list[Way] = []
    # Each passage has stages of its own, which nobody wants to hear of.
    quiet = Job(cancel=job.cancel)

    def sail(most: int | None) -> Passage:
        asked = replace(question, options=replace(question.options, most_turns=most))
        return replan(asked, answer, settings=settings, job=quiet, planner=planner).passage

    for one in fewer_turns(shown, sail, job=job):
        # Of a passage by way of a place each half may have so many; else the number it has says as much.
        turns = one.passage.tacks + one.passage.gybes
        ways.append(_turning(one.passage, turns if question.via is None else one.most_turns, shown))
        deliver(tuple(ways))
    if question.options.most_turns is not None:
        free = sail(None)
        if free.tacks + free.gybes > shown.tacks + shown.gybes:
            ways.append(_turning(free, None, shown))
    return tuple(ways)


def _turning(passage: Passage, most: int | None, shown: Passage) -> Way:
    more_h = passage.duration_h - shown.duration_h
    way = Way("", "", passage.duration_h, more_h, line_of(passage), _middle(passage), None)
    turns, others = (one.tacks + one.gybes for one in (passage, shown))
    return replace(way, turns=turns, not_turns=others, most_turns=most)


def _other(way: OtherWay, shown: Passage) -> Way:
    passage, place = way.passage, (way.lat, way.lon)
    more_h = passage.duration_h - shown.duration_h
    return Way(way.island, way.side, passage.duration_h, more_h, line_of(passage), place, place)


def _middle(passage: Passage) -> tuple[float, float]:
    """Position after half of the time [degrees]."""
    half = len(passage.track.time) // 2
    return float(passage.track.lat[half]), float(passage.track.lon[half])


def line_of(passage: Passage) -> NDArray[np.float64]:
    """Positions of a passage's waypoints ``(n, 2)`` as lat and lon [degrees]."""
    return np.array([[waypoint.lat, waypoint.lon] for waypoint in passage.waypoints])


class Finder(Protocol):
    """`find_ways`, or another search for ways."""

    def __call__(
        self, answer: Answer, *, settings: Settings, job: Job, planner: Planner, deliver: Deliver
    ) -> tuple[Way, ...]:
        """Find them."""
        ...


class _Seeker(QObject):
    """Keeps ways of one kind on the chart those of the passage shown.

    Parameters
    ----------
    find, put
        What finds them on a worker, and where they are shown.

    Signals: ``looking(message)`` what is looked for, ``found(ways)``, ``failed(error)``.
    """

    looking = Signal(str)
    found = Signal(object)
    failed = Signal(object)

    def __init__(
        self,
        name: str,
        find: Callable[[Answer, Job, Deliver], tuple[Way, ...]],
        put: Callable[[Sequence[Way]], None],
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._find, self._put = find, put
        self._of: Answer | None = None
        self._inbox: Inbox[tuple[Way, ...]] = Inbox()
        self.jobs = JobRunner(name, self)
        self.jobs.progressed.connect(self._progressed)
        self.jobs.finished.connect(self._found)
        self.jobs.failed.connect(lambda _, error: self.failed.emit(error))

    def show(self, answer: Answer | None) -> None:
        """Find the ways of an answer, unless they are there; none while it follows a hand."""
        if answer is self._of:
            return
        self._of = None
        self.jobs.cancel()
        self._put(())
        if answer is None or answer.rough:
            return
        inbox: Inbox[tuple[Way, ...]] = Inbox()
        self._of, self._inbox, find = answer, inbox, self._find

        def work(job: Job) -> Any:
            return find(answer, job, inbox.put)

        self.jobs.run_job(work)

    def _progressed(self, _generation: int, _stage: str, _fraction: float | None, message: str) -> None:
        if ways := self._inbox.take():
            self._put(ways[-1])
        self.looking.emit(message)

    def _found(self, _generation: int, ways: tuple[Way, ...]) -> None:
        self._put(ways)
        self.found.emit(ways)


class OtherWays(QObject):
    """Keeps the other ways on the chart those of the passage shown.

    Signals: ``failed(error)`` when they could not be found, ``departure_picked(datetime)`` on a click on a
    passage that leaves at another time, ``turns_picked(most)`` on one with fewer turns, ``None`` for as many
    as are fastest; ``noted(text)`` what the line below should say of the search for fewer turns.
    """

    failed = Signal(object)
    departure_picked = Signal(object)
    turns_picked = Signal(object)
    noted = Signal(str)

    def __init__(
        self, settings: Settings, planner: Planner, view: ChartView, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._view = view
        self._answer: Answer | None = None

        def seeker(name: str, find: Finder, put: Callable[[Sequence[Way]], None]) -> _Seeker:
            def seek(answer: Answer, job: Job, deliver: Deliver) -> tuple[Way, ...]:
                return find(answer, settings=settings, job=job, planner=planner, deliver=deliver)

            made = _Seeker(name, seek, put, self)
            made.failed.connect(self.failed)
            return made

        self.islands = seeker("ways", find_ways, view.others.show_ways)
        self.turns = seeker("turns", find_fewer_turns, view.others.show_turns)
        self.turns.looking.connect(lambda message: self.noted.emit(sentence(message)))
        self.turns.found.connect(self._note_turns)
        view.way_picked.connect(self._adopt)

    def list_in(self, menu: QMenu) -> None:
        """List the ways on the chart in a menu whenever it opens, for the keyboard and where lines cover."""

        def fill() -> None:
            menu.clear()
            for way in self._view.others.ways:
                menu.addAction(way.text).triggered.connect(
                    lambda _checked=False, way=way: self._view.way_picked.emit(way)
                )
            if menu.isEmpty():
                menu.addAction(_tr("None on the chart: View, Other ways or Fewer turns")).setEnabled(False)

        menu.aboutToShow.connect(fill)

    def show(self, answer: Answer | None, *, islands: bool, turns: bool) -> None:
        """Find the ways of an answer past islands, those with fewer turns, or both."""
        if answer is not self._answer:
            self._answer = answer
            self._view.others.compare(None)
        self.islands.show(answer if islands else None)
        self.turns.show(answer if turns else None)

    def compare(self, run: Run | None) -> None:
        """Show the way of a departure that was compared, or none; it is known, nothing is computed."""
        shown = self._answer
        self._view.others.compare(
            None if run is None or shown is None else way_of_departure(run, shown.passage)
        )

    def shut_down(self) -> None:
        """End the workers."""
        self.islands.jobs.shut_down()
        self.turns.jobs.shut_down()

    def _note_turns(self, ways: tuple[Way, ...]) -> None:
        fewer = [way for way in ways if (way.turns or 0) < (way.not_turns or 0)]
        told = ", ".join(_tr("{n} ({difference})").format(n=w.turns, difference=w.difference) for w in fewer)
        self.noted.emit(
            _tr(
                "Fewer turns: {ways}. Click one on the chart, or choose it under Passage, Sail another way."
            ).format(ways=told)
            if fewer
            else _tr("There is no passage with fewer tacks and gybes that is worth its time.")
        )

    def _adopt(self, way: Way) -> None:
        """Sail a way: by way of the place where it is abeam of its island, or with so many turns."""
        if way.leaving is not None:
            self.departure_picked.emit(way.leaving)
        elif way.turns is not None:
            self.turns_picked.emit(way.most_turns)
        elif way.via is None:
            self._view.via_dropped.emit()
        else:
            self._view.end_picked.emit("via", *way.via)


def _tr(text: str) -> str:
    return QCoreApplication.translate("ways", text)
