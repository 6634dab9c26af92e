"""``seacruise ports``: which harbours there are, and whether a file of them is sound."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from seacruise.commands.common import add_format, cancellable_job, parse_path
from seacruise.errors import InputError, NoPassageError

if TYPE_CHECKING:
    from seacruise.ports import Port
    from seacruise.progress import Job

_MARGIN_DEG = 0.5
_FAR_NM = 1.0
"""A harbour farther from open water than this is worth a look: a typing error, or a river."""


def add_parser(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the sub-command and what it can do."""
    parser = commands.add_parser("ports", help="the harbours that can be named")
    actions = parser.add_subparsers(dest="action", required=True, metavar="ACTION")
    listing = actions.add_parser("list", help="print them", description="Print the harbours.")
    listing.add_argument("--search", metavar="TEXT", help="only those that fit what is typed, best first")
    add_format(listing)
    listing.set_defaults(run=run_list)
    check = actions.add_parser(
        "check",
        help="read a ports.csv and look how far from open water its harbours are",
        description="Read a file of ports, name its first mistake, and look how far each is from open water.",
    )
    check.add_argument(
        "file", nargs="?", type=parse_path, metavar="FILE", help="default: the one that is shipped"
    )
    add_format(check)
    check.set_defaults(run=run_check)


def run_list(arguments: argparse.Namespace) -> int:
    """Print the ports, or those that fit a text; none is an error."""
    from seacruise.geodesy import format_position
    from seacruise.ports import load_ports, search_ports

    ports = load_ports()
    text = arguments.search
    found = list(ports) if text is None else search_ports(text, ports, limit=len(ports))
    if not found:
        raise InputError(f"No port fits {text!r}; seacruise ports list prints all {len(ports)}.")
    if arguments.format == "json":
        from seacruise.export.jsonform import dumps

        print(dumps([_as_json(port) for port in found]))
        return 0
    width = max(len(port.name) for port in found)
    for port in found:
        print(f"{port.name:<{width}}  {port.country:2}  {format_position(port.lat, port.lon)}")
    return 0


def run_check(arguments: argparse.Namespace) -> int:
    """Print each port's distance to open water; exit code 2 when one has none."""
    from seacruise.ports import load_ports
    from seacruise.settings import Settings

    ports = load_ports(arguments.file)
    settings = Settings.from_environment()
    with cancellable_job() as job:
        distances = [_distance_nm(port, settings.cache_dir, job) for port in ports]
    stranded = [port.name for port, distance in zip(ports, distances, strict=True) if distance is None]
    if arguments.format == "json":
        from seacruise.export.jsonform import dumps, number

        pairs = zip(ports, distances, strict=True)
        rows = [{**_as_json(port), "open_water_nm": number(distance, 2)} for port, distance in pairs]
        print(dumps({"ports": rows, "stranded": stranded}))
    else:
        _print_check(ports, distances)
    return InputError.exit_code if stranded else 0


def _distance_nm(port: Port, cache_dir: Path, job: Job) -> float | None:
    from seacruise.sea import Sea

    job.check()
    sea = Sea.around([port.lat], [port.lon], margin_deg=_MARGIN_DEG, cache_dir=cache_dir)
    try:
        return float(sea.snap(port.lat, port.lon, name=port.name).distance_nm)
    except NoPassageError:
        return None


def _print_check(ports: tuple[Port, ...], distances: list[float | None]) -> None:
    far = 0
    for port, distance in zip(ports, distances, strict=True):
        if distance is None:
            print(f"{port.name}: no open water near it; check its position, latitude first")
        elif distance > _FAR_NM:
            far += 1
            print(f"{port.name}: {distance:.1f} nm from open water")
    without = sum(distance is None for distance in distances)
    print(f"{len(ports)} ports: {without} without open water, {far} farther than {_FAR_NM:g} nm from it")


def _as_json(port: Port) -> dict[str, object]:
    return {"name": port.name, "country": port.country, "lat": port.lat, "lon": port.lon}
