"""``seacruise replan``: under way, a newer forecast, the passage from here and what it changes."""

from __future__ import annotations

import argparse
from datetime import UTC, datetime

from seacruise.commands import request as ask
from seacruise.commands.common import add_format, cancellable_job, parse_path, parse_time, say


def add_parser(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the sub-command."""
    parser = commands.add_parser(
        "replan",
        help="under way: the passage from here with a newer forecast",
        description="Plan from where the yacht is to the end of a saved passage, and say what changes.",
    )
    parser.add_argument(
        "saved",
        type=parse_path,
        metavar="PASSAGE.json",
        help="what 'seacruise plan --format json' printed",
    )
    parser.add_argument(
        "--at",
        metavar="LAT,LON",
        help="where she is (default: where the plan has her at --time)",
    )
    parser.add_argument(
        "--time",
        type=parse_time,
        metavar="TIME",
        help="when she is there, ISO, UTC unless it has an offset (default: now)",
    )
    parser.add_argument(
        "--forecast",
        action="append",
        metavar="SOURCE",
        help=f"{', '.join(ask.SERVICES)}, a GRIB or NetCDF file; repeat to average several (default: auto)",
    )
    parser.add_argument(
        "--weights",
        type=ask.parse_weights,
        metavar="W,W",
        help="weights of several forecasts in their mean, in the order of --forecast (default: equal)",
    )
    parser.add_argument(
        "--current", type=parse_path, metavar="FILE", help="GRIB or NetCDF file with the current"
    )
    parser.add_argument(
        "--yacht",
        metavar="NAME",
        help="a name from polars/, or the path of a polar file (default: the yacht of the passage)",
    )
    ask.add_search_options(parser)
    ask.add_avoid(parser)
    add_format(parser)
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Plan anew and print; the exit code is 0 or that of the error."""
    from seacruise.along import UNDER_WAY
    from seacruise.between import fetch_wind_between
    from seacruise.errors import InputError
    from seacruise.export.saved import read_saved
    from seacruise.ports import Port, parse_position
    from seacruise.settings import Settings
    from seacruise.underway import replan

    settings = Settings.from_environment()
    saved = read_saved(arguments.saved)
    time = arguments.time or datetime.now(UTC)
    planned = saved.position_at(time)
    position = parse_position(arguments.at) if arguments.at else None
    if arguments.at and position is None:
        raise InputError(f"{arguments.at!r} is no position; write it as 57.5,18.6 (--at).")
    yacht = ask.find_yacht_named(arguments.yacht or saved.yacht, settings)
    here = Port(UNDER_WAY, "", *(position or planned))
    zones = ask.zones_from(arguments, settings)
    with cancellable_job() as job:
        wind = fetch_wind_between(
            arguments.forecast or ["auto"],
            here,
            saved.end,
            time,
            settings=settings,
            job=job,
            weights=arguments.weights,
            current=arguments.current,
        )
        answer = replan(
            saved,
            position=position,
            time=time,
            wind=wind,
            yacht=yacht,
            settings=settings,
            options=ask.options_from(arguments),
            zones=zones,
            job=job,
        )
    if arguments.format == "json":
        from seacruise.export.jsonform import dumps
        from seacruise.export.underway import replanned_to_json

        print(dumps(replanned_to_json(answer)))
        for notice in answer.passage.notices:
            say(f"Note: {notice}")
    else:
        from seacruise.export.underway import replanned_to_text

        print(replanned_to_text(answer, now=datetime.now(UTC)))
    return 0
