"""Stencils: the set of edges that leave each vertex of a triangular lattice.

Positions on the lattice are axial: ``(i, j)`` lies at ``x = i + j / 2``, ``y = j * sqrt(3) / 2`` sides of
a triangle. Ring K holds the 6 K positions that are K steps away; of those, the ones with coprime
coordinates open a course that no nearer ring has: 6 phi(K) of them.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import NDArray

COURSES: Final = (6, 12, 24, 36, 60, 72, 108, 132)
"""Number of courses with 1 to 8 rings."""

ROW_HEIGHT: Final = math.sqrt(3.0) / 2.0


@lru_cache(maxsize=16)
def triangular(courses: int) -> NDArray[np.int64]:
    """Axial offsets ``(courses, 2)`` of the stencil with that many courses, sorted by course.

    Raises
    ------
    ValueError
        For a number that no whole set of rings has.
    """
    if courses not in COURSES:
        raise ValueError(f"a triangular lattice has {COURSES} courses, not {courses}")
    rings = COURSES.index(courses) + 1
    steps = range(-rings, rings + 1)
    kept = [
        (i, j)
        for i in steps
        for j in steps
        if math.gcd(i, j) == 1 and max(abs(i), abs(j), abs(i + j)) <= rings
    ]
    return _by_course(np.array(kept))


def second_ring() -> NDArray[np.int64]:
    """R1's 12 neighbours, "jump by 2": 6 at two sides of the triangle and 6 at sqrt(3)."""
    steps = range(-2, 3)
    return _by_course(
        np.array([(i, j) for i in steps for j in steps if max(abs(i), abs(j), abs(i + j)) == 2])
    )


def _by_course(offsets: NDArray[np.int64]) -> NDArray[np.int64]:
    x, y = plane(offsets)
    return np.asarray(offsets[np.argsort(np.arctan2(x, y) % (2 * np.pi), kind="stable")])


def plane(offsets: NDArray[np.int64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Axial positions ``(n, 2)`` in sides of the triangle, as x (east) and y (north)."""
    return np.asarray(offsets[..., 0] + offsets[..., 1] / 2.0), np.asarray(offsets[..., 1] * ROW_HEIGHT)
