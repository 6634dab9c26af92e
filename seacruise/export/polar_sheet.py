"""The sheet that pictures of polars are drawn on: light or dark, with title, legends and source."""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass
from textwrap import fill, shorten
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from seacruise.errors import InputError

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.colors import Colormap
    from matplotlib.figure import Figure
    from matplotlib.legend import Legend

DPI: Final = 150
_KEY_LETTERS: Final = 22
WIDTH_IN, HEIGHT_IN = 9.0, 8.0
_MARGIN_IN: Final = 0.55
_HEAD_IN: Final = 1.15
_FOOT_IN: Final = 0.75

FORMS: Final = ("png", "pdf", "svg")
"""Formats of a picture; also its file's ending."""

DASHES: Final[tuple[Any, ...]] = ("-", (0, (5, 2)), (0, (1.5, 1.5)), (0, (7, 2, 1.5, 2)))
"""Of the yachts that are compared, the first one's line is whole."""

MOST_YACHTS: Final = len(DASHES)

# Okabe & Ito's colours, told apart with any kind of colour vision (jfly.uni-koeln.de/color); yellow is left
# out, which does not show on white.
SAIL_COLOURS: Final = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#999999")


@dataclass(frozen=True, slots=True)
class Theme:
    """Colours of a sheet; ``ramp`` is the part of viridis that stands out against its ground."""

    name: str
    paper: str
    ink: str
    muted: str
    grid: str
    ramp: tuple[float, float]
    accent: str
    second: str


LIGHT: Final = Theme("light", "#FFFFFF", "#14304A", "#52687B", "#CFDAE3", (0.0, 0.88), "#A8126F", "#B34700")
DARK: Final = Theme("dark", "#141E27", "#E3ECF3", "#A9BDCC", "#3B4C5A", (0.32, 1.0), "#F08CCB", "#FFB066")


def wind_colours(theme: Theme, number: int) -> list[tuple[float, float, float, float]]:
    """Colours of some winds in their order: viridis keeps it for every kind of colour vision and in print."""
    from matplotlib import colormaps

    low, high = theme.ramp
    places = np.linspace(low, high, number) if number > 1 else np.array([(low + high) / 2])
    return [(r, g, b, a) for r, g, b, a in colormaps["viridis"](places).tolist()]


def speed_map() -> Colormap:
    """Colours of boat speed where a whole area is filled."""
    from matplotlib import colormaps

    return colormaps["viridis"]


def canvas(theme: Theme, *, title: str, subtitle: str, foot: Sequence[str]) -> Figure:
    """Empty sheet with its words.

    Parameters
    ----------
    foot
        Lines at the bottom: where the figures are from.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(WIDTH_IN, HEIGHT_IN), dpi=DPI, facecolor=theme.paper)

    def write(x_in: float, y_in: float, text: str, **style: Any) -> None:
        figure.text(x_in / WIDTH_IN, y_in / HEIGHT_IN, text, parse_math=False, **style)

    head = shorten(title, 110, placeholder=" ...")
    size = min(16.0, 100.0 * WIDTH_IN / max(len(head), 1))
    write(_MARGIN_IN, HEIGHT_IN - 0.5, head, fontsize=size, color=theme.ink, fontweight="bold")
    write(_MARGIN_IN, HEIGHT_IN - 0.8, shorten(subtitle, 130), fontsize=9, color=theme.muted)
    lines = [shorten(line, 150, placeholder=" ...") for line in foot][:4]
    for number, line in enumerate(reversed(lines)):
        write(_MARGIN_IN, 0.2 + 0.14 * number, line, fontsize=7, color=theme.muted)
    return figure


def room(left: float = 0.0, width: float = 1.0) -> tuple[float, float, float, float]:
    """Part of the sheet between head and foot, for ``add_axes``.

    Parameters
    ----------
    left, width
        Where it begins and how wide it is, in parts of the room between the margins.
    """
    inner = WIDTH_IN - 2 * _MARGIN_IN
    height = HEIGHT_IN - _HEAD_IN - _FOOT_IN
    return (
        (_MARGIN_IN + left * inner) / WIDTH_IN,
        _FOOT_IN / HEIGHT_IN,
        width * inner / WIDTH_IN,
        height / HEIGHT_IN,
    )


def dress(axes: Axes, theme: Theme) -> None:
    """Give axes the colours of the sheet."""
    axes.set_facecolor(theme.paper)
    axes.tick_params(labelsize=8, colors=theme.muted, labelcolor=theme.ink)
    axes.grid(color=theme.grid, linewidth=0.6)
    axes.set_axisbelow(True)
    for spine in axes.spines.values():
        spine.set_color(theme.muted)
        spine.set_linewidth(0.8)


def halo(theme: Theme) -> list[Any]:
    """Rim in the colour of the paper, so that words hold on lines."""
    from matplotlib.patheffects import withStroke

    return [withStroke(linewidth=2.5, foreground=theme.paper)]


def key(
    figure: Figure,
    theme: Theme,
    entries: Sequence[tuple[Any, str]],
    *,
    title: str,
    place: tuple[float, float],
) -> Legend:
    """Legend of handles and their words, its upper left corner at a place in parts of the sheet."""
    legend = figure.legend(
        [handle for handle, _ in entries],
        # A label that begins with an underscore would be left out; a name may.
        ["\u200b" + fill(shorten(words, 70, placeholder=" ..."), _KEY_LETTERS) for _, words in entries],
        title=title,
        loc="upper left",
        bbox_to_anchor=place,
        borderaxespad=0.0,
        fontsize=8.5,
        title_fontproperties={"size": 8.5, "weight": "bold"},
        alignment="left",
        frameon=False,
        labelcolor=theme.ink,
        handlelength=2.6,
    )
    legend.get_title().set_color(theme.ink)
    for text in legend.get_texts():
        text.set_parse_math(False)
    return legend


def below(figure: Figure, legend: Legend, gap: float = 0.02) -> tuple[float, float]:
    """Place for the next legend, under this one."""
    box = legend.get_window_extent()
    x, y = figure.transFigure.inverted().transform((box.x0, box.y0))
    return float(x), float(y) - gap


def saved(figure: Figure, form: str) -> bytes:
    """Picture as the bytes of a file.

    Raises
    ------
    InputError
        There is no such format.
    """
    # No version and no date in the file: the same polar gives the same picture.
    metadata: dict[str, dict[str, Any]] = {
        "png": {"Software": "SeaCruise"},
        "pdf": {"Creator": "SeaCruise", "Producer": "SeaCruise", "CreationDate": None},
        "svg": {"Creator": "SeaCruise", "Date": None},
    }
    if form not in metadata:
        raise InputError(f"There is no picture format {form!r}; choose one of {', '.join(FORMS)}.")
    picture = io.BytesIO()
    # Faces that a surface leaves out have whatever stood in memory for corners, and are turned all the same.
    with np.errstate(over="ignore", invalid="ignore"):
        figure.savefig(picture, format=form, facecolor=figure.get_facecolor(), metadata=metadata[form])
    return picture.getvalue()
