"""Where a forecast is put together of two models, for the wind may jump there.

Services fill the far end of a forecast with another model than the near end, without a word: at such a
splice a recorded answer of Storm Glass turns by 42 degrees within an hour.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from datetime import UTC, datetime
from itertools import pairwise
from typing import Final

import msgspec
import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

LASTING_H: Final = 3.0
"""A model that stands in for a shorter time fills a hole and makes no splice [h]."""

JUMP_MS: Final = 1.5
"""A smaller change from one hour to the next is no jump [m/s]."""

JUMP_TIMES: Final = 3.0
"""How many times the usual change within half a day a jump is."""

_HALF_DAY_S: Final = 12 * 3600.0


class Splice(msgspec.Struct, frozen=True, array_like=True):
    """A change from one model to another.

    Attributes
    ----------
    time
        First hour of the later one [s since 1970].
    before, after
        Names of the models; ``after`` is empty where only the end of the earlier one is known.
    jump
        Change of the wind's vector in the hour before it, where that is far more than usual [m/s]; else 0.
    """

    time: float
    before: str
    after: str
    jump: float = 0.0


def find_splices(
    time: Array, wind: tuple[Array, Array], behind: Sequence[frozenset[str]], told: Sequence[frozenset[str]]
) -> tuple[Splice, ...]:
    """Find the splices of an answer.

    Parameters
    ----------
    time
        ``(t,)`` seconds since 1970, increasing.
    wind
        ``u`` and ``v``, ``(t,)`` each [m/s].
    behind
        For each time the models whose wind it has; more than one where they agree, none where not known.
    told
        For each time all models that the answer has for it. Where one ends for good while the wind jumps,
        that is a splice as well.
    """
    found = [
        Splice(float(time[index]), before, after, _jump(time, wind, index))
        for index, before, after in _changes(time, behind)
    ]
    known = {one.time for one in found}
    later: frozenset[str] = frozenset()
    for index in range(len(told) - 1, 0, -1):
        later |= told[index]
        ended = told[index - 1] - later
        if ended and float(time[index]) not in known and (jump := _jump(time, wind, index)) > 0.0:
            found.append(Splice(float(time[index]), "+".join(sorted(ended)), "", jump))
    return tuple(sorted(found, key=lambda one: one.time))


def _changes(time: Array, behind: Sequence[frozenset[str]]) -> list[tuple[int, str, str]]:
    """Index, model before and model after of each lasting change."""
    stretches: list[tuple[int, frozenset[str]]] = []
    for index, models in enumerate(behind):
        if not models:
            continue
        if stretches and models & stretches[-1][1]:
            stretches[-1] = stretches[-1][0], models & stretches[-1][1]
        else:
            stretches.append((index, models))
    ends = [*(time[index] for index, _ in stretches[1:]), np.inf][: len(stretches)]
    lasting: list[tuple[int, str]] = []
    for (index, models), end in zip(stretches, ends, strict=True):
        name = min(models)
        if end - time[index] >= LASTING_H * 3600.0 and not (lasting and lasting[-1][1] in models):
            lasting.append((index, name))
    return [(index, before, after) for (_, before), (index, after) in pairwise(lasting)]


def _jump(time: Array, wind: tuple[Array, Array], index: int) -> float:
    """Change of the wind from the time before ``index`` to it, if that is a jump; else 0 [m/s]."""
    if index == 0:
        return 0.0
    near = np.abs(time - time[index]) <= _HALF_DAY_S
    u, v = wind
    change = np.hypot(np.diff(u[near]), np.diff(v[near]))
    here = float(np.hypot(u[index] - u[index - 1], v[index] - v[index - 1]))
    return here if here > max(JUMP_MS, JUMP_TIMES * float(np.median(change))) else 0.0


def describe_splices(service: str, splices: Iterable[Splice]) -> list[str]:
    """Make sentences of the splices of all places: one for each change, with the greatest of its jumps."""
    jumps: dict[tuple[float, str, str], float] = {}
    for one in splices:
        key = one.time, one.before, one.after
        jumps[key] = max(jumps.get(key, 0.0), one.jump)
    sentences = []
    for (time, before, after), jump in sorted(jumps.items()):
        when = f"{datetime.fromtimestamp(time, UTC):%d %b %H:%M} UTC"
        by = f"the wind jumps there by up to {jump:.1f} m/s"
        if not after:
            sentences.append(f"{service} loses {before} at {when}; {by}.")
        else:
            follows = f"{service} follows {before} until {when}, then {after}"
            sentences.append(f"{follows}; {by}." if jump else f"{follows}.")
    return sentences
