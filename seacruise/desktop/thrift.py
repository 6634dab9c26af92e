"""Memory that nobody needs is not taken, or given back to the system.

Each search works on a thread of its own, and glibc keeps for each thread what it has freed.
"""

from __future__ import annotations

import builtins
import ctypes
import linecache
import sys
from functools import lru_cache
from pathlib import Path
from typing import Final

_ARENA_MAX: Final = -8
"""``M_ARENA_MAX`` of glibc's ``malloc.h``."""

_ARENAS: Final = 1
"""What is free at the end of any but the first, ``malloc_trim`` does not give back: a hundred megabytes after
some minutes of dragging. Threads have small pieces of their own at hand and wait for larger ones only."""

_DONTNEED: Final = 4
"""``MADV_DONTNEED`` of Linux's ``mman.h``."""

_SELDOM: Final = ("libllvmlite", "libhdf5", "libnetcdf", "libcrypto", "cryptography")
"""Libraries that load kernels, read a file of weather, or ask the keychain: nothing of them is needed
otherwise."""

_HOLDERS: Final = ("seacruise.sea.raster", "seacruise.routing.levels")
"""Modules that hold what can be made again, and let go of it."""


@lru_cache(maxsize=1)
def _libc() -> ctypes.CDLL | None:
    """Give the C library, when it is glibc."""
    if sys.platform != "linux":
        return None
    try:
        libc = ctypes.CDLL(None)
        # Others have no such functions.
        _ = libc.mallopt, libc.malloc_trim
    except (OSError, AttributeError):
        return None
    return libc


def import_qt_plainly() -> None:
    """Set memory up before there are threads, and import Qt so that it does not meddle with later imports.

    PySide6 searches the source text of each module that is imported for its own name, for the sake of its
    switch ``__feature__``, which nothing here uses; the texts stay in Python's `linecache`, 30 MB of them,
    and a fifth of the time of the imports goes there.
    """
    share_arenas()
    import PySide6.QtCore  # noqa: F401 - it is what replaces the function

    builtins.__import__ = getattr(builtins, "__orig_import__", builtins.__import__)
    linecache.clearcache()


def share_arenas() -> None:
    """Let all threads take their memory from the same few places, before there are many of them."""
    if (libc := _libc()) is not None:
        libc.mallopt(_ARENA_MAX, _ARENAS)


def give_back() -> None:
    """Give back what is free, and what nobody looks at while nothing is searched."""
    for name in _HOLDERS:
        # What has not been imported holds nothing.
        if (holder := sys.modules.get(name)) is not None:
            holder.let_go()
    if (libc := _libc()) is not None:
        _let_go_of_code(libc, _SELDOM)
        libc.malloc_trim(0)


def _let_go_of_code(libc: ctypes.CDLL, libraries: tuple[str, ...]) -> None:
    """Take code out of memory, fifty megabytes for LLVM's; what is called again is read again.

    Code is only ever read, so that nothing is lost; whatever else a library has is left alone.
    """
    try:
        lines = Path("/proc/self/maps").read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        return
    for line in lines:
        if " r-xp " in line and any(library in line for library in libraries):
            begin, end = (int(address, 16) for address in line.partition(" ")[0].split("-"))
            libc.madvise(ctypes.c_void_p(begin), ctypes.c_size_t(end - begin), _DONTNEED)
