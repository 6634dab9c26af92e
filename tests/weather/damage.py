"""Damaged weather files by the hundred, read in a process of its own: ``python -m tests.weather.damage``.

Prints the number of each case before it is read, so that whoever reads along knows which one crashed or
hangs, and after it what became of it.
"""

from __future__ import annotations

import bz2
import gzip
import random
import sys
import warnings
from pathlib import Path

from seacruise.errors import SeaCruiseError
from seacruise.weather.files import read_current_file, read_wind_file


def damaged(originals: list[bytes], case: int) -> bytes:
    """Make the file of a case: one of the originals, cut, flipped, swapped, spliced or packed."""
    dice = random.Random(case)
    data = bytearray(dice.choice(originals))
    for _ in range(dice.choice((1, 1, 2, 4))):
        kind = dice.randrange(8)
        at = dice.randrange(len(data))
        if kind == 0:
            del data[at:]
        elif kind <= 3:
            # headers are short and hold what matters; bits there are flipped as often as all the others
            at = dice.randrange(min(len(data), 400)) if kind == 3 else at
            data[at] ^= 1 << dice.randrange(8)
        elif kind == 4:
            other = dice.choice(originals)
            data[: dice.choice((4, 8, 16, 64))] = other[: dice.choice((4, 8, 16, 64))]
        elif kind == 5:
            data[at : at + dice.choice((1, 4, 64))] = bytes(dice.choice((0, 255)) for _ in range(4))
        elif kind == 6:
            data[at:at] = data[: dice.randrange(1, 200)]
        else:
            data += dice.choice(originals)[at:]
        if not data:
            break
    pack = dice.choice((bytes, bytes, bytes, bz2.compress, gzip.compress))
    return pack(bytes(data))


def read(path: Path) -> str:
    """Read a file both ways; ``ok``, ``refused``, or the name of what should not have come."""
    outcome = "ok"
    for reader in (read_wind_file, read_current_file):
        try:
            reader(path)
        except SeaCruiseError as error:
            outcome = "refused"
            sentence = str(error)
            if path.name not in sentence or not sentence.endswith(".") or "Traceback" in sentence:
                return f"unclear: {sentence!r}"
        except Exception as error:  # noqa: BLE001 - whatever it is, it should not have come
            return f"{type(error).__name__}: {error}"
    return outcome


def main(folder: Path, first: int, last: int) -> None:
    """Read the cases from ``first`` up to, not including, ``last``."""
    warnings.simplefilter("ignore")
    originals = [path.read_bytes() for path in sorted(folder.glob("original*"))]
    for case in range(first, last):
        path = folder / "case.grb"
        path.write_bytes(damaged(originals, case))
        sys.stdout.write(f"{case} ")
        sys.stdout.flush()
        sys.stdout.write(f"{read(path)}\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]))
