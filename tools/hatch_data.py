"""Puts the data into the wheel; an editable install reads it where it lies in the checkout."""

from __future__ import annotations

from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class DataHook(BuildHookInterface[Any]):
    """Maps ``polars/``, ``assets/``, ``ports.csv`` and ``NOTICE`` to ``seacruise/_data`` in the wheel."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Add the data to a standard wheel, see `seacruise.resources`."""
        if version == "standard":
            for name in ("polars", "assets", "ports.csv", "NOTICE"):
                build_data["force_include"][name] = f"seacruise/_data/{name}"
