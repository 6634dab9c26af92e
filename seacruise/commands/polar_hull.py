"""``seacruise polar hull``: how to make good any course, by tacking and gybing where that is faster."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from seacruise.commands import request as ask
from seacruise.commands.common import add_format, number_between

if TYPE_CHECKING:
    from seacruise.yacht.polar import Polar

DEFAULT_TWS_KN = (6.0, 12.0, 20.0)


def add_parser(actions: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the action."""
    hull = actions.add_parser(
        "hull",
        help="best headings for every course to the wind",
        description="Print, for courses to the wind, the two headings that make them good fastest, the share "
        "of the time on each, the sails where the polar knows them, and the speed of sailing direct.",
    )
    hull.add_argument("yacht", metavar="YACHT", help="a name from polars/, or the path of a polar file")
    hull.add_argument(
        "--tws",
        type=number_between(0.5, 100, "kn"),
        action="append",
        metavar="KN",
        help="true wind speed; repeat for several (default: 6, 12 and 20)",
    )
    hull.add_argument(
        "--every",
        type=number_between(1, 90, "degrees"),
        default=10.0,
        metavar="DEG",
        help="step of the courses (default: 10)",
    )
    add_format(hull)
    hull.set_defaults(run=run_hull)


def run_hull(arguments: argparse.Namespace) -> int:
    """Print the headings."""
    from seacruise.settings import Settings

    polar = ask.find_yacht_named(arguments.yacht, Settings.from_environment())
    answer = best_headings(polar, tuple(arguments.tws or DEFAULT_TWS_KN), arguments.every)
    if arguments.format == "json":
        from seacruise.export.jsonform import dumps

        print(dumps(answer))
    else:
        print(to_text(answer))
    return 0


def best_headings(polar: Polar, tws_kn: tuple[float, ...], every: float) -> dict[str, Any]:
    """Headings for courses from 0 to 180 degrees, ``every`` so many, in some winds [kn]."""
    import numpy as np

    courses = np.append(np.arange(0.0, 180.0, every), 180.0)
    return {
        "schema": "seacruise.polar-hull/1",
        "yacht": polar.name,
        "winds": [{"tws_kn": kn, "courses": _courses(polar, kn, courses)} for kn in tws_kn],
    }


def _courses(polar: Polar, tws_kn: float, courses: Any) -> list[dict[str, Any]]:
    from seacruise.units import MS_PER_KNOT
    from seacruise.yacht.hull import hull_headings, hull_speed
    from seacruise.yacht.sails import sail_at

    wind = tws_kn * MS_PER_KNOT
    made = hull_speed(polar, wind, courses)[0] / MS_PER_KNOT
    direct = polar.speed(wind, courses) / MS_PER_KNOT
    first, share, second, other = hull_headings(polar, wind, courses)
    answer = []
    for k, course in enumerate(courses):
        headings = [
            {
                "twa_deg": round(float(twa), 1),
                "share": round(float(part), 3),
                "boat_speed_kn": round(float(polar.speed(wind, twa)) / MS_PER_KNOT, 2),
                "sail": sail_at(polar, wind, float(twa)),
            }
            for twa, part in ((first[k], share[k]), (second[k], other[k]))
            if part > 0.0
        ]
        answer.append(
            {
                "course_deg": round(float(course), 1),
                "made_good_kn": round(float(made[k]), 2),
                "direct_kn": round(float(direct[k]), 2),
                "headings": headings,
            }
        )
    return answer


def to_text(answer: dict[str, Any]) -> str:
    """One table for each wind."""
    lines = [answer["yacht"]]
    for wind in answer["winds"]:
        lines += ["", f"Courses to {wind['tws_kn']:g} kn of wind, speeds in kn", ""]
        lines.append(f"{'course':>7}{'made good':>11}{'direct':>8}  how")
        for row in wind["courses"]:
            lines.append(
                f"{row['course_deg']:>6g}°{row['made_good_kn']:>11.2f}{row['direct_kn']:>8.2f}  {_how(row)}"
            )
    return "\n".join(lines)


def _how(row: dict[str, Any]) -> str:
    if row["made_good_kn"] == 0.0:
        return "becalmed"
    if len(row["headings"]) == 1:
        sail = row["headings"][0]["sail"]
        return f"direct, {sail}" if sail else "direct"
    return " + ".join(
        f"{100.0 * heading['share']:.0f} % at {heading['twa_deg']:g}°"
        + (f" ({heading['sail']})" if heading["sail"] else "")
        for heading in row["headings"]
    )
