"""Files that come with the program: ports, polars, icons."""

from __future__ import annotations

from pathlib import Path

from seacruise.errors import InputError

_PACKAGE = Path(__file__).resolve().parent


def resource_path(name: str) -> Path:
    """Find a shipped file or folder, e.g. ``"ports.csv"``, ``"polars"`` or ``"assets/icon.svg"``.

    The wheel carries them in ``seacruise/_data``; a source checkout has them beside the package.

    Raises
    ------
    InputError
        The installation is incomplete.
    """
    for folder in (_PACKAGE / "_data", _PACKAGE.parent):
        path = folder / name
        if path.exists():
            return path
    raise InputError(f"SeaCruise is not installed completely: {name} is missing; install it again.")
