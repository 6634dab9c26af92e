"""What a fitted polar remembers of its points, in a file beside it: the next log then adds to this one."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import msgspec
import numpy as np

from seacruise.atomic import write_atomically
from seacruise.errors import InputError
from seacruise.units import MS_PER_KNOT
from seacruise.yacht.logs.fit import Fitted
from seacruise.yacht.polar import Polar

SUFFIX: Final = ".cells"
_SCHEMA: Final = "seacruise.polar-cells/1"
_SAME_KN: Final = 0.02


class _File(msgspec.Struct):
    schema: str
    tws_kn: list[float]
    twa_deg: list[float]
    speed_kn: list[list[float | None]]
    error_kn: list[list[float | None]]
    count: list[list[float]]


def write_cells(fitted: Fitted, polar_path: Path) -> Path:
    """Write the figures of a fit beside its polar; returns where.

    Raises
    ------
    InputError
        The place cannot be written to.
    """
    path = Path(polar_path).with_suffix(SUFFIX)
    content = _File(
        _SCHEMA,
        _rounded(fitted.tws / MS_PER_KNOT),
        _rounded(fitted.twa),
        [_known(row) for row in fitted.speed / MS_PER_KNOT],
        [_known(row) for row in fitted.error / MS_PER_KNOT],
        [_rounded(row) for row in fitted.count],
    )
    write_atomically(path, msgspec.json.encode(content).decode() + "\n", what="polar's figures")
    return path


def read_cells(polar: Polar) -> Fitted | None:
    """Read what was written beside a polar.

    Returns
    -------
    Fitted or None
        ``None`` where there is nothing, or it belongs to a polar that was changed since.

    Raises
    ------
    InputError
        The file is broken.
    """
    if polar.path is None:
        return None
    path = polar.path.with_suffix(SUFFIX)
    try:
        content = msgspec.json.decode(path.read_bytes(), type=_File)
        fitted = _fitted(content)
    except FileNotFoundError:
        return None
    except (OSError, ValueError) as error:
        raise InputError(
            f"{path.name} beside the polar cannot be used ({error}); remove it to start anew from the polar."
        ) from error
    return fitted if _belongs(fitted, polar) else None


def _fitted(content: _File) -> Fitted:
    tws, twa = (np.array(axis, dtype=np.float64) for axis in (content.tws_kn, content.twa_deg))
    parts = [np.array(part, dtype=np.float64) for part in (content.speed_kn, content.error_kn, content.count)]
    if content.schema != _SCHEMA or any(part.shape != (twa.size, tws.size) for part in parts):
        raise ValueError("its tables do not fit its axes")
    speed, error, count = parts
    return Fitted(tws * MS_PER_KNOT, twa, speed * MS_PER_KNOT, error * MS_PER_KNOT, count)


def _belongs(fitted: Fitted, polar: Polar) -> bool:
    """Whether the polar still has these figures."""
    same = fitted.polar(polar.name)
    if same.speed_table.shape != polar.speed_table.shape:
        return False
    off = np.abs(np.nan_to_num(same.speed_table) - np.nan_to_num(polar.speed_table))
    return bool((off <= _SAME_KN * MS_PER_KNOT).all())


def _rounded(values: np.typing.NDArray[np.float64]) -> list[float]:
    return [round(float(value), 6) for value in values]


def _known(values: np.typing.NDArray[np.float64]) -> list[float | None]:
    return [None if np.isnan(value) else round(float(value), 6) for value in values]
