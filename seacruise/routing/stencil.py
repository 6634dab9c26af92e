"""Stencils: the set of edges that leave each vertex of a lattice, triangular or rectangular.

Positions on the triangular lattice are axial: ``(i, j)`` lies at ``x = i + j / 2``, ``y = j * sqrt(3) / 2``
sides of a triangle. Ring K holds the 6 K positions that are K steps away; of those, the ones with coprime
coordinates open a course that no nearer ring has: 6 phi(K) of them. On the rectangular one (R2, R3)
``(i, j)`` are column and row, and the moves are those with coprime i, j up to 1, 2 or 3.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

COURSES: Final = (6, 12, 24, 36, 60, 72, 108, 132)
"""Number of courses with 1 to 8 rings."""

RECTANGULAR_COURSES: Final = (8, 16, 32)
"""Number of courses of a rectangular lattice with moves of up to 1, 2 and 3 columns and rows."""

ROW_HEIGHT: Final = math.sqrt(3.0) / 2.0

Kind = Literal["triangular", "rectangular"]


@dataclass(frozen=True, slots=True)
class Mesh:
    """Shape of a lattice: position ``(i, j)`` lies at ``x = i + lean * j``, ``y = rise * j`` sides."""

    lean: float
    rise: float

    @property
    def pair(self) -> tuple[float, float]:
        """What the kernels call ``mesh``."""
        return self.lean, self.rise

    @property
    def longest(self) -> float:
        """Longest side of its triangles or rectangles, the side being 1."""
        return max(1.0, math.hypot(self.lean, self.rise))


TRIANGLES: Final = Mesh(0.5, ROW_HEIGHT)
SQUARES: Final = Mesh(0.0, 1.0)


def mesh_of(kind: Kind) -> Mesh:
    """Mesh of a kind of lattice."""
    return SQUARES if kind == "rectangular" else TRIANGLES


def of(kind: Kind, courses: int) -> NDArray[np.int64]:
    """Offsets of the stencil of a kind of lattice with that many courses; `triangular`, `rectangular`."""
    return rectangular(courses) if kind == "rectangular" else triangular(courses)


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
    return _by_course(np.array(kept), TRIANGLES)


@lru_cache(maxsize=4)
def rectangular(courses: int) -> NDArray[np.int64]:
    """Offsets ``(courses, 2)`` by columns and rows of R2's and R3's moves, sorted by course.

    On squares they are 45 degrees apart, or at most 26.6 and 18.4; on other rectangles the courses are
    what the rectangle makes them, exactly and everywhere.

    Raises
    ------
    ValueError
        For a number that no set of moves has.
    """
    if courses not in RECTANGULAR_COURSES:
        raise ValueError(f"a rectangular lattice has {RECTANGULAR_COURSES} courses, not {courses}")
    most = RECTANGULAR_COURSES.index(courses) + 1
    steps = range(-most, most + 1)
    return _by_course(np.array([(i, j) for i in steps for j in steps if math.gcd(i, j) == 1]), SQUARES)


def second_ring() -> NDArray[np.int64]:
    """R1's 12 neighbours, "jump by 2": 6 at two sides of the triangle and 6 at sqrt(3)."""
    steps = range(-2, 3)
    return _by_course(
        np.array([(i, j) for i in steps for j in steps if max(abs(i), abs(j), abs(i + j)) == 2]),
        TRIANGLES,
    )


def _by_course(offsets: NDArray[np.int64], mesh: Mesh) -> NDArray[np.int64]:
    x, y = plane(offsets, mesh)
    return np.asarray(offsets[np.argsort(np.arctan2(x, y) % (2 * np.pi), kind="stable")])


def plane(
    offsets: NDArray[np.int64], mesh: Mesh = TRIANGLES
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Positions ``(n, 2)`` on a lattice, in sides, as x (east) and y (north)."""
    return np.asarray(offsets[..., 0] + mesh.lean * offsets[..., 1]), np.asarray(offsets[..., 1] * mesh.rise)
