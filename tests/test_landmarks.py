from __future__ import annotations

import numpy as np
import pytest

from seacruise.geodesy import great_circle_m
from seacruise.landmarks import load_landmarks
from seacruise.sea.coast import covers, fine_land, fine_tree
from seacruise.units import METRES_PER_NM


def test_names_are_their_own_and_words_are_known() -> None:
    marks = load_landmarks()
    assert len(marks) >= 100
    assert len({mark.name for mark in marks}) == len(marks)
    assert {mark.kind for mark in marks} == {"cape", "light", "island"}
    assert {mark.rank for mark in marks} == {1, 2}
    assert all(len(mark.country) == 2 and mark.country.isupper() for mark in marks)


def test_the_ones_every_baltic_sailor_knows_are_there() -> None:
    names = {mark.name for mark in load_landmarks()}
    assert names >= {
        "Hel", "Rozewie", "Arkona", "Hoburgen", "Dueodde", "Hammeren", "Utklippan", "Landsort",
        "Ölands södra udde", "Ölands norra udde", "Kõpu", "Sõrve säär", "Bengtskär", "Skagen (Grenen)",
        "Kullen", "Gotska Sandön",
    }  # fmt: skip


@pytest.mark.parametrize("kind", ["cape", "island", "light"])
def test_they_lie_where_the_coast_is(kind: str) -> None:
    """Capes and islands on their shore; lights may stand on rocks that a coast of 100 m leaves out."""
    import shapely

    land, tree = fine_land(), fine_tree()
    for mark in load_landmarks():
        assert covers(np.array([mark.lat]), np.array([mark.lon])).all(), mark.name
        if mark.kind != kind:
            continue
        at = shapely.Point(mark.lon, mark.lat)
        line = shapely.shortest_line(land[tree.nearest(at)], at)
        (lon, lat), _ = shapely.get_coordinates(line).tolist()
        away = float(great_circle_m(lat, lon, mark.lat, mark.lon)) / METRES_PER_NM
        assert away < (30.0 if kind == "light" else 0.3), mark.name


def test_capes_are_at_the_water() -> None:
    """No cape is more than half a mile inland."""
    import shapely

    land, tree = fine_land(), fine_tree()
    for mark in load_landmarks():
        if mark.kind == "cape":
            at = shapely.Point(mark.lon, mark.lat)
            around = shapely.union_all(land[tree.query(at.buffer(0.1))])
            (lon, lat), _ = shapely.get_coordinates(shapely.shortest_line(around.boundary, at)).tolist()
            assert float(great_circle_m(lat, lon, mark.lat, mark.lon)) < 0.5 * METRES_PER_NM, mark.name
