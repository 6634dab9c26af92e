"""The header of classic NetCDF files, held against the size of the file before the library reads it.

The library believes the counts in a header: one flipped bit, and it asks for gigabytes or reads for minutes.
"""

from __future__ import annotations

import os
from typing import IO, Final

from seacruise.errors import WeatherError

CLASSIC: Final = (b"CDF\x01", b"CDF\x02", b"CDF\x05")
"""First bytes of the three forms."""

_DIMENSIONS, _VARIABLES, _ATTRIBUTES = 10, 11, 12
_BYTES: Final = {1: 1, 2: 1, 3: 2, 4: 4, 5: 4, 6: 8, 7: 1, 8: 2, 9: 4, 10: 8, 11: 8}
"""Bytes per value of each type."""


def check_header(file: IO[bytes]) -> None:
    """Walk through the header of a NetCDF file from its begin, if it is a classic one.

    The format is that of the NetCDF User's Guide, appendix B.

    Raises
    ------
    WeatherError
        ``bad-response``, with an unfinished sentence, when a list in it does not fit into the file.
    OSError
        The file cannot be read.
    """
    size = file.seek(0, os.SEEK_END)
    file.seek(0)
    magic = file.read(4)
    if magic in CLASSIC:
        _Header(file, size, magic[3]).walk()


class _Header:
    def __init__(self, file: IO[bytes], size: int, version: int) -> None:
        self._file, self._size = file, size
        self._count_bytes = 8 if version == 5 else 4
        self._offset_bytes = 4 if version == 1 else 8

    def walk(self) -> None:
        """Read on to the end of the header."""
        self._number(self._count_bytes)
        for _ in range(self._list(_DIMENSIONS)):
            self._name()
            self._number(self._count_bytes)
        self._attributes()
        for _ in range(self._list(_VARIABLES)):
            self._name()
            self._skip(self._fitting() * self._count_bytes)
            self._attributes()
            self._number(4)
            self._skip(self._count_bytes + self._offset_bytes)

    def _attributes(self) -> None:
        for _ in range(self._list(_ATTRIBUTES)):
            self._name()
            size = _BYTES.get(self._number(4))
            if size is None:
                raise self._damaged()
            self._skip(self._fitting() * size)

    def _list(self, kind: int) -> int:
        tag, count = self._number(4), self._fitting()
        if tag != kind and (tag or count):
            raise self._damaged()
        return count

    def _fitting(self) -> int:
        """Read a count of things that take a byte each at least."""
        count = self._number(self._count_bytes)
        if count > self._size - self._file.tell():
            raise self._damaged()
        return count

    def _name(self) -> None:
        self._skip(self._fitting())

    def _skip(self, size: int) -> None:
        # everything in a header is padded to four bytes
        end = self._file.tell() + (size + 3) // 4 * 4
        if end > self._size:
            raise self._damaged()
        self._file.seek(end)

    def _number(self, size: int) -> int:
        data = self._file.read(size)
        if len(data) < size:
            raise self._damaged()
        return int.from_bytes(data)

    def _damaged(self) -> WeatherError:
        return WeatherError("it is not a NetCDF file, or it is damaged")
