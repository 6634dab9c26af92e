"""A day of log at 1 Hz: how long it takes to become a polar, and how much memory."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable, Iterator
from datetime import UTC, datetime, timedelta
from functools import reduce
from importlib import import_module
from operator import xor
from pathlib import Path
from typing import Final

import numpy as np

from benchmarks.measure import Figures, Pace, attempt, run_process, say
from benchmarks.world import home, world
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.logs.log import Tally, angle_of, vector
from seacruise.yacht.logs.nmea import read_nmea

BEGIN: Final = datetime(2026, 7, 1, tzinfo=UTC)
SENTENCES: Final = 6
"""A second."""

_LEG_S: Final = 300


def logs(pace: Pace) -> Figures:
    """Read and fit hours of log; a quick run leaves the day out."""
    folder = Path(home()) / "logs"
    folder.mkdir(parents=True, exist_ok=True)
    figures: Figures = {}
    for hours in (1, 6) if pace.quick else (1, 6, 24):
        say(f"logs: {hours} h")
        path = folder / f"{hours}-h.nmea"
        write_log(path, hours)
        figures[f"{hours}_h"] = _measured(path, hours * 3600 * SENTENCES)
    say("logs: other readers")
    hour = folder / "1-h.nmea"
    figures["pynmea2_alone_1_h"] = _alone(hour)
    figures["hrosailing_1_h"] = attempt(lambda: _hrosailing(hour))
    for path in folder.iterdir():
        path.unlink()
    return figures


def write_log(path: Path, hours: int) -> None:
    """Write what a yacht with a known polar says at 1 Hz: legs of five minutes at all angles."""
    rng = np.random.default_rng(2026)
    seconds = np.arange(hours * 3600, dtype=np.float64)
    tws = (11.0 - 5.0 * np.cos(seconds * 2 * np.pi / 3600.0)) * MS_PER_KNOT
    angles = rng.uniform(42.0, 170.0, seconds.size // _LEG_S + 1) * rng.choice(
        (-1, 1), seconds.size // _LEG_S + 1
    )
    twa = np.repeat(angles, _LEG_S)[: seconds.size]
    stw = np.asarray(world().yacht.speed(tws, twa)) + rng.normal(0.0, 0.03, seconds.size)
    heading = (250.0 - twa) % 360.0
    apparent = vector(tws, twa) + stw
    awa, aws = angle_of(apparent) % 360.0, np.abs(apparent) / MS_PER_KNOT
    knots, wind = stw / MS_PER_KNOT, tws / MS_PER_KNOT
    with path.open("w", encoding="ascii", newline="\r\n") as file:
        for k in range(seconds.size):
            clock = (BEGIN + timedelta(seconds=k)).strftime("%H%M%S")
            day = (BEGIN + timedelta(seconds=k)).strftime("%d%m%y")
            for body in (
                f"GPRMC,{clock},A,5430.000,N,01030.000,E,{knots[k]:.1f},{heading[k]:.1f},{day},2.0,E,A",
                f"GPGLL,5430.000,N,01030.000,E,{clock},A,A",
                f"IIHDG,{heading[k]:.1f},,,2.0,E",
                f"IIVHW,,,{heading[k]:.1f},M,{knots[k]:.2f},N,,",
                f"IIMWV,{awa[k]:.1f},R,{aws[k]:.1f},N,A",
                f"IIMWV,{twa[k] % 360:.1f},T,{wind[k]:.1f},N,A",
            ):
                file.write(f"${body}*{reduce(xor, body.encode(), 0):02X}\n")


def _measured(path: Path, sentences: int) -> Figures:
    seconds = _seconds(lambda: sum(len(block) for block in read_nmea(_lines(path), Tally())))
    out = path.with_suffix(".csv")
    whole = run_process(
        [sys.executable, "-m", "seacruise", "polar", "fit", str(path), "--out", str(out), "--format", "json"]
    )
    if whole.code:
        raise RuntimeError(whole.said)
    account = json.loads(whole.output)
    return {
        "sentences": sentences,
        "megabytes": round(path.stat().st_size / 1e6, 1),
        "reading_s": round(seconds, 2),
        "reading_us_per_sentence": round(1e6 * seconds / sentences, 1),
        "polar_fit_whole_process_s": round(whole.seconds, 2),
        "polar_fit_peak_mb": whole.peak_mb,
        "steady_means": account["steady"],
        "held_back_median_error_percent": account["held_back"]["median_error_percent"],
    }


def _lines(path: Path) -> Iterator[bytes]:
    with path.open("rb") as file:
        yield from file


def _seconds(call: Callable[[], object]) -> float:
    begun = time.perf_counter()
    call()
    return time.perf_counter() - begun


def _alone(path: Path) -> Figures:
    """Parse every sentence with pynmea2 and look at none of its fields."""
    parse = import_module("pynmea2").parse
    seconds = _seconds(lambda: [parse(line.decode("ascii")) for line in _lines(path)])
    return {"seconds": round(seconds, 2), "us_per_sentence": round(1e6 * seconds / (3600 * SENTENCES), 1)}


def _hrosailing(path: Path) -> Figures:
    """Its handler of NMEA files, with the attributes that a polar needs."""
    handler = import_module("hrosailing.processing.datahandler").NMEAFileHandler(
        wanted_attributes=["BSP", "TWS", "TWA"]
    )
    seconds = _seconds(lambda: handler.handle(path))
    return {"seconds": round(seconds, 2), "us_per_sentence": round(1e6 * seconds / (3600 * SENTENCES), 1)}
