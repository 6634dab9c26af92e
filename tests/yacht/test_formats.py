"""Every format that sailors have, read from what they have; and written so that it is read the same."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from seacruise.errors import InputError
from seacruise.resources import resource_path
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.files import FORMATS, read_points, read_polar, write_polar
from seacruise.yacht.polar import Polar
from seacruise.yacht.sails import sail_at
from seacruise.yacht.writers import polar_text
from tests.yacht.polars import NAN, polar_kn, polars, small

KN = MS_PER_KNOT
EMPTY_CELLS = ("seacruise", "json", "opencpn", "expedition", "points")


def read(tmp_path: Path, content: str, name: str = "boat.csv") -> Polar:
    path = tmp_path / name
    path.write_text(content, encoding="utf-8")
    return read_polar(path)


def speed_kn(polar: Polar, tws_kn: float, twa: float) -> float:
    return float(polar.speed(tws_kn * KN, twa)) / KN


# ------------------------------------------------------------------------------------- read


@pytest.mark.parametrize(
    ("file", "tws_kn", "twa", "speed"),
    [
        ("expedition/Santa_Cruz_50.txt", 10, 110, 9.20),
        ("expedition/Santa_Cruz_50.txt", 24, 168, 10.89),
        ("expedition/NF_bangTWS.txt", 4, 40, 3.9),
        ("gweatherrouting/first317.pol", 8, 45, 5.7),
        ("hrosailing/array_format_example.csv", 14, 120, 6.62),
        ("hrosailing/cloud_hro_format_example.csv", 8, 52, 4.48),
        ("hrosailing/multisails_hro_format_example.csv", 20, 120, 9.74),
        ("hrosailing/opencpn_format_example.csv", 12, 75, 5.66),
        ("hrosailing/orc_format_example.csv", 12, 75, 5.66),
        ("maxsea_tab/Alberg35_TWA_header.pol", 20, 150, 7.3),
        ("misc/Arcona_400_tab.csv", 12, 150, 7.0),
        ("misc/Facil_30_bom_crlf.txt", 6, 52, 4.89),
        ("misc/J80_enl_ORC_WindVelocity.txt", 20, 135, 10.24),
        ("misc/OE36_TWSknop_semicolon.txt", 20, 150, 7.65),
        ("opencpn/Bavaria_40Cruiser.pol", 8, 45, 5.3),
        ("opencpn/Example-24-60_semicolon.pol", 34 - 2, 90, 3.4),
        ("opencpn/deerfoot_64k_crlf.pol", 26, 120, 14.9),
        ("orc/jieter_extended_bavaria-40.csv", 24, 75, 8.48),
        ("qtvlm/boat_BP5_bom.csv", 20, 45, 20.24),
        ("qtvlm/boat_figaro2.csv", 6, 5, 0.45),
        ("router-lib/sample.pol", 40, 180, 12.3),
    ],
)
def test_a_figure_of_each_real_file(
    shared_data: Path, file: str, tws_kn: float, twa: float, speed: float
) -> None:
    polar = read_polar(shared_data / "polars/formats" / file)
    assert speed_kn(polar, tws_kn, twa) == pytest.approx(speed, abs=1e-9)


@pytest.mark.parametrize(
    ("file", "tws_kn", "twa", "vmg"),
    [
        ("misc/J80_enl_ORC_WindVelocity.txt", 10, 40.8, 4.28),
        ("misc/J80_enl_ORC_WindVelocity.txt", 10, 150.5, -5.11),
        ("misc/J80_enl_ORC_WindVelocity.txt", 20, 39.1, 4.66),
        ("misc/OE36_TWSknop_semicolon.txt", 6, 44.2, 3.03),
        ("misc/OE36_TWSknop_semicolon.txt", 20, 37.1, 4.73),
    ],
)
def test_beat_and_run_rows_in_two_languages(
    shared_data: Path, file: str, tws_kn: float, twa: float, vmg: float
) -> None:
    polar = read_polar(shared_data / "polars/formats" / file)
    assert speed_kn(polar, tws_kn, twa) * np.cos(np.radians(twa)) == pytest.approx(vmg, abs=1e-9)


def test_97_certificates_in_json_have_the_figures_of_the_sites_export(shared_data: Path) -> None:
    files = sorted((shared_data / "polars/orc/json").glob("*.json"))
    assert len(files) == 97
    for path in files:
        certificate = read_polar(path)
        export = read_polar(shared_data / "polars/orc/csv_extended" / f"{path.stem}.csv")
        np.testing.assert_allclose(certificate.tws, export.tws)
        np.testing.assert_allclose(certificate.twa, export.twa, err_msg=path.name)
        # The export rounds beat and run speeds to a hundredth of a knot.
        np.testing.assert_allclose(certificate.speed_table, export.speed_table, atol=0.0051 * KN)
        assert certificate.source.startswith("ORC certificate ")


VIRTUAL_REGATTA: dict[str, Any] = {
    "_id": 3,
    "label": "Figaro",
    "globalSpeedRatio": 1.01,
    "tws": [0, 6, 12],
    "twa": [30, 90, 160],
    "sail": [
        {"id": 1, "name": "JIB", "speed": [[0, 3, 5], [0, 5, 6], [0, 3, 4]]},
        {"id": 2, "name": "LIGHT_GNK", "speed": [[0, -0.02, 0], [0, 4, 7], [0, 4, 6]]},
        {"id": 4, "name": "CODE_0", "speed": [[0, 0, 0]] * 3},
    ],
}


@pytest.mark.parametrize("wrapped", [False, True])
def test_virtual_regatta(tmp_path: Path, wrapped: bool) -> None:
    content = {"scriptData": {"polar": VIRTUAL_REGATTA}} if wrapped else VIRTUAL_REGATTA
    polar = read(tmp_path, json.dumps(content), "boat.txt")
    assert polar.name == "Figaro"
    assert [sail.name for sail in polar.sails] == ["Jib", "Light gnk"]
    assert speed_kn(polar, 6, 90) == pytest.approx(5 * 1.01)
    assert speed_kn(polar, 12, 160) == pytest.approx(6 * 1.01)
    assert polar.sails[1].speed_table.min() == 0.0
    assert sail_at(polar, 12 * KN, 30.0) == "Jib"
    assert sail_at(polar, 12 * KN, 90.0) == "Light gnk"


MULTI_SAILS = (
    "PolarDiagramMultiSails\nTWS\n6,8\nGenoa\nTWA\n45,90\nBSP\n4,5\n5,6\n"
    "Spinnaker\nTWA\n90,150\nBSP\n6,5.5\n4,5\n"
)


def test_hrosailings_several_sails(tmp_path: Path) -> None:
    polar = read(tmp_path, MULTI_SAILS)
    assert [sail.name for sail in polar.sails] == ["Genoa", "Spinnaker"]
    assert speed_kn(polar, 6, 90) == pytest.approx(6)
    assert speed_kn(polar, 8, 90) == pytest.approx(6)
    assert sail_at(polar, 8 * KN, 89.0) == "Genoa"


def test_hrosailings_table(tmp_path: Path) -> None:
    polar = read(tmp_path, "PolarDiagramTable\nTWS:\n6,8\nTWA:\n45,90\nBSP:\n4,5\n5,6\n")
    assert polar.sails == ()
    np.testing.assert_allclose(polar.speed_table / KN, [[4, 5], [5, 6]])


def test_hrosailings_table_of_both_tacks_is_their_mean(tmp_path: Path) -> None:
    polar = read(
        tmp_path, "PolarDiagramTable\nTWS\n6,8\nTWA\n0,45,90,270,315\nBSP\n0,0\n4,5\n5,6\n6,7\n3,4\n"
    )
    np.testing.assert_allclose(polar.twa, [0, 45, 90])
    np.testing.assert_allclose(polar.speed_table / KN, np.array([[0, 0], [3.5, 4.5], [5.5, 6.5]]))


def test_house_format_of_several_sails(tmp_path: Path) -> None:
    polar = read(
        tmp_path,
        "# name: Two\n# sail: Genoa\ntwa/tws;6;8\n45;4;5\n90;5;6\n"
        "# sail: Spinnaker\ntwa/tws;6;8;10\n90;6;5.5;7\n150;4;5;6\n",
    )
    assert polar.name == "Two"
    assert [sail.name for sail in polar.sails] == ["Genoa", "Spinnaker"]
    np.testing.assert_allclose(polar.tws / KN, [6, 8, 8.5, 10])


@pytest.mark.parametrize("place", ["", "polars"])
def test_an_opencpn_boat_is_the_best_of_its_polars(tmp_path: Path, place: str) -> None:
    (tmp_path / place).mkdir(exist_ok=True)
    (tmp_path / place / "jib.pol").write_text("TWA\\TWS\t6\t8\n45\t4\t5\n90\t5\t6\n")
    (tmp_path / place / "spi.pol").write_text("TWA\\TWS\t6\t8\n90\t6\t7\n150\t4\t5\n")
    boat = (
        '<?xml version="1.0" encoding="utf-8" ?>\n<!-- ours -->\n<OpenCPNWeatherRoutingBoat version="1.10">'
        '<Polar FileName="Example/jib.pol" CrossOverPercentage="0" /><Polar FileName="C:\\polars\\spi.pol"/>'
        "</OpenCPNWeatherRoutingBoat>"
    )
    polar = read(tmp_path, boat, "My_boat.xml")
    assert polar.name == "My boat"
    assert sail_at(polar, 6 * KN, 90.0) == "spi"
    assert sail_at(polar, 6 * KN, 45.0) == "jib"
    one = read(tmp_path, boat.replace('<Polar FileName="C:\\polars\\spi.pol"/>', ""), "one.xml")
    assert one.sails == ()
    assert speed_kn(one, 8, 90) == pytest.approx(6)


@pytest.mark.parametrize(
    "content",
    [
        pytest.param("\t6\t8\n45\t4\t5\n90\t5\t6\n", id="empty corner (PredictWind)"),
        pytest.param("6 8\n45 4 5\n90 5 6\n", id="no corner"),
        pytest.param("0;6;8\n45;4;5\n90;5;6\n", id="zero in the corner (Sailonline)"),
    ],
)
def test_tables_without_a_corner(tmp_path: Path, content: str) -> None:
    polar = read(tmp_path, content)
    np.testing.assert_allclose(polar.tws / KN, [6, 8])
    np.testing.assert_allclose(polar.speed_table / KN, [[4, 5], [5, 6]])


def test_points_in_any_order_are_a_table_if_they_can_be(tmp_path: Path) -> None:
    polar = read(tmp_path, "TWS,TWA,BSP\n8,90,6\n6,90,5\n8,45,5\n6,45,4\n")
    np.testing.assert_allclose(polar.speed_table / KN, [[4, 5], [5, 6]])


def test_scattered_points_are_the_surface_through_them(tmp_path: Path) -> None:
    path = tmp_path / "cloud.csv"
    lines = [f"{6 + k * 0.37},{45 + k * 7 % 110},{4 + k * 0.1}" for k in range(30)]
    path.write_text("\n".join(["# name: Cloud", "TWS,TWA,BSP", *lines, "7,90,5", "7,90,5.4"]))
    points = read_points(path)
    assert points.tws.shape == (32,)
    assert float(points.speed(7 * KN, 90.0)) / KN == pytest.approx(5.2)
    polar = read_polar(path)
    assert polar.name == points.name == "Cloud"
    inside = ~np.isnan(polar.speed_table)
    assert polar.speed_table[inside].max() <= points.boat_speed.max()
    with pytest.raises(InputError, match="is no list of points"):
        read_points(write(tmp_path / "table.csv", small()))


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        ('{"label": 1}', "line 1: this JSON is no polar"),
        ('{"tws_kn": [6, 8', "line 1, column 17: this is not JSON"),
        ('{"a":\n 1,\n}', "line 3, column 1: this is not JSON"),
        ('{"tws_kn": NaN}', "line 1: NaN is not a number"),
        ('{"tws_kn": [6, 8], "twa_deg": 5}', "twa_deg: a list of figures is missing"),
        (
            '{"tws_kn": [6, 8], "twa_deg": [45, 90], "boat_speed_kn": [[1, 2]]}',
            "boat_speed_kn: 1 rows for 2 wind angles",
        ),
        (
            '{"tws_kn": [6, 8], "twa_deg": [45, 90], "boat_speed_kn": [[1, 2], [3]]}',
            "boat_speed_kn, row 2: 1 figures for 2 wind speeds",
        ),
        (
            '{"tws_kn": [6, 8], "twa_deg": [45, 90], "boat_speed_kn": [[1, 2], [3, "x"]]}',
            "boat_speed_kn, row 2, cell 2: 'x' is not a number",
        ),
        (
            '{"tws_kn": [6, 8], "twa_deg": [45, 90], "boat_speed_kn": [[1, 2], [3, -0.1]]}',
            "boat_speed_kn, row 2, cell 2: a boat speed of -0.1",
        ),
        ('{"sail": [], "tws": [6], "twa": [45]}', "sail: there is no sail with a boat speed above zero"),
        ('{"sail": [{"name": "JIB", "speed": [[-3, 2]]}], "tws": [6, 8], "twa": [45]}', "boat speed of -3"),
        (
            '{"vpp": {"speeds": [6, 8], "angles": [52], "60": [1, 2]}}',
            "vpp, 52: a list of figures is missing",
        ),
        ("<a><b></a>", "line 1: this is not XML that can be read"),
        ("<a/>", "line 1: this XML is no OpenCPN boat"),
        ("<!DOCTYPE a><a/>", "line 1: this XML declares things of its own"),
        ("PolarDiagramMultiSails\nSails:A:B\n", "line 2: the sails are in files of their own"),
        ("PolarDiagramMultiSails\nTWS\n6,8\n", "line 3: the angles and boat speeds are missing"),
        ("PolarDiagramTable\nTWS\n6,8\nBSP\n", "line 4: TWA should be here"),
        ("PolarDiagramTable\nTWS\n6,8\nTWA\n45\nBSP\n1\n", "line 7: 1 figures for 2 wind speeds"),
        ("PolarDiagramTable\nTWS\n6,8\nTWA\n45\nBSP\n", "line 6: the file ends where"),
        ("twa/tws;" + ";".join(map(str, range(110))) + "\n45" + ";1" * 111, "line 2: 111 figures"),
        (
            "\n".join(["TWA;6;8", *(f"{k / 10};1;2" for k in range(1001))]),
            "line 1: 2 wind speeds and 1001 angles are more than a polar has",
        ),
        (
            "\n".join(f"# sail: {k}\nTWA;6;8\n45;1;2\n90;2;3" for k in range(21)),
            "line 1: 21 sails are more than a yacht carries",
        ),
        (MULTI_SAILS.replace("Spinnaker", "Genoa"), "line 1: two sails have the name Genoa"),
        ("# sail: A\ntwa/tws;6;8\n45;4;5\n90;5;6\n# sail: B\n45;1;2\n", "line 6: the header of B is missing"),
        ("TWS,TWA,BSP\n6,45,4\n6,190,5\n", "line 3, cell 3: a wind angle of 190"),
        ("TWS,TWA,BSP\n", "line 1: there is a header but no points"),
        ("TWS,TWA,BSP\n6,45,4\n6,45,5\n", "line 1: a polar needs points at two wind speeds"),
    ],
)
def test_what_is_wrong_is_said_with_its_place(tmp_path: Path, content: str, sentence: str) -> None:
    with pytest.raises(InputError) as caught:
        read(tmp_path, content)
    assert sentence in str(caught.value)
    assert str(caught.value).startswith("boat.csv, ")


# ------------------------------------------------------------------------------------- written


def write(path: Path, polar: Polar, form: str = "seacruise") -> Path:
    write_polar(polar, path, form=form)
    return path


def assert_same_table(a: Polar, b: Polar) -> None:
    np.testing.assert_array_equal(a.tws, b.tws)
    np.testing.assert_array_equal(a.twa, b.twa)
    np.testing.assert_array_equal(a.speed_table, b.speed_table)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("polars")


def there_and_back(polar: Polar, form: str, folder: Path) -> Polar:
    # Not written atomically, which waits for the disk.
    (folder / "polar.txt").write_bytes(polar_text(polar, form).encode())
    return read_polar(folder / "polar.txt")


@pytest.mark.parametrize("form", FORMATS)
@given(polar=polars())
def test_what_is_written_is_read_in_every_format(form: str, folder: Path, polar: Polar) -> None:
    filled = np.nan_to_num(polar.speed_table)
    assume((filled > 0).any() and (~np.isnan(polar.speed_table)).sum(axis=0).min() > 1)
    once = there_and_back(polar, form, folder)
    assert_same_table(there_and_back(once, form, folder), once)
    rows = ~np.isnan(polar.speed_table).all(axis=1) if form in EMPTY_CELLS else np.full(len(polar.twa), True)
    expected = polar.speed_table[rows]
    if form not in EMPTY_CELLS:
        there = polar.speed(polar.tws, polar.twa[:, np.newaxis])
        expected = np.where(np.isnan(expected), there, expected)
    np.testing.assert_allclose(once.tws, polar.tws, atol=1e-6)
    np.testing.assert_allclose(once.twa, polar.twa[rows])
    np.testing.assert_allclose(once.speed_table, expected, atol=1e-6)


@pytest.mark.parametrize("form", FORMATS)
def test_shipped_yachts_survive_every_format(form: str, folder: Path) -> None:
    for path in sorted(resource_path("polars").glob("*.csv"))[::9]:
        yacht = read_polar(path)
        again = there_and_back(yacht, form, folder)
        winds, angles = yacht.tws, np.arange(30.0, 181.0, 3.0)[:, np.newaxis]
        tolerance = 1e-6 if form in EMPTY_CELLS else 0.02
        np.testing.assert_allclose(again.speed(winds, angles), yacht.speed(winds, angles), atol=tolerance)
        if form in EMPTY_CELLS:
            assert_same_table(there_and_back(again, form, folder), again)


@pytest.mark.parametrize("form", ["seacruise", "json"])
def test_sails_survive(form: str, tmp_path: Path) -> None:
    polar = read(tmp_path, MULTI_SAILS)
    again = read_polar(write(tmp_path / "again.csv", polar, form))
    assert again.name == "boat"
    assert [sail.name for sail in again.sails] == ["Genoa", "Spinnaker"]
    for one, other in zip(polar.sails, again.sails, strict=True):
        assert_same_table(one, other)
    assert_same_table(polar, again)


def test_the_figures_of_a_text_stay_as_they_are(tmp_path: Path) -> None:
    text = "# source: mine\n# name: Mine\ntwa/tws;6;8.5\n45.5;4.1;5.25\n90;5;\n"
    assert polar_text(read(tmp_path, text)) == text


def test_what_other_programs_get() -> None:
    polar = polar_kn((6, 8), (45, 90), ((4, NAN), (5, 6)))
    assert polar_text(polar, "opencpn") == "TWA\\TWS;6;8\n45;4;\n90;5;6\n"
    assert polar_text(polar, "expedition") == "!Expedition polar\r\n6\t45\t4\t90\t5\r\n8\t90\t6\r\n"
    assert polar_text(polar, "points").splitlines()[2:] == ["TWS,TWA,BSP", "6,45,4", "6,90,5", "8,90,6"]
    filled = polar_text(polar, "maxsea").split("\r\n")
    assert filled[0] == "TWA\t6\t8"
    assert float(filled[1].split("\t")[2]) == pytest.approx(speed_kn(polar, 8, 45), abs=1e-6)
    assert polar_text(polar, "qtvlm").startswith("TWA\\TWS;6;8\n45;4;")
    assert polar_text(polar, "hrosailing").startswith("TWA\\TWS\t6\t8\n45\t4\t")


def test_an_unknown_format_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="There is no polar format 'xls'; choose one of seacruise, json"):
        write_polar(small(), tmp_path / "a.xls", form="xls")
    assert not list(tmp_path.iterdir())


@given(st.text(max_size=30), st.sampled_from(FORMATS))
def test_any_name_can_be_written(folder: Path, name: str, form: str) -> None:
    plain, named = small(), dataclasses.replace(small(), name=name, source=name)
    assert_same_table(there_and_back(named, form, folder), there_and_back(plain, form, folder))
