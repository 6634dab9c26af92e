"""The 21 ways in which a polar file goes wrong, or looks as if it did, through the whole program."""

from __future__ import annotations

import codecs
import json
from collections.abc import Callable
from pathlib import Path

import pytest

from seacruise import cli

TABLE = "twa/tws;6;8\n45;4.1;5.2\n90;5.3;6.4\n150;3.9;4.8\n"

Maker = Callable[[Path], None]


def content(text: str | bytes) -> Maker:
    def make(path: Path) -> None:
        path.write_bytes(text if isinstance(text, bytes) else text.encode())

    return make


def huge(path: Path) -> None:
    with path.open("wb") as file:
        file.truncate(100_000_000)


READ: dict[str, Maker] = {
    "F05 BOM": content(codecs.BOM_UTF8 + TABLE.encode()),
    "F06 UTF-16": content(TABLE.encode("utf-16")),
    "F07 CRLF": content(TABLE.replace("\n", "\r\n")),
    "F07 CR": content(TABLE.replace("\n", "\r")),
    "F07 CR CR CR LF": content(TABLE.replace("\n", "\r\r\r\n")),
    "F08 semicolons and decimal commas": content(TABLE.replace(".", ",")),
    "F09 tabs": content(TABLE.replace(";", "\t")),
    "F10 quoted": content(TABLE.replace("4.1", '"4.1"')),
    "F13 unsorted TWA": content("twa/tws;6;8\n150;3.9;4.8\n90;5.3;6.4\n45;4.1;5.2\n"),
    "F21 row TWA=0 absent": content(TABLE),
}

REFUSED: dict[str, tuple[Maker, str]] = {
    "F01 missing file": (lambda path: None, "There is no polar file"),
    "F02 directory": (lambda path: path.mkdir(), "is a folder"),
    "F03 empty": (content(""), "is empty"),
    "F04 header only": (content("twa/tws;6;8\n"), "line 1: there is a header but no rows"),
    "F11 ragged row": (content(TABLE + "160;3\n"), "line 5: 1 figures where the header has 2"),
    "F12 duplicate TWS": (content(TABLE.replace("6;8", "6;6")), "line 1, cell 3: the wind speed 6 kn"),
    "F13 unsorted TWS": (content(TABLE.replace("6;8", "8;6")), "line 1, cell 3: the wind speeds must"),
    "F14 TWA above 180": (content(TABLE + "190;3;4\n"), "line 5, cell 2: a wind angle of 190"),
    "F15 negative speed": (content(TABLE + "160;-3;4\n"), "line 5, cell 2: a boat speed of -3"),
    "F16 text cell": (content(TABLE + "160;fast;4\n"), "line 5, cell 2: 'fast' is not a number"),
    "F17 nan": (content(TABLE + "160;nan;4\n"), "line 5, cell 2: 'nan' is not a number"),
    "F17 inf": (content(TABLE + "160;3;inf\n"), "line 5, cell 3: 'inf' is not a number"),
    "F18 100 MB": (huge, "larger than 5 MB"),
    "F19 single column": (content("twa/tws;6\n45;4\n90;5\n"), "line 1: there is only one wind speed"),
    "F20 all zeros": (content("twa/tws;6;8\n45;0;0\n90;0;0\n"), "all boat speeds are zero"),
}


@pytest.mark.parametrize("case", READ)
def test_read_all_the_same(case: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "boat.csv"
    READ[case](path)
    assert cli.main(["polar", "show", str(path), "--format", "json"]) == 0
    shown = json.loads(capsys.readouterr().out)
    assert shown["tws_kn"] == [6.0, 8.0]
    assert shown["boat_speed_kn"] == [[4.1, 5.2], [5.3, 6.4], [3.9, 4.8]]


@pytest.mark.parametrize("case", REFUSED)
def test_refused_with_one_sentence(case: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    make, sentence = REFUSED[case]
    path = tmp_path / "boat.csv"
    make(path)
    assert cli.main(["polar", "show", str(path), "--format", "json"]) == 2
    out, err = capsys.readouterr()
    assert json.loads(out)["reason"] == "bad-input"
    assert sentence in err
    assert "boat.csv" in err
    assert len(err.strip().splitlines()) == 1
    assert "Traceback" not in err


def test_every_case_of_the_catalogue_has_a_test() -> None:
    assert {case[:3] for case in (*READ, *REFUSED)} == {f"F{number:02}" for number in range(1, 22)}
