"""Damaged files end in one sentence of ours, whatever they do to the libraries that read them."""

from __future__ import annotations

import gzip
import io
import os
import subprocess
import sys
from collections import Counter
from pathlib import Path
from typing import Any

import netCDF4
import numpy as np
import pytest

from seacruise.errors import SeaCruiseError, WeatherError
from seacruise.progress import Job
from seacruise.weather import isolated
from seacruise.weather.classic import check_header
from seacruise.weather.files import read_wind_file
from tests.conftest import REPOSITORY
from tests.weather.damage import damaged
from tests.weather.worlds import full, message, write_layers

CASES = int(os.environ.get("SEACRUISE_DAMAGED_FILES", "400"))
HANG_S = 20.0


def write_originals(folder: Path) -> None:
    """Write small, sound files of every kind; those of the cases are made of them."""
    rng = np.random.default_rng(1)
    field = rng.uniform(-9, 9, (4, 5))
    for number, sample in enumerate(("regular_ll_sfc_grib1", "regular_ll_sfc_grib2")):
        both = [message(name, field, sample, stepRange=step) for step in "03" for name in ("10u", "10v")]
        (folder / f"original{number}.grb").write_bytes(b"".join(both))
    member: dict[str, Any] = {"productDefinitionTemplateNumber": 1, "perturbationNumber": 1}
    rich = [
        message("10u", full(4.0), **member), message("10v", full(4.0), **member),
        message("10u", full(5.0)), message("10v", full(5.0)), message("swh", field),
    ]  # fmt: skip
    (folder / "original3.grb").write_bytes(b"".join(rich))
    values = np.broadcast_to(field, (3, 4, 5))
    layers = {
        name: (values, {"units": unit})
        for name, unit in (("u10", "m/s"), ("v10", "m/s"), ("swh", "m"), ("uo", "m/s"), ("vo", "m/s"))
    }
    write_classic(write_layers(folder / "original4.nc", layers), folder / "original5.nc", "NETCDF3_CLASSIC")


def write_classic(path: Path, target: Path, form: Any) -> Path:
    """Copy a NetCDF file into a classic form."""
    with netCDF4.Dataset(path) as source, netCDF4.Dataset(target, "w", format=form) as copy:
        copy.history = "a text of odd length."
        for name, dimension in source.dimensions.items():
            copy.createDimension(name, None if name == "time" else len(dimension))
        for name, variable in source.variables.items():
            new = copy.createVariable(name, variable.dtype, variable.dimensions)
            new.units = variable.units
            new[:] = variable[:]
    return target


def read_on(folder: Path, first: int) -> tuple[list[str], int | None]:
    """Read cases from ``first`` on: outcomes, and the case that made the reader crash or hang, if any."""
    command = [sys.executable, "-m", "tests.weather.damage", str(folder), str(first), str(CASES)]
    log = folder / "log"
    with (
        log.open("w") as out,
        subprocess.Popen(command, cwd=REPOSITORY, stdout=out, stderr=subprocess.DEVNULL) as child,
    ):
        size = -1
        while child.poll() is None:
            try:
                child.wait(HANG_S)
            except subprocess.TimeoutExpired:
                if log.stat().st_size == size:
                    child.kill()
                size = log.stat().st_size
    lines = log.read_text().split("\n")
    outcomes = [line.split(" ", 1)[1] for line in lines[:-1]]
    last = lines[-1].split()
    return outcomes, int(last[0]) if last else None


@pytest.mark.parametrize("form", ["NETCDF3_CLASSIC", "NETCDF3_64BIT_OFFSET", "NETCDF3_64BIT_DATA"])
def test_a_classic_header_is_believed_only_where_it_fits(tmp_path: Path, form: str) -> None:
    layers = {name: (np.full((3, 4, 5), 4.0), {"units": "m/s"}) for name in ("u10", "v10")}
    path = write_classic(write_layers(tmp_path / "a.nc", layers), tmp_path / "b.nc", form)
    np.testing.assert_allclose(read_wind_file(path).u, 4.0)
    sound = path.read_bytes()
    path.write_bytes(gzip.compress(sound))
    np.testing.assert_allclose(read_wind_file(path).u, 4.0)
    refused = 0
    for at in range(4, sound.index(b"u10"), 4):
        try:
            check_header(io.BytesIO(sound[:at] + b"\x7f\xff\xff\xff" + sound[at + 4 :]))
        except WeatherError:
            refused += 1
    # every tag, count and length of a name; not the lengths of dimensions and the texts themselves
    assert refused > 10
    for length in range(4, sound.index(b"u10")):
        with pytest.raises(WeatherError, match="damaged"):
            check_header(io.BytesIO(sound[:length]))


def test_damaged_files_end_in_our_own_errors(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(isolated, "PATIENCE_S", 10.0)
    write_originals(tmp_path)
    outcomes: list[str] = []
    crashes: list[int] = []
    first = 0
    while first < CASES:
        found, crash = read_on(tmp_path, first)
        outcomes += found
        if crash is None:
            first += len(found)
            assert first == CASES
        else:
            crashes.append(crash)
            first = crash + 1
    originals = [path.read_bytes() for path in sorted(tmp_path.glob("original*"))]
    for case in crashes:
        # what takes the libraries down takes down a child only
        path = tmp_path / f"case{case}.grb"
        path.write_bytes(damaged(originals, case))
        with pytest.raises(SeaCruiseError, match=path.name):
            isolated.read_isolated(path, job=Job())
    count = Counter(outcomes)
    assert set(count) <= {"ok", "refused"}, (count, crashes)
    assert len(outcomes) + len(crashes) == CASES
    # neither all sound nor all hopeless: the damage is of a kind that tells something
    assert count["refused"] > CASES / 5
    assert count["ok"] > CASES / 50
