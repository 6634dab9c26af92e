"""Many passages side by side, as JSON (schema ``seacruise.study/1``) and as a table."""

from __future__ import annotations

from datetime import datetime
from typing import Any, Final

from seacruise.export.jsonform import forecast_to_json, format_time, number
from seacruise.export.textform import NOTICE, format_day_time, format_duration, format_forecast
from seacruise.study import Band, Run, Spread, Study

SCHEMA: Final = "seacruise.study/1"

_NONE: Final = "-"


def study_to_json(study: Study) -> dict[str, Any]:
    """Put the answer into the object of the command line's contract; ``best`` is an index into ``runs``."""
    best = study.best()
    return {
        "schema": SCHEMA,
        "start": study.start,
        "end": study.end,
        "forecast": forecast_to_json(study.forecast),
        "runs": [_run(run) for run in study.runs],
        "best": None if best is None else study.runs.index(best),
        "best_of_yacht": {
            yacht: None if (one := study.best(yacht)) is None else study.runs.index(one)
            for yacht in study.yachts
        },
    }


def _run(run: Run) -> dict[str, Any]:
    return {**_figures(run), "ensemble": None if run.band is None else _band(run, run.band)}


def _figures(run: Run) -> dict[str, Any]:
    return {
        "departure": format_time(run.departure),
        "yacht": run.yacht,
        "member": run.member,
        "duration_h": number(run.duration_h, 4),
        "arrival": None if run.arrival is None else format_time(run.arrival),
        "distance_nm": number(run.distance_nm, 3),
        "max_tws_kn": number(run.max_tws_kn, 2),
        "upwind_share": number(run.upwind_share, 4),
        "night_h": number(run.night_h, 4),
        "motor_h": number(run.motor_h, 4),
        "beyond_forecast_h": number(run.beyond_forecast_h, 4),
        "reason": run.reason or None,
        "message": run.message or None,
    }


def _band(run: Run, band: Band) -> dict[str, Any]:
    return {
        "members": len(band.members),
        "found": band.found,
        "duration_h": _spread(band.duration_h),
        "arrival": dict(
            zip(
                ("p10", "p50", "p90"),
                (None if time is None else format_time(time) for time in run.arrivals),
                strict=True,
            )
        ),
        "followed_h": _spread(band.followed_h),
        "runs": [{**_figures(one), "followed_h": number(one.followed_h, 4)} for one in band.members],
    }


def _spread(spread: Spread) -> dict[str, float | None]:
    return {
        "p10": number(spread.low, 4),
        "p50": number(spread.middle, 4),
        "p90": number(spread.high, 4),
    }


def study_to_text(study: Study, *, now: datetime) -> str:
    """Summary, a table a yacht, the best departure in words, and notices.

    Parameters
    ----------
    now
        Timezone-aware; the age of the forecast is counted to it.
    """
    found = sum(run.found for run in study.runs)
    blocks = [
        f"{study.start} - {study.end}: {found} of {len(study.runs)} passages found",
        f"  Forecast         {format_forecast(study.forecast, now=now)}",
    ]
    for yacht in study.yachts:
        runs = study.of_yacht(yacht)
        best = study.best(yacht)
        blocks.append(f"{yacht}\n{_table(runs, best)}")
    blocks.append("\n".join(best_sentences(study)))
    notices = [f"! {notice}" for notice in (study.forecast.notice, NOTICE) if notice]
    if late := [run for run in study.runs if run.beyond_forecast_h]:
        fading = any(run.passage is not None and run.passage.beyond == "fade" for run in late)
        how = "which fades to the usual there" if fading else "held as it was"
        notices.insert(-1, f"! Late: hours sailed after the end of the forecast, in its last wind, {how}.")
    if any(run.band for run in study.runs):
        notices.insert(
            -1,
            "! 10 - 50 - 90 %: durations of the members' own fastest passages; kept: of this passage sailed "
            "in their wind.",
        )
    blocks.append("\n".join(notices))
    return "\n\n".join(blocks)


def _table(runs: tuple[Run, ...], best: Run | None) -> str:
    bands = any(run.band for run in runs)
    head = (
        f"  {'Departure (UTC)':<21}  {'Duration':>11}  {'Arrival (UTC)':<21}  {'Dist':>8}  {'Wind':>5}  "
        f"{'Upwind':>6}  {'Night':>5}  {'Engine':>6}  {'Late':>5}"
    )
    lines = [head + (f"  {'10 - 50 - 90 % [h]':<22}  {'kept [h]':<22}" if bands else "")]
    for run in runs:
        mark = "*" if run is best else " "
        line = f"{mark} {format_day_time(run.departure):<21}  {_cells(run)}"
        if run.band:
            line += f"  {_three(run.band.duration_h):<22}  {_three(run.band.followed_h):<22}"
        lines.append(line.rstrip())
    return "\n".join(line.rstrip() for line in lines)


def _cells(run: Run) -> str:
    if run.duration_h is None or run.arrival is None:
        return f"{_NONE:>11}  {run.reason}: {run.message}"
    engine = f"{run.motor_h:.1f} h" if run.motor_h else _NONE
    late = f"{run.beyond_forecast_h:.0f} h" if run.beyond_forecast_h else _NONE
    return (
        f"{format_duration(run.duration_h):>11}  {format_day_time(run.arrival):<21}  "
        f"{run.distance_nm:5.1f} nm  {run.max_tws_kn:2.0f} kn  {run.upwind_share:6.0%}  "
        f"{run.night_h:3.0f} h  {engine:>6}  {late:>5}"
    )


def _three(spread: Spread) -> str:
    return " - ".join(
        _NONE if value is None else f"{value:.1f}" for value in (spread.low, spread.middle, spread.high)
    )


def best_sentences(study: Study) -> list[str]:
    """Name the best departure of each yacht, what it saves, and the fastest of several yachts."""
    said = [_best_of(study, yacht) for yacht in study.yachts]
    best = study.best()
    if len(said) > 1 and best is not None:
        assert best.duration_h is not None
        said.append(
            f"Fastest of all: {best.yacht}, leaving {format_day_time(best.departure)} UTC, in "
            f"{format_duration(best.duration_h)}."
        )
    return said


def _best_of(study: Study, yacht: str) -> str:
    runs = study.of_yacht(yacht)
    best = study.best(yacht)
    name = f"{yacht}: " if len(study.yachts) > 1 else ""
    if best is None or best.duration_h is None:
        return f"{name}None of these departures leads to a passage; the reasons stand beside them."
    leaving = f"{name}Best: leaving {format_day_time(best.departure)} UTC, {format_duration(best.duration_h)}"
    others = [run for run in runs if run.found and run is not best]
    if not others:
        return f"{leaving}."
    if not best.is_forecast:
        return (
            f"{leaving}, but more than a tenth of every passage is beyond the forecast: nothing can be said "
            "yet about when to leave."
        )
    first, slowest = others[0], max(others, key=lambda run: run.duration_h or 0.0)
    against = first if first.departure < best.departure else slowest
    assert against.duration_h is not None
    saved_h = against.duration_h - best.duration_h
    if saved_h < 0.0:
        # Only passages too much of which nobody forecast are shorter than the best one.
        other = format_day_time(against.departure)
        return f"{leaving}; leaving {other} would be shorter, but too much of it is after the forecast."
    return (
        f"{leaving}; saves {format_duration(saved_h)} against leaving {format_day_time(against.departure)}."
    )
