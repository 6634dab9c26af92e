"""Print the table of docs/accuracy.md: passages with a known answer, and how near we come.

Run it in the checkout with ``python -m tools.accuracy``; the winds, the yachts and the formulas are those of
the tests (``tests/routing/analytic.py``).
"""

from __future__ import annotations

from dataclasses import replace

from seacruise.routing.manoeuvres import sail_boards
from seacruise.routing.resail import resail
from seacruise.units import SECONDS_PER_HOUR
from tests.routing.analytic import PASSAGES
from tests.routing.worlds import PRECISE, T0, fastest, open_sea, question


def main() -> None:
    """Sail every analytic passage and print its row."""
    print("| passage | closed form | exact h | shown h | shown | estimated by the search | lattice alone |")
    print("|---|---|---|---|---|---|---|")
    sea = open_sea()
    for name, make in PASSAGES.items():
        case = make()
        asked = question(sea, case.wind, case.yacht, case.start, case.end, current=case.current)
        line = fastest(asked).line
        shown = float(resail(asked, sail_boards(asked, line), fuel_rate_l_h=0.0).time[-1]) - T0
        coarse = fastest(replace(asked, how=replace(PRECISE, refine=False))).line.seconds
        errors = (f"{100 * (s / case.exact_s - 1):+.3f} %" for s in (shown, line.seconds, coarse))
        hours = (f"{s / SECONDS_PER_HOUR:.4f}" for s in (case.exact_s, shown))
        print(f"| {' | '.join([name, case.formula, *hours, *errors])} |")


if __name__ == "__main__":
    main()
