"""Measure and print one JSON object: ``python -m benchmarks [--quick] [SECTION ...]``."""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from importlib import import_module
from typing import Final

from benchmarks.measure import Figures, Pace, load, machine, say

SCHEMA: Final = "seacruise.benchmarks/1"

# Loaded when they are run: a section must not pay for the imports of the others.
SECTIONS: Final = {
    "search": ("lattices", "searches"),
    "lattice": ("lattices", "lattice_builds"),
    "plan": ("plans", "plans"),
    "accuracy": ("accuracy", "accuracy"),
    "peers": ("peers", "peers"),
    "rooms": ("rooms", "rooms"),
    "legs": ("legs", "legs"),
    "logs": ("logs", "logs"),
    "window": ("window", "window"),
    "soak": ("soak", "soak"),
}


def main(arguments: Sequence[str]) -> int:
    """Run the sections that were named, or all."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("sections", nargs="*", metavar="SECTION", help=f"of {', '.join(SECTIONS)}")
    parser.add_argument("--runs", type=int, default=7, help="timed repetitions of each figure (default: 7)")
    parser.add_argument("--quick", action="store_true", help="small cases, one repetition: for tests")
    said = parser.parse_args(arguments)
    unknown = set(said.sections) - set(SECTIONS)
    if unknown:
        parser.error(f"no section {', '.join(sorted(unknown))}; there are {', '.join(SECTIONS)}")
    if said.runs < 1:
        parser.error("--runs must be 1 or more")
    pace = Pace(1, quick=True) if said.quick else Pace(said.runs)
    begun = datetime.now(UTC)
    report: Figures = {
        "schema": SCHEMA,
        "begun": begun.isoformat(timespec="seconds"),
        "machine": machine(),
        "sections": {},
    }
    # In the order of the list: peers and window are the least important, and last.
    for name in [name for name in SECTIONS if name in said.sections or not said.sections]:
        report["sections"][name] = _measured(name, pace)
    report["seconds"] = round((datetime.now(UTC) - begun).total_seconds(), 1)
    report["machine"]["load_average_1min_at_end"] = load()
    report["missed_budgets"] = missed(report["sections"])
    print(json.dumps(report, indent=1, ensure_ascii=False))
    return int(any("failed" in section for section in report["sections"].values()))


def _measured(name: str, pace: Pace) -> Figures:
    module, function = SECTIONS[name]
    section: Callable[[Pace], Figures] = getattr(import_module(f"benchmarks.{module}"), function)
    begun = time.perf_counter()
    try:
        figures = section(pace)
    except Exception as error:  # noqa: BLE001 - minutes of other sections' results must not be lost
        say(f"{name}: failed")
        return {"failed": f"{type(error).__name__}: {error}"}
    took = time.perf_counter() - begun
    say(f"{name}: done in {took:.1f} s")
    return figures | {"section_s": round(took, 1)}


def missed(figures: Figures, where: str = "") -> list[str]:
    """Name every figure that is over its budget."""
    found = [f"{where}: {key}" for key in ("within", "within_memory") if figures.get(key) is False]
    for key, value in figures.items():
        if isinstance(value, dict):
            found += missed(value, f"{where}/{key}" if where else key)
    return found


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
