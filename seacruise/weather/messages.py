"""From the messages of a GRIB file to fields: runs, members and grids put in order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

from seacruise.weather.grids import Array, RawField, ascending, onto

Role = Literal["u", "v", "gust", "wave", "cu", "cv"]

WIND: Final[tuple[Role, ...]] = ("u", "v")
CURRENT: Final[tuple[Role, ...]] = ("cu", "cv")
GUST: Final[tuple[Role, ...]] = ("gust",)
WAVE: Final[tuple[Role, ...]] = ("wave",)

_LOSS: Final = 0.05
"""A coarser grid may lack this much more of the finest one's area to extend it."""


@dataclass(frozen=True, slots=True)
class Message:
    """One field at one time.

    Attributes
    ----------
    grid
        What tells the grid from others.
    run, valid
        Seconds since 1970-01-01T00:00Z.
    member
        Number in an ensemble; ``None`` for a single forecast.
    level
        Height or depth, as the message counts it.
    """

    role: Role
    grid: tuple[Any, ...]
    run: float
    valid: float
    member: int | None
    level: int
    lat: Array
    lon: Array
    grid_relative: bool
    values: NDArray[np.float32]


def join(messages: Sequence[Message], roles: Sequence[Role], notes: list[str]) -> RawField | None:
    """Put the messages of a layer together: the members of an ensemble, or the one forecast there is.

    Parameters
    ----------
    roles
        Components that make up the layer.
    notes
        Receives sentences about what was left out or combined.

    Returns
    -------
    RawField or None
        ``None`` without a time that has all components.
    """
    own = [message for message in messages if message.role in roles]
    if not own:
        return None
    top = min(message.level for message in own)
    own = [message for message in own if message.level == top]
    runs = {message.run for message in own}
    if len(runs) > 1:
        notes.append(f"Of {len(runs)} model runs, the latest is used for each hour.")
    numbers = sorted({message.member for message in own if message.member is not None})
    if len(numbers) > 1:
        if any(message.member is None for message in own):
            notes.append("Of the forecasts in the file, the ensemble is used.")
        return _ensemble([[one for one in own if one.member == number] for number in numbers], roles, notes)
    return _combined(own, roles, notes)


def _ensemble(members: Sequence[list[Message]], roles: Sequence[Role], notes: list[str]) -> RawField | None:
    """Stack members that share a grid, at the times that all of them have."""
    found = [one for messages in members if (one := _combined(messages, roles, notes)) is not None]
    if len(found) < 2:
        return found[0] if found else None
    first = found[0]
    alike = [one for one in found if one.lat.shape == first.lat.shape and one.lon.shape == first.lon.shape]
    times = first.time
    for one in alike[1:]:
        times = np.intersect1d(times, one.time)
    if len(alike) < len(members) or times.size < max(one.time.size for one in alike):
        notes.append(
            f"{len(alike)} of {len(members)} members are used, at the {times.size} times they have in common."
        )
    if not times.size:
        return first
    parts = (np.stack([one.parts[k][np.isin(one.time, times)] for one in alike]) for k in range(len(roles)))
    return replace(first, time=times, parts=tuple(parts))


def _combined(messages: Sequence[Message], roles: Sequence[Role], notes: list[str]) -> RawField | None:
    """Keep the finest grid and extend it in time by the coarser ones that cover it."""
    grids: dict[tuple[Any, ...], list[Message]] = {}
    for message in messages:
        grids.setdefault(message.grid, []).append(message)
    parts = [part for group in grids.values() if (part := _stacked(group, roles)) is not None]
    if len(parts) < 2:
        return parts[0] if parts else None
    if any(part.lat.ndim == 2 for part in parts):
        notes.append(f"The file mixes {len(parts)} grids; the one with the most hours is used.")
        return max(parts, key=lambda part: part.time.size)
    parts = sorted((ascending(part) for part in parts), key=lambda part: (part.step, -part.time.size))
    base = parts[0]
    for other in parts[1:]:
        new = ~np.isin(other.time, base.time)
        later = replace(other, time=other.time[new], parts=tuple(part[new] for part in other.parts))
        fitted = onto(later, base.lat, base.lon)
        if not new.any() or _holes(fitted) > _holes(other) + _LOSS:
            notes.append(f"A second grid of {other.step:.2f} degrees in the file is not used.")
            continue
        notes.append(f"{int(new.sum())} of the hours are from a coarser grid of {other.step:.2f} degrees.")
        base = _merged(base, fitted)
    return base


def _stacked(group: Sequence[Message], roles: Sequence[Role]) -> RawField | None:
    """Put the messages of one grid in order of time; the later of two runs that have an hour counts."""
    found: dict[tuple[float, float], dict[Role, Message]] = {}
    for message in group:
        found.setdefault((message.valid, message.run), {})[message.role] = message
    # in order of the run: components of two runs are no vector, and a later run counts for its hours
    whole = {valid: one for (valid, _), one in sorted(found.items()) if len(one) == len(roles)}
    if not whole:
        return None
    first = next(iter(whole.values()))[roles[0]]
    return RawField(
        time=np.array(list(whole)),
        lat=first.lat,
        lon=first.lon,
        parts=tuple(np.stack([one[role].values for one in whole.values()]) for role in roles),
        grid_relative=first.grid_relative and len(roles) == 2,
    )


def _merged(base: RawField, other: RawField) -> RawField:
    time = np.concatenate([base.time, other.time])
    order = np.argsort(time)
    parts = (np.concatenate(pair)[order] for pair in zip(base.parts, other.parts, strict=True))
    return replace(base, time=time[order], parts=tuple(parts))


def _holes(field: RawField) -> float:
    return float(np.isnan(field.parts[0]).mean())
