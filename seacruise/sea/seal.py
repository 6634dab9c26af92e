"""Seals on cached files: whether what lies on the disk is still what was written there.

A seal holds size, time of change and a checksum of each file. Size and time answer at once; only when they
differ - a folder was copied, a file touched or damaged - is the content read and summed.
"""

from __future__ import annotations

import json
import zlib
from pathlib import Path
from typing import Final

SEAL: Final = "seal.json"
_BLOCK: Final = 1 << 20


def seal(folder: Path, names: tuple[str, ...]) -> None:
    """Write the seal of files in a folder."""
    state = {name: [*_stamp(folder / name), _checksum(folder / name)] for name in names}
    (folder / SEAL).write_text(json.dumps(state), encoding="utf-8")


def is_whole(folder: Path, names: tuple[str, ...]) -> bool:
    """Tell whether all files are as they were when they were sealed."""
    try:
        state = json.loads((folder / SEAL).read_text(encoding="utf-8"))
        for name in names:
            size, changed, checksum = state[name]
            stamp = _stamp(folder / name)
            if stamp[0] != size or (stamp[1] != changed and _checksum(folder / name) != checksum):
                return False
    except (OSError, ValueError, KeyError, TypeError):
        return False
    return True


def _stamp(path: Path) -> tuple[int, int]:
    status = path.stat()
    return status.st_size, status.st_mtime_ns


def _checksum(path: Path) -> int:
    # Adler's sum: four times as fast as CRC-32 without help of the processor, and damage is no adversary.
    value = 1
    with path.open("rb") as file:
        while block := file.read(_BLOCK):
            value = zlib.adler32(block, value)
    return value
