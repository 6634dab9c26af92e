"""The passage as a sailor reads it in a terminal."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime, timedelta
from typing import TYPE_CHECKING

from seacruise.geodesy import format_position
from seacruise.units import SECONDS_PER_HOUR

if TYPE_CHECKING:
    from seacruise.passage import Passage, Place, Waypoint
    from seacruise.tradeoff import Choice
    from seacruise.weather.wind import Forecast

NOTICE = "A planning aid, not for navigation."
"""Stands in every file that leaves the program."""

_SIDE = {"port": "port", "starboard": "stbd", "both": "both", None: ""}


def title(passage: Passage) -> str:
    """Name of the passage: ``Gdynia - Stockholm``."""
    return f"{passage.start.name} - {passage.end.name}"


def format_duration(hours: float) -> str:
    """Write a duration as sailors say it: ``41 h 49 min``."""
    minutes = round(hours * 60)
    return f"{minutes // 60} h {minutes % 60:02d} min"


def to_minute(time: datetime) -> datetime:
    """Round to the nearest full minute, UTC."""
    return (time.astimezone(UTC) + timedelta(seconds=30)).replace(second=0, microsecond=0)


def format_day_time(time: datetime) -> str:
    """Write a time with its weekday, UTC, to the minute: ``Sun 20 Nov 2016 06:00``."""
    days = ("Mon", "Tue", "Wed", "Thu", "Fri", "Sat", "Sun")
    months = ("Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec")
    utc = to_minute(time)
    return f"{days[utc.weekday()]} {utc.day:2d} {months[utc.month - 1]} {utc.year} {utc:%H:%M}"


def format_course(course_deg: float) -> str:
    """Write a course with three digits: ``045°``."""
    return f"{round(course_deg) % 360:03d}°"


def leg_sentence(waypoint: Waypoint) -> str:
    """Say the leg that begins at a waypoint in one line, for plotters and maps."""
    assert waypoint.course_deg is not None
    how = "under engine" if waypoint.motor else f"wind {_angle(waypoint)}"
    return (
        f"steer {format_course(waypoint.course_deg)} for {waypoint.leg_nm:.1f} nm, "
        f"{waypoint.boat_speed_kn:.1f} kn, {how}, TWS {waypoint.tws_kn:.0f} kn"
    )


def passage_to_text(passage: Passage, *, now: datetime) -> str:
    """Summary, notices and table of legs.

    Parameters
    ----------
    now
        Timezone-aware; the age of the forecast is counted to it.
    """
    blocks = ["\n".join(_summary(passage, now)), _legs_table(passage)]
    notices = [notice for notice in (*passage.notices, NOTICE) if notice]
    blocks.append("\n".join(f"! {notice}" for notice in dict.fromkeys(notices)))
    return "\n\n".join(blocks)


def _summary(passage: Passage, now: datetime) -> list[str]:
    bound = f"no passage takes less than {format_duration(passage.lower_bound_h)}, even over land"
    rows = [
        ("Yacht", passage.yacht),
        ("From", _place(passage.start)),
        ("To", _place(passage.end)),
        ("Departure", f"{format_day_time(passage.departure)} UTC"),
        ("Arrival", f"{format_day_time(passage.arrival)} UTC"),
        ("Duration", format_duration(passage.duration_h)),
        ("Distance", f"{passage.distance_nm:.1f} nm sailed, {passage.direct_distance_nm:.1f} nm direct"),
        ("Mean speed", f"{passage.mean_speed_kn:.1f} kn"),
        ("Strongest wind", f"{passage.max_tws_kn:.0f} kn"),
        ("Manoeuvres", manoeuvres(passage)),
        ("Forecast", format_forecast(passage.forecast, now=now)),
        ("Lower bound", bound),
        ("Checks", _checks(passage)),
    ]
    if passage.manoeuvre_h > 0:
        rows.insert(10, ("Lost in turning", format_duration(passage.manoeuvre_h)))
    if passage.motor_h > 0:
        engine = f"{format_duration(passage.motor_h)}, {passage.fuel_l:.1f} l of fuel"
        rows.insert(9, ("Engine", engine))
    if passage.beyond_forecast_h > 0:
        fading = ", fading to the usual" if passage.beyond == "fade" else ""
        held = f"{format_duration(passage.beyond_forecast_h)} sailed on the last known wind{fading}"
        rows.insert(-2, ("Beyond forecast", held))
    return [f"{title(passage)}: {format_duration(passage.duration_h)}", ""] + [
        f"  {label:<16} {text}" for label, text in rows
    ]


def _place(place: Place) -> str:
    snapped = f", {place.snapped_nm:.1f} nm from the harbour" if place.snapped_nm >= 0.05 else ""
    return f"{place.name}, {format_position(place.lat, place.lon)}{snapped}"


def manoeuvres(passage: Passage) -> str:
    """Count what the crew does: ``1 tack, 2 gybes, 6 course changes``."""

    def count(number: int, word: str) -> str:
        return f"{number} {word}{'' if number == 1 else 's'}"

    return ", ".join(
        (
            count(passage.tacks, "tack"),
            count(passage.gybes, "gybe"),
            count(passage.course_changes, "course change"),
        )
    )


def format_forecast(forecast: Forecast, *, now: datetime) -> str:
    """Say where a wind is from, what it covers and how old it is."""
    span = f"{format_day_time(forecast.valid_from)} to {format_day_time(forecast.valid_to)} UTC"
    parts = [forecast.source, span, f"every {forecast.step_h:g} h on {forecast.resolution_deg:g}°"]
    if forecast.issued is not None:
        age_h = (now - forecast.issued).total_seconds() / SECONDS_PER_HOUR
        age = f"{age_h:.0f} h old" if age_h < 72 else f"{age_h / 24:.0f} days old"
        parts.insert(1, f"issued {format_day_time(forecast.issued)} UTC, {age}")
    return "; ".join(parts)


def _checks(passage: Passage) -> str:
    checks = passage.checks
    answers = (
        (checks.land_free, "clear of land", "CROSSES LAND"),
        # Said only when it is not so: without zones it would promise what nobody looked at.
        (checks.zones_free, "", "CROSSES A ZONE"),
        (checks.within_limits, "within limits", "BEYOND A LIMIT"),
    )
    said = ", ".join(text for fine, good, bad in answers if (text := good if fine else bad))
    return f"sailed again in {format_duration(checks.resailed_h)}; {said}"


def _angle(waypoint: Waypoint) -> str:
    assert waypoint.twa_deg is not None
    return f"{waypoint.twa_deg:.0f}° {_SIDE[waypoint.tack]}".rstrip()


def _in_current(waypoint: Waypoint) -> str:
    """Say what the current does to a leg: ``  steer 012°, 6.4 kn over ground, current 0.5 kn to 085°``."""
    if waypoint.current_kn is None or waypoint.current_to_deg is None or waypoint.steer_deg is None:
        return ""
    return (
        f"  steer {format_course(waypoint.steer_deg)}, {waypoint.sog_kn:.1f} kn over ground, "
        f"current {waypoint.current_kn:.1f} kn to {format_course(waypoint.current_to_deg)}"
    )


def _legs_table(passage: Passage) -> str:
    head = (
        f"{'':3} {'Time (UTC)':<21}  {'Position':<20}  {'Course':>6}  {'Dist':>8}  {'TWS':>5}  {'TWD':>4}  "
    )
    lines = [f"{head}{'TWA':<10}  {'Speed':>7}".rstrip()]
    for number, waypoint in enumerate(passage.waypoints):
        where = f"{format_day_time(waypoint.time)}  {format_position(waypoint.lat, waypoint.lon)}"
        line = f"{number:3d} {where}"
        if waypoint.course_deg is not None and waypoint.twd_deg is not None:
            wind = f"{waypoint.tws_kn:2.0f} kn  {format_course(waypoint.twd_deg)}  {_angle(waypoint):<10}"
            line += f"  {format_course(waypoint.course_deg):>6}  {waypoint.leg_nm:5.1f} nm  {wind}  "
            line += f"{waypoint.boat_speed_kn:4.1f} kn{'  engine' if waypoint.motor else ''}"
            line += f"  {waypoint.sail}" if waypoint.sail else ""
            line += _in_current(waypoint)
        lines.append(line.rstrip())
    return "\n".join(lines)


def trade_off_to_text(choices: Sequence[Choice]) -> str:
    """Table of the least time for each number of changes of course."""
    lines = ["Fewer changes of course", f"{'Changes':>8}  {'Duration':>11}  {'Distance':>9}  Tacks and gybes"]
    for choice in choices:
        turns = f"{choice.tacks} and {choice.gybes}"
        duration = format_duration(choice.duration_h)
        lines.append(
            f"{choice.course_changes:8d}  {duration:>11}  {choice.distance_nm:6.1f} nm  {turns}".rstrip()
        )
    return "\n".join(lines)
