"""Polars that the tests of this room share."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import strategies as st

from seacruise.units import MS_PER_KNOT
from seacruise.yacht.polar import Polar

NAN = np.nan


def polar_kn(tws: Any, twa: Any, table: Any, name: str = "Test") -> Polar:
    """A polar from figures in knots."""
    return Polar(
        name,
        np.asarray(tws, dtype=float) * MS_PER_KNOT,
        np.asarray(twa, dtype=float),
        np.asarray(table, dtype=float) * MS_PER_KNOT,
    )


def small() -> Polar:
    """Three wind speeds, each with its own beat and run angle, as a certificate has them."""
    return polar_kn(
        (6, 10, 16),
        (40, 42, 45, 60, 90, 120, 145, 150, 165),
        (
            (NAN, NAN, 6.8),
            (NAN, 6.2, NAN),
            (4.6, NAN, NAN),
            (5.4, 7.0, 7.7),
            (5.8, 7.6, 8.6),
            (5.3, 7.4, 8.9),
            (4.0, NAN, NAN),
            (3.7, 6.0, 8.2),
            (NAN, 5.2, 7.4),
        ),
    )


@st.composite
def polars(draw: st.DrawFn) -> Polar:
    """Any table that is a polar, gaps included."""
    winds = draw(st.lists(st.integers(1, 60), min_size=2, max_size=5, unique=True).map(sorted))
    angles = draw(st.lists(st.integers(0, 360), min_size=2, max_size=8, unique=True).map(sorted))
    speed = st.one_of(st.just(NAN), st.integers(0, 2000).map(lambda n: n / 100.0))
    size = len(angles) * len(winds)
    table = np.array(draw(st.lists(speed, min_size=size, max_size=size))).reshape(len(angles), len(winds))
    empty = np.isnan(table).all(axis=0)
    table[0, empty] = 3.0
    return polar_kn(winds, np.array(angles) / 2.0, table)
