"""Members of an ensemble around the passage shown: found beside the window, told in words and drawn."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QCoreApplication, QObject, Qt, QTimer, Signal
from PySide6.QtWidgets import QApplication

from seacruise.desktop.alternatives import side_name
from seacruise.desktop.compute import Answer, Planner, replan
from seacruise.desktop.jobs import JobRunner
from seacruise.desktop.pages.inbox import Inbox
from seacruise.desktop.side_by_side import as_they_come
from seacruise.errors import CancelledError, SeaCruiseError
from seacruise.export.textform import format_duration

if TYPE_CHECKING:
    from seacruise.alternatives import Split
    from seacruise.desktop.chart.view import ChartView
    from seacruise.members import Bundle, Member
    from seacruise.progress import Job
    from seacruise.settings import Settings
    from seacruise.study import Spread

_REST_MS: Final = 300
"""Only so long after the last change are members sailed: what follows a hand has the cores for itself."""

_BUNDLE_EVERY_S: Final = 0.25

_LEAST_TOLD: Final = 5
"""Of fewer members no spread is told."""

_TO_THE_HOUR_H: Final = 20.0
_STEP_H: Final = 1.0 / 6.0


# ------------------------------------------------------------------------------------------ the work


def sail_members(
    answer: Answer,
    *,
    settings: Settings,
    job: Job,
    planner: Planner,
    deliver: Callable[[Bundle], None],
) -> Bundle:
    """Sail a passage in the wind of each member: the fastest there, and the line as it was planned.

    Parameters
    ----------
    answer
        Its wind has members; it leaves when the answer does, and by the same place if there is one.
    deliver
        Called on this thread with what is known so far, some four times a second.

    Raises
    ------
    CancelledError
        The job was cancelled.
    """
    from seacruise.members import bundle_of, winds_of

    planned, options = answer.passage, answer.question.options
    winds = winds_of(answer.wind, options.beyond)
    known: list[Member] = []
    told = time.monotonic()

    def one(number: int) -> Member:
        return _sail(number, replace(answer, wind=winds[number]), settings=settings, job=job, planner=planner)

    for member in as_they_come(one, len(winds), job, name="members"):
        known.append(member)
        if time.monotonic() - told >= _BUNDLE_EVERY_S and len(known) < len(winds):
            told = time.monotonic()
            deliver(_weighed(bundle_of(planned, len(winds), known)))
            job.report("search", len(known) / len(winds), f"Passage {len(known)} of {len(winds)}")
    return _weighed(bundle_of(planned, len(winds), known))


def _sail(number: int, there: Answer, *, settings: Settings, job: Job, planner: Planner) -> Member:
    """Sail the passage of an answer in the wind it has now."""
    from seacruise.members import Member, hours_along
    from seacruise.passage import PassageRequest

    planned = there.passage
    question = replace(there.question, departure=planned.departure)
    passage, kept_h = None, None
    try:
        passage = replan(question, there, settings=settings, job=job, planner=planner).passage
        passage = replace(passage, lattice_edges=None)
    except CancelledError:
        raise
    except SeaCruiseError:
        # A member in which there is no way is counted as one.
        job.check()
    request = PassageRequest(
        question.start,
        question.end,
        question.yacht,
        there.wind,
        planned.departure,
        question.options,
        there.zones,
    )
    kept_h = hours_along(request, planned, settings=settings)
    return Member(number, passage, kept_h)


def _weighed(bundle: Bundle) -> Bundle:
    """Have a bundle weighed here, not on the window's thread."""
    _ = bundle.splits, bundle.duration_h, bundle.kept_h
    return bundle


# ------------------------------------------------------------------------------------------ in words


def bundle_text(bundle: Bundle) -> str:
    """Say what the members make of a passage: how long, how long on the planned line, by which side."""
    known, total = len(bundle.members), bundle.total
    if known < min(_LEAST_TOLD, total):
        return _tr("{n} of {total} members sailed so far…").format(n=known, total=total)
    head = _tr("In {n} members") if bundle.is_complete else _tr("In {n} of {total} members so far")
    head = head.format(n=known, total=total)
    said = [_tr("{head}: {hours}.").format(head=head, hours=spread_text(bundle.duration_h))]
    without = known - len(bundle.passages)
    if without:
        said.append(_tr("No passage in {n} of {total}.").format(n=without, total=known))
    said.append(_tr("The planned line takes {hours}.").format(hours=spread_text(bundle.kept_h)))
    stuck = sum(member.kept_h is None for member in bundle.members)
    if stuck:
        said.append(_tr("Along it she does not arrive in {n} of {total}.").format(n=stuck, total=known))
    said.extend(split_text(split, known) for split in bundle.splits[:2])
    return " ".join(said)


def spread_text(spread: Spread) -> str:
    """Say a spread: ``41 h to 49 h (10 to 90 %), median 44 h``."""
    low, middle, high = (None if h is None else about(h) for h in (spread.low, spread.middle, spread.high))
    if low is None:
        return _tr("hardly ever arrives")
    if middle is None or high is None:
        return _tr("{low} at best (10 %)").format(low=low)
    if low == high:
        return _tr("about {middle}").format(middle=middle)
    return _tr("{low} to {high} (10 to 90 %), median {middle}").format(low=low, high=high, middle=middle)


def split_text(split: Split, total: int) -> str:
    """Say by which side of an island most members go, and whether that is the planned one."""
    most = split.passing[0]
    planned = most.side == split.planned
    text = (
        _tr("{n} of {total} go {side}, as planned.")
        if planned
        else _tr("{n} of {total} go {side}, unlike the plan.")
    )
    return text.format(n=most.count, total=total, side=side_name(split.island, most.side))


def about(hours: float) -> str:
    """Write a duration as roughly as an ensemble knows it: ``41 h``, ``5 h 40 min``."""
    if hours >= _TO_THE_HOUR_H:
        return _tr("{n} h").format(n=round(hours))
    return format_duration(round(hours / _STEP_H) * _STEP_H)


def _tr(text: str) -> str:
    return QCoreApplication.translate("members", text)


# -------------------------------------------------------------------------------------- in the window


class ForecastMembers(QObject):
    """Keeps the members on the chart those of the passage shown.

    Signals: ``told(text)`` what they say together, empty when there is nothing to say; ``failed(error)``.
    """

    told = Signal(str)
    failed = Signal(object)

    def __init__(
        self, settings: Settings, planner: Planner, view: ChartView, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._settings, self._planner, self._view = settings, planner, view
        self._of: Answer | None = None
        self._inbox: Inbox[Bundle] = Inbox()
        self._begin = QTimer(self)
        self._begin.setSingleShot(True)
        self._begin.setInterval(_REST_MS)
        self._begin.timeout.connect(self._start)
        self.jobs = JobRunner("members", self)
        self.jobs.progressed.connect(lambda *_: self._take())
        self.jobs.finished.connect(lambda _, bundle: self._show(bundle))
        self.jobs.failed.connect(lambda _, error: self.failed.emit(error))

    def show(self, answer: Answer | None, *, on: bool) -> None:
        """Find the members of an answer, unless they are there; none while it follows a hand."""
        wanted = answer if on and answer is not None and answer.wind.members else None
        if wanted is self._of:
            return
        self._drop()
        self._of = wanted
        if wanted is not None and not wanted.rough:
            self._begin.start()

    def shut_down(self) -> None:
        """End the worker, and begin no other."""
        self._begin.stop()
        self.jobs.shut_down()

    def _drop(self) -> None:
        """Forget what is on the chart, and what is on its way."""
        self._begin.stop()
        self.jobs.cancel()
        self._inbox = Inbox()
        self._view.members.show_bundle(None)
        self.told.emit("")

    def _start(self) -> None:
        answer = self._of
        if answer is None:
            return
        if QApplication.mouseButtons() & Qt.MouseButton.LeftButton:
            # A drag that is precise at each step pauses now and then; the hand has not let go.
            self._begin.start()
            return
        settings, planner, inbox = self._settings, self._planner, self._inbox

        def work(job: Job) -> Any:
            return sail_members(answer, settings=settings, job=job, planner=planner, deliver=inbox.put)

        self.told.emit(_tr("Sailing the members of the forecast…"))
        self.jobs.run_job(work)

    def _take(self) -> None:
        bundles = self._inbox.take()
        if bundles:
            self._show(bundles[-1])

    def _show(self, bundle: Bundle) -> None:
        self._view.members.show_bundle(bundle)
        self._view.viewport().update()
        self.told.emit(bundle_text(bundle))
