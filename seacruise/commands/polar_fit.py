"""``seacruise polar fit``: a polar from the boat's own logs."""

from __future__ import annotations

import argparse
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from seacruise.commands import request as ask
from seacruise.commands.common import add_format, cancellable_job, number_between, parse_path, say
from seacruise.text import parse_number

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from seacruise.yacht.logs.pipeline import Choices, LogFit, Reading

# Also in seacruise.yacht.logs, which needs numpy: --help answers without. A test holds them together.
CHECKSUMS = ("auto", "strict", "accept", "ignore")
METHODS = ("table", "cloud", "curve")
WEIGHERS = ("mean", "member", "fluctuation")


def add_parser(actions: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the action."""
    fit = actions.add_parser(
        "fit",
        help="a polar from the boat's own logs",
        description="Read logs (NMEA 0183, Signal K deltas, tables), keep steady sailing, fit a polar. "
        "See docs/logs.md.",
    )
    fit.add_argument("logs", nargs="+", type=parse_path, metavar="LOG", help="logs of one yacht")
    fit.add_argument("--out", required=True, type=parse_path, metavar="FILE.csv", help="polar file to write")
    fit.add_argument("--name", help="the yacht (default: the prior's name, or that of the file)")
    fit.add_argument(
        "--prior",
        metavar="POLAR",
        help="a yacht's name or a polar file to start from; one that was fitted before learns on",
    )
    fit.add_argument("--method", choices=METHODS, default="table", help="(default: table)")
    fit.add_argument(
        "--orthogonal", action="store_true", help="with curve: distances in wind and angle count as well"
    )
    _add_reading(fit)
    fit.add_argument(
        "--weigh",
        choices=WEIGHERS,
        action="append",
        help="how points are weighed; repeat to multiply (default: mean)",
    )
    fit.add_argument(
        "--drop",
        type=number_between(0, 50, "%"),
        default=5.0,
        metavar="PERCENT",
        help="share of the points with the least weights to leave out (default: 5)",
    )
    fit.add_argument(
        "--least-weight",
        type=number_between(0, 1, ""),
        default=0.0,
        metavar="WEIGHT",
        help="leave out all points of less weight, 0 to 1 (default: 0)",
    )
    add_format(fit)
    fit.set_defaults(run=run_fit)


def _add_reading(fit: argparse.ArgumentParser) -> None:
    fit.add_argument(
        "--checksum",
        choices=CHECKSUMS,
        default="auto",
        help="NMEA sentences: only with a right checksum (strict), also without one (accept), all (ignore); "
        "auto decides for each file (default)",
    )
    fit.add_argument(
        "--variation",
        type=number_between(-180, 180, "degrees"),
        metavar="DEG",
        help="magnetic variation where a log tells none, positive to the east",
    )
    fit.add_argument(
        "--current",
        type=_current,
        metavar="SET,KN",
        help="where the water goes to [degrees true] and how fast (default: estimated)",
    )
    fit.add_argument(
        "--vane",
        type=_vane,
        metavar="DEG",
        help="add this to the apparent wind angle; none for 0 (default: found from the beats)",
    )
    fit.add_argument(
        "--no-calibration",
        dest="calibrate",
        action="store_false",
        help="take log and compass as they are, without holding them against the ground",
    )


def _current(text: str) -> tuple[float, float]:
    parts = [parse_number(part) for part in text.split(",")]
    if len(parts) != 2 or parts[0] is None or parts[1] is None or not 0 <= parts[1] <= 20:
        raise argparse.ArgumentTypeError(f"{text!r} is no current; write it as 270,0.5")
    from seacruise.units import MS_PER_KNOT

    return parts[0], parts[1] * MS_PER_KNOT


def _vane(text: str) -> float:
    return 0.0 if text.strip().lower() == "none" else number_between(-45, 45, "degrees")(text)


def run_fit(arguments: argparse.Namespace) -> int:
    """Fit the logs, write the polar and tell what it rests on."""
    from seacruise.atomic import check_target
    from seacruise.settings import Settings
    from seacruise.yacht.files import write_polar
    from seacruise.yacht.logs.cells import write_cells
    from seacruise.yacht.logs.pipeline import fit_logs

    check_target(arguments.out, "polar")
    prior = ask.find_yacht_named(arguments.prior, Settings.from_environment()) if arguments.prior else None
    name = arguments.name or (prior.name if prior else _name_of(arguments.out))
    with cancellable_job() as job:
        made = fit_logs(arguments.logs, choices_from(arguments), name=name, prior=prior, job=job)
    write_polar(made.polar, arguments.out)
    cells = write_cells(made.fitted, arguments.out)
    account = to_json(made, arguments.out, cells)
    if arguments.format == "json":
        from seacruise.export.jsonform import dumps

        print(dumps(account))
    else:
        print(to_text(account))
    for reading in account["logs"]:
        for note in reading["notes"]:
            say(f"Note: {reading['file']}: {note}")
    return 0


def _name_of(path: Path) -> str:
    return " ".join(path.stem.replace("_", " ").split()) or path.name


def choices_from(arguments: argparse.Namespace) -> Choices:
    """Make the choices of what was said."""
    from seacruise.yacht.logs.pipeline import Choices

    return Choices(
        checksum=arguments.checksum,
        variation_deg=math.nan if arguments.variation is None else arguments.variation,
        calibrate=arguments.calibrate,
        vane_deg=arguments.vane,
        current=arguments.current,
        method=arguments.method,
        weighers=tuple(arguments.weigh or ("mean",)),
        drop_share=arguments.drop / 100.0,
        least_weight=arguments.least_weight,
        orthogonal=arguments.orthogonal,
    )


def to_json(made: LogFit, out: Path, cells: Path) -> dict[str, Any]:
    """Put the account into the object that is printed: what was read, used, rejected, and is known."""
    from seacruise.units import MS_PER_KNOT

    prepared, fitted = made.prepared, made.fitted
    vane, held, tacks, share = prepared.vane, made.held_back, made.tacks, made.performance
    return {
        "schema": "seacruise.polar-fit/1",
        "yacht": made.polar.name,
        "polar": str(out),
        "cells": str(cells),
        "logs": [_reading(reading) for reading in prepared.readings],
        "vane": {
            "applied_deg": round(prepared.vane_deg, 2),
            "beats_starboard_deg": round(vane.starboard_deg, 1) if vane else None,
            "beats_port_deg": round(vane.port_deg, 1) if vane else None,
        },
        "means": sum(reading.means for reading in prepared.readings),
        "rejected": dict(prepared.rejected.most_common()),
        "steady": len(prepared.points),
        "dropped_by_weight": made.dropped,
        "used": len(prepared.points) - made.dropped,
        "held_back": held
        and {
            "means": held.means,
            "median_error_percent": _percent(held.median),
            "ninth_tenth_error_percent": _percent(held.ninth_tenth),
            "bias_percent": _percent(held.bias),
        },
        "share_of_prior": share
        and {
            "percent": _percent(share.share),
            "error_percent": _percent(share.error),
            "independent": round(share.independent),
        },
        "starboard_against_port": tacks
        and {
            "percent": _percent(tacks.difference),
            "error_percent": _percent(tacks.error),
            "significant": tacks.significant,
        },
        "tws_kn": [round(float(v), 2) for v in fitted.tws / MS_PER_KNOT],
        "twa_deg": [round(float(v), 2) for v in fitted.twa],
        "boat_speed_kn": _table(fitted.speed / MS_PER_KNOT, 2),
        "standard_error_kn": _table(fitted.error / MS_PER_KNOT, 2),
        "points": _table(fitted.count, 1),
        "in_polar": fitted.certain.tolist(),
    }


def _reading(reading: Reading) -> dict[str, Any]:
    found = reading.calibration
    return {
        "file": reading.path.name,
        "used": reading.tally.used,
        "skipped": dict(reading.tally.skipped.most_common()),
        "rows": reading.rows,
        "hours": round(reading.hours, 2),
        "over_ground_percent": _percent(reading.filled),
        "calibration": found
        and {
            "applied": found.trusted,
            "log_factor": round(found.log_factor, 4),
            "compass_offset_deg": round(found.compass_offset_deg, 2),
            "error_percent": _percent(found.error),
        },
        "notes": reading.tally.notes,
    }


def _percent(share: float) -> float:
    return round(100.0 * share, 2)


def _table(values: NDArray[np.float64], digits: int) -> list[list[float | None]]:
    return [[None if math.isnan(v) else round(float(v), digits) for v in row] for row in values]


# --- text ----------------------------------------------------------------------------------------------


def to_text(account: dict[str, Any]) -> str:
    """Tell the account in words and a table of boat speeds with their standard errors."""
    lines = [line for reading in account["logs"] for line in _about_log(reading)]
    vane = account["vane"]
    if vane["beats_port_deg"] is not None:
        lines.append(
            f"Vane turned by {vane['applied_deg']:+.1f} degrees: she beats at "
            f"{vane['beats_starboard_deg']:g} degrees apparent on starboard and {vane['beats_port_deg']:g} "
            "on port tack."
        )
    rejected = ", ".join(f"{count} {reason}" for reason, count in account["rejected"].items())
    lines += [
        f"{account['means']} means of 10 s: {rejected or 'none rejected'}; {account['steady']} steady.",
        f"{account['dropped_by_weight']} of them dropped for their weight, {account['used']} used.",
    ]
    lines += [*_about_fit(account), "", "Boat speed [kn] ± standard error by true wind angle and speed [kn]"]
    lines += _text_table(account)
    lines += ["", f"Written: {account['polar']}, and {account['cells']} for the next log to learn on."]
    return "\n".join(lines)


def _about_log(reading: dict[str, Any]) -> list[str]:
    skipped = ", ".join(f"{count} {reason}" for reason, count in reading["skipped"].items())
    read = f"{reading['file']}: {reading['hours']:.1f} h; {reading['used']} sentences or rows used"
    lines = [f"{read}, skipped: {skipped or 'none'}."]
    found = reading["calibration"]
    if found:
        lines.append(
            f"  against the ground: log x {found['log_factor']:.3f}, compass "
            f"{found['compass_offset_deg']:+.1f} degrees, ± {found['error_percent']:.1f} %; "
            + ("applied." if found["applied"] else "too few courses or too uncertain, not applied.")
        )
    if reading["over_ground_percent"] > 0:
        lines.append(
            f"  {reading['over_ground_percent']:g} % without speed through the water: speed over ground, "
            "less the current, stands for it."
        )
    return lines


def _about_fit(account: dict[str, Any]) -> list[str]:
    lines = []
    if held := account["held_back"]:
        lines.append(
            "Every fourth ten minutes held back and foretold, in turn: "
            f"{held['median_error_percent']:.1f} % off in the middle, "
            f"{held['ninth_tenth_error_percent']:.1f} % at nine tenths."
        )
    if share := account["share_of_prior"]:
        lines.append(f"She sails {share['percent']:.1f} ± {share['error_percent']:.1f} % of the prior polar.")
    if tacks := account["starboard_against_port"]:
        lines.append(
            f"Starboard against port tack: {tacks['percent']:+.1f} ± {tacks['error_percent']:.1f} %"
            + ("." if tacks["significant"] else ", which may be chance.")
        )
    return lines


def _text_table(account: dict[str, Any]) -> list[str]:
    def cell(speed: float | None, error: float | None, certain: bool) -> str:
        if speed is None or error is None:
            return "-"
        return f"{speed:.1f}±{error:.1f}" if certain else f"({speed:.1f})"

    tables = ("boat_speed_kn", "standard_error_kn", "in_polar")
    rows = zip(account["twa_deg"], *(account[name] for name in tables), strict=True)
    table = [" TWA \\ TWS" + "".join(f"{tws:>10g}" for tws in account["tws_kn"])]
    for twa, speeds, errors, certain in rows:
        if any(speed is not None for speed in speeds):
            cells = (cell(*figures) for figures in zip(speeds, errors, certain, strict=True))
            table.append(f"{twa:>9g}°" + "".join(f"{text:>10}" for text in cells))
    if not all(map(all, account["in_polar"])):
        table.append("In brackets: too uncertain; the polar has what other angles and winds foretell there.")
    return table
