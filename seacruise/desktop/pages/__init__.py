"""Pages beside the chart: when to go, and where to go."""
