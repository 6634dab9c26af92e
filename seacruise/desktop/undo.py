"""Undo and redo of what changes the question: ports, departure, yacht, how she is sailed, a place to sail by.

Nobody who changes something has to know of it: after each change what is asked is compared with what was
asked before, and the difference becomes a step. Areas to avoid are steps of their own on the same stack
(`seacruise.desktop.avoid`).
"""

from __future__ import annotations

import time
from dataclasses import asdict, dataclass, fields, replace
from datetime import datetime
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, QObject, Qt, QTimer
from PySide6.QtGui import QAction, QKeySequence, QUndoCommand, QUndoStack
from PySide6.QtWidgets import QApplication

from seacruise.desktop.avoid import Change, Renamed
from seacruise.desktop.language import sentence
from seacruise.desktop.log_words import day_and_time

if TYPE_CHECKING:
    from seacruise.desktop.chart_pane import ChartPane
    from seacruise.desktop.form import PassageForm
    from seacruise.desktop.steering import Steering
    from seacruise.passage import Options
    from seacruise.ports import Port

_TOGETHER_S: Final = 1.0
"""Changes of the same thing that follow each other sooner are one step, as by a wheel or a held key [s]."""


def _tr(text: str) -> str:
    return QCoreApplication.translate("undo", text)


@dataclass(frozen=True, slots=True)
class Asked:
    """What form and chart ask.

    Attributes
    ----------
    chosen
        Whether the sailor chose the departure; else it follows the forecast, and is nobody's wish.
    forecast
        Names and weights.
    """

    start: Port | None
    end: Port | None
    departure: datetime
    chosen: bool
    yacht: str
    forecast: tuple[tuple[str, ...], tuple[float, ...]]
    options: Options
    via: Port | None


def differences(before: Asked, after: Asked) -> frozenset[str]:
    """Name the fields in which the sailor's wishes differ.

    A field for a port that names none is one that is being typed into; a departure that nobody chose follows
    the forecast.
    """
    found = {f.name for f in fields(Asked) if getattr(before, f.name) != getattr(after, f.name)}
    if after.start is None:
        found.discard("start")
    if after.end is None:
        found.discard("end")
    if not after.yacht:
        found.discard("yacht")
    if not after.chosen:
        found.discard("departure")
    found.discard("chosen")
    return frozenset(found)


def name_of(changed: frozenset[str], before: Asked, after: Asked) -> str:
    """Name a step for the menu."""
    if changed == {"start", "end"}:
        if (after.start, after.end) == (before.end, before.start):
            return _tr("start and end swapped")
        return _tr("start and end")
    if len(changed) != 1:
        return _tr("passage")
    match next(iter(changed)):
        case "start" if after.start is not None:
            return _tr("start {port}").format(port=after.start.name)
        case "end" if after.end is not None:
            return _tr("destination {port}").format(port=after.end.name)
        case "departure":
            return _tr("departure {moment}").format(moment=day_and_time(after.departure))
        case "yacht":
            return _tr("yacht {name}").format(name=sentence(after.yacht))
        case "forecast":
            return _tr("forecast")
        case "via":
            return _tr("sailing by way of a place") if after.via is not None else _tr("sailing direct")
    return _tr("how she is sailed")


class _Step(QUndoCommand):
    """From one question to another; what it does not change stays as it is when it is undone."""

    def __init__(self, history: History, before: Asked, after: Asked, session: int) -> None:
        self.changed = differences(before, after)
        super().__init__(name_of(self.changed, before, after))
        self._history, self.before, self.after, self.session = history, before, after, session
        self._is_made = True

    def again(self, history: History) -> _Step:
        """Give the same step for another window, named in its language."""
        return _Step(history, self.before, self.after, self.session)

    def grow(self, after: Asked, changed: frozenset[str]) -> bool:
        """Become one with what the same movement did next; False when that came back to where it began."""
        self.after = after
        self.changed |= changed
        self.setText(name_of(self.changed, self.before, self.after))
        return bool(differences(self.before, self.after))

    def redo(self) -> None:
        """Make the change; the first time the sailor has made it."""
        if self._is_made:
            self._is_made = False
            return
        self._history.put(self.after, self.changed)

    def undo(self) -> None:
        """Take it back."""
        self._history.put(self.before, self.changed)


class History(QObject):
    """Watches form and chart, and fills the stack of the areas to avoid.

    Nothing is recorded before `begin`: until ports, yachts and forecast are loaded the form fills itself.

    Parameters
    ----------
    form, chart, steering
        Of the window; ``steering`` has the stack.
    """

    def __init__(
        self, form: PassageForm, chart: ChartPane, steering: Steering, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._form, self._steering = form, steering
        self._known: Asked | None = None
        self._putting = self._is_copying = False
        self._session, self._kind, self._last = 0, frozenset[str](), 0.0
        self._soon = QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.setInterval(0)
        self._soon.timeout.connect(self.note)
        bar, view = chart.time_bar, chart.view
        for signal in (
            form.ends_changed,
            form.departure.changed,
            form.forecast_changed,
            form.sailing.changed,
            form.yacht_box.currentTextChanged,
            view.via_dropped,
        ):
            signal.connect(self._soon.start)
        for signal in (form.start_field.editingFinished, form.end_field.editingFinished):
            signal.connect(self.settle)
        bar.departure_settled.connect(self.settle)
        view.end_picked.connect(self.settle)
        view.end_dragged.connect(self._dragged)
        steering.taken_over.connect(self.begin)

    @property
    def stack(self) -> QUndoStack:
        """The steps."""
        return self._steering.avoided.stack

    def begin(self) -> None:
        """Regard what is asked now as what there was before: record from here on."""
        self._known = self._asked()

    def _asked(self) -> Asked:
        form, ends = self._form, self._form.ends
        return Asked(
            start=ends.get("from"),
            end=ends.get("to"),
            departure=form.departure.moment,
            chosen=form.departure.was_chosen,
            yacht=form.yacht_box.currentText(),
            forecast=(form.forecast, form.weights),
            options=form.options(),
            via=self._steering.via,
        )

    def _dragged(self, _which: str, _port: object, done: bool) -> None:
        if done:
            self.settle()
        else:
            self.note()

    def settle(self) -> None:
        """Take note, and let the next change be a step of its own: the hand has let go."""
        self.note()
        self._kind = frozenset()

    def note(self) -> None:
        """Take note of what has changed, if anything has."""
        self._soon.stop()
        before, after = self._known, self._asked()
        if before is None or self._putting:
            return
        changed = differences(before, after)
        # Half a name is no port: the step leads from the last one that was.
        self._known = replace(
            after,
            start=after.start or before.start,
            end=after.end or before.end,
            yacht=after.yacht or before.yacht,
        )
        if not changed:
            return
        now = time.monotonic()
        if changed != self._kind or (now - self._last > _TOGETHER_S and not self._is_held()):
            self._session += 1
        self._kind, self._last = changed, now
        if not self._grown(self._known, changed):
            self.stack.push(_Step(self, before, self._known, self._session))

    def _grown(self, after: Asked, changed: frozenset[str]) -> bool:
        """Let the last step become one with a change of the same movement; False when there is none."""
        # Qt would merge them itself, but of a step that is pushed and merged PySide6 never lets go, and a
        # drag has a dozen of them.
        stack, last = self.stack, self.stack.index() - 1
        step = stack.command(last) if 0 <= last == stack.count() - 1 else None
        if not isinstance(step, _Step) or step.session != self._session:
            return False
        if step.grow(after, changed):
            stack.undoTextChanged.emit(step.text())
        else:
            step.setObsolete(True)
            stack.undo()
        return True

    def _is_held(self) -> bool:
        """Whether a hand still holds something, or still types a name."""
        typing = self._form.start_field.hasFocus() or self._form.end_field.hasFocus()
        held = bool(QApplication.mouseButtons() & Qt.MouseButton.LeftButton)
        return held or (typing and bool(self._kind & {"start", "end"}))

    def take_over(self, other: History, renamed: Renamed) -> None:
        """Be able to take back what could be taken back in another window; nothing is asked anew."""
        given, stack, avoided = other.stack, self.stack, self._steering.avoided
        zones = avoided.zones
        self._is_copying = True
        try:
            for number in range(given.count()):
                step = given.command(number)
                if isinstance(step, _Step):
                    stack.push(step.again(self))
                elif isinstance(step, Change):
                    stack.push(step.again(avoided, renamed))
            stack.setIndex(given.index())
        finally:
            self._is_copying = False
        avoided.put(zones)
        self._session = other.session
        self._known = self._asked()

    @property
    def session(self) -> int:
        """Number of the last movement of the hand."""
        return self._session

    def put(self, asked: Asked, changed: frozenset[str]) -> None:
        """Let some fields ask what they did, and sail that, if there is a passage to follow from."""
        if self._is_copying:
            return
        form, steering = self._form, self._steering
        via = asked.via if "via" in changed else steering.via

        def fill() -> None:
            for which, name, port in (("from", "start", asked.start), ("to", "end", asked.end)):
                if name in changed and port is not None:
                    form.set_end(which, port)
                elif name in changed:
                    (form.start_field if which == "from" else form.end_field).clear()
            if "departure" in changed:
                form.departure.set_moment(asked.departure, chosen=asked.chosen)
            if "yacht" in changed:
                form.fill({"yacht": asked.yacht})
            if "options" in changed:
                form.sailing.put(asdict(asked.options))
            if "forecast" in changed:
                form.set_forecast(*asked.forecast)

        self._putting = True
        try:
            steering.ask_again(fill, via)
        finally:
            self._putting = False
        self._soon.stop()
        self._known = self._asked()
        self._kind = frozenset()
        steering.follow()


class StepAction(QAction):
    """Entry of a menu that names the step it would take.

    Parameters
    ----------
    back
        Undo; else redo.
    """

    def __init__(self, stack: QUndoStack, parent: QObject, *, back: bool) -> None:
        super().__init__(parent)
        self._back = back
        self._show_text("")
        self._show_enabled(False)
        # Bound methods: a stack that goes with its window tells nobody who has gone before it.
        if back:
            stack.undoTextChanged.connect(self._show_text)
            stack.canUndoChanged.connect(self._show_enabled)
            self.triggered.connect(stack.undo)
            self.setShortcut(QKeySequence("Ctrl+Z"))
        else:
            stack.redoTextChanged.connect(self._show_text)
            stack.canRedoChanged.connect(self._show_enabled)
            self.triggered.connect(stack.redo)
            self.setShortcuts([QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")])

    def _show_text(self, what: str) -> None:
        if self._back:
            self.setText(_tr("&Undo: {what}").format(what=what) if what else _tr("&Undo"))
        else:
            self.setText(_tr("&Redo: {what}").format(what=what) if what else _tr("&Redo"))

    def _show_enabled(self, on: bool) -> None:
        self.setEnabled(on)
