"""Where a yacht can be: land, water, the way from a port to the open sea."""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from seacruise.sea.water import Sea, Snap

__all__ = ["Sea", "Snap"]


def __getattr__(name: str) -> Any:
    """Load them when they are asked for: the chart needs the coast alone."""
    if name in __all__:
        from seacruise.sea import water

        return getattr(water, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
