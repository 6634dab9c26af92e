"""The bundle of `make bundle` starts and works where there is no Python; see docs/bundle.md.

It takes minutes to build, so these tests run where it has been built already and is newer than the sources.
With ``SEACRUISE_BUNDLE=build`` they build it first; with the path of a program there, they try that one.
"""

from __future__ import annotations

import importlib.util
import json
import os
import shutil
import struct
import subprocess
import sys
import zipfile
from collections.abc import Callable, Sequence
from datetime import UTC, datetime, timedelta
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any

import pytest

REPOSITORY = Path(__file__).resolve().parent.parent
PROGRAM = (
    REPOSITORY / "build" / "bundle" / "seacruise" / ("seacruise.exe" if os.name == "nt" else "seacruise")
)

Run = Callable[..., subprocess.CompletedProcess[str]]

PLAN = ["plan", "--from", "Gdynia", "--to", "Visby", "--yacht", "Bavaria 46 Cruiser", "--format", "json"]
SAMPLE = [*PLAN, "--forecast", "sample", "--depart", "2016-11-20T06:00Z"]


@pytest.fixture(scope="session")
def program() -> Path:
    """The bundled program."""
    wanted = os.environ.get("SEACRUISE_BUNDLE", "")
    if wanted == "build":
        subprocess.run([sys.executable, "tools/bundle/build.py"], cwd=REPOSITORY, check=True)
    found = Path(wanted) if wanted not in {"", "build"} else PROGRAM
    if not found.is_file():
        if wanted:
            pytest.fail(f"SEACRUISE_BUNDLE={wanted}: there is no program {found}")
        pytest.skip("NO BUNDLE: nothing in build/bundle (make bundle, or SEACRUISE_BUNDLE=build)")
    sources = max(path.stat().st_mtime for path in (REPOSITORY / "seacruise").rglob("*.py"))
    if not wanted and found.stat().st_mtime < sources:
        pytest.skip("OLD BUNDLE: sources have changed since it was built (make bundle again)")
    return found


@pytest.fixture(scope="session")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Home of a sailor who has just unpacked it; shared, since the sea is drawn once."""
    return tmp_path_factory.mktemp("sailor")


@pytest.fixture
def run(program: Path, home: Path, tmp_path: Path) -> Run:
    """Start the program with next to no environment, in a folder of its own."""
    env = {"HOME": str(home), "SEACRUISE_HOME": str(home / "seacruise"), "PATH": str(tmp_path / "no-python")}
    for service in ("STORMGLASS", "OPENMETEO", "METNO"):
        env[f"SEACRUISE_{service}_URL"] = "http://127.0.0.1:9"
    if os.name == "nt":
        env |= {name: os.environ[name] for name in ("SYSTEMROOT", "TEMP") if name in os.environ}

    def start(*words: str, code: int = 0, **more: str) -> subprocess.CompletedProcess[str]:
        answer = subprocess.run(
            [str(program), *words],
            env=env | more,
            cwd=tmp_path,
            capture_output=True,
            encoding="utf-8",
            timeout=600,
            check=False,
        )
        assert answer.returncode == code, answer.stdout + answer.stderr
        assert "Traceback" not in answer.stderr
        return answer

    return start


def machine_code(home: Path) -> dict[str, int]:
    kernels = home / "seacruise" / "cache" / "kernels"
    return {str(path.relative_to(kernels)): path.stat().st_mtime_ns for path in kernels.rglob("*.nb?")}


def shipped_machine_code(program: Path) -> set[str]:
    with zipfile.ZipFile(program.parent / "_internal" / "kernels.zip") as archive:
        return {str(Path(name)) for name in archive.namelist() if Path(name).suffix.startswith(".nb")}


def works_here() -> bool:
    """Tell whether this processor takes the machine code that bundles bring."""
    from numba.core.codegen import get_host_cpu_features

    from seacruise.compiled import _ABILITIES

    abilities = get_host_cpu_features().split(",")  # type: ignore[no-untyped-call]
    return all(f"+{name}" in abilities for name in _ABILITIES)


def duration_h(answer: subprocess.CompletedProcess[str]) -> float:
    passage: dict[str, Any] = json.loads(answer.stdout)
    assert passage["schema"].startswith("seacruise.passage/")
    return float(passage["duration_h"])


def by_python(words: Sequence[str]) -> float:
    """Duration that the program of this checkout finds [h]."""
    answer = subprocess.run(
        [sys.executable, "-m", "seacruise", *words],
        cwd=REPOSITORY,
        capture_output=True,
        encoding="utf-8",
        check=True,
    )
    return duration_h(answer)


def test_it_says_its_version_and_loads_nothing_from_elsewhere(run: Run) -> None:
    import seacruise

    assert run("--version").stdout == f"SeaCruise {seacruise.__version__}\n"
    # What a sailor's own Python has set up must not leak in.
    assert "Gdynia" in run("ports", "list", PYTHONPATH="nowhere", PYTHONHOME="nowhere").stdout


def test_a_passage_is_the_one_of_the_checkout_and_kernels_are_kept(
    run: Run, program: Path, home: Path, tmp_path: Path
) -> None:
    first = duration_h(run(*SAMPLE))
    assert first == pytest.approx(by_python(SAMPLE), abs=1e-3)
    compiled = machine_code(home)
    assert len(compiled) > 20
    if works_here():
        # It brings all that a passage needs: nothing was compiled.
        assert set(compiled) == shipped_machine_code(program)
    # Again: nothing is compiled, or kept under another name.
    exports = {name: str(tmp_path / f"passage.{name}") for name in ("gpx", "pdf")}
    again = run(
        *SAMPLE, "--gpx", exports["gpx"], "--pdf", exports["pdf"], "--chart", str(tmp_path / "chart.png")
    )
    # A library that misses a part of itself warns.
    assert "Warn" not in again.stderr
    assert machine_code(home) == compiled
    assert (tmp_path / "chart.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "passage.pdf").read_bytes().startswith(b"%PDF")
    assert "<gpx" in (tmp_path / "passage.gpx").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    "name", ["RELOCATED_gfs025_192h_to_baltic.grb", "RELOCATED_gfs025_120h_to_baltic.nc"]
)
def test_weather_is_read_in_a_process_of_its_own(run: Run, shared_data: Path, name: str) -> None:
    file = shared_data / "weather" / "baltic" / name
    words = [*PLAN, "--forecast", str(file), "--depart", "2018-05-01T06:00Z"]
    assert duration_h(run(*words)) == pytest.approx(by_python(words), abs=1e-3)


def test_a_grib_file_of_the_second_edition_is_read(run: Run, shared_data: Path) -> None:
    file = shared_data / "weather" / "grib" / "gfs_southatlantic_20251111_single.grib2"
    # Read and understood: what it lacks is the Baltic.
    words = [*PLAN, "--forecast", str(file), "--depart", "2025-11-11T18:00Z"]
    assert json.loads(run(*words, code=3).stdout)["reason"] == "outside-forecast"


def test_what_is_no_weather_is_told_in_a_sentence(run: Run, tmp_path: Path) -> None:
    (tmp_path / "wind.grb").write_bytes(b"GRIB" + b"\xff" * 400)
    answer = run(*PLAN, "--forecast", "wind.grb", "--depart", "2018-05-01T06:00Z", code=2)
    assert "wind.grb" in json.loads(answer.stdout)["message"]


def test_certificates_are_there_and_a_service_that_refuses_is_a_sentence(run: Run) -> None:
    soon = datetime.now(UTC) + timedelta(hours=3)
    # requests looks for the certificates before it connects.
    answer = run(
        *PLAN,
        *("--forecast", "open-meteo", "--depart", f"{soon:%Y-%m-%dT%H:%MZ}"),
        code=4,
        SEACRUISE_OPENMETEO_URL="https://127.0.0.1:9",
    )
    assert json.loads(answer.stdout)["reason"] == "no-network"


def test_a_polar_is_drawn(run: Run, tmp_path: Path) -> None:
    run("polar", "plot", "Bavaria 46 Cruiser", "--out", "polar.svg")
    assert "<svg" in (tmp_path / "polar.svg").read_text(encoding="utf-8")


@pytest.mark.parametrize("platform", ["offscreen", "xcb"])
def test_the_window_opens_and_draws(run: Run, tmp_path: Path, platform: str) -> None:
    more = {"QT_QPA_PLATFORM": platform, "LC_ALL": "C.UTF-8"}
    if platform == "xcb":
        if not sys.platform.startswith("linux") or not os.environ.get("DISPLAY"):
            pytest.skip("NO DISPLAY: start it under xvfb-run, or on a desktop")
        # xvfb-run, and many a desktop, lets in only who knows its cookie.
        more |= {name: os.environ[name] for name in ("DISPLAY", "XAUTHORITY") if name in os.environ}
    picture = tmp_path / "window.png"
    voyage = ["--from", "Gdynia", "--to", "Visby", "--forecast", "sample", "--depart", "2016-11-20T06:00Z"]
    answer = run("window", *voyage, "--screenshot", str(picture), "--size", "1280x800", **more)
    content = picture.read_bytes()
    assert struct.unpack(">II", content[16:24]) == (1280, 800)
    # An empty window of that size takes 10 kB; a chart with a passage and the form beside it, far more.
    assert len(content) > 60_000
    assert "Could not find the Qt platform plugin" not in answer.stderr


def test_what_must_be_in_it_is_in_it_and_nothing_of_ours_leaks(program: Path) -> None:
    inside = program.parent / "_internal"
    for name in ("polars/bavaria-46-cruiser.csv", "ports.csv", "certifi/cacert.pem"):
        assert (inside / name).is_file(), name
    for file in (REPOSITORY / "assets").rglob("*.*"):
        assert (inside / file.relative_to(REPOSITORY)).is_file(), file
    words = {file.stem for file in inside.rglob("qt*.qm")}
    assert {"qtbase_pl"} <= words <= {"qtbase_pl", "qtbase_en"}
    assert "PySide6" in (program.parent / "licenses" / "README.txt").read_text(encoding="utf-8")
    broken = [path for path in inside.rglob("*") if path.is_symlink() and not path.exists()]
    assert not broken
    assert not [name for name in ("scipy", "pandas", "tests", "pytest") if (inside / name).exists()]


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="libraries of Linux are cut")
def test_a_library_loads_without_what_is_never_loaded(tmp_path: Path) -> None:
    import netCDF4

    spec = importlib.util.spec_from_file_location("build", REPOSITORY / "tools" / "bundle" / "build.py")
    assert spec is not None
    assert spec.loader is not None
    build = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(build)
    assert build.only_what_is_loaded(b"#!/bin/sh\n") == b"#!/bin/sh\n"
    # auditwheel has moved its segments about, which `strip` does not survive.
    source = next((Path(netCDF4.__file__).parents[1] / "netcdf4.libs").glob("libaec*"))
    whole = source.read_bytes() + b"debug" * 200_000
    cut = build.only_what_is_loaded(whole)
    assert len(cut) < len(whole) - 900_000
    (tmp_path / source.name).write_bytes(cut)
    # RTLD_NOW: every symbol is found now or the loader refuses; in a process of its own, which may crash.
    probe = "import ctypes, os, sys; ctypes.CDLL(sys.argv[1], mode=os.RTLD_NOW).aec_decode_init"
    answer = subprocess.run(
        [sys.executable, "-c", probe, str(tmp_path / source.name)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert answer.returncode == 0, answer.stderr


@pytest.fixture
def bundled(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> ModuleType:
    """`seacruise.compiled` as in a bundle that lies in ``tmp_path``, with a home beside it."""
    import numba

    from seacruise import compiled

    monkeypatch.setattr(compiled, "_IS_BUNDLED", True)
    monkeypatch.setattr(compiled, "_HOME", tmp_path)
    monkeypatch.setattr(compiled, "_settle_on_a_processor", lambda: None)
    monkeypatch.setattr(numba.config, "CACHE_LOCATOR_CLASSES", "")
    monkeypatch.setattr(numba.config, "CACHE_DIR", "")
    monkeypatch.setenv("SEACRUISE_HOME", str(tmp_path / "home"))
    (tmp_path / "build.txt").write_text("build 1", encoding="utf-8")
    compiled._build.cache_clear()
    compiled._unpack.cache_clear()
    monkeypatch.setattr(compiled, "_build", compiled._build.__wrapped__)
    monkeypatch.setattr(compiled, "_unpack", compiled._unpack.__wrapped__)
    return compiled


def double(x: float) -> float:
    return 2.0 * x


def test_a_bundles_kernels_are_kept_by_build_not_by_where_the_bundle_or_the_sailor_is(
    bundled: ModuleType, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    kept = tmp_path / "home" / "cache" / "kernels" / "bundle" / __name__
    hits = []
    for place, build in [("here", "build 1"), ("there", "build 1"), ("there", "build 2")]:
        (tmp_path / place).mkdir(exist_ok=True)
        monkeypatch.chdir(tmp_path / place)
        (tmp_path / "build.txt").write_text(build, encoding="utf-8")
        # As PyInstaller leaves it, wherever it unpacked.
        inside = double.__code__.replace(co_filename=f"{place}/compiled.py")
        kernel = bundled.kernel(FunctionType(inside, {"__name__": __name__}, "double"))
        assert kernel(1.5) == 3.0
        hits.append(sum(kernel.stats.cache_hits.values()))
    assert hits == [0, 1, 0]
    assert len(list(kept.glob("*.nbc"))) == 1


def test_kernels_that_came_with_a_bundle_are_laid_out_once_for_each_build(
    bundled: ModuleType, tmp_path: Path
) -> None:
    shipped = tmp_path / "made" / "bundle" / "seacruise.sea"
    shipped.mkdir(parents=True)
    (shipped / "kernel.nbc").write_bytes(b"code")
    shutil.make_archive(str(tmp_path / "kernels"), "zip", tmp_path / "made", "bundle")
    kept = bundled._bundles_kernels()
    (kept / "seacruise.sea").mkdir(parents=True)
    (kept / "seacruise.sea" / "old.nbc").write_bytes(b"of another build")
    bundled._unpack(kept)
    assert [path.name for path in (kept / "seacruise.sea").iterdir()] == ["kernel.nbc"]
    # What was compiled since stays: it is not laid out again.
    (kept / "seacruise.sea" / "more.nbc").write_bytes(b"of this build")
    bundled._unpack(kept)
    assert len(list((kept / "seacruise.sea").iterdir())) == 2
    assert [path.name for path in kept.parent.iterdir()] == ["bundle"]


def test_a_bundle_works_where_nothing_can_be_kept(bundled: ModuleType, tmp_path: Path) -> None:
    (tmp_path / "home").write_text("no folder", encoding="utf-8")
    assert bundled.kernel(double)(1.5) == 3.0


def linked(source: str, target: str) -> None:
    try:
        os.link(source, target)
    except OSError:
        shutil.copy2(source, target)


def test_it_may_be_moved(run: Run, program: Path, home: Path, tmp_path: Path) -> None:
    run(*SAMPLE)
    compiled = machine_code(home)
    moved = tmp_path / "A folder with spaces, and ü"
    shutil.copytree(program.parent, moved, symlinks=True, copy_function=linked)
    picture = tmp_path / "window.png"
    for words in (["window", "--screenshot", str(picture)], SAMPLE):
        answer = subprocess.run(
            [str(moved / program.name), *words],
            env={
                **os.environ,
                "HOME": str(home),
                "SEACRUISE_HOME": str(home / "seacruise"),
                "PATH": "",
                "QT_QPA_PLATFORM": "offscreen",
            },
            capture_output=True,
            encoding="utf-8",
            timeout=600,
            check=False,
        )
        assert answer.returncode == 0, answer.stderr
    assert picture.is_file()
    assert machine_code(home) == compiled
