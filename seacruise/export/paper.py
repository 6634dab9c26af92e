"""A sheet of paper: its size, its margins, and writing on it at inches."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from seacruise.export.chartwork import DPI, INK

if TYPE_CHECKING:
    from matplotlib.figure import Figure

WIDTH_IN, HEIGHT_IN = 8.27, 11.69
"""A4, upright [inches]."""

LEFT, RIGHT = 0.6, WIDTH_IN - 0.6
FOOT: Final = 0.75
"""What stands lower belongs to the foot of the page [inches]."""

TOP: Final = HEIGHT_IN - 0.75
"""Where the first heading of a page stands [inches]."""

FAINT: Final = "#5b6f7d"


def new_page() -> Figure:
    """Make an empty page."""
    from matplotlib.figure import Figure

    return Figure(figsize=(WIDTH_IN, HEIGHT_IN), dpi=DPI, facecolor="white")


def write(
    page: Figure, x_in: float, y_in: float, text: str, *, size: float = 8.5, color: str = INK,
    bold: bool = False, align: str = "left",
) -> None:  # fmt: skip
    """Write a line at inches from the left and from the bottom."""
    page.text(
        x_in / WIDTH_IN,
        y_in / HEIGHT_IN,
        text,
        fontsize=size,
        color=color,
        fontweight="bold" if bold else "normal",
        horizontalalignment=align,
        verticalalignment="baseline",
    )


def write_line(page: Figure, y_in: float, text: str, *, size: float = 8.5, color: str = INK) -> None:
    """Write a line from the left margin on."""
    write(page, LEFT, y_in, text, size=size, color=color)


def band(page: Figure, y_in: float, height_in: float) -> None:
    """Shade a line of a table, so that the eye stays in it."""
    from matplotlib.patches import Rectangle

    corner = ((LEFT - 0.05) / WIDTH_IN, (y_in - 0.3 * height_in) / HEIGHT_IN)
    size = (RIGHT - LEFT + 0.1) / WIDTH_IN, height_in / HEIGHT_IN
    page.add_artist(Rectangle(corner, *size, facecolor="#f1f4f7", linewidth=0, zorder=-1))
