"""A damaged file takes down a child, never the program."""

from __future__ import annotations

import pickle
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from seacruise.errors import CancelledError, InputError, NoPassageError
from seacruise.progress import Job
from seacruise.resources import resource_path
from seacruise.weather import isolated
from seacruise.weather.files import read_wind_file

SAMPLE = resource_path("assets/wind/sample.nc")


def test_the_child_reads_what_the_parent_would() -> None:
    ends = [(54.5, 18.5), (57.6, 18.3)]
    there, here = isolated.read_isolated(SAMPLE, around=ends, job=Job()), read_wind_file(SAMPLE, around=ends)
    assert there.forecast == here.forecast
    assert np.array_equal(there.u, here.u)
    assert np.array_equal(there.time, here.time)


@pytest.mark.parametrize("content", [b"", b"GRIB", b"no weather at all", b"CDF\x01" + b"\xff" * 64])
def test_the_childs_sentence_is_ours(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "wind.grb"
    path.write_bytes(content)
    with pytest.raises(InputError, match=r"wind\.grb"):
        isolated.read_isolated(path, job=Job())


def test_a_reason_survives_the_way_between_processes() -> None:
    with pytest.raises(NoPassageError) as caught:
        isolated.read_isolated(SAMPLE, around=[(43.0, 8.0), (42.0, 9.0)], job=Job())
    assert caught.value.reason == "outside-forecast"
    error = pickle.loads(pickle.dumps(NoPassageError("Why.", reason="becalmed", place=(1.0, 2.0))))
    assert (str(error), error.reason, error.place) == ("Why.", "becalmed", (1.0, 2.0))


def test_a_reader_that_crashes_is_an_error_not_an_end(monkeypatch: pytest.MonkeyPatch) -> None:
    real = subprocess.Popen

    def crashing(command: list[str], **options: Any) -> subprocess.Popen[bytes]:
        # What a segmentation fault looks like from outside: an abnormal end and no answer.
        return real([sys.executable, "-c", "import os; os.abort()"], **options)

    monkeypatch.setattr("seacruise.weather.isolated.subprocess.Popen", crashing)
    with pytest.raises(InputError, match=r"sample\.nc is damaged"):
        isolated.read_isolated(SAMPLE, job=Job())


def test_cancelling_kills_the_reader(monkeypatch: pytest.MonkeyPatch) -> None:
    real, children = subprocess.Popen, []

    def sleeping(command: list[str], **options: Any) -> subprocess.Popen[bytes]:
        children.append(real([sys.executable, "-c", "import time; time.sleep(60)"], **options))
        return children[0]

    monkeypatch.setattr("seacruise.weather.isolated.subprocess.Popen", sleeping)
    job = Job()
    threading.Timer(0.2, job.cancel.set).start()
    with pytest.raises(CancelledError):
        isolated.read_isolated(SAMPLE, job=job)
    assert children[0].wait(5.0) != 0


def test_a_file_that_takes_too_long_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(isolated, "PATIENCE_S", 0.0)
    with pytest.raises(InputError, match="cut it"):
        isolated.read_isolated(SAMPLE, job=Job())
