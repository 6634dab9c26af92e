"""What re-planning and simulations say, as JSON and as text."""

from __future__ import annotations

from datetime import datetime
from typing import Any, Final

from seacruise.along import apart_nm
from seacruise.export.jsonform import format_time, number, passage_to_json
from seacruise.export.textform import (
    NOTICE,
    format_course,
    format_day_time,
    format_duration,
    passage_to_text,
)
from seacruise.geodesy import format_position
from seacruise.ports import load_ports
from seacruise.simulation import LogEntry, Voyage
from seacruise.underway import OtherSide, Replanned

REPLAN_SCHEMA: Final = "seacruise.replan/1"
VOYAGE_SCHEMA: Final = "seacruise.voyage/1"

NAMED_WITHIN_NM: Final = 15.0
"""An island is named after a port no farther from its middle than this [nm]."""


def replanned_to_json(answer: Replanned) -> dict[str, Any]:
    """Put the answer into one object: what changed, and the new passage as `plan` prints it."""
    lat, lon = answer.position
    return {
        "schema": REPLAN_SCHEMA,
        "time": format_time(answer.time),
        "position": {"lat": number(lat, 6), "lon": number(lon, 6)},
        "planned_arrival": format_time(answer.saved.arrival),
        "planned_forecast": {
            "source": answer.saved.source,
            "issued": None if answer.saved.issued is None else format_time(answer.saved.issued),
        },
        "changes": {
            "off_plan_nm": number(answer.off_plan_nm, 3),
            "arrival_change_h": number(answer.arrival_change_h, 4),
            "kept_arrival": None if answer.kept_arrival is None else format_time(answer.kept_arrival),
            "saves_h": number(answer.saves_h, 4),
            "course_deg": number(answer.course_deg, 2),
            "course_change_deg": number(answer.course_change_deg, 2),
            "distance_change_nm": number(answer.distance_change_nm, 3),
            "max_tws_change_kn": number(answer.max_tws_change_kn, 2),
            "other_side": [
                {
                    "name": island_name(island),
                    "lat": number(island.lat, 4),
                    "lon": number(island.lon, 4),
                    "area_km2": number(island.area_km2, 1),
                    "side": island.side,
                }
                for island in answer.other_side
            ],
        },
        "passage": passage_to_json(answer.passage),
    }


def replanned_to_text(answer: Replanned, *, now: datetime) -> str:
    """Say what changed, then the new passage.

    Parameters
    ----------
    now
        Timezone-aware; the age of the forecast is counted to it.
    """
    rows = [
        ("Time", f"{format_day_time(answer.time)} UTC"),
        ("Position", f"{format_position(*answer.position)}, {answer.off_plan_nm:.1f} nm from the plan"),
        ("Arrival", f"{_change_h(answer.arrival_change_h)} than planned, {_arrivals(answer)}"),
        ("Old waypoints", _kept(answer)),
        ("Course now", _course(answer)),
        ("Distance", f"{answer.distance_change_nm:+.1f} nm against what was left of the plan"),
        ("Strongest wind", f"{answer.passage.max_tws_kn:.0f} kn ({answer.max_tws_change_kn:+.0f} kn)"),
    ]
    rows += [
        ("Other side", f"{island_name(island)} is left to {island.side}") for island in answer.other_side
    ]
    head = f"Re-planned under way to {answer.passage.end.name}\n\n"
    return (
        head
        + "\n".join(f"  {label:<16} {text}" for label, text in rows)
        + "\n\n"
        + passage_to_text(answer.passage, now=now)
    )


def _change_h(hours: float) -> str:
    if abs(hours) < 1 / 60:
        return "no earlier or later"
    return f"{format_duration(abs(hours))} {'later' if hours > 0 else 'earlier'}"


def _arrivals(answer: Replanned) -> str:
    then, now = answer.saved.arrival, answer.passage.arrival
    return f"{format_day_time(now)} instead of {format_day_time(then)} UTC"


def _kept(answer: Replanned) -> str:
    if answer.kept_arrival is None:
        return "lead nowhere in this wind"
    saves = answer.saves_h or 0.0
    what = "as fast as the new passage" if abs(saves) < 1 / 60 else f"{_change_h(saves)} than the new passage"
    return f"kept, {format_day_time(answer.kept_arrival)} UTC: {what}"


def _course(answer: Replanned) -> str:
    turn = answer.course_change_deg
    if abs(turn) < 1.0:
        return f"{format_course(answer.course_deg)}, as planned"
    side = "starboard" if turn > 0 else "port"
    return f"{format_course(answer.course_deg)}, {abs(turn):.0f}° to {side} of the plan's"


def island_name(island: OtherSide) -> str:
    """Name an island after the nearest port of the list, or by its position."""
    here = island.lat, island.lon
    nearest = min(load_ports(), key=lambda port: apart_nm(here, (port.lat, port.lon)))
    if apart_nm(here, (nearest.lat, nearest.lon)) <= NAMED_WITHIN_NM + island.area_km2**0.5 / 1.852:
        return f"the island near {nearest.name}"
    return f"the island at {format_position(*here)}"


# ---------------------------------------------------------------------------------------- simulations


def voyage_to_json(voyage: Voyage) -> dict[str, Any]:
    """Put a simulated voyage into one object."""
    return {
        "schema": VOYAGE_SCHEMA,
        "start": voyage.request.start.name,
        "end": voyage.request.end.name,
        "yacht": voyage.request.yacht.name,
        "departure": format_time(voyage.departure),
        "expected_h": number(voyage.expected_h, 4),
        "sailed_h": number(voyage.sailed_h, 4),
        "kept_h": number(voyage.kept_h, 4),
        "gained_h": number(voyage.gained_h, 4),
        "hindsight_h": number(voyage.hindsight_h, 4),
        "max_tws_kn": number(voyage.max_tws_kn, 2),
        "replanned": [_entry(entry) for entry in voyage.log],
    }


def _entry(entry: LogEntry) -> dict[str, Any]:
    def wind(pair: tuple[float, float]) -> dict[str, float | None]:
        return {"tws_kn": number(pair[0], 2), "twd_deg": number(pair[1], 1)}

    return {
        "time": format_time(entry.time),
        "lat": number(entry.position[0], 6),
        "lon": number(entry.position[1], 6),
        "forecast": wind(entry.planned),
        "met": wind(entry.met),
        "issued": None if entry.issued is None else format_time(entry.issued),
        "expected_arrival": None if entry.expected is None else format_time(entry.expected),
        "reason": entry.reason or None,
    }


def voyage_to_text(voyage: Voyage) -> str:
    """Summary of a simulated voyage and its log."""

    def hours(value: float | None) -> str:
        return "she does not arrive" if value is None else format_duration(value)

    gained = voyage.gained_h
    rows = [
        ("Yacht", voyage.request.yacht.name),
        ("Departure", f"{format_day_time(voyage.departure)} UTC"),
        ("Promised", format_duration(voyage.expected_h)),
        ("Re-planned", f"{hours(voyage.sailed_h)}, planned anew {len(voyage.log)} times"),
        ("First plan kept", hours(voyage.kept_h)),
        ("In hindsight", hours(voyage.hindsight_h)),
        ("Strongest wind", f"{voyage.max_tws_kn:.0f} kn"),
    ]
    if gained is not None:
        word = "saves" if gained >= 0 else "costs"
        rows.insert(5, ("Re-planning", f"{word} {format_duration(abs(gained))}"))
    lines = [f"{voyage.request.start.name} - {voyage.request.end.name}, simulated", ""]
    lines += [f"  {label:<16} {text}" for label, text in rows]
    if voyage.log:
        lines += [
            "",
            _LOG_HEAD,
        ]
        lines += [_log_line(entry) for entry in voyage.log]
    return "\n".join([*lines, "", f"! {NOTICE}"])


_LOG_HEAD: Final = (
    f"{'Planned anew (UTC)':<21}  {'Position':<21}  {'Forecast':<10}  {'Met':<10}  {'Issued (UTC)':<21}  "
    "Arrival (UTC)"
)


def _log_line(entry: LogEntry) -> str:
    def wind(pair: tuple[float, float]) -> str:
        return f"{pair[0]:2.0f} kn {format_course(pair[1])}"

    issued = "" if entry.issued is None else format_day_time(entry.issued)
    arrival = f"none ({entry.reason})" if entry.expected is None else format_day_time(entry.expected)
    return (
        f"{format_day_time(entry.time):<21}  {format_position(*entry.position):<21}  "
        f"{wind(entry.planned):<10}  {wind(entry.met):<10}  {issued:<21}  {arrival}"
    )
