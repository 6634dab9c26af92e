"""A whole polar at once: as a surface, and as colours over wind and angle."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.export.polar_lines import Yacht, sources_of
from seacruise.export.polar_sheet import Theme, canvas, dress, halo, key, room, speed_map
from seacruise.export.polar_slices import LogPoints
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.polar import Polar
from seacruise.yacht.tacks import TwoSided

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

_WINDS: Final = 81
_STEP_DEG: Final = 2.0


def surface(yacht: Yacht, *, points: LogPoints | None, theme: Theme) -> Figure:
    """Boat speed as a surface over wind speed and angle; its colour is its height."""
    winds, angles, speed = _grid(yacht)
    figure = _sheet(yacht, theme, points, "Boat speed over true wind speed and angle")
    left, bottom, width, height = room(-0.02, 0.92)
    axes: Any = figure.add_axes((left, bottom, width, height), projection="3d")
    axes.set_facecolor(theme.paper)
    top = float(speed.max(initial=1.0))
    drawn = axes.plot_surface(
        *np.meshgrid(winds, angles),
        speed,
        cmap=speed_map(),
        vmin=0.0,
        vmax=top,
        rcount=60,
        ccount=40,
        linewidth=0.15,
        edgecolor=theme.paper,
        antialiased=True,
        alpha=0.75 if points is not None else 1.0,
    )
    if points is not None:
        angle = points.twa if isinstance(yacht, TwoSided) else np.abs(points.twa)
        axes.scatter(points.tws_kn, angle, points.speed_kn, s=3, color=theme.accent, depthshade=False)
    axes.view_init(elev=26.0, azim=-128.0)
    axes.set_yticks(_angle_ticks(yacht))
    axes.yaxis.set_major_formatter(lambda angle, _: f"{abs(angle):.0f}°")
    labels = ("True wind speed [kn]", "True wind angle [degrees]", "Boat speed [kn]")
    for axis, label in zip((axes.xaxis, axes.yaxis, axes.zaxis), labels, strict=True):
        axis.set_label_text(label, fontsize=8.5, color=theme.ink)
        axis.set_pane_color(theme.paper)
        axis.line.set_color(theme.muted)
    axes.tick_params(labelsize=8, colors=theme.muted, labelcolor=theme.ink)
    _scale(figure, drawn, theme)
    _points_key(figure, points, theme, colour=theme.accent)
    return figure


def colours(yacht: Yacht, *, points: LogPoints | None, theme: Theme) -> Figure:
    """Boat speed as colours over wind speed and angle, with lines of even speed and the best VMG."""
    winds, angles, speed = _grid(yacht)
    figure = _sheet(
        yacht, theme, points, "Boat speed by true wind speed and angle, and the best beat and run"
    )
    left, bottom, width, height = room(0.05, 0.80)
    axes = figure.add_axes((left, bottom + 0.05, width, height - 0.09))
    dress(axes, theme)
    axes.grid(visible=False)
    top = float(speed.max(initial=1.0))
    mesh = axes.pcolormesh(
        winds, angles, speed, cmap=speed_map(), vmin=0.0, vmax=top, shading="gouraud", rasterized=True
    )
    levels = np.arange(1.0, np.ceil(top))
    if levels.size:
        even = axes.contour(winds, angles, speed, levels=levels, colors="white", linewidths=0.6, alpha=0.8)
        axes.clabel(even, fmt=lambda kn: f"{kn:g} kn", fontsize=7)
    _best_lines(axes, yacht, winds, theme)
    if points is not None:
        angle = points.twa if isinstance(yacht, TwoSided) else np.abs(points.twa)
        near = (points.tws_kn >= winds[0]) & (points.tws_kn <= winds[-1])
        axes.scatter(
            points.tws_kn[near],
            angle[near],
            c=points.speed_kn[near],
            cmap=speed_map(),
            vmin=0.0,
            vmax=top,
            s=7,
            edgecolors="white",
            linewidths=0.25,
            rasterized=True,
        )
    axes.set_yticks(_angle_ticks(yacht))
    axes.yaxis.set_major_formatter(lambda angle, _: f"{abs(angle):.0f}°")
    axes.set_xlim(winds[0], winds[-1])
    axes.set_ylim(angles[0], angles[-1])
    axes.set_xlabel("True wind speed [kn]", fontsize=9, color=theme.ink)
    side = "  (port tack below)" if isinstance(yacht, TwoSided) else ""
    axes.set_ylabel(f"True wind angle [degrees]{side}", fontsize=9, color=theme.ink)
    _scale(figure, mesh, theme)
    _points_key(figure, points, theme, colour=speed_map()(0.6))
    return figure


def _sheet(yacht: Yacht, theme: Theme, points: LogPoints | None, subtitle: str) -> Figure:
    return canvas(theme, title=yacht.name, subtitle=subtitle, foot=sources_of([yacht], points))


def _grid(yacht: Yacht) -> tuple[Array, Array, Array]:
    """Winds [kn] of the table, angles [degrees], and speeds [kn] ``(a, w)``."""
    table = yacht.to_table()
    low, high = float(table.tws[0]) / MS_PER_KNOT, float(table.tws[-1]) / MS_PER_KNOT
    # A table of one wind is a line; the calm below it, which is known too, makes it an area.
    winds = np.linspace(low if high > low else 0.0, high if high > 0.0 else 1.0, _WINDS)
    angles = np.arange(-180.0 if isinstance(yacht, TwoSided) else 0.0, 181.0, _STEP_DEG)
    tws = winds * MS_PER_KNOT
    on = yacht.speed_on if isinstance(yacht, TwoSided) else yacht.speed
    return winds, angles, on(tws, angles[:, np.newaxis]) / MS_PER_KNOT


def _angle_ticks(yacht: Yacht) -> Array:
    return np.arange(-180.0, 181.0, 60.0) if isinstance(yacht, TwoSided) else np.arange(0.0, 181.0, 30.0)


def _best_lines(axes: Any, yacht: Yacht, winds: Array, theme: Theme) -> None:
    """Draw the angles of the best beat and run."""
    sides: dict[int, Polar] = (
        {1: yacht.starboard, -1: yacht.port} if isinstance(yacht, TwoSided) else {1: yacht.to_table()}
    )
    for side, polar in sides.items():
        for upwind, words in ((True, "best beat"), (False, "best run")):
            angle = side * polar.best_vmg(winds * MS_PER_KNOT, upwind)[0]
            axes.plot(winds, angle, color="white", linewidth=1.6, linestyle=(0, (4, 2)))
            place = len(winds) // 2
            label = axes.annotate(
                words,
                (winds[place], angle[place]),
                xytext=(0, -9 if upwind == (side > 0) else 6),
                textcoords="offset points",
                fontsize=8,
                color=theme.ink,
                ha="center",
            )
            label.set_path_effects(halo(theme))


def _scale(figure: Figure, drawn: Any, theme: Theme) -> None:
    place = figure.add_axes((0.905, 0.30, 0.018, 0.42))
    bar = figure.colorbar(drawn, cax=place)
    bar.set_label("Boat speed [kn]", fontsize=8.5, color=theme.ink)
    bar.ax.tick_params(labelsize=8, colors=theme.muted, labelcolor=theme.ink)
    bar.outline.set_edgecolor(theme.muted)


def _points_key(figure: Figure, points: LogPoints | None, theme: Theme, *, colour: Any) -> None:
    if points is None:
        return
    from matplotlib.lines import Line2D

    dot = Line2D([], [], color=colour, linestyle="", marker="o", markersize=4)
    key(figure, theme, [(dot, f"{len(points)} log points")], title="", place=(0.70, 0.895))
