"""The passage plan as a PDF: what is printed and lies on the chart table.

Page 1 has summary, chart and notices; page 2 the weather along the passage, the legs and the log, which go on
over as many pages as they need. Nothing is told by colour alone: it is printed without, too.
"""

from __future__ import annotations

import io
from collections.abc import Sequence
from datetime import datetime
from pathlib import Path
from textwrap import shorten, wrap
from typing import TYPE_CHECKING, Final

from seacruise.atomic import write_atomically
from seacruise.export.chartlabels import draw_ports, draw_waypoints
from seacruise.export.chartwork import (
    INK,
    MAGENTA,
    WATER,
    Frame,
    draw_barbs,
    draw_graticule,
    draw_land,
    draw_passage,
    draw_scale_bar,
    framed,
    mercator,
)
from seacruise.export.meteogram import draw_meteogram
from seacruise.export.paper import (
    FAINT,
    FOOT,
    HEIGHT_IN,
    LEFT,
    RIGHT,
    TOP,
    WIDTH_IN,
    new_page,
    write,
    write_line,
)
from seacruise.export.pdf_legs import choose_layout, write_legs_and_log
from seacruise.export.textform import format_duration, title
from seacruise.export.words import ENGLISH, Words
from seacruise.narrative import tell
from seacruise.passage import Passage, Place
from seacruise.ports import load_ports
from seacruise.sun import night_hours

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from seacruise.weather.wind import Wind

_DAYS_TOLD: Final = 2
"""From so many days on the heading tells the duration in days, too."""

_HELD: Final = ("Held wind", "Fading wind")
_HELD_SHARE: Final = 0.1
"""More of the passage than this beyond the forecast is told in the colour of warnings."""

_NOTICE_LINE: Final = 0.15
_NOTICE_LINES: Final = 16
"""Height of a line of notices [inches], and how many stand on page 1; others have a page of their own."""

_LABEL_IN, _LABEL_ROOM_IN = 1.15, 0.5
"""Room for the names of the ends on the chart, to each side and above and below [inches]."""

_CAPTION, _BELOW_WEATHER = 0.30, 0.72
"""Room between the heading of the weather and its box, and between the box and the legs [inches]."""

_LONG_NAME: Final = 34
_LABEL_LETTERS, _VALUE_LETTERS, _WARNING_LETTERS = 16, 40, 90
"""Letters of labels and values in the summary, and of the warning below, that have room in full size."""

NOT_A_CHART: Final = (
    "Not a navigation chart. A planning aid: check every leg on official charts before sailing."
)
_COAST: Final = "Coast: (c) OpenStreetMap contributors, ODbL; beyond the Baltic to 2 km. Polar: {yacht}."
_SIGNS: Final = (
    "Shaded: sun more than 6° below the horizon. Hatched: beyond the end of the forecast. "
    "Dotted: angle of the true wind."
)


def pdf(passage: Passage, *, wind: Wind | None = None, words: Words = ENGLISH) -> bytes:
    """Make the PDF.

    The same passage gives the same bytes: no time of writing is in it.

    Parameters
    ----------
    wind
        Source of the chart's barbs, and of gusts and waves; without it there are none.
    words
        The language of the sheet.
    """
    import matplotlib as mpl
    from matplotlib.backends.backend_pdf import PdfPages

    file = io.BytesIO()
    about = {
        "Title": title(passage),
        "Subject": words.say(NOT_A_CHART),
        "Creator": "SeaCruise",
        "CreationDate": None,
    }
    # TrueType, so that letters beyond Latin-1 stay text that can be searched.
    with mpl.rc_context({"pdf.fonttype": 42}), PdfPages(file, metadata=about) as book:
        for page in pages(passage, wind=wind, words=words):
            book.savefig(page)
    return file.getvalue()


def write_pdf(passage: Passage, path: Path, *, wind: Wind | None = None, words: Words = ENGLISH) -> None:
    """Write `pdf` to a file.

    Raises
    ------
    InputError
        The file cannot be written.
    """
    write_atomically(path, pdf(passage, wind=wind, words=words), what="PDF file")


def pages(passage: Passage, *, wind: Wind | None = None, words: Words = ENGLISH) -> list[Figure]:
    """Draw the pages, A4 upright; two of them unless legs or notices need more."""
    first, second = new_page(), new_page()
    y = _write_head(first, passage, words)
    notices = _notice_lines(passage, words)
    low = _write_notices(first, notices[:_NOTICE_LINES])
    _draw_chart(first, passage, wind, words, top_in=y - 0.15, bottom_in=low + 0.45)
    layout = choose_layout(passage, tell(passage, wind=wind), words, above_in=_CAPTION + _BELOW_WEATHER)
    y = _draw_weather(second, passage, wind, words, height_in=layout.style.weather_in)
    sheets = [first, second, *write_legs_and_log(second, y, passage, layout, words)]
    sheets += _more_notices(notices[_NOTICE_LINES:], words)
    for number, sheet in enumerate(sheets, 1):
        of_all = words.fill("Page {number} of {count}", number=number, count=len(sheets))
        _write_foot(sheet, passage, of_all, words)
    return sheets


def _write_head(page: Figure, passage: Passage, words: Words) -> float:
    """Write title and summary; returns how low they reach [inches from the bottom]."""
    ends = [shorten(place.name, _LONG_NAME, placeholder=" ...") for place in (passage.start, passage.end)]
    head = f"{' – '.join(ends)}: {format_duration(passage.duration_h)}"
    days, hours = divmod(round(passage.duration_h), 24)
    if days >= _DAYS_TOLD:
        head += f" ({days} d {hours} h)"
    y = HEIGHT_IN - 0.85
    write_line(page, y, head, size=min(17.0, 17.0 * 50 / len(head)))
    y -= 0.34
    rows = _summary(passage, words)
    half = (len(rows) + 1) // 2
    for k, (label, text) in enumerate(rows):
        x = LEFT if k < half else WIDTH_IN / 2 + 0.1
        at = y - (k % half) * 0.19
        told = words.say(label)
        # other languages have longer words
        write(page, x, at, told, size=min(8.0, 8.0 * _LABEL_LETTERS / len(told)), color=FAINT)
        value = shorten(text, 52, placeholder=" ...")
        warns = label in _HELD and passage.beyond_forecast_h > _HELD_SHARE * passage.duration_h
        size, color = min(8.0, 8.0 * _VALUE_LETTERS / len(value)), MAGENTA if warns else INK
        write(page, x + 1.06, at, value, size=size, color=color, bold=warns)
    return y - (half - 1) * 0.19


def _summary(passage: Passage, words: Words) -> list[tuple[str, str]]:
    track = passage.track
    rows = [
        ("Yacht", passage.yacht),
        ("From", _place(passage.start, words)),
        ("To", _place(passage.end, words)),
        ("Departure", f"{words.day_time(passage.departure)} UTC"),
        ("Arrival", f"{words.day_time(passage.arrival)} UTC"),
        (
            "Distance",
            words.fill(
                "{sailed:.1f} nm, {direct:.1f} nm direct",
                sailed=passage.distance_nm,
                direct=passage.direct_distance_nm,
            ),
        ),
        ("Mean speed", words.fill("{speed:.1f} kn", speed=passage.mean_speed_kn)),
        ("Strongest wind", words.fill("{speed:.0f} kn", speed=passage.max_tws_kn)),
        (
            "Manoeuvres",
            words.fill(
                "tacks {tacks}, gybes {gybes}, course changes {changes}",
                tacks=passage.tacks,
                gybes=passage.gybes,
                changes=passage.course_changes,
            ),
        ),
        ("At night", f"{night_hours(track.time, track.lat, track.lon):.0f} h"),
        ("Lower bound", format_duration(passage.lower_bound_h)),
        ("Sailed again", _checked(passage, words)),
    ]
    if passage.motor_h > 0:
        told = words.fill(
            "{hours}, {litres:.0f} l of fuel", hours=format_duration(passage.motor_h), litres=passage.fuel_l
        )
        rows.append(("Engine", told))
    if passage.manoeuvre_h > 0:
        told = words.fill("{hours} for manoeuvres", hours=format_duration(passage.manoeuvre_h))
        rows.append(("Turning", told))
    if passage.beyond_forecast_h > 0:
        name = _HELD[passage.beyond == "fade"]
        told = words.fill("{hours} beyond the forecast", hours=format_duration(passage.beyond_forecast_h))
        rows.append((name, told))
    return rows


def _place(place: Place, words: Words) -> str:
    snapped = ""
    if place.snapped_nm >= 0.05:
        snapped = words.fill(", {distance:.1f} nm from the harbour", distance=place.snapped_nm)
    return f"{shorten(place.name, 40 - len(snapped), placeholder=' ...')}{snapped}"


def _checked(passage: Passage, words: Words) -> str:
    """Say what the passage was held against; what failed is told in capitals."""
    checks = passage.checks
    answers = (
        (checks.land_free, "clear of land", "CROSSES LAND"),
        (checks.zones_free, "", "CROSSES A ZONE"),
        (checks.within_limits, "within limits", "BEYOND A LIMIT"),
    )
    return ", ".join(words.say(text) for fine, good, bad in answers if (text := good if fine else bad))


def _notice_lines(passage: Passage, words: Words) -> list[str]:
    said = [words.sentence(notice) for notice in passage.notices if notice]
    return [line for notice in (_age(passage, words), *said) for line in wrap(f"! {notice}", 118)]


def _age(passage: Passage, words: Words) -> str:
    """Say how old the wind is when she leaves; a paper knows nothing of the day on which it is read."""
    issued = passage.forecast.issued
    if issued is None:
        return words.say("When this wind was issued is not known.")
    hours = (passage.departure - issued).total_seconds() / 3600.0
    when = words.day_time(issued)
    if hours < 0.0:
        return words.fill("The wind is of {when} UTC.", when=when)
    return words.fill("The wind is of {when} UTC, {hours:.0f} h before departure.", when=when, hours=hours)


def _write_notices(page: Figure, lines: Sequence[str]) -> float:
    """Write notices above the foot of the page; returns how high they reach [inches from the bottom]."""
    y = FOOT + 0.12
    for line in reversed(lines):
        write_line(page, y, line, size=7.5)
        y += _NOTICE_LINE
    return y


def _more_notices(lines: Sequence[str], words: Words) -> list[Figure]:
    """Pages for the notices that page 1 has no room for."""
    most = int((HEIGHT_IN - 1.3 - FOOT) / _NOTICE_LINE)
    sheets = []
    for begin in range(0, len(lines), most):
        sheets.append(new_page())
        write_line(sheets[-1], TOP, words.say("Notices (continued)"), size=12)
        for k, line in enumerate(lines[begin : begin + most]):
            write_line(sheets[-1], HEIGHT_IN - 1.05 - k * _NOTICE_LINE, line, size=7.5)
    return sheets


def _write_foot(page: Figure, passage: Passage, number: str, words: Words) -> None:
    forecast = passage.forecast
    source = words.fill("Wind: {source}", source=words.sentence(forecast.source))
    if forecast.issued:
        source += words.fill(", issued {when} UTC", when=words.day_time(forecast.issued))
    span = _span(words, forecast.valid_from, forecast.valid_to)
    coast = words.fill(_COAST, yacht=shorten(passage.yacht, 60))
    write(page, LEFT, 0.58, f"{shorten(source, 78, placeholder=' ...')}; {span}.", size=6.5, color=FAINT)
    write(page, LEFT, 0.46, coast, size=6.5, color=FAINT)
    warning = words.say(NOT_A_CHART)
    write(
        page,
        LEFT,
        0.28,
        warning,
        size=min(8.0, 8.0 * _WARNING_LETTERS / len(warning)),
        color=MAGENTA,
        bold=True,
    )
    write(page, RIGHT, 0.28, number, size=8, color=FAINT, align="right")


def _span(words: Words, begin: datetime, end: datetime) -> str:
    return words.fill("{begin} to {end} UTC", begin=words.day_time(begin), end=words.day_time(end))


def _draw_weather(
    page: Figure, passage: Passage, wind: Wind | None, words: Words, *, height_in: float
) -> float:
    """Draw the weather along the way; returns where the legs begin [inches from the bottom]."""
    write_line(page, TOP, words.say("Weather along the passage"), size=12)
    write_line(page, TOP - 0.18, words.say(_SIGNS), size=7, color=FAINT)
    top = TOP - _CAPTION
    box = (
        (LEFT + 0.25) / WIDTH_IN,
        (top - height_in) / HEIGHT_IN,
        (RIGHT - LEFT - 0.65) / WIDTH_IN,
        height_in / HEIGHT_IN,
    )
    draw_meteogram(page, box, passage, wind=wind, words=words)
    return top - height_in - _BELOW_WEATHER


def _draw_chart(
    page: Figure, passage: Passage, wind: Wind | None, words: Words, *, top_in: float, bottom_in: float
) -> None:
    """Draw the chart across the page, between two heights."""
    left, right = LEFT + 0.25, RIGHT
    frame = _frame(passage, right - left, top_in - bottom_in)
    axes = page.add_axes(
        (
            left / WIDTH_IN,
            bottom_in / HEIGHT_IN,
            (right - left) / WIDTH_IN,
            (top_in - bottom_in) / HEIGHT_IN,
        )
    )
    axes.set_facecolor(WATER)
    axes.set_xlim(frame.west, frame.east)
    axes.set_ylim(frame.low, frame.high)
    axes.set_aspect("equal")
    axes.tick_params(labelsize=7, colors=INK, length=3)
    land = draw_land(axes, frame)
    draw_graticule(axes, frame)
    if wind is not None:
        middle = passage.departure + (passage.arrival - passage.departure) / 2
        draw_barbs(axes, frame, wind, middle, land)
        told = words.fill("Barbs: {when} UTC", when=words.day_time(middle))
        write(page, right, bottom_in - 0.32, told, size=7, color=FAINT, align="right")
    line = draw_passage(axes, passage, under_engine=words.say("under engine"))
    length = draw_scale_bar(axes, frame, unit=words.say("nm"))
    inset = axes.inset_axes((0.955, 0.05, 0.018, 0.22), zorder=12)
    bar = page.colorbar(line, cax=inset)
    inset.yaxis.set_ticks_position("left")
    inset.yaxis.set_label_position("left")
    bar.set_label(words.say("True wind [kn]"), fontsize=7, color=INK)
    inset.tick_params(labelsize=7, colors=INK)
    colours = inset.get_tightbbox()
    taken = draw_waypoints(axes, passage, [length] if colours is None else [length, colours], words)
    draw_ports(axes, frame, passage, load_ports(), taken)


def _frame(passage: Passage, width_in: float, height_in: float) -> Frame:
    """Fit the chart round the passage, with room for labels, in the shape of its place on the page."""
    x, y = passage.track.lon, mercator(passage.track.lat)
    west, east, low, high = float(x.min()), float(x.max()), float(y.min()), float(y.max())
    least = 0.15
    wide = max(east - west, least) / (1.0 - 2 * _LABEL_IN / width_in)
    tall = max(high - low, least) / max(0.2, 1.0 - 2 * _LABEL_ROOM_IN / height_in)
    shape = width_in / height_in
    middle = (west + east) / 2, (low + high) / 2
    return framed(middle, max(wide, tall * shape), max(tall, wide / shape), (width_in, height_in))
