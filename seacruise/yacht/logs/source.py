"""A log file of any kind that is known, told by its content, as blocks."""

from __future__ import annotations

import csv
import json
import re
from collections.abc import Iterator
from itertools import islice
from math import nan
from pathlib import Path
from typing import BinaryIO, Final

from seacruise.errors import InputError
from seacruise.yacht.logs.log import Log, Tally
from seacruise.yacht.logs.nmea import Checksum, read_nmea
from seacruise.yacht.logs.sheet import read_sheet
from seacruise.yacht.logs.signalk import read_signalk

_LONGEST_LINE: Final = 65_536
"""A file without line ends must not be read as one line."""

_SENTENCE = re.compile(rb"[$!][A-Z]{2}[A-Z0-9]{3},")
_LOOK_AT: Final = 200


def read_log(
    path: Path, tally: Tally, *, checksum: Checksum = "auto", variation_deg: float = nan
) -> Iterator[Log]:
    """Read a log: NMEA 0183, Signal K deltas, or a table with a header.

    Parameters
    ----------
    path
        The file; of any size, it is read in blocks.
    tally
        Is counted up on the way.
    checksum
        Which NMEA sentences to believe, see `seacruise.yacht.logs.nmea.CHECKSUMS`.
    variation_deg
        Magnetic variation [degrees, positive to the east] where the log tells none.

    Raises
    ------
    InputError
        The file is missing, cannot be read or is no log.
    """
    path = Path(path)
    try:
        with path.open("rb") as file:
            begin = list(islice(_lines(file), _LOOK_AT))
            file.seek(0)
            lines = _lines(file)
            if any(_SENTENCE.search(line) for line in begin):
                yield from read_nmea(lines, tally, checksum=checksum, variation_deg=variation_deg)
            elif any(_is_json(line) for line in begin):
                yield from read_signalk(lines, tally, variation_deg=variation_deg)
            else:
                yield from read_sheet(lines, tally, variation_deg=variation_deg)
    except FileNotFoundError:
        raise InputError(f"There is no log {path}; check the name and the folder.") from None
    except InputError as error:
        raise InputError(f"{path.name} cannot be used. {error}") from None
    except (OSError, ValueError, csv.Error) as error:
        detail = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise InputError(f"The log {str(path)!r} cannot be read: {detail}.") from error


def _lines(file: BinaryIO) -> Iterator[bytes]:
    return iter(lambda: file.readline(_LONGEST_LINE), b"")


def _is_json(line: bytes) -> bool:
    brace = line.find(b"{")
    if brace < 0:
        return False
    try:
        return isinstance(json.loads(line[brace:]), dict)
    except ValueError:
        return False
