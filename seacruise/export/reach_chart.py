"""What is reached, on a chart: lines of equal time, and the ports that fit."""

from __future__ import annotations

import io
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from seacruise.atomic import write_atomically
from seacruise.export.chartwork import (
    INK,
    LEFT_IN,
    MAGENTA,
    RIGHT_IN,
    canvas,
    draw_graticule,
    draw_land,
    draw_scale_bar,
    frame_of,
    mercator,
)
from seacruise.export.textform import NOTICE, format_day_time, format_duration
from seacruise.reach import Reach

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_LABEL_PX: Final = (160.0, 14.0)
"""Room that the label of a port takes [pixels]."""


def reach_chart(reached: Reach) -> bytes:
    """Draw what is reached and return the PNG.

    Each line bounds the water reached within its hours; land covers what of it lies ashore. Ports from
    which she is back in time are filled.
    """
    points = [(port.lat, port.lon) for port in reached.ports] + [(reached.start.lat, reached.start.lon)]
    rings = [ring for line in reached.isochrones for polygon in line.polygons for ring in polygon]
    lat, lon = np.concatenate([np.array(points), *rings]).T
    frame = frame_of(lon, lat)
    figure, axes = canvas(frame)
    draw_land(axes, frame)
    draw_graticule(axes, frame)
    _draw_lines(axes, reached)
    _draw_ports(axes, reached)
    draw_scale_bar(axes, frame)
    _write_texts(figure, reached)
    picture = io.BytesIO()
    figure.savefig(picture, format="png", metadata={"Software": "SeaCruise"})
    return picture.getvalue()


def write_reach_chart(reached: Reach, path: Path) -> None:
    """Write `reach_chart` to a file.

    Raises
    ------
    InputError
        The file cannot be written.
    """
    write_atomically(path, reach_chart(reached), what="chart")


def _draw_lines(axes: Axes, reached: Reach) -> None:
    """Fill the water from the longest time to the shortest, so that each band keeps its colour."""
    from matplotlib import colormaps
    from matplotlib.collections import PathCollection
    from matplotlib.patches import Patch
    from matplotlib.path import Path as Outline

    colours = colormaps["viridis"](np.linspace(0.95, 0.25, len(reached.isochrones)))
    handles = []
    for line, colour in reversed(list(zip(reached.isochrones, colours, strict=True))):
        outlines = [
            Outline.make_compound_path(
                *(Outline(np.column_stack([r[:, 1], mercator(r[:, 0])]), closed=True) for r in polygon)
            )
            for polygon in line.polygons
        ]
        axes.add_collection(
            PathCollection(outlines, facecolors=[colour], edgecolors="white", linewidths=0.6, zorder=1.5),
            autolim=False,
        )
        handles.append(Patch(facecolor=colour, label=format_duration(line.hours)))
    axes.legend(handles=handles[::-1], loc="lower right", fontsize=8, title="Reached within").set_zorder(12)


def _draw_ports(axes: Axes, reached: Reach) -> None:
    """Mark every port; write name and time where there is room for them."""
    labelled: list[Any] = []
    for port in reached.ports:
        face = MAGENTA if port.return_fits else "white"
        x, y = port.lon, float(mercator(port.lat))
        axes.plot(x, y, "o", markersize=4, color=face, markeredgecolor=MAGENTA, zorder=8)
        at = axes.transData.transform((x, y))
        if any(
            abs(at[0] - other[0]) < _LABEL_PX[0] and abs(at[1] - other[1]) < _LABEL_PX[1]
            for other in labelled
        ):
            continue
        labelled.append(at)
        axes.annotate(
            f"{port.port.name} {format_duration(port.out_h)}",
            (x, y),
            xytext=(4, 2),
            textcoords="offset points",
            fontsize=5.5,
            color=INK,
            zorder=9,
        )
    here = reached.start.lon, float(mercator(reached.start.lat))
    axes.plot(*here, "*", markersize=12, color=MAGENTA, markeredgecolor="white", zorder=10)


def _write_texts(figure: Figure, reached: Reach) -> None:
    width, height = figure.get_figwidth(), figure.get_figheight()
    count = sum(port.return_fits for port in reached.ports)
    head = f"From {reached.start.name}: {len(reached.ports)} ports within {format_duration(reached.hours)}"
    facts = (
        f"{reached.yacht}   |   from {format_day_time(reached.departure)} UTC   |   "
        f"{count} of them out and back (filled)"
    )
    figure.text(LEFT_IN / width, 1.0 - 0.42 / height, head, fontsize=15, color=INK)
    figure.text(LEFT_IN / width, 1.0 - 0.82 / height, facts, fontsize=9, color=INK)
    wind = f"Wind: {reached.forecast.source}"
    figure.text(LEFT_IN / width, 0.40 / height, wind, fontsize=8, color=INK)
    figure.text(LEFT_IN / width, 0.17 / height, NOTICE, fontsize=8, color=MAGENTA, fontweight="bold")
    coast = "Coast: (c) OpenStreetMap contributors, ODbL, Baltic only."
    right = 1.0 - RIGHT_IN / width
    figure.text(right, 0.17 / height, coast, fontsize=7, color=INK, horizontalalignment="right")
