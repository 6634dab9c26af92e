"""Stop-watch, memory of whole processes, and the machine they ran on."""

from __future__ import annotations

import json
import os
import platform
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any, Final

ROOT: Final = Path(__file__).resolve().parent.parent

_CHILD: Final = Path(__file__).with_name("child.py")
_PACKAGES: Final = ("numpy", "numba", "shapely", "PySide6_Essentials", "weatherrouting", "hrosailing")

HOW_TO_INSTALL: Final = "Not installed; the extra `bench` has it, and `make bench` installs it."

Figures = dict[str, Any]


@dataclass(frozen=True, slots=True)
class Pace:
    """How long to measure.

    Attributes
    ----------
    runs
        Timed repetitions of each figure, after one that is not counted.
    quick
        Leave the large cases out: for the tests, not for figures worth keeping.
    """

    runs: int = 7
    quick: bool = False


def say(text: str) -> None:
    """Tell the progress, on standard error."""
    print(text, file=sys.stderr, flush=True)


def stopwatch(call: Callable[[], object], *, runs: int) -> list[float]:
    """Seconds of ``runs`` calls, after one that is not counted: it compiles and fills caches."""
    call()
    seconds = []
    for _ in range(runs):
        begun = time.perf_counter()
        call()
        seconds.append(time.perf_counter() - begun)
    return seconds


def in_ms(seconds: Sequence[float], *, budget_ms: float | None = None) -> Figures:
    """Median and least of some times [ms], held against a budget where there is one."""
    figures: Figures = {
        "median_ms": round(statistics.median(seconds) * 1e3, 4),
        "min_ms": round(min(seconds) * 1e3, 4),
        "runs": len(seconds),
    }
    return figures if budget_ms is None else figures | within(figures, "median_ms", budget_ms)


def within(figures: Figures, key: str, budget: float) -> Figures:
    """Budget of a figure, and whether it is kept; the unit is that of the figure's own key."""
    return {f"budget_{key.rsplit('_', 1)[-1]}": budget, "within": bool(figures[key] <= budget)}


@dataclass(frozen=True, slots=True)
class Sailed:
    """A process that was run to its end.

    Attributes
    ----------
    seconds
        Wall time from its start to its end [s].
    begun
        When it was started, seconds since 1970.
    peak_mb
        Largest resident memory of that process alone [MB of 10^6 bytes]; ``None`` where the system does
        not tell it.
    """

    seconds: float
    begun: float
    peak_mb: float | None
    code: int
    output: str
    said: str


def attempt(call: Callable[[], Figures]) -> Figures:
    """Call another program; whatever it raises is its result, in plain words."""
    begun = time.perf_counter()
    try:
        return call()
    except ModuleNotFoundError as error:
        return {"outcome": f"{HOW_TO_INSTALL} ({error})"}
    except Exception as error:  # noqa: BLE001 - other people's programs raise what they like
        return {
            "outcome": f"It raised {type(error).__name__}: {error}",
            "computing_s": round(time.perf_counter() - begun, 3),
        }


def run_process(command: Sequence[str], *, environment: Mapping[str, str] | None = None) -> Sailed:
    """Run a command and measure the whole of it.

    A small process stands between: Linux counts the memory of whoever starts a process as that process's
    own peak, and this one is large.
    """
    answer = subprocess.run(
        [sys.executable, "-E", "-S", str(_CHILD), *command],
        capture_output=True,
        check=True,
        text=True,
        encoding="utf-8",
        cwd=ROOT,
        env={**os.environ, **(environment or {})},
    )
    return Sailed(**json.loads(answer.stdout))


def machine() -> Figures:
    """Describe the computer and the versions that a result depends on."""
    versions = {}
    for name in _PACKAGES:
        try:
            versions[name] = version(name)
        except PackageNotFoundError:
            versions[name] = "not installed"
    return {
        "system": platform.platform(),
        "processor": _processor(),
        "cores": os.cpu_count(),
        "memory_gb": _memory_gb(),
        "python": platform.python_version(),
        "packages": versions,
        "load_average_1min": load(),
    }


def load() -> float | None:
    """Give the processes that wanted to run in the last minute: more than cores make figures worse."""
    return round(os.getloadavg()[0], 2) if hasattr(os, "getloadavg") else None


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    if info.exists():
        for line in info.read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()


def _memory_gb() -> float | None:
    if not hasattr(os, "sysconf"):
        return None
    return round(os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / 1e9, 1)
