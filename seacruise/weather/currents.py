"""The current of a file put to a wind, where it is of the same days."""

from __future__ import annotations

from dataclasses import replace

from seacruise.errors import InputError
from seacruise.weather.wind import Current, Wind


def with_current(wind: Wind, current: Current) -> Wind:
    """Put a current in the place of that which came with a wind, if any.

    Between its times the current is interpolated; before the first and after the last it is held, which is
    told when it ends before the wind does. One of a single time is a steady current.

    Raises
    ------
    InputError
        The two have no time in common: tides of another week would be worse than none.
    """
    covered, wanted = current.forecast, wind.forecast
    if current.time.size == 1:
        return replace(wind, current=current)
    if covered.valid_to < wanted.valid_from or covered.valid_from > wanted.valid_to:
        raise InputError(
            f"The current ({covered.source}) covers {covered.valid_from:%Y-%m-%d %H:%M} to "
            f"{covered.valid_to:%Y-%m-%d %H:%M} UTC, and the wind ({wanted.source}) "
            f"{wanted.valid_from:%Y-%m-%d %H:%M} to {wanted.valid_to:%Y-%m-%d %H:%M} UTC; choose a current "
            "of the same days, or none."
        )
    if covered.valid_to >= wanted.valid_to:
        return replace(wind, current=current)
    told = f"The current ({covered.source}) ends at {covered.valid_to:%Y-%m-%d %H:%M} UTC; the last is held."
    notice = f"{wanted.notice} {told}".strip()
    return replace(wind, current=current, forecast=replace(wanted, notice=notice))
