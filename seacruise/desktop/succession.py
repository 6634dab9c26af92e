"""Another language at once: a window in that language takes the place of the one that is open.

A window made anew has no stale word anywhere; what was asked, found, opened and running goes over to it.
"""

from __future__ import annotations

import os
import weakref
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import asdict, replace
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, QPointF, QRectF, QTimer
from PySide6.QtWidgets import QApplication, QWidget

from seacruise.desktop import language
from seacruise.desktop.avoid import Renamed, area_names
from seacruise.desktop.jobs import are_workers_left
from seacruise.desktop.messages import message_for
from seacruise.desktop.state import Phase
from seacruise.errors import NoPassageError, SeaCruiseError

if TYPE_CHECKING:
    from seacruise.desktop.chart.view import ChartView
    from seacruise.desktop.window import MainWindow


_CLEAR_MS: Final = 400
_LONGER: Final = 4
_PATIENCE_MS: Final = 60_000
"""What is left of a window is looked for after 0.4 s, then after ever longer times, at most after this."""


class Succession(QObject):
    """Knows the window that is open, and puts another in its place when a language is chosen.

    Parameters
    ----------
    app
        Speaks the language.
    window
        The first one.
    """

    def __init__(self, app: QApplication, window: MainWindow) -> None:
        super().__init__(app)
        self._app = app
        self.window = window
        self._clearing = QTimer(self)
        self._gone: Callable[[], MainWindow | None] = lambda: None
        self._clearing.timeout.connect(self._clear)
        self._watch(window)

    def _watch(self, window: MainWindow) -> None:
        # Not from within the menu of the window that goes.
        window.habits.language.chosen.connect(lambda: QTimer.singleShot(0, self.change))

    def change(self) -> None:
        """Speak the language that is wanted now."""
        old = self.window
        code = language.wanted(old.habits.memory)
        if code == language.current():
            self._explain(old)
            return
        old.habits.keep()
        before = area_names()
        language.speak(self._app, code)
        renamed = Renamed(dict(zip(before, area_names(), strict=True)))
        heir = self.window = old.heir()
        hand_over(old, heir, renamed)
        self._watch(heir)
        self._retire(old, heir)

    def _explain(self, window: MainWindow) -> None:
        chosen = language.chosen(window.habits.memory)
        if chosen and chosen != language.current() and os.environ.get("SEACRUISE_LANGUAGE"):
            text = self.tr("SEACRUISE_LANGUAGE decides on the language; the choice counts without it.")
            window.status.say(text, 8.0)

    def _retire(self, old: MainWindow, heir: MainWindow) -> None:
        old.retire()
        # Which gave collection back to Python.
        heir.garbage.start()
        old.deleteLater()
        self._gone = weakref.ref(old)
        self._clearing.start(_CLEAR_MS)

    def _clear(self) -> None:
        """Free what is left of a window once nobody works for it any more."""
        if are_workers_left():
            return
        self.window.garbage.renew()
        # Something on its way through Qt's queue may still know it.
        later = _LONGER * self._clearing.interval()
        if self._gone() is None or later > _PATIENCE_MS:
            self._clearing.stop()
        else:
            self._clearing.setInterval(later)


def hand_over(old: MainWindow, heir: MainWindow, renamed: Renamed) -> None:
    """Let a window go on where another one is, and show it in its place.

    Parameters
    ----------
    heir
        It remembers already what outlives the program: form, layers, units, tabs.
    """
    heir.load(known=old.background.found)
    _hand_over_question(old, heir, renamed)
    heir.planning.take_over(old.planning)
    heir.take_over(old)
    _say_refusal_again(heir)
    _hand_over_chart(old, heir)
    heir.status.show_quota(old.background.found.get("quota"))
    if old.habits.memory is not None:
        old.habits.memory.restore_geometry(heir, heir.splitter)
    heir.setGeometry(old.geometry())
    heir.setWindowState(old.windowState())
    heir.habits.columns.show_column(old.habits.columns.shown)
    heir.show()
    heir.planning.frame.take_over(old.planning.frame)
    heir.form.options_bar.take_over(old.form.options_bar)
    heir.desk.take_over(old.desk)
    if (guide := old.habits.guide) is not None and guide.isVisible():
        heir.habits.show_guide(guide.step)
    if old.isActiveWindow():
        heir.activateWindow()
        _hand_over_focus(old, heir)
    # Once the window is laid out, and the passage fitted.
    place = partial(_show_place, heir.chart.view, *_place_of(old.chart.view))
    QTimer.singleShot(0, partial(QTimer.singleShot, 0, place))


def _hand_over_question(old: MainWindow, heir: MainWindow, renamed: Renamed) -> None:
    """Let form and chart ask the same, and what was asked before be undone."""
    form, steering = old.form, old.steering
    with _quiet(heir):
        heir.form.sailing.put(asdict(form.options()))
        heir.form.departure.set_moment(form.departure.moment, chosen=form.departure.was_chosen)
        heir.steering.ask_again(lambda: None, steering.via)
        heir.steering.avoided.put(renamed(steering.avoided.zones))
        heir.history.take_over(old.history, renamed)


@contextmanager
def _quiet(window: MainWindow) -> Iterator[None]:
    """Sail nothing anew meanwhile."""
    enabled, window.steering.enabled = window.steering.enabled, False
    try:
        yield
    finally:
        window.steering.enabled = enabled


def _say_refusal_again(heir: MainWindow) -> None:
    """Say in the window's language what is wrong with the form: those sentences are the form's own."""
    if heir.state.phase is not Phase.FAILED:
        return
    try:
        heir.steering.question()
    except SeaCruiseError as error:
        heir.state = replace(heir.state, error=error)
        heir.say(partial(message_for, error))


def _hand_over_chart(old: MainWindow, heir: MainWindow) -> None:
    """Show the same moment, trouble and switches."""
    bar, answer, error = old.chart.time_bar, old.state.answer, old.state.error
    heir.chart.time_bar.set_departure(heir.form.departure.moment)
    if answer is not None:
        heir.chart.time_bar.set_moment(bar.moment)
        heir.chart.time_bar.play_button.setChecked(bar.play_button.isChecked())
    if old.state.phase is Phase.FAILED and isinstance(error, NoPassageError):
        heir.chart.view.trouble.mark(error.place)
    if old.steering.router.is_busy:
        heir.steering.follow()


def _hand_over_focus(old: MainWindow, heir: MainWindow) -> None:
    focused = old.focusWidget()
    parts = [(w.form, w.form.options_bar, w.chart) for w in (old, heir)]
    for mine, its in zip(*parts, strict=True):
        for name, widget in vars(mine).items():
            twin = vars(its).get(name)
            is_it = isinstance(widget, QWidget) and focused is not None
            if is_it and (widget is focused or widget.focusProxy() is focused) and isinstance(twin, QWidget):
                twin.setFocus()
                return


def _place_of(view: ChartView) -> tuple[float, QPointF]:
    """Tell the scale of a chart, and what is in its middle."""
    back, _ = view.viewportTransform().inverted()
    return view.transform().m11(), back.map(QRectF(view.viewport().rect()).center())


def _show_place(view: ChartView, scale: float, middle: QPointF) -> None:
    """Show the same part of the chart; where it does already, what was fitted stays so."""
    now, at = _place_of(view)
    pixels = (at - middle) * scale
    if abs(now / scale - 1.0) < 1e-6 and pixels.manhattanLength() < 3.0:
        return
    view.scale(scale / now, scale / now)
    view.centerOn(middle)
    view.zoom(1.0)
