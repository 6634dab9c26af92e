"""The window, drawn in memory: its first frame in a cold process, frames of a busy chart, drags followed."""

from __future__ import annotations

import json
import os
import statistics
import sys
from pathlib import Path
from typing import Final

from benchmarks.measure import Figures, Pace, run_process, say, within
from benchmarks.world import home

BUDGET_S: Final = 0.6
FRAME_MEDIAN_MS: Final = 16.0
FRAME_WORST_MS: Final = 40.0
DRAG_MS: Final = 50.0


def window(pace: Pace) -> Figures:
    """Start the program's window in processes of their own and take the time of the first frame."""
    runs = 1 if pace.quick else 5
    screen = os.environ.get("QT_QPA_PLATFORM", "offscreen")
    environment = {
        "SEACRUISE_HOME": home(),
        "QT_QPA_PLATFORM": screen,
        # As installed: compiled once, not by each process anew.
        "PYTHONDONTWRITEBYTECODE": "",
        "PYTHONPYCACHEPREFIX": str(Path(home()) / "bytecode"),
    }
    seconds: list[float] = []
    peaks: list[float | None] = []
    frames: list[dict[str, float]] = []
    for run in range(runs + 1):
        say(f"window: {run or 'warm-up'}")
        sailed = run_process((sys.executable, "-m", "benchmarks.first_frame"), environment=environment)
        if sailed.code:
            last = (sailed.said.strip() or f"exit code {sailed.code}").splitlines()[-1]
            return {"outcome": f"The window did not open: {last}"}
        if run:
            frames.append(json.loads(sailed.output))
            seconds.append(frames[-1]["painted"] - sailed.begun)
            peaks.append(sailed.peak_mb)
    figures: Figures = {
        "outcome": "opened",
        "platform": screen,
        "first_frame_median_s": round(statistics.median(seconds), 3),
        "first_frame_min_s": round(min(seconds), 3),
        "peak_mb": max((round(peak, 1) for peak in peaks if peak is not None), default=None),
        "runs": runs,
        "cpu_min_s": round(min(frame["cpu_s"] for frame in frames), 3),
    }
    for name in ("rss_mb", "own_mb"):
        if name in frames[-1]:
            figures[name] = max(frame[name] for frame in frames)
    figures |= within(figures, "first_frame_median_s", BUDGET_S)
    say("window: frames of the chart")
    figures["chart_1920x1080"] = chart(environment, 20 if pace.quick else 120)
    say("window: passages that follow a hand")
    return figures | {"drag": drags(environment, 10 if pace.quick else 120)}


def chart(environment: dict[str, str], frames: int) -> Figures:
    """Pan, zoom and play the chart in a process of its own."""
    figures = _of_process("frames", frames, environment)
    if "all" not in figures:
        return figures
    frame = figures["all"]
    figures["all"] = frame | within(frame, "median_ms", FRAME_MEDIAN_MS)
    figures["worst"] = {"worst_ms": frame["worst_ms"]} | within(frame, "worst_ms", FRAME_WORST_MS)
    return figures


def drags(environment: dict[str, str], moves: int) -> Figures:
    """Drag departure, start and a place on the way, in a process of its own."""
    figures = _of_process("drag", moves, environment)
    for passage in figures.values():
        if isinstance(passage, dict):
            for case in passage.values():
                if "median_ms" in case:
                    case.update(within(case, "median_ms", DRAG_MS))
    return figures


def _of_process(module: str, times: int, environment: dict[str, str]) -> Figures:
    sailed = run_process((sys.executable, "-m", f"benchmarks.{module}", str(times)), environment=environment)
    if sailed.code:
        last = (sailed.said.strip() or f"exit code {sailed.code}").splitlines()[-1]
        return {"outcome": f"It did not get there: {last}"}
    figures: Figures = json.loads(sailed.output)
    return figures
