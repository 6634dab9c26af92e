"""The set-up: what it says when it cannot, that it is instant when it has, and what the wheel carries."""

from __future__ import annotations

import importlib.util
import json
import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from types import ModuleType

import pytest

REPOSITORY = Path(__file__).resolve().parent.parent
POSIX_ONLY = pytest.mark.skipif(
    os.name == "nt" or shutil.which("make") is None, reason="make and sh are needed"
)


@pytest.fixture
def setup_venv(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The set-up program, working on a copy of what it reads."""
    spec = importlib.util.spec_from_file_location("setup_venv", REPOSITORY / "tools" / "setup_venv.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    (tmp_path / "tools").mkdir()
    for name in ("pyproject.toml", "constraints.txt", "tools/setup_venv.py"):
        shutil.copy(REPOSITORY / name, tmp_path / name)
    venv = tmp_path / ".venv"
    python = venv / "bin" / "python"
    python.parent.mkdir(parents=True)
    python.touch()
    monkeypatch.setattr(module, "ROOT", tmp_path)
    monkeypatch.setattr(module, "VENV", venv)
    monkeypatch.setattr(module, "PYTHON", python)
    monkeypatch.setattr(module, "STAMP", venv / "seacruise-ready.json")
    return module


def stamp(module: ModuleType, *extras: str) -> None:
    module.STAMP.write_text(json.dumps({"key": module.stamp_key(), "extras": extras}), encoding="utf-8")


# -------------------------------------------------------------------------------------------- set-up


def test_a_stamp_makes_the_next_call_instant(setup_venv: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(setup_venv, "run", lambda *_: pytest.fail("nothing is to be installed"))
    stamp(setup_venv, "dev")
    assert setup_venv.main(["dev"]) == 0
    assert setup_venv.main([]) == 0
    assert setup_venv.main(["--check", "dev"]) == 0
    assert setup_venv.main(["--check", "bench"]) == 1


@pytest.mark.parametrize("name", ["pyproject.toml", "constraints.txt"])
def test_a_changed_requirement_undoes_the_stamp(setup_venv: ModuleType, name: str) -> None:
    stamp(setup_venv, "dev")
    with (setup_venv.ROOT / name).open("a", encoding="utf-8") as file:
        file.write("\n# changed\n")
    assert setup_venv.main(["--check"]) == 1


@pytest.mark.parametrize("content", ["", "{", "[]", '{"key": 1}', "null"])
def test_a_broken_stamp_is_no_stamp(setup_venv: ModuleType, content: str) -> None:
    setup_venv.STAMP.write_text(content, encoding="utf-8")
    assert setup_venv.main(["--check"]) == 1


def test_extras_add_up_and_the_warm_up_must_succeed(
    setup_venv: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    calls: list[tuple[str, ...]] = []
    monkeypatch.setattr(setup_venv, "run", lambda *words: calls.append(words))
    monkeypatch.setattr(setup_venv, "check_qt", lambda: None)
    monkeypatch.setattr(setup_venv, "venv_is_sound", lambda: True)
    stamp(setup_venv, "bench")
    assert setup_venv.main(["dev"]) == 0
    assert ".[bench,dev]" in calls[0]
    assert calls[1] == ("-m", "seacruise.warmup")
    assert setup_venv.main(["--check", "dev", "bench"]) == 0

    def broken(*words: str) -> None:
        if "seacruise.warmup" in words:
            raise setup_venv.SetupError("the warm-up failed")

    setup_venv.STAMP.unlink()
    monkeypatch.setattr(setup_venv, "run", broken)
    assert setup_venv.main([]) == 1
    assert "Set-up stopped: the warm-up failed." in capsys.readouterr().err
    assert setup_venv.main(["--check"]) == 1


def test_an_old_python_is_told_so(
    setup_venv: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "version_info", (3, 10, 13))
    assert setup_venv.main([]) == 2
    assert "needs Python 3.11 or newer" in capsys.readouterr().err


def test_a_missing_ensurepip_is_named_with_its_package(
    setup_venv: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(setup_venv, "venv_is_sound", lambda: False)
    monkeypatch.setitem(sys.modules, "ensurepip", None)
    assert setup_venv.main([]) == 1
    package = f"python{sys.version_info[0]}.{sys.version_info[1]}-venv"
    err = capsys.readouterr().err
    assert "ensurepip" in err
    assert f"apt-get install {package}" in err
    assert "Traceback" not in err


# ------------------------------------------------------------------------------------ make and .ci/run


def stand_in(folder: Path, name: str, script: str) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
    (folder / name).chmod(0o755)


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """A checkout whose environment is a stand-in that says how it was called."""
    (tmp_path / "tools").mkdir()
    (tmp_path / ".ci").mkdir()
    for name in ("Makefile", "tools/setup.sh", "tools/setup_venv.py", ".ci/run"):
        shutil.copy(REPOSITORY / name, tmp_path / name)
    binaries = tmp_path / ".venv" / "bin"
    stand_in(binaries, "python", 'echo "python $*"')
    stand_in(binaries, "ruff", 'echo "ruff $*"')
    stand_in(binaries, "mypy", 'echo "mypy $*"')
    stand_in(binaries, "seacruise", 'echo "seacruise $*"')
    return tmp_path


def call(checkout: Path, *words: str, **env: str) -> subprocess.CompletedProcess[str]:
    inherited = {
        k: v for k, v in os.environ.items() if not k.startswith(("DISPLAY", "WAYLAND", "MAKE", "MFLAGS"))
    }
    return subprocess.run(
        words, cwd=checkout, capture_output=True, text=True, env={**inherited, **env}, check=False, timeout=60
    )


@POSIX_ONLY
def test_make_run_opens_the_window(checkout: Path) -> None:
    answer = call(checkout, "make", "run", DISPLAY=":0")
    assert answer.returncode == 0, answer.stderr
    assert answer.stdout.splitlines()[-1] == "seacruise "


@POSIX_ONLY
@pytest.mark.skipif(sys.platform != "linux", reason="other systems always have a display")
def test_make_run_without_a_display_runs_the_demo(checkout: Path) -> None:
    answer = call(checkout, "make", "run")
    assert answer.returncode == 0, answer.stderr
    assert "No display here" in answer.stderr
    assert answer.stdout.splitlines()[-1].startswith("seacruise plan --from Gdynia --to Stockholm")


@POSIX_ONLY
def test_make_demo_is_the_published_example(checkout: Path) -> None:
    answer = call(checkout, "make", "demo")
    assert answer.returncode == 0, answer.stderr
    assert answer.stdout.splitlines()[-1] == (
        "seacruise plan --from Gdynia --to Stockholm --depart 2016-11-20T06:00Z --yacht Bavaria 46 Cruiser "
        "--forecast sample --chart build/demo.png --gpx build/demo.gpx"
    )
    assert (checkout / "build").is_dir()


@POSIX_ONLY
def test_make_test_stops_at_the_first_failure(checkout: Path) -> None:
    answer = call(checkout, "make", "test")
    assert answer.returncode == 0, answer.stderr
    ran = [line for line in answer.stdout.splitlines() if not line.startswith(".venv")]
    assert [line.strip() for line in ran][-6:] == [
        "ruff check .",
        "ruff format --check .",
        "mypy",
        "python -m pytest --numprocesses=2 --dist=loadfile --ignore=tests/desktop --ignore=tests/display",
        "python -m pytest --numprocesses=2 --dist=loadfile tests/desktop",
        "python -m pytest tests/display",
    ]
    stand_in(checkout / ".venv" / "bin", "mypy", "exit 1")
    stopped = call(checkout, "make", "test")
    assert stopped.returncode != 0
    assert "python -m pytest" not in stopped.stdout


@POSIX_ONLY
def test_no_python_is_one_sentence(checkout: Path) -> None:
    shutil.rmtree(checkout / ".venv")
    for tool in ("sh", "dirname"):
        found = shutil.which(tool)
        assert found is not None
        (checkout / "few").mkdir(exist_ok=True)
        (checkout / "few" / tool).symlink_to(found)
    answer = call(checkout, "sh", "tools/setup.sh", PATH=str(checkout / "few"), PYTHON="")
    assert answer.returncode == 1
    assert answer.stderr.startswith("SeaCruise needs Python 3.11 or newer and found none")


@POSIX_ONLY
@pytest.mark.skipif(shutil.which("bash") is None, reason="bash is needed")
def test_ci_without_rights_says_what_is_missing_and_tests(checkout: Path) -> None:
    stubs = checkout / "stubs"
    stand_in(stubs, "id", "echo 1000")
    stand_in(stubs, "ldconfig", "echo libEGL.so.1 there")
    stand_in(stubs, "make", 'echo "make $*"')
    stand_in(stubs, "apt-get", "echo never; exit 1")
    answer = call(checkout, "bash", ".ci/run", PATH=f"{stubs}{os.pathsep}{os.environ['PATH']}")
    assert answer.returncode == 0, answer.stderr
    assert answer.stdout == "make test\n"
    assert "libxcb-cursor0" in answer.stderr
    assert "libegl1" not in answer.stderr


# ----------------------------------------------------------------------------------- what is installed


def test_the_wheel_carries_the_data_and_nothing_else(tmp_path: Path) -> None:
    from hatchling.builders.wheel import WheelBuilder

    wheel = Path(next(WheelBuilder(str(REPOSITORY)).build(directory=str(tmp_path), versions=["standard"])))
    names = zipfile.ZipFile(wheel).namelist()
    polars = {path.name for path in (REPOSITORY / "polars").glob("*.csv")}
    shipped = {name.rsplit("/", 1)[1] for name in names if name.startswith("seacruise/_data/polars/")}
    assert polars
    assert polars <= shipped
    assert {
        "seacruise/_data/ports.csv",
        "seacruise/_data/assets/coast/baltic.npz",
        "seacruise/py.typed",
    } <= set(names)
    assert {name.split("/")[0].split("-")[0] for name in names} == {"seacruise"}
    assert any(name.endswith("licenses/LICENSE") for name in names)
    assert not [name for name in names if name.endswith((".pyc", ".nbi", ".nbc"))]


def test_qt_loses_no_reference_to_none() -> None:
    """PySide6 6.12.0 before Python 3.12 loses one on every void call and aborts after some thousands."""
    from PySide6.QtCore import QObject

    thing = QObject()
    before = sys.getrefcount(None)
    for _ in range(2000):
        thing.setObjectName("x")
    assert abs(sys.getrefcount(None) - before) < 200


def test_public_names_are_there() -> None:
    import seacruise

    for name in seacruise.__all__:
        assert getattr(seacruise, name) is not None
    assert set(dir(seacruise)) == set(seacruise.__all__)
    with pytest.raises(AttributeError, match="Route66"):
        seacruise.Route66  # noqa: B018 - the access is the test
