"""A polar from the boat's own log: read it, take the water and the wind apart, keep what was steady, fit."""
