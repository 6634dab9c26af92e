"""What ``import seacruise`` offers is enough to plan a passage, as its own docstring shows."""

from __future__ import annotations

import textwrap
from pathlib import Path

import pytest

import seacruise
from seacruise.resources import resource_path


def test_the_example_of_the_docstring_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("my-yacht.csv").write_bytes((resource_path("polars") / "bavaria-46-cruiser.csv").read_bytes())
    assert seacruise.__doc__ is not None
    example = textwrap.dedent(seacruise.__doc__.partition("::\n")[2])
    exec(compile(example, "example", "exec"), {})
    assert 24 < float(capsys.readouterr().out) < 100
