"""Files that are dropped on the window: forecasts, and polars to join the fleet."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Final

from PySide6.QtCore import QMimeData

_WIND_FILES: Final = (".grib", ".grib1", ".grib2", ".grb", ".grb1", ".grb2", ".nc", ".nc4")


def dropped_files(mime: QMimeData) -> tuple[list[Path], list[Path]]:
    """Tell weather files, by their names, from the others."""
    paths = [Path(url.toLocalFile()) for url in mime.urls() if url.isLocalFile()]
    winds = [path for path in paths if path.suffix.lower() in _WIND_FILES]
    return winds, [path for path in paths if path not in winds]


def use_files(
    data: QMimeData, plan_with: Callable[[tuple[str, ...]], None], add_polar: Callable[[Path], None]
) -> None:
    """Plan with the forecasts among dropped files; let the others join the fleet, as polars."""
    winds, others = dropped_files(data)
    if winds:
        plan_with(tuple(str(path) for path in winds))
    for path in others:
        add_polar(path)
