"""The passage on the chart: coloured, with its nights, its waypoints, the chosen leg, and the boat."""

from __future__ import annotations

import math
from dataclasses import dataclass
from datetime import UTC, datetime
from itertools import pairwise
from typing import TYPE_CHECKING, Final

import numpy as np
from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QPolygonF, QTransform

from seacruise.desktop.chart.basemap import polygon_of
from seacruise.desktop.chart.labels import Label, around
from seacruise.desktop.chart.layer import Layer, draw_dot, text_width
from seacruise.desktop.chart.palette import dimmed
from seacruise.desktop.chart.plane import point, to_plane
from seacruise.desktop.chart.schemes import SCHEMES, Scheme
from seacruise.desktop.daylight import Light, light_along, spans, sun_events
from seacruise.desktop.style import scaled_font
from seacruise.desktop.units_choice import clock_text

if TYPE_CHECKING:
    from seacruise.passage import Passage

_PICK_PX: Final = 10.0
_NIGHT_PX: Final = 19.0
_FADED: Final = 0.45


@dataclass(frozen=True, slots=True, eq=False)
class _Piece:
    """Run of the track that is drawn alike: a class of the colours, or of the light."""

    number: int
    motor: bool
    line: QPolygonF


class RouteLayer(Layer):
    """A passage; fainter when it is not of the latest calculation."""

    def __init__(self, bounds: QRectF) -> None:
        super().__init__(bounds)
        self._passage: Passage | None = None
        self._scheme = SCHEMES["tws"]
        self._pieces: list[_Piece] = []
        self._nights: list[_Piece] = []
        self._suns: list[tuple[QPointF, str, bool]] = []
        self._legs: list[QPolygonF] = []
        self._waypoints: list[QPointF] = []
        self._direct = QPolygonF()
        self._whole = QPolygonF()
        self._plane = np.empty((0, 2))
        self._corners = np.empty(0, dtype=np.int64)
        self._leg: int | None = None
        self.boat: tuple[QPointF, float] | None = None
        self.time: float | None = None
        self._faded = False
        self._nights_shown = True

    def show_passage(self, passage: Passage | None) -> None:
        """Show a passage, or none."""
        self._passage = passage
        self._leg, self.boat, self._legs, self._waypoints = None, None, [], []
        self._pieces, self._nights, self._suns = [], [], []
        if passage is not None:
            track = passage.track
            self._plane = np.stack(to_plane(track.lat, track.lon), axis=1)
            self._corners = np.flatnonzero(np.diff(track.leg)) + 1
            self._whole = self._line(0, len(track.time) - 1)
            self._pieces = self._coloured_pieces(passage)
            self._nights = self._dark_pieces(passage)
            self._suns = _sun_marks(passage)
            corners = [point(w.lat, w.lon) for w in passage.waypoints]
            self._waypoints = corners
            self._legs = [QPolygonF([a, b]) for a, b in pairwise(corners)]
            self._direct = QPolygonF([corners[0], corners[-1]])
        self.update()

    def tell_again(self) -> None:
        """Write the times of sunrise and sunset in the zone that was chosen."""
        if self._passage is not None:
            self._suns = _sun_marks(self._passage)
            self.update()

    def show_scheme(self, scheme: Scheme) -> None:
        """Give the colours another meaning."""
        self._scheme = scheme
        if self._passage is not None:
            self._pieces = self._coloured_pieces(self._passage)
        self.update()

    @property
    def faded(self) -> bool:
        """Whether the passage is not of the latest calculation."""
        return self._faded

    @faded.setter
    def faded(self, on: bool) -> None:
        if on != self._faded:
            self._faded = on
            self.update()

    @property
    def nights_shown(self) -> bool:
        """Whether the parts that are sailed in the dark are told from others."""
        return self._nights_shown

    @nights_shown.setter
    def nights_shown(self, on: bool) -> None:
        if on != self._nights_shown:
            self._nights_shown = on
            self.update()

    @property
    def scheme(self) -> Scheme:
        """What the colours mean."""
        return self._scheme

    def _coloured_pieces(self, passage: Passage) -> list[_Piece]:
        """Find the runs of the track that share a colour, and whether they are under engine."""
        classes = self._scheme.classes(passage.track)
        both = 2 * classes + passage.track.motor
        return [
            _Piece(number // 2, bool(number % 2), self._line(begin, end))
            for number, begin, end in spans(both)
        ]

    def _line(self, begin: int, end: int) -> QPolygonF:
        """Part of the track between two samples; legs are straight, so their inner samples are left out."""
        inner = self._corners[(self._corners > begin) & (self._corners < end)]
        return polygon_of(self._plane[[begin, *inner.tolist(), end]])

    def _dark_pieces(self, passage: Passage) -> list[_Piece]:
        return [
            _Piece(light, False, self._line(begin, end))
            for light, begin, end in spans(light_along(passage.track))
            if light != Light.DAY
        ]

    def choose_leg(self, number: int | None) -> None:
        """Mark the leg that begins at a waypoint."""
        self._leg = number
        self.update()

    def place_boat(self, time: float) -> None:
        """Put the boat where she is at a time [s since 1970-01-01T00:00Z]."""
        self.time = time
        if self._passage is None:
            return
        track = self._passage.track
        x = float(np.interp(time, track.time, self._plane[:, 0]))
        y = float(np.interp(time, track.time, self._plane[:, 1]))
        now = int(np.clip(np.searchsorted(track.time, time, side="right") - 1, 0, len(track.time) - 1))
        self.boat = (QPointF(x, y), float(track.course_deg[now]))

    def leg_at(self, at: QPointF, to_pixels: QTransform) -> int | None:
        """Leg of the track that passes closest to a point [pixels], when it is near enough to be meant."""
        if self._passage is None:
            return None
        x = to_pixels.m11() * self._plane[:, 0] + to_pixels.dx()
        y = to_pixels.m22() * self._plane[:, 1] + to_pixels.dy()
        ax, ay, dx, dy = x[:-1], y[:-1], np.diff(x), np.diff(y)
        share = np.clip(((at.x() - ax) * dx + (at.y() - ay) * dy) / np.maximum(dx**2 + dy**2, 1e-9), 0.0, 1.0)
        gap = np.hypot(ax + share * dx - at.x(), ay + share * dy - at.y())
        nearest = int(np.argmin(gap))
        return int(self._passage.track.leg[nearest]) if gap[nearest] <= _PICK_PX else None

    def touches(self, box: QRectF, to_pixels: QTransform) -> bool:
        """Whether the track leads through a box [pixels]."""
        if self._passage is None:
            return False
        x = to_pixels.m11() * self._plane[:, 0] + to_pixels.dx()
        y = to_pixels.m22() * self._plane[:, 1] + to_pixels.dy()
        within = (x > box.left()) & (x < box.right()) & (y > box.top()) & (y < box.bottom())
        return bool(within.any())

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw direct line, track and waypoints, from below to above."""
        del view
        if self._passage is not None:
            painter.setOpacity(_FADED if self._faded else 1.0)
            self._draw_direct(painter, to_pixels)
            self._draw_track(painter, to_pixels)
            self._draw_waypoints(painter, to_pixels)
            if self._nights_shown:
                self._draw_suns(painter, to_pixels)
            painter.setOpacity(1.0)

    def _draw_direct(self, painter: QPainter, to_pixels: QTransform) -> None:
        pen = QPen(self.colours.magenta, 1.0, Qt.PenStyle.CustomDashLine)
        pen.setDashPattern([5.0, 5.0])
        painter.setPen(pen)
        painter.drawPolyline(to_pixels.map(self._direct))

    def _draw_track(self, painter: QPainter, to_pixels: QTransform) -> None:
        def stroke(line: QPolygonF, pen: QPen, cap: Qt.PenCapStyle = Qt.PenCapStyle.RoundCap) -> None:
            pen.setCapStyle(cap)
            pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
            path = QPainterPath()
            path.addPolygon(to_pixels.map(line))
            painter.strokePath(path, pen)

        if self._nights_shown:
            for piece in self._nights:
                shade = QColor(self.colours.night)
                if piece.number == Light.TWILIGHT:
                    shade.setAlpha(shade.alpha() // 2)
                stroke(piece.line, QPen(shade, _NIGHT_PX), Qt.PenCapStyle.FlatCap)
        if self._leg is not None and self._leg < len(self._legs):
            stroke(self._legs[self._leg], QPen(self.colours.magenta, 13.0))
        stroke(self._whole, QPen(self.colours.keel, 7.0))
        for piece in self._pieces:
            stroke(piece.line, QPen(dimmed(self._scheme.colours[piece.number], self.colours), 4.6))
        for piece in self._pieces:
            if piece.motor:
                dots = QPen(self.colours.casing, 2.0, Qt.PenStyle.CustomDashLine)
                dots.setDashPattern([0.1, 4.0])
                stroke(piece.line, dots)

    def _draw_waypoints(self, painter: QPainter, to_pixels: QTransform) -> None:
        last: QPointF | None = None
        for place in self._waypoints[1:-1]:
            at = to_pixels.map(place)
            # Tacks lie close together: where they would be a row of beads, some are left out.
            if last is not None and math.hypot(at.x() - last.x(), at.y() - last.y()) < 9.0:
                continue
            draw_dot(painter, at, 3.3, self.colours.casing, self.colours.magenta)
            last = at

    def _draw_suns(self, painter: QPainter, to_pixels: QTransform) -> None:
        """Draw a sun half above the horizon where it rises or sets, and when."""
        before = painter.font()
        painter.setFont(scaled_font(before, 0.9))
        height = painter.fontMetrics().height()
        for place, text, rises in self._suns:
            at = to_pixels.map(place)
            painter.setPen(QPen(self.colours.casing, 1.4))
            painter.setBrush(self.colours.sun if rises else self.colours.keel)
            painter.drawEllipse(at, 6.0, 6.0)
            painter.setBrush(self.colours.keel if rises else self.colours.sun)
            painter.drawChord(QRectF(at.x() - 6, at.y() - 6, 12, 12), 180 * 16, 180 * 16)
            width = text_width(painter.font(), text)
            places = around(at, width, height, 14.0)
            beside = [place for place in places if not self.touches(place, to_pixels)]
            label = self.labels.claim(*(beside or places))
            if label is not None:
                base = QPointF(label.left(), label.top() + painter.fontMetrics().ascent())
                self.labels.write(Label(painter.font(), base, text, self.colours.sun))
        painter.setFont(before)


def _sun_marks(passage: Passage) -> list[tuple[QPointF, str, bool]]:
    words = {
        "sunrise": QCoreApplication.translate("route", "sunrise {time}"),
        "sunset": QCoreApplication.translate("route", "sunset {time}"),
    }
    return [
        (
            point(event.lat, event.lon),
            words[event.kind].format(time=clock_text(datetime.fromtimestamp(event.time, UTC))),
            event.kind == "sunrise",
        )
        for event in sun_events(passage.track)
    ]


class BoatLayer(Layer):
    """The boat where she is at the slider's time; apart from the route, which stays as it is while time runs.

    Parameters
    ----------
    route
        Knows where she is.
    """

    def __init__(self, bounds: QRectF, route: RouteLayer) -> None:
        super().__init__(bounds)
        self._route = route

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw her hull, heading as she sails."""
        del view
        if self._route.boat is None:
            return
        place, course_deg = self._route.boat
        painter.setOpacity(_FADED if self._route.faded else 1.0)
        painter.translate(to_pixels.map(place))
        painter.rotate(course_deg)
        hull = QPainterPath(QPointF(0.0, -13.0))
        hull.quadTo(QPointF(6.0, -6.0), QPointF(5.2, 3.0))
        hull.lineTo(3.6, 11.0)
        hull.lineTo(-3.6, 11.0)
        hull.lineTo(-5.2, 3.0)
        hull.quadTo(QPointF(-6.0, -6.0), QPointF(0.0, -13.0))
        painter.strokePath(hull, QPen(self.colours.casing, 4.0))
        painter.fillPath(hull, self.colours.magenta)
        painter.setPen(QPen(self.colours.casing, 1.4))
        painter.drawLine(QPointF(0, -6), QPointF(0, 7))


_MARK_PX: Final = 16.0


class TroubleLayer(Layer):
    """Where a calculation found no way on; above everything else."""

    def __init__(self, bounds: QRectF) -> None:
        super().__init__(bounds)
        self._place: QPointF | None = None

    def mark(self, place: tuple[float, float] | None) -> None:
        """Mark a position [degrees], or nothing."""
        self._place = None if place is None else point(*place)
        self.update()

    def taken(self, to_pixels: QTransform) -> list[QRectF]:
        """Place of the mark in pixels, which no name may take."""
        if self._place is None:
            return []
        at = to_pixels.map(self._place)
        return [QRectF(at.x() - _MARK_PX, at.y() - _MARK_PX, 2 * _MARK_PX, 2 * _MARK_PX)]

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw a ring with a cross."""
        del view
        if self._place is None:
            return
        at = to_pixels.map(self._place)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for colour, width in ((self.colours.casing, 6.0), (self.colours.trouble, 2.6)):
            painter.setPen(QPen(colour, width))
            painter.drawEllipse(at, _MARK_PX - 3.0, _MARK_PX - 3.0)
            painter.drawLine(at + QPointF(-5, -5), at + QPointF(5, 5))
            painter.drawLine(at + QPointF(-5, 5), at + QPointF(5, -5))
