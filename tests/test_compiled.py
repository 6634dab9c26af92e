"""Kernels are compiled wherever the program lies, and kept where that is possible."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

import numba
import pytest

from seacruise import compiled


def double(x: float) -> float:
    return 2.0 * x


def test_kernels_work_where_nothing_can_be_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    """A program folder and a home that are both write-protected, as on a boat's shared computer."""
    asked: list[bool] = []

    def njit(*, cache: bool = False, **options: Any) -> Any:
        asked.append(cache)
        if cache:
            raise RuntimeError("cannot cache function: no locator available")
        return real(**options)

    real = numba.njit
    monkeypatch.setattr(compiled, "njit", njit)
    monkeypatch.setattr(numba.config, "CACHE_DIR", "")
    assert compiled.kernel(double)(1.5) == 3.0
    assert asked == [True, True, False]


def test_where_only_the_sailors_folder_can_be_written_kernels_are_kept_there(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def njit(*, cache: bool = False, **options: Any) -> Any:
        if cache and not numba.config.CACHE_DIR:  # type: ignore[attr-defined]
            raise RuntimeError("cannot cache function: no locator available")
        return real(cache=cache, **options)

    real = numba.njit
    monkeypatch.setattr(compiled, "njit", njit)
    monkeypatch.setattr(numba.config, "CACHE_DIR", "")
    monkeypatch.setenv("SEACRUISE_HOME", str(tmp_path))
    assert compiled.kernel(double)(1.5) == 3.0
    assert list((tmp_path / "cache" / "kernels").rglob("*.nbi"))


def test_the_first_kernel_loads_neither_scipy_nor_cffi_and_hides_neither() -> None:
    """Each takes a good part of a tenth of a second to load, and no kernel calls them."""
    code = """
import importlib.util, sys
from seacruise import compiled

def double(x):
    return 2.0 * x

assert compiled.numba.njit(double)(1.5) == 3.0
print([name for name in ("scipy", "cffi", "pycparser") if name in sys.modules])
importlib.util.find_spec("cffi"), importlib.util.find_spec("scipy")
"""
    answer = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert answer.returncode == 0, answer.stderr
    assert answer.stdout.strip() == "[]"
