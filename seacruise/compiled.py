"""How kernels are compiled: numba, cached on disk, releasing the interpreter while they run.

A kernel's arguments are arrays and tuples of arrays whose types numba infers; they are described in its
docstring, not annotated.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from seacruise.settings import Settings

# numba looks for the BLAS of SciPy, which no kernel here calls and which takes a third of a second to load.
_SCIPY_IS_LOADED = "scipy" in sys.modules
if not _SCIPY_IS_LOADED:
    sys.modules["scipy"] = None  # type: ignore[assignment]
try:
    import numba
    import numba.np.arraymath
    from numba import njit
finally:
    if not _SCIPY_IS_LOADED:
        del sys.modules["scipy"]

# Nor does a kernel call C by way of cffi, whose parser numba would load with its first kernel; without it
# numba does as where there is none.
_CFFI_IS_LOADED = "cffi" in sys.modules
if not _CFFI_IS_LOADED:
    sys.modules["cffi"] = None  # type: ignore[assignment]
try:
    import numba.core.typing.cffi_utils
finally:
    if not _CFFI_IS_LOADED:
        del sys.modules["cffi"]

_IS_BUNDLED = getattr(sys, "frozen", False)
_HOME = Path(__file__).resolve().parent.parent


def kernel(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compile a function at its first call and keep the machine code on disk.

    Division by zero gives an infinity as in C: the checks Python wants cost a tenth of a search.
    """
    return _compile(function)


def inlined(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compile a small function into each kernel that calls it: a fifth of a search is calling otherwise."""
    return _compile(function, inline="always")


def chosen(choose: Callable[..., Callable[..., Any]]) -> Callable[..., Any]:
    """Make a function of which each kernel gets the version for the types it is called with.

    ``choose`` gets numba's types in place of the arguments and returns a plain function with arguments of the
    same names; it is compiled into the kernel like an `inlined` one.
    """
    from numba.extending import overload

    def stub(*arguments: Any) -> Any:
        raise NotImplementedError(f"{choose.__name__} works in compiled code only")

    stub.__name__, stub.__doc__ = choose.__name__, choose.__doc__
    overload(stub, inline="always", jit_options={"nogil": True, "error_model": "numpy"})(choose)
    return stub


def _compile(function: Callable[..., Any], **more: str) -> Callable[..., Any]:
    options: dict[str, Any] = {"nogil": True, "error_model": "numpy", **more}
    compiled: Callable[..., Any]
    if _IS_BUNDLED:
        _place(function)
        _keep_in_cache()
    try:
        compiled = njit(cache=True, **options)(function)
    except RuntimeError:
        # Neither the program's own folder nor the user's can be written; the sailor's may.
        _keep_in_cache()
        try:
            compiled = njit(cache=True, **options)(function)
        except (RuntimeError, OSError):
            compiled = njit(**options)(function)
    return compiled


def _place(function: Callable[..., Any]) -> None:
    # Code in a bundle names its file relative to the bundle. numba would look for it where the sailor
    # happens to stand, and compile anew in every other folder.
    code = function.__code__
    function.__code__ = code.replace(co_filename=str(_HOME / code.co_filename))


def _keep_in_cache() -> None:
    kept = Settings.from_environment().cache_dir / "kernels"
    numba.config.CACHE_DIR = str(kept)  # type: ignore[attr-defined]
