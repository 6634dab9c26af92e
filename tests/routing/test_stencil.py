"""Stencils: how many courses, and how far apart."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from numpy.typing import NDArray

from seacruise.routing import stencil

# Rings of neighbours, courses, widest gap [degrees]: the table every lattice router is judged by.
RINGS = ((6, 60.0), (12, 30.0), (24, 19.1), (36, 13.9), (60, 10.9), (72, 8.9), (108, 7.6), (132, 6.6))


def courses_of(offsets: NDArray[np.int64]) -> NDArray[np.float64]:
    x, y = stencil.plane(offsets)
    return np.asarray(np.sort(np.degrees(np.arctan2(x, y)) % 360.0))


@pytest.mark.parametrize(("courses", "gap"), RINGS)
def test_rings_give_courses_and_gaps(courses: int, gap: float) -> None:
    assert courses in stencil.COURSES
    angles = courses_of(stencil.triangular(courses))
    assert angles.size == np.unique(np.round(angles, 6)).size == courses
    gaps = np.diff(np.append(angles, angles[0] + 360.0))
    assert gaps.max() == pytest.approx(gap, abs=0.06)


def test_the_two_lists_agree() -> None:
    assert tuple(courses for courses, _ in RINGS) == stencil.COURSES


@pytest.mark.parametrize("courses", stencil.COURSES)
def test_half_of_a_stencil_is_the_other_half_turned_round(courses: int) -> None:
    offsets = stencil.triangular(courses)
    half = courses // 2
    np.testing.assert_array_equal(offsets[half:], -offsets[:half])


def test_richer_stencils_hold_the_poorer_ones() -> None:
    sets = [set(map(tuple, stencil.triangular(c).tolist())) for c in stencil.COURSES]
    assert all(few < many for few, many in itertools.pairwise(sets))


def test_second_ring_is_what_r1_published() -> None:
    offsets = stencil.second_ring()
    length = np.sort(np.hypot(*stencil.plane(offsets)))
    np.testing.assert_allclose(length, [3**0.5] * 6 + [2.0] * 6)
    np.testing.assert_allclose(courses_of(offsets), np.arange(0.0, 360.0, 30.0), atol=1e-9)


def test_other_numbers_of_courses_are_refused() -> None:
    with pytest.raises(ValueError, match="48"):
        stencil.triangular(48)
