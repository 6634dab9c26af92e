"""The five pictures of a polar: slices round the wind and flat, surface, colours, and the hull of a slice.

References
----------
V. Dannenberg, R. Schueler, A. Schuermann, Appl. Sci. 12 (2022) 3085, doi 10.3390/app12063085: the pictures
of `hrosailing`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Final

from seacruise.atomic import write_atomically
from seacruise.errors import InputError
from seacruise.export import polar_areas, polar_hulls, polar_lines
from seacruise.export.polar_sheet import DARK, FORMS, LIGHT, MOST_YACHTS, Theme, saved
from seacruise.export.polar_slices import LogPoints, usual_winds
from seacruise.yacht.polar import Polar
from seacruise.yacht.tacks import TwoSided

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Yacht = Polar | TwoSided

KINDS: Final = ("polar", "flat", "surface", "colour", "hull")
"""Round the wind, over the angle, as a surface, as colours, with its hull."""

COMPARING: Final = ("polar", "flat")
"""Kinds that take several yachts."""

_MOST_WINDS: Final = {"polar": 12, "flat": 12, "hull": 3}


@dataclass(frozen=True, slots=True)
class _Order:
    """What is to be drawn; winds [kn] in increasing order."""

    yachts: tuple[Yacht, ...]
    winds: tuple[float, ...]
    points: LogPoints | None
    theme: Theme


_DRAW: Final[dict[str, Callable[[_Order], Figure]]] = {
    "polar": lambda o: polar_lines.round_the_wind(o.yachts, o.winds, points=o.points, theme=o.theme),
    "flat": lambda o: polar_lines.over_the_angle(o.yachts, o.winds, points=o.points, theme=o.theme),
    "surface": lambda o: polar_areas.surface(o.yachts[0], points=o.points, theme=o.theme),
    "colour": lambda o: polar_areas.colours(o.yachts[0], points=o.points, theme=o.theme),
    "hull": lambda o: polar_hulls.hulls(o.yachts[0], o.winds, points=o.points, theme=o.theme),
}


def polar_picture(
    yachts: Sequence[Yacht],
    kind: str,
    *,
    tws_kn: Sequence[float] = (),
    points: LogPoints | None = None,
    dark: bool = False,
    form: str = "png",
) -> bytes:
    """Draw polars and return the picture's file.

    Parameters
    ----------
    yachts
        One, or up to four to be compared in ``"polar"`` and ``"flat"``. One that is not the same on both
        tacks shows both.
    kind
        One of `KINDS`.
    tws_kn
        Winds of the slices [kn]; without them `winds_for` chooses. ``"surface"`` and ``"colour"`` show all.
    points
        Points of a log, laid over the polar; with slices those within one knot of their wind.
    form
        One of `FORMS`.

    Raises
    ------
    InputError
        There is no such kind or form, or there are too many yachts or winds for it.
    """
    winds = winds_for(yachts, kind, tws_kn)
    if form not in FORMS:
        raise InputError(f"There is no picture format {form!r}; choose one of {', '.join(FORMS)}.")
    order = _Order(tuple(yachts), winds, points, DARK if dark else LIGHT)
    return saved(_DRAW[kind](order), form)


def write_polar_picture(
    path: Path,
    yachts: Sequence[Yacht],
    kind: str,
    *,
    tws_kn: Sequence[float] = (),
    points: LogPoints | None = None,
    dark: bool = False,
) -> None:
    """Write `polar_picture` to a file, whose ending says the format.

    Raises
    ------
    InputError
        As `polar_picture`, or the file cannot be written.
    """
    picture = polar_picture(yachts, kind, tws_kn=tws_kn, points=points, dark=dark, form=form_of(path))
    write_atomically(path, picture, what="picture")


def form_of(path: Path) -> str:
    """Format of a picture by the ending of its file.

    Raises
    ------
    InputError
        The ending is that of no picture we can draw.
    """
    form = path.suffix.lower().removeprefix(".")
    if form not in FORMS:
        raise InputError(f"The picture {path.name!r} must end in .png, .pdf or .svg; give another name.")
    return form


def winds_for(yachts: Sequence[Yacht], kind: str, tws_kn: Sequence[float] = ()) -> tuple[float, ...]:
    """Check what is asked for and return the winds [kn] of its slices; none where the whole polar is shown.

    Raises
    ------
    InputError
        There is no such kind, or there are too many yachts or winds for it.
    """
    if kind not in KINDS:
        raise InputError(f"There is no picture {kind!r} of a polar; choose one of {', '.join(KINDS)}.")
    if not yachts:
        raise InputError("No yacht was named; give one to draw.")
    if len(yachts) > 1 and kind not in COMPARING:
        raise InputError(
            f"The picture {kind!r} shows one yacht, not {len(yachts)}; use polar or flat to compare."
        )
    if len(yachts) > MOST_YACHTS:
        raise InputError(f"{len(yachts)} yachts cannot be told apart; compare {MOST_YACHTS} at most.")
    if kind not in _MOST_WINDS:
        return ()
    winds = tuple(sorted(set(tws_kn))) or _usual(yachts, kind)
    if any(not 0.0 < kn <= 100.0 for kn in winds):
        raise InputError("A wind speed of a picture is out of range; give 0.5 to 100 kn.")
    if len(winds) > _MOST_WINDS[kind]:
        raise InputError(
            f"{len(winds)} winds are too many for the picture {kind!r}; give {_MOST_WINDS[kind]} at most."
        )
    return winds


def _usual(yachts: Sequence[Yacht], kind: str) -> tuple[float, ...]:
    winds = usual_winds([yacht.to_table() for yacht in yachts])
    if kind == "hull":
        return (min(winds, key=lambda kn: abs(kn - 10.0)),)
    # Of several yachts each has her curve in each wind: seven would be a thicket.
    return winds if len(yachts) == 1 else winds[1::2] or winds
