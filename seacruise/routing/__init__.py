"""Which way is fastest: lattice, search, refinement, and the passage sailed again."""
