"""``seacruise polar plot``: polars as pictures."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from seacruise.commands import request as ask
from seacruise.commands.common import add_format, cancellable_job, number_between, parse_path, say

if TYPE_CHECKING:
    from collections.abc import Sequence

    from seacruise.export.polar_slices import LogPoints
    from seacruise.yacht.polar import Polar

# Also in seacruise.export.polar_pictures, which needs numpy: --help answers without. A test holds them
# together.
KINDS = ("polar", "flat", "surface", "colour", "hull")


def add_parser(actions: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the action."""
    plot = actions.add_parser(
        "plot",
        help="polars as pictures",
        description="Draw a polar: slices round the wind (polar) or over the angle (flat), which also "
        "compare up to four yachts; all of it as a surface or as colours; or the hull of a slice, which "
        "tells what is made good by tacking, gybing and changing sails. Points of a log can be laid over it. "
        "See docs/yachts.md.",
    )
    plot.add_argument("yachts", metavar="YACHT", nargs="+", help="a name from polars/, or a polar file")
    plot.add_argument("--kind", choices=KINDS, default="polar", help="which picture (default: polar)")
    plot.add_argument(
        "--tws",
        type=_winds,
        action="append",
        metavar="KN,KN",
        help="true wind speeds of the slices, e.g. 6,10,14 (default: those of the polar; hull: 10)",
    )
    plot.add_argument(
        "--out", required=True, type=parse_path, metavar="FILE", help="the picture: .png, .pdf or .svg"
    )
    plot.add_argument(
        "--log",
        type=parse_path,
        action="append",
        metavar="FILE",
        help="lay the steady sailing of a log over it; repeat for several logs of the yacht",
    )
    plot.add_argument("--dark", action="store_true", help="light on dark")
    add_format(plot)
    plot.set_defaults(run=run_plot)


def _winds(text: str) -> list[float]:
    read = number_between(0.5, 100, "kn")
    return [read(part) for part in text.split(",")]


def run_plot(arguments: argparse.Namespace) -> int:
    """Draw the picture and tell what is in it."""
    from seacruise.atomic import check_target
    from seacruise.export.polar_pictures import form_of, winds_for, write_polar_picture
    from seacruise.settings import Settings

    check_target(arguments.out, "picture")
    form_of(arguments.out)
    settings = Settings.from_environment()
    polars = [ask.find_yacht_named(name, settings) for name in arguments.yachts]
    winds = winds_for(polars, arguments.kind, [kn for some in arguments.tws or () for kn in some])
    if arguments.tws and not winds:
        say(f"Note: the picture {arguments.kind} shows all winds; --tws changes nothing.")
    points = points_of_logs(arguments.log) if arguments.log else None
    write_polar_picture(
        arguments.out, polars, arguments.kind, tws_kn=winds, points=points, dark=arguments.dark
    )
    answer = what_was_drawn(polars, arguments.kind, winds, points=points, out=arguments.out)
    answer["theme"] = "dark" if arguments.dark else "light"
    if arguments.format == "json":
        from seacruise.export.jsonform import dumps

        print(dumps(answer))
    else:
        print(to_text(answer))
    return 0


def points_of_logs(paths: Sequence[Path]) -> LogPoints:
    """Steady sailing of some logs of a yacht.

    Raises
    ------
    InputError
        A log cannot be read, or there is too little steady sailing in them.
    """
    from seacruise.export.polar_slices import LogPoints
    from seacruise.units import MS_PER_KNOT
    from seacruise.yacht.logs.pipeline import Choices, prepare

    with cancellable_job() as job:
        points = prepare(paths, Choices(), job=job).points
    names = ", ".join(path.name for path in paths)
    return LogPoints(points.tws / MS_PER_KNOT, points.twa, points.speed / MS_PER_KNOT, names)


def what_was_drawn(
    polars: Sequence[Polar],
    kind: str,
    winds: Sequence[float],
    *,
    points: LogPoints | None,
    out: Path,
) -> dict[str, Any]:
    """Describe a picture: file, yachts, winds [kn] with each yacht's best VMG, headings, log."""
    from seacruise.export.polar_pictures import form_of
    from seacruise.export.polar_slices import NEAR_KN, slice_of

    answer: dict[str, Any] = {
        "schema": "seacruise.polar-picture/1",
        "file": str(out),
        "form": form_of(out),
        "kind": kind,
        "tws_kn": list(winds),
        "yachts": [],
        "log": None,
    }
    for polar in polars:
        slices = [_slice(slice_of(polar, kn), headings=kind == "hull") for kn in winds]
        answer["yachts"].append({"yacht": polar.name, "source": polar.source, "slices": slices})
    if points is not None:
        shown = sum(len(points.near(kn)) for kn in winds) if winds else len(points)
        answer["log"] = {"file": points.source, "points": len(points), "shown": shown}
        if winds:
            answer["log"]["within_kn"] = NEAR_KN
    return answer


def _slice(cut: Any, *, headings: bool) -> dict[str, Any]:
    best = {
        way: {
            "twa_deg": round(target.twa, 1),
            "boat_speed_kn": round(target.boat_speed_kn, 2),
            "vmg_kn": round(target.vmg_kn, 2),
        }
        for way, target in (("beat", cut.beat), ("run", cut.run))
    }
    answer: dict[str, Any] = {"tws_kn": cut.tws_kn, **best}
    if headings:
        answer["two_headings"] = [
            {
                "course_from": round(chord.course_from, 1),
                "course_to": round(chord.course_to, 1),
                "twa_deg": [round(chord.twa1, 1), round(chord.twa2, 1)],
                "sails": [chord.sail1, chord.sail2],
            }
            for chord in cut.chords
        ]
        answer["sail_ranges"] = [
            {"sail": part.sail, "twa_from": round(part.twa_from, 1), "twa_to": round(part.twa_to, 1)}
            for part in cut.ranges
        ]
    return answer


def to_text(answer: dict[str, Any]) -> str:
    """One line for the file, one for each yacht's slices."""
    lines = [f"{answer['kind']} picture of {_joined(y['yacht'] for y in answer['yachts'])}: {answer['file']}"]
    for yacht in answer["yachts"]:
        for cut in yacht["slices"]:
            beat, run = cut["beat"], cut["run"]
            lines.append(
                f"{yacht['yacht']}, {cut['tws_kn']:g} kn: beat {beat['twa_deg']:.0f}° VMG "
                f"{beat['vmg_kn']:.2f} kn, run {run['twa_deg']:.0f}° VMG {run['vmg_kn']:.2f} kn"
            )
    if log := answer["log"]:
        near = f", those within {log['within_kn']:g} kn of a wind" if "within_kn" in log else ""
        lines.append(f"{log['file']}: {log['shown']} of {log['points']} points of steady sailing{near}")
    return "\n".join(lines)


def _joined(names: Any) -> str:
    return ", ".join(names)
