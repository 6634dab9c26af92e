"""Polar files: what sailors have, what is wrong with some, and the house format there and back."""

from __future__ import annotations

import codecs
import json
import tempfile
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from seacruise.errors import InputError
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.files import read_polar, write_polar
from seacruise.yacht.polar import Polar
from tests.yacht.polars import NAN, polars, small

TABLE = "twa/tws;6;8;10\n45;4.1;5.2;6.1\n90;5.3;6.4;7.2\n150;3.9;4.8;5.7\n"


def read(tmp_path: Path, content: str | bytes, name: str = "boat.csv") -> Polar:
    path = tmp_path / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return read_polar(path)


def assert_same(a: Polar, b: Polar) -> None:
    assert a.name == b.name
    np.testing.assert_array_equal(a.tws, b.tws)
    np.testing.assert_array_equal(a.twa, b.twa)
    np.testing.assert_array_equal(a.speed_table, b.speed_table)


def in_knots(polar: Polar) -> list[list[float]]:
    figures: list[list[float]] = np.round(polar.speed_table / MS_PER_KNOT, 3).tolist()
    return figures


PLAIN = [[4.1, 5.2, 6.1], [5.3, 6.4, 7.2], [3.9, 4.8, 5.7]]


@pytest.mark.parametrize(
    "content",
    [
        pytest.param(TABLE, id="house"),
        pytest.param("# a comment\n! another\n\n" + TABLE, id="comments"),
        pytest.param(codecs.BOM_UTF8 + TABLE.encode(), id="BOM"),
        pytest.param(TABLE.encode("utf-16"), id="UTF-16"),
        pytest.param(TABLE.encode("utf-16-le"), id="UTF-16 LE without mark"),
        pytest.param(TABLE.encode("utf-16-be"), id="UTF-16 BE without mark"),
        pytest.param(TABLE.replace("\n", "\r\n"), id="CRLF"),
        pytest.param(TABLE.replace("\n", "\r"), id="CR"),
        pytest.param(TABLE.replace("\n", "\r\r\r\n"), id="CR CR CR LF"),
        pytest.param(TABLE.replace(".", ","), id="decimal commas"),
        pytest.param(TABLE.replace(".", ",").replace(";", "\t"), id="tabs and decimal commas"),
        pytest.param(TABLE.replace(".", ",").replace(";", "  "), id="blanks and decimal commas"),
        pytest.param(TABLE.replace("twa/tws", r"TWA\TWS").replace(";", "\t"), id="OpenCPN tabs"),
        pytest.param(TABLE.replace(";", ","), id="commas"),
        pytest.param(TABLE.replace(";", ", "), id="commas and blanks"),
        pytest.param(TABLE.replace(";", "   "), id="blanks"),
        pytest.param(TABLE.replace("\n", "\t\t\n").replace(";", "\t"), id="trailing tabs"),
        pytest.param(TABLE.replace("\n", ";\n"), id="trailing separators"),
        pytest.param(
            '"twa/tws";"6";"8";"10"\n"45";"4,1";"5,2";"6,1"\n90;5.3;6.4;7.2\n150;3.9;4.8;5.7', id="quoted"
        ),
        pytest.param(
            "TWA,6,8,10\n45,'4.1','5.2','6.1'\n90,5.3,6.4,7.2\n150,3.9,4.8,5.7", id="TWA in the corner"
        ),
        pytest.param(
            "TWA\t6\t8\t10\n45\xb0\t4.1\t5.2\t6.1\n90\xb0\t5.3\t6.4\t7.2\n150\xb0\t3.9\t4.8\t5.7".encode(
                "latin-1"
            ),
            id="Latin-1 degree signs",
        ),
        pytest.param("My boat\n2019 sails\n" + TABLE, id="title lines"),
        pytest.param(
            "twa/tws;6;8;10\n150;3.9;4.8;5.7\n90;5.3;6.4;7.2\n45;4.1;5.2;6.1\n", id="angles unsorted"
        ),
        pytest.param(
            r"TWS\TWA;45;90;150" + "\n6;4.1;5.3;3.9\n8;5.2;6.4;4.8\n10;6.1;7.2;5.7", id="a row per wind"
        ),
        pytest.param(
            "!Expedition polar\r\n6\t45\t4.1\t90\t5.3\t150\t3.9\r\n8\t45\t5.2\t90\t6.4\t150\t4.8\r\n"
            "10\t45\t6.1\t90\t7.2\t150\t5.7\t\r\n",
            id="Expedition",
        ),
        pytest.param(
            "TWS,TWA,BSP\n6,45,4.1\n6,90,5.3\n6,150,3.9\n8,45,5.2\n8,90,6.4\n8,150,4.8\n10,45,6.1\n10,90,7.2\n"
            "10,150,5.7",
            id="list of points",
        ),
    ],
)
def test_the_same_table_in_many_forms(tmp_path: Path, content: str | bytes) -> None:
    polar = read(tmp_path, content)
    assert polar.twa.tolist() == [45, 90, 150]
    assert np.round(polar.tws / MS_PER_KNOT, 6).tolist() == [6, 8, 10]
    assert in_knots(polar) == PLAIN


def test_in_the_export_of_a_certificate_zero_is_no_figure(tmp_path: Path) -> None:
    polar = read(
        tmp_path,
        "twa/tws;6;8;10\n0;0;0;0\n44;4;0;0\n42;0;5;0\n42;0;0;6\n90;5.3;6.4;7.2\n150;3.9;4.8;5.7\n145;4;0;0\n"
        "147;0;5;0\n150;0;0;5.72\n",
    )
    assert polar.twa.tolist() == [42, 44, 90, 145, 147, 150]
    np.testing.assert_allclose(
        polar.speed_table / MS_PER_KNOT,
        np.array(
            [[NAN, 5, 6], [4, NAN, NAN], [5.3, 6.4, 7.2], [4, NAN, NAN], [NAN, 5, NAN], [3.9, 4.8, 5.7]]
        ),
    )


def test_elsewhere_zero_is_zero_and_empty_is_no_figure(tmp_path: Path) -> None:
    polar = read(tmp_path, "twa/tws;20;30;40\n0;0;0;0\n45;6;;0\n90;7;6;0.1\n")
    np.testing.assert_allclose(
        polar.speed_table / MS_PER_KNOT, np.array([[0, 0, 0], [6, NAN, 0], [7, 6, 0.1]])
    )


def test_a_wind_without_figures_is_left_out(tmp_path: Path) -> None:
    polar = read(tmp_path, "twa/tws;20;25;30\n45;6;;5\n90;7;;6\n")
    assert len(polar.tws) == 2


def test_beat_and_run_vmg_become_speeds(tmp_path: Path) -> None:
    polar = read(
        tmp_path,
        "WindVelocity 6 8\nBeatAngles 45° 60°\nBeatVMG 3 2\n90° 5 6\nGybeAngles 135° 120°\nRunVMG 3 3\n",
    )
    assert polar.twa.tolist() == [45, 60, 90, 120, 135]
    expected = np.array([[4.243, NAN], [NAN, 4.0], [5, 6], [NAN, 6.0], [4.243, NAN]])
    np.testing.assert_allclose(polar.speed_table / MS_PER_KNOT, expected, atol=1e-3)


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        pytest.param("", "is empty", id="empty"),
        pytest.param("  \n\t\n", "is empty", id="blank"),
        pytest.param("# only\n# comments\n", "line 1: there are only comments", id="only comments"),
        pytest.param("twa/tws;6;8\n", "line 1: there is a header but no rows", id="header only"),
        pytest.param("twa/tws;6;8\n45;4\n", "line 2: 1 figures where the header has 2", id="ragged: short"),
        pytest.param(
            "twa/tws;6;8\n45;4;5;6\n", "line 2: 3 figures where the header has 2", id="ragged: long"
        ),
        pytest.param(
            "twa/tws;6;6\n45;4;5\n", "line 1, cell 3: the wind speed 6 kn is there twice", id="duplicate TWS"
        ),
        pytest.param(
            "twa/tws;8;6\n45;4;5\n", "line 1, cell 3: the wind speeds must increase", id="unsorted TWS"
        ),
        pytest.param(
            "twa/tws;6;8\n45;4;5\n45;4;6\n", "line 3, cell 3: 45 degrees at 8 kn has two", id="two figures"
        ),
        pytest.param("twa/tws;6;8\n190;4;5\n", "line 2, cell 2: a wind angle of 190", id="TWA above 180"),
        pytest.param("twa/tws;6;8\n-45;4;5\n", "line 2, cell 2: a wind angle of -45", id="negative TWA"),
        pytest.param("twa/tws;6;8\n45;4;-5\n", "line 2, cell 3: a boat speed of -5", id="negative speed"),
        pytest.param("twa/tws;6;8\n45;4;500\n", "line 2, cell 3: a boat speed of 500", id="speed of 500"),
        pytest.param("twa/tws;6;800\n45;4;5\n", "line 1, cell 3: a wind speed of 800", id="wind of 800"),
        pytest.param("twa/tws;6;8\n45;4;fast\n", "line 2, cell 3: 'fast' is not a number", id="text cell"),
        pytest.param("twa/tws;6;8\nreach;4;5\n", "line 2, cell 1: 'reach' is not a number", id="text angle"),
        pytest.param("twa/tws;6;8\n45;4;nan\n", "line 2, cell 3: 'nan' is not a number", id="nan"),
        pytest.param("twa/tws;6;8\n45;4;inf\n", "line 2, cell 3: 'inf' is not a number", id="inf"),
        pytest.param("twa/tws;6;8\n45;4;1e999\n", "line 2, cell 3: '1e999' is not a number", id="1e999"),
        pytest.param("twa/tws;6;8\n45;4;1_0\n", "line 2, cell 3: '1_0' is not a number", id="underscore"),
        pytest.param(
            "twa/tws;6;8\n45;4;\u0665\n", "line 2, cell 3: '\u0665' is not a number", id="Arabic digit"
        ),
        pytest.param("twa/tws;6\n45;4\n90;5\n", "line 1: there is only one wind speed", id="single column"),
        pytest.param("twa/tws;6;8\n45;4;5\n", "two wind speeds and two angles", id="single row"),
        pytest.param("twa/tws;6;8\n45;0;0\n90;0;0\n", "all boat speeds are zero", id="all zeros"),
        pytest.param('twa/tws;6;8\n45;"4;5\n', "line 2: the quotation marks do not match", id="open quote"),
        pytest.param("hello\nworld\n", "line 1: this is no header", id="no table"),
        pytest.param(
            "45 4 5 6\n90 5 6 7\n", "line 1: the header with the wind speeds is missing", id="no header"
        ),
        pytest.param(
            "6\t45\t4\n8\t45\n", "line 2: after the wind speed there must be pairs", id="half a pair"
        ),
        pytest.param("BeatTWS;6;8\n", "line 1: this is no header", id="unknown corner"),
        pytest.param("twa/tws;6;8\nVMG;3;4\n", "line 2: the row of angles", id="VMG without angles"),
        pytest.param(
            "twa/tws;6;8\nTWA;90;45\nVMG;3;4\n", "line 2, cell 2: 90 degrees", id="VMG at 90 degrees"
        ),
        pytest.param(
            "TWS,TWA,BSP\n6,45\n", "line 2: wind speed, wind angle and boat speed", id="short point"
        ),
        pytest.param(b"BZh91AY&SY\x00\x01\x02", "is not a text file", id="binary"),
        pytest.param(b"\xff\xfet", "is not a text file", id="half UTF-16"),
    ],
)
def test_what_is_wrong_is_said_with_line_and_cell(
    tmp_path: Path, content: str | bytes, sentence: str
) -> None:
    with pytest.raises(InputError) as caught:
        read(tmp_path, content)
    assert "boat.csv" in str(caught.value)
    assert sentence in str(caught.value)
    assert "\n" not in str(caught.value)


def test_missing_file(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"There is no polar file .*check the name"):
        read_polar(tmp_path / "none.csv")


def test_directory(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="is a folder"):
        read_polar(tmp_path)


def test_name_no_system_allows() -> None:
    with pytest.raises(InputError, match="cannot be read"):
        read_polar(Path("a\0b.csv"))


def test_100_mb_are_refused_unread(tmp_path: Path) -> None:
    path = tmp_path / "huge.csv"
    with path.open("wb") as file:
        file.truncate(100_000_000)
    with pytest.raises(InputError, match="larger than 5 MB"):
        read_polar(path)


def test_a_row_at_zero_degrees_may_be_absent(tmp_path: Path) -> None:
    assert read(tmp_path, TABLE).speed(3.0, 0.0) == 0.0


def test_name_and_source_come_from_comments_or_the_file(tmp_path: Path) -> None:
    named = read(tmp_path, "# source: certificate 1\n# name: Café 30\n" + TABLE)
    assert (named.name, named.source) == ("Café 30", "certificate 1")
    unnamed = read(tmp_path, TABLE, "My_old boat.pol")
    assert (unnamed.name, unnamed.source) == ("My old boat", "My_old boat.pol")


@given(polars(), st.text(max_size=20))
def test_what_is_written_is_read(polar: Polar, name: str) -> None:
    polar = Polar(name, polar.tws, polar.twa, polar.speed_table)
    rows = ~np.isnan(polar.speed_table).all(axis=1)
    assume((polar.speed_table > 0).any() and rows.sum() > 1)
    with tempfile.TemporaryDirectory() as folder:
        first = Path(folder) / "first.csv"
        write_polar(polar, first)
        again = read_polar(first)
        write_polar(again, Path(folder) / "second.csv")
        assert_same(read_polar(Path(folder) / "second.csv"), again)
    np.testing.assert_allclose(again.tws, polar.tws, atol=1e-6)
    np.testing.assert_allclose(again.twa, polar.twa[rows])
    np.testing.assert_allclose(again.speed_table, polar.speed_table[rows], atol=1e-6)


def test_writing_keeps_shipped_figures_to_the_last_bit(tmp_path: Path) -> None:
    write_polar(read(tmp_path, TABLE), tmp_path / "copy.csv")
    np.testing.assert_array_equal(
        read_polar(tmp_path / "copy.csv").speed_table, read(tmp_path, TABLE).speed_table
    )


def test_a_target_that_cannot_be_written_leaves_nothing(tmp_path: Path) -> None:
    target = tmp_path / "taken"
    target.mkdir()
    with pytest.raises(InputError, match="cannot be written"):
        write_polar(small(), target)
    assert [path.name for path in tmp_path.iterdir() if path.is_file()] == []


@given(st.binary(max_size=400))
@example(b"twa/tws;6;8\n45;4;5\n90;\xff;6")
@example(b"TWS,TWA,BSP")
@example(b"TWA 6 8\nTWA 45 45\nVMG 1 1")
def test_hostile_bytes_raise_nothing_but_input_errors(folder: Path, content: bytes) -> None:
    read_or_refuse(content, folder)


HOSTILE = st.text("0123456789.,;\t\n\r -+eE°\"'#!/\\{[<twasbpvmgxyn\u0660\ud7ff", max_size=200)


@given(HOSTILE)
def test_hostile_text_raises_nothing_but_input_errors(folder: Path, content: str) -> None:
    read_or_refuse(content.encode(), folder)
    read_or_refuse(b"twa/tws;6;8\n" + content.encode(), folder)
    read_or_refuse(b"TWA\t6\t8\n45\t3\t4\n" + content.encode(), folder)
    read_or_refuse(b"# sail: A\ntwa/tws;6;8\n45;3;4\n90;4;5\n# sail: B\n" + content.encode(), folder)


KEYS = ["vpp", "speeds", "angles", "45", "beat_angle", "beat_vmg", "sail", "tws", "twa", "speed", "label"]
KEYS += ["globalSpeedRatio", "sails", "name", "tws_kn", "twa_deg", "boat_speed_kn", "yacht"]

JSON = st.recursive(
    st.none() | st.booleans() | st.floats() | st.integers() | st.text(max_size=5) | st.floats(0, 60),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.dictionaries(
            st.sampled_from(KEYS),
            inner,
            max_size=6,
        )
    ),
    max_leaves=40,
)


@given(JSON)
@example({"tws_kn": [6, 8], "twa_deg": [45, 90], "boat_speed_kn": [[1, 2], [3, None]]})
@example({"sails": [{"tws_kn": [6, 8], "twa_deg": [45, 90], "boat_speed_kn": [[1, 2], [3, 10**400]]}]})
@example({"sail": [{"speed": [[1, 2], [3, -0.1]]}], "tws": [6, 8], "twa": [45, 90]})
@example({"vpp": {"speeds": [6, 8], "angles": [45], "45": [1, 2], "beat_angle": [0, 90], "beat_vmg": [1, 1]}})
def test_hostile_json_raises_nothing_but_input_errors(folder: Path, content: object) -> None:
    read_or_refuse(json.dumps(content).encode(), folder)


@given(st.text('<>/="!&;:- \n[]ABCDEFGHIJKLMNOPenCPNWthrRoutigBalFm.?x#0123456789', max_size=200))
@example("[" * 100_000)
@example('{"a":' * 100_000)
@example("<a>" * 100_000)
@example('<!DOCTYPE a [<!ENTITY b "bb"><!ENTITY c "&b;&b;">]><a>&c;</a>')
@example('<OpenCPNWeatherRoutingBoat><Polar FileName="../../boat.csv"/></OpenCPNWeatherRoutingBoat>')
@example("PolarDiagramMultiSails\nTWS\n6,8\nA\nTWA\n45,90\nBSP\n1,2\n")
@example("PolarDiagramTable\nTWS\n6,8\nTWA\n45,90\nBSP\n1,2\n3,4\n5")
def test_hostile_forms_raise_nothing_but_input_errors(folder: Path, content: str) -> None:
    read_or_refuse(content.encode(), folder)
    read_or_refuse(b"<OpenCPNWeatherRoutingBoat>" + content.encode(), folder)
    read_or_refuse(b"PolarDiagramMultiSails\nTWS\n6,8\n" + content.encode(), folder)
    read_or_refuse(b"TWS,TWA,BSP\n6,45,4\n" + content.encode(), folder)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("hostile")


def read_or_refuse(content: bytes, folder: Path) -> None:
    path = folder / "boat.csv"
    path.write_bytes(content)
    with suppress(InputError):
        polar = read_polar(path)
        assert np.isfinite(polar.speed(5.0, np.arange(181.0))).all()


# Its polar file does not lie beside it.
REFUSED = {"Boat.xml": "the boat's polar file 'Test-TWS-0-20\\+60.pol' does not lie beside it"}


def test_every_real_file_is_read_or_refused_rightly(shared_data: Path) -> None:
    files = [p for p in sorted((shared_data / "polars/formats").rglob("*")) if p.is_file()]
    assert len(files) > 15
    for path in files:
        if path.name in REFUSED:
            with pytest.raises(InputError, match=REFUSED[path.name]):
                read_polar(path)
        else:
            polar = read_polar(path)
            assert 3.0 < polar.speed_table[~np.isnan(polar.speed_table)].max() / MS_PER_KNOT < 50.0


def test_the_sites_export_has_the_certificates_figures(shared_data: Path) -> None:
    for path in sorted((shared_data / "polars/orc/csv_extended").glob("*.csv")):
        exported = read_polar(path)
        shipped = Path(__file__).parents[2] / "polars" / f"{path.stem.replace('_nospi', '-no-spinnaker')}.csv"
        if shipped.exists():
            ours = read_polar(shipped)
            np.testing.assert_allclose(exported.tws, ours.tws)
            np.testing.assert_allclose(exported.twa, ours.twa, err_msg=path.name)
            np.testing.assert_allclose(
                exported.speed_table, ours.speed_table, atol=0.02 * MS_PER_KNOT, err_msg=path.name
            )
