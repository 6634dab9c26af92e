"""Planning: the whole process, and the computation inside it."""

from __future__ import annotations

import statistics
import sys
import tempfile
from collections.abc import Sequence
from typing import Final

from benchmarks.measure import Figures, Pace, Sailed, in_ms, run_process, say, within
from benchmarks.world import DEPARTURE, PASSAGES, YACHT, home, world
from seacruise.passage import plan

PROCESS_BUDGET_S: Final = 1.5
PROCESS_BUDGET_MB: Final = 350.0
COMPUTE_BUDGET_MS: Final = 100.0

STAGES: Final = ("sea", "lattice", "wind", "search", "refine", "check")

_SEACRUISE: Final = (sys.executable, "-m", "seacruise")
_PLAN: Final = (
    *_SEACRUISE,
    *("plan", "--from", "Gdynia", "--to", "Stockholm", "--depart", DEPARTURE.strftime("%Y-%m-%dT%H:%MZ")),
    *("--yacht", YACHT, "--forecast", "sample", "--preset", "precise", "--format", "json"),
)


def plans(pace: Pace) -> Figures:
    """Wall time and peak memory of whole processes, and seconds of each stage within one."""
    runs = 1 if pace.quick else 5
    return {
        "whole_process_gdynia_stockholm": _processes(runs),
        "in_process_warm": _in_process(1 if pace.quick else pace.runs, PASSAGES[: 1 if pace.quick else None]),
    }


def _processes(runs: int) -> Figures:
    say("plan: whole process")
    warm = {"SEACRUISE_HOME": home()}
    _sound(run_process(_PLAN, environment=warm))
    caches_warm = _summary([_sound(run_process(_PLAN, environment=warm)) for _ in range(runs)])
    caches_warm |= within(caches_warm, "median_s", PROCESS_BUDGET_S)
    if caches_warm["peak_mb"] is not None:
        caches_warm |= {
            "budget_mb": PROCESS_BUDGET_MB,
            "within_memory": caches_warm["peak_mb"] <= PROCESS_BUDGET_MB,
        }
    say("plan: with nothing cached")
    fresh = _summary([_fresh() for _ in range(min(runs, 3))])
    figures: Figures = {
        "caches_warm": caches_warm,
        "fresh_home": fresh,
        "help": _summary([_sound(run_process((*_SEACRUISE, "--help"))) for _ in range(runs)]),
    }
    if runs > 1:
        say("plan: compiling the kernels, once")
        with tempfile.TemporaryDirectory() as folder:
            once = _sound(run_process(_PLAN, environment={**warm, "NUMBA_CACHE_DIR": folder}))
        figures["kernels_not_compiled"] = _summary([once])
    return figures


def _fresh() -> Sailed:
    with tempfile.TemporaryDirectory() as folder:
        return _sound(run_process(_PLAN, environment={"SEACRUISE_HOME": folder}))


def _sound(sailed: Sailed) -> Sailed:
    """Refuse to measure a program that failed."""
    if sailed.code:
        raise RuntimeError(f"The program ended with exit code {sailed.code}: {sailed.said.strip()}")
    return sailed


def _summary(runs: Sequence[Sailed]) -> Figures:
    peaks = [one.peak_mb for one in runs if one.peak_mb is not None]
    return {
        "median_s": round(statistics.median(one.seconds for one in runs), 3),
        "min_s": round(min(one.seconds for one in runs), 3),
        "peak_mb": round(max(peaks), 1) if peaks else None,
        "runs": len(runs),
    }


def _in_process(runs: int, passages: Sequence[tuple[str, str]]) -> Figures:
    """`seacruise.plan`, lattices kept from the call before: the ports to the finished `Passage`."""
    at = world()
    figures: Figures = {}
    for start, end in passages:
        say(f"plan: {start} - {end}")
        request = at.request(start, end)
        plan(request, settings=at.settings)
        found = [plan(request, settings=at.settings) for _ in range(runs)]
        totals = [sum(passage.search.seconds.values()) for passage in found]
        figures[f"{start} - {end}"] = in_ms(totals, budget_ms=COMPUTE_BUDGET_MS) | {
            "stages_median_ms": {
                stage: round(statistics.median(p.search.seconds[stage] for p in found) * 1e3, 2)
                for stage in STAGES
            },
            "duration_h": round(found[-1].duration_h, 4),
            "lower_bound_h": round(found[-1].lower_bound_h, 4),
            "land_free": found[-1].checks.land_free,
            "vertices": found[-1].search.vertices,
        }
    return figures
