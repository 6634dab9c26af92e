"""Weather files: what is in the bytes decides how they are read, not what the file is called."""

from __future__ import annotations

import bz2
import gzip
import io
import zlib
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Final, TypeVar

from seacruise.errors import InputError, WeatherError
from seacruise.weather.classic import CLASSIC
from seacruise.weather.grids import Place, RawFile
from seacruise.weather.layers import to_current, to_wind
from seacruise.weather.wind import Current, Wind

_Made = TypeVar("_Made")

MAX_BYTES: Final = 1_000_000_000
"""Largest file, and largest content of a compressed one, that is read [bytes]."""

_NETCDF_MAGIC: Final = (*CLASSIC, b"\x89HDF")


def read_wind_file(path: Path | str, *, around: Sequence[Place] = ()) -> Wind:
    """Read the wind at 10 m from a GRIB 1, GRIB 2 or CF NetCDF file, also bzip2 or gzip compressed ones.

    Gusts, waves, the current and the members of an ensemble come with it where the file has them.

    Parameters
    ----------
    around
        Ends of a passage, latitude and longitude [degrees]: they must be covered, and only what a passage
        between them may meet is kept. Masked values are filled from the sea beside them, and judged there.

    Raises
    ------
    InputError
        With one sentence naming the file, when it is not there, is no weather file, or its wind cannot
        be used.
    NoPassageError
        ``outside-forecast`` when an end of the passage is not covered.
    """
    return _make(Path(path), lambda raw: to_wind(raw, around=around))


def read_current_file(path: Path | str, *, around: Sequence[Place] = ()) -> Current:
    """Read the current at the surface of the sea from a GRIB or CF NetCDF file, with or without wind in it.

    Over land and beyond the edge of its grid there is none.

    Parameters
    ----------
    around
        Ends of a passage, latitude and longitude [degrees]; only what lies around them is kept.

    Raises
    ------
    InputError
        With one sentence naming the file, when it is not there, is no such file, or has no current.
    """
    return _make(Path(path), lambda raw: to_current(raw, around=around))


def _make(path: Path, make: Callable[[RawFile], _Made]) -> _Made:
    """Make something of a file; whatever is wrong becomes one sentence that names it."""
    try:
        return make(_read(path))
    except WeatherError as error:
        sentence = str(error).rstrip(".")
        raise InputError(f"The weather file {path.name} cannot be used: {sentence}.") from None
    except OSError as error:
        raise InputError(f"The weather file {path} cannot be read: {error.strerror or error}.") from None
    except (ArithmeticError, ValueError, IndexError, TypeError) as error:
        # a file damaged where its reader did not notice: axes that are none, times before the calendar
        raise InputError(f"The weather file {path.name} is damaged ({error}); download it again.") from None
    except MemoryError:
        raise InputError(f"The weather file {path.name} is too large for this computer's memory.") from None


def _read(path: Path) -> RawFile:
    from seacruise.weather.grib import read_grib
    from seacruise.weather.netcdf import read_netcdf

    if path.stat().st_size > MAX_BYTES:
        raise WeatherError(f"it is larger than {MAX_BYTES // 10**6} MB; cut it to the area of the passage")
    with path.open("rb") as file:
        magic = file.read(4)
    source = f"File {path.name}"
    if magic in _NETCDF_MAGIC:
        return read_netcdf(path, source=source)
    data = path.read_bytes()
    if magic[:3] == b"BZh" or magic[:2] == b"\x1f\x8b":
        data = _expand(data)
        if data[:4] in _NETCDF_MAGIC:
            return read_netcdf(data, source=source)
    if not data:
        raise WeatherError("it is empty")
    # a Saildocs mail or a bulletin header may stand before the first message
    if b"GRIB" not in data[:65536]:
        raise WeatherError("it is neither GRIB nor NetCDF")
    return read_grib(data, source=source)


def _expand(data: bytes) -> bytes:
    packed = io.BytesIO(data)
    try:
        with bz2.open(packed) if data[:1] == b"B" else gzip.open(packed) as stream:
            content = stream.read(MAX_BYTES + 1)
    except (OSError, EOFError, zlib.error):
        raise WeatherError("it is compressed, and damaged or cut off") from None
    if len(content) > MAX_BYTES:
        raise WeatherError(f"it is larger than {MAX_BYTES // 10**6} MB when expanded")
    return content
