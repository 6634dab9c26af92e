"""How fast she goes: polars, their files, and what she makes good by tacking and gybing."""
