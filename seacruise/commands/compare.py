"""``seacruise compare``: the same passage for several departures and yachts, side by side."""

from __future__ import annotations

import argparse
import re
from datetime import UTC, datetime, timedelta

from seacruise.commands import request as ask
from seacruise.commands.common import add_format, cancellable_job, say
from seacruise.text import parse_number

DEPARTURES = 8
EVERY = timedelta(hours=6)

_UNITS = {"": 3600.0, "h": 3600.0, "min": 60.0, "m": 60.0, "d": 86_400.0}


def add_parser(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the sub-command."""
    parser = commands.add_parser(
        "compare",
        help="the same passage for several departures and yachts",
        description="Plan the same passage for several departures and yachts, and say which one is best.",
    )
    ask.add_voyage(parser, required=True)
    parser.add_argument(
        "--departures",
        type=_count,
        metavar="N",
        help=f"how many departures, from --depart on (default: {DEPARTURES}, with several yachts 1)",
    )
    parser.add_argument(
        "--every",
        type=parse_interval,
        default=EVERY,
        metavar="6h",
        help="time between them: 6h, 90min or 1d (default: 6h)",
    )
    parser.add_argument(
        "--yacht",
        dest="yachts",
        action="append",
        required=True,
        metavar="NAME",
        help="a name from polars/, or the path of a polar file; repeat to compare yachts",
    )
    parser.add_argument(
        "--no-members",
        dest="members",
        action="store_false",
        help="of an ensemble forecast use the mean alone",
    )
    ask.add_search_options(parser)
    ask.add_avoid(parser)
    add_format(parser)
    parser.set_defaults(run=run)


def _count(text: str) -> int:
    from seacruise.study import MOST_RUNS

    value = parse_number(text)
    if value is None or value != int(value) or not 1 <= value <= MOST_RUNS:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from 1 to {MOST_RUNS}")
    return int(value)


def parse_interval(text: str) -> timedelta:
    """Read ``6h``, ``90min``, ``1d`` or a bare number of hours.

    Raises
    ------
    argparse.ArgumentTypeError
        It is none, or not between a minute and 30 days.
    """
    parts = re.fullmatch(r"\s*([\d.,]+)\s*(h|min|m|d)?\s*", text)
    value = parse_number(parts[1]) if parts else None
    if parts is None or value is None or not 60.0 <= value * _UNITS[parts[2] or ""] <= 30 * 86_400.0:
        raise argparse.ArgumentTypeError(f"{text!r} is not a time such as 6h, 90min or 1d")
    return timedelta(seconds=value * _UNITS[parts[2] or ""])


def run(arguments: argparse.Namespace) -> int:
    """Plan all, print; the exit code is 0 when at least one passage was found, else 3."""
    from seacruise.passage import PassageRequest
    from seacruise.settings import Settings
    from seacruise.study import compare, departures_from, variants

    settings = Settings.from_environment()
    start, end = ask.find_ends(arguments)
    named = [ask.find_yacht_named(name, settings) for name in dict.fromkeys(arguments.yachts)]
    count = arguments.departures or (1 if len(named) > 1 else DEPARTURES)
    options = ask.options_from(arguments)
    zones = ask.zones_from(arguments, settings)
    with cancellable_job() as job:
        wind = ask.fetch(arguments, start, end, settings=settings, job=job)
        asked = PassageRequest(start, end, named[0], wind, arguments.depart, options, zones)
        departures = departures_from(asked, count=count, every=arguments.every)
        requests = variants(asked, departures=departures, yachts=named)
        study = compare(requests, settings=settings, job=job, members=arguments.members)
    if arguments.format == "json":
        from seacruise.export.jsonform import dumps
        from seacruise.export.study import study_to_json

        print(dumps(study_to_json(study)))
    else:
        from seacruise.export.study import study_to_text

        print(study_to_text(study, now=datetime.now(UTC)))
    if study.best() is None:
        say(f"seacruise: None of the {len(study.runs)} passages exists: {study.runs[0].message}")
        return 3
    return 0
