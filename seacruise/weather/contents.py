"""What a wind brings besides: named alike on the command line and in the window."""

from __future__ import annotations

from seacruise.weather.wind import Wind


def carried(wind: Wind) -> list[str]:
    """Name what a forecast has besides the wind: gusts, waves, current, spread, and how many members."""
    parts = {"gusts": wind.gust, "waves": wind.wave, "current": wind.current, "spread": wind.spread}
    members = [f"{len(wind.members)} members"] if wind.members else []
    return [name for name, part in parts.items() if part is not None] + members
