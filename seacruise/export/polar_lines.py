"""Slices of polars as lines: round the wind, and flat over the angle."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from seacruise.export.polar_sheet import (
    DASHES,
    Theme,
    below,
    canvas,
    dress,
    halo,
    key,
    room,
    wind_colours,
)
from seacruise.export.polar_slices import NEAR_KN, LogPoints, Slice, slice_of
from seacruise.yacht.polar import Polar
from seacruise.yacht.tacks import TwoSided

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = NDArray[np.float64]
Yacht = Polar | TwoSided

_KEY_LEFT = 0.755


@dataclass(frozen=True, slots=True, eq=False)
class _Line:
    """A slice on one tack; ``side`` is 1 for starboard and -1 for port."""

    cut: Slice
    side: int
    yacht: int
    wind: int


def round_the_wind(
    yachts: Sequence[Yacht], winds: Sequence[float], *, points: LogPoints | None, theme: Theme
) -> Figure:
    """Polar plot: the wind blows from above, the radius is boat speed.

    Half a circle, unless a yacht or the points of a log differ between the tacks.
    """
    full = _has_sides(yachts) or (points is not None and points.both_tacks)
    lines = list(_lines(yachts, winds, full=full))
    figure = _sheet(yachts, theme, points, what="boat speed by true wind angle")
    left, bottom, width, height = room(0.0, 0.76 if full else 0.72)
    axes = figure.add_axes((left, bottom + 0.025, width, height - 0.025), projection="polar")
    wind_rose(axes, theme, top=_top(lines, points, winds), full=full)
    sizes = _draw(axes, lines, winds, points, theme, turn=np.radians, fold=not full)
    _keys(figure, yachts, winds, theme, shown=sizes, points=points)
    return figure


def over_the_angle(
    yachts: Sequence[Yacht], winds: Sequence[float], *, points: LogPoints | None, theme: Theme
) -> Figure:
    """Flat plot: boat speed over the angle, from -180 degrees where a yacht differs between the tacks."""
    full = _has_sides(yachts)
    lines = list(_lines(yachts, winds, full=full))
    figure = _sheet(yachts, theme, points, what="boat speed over true wind angle")
    left, bottom, width, height = room(0.05, 0.70)
    axes = figure.add_axes((left, bottom + 0.05, width, height - 0.05))
    dress(axes, theme)
    axes.set_xlim(-180.0 if full else 0.0, 180.0)
    axes.set_ylim(0.0, _top(lines, points, winds))
    axes.set_xticks(np.arange(-180.0 if full else 0.0, 181.0, 60.0 if full else 30.0))
    axes.xaxis.set_major_formatter(lambda angle, _: f"{abs(angle):.0f}°")
    side = "  (port tack left, starboard tack right)" if full else ""
    axes.set_xlabel(f"True wind angle [degrees]{side}", fontsize=9, color=theme.ink)
    axes.set_ylabel("Boat speed [kn]", fontsize=9, color=theme.ink)
    sizes = _draw(axes, lines, winds, points, theme, turn=np.asarray, fold=not full)
    _keys(figure, yachts, winds, theme, shown=sizes, points=points)
    return figure


def wind_rose(axes: Any, theme: Theme, *, top: float, full: bool) -> None:
    """Turn polar axes so that the wind comes from above, and label them."""
    dress(axes, theme)
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(-1)
    axes.set_thetalim(np.radians(-180.0 if full else 0.0), np.radians(180.0))
    axes.set_rlim(0.0, top)
    angles = np.arange(-150.0, 181.0, 30.0) if full else np.arange(0.0, 181.0, 30.0)
    axes.set_xticks(np.radians(angles))
    axes.set_xticklabels([f"{abs(angle):.0f}°" for angle in angles])
    step = next(s for s in (1, 2, 5, 10, 20, 50, 100, 1000) if top / s <= 8)
    speeds = np.arange(step, top + 1e-9, step)
    axes.set_yticks(speeds)
    axes.set_yticklabels([f"{v:g} kn" if v == speeds[-1] else f"{v:g}" for v in speeds])
    axes.tick_params(axis="y", labelsize=7.5, labelcolor=theme.muted)
    if full:
        axes.set_rlabel_position(0.0)


def title_of(yachts: Sequence[Yacht]) -> str:
    """Names of the yachts, for the head of a sheet."""
    names = [yacht.name for yacht in yachts]
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def sources_of(yachts: Sequence[Yacht], points: LogPoints | None) -> list[str]:
    """Where the figures are from, a line each, for the foot of a sheet."""
    one = len(yachts) == 1
    lines = [
        f"Polar: {yacht.source}" if one else f"{yacht.name}: {yacht.source}"
        for yacht in yachts
        if yacht.source and yacht.source != yacht.name
    ]
    if points is not None and points.source:
        lines.append(f"Log: {points.source}")
    return [*lines, "Drawn by SeaCruise"]


def _sheet(yachts: Sequence[Yacht], theme: Theme, points: LogPoints | None, *, what: str) -> Figure:
    return canvas(
        theme,
        title=title_of(yachts),
        subtitle=f"{what[:1].upper()}{what[1:]}, one curve for each true wind speed; dots are the best VMG",
        foot=sources_of(yachts, points),
    )


def _has_sides(yachts: Sequence[Yacht]) -> bool:
    return any(isinstance(yacht, TwoSided) for yacht in yachts)


def _lines(yachts: Sequence[Yacht], winds: Sequence[float], *, full: bool) -> Iterator[_Line]:
    for number, yacht in enumerate(yachts):
        if isinstance(yacht, TwoSided):
            sides = {1: yacht.starboard, -1: yacht.port}
        else:
            sides = {1: yacht, -1: yacht} if full else {1: yacht}
        for k, kn in enumerate(winds):
            cuts = {id(polar): slice_of(polar, kn) for polar in sides.values()}
            for side, polar in sides.items():
                yield _Line(cuts[id(polar)], side, number, k)


def _top(lines: Sequence[_Line], points: LogPoints | None, winds: Sequence[float]) -> float:
    """Round the greatest speed of the lines and points up, with room for a label."""
    tops = [float(line.cut.speed_kn.max(initial=0.0)) for line in lines]
    if points is not None:
        tops += [float(points.near(kn).speed_kn.max(initial=0.0)) for kn in winds]
    return float(np.ceil(max(*tops, 0.9) * 1.04 * 2.0) / 2.0)


def _draw(
    axes: Axes,
    lines: Sequence[_Line],
    winds: Sequence[float],
    points: LogPoints | None,
    theme: Theme,
    *,
    turn: Any,
    fold: bool,
) -> list[int]:
    """Draw points, lines and best VMG; returns how many points each wind has."""
    colours = wind_colours(theme, len(winds))
    shown = []
    for kn, colour in zip(winds, colours, strict=True):
        near = points.near(kn) if points is not None else None
        shown.append(len(near) if near is not None else 0)
        if near is not None:
            angle = np.abs(near.twa) if fold else near.twa
            axes.plot(
                turn(angle),
                near.speed_kn,
                linestyle="",
                marker=".",
                markersize=3.0,
                color=colour,
                alpha=0.35,
                markeredgewidth=0,
                zorder=2,
                rasterized=True,
            )
    for line in lines:
        _draw_line(axes, line, colours[line.wind], turn=turn)
    _write_winds(axes, [line for line in lines if line.yacht == 0 and line.side == 1], theme, turn=turn)
    return shown


def _write_winds(axes: Axes, lines: Sequence[_Line], theme: Theme, *, turn: Any) -> None:
    """Write the wind on the fastest place of each curve, unless it would cover another."""
    room_for_words = 0.045 * axes.get_ylim()[1]
    last = -room_for_words
    for line in lines:
        cut = line.cut
        fastest = int(np.where(cut.known, cut.speed_kn, -1.0).argmax())
        speed = float(cut.speed_kn[fastest])
        if abs(speed - last) < room_for_words:
            continue
        last = speed
        axes.annotate(
            f"{cut.tws_kn:g}",
            (float(turn(cut.twa[fastest])), speed),
            ha="center",
            va="center",
            fontsize=7.5,
            color=theme.ink,
            path_effects=halo(theme),
            zorder=6,
        )


def _draw_line(axes: Axes, line: _Line, colour: Any, *, turn: Any) -> None:
    cut = line.cut
    angle = turn(line.side * cut.twa)
    style = {"color": colour, "linestyle": DASHES[line.yacht]}
    axes.plot(angle, cut.speed_kn, linewidth=0.9, alpha=0.45, zorder=3, **style)
    known = np.where(cut.known, cut.speed_kn, np.nan)
    axes.plot(angle, known, linewidth=1.9, zorder=4, **style)
    for best in (cut.beat, cut.run):
        if best.vmg_kn > 0.0:
            axes.plot(
                turn(np.array([line.side * best.twa])),
                [best.boat_speed_kn],
                marker="o",
                markersize=4.5,
                color=colour,
                zorder=5,
                linestyle="",
            )


def _keys(
    figure: Figure,
    yachts: Sequence[Yacht],
    winds: Sequence[float],
    theme: Theme,
    *,
    shown: Sequence[int],
    points: LogPoints | None,
) -> None:
    from matplotlib.lines import Line2D

    colours = wind_colours(theme, len(winds))
    by_wind: list[tuple[Any, str]] = [
        (Line2D([], [], color=colour, linewidth=2.0), f"{kn:g} kn")
        for kn, colour in zip(winds, colours, strict=True)
    ]
    legend = key(figure, theme, by_wind, title="True wind speed", place=(_KEY_LEFT, 0.85))
    if len(yachts) > 1:
        by_yacht = [
            (Line2D([], [], color=theme.ink, linewidth=1.8, linestyle=dash), yacht.name)
            for yacht, dash in zip(yachts, DASHES, strict=False)
        ]
        legend = key(figure, theme, by_yacht, title="Yacht", place=below(figure, legend))
    more: list[tuple[Any, str]] = [
        (Line2D([], [], color=theme.ink, linestyle="", marker="o", markersize=4.5), "best VMG"),
        (Line2D([], [], color=theme.ink, linewidth=0.9, alpha=0.45), "beyond the figures"),
    ]
    if points is not None:
        dots = Line2D([], [], color=theme.ink, linestyle="", marker=".", markersize=4, alpha=0.6)
        more.append((dots, f"{sum(shown)} of {len(points)} log points, within {NEAR_KN:g} kn of a wind"))
    key(figure, theme, more, title="Signs", place=below(figure, legend))
