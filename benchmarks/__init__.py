"""Measurements of SeaCruise: ``python -m benchmarks`` prints one JSON object; see docs/benchmarks.md."""
