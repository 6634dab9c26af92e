"""Put results into docs/benchmarks.md: ``python -m benchmarks.tables results.json``.

Only what stands between the two marks is replaced; the words around it are written by hand. A file with
some of the sections renews these, and says so in each.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, Final

from benchmarks.measure import ROOT, Figures

DOCUMENT: Final = ROOT / "docs" / "benchmarks.md"
BEGIN: Final = "<!-- results: written by python -m benchmarks.tables -->"
END: Final = "<!-- end of results -->"


def table(head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """Lay out a Markdown table."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(str(cell) for cell in line)} |" for line in lines)


def render(report: Figures) -> str:
    """All sections of a report that there are, as Markdown."""
    parts = [_machine(report)]
    for name, part in PARTS.items():
        section = report["sections"].get(name)
        if section is not None:
            parts.append(f"{name} failed: {section['failed']}" if "failed" in section else part(section))
    return "\n\n".join(parts)


def renew(results: str, report: Figures) -> str:
    """Put the sections of a report in the place of those of earlier results; the others stay."""
    if set(report["sections"]) >= set(PARTS):
        return render(report)
    blocks = [block.strip() for block in re.split(r"(?m)^(?=### )", results)]
    titles = [block.partition("\n")[0] for block in blocks]
    for part in re.split(r"(?m)^(?=### )", render(report))[1:]:
        title, _, body = part.strip().partition("\n")
        renewed = f"{title}\n\nMeasured on its own, {report['begun']}.\n{body}"
        if title in titles:
            blocks[titles.index(title)] = renewed
        else:
            blocks.append(renewed)
    return "\n\n".join(blocks)


def _machine(report: Figures) -> str:
    about = report["machine"]
    packages = ", ".join(f"{name} {version}" for name, version in about["packages"].items())
    return (
        f"Measured {report['begun']} in {report['seconds']:.0f} s on {about['processor']}, "
        f"{about['cores']} cores, {about['memory_gb']} GB, {about['system']}, Python {about['python']}, "
        f"{packages}. Load average {about['load_average_1min']} before and "
        f"{about['load_average_1min_at_end']} after; the benchmarks "
        "alone make 1.0, and what is above the number of cores makes figures worse."
    )


def _kept(case: Figures) -> str:
    if "within" not in case:
        return ""
    unit = next(key.removeprefix("budget_") for key in case if key.startswith("budget_"))
    return f"{case[f'budget_{unit}']:g} {'%' if unit == 'percent' else unit}: {_yes(case['within'])}"


def _yes(kept: bool) -> str:
    return "kept" if kept else "**missed**"


def _words(name: str) -> str:
    return name.replace("_", " ")


def _search(section: Figures) -> str:
    head = ("search", "vertices", "edges", "settled", "median ms", "min ms", "ns per edge sailed", "budget")
    rows = [
        (f"{_words(name)}, {_words(kind)}", *_row(case[kind]), _kept(case[kind]))
        for name, case in section["cases"].items()
        for kind in ("goal_directed", "whole_area")
        if kind in case
    ]
    grown = []
    for series in ("growth_with_vertices_12_courses", "growth_with_courses_2_nm"):
        grown += [(f"{g['courses']} courses, {g['spacing_nm']:g} nm", *_row(g)) for g in section[series]]
    cases, growth = table(head, rows), table(head[:-1], grown)
    return f"### Search\n\n{section['about']}\n\n{cases}\n\nGrowth, whole area:\n\n{growth}"


def _row(case: Figures) -> tuple[object, ...]:
    counts = tuple(f"{case[key]:,}" for key in ("vertices", "edges", "settled"))
    return (*counts, f"{case['median_ms']:.2f}", f"{case['min_ms']:.2f}", f"{case['ns_per_relaxation']:.0f}")


def _lattice(section: Figures) -> str:
    head = ("lattice", "vertices", "edges", "median s", "min s", "ns per edge", "budget")
    rows = [
        (
            _words(name),
            f"{case['vertices']:,}",
            f"{case['edges']:,}",
            f"{case['median_s']:.3f}",
            f"{case['min_s']:.3f}",
            f"{case['ns_per_edge']:.0f}",
            _kept(case),
        )
        for name, case in section.items()
        if isinstance(case, dict)
    ]
    return f"### Lattice, land-checked\n\n{table(head, rows)}"


def _plan(section: Figures) -> str:
    head = ("whole process", "median s", "min s", "peak MB", "runs", "budget")
    rows = []
    for name, case in section["whole_process_gdynia_stockholm"].items():
        memory = f", {case['budget_mb']:g} MB: {_yes(case['within_memory'])}" if "budget_mb" in case else ""
        rows.append(
            (
                _words(name),
                case["median_s"],
                case["min_s"],
                case["peak_mb"],
                case["runs"],
                _kept(case) + memory,
            )
        )
    passages = section["in_process_warm"]
    stages = list(next(iter(passages.values()))["stages_median_ms"])
    inside = [
        (
            name,
            f"{case['median_ms']:.0f}",
            f"{case['min_ms']:.0f}",
            *(f"{case['stages_median_ms'][stage]:.1f}" for stage in stages),
            case["duration_h"],
            _kept(case),
        )
        for name, case in passages.items()
    ]
    return (
        f"### Plan, Gdynia - Stockholm, precise\n\n{table(head, rows)}\n\n"
        "Inside the process, everything warm [ms]:\n\n"
        + table(("passage", "median", "min", *stages, "passage takes h", "budget"), inside)
    )


def _accuracy(section: Figures) -> str:
    keys = (
        "found_h",
        "optimum_h",
        "gap_percent",
        "line_h",
        "optimum_line_h",
        "line_gap_percent",
        "land_free",
        "classic_h",
    )
    rows = [(name, *(case[key] for key in keys)) for name, case in section["passages"].items()]
    worst = (
        f"Worst gap {section['shown']['worst_gap_percent']} %, budget {_kept(section['shown'])}; "
        f"of the lines {section['lines']['worst_gap_percent']} %, budget {_kept(section['lines'])}. "
        f"Slower than classic: {', '.join(section['slower_than_classic']) or 'none'}."
    )
    head = ("passage", *(_words(key) for key in keys))
    return f"### Accuracy\n\n{section['about']}\n\n{table(head, rows)}\n\n{worst}"


def _peers(section: Figures) -> str:
    head = ("passage", "program", "sailed h", "gap %", "short of port nm", "claimed h", "computing", "ratio")
    rows: list[tuple[object, ...]] = []
    for name, case in section["routes"].items():
        ours = case["seacruise"]
        times = f"{ours['computing_lattice_built']['median_ms'] / 1e3:.2f} s"
        kept = f"{ours['computing_lattice_kept']['median_ms'] / 1e3:.2f} s with the lattice kept"
        rows.append(
            (
                _words(name),
                "SeaCruise",
                ours["sailed_h"],
                ours["gap_percent"],
                0,
                ours["shown_h"],
                f"{times} ({kept})",
                1,
            )
        )
        for program, theirs in case.items():
            if isinstance(theirs, dict) and program != "seacruise":
                rows.append((_words(name), _words(program), *_peer(theirs)))
    text = f"### Other programs\n\n{section['about']}\n\n{table(head, rows)}"
    return text + "\n\n" + _hrosailing(section["hrosailing"])


def _peer(theirs: Figures) -> tuple[object, ...]:
    if theirs["outcome"] != "sailed":
        return (theirs["outcome"], "", "", "", "", "")
    return (
        theirs["sailed_h"],
        theirs["gap_percent"],
        theirs["ends_short_of_the_port_nm"],
        theirs["claimed_h"],
        f"{theirs['computing_s']:.1f} s",
        theirs["ratio_of_computing"],
    )


def _hrosailing(section: Figures) -> str:
    title = "#### hrosailing, which has no router\n\n"
    if "outcome" in section:
        return title + str(section["outcome"])
    rows = []
    for name, case in section["cost_cruise_straight_leg"].items():
        rows.append((f"cost_cruise {_words(name)}", _facts(case)))
    rows += [(name, _facts(section[name])) for name in section if name != "cost_cruise_straight_leg"]
    return title + table(("function", "figures"), rows)


def _facts(case: Figures) -> str:
    """Write figures in a row; of times the median is enough."""

    def shown(value: Any) -> Any:
        return f"{value['median_ms']} ms" if isinstance(value, dict) and "median_ms" in value else value

    return "; ".join(f"{_words(key)} {shown(value)}" for key, value in case.items())


def _rooms(section: Figures) -> str:
    rows = [
        (_words(name), case["median_ms"], case["min_ms"])
        for name, case in section.items()
        if isinstance(case, dict) and "median_ms" in case
    ]
    text = f"### Wind, polar, files\n\n{table(('call', 'median ms', 'min ms'), rows)}"
    return text + _beside(section.get("beside_hrosailing", {}))


def _beside(section: Figures) -> str:
    if section.get("outcome") != "compared":
        return ""
    cases = [(_words(name), _facts(section[name])) for name in ("evaluation", "hull_directions")]
    return "\n\nThe same table in hrosailing:\n\n" + table(("what", "figures"), cases)


def _legs(section: Figures) -> str:
    ours = [(_words(name), case["median_ms"], case["min_ms"]) for name, case in section["ours"].items()]
    text = f"### Legs\n\n{section['about']}\n\n{table(('call', 'median ms', 'min ms'), ours)}"
    if "outcome" in section["hrosailing"]:
        text += f"\n\nhrosailing: {section['hrosailing']['outcome']}"
    else:
        rows = [
            (_words(course), _words(name), *(case[key] for key in _BESIDE))
            for course, cases in section["hrosailing"].items()
            for name, case in cases.items()
        ]
        text += "\n\n" + table(("leg", "figure", *map(_words, _BESIDE)), rows)
    rows = [
        (_words(name), _facts(case)) for name, case in section["geographiclib"].items() if name != "outcome"
    ]
    return text + "\n\n" + table(("course for 6 h", "against the ellipsoid"), rows)


_BESIDE: Final = ("hrosailing", "ours", "difference_percent", "ratio")


def _logs(section: Figures) -> str:
    rows = [(_words(name), _facts(case)) for name, case in section.items() if isinstance(case, dict)]
    return "### Logs\n\n" + table(("log at 1 Hz", "figures"), rows)


def _window(section: Figures) -> str:
    if section["outcome"] != "opened":
        return f"### Window\n\n{section['outcome']}"
    return (
        f"### Window\n\nFirst frame of a cold process ({section['platform']}): median "
        f"{section['first_frame_median_s']} s, least {section['first_frame_min_s']} s of {section['runs']}, "
        f"peak {section['peak_mb']} MB; budget {_kept(section)}."
        + (_at_first_frame(section) + _chart(section) + _drag(section))
    )


def _at_first_frame(section: Figures) -> str:
    told = {
        "cpu_min_s": "{} s of the processor at least",
        "rss_mb": "{} MB resident",
        "own_mb": "{} MB of them its own",
    }
    figures = ", ".join(text.format(section[name]) for name, text in told.items() if name in section)
    return f" Until then: {figures}." if figures else ""


def _chart(section: Figures) -> str:
    rows = [
        (_words(name), _facts(case))
        for name, case in section.get("chart_1920x1080", {}).items()
        if isinstance(case, dict) and "p95_ms" in case
    ]
    return "\n\n" + table(("frames of the chart, 1920x1080", "figures"), rows) if rows else ""


def _drag(section: Figures) -> str:
    rows = [
        (passage, _words(what), _facts(case))
        for passage, cases in section.get("drag", {}).items()
        if isinstance(cases, dict)
        for what, case in cases.items()
    ]
    return "\n\n" + table(("passage", "dragged", "from move to route painted"), rows) if rows else ""


def _soak(section: Figures) -> str:
    if "outcome" in section:
        return f"### Long use\n\n{section['outcome']}"
    told = {key: value for key, value in section.items() if not isinstance(value, (dict, list))}
    most, worst = section["at_rest"], section["worst"]
    return (
        f"### Long use\n\nResident memory at rest at most {most['rss_mb']} MB, budget {_kept(most)}; while "
        f"it computed {section['peak_mb']} MB; at rest at the end: {_facts(section['parts'])}; the window "
        f"was held up for {worst['blocked_ms']} ms of its own time at most (while: {worst['while']}), budget "
        f"{_kept(worst)}; {_facts(told)}."
    )


PARTS: Final = {
    "search": _search,
    "lattice": _lattice,
    "plan": _plan,
    "accuracy": _accuracy,
    "peers": _peers,
    "rooms": _rooms,
    "legs": _legs,
    "logs": _logs,
    "window": _window,
    "soak": _soak,
}


def main(arguments: Sequence[str]) -> int:
    """Replace the results in the document by those of a file."""
    if len(arguments) != 1:
        print("usage: python -m benchmarks.tables RESULTS.json", file=sys.stderr)
        return 2
    report = json.loads(Path(arguments[0]).read_text(encoding="utf-8"))
    text = DOCUMENT.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    results, after = rest.split(END)
    DOCUMENT.write_text(
        f"{before}{BEGIN}\n\n{renew(results.strip(), report)}\n\n{END}{after}", encoding="utf-8"
    )
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
