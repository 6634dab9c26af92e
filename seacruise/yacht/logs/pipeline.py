"""The use case: logs in, a polar and an account of it out. Each step is a module of this folder."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from math import nan
from pathlib import Path
from typing import Final, Literal

import numpy as np

from seacruise.errors import InputError
from seacruise.progress import Job
from seacruise.yacht.logs import filters, steady, update, water, weigh, wind
from seacruise.yacht.logs.average import SPAN_S, averaged
from seacruise.yacht.logs.cells import read_cells
from seacruise.yacht.logs.fit import Fitted, Method, fit_cloud, fit_table, nodes
from seacruise.yacht.logs.log import Array, Log, Mask, Points, Tally, Vectors, joined, points_of
from seacruise.yacht.logs.nmea import Checksum
from seacruise.yacht.logs.source import read_log
from seacruise.yacht.logs.tacks import Asymmetry, asymmetry
from seacruise.yacht.polar import Polar

LEAST_POINTS: Final = 30

Weigher = Literal["mean", "member", "fluctuation"]
WEIGHERS: Final[tuple[Weigher, ...]] = ("mean", "member", "fluctuation")

_HELD_S: Final = 600.0
_NO_WEIGHT: Final = 1e-9

_MOST_SPEED_SPREAD: Final = 0.5
_MOST_WIND_SPREAD: Final = 1.5
"""Standard deviations [m/s] within two minutes at which the weight by fluctuation is 0."""


@dataclass(frozen=True, slots=True)
class Choices:
    """How logs become a polar.

    Attributes
    ----------
    checksum
        Which NMEA sentences to believe.
    variation_deg
        Magnetic variation where a log tells none [degrees, positive to the east].
    calibrate
        Correct log and compass by the ground where that can be told.
    vane_deg
        Offset of the vane [degrees]; ``None`` to find it from the beats.
    current
        Where the water goes to [degrees true, m/s]; ``None`` to estimate it where that can be told.
    weighers
        Weights are multiplied.
    drop_share, least_weight
        Share of the points with the least weights that is left out, and the least weight that is kept.
    orthogonal
        Fit the curve by orthogonal distance.
    """

    checksum: Checksum = "auto"
    variation_deg: float = nan
    calibrate: bool = True
    vane_deg: float | None = None
    current: tuple[float, float] | None = None
    method: Method = "table"
    weighers: tuple[Weigher, ...] = ("mean",)
    drop_share: float = 0.05
    least_weight: float = 0.0
    orthogonal: bool = False
    rules: steady.Rules = steady.CRUISING


@dataclass(frozen=True, slots=True, eq=False)
class Reading:
    """What came of one file.

    Attributes
    ----------
    rows, means
        Moments read, and means made of them.
    hours
        Time that the means stand for [h].
    filled
        Share of the means whose speed through the water is that over ground, less the current.
    """

    path: Path
    tally: Tally
    rows: int
    means: int
    hours: float
    filled: float
    calibration: water.Calibration | None


@dataclass(frozen=True, slots=True, eq=False)
class Prepared:
    """Steady points of all logs, and how they were found.

    Attributes
    ----------
    rejected
        By reason, the means that were no steady sailing; see `seacruise.yacht.logs.steady`.
    vane
        The vane as it was found; ``None`` where it was not, or an offset was given.
    vane_deg
        The offset that was applied [degrees].
    """

    readings: tuple[Reading, ...]
    points: Points
    rejected: Counter[str]
    vane: wind.Vane | None
    vane_deg: float


@dataclass(frozen=True, slots=True)
class HeldBack:
    """How well a polar made of part of the time foretells the rest.

    Attributes
    ----------
    means
        Steady means that were foretold.
    median, ninth_tenth
        Of the shares by which the speed was missed, the middle one and the one that nine tenths stay below.
    bias
        Mean of foretold over sailed speed, less 1.
    """

    means: int
    median: float
    ninth_tenth: float
    bias: float


@dataclass(frozen=True, slots=True, eq=False)
class LogFit:
    """A polar from logs, and what it rests on.

    Attributes
    ----------
    fitted
        Figures, errors and counts, joined with the prior where one was given.
    seen
        The same from these logs alone.
    dropped
        Points left out for their weight.
    held_back
        How well the logs foretell themselves; ``None`` where they are too short for that.
    performance
        How she does against the prior; ``None`` without one.
    tacks
        Difference between the tacks; ``None`` where it cannot be told.
    """

    prepared: Prepared
    polar: Polar
    fitted: Fitted
    seen: Fitted
    dropped: int
    held_back: HeldBack | None
    performance: update.Performance | None
    tacks: Asymmetry | None


def fit_logs(
    paths: Sequence[Path],
    choices: Choices,
    *,
    name: str,
    prior: Polar | None = None,
    job: Job | None = None,
) -> LogFit:
    """Make a polar of logs.

    Parameters
    ----------
    paths
        Logs of one yacht, of any kind that is known.
    name
        The yacht.
    prior
        What is believed of her so far: a certificate, or a polar that was fitted before.

    Raises
    ------
    InputError
        A log cannot be read, or there is too little steady sailing in all of them.
    """
    prepared = prepare(paths, choices, job=job)
    points = weighed(prepared.points, choices)
    fitted = seen = fit_points(points, choices, nodes(points))
    performance = None
    if prior is not None:
        remembered = read_cells(prior)
        performance = update.performance(points, prior)
        if remembered is None:
            scale = performance.shrunk if performance else 1.0
            axes = update.joined_axes(prior, seen)
            remembered = update.believed(prior, *axes, scale=scale)
        else:
            remembered = remembered.on(*update.joined_axes(remembered, seen))
        seen = fit_points(points, choices, (remembered.tws, remembered.twa))
        fitted = update.updated(remembered, seen)
    source = f"fitted to {len(points)} steady means of {SPAN_S:g} s from {_names(paths)}"
    return LogFit(
        prepared,
        fitted.polar(name, source=source),
        fitted,
        seen,
        len(prepared.points) - len(points),
        held_back(prepared.points, choices),
        performance,
        asymmetry(prepared.points, *nodes(prepared.points)),
    )


def _names(paths: Sequence[Path]) -> str:
    names = [Path(path).name for path in paths]
    return ", ".join(names) if len(names) <= 3 else f"{names[0]} and {len(names) - 1} other logs"


def prepare(paths: Sequence[Path], choices: Choices, *, job: Job | None = None) -> Prepared:
    """Read logs and find what was steady sailing; the steps up to the points.

    Raises
    ------
    InputError
        A log cannot be read, or there is too little steady sailing in all of them.
    """
    watch = job or Job()
    parts = []
    for number, path in enumerate(paths):
        watch.check()
        watch.report("logs", number / len(paths), f"Reading {Path(path).name}")
        parts.append(_read(Path(path), choices, watch))
    log, current = joined(part[1] for part in parts), np.concatenate([part[2] for part in parts])
    order = np.argsort(log.time, kind="stable")
    log, current = log.rows(order), current[order]
    vane = wind.vane_of(log, span_s=SPAN_S) if choices.vane_deg is None else None
    vane_deg = choices.vane_deg if choices.vane_deg is not None else (vane.offset_deg if vane else 0.0)
    log = wind.with_true_wind(wind.with_vane_turned(log, vane_deg) if vane_deg else log)
    reason = steady.judged(log, current, span_s=SPAN_S, rules=choices.rules)
    rejected = Counter({steady.REASONS[k]: int((reason == k).sum()) for k in np.unique(reason[reason >= 0])})
    points = points_of(log.rows(reason == steady.STEADY), span=SPAN_S)
    if len(points) < LEAST_POINTS:
        raise InputError(_too_little(len(points), len(log), rejected), reason="too-little-sailing")
    return Prepared(tuple(part[0] for part in parts), points, rejected, vane, vane_deg)


def _too_little(steady_means: int, means: int, rejected: Counter[str]) -> str:
    why = ", ".join(f"{count} {reason}" for reason, count in rejected.most_common(3))
    return (
        f"The logs have {steady_means} means of {SPAN_S:g} s of steady sailing, {LEAST_POINTS} are needed; "
        f"of {means} means {why or 'none had wind and speed'}."
    )


def _read(path: Path, choices: Choices, job: Job) -> tuple[Reading, Log, Vectors]:
    """Read a log, calibrate it, and take out the current; the wind waits for the vane."""
    tally = Tally()
    rows = 0

    def blocks() -> Iterator[Log]:
        nonlocal rows
        for block in read_log(path, tally, checksum=choices.checksum, variation_deg=choices.variation_deg):
            job.check()
            rows += len(block)
            yield block

    log = averaged(blocks())
    calibration = water.calibrated(log) if choices.calibrate else None
    if calibration is not None and calibration.trusted:
        log = water.corrected(log, calibration)
    if choices.current is not None:
        current = water.given_current(log, *choices.current)
    else:
        current = water.estimated_current(log)
    log, filled = water.without_current(log, current)
    hours = len(log) * SPAN_S / 3600.0
    share = float(filled.mean()) if len(log) else 0.0
    return Reading(path, tally, rows, len(log), hours, share, calibration), log, current


def weighed(points: Points, choices: Choices) -> Points:
    """Weigh points and leave out those with the least weights.

    Raises
    ------
    InputError
        Next to none is left.
    """
    weight: Array = np.ones(len(points))
    for weigher in choices.weighers:
        weight = weight * _WEIGH[weigher](points)
    keep: Mask = filters.above_quantile(weight, choices.drop_share)
    keep &= filters.bounded(weight, low=max(choices.least_weight, _NO_WEIGHT))
    if keep.sum() < LEAST_POINTS / 2:
        raise InputError(
            f"Only {keep.sum()} of {len(points)} steady means have the weight that is asked for; "
            "leave out fewer (--drop, --least-weight), or weigh in another way (--weigh)."
        )
    return replace(points, weight=weight).rows(keep)


def _by_fluctuation(points: Points) -> Array:
    speed = weigh.fluctuation(points.time, points.speed, most=_MOST_SPEED_SPREAD)
    return speed * weigh.fluctuation(points.time, points.tws, most=_MOST_WIND_SPREAD)


_WEIGH: Final[dict[Weigher, Callable[[Points], Array]]] = {
    "mean": weigh.cylindric_mean,
    "member": weigh.cylindric_member,
    "fluctuation": _by_fluctuation,
}


def fit_points(points: Points, choices: Choices, axes: tuple[Array, Array]) -> Fitted:
    """Fit weighed points at nodes, by the method of the choices."""
    if choices.method == "curve":
        # SciPy takes half a second to load and is optional.
        from seacruise.yacht.logs.curve import fit_curve

        return fit_curve(points, *axes, orthogonal=choices.orthogonal)
    return (fit_cloud if choices.method == "cloud" else fit_table)(points, *axes)


def held_back(points: Points, choices: Choices) -> HeldBack | None:
    """Hold back every fourth ten minutes, foretell it from a fit of the rest; each of the four in turn.

    Whole blocks of time, since the next ten seconds are known from the last ten whatever the polar.

    Returns
    -------
    HeldBack or None
        ``None`` where no part is long enough.
    """
    block = np.floor(points.time / _HELD_S) % 4
    ratios = [_foretold(points.rows(block != k), points.rows(block == k), choices) for k in range(4)]
    ratio = np.concatenate(ratios)
    if not ratio.size:
        return None
    median, ninth_tenth = (float(v) for v in np.percentile(np.abs(ratio), (50.0, 90.0)))
    return HeldBack(ratio.size, median, ninth_tenth, float(ratio.mean()))


def _foretold(known: Points, asked: Points, choices: Choices) -> Array:
    """Foretold over sailed speed, less 1; nothing where the part that is known makes no polar."""
    if len(known) < LEAST_POINTS or not len(asked):
        return np.empty(0)
    try:
        known = weighed(known, choices)
        polar = fit_points(known, choices, nodes(known)).polar("held back")
    except InputError:
        return np.empty(0)
    return np.asarray(polar.speed(asked.tws, asked.twa) / asked.speed - 1.0)
