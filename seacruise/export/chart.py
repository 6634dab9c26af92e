"""The passage on a chart, as a PNG: what one hangs up or sends to the crew."""

from __future__ import annotations

import io
import math
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from textwrap import shorten
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.atomic import write_atomically
from seacruise.export.textform import NOTICE, format_day_time, format_duration, manoeuvres, title, to_minute
from seacruise.geodesy import great_circle_m
from seacruise.passage import Passage
from seacruise.sea.coast import FINE_EAST, FINE_NORTH, FINE_SOUTH, FINE_WEST, chart_land
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

_LEFT_IN, _RIGHT_IN, _BOTTOM_IN, _TOP_IN = 0.8, 1.0, 0.95, 1.15
"""Room on the sheet around the chart [inches]: latitudes, colours, notices, title."""

# After IHO S-52, day: buff land, pale water, magenta for what the navigator adds.
_WATER = "#e6f1f7"
_LAND = "#f2e3b8"
_SHORE = "#8a7a4d"
_GRATICULE = "#a9bcc8"
_INK = "#1d2b36"
_BARBS = "#5b6f7d"
_MAGENTA = "#b0006e"

_LABEL_GAP_PX: Final = 40.0
"""Of waypoints closer than this, as in a beat, one has its time written."""

_STEPS_MIN: Final = (1, 2, 5, 10, 15, 30, 60, 120, 300, 600)
_BARS_NM: Final = (0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500)


def chart(passage: Passage, *, wind: Wind | None = None) -> bytes:
    """Draw a passage and return the PNG.

    Land is the coast that the passage was checked against, thinned for the scale. The line of the passage
    is coloured by the true wind met at each place; barbs show the wind of the whole sea half-way through.

    Parameters
    ----------
    wind
        Source of the barbs; without it there are none.
    """
    frame = _frame(passage.track.lon, passage.track.lat)
    figure, axes = _canvas(frame)
    land = _draw_land(axes, frame)
    _draw_graticule(axes, frame)
    middle = passage.departure + (passage.arrival - passage.departure) / 2
    if wind is not None:
        _draw_barbs(axes, frame, wind, middle, land)
    line = _draw_passage(axes, passage)
    _draw_waypoints(axes, passage)
    _draw_scale_bar(axes, frame)
    _write_texts(figure, passage, middle if wind is not None else None)
    _draw_colours(figure, line)
    picture = io.BytesIO()
    # No version and no date in the file: the same passage gives the same picture.
    figure.savefig(picture, format="png", metadata={"Software": "SeaCruise"})
    return picture.getvalue()


def write_chart(passage: Passage, path: Path, *, wind: Wind | None = None) -> None:
    """Write `chart` to a file.

    Raises
    ------
    InputError
        The file cannot be written.
    """
    write_atomically(path, chart(passage, wind=wind), what="chart")


@dataclass(frozen=True, slots=True)
class _Frame:
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


def _mercator(lat: float | NDArray[np.float64]) -> NDArray[np.float64]:
    """Latitude [degrees] as a Mercator ordinate in the unit of degrees of longitude."""
    return np.asarray(np.degrees(np.arcsinh(np.tan(np.radians(lat)))))


def _latitude(ordinate: float | NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(np.degrees(np.arctan(np.sinh(np.radians(ordinate)))))


def _frame(lon: NDArray[np.float64], lat: NDArray[np.float64]) -> _Frame:
    """Fit the sheet round positions [degrees]: upright or across, with room for the labels."""
    x, y = lon, _mercator(lat)
    west, east, low, high = float(x.min()), float(x.max()), float(y.min()), float(y.max())
    upright = high - low > east - west
    width_in, height_in = (_SHORT_SIDE_IN, _LONG_SIDE_IN) if upright else (_LONG_SIDE_IN, _SHORT_SIDE_IN)
    shape = (width_in - _LEFT_IN - _RIGHT_IN) / (height_in - _TOP_IN - _BOTTOM_IN)
    margin = 0.15 * max(east - west, high - low, 0.15)
    wide, tall = east - west + 2 * margin, high - low + 2 * margin
    wide, tall = max(wide, tall * shape), max(tall, wide / shape)
    middle_x, middle_y = (west + east) / 2, (low + high) / 2
    return _Frame(
        west=middle_x - wide / 2,
        east=middle_x + wide / 2,
        low=middle_y - tall / 2,
        high=middle_y + tall / 2,
        width_in=width_in,
        height_in=height_in,
    )


def _canvas(frame: _Frame) -> tuple[Figure, Axes]:
    from matplotlib.figure import Figure

    figure = Figure(figsize=(frame.width_in, frame.height_in), dpi=DPI, facecolor="white")
    width = 1.0 - (_LEFT_IN + _RIGHT_IN) / frame.width_in
    height = 1.0 - (_TOP_IN + _BOTTOM_IN) / frame.height_in
    axes = figure.add_axes((_LEFT_IN / frame.width_in, _BOTTOM_IN / frame.height_in, width, height))
    axes.set_facecolor(_WATER)
    axes.set_xlim(frame.west, frame.east)
    axes.set_ylim(frame.low, frame.high)
    axes.set_aspect("equal")
    axes.tick_params(labelsize=8, colors=_INK, length=3)
    for spine in axes.spines.values():
        spine.set_color(_INK)
    return figure, axes


def _draw_land(axes: Axes, frame: _Frame) -> list[Outline]:
    """Fill the land and return its outlines; say where the coast is not known."""
    from matplotlib.collections import PathCollection
    from matplotlib.patches import Rectangle
    from matplotlib.path import Path as Outline

    level = 0 if frame.span > 16.0 else 1 if frame.span > 2.5 else 2
    outlines = []
    for rings in chart_land(level):
        shore = rings[0]
        y = _mercator(shore[:, 1])
        if (
            shore[:, 0].max() < frame.west
            or shore[:, 0].min() > frame.east
            or y.max() < frame.low
            or y.min() > frame.high
        ):
            continue
        projected = [
            _turned(np.column_stack([r[:, 0], _mercator(r[:, 1])]), k > 0) for k, r in enumerate(rings)
        ]
        outlines.append(Outline.make_compound_path(*(Outline(r, closed=True) for r in projected)))
    axes.add_collection(
        PathCollection(outlines, facecolors=_LAND, edgecolors=_SHORE, linewidths=0.25, zorder=2),
        autolim=False,
    )
    low, high = float(_mercator(FINE_SOUTH)), float(_mercator(FINE_NORTH))
    outside = [
        (frame.west, frame.low, FINE_WEST - frame.west, frame.high - frame.low),
        (FINE_EAST, frame.low, frame.east - FINE_EAST, frame.high - frame.low),
        (frame.west, frame.low, frame.east - frame.west, low - frame.low),
        (frame.west, high, frame.east - frame.west, frame.high - high),
    ]
    for x, y0, width, height in outside:
        if width > 0 and height > 0:
            hatched = Rectangle((x, y0), width, height, facecolor="#dddddd", edgecolor="#b5b5b5", hatch="//")
            axes.add_patch(hatched).set(linewidth=0, zorder=2.1)
    return outlines


def _turned(ring: NDArray[np.float64], lake: bool) -> NDArray[np.float64]:
    """Turn shores and lakes opposite ways: the renderer fills by winding, not by even and odd."""
    x, y = ring[:, 0], ring[:, 1]
    anticlockwise = float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])) > 0
    return ring if anticlockwise != lake else ring[::-1]


def _draw_graticule(axes: Axes, frame: _Frame) -> None:
    south, north = float(_latitude(frame.low)), float(_latitude(frame.high))
    meridians = _nice_ticks(frame.west, frame.east)
    parallels = _nice_ticks(south, north)
    axes.set_xticks(meridians, [_degrees(value, "E", "W") for value in meridians])
    axes.set_yticks(_mercator(np.array(parallels)), [_degrees(value, "N", "S") for value in parallels])
    axes.grid(color=_GRATICULE, linewidth=0.5, zorder=1)


def _nice_ticks(low: float, high: float) -> list[float]:
    """Whole degrees or minutes between two limits, four to nine of them."""
    step = next((s for s in _STEPS_MIN if (high - low) * 60 / s <= 8), _STEPS_MIN[-1])
    first, last = math.ceil(low * 60 / step), math.floor(high * 60 / step)
    return [k * step / 60 for k in range(first, last + 1)]


def _degrees(value: float, positive: str, negative: str) -> str:
    minutes = round(abs(value) * 60)
    part = f"{minutes // 60}°{minutes % 60:02d}'" if minutes % 60 else f"{minutes // 60}°"
    return f"{part}{positive if value >= 0 else negative}"


def _draw_barbs(axes: Axes, frame: _Frame, wind: Wind, time: datetime, land: list[Outline]) -> None:
    """Barbs about 60 pixels apart, at sea only, where the forecast has a figure."""
    columns = max(4, round(frame.width_in * 0.8 * DPI / 75))
    step = (frame.east - frame.west) / columns
    x = np.arange(frame.west + step / 2, frame.east, step)
    y = np.arange(frame.low + step / 2, frame.high, step)
    places = np.array([(a, b) for b in y for a in x])
    lat, lon = _latitude(places[:, 1]), places[:, 0]
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


def _draw_passage(axes: Axes, passage: Passage) -> LineCollection:
    """Draw the sailed line over a dark seam, so that its colours hold on water and on land."""
    from matplotlib.collections import LineCollection
    from matplotlib.colors import Normalize

    track = passage.track
    points = np.column_stack([track.lon, _mercator(track.lat)])
    segments = np.stack([points[:-1], points[1:]], axis=1)
    tws = (track.tws_kn[:-1] + track.tws_kn[1:]) / 2
    axes.plot(points[:, 0], points[:, 1], color=_INK, linewidth=5.2, solid_capstyle="round", zorder=5)
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
        under_engine = np.where(track.motor, points[:, 1], np.nan)
        axes.plot(
            points[:, 0],
            under_engine,
            color="white",
            linewidth=1.2,
            dashes=(3, 3),
            zorder=7,
            label="under engine",
        )
        axes.legend(loc="upper left", fontsize=8, facecolor=_INK, labelcolor="white", framealpha=0.85)
    return line


def _draw_colours(figure: Figure, line: LineCollection) -> None:
    """Explain the colours of the passage to the right of the chart."""
    width = figure.get_figwidth()
    room = figure.add_axes((1.0 - (_RIGHT_IN - 0.22) / width, 0.3, 0.14 / width, 0.4))
    bar = figure.colorbar(line, cax=room)
    bar.set_label("True wind speed [kn]", fontsize=8, color=_INK)
    bar.ax.tick_params(labelsize=8, colors=_INK)


def _fives(values: NDArray[np.float64]) -> tuple[float, float]:
    """Multiples of five that enclose the values."""
    low = math.floor(float(values.min()) / 5) * 5
    return low, max(low + 5, math.ceil(float(values.max()) / 5) * 5)


def _free_side(pixels: NDArray[np.float64], number: int) -> tuple[int, int]:
    """Side of a waypoint that is farthest from its legs: right (1, 0), left, above (0, 1) or below."""
    neighbours = pixels[[k for k in (number - 1, number + 1) if 0 <= k < len(pixels)]] - pixels[number]
    legs = neighbours / np.maximum(np.hypot(*neighbours.T), 1e-9)[:, None]
    sides = ((1, 0), (-1, 0), (0, 1), (0, -1))
    return min(sides, key=lambda side: float((legs @ np.array(side)).max()))


def _draw_waypoints(axes: Axes, passage: Passage) -> None:
    """Mark the waypoints; write names at the ends and times wherever there is room for them."""
    x = np.array([w.lon for w in passage.waypoints])
    y = _mercator(np.array([w.lat for w in passage.waypoints]))
    axes.plot(
        x, y, "o", markersize=4.5, color="white", markeredgecolor=_MAGENTA, markeredgewidth=1.3, zorder=8
    )
    pixels = axes.transData.transform(np.column_stack([x, y]))
    first, last = (shorten(place.name, 26, placeholder=" ...") for place in (passage.start, passage.end))
    ends = {0: first, len(x) - 1: last}
    taken: list[Bbox] = []
    labelled: list[int] = []
    for number in sorted(range(len(x)), key=lambda k: k not in ends):
        clock = f"{to_minute(passage.waypoints[number].time):%d.%m. %H:%M}"
        name = ends.get(number)
        near = np.hypot(*(pixels[labelled] - pixels[number]).T) < _LABEL_GAP_PX
        if name is None and near.any():
            continue
        label = axes.annotate(
            f"{name}\n{clock}" if name else clock,
            (x[number], y[number]),
            textcoords="offset points",
            fontsize=9 if name else 7.5,
            fontweight="bold" if name else "normal",
            color=_INK,
            bbox={"boxstyle": "round,pad=0.15", "facecolor": "white", "alpha": 0.75, "linewidth": 0},
            zorder=9,
            **_beside(*_free_side(pixels, number)),
        )
        box = label.get_window_extent()
        others = np.delete(pixels, number, axis=0)
        if name is None and (box.count_overlaps(taken) or box.count_contains(others)):
            label.remove()
        else:
            taken.append(box)
            labelled.append(number)


def _beside(right: int, above: int) -> dict[str, Any]:
    """Place of a text beside a point, for ``annotate``."""
    across = {-1: "right", 0: "center", 1: "left"}[right]
    upwards = {-1: "top", 0: "center", 1: "bottom"}[above]
    return {
        "xytext": (9 * right, 9 * above),
        "horizontalalignment": across,
        "verticalalignment": upwards,
    }


def _draw_scale_bar(axes: Axes, frame: _Frame) -> None:
    """Draw a bar in nautical miles, true at its own latitude."""
    y = frame.low + 0.035 * (frame.high - frame.low)
    lat = float(_latitude(y))
    nm_per_degree = float(great_circle_m(lat, 0.0, lat, 1.0)) / METRES_PER_NM
    room_nm = 0.25 * (frame.east - frame.west) * nm_per_degree
    length_nm = max((nm for nm in _BARS_NM if nm <= room_nm), default=_BARS_NM[0])
    x0 = frame.west + 0.04 * (frame.east - frame.west)
    length = length_nm / nm_per_degree
    halves = ((0.0, "white"), (0.5, _INK))
    axes.plot([x0, x0 + length], [y, y], color=_INK, linewidth=5, solid_capstyle="butt", zorder=10)
    for begin, colour in halves:
        ends = [x0 + begin * length, x0 + (begin + 0.5) * length]
        axes.plot(ends, [y, y], color=colour, linewidth=3, solid_capstyle="butt", zorder=11)
    axes.annotate(
        f"{length_nm:g} nm",
        (x0 + length / 2, y),
        xytext=(0, 5),
        textcoords="offset points",
        horizontalalignment="center",
        fontsize=8,
        color=_INK,
        zorder=11,
    )


def _write_texts(figure: Figure, passage: Passage, barbs_at: datetime | None) -> None:
    width, height = figure.get_figwidth(), figure.get_figheight()

    def write(x_in: float, y_in: float, text: str, **style: Any) -> None:
        """Write at inches from the left and from the bottom, or from the right and the top if negative."""
        x = x_in / width if x_in >= 0 else 1.0 + x_in / width
        y = y_in / height if y_in >= 0 else 1.0 + y_in / height
        figure.text(x, y, text, **{"fontsize": 8, "color": _INK, **style})

    facts = (
        f"{passage.yacht}   |   "
        f"{format_day_time(passage.departure)} to {format_day_time(passage.arrival)} UTC\n"
        f"{passage.distance_nm:.1f} nm at {passage.mean_speed_kn:.1f} kn, "
        f"strongest wind {passage.max_tws_kn:.0f} kn, {manoeuvres(passage)}"
    )
    issued = passage.forecast.issued
    source = passage.forecast.source + (f", issued {format_day_time(issued)} UTC" if issued else "")
    barbs = f"   |   Barbs: {format_day_time(barbs_at)} UTC" if barbs_at else ""
    head = f"{title(passage)}: {format_duration(passage.duration_h)}"
    write(_LEFT_IN, -0.42, head, fontsize=min(16.0, 95.0 * width / len(head)))
    write(_LEFT_IN, -0.92, facts, fontsize=9, linespacing=1.5)
    write(_LEFT_IN, 0.40, f"Wind: {shorten(source, 70, placeholder=' ...')}{barbs}")
    write(_LEFT_IN, 0.17, NOTICE, color=_MAGENTA, fontweight="bold")
    coast = "Coast: (c) OpenStreetMap contributors, ODbL, Baltic only."
    write(-_RIGHT_IN, 0.17, coast, fontsize=7, horizontalalignment="right")
