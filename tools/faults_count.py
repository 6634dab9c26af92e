"""Count the faults that the program is tried with, and how many it survives.

    python tools/faults_count.py            # prints a line a group; ends with 1 when one is not survived
    python tools/faults_count.py K H        # those groups only

A fault is a test whose name carries the letter of its group: ``test_fault[A-reset]``, ``test_I_symlink``,
``[F03 empty]``. Ports and the search have tests of their own for theirs; those are named here, by case.
"""

from __future__ import annotations

import re
import sys
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parent.parent
WEATHER = tuple(f"weather/test_{name}.py" for name in ("openmeteo", "metno", "services", "shelf", "tls"))
GROUPS = {
    "A": ("HTTP and transport", WEATHER),
    "B": ("TLS", WEATHER),
    "C": ("refusals and quotas", WEATHER),
    "D": ("JSON and its meaning", WEATHER),
    "E": ("units", WEATHER),
    "F": ("polar files", ("yacht/test_faults.py",)),
    "G": ("ports", ()),
    "H": ("dates and horizon", ("desktop/test_faults.py",)),
    "I": ("what is kept on disk", WEATHER),
    "J": ("the search", ()),
    "K": ("the window", ("desktop/test_faults.py",)),
}
_WRONG = "test_ports.py::test_what_is_wrong_with_ports_is_said_with_the_line"
NAMED = {
    "G missing": "test_ports.py::test_a_missing_file_is_told",
    "G wrong header": f"{_WRONG}[wrong header]",
    "G duplicate names": f"{_WRONG}[duplicate]",
    "G lat and lon swapped": f"{_WRONG}[swapped]",
    "G DMS text": f"{_WRONG}[DMS text]",
    "G out of range": f"{_WRONG}[out of range]",
    "G port on land": "sea/test_coast.py::test_a_place_far_inland_is_refused",
    "G port on a lake": "test_passage.py::test_a_port_on_a_lake_has_no_way_to_the_sea",
    "G non-ASCII names": "test_ports.py::test_ports_are_found_as_typed",
    "G trailing comma": "test_ports.py::test_trailing_commas_blank_lines_and_a_mark_do_no_harm",
    "G same start and end": "test_passage.py::test_the_same_port_twice",
    "G 100,000 rows": "test_ports.py::test_100000_rows_are_read_and_searched",
    "J no sea path": "test_passage.py::test_the_caspian_is_a_lake",
    "J start enclosed": "test_passage.py::test_a_port_on_a_lake_has_no_way_to_the_sea",
    "J calm everywhere": "test_passage.py::test_becalmed",
    "J wind above the polar": "yacht/test_polar.py::test_above_the_greatest_wind_it_stays",
    "J lattice too fine": "routing/test_lattice.py::test_a_lattice_too_fine_for_the_memory_is_refused",
    "J cancel at every stage": "test_passage.py::test_cancelled_at_any_stage_it_goes_no_further",
}
"""Tests of cases that do not carry the letter in their name."""

_LETTER = re.compile(r"(?:test_|\[|-)([A-K])(?:[-_](?=[a-z0-9])|\d\d )")


class Counting:
    """A plugin of pytest that counts outcomes by group."""

    def __init__(self, letters: Iterable[str]) -> None:
        self.outcomes: dict[str, Counter[str]] = {letter: Counter() for letter in letters}

    def pytest_runtest_logreport(self, report: Any) -> None:
        """Take note of one phase of one test."""
        if report.when != "call" and report.passed:
            return
        for letter in self._groups_of(report.nodeid):
            self.outcomes[letter][report.outcome] += 1

    def _groups_of(self, test: str) -> set[str]:
        found = _LETTER.search(test.rpartition("::")[2])
        letters = {found[1]} if found else set()
        for case, named in NAMED.items():
            if test == f"tests/{named}" or test.startswith(f"tests/{named}["):
                letters.add(case[0])
        return letters & set(self.outcomes)


def tests_of(letters: Iterable[str]) -> list[str]:
    """Files and single tests to run for some groups."""
    chosen = set(letters)
    files = [f"tests/{file}" for letter in chosen for file in GROUPS[letter][1]]
    single = [f"tests/{test}" for case, test in NAMED.items() if case[0] in chosen]
    return sorted(set(files) | set(single))


def main(words: list[str]) -> int:
    """Run the tests and print the counts."""
    letters = [letter for letter in GROUPS if letter in words or not words]
    counting = Counting(letters)
    asked = [str(ROOT / test) for test in tests_of(letters)]
    code = pytest.main([*asked, "-q", "-p", "no:randomly", f"--rootdir={ROOT}"], plugins=[counting])
    print()
    for letter, outcomes in counting.outcomes.items():
        skipped = f", {outcomes['skipped']} not tried here" if outcomes["skipped"] else ""
        tried = outcomes["passed"] + outcomes["failed"]
        print(f"{letter} {GROUPS[letter][0]:<24} {outcomes['passed']:>4} of {tried} survived{skipped}")
    survived = sum(outcomes["passed"] for outcomes in counting.outcomes.values())
    failed = sum(outcomes["failed"] for outcomes in counting.outcomes.values())
    print(f"  {'all':<24} {survived:>4} of {survived + failed} survived")
    return int(code)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
