"""Count the faults that the weather services are tried with, and how many the program survives.

    python tools/faults_count.py            # prints a line a group; ends with 1 when one is not survived

A fault is a test whose id carries the letter of its group: ``test_fault[A-reset]``, ``test_I_symlink``.
"""

from __future__ import annotations

import re
import sys
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parent.parent
WHERE = ("test_openmeteo.py", "test_metno.py", "test_services.py", "test_shelf.py", "test_tls.py")
GROUPS = {
    "A": "HTTP and transport",
    "B": "TLS",
    "C": "refusals and quotas",
    "D": "JSON and its meaning",
    "E": "units",
    "I": "what is kept on disk",
}
_LETTER = re.compile(r"(?:test_|\[|-)([A-K])[-_](?=[a-z0-9])")


class Counting:
    """A plugin of pytest that counts outcomes by the letter in the test's id."""

    def __init__(self) -> None:
        self.outcomes: dict[str, Counter[str]] = {letter: Counter() for letter in GROUPS}

    def pytest_runtest_logreport(self, report: Any) -> None:
        """Take note of one phase of one test."""
        found = _LETTER.search(report.nodeid.rpartition("::")[2])
        if found and found[1] in self.outcomes and (report.when == "call" or not report.passed):
            self.outcomes[found[1]][report.outcome] += 1


def main() -> int:
    """Run the tests and print the counts."""
    counting = Counting()
    arguments = [*(str(ROOT / "tests" / "weather" / name) for name in WHERE), "-q", "-p", "no:randomly"]
    code = pytest.main([*arguments, f"--rootdir={ROOT}"], plugins=[counting])
    print()
    for letter, outcomes in counting.outcomes.items():
        skipped = f", {outcomes['skipped']} not tried here" if outcomes["skipped"] else ""
        tried = outcomes["passed"] + outcomes["failed"]
        print(f"{letter} {GROUPS[letter]:<24} {outcomes['passed']:>4} of {tried} survived{skipped}")
    survived = sum(outcomes["passed"] for outcomes in counting.outcomes.values())
    failed = sum(outcomes["failed"] for outcomes in counting.outcomes.values())
    print(f"  {'all':<24} {survived:>4} of {survived + failed} survived")
    return int(code)


if __name__ == "__main__":
    sys.exit(main())
