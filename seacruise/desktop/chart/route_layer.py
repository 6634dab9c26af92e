"""The passage on the chart: coloured by wind, with its waypoints, the chosen leg, and the boat."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING, Final

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPainterPath, QPen, QPolygonF, QTransform

from seacruise.desktop.chart import palette
from seacruise.desktop.chart.layer import Layer
from seacruise.desktop.chart.plane import point, to_plane

if TYPE_CHECKING:
    from seacruise.passage import Passage

_PICK_PX: Final = 10.0


class RouteLayer(Layer):
    """A passage; fainter when it is not of the latest calculation."""

    def __init__(self, bounds: QRectF) -> None:
        super().__init__(bounds)
        self._passage: Passage | None = None
        self._pieces: list[tuple[int, bool, QPolygonF]] = []
        self._legs: list[QPolygonF] = []
        self._waypoints: list[QPointF] = []
        self._direct = QPolygonF()
        self._plane = np.empty((0, 2))
        self._leg: int | None = None
        self._boat: tuple[QPointF, float] | None = None
        self.faded = False

    def show_passage(self, passage: Passage | None) -> None:
        """Show a passage, or none."""
        self._passage = passage
        self._leg, self._boat, self._pieces, self._legs, self._waypoints = None, None, [], [], []
        if passage is not None:
            track = passage.track
            self._plane = np.stack(to_plane(track.lat, track.lon), axis=1)
            self._pieces = self._coloured_pieces(passage)
            corners = [point(w.lat, w.lon) for w in passage.waypoints]
            self._waypoints = corners
            self._legs = [QPolygonF([a, b]) for a, b in pairwise(corners)]
            self._direct = QPolygonF([corners[0], corners[-1]])
        self.update()

    def _coloured_pieces(self, passage: Passage) -> list[tuple[int, bool, QPolygonF]]:
        """Find the runs of the track that share a colour, and whether they are under engine."""
        classes = np.searchsorted(palette.WIND_LIMITS_KN, passage.track.tws_kn, side="right")
        motor = passage.track.motor.astype(np.int64)
        changes = np.flatnonzero((np.diff(classes) != 0) | (np.diff(motor) != 0)) + 1
        bounds = [0, *changes.tolist(), len(classes) - 1]
        pieces = []
        for begin, end in pairwise(bounds):
            if end <= begin:
                continue
            line = QPolygonF([QPointF(x, y) for x, y in self._plane[begin : end + 1].tolist()])
            pieces.append((int(classes[begin]), bool(motor[begin]), line))
        return pieces

    def choose_leg(self, number: int | None) -> None:
        """Mark the leg that begins at a waypoint."""
        self._leg = number
        self.update()

    def place_boat(self, time: float) -> None:
        """Put the boat where she is at a time [s since 1970-01-01T00:00Z]."""
        if self._passage is None:
            return
        track = self._passage.track
        x = float(np.interp(time, track.time, self._plane[:, 0]))
        y = float(np.interp(time, track.time, self._plane[:, 1]))
        now = int(np.clip(np.searchsorted(track.time, time, side="right") - 1, 0, len(track.time) - 1))
        self._boat = (QPointF(x, y), float(track.course_deg[now]))
        self.update()

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

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw direct line, track, waypoints and boat, from below to above."""
        del view
        if self._passage is not None:
            painter.setOpacity(0.45 if self.faded else 1.0)
            self._draw_direct(painter, to_pixels)
            self._draw_track(painter, to_pixels)
            self._draw_waypoints(painter, to_pixels)
            if self._boat is not None:
                self._draw_boat(painter, to_pixels.map(self._boat[0]), self._boat[1])
            painter.setOpacity(1.0)

    def _draw_direct(self, painter: QPainter, to_pixels: QTransform) -> None:
        pen = QPen(palette.MAGENTA, 1.3, Qt.PenStyle.CustomDashLine)
        pen.setDashPattern([5.0, 5.0])
        painter.setPen(pen)
        painter.drawPolyline(to_pixels.map(self._direct))

    def _draw_track(self, painter: QPainter, to_pixels: QTransform) -> None:
        def stroke(line: QPolygonF, pen: QPen) -> None:
            pen.setCapStyle(Qt.PenCapStyle.RoundCap)
            pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
            path = QPainterPath()
            path.addPolygon(to_pixels.map(line))
            painter.strokePath(path, pen)

        if self._leg is not None and self._leg < len(self._legs):
            stroke(self._legs[self._leg], QPen(palette.MAGENTA, 13.0))
        for _, _, line in self._pieces:
            stroke(line, QPen(palette.PORT, 7.0))
        for number, _, line in self._pieces:
            stroke(line, QPen(palette.WIND_COLOURS[number], 4.6))
        for _, motor, line in self._pieces:
            if motor:
                dots = QPen(palette.CASING, 2.0, Qt.PenStyle.CustomDashLine)
                dots.setDashPattern([0.1, 4.0])
                stroke(line, dots)

    def _draw_waypoints(self, painter: QPainter, to_pixels: QTransform) -> None:
        painter.setPen(QPen(palette.MAGENTA, 1.6))
        painter.setBrush(palette.CASING)
        last: QPointF | None = None
        for place in self._waypoints[1:-1]:
            at = to_pixels.map(place)
            # Tacks lie close together: where they would be a row of beads, some are left out.
            if last is not None and math.hypot(at.x() - last.x(), at.y() - last.y()) < 9.0:
                continue
            painter.drawEllipse(at, 3.3, 3.3)
            last = at

    def _draw_boat(self, painter: QPainter, at: QPointF, course_deg: float) -> None:
        painter.save()
        painter.translate(at)
        painter.rotate(course_deg)
        hull = QPainterPath(QPointF(0.0, -13.0))
        hull.quadTo(QPointF(6.0, -6.0), QPointF(5.2, 3.0))
        hull.lineTo(3.6, 11.0)
        hull.lineTo(-3.6, 11.0)
        hull.lineTo(-5.2, 3.0)
        hull.quadTo(QPointF(-6.0, -6.0), QPointF(0.0, -13.0))
        painter.strokePath(hull, QPen(palette.CASING, 4.0))
        painter.fillPath(hull, palette.MAGENTA)
        painter.setPen(QPen(palette.CASING, 1.4))
        painter.drawLine(QPointF(0, -6), QPointF(0, 7))
        painter.restore()


class TroubleLayer(Layer):
    """Where a calculation found no way on; above everything else."""

    def __init__(self, bounds: QRectF) -> None:
        super().__init__(bounds)
        self._place: QPointF | None = None

    def mark(self, place: tuple[float, float] | None) -> None:
        """Mark a position [degrees], or nothing."""
        self._place = None if place is None else point(*place)
        self.update()

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw a ring with a cross."""
        del view
        if self._place is None:
            return
        at = to_pixels.map(self._place)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for colour, width in ((palette.CASING, 6.0), (palette.TROUBLE, 2.6)):
            painter.setPen(QPen(colour, width))
            painter.drawEllipse(at, 13.0, 13.0)
            painter.drawLine(at + QPointF(-5, -5), at + QPointF(5, 5))
            painter.drawLine(at + QPointF(-5, 5), at + QPointF(5, -5))
