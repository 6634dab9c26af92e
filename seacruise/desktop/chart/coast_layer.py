"""Depths, coast and lattice on the chart: the last picture at once, a fitting one once it is painted."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QPainter, QTransform

from seacruise.desktop.chart.basemap import Extent, Painter, Picture
from seacruise.desktop.chart.depth_layer import strength
from seacruise.desktop.chart.layer import Layer
from seacruise.desktop.chart.palette import Palette
from seacruise.desktop.chart.plane import point
from seacruise.desktop.chart.turns import PoliteJob, Turns
from seacruise.sea.depth import chart_depths

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from seacruise.desktop.jobs import JobRunner
    from seacruise.progress import Job

_MARGIN: Final = 0.3
"""How much more than the view is painted to each side, so that panning has something to show."""


class CoastLayer(Layer):
    """Shows pictures of coast and lattice.

    Parameters
    ----------
    runner
        Paints them; nothing else may use it.
    on_painted
        Called when there is a new picture.
    """

    by_strips = True

    def __init__(self, bounds: QRectF, runner: JobRunner, on_painted: Callable[[], None]) -> None:
        super().__init__(bounds)
        self.turns = Turns()
        self._runner = runner
        self._on_painted = on_painted
        self._painter = Painter()
        self._picture: Picture | None = None
        self._wanted: Extent | None = None
        self._lattice: Callable[[], NDArray[np.float32]] | None = None
        self._stale = True
        self._depths = False
        runner.finished.connect(self._painted)

    def show_lattice(self, edges: Callable[[], NDArray[np.float32]] | None) -> None:
        """Show the edges of a lattice ``(n, 4)``, or none; the worker that paints puts them together."""
        if edges != self._lattice:
            self._lattice = edges
            self._stale = True

    def show_depths(self, on: bool) -> None:
        """Tint the water by its depth, or not."""
        if on != self._depths:
            self._depths = on
            self._stale = True

    def set_palette(self, colours: Palette) -> None:
        """Paint anew in the colours of another light."""
        super().set_palette(colours)
        self._stale = True

    @property
    def is_up_to_date(self) -> bool:
        """Whether the picture is of the present view and lattice."""
        return self._picture is not None and not self._stale and not self._runner.is_running

    def covers(self, view: QRectF) -> bool:
        """Whether the picture there is shows all of a view of the plane, sharp or not."""
        return self._picture is not None and self._picture.extent.rectangle().contains(view)

    def band_at(self, lat: float, lon: float) -> int | None:
        """Band of depth with which a position [degrees] is tinted; ``None`` on land or without a tint."""
        picture = self._picture
        if picture is None or not self._depths or strength(picture.extent.scale) == 0.0:
            return None
        extent, at = picture.extent, point(lat, lon)
        column, row = (
            int(side * extent.scale * extent.density) for side in (at.x() - extent.left, at.y() - extent.top)
        )
        if not picture.image.valid(column, row) or picture.image.pixelColor(column, row) == self.colours.land:
            return None
        return chart_depths().band(lat, lon)

    def demand(self, view: QRectF, scale: float, size: tuple[int, int], density: float) -> None:
        """Ask for a picture of a view of the plane, unless there is one or it is being painted."""
        painted = self._picture.extent if self._picture else None
        current = self._wanted if self._runner.is_running else painted
        fits = (
            current is not None
            and abs(current.scale / scale - 1.0) < 1e-9
            and current.density == density
            and current.rectangle().contains(view)
        )
        if fits and not self._stale:
            return
        width, height = (round(side * (1 + 2 * _MARGIN)) for side in size)
        extent = Extent(
            left=view.center().x() - width / 2 / scale,
            top=view.center().y() - height / 2 / scale,
            scale=scale,
            width=width,
            height=height,
            density=density,
            colours=self.colours,
            depths=self._depths,
        )
        painter, lattice, turns = self._painter, self._lattice, self.turns
        self._wanted, self._stale = extent, False

        def work(job: Job) -> Any:
            edges = lattice() if lattice is not None else None
            return painter.paint(extent, edges, PoliteJob(job.report, job.cancel, turns))

        self._runner.run_job(work)

    def _painted(self, _generation: int, picture: Picture) -> None:
        self._picture = picture
        self.update()
        self._on_painted()

    def draw(self, painter: QPainter, to_pixels: QTransform, view: QRectF) -> None:
        """Draw the last picture where it belongs, stretched while a better one is painted."""
        if self._picture is None:
            painter.fillRect(view, self.colours.water)
            return
        extent = self._picture.extent
        corner = to_pixels.map(QPointF(extent.left, extent.top))
        stretch = to_pixels.m11() / extent.scale
        target = QRectF(corner.x(), corner.y(), extent.width * stretch, extent.height * stretch)
        if not target.contains(view):
            painter.fillRect(view, self.colours.water)
        if abs(stretch - 1.0) < 1e-9:
            painter.drawImage(QPointF(round(corner.x()), round(corner.y())), self._picture.image)
        else:
            painter.drawImage(target, self._picture.image)
