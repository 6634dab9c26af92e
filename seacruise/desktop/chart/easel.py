"""How a frame of the chart is drawn: layer by layer while it rests, from a sheet while it moves."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, QRectF, QSizeF, QTimer
from PySide6.QtGui import QFont, QPainter, QPixmap, QTransform

from seacruise.desktop.chart.labels import Box, Labels, edges
from seacruise.desktop.chart.layer import Layer
from seacruise.desktop.chart.sheet import Group, Sheet, SheetPainter, State, blank

if TYPE_CHECKING:
    from seacruise.desktop.chart.graticule import DegreesLayer
    from seacruise.desktop.chart.ports_layer import PortsLayer
    from seacruise.desktop.chart.view import ChartView

_REST_S: Final = 0.12
"""A chart that has not moved for so long rests, and is drawn anew layer by layer."""

_CALM_MS: Final = 200
"""A chart on which nothing has changed for so long gets a sheet, for the next time it is moved."""

_IDLE_MS: Final = 5000
"""So long the memory of a sheet that is out of date is kept for the next one."""

_MARGIN: Final = 0.2
"""How much more than the view a sheet shows to each side."""

_SPARE: Final = 0.6
"""Share of the margin that must be left, or else the next sheet is begun."""

_BARE: Final = 0.15
"""How much of the view to each side may show no more than the coast for a moment, while it is zoomed out."""

_BLURRED: Final = 1.3
_TOO_BLURRED: Final = 1.7
"""How many times a sheet may be stretched before the next one is begun, and before it is not shown at all."""


@dataclass(frozen=True, slots=True)
class Stack:
    """Layers from below to above.

    Attributes
    ----------
    ground
        What changes by zooming only.
    weather
        What changes while time runs.
    lying
        What else lies on the chart.
    above
        What keeps its place on the screen, or moves while time runs; drawn anew in each frame.
    """

    ground: tuple[Layer, ...]
    weather: tuple[Layer, ...]
    lying: tuple[Layer, ...]
    above: tuple[Layer, ...]

    @property
    def layers(self) -> tuple[Layer, ...]:
        """All of them."""
        return (*self.ground, *self.weather, *self.lying, *self.above)


class Easel(QObject):
    """Draws the frames of a view.

    Parameters
    ----------
    ports, degrees
        Those of the layers that take places before anything is written.
    """

    def __init__(self, view: ChartView, stack: Stack, ports: PortsLayer, degrees: DegreesLayer) -> None:
        super().__init__(view)
        self._view, self._stack, self._ports, self._degrees = view, stack, ports, degrees
        self.labels = Labels()
        for layer in stack.layers:
            layer.labels = self.labels
            layer.on_update = view.viewport().update
        self._sheet: Sheet | None = None
        self._next: SheetPainter | None = None
        self._used: QPixmap | None = None
        self._weather = (*stack.ground, *stack.weather)
        self._under = Group(self._weather, opaque=True)
        self._over = Group(stack.lying, opaque=False)
        self._taken: Sequence[QRectF] = ()
        self._laid_around: list[Box] = []
        self._moved_at = -_REST_S
        self._rest = self._timer(round(1e3 * _REST_S) + 10, self._rested)
        self._calm = self._timer(_CALM_MS, self._calmed)
        self._work = self._timer(0, self._step)
        self._idle = self._timer(_IDLE_MS, self._forget_used)

    def _timer(self, interval_ms: int, call: object) -> QTimer:
        timer = QTimer(self)
        timer.setSingleShot(True)
        timer.setInterval(interval_ms)
        timer.timeout.connect(call)
        return timer

    # --- moving -------------------------------------------------------------------------------------

    @property
    def is_moving(self) -> bool:
        """Whether the chart was moved a moment ago."""
        return time.monotonic() - self._moved_at < _REST_S

    @property
    def has_sheet(self) -> bool:
        """Whether there is a sheet of what the chart shows now."""
        return self._sheet is not None and self._is_of_now(self._sheet, self._view.viewportTransform())

    def moved(self) -> None:
        """Tell that the chart has been moved or zoomed."""
        self._moved_at = time.monotonic()
        self._rest.start()

    def _forget_used(self) -> None:
        self._used = None

    def _rested(self) -> None:
        if self.is_moving:
            self._rest.start()
        else:
            self._view.viewport().update()

    # --- frames -------------------------------------------------------------------------------------

    def paint(self, painter: QPainter, taken: Sequence[QRectF]) -> None:
        """Draw a frame.

        Parameters
        ----------
        taken
            Places that lie under something else.
        """
        with self._view.coast.turns.drawing():
            self._paint(painter, taken)

    def _paint(self, painter: QPainter, taken: Sequence[QRectF]) -> None:
        to_pixels, room = self._view.viewportTransform(), QRectF(self._view.viewport().rect())
        sheet = self._fitting(to_pixels, room) if self.is_moving else None
        self._taken = taken
        self.labels.begin(room, taken)
        self._reserve(self.labels, painter.font(), to_pixels)
        self._degrees.reserve(painter.font(), to_pixels, room)
        if sheet is None:
            self._paint_groups(painter, to_pixels, room)
        else:
            if not sheet.place(to_pixels).contains(room):
                for layer in self._stack.ground:
                    layer.paint(painter, to_pixels, room)
            sheet.draw(painter, to_pixels)
        for layer in self._stack.above:
            layer.paint(painter, to_pixels, room)
        if not self.is_moving:
            self._calm.start()
        elif self._next is None and (sheet is None or not self._lasts(sheet, to_pixels, room)):
            self._prepare()

    def _paint_groups(self, painter: QPainter, to_pixels: QTransform, room: QRectF) -> None:
        """Paint what changes while time runs, and what does not; each from a picture while it stays so."""
        place = (to_pixels.m11(), to_pixels.dx(), to_pixels.dy(), room.width(), room.height())
        for group, layers in ((self._under, self._weather), (self._over, self._stack.lying)):
            state = (*self._state(layers), *place)
            group.paint(painter, to_pixels, room, state=state, keep=not self.is_moving)

    def _around(self) -> list[Box]:
        """Places that names were laid out around."""
        return [edges(place) for place in (*self._taken, *self.labels.kept.values())]

    def _calmed(self) -> None:
        """Lay names out anew around what has moved meanwhile, and get ready for being moved."""
        if self._around() != self._laid_around:
            self._laid_around = self._around()
            self._over.forget()
            self._view.viewport().update()
        else:
            self._prepare()

    def _reserve(self, labels: Labels, font: QFont, to_pixels: QTransform) -> None:
        self._ports.reserve(font, to_pixels, labels)

    # --- sheets -------------------------------------------------------------------------------------

    @property
    def _movable(self) -> tuple[Layer, ...]:
        return (*self._stack.weather, *self._stack.lying)

    def _state(self, layers: Sequence[Layer]) -> State:
        return (self._view.devicePixelRatioF(), *(float(layer.version) for layer in layers))

    def _fitting(self, to_pixels: QTransform, room: QRectF) -> Sheet | None:
        """Give the sheet, when it shows what the view would; its coast may be an older picture."""
        sheet = self._sheet
        if sheet is None or sheet.lying != self._state(self._movable):
            return None
        times = sheet.stretch(to_pixels)
        if not 1.0 / _TOO_BLURRED < times < _TOO_BLURRED:
            return None
        return sheet if sheet.place(to_pixels).contains(_wider(room, -_BARE)) else None

    def _lasts(self, sheet: Sheet, to_pixels: QTransform, room: QRectF) -> bool:
        """Tell whether a sheet will do for some more frames."""
        wide = _wider(room, _SPARE * _MARGIN)
        sharp = 1.0 / _BLURRED < sheet.stretch(to_pixels) < _BLURRED
        return (
            sharp
            and sheet.place(to_pixels).contains(wide)
            and sheet.ground == self._state(self._stack.ground)
        )

    def _is_of_now(self, sheet: Sheet, to_pixels: QTransform) -> bool:
        fresh = (sheet.ground, sheet.lying) == (self._state(self._stack.ground), self._state(self._movable))
        return fresh and abs(sheet.stretch(to_pixels) - 1.0) < 1e-9

    def _prepare(self) -> None:
        """Begin a sheet around the present view, unless there is one."""
        to_pixels, room = self._view.viewportTransform(), QRectF(self._view.viewport().rect())
        known = self._sheet
        if room.isEmpty() or not self._view.isVisible():
            return
        if known is not None and self._is_of_now(known, to_pixels) and self._lasts(known, to_pixels, room):
            return
        used = self._used if self._next is None else self._next.sheet.picture
        left, top = round(_MARGIN * room.width()), round(_MARGIN * room.height())
        size = QSizeF(room.width() + 2 * left, room.height() + 2 * top)
        sheet = Sheet(
            blank(size, self._view.devicePixelRatioF(), used),
            to_pixels * QTransform.fromTranslate(left, top),
            size,
            self._state(self._stack.ground),
            self._state(self._movable),
        )
        layers = (*self._stack.ground, *self._movable)
        self._next = SheetPainter(sheet, layers, self._view.viewport().font(), self._reserve)
        self._used = None
        self._work.start()

    def _step(self) -> None:
        """Paint a part of the next sheet; one of what is no longer so is given up."""
        work = self._next
        if work is None:
            return
        lying, ground = self._state(self._movable), self._state(self._stack.ground)
        if work.sheet.lying != lying or (work.sheet.ground != ground and not work.has(self._stack.ground)):
            self._next, self._used = None, work.sheet.picture
            self._calm.start()
            if work.sheet.lying == lying:
                self._prepare()
            return
        with self._view.coast.turns.drawing():
            done = work.step()
        if not done:
            self._work.start()
            return
        self._used = self._sheet.picture if self._sheet is not None else None
        self._idle.start()
        self._next, self._sheet = None, work.sheet


def _wider(room: QRectF, share: float) -> QRectF:
    """Rectangle wider and higher by a share of it to each side."""
    dx, dy = share * room.width(), share * room.height()
    return room.adjusted(-dx, -dy, dx, dy)
