"""Axes of a small plot: even ticks, and from values to pixels; without Qt."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

HOURS_PER_DAY: Final = 24.0

_STEPS_H: Final = (0.25, 0.5, 1.0, 2.0, 3.0, 6.0, 12.0, 24.0, 48.0, 96.0, 168.0, 336.0, 720.0)


@dataclass(frozen=True, slots=True)
class Scale:
    """Maps values from ``low`` to ``high`` to pixels from ``begin`` to ``end``, which may run backwards."""

    low: float
    high: float
    begin: float
    end: float

    def to_px(self, value: float) -> float:
        """Pixel of a value."""
        return self.begin + (value - self.low) / (self.high - self.low) * (self.end - self.begin)


def step_h(span_h: float, most: int) -> float:
    """Find the smallest even step [h] that divides a span [h] into no more than ``most`` parts."""
    return next((step for step in _STEPS_H if span_h / step <= most), _STEPS_H[-1])


def ticks_h(low: float, high: float, most: int) -> list[float]:
    """Even hours from ``low`` to ``high``, at the most ``most + 1``; full days where a step is a day.

    Hours since 1970 begin at midnight, so ticks of moments are at 00:00, 06:00, 12:00.
    """
    step = step_h(max(high - low, 1e-9), most)
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [k * step for k in range(first, last + 1)]


def with_room(low: float, high: float, *, least: float) -> tuple[float, float]:
    """Widen a span by a tenth to both sides, to ``least`` at the least, so that no dot is on the frame."""
    middle, half = (low + high) / 2, max((high - low) * 0.6, least / 2)
    return middle - half, middle + half
