"""What is kept, and what goes first."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from seacruise.desktop.chart.kept import Kept
from seacruise.desktop.chart.land import LandCells


def test_what_was_not_asked_for_the_longest_goes_first() -> None:
    kept: Kept[str, str] = Kept(6, len)
    for word in ("aa", "bb", "cc"):
        kept.put(word, word)
    assert kept.get("aa") == "aa"
    kept.put("dd", "dd")
    assert kept.get("bb") is None
    assert [kept.get(word) for word in ("aa", "cc", "dd")] == ["aa", "cc", "dd"]


def test_what_is_too_large_alone_stays_until_the_next() -> None:
    kept: Kept[int, str] = Kept(3, len)
    kept.put(1, "a")
    assert kept.put(2, "too large") == "too large"
    assert (len(kept), kept.get(1), kept.get(2)) == (1, None, "too large")
    kept.put(3, "b")
    assert (len(kept), kept.get(2), kept.total) == (1, None, 1)


@given(st.lists(st.tuples(st.integers(0, 20), st.integers(1, 9))))
def test_it_is_never_larger_than_allowed_and_knows_its_size(asked: list[tuple[int, int]]) -> None:
    kept: Kept[int, str] = Kept(20, len)
    for key, size in asked:
        if kept.get(key) is None:
            kept.put(key, "x" * size)
        assert kept.total <= 20
        held = [kept.get(number) for number in range(21)]
        assert kept.total == sum(len(word) for word in held if word is not None)
        assert kept.get(key) is not None


def test_cells_of_the_coast_come_back_as_they_were() -> None:
    cells, again = LandCells(0), LandCells(0)
    before = {(c, r): cells.cell(5, c, r).points.tobytes() for c in range(32) for r in range(32)}
    again._cells._most = 2000  # too few for any depth
    assert {key: again.cell(5, *key).points.tobytes() for key in before} == before
    assert len(again._cells) < 32 * 32
