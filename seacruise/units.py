"""Conversions between SI, used inside, and what sailors read: knots, nautical miles, hours."""

from __future__ import annotations

from bisect import bisect_right
from typing import Final

METRES_PER_NM: Final = 1852.0
"""International nautical mile, by definition [m]."""

MS_PER_KNOT: Final = METRES_PER_NM / 3600.0
"""One knot [m/s]."""

SECONDS_PER_HOUR: Final = 3600.0

BEAUFORT_KN: Final = (1, 4, 7, 11, 17, 22, 28, 34, 41, 48, 56, 64)
"""First whole knot of forces 1 to 12 (WMO-No. 306, code table 1100)."""


def beaufort(speed_kn: float) -> int:
    """Force of a wind [Beaufort, 0 to 12], of its speed in whole knots."""
    return bisect_right(BEAUFORT_KN, round(speed_kn))
