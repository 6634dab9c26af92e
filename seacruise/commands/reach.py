"""``seacruise reach``: every port that can be reached in a time, with the time out and the time back."""

from __future__ import annotations

import argparse
from datetime import UTC, datetime

from seacruise.commands import request as ask
from seacruise.commands.common import add_format, cancellable_job, number_between, parse_path, say

FILES = {"geojson": "GeoJSON file", "chart": "chart"}


def add_parser(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the sub-command."""
    parser = commands.add_parser(
        "reach",
        help="the ports that can be reached in a time, and back",
        description="Print every port that can be reached within some hours, with the time out and back.",
    )
    ask.add_start(parser)
    parser.add_argument(
        "--hours",
        required=True,
        type=number_between(0.5, 336, "h"),
        metavar="H",
        help="the time there is, out and back",
    )
    parser.add_argument(
        "--stay",
        type=number_between(0, 336, "h"),
        default=0.0,
        metavar="H",
        help="time in the port before sailing back (default: 0)",
    )
    parser.add_argument(
        "--check",
        action="store_true",
        help="sail every way out again, as a planned passage is; takes about as long again",
    )
    ask.add_yacht(parser, required=True)
    ask.add_sail_options(parser)
    ask.add_avoid(parser)
    files = parser.add_argument_group("files to write (an existing file of that name is replaced)")
    files.add_argument(
        "--geojson",
        type=parse_path,
        metavar="F.geojson",
        help="the water reached hour by hour, and the ports",
    )
    files.add_argument("--chart", type=parse_path, metavar="F.png", help="the same on a chart")
    add_format(parser)
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Search, print, write; the exit code is 0 or that of the error."""
    from seacruise.atomic import check_target
    from seacruise.export.reach import reach_to_json, reach_to_text, write_reach_geojson
    from seacruise.ports import find_port, load_ports
    from seacruise.reach import ReachRequest, fetch_wind_around, reach
    from seacruise.settings import Settings

    for name, what in FILES.items():
        if getattr(arguments, name):
            check_target(getattr(arguments, name), what)
    settings = Settings.from_environment()
    ports = load_ports()
    start = find_port(arguments.start, ports)
    yacht = ask.find_yacht_named(arguments.yacht, settings)
    options = ask.options_from(arguments)
    with cancellable_job() as job:
        wind = fetch_wind_around(
            start,
            yacht,
            options=options,
            hours=arguments.hours,
            ports=ports,
            names=arguments.forecast or ["auto"],
            departure=arguments.depart,
            settings=settings,
            job=job,
            weights=arguments.weights,
            current=arguments.current,
        )
        asked = ReachRequest(
            start,
            yacht,
            wind,
            arguments.hours,
            arguments.depart,
            stay_h=arguments.stay,
            options=options,
            zones=ask.zones_from(arguments, settings),
            check=arguments.check,
        )
        reached = reach(asked, ports=ports, settings=settings, job=job)
    if arguments.format == "json":
        from seacruise.export.jsonform import dumps

        print(dumps(reach_to_json(reached)))
        for notice in reached.notices:
            say(f"Note: {notice}")
    else:
        print(reach_to_text(reached, now=datetime.now(UTC)))
    if arguments.geojson:
        write_reach_geojson(reached, arguments.geojson)
        say(f"Wrote {arguments.geojson}")
    if arguments.chart:
        from seacruise.export.reach_chart import write_reach_chart

        write_reach_chart(reached, arguments.chart)
        say(f"Wrote {arguments.chart}")
    return 0
