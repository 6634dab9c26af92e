"""``seacruise polar compare``: by how much two yachts, or two polars of one, differ."""

from __future__ import annotations

import argparse
import math
from typing import TYPE_CHECKING, Any

from seacruise.commands import request as ask
from seacruise.commands.common import add_format, number_between

if TYPE_CHECKING:
    from seacruise.yacht.polar import Polar

ANGLES = (45.0, 52.0, 60.0, 75.0, 90.0, 110.0, 120.0, 135.0, 150.0, 165.0)


def add_parser(actions: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the action."""
    compare = actions.add_parser(
        "compare",
        help="differences between polars",
        description="Print by how much other polars differ from the first, in knots and per cent of its "
        "speed, by wind speed and angle, and the best beats and runs of each. Where one has no figures there "
        "is a dash.",
    )
    compare.add_argument("yacht", metavar="YACHT", help="the one to compare with: a name, or a polar file")
    compare.add_argument("others", metavar="OTHER", nargs="+", help="the ones that are compared")
    compare.add_argument(
        "--tws",
        type=number_between(0.5, 100, "kn"),
        action="append",
        metavar="KN",
        help="true wind speed; repeat for several (default: those of the first polar)",
    )
    add_format(compare)
    compare.set_defaults(run=run_compare)


def run_compare(arguments: argparse.Namespace) -> int:
    """Print the differences."""
    from seacruise.settings import Settings
    from seacruise.units import MS_PER_KNOT

    settings = Settings.from_environment()
    polars = [ask.find_yacht_named(name, settings) for name in (arguments.yacht, *arguments.others)]
    winds = arguments.tws or [round(float(tws) / MS_PER_KNOT, 2) for tws in polars[0].tws if tws > 0.0]
    answer = differences(polars, winds)
    if arguments.format == "json":
        from seacruise.export.jsonform import dumps

        print(dumps(answer))
    else:
        print(to_text(answer))
    return 0


def differences(polars: list[Polar], tws_kn: list[float]) -> dict[str, Any]:
    """Differences from the first polar at `ANGLES` and winds [kn], and everybody's targets.

    A difference is ``None`` where one of the two polars has no figures: in more or less wind than its table,
    above its beat or below its greatest angle.
    """
    import numpy as np

    from seacruise.units import MS_PER_KNOT

    wind = np.array(tws_kn) * MS_PER_KNOT
    twa = np.array(ANGLES)[:, np.newaxis]
    first = polars[0].speed(wind, twa) / MS_PER_KNOT
    known = polars[0].covers(wind, twa)
    others = []
    for other in polars[1:]:
        both = known & other.covers(wind, twa)
        less = np.where(both, other.speed(wind, twa) / MS_PER_KNOT - first, np.nan)
        share = 100.0 * less / np.where(first > 0.0, first, np.nan)
        others.append(
            {
                "yacht": other.name,
                "difference_kn": _table(less, 2),
                "difference_percent": _table(share, 1),
                "mean_percent": None if np.isnan(share).all() else round(float(np.nanmean(share)), 1),
            }
        )
    return {
        "schema": "seacruise.polar-comparison/1",
        "yacht": polars[0].name,
        "tws_kn": list(tws_kn),
        "twa_deg": list(ANGLES),
        "boat_speed_kn": _table(np.where(known, first, np.nan), 2),
        "others": others,
        "targets": [_targets(polar, tws_kn) for polar in polars],
    }


def _targets(polar: Polar, tws_kn: list[float]) -> dict[str, Any]:
    from seacruise.yacht.targets import targets

    found = targets(polar, tws_kn)
    return {"yacht": polar.name} | {
        way: {
            "twa_deg": [round(best.twa, 1) for best in bests],
            "boat_speed_kn": [round(best.boat_speed_kn, 2) for best in bests],
            "vmg_kn": [round(best.vmg_kn, 2) for best in bests],
        }
        for way, bests in (("beat", [t.beat for t in found]), ("run", [t.run for t in found]))
    }


def _table(values: Any, digits: int) -> list[list[float | None]]:
    return [[None if math.isnan(v) else round(float(v), digits) for v in row] for row in values]


def to_text(answer: dict[str, Any]) -> str:
    """Differences in knots and per cent, one table an other yacht, and the targets of all."""

    def row(label: str, cells: list[str]) -> str:
        return f"{label:>12} " + " ".join(f"{cell:>6}" for cell in cells)

    def table(values: list[list[float | None]], digits: int) -> list[str]:
        body = [row("TWA \\ TWS", [f"{tws:g}" for tws in answer["tws_kn"]])]
        for twa, cells in zip(answer["twa_deg"], values, strict=True):
            body.append(row(f"{twa:g}°", ["-" if v is None else f"{v:+.{digits}f}" for v in cells]))
        return body

    lines: list[str] = []
    for other in answer["others"]:
        mean = other["mean_percent"]
        lines += [f"{other['yacht']} against {answer['yacht']}"]
        lines += ["They have no wind and angle in common." if mean is None else f"{mean:+.1f} % in the mean"]
        lines += ["", "Difference of boat speed [kn]", *table(other["difference_kn"], 2)]
        lines += ["", "Difference of boat speed [%]", *table(other["difference_percent"], 1), ""]
    lines.append("Targets: angle and VMG [kn] of the best beat and run")
    lines.append(row("TWS", [f"{tws:g}" for tws in answer["tws_kn"]]))
    for one in answer["targets"]:
        lines.append(one["yacht"])
        for way in ("beat", "run"):
            lines.append(row(f"{way} angle", [f"{twa:.0f}°" for twa in one[way]["twa_deg"]]))
            lines.append(row(f"{way} VMG", [f"{vmg:.2f}" for vmg in one[way]["vmg_kn"]]))
    return "\n".join(lines)
