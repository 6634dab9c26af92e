"""Colours of the chart, after IHO S-52: by day, at dusk, and by night for eyes that are used to the dark."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass, fields
from typing import Final

from PySide6.QtGui import QColor


@dataclass(frozen=True, slots=True, eq=False)
class Palette:
    """Colours for one light.

    Attributes
    ----------
    ink
        Names and lines that must be read.
    casing, keel
        Rim of symbols, and of the route.
    member
        Lines and dots of the members of an ensemble.
    night
        Shade under those parts of the route that are sailed in the dark.
    card, card_line
        Ground and frame of legend and read-outs.
    field_alpha
        How much of the wind's colour field covers the chart, 0 to 255.
    depths
        Tints of the water from shallow to deep, one more than `seacruise.sea.depth.BAND_LIMITS_M`; as in
        S-52 what is deep is the quiet ground, by day nearly white, at dusk and by night nearly black.
    """

    name: str
    water: QColor
    land: QColor
    shore: QColor
    uncharted: QColor
    uncharted_hatch: QColor
    graticule: QColor
    graticule_text: QColor
    lattice: QColor
    barb: QColor
    ink: QColor
    halo: QColor
    magenta: QColor
    casing: QColor
    keel: QColor
    night: QColor
    trouble: QColor
    isochrone: QColor
    member: QColor
    zone: QColor
    sun: QColor
    card: QColor
    card_line: QColor
    focus: QColor
    field_alpha: int
    depths: tuple[QColor, ...]


def _palette(name: str, field_alpha: int, depths: str, **colours: str) -> Palette:
    """Palette of colours written ``#RRGGBB`` or ``#AARRGGBB``."""
    return Palette(
        name=name,
        field_alpha=field_alpha,
        depths=tuple(QColor(text) for text in depths.split()),
        **{key: QColor(text) for key, text in colours.items()},
    )


DAY: Final = _palette(
    "day",
    112,
    "#BFDCEE #D0E6F3 #DEEEF7 #EAF4FA #F5FAFD",
    water="#E4F1F8",
    land="#EFE2BD",
    shore="#9C8552",
    uncharted="#E3E8EC",
    uncharted_hatch="#CBD5DC",
    graticule="#343C698C",
    graticule_text="#4A6A83",
    lattice="#3C125C8A",
    barb="#2C4A63",
    ink="#14304A",
    halo="#E1FFFFFF",
    magenta="#B0157A",
    casing="#FFFFFF",
    keel="#14304A",
    night="#55203060",
    trouble="#B3261E",
    isochrone="#0B5C8A",
    member="#00695C",
    zone="#B0157A",
    sun="#8A5A00",
    card="#EBFFFFFF",
    card_line="#CFDAE3",
    focus="#1C86C4",
)
DUSK: Final = _palette(
    "dusk",
    95,
    "#2F4C62 #294355 #233948 #1D2F3C #172631",
    water="#20313F",
    land="#3B382B",
    shore="#8A7C56",
    uncharted="#1B242C",
    uncharted_hatch="#2C3943",
    graticule="#3C9FB8C9",
    graticule_text="#94AEC0",
    lattice="#3C7FB4D6",
    barb="#B9CEDD",
    ink="#D3E0EA",
    halo="#C8141E27",
    magenta="#E56DB9",
    casing="#10181F",
    keel="#C9D5DE",
    night="#8C05080B",
    trouble="#FF8A80",
    isochrone="#7CC0E8",
    member="#6FCFB2",
    zone="#E56DB9",
    sun="#F0B95A",
    card="#EB1C2833",
    card_line="#3B4C5A",
    focus="#5FA8D8",
)
NIGHT: Final = _palette(
    "night",
    44,
    "#16222B #111A21 #0C1318 #080D11 #05080A",
    water="#070A0D",
    land="#1C170F",
    shore="#54452C",
    uncharted="#0A0B0C",
    uncharted_hatch="#171615",
    graticule="#3C7A4436",
    graticule_text="#8E5240",
    lattice="#307A3A2E",
    barb="#9E5C48",
    ink="#BE7058",
    halo="#C8040506",
    magenta="#C24F78",
    casing="#050607",
    keel="#7A5348",
    night="#7048342E",
    trouble="#D9534A",
    isochrone="#8C5A3C",
    member="#927E42",
    zone="#A8405F",
    sun="#A8732E",
    card="#EB0B0A0A",
    card_line="#3A2620",
    focus="#8A4A34",
)
PALETTES: Final = {palette.name: palette for palette in (DAY, DUSK, NIGHT)}

WIND_LIMITS_KN: Final = (5.0, 10.0, 15.0, 20.0, 25.0, 30.0)
"""Where one colour of the route ends and the next begins, true wind speed [kn]."""

WIND_COLOURS: Final = tuple(
    QColor(name) for name in ("#F0F921", "#FCA636", "#EE7B51", "#D5536F", "#A82296", "#6A00A8", "#26066E")
)
"""From calm to gale. Samples of matplotlib's plasma, darkening evenly, so that they are told apart by
their lightness alone (Nuñez et al. 2018, doi:10.1371/journal.pone.0199239)."""


def wind_class(tws_kn: float) -> int:
    """Give the number of the colour for a true wind speed [kn]."""
    return bisect_right(WIND_LIMITS_KN, tws_kn)


def class_name(limits: tuple[float, ...], number: int) -> str:
    """Span of a class between limits, for a legend."""
    if number == 0:
        return f"< {limits[0]:.0f}"
    if number == len(limits):
        return f"> {limits[-1]:.0f}"
    return f"{limits[number - 1]:.0f}–{limits[number]:.0f}"


def wind_class_name(number: int) -> str:
    """Span of a colour of the wind, for the legend."""
    return class_name(WIND_LIMITS_KN, number)


def dimmed(colour: QColor, palette: Palette) -> QColor:
    """Colour of a class, as bright as a light allows: by night nothing may dazzle."""
    return colour.darker(190) if palette is NIGHT else colour


def colours_of(palette: Palette) -> dict[str, QColor]:
    """All colours of a palette by name."""
    return {f.name: value for f in fields(palette) if isinstance(value := getattr(palette, f.name), QColor)}
