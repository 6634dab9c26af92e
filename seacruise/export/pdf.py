"""The passage plan as a PDF: what is printed and lies on the chart table.

Page 1 has summary, chart and notices; page 2 the weather along the passage and the legs, which go on over as
many pages as they need.
"""

from __future__ import annotations

import io
from collections.abc import Sequence
from datetime import datetime
from pathlib import Path
from textwrap import shorten, wrap
from typing import TYPE_CHECKING, Final

from seacruise.atomic import write_atomically
from seacruise.export.chart import (
    _INK,
    _MAGENTA,
    _WATER,
    DPI,
    _draw_barbs,
    _draw_graticule,
    _draw_land,
    _draw_passage,
    _draw_scale_bar,
    _draw_waypoints,
    _Frame,
    _mercator,
)
from seacruise.export.meteogram import draw_meteogram
from seacruise.export.textform import (
    format_course,
    format_day_time,
    format_duration,
    manoeuvres,
    title,
)
from seacruise.geodesy import format_position
from seacruise.passage import Passage, Place, Waypoint
from seacruise.sun import night_hours

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from seacruise.weather.wind import Wind

WIDTH_IN, HEIGHT_IN = 8.27, 11.69
"""A4, upright [inches]."""

_LEFT, _RIGHT = 0.6, WIDTH_IN - 0.6
_FOOT: Final = 0.75
"""What stands lower belongs to the foot of the page [inches]."""

_LINE: Final = 0.185
"""Height of a line of the table of legs [inches]."""

_NOTICE_LINE: Final = 0.15
_NOTICE_LINES: Final = 16
"""Height of a line of notices [inches], and how many stand on page 1; others have a page of their own."""

_LABEL_IN, _LABEL_ROOM_IN = 1.15, 0.5
"""Room for the names of the ends on the chart, to each side and above and below [inches]."""

_LONG_NAME: Final = 34
_FAINT: Final = "#5b6f7d"

NOT_A_CHART: Final = (
    "Not a navigation chart. A planning aid: check every leg on official charts before sailing."
)
_COAST: Final = "Coast: (c) OpenStreetMap contributors, ODbL (Baltic only)."

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


def pdf(passage: Passage, *, wind: Wind | None = None) -> bytes:
    """Make the PDF.

    The same passage gives the same bytes: no time of writing is in it.

    Parameters
    ----------
    wind
        Source of the chart's barbs, and of gusts and waves; without it there are none.
    """
    import matplotlib as mpl
    from matplotlib.backends.backend_pdf import PdfPages

    file = io.BytesIO()
    about = {"Title": title(passage), "Subject": NOT_A_CHART, "Creator": "SeaCruise", "CreationDate": None}
    # TrueType, so that letters beyond Latin-1 stay text that can be searched.
    with mpl.rc_context({"pdf.fonttype": 42}), PdfPages(file, metadata=about) as book:
        for page in pages(passage, wind=wind):
            book.savefig(page)
    return file.getvalue()


def write_pdf(passage: Passage, path: Path, *, wind: Wind | None = None) -> None:
    """Write `pdf` to a file.

    Raises
    ------
    InputError
        The file cannot be written.
    """
    write_atomically(path, pdf(passage, wind=wind), what="PDF file")


def pages(passage: Passage, *, wind: Wind | None = None) -> list[Figure]:
    """Draw the pages, A4 upright."""
    first = _page()
    y = _write_head(first, passage)
    notices = _notice_lines(passage)
    low = _write_notices(first, notices[:_NOTICE_LINES])
    _draw_chart(first, passage, wind, top_in=y - 0.15, bottom_in=low + 0.45)
    sheets = [first, _page()]
    _write_line(sheets[1], HEIGHT_IN - 0.72, "Weather along the passage", size=12)
    _write_line(
        sheets[1],
        HEIGHT_IN - 0.92,
        "Shaded: sun more than 6° below the horizon. Hatched: beyond the end of the forecast. "
        "Dotted: angle of the true wind.",
        size=7,
        color=_FAINT,
    )
    top = HEIGHT_IN - 1.05
    height = 3.6
    box = (
        (_LEFT + 0.25) / WIDTH_IN,
        (top - height) / HEIGHT_IN,
        (_RIGHT - _LEFT - 0.65) / WIDTH_IN,
        height / HEIGHT_IN,
    )
    draw_meteogram(sheets[1], box, passage, wind=wind)
    rows = list(enumerate(passage.waypoints))
    y = top - height - 0.75
    while rows:
        y, rows = _write_legs(sheets[-1], rows, y, passage)
        if rows:
            sheets.append(_page())
            y = HEIGHT_IN - 0.75
    sheets += _more_notices(notices[_NOTICE_LINES:])
    for number, sheet in enumerate(sheets, 1):
        _write_foot(sheet, passage, f"Page {number} of {len(sheets)}")
    return sheets


def _page() -> Figure:
    from matplotlib.figure import Figure

    return Figure(figsize=(WIDTH_IN, HEIGHT_IN), dpi=DPI, facecolor="white")


def _write(
    page: Figure, x_in: float, y_in: float, text: str, *, size: float = 8.5, color: str = _INK,
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


def _write_line(page: Figure, y_in: float, text: str, *, size: float = 8.5, color: str = _INK) -> None:
    _write(page, _LEFT, y_in, text, size=size, color=color)


def _write_head(page: Figure, passage: Passage) -> float:
    """Write title and summary; returns how low they reach [inches from the bottom]."""
    ends = [shorten(place.name, _LONG_NAME, placeholder=" ...") for place in (passage.start, passage.end)]
    head = f"{' - '.join(ends)}: {format_duration(passage.duration_h)}"
    y = HEIGHT_IN - 0.85
    _write_line(page, y, head, size=min(17.0, 17.0 * 50 / len(head)))
    y -= 0.34
    rows = _summary(passage)
    half = (len(rows) + 1) // 2
    for k, (label, text) in enumerate(rows):
        x = _LEFT if k < half else WIDTH_IN / 2 + 0.1
        at = y - (k % half) * 0.19
        _write(page, x, at, label, size=8, color=_FAINT)
        _write(page, x + 0.95, at, shorten(text, 42, placeholder=" ..."), size=8)
    return y - (half - 1) * 0.19


def _summary(passage: Passage) -> list[tuple[str, str]]:
    track = passage.track
    rows = [
        ("Yacht", passage.yacht),
        ("From", _place(passage.start)),
        ("To", _place(passage.end)),
        ("Departure", f"{format_day_time(passage.departure)} UTC"),
        ("Arrival", f"{format_day_time(passage.arrival)} UTC"),
        ("Distance", f"{passage.distance_nm:.1f} nm, {passage.direct_distance_nm:.1f} nm direct"),
        ("Mean speed", f"{passage.mean_speed_kn:.1f} kn"),
        ("Strongest wind", f"{passage.max_tws_kn:.0f} kn"),
        ("Manoeuvres", manoeuvres(passage)),
        ("At night", f"{night_hours(track.time, track.lat, track.lon):.0f} h"),
        ("Lower bound", format_duration(passage.lower_bound_h)),
    ]
    if passage.motor_h > 0:
        rows.append(("Engine", f"{format_duration(passage.motor_h)}, {passage.fuel_l:.0f} l of fuel"))
    if passage.manoeuvre_h > 0:
        rows.append(("Turning", f"{format_duration(passage.manoeuvre_h)} for manoeuvres"))
    if passage.beyond_forecast_h > 0:
        name = "Fading wind" if passage.beyond == "fade" else "Held wind"
        rows.append((name, f"{format_duration(passage.beyond_forecast_h)} beyond the forecast"))
    return rows


def _place(place: Place) -> str:
    snapped = f", {place.snapped_nm:.1f} nm from the harbour" if place.snapped_nm >= 0.05 else ""
    return f"{shorten(place.name, 40 - len(snapped), placeholder=' ...')}{snapped}"


def _notice_lines(passage: Passage) -> list[str]:
    return [line for notice in passage.notices if notice for line in wrap(f"! {notice}", 118)]


def _write_notices(page: Figure, lines: Sequence[str]) -> float:
    """Write notices above the foot of the page; returns how high they reach [inches from the bottom]."""
    y = _FOOT + 0.12
    for line in reversed(lines):
        _write_line(page, y, line, size=7.5)
        y += _NOTICE_LINE
    return y


def _more_notices(lines: Sequence[str]) -> list[Figure]:
    """Pages for the notices that page 1 has no room for."""
    most = int((HEIGHT_IN - 1.3 - _FOOT) / _NOTICE_LINE)
    sheets = []
    for begin in range(0, len(lines), most):
        sheets.append(_page())
        _write_line(sheets[-1], HEIGHT_IN - 0.75, "Notices (continued)", size=12)
        for k, line in enumerate(lines[begin : begin + most]):
            _write_line(sheets[-1], HEIGHT_IN - 1.05 - k * _NOTICE_LINE, line, size=7.5)
    return sheets


def _write_foot(page: Figure, passage: Passage, number: str) -> None:
    forecast = passage.forecast
    issued = f", issued {format_day_time(forecast.issued)} UTC" if forecast.issued else ""
    span = f"{format_day_time(forecast.valid_from)} to {format_day_time(forecast.valid_to)} UTC"
    source = shorten(f"Wind: {forecast.source}{issued}", 78, placeholder=" ...")
    _write(page, _LEFT, 0.58, f"{source}; {span}.", size=6.5, color=_FAINT)
    _write(page, _LEFT, 0.46, f"{_COAST} Polar: {shorten(passage.yacht, 60)}.", size=6.5, color=_FAINT)
    _write(page, _LEFT, 0.28, NOT_A_CHART, size=8, color=_MAGENTA, bold=True)
    _write(page, _RIGHT, 0.28, number, size=8, color=_FAINT, align="right")


def _draw_chart(
    page: Figure, passage: Passage, wind: Wind | None, *, top_in: float, bottom_in: float
) -> None:
    """Draw the chart across the page, between two heights."""
    left, right = _LEFT + 0.25, _RIGHT
    frame = _frame(passage, right - left, top_in - bottom_in)
    axes = page.add_axes(
        (
            left / WIDTH_IN,
            bottom_in / HEIGHT_IN,
            (right - left) / WIDTH_IN,
            (top_in - bottom_in) / HEIGHT_IN,
        )
    )
    axes.set_facecolor(_WATER)
    axes.set_xlim(frame.west, frame.east)
    axes.set_ylim(frame.low, frame.high)
    axes.set_aspect("equal")
    axes.tick_params(labelsize=7, colors=_INK, length=3)
    land = _draw_land(axes, frame)
    _draw_graticule(axes, frame)
    if wind is not None:
        middle = passage.departure + (passage.arrival - passage.departure) / 2
        _draw_barbs(axes, frame, wind, middle, land)
        _write(
            page, right, bottom_in - 0.32, f"Barbs: {format_day_time(middle)} UTC", size=7, color=_FAINT,
            align="right",
        )  # fmt: skip
    line = _draw_passage(axes, passage)
    _draw_waypoints(axes, passage)
    _draw_scale_bar(axes, frame)
    inset = axes.inset_axes((0.955, 0.05, 0.018, 0.22), zorder=12)
    bar = page.colorbar(line, cax=inset)
    inset.yaxis.set_ticks_position("left")
    inset.yaxis.set_label_position("left")
    bar.set_label("True wind [kn]", fontsize=7, color=_INK)
    inset.tick_params(labelsize=7, colors=_INK)


def _frame(passage: Passage, width_in: float, height_in: float) -> _Frame:
    """Fit the chart round the passage, with room for labels, in the shape of its place on the page."""
    x, y = passage.track.lon, _mercator(passage.track.lat)
    west, east, low, high = float(x.min()), float(x.max()), float(y.min()), float(y.max())
    least = 0.15
    wide = max(east - west, least) / (1.0 - 2 * _LABEL_IN / width_in)
    tall = max(high - low, least) / max(0.2, 1.0 - 2 * _LABEL_ROOM_IN / height_in)
    shape = width_in / height_in
    wide, tall = max(wide, tall * shape), max(tall, wide / shape)
    middle_x, middle_y = (west + east) / 2, (low + high) / 2
    return _Frame(
        west=middle_x - wide / 2,
        east=middle_x + wide / 2,
        low=middle_y - tall / 2,
        high=middle_y + tall / 2,
        width_in=width_in,
        height_in=height_in,
    )


def _write_legs(
    page: Figure, rows: Sequence[tuple[int, Waypoint]], y: float, passage: Passage
) -> tuple[float, list[tuple[int, Waypoint]]]:
    """Write as many legs as fit; returns how low they reach [inches] and those that are left."""
    more = " (continued)" if rows[0][0] else ""
    _write_line(page, y, f"Legs{more}", size=12)
    y -= 0.27
    heads = _columns(passage)
    for text, x, align in heads:
        _write(page, _LEFT + x, y, text, size=7, color=_FAINT, align=align)
    fitting = max(1, int((y - _FOOT - 0.1) / _LINE))
    for k, (number, waypoint) in enumerate(rows[:fitting]):
        y -= _LINE
        if k % 2 == 0:
            _band(page, y)
        for cell, (_, x, align) in zip(_cells(number, waypoint, passage), heads, strict=True):
            if cell:
                _write(page, _LEFT + x, y, cell, size=7.5, align=align)
    return y, list(rows[fitting:])


def _band(page: Figure, y: float) -> None:
    """Shade a line of the table, so that the eye stays in it."""
    from matplotlib.patches import Rectangle

    corner = ((_LEFT - 0.05) / WIDTH_IN, (y - 0.055) / HEIGHT_IN)
    size = (_RIGHT - _LEFT + 0.1) / WIDTH_IN, _LINE / HEIGHT_IN
    page.add_artist(Rectangle(corner, *size, facecolor="#f1f4f7", linewidth=0, zorder=-1))


def _columns(passage: Passage) -> tuple[tuple[str, float, str], ...]:
    return (*COLUMNS[:3], STEER, *COLUMNS[3:]) if _has_current(passage) else COLUMNS


def _has_current(passage: Passage) -> bool:
    return any(waypoint.current_kn is not None for waypoint in passage.waypoints)


def _cells(number: int, waypoint: Waypoint, passage: Passage) -> tuple[str, ...]:
    time = f"{_short_time(waypoint.time)}"
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
        f"{waypoint.leg_nm:.1f}",
        f"{waypoint.boat_speed_kn:.1f}",
        f"{waypoint.tws_kn:.0f}",
        format_course(waypoint.twd_deg),
        f"{waypoint.twa_deg:.0f}°",
        "engine" if waypoint.motor else waypoint.tack or "",
    )


def _short_time(time: datetime) -> str:
    """Write day and time without the year: ``Sun 20 Nov 06:00``."""
    day, date, month, _, clock = format_day_time(time).split()
    return f"{day} {date} {month} {clock}"
