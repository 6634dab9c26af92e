"""Read a weather file in a process of its own.

The libraries behind GRIB and HDF5 are written in C, and a damaged file can make them take the whole
program down. Here it takes down a child, and the sailor is told which file it was.
"""

from __future__ import annotations

import pickle
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Final

from seacruise.errors import InputError, SeaCruiseError
from seacruise.progress import Job
from seacruise.weather.files import read_current_file, read_wind_file
from seacruise.weather.grids import Place
from seacruise.weather.wind import Current, Wind

PATIENCE_S: Final = 300.0
"""Longest time that a file may take [s]."""

_POLL_S: Final = 0.02


_READERS: Final[dict[str, Callable[..., Wind | Current]]] = {
    "wind": read_wind_file,
    "current": read_current_file,
}


def read_isolated(path: Path, *, around: Sequence[Place] = (), job: Job) -> Wind:
    """Read a file as `read_wind_file` does, safe from what it may do to the libraries that read it.

    Raises
    ------
    InputError, NoPassageError
        As `read_wind_file`; and when the file made its reader crash or took longer than `PATIENCE_S`.
    CancelledError
    """
    found = _read("wind", path, around, job)
    assert isinstance(found, Wind)
    return found


def read_current_isolated(path: Path, *, around: Sequence[Place] = (), job: Job) -> Current:
    """Read a file as `read_current_file` does, safe from what it may do to the libraries that read it.

    Raises
    ------
    InputError
        As `read_current_file`; and when the file made its reader crash or took longer than `PATIENCE_S`.
    CancelledError
    """
    found = _read("current", path, around, job)
    assert isinstance(found, Current)
    return found


def _read(what: str, path: Path, around: Sequence[Place], job: Job) -> Wind | Current:
    with tempfile.TemporaryDirectory(prefix="seacruise-") as folder:
        answer = Path(folder) / "answer.pickle"
        question = Path(folder) / "question.pickle"
        question.write_bytes(pickle.dumps((what, Path(path), tuple(around))))
        # In a bundle that is SeaCruise itself, which knows this one module (tools/bundle/start.py).
        command = [sys.executable, "-m", "seacruise.weather.isolated", str(question), str(answer)]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as child:
            try:
                _wait(child, path, job)
            finally:
                child.kill()
        if not answer.is_file():
            raise InputError(
                f"The weather file {path.name} is damaged: the library that reads it gave up; download it "
                "again or choose another file."
            )
        found = pickle.loads(answer.read_bytes())  # noqa: S301 - our own child wrote it
    if isinstance(found, SeaCruiseError):
        raise found
    assert isinstance(found, Wind | Current)
    return found


def _wait(child: subprocess.Popen[bytes], path: Path, job: Job) -> None:
    until = time.monotonic() + PATIENCE_S
    while child.poll() is None:
        job.check()
        if time.monotonic() > until:
            raise InputError(
                f"The weather file {path.name} takes longer than {PATIENCE_S / 60:.0f} min to read; cut it "
                "to the area of the passage."
            )
        time.sleep(_POLL_S)


def main(question: str, answer: str) -> None:
    """Answer a question in the child: what was read, or the error that says why there is nothing."""
    what, path, around = pickle.loads(Path(question).read_bytes())  # noqa: S301 - our own parent wrote it
    found: Wind | Current | SeaCruiseError
    try:
        found = _READERS[what](path, around=around)
    except SeaCruiseError as error:
        found = error
    # Renamed when whole: a child that dies while writing has given no answer.
    part = Path(answer).with_suffix(".part")
    part.write_bytes(pickle.dumps(found))
    part.replace(answer)


if __name__ == "__main__":
    main(*sys.argv[1:3])
