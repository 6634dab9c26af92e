"""Passages as files: GPX, KML, GeoJSON, CSV, JSON, a chart, and the text of the command line."""
