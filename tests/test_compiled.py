"""Kernels are compiled wherever the program lies, and kept where that is possible."""

from __future__ import annotations

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
    assert compiled.kernel(double)(1.5) == 3.0
    assert asked == [True, False]
