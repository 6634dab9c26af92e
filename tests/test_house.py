"""The rules of the house that a program can check."""

from __future__ import annotations

import re
import socket
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from tests.network import NETWORK

REPOSITORY = Path(__file__).resolve().parent.parent

FORBIDDEN = {
    "an absolute path of a developer's machine": re.compile(r"(?<![\w.~-])/(?:work|opt|root|home/\w+)/\w"),
    "an address of a package index": re.compile(
        r"--(?:extra-)?index-url|--find-links|https?://[^\s/]+/simple\b"
    ),
    "a note to self": re.compile(r"#\s*(?:TODO|FIXME|XXX)\b"),
}
TEXT = {".py", ".md", ".toml", ".txt", ".csv", ".yml", ".yaml", ".cfg", ".sh", ""}


def files_of_the_project() -> list[Path]:
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=REPOSITORY,
        capture_output=True,
        check=False,
    )
    if listed.returncode == 0 and listed.stdout:
        paths = [REPOSITORY / name for name in listed.stdout.decode().split("\0") if name]
    else:
        # Not a checkout: everything but what tools leave behind, which is hidden or ignored.
        left = re.compile(r"(^|/)(\.(?!ci/|gitignore)|build/|dist/|__pycache__/)")
        paths = [p for p in REPOSITORY.rglob("*") if not left.search(p.relative_to(REPOSITORY).as_posix())]
    # This file spells out what it looks for.
    return [p for p in paths if p.is_file() and p.suffix in TEXT and p != Path(__file__)]


def test_imports_point_one_way() -> None:
    answer = subprocess.run(
        [sys.executable, "-c", "from importlinter.cli import lint_imports_command as c; c()", "--no-cache"],
        cwd=REPOSITORY,
        capture_output=True,
        text=True,
        check=False,
    )
    assert answer.returncode == 0, answer.stdout + answer.stderr
    assert "0 broken" in answer.stdout


@pytest.mark.parametrize("what", sorted(FORBIDDEN))
def test_nothing_in_the_tree_names(what: str) -> None:
    found = [
        f"{path.relative_to(REPOSITORY)}:{number}: {line.strip()[:100]}"
        for path in files_of_the_project()
        for number, line in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), 1)
        if FORBIDDEN[what].search(line)
    ]
    assert not found, f"{what}:\n" + "\n".join(found)


def test_modules_stay_readable() -> None:
    long = {
        str(path.relative_to(REPOSITORY)): lines
        for path in (REPOSITORY / "seacruise").rglob("*.py")
        if (lines := len(path.read_text(encoding="utf-8").splitlines())) > 450
    }
    assert not long, long


def test_pins_cover_every_dependency() -> None:
    project = tomllib.loads((REPOSITORY / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    wanted = project["dependencies"] + project["optional-dependencies"]["dev"]
    pins = (REPOSITORY / "constraints.txt").read_text(encoding="utf-8")

    def plain(name: str) -> str:
        return re.split(r"[<>=;\s\[]", name, maxsplit=1)[0].replace("_", "-").lower()

    pinned = {plain(line) for line in pins.splitlines() if line and not line.startswith("#")}
    assert {plain(name) for name in wanted} <= pinned
    assert all("==" in line for line in pins.splitlines() if line and not line.startswith("#"))


def test_the_guard_lets_nothing_out_of_this_machine() -> None:
    with socket.socket() as outwards, pytest.raises(OSError, match="tests reach this machine only"):
        outwards.connect(("192.0.2.1", 80))
    with pytest.raises(socket.gaierror):
        socket.getaddrinfo("example.org", 443)
    assert NETWORK.attempts == ["('192.0.2.1', 80)", "example.org"]
    NETWORK.attempts.clear()
    with socket.create_server(("127.0.0.1", 0)) as server:
        socket.create_connection(server.getsockname(), timeout=10).close()
    assert NETWORK.attempts == []
