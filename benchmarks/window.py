"""The window, drawn in memory: its first frame in a cold process, frames of a busy chart, a drag followed."""

from __future__ import annotations

import json
import os
import statistics
import sys
from typing import Final

from benchmarks.measure import Figures, Pace, run_process, say, within
from benchmarks.world import home

BUDGET_S: Final = 0.6
FRAME_MEDIAN_MS: Final = 16.0
FRAME_WORST_MS: Final = 40.0


def window(pace: Pace) -> Figures:
    """Start the program's window in processes of their own and take the time of the first frame."""
    runs = 1 if pace.quick else 5
    screen = os.environ.get("QT_QPA_PLATFORM", "offscreen")
    environment = {
        "SEACRUISE_HOME": home(),
        "QT_QPA_PLATFORM": screen,
    }
    seconds, peaks = [], []
    for run in range(runs + 1):
        say(f"window: {run or 'warm-up'}")
        sailed = run_process((sys.executable, "-m", "benchmarks.first_frame"), environment=environment)
        if sailed.code:
            last = (sailed.said.strip() or f"exit code {sailed.code}").splitlines()[-1]
            return {"outcome": f"The window did not open: {last}"}
        if run:
            seconds.append(float(sailed.output) - sailed.begun)
            peaks.append(sailed.peak_mb)
    figures: Figures = {
        "outcome": "opened",
        "platform": screen,
        "first_frame_median_s": round(statistics.median(seconds), 3),
        "first_frame_min_s": round(min(seconds), 3),
        "peak_mb": max((round(peak, 1) for peak in peaks if peak is not None), default=None),
        "runs": runs,
    }
    figures |= within(figures, "first_frame_median_s", BUDGET_S)
    say("window: frames of the chart")
    return figures | {"chart_1920x1080": chart(environment, 20 if pace.quick else 120)}


def chart(environment: dict[str, str], frames: int) -> Figures:
    """Pan, zoom and play the chart in a process of its own, then drag the departure."""
    sailed = run_process((sys.executable, "-m", "benchmarks.frames", str(frames)), environment=environment)
    if sailed.code:
        last = (sailed.said.strip() or f"exit code {sailed.code}").splitlines()[-1]
        return {"outcome": f"The chart was not drawn: {last}"}
    figures: Figures = json.loads(sailed.output)
    frame = figures["all"]
    figures["all"] = frame | within(frame, "median_ms", FRAME_MEDIAN_MS)
    figures["worst"] = {"worst_ms": frame["worst_ms"]} | within(frame, "worst_ms", FRAME_WORST_MS)
    return figures
