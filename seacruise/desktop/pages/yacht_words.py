"""What the page of yachts says: an angle in a sentence, a table of targets, what a log has told."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QCoreApplication

from seacruise.desktop.language import fill, sentence
from seacruise.desktop.pages.rows import Column
from seacruise.desktop.pages.yacht_model import FromLog, Shown, reading_at, scaled
from seacruise.export.polar_slices import Slice
from seacruise.yacht.tacks import TwoSided
from seacruise.yacht.targets import Target, Targets


def tr(text: str) -> str:
    """Translate a text of this module."""
    return QCoreApplication.translate("yachts", text)


@dataclass(frozen=True, slots=True)
class TargetRow:
    """A wind of the table: targets of the yacht and, in the same wind, of the one she is compared with."""

    targets: Targets
    percent: float
    other: Targets | None = None


def target_columns() -> tuple[Column, ...]:
    """Columns of the table of targets; the last two are of the comparison."""

    def beat(row: TargetRow) -> Target:
        return scaled(row.targets.beat, row.percent)

    def run(row: TargetRow) -> Target:
        return scaled(row.targets.run, row.percent)

    def gain(row: TargetRow, way: str) -> float | None:
        if row.other is None:
            return None
        mine, theirs = getattr(row.targets, way), getattr(row.other, way)
        return float(mine.vmg_kn - theirs.vmg_kn) * row.percent / 100.0

    def signed(value: float | None) -> str:
        return "" if value is None else fill("{n:+.2f}", n=value)

    return (
        Column(
            tr("TWS"),
            tr("True wind speed [kn]"),
            lambda r: fill("{n:g}", n=r.targets.tws_kn),
            lambda r: r.targets.tws_kn,
            "00000",
        ),
        Column(
            tr("Beat"),
            tr("True wind angle of the best beat [degrees]"),
            lambda r: f"{r.targets.beat.twa:.0f}°",
            lambda r: r.targets.beat.twa,
            "000°",
        ),
        Column(
            tr("kn"),
            tr("Boat speed on the beat [kn]"),
            lambda r: fill("{n:.2f}", n=beat(r).boat_speed_kn),
            lambda r: beat(r).boat_speed_kn,
            "00.00",
        ),
        Column(
            tr("VMG"),
            tr("Made good against the wind [kn]"),
            lambda r: fill("{n:.2f}", n=beat(r).vmg_kn),
            lambda r: beat(r).vmg_kn,
            "00.00",
        ),
        Column(
            tr("Run"),
            tr("True wind angle of the best run [degrees]"),
            lambda r: f"{r.targets.run.twa:.0f}°",
            lambda r: r.targets.run.twa,
            "000°",
        ),
        Column(
            tr("kn"),
            tr("Boat speed on the run [kn]"),
            lambda r: fill("{n:.2f}", n=run(r).boat_speed_kn),
            lambda r: run(r).boat_speed_kn,
            "00.00",
        ),
        Column(
            tr("VMG"),
            tr("Made good with the wind [kn]"),
            lambda r: fill("{n:.2f}", n=run(r).vmg_kn),
            lambda r: run(r).vmg_kn,
            "00.00",
        ),
        Column(
            tr("± beat"),
            tr("By how much her VMG on the beat is better than the other yacht's [kn]"),
            lambda r: signed(gain(r, "beat")),
            lambda r: gain(r, "beat"),
            "+0.00",
        ),
        Column(
            tr("± run"),
            tr("By how much her VMG on the run is better than the other yacht's [kn]"),
            lambda r: signed(gain(r, "run")),
            lambda r: gain(r, "run"),
            "+0.00",
        ),
    )


COMPARING_COLUMNS = (7, 8)


def best_text(cut: Slice, percent: float) -> str:
    """Best beat and run in a wind, while no angle is looked at."""
    share = percent / 100.0
    return fill(
        tr("Best beat {beat:.0f}°, VMG {up:.2f} kn.  Best run {run:.0f}°, VMG {down:.2f} kn."),
        beat=cut.beat.twa,
        up=cut.beat.vmg_kn * share,
        run=cut.run.twa,
        down=cut.run.vmg_kn * share,
    )


def angle_text(shown: Shown, cut: Slice, angle: float, percent: float, *, hull: bool) -> str:
    """Say what is sailed at an angle [degrees, negative on port tack], and whether two headings do better."""
    found = reading_at(shown.yacht, cut.tws_kn, angle, percent)
    tack = ""
    if isinstance(shown.yacht, TwoSided):
        tack = tr(" port") if angle < 0.0 else tr(" starboard")
    parts = [
        fill(tr("TWA {twa:.0f}°{tack}: {speed:.2f} kn"), twa=found.twa, tack=tack, speed=found.boat_speed_kn),
        fill(
            tr("VMG {vmg:.2f} kn to windward") if found.twa < 90.0 else tr("VMG {vmg:.2f} kn to leeward"),
            vmg=found.vmg_kn,
        ),
        fill(tr("apparent {awa:.0f}°, {aws:.1f} kn"), awa=found.awa, aws=found.aws_kn),
    ]
    if found.sail:
        parts.append(found.sail)
    words = ", ".join(parts) + "."
    if hull and not tack and (better := _better(cut, abs(angle), percent)):
        words += "  " + better
    return words


def _better(cut: Slice, course: float, percent: float) -> str:
    chord = next((c for c in cut.chords if c.course_from <= course <= c.course_to), None)
    direct, made = (float(np.interp(course, cut.twa, y)) for y in (cut.speed_kn, cut.hull_kn))
    if chord is None or made <= direct * 1.001:
        return ""
    made *= percent / 100.0
    if chord.twa1 == -chord.twa2:
        how = tr("tacking") if course < 90.0 else tr("gybing")
        return fill(
            tr("{how} at {angle:.0f}° makes good {made:.2f} kn that way."),
            how=how[:1].upper() + how[1:],
            angle=abs(chord.twa1),
            made=made,
        )
    one, two = (
        f"{abs(angle):.0f}°" + (f" ({sail})" if sail else "")
        for angle, sail in ((chord.twa1, chord.sail1), (chord.twa2, chord.sail2))
    )
    return fill(tr("{one} and {two} by turns make good {made:.2f} kn that way."), one=one, two=two, made=made)


def fit_text(found: FromLog) -> str:
    """Say what a log has told."""
    said = [
        tr("Fitted to {n} steady means of 10 s from {logs}.").format(
            n=found.steady, logs=sentence(found.points.source)
        )
    ]
    if found.share is not None and found.share_error is not None:
        said.append(
            fill(
                tr("She sails {share:.1f} ± {error:.1f} % of the polar it was held against."),
                share=100.0 * found.share,
                error=100.0 * found.share_error,
            )
        )
    if found.tacks is not None:
        faster = tr("starboard") if found.tacks > 0.0 else tr("port")
        said.append(
            fill(
                tr("She is {percent:.1f} % faster on {tack} tack."),
                percent=100.0 * abs(found.tacks),
                tack=faster,
            )
        )
    return " ".join(said)
