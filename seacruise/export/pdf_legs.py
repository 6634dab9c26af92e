"""The table of legs and the log of the passage plan, on as many pages as they need."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from textwrap import shorten, wrap
from typing import TYPE_CHECKING, Final

from seacruise.export.paper import FAINT, FOOT, LEFT, TOP, band, new_page, write, write_line
from seacruise.export.textform import format_course
from seacruise.export.words import Words
from seacruise.geodesy import format_position
from seacruise.narrative import Entry
from seacruise.passage import Passage, Waypoint

if TYPE_CHECKING:
    from matplotlib.figure import Figure

COLUMNS: Final = (
    ("No", 0.00, "left"),
    ("Time (UTC)", 0.32, "left"),
    ("Position", 1.42, "left"),
    ("Course", 3.62, "right"),
    ("Dist nm", 4.22, "right"),
    ("Speed kn", 4.86, "right"),
    ("TWS kn", 5.42, "right"),
    ("TWD", 5.86, "right"),
    ("TWA", 6.32, "right"),
    ("Tack", 6.42, "left"),
)
"""Heads of the table of legs: text, place from the left margin [inches] and the side it is aligned to."""

STEER: Final = ("Steer", 3.12, "right")
"""Head of the course to steer, which stands before the course made good where there is a current."""

_HEADING, _HEADS = 0.27, 0.22
"""Room below a heading, and between it and the line above [inches]."""

_FEWEST_LINES: Final = 8
"""A log of fewer lines than this is not worth shortening: it gets a page of its own."""

_LOG_TEXT, _LETTERS = 0.75, 100
"""Where the text of a log's line begins, from the left margin [inches], and its letters at most."""

_WEIGHTS: Final = {
    "departure": 0, "arrival": 0, "waiting": 0, "forecast-ends": 0, "engine-on": 1, "engine-off": 1,
    "rounding": 2, "passing": 2, "strongest-wind": 2, "beat": 3, "run": 3, "waves": 3, "sunset": 4,
    "sunrise": 4, "current": 4, "tack": 5, "gybe": 5, "wind-up": 6, "wind-down": 6, "point-of-sail": 7,
}  # fmt: skip
"""What a log that must be short keeps first; the legs tell tacks and gybes anyway."""


LogLine = tuple[str, str]
"""Time and text; a line that goes on has no time."""


@dataclass(frozen=True, slots=True)
class Style:
    """How closely a page is written: height of the weather, of a line [inches], and size of letters [pt]."""

    weather_in: float
    line_in: float
    size: float


AIRY: Final = Style(3.4, 0.185, 7.5)
DENSE: Final = Style(2.6, 0.143, 6.8)


@dataclass(frozen=True, slots=True)
class Layout:
    """How the second page is written, and the lines of the log that it has room for."""

    style: Style
    log: tuple[LogLine, ...]


def choose_layout(passage: Passage, entries: Sequence[Entry], words: Words, *, above_in: float) -> Layout:
    """Choose so that legs and log stand on the second page where they can.

    A log that is too long for what the legs leave is shortened; legs never are. Where even closely written
    legs leave no room for a log, both go on over more pages.

    Parameters
    ----------
    above_in
        Height of the page below its heading down to the legs, but for the weather itself [inches].
    """
    log = _log_lines(entries, words)
    for style in (AIRY, DENSE):
        if len(log) <= _room_for_log(passage, style, above_in):
            return Layout(style, tuple(log))
    room = _room_for_log(passage, DENSE, above_in)
    if room < _FEWEST_LINES:
        return Layout(DENSE, tuple(log))
    kept = sorted(range(len(entries)), key=lambda k: (_WEIGHTS[entries[k].kind], k))
    while len(short := _log_lines([entries[k] for k in sorted(kept)], words)) > room - 1:
        kept.pop()
    told = words.fill("and {n} smaller changes of course and wind", n=len(entries) - len(kept))
    return Layout(DENSE, (*short, ("", f"({told})")))


def _room_for_log(passage: Passage, style: Style, above_in: float) -> int:
    """Lines of the log for which there is room on the page after all legs; negative when legs are left."""
    height = TOP - FOOT - above_in - style.weather_in - 2 * _HEADING - 2 * _HEADS
    return int(height / style.line_in) - len(passage.waypoints) - 1


def _log_lines(entries: Sequence[Entry], words: Words) -> list[LogLine]:
    lines = []
    for entry in entries:
        first, *rest = wrap(words.tell(entry.phrase), _LETTERS)
        lines += [(words.clock(entry.time), first), *(("", text) for text in rest)]
    return lines


def write_legs_and_log(
    page: Figure, y: float, passage: Passage, layout: Layout, words: Words
) -> list[Figure]:
    """Write the table and the log below it; returns the pages that were needed besides."""
    more: list[Figure] = []
    rows = list(enumerate(passage.waypoints))
    while rows:
        sheet = more[-1] if more else page
        y, rows = _write_legs(sheet, rows, y, passage, style=layout.style, words=words)
        if rows:
            more.append(new_page())
            y = TOP
    lines = list(layout.log)
    while lines:
        y -= layout.style.line_in + _HEADS
        fitting = int((y - _HEADING + layout.style.line_in - FOOT - 0.05) / layout.style.line_in)
        if fitting < min(len(lines), 3):
            more.append(new_page())
            y = TOP + layout.style.line_in + _HEADS
            continue
        begun = len(lines) < len(layout.log)
        sheet = more[-1] if more else page
        write_line(sheet, y, words.say("Log (UTC, continued)" if begun else "Log (UTC)"), size=12)
        y -= _HEADING - layout.style.line_in
        for clock, text in lines[:fitting]:
            y -= layout.style.line_in
            write_line(sheet, y, clock, size=layout.style.size)
            write(sheet, LEFT + _LOG_TEXT, y, text, size=layout.style.size)
        lines = lines[fitting:]
        if lines:
            y = FOOT
    return more


def _write_legs(
    page: Figure,
    rows: Sequence[tuple[int, Waypoint]],
    y: float,
    passage: Passage,
    *,
    style: Style,
    words: Words,
) -> tuple[float, list[tuple[int, Waypoint]]]:
    """Write as many legs as fit; returns how low they reach [inches] and those that are left."""
    write_line(page, y, words.say("Legs (continued)" if rows[0][0] else "Legs"), size=12)
    y -= _HEADING
    heads = _columns(passage)
    for text, x, align in heads:
        write(page, LEFT + x, y, words.say(text), size=7, color=FAINT, align=align)
    fitting = max(1, int((y - FOOT - 0.05) / style.line_in))
    for k, (number, waypoint) in enumerate(rows[:fitting]):
        y -= style.line_in
        if k % 2 == 0:
            band(page, y, style.line_in)
        for cell, (_, x, align) in zip(_cells(number, waypoint, passage, words), heads, strict=True):
            if cell:
                write(page, LEFT + x, y, cell, size=style.size, align=align)
    return y, list(rows[fitting:])


def _columns(passage: Passage) -> tuple[tuple[str, float, str], ...]:
    return (*COLUMNS[:3], STEER, *COLUMNS[3:]) if _has_current(passage) else COLUMNS


def _has_current(passage: Passage) -> bool:
    return any(waypoint.current_kn is not None for waypoint in passage.waypoints)


def _cells(number: int, waypoint: Waypoint, passage: Passage, words: Words) -> tuple[str, ...]:
    time = words.day_time(waypoint.time, year=False)
    where = format_position(waypoint.lat, waypoint.lon)
    if waypoint.course_deg is None or waypoint.twd_deg is None or waypoint.twa_deg is None:
        name = shorten(passage.end.name, 40, placeholder=" ...")
        return (str(number), time, f"{where}   {name}", *[""] * (len(_columns(passage)) - 3))
    steer = waypoint.course_deg if waypoint.steer_deg is None else waypoint.steer_deg
    return (
        str(number),
        time,
        where,
        *((format_course(steer),) if _has_current(passage) else ()),
        format_course(waypoint.course_deg),
        words.fill("{value:.1f}", value=waypoint.leg_nm),
        words.fill("{value:.1f}", value=waypoint.boat_speed_kn),
        f"{waypoint.tws_kn:.0f}",
        format_course(waypoint.twd_deg),
        f"{waypoint.twa_deg:.0f}°",
        _how(waypoint, words),
    )


def _how(waypoint: Waypoint, words: Words) -> str:
    """Say the tack, and the sail where the polar knows several, or that the engine runs."""
    if waypoint.motor:
        return words.say("engine")
    tack = words.say(waypoint.tack) if waypoint.tack else ""
    if waypoint.sail is None:
        return tack
    return f"{tack[:1].upper()} {shorten(waypoint.sail, 10, placeholder='')}".strip()
