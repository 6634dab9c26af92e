"""The weather along a passage: what she meets, hour by hour, where she then is."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray

from seacruise.along import weather_along
from seacruise.export.words import ENGLISH, Words
from seacruise.passage import Passage
from seacruise.sun import CIVIL_TWILIGHT_DEG, sun_altitude_deg

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from seacruise.weather.wind import Wind

_INK: Final = "#1d2b36"
_NIGHT: Final = "#dfe3ea"
_WIND: Final = "#2a6f97"
_GUST: Final = "#c1440e"
_BOAT: Final = "#3b6d3b"
_ANGLE: Final = "#8a5a00"
_WAVE: Final = "#4a4e8f"

_BARBS: Final = 22
"""So many barbs stand along the passage."""

_TICKS_H: Final = (1, 2, 3, 6, 12, 24, 48)
_MOST_TICKS: Final = 9

Box = tuple[float, float, float, float]
Array = NDArray[np.float64]


def draw_meteogram(
    figure: Figure, box: Box, passage: Passage, *, wind: Wind | None = None, words: Words = ENGLISH
) -> None:
    """Draw wind, boat speed and angle, and waves where they are known, over the time of a passage.

    Parameters
    ----------
    box
        Where on the figure: left, bottom, width and height in parts of it.
    wind
        Source of gusts and waves; without it, or where it has none, they are left out.
    """
    met = weather_along(passage.track, wind)
    gust, wave = met.gust_kn, met.wave_m
    heights = [1.3, 1.0] if wave is None else [1.3, 1.0, 0.7]
    left, bottom, width, height = box
    gap = 0.012
    unit = (height - gap * (len(heights) - 1)) / sum(heights)
    panels: list[Axes] = []
    top = bottom + height
    for share in heights:
        top -= unit * share
        panels.append(figure.add_axes((left, top, width, unit * share)))
        top -= gap
    times = [datetime.fromtimestamp(t, UTC) for t in passage.track.time.tolist()]
    _draw_wind(panels[0], times, passage, gust, words)
    _draw_boat(panels[1], times, passage, words)
    if wave is not None:
        panels[2].fill_between(_x(times), 0, wave, color=_WAVE, alpha=0.35, linewidth=0)
        _label(panels[2], words.say("Waves [m]"))
        panels[2].set_ylim(0, max(1.0, float(wave.max()) * 1.15))
    for panel in panels:
        _shade(panel, times, passage)
        _set_times(panel, times, words, labels=panel is panels[-1])
    _name_the_end(panels[0], times, passage, words)


def _x(times: list[datetime]) -> Any:
    """Give times as matplotlib's numbers: days since 1970."""
    return np.array([t.timestamp() for t in times]) / 86_400.0


def _draw_wind(axes: Axes, times: list[datetime], passage: Passage, gust: Array | None, words: Words) -> None:
    """Draw speed as an area, gusts as a line, direction as barbs above."""
    track, x = passage.track, _x(times)
    axes.fill_between(x, 0, track.tws_kn, color=_WIND, alpha=0.30, linewidth=0)
    axes.plot(x, track.tws_kn, color=_WIND, linewidth=1.2)
    top = float(track.tws_kn.max())
    if gust is not None:
        axes.plot(x, gust, color=_GUST, linewidth=1.0, linestyle="--")
        top = max(top, float(gust.max()))
        axes.text(
            x[-1],
            float(gust[-1]),
            f" {words.say('gusts')}",
            fontsize=6.5,
            color=_GUST,
            verticalalignment="center",
        )
    full = max(10.0, top * 1.45)
    axes.set_ylim(0, full)
    # Even in time: samples are denser where legs are short.
    when = np.linspace(x[0], x[-1], _BARBS + 2)[1:-1]
    at = np.searchsorted(x, when)
    angle = np.radians(track.twd_deg[at])
    axes.barbs(
        when,
        np.full(at.size, full * 0.88),
        -track.tws_kn[at] * np.sin(angle),
        -track.tws_kn[at] * np.cos(angle),
        length=5.0,
        linewidth=0.6,
        color=_INK,
        pivot="middle",
        flip_barb=track.lat[at] < 0,
        sizes={"emptybarb": 0.12},
    )
    _label(axes, words.say("True wind [kn]"))


def _draw_boat(axes: Axes, times: list[datetime], passage: Passage, words: Words) -> None:
    """Draw boat speed, and on the right the angle of the true wind."""
    track, x = passage.track, _x(times)
    axes.plot(x, track.boat_speed_kn, color=_BOAT, linewidth=1.2)
    axes.set_ylim(0, max(6.0, float(track.boat_speed_kn.max()) * 1.15))
    _label(axes, words.say("Boat speed [kn]"), _BOAT)
    other = axes.twinx()
    other.plot(x, track.twa_deg, color=_ANGLE, linewidth=0.8, linestyle=":")
    other.set_ylim(0, 185)
    other.set_yticks([0, 45, 90, 135, 180])
    _label(other, words.say("Wind angle [°]"), _ANGLE)
    # one grid is enough, and this one would lie over the boat speed
    other.grid(visible=False)
    other.spines[["top", "left", "bottom"]].set_visible(False)
    if track.motor.any():
        axes.fill_between(x, 0, 0.4, where=track.motor.tolist(), color=_INK, linewidth=0)
        axes.text(float(x[int(np.argmax(track.motor))]), 0.55, words.say("engine"), fontsize=6.5, color=_INK)


def _label(axes: Axes, text: str, color: str = _INK) -> None:
    from matplotlib.ticker import MaxNLocator

    axes.set_ylabel(text, fontsize=7.5, color=color)
    axes.yaxis.set_major_locator(MaxNLocator(nbins=7, integer=True))
    axes.tick_params(labelsize=7, colors=_INK, length=2.5)
    axes.tick_params(axis="y", labelcolor=color)
    axes.grid(axis="y", color="#c9d1d8", linewidth=0.4)
    axes.set_axisbelow(True)
    for spine in axes.spines.values():
        spine.set_color("#8b98a3")
        spine.set_linewidth(0.6)


def _shade(axes: Axes, times: list[datetime], passage: Passage) -> None:
    """Shade the nights, and hatch what is sailed beyond the end of the forecast."""
    track, x = passage.track, _x(times)
    dark = sun_altitude_deg(track.time, track.lat, track.lon) < CIVIL_TWILIGHT_DEG
    edges = np.flatnonzero(np.diff(np.concatenate([[False], dark, [False]]).astype(np.int8)))
    for begin, end in edges.reshape(-1, 2).tolist():
        axes.axvspan(x[begin], x[min(end, x.size - 1)], color=_NIGHT, linewidth=0, zorder=0)
    horizon = passage.forecast.valid_to
    if horizon < times[-1]:
        known_to = max(float(_x([horizon])[0]), float(x[0]))
        axes.axvspan(
            known_to, x[-1], facecolor="none", edgecolor="#b5b5b5", hatch="//", linewidth=0, zorder=0.5
        )


def _name_the_end(axes: Axes, times: list[datetime], passage: Passage, words: Words) -> None:
    """Write beside the hatching what it means, where there is room."""
    begin, horizon, end = times[0], passage.forecast.valid_to, times[-1]
    if horizon < end and (end - max(horizon, begin)) > 0.2 * (end - begin):
        middle = max(horizon, begin) + (end - max(horizon, begin)) / 2
        axes.text(
            float(_x([middle])[0]), 0.04, words.say("beyond the forecast"), fontsize=6.5, color=_INK,
            horizontalalignment="center", transform=axes.get_xaxis_transform(),
            bbox={"facecolor": "white", "alpha": 0.8, "linewidth": 0, "pad": 1.5},
        )  # fmt: skip


def _set_times(axes: Axes, times: list[datetime], words: Words, *, labels: bool) -> None:
    """Mark even hours; a label has the day where a new one begins."""
    hours = (times[-1] - times[0]).total_seconds() / 3600.0
    step = next((s for s in _TICKS_H if hours / s <= _MOST_TICKS), _TICKS_H[-1] * 2)
    first = times[0].replace(hour=0, minute=0, second=0, microsecond=0)
    count = int((times[-1] - first).total_seconds() // (step * 3600)) + 1
    marks = [first + timedelta(hours=step * k) for k in range(count)]
    marks = [mark for mark in marks if mark >= times[0]]
    axes.set_xlim(*_x([times[0], times[-1]]))
    axes.set_xticks(_x(marks))
    days: set[int] = set()
    texts = []
    for mark in marks:
        new = mark.day not in days
        days.add(mark.day)
        day = words.day_time(mark, year=False).rpartition(" ")[0]
        texts.append(f"{mark:%H:%M}\n{day}" if new else f"{mark:%H:%M}")
    axes.set_xticklabels(texts if labels else [])
