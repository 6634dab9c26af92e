"""Names and times on charts, which never lie over each other, over a waypoint or off the chart."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import shorten
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.export.chartwork import INK, MAGENTA, Frame, mercator
from seacruise.export.words import ENGLISH, Words
from seacruise.passage import Passage
from seacruise.ports import Port

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.text import Annotation
    from matplotlib.transforms import Bbox

_LABEL_GAP_PX: Final = 40.0
"""Of waypoints closer than this, as in a beat, one has its time written."""

_SIDES: Final = ((1, 0), (-1, 0), (0, 1), (0, -1))
_CORNERS: Final = ((1, 1), (-1, 1), (1, -1), (-1, -1))
_CLOSE_PX: Final = 4.0
"""The way is looked at this closely when a label must not lie over it."""

_CLEAR_PX: Final = 5.0
"""Room between a label and the way, its waypoints and other ports, which are more than points [pixels]."""

_MOST_PORTS: Final = 60
_AT_THE_END_DEG: Final = 0.05
"""A port so near to an end of the passage is that end."""

_PAPER: Final = {"boxstyle": "round,pad=0.15", "facecolor": "white", "alpha": 0.75, "linewidth": 0}


def free_sides(pixels: NDArray[np.float64], number: int) -> list[tuple[int, int]]:
    """Sides of a waypoint, the farthest from its legs first: right (1, 0), left, above (0, 1), below."""
    neighbours = pixels[[k for k in (number - 1, number + 1) if 0 <= k < len(pixels)]] - pixels[number]
    legs = neighbours / np.maximum(np.hypot(*neighbours.T), 1e-9)[:, None]
    return sorted(_SIDES, key=lambda side: float((legs @ np.array(side)).max()))


def draw_waypoints(
    axes: Axes, passage: Passage, taken: Sequence[Bbox] = (), words: Words = ENGLISH
) -> list[Bbox]:
    """Mark the waypoints; write names at the ends, and number and time wherever there is room for them.

    Parameters
    ----------
    taken
        Where other things lie [pixels].

    Returns
    -------
    list
        The same with the labels.
    """
    x = np.array([w.lon for w in passage.waypoints])
    y = mercator(np.array([w.lat for w in passage.waypoints]))
    axes.plot(
        x, y, "o", markersize=4.5, color="white", markeredgecolor=MAGENTA, markeredgewidth=1.3, zorder=8
    )
    pixels = axes.transData.transform(np.column_stack([x, y]))
    first, last = (shorten(place.name, 26, placeholder=" ...") for place in (passage.start, passage.end))
    ends = {0: first, len(x) - 1: last}
    way, boxes = _way(axes, passage), list(taken)
    labelled: list[int] = []
    for number in sorted(range(len(x)), key=lambda k: k not in ends):
        clock = words.clock(passage.waypoints[number].time)
        name = ends.get(number)
        near = np.hypot(*(pixels[labelled] - pixels[number]).T) < _LABEL_GAP_PX
        if name is None and near.any():
            continue
        label = axes.annotate(
            f"{name}\n{clock}" if name else f"{number}: {clock}",
            (x[number], y[number]),
            xytext=(0, 0),
            textcoords="offset points",
            fontsize=9 if name else 7.5,
            fontweight="bold" if name else "normal",
            color=INK,
            bbox=_PAPER,
            zorder=9,
        )
        sides = free_sides(pixels, number)
        box = _place(axes, label, (*sides, *_CORNERS), boxes, way)
        if box is None and name is not None:
            # the ends have their names whatever lies below
            box = _place(axes, label, (*sides, *_CORNERS), (), way[:0]) or _put(label, *sides[0])
        if box is None:
            label.remove()
        else:
            boxes.append(box)
            labelled.append(number)
    return boxes


def _way(axes: Axes, passage: Passage) -> NDArray[np.float64]:
    """Points of the sailed line, and the waypoints between, as close as labels need them [pixels]."""
    track = np.column_stack([passage.track.lon, mercator(passage.track.lat)])
    pixels = axes.transData.transform(track)
    run = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(pixels, axis=0).T))])
    at = np.linspace(0.0, run[-1], max(2, int(run[-1] / _CLOSE_PX)))
    return np.column_stack([np.interp(at, run, pixels[:, 0]), np.interp(at, run, pixels[:, 1])])


def draw_ports(
    axes: Axes, frame: Frame, passage: Passage, ports: Sequence[Port], taken: Sequence[Bbox]
) -> int:
    """Mark the ports that have room for their names, the nearest to the way first.

    A mark without a name helps nobody, and the coasts are full of them.

    Returns
    -------
    int
        How many are marked.
    """
    ends = ((passage.start.port_lat, passage.start.port_lon), (passage.end.port_lat, passage.end.port_lon))
    way, boxes, marked = _way(axes, passage), list(taken), 0
    near: list[tuple[float, float, float, str]] = []
    for port in ports:
        x, y = port.lon, float(mercator(port.lat))
        at_end = any(np.hypot(port.lat - lat, port.lon - lon) < _AT_THE_END_DEG for lat, lon in ends)
        if frame.holds(x, y) and not at_end:
            here = axes.transData.transform((x, y))
            near.append((float(np.hypot(*(way - here).T).min()), x, y, port.name))
    for _, x, y, name in sorted(near)[:_MOST_PORTS]:
        here = axes.transData.transform((x, y))
        if any(box.contains(*here) for box in boxes):
            continue
        label = axes.annotate(
            shorten(name, 24, placeholder="..."),
            (x, y),
            xytext=(0, 0),
            textcoords="offset points",
            fontsize=6.5,
            color=INK,
            bbox={**_PAPER, "boxstyle": "round,pad=0.05", "alpha": 0.6},
            zorder=4.5,
        )
        box = _place(axes, label, (*_SIDES, *_CORNERS), boxes, way, away=5)
        if box is None:
            label.remove()
            continue
        axes.plot(
            x, y, "s", markersize=2.6, color="white", markeredgecolor=INK, markeredgewidth=0.6, zorder=4
        )
        boxes.append(box)
        way = np.concatenate([way, [here]])
        marked += 1
    return marked


def _place(
    axes: Axes,
    label: Annotation,
    sides: Sequence[tuple[int, int]],
    taken: Sequence[Bbox],
    points: NDArray[np.float64],
    *,
    away: int = 9,
) -> Bbox | None:
    """Put a label on the first side on which it lies on the chart and over nothing else."""
    chart = axes.get_window_extent()
    for side in sides:
        box = _put(label, *side, away=away)
        inside = chart.x0 <= box.x0 and box.x1 <= chart.x1 and chart.y0 <= box.y0 and box.y1 <= chart.y1
        if inside and not box.count_overlaps(taken) and not box.padded(_CLEAR_PX).count_contains(points):
            return box
    return None


def _put(label: Annotation, right: int, above: int, *, away: int = 9) -> Bbox:
    """Put a text beside its point; returns where it lies [pixels]."""
    label.set_position((away * right, away * above))
    across: dict[int, Any] = {-1: "right", 0: "center", 1: "left"}
    upwards: dict[int, Any] = {-1: "top", 0: "center", 1: "bottom"}
    label.set_horizontalalignment(across[right])
    label.set_verticalalignment(upwards[above])
    return label.get_window_extent()
