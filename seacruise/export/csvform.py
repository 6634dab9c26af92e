"""The legs as CSV, for spreadsheets: decimal points and commas whatever the computer's language."""

from __future__ import annotations

import csv
import io
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
)


def legs_csv(passage: Passage) -> str:
    """One row a waypoint with the leg that begins there; the cells of the last one's leg are empty."""
    table = io.StringIO()
    writer = csv.writer(table, lineterminator="\n")
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
        cells = ["" if value is None else f"{value:.{digits}f}" for value, digits in figures]
        motor = "" if w.motor is None else "yes" if w.motor else "no"
        writer.writerow([number, format_time(w.time), *cells, w.tack or "", motor])
    return table.getvalue()


def write_csv(passage: Passage, path: Path) -> None:
    """Write `legs_csv` to a file.

    Raises
    ------
    InputError
        The file cannot be written.
    """
    write_atomically(path, legs_csv(passage), what="CSV file")
