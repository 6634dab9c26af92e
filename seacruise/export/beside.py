"""What lies beside a passage on a picture: members of an ensemble, and other ways, faint under it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Literal

import numpy as np
from numpy.typing import NDArray

from seacruise.export.chartwork import INK, mercator

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.lines import Line2D
    from matplotlib.transforms import Bbox

    from seacruise.passage import Passage

_MEMBER: Final = "#00695c"


@dataclass(frozen=True, slots=True, eq=False)
class Beside:
    """Lines beside a passage, each ``(n, 2)`` of lat and lon [degrees].

    Attributes
    ----------
    members
        The fastest passage in each member of an ensemble.
    ways
        Other ways, with their names.
    """

    members: tuple[NDArray[np.float64], ...] = ()
    ways: tuple[tuple[str, NDArray[np.float64]], ...] = ()


NOTHING: Final = Beside()


def draw_beside(axes: Axes, beside: Beside, passage: Passage) -> list[Bbox]:
    """Draw the lines under a passage, and say what they are in a corner; returns where that lies [pixels]."""
    handles: list[Line2D] = []
    for line in beside.members:
        handles[:1] = axes.plot(
            line[:, 1],
            mercator(line[:, 0]),
            color=_MEMBER,
            linewidth=0.8,
            alpha=0.6,
            zorder=4,
            label=f"fastest in each of {len(beside.members)} members",
        )
    for number, (name, line) in enumerate(beside.ways):
        # Told apart without colours: each has dashes of its own.
        dashes = (6, 2, *(1, 2) * number)
        handles += axes.plot(
            line[:, 1], mercator(line[:, 0]), color=INK, linewidth=1.4, dashes=dashes, zorder=4, label=name
        )
    if not handles:
        return []
    engine = axes.get_legend()
    told = axes.legend(
        handles=handles,
        loc=_corner(axes, passage),
        fontsize=8,
        handlelength=6.0,
        labelcolor=INK,
        framealpha=0.9,
    )
    # Above the lines, below the names.
    told.set_zorder(8)
    if engine is not None:
        axes.add_artist(engine)
    return [told.get_window_extent()]


def _corner(axes: Axes, passage: Passage) -> Literal["upper right", "lower right"]:
    """Choose the corner on the right that the passage keeps farther off; on the left lies the scale."""
    track = passage.track
    points = np.column_stack([track.lon, mercator(track.lat)])
    east, (low, high) = axes.get_xlim()[1], axes.get_ylim()
    upper, lower = (np.hypot(*(points - (east, y)).T).min() for y in (high, low))
    return "upper right" if upper > lower else "lower right"
