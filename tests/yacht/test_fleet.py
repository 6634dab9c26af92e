"""The yachts one can choose from."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

from seacruise.errors import InputError
from seacruise.resources import resource_path
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.files import write_polar
from seacruise.yacht.fleet import Fleet, find_yacht, load_fleet
from tests.yacht.polars import polar_kn

GOOD = "twa/tws;6;8\n45;4;5\n90;5;6\n150;4;5\n"
PUBLISHED = (
    "Edel 660",
    "Bavaria 46 Cruiser",
    "Bavaria 40 Cruiser",
    "Delphia 47",
    "Cookson 50",
    "Bavaria C50",
)


@pytest.fixture(scope="module")
def shipped() -> Fleet:
    return load_fleet([resource_path("polars")])


def test_all_shipped_yachts_are_read(shipped: Fleet) -> None:
    assert shipped.problems == ()
    assert len(shipped.yachts) >= 30
    assert set(PUBLISHED) <= set(shipped.yachts)
    assert all(polar.source.startswith("ORC certificate ") for polar in shipped.yachts.values())
    assert [name for name, polar in shipped.yachts.items() if polar.name != name] == []


def test_yachts_are_in_the_order_of_their_names(shipped: Fleet) -> None:
    names = [name.casefold().replace("-", " ") for name in shipped.yachts]
    assert names == sorted(names)


def test_shipped_speeds_are_those_of_yachts(shipped: Fleet) -> None:
    for polar in shipped.yachts.values():
        reach_kn = float(polar.speed(12 * MS_PER_KNOT, 90.0)) / MS_PER_KNOT
        assert 4.0 < reach_kn < 14.0, polar.name


def test_published_figures_are_there(shipped: Fleet) -> None:
    polar = shipped.yachts["Bavaria 46 Cruiser"]
    assert float(polar.speed(10 * MS_PER_KNOT, 52.0)) / MS_PER_KNOT == pytest.approx(7.30)
    assert float(polar.speed(20 * MS_PER_KNOT, 120.0)) / MS_PER_KNOT == pytest.approx(10.20)
    beat = float(polar.speed(10 * MS_PER_KNOT, 42.0)) * np.cos(np.radians(42.0)) / MS_PER_KNOT
    assert beat == pytest.approx(4.89, abs=0.001)


def test_certificates_speeds_are_shipped(shared_data: Path, shipped: Fleet) -> None:
    import json

    by_file = {polar.path.stem: polar for polar in shipped.yachts.values() if polar.path}
    checked = 0
    for path in sorted((shared_data / "polars/orc/json").glob("*.json")):
        polar = by_file.get(path.stem.replace("_nospi", "-no-spinnaker"))
        if polar is None:
            continue
        vpp = json.loads(path.read_text(encoding="utf-8"))["vpp"]
        winds = np.array(vpp["speeds"]) * MS_PER_KNOT
        for angle in vpp["angles"]:
            np.testing.assert_allclose(polar.speed(winds, angle) / MS_PER_KNOT, vpp[str(angle)], rtol=1e-9)
        beat = np.array(vpp["beat_angle"])
        vmg = polar.speed(winds, beat) * np.cos(np.radians(beat)) / MS_PER_KNOT
        np.testing.assert_allclose(vmg, vpp["beat_vmg"], atol=2e-4)
        checked += 1
    assert checked == len(shipped.yachts)


def test_a_bad_file_never_stops_the_others(tmp_path: Path) -> None:
    (tmp_path / "bad.csv").write_text("twa/tws;6;8\n45;4;fast\n")
    (tmp_path / "good.csv").write_text(GOOD)
    (tmp_path / "empty.pol").write_text("")
    (tmp_path / "notes.md").write_text("not a polar")
    (tmp_path / ".hidden.csv").write_text("not a polar")
    (tmp_path / "folder.csv").mkdir()
    fleet = load_fleet([tmp_path])
    assert list(fleet.yachts) == ["good"]
    assert len(fleet.problems) == 3
    assert any("bad.csv, line 2, cell 3: 'fast' is not a number" in problem for problem in fleet.problems)


def test_the_sailors_yacht_takes_the_place_of_a_shipped_one(tmp_path: Path, shipped: Fleet) -> None:
    write_polar(polar_kn((6, 8), (45, 90), ((1, 2), (3, 4)), "bavaria 46 CRUISER"), tmp_path / "mine.csv")
    fleet = load_fleet([resource_path("polars"), tmp_path])
    assert len(fleet.yachts) == len(shipped.yachts)
    assert len(find_yacht("Bavaria 46 Cruiser", fleet).tws) == 2


def test_two_files_of_one_name_in_a_folder_are_told(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("# name: Albatros\n" + GOOD)
    (tmp_path / "b.csv").write_text("# name: ALBATROS\n" + GOOD)
    fleet = load_fleet([tmp_path])
    assert list(fleet.yachts) == ["Albatros"]
    assert "b.csv: the yacht ALBATROS is also in a.csv" in fleet.problems[0]


def test_a_folder_that_is_not_there_is_passed_over(tmp_path: Path) -> None:
    assert load_fleet([tmp_path / "none"]) == Fleet()


def test_a_file_in_place_of_a_folder_is_told(tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.write_text("x")
    assert "cannot be read" in load_fleet([path]).problems[0]


@pytest.mark.parametrize(
    ("typed", "name"),
    [
        ("Bavaria 46 Cruiser", "Bavaria 46 Cruiser"),
        ("bavaria 46 cruiser", "Bavaria 46 Cruiser"),
        ("hallberg rassy 40", "Hallberg-Rassy 40"),
        ("X332", "X-332"),
        ("edel", "Edel 660"),
        ("Cookson", "Cookson 50"),
        ("bavaria c50 no spinnaker", "Bavaria C50 (no spinnaker)"),
    ],
)
def test_yachts_are_found_as_typed(shipped: Fleet, typed: str, name: str) -> None:
    assert find_yacht(typed, shipped).name == name


@pytest.mark.parametrize(
    ("typed", "sentence"),
    [
        ("", "No yacht was named"),
        ("Bavari 46 Cruiser", "did you mean Bavaria 46 Cruiser"),
        ("Bavaria", "More than one yacht fits 'Bavaria'"),
        ("Titanic", "There is no yacht 'Titanic'"),
        ("🚤", "There is no yacht"),
        ("nowhere/boat.csv", "There is no polar file"),
        ("boat.pol", "There is no polar file"),
    ],
)
def test_yachts_that_are_not_there(shipped: Fleet, typed: str, sentence: str) -> None:
    with pytest.raises(InputError) as caught:
        find_yacht(typed, shipped)
    assert sentence in str(caught.value)


def test_a_path_is_read(tmp_path: Path, shipped: Fleet) -> None:
    path = tmp_path / "Moja łódź.csv"
    path.write_text(GOOD)
    assert find_yacht(str(path), shipped).name == "Moja łódź"
    bare = tmp_path / "polar_without_suffix"
    shutil.copy(path, bare)
    assert find_yacht(str(bare), shipped).name == "polar without suffix"
    path.write_text("nonsense")
    with pytest.raises(InputError, match="line 1"):
        find_yacht(str(path), shipped)
