"""The legs as CSV after RFC 4180: decimal points and commas whatever the computer's language."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable
from pathlib import Path

from seacruise.atomic import write_atomically
from seacruise.export.jsonform import format_time
from seacruise.passage import Passage

COLUMNS = (
    "number",
    "time_utc",
    "lat",
    "lon",
    "course_deg",
    "leg_nm",
    "boat_speed_kn",
    "tws_kn",
    "twd_deg",
    "twa_deg",
    "tack",
    "motor",
    "sog_kn",
    "steer_deg",
    "current_kn",
    "current_to_deg",
    "sail",
)
"""New columns come at the end: spreadsheets count them."""


def legs_csv(passage: Passage) -> str:
    """One row a waypoint with the leg that begins there; the cells of the last one's leg are empty.

    Lines end with CR LF, as RFC 4180 wants them.
    """
    table = io.StringIO()
    writer = csv.writer(table, lineterminator="\r\n")
    writer.writerow(COLUMNS)
    for number, w in enumerate(passage.waypoints):
        figures = (
            (w.lat, 6),
            (w.lon, 6),
            (w.course_deg, 1),
            (w.leg_nm, 2),
            (w.boat_speed_kn, 2),
            (w.tws_kn, 1),
            (w.twd_deg, 1),
            (w.twa_deg, 1),
        )
        water = ((w.sog_kn, 2), (w.steer_deg, 1), (w.current_kn, 2), (w.current_to_deg, 1))
        motor = "" if w.motor is None else "yes" if w.motor else "no"
        about = [*_cells(figures), w.tack or "", motor, *_cells(water), w.sail or ""]
        writer.writerow([number, format_time(w.time), *about])
    return table.getvalue()


def _cells(figures: Iterable[tuple[float | None, int]]) -> list[str]:
    return ["" if value is None else f"{value:.{digits}f}" for value, digits in figures]


def write_csv(passage: Passage, path: Path) -> None:
    """Write `legs_csv` to a file.

    Raises
    ------
    InputError
        The file cannot be written.
    """
    write_atomically(path, legs_csv(passage), what="CSV file")
