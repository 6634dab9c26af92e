"""Units: by definition."""

from __future__ import annotations

import pytest

from seacruise.units import METRES_PER_NM, MS_PER_KNOT, SECONDS_PER_HOUR


def test_a_knot_is_a_nautical_mile_an_hour() -> None:
    assert METRES_PER_NM == 1852.0
    assert SECONDS_PER_HOUR == 3600.0
    assert pytest.approx(METRES_PER_NM, rel=1e-15) == MS_PER_KNOT * SECONDS_PER_HOUR
    # The other way round, as most tables have it.
    assert pytest.approx(1.943_844_492, rel=1e-9) == 1.0 / MS_PER_KNOT
