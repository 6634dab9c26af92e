"""Members of an ensemble: the fastest passage in each as a thin line, and where the boat is in each."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen, QPolygonF, QTransform

from seacruise.desktop.chart.basemap import polygon_of
from seacruise.desktop.chart.labels import Label, around
from seacruise.desktop.chart.layer import Layer, draw_dot, text_width
from seacruise.desktop.chart.plane import point, to_plane
from seacruise.desktop.style import scaled_font

if TYPE_CHECKING:
    from seacruise.alternatives import Passing
    from seacruise.desktop.chart.route_layer import RouteLayer
    from seacruise.members import Bundle, Member
    from seacruise.passage import Passage

LINE_PX: Final = 1.0
"""Wider lines, and those that let the ground through, take Qt ten times as long: 51 of them are a frame."""

DOT_PX: Final = 3.0


@dataclass(frozen=True, slots=True, eq=False)
class _Drawn:
    """A passage in the plane [m]: its legs, and where she is at each time."""

    line: QPolygonF
    time: NDArray[np.float64]
    track: NDArray[np.float64]


class MembersLayer(Layer):
    """Lines of the members, under the passage; where they part about an island, how many go where.

    Parameters
    ----------
    route
        The passage, which no figure may cover.
    """

    def __init__(self, bounds: QRectF, route: RouteLayer) -> None:
        super().__init__(bounds)
        self._route = route
        self.bundle: Bundle | None = None
        self._drawn: dict[Member, _Drawn] = {}

    def show_bundle(self, bundle: Bundle | None) -> None:
        """Show the members that are known, or none."""
        if bundle is self.bundle:
            return
        self.bundle = bundle
        # They come one by one; what is there need not be made again.
        before, self._drawn = self._drawn, {}
        for member in () if bundle is None else bundle.members:
            if member.passage is not None:
                self._drawn[member] = before.get(member) or _drawn(member.passage)
        self.update()

    def boats_at(self, time: float) -> NDArray[np.float64]:
        """Positions ``(n, 2)`` in the plane [m] of all members at a time [s since 1970-01-01T00:00Z]."""
        places = [
            [np.interp(time, one.time, one.track[:, 0]), np.interp(time, one.time, one.track[:, 1])]
            for one in self._drawn.values()
        ]
        return np.array(places, dtype=np.float64).reshape(-1, 2)

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw the lines, and write the figures."""
        del view
        if self.bundle is None:
            return
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(self.colours.member, LINE_PX))
        for one in self._drawn.values():
            painter.drawPolyline(to_pixels.map(one.line))
        painter.setFont(scaled_font(painter.font(), 0.9))
        for split in self.bundle.splits:
            for passing in split.passing:
                self._write(painter, passing, to_pixels)

    def _write(self, painter: QPainter, passing: Passing, to_pixels: QTransform) -> None:
        assert self.bundle is not None
        text = QCoreApplication.translate("members", "{n} of {total} members").format(
            n=passing.count, total=len(self.bundle.members)
        )
        at = to_pixels.map(point(passing.lat, passing.lon))
        size = (text_width(painter.font(), text), float(painter.fontMetrics().height()))
        right, left, above, below = around(at, *size, 10.0)
        # Away from the island first, and never across it: there go the others.
        places = {
            "east": (right, above, below),
            "west": (left, above, below),
            "north": (above, right, left),
            "south": (below, right, left),
        }[passing.side]
        place = self.labels.claim(*(one for one in places if not self._route.touches(one, to_pixels)))
        if place is not None:
            base = QPointF(place.left(), place.top() + painter.fontMetrics().ascent())
            self.labels.write(Label(painter.font(), base, text, self.colours.member))


class MemberBoatsLayer(Layer):
    """A dot for each member where she is at the slider's time.

    Parameters
    ----------
    members, route
        Know the members, and the time.
    """

    def __init__(self, bounds: QRectF, members: MembersLayer, route: RouteLayer) -> None:
        super().__init__(bounds)
        self._members, self._route = members, route

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw the dots that are in view."""
        time = self._route.time
        if self._members.bundle is None or time is None:
            return
        for x, y in self._members.boats_at(time).tolist():
            at = to_pixels.map(QPointF(x, y))
            if view.contains(at):
                draw_dot(painter, at, DOT_PX, self.colours.member, self.colours.casing)


def _drawn(passage: Passage) -> _Drawn:
    lat, lon = np.array([[waypoint.lat, waypoint.lon] for waypoint in passage.waypoints]).T
    track = passage.track
    return _Drawn(
        polygon_of(np.stack(to_plane(lat, lon), axis=1)),
        track.time,
        np.stack(to_plane(track.lat, track.lon), axis=1),
    )
