"""The wind after the end of the forecast.

R1 holds the last wind for ever, which makes of the last gale an endless one. A forecast that fades to the
usual wind is worth less and less the longer the passage lasts beyond it, and says so.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import datetime
from typing import Any, Final, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from seacruise.weather.wind import Wind

Beyond = Literal["hold", "fade", "refuse"]
"""What is done about the hours after the end of a forecast; refusing is up to who plans the passage."""

BEYOND: Final[tuple[Beyond, ...]] = get_args(Beyond)

FADE_H: Final = 24.0
"""How long it takes until nothing is left of the last wind [h]: lows cross the Baltic in a day."""

_Grid = NDArray[np.float32]


def extend(wind: Wind, mode: Beyond, until: datetime | None = None) -> Wind:
    """Extend a wind beyond its horizon.

    With ``"hold"`` (and ``"refuse"``) nothing changes: `Wind.at` holds the last wind, as R1 does. With
    ``"fade"`` the vectors go linearly, over `FADE_H` hours, from the last ones

    - to the mean of the members' last vectors, when the wind has members; the spread is held;
    - else to the mean of the vectors at that place over the time of the forecast: what the wind there has
      been like, all that is known then. The spread, if there is one, goes to how far the vectors have
      scattered around that mean; gusts and waves go to their own means.

    After that they are held. A forecast of a single time cannot fade, and is held.

    Parameters
    ----------
    until
        Timezone-aware end of what is asked; up to the horizon nothing changes. By default there is none.

    Returns
    -------
    Wind
        With one time more. ``forecast.valid_to`` stays the horizon of the forecast: hours are still counted
        as beyond it from there. A wind that was extended before is returned as it is, so that members can
        be extended together and then sailed one by one.
    """
    horizon = wind.forecast.valid_to.timestamp()
    is_enough = wind.time[-1] >= horizon + FADE_H * 3600.0 or (
        until is not None and until.timestamp() <= horizon
    )
    if mode != "fade" or is_enough or (wind.time.size == 1 and not wind.members):
        return wind
    last = _usual(wind)
    if wind.members:
        last = {
            name: np.mean([getattr(one, name)[-1] for one in wind.members], axis=0) for name in ("u", "v")
        }
    members = tuple(_appended(one, last) for one in wind.members)
    return replace(_appended(wind, last), members=members)


def extend_each(winds: Sequence[tuple[Wind, Beyond]]) -> list[Wind]:
    """Extend many winds, each distinct one once: an ensemble is megabytes, and many requests share it."""
    extended: dict[tuple[int, Beyond], Wind] = {}
    for wind, mode in winds:
        if (id(wind), mode) not in extended:
            extended[id(wind), mode] = extend(wind, mode)
    return [extended[id(wind), mode] for wind, mode in winds]


def _appended(wind: Wind, last: Mapping[str, _Grid]) -> Wind:
    """Put the faded wind one time after the last; what is not in it is held."""

    def more(name: str) -> Any:
        values: _Grid | None = getattr(wind, name)
        return None if values is None else np.concatenate([values, last.get(name, values[-1])[None]])

    return replace(
        wind,
        time=np.append(wind.time, wind.time[-1] + FADE_H * 3600.0),
        u=more("u"),
        v=more("v"),
        gust=more("gust"),
        wave=more("wave"),
        spread=more("spread"),
        members=(),
    )


def _usual(wind: Wind) -> dict[str, _Grid]:
    """Tell what a wind without members fades to: the means over its own time, place by place."""
    if wind.time.size == 1:
        return {}
    # each hour counts alike, whether the steps are of one hour or of six
    weights = np.gradient(wind.time)
    weights[[0, -1]] /= 2.0

    def mean(values: _Grid) -> _Grid:
        return np.average(values, axis=0, weights=weights).astype(np.float32)

    usual = {
        name: mean(values)
        for name in ("u", "v", "gust", "wave")
        if (values := getattr(wind, name)) is not None
    }
    if wind.spread is not None:
        usual["spread"] = np.sqrt(mean(np.square(wind.u - usual["u"]) + np.square(wind.v - usual["v"])))
    return usual
