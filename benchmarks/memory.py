"""Memory of this process: what is resident, whose it is, and the most it has been."""

from __future__ import annotations

import os
import sys
from collections import Counter
from pathlib import Path
from typing import Final

from benchmarks.measure import Figures

_STATM: Final = Path("/proc/self/statm")
_SMAPS: Final = Path("/proc/self/smaps")
_OWNERS: Final = (
    ("libllvmlite", "compiler"),
    ("PySide6", "qt"),
    ("shiboken6", "qt"),
    (".npy", "sea"),
)
"""Which part of a path tells whose file it is; all others are libraries of Python's and the system's."""


def rss_mb() -> float:
    """Resident memory of this process [MB of 10^6 bytes]; its greatest where the system tells no more."""
    return _pages(1) if _STATM.exists() else peak_mb()


def own_mb() -> float | None:
    """Tell what of it is no file that lies in memory and could be read again [MB]; ``None`` where unknown."""
    return round(_pages(1) - _pages(2), 1) if _STATM.exists() else None


def _pages(field: int) -> float:
    return int(_STATM.read_text(encoding="ascii").split()[field]) * os.sysconf("SC_PAGE_SIZE") / 1e6


def peak_mb() -> float:
    """Greatest resident memory since `forget_peak`, or of the whole process [MB]."""
    status = Path("/proc/self/status")
    if status.exists():
        for line in status.read_text(encoding="ascii", errors="replace").splitlines():
            if line.startswith("VmHWM:"):
                return int(line.split()[1]) * 1024 / 1e6
    if sys.platform == "win32":
        raise SystemExit("The memory of a process is measured on Linux and macOS only.")
    import resource

    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak / 1e6 if sys.platform == "darwin" else peak / 1e3


def forget_peak() -> None:
    """Begin anew with the greatest memory, where the system can."""
    switch = Path("/proc/self/clear_refs")
    try:
        switch.write_text("5", encoding="ascii")
    except OSError:
        return


def parts() -> Figures:
    """Tell whose the resident memory is [MB]: files by owner, and ``own`` for what is no file."""
    if not _SMAPS.exists():
        return {}
    held: Counter[str] = Counter()
    owner = ""
    for line in _SMAPS.read_text(encoding="utf-8", errors="replace").splitlines():
        name, _, value = line.partition(":")
        if name in {"Rss", "Anonymous"}:
            size = int(value.split()[0])
            held[owner] += size if name == "Rss" else -size
            held["own"] += 0 if name == "Rss" else size
        elif "-" in name and " " in name:
            path = line.split(maxsplit=5)[5] if line.count(" ") > 5 and "/" in line else ""
            owner = next((whose for part, whose in _OWNERS if part in path), "libraries")
    return {f"{name}_mb": round(size * 1024 / 1e6, 1) for name, size in sorted(held.items())}
