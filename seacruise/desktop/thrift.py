"""Memory that nobody needs any more is given back to the system: on Linux with glibc, which keeps it.

Each search works on a thread of its own, and glibc keeps for each thread what it has freed.
"""

from __future__ import annotations

import ctypes
import sys
from functools import lru_cache
from typing import Final

_ARENA_MAX: Final = -8
"""``M_ARENA_MAX`` of glibc's ``malloc.h``."""

_ARENAS: Final = 2


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


def share_arenas() -> None:
    """Let all threads take their memory from the same few places, before there are many of them."""
    if (libc := _libc()) is not None:
        libc.mallopt(_ARENA_MAX, _ARENAS)


def give_back() -> None:
    """Give back what is free."""
    if (libc := _libc()) is not None:
        libc.malloc_trim(0)
