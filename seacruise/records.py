"""Our own dataclasses as bytes, and back to the last digit: for what outlives the program.

Only the classes named here are ever made of bytes, so that a file from elsewhere can do nothing else.
"""

from __future__ import annotations

import zlib
from dataclasses import fields, is_dataclass
from datetime import datetime
from pathlib import Path
from typing import Any, Final

import msgspec
import numpy as np

from seacruise.model import Checks, Options, Passage, Place, SearchReport, Track, Waypoint
from seacruise.ports import Port
from seacruise.sea.zones import Zone
from seacruise.weather.wind import Current, Forecast, Wind
from seacruise.yacht.polar import Polar

_CLASSES: Final = {
    one.__name__: one
    for one in (
        *(Checks, Options, Passage, Place, SearchReport, Track, Waypoint),
        *(Port, Zone, Current, Forecast, Wind, Polar),
    )
}
_KIND: Final = "~"
_DTYPES: Final = frozenset({"<f8", "<f4", "<i8", "|b1"})


def pack(value: Any) -> bytes:
    """Write dataclasses, arrays, times, paths and what JSON knows; tuples and lists are the same."""
    return zlib.compress(msgspec.msgpack.encode(_plain(value)), level=6)


def unpack(data: bytes) -> Any:
    """Read what `pack` wrote.

    Raises
    ------
    ValueError
        The bytes are damaged, or of a class or a field that this version does not know.
    """
    try:
        return _whole(msgspec.msgpack.decode(zlib.decompress(data)))
    except (zlib.error, msgspec.MsgspecError, TypeError, KeyError, RecursionError) as error:
        raise ValueError(f"not a record of ours ({type(error).__name__})") from None


def _plain(value: Any) -> Any:
    if is_dataclass(value) and not isinstance(value, type):
        kept = {one.name: _plain(getattr(value, one.name)) for one in fields(value) if one.init}
        return {_KIND: type(value).__name__, **kept}
    if isinstance(value, np.ndarray):
        little = np.ascontiguousarray(value).astype(value.dtype.newbyteorder("<"))
        return {
            _KIND: "array", "dtype": little.dtype.str, "shape": list(value.shape), "data": little.tobytes()
        }  # fmt: skip
    if isinstance(value, datetime):
        return {_KIND: "time", "iso": value.isoformat()}
    if isinstance(value, Path):
        return {_KIND: "path", "path": str(value)}
    if isinstance(value, dict):
        return {str(key): _plain(one) for key, one in value.items()}
    if isinstance(value, tuple | list):
        return [_plain(one) for one in value]
    return value.item() if isinstance(value, np.generic) else value


def _whole(value: Any) -> Any:
    if isinstance(value, list):
        return tuple(_whole(one) for one in value)
    if not isinstance(value, dict):
        return value
    kind = value.pop(_KIND, None)
    if kind is None:
        return {key: _whole(one) for key, one in value.items()}
    if kind == "array":
        return _array(**value)
    if kind == "time":
        return datetime.fromisoformat(value["iso"])
    if kind == "path":
        return Path(value["path"])
    return _CLASSES[kind](**{key: _whole(one) for key, one in value.items()})


def _array(dtype: str, shape: list[int], data: bytes) -> Any:
    if dtype not in _DTYPES:
        raise ValueError(f"no array of ours has the type {dtype!r}")
    return np.frombuffer(data, dtype=dtype).reshape(shape).astype(np.dtype(dtype).newbyteorder("="))
