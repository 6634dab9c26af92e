"""Depth tint: a few bands of blue under the coast, painted into its picture and so free while panning.

The grid behind it is one of 9 km. So nothing that looks like a sounding is ever written, edges are soft, and
close to the ground, where a cell of the grid would fill a harbour, the tint gives way to plain water.
"""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QCoreApplication, QRect, QRectF
from PySide6.QtGui import QImage, QPainter

from seacruise.desktop.chart.palette import Palette
from seacruise.desktop.chart.plane import CHARTED
from seacruise.geodesy import from_mercator
from seacruise.sea.depth import ALL_LAND_M, BAND_LIMITS_M, chart_depths

if TYPE_CHECKING:
    from seacruise.desktop.chart.basemap import Extent
    from seacruise.progress import Job

_COLUMNS: Final = 1584
"""Of the tints' picture: six to a cell of the grid, so that bands blend softly when it is enlarged."""

_ROWS_A_STEP: Final = 24
_PIXELS_A_STEP: Final = 48
_REST_S: Final = 0.0005
"""Between two steps the window's thread gets Python's lock; else it would wait for it at each call."""

_TABLE_LIMITS_M: Final = (ALL_LAND_M, *BAND_LIMITS_M)
"""Lakes far from the sea are not tinted: the grid has no depths of theirs."""

_FAINT_M_PX: Final = 90.0
_FULL_M_PX: Final = 280.0
"""Metres of the plane a pixel [m] at which the tint is gone, and from which it is drawn in full."""


def strength(scale: float) -> float:
    """Strength of the tint at a scale [pixels per metre of the plane], 0 to 1."""
    return min(max((1.0 / scale - _FAINT_M_PX) / (_FULL_M_PX - _FAINT_M_PX), 0.0), 1.0)


class DepthTints:
    """Paints the tints; keeps their picture, which is made once for each light, step by step.

    What was made before a job is cancelled is kept for the next.
    """

    def __init__(self) -> None:
        rows = round(_COLUMNS * CHARTED.height() / CHARTED.width())
        self._bands = np.zeros((rows, _COLUMNS), dtype=np.uint8)
        self._known = 0
        self._colours: Palette | None = None
        self._pixels = np.zeros((rows, _COLUMNS), dtype=np.uint32)
        self._painted = 0

    def paint(self, painter: QPainter, extent: Extent, job: Job) -> None:
        """Tint what an extent shows of the charted water.

        Raises
        ------
        CancelledError
            Another view is wanted meanwhile.
        """
        charted = pixels_of(extent, CHARTED).intersected(QRect(0, 0, extent.width, extent.height))
        if strength(extent.scale) == 0.0 or charted.isEmpty():
            return
        self._prepare(extent.colours, job)
        whole = QRectF(
            (CHARTED.left() - extent.left) * extent.scale,
            (CHARTED.top() - extent.top) * extent.scale,
            CHARTED.width() * extent.scale,
            CHARTED.height() * extent.scale,
        )
        rows = len(self._pixels)
        # Not copied: the pixels must outlive the picture, and do.
        picture = QImage(self._pixels.data, _COLUMNS, rows, 4 * _COLUMNS, QImage.Format.Format_RGB32)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.setOpacity(strength(extent.scale))
        try:
            for top in range(charted.top(), charted.bottom() + 1, _PIXELS_A_STEP):
                _rest(job)
                strip = QRect(charted.left(), top, charted.width(), _PIXELS_A_STEP)
                painter.setClipRect(strip.intersected(charted))
                painter.drawImage(whole, picture)
        finally:
            painter.setOpacity(1.0)
            painter.setClipping(False)

    def _prepare(self, colours: Palette, job: Job) -> None:
        """Make what is missing of the picture for a light."""
        rows = len(self._bands)
        if colours is not self._colours:
            self._colours, self._painted = colours, 0
        table = np.array([colour.rgba() for colour in (colours.water, *colours.depths)], dtype=np.uint32)
        while self._painted < rows:
            _rest(job)
            part = slice(self._painted, min(self._painted + _ROWS_A_STEP, rows))
            if part.start >= self._known:
                self._bands[part] = _bands_of(part, rows)
                self._known = part.stop
            self._pixels[part] = table[self._bands[part]]
            self._painted = part.stop


def _rest(job: Job) -> None:
    job.check()
    time.sleep(_REST_S)


def _bands_of(part: slice, rows: int) -> NDArray[np.uint8]:
    """Bands of some rows of the picture."""
    x = CHARTED.left() + CHARTED.width() / _COLUMNS * (np.arange(_COLUMNS) + 0.5)
    y = CHARTED.top() + CHARTED.height() / rows * (np.arange(part.start, part.stop) + 0.5)
    lat, _ = from_mercator(np.zeros_like(y), -y)
    _, lon = from_mercator(x, np.zeros_like(x))
    return np.searchsorted(_TABLE_LIMITS_M, chart_depths().on(lat, lon), side="right").astype(np.uint8)


def pixels_of(extent: Extent, area: QRectF) -> QRect:
    """Whole pixels of an extent's picture that a rectangle of the plane covers."""
    left, right = (round((x - extent.left) * extent.scale) for x in (area.left(), area.right()))
    top, bottom = (round((y - extent.top) * extent.scale) for y in (area.top(), area.bottom()))
    return QRect(left, top, right - left, bottom - top)


def band_name(number: int) -> str:
    """Span of a band for the legend [m]."""
    low, high = _span(number)
    if low is None:
        return f"< {high:.0f}"
    return f"> {low:.0f}" if high is None else f"{low:.0f}–{high:.0f}"


def band_text(number: int, *, brief: bool = False) -> str:
    """Words for the tint under the pointer: no sounding, and not for navigation."""
    low, high = _span(number)
    if low is None:
        text = _tr("tint under about {metres:.0f} m").format(metres=high)
    elif high is None:
        text = _tr("tint over about {metres:.0f} m").format(metres=low)
    else:
        text = _tr("tint about {low:.0f}–{high:.0f} m").format(low=low, high=high)
    why = _tr("{tint} (coarse)") if brief else _tr("{tint} (coarse, not for navigation)")
    return why.format(tint=text)


def _span(number: int) -> tuple[float | None, float | None]:
    bounds = (None, *BAND_LIMITS_M, None)
    return bounds[number], bounds[number + 1]


def _tr(text: str) -> str:
    return QCoreApplication.translate("depth", text)
