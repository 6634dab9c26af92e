"""What charts on paper and in pictures are made of: frame, land, graticule, barbs, the passage, scale."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.geodesy import great_circle_m
from seacruise.passage import Passage
from seacruise.sea.coast import FINE_EAST, FINE_NORTH, FINE_SOUTH, FINE_WEST, chart_land, world_land
from seacruise.units import METRES_PER_NM, MS_PER_KNOT

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.collections import LineCollection
    from matplotlib.figure import Figure
    from matplotlib.path import Path as Outline
    from matplotlib.transforms import Bbox

    from seacruise.weather.wind import Wind

DPI: Final = 150
_LONG_SIDE_IN: Final = 11.0
_SHORT_SIDE_IN: Final = 8.5

LEFT_IN, RIGHT_IN, BOTTOM_IN, TOP_IN = 0.8, 1.0, 0.95, 1.15
"""Room on the sheet around the chart [inches]: latitudes, colours, notices, title."""

# After IHO S-52, day: buff land, pale water, magenta for what the navigator adds.
WATER = "#e6f1f7"
LAND = "#f2e3b8"
SHORE = "#8a7a4d"
_GRATICULE = "#a9bcc8"
INK = "#1d2b36"
_BARBS = "#5b6f7d"
MAGENTA = "#b0006e"

_OVERLAP: Final = 0.002
"""The coarse coast reaches so far below the fine one, as a part of the chart."""

_STEPS_MIN: Final = (1, 2, 5, 10, 15, 30, 60, 120, 300, 600)
_BARS_NM: Final = (0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500)


@dataclass(frozen=True, slots=True)
class Frame:
    """What the chart shows: degrees of longitude and of Mercator latitude, and the size of the sheet."""

    west: float
    east: float
    low: float
    high: float
    width_in: float
    height_in: float

    @property
    def span(self) -> float:
        """Longer side of the chart [degrees of longitude]."""
        return max(self.east - self.west, self.high - self.low)

    def holds(self, x: float, y: float) -> bool:
        """Tell whether the chart shows a place."""
        return self.west < x < self.east and self.low < y < self.high


def mercator(lat: float | NDArray[np.float64]) -> NDArray[np.float64]:
    """Latitude [degrees] as a Mercator ordinate in the unit of degrees of longitude."""
    return np.asarray(np.degrees(np.arcsinh(np.tan(np.radians(lat)))))


def latitude(ordinate: float | NDArray[np.float64]) -> NDArray[np.float64]:
    """Latitude [degrees] of a Mercator ordinate."""
    return np.asarray(np.degrees(np.arctan(np.sinh(np.radians(ordinate)))))


def frame_of(lon: NDArray[np.float64], lat: NDArray[np.float64]) -> Frame:
    """Fit the sheet round positions [degrees]: upright or across, with room for the labels."""
    x, y = lon, mercator(lat)
    west, east, low, high = float(x.min()), float(x.max()), float(y.min()), float(y.max())
    upright = high - low > east - west
    width_in, height_in = (_SHORT_SIDE_IN, _LONG_SIDE_IN) if upright else (_LONG_SIDE_IN, _SHORT_SIDE_IN)
    shape = (width_in - LEFT_IN - RIGHT_IN) / (height_in - TOP_IN - BOTTOM_IN)
    margin = 0.15 * max(east - west, high - low, 0.15)
    wide, tall = east - west + 2 * margin, high - low + 2 * margin
    middle = (west + east) / 2, (low + high) / 2
    return framed(middle, max(wide, tall * shape), max(tall, wide / shape), (width_in, height_in))


def framed(middle: tuple[float, float], wide: float, tall: float, sheet_in: tuple[float, float]) -> Frame:
    """Make the frame of a sheet of width and height [in] around its middle, ``wide`` by ``tall`` degrees."""
    x, y = middle
    return Frame(
        west=x - wide / 2,
        east=x + wide / 2,
        low=y - tall / 2,
        high=y + tall / 2,
        width_in=sheet_in[0],
        height_in=sheet_in[1],
    )


def canvas(frame: Frame) -> tuple[Figure, Axes]:
    """Make the sheet of a picture, and on it the place of the chart."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(frame.width_in, frame.height_in), dpi=DPI, facecolor="white")
    width = 1.0 - (LEFT_IN + RIGHT_IN) / frame.width_in
    height = 1.0 - (TOP_IN + BOTTOM_IN) / frame.height_in
    axes = figure.add_axes((LEFT_IN / frame.width_in, BOTTOM_IN / frame.height_in, width, height))
    axes.set_facecolor(WATER)
    axes.set_xlim(frame.west, frame.east)
    axes.set_ylim(frame.low, frame.high)
    axes.set_aspect("equal")
    axes.tick_params(labelsize=8, colors=INK, length=3)
    for spine in axes.spines.values():
        spine.set_color(INK)
    return figure, axes


def draw_land(axes: Axes, frame: Frame) -> list[Outline]:
    """Fill the land and return its outlines: the fine coast, and beyond it what routing knows there."""
    level = 0 if frame.span > 16.0 else 1 if frame.span > 2.5 else 2
    low, high = float(mercator(FINE_SOUTH)), float(mercator(FINE_NORTH))
    fine = Frame(
        max(frame.west, FINE_WEST), min(frame.east, FINE_EAST), max(frame.low, low), min(frame.high, high),
        frame.width_in, frame.height_in,
    )  # fmt: skip
    has_fine = fine.west < fine.east and fine.low < fine.high
    outlines: list[Outline] = []
    if fine != frame:
        for part in _around(frame, fine) if has_fine else [frame]:
            outlines += _fill_land(axes, world_land(), part)
    # over the coarse one, which reaches a little below it: two fills that just meet show a seam
    return outlines + _fill_land(axes, chart_land(level), fine) if has_fine else outlines


def _around(frame: Frame, inner: Frame) -> list[Frame]:
    """Parts of a frame that lie outside of another one within it, and a little of that."""
    size, over = (frame.width_in, frame.height_in), _OVERLAP * frame.span
    parts = [
        (inner.west > frame.west, (frame.west, inner.west + over, frame.low, frame.high)),
        (inner.east < frame.east, (inner.east - over, frame.east, frame.low, frame.high)),
        (inner.low > frame.low, (inner.west, inner.east, frame.low, inner.low + over)),
        (inner.high < frame.high, (inner.west, inner.east, inner.high - over, frame.high)),
    ]
    return [Frame(*edges, *size) for is_there, edges in parts if is_there]


def _fill_land(axes: Axes, land: Iterable[Sequence[NDArray[np.float64]]], frame: Frame) -> list[Outline]:
    """Fill the land within a frame and draw its shores, but no line where it is cut."""
    from matplotlib.collections import PathCollection
    from matplotlib.path import Path as Outline

    outlines, shores = [], []
    for rings in land:
        shore = rings[0]
        y = mercator(shore[:, 1])
        if (
            shore[:, 0].max() < frame.west
            or shore[:, 0].min() > frame.east
            or y.max() < frame.low
            or y.min() > frame.high
        ):
            continue
        projected = [np.column_stack([ring[:, 0], mercator(ring[:, 1])]) for ring in rings]
        cut = [_turned(part, k > 0) for k, ring in enumerate(projected) if len(part := _cut(ring, frame)) > 3]
        if cut:
            outlines.append(Outline.make_compound_path(*(Outline(ring, closed=True) for ring in cut)))
            shores += [Outline(ring, _pen(ring, frame)) for ring in cut]
    inside = {"autolim": False}
    axes.add_collection(PathCollection(outlines, facecolors=LAND, linewidths=0, zorder=2), **inside)
    lines = PathCollection(shores, facecolors="none", edgecolors=SHORE, linewidths=0.4, zorder=2.1)
    axes.add_collection(lines, **inside)
    return outlines


def _pen(ring: NDArray[np.float64], frame: Frame) -> NDArray[np.uint8]:
    """Tell the pen for each point of a ring: lifted along the edges of the frame, drawing otherwise."""
    from matplotlib.path import Path as Outline

    x, y = ring.T
    edges = ((x, frame.west), (x, frame.east), (y, frame.low), (y, frame.high))
    lifted = np.zeros(len(ring), dtype=bool)
    for values, edge in edges:
        on = np.abs(values - edge) < 1e-9 * max(1.0, abs(edge))
        lifted[1:] |= on[1:] & on[:-1]
    lifted[0] = True
    return np.where(lifted, Outline.MOVETO, Outline.LINETO).astype(np.uint8)


def _cut(ring: NDArray[np.float64], frame: Frame) -> NDArray[np.float64]:
    """Cut a closed ring at the edges of the chart: a whole continent would make a file of a megabyte.

    After Sutherland and Hodgman (1974), one edge after the other; pieces that fall apart stay joined along
    the edge, which filling does not mind.
    """
    edges = ((0, frame.west, 1.0), (0, frame.east, -1.0), (1, frame.low, 1.0), (1, frame.high, -1.0))
    for axis, limit, sign in edges:
        depth = sign * (ring[:, axis] - limit)
        if len(ring) == 0 or (depth >= 0.0).all():
            continue
        before, there = np.roll(depth[:-1], 1), depth[:-1]
        here, to = np.roll(ring[:-1], 1, axis=0), ring[:-1]
        crosses = (before >= 0.0) != (there >= 0.0)
        share = np.where(crosses, before / np.where(crosses, before - there, 1.0), 0.0)
        # each vertex may be preceded by the place where the edge to it meets the limit
        both = np.stack([here + share[:, None] * (to - here), to], axis=1).reshape(-1, 2)
        ring = both[np.stack([crosses, there >= 0.0], axis=1).ravel()]
        ring = np.concatenate([ring, ring[:1]])
    return ring


def _turned(ring: NDArray[np.float64], lake: bool) -> NDArray[np.float64]:
    """Turn shores and lakes opposite ways: the renderer fills by winding, not by even and odd."""
    x, y = ring[:, 0], ring[:, 1]
    anticlockwise = float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])) > 0
    return ring if anticlockwise != lake else ring[::-1]


def draw_graticule(axes: Axes, frame: Frame) -> None:
    """Draw meridians and parallels, and write their degrees at the edges."""
    south, north = float(latitude(frame.low)), float(latitude(frame.high))
    meridians = nice_ticks(frame.west, frame.east)
    parallels = nice_ticks(south, north)
    axes.set_xticks(meridians, [degrees(value, "E", "W") for value in meridians])
    axes.set_yticks(mercator(np.array(parallels)), [degrees(value, "N", "S") for value in parallels])
    axes.grid(color=_GRATICULE, linewidth=0.5, zorder=1)


def nice_ticks(low: float, high: float) -> list[float]:
    """Whole degrees or minutes between two limits, four to nine of them."""
    step = next((s for s in _STEPS_MIN if (high - low) * 60 / s <= 8), _STEPS_MIN[-1])
    first, last = math.ceil(low * 60 / step), math.floor(high * 60 / step)
    return [k * step / 60 for k in range(first, last + 1)]


def degrees(value: float, positive: str, negative: str) -> str:
    """Write a latitude or longitude to the minute, as charts do: ``54°30'N``."""
    minutes = round(abs(value) * 60)
    part = f"{minutes // 60}°{minutes % 60:02d}'" if minutes % 60 else f"{minutes // 60}°"
    return f"{part}{positive if value >= 0 else negative}"


def draw_barbs(axes: Axes, frame: Frame, wind: Wind, time: datetime, land: list[Outline]) -> None:
    """Barbs about 60 pixels apart, at sea only, where the forecast has a figure."""
    columns = max(4, round(frame.width_in * 0.8 * DPI / 75))
    step = (frame.east - frame.west) / columns
    x = np.arange(frame.west + step / 2, frame.east, step)
    # half a barb at the upper edge would be a stroke without meaning
    y = np.arange(frame.low + step / 2, frame.high - step / 3, step)
    places = np.array([(a, b) for b in y for a in x])
    lat, lon = latitude(places[:, 1]), places[:, 0]
    shown = wind.covers(lat, lon)
    for outline in land:
        box = outline.get_extents()
        near = shown & (places >= box.min).all(axis=1) & (places <= box.max).all(axis=1)
        if near.any():
            shown[near] &= ~outline.contains_points(places[near])
    if not shown.any():
        return
    u, v = wind.at(time.timestamp(), lat[shown], lon[shown])
    axes.barbs(
        places[shown, 0],
        places[shown, 1],
        u / MS_PER_KNOT,
        v / MS_PER_KNOT,
        length=5.0,
        linewidth=0.6,
        color=_BARBS,
        flip_barb=lat[shown] < 0,
        sizes={"emptybarb": 0.12},
        zorder=3,
    )


def draw_passage(axes: Axes, passage: Passage, *, under_engine: str = "under engine") -> LineCollection:
    """Draw the sailed line over a dark seam, so that its colours hold on water and on land.

    Where the engine runs a white line of dashes lies in it, which is there without colours too.
    """
    from matplotlib.collections import LineCollection
    from matplotlib.colors import Normalize

    track = passage.track
    points = np.column_stack([track.lon, mercator(track.lat)])
    segments = np.stack([points[:-1], points[1:]], axis=1)
    tws = (track.tws_kn[:-1] + track.tws_kn[1:]) / 2
    axes.plot(points[:, 0], points[:, 1], color=INK, linewidth=5.2, solid_capstyle="round", zorder=5)
    # viridis keeps its order for every kind of colour vision and in print.
    line = LineCollection(
        list(segments),
        cmap="viridis",
        norm=Normalize(*_fives(track.tws_kn)),
        linewidths=3.4,
        capstyle="round",
        zorder=6,
    )
    line.set_array(tws)
    axes.add_collection(line, autolim=False)
    if track.motor.any():
        y = np.where(track.motor, points[:, 1], np.nan)
        axes.plot(
            points[:, 0],
            y,
            color="white",
            linewidth=1.2,
            dashes=(3, 3),
            zorder=7,
            label=under_engine,
        )
        axes.legend(loc="upper left", fontsize=8, facecolor=INK, labelcolor="white", framealpha=0.85)
    return line


def _fives(values: NDArray[np.float64]) -> tuple[float, float]:
    """Multiples of five that enclose the values."""
    low = math.floor(float(values.min()) / 5) * 5
    return low, max(low + 5, math.ceil(float(values.max()) / 5) * 5)


def draw_scale_bar(axes: Axes, frame: Frame, *, unit: str = "nm") -> Bbox:
    """Draw a bar in nautical miles, true at its own latitude; returns where it lies [pixels]."""
    from matplotlib.transforms import Bbox

    y = frame.low + 0.035 * (frame.high - frame.low)
    lat = float(latitude(y))
    nm_per_degree = float(great_circle_m(lat, 0.0, lat, 1.0)) / METRES_PER_NM
    room_nm = 0.25 * (frame.east - frame.west) * nm_per_degree
    length_nm = max((nm for nm in _BARS_NM if nm <= room_nm), default=_BARS_NM[0])
    x0 = frame.west + 0.04 * (frame.east - frame.west)
    length = length_nm / nm_per_degree
    halves = ((0.0, "white"), (0.5, INK))
    axes.plot([x0, x0 + length], [y, y], color=INK, linewidth=5, solid_capstyle="butt", zorder=10)
    for begin, colour in halves:
        ends = [x0 + begin * length, x0 + (begin + 0.5) * length]
        axes.plot(ends, [y, y], color=colour, linewidth=3, solid_capstyle="butt", zorder=11)
    label = axes.annotate(
        f"{length_nm:g} {unit}",
        (x0 + length / 2, y),
        xytext=(0, 5),
        textcoords="offset points",
        horizontalalignment="center",
        fontsize=8,
        color=INK,
        zorder=11,
    )
    bar = Bbox(axes.transData.transform([[x0, y], [x0 + length, y]]))
    return Bbox.union([bar, label.get_window_extent()])
