"""``seacruise polar plot``."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from seacruise import cli
from seacruise.commands import polar_plot
from seacruise.export.polar_pictures import KINDS
from tests.yacht.logs.voyages import nmea, voyage
from tests.yacht.polars import small

YACHT = "Bavaria 46 Cruiser"


def plot(capsys: pytest.CaptureFixture[str], *words: str) -> dict[str, Any]:
    assert cli.main(["polar", "plot", *words, "--format", "json"]) == 0
    answer: dict[str, Any] = json.loads(capsys.readouterr().out)
    return answer


def test_kinds_are_those_that_can_be_drawn() -> None:
    assert polar_plot.KINDS == KINDS


def test_json_names_the_file_and_what_is_in_it(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    out = tmp_path / "a.svg"
    found = plot(capsys, YACHT, "Carter 30", "--tws", "6,10", "--tws", "14", "--out", str(out))
    assert found["schema"] == "seacruise.polar-picture/1"
    assert (found["file"], found["form"], found["kind"], found["theme"]) == (
        str(out),
        "svg",
        "polar",
        "light",
    )
    assert found["tws_kn"] == [6, 10, 14]
    assert [yacht["yacht"] for yacht in found["yachts"]] == [YACHT, "Carter 30"]
    beat = found["yachts"][0]["slices"][1]["beat"]
    assert beat["twa_deg"] == pytest.approx(42, abs=0.5)
    assert beat["vmg_kn"] < beat["boat_speed_kn"]
    assert out.stat().st_size > 10_000


def test_hull_tells_its_headings(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    found = plot(capsys, YACHT, "--kind", "hull", "--dark", "--out", str(tmp_path / "a.pdf"))
    cut = found["yachts"][0]["slices"][0]
    assert cut["tws_kn"] == 10
    first, second = cut["two_headings"][0]["twa_deg"]
    assert first == -second == cut["beat"]["twa_deg"]
    assert found["theme"] == "dark"


def test_text_and_all_winds(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    out = tmp_path / "a.png"
    assert cli.main(["polar", "plot", YACHT, "--kind", "colour", "--tws", "6", "--out", str(out)]) == 0
    said = capsys.readouterr()
    assert str(out) in said.out
    assert "shows all winds" in said.err


def test_a_log_over_the_polar(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    log = tmp_path / "july.nmea"
    log.write_text("\n".join(nmea(voyage(small(), hours=0.5), variation="0.0,E")))
    found = plot(capsys, YACHT, "--tws", "8", "--log", str(log), "--out", str(tmp_path / "a.png"))
    assert found["log"]["file"] == "july.nmea"
    assert 0 < found["log"]["shown"] < found["log"]["points"]
    assert found["log"]["within_kn"] == 1


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ((YACHT, "--out", "a.gif"), "must end in .png, .pdf or .svg"),
        ((YACHT, "--out", "none/a.png"), "no folder"),
        ((YACHT, "--out", "a.png", "--tws", "6,ten"), "'ten' is not a number"),
        ((YACHT, "--out", "a.png", "--tws", ","), "'' is not a number"),
        ((YACHT, "Carter 30", "--kind", "hull", "--out", "a.png"), "shows one yacht"),
        ((YACHT, "--out", "a.png", "--log", "none.nmea"), "There is no log"),
        (("Nobody's yacht", "--out", "a.png"), "There is no yacht"),
        ((YACHT,), "--out"),
        ((YACHT, "--out", "a.png", "--kind", "pie"), "invalid choice"),
    ],
)
def test_refusals_are_one_sentence(
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    words: tuple[str, ...],
    sentence: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert cli.main(["polar", "plot", *words]) == 2
    said = capsys.readouterr()
    last = said.err.strip().splitlines()[-1]
    assert sentence in last
    assert "Traceback" not in said.err
    assert said.out == ""
    assert not list(tmp_path.glob("*.png"))
