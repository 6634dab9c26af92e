"""Passages with a known answer: found, sailed again, held against closed forms. See docs/accuracy.md."""

from __future__ import annotations

import pytest

from seacruise.routing.manoeuvres import sail_boards
from seacruise.routing.resail import resail
from tests.routing.analytic import PASSAGES
from tests.routing.worlds import T0, fastest, open_sea, question


@pytest.mark.parametrize("name", PASSAGES)
def test_time_shown_is_the_known_one(name: str) -> None:
    case = PASSAGES[name]()
    asked = question(open_sea(), case.wind, case.yacht, case.start, case.end, current=case.current)
    line = fastest(asked).line
    sailed = resail(asked, sail_boards(asked, line), fuel_rate_l_h=0.0)
    assert sailed.arrived
    shown = float(sailed.time[-1]) - T0
    assert shown == pytest.approx(case.exact_s, rel=case.held)
    # The search looks the wind up in pieces and slices; it must not promise what is not sailed.
    assert line.seconds == pytest.approx(shown, rel=5e-3)
