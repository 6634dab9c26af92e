"""Conversions between SI, used inside, and what sailors read: knots, nautical miles, hours."""

from __future__ import annotations

from typing import Final

METRES_PER_NM: Final = 1852.0
"""International nautical mile, by definition [m]."""

MS_PER_KNOT: Final = METRES_PER_NM / 3600.0
"""One knot [m/s]."""

SECONDS_PER_HOUR: Final = 3600.0
