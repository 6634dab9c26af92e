"""Where a yacht can be: land, water, the way from a port to the open sea."""

from seacruise.sea.water import Sea, Snap

__all__ = ["Sea", "Snap"]
