"""The chart: a Mercator view with coast, lattice, wind, route and boat, drawn layer by layer."""
