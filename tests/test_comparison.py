"""The comparison in the documentation: every cell has its word and source, every claim of ours its proof."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest

from tests.conftest import REPOSITORY

PAGE = REPOSITORY / "docs" / "comparison.md"
PROGRAMS = ["SeaCruise", "OpenCPN", "qtVlm", "LuckGrib", "PredictWind", "Expedition"]
SOURCE = re.compile(r"\(([A-Z]\d(?:, [A-Z]\d)*)\)")


def cells(line: str) -> list[str]:
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def rows() -> Iterator[tuple[str, list[str]]]:
    """Rows of the tables of features: the feature, then the programs and the proof."""
    inside = False
    for line in PAGE.read_text("utf-8").splitlines():
        if not line.startswith("|"):
            inside = False
        elif not inside:
            inside = cells(line)[1:7] == PROGRAMS
        elif not line.startswith("|---"):
            feature, *rest = cells(line)
            yield feature, rest


ROWS = list(rows())


def test_there_is_a_table_of_every_part() -> None:
    assert len(ROWS) >= 40
    assert len({feature for feature, _ in ROWS}) == len(ROWS)


@pytest.mark.parametrize(("feature", "row"), ROWS, ids=[feature for feature, _ in ROWS])
def test_each_cell_of_others_has_a_source_or_is_unknown(feature: str, row: list[str]) -> None:
    assert len(row) == 7, feature
    known = set(re.findall(r"^\| ([A-Z]\d) \|", PAGE.read_text("utf-8"), re.MULTILINE))
    for program, cell in zip(PROGRAMS[1:], row[1:6], strict=True):
        sources = SOURCE.findall(cell)
        if feature not in {"Method", "Polars that come along"}:
            assert re.match(r"(yes|no|partly|unknown)\b", cell), f"{program}: {cell}"
        if not cell.startswith("unknown"):
            assert sources, f"{program}: {cell} has no source"
        named = {letter for one in sources for letter in one.split(", ")}
        assert named <= known, f"{program}: {named - known} is no source"
        assert {letter[0] for letter in named} <= {program[0] if program != "qtVlm" else "Q"}, cell
        assert not cell.startswith("no") or sources


@pytest.mark.parametrize(("feature", "row"), ROWS, ids=[feature for feature, _ in ROWS])
def test_what_we_claim_is_shown_somewhere(feature: str, row: list[str]) -> None:
    links = re.findall(r"\]\(([^)]+)\)", row[6])
    assert links
    for link in links:
        assert (PAGE.parent / link).resolve().is_file(), f"{feature}: {link}"


def test_the_page_can_be_found() -> None:
    for name in ("README.md", "docs/architecture.md"):
        assert "comparison.md" in (REPOSITORY / name).read_text("utf-8")
