"""The options that ask for a passage, shared by ``plan`` and ``window``."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from seacruise.commands.common import number_between, parse_path, parse_time, say, whole_number_between
from seacruise.errors import InputError
from seacruise.text import parse_number

if TYPE_CHECKING:
    from seacruise.passage import Options
    from seacruise.ports import Port
    from seacruise.progress import Job
    from seacruise.sea.zones import Zones
    from seacruise.settings import Settings
    from seacruise.weather.wind import Wind
    from seacruise.yacht.polar import Polar

SERVICES = ("auto", "stormglass", "open-meteo", "open-meteo-ensemble", "metno", "practice", "sample")
DIRECTIONS = (8, 12, 16, 24, 32, 36, 60, 72, 108, 132)

_OPTION_FIELDS = (
    "preset",
    "directions",
    "spacing_nm",
    "area",
    "refine",
    "tacking",
    "percent_of_polar",
    "motor_below_kn",
    "motor_speed_kn",
    "fuel_rate_l_h",
    "max_wind_kn",
    "max_gust_kn",
    "max_wave_m",
    "shore_clearance_nm",
    "tack_penalty_min",
    "gybe_penalty_min",
    "turn_penalty",
    "board_h",
    "most_turns",
    "may_wait_h",
    "lattice",
    "safety_radius_nm",
    "safety_levels",
    "percent_at_night",
    "sea_state_percent",
    "beyond",
    "currents",
)


def add_voyage(parser: argparse.ArgumentParser, *, required: bool) -> None:
    """Add from, to, when and with which forecast."""
    ask = parser.add_argument_group("the passage")
    _add_from(ask, required=required)
    ask.add_argument(
        "--to", dest="end", required=required, metavar="PORT", help="the same for the destination"
    )
    _add_when(ask)
    if required:
        _add_mixing(ask)


def add_start(parser: argparse.ArgumentParser) -> None:
    """Add from, when and with which forecast."""
    ask = parser.add_argument_group("the start")
    _add_from(ask, required=True)
    _add_when(ask)
    _add_mixing(ask)


def _add_from(ask: argparse._ArgumentGroup, *, required: bool) -> None:
    ask.add_argument(
        "--from", dest="start", required=required, metavar="PORT", help="a name from ports.csv, or LAT,LON"
    )


def _add_when(ask: argparse._ArgumentGroup) -> None:
    ask.add_argument(
        "--depart",
        type=parse_time,
        metavar="TIME",
        help="ISO time, UTC unless it has an offset (default: the next full hour of the forecast)",
    )
    ask.add_argument(
        "--forecast",
        action="append",
        metavar="SOURCE",
        help=f"{', '.join(SERVICES)}, or a GRIB or NetCDF file; repeat to average several (default: auto)",
    )


def _add_mixing(ask: argparse._ArgumentGroup) -> None:
    ask.add_argument(
        "--weights",
        type=parse_weights,
        metavar="W,W",
        help="weights of several forecasts in their mean, in the order of --forecast (default: equal)",
    )
    ask.add_argument(
        "--current",
        type=parse_path,
        metavar="FILE",
        help="GRIB or NetCDF file with the current, instead of one that comes with the forecast",
    )


def parse_weights(text: str) -> tuple[float, ...]:
    """Read weights such as ``2,1``.

    Raises
    ------
    argparse.ArgumentTypeError
        One of them is no number.
    """
    values = [parse_number(part.strip()) for part in text.replace(";", ",").split(",")]
    if any(value is None or value <= 0.0 for value in values):
        raise argparse.ArgumentTypeError(f"{text!r} is not a list of numbers above 0 such as 2,1")
    return tuple(value for value in values if value is not None)


def add_yacht(parser: argparse.ArgumentParser, *, required: bool) -> None:
    """Add the yacht."""
    parser.add_argument(
        "--yacht", required=required, metavar="NAME", help="a name from polars/, or the path of a polar file"
    )


def add_sail_options(parser: argparse.ArgumentParser) -> None:
    """Add how to sail."""
    sail = parser.add_argument_group("how she is sailed")
    sail.add_argument(
        "--percent-of-polar",
        type=number_between(10, 150, "%"),
        metavar="PERCENT",
        help="share of the polar's speed that this crew reaches (default: 100)",
    )
    sail.add_argument(
        "--percent-at-night",
        type=number_between(10, 100, "%"),
        metavar="PERCENT",
        help="share of that speed which the crew keeps in the dark (default: 100)",
    )
    sail.add_argument(
        "--sea-state",
        dest="sea_state_percent",
        type=number_between(0, 50, "%"),
        metavar="PERCENT",
        help="what each metre of waves above half a metre takes off her speed head to sea, where the "
        "forecast has waves (default: 0; 8 is a rule of thumb)",
    )
    sail.add_argument(
        "--no-tacking",
        dest="tacking",
        action="store_false",
        default=None,
        help="no tacking up or gybing down the wind",
    )
    sail.add_argument(
        "--no-current",
        dest="currents",
        action="store_false",
        default=None,
        help="do not reckon with the current, where the forecast has one",
    )
    sail.add_argument(
        "--max-wind",
        dest="max_wind_kn",
        type=number_between(1, 100, "kn"),
        metavar="KN",
        help="never sail in more true wind than this",
    )
    sail.add_argument(
        "--max-gust",
        dest="max_gust_kn",
        type=number_between(1, 150, "kn"),
        metavar="KN",
        help="never sail in stronger gusts than this, where the forecast has gusts",
    )
    sail.add_argument(
        "--max-wave",
        dest="max_wave_m",
        type=number_between(0.1, 30, "m"),
        metavar="M",
        help="never sail in higher waves than this (significant height), where the forecast has waves",
    )
    sail.add_argument(
        "--motor-below",
        dest="motor_below_kn",
        type=number_between(0.1, 20, "kn"),
        metavar="KN",
        help="start the engine when she would sail slower than this",
    )
    sail.add_argument(
        "--motor-speed",
        dest="motor_speed_kn",
        type=number_between(0.5, 30, "kn"),
        metavar="KN",
        help="speed under engine (default: 5)",
    )
    sail.add_argument(
        "--fuel-rate",
        dest="fuel_rate_l_h",
        type=number_between(0, 200, "l/h"),
        metavar="L/H",
        help="consumption under engine (default: 2.5)",
    )


def add_manoeuvres(parser: argparse.ArgumentParser) -> None:
    """Add what turning costs, how long boards are, and how far off the shore she keeps."""
    crew = parser.add_argument_group("what the crew likes")
    for kind, what in (("tack", "tack"), ("gybe", "gybe")):
        crew.add_argument(
            f"--{kind}-penalty",
            dest=f"{kind}_penalty_min",
            type=number_between(0, 120, "min"),
            metavar="MIN",
            help=f"what a {what} costs; boards are then weighed while the passage is searched",
        )
    crew.add_argument(
        "--turn-penalty",
        type=number_between(0, 60, "min"),
        metavar="P",
        help="minutes that each change of course costs for every 10 degrees",
    )
    crew.add_argument(
        "--boards",
        dest="board_h",
        type=number_between(0.1, 24, "h"),
        metavar="H",
        help="usual length of a board on a beat or run in open water (default: 1.5)",
    )
    crew.add_argument(
        "--most-turns",
        type=whole_number_between(0, 1000, "tacks and gybes"),
        metavar="N",
        help="no more tacks and gybes than this, as far as the water allows it",
    )
    crew.add_argument(
        "--shore-clearance",
        dest="shore_clearance_nm",
        type=number_between(0.1, 15, "nm"),
        metavar="NM",
        help="keep this far off every shore, but on the ways out of and into the ports",
    )
    crew.add_argument(
        "--may-wait",
        dest="may_wait_h",
        type=number_between(0, 240, "h"),
        metavar="H",
        help="leave up to this much later if that brings her there earlier, or at all",
    )


def add_search_options(parser: argparse.ArgumentParser) -> None:
    """Add how to sail and how to search."""
    add_sail_options(parser)
    add_manoeuvres(parser)
    search = parser.add_argument_group("how it is searched")
    search.add_argument("--preset", choices=("precise", "classic"), help="classic is R1 as published")
    search.add_argument("--directions", type=int, choices=DIRECTIONS, help="courses of the lattice")
    search.add_argument(
        "--spacing",
        dest="spacing_nm",
        type=number_between(0.1, 60, "nm"),
        metavar="NM",
        help="distance between the vertices of the lattice",
    )
    search.add_argument(
        "--lattice",
        choices=("triangular", "rectangular"),
        help="rectangular has 8, 16 or 32 directions (default: triangular, 12 to 132)",
    )
    search.add_argument(
        "--safety-radius",
        dest="safety_radius_nm",
        type=number_between(0.1, 15, "nm"),
        metavar="NM",
        help="refine the lattice this near to shores and zones, see --safety-levels",
    )
    search.add_argument(
        "--safety-levels",
        type=whole_number_between(1, 6, "levels"),
        metavar="S",
        help="halve the spacing this often within the safety radius",
    )
    search.add_argument(
        "--area", choices=("ellipse", "rectangle"), help="ellipse: provably large enough; rectangle: R1's"
    )
    search.add_argument(
        "--no-refine",
        dest="refine",
        action="store_false",
        default=None,
        help="the first search is the answer",
    )
    search.add_argument(
        "--beyond",
        choices=("hold", "fade", "refuse"),
        help="after the end of the forecast hold the last wind (default), let it fade to the usual within a "
        "day, or refuse to sail on",
    )


def add_avoid(parser: argparse.ArgumentParser) -> None:
    """Let the sailor name zones to keep out of."""
    parser.add_argument(
        "--avoid",
        type=parse_path,
        action="append",
        default=[],
        metavar="FILE.geojson",
        help="zones to keep out of, for good or for a time; besides those in the layers folder",
    )


def zones_from(arguments: argparse.Namespace, settings: Settings) -> Zones:
    """Read the zones of the layers folder and those that were named."""
    from seacruise.sea.zones import layer_files, load_zones

    return load_zones([*layer_files(settings.layers), *arguments.avoid])


def options_from(arguments: argparse.Namespace) -> Options:
    """Make the search options; what was not said is left to the preset."""
    from seacruise.passage import Options

    if getattr(arguments, "current", None) is not None and arguments.currents is False:
        raise InputError("--no-current leaves out what --current names; give one of the two.")
    said: dict[str, Any] = {name: getattr(arguments, name, None) for name in _OPTION_FIELDS}
    return Options(**{name: value for name, value in said.items() if value is not None})


def find_yacht_named(text: str, settings: Settings) -> Polar:
    """Find a yacht among the shipped and the sailor's own polars; say which files are broken."""
    from seacruise.resources import resource_path
    from seacruise.yacht.fleet import find_yacht, load_fleet

    fleet = load_fleet([resource_path("polars"), settings.user_polars])
    for problem in fleet.problems:
        say(f"Note: {problem}")
    return find_yacht(text, fleet)


def find_ends(arguments: argparse.Namespace) -> tuple[Port, Port]:
    """Find the two ports that were named."""
    from seacruise.ports import find_port, load_ports

    ports = load_ports()
    return find_port(arguments.start, ports), find_port(arguments.end, ports)


def fetch(arguments: argparse.Namespace, start: Port, end: Port, *, settings: Settings, job: Job) -> Wind:
    """Get the wind for a passage from the sources that were named."""
    from seacruise.between import fetch_wind_between

    names = arguments.forecast or ["auto"]
    return fetch_wind_between(
        names,
        start,
        end,
        arguments.depart,
        settings=settings,
        job=job,
        weights=arguments.weights,
        current=arguments.current,
    )
