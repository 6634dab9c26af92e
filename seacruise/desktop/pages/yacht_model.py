"""What the page of yachts knows and does, without Qt: search, targets, import, and a fit from logs."""

from __future__ import annotations

import importlib.util
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Final

import numpy as np

from seacruise.errors import InputError
from seacruise.export.polar_slices import LogPoints, target_at
from seacruise.text import fold, folds, rank_names
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.polar import Polar
from seacruise.yacht.tacks import TwoSided
from seacruise.yacht.targets import Target, Targets

if TYPE_CHECKING:
    from seacruise.progress import Job
    from seacruise.settings import Settings
    from seacruise.yacht.logs.pipeline import LogFit

Yacht = Polar | TwoSided

_MOST_ROWS: Final = 14


def search_yachts(text: str, names: Iterable[str]) -> list[str]:
    """Names that fit what is typed, best first; all of them for nothing."""
    every = list(names)
    return rank_names(text, {name: folds(name) for name in every}) if any(folds(text)) else every


@dataclass(frozen=True, slots=True, eq=False)
class Shown:
    """A yacht as the page shows her.

    Attributes
    ----------
    yacht
        The polar, or one for each tack.
    table
        The polar that is sailed; of two tacks the mean.
    rows
        Best beat and run in the winds of the table.
    least_kn, most_kn
        Winds that the slider runs over [kn].
    """

    yacht: Yacht
    table: Polar
    rows: tuple[Targets, ...]
    least_kn: int
    most_kn: int


def look_at(yacht: Yacht, job: Job | None = None, *, tws_kn: Sequence[float] = ()) -> Shown:
    """Make ready what is shown of a yacht; slow for polars of many sails, so not on the window's thread.

    Parameters
    ----------
    tws_kn
        Winds of the rows [kn]; without them those of the table.
    """
    table = yacht.to_table()
    for polar in (table, *((yacht.port, yacht.starboard) if isinstance(yacht, TwoSided) else ())):
        # The cubics behind the table are made once, when they are first asked for.
        _ = polar.curves
    winds = [float(tws) / MS_PER_KNOT for tws in table.tws if tws > 0.5 * MS_PER_KNOT]
    winds = list(tws_kn) or winds or [float(table.tws[-1]) / MS_PER_KNOT]
    if len(winds) > _MOST_ROWS:
        chosen = np.linspace(0, len(winds) - 1, _MOST_ROWS).round().astype(int).tolist()
        winds = [winds[k] for k in chosen]
    rows = []
    for kn in winds:
        if job is not None:
            job.check()
        rows.append(_targets(table, round(kn, 2)))
    least = max(1, int(np.floor(winds[0])))
    return Shown(yacht, table, tuple(rows), least, max(least + 1, int(np.ceil(round(winds[-1], 3)))))


def _targets(polar: Polar, tws_kn: float) -> Targets:
    wind = np.array([tws_kn * MS_PER_KNOT])
    beat, run = (float(polar.best_vmg(wind, up)[0][0]) for up in (True, False))
    return Targets(tws_kn, target_at(polar, tws_kn, beat), target_at(polar, tws_kn, run))


def targets_in(shown: Shown, tws_kn: float) -> Targets | None:
    """Find the row of a wind [kn]."""
    return next((row for row in shown.rows if abs(row.tws_kn - tws_kn) < 0.01), None)


def scaled(target: Target, percent: float) -> Target:
    """Take a share of a target's speed; the apparent wind follows."""
    share = percent / 100.0
    speed, twa = target.boat_speed_kn * share, np.radians(target.twa)
    # The true wind, from the apparent one of the whole speed.
    apparent = np.radians(target.awa)
    ahead = target.aws_kn * np.cos(apparent) - target.boat_speed_kn + speed
    abeam = target.aws_kn * np.sin(apparent)
    return replace(
        target,
        boat_speed_kn=speed,
        vmg_kn=speed * abs(float(np.cos(twa))),
        awa=float(np.degrees(np.arctan2(abeam, ahead))),
        aws_kn=float(np.hypot(ahead, abeam)),
    )


def reading_at(yacht: Yacht, tws_kn: float, twa_signed: float, percent: float) -> Target:
    """Tell what is sailed at an angle [degrees, negative on port tack] in a wind [kn], at some per cent."""
    polar = yacht if isinstance(yacht, Polar) else yacht.port if twa_signed < 0.0 else yacht.starboard
    return scaled(target_at(polar, tws_kn, abs(twa_signed)), percent)


def import_polar(path: Path, settings: Settings) -> Polar:
    """Check a polar file and copy it to the sailor's own.

    Raises
    ------
    InputError
        It is no polar, a file or a yacht of that name is there already, or it cannot be copied.
    """
    from seacruise.atomic import write_atomically
    from seacruise.yacht.files import read_polar
    from seacruise.yacht.fleet import POLAR_SUFFIXES, load_fleet

    if path.suffix.lower() not in POLAR_SUFFIXES:
        raise InputError(f"{path.name} is no polar file: it must end in {', '.join(POLAR_SUFFIXES)}.")
    polar = read_polar(path)
    target = settings.user_polars / path.name
    if _same_file(target, path):
        return polar
    if target.exists():
        raise InputError(f"There is already a polar file {path.name} of yours; rename one of them.")
    for own in load_fleet([settings.user_polars]).yachts.values():
        if fold(own.name) == fold(polar.name):
            file = own.path.name if own.path else own.source
            raise InputError(f"{path.name}: you have the yacht {polar.name} in {file}; rename one of them.")
    _make_folder(target.parent)
    try:
        content = path.read_bytes()
    except OSError as error:
        raise InputError(f"{path.name} cannot be read: {error.strerror or error}.") from error
    write_atomically(target, content, what="polar")
    return replace(polar, path=target)


def _same_file(target: Path, path: Path) -> bool:
    try:
        return target.samefile(path)
    except OSError:
        return False


def _make_folder(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(
            f"Your polar folder {folder} cannot be made: {error.strerror or error}; make room there."
        ) from error


# --- from a log ----------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True, eq=False)
class FromLog:
    """A polar fitted to logs, not kept yet.

    Attributes
    ----------
    yacht
        The fitted polar; one for each tack where the log shows a difference that is not chance.
    points
        The steady sailing it rests on.
    steady
        How many means that were.
    share, share_error
        Share of the prior polar that she sailed, and its standard error; ``None`` where it is not known.
    tacks
        Speed on starboard tack over that on port tack, less 1; ``None`` unless it is more than chance.
    """

    yacht: Yacht
    points: LogPoints
    steady: int
    share: float | None
    share_error: float | None
    tacks: float | None
    made: LogFit


def can_fit() -> bool:
    """Whether this installation can fit polars to logs."""
    try:
        return importlib.util.find_spec("seacruise.yacht.logs.pipeline") is not None
    except ModuleNotFoundError:
        return False


def fit_from_logs(paths: Sequence[Path], prior: Polar | None, job: Job) -> FromLog:
    """Fit a polar to logs, starting from the polar that is shown.

    Raises
    ------
    InputError
        A log cannot be read, or there is too little steady sailing.
    """
    from seacruise.yacht.logs.pipeline import Choices, fit_logs

    base = prior.name if prior is not None else paths[0].stem
    made = fit_logs(paths, Choices(), name=f"{base} (log)", prior=prior, job=job)
    steady = made.prepared.points
    points = LogPoints(
        steady.tws / MS_PER_KNOT, steady.twa, steady.speed / MS_PER_KNOT, ", ".join(p.name for p in paths)
    )
    significant = made.tacks is not None and made.tacks.significant
    yacht: Yacht = (_each_tack(made) if significant else None) or made.polar
    return FromLog(
        yacht,
        points,
        len(steady),
        made.performance.share if made.performance else None,
        made.performance.error if made.performance else None,
        made.tacks.difference if made.tacks is not None and significant else None,
        made,
    )


def _each_tack(made: LogFit) -> TwoSided | None:
    """Fit each tack on its own; ``None`` where one has too little sailing for a polar."""
    from seacruise.yacht.logs.fit import nodes
    from seacruise.yacht.logs.pipeline import Choices, fit_points, weighed

    def fitted(tack: str, sign: float) -> Polar:
        points = made.prepared.points
        points = weighed(points.rows(sign * points.twa > 0.0), Choices())
        return fit_points(points, Choices(), nodes(points)).polar(f"{made.polar.name}, {tack} tack")

    try:
        port, starboard = fitted("port", -1.0), fitted("starboard", 1.0)
    except InputError:
        return None
    return TwoSided(made.polar.name, port, starboard, source=made.polar.source)


def keep_fit(found: FromLog, settings: Settings) -> Polar:
    """Write a fitted polar, and what the next log learns on, into the sailor's own folder.

    A fit of the same name takes the place of the earlier one.

    Raises
    ------
    InputError
        The folder cannot be written to.
    """
    from seacruise.yacht.files import write_polar
    from seacruise.yacht.logs.cells import write_cells

    polar = found.made.polar
    stem = "-".join(fold(polar.name).split()) or "yacht"
    path = settings.user_polars / f"{stem}.csv"
    _make_folder(path.parent)
    write_polar(polar, path)
    write_cells(found.made.fitted, path)
    return replace(polar, path=path)


def yachts_of(settings: Settings) -> tuple[Mapping[str, Polar], tuple[str, ...]]:
    """Read all yachts and what is wrong with files that are none."""
    from seacruise.resources import resource_path
    from seacruise.yacht.fleet import load_fleet

    fleet = load_fleet([resource_path("polars"), settings.user_polars])
    return fleet.yachts, fleet.problems
