"""Stencils: how many courses, and how far apart."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from numpy.typing import NDArray

from seacruise.routing import stencil

# Rings of neighbours, courses, widest gap [degrees]: the table every lattice router is judged by.
RINGS = ((6, 60.0), (12, 30.0), (24, 19.1), (36, 13.9), (60, 10.9), (72, 8.9), (108, 7.6), (132, 6.6))


# The moves of R2 and R3 on squares: courses, widest gap [degrees].
MOVES = ((8, 45.0), (16, 26.57), (32, 18.43))


def courses_of(offsets: NDArray[np.int64], mesh: stencil.Mesh = stencil.TRIANGLES) -> NDArray[np.float64]:
    x, y = stencil.plane(offsets, mesh)
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


# ----------------------------------------------------------------------------------------- rectangular


@pytest.mark.parametrize(("courses", "gap"), MOVES)
def test_moves_give_courses_and_gaps(courses: int, gap: float) -> None:
    angles = courses_of(stencil.rectangular(courses), stencil.SQUARES)
    assert angles.size == np.unique(np.round(angles, 6)).size == courses
    gaps = np.diff(np.append(angles, angles[0] + 360.0))
    assert gaps.max() == pytest.approx(gap, abs=0.01)
    assert tuple(n for n, _ in MOVES) == stencil.RECTANGULAR_COURSES


def test_sixteen_courses_are_the_king_s_and_the_knight_s() -> None:
    king = {(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)} - {(0, 0)}
    knight = {(a * s, b * t) for a, b in ((1, 2), (2, 1)) for s in (-1, 1) for t in (-1, 1)}
    assert set(map(tuple, stencil.rectangular(8).tolist())) == king
    assert set(map(tuple, stencil.rectangular(16).tolist())) == king | knight


@pytest.mark.parametrize("courses", stencil.RECTANGULAR_COURSES)
def test_half_of_the_moves_is_the_other_half_turned_round(courses: int) -> None:
    offsets = stencil.rectangular(courses)
    np.testing.assert_array_equal(offsets[courses // 2 :], -offsets[: courses // 2])
    # By course on any rectangle, not on squares only.
    angles = np.degrees(np.arctan2(*stencil.plane(offsets, stencil.Mesh(0.0, 1.7)))) % 360.0
    assert (np.diff(angles) > 0.0).all()


def test_kinds_have_their_own_moves() -> None:
    assert stencil.of("triangular", 24) is stencil.triangular(24)
    assert stencil.of("rectangular", 16) is stencil.rectangular(16)
    assert stencil.mesh_of("triangular") == stencil.TRIANGLES
    assert stencil.mesh_of("rectangular") == stencil.SQUARES
    with pytest.raises(ValueError, match="24"):
        stencil.of("rectangular", 24)
