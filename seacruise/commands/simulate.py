"""``seacruise simulate``: a passage sailed through forecasts that do not come true."""

from __future__ import annotations

import argparse
from dataclasses import replace
from datetime import datetime
from typing import TYPE_CHECKING

from seacruise.commands import request as ask
from seacruise.commands.common import add_format, cancellable_job, number_between, parse_path, parse_time, say

if TYPE_CHECKING:
    from seacruise.weather.wind import Wind


def add_parser(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the sub-command."""
    parser = commands.add_parser(
        "simulate",
        help="sail a passage through forecasts and another, true wind, re-planning under way",
        description="Sail a passage in a true wind while planning with forecasts, each from its issue on; "
        "say what re-planning under way saves.",
    )
    voyage = parser.add_argument_group("the passage")
    for flag, dest, text in (
        ("--from", "start", "a name from ports.csv, or LAT,LON"),
        ("--to", "end", "the same"),
    ):
        voyage.add_argument(flag, dest=dest, required=True, metavar="PORT", help=text)
    voyage.add_argument("--depart", type=parse_time, required=True, metavar="TIME", help="ISO time, UTC")
    winds = parser.add_argument_group("the wind")
    winds.add_argument(
        "--forecast",
        action="append",
        required=True,
        metavar="FILE",
        help="a forecast that is known from its issue on; repeat for newer ones",
    )
    winds.add_argument(
        "--issued",
        type=parse_time,
        action="append",
        default=[],
        metavar="TIME",
        help="when it was issued; one for each --forecast, where the files do not tell",
    )
    winds.add_argument("--truth", required=True, metavar="FILE", help="the wind that blows")
    winds.add_argument(
        "--current",
        type=parse_path,
        metavar="FILE",
        help="GRIB or NetCDF file with the current, forecast and met alike",
    )
    winds.add_argument(
        "--more-than",
        dest="tws_kn",
        type=number_between(0, 60, "kn"),
        default=4.0,
        metavar="KN",
        help="plan anew where the wind speed differs by more (default: 4)",
    )
    winds.add_argument(
        "--turned-by",
        dest="twd_deg",
        type=number_between(0, 180, "degrees"),
        default=20.0,
        metavar="DEGREES",
        help="plan anew where its direction differs by more (default: 20)",
    )
    ask.add_yacht(parser, required=True)
    ask.add_search_options(parser)
    ask.add_avoid(parser)
    add_format(parser)
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Simulate and print; the exit code is 0 when she arrives, else 3."""
    from seacruise.between import fetch_wind_between
    from seacruise.passage import PassageRequest
    from seacruise.settings import Settings
    from seacruise.simulation import Tolerance, simulate

    settings = Settings.from_environment()
    start, end = ask.find_ends(arguments)
    yacht = ask.find_yacht_named(arguments.yacht, settings)
    options, zones = ask.options_from(arguments), ask.zones_from(arguments, settings)
    with cancellable_job() as job:
        winds = [
            fetch_wind_between(
                [name],
                start,
                end,
                arguments.depart,
                settings=settings,
                job=job,
                current=arguments.current,
            )
            for name in (*arguments.forecast, arguments.truth)
        ]
        forecasts = _issued(winds[:-1], arguments.issued)
        asked = PassageRequest(start, end, yacht, winds[-1], arguments.depart, options, zones)
        voyage = simulate(
            asked,
            forecasts,
            winds[-1],
            settings=settings,
            tolerance=Tolerance(arguments.tws_kn, arguments.twd_deg),
            job=job,
        )
    if arguments.format == "json":
        from seacruise.export.jsonform import dumps
        from seacruise.export.underway import voyage_to_json

        print(dumps(voyage_to_json(voyage)))
    else:
        from seacruise.export.underway import voyage_to_text

        print(voyage_to_text(voyage))
    if voyage.sailed_h is None:
        say("seacruise: She does not arrive in the true wind: she is becalmed under way.")
        return 3
    return 0


def _issued(winds: list[Wind], times: list[datetime]) -> list[Wind]:
    """Put the times of issue that were given to the forecasts, in their order."""
    from seacruise.errors import InputError

    if not times:
        return winds
    if len(times) != len(winds):
        raise InputError(
            f"There are {len(winds)} forecasts and {len(times)} times of issue; give one --issued for each "
            "--forecast, or none."
        )
    return [
        replace(wind, forecast=replace(wind.forecast, issued=time))
        for wind, time in zip(winds, times, strict=True)
    ]
