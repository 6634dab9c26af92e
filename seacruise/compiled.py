"""How kernels are compiled: numba, cached on disk, releasing the interpreter while they run.

A kernel's arguments are arrays and tuples of arrays whose types numba infers; they are described in its
docstring, not annotated.
"""

from __future__ import annotations

import shutil
import sys
import tempfile
from collections.abc import Callable
from contextlib import suppress
from functools import lru_cache
from pathlib import Path
from typing import Any, Final, Self

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

_PROCESSOR: Final = "x86-64-v3"
"""Processor that a bundle's kernels are made for: most of Intel's since 2013, AMD's since 2015."""

_ABILITIES: Final = ("avx2", "bmi", "bmi2", "f16c", "fma", "lzcnt", "movbe")
"""What it has beyond older ones, in LLVM's words."""


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
        _take_what_the_bundle_brings()
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


def _keep_in_cache() -> None:
    kept = Settings.from_environment().cache_dir / "kernels"
    numba.config.CACHE_DIR = str(kept)  # type: ignore[attr-defined]


class BundledKernels:
    """Where numba keeps a bundle's kernels: by module and build, wherever the bundle and its user are.

    numba asks it what it asks each of its own locators (``numba.core.caching``), which go by the path of the
    source; in a bundle that changes when the folder is moved.
    """

    def __init__(self, folder: Path, line: int) -> None:
        self._folder = folder
        self._line = line

    @classmethod
    def from_function(cls, function: Callable[..., Any], _file: str) -> Self | None:
        """Give the place of a function, or ``None`` where nothing can be kept."""
        folder = _bundles_kernels() / function.__module__
        try:
            folder.mkdir(parents=True, exist_ok=True)
            tempfile.TemporaryFile(dir=folder).close()
        except OSError:
            return None
        return cls(folder, function.__code__.co_firstlineno)

    def ensure_cache_path(self) -> None:
        """Make the folder, should somebody have cleared the cache."""
        self._folder.mkdir(parents=True, exist_ok=True)

    def get_cache_path(self) -> str:
        """Give the folder."""
        return str(self._folder)

    def get_source_stamp(self) -> str:
        """Give what changes whenever a kernel may have changed."""
        return _build()

    def get_disambiguator(self) -> str:
        """Tell functions of one name apart."""
        return str(self._line)


def _bundles_kernels() -> Path:
    return Settings.from_environment().cache_dir / "kernels" / "bundle"


@lru_cache(maxsize=1)
def _build() -> str:
    """Give the name of this build, which tools/bundle/seacruise.spec writes."""
    return (_HOME / "build.txt").read_text(encoding="utf-8")


def _take_what_the_bundle_brings() -> None:
    numba.config.CACHE_LOCATOR_CLASSES = f"{__name__}.{BundledKernels.__name__}"  # type: ignore[attr-defined]
    _settle_on_a_processor()
    _unpack(_bundles_kernels())


@lru_cache(maxsize=1)
def _settle_on_a_processor() -> None:
    """Make and accept machine code that serves most computers, so that it need not be made on each."""
    from numba.core.codegen import get_host_cpu_features

    abilities = get_host_cpu_features().split(",")  # type: ignore[no-untyped-call]
    if all(f"+{name}" in abilities for name in _ABILITIES):
        numba.config.CPU_NAME = _PROCESSOR  # type: ignore[attr-defined]
        numba.config.CPU_FEATURES = ""  # type: ignore[attr-defined]


@lru_cache(maxsize=1)
def _unpack(kept: Path) -> None:
    """Lay the machine code that came with the bundle where numba looks for it, once for each build.

    What cannot be laid there is compiled, as on a computer that it was not made for.
    """
    shipped, mark = _HOME / "kernels.zip", kept / "build.txt"
    with suppress(OSError):
        if not shipped.is_file() or (mark.is_file() and mark.read_text(encoding="utf-8") == _build()):
            return
        kept.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix="unpacked-", dir=kept.parent) as fresh:
            shutil.unpack_archive(shipped, fresh)
            (Path(fresh) / kept.name / mark.name).write_text(_build(), encoding="utf-8")
            shutil.rmtree(kept, ignore_errors=True)
            # Another SeaCruise that starts just now may have been faster; then this one has no place to go.
            (Path(fresh) / kept.name).replace(kept)
