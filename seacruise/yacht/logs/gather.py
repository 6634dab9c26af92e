"""Rows of a log from values that arrive one by one, each instrument at its own pace."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from seacruise.yacht.logs.log import COLUMNS, Log

BLOCK: Final = 4096
"""Rows that are handed on together: enough for NumPy, little for memory."""

_LATE_S: Final = 60.0
"""A time that is older than the last by less than this [s] is a late sentence, else a clock set back."""


class Gatherer:
    """Collects values into a row a moment; the last value of a moment counts.

    A log's clock is its own: values belong to the latest time that was read before them. So a receiver
    that repeats its last fix for some seconds makes one row, not several of one time.
    """

    def __init__(self) -> None:
        self._time = math.nan
        self._values: dict[str, float] = {}
        self._rows: list[list[float]] = []

    @property
    def time(self) -> float:
        """Moment that values are collected for [s since 1970]; NaN before the first."""
        return self._time

    def at(self, time: float) -> None:
        """Go on to a moment [s since 1970]."""
        if time <= self._time and self._time - time < _LATE_S:
            return
        self._end_row()
        self._time = time

    def knows(self, column: str) -> bool:
        """Tell whether this moment has a value already."""
        return column in self._values

    def put(self, column: str, value: float) -> None:
        """Note a value; NaN is none."""
        if not math.isnan(value):
            self._values[column] = value

    def full(self) -> Log | None:
        """Give the rows collected so far once they fill a block."""
        return self._block() if len(self._rows) >= BLOCK else None

    def rest(self) -> Log | None:
        """Give what is left at the end of the log."""
        self._end_row()
        return self._block() if self._rows else None

    def _end_row(self) -> None:
        if self._values and not math.isnan(self._time):
            get = self._values.get
            self._rows.append([self._time, *(get(name, math.nan) for name in COLUMNS[1:])])
        self._values = {}

    def _block(self) -> Log:
        columns = np.array(self._rows, dtype=np.float64).T
        self._rows = []
        return Log(*columns)
