"""A file is complete or not there; what was there before survives every failure."""

from __future__ import annotations

import errno
import os
import sys
from pathlib import Path
from typing import Any

import pytest

from seacruise.atomic import check_target, write_atomically
from seacruise.errors import InputError


def test_replaces_whole_and_leaves_nothing_beside(tmp_path: Path) -> None:
    target = tmp_path / "über route.gpx"
    write_atomically(target, "one", what="GPX file")
    write_atomically(target, b"two", what="GPX file")
    assert target.read_bytes() == b"two"
    assert [p.name for p in tmp_path.iterdir()] == [target.name]


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such permissions")
def test_permissions_are_those_of_any_new_file(tmp_path: Path) -> None:
    plain, ours = tmp_path / "plain", tmp_path / "ours"
    plain.write_text("x", encoding="utf-8")
    write_atomically(ours, "x", what="file")
    assert ours.stat().st_mode == plain.stat().st_mode
    ours.chmod(0o600)
    write_atomically(ours, "y", what="file")
    assert ours.stat().st_mode & 0o777 == 0o600


@pytest.mark.parametrize("step", ["fsync", "replace"])
def test_old_file_survives_a_full_disk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, step: str) -> None:
    target = tmp_path / "passage.csv"
    target.write_text("precious", encoding="utf-8")

    def full(*_: Any, **__: Any) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    if step == "fsync":
        monkeypatch.setattr(os, "fsync", full)
    else:
        monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(InputError, match=r"CSV file cannot be written to .*no space left"):
        write_atomically(target, "new", what="CSV file")
    assert target.read_text(encoding="utf-8") == "precious"
    assert [p.name for p in tmp_path.iterdir()] == [target.name]


@pytest.mark.skipif(os.name == "nt", reason="Windows lets only administrators make links")
def test_a_link_is_followed(tmp_path: Path) -> None:
    folder = tmp_path / "elsewhere"
    folder.mkdir()
    link = tmp_path / "route.gpx"
    link.symlink_to(folder / "real.gpx")
    write_atomically(link, "whole", what="GPX file")
    assert link.is_symlink()
    assert (folder / "real.gpx").read_text(encoding="utf-8") == "whole"
    assert [p.name for p in folder.iterdir()] == ["real.gpx"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="Windows has no named pipes")
def test_a_pipe_is_written_into_and_not_replaced(tmp_path: Path) -> None:
    pipe = tmp_path / "to-the-plotter"
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    try:
        write_atomically(pipe, "route", what="GPX file")
        assert os.read(reader, 100) == b"route"
    finally:
        os.close(reader)
    assert pipe.is_fifo()


def test_a_folder_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="that is a folder"):
        write_atomically(tmp_path, "x", what="chart")


def test_a_missing_folder_is_named_before_anything_is_computed(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"there is no folder .*nowhere"):
        check_target(tmp_path / "nowhere" / "a.png", "chart")


def test_what_cannot_even_be_looked_at_is_one_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def closed(*_: Any, **__: Any) -> bool:
        raise PermissionError(errno.EACCES, "Permission denied")

    monkeypatch.setattr(Path, "is_dir", closed)
    with pytest.raises(InputError, match="permission denied; choose another place") as caught:
        check_target(tmp_path / "a.png", "chart")
    assert caught.value.reason == "not-written"


@pytest.mark.skipif(
    sys.platform == "win32" or (hasattr(os, "geteuid") and os.geteuid() == 0),
    reason="root may write everywhere",
)
def test_a_closed_folder_is_refused(tmp_path: Path) -> None:
    tmp_path.chmod(0o500)
    try:
        with pytest.raises(InputError, match="write-protected"):
            check_target(tmp_path / "a.png", "chart")
    finally:
        tmp_path.chmod(0o700)
