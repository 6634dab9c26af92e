"""``seacruise polar show``: target speeds as a table."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from seacruise.commands import request as ask
from seacruise.commands.common import add_format

if TYPE_CHECKING:
    from seacruise.yacht.polar import Polar


def add_parser(actions: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the action."""
    show = actions.add_parser(
        "show",
        help="target speeds as a table",
        description="Print boat speed by true wind angle and speed, and the best ones up and down the wind.",
    )
    show.add_argument("yacht", metavar="YACHT", help="a name from polars/, or the path of a polar file")
    add_format(show)
    show.set_defaults(run=run_show)


def run_show(arguments: argparse.Namespace) -> int:
    """Print the target speeds of a yacht."""
    from seacruise.settings import Settings

    polar = ask.find_yacht_named(arguments.yacht, Settings.from_environment())
    targets = target_speeds(polar)
    if arguments.format == "json":
        from seacruise.export.jsonform import dumps

        print(dumps(targets))
    else:
        print(to_text(targets))
    return 0


def target_speeds(polar: Polar) -> dict[str, Any]:
    """Boat speed [kn] at the polar's own angles and winds, and the best VMG to windward and downwind."""
    import numpy as np

    from seacruise.units import MS_PER_KNOT

    # Angles with a figure or two are the best beat or run of some wind; those have rows of their own.
    full = np.isfinite(polar.speed_table).mean(axis=1) > 0.5
    if polar.sails:
        # Neither has an angle at which sails change: they are listed below.
        full &= np.isin(polar.twa, np.concatenate([sail.twa for sail in polar.sails]))
    twa = polar.twa[full] if full.any() else polar.twa
    speed = polar.speed(polar.tws[None, :], twa[:, None]) / MS_PER_KNOT

    def best(upwind: bool) -> dict[str, list[float]]:
        angle, vmg = polar.best_vmg(polar.tws, upwind)
        return {"twa_deg": _rounded(angle, 1), "vmg_kn": _rounded(vmg / MS_PER_KNOT, 2)}

    answer: dict[str, Any] = {
        "schema": "seacruise.polar/1",
        "yacht": polar.name,
        "source": polar.source,
        "tws_kn": _rounded(polar.tws / MS_PER_KNOT, 2),
        "twa_deg": _rounded(twa, 2),
        "boat_speed_kn": [_rounded(row, 2) for row in speed],
        "beat": best(True),
        "run": best(False),
    }
    if polar.sails:
        answer["sail_ranges"] = _sail_ranges(polar)
    return answer


def _sail_ranges(polar: Polar) -> list[dict[str, Any]]:
    """Which sail to set between which angles, wind speed by wind speed."""
    from seacruise.units import MS_PER_KNOT
    from seacruise.yacht.sails import SailSet

    sails = SailSet(polar.name, polar.sails)
    return [
        {
            "tws_kn": round(float(tws) / MS_PER_KNOT, 2),
            "ranges": [
                {"sail": part.sail, "twa_from": round(part.twa_from, 1), "twa_to": round(part.twa_to, 1)}
                for part in sails.ranges(float(tws))
            ],
        }
        for tws in polar.tws
    ]


def to_text(targets: dict[str, Any]) -> str:
    """Table with a column a wind speed and a row an angle, the best beat above and the best run below."""

    def row(label: str, cells: list[str]) -> str:
        return f"{label:>12} " + " ".join(f"{cell:>6}" for cell in cells)

    def best(name: str, figures: dict[str, list[float]]) -> list[str]:
        return [
            row(f"{name} angle", [f"{twa:.0f}°" for twa in figures["twa_deg"]]),
            row(f"{name} VMG", [f"{vmg:.1f}" for vmg in figures["vmg_kn"]]),
        ]

    lines = [targets["yacht"]]
    if targets["source"]:
        lines.append(targets["source"])
    lines += ["Boat speed [kn] by true wind angle and true wind speed [kn]", ""]
    lines += [row("TWA \\ TWS", [f"{tws:g}" for tws in targets["tws_kn"]]), *best("beat", targets["beat"])]
    for twa, speeds in zip(targets["twa_deg"], targets["boat_speed_kn"], strict=True):
        lines.append(row(f"{twa:g}°", [f"{speed:.2f}" for speed in speeds]))
    lines += best("run", targets["run"])
    if "sail_ranges" in targets:
        lines += ["", "Sails, from close-hauled to a run"]
        for wind in targets["sail_ranges"]:
            parts = [f"{part['sail']} to {part['twa_to']:.0f}°" for part in wind["ranges"]]
            lines.append(f"{wind['tws_kn']:>9g} kn  " + ", ".join(parts))
    return "\n".join(lines)


def _rounded(values: Any, digits: int) -> list[float]:
    return [round(float(value), digits) for value in values]
