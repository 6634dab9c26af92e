"""``seacruise polar``: show, hull, compare, convert."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from seacruise import cli
from seacruise.commands import polar_convert
from seacruise.yacht.files import FORMATS, read_polar

YACHT = "Bavaria 46 Cruiser"
SAILS = (
    "# name: Two sails\n# sail: Genoa\ntwa/tws;6;10\n45;4;5.5\n90;5;6.6\n120;4.2;6\n"
    "# sail: Gennaker\ntwa/tws;6;10\n90;5.5;7\n120;5.2;7.2\n160;3.4;5.3\n"
)


@pytest.fixture
def two_sails(tmp_path: Path) -> str:
    path = tmp_path / "two.csv"
    path.write_text(SAILS)
    return str(path)


def answer(capsys: pytest.CaptureFixture[str], *words: str) -> dict[str, Any]:
    assert cli.main(["polar", *words, "--format", "json"]) == 0
    content: dict[str, Any] = json.loads(capsys.readouterr().out)
    return content


def text(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    assert cli.main(["polar", *words]) == 0
    return capsys.readouterr().out


def test_show_names_the_sails(capsys: pytest.CaptureFixture[str], two_sails: str) -> None:
    shown = answer(capsys, "show", two_sails)
    assert shown["twa_deg"] == [45, 90, 120, 160]
    ranges = shown["sail_ranges"][1]
    assert ranges["tws_kn"] == 10
    assert [part["sail"] for part in ranges["ranges"]] == ["Genoa", "Gennaker"]
    assert 45 < ranges["ranges"][0]["twa_to"] <= 90
    assert "Gennaker to 180°" in text(capsys, "show", two_sails)
    assert "sail_ranges" not in answer(capsys, "show", YACHT)


def test_what_show_prints_is_a_polar_file(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    path = tmp_path / "shown.json"
    path.write_text(text(capsys, "show", YACHT, "--format", "json"))
    assert read_polar(path).name == YACHT
    assert (
        answer(capsys, "show", str(path))["boat_speed_kn"] == answer(capsys, "show", YACHT)["boat_speed_kn"]
    )


def test_hull_tells_two_headings_and_their_shares(capsys: pytest.CaptureFixture[str]) -> None:
    hull = answer(capsys, "hull", YACHT, "--tws", "10", "--every", "20")
    assert hull["schema"] == "seacruise.polar-hull/1"
    courses = hull["winds"][0]["courses"]
    assert [row["course_deg"] for row in courses] == [*range(0, 180, 20), 180]
    beat = courses[0]
    assert beat["direct_kn"] == 0.0
    assert beat["made_good_kn"] == pytest.approx(4.89, abs=0.01)
    assert [heading["twa_deg"] for heading in beat["headings"]] == [42.0, -42.0]
    assert [heading["share"] for heading in beat["headings"]] == [0.5, 0.5]
    assert len(courses[4]["headings"]) == 1
    assert "50 % at 42° + 50 % at -42°" in text(capsys, "hull", YACHT, "--tws", "10")
    assert "Courses to 20 kn" in text(capsys, "hull", YACHT)


def test_hull_names_the_sails(capsys: pytest.CaptureFixture[str], two_sails: str) -> None:
    assert "direct, Gennaker" in text(capsys, "hull", two_sails, "--tws", "10")
    assert "50 % at 45° (Genoa)" in text(capsys, "hull", two_sails, "--tws", "10")


def test_compare_has_differences_and_targets(capsys: pytest.CaptureFixture[str]) -> None:
    found = answer(capsys, "compare", YACHT, "Edel 660", YACHT, "--tws", "10", "--tws", "50")
    slower, same = found["others"]
    assert (slower["yacht"], same["yacht"]) == ("Edel 660", YACHT)
    row = found["twa_deg"].index(90)
    assert found["boat_speed_kn"][row][0] == pytest.approx(7.87, abs=0.01)
    assert slower["difference_kn"][row][0] == pytest.approx(-2.31, abs=0.02)
    assert slower["difference_percent"][row][0] == pytest.approx(-29.4, abs=0.1)
    assert slower["difference_kn"][row][1] is None
    assert slower["mean_percent"] < -20
    assert same["mean_percent"] == 0.0
    assert [target["yacht"] for target in found["targets"]] == [YACHT, "Edel 660", YACHT]
    assert found["targets"][0]["beat"]["vmg_kn"][0] == pytest.approx(4.89, abs=0.01)


def test_compare_as_text(capsys: pytest.CaptureFixture[str], two_sails: str) -> None:
    printed = text(capsys, "compare", YACHT, "Edel 660")
    assert "Edel 660 against Bavaria 46 Cruiser" in printed
    assert "% in the mean" in printed
    assert "beat angle" in printed
    assert "They have no wind and angle in common." in text(
        capsys, "compare", YACHT, two_sails, "--tws", "22"
    )


@pytest.mark.parametrize("form", FORMATS)
def test_convert(form: str, capsys: pytest.CaptureFixture[str], tmp_path: Path, two_sails: str) -> None:
    out = tmp_path / "out.txt"
    written = answer(capsys, "convert", two_sails, str(out), "--to", form)
    again = read_polar(out)
    assert written["format"] == form
    assert written["sails"] == [sail.name for sail in again.sails]
    assert len(written["tws_kn"]) == len(again.tws)
    certificate = answer(capsys, "convert", YACHT, str(out), "--to", form)
    assert (certificate["interpolated"] > 0) == (form in polar_convert.FILLED)


def test_convert_says_what_is_lost(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, two_sails: str
) -> None:
    assert cli.main(["polar", "convert", two_sails, str(tmp_path / "a.pol"), "--to", "maxsea"]) == 0
    out, err = capsys.readouterr()
    assert "Two sails: 2 wind speeds" in out
    assert "knows no empty cells" not in err
    assert "knows no sails; the file has the best of 2" in err
    assert cli.main(["polar", "convert", YACHT, str(tmp_path / "a.pol"), "--to", "maxsea"]) == 0
    assert "maxsea knows no empty cells; 108 were interpolated" in capsys.readouterr().err


def test_convert_refuses_what_cannot_be_written(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, two_sails: str
) -> None:
    assert cli.main(["polar", "convert", two_sails, str(tmp_path / "no" / "a.csv")]) == 2
    assert "there is no folder" in capsys.readouterr().err
    assert cli.main(["polar", "convert", two_sails, str(tmp_path / "a.csv"), "--to", "xls"]) == 2
    assert "invalid choice: 'xls'" in capsys.readouterr().err


def test_the_command_line_knows_all_formats() -> None:
    assert polar_convert.FORMATS == FORMATS
