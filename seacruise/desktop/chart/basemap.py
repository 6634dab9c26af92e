"""Picture of depths, coast and lattice for a view, painted on a worker thread in small steps.

`QPainter` keeps Python's lock while it fills a path: one coast of 140,000 points would hold the window
up for 0.9 s. Cell by cell it is a millisecond at a time.
"""

from __future__ import annotations

import math
import threading
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final, cast

import numpy as np
import shiboken6
from numpy.typing import NDArray
from PySide6.QtCore import QLineF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QImage, QPainter, QPainterPath, QPen, QPolygonF, QTransform

from seacruise.desktop.chart.depth_layer import DepthTints, pixels_of
from seacruise.desktop.chart.kept import Kept
from seacruise.desktop.chart.land import LandCells, Points, cell_box
from seacruise.desktop.chart.palette import DAY, Palette
from seacruise.desktop.chart.plane import CHARTED, to_plane
from seacruise.sea.coast import CHART_LEVELS

if TYPE_CHECKING:
    from seacruise.progress import Job

_CELL_PX: Final = 110.0
_DEEPEST: Final = 16
_LEAST_PX: Final = 1.8
_LEVEL_BELOW_M_PX: Final = (3600.0, 420.0)
"""Metres of the Mercator plane a pixel [m] above which level 0, and above which level 1 is fine enough."""

_MOST_ELEMENTS: Final = 300_000
"""Points of all paths that are kept, of 24 bytes each."""

_LINES_A_STEP: Final = 500
_INK_PER_PX: Final = 2.2


@dataclass(frozen=True, slots=True)
class Extent:
    """Part of the plane to be pictured, at a scale.

    Attributes
    ----------
    left, top
        Of the picture in the plane [m].
    scale
        Pixels (independent of the screen's density) per metre.
    width, height
        Pixels.
    density
        Physical pixels per pixel.
    colours
        Of the light there is.
    depths
        Whether the water is tinted by its depth.
    """

    left: float
    top: float
    scale: float
    width: int
    height: int
    density: float
    colours: Palette = DAY
    depths: bool = False

    def rectangle(self) -> QRectF:
        """Pictured rectangle of the plane."""
        return QRectF(self.left, self.top, self.width / self.scale, self.height / self.scale)


@dataclass(frozen=True, slots=True, eq=False)
class Picture:
    """A painted extent."""

    extent: Extent
    image: QImage


def polygon_of(ring: Points) -> QPolygonF:
    """Qt polygon of ``(n, 2)`` points, written in one piece: a list of `QPointF` takes fifty times that."""
    polygon = QPolygonF()
    polygon.resize(len(ring))
    if len(ring):
        # The stub knows one argument only; the second and third are the size and "writable".
        memory: Any = shiboken6.VoidPtr(cast("Any", polygon.data()), ring.size * 8, True)  # type: ignore[call-arg]
        np.frombuffer(memory, np.float64).reshape(-1, 2)[:] = ring
    return polygon


class Painter:
    """Paints extents; keeps the cut coast."""

    def __init__(self) -> None:
        # A superseded worker may still be in its last cell when the next one begins.
        self._lock = threading.Lock()
        self._levels = [LandCells(level) for level in range(CHART_LEVELS)]
        self._world = LandCells(None)
        self._depths = DepthTints()
        self._paths: Kept[tuple[int, int, int, int], QPainterPath] = Kept(
            _MOST_ELEMENTS, lambda path: 1 + path.elementCount()
        )

    def paint(self, extent: Extent, lattice: NDArray[np.float32] | None, job: Job) -> Picture:
        """Paint coast and, when given, the lattice ``(n, 4)`` of lat1, lon1, lat2, lon2 [degrees].

        Raises
        ------
        CancelledError
            Another view is wanted meanwhile.
        """
        with self._lock:
            return self._paint(extent, lattice, job)

    def _paint(self, extent: Extent, lattice: NDArray[np.float32] | None, job: Job) -> Picture:
        image = QImage(
            round(extent.width * extent.density),
            round(extent.height * extent.density),
            QImage.Format.Format_RGB32,
        )
        image.setDevicePixelRatio(extent.density)
        image.fill(extent.colours.uncharted)
        painter = QPainter(image)
        try:
            if not CHARTED.contains(extent.rectangle()):
                self._paint_land(painter, extent, self._world, 0, job)
            charted = pixels_of(extent, CHARTED)
            painter.fillRect(charted, extent.colours.water)
            if extent.depths:
                self._depths.paint(painter, extent, job)
            metres = 1.0 / extent.scale
            level = sum(metres < limit for limit in _LEVEL_BELOW_M_PX)
            self._paint_land(painter, extent, self._levels[level], level + 1, job)
            painter.setPen(QPen(extent.colours.uncharted_hatch, 1.0))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(charted)
            if lattice is not None:
                _paint_lattice(painter, extent, lattice, job)
        finally:
            painter.end()
        return Picture(extent, image)

    def _paint_land(self, painter: QPainter, extent: Extent, land: LandCells, key: int, job: Job) -> None:
        frame = land.frame
        depth = round(math.log2(max(frame.width() * extent.scale / _CELL_PX, 1.0)))
        depth = min(depth, _DEEPEST)
        pen = QPen(extent.colours.shore, 1.0)
        pen.setCosmetic(True)
        brush = QBrush(extent.colours.land)
        view = extent.rectangle()
        count = 2**depth
        columns = _span(view.left(), view.right(), frame.left(), frame.width() / count, count)
        rows = _span(view.top(), view.bottom(), frame.top(), frame.height() / count, count)
        for column in columns:
            for row in rows:
                job.check()
                west, north, east, south = cell_box(depth, column, row, frame)
                box = QRectF(west, north, east - west, south - north)
                if land is self._world and CHARTED.contains(box):
                    # The fine coast will cover it.
                    continue
                path = self._path(land, (key, depth, column, row))
                if path.isEmpty():
                    continue
                painter.resetTransform()
                painter.setRenderHint(QPainter.RenderHint.Antialiasing)
                painter.setClipRect(pixels_of(extent, box))
                painter.setTransform(
                    QTransform.fromTranslate(-extent.left, -extent.top)
                    * QTransform.fromScale(extent.scale, extent.scale)
                )
                painter.setPen(pen)
                painter.setBrush(brush)
                painter.drawPath(path)
        painter.setClipping(False)
        painter.resetTransform()

    def _path(self, land: LandCells, key: tuple[int, int, int, int]) -> QPainterPath:
        path = self._paths.get(key)
        if path is None:
            path = QPainterPath()
            _, depth, column, row = key
            # At this depth a cell is about `_CELL_PX` wide, whatever the zoom is exactly.
            least_m = _LEAST_PX * land.frame.width() / 2**depth / _CELL_PX
            for ring in land.cell(depth, column, row).split(least_m):
                path.addPolygon(polygon_of(ring))
                path.closeSubpath()
            self._paths.put(key, path)
        return path


def _span(low: float, high: float, origin: float, size: float, count: int) -> range:
    return range(
        max(0, math.floor((low - origin) / size)), min(count, math.floor((high - origin) / size) + 1)
    )


def _paint_lattice(painter: QPainter, extent: Extent, lattice: NDArray[np.float32], job: Job) -> None:
    edges = np.asarray(lattice, dtype=np.float64)
    x1, y1 = to_plane(edges[:, 0], edges[:, 1])
    x2, y2 = to_plane(edges[:, 2], edges[:, 3])
    lines = np.stack((x1 - extent.left, y1 - extent.top, x2 - extent.left, y2 - extent.top), axis=1)
    lines *= extent.scale
    right, bottom = float(extent.width), float(extent.height)
    seen = (
        (np.maximum(lines[:, 0], lines[:, 2]) >= 0)
        & (np.minimum(lines[:, 0], lines[:, 2]) <= right)
        & (np.maximum(lines[:, 1], lines[:, 3]) >= 0)
        & (np.minimum(lines[:, 1], lines[:, 3]) <= bottom)
    )
    lines = lines[seen]
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    ink = QColor(extent.colours.lattice)
    # Where edges are hardly longer than they are apart from the next, full ink would be a blue wall.
    length = (
        float(np.median(np.hypot(lines[:, 2] - lines[:, 0], lines[:, 3] - lines[:, 1])))
        if len(lines)
        else 0.0
    )
    ink.setAlpha(round(min(max(_INK_PER_PX * length, 9.0), float(ink.alpha()))))
    painter.setPen(QPen(ink, 1.0))
    for begin in range(0, len(lines), _LINES_A_STEP):
        job.check()
        painter.drawLines([QLineF(*line) for line in lines[begin : begin + _LINES_A_STEP].tolist()])
