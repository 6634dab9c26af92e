"""The passage on a chart, as a PNG: what one hangs up or sends to the crew."""

from __future__ import annotations

import io
from datetime import datetime
from pathlib import Path
from textwrap import shorten
from typing import TYPE_CHECKING, Any

from seacruise.atomic import write_atomically
from seacruise.export.beside import NOTHING, Beside, draw_beside
from seacruise.export.chartlabels import draw_ports, draw_waypoints
from seacruise.export.chartwork import (
    INK,
    LEFT_IN,
    MAGENTA,
    RIGHT_IN,
    canvas,
    draw_barbs,
    draw_graticule,
    draw_land,
    draw_passage,
    draw_scale_bar,
    frame_of,
)
from seacruise.export.textform import NOTICE, format_day_time, format_duration, manoeuvres, title
from seacruise.passage import Passage
from seacruise.ports import load_ports

if TYPE_CHECKING:
    from matplotlib.collections import LineCollection
    from matplotlib.figure import Figure

    from seacruise.weather.wind import Wind


def chart(passage: Passage, *, wind: Wind | None = None, beside: Beside = NOTHING) -> bytes:
    """Draw a passage and return the PNG.

    Land is the coast that the passage was checked against, thinned for the scale. The line of the passage
    is coloured by the true wind met at each place; barbs show the wind of the whole sea half-way through.

    Parameters
    ----------
    wind
        Source of the barbs; without it there are none.
    beside
        Lines to be drawn faintly under the passage.
    """
    frame = frame_of(passage.track.lon, passage.track.lat)
    figure, axes = canvas(frame)
    land = draw_land(axes, frame)
    draw_graticule(axes, frame)
    middle = passage.departure + (passage.arrival - passage.departure) / 2
    if wind is not None:
        draw_barbs(axes, frame, wind, middle, land)
    line = draw_passage(axes, passage)
    told = draw_beside(axes, beside, passage)
    taken = draw_waypoints(axes, passage, [draw_scale_bar(axes, frame), *told])
    draw_ports(axes, frame, passage, load_ports(), taken)
    _write_texts(figure, passage, middle if wind is not None else None)
    _draw_colours(figure, line)
    picture = io.BytesIO()
    # No version and no date in the file: the same passage gives the same picture.
    figure.savefig(picture, format="png", metadata={"Software": "SeaCruise"})
    return picture.getvalue()


def write_chart(passage: Passage, path: Path, *, wind: Wind | None = None, beside: Beside = NOTHING) -> None:
    """Write `chart` to a file.

    Raises
    ------
    InputError
        The file cannot be written.
    """
    write_atomically(path, chart(passage, wind=wind, beside=beside), what="chart")


def _draw_colours(figure: Figure, line: LineCollection) -> None:
    """Explain the colours of the passage to the right of the chart."""
    width = figure.get_figwidth()
    room = figure.add_axes((1.0 - (RIGHT_IN - 0.22) / width, 0.3, 0.14 / width, 0.4))
    bar = figure.colorbar(line, cax=room)
    bar.set_label("True wind speed [kn]", fontsize=8, color=INK)
    bar.ax.tick_params(labelsize=8, colors=INK)


def _write_texts(figure: Figure, passage: Passage, barbs_at: datetime | None) -> None:
    width, height = figure.get_figwidth(), figure.get_figheight()

    def write(x_in: float, y_in: float, text: str, **style: Any) -> None:
        """Write at inches from the left and from the bottom, or from the right and the top if negative."""
        x = x_in / width if x_in >= 0 else 1.0 + x_in / width
        y = y_in / height if y_in >= 0 else 1.0 + y_in / height
        figure.text(x, y, text, **{"fontsize": 8, "color": INK, **style})

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
    write(LEFT_IN, -0.42, head, fontsize=min(16.0, 95.0 * width / len(head)))
    write(LEFT_IN, -0.92, facts, fontsize=9, linespacing=1.5)
    write(LEFT_IN, 0.40, f"Wind: {shorten(source, 70, placeholder=' ...')}{barbs}")
    write(LEFT_IN, 0.17, NOTICE, color=MAGENTA, fontweight="bold")
    coast = "Coast: (c) OpenStreetMap contributors, ODbL; beyond the Baltic to 2 km."
    write(-RIGHT_IN, 0.17, coast, fontsize=7, horizontalalignment="right")
