"""The convex hull of a slice: best VMG, the headings to share, and where the sail changes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from seacruise.export.polar_lines import Yacht, sources_of, wind_rose
from seacruise.export.polar_sheet import HEIGHT_IN, SAIL_COLOURS, WIDTH_IN, Theme, below, canvas, halo, key
from seacruise.export.polar_slices import NEAR_KN, Chord, LogPoints, Slice, slice_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_ROOM: Final = {1: (0.06, 0.64), 2: (0.04, 0.70), 3: (0.02, 0.74)}
"""Left end and width that the slices take of the sheet, by their number."""


def hulls(yacht: Yacht, winds: Sequence[float], *, points: LogPoints | None, theme: Theme) -> Figure:
    """Hulls of a yacht's slices, side by side, of one that differs between the tacks those of the mean."""
    polar = yacht.to_table()
    cuts = [slice_of(polar, kn) for kn in winds]
    figure = canvas(
        theme,
        title=yacht.name,
        subtitle="What she makes good by sharing the time between two headings",
        foot=sources_of([yacht], points),
    )
    left, width = _ROOM[len(cuts)]
    each = width / len(cuts)
    top = max(float(cut.hull_kn.max(initial=0.9)) for cut in cuts)
    if points is not None:
        top = max(top, *(float(points.near(kn).speed_kn.max(initial=0.0)) for kn in winds))
    for number, cut in enumerate(cuts):
        axes: Any = figure.add_axes(_square(left + number * each, each), projection="polar")
        wind_rose(axes, theme, top=float(np.ceil(top * 1.06 * 2.0) / 2.0), full=False)
        words = f"{cut.tws_kn:g} kn of wind\n{_best_words(cut)}"
        axes.set_title(words, fontsize=8.5, color=theme.ink, pad=10, linespacing=1.4)
        if points is not None:
            _draw_points(axes, points.near(cut.tws_kn), theme)
        _draw_slice(axes, cut, theme)
    _keys(figure, cuts, theme, points)
    return figure


def _square(left: float, width: float) -> tuple[float, float, float, float]:
    """Square whose middle half, in which half a circle is drawn, is a part of the sheet's width."""
    half = min((width - 0.07) * WIDTH_IN, 0.33 * HEIGHT_IN)
    middle_in = (left + width / 2.0) * WIDTH_IN
    return (
        (middle_in - half) / WIDTH_IN,
        0.44 - half / HEIGHT_IN,
        2.0 * half / WIDTH_IN,
        2.0 * half / HEIGHT_IN,
    )


def _best_words(cut: Slice) -> str:
    return (
        f"beat {cut.beat.twa:.0f}°, VMG {cut.beat.vmg_kn:.2f} kn\n"
        f"run {cut.run.twa:.0f}°, VMG {cut.run.vmg_kn:.2f} kn"
    )


def _draw_points(axes: Any, near: LogPoints, theme: Theme) -> None:
    axes.plot(
        np.radians(np.abs(near.twa)),
        near.speed_kn,
        linestyle="",
        marker=".",
        markersize=3,
        color=theme.muted,
        alpha=0.45,
        rasterized=True,
    )


def _draw_slice(axes: Any, cut: Slice, theme: Theme) -> None:
    angle = np.radians(cut.twa)
    axes.fill(
        np.concatenate([angle, [0.0]]), np.concatenate([cut.hull_kn, [0.0]]), color=theme.accent, alpha=0.08
    )
    for number, sail in enumerate(cut.sails):
        axes.plot(angle, sail.speed_kn, linewidth=1.3, color=_sail_colour(number), zorder=4)
    axes.plot(angle, cut.speed_kn, color=theme.ink, zorder=3, **_direct(cut))
    for chord in cut.chords:
        on = (cut.twa >= chord.course_from) & (cut.twa <= chord.course_to)
        axes.plot(
            angle[on], cut.hull_kn[on], linewidth=1.8, linestyle=(0, (4, 2)), color=theme.accent, zorder=5
        )
        for heading in (chord.twa1, chord.twa2):
            if heading >= 0.0:
                _mark(axes, cut, heading, theme)
    for before, after in zip(cut.ranges[:-1], cut.ranges[1:], strict=True):
        if before.sail != after.sail:
            _mark_change(axes, cut, after.twa_from, theme)


def _direct(cut: Slice) -> dict[str, float]:
    """Width of the yacht's own curve: where it is the best of sails, it lies behind theirs."""
    return {"linewidth": 3.6, "alpha": 0.3} if cut.sails else {"linewidth": 1.9}


def _mark(axes: Any, cut: Slice, heading: float, theme: Theme) -> None:
    """Mark a heading of a chord; on a beat or run, where it is of both tacks, as a disc."""
    speed = float(np.interp(heading, cut.twa, cut.speed_kn))
    mirrored = any(abs(c.twa1 + c.twa2) < 1e-6 and abs(abs(c.twa1) - heading) < 1e-6 for c in cut.chords)
    place = (float(np.radians(heading)), speed)
    axes.plot(*place, marker="o" if mirrored else "D", markersize=6 if mirrored else 5, color=theme.accent)
    axes.lines[-1].set_zorder(7)
    axes.annotate(
        f"{heading:.0f}°",
        place,
        xytext=(-7, -11 if heading < 90.0 else 6),
        textcoords="offset points",
        ha="right",
        fontsize=7.5,
        color=theme.ink,
        path_effects=halo(theme),
        zorder=8,
    )


def _mark_change(axes: Any, cut: Slice, angle: float, theme: Theme) -> None:
    speed = float(np.interp(angle, cut.twa, cut.speed_kn))
    place = (float(np.radians(angle)), speed)
    axes.plot(*place, marker="s", markersize=5, color=theme.paper, markeredgecolor=theme.ink, zorder=7)
    axes.annotate(
        f"{angle:.0f}°",
        place,
        xytext=(-7, 0),
        textcoords="offset points",
        ha="right",
        va="center",
        fontsize=7,
        color=theme.muted,
        path_effects=halo(theme),
        zorder=8,
    )


def _sail_colour(number: int) -> str:
    return SAIL_COLOURS[number % len(SAIL_COLOURS)]


def _keys(figure: Figure, cuts: Sequence[Slice], theme: Theme, points: LogPoints | None) -> None:
    from matplotlib.lines import Line2D

    def line(**style: Any) -> Line2D:
        return Line2D([], [], **{"linestyle": "", **style})

    place = (0.72 if len(cuts) == 1 else 0.765, 0.85)
    signs: list[tuple[Any, str]] = [
        (line(color=theme.ink, linestyle="-", **_direct(cuts[0])), "sailed direct"),
        (line(color=theme.accent, linewidth=1.8, linestyle=(0, (4, 2))), "made good on two headings"),
        (line(color=theme.accent, marker="o", markersize=6), "best VMG: beat, run"),
    ]
    chords = [chord for cut in cuts for chord in cut.chords]
    if any(not _mirrored(chord) for chord in chords):
        signs.append((line(color=theme.accent, marker="D", markersize=5), "heading of a mixture"))
    if points is not None:
        shown = sum(len(points.near(cut.tws_kn)) for cut in cuts)
        words = f"{shown} of {len(points)} log points, within {NEAR_KN:g} kn of the wind"
        signs.append((line(color=theme.muted, marker=".", markersize=4), words))
    names = [sail.name for sail in cuts[0].sails]
    if names:
        signs.append((line(color=theme.paper, marker="s", markeredgecolor=theme.ink), "change of sail"))
    legend = key(figure, theme, signs, title="Signs", place=place)
    if names:
        sails = [(line(color=_sail_colour(k), linestyle="-"), name) for k, name in enumerate(names)]
        legend = key(figure, theme, sails, title="Sails", place=below(figure, legend))
    if len(cuts) == 1:
        _tell(figure, cuts[0], theme, below(figure, legend))


def _mirrored(chord: Chord) -> bool:
    return abs(chord.twa1 + chord.twa2) < 1e-6


def _tell(figure: Figure, cut: Slice, theme: Theme, place: tuple[float, float]) -> None:
    """Say in words which courses are made good how."""
    lines = []
    for chord in cut.chords:
        lines.append(f"{chord.course_from:.0f}° to {chord.course_to:.0f}°:")
        for heading, sail in ((chord.twa1, chord.sail1), (chord.twa2, chord.sail2)):
            tack = "" if not _mirrored(chord) else " starboard" if heading > 0 else " port"
            lines.append(f"   {abs(heading):.0f}°{tack}" + (f", {sail}" if sail else ""))
    if lines:
        figure.text(
            *place, "Courses on two headings", fontsize=8.5, fontweight="bold", color=theme.ink, va="top"
        )
        figure.text(
            place[0],
            place[1] - 0.022,
            "\n".join(lines),
            fontsize=8,
            color=theme.ink,
            va="top",
            linespacing=1.4,
            parse_math=False,
        )
