"""``seacruise plan``: one passage, computed, printed and exported."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

from seacruise.commands import request as ask
from seacruise.commands.common import add_format, cancellable_job, parse_path, parse_time, say

if TYPE_CHECKING:
    from seacruise.passage import Passage
    from seacruise.tradeoff import Choice
    from seacruise.weather.wind import Wind

EXPORTS = {
    "gpx": ("F.gpx", "GPX 1.1 route and track, for plotters and OpenCPN"),
    "kml": ("F.kml", "KML, for Google Earth"),
    "geojson": ("F.geojson", "GeoJSON, for map programs"),
    "csv": ("F.csv", "the legs as a table"),
    "chart": ("F.png", "the passage on a chart"),
    "pdf": ("F.pdf", "the passage plan to print: chart, weather along the way, legs"),
}


def add_parser(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the sub-command."""
    parser = commands.add_parser(
        "plan",
        help="find the fastest passage between two ports",
        description="Find the fastest passage under sail between two ports and say how long it takes.",
    )
    ask.add_voyage(parser, required=True)
    parser.add_argument(
        "--arrive-by",
        type=parse_time,
        metavar="TIME",
        help="leave as late as possible and still arrive by then, instead of --depart",
    )
    ask.add_yacht(parser, required=True)
    ask.add_search_options(parser)
    ask.add_avoid(parser)
    parser.add_argument(
        "--trade-off",
        action="store_true",
        help="also tell the least time for each smaller number of course changes",
    )
    files = parser.add_argument_group("files to write (an existing file of that name is replaced)")
    for name, (metavar, text) in EXPORTS.items():
        files.add_argument(f"--{name}", type=parse_path, metavar=metavar, help=text)
    add_format(parser)
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Plan, print, export; the exit code is 0 or that of the error."""
    from seacruise.atomic import check_target
    from seacruise.errors import InputError
    from seacruise.passage import PassageRequest, plan
    from seacruise.settings import Settings

    if arguments.arrive_by and arguments.depart:
        raise InputError("Give either --depart or --arrive-by, not both: one follows from the other.")
    targets: dict[str, Path] = {name: path for name in EXPORTS if (path := getattr(arguments, name))}
    for name, path in targets.items():
        check_target(path, f"{name} file")
    settings = Settings.from_environment()
    start, end = ask.find_ends(arguments)
    yacht = ask.find_yacht_named(arguments.yacht, settings)
    options = ask.options_from(arguments)
    zones = ask.zones_from(arguments, settings)
    with cancellable_job() as job:
        wind = ask.fetch(arguments, start, end, settings=settings, job=job)
        asked = PassageRequest(start, end, yacht, wind, arguments.depart, options, zones)
        if arguments.arrive_by:
            from seacruise.arrival import plan_arrival

            passage = plan_arrival(asked, arguments.arrive_by, settings=settings, job=job)
        else:
            passage = plan(asked, settings=settings, job=job)
        choices: tuple[Choice, ...] | None = None
        if arguments.trade_off:
            from seacruise.tradeoff import trade_off

            choices = trade_off(asked, passage, settings=settings, job=job)
    # The answer first: a full disk must not cost the sailor what was found. Nor must a reader of it who
    # leaves early (| head) cost the files.
    try:
        show(passage, as_json=arguments.format == "json", choices=choices)
    finally:
        for name, path in targets.items():
            export(name, passage, path, wind=wind)
            say(f"Wrote {path}")
    return 0


def show(passage: Passage, *, as_json: bool, choices: Sequence[Choice] | None = None) -> None:
    """Print a passage on standard output; with JSON its notices go to standard error."""
    if as_json:
        from seacruise.export.jsonform import dumps, passage_to_json, trade_off_to_json

        more = {} if choices is None else {"trade_off": trade_off_to_json(choices)}
        print(dumps(passage_to_json(passage) | more))
        for notice in passage.notices:
            say(f"Note: {notice}")
    else:
        from seacruise.export.textform import passage_to_text, trade_off_to_text

        print(passage_to_text(passage, now=datetime.now(UTC)))
        if choices is not None:
            print(f"\n{trade_off_to_text(choices)}")


def export(name: str, passage: Passage, path: Path, *, wind: Wind) -> None:
    """Write one of `EXPORTS`.

    Raises
    ------
    InputError
        The file cannot be written.
    """
    from seacruise.export import chart, csvform, geojson, gpx, kml, pdf

    if name in {"chart", "pdf"}:
        draw = chart.write_chart if name == "chart" else pdf.write_pdf
        draw(passage, path, wind=wind)
        return
    write = {
        "gpx": gpx.write_gpx,
        "kml": kml.write_kml,
        "geojson": geojson.write_geojson,
        "csv": csvform.write_csv,
    }[name]
    write(passage, path)
