"""``seacruise polar convert``: a polar as another program reads it."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from seacruise.commands import request as ask
from seacruise.commands.common import add_format, parse_path, say

if TYPE_CHECKING:
    from seacruise.yacht.polar import Polar

# Also in seacruise.yacht.writers, which needs numpy: --help answers without. A test holds them together.
FORMATS = ("seacruise", "json", "opencpn", "expedition", "maxsea", "qtvlm", "hrosailing", "points")
FILLED = {"maxsea", "qtvlm", "hrosailing"}
WITH_SAILS = {"seacruise", "json"}


def add_parser(actions: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the action."""
    convert = actions.add_parser(
        "convert",
        help="write a polar for another program",
        description="Read a polar of any known format and write it in another one. See docs/yachts.md.",
    )
    convert.add_argument("yacht", metavar="IN", help="a polar file of any known format, or a yacht's name")
    convert.add_argument("out", metavar="OUT", type=parse_path, help="the file to write")
    convert.add_argument(
        "--to", dest="form", choices=FORMATS, default="seacruise", help="its format (default: seacruise)"
    )
    add_format(convert)
    convert.set_defaults(run=run_convert)


def run_convert(arguments: argparse.Namespace) -> int:
    """Write the polar and tell what was written."""
    from seacruise.settings import Settings
    from seacruise.yacht.files import write_polar

    polar = ask.find_yacht_named(arguments.yacht, Settings.from_environment())
    write_polar(polar, arguments.out, form=arguments.form)
    answer = what_was_written(polar, str(arguments.out), arguments.form)
    if answer["interpolated"]:
        say(f"Note: {arguments.form} knows no empty cells; {answer['interpolated']} were interpolated.")
    if polar.sails and not answer["sails"]:
        say(f"Note: {arguments.form} knows no sails; the file has the best of {len(polar.sails)}.")
    if arguments.format == "json":
        from seacruise.export.jsonform import dumps

        print(dumps(answer))
    else:
        winds, angles = len(answer["tws_kn"]), answer["angles"]
        print(f"{polar.name}: {winds} wind speeds and {angles} angles written to {arguments.out}")
    return 0


def what_was_written(polar: Polar, out: str, form: str) -> dict[str, Any]:
    """Describe the file: yacht, format, winds [kn], and what was filled in or left out."""
    import numpy as np

    from seacruise.units import MS_PER_KNOT

    return {
        "schema": "seacruise.polar-file/1",
        "file": out,
        "format": form,
        "yacht": polar.name,
        "tws_kn": [round(float(tws) / MS_PER_KNOT, 2) for tws in polar.tws],
        "angles": len(polar.twa),
        "interpolated": int(np.isnan(polar.speed_table).sum()) if form in FILLED else 0,
        "sails": [sail.name for sail in polar.sails] if form in WITH_SAILS else [],
    }
